// Plastic hinges at the end of a step: what flowed becomes part of the state (eqs 4, 6 and 10; state/hinges.h). The
// return to the yield surface is in the assembly, the tangents of what flows in run/yield_tangents.h.
#include <algorithm>
#include <cmath>
#include <set>

#include "core/text.h"
#include "effects/kinds.h"
#include "effects/shear_strength.h"
#include "state/hinge_records.h"
#include "state/hinges.h"

namespace hinge {
namespace {

class Plasticity : public Effect, public StepLimiter, public Sleeper {
public:
    Plasticity(Workspace& w, Host& host)
        : Effect("plasticity", w, host, {.mean_forces = true, .calls_script = w.structure.laws_call_script()}),
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
        shear_.weaken(w_, step, w_.state);
    }

    bool allows_long_step() const override { return w_.yielding.empty(); }
    bool busy() const override { return !w_.yielding.empty(); }
    std::string why_awake() const override {
        return std::to_string(w_.yielding.size()) +
               (w_.yielding.size() == 1 ? " element flows: " : " elements flow: ") +
               w_.structure.element_name(w_.yielding[0].element);
    }

    void save(Writer& to) const override { to(flowing_); }
    void restore(Reader& from) override { from(flowing_); }
    bool restored(std::span<const State* const>) override {
        const int n = int(w_.structure.elements().size());
        if (!records().makes_sense(n)) return false;
        return std::all_of(flowing_.begin(), flowing_.end(), [n](int e) { return e >= 0 && e < n; });
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
    const ShearStrength shear_;
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
