// Values that a script makes before any model: materials, sections, backbones.
#pragma once

#include "model/model.h"
#include "script/lua/lua_support.h"

namespace hinge::script {

struct MaterialBox {
    static constexpr const char* lua_name = "hinge.material";
    std::shared_ptr<const Material> value;
};
struct SectionBox {
    static constexpr const char* lua_name = "hinge.section";
    std::shared_ptr<const Section> value;
};
struct BackboneBox {
    static constexpr const char* lua_name = "hinge.backbone";
    std::shared_ptr<const beam::MaterialLaw> value;
};

}  // namespace hinge::script
