-- A propped cantilever with a load in its middle: two plastic hinges in three stages. See plastic_hinges.md.
local hinge = require "hinge"

local L, side, yield_stress = 4, 0.05, 235e6
local steel = hinge.material { E = 210e9, density = 7850, yield_stress = yield_stress }
local bar = hinge.section.solid { width = side, depth = side }
local Mp, EI = bar.Zx * yield_stress, steel.E * bar.Ix

local model = hinge.model { displacement = "small" }
local wall, middle, prop = model:node { 0, 0, 0 }, model:node { L / 2, 0, 0 }, model:node { L, 0, 0 }
model:fix(wall, "all")
model:fix(prop, "y,z,rx")
local left = model:member { wall, middle, section = bar, material = steel, group = "beam" }
model:member { middle, prop, section = bar, material = steel, group = "beam" }
local push = model:case "push"
push:load { node = middle, force = { 0, 0, -1000 } }

-- By hand: the wall yields first, then the middle; then the beam is a mechanism.
local P1, P2 = 16 / 3 * Mp / L, 6 * Mp / L
local d1 = 7 / 768 * P1 * L ^ 3 / EI
local d2 = d1 + (P2 - P1) * L ^ 3 / (48 * EI)
local last = 0.12 -- m, to which the middle is pushed down
local left_by_hand = 1e3 * (last - 7 / 768 * P2 * L ^ 3 / EI) -- mm
local work = Mp * (Mp * L / (24 * EI)) + Mp * 3 * (last - d2) / (L / 2)

local curve = { name = "hinge", x = { 0 }, y = { 0 } }
local function keep(load)
  table.insert(curve.x, -1000 * select(3, middle:displacement()))
  table.insert(curve.y, load)
end

local run = model:static { steps = 600, loads = { push = 1 }, control = { node = middle, "uz", to = -last } }
local first, second
for step in run:steps() do
  keep(step.factor)
  local at_wall, at_middle = left:forces()
  if not first and at_wall.f_y > 0.9999 then first = { step.factor, curve.x[#curve.x] } end
  if not second and at_middle.f_y > 0.9999 then second = { step.factor, curve.x[#curve.x] } end
end
first, second = first or { 0, 0 }, second or { 0, 0 } -- a plan takes no step

-- The load is taken off: the beam springs back, and what is left is plastic.
local unloaded = model:static { from = run, steps = 20, loads = { push = 0 } }
for step in unloaded:steps() do keep(run.factor * (1 - step.factor)) end

print "                        hinge               by hand"
local row = "%-18s %8.3f kN %6.2f mm %8.3f kN %6.2f mm"
print(row:format("hinge at the wall", first[1], first[2], P1 / 1e3, 1e3 * d1))
print(row:format("and in the middle", second[1], second[2], P2 / 1e3, 1e3 * d2))
print(row:format("load taken off", 0, curve.x[#curve.x], 0, left_by_hand))
print(("plastic work %.1f J, by hand %.1f J"):format(run.energy.plastic, work))
print(("moment left at the wall %.3f Mp, by hand -0.125 Mp"):format(left:forces(unloaded).Mx / Mp))

-- By how many per cent eq 14 finds a moment too strong beside N.
local shapes = {
  { "HEB 300 about x", 1, hinge.section.h { depth = 0.3, width = 0.3, web = 0.011, flange = 0.019 } },
  { "HEB 300 about y", 2, hinge.section.h { depth = 0.3, width = 0.3, web = 0.011, flange = 0.019 } },
  { "IPE 300 about x", 1, hinge.section.h { depth = 0.3, width = 0.15, web = 0.0071, flange = 0.0107 } },
  { "RHS 200x100x8 about x", 1, hinge.section.box { depth = 0.2, width = 0.1, thickness = 0.008 } },
  { "RHS 200x100x8 about y", 2, hinge.section.box { depth = 0.2, width = 0.1, thickness = 0.008 } },
  { "pipe 200x5", 1, hinge.section.pipe { diameter = 0.2, thickness = 0.005 } },
  { "rectangle", 1, bar } }
print "too strong, %, at N / N0 =   0.1    0.2    0.3    0.6    0.9"
for _, shape in ipairs(shapes) do
  local line = ("%-22s"):format(shape[1])
  for _, n in ipairs { 0.1, 0.2, 0.3, 0.6, 0.9 } do
    local exact = select(shape[2], shape[3]:reduced_moments(n))
    line = line .. ("%7d"):format(math.floor(100 * (math.sqrt(1 - n ^ 2) / exact - 1) + 0.5))
  end
  print(line)
end

local hand = { name = "by hand", style = "points", x = { 1e3 * d1, 1e3 * d2, 1e3 * last, left_by_hand },
  y = { P1 / 1e3, P2 / 1e3, P2 / 1e3, 0 } }
hinge.plot({ series = { curve, hand }, title = "three stages of a propped cantilever", x_label = "sag, mm",
  y_label = "load, kN", width = 1000, height = 600 }, "plastic_hinges.png")
return { limit_kN = run.factor }
