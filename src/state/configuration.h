// Frame, deformation and tangent of one element at a pose. The assembly computes eight elements at a time itself
// (element_assembly.h).
#pragma once

#include <optional>
#include <vector>

#include "beam/winding.h"
#include "state/state.h"

namespace hinge {

/// Frame of an element. If it is wound, its end rotations and y axes have no meaning: `wound` has its deformation.
struct ElementFrame : beam::ElementFrame<double> {
    std::optional<beam::Winding> wound;
};

/// Functions of one element, for its tangent and for output.
Mat3 axes_of(const beam::ElementFrame<double>& placement);  ///< columns: the local axes in space
ElementFrame element_frame(const Structure& structure, int element, const Pose& at);
/// Deformation d of timoshenko.h less what heat makes without force.
Vec6 element_deformation(const Structure& structure, int element, const Pose& at);
Vec6 element_deformation(const Structure& structure, int element, const Pose& at, const ElementFrame& placement);
Eigen::Matrix<double, 12, 6> forces_at_nodes(const ElementFrame& placement);  ///< times p: nodal forces, in space
/// Rates of an element's deformation from the velocities of its nodes, and the nodal forces of p; both in space.
Vec6 deformation_rates(const ElementFrame& placement, const Vec6& first, const Vec6& second);
Vec12 nodal_forces(const ElementFrame& placement, const Vec6& p);
/// Element stiffness in space; large displacement: see beam/tangent.h.
Mat12 element_tangent(const ElementFrame& placement, const Vec6& p, const Mat6& k, bool geometric);

/// Vector from node 1 to node 2, m.
Vec3 chord_of(const Element& e, const std::vector<Vec3>& displacement);
/// Large displacement: rotation of the node at an end (0, 1), with the turn of that end by hinges.
Quat end_rotation(const Element& e, int index, int end, const Pose& at);
/// Input of winding.h for an element.
beam::Winding winding_of(const Element& e, int index, const Pose& at);

}  // namespace hinge
