-- A cantilever with a load at its tip: see first_model.md.
local hinge = require "hinge"

-- What the beam is made of, and its section: 50 by 50 mm.
local steel = hinge.material { E = 206e9, nu = 0.3, density = 7850 }
local bar = hinge.section.solid { width = 0.05, depth = 0.05 }

-- Two nodes, a support and a member between them.
local model = hinge.model { displacement = "small" }
local wall, tip = model:node { 0, 0, 0 }, model:node { 1, 0, 0 }
model:fix(wall, "all")
local beam = model:member { wall, tip, section = bar, material = steel, up = { 0, 0, 1 } }

-- 1 kN downwards.
model:load { node = tip, force = { 0, 0, -1000 } }

-- Statics in one step; `finish` takes all steps.
local run = model:static { steps = 1 }
run:finish()

local _, _, uz = run:displacement(tip)
local at_wall = beam:forces(run)
local _, _, rz = run:reaction(wall)
print(("the tip goes down by %.4f mm"):format(-1000 * uz))
print(("the moment at the wall is %.1f N m"):format(at_wall.Mx))
print(("the wall carries %.1f N"):format(rz))
hinge.picture(run, { title = "a cantilever" }, "first_model.png")

return { tip_mm = -1000 * uz }
