-- A beam on three supports: load cases, a combination, and a support that settles: see supports_loads_cases.md.
local hinge = require "hinge"

local steel = hinge.material { E = 210e9, nu = 0.3, density = 7850 }
local h = hinge.section.h { depth = 0.3, width = 0.15, web = 0.007, flange = 0.011 }

-- Two spans of 6 m: a pin on the left, a roller in the middle and one on the right.
local l = 6
local model = hinge.model { displacement = "small" }
local left, middle, right = model:node { 0, 0, 0 }, model:node { l, 0, 0 }, model:node { 2 * l, 0, 0 }
model:fix(left, "xyz rx")
model:fix({ middle, right }, "y,z")
local first = model:member { left, middle, section = h, material = steel, group = "beam" }
model:member { middle, right, section = h, material = steel, group = "beam" }

-- Load cases: a floor's own weight on both spans, goods on the first span alone.
local dead, live = model:case "dead", model:case "live"
dead:load { group = "beam", q = { 0, 0, -10e3 } }
live:load { member = first, at = 0.5, force = { 0, 0, -40e3 } }
model:combination("design", { dead = 1.35, live = 1.5 })

-- The middle support goes down by 30 mm in one second, slowly at both ends of its way. Statics leaves it where it is.
local settles, duration = 0.03, 1
model:move { node = middle, z = function(t)
  return -settles * (1 - math.cos(math.pi * math.min(t / duration, 1))) / 2
end }

local function show(what, run)
  local _, _, a = left:reaction(run)
  local _, _, b = middle:reaction(run)
  local _, _, c = right:reaction(run)
  print(("%-18s %8.2f %8.2f %8.2f"):format(what, a / 1e3, b / 1e3, c / 1e3))
end
print "reactions, kN          left   middle    right"
local rest = model:static { steps = 1, loads = "dead" }:finish()
show("dead", rest)
show("live", model:static { steps = 1, loads = "live" }:finish())
show("design", model:static { steps = 1, loads = "design" }:finish())

-- By hand: what 12 m without the middle support would sag, and what a force of 1 N there takes back.
local EI, kGA = steel.E * h.Ix, steel.G * h.shear_area_y
local sag = 5 * 10e3 * (2 * l) ^ 4 / (384 * EI) + 10e3 * (2 * l) ^ 2 / (8 * kGA)
local per_newton = (2 * l) ^ 3 / (48 * EI) + 2 * l / (4 * kGA)

local run = model:dynamic { from = rest, dt = 1e-3, duration = duration }
local at_middle, at_right = { name = "middle", x = {}, y = {} }, { name = "left, right", x = {}, y = {} }
local hand = { name = "middle by hand", x = {}, y = {}, style = "points" }
run:on_step(function()
  local _, _, w = middle:displacement()
  local i = #at_middle.x + 1
  at_middle.x[i], at_middle.y[i] = -1000 * w, select(3, middle:reaction()) / 1e3
  at_right.x[i], at_right.y[i] = -1000 * w, select(3, right:reaction()) / 1e3
  if i % 100 == 0 then table.insert(hand.x, -1000 * w) table.insert(hand.y, (sag + w) / per_newton / 1e3) end
end)
run:finish()
show("dead, then settled", run)
print(("the middle by hand: dead %.2f, settled %.2f kN"):format(sag / per_newton / 1e3,
  (sag - settles) / per_newton / 1e3))

hinge.plot({ series = { at_middle, at_right, hand }, title = "reactions while the middle support settles",
  x_label = "settlement, mm", y_label = "reaction, kN", width = 1000, height = 600 }, "supports_loads_cases.png")
return { middle_kN = select(3, middle:reaction(run)) / 1e3 }
