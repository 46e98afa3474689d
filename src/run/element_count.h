// elements = "auto": the number of elements of a member.
//
// One linear static solution of what the model declares (loads and gravity in full, without contact) says how far each
// member is compressed, and whether it yields inside. Two elements are exact for a member that does neither; the number
// is 2, 4, 8 or 16.
//
// Compression counts in large displacement. With n elements a pinned member buckles at (1 + e) times Euler's load P_E
// (README, "Columns in compression"), so at a compression P its bending stiffness 1 - P / P_E is P / ((1 + e) P_E) less
// in place of P / P_E. The difference, as a part of the stiffness without compression, is held within
// elements_accuracy. With p_delta = "member" two elements have it exactly; from Euler's load on a member gets four,
// which follow it as it bends out, and see the buckling between two clamped ends.
//
// Hinges stand at the ends of elements alone. Four elements go to a member where moments between its ends reach the
// fully plastic one, its ends carrying no more than theirs and compression adding its part; and to one with loads of
// its own that yields anywhere, because the moments at its ends count as if the loads acted on its nodes.
//
// The solution does not include impacts, motions of supports, loads that are functions of the state.
#pragma once

#include <string>
#include <vector>

#include "model/model.h"

namespace hinge {

/// Sets the number of elements of all undecided members; without any it does nothing. Bodies that supports do not hold
/// have no static solution and keep two.
void decide_elements(Model& model);

/// Members that elements = "auto" gave the same number for the same reason.
struct ElementGroup {
    int elements = 0, members = 0;
    std::string because;
};
std::vector<ElementGroup> element_groups(const Model& model);  ///< the most elements first; empty where none is "auto"

}  // namespace hinge
