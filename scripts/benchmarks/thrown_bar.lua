-- A bar that is thrown flies and turns, lands flat on the ground, and bounces.
--
-- Run     hinge run scripts/benchmarks/thrown_bar.lua
-- Shows   free flight under gravity; the impact of a bar on the ground, flat and at 45 degrees
-- Expect  the parabola; a flat bar that keeps the part e of its speed; the impulse of a rigid rod that lands on one end
--
-- The ground is points on springs. For the oblique impact it is soft, and without loss, so that the bar
-- does not vibrate.
local hinge = require "hinge"

local E, density, side, L, g = 206e9, 7850, 0.05, 1, 9.80665
local section = hinge.section.solid { width = side, depth = side }

-- A bar along (cos a, 0, sin a) with its middle at (0, 0, z).
local function bar(a, z)
  local model = hinge.model { plasticity = false }
  local steel = hinge.material { E = E, density = density }
  local x, up = L / 2 * math.cos(a), L / 2 * math.sin(a)
  local low, high = model:node { -x, 0, z - up }, model:node { x, 0, z + up }
  model:member { low, high, section = section, material = steel, group = "bar" }
  return model, high
end

-- Thrown with 10 m/s along x and up, and 5 rad/s about y: the position of its second end after 2 s.
local function thrown()
  local model, high = bar(0, 0)
  model:gravity { 0, 0, -g }
  model:velocity("bar", { 10, 0, 10 }, { 0, 5, 0 })
  local run = model:dynamic { dt = 1e-3, duration = 2, record = false }:finish()
  local x, _, z = high:position(run)
  return x, z, run
end

-- Falls flat by 0.5 m: its speed upwards after the impact over that before.
local function flat(restitution)
  local model = bar(0, 0.5 + side / 2)
  model:gravity { 0, 0, -g }
  model:ground { restitution = restitution }
  local run = model:dynamic { dt = 2e-5, duration = math.sqrt(2 * 0.5 / g) + 0.05, record = false }:finish()
  local t = run.time - math.sqrt(2 * 0.5 / g)
  return (run:momentum().linear[3] / run:momentum().mass + g * t) / math.sqrt(2 * 0.5 * g), run
end

-- Falls at 0.2 m/s and 45 degrees, without gravity: the velocity of its middle and its rotation after the impact.
local function oblique()
  local model = bar(math.pi / 4, L / 2 * math.sin(math.pi / 4) + side / 2 + 1e-4)
  model:ground { stiffness = 2e5 }
  model:velocity("bar", { 0, 0, -0.2 })
  local run = model:dynamic { dt = 5e-5, duration = 0.03, record = false }:finish()
  local m = run:momentum()
  return m.linear[3] / m.mass, m.angular[2], run
end

return hinge.benchmark {
  title = "Bar that is thrown and bounces", kind = "dynamics", fast = true,
  source = "closed form: parabola, Newton's law of impact, rigid rod that lands on one end",
  run = function(b)
    local function row(what, computed, reference, unit, tolerance, run, scale)
      b:row { what, computed = computed, reference = reference, unit = unit, tolerance = tolerance, elements = 2,
        steps = run.index, scale = scale }
    end
    local x, z, run = thrown()
    row("thrown: x of an end after 2 s", x, 20 + L / 2 * math.cos(10), "m", 1e-4, run)
    row("thrown: z of it", z, 20 - 2 * g - L / 2 * math.sin(10), "m", 3e-4, run, 10)
    local kept
    kept, run = flat(0.5)
    row("flat on the ground, e = 0.5: speed kept", kept, 0.5, "", 4e-3, run)
    -- An impulse P at the end, x = -L/2 cos a from the middle: m v' = P - m v, J w = P x, and the end leaves with v.
    local m, lever = density * side ^ 2 * L, L / 2 * math.cos(math.pi / 4)
    local J = m * L ^ 2 / 12 + density * side ^ 4 / 12 * L
    local P = 2 * 0.2 / (1 / m + lever ^ 2 / J)
    local v, spin
    v, spin, run = oblique()
    row("at 45 degrees: velocity of the middle", v, P / m - 0.2, "m/s", 3e-3, run, 0.2)
    row("at 45 degrees: angular momentum", spin, P * lever, "kg m^2/s", 1e-3, run)
  end,
}
