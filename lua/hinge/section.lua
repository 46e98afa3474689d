-- Cross-sections for members: ready shapes by their dimensions, or any section by its properties.
local core = require "hinge.core"
local check = require "hinge.check"
local shapes = require "hinge.shapes"

local section = { general = core.section }
for name, properties in pairs(shapes) do
  section[name] = function(options, ...)
    check.no_more("hinge.section." .. name, ...)
    return core.section(properties(options))
  end
end

return check.strict(section, "hinge.section")
