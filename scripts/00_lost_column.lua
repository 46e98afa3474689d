-- A frame loses a column of its ground floor at once: the script of the README.
--
-- Run     hinge run scripts/00_lost_column.lua
-- Shows   a plane frame of four storeys at rest under its weight; the middle column of the ground floor breaks, and the
--         frame above it comes down while its beams yield at their ends
-- Expect  fell_m = 2.08 within 0.5 %               how far the joint above the column fell in one second
--         energy_error_percent = 0 within 0.01     energy error, of the potential energy released
local hinge = require "hinge"
local steel  = hinge.material { E = 206e9, density = 7850, yield_stress = 325e6 }
local column = hinge.section.box { width = 0.2, depth = 0.2, thickness = 0.008 }
local beam   = hinge.section.h { depth = 0.25, width = 0.125, web = 0.006, flange = 0.009 }
local laden  = hinge.material { E = 206e9, density = 7850 + 1610 / beam.area, yield_stress = 325e6 } -- floor: 1610 kg/m
local model, node = hinge.model(), {}
for i = 1, 25 do -- five nodes on each of five levels
  node[i] = model:node { 6 * ((i - 1) % 5), 0, 3.5 * ((i - 1) // 5) }
  model:fix(node[i], i <= 5 and "all" or "y,rx,rz") -- the frame stays in its plane
  if i > 5 then model:member { node[i - 5], node[i], section = column, material = steel, group = "column " .. i } end
  if i > 5 and i % 5 ~= 1 then model:member { node[i - 1], node[i], section = beam, material = laden } end
end
model:gravity { 0, 0, -9.80665 }
local rest = model:static { steps = 4 }:finish()
model:fracture { group = "column 8", where = "all", rule = function() return true end } -- it breaks at once
local run = model:dynamic { from = rest, dt = 1e-3, duration = 1 }:finish()
local fell = select(3, rest:displacement(node[8])) - select(3, run:displacement(node[8]))
print(("the joint above the lost column fell by %.2f m"):format(fell))
hinge.picture(run, { from = { -0.3, -1, 0.2 }, width = 1000, height = 560 }, "lost_column.png")
return { fell_m = fell, energy_error_percent = -100 * run.energy.energy_error / run.energy.gravity }
