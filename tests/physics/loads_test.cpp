// Loads and gravity: the momentum that they give over time, also to bodies that break, and the work that they do.
#include "helpers.h"
#include "run/checkpoint.h"

using namespace hinge;
using namespace hinge::test;

namespace {

constexpr double dt = 1e-5;
constexpr const char* schemes[] = {"Newmark, acceleration held", "Newmark, displacement held", "explicit",
                                   "dissipative"};

DynamicSettings steps_of(int steps, bool in_explicit_steps) {
    return {.dt = dt, .duration = steps * dt, .beta = in_explicit_steps ? 0 : 0.25};
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
        add_load(*frame.model, {.node = hub, .force_rule = [this](double) { return of_rule; }});
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

TEST_CASE("loads: gravity and loads go on acting on a node where an element breaks, across a checkpoint too") {
    for (const bool in_explicit_steps : {false, true})
        for (const int element : {0, 1, 3})  // at the loaded hub, at the loaded far end, beside the hub
            for (const int end : {1, 2}) {
                INFO("element " << element << ", end " << end << (in_explicit_steps ? ", explicit" : ""));
                const Falling scene(element, end);
                const auto structure = structure_of(scene.frame, in_explicit_steps);
                const DynamicSettings settings = steps_of(Falling::steps, in_explicit_steps);
                Dynamics run = dynamics(structure, settings);
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

                Dynamics resumed = dynamics(structure, settings);
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

TEST_CASE("loads: histories and functions of the state act from where a run begins, and give their integral") {
    // The trapezium rule has the integral of F + c t exactly. A load that sets in with the end of the first step would
    // be off by F dt / 2; a run that begins anew in the middle, by as much again; one that is a step late, by F dt.
    const int steps = 100;
    const double end = steps * dt, rise = 1e3;
    const Vec3 force(300, -200, 500), moment(40, 0, 0);  // N, N m about the bar's own axis
    const auto grown = [&](double t) { return 0.5 * (1 + rise * t); };
    for (const int scheme : {0, 1, 2, 3})
        for (const bool rules : {false, true}) {
            INFO(schemes[scheme] << (rules ? ", functions of the state" : ", histories"));
            Frame frame;
            const int ends[] = {frame.node(-0.5, 0, 0), frame.node(0.5, 0, 0)};
            frame.member(ends[0], ends[1]);
            std::vector<double> asked;
            for (const int n : ends) {
                NodalLoad load{n, force, moment, grown};
                if (rules) {
                    load = {n};
                    load.force_rule = [&, n](double t) {
                        if (n == ends[0]) asked.push_back(t);
                        return Vec3(grown(t) * force);
                    };
                    load.moment_rule = [&](double t) { return Vec3(grown(t) * moment); };
                }
                add_load(*frame.model, load);
            }
            const auto structure = structure_of(frame, scheme == 2);
            DynamicSettings settings = steps_of(steps, scheme == 2);
            if (scheme == 3) settings.rho_infinity = 0.5, settings.beta = DynamicSettings::beta_of(0.5);
            settings.predictor = scheme == 1 ? Predictor::displacement : Predictor::acceleration;
            settings.solver.tolerance = 1e-12;
            Dynamics run = dynamics(structure, settings);
            complete(run);
            REQUIRE(asked.size() == (rules ? steps + 1 : 0));
            for (std::size_t i = 0; i < asked.size(); ++i)
                CHECK_FIGURE("asked at", std::abs(asked[i] - double(i) * dt), 1e-12);
            const auto hold = [&](const Dynamics& at, double t) {
                const Momentum now = momentum(*structure, at.state());
                const double integral = t + rise / 2 * t * t;
                // Bossak's weighting delays what acts by alpha dt: it is off by that part of what has changed
                const double within = scheme == 3 ? 1e-4 : 1e-8;
                CHECK_FIGURE("momentum", (now.linear - integral * force).norm() / (integral * force.norm()), within);
                CHECK_FIGURE("angular momentum about the axis", off(now.angular.x(), integral * moment.x()),
                             scheme == 3 ? within : 1e-5);
                CHECK_FIGURE("energy balance error", std::abs(at.energy().error / at.energy()["work"]),
                             scheme == 2 ? 1e-4 : 1e-5);
            };
            hold(run, end);
            // the middle of mass, by steps to dt^2 of its way; a step late 3 / steps
            Vec3 middle = Vec3::Zero();
            const double mass = momentum(*structure, run.state()).mass;
            for (const Element& e : structure->elements())
                for (const int side : {0, 1})
                    middle += e.inertia.weight(side) / mass * run.state().displacement[e.node[side]];
            const Vec3 way = (end * end / 2 + rise * std::pow(end, 3) / 6) / mass * force;
            CHECK_FIGURE("way of the middle of mass", (middle - way).norm() / way.norm(),
                         scheme == 3 ? 1e-3 : 2.0 / (steps * steps));
            Dynamics on(structure, run.state(), settings);
            while (on.advance()) {}
            hold(on, 2 * end);
        }
}

TEST_CASE("loads: in statics an elastic member takes half of force times way") {
    const Vec3 force(40, -30, -500), moment(20, 5, -9);
    for (const int steps : {1, 7})
        for (const bool by_displacement : {false, true}) {
            INFO(steps << " steps" << (by_displacement ? ", displacement control" : ""));
            Frame frame(small_displacement());
            const int foot = frame.foot(0, 0, 0), tip = frame.node(1, 0, 0);
            frame.member(foot, tip);
            frame.load(tip, force, moment);
            const auto run =
                statics(frame.build(), by_displacement ? driven(tip, 2, -1e-3, steps) : StaticSettings{.steps = steps});
            REQUIRE(run->verdict() == Verdict::completed);
            const Vec6 u = run->displacement(tip);
            const double half = 0.5 * run->state().factor * (force.dot(u.head<3>()) + moment.dot(u.tail<3>()));
            REQUIRE(half > 0);
            CHECK_FIGURE("work against F u / 2", off(run->energy()["work"], half), 1e-9);
            CHECK_FIGURE("strain energy against F u / 2", off(run->energy()["elastic"], half), 1e-9);
        }

    {  // large displacement: the load's path is not straight, the sum of many small steps is what is stored
        Frame frame;
        const int tip = frame.node(1, 0, 0);
        frame.member(frame.foot(0, 0, 0), tip);
        frame.load(tip, {0, 0, -6e4});
        const auto run = statics(frame.build(), {.steps = 50});
        REQUIRE(run->verdict() == Verdict::completed);
        CHECK(run->displacement(tip)[2] < -0.1);
        CHECK_FIGURE("work of a large displacement", off(run->energy()["work"], run->energy()["elastic"]), 1e-3);
    }
}
