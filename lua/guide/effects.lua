-- A bar is thrown at a portal: which effects does this scene call for? See effects.md.
local hinge = require "hinge"

local steel = hinge.material { E = 206e9, density = 7850, yield_stress = 235e6 }
local bar = hinge.section.solid { width = 0.05, depth = 0.05 }
local model = hinge.model()
local feet = { model:node { 0, 0, 0 }, model:node { 3, 0, 0 } }
local heads = { model:node { 0, 0, 3 }, model:node { 3, 0, 3 } }
model:fix(feet, "all")
model:member { feet[1], heads[1], section = bar, material = steel, group = "portal" }
model:member { feet[2], heads[2], section = bar, material = steel, group = "portal" }
model:member { heads[1], heads[2], section = bar, material = steel, group = "portal" }

local rod = { model:node { -0.8, -0.5, 1.5 }, model:node { -0.8, 0.5, 1.5 } }
model:member { rod[1], rod[2], section = bar, material = steel, group = "rod" }
model:velocity("rod", { 40, 0, 0 })

model:gravity { 0, 0, -9.80665 }
model:contact { rule = "surface", between = { "rod", "portal" } }

local run = model:dynamic { from = model:static { fixed_group = "rod" }:finish(), dt = 2e-5, duration = 0.06 }:finish()
print(("energy error %.2f %% of the rod's energy"):format(100 * run.energy.energy_error / run.energy.initial))
hinge.picture(run, { from = { -0.4, -1, 0.25 }, width = 1000, height = 600 }, "effects.png")
