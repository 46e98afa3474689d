-- Cross-sections by their dimensions: reads and checks them; src/section/shapes.cpp has the formulas.
--
-- x and y are the section's axes, y along the member's `up`. Each function returns the table that core.section takes:
-- area (m^2), Ix, Iy, J (m^4), shear_area_x and shear_area_y (m^2), plastic = { A, Zx, Zy, Zz } (m^2, m^3: fully
-- plastic resultant over yield stress; Zz over yield stress / sqrt 3), size = { width, depth } (m, along x and y; of an
-- H also web and flange, for pictures), outline (m), interaction and kind. core.shape has more shapes, for names and
-- imports: "tee", "double angle" and "tapered".
local check = require "hinge.library.check"
local core = require "hinge.core"

local length = { "number", unit = "m", above = 0 }
local optional_length = { "number", unit = "m", above = 0, optional = true }
local radius = { "number", unit = "m", at_least = 0, optional = true }

local function box_walls(where, o)
  if o.thickness and (o.web or o.flange) then
    check.fail("%s: fields 'thickness' and '%s' are both given; give thickness (m), or web and flange (m)", where,
      o.web and "web" or "flange")
  elseif not o.thickness and not (o.web and o.flange) then
    check.fail("%s: field '%s' is missing; give thickness, a number above 0 m, or both web and flange", where,
      o.web and "flange" or o.flange and "web" or "thickness")
  elseif o.r_inner and not o.r then
    check.fail("%s: field 'r' is missing; give the corners' outer radius (m) with r_inner", where)
  end
end

local fields = {
  solid = { width = length, depth = length },
  box = { width = length, depth = length, thickness = optional_length, web = optional_length, flange = optional_length,
    r = radius, r_inner = radius },
  h = { depth = length, width = length, web = length, flange = length, r = radius },
  channel = { depth = length, width = length, web = length, flange = length, r = radius, r_toe = radius,
    slope = { "number", at_least = 0, below = 0.5, default = 0 }, flange_at = optional_length },
  angle = { depth = length, width = length, thickness = length, r = radius, r_toe = radius },
  pipe = { diameter = length, thickness = length },
  round = { diameter = length },
}

local shapes = {}
for kind, of in pairs(fields) do
  of.interaction = { "string", one_of = { "paper", "exact", "exact with shear" }, optional = true }
  shapes[kind] = function(options)
    local where = "hinge.section." .. kind
    local o = check.options(where, options, of)
    if kind == "box" then box_walls(where, o) end
    local made = core.shape(kind, o, where)
    made.interaction = o.interaction
    return made
  end
end

return shapes
