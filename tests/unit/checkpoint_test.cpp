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
    explicit Crash(bool in_explicit_steps) {
        Frame frame;
        add_contact(*frame.model, surface(0.2));
        add_fracture(*frame.model, bent_by(0.3));
        set_gravity(*frame.model, {0, 0, -9.80665});
        frame.material = steel(245e6);
        falling_on(frame, true, 0.08, 90, 0.1, 0, 60);
        structure =
            std::make_shared<const Structure>(frame.model, in_explicit_steps ? MassKind::lumped : MassKind::consistent);
        settings = {.dt = in_explicit_steps ? 1e-5 : 2e-5, .duration = 0.02, .beta = in_explicit_steps ? 0 : 0.25};
    }
    Dynamics start(int threads = 1) const {
        DynamicSettings own = settings;
        own.threads = threads;
        return dynamics(structure, own);
    }
};

std::string saved(const Dynamics& run) {
    std::string bytes;
    run.save(bytes);
    return bytes;
}

}  // namespace

TEST_CASE("checkpoint: contents that are not valid are refused, and the run is as it was") {
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

TEST_CASE("checkpoint: a state with a number that is not finite is refused") {
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

TEST_CASE("checkpoint: a node that is gone does not move, and what is held has no way to") {
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
