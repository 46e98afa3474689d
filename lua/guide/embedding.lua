-- A cantilever whose fracture rule comes from the program that loads this script: see embedding.md.
local hinge = require "hinge"

-- A host calls the script with its rule; without one, a rule of the script's own.
local rule = ...
if type(rule) ~= "function" then
  rule = function(section) return section.curvature_x ^ 2 + section.curvature_y ^ 2 > 0.12 ^ 2 end
end

local steel = hinge.material { E = 206e9, density = 7850 }
local bar = hinge.section.round { diameter = 0.05 }
local model = hinge.model()
local foot, tip = model:node { 0, 0, 0 }, model:node { 1, 0, 0 }
model:fix(foot)
model:member { foot, tip, section = bar, material = steel }
model:load { node = tip, force = { 0, 0, -5e3 } }
model:fracture(rule)

local run = model:dynamic { dt = 2e-5, duration = 0.05 }
local fall = run:probe { node = tip, "uz" }
while run:count { state = "broken" } == 0 and run:step() do end
print(("broken at t = %.2f ms, the tip at %.1f mm"):format(1e3 * run.time, 1e3 * fall.last))
hinge.plot({ title = "the tip until the bar breaks", x_label = "time, s", y_label = "displacement, m", width = 1000,
  height = 600, series = { { x = fall.time, y = fall.value } } }, "embedding.png")
return { time = run.time, tip = fall.last }
