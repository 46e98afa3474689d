// Columns that a bow follows: members in line are one column, and columns in line bow to opposite sides.
#pragma once

#include <vector>

#include "model/model.h"

namespace hinge::script {

/// A member of a column: from `begin` to `end` of the column's length, of which 0 is at one end and 1 at the other.
struct ColumnPart {
    int member;
    double begin, end;  ///< of the member's ends a and b
};

/// Members in line between two nodes that are held across the bow.
struct BowedColumn {
    std::vector<ColumnPart> parts;  ///< in line
    double length = 0;              ///< m
    Vec3 direction;                 ///< in space, of length 1
};

/// Puts members together to columns. Members are in line where two of them, and nothing else, meet at a node in one
/// line, with parallel section axes. Such a node is in a column unless a support or a link holds it across the bow, or
/// a joint is free to turn about the axis of bending. `axis`: the section's axis along which they bow, 0 or 1.
///
/// `opposite`: where two columns meet in line at a node that is held, and their bending goes on across it, they bow to
/// opposite sides: so does the mode in which they buckle between such nodes. In each line the lowest column (by z, then
/// x, then y) bows along the section's axis of its lowest member.
///
/// `place`: of the nodes without their imperfections, m.
std::vector<BowedColumn> bowed_columns(const Model& model, const std::vector<int>& members, int axis, bool opposite,
                                       const std::vector<Vec3>& place);

}  // namespace hinge::script
