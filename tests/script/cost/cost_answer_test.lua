-- hinge cost gives an answer on any scene: an estimated error with its band, also where references differ or do not
-- fit; means and scatter where answers are chaotic; a budget that is kept by a clock of the test's own; the result in
-- words.
--
-- Run: lua5.4 tests/script/cost/cost_answer_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local hinge = require "hinge"
local core = require "hinge.core"
local headline = require "hinge.cost.headline"
local ladder = require "hinge.cost.ladder"
local words = require "hinge.cost.words"
local checks = support.checks "cost_answer"
local case, expect, equal, near = checks.case, checks.expect, checks.equal, checks.near

local function find(result, wanted)
  for _, s in ipairs(result.settings) do
    local same = true
    for name, value in pairs(wanted) do same = same and s.values[name] == value end
    if same then return s end
  end
  expect(false, "no such setting")
  return { errors = {}, estimates = {}, values = {}, answers = {}, means = {} }
end

-- Names of options ----------------------------------------------------------------------------------------------------

case("every option that cost varies is declared, and has its finer side", function()
  local declared = require "hinge.program.reference".page()
  for _, pattern in ipairs(ladder.named()) do
    local found = false
    for name in declared:gmatch "\n%- `([%w_]+)%??`: " do found = found or name:find(pattern) ~= nil end
    expect(found, "a rule of hinge cost is for '%s', and no call has such an option", pattern)
  end
  local inputs = ladder.inputs("here", { parameters = { dt = 0.01 }, accuracy = {} }, {}, {})
  equal(inputs[1] and inputs[1].side.finer, "smaller", "finer side of dt")
  equal(inputs[1] and inputs[1].values[3], 0.04, "its coarsest value, where the script has no list")
end)

-- Words ---------------------------------------------------------------------------------------------------------------

case("settings and errors are named in the words of an engineer", function()
  for value, wanted in pairs { [1e-5] = "10 us", [2.5e-6] = "2.5 us", [1e-3] = "1 ms", [0.9999999e-3] = "1 ms",
    [31.4159] = "31.42 s", [0.1] = "100 ms" } do
    equal(words.seconds(value), wanted, "a time in words")
  end
  for part, wanted in pairs { [0.03] = "3 %", [0.0251] = "2.6 %", [0.00163] = "0.17 %", [0.0999] = "10 %",
    [0.01004] = "1.01 %" } do
    equal(words.bound(part), wanted, "a bound is rounded up")
  end
  local three = { { name = "dt" }, { name = "elements_per_member" }, { name = "formulation" } }
  equal(words.setting(three, { dt = 1e-3, elements_per_member = 2, formulation = "asi" }),
    "dt 1 ms with two elements, asi", "a setting in words")
end)

-- Scenes with a clock of their own ------------------------------------------------------------------------------------

local clock, now = core.clock, 0
local processor = os.clock
core.clock = function() return now end
rawset(os, "clock", core.clock) -- the processor's time
local function scene(accuracy, f, seconds)
  return hinge.scenario { parameters = { x = 0.3 }, accuracy = accuracy, run = function(p)
    now = now + (seconds or 0.4) / p.dt
    return f(p)
  end }
end

case("answers that have not converged have an error by their order, and the first line says what it takes", function()
  -- References that differ by more than is accepted: of first order, 1 + dt. The error is known all the same.
  local r = hinge.cost(scene({ dt = { 0.2, 0.4, 0.8 } }, function(p) return { v = 1 + p.dt } end),
    { within = 0.15, orders = { dt = 1 }, repeats = 1 })
  equal(r.quantities.v.state, "sound", "references that differ by 4.8 %, 15 % accepted")
  local same = hinge.cost(scene({ dt = { 0.2, 0.4, 0.8 } }, function(p) return { v = 1 + p.dt } end),
    { within = 0.03, orders = { dt = 1 }, repeats = 1 })
  for _, s in ipairs(same.settings) do
    local e = s.estimates.v
    near(e.error, s.values.dt, 1e-7, "error of " .. s.label)
    near(e.difference, (s.values.dt - 0.05) / 1.05, 1e-9, "difference from the finest run of " .. s.label)
    expect(e.low <= s.values.dt and s.values.dt <= e.high and e.high - e.low > 0.05, "band of %s", s.label)
    expect(s.error and s.worst == "v" and not s.meets, "an error of %s", s.label)
  end
  local q = same.quantities.v
  equal(q.state, "unsettled", "3 % accepted")
  expect(q.by == "order" and math.abs(q.order - 1) < 1e-6 and math.abs(q.extrapolated - 1) < 1e-7
    and math.abs(q.value - 1.05) < 1e-12, "how it is known: %s %s %s", q.by, q.order, q.extrapolated)
  near(same.orders.dt.observed, 1, 1e-6, "order of what is not converged")
  expect(#same.front == 3, "settings on the front")
  -- the first line: 0.2 takes 2 s, its error is 20 % with a band of 1.25 times the rest of the series, 6.25 %; the
  -- references take 4 and 8 s. Each further refinement halves that
  equal(headline.lines(same)[1], "dt 200 ms is within 27 % in 2 s; 3 % would take about 64 s (dt 6.25 ms)",
    "first line where none is good enough")
  same.beyond = nil
  equal(headline.lines(same)[1], "dt 200 ms is within 27 % in 2 s; 3 % is not reached: the finest run "
    .. "(dt 50 ms, 8 s) is within 11.3 %", "the same without an order")
  local loose = hinge.cost(scene({ dt = { 0.2, 0.4, 0.8 } }, function(p) return { v = 1 + p.dt ^ 2 / 10 } end),
    { within = 0.01, repeats = 1 })
  equal(headline.lines(loose)[1], "dt 400 ms is within 1.7 % in 1 s; 1 % takes 2 s (dt 200 ms)", "first line")
end)

case("a chaotic answer has a mean and a scatter, and settings that cannot be told apart", function()
  -- Noise that differs where x changes by 1e-9, as from step to step.
  local function noise(n) -- the same for the same number, and else any
    local x = 0.1 + 0.8 * ((n * 0.7548776662) % 1)
    for _ = 1, 60 do x = 3.99 * x * (1 - x) end
    return x - 0.5
  end
  local seen = {}
  local chaos = scene({ dt = { 0.2, 0.4, 0.8 }, way = { "a", "b" } }, function(p)
    local v = 10 + (p.way == "b" and 5 or 0) + 0.6 * noise(math.floor(4000 / p.dt + 1e10 * p.x + 0.5))
    seen[#seen + 1] = { dt = p.dt, way = p.way, v = v }
    return { v = v, steady = 1 + p.dt ^ 2 / 100 }
  end)
  local r = hinge.cost(chaos, { within = 0.01, repeats = 2 })
  local q = r.quantities.v
  equal(q.state, "chaotic", "what scatters when a number changes by 1e-9")
  equal(r.quantities.steady.state, "sound", "what does not scatter")
  for _, s in ipairs(r.settings) do
    local values, step = {}, { [s.answers.v] = true }
    for _, run in ipairs(seen) do
      local own = run.way == s.values.way and run.dt == s.values.dt
      if own and not step[run.v] then step[run.v], values[#values + 1] = true, run.v end
    end
    table.insert(values, 1, s.answers.v)
    local sum, squares = 0, 0
    for _, v in ipairs(values) do sum = sum + v end
    for _, v in ipairs(values) do squares = squares + (v - sum / #values) ^ 2 end
    local m = s.means and s.means.v or {}
    equal(m.runs, 5, "runs of " .. s.label)
    equal(#values, 5, "different runs of " .. s.label)
    near(m.mean or 0, sum / #values, 1e-9, "mean of " .. s.label)
    near((m.scatter or 0) * (m.mean or 0), math.sqrt(squares / (#values - 1)), 1e-9, "scatter of " .. s.label)
    equal(m.apart, s.values.way == "b", "told apart from the finest: " .. s.label)
    expect(s.errors.v == nil and s.worst == "steady", "no error of what is chaotic: %s", s.label)
  end
  equal(#(q.alike or {}), 3, "settings that cannot be told apart")
  equal(q.standard, "dt 0.2, way a", "the finest, from which others are told apart")
  equal(headline.lines(r)[2], "not counted: v (chaotic)", "words beside a result that is sound")
  r = hinge.cost(chaos, { within = 0.01, repeats = 2, quantity = "v" })
  local line = headline.lines(r)[1]
  local m = find(r, { dt = 0.8, way = "a" }).means.v
  equal(line, ("v is chaotic: %.4g with a scatter of %.2g in 5 runs of dt 800 ms, a (500 ms each); this mean cannot be "
    .. "told apart from that of dt 200 ms, a (2 s), as 3 of 6 cannot"):format(m.mean, m.scatter * m.mean),
    "chaos in words")
end)

case("what differs from run to run of one setting is no chaos", function()
  -- what differs from run to run is no chaos, and its settings are not run again for it
  local count = 0
  local r = hinge.cost(scene({ dt = { 0.2, 0.4 } }, function()
    count = count + 1
    return { v = count }
  end), { repeats = 3 })
  equal(r.quantities.v.state, "moving", "a number that differs from run to run")
  equal(count, 2 * 3 + 2 + 3, "runs: two settings three times, two references, three changed ones")
  equal(headline.lines(r)[1], "no setting can be compared: every answer differs from run to run of the same setting",
    "words for it")
end)

-- what grows with each refinement has a lower bound
case("what grows with each refinement has a lower bound of its error", function()
  local r = hinge.cost(scene({ dt = { 0.2, 0.4 } }, function(p) return { v = 1 / p.dt } end), { repeats = 1 })
  local s = find(r, { dt = 0.2 })
  expect(s.above and s.high == math.huge and not s.meets and s.error >= 0.75, "an error above 75 %%: %s", s.error)
  equal(#r.front, 0, "lower bounds on the front")
  expect(headline.lines(r)[1]:find("no setting has a known error: v", 1, true), "words for it: %s",
    headline.lines(r)[1])
end)

case("a budget leaves out the settings that do not fit in it, and says so", function()
  -- A budget for runs of 0.4 / dt s each. Without room for references the settings tell their errors themselves.
  local ran = {}
  local function timed(p)
    ran[#ran + 1] = p.dt
    return { v = 1 + p.dt ^ 2 / 10 }
  end
  local steps = { dt = { 0.05, 0.1, 0.2, 0.4, 0.8 } }
  local start = now
  local r = hinge.cost(scene(steps, timed), { within = 0.01, budget = 12, repeats = 1 })
  expect(now - start <= 12, "a budget of 12 s: %g s", now - start)
  equal(ran[1], 0.8, "the cheapest first")
  expect(r.references and #r.left_out == 1 and not r.complete, "left out: %d", #r.left_out)
  equal(headline.left_out(r)[1], "left out because of the budget: 1 setting, dt 50 ms (about 8 s); with their "
    .. "references "
    .. "and checks they take about 80 s more", "left out, from measured times")
  equal(#r.settings, 4, "settings: two with references finer than they, and these references")
  equal(r.notes[1], "the budget left no time for references finer than all settings; the finest one is dt 0.1",
    "a note")
  start, ran = now, {}
  r = hinge.cost(scene({ dt = { 0.2, 0.4, 0.8 } }, timed), { within = 0.01, budget = 4.4, repeats = 1 })
  expect(now - start <= 4.4 and r.references == nil, "a budget without room for references: %g s", now - start)
  for _, one in ipairs(r.settings) do
    expect(one.error and one.high < math.huge, "an error of %s", one.label)
    local e = one.estimates.v
    expect(e and e.low <= one.values.dt ^ 2 / 10 and one.values.dt ^ 2 / 10 <= e.high, "its band")
  end
  equal(#r.settings, 3, "settings within 4.4 s")
  equal(r.quantities.v.by, "order", "what the error is known from")
  equal(headline.lines(r)[1], "dt 400 ms is within 2.1 % in 1 s; 1 % takes 2 s (dt 200 ms)", "without references")
end)

case("an earlier call's settings are compared too where the references are finer", function()
  -- What an earlier call has measured is compared, too, where the references are finer: cost 0.1 n / dt.
  local kept = support.temporary_folder() .. "/kept"
  local plane = hinge.scenario { parameters = { x = 0.3 }, accuracy = { dt = { 0.2, 0.4 }, elements = { 1, 2 } },
    run = function(p)
      now = now + 0.1 * p.elements / p.dt
      return { v = 1 + p.dt ^ 2 / 10 + 0.1 / p.elements ^ 2 }
    end }
  local r = hinge.cost(plane, { within = 0.01, budget = 1.3, repeats = 1, out = kept })
  expect(#r.settings == 3 and r.references == nil, "settings within 1.3 s: %d", #r.settings)
  local start = now
  r = hinge.cost(plane, { within = 0.01, budget = 6.5, repeats = 1, out = kept })
  expect(now - start <= 6.5 and #r.settings == 4 and r.references and not r.complete,
    "settings within 6.5 s: %d, %s, %s",
    #r.settings, r.references and r.references[2].label, now - start)
  for _, one in ipairs(r.settings) do
    near(one.estimates.v.error, one.values.dt ^ 2 / 10 + 0.1 / one.values.elements ^ 2, 1e-7, "error of " .. one.label)
  end
  core.clock = clock
  rawset(os, "clock", processor)
end)

case("a reference that fails, and answers that are no number, leave an honest first line", function()
  -- A reference that fails: the settings and the other one still show the order. No answer, and none that is finite.
  local function plain(accuracy, f) return hinge.scenario { parameters = { x = 1.5 }, accuracy = accuracy, run = f } end
  local r = hinge.cost(plain({ dt = { 0.1, 0.2, 0.4 } }, function(p)
    if p.dt < 0.04 then error("too short a step", 0) end
    return { v = 1 + p.dt ^ 2 }
  end), { repeats = 1, within = 0.001 })
  expect(r.references == nil and r.quantities.v.by == "order" and math.abs(r.quantities.v.extrapolated - 1) < 1e-6,
    "one reference alone: %s", r.quantities.v.by)
  r = hinge.cost(plain({ dt = { 0.1, 0.2 } }, function() return { word = "yes" } end), { repeats = 1 })
  equal(headline.lines(r)[1], "no setting can be compared: the scenario returns no number, and its runs have no probe",
    "words without an answer")
  r = hinge.cost(plain({ dt = { 0.1, 0.2 } }, function(p) return { v = p.dt < 0.03 and math.huge or 1 } end),
    { repeats = 1 })
  expect(r.quantities.v.by == "open" and not r.settings[1].meets, "what is not finite: %s", r.quantities.v.by)
  r = hinge.cost(plain({ elements = { 2, 4 } }, function(p) return { v = 1 + 1 / p.elements ^ 2 } end), { repeats = 1 })
  expect(headline.lines(r)[1]:find "^four elements are within ", "words: %s", headline.lines(r)[1])
end)

case("what changes with the time step and not with physical numbers is no chaos", function()
  -- An answer that jumps about by 0.4 % where dt changes by thousandths: that is discretisation, and has an error.
  local r = hinge.cost(hinge.scenario { parameters = { mass = 2.5 }, accuracy = { dt = { 1e-3, 2e-3, 4e-3 } },
    run = function(p) return { fall_mm = 800 * (1 + p.mass * 1e-6 + 0.004 * math.sin(1e6 * p.dt)) } end },
    { within = 0.001, repeats = 1 })
  local q = r.quantities.fall_mm
  expect(q.state == "unsettled" and q.scatter < 1e-6 and q.half > 1e-3, "state %s, scatter %s, error %s", q.state,
    q.scatter, q.half)
  expect(not table.concat(headline.lines(r)):find "chaotic", "words: %s", headline.lines(r)[1])
end)

case("where a bar comes to lie is chaotic, that it lies on the ground is not", function()
  local m
  -- A bar that strikes the ground and slides: where it comes to lie is chaotic, that it lies on the ground is not.
  local r = hinge.cost(hinge.scenario {
    parameters = { speed = 9.0 }, accuracy = { dt = { 2e-4, 4e-4 } },
    run = function(p)
      local model = hinge.model { elements_per_member = 2 }
      local a, b = model:node { -0.5, 0, 0.9 }, model:node { 0.5, 0, 1.2 }
      model:member { a, b, section = hinge.section.solid { width = 0.05, depth = 0.05 }, group = "bar",
        material = hinge.material { E = 2e9, density = 7850 } }
      model:velocity("bar", { 1, 0.3, -p.speed })
      model:gravity { 0, 0, -9.81 }
      model:ground { point = { 0, 0, 0 }, normal = { 0, 0, 1 }, friction = 0.3 }
      local x, _, z = model:dynamic { dt = p.dt, duration = 0.3 }:finish():displacement(a)
      return { x = x, z = z }
    end,
  }, { within = 0.004, repeats = 1 })
  equal(r.quantities.x.state, "chaotic", "where a bar comes to lie")
  equal(r.quantities.z.state, "sound", "that it lies on the ground")
  for _, one in ipairs(r.settings) do
    m = one.means and one.means.x or { runs = 0, scatter = 0 }
    expect(m.runs >= 3 and m.scatter > 1e-4 and m.scatter < 1, "scatter of %s: %g in %d runs", one.label, m.scatter,
      m.runs)
    expect(one.worst == "z" and one.error < 0.01, "error of %s: %s in %s", one.label, one.error, one.worst)
  end
end)

case("the warnings of a setting's run are kept", function()
  -- A bar in free flight that spins too fast for its step: the warning of its run is not lost.
  local r = hinge.cost(hinge.scenario { parameters = { spin = 60.5 }, accuracy = { dt = { 1e-3, 1e-4 } }, run =
    function(p)
    local model = hinge.model { elements_per_member = 2 }
    local a, b = model:node { 0, 0, 0 }, model:node { 1, 0, 0 }
    model:member { a, b, section = hinge.section.solid { width = 0.05, depth = 0.05 }, group = "bar",
      material = hinge.material { E = 206e9, density = 7850 } }
    model:velocity("bar", { 1, 0, 0 }, { 0, 0, p.spin })
    local run = model:dynamic { dt = p.dt, duration = 0.2 }:finish()
    return { x = (run:displacement(a)) }
  end }, { repeats = 1 })
  local coarse = find(r, { dt = 1e-3 })
  expect(#coarse.warnings > 0 and coarse.warnings[1]:find "spins", "warnings of a setting: %s", coarse.warnings[1])
  expect((headline.warnings(r)[1] or ""):find "^warnings in [12] of 2 settings, such as dt 1", "words: %s",
    headline.warnings(r)[1])
end)

case("settings that fail are named", function()
  -- Settings that fail: a line for each reason, with the nearest setting that has an answer.
  local r = hinge.cost(hinge.scenario { accuracy = { dt = { 0.1, 0.2, 0.4 }, way = { "a", "b" } }, run = function(p)
    if p.dt > 0.15 and p.way == "b" then error("too long a step", 0) end
    return { v = 1 + p.dt ^ 2 / 100 }
  end }, { repeats = 1 })
  equal(table.concat(headline.failures(r), "\n"), "no answer: dt 400 ms, b and 1 more: too long a step; "
    .. "the nearest setting with an answer is dt 100 ms, b", "settings that fail")
end)

checks.done()
