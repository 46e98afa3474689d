-- How far does the tip of a cantilever go?
--
-- Run     hinge run scripts/01_first_cantilever.lua
-- Shows   a square steel bar, 1 m long, 50 mm thick, clamped at one end and pushed down at the other
-- Expect  tip_mm = 3.112854 within 0.00002 %       P L^3 / (3 E I) + P L / (k G A) for P = 1 kN
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
