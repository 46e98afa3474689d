// Members that are removed at a time (model:remove): their elements break as by a fracture rule, whatever their
// strains. Where they leave over a time, the forces that they had stand in for them and fall to nothing.
#include "effects/removal.h"

#include <algorithm>

#include "core/text.h"
#include "effects/kinds.h"
#include "state/configuration.h"

namespace hinge {
namespace {

const std::vector<Removal>& declared(const Structure& s) { return s.model().declared<Removal>(removal_effect); }

bool is_of(const Structure& s, const Removal& r, int element) {
    return r.group >= 0 ? s.in_group(element, r.group) : s.elements()[std::size_t(element)].member == r.member;
}

/// Force of a removed element on a node: part of R. It falls to nothing in a straight line.
struct StandIn {
    int node;
    Vec6 force = Vec6::Zero();  ///< N, N m
    double from = 0, over = 1;  ///< s

    double part_at(double time) const { return std::clamp(1 - (time - from) / over, 0.0, 1.0); }
    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.node, s.force, s.from, s.over);
    }
};

/// Those of members that have gone: a run that goes on from the state has them too.
struct StandIns {
    static constexpr bool in_state_hash = false;  ///< the hash of a state is that of its arrays
    std::vector<StandIn> list;
    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.list);
    }
};

class Removals : public Effect, public Breaker, public StepLimiter, public Force {
public:
    Removals(Workspace& w, Host& host)
        : Effect(removal_effect, w, host, {.forces_vanish = true}), done_(declared(w.structure).size(), 0) {
        if (!w.state.data.find<StandIns>(removal_effect)) w.state.data.set(removal_effect, StandIns{});
    }
    const char* stage_name() const override { return removal_effect; }

    void find_breaks(Step& step) override {
        next_.clear();
        time_ = step.end() + 1e-6 * step.dt;
        for (std::size_t i = 0; i < done_.size(); ++i) {
            if (done_[i] || !is_due(i, step)) continue;
            const Removal& removal = declared(w_.structure)[i];
            for (int e = 0; e < int(w_.structure.elements().size()); ++e)
                if (!w_.state.broken[std::size_t(e)] && is_of(w_.structure, removal, e)) {
                    take_out(step, e);
                    if (removal.over > 0) stand_in(e, step.end(), removal.over);
                }
        }
        std::sort(step.breaks.begin(), step.breaks.end(),
                  [](const Break& a, const Break& b) { return a.element < b.element; });
    }
    /// A run that goes on from a checkpoint checks again what was due before, and finds it broken.
    void after_commit(const Step& step) override {
        for (std::size_t i = 0; i < done_.size(); ++i) done_[i] = done_[i] || is_due(i, step);
        std::erase_if(standing(), [&](const StandIn& s) { return s.part_at(step.end()) == 0; });
        standing().insert(standing().end(), next_.begin(), next_.end());
        next_.clear();
    }

    // ---- forces of members that leave over a time -----------------------------------------------------------------
    void add_forces(double time, std::vector<Vec6>& resisting) override {
        for (const StandIn& s : standing())
            if (!w_.state.gone[s.node]) resisting[s.node] += s.part_at(time) * s.force;
    }
    /// By the trapezium rule.
    void accumulate_energy(const Step& step, Accounts& sums) const override {
        for (const StandIn& s : standing()) {
            if (w_.state.gone[s.node]) continue;
            const Vec6 mean = 0.5 * (s.part_at(step.begin) + s.part_at(step.end())) * s.force;
            sums["work"] -= mean.head<3>().dot(w_.trial.displacement[s.node] - w_.state.displacement[s.node]) +
                            mean.tail<3>().dot(w_.rotation_step[s.node]);
        }
    }
    void keep_from_rest(const Bodies& bodies, std::vector<char>& rests) const override {
        for (const StandIn& s : standing())
            if (bodies.of_node[s.node] >= 0) rests[bodies.of_node[s.node]] = 0;
    }
    bool changes_within(double now, std::span<const double> after) const override {
        if (!standing().empty()) return true;
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

    std::vector<StandIn>& standing() const { return w_.state.data.find<StandIns>(removal_effect)->list; }
    /// At the script's nodes that keep another member. Inside a member, and where all members go, there is none.
    void stand_in(int element, double from, double over) {
        const Structure& s = w_.structure;
        const Element& e = s.elements()[std::size_t(element)];
        const Vec12 forces = nodal_forces(element_frame(s, element, w_.trial), w_.force[std::size_t(element)]);
        for (const int end : {0, 1}) {
            const int node = s.declared_node(e.node[end]);
            const auto stays = [&](int other) { return !w_.state.broken[std::size_t(other)] && !is_going(other); };
            if (node < 0 || std::none_of(s.elements_at(node).begin(), s.elements_at(node).end(), stays)) continue;
            next_.push_back({node, forces.segment<6>(6 * end), from, over});
        }
    }
    /// Whether a removal that is done or due has the element.
    bool is_going(int element) const {
        const auto& list = declared(w_.structure);
        return std::any_of(list.begin(), list.end(),
                           [&](const Removal& r) { return r.at <= time_ && is_of(w_.structure, r, element); });
    }

    std::vector<char> done_;     ///< of each removal
    std::vector<StandIn> next_;  ///< of the step that is being tried
    double time_ = 0;            ///< s, at the end of that step
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
        if (r.over > 0) text += " over " + number_text(r.over) + " s";
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
            .may_break = [](const Model& model, int member) { return built::fracture && is_removed(model, member); }};
}

}  // namespace hinge
