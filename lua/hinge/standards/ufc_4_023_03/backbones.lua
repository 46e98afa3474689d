-- hinge.backbone.ufc: UFC 4-023-03, table 5-2, as the public program soconnell345-geotech/geotech-references
-- (ufc_collapse) has it; the standard was not at hand. Table 11 of GSA's guidelines of 2016 has the same numbers.
-- Acceptance: a for primary members, b for secondary ones. The shear tab's depth is that of its bolt group.
local check = require "hinge.library.check"
local shared = require "hinge.sections.backbone_laws"
local asce_41 = require "hinge.standards.asce_41.backbones"

local rules = shared.rules

-- a, b and c: see standards/asce_41/backbones.lua.
local table_5_2 = {
  RBS = { a = { 0.050, -0.0003 }, b = { 0.070, -0.0003 }, c = 0.2 },
  WUF = { a = { 0.0284, -0.0004 }, b = { 0.043, -0.0006 }, c = 0.2 },
  ["improved WUF"] = { a = { 0.021, -0.0003 }, b = { 0.050, -0.0006 }, c = 0.2 },
  SidePlate = { a = { 0.089, -0.0005 }, b = { 0.169, -0.0001 }, c = 0.6 },
  ["shear tab"] = { a = { 0.0502, -0.0015 }, b = { 0.1125, -0.0027 }, c = 0.2 },
}

--- hinge.backbone.ufc
return function(options, ...)
  local where = "hinge.backbone.ufc"
  check.no_more(where, ...)
  local o = check.options(where, options, {
    kind = { "string", one_of = { "RBS", "WUF", "improved WUF", "SidePlate", "shear tab" } }, depth = rules.length,
    strength = { "number", at_least = shared.least, optional = true },
    role = { "string", one_of = { "primary", "secondary" }, default = "primary" },
    yield_rotation = { "number", unit = "rad", above = 0, optional = true } })
  local strength = o.strength
  if not strength then
    if o.kind == "RBS" or o.kind == "shear tab" then
      check.fail("%s: field 'strength' is missing; kind = '%s' needs the moment at which it yields, over Mp of the "
        .. "member", where, o.kind)
    end
    strength = 1
  end
  local row = table_5_2[o.kind]
  local a, b = shared.rotations(where, row, o.depth, o.kind == "shear tab" and "a bolt group" or "a depth")
  local at_a = o.yield_rotation and 1 + asce_41.hardening[1] * a / o.yield_rotation or 1
  return shared.from_abc(a, b, row.c, at_a, strength), o.role == "primary" and a or b
end

