#include "state/bodies.h"

namespace hinge {

Bodies find_bodies(const Structure& structure, const State& state) {
    Bodies bodies;
    bodies.of_node.assign(structure.position().size(), -1);
    std::vector<int> reached;
    for (int start = 0; start < int(bodies.of_node.size()); ++start) {
        if (bodies.of_node[start] >= 0 || state.gone[start]) continue;
        reached.assign(1, start);
        bodies.of_node[start] = bodies.count;
        while (!reached.empty()) {
            const int node = reached.back();
            reached.pop_back();
            for (int e : structure.elements_at(node)) {
                if (state.broken[e]) continue;
                for (int next : structure.elements()[e].node)
                    if (bodies.of_node[next] < 0) bodies.of_node[next] = bodies.count, reached.push_back(next);
            }
        }
        ++bodies.count;
    }
    return bodies;
}

std::vector<std::vector<int>> nodes_of(const Bodies& bodies) {
    std::vector<std::vector<int>> nodes(bodies.count);
    for (std::size_t n = 0; n < bodies.of_node.size(); ++n)
        if (bodies.of_node[n] >= 0) nodes[bodies.of_node[n]].push_back(int(n));
    return nodes;
}

}  // namespace hinge
