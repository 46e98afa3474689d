// A shape in which a structure vibrates or buckles, as a script has it.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/types.h"
#include "script/bind/run_box.h"

namespace hinge::script {

/// A shape of a run.
struct ModeBox {
    static constexpr const char* lua_name = "hinge.mode";
    std::shared_ptr<ScriptRun> record;
    std::vector<Vec6> shape;
    std::optional<double> factor;  ///< of buckling; none: a natural mode
    double omega_squared = 0;
    Vec3 participation = Vec3::Zero();
    Vec3 share = Vec3::Zero();  ///< effective masses over the whole mass
};

}  // namespace hinge::script
