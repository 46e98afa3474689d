-- Load cases: a portal under dead load and a part of the live load, then pushed, and hit by a blast.
--
-- Run     hinge run scripts/14_load_cases.lua
--
-- Each run names the cases that act. A static run that continues another run keeps the loads of that run. Its load
-- factor therefore scales the push alone. In the dynamic run the loads of the static run also go on. The blast has a
-- history and begins with the first step.
--
-- Expect  at the feet, kN, by hand:
--         feet = 144 within 0.01           2 (60 + 0.3 x 40), dead and 0.3 of live
--         feet_design = 282 within 0.01    2 (1.35 x 60 + 1.5 x 40), the combination
--         feet_pushed = 144 within 0.01    unchanged while the corner is pushed by 20 mm
--         impulse = 300 within 0.5 %       N s, half of 60 kN over 10 ms: momentum and impulse of the feet
local hinge = require "hinge"

local model = hinge.model { displacement = "small" }
local steel = hinge.material { E = 206e9, density = 7850, yield_stress = 235e6 }
local column = hinge.section.box { width = 0.2, depth = 0.2, thickness = 0.01 }
local node = { model:node { 0, 0, 0 }, model:node { 0, 0, 3 }, model:node { 5, 0, 3 }, model:node { 5, 0, 0 } }
model:fix { node[1], node[4] }
for i = 1, 3 do model:member { node[i], node[i + 1], section = column, material = steel, elements = 4 } end

local dead, live, push, blast = model:case "dead", model:case "live", model:case "push", model:case "blast"
for _, top in ipairs { node[2], node[3] } do
  dead:load { node = top, force = { 0, 0, -60e3 } }
  live:load { node = top, force = { 0, 0, -40e3 } }
end
push:load { node = node[2], force = { 1e3, 0, 0 } }
blast:load { node = node[2], force = { 60e3, 0, 0 }, history = { { 0, 1 }, { 0.01, 0 } } }
model:combination("uls", { dead = 1.35, live = 1.5 })

local function feet(run) return select(3, node[1]:reaction(run)) + select(3, node[4]:reaction(run)) end

local rest = model:static { steps = 1, loads = { dead = 1, live = 0.3 } }:finish()
local design = model:static { steps = 1, loads = "uls" }:finish()
local pushed = model:static { from = rest, loads = { push = 1 }, control = { node = node[2], "ux", to = 0.02 } }
pushed:finish()

local hit = model:dynamic { from = rest, loads = { dead = 1, blast = 1 }, dt = 1e-4, duration = 0.01 }
local taken, before = 0, 0 -- N s; N
for _ in hit:steps() do
  local now = node[1]:reaction(hit) + node[4]:reaction(hit)
  taken, before = taken + 1e-4 * (before + now) / 2, now
end

local results = { feet = feet(rest) / 1e3, feet_design = feet(design) / 1e3, feet_pushed = feet(pushed) / 1e3,
  impulse = hit:momentum().linear[1] - taken }
print(("feet %.1f kN, design %.1f kN; pushed by %.1f kN, feet %.1f kN; impulse %.2f N s"):format(results.feet,
  results.feet_design, pushed.factor, results.feet_pushed, results.impulse))
return results
