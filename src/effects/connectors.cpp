// Connectors: springs, dashpots and laws of the script between two nodes, or between a node and the ground.
//
// Node a carries the connector on a rigid arm that reaches to node b. With r from a to b, A the axes (they rotate with
// a) and w the relative rotation vector, the deformation is d = [A^T r - A0^T r0, A^T w], d' = B v, and the forces of
// the nodes are B^T f: they are in balance, moments too, wherever the nodes have gone.
//
// Damping by stiffness (model:damping) adds beta times the rate of the force of springs and curves. It is beside the
// force that a script reads and that a capacity limits, and its work is in the account of damping.
#include "effects/connectors.h"

#include <algorithm>
#include <cmath>

#include "core/errors.h"
#include "effects/all_effects.h"
#include "effects/connector_curve.h"
#include "effects/kinds.h"
#include "effects/relative_rotation.h"
#include "state/joint_records.h"

namespace hinge {
namespace {

using Mat6x12 = Eigen::Matrix<double, 6, 12>;

/// Part of a deformation, or of its rate, by which a law's slope is told from a difference; and the least of both.
constexpr double slope_part = 1e-6, slope_least = 1e-3;

/// Where a connector is.
struct Placed {
    RelativeRotation turn;
    Vec3 arm;          ///< from a to b
    Vec6 deformation;  ///< m, rad
    Mat6x12 B;
};

class Connectors : public Effect, public Force, public BreakListener, public StepLimiter {
public:
    Connectors(Workspace& w, Host& host)
        : Effect(connectors_effect, w, host, {.mean_forces = true}), now_(declared().size()) {
        for (const Connector& c : declared()) {
            traits_.forces_vanish = traits_.forces_vanish || (c.capacity.array() < infinite).any() || c.ultimate.any();
            traits_.calls_script = traits_.calls_script || std::any_of(std::begin(c.law), std::end(c.law),
                                                                       [](const ConnectorLaw& l) { return bool(l); });
        }
        for (const Connector& c : declared()) refuse_rotation_of_panels(c);
        for (const Connector& c : declared())
            for (const int node : {c.a, c.b})
                if (node >= 0 && w.structure.is_alone(node))
                    throw InputError("model:connector: " + w.structure.node_name(node) +
                                     " belongs to no member, so that nothing moves it; join the members' own nodes, or "
                                     "use ground = true");
        if (!w.state.data.find<ConnectorsNow>(connectors_effect)) w.state.data.set(connectors_effect, ConnectorsNow{});
        list().resize(declared().size());
        const std::vector<ElementDamping> damping = damping_of(w.structure);
        for (const Connector& c : declared()) damping_.push_back(joint_damping(w.structure, damping, {c.a, c.b}));
    }

    // ---- what acts ------------------------------------------------------------------------------------------------
    void begin_statics() override {
        for (ConnectorNow& c : list()) c.of_dashpots.setZero(), c.viscous.setZero();
    }
    void add_forces(double time, std::vector<Vec6>& resisting) override {
        for (std::size_t i = 0; i < now_.size(); ++i) {
            if (list()[i].broken) continue;
            const Connector& c = declared()[i];
            const Placed p = place(i, w_.trial, list()[i]);
            evaluate(i, p, time - w_.state.time);
            const Vec12 force = p.B.transpose() * (now_[i].force() + now_[i].viscous);
            if (c.a >= 0) resisting[c.a] += force.head<6>();
            resisting[c.b] += force.tail<6>();
        }
    }

    bool has_blocks() const override {
        return std::any_of(list().begin(), list().end(), [](const ConnectorNow& c) { return !c.broken; });
    }
    bool blocks_follow() const override {
        if (w_.structure.large()) return has_blocks();
        for (std::size_t i = 0; i < now_.size(); ++i)
            if (!list()[i].broken && !declared()[i].is_linear()) return true;
        return false;
    }
    void add_blocks(const Pose& at, Blocks& blocks) const override {
        for (std::size_t i = 0; i < now_.size(); ++i) {
            if (list()[i].broken) continue;
            const Connector& c = declared()[i];
            const Evaluated& now = now_[i];
            const Placed p = place(i, at, list()[i]);
            const Vec6 springs = slope_of(i, p.deformation), slope = springs + now.law_slope;
            Mat12 K = p.B.transpose() * slope.asDiagonal() * p.B;
            if (c.yield.any()) {  // x and y that yield together
                Mat6 across = spring_that_yields(i, p.deformation).slope;
                across.diagonal().setZero();
                K += p.B.transpose() * across * p.B;
            }
            if (w_.structure.large() && w_.kind.geometric) add_rotation_of_axes(p, now.force(), c.a < 0, K);
            add(c, K, p.B, c.damping + now.law_rate_slope + damping_[i] * springs, blocks);
        }
    }

    // ---- a step ---------------------------------------------------------------------------------------------------
    /// The work of dashpots and laws, by the trapezium rule.
    void accumulate_energy(const Step&, Accounts& sums) const override {
        double work = 0, by_stiffness = 0;
        for (std::size_t i = 0; i < now_.size(); ++i) {
            const ConnectorNow& before = list()[i];
            if (before.broken) continue;
            const ConnectorNow end = at_end(i);
            by_stiffness += 0.5 * (before.viscous + end.viscous).dot(end.deformation - before.deformation);
            if (declared()[i].yield.any()) {
                const Vec6& k = declared()[i].stiffness;
                work += 0.5 * k.cwiseProduct(before.deformation - before.plastic + end.deformation - end.plastic)
                                  .dot(end.plastic - before.plastic);
            }
            work += 0.5 * (before.of_dashpots + before.of_laws + end.of_dashpots + end.of_laws)
                              .dot(end.deformation - before.deformation);
        }
        sums["connector_dissipated"] += work;
        if (by_stiffness != 0) sums["damping"] += by_stiffness;
    }

    void before_commit(const Step& step) override {
        bool any = false;
        for (std::size_t i = 0; i < now_.size(); ++i) {
            if (list()[i].broken) continue;
            list()[i] = at_end(i);
            for (int k = 0; k < 6; ++k) keep_largest(list()[i].largest[k], list()[i].force[k]);
            int broke = declared()[i].ultimate.reached(list()[i].plastic);
            for (int k = 5; k >= 0; --k)
                if (std::abs(list()[i].force[k]) >= declared()[i].capacity[k]) broke = k;
            if (broke >= 0) release(i, step.end(), broke), any = true;
        }
        if (any) changed(w_.trial);
    }

    /// A node that has lost its last element holds nothing any more.
    void all_broke() override {
        bool any = false;
        for (std::size_t i = 0; i < now_.size(); ++i) {
            const Connector& c = declared()[i];
            if (list()[i].broken || !(w_.state.gone[c.b] || (c.a >= 0 && w_.state.gone[c.a]))) continue;
            release(i, w_.state.time, -1);
            any = true;
        }
        if (any) changed(w_.state);
    }

    void acceleration_found() override {
        for (std::size_t i = 0; i < now_.size(); ++i)
            if (ConnectorNow& c = list()[i]; !c.broken)
                c.of_dashpots = now_[i].dashpot, c.of_laws = now_[i].law, c.viscous = now_[i].viscous;
    }

    bool allows_long_step() const override {
        for (std::size_t i = 0; i < now_.size(); ++i)
            if (!list()[i].broken && (!declared()[i].is_linear() || (declared()[i].capacity.array() < infinite).any()))
                return false;
        return true;
    }
    void keep_from_rest(const Bodies& bodies, std::vector<char>& rests) const override {
        for (std::size_t i = 0; i < now_.size(); ++i)
            for (const int node : {declared()[i].a, declared()[i].b})
                if (node >= 0 && !list()[i].broken && bodies.of_node[node] >= 0) rests[bodies.of_node[node]] = 0;
    }

    /// With a curve's steepest piece. The slope of a law is not known.
    void add_stiffest(Blocks& most) const override {
        for (std::size_t i = 0; i < now_.size(); ++i) {
            if (list()[i].broken) continue;
            const Connector& c = declared()[i];
            const Placed p = place(i, w_.state, list()[i]);
            Vec6 slope = c.stiffness;
            for (int k = 0; k < 6; ++k) slope[k] += steepest(c.curve[k]);
            add(c, p.B.transpose() * slope.asDiagonal() * p.B, p.B, c.damping + damping_[i] * slope, most);
        }
    }

    // ---- energy and checkpoint ------------------------------------------------------------------------------------
    void add_energy(const State& state, Accounts& sums) const override { sums["connector_stored"] += stored(state); }
    void save(Writer& to) const override { fields(*this, to); }
    void restore(Reader& from) override { fields(*this, from); }
    bool restored(std::span<const State* const> states) override {
        for (const State* s : states) {
            const auto* there = s->data.find<ConnectorsNow>(connectors_effect);
            if (!there || there->list.size() != declared().size()) return false;
        }
        return now_.size() == declared().size();
    }

private:
    static constexpr double infinite = std::numeric_limits<double>::infinity();

    /// Its forces at the last evaluation, in its axes.
    struct Evaluated {
        Vec6 deformation = Vec6::Zero(), rate = Vec6::Zero();
        Vec6 spring = Vec6::Zero(), dashpot = Vec6::Zero(), law = Vec6::Zero();
        Vec6 law_slope = Vec6::Zero(), law_rate_slope = Vec6::Zero();
        Vec6 viscous = Vec6::Zero();
        LawState state[6];
        Vec6 force() const { return spring + dashpot + law; }
        template <class Self, class A>
        static void fields(Self& s, A& a) {
            a(s.deformation, s.rate, s.spring, s.dashpot, s.law, s.law_slope, s.law_rate_slope, s.viscous, s.state);
        }
    };
    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.now_);
    }

    const std::vector<Connector>& declared() const { return declared_; }
    const std::vector<Connector>& declared_ = w_.structure.model().declared<Connector>(connectors_effect);
    std::vector<ConnectorNow>& list() const { return w_.state.data.find<ConnectorsNow>(connectors_effect)->list; }

    std::string name_of(std::size_t i) const {
        const Connector& c = declared()[i];
        return "connector " + std::to_string(i + 1) +
               (c.a < 0 ? " between the ground and " + w_.structure.node_name(c.b)
                        : " between " + w_.structure.node_name(c.a) + " and " + w_.structure.node_name(c.b));
    }

    /// A node that panels alone join does not rotate.
    void refuse_rotation_of_panels(const Connector& c) const {
        const Structure& s = w_.structure;
        const auto of_panels = [&](int node) { return node >= 0 && s.has_panels_alone(node); };
        if (!of_panels(c.a) && !of_panels(c.b)) return;
        bool rotates = !c.stiffness.tail<3>().isZero(0) || !c.damping.tail<3>().isZero(0);
        for (int k = 3; k < 6; ++k) rotates = rotates || !c.curve[k].empty() || c.law[k];
        const std::string why =
            ", and panels alone join " + s.node_name(of_panels(c.a) ? c.a : c.b) + ": it has no rotation of its own";
        if (rotates) throw InputError("model:connector: it acts about rx, ry or rz" + why + "; give x, y and z alone");
        if (of_panels(c.a) && (s.position()[c.b] - s.position()[c.a]).norm() > 0)
            throw InputError("model:connector: its first node carries it on an arm" + why +
                             "; give the member's node first");
    }

    Placed place(std::size_t i, const Pose& at, const ConnectorNow& before) const {
        const Connector& c = declared()[i];
        const auto& X = w_.structure.position();
        const Vec3 arm = c.a < 0 ? Vec3(Vec3::Zero()) : Vec3(X[c.b] - X[c.a]);
        const Vec3 moved = c.a < 0 ? at.displacement[c.b] : Vec3(at.displacement[c.b] - at.displacement[c.a]);
        Placed p;
        p.turn = relative_rotation(w_.structure, at, c.a, c.b, c.axes, before.deformation.tail<3>());
        const Mat3 to_axes = p.turn.axes.transpose();
        if (w_.structure.large()) {
            p.arm = arm + moved;
            p.deformation.head<3>() = to_axes * p.arm - c.axes.transpose() * arm;
        } else {
            const Vec3 rotation = c.a < 0 ? Vec3(Vec3::Zero()) : at.small_rotation[c.a];
            p.arm = arm;
            p.deformation.head<3>() = to_axes * (moved - rotation.cross(arm));
        }
        p.deformation.tail<3>() = p.turn.rotation;
        p.B.setZero();
        p.B.block<3, 3>(0, 6) = to_axes;
        p.B.block<3, 3>(3, 9) = p.turn.by_spin();
        if (c.a >= 0) {
            p.B.block<3, 3>(0, 0) = -to_axes;
            p.B.block<3, 3>(0, 3) = to_axes * skew(p.arm);
            p.B.block<3, 3>(3, 3) = -p.B.block<3, 3>(3, 9);
        }
        return p;
    }

    Vec6 rate_of(std::size_t i, const Placed& p) const {
        const Connector& c = declared()[i];
        Vec12 v;
        v << (c.a < 0 ? Vec6(Vec6::Zero()) : w_.velocity(w_.trial, c.a)), w_.velocity(w_.trial, c.b);
        return p.B * v;
    }

    Vec6 viscous_of(std::size_t i, const Vec6& deformation, const Vec6& rate) const {
        if (damping_[i] == 0) return Vec6::Zero();
        return damping_[i] * slope_of(i, deformation).cwiseProduct(rate);
    }

    YieldingSpring spring_that_yields(std::size_t i, const Vec6& deformation) const {
        const Connector& c = declared()[i];
        return yielding_spring(c.stiffness, c.yield, deformation, list()[i].plastic);
    }
    Vec6 slope_of(std::size_t i, const Vec6& deformation) const {
        const Connector& c = declared()[i];
        Vec6 slope = c.yield.any() ? Vec6(spring_that_yields(i, deformation).slope.diagonal()) : c.stiffness;
        for (int k = 0; k < 6; ++k) slope[k] += on_curve(c.curve[k], deformation[k]).slope;
        return slope;
    }
    Vec6 spring_of(std::size_t i, const Vec6& deformation) const {
        const Connector& c = declared()[i];
        Vec6 force =
            c.yield.any() ? spring_that_yields(i, deformation).force : Vec6(c.stiffness.cwiseProduct(deformation));
        for (int k = 0; k < 6; ++k) force[k] += on_curve(c.curve[k], deformation[k]).force;
        return force;
    }

    /// `rate`: N s/m and N m s/rad, in the connector's axes.
    static void add(const Connector& c, const Mat12& K, const Mat6x12& B, const Vec6& rate, Blocks& blocks) {
        const Mat12 C = B.transpose() * rate.asDiagonal() * B;
        if (c.a < 0) {
            blocks.stiffness(c.b, K.bottomRightCorner<6, 6>());
            if (!rate.isZero(0)) blocks.damping(c.b, Mat6(C.bottomRightCorner<6, 6>()));
        } else {
            blocks.stiffness(c.a, c.b, K);
            if (!rate.isZero(0)) blocks.damping(c.a, c.b, C);
        }
    }

    void evaluate(std::size_t i, const Placed& p, double dt) {
        const Connector& c = declared()[i];
        Evaluated& now = now_[i];
        now.deformation = p.deformation;
        now.rate = rate_of(i, p);
        now.spring = spring_of(i, p.deformation);
        now.dashpot = c.damping.cwiseProduct(now.rate);
        now.viscous = viscous_of(i, now.deformation, now.rate);
        for (int k = 0; k < 6; ++k) {
            if (!c.law[k]) continue;
            const double d = now.deformation[k], v = now.rate[k];
            const auto ask = [&](double deformation, double rate, LawState& state) {
                state = list()[i].law[k];
                return c.law[k](deformation, rate, dt, state);
            };
            now.law[k] = ask(d, v, now.state[k]);
            if (w_.kind.explicit_steps) continue;
            LawState unused;
            const double by = std::copysign(slope_part * std::max(std::abs(d), slope_least), d);
            now.law_slope[k] = (ask(d + by, v, unused) - now.law[k]) / by;
            if (!w_.kind.dynamic) continue;  // a law is asked of no rate but 0
            const double faster = std::copysign(slope_part * std::max(std::abs(v), slope_least), v);
            now.law_rate_slope[k] = (ask(d, v + faster, unused) - now.law[k]) / faster;
        }
    }

    /// Where the trial has ended. Steps that solve once took the forces to follow their slopes from where they were
    /// found.
    ConnectorNow at_end(std::size_t i) const {
        const Evaluated& now = now_[i];
        ConnectorNow end = list()[i];
        const Placed p = place(i, w_.trial, end);
        end.deformation = p.deformation;
        end.of_dashpots = now.dashpot;
        end.of_laws = now.law;
        end.viscous = now.viscous;
        if (!w_.kind.explicit_steps) {
            const Vec6 rate = rate_of(i, p);
            end.of_dashpots = declared()[i].damping.cwiseProduct(rate);
            end.viscous = viscous_of(i, p.deformation, rate);
            end.of_laws += now.law_slope.cwiseProduct(p.deformation - now.deformation) +
                           now.law_rate_slope.cwiseProduct(rate - now.rate);
        }
        if (declared()[i].yield.any()) end.plastic = spring_that_yields(i, p.deformation).plastic;
        end.force = spring_of(i, p.deformation) + end.of_dashpots + end.of_laws;
        for (int k = 0; k < 6; ++k) end.law[k] = now.state[k];
        return end;
    }

    /// Stiffness by the rotation of axes, arm and moments; its symmetric part.
    static void add_rotation_of_axes(const Placed& p, const Vec6& f, bool ground, Mat12& K) {
        Mat12 G = Mat12::Zero();
        add_moment_curvature(p.turn, f.tail<3>(), G);
        const Mat3 F = skew(p.turn.axes * f.head<3>());
        G.block<3, 3>(6, 3) -= F;
        G.block<3, 3>(3, 6) += F;
        G.block<3, 3>(0, 3) += F;
        G.block<3, 3>(3, 0) -= F;
        G.block<3, 3>(3, 3) += skew(p.arm) * F;
        if (ground) G.topRows<6>().setZero(), G.leftCols<6>().setZero();
        K += 0.5 * (G + G.transpose());
    }

    double stored_in(std::size_t i, const Vec6& deformation, const Vec6& plastic) const {
        const Connector& c = declared()[i];
        const Vec6 elastic = deformation - plastic;
        double energy = 0.5 * elastic.dot(c.stiffness.cwiseProduct(elastic));
        for (int k = 0; k < 6; ++k) energy += on_curve(c.curve[k], deformation[k]).energy;
        return energy;
    }
    double stored(const State& state) const {
        const auto* there = state.data.find<ConnectorsNow>(connectors_effect);
        double energy = 0;
        for (std::size_t i = 0; there && i < there->list.size(); ++i)
            if (!there->list[i].broken)
                energy += stored_in(i, place(i, state, there->list[i]).deformation, there->list[i].plastic);
        return energy;
    }

    /// direction -1: its node is gone; 6: x and y together.
    void release(std::size_t i, double time, int direction) {
        ConnectorNow& c = list()[i];
        w_.state.accumulated["connector_dissipated"] += stored_in(i, c.deformation, c.plastic);
        c.broken = true;
        c.broken_at = time;
        host_.note_activation(connectors_effect, false, name_of(i) + how_it_broke(declared()[i], c, direction));
    }
    void changed(const Pose& at) {
        host_.accelerations_anew();
        host_.blocks_changed(at);
    }

    std::vector<Evaluated> now_;
    std::vector<double> damping_;  ///< s: beta of model:damping
};

void linear_connectors(Model& model) {
    if (model.declared<Connector>(connectors_effect).empty()) return;
    for (Connector& c : model.change_declared<Connector>(connectors_effect)) c.yield = c.ultimate = {};
}

std::vector<PlanLine> connectors_plan(const Structure& s, const RunKind&) {
    const std::size_t n = s.model().declared<Connector>(connectors_effect).size();
    return {{connectors_effect, n > 0, n == 0 ? "not declared" : std::to_string(n) + " by model:connector",
             s.model().asked_at(connectors_effect)}};
}

}  // namespace

EffectKind connectors_kind() {
    return {.name = connectors_effect,
            .accounts = {{"connectors", 70, "stored in connectors now, and dissipated by them", {}, false, true},
                         {"connector_stored", 71, "stored now in springs and curves of connectors", "connectors"},
                         {"connector_dissipated", 72, "work done on dashpots and laws, and released by breaks",
                          "connectors"}},
            .plan = connectors_plan,
            .make = [](Workspace& w, Host& host) -> std::unique_ptr<Effect> {
                if (w.structure.model().declared<Connector>(connectors_effect).empty()) {
                    w.state.data.erase(connectors_effect);
                    return nullptr;
                }
                return std::make_unique<Connectors>(w, host);
            },
            .leave_out = leave_out_declared<connectors_effect>,
            .linear = linear_connectors,
            .declarer = {.links =
                             [](const Model& model) {
                                 std::vector<NodeLink> list;
                                 for (const Connector& c : model.declared<Connector>(connectors_effect))
                                     list.push_back({c.a, c.b});
                                 return list;
                             },
                         .functions = [](const Model& model) -> std::vector<ScriptFunctions> {
                             const auto& list = model.declared<Connector>(connectors_effect);
                             if (std::none_of(list.begin(), list.end(), [](const Connector& c) { return c.has_law(); }))
                                 return {};
                             return {{5, "a connector's law", false, model.asked_at(connectors_effect)}};
                         }}};
}

}  // namespace hinge
