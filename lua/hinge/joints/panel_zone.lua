-- hinge.joint.panel_zone: the web of a column between the flanges of beams, in shear. Three straight lines as
-- Krawinkler (1978) and Gupta and Krawinkler (1999) have them. Lengths in m, forces in N.
local core = require "hinge.core"
local check = require "hinge.library.check"
local parts = require "hinge.standards.en_1993_1_8.parts"

local where = "hinge.joint.panel_zone"

local rules = {
  column = { "table" }, beam_depth = parts.length, doubler = parts.with(parts.no_length, { default = 0 }),
  storey_height = parts.some_length, hardening = { "number", at_least = 0, below = 1, default = 0 },
  capacity = { "number", unit = "rad", above = 0, optional = true },
}
local column_rules = { section = { "section" }, yield_stress = parts.stress }

--- hinge.joint.panel_zone
return function(options, ...)
  check.no_more(where, ...)
  local o = check.options(where, options, rules)
  o.column = parts.options(where, o, "column", column_rules)
  if o.storey_height and not (o.storey_height > o.beam_depth) then
    check.fail("%s: field 'storey_height' is %s m; must be more than the depth of the beam, %s m", where,
      check.show(o.storey_height), check.show(o.beam_depth))
  end
  local c = parts.h(where, o, "column")
  local db, t, G = o.beam_depth, c.tw + o.doubler, parts.E / 2.6
  local area = 0.95 * c.h * t -- in shear
  local n = { thickness = t, shear = 0.55 * c.fy * c.h * t }
  n.distortion = n.shear / (G * area)
  -- the flanges bend at the corners, until four times the distortion
  n.flanges = 3 * n.distortion * 0.95 * G * c.b * c.tf ^ 2 / db
  n.full_shear = n.shear + n.flanges
  -- the moments of the beams at the middle of the joint, less the shear of the column
  n.lever_arm = db / (1 - (o.storey_height and db / o.storey_height or 0))
  n.stiffness, n.moment = G * area * n.lever_arm, n.full_shear * n.lever_arm
  n.points = { { n.distortion, n.shear * n.lever_arm }, { 4 * n.distortion, n.moment } }
  if o.hardening > 0 then -- up to a distortion that no joint reaches
    n.points[3] = { 1 + 4 * n.distortion, n.moment + o.hardening * n.stiffness }
  end
  n.capacity = o.capacity
  return core.joint { Mx = { points = n.points, capacity = o.capacity } }, n
end
