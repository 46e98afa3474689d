-- Tables for a report: forces of members, envelopes, utilisation, storeys, base reactions. See results.md.
local hinge = require "hinge"
local results = hinge.results

local g, spans, levels = 9.80665, { 0, 6 }, { 0, 4, 7.5 } -- m/s^2, m
local steel = hinge.material.steel "S355"
local post, beam = hinge.section.named "HEB 220", hinge.section.named "IPE 330"
local heavy = steel:with { density = 22e3 / g / beam.area } -- 22 kN/m: the floor as mass of the beams

local model = hinge.model { mass = "cubic" }
local grid = hinge.grid { model = model, x = spans, z = levels }
grid:fix "all"
for storey = 1, 2 do grid:fix("y,rx,rz", storey) end
grid:columns { section = post, material = steel, group = "columns" }
grid:beams { along = "x", section = beam, material = heavy, group = "beams" }

model:case("dead"):gravity { 0, 0, -g }
model:load { group = "beams", q = { 0, 0, -12e3 }, case = model:case "live" }
for storey, force in ipairs { 30e3, 20e3 } do
  model:load { node = grid:node("A1", storey), force = { force, 0, 0 }, case = model:case "wind" }
end
local live = model:static { steps = 2, loads = { dead = 1.35, live = 1.5 } }:finish()
local wind = model:static { steps = 2, loads = { dead = 1.35, wind = 1.5 } }:finish()

local out = results.of(model)
print(out.members(wind):text { columns = { "index", "group", "N_min", "Mx_min", "Mx_max" } })
print(out.envelope { live, wind }:text { columns = { "index", "Mx_min", "Mx_max" }, sort = "Mx", top = 3 })

local lengths = { columns = { kx = 1.2, ky = 1 }, beams = { Lb = 2 } }
local both = { live, wind }
print(out.utilisation(both, { standard = "EN 1993-1-1", lengths = lengths }))
print(out.utilisation(both, { standard = "AISC 360", lengths = lengths }))
print(out.base(wind, { gravity = { 0, 0, -1.35 * g } }))

-- The feet shake for three cycles, under dead load and a third of the live load.
local rest = model:static { steps = 2, loads = { dead = 1, live = 0.3 } }:finish()
local a = {}
for i = 0, 400 do a[i + 1] = i < 375 and 3.5 * math.sin(2 * math.pi * i / 125) or 0 end -- m/s^2, every 10 ms
model:move { node = { grid:node("A1", 0), grid:node("B1", 0) }, x = hinge.ground { dt = 0.01, acceleration = a } }
model:damping { ratio = 0.02, periods = { 1.2, 0.12 } }
local shake = model:dynamic { from = rest, dt = 0.01, duration = 5 }
local peaks = out.envelope { shake }
local floors = out.storeys(shake)
local used = out.utilisation(shake, { standard = "EN 1993-1-1", lengths = lengths, every = 2 })
shake:finish()
print(floors)
print(used:text { top = 3 })
floors:plot("results_drifts.png", { title = "Drifts" })
peaks:plot("results_moments.png", { members = model:group("beams"):members(), title = "Beams of both storeys" })
used:plot("results_used.png", { title = "During the shake" })
