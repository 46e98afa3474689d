-- Debris falls on a floor.
--
-- Run     hinge run scripts/08_debris.lua
-- Shows   five loose bars fall half a metre, at 1 m/s to the right, on a grating of fixed bars. They bounce, hit each
--         other and slide. Friction dissipates a part of their energy
-- Expect  first_touch_ms = 319.3 within 0.02 %     sqrt(2 h / g) of the lowest one, h = 0.5 m between the surfaces
--         fallen_through = 0 within 1              bars below it in the end; one along the grating fits through
--         heat_percent = 21 within 8               heat of friction, of the work of gravity; there is no other damping,
--                                                  so the rest is motion and vibration
--         energy_error_percent = 0 within 0.1      energy error, of the work of gravity
--
-- The impacts among the bars are chaotic: another processor gives another heap. The energy balance holds in any case.
local hinge = require "hinge"

local side, h, g = 0.05, 0.5, 9.80665
local steel = hinge.material { E = 206e9, density = 7850 }
local bar   = hinge.section.solid { width = side, depth = side }

local model = hinge.model {}
for i = -4, 4 do
  local a, b = model:node { 0.25 * i, -1, 0 }, model:node { 0.25 * i, 1, 0 }
  model:fix({ a, b }, "all")
  model:member { a, b, section = bar, material = steel, group = "floor", elements = 4 }
end
for i = 0, 4 do
  local angle, z = 0.5 * i - 1, side + h + 0.12 * i
  local x, y = 0.6 * math.cos(angle), 0.6 * math.sin(angle)
  model:member { model:node { -x, -y, z }, model:node { x, y, z }, section = bar, material = steel, group = "debris" }
end
model:velocity("debris", { 1, 0, 0 })
model:gravity { 0, 0, -g }

local first = 0
model:contact { friction = 0.5, on_contact = function(event) if first == 0 then first = event.time end end }

local run = model:dynamic { integrator = "explicit", dt = "auto", duration = 0.8 }:finish()

local through = 0
for _, z in ipairs(run:read("z", "debris")) do
  if z < 0 then through = through + 1 end
end
local given = -run.energy.gravity
print(("first touch at %.1f ms, by hand %.1f ms; %d bars fell through")
  :format(1e3 * first, 1e3 * math.sqrt(2 * h / g), through))
print(("%.1f J from gravity, %.1f J heat of friction, %.1f J in motion")
  :format(given, run.energy.contact_released, run.energy.kinetic))
return {
  first_touch_ms = 1e3 * first, fallen_through = through, heat_percent = 100 * run.energy.contact_released / given,
  energy_error_percent = 100 * run.energy.energy_error / given,
}
