-- What accuracy costs: errors and orders against closed forms, chaos called chaos, budgets kept,
-- finished settings not run again.
--
-- Run: lua5.4 tests/script/cost/cost_test.lua BUILD_FOLDER
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local hinge = require "hinge"
local compare = require "hinge.cost.compare"
local methods = require "hinge.cost.methods"
local checks = support.checks "cost"
local case, expect, equal, near = checks.case, checks.expect, checks.equal, checks.near

local function find(result, wanted)
  for _, s in ipairs(result.settings) do
    local same = true
    for name, value in pairs(wanted) do same = same and s.values[name] == value end
    if same then return s end
  end
  expect(false, "no such setting")
  return { errors = {}, values = {}, answers = {} }
end
local function refused(message, f, ...)
  local ok, failure = pcall(f, ...)
  expect(not ok and support.says(tostring(failure), message), "says   %s\n    wanted %s", tostring(failure), message)
end

-- Comparing -----------------------------------------------------------------------------------------------------------

local front = compare.front { { time = 1, error = 9 }, { time = 2, error = 3 }, { time = 3, error = 3 },
  { time = 4, error = 4 }, { time = 5, error = 1 }, { time = 0.5 }, { time = 2, error = 5 } }
case("the Pareto front and the order of convergence of known numbers", function()
  equal(#front, 3, "items on the front")
  for i, wanted in ipairs { { 1, 9 }, { 2, 3 }, { 5, 1 } } do
    expect(front[i] and front[i].time == wanted[1] and front[i].error == wanted[2], "item %d of the front", i)
  end
  equal(#compare.front { { time = 1, error = 2 }, { time = 2, error = 1.999 }, { time = 3, error = 1.99 } }, 2,
    "what is better by rounding alone is not on the front")
  for p, h in pairs { [1] = { 4, 2, 1 }, [2] = { 5, 3, 1 }, [4] = { 4, 3, 1 } } do
    local answers = {}
    for i, size in ipairs(h) do answers[i] = 10 - 0.01 * size ^ p end
    near(compare.order(h, answers) or 0, p, 1e-2, "order of 10 - h^p / 100")
  end
  equal(compare.order({ 4, 2, 1 }, { 3, 3, 3 }), math.huge, "order of what is exact")
  equal(compare.order({ 4, 2, 1 }, { 1, 2, 4 }), nil, "order of what diverges")
  near(compare.error(9, 10), 0.1, 1e-15, "error of a number")
end)

local function sine(n, shift)
  local h = { x = {}, y = {} }
  for i = 1, n + 1 do
    h.x[i] = (i - 1) / n
    h.y[i] = math.sin(2 * math.pi * h.x[i]) + shift
  end
  return h
end
case("the error of a curve is that beside the other one, at any points", function()
  near(compare.error(sine(40, 0), sine(64, 0)), 0, 3e-6, "error of one curve at other points")
  near(compare.error(sine(40, 0.02), sine(64, 0)), 0.02, 3e-6, "error of a curve that lies 0.02 beside one of height 1")
end)

-- A number that is not one is never near.
local nan = 0 / 0
case("an error that is not a number is on no front and gives no order", function()
  local huge = math.huge
  for _, pair in ipairs { { nan, 1 }, { 1, nan }, { nan, nan }, { 1, huge }, { huge, 1 }, { huge, huge } } do
    equal(compare.error(pair[1], pair[2]), math.huge, ("error of %g against %g"):format(pair[1], pair[2]))
  end
  for _, at in ipairs { 1, 20, 41, 65 } do -- the last is beyond where the other curve ends
    for _, bad in ipairs { nan, math.huge } do
      local short, long = sine(40, 0), sine(64, 0)
      for i = 1, #long.x do long.x[i] = 1.6 * long.x[i] end
      long.y[at] = bad
      equal(compare.error(short, long), math.huge, ("error against a curve whose point %d is %g"):format(at, bad))
      equal(compare.error(long, sine(64, 0)), math.huge, ("error of a curve whose point %d is %g"):format(at, bad))
    end
  end
  equal(compare.order({ 4, 2, 1 }, { 3, nan, 3 }), nil, "order of what is not a number")
  local known_errors = { { time = 1, error = nan }, { time = 2, error = 3 } }
  equal(#compare.front(known_errors), 1, "an error that is not a number is not on the front")
  for at = 1, 3 do
    local worst = 0
    for i = 1, 3 do worst = compare.larger(worst, i == at and nan or 1e-16) end
    expect(worst ~= worst, "compare.larger keeps what is not a number at place %d", at)
  end
  do
    local verdict = require "hinge.cost.verdict"
    local function record(value) return { record = { answers = { v = value } } } end
    local known = verdict.answers({ record(nan), record(1) }, { v = 0 }, {}, {}, 0.1)
    equal(known.v.state, "unsettled", "an answer whose coarser reference is not a number")
    known = verdict.answers({ record(1), record(1) }, { v = nan }, {}, {}, 0.1)
    equal(known.v.state, "chaotic", "an answer whose scatter is not a number")
  end
end)

case("methods are compared by the time at equal error", function()
  -- Methods at equal error: time n and error 1 / n^2 by one way, time 3 n and error 1 / n by another, so that the time
  -- is error^(-1/2) and 3 / error.
  local raced = {}
  for _, n in ipairs { 2, 4, 8, 16 } do
    raced[#raced + 1] = { values = { n = n, way = "quick" }, seconds = n, high = 1 / n ^ 2 }
    raced[#raced + 1] = { values = { n = n, way = "slow" }, seconds = 3 * n, high = 1 / n }
    raced[#raced + 1] = { values = { n = n, way = "exact" }, seconds = 5 * n, high = 0 }
  end
  local race = methods.compare(
    { { name = "n", values = { 2, 4, 8, 16 }, side = {} }, { name = "way", values = { "quick", "slow", "exact" } } },
    raced, 0.11, { high = 0.03 })
  equal(race.n, nil, "a number with a finer side is no method")
  equal(#race.way, 3, "errors at which ways are compared: that asked for, that of the cheapest, the least that all "
    .. "reach")
  for i, error in ipairs { 0.11, 1 / 16, 0.03 } do
    local row = race.way[i]
    near(row.error, error, 1e-12, "error at which ways are compared")
    near(row.methods[1].seconds, error ^ -0.5, 1e-9, "time of the quick way")
    near(row.methods[2].seconds, math.min(3 / error, 48), 1e-9, "time of the slow way")
    near(row.methods[2].ratio, math.min(3 / error, 48) * error ^ 0.5, 1e-9, "its ratio")
    equal(row.methods[2].more or false, error < 1 / 16, "the slow way never comes nearer than 1/16")
    near(row.methods[3].seconds, 10, 1e-12, "time of what is exact at its cheapest")
  end
  equal(race.way[1].methods[1].settings[1].values.n, 2, "the setting before")
  equal(race.way[1].methods[1].settings[2].values.n, 4, "and after")
  equal(#race.way[2].methods[1].settings, 1, "a setting that has just that error")
  equal(methods.time_at(methods.front {}, 0.1), nil, "time of no setting")
end)

case("the answer whose band reaches farthest has the error of a setting", function()
  local function found(error)
    return { found = { by = "order", answer = 1, error = error }, finest = 1, state = "sound" }
  end
  local s = { record = { answers = { near = 1.05, far = 1.04 } } }
  require "hinge.cost.verdict".errors({ s }, {}, { near = found(0.001), far = found(0.03) })
  equal(("%s %.3f %.3f %.3f"):format(s.worst, s.error, s.low, s.high), "far 0.040 0.010 0.070", "error and band")
end)

case("what a run will take is foretold from runs of its own method", function()
  local inputs = { { name = "n", values = { 1, 2 }, side = { finer = "larger", ratio = 2, work = 1 } },
    { name = "way", values = { "quick", "slow" } } }
  local bench = require "hinge.cost.bench".open({ run = print }, {}, inputs, { perturbation = 1e-9 })
  bench.timed = { { weight = 1, seconds = 1, values = { n = 1, way = "quick" } },
    { weight = 2, seconds = 50, values = { n = 2, way = "slow" } } }
  local wanted = { weight = 4, values = { n = 4, way = "quick" } }
  function bench.growth() return 1 end
  near(bench:estimate(wanted), 4, 1e-12, "four times the quick run, not twice the slow one")
end)

case("settings that are one and the same run stand once, without the number that changes nothing", function()
  local swing = hinge.scenario {
    accuracy = { dt = { 2e-3, 1e-3 }, integrator = { "newmark", "explicit" } },
    run = function(p)
      local model = hinge.model()
      local wall, tip = model:node { 0, 0, 0 }, model:node { 1, 0, 0 }
      model:fix(wall)
      model:member { wall, tip, section = hinge.section.solid { width = 0.05, depth = 0.05 },
        material = hinge.material { E = 206e9, density = 7850 } }
      model:load { node = tip, force = { 0, 0, -100 } }
      local run = model:dynamic { integrator = p.integrator, dt = p.integrator == "explicit" and "auto" or p.dt,
        duration = 0.02 }
      return { tip = select(3, tip:displacement(run:finish())) }
    end,
  }
  local r = hinge.cost(swing, { repeats = 1, within = 0.5 })
  local seen = {}
  for i, s in ipairs(r.settings) do seen[i] = s.label end
  table.sort(seen)
  equal(table.concat(seen, "; "), "dt 0.001, integrator newmark; dt 0.002, integrator newmark; integrator explicit",
    "settings")
  expect(table.concat(r.notes, "\n"):find("dt changes nothing with explicit", 1, true), "a note of it: %s", r.notes[1])
end)

-- Time steps: one degree of freedom under a load from t = 0, u = F / k (1 - cos wt). Newmark's method is of
-- second order. ------------------------------------------------------------------------------------------------------

local E, rho, length, side, force = 206e9, 7850, 1, 0.05, 1000
local omega, stiffness = math.sqrt(3 * E / rho) / length, E * side ^ 2 / length -- k over a third of the mass
local period = 2 * math.pi / omega
local oscillator = hinge.scenario {
  parameters = { force = force + 0.5, dt = period / 80 },
  accuracy = { dt = { period / 80, period / 40, period / 20 } },
  run = function(p)
    local model = hinge.model { formulation = "conventional", elements_per_member = 1, displacement = "small" }
    local wall, tip = model:node { 0, 0, 0 }, model:node { length, 0, 0 }
    model:fix(wall, "all")
    model:fix(tip, "y,z,rx,ry,rz")
    model:member { wall, tip, section = hinge.section.solid { width = side, depth = side },
      material = hinge.material { E = E, density = rho } }
    model:load { node = tip, force = { p.force, 0, 0 } }
    local run = model:dynamic { dt = p.dt, duration = 2.3 * period }
    run:probe { node = tip, "ux", name = "ux" }
    run:finish()
    return { energy = { elastic = run.energy.elastic, work = run.energy.work }, ux = (run:displacement(tip)) }
  end,
}
case("the cost of an oscillator finds the second order of Newmark's method", function()
  local r = hinge.cost(oscillator, { within = 0.02, quantity = "ux#2" })
  equal(#r.settings, 3, "settings of the oscillator")
  for _, s in ipairs(r.settings) do
    local h, sum, peak = s.answers["ux#2"], 0, 2 * (force + 0.5) / stiffness
    for i, t in ipairs(h.x) do sum = sum + (h.y[i] - (force + 0.5) / stiffness * (1 - math.cos(omega * t))) ^ 2 end
    local true_error = math.sqrt(sum / #h.x) / peak
    near(s.error / true_error, 1, 0.08, ("reported over true error, %s"):format(s.label))
    equal(s.worst, "ux#2", "the answer that was asked for")
    equal(s.meets, s.error <= 0.02, "within")
    expect(s.seconds > 0 and s.ratio >= 1 and #s.times >= 3 and s.stages.solve and s.energy_error < 1e-6,
      "what %s took", s.label)
    expect(s.memory == nil or s.memory >= 0, "memory")
  end
  near(r.orders.dt.observed or 0, 2, 0.05, "order of Newmark's method")
  equal(r.orders.dt.theory, 2, "its order in theory")
  equal(r.quantities["ux#2"].state, "sound", "state of a history")
  equal(r.references[2].values.dt, period / 320, "the reference is finer than all")
  equal(r.references[1].values.dt, period / 160, "so is the other one")
  expect(r.cheapest and r.cheapest.meets and r.complete, "the cheapest within 2 %%")
  for _, s in ipairs(r.settings) do
    expect(not s.meets or s.seconds >= r.cheapest.seconds, "nothing cheaper is within 2 %%")
  end
  equal(find(r, { dt = period / 80 }).errors["energy.elastic"] ~= nil or r.quantities["energy.elastic"].state ~=
    "sound",
    true, "every answer is compared")
end)

-- Elements: a cantilever. The midpoint element lacks 1 / (4 n^2) of the bending deflection; asi-gauss is exact. -------

local I, shear = side ^ 4 / 12, 5 / 6 * side ^ 2 * E / 2.6
local bending, sheared = force * length ^ 3 / (3 * E * I), force * length / shear
local cantilever = hinge.scenario {
  parameters = { force = force + 0.5 },
  accuracy = { elements_per_member = { 2, 4, 8 }, formulation = { "conventional", "asi-gauss" } },
  run = function(p)
    local model = hinge.model { formulation = p.formulation, elements_per_member = p.elements_per_member,
      displacement = "small" }
    local wall, tip = model:node { 0, 0, 0 }, model:node { length, 0, 0 }
    model:fix(wall, "all")
    model:member { wall, tip, section = hinge.section.solid { width = side, depth = side },
      material = hinge.material { E = E, nu = 0.3 } }
    model:load { node = tip, force = { 0, 0, -p.force } }
    local _, _, uz = model:static { steps = 1 }:finish():displacement(tip)
    return { uz = uz }
  end,
}
case("the cost of a cantilever finds asi-gauss exact and the midpoint element of second order", function()
  local r = hinge.cost(cantilever, { within = 0.01, repeats = 2 })
  for _, s in ipairs(r.settings) do
    local n = s.values.elements_per_member
    local true_error = s.values.formulation == "asi-gauss" and 0 or bending / (4 * n * n) / (bending + sheared)
    near(s.errors.uz, true_error, 1e-7, "error, " .. s.label)
  end
  equal(r.references[2].values.formulation, "asi-gauss", "the reference's formulation")
  equal(r.references[2].values.elements_per_member, 32, "the reference's elements")
  equal(r.orders.elements_per_member.observed, math.huge, "asi-gauss is exact, whatever the elements")
  equal(r.cheapest.errors.uz <= 0.01, true, "cheapest within 1 %")
  equal(find(r, { formulation = "conventional", elements_per_member = 4 }).meets, false, "1.5 % is not within 1 %")
  local row = r.equal.formulation[1]
  near(row.error, 0.01, 1e-12, "formulations are compared at 1 %")
  equal(row.methods[1].value, "conventional", "the first formulation")
  local function conventional(n) return find(r, { formulation = "conventional", elements_per_member = n }) end
  if conventional(4).seconds < conventional(8).seconds then -- which noise may turn round
    equal(row.methods[1].settings[1].values.elements_per_member, 4, "1 % lies between 4")
    equal(row.methods[1].settings[2].values.elements_per_member, 8, "and 8 conventional elements")
  end
  -- asi-gauss is there with any number: the fastest one counts, which noise may choose where all take microseconds
  local fastest
  for _, s in ipairs(r.settings) do
    if s.values.formulation == "asi-gauss" and (not fastest or s.seconds < fastest.seconds) then fastest = s end
  end
  equal(row.methods[2].settings[1].values.elements_per_member, fastest.values.elements_per_member,
    "the fastest asi-gauss")
  local shorter = support.smallest_of(row.methods[1].ratio, row.methods[2].ratio)
  near(shorter, 1, 1e-12, "the shorter of both times is the measure")
  r = hinge.cost(cantilever, { parameters = { formulation = "conventional" }, repeats = 1, within = 0.01 })
  equal(#r.settings, 3, "a setting that is given is held")
  near(r.orders.elements_per_member.observed, 2, 1e-3, "order of the midpoint element")
  equal(hinge.cost(cantilever, { accuracy = { elements_per_member = { 2, 4 } }, parameters = { formulation = "asi" },
    repeats = 1 }).settings[1].values.formulation, nil, "only what is varied is in a setting's values")
end)

-- What has no error ---------------------------------------------------------------------------------------------------

local function toy(run, accuracy)
  return hinge.scenario { parameters = { x = 0.3 }, accuracy = accuracy or { dt = { 0.1, 0.2 } }, run = run }
end
case("chaotic, diverging and changing answers have no error and are not compared", function()
  local r = hinge.cost(toy(function(p)
    local x = p.x
    for _ = 1, 200 do x = 3.9 * x * (1 - x) end
    return { chaos = x, steady = p.x + p.dt ^ 2 / 100 }
  end, { dt = { 0.1, 0.2, 0.4 } }))
  equal(r.quantities.chaos.state, "chaotic", "a logistic map")
  expect(r.quantities.chaos.scatter > 0.05, "its scatter, %g", r.quantities.chaos.scatter)
  equal(r.quantities.steady.state, "sound", "what does not hang on it")
  equal(r.settings[1].errors.chaos, nil, "it has no error")
  equal(r.settings[1].worst, "steady", "and no setting is compared by it")
  near(r.orders.dt.observed, 2, 1e-6, "order in dt")
  r = hinge.cost(toy(function(p)
    local x = p.x
    for _ = 1, 200 do x = 3.9 * x * (1 - x) end
    return { chaos = x }
  end))
  expect(r.cheapest == nil and #r.front == 0 and r.settings[1].error == nil, "only chaos: neither front nor cheapest")
  r = hinge.cost(toy(function(p)
    return { grows = 1 / p.dt, clock = os.clock(), fine = 2, [3] = { nested = { p.x } } }
  end))
  equal(r.quantities.grows.state, "unsettled", "what does not converge")
  near(r.quantities.grows.agreement, 0.5, 1e-12, "by how much its references differ")
  equal(r.quantities.clock.state, "moving", "what differs from run to run")
  equal(r.quantities["3.nested.1"].state, "sound", "names of what is nested")
end)

case("failed settings, wrong options, and settings that the script does not list", function()
  -- A setting that fails is said; so is a scenario whose settings all do.
  local r = hinge.cost(toy(function(p)
    return p.way == "bad" and error "no such way" or { v = 1 }
  end, { dt = { 1, 2 }, way = { "good", "bad" } }))
  expect(#r.settings == 2 and #r.failed == 2 and r.failed[1].failed:find "no such way", "settings that fail")
  refused("...hinge.cost: no setting has an answer: ...broken...", hinge.cost, toy(function() error "broken" end))
  refused("...hinge.cost: takes a scenario, made by hinge.scenario{...}, got 3", hinge.cost, 3)
  refused("...hinge.cost: the scenario has no setting to vary; ...", hinge.cost, hinge.scenario { run =
    function() end })
  refused("...unknown quantity 'sum.tp' (did you mean 'sum.tip'?)...", hinge.cost,
    toy(function() return { sum = { tip = 1 } } end), { quantity = "sum.tp" })
  refused("...field 'within' is -1; must be a number above 0", hinge.cost, toy(function() end), { within = -1 })
  refused("...unknown parameter 'y'...", hinge.cost, toy(function() end), { parameters = { y = 1 } })
  r = hinge.cost(hinge.scenario { parameters = { dt = 0.5, elements_per_member = 3, own = 7 },
    run = function(p) return { v = 1 + p.dt } end }, { repeats = 1 })
  equal(#r.settings, 9, "a ladder where the script gives none")
  expect(find(r, { dt = 2, elements_per_member = 12 }), "its coarsest steps and most elements")
  r = hinge.cost(toy(function(p) return { v = 1 + p.h ^ 3 } end, { h = { 0.1, 0.2, 0.4 } }), { finer = { h =
    "smaller" },
    orders = { h = 3 }, repeats = 1 })
  near(r.orders.h.observed, 3, 1e-6, "order in a number of the script's own")
  equal(r.orders.h.theory, 3, "its theory")
end)

-- Memory --------------------------------------------------------------------------------------------------------------

case("the memory of a setting is that of its own run", function()
  local r = hinge.cost(toy(function(p)
    local held = ("x"):rep(math.floor(4e6 / p.dt))
    return { v = #held * p.dt }
  end, { dt = { 0.1, 0.4 } }), { repeats = 1 })
  if r.settings[1].memory then
    near(find(r, { dt = 0.1 }).memory / 40e6, 2, 0.3, "40 MB that a run held twice, while they were made")
    near(find(r, { dt = 0.4 }).memory / 10e6, 2, 0.6, "10 MB, beside one that held more")
  end
end)

-- Budget, and going on ------------------------------------------------------------------------------------------------

-- With a clock that only these scenarios advance: what is chosen does not depend on the machine.
local core = require "hinge.core"
local clock, now = core.clock, 0
local processor = os.clock
core.clock = function() return now end
rawset(os, "clock", core.clock) -- the processor's time
local function wait(seconds) now = now + seconds end
local folder, calls = support.temporary_folder(), {}
case("a budget chooses the cheapest settings first, and a second call goes on", function()
  local slow = toy(function(p)
    calls[#calls + 1] = p.dt
    wait(0.02 / p.dt)
    return { v = 1 + p.dt ^ 2 / 10, list = { p.dt, 1, 2 } }
  end, { dt = { 0.0625, 0.125, 0.25, 0.5, 1 } })
  local r = hinge.cost(slow, { budget = 1, out = folder .. "/kept" })
  expect(r.elapsed <= 1, "a budget of 1 s: %.2f s", r.elapsed)
  equal(calls[1], 1, "the cheapest is first")
  expect(#r.settings >= 2 and r.references and not r.complete, "part of it: %d settings", #r.settings)
  local finest = 1
  for _, s in ipairs(r.settings) do finest = support.smallest_of(finest, s.values.dt) end
  equal(r.references[2].values.dt <= finest, true, "a reference no coarser than what was compared")
  local first, done = calls, #r.settings
  calls = {}
  r = hinge.cost(slow, { budget = 30, out = folder .. "/kept" })
  expect(r.complete and #r.settings == 5, "a second call goes on to the end: %d", #r.settings)
  for _, dt in ipairs(calls) do
    expect(dt ~= 1 and dt ~= 0.5 or #find(r, { dt = dt }).times >= 3, "dt %g is run again", dt)
  end
  expect(done >= 2 and #first >= 2, "settings of the first call")
  support.write(folder .. "/kept/finished.lua", support.read(folder .. "/kept/finished.lua")
    .. "\n{[\"key\"]=\"cut sho")
  calls = {}
  local again = hinge.cost(slow, { out = folder .. "/kept" })
  equal(#calls, 0, "runs of a third call")
  for _, s in ipairs(again.settings) do
    local before = find(r, s.values)
    expect(s.error == before.error and s.seconds == before.seconds and s.errors.list == before.errors.list,
      "the same: %s", s.label)
  end
  calls = {}
  hinge.cost(slow, { out = folder .. "/kept", parameters = { x = 0.4 }, repeats = 1 })
  expect(#calls >= 7, "other parameters are run: %d", #calls)
  core.clock = clock
  rawset(os, "clock", processor)
end)

case("a run longer than the budget ends with it", function()
  local start = clock()
  refused("...hinge.cost: the budget ended before the first setting was finished; ...", hinge.cost, hinge.scenario {
    parameters = { force = 1.5 }, accuracy = { dt = { 1e-6, 2e-6 } },
    run = function(p)
      local model = hinge.model()
      local wall, tip = model:node { 0, 0, 0 }, model:node { 1, 0, 0 }
      model:fix(wall)
      model:member { wall, tip, section = hinge.section.solid { width = side, depth = side },
        material = hinge.material { E = E, density = rho } }
      model:dynamic { dt = p.dt, duration = 1000 }:finish()
    end,
  }, { budget = 0.2 })
  expect(clock() - start < 0.5, "a run that is longer than the budget ends with it")
end)

-- The program ---------------------------------------------------------------------------------------------------------

local program = support.quote(arg[1] .. "/hinge")
local script = folder .. "/script.lua"
local text = [[
return hinge.scenario {
  parameters = { x = 0.3, mark = "]] .. folder .. [[/ran" },
  cases = { far = { x = 3.5 } },
  accuracy = { dt = { 0.1, 0.2, 0.4 }, way = { "one", "two" } },
  run = function(p)
    local file = io.open(p.mark, "a")
    file:write "."
    file:close()
    print "not seen"
    return { v = p.x + (p.way == "two" and 2 or 1) * p.dt ^ 2 / 10 }
  end,
}
]]
support.write(script, "local hinge = require 'hinge'\n" .. text)
local command = ("%s cost %s --out %s/p"):format(program, support.quote(script), folder)
local _ -- a result that is not looked at
case("hinge cost prints its tables and writes cost.csv and summary.json", function()
  local status, printed, complaint = support.run(command .. " --within 5% --budget 60s")
  equal(status, 0, "status: " .. complaint)
  for _, part in ipairs { "6 settings", "Error of each answer", "Order of convergence", "Time at equal error",
    "dt      2.00       2", "reference: dt 25 ms, one; a coarser one (dt 50 ms, one) agrees",
    "written to " .. folder .. "/p" } do
    expect(support.has(printed, part), "hinge cost does not say '%s':\n%s", part, printed)
  end
  expect(not printed:find "not seen" and complaint:find "^cost %[",
    "what the script prints is not shown, progress is: %s", complaint)
  local summary = support.json(support.read(folder .. "/p/summary.json") or "{}")
  equal(#(summary.settings or {}), 6, "settings in summary.json")
  expect(summary.complete == true and summary.quantities.v.state == "sound" and summary.orders.dt.theory == 2
    and #summary.front >= 1, "summary.json")
  local csv = support.read(folder .. "/p/cost.csv") or ""
  equal(csv:match "^[^\n]*",
    "dt,way,error,low,high,worst,seconds,ratio,timings,outside_seconds,memory_bytes,energy_error,front,within,failed,"
      .. "value of v,difference of v,error of v,low of v,high of v",
    "head of cost.csv")
  equal(select(2, csv:gsub("\n", "")), 7, "lines of cost.csv")
end)

case("hinge cost with many settings, a second call, held settings and wrong arguments", function()
  -- Many settings and many answers: tables of twelve settings, no wider than the terminal (120 columns in a pipe).
  support.write(folder .. "/wide.lua", [[
local hinge = require "hinge"
return hinge.scenario {
  accuracy = { dt = { 0.1, 0.2, 0.3, 0.4 }, way = { "a", "b", "c", "d" } },
  run = function(p)
    local r = {}
    for i = 1, 30 do r[("an_answer_%d"):format(i)] = 1 + i * p.dt ^ 2 / 10 end
    return r
  end,
}
]])
  local status, printed, complaint = support.run(("%s cost %s --out %s/wide --budget 60s"):format(program,
    support.quote(folder .. "/wide.lua"), folder))
  equal(status, 0, "status of many settings: " .. complaint)
  local errors_of = printed:match "\nError of each answer.-\n\n" or ""
  expect(errors_of:find "; %d+ more answers in cost.csv\n", "the answers left out are not told:\n%s", printed)
  equal(select(2, errors_of:gsub("\n  %d+ ", "")), 12, "settings in the table of errors")
  expect(printed:find("16 settings", 1, true) and printed:find("the best 12, 4 more in cost.csv", 1, true),
    "the settings left out are not told:\n%s", printed)
  local widest = 0
  for line in errors_of:gmatch "\n(  [^\n]*)" do widest = support.largest_of(widest, #line) end
  expect(widest > 60 and widest <= 120, "the table of errors is %d columns wide", widest)
  equal(select(2, support.read(folder .. "/wide/cost.csv"):gsub("\n", "")), 17, "lines of cost.csv, many settings")
  if support.is_there(arg[1] .. "/libhinge_output.so") then
    expect((support.read(folder .. "/p/cost.png") or ""):find "^\137PNG", "cost.png")
  end
  local function runs() return #support.read(folder .. "/ran") end
  local before = runs()
  equal(support.run(command .. " --within 5%"), 0, "a second call")
  equal(runs(), before, "runs of a second call")
  support.write(script, "local hinge = require 'hinge' -- changed\n" .. text)
  support.run(command .. " --within 5%")
  expect(runs() > before, "a script that has changed is run again")
  expect(select(2, support.run(command .. " --case far way=one")):find "3 settings", "a case, a setting held")
  -- By itself it writes to a folder that tells the settings that are held.
  local elsewhere = ("cd %s && %s cost %s --within 5%% "):format(support.quote(folder), program, support.quote(script))
  for arguments, wanted in pairs { ["way=one"] = "-cost-way=one", ["x=0.25 way=two"] = "-cost-way=two-x=0.25" } do
    status, printed, complaint = support.run(elsewhere .. arguments)
    wanted = "out/" .. script:match "([^/]*)%.lua$" .. wanted
    expect(status == 0 and printed:find("written to " .. wanted .. "\n", 1, true)
      and support.is_there(folder .. "/" .. wanted .. "/summary.json"),
      "folder of %s: %s%s", arguments, printed, complaint)
  end
  for arguments, message in pairs {
    [" --within much"] = "hinge: --within much: must be a part above 0 and below 1, such as 2% or 0.02\n",
    [" --budget 3x"] = "hinge: --budget 3x: must be a time above 0, such as 60s, 5min or 1h\n",
    [" --quantity w"] = "...hinge.cost: quantity: unknown quantity 'w'; there are v\n",
    [" --case near"] = "...unknown case 'near'...",
  } do
    status, _, complaint = support.run(command .. arguments)
    expect(status == 2 and support.says(complaint:gsub("^cost[^\n]*\n", ""), message), "cost%s: %s %s", arguments,
      status, complaint)
  end
end)

case("hinge cost in the sandbox, and without a scenario", function()
  support.write(folder .. "/confined.lua", [[
local hinge = require "hinge"
local r = hinge.cost(hinge.scenario { accuracy = { dt = { 1, 2, 4 } },
  run = function(p) return { v = 900 + p.dt ^ 2 } end })
print(("order %.2f"):format(r.orders.dt.observed))
]])
  local status, printed, complaint = support.run(("%s run --sandbox %s/confined.lua --out %s/c")
    :format(program, folder, folder))
  expect(status == 0 and printed:find "order 2.00", "in the sandbox: %s %s %s", status, printed, complaint)
  support.write(folder .. "/plain.lua", "return 1")
  status, _, complaint = support.run(("%s cost %s/plain.lua --out %s/q"):format(program, folder, folder))
  expect(status == 2 and complaint:find "it does not return a hinge.scenario", "plain statements: %s", complaint)
end)

checks.done()
