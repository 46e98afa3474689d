-- A bar is dropped on a rigid ground.
--
-- Run     hinge run scripts/13_ground.lua
-- Shows   a steel bar falls flat by 50 mm on a ground that gives back half of the normal velocity
-- Expect  speed = 0.99028 within 0.2 %             sqrt(2 g h) as it reaches the ground, m/s
--         rebound_mm = 12.5 within 1 %             e^2 h, e = 0.5
--         lost_percent = 75 within 1 %             1 - e^2, of the work of gravity
local hinge = require "hinge"

local side, h, g, e = 0.05, 0.05, 9.80665, 0.5
local steel = hinge.material { E = 206e9, density = 7850 }
local bar   = hinge.section.solid { width = side, depth = side }
local model = hinge.model {}
local a, b = model:node { 0, 0, h + side / 2 }, model:node { 1, 0, h + side / 2 }
model:member { a, b, section = bar, material = steel }
model:gravity { 0, 0, -g }
model:ground { restitution = e, friction = 0.3 }

local run = model:dynamic { dt = 5e-5, duration = 1.5 * math.sqrt(2 * h / g), record = false }
local speed, rebound, touched = 0, 0, false
for _ in run:steps() do
  local _, _, z = run:displacement(a)
  local _, _, vz = run:velocity(a)
  speed, touched = math.max(speed, -vz), touched or z < -h
  if touched then rebound = math.max(rebound, z + h) end
end
local lost = run.energy.ground_dissipated / (7850 * side ^ 2 * g * h)
print(("%.3f m/s at the ground; back to %.2f mm of %.0f mm"):format(speed, 1e3 * rebound, 1e3 * h))
return { speed = speed, rebound_mm = 1e3 * rebound, lost_percent = 100 * lost }
