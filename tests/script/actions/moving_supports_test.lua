-- Supports that move: where they are, what they take, the work they do, and that the
-- energy balance closes however they set off.
--
-- Run: lua5.4 tests/script/actions/moving_supports_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local hinge = require "hinge"
local support = require "support"
local scenes = require "scenes"
local checks = support.checks "moving supports"
local runs = require "runs"(checks)
local case, with = checks.case, scenes.with

local elastic, bar = scenes.elastic, scenes.square
-- By integrator: options of a run whose implicit steps are dt.
local function methods(dt)
  return { newmark = { integrator = "newmark", dt = dt }, explicit = { integrator = "explicit", dt = "auto" } }
end
local function cantilever(length, along, options)
  local model, tip, _, foot = scenes.cantilever(with({ length = length, along = along }, options))
  return model, foot, tip
end

case("a short column on a shaken support moves with it", function()
  -- the support's force is mass times acceleration, its work the kinetic energy
  for integrator, options in pairs(methods(2e-5)) do
    local model, foot = cantilever(0.2, { 0, 0, 1 })
    local mass, w = 7850 * 0.05 ^ 2 * 0.2, 2 * math.pi * 10
    model:move { node = foot, x = function(t) return 0.02 * (t - math.sin(w * t) / w) end }
    local run = model:dynamic(with(options, { duration = 0.025 })):finish()
    local t = run.time
    checks.near(run:displacement(foot), 0.02 * (t - math.sin(w * t) / w), 1e-9, integrator .. ": where the support is")
    checks.near(run:velocity(foot), 0.02 * (1 - math.cos(w * t)), 1e-5, integrator .. ": how fast it is")
    checks.near(run:reaction(foot), mass * 0.02 * w * math.sin(w * t), 0.02 * mass * 0.02 * w,
      integrator .. ": what it takes")
    checks.near(run.energy.work, 0.5 * mass * (0.02 * (1 - math.cos(w * t))) ^ 2, 0.02 * run.energy.work,
      integrator .. ": what it does")
    runs.balanced(run, 1e-4, "work", integrator)
  end
end)

case("the energy error of a shaken frame falls with the square of the step", function()
  local function energy_error(dt)
    local model, foot = cantilever(1, { 0, 0, 1 })
    model:move { node = foot, x = hinge.ground { dt = 0.01, acceleration = { 0, 60, -80, 30, 0 } } }
    local run = model:dynamic { dt = dt, duration = 0.05 }:finish()
    return math.abs(run.energy.energy_error), run.energy.work
  end
  local coarse, work = energy_error(4e-5)
  local fine = energy_error(1e-5)
  checks.expect(coarse < 1e-3 * work and fine < coarse / 8, "%g and %g of %g J", coarse, fine, work)
end)

case("a support takes what a load does not move, in steps short or long", function()
  -- longer ones are solved from where they begin
  for _, displacement in ipairs { "small", "large" } do
    for _, dt in ipairs { 1e-4, 2.9e-4, 3.1e-4, 1e-3 } do
      local model, wall, tip = cantilever(3, { 1, 0, 0 }, { model = { displacement = displacement },
        member = { section = hinge.section.solid { width = 0.1, depth = 0.1 } } })
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
  -- the force is that of a wave, rho c A V, until the wave comes back; half the work moves, half is strain
  for integrator, options in pairs(methods(5e-7)) do
    local model, foot = cantilever(1, { 1, 0, 0 }, { member = { elements = 100 } })
    local V, c = 3, math.sqrt(206e9 / 7850)
    model:move { node = foot, x = function(t) return V * t end }
    local run = model:dynamic(with(options, { duration = 1.5e-4 })):finish()
    local force = 7850 * c * 0.05 ^ 2 * V
    checks.near(run.energy.work, force * V * run.time, 0.01 * run.energy.work, integrator .. ": rho c A V^2 t")
    checks.near(run:momentum().linear[1], force * run.time, 0.01 * force * run.time, integrator .. ": rho c A V t")
    checks.near(run.energy.kinetic, run.energy.elastic, 0.02 * run.energy.elastic, integrator .. ": half of it moves")
    -- explicit steps keep dt^2/8 a.M a to themselves, and the front is steep
    runs.balanced(run, integrator == "explicit" and 2e-3 or 1e-6, "work", integrator)
  end
end)

-- A portal on feet that take `path`; what is left in the energy balance, as a part of their work.
local function shaken(path, options, material, rule)
  local of_all = { material = material or elastic }
  local model, node = scenes.portal { width = 3, height = 2, column = of_all, beam = of_all }
  model:move { node = { node[1], node[4] }, x = path }
  if rule then model:fracture(rule) end
  local run = model:dynamic(with({ dt = options.integrator and "auto" or 2e-5, duration = 0.02 }, options))
  runs.completed(run, "a shaken portal")
  return math.abs(run.energy.energy_error) / run.energy.work, run
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
  -- an element that breaks next to a foot stays on it as a rigid offset mass, which the foot drives too
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
  -- the blows of contact that a step gives at once are the support's work, too
  for _, rule in ipairs { "surface", "gap" } do
    for integrator, options in pairs(methods(5e-6)) do
      local model = hinge.model()
      local a, b, c, d = model:node { -0.5, 0, 0 }, model:node { 0.5, 0, 0 }, model:node { -0.4, -0.5, 0.08 },
        model:node { -0.4, 0.5, 0.08 }
      for _, foot in ipairs { a, b } do model:fix(foot, "all") end
      model:member { a, b, section = bar, material = elastic }
      model:member { c, d, section = bar, material = elastic, group = "striker" }
      model:velocity("striker", { 0, 0, -20 })
      model:move { node = { a, b }, z = function(t) return 5 * t end }
      model:contact { rule = rule }
      local run = model:dynamic(with(options, { duration = 0.01 })):finish()
      checks.expect(run:count { state = "touched" } > 0, "%s, %s: they meet", rule, integrator)
      runs.balanced(run, 4e-4, "work", rule .. ", " .. integrator)
    end
  end
end)

case("a run that goes on from another takes its supports at their speed", function()
  -- nothing jumps
  local model, foot = cantilever(1, { 0, 0, 1 })
  model:move { node = foot, x = function(t) return 2 * t end }
  local first = model:dynamic { dt = 1e-5, duration = 0.005 }:finish()
  local second = model:dynamic { dt = 1e-5, duration = 0.005, from = first }
  local before = second:step() and second.energy.work
  checks.expect(math.abs(before) < 1e-2 * first.energy.work,
    "the first step's work is a step's: %g of %g J", before, first.energy.work)
  second:finish()
  checks.near(second:displacement(foot), 0.02, 1e-9, "where it is then")
  runs.balanced(second, 1e-5, first.energy.work, "going on")
end)

case("a path is asked for nothing before its run begins", function()
  local earliest = math.huge
  shaken(function(t)
    earliest = support.smallest_of(earliest, t)
    return t
  end, {})
  checks.equal(earliest, 0, "the earliest time that a path is asked for")
end)

-- Steps longer than the fastest waves need ----------------------------------------------------------------------------

-- From rest to 1 m/s in a second, and on at that speed: where the foot is.
local function sets_off(t)
  return t < 1 and t / 2 - math.sin(math.pi * t) / (2 * math.pi) or t - 0.5
end
local post = hinge.section.solid { width = 0.1, depth = 0.1 }

-- A column with 500 kg at its top, on a foot that `sets_off` moves.
local function column(model, material, ends)
  local foot, top = model:node { 0, 0, 0 }, model:node { 0, 0, 3 }
  model:fix(foot)
  model:member { foot, top, section = post, material = material, up = { 1, 0, 0 }, ends = ends }
  model:mass { node = top, mass = 500 }
  model:move { node = foot, x = sets_off }
  return top
end
-- A portal whose feet move by `first` and `second`.
local function portal(model, material, first, second)
  local a, d = model:node { 0, 0, 0 }, model:node { 4, 0, 0 }
  local b, c = model:node { 0, 0, 3 }, model:node { 4, 0, 3 }
  model:fix { a, d }
  for _, ends in ipairs { { a, b }, { b, c }, { d, c } } do
    model:member { ends[1], ends[2], section = post, material = material }
  end
  for _, top in ipairs { b, c } do model:mass { node = top, mass = 250 } end
  model:move { node = a, x = first.x, z = first.z }
  model:move { node = d, x = second.x, z = second.z }
  return b
end
-- A column on springs and a dashpot between its foot and a beam that moves.
local function on_springs(model, material)
  local anchor, far = model:node { 0, 0, -0.1 }, model:node { 1, 0, -0.1 }
  local foot, top = model:node { 0, 0, 0 }, model:node { 0, 0, 3 }
  model:fix { anchor, far }
  model:member { anchor, far, section = post, material = material }
  model:member { foot, top, section = post, material = material, up = { 1, 0, 0 } }
  model:mass { node = top, mass = 500 }
  model:connector { anchor, foot, damping = { x = 1e4 },
    stiffness = { x = 1e6, y = 1e6, z = 1e8, rx = 1e6, ry = 1e6, rz = 1e5 } }
  model:move { node = { anchor, far }, x = sets_off }
  return top
end

-- The run of a structure with or without a yield stress that it does not reach.
local function long_steps(build, yields, model_options, run_options, damping)
  local model = hinge.model(model_options)
  local steel = { E = 210e9, nu = 0.3, density = 7850, yield_stress = yields and 235e6 or nil }
  local top = build(model, hinge.material(steel))
  if damping then model:damping(damping) end
  local run = model:dynamic(with({ dt = 2.5e-3, duration = 2 }, run_options)):finish()
  return run, run:displacement(top)
end

case("plasticity that is not reached takes no step more than an elastic material", function()
  local soft = { Mx = { stiffness = 1e6 }, My = { stiffness = 1e6 } }
  local structures = {
    column = { column },
    ["a column, rho_infinity 0.8"] = { column, run = { rho_infinity = 0.8 } },
    ["a column, one solution a step"] = { column, run = { iterations = 1 } },
    ["a column, factors"] = { column, run = { solver = "direct" } },
    ["a column damped by alpha and beta"] = { column, damping = { alpha = 2, beta = 1e-4 } },
    ["a column on a joint"] = { function(model, m) return column(model, m, { a = hinge.joint(soft) }) end },
    ["a column on springs"] = { on_springs },
    ["feet that move alike"] = { function(model, m) return portal(model, m, { x = sets_off }, { x = sets_off }) end },
    ["feet that move apart and settle"] = { function(model, material)
      return portal(model, material, { x = sets_off }, {
        x = function(t) return sets_off(t) + 4e-3 * math.sin(5 * t) end,
        z = function(t) return -0.01 * sets_off(t) end,
      })
    end },
  }
  for what, scene in pairs(structures) do
    for _, displacement in ipairs { "small", "large" } do
      -- with one solution a step the rotation of a step is missed where displacements are large
      if not (displacement == "large" and scene.run and scene.run.iterations) then
        local of = ("%s, %s displacement"):format(what, displacement)
        local elastic_run, u = long_steps(scene[1], false, { displacement = displacement }, scene.run, scene.damping)
        local run, v = long_steps(scene[1], true, { displacement = displacement }, scene.run, scene.damping)
        for kind, r in pairs { elastic = elastic_run, ["with a yield stress"] = run } do
          checks.equal(r.verdict, "completed", of .. ", " .. kind .. ": " .. tostring(r.reason))
          checks.equal(r.index, 800, of .. ", " .. kind .. ": steps")
          -- Newton's method ends at 1e-6 of a step's motion, and the balance is of second order in that
          checks.expect(math.abs(r.energy_error) < 1e-7, "%s, %s: energy error %g", of, kind, r.energy_error)
        end
        checks.equal(run.counts.rejected_steps, 0, of .. ": steps taken back")
        checks.equal(run.energy.plastic, 0, of .. ": plastic work")
        checks.near(v, u, 1e-9, of .. ": where the top is")
      end
    end
  end
end)

case("a yielding column on moving ground is the bilinear oscillator", function()
  -- Mass on a weightless column, a pulse of the ground that takes it to about four times its yield displacement. Two
  -- asi-gauss elements have the stiffness of the closed form, and a hinge at the foot makes it bilinear.
  local E, nu, fy, b, L, M = 210e9, 0.3, 235e6, 0.1, 3, 2000
  local k = 1 / (L ^ 3 / (3 * E * b ^ 4 / 12) + L / (E / (2 * (1 + nu)) * 5 / 6 * b ^ 2))
  local F, T = b ^ 3 / 4 * fy / L, 2 * math.pi * math.sqrt(M / k)
  local pulse, peak_acceleration = 1.2 * T, 1.3 * F / M
  local function acceleration(t)
    return t < pulse and peak_acceleration * math.sin(2 * math.pi * t / pulse) or 0
  end
  -- by hand: Verlet's method in relative coordinates
  local n, u, v, flowed, peak, work = 40000, 0, 0, 0, 0, 0
  local dt, force = 3 * T / n, 0
  for i = 1, n do
    v = v + 0.5 * dt * (-force / M - acceleration((i - 1) * dt))
    u = u + dt * v
    force = k * (u - flowed)
    if math.abs(force) > F then
      local side = force > 0 and 1 or -1
      local to = u - side * F / k
      work, flowed, force = work + F * math.abs(to - flowed), to, side * F
    end
    v = v + 0.5 * dt * (-force / M - acceleration(i * dt))
    peak = support.largest_of(peak, math.abs(u))
  end
  checks.expect(peak > 2.5 * F / k, "the oscillator yields: %g of %g m", peak, F / k)

  local record, h = {}, T / 1000
  for i = 0, 3000 do record[i + 1] = acceleration(i * h) end
  for _, part in ipairs { 50, 200 } do
    local model = hinge.model { displacement = "small" }
    local foot, top = model:node { 0, 0, 0 }, model:node { 0, 0, L }
    model:fix(foot)
    model:member { foot, top, section = hinge.section.solid { width = b, depth = b }, up = { 1, 0, 0 },
      material = hinge.material { E = E, nu = nu, density = 1, yield_stress = fy } }
    model:mass { node = top, mass = M, inertia = 5 }
    model:move { node = foot, x = hinge.ground { dt = h, acceleration = record } }
    local run = model:dynamic { dt = T / part, duration = 3 * T }
    local most = 0
    for _ in run:steps() do
      most = support.largest_of(most, math.abs(run:displacement(top) - run:displacement(foot)))
    end
    local what = ("T/%d"):format(part)
    runs.completed(run, what)
    -- a few steps, where the hinge begins to flow, are halved: Newton's method does not converge
    checks.expect(run.index < 2 * 3 * part, "%s: %d steps", what, run.index)
    checks.near(most, peak, 0.02 * peak, what .. ": peak")
    checks.near(run.energy.plastic, work, 0.02 * work, what .. ": plastic work")
  end
end)

-- Ground motion -------------------------------------------------------------------------------------------------------

case("ground motion is integrated to displacements", function()
  local ground = hinge.ground { dt = 0.5, acceleration = { 2, 2, 2 }, scale = 3 }
  checks.near(ground(1), 3, 1e-12, "constant acceleration for a second")
  checks.near(ground(2), 3 + 6 * 1, 1e-12, "straight on after the record")
  checks.equal(ground(-1), 0, "before the record")
end)

-- A beam clamped at both ends, of which one is rotated by a settlement or by a path.
local function clamped(displacement)
  local model, b, _, a = scenes.cantilever { length = 2, model = { displacement = displacement } }
  model:fix(b)
  return model, a, b
end

case("a support that rotates slowly does what a settlement does", function()
  local angle, time = 0.02, 0.05
  for _, displacement in ipairs { "small", "large" } do
    for c, axis in pairs { [4] = "rx", [5] = "ry", [6] = "rz" } do
      local settled, one, other = clamped(displacement)
      settled:settle { node = one, [axis] = angle }
      local rest = settled:static { steps = 4 }:finish()
      local here, there = { rest:reaction(one) }, { rest:reaction(other) }
      local size = support.largest_of(math.abs(here[4]), math.abs(here[5]), math.abs(here[6]))
      for kind, options in pairs(with(methods(2e-5), { ["long steps"] = { dt = 1e-3 } })) do
        local model, a, b = clamped(displacement)
        model:damping { alpha = 400 }
        model:move { node = a, [axis] = function(t)
          local s = math.min(1, t / time)
          return angle * s * s * (3 - 2 * s)
        end }
        local what = ("%s, %s, %s"):format(displacement, axis, kind)
        local run = runs.completed(model:dynamic(with(options, { duration = 0.2 })), what)
        checks.near(select(c, run:displacement(a)), angle, 1e-9, what .. ": rotation")
        for i = 4, 6 do
          checks.near(select(i, run:reaction(a)), here[i], 2e-3 * size, what .. ": moment " .. i)
          checks.near(select(i, run:reaction(b)), there[i], 2e-3 * size, what .. ": moment at the other end " .. i)
        end
        -- slow: the work is what the beam stores, and what is damped
        checks.near(run.energy.work - run.energy.damping, 0.5 * here[c] * angle, 5e-3 * size * angle, what .. ": work")
        runs.balanced(run, 1e-3, "work", what)
      end
    end
  end
end)

case("a cantilever on a support that rotates far goes round with it", function()
  local rate = 2
  for integrator, options in pairs(methods(1e-4)) do
    local model, foot, tip = cantilever(0.5)
    model:move { node = foot, rz = function(t) return rate * (t < 0.4 and t * t / 0.8 or t - 0.2) end }
    local run = model:dynamic(with(options, { duration = 1 })):finish()
    local angle = rate * (run.time - 0.2)
    local x, y = run:displacement(tip)
    checks.near(0.5 + x, 0.5 * math.cos(angle), 1e-4, integrator .. ": x of the tip")
    checks.near(y, 0.5 * math.sin(angle), 1e-4, integrator .. ": y of the tip")
    runs.balanced(run, 0.01, "work", integrator)
  end
end)

case("wrong rotations are refused", function()
  local model = hinge.model()
  local foot = model:node { 0, 0, 0 }
  model:move { node = foot, ry = { { 0, 0 }, { 1, 0.1 } } }
  checks.refused("node 1 is moved about y already", model.move, model, { node = foot, ry = { { 0, 0 }, { 1, 0.1 } } })
  checks.refused("none of 'x', 'y', 'z', 'rx', 'ry', 'rz'", model.move, model, { node = foot })
end)

checks.done()
