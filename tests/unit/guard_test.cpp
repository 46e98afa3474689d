// The guard on a run whose energy grows out of nothing: steps a little above the limit of stability, explicit and of
// Newmark's method.
#include "helpers.h"

using namespace hinge;
using namespace hinge::test;

namespace {

/// A rod of four elements, held at one end, whose nodes can only move along it. It swings in its first shape, with a
/// trace of its highest, whose frequency is known: omega^2 = 2 (c/h)^2 (1 - cos x) with masses at the nodes and
/// 6 (c/h)^2 (1 - cos x) / (2 + cos x) with the linear mass, x = 7 pi / 8. Central differences are stable to omega dt =
/// 2, Newmark's method with beta = 1/6 to sqrt(12).
struct Swinging {
    std::shared_ptr<const Structure> structure;
    double limit;  ///< s
    explicit Swinging(bool in_explicit_steps) {
        Frame frame(small_displacement(Formulation::conventional));
        frame.elements = 1;
        const double h = 0.25, c = std::sqrt(frame.material->E / frame.material->density);
        const std::vector<int> nodes = straight(frame, Vec3::Zero(), Vec3(4 * h, 0, 0), 4);
        for (const int n : nodes) frame.model->fix(n, n == nodes.front() ? 63 : 62);
        for (int i = 1; i <= 4; ++i)
            frame.model->set_velocity(nodes[i], {std::sin(pi / 8 * i) + 1e-4 * std::sin(7 * pi / 8 * i), 0, 0},
                                      Vec3::Zero());
        structure =
            std::make_shared<const Structure>(frame.model, in_explicit_steps ? MassKind::lumped : MassKind::consistent);
        const double cosine = std::cos(7 * pi / 8);
        limit = in_explicit_steps ? 2 / (c / h * std::sqrt(2 * (1 - cosine)))
                                  : std::sqrt(12.0) / (c / h * std::sqrt(6 * (1 - cosine) / (2 + cosine)));
    }
    Dynamics run(double part_of_limit, bool in_explicit_steps, std::optional<double> tolerance = {}) const {
        const double dt = part_of_limit * limit;
        return dynamics(structure, {.dt = dt,
                                    .duration = 600 * dt,
                                    .beta = in_explicit_steps ? 0 : 1.0 / 6,
                                    .iterations = 1,
                                    .energy_tolerance = tolerance});
    }
};

}  // namespace

TEST_CASE("guard: a run that gains energy fails, and goes back to where its balance closed") {
    for (const bool in_explicit_steps : {true, false}) {
        INFO((in_explicit_steps ? "explicit" : "Newmark, beta 1/6"));
        const Swinging scene(in_explicit_steps);
        Dynamics guarded = scene.run(1.0005, in_explicit_steps);
        const double initial = guarded.energy().initial;
        while (guarded.advance()) {}
        INFO(guarded.reason());
        CHECK(guarded.verdict() == Verdict::failed);
        CHECK(guarded.reason().find("the energy balance no longer closes, its error is -") != std::string::npos);
        const Energy e = guarded.energy();
        CHECK(guarded.steps_done() > 0);
        CHECK_FIGURE("energy where it went back to, over the initial", (e["kinetic"] + e["elastic"]) / initial, 1.12);

        // without the guard the same run gains without bound
        Dynamics unguarded = scene.run(1.0005, in_explicit_steps, 0.0);
        double now = 0;
        while (unguarded.advance() && now < 1e6 * initial) now = unguarded.energy()["kinetic"];
        CHECK(now >= 1e6 * initial);

        // and with shorter steps it is let alone
        Dynamics stable = scene.run(0.5, in_explicit_steps);
        complete(stable);
    }
}

namespace {

const AccountList some_accounts = {{"kinetic", 10, ""},
                                   {"gravity", 20, "", {}, false, true},
                                   {"elastic", 30, ""},
                                   {"plastic", 40, ""},
                                   {"work", 100, ""}};

Energy balance_of(double initial, std::initializer_list<std::pair<const char*, double>> sums) {
    Accounts accounts;
    for (const auto& [name, value] : sums) accounts[name] = value;
    return balance(some_accounts, initial, accounts);
}
double share(LargestEnergy& of, double initial, std::initializer_list<std::pair<const char*, double>> sums) {
    return of.share(balance_of(initial, sums), some_accounts);
}

}  // namespace

TEST_CASE("guard: energy that an error makes is no part of what the error is compared with") {
    const Swinging scene(false);
    LargestEnergy largest(*scene.structure);
    // the largest account while the balance closes, to the bit
    CHECK(share(largest, 1e8, {{"kinetic", 1e8}}) == 0);
    CHECK(largest.most() == 1e8);
    CHECK(share(largest, 1e8, {{"kinetic", 3e8}, {"gravity", -2e8}}) == 0);
    CHECK(largest.most() == 3e8);
    CHECK(share(largest, 1e8, {{"plastic", 4e8}, {"gravity", -2e8}, {"work", 1e8}}) == 0);
    CHECK(largest.most() == 4e8);
    // 7e12 J of strain energy from nowhere
    LargestEnergy other(*scene.structure);
    const double part = share(other, 1.12e8, {{"kinetic", 1e8}, {"gravity", -2e6}, {"elastic", 7e12}, {"work", 1e6}});
    CHECK(other.most() == Approx(1.15e8));
    CHECK(part == Approx(-7e12 / 1.15e8).epsilon(1e-4));
    // what is said to have been given and arrives nowhere
    LargestEnergy given(*scene.structure);
    CHECK(share(given, 1e3, {{"kinetic", 1e3}, {"work", 1e9}}) == Approx(1e6));
    CHECK(given.most() == 1e3);
    // what can only be dissipated, and has come out of there: the balance closes, and that energy was made all the same
    LargestEnergy undone(*scene.structure);
    share(undone, 1e3, {{"kinetic", 9e3}, {"plastic", -8e3}});
    CHECK(undone.most() == 1e3);
}

TEST_CASE("guard: the error at the moment of failure is kept, and a jump between two looks does not pass") {
    const Swinging scene(false);
    State state = initial_state(*scene.structure);
    const double may_grow = EnergyMonitor::may_grow(0.02);
    CHECK(may_grow == Approx(0.01));
    CHECK(EnergyMonitor::may_grow(0.01) == Approx(0.01));
    CHECK(EnergyMonitor::may_grow(0.001) == Approx(0.001));
    for (const double jump : {-0.03e8, -0.3e8}) {  // below the tolerance, and beyond it
        INFO("jump " << jump);
        LargestEnergy largest(*scene.structure);
        EnergyMonitor guard(0.1, 1000);
        state.step = 50, state.time = 0.5;
        const Energy good = balance_of(1e8, {{"kinetic", 1e8 + 0.005e8}});
        REQUIRE(!guard.check(state, good, some_accounts, largest, true, may_grow));
        CHECK(!guard.lost());
        const double before = largest.most();
        state.step = 100, state.time = 1;
        const Energy bad = balance_of(1e8, {{"kinetic", 1e8}, {"elastic", 0.005e8 - jump}});
        const auto why = guard.check(state, bad, some_accounts, largest, true, may_grow);
        REQUIRE(why);
        INFO(text_of(why, *scene.structure));
        CHECK(why.cause == (jump < -0.1e8 ? Cause::energy_error : Cause::energy_error_grown));
        CHECK(why.value == Approx(jump < -0.1e8 ? -0.305 : 0.03));
        CHECK(why.step == 100);
        CHECK(state.step == 50);
        REQUIRE(guard.lost());
        CHECK(guard.lost()->step == 100);
        CHECK(guard.lost()->time == 1);
        CHECK(guard.lost()->share == Approx((jump - 0.005e8) / 1e8));
        CHECK(guard.lost()->went_back);
        CHECK(guard.lost()->good_share == Approx(-0.005));
        CHECK(largest.most() == before);
    }
    // the same error, come slowly, passes
    LargestEnergy largest(*scene.structure);
    EnergyMonitor guard(0.1, 1000);
    for (int i = 1; i <= 9; ++i)
        CHECK(!guard.check(state, balance_of(1e8, {{"kinetic", 1e8 + i * 0.009e8}}), some_accounts, largest, true,
                           may_grow));
}

namespace {

/// Step control by default on steps of 1 s, in a run of 1000 s whose energy is 1e8 J.
struct Controlled {
    static constexpr double all = 1e8;
    Swinging scene{false};
    LargestEnergy largest{*scene.structure};
    StepSize size{1, 1000, false, true, 0};
    StepControl control{1e-3, true};

    /// Whether a step at whose end the balance has that error, J, is kept.
    bool keeps(double error, double before = 0) {
        const Energy energy = balance_of(all, {{"kinetic", all - error}});
        return !control.refuse(energy, some_accounts, largest, size, [&] { return before; });
    }
    void halve() { size.set_length(size.halved(size.length())); }
};

}  // namespace

TEST_CASE("step control by default: looks grow apart while the error does not") {
    Controlled run;
    CHECK(run.control.due(false, run.size));
    for (const int apart : {2, 4, 8, 16, 32, 32}) {
        REQUIRE(run.keeps(10));
        for (int i = 1; i < apart; ++i) {
            CHECK(!run.control.due(false, run.size));
            run.control.skip(run.size);
        }
        CHECK(run.control.due(false, run.size));
    }
    REQUIRE(run.keeps(10));
    CHECK(run.control.due(true, run.size));  // something abrupt
    // what was lost while nobody looked is kept, the last step's own loss is not, and every step is looked at then
    for (int i = 0; i < 10; ++i) run.control.skip(run.size);
    CHECK(!run.keeps(5e5, 1e5));
    CHECK(run.control.due(false, run.size));
    CHECK(run.keeps(1.0001e5, 1e5));
}

TEST_CASE("step control by default: a loss that halving does not make smaller is kept at dt / 64") {
    Controlled at_once;
    REQUIRE(at_once.keeps(0));
    int halved = 0;
    for (; halved < 20 && !at_once.keeps(1e6); ++halved) at_once.halve();  // 1 %
    CHECK(halved == 6);
    CHECK(at_once.size.dt() == Approx(1.0 / 64));
    CHECK(at_once.keeps(1e6));  // it is no later step's
    at_once.size.set_length(at_once.size.own_length());
    CHECK(!at_once.keeps(2e6));  // and allows none to them

    Controlled all_along;  // so much a second however long the step is, after all that may be there was lost
    double error = 2.6e5;
    const double rate = 550;  // J/s: 0.55 % of the energy in the whole run
    REQUIRE(all_along.keeps(0));
    all_along.control.skip(all_along.size);
    REQUIRE(all_along.keeps(error, error));
    for (halved = 0; halved < 20 && !all_along.keeps(error + rate * all_along.size.dt()); ++halved) all_along.halve();
    CHECK(halved == 6);
    error += rate / 64;
    all_along.size.set_length(all_along.size.own_length());
    CHECK(!all_along.keeps(error + 3 * rate));
    CHECK(all_along.keeps(error + rate));  // expected now

    Controlled too_much = all_along;  // what the rest of the run cannot bear is not expected of later steps
    error = 9e5;
    too_much.control.start_from(error);
    CHECK(!too_much.keeps(error + rate));
    while (!too_much.size.fine()) too_much.halve();
    CHECK(!too_much.keeps(1.001e6));  // nor is it kept at dt / 64 beyond 1 % in all
    CHECK(too_much.keeps(0.999e6));
}
