// Explicit steps (central differences, lumped masses): how long they may be, what they keep, and that they give what
// the implicit ones give.
#include <Eigen/Eigenvalues>

#include "helpers.h"
#include "state/breaking.h"
#include "algebra/stable_step.h"

using namespace hinge;
using namespace hinge::test;

namespace {

std::shared_ptr<const Structure> lumped(const Frame& frame) {
    return std::make_shared<Structure>(frame.model, MassKind::lumped);
}

DynamicSettings explicit_steps(double dt, double duration) { return {.dt = dt, .duration = duration, .beta = 0}; }
DynamicSettings implicit_steps(double dt, double duration) { return {.dt = dt, .duration = duration}; }

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
    complete(run);
    return worst;
}

// ---- a cantilever

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

/// Beam b falls at 50 m/s on beam a, which is clamped, `off` m from its middle.
Frame falling_beam(const ContactRule& rule, double angle, double off) {
    Frame frame;
    add_contact(*frame.model, rule);
    falling_on(frame, true, 0.25, angle, off, 0, 50);
    return frame;
}

}  // namespace

TEST_CASE("explicit: where the axial vibration rules, the stable step is that of a third and two thirds (rounding)") {
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

TEST_CASE("explicit: no structure vibrates faster than its stable step has it, and none is half as slow again") {
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
        check(f == Formulation::asi ? "space frame, asi" : "space frame, conventional",
              SpaceFrame({.formulation = f}, 0, infinite));
    }
}

TEST_CASE("explicit: just below the limit a cantilever stays bounded over 20000 steps, 5 % above it does not") {
    for (bool large : {false, true}) {
        const std::string name = large ? "large displacement" : "small displacement";
        const Cantilever frame(large ? ModelOptions{} : small_displacement(), 0.05, 1, 0.1);  // all modes are there
        const auto structure = lumped(frame);
        const double limit = limit_of(*structure), swing = 1 / frame.omega();

        const double below = 0.99 * limit;
        Dynamics stays = dynamics(structure, explicit_steps(below, 20000 * below));
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
        // a scatter of a tenth may add as much
        CHECK_FIGURE(name + ": swing against v / omega", off(furthest[1], swing), 0.1);

        const double above = 1.05 * limit;
        Dynamics grows = dynamics(structure, explicit_steps(above, 20000 * above));
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

TEST_CASE("explicit: first bending frequency of a cantilever of 16 elements to 0.5 %") {
    // masses at 17 nodes: (1.875/16)^2/12 = 0.1 %; shear and rotary inertia at L/b = 50: 0.1 %
    const Cantilever frame({}, 0.02, 0.1);
    const auto structure = lumped(frame);
    const double dt = usual_step(stable_step(*structure), *structure);
    Dynamics run = dynamics(structure, explicit_steps(dt, 5.2 * 2 * pi / frame.omega()));
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

TEST_CASE("explicit: two beams that collide keep the energy balance to 0.5 % of the initial energy, by both rules") {
    // What the fastest vibrations hold swings by (omega dt / 2)^2 in central differences and comes back: in the longest
    // steps a run takes of itself the end of the run tells what is lost, in half of them every step
    for (const auto& [what, rule] : {std::pair{"gap", ContactRule{}}, {"surface", surface()}})
        for (double angle : {90.0, 45.0})
            for (bool half : {false, true}) {
                const auto structure = lumped(falling_beam(rule, angle, 0.13));
                const double dt = (half ? 0.5 : 1) * usual_step(stable_step(*structure), *structure);
                Dynamics run = dynamics(structure, explicit_steps(dt, 0.03));
                const double worst = worst_energy_error(run, 5);
                CHECK(contact_of(run.state())->counts().bound > 0);
                INFO(what << ", " << angle << " degrees");
                const char* name = half ? "energy error at worst, half the step" : "energy error at the end";
                CHECK_FIGURE(name, half ? worst : std::abs(run.energy().error) / run.energy().initial, 5e-3);
            }
}

TEST_CASE("explicit: the energy error of a collision falls with the square of the step") {
    double worst[2];
    for (int fine : {0, 1}) {
        Dynamics run = dynamics(lumped(falling_beam(surface(), 90, 0.13)), explicit_steps(fine ? 2e-6 : 8e-6, 0.03));
        worst[fine] = worst_energy_error(run, 5);
    }
    CHECK_FIGURE("energy error of a quarter of the step, of the energy error", worst[1] / worst[0], 1.0 / 8);
}

TEST_CASE("explicit: a beam that breaks under the blow keeps the energy balance to 0.5 % of the initial energy") {
    for (const auto& [what, rule] : {std::pair{"gap", ContactRule{}}, {"surface", surface()}}) {
        Frame frame = falling_beam(rule, 90, 0.1);
        add_fracture(*frame.model, bent_by(0.03));
        const auto structure = lumped(frame);
        Dynamics run = dynamics(structure, explicit_steps(0.5 * stable_step(*structure).dt, 0.015));
        const double worst = worst_energy_error(run, 5);
        CHECK(run.count_members(-1).broken > 0);
        CHECK(run.energy()["fracture"] > 0);
        CHECK_FIGURE(std::string(what) + ": energy error through breaks", worst, 5e-3);
    }
}

TEST_CASE("explicit: a rigid offset mass on a pin swings about it, as by implicit steps (2e-3: its rotary inertia)") {
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
