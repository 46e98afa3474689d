-- run:hinges: rotation, work, utilisation and first yield of every plastic hinge, against limits; over chained runs,
-- checkpoints and the reversal of a load; as text, as hinges.csv, by storey.
--
-- Run: lua5.4 tests/script/results/hinges_test.lua BUILD_FOLDER [PICTURE]      PICTURE: where one of its pictures goes
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local hinge = require "hinge"
local support = require "support"
local scenes = require "scenes"
local checks = support.checks "hinges"
local case, expect, equal, near = checks.case, checks.expect, checks.equal, checks.near

local fy, L, side = 235e6, 4, 0.05
local steel = hinge.material { E = 210e9, density = 7850, yield_stress = fy }
local bar = hinge.section.solid { width = side, depth = side }
local Mp, EI = bar.Zx * fy, steel.E * bar.Ix

-- A propped cantilever pushed down in its middle, to `last` m; see lua/guide/plastic_hinges.md.
local function propped(formulation)
  local model = hinge.model { displacement = "small", formulation = formulation }
  local wall, middle, prop = model:node { 0, 0, 0 }, model:node { L / 2, 0, 0 }, model:node { L, 0, 0 }
  model:fix(wall, "all")
  model:fix(prop, "y,z,rx")
  local left = model:member { wall, middle, section = bar, material = steel, group = "left" }
  local right = model:member { middle, prop, section = bar, material = steel, group = "right" }
  model:case("push"):load { node = middle, force = { 0, 0, -1000 } }
  return model, middle, left, right, wall
end
local last = 0.12
local P1, P2 = 16 / 3 * Mp / L, 6 * Mp / L
local d2 = 7 / 768 * P1 * L ^ 3 / EI + (P2 - P1) * L ^ 3 / (48 * EI)
local at_wall = Mp * L / (24 * EI) + (last - d2) / (L / 2) -- rad: before and after the second hinge
local at_middle = 2 * (last - d2) / (L / 2)

case("a propped cantilever has its two plastic hinges at the loads and rotations of theory", function()
  local model, middle, left, _, wall = propped()
  local run = model:static { steps = 300, loads = { push = 1 }, control = { node = middle, "uz", to = -last } }
  equal(#run:hinges(), 0, "before the first step")
  equal(tostring(run:hinges()), "0 plastic hinges", "as text")
  equal(run:hinges().worst, nil, "no worst")
  run:finish()
  local list = run:hinges()
  expect(#list == 2 or #list == 3, "%d hinges", #list) -- the joint in the middle: in one member or in both
  local w = list[1]
  equal(w.member, left, "its member")
  equal(w.node, wall, "its joint")
  equal(w.group, "left", "its group")
  equal(w.storey, nil, "no storey: its only level member stands on the supports")
  equal(w.at, 0, "its place")
  equal(w.element, 1, "its element")
  equal(w["end"], 1, "and end")
  near(w.largest, at_wall, 0.01 * at_wall, "rotation at the wall") -- shear, which is not in the hand's sums
  equal(w.rotation, w.largest, "it has only grown")
  equal(w.rotation, math.abs(w.rotation_x), "about one axis")
  near(w.work, Mp * at_wall, 0.01 * Mp * at_wall, "work at the wall")
  near(w.f_y, 1, 1e-9, "f_y")
  near(w.utilisation, 1, 1e-9, "utilisation")
  near(w.first_yield, P1 / 1000, 0.01 * P1 / 1000, "first yield, as a load factor") -- a step is 0.8 % of it
  equal(w.first_kind, "static", "its kind")
  equal(w.before, false, "in this run")
  local middles, work = 0, w.work
  for i = 2, #list do
    middles = middles + list[i].largest
    work = work + list[i].work
    near(list[i].first_yield, P2 / 1000, 0.002 * P2 / 1000, "first yield in the middle")
  end
  near(middles, at_middle, 0.01 * at_middle, "rotation in the middle")
  for i = 2, #list do near(list[i].demand, middles, 1e-15, "demand in the middle, which two members may share") end
  equal(w.demand, w.largest, "demand at the wall")
  equal(list.worst, at_middle > at_wall and list[2] or w, "the largest")
  near(work, run.energy.plastic, 1e-9 * work, "the sum of the work")
  equal(#run:hinges { group = "right" }, #list - 1 - (#list == 3 and 1 or list[2].member == left and 1 or 0),
    "of a group")

  -- taken off: it unloads, and the utilisation falls with the forces
  local off = model:static { from = run, steps = 4, loads = { push = 0 } }:finish()
  local now = off:hinges()[1]
  equal(now.rotation, w.rotation, "unloaded: rotation")
  equal(now.before, true, "in the run before")
  equal(now.first_yield, w.first_yield, "and then")
  near(now.utilisation, 0.125, 0.002, "√f_y of -0.125 Mp")
  near(now.f_y, 0.125 ^ 2, 0.0005, "f_y")

  -- pushed up again: the rotation goes back, the largest stays
  local up = model:static { from = off, steps = 100, loads = { push = -1 },
    control = { node = middle, "uz", to = 0.02 } }:finish()
  local back = up:hinges()[1]
  expect(back.rotation < 0.9 * w.rotation, "pushed back: %g of %g", back.rotation, w.rotation)
  equal(back.largest, w.largest, "pushed back: the largest")
  expect(back.work > w.work, "pushed back: work %g after %g", back.work, w.work)
end)

case("where two elements of a member meet there is one hinge with the rotation of both", function()
  local model = hinge.model { displacement = "small" }
  local a, b = model:node { 0, 0, 0 }, model:node { L, 0, 0 }
  model:fix(a, "x,y,z,rx")
  model:fix(b, "y,z,rx")
  local beam = model:member { a, b, section = bar, material = steel }
  model:load { member = beam, at = 0.5, force = { 0, 0, -1 } }
  local run = model:static { steps = 20, control = { node = a, "ry", to = 0.1 } }:finish()
  local list = run:hinges()
  equal(#list, 1, "hinges of a beam on two supports")
  local elastic = Mp * L / (4 * EI) -- rad, at its end: P L^2 / 16 EI with P = 4 Mp / L
  near(list[1].at, 0.5, 1e-12, "in its middle")
  equal(list[1].node, nil, "at no joint")
  near(list[1].x, L / 2, 1e-12, "at x")
  near(list[1].largest, 2 * (0.1 - elastic), 0.01, "its kink") -- shear: 1 % of the elastic part
  near(list[1].work, run.energy.plastic, 1e-9 * run.energy.plastic, "its work")
end)

case("the conventional element has its hinge in the middle", function()
  local model, middle = propped "conventional"
  local run = model:static { steps = 100, loads = { push = 1 }, control = { node = middle, "uz", to = -last } }:finish()
  local list, work = run:hinges(), 0
  for _, h in ipairs(list) do
    equal(h["end"], 0, "conventional: its end")
    expect(h.at == 0.25 or h.at == 0.75, "conventional: at %g", h.at)
    work = work + h.work
  end
  near(work, run.energy.plastic, 1e-9 * work, "conventional: the sum of the work")
end)

-- In time: when it first yielded, over a checkpoint and over a chain of runs.
local function struck(from, duration)
  local model, tip = scenes.cantilever { along = { 0, 0, 1 },
    member = { section = bar, material = steel, group = "posts" } }
  model:mass { node = tip, mass = 50 }
  if from then return model end
  model:velocity(tip, { 20, 3, 0 })
  return model:dynamic { dt = 1e-4, duration = duration or 0.04 }, model
end
case("the time of first yield holds over checkpoints and chains of runs", function()
  local run = struck()
  local first
  for step in run:steps() do
    if not first and run:count { state = "yielded" } > 0 then first = step.time end
  end
  local list = run:hinges()
  expect(#list >= 1, "%d hinges of the post", #list)
  local earliest, both, work = math.huge, false, 0
  for _, h in ipairs(list) do
    earliest, work = math.min(earliest, h.first_yield), work + h.work
    both = both or h.rotation_x ~= 0 and h.rotation_y ~= 0
    near(h.rotation, math.sqrt(h.rotation_x ^ 2 + h.rotation_y ^ 2), 1e-15, "about both axes")
    equal(h.first_kind, "dynamic", "its kind")
  end
  near(earliest, first, 1e-9, "first yield, s")
  expect(both, "it bends about both axes")
  near(work, run.energy.plastic, 1e-6 * work, "the sum of the work")

  local file = support.temporary_folder() .. "/half.checkpoint"
  local half = struck()
  for step in half:steps() do
    if step.index == 200 then half:checkpoint(file) end
  end
  local resumed = struck()
  resumed:resume(file)
  expect(#resumed:hinges() > 0, "right after the resume there are hinges")
  resumed:finish()
  equal(tostring(resumed:hinges()), tostring(list), "after a resume, as text")
  for i, h in ipairs(resumed:hinges()) do
    for _, field in ipairs { "rotation_x", "rotation_y", "largest", "elongation", "work", "first_yield", "before" } do
      equal(h[field], list[i][field], "after a resume: " .. field)
    end
  end

  local short, model = struck(nil, 0.02)
  short:finish()
  local before = short:hinges()[1]
  local on = model:dynamic { from = short, dt = 1e-4, duration = 0.02 }:finish()
  local after = on:hinges()[1]
  equal(after.first_yield, before.first_yield, "from another run: first yield")
  equal(after.before, true, "from another run: before it")
  expect(after.work > before.work, "from another run: work %g after %g", after.work, before.work)
  -- the default control looks at other steps in a run that is half as long
  near(after.work, list[1].work, 2e-3 * after.work, "from another run: as in one")
end)

-- Limits --------------------------------------------------------------------------------------------------------------
case("limits of hinge rotation give utilisations, and wrong ones are refused", function()
  local model, middle, left = propped()
  local run = model:static { steps = 100, loads = { push = 1 }, control = { node = middle, "uz", to = -last } }:finish()
  local bare = run:hinges()
  equal(bare.beyond, nil, "without a limit")
  equal(bare[1].ratio, nil, "without a limit: ratio")
  local theta = bare[1].largest
  local list = run:hinges { limit = theta / 2 }
  near(list[1].ratio, 2, 1e-12, "one limit")
  equal(list[1].level, nil, "one limit: level")
  expect(list.beyond >= 1, "one limit: %d beyond", list.beyond)
  local levels = { IO = theta / 4, LS = theta / 2, CP = 2 * theta }
  list = run:hinges { limit = levels }
  equal(list[1].level, "CP", "levels")
  equal(list[1].limit, 2 * theta, "levels: limit")
  near(list[1].ratio, 0.5, 1e-12, "levels: ratio")
  equal(list.beyond, 0, "levels: beyond")
  equal(run:hinges { limit = { IO = theta } }[1].level, "IO", "at the limit")
  equal(run:hinges { limit = { LS = theta / 2 } }[1].level, "beyond LS", "beyond the last level")
  list = run:hinges { limit = { left = theta / 3 } }
  near(list[1].ratio, 3, 1e-12, "by group")
  equal(list.worst.node, middle, "by group: the worst") -- there two members share the rotation
  local without = 0
  for _, h in ipairs(list) do
    if h.member ~= left then without = without + 1 end
  end
  equal(list.without_limit, without, "by group: without a limit")
  list = run:hinges { limit = function(h) return h.member == left and { LS = theta, CP = 2 * theta } or nil end }
  equal(list[1].level, "LS", "by function")
  local text = tostring(run:hinges { limit = theta / 2 })
  expect(text:find("^" .. #bare .. " plastic hinges, %d beyond the limit; the worst: member %d %(%a+%), "), "text: %s",
    text)
  expect(text:find "2%.000", "text has no ratio: %s", text)

  for _, r in ipairs {
    { { "unknown field 'limits' (did you mean 'limit'?)", "group, limit" }, { limits = 0.1 } },
    { "field 'limit' is 0 rad; must be a number above 0 rad", { limit = 0 } },
    { "field 'limit' is 'CP'; must be a number above 0 rad", { limit = "CP" } },
    { "field 'limit.LS' is -1 rad; must be a number above 0 rad", { limit = { LS = -1 } } },
    { "CP is 0.02 rad, which is not above LS, 0.03 rad", { limit = { LS = 0.03, CP = 0.02 } } },
    { "field 'limit' is an empty table", { limit = {} } },
    { "field 'limit' has both levels (IO) and groups", { limit = { IO = 1, left = 1 } } },
    { { "'lift'", "did you mean 'left'" }, { limit = { lift = 1 } } },
    { { "group", "'none'" }, { group = "none" } },
    { "takes no further argument, got also 1", {}, 1 },
  } do
    checks.refused(r[1], function() run:hinges(table.unpack(r, 2)) end)
  end
  checks.refused({ "field 'hinges' is", "a list of run:hinges that was given a limit" },
    function() hinge.picture(run, { hinges = bare }) end)
  checks.refused("filename is '../a.csv'; must be a plain name ending in .csv", function() bare:write "../a.csv" end)
end)

-- Storeys, and the files of a program ---------------------------------------------------------------------------------
local hinge_on, folder = support.scenes(arg[1])
local scene = [=[
local hinge = require "hinge"
local how = ...
local steel = hinge.material { E = 206e9, density = 7850, yield_stress = 235e6 }
local tube = hinge.section.box { width = 0.15, depth = 0.15, thickness = 0.006 }
local model = hinge.model()
local node = {}
for i = 0, 1 do
  node[i] = {}
  for k = 0, 2 do node[i][k] = model:node { 4 * i, 0, 3 * k } end
  model:fix(node[i][0])
  for k = 1, 2 do
    model:member { node[i][k - 1], node[i][k], section = tube, material = steel, group = "columns" }
    if i > 0 then model:member { node[0][k], node[1][k], section = tube, material = steel, group = 'a "beam"' } end
  end
end
model:load { node = node[0][2], force = { how.push, 0, 0 } }
local run = model:static { steps = 60, control = { node = node[0][2], "ux", to = 1e-6 * how.push } }:finish()
local list = run:hinges { limit = 0.05 }
if how.write == "yes" then list:write() end
if how.picture == "yes" then
  local view = { hinges = list, view = "front", width = 640, height = 480 }
  hinge.picture(run, view, "limits.png")
  hinge.strip({ { run, view }, { run, view } }, 2, "strip.png")
  view.hinges = true
  hinge.picture(run, view, "plain.png")
  view.hinges = run:hinges { limit = 1 }
  hinge.picture(run, view, "far.png")
end
print(list)
return { n = #list }
]=]
local function rows_of(file)
  local text, rows, head = support.read(folder .. "/" .. file) or "", {}, nil
  for line in text:gmatch "[^\n]+" do
    local row, at = {}, 0
    for value in (line .. ","):gmatch "([^,]*)," do
      at = at + 1
      row[head and head[at] or at] = value
    end
    if head then rows[#rows + 1] = row else head = row end
  end
  return rows, head or {}
end
case("run:hinges of a storey frame writes its table, its picture and hinges.csv", function()
  local status, printed, complaint = hinge_on("run -q", scene, "push=4e5 --out one")
  equal(status, 0, "the scene: " .. complaint)
  local rows, head = rows_of "one/hinges.csv"
  expect(#rows >= 6, "%d hinges in the file", #rows)
  equal(table.concat(head, ","), "storey,member,group,element,end,at,node,x,y,z,rotation_x,rotation_y,rotation,"
    .. "largest,demand,"
    .. "elongation,work,f_y,utilisation,first_yield,first_kind,before,broken,limit,ratio,level,joint,axis,rotation_z,"
    .. "moment,largest_moment,force,largest_force,stiffness,strength,capacity,yielded,failed", "columns")
  local storey = 0
  for _, row in ipairs(rows) do
    local z = tonumber(row.z)
    local column = row.group == '"columns"'
    local wanted = z == 6 and "2" or z == 3 and "1"
    if wanted and not column then equal(row.storey, wanted, "storey of a beam at " .. z) end
    if column and z == 0 then equal(row.storey, "1", "storey of a foot") end
    expect(tonumber(row.storey) >= storey, "storeys rise")
    storey = tonumber(row.storey)
    equal(row.limit, "", "no limit by itself")
    expect(row.group == '"columns"' or row.group == '"a ""beam"""', "group %s", row.group)
  end
  expect(printed:find("^" .. #rows .. " plastic hinges, %d+ beyond the limit; the worst: member %d"), "prints %s",
    printed)
  if support.is_there(arg[1] .. "/libhinge_output.so") then
    equal(hinge_on("run -q", scene, "push=4e5 picture=yes --out drawn"), 0, "pictures")
    local drawn = {}
    for _, name in ipairs { "limits", "plain", "far", "strip" } do
      drawn[name] = support.read(folder .. "/drawn/" .. name .. ".png") or ""
      expect(drawn[name]:find "^\137PNG", "no picture %s", name)
    end
    expect(drawn.limits ~= drawn.plain and drawn.limits ~= drawn.far, "a picture does not show the limits")
    if arg[2] then support.write(arg[2], drawn.limits) end
  end
  -- the script's own list stays
  equal(hinge_on("run -q", scene, "push=4e5 write=yes --out two"), 0, "written by the script")
  local own = rows_of "two/hinges.csv"
  equal(#own, #rows, "as many")
  own[1] = own[1] or {}
  near(tonumber(own[1].limit or "") or 0, 0.05, 0, "with the limit")
  near(tonumber(own[1].ratio or "") or 0, (tonumber(own[1].largest or "") or 1) / 0.05, 1e-8, "and the ratio")
  -- a run without hinges leaves none of an earlier one
  equal(hinge_on("run -q", scene, "push=1 --out two"), 0, "an elastic run")
  expect(not support.is_there(folder .. "/two/hinges.csv"), "hinges of an earlier run stay")
end)

checks.done()
