// The return of an element to its yield surface by other routes: bisection, the rate equations of plastic flow, and
// many small steps in the place of one.
#include <array>

#include "random_sections.h"

using namespace hinge;
using namespace hinge::beam;
using namespace hinge::test;
using namespace hinge::test::sections;

namespace {

/// What each of an element's forces is compared with.
Vec6 limits_of(const Vec4& s) { return (Vec6() << s[0], s[0], s[1], s[1], s[2], s[3]).finished(); }

/// How far apart two states of forces are, as a part of the strength.
double apart(const Trial& t, const Vec6& a, const Vec6& b) {
    return largest_entry((a - b).cwiseQuotient(limits_of(t.strength)));  // 0 where there is no limit
}

/// What yields the element by itself, times `size`.
Vec6 deformation(Dice& dice, const Trial& t, double size, bool all) {
    const Vec6 limits = limits_of(t.strength);
    const Mat6 K = t.k.matrix();
    Vec6 d = Vec6::Zero();
    for (int i = 0; i < 6; ++i)
        if (std::isfinite(limits[i]) && (all || dice.pick(4))) d[i] = size * dice(-1, 1) * limits[i] / K(i, i);
    return d;
}

/// An element of steel or of concrete, or one of eq 14.
Trial random_element(Dice& dice) {
    const int kind = dice.pick(6);
    if (kind == 5) return random_concrete(dice, 0);
    Trial t = random_trial(dice, 0);
    if (kind == 4) {
        if (!std::isfinite(t.strength[3])) t.strength[3] = t.strength[0];
        const Vec4 w = t.strength.cwiseProduct(t.strength).cwiseInverse();
        t.law = paper_law({w[0], w[1], w[2], w[3]});
    }
    return t;
}

/// The state of an element that is deformed step by step.
struct Deformed {
    Vec6 d = Vec6::Zero(), plastic = Vec6::Zero(), p = Vec6::Zero();
    std::vector<double> history;
    double work = 0;        ///< dissipated
    double least = 0;       ///< of the dissipation of a step
    bool converged = true;  ///< in the last step
    long lost = 0;          ///< steps whose flow was not found

    explicit Deformed(const SectionLaw& law) : history(2 * std::size_t(law.history_size()), 0.0) {}
    void move(const Trial& t, const Vec6& by, int steps) {
        const Vec6 from = d;
        for (int i = 1; i <= steps; ++i) {
            d = from + double(i) / steps * by;
            const ReturnMapResult flow =
                t.law->return_to_surface(t.k.times(d - plastic), t.k, ends, 2, {no_fixed_end, history.data()});
            for (int s : {0, 1})
                if (t.law->history_size() > 0)
                    t.law->commit(flow, s, 0, &history[std::size_t(s * t.law->history_size())]);
            plastic += flow.plastic, p = flow.p, work += flow.dissipation;
            least = smallest_of(least, flow.dissipation), lost += !flow.converged, converged = flow.converged;
        }
    }
};

/// Mean and largest of what random paths show, for sizes of a step.
struct Paths {
    static constexpr std::array<double, 5> sizes = {0.01, 0.1, 1, 10, 100};  ///< of what yields the element
    std::array<double, 5> mean{}, largest{}, work{};
    std::array<long, 5> count{};
    double outside = 0, least = 0;
    long lost = 0;
};

/// Random paths: one step from a state that has flowed or not, and the same path in `parts` steps.
Paths walk(unsigned seed, long count, int parts) {
    Dice dice(seed);
    Paths all;
    for (long n = 0; n < count; ++n) {
        const Trial t = random_element(dice);
        Deformed start(*t.law);
        start.move(t, deformation(dice, t, std::exp(dice(-1, 1.5)), dice.pick(2)), 1);
        const std::size_t size = std::size_t(dice.pick(5));
        const Vec6 by = deformation(dice, t, Paths::sizes[size], dice.pick(2));
        Deformed once = start, fine = start;
        once.work = fine.work = 0, once.lost = fine.lost = 0;
        once.move(t, by, 1), fine.move(t, by, parts);
        all.lost += once.lost + fine.lost;
        const double error = apart(t, once.p, fine.p);
        all.mean[size] += error, ++all.count[size];
        all.largest[size] = largest_of(all.largest[size], error);
        if (fine.work > 0) all.work[size] += std::abs(once.work / fine.work - 1);
        all.least = smallest_of(all.least, smallest_of(once.least, fine.least));
        for (double r : ends) {
            if (!once.converged) continue;
            const Vec6 trial = t.k.times(once.d - start.plastic);
            const double f = t.law->yield_function(once.p, r) - 1, beyond = apart(t, trial, once.p);
            all.outside = largest_of(all.outside, f / (1 + beyond));
        }
    }
    for (std::size_t i = 0; i < all.count.size(); ++i)
        all.mean[i] /= double(all.count[i]), all.work[i] /= double(all.count[i]);
    return all;
}

}  // namespace

// Flow in a plane, by N and one moment: its direction is an angle, and bisection finds it. 1e-9: what the search
// leaves.
TEST_CASE("the flow of one section by N and a moment is that of bisection") {
    Dice dice(3);
    double off = 0, flow_off = 0;
    int flows = 0;
    for (int n = 0; n < 4000; ++n) {
        const auto domain = domain_of(n % 3);  // with two axes of symmetry
        const int axis = dice.pick(2);
        const double A = domain->area(), E = 206e9;
        Vec4 strength;
        strength << fy * domain->moduli()[0], fy * domain->moduli()[1], fy * A, infinite;
        const auto law = exact_law(domain, strength);
        const Rigidity c{E * A * 0.012, E * A * 0.006, E * A, E * 0.001 * A, 0.2 * E * A, 0.2 * E * A};
        const Stiffness k = stiffness(c, dice(0.5, 6), 0);
        // at the middle: its stiffness against rotation and elongation, over the strength
        Vec6 trial = Vec6::Zero();
        const double size = std::exp(dice(-1, 3)), m = size * dice(-1, 1), nn = size * dice(-1, 1);
        trial[2 * axis] = -m * strength[axis], trial[2 * axis + 1] = m * strength[axis], trial[4] = nn * strength[2];
        const ReturnMapResult flow = law->return_to_surface(trial, k, middle, 1, no_fixed_end);
        if (!flow.flows()) continue;
        const double bend = (axis ? k.y11 + k.y22 - 2 * k.y12 : k.x11 + k.x22 - 2 * k.x12) / 4 /
                            (strength[axis] * strength[axis]),
                     pull = k.axial / (strength[2] * strength[2]);
        const auto at = [&](double angle, Eigen::Vector2d& way) {
            Vec3 e = Vec3::Zero(), point;
            e[axis] = std::cos(angle), e[2] = std::sin(angle);
            domain->support(e, point);
            way << bend * e[axis], pull * e[2];
            return Eigen::Vector2d(point[axis], point[2]);
        };
        const Eigen::Vector2d q(m, nn);
        // What is left of the trial forces turns from one side of the way of flow to the other within half a turn. The
        // flow moves to the trial along its way; where the search starts, the way has an angle of 90 degrees to it.
        const double toward = std::atan2(nn / pull, m / bend);
        double low = toward - pi / 2, high = toward + pi / 2;
        Eigen::Vector2d way;
        for (int i = 0; i < 100; ++i) {
            const double half = 0.5 * (low + high);
            const Eigen::Vector2d left = q - at(half, way);
            (way.x() * left.y() - way.y() * left.x() > 0 ? low : high) = half;
        }
        const Eigen::Vector2d found = at(0.5 * (low + high), way);
        const double much = (q - found).norm() / way.norm();
        Vec4 e = Vec4::Zero();
        e[axis] = much * std::cos(0.5 * (low + high)) / strength[axis],
        e[2] = much * std::sin(0.5 * (low + high)) / strength[2];
        ++flows;
        off = largest_of(off, std::abs(flow.p[2 * axis + 1] / strength[axis] - found.x()),
                         std::abs(flow.p[4] / strength[2] - found.y()));
        const Vec4 more = (flow.section[0] - e).cwiseProduct(strength.cwiseMin(1e9));
        flow_off = largest_of(flow_off, more.norm() / e.cwiseProduct(strength.cwiseMin(1e9)).norm());
    }
    CHECK(flows > 2000);
    CHECK_FIGURE("forces", off, 1e-9);
    CHECK_FIGURE("flow", flow_off, 1e-6);
}

namespace {

/// The rate equations of associated flow, p' = K (d' - sum of rate_i B_i n_i), in small steps: n is the gradient of the
/// yield function by differences, and the rates keep the forces of ends that flow on the surface.
Vec6 by_rates(const Trial& t, Vec6 p, const Vec6& by, int steps) {
    const Mat6 K = t.k.matrix();
    const Vec6 h = 1e-6 * limits_of(t.strength.cwiseMin(1e12));
    const auto f = [&](const Vec6& at, int s) { return t.law->yield_function(at, ends[s]) - 1; };
    const auto gradient = [&](const Vec6& at, int s) -> Vec6 {
        return differences([&](const Vec6& there) { return Eigen::Matrix<double, 1, 1>(f(there, s)); }, at, h)
            .transpose();
    };
    const Vec6 step = K * by / steps;
    for (int i = 0; i < steps; ++i) {
        p += step;
        for (int rounds = 0; rounds < 20; ++rounds) {  // to the surfaces that were left, along their normals
            Vec6 n[2];
            double beyond[2], rate[2] = {0, 0};
            for (int s : {0, 1}) beyond[s] = f(p, s), n[s] = gradient(p, s);
            if (beyond[0] < 1e-10 && beyond[1] < 1e-10) break;
            const double a = n[0].dot(K * n[0]), b = n[0].dot(K * n[1]), c = n[1].dot(K * n[1]), det = a * c - b * b;
            if (beyond[0] > 0 && beyond[1] > 0 && det > 1e-9 * a * c)
                rate[0] = (c * beyond[0] - b * beyond[1]) / det, rate[1] = (a * beyond[1] - b * beyond[0]) / det;
            if (!(rate[0] > 0 && rate[1] > 0)) {
                const int s = beyond[1] > beyond[0];
                rate[s] = beyond[s] / (s ? c : a), rate[1 - s] = 0;
            }
            for (int s : {0, 1}) p -= rate[s] * (K * n[s]);
        }
    }
    return p;
}

}  // namespace

// Both are of the first order in the step, so that two steps' lengths give the limit. Where a corner of the surface is
// passed, the rate equations come to it slowly: hence a bound on the middle one, and a wide one on all.
TEST_CASE("many steps come to the solution of the rate equations of plastic flow") {
    Dice dice(9);
    std::vector<double> off;
    double most = 0;
    for (int n = 0; n < 25; ++n) {
        const Trial t = random_trial(dice, 0);
        const Vec6 by = deformation(dice, t, 2, true);
        Vec6 limit[2] = {Vec6::Zero(), Vec6::Zero()}, fine[2];
        for (int i : {0, 1}) {
            const int steps = 150 << i;
            Deformed one(*t.law);
            one.move(t, by, steps);
            fine[0] = one.p, fine[1] = by_rates(t, Vec6::Zero(), by, steps);
            for (int j : {0, 1}) limit[j] += (i ? 2 : -1) * fine[j];
        }
        off.push_back(apart(t, limit[0], limit[1]));
        most = largest_of(most, apart(t, fine[0], fine[1]));
    }
    std::sort(off.begin(), off.end());
    CHECK_FIGURE("the middle one of the limits", off[off.size() / 2], 1e-3);
    CHECK_FIGURE("largest difference at 300 steps", most, 0.1);
}

namespace {

/// `count` random paths. One step that is small has an error of the size of the step; forces of a large one are on the
/// surface, as those of many steps are, so that they are 2 strengths apart at most (of concrete a little more: beside a
/// compression it carries more moment than alone).
void check_paths(unsigned seed, long count) {
    const Paths all = walk(seed, count, 64);
    const double mean[] = {4e-4, 8e-3, 0.1, 0.15, 0.06}, largest[] = {0.04, 0.4, 2.2, 2.2, 2.2},
                 work[] = {0.007, 0.03, 0.12, 0.04, 0.008};
    for (std::size_t i = 0; i < all.sizes.size(); ++i) {
        const std::string of = "one step of " + std::to_string(all.sizes[i]) + " times the yield deformation: ";
        CHECK_FIGURE(of + "mean error of forces", all.mean[i], mean[i]);
        CHECK_FIGURE(of + "largest", all.largest[i], largest[i]);
        CHECK_FIGURE(of + "mean error of the dissipation", all.work[i], work[i]);
    }
    // Five of a million, and as many by chance where there are few: rounding decides which they are.
    CHECK_FIGURE("steps whose flow is not found", double(all.lost), 5 + 5e-6 * 65 * double(count));
    CHECK_FIGURE("negative dissipation, J", -all.least, 0);
    CHECK_FIGURE("beyond the surface, over the trial forces", all.outside, 1e-7);
}

}  // namespace

TEST_CASE("5e3 random paths: the error of one step of any size, and what must hold in each") { check_paths(1, 5000); }

// The target `paths`: some minutes.
TEST_CASE("1e6 random paths: the error of one step of any size, and what must hold in each", "[.paths]") {
    check_paths(2, 1000000);
}
