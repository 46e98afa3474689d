// A snapshot of a run as a script has it.
#pragma once

#include "output/picture.h"
#include "script/bind/model_box.h"

namespace hinge {
class Structure;
}

namespace hinge::script {

struct SnapshotBox {
    static constexpr const char* lua_name = "hinge.snapshot";
    output::Snapshot value;
    std::shared_ptr<const Structure> structure;
    std::shared_ptr<ScriptModel> model;
};

}  // namespace hinge::script
