-- The picture of hinge cost has every setting with an error once, with its band, on the line of its method. It names
-- those on the Pareto front alone. Chaotic answers have panels with means and scatter.
--
-- Run: lua5.4 tests/script/cost/cost_picture_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
require "hinge"
local checks = support.checks "cost_picture"
local case, equal = checks.case, checks.equal

local inputs = { { name = "dt", side = "finer", values = { 2e-5, 1e-5 } },
  { name = "elements_per_member", side = "finer", values = { 2, 4 } }, { name = "way", values = { "one", "two" } } }
local settings, drawn = {}, nil
case("the picture of hinge cost has every setting with an error once", function()
  for _, v in ipairs { { 2e-5, 2, 3, 9 }, { 1e-5, 2, 4, 9.5 }, { 2e-5, 4, 5, 2 }, { 1e-5, 4, 8, 1 } } do
    for k, way in ipairs { "one", "two" } do
      settings[#settings + 1] = { values = { dt = v[1], elements_per_member = v[2], way = way },
        seconds = v[3] * k, error = v[4] * k / 100, low = v[4] * k / 200, high = v[4] * k / 50 }
    end
  end
  settings[8].error, settings[8].low, settings[8].high = 0, 0, 0 -- exact
  settings[#settings + 1] = { values = { dt = 1, elements_per_member = 2, way = "one" }, seconds = 1 } -- no error
  settings[#settings + 1] = { values = { dt = 1, elements_per_member = 2, way = "one" }, seconds = 2, error = 0.3,
    above = true, high = math.huge }
  settings[1].front, settings[7].front = true, true
  require "hinge.cost.plot".draw({ inputs = inputs, settings = settings, quantities = {}, within = 0.03 },
    { plot = function(_, what) drawn = what end })
  equal(#drawn.panels, 1, "panels")
  local seen, labels, looks, panel = {}, {}, {}, drawn.panels[1]
  for _, s in ipairs(panel.series) do
    looks[#looks + 1] = ("%s: %s %s%s"):format(s.name, s.colour, s.mark, s.dashed and " dashed" or "")
    for i, x in ipairs(s.x) do
      seen[#seen + 1] = ("%s %g %.3g [%.3g %.3g]"):format(s.name:match "^%a+", x, s.y[i], s.low[i], s.high[i])
      labels[#labels + 1] = s.labels[i] ~= "" and s.labels[i] or nil
    end
  end
  for _, list in ipairs { seen, labels, looks } do table.sort(list) end
  equal(table.concat(looks, "; "), "at least: grey triangle; one, 2 elements: blue circle; "
    .. "one, 4 elements: blue square; two, 2 elements: red circle dashed; "
    .. "two, 4 elements: red square dashed", "method by colour, elements by mark")
  equal(table.concat(seen, "; "), "at 2 30 [30 60]; one 3 9 [4.5 18]; one 4 9.5 [4.75 19]; one 5 2 [1 4]; "
    .. "one 8 1 [0.5 2]; two 10 4 [2 8]; two 16 0.1 [0.1 0.1]; two 6 18 [9 36]; two 8 19 [9.5 38]", "points and bars")
  equal(table.concat(labels, "; "), "1 s, 2 elements, one; 10 us, 4 elements, one; 20 us, 2 elements, one",
    "the front is named, and what has only a bound")
  equal(("%g %s"):format(panel.lines[1].y, panel.lines[1].name), "3 asked: 3 %", "the line of what was asked")
end)

case("the picture of chaotic answers has means with bars", function()
  -- Two settings with alike means, a third one apart: bars about the means, and the name of the cheapest alike one.
  local chaotic, points = {}, {}
  for i, mean in ipairs { 10, 11, 20 } do
    chaotic[i] = { values = { dt = i * 1e-5, elements_per_member = 2, way = "one" }, seconds = i, label = "s" .. i,
      means = { v = { mean = mean, scatter = 0.1, runs = 5, apart = i == 3 } } }
  end
  require "hinge.cost.plot".draw({ inputs = inputs, settings = chaotic, within = 0.01,
    quantities = { v = { kind = "number", alike = { "s1", "s2" }, standard = "s2" } } },
    { plot = function(_, what) drawn = what end })
  equal(#drawn.panels, 1, "no setting has an error: one panel")
  local panel = drawn.panels[1]
  for _, s in ipairs(panel.series) do
    for i, x in ipairs(s.x) do
      points[#points + 1] = ("%g: %.4g to %.4g to %.4g %s"):format(x, s.low[i], s.y[i], s.high[i], s.labels[i])
    end
  end
  equal(table.concat(points, "; "), "1: 9 to 10 to 11 10 us, 2 elements; 2: 9.9 to 11 to 12.1 ; 3: 18 to 20 to 22 ",
    "means and one standard deviation")
  equal(panel.lines[1].y, 11, "the mean of the finest")
end)

case("the picture of hinge run --within has every setting once, and names the front and the chosen one", function()
  local Ladders = require "hinge.accuracy.ladders"
  local knobs = { { name = "dt", theory = 2, ratio = 2, least = 0, most = 4 },
    { name = "elements", theory = 2, ratio = 2, least = 0, most = 3 } }
  local ladders = Ladders.new(knobs, { dt = 0, elements = 0 }, 0.01)
  local function keep(dt, elements, seconds, v, w, vary)
    local levels = { dt = dt, elements = elements }
    ladders:keep(levels, vary or 0, { levels = levels, seconds = seconds, answers = { v = v, w = w },
      runs = { { dt = 1e-3 / 2 ^ dt, steps = 5, elements = 20 * 2 ^ elements, members = 10 } } })
  end
  keep(0, 0, 1, 1.16, 5)
  keep(0, 1, 5, 1.15, 5)
  keep(1, 0, 2, 1.04, 5)
  keep(2, 0, 4, 1.01, 5)
  keep(1, 1, 3, 1.04, 7)
  for vary = 1, 2 do keep(1, 1, 3, 1.04, 7 + vary, vary) end
  ladders.chaotic = { w = true }
  local told = { asked = 0.02, estimated = 0.015, levels = { dt = 1, elements = 1 }, knobs = knobs,
    answers = { { name = "v", value = 1.04 }, { name = "w", value = 7, chaotic = true } },
    search = { ladders = ladders, names = { "v" } } }
  told.search.ladders.worst = Ladders.worst
  local of = require "hinge.accuracy.picture".of(told)
  require "hinge.cost.plot".draw(of, { plot = function(_, what) drawn = what end })
  local seen, means = {}, drawn.panels[2].series
  for _, s in ipairs(drawn.panels[1].series) do
    for i, x in ipairs(s.x) do seen[#seen + 1] = ("%s %g %s"):format(s.name, x, s.labels[i]) end
  end
  table.sort(seen)
  equal(table.concat(seen, "; "), "2 elements 1 1 ms, 2 elements; 2 elements 2 500 us, 2 elements; "
    .. "2 elements 4 ; 4 elements 3 chosen: 500 us, 4 elements; 4 elements 5 ", "settings")
  equal(("%g %g %g %s"):format(means[1].low[1], means[1].y[1], means[1].high[1], means[1].labels[1]),
    "7 8 9 chosen: 500 us, 4 elements", "mean and scatter of the chaotic answer")
end)

checks.done()
