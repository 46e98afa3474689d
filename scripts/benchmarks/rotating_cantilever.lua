-- A spinning cantilever flaps faster, because the centrifugal tension holds it straight.
--
-- Run     hinge run scripts/benchmarks/rotating_cantilever.lua
-- Shows   the geometric stiffness of a tension that changes along a member, in a body that really rotates
-- Expect  frequencies over sqrt(EI / (rho A L^4)) of 3.516 at rest, 4.137, 7.360 and 13.170 at the speeds 2, 6 and 12
--
-- Two equal arms turn about a pin between them. When both tips flap upwards, the slope at the pin is zero: each arm is
-- a cantilever from a hub without radius. The speed of rotation is in the same unit as the frequency. The arms begin
-- without tension, so that they vibrate along their axes, too. Newmark's method ends with an energy error there, unless
-- its steps are much shorter. The warning that the arms can rotate about the pin is what the problem asks for.
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "support/?.lua;" .. package.path
local hinge = require "hinge"
local frequency = require "vibration".frequency

local E, density, side, L, elements = 206e9, 7850, 0.01, 1, 8
local unit = math.sqrt(E * side ^ 2 / 12 / density) / L ^ 2 -- 1/s

local function spinning(spin, guess)
  local model = hinge.model { mass = "cubic", elements_per_member = elements }
  local steel = hinge.material { E = E, density = density }
  local section = hinge.section.solid { width = side, depth = side }
  local hub = model:node { 0, 0, 0 }
  model:fix(hub, "xyz")
  local tips = {}
  for i, x in ipairs { L, -L } do
    tips[i] = model:node { x, 0, 0 }
    model:member { hub, tips[i], section = section, material = steel, group = "arms" }
  end
  model:velocity("arms", { 0, 0, 0 }, { 0, 0, spin })
  for i, x in ipairs { L, -L } do model:velocity(tips[i], { 0, spin * x, 0.01 }, { 0, 0, spin }) end
  local dt = 2 * math.pi / guess / 100
  local run = model:dynamic { dt = dt, duration = 1000 * dt, integrator = "energy-momentum",
    record = false }
  local up = run:probe { node = tips[1], "uz" }
  run:finish()
  return 2 / dt * math.tan(frequency(up, dt, guess) * dt / 2), run -- without the step's own part
end

return hinge.benchmark {
  title = "Flapping of a rotating cantilever", kind = "dynamics", fast = true,
  source = "rotating Euler-Bernoulli beam without hub, solved apart",
  run = function(b)
    for _, case in ipairs { { 0, 3.5160, 2e-4 }, { 2, 4.1373, 2e-4 }, { 6, 7.3604, 1e-3 },
      { 12, 13.1702, 2.5e-3 } } do
      local speed, reference, tolerance = table.unpack(case)
      local w, run = spinning(speed * unit, reference * unit)
      b:row { ("flap frequency at the speed %g"):format(speed), computed = w / unit, reference = reference,
        tolerance = tolerance, elements = 2 * elements, steps = run.index }
    end
  end,
}
