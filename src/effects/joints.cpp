// Joints of member ends, and between two nodes at one place: pins, semi-rigid and partial-strength joints, panel zones,
// and joints that break.
//
// An end with a joint has a node of its own (Structure::end_node) in the place of the script's. Constraints tie its
// displacement to that of the script's node. A moment resists its rotation relative to that node, about the axes of the
// section, which rotate with the node. The curve of an axis is a sum of springs, each in series with a slider: their
// stiffnesses are the differences of the slopes. So unloading is elastic, a cycle follows Masing's rule, and each step
// dissipates energy or none. Tension may take strength from the sliders; it is that where the step begins. It follows
// the force of the member with the delay of an axial wave: a moment that falls changes that force at once, and without
// a delay the two would swing from step to step, however short the steps.
//
// Damping by stiffness (model:damping) gives each spring of finite stiffness a dashpot that takes the rate of the
// spring alone: the slip of its slider is free. In a step that turns the joint by D and moves the slider by P that is
// k beta ((D - P) / dt + x (rate - D / dt)), x = (D - P) / D between 0 and 1: of second order, as in elastic_rate.h.
// The moment of the dashpots is beside that of the joint. Neither strength nor capacity limits it.
#include "effects/joints.h"

#include <algorithm>
#include <cmath>

#include "core/text.h"
#include "effects/all_effects.h"
#include "effects/constrainer.h"
#include "effects/facts.h"
#include "effects/joint_ties.h"
#include "effects/kinds.h"
#include "model/member_ends.h"
#include "state/joint_records.h"
#include "state/node_mass.h"

namespace hinge {
namespace {

/// Stiffness of a joint that slides, as a part of its elastic one: in the tangent alone.
constexpr double of_sliding = 1e-9;

/// Part of its capacity that another joint has when one breaks, for the order to be in doubt: tension and shear of
/// joints in explicit and in Newmark's steps differ by some per cent of their peaks.
constexpr double close_part = 0.9;

/// Stiffness that a node of the script keeps to the end of one of its members where the ends of all of them are
/// released: in the tangent alone, as a part of that member's own. The node rotates with that end, without a moment.
constexpr double of_riding = 1e-6;

const char* const axis_names[] = {"Mx", "My", "Mz"};

class Joints : public Effect,
               public Force,
               public Constrainer,
               public BreakListener,
               public StepLimiter,
               public JointBreaks {
public:
    Joints(Workspace& w, Host& host)
        : Effect(joints_effect, w, host), joints_(configured_joints(w)), ties_(w, joints_) {
        if (!w.state.data.find<JointStates>(joints_effect)) w.state.data.set(joints_effect, JointStates{});
        if (!w.state.data.find<JointRecords>(joint_records)) w.state.data.set(joint_records, JointRecords{});
        records().one_run_later();
        records().list.resize(declared().size());
        list().resize(declared().size());
        end_forces_.resize(declared().size());
        turned_.resize(declared().size());
        for (std::size_t i = 0; i < joints_.size(); ++i) {
            for (int k = 0; k < 3; ++k) list()[i].slid[k].resize(joints_[i].parts[k].size(), 0.0);
            traits_.forces_vanish = traits_.forces_vanish || declared()[i].is.can_break();
        }
        for (std::size_t i = 0; i < joints_.size(); ++i) go_on(i);
        ties_.refuse_moments(joints_);
    }

    // ---- forces ---------------------------------------------------------------------------------------------------
    void begin_statics() override {
        for (JointState& j : list()) j.viscous.setZero(), j.elastic.setOnes();
    }
    void add_forces(double time, std::vector<Vec6>& resisting) override {
        for (std::size_t i = 0; i < joints_.size(); ++i) {
            if (list()[i].broken) continue;
            const ConfiguredJoint& m = joints_[i];
            end_forces_[i].resisted = resisting[m.end].head<3>();
            const RelativeRotation r = turn(i, w_.trial);
            const JointMoments e = evaluate(i, r.rotation);
            Vec3 moment = e.moment;
            if (m.damping > 0) moment += end_forces_[i].viscous = viscous(i, r, e, time == w_.state.time).moment;
            const Vec3 in_space = r.by_spin().transpose() * moment;
            resisting[m.node].tail<3>() -= in_space;
            resisting[m.end].tail<3>() += in_space;
        }
    }
    bool has_blocks() const override {
        return std::any_of(list().begin(), list().end(), [](const JointState& j) { return !j.broken; });
    }
    bool blocks_follow() const override {
        if (w_.structure.large()) return has_blocks();
        for (std::size_t i = 0; i < joints_.size(); ++i)
            if (!list()[i].broken && !declared()[i].is.is_linear()) return true;
        return false;
    }
    void add_blocks(const Pose& at, Blocks& blocks) const override {
        blocks.pairs.reserve(blocks.pairs.size() + joints_.size());
        for (std::size_t i = 0; i < joints_.size(); ++i) {
            if (list()[i].broken) continue;
            const RelativeRotation r = turn(i, at);
            const JointMoments e = evaluate(i, r.rotation);
            // a joint that slides leaves a mechanism: without any stiffness what solves for it would divide by rounding
            Vec3 slope = slope_of(joints_[i], r.rotation, list()[i], e, blocks.yielded)
                             .cwiseMax(of_sliding * joints_[i].stiffness);
            if (ties_.carries_node(joints_[i], i)) slope = slope.cwiseMax(of_riding * joints_[i].own);
            ViscousMoments v;
            if (joints_[i].damping > 0) v = viscous(i, r, e, false), slope += v.by_rotation;
            add_joint_blocks(joints_[i], r, slope, v.by_rate,
                             w_.structure.large() && w_.kind.geometric ? e.moment : Vec3(Vec3::Zero()), blocks);
        }
    }
    void add_stiffest(Blocks& most) const override {
        for (std::size_t i = 0; i < joints_.size(); ++i)
            if (!list()[i].broken)
                add_joint_blocks(joints_[i], turn(i, w_.state), joints_[i].stiffness,
                                 joints_[i].damping * joints_[i].damped, Vec3::Zero(), most);
    }

    // ---- constraints ----------------------------------------------------------------------------------------------
    void add_constraints(const Pose& at, std::vector<LinearConstraint>& list_of_all) const override {
        ties_.add_constraints(at, list_of_all);
    }
    bool factors_vary() const override { return ties_.have_arms(); }
    void place(const Pose&, const std::vector<Vec3>&, Configuration& to) const override { ties_.place(to); }
    void set_velocities(Configuration& of) const override { ties_.set_velocities(of); }
    void set_accelerations(Configuration& of) const override { ties_.set_accelerations(of); }
    void add_curvature(const Pose& at, const std::vector<Vec6>& unbalanced, Blocks& blocks) const override {
        ties_.add_curvature(at, unbalanced, blocks);
    }

    // ---- a step ---------------------------------------------------------------------------------------------------
    void accumulate_energy(const Step&, Accounts& sums) const override {
        double work = 0;
        for (std::size_t i = 0; i < joints_.size(); ++i) {
            if (list()[i].broken) continue;
            work += dissipated_in_step(i);
            if (joints_[i].damping == 0) continue;
            const Vec3 turned = turn(i, w_.trial).rotation - list()[i].rotation;
            sums["damping"] += 0.5 * (list()[i].viscous + viscous_at_end(i).moment).dot(turned);
        }
        sums["joint_dissipated"] += work;
    }
    void acceleration_found() override {
        for (std::size_t i = 0; i < joints_.size(); ++i) list()[i].viscous = end_forces_[i].viscous;
    }
    void before_commit(const Step& step) override {
        int first = -1;  // of those that break in the step
        for (std::size_t i = 0; i < joints_.size(); ++i) {
            if (list()[i].broken) continue;
            keep(i, step);
            if (list()[i].over < 0 || !w_.kind.dynamic) continue;
            release(i, step.end());
            ties_.leave_node(joints_[i].node);
            if (first < 0) first = int(i);
        }
        if (first < 0) return;
        note_close_call(std::size_t(first), step.end());
        host_.constraints_changed();
        changed(w_.trial);
    }
    /// A node whose last element has broken holds nothing any more. The run finds its constraints anew after that.
    void broke(const Break&) override {
        for (const JointTie& t : ties_)
            if (t.is_rigid() && (ties_.has_lost_all(t.node) || ties_.has_lost_all(t.end)))
                ties_.leave_node(t.node), lost_any_ = true;
        for (std::size_t i = 0; i < joints_.size(); ++i) {
            if (list()[i].broken || !(ties_.has_lost_all(joints_[i].node) || ties_.has_lost_all(joints_[i].end)))
                continue;
            release(i, w_.state.time);
            ties_.leave_node(joints_[i].node);
            lost_any_ = true;
        }
    }
    void all_broke() override {
        if (lost_any_) changed(w_.state);
        lost_any_ = false;
    }
    bool allows_long_step() const override {
        for (std::size_t i = 0; i < joints_.size(); ++i)
            if (!list()[i].broken && (!declared()[i].is.is_linear() || declared()[i].is.can_break())) return false;
        return true;
    }
    void keep_from_rest(const Bodies& bodies, std::vector<char>& rests) const override {
        ties_.for_each_whole([&](const JointTie& t) {
            for (const int n : {t.node, t.end})
                if (bodies.of_node[n] >= 0) rests[bodies.of_node[n]] = 0;
        });
    }

    // ---- energy, facts for advice and checkpoint -------------------------------------------------------------------
    void add_energy(const State& state, Accounts& sums) const override { sums["joint_stored"] += stored(state); }
    Close close_breaks() const override {
        if (close_.times == 0) return {};
        return {close_.times, name_of(close_.broke), name_of(close_.other), joints_[close_.broke].member, close_.part,
                close_.time};
    }
    std::vector<Beyond> beyond_capacity() const override {
        std::vector<Beyond> beyond;
        for (std::size_t i = 0; i < joints_.size(); ++i)
            if (list()[i].over >= 0) beyond.push_back({name_of(i), reached_by(i), joints_[i].member});
        return beyond;
    }
    bool restored(std::span<const State* const> states) override {
        if (close_.times < 0) return false;
        if (close_.times > 0 && (close_.broke >= joints_.size() || close_.other >= joints_.size())) return false;
        return std::all_of(states.begin(), states.end(), [&](const State* s) {
            const auto* there = s->data.find<JointStates>(joints_effect);
            const auto* records = s->data.find<JointRecords>(joint_records);
            if (!there || there->list.size() != joints_.size()) return false;
            if (!records || records->list.size() != joints_.size()) return false;
            for (std::size_t i = 0; i < joints_.size(); ++i)
                for (int k = 0; k < 3; ++k)
                    if (there->list[i].slid[k].size() != joints_[i].parts[k].size()) return false;
            return true;
        });
    }

    void save(Writer& to) const override { to(close_); }
    void restore(Reader& from) override { from(close_); }

private:
    /// Forces of the member's end at the last evaluation, with the loads on it.
    struct EndForces {
        Vec3 resisted = Vec3::Zero();  ///< N, in space
        Vec3 viscous = Vec3::Zero();   ///< N m: the moment of damping
    };
    const std::vector<Joint>& declared() const { return declared_; }
    const std::vector<Joint>& declared_ = w_.structure.model().declared<Joint>(joints_effect);
    std::vector<JointState>& list() const { return w_.state.data.find<JointStates>(joints_effect)->list; }
    JointRecords& records() const { return *w_.state.data.find<JointRecords>(joint_records); }

    /// A run that goes on from one with another stiffness of rigid axes begins with the moments of that one.
    void go_on(std::size_t i) {
        for (int k = 0; k < 3; ++k)
            if (!std::isfinite(declared()[i].is.axis[k].stiffness))
                list()[i].offset[k] = list()[i].rotation[k] - list()[i].moment[k] / joints_[i].stiffness[k];
    }

    RelativeRotation turn(std::size_t i, const Pose& at) const {
        const ConfiguredJoint& m = joints_[i];
        return turned_[i].at(w_.structure, at, m.node, m.end, m.axes, list()[i].rotation);
    }
    JointMoments evaluate(std::size_t i, const Vec3& rotation) const {
        return hinge::evaluate(joints_[i], rotation, list()[i]);
    }
    ViscousMoments viscous(std::size_t i, const RelativeRotation& r, const JointMoments& e, bool begins) const {
        const ConfiguredJoint& m = joints_[i];
        const Vec3 rate = r.by_spin() * (w_.velocity(w_.trial, m.end) - w_.velocity(w_.trial, m.node)).tail<3>();
        return viscous_moments(m, list()[i], r.rotation, rate, w_.assembly.step(), e, begins);
    }
    /// Where the trial has ended; explicit steps took it at the predicted velocity.
    ViscousMoments viscous_at_end(std::size_t i) const {
        const RelativeRotation r = turn(i, w_.trial);
        ViscousMoments v = viscous(i, r, evaluate(i, r.rotation), false);
        if (w_.kind.explicit_steps) v.moment = end_forces_[i].viscous;
        return v;
    }

    /// Where tension has weakened the joint, the step began with the moment that it had before: half of what that lost
    /// does work with the step's rotation.
    double dissipated_in_step(std::size_t i) const {
        const JointState& j = list()[i];
        const Vec3 end = turn(i, w_.trial).rotation;
        double work = evaluate(i, end).dissipated;
        if (declared()[i].is.tension_weakens)
            work += 0.5 * (j.moment - evaluate(i, j.rotation).moment).dot(end - j.rotation);
        return work;
    }

    /// The largest part of a capacity that the joint has at the end of the step.
    double used(std::size_t i) const {
        const JointProperties& is = declared()[i].is;
        double most = std::max(list()[i].tension / is.tension, list()[i].shear / is.shear);
        for (int k = 0; k < 3; ++k) most = std::max(most, std::abs(list()[i].rotation[k]) / is.axis[k].capacity);
        return most;
    }
    /// Called when one has broken: another one that does not break in the same step, but nearly does?
    void note_close_call(std::size_t broke, double time) {
        for (std::size_t k = 0; k < joints_.size(); ++k) {
            if (list()[k].broken || !declared()[k].is.can_break()) continue;
            const double part = used(k);
            if (!(part >= close_part && part < 1)) continue;
            if (close_.times++ == 0) close_.broke = broke, close_.other = k, close_.part = part, close_.time = time;
            return;
        }
    }

    /// Takes what the step has led to, and sees whether it reaches a capacity.
    void keep(std::size_t i, const Step& step) {
        const ConfiguredJoint& m = joints_[i];
        const JointProperties& is = declared()[i].is;
        JointState& j = list()[i];
        if (m.damping > 0) {
            const ViscousMoments v = viscous_at_end(i);
            j.viscous = v.moment, j.elastic = v.elastic;
        }
        j.rotation = turn(i, w_.trial).rotation;
        JointMoments e = evaluate(i, j.rotation);
        for (int k = 0; k < 3; ++k) {
            if (m.parts[k].empty()) continue;
            note_slip(i, k, e.slid[k] != j.slid[k], e.work[k], step);
            j.slid[k] = std::move(e.slid[k]);
        }
        j.moment = e.moment;
        const Mat3 turned = w_.structure.large() ? Mat3(w_.trial.rotation[m.end].toRotationMatrix() * m.axes) : m.axes;
        const Vec3 f =
            turned.transpose() * (end_forces_[i].resisted - w_.load(m.end).head<3>() + inertia_of_end(m.end));
        j.tension = m.side == 0 ? -f.z() : f.z();
        j.shear = f.head<2>().norm();
        if (is.tension_weakens) {
            const double part = w_.kind.dynamic && step.dt < m.wave ? step.dt / m.wave : 1;
            j.pull += part * (j.tension - j.pull);
            weaken(i, std::clamp(1 - j.pull / is.tension, 0.0, 1.0), step);
        }
        add_step(records().list[i], is, j);
        j.over = capacity_reached(is, j);
    }

    /// The force of a member's end has the inertia of what moves with its node. R of implicit steps has it already.
    Vec3 inertia_of_end(int end) const {
        if (!w_.kind.explicit_steps) return Vec3::Zero();
        return lumped_mass_at(w_.structure, w_.state, end).mass * w_.trial.acceleration[end].head<3>();
    }

    /// Sliders that hold less from the next step on slip at once: what their springs lose is dissipated.
    void weaken(std::size_t index, double left, const Step& step) {
        const ConfiguredJoint& m = joints_[index];
        JointState& j = list()[index];
        j.left = left;
        for (int k : {0, 1})
            for (std::size_t i = 0; i < m.parts[k].size(); ++i) {
                const auto& [stiffness, strength] = m.parts[k][i];
                if (stiffness == 0) continue;
                const double has = stiffness * (j.rotation[k] - j.slid[k][i]), most = left * strength;
                if (std::abs(has) <= most) continue;
                j.slid[k][i] = j.rotation[k] - std::copysign(most, has) / stiffness;
                const double lost = 0.5 * (has * has - most * most) / stiffness;
                w_.state.accumulated["joint_dissipated"] += lost;
                note_slip(index, k, true, lost, step);
            }
    }

    void note_slip(std::size_t i, int k, bool slips, double work, const Step& step) {
        JointRecord::Axis& axis = records().list[i].axis[k];
        axis.work += work;
        if (!slips || axis.yielded) return;
        axis.yielded = true, axis.statics = w_.goes_by_load_factor(), axis.runs_ago = 0;
        axis.first = w_.kind.dynamic ? step.end() : w_.factor;  // the state has the factor before
    }

    double stored(const State& state) const {
        const auto* there = state.data.find<JointStates>(joints_effect);
        double energy = 0;
        for (std::size_t i = 0; there && i < there->list.size(); ++i) {
            const JointState& j = there->list[i];
            if (j.broken) continue;
            const ConfiguredJoint& m = joints_[i];
            const Vec3 turned = relative_rotation(w_.structure, state, m.node, m.end, m.axes, j.rotation).rotation;
            energy += hinge::evaluate(m, turned, j).stored;
        }
        return energy;
    }

    std::string name_of(std::size_t i) const {
        if (declared()[i].is_between_nodes())
            return "the joint between nodes " + std::to_string(joints_[i].node + 1) + " and " +
                   std::to_string(joints_[i].end + 1);
        return "the joint at end " + std::string(joints_[i].side == 0 ? "a" : "b") + " of member " +
               std::to_string(joints_[i].member + 1);
    }
    std::string reached_by(std::size_t i) const {
        const JointState& j = list()[i];
        char text[80] = "its node has lost its last member";
        if (j.over >= 0 && j.over < 3)
            std::snprintf(text, sizeof text, "rotation of %.4g rad about the axis of %s", j.rotation[j.over],
                          axis_names[j.over]);
        if (j.over == 3) std::snprintf(text, sizeof text, "tension of %.4g N", j.tension);
        if (j.over == 4) std::snprintf(text, sizeof text, "shear force of %.4g N", j.shear);
        return text;
    }
    void release(std::size_t i, double time) {
        JointState& j = list()[i];
        w_.state.accumulated["joint_dissipated"] += evaluate(i, j.rotation).stored;
        j.broken = true;
        j.broken_at = time;
        host_.note_activation(joints_effect, false, name_of(i) + " broke: " + reached_by(i));
    }
    void changed(const Pose& at) {
        host_.accelerations_anew();
        host_.blocks_changed(at);
    }

    std::vector<ConfiguredJoint> joints_;
    JointTies ties_;
    std::vector<EndForces> end_forces_;
    mutable std::vector<LastRotation> turned_;
    bool lost_any_ = false;
    /// The first break at which another joint was close to its own, and how many there were.
    struct FirstClose {
        long times = 0;
        std::size_t broke = 0, other = 0;
        double part = 0, time = 0;
        template <class Self, class A>
        static void fields(Self& s, A& a) {
            a(s.times, s.broke, s.other, s.part, s.time);
        }
    } close_;
};

std::vector<PlanLine> joints_plan(const Structure& s, const RunKind&) {
    const std::size_t n = s.model().declared<Joint>(joints_effect).size(),
                      offsets = s.model().declared<MemberOffset>(member_offsets).size();
    std::string text = n == 0 ? "" : count_text(long(n), "joint");
    if (offsets > 0) text += (n == 0 ? "" : ", ") + count_text(long(offsets), "offset end");
    return {
        {joints_effect, n + offsets > 0, n + offsets == 0 ? "not declared" : text, s.model().asked_at(joints_effect)}};
}

}  // namespace

EffectKind joints_kind() {
    return {
        .name = joints_effect,
        .accounts = {{"joints", 73, "stored in joints now, and dissipated by them", {}, false, true},
                     {"joint_stored", 73, "stored now in the springs of joints", "joints"},
                     {"joint_dissipated", 74, "plastic work of joints, and what their breaks released", "joints"}},
        .plan = joints_plan,
        .make = [](Workspace& w, Host& host) -> std::unique_ptr<Effect> {
            const Model& model = w.structure.model();
            if (model.declared<Joint>(joints_effect).empty() && model.declared<MemberOffset>(member_offsets).empty()) {
                w.state.data.erase(joints_effect);
                w.state.data.erase(joint_records);
                return nullptr;
            }
            return std::make_unique<Joints>(w, host);
        },
        .declarer = {.links = [](const Model& model) {
            std::vector<NodeLink> list;
            for (const Joint& j : model.declared<Joint>(joints_effect))
                if (j.is_between_nodes()) list.push_back({j.from, j.to});
            return list;
        }}};
}

}  // namespace hinge
