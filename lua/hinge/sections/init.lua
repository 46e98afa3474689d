-- Cross-sections for members: ready shapes by their dimensions, by their names, or any section by its properties.
local core = require "hinge.core"
local check = require "hinge.library.check"
local shapes = require "hinge.sections.shapes"

local section = { general = core.section }
for name, properties in pairs(shapes) do
  section[name] = function(options, ...)
    check.no_more("hinge.section." .. name, ...)
    return core.section(properties(options))
  end
end

function section.concrete(options, ...)
  check.no_more("hinge.section.concrete", ...)
  return core.section(require "hinge.sections.concrete".properties(options))
end

function section.named(name, options, ...)
  check.no_more("hinge.section.named", ...)
  return core.section(require "hinge.sections.named".properties(name, options))
end

function section.names(family, ...)
  check.no_more("hinge.section.names", ...)
  return require "hinge.sections.named".names(family)
end

return check.strict(section, "hinge.section")
