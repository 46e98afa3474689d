// Reads the settings of a picture from a script.
#pragma once

#include "script/bind/snapshot_box.h"

namespace hinge::script {

/// Reads the table at `index`, whose fields are those of hinge.view. `snapshot`: what will be drawn; `box`: the
/// script's own, null for one that was read from a file. Throws InputError naming the field.
output::View read_view(lua_State* L, int index, const output::Snapshot& snapshot, const SnapshotBox* box);

}  // namespace hinge::script
