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

}  // namespace hinge
