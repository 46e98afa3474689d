#include "run/go_on.h"

#include "core/errors.h"

namespace hinge {
namespace {

/// Velocities that were given since the run before was made: of the target where it is now, and of the nodes inside the
/// members there as Structure::initial_velocity has them.
void take_velocities(State& state, const Structure& structure, const Model& before) {
    const Model& m = structure.model();
    std::vector<Vec6> velocity = state.velocity;
    std::vector<char> anew(velocity.size(), 0);
    for (std::size_t n = 0; n < m.nodes().size(); ++n) {
        const int given = m.velocity_given()[n];
        if (given == before.velocity_given()[n]) continue;
        const GivenVelocity& v = m.given_velocities()[given];
        const auto place = [&](int node) { return Vec3(structure.position()[node] + state.displacement[node]); };
        Vec3 centre = Vec3::Zero();
        for (int node : v.nodes) {
            if (state.gone[node] && !structure.is_alone(node))
                throw InputError("a velocity was given to " + structure.node_name(node) +
                                 ", which has no element left in the run that this one goes on from");
            centre += place(node) / double(v.nodes.size());
        }
        velocity[n] << v.linear + v.angular.cross(place(int(n)) - centre), v.angular;
        anew[n] = 1;
    }
    std::size_t inner = m.nodes().size();
    for (const MemberData& member : m.members())
        for (int end : {0, 1})
            if (member.has_joint(end)) {
                anew[inner] = anew[member.node[end]];
                velocity[inner] = velocity[member.node[end]];
                const Vec3 arm = structure.position()[inner] + state.displacement[inner] -
                                 structure.position()[member.node[end]] - state.displacement[member.node[end]];
                velocity[inner].head<3>() += Vec3(velocity[inner].tail<3>()).cross(arm);
                ++inner;
            }
    const std::vector<char> given = anew;
    for (std::size_t index = 0; index < m.members().size(); ++index) {
        const MemberData& member = m.members()[index];
        for (int i = 1; i < member.elements && given[member.node[0]] && given[member.node[1]]; ++i) {
            const double t = double(i) / member.elements;
            const int node = structure.inner_node(int(index), i);
            if (given[node]) continue;
            anew[node] = 1;
            velocity[node] = (1 - t) * velocity[member.node[0]] + t * velocity[member.node[1]];
        }
    }
    for (std::size_t n = 0; n < velocity.size(); ++n)
        for (int c = 0; c < 6 && anew[n]; ++c) state.velocity[n][c] = state.held[n] >> c & 1 ? 0 : velocity[n][c];
}

}  // namespace

std::optional<Refusal> refusal_to_go_on(const Run& before, const Structure& structure) {
    const State& from = before.state();
    const std::size_t nodes = structure.position().size(), elements = structure.elements().size();
    const Model &there = before.structure().model(), &here = structure.model();
    const bool same = there.nodes().size() == here.nodes().size() && there.members().size() == here.members().size();
    if (!same || from.displacement.size() != nodes || from.broken.size() != elements)
        return Refusal{"a run of a structure with " + std::to_string(from.displacement.size()) + " nodes and " +
                           std::to_string(from.broken.size()) + " elements",
                       "this model has " + std::to_string(nodes) + " and " + std::to_string(elements) +
                           "; add nothing between the runs"};
    if (before.structure().position() != structure.position())
        return Refusal{"", "model:imperfection has moved nodes since; it belongs before the first run"};
    for (std::size_t n = 0; n < here.nodes().size(); ++n)
        if (here.nodes()[n].fixed & ~there.nodes()[n].fixed)
            return Refusal{"", structure.node_name(int(n)) +
                                   " has been fixed since, and what goes on has it free; fix it before that run is "
                                   "made"};
    return {};
}

State state_to_go_on(const Run& before, const Structure& structure) {
    State state = before.state();
    state.step = 0;
    take_velocities(state, structure, before.structure().model());
    return state;
}

/// A velocity that no node can have.
void refuse_idle_velocities(const Structure& structure, const State& start) {
    const Model& m = structure.model();
    for (std::size_t n = 0; n < m.nodes().size(); ++n) {
        const int given = m.velocity_given()[n];
        if (given < 0 || m.given_velocities()[given].nodes.size() > 1) continue;
        const GivenVelocity& v = m.given_velocities()[given];
        Vec6 wanted;
        wanted << v.linear, v.angular;
        bool moves = wanted.isZero(0) || (start.gone[n] && !structure.is_alone(int(n)));
        for (int c = 0; c < 6; ++c) moves = moves || (wanted[c] != 0 && !(start.held[n] >> c & 1));
        if (!moves)
            throw InputError("a velocity was given to " + structure.node_name(int(n)) +
                             (structure.is_alone(int(n)) ? ", which belongs to no member"
                                                         : ", which supports hold in its directions"));
    }
}

}  // namespace hinge
