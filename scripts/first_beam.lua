-- How far does the tip of a cantilever go?
--
-- Run     hinge run scripts/first_beam.lua
-- Shows   a square steel bar, 1 m long, 50 mm thick, clamped at one end and pushed down at the other
-- Expect  3.112854 mm for 1 kN: P L^3 / (3 E I) + P L / (k G A)
local hinge = require "hinge"

local steel = hinge.material { E = 206e9, nu = 0.3, density = 7850 }
local bar   = hinge.section.solid { width = 0.05, depth = 0.05 }
local model = hinge.model { displacement = "small" }
local wall, tip = model:node { 0, 0, 0 }, model:node { 1, 0, 0 }
model:fix(wall, "all")
model:member { wall, tip, section = bar, material = steel, up = { 0, 0, 1 } }
model:load { node = tip, force = { 0, 0, -1000 } }

local run = model:static { steps = 1 }
run:finish()
local _, _, uz = run:displacement(tip)
print(("tip goes down by %.6f mm"):format(-1000 * uz))
return { tip_mm = -1000 * uz }
