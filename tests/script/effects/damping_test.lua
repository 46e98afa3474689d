-- Rayleigh damping: decay against closed forms, what it leaves alone, and the energy that it takes.
--
-- Run: lua5.4 tests/script/effects/damping_test.lua
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local scenes = require "scenes"
local hinge = require "hinge"
local checks = support.checks "damping"
local case, expect, equal, near = checks.case, checks.expect, checks.equal, checks.near
local largest_of = support.largest_of
local folder = support.temporary_folder()

-- An axial spring with all its mass at the end: one element, lumped on a free node, is one degree of freedom. With
-- consistent mass it is one too, its mass a third of the bar's instead of half.
local E, A, L, rho = 1e6, 1e-2, 1, 7800
local function bar(options)
  local model, tip = scenes.cantilever { length = L, model = { displacement = options.displacement or "small",
    elements_per_member = 1, formulation = "conventional" }, member = { group = "bar",
    section = hinge.section.solid { width = 0.1, depth = 0.1 },
    material = hinge.material { E = E, nu = 0.3, density = rho } } }
  model:fix(tip, "yz")
  return model, tip
end
local function omega_of(explicit) return math.sqrt(E * A / L / (rho * A * L * (explicit and 0.5 or 1 / 3))) end

-- x of z and w from rest at 0 with speed v.
local function decay(z, w, v, t)
  local wd = w * math.sqrt(1 - z * z)
  return v / wd * math.exp(-z * w * t) * math.sin(wd * t)
end

case("a damped oscillator decays as exp(-z w t), with Newmark and explicit steps", function()
  for _, explicit in ipairs { false, true } do
    for _, displacement in ipairs { "small", "large" } do
      for _, kind in ipairs { "alpha", "beta", "both" } do
        local w = omega_of(explicit)
        local z = 0.05
        local T = 2 * math.pi / w
        local model, tip = bar { displacement = displacement }
        model:damping { alpha = kind ~= "beta" and (kind == "both" and z * w or 2 * z * w) or 0,
          beta = kind ~= "alpha" and (kind == "both" and z / w or 2 * z / w) or 0 }
        local v = 1e-3
        model:velocity(tip, { v, 0, 0 })
        local run = model:dynamic { dt = T / 400, duration = 5 * T, record = false, rest = false,
          integrator = explicit and "explicit" or "newmark", precision = not explicit and "double" or nil,
          solver = not explicit and "direct" or nil }
        local probe = run:probe { node = tip, "ux" }
        run:finish()
        equal(run.verdict, "completed", "one degree of freedom")
        local worst = 0
        for i, t in ipairs(probe.time) do
          worst = largest_of(worst, math.abs(probe.value[i] - decay(z, w, v, t)) / (v / w))
        end
        local what = ("%s, %s, %s"):format(explicit and "explicit" or "implicit", displacement, kind)
        expect(worst < 2e-3, "%s: off the closed form by %.3g of the amplitude", what, worst)
        local e = run.energy
        local open = math.abs(e.energy_error) / e.initial
        local lost = (e.initial - e.kinetic - e.elastic) / e.initial
        near(e.damping / e.initial, lost, not explicit and displacement == "small" and 1e-12 or 1e-4, what
          .. ": account")
        expect(lost > 0.9, "%s: lost %.3g", what, lost)
        expect(open < (not explicit and displacement == "small" and 1e-12 or 1e-4), "%s: open by %.3g", what, open)
      end
    end
  end
end)

case("the error of explicit damped steps falls with their square", function()
  local open = {}
  for i, n in ipairs { 100, 200 } do
    local model, tip = bar {}
    local w = omega_of(true)
    model:damping { alpha = 0.05 * w, beta = 0.05 / w }
    model:velocity(tip, { 1e-3, 0, 0 })
    local T = 2 * math.pi / w
    local run = model:dynamic { dt = T / n, duration = 3 * T, integrator = "explicit", record = false, rest = false }
    run:finish()
    open[i] = math.abs(run.energy.energy_error) / run.energy.initial
  end
  expect(open[1] / open[2] > 3 and open[1] < 1e-2, "explicit balance: %.3g, %.3g at half the step", open[1], open[2])
end)

-- The first two modes of a cantilever, each set off by its own velocities; by ratios at their periods. The mean over a
-- period of the logarithm of the energy falls by 2 z w T from one period to the next.
local function mode(number, explicit)
  local n, length, side = 5, 3, 0.1
  local c = math.sqrt(206e9 * side ^ 2 / 12 / 7850)
  local k = { 1.8751040687 / length, 4.6940911330 / length }
  local w = { k[1] ^ 2 * c, k[2] ^ 2 * c }
  local z = { 0.02, 0.05 }
  local model = hinge.model { displacement = "small", elements_per_member = 2 }
  local nodes = {}
  for i = 0, n do nodes[i] = model:node { length * i / n, 0, 0 } end
  model:fix(nodes[0])
  local section = hinge.section.solid { width = side, depth = side }
  local steel = hinge.material { E = 206e9, nu = 0.3, density = 7850 }
  for i = 1, n do
    model:member { nodes[i - 1], nodes[i], section = section, material = steel, up = { 0, 0, 1 } }
  end
  local alpha, beta = model:damping { ratio = z, periods = { 2 * math.pi / w[1], 2 * math.pi / w[2] } }
  for i = 1, 2 do
    near(alpha / (2 * w[i]) + beta * w[i] / 2, z[i], 1e-12, "ratio of the coefficients at period " .. i)
  end
  local a = k[number]
  local function cosh(x) return (math.exp(x) + math.exp(-x)) / 2 end
  local function sinh(x) return (math.exp(x) - math.exp(-x)) / 2 end
  local s = (math.cos(a * length) + cosh(a * length)) / (math.sin(a * length) + sinh(a * length))
  for i = 1, n do
    local x = a * length * i / n
    local v = cosh(x) - math.cos(x) - s * (sinh(x) - math.sin(x))
    local turn = a * (sinh(x) + math.sin(x) - s * (cosh(x) - math.cos(x)))
    model:velocity(nodes[i], { 0, 0, v }, { 0, -turn, 0 })
  end
  local T = 2 * math.pi / w[number]
  local run = model:dynamic { dt = explicit and "auto" or T / 200, duration = 3 * T, record = false,
    integrator = explicit and "explicit" or "newmark" }
  local sum, steps = { 0, 0, 0 }, { 0, 0, 0 }
  for step in run:steps() do
    if not explicit or step.index % 16 == 0 then
      local period = math.min(3, math.ceil(step.time / T))
      sum[period] = sum[period] + math.log(run.energy.kinetic + run.energy.elastic)
      steps[period] = steps[period] + 1
    end
  end
  local ratio = (sum[1] / steps[1] - sum[3] / steps[3]) / (4 * w[number] * T)
  local what = ("%s, mode %d"):format(explicit and "explicit" or "implicit", number)
  near(ratio / z[number], 1, explicit and 0.06 or 0.02, what .. ": ratio") -- of lumped masses, mode 2 is lower
  near(run.energy.energy_error / run.energy.initial, 0, explicit and 1e-3 or 1e-6, what .. ": balance")
end
case("the first two modes of a cantilever lose 2 z w T of energy a period", function()
  mode(1, false)
  mode(2, false)
  mode(2, true)
end)

-- A bar that spins and flies freely keeps both under beta alone: it is not damped as a whole. alpha slows both.
local function spinning(damping, duration)
  local model = hinge.model { elements_per_member = 4 }
  local ends = { model:node { 0, 0, 0 }, model:node { 2, 0, 0 } }
  model:member { ends[1], ends[2], section = hinge.section.solid { width = 0.05, depth = 0.05 },
    material = hinge.material { E = 206e9, nu = 0.3, density = 7850 }, group = "bar" }
  model:velocity("bar", { 1, 2, 3 }, { 0, 0, 30 })
  if damping then model:damping(damping) end
  -- stretched by its spin, it would else begin to swing along its axis
  local run = model:dynamic { dt = 1e-4, duration = duration or 0.2, record = false, iterations = 8, solver = "direct" }
  run:finish()
  equal(run.verdict, "completed", "a spinning bar")
  local momentum = {}
  local a, b = { run:velocity(ends[1]) }, { run:velocity(ends[2]) }
  for i = 1, 3 do momentum[i] = (a[i] + b[i]) / 2 end
  return momentum, (a[6] + b[6]) / 2, run
end
case("a free bar that spins is slowed by alpha and not by beta", function()
  local momentum, spin, run = spinning { beta = 2e-4 }
  local _, sooner = spinning({ beta = 2e-4 }, 0.1) -- it has stretched by its spin, and stays so
  near(spin / sooner, 1, 1e-8, "spin under beta")
  near(spin, 30 * (1 - 2 * 7850 * 30 ^ 2 * 2 / 5 / 206e9), 1e-4, "by as much as it stretches")
  for i = 1, 3 do near(momentum[i], i, 1e-8, "momentum under beta, axis " .. i) end
  near(run.energy.energy_error / run.energy.initial, 0, 1e-5, "its balance")
  expect(run.energy.damping >= 0 and run.energy.damping < 1e-4 * run.energy.initial, "lost %.3g", run.energy.damping)
  local slower, slow_spin = spinning { alpha = 2 }
  near(slow_spin, 30 * math.exp(-0.4), 0.01, "spin under alpha")
  for i = 1, 3 do near(slower[i], i * math.exp(-0.4), 1e-5, "momentum under alpha, axis " .. i) end
end)

-- What it must leave alone --------------------------------------------------------------------------------------------

-- Two portals that swing apart from one another; with yield, large displacement.
local function portals(options)
  local model, tops = hinge.model(options.model), {}
  local steel = hinge.material { E = 206e9, nu = 0.3, density = 7850, yield_stress = options.yield }
  local section = hinge.section.solid { width = 0.1, depth = 0.1 }
  for i, y in ipairs { 0, 5 } do
    local a, b, c, d = model:node { 0, y, 0 }, model:node { 0, y, 3 }, model:node { 3, y, 3 }, model:node { 3, y, 0 }
    model:fix { a, d }
    for _, pair in ipairs { { a, b }, { b, c }, { c, d } } do
      model:member { pair[1], pair[2], section = section, material = steel, group = i == 1 and "near" or "far" }
    end
    model:velocity(b, { options.speed or 1, 0, 0 })
    tops[i] = b
  end
  if options.declare then options.declare(model, tops) end
  return model:dynamic(scenes.with({ dt = 1e-4, duration = 0.05, record = false }, options.run)), tops, model
end
local function ended(options)
  local run, tops, model = portals(options)
  run:finish()
  expect(run.verdict == "completed", "portals: %s", run.reason)
  return run, tops, model
end

case("damping of zero changes no bit and the last declaration counts", function()
  local plain = ended {}
  equal(ended { declare = function(m) m:damping { alpha = 0, beta = 0 } end }.hash, plain.hash, "nothing declared")
  equal(ended { declare = function(m)
    m:damping { ratio = 0.1, periods = { 0.3, 0.1 } }
    m:damping { alpha = 0 }
  end }.hash, plain.hash, "the last declaration counts")
  expect(ended { declare = function(m) m:damping { alpha = 1 } end }.hash ~= plain.hash, "the hash sees damping")
end)

case("damping of a group changes no bit of the other members", function()
  local function declare(m) m:damping { ratio = 0.1, periods = { 0.3, 0.1 }, group = "near" } end
  local options = { solver = "direct", internals = { predictor = "displacement" } }
  local run, again = ended { declare = declare, run = options }
  local bare, bare_tops = ended { run = options }
  local damped, free = run:displacement(again[1]), run:displacement(again[2])
  local of_near, of_far = bare:displacement(bare_tops[1]), bare:displacement(bare_tops[2])
  expect(math.abs(damped / of_near - 1) > 0.01, "the damped portal is another: %.6g, %.6g", damped, of_near)
  near(free / of_far, 1, 1e-9, "the other portal")
end)

case("damping changes nothing in statics", function()
  local function hash(declare)
    local model, tip = bar { displacement = "large" }
    if declare then model:damping { ratio = 0.1, periods = { 1, 1 } } end
    model:load { node = tip, force = { -50, 0, 0 } }
    return model:static({ steps = 3 }):finish().hash
  end
  equal(hash(true), hash(false), "statics")
end)

case("a damped body may rest", function()
  local model, tip = bar { displacement = "large" }
  model:damping { ratio = 0.1, periods = { 0.3, 0.1 } }
  model:load { node = tip, force = { 50, 0, 0 } }
  local run = model:dynamic { from = model:static({}):finish(), dt = 1e-3, duration = 0.02, record = false }
  local before = run.hash
  run:finish()
  expect(#run.state_changes >= 1 and not run.state_changes[1].awake, "a damped body rests")
  expect(before ~= nil and run.energy.damping == 0, "at rest it loses %.3g", run.energy.damping)
end)

-- Yielding, strong damping, many integrators: the balance closes ------------------------------------------------------

local strong = function(m) m:damping { ratio = 0.3, periods = { 0.5, 0.05 } } end
for what, run_options in pairs {
  ["short steps"] = { dt = 2e-5, duration = 0.02 },
  ["long steps"] = { dt = 5e-4, precision = "double" },
  ["dissipative"] = { dt = 2e-5, duration = 0.01, rho_infinity = 0.8 },
  ["dt auto"] = { dt = "auto", duration = 0.01 },
  ["explicit"] = { dt = "auto", integrator = "explicit", duration = 0.001 },
} do
  case("strong damping keeps the energy balance of yielding portals: " .. what, function()
    -- explicit steps have less mass at the node that alone is given a velocity
    local speed = run_options.integrator == "explicit" and 30 or 20
    local run = ended { yield = 100e6, speed = speed, declare = strong, run = run_options }
    local e = run.energy
    expect(math.abs(e.energy_error) < 1e-2 * e.initial, "%s, yielding: open by %.3g", what, e.energy_error / e.initial)
    expect(e.plastic > 0 and e.damping > 0.1 * e.initial, "%s: plastic %.3g, damping %.3g of %.3g", what,
      e.plastic, e.damping, e.initial)
  end)
end

-- Checkpoints and steps that are taken back ---------------------------------------------------------------------------

for what, options in pairs {
  ["implicit"] = { run = { dt = 5e-5, duration = 0.02 } },
  ["explicit"] = { run = { dt = "auto", integrator = "explicit", duration = 0.0005 } },
  ["step control"] = { run = { dt = 2e-3, step_control = 1e-4 } },
} do
  case("checkpoints and steps taken back change no bit of damped runs: " .. what, function()
    options.yield, options.speed, options.declare = 250e6, 20, strong
    local whole = ended(options)
    local watched = portals(options)
    for _ = 1, whole.index // 2 do watched:step() end
    watched:checkpoint(folder .. "/one.checkpoint")
    local other = portals(options):resume(folder .. "/one.checkpoint")
    other:finish()
    watched:finish()
    for name, run in pairs { resumed = other, watched = watched } do
      equal(run.hash, whole.hash, ("%s, %s: state"):format(what, name))
      for _, account in ipairs { "damping", "plastic", "energy_error" } do
        equal(run.energy[account], whole.energy[account], ("%s, %s: %s"):format(what, name, account))
      end
    end
    if options.run.step_control then
      expect(whole.counts.rejected_steps > 2, "steps taken back: %d", whole.counts.rejected_steps)
      local e = whole.energy
      expect(math.abs(e.energy_error) <= 1e-4 * e.initial, "step control holds the balance: %.3g",
        e.energy_error / e.initial)
    end
  end)
end

case("a function that fails in a damped step takes it back whole", function()
  local function failing(fails)
    return { speed = 20, run = { dt = 2e-5, duration = 5e-3 }, declare = function(m, tops_of)
      strong(m)
      m:load { node = tops_of[1], force = function(t)
        if fails and t > 0.002 then
          fails = false
          error "once"
        end
        return { 100 * t, 0, 0 }
      end }
    end }
  end
  local run = portals(failing(true))
  expect(not pcall(run.finish, run), "the function fails")
  run:finish()
  local whole = ended(failing(false))
  equal(run.hash, whole.hash, "after an error: state")
  equal(run.energy.damping, whole.energy.damping, "after an error: account")
end)

case("members that break are damped no more and keep the balance", function()
  local run = ended { yield = 250e6, speed = 60, declare = function(m)
    strong(m)
    m:fracture { curvature_x = 0.05, curvature_y = 0.05, axial_strain = 0.05 }
    m:contact {}
  end, run = { dt = 2e-5 } }
  expect(run:count { state = "broken" } > 0, "nothing breaks")
  local e = run.energy
  expect(math.abs(e.energy_error) < 1e-2 * e.initial, "breaking: open by %.3g", e.energy_error / e.initial)
end)

case("damping and contact impulses keep the energy balance", function()
  -- Contact gives impulses at the end of a step: the accelerations on both sides of it met the forces from before.
  for _, damping in ipairs { { alpha = 2000 }, { beta = 2e-5 }, { alpha = 200, beta = 1e-5 } } do
    local model = hinge.model {}
    local steel = hinge.material { E = 206e9, nu = 0.3, density = 7850 }
    local section = hinge.section.solid { width = 0.05, depth = 0.05 }
    model:member { model:node { 0, 0, 0 }, model:node { 1, 0, 0 }, section = section, material = steel }
    model:member { model:node { 0.5, -0.5, 0.052 }, model:node { 0.5, 0.5, 0.052 }, section = section, material = steel,
      group = "missile" }
    model:velocity("missile", { 0, 0, -20 })
    model:contact { rule = "surface" }
    model:damping(damping)
    local run = model:dynamic { dt = 2e-5, duration = 2e-3, record = false }:finish()
    expect(run.verdict == "completed" and run.contacts.bound > 0, "an impact that is damped: %s", run.reason)
    near(run.energy.energy_error / run.energy.initial, 0, 1e-5, "balance of an impact that is damped")
    expect(run.energy.damping > 0.03 * run.energy.initial, "it takes %g J", run.energy.damping)
  end
end)

-- Explicit steps ------------------------------------------------------------------------------------------------------

case("explicit damped steps are stable at 0.99 of the limit that is named and refused beyond it", function()
  local function with_dt(dt)
    local model, tip = bar {}
    model:damping { beta = 0.02 }
    model:velocity(tip, { 1e-3, 0, 0 })
    local run = model:dynamic { dt = dt, duration = 1000 * dt, integrator = "explicit", record = false, rest = false,
      energy_tolerance = 0 }
    return run
  end
  local message = checks.refused("damping shortens it", with_dt, 1)
  local limit = tonumber(message:match "stay stable up to ([%d.e+-]+) s")
  local run = with_dt(0.99 * limit)
  run:finish()
  expect(run.energy.kinetic + run.energy.elastic < 1e-3 * run.energy.initial, "stable at 0.99 of the limit")
end)

-- Wrong input ---------------------------------------------------------------------------------------------------------

case("wrong damping is refused and leaves no damping effect", function()
  local model = bar {}
  for _, row in ipairs {
    { {}, "none of 'alpha', 'beta', 'ratio' is given" },
    { { alpha = -1 }, "field 'alpha' is -1 1/s; must be 0 1/s or above" },
    { { beta = "x" }, "field 'beta' is 'x'; must be a number in s" },
    { { beta = 0 / 0 }, "field 'beta' is not a number" },
    { { ratio = 0.02 }, "field 'periods' is missing" },
    { { periods = { 1, 0.1 } }, "field 'ratio' is missing" },
    { { ratio = 2, periods = { 1, 0.1 } }, "field 'ratio' is 2; must be a part of critical damping" },
    { { ratio = -0.1, periods = { 1, 0.1 } }, "field 'ratio' is -0.1" },
    { { ratio = 0 / 0, periods = { 1, 0.1 } }, "field 'ratio'" },
    { { ratio = 0.02, periods = { 1 } }, "field 'periods'" },
    { { ratio = 0.02, periods = 1 }, "field 'periods' is 1; must be two numbers in s" },
    { { ratio = 0.02, periods = { 1, 0 } }, "field 'periods' is 0 s; must be positive" },
    { { ratio = { 0.02, "x" }, periods = { 1, 0.1 } }, "field 'ratio'" },
    { { ratio = { 0.02, 0.05 }, periods = { 1, 1 } }, "two ratios need two periods that differ" },
    { { ratio = { 0.5, 0.01 }, periods = { 1, 0.1 } }, "beta = -" },
    { { ratio = 0.02, alpha = 1, periods = { 1, 0.1 } }, "field 'alpha' is given" },
    { { alpha = 1, group = "beam" }, "no group 'beam'" },
    { { alpha = 1, ratios = 0.1 }, "ratios" },
  } do
    checks.refused(row[2], function() model:damping(row[1]) end)
  end
  model:velocity("bar", { 0, 0, 0 })
  local run = model:dynamic { dt = 1e-3, duration = 1e-2, record = false }
  for _, effect in ipairs(run.effects or {}) do
    if effect.name == "damping" then expect(not effect.active, "wrong input leaves the model as it was") end
  end
end)

checks.done()
