// Fracture (paper 2.3, eq 16, figs 4 and 5): what it conserves, what it costs, when it happens.
#include "effects/all_effects.h"
#include "section/fracture_limits.h"
#include "helpers.h"
#include "state/breaking.h"

using namespace hinge;
using namespace hinge::test;

namespace {

/// A star of members around node 0 in tumbling flight, some milliseconds in, so that it is bent, turned and vibrating.
struct Star {
    std::shared_ptr<const Structure> structure;
    State state;
    /// `bend`: by much more, at random.
    explicit Star(unsigned seed, MassKind kind = MassKind::consistent, int elements = 2, bool bend = false) {
        Dice dice(seed);
        Frame frame;
        frame.elements = elements;
        const Vec3 hub = dice.vector(3);
        frame.node(hub);
        for (int i = 0; i < 4; ++i)
            frame.member(0, frame.node(hub + dice(0.5, 1.5) * dice.direction()), dice.direction());
        const Vec3 v = dice.vector(100), w = dice.vector(30);
        for (int n = 0; n <= 4; ++n)
            frame.model->set_velocity(n, v + w.cross(frame.model->nodes()[n].position - hub) + dice.vector(2),
                                      w + dice.vector(2));
        structure = std::make_shared<Structure>(frame.model, kind);
        Dynamics run = dynamics(structure, {.dt = 1e-5, .duration = 2e-3, .beta = kind == MassKind::lumped ? 0 : 0.25});
        complete(run);
        state = run.state();
        for (std::size_t n = 0; bend && n < state.velocity.size(); ++n) {
            state.displacement[n] += dice.vector(0.05);
            state.rotation[n] = dice.rotation(0.2) * state.rotation[n];
            state.velocity[n] << dice.vector(100), dice.vector(30);
        }
    }
    Momentum now() const { return momentum(*structure, state); }
    double kinetic() const { return kinetic_energy(*structure, state); }
    Vec3 centre() const {
        Vec3 sum = Vec3::Zero();
        for_each_weight(*structure, state, [&](int node, double mass) {
            sum += mass * (structure->position()[node] + state.displacement[node]);
        });
        for (std::size_t n = 0; n < state.offset_mass.size(); ++n)
            if (const OffsetMass& h = state.offset_mass[n]; h.mass > 0)
                sum += h.mass * (structure->position()[n] + state.displacement[n]) + state.rotation[n] * h.moment;
        return sum / now().mass;
    }
};

beam::LimitReached rotated_by(double x, double y, const beam::FractureLimits& limits) {
    const double rotation[2] = {x, y};
    return beam::rotation_reached(rotation, limits);
}

}  // namespace

TEST_CASE(
    "fracture: a break keeps mass, momenta and centre, gains no energy, and accumulates what it costs (rounding)") {
    for (const MassKind kind : {MassKind::consistent, MassKind::lumped})
        for (const bool bend : {false, true}) {
            double momenta = 0, gained = 0, lost = 0, booked = 0, moved = 0;
            for (unsigned seed = 1; seed <= 20; ++seed) {
                const int elements = 2 + 2 * int(seed % 2);
                Star star(seed, kind, elements, bend);
                Dice dice(seed + 100);
                for (int n = 0; n < 8; ++n) {  // one after the other, several at the hub, some beside a broken one
                    const int element = elements * (n / 2) + dice.pick(elements), end = 1 + dice.pick(2);
                    if (star.state.broken[element]) continue;
                    const Momentum before = star.now();
                    const Vec3 centre = star.centre();
                    const double kinetic = star.kinetic(), accumulated = star.state.accumulated["fracture_kinetic"];
                    const BreakReport report = break_element(*star.structure, star.state, element, end);
                    momenta = largest_of(momenta, momentum_change(before, star.now()));
                    moved = largest_of(moved, (star.centre() - centre).norm());
                    gained = largest_of(gained, -report.kinetic / kinetic);
                    lost = largest_of(lost, report.kinetic / kinetic);
                    booked = largest_of(
                        booked, std::abs(kinetic - star.kinetic() - report.kinetic) / kinetic,
                        std::abs(star.state.accumulated["fracture_kinetic"] - accumulated - report.kinetic) / kinetic);
                    CHECK(report.elastic >= 0);
                    CHECK(star.state.broken[element] == end);
                    CHECK(star.state.force[element].isZero(0));
                }
            }
            CHECK_FIGURE("mass, linear and angular momentum", momenta, 1e-12);
            if (kind == MassKind::lumped) CHECK_FIGURE("centre", moved, 1e-13);
            CHECK_FIGURE("kinetic energy gained in a break", gained, 1e-14);
            CHECK_FIGURE("kinetic energy lost and accumulated", booked, 1e-12);
            if (bend) CHECK(lost > 0.01);
        }
}

TEST_CASE("fracture: a node that has lost all its elements leaves the solve") {
    Star star(7);
    const int element = 1, freed = star.structure->elements()[element].node[1];
    REQUIRE(star.structure->elements_at(freed).size() == 1);
    const BreakReport report = break_element(*star.structure, star.state, element, 2);
    CHECK(report.orphaned);
    CHECK(star.state.gone[freed] == 1);
    CHECK(star.state.held[freed] == 63);
    Dynamics on(star.structure, star.state, {.dt = 1e-5, .duration = 2e-3});
    const Vec3 there = star.state.displacement[freed];
    complete(on);
    CHECK(on.state().displacement[freed] == there);
}

TEST_CASE("fracture: a body that has broken flies on with its momenta and its energy") {
    for (const MassKind kind : {MassKind::consistent, MassKind::lumped}) {
        const bool in_explicit_steps = kind == MassKind::lumped;
        Star star(3, kind);
        for (int element : {1, 2, 5}) break_element(*star.structure, star.state, element, 1 + element % 2);
        const Momentum before = star.now();
        Dynamics on(star.structure, star.state,
                    {.dt = in_explicit_steps ? 2e-6 : 1e-5, .duration = 0.01, .beta = in_explicit_steps ? 0 : 0.25});
        double worst = 0;
        while (on.advance()) worst = largest_of(worst, std::abs(on.energy().error) / on.energy().initial);
        CHECK(on.verdict() == Verdict::completed);
        CHECK_FIGURE("energy error after three breaks", worst, 1e-4);
        CHECK_FIGURE("momenta after three breaks", momentum_change(before, momentum(*star.structure, on.state())),
                     in_explicit_steps ? 1e-5 : 1e-4);
    }
}

TEST_CASE("fracture: eq 16 holds just below each limit, and breaks at it and above; each strain alone, either sign") {
    const double limit_x = 0.4, limit_y = 0.5, limit_axial = 0.3;
    const auto breaks = [&](const beam::FractureStrains& e, bool tension_only) {
        beam::FractureLimits limits{limit_x, limit_y, limit_axial};
        limits.tension_only = tension_only;
        return beam::reached(e, limits);
    };
    for (const bool tension_only : {false, true}) {
        CHECK_FALSE(breaks({0, 0, 0, 1e9}, tension_only));  // twist has no limit
        CHECK_FALSE(breaks({std::nextafter(limit_x, 0), -std::nextafter(limit_y, 0), std::nextafter(limit_axial, 0), 0},
                           tension_only));
        for (const double sign : {1.0, -1.0})
            for (const int strain : {0, 1, 2})
                for (const int where : {-1, 0, 1}) {
                    const double limit = Vec3(limit_x, limit_y, limit_axial)[strain],
                                 size = where == 0 ? limit : std::nextafter(limit, where < 0 ? 0 : infinite);
                    const Vec3 e = sign * size * Vec3::Unit(strain);
                    const bool spared = strain == 2 && tension_only && sign < 0;
                    INFO("strain " << strain << ", sign " << sign << ", " << where << ", tension_only "
                                   << tension_only);
                    CHECK(breaks({e[0], e[1], e[2], 0}, tension_only) == (where >= 0 && !spared));
                }
    }
    // the strains of an element: end rotations about x and y, stretch and twist over its length
    Vec6 d;
    d << -0.01, 0.03, 0.02, -0.05, 0.004, 0.006;
    const beam::FractureStrains e = beam::fracture_strains(d, 0.5);
    CHECK(e.curvature_x == Approx(0.08));
    CHECK(e.curvature_y == Approx(-0.14));
    CHECK(e.axial == Approx(0.008));
    CHECK(e.twist == Approx(0.012));
}

TEST_CASE("fracture: a rotation of a hinge breaks at its limit and not just below, of either sign, each axis alone") {
    beam::FractureLimits limits;
    limits.hinge_rotation_x = 0.05, limits.hinge_rotation_y = 0.03;
    for (const double sign : {1.0, -1.0}) {
        CHECK(rotated_by(sign * 0.05, 0, limits).which == beam::Limit::hinge_rotation_x);
        CHECK(rotated_by(sign * 0.05, 0, limits).strain == sign * 0.05);
        CHECK(rotated_by(0, sign * 0.03, limits).which == beam::Limit::hinge_rotation_y);
        CHECK(rotated_by(sign * std::nextafter(0.05, 0), sign * std::nextafter(0.03, 0), limits).which ==
              beam::Limit::rule);
    }
    // both: the one that is further beyond
    CHECK(rotated_by(0.06, 0.035, limits).which == beam::Limit::hinge_rotation_x);
    CHECK(rotated_by(0.06, 0.045, limits).which == beam::Limit::hinge_rotation_y);
}

TEST_CASE("fracture: a limit that is not given is never reached") {
    beam::FractureLimits limits;
    CHECK(limits.none());
    CHECK(rotated_by(1e300, -1e300, limits).which == beam::Limit::rule);
    limits.hinge_rotation_y = 0.03;
    CHECK((!limits.none() && limits.no_strains()));
    CHECK(rotated_by(1e300, 0, limits).which == beam::Limit::rule);
    limits = {.elongation = 0.1};
    CHECK((!limits.none() && !limits.no_hinges()));
    limits = {.curvature_x = 1};  // a limit of strain leaves those of hinges alone
    CHECK((limits.no_hinges() && !limits.no_strains()));
}
