-- Integrators. The energy-momentum method (integrator = "energy-momentum"): energy and both momenta stay, in rotations
-- of any size and in long steps; order two; hinges dissipate; loads, damping and what else acts is counted; the same
-- bits again; what it does not go with is refused. Newmark's method: what it takes out, and initial stress.
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local scenes = require "scenes"
local hinge = require "hinge"
local checks = support.checks "integrators"
local case, expect, equal, refused = checks.case, checks.expect, checks.equal, checks.refused
local largest_of = support.largest_of

local function with(...) return scenes.with({ integrator = "energy-momentum", record = false }, ...) end
--- |a - b| / |a|
local function apart(a, b)
  local difference, size = 0, 0
  for i = 1, 3 do difference, size = difference + (a[i] - b[i]) ^ 2, size + a[i] ^ 2 end
  return math.sqrt(difference / size)
end
local function largest_energy(run)
  local largest = 0
  for name, value in pairs(run.energy) do
    if name ~= "energy_error" and name ~= "remainder" then largest = largest_of(largest, math.abs(value)) end
  end
  return largest
end

--- Takes a run to its end, where its momenta (without `linear` the angular one alone) are as before, within these parts
--- of them. Returns its energy error as a part of the energy at its start.
local function keeps(what, run, angular, linear)
  local before = run:momentum()
  run:finish()
  local now = run:momentum()
  equal(run.verdict, "completed", what .. ": " .. run.reason)
  for kind, within in pairs { angular = angular, linear = linear } do
    expect(apart(before[kind], now[kind]) < within, "%s: %s momentum changes by %g", what, kind,
      apart(before[kind], now[kind]))
  end
  return run.energy.energy_error / run.energy.initial
end

-- The right-angle cantilever of Simo and Vu-Quoc (Comp. Meth. Appl. Mech. Eng. 66, 1988), with their step -------------
-- Two legs of 10 m, GA = EA = 1e6 N, EI = GJ = 1e3 N m^2, 1 kg/m, rotary inertia 20, 10, 10 kg m; the elbow is pushed
-- out of the plane by 0 -> 50 -> 0 N in 2 s.
local function cantilever(options)
  local model = hinge.model { elements_per_member = 10, mass = options.mass or "cubic", p_delta = options.p_delta }
  local foot, elbow, tip = model:node { 0, 0, 0 }, model:node { 10, 0, 0 }, model:node { 10, 10, 0 }
  local material = hinge.material { E = 1e6, nu = -0.5, density = 1 }
  local section = hinge.section.general { area = 1, Ix = 1e-3, Iy = 1e-3, J = 1e-3, shear_area_x = 1, shear_area_y = 1,
    mass_Ix = options.slender and 1e-3 or 10, mass_Iy = options.slender and 1e-3 or 10 }
  model:member { foot, elbow, section = section, material = material }
  model:member { elbow, tip, section = section, material = material }
  model:fix(foot)
  model:load { node = elbow, force = { 0, 0, 50 }, history = { { 0, 0 }, { 1, 1 }, { 2, 0 }, { 1000, 0 } } }
  local run = model:dynamic(with({ dt = 0.25, duration = 60 }, options.run))
  return run, run:probe { node = elbow, "uz" }, run:probe { node = tip, "uz" }
end
case("a cantilever swings like that of Newmark's method, with the energy kept", function()
  --- The extreme of a probe between two times, s.
  local function extreme(probe, from, to)
    local most = 0
    for i, t in ipairs(probe.time) do
      if t >= from and t <= to and math.abs(probe.value[i]) > math.abs(most) then most = probe.value[i] end
    end
    return most
  end
  for _, row in ipairs { { mass = "cubic" }, { mass = "linear" },
    { mass = "cubic", p_delta = "chord", run = { step_control = 0 } },
    { mass = "cubic", run = { dt = 0.5, duration = 200 } }, { mass = "cubic", slender = true },
    { mass = "linear", slender = true } } do
    local run, elbow, tip = cantilever(row)
    local what = ("cantilever%s, %s mass, steps of %g s"):format(row.slender and ", slender" or "", row.mass,
      row.run and row.run.dt or 0.25)
    local after, worst = nil, 0
    run:on_step(function(r)
      if r.time < 2.001 then return end
      local energy = r.energy.kinetic + r.energy.elastic
      after = after or energy
      worst = largest_of(worst, math.abs(energy / after - 1))
    end)
    run:finish()
    equal(run.verdict, "completed", what .. ": " .. run.reason)
    after = after or 0 / 0 -- where it ended before
    expect(worst < 1e-6, "%s: energy after the push changes by %g of it", what, worst)
    expect(math.abs(run.energy.energy_error) < 1e-6 * after, "%s: energy error %g", what, run.energy.energy_error)
    if (row.run or {}).dt == nil and not row.slender then
      checks.near(after, 114.8, 2.5, what .. ": energy after the push")
      checks.near(extreme(elbow, 0, 5), 5.5, 0.15, what .. ": elbow, first swing")
      checks.near(extreme(elbow, 9, 13), -4.06, 0.2, what .. ": elbow, second swing")
      checks.near(extreme(tip, 5, 10), 8.2, 0.2, what .. ": tip, first swing")
      checks.near(extreme(tip, 13, 18), -9.7, 0.2, what .. ": tip, second swing")
    end
  end
end)

case("a bar with its own rotary inertia swings at the frequency of theory", function()
  -- Slender, with the rotary inertia of its own section, it is not for Newmark's method, which says what is.
  local run = cantilever { mass = "cubic", slender = true, run = { integrator = "newmark", dt = 0.01 } }
  run:finish()
  equal(run.verdict, "failed", "slender cantilever by Newmark's method")
  expect(run.reason:find("(energy_tolerance 1 %)", 1, true)
    and (run.reason:find(" holds: tried", 1, true) or run.reason:find(" may hold", 1, true)),
    "it names a remedy: %s", run.reason)
end)

-- A free frame that tumbles: both momenta, and the energy -------------------------------------------------------------
case("a free frame that tumbles keeps momenta and energy", function()
  local function tumbling(mass)
    local model = hinge.model { elements_per_member = 2, mass = mass }
    local section = hinge.section.solid { width = 0.05, depth = 0.1 }
    local n = { model:node { 0, 0, 0 }, model:node { 2, 0, 0 }, model:node { 2, 1.5, 0 }, model:node { 0, 1.5, 1 } }
    for _, ends in ipairs { { 1, 2 }, { 2, 3 }, { 3, 4 }, { 4, 1 }, { 1, 3 } } do
      model:member { n[ends[1]], n[ends[2]], section = section, material = scenes.elastic, group = "frame" }
    end
    model:mass { node = n[3], mass = 20, inertia = { 0.5, 1, 2 } }
    model:velocity("frame", { 3, -2, 5 }, { 4, 11, -7 }) -- rad/s: two turns in a second
    return model
  end
  for _, mass in ipairs { "linear", "cubic" } do
    for _, dt in ipairs { 1e-3, 0.02 } do
      local run = tumbling(mass):dynamic(with { dt = dt, duration = 1.2, tolerance = 1e-12 })
      local what = ("tumbling, %s mass, steps of %g s"):format(mass, dt)
      local off = keeps(what, run, 1e-9, 1e-9)
      expect(math.abs(off) < 1e-9, "%s: energy error %g", what, off)
      expect(run.energy.elastic > 1e-6 * run.energy.initial, "%s: it deforms", what)
    end
  end
end)

case("a mass beside the end of a bar in flight keeps momenta and energy", function()
  -- Its momentum depends on where the bar has turned to. The mean over a step is of second order, so that some energy
  -- is missed: 0.004 % of it in steps of 22 mrad.
  local model, b, bar = scenes.cantilever { foot = false }
  model:mass { node = b, mass = 20, offset = { 0.1, 0.2, 0.3 } }
  model:velocity(bar, { 3, -2, 5 }, { 4, 11, -7 })
  local run, worst = model:dynamic(with { dt = 2e-3, duration = 1, tolerance = 1e-12 }), 0
  run:on_step(function(r) worst = largest_of(worst, math.abs(r.energy.energy_error)) end)
  keeps("a mass beside a bar", run, 1e-9, 1e-9)
  expect(worst < 2e-4 * run.energy.initial, "a mass beside a bar: energy error %g of it", worst / run.energy.initial)
end)

-- A bar that spins about its axis, or across it, for a hundred turns in steps of a tenth of a radian and more ---------
case("a bar that spins a hundred turns keeps its energy", function()
  for _, spin in ipairs { { 300, 0, 0 }, { 0, 0, 300 }, { 300, 5, 0 } } do
    local model, _, bar = scenes.cantilever { foot = false }
    model:velocity(bar, { 0, 0, 0 }, spin)
    local what = ("bar spinning at %g, %g, %g rad/s"):format(table.unpack(spin))
    local off = keeps(what, model:dynamic(with { dt = 1e-3, duration = 2.1, tolerance = 1e-12 }), 1e-8)
    expect(math.abs(off) < 1e-8, "%s: energy error %g", what, off)
  end
end)

-- Order two: a soft bent bar that swings far, against steps a sixteenth as long ---------------------------------------
local function swinging(dt, options)
  local model = hinge.model { elements_per_member = 4 }
  local a, b, c = model:node { 0, 0, 0 }, model:node { 1, 0, 0 }, model:node { 1, 1, 0 }
  local material = hinge.material { E = 2e5, nu = 0.3, density = 1000 }
  local section = hinge.section.solid { width = 0.1, depth = 0.1 }
  model:member { a, b, section = section, material = material }
  model:member { b, c, section = section, material = material }
  model:fix(a, "xyz")
  model:gravity { 3, -9.81, 6 }
  local run = model:dynamic(with({ dt = dt, duration = 0.4 }, options))
  local x, z = run:probe { node = c, "ux" }, run:probe { node = c, "uz" }
  run:finish()
  equal(run.verdict, "completed", "swinging: " .. run.reason)
  return x.last, z.last, run
end
case("the error falls with the square of the step", function()
  local x, z = swinging(1.25e-4)
  local function error_of(dt)
    local at_x, at_z = swinging(dt)
    return math.sqrt((at_x - x) ^ 2 + (at_z - z) ^ 2)
  end
  -- at least: the errors at 1 ms are not all of the leading term yet (5.7 to 0.5 ms)
  local coarse, fine = error_of(1e-3), error_of(5e-4)
  expect(coarse / fine > 3.5 and coarse / fine < 8, "order two: errors %g and %g m", coarse, fine)
  local by_newmark = { swinging(1.25e-4, { integrator = "newmark" }) }
  expect(math.abs(by_newmark[1] - x) < 2e-3 and math.abs(by_newmark[2] - z) < 2e-3,
    "Newmark's method goes to the same place: %g and %g m, %g and %g m", by_newmark[1], x, by_newmark[2], z)
end)

-- What acts is counted: the balance closes to the tolerance, however long the steps -----------------------------------
local function bent(o)
  local model = hinge.model { elements_per_member = 4, mass = "cubic" }
  local material = hinge.material { E = 206e9, density = 7850, yield_stress = o.yield }
  local section = hinge.section.solid { width = 0.05, depth = 0.1 }
  local a, b, c, d = model:node { 0, 0, 0 }, model:node { 0, 0, 2 }, model:node { 2, 0, 2 }, model:node { 2, 1, 2 }
  for _, ends in ipairs { { a, b }, { b, c }, { c, d } } do
    model:member { ends[1], ends[2], section = section, material = material, group = "all" }
  end
  model:fix(a)
  return model, a, d
end
local function balance(what, model, within, options)
  for _, dt in ipairs { 4e-3, 1e-3 } do
    local run = model:dynamic(with({ dt = dt, duration = 0.2, tolerance = 1e-11 }, options))
    local dissipated, least = 0, 0
    run:on_step(function(r)
      local plastic = r.energy.plastic or 0
      least = support.smallest_of(least, plastic - dissipated)
      dissipated = plastic
    end)
    run:finish()
    equal(run.verdict, "completed", what .. ": " .. run.reason)
    expect(math.abs(run.energy.energy_error) < within * largest_energy(run), "%s, steps of %g s: energy error %g of it",
      what, dt, run.energy.energy_error / largest_energy(run))
    expect(least >= 0, "%s: no step gives back what was dissipated, %g J", what, least)
    if what == "plastic" then
      expect(dissipated > 0.5 * run.energy.initial, "plastic: it dissipates, %g of %g J", dissipated,
        run.energy.initial)
    end
  end
end
case("loads, damping, contact and hinges are in the energy balance", function()
  local model, _, d = bent {}
  model:gravity { 0, 0, -9.81 }
  model:velocity(d, { 0, 20, 30 }, { 0, 0, 0 })
  model:mass { node = d, mass = 20, inertia = { 1, 2, 3 } }
  balance("weight and a mass", model, 1e-6)
  model, _, d = bent {}
  model:velocity(d, { 0, 20, 30 }, { 0, 0, 0 })
  model:damping { alpha = 5, beta = 1e-4 }
  balance("damping", model, 1e-6)
  model = bent { yield = 250e6 }
  model:velocity("all", { 0, 20, 0 }, { 0, 0, 0 })
  balance("plastic", model, 1e-6)
  model, _, d = bent {}
  model:load { node = d, force = { 1e3, 0, 0 }, moment = { 0, 3e3, 2e3 } }
  balance("a force and a moment", model, 1e-6)
end)

-- The same bits: from a checkpoint, on several threads ----------------------------------------------------------------
case("checkpoints, threads and steps taken back change no bit of the energy-momentum method", function()
  local file = support.temporary_folder() .. "/checkpoint"
  local function run_of(threads)
    local model, _, d = bent { yield = 250e6 }
    model:gravity { 0, 0, -9.81 }
    model:velocity("all", { 0, 10, 0 }, { 0, 0, 0 })
    model:load { node = d, force = { 0, 0, 5e3 }, history = { { 0, 0 }, { 0.05, 1 }, { 0.1, 0 } } }
    model:damping { alpha = 1, beta = 1e-5 }
    return model:dynamic(with { dt = 2e-3, duration = 0.1, threads = threads })
  end
  local whole = run_of(1)
  for step in whole:steps() do
    if step.index == 20 then whole:checkpoint(file) end
  end
  equal(whole.verdict, "completed", "bits: " .. whole.reason)
  for threads = 1, whole.index < 20 and 0 or 3 do
    equal(run_of(threads):finish().hash, whole.hash, ("bits of %d threads"):format(threads))
    equal(run_of(threads):resume(file):finish().hash, whole.hash, ("from a checkpoint, %d threads"):format(threads))
  end
  local by_newmark = bent { yield = 250e6 }:dynamic { dt = 2e-3, duration = 0.1 }
  refused("is of another run", by_newmark.resume, by_newmark, file)
end)

-- What it does not go with --------------------------------------------------------------------------------------------
case("options and effects that the energy-momentum method cannot take are refused", function()
  local goes_not = " does not go with %s yet; leave that out, or take 'newmark' or 'explicit'"
  local no_meaning = "field '%s' has no meaning with integrator = 'energy-momentum'; leave it out"
  for _, row in ipairs { -- words, what the model has, options of model:dynamic, of the model
    { goes_not:format "contact", function(model) model:contact { rule = "gap" } end },
    { goes_not:format "fracture", function(model) model:fracture { axial_strain = 0.1 } end },
    { goes_not:format "ground", function(model) model:ground { point = { 0, 0, -1 } } end },
    { goes_not:format "moving supports", function(model, b) model:move { node = b, z = function(t) return t end } end },
    { no_meaning:format "beta", nil, { beta = 0.5 } },
    { no_meaning:format "rho_infinity", nil, { rho_infinity = 0.5 } },
    { " is for large rotations; ", nil, nil, { displacement = "small" } },
    { " needs an energy balance that closes, ", nil, nil, { shift = "elastic_and_plastic" } },
    { { "field 'dt' is 'auto'", " needs a number in s" }, nil, { dt = "auto" } },
  } do
    local model, b = scenes.cantilever { model = row[4] }
    if row[2] then row[2](model, b) end
    local says = refused(row[1], function() model:dynamic(with({ dt = 1e-3, duration = 0.1 }, row[3])) end)
    expect(support.says(says, "model:dynamic: ...integrator = 'energy-momentum'..."), "whose: %s", says)
  end
end)

-- Newmark's method ----------------------------------------------------------------------------------------------------

-- One free degree of freedom: the end of a bar of one element along its axis, k = EA / L, m = rho A L / 3.
local E, density, length = 206e9, 7850, 2
local frequency = math.sqrt(3 * E / density) / length
case("steps far beyond the frequency's period stay stable", function()
  -- Wood, Bossak and Zienkiewicz's method has the double root -rho_infinity there, so v'' + 2 rho v' + rho^2 v = 0 from
  -- step to step. (tests/unit/integrators_test.cpp has order and energy of steps of any length.)
  for _, rho in ipairs { 1, 0.9, 0.5, 0.2, 0 } do
    local model, b = scenes.cantilever { model = { displacement = "small", formulation = "conventional" },
      length = length, head = "yz", member = { elements = 1 } }
    model:velocity(b, { 1, 0, 0 })
    local dt = 1e5 / frequency
    local run = model:dynamic { dt = dt, duration = 12 * dt, rho_infinity = rho, energy_tolerance = 0, record = false }
    local v, worst = run:probe { node = b, "vx" }, 0
    run:finish()
    for i = 3, #v.value - 2 do
      local off = v.value[i + 2] + 2 * rho * v.value[i + 1] + rho ^ 2 * v.value[i]
      worst = largest_of(worst, math.abs(off) / largest_of(math.abs(v.value[i]), 1e-4))
    end
    expect(worst < 1e-5, "rho_infinity %g: off the recurrence by %g", rho, worst)
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
  local off = keeps("rotating", run, 1e-3, 2.6e-10) -- 1e-9 m/s of 3.7 m/s
  expect(math.abs(off) < 1e-4, "rotating: energy error %g", off)
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
