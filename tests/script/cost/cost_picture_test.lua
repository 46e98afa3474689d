-- The picture of hinge cost has every setting with an error once, with its band, and a line through the front of each
-- method. It names those on the Pareto front, and the one of the first line. Chaotic answers have panels with means.
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

-- Points, labels, lines and legend of a panel as texts.
local function texts_of(panel)
  local points, labels, lines, legend = {}, {}, {}, {}
  for _, s in ipairs(panel.series) do
    local look = ("%s %s%s"):format(s.colour, s.mark or "line", s.dashed and " dashed" or "")
    if s.x[1] == false then legend[#legend + 1] = ("%s: %s"):format(s.name, look)
    elseif s.style == "line" then
      local at = {}
      for i, x in ipairs(s.x) do at[i] = ("%g %.3g"):format(x, s.y[i]) end
      lines[#lines + 1] = look .. " " .. table.concat(at, ", ")
    else
      for i, x in ipairs(s.x) do
        points[#points + 1] = ("%s %g: %.3g [%.3g %.3g]"):format(s.name or look:gsub(" dashed", ""), x, s.y[i],
          s.low[i], s.high[i])
        labels[#labels + 1] = s.labels and s.labels[i] ~= "" and ("%g: %s"):format(x, s.labels[i]) or nil
      end
    end
  end
  table.sort(points)
  table.sort(labels)
  return table.concat(points, "; "), table.concat(labels, "; "), table.concat(lines, "; "), table.concat(legend, "; ")
end

case("the picture of hinge cost has every setting with an error once", function()
  for _, v in ipairs { { 2e-5, 2, 3, 9 }, { 1e-5, 2, 4, 9.5 }, { 2e-5, 4, 5, 2 }, { 1e-5, 4, 8, 1 } } do
    for k, way in ipairs { "one", "two" } do
      settings[#settings + 1] = { values = { dt = v[1], elements_per_member = v[2], way = way },
        seconds = v[3] * k, error = v[4] * k / 100, low = v[4] * k / 200, high = v[4] * k / 50 }
    end
  end
  settings[7].below, settings[8].error, settings[8].low, settings[8].high = true, 0, 0, 0 -- up to 1 %; exact
  settings[#settings + 1] = { values = { dt = 1, elements_per_member = 2, way = "one" }, seconds = 1 } -- no error
  settings[#settings + 1] = { values = { dt = 1, elements_per_member = 2, way = "one" }, seconds = 2, error = 0.3,
    above = true, high = math.huge }
  settings[1].front = true -- the first line names the exact one
  require "hinge.cost.plot".draw({ inputs = inputs, settings = settings, quantities = {}, within = 0.03 },
    { plot = function(_, what) drawn = what end })
  equal(#drawn.panels, 1, "panels")
  local panel = drawn.panels[1]
  local points, labels, lines, legend = texts_of(panel)
  equal(points, "at least 2: 30 [30 60]; blue circle 3: 9 [4.5 18]; blue circle 4: 9.5 [4.75 19]; "
    .. "blue square 5: 2 [1 4]; blue square 8: 1 [1 2]; red open circle 6: 18 [9 36]; "
    .. "red open circle 8: 19 [9.5 38]; red open square 10: 4 [2 8]; red open square 16: 0.1 [0.1 0.1]",
    "methods by colour, elements by mark, and bars")
  equal(labels, "16: 10 us, 4 elements; 3: 20 us, 2 elements", "the front and the setting of the first line are named")
  equal(lines, "blue line 3 9, 5 2, 8 1; red line dashed 6 18, 10 4, 16 0.1", "the front of each method")
  equal(legend, "one: blue circle; two: red open circle dashed; 2 elements: grey circle; 4 elements: grey square",
    "legend")
  equal(panel.y_label, "error, % (exact: at 0.1; without a bar: at most)", "what is not to be seen")
  equal(("%g %s"):format(panel.lines[1].y, panel.lines[1].name), "3 asked: 3 %", "the line of what was asked")
end)

case("the picture of chaotic answers has means with bars", function()
  -- Two settings with alike means, a third one apart: bars about the means, and the name of the cheapest alike one.
  local chaotic = {}
  for i, mean in ipairs { 10, 11, 20 } do
    chaotic[i] = { values = { dt = i * 1e-5, elements_per_member = 2, way = "one" }, seconds = i, label = "s" .. i,
      means = { v = { mean = mean, scatter = 0.1, runs = 5, apart = i == 3 } } }
  end
  require "hinge.cost.plot".draw({ inputs = inputs, settings = chaotic, within = 0.01,
    quantities = { v = { kind = "number", alike = { "s1", "s2" }, standard = "s2" } } },
    { plot = function(_, what) drawn = what end })
  equal(#drawn.panels, 1, "no setting has an error: one panel")
  local points, labels = texts_of(drawn.panels[1])
  equal(points, "blue circle 1: 10 [9 11]; blue circle 2: 11 [9.9 12.1]; blue circle 3: 20 [18 22]",
    "means and one standard deviation")
  equal(labels, "1: 10 us, 2 elements", "the cheapest that is like the finest")
  equal(drawn.panels[1].lines[1].y, 11, "the mean of the finest")
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
  local points, labels, _, legend = texts_of(drawn.panels[1])
  equal(#points:gsub("[^;]", ""), 4, "five settings")
  equal(labels, "1: 1 ms, 2 elements; 2: 500 us, 2 elements; 3: chosen: 500 us, 4 elements", "names")
  equal(legend, "2 elements: grey circle; 4 elements: grey square", "legend")
  points, labels = texts_of(drawn.panels[2])
  equal(points .. " " .. labels, "blue square 3: 8 [7 9] 3: chosen: 500 us, 4 elements",
    "mean and scatter of the chaotic answer")
end)

checks.done()
