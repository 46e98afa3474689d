// What run:along and member:along read.
#pragma once

struct lua_State;

namespace hinge {
class Run;
}

namespace hinge::script {

/// Leaves a list on the stack: the resultants along the elements from `first` on, a member, at `stations` equal parts
/// of its length and where they are extreme. Broken elements have no rows.
int push_along(lua_State* L, const Run& run, int first, int count, int stations);

}  // namespace hinge::script
