// Members that are removed at a time (model:remove): their elements break as by a fracture rule, whatever their
// strains.
#include "effects/removal.h"

#include <algorithm>

#include "core/text.h"
#include "effects/kinds.h"

namespace hinge {
namespace {

const std::vector<Removal>& declared(const Structure& s) { return s.model().declared<Removal>(removal_effect); }

bool is_of(const Structure& s, const Removal& r, int element) {
    return r.group >= 0 ? s.in_group(element, r.group) : s.elements()[std::size_t(element)].member == r.member;
}

class Removals : public Effect, public Breaker, public StepLimiter {
public:
    Removals(Workspace& w, Host& host)
        : Effect(removal_effect, w, host, {.forces_vanish = true}), done_(declared(w.structure).size(), 0) {}
    const char* decides() const override { return removal_effect; }

    void decide(Step& step) override {
        for (std::size_t i = 0; i < done_.size(); ++i) {
            if (done_[i] || !is_due(i, step)) continue;
            for (int e = 0; e < int(w_.structure.elements().size()); ++e)
                if (!w_.state.broken[std::size_t(e)] && is_of(w_.structure, declared(w_.structure)[i], e))
                    take_out(step, e);
        }
        std::sort(step.breaks.begin(), step.breaks.end(),
                  [](const Break& a, const Break& b) { return a.element < b.element; });
    }
    /// A run that goes on from a checkpoint looks once more at what was due before, and finds it broken.
    void after_commit(const Step& step) override {
        for (std::size_t i = 0; i < done_.size(); ++i) done_[i] = done_[i] || is_due(i, step);
    }

    bool changes_within(double now, std::span<const double> after) const override {
        return std::any_of(declared(w_.structure).begin(), declared(w_.structure).end(), [&](const Removal& r) {
            return r.at > now && !after.empty() && r.at <= now + after.back();
        });
    }

private:
    bool is_due(std::size_t i, const Step& step) const {
        return step.end() >= declared(w_.structure)[i].at - 1e-6 * step.dt;  // times are sums of steps
    }
    /// The two halves of a member stay with its ends: an element breaks at its end nearer to the middle.
    void take_out(Step& step, int e) const {
        const auto& elements = w_.structure.elements();
        const auto same = [&](std::size_t i) {
            return i < elements.size() && elements[i].member == elements[std::size_t(e)].member;
        };
        long before = 0, after = 0;
        while (e - before > 0 && same(std::size_t(e - before - 1))) ++before;
        while (same(std::size_t(e + after + 1))) ++after;
        const Break b = {e, before <= after ? 2 : 1, {}};
        const auto known = std::find_if(step.breaks.begin(), step.breaks.end(),
                                        [&](const Break& other) { return other.element == e; });
        if (known == step.breaks.end()) step.breaks.push_back(b);
        else *known = b;
    }

    std::vector<char> done_;  ///< of each removal
};

bool is_removed(const Model& model, int member) {
    const auto& groups = model.members()[member].groups;
    const auto& list = model.declared<Removal>(removal_effect);
    return std::any_of(list.begin(), list.end(), [&](const Removal& r) {
        return r.group < 0 ? r.member == member : std::find(groups.begin(), groups.end(), r.group) != groups.end();
    });
}

std::vector<PlanLine> removal_plan(const Structure& s, const RunKind&) {
    const auto& list = declared(s);
    std::string text = list.empty() ? "not declared" : "model:remove";
    for (const Removal& r : list) {
        const auto& members = s.model().members();
        long n = r.group < 0 ? 1 : 0;
        for (const MemberData& m : members)
            n += r.group >= 0 && std::find(m.groups.begin(), m.groups.end(), r.group) != m.groups.end();
        text += (&r == &list[0] ? "; " : ", ") + count_text(n, "member") + " at " + number_text(r.at) + " s";
    }
    return {{removal_effect, !list.empty(), text, s.model().asked_at(removal_effect)}};
}

}  // namespace

EffectKind removal_kind() {
    return {.name = removal_effect,
            .plan = removal_plan,
            .make = [](Workspace& w, Host& host) -> std::unique_ptr<Effect> {
                if (!built::fracture || declared(w.structure).empty()) return nullptr;
                return std::make_unique<Removals>(w, host);
            },
            .dynamic_only = true,
            .leave_out = leave_out_declared<removal_effect>,
            .may_break = [](const Model& model, int member) { return built::fracture && is_removed(model, member); },
            .stages = {removal_effect}};
}

}  // namespace hinge
