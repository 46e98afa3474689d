// Snapshot of a run at one instant, for pictures and frames.
#pragma once

#include "output/picture.h"
#include "script/lua/objects.h"

namespace hinge::script {

struct SnapshotBox {
    static constexpr const char* lua_name = "hinge.snapshot";
    output::Snapshot value;
    std::shared_ptr<const Structure> structure;
    std::shared_ptr<ScriptModel> model;
};

/// Elements as bars; a broken one as the rigid bar from the node that carries it to its virtual node (paper, fig 4).
output::Snapshot make_snapshot(const Run& run);

}  // namespace hinge::script
