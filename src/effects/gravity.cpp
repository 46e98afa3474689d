// Gravity: the weight of elements and of rigid offset masses, and their potential energy (eq 20b).
//
// The potential energy is counted from where each node is at the start of the run: weight times place in space would
// round by 1e-16 m g z, which is more than a body has that has just been let go at a height z.
//
// Weights act at the nodes. What they miss of a load along the member is added to members that are whole and carried
// (member_weights.h). It has no potential: minus its work is in gravity's account.
#include "effects/gravity.h"

#include <algorithm>
#include <optional>

#include "effects/kinds.h"
#include "effects/member_weights.h"
#include "state/node_mass.h"

namespace hinge {
namespace {

class Gravity : public Effect, public Load, public SectionForceSource, public BreakListener {
public:
    Gravity(Workspace& w, Host& host)
        : Effect(gravity_effect, w, host, {.mean_forces = true}),
          g_(gravity_of(w.structure.model())->acceleration),
          held_(gravity_of(w.structure.model())->held) {
        even_.find(w.structure, w.state, g_);
        start_ = w.state.displacement;
        at_start_ = potential(w.state);
        if (w.structure.model().options().weight == Weight::members) members_ = MemberWeights(w.structure);
        choose_members();
    }

    /// Offset masses resist with their weight themselves (broken_members.cpp), since it rotates with them.
    void add_steady_loads(std::vector<Vec6>& external) const override {
        for_each_weight(w_.structure, w_.state, [&](int node, double mass) { external[node].head<3>() += mass * g_; });
        for (std::size_t n = 0; n < even_.more().size(); ++n) external[n].head<3>() += even_.more()[n] * g_;
    }
    void add_static_loads(const Pose& at, std::vector<Vec6>& external) const override {
        add_corrections(g_, at, external);
    }
    void add_held_loads(const Pose& at, std::vector<Vec6>& external) const override {
        for_each_weight(w_.structure, w_.state,
                        [&](int node, double mass) { external[node].head<3>() += mass * held_; });
        add_corrections(held_, at, external);
    }
    bool follows_nodes() const override { return w_.structure.large() && !members_.joints().empty(); }
    /// The members' moments are next to nothing beside their stiffness.
    bool is_unsymmetric() const override { return follows_nodes() && !w_.state.offset_mass.empty(); }
    bool has_potential() const override { return true; }

    /// A break moves weights between nodes, and in no direction: what that changes in the sum is no energy.
    void breaks(const Break&, std::vector<Vec6>&) override {
        if (!before_breaks_) before_breaks_ = potential(w_.state);
    }
    void broke(const Break& b) override {
        for_each_lost_weight(w_.structure, w_.state, b.element,
                             [&](int node, double mass) { host_.change_steady_load(node, -(mass * g_)); });
    }
    void all_broke() override {
        renew_even_weights();
        if (before_breaks_) at_start_ += potential(w_.state) - *before_breaks_;
        before_breaks_.reset();
        choose_members();
    }

    /// In dynamics the corrections are not part of F: they rotate with the members.
    void subtract_following_loads(std::vector<Vec6>& resisting) override {
        const std::vector<int>& joints = members_.joints();
        if (joints.empty()) return;
        if (w_.structure.large()) members_.find_moments(w_.structure, g_, w_.trial, w_.force, placed_, now_);
        placed_ = false;
        for (std::size_t i = 0; i < joints.size(); ++i)
            if (!w_.rests(joints[i])) resisting[joints[i]].tail<3>() -= now_[i];
    }
    void acceleration_found() override { before_ = now_; }

    bool has_fixed_ends() const override { return !members_.joints().empty(); }
    void add_fixed_ends(const Pose& at, double factor, std::vector<beam::FixedEnd>& all) const override {
        members_.add_fixed_ends(w_.structure, w_.pool, g_at(factor), at, w_.force_of_fixed_ends(), false, all);
        placed_ = true;
    }
    void set_fixed_ends(const Pose& at, double factor, std::vector<beam::FixedEnd>& all) const override {
        members_.add_fixed_ends(w_.structure, w_.pool, g_at(factor), at, w_.force_of_fixed_ends(), true, all);
        placed_ = true;
    }

    /// By the trapezium rule, with the moments that the step was solved with; in statics, as F, with those at its end.
    void accumulate_energy(const Step&, Accounts& sums) const override {
        const std::vector<int>& joints = members_.joints();
        if (joints.empty()) return;
        for (const PlasticIncrement& y : w_.yielding) {
            if (!members_.has(w_.structure.elements()[y.element].member)) continue;
            const auto on_flow = [&](const Vec3& g) {
                return work_on_flow(y,
                                    members_.fixed_end(w_.structure, g, w_.trial, w_.force_of_fixed_ends(), y.element));
            };
            const double whole = on_flow(g_);
            sums["gravity"] -= whole;
            if (const Vec3 g = g_at(w_.factor); g != g_) sums["work"] += on_flow(g) - whole;  // what is not there yet
        }
        std::vector<Vec3> moments = now_;
        if (w_.kind.dynamic)
            for (std::size_t i = 0; i < joints.size(); ++i) moments[i] = 0.5 * (now_[i] + before_[i]);
        else members_.find_moments(w_.structure, g_, w_.trial, w_.force, false, moments);
        double work = 0;
        for (std::size_t i = 0; i < joints.size(); ++i) work += moments[i].dot(w_.rotation_step[joints[i]]);
        sums["gravity"] -= work;
    }
    void before_commit(const Step&) override { before_ = now_; }

    void add_section_forces(int element, double side, SectionForces& forces) const override {
        if (!members_.has(w_.structure.elements()[element].member)) return;
        members_.add_section_forces(w_.structure, w_.state, g_at(w_.acting_factor()), element, side, forces);
    }

    /// Zero where the run starts.
    void add_energy(const State& state, Accounts& sums) const override {
        sums["gravity"] += potential(state) - at_start_;
        // displacements are kept as they are, although the potential needs only how far they are from the start
        for_each_weight(w_.structure, state, [&](int node, double mass) {
            sums[energy_scale] += mass * std::abs(state.displacement[node].dot(g_));
        });
    }

    void save(Writer& to) const override { to(at_start_, start_, before_); }
    void restore(Reader& from) override { from(at_start_, start_, before_); }
    bool restored(std::span<const State* const>) override {
        if (start_.size() != w_.state.displacement.size()) return false;
        even_.find(w_.structure, w_.state, g_);
        std::vector<Vec3> before = std::move(before_);
        choose_members();
        before_ = std::move(before);
        return before_.size() == members_.joints().size();
    }

private:
    void renew_even_weights() {
        if (!w_.structure.lumped()) return;
        const std::vector<double> before = even_.more();
        even_.find(w_.structure, w_.state, g_);
        for (std::size_t n = 0; n < before.size(); ++n)
            if (const double more = even_.more()[n] - before[n]; more != 0) host_.change_steady_load(int(n), more * g_);
    }

    /// In statics all is held, one way or another, and what cannot be carried has its limit load.
    void choose_members() {
        if (members_.count() == 0) return;
        const std::vector<char> carried = carried_members(w_.structure, w_.state, members_, g_);
        std::vector<int> list;
        for (int m = 0; m < members_.count(); ++m)
            if (w_.kind.dynamic ? carried[m] && members_.carries_itself(w_.structure, g_, m)
                                : members_.ends(m).whole(w_.state))
                list.push_back(m);
        members_.choose(w_.structure, list);
        placed_ = false;
        members_.find_moments(w_.structure, g_, w_.state, w_.state.force, false, now_);
        before_ = now_;
    }
    void add_corrections(const Vec3& g, const Pose& at, std::vector<Vec6>& external) const {
        std::vector<Vec3> moments;
        members_.find_moments(w_.structure, g, at, w_.force, false, moments);
        for (std::size_t i = 0; i < moments.size(); ++i) external[members_.joints()[i]].tail<3>() += moments[i];
    }

    /// The gravity that acts at a load factor, 1 in dynamics, where nothing is held.
    Vec3 g_at(double factor) const { return held_ + factor * (g_ - held_); }

    /// Eq 20b. In small displacement an arm S turns by the linear rotation r, as its moment S x g does work on it.
    double potential(const State& state) const {
        const auto moved = [&](std::size_t node) -> Vec3 { return state.displacement[node] - start_[node]; };
        Vec3 moment = Vec3::Zero();  // kg m
        for_each_weight(w_.structure, state, [&](int node, double mass) { moment += mass * moved(node); });
        for (std::size_t n = 0; n < even_.more().size(); ++n) moment += even_.more()[n] * moved(n);
        for (std::size_t i = 0; i < state.offset_mass.size(); ++i) {
            const OffsetMass& h = state.offset_mass[i];
            if (!(h.mass > 0)) continue;
            moment += h.mass * moved(i);
            if (w_.structure.large()) moment += state.rotation[i] * h.moment;
            else moment += h.moment + state.small_rotation[i].cross(h.moment);
        }
        return -moment.dot(g_);
    }

    Vec3 g_, held_;                        ///< m/s^2; of it, what statics holds from the start on
    std::vector<Vec3> start_;              ///< m, displacements at the start
    double at_start_;                      ///< J
    std::optional<double> before_breaks_;  ///< J, while elements break
    EvenWeights even_;
    MemberWeights members_;  ///< none with weight = "nodes"
    /// On its joints: what they were at the end of the last step, and are where forces were asked for last, N m.
    std::vector<Vec3> before_, now_;
    /// The fixed ends have been found where forces are asked for next.
    mutable bool placed_ = false;
};

std::vector<PlanLine> gravity_plan(const Structure& s, const RunKind&) {
    const bool on = gravity_of(s.model()) != nullptr;
    const bool along = s.model().options().weight == Weight::members;
    return {{gravity_effect, on,
             !on     ? "not declared"
             : along ? "model:gravity, along members; weight = \"nodes\" leaves that out"
                     : "model:gravity, at nodes alone",
             s.model().asked_at(gravity_effect)}};
}

}  // namespace

void set_gravity(Model& model, const Vec3& acceleration, int load_case) {
    must_be_finite(acceleration, "gravity", "m/s^2");
    model.change_declared<DeclaredGravity>(gravity_effect) = {{acceleration, load_case}};
}

int DeclaredGravity::choose(std::vector<DeclaredGravity>& list, const std::vector<DeclaredGravity>* before,
                            const ChosenLoads& chosen) {
    if (list.empty() || chosen.held.empty()) return 0;  // none, or a model without load cases
    DeclaredGravity& g = list.back();
    if (before && !before->empty()) {
        const DeclaredGravity& b = before->back();
        g.held = b.held + chosen.choice.reached * (b.acceleration - b.held);
    }
    if (g.load_case < 0) return 0;
    const double factor = chosen.choice.factor[g.load_case];
    if (factor == 0 && g.held.isZero(0)) list.clear();
    else if (factor != 1) g.acceleration *= factor;
    return 0;
}

EffectKind gravity_kind() {
    return {.name = gravity_effect,
            .accounts = {{"gravity", 20, "potential energy, zero at the start of the run", {}, true, true}},
            .plan = gravity_plan,
            .make = [](Workspace& w, Host& host) -> std::unique_ptr<Effect> {
                if (!gravity_of(w.structure.model())) return nullptr;
                return std::make_unique<Gravity>(w, host);
            },
            .leave_out = leave_out_declared<gravity_effect>,
            .declarer = {.gravity = [](const Model& model) -> std::optional<Vec3> {
                if (const DeclaredGravity* g = gravity_of(model)) return g->acceleration;
                return {};
            }}};
}

}  // namespace hinge
