-- A cantilever whose foot has the backbone of a test: pushed to its end, and bent to and fro. See backbone.md.
local hinge = require "hinge"

local E, fy, L = 200e9, 345e6, 3
local steel = hinge.material { E = E, density = 7850, yield_stress = fy }
local column = hinge.section.h { depth = 0.4, width = 0.2, web = 0.01, flange = 0.015 }
local Mp = fy * column.Zx

local numbers = { yield = 1.1, cap_rotation = 0.025, cap_strength = 1.2, post_cap_rotation = 0.16, residual = 0.4,
  ultimate_rotation = 0.2 }
local pushed = hinge.backbone(numbers)
numbers.wear = 1
local worn = hinge.backbone(numbers)
numbers.stiffness_wear = true
local softer = hinge.backbone(numbers)

-- The moment at the foot over the rotation of the chord, while the tip goes from one of `turns` (rad) to the next.
local function bent(name, backbone, elements, turns)
  local model = hinge.model { displacement = "small" }
  local foot, tip = model:node { 0, 0, 0 }, model:node { L, 0, 0 }
  model:member { foot, tip, section = column, material = steel, up = { 0, 0, 1 }, elements = elements,
    backbone = backbone }
  model:fix(foot, "all")
  model:load { node = tip, force = { 0, 0, -Mp / L } }
  local curve, run = { name = name, x = { 0 }, y = { 0 } }, nil
  for _, turn in ipairs(turns) do
    run = model:static { from = run, steps = 40, control = { node = tip, "uz", to = -turn * L } }
    while run:step() do
      local _, _, uz = tip:displacement(run)
      table.insert(curve.x, -uz / L)
      table.insert(curve.y, run.factor)
    end
    assert(run.verdict == "completed", run.reason)
  end
  return curve
end

print "elements    M / Mp at 0.035     at 0.10     at 0.19 rad"
local two
for _, elements in ipairs { 2, 4, 8 } do
  local c = bent("pushed", pushed, elements, { 0.035, 0.1, 0.19 })
  print(("%8d %18.4f %11.4f %11.4f"):format(elements, c.y[41], c.y[81], c.y[121]))
  two = two or c
end

local turns = { 0.04, -0.04, 0.04, -0.04, 0.06, -0.06, 0.06, -0.06, 0.08, -0.08, 0.08, -0.08 }
local kept, tired = bent("cycles", pushed, 2, turns), bent("with wear", worn, 2, turns)
local soft = bent("stiffness, too", softer, 2, turns)
-- M / Mp over the rotation, where the last half cycle begins to unload
local function unloading(c) return (c.y[442] - c.y[441]) / (c.x[442] - c.x[441]) end
print(("after two cycles each at 0.04, 0.06 and 0.08 rad: %.3f Mp, with wear %.3f Mp"):format(
  math.abs(kept.y[#kept.y]), math.abs(tired.y[#tired.y])))
print(("stiffness of the last unloading, over the elastic one: with wear %.3f, with wear of the stiffness %.3f"):format(
  unloading(tired) / unloading(kept), unloading(soft) / unloading(kept)))
hinge.plot({ series = { two, kept, tired, soft }, title = "Cantilever with a backbone at its foot",
  x_label = "rotation of the chord (rad)", y_label = "M / Mp at the foot", width = 1000, height = 700 }, "backbone.png")
return { elements = two.y[81], kept = math.abs(kept.y[#kept.y]), worn = math.abs(tired.y[#tired.y]) }
