-- A braced frame is pushed to and fro, with braces that carry tension alone. See braces.md.
local hinge = require "hinge"

local E, fy, h, bay = 210e9, 235e6, 3.5, 5
local steel = hinge.material { E = E, density = 7850 }
local mild = hinge.material { E = E, density = 7850, yield_stress = fy }
local flat = hinge.section.solid { width = 0.08, depth = 0.008 }

-- The force at the head of a frame over its drift, while it is pushed from one of `drifts` (m) to the next.
local function cycle(name, carries, material)
  local model = hinge.model { displacement = "small" }
  local foot, head = {}, {}
  for i = 1, 2 do foot[i], head[i] = model:node { (i - 1) * bay, 0, 0 }, model:node { (i - 1) * bay, 0, h } end
  for i = 1, 2 do
    model:fix(foot[i], "all")
    model:fix(head[i], "y,rx,rz")
    model:member { foot[i], head[i], section = hinge.section.named "HEB 160", material = steel, up = { 0, 1, 0 } }
    model:member { foot[i], head[3 - i], section = flat, material = material, up = { 0, 1, 0 },
      carries = carries, group = "braces" }
  end
  model:member { head[1], head[2], section = hinge.section.named "IPE 300", material = steel, up = { 0, 0, 1 } }
  model:load { node = head[1], force = { 1e5, 0, 0 } }
  local curve, run = { name = name, x = { 0 }, y = { 0 } }, nil
  for _, drift in ipairs { 0.01, -0.01, 0.02, -0.02, 0.02 } do
    run = model:static { from = run, steps = 40, control = { node = head[1], "ux", to = drift } }
    while run:step() do
      table.insert(curve.x, 1e3 * head[1]:displacement(run))
      table.insert(curve.y, 100 * run.factor)
    end
    assert(run.verdict == "completed", run.reason)
  end
  return curve, run
end

local elastic = cycle("tension, elastic", "tension", steel)
local yields, run = cycle("tension, yields", "tension", mild)
local both = cycle("both, yields", "both", mild)
print "                  force (kN) at 10 mm   at -10 mm   at 20 mm, last"
for _, c in ipairs { elastic, yields, both } do
  print(("%-17s %19.1f %11.1f %16.1f"):format(c.name, c.y[41], c.y[81], c.y[#c.y]))
end
local work = 0
for _, end_of in ipairs(run:hinges { group = "braces" }) do work = work + end_of.work end
print(("the braces that yield in tension have dissipated %.1f kJ"):format(work / 1e3))
hinge.plot({ series = { both, yields, elastic }, title = "A frame with crossed braces, pushed to and fro",
  x_label = "drift (mm)", y_label = "force (kN)", width = 1000, height = 700 }, "braces.png")
return { last_force = yields.y[#yields.y] }
