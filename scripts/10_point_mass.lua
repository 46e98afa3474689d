-- A mass at the tip of a cantilever: its static deflection and its natural period.
--
-- Run     hinge run scripts/10_point_mass.lua
-- Shows   a mass of 20 kg at the tip of a steel bar, 1 m long, with almost no mass of its own: the deflection at rest,
--         and the period of the vibration when the mass is released on the straight bar
-- Expect  sag_mm = 0.610534 within 0.0002 %        m g f, f = L^3 / (3 E I) + L / (k G A)
--         period_ms = 49.576 within 0.02 %         2 pi sqrt(m f)
local hinge = require "hinge"

local steel = hinge.material { E = 206e9, nu = 0.3, density = 0.01 }
local bar   = hinge.section.solid { width = 0.05, depth = 0.05 }
local model = hinge.model { displacement = "small" }
local wall, tip = model:node { 0, 0, 0 }, model:node { 1, 0, 0 }
model:fix(wall, "all")
model:member { wall, tip, section = bar, material = steel, up = { 0, 0, 1 } }
model:mass { node = tip, mass = 20 }
model:gravity { 0, 0, -9.80665 }

local rest = model:static { steps = 1 }
rest:finish()
local _, _, sag = rest:displacement(tip)

-- The tip starts at the level of the wall and swings about its position at rest. It is back after one period.
local run = model:dynamic { dt = 1e-4, duration = 0.3 }
local probe = run:probe { node = tip, "uz" }
run:finish()
local time, value, first, last, swings = probe.time, probe.value, nil, nil, -1
for i = 2, #value do
  local a, b = value[i - 1] - sag, value[i] - sag
  if a < 0 and b >= 0 then
    last, swings = time[i - 1] + (time[i] - time[i - 1]) * a / (a - b), swings + 1
    first = first or last
  end
end
local period = first and (last - first) / swings or 0 -- 0: nothing swung, as in a plan
print(("20 kg bend the bar by %.6f mm; a swing takes %.3f ms"):format(-1e3 * sag, 1e3 * period))
return { sag_mm = -1e3 * sag, period_ms = 1e3 * period }
