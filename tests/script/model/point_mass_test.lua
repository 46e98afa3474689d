-- Point masses: weight at rest, frequencies, momentum, rest, fracture, and what is refused.
--
-- Run: lua5.4 tests/script/model/point_mass_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local scenes = require "scenes"
local hinge = require "hinge"
local core = require "hinge.core"
local vectors = require "hinge.library.vectors"
local checks = support.checks "point masses"
local runs = require "runs"(checks)
local case, expect, equal, near = checks.case, checks.expect, checks.equal, checks.near
local with, done, cross, size = scenes.with, runs.completed, vectors.cross, vectors.length

local g, E, G = 9.80665, 206e9, 206e9 / 2.6
local bar = scenes.square
local I, A, J = bar.Ix, bar.area, bar.J
local function steel(density) return hinge.material { E = E, nu = 0.3, density = density or 7850 } end
local flexibility = 1 / (3 * E * I) + 1 / (bar.shear_area_y * G) -- of a cantilever 1 m long, m/N

local function apart(a, b) return size(vectors.minus(a, b)) end
local function cantilever(options, density)
  local model, tip, _, wall = scenes.cantilever { model = with({ displacement = "small" }, options),
    member = { material = steel(density), up = { 0, 0, 1 } } }
  return model, wall, tip
end

-- Statics -------------------------------------------------------------------------------------------------------------

for _, displacement in ipairs { "small", "large" } do
  case(("the weight of a point mass on a cantilever in statics: %s displacement"):format(displacement), function()
    local model, wall, tip = cantilever({ displacement = displacement }, 1e-9)
    model:gravity { 0, 0, -g }
    model:mass { node = tip, mass = 2 }
    model:mass { node = tip, mass = 1, inertia = 0.1 }
    model:mass { node = wall, mass = 50 }
    local run = done(model:static { steps = 1 }, "statics")
    local _, _, uz = run:displacement(tip)
    near(uz / (-3 * g * flexibility), 1, 1e-6,
      displacement .. ": deflection under the weight, of P L^3 / 3 E I + P L / k A G")
    local _, _, fz, _, my = run:reaction(wall)
    near(fz, 53 * g, 1e-6, displacement .. ": reaction, N")
    near(my, -3 * g, 1e-5, displacement .. ": its moment, N m")
    equal(run:momentum().mass - 1e-9 * A, 53, displacement .. ": all masses")
    runs.balanced(run, 1e-8, "elastic", displacement)

    -- beside its node: the weight is a moment too
    model, wall, tip = cantilever({ displacement = displacement }, 1e-9)
    model:gravity { 0, 0, -g }
    model:mass { node = tip, mass = 3, offset = { 0.5, 0.2, 0 } }
    run = done(model:static { steps = 1 }, "statics, offset")
    _, _, uz = run:displacement(tip)
    local by_hand = -3 * g * (flexibility + 0.5 / (2 * E * I))
    near(uz / by_hand, 1, 1e-4, displacement .. ": deflection under a weight beside the tip")
    local _, _, _, mx, moment = run:reaction(wall)
    near(moment, -3 * g * 1.5, 1e-2, displacement .. ": moment about y, N m")
    near(mx, 3 * g * 0.2, 1e-2, displacement .. ": moment about x, N m")
  end)
end

-- Frequencies ---------------------------------------------------------------------------------------------------------

-- The frequency of free vibrations in which a probe goes through zero upwards, from the first crossing to the last.
local function frequency(run, probe)
  done(run, "vibration")
  local time, value, crossings, first, last = probe.time, probe.value, 0, nil, nil
  for i = 2, #value do
    local a, b = value[i - 1], value[i]
    if a < 0 and b >= 0 then
      last = time[i - 1] + (time[i] - time[i - 1]) * a / (a - b)
      first, crossings = first or last, crossings + 1
    end
  end
  expect(crossings > 1, "%d crossings", crossings)
  return (crossings - 1) / (last - first)
end
local function swings(what, w, set, options)
  local period = 2 * math.pi / w
  local function measure(integrator, density, dt, periods)
    local model, _, tip = cantilever(options, density)
    local channel = set(model, tip)
    local run = model:dynamic { dt = dt, duration = periods * period, integrator = integrator, record = false }
    local measured = 2 * math.pi * frequency(run, run:probe { node = tip, channel })
    runs.balanced(run, integrator == "explicit" and 1e-3 or 1e-6, "initial", what .. ", " .. integrator)
    return measured
  end
  -- a bar of next to no mass; the method's own frequency is lower by (w dt)^2 / 12
  near(measure("newmark", 0.785, period / 400, 4.6) / w, 1, 1e-4, what .. ": frequency, of the closed form")
  if options then return end
  -- explicit steps lump the bar's mass
  near(measure("explicit", 785, "auto", 2.6) / measure("newmark", 785, period / 400, 2.6), 1, 5e-3,
    what .. ": frequency with explicit steps, of that with implicit ones")
end
case("a cantilever with a point mass swings at the frequency of theory", function()
  for _, displacement in ipairs { "small", "large" } do
    local options = displacement == "large" and { displacement = displacement } or nil
    swings("tip mass, " .. displacement, math.sqrt(1 / (20 * flexibility)), function(model, tip)
      model:mass { node = tip, mass = 20 }
      model:velocity(tip, { 0, 0, 0.01 })
      return "uz"
    end, options)
    swings("torsion, " .. displacement, math.sqrt(G * J / 3), function(model, tip)
      model:mass { node = tip, mass = 1, inertia = { 3, 0, 0 } }
      model:velocity(tip, { 0, 0, 0 }, { 0.01, 0, 0 })
      return "rx"
    end, options)
  end
end)

case("a mass on an arm along the bar has the lower frequency worked out by hand", function()
  -- bending with two degrees of freedom
  local m, r = 20, 0.5
  -- K^-1 (M - w^-2 K) of tip deflection u and slope s; mass matrix m { {1, r}, {r, r^2} } is of rank one
  local at_mass = flexibility + 2 * r / (2 * E * I) + r * r / (E * I)
  swings("mass on an arm", math.sqrt(1 / (m * at_mass)), function(model, tip)
    model:mass { node = tip, mass = m, offset = { r, 0, 0 } }
    local slope = (1 / (2 * E * I) + r / (E * I)) / (flexibility + r / (2 * E * I))
    model:velocity(tip, { 0, 0, 0.01 }, { 0, -0.01 * slope, 0 })
    return "uz"
  end)
end)

-- Flight --------------------------------------------------------------------------------------------------------------

local function thrown(options)
  local model = hinge.model(options and options.model)
  local a, b = model:node { 0, 0, 0 }, model:node { 1, 0, 0 }
  model:member { a, b, section = bar, material = steel(), group = "bar" }
  model:mass { node = a, mass = 4 }
  model:mass { node = b, mass = 10, inertia = { 0.1, 0.2, 0.3 },
    offset = not (options and options.centred) and { 0.1, 0, 0.2 } or nil }
  model:velocity("bar", { 1, 2, 3 }, { 3, -2, 5 })
  if options and options.gravity then model:gravity { 0, 0, -g } end
  return model, a, b
end
local bar_mass = 7850 * A
for integrator, dt in pairs { newmark = 2e-5, explicit = "auto" } do
  case(("a thrown bar with a point mass flies as a rigid body: " .. integrator), function()
    local model, a = thrown()
    local run = model:dynamic { dt = dt, duration = 0.2, integrator = integrator, record = false }
    local before = run:momentum()
    near(before.mass, bar_mass + 14, 1e-12, integrator .. ": mass, kg")
    -- by hand: velocities are those of a rigid body about the middle
    local w, p, L, energy = { 3, -2, 5 }, { 0, 0, 0 }, { 0, 0, 0 }, 0
    for _, part in ipairs { { 4, { 0, 0, 0 } }, { 10, { 1.1, 0, 0.2 } }, { bar_mass, { 0.5, 0, 0 } } } do
      local m, x = part[1], part[2]
      local turn = cross(w, { x[1] - 0.5, x[2], x[3] })
      local v = { 1 + turn[1], 2 + turn[2], 3 + turn[3] }
      local l = cross(x, v)
      energy = energy + 0.5 * m * size(v) ^ 2
      for c = 1, 3 do p[c], L[c] = p[c] + m * v[c], L[c] + m * l[c] end
    end
    local across = bar_mass / 12 + 7850 * I
    for c, inertia in ipairs { 0.1 + 7850 * 2 * I, 0.2 + across, 0.3 + across } do
      L[c], energy = L[c] + inertia * w[c], energy + 0.5 * inertia * w[c] ^ 2
    end
    local within = integrator == "explicit" and 0.05 or 1e-9 -- explicit steps lump the bar's mass
    expect(apart(before.linear, p) < 1e-9 * size(p), "%s: momentum differs by %g", integrator, apart(before.linear, p))
    expect(apart(before.angular, L) < within * size(L), "%s: angular momentum differs by %g of %g", integrator,
      apart(before.angular, L), size(L))
    near(run.energy.initial / energy, 1, within, integrator .. ": kinetic energy")
    done(run, integrator)
    local after = run:momentum()
    local _, _, _, rx, ry, rz = run:displacement(a)
    expect(size { rx, ry, rz } > 0.5, "%s: it rotated by %g", integrator, size { rx, ry, rz })
    local linear, angular = apart(after.linear, before.linear) / size(before.linear),
      apart(after.angular, before.angular) / size(before.angular)
    expect(linear < 1e-9, "%s: momentum off by %g", integrator, linear)
    expect(angular < 1e-6, "%s: angular momentum off by %g", integrator, angular)
    runs.balanced(run, 1e-6, "initial", integrator)

    -- free fall
    run = done(thrown({ gravity = true }):dynamic { dt = dt, duration = 0.1, integrator = integrator, record = false },
      integrator .. ", falling")
    after = run:momentum()
    near(after.linear[3] - p[3], -g * 0.1 * before.mass, 1e-8 * size(p), integrator .. ": momentum of the fall")
    runs.balanced(run, 1e-6, "initial", integrator .. ", falling")
    expect(math.abs(run.energy.gravity) > 10, "%s: gravity's account %g J", integrator, run.energy.gravity)
  end)
end

case("a support that is moved carries a point mass by F = m a", function()
  for integrator, dt in pairs { newmark = 1e-4, explicit = "auto" } do
    local model, wall, tip = cantilever(nil, 7.85)
    model:mass { node = wall, mass = 7 }
    model:mass { node = tip, mass = 0.5 }
    model:move { node = wall, x = function(t) return 5 * t * t end }
    local run = done(model:dynamic { dt = dt, duration = 0.02, integrator = integrator, record = false }, "moved")
    local mean = run:reaction(wall) -- the bar rings: its mean is 0.5 kg * 10 m/s^2
    expect(math.abs(mean - 75) < 6, "%s: a moved support is pushed by %g N, wanted 70 N and up to 10 N of the bar",
      integrator, mean)
    runs.balanced(run, 1e-3, "work", integrator .. ", moved")
    expect(run.energy.work > 0.1, "%s: moved: work %g J", integrator, run.energy.work)
  end
end)

-- One run goes on from another ----------------------------------------------------------------------------------------

case("a run goes on from another with its point masses", function()
  local model, _, tip = cantilever { displacement = "large" }
  model:gravity { 0, 0, -g }
  model:mass { node = tip, mass = 5 }
  local loaded = done(model:static {}, "from")
  near(loaded:momentum().mass, bar_mass + 5, 1e-12, "mass of a static run")
  local run = done(model:dynamic { from = loaded, dt = 1e-5, duration = 1e-3, rest = false }, "from")
  near(run:momentum().mass, bar_mass + 5, 1e-12, "mass of a run that goes on from it")
  local _, _, before = loaded:displacement(tip)
  local _, _, after = run:displacement(tip)
  near(after / before, 1, 1e-6, "in balance: deflection")
  model:mass { node = tip, mass = 2 }
  local more = model:dynamic { from = run, dt = 1e-5, duration = 5e-3 }
  near(more:momentum().mass, bar_mass + 7, 1e-12, "mass with one declared since")
  done(more, "from")
  runs.balanced(more, 1e-6, "elastic", "one declared since")
  local _, _, deeper = more:displacement(tip)
  expect(deeper < 1.005 * before, "one declared since: %g m, before %g m", deeper, before)
  near(done(model:static { from = more }, "from"):momentum().mass, bar_mass + 7, 1e-12, "mass of a static run after")
end)

case("bodies with point masses rest until something reaches them, with the same outcome", function()
  for _, integrator in ipairs { "newmark", "explicit" } do
    local function fallen(rest)
      local model = hinge.model {}
      local foot, head = model:node { 0, 0, 0 }, model:node { 0, 0, 2 }
      model:fix(foot)
      model:member { foot, head, section = bar, material = steel() }
      model:mass { node = head, mass = 30, inertia = 1, offset = { 0, 0.1, 0 } }
      local left, right = model:node { -0.5, 0.3, 1.8 }, model:node { 0.5, 0.3, 1.8 }
      model:member { left, right, section = bar, material = steel(), group = "missile" }
      model:mass { node = left, mass = 3 }
      model:velocity("missile", { 0, -60, 0 })
      model:gravity { 0, 0, -g }
      model:contact {}
      local loaded = done(model:static { fixed_group = "missile" }, "rest")
      local run = model:dynamic { from = loaded, dt = 5e-6, duration = 0.01, integrator = integrator, rest = rest,
        record = false }
      return done(run, "rest"), head
    end
    local run, head = fallen(true)
    local full, same_head = fallen(false)
    local slept, woken
    for _, w in ipairs(run.state_changes) do
      if w.effect == "body" then slept, woken = slept or not w.awake, woken or w.awake end
    end
    expect(slept and woken, "%s: a post with a mass at its head rests %s, wakes %s", integrator, slept, woken)
    expect(run.counts.element_updates < full.counts.element_updates, "%s: rest saves nothing", integrator)
    local _, y = run:displacement(head)
    local _, same_y = full:displacement(same_head)
    expect(math.abs(same_y) > 1e-4, "%s: the head has moved by %g m", integrator, same_y)
    near(y, same_y, 1e-8, integrator .. ": the head's way")
    near(run.energy.energy_error / run.energy.initial, full.energy.energy_error / full.energy.initial, 1e-9,
      integrator .. ": energy error")
  end
end)

-- Fracture ------------------------------------------------------------------------------------------------------------

-- The last member of a node breaks there, and the node flies on alone; what it has of rotary inertia stays.
for what, o in pairs {
  ["a point"] = { mass = {} },
  ["a point, explicit"] = { mass = {}, integrator = "explicit" },
  ["a body"] = { mass = { inertia = { 0.1, 0.2, 0.3 } } },
  ["a needle"] = { mass = { inertia = { 0, 0.2, 0.2 } }, integrator = "explicit" },
  ["on an arm"] = { mass = { offset = { 0.2, 0.1, 0 } } },
} do
  case("a point mass flies on alone when its last member breaks: " .. what, function()
    local model = hinge.model {}
    local a, b = model:node { 0, 0, 0 }, model:node { 1, 0, 0 }
    local member = model:member { a, b, section = bar, material = steel(), group = "bar" }
    model:mass(with({ node = b, mass = 6 }, o.mass))
    model:velocity("bar", { 0, 0, 3 }, { 2, 1, 6 })
    model:gravity { 0, 0, -g }
    local now, broke = 0, nil
    model:fracture { where = "all", rule = function(section)
      if now < 0.01 or section.node ~= b.index then return false end
      broke = broke or now
      return true
    end }
    local run = model:dynamic { dt = 1e-5, duration = 0.1, integrator = o.integrator, record = false }
    local x0, v0, before
    while run:step() do
      now = run.time
      if broke and not x0 then
        x0, v0, before = { run:displacement(b) }, { run:velocity(b) }, run:momentum()
        x0.time = run.time
      end
    end
    equal(run.verdict, "completed", what .. ": verdict " .. run.reason)
    equal(member:state(), "broken", what .. ": the member")
    if expect(x0, "%s: nothing broke", what) then
      local t, after = run.time - x0.time, run:momentum()
      local x, v = { run:displacement(b) }, { run:velocity(b) }
      if not o.mass.offset then
        for c = 1, 3 do
          local fall = c == 3 and -g or 0
          near(x[c], x0[c] + v0[c] * t + 0.5 * fall * t * t, 2e-5, ("%s: place %d after it broke off"):format(what, c))
          near(v[c], v0[c] + fall * t, 1e-3, ("%s: velocity %d"):format(what, c))
        end
      end
      local dp = vectors.minus(after.linear, vectors.plus(before.linear, after.mass * t, { 0, 0, -g }))
      expect(size(dp) < 1e-6 * size(before.linear), "%s: momentum off by %g of %g", what, size(dp), size(before.linear))
      near(after.mass, bar_mass + 6, 1e-9, what .. ": mass")
      expect(size { v[4], v[5], v[6] } < 20, "%s: it spins at %g rad/s", what, size { v[4], v[5], v[6] })
    end
    runs.balanced(run, 1e-5, "initial", what)
  end)
end

-- The same bits -------------------------------------------------------------------------------------------------------

for integrator, dt in pairs { newmark = 2e-5, explicit = "auto" } do
  case("checkpoints change no bit of point masses, and those of other masses are refused: " .. integrator, function()
    local options = { dt = dt, duration = 0.01, integrator = integrator, record = false }
    runs.resumes(function() return (thrown { gravity = true }):dynamic(options) end, 0.005, integrator)
    local path, watched = support.temporary_folder() .. "/one.checkpoint", thrown { gravity = true }:dynamic(options)
    while watched.time < 0.005 do watched:step() end
    watched:checkpoint(path)
    local resumed = thrown { gravity = true }:dynamic(options):resume(path)
    equal(resumed.hash, watched.hash, integrator .. ": state at the checkpoint")
    equal(resumed:momentum().mass, watched:momentum().mass, integrator .. ": mass at the checkpoint")
    local other = thrown { gravity = true }
    other:mass { node = other:nodes()[1], mass = 1 }
    local run = other:dynamic(options)
    expect(not pcall(run.resume, run, path), "%s: a checkpoint of other masses is taken", integrator)
  end)
end

case("steps taken back leave point masses as they were", function()
  -- by an error of the script, and by step control
  local function pushed(history, options)
    local model, _, b = thrown()
    model:load { node = b, force = { 0, 0, 100 }, history = history }
    return model:dynamic(with({ dt = 2e-5, duration = 4e-3, record = false }, options))
  end
  local plain, failed = pushed(function(t) return t end), false
  plain:finish()
  local run = pushed(function(t)
    if t > 2e-3 and not failed then
      failed = true
      error "once"
    end
    return t
  end)
  expect(not pcall(run.finish, run) and failed, "the script's error is not raised")
  done(run, "after an error")
  equal(run.hash, plain.hash, "state after a step that was taken back")

  -- one solution a step, from the displacement held: also with a mass on an arm, and with what is left of a member
  for what, o in pairs { centred = { centred = true }, ["on an arm"] = {}, broken = { breaks = true } } do
    what = "step control, " .. what
    local model = thrown(o)
    if o.breaks then
      model:fracture { where = "all", rule = function(at) return at.time > 5e-3 and at.element == 1 end }
    end
    local controlled = model:dynamic { dt = 1e-3, duration = 0.05, iterations = 1, step_control = 0.01, record = false }
    local before = controlled:momentum()
    done(controlled, what)
    local after = controlled:momentum()
    equal(controlled:count { state = "broken" }, o.breaks and 1 or 0, what .. ": members broken")
    expect(controlled.counts.rejected_steps > 0, "%s: nothing taken back", what)
    runs.balanced(controlled, 0.01, "initial", what)
    expect(apart(before.linear, after.linear) < 3e-6 * size(before.linear), "%s: momentum off by %g of %g", what,
      apart(before.linear, after.linear), size(before.linear))
    expect(controlled.index < 5000, "%s: it took %d steps", what, controlled.index)
  end
end)

case("a point mass left out of a comparison is as not declared", function()
  local function run_of(declare)
    local model, _, tip = cantilever { displacement = "large" }
    model:velocity(tip, { 0, 0, 1 })
    if declare then model:mass { node = tip, mass = 5 } end
    return done(model:dynamic { dt = 1e-5, duration = 1e-3, record = false }, "left out").hash
  end
  local plain, heavy = run_of(false), run_of(true)
  expect(plain ~= heavy, "a mass changes nothing")
  core.leave_out "point masses"
  local without = run_of(true)
  core.leave_out(nil)
  equal(without, plain, "state without the effect")
end)

-- What is refused -----------------------------------------------------------------------------------------------------

case("wrong point masses are refused, and change nothing", function()
  local model, _, tip = cantilever()
  model:load { node = tip, force = { 0, 0, -1 } }
  local before = done(model:static {}, "before").hash
  for words, options in pairs {
    ["field 'mass' is missing; give a number in kg"] = {}, ["field 'mass' is 0 kg; must be above 0 kg"] = { mass = 0 },
    ["field 'mass' is -2 kg; must be above 0 kg"] = { mass = -2 },
    ["field 'mass' is not a number (nan); must be a finite number in kg"] = { mass = 0 / 0 },
    ["field 'mass' is 'heavy'"] = { mass = "heavy" },
    ["field 'inertia' is -1 kg m^2; must be 0 kg m^2 or above"] = { mass = 1, inertia = -1 },
    ["field 'inertia': component z is not a number (nan); must be finite"] = { mass = 1, inertia = { 1, 2, 0 / 0 } },
    ["field 'inertia' is 'round'; must be a number or {Jx, Jy, Jz} in kg m^2"] = { mass = 1, inertia = "round" },
    ["field 'offset' is 5; must be a table {x, y, z} in m"] = { mass = 1, offset = 5 },
    ["field 'node' is 'tip'; must be a node made by model:node"] = { node = "tip", mass = 1 },
  } do
    checks.refused("model:mass: " .. words, function() model:mass(with({ node = tip }, options)) end)
  end
  equal(done(model:static {}, "after").hash, before, "the model afterwards")
end)

case("a point mass on a node without a member is refused when a run begins", function()
  local model = cantilever()
  model:mass { node = model:node { 5, 0, 0 }, mass = 1 }
  for call, options in pairs { static = {}, dynamic = { dt = 1e-5, duration = 1e-3 } } do
    checks.refused({ "model:mass: node 3", "has no member", "begins" }, function() model[call](model, options) end)
  end
end)

checks.done()
