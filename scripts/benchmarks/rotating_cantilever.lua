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
local hinge = require "hinge"

local E, density, side, L, elements = 206e9, 7850, 0.01, 1, 8
local unit = math.sqrt(E * side ^ 2 / 12 / density) / L ^ 2 -- 1/s

-- Angular frequency of the largest harmonic part of a signal near `guess`, rad/s: maximum of the transform under the
-- window of Blackman and Harris.
local function frequency(probe, dt, guess)
  local u, n, cut = probe.value, #probe.value, {}
  for i = 1, n do
    local x = 2 * math.pi * (i - 1) / (n - 1)
    cut[i] = u[i] * (0.35875 - 0.48829 * math.cos(x) + 0.14128 * math.cos(2 * x) - 0.01168 * math.cos(3 * x))
  end
  local function size(w)
    local re, im = 0, 0
    for i = 1, n do
      local a = w * dt * (i - 1)
      re, im = re + cut[i] * math.cos(a), im + cut[i] * math.sin(a)
    end
    return re * re + im * im
  end
  local ratio = (math.sqrt(5) - 1) / 2
  local low, high = 0.9 * guess, 1.1 * guess
  for _ = 1, 30 do
    local a, b = high - ratio * (high - low), low + ratio * (high - low)
    if size(a) > size(b) then high = b else low = a end
  end
  return (low + high) / 2
end

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
