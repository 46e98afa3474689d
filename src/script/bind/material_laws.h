// The fields `hardening` and `rate` of hinge.material.
#pragma once

#include "model/model.h"
#include "script/lua/options.h"
#include "script/lua/model_registry.h"

namespace hinge::script {

/// The laws that the table declares for the material `m`, of which E and yield_stress are read already.
std::vector<std::shared_ptr<const beam::MaterialLaw>> read_material_laws(Options& o, const Material& m);

/// A backbone that the script gives as a function (largest, x, y in rad, work in J), which returns the strength.
std::shared_ptr<const beam::MaterialLaw> own_backbone(const LuaFunction& f);
/// The field `law` of a member: { variables =, step = function(flow, history) } or that function; null where nil.
std::shared_ptr<const beam::MaterialLaw> read_own_law(Options& member, const std::shared_ptr<Model>& model);

}  // namespace hinge::script
