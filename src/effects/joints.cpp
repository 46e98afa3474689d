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
// The moment of the dashpots is beside that of the joint. Neither strength nor capacity is asked of it.
#include "effects/joints.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "core/errors.h"
#include "core/text.h"
#include "effects/all_effects.h"
#include "effects/constrainer.h"
#include "effects/declared.h"
#include "effects/joint_parts.h"
#include "effects/kinds.h"
#include "effects/relative_rotation.h"
#include "model/member_ends.h"
#include "state/joint_records.h"
#include "state/node_mass.h"

namespace hinge {
namespace {

/// Stiffness of a rigid axis over that of its member, 4 EI / L or GJ / L. A cantilever whose end has such an axis is
/// softer by 3 / 4 of its inverse. With more in dynamics, conjugate gradients may not converge (they may be in single
/// precision), and explicit steps would be shorter. Statics has factors, which take more.
constexpr double rigid_part_static = 1e5, rigid_part_implicit = 1e3, rigid_part_explicit = 100;

/// Stiffness of a joint that slides, as a part of its elastic one: in the tangent alone.
constexpr double of_sliding = 1e-9;

/// Part of its strength from which on a joint counts as sliding where it is asked how it goes on (Yielded::goes_on):
/// the residual of an equilibrium, and what it turns back by in dynamics from step to step.
constexpr double at_strength = 1 - 1e-6;

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
               public RunChecker {
public:
    Joints(Workspace& w, Host& host) : Effect(joints_effect, w, host) {
        for (const Joint& j : declared()) made_.push_back(make(j));
        for (const bool between_nodes : {true, false})  // an end may follow a node that follows another one
            for (std::size_t i = 0; i < made_.size(); ++i)
                if (declared()[i].is_between_nodes() == between_nodes) in_order_.push_back(i);
        if (!w.state.data.find<JointsNow>(joints_effect)) w.state.data.set(joints_effect, JointsNow{});
        if (!w.state.data.find<JointRecords>(joint_records)) w.state.data.set(joint_records, JointRecords{});
        records().one_run_later();
        records().list.resize(declared().size());
        list().resize(declared().size());
        now_.resize(declared().size());
        for (std::size_t i = 0; i < made_.size(); ++i) {
            for (int k = 0; k < 3; ++k) list()[i].slid[k].resize(made_[i].parts[k].size(), 0.0);
            traits_.forces_vanish = traits_.forces_vanish || declared()[i].is.can_break();
        }
        for (std::size_t i = 0; i < made_.size(); ++i) go_on(i);
        list_ties();
        refuse_moments();
    }

    // ---- forces ---------------------------------------------------------------------------------------------------
    void begin_statics() override {
        for (JointNow& j : list()) j.viscous.setZero(), j.elastic.setOnes();
    }
    void add_forces(double time, std::vector<Vec6>& resisting) override {
        for (std::size_t i = 0; i < made_.size(); ++i) {
            if (list()[i].broken) continue;
            const Made& m = made_[i];
            now_[i].resisted = resisting[m.end].head<3>();
            const RelativeRotation r = turn(i, w_.trial);
            const Evaluated e = evaluate(i, r.rotation);
            Vec3 moment = e.moment;
            if (m.damping > 0) moment += now_[i].viscous = viscous(i, r, e, time == w_.state.time).moment;
            const Vec3 in_space = r.by_spin().transpose() * moment;
            resisting[m.node].tail<3>() -= in_space;
            resisting[m.end].tail<3>() += in_space;
        }
    }
    bool has_blocks() const override {
        return std::any_of(list().begin(), list().end(), [](const JointNow& j) { return !j.broken; });
    }
    bool blocks_follow() const override {
        if (w_.structure.large()) return has_blocks();
        for (std::size_t i = 0; i < made_.size(); ++i)
            if (!list()[i].broken && !declared()[i].is.is_linear()) return true;
        return false;
    }
    void add_blocks(const Pose& at, Blocks& blocks) const override {
        for (std::size_t i = 0; i < made_.size(); ++i) {
            if (list()[i].broken) continue;
            const RelativeRotation r = turn(i, at);
            const Evaluated e = evaluate(i, r.rotation);
            // a joint that slides leaves a mechanism: without any stiffness what solves for it would divide by rounding
            Vec3 slope = slope_of(i, r.rotation, e, blocks.yielded).cwiseMax(of_sliding * made_[i].stiffness);
            if (carries_node(i)) slope = slope.cwiseMax(of_riding * made_[i].own);
            Viscous v;
            if (made_[i].damping > 0) v = viscous(i, r, e, false), slope += v.by_rotation;
            add(i, r, slope, w_.structure.large() && w_.kind.geometric ? e.moment : Vec3(Vec3::Zero()), blocks,
                v.by_rate);
        }
    }
    void add_stiffest(Blocks& most) const override {
        for (std::size_t i = 0; i < made_.size(); ++i)
            if (!list()[i].broken)
                add(i, turn(i, w_.state), made_[i].stiffness, Vec3::Zero(), most, made_[i].damping * damped(i));
    }

    // ---- constraints ----------------------------------------------------------------------------------------------
    /// u' = u + w x arm of the member's own node, and w' = w where it has no joint. A node that follows another one
    /// passes the end on to that one.
    void add_constraints(const Pose& at, std::vector<LinearConstraint>& list_of_all) const override {
        std::unordered_map<int, std::size_t> follows;
        for (std::size_t i = 0; i < list_of_all.size(); ++i)
            follows[6 * list_of_all[i].dependent.node + list_of_all[i].dependent.component] = i;
        for (const Tie& t : ties_) {
            if (!is_whole(t)) continue;
            const Vec3 arm = arm_of(t, at);
            for (int c = 0; c < (t.is_rigid() ? 6 : 3); ++c) {
                LinearConstraint tie{t.call, {t.end, c}, {}};
                const auto add = [&](int component, double factor) {
                    const auto found = follows.find(6 * t.node + component);
                    if (found == follows.end()) return tie.terms.push_back({{t.node, component}, factor});
                    for (const LinearConstraint::Term& term : list_of_all[found->second].terms)
                        tie.terms.push_back({term.of, factor * term.factor});
                };
                add(c, 1);
                for (int k = 0; c < 3 && k < 3; ++k)
                    if (const double lever = Vec3::Unit(k).cross(arm)[c]; lever != 0) add(3 + k, lever);
                if (t.between_nodes) follows[6 * t.end + c] = list_of_all.size();
                list_of_all.push_back(std::move(tie));
            }
        }
    }
    void place(const Pose&, const std::vector<Vec3>&, Configuration& to) const override {
        for_each_tied([&](const Tie& t) {
            to.displacement[t.end] = to.displacement[t.node];
            if (t.arm.isZero(0)) return;
            to.displacement[t.end] += w_.structure.large() ? Vec3(to.rotation[t.node] * t.arm - t.arm)
                                                           : Vec3(to.small_rotation[t.node].cross(t.arm));
        });
    }
    void set_velocities(Configuration& of) const override {
        for_each_tied([&](const Tie& t) {
            const Vec6& v = of.velocity[t.node];
            of.velocity[t.end].head<3>() = v.head<3>();
            if (!t.arm.isZero(0)) of.velocity[t.end].head<3>() += Vec3(v.tail<3>()).cross(arm_of(t, of));
            if (t.is_rigid()) of.velocity[t.end].tail<3>() = v.tail<3>();
        });
    }
    void set_accelerations(Configuration& of) const override {
        for_each_tied([&](const Tie& t) {
            const Vec6& a = of.acceleration[t.node];
            of.acceleration[t.end].head<3>() = a.head<3>();
            if (t.is_rigid()) of.acceleration[t.end].tail<3>() = a.tail<3>();
            if (t.arm.isZero(0)) return;
            const Vec3 r = arm_of(t, of), w = of.velocity[t.node].tail<3>();
            of.acceleration[t.end].head<3>() += Vec3(a.tail<3>()).cross(r);
            if (w_.structure.large()) of.acceleration[t.end].head<3>() += w.cross(w.cross(r));
        });
    }
    /// The moment arm x f of an end on its node changes as the arm rotates.
    void add_curvature(const Pose& at, const std::vector<Vec6>& unbalanced, Blocks& blocks) const override {
        if (!w_.structure.large()) return;
        for (const Tie& t : ties_) {
            if (t.arm.isZero(0) || !is_whole(t)) continue;
            Mat6 K = Mat6::Zero();
            K.block<3, 3>(3, 3) = skew(Vec3(unbalanced[t.end].head<3>())) * skew(arm_of(t, at));
            blocks.stiffness(t.node, K);
        }
    }

    // ---- a step ---------------------------------------------------------------------------------------------------
    void accumulate_energy(const Step&, Accounts& sums) const override {
        double work = 0;
        for (std::size_t i = 0; i < made_.size(); ++i) {
            if (list()[i].broken) continue;
            work += dissipated_in_step(i);
            if (made_[i].damping == 0) continue;
            const Vec3 turned = turn(i, w_.trial).rotation - list()[i].rotation;
            sums["damping"] += 0.5 * (list()[i].viscous + viscous_at_end(i).moment).dot(turned);
        }
        sums["joint_dissipated"] += work;
    }
    void acceleration_found() override {
        for (std::size_t i = 0; i < made_.size(); ++i) list()[i].viscous = now_[i].viscous;
    }
    void before_commit(const Step& step) override {
        int first = -1;  // of those that break in the step
        for (std::size_t i = 0; i < made_.size(); ++i) {
            if (list()[i].broken) continue;
            keep(i, step);
            if (list()[i].over < 0 || !w_.kind.dynamic) continue;
            release(i, step.end());
            leave_node(made_[i].node);
            if (first < 0) first = int(i);
        }
        if (first < 0) return;
        note_close_call(std::size_t(first), step.end());
        host_.constraints_changed();
        changed(w_.trial);
    }
    /// A node whose last element has broken holds nothing any more. The run finds its constraints anew after that.
    void broke(const Break&) override {
        for (const Tie& t : ties_)
            if (t.is_rigid() && (lost(t.node) || lost(t.end))) leave_node(t.node), lost_any_ = true;
        for (std::size_t i = 0; i < made_.size(); ++i) {
            if (list()[i].broken || !(lost(made_[i].node) || lost(made_[i].end))) continue;
            release(i, w_.state.time);
            leave_node(made_[i].node);
            lost_any_ = true;
        }
    }
    void all_broke() override {
        if (lost_any_) changed(w_.state);
        lost_any_ = false;
    }
    bool allows_long_step() const override {
        for (std::size_t i = 0; i < made_.size(); ++i)
            if (!list()[i].broken && (!declared()[i].is.is_linear() || declared()[i].is.can_break())) return false;
        return true;
    }
    void keep_from_rest(const Bodies& bodies, std::vector<char>& rests) const override {
        for_each_tied([&](const Tie& t) {
            for (const int n : {t.node, t.end})
                if (bodies.of_node[n] >= 0) rests[bodies.of_node[n]] = 0;
        });
    }

    // ---- energy, warnings and checkpoint --------------------------------------------------------------------------
    void add_energy(const State& state, Accounts& sums) const override { sums["joint_stored"] += stored(state); }
    /// Statics breaks no joint. In dynamics the order in which they break may hang on the settings.
    void check_run(std::vector<RunWarning>& warnings) const override {
        if (close_.times > 0)
            warnings.push_back(
                {name_of(close_.broke) + " broke at t = " + number_text(close_.time, 4) + " s, when " +
                     name_of(close_.other) + " had " + number_text(100 * close_.part, 3) + " % of its capacity" +
                     (close_.times > 1 ? ", and so " + std::to_string(close_.times - 1) + " more times" : "") +
                     ": which of them breaks first may hang on dt, the integrator and the elements, and "
                     "what follows with it",
                 "compare with another integrator, and with twice the elements", made_[close_.broke].member});
        for (std::size_t i = 0; i < made_.size(); ++i) {
            const JointNow& j = list()[i];
            if (w_.kind.dynamic || j.over < 0) continue;
            warnings.push_back({name_of(i) + " is beyond its capacity: " + why(i) + "; statics breaks no joint",
                                "a dynamic run that goes on from here breaks it", made_[i].member});
        }
    }
    bool restored(std::span<const State* const> states) override {
        if (close_.times < 0 || close_.broke >= made_.size() || close_.other >= made_.size()) return false;
        return std::all_of(states.begin(), states.end(), [&](const State* s) {
            const auto* there = s->data.find<JointsNow>(joints_effect);
            const auto* records = s->data.find<JointRecords>(joint_records);
            if (!there || there->list.size() != made_.size()) return false;
            if (!records || records->list.size() != made_.size()) return false;
            for (std::size_t i = 0; i < made_.size(); ++i)
                for (int k = 0; k < 3; ++k)
                    if (there->list[i].slid[k].size() != made_[i].parts[k].size()) return false;
            return true;
        });
    }

    void save(Writer& to) const override { to(close_); }
    void restore(Reader& from) override { from(close_); }

private:
    /// A declared joint in this structure.
    struct Made {
        int member, side;
        int node, end;   ///< the script's node, and the member's own
        Vec3 stiffness;  ///< of the elastic part about each axis, N m/rad
        Vec3 own;        ///< of the member about each axis: 4 EI / L and G J / L, N m/rad
        std::vector<JointPart> parts[3];
        Mat3 axes;  ///< columns x y z of the section
        bool is_between_nodes() const { return member < 0; }
        double wave = 0;     ///< s, in which an axial wave runs through the member
        double damping = 0;  ///< s: beta of model:damping
    };
    struct Evaluated {
        Vec3 moment = Vec3::Zero(), slope = Vec3::Zero();
        double stored = 0, dissipated = 0;
        double work[3] = {0, 0, 0};  ///< J: `dissipated` by axis
        std::vector<double> slid[3];
    };
    /// What the member's end resists where forces were found last, with the loads on it.
    struct Now {
        Vec3 resisted = Vec3::Zero();  ///< N, in space
        Vec3 viscous = Vec3::Zero();   ///< N m: the moment of damping
    };
    /// Moment of damping about each axis, N m, and its derivatives by the rate and by the rotation. `elastic`: part of
    /// the rate that the springs have.
    struct Viscous {
        Vec3 moment = Vec3::Zero(), by_rate = Vec3::Zero(), by_rotation = Vec3::Zero(), elastic = Vec3::Ones();
    };

    const std::vector<Joint>& declared() const { return declared_; }
    const std::vector<Joint>& declared_ = w_.structure.model().declared<Joint>(joints_effect);
    std::vector<JointNow>& list() const { return w_.state.data.find<JointsNow>(joints_effect)->list; }
    JointRecords& records() const { return *w_.state.data.find<JointRecords>(joint_records); }
    bool lost(int node) const { return w_.state.gone[node] && !w_.structure.is_alone(node); }

    Made make(const Joint& j) const {
        if (j.is_between_nodes()) return between_nodes(j);
        const Structure& s = w_.structure;
        Made m{j.member, j.end, s.model().members()[j.member].node[j.end], s.end_node(j.member, j.end), {}, {}, {}, {}};
        const Element& e = s.elements()[s.elements_at(m.end)[0]];
        const double length = e.length * s.model().members()[j.member].elements;
        m.axes = e.axes.toRotationMatrix();
        m.wave = length * std::sqrt(e.rigidity.rhoA / e.rigidity.EA);
        find_parts(j, Vec3(4 * e.rigidity.EIx, 4 * e.rigidity.EIy, e.rigidity.GJ) / length, m);
        m.damping = joint_damping(s, damping_of_elements_, {m.end});
        return m;
    }
    Made between_nodes(const Joint& j) const {
        const Structure& s = w_.structure;
        Made m{-1, 0, j.from, j.to, {}, {}, {}, j.axes};
        double stiffest = 0;
        for (const int node : {j.from, j.to}) {
            if (s.is_alone(node))
                throw InputError("model:joint: " + s.node_name(node) +
                                 " has no member, so that it has neither stiffness nor mass; join nodes of members");
            const auto count = [&](int at) {
                for (const int i : s.elements_at(at)) {
                    const Element& e = s.elements()[i];
                    const double length = e.length * s.model().members()[e.member].elements;
                    stiffest = std::max({stiffest, 4 * e.rigidity.EIx / length, 4 * e.rigidity.EIy / length});
                }
            };
            count(node);
            for (const Made& other : made_)
                if (!other.is_between_nodes() && other.node == node && s.hangs_on_joints(node)) count(other.end);
        }
        find_parts(j, Vec3::Constant(stiffest), m);
        m.damping = joint_damping(s, damping_of_elements_, {j.from, j.to});
        return m;
    }
    double rigid_part() const {
        return !w_.kind.dynamic         ? rigid_part_static
               : w_.kind.explicit_steps ? rigid_part_explicit
                                        : rigid_part_implicit;
    }
    /// `own`: stiffness of the member about each axis, N m/rad.
    void find_parts(const Joint& j, const Vec3& own, Made& m) const {
        m.own = own;
        for (int k = 0; k < 3; ++k) {
            const JointAxis& axis = j.is.axis[k];
            m.parts[k] = parts_of(axis);
            m.stiffness[k] = std::isfinite(axis.stiffness) ? axis.stiffness : rigid_part() * own[k];
        }
    }

    /// A run that goes on from one with another stiffness of rigid axes begins with the moments of that one.
    void go_on(std::size_t i) {
        for (int k = 0; k < 3; ++k)
            if (!std::isfinite(declared()[i].is.axis[k].stiffness))
                list()[i].offset[k] = list()[i].rotation[k] - list()[i].moment[k] / made_[i].stiffness[k];
    }

    /// A node that follows one of the script's: a member's own end, at an offset or not, or a node at a joint.
    struct Tie {
        int node, end;
        int joint;  ///< its place in made_; -1: none, the end rotates with the node
        bool between_nodes;
        Vec3 arm;  ///< from the node to the end as declared, m
        const char* call;
        bool is_rigid() const { return joint < 0; }
    };
    void list_ties() {
        const Model& model = w_.structure.model();
        for (const MemberOffset& o : model.declared<MemberOffset>(member_offsets))
            for (const DeclaredLoad& load : declared_loads(model))
                if (load.motion && w_.kind.dynamic && load.node == model.members()[o.member].node[o.end])
                    throw InputError("model:member, offset: " + w_.structure.node_name(load.node) +
                                     " is moved by model:move; that does not go together yet: let the member end at "
                                     "the node that is moved");
        for (const std::size_t i : in_order_) {
            const Made& m = made_[i];
            const bool between = declared()[i].is_between_nodes();
            ties_.push_back({m.node, m.end, int(i), between,
                             between ? Vec3(Vec3::Zero()) : offset_of(model, m.member, m.side),
                             between ? "model:joint" : "model:member, ends"});
        }
        for (const MemberOffset& o : model.declared<MemberOffset>(member_offsets)) {
            const int end = w_.structure.end_node(o.member, o.end);
            if (std::none_of(made_.begin(), made_.end(), [&](const Made& m) { return m.end == end; }))
                ties_.push_back({model.members()[o.member].node[o.end], end, -1, false, o.by, "model:member, offset"});
        }
    }
    bool is_whole(const Tie& t) const {
        return t.is_rigid() ? !lost(t.node) && !w_.state.gone[t.end] : !list()[std::size_t(t.joint)].broken;
    }
    Vec3 arm_of(const Tie& t, const Pose& at) const {
        return t.arm.isZero(0) || !w_.structure.large() ? t.arm : Vec3(at.rotation[t.node] * t.arm);
    }
    template <class F>
    void for_each_tied(F f) const {
        for (const Tie& t : ties_)
            if (is_whole(t)) f(t);
    }

    RelativeRotation turn(std::size_t i, const Pose& at) const {
        const Made& m = made_[i];
        return relative_rotation(w_.structure, at, m.node, m.end, m.axes, list()[i].rotation);
    }

    Evaluated evaluate(std::size_t i, const Vec3& rotation) const { return evaluate(made_[i], rotation, list()[i]); }
    static Evaluated evaluate(const Made& m, const Vec3& rotation, const JointNow& from) {
        Evaluated e;
        for (int k = 0; k < 3; ++k) {
            if (m.parts[k].empty()) {
                const double turned = rotation[k] - from.offset[k];
                e.moment[k] = m.stiffness[k] * turned;
                e.slope[k] = m.stiffness[k];
                e.stored += 0.5 * e.moment[k] * turned;
                continue;
            }
            e.slid[k] = from.slid[k];
            const Resistance r = resist(m.parts[k], k < 2 ? from.left : 1, rotation[k], e.slid[k]);
            e.moment[k] = r.moment, e.slope[k] = r.slope;
            e.stored += r.stored, e.dissipated += r.dissipated, e.work[k] = r.dissipated;
        }
        return e;
    }

    /// Of each axis, N m/rad, as Blocks asks for those that have yielded.
    Vec3 slope_of(std::size_t i, const Vec3& rotation, const Evaluated& e, Yielded as) const {
        if (as == Yielded::at_rotation) return e.slope;
        const Made& m = made_[i];
        Vec3 slope = m.stiffness;
        for (int k = 0; k < 3 && as == Yielded::goes_on; ++k) {
            if (m.parts[k].empty()) continue;
            slope[k] = 0;
            for (std::size_t p = 0; p < m.parts[k].size(); ++p) {
                const auto& [stiffness, strength] = m.parts[k][p];
                const double has = std::abs(stiffness * (rotation[k] - e.slid[k][p]));
                if (has < at_strength * (k < 2 ? list()[i].left : 1) * strength) slope[k] += stiffness;
            }
        }
        return slope;
    }

    /// Stiffness of the axes that are damped: a rigid one has no rate of its own.
    Vec3 damped(std::size_t i) const {
        Vec3 k = made_[i].stiffness;
        for (int c = 0; c < 3; ++c)
            if (!std::isfinite(declared()[i].is.axis[c].stiffness)) k[c] = 0;
        return k;
    }
    /// `begins`: where a step begins, the joint slips on as in the step before.
    Viscous viscous(std::size_t i, const RelativeRotation& r, const Evaluated& e, bool begins) const {
        const Made& m = made_[i];
        const JointNow& from = list()[i];
        const Vec3 k = damped(i), turned = r.rotation - from.rotation,
                   rate = r.by_spin() * (w_.velocity(w_.trial, m.end) - w_.velocity(w_.trial, m.node)).tail<3>();
        const double dt = w_.assembly.step();
        Viscous v;
        if (begins) v.elastic = from.elastic;
        for (int c = 0; c < 3 && !begins; ++c) {
            if (m.parts[c].empty() || turned[c] == 0 || dt == 0 || k[c] == 0) continue;
            double springs = 0, mean = 0;  // k x, and k (D - P) / D
            for (std::size_t p = 0; p < m.parts[c].size(); ++p) {
                const double part = 1 - (e.slid[c][p] - from.slid[c][p]) / turned[c];
                springs += m.parts[c][p].stiffness * std::clamp(part, 0.0, 1.0);
                mean += m.parts[c][p].stiffness * part;
            }
            v.elastic[c] = springs / k[c];
            v.moment[c] = m.damping * (mean - springs) * turned[c] / dt;
            v.by_rotation[c] = m.damping * (e.slope[c] - springs) / dt;
        }
        v.by_rate = m.damping * k.cwiseProduct(v.elastic);
        v.moment += v.by_rate.cwiseProduct(rate);
        return v;
    }
    /// Where the trial has ended; explicit steps took it at the predicted velocity.
    Viscous viscous_at_end(std::size_t i) const {
        const RelativeRotation r = turn(i, w_.trial);
        Viscous v = viscous(i, r, evaluate(i, r.rotation), false);
        if (w_.kind.explicit_steps) v.moment = now_[i].viscous;
        return v;
    }

    /// Where tension has weakened the joint, the step began with the moment that it had before: half of what that lost
    /// does work with the step's rotation.
    double dissipated_in_step(std::size_t i) const {
        const JointNow& j = list()[i];
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
        for (std::size_t k = 0; k < made_.size(); ++k) {
            if (list()[k].broken || !declared()[k].is.can_break()) continue;
            const double part = used(k);
            if (!(part >= close_part && part < 1)) continue;
            if (close_.times++ == 0) close_.broke = broke, close_.other = k, close_.part = part, close_.time = time;
            return;
        }
    }

    /// `by_rate`: N m s/rad about each axis.
    void add(std::size_t i, const RelativeRotation& r, const Vec3& slope, const Vec3& moment, Blocks& blocks,
             const Vec3& by_rate) const {
        const Mat3 S = r.by_spin();
        const auto between = [&S](const Vec3& of_axes) {
            const Mat3 k = S.transpose() * of_axes.asDiagonal() * S;
            Mat12 K = Mat12::Zero();
            K.block<3, 3>(3, 3) = K.block<3, 3>(9, 9) = k;
            K.block<3, 3>(3, 9) = K.block<3, 3>(9, 3) = -k;
            return K;
        };
        Mat12 K = between(slope);
        if (!by_rate.isZero(0)) blocks.damping(made_[i].node, made_[i].end, between(by_rate));
        Mat12 G = Mat12::Zero();
        add_moment_curvature(r, moment, G);
        K += blocks.yielded == Yielded::at_rotation ? Mat12(0.5 * (G + G.transpose())) : G;  // modes take all of it
        blocks.stiffness(made_[i].node, made_[i].end, K);
    }

    /// Takes what the step has led to, and sees whether it reaches a capacity.
    void keep(std::size_t i, const Step& step) {
        const Made& m = made_[i];
        const JointProperties& is = declared()[i].is;
        JointNow& j = list()[i];
        if (m.damping > 0) {
            const Viscous v = viscous_at_end(i);
            j.viscous = v.moment, j.elastic = v.elastic;
        }
        j.rotation = turn(i, w_.trial).rotation;
        Evaluated e = evaluate(i, j.rotation);
        for (int k = 0; k < 3; ++k) {
            if (m.parts[k].empty()) continue;
            note_slip(i, k, e.slid[k] != j.slid[k], e.work[k], step);
            j.slid[k] = std::move(e.slid[k]);
        }
        j.moment = e.moment;
        const Mat3 turned = w_.structure.large() ? Mat3(w_.trial.rotation[m.end].toRotationMatrix() * m.axes) : m.axes;
        const Vec3 f = turned.transpose() * (now_[i].resisted - w_.load(m.end).head<3>() + inertia_of_end(m.end));
        j.tension = m.side == 0 ? -f.z() : f.z();
        j.shear = f.head<2>().norm();
        if (is.tension_weakens) {
            const double part = w_.kind.dynamic && step.dt < m.wave ? step.dt / m.wave : 1;
            j.pull += part * (j.tension - j.pull);
            weaken(i, std::clamp(1 - j.pull / is.tension, 0.0, 1.0), step);
        }
        record(i);
        j.over = -1;
        for (int k = 0; k < 3; ++k)
            if (std::abs(j.rotation[k]) >= is.axis[k].capacity) j.over = k;
        if (j.tension >= is.tension) j.over = 3;
        if (j.shear >= is.shear) j.over = 4;
    }

    /// The force of a member's end has the inertia of what moves with its node. R of implicit steps has it already.
    Vec3 inertia_of_end(int end) const {
        if (!w_.kind.explicit_steps) return Vec3::Zero();
        return lumped_mass_at(w_.structure, w_.state, end).mass * w_.trial.acceleration[end].head<3>();
    }

    /// Sliders that hold less from the next step on slip at once: what their springs lose is dissipated.
    void weaken(std::size_t index, double left, const Step& step) {
        const Made& m = made_[index];
        JointNow& j = list()[index];
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
    /// Takes the end of the step into what the joint has gone through.
    void record(std::size_t i) {
        const JointNow& j = list()[i];
        JointRecord& r = records().list[i];
        double about[3] = {0, 0, 0};
        for (int k = 0; k < 3; ++k) {
            if (!declared()[i].is.axis[k].is_spring()) continue;
            about[k] = j.rotation[k];
            keep_largest(r.axis[k].largest, j.rotation[k]);
            keep_largest(r.axis[k].moment, j.moment[k]);
        }
        keep_largest(r.bent, std::hypot(about[0], about[1]));
        if (!(j.tension <= 0)) keep_largest(r.tension, j.tension);
        keep_largest(r.shear, j.shear);
    }

    double stored(const State& state) const {
        const auto* there = state.data.find<JointsNow>(joints_effect);
        double energy = 0;
        for (std::size_t i = 0; there && i < there->list.size(); ++i) {
            const JointNow& j = there->list[i];
            if (!j.broken) energy += evaluate(made_[i], turn_in(i, state, j), j).stored;
        }
        return energy;
    }
    Vec3 turn_in(std::size_t i, const State& state, const JointNow& j) const {
        const Made& m = made_[i];
        return relative_rotation(w_.structure, state, m.node, m.end, m.axes, j.rotation).rotation;
    }

    std::string name_of(std::size_t i) const {
        if (declared()[i].is_between_nodes())
            return "the joint between nodes " + std::to_string(made_[i].node + 1) + " and " +
                   std::to_string(made_[i].end + 1);
        return "the joint at end " + std::string(made_[i].side == 0 ? "a" : "b") + " of member " +
               std::to_string(made_[i].member + 1);
    }
    std::string why(std::size_t i) const {
        const JointNow& j = list()[i];
        char text[80] = "its node has lost its last member";
        if (j.over >= 0 && j.over < 3)
            std::snprintf(text, sizeof text, "rotation of %.4g rad about the axis of %s", j.rotation[j.over],
                          axis_names[j.over]);
        if (j.over == 3) std::snprintf(text, sizeof text, "tension of %.4g N", j.tension);
        if (j.over == 4) std::snprintf(text, sizeof text, "shear force of %.4g N", j.shear);
        return text;
    }

    /// Whether a node that hangs on joints rotates with the end of this one, the first of those that are whole.
    bool carries_node(std::size_t i) const {
        const int node = made_[i].node;
        if (!w_.structure.hangs_on_joints(node) || made_[i].is_between_nodes()) return false;
        for (const bool rigid : {true, false})  // an end without a joint holds the node
            for (const Tie& t : ties_)
                if (t.is_rigid() == rigid && t.node == node && !t.between_nodes && is_whole(t))
                    return t.joint == int(i);
        return false;
    }
    /// A node that hung on joints and offset ends, and has lost the last of them, is gone. One with a point mass flies
    /// on; where that has no rotary inertia, without a rotation.
    void leave_node(int node) {
        if (!w_.structure.hangs_on_joints(node) || w_.state.gone[node]) return;
        for (const Tie& t : ties_)
            if ((t.node == node || t.end == node) && is_whole(t)) return;
        const bool heavy = !w_.state.offset_mass.empty() && w_.state.offset_mass[node].mass > 0;
        if (heavy && w_.state.offset_mass[node].inertia.trace() > 0) return;
        w_.state.held[node] |= heavy ? 56 : 63;
        if (!heavy) w_.state.gone[node] = 1;
        for (int c = heavy ? 3 : 0; c < 6; ++c)
            for (double* of : {&w_.state.velocity[node][c], &w_.state.acceleration[node][c],
                               &w_.trial.velocity[node][c], &w_.trial.acceleration[node][c]})
                *of = 0;
        w_.supported.push_back(node);
    }
    /// A moment on a node that no member resists, where the ends of all of them are released about its axis.
    void refuse_moments() const {
        for (const DeclaredLoad& load : declared_loads(w_.structure.model())) {
            const int node = load.node;
            if (load.motion || node < 0 || load.moment.isZero(0) || !w_.structure.hangs_on_joints(node)) continue;
            Mat3 held = Mat3::Zero();
            for (int c : {0, 1, 2})
                if (w_.structure.fixed()[node] >> (3 + c) & 1) held(c, c) = 1;
            for (const Tie& t : ties_)
                if (t.is_rigid() && t.node == node) held.setIdentity();
            for (std::size_t i = 0; i < made_.size(); ++i)
                for (int k = 0; k < 3; ++k)
                    if ((made_[i].node == node || made_[i].end == node) && made_[i].stiffness[k] > 0)
                        held += made_[i].axes.col(k) * made_[i].axes.col(k).transpose();
            const Vec3 M = load.moment.normalized();
            const Eigen::SelfAdjointEigenSolver<Mat3> directions(held);
            for (int i = 0; i < 3; ++i)
                if (directions.eigenvalues()[i] < 1e-6 && std::abs(M.dot(directions.eigenvectors().col(i))) > 1e-6)
                    throw InputError(load.what + " has a moment, and the ends of all members at " +
                                     w_.structure.node_name(node) +
                                     " are released about its axis, so that nothing resists it; leave the release out "
                                     "at one of them, or take the moment away");
        }
    }

    void release(std::size_t i, double time) {
        JointNow& j = list()[i];
        w_.state.accumulated["joint_dissipated"] += evaluate(i, j.rotation).stored;
        j.broken = true;
        j.broken_at = time;
        host_.note_activation(joints_effect, false, name_of(i) + " broke: " + why(i));
    }
    void changed(const Pose& at) {
        host_.accelerations_anew();
        host_.blocks_changed(at);
    }

    const std::vector<ElementDamping> damping_of_elements_ = damping_of(w_.structure);
    std::vector<Made> made_;
    std::vector<std::size_t> in_order_;  ///< joints between nodes first
    std::vector<Tie> ties_;              ///< in that order; then ends at an offset without a joint
    std::vector<Now> now_;
    bool lost_any_ = false;
    /// The first break at which another joint was close to its own, and how many there were.
    struct Close {
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
