-- hinge.robustness: which members are columns, what stands above what, bays, spans and joints of each case, all against
-- a list by hand for a frame with unequal bays, divided members, a held mid-height and members that lean by 15 degrees;
-- Omega_N by hand for each beam; what is printed, written and drawn of rows that are given.
--
-- Run: lua5.4 tests/script/robustness/robustness_cases_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local hinge = require "hinge"
local demands = require "hinge.robustness.demands"
local geometry = require "hinge.robustness.geometry"
local Result = require "hinge.robustness.result"
local checks = support.checks "cases of robustness"
local case, near, equal, expect = checks.case, checks.near, checks.equal, checks.expect
local joined, with = support.joined, require "scenes".with

local E, fy, inf = 206e9, 325e6, math.huge
local steel = hinge.material { E = E, density = 7850, yield_stress = fy }
local beam_section = hinge.section.box { width = 0.15, depth = 0.3, thickness = 0.01 }
local post = hinge.section.box { width = 0.25, depth = 0.25, thickness = 0.012 }

-- A model by the places of nodes; a member by the places of its ends.
local function builder(shift)
  local model, nodes = hinge.model {}, {}
  local function at(x, y, z)
    local key = ("%g %g %g"):format(x, y, z)
    nodes[key] = nodes[key] or model:node { x + (shift and shift(key) or 0), y, z }
    return nodes[key]
  end
  return model, at, function(a, b, group, up)
    return model:member { at(table.unpack(a)), at(table.unpack(b)), section = group == "post" and post or beam_section,
      material = steel, group = group, up = up }
  end
end

-- The frame -----------------------------------------------------------------------------------------------------------

-- Columns at x = 0, 6, 13 and y = 0, 6.5, floors at 4 and 7 m. Beams are groups of their own.
local function frame(shift)
  local model, at, member = builder(shift)
  member({ 0, 0, 0 }, { 0, 0, 4 }, "post") -- 1: its foot is on no support
  member({ 6, 0, 1.5 }, { 6, 0, 4 }, "post") -- 2 and 3 are one column, divided
  member({ 6, 0, 0 }, { 6, 0, 1.5 }, "post")
  member({ 13, 0, 0 }, { 13, 0, 4 }, "post") -- 4
  member({ 0, 6.5, 4 }, { 0, 6.5, 1 }, "post") -- 5 and 6: from above; held sideways at 1 m
  member({ 0, 6.5, 1 }, { 0, 6.5, 0 }, "post")
  member({ 6, 6.5, 0 }, { 6, 6.5, 4 }, "post") -- 7
  member({ 13, 6.5, 0 }, { 13, 6.5, 2 }, "post") -- 8 and 9: two columns, since the place between them is held upright
  member({ 13, 6.5, 2 }, { 13, 6.5, 4 }, "post")
  for _, p in ipairs { { 0, 0 }, { 6, 0 }, { 13, 0 }, { 0, 6.5 }, { 6, 6.5 }, { 13, 6.5 } } do -- 10 to 15
    local lean = p[1] == 13 and p[2] == 0 and 0.8 or 0 -- 14.9 degrees
    member({ p[1], p[2], 4 }, { p[1] + lean, p[2], 7 }, "post")
  end
  member({ 13, 6.5, 4 }, { 13.81, 6.5, 7 }, "brace") -- 16: 15.1 degrees
  member({ 0, 0, 4 }, { 2, 0, 4 }, "A", { 0, 0, 1 }) -- 17 and 18: one beam with a beam across it at x = 2
  member({ 6, 0, 4 }, { 2, 0, 4 }, "A", { 0, 0, 1 })
  member({ 6, 0, 4 }, { 13, 0, 4 }, "B", { 0, 1, 0 }) -- 19: bent about the axis of I_y
  member({ 2, 0, 4 }, { 2, 6.5, 4 }, "C", { 0, 0.6, 0.8 }) -- 20: up leans less than 45 degrees
  member({ 0, 6.5, 4 }, { 2, 6.5, 4 }, "D", { 0, 0, 2 }) -- 21, 22
  member({ 2, 6.5, 4 }, { 6, 6.5, 4 }, "D", { 0, 0, 2 })
  member({ 6, 6.5, 4 }, { 13, 6.5, 4 }, "F", { 0, 0, 1 }) -- 23
  member({ 0, 0, 7 }, { 6, 0, 7 }, "H", { 0, 0, 1 }) -- 24
  member({ 6, 0, 4 }, { 0, 0, 5.6 }, "ramp", { 0, 0, 1 }) -- 25: 14.9 degrees, level; its other end hangs
  member({ 6, 0, 4 }, { 0, 0, 5.63 }, "steep", { 0, 0, 1 }) -- 26: 15.2 degrees
  for _, p in ipairs { { 6, 0 }, { 13, 0 }, { 0, 6.5 }, { 6, 6.5 }, { 13, 6.5 } } do model:fix(at(p[1], p[2], 0)) end
  model:fix(at(0, 6.5, 1), "x,y")
  model:fix(at(13, 6.5, 2), "y,z,rx")
  return model, at
end

-- members, x, y, z from and to, storey; in order of height, x and y
local columns = {
  { "1", 0, 0, 0, 4, 1 }, { "5 6", 0, 6.5, 0, 4, 1 }, { "2 3", 6, 0, 0, 4, 1 }, { "7", 6, 6.5, 0, 4, 1 },
  { "4", 13, 0, 0, 4, 1 }, { "8", 13, 6.5, 0, 2, 1 }, { "9", 13, 6.5, 2, 4, 2 }, { "10", 0, 0, 4, 7, 2 },
  { "13", 0, 6.5, 4, 7, 2 }, { "11", 6, 0, 4, 7, 2 }, { "14", 6, 6.5, 4, 7, 2 }, { "15", 13, 6.5, 4, 7, 3 },
  { "12", 13.8, 0, 4, 7, 2 },
}

case("columns, beams and storeys of a frame are those of a list by hand", function()
  local geo = geometry.read((frame()))
  equal(#geo.columns, #columns, "columns")
  equal(geo.storeys, 3, "storeys of the tallest stack")
  for i, c in ipairs(geo.columns) do
    local row = columns[i]
    equal(joined { joined(c.members), c.x, c.y, c.low.z, c.high.z, c.storey }, joined(row), "column " .. i)
    equal(c.name, ("x = %g m, y = %g m, z = %g to %g m"):format(table.unpack(row, 2, 5)), "its name")
    equal(c.group, "post", "its group")
  end
  local kinds, lengths = {}, {}
  for i = 16, 26 do
    kinds[#kinds + 1], lengths[#lengths + 1] = geo.members[i].kind, geo.beam_length[i] or 0
  end
  equal(joined(kinds), "other beam beam beam beam beam beam beam beam beam other", "kinds from member 16 on")
  equal(joined(lengths), joined { 0, 6, 6, 7, 6.5, 6, 6, 7, 6, math.sqrt(36 + 1.6 ^ 2), 0 }, "from column to column, m")
  local names = { lowest = "1 2 3 4 5 6 7", all = "1 2 3 4 5 6 7 8 9 10 11 12 13" } -- 7 stands on a support
  for which, wanted in pairs(names) do
    local found = {}
    for _, c in ipairs(geometry.cases("test", geo, "columns", which)) do
      for k, row in ipairs(columns) do
        if joined(c.members) == row[1] then
          found[#found + 1] = k
          local x = row[1] == "12" and 13 or row[2] -- the joint that is left is the foot of the leaning one
          equal(joined { c.x, c.y, c.z_low, c.z_high, c.storey }, joined { x, table.unpack(row, 3) }, "case " .. row[1])
          equal(c.name .. c.group, geo.columns[k].name .. "post", "its name and group")
        end
      end
    end
    equal(joined(found), wanted, "columns that go: " .. which)
  end
end)

-- members that go; x, y, z from, z to; joints as places; span; bays as { x from, to, y from, to, z from }
local cases = {
  { { 1 }, { 0, 0, 0, 4 }, "0 0 4", 6, { { -inf, 6, -inf, 6.5, 3.7 } } },
  { { 2, 3 }, { 6, 0, 0, 4 }, "6 0 4", 6, { { 0, 13, -inf, 6.5, 3.7 } } },
  -- the column above leans to 13.8 m, and stands on the joint itself
  { { 4 }, { 13, 0, 0, 4 }, "13 0 4", 6.5, { { 6, inf, -inf, 6.5, 3.7 } } },
  { { 7 }, { 6, 6.5, 0, 4 }, "6 6.5 4", 6, { { 0, 13, 0, inf, 3.7 } } },
  { { 9 }, { 13, 6.5, 2, 4 }, "13 6.5 4", 6.5, { { 6, inf, 0, inf, 3.7 } } },
  { { 5, 13 }, { 0, 6.5, 1, 7 }, "0 6.5 4, 0 6.5 1", 6, { { -inf, 6, 0, inf, 3.7 } } }, -- nothing is left at 7 m
  -- the bay of each ends at the joint of the other, on which a column of the next storey stands
  { { 2, 4 }, { 6, 0, 0, 4 }, "6 0 4, 13 0 4, 6 0 1.5", 6, { { 0, 13, -inf, 6.5, 3.7 }, { 6, inf, -inf, 6.5, 3.7 } } },
  { { 19 }, { 6, 0, 4, 4 }, "6 0 4, 13 0 4", 6, { { 0, 13, -inf, 6.5, 3.7 }, { 6, inf, -inf, 6.5, 3.7 } } },
}

case("joints, spans and bays of what goes are those of a list by hand", function()
  local geo = geometry.read((frame()))
  for _, r in ipairs(cases) do
    local name = "members " .. joined(r[1])
    local c = geometry.cases("test", geo, { r[1] }, "lowest")[1]
    equal(joined(c.members), joined(r[1]), name)
    equal(joined { c.x, c.y, c.z_low, c.z_high }, joined(r[2]), name .. ": place")
    local joints, bays = {}, {}
    for i, j in ipairs(c.joints) do joints[i] = joined { j.x, j.y, j.z } end
    equal(table.concat(joints, ", "), r[3], name .. ": joints")
    near(c.span, r[4], 1e-12, name .. ": span, m")
    for i, b in ipairs(c.bays) do bays[i] = joined { b.x[1], b.x[2], b.y[1], b.y[2], b.z } end
    for i, b in ipairs(r[5]) do equal(bays[i], joined(b), ("%s: bay %d"):format(name, i)) end
    equal(#bays, #r[5], name .. ": bays")
    local words = {}
    for i, index in ipairs(r[1]) do words[i] = "member " .. index end
    local heights = r[2][3] == r[2][4] and ("%g"):format(r[2][3]) or ("%g to %g"):format(r[2][3], r[2][4])
    equal(c.name, ("%s (x = %g m, y = %g m, z = %s m)"):format(table.concat(words, " and "), r[2][1], r[2][2],
      heights), "its name")
  end
  -- each side of a bay with its edge, and what is above it
  local c = geometry.cases("test", geo, { { 2, 3 } }, "lowest")[1]
  for _, p in ipairs { { 0, 0, 4, true }, { -0.001, 0, 4, false }, { 13, 6.5, 4, true }, { 13.001, 6, 4, false },
    { 13, 6.501, 4, false }, { 5, -20, 4, true }, { 5, 3, 3.71, true }, { 5, 3, 3.69, false }, { 5, 3, 30, true } } do
    equal(geometry.is_near(c, p[1], p[2], p[3]), p[4], "is near: " .. joined(p))
  end
  checks.refused({ "field 'remove': unknown group 'brase' (did you mean 'brace'?)",
    "A, B, C, D, F, H, brace, post, ramp, steep" }, geometry.cases, "test", geo, { "brase" }, "lowest")
  local alone = geometry.cases("test", geo, { "brace" }, "lowest")[1]
  equal(alone.name .. alone.group, "brace (x = 13 m, y = 6.5 m, z = 4 to 7 m)brace", "a group by its name")
end)

case("columns within 0.3 m of a line are on it, and the span is the distance in plan", function()
  local model, at, member = builder()
  for _, p in ipairs { { 3, 4 }, { 3.29, 9 }, { 7, 4.29 }, { -1, 4.31 }, { 3.31, 1 }, { 3, -7 }, { -9, 4 } } do
    member({ p[1], p[2], 0 }, { p[1], p[2], 3 }, "post")
    model:fix(at(p[1], p[2], 0))
  end
  member({ 3.2, 4.2, 3 }, { 3.2, 4.2, 6 }, "post") -- within 0.3 m: it stands above the first
  member({ 3, 4, 3 }, { 5, 4, 3 }, "A")
  member({ 2, 3.5, 3.31 }, { 2, 3.5, 6 }, "post") -- its foot is above the level by more than 0.3 m
  member({ 3, 3.6, 0 }, { 3, 3.6, 2.69 }, "post") -- and this one's head is below it
  local c = geometry.cases("test", geometry.read(model), { 1 }, "lowest")[1]
  near(c.span, math.sqrt(0.31 ^ 2 + 3 ^ 2), 1e-12, "span, m")
  equal(joined { c.bays[1].x[1], c.bays[1].x[2], c.bays[1].y[1], c.bays[1].y[2] }, "-9 7 -7 9", "the bay")
end)

case("another structure than before is told for each coordinate of each end", function()
  local geo = geometry.read((frame()))
  geometry.must_be_same("test", geo, (frame()))
  local function moved(far, key)
    return pcall(geometry.must_be_same, "test", geo, (frame(function(own) return own == key and far or 0 end)))
  end
  for _, key in ipairs { "0 0 5.63", "0 6.5 1", "13 6.5 0" } do
    equal(moved(5e-7, key), true, "5e-7 m at " .. key)
    equal(moved(-2e-6, key), false, "2e-6 m at " .. key)
    equal(moved(2e-6, key), false, "the other way")
  end
  for axis, name in ipairs { "x", "y", "z" } do
    local models = {}
    for i = 1, 2 do
      local model, at, member = builder()
      member({ 0, 0, 0 }, { 0, 0, 3 }, "post")
      local other = { 1, 2, 3 }
      other[axis] = other[axis] + (i - 1) * 1e-3
      model:member { at(0, 0, 0), model:node(other), section = post, material = steel }
      models[i] = model
    end
    equal(pcall(geometry.must_be_same, "test", geometry.read(models[1]), models[2]), false, name)
  end
end)

-- Omega_N -------------------------------------------------------------------------------------------------------------

case("the smallest ratio of allowed rotation to M_p L / (6 E I) is that of each beam in the bays by hand", function()
  local model = frame()
  local geo = geometry.read(model)
  local s = beam_section
  local strong, weak = s.Zx * fy / (6 * E * s.Ix), s.Zy * fy / (6 * E * s.Iy) -- rotation at yield for each metre
  -- groups in the bays of columns 2 and 3, which are those from x = 0 to 13 and y to 6.5
  local at_yield = { A = 6 * strong, B = 7 * weak, C = 6.5 * strong, D = 6 * strong, F = 7 * strong, H = 6 * strong,
    ramp = math.sqrt(36 + 1.6 ^ 2) * strong }
  local middle = geometry.cases("test", geo, { { 2, 3 } }, "lowest")[1]
  local corner = geometry.cases("test", geo, { { 1 } }, "lowest")[1] -- x to 6
  local function ratio(c, limit, capacity) return demands.smallest_ratio(model, geo, c, limit, capacity or {}) end
  for group, rotation in pairs(at_yield) do
    local limit = { [group] = 0.03 }
    near(ratio(middle, limit), 0.03 / rotation, 1e-9, "group " .. group)
    local here = group ~= "B" and group ~= "F"
    local found = ratio(corner, limit)
    equal(found ~= nil, here, "in the bay of the corner: " .. group)
    if here then near(found, 0.03 / rotation, 1e-9, "its ratio") end
  end
  for _, group in ipairs { "brace", "steep", "post" } do equal(ratio(middle, { [group] = 0.03 }), nil, group) end
  local least = 0.03 / (7 * strong)
  if weak > strong then least = 0.03 / (7 * weak) end
  near(ratio(middle, 0.03), least, 1e-9, "of all: the longest one")
  near(ratio(middle, { C = 0.03 }, { [20] = 0.004, [23] = 1 }), 0.004 / (6.5 * strong), 1e-9, "a joint's capacity")
  near(ratio(middle, { C = 0.003 }, { [20] = 0.004, [23] = 1 }), 0.003 / (6.5 * strong), 1e-9, "above the limit")
  near(ratio(middle, nil, { [23] = 0.02 }), 0.02 / (7 * strong), 1e-9, "a capacity alone")
  local gone = geometry.cases("test", geo, { { 2, 3, 20 } }, "lowest")[1]
  equal(ratio(gone, { C = 0.03 }), nil, "a beam that goes itself")
end)

-- What is printed, written and drawn ----------------------------------------------------------------------------------

local folder = support.temporary_folder()
require "hinge.core".own_output(folder, {}, true)

local function row(of)
  return with({ group = "post", warnings = {}, reason = "", y = 0, z_low = 0, z_high = 3, seconds = 0.5 }, of)
end

-- Rows of two columns, at x = 0 and 4 m, by the three procedures.
local function given(more)
  local rows = {
    row { case = 1, name = "left", x = 0, procedure = "nonlinear dynamic", verdict = "holds", deflection = 0.01234,
      beam_rotation = 0.0021, column_rotation = 0.00345, ratio = 0.0863, increase = 1.875, dt = 5e-4,
      limit_reached = true, warnings = { "odd", "even" } },
    row { case = 1, name = "left", x = 0, procedure = "nonlinear static", verdict = "exceeds the limit of rotation",
      reason = "member 2 has 1.2 of its limit 0.04 rad", deflection = 0.02, beam_rotation = 0.048,
      column_rotation = 0.001, ratio = 1.2, load_factor = 1.456, omega = 1.23, limit_reached = false,
      warnings = { "odd" } },
    row { case = 2, name = 'the "middle"', x = 4, procedure = "nonlinear dynamic", verdict = "failed",
      reason = "no joint" },
    row { case = 2, name = 'the "middle"', x = 4, procedure = "linear static", verdict = "exceeds the capacity",
      reason = "member 4 has a DCR of 3.5", deflection = 0.1, beam_rotation = 0.3, column_rotation = 0.2, dcr = 3.4567,
      dcr_limit = 2.5, ratio = 1.38, worst = 4 },
  }
  local result = { rows = rows, cases = 2, criterion = "GSA", m = 2.5, omega_ld = 3.35, has_limit = true, seconds = 7,
    procedures = { "nonlinear dynamic", "nonlinear static", "linear static" },
    counts = { ["nonlinear dynamic"] = { holds = 1, failed = 1 }, ["nonlinear static"] = { x = 1 },
      ["linear static"] = { y = 2 } }, outline = {} }
  local function line(x1, z1, x2, z2)
    table.insert(result.outline, { { x = x1, y = 0, z = z1 }, { x = x2, y = 0, z = z2 } })
  end
  line(0, 0, 0, 3)
  line(4, 0, 4, 3)
  line(0, 3, 4, 3)
  line(0, 3, 4, 3) -- behind the last one
  return setmetatable(with(result, more), Result)
end

local reasons = [[
case 1, nonlinear static: exceeds the limit of rotation: member 2 has 1.2 of its limit 0.04 rad
case 2, nonlinear dynamic: failed: no joint
case 2, linear static: exceeds the capacity: member 4 has a DCR of 3.5]]

case("the table has mm, the larger rotation, the part of the limit, and the answer of each procedure", function()
  equal(tostring(given()), [[
  procedure          deflection, mm  rotation, rad  of limit  answer              verdict
case 1, left
  nonlinear dynamic  12.3            0.0034         0.09      1.88 times statics  holds
  nonlinear static   20.0            0.0480         1.20      loads 1.46 of 1.23  exceeds the limit of rotation
case 2, the "middle"
  nonlinear dynamic  -               -              -         -                   failed
  linear static      100.0           -              -         DCR 3.457 of 2.5    exceeds the capacity
]] .. reasons, "as text")
  equal(given():markdown(), [[
| case | what is removed | procedure | deflection, mm | rotation, rad | of limit | answer | verdict |
|---|---|---|---|---|---|---|---|
| 1 | left | nonlinear dynamic | 12.3 | 0.0034 | 0.09 | 1.88 times statics | holds |
| 1 | left | nonlinear static | 20.0 | 0.0480 | 1.20 | loads 1.46 of 1.23 | exceeds the limit of rotation |
| 2 | the "middle" | nonlinear dynamic | - | - | - | - | failed |
| 2 | the "middle" | linear static | 100.0 | - | - | DCR 3.457 of 2.5 | exceeds the capacity |
]], "as Markdown")
end)

-- What a method of a result draws: where, the plot and the name of its file.
local function drawing(result, method)
  local drawn
  local job = require "hinge.program.job"
  local new = job.new
  job.new = function(where)
    return { plot = function(_, plot, filename) drawn = { where = where, plot = plot, filename = filename } end }
  end
  result[method](result)
  job.new = new
  return drawn
end

case("the CSV file and the report hold each number of each row, and each warning once", function()
  local drawn = drawing(given { folder = "loss" }, "report")
  equal(drawn.where .. "/" .. drawn.filename, folder .. "/loss/robustness.png", "the picture")
  local lines = {}
  for line in (support.read(folder .. "/loss/robustness.csv") or ""):gmatch "[^\n]+" do lines[#lines + 1] = line end
  equal(#lines, 5, "lines of the CSV file")
  local names = {}
  for name in lines[1]:gmatch "[^,]+" do names[#names + 1] = name end
  local plain = { [1] = 1, [2] = 2, [4] = 4 } -- rows without a comma or a quote in a text, but for the names
  for i in pairs(plain) do
    local r, k = given().rows[i], 0
    for cell in (lines[i + 1] .. ","):gsub('"the ""middle"""', "MIDDLE"):gmatch "([^,]*)," do
      k = k + 1
      local value = r[names[k]]
      if cell == "MIDDLE" then cell = 'the "middle"' end
      local wanted = value == nil and "" or value == true and 1 or value == false and 0 or value
      equal(tonumber(cell) or (cell:gsub('^"(.*)"$', "%1")), wanted, ("row %d, %s"):format(i, names[k]))
    end
    equal(k, #names, "cells")
  end
  local report = support.read(folder .. "/loss/report.md")
  equal(report:match "^(.-)\n| case", [[
# Loss of columns

Criterion: GSA. 2 cases, 4 rows in 7 s.

- nonlinear dynamic: failed: 1, holds: 1
- nonlinear static: x: 1
- linear static: y: 2

| procedure | loads | what it is held against |
|---|---|---|
| nonlinear dynamic | as given; the column goes at once | the limit of rotation, and a fall of the joints |
| nonlinear static | times Omega_N = 1.08 + 0.76 / (allowed rotation / rotation at yield + 0.83), or as given | ]]
    .. [[equilibrium under these loads, and the limit of rotation |
| linear static | times Omega_LD = 3.35; columns with more than half of N0: 2 | a DCR of m = 2.5; such columns: 1 |
]], "the head of the report")
  expect(report:find("\n- " .. reasons:gsub("\n", "\n- ") .. "\n", 1, true), "reasons in: %s", report)
  equal(report:match "\n(## Warnings.*)$", "## Warnings of the runs\n\n- case 1, nonlinear dynamic: odd\n"
    .. "- case 1, nonlinear dynamic: even\n", "warnings")
  given({ has_limit = false }):report()
  expect(support.read(folder .. "/report.md"):find "the limits of joints alone: no other was given, and a fall",
    "no limit, no folder")
end)

case("the picture of a plane frame has the columns that go as bars over their height, by verdict", function()
  local plot = drawing(given(), "picture").plot
  equal(joined { #plot.panels, plot.columns, plot.width, plot.height, plot.title },
    "3 1 1000 1080 Loss of columns, GSA", "panels below each other")
  local titles = { "nonlinear dynamic: deflection", "nonlinear static: largest load factor", "linear static: DCR" }
  for i, panel in ipairs(plot.panels) do
    equal(panel.title, titles[i], "title")
    equal(joined { panel.x_label, panel.y_label, panel.x_range[1], panel.x_range[2], panel.y_range[1],
      panel.y_range[2] }, "x, m z, m -0.5 4.5 -0.5 3.5", "axes: a margin of at least 0.5 m")
    local lines = panel.series[1]
    equal(joined(lines.x), "0 0 | 4 4 | 0 4 |", "the frame, each line once: x")
    equal(joined(lines.y), "0 3 | 0 3 | 3 3 |", "and z")
    equal(#panel.series, 1 + 2 * 4 + 1, "frame, fill and edge of four verdicts, texts")
  end
  local first, second, third = table.unpack(plot.panels)
  local half = 0.03 * 5 / 2
  local function mark(x) return joined { x - half, x + half, 0 / 0 } end
  local function edge(x) return joined { x - half, x + half, x + half, x - half, x - half, 0 / 0 } end
  local function fills(panel)
    local list = {}
    for i = 2, 8, 2 do
      local s = panel.series[i]
      list[#list + 1] = ("%s %s %s"):format(s.name, s.colour, joined(s.x))
      equal(s.style, "band", "filled")
      equal(joined(s.low) .. joined(s.high), #s.x > 0 and "0 0 |3 3 |" or "", "over the height")
      equal(panel.series[i + 1].colour, s.colour, "its edge")
      equal(joined(panel.series[i + 1].y), #s.x > 0 and "0 0 3 3 0 |" or "", "the edge, z")
    end
    return table.concat(list, "; ")
  end
  local names = { "holds green ", "exceeds the limit of rotation orange ", "failed black ",
    "exceeds the capacity orange " }
  equal(fills(first), names[1] .. mark(0) .. "; " .. names[2] .. "; " .. names[3] .. mark(4) .. "; " .. names[4], "1")
  equal(fills(second), names[1] .. "; " .. names[2] .. mark(0) .. "; " .. names[3] .. "; " .. names[4], "2")
  equal(fills(third), names[1] .. "; " .. names[2] .. "; " .. names[3] .. "; " .. names[4] .. mark(4), "3")
  equal(joined(first.series[3].x), edge(0), "the edge, x")
  local function texts(panel)
    local s = panel.series[#panel.series]
    return joined(s.x) .. "; " .. joined(s.y) .. "; " .. joined(s.labels) .. "; " .. s.style .. " " .. s.colour
  end
  equal(texts(first), "0 4; 1.5 1.5; 12 mm -; points black", "deflections")
  equal(texts(second), "0; 1.5; 1.46; points black", "load factor")
  equal(texts(third), "4; 1.5; 3.46; points black", "DCR")
end)

case("the picture of a space frame is a plan, with a panel for each height at which columns begin", function()
  local result = given()
  result.outline = { { { x = 0, y = 0, z = 0 }, { x = 0, y = 0, z = 3 } },
    { { x = 0, y = 0, z = 3 }, { x = 20, y = 0, z = 3 } }, { { x = 0, y = 0, z = 3 }, { x = 0, y = 10, z = 3 } } }
  result.rows[4].z_low, result.rows[4].y = -1, 10
  local plot = drawing(result, "picture").plot
  equal(joined { #plot.panels, plot.columns, plot.width, plot.height }, "6 3 2400 1020", "plans side by side")
  equal(plot.panels[3].title, "linear static: DCR, from z = -1 m", "the lowest first")
  equal(plot.panels[4].title, "nonlinear dynamic: deflection, from z = 0 m", "then the next")
  local panel = plot.panels[3]
  equal(joined { panel.x_label, panel.y_label, panel.x_range[1], panel.x_range[2], panel.y_range[1],
    panel.y_range[2] }, "x, m y, m -2.4 22.4 -1.2 11.2", "axes: a margin of 12 %")
  equal(joined(panel.series[1].x) .. " " .. joined(panel.series[1].y), "0 20 | 0 0 | 0 0 | 0 10 |", "the floor")
  local half, square = 0.03 * 24.8 / 2, panel.series[8]
  equal(joined(square.x), joined { 4 - half, 4 + half, 0 / 0 }, "a square, x")
  equal(joined(square.low) .. joined(square.high), joined { 10 - half, 10 - half, 0 / 0 }
    .. joined { 10 + half, 10 + half, 0 / 0 }, "and y")
  equal(joined(panel.series[10].y), "10", "the text stands in it")
  for _, line in ipairs(result.outline) do
    for _, p in ipairs(line) do p.x, p.y = 0, p.x end
  end
  equal(drawing(result, "picture").plot.panels[1].x_label, "y, m", "a frame in the plane of y and z")
end)

checks.done()
