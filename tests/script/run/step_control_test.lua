-- Step control: a step that would lose too much is taken back and halved before anything is
-- told of it, and steps grow again.
--
-- Run: lua5.4 tests/script/run/step_control_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local hinge = require "hinge"
local checks = support.checks "step_control"
local case, expect, equal = checks.case, checks.expect, checks.equal
local bar, steel = hinge.section.solid { width = 0.05, depth = 0.05 }, hinge.material { E = 206e9, density = 7850 }

local function share(run) return math.abs(run.energy.energy_error) / run.energy.initial end

-- A bar that rotates by 0.03 rad a step, by one solve a step from the displacement held: it cannot hold.
local function bar_in_flight()
  local model = hinge.model {}
  local a, b = model:node { 0, 0, 0 }, model:node { 1, 0, 0 }
  model:member { a, b, section = bar, material = steel, group = "bar" }
  model:velocity("bar", { 0, 0, 0 }, { 0, 0, 314 })
  return model
end
local function turning(options)
  options.dt, options.duration, options.iterations, options.record = 1e-4, 0.05, 1, false
  return bar_in_flight():dynamic(options)
end
local dt = 1e-4
local run, last, told = turning { step_control = 0.01 }, 0, 0
case("a bar that rotates far a step loses no more than step control allows", function()
  run:on_step(function(r)
    local parts = dt / (r.time - last)
    expect(math.abs(parts - math.floor(parts + 0.5)) < 1e-6 and parts <= 1024, "a step of dt / %.9g at %g s",
      parts, r.time)
    last, told = r.time, told + 1
  end)
  run:finish()
  equal(run.verdict, "completed", "a bar that rotates: " .. run.reason)
  expect(share(run) <= 0.01, "energy error %g", share(run))
  expect(run.counts.rejected_steps > 0 and run.dt < dt, "%d steps taken back, dt %g", run.counts.rejected_steps, run.dt)
  equal(told, run.index, "steps told to the script")
  expect(math.abs(run.time - 0.05) < 1e-15, "it ends at %.17g s", run.time)
end)

case("where every step may be kept, step control changes no bit", function()
  -- Where every step may be kept, it changes no bit.
  local free, watched = turning { energy_tolerance = 0 }, turning { energy_tolerance = 0, step_control = 0.999 }
  for _ = 1, 3 do free:step() watched:step() end
  equal(watched.counts.rejected_steps, 0, "none taken back")
  equal(watched.hash, free.hash, "the bits of three steps")
end)

case("what no step can meet ends the run in the state before", function()
  -- What no step can meet ends the run by itself, in the state before.
  local never = turning { step_control = 1e-15 }
  never:finish()
  equal(never.verdict, "failed", "step_control = 1e-15")
  expect(support.says(never.reason,
    "step ..., t = ... s: the step would lose ... % of the largest energy, its share of step_control is ... %; "
    .. "dt was halved down to 9.77e-08 s, and no shorter step is tried; step_control = 0.01 holds: tried "
    .. "from t = ... s to ... s"),
    "reason: %s", never.reason)
  expect(share(never) < 1e-3 and not never:step(), "the state before it, energy error %g", share(never))
end)

-- Impact by surfaces at eight times the step that it needs: what the script is told of belongs to steps that were kept.
local function crash(options)
  local model, touched, released, asked = hinge.model {}, 0, 0, {}
  local function row(group, from, to)
    local nodes = {}
    for i = 0, 2 do
      nodes[i + 1] = model:node { from[1] + (to[1] - from[1]) * i / 2, from[2] + (to[2] - from[2]) * i / 2, from[3] }
    end
    for i = 1, 2 do model:member { nodes[i], nodes[i + 1], section = bar, material = steel, group = group } end
    return nodes
  end
  row("struck", { 0, 0, 0 }, { 1, 0, 0 })
  local striker = row("striker", { 0, 0, 0.06 }, { 1, 0, 0.06 })
  model:velocity("striker", { 0, 0, -20 })
  model:contact { rule = "surface", on_contact = function() touched = touched + 1 end,
    on_release = function() released = released + 1 end }
  model:load { node = striker[2], force = { 1, 0, 0 }, history = function(t) asked[#asked + 1] = t return 1 end }
  options.duration, options.record = 4e-3, false
  local crashed = model:dynamic(options)
  local before = crashed:momentum().linear[3]
  crashed:finish()
  return crashed, touched, released, asked, math.abs(crashed:momentum().linear[3] / before - 1)
end
case("impact in steps of eight times the length keeps the energy, with the same bits on two threads", function()
  local long = crash { dt = 4e-5, energy_tolerance = 0, step_control = 0 }
  expect(share(long) > 0.02, "without control the energy balance is off by %g", share(long))
  local held, touched, released, asked, lost = crash { dt = 4e-5, step_control = 0.01 }
  equal(held.verdict, "completed", "impact: " .. held.reason)
  expect(share(held) <= 0.01 and lost < 1e-6, "impact: energy error %g, momentum %g", share(held), lost)
  expect(held.counts.rejected_steps > 0, "impact: steps taken back")
  equal(held.contacts.bound, touched, "touches told")
  equal(held.contacts.released, released, "releases told")
  local back = 0
  for i = 2, #asked do back = back + (asked[i] < asked[i - 1] and 1 or 0) end
  expect(back >= held.counts.rejected_steps,
    "loads are asked again where a step is tried again: %d times for %d", back, held.counts.rejected_steps)
end)

case("a function that fails in a step of step control is undone", function()
  -- A function of the script that fails in a step is undone as ever.
  local model = hinge.model {}
  local a, b = model:node { 0, 0, 0 }, model:node { 1, 0, 0 }
  model:member { a, b, section = bar, material = steel }
  model:fix(a)
  local fails = false
  model:load { node = b, force = { 0, 0, 1e3 }, history = function() return fails and error "not now" or 1 end }
  local undone = model:dynamic { dt = 1e-5, duration = 1e-3, step_control = 0.01, record = false }
  for _ = 1, 10 do undone:step() end
  local before = undone.hash
  fails = true
  local ok, why = pcall(undone.step, undone)
  expect(not ok and tostring(why):find "not now", "the function's error: %s", why)
  equal(undone.hash, before, "the state before it")
  fails = false
  undone:finish()
  equal(undone.verdict, "completed", "and goes on")
end)

case("hinges that chatter are stepped through", function()
  -- Hinges that chatter so that Newton's method finds no end: steps that cannot be solved are halved too.
  local function mechanism(options)
    local model = hinge.model {}
    local soft = hinge.material { E = 206e9, density = 7850, yield_stress = 1e6 }
    local nodes = {}
    for level = 0, 2 do
      nodes[level] = {}
      for x = 0, 2 do nodes[level][x] = model:node { 3 * x, 0, 3 * level } end
    end
    model:fix { nodes[0][0], nodes[0][1], nodes[0][2] }
    for level = 1, 2 do
      for x = 0, 2 do
        model:member { nodes[level - 1][x], nodes[level][x], section = bar, material = soft }
        if x > 0 then model:member { nodes[level][x - 1], nodes[level][x], section = bar, material = soft } end
      end
    end
    model:gravity { 0.5, 0, -9.80665 }
    options.dt, options.duration, options.record = 2e-3, 0.2, false
    return model:dynamic(options):finish()
  end
  local kept, alone, controlled = mechanism { step_control = 0 }, mechanism {}, mechanism { step_control = 0.01 }
  local function said(r)
    return ("%s, %d taken back, %d steps, dt %g s"):format(r.verdict, r.counts.rejected_steps, r.index, r.dt)
  end
  print(("hinges everywhere: all steps kept %s; by default %s; with step control %s")
    :format(said(kept), said(alone), said(controlled)))
  equal(controlled.verdict, "completed", "hinges everywhere: " .. controlled.reason)
  -- By default, too, where there are hinges; a run whose steps must all be kept fails, and names what holds.
  equal(alone.verdict, "completed", "hinges everywhere, by default: " .. alone.reason)
  expect(alone.counts.rejected_steps > 0 and math.abs(alone.time - 0.2) < 1e-12,
    "by default %d taken back, ends at %.17g s", alone.counts.rejected_steps, alone.time)
  expect(math.abs(alone.energy_error) <= 0.002, "by default: energy error %g", alone.energy_error)
  expect(support.says(kept.reason, "step ..., t = ... s: Newton did not converge in 30 iterations (last correction "
    .. "... of the first); step_control = 0.01 holds: tried from t = ... s to ... s"),
    "all steps kept: %s", kept.reason)
end)

case("while no step is taken back the default changes no bit, no time and no step", function()
  -- While no step is taken back, the default changes no bit, no time and no step: hinges, contact, fracture.
  local function same(what, make)
    local default, kept = make {}, make { step_control = 0 }
    equal(default.verdict, "completed", what .. ": " .. default.reason)
    equal(default.counts.rejected_steps, 0, what .. ": steps taken back")
    equal(default.hash, kept.hash, what .. ": bits")
    equal(default.time, kept.time, what .. ": time")
    equal(default.index, kept.index, what .. ": steps")
    equal(default.dt, kept.dt, what .. ": dt")
    local text = "halved where one would lose more than its share of 0.1 % of the energy"
    expect(default.effects[1].because:find(text, 1, true) and not kept.effects[1].because:find(text, 1, true),
      "%s: the plan says %s", what, default.effects[1].because)
  end
  same("impact", function(options)
    options.dt = 1e-6
    return (crash(options))
  end)
  same("hinges and fracture", function(options)
    local model = hinge.model {}
    local a, b = model:node { 0, 0, 0 }, model:node { 0, 0, 1 }
    model:member { a, b, section = bar, material = hinge.material { E = 206e9, density = 7850, yield_stress = 235e6 } }
    model:fix(a)
    model:fracture { curvature_x = 0.4, curvature_y = 0.4, axial_strain = 0.3 }
    model:velocity(b, { 30, 0, 0 })
    options.dt, options.duration, options.record = 1e-5, 0.01, false
    return model:dynamic(options):finish()
  end)
end)

case("a trial of a remedy calls no function of the script", function()
  -- A trial of what may hold calls no function of the script: where there is one, the remedy is named untried.
  local model, calls, latest = hinge.model {}, 0, -1
  local a, b = model:node { 0, 0, 0 }, model:node { 1, 0, 0 }
  model:member { a, b, section = bar, material = steel, group = "bar" }
  model:velocity("bar", { 0, 0, 0 }, { 0, 0, 314 })
  model:load { node = b, force = { 0, 0, 1 }, history = function(t) calls, latest = calls + 1, t return 1 end }
  local fails = model:dynamic { dt = 1e-4, duration = 0.05, iterations = 1, record = false }
  local seen = 0
  fails:on_step(function() seen = seen + 1 end)
  fails:finish()
  equal(fails.verdict, "failed", "a bar that rotates, with a load by a function")
  expect(fails.reason:find("; step_control = 0.01 may hold (not tried: it would call functions of the script)", 1,
    true), "it says: %s", fails.reason)
  expect(calls <= seen + 6 and latest <= 1e-4 * (seen + 1.5), "%d calls up to %g s in %d steps", calls, latest, seen)
end)

case("dt = auto has step control by default, and a number has not", function()
  -- dt = "auto" has it by itself, and only that.
  local text = "halved where one would lose more than its share of "
  local function said(options) return bar_in_flight():dynamic(options).effects[1].because end
  expect(said { dt = "auto", duration = 1e-3 }:find(text .. "0.1 %", 1, true), "auto: %s",
    said { dt = "auto", duration = 1e-3 })
  expect(said { dt = 1e-5, duration = 1e-3, step_control = 0.02 }:find(text .. "2 %", 1, true), "as told")
  for _, none in ipairs { { dt = "auto", duration = 1e-3, step_control = 0 }, { dt = 1e-5, duration = 1e-3 },
    { dt = "auto", duration = 1e-3, integrator = "explicit" } } do
    expect(not said(none):find(text, 1, true), "not there: %s", said(none))
  end
end)

checks.done()
