-- A portal of named sections and grades, and HEB 300 from its dimensions and from its table. See named_sections.md.
local hinge = require "hinge"
local u = hinge.units

-- Sections and materials by their names; units as factors.
local column = hinge.section.named "HEB 300"
local beam = hinge.section.named "IPE 400"
local steel = hinge.material.steel("S355", { thickness = 19 * u.mm }) -- the flange of the column

local height, span = 4 * u.m, 8 * u.m
local model = hinge.model()
local n = { model:node { 0, 0, 0 }, model:node { 0, 0, height }, model:node { span, 0, height },
  model:node { span, 0, 0 } }
model:fix({ n[1], n[4] }, "all")
model:fix({ n[2], n[3] }, "y,rx,rz") -- the frame stays in its plane
model:member { n[1], n[2], section = column, material = steel, up = { 1, 0, 0 } }
model:member { n[4], n[3], section = column, material = steel, up = { 1, 0, 0 } }
local top = model:member { n[2], n[3], section = beam, material = steel, elements = 4 }
model:case "floor":load { member = top, q = { 0, 0, -30 * u.kN / u.m } }
model:case "wind":load { node = n[2], force = { 100 * u.kN, 0, 0 } }

local run = model:static { loads = { floor = 1, wind = 1 }, steps = 4 }:finish()
print(("the frame moves by %.1f mm"):format(n[2]:displacement(run) / u.mm))
print(("fy %g MPa, Mx0 of the column %.0f kN m"):format(steel.yield_stress / u.MPa,
  column.Zx * steel.yield_stress / (u.kN * u.m)))

-- The same section by its dimensions.
local by_hand = hinge.section.h { depth = 300 * u.mm, width = 300 * u.mm, web = 11 * u.mm, flange = 19 * u.mm,
  r = 27 * u.mm }
local plates = hinge.section.h { depth = 300 * u.mm, width = 300 * u.mm, web = 11 * u.mm, flange = 19 * u.mm }
print "             by name   by hand  r = 0   in tables"
for _, row in ipairs { { "area", 4, "A, cm2", 149.1 }, { "Ix", 8, "Ix, cm4", 25170 }, { "Iy", 8, "Iy, cm4", 8563 },
  { "Zx", 6, "Zx, cm3", 1869 }, { "Zy", 6, "Zy, cm3", 870.1 }, { "J", 8, "J, cm4", 185 } } do
  local field, cm = row[1], 10 ^ row[2]
  print(("%-8s %11.1f%10.1f%9.1f%9.1f"):format(row[3], column[field] * cm, by_hand[field] * cm, plates[field] * cm,
    row[4]))
end
hinge.picture(run, { from = { -0.25, -1, 0.25 }, show = "Mx", width = 900, height = 560 }, "named_sections.png")
return { sway_mm = n[2]:displacement(run) / u.mm }
