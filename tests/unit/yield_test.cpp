// Plastic hinges: the return to the surface of eq 14, and what moving the integration point leaves alone.
#include "section/yield.h"

#include "helpers.h"
#include "state/hinges.h"

using namespace hinge;
using namespace hinge::beam;
using namespace hinge::test;

namespace {

/// A steel-like element and forces up to several times its yield limits, bending both ways, pulled and twisted.
struct Trial {
    Stiffness k;
    YieldSurface w;
    Vec6 p;
};

Trial random_trial(Dice& dice, bool midpoint = false) {
    Trial t;
    const double b = dice(0.02, 0.5), E = 206e9, G = E / 2.6, stress = dice(200e6, 400e6), h = b * dice(0.5, 1),
                 GA = G * b * h * 5 / 6;
    const Rigidity c{E * b * h * h * h / 12, E * h * b * b * b / 12, E * b * h, G * 0.14 * b * h * h * h, GA, GA};
    t.k = stiffness(c, b * dice(3, 40), midpoint ? 0 : dice(-1, 1));
    const double limit[4] = {stress * b * h * h / 4, stress * h * b * b / 4, stress * b * h,
                             stress / std::sqrt(3.0) * b * h * h / 3};
    t.w = {1 / (limit[0] * limit[0]), 1 / (limit[1] * limit[1]), 1 / (limit[2] * limit[2]), 1 / (limit[3] * limit[3])};
    // from hardly yielding to far outside; some components left out at random, so that corners of the surface are
    // reached too
    const double size = std::exp(dice(-1, 3));
    for (int i = 0; i < 6; ++i) t.p[i] = dice.pick(4) ? size * dice(-1, 1) * limit[i < 4 ? i / 2 : i - 2] : 0;
    return t;
}

/// The surface's factor for each component of p.
Vec6 of_components(const YieldSurface& w) { return (Vec6() << w.x, w.x, w.y, w.y, w.n, w.z).finished(); }

/// Size in which rounding is measured: forces over their limits.
double size_of(const Vec6& p, const YieldSurface& w) { return std::sqrt(of_components(w).dot(p.cwiseProduct(p))); }

const double ends[2] = {-1, 1}, middle[1] = {0};

/// By how much the rules of associated flow are missed, with loads between the nodes or without.
struct Returns {
    double off_surface = 0, beyond = 0, off_normal = 0, off_work = 0, least_dissipation = 0;
    long one = 0, both = 0, none = 0;

    void look(const Trial& t, const ReturnMapResult& flow, const FixedEnd& fixed = no_fixed_end,
              const double* sections = ends, int count = 2) {
        const Vec6 s[2] = {fixed.at(sections[0]), fixed.at(sections[count - 1])};
        REQUIRE((flow.lambda[0] >= 0 && flow.lambda[1] >= 0));
        if (flow.lambda[0] == 0 && flow.lambda[1] == 0) {  // elastic: nothing happens
            ++none;
            REQUIRE((flow.p == t.p && flow.plastic.isZero() && flow.dissipation == 0));
            for (int i = 0; i < count; ++i) REQUIRE(yield_function(Vec6(t.p + s[i]), sections[i], t.w) <= 1);
            return;
        }
        ++(flow.lambda[0] > 0 && flow.lambda[1] > 0 ? both : one);
        Vec6 plastic = Vec6::Zero();
        double dissipation = 0, part = 0;
        for (int i = 0; i < count; ++i) {
            const Vec6 whole = flow.p + s[i], there = flow.lambda[i] * yield_gradient(whole, sections[i], t.w);
            const double f = yield_function(whole, sections[i], t.w);
            if (flow.lambda[i] > 0) off_surface = largest_of(off_surface, std::abs(f - 1));
            beyond = largest_of(beyond, f - 1);
            plastic += there, dissipation += whole.dot(there), part += s[i].dot(there);
        }
        // Nearest in the energy norm: the way back is k times the gradients, with multipliers that are not negative.
        // The surface is convex, so there is one such point.
        const double size = size_of(t.p, t.w) + size_of(s[0], t.w);
        off_normal = largest_of(off_normal, size_of(t.p - t.k.times(plastic) - flow.p, t.w) / size,
                                (plastic - flow.plastic).norm() / plastic.norm());
        off_work = largest_of(off_work, std::abs(flow.dissipation / dissipation - 1),
                              std::abs(work_of(fixed, flow, t.w, sections, count, fixed) - part) / dissipation);
        least_dissipation = smallest_of(least_dissipation, flow.dissipation);
    }
    /// 1e-11: rounding of 1e-16 after 20 times the strength, whose square is in f, and with a flexibility that is
    /// nearly singular.
    void check() const {
        CHECK_FIGURE("distance of a flowing end from the surface, |f - 1|", off_surface, 1e-11);
        CHECK_FIGURE("an end beyond the surface, f - 1", beyond, 1e-11);
        CHECK_FIGURE("way back against k times the gradients", off_normal, 1e-10);
        CHECK_FIGURE("dissipation and the fixed-end part's work on it", off_work, 1e-9);
        CHECK_FIGURE("negative dissipation, J", -least_dissipation, 0);
    }
};

}  // namespace

TEST_CASE("1e5 random returns, both ends: on the surface, nearest point, never negative dissipation (1e-11)") {
    Dice dice(31);
    Returns all;
    for (int trial = 0; trial < 100000; ++trial) {
        const Trial t = random_trial(dice);
        all.look(t, return_to_surface(t.p, t.k, t.w, ends, 2));
    }
    all.check();
    CHECK(all.one > 5000);
    CHECK(all.both > 10000);
    CHECK(all.none > 1000);
}

// 1e-8: rounding after 1e7 times the strength.
TEST_CASE("3e5 returns from far outside, of odd elements and loads: an answer, or the word that there is none") {
    Dice dice(7);
    double off_surface = 0;
    long answers = 0, none = 0, wrong = 0;
    for (int trial = 0; trial < 300000; ++trial) {
        Trial t = random_trial(dice);
        for (double* w : {&t.w.x, &t.w.y, &t.w.n, &t.w.z}) *w *= std::exp(dice(-18, 18));
        const Vec6 limit = of_components(t.w).cwiseSqrt().cwiseInverse();
        const double size = std::exp(dice(-1, 16)), loads = trial % 2 ? dice(0, 12) : 0;
        for (int i = 0; i < 6; ++i) t.p[i] = dice.pick(4) ? size * dice(-1, 1) * limit[i] : 0;
        FixedEnd fixed;
        for (int end : {0, 1})
            fixed.add(end, loads * dice(-1, 1) * limit[0], loads * dice(-1, 1) * limit[2],
                      0.2 * loads * dice(-1, 1) * limit[4], 0.2 * loads * dice(-1, 1) * limit[5]);
        const Vec6 s[2] = {fixed.at(-1), fixed.at(1)}, apart = s[0] - s[1];
        const ReturnMapResult flow = return_to_surface(t.p, t.k, t.w, ends, 2, fixed);
        // N and Mz are the same at both ends but for the loads between them: too far apart, no p serves both
        const bool possible = t.w.n * apart[4] * apart[4] + t.w.z * apart[5] * apart[5] < 4;
        double off = 0;
        for (int i = 0; i < 2; ++i) {
            const double f = yield_function(Vec6(flow.p + s[i]), ends[i], t.w) - 1;
            off = largest_of(off, flow.lambda[i] > 0 ? std::abs(f) : f);
        }
        if (flow.converged) ++answers, off_surface = largest_of(off_surface, off);
        else ++none;
        wrong += flow.converged != possible;
    }
    CHECK_FIGURE("distance from the surface of what is said to be an answer", off_surface, 1e-8);
    CHECK(answers > 200000);
    CHECK(none > 10000);
    CHECK(wrong == 0);
    Trial t = random_trial(dice);
    t.p << 1e9, 1e9, 0, std::nan(""), 0, 0;
    CHECK(!return_to_surface(t.p, t.k, t.w, ends, 2).converged);
}

TEST_CASE("returns of elements with loads between their nodes: the whole forces are on the surface, and the tangent") {
    Dice dice(38);
    Returns all;
    double off_tangent = 0;
    long compared = 0;
    for (int trial = 0; trial < 20000; ++trial) {
        const Trial t = random_trial(dice);
        FixedEnd fixed;
        const Vec6 limit = of_components(t.w).cwiseSqrt().cwiseInverse();
        for (int end : {0, 1})
            fixed.add(end, dice(-2, 2) * limit[0], dice(-2, 2) * limit[2], dice(-0.2, 0.2) * limit[4],
                      dice(-0.2, 0.2) * limit[5]);
        const auto returned = [&](const Vec6& p) { return return_to_surface(p, t.k, t.w, ends, 2, fixed); };
        const ReturnMapResult flow = returned(t.p);
        all.look(t, flow, fixed);
        const bool active[2] = {flow.lambda[0] > 0, flow.lambda[1] > 0};
        if (!active[0] && !active[1]) continue;
        // Near a corner, or hardly flowing, there is no derivative to compare with.
        const Mat6 tangent = plastic_tangent(flow.p, t.k, t.w, ends, flow.lambda, active, 2, fixed);
        bool same_ends = true;
        double worst = 0;
        for (int j = 0; j < 6; ++j) {
            const double unit = limit[j] / t.k.matrix()(j, j);
            const Vec6 way = t.k.times(1e-4 * unit * Vec6::Unit(j));
            const auto at = [&](double by) -> Vec6 {
                const ReturnMapResult there = returned(t.p + by * way);
                for (int i = 0; i < 2; ++i) same_ends = same_ends && (there.lambda[i] > 0) == active[i];
                return there.p;
            };
            const Vec6 slope = (8 * (at(1) - at(-1)) - (at(2) - at(-2))) / (12e-4 * unit);
            worst = largest_of(worst, unit * size_of(tangent.col(j) - slope, t.w));
        }
        if (same_ends) off_tangent = largest_of(off_tangent, worst), ++compared;
    }
    all.check();
    CHECK_FIGURE("tangent of the return against differences", off_tangent, 1e-4);
    CHECK(all.one > 1000);
    CHECK(all.both > 1000);
    CHECK(compared > 2000);
}

namespace {

/// Forces with f = 1 at end 1 and f = `at_2` <= 1 at end 2, all six components at work; `axial` and `twist`: the parts
/// of f that N and Mz make.
Vec6 forces_on_surface(Dice& dice, const YieldSurface& w, double axial, double twist, double at_2) {
    const auto sign = [&] { return dice(-1, 1) < 0 ? -1.0 : 1.0; };
    Vec6 p;
    for (int end = 0; end < 2; ++end) {
        const double bending = (end == 0 ? 1 : at_2) - axial - twist, share = dice(0.1, 0.9);
        p[end] = sign() * std::sqrt(share * bending / w.x);
        p[2 + end] = sign() * std::sqrt((1 - share) * bending / w.y);
    }
    p[4] = sign() * std::sqrt(axial / w.n);
    p[5] = sign() * std::sqrt(twist / w.z);
    return p;
}

}  // namespace

TEST_CASE("the return's tangent is its derivative, at one end and at both, near corners too (1e-6)") {
    // Made backwards: forces on the surface, and flow by given multipliers away from them. So the cases are where a
    // random trial hardly comes: the other end about to flow, or flowing by a thousandth of the first.
    Dice dice(35);
    double off_point = 0, off_tangent = 0, without_curvature = 0;
    int compared[2][2] = {};
    for (int trial = 0; trial < 4000; ++trial) {
        const Trial t = random_trial(dice);
        const bool both = trial % 2, near = trial / 2 % 2;
        const double axial = dice(0.02, 0.6), twist = dice(0.02, 0.3);
        const double at_2 = both ? 1 : near ? 0.999 : dice(axial + twist + 0.02, 0.99);
        const Vec6 p = forces_on_surface(dice, t.w, axial, twist, at_2);
        const Vec6 a[2] = {yield_gradient(p, -1, t.w), yield_gradient(p, 1, t.w)};
        // flow whose elastic way back is 0.01 to 3 times the forces' own size
        double lambda[2] = {0, 0};
        lambda[0] = dice(0.01, 3) / size_of(t.k.times(a[0]), t.w);
        if (both) lambda[1] = (near ? 1e-3 : dice(0.01, 3)) / size_of(t.k.times(a[1]), t.w);
        const Vec6 d = t.k.solve(p) + lambda[0] * a[0] + lambda[1] * a[1];
        const auto returned = [&](const Vec6& deformation) {
            return return_to_surface(t.k.times(deformation), t.k, t.w, ends, 2);
        };
        const ReturnMapResult flow = returned(d);
        off_point = largest_of(off_point, size_of(flow.p - p, t.w));
        const bool active[2] = {flow.lambda[0] > 0, flow.lambda[1] > 0};
        REQUIRE((active[0] && active[1] == both));
        const Mat6 tangent = plastic_tangent(flow.p, t.k, t.w, ends, flow.lambda, active, 2);
        const double none[2] = {0, 0};
        const Mat6 straight = plastic_tangent(flow.p, t.k, t.w, ends, none, active, 2);
        // unit of a deformation: what yields alone
        const Vec6 limit = of_components(t.w).cwiseSqrt().cwiseInverse();
        bool same_ends = true;  // over the differences: else there is no derivative to compare with
        double worst = 0;
        for (int j = 0; j < 6; ++j) {
            const double unit = limit[j] / t.k.matrix()(j, j), h = 1e-5 * unit;
            const auto at = [&](double by) -> Vec6 {
                const ReturnMapResult there = returned(d + by * Vec6::Unit(j));
                same_ends = same_ends && there.lambda[0] > 0 && (there.lambda[1] > 0) == both;
                return there.p;
            };
            const Vec6 slope = (8 * (at(h) - at(-h)) - (at(2 * h) - at(-2 * h))) / (12 * h);
            worst = largest_of(worst, unit * size_of(tangent.col(j) - slope, t.w));
            without_curvature = largest_of(without_curvature, unit * size_of(straight.col(j) - slope, t.w));
        }
        if (!same_ends) continue;
        off_tangent = largest_of(off_tangent, worst);
        ++compared[both][near];
    }
    CHECK_FIGURE("the point that flowed comes back, over the plastic resultants", off_point, 1e-9);
    CHECK_FIGURE("tangent of the return against differences", off_tangent, 1e-6);
    CHECK(without_curvature > 0.1);  // the surface's curvature counts
    for (int both : {0, 1})
        for (int near : {0, 1}) {
            INFO((both ? "both ends flow" : "one end flows") << (near ? ", near a corner" : ""));
            CHECK(compared[both][near] > 800);  // of 1000
        }
}

TEST_CASE("the conventional element yields at its middle alone (1e-12)") {
    Dice dice(33);
    Returns all;
    for (int trial = 0; trial < 10000; ++trial) {
        const Trial t = random_trial(dice, true);
        all.look(t, return_to_surface(t.p, t.k, t.w, middle, 1), no_fixed_end, middle, 1);
    }
    all.check();
}

TEST_CASE("eq 14: each resultant alone yields at its fully plastic value, at its own end") {
    const YieldSurface w{1 / 9.0, 1 / 16.0, 1 / 25.0, 1 / 36.0};
    const auto f = [&](int i, double value, double r) { return yield_function(Vec6(value * Vec6::Unit(i)), r, w); };
    CHECK(f(0, 3, -1) == Approx(1));
    CHECK(f(0, 3, 1) == 0);
    CHECK(f(1, -3, 1) == Approx(1));
    CHECK(f(2, 4, -1) == Approx(1));
    CHECK(f(3, 4, 1) == Approx(1));
    CHECK(f(4, -5, 0.3) == Approx(1));
    CHECK(f(5, 6, -0.7) == Approx(1));
    const Vec6 p = (Vec6() << 1, 2, 3, 4, 5, 6).finished();
    CHECK(p.dot(yield_gradient(p, 0.4, w)) == Approx(2 * yield_function(p, 0.4, w)));  // quadratic: p . df/dp = 2 f
}

TEST_CASE("moving the integration point changes no nodal force (1e-12)") {
    Dice dice(34);
    double worst = 0;
    for (bool large : {false, true}) {
        // points move with shift = "elastic_and_plastic" alone, which has no other p_delta
        Frame frame({.displacement = large ? Displacement::large : Displacement::small, .p_delta = PDelta::chord});
        frame.material = steel(245e6);
        const int a = frame.node(0, 0, 0), b = frame.node(0.6, 0.3, 0.2), c = frame.node(0.1, 0.9, -0.3);
        frame.member(a, b);
        frame.member(b, c);
        const auto structure = frame.build();
        for (int trial = 0; trial < 200; ++trial) {
            State state = initial_state(*structure);
            state.small_rotation.resize(state.displacement.size());
            for (std::size_t i = 0; i < state.displacement.size(); ++i) {
                state.displacement[i] = dice.vector(1e-4);
                state.small_rotation[i] = dice.vector(1e-3);
                state.rotation[i] = exponential(state.small_rotation[i]);
            }
            for (Vec6& d : state.plastic)
                for (double& v : d) v = dice(-1e-4, 1e-4);
            std::vector<PlasticIncrement> yielding;
            const auto nodal = [&](std::vector<Vec6>& force) {
                ThreadPool alone;
                ElementAssembly assembly(*structure, alone, false);
                assembly.update_active(state);
                std::vector<Vec6> at(state.displacement.size(), Vec6::Zero());
                assembly.run(state, state, at, force, yielding);
                return at;
            };
            // a state on which nothing yields, as it is when a step is over
            nodal(state.force);
            for (const PlasticIncrement& y : yielding) state.plastic[y.element] += y.flow.plastic;
            const std::vector<Vec6> before = nodal(state.force);
            const std::vector<Vec6> force_before = state.force;
            Vec6 size = Vec6::Constant(1);
            for (const Vec6& f : before) size = size.cwiseMax(f.cwiseAbs());
            for (std::size_t e = 0; e < structure->elements().size(); ++e) {
                const double s[] = {-1, 1, 0, dice(-1, 1)};
                const beam::Stiffness k = stiffness_now(*structure, state, int(e));
                move_point(*structure, state, int(e), s[trial % 4]);
                if (trial % 4 < 2)
                    CHECK(off(stiffness_now(*structure, state, int(e)).x11, k.x11) > 0.1);  // it did move
            }
            const std::vector<Vec6> after = nodal(state.force);
            for (std::size_t i = 0; i < after.size(); ++i)
                worst = largest_of(worst, largest_entry((after[i] - before[i]).cwiseQuotient(size)));
            for (std::size_t e = 0; e < force_before.size(); ++e)
                worst = largest_of(worst, size_of(state.force[e] - force_before[e], structure->elements()[e].yield));
        }
    }
    CHECK_FIGURE("jump of a nodal force when the point moves", worst, 1e-12);
}

namespace {

/// A cantilever along x of section S, one pair of elements, root element first, that a tip load in -z bends.
std::shared_ptr<const Structure> cantilever(Shift shift, History history = {}) {
    ModelOptions options = small_displacement();
    options.shift = shift;
    Frame frame(options);
    frame.material = steel(245e6);
    const int a = frame.foot(0, 0, 0), b = frame.node(1, 0, 0);
    frame.member(a, b);
    frame.load(b, {0, 0, -1000}, Vec3::Zero(), std::move(history));
    return frame.build();
}
const double Mp = 7656.25;

}  // namespace

TEST_CASE("a hinge takes the point to the far end (eq 6), its partner's to the middle; the limit load is Mp/L (1e-9)") {
    const auto structure = cantilever(Shift::elastic_and_plastic);
    Statics run(structure, initial_state(*structure), driven(1, 2, -0.04, 100));
    REQUIRE(run.advance());
    CHECK(run.state().point[0] == gauss_point);
    CHECK(run.state().point[1] == -gauss_point);
    complete(run);
    CHECK(run.state().hinge[0] == hinge_at_1);
    CHECK(run.state().point[0] == 1);  // s = -r, the hinge being at r = -1
    CHECK(run.state().point[1] == 0);
    CHECK_FIGURE("plastic moment at the root, point shifted", off(run.state().factor * 1000, Mp), 1e-9);
}

TEST_CASE(
    "with Shift::plastic the elastic points stay: the plastic rotation is the deflection's over the elastic one") {
    const auto run = statics(cantilever(Shift::plastic), driven(1, 2, -0.04, 100));
    CHECK(run->state().hinge[0] == hinge_at_1);
    CHECK(run->state().point[0] == gauss_point);
    CHECK(run->state().point[1] == -gauss_point);
    CHECK_FIGURE("plastic moment at the root, points that stay", off(run->state().factor * 1000, Mp), 1e-9);
    const double elastic = Mp * 3.112854e-6;  // m/N: tests/references.md 10
    CHECK_FIGURE("plastic rotation of the root", off(largest_entry(run->state().plastic[0].head<4>()), 0.04 - elastic),
                 1e-6);
}

TEST_CASE("unloading takes the points back, and the forces are continuous when they go and come (dynamics)") {
    // A pulse that bends the root plastically and lets it swing back.
    const auto structure = cantilever(Shift::elastic_and_plastic, [](double t) { return t < 5e-3 ? 9.0 : 0.0; });
    Dynamics run = dynamics(structure, {.dt = 2e-6, .duration = 0.012});
    int away = 0, back = 0;
    double worst = 0;
    State before = run.state();
    while (run.advance()) {
        const State& now = run.state();
        const bool was = before.point[0] != gauss_point, is = now.point[0] != gauss_point;
        away += !was && is;
        back += was && !is;
        CHECK((now.point[1] != -gauss_point) == (is || now.hinge[1] != 0));
        // p = k(s) (d - d_p) holds with the point where it is now
        for (int e = 0; e < 2; ++e) {
            const Vec6 d = element_deformation(*structure, e, now) - now.plastic[e];
            worst = largest_of(worst, size_of(stiffness_now(*structure, now, e).times(d) - now.force[e],
                                              structure->elements()[e].yield));
        }
        before = now;
    }
    REQUIRE(run.verdict() == Verdict::completed);
    CHECK(away >= 1);
    CHECK(back >= 1);
    CHECK(away - back <= 1);
    // The forces of a step are those at its last solve; the correction after it moves them by a part of a step's
    // change, and k(s) of a shifted point is some hundred times stiffer than k of the Gauss point (0.006 at this dt,
    // falling with its square).
    CHECK_FIGURE("k(s) (d - d_p) against p, over the plastic resultants", worst, 2e-2);
}

TEST_CASE("a run that starts from another's state knows which hinges flowed") {
    const auto structure = cantilever(Shift::elastic_and_plastic);
    const auto first = statics(structure, driven(1, 2, -0.04, 100));
    REQUIRE(first->state().hinge[0] == hinge_at_1);
    Statics second(structure, first->state(), driven(1, 2, 0.001, 1));  // 1 mm back: elastic
    REQUIRE(second.advance());
    CHECK(second.state().hinge[0] == 0);
    CHECK(second.state().point[0] == gauss_point);
    CHECK(second.state().point[1] == -gauss_point);
}
