-- Effects that act only where and when they can, each against the full computation: bodies at rest, contact between
-- looks, long steps in flight, an operator that is kept, single precision.
--
-- Run: lua5.4 tests/script/effects/sleep_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local scenes = require "scenes"
local hinge = require "hinge"
local impact = require "hinge.models.ten_storey_impact"
local checks = support.checks "sleep"
local case = checks.case
local largest_of = support.largest_of
local expect, equal = checks.expect, checks.equal

local steel = hinge.material { E = 206e9, nu = 0.3, density = 7850, yield_stress = 250e6 }
local elastic, with = scenes.elastic, scenes.with
local bar = hinge.section.solid { width = 0.1, depth = 0.1 }

-- A portal 3 m wide and high at each of the places `at` (m along y), and a bar thrown along y at its beam from `gap`
-- before it. Returns the model, a corner of each portal, and a node of the bar.
local function thrown(o)
  local model, corners = hinge.model {}, {}
  for i, y in ipairs(o.at or { 0 }) do
    local a, b, c, d = model:node { 0, y, 0 }, model:node { 0, y, 3 }, model:node { 3, y, 3 }, model:node { 3, y, 0 }
    model:fix { a, d }
    for _, ends in ipairs { { a, b }, { b, c }, { c, d } } do
      model:member { ends[1], ends[2], section = bar, material = steel }
    end
    corners[i] = b
  end
  local low = model:node { 1.5, -o.gap, 2 }
  model:member { low, model:node { 1.5, -o.gap, 4 }, section = bar, material = steel, group = "missile" }
  model:velocity("missile", { 0, o.speed or 60, 0 }, o.spin)
  if o.gravity then model:gravity { 0, 0, -9.80665 } end
  if o.fracture then model:fracture { curvature_x = o.fracture, curvature_y = o.fracture, axial_strain = 0.3 } end
  model:contact(o.contact or {})
  if o.declare then o.declare(model, corners) end
  return model, corners, low
end

-- The first waking (or, awake = false, falling asleep) of an effect.
local function waking(run, effect, awake)
  for _, w in ipairs(run.state_changes) do
    if w.effect == effect and w.awake == awake then return w end
  end
end

local function completed(run, what)
  run:finish()
  equal(run.verdict, "completed", what .. ": verdict " .. run.reason)
  return run
end

-- The difference of the energies of two runs, as a part of what there was at the start.
local function difference(a, b)
  local most = 0
  for _, name in ipairs { "kinetic", "elastic", "plastic", "fracture", "contact" } do
    most = largest_of(most, math.abs(a.energy[name] - b.energy[name]) / b.energy.initial)
  end
  return most
end

-- Bodies at rest ------------------------------------------------------------------------------------------------------

-- Goes through a run and notes when a pair first touched, when each corner first moved, and when a hinge first formed.
local function observe(run, corners)
  local seen, start = { moved = {} }, {}
  for i, n in ipairs(corners) do start[i] = { run:displacement(n) } end
  while run:step() do
    if not seen.touched and run.contacts.bound > 0 then seen.touched = run.time end
    if not seen.hinge and run:count { state = "yielded" } > 0 then seen.hinge = run.time end
    for i, n in ipairs(corners) do
      local now = { run:displacement(n) }
      for c = 1, 6 do
        if not seen.moved[i] and now[c] ~= start[i][c] then seen.moved[i] = run.time end
      end
    end
  end
  equal(run.verdict, "completed", "at rest: verdict " .. run.reason)
  return seen
end

for what, o in pairs {
  ["surfaces"] = {},
  ["gaps"] = { contact = { rule = "gap" } },
  ["explicit"] = { run = { integrator = "explicit" } },
  ["two bodies"] = { at = { 0, 2 } },
  ["two bodies, explicit"] = { at = { 0, 2 }, run = { integrator = "explicit" } },
} do
  case(("bodies at rest wake when something reaches them: " .. what), function()
    local model, corners = thrown(with(o, { gap = 0.41, gravity = true }))
    local loaded = completed(model:static { fixed_group = "missile", loads = o.loads, record = false }, what)
    local base = with(o.run, { from = loaded, dt = 5e-6, duration = 0.015, record = false })
    local lazy, full = model:dynamic(base), model:dynamic(with(base, { rest = false }))
    local a, b = observe(lazy, corners), observe(full, corners)
    expect(a.touched and a.touched == b.touched, "%s: touched at %s s, all awake at %s s", what, a.touched, b.touched)
    expect(a.moved[1] and a.touched and a.moved[1] >= a.touched and a.moved[1] <= a.touched + 2 * base.dt,
      "%s: the frame moves from %s s, touched at %s s", what, a.moved[1], a.touched)
    expect(b.moved[1] and a.touched and b.moved[1] < a.touched,
      "%s: with rest = false it is computed from the start", what)
    local apart = difference(lazy, full)
    expect(apart < 1e-10, "%s: energies differ by %g of the initial", what, apart)
    expect(lazy.energy.plastic > 0.1 * lazy.energy.initial, "%s: no impact to speak of", what)
    for i in ipairs(corners) do
      local x, y = { lazy:displacement(corners[i]) }, { full:displacement(corners[i]) }
      for c = 1, 6 do
        expect(math.abs(x[c] - y[c]) < 1e-8, "%s: displacement %d of portal %d is %g, %g", what, c, i, x[c], y[c])
      end
    end

    local slept = waking(lazy, #corners == 1 and "body" or "2 bodies", false)
    expect(slept and slept.time == 0 and slept.why:find("^" .. 6 * #corners .. " elements at rest"),
      "%s: asleep from the start", what)
    local woke = waking(lazy, "body", true)
    expect(woke and math.abs(woke.time - (a.touched or 0)) < 1.001 * base.dt
      and woke.why:find "reached at element %d of member 2,",
      "%s: woke at %s s, touched at %s s", what, woke and woke.time, a.touched)
    if corners[2] then
      equal(a.moved[2], nil, what .. ": the portal that nothing reaches moves")
      expect(lazy.counts.element_updates < 0.6 * full.counts.element_updates,
        "%s: %d element updates, %d with rest = false", what, lazy.counts.element_updates, full.counts.element_updates)
      local again = 0
      for _, w in ipairs(lazy.state_changes) do again = again + (w.effect == "body" and w.awake and 1 or 0) end
      equal(again, 1, what .. ": bodies woken")
    end
    expect(not waking(full, "body", false) and not waking(full, "2 bodies", false) and not waking(full, "body", true),
      "%s: rest = false lets bodies rest", what)

    local hinge_woke = waking(lazy, "plasticity", true)
    expect(a.hinge and hinge_woke and math.abs(hinge_woke.time - a.hinge) < 1.001 * base.dt
      and hinge_woke.why:find " flows?: element ",
      "%s: the first hinge at %s s, plasticity awake at %s s", what, a.hinge, hinge_woke and hinge_woke.time)
  end)
end

case("a bar that drives one portal into another wakes them one after the other", function()
  local model, corners = thrown { gap = 0.41, gravity = true, at = { 0, 0.2 } }
  local loaded = completed(model:static { fixed_group = "missile", record = false }, "one after the other")
  local base = { from = loaded, dt = 5e-6, duration = 0.02, record = false }
  local lazy, full = model:dynamic(base), model:dynamic(with(base, { rest = false }))
  local a, b = observe(lazy, corners), observe(full, corners)
  local times = {}
  for _, w in ipairs(lazy.state_changes) do
    if w.effect == "body" and w.awake then times[#times + 1] = w.time end
  end
  expect(#times == 2 and times[1] < times[2], "one after the other: %d changes", #times)
  expect(times[2] and a.moved[2] and a.moved[2] > times[2] and a.moved[2] < times[2] + 3 * base.dt,
    "one after the other: the second moves from %s s", a.moved[2])
  expect(difference(lazy, full) < 1e-9, "one after the other: energies differ by %g", difference(lazy, full))
  expect(a.touched == b.touched, "one after the other: touched at %s, %s s", a.touched, b.touched)
end)

-- What is not at rest: under a load with a history, out of balance, or under way.
case("bodies under a changing load, out of balance or under way do not rest", function()
  for what, o in pairs {
    ["a load with a history"] = { static = true, declare = function(m, corners)
      m:case "push":load { node = corners[1], force = { 0, 0, 1 }, history = function() return 1 end }
    end, loads = "push" },
    ["gravity, not brought to equilibrium"] = { gravity = true },
    ["a load, not brought to equilibrium"] = { declare = function(m, corners)
      m:load { node = corners[1], force = { 0, 10, 0 } }
    end },
    ["a moment, not brought to equilibrium"] = { declare = function(m, corners)
      m:load { node = corners[1], moment = { 0, 10, 0 } }
    end },
    ["a frame under way"] = { declare = function(m, corners) m:velocity(corners[1], { 1e-6, 0, 0 }) end },
  } do
    for _, integrator in ipairs { "newmark", "explicit" } do
      local model, corners = thrown(with(o, { gap = 1 }))
      local loaded = o.static
        and completed(model:static { fixed_group = "missile", loads = o.loads, record = false }, what) or nil
      local run = model:dynamic { from = loaded, dt = 5e-6, duration = 5e-4, integrator = integrator, record = false }
      local start = { run:displacement(corners[1]) }
      completed(run, what)
      local moved = false
      for c, u in ipairs { run:displacement(corners[1]) } do moved = moved or u ~= start[c] end
      expect(not waking(run, "body", false), "%s, %s: the frame is left at rest", what, integrator)
      if not o.static then expect(moved, "%s, %s: the frame does not move", what, integrator) end
    end
  end
end)

case("a frame under a moment rests once statics has brought it to equilibrium", function()
  local model, corners = thrown { gap = 1, declare = function(m, at)
    m:load { node = at[1], moment = { 0, 1000, 0 } }
  end }
  local loaded = completed(model:static { fixed_group = "missile", record = false }, "a moment")
  local start = { loaded:displacement(corners[1]) }
  local run = completed(model:dynamic { from = loaded, dt = 5e-6, duration = 5e-4, record = false }, "a moment")
  expect(waking(run, "body", false), "a moment in equilibrium: the frame does not rest")
  for c, u in ipairs { run:displacement(corners[1]) } do
    equal(u, start[c], "a moment in equilibrium: displacement " .. c)
  end
  expect(math.abs(start[5]) > 1e-5, "a moment in equilibrium: the corner has rotated by %g", start[5])
end)

case("a beam that loses a support wakes and falls as if it had never rested", function()
  local function robbed(rest)
    local model = hinge.model {}
    local head
    for i = 0, 2 do
      local foot, top = model:node { 3 * i, 0, 0 }, model:node { 3 * i, 0, 3 }
      model:fix(foot)
      model:member { foot, top, section = bar, material = elastic, group = i == 1 and "middle" or "sides" }
      if head then model:member { head, top, section = bar, material = elastic } end
      head = top
    end
    model:gravity { 0, 0, -9.80665 }
    local post = model:group "middle":members()[1]
    model:fracture { group = "middle", where = "all", rule = function(s)
      return s.time >= 2e-3 and s.node == post.b.index
    end }
    local run = completed(model:dynamic { from = model:static():finish(), dt = 1e-4, duration = 0.1, rest = rest },
      "a post lost")
    return run, select(3, post.b:displacement(run))
  end
  local run, depth = robbed(true)
  local _, exact = robbed(false)
  local woken = waking(run, "body", true)
  expect(woken and support.says(woken.why, "it was at rest; broken at element ...")
    and math.abs(woken.time - 2e-3) < 2e-4, "a post lost: woken by %s", woken and woken.why)
  expect(exact < -5e-4 and math.abs(depth / exact - 1) < 1e-6,
    "a post lost: the head falls by %g m, without rest by %g m", depth, exact)
  expect(math.abs(run.energy.energy_error) < 1e-6 * -run.energy.gravity, "a post lost: energy error %g J",
    run.energy.energy_error)
end)

-- Contact between looks -----------------------------------------------------------------------------------------------

-- Case I of the ten-storey impact, from its rest; `rule` goes to model:contact.
local function case_one(options, rule)
  local p = impact.parameters { design = "heavy" }
  p.contact, p.contact_limits = rule and rule.rule or "gap", rule and { sleep = rule.sleep } or {}
  local model = hinge.model {}
  local _, plane = impact.add(model, p)
  local loaded = completed(model:static { fixed_group = plane, record = false }, "Case I at rest")
  local all = with({ from = loaded, dt = 1e-5, duration = 6e-3, beta = 0.4, record = false }, options)
  return completed(model:dynamic(all), "Case I")
end

-- `saves`: how many times fewer pairs are looked at, at least; bodies that stay near each other
-- are looked at whenever they move.
for what, c in pairs {
  ["surfaces, two portals"] = { rule = "surface", saves = 8, duration = 0.045, at = { 0, 2 }, gap = 0.41 },
  ["surfaces, with friction"] = { rule = "surface", friction = 0.3, saves = 5, duration = 0.03, gap = 0.41,
    spin = { 5, 0, 3 } },
  ["gaps, bound most of the time"] = { rule = "gap", saves = 1.2, duration = 0.045, at = { 0, 2 }, gap = 0.41 },
  ["gaps, debris"] = { rule = "gap", saves = 1.5, duration = 0.045, at = { 0, 2 }, gap = 1, spin = { 20, 0, 10 },
    fracture = 0.6, debris = true },
  ["surfaces, Case I"] = { rule = "surface", saves = 20, case = true },
  ["gaps, Case I"] = { rule = "gap", saves = 20, case = true, debris = true },
} do
  case("fewer pairs are tested and no bit changes: contact, " .. what, function()
    local function go(sleep)
      local rule = { rule = c.rule, friction = c.friction, sleep = sleep }
      if c.case then return case_one({}, rule) end
      return completed(thrown(with(c, { contact = rule })):dynamic { dt = 1e-5, duration = c.duration, record = false },
        what)
    end
    local lazy, full = go(nil), go(false)
    local fewer = full.counts.pair_tests / lazy.counts.pair_tests
    equal(lazy.hash, full.hash, what .. ": hash")
    expect(lazy.contacts.bound > 0 and lazy.contacts.released > 0, "contact, %s: %d touches, %d released", what,
      lazy.contacts.bound, lazy.contacts.released)
    if c.debris then expect(lazy:count { state = "broken" } > 0, "contact, %s: nothing breaks", what) end
    expect(fewer >= c.saves, "contact, %s: only %.1f times fewer pair tests than with sleep = false", what, fewer)
  end)
end

case("contact wakes when bodies come near and sleeps when they have parted", function()
  local run = completed(thrown { gap = 0.41 }:dynamic { dt = 1e-5, duration = 0.02, record = false },
    "contact's changes of state")
  local woke, slept = waking(run, "contact", true), waking(run, "contact", false)
  local touched = waking(run, "body", true)
  local why = "^2 bodies within [%d.]+ m: element %d of member %d.* and element %d of member 4 %(missile%)"
  expect(woke and woke.why:find(why), "contact wakes: %s", woke and woke.why)
  expect(woke and touched and slept and woke.time > 0 and woke.time < touched.time and touched.time < slept.time,
    "contact wakes, touches and sleeps: %s, %s, %s s",
    woke and woke.time, touched and touched.time, slept and slept.time)
  local last
  for _, w in ipairs(run.state_changes) do
    if w.effect == "contact" then
      expect(w.awake ~= last, "contact: twice %s", w.awake and "awake" or "asleep")
      last = w.awake
    end
  end
end)

-- dt = "auto" ---------------------------------------------------------------------------------------------------------

case("dt = auto takes long steps in free flight and short ones at a touch", function()
  local duration = 0.1
  local run = thrown { gap = 3 }:dynamic { dt = "auto", duration = duration, record = false }
  local planned = run.planned_steps
  local shortest = duration / planned
  local last, bound, longest, touched = 0, 0, 0, nil
  while run:step() do
    local step = run.time - last
    longest = largest_of(longest, step)
    if run.contacts.bound > bound then
      touched = touched or run.time
      expect(step < 1.001 * shortest, "auto: a touch began in a step of %g s at %g s", step, run.time)
    end
    last, bound = run.time, run.contacts.bound
  end
  equal(run.verdict, "completed", "auto: verdict " .. run.reason)
  equal(run.time, duration, "auto: time at the end")
  expect(longest > 7.9 * shortest and longest < 8.1 * shortest,
    "auto: the longest step is %g of the shortest", longest / shortest)
  local woke, slept = waking(run, "long steps", true), waking(run, "long steps", false)
  expect(woke and slept and touched and woke.time < slept.time and slept.time <= touched,
    "auto: long steps from %s to %s s, touched at %s s", woke and woke.time, slept and slept.time, touched)

  local fine = thrown { gap = 3 }:dynamic { dt = shortest / 4, duration = duration, record = false }
  local fine_touched
  while fine:step() do
    if not fine_touched and fine.contacts.bound > 0 then fine_touched = fine.time end
  end
  local apart, energy_error = difference(run, fine), math.abs(run.energy.energy_error) / run.energy.initial
  expect(run.index < 0.7 * planned, "auto: %d steps of %d planned", run.index, planned)
  expect(apart < 0.005, "auto: energies differ by %.3f %%", 100 * apart)
  expect(energy_error < 0.0002, "auto: energy error %.4f %%", 100 * energy_error)
  expect(math.abs(touched - fine_touched) < 2 * shortest,
    "auto: touched at %g s, with finer steps at %g s", touched, fine_touched)
end)

case("before a touch the long steps end once", function()
  for _, rule in ipairs { "surface", "gap" } do
    local run = thrown { gap = 3, contact = { rule = rule } }:dynamic { dt = "auto", duration = 0.06, record = false }
    local changes = 0
    while run.contacts.bound == 0 and run:step() do end
    expect(run.contacts.bound > 0, "auto, %s: nothing touches", rule)
    for _, w in ipairs(run.state_changes) do changes = changes + (w.effect == "long steps" and 1 or 0) end
    equal(changes, 2, "auto, " .. rule .. ": changes of step up to the first touch")
  end
end)

case("with contact declared and nothing near, dt = auto flies as a rigid body", function()
  local model, _, low = thrown { gap = 50 }
  local run = completed(model:dynamic { dt = "auto", duration = 0.1, record = false }, "flight")
  local x, y, z, rx, ry, rz = run:displacement(low)
  expect(math.abs(y - 6) < 1e-12 and x == 0 and z == 0 and rx == 0 and ry == 0 and rz == 0,
    "flight: displacement %g %g %g", x, y, z)
  equal(run.energy.kinetic, run.energy.initial, "flight: kinetic energy")
  equal(#run.state_changes, 2, "flight: the frame sleeps, steps become long, and nothing else")
end)

-- Something stands still, or flies, until a load comes: no long step is taken across its beginning or its end.
case("dt = auto takes no long step across the beginning or end of a load", function()
  for what, c in pairs { ["standing"] = { width = 1e-3 }, ["flying"] = { width = 1e-3, flies = true },
    ["flying, a tap"] = { width = 2e-5, flies = true } } do
    local function pushed(dt)
      local model = hinge.model {}
      local a, b = model:node { 0, 0, 0 }, model:node { 0.5, 0, 0 }
      local tip = model:node { 1, 0, 0 }
      model:member { a, b, section = bar, material = elastic, group = "rod" }
      model:member { b, tip, section = bar, material = elastic, group = "rod" }
      if c.flies then model:velocity("rod", { 0, 10, 0 }) else model:fix(a) end
      model:load { node = tip, force = { 0, 0, -5000 }, history = function(t)
        return t >= 0.01 and t < 0.01 + c.width and 1 or 0
      end }
      local run = model:dynamic { dt = dt, duration = 0.02, record = false }
      local planned = run.planned_steps
      return completed(run, what), select(3, run:displacement(tip)), planned
    end
    local run, z, planned = pushed "auto"
    local even, wanted = pushed(0.02 / planned)
    expect(run.index < 0.7 * planned, "a load comes, %s: %d steps of %d", what, run.index, planned)
    expect(math.abs(run.energy.work / even.energy.work - 1) < 5e-3,
      "a load comes, %s: work %g J, in short steps %g J", what, run.energy.work, even.energy.work)
    expect(math.abs(z / wanted - 1) < 2e-2,
      "a load comes, %s: the tip is at %g m, in short steps at %g m", what, z, wanted)
  end
end)

case("dt = auto takes no long steps for a cantilever that vibrates", function()
  for _, displacement in ipairs { "small", "large" } do
    local function cantilever(dt)
      local model = hinge.model { displacement = displacement }
      local last = model:node { 0, 0, 0 }
      model:fix(last)
      for i = 1, 4 do
        local next = model:node { 0.5 * i, 0, 0 }
        model:member { last, next, section = bar, material = elastic }
        last = next
      end
      model:load { node = last, force = { 0, 0, -5000 } }
      local run = model:dynamic { dt = dt, duration = 0.1, record = false }
      local tip, planned = run:probe { node = last, "uz" }, run.planned_steps
      return completed(run, "cantilever"), tip, planned
    end
    local run, tip, planned = cantilever "auto"
    local _, even = cantilever(0.1 / planned)
    local values, worst = even.value, 0
    local value = tip.value
    for i, t in ipairs(tip.time) do
      worst = largest_of(worst, math.abs(value[i] - values[math.floor(t / 0.1 * planned + 0.5) + 1]))
    end
    expect(even.min < -0.01, "cantilever: it swings to %g m", even.min)
    expect(worst < -1e-3 * even.min,
      "cantilever, %s displacement: tip off by %g of its swing", displacement, worst / -even.min)
    expect(#run.state_changes < 20, "cantilever, %s displacement: the step changed %d times", displacement,
      #run.state_changes)
  end
end)

-- The operator: kept while elements turn little; in single precision --------------------------------------------------

-- An elastic corner that flies, rotates and bends.
local function corner(options)
  local model = hinge.model {}
  local a, b, c = model:node { 0, 0, 0 }, model:node { 0, 0, 1 }, model:node { 1, 0, 1 }
  for _, ends in ipairs { { a, b }, { b, c } } do
    model:member { ends[1], ends[2], section = scenes.square, material = elastic, group = "corner" }
  end
  model:velocity("corner", { 0, 3, 0 }, { 10, 20, 30 })
  local run = model:dynamic(with({ dt = 1e-5, duration = 0.02, record = false }, options))
  local tip = run:probe { node = c, "uz" }
  return completed(run, "corner"), tip
end

for what, go in pairs { ["Case I"] = case_one, ["a corner that rotates"] = corner } do
  case(what .. ": rebuild_angle and single precision change the energies by less than 1e-7 and 1e-8", function()
    local usual, fresh, double = go {}, go { internals = { rebuild_angle = 1e-9 } }, go { precision = "double" }
    local apart, fewer, rounding = difference(usual, fresh), fresh.counts.element_builds / usual.counts.element_builds,
      difference(usual, double)
    expect(apart < 1e-7, "%s: rebuild_angle = 1e-9 changes the energies by %g", what, apart)
    expect(fewer > 5, "%s: rebuild_angle = 1e-9 builds only %.1f times as many elements", what, fewer)
    expect(rounding < 1e-8, "%s: double precision changes the energies by %g", what, rounding)
  end)
end
case("double precision moves the tip of a corner that rotates by less than 1e-6 m", function()
  local single, tip = corner {}
  local double, exact = corner { precision = "double" }
  expect(single.hash ~= double.hash, "precision = 'double' changes nothing")
  local a, b, worst = tip.value, exact.value, 0
  for i = 1, #a do worst = largest_of(worst, math.abs(a[i] - b[i])) end
  expect(exact.max - exact.min > 0.1 and worst < 1e-6,
    "double precision: the tip differs by %g m, moving by %g m", worst, exact.max - exact.min)
end)

checks.done()
