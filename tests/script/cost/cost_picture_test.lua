-- The picture of hinge cost has every setting with an error once: on a method's line, or faint beside it. It names
-- those on the Pareto front alone. Where every answer is chaotic, it shows means and scatter.
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
  for i, v in ipairs { { 2e-5, 2, 3, 9 }, { 1e-5, 2, 4, 9.5 }, { 2e-5, 4, 5, 2 }, { 1e-5, 4, 8, 1 } } do
    for k, way in ipairs { "one", "two" } do
      settings[#settings + 1] = { values = { dt = v[1], elements_per_member = v[2], way = way },
        seconds = v[3] * k, error = v[4] * k / 100 }
    end
    settings[2 * i].error = i == 4 and 0 or settings[2 * i].error -- exact
  end
  settings[#settings + 1] = { values = { dt = 1, elements_per_member = 2, way = "one" }, seconds = 1 } -- no error
  settings[1].front, settings[7].front = true, true
  require "hinge.cost.plot".draw({ inputs = inputs, settings = settings, front = { settings[1], settings[7] } },
    { plot = function(_, what) drawn = what end })
  local seen, labels, faint, named = {}, {}, 0, 0
  for _, s in ipairs(drawn.series) do
    named = named + (s.faint and s.name and 1 or 0)
    for i, label in ipairs(s.labels or {}) do
      local way = s.faint and ({ blue = "one", red = "two" })[s.colour] or (s.name or "?"):match "^%a+"
      seen[#seen + 1] = ("%s %g"):format(way, s.x[i])
      labels[#labels + 1] = label ~= "" and label or nil
      faint = faint + (s.faint and s.style == "points" and 1 or 0)
    end
  end
  table.sort(seen)
  table.sort(labels)
  equal(table.concat(seen, "; "), "one 3; one 4; one 5; one 8; two 10; two 16; two 6; two 8", "points of cost.png")
  equal(table.concat(labels, "; "), "10 us, 4 elements; 20 us, 2 elements", "the front alone is named, with units")
  equal(named, 1, "entries of the legend for faint points")
  equal(faint, 2, "faint points: those that are slower and no better than another of their method")
end)

case("the picture of chaotic answers has means with bars", function()
  -- Two settings with alike means, a third one apart: bars about the means, and names of the alike ones.
  local chaotic, bars, points = {}, {}, {}
  for i, mean in ipairs { 10, 11, 20 } do
    chaotic[i] = { values = { dt = i * 1e-5, elements_per_member = 2, way = "one" }, seconds = i,
      means = { v = { mean = mean, scatter = 0.1, runs = 5, apart = i == 3 } } }
  end
  require "hinge.cost.plot".draw({ inputs = inputs, settings = chaotic, front = {},
    quantities = { v = { kind = "number", alike = { "a", "b" } } } }, { plot = function(_, what) drawn = what end })
  for _, s in ipairs(drawn.series) do
    for i, x in ipairs(s.style == "points" and s.x or {}) do
      points[#points + 1] = ("%g %g%s"):format(x, s.y[i], s.labels[i] ~= "" and " " .. s.labels[i] or "")
    end
    if s.style ~= "points" then bars[#bars + 1] = ("%g %.4g %.4g"):format(s.x[2], s.y[1], s.y[2]) end
  end
  table.sort(points)
  equal(table.concat(points, "; "), "1 10 10 us, 2 elements, one; 2 11 20 us, 2 elements, one; 3 20", "means")
  equal(table.concat(bars, "; "), "1 9 11; 2 9.9 12.1; 3 18 22", "bars of one standard deviation")
end)

checks.done()
