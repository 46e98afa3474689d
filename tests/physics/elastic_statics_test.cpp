// Elastic statics at large displacement against closed forms and independent solutions (tests/references.md
// 1, 2, 4, 8 and 10; Mattiasson 1981, Bathe and Bolourchi 1979).
#include "helpers.h"

using namespace hinge;
using namespace hinge::test;

namespace {

StaticSettings steps(int n) {
    StaticSettings s;
    s.steps = n;
    return s;
}

/// A cantilever along x of length 1, EI 1, all but rigid in tension and shear, of n members; bends in the xz plane.
struct Cantilever : Frame {
    std::vector<int> nodes;
    explicit Cantilever(int members) {
        material = unit_material();
        section = rigidities(1e7, 1, 1, 1, 1e7);
        nodes = straight(*this, {0, 0, 0}, {1, 0, 0}, members);
        model->fix(nodes[0], 63);
    }
    int tip() const { return nodes.back(); }
};

}  // namespace

TEST_CASE("elastic statics: a moment rolls a cantilever up into half a circle and a whole one", "[elastic_statics]") {
    for (double part : {0.5, 1.0}) {
        Cantilever beam(16);
        beam.load(beam.tip(), Vec3::Zero(), {0, -2 * pi * part, 0});  // lifts the tip
        const auto run = statics(beam.build(), steps(64));
        REQUIRE(run->verdict() == Verdict::completed);
        const Vec6 u = run->displacement(beam.tip());
        // radius 1 / M: the tip at (sin(M) / M, (1 - cos(M)) / M)
        const double M = 2 * pi * part, x = std::sin(M) / M, z = (1 - std::cos(M)) / M;
        CHECK_FIGURE("rolled up by " + std::to_string(part) + ": tip", std::hypot(1 + u[0] - x, u[2] - z), 2e-3);
    }
}

TEST_CASE("elastic statics: a dead load bends a cantilever as Mattiasson's elliptic integrals say",
          "[elastic_statics]") {
    const double table[][4] = {{1, 0.30172, 0.05643, 0.46135},
                               {2, 0.49346, 0.16064, 0.78175},
                               {5, 0.71379, 0.38763, 1.21537},
                               {10, 0.81061, 0.55500, 1.43029}};
    for (const auto& row : table) {
        Cantilever beam(8);
        beam.load(beam.tip(), {0, 0, -row[0]});
        const auto run = statics(beam.build(), steps(20));
        REQUIRE(run->verdict() == Verdict::completed);
        const Vec6 u = run->displacement(beam.tip());
        const std::string what = "PL^2/EI = " + std::to_string(int(row[0]));
        CHECK_FIGURE(what + ": deflection", off(-u[2], row[1]), 2e-3);
        CHECK_FIGURE(what + ": shortening", off(-u[0], row[2]), 4e-3);
        CHECK_FIGURE(what + ": slope", off(u[4], row[3]), 2e-3);
    }
}

TEST_CASE("elastic statics: the 45-degree bend goes out of its plane", "[elastic_statics]") {
    Frame frame;
    frame.material = std::make_shared<Material>(Material{1e7, 5e6, 1});
    auto section = std::make_shared<Section>(*square(1));
    section->J = 1.0 / 6;
    frame.section = section;
    std::vector<Vec3> points;
    for (int i = 0; i <= 8; ++i)
        points.push_back(100 * Vec3(std::sin(pi / 4 * i / 8), 1 - std::cos(pi / 4 * i / 8), 0));
    const std::vector<int> nodes = chain(frame, points, Vec3::UnitZ());
    frame.model->fix(nodes[0], 63);
    frame.load(nodes.back(), {0, 0, 600});
    const auto run = statics(frame.build(), steps(20));
    REQUIRE(run->verdict() == Verdict::completed);
    const Vec6 u = run->displacement(nodes.back());  // x along the first tangent, y towards the centre
    CHECK_FIGURE("45-degree bend: along the tangent", off(u[0], -23.5606), 5e-3);
    CHECK_FIGURE("45-degree bend: towards the centre", off(u[1], -13.6046), 5e-3);
    CHECK_FIGURE("45-degree bend: out of the plane", off(u[2], 53.4755), 5e-3);
}

TEST_CASE("elastic statics: von Mises's truss snaps through at its closed form's load", "[elastic_statics]") {
    ModelOptions options;
    options.p_delta = PDelta::chord;  // bars that bend next to nothing, and do not buckle for it
    Frame frame(options);
    frame.material = unit_material();
    frame.section = rigidities(1, 1e-6, 1e-6, 1e-6, 1);  // a hinged bar: next to no bending at its ends
    const int a = frame.foot(-1, 0, 0), b = frame.foot(1, 0, 0), top = frame.node(0, 0, 0.1);
    frame.model->fix(top, 1 | 2 | 8 | 16 | 32);
    frame.member(a, top);
    frame.member(b, top);
    frame.load(top, {0, 0, -1});
    const auto structure = frame.build();
    Statics run(structure, initial_state(*structure), driven(top, 2, -0.08, 80));
    double most = 0, at = 0;
    while (run.advance())
        if (!(run.state().factor <= most)) most = run.state().factor, at = -run.displacement(top)[2];
    CHECK(run.verdict() == Verdict::completed);
    const double bending = 24e-6 * 0.042361;  // of the two clamped bars: 2 * 12 EI w / L^3, not the truss's
    CHECK_FIGURE("von Mises: load", off(most - bending, 3.81087e-4), 1e-2);
    CHECK_FIGURE("von Mises: where", off(at, 0.042361), 4e-2);
}

TEST_CASE("elastic statics: a Timoshenko cantilever to the digits of its closed form", "[elastic_statics]") {
    Frame frame(small_displacement());
    const int wall = frame.foot(0, 0, 0), tip = frame.node(1, 0, 0);
    frame.member(wall, tip);
    frame.load(tip, {0, 0, -1000});
    const auto run = statics(frame.build(), steps(1));
    CHECK_FIGURE("cantilever of 50 mm square, 1 m, 1 kN", off(-run->displacement(tip)[2], 3.112854e-3), 2e-7);
}
