// The elements themselves: inertia, elasticity and large displacement, which every scene has. Their forces are summed
// eight at a time by the assembly (state/element_assembly.h), their stiffness stands in the effective stiffness; here
// are their energies (eqs 20a and 20c) and their lines of the plan.
#include "effects/kinds.h"
#include "state/hinges.h"

namespace hinge {
namespace {

class Elements : public Effect {
public:
    Elements(Workspace& w, Host& host) : Effect("elements", w, host, {.mean_forces = true}) {}

    /// Eqs 20a and 20c with consistent mass and plastic strain, in one pass.
    void add_energy(const State& state, Accounts& sums) const override {
        double elastic = 0, kinetic = 0;
        Vec6 before = Vec6::Zero();
        for (std::size_t i = 0; i < w_.structure.elements().size(); ++i) {
            if (state.broken[i]) continue;
            const ElementFrame placement = element_frame(w_.structure, int(i), state);
            const beam::Stiffness k = stiffness_now(w_.structure, state, int(i));
            const Vec6 d = element_deformation(w_.structure, int(i), state, placement) - state.plastic[i];
            elastic += 0.5 * d.dot(k.times(d));
            if (w_.structure.p_delta()) {
                if (i % 2 == 1 && !state.broken[i - 1])
                    elastic += elastic_pair(w_.structure, state, int(i) - 1, heat_of(state.heat, int(i)))
                                   .energy_beyond(before, d);
                before = d;
            }
            kinetic += kinetic_energy(w_.structure, state, int(i), axes_of(placement));
        }
        sums["elastic"] += elastic;
        sums["kinetic"] += kinetic;
    }
};

std::vector<PlanLine> inertia_plan(const Structure&, const RunKind& run) {
    return {{"inertia", run.dynamic, run.dynamic ? "model:dynamic" : "statics", ""}};
}

std::vector<PlanLine> large_displacement_plan(const Structure& s, const RunKind& run) {
    const bool large = s.large(), stiffens = run.geometric && large;
    PlanLine geometric{"geometric stiffness", stiffens && !run.explicit_steps, "", ""};
    geometric.because = !large             ? "displacement is small"
                        : !stiffens        ? "geometric = false"
                        : geometric.active ? "part of large displacement"
                                           : "explicit steps form no stiffness; the forces have it";
    return {{"large displacement", large,
             !large ? "displacement = \"small\""
             : s.p_delta()
                 ? "the default, with the axial force on the bending of members; p_delta = \"chord\" leaves that out"
                 : "the default; displacement = \"small\" leaves it out",
             large ? "" : s.model().asked_at("model")},
            geometric};
}

}  // namespace

EffectKind inertia_kind() {
    return {
        .name = "inertia",
        .accounts = {{"kinetic", 10, "kinetic energy", {}, true},
                     {"elastic", 30, "strain energy of the elements", {}, true},
                     {"numerical", 90, "taken out by a dissipative integrator", {}, true}},
        .plan = inertia_plan,
        .make = [](Workspace& w, Host& host) -> std::unique_ptr<Effect> { return std::make_unique<Elements>(w, host); },
        .stages = {"predict", "stiffness", "solve", "correct", "accelerate", "step control", "commit"}};
}

EffectKind large_displacement_kind() {
    return {.name = "large displacement",
            .plan = large_displacement_plan,
            .leave_out =
                [](Model& model) {
                    ModelOptions options = model.options();
                    options.displacement = Displacement::small;
                    model.set_options(options);
                },
            .stages = {"recover stresses", "mean forces"}};
}

}  // namespace hinge
