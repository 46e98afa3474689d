// Point masses on nodes. Each is added to its node's rigid offset mass; what that does is in broken_members.cpp.
#include "effects/point_mass.h"

#include <Eigen/Eigenvalues>
#include <algorithm>

#include "core/errors.h"
#include "effects/joints.h"
#include "effects/kinds.h"
#include "model/member_ends.h"

namespace hinge {
namespace {

/// How many of the model's point masses the state has: a run that goes on from another adds what was declared since.
struct Added {
    std::size_t count = 0;
    static constexpr bool in_state_hash = false;  ///< the offset masses are in it

    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.count);
    }
};

/// A mass that flies alone rotates about any axis: what it lacks of rotary inertia about one is set to this part of
/// that about another, as an offset mass that was a member has it, or follows from this part of the last member's
/// length.
constexpr double slender = 1e-3, small_radius = 1e-2;

/// Adds it to what a node carries.
void attach(const PointMass& m, OffsetMass& to) {
    to.mass += m.mass;
    to.moment += m.mass * m.offset;
    to.inertia += m.inertia.asDiagonal().toDenseMatrix() +
                  m.mass * (m.offset.squaredNorm() * Mat3::Identity() - m.offset * m.offset.transpose());
}

/// Explicit steps: a node that hangs on joints alone (Structure::hangs_on_joints) rotates by its own inertia. It has
/// that of the mean of its members' ends, and next to no mass.
void give_inertia(Workspace& w) {
    const Structure& s = w.structure;
    State& state = w.state;
    std::vector<double> inertia(s.model().nodes().size(), 0), mass = inertia;
    std::vector<int> ends(inertia.size(), 0);
    std::vector<char> has_rigid_end(inertia.size(), 0);  // at an offset, without a joint
    for (const MemberOffset& o : s.model().declared<MemberOffset>(member_offsets)) {
        const auto& joints = s.model().declared<Joint>(joints_effect);
        if (std::none_of(joints.begin(), joints.end(),
                         [&](const Joint& j) { return j.member == o.member && j.end == o.end; }))
            has_rigid_end[s.model().members()[o.member].node[o.end]] = 1;
    }
    for (const Element& e : s.elements())
        for (int end : {0, 1})
            if (const int n = s.declared_node(e.node[end]); n >= 0 && n != e.node[end] && s.hangs_on_joints(n)) {
                ++ends[n];
                inertia[n] += e.inertia.rotary[end].sum() / 3, mass[n] += e.mass();
            }
    constexpr double next_to_none = 1e-9;
    for (std::size_t n = 0; n < ends.size(); ++n) {
        if (ends[n] == 0 || state.gone[n]) continue;
        if (state.offset_mass.empty()) state.offset_mass.assign(state.displacement.size(), {});
        OffsetMass& at = state.offset_mass[n];
        if (at.inertia.trace() > 0) continue;  // from a run before, or of the script
        if (has_rigid_end[n]) continue;
        at.mass += next_to_none * mass[n], at.inertia += inertia[n] / ends[n] * Mat3::Identity();
    }
}

class PointMasses : public Effect, public BreakListener {
public:
    PointMasses(Workspace& w, Host& host) : Effect(point_mass_effect, w, host, {.mean_forces = true}) {
        Added* added = w.state.data.find<Added>(point_mass_effect);
        if (!added) added = &w.state.data.set(point_mass_effect, Added{});
        for (; added->count < declared().size(); ++added->count) add(declared()[added->count]);
    }

    /// A node that has lost its last member flies on.
    void broke(const Break& b) override {
        const Element& e = w_.structure.elements()[b.element];
        for (const int node : e.node)
            if (flies_alone(node)) make_turnable(node, e.length);
    }

    bool restored(std::span<const State* const> states) override {
        return std::all_of(states.begin(), states.end(), [&](const State* s) {
            return s->data.find<Added>(point_mass_effect)->count == declared().size() &&
                   s->offset_mass.size() == w_.structure.position().size();
        });
    }

private:
    const std::vector<PointMass>& declared() const {
        return w_.structure.model().declared<PointMass>(point_mass_effect);
    }

    void add(const PointMass& m) {
        State& s = w_.state;
        const bool on_support = w_.structure.is_alone(m.node) && has_member_at(w_.structure.model(), m.node);
        if (s.gone[m.node] && !on_support)
            throw InputError("model:mass: " + w_.structure.node_name(m.node) +
                             " has no member; a point mass needs one, and one that has not broken off, where a run "
                             "begins");
        if (s.offset_mass.empty()) s.offset_mass.assign(s.displacement.size(), {});
        attach(m, s.offset_mass[m.node]);
    }

    bool flies_alone(int node) const {
        const auto& at = w_.structure.elements_at(node);
        return std::any_of(declared().begin(), declared().end(), [&](const PointMass& m) { return m.node == node; }) &&
               std::all_of(at.begin(), at.end(), [&](int e) { return w_.state.broken[e] != 0; });
    }

    /// Spin about an axis through the centre of mass without rotary inertia is neither momentum nor energy: it ends,
    /// and an inertia takes its place. Where a support holds the node, it rotates about that.
    void make_turnable(int node, double length) {
        State& s = w_.state;
        OffsetMass& h = s.offset_mass[node];
        Vec3 arm = Vec3::Zero();
        if (!(s.held[node] & 7)) arm = h.moment / h.mass;
        const Mat3 about_centre = h.inertia - h.mass * (arm.squaredNorm() * Mat3::Identity() - arm * arm.transpose());
        const Eigen::SelfAdjointEigenSolver<Mat3> principal(about_centre);
        const double largest = principal.eigenvalues().maxCoeff(), rounding = 1e-9 * h.inertia.trace();
        const double least =
            largest > rounding ? slender * largest : h.mass * small_radius * length * small_radius * length;
        for (int i = 0; i < 3; ++i) {
            const double own = principal.eigenvalues()[i];
            if (own > std::max(slender * least, rounding)) continue;
            const Vec3 in_node = principal.eigenvectors().col(i), axis = s.rotation[node] * in_node;
            h.inertia += (least - own) * in_node * in_node.transpose();
            const Vec3 spin = s.velocity[node].tail<3>().dot(axis) * axis;
            s.velocity[node].head<3>() += spin.cross(s.rotation[node] * arm);
            s.velocity[node].tail<3>() -= spin;
        }
        host_.set_offset_mass(node, offset_mass_in_space(h, s.rotation[node]));
    }
};

std::vector<PlanLine> point_mass_plan(const Structure& s, const RunKind&) {
    const auto& masses = s.model().declared<PointMass>(point_mass_effect);
    const bool on = !masses.empty();
    return {{point_mass_effect, on, on ? std::to_string(masses.size()) + " on nodes" : "not declared",
             s.model().asked_at(point_mass_effect)}};
}

}  // namespace

EffectKind point_mass_kind() {
    return {.name = point_mass_effect,
            .plan = point_mass_plan,
            .make = [](Workspace& w, Host& host) -> std::unique_ptr<Effect> {
                std::unique_ptr<Effect> masses;
                if (!w.structure.model().declared<PointMass>(point_mass_effect).empty())
                    masses = std::make_unique<PointMasses>(w, host);
                if (w.kind.explicit_steps) give_inertia(w);
                return masses;
            },
            .leave_out = leave_out_declared<point_mass_effect>,
            .declarer = {.masses = [](const Model& model) {
                std::vector<AddedMass> list;
                for (const PointMass& m : model.declared<PointMass>(point_mass_effect)) {
                    list.push_back({m.node, {}});
                    attach(m, list.back().mass);
                }
                return list;
            }}};
}

}  // namespace hinge
