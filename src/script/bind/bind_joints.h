// The fields `ends`, `release` and `offset` of model:member, and what member:joint reads.
#pragma once

#include <array>
#include <optional>

#include "effects/joints.h"
#include "script/lua/options.h"

namespace hinge {
class Model;
class Run;
}  // namespace hinge

namespace hinge::script {

/// The joints at both ends of a member, by the fields `ends` and `release`.
std::array<std::optional<JointProperties>, 2> read_joints(Options& o);

/// Declares the joints of a member that the model has accepted.
void declare_joints(lua_State* L, Model& m, int member, const std::array<std::optional<JointProperties>, 2>& joints);

/// Where both ends of a member stand off their nodes, by the field `offset`, m.
std::array<std::optional<Vec3>, 2> read_offsets(Options& o);
void declare_offsets(lua_State* L, Model& m, int member, const std::array<std::optional<Vec3>, 2>& offsets);
/// Leaves them on the stack, { a = {x, y, z}, b = }; nil where it has none.
void push_offsets_of(lua_State* L, const Model& m, int member);

/// Leaves the joints of a member on the stack, { a = , b = }; nil where it has none.
void push_joints_of(lua_State* L, const Model& m, int member);

/// Leaves a joint of a run on the stack as a table; nil where the end has none.
void push_joint(lua_State* L, const Run& run, int member, int end);

}  // namespace hinge::script
