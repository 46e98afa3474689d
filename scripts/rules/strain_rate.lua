-- A limit that rises with the speed: a rod breaks later when it is pulled faster.
--
-- Run     hinge run scripts/rules/strain_rate.lua
-- Shows   glass-fibre rods pulled apart at three speeds, 0.1, 1 and 10 m/s a metre; each breaks where the strain of its
--         outermost fibre reaches e0 (1 + (rate / C)^(1/q)), after Cowper and Symonds
-- Expect  slow_percent = 2.368 within 0.5 %        strain at the break, for e0 = 2 %, C = 1000 1/s, q = 5.43
--         middle_percent = 2.560 within 0.5 %
--         fast_percent = 2.856 within 1 %
--         energy_error_percent = 0 within 0.01     energy error, of the work at the moved end, all together
local hinge = require "hinge"

local L, d, e0, C, q = 0.2, 0.01, 0.02, 1000, 5.43
local glass = hinge.material { E = 45e9, density = 2000 }
local rod   = hinge.section.round { diameter = d }

local function limit(rate) return e0 * (1 + (rate / C) ^ (1 / q)) end

-- Strain of the outermost fibre, from bending and tension. The square root of the curvatures is for a round section.
local function fibre(axial, curvature_x, curvature_y)
  return math.abs(axial) + d / 2 * math.sqrt(curvature_x ^ 2 + curvature_y ^ 2)
end

local function rule(section)
  local strain = fibre(section.axial_strain, section.curvature_x, section.curvature_y)
  return strain >= limit(fibre(section.axial_strain_rate, section.curvature_rate_x, section.curvature_rate_y))
end

-- The moved end accelerates over the first tenth of the time, so that no shock wave runs along the rod.
local function pull(rate)
  local model = hinge.model {}
  local held, pulled = model:node { 0, 0, 0 }, model:node { L, 0, 0 }
  model:fix(held, "all")
  local member = model:member { held, pulled, section = rod, material = glass, elements = 4 }
  local speed, start = rate * L, 0.1 * e0 / rate
  model:move { node = pulled, x = function(t)
    local part = t / start
    return speed * (part < 1 and start * (part ^ 3 - part ^ 4 / 2) or t - start / 2)
  end }
  model:fracture(rule)
  local strain = 0
  local run = model:dynamic { dt = e0 / rate / 5000, duration = 2 * e0 / rate }
  run:on_step(function()
    if member:state() ~= "broken" then strain = pulled:displacement() / L end
  end)
  run:finish()
  return 100 * strain, math.abs(100 * run.energy.energy_error / run.energy.work)
end

local results, lost = {}, 0
for _, test in ipairs { { "slow", 0.1 }, { "middle", 1 }, { "fast", 10 } } do
  local name, rate = table.unpack(test)
  local strain, energy_error = pull(rate)
  results[name .. "_percent"], lost = strain, lost + energy_error
  print(("%5.1f 1/s: breaks at a strain of %.3f %%; the limit is %.3f %%"):format(rate, strain, 100 * limit(rate)))
end
results.energy_error_percent = lost
return results
