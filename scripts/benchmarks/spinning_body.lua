-- A free body spins about each of its three principal axes: Euler's equations.
--
-- Run     hinge run scripts/benchmarks/spinning_body.lua
-- Shows   free rotation in space: two axes are stable, and the body turns over about the middle one
-- Expect  the periods of Euler's solution; energy and angular momentum stay
--
-- The body is made of three steel bars that cross in one point. It is stiff: it vibrates 50 times as fast as it spins.
local hinge = require "hinge"
local elliptic = require "hinge.library.numeric".elliptic

local density, side, lengths, spin, tilt = 7850, 0.05, { 1, 0.8, 0.6 }, 20, 0.2 -- kg/m^3, m, m, rad/s, rad/s

-- Moments of inertia about x, y and z, kg m^2: of thin bars, and of their sections.
local function inertias()
  local of, I = {}, side ^ 4 / 12
  for axis = 1, 3 do
    of[axis] = 0
    for i, length in ipairs(lengths) do
      of[axis] = of[axis] + density * (i == axis and 2 * I * length or side ^ 2 * length ^ 3 / 12 + I * length)
    end
  end
  return of
end

-- Spins the body about an axis, with a little about x or z, for a time. Returns the times at which the angular velocity
-- along the axis `watched` of the body is zero, and the run.
local function spinning(axis, disturbed, watched, duration)
  local model = hinge.model { plasticity = false }
  local steel = hinge.material { E = 206e9, density = density }
  local hub, section, tips = model:node { 0, 0, 0 }, hinge.section.solid { width = side, depth = side }, {}
  for i, length in ipairs(lengths) do
    for sign = -1, 1, 2 do
      local at = { 0, 0, 0 }
      at[i] = sign * length / 2
      local tip = model:node(at)
      model:member { hub, tip, section = section, material = steel, group = "body" }
      if i == watched and sign == 1 then tips[1] = tip end
    end
  end
  local omega = { 0, 0, 0 }
  omega[axis], omega[disturbed] = spin, tilt
  model:velocity("body", { 0, 0, 0 }, omega)
  local run = model:dynamic { dt = 2e-3, duration = duration, integrator = "energy-momentum", record = false }
  local zeros, before, last = {}, run:momentum(), nil
  run:on_step(function(r)
    local x, y, z = r:position(tips[1])
    local hx, hy, hz = r:position(hub)
    local _, _, _, wx, wy, wz = r:velocity(hub)
    local along = (x - hx) * wx + (y - hy) * wy + (z - hz) * wz
    if last and last * along < 0 then zeros[#zeros + 1] = r.time - r.dt * along / (along - last) end
    last = along
  end)
  run:finish()
  return zeros, run, before
end

local function mean_gap(zeros) return (zeros[#zeros] - zeros[1]) / (#zeros - 1) end

return hinge.benchmark {
  title = "Body spinning about three axes", kind = "dynamics", fast = true,
  source = "closed form: Euler's equations, Jacobi's elliptic functions",
  run = function(b)
    local I = inertias()
    local row = b:rows_with { elements = 12 }
    -- Half a period of a small wobble about the axis `axis`, with the inertias of the two others.
    local function wobble(axis, one, other)
      return math.pi / (spin * math.sqrt((I[axis] - I[one]) * (I[axis] - I[other]) / (I[one] * I[other])))
    end
    local zeros, run = spinning(3, 1, 1, 3)
    row("largest inertia: half a wobble", mean_gap(zeros), wobble(3, 1, 2), "s", 8e-4, { steps = run.index })
    zeros, run = spinning(1, 3, 3, 3)
    row("least inertia: half a wobble", mean_gap(zeros), wobble(1, 2, 3), "s", 1e-4, { steps = run.index })
    local before
    zeros, run, before = spinning(2, 3, 2, 6)
    local energy, momentum2 = I[2] * spin ^ 2 + I[3] * tilt ^ 2, (I[2] * spin) ^ 2 + (I[3] * tilt) ^ 2 -- twice, squared
    local rate = math.sqrt((I[3] - I[2]) * (momentum2 - energy * I[1]) / (I[1] * I[2] * I[3]))
    local k2 = (I[2] - I[1]) * (energy * I[3] - momentum2) / ((I[3] - I[2]) * (momentum2 - energy * I[1]))
    row("middle one: time between turns", mean_gap(zeros), 2 * elliptic(k2) / rate, "s", 1e-3, { steps = run.index })
    row("angular momentum at the end", run:momentum().angular[2], before.angular[2], "kg m^2/s", 1e-6,
      { steps = run.index })
    row("energy at the end", run.energy.kinetic + run.energy.elastic, energy / 2, "J", 1e-6, { steps = run.index })
  end,
}
