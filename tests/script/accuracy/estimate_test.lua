-- The estimator and the search of hinge run --within, on made-up sequences: errors by order and by changes, means of
-- chaotic answers, who broke, and settings that are chosen in a table of known answers.
--
-- Run: lua5.4 tests/script/accuracy/estimate_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
require "hinge"
local broken = require "hinge.accuracy.broken"
local estimate = require "hinge.accuracy.estimate"
local library = require "hinge.library.check"
local store = require "hinge.cost.store"
local Search = require "hinge.accuracy.search"
local statistics = require "hinge.accuracy.statistics"
local checks = support.checks "accuracy_estimate"
local case, expect, equal, near = checks.case, checks.expect, checks.equal, checks.near

local function powers(p, h)
  local answers = {}
  for i, size in ipairs(h) do answers[i] = 2 + 3 * size ^ p end
  return answers
end

-- Along one refinement: 2 + 3 h^p, whose exact value is 2 -------------------------------------------------------------

case("three values that show an order have the rest of the series and a quarter of it as their error", function()
  for _, p in ipairs { 1, 2 } do
    for _, h in ipairs { { 0.4, 0.2, 0.1 }, { 0.5, 0.3, 0.1 } } do
      local found = estimate.along(h, powers(p, h), p)
      equal(found.by, "order", "kind of order " .. p)
      near(found.order, p, 1e-6, "observed order")
      near(found.answer, 2, 1e-7, "extrapolated value, order " .. p)
      near(found.error, 1.25 * 3 * 0.1 ^ p, 1e-9, "error of order " .. p)
    end
  end
end)

case("an order below the theory's has a factor of 3, and of 2 where four values show it", function()
  near(estimate.along({ 0.4, 0.2, 0.1 }, powers(1, { 0.4, 0.2, 0.1 }), 2).error, 3 * 3 * 0.1, 1e-9, "seen once")
  near(estimate.along({ 0.8, 0.4, 0.2, 0.1 }, powers(1, { 0.8, 0.4, 0.2, 0.1 }), 2).error, 2 * 3 * 0.1, 1e-9, "twice")
  near(estimate.along({ 0.4, 0.2, 0.1 }, powers(1.6, { 0.4, 0.2, 0.1 }), 2).error, 1.25 * 3 * 0.1 ^ 1.6, 1e-9,
    "near the theory")
end)

case("an order beyond the theory, or below one half, is chance and not believed", function()
  for _, p in ipairs { 0.3, 2.6, 4 } do
    local h = { 0.4, 0.2, 0.1 }
    local found = estimate.along(h, powers(p, h), 2)
    equal(found.by, "change", "kind of order " .. p)
    local change = 3 * (0.2 ^ p - 0.1 ^ p)
    local least = p < 0.5 and 1.25 * change / (2 ^ 0.5 - 1) or change -- what is slow counts as of the order 0.5
    expect(found.error >= least * (1 - 1e-9), "order %g: an error of %g after a change of %g", p, found.error, change)
  end
end)

case("two values have Roache's factor of safety of 3", function()
  local found = estimate.along({ 0.2, 0.1 }, powers(2, { 0.2, 0.1 }), 2)
  equal(found.by, "change", "kind")
  near(found.error, 3 * 0.09, 1e-12, "3 d, in truth 0.03")
  near(estimate.along({ 0.2, 0.1 }, powers(1, { 0.2, 0.1 }), 1).error, 3 * 0.3, 1e-12, "3 d / (2 - 1), in truth 0.3")
end)

case("two values that agree by chance do not make a narrow band", function()
  near(estimate.along({ 4, 2, 1 }, { 102, 100, 100 }, 2).error, 1, 1e-12,
    "the change before, over 2")
  near(estimate.along({ 4, 2, 1 }, { 5, 5.6, 5.5 }, 2).error, 0.3, 1e-12, "a change that turns back")
end)

case("of four values on a line the first three must show an order as well", function()
  local h, lucky = { 8, 4, 2, 1 }, { 0.9328, 0.9642, 1.0081, 1.0162 }
  equal(estimate.along(h, lucky, 2).by, "order", "of the last three")
  local found = estimate.along(h, lucky, 2, 0, true)
  equal(found.by, "change", "twice")
  near(found.error, (1.0081 - 0.9642) / 2, 1e-9, "the change before, over 2")
  near(estimate.along(h, powers(2, h), 2, 0, true).order, 2, 1e-6, "an order that is there")
end)

case("what does not change is exact, what grows or is no number has no error", function()
  equal(estimate.along({ 4, 2, 1 }, { 5, 5, 5 }, 2).by, "exact", "what does not change")
  for by, answers in pairs { grows = { 5, 5.1, 5.3 }, open = { 5, 0 / 0, 5 } } do
    local found = estimate.along({ 4, 2, 1 }, answers, 2)
    expect(found.by == by and found.error == math.huge, "%s: %s, %s", by, found.by, found.error)
  end
  equal(estimate.along({ 1 }, { 5 }, 2).by, "open", "one value")
  equal(estimate.along({ 4, 2, 1 }, { 5, 5.1, 5.3 }, 2, 0.05).by, "change", "what grows within what is accepted")
end)

case("a history whose every point converges is extrapolated", function()
  local curves = {}
  for i, size in ipairs { 0.4, 0.2, 0.1 } do
    curves[i] = { x = { 0, 1, 2, 3 }, y = { 1, 2 + size ^ 2, 3 - size ^ 2, 4 + 2 * size ^ 2 } }
  end
  local found = estimate.along({ 0.4, 0.2, 0.1 }, curves, 2)
  equal(found.by, "order", "kind of a history")
  for i, y in ipairs { 1, 2, 3, 4 } do near(found.answer.y[i], y, 1e-9, "extrapolated history") end
end)

-- Scatter -------------------------------------------------------------------------------------------------------------

case("means of scattered answers are told apart by Welch's test, and have Student's band", function()
  local mean, deviation, runs = statistics.mean { 3, 4, 5 }
  expect(mean == 4 and runs == 3 and math.abs(deviation - 1) < 1e-12, "mean of 3, 4, 5: %g, %g, %g", mean, deviation,
    runs)
  near(statistics.band(1, 3), 4.303 / math.sqrt(3), 1e-3, "band of three values: t of two degrees of freedom")
  local function sample(m, s, n) return { mean = m, deviation = s, runs = n } end
  -- equal deviations s and n = 5: 8 degrees of freedom, t = 2.306, limit 2.306 s sqrt(2 / 5) = 1.458 s
  equal(statistics.apart(sample(10, 1, 5), sample(11.45, 1, 5)), false, "means within the limit")
  equal(statistics.apart(sample(10, 1, 5), sample(11.47, 1, 5)), true, "means beyond the limit")
  equal(statistics.apart(sample(10, 0, 5), sample(10, 0, 5)), false, "the same without scatter")
  local curve = statistics.mean { { x = { 0, 1 }, y = { 1, 2 } }, { x = { 0, 1 }, y = { 3, 6 } } }
  expect(curve.y[1] == 2 and curve.y[2] == 4, "mean of histories")
end)

case("a change that has grown less than a thousandfold, or that does not matter, is no chaos", function()
  equal(statistics.is_chaotic(3e-8, 0.02), false, "3e-8")
  equal(statistics.is_chaotic(2e-6, 1e-5), true, "2e-6 where 0.001 % is asked")
  equal(statistics.is_chaotic(0.004, 0.02), true, "0.4 % where 2 % is asked")
  equal(statistics.is_chaotic(0.0005, 0.02), false, "a fortieth of what is asked")
  equal(statistics.is_chaotic(0 / 0, 0.02), true, "what is not a number")
end)

-- Who broke -----------------------------------------------------------------------------------------------------------

case("members that broke in all, some and none of the runs are told apart", function()
  local function record(...) return { runs = { { members = 5, broken = { ... }, groups = { [2] = "columns" } } } } end
  local of = broken.of { record(2, 3), record(2), record(2, 5) }
  expect(of.runs == 3 and of.in_all == 1 and of.in_some == 2 and of.in_none == 2, "counts: %d, %d, %d", of.in_all,
    of.in_some, of.in_none)
  equal(broken.csv(of), 'member,group,broken,runs\n2,columns,3,3\n3,,1,3\n5,,1,3\n', "table")
  equal(broken.lines(of)[1], "broken in 3 of 3 runs: member 2", "line of those in all runs")
  equal(broken.lines(of)[2], "broken in some of 3 runs: members 3, 5 (broken.csv)", "line of those in some")
  equal(#broken.lines(broken.of { record() }), 0, "lines where nothing broke")
end)

case("a run that is given twice counts once, one that failed does not count, and one alone is not compared", function()
  local one = { runs = { { members = 3, broken = { 2 } } } }
  local of = broken.of { one, { failed = "at once", runs = { { members = 3, broken = {} } } }, one }
  expect(of.runs == 1 and of.in_all == 1 and of.in_some == 0, "counts: %d, %d, %d", of.runs, of.in_all, of.in_some)
  equal(table.concat(broken.lines(of), "\n"), "broken: member 2", "its line")
end)

case("what is kept of a run has all its numbers, also after a gap", function()
  local groups = { [1] = "a", [2] = "b", [4] = "c", [5] = "d", [9] = "e" }
  local kept = load("return " .. store.key(groups))()
  for number, group in pairs(groups) do equal(kept[number], group, "group of member " .. number) end
end)

-- The search, in a table ----------------------------------------------------------------------------------------------

-- A search for answers(dt, elements, vary), where dt is 2^-level and so is the length of elements; a run takes
-- 1 s at level 0 of both, twice that a refinement.
local function search(answers, within, options)
  options = options or {}
  local growth = options.growth or 1 -- exponent of the time over elements
  local made, spent = {}, 0
  local found
  local one
  one = Search.new {
    knobs = { { name = "dt", theory = 2, ratio = 2, least = -6, most = options.most or 6 },
      { name = "elements", theory = 2, ratio = 2, work = growth, least = 0, most = options.most or 6 } },
    corner = { dt = -2, elements = 0 }, within = within, least = options.least,
    most_runs = 20, economic = options.economic,
    names = function(record) return library.keys(record.answers) end,
    foretell = function(levels) return 2.0 ^ (levels.dt + growth * levels.elements) end,
    fits = function(seconds) return not options.budget or spent + seconds <= options.budget end,
    run = function(levels, vary)
      local seconds = 2.0 ^ (levels.dt + growth * levels.elements)
      spent = spent + seconds
      made[#made + 1] = { dt = levels.dt, elements = levels.elements, vary = vary }
      local a = answers(2.0 ^ -levels.dt, 2.0 ^ -levels.elements, vary)
      return type(a) == "table" and { answers = a, seconds = seconds, runs = {} } or { failed = a, seconds = seconds }
    end,
  }
  found = one:find()
  return found, made, one
end

local function smooth(dt, length) return { v = 10 * (1 + 0.02 * dt ^ 2 + 0.03 * length ^ 2) } end

case("the error that is told is above the true one, and what was asked is kept", function()
  for _, within in ipairs { 0.1, 0.05, 0.02, 0.01, 0.001 } do
    local found = search(smooth, within)
    local true_error = 0.02 * 4.0 ^ -found.chosen.dt + 0.03 * 4.0 ^ -found.chosen.elements
    local told = found.errors.v.total
    expect(found.reached and told <= within, "asked %g, told %g", within, told)
    expect(told >= true_error / (1 + true_error) * (1 - 1e-9), "asked %g: told %g, in truth %g", within, told,
      true_error)
  end
end)

case("asking costs at most four times the chosen run", function()
  for _, within in ipairs { 0.05, 0.01, 0.001 } do
    local found = search(smooth, within)
    expect(found.seconds <= 4.01 * found.own, "asked %g: %.3g times", within, found.seconds / found.own)
  end
end)

case("a script that is far too fine is made coarser, and a far too coarse one finer", function()
  local found = search(function(dt, length) return { v = 1 + 1e-5 * dt ^ 2 + 1e-5 * length ^ 2 } end, 0.02)
  equal(found.chosen.dt, -1, "steps of twice the length do")
  found = search(function(dt, length) return { v = 1 + 0.5 * dt ^ 2 + 1e-4 * length ^ 2 } end, 0.02)
  expect(found.reached and found.chosen.dt >= 2 and found.chosen.elements <= 1,
    "refined alone: dt level %d, elements %d", found.chosen.dt, found.chosen.elements)
end)

case("an answer that does not settle is not reached, and nothing is tried for ever", function()
  local found, made = search(function(dt, length) return { v = 1 + 0.1 * math.sin(1e6 * dt + 17 / length) } end, 0.01)
  expect(not found.reached and found.errors.v.total > 0.01 and #made < 15, "told %g after %d runs",
    found.errors.v.total, #made)
end)

case("errors of knobs add up, and so does what they do to each other at the chosen setting", function()
  local found = search(smooth, 0.05)
  local e = found.errors.v
  expect(e.parts.dt > 0 and e.parts.elements > 0 and e.total >= e.parts.dt + e.parts.elements, "%g from %g and %g",
    e.total, e.parts.dt, e.parts.elements)
  -- both ladders stay at one side of the corner: where both are fine the answer is 1 % more
  local function joined(dt, length)
    return { v = (1 + 0.001 * dt ^ 2 + 0.001 * length ^ 2) * (dt < 3 and length < 0.9 and 1.01 or 1) }
  end
  local together, _, one = search(joined, 0.05, { growth = 4 }) -- without a check
  e = together.errors.v
  near(one.ladders:interplay(together.chosen, "v"), 0.01, 2e-4, "what both do together")
  expect(e.total >= (e.parts.dt + e.parts.elements + e.interplay) * (1 - 1e-9) and e.interplay > 0.0098,
    "told %g, where %g is what both do together", e.total, e.interplay)
end)

case("a check that shows more than was told counts", function()
  -- elements finer than any ladder change the answer by 30 %
  local function later(dt, length) return { v = smooth(dt, length).v * (length < 0.3 and 1.3 or 1) } end
  local found = search(later, 0.99)
  local e = found.errors.v
  expect(found.checked and found.checked.elements > found.chosen.elements, "a check with more elements")
  near(e.shown, 0.93, 0.01, "three times the change, where the ladder did not expect it")
  expect(e.by_check and e.total >= 0.29, "told %g, where the check shows 30 %%", e.total)
end)

case("two numbers of elements that agree by chance are found out by the check", function()
  local function falls(dt, length) -- 4 elements as 2; with 8 and 16 the answer falls
    local of = { [0] = 284, 284, 266, 255, 250, 248, 247, 247, 247 }
    return { peak = of[math.floor(-math.log(length, 2) + 0.5)] * (1 + 1e-4 * dt) }
  end
  for _, within in ipairs { 0.02, 0.05, 0.1 } do
    local found = search(falls, within)
    local e = found.errors.peak
    local truth = falls(2.0 ^ -found.chosen.dt, 2.0 ^ -found.chosen.elements).peak / 247 - 1
    expect(found.reached and e.total >= truth and truth <= within, "asked %g: told %g, in truth %g", within, e.total,
      truth)
  end
end)

case("an answer that is small may be wrong by what does not matter", function()
  local function wiggles(dt, length)
    return { v = smooth(dt, length).v, small = 0.02 + 0.004 * math.sin(1e6 * dt + 17 / length) }
  end
  local found = search(wiggles, 0.02)
  expect(not found.reached and not (found.errors.small.total <= 0.02), "2 %% of a small answer")
  found = search(wiggles, 0.02, { least = { small = 0.1 } })
  expect(found.reached and found.errors.small.total <= 0.02 and found.errors.small.total * 0.1 / 0.02 >= 0.004,
    "a tenth does not matter: told %g", found.errors.small.total)
  expect(not search(wiggles, 0.02, { least = { small = 1e-4 } }).reached, "less than it wiggles")
end)

case("where coarse steps disturb a ladder, settings on a line tell the error of all", function()
  local function disturbed(dt, length)
    return { v = smooth(dt, length).v + (dt > 0.2 and 0.4 * math.sin(17 / length) or 0) }
  end
  local found, _, one = search(disturbed, 0.01, { most = 8 })
  local e = found.errors.v
  local truth = disturbed(2.0 ^ -found.chosen.dt, 2.0 ^ -found.chosen.elements).v / 10 - 1
  expect(not (e.parts.elements <= 0.01), "the ladder of elements alone: %g", e.parts.elements)
  expect(found.reached and found.line and not found.checked, "on a line, without a check")
  expect(e.total >= truth and truth <= 0.01, "told %g, in truth %g", e.total, truth)
  for i = 2, #found.line do
    for _, knob in ipairs(one.knobs) do
      equal(found.line[i][knob.name], found.line[i - 1][knob.name] + 1, "each is a level finer in all")
    end
  end
end)

case("settings on a line that agree by chance do not hide what a ladder shows", function()
  local function agrees(dt, length) -- the same on a line, and not beside it
    local level, apart = -math.log(dt, 2), -math.log(length, 2)
    return { v = 10 + (level ~= apart and 2 * math.sin(1e6 * dt + 17 / length) or 0) }
  end
  local found = search(agrees, 0.01)
  expect(found.chosen.dt >= 3 and found.errors.v.total > 1e-3, "dt level %d, told %g", found.chosen.dt,
    found.errors.v.total)
end)

case("a dear check is left out, an answer that does not settle ends its ladder", function()
  -- twice the elements take 16 times as long: the check does not fit into four times the chosen run
  local found = search(smooth, 0.2, { growth = 4 })
  expect(found.seconds <= 4.01 * found.own and not found.checked, "%.3g times", found.seconds / found.own)
  local restless, made, one = search(function(dt, length)
    return { v = 1 + 0.1 * math.sin(1e6 * dt) + 1e-4 * length ^ 2 }
  end, 0.01)
  equal(one.stuck.dt, "finest", "the reason")
  expect(#one.ladders:levels(one.knobs[1]) <= 4, "a ladder that does not settle is left")
  expect(#made <= 16 and not restless.reached, "%d runs", #made)
end)

case("a chaotic answer is a mean with a band, and one beside it has an error", function()
  local state = 7
  local function noise()
    state = (state * 48271) % 2147483647
    return state / 2147483647 - 0.5
  end
  local found, made, one = search(function(dt, length, vary)
    return { steady = smooth(dt, length).v, wild = 100 + 10 * noise() + 0 * vary }
  end, 0.05)
  expect(one.ladders.chaotic.wild and not one.ladders.chaotic.steady, "what is chaotic")
  local e = found.errors.wild
  expect(e.runs >= 5 and math.abs(e.mean - 100) <= e.band + 10 / 3 and e.band > 0, "mean %g, band %g of %d runs",
    e.mean, e.band, e.runs)
  expect(#made > 10, "runs: %d", #made)
end)

case("an answer that jumps at the coarsest step alone is no chaos", function()
  local found, _, one = search(function(dt, length, vary)
    return { v = smooth(dt, length).v * (dt > 3 and 1 + 0.01 * vary or 1 + 1e-10 * vary) }
  end, 0.02)
  expect(found.reached and not one.ladders.chaotic.v, "a jump of 1 %% at the coarsest step")
end)

case("a number that counts is wrong by one where it changes at all", function()
  local found = search(function(dt, length)
    return { v = smooth(dt, length).v, columns = length > 0.9 and 1011 or 1012 }
  end, 0.01)
  near(found.errors.columns.total, 1 / 1012, 1e-12, "columns: one")
end)

case("a coarse setting that fails is left behind, a budget ends the search", function()
  local found = search(function(dt, length) return dt > 1.5 and "no convergence" or smooth(dt, length) end, 0.05)
  expect(found and found.reached and found.chosen.dt >= 0, "chosen where dt above 1.5 fails")
  local short, made = search(smooth, 1e-6, { budget = 4 })
  expect(short and not short.reached and short.stuck, "with a budget of 4: %d runs", #made)
end)

checks.done()
