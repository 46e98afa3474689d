// Loads and gravity: the momentum that they give over time, also to bodies that break, and the work that they do.
#include "helpers.h"
#include "run/checkpoint.h"

using namespace hinge;
using namespace hinge::test;

namespace {

constexpr double dt = 1e-5;

DynamicSettings steps_of(int steps, bool in_explicit_steps) {
    DynamicSettings s;
    s.dt = dt;
    s.duration = steps * dt;
    s.beta = in_explicit_steps ? 0 : 0.25;
    return s;
}

std::shared_ptr<const Structure> structure_of(const Frame& frame, bool in_explicit_steps) {
    return std::make_shared<const Structure>(frame.model, in_explicit_steps ? MassKind::lumped : MassKind::consistent);
}

/// Three members that fall freely, with loads on their common node and on one of their far ends. In step 20 the
/// script's own rule breaks one element at one end.
struct Falling {
    static constexpr int steps = 200, breaks_in = 20;
    Frame frame;
    int hub = frame.node(0, 0, 0), tip = frame.node(1, 0, 0);
    Vec3 gravity{1, -2, -9.80665}, on_hub{300, -200, 100}, of_rule{-50, 400, 80}, on_tip{20, 30, -60};

    Falling(int element, int end) {
        frame.member(hub, tip);
        frame.member(hub, frame.node(0, 1.2, 0.1));
        frame.member(hub, frame.node(-0.2, 0, 0.9));
        set_gravity(*frame.model, gravity);
        frame.load(hub, 0.25 * on_hub);
        frame.load(hub, 0.75 * on_hub, Vec3::Zero(), [](double) { return 1.0; });
        NodalLoad follows;
        follows.node = hub;
        follows.force_rule = [this](double) { return of_rule; };
        add_load(*frame.model, follows);
        frame.load(tip, on_tip);
        FractureRule rule;
        rule.where = FractureRule::Where::all;
        rule.hook = [element, end](const SectionView& s) {
            return s.element == element && s.end == end && s.step == breaks_in;
        };
        add_fracture(*frame.model, rule);
    }
    Falling(const Falling&) = delete;
    /// kg m/s after that many steps. `tip_lost`: from the break on the far end is no node.
    Vec3 momentum_after(long done, double mass, bool tip_lost) const {
        const double with_tip = double(tip_lost ? std::min<long>(done, breaks_in) : done);
        return dt * (double(done) * (mass * gravity + on_hub + of_rule) + with_tip * on_tip);
    }
};

}  // namespace

TEST_CASE("loads: gravity and loads go on acting on a node where an element breaks, across a checkpoint too",
          "[loads]") {
    for (const bool in_explicit_steps : {false, true})
        for (const int element : {0, 1, 3})  // at the loaded hub, at the loaded far end, beside the hub
            for (const int end : {1, 2}) {
                INFO("element " << element << ", end " << end << (in_explicit_steps ? ", explicit" : ""));
                const Falling scene(element, end);
                const auto structure = structure_of(scene.frame, in_explicit_steps);
                const DynamicSettings settings = steps_of(Falling::steps, in_explicit_steps);
                Dynamics run(structure, initial_state(*structure), settings);
                const double mass = momentum(*structure, run.state()).mass;
                const bool tip_lost = element == 1 && end == 2;
                const auto hold = [&](const Dynamics& at, long steps) {
                    const Vec3 wanted = scene.momentum_after(steps, mass, tip_lost);
                    const Momentum now = momentum(*structure, at.state());
                    CHECK_FIGURE("mass", off(now.mass, mass), 1e-12);
                    CHECK_FIGURE("momentum", (now.linear - wanted).norm() / wanted.norm(), 1e-8);
                    CHECK_FIGURE("energy balance error", std::abs(at.energy().error / at.energy()["work"]), 1e-3);
                };
                std::string saved;
                while (run.advance())
                    if (run.steps_done() == Falling::steps / 2) {
                        REQUIRE(run.state().broken[element] == end);
                        hold(run, run.steps_done());
                        saved = checkpoint_of(run);
                    }
                REQUIRE(run.verdict() == Verdict::completed);
                CHECK(run.breaks() == 1);
                CHECK((run.state().gone[scene.tip] != 0) == tip_lost);
                hold(run, Falling::steps);

                Dynamics resumed(structure, initial_state(*structure), settings);
                resume(resumed, open_checkpoint(saved, "file"), "file");
                while (resumed.advance()) {}
                hold(resumed, Falling::steps);
                CHECK(hash(resumed.state()) == hash(run.state()));
                CHECK(resumed.energy()["work"] == run.energy()["work"]);

                Dynamics on(structure, run.state(), settings);  // begins with what is broken already
                while (on.advance()) {}
                const Vec3 wanted = scene.momentum_after(2 * Falling::steps, mass, tip_lost);
                CHECK_FIGURE("momentum of a run that begins broken",
                             (momentum(*structure, on.state()).linear - wanted).norm() / wanted.norm(), 1e-8);
            }
}

TEST_CASE("loads: a force and a moment that rise with time give the momentum of their integral", "[loads]") {
    // The trapezium rule has the integral of c t exactly; a load that came one step late would be off by 2 / steps.
    const int steps = 200;
    const double end = steps * dt, c = 1e6;
    const Vec3 force(1, -2, 0.5), moment(0.3, 0, 0);  // N/s and N m/s over c; the moment about the bar's own axis
    for (const int scheme : {0, 1, 2}) {
        INFO((scheme == 0 ? "Newmark, acceleration held" : scheme == 1 ? "Newmark, displacement held" : "explicit"));
        Frame frame;
        const int a = frame.node(-0.5, 0, 0), b = frame.node(0.5, 0, 0);
        frame.member(a, b);
        for (const int n : {a, b}) frame.load(n, 0.5 * force, 0.5 * moment, [c](double t) { return c * t; });
        const auto structure = structure_of(frame, scheme == 2);
        DynamicSettings settings = steps_of(steps, scheme == 2);
        settings.predictor = scheme == 1 ? Predictor::displacement : Predictor::acceleration;
        settings.solver.tolerance = 1e-12;
        Dynamics run(structure, initial_state(*structure), settings);
        while (run.advance()) {}
        REQUIRE(run.verdict() == Verdict::completed);
        const Momentum now = momentum(*structure, run.state());
        const Vec3 impulse = 0.5 * c * end * end * force, turn = 0.5 * c * end * end * moment;
        CHECK_FIGURE("momentum", (now.linear - impulse).norm() / impulse.norm(), 1e-8);
        CHECK_FIGURE("angular momentum about the axis", off(now.angular.x(), turn.x()), 1e-6);
        // the middle of mass: c t^3 / 6 m, by steps to dt^2 of it; a step late 3 / steps
        Vec3 middle = Vec3::Zero();
        for (const Element& e : structure->elements())
            for (const int side : {0, 1})
                middle += e.inertia.weight(side) / now.mass * run.state().displacement[e.node[side]];
        const Vec3 way = c * std::pow(end, 3) / (6 * now.mass) * force;
        CHECK_FIGURE("way of the middle of mass", (middle - way).norm() / way.norm(), 2.0 / (steps * steps));
    }
}

TEST_CASE("loads: functions of the state act from where a run begins", "[loads]") {
    // The trapezium rule has the integral of F + c t exactly. A load that sets in with the end of the first step would
    // be off by F dt / 2; a run that begins anew in the middle, by as much again.
    const int steps = 100;
    const Vec3 force(300, -200, 500), moment(40, 0, 0);  // N, N m about the bar's own axis
    for (const int scheme : {0, 1, 2, 3}) {
        INFO((scheme == 0   ? "Newmark, acceleration held"
              : scheme == 1 ? "Newmark, displacement held"
              : scheme == 2 ? "explicit"
                            : "dissipative"));
        Frame frame;
        const int ends[] = {frame.node(-0.5, 0, 0), frame.node(0.5, 0, 0)};
        frame.member(ends[0], ends[1]);
        std::vector<double> asked;
        for (const int n : ends) {
            NodalLoad load;
            load.node = n;
            load.force_rule = [&, n](double t) {
                if (n == ends[0]) asked.push_back(t);
                return Vec3(0.5 * (1 + 1e3 * t) * force);
            };
            load.moment_rule = [&](double t) { return Vec3(0.5 * (1 + 1e3 * t) * moment); };
            add_load(*frame.model, load);
        }
        const auto structure = structure_of(frame, scheme == 2);
        DynamicSettings settings = steps_of(steps, scheme == 2);
        if (scheme == 3) settings.rho_infinity = 0.5, settings.beta = DynamicSettings::beta_of(0.5);
        settings.predictor = scheme == 1 ? Predictor::displacement : Predictor::acceleration;
        settings.solver.tolerance = 1e-12;
        Dynamics run(structure, initial_state(*structure), settings);
        while (run.advance()) {}
        REQUIRE(run.verdict() == Verdict::completed);
        REQUIRE(asked.size() == steps + 1);
        for (int i = 0; i <= steps; ++i) CHECK_FIGURE("asked at", std::abs(asked[i] - i * dt), 1e-12);
        const double end = steps * dt, first = end + 500 * end * end;
        const auto hold = [&](const Dynamics& at, double integral) {
            const Momentum now = momentum(*structure, at.state());
            // Bossak's weighting delays what acts by alpha dt: it is off by that part of what has changed
            const double within = scheme == 3 ? 1e-4 : 1e-8;
            CHECK_FIGURE("momentum", (now.linear - integral * force).norm() / (integral * force.norm()), within);
            CHECK_FIGURE("angular momentum about the axis", off(now.angular.x(), integral * moment.x()),
                         scheme == 3 ? within : 1e-5);
            CHECK_FIGURE("energy balance error", std::abs(at.energy().error / at.energy()["work"]),
                         scheme == 2 ? 1e-4 : 1e-5);
        };
        hold(run, first);
        Dynamics on(structure, run.state(), settings);
        while (on.advance()) {}
        hold(on, 2 * end + 500 * 4 * end * end);
    }
}

TEST_CASE("loads: weight along a clamped member has the moments of w L^2/12 and w L^2/24, with both masses",
          "[loads]") {
    for (const MassShape mass : {MassShape::linear, MassShape::cubic})
        for (const int elements : {2, 4}) {
            INFO(elements << " elements, mass " << int(mass));
            ModelOptions options = small_displacement();
            options.mass = mass;
            Frame frame(options);
            frame.elements = elements;
            frame.member(frame.foot(0, 0, 0), frame.foot(1, 0, 0));
            set_gravity(*frame.model, {0, 0, -9.80665});
            const auto run = statics(frame.build());
            const Element& e = run->structure().elements()[0];
            const double wL2 = e.rigidity.rhoA * 9.80665;
            const auto at = [&](int k, double side) {
                const SectionForces f = run->section_forces(k, side);
                return std::hypot(f.Mx, f.My);
            };
            CHECK_FIGURE("moment at the end", off(at(0, -1), wL2 / 12), 1e-9);
            CHECK_FIGURE("moment in the middle", off(at(elements / 2 - 1, 1), wL2 / 24), 1e-9);
            CHECK_FIGURE("moment behind the middle", off(at(elements / 2, -1), wL2 / 24), 1e-9);
            if (elements == 4) CHECK_FIGURE("moment at a quarter", off(at(0, 1), wL2 / 96), 1e-9);
        }
}

TEST_CASE("loads: in statics an elastic member takes half of force times way, and so does gravity", "[loads]") {
    const Vec3 force(40, -30, -500), moment(20, 5, -9);
    for (const int steps : {1, 7})
        for (const bool by_displacement : {false, true}) {
            INFO(steps << " steps" << (by_displacement ? ", displacement control" : ""));
            Frame frame(small_displacement());
            const int foot = frame.foot(0, 0, 0), tip = frame.node(1, 0, 0);
            frame.member(foot, tip);
            frame.load(tip, force, moment);
            const auto structure = frame.build();
            StaticSettings settings;
            settings.steps = steps;
            if (by_displacement) settings = driven(tip, 2, -1e-3, steps);
            const auto run = statics(structure, settings);
            REQUIRE(run->verdict() == Verdict::completed);
            const Vec6 u = run->displacement(tip);
            const double half = 0.5 * run->state().factor * (force.dot(u.head<3>()) + moment.dot(u.tail<3>()));
            REQUIRE(half > 0);
            CHECK_FIGURE("work against F u / 2", off(run->energy()["work"], half), 1e-9);
            CHECK_FIGURE("strain energy against F u / 2", off(run->energy()["elastic"], half), 1e-9);
        }
    {  // gravity let on slowly: what was not there yet was held back, which took half of the way's weight
        ModelOptions options = small_displacement();
        options.weight = Weight::nodes;
        Frame frame(options);
        frame.member(frame.foot(0, 0, 0), frame.node(1, 0, 0));
        set_gravity(*frame.model, {0, 0, -9.80665});
        const auto structure = frame.build();
        const auto run = statics(structure);
        double fall = 0;  // weight times way, of each element's halves
        for (const Element& e : structure->elements())
            for (const int n : e.node) fall -= 0.5 * e.rigidity.rhoA * e.length * 9.80665 * run->displacement(n)[2];
        REQUIRE(fall > 0);
        CHECK_FIGURE("potential energy of the weight", off(run->energy()["gravity"], -fall), 1e-9);
        CHECK_FIGURE("work of what held the weight back", off(run->energy()["work"], -0.5 * fall), 1e-9);
        CHECK_FIGURE("strain energy under its weight", off(run->energy()["elastic"], 0.5 * fall), 1e-9);
    }
    {  // large displacement: the load's path is not straight, the sum of many small steps is what is stored
        Frame frame;
        const int tip = frame.node(1, 0, 0);
        frame.member(frame.foot(0, 0, 0), tip);
        frame.load(tip, {0, 0, -6e4});
        StaticSettings settings;
        settings.steps = 50;
        const auto run = statics(frame.build(), settings);
        REQUIRE(run->verdict() == Verdict::completed);
        CHECK(run->displacement(tip)[2] < -0.1);
        CHECK_FIGURE("work of a large displacement", off(run->energy()["work"], run->energy()["elastic"]), 1e-3);
    }
}
