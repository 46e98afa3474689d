// Explicit steps (central differences, lumped masses): how long they may be, what they keep, and that they give what
// the implicit ones give.
#include <Eigen/Eigenvalues>

#include "effects/all_effects.h"
#include "helpers.h"
#include "state/breaking.h"
#include "algebra/stable_step.h"

using namespace hinge;
using namespace hinge::test;

namespace {

std::shared_ptr<const Structure> lumped(const Frame& frame) {
    return std::make_shared<Structure>(frame.model, MassKind::lumped);
}

DynamicSettings explicit_steps(double dt, double duration) {
    DynamicSettings s;
    s.dt = dt;
    s.duration = duration;
    s.beta = 0;
    return s;
}
DynamicSettings implicit_steps(double dt, double duration) {
    DynamicSettings s;
    s.dt = dt;
    s.duration = duration;
    return s;
}

/// 2 / omega of the fastest vibration of the whole structure.
double limit_of(const Structure& structure) {
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> modes(
        dense(structure, 0, 1), dense(structure, 1, 0), Eigen::EigenvaluesOnly);
    return 2 / std::sqrt(modes.eigenvalues().maxCoeff<Eigen::PropagateNaN>());
}

/// What eq 20 lacks at worst, of what there was or was put in.
double worst_energy_error(Dynamics& run, int every = 1) {
    double worst = 0;
    while (run.advance()) {
        if (run.steps_done() % every) continue;
        const Energy e = run.energy();
        worst = largest_of(worst, std::abs(e.error) / largest_of(e.initial, std::abs(e["work"])));
    }
    REQUIRE(run.verdict() == Verdict::completed);
    return worst;
}

// ---- free flight
// ------------------------------------------------------------------------------------------------------

/// A beam skew in space with speed v and spin about an axis across it, for 0.03 s.
Flight fly(const Vec3& v, double spin, double dt) {
    Frame frame;
    const Vec3 along = Vec3(1, 2, -0.5).normalized(), axis = along.unitOrthogonal(), start(1, 1, 1);
    const auto nodes = straight(frame, start, start + along, 2, axis);
    for (int n : nodes)
        frame.model->set_velocity(n, v + spin * axis.cross(frame.model->nodes()[n].position - start - 0.5 * along),
                                  spin * axis);
    const auto structure = lumped(frame);
    Dynamics run(structure, initial_state(*structure), explicit_steps(dt, 0.03));
    return worst_of_flight(run);
}

// ---- a cantilever
// -----------------------------------------------------------------------------------------------------

/// 16 elements along x, 1 m, set going upwards in its first bending mode; each joint with a random
/// velocity of up to `scatter` m/s as well.
struct Cantilever : Frame {
    static constexpr double root = 1.875104068711961;
    std::vector<int> nodes;
    Cantilever(ModelOptions options, double side, double tip_speed, double scatter = 0) : Frame(options) {
        Dice dice(51);
        section = square(side);
        nodes = straight(*this, Vec3::Zero(), Vec3(1, 0, 0), 8, Vec3::UnitZ());
        model->fix(nodes[0], 63);
        const double sigma = (std::cosh(root) + std::cos(root)) / (std::sinh(root) + std::sin(root));
        for (std::size_t i = 1; i < nodes.size(); ++i) {
            const double x = root * i / 8;
            const double shape = 0.5 * (std::cosh(x) - std::cos(x) - sigma * (std::sinh(x) - std::sin(x)));
            const double slope = 0.5 * root * (std::sinh(x) + std::sin(x) - sigma * (std::cosh(x) - std::cos(x)));
            model->set_velocity(nodes[i], Vec3(0, 0, tip_speed * shape) + dice.vector(scatter),
                                {0, -tip_speed * slope, 0});
        }
    }
    int tip() const { return nodes.back(); }
    double omega() const {
        return std::sqrt(material->E * section->Ix / (material->density * section->area)) * root * root;
    }
};

// ---- two beams that meet
// ----------------------------------------------------------------------------------------------

ContactRule surface() {
    ContactRule rule;
    rule.settings.rule = contact::ContactRuleKind::surface;
    return rule;
}

/// Beam a along x, clamped; beam b above it at `angle` degrees, `off` m from the middle of a, falling at 50 m/s.
Frame falling_beam(ContactRule rule, double angle, double off) {
    Frame frame;
    add_contact(*frame.model, rule);
    const Vec3 d(std::cos(angle * pi / 180), std::sin(angle * pi / 180), 0), middle(off, 0, 0.25);
    const int a1 = frame.foot(-0.5, 0, 0), a2 = frame.foot(0.5, 0, 0), b1 = frame.node(middle - 0.5 * d),
              b2 = frame.node(middle + 0.5 * d);
    frame.member(a1, a2);
    frame.member(b1, b2);
    for (int b : {b1, b2}) frame.model->set_velocity(b, {0, 0, -50}, Vec3::Zero());
    return frame;
}

}  // namespace

TEST_CASE(
    "explicit: where the axial vibration rules, the stable step is that of a third and two thirds (1e-12: rounding)",
    "[explicit]") {
    // omega^2 = EA/L (3 + 3/2) / m, so sqrt(8/9) L/c; soft in shear and torsion: sqrt(GA / rho Ip) and sqrt(EI / rho
    // Ip) 2/L stay below 2c/L
    Frame frame;
    frame.material = unit_material();
    frame.section = rigidities(2, 0.3, 0.3, 0.01, 0.01);
    frame.elements = 4;
    const int corner = frame.foot(0, 0, 0);
    frame.member(corner, frame.node(2, 0, 0));
    frame.member(corner, frame.node(0, 1.2, 0));  // its elements are the shorter ones: 0.3 m, c = 1 m/s
    const auto structure = lumped(frame);
    const StableStep limit = stable_step(*structure);
    CHECK_FIGURE("sqrt(8/9) L/c", off(limit.dt, std::sqrt(8.0 / 9) * 0.3), 1e-12);
    CHECK(structure->elements()[limit.element].member == 1);
}

TEST_CASE(
    "explicit: no structure vibrates faster than its stable step has it, and none much more slowly (half as long "
    "again)",
    "[explicit]") {
    const auto check = [](const char* what, const Frame& frame) {
        const auto structure = lumped(frame);
        const double ratio = limit_of(*structure) / stable_step(*structure).dt;
        CHECK_FIGURE(std::string(what) + ": stable step over 2/omega", 1 / ratio, 1 + 1e-9);
        CHECK_FIGURE(std::string(what) + ": 2/omega over stable step", ratio, 1.5);
    };
    check("cantilever", Cantilever({}, 0.02, 0));
    check("space frame", SpaceFrame({}, 0, infinite));
    Frame mixed;
    mixed.elements = 4;
    const int a = mixed.foot(0, 0, 0), b = mixed.node(1, 0.3, 0.5), c = mixed.foot(2, 0, 0.2, 0b000111);
    mixed.member(a, b);
    mixed.section = square(0.02);
    mixed.elements = 2;
    mixed.member(b, c);
    mixed.member(b, mixed.node(1, 1, 1));
    check("two sections", mixed);
    for (Formulation f : {Formulation::asi, Formulation::conventional}) {
        ModelOptions options;
        options.formulation = f;
        check(f == Formulation::asi ? "space frame, asi" : "space frame, conventional",
              SpaceFrame(options, 0, infinite));
    }
}

TEST_CASE("explicit: a free beam with speed and spin keeps both momenta to rounding, and its energy better with dt^2",
          "[explicit]") {
    // the two halves of a central-difference step, velocity and displacement, each keep both momenta: what is left is
    // rounding over 1e4 steps
    const Flight coarse = fly({20, 5, 1}, 50, 1e-5), fine = fly({20, 5, 1}, 50, 2.5e-6);
    CHECK_FIGURE("linear momentum", fine.linear, 1e-12);
    CHECK_FIGURE("angular momentum", fine.angular, 1e-11);
    CHECK_FIGURE("energy, dt 2.5 us", fine.energy, 1e-4);
    CHECK_FIGURE("energy falls with dt^2: 16 times for 4", fine.energy / coarse.energy, 1.0 / 8);
}

TEST_CASE("explicit: just below the limit a cantilever stays bounded over 20000 steps, 5 % above it does not",
          "[explicit]") {
    for (bool large : {false, true}) {
        const std::string name = large ? "large displacement" : "small displacement";
        const Cantilever frame(large ? ModelOptions{} : small_displacement(), 0.05, 1, 0.1);  // all modes are there
        const auto structure = lumped(frame);
        const double limit = limit_of(*structure), swing = 1 / frame.omega();

        const double below = 0.99 * limit;
        Dynamics stays(structure, initial_state(*structure), explicit_steps(below, 20000 * below));
        double furthest[2] = {0, 0}, kinetic[2] = {0, 0};  // in the first half and in the second
        while (stays.advance()) {
            const int half = stays.steps_done() > 10000;
            furthest[half] = largest_of(furthest[half], std::abs(stays.displacement(frame.tip())[2]));
            kinetic[half] = largest_of(kinetic[half], stays.energy()["kinetic"]);
        }
        REQUIRE(stays.verdict() == Verdict::completed);
        CHECK(stays.steps_done() == 20000);
        CHECK_FIGURE(name + ": swing of the second half over that of the first", furthest[1] / furthest[0], 1.05);
        CHECK_FIGURE(name + ": kinetic energy of the second half over that of the first", kinetic[1] / kinetic[0],
                     1.05);
        CHECK_FIGURE(name + ": swing against v / omega", off(furthest[1], swing),
                     0.1);  // what a scatter of a tenth may add

        const double above = 1.05 * limit;
        Dynamics grows(structure, initial_state(*structure), explicit_steps(above, 20000 * above));
        double most = 0;
        while (grows.advance()) most = largest_of(most, grows.displacement(frame.tip()).head<3>().norm());
        INFO(name << ": " << hinge::name(grows.verdict()) << ", " << grows.reason() << ", " << most << " m");
        const bool failed = grows.verdict() == Verdict::failed;
        REQUIRE((failed || most > 100 * swing));
        if (failed)
            CHECK((grows.reason().find("element ") != std::string::npos ||
                   grows.reason().find("node ") != std::string::npos));  // where
    }
}

TEST_CASE("explicit: first bending frequency of a cantilever of 16 elements to 0.5 %", "[explicit]") {
    // masses at 17 nodes: (1.875/16)^2/12 = 0.1 %; shear and rotary inertia at L/b = 50: 0.1 %
    const Cantilever frame({}, 0.02, 0.1);
    const auto structure = lumped(frame);
    const double dt = usual_step(stable_step(*structure), *structure);
    Dynamics run(structure, initial_state(*structure), explicit_steps(dt, 5.2 * 2 * pi / frame.omega()));
    std::vector<double> crossings;
    double before = 0;
    while (run.advance()) {
        const double now = run.displacement(frame.tip())[2];
        if (before < 0 && now >= 0) crossings.push_back(run.state().time - dt * now / (now - before));
        before = now;
    }
    REQUIRE(run.verdict() == Verdict::completed);
    REQUIRE(crossings.size() == 5);
    CHECK_FIGURE("frequency", off(2 * pi * 4 / (crossings.back() - crossings.front()), frame.omega()), 5e-3);
}

TEST_CASE("explicit: a plastic portal under a sudden load dissipates what it does in implicit steps, to 2 %",
          "[explicit]") {
    // beside the step, the kinds of mass differ: lumped in explicit steps, consistent in implicit ones
    Frame frame;
    frame.material = steel(245e6);
    frame.elements = 8;
    const int a = frame.foot(0, 0, 0), b = frame.node(0, 0, 1), c = frame.node(1, 0, 1), d = frame.foot(1, 0, 0);
    frame.member(a, b);
    frame.member(b, c);
    frame.member(c, d);
    frame.load(b, {20e3, 2e3, 0});
    const double duration = 0.02, dt = 1e-6;
    const auto with_lumps = lumped(frame), with_all = frame.build();
    REQUIRE(dt < stable_step(*with_lumps).dt);
    Dynamics fast(with_lumps, initial_state(*with_lumps), explicit_steps(dt, duration)),
        slow(with_all, initial_state(*with_all), implicit_steps(dt, duration));
    const double energy_error = worst_energy_error(fast, 10);
    worst_energy_error(slow, 1000);
    REQUIRE(fast.verdict() == Verdict::completed);
    REQUIRE(slow.verdict() == Verdict::completed);
    const double dissipated = slow.energy()["plastic"];
    CHECK(dissipated > 0.2 * slow.energy()["work"]);
    CHECK_FIGURE("dissipated in hinges", off(fast.energy()["plastic"], dissipated), 0.02);
    CHECK_FIGURE("sway", off(fast.displacement(b)[0], slow.displacement(b)[0]), 0.02);
    CHECK_FIGURE("energy error over the work of the load", energy_error, 1e-3);
}

TEST_CASE(
    "explicit: two beams that collide keep the energy balance to 0.5 % of the initial energy, by gap and by surface",
    "[explicit]") {
    // What the fastest vibrations hold swings by (omega dt / 2)^2 in central differences and comes back: in the longest
    // steps a run takes of itself the end of the run tells what is lost, in half of them every step
    for (const auto& [what, rule] : {std::pair{"gap", ContactRule{}}, {"surface", surface()}})
        for (double angle : {90.0, 45.0})
            for (bool half : {false, true}) {
                const Frame frame = falling_beam(rule, angle, 0.13);
                const auto structure = lumped(frame);
                Dynamics run(structure, initial_state(*structure),
                             explicit_steps((half ? 0.5 : 1) * usual_step(stable_step(*structure), *structure), 0.03));
                const double worst = worst_energy_error(run, 5);
                CHECK(run.verdict() == Verdict::completed);
                CHECK(contact_of(run.state())->counts().bound > 0);
                char text[64];
                std::snprintf(text, sizeof text, "%s, %g degrees: energy error %s", what, angle,
                              half ? "at worst, half the step" : "at the end");
                CHECK_FIGURE(text, half ? worst : std::abs(run.energy().error) / run.energy().initial, 5e-3);
            }
}

TEST_CASE("explicit: the energy error of a collision falls with the square of the step", "[explicit]") {
    double worst[2];
    for (int fine : {0, 1}) {
        const Frame frame = falling_beam(surface(), 90, 0.13);
        const auto structure = lumped(frame);
        Dynamics run(structure, initial_state(*structure), explicit_steps(fine ? 2e-6 : 8e-6, 0.03));
        worst[fine] = worst_energy_error(run, 5);
    }
    CHECK_FIGURE("energy error of a quarter of the step, of the energy error", worst[1] / worst[0], 1.0 / 8);
}

TEST_CASE("explicit: a beam that breaks under the blow keeps the energy balance to 0.5 % of the initial energy",
          "[explicit]") {
    for (const auto& [what, rule] : {std::pair{"gap", ContactRule{}}, {"surface", surface()}}) {
        Frame frame = falling_beam(rule, 90, 0.1);
        FractureRule breaks;
        breaks.curvature_x = breaks.curvature_y = 0.03;
        add_fracture(*frame.model, breaks);
        const auto structure = lumped(frame);
        Dynamics run(structure, initial_state(*structure), explicit_steps(0.5 * stable_step(*structure).dt, 0.015));
        const double worst = worst_energy_error(run, 5);
        CHECK(run.verdict() == Verdict::completed);
        CHECK(run.count_members(-1).broken > 0);
        CHECK(run.energy()["fracture"] > 0);
        CHECK_FIGURE(std::string(what) + ": energy error through breaks", worst, 5e-3);
    }
}

TEST_CASE("explicit: a body that has broken flies on with its momenta", "[explicit]") {
    Frame frame;
    const int hub = frame.node(0, 0, 0);
    for (const Vec3& x : {Vec3(1, 0, 0.2), Vec3(-0.4, 0.8, 0), Vec3(-0.3, -0.7, 0.4)}) frame.member(hub, frame.node(x));
    const Vec3 v(30, -10, 5), w(5, 10, -20);
    for (int n = 0; n < 4; ++n) frame.model->set_velocity(n, v + w.cross(frame.model->nodes()[n].position), w);
    const auto structure = lumped(frame);
    State state = initial_state(*structure);
    for (int element : {1, 2}) break_element(*structure, state, element, 1 + element % 2);
    const Momentum before = momentum(*structure, state);
    Dynamics run(structure, state, explicit_steps(2e-6, 0.02));
    const double worst = worst_energy_error(run, 10);
    REQUIRE(run.verdict() == Verdict::completed);
    const Momentum after = momentum(*structure, run.state());
    CHECK_FIGURE("energy", worst, 1e-4);
    CHECK_FIGURE("linear momentum", (after.linear - before.linear).norm() / before.linear.norm(), 1e-5);
    CHECK_FIGURE("angular momentum", (after.angular - before.angular).norm() / before.angular.norm(), 1e-5);
}

TEST_CASE("explicit: a break keeps both momenta and gains no energy (1e-12, 1e-14: rounding)", "[explicit]") {
    double worst = 0, gained = 0, lost = 0;
    for (unsigned seed = 1; seed <= 20; ++seed) {
        Dice dice(seed);
        Frame frame;
        const int hub = frame.node(dice.vector(3));
        for (int i = 0; i < 4; ++i)
            frame.member(hub, frame.node(frame.model->nodes()[hub].position + dice(0.5, 1.5) * dice.direction()),
                         dice.direction());
        for (int n = 0; n < 5; ++n) frame.model->set_velocity(n, dice.vector(100), dice.vector(30));
        const auto structure = lumped(frame);
        State state = initial_state(*structure);
        for (int n = 0; n < 4; ++n) {
            const Momentum before = momentum(*structure, state);
            const double kinetic = kinetic_energy(*structure, state);
            const BreakReport report = break_element(*structure, state, 2 * n + dice.pick(2), 1 + dice.pick(2));
            const Momentum after = momentum(*structure, state);
            worst = largest_of(worst, (after.linear - before.linear).norm() / before.linear.norm(),
                               (after.angular - before.angular).norm() / before.angular.norm());
            worst = largest_of(worst, std::abs(kinetic - kinetic_energy(*structure, state) - report.kinetic) / kinetic);
            gained = largest_of(gained, -report.kinetic / kinetic);
            lost = largest_of(lost, report.kinetic / kinetic);
        }
    }
    CHECK(lost > 0.01);
    CHECK_FIGURE("momenta, and the energy that is accumulated, 80 breaks", worst, 1e-12);
    CHECK_FIGURE("kinetic energy gained in a break", gained, 1e-14);
}

TEST_CASE(
    "explicit: a break of bent pairs keeps both momenta and the centre, and gains no energy (1e-12, 1e-14: rounding)",
    "[explicit]") {
    double worst = 0, gained = 0, moved = 0;
    const auto centre = [](const Structure& structure, const State& state) {
        Vec3 sum = Vec3::Zero();
        for_each_weight(structure, state, [&](int node, double mass) {
            sum += mass * (structure.position()[node] + state.displacement[node]);
        });
        for (std::size_t n = 0; n < state.offset_mass.size(); ++n)
            if (const OffsetMass& h = state.offset_mass[n]; h.mass > 0)
                sum += h.mass * (structure.position()[n] + state.displacement[n]) + state.rotation[n] * h.moment;
        return sum;
    };
    for (unsigned seed = 1; seed <= 40; ++seed) {
        Dice dice(seed);
        Frame frame;
        frame.elements = 2 + 2 * int(seed % 2);
        const int hub = frame.node(dice.vector(3));
        for (int i = 0; i < 3; ++i)
            frame.member(hub, frame.node(frame.model->nodes()[hub].position + dice(0.5, 1.5) * dice.direction()),
                         dice.direction());
        const auto structure = lumped(frame);
        State state = initial_state(*structure);
        for (std::size_t n = 0; n < state.velocity.size(); ++n) {
            state.displacement[n] = dice.vector(0.05);
            state.rotation[n] = Quat(Eigen::AngleAxisd(dice(-0.2, 0.2), dice.direction()));
            state.velocity[n] << dice.vector(100), dice.vector(30);
        }
        for (int i = 0; i < 6; ++i) {
            const int element = frame.elements / 2 * i + (i % 2 && frame.elements == 2 ? 0 : dice.pick(2) % 2);
            if (state.broken[element]) continue;
            const Momentum before = momentum(*structure, state);
            const double kinetic = kinetic_energy(*structure, state);
            const Vec3 at = centre(*structure, state);
            const BreakReport report = break_element(*structure, state, element, 1 + dice.pick(2));
            const Momentum after = momentum(*structure, state);
            moved = largest_of(moved, (centre(*structure, state) - at).norm() / before.mass);
            worst = largest_of(worst, (after.linear - before.linear).norm() / before.linear.norm(),
                               (after.angular - before.angular).norm() / before.angular.norm());
            worst = largest_of(worst, std::abs(kinetic - kinetic_energy(*structure, state) - report.kinetic) / kinetic,
                               std::abs(after.mass / before.mass - 1));
            gained = largest_of(gained, -report.kinetic / kinetic);
        }
    }
    CHECK_FIGURE("momenta, mass, and the energy that is accumulated", worst, 1e-12);
    CHECK_FIGURE("centre", moved, 1e-13);
    CHECK_FIGURE("kinetic energy gained in a break", gained, 1e-14);
}

TEST_CASE(
    "explicit: a rigid offset mass on a pin swings about the pin, in explicit steps and in implicit ones (2e-3: its "
    "rotary inertia, "
    "r^2/L^2)",
    "[explicit]") {
    // inertia c m L^2 about the pin, 1/3 of a rod: theta'' = g cos(theta) / (2 c L) from the horizontal, theta'^2 = g
    // sin(theta) / (c L)
    constexpr double g = 9.80665, L = 0.5;
    for (bool in_explicit_steps : {true, false}) {
        const std::string name = in_explicit_steps ? "explicit" : "implicit";
        const double c = 1.0 / 3;
        Frame frame;
        frame.section = square(0.02);
        set_gravity(*frame.model, {0, 0, -g});
        const int pin = frame.foot(0, 0, 0, 0b000111);
        frame.member(pin, frame.node(2 * L, 0, 0));
        const auto structure = in_explicit_steps ? lumped(frame) : frame.build();
        State state = initial_state(*structure);
        REQUIRE(structure->elements()[0].node[0] == pin);
        break_element(*structure, state, 0, 2);
        const double dt = in_explicit_steps ? 4e-6 : 2e-5, duration = 0.15;
        Dynamics run(structure, state, in_explicit_steps ? explicit_steps(dt, duration) : implicit_steps(dt, duration));
        CHECK_FIGURE(name + ": angular acceleration at the start",
                     off(run.state().acceleration[pin][4], g / (2 * c * L)), 2e-3);
        double worst = 0;
        while (run.advance())
            if (run.steps_done() % 10 == 0) worst = largest_of(worst, std::abs(run.energy().error));
        REQUIRE(run.verdict() == Verdict::completed);
        const Vec3 along = run.state().rotation[pin] * Vec3::UnitX();
        CHECK(-along.z() > 0.2);
        CHECK_FIGURE(name + ": angular speed for the height fallen",
                     off(std::pow(run.state().velocity[pin][4], 2), g * -along.z() / (c * L)), 2e-3);
        CHECK_FIGURE(name + ": energy error over the kinetic energy", worst / run.energy()["kinetic"], 1e-3);
    }
}
