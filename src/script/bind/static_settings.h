// The options of model:static as the settings of a static run.
#pragma once

#include "model/structure.h"
#include "run/static_settings.h"
#include "script/bind/model_box.h"

namespace hinge::script {

/// Throws InputError, naming the field, where one is out of range or has no meaning beside others. `goes_on`: the run
/// goes on from another.
StaticSettings read_static_settings(Options& o, const std::shared_ptr<ScriptModel>& model, const Structure& structure,
                                    bool goes_on);

}  // namespace hinge::script
