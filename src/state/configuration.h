// Configuration of the nodes, of a state or on trial, and of one element: frame, deformation and tangent. The assembly
// computes eight elements at a time itself (element_assembly.h).
#pragma once

#include <optional>
#include <vector>

#include "beam/winding.h"
#include "state/state.h"

namespace hinge {

/// Trial configuration of the nodes: positions, velocities, accelerations.
struct Configuration {
    std::vector<Vec3> displacement;
    std::vector<Quat> rotation;
    std::vector<Vec3> small_rotation;
    std::vector<Vec6> velocity, acceleration;
    std::vector<double> twist;       ///< of the state that the step began with (State::twist)
    std::vector<TurnedEnds> turned;  ///< the same (State::turned)
    ElementHeats heat;               ///< empty where nothing is heated
};

/// Configuration of a state's nodes.
Configuration configuration_of(const State& state);

/// Reference to the node positions of a state or a configuration.
struct ConfigurationView {
    const std::vector<Vec3>& displacement;
    const std::vector<Quat>& rotation;
    const std::vector<Vec3>& small_rotation;
    const std::vector<double>& twist;
    const std::vector<TurnedEnds>& turned;
    const ElementHeats& heat;
    ConfigurationView(const State& s) : ConfigurationView(s, 0) {}
    ConfigurationView(const Configuration& p) : ConfigurationView(p, 0) {}

private:
    template <class T>
    ConfigurationView(const T& from, int)
        : displacement(from.displacement),
          rotation(from.rotation),
          small_rotation(from.small_rotation),
          twist(from.twist),
          turned(from.turned),
          heat(from.heat) {}
};

/// Frame of an element. If it is wound, its end rotations and y axes have no meaning: `wound` has its deformation.
struct ElementFrame : beam::ElementFrame<double> {
    std::optional<beam::Winding> wound;
};

/// Functions of one element, for its tangent and for output.
Mat3 axes_of(const beam::ElementFrame<double>& placement);  ///< columns: the local axes in space
ElementFrame element_frame(const Structure& structure, int element, const ConfigurationView& at);
/// Deformation d of timoshenko.h less what heat makes without force.
Vec6 element_deformation(const Structure& structure, int element, const ConfigurationView& at);
Vec6 element_deformation(const Structure& structure, int element, const ConfigurationView& at,
                         const ElementFrame& placement);
Eigen::Matrix<double, 12, 6> forces_at_nodes(const ElementFrame& placement);  ///< times p: nodal forces, in space
/// Element stiffness in space; large displacement: see beam/tangent.h.
Mat12 element_tangent(const ElementFrame& placement, const Vec6& p, const Mat6& k, bool geometric);

/// Vector from node 1 to node 2, m.
Vec3 chord_of(const Element& e, const std::vector<Vec3>& displacement);
/// Large displacement: rotation of the node at an end (0, 1), with the turn of that end by hinges.
Quat end_rotation(const Element& e, int index, int end, const ConfigurationView& at);
/// Input of winding.h for an element.
beam::Winding winding_of(const Element& e, int index, const ConfigurationView& at);

}  // namespace hinge
