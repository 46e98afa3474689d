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
        ModelOptions options = small_displacement(Formulation::conventional);
        Frame frame(options);
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
        DynamicSettings s;
        s.dt = part_of_limit * limit;
        s.duration = 600 * s.dt;
        s.beta = in_explicit_steps ? 0 : 1.0 / 6;
        s.iterations = 1;
        s.energy_tolerance = tolerance;
        return Dynamics(structure, initial_state(*structure), s);
    }
};

}  // namespace

TEST_CASE("guard: a run that gains energy fails, and goes back to where its balance closed", "[guard]") {
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
        while (stable.advance()) {}
        INFO(stable.reason());
        CHECK(stable.verdict() == Verdict::completed);
    }
}
