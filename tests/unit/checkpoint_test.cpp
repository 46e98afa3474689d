// Checkpoints as bytes: written and read by one list of fields, total against whatever stands in them.
#include "core/archive.h"
#include "core/errors.h"
#include "helpers.h"
#include "run/checkpoint.h"
#include "algebra/mass_matrix.h"

using namespace hinge;
using namespace hinge::test;

namespace {

/// A bar flies into a clamped one that yields and breaks; explicit, or by the operator.
struct Crash {
    std::shared_ptr<const Structure> structure;
    DynamicSettings settings;
    explicit Crash(bool in_explicit_steps, double speed = 60) {
        Frame frame;
        ContactRule rule;
        rule.settings.rule = contact::ContactRuleKind::surface;
        rule.settings.friction = 0.2;
        add_contact(*frame.model, rule);
        FractureRule limits;
        limits.curvature_x = limits.curvature_y = 0.3;
        add_fracture(*frame.model, limits);
        set_gravity(*frame.model, {0, 0, -9.80665});
        frame.material = steel(245e6);
        const int a1 = frame.node(-0.5, 0, 0), a2 = frame.node(0.5, 0, 0), b1 = frame.node(0.1, -0.5, 0.08),
                  b2 = frame.node(0.1, 0.5, 0.08);
        for (int a : {a1, a2}) frame.model->fix(a, 63);
        frame.member(a1, a2);
        frame.member(b1, b2);
        for (int b : {b1, b2}) frame.model->set_velocity(b, {0, 0, -speed}, Vec3::Zero());
        structure =
            std::make_shared<const Structure>(frame.model, in_explicit_steps ? MassKind::lumped : MassKind::consistent);
        settings.dt = in_explicit_steps ? 1e-5 : 2e-5;
        settings.duration = 0.02;
        settings.beta = in_explicit_steps ? 0 : 0.25;
    }
    Dynamics start(int threads = 1) const {
        DynamicSettings own = settings;
        own.threads = threads;
        return Dynamics(structure, initial_state(*structure), own);
    }
};

std::string saved(const Dynamics& run) {
    std::string bytes;
    run.save(bytes);
    return bytes;
}

}  // namespace

TEST_CASE("checkpoint: goes on with the same bits at every step of a crash", "[checkpoint]") {
    for (bool in_explicit_steps : {false, true}) {
        const Crash crash(in_explicit_steps);
        Dynamics whole = crash.start(), taken = crash.start();
        while (whole.advance()) {}
        REQUIRE(whole.verdict() == Verdict::completed);
        REQUIRE(whole.count_members(-1).broken > 0);
        long resumed = 0;
        while (taken.advance()) {
            if (taken.steps_done() % 97) continue;
            Dynamics other = crash.start(1 + resumed++ % 2);
            const std::string bytes = checkpoint_of(taken, "beside");
            const Checkpoint found = open_checkpoint(bytes, "file");
            CHECK(found.step == taken.steps_done());
            CHECK(found.beside == "beside");
            resume(other, found, "file");
            CHECK(saved(other).size() == saved(taken).size());
            while (other.advance()) {}
            CHECK(hash(other.state()) == hash(whole.state()));
            CHECK(other.energy().error == whole.energy().error);
        }
        CHECK(resumed > 9);
        CHECK(hash(taken.state()) == hash(whole.state()));
    }
}

TEST_CASE("checkpoint: contents that are not valid are refused, and the run is as it was", "[checkpoint]") {
    for (bool in_explicit_steps : {false, true}) {
        const Crash crash(in_explicit_steps);
        Dynamics run = crash.start();
        while (run.advance() && (run.count_members(-1).broken == 0 || contact_of(run.state())->idle())) {}
        REQUIRE(run.verdict() == Verdict::running);
        const std::string good = saved(run);
        Dynamics other = crash.start();
        const std::string fresh = saved(other);
        long refused = 0, taken = 0;
        const auto attempt = [&](std::string_view bytes) {
            try {
                other.restore(bytes);
                ++taken;  // a number among others
                return true;
            } catch (const Damaged&) {
                ++refused;
                return false;
            }
        };
        for (std::size_t length = 0; length < good.size(); length += 1 + length % 7)
            REQUIRE_FALSE(attempt(std::string_view(good).substr(0, length)));
        CHECK((saved(other) == fresh));
        for (std::size_t i = 0; i < good.size(); ++i)
            for (int change : {0x01, 0x80, 0xff}) {
                std::string bytes = good;
                bytes[i] = char(bytes[i] ^ change);
                if (attempt(bytes)) other.restore(fresh);
                else if (refused % 50 == 0) REQUIRE((saved(other) == fresh));
            }
        CHECK(refused > 1000);
        CHECK(taken > 1000);
        other.restore(good);
        while (run.advance()) {}
        while (other.advance()) {}
        CHECK(run.verdict() == Verdict::completed);
        CHECK(hash(other.state()) == hash(run.state()));
    }
}

TEST_CASE("checkpoint: a state with a number that is not finite is refused", "[checkpoint]") {
    const Crash crash(false);
    Dynamics run = crash.start();
    const std::string good = saved(run);
    for (double number : {infinite, -infinite, std::nan("")}) {
        std::string bytes = good;
        std::memcpy(&bytes[8], &number, sizeof number);  // behind their count, the first displacement
        CHECK_THROWS_AS(run.restore(bytes), Damaged);
        CHECK((saved(run) == good));
    }
}

TEST_CASE("checkpoint: a node that is gone does not move, and what is held has no way to", "[checkpoint]") {
    const Crash crash(true);
    Dynamics run = crash.start();
    while (run.advance() && std::none_of(run.state().gone.begin(), run.state().gone.end(), [](char g) { return g; })) {}
    REQUIRE(run.verdict() == Verdict::running);
    State state = run.state();
    const auto gone = std::size_t(std::find(state.gone.begin(), state.gone.end(), 1) - state.gone.begin());
    REQUIRE(makes_sense(state, *crash.structure));
    for (Vec6* of : {&state.velocity[gone], &state.acceleration[gone]}) {
        (*of)[4] = 1e-9;
        CHECK_FALSE(makes_sense(state, *crash.structure));
        (*of)[4] = 0;
    }
    state.held[gone] = 62;
    CHECK_FALSE(makes_sense(state, *crash.structure));

    const auto bytes_of = [](const std::vector<Vec6>& list) {
        return std::string(reinterpret_cast<const char*>(list.data()), list.size() * sizeof(Vec6));
    };
    const std::string good = saved(run), inverse = bytes_of(Mass(*crash.structure, run.state()).lumped_inverse());
    const auto at = good.find(inverse);
    REQUIRE(at != std::string::npos);
    for (const std::size_t held : {std::size_t(0), gone}) {
        std::string bytes = good;
        const double loose = 0.1;
        std::memcpy(&bytes[at + held * sizeof(Vec6)], &loose, sizeof loose);
        CHECK_THROWS_AS(run.restore(bytes), Damaged);
        CHECK((saved(run) == good));
    }
}

TEST_CASE("checkpoint: one of another model or other settings is told by its parts", "[checkpoint]") {
    const Crash crash(false), faster(false, 61);
    const std::string bytes = checkpoint_of(crash.start());
    const Checkpoint found = open_checkpoint(bytes, "file");
    Dynamics other = faster.start();
    const std::string before = saved(other);
    CHECK_THROWS_WITH(resume(other, found, "file"), Catch::Contains("is of another run, which differs in velocities;"));
    CHECK((saved(other) == before));
    Crash longer(false);
    longer.settings.duration = 0.03;
    longer.settings.rebuild_angle = 0.02;
    Dynamics third = longer.start();
    CHECK_THROWS_WITH(resume(third, found, "file"),
                      Catch::Contains("which differs in duration and settings of the run;"));
    CHECK_THROWS_AS(open_checkpoint(bytes.substr(0, 30), "file"), OutsideError);
    CHECK_THROWS_AS(open_checkpoint("", "file"), OutsideError);
}
