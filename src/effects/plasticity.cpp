// Plastic hinges at the end of a step: what flowed becomes part of the state (eqs 4, 6 and 10; state/hinges.h). The
// return to the yield surface is in the assembly, the tangents of what flows in run/yield_tangents.h.
#include <algorithm>
#include <cmath>
#include <set>

#include "core/text.h"
#include "effects/axial_strength.h"
#include "effects/kinds.h"
#include "effects/shear_strength.h"
#include "state/hinge_records.h"
#include "state/hinges.h"

namespace hinge {
namespace {

/// Part of the largest axial force of a structure that half of the load along a slack element may be.
constexpr double least_missed = 0.05;

/// The inertia of a slack element along itself, over the half of the load along it that is told to be missing.
constexpr double most_inertia = 0.1;

/// The sense in which an element carries axial force alone, if that is one: 1 tension, -1 compression; else 0.
int one_sense(const Structure& structure, int element) {
    switch (structure.model().members()[std::size_t(structure.elements()[std::size_t(element)].member)].carries) {
        case Carries::tension: return 1;
        case Carries::compression: return -1;
        default: return 0;
    }
}

/// N, of an element's mass at the larger one of its ends' accelerations along it; 0 in statics.
double inertia_along(const Workspace& w, int element) {
    if (!w.kind.dynamic) return 0;
    const Element& e = w.structure.elements()[std::size_t(element)];
    const auto place = [&](int end) -> Vec3 {
        return w.structure.position()[e.node[end]] + w.state.displacement[e.node[end]];
    };
    const Vec3 axis = (place(1) - place(0)).normalized();
    double most = 0;
    for (int node : e.node) most = std::max(most, std::abs(axis.dot(w.state.acceleration[node].head<3>())));
    return e.mass() * most;
}

/// A slack element has no axial force in its middle, but its nodes take half each of a load along it. The half at the
/// slack end presses on the node there, in the place of hanging from the other end: N of the part that carries is too
/// small by that. In dynamics where it does not move along itself: else its inertia carries a part of the load.
void warn_of_slack_ends(const Workspace& w, std::vector<RunWarning>& list) {
    double largest = 0, most = 0;
    int worst = -1;
    for (int e = 0; e < int(w.state.force.size()); ++e) {
        if (w.state.broken[e]) continue;
        const double N = w.state.force[e][4];
        const beam::FixedEnd& loads = w.assembly.fixed_end(e);
        largest = std::max({largest, std::abs(N + loads.N[0]), std::abs(N + loads.N[1])});
        const int sense = N == 0 ? one_sense(w.structure, e) : 0;
        const double missed = sense == 0 ? 0 : -std::min(sense * loads.N[0], sense * loads.N[1]);
        if (missed > (1 + 1e-9) * most && !(inertia_along(w, e) > most_inertia * missed)) most = missed, worst = e;
    }
    if (worst < 0 || !(most > least_missed * largest)) return;
    const int member = w.structure.elements()[std::size_t(worst)].member,
              elements = w.structure.model().members()[std::size_t(member)].elements,
              enough = 2 * int(std::ceil(0.5 * elements * most / (least_missed * largest)));
    const char* sense = one_sense(w.structure, worst) > 0 ? "tension" : "compression";
    list.push_back({"member " + std::to_string(member + 1) + " carries " + sense +
                        " alone, and where it is slack half of the load along an element, " + number_text(most, 3) +
                        " N, presses on its node, in the place of hanging from the part that carries: N there and the "
                        "reaction at its end are too small by that",
                    "elements = " + std::to_string(enough) + " for that member make it " +
                        number_text(most * elements / enough, 2) + " N",
                    member});
}

class Plasticity : public Effect, public StepLimiter, public Sleeper, public RunChecker {
public:
    Plasticity(Workspace& w, Host& host)
        : Effect("plasticity", w, host, {.mean_forces = true, .calls_script = w.structure.laws_call_script()}),
          strength_(w.structure),
          shear_(w.structure) {
        for (std::size_t i = 0; i < w.state.hinge.size(); ++i)
            if (w.state.hinge[i]) flowing_.push_back(int(i));
        if (!w.state.data.find<HingeRecords>(hinge_records)) w.state.data.set(hinge_records, HingeRecords{});
        for (HingeRecord& h : records().list) ++h.runs_ago;
    }

    void accumulate_energy(const Step&, Accounts& sums) const override {
        double& plastic = sums["plastic"];
        for (const PlasticIncrement& y : w_.yielding) plastic += y.flow.dissipation;
    }

    void after_commit(const Step& step) override {
        keep_flow(step);
        strength_.look(w_, step);
        shear_.look(w_, step);
        shear_.weaken(w_, step, w_.state);
    }
    void check_run(std::vector<RunWarning>& list) const override {
        strength_.check_run(w_, list);
        shear_.check_run(w_, list);
        warn_of_slack_ends(w_, list);
    }

    bool allows_long_step() const override { return w_.yielding.empty(); }
    bool busy() const override { return !w_.yielding.empty(); }
    std::string why_awake() const override {
        return std::to_string(w_.yielding.size()) +
               (w_.yielding.size() == 1 ? " element flows: " : " elements flow: ") +
               w_.structure.element_name(w_.yielding[0].element);
    }

    void save(Writer& to) const override { to(flowing_, strength_, shear_); }
    void restore(Reader& from) override { from(flowing_, strength_, shear_); }
    bool restored(std::span<const State* const>) override {
        const int n = int(w_.structure.elements().size());
        if (!records().makes_sense(n)) return false;
        return std::all_of(flowing_.begin(), flowing_.end(), [n](int e) { return e >= 0 && e < n; }) &&
               strength_.fits(w_.structure) && shear_.fits(w_.structure);
    }

    void returned_to_yield(const Step& start) override {
        accumulate_energy(start, w_.state.accumulated);
        keep_flow(start);
    }

private:
    void keep_flow(const Step& step) {
        if (!w_.yielding.empty())
            record_flow(w_.structure, w_.yielding, w_.reached(step), w_.goes_by_load_factor(), records());
        for (int e : commit_flow(w_.structure, w_.state, w_.yielding, w_.assembly.step(), flowing_)) {
            w_.points_moved = true;
            host_.stiffness_changed(e);
        }
    }
    HingeRecords& records() { return *w_.state.data.find<HingeRecords>(hinge_records); }

    std::vector<int> flowing_;  ///< elements that flowed in the last step
    AxialStrength strength_;
    ShearStrength shear_;
};

/// The laws of sections that are not eq 14 alone.
std::string laws_text(const Structure& s) {
    std::set<std::string> laws;
    bool others = false;
    for (const Element& e : s.elements())
        if (e.law) laws.insert(e.law->words()), others |= !e.law->ignores_shape() || !e.law->keeps_strength();
    std::string text;
    for (const std::string& law : laws) text += (text.empty() ? "; law of sections: " : "; ") + law;
    return others ? text : "";
}

std::vector<PlanLine> plasticity_plan(const Structure& s, const RunKind&) {
    const auto& elements = s.elements();
    const bool could =
        std::any_of(elements.begin(), elements.end(), [](const Element& e) { return !e.yield.elastic(); });
    const char* yields = could ? "a material has a yield stress" : "members carry tension or compression alone";
    return {{"plasticity", s.can_yield(),
             s.can_yield() ? yields + laws_text(s)
             : could       ? "plasticity = false"
                           : "no section can yield",
             s.model().asked_at("plasticity")}};
}

}  // namespace

EffectKind plasticity_kind() {
    return {.name = "plasticity",
            .accounts = {{"plastic", 40, "dissipated in plastic hinges", {}, true}},
            .plan = plasticity_plan,
            .make = [](Workspace& w, Host& host) -> std::unique_ptr<Effect> {
                const auto& hinges = w.state.hinge;
                const bool flowed = std::any_of(hinges.begin(), hinges.end(), [](int h) { return h != 0; });
                if (!w.structure.can_yield() && !flowed) return nullptr;
                return std::make_unique<Plasticity>(w, host);
            },
            .leave_out =
                [](Model& model) {
                    ModelOptions options = model.options();
                    options.plasticity = false;
                    model.set_options(options);
                },
            .stages = {"yield"}};
}

}  // namespace hinge
