-- The observed order in time of the three integrators.
--
-- Run     hinge run scripts/benchmarks/order_of_integrators.lua
-- Shows   how fast the error of the angle falls when the step is halved
-- Expect  order 2; Newmark's steps lag behind, central differences lead by half as much
--
-- Newmark's method and central differences: a rod that vibrates along its axis, after five periods of its first mode.
-- The frequency of the rod with its elements is known: w = 2 c / l sin(q / 2) with lumped masses, q = pi / (2 n), and
-- w = c / l sqrt(6 (1 - cos q) / (2 + cos q)) with consistent ones. So is the one in the steps, w':
-- tan(w' dt / 2) = w dt / 2 and sin(w' dt / 2) = w dt / 2. The energy-momentum method: a stiff rod that swings as a
-- pendulum from the horizontal, at the fifth passage of its lowest point; the period is an elliptic integral.
local hinge = require "hinge"

local E, density, side, L, n, periods, g = 206e9, 7850, 0.05, 1, 8, 5, 9.80665
local c = math.sqrt(E / density)
local section = hinge.section.solid { width = side, depth = side }
local steel = hinge.material { E = E, density = density }

local function frequency_of(integrator)
  local q = math.pi / (2 * n)
  if integrator == "explicit" then return 2 * c * n / L * math.sin(q / 2) end
  return c * n / L * math.sqrt(6 * (1 - math.cos(q)) / (2 + math.cos(q)))
end

-- Angle by which the first mode of the rod lags behind after five periods, rad.
local function lag_of_rod(integrator, steps)
  local model = hinge.model { displacement = "small", plasticity = false, formulation = "conventional",
    elements_per_member = 1 }
  local nodes = {}
  for i = 0, n do nodes[i] = model:node { L * i / n, 0, 0 } end
  model:fix(nodes[0])
  for i = 1, n do
    model:fix(nodes[i], "y,z,rx,ry,rz")
    model:member { nodes[i - 1], nodes[i], section = section, material = steel }
  end
  for i = 1, n do model:velocity(nodes[i], { math.sin(math.pi * i / (2 * n)), 0, 0 }) end
  local w = frequency_of(integrator)
  local dt = 2 * math.pi / w / steps
  local run = model:dynamic { dt = dt, duration = periods * steps * dt, integrator = integrator, record = false }
  run:finish()
  local closed = integrator == "explicit" and 2 * math.asin(w * dt / 2) or 2 * math.atan(w * dt / 2)
  return -math.atan(w * nodes[n]:displacement(run), nodes[n]:velocity(run)),
    periods * steps * (w * dt - closed), run
end

-- Angle that the pendulum lacks at its lowest point after 2 1/4 periods, rad.
local function lag_of_pendulum(steps)
  local model = hinge.model { plasticity = false }
  local pin, tip = model:node { 0, 0, 0 }, model:node { L, 0, 0 }
  model:fix(pin, "x,y,z,rx,rz")
  model:fix(tip, "y,rx,rz")
  model:member { pin, tip, section = section, material = steel }
  model:gravity { 0, 0, -g }
  local K = 1.8540746773013719 -- at the modulus sin 45 degrees
  local T = 4 * K * math.sqrt((L ^ 2 / 3 + side ^ 2 / 12) / (g * L / 2))
  local run = model:dynamic { dt = T / steps, duration = 2.25 * T, integrator = "energy-momentum", record = false }
  run:finish()
  local x, _, z = tip:position(run)
  return math.atan(x, -z), run
end

return hinge.benchmark {
  title = "Order of the integrators", kind = "dynamics", fast = true,
  source = "closed form: frequencies in the steps; elliptic integral",
  run = function(b)
    for _, integrator in ipairs { "newmark", "explicit" } do
      local coarse = lag_of_rod(integrator, 80)
      local fine, closed, run = lag_of_rod(integrator, 160)
      b:row { integrator .. ": lag, 160 steps a period", computed = fine, reference = closed, unit = "rad",
        tolerance = 4e-4, elements = n, steps = run.index }
      b:row { integrator .. ": observed order", computed = math.log(coarse / fine, 2), reference = 2, tolerance = 2e-3,
        elements = n, steps = run.index }
    end
    local coarse = lag_of_pendulum(200)
    local fine, run = lag_of_pendulum(400)
    b:row { "energy-momentum: observed order", computed = math.log(coarse / fine, 2), reference = 2, tolerance = 0.02,
      elements = 2, steps = run.index }
  end,
}
