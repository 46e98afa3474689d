-- Natural frequencies of a cantilever with shear and rotary inertia, with 2, 4 and 8 elements and both masses.
--
-- Run     hinge run scripts/benchmarks/timoshenko_frequencies.lua
-- Shows   the linear mass of the paper has an error of second order; the cubic mass is near with two elements
-- Expect  41.294 and 255.77 Hz for a steel bar, 1 m long and 50 mm square
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "support/?.lua;" .. package.path
local hinge = require "hinge"
local frequency = require "vibration".frequency

local E, nu, density, side, L = 206e9, 0.3, 7850, 0.05, 1
local first, second = 41.2938, 255.770 -- Hz, roots of Timoshenko's frequency equation with the shear factor 5/6

-- Lets go of the tip after a static load, and returns the frequency near `guess`. The step makes vibrations slower by
-- a known amount: tan(w' dt / 2) = w dt / 2 for Newmark's method with beta = 1/4. It is taken out here.
local function release(elements, mass, guess)
  local model = hinge.model { displacement = "small", mass = mass }
  local wall, tip = model:node { 0, 0, 0 }, model:node { L, 0, 0 }
  model:fix(wall)
  model:fix(tip, "y,rx,rz")
  local steel = hinge.material { E = E, nu = nu, density = density }
  model:member { wall, tip, section = hinge.section.solid { width = side, depth = side }, material = steel,
    elements = elements }
  local pull = model:load { node = tip, force = { 0, 0, -1000 } }
  local bent = model:static { steps = 1 }:finish()
  pull:remove()
  local dt = 1 / guess / 40
  local run = model:dynamic { from = bent, dt = dt, duration = 40 / guess, solver = "direct", record = false }
  local down = run:probe { node = tip, "uz" }
  run:finish()
  local f = frequency(down, dt, 2 * math.pi * guess) / (2 * math.pi)
  return math.tan(math.pi * f * dt) / (math.pi * dt), run.index
end

return hinge.benchmark {
  title = "Frequencies of a Timoshenko cantilever", kind = "dynamics", fast = true,
  source = "Timoshenko's frequency equation, solved apart",
  run = function(b)
    local found, steps = {}, nil
    for _, n in ipairs { 2, 4, 8 } do found[n], steps = release(n, "linear", first) end
    b:row { "first, 2 elements, linear mass", computed = found[2], reference = first, unit = "Hz", tolerance = 0.06,
      elements = 2, steps = steps }
    b:row { "first, 8 elements, linear mass", computed = found[8], reference = first, unit = "Hz", tolerance = 2.5e-3,
      elements = 8, steps = steps }
    b:row { "observed order, 4 to 8 elements", computed = math.log((found[4] - first) / (found[8] - first), 2),
      reference = 2, tolerance = 0.1, elements = 8, steps = steps }
    local cubic = release(2, "cubic", first)
    b:row { "first, 2 elements, cubic mass", computed = cubic, reference = first, unit = "Hz", tolerance = 3e-3,
      elements = 2, steps = steps }
    local higher, many = release(8, "cubic", second)
    b:row { "second, 8 elements, cubic mass", computed = higher, reference = second, unit = "Hz", tolerance = 8e-4,
      elements = 8, steps = many }
  end,
}
