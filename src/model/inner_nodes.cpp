#include "model/inner_nodes.h"

#include <algorithm>
#include <utility>

#include "core/errors.h"
#include "model/member_ends.h"

namespace hinge {

int name_inner_node(Model& model, int member, int after) {
    const MemberData& m = model.members()[member];
    if (m.elements_by != ElementsBy::script)
        throw InputError("member " + std::to_string(member + 1) +
                         " has elements = 'auto', so that a run chooses how many nodes are inside; give it a number of "
                         "elements");
    if (after < 1 || after >= m.elements)
        throw InputError("member " + std::to_string(member + 1) + " has " + std::to_string(m.elements) +
                         " elements and no node " + std::to_string(after) + " inside; must be 1 to " +
                         std::to_string(m.elements - 1));
    const auto find = [&](auto& list) {
        return std::lower_bound(list.begin(), list.end(), std::pair(member, after),
                                [](const InnerNode& n, auto& sought) { return std::pair(n.member, n.after) < sought; });
    };
    const auto& known = model.declared<InnerNode>(inner_nodes);
    if (const auto at = find(known); at != known.end() && at->member == member && at->after == after) return at->node;
    const double t = double(after) / m.elements;
    const int node =
        model.add_node((1 - t) * end_position(model, member, 0) + t * end_position(model, member, 1) + m.offset(after));
    auto& list = model.change_declared<InnerNode>(inner_nodes);
    list.insert(find(list), {member, after, node});
    return node;
}

}  // namespace hinge
