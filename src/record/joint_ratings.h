// What each joint of a run has gone through, beside what it can take: for run:hinges, summary.json and pictures. And
// each connector that breaks at a force.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "effects/joints.h"
#include "state/joint_records.h"

namespace hinge {
class Run;
class Structure;
}  // namespace hinge

namespace hinge {

/// A quantity of a joint that has a limit or a law: the moment about an axis that is a spring, or a force at which the
/// joint or a connector breaks.
struct JointRating {
    enum Which : std::uint8_t { x, y, z, tension, shear, force_x, force_y, force_z, moment_x, moment_y, moment_z };
    int joint = 0;           ///< among those of the model: the joints, or the connectors
    bool connector = false;  ///< of it `which` is force_x or more, along and about its own axes; it has no `now`
    Which which = x;
    int element = 0, end = 1;               ///< the element that it stands at, and its end there, 1 or 2
    int node = 0;                           ///< the script's
    double force = 0, largest_force = 0;    ///< now, and the most so far: N m about an axis, else N
    double strength = JointAxis::infinite;  ///< N m or N; of a curve its last point
    double utilisation = 0;                 ///< force over what the strength is now; 0 without strength
    double largest = 0;                     ///< rad, about this axis, the most so far
    double demand = 0;                      ///< rad: of x and y that of both together, of z `largest`
    double capacity = JointAxis::infinite;  ///< rad, at which it breaks
    bool broken = false;                    ///< for whatever reason
    bool failed = false;                    ///< broken, or in statics beyond, by a limit of its own
    const JointState* now = nullptr;
    const JointRecord::Axis* record = nullptr;  ///< of an axis

    bool is_force() const { return which >= tension; }
    /// Largest rotation over the capacity, or largest force over the strength of what breaks by it; 0: no such limit.
    double of_own_limit() const { return is_force() ? largest_force / strength : largest / capacity; }
};

inline constexpr const char* joint_rating_names[] = {"x",       "y",       "z",        "tension",  "shear",   "force_x",
                                                     "force_y", "force_z", "moment_x", "moment_y", "moment_z"};

/// "joint at end a of member 3", "joint between nodes 4 and 9"
std::string joint_name(const Structure& structure, int joint);
/// "connector 2 between nodes 4 and 9", "connector 1 between the ground and node 4"
std::string connector_name(const Structure& structure, int connector);

/// Where a joint or a connector is: an element, its end there (1, 2), and the script's node. A joint or a connector
/// between nodes is at the first element of its second node.
struct JointPlace {
    int element, end, node;
};
JointPlace joint_place(const Structure& structure, int joint);
/// At its second node, or at its first where panels alone join that one; nothing where they alone join both.
std::optional<JointPlace> connector_place(const Structure& structure, int connector);

/// All of them, by joint in the order of declaration, then x, y, z, tension, shear; then connectors, of which each
/// direction with a capacity has one. Pins and rigid axes have none.
std::vector<JointRating> joint_ratings(const Run& run);

}  // namespace hinge
