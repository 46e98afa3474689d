#include "effects/joined_bodies.h"

#include "effects/declared.h"

namespace hinge {
namespace {

/// Those of the model, and the joints of members' ends.
std::vector<NodeLink> links_of(const Structure& structure) {
    std::vector<NodeLink> links = node_links(structure.model());
    const int declared = int(structure.model().nodes().size());
    for (int n = declared; n < declared + structure.joints(); ++n) links.push_back({structure.declared_node(n), n});
    return links;
}

}  // namespace

Bodies joined_bodies(const Structure& structure, const State& state) {
    Bodies bodies = find_bodies(structure, state);
    for (const NodeLink& link : links_of(structure)) {
        if (link.a < 0 || link.b < 0) continue;
        const int keep = bodies.of_node[link.a], gone = bodies.of_node[link.b];
        if (keep == gone || keep < 0 || gone < 0) continue;
        for (int& body : bodies.of_node)
            if (body == gone) body = keep;
    }
    return bodies;
}

std::vector<char> held_bodies(const Structure& structure, const State& state, const Bodies& bodies) {
    std::vector<char> held(bodies.count, 0);
    for (std::size_t n = 0; n < bodies.of_node.size(); ++n)
        if (bodies.of_node[n] >= 0 && (structure.has_panels_alone(int(n)) ? state.held[n] & 7 : state.held[n]))
            held[bodies.of_node[n]] = 1;
    for (const NodeLink& link : links_of(structure))
        for (const auto& [by, what] : {std::pair{link.a, link.b}, std::pair{link.b, link.a}})
            if (what >= 0 && bodies.of_node[what] >= 0 && (by < 0 || structure.is_alone(by)))
                held[bodies.of_node[what]] = 1;
    return held;
}

std::vector<char> carried_bodies(const Structure& structure, const State& state, const Bodies& bodies, const Vec3& g) {
    std::vector<char> carried(bodies.count, 0);
    for (std::size_t n = 0; n < bodies.of_node.size(); ++n)
        for (int c : {0, 1, 2})
            if (bodies.of_node[n] >= 0 && g[c] != 0 && state.held[n] >> c & 1) carried[bodies.of_node[n]] = 1;
    const std::vector<NodeLink> links = links_of(structure);
    for (bool more = true; more;) {
        more = false;
        for (const NodeLink& link : links) {
            // a node without elements carries where it is held
            const auto carries = [&](int node) {
                return node < 0 ||
                       (bodies.of_node[node] >= 0 ? carried[bodies.of_node[node]] != 0 : state.held[node] != 0);
            };
            for (const auto& [by, what] : {std::pair{link.a, link.b}, std::pair{link.b, link.a}}) {
                if (what < 0 || bodies.of_node[what] < 0 || carried[bodies.of_node[what]] || !carries(by)) continue;
                carried[bodies.of_node[what]] = 1;
                more = true;
            }
        }
    }
    return carried;
}

}  // namespace hinge
