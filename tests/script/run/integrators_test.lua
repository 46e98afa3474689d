-- Integrators: what they take out, and how fast they converge, against the closed form of one mass on a spring.
--
-- Run: lua5.4 tests/script/run/integrators_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local scenes = require "scenes"
local hinge = require "hinge"
local checks = support.checks "integrators"
local case, expect, largest_of = checks.case, checks.expect, support.largest_of

-- One free degree of freedom: the end of a bar of one element along its axis, k = EA / L, m = rho A L / 3.
local E, density, length = 206e9, 7850, 2
local frequency = math.sqrt(3 * E / density) / length
local function spring(phase_a_step, steps, options)
  local model, b = scenes.cantilever { model = { displacement = "small", formulation = "conventional" },
    length = length, head = "yz", member = { elements = 1 } }
  model:velocity(b, { 1, 0, 0 })
  options.dt, options.record, options.energy_tolerance = phase_a_step / frequency, false, 0
  options.duration = steps * options.dt
  local run = model:dynamic(options)
  return run, run:probe { node = b, "vx" }, run:probe { node = b, "ux" }
end

case("steps far beyond the frequency's period stay stable", function()
  -- Far beyond the frequency's period: Wood, Bossak and Zienkiewicz's method has the double root -rho_infinity there,
  -- so v'' + 2 rho v' + rho^2 v = 0 from step to step.
  for _, rho in ipairs { 1, 0.9, 0.5, 0.2, 0 } do
    local run, v = spring(1e5, 12, { rho_infinity = rho })
    run:finish()
    local worst = 0
    for i = 3, #v.value - 2 do
      local off = v.value[i + 2] + 2 * rho * v.value[i + 1] + rho ^ 2 * v.value[i]
      worst = largest_of(worst, math.abs(off) / largest_of(math.abs(v.value[i]), 1e-4))
    end
    print(("rho_infinity %g: the recurrence holds to %.1e, %.4f of the energy taken out")
      :format(rho, worst, run.energy.numerical / run.energy.initial))
    expect(worst < 1e-5, "rho_infinity %g: off the recurrence by %g", rho, worst)
  end
end)

case("two periods have an error of second order in velocity", function()
  -- the default keeps all energy, the others take out less and less
  for _, rho in ipairs { 1, 0.8, 0.5 } do
    local off, taken = {}, {}
    for i, steps in ipairs { 80, 160, 320 } do
      local run, v, u = spring(4 * math.pi / steps, steps, { rho_infinity = rho })
      for _ = 1, steps / 2 do run:step() end
      local first_period = run.energy.numerical -- the first step is another: its acceleration has no lag yet
      run:finish()
      off[i] = math.sqrt((v.last - 1) ^ 2 + (u.last * frequency) ^ 2) -- two whole periods: as at the start
      taken[i] = (run.energy.numerical - first_period) / run.energy.initial
      expect(math.abs(run.energy.energy_error) < 1e-7 * run.energy.initial, "rho_infinity %g: energy error %g", rho,
        run.energy.energy_error / run.energy.initial)
      expect(rho == 1 and taken[i] == 0 or rho < 1 and taken[i] > 0, "rho_infinity %g: %g taken out", rho, taken[i])
    end
    print(("rho_infinity %g: off by %.2e %.2e %.2e, of the energy taken out by the second period %.1e %.1e %.1e")
      :format(rho, off[1], off[2], off[3], taken[1], taken[2], taken[3]))
    for i = 2, 3 do
      expect(math.abs(off[i - 1] / off[i] - 4) < 0.3,
        "rho_infinity %g: half the step has %.3f times the error", rho, off[i - 1] / off[i])
    end
    if rho < 1 then
      expect(taken[1] / taken[2] > 6 and taken[2] / taken[3] > 6,
        "what is taken out vanishes with the third power of the step: %g, %g", taken[1] / taken[2], taken[2] / taken[3])
    end
  end
end)

case("a body in flight that rotates keeps its momenta and its energy, whatever rho_infinity", function()
  local model = hinge.model {}
  local a, b, c = model:node { 0, 0, 0 }, model:node { 1, 0, 0 }, model:node { 1, 0.4, 0.2 }
  for _, ends in ipairs { { a, b }, { b, c } } do
    model:member { ends[1], ends[2], section = scenes.square, material = scenes.elastic, group = "body" }
  end
  model:velocity("body", { 3, 2, 1 }, { 5, 20, 10 })
  local run = model:dynamic { dt = 1e-4, duration = 0.3, rho_infinity = 0.7, record = false }
  local before = run:momentum()
  run:finish()
  local now, size = run:momentum(), 0
  for axis = 1, 3 do
    expect(math.abs(now.linear[axis] - before.linear[axis]) < 1e-9 * before.mass, "linear momentum, axis %d", axis)
    size = size + (now.angular[axis] - before.angular[axis]) ^ 2
  end
  local whole = math.sqrt(before.angular[1] ^ 2 + before.angular[2] ^ 2 + before.angular[3] ^ 2)
  print(("a body that rotates: angular momentum %.1e, energy error %.1e, taken out %.1e")
    :format(math.sqrt(size) / whole, run.energy.energy_error / run.energy.initial,
    run.energy.numerical / run.energy.initial))
  expect(math.sqrt(size) < 1e-3 * whole and math.abs(run.energy.energy_error) < 1e-4 * run.energy.initial, "rotating")
end)

case("initial stress changes the frequency as theory has it, with every solver", function()
  -- A wire of one element under tension N, whose end swings across it. Its stiffness across is (GA + N) / L, of which
  -- geometric = false leaves N / L out of the operator, not out of the forces. One degree of freedom again, so that
  -- each step can be taken by hand.
  for _, geometric in ipairs { true, false } do
    local GA, N, area, wire = 1e3, 1e5, 0.1, 2
    local shear_area = GA / scenes.elastic.G
    local model, b = scenes.cantilever { model = { formulation = "conventional" }, length = wire, head = "y,rx,ry,rz",
      force = { N, 0, 0 }, member = { elements = 1, section = hinge.section.general { area = area, Ix = 1e-4, Iy = 1e-4,
        J = 1e-4, shear_area_x = shear_area, shear_area_y = shear_area } } }
    model:velocity(b, { 0, 0, 1e-4 })
    local start = model:static { steps = 1 }:finish()
    local m, k = density * area * wire / 3, (GA + N) / wire
    local dt, beta = 1 / math.sqrt(k / m), 0.25
    local run = model:dynamic { from = start, dt = dt, duration = 40 * dt, beta = beta, iterations = 1,
      internals = { predictor = "acceleration", geometric = geometric }, energy_tolerance = 0, record = false }
    local probe = run:probe { node = b, "uz" }
    run:finish()
    local u, v, acceleration, by_hand = 0, 1e-4, 0, {}
    local solved = m + beta * dt ^ 2 * (geometric and k or GA / wire)
    for i = 1, 40 do
      local reached = u + dt * v + dt ^ 2 / 2 * acceleration
      local change = (-k * reached - m * acceleration) / solved
      u, v = reached + beta * dt ^ 2 * change, v + dt * (acceleration + change / 2)
      acceleration = acceleration + change
      by_hand[i] = u
    end
    for i = 1, 40 do -- the swing is about v / omega
      checks.near(probe.value[i + 1], by_hand[i], 1e-3 * 1e-4 * dt,
        ("geometric = %s: step %d by hand"):format(geometric, i))
    end
    for _, effect in ipairs(run.effects) do
      if effect.name == "geometric stiffness" then
        expect(effect.active == geometric, "geometric = %s: the effect is active: %s", geometric, effect.active)
        expect(effect.because == (geometric and "part of large displacement" or "geometric = false"), "because %s",
          effect.because)
      end
    end
  end
end)

checks.done()
