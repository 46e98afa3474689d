-- Supports that move: where they are, what they take, the work they do, and that the
-- energy balance closes however they set off.
--
-- Run: lua5.4 tests/script/moving_supports_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "?.lua;" .. package.path
local hinge = require "hinge"
local support = require "support"
local checks = support.checks "moving supports"
local case = checks.case

local elastic = hinge.material { E = 206e9, nu = 0.3, density = 7850 }
local bar = hinge.section.solid { width = 0.05, depth = 0.05 }

case("a short column on a shaken support moves with it", function()
  -- A short column on a shaken support moves with it: the support's force is mass times
  -- acceleration, its work the kinetic energy.
  for _, integrator in ipairs { "newmark", "explicit" } do
    local model = hinge.model()
    local foot, top = model:node { 0, 0, 0 }, model:node { 0, 0, 0.2 }
    model:fix(foot, "all")
    model:member { foot, top, section = bar, material = elastic }
    local mass, w = 7850 * 0.05 ^ 2 * 0.2, 2 * math.pi * 10
    model:move { node = foot, x = function(t) return 0.02 * (t - math.sin(w * t) / w) end }
    local run = model:dynamic { dt = integrator == "explicit" and "auto" or 2e-5, duration = 0.025,
      integrator = integrator }
    run:finish()
    local t = run.time
    checks.near(run:displacement(foot), 0.02 * (t - math.sin(w * t) / w), 1e-9, integrator .. ": where the support is")
    checks.near(run:velocity(foot), 0.02 * (1 - math.cos(w * t)), 1e-5, integrator .. ": how fast it is")
    checks.near(run:reaction(foot), mass * 0.02 * w * math.sin(w * t), 0.02 * mass * 0.02 * w,
      integrator .. ": what it takes")
    checks.near(run.energy.work, 0.5 * mass * (0.02 * (1 - math.cos(w * t))) ^ 2, 0.02 * run.energy.work,
      integrator .. ": what it does")
    checks.expect(math.abs(run.energy.remainder) < 1e-4 * run.energy.work, "%s: energy error %g of %g J", integrator,
      run.energy.remainder, run.energy.work)
  end
end)

case("the energy error of a shaken frame falls with the square of the step", function()
  -- The energy error of a frame that is shaken hard falls with the square of the step.
  local function energy_error(dt)
    local model = hinge.model()
    local foot, top = model:node { 0, 0, 0 }, model:node { 0, 0, 1 }
    model:fix(foot, "all")
    model:member { foot, top, section = bar, material = elastic }
    model:move { node = foot, x = hinge.ground { dt = 0.01, acceleration = { 0, 60, -80, 30, 0 } } }
    local run = model:dynamic { dt = dt, duration = 0.05 }
    run:finish()
    return math.abs(run.energy.remainder), run.energy.work
  end
  local coarse, work = energy_error(4e-5)
  local fine = energy_error(1e-5)
  checks.expect(coarse < 1e-3 * work and fine < coarse / 8, "%g and %g of %g J", coarse, fine, work)
end)

case("a support takes what a load does not move, in steps short or long", function()
  -- A support takes what a load does not move, in steps short or long: longer ones are solved from where they begin.
  for _, displacement in ipairs { "small", "large" } do
    for _, dt in ipairs { 1e-4, 2.9e-4, 3.1e-4, 1e-3 } do
      local model = hinge.model { displacement = displacement }
      local wall, tip = model:node { 0, 0, 0 }, model:node { 3, 0, 0 }
      model:fix(wall, "all")
      model:member { wall, tip, section = hinge.section.solid { width = 0.1, depth = 0.1 }, material = elastic }
      model:load { node = tip, force = { 0, 0, 1000 }, history = { { 0, 0 }, { 0.5, 1 } } }
      local run = model:dynamic { dt = dt, duration = 0.6 }
      local taken, before = 0, 0
      for _ in run:steps() do
        local now = select(3, run:reaction(wall))
        taken, before = taken + dt * (before + now) / 2, now
      end
      checks.near(select(3, table.unpack(run:momentum().linear)) - taken, 350, 0.5,
        ("impulse of a load that rises, %s displacement, dt %g s"):format(displacement, dt))
      checks.near(select(3, run:reaction(wall)), -1000, 150,
        ("reaction, %s displacement, dt %g s"):format(displacement, dt))
    end
  end
end)

-- What sets off at once -----------------------------------------------------------------------------------------------

case("a bar pushed at its end moves as the wave equation has it", function()
  -- A bar pushed at its end: the force is that of a wave, rho c A V, until the wave comes back; half
  -- the work moves, half is strain.
  for _, integrator in ipairs { "newmark", "explicit" } do
    local model = hinge.model()
    local foot, far = model:node { 0, 0, 0 }, model:node { 1, 0, 0 }
    model:fix(foot, "all")
    model:member { foot, far, section = bar, material = elastic, elements = 100 }
    local V, c = 3, math.sqrt(206e9 / 7850)
    model:move { node = foot, x = function(t) return V * t end }
    local run = model:dynamic { dt = integrator == "explicit" and "auto" or 5e-7, duration = 1.5e-4,
      integrator = integrator }
    run:finish()
    local force = 7850 * c * 0.05 ^ 2 * V
    checks.near(run.energy.work, force * V * run.time, 0.01 * run.energy.work, integrator .. ": rho c A V^2 t")
    checks.near(run:momentum().linear[1], force * run.time, 0.01 * force * run.time, integrator .. ": rho c A V t")
    checks.near(run.energy.kinetic, run.energy.elastic, 0.02 * run.energy.elastic, integrator .. ": half of it moves")
    -- explicit steps keep dt^2/8 a.M a to themselves, and the front is steep
    local bound = integrator == "explicit" and 2e-3 or 1e-6
    checks.expect(math.abs(run.energy.remainder) < bound * run.energy.work, "%s: energy error %g of %g J", integrator,
      run.energy.remainder, run.energy.work)
  end
end)

-- A portal on feet that take `path`; what is left in the energy balance, as a part of their work.
local function shaken(path, options, material, rule)
  local model = hinge.model()
  local a, b, c, d = model:node { 0, 0, 0 }, model:node { 0, 0, 2 }, model:node { 3, 0, 2 }, model:node { 3, 0, 0 }
  for _, foot in ipairs { a, d } do model:fix(foot, "all") end
  for _, ends in ipairs { { a, b }, { b, c }, { c, d } } do
    model:member { ends[1], ends[2], section = bar, material = material or elastic }
  end
  model:move { node = { a, d }, x = path }
  if rule then model:fracture(rule) end
  local settings = { dt = options.integrator and "auto" or 2e-5, duration = 0.02 }
  for k, v in pairs(options) do settings[k] = v end
  local run = model:dynamic(settings):finish()
  checks.equal(run.verdict, "completed", "a shaken portal: " .. tostring(run.reason))
  return math.abs(run.energy.remainder) / run.energy.work, run
end
case("a portal on moving feet closes its energy balance by the work of the feet", function()
  local paths = {
    ["sets off at once"] = function(t) return 2 * t end,
    ["sets off later"] = function(t) return t > 5.05e-3 and 2 * (t - 5.05e-3) or 0 end,
    ["stops at once"] = function(t) return t < 6e-3 and 3 * t or 0.018 end,
    ["swings from the middle"] = function(t) return 0.05 * math.sin(200 * t) end,
  }
  for what, path in pairs(paths) do
    for name, settings in pairs {
      newmark = { {}, 3e-6 }, damped = { { rho_infinity = 0.8 }, 3e-6 },
      ["long steps"] = { { dt = 2e-4, iterations = 30 }, 1e-3 },
      explicit = { { integrator = "explicit" }, 5e-4 }, ["beta 0.4"] = { { beta = 0.4 }, 1e-3 },
    } do
      local left = shaken(path, settings[1])
      checks.expect(left < settings[2], "a foot that %s, %s: energy error %g of the work", what, name, left)
    end
  end
end)

case("feet that tear their columns keep the balance", function()
  -- Feet that tear their columns: an element that breaks next to a foot stays on it as a
  -- rigid offset mass, which the foot drives too.
  local steel = hinge.material { E = 206e9, nu = 0.3, density = 7850, yield_stress = 300e6 }
  for name, settings in pairs { newmark = { { dt = 1e-5 }, 3e-4 }, damped = { { dt = 1e-5, rho_infinity = 0.8 }, 3e-4 },
    explicit = { { integrator = "explicit" }, 1e-4 } } do
    local left, run = shaken(function(t) return 0.05 * (1 - math.cos(200 * t)) end, settings[1],
      steel, { axial_strain = 0.002, curvature_x = 0.06, curvature_y = 0.06 })
    checks.expect(run:count { state = "broken" } > 0, "%s: something breaks", name)
    checks.expect(run.energy.fracture_kinetic >= 0, "%s: breaking takes motion out: %g J", name,
      run.energy.fracture_kinetic)
    checks.expect(left < settings[2], "%s: energy error %g of the work", name, left)
  end
end)

case("a body hit beside a moving support keeps the balance", function()
  -- What is hit beside a moving support: the blows of contact that a step gives at once are the support's work, too.
  for _, rule in ipairs { "surface", "gap" } do
    for _, integrator in ipairs { "newmark", "explicit" } do
      local model = hinge.model()
      local a, b, c, d = model:node { -0.5, 0, 0 }, model:node { 0.5, 0, 0 }, model:node { -0.4, -0.5, 0.08 },
        model:node { -0.4, 0.5, 0.08 }
      for _, foot in ipairs { a, b } do model:fix(foot, "all") end
      model:member { a, b, section = bar, material = elastic }
      model:member { c, d, section = bar, material = elastic, group = "striker" }
      model:velocity("striker", { 0, 0, -20 })
      model:move { node = { a, b }, z = function(t) return 5 * t end }
      model:contact { rule = rule }
      local run = model:dynamic { dt = integrator == "explicit" and "auto" or 5e-6, duration = 0.01,
        integrator = integrator }:finish()
      checks.expect(run:count { state = "touched" } > 0, "%s, %s: they meet", rule, integrator)
      checks.expect(math.abs(run.energy.remainder) < 4e-4 * run.energy.work, "%s, %s: energy error %g of %g J", rule,
        integrator, run.energy.remainder, run.energy.work)
    end
  end
end)

case("a run that goes on from another takes its supports at their speed", function()
  -- A run that goes on from another takes its supports at their speed: nothing jumps.
  local model = hinge.model()
  local foot, top = model:node { 0, 0, 0 }, model:node { 0, 0, 1 }
  model:fix(foot, "all")
  model:member { foot, top, section = bar, material = elastic }
  model:move { node = foot, x = function(t) return 2 * t end }
  local first = model:dynamic { dt = 1e-5, duration = 0.005 }
  first:finish()
  local second = model:dynamic { dt = 1e-5, duration = 0.005, from = first }
  local before = second:step() and second.energy.work
  checks.expect(math.abs(before) < 1e-2 * first.energy.work,
    "the first step's work is a step's: %g of %g J", before, first.energy.work)
  second:finish()
  checks.near(second:displacement(foot), 0.02, 1e-9, "where it is then")
  checks.expect(math.abs(second.energy.remainder) < 1e-5 * first.energy.work, "energy error %g",
    second.energy.remainder)
end)

case("a path is asked for nothing before its run begins", function()
  -- A path is asked for nothing before its run begins.
  local earliest = math.huge
  shaken(function(t)
    earliest = support.smallest_of(earliest, t)
    return t
  end, {})
  checks.equal(earliest, 0, "the earliest time that a path is asked for")
end)

-- Ground motion -------------------------------------------------------------------------------------------------------

case("ground motion is integrated to displacements", function()
  local ground = hinge.ground { dt = 0.5, acceleration = { 2, 2, 2 }, scale = 3 }
  checks.near(ground(1), 3, 1e-12, "constant acceleration for a second")
  checks.near(ground(2), 3 + 6 * 1, 1e-12, "straight on after the record")
  checks.equal(ground(-1), 0, "before the record")
end)

checks.done()
