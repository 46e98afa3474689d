-- hinge.results: tables as text, Markdown, LaTeX and CSV compared whole; members and envelopes of a simple beam at
-- every station; which members and states are read; buckling lengths; plots.
--
-- Run: lua5.4 tests/script/results/results_tables_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local scenes = require "scenes"
local hinge = require "hinge"
local results = require "hinge.results"
local lengths = require "hinge.results.lengths"
local members = require "hinge.results.members"
local source = require "hinge.results.source"
local Table = require "hinge.results.table"
local checks = support.checks "tables of results"
local case, near, equal, expect = checks.case, checks.near, checks.equal, checks.expect
local joined = support.joined

local folder = support.temporary_folder()
require "hinge.core".own_output(folder, {}, true)
local steel = hinge.material { E = 210e9, nu = 0.3, density = 7850, yield_stress = 355e6 }
local heb = hinge.section.named "HEB 300"

-- Texts of tables -----------------------------------------------------------------------------------------------------

local Plain = Table.class "a table of tests"

local function some_rows()
  return Table.new(Plain, { title = "Title", notes = { "a note", "another" }, sort_keys = { hidden = true }, columns = {
    { key = "index", head = "no", kind = "whole" }, { key = "name", head = "name", kind = "text" },
    { key = "F", head = "force", kind = "force", place = "F_x", when = "F_when" },
    { key = "M", head = "moment", kind = "moment", when = "M_when" }, { key = "G", head = "rest", kind = "force" },
    { key = "u", head = "way", kind = "displacement" }, { key = "r", head = "part", kind = "number", decimals = 2 },
    { key = "more", head = "more", kind = "length", minor = true } }, rows = {
    { index = 1, name = "b_1", F = -12345, F_x = 0.5, F_when = 0.25, M = 1000, M_when = "A & B", G = 1e-4, u = 0.0123,
      r = 0.126, more = 2, hidden = 2 },
    { index = 2, name = "a|2", F = 500.4, F_x = 12, F_when = 1.5, M = -0.0, u = -2e-4, r = -0.001, hidden = 3 },
    { index = 3, F = 12345, F_when = "x", M = 0 / 0, G = -7, u = 0, r = 12, hidden = 3 } } })
end

case("a table as text, Markdown, LaTeX and CSV, whole: digits, places, times, units, remarks", function()
  -- digits: four for the largest number of a column, and two more than that of its kind for the others
  local found = some_rows()
  equal(tostring(found), [[
Title
  no  name     force, kN (at x, m)  moment, kN m  rest, kN  way, mm  part
   1  b_1   -12.35 at 0.50, 0.25 s  1.000, A & B    0.0000    12.30  0.13
   2  a|2     0.50 at 12.00, 1.5 s         0.000         -    -0.20  0.00
   3  -                   12.35, x           nan   -0.0070     0.00    12
a note
another]], "as text")
  equal(found:markdown { top = 2, sort = "name", columns = { "F", "name" } }, [[
| force, kN (at x, m) | name |
|---:|---|
| 0.50 at 12.00, 1.5 s | a\|2 |
| -12.35 at 0.50, 0.25 s | b_1 |

a note

another

1 row more
]], "Markdown")
  equal(found:latex { columns = { "name", "F", "M" }, units = "N, cm, ms" }, [[
\begin{tabular}{lrr}
  \hline
  name & force, N (at x, cm) & moment, N cm \\
  \hline
  b\_1 & $-12345$ at 50, 250 ms & 100000, A \& B \\
  a|2 & 500 at 1200, 1500 ms & 0 \\
  -- & 12345, x & nan \\
  \hline
\end{tabular}
% a note
% another
]], "LaTeX")
  found:csv("t.csv", { units = "kN, mm, cm", sort = "r" })
  equal((support.read(folder .. "/t.csv"):gsub("%-nan", "nan")), [[
"index","name","F (kN)","F_x (mm)","F_when (s)","M (kN mm)","M_when (s)","G (kN)","u (cm)","r","more (mm)"
3,,12.345,,"x",nan,,-0.007,0,12,
1,"b_1",-12.345,500,0.25,1000,"A & B",1e-07,1.23,0.126,2000
2,"a|2",0.5004,12000,1.5,-0,,,-0.02,-0.001,
]], "CSV: all columns, the largest part first")
  local function order(key) -- of equal rows the order stays; rows without a value are the last
    local list = {}
    for index in found:text({ sort = key, columns = { "index" } }):gmatch "\n +(%d)" do list[#list + 1] = index end
    return table.concat(list)
  end
  equal(joined { order "hidden", order "F", order "G", order "name", order "more", order() }, "231 132 312 213 123 123",
    "sorted")
  equal(#found.rows, 3, "the rows are as they were")
  found.rows[1].name = "z"
  equal(order "name", "213", "rows without a text are the last, behind z")
end)

-- Members -------------------------------------------------------------------------------------------------------------

-- A simple beam of L = 8 m with F upwards at its middle, and N at its end, in load cases, and a second beam beside it.
local L = 8
local function beams()
  local model, list = hinge.model { displacement = "small", plasticity = false }, {}
  for i = 1, 2 do
    local a, b = model:node { 0, 3 * i, 0 }, model:node { L, 3 * i, 0 }
    model:fix(a, "x,y,z,rx")
    model:fix(b, "y,z")
    list[i] = model:member { a, b, section = heb, material = steel, up = { 0, 0, 1 }, group = i == 1 and "A" or "B" }
    model:case("push"):load { node = b, force = { -4e3 * i, 0, 0 } }
    model:case("up"):load { member = list[i], force = { 0, 0, 10e3 * i }, at = 0.5 }
  end
  return model, list
end

case("smallest and largest resultants of members have their places, and equal ones the first place", function()
  local model = beams()
  local run = model:static { steps = 1, loads = { up = 1, push = 1 } }:finish()
  local found = results.of(model).members(run)
  for i, row in ipairs(found.rows) do
    local F = 10e3 * i
    equal(joined { row.index, row.group, row.length }, joined { i, i == 1 and "A" or "B", L }, "member")
    near(row.Mx_max, F * L / 4, 1, "M, N m")
    near(row.Mx_max_x, L / 2, 1e-5, "its place, m")
    near(row.Mx, row.Mx_max, 1e-9, "the larger of both")
    near(row.Qy_min, -F / 2, 1e-3, "Q, N")
    near(row.Qy_max, F / 2, 1e-3, "Q, N")
    near(row.N, -4e3 * i, 1e-3, "N")
    equal(joined { row.N_min_x, row.N_max_x }, "0 0", "equal ones: the first place")
  end
  equal(#results.members(run, { group = model:group "B" }).rows, 1, "a group needs no model")
  equal(found:text { columns = { "index", "N_min", "Mx_max" } }, [[
  member  N min, kN (at x, m)  Mx max, kN m (at x, m)
       1        -4.000 at 0.0          20.00 at 4.000
       2        -8.000 at 0.0          40.00 at 4.000]], "as text")
  local keys = {}
  for i, c in ipairs(found:all_columns()) do keys[i] = c.key .. (c.minor and "-" or "") end
  equal(table.concat(keys, " "), "index group N_min N_max Mx_min Mx_max My_min- My_max- Mz_min- Mz_max- Qx_min- "
    .. "Qx_max- Qy_min Qy_max remark-", "columns; those that are zero are minor")
  equal(joined { found:text({ sort = "Mx", columns = { "index" }, top = 1 }):match "\n +(%d)" }, "2", "sorted by Mx")
  -- widened by hand: a value that is more extreme by less than 1e-9 of it is none
  local row = members.row { index = 7, group = "g", length = 3 }
  local function at(x, of) return scenes.with({ x = x, N = 0, Mx = 0, My = 0, Mz = 0, Qx = 0, Qy = 0 }, of) end
  members.widen(row, { at(1, { N = 5, Mx = -5 }), at(2, { N = 5 * (1 + 5e-10), Mx = -5 * (1 + 5e-10) }) }, "one")
  members.widen(row, { at(0, { N = -5.5, Mx = 4 }), at(3, { N = 5 * (1 + 2e-9), Mx = -5 * (1 + 2e-9) }) }, "two")
  equal(joined { row.N_min, row.N_min_x, row.N_min_when, row.N_max_x, row.N_max_when, row.N, row.N_x, row.N_when },
    "-5.5 0 two 3 two -5.5 0 two", "N")
  equal(joined { row.Mx_min_x, row.Mx_min_when, row.Mx_max, row.Mx_max_x, row.Mx, row.Mx_x, row.Mx_when },
    "3 two 4 0 -5 3 two", "Mx")
end)

case("members that broke say so, in whole or in part, and the column of remarks stands where one has one", function()
  local model = hinge.model { displacement = "small", elements_per_member = 4 }
  for i = 1, 3 do
    local a, b = model:node { 0, 3 * i, 0 }, model:node { 2, 3 * i, 0 }
    model:fix { a, b }
    local m = model:member { a, b, section = heb, material = steel, elements = 4, group = "m" .. i }
    model:mass { node = b, mass = 10 }
    if i == 2 then model:remove { member = m, at = 0 } end
  end
  model:gravity { 0, 0, -9.81 }
  local run = model:dynamic { dt = 1e-4, duration = 1e-3 }:finish()
  local found = results.members(run, { model = model })
  equal(joined { found.rows[1].remark, found.rows[2].remark, found.rows[3].remark }, joined { nil, "broken", nil },
    "remarks")
  equal(found.rows[2].remark, "broken", "remark")
  equal(found.rows[1].remark, nil, "none")
  expect(found:text():find("remark\n", 1, true), "the column is last: %s", found:text())
  expect(not results.members(run, { members = { found.rows[1].member } }):text():find "remark", "no remark, no column")
end)

-- Envelopes -----------------------------------------------------------------------------------------------------------

case("the band of an envelope at each station is that of statics by hand, on both sides of a force", function()
  local model, list = beams()
  local cases = { { up = 1 }, { up = -1.5 }, { push = 2, up = 0.5 } }
  local all = {}
  for i, loads in ipairs(cases) do all[i] = model:static { steps = 1, loads = loads }:finish() end
  local found = results.envelope { all[1], all[2], all[3], model = model, parts = 4, names = { "a", "b", "c" } }
  equal(found.states, 3, "states")
  for i, row in ipairs(found.rows) do
    local F = 10e3 * i
    equal(#row.stations, 5, "stations")
    for k, station in ipairs(row.stations) do
      local x = (k - 1) * L / 4
      near(station.x, x, 1e-12, "place")
      -- factors of the force from -1.5 to 1; at the middle the shear force has both signs
      local M = F / 2 * (x <= L / 2 and x or L - x)
      near(station.Mx[1], -1.5 * M, 0.1, "Mx, low")
      near(station.Mx[2], M, 0.1, "Mx, high")
      near(station.Qy[1], (k <= 3 and -1.5 or -1) * F / 2, 0.1, "Qy, low")
      near(station.Qy[2], (k >= 3 and 1.5 or 1) * F / 2, 0.1, "Qy, high")
      near(station.N[1], -8e3 * i, 1e-3, "N, low")
      near(station.N[2], 0, 1e-3, "N, high")
    end
    equal(joined { row.Mx_min_when, row.Mx_max_when, row.N_min_when, row.N_max_when }, "b a c a", "which state")
  end
  -- the plot: one member after the other, with a gap and a line between them
  local function drawing(options)
    local drawn
    found:plot({ plot = function(_, plot) drawn = plot end }, "a.svg", options)
    return drawn
  end
  local function texts(plot)
    local band = plot.series[1]
    for i, side in ipairs { "low", "high" } do
      local edge = plot.series[i + 1]
      equal(joined(edge.x) .. joined(edge.y) .. edge.colour, joined(band.x) .. joined(band[side]) .. "blue", "an edge")
    end
    return joined(band.x), joined(band.low), joined(band.high)
  end
  local plot = drawing()
  local x, low, high = texts(plot)
  equal(x, "0 2 4 6 8 8 8 10 12 14 16", "x, m")
  local function rounded(text) return (text:gsub("%-?%d[%d.e-]*", function(v) return ("%g"):format(tonumber(
    ("%.2f"):format(tonumber(v)))) end):gsub("%-0 ", "0 "):gsub("%-0$", "0")) end
  equal(rounded(low), "0 -15 -30 -15 0 | 0 -30 -60 -30 0", "Mx, low, kN m")
  equal(rounded(high), "0 10 20 10 0 | 0 20 40 20 0", "high")
  equal(#plot.lines, 2, "lines")
  equal(joined { plot.lines[1].x, plot.lines[1].dashed, plot.lines[2].y, plot.lines[2].dashed }, "8 true 0 false",
    "where the second member begins, and the axis")
  equal(joined { plot.x_label, plot.y_label, plot.series[1].style, plot.series[1].name }, "x, m Mx, kN m band Mx",
    "labels")
  plot = drawing { members = { list[2], list[1] }, quantity = "N", units = "N, cm", title = "T" }
  x, low = texts(plot)
  equal(x, "0 200 400 600 800 800 800 1000 1200 1400 1600", "x, cm")
  equal(rounded(low), "-16000 -16000 -16000 -16000 -16000 | -8000 -8000 -8000 -8000 -8000", "in the order of the list")
  equal(joined { plot.title, plot.x_label, plot.y_label }, "T x, cm N, N", "labels")
  checks.refused("members[2] is 7; must be a member of this envelope", drawing, { members = { list[1], 7 } })
end)

-- What is read --------------------------------------------------------------------------------------------------------

case("groups and lists of members, names of states, and runs that failed", function()
  local model, list = beams()
  local run = model:static { steps = 2, loads = { up = 1.35, push = -0.5 } }
  local function indices(options)
    options.model = model
    local found = {}
    for i, m in ipairs(source.members("w", run, options)) do found[i] = m.index end
    return table.concat(found, " ")
  end
  equal(indices {}, "1 2", "all")
  equal(#source.members("w", run, {}), 2, "all of the run's own model")
  equal(indices { group = "B" }, "2", "a group")
  equal(indices { group = { "B", model:group "A", "B" } }, "2 1", "each once, in the order of the groups")
  equal(indices { members = { list[2] } }, "2", "a list")
  equal(source.state(run, "own"), "own", "a name that is given")
  equal(source.state(run), "factor 0", "before the first step")
  run:step()
  equal(source.state(run), "-0.25 push + 0.675 up", "in the order of names, with the load factor")
  run:finish()
  equal(source.state(model:static { steps = 1, loads = { up = 0 } }:finish()), "factor 1", "factors of 0 are left out")
  local moving = model:dynamic { dt = 1e-3, duration = 3e-3, loads = { up = 1 } }
  moving:step()
  equal(source.state(moving), 1e-3, "a time")
  equal(source.failed(run), nil, "it has not failed")
  moving:finish()
  local seen = {}
  local collector = { add = function(_, of, name) seen[#seen + 1] = ("%s %s"):format(of.index, name) end }
  local steps = model:dynamic { dt = 1e-3, duration = 7e-3, loads = { up = 1 } }
  source.collect("w", collector, { run, steps }, { "one", "two" }, 3)
  steps:finish()
  equal(table.concat(seen, ", "), "2 one, 0 two, 3 two, 6 two, 7 two", "what has ended; the start, thirds, the last")
  local torn = scenes.cantilever { model = { displacement = "small" }, length = 3, along = { 0, 0, 1 },
    force = { 1e9, 0, 0 }, member = { section = heb, material = steel } }
  local failed = torn:static { steps = 1 }:finish()
  if expect(failed.verdict == "failed", "it cannot carry its load: %s", failed.verdict) then
    equal(source.failed(failed, "x"), "the run x failed: " .. failed.reason, "a run that failed")
    equal(results.members(failed, { model = torn }).notes[1], ("the run %s failed: %s"):format(source.state(failed),
      failed.reason), "below its table")
    local envelope = results.envelope { model = torn }
    equal(envelope:add(failed, "y").notes[1], "the run y failed: " .. failed.reason, "of an envelope")
    local rated = results.utilisation(failed, { model = torn, standard = "AISC 360", names = { "z" } })
    equal(rated.notes[#rated.notes], "the run z failed: " .. failed.reason, "of a utilisation")
    equal(#rated.notes, 3, "below the others")
  end
end)

case("buckling lengths: factors times the member's length, own lengths, by group, and what is said", function()
  local group = { name = "B" }
  local member = { length = 5, index = 3, groups = function() return { { name = "A" }, group } end }
  for _, r in ipairs { { nil, "5 5 nil 1 1" }, { { kx = 2, Ly = 3, Lb = 4 }, "10 3 4 1 1" },
    { { ky = 0.7, Lx = 1, C1 = 1.3, Cb = 1.2 }, "1 3.5 nil 1.3 1.2" }, { { B = { kx = 3 }, C = { kx = 4 } },
    "15 5 nil 1 1" }, { { C = { kx = 4 } }, "5 5 nil 1 1" }, { {}, "5 5 nil 1 1" },
    { function(m) return { kx = m.index } end, "15 5 nil 1 1" }, { function() end, "5 5 nil 1 1" } } do
    local found = lengths.of("w", r[1], member)
    equal(joined { found.Lx, found.Ly, tostring(found.Lb), found.C1, found.Cb }, r[2], "lengths")
  end
  for _, r in ipairs { { { B = { kx = 1, Lx = 2 } }, "field 'lengths'.B: fields 'kx' and 'Lx' are both given" },
    { { ky = 1, Ly = 2 }, "fields 'ky' and 'Ly' are both given" },
    { function() return 3 end, "field 'lengths'(member 3): is 3; must be a table" },
    { { { kx = 1 } }, "has 1 = a table" }, { { B = 3 }, "has B = 3; must be" }, { { C1 = 5 }, "C1" },
    { { Cb = 0.9 }, "Cb" } } do
    checks.refused(r[2], lengths.of, "w", r[1], member)
  end
  local of_members = "buckling lengths are those of the members; "
  local given = "lateral torsional buckling where Lb is given"
  local none = "no lateral torsional buckling, since no Lb is given"
  equal(lengths.remark(nil), of_members .. none, "nothing given")
  equal(lengths.remark { kx = 1 }, none, "no Lb")
  equal(lengths.remark { Lb = 3 }, given, "Lb")
  equal(lengths.remark { B = { Lb = 3 } }, given, "Lb of a group")
  equal(lengths.remark { B = { kx = 3 } }, none, "a group without it")
  equal(lengths.remark(function() end), given, "a function")
end)

-- Utilisation ---------------------------------------------------------------------------------------------------------

case("an envelope is as far used as the worse of its runs, where the other sign is the larger one", function()
  local model = beams()
  local runs = {}
  for i, factor in ipairs { 1, -4 } do runs[i] = model:static { steps = 1, loads = { up = factor } }:finish() end
  for _, standard in ipairs { "EN 1993-1-1", "AISC 360" } do
    local options = { model = model, standard = standard }
    local bound = results.utilisation(results.envelope { runs[1], runs[2], model = model }, options)
    for i, row in ipairs(results.utilisation(runs[2], options).rows) do
      near(bound.rows[i].utilisation, row.utilisation, 1e-6, "of " .. standard)
    end
    equal(bound.states, 2, "states")
    checks.refused("'every' is 0", results.utilisation, runs[1], { model = model, standard = standard, every = 0 })
  end
end)

case("the table and the plot of utilisations: order, remarks, columns of each check, bars", function()
  local model = beams()
  local a, b = model:node { 0, 20, 0 }, model:node { 4, 20, 0 }
  model:fix(a)
  model:member { a, b, section = hinge.section.named "UPN 200", material = steel }
  local run = model:static { steps = 1, loads = { up = 3, push = 1 } }:finish()
  local found = results.utilisation(run, { model = model, standard = "EN 1993-1-1" })
  local one, two, none = table.unpack(found.rows)
  local M = 3 * 10e3 * L / 4
  local by_hand = M / (heb.Zx * 355e6) -- N is small, and there is no shear where M is largest but half of F
  expect(one.utilisation >= by_hand * 0.999 and two.utilisation > one.utilisation, "%g, %g of at least %g",
    one.utilisation, two.utilisation, by_hand)
  equal(none.utilisation, nil, "a channel")
  local lines = {}
  for line in found:text { columns = { "index", "utilisation", "check", "when", "remark" } }:gmatch "[^\n]+" do
    lines[#lines + 1] = line
  end
  expect(lines[2]:find "^ +2 " and lines[3]:find "^ +1 " and lines[4]:find "^ +3 +%- +%- +%- +not checked: its plates",
    "the largest first: %s", table.concat(lines, "\n"))
  expect(lines[2]:find(("%.3f  %s +1 push %%+ 3 up"):format(two.utilisation, two.check:gsub("%p", "%%%0"))),
    "its numbers: %s", lines[2])
  expect(support.has(found:text { columns = { "law", "slenderness" } }, ("%.3f"):format(two.law)), "three decimals: %s",
    found:text { columns = { "law", "slenderness" } })
  equal(lines[5], "EN 1993-1-1:2005, classes 1 and 2, annex B, of the resultants of the run", "the standard")
  equal(lines[6], lengths.remark(nil), "what is said of lengths")
  local keys, names = {}, {}
  for i, c in ipairs(found:all_columns()) do keys[i] = c.key .. (c.minor and "-" or "") end
  for name, value in pairs(two.checks) do
    names[#names + 1] = name .. "-"
    equal(two[name], value.value, "the field of a check")
  end
  table.sort(names)
  equal(table.concat(keys, " "), "index group joint- utilisation check x when law slenderness remark "
    .. table.concat(names, " "), "columns")
  equal(results.utilisation(run, { model = model, group = "A", standard = "AISC 360" }).notes[1],
    "AISC 360-16, LRFD, of the resultants of the run", "AISC")
  local drawn
  local job = { plot = function(_, plot) drawn = plot end }
  found:plot(job, "a.svg", { title = "T" })
  local bars = drawn.series[1]
  equal(joined(bars.x), joined { two.utilisation, one.utilisation }, "bars, the largest first")
  equal(table.concat(bars.y, ", "), "member 2 (B), member 1 (A)", "names")
  equal(table.concat(bars.labels, "; "), ("%.2f, %s; %.2f, %s"):format(two.utilisation, two.check, one.utilisation,
    one.check), "labels")
  equal(joined { drawn.x_label, drawn.title, bars.style, drawn.lines[1].x, drawn.x_range[1] },
    "utilisation, EN 1993-1-1 T bars 1 0", "the plot")
  near(drawn.x_range[2], 1.25 * support.largest_of(1, two.utilisation), 1e-12, "its range")
  local alike = results.utilisation(run, { model = model, members = { two.member, one.member }, standard = "AISC 360" })
  for _, row in ipairs(alike.rows) do row.utilisation = 0.5 end
  alike:plot(job, "a.svg")
  equal(table.concat(drawn.series[1].y, ", "), "member 1 (A), member 2 (B)", "equal ones in the order of the members")
  checks.refused("members[1] is ", results.members, run, { members = { a } }) -- a node
  found:plot(job, "a.svg", { top = 1 })
  equal(#drawn.series[1].x, 1, "the first one alone")
  checks.refused("takes no further argument, got also 3", found.plot, found, job, "a.svg", {}, 3)
  for _, standard in ipairs { "EN 1993-1-1", "AISC 360" } do -- the moment of the beam is largest in its middle
    local row = results.utilisation(run, { model = model, group = "B", standard = standard, lengths = { kx = 0.01,
      ky = 0.01 } }).rows[1]
    local name = standard == "AISC 360" and "H1-1" or "6.2.9 M"
    for key, check in pairs(row.checks) do
      if key == name or key == "6.41" then near(check.x, L / 2, 1e-5, ("%s: %s at x"):format(standard, key)) end
      equal(check.when, "1 push + 3 up", "its state")
    end
  end
end)

checks.done()
