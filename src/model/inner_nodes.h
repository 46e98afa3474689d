// Nodes inside members that the script has named: what it declares at nodes may be there too.
#pragma once

#include "model/model.h"

namespace hinge {

inline constexpr const char* inner_nodes = "inner nodes";

/// A node of the script in the place of the one that a member has after so many of its elements. The list of a model
/// is sorted by both.
struct InnerNode {
    int member, after, node;
    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.member, s.after, s.node);
    }
};

/// Index of the node between two elements of a member, which is declared when it is first asked for. `after`: the
/// number of elements before it, 1 to elements - 1. Throws InputError for another number, and for a member whose number
/// of elements a run chooses.
int name_inner_node(Model& model, int member, int after);

}  // namespace hinge
