// The fields `hardening` and `rate` of hinge.material, `law` of model:member.
#pragma once

#include "model/model.h"
#include "script/lua/options.h"
#include "script/lua/model_registry.h"

namespace hinge::script {

/// The laws that the table declares for the material `m`, of which E and yield_stress are read already.
std::vector<std::shared_ptr<const beam::MaterialLaw>> read_material_laws(Options& o, const Material& m);

/// The field `law` of a member: { variables =, step = function(flow, history) } or that function; null where nil.
std::shared_ptr<const beam::MaterialLaw> read_own_law(Options& member, const std::shared_ptr<Model>& model);

}  // namespace hinge::script
