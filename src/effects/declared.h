// Lists what a model declares, over all effects: loads, added masses, links between nodes, planes, functions of the
// script. Warnings, pictures, the summary and other effects ask here, and need to know no effect by its type.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/types.h"
#include "state/state.h"

namespace hinge {

class History;
class Model;

/// A load, or the motion of a support.
struct DeclaredLoad {
    std::string what;                  ///< "the load on node 3"
    std::string asked;                 ///< its name in Model::asked_at
    int node = -1, member = -1;        ///< where it acts
    const History* history = nullptr;  ///< null where it has none
    bool constant = true;              ///< neither a history nor a function
    int load_case = -1;
    Vec3 force = Vec3::Zero();   ///< N, of the whole load in space; zero where it is given in a member's axes
    Vec3 moment = Vec3::Zero();  ///< N m, of a load on a node
    bool motion = false;
    bool follows_state = false;  ///< a function of time and the run
};
std::vector<DeclaredLoad> declared_loads(const Model& model);

/// A mass that is rigidly attached to a node.
struct AddedMass {
    int node;
    OffsetMass mass;
};
std::vector<AddedMass> added_masses(const Model& model);
inline void add(const OffsetMass& more, OffsetMass& to) {
    to.mass += more.mass, to.moment += more.moment, to.inertia += more.inertia;
}

/// Two nodes that are joined other than by a member; -1: the ground.
struct NodeLink {
    int a, b;
};
std::vector<NodeLink> node_links(const Model& model);

struct DeclaredPlane {
    Vec3 point, normal;
};
std::vector<DeclaredPlane> declared_planes(const Model& model);

/// The acceleration of free fall, m/s^2; none where nothing gives one.
std::optional<Vec3> declared_gravity(const Model& model);

/// Functions of the script that a step calls.
struct ScriptFunctions {
    int place;             ///< the plan names those with the lowest
    std::string call;      ///< "a function in model:fracture"
    bool dynamic_only;     ///< statics does not call them
    std::string asked_at;  ///< the script's line
};
/// Rising by place.
std::vector<ScriptFunctions> script_functions(const Model& model);

/// Load cases of what is declared and is no load: heat, prestress.
std::vector<int> declared_cases(const Model& model);

/// Functions that list the declarations of one kind of effect; null for none.
struct Declarer {
    std::vector<DeclaredLoad> (*loads)(const Model& model) = nullptr;
    std::vector<AddedMass> (*masses)(const Model& model) = nullptr;
    std::vector<NodeLink> (*links)(const Model& model) = nullptr;
    std::vector<DeclaredPlane> (*planes)(const Model& model) = nullptr;
    std::optional<Vec3> (*gravity)(const Model& model) = nullptr;
    std::vector<ScriptFunctions> (*functions)(const Model& model) = nullptr;
    std::vector<int> (*cases)(const Model& model) = nullptr;
};

}  // namespace hinge
