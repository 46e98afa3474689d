-- hinge.material: a function that makes a material, and a table of those that make one by its name.
local core = require "hinge.core"
local check = require "hinge.library.check"

local material = {}
for _, kind in ipairs { "steel", "aluminium", "timber", "concrete", "bars" } do
  material[kind] = function(name, options, ...)
    check.no_more("hinge.material." .. kind, ...)
    return core.material(require "hinge.sections.grades"[kind](name, options))
  end
end

function material.names(kind, ...)
  check.no_more("hinge.material.names", ...)
  return require "hinge.sections.grades".names(kind)
end

return check.strict(material, "hinge.material", core.material)
