-- A cantilever is bent to and fro, with three kinds of hardening; a bar is pulled slowly and fast. See hardening.md.
local hinge = require "hinge"

local E, fy, L = 210e9, 235e6, 3
local column = hinge.section.h { depth = 0.3, width = 0.3, web = 0.011, flange = 0.019, interaction = "exact" }
local Mp = fy * column.Zx

local function steel(hardening, rate)
  return hinge.material { E = E, density = 7850, yield_stress = fy, hardening = hardening, rate = rate }
end

-- The moment at the foot over the rotation of the chord, while the tip goes from one of `turns` (rad) to the next.
local function cycle(name, material, turns)
  local model = hinge.model { displacement = "small" }
  local foot, tip = model:node { 0, 0, 0 }, model:node { L, 0, 0 }
  model:member { foot, tip, section = column, material = material, up = { 0, 0, 1 }, elements = 8 }
  model:fix(foot, "all")
  model:load { node = tip, force = { 0, 0, -Mp / L } }
  local curve, run = { name = name, x = { 0 }, y = { 0 } }, nil
  for _, turn in ipairs(turns) do
    run = model:static { from = run, steps = 40, control = { node = tip, "uz", to = -turn * L } }
    while run:step() do
      local _, _, uz = tip:displacement(run)
      table.insert(curve.x, -100 * uz / L)
      table.insert(curve.y, run.factor)
    end
    assert(run.verdict == "completed", run.reason)
  end
  return curve
end

local turns = { 0.02, -0.02, 0.03, -0.03, 0.03 }
local moves = cycle("kinematic", steel { tangent = E / 100 }, turns)
local grows = cycle("isotropic", steel { tangent = E / 100, kinematic = 0 }, turns)
local bends = cycle("saturating", steel { modulus = 10e9, saturation = 100e6 }, turns)
print "            M / Mp at 0.02    at -0.02    at 0.03, last"
for _, c in ipairs { moves, grows, bends } do
  print(("%-11s %14.3f %11.3f %16.3f"):format(c.name, c.y[41], c.y[81], c.y[#c.y]))
end
hinge.plot({ series = { moves, grows, bends }, title = "HEB 300, bent to and fro",
  x_label = "rotation of the chord (%)", y_label = "M / Mp at the foot", width = 1000, height = 700 }, "hardening.png")

-- A bar that is pulled at a constant rate: the stress beyond yield, over fy.
local function pulled(rate)
  local model = hinge.model { displacement = "small" }
  local a, b = model:node { 0, 0, 0 }, model:node { 1, 0, 0 }
  local mild = steel(nil, { D = 40.4, q = 5 }):with { density = 1e-3 } -- so light that no wave is seen
  local bar = model:member { a, b, section = hinge.section.solid { width = 0.02, depth = 0.02 }, material = mild,
    up = { 0, 0, 1 } }
  model:fix(a, "all")
  model:fix(b, "all")
  local duration = 0.02 / rate
  model:move { node = b, x = { { 0, 0 }, { duration, 0.02 } } }
  local run = model:dynamic { dt = duration / 400, duration = duration }
  run:finish()
  return run:forces(bar).N / (4e-4 * fy)
end

print "\nrate (1/s)   stress / fy   Cowper and Symonds"
for _, rate in ipairs { 0.01, 1, 100 } do
  print(("%10g %13.3f %20.3f"):format(rate, pulled(rate), 1 + (rate / 40.4) ^ 0.2))
end
return { kinematic = moves.y[#moves.y], isotropic = grows.y[#grows.y] }
