-- What hinge study prints of its cases: results first, what is the same in all cases in a footer; and a fragility curve
-- from three listed values, or why there is none.
--
-- Run: lua5.4 tests/script/study/study_table_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
require "hinge"
local core = require "hinge.core"
local fit = require "hinge.study.fit"
local pictures = require "hinge.study.pictures"
local tables = require "hinge.study.table"
local checks = support.checks "study_table"
local case, expect, equal, near = checks.case, checks.expect, checks.equal, checks.near

-- The table -----------------------------------------------------------------------------------------------------------

local function one_case(number, speed, results)
  return { number = number, parameters = { speed = speed, mass = 12000 }, results = results, verdict = "completed" }
end
local of = { varied = { "speed", "mass" }, cases = {
  one_case(1, 90, { sway = 0.1, floors = 10, lost = false }), one_case(2, 110, { sway = 0.2, floors = 10, lost =
    true }) } }
local _ -- what is not looked at
local lines, left_out, footer = tables.lines(of, 80)
case("the table of a study lines up its columns", function()
  equal(lines[1], "  number   lost  sway  speed", "results stand before what varied")
  equal(lines[3], "       2   true   0.2    110", "a row")
  equal(left_out, 0, "columns left out")
  equal(table.concat(footer, "\n"), "  the same in all 2 cases: floors 10, mass 12000, verdict completed", "the footer")
  of.cases[2].verdict, of.cases[2].results.floors = "failed", 10 + 1e-9
  lines, _, footer = tables.lines(of, 80)
  equal(lines[1], "  number  floors   lost  sway  speed    verdict", "a verdict and a ninth digit that differ")
  equal(footer[1], "  the same in all 2 cases: mass 12000", "what is left of the footer")
end)

case("a table too wide for the terminal names what it leaves out", function()
  -- no room for all: the varied keep theirs, up to half, and results take the rest
  for i = 1, 30 do
    for k, c in ipairs(of.cases) do c.results[("z_result_%02d"):format(i)] = i + k end
  end
  lines, left_out = tables.lines(of, 60)
  for i, line in ipairs(lines) do expect(#line <= 60, "line %d is %d columns wide", i, #line) end
  expect(lines[1]:find "lost.*sway.*speed.*verdict" and left_out >= 27, "a narrow table: %s, %d left out", lines[1],
    left_out)
  local long = {}
  for i = 1, 30 do long[i] = { name = "constant_" .. i, texts = { "", "1" } } end
  for i, line in ipairs(tables.footer(long, 5, 60)) do expect(#line <= 60, "line %d of the footer: %d", i, #line) end
  of.cases = { of.cases[1] }
  lines, _, footer = tables.lines(of, 200)
  expect(lines[1]:find "mass" and #footer == 0, "one case has no constants: %s", lines[1])
end)

-- Fragility -----------------------------------------------------------------------------------------------------------

-- Three values, three cases each: none, one and all of them are true. By symmetry of 0/3, 1.5/3, 3/3 the median would
-- be the middle one; with 1/3 there it is above it.
local x, y = {}, {}
for i, ones in ipairs { 0, 1, 3 } do
  for k = 1, 3 do x[#x + 1], y[#y + 1] = 80 + 20 * i, k <= ones and 1 or 0 end
end
local curve = fit.fragility(x, y, true)
case("fragility of listed values is found, and a step or no trend gives a reason in its place", function()
  if expect(curve, "a curve from three values") then
    expect(curve.median > 120 and curve.median < 140, "its median: %g", curve.median)
    near(curve.at(120), 1 / 3, 0.03, "chance at the middle value, where a third is true")
  end
  local function why(given_x, given_y) return select(2, fit.fragility(given_x, given_y, true)) or "a curve" end
  expect(why({ 100, 120, 140 }, { 0, 0, 1 }):find("changes between 120 and 140", 1, true), "a step: %s",
    why({ 100, 120, 140 }, { 0, 0, 1 }))
  expect(why({ 100, 120, 140 }, { 1, 1, 0 }):find("changes between 120 and 140", 1, true), "a step down")
  local flat = { 100, 100, 100, 120, 120, 120, 140, 140, 140 }
  expect(why(flat, { 0, 1, 0, 1, 0, 1, 0, 1, 0 }):find("no trend beyond chance", 1, true), "no trend: %s",
    why(flat, { 0, 1, 0, 1, 0, 1, 0, 1, 0 }))
end)

case("a study draws its fragility curves and notes why one is missing", function()
  -- As a study draws them: the names of its pictures, its curves and its notes.
  local draw_plot = core.draw_plot
  core.draw_plot = function() end
  local function drawn(values, outcomes)
    local study = { varied = { "speed" }, folder = ".", cases = {} }
    for i, value in ipairs(values) do
      study.cases[i] = { number = i, parameters = { speed = value }, results = { lost = outcomes[i] == 1 },
        verdict = "completed" }
    end
    return study, pictures.draw(study)
  end
  local study, names = drawn(x, y)
  equal(names[1], "chance_of_lost-speed.png", "picture of a curve from three listed values")
  equal(#study.fragility, 1, "curves")
  equal(#study.notes, 0, "notes beside a curve")
  for _, given in ipairs {
    { { 100, 120, 140 }, { 0, 0, 1 }, "the outcome changes between 120 and 140" },
    { { 100, 120, 140 }, { 0, 1, 0 }, "a curve takes 8 cases, and there are 3|no trend" },
    { { 100, 120 }, { 0, 1 }, "against speed: a curve takes 3 values, and there are 2" },
  } do
    study, names = drawn(given[1], given[2])
    local found = false
    for part in given[3]:gmatch "[^|]+" do found = found or (study.notes[1] or ""):find(part, 1, true) ~= nil end
    expect(found and #study.fragility == 0, "why not: %s", study.notes[1])
    equal(names[1], "lost-speed.png", "a picture all the same")
  end
  core.draw_plot = draw_plot
end)

checks.done()
