-- How much larger is the deflection under a sudden load, and how long must the load last? A loop over models, a table.
--
-- Run     hinge run scripts/06_parameter_loop.lua
--         hinge run scripts/06_parameter_loop.lua | grep , > spectrum.csv          (rows for a spreadsheet)
-- Shows   a heavy beam across the tip of a cantilever. A load acts on it for a part of its natural period. The
--         result is the largest deflection over the static one
-- Expect  at_5_percent = 0.31287 within 1 %        2 sin(pi t/T) of one mass on a spring, for a load that lasts
--                                                  t = T / 20
--         at_25_percent = 1.41421 within 1 %       the same for t = T / 4
--         at_100_percent = 2 within 1 %            and 2 for loads that last half a period or longer
--         energy_error_percent = 0 within 0.01     energy error, of the work of all loads together
local hinge = require "hinge"

local L, F = 2, 1000 -- m, N
local steel = hinge.material { E = 206e9, density = 7850 }
local heavy = hinge.material { E = 206e9, density = 250e3 }
local bar   = hinge.section.solid { width = 0.05, depth = 0.05 }
local cross = hinge.section.solid { width = 0.1, depth = 0.1 }

-- A cantilever with a heavy beam across its tip.
local function cantilever()
  local model = hinge.model { displacement = "small" }
  local wall, tip = model:node { 0, 0, 0 }, model:node { L, 0, 0 }
  model:fix(wall, "all")
  -- the part of the bar that swings with the tip
  local mass = 33 / 140 * model:member { wall, tip, section = bar, material = steel }.mass
  for _, y in ipairs { -0.4, 0.4 } do
    mass = mass + model:member { tip, model:node { L, y, 0 }, section = cross, material = heavy }.mass
  end
  return model, tip, mass
end

local function deepest(duration, total)
  local model, tip = cantilever()
  model:load { node = tip, force = { 0, 0, -F }, history = function(t) return t <= duration and 1 or 0 end }
  local run = model:dynamic { dt = total / 8000, duration = total }
  local depth = run:probe { node = tip, "uz" }
  run:finish()
  return -depth.min, math.abs(run.energy.energy_error / run.energy.work)
end

local _, _, mass = cantilever()
local stiffness = 3 * steel.E * bar.Ix / L ^ 3
local static, period = F / stiffness, 2 * math.pi * math.sqrt(mass / stiffness)

local results = { energy_error_percent = 0 }
print "duration / period, largest / static, one mass on a spring"
for _, part in ipairs { 0.05, 0.1, 0.25, 0.5, 1 } do
  local depth, energy_error = deepest(part * period, 2 * period)
  print(("%.2f, %.5f, %.5f"):format(part, depth / static, part < 0.5 and 2 * math.sin(math.pi * part) or 2))
  results.energy_error_percent = results.energy_error_percent + 100 * energy_error
  if part == 0.05 or part == 0.25 or part == 1 then results[("at_%.0f_percent"):format(100 * part)] = depth / static end
end
return results
