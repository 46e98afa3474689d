// Supports that move along a path of the script's own, and the work that they do.
#include "effects/moving_supports.h"

#include <algorithm>

#include "effects/joints.h"
#include "core/rotation.h"
#include "effects/kinds.h"
#include "state/node_mass.h"

namespace hinge {
namespace {

class MovingSupports : public Effect, public Prescriber, public MatrixWatcher, public StepLimiter {
public:
    MovingSupports(Workspace& w, Host& host) : Effect(moving_supports_effect, w, host) {
        const auto& motions = w.structure.model().declared<SupportMotion>(moving_supports_effect);
        traits_.calls_script = std::any_of(motions.begin(), motions.end(), [](const SupportMotion& m) {
            return m.displacement && !m.displacement.points();
        });
        for (const SupportMotion& m : motions) {
            const double begin = w.state.time, speed = w.state.velocity[m.node][m.component];
            Moved moved{m.node, m.component, [path = m.displacement, begin, speed](double t) {
                            return t < begin ? path(begin) + speed * (t - begin) : path(t);
                        }};
            moved.joined = joined_to(m.node);
            moved_.push_back(std::move(moved));
            for_each_element(moved_.back(), true, [&](int e, int) { matrices_[e] = {Mat12::Zero(), Mat6::Zero()}; });
        }
    }

    /// Velocity and acceleration by differences backwards, of second order: a motion is evaluated once a step.
    void begin(const Step& step) override {
        const double dt = step.dt;
        for (Moved& m : moved_) {
            if (is_gone(m)) continue;
            if (!m.begun) {
                m.now = m.turns() ? 0 : w_.state.displacement[m.node][m.component];
                m.from = m.path(w_.state.time) - m.now;
                m.begun = true;
            }
            if (m.apart != dt) {
                m.before = m.path(w_.state.time - dt) - m.from;
                m.long_before = m.path(w_.state.time - 2 * dt) - m.from;
                m.apart = dt;
            }
            m.next = m.path(w_.state.time + dt) - m.from;
            m.speed = (3 * m.next - 4 * m.now + m.before) / (2 * dt);
            m.acceleration = (2 * m.next - 5 * m.now + 4 * m.before - m.long_before) / (dt * dt);
        }
    }

    void list_prescribed(std::vector<DegreeOfFreedom>& list) const override {
        for (const Moved& m : moved_)
            if (!is_gone(m)) list.push_back({m.node, m.component});
    }

    /// The trial has the supports at their places at the end of the step; their rows of the solution stay zero.
    void predicted(const Step&) override {
        for (const Moved& m : moved_) {
            if (is_gone(m)) continue;
            if (m.turns()) turn(m);
            else w_.trial.displacement[m.node][m.component] = m.next;
            w_.trial.velocity[m.node][m.component] = m.speed;
            w_.trial.acceleration[m.node][m.component] =
                w_.scheme.weighted(w_.state.acceleration[m.node][m.component], m.acceleration);
        }
    }

    /// The force by which a support is moved: that at the pose from which the step was solved, and what the solution
    /// added. Long steps recompute it at their end (recovered_last).
    void corrected(const Step& step, const std::vector<Vec6>& change) override {
        predicted(step);
        for (Moved& m : moved_) {
            double& force = w_.reaction[m.node][m.component];
            if (!w_.kind.explicit_steps)
                for_each_element(m, false, [&](int e, int end) {
                    const Element& element = w_.structure.elements()[e];
                    Vec12 of_element;
                    of_element << change[element.node[0]], change[element.node[1]];
                    const ElementPart& part = matrices_.at(e);
                    force += part.A.row(6 * end + m.component).dot(of_element);
                    if (element.partner < 0 || (e < element.partner) != (end == 0))
                        return;  // not the pair's outer node
                    const int far = w_.structure.elements()[element.partner].node[1 - end];
                    force += part.bridge.row(m.component).dot(change[far]);
                });
            else if (!is_tied(m)) force += momentum_at(m, w_.trial.acceleration, false);
            m.next_force = force;
        }
    }

    /// R - F where the step ends, of all that joins the support, connectors too. R has the acceleration at the end, eq
    /// 15 Bossak's weighted one.
    void recovered_last() override {
        for (Moved& m : moved_) {
            if (is_gone(m)) continue;
            double& force = w_.reaction[m.node][m.component];
            force = w_.resisting[m.node][m.component] - w_.external[m.node][m.component];
            if (w_.scheme.alpha != 0) force += momentum_at(m, w_.next_weighted) - momentum_at(m, w_.trial.acceleration);
            m.next_force = force;
        }
    }

    bool watches_matrix(int element) const override { return matrices_.count(element) > 0; }
    void matrix_built(int element, const ElementPart& part) override { matrices_.at(element) = part; }

    /// By the trapezium rule, as if velocity and place followed from the accelerations as a free node's do; and what
    /// they do beyond that, so that a path may set off at once. With v' = v'_N + j and u' = u'_N + k, V the mean
    /// velocity, dv_N as Newmark has it and b the mean Bossak-weighted acceleration: j (M V) + j/2 (M dv_N) - k (M b).
    void accumulate_energy(const Step& step, Accounts& sums) const override {
        const double dt = step.dt;
        const Scheme& scheme = w_.scheme;
        const bool damped = scheme.alpha != 0;
        const State& s = w_.state;
        double work = 0;
        for (const Moved& m : moved_) {
            if (is_gone(m)) continue;
            work += 0.5 * (m.force + m.next_force) * (m.next - m.now);
            const double v = s.velocity[m.node][m.component], a = s.acceleration[m.node][m.component],
                         next_a = w_.trial.acceleration[m.node][m.component];
            const double j = m.speed - v - scheme.velocity_change(a, next_a, dt),
                         k = m.next - m.now - dt * v - scheme.displacement_beyond_velocity(a, next_a, dt);
            const double mv = 0.5 * (momentum_at(m, s.velocity) + momentum_at(m, w_.trial.velocity));
            const double mdv =
                scheme.velocity_change(momentum_at(m, s.acceleration), momentum_at(m, w_.trial.acceleration), dt);
            const double mb = 0.5 * (momentum_at(m, damped ? w_.weighted : s.acceleration) +
                                     momentum_at(m, damped ? w_.next_weighted : w_.trial.acceleration));
            work += j * mv + 0.5 * j * mdv - k * mb;
        }
        sums["work"] += work;
    }

    void before_commit(const Step&) override {
        for (Moved& m : moved_) {
            if (is_gone(m)) continue;
            m.force = m.next_force;
            m.long_before = m.before, m.before = m.now, m.now = m.next;
        }
    }

    double work_of_supports(const std::vector<Vec6>& supports, const std::vector<Vec6>& velocity) const override {
        double work = 0;
        for (const Moved& m : moved_)
            if (!is_gone(m)) work += supports[m.node][m.component] * momentum_at(m, velocity);
        return work;
    }

    // The recomputed acceleration keeps that of the supports, which is given.
    void keep_acceleration() override {
        for (Moved& m : moved_) m.given = w_.state.acceleration[m.node][m.component];
    }
    void prescribe(std::vector<Vec6>& acceleration) const override {
        for (const Moved& m : moved_) acceleration[m.node][m.component] = m.given;
    }
    void acceleration_found() override {
        std::vector<Vec6>& acceleration = w_.state.acceleration;
        for (Moved& m : moved_) {
            m.force = w_.reaction[m.node][m.component];
            // in implicit steps the support's own mass is in its reaction
            acceleration[m.node][m.component] = w_.kind.explicit_steps ? m.given : 0;
            if (!w_.kind.explicit_steps || !is_tied(m)) m.force += momentum_at(m, acceleration, false);
        }
        prescribe(acceleration);
    }

    bool allows_long_step() const override { return false; }
    void keep_from_rest(const Bodies& bodies, std::vector<char>& rests) const override {
        for (const Moved& m : moved_)
            if (bodies.of_node[m.node] >= 0) rests[bodies.of_node[m.node]] = 0;
    }

    void save(Writer& to) const override { fields(*this, to); }
    void restore(Reader& from) override { fields(*this, from); }

private:
    /// A member's end, or a node, that a joint joins to the support.
    struct JoinedEnd {
        std::size_t joint;
        int node;
    };
    /// A degree of freedom of a support that moves: where it is now and was one and two steps ago, m, and how long a
    /// step is, s; where the step takes it, m, m/s, m/s^2; the force that moves it, N. Rotations in rad, N m.
    struct Moved {
        int node, component;
        History path;
        bool turns() const { return component >= 3; }
        std::vector<JoinedEnd> joined = {};
        double from = 0, now = 0, before = 0, long_before = 0, apart = 0, next = 0, speed = 0, acceleration = 0,
               force = 0, next_force = 0;
        bool begun = false;
        double given = 0;  ///< its acceleration, while others are recomputed
    };
    template <class Self, class A>
    static void fields(Self& s, A& a) {
        for (auto& m : s.moved_) {
            a(m.from, m.now, m.before, m.long_before, m.apart, m.next, m.speed, m.acceleration, m.force, m.next_force,
              m.begun);
            s.for_each_element(m, true, [&](int e, int) { a(s.matrices_.at(e).A, s.matrices_.at(e).bridge); });
        }
    }

    std::vector<JoinedEnd> joined_to(int node) const {
        const Model& model = w_.structure.model();
        const auto& joints = model.declared<Joint>(joints_effect);
        std::vector<JoinedEnd> list;
        for (std::size_t i = 0; i < joints.size(); ++i) {
            const Joint& j = joints[i];
            const int from = j.is_between_nodes() ? j.from : model.members()[j.member].node[j.end];
            if (from == node) list.push_back({i, j.is_between_nodes() ? j.to : w_.structure.end_node(j.member, j.end)});
        }
        return list;
    }
    bool is_whole(const JoinedEnd& end) const {
        return !w_.state.data.find<JointStates>(joints_effect)->list[end.joint].broken;
    }
    /// Whether the support has lost all of its members, and does not move any more. One to which nothing but joints
    /// joins members moves on.
    bool is_gone(const Moved& m) const { return w_.state.gone[m.node] && !w_.structure.is_alone(m.node); }
    /// Whether joints tie ends to the support: in explicit steps their reactions have the inertia of both.
    bool is_tied(const Moved& m) const {
        return std::any_of(m.joined.begin(), m.joined.end(), [&](const JoinedEnd& end) { return is_whole(end); });
    }
    /// Calls f(element, its end at the support), for elements that are whole and at the support or joined to it; or for
    /// `all` of them.
    template <class F>
    void for_each_element(const Moved& m, bool all, F f) const {
        const auto at = [&](int node) {
            for (const int e : w_.structure.elements_at(node))
                if (all || !w_.state.broken[e]) f(e, w_.structure.elements()[e].node[0] == node ? 0 : 1);
        };
        at(m.node);
        if (m.turns()) return;  // joints tie places alone
        for (const JoinedEnd& end : m.joined)
            if (all || is_whole(end)) at(end.node);
    }

    /// The step rotates the trial by what is prescribed, and about the other axes as predicted or solved for.
    void turn(const Moved& m) {
        const int n = m.node;
        w_.rotation_step[n][m.component - 3] = m.next - m.now;
        if (w_.structure.large()) w_.trial.rotation[n] = rotated(w_.rotation_step[n], w_.state.rotation[n]);
        else w_.trial.small_rotation[n] = w_.state.small_rotation[n] + w_.rotation_step[n];
    }

    /// The row of M of a support's degree of freedom, times such a value of each node; with or without the masses that
    /// are attached to it.
    double momentum_at(const Moved& m, const std::vector<Vec6>& of, bool offsets = true) const {
        const int c = m.component;
        const State& s = w_.state;
        if (m.turns()) return spin_momentum_at(m, of, offsets);
        double sum = 0;
        if (offsets && !s.offset_mass.empty()) {
            sum = s.offset_mass[m.node].mass * of[m.node][c];
            for (const JoinedEnd& end : m.joined)
                if (is_whole(end)) sum += s.offset_mass[end.node].mass * of[m.node][c];
        }
        for_each_element(m, false, [&](int e, int end) {
            const beam::Inertia& inertia = inertia_now(w_.structure, w_.state, e);
            sum += inertia.own[end] * of[m.node][c] + inertia.across * of[w_.structure.elements()[e].node[1 - end]][c];
        });
        return sum;
    }

    double spin_momentum_at(const Moved& m, const std::vector<Vec6>& of, bool offsets) const {
        const State& s = w_.state;
        double sum = 0;
        if (offsets && !s.offset_mass.empty())
            sum = offset_mass_in_space(s.offset_mass[m.node], s.rotation[m.node]).row(m.component).dot(of[m.node]);
        for_each_element(m, false, [&](int e, int end) {
            const beam::Inertia& inertia = inertia_now(w_.structure, s, e);
            const Mat3 axes = axes_of(element_frame(w_.structure, e, s));
            const auto times = [&](const Vec3& rotary, int node) -> Vec3 {
                return axes * rotary.cwiseProduct(axes.transpose() * of[node].tail<3>());
            };
            const int other = w_.structure.elements()[e].node[1 - end];
            sum += (times(inertia.rotary[end], m.node) + times(inertia.rotary_across, other))[m.component - 3];
        });
        return sum;
    }

    std::vector<Moved> moved_;
    std::unordered_map<int, ElementPart> matrices_;  ///< of the elements at moved supports
};

std::vector<PlanLine> moving_supports_plan(const Structure& s, const RunKind&) {
    const bool moves = !s.model().declared<SupportMotion>(moving_supports_effect).empty();
    return {{moving_supports_effect, moves, moves ? "model:move" : "supports do not move",
             moves ? s.model().asked_at("ground") : ""}};
}

}  // namespace

void add_motion(Model& model, SupportMotion motion) {
    model.fix(motion.node, 1 << motion.component);
    model.declare(moving_supports_effect, std::move(motion));
}

EffectKind moving_supports_kind() {
    return {.name = moving_supports_effect,
            .plan = moving_supports_plan,
            .make = [](Workspace& w, Host& host) -> std::unique_ptr<Effect> {
                if (w.structure.model().declared<SupportMotion>(moving_supports_effect).empty()) return nullptr;
                return std::make_unique<MovingSupports>(w, host);
            },
            .dynamic_only = true,
            .declarer = {.loads = [](const Model& model) {
                std::vector<DeclaredLoad> list;
                for (const SupportMotion& m : model.declared<SupportMotion>(moving_supports_effect)) {
                    DeclaredLoad motion{"the motion of node " + std::to_string(m.node + 1) +
                                            (m.component < 3 ? " along " : " about ") + "xyz"[m.component % 3],
                                        "motion of node " + std::to_string(m.node), m.node};
                    motion.history = &m.displacement, motion.constant = false, motion.motion = true;
                    list.push_back(std::move(motion));
                }
                return list;
            }}};
}

}  // namespace hinge
