// Limit loads and the way to them (tests/references.md 11-14): first-order values, so displacement = "small". Two
// asi-gauss elements a member.
//
// The references are for beams without shear deformation and, in frames, without axial deformation; both are made many
// thousand times stiffer here, which leaves some 1e-6 of them.
#include <optional>

#include "helpers.h"

using namespace hinge;
using namespace hinge::test;

namespace {

constexpr double Mp = 7656.25, N0 = 612.5e3, T0 = 5893.78;  // section S: 50 mm square, yield 245 MPa; N m, N, N m

/// Section S, stiff against what the references leave out. N0 counts in eq 14 only where `axial_counts`.
std::shared_ptr<Section> section_S(double shear, double axial = 1, bool axial_counts = true) {
    auto s = square(0.05);
    s->shear_area_x *= shear;
    s->shear_area_y *= shear;
    s->area *= axial;
    if (!axial_counts) s->given.N0 = infinite;
    return s;
}

struct Bench : Frame {
    int probe = 0, component = 0;  ///< where the load goes and how it is driven
    explicit Bench(std::shared_ptr<Section> s) : Frame(small_displacement()) {
        section = std::move(s);
        material = steel(245e6);
    }
};

/// 11: propped cantilever, L 1, load at mid-span. Unit load, so that factors are newtons.
Bench propped() {
    Bench b(section_S(1e4));
    const int left = b.foot(0, 0, 0), mid = b.node(0.5, 0, 0), right = b.foot(1, 0, 0, 0b001110);
    b.member(left, mid);
    b.member(mid, right);
    b.load(mid, {0, 0, -1});
    b.probe = mid, b.component = 2;
    return b;
}

/// 12: fixed at both ends, load at L/3.
Bench fixed_fixed() {
    Bench b(section_S(1e4));
    const int left = b.foot(0, 0, 0), third = b.node(1.0 / 3, 0, 0), right = b.foot(1, 0, 0);
    b.member(left, third);
    b.member(third, right);
    b.load(third, {0, 0, -1});
    b.probe = third, b.component = 2;
    return b;
}

/// 13: portal, h = L = 1 in the x-z plane, horizontal load H at the left corner and V at the middle of the beam.
Bench portal(double H, double V, bool pinned = false, bool axial_counts = false) {
    Bench b(section_S(1e4, 1e3, axial_counts));
    const std::uint8_t base = pinned ? 0b101111 : 63;
    const int foot1 = b.foot(0, 0, 0, base), foot2 = b.foot(1, 0, 0, base), top1 = b.node(0, 0, 1),
              mid = b.node(0.5, 0, 1), top2 = b.node(1, 0, 1);
    b.member(foot1, top1);
    b.member(foot2, top2);
    b.member(top1, mid);
    b.member(mid, top2);
    if (H != 0) b.load(top1, {H, 0, 0});
    if (V != 0) b.load(mid, {0, 0, -V});
    b.probe = top1, b.component = 0;
    return b;
}

/// The load factor where the probe has come to `value`.
double load_at(const Bench& bench, double value, int steps) {
    const auto run = statics(bench.build(), driven(bench.probe, bench.component, value, steps));
    INFO(run->reason());
    REQUIRE(run->verdict() == Verdict::completed);
    return run->state().factor;
}

/// The largest load factor that load control comes to on the way to `beyond`; it must end there as failed.
double limit_load(const Bench& bench, double beyond) {
    StaticSettings settings;
    settings.steps = 20;
    auto loaded = std::make_shared<Model>(*bench.model);
    for (const NodalLoad& l : bench.model->declared<NodalLoad>(loads_effect))
        add_load(*loaded, {l.node, (beyond - 1) * l.force, (beyond - 1) * l.moment, {}});
    const auto run = statics(std::make_shared<Structure>(loaded), settings);
    REQUIRE(run->verdict() == Verdict::failed);
    CHECK(run->reason().find("limit load") != std::string::npos);
    return run->state().factor * beyond;
}

/// The kinks of the load-displacement line: loads at which a hinge forms. Between kinks the line is straight, so each
/// is found by crossing the straight pieces before and after it.
std::vector<double> hinge_loads(const Bench& bench, double to, int steps) {
    const auto structure = bench.build();
    Statics run(structure, initial_state(*structure), driven(bench.probe, bench.component, to, steps));
    std::vector<double> u{0}, P{0};
    while (run.advance()) u.push_back(run.displacement(bench.probe)[bench.component]), P.push_back(run.state().factor);
    INFO(run.reason());
    REQUIRE(run.verdict() == Verdict::completed);
    std::vector<double> slope, kinks;
    for (std::size_t i = 1; i < u.size(); ++i) slope.push_back((P[i] - P[i - 1]) / (u[i] - u[i - 1]));
    for (std::size_t i = 1; i + 1 < slope.size();
         ++i) {  // step i holds a kink: straight before, straight after, not the same
        const bool bent = std::abs(slope[i] - slope[i - 1]) > 1e-2 * std::abs(slope[0]);
        if (!bent) continue;
        const double before = slope[i - 1], after = slope[i + 1];
        // P[i] + before (u - u[i]) = P[i+1] + after (u - u[i+1])
        const double where = (P[i + 1] - P[i] + before * u[i] - after * u[i + 1]) / (before - after);
        kinks.push_back(P[i] + before * (where - u[i]));
        ++i;
    }
    return kinks;
}

}  // namespace

TEST_CASE(
    "reference 11: propped cantilever, the two hinges' loads at their displacements, and the mechanism (0.1 %; exact "
    "to 1e-5)") {
    const Bench bench = propped();
    CHECK_FIGURE("propped cantilever, P at w = 3.46885 mm", off(load_at(bench, -3.46885e-3, 1), 40.8333e3), 1e-5);
    CHECK_FIGURE("propped cantilever, P at w = 4.45995 mm", off(load_at(bench, -4.45995e-3, 4), 45.9375e3), 1e-5);
    CHECK_FIGURE("propped cantilever, plateau at 3 w", off(load_at(bench, -15e-3, 10), 45.9375e3), 1e-7);
    CHECK_FIGURE("propped cantilever, load control's limit", off(limit_load(bench, 60e3), 45.9375e3), 1e-3);
    const auto kinks = hinge_loads(bench, -8e-3, 40);
    REQUIRE(kinks.size() == 2);
    CHECK_FIGURE("propped cantilever, first hinge", off(kinks[0], 40.8333e3), 1e-5);
    CHECK_FIGURE("propped cantilever, second hinge", off(kinks[1], 45.9375e3), 1e-5);
}

TEST_CASE("reference 12: fixed beam loaded at a third, three hinges at their displacements (0.1 %; exact to 1e-5)") {
    const Bench bench = fixed_fixed();
    CHECK_FIGURE("fixed beam, P at 1.76196 mm", off(load_at(bench, -1.76196e-3, 1), 51.6797e3), 1e-5);
    CHECK_FIGURE("fixed beam, P at 3.02050 mm", off(load_at(bench, -3.02050e-3, 5), 66.4453e3), 1e-5);
    CHECK_FIGURE("fixed beam, P at 5.28587 mm", off(load_at(bench, -5.28587e-3, 10), 68.90625e3), 1e-5);
    CHECK_FIGURE("fixed beam, load control's limit", off(limit_load(bench, 100e3), 68.90625e3), 1e-3);
}

TEST_CASE("reference 13: portal under a horizontal load, axially rigid (0.1 %; exact to 1e-5)") {
    const Bench bench = portal(1, 0);
    CHECK_FIGURE("portal, H at u = 14.8665 mm", off(load_at(bench, 14.8665e-3, 1), 26.7969e3), 1e-5);
    CHECK_FIGURE("portal, H at u = 23.7864 mm", off(load_at(bench, 23.7864e-3, 10), 30.625e3), 1e-5);
    CHECK_FIGURE("portal, load control's limit", off(limit_load(bench, 50e3), 30.625e3), 1e-3);
}

TEST_CASE("reference 13: portal, N and M together by eq 14: 30.6154 kN (0.1 %)") {
    const Bench bench = portal(1, 0, false, true);
    CHECK_FIGURE("portal with N-M interaction, plateau", off(load_at(bench, 60e-3, 60), 30.6154e3), 1e-4);
    CHECK(load_at(bench, 60e-3, 60) < 30.624e3);  // below the value without N
}

TEST_CASE("reference 13: portal, H = V: four hinges one after the other (0.1 %)") {
    const auto kinks = hinge_loads(portal(1, 1), 60e-3, 2000);
    REQUIRE(kinks.size() == 4);
    const double expected[] = {23.3864e3, 25.6136e3, 27.0640e3, 30.6250e3};
    for (int i = 0; i < 4; ++i)
        CHECK_FIGURE("portal H = V, hinge " + std::to_string(i + 1), off(kinks[i], expected[i]), 1e-4);
}

TEST_CASE("reference 13: portal, V = 2H and pinned bases (0.1 %)") {
    CHECK_FIGURE("portal V = 2H, plateau", off(load_at(portal(1, 2), 80e-3, 80), 22.96875e3), 1e-5);
    CHECK_FIGURE("portal V = 2H, load control's limit", off(limit_load(portal(1, 2), 40e3), 22.96875e3), 1e-3);
    const auto kinks = hinge_loads(portal(1, 1, true), 100e-3, 1000);
    REQUIRE(kinks.size() == 2);
    CHECK_FIGURE("pinned portal H = V, first hinge", off(kinks[0], 13.3152e3), 1e-4);
    CHECK_FIGURE("pinned portal H = V, second hinge", off(kinks[1], 15.3125e3), 1e-4);
}

namespace {

/// A cantilever along x of section S as it is, with one tip load; its limit load as a factor of that load.
double cantilever_limit(const Vec3& force, bool by_displacement) {
    Bench b(square(0.05));
    const int root = b.foot(0, 0, 0), tip = b.node(1, 0, 0);
    b.member(root, tip);
    b.load(tip, force);
    int component = 1;
    for (int c : {1, 2})
        if (std::abs(force[c]) > std::abs(force[component])) component = c;
    b.probe = tip, b.component = component;
    if (!by_displacement) return limit_load(b, 1.5);
    return load_at(b, std::copysign(0.3, force[component]), 60);
}

}  // namespace

TEST_CASE("reference 14: a biaxially bent square cantilever carries Mp/L in any direction (0.1 %)") {
    for (double degrees : {0.0, 17.0, 45.0, 71.0, 90.0, 200.0}) {
        const Vec3 along(0, std::cos(degrees * pi / 180), std::sin(degrees * pi / 180));
        CHECK_FIGURE("cantilever bent towards " + std::to_string(int(degrees)) + " degrees, load control",
                     off(cantilever_limit(Mp * along, false), 1), 1e-4);
        CHECK_FIGURE("cantilever bent towards " + std::to_string(int(degrees)) + " degrees, plateau",
                     off(cantilever_limit(Mp * along, true), 1), 1e-6);
    }
}

TEST_CASE("reference 14: bending with axial force: N = N0/2 and H = 6630.5 N; N = 3 F and H = F = 7650.87 N (0.1 %)") {
    CHECK_FIGURE("N = N0/2, H = 6630.5 N", off(cantilever_limit({N0 / 2, 0, 6630.5}, false), 1), 1e-4);
    CHECK_FIGURE("N = -N0/2, H = 6630.5 N", off(cantilever_limit({-N0 / 2, 0, 6630.5}, false), 1), 1e-4);
    CHECK_FIGURE("H = F, N = 3 F: 7650.87 N", off(cantilever_limit({3 * 7650.87, 0, 7650.87}, false), 1), 1e-4);
    CHECK_FIGURE("N alone: N0", off(cantilever_limit({N0, 0, 0}, false), 1), 1e-4);
}

TEST_CASE("reference 14: L-shaped cantilever in plan, bent and twisted at its root (0.1 %)") {
    for (const auto& [arm, load] : {std::pair{1.0, 4670.27}, std::pair{0.5, 6420.74}}) {
        Bench b(square(0.05));
        const int root = b.foot(0, 0, 0), elbow = b.node(1, 0, 0), tip = b.node(1, arm, 0);
        b.member(root, elbow);
        b.member(elbow, tip);
        b.load(tip, {0, 0, -1});
        b.probe = tip, b.component = 2;
        CHECK_FIGURE("L-cantilever, arm " + std::to_string(arm) + ", load control",
                     off(limit_load(b, 1.3 * load), load), 1e-4);
        CHECK_FIGURE("L-cantilever, arm " + std::to_string(arm) + ", plateau", off(load_at(b, -0.5, 100), load), 1e-4);
        CHECK_FIGURE("T0 of the root", off(1 / std::sqrt(b.build()->elements()[0].yield.z), T0), 1e-6);
    }
}

TEST_CASE(
    "asi and conventional elements: asi has the exact limit load with any mesh, the conventional one only from above "
    "(0.1 %)") {
    const auto limit = [](Formulation f, int elements) {
        Frame frame(small_displacement(f));
        frame.section = section_S(1e4);
        frame.material = steel(245e6);
        frame.elements = elements;
        const int a = frame.foot(0, 0, 0), b = frame.node(1, 0, 0);
        frame.member(a, b);
        frame.load(b, {0, 0, -1});
        const auto run = statics(frame.build(), driven(b, 2, -0.2, 40));
        REQUIRE(run->verdict() == Verdict::completed);
        return run->state().factor / Mp;
    };
    for (int n : {1, 2, 4}) {
        CHECK_FIGURE("asi, " + std::to_string(n) + " elements", off(limit(Formulation::asi, n), 1), 1e-6);
        // its hinge sits in the middle of the root element: arm L (1 - 1/(2 n))
        CHECK_FIGURE("conventional, " + std::to_string(n) + " elements",
                     off(limit(Formulation::conventional, n), 1 / (1 - 0.5 / n)), 1e-6);
    }
}

TEST_CASE(
    "the limit load does not depend on whether elastic points move with the hinge (Shift::elastic_and_plastic, 1e-6)") {
    ModelOptions options = small_displacement();
    options.shift = Shift::elastic_and_plastic;
    Frame frame(options);
    frame.section = section_S(1e4);
    frame.material = steel(245e6);
    const int left = frame.foot(0, 0, 0), mid = frame.node(0.5, 0, 0), right = frame.foot(1, 0, 0, 0b001110);
    frame.member(left, mid);
    frame.member(mid, right);
    frame.load(mid, {0, 0, -1});
    const auto run = statics(frame.build(), driven(mid, 2, -15e-3, 60));
    REQUIRE(run->verdict() == Verdict::completed);
    CHECK_FIGURE("propped cantilever, shifted points", off(run->state().factor, 45.9375e3), 1e-6);
}

TEST_CASE("the space frame SF-1 collapses at 12.6882 kN (0.5 %) and first yields at 8.555 kN (0.1 %)") {
    const SpaceFrame frame(small_displacement(), 1000, 245e6);
    const auto structure = frame.build();
    Statics run(structure, initial_state(*structure), driven(frame.loaded, 0, 20e-3, 200));
    double first = 0, before = 0, most = 0;
    while (run.advance()) {
        if (first == 0 && run.count_members(-1).yielded > 0) first = before;
        before = run.state().factor;
        most = largest_of(most, before);
    }
    REQUIRE(run.verdict() == Verdict::completed);
    CHECK_FIGURE("SF-1 limit load", off(most, 12.6882), 5e-3);
    CHECK_FIGURE("SF-1 first hinge (a step is 0.4 kN)", std::abs(first - 8.555), 0.4);
    StaticSettings below;
    below.steps = 1;
    const SpaceFrame elastic(small_displacement(), 8550, 245e6), yielding(small_displacement(), 8560, 245e6);
    CHECK(statics(elastic.build(), below)->count_members(-1).yielded == 0);
    CHECK(statics(yielding.build(), below)->count_members(-1).yielded == 1);
}

namespace {

/// Vogel's frame (tests/references.md): six storeys, two bays, in the x-z plane, to first order.
struct Vogel : Bench {
    bool axial_counts;

    explicit Vogel(bool axial) : Bench(nullptr), axial_counts(axial) {
        auto s235 = std::make_shared<Material>(*steel(235e6));
        s235->E = 205e9;
        s235->G = s235->E / 2.6;
        material = s235;
        int joint[7][3];
        for (int floor = 0; floor <= 6; ++floor)
            for (int line = 0; line < 3; ++line)
                joint[floor][line] = floor == 0 ? foot(6 * line, 0, 0) : node(6 * line, 0, 3.75 * floor);
        const std::shared_ptr<Section> outer[] = {profile(91.0, 8091, 827.0), profile(78.1, 5696, 642.5),
                                                  profile(54.3, 2492, 354.0)};  // HEB 220, 200, 160
        const std::shared_ptr<Section> inner[] = {profile(118, 14920, 1283), profile(106, 11260, 1053),
                                                  profile(78.1, 5696, 642.5)};  // HEB 260, 240, 200
        const std::shared_ptr<Section> ipe300 = profile(53.8, 8356, 628.4);
        const std::shared_ptr<Section> beam[] = {
            profile(84.5, 23130, 1307), profile(72.7, 16270, 1019), profile(62.6, 11770, 804.3), ipe300, ipe300,
            profile(39.1, 3892, 366.6)};  // IPE 400, 360, 330, 300, 300, 240
        for (int floor = 1; floor <= 6; ++floor) {
            for (int line = 0; line < 3; ++line) {
                const std::shared_ptr<Section>* column = line == 1 ? inner : outer;
                section = column[(floor - 1) / 2];
                member(joint[floor - 1][line], joint[floor][line]);
            }
            load(joint[floor][0], {floor == 6 ? 10.23e3 : 20.44e3, 0, 0});
            const Vec3 share(0, 0, -(floor == 6 ? 31.7e3 : 49.1e3) * 1.5 / 2);  // of a quarter of a span, at each end
            section = beam[floor - 1];
            for (int bay = 0; bay < 2; ++bay)
                for (int quarter = 0, last = joint[floor][bay]; quarter < 4; ++quarter) {
                    const int next =
                        quarter == 3 ? joint[floor][bay + 1] : node(6 * bay + 1.5 * (quarter + 1), 0, 3.75 * floor);
                    member(last, next);
                    load(last, share);
                    load(next, share);
                    if (floor == 6 && bay == 0 && quarter == 1) probe = next;  // middle of the left roof beam
                    last = next;
                }
        }
        component = 2;
    }

    /// From tables: area in cm2, moment of inertia in cm4, plastic modulus in cm3.
    std::shared_ptr<Section> profile(double area, double inertia, double modulus) const {
        auto s = std::make_shared<Section>();
        s->area = s->plastic_area = area * 1e-4;
        s->shear_area_x = s->shear_area_y = s->area / 3;
        s->Ix = inertia * 1e-8;
        s->Zx = modulus * 1e-6;
        s->Iy = s->Ix / 3, s->J = s->Ix / 100, s->Zy = s->Zx / 3, s->Zz = s->Zx / 10;  // do not act in the plane
        s->width = s->depth = 0.2;
        if (!axial_counts) s->given.N0 = infinite;
        return s;
    }
};

}  // namespace

TEST_CASE("Vogel's frame, N and M together by eq 14: displacement control arrives at the limit load (5e-6)") {
    // The roof beam sinks from 1.19505 on with N in it. N gives way along the yield surface, over some ten metres of
    // deflection that only a theory of small displacement allows, and the load goes up to the limit. All the way the
    // mechanism has a small stiffness of its own, and from 1.1955 on there are two.
    for (const auto& [axial, limit] : {std::pair{false, 1.197487}, std::pair{true, 1.195664}}) {
        const Vogel frame(axial);
        const auto run = statics(frame.build(), driven(frame.probe, frame.component, -60, 150));
        const std::string name = axial ? "Vogel's frame, N and M, " : "Vogel's frame, M alone, ";
        INFO(run->reason());
        REQUIRE(run->verdict() == Verdict::completed);
        CHECK_FIGURE(name + "limit load", off(run->state().factor, limit), 5e-6);
        CHECK_FIGURE(name + "steps with those halved", run->state().step, 200);
        CHECK_FIGURE(name + "factorisations", run->solver_counts().factorisations, 1500);
    }
}
