-- A script's own functions inside the run: a fracture rule and a load history do what the same thing in numbers does.
local hinge = require "hinge"

local steel = hinge.material { E = 206e9, nu = 0.3, density = 7850, yield_stress = 245e6 }
local bar = hinge.section.solid { width = 0.05, depth = 0.05 }

local function pulled(fracture, history)
  local model = hinge.model()
  local wall, tip = model:node { 0, 0, 0 }, model:node { 1, 0, 0 }
  model:fix(wall, "all")
  model:member { wall, tip, section = bar, material = steel, group = "bars" }
  model:load { node = tip, force = { 735e3, 0, 0 }, history = history }
  model:fracture(fracture)
  collectgarbage() -- the functions live on in the model alone
  local run = model:dynamic { dt = 1e-5, duration = 4e-3 }
  run:finish()
  return run
end

local ramp = { { 0, 0 }, { 1e-3, 1 } }
local numbers = pulled({ axial_strain = 0.01 }, ramp)
local seen = 0
local functions = pulled(function(section)
  seen = seen + 1
  assert(section.group == "bars" and section.member == 1 and section.plastic)
  return math.abs(section.axial_strain) >= 0.01
end, function(t) return t >= 1e-3 and 1 or (1 - t / 1e-3) * 0 + t / 1e-3 * 1 end)

assert(numbers:count { state = "broken" } == 1, "the bar breaks by numbers")
assert(functions:count { state = "broken" } == 1, "the bar breaks by a function")
assert(seen > 10, "the function is asked while the bar flows")
assert(numbers.hash == functions.hash, "the same bits")
print("hooks: the same bits by numbers and by functions; asked " .. seen .. " times")
