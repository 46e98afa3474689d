-- The picture of hinge cost has every setting with an error once, named: on a method's line, or faint beside it.
--
-- Run: lua5.4 tests/script/cost_picture_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "?.lua;" .. package.path
local support = require "support"
require "hinge"
local checks = support.checks "cost_picture"
local equal = checks.equal

local knobs = { { name = "dt", side = "finer", values = { 4, 2 } },
  { name = "elements_per_member", side = "finer", values = { 2, 4 } }, { name = "way", values = { "one", "two" } } }
local settings, drawn = {}, nil
for i, v in ipairs { { 4, 2, 3, 9 }, { 2, 2, 4, 9.5 }, { 4, 4, 5, 2 }, { 2, 4, 8, 1 } } do
  for k, way in ipairs { "one", "two" } do
    settings[#settings + 1] = { values = { dt = v[1], elements_per_member = v[2], way = way },
      seconds = v[3] * k, error = v[4] * k / 100 }
  end
  settings[2 * i].error = i == 4 and 0 or settings[2 * i].error -- exact
end
settings[#settings + 1] = { values = { dt = 1, elements_per_member = 2, way = "one" }, seconds = 1 } -- no error
require "hinge.cost.plot".draw({ knobs = knobs, settings = settings, front = {} },
  { plot = function(_, what) drawn = what end })
local seen, faint, named = {}, 0, 0
for _, s in ipairs(drawn.series) do
  named = named + (s.faint and s.name and 1 or 0)
  for i, label in ipairs(s.labels or {}) do
    local way = s.faint and ({ blue = "one", red = "two" })[s.colour] or (s.name or "?"):match "^%a+"
    seen[#seen + 1] = ("%s %s %g"):format(label, way, s.x[i])
    faint = faint + (s.faint and s.style == "points" and 1 or 0)
  end
end
table.sort(seen)
equal(table.concat(seen, "; "), "dt 2, 2 elements one 4; dt 2, 2 elements two 8; dt 2, 4 elements one 8; "
  .. "dt 2, 4 elements two 16; dt 4, 2 elements one 3; dt 4, 2 elements two 6; dt 4, 4 elements one 5; "
  .. "dt 4, 4 elements two 10", "points of cost.png")
equal(named, 1, "entries of the legend for faint points")
equal(faint, 2, "faint points: those that are slower and no better than another of their method")

checks.done()
