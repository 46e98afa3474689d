-- Frames for ParaView, read by VTK's own reader (tests/frame_reader.cpp): the arrays, their units in their names, and
-- their numbers against those of the run; the collection that lists them.
--
-- Run: lua5.4 tests/script/render/frames_test.lua BUILD READER
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local checks = support.checks "frames"
local case = checks.case
local quote, expect, equal, near = support.quote, checks.expect, checks.equal, checks.near
local hinge_on, folder = support.scenes(arg[1])

-- A portal that yields and sways, and a bar that a rule breaks; what the run says of the last frame goes into "said".
local scene = [=[
local hinge = require "hinge"
local steel = hinge.material { E = 206e9, density = 7850, yield_stress = 235e6 }
local section = hinge.section.h { depth = 0.2, width = 0.15, web = 0.008, flange = 0.012 }
local model = hinge.model { interaction = "paper" }
local node = {}
for i, p in ipairs { { 0, 0, 0 }, { 0, 0, 3 }, { 4, 0, 3 }, { 4, 0, 0 } } do node[i] = model:node(p) end
model:fix(node[1])
model:fix(node[4])
local member = {}
for i = 1, 3 do
  member[i] = model:member { node[i], node[i + 1], section = section, material = steel,
    group = i == 2 and "beams" or "columns", up = { i == 2 and 0 or 1, 0, i == 2 and 1 or 0 } }
end
model:ground { point = { 0, 0, -0.1 }, normal = { 0, 0, 1 } }
model:load { node = node[2], force = { 300e3, 20e3, 0 } }
model:load { member = member[2], q = { 0, 0, -20e3 } }
model:fracture(function(s) return s.member == 3 and s.time > 0.03 end)
local run = model:dynamic { dt = 1e-4, duration = 0.04 }
for step in run:steps() do
  if step.index % 100 == 0 then hinge.frame(run) end
end
local said = { time = run.time }
local function note(name, value)
  local s = said[name] or { low = value, high = value }
  if not (value >= s.low) then s.low = value end
  if not (value <= s.high) then s.high = value end
  said[name] = s
end
for _, part in ipairs { "N", "Mx", "My", "Mz" } do
  for _, m in ipairs(member) do
    for _, v in ipairs { m:forces(run) } do note(part, v[part]) end
  end
end
for _, n in ipairs(node) do
  local u = said.u or {}
  u[#u + 1], said.u = { run:displacement(n) }, u
end
said.yielded, said.broken = run:count { state = "yielded" }, run:count { state = "broken" }
return said
]=]
assert(hinge_on("run -q", scene, "--out one") == 0, "the scene")
local said = support.json(support.read(folder .. "/one/summary.json") or "{}").results or {}

local function read_frame(name, out)
  local text = support.output(("%s %s/%s/%s"):format(quote(arg[2]), quote(folder), out or "one", name))
  local found = { points = tonumber(text:match "points (%d+)"), lines = tonumber(text:match "lines (%d+)"),
    polygons = tonumber(text:match "polygons (%d+)"), of = {} }
  for where, array, kind, components, tuples, rest in text:gmatch
    "(%l+)\t([^\t\n]+)\t([^\t]+)\t(%d+)\t(%d+)\t([^\n]*)\n" do
    local low, high, sum = rest:match "^(%S+)\t(%S+)\t(%S+)$"
    found.of[array] = { where = where, kind = kind, components = tonumber(components), tuples = tonumber(tuples),
      low = tonumber(low), high = tonumber(high), sum = tonumber(sum), text = rest }
  end
  return found
end

-- The collection: ParaView takes times from it.
local pvd = support.read(folder .. "/one/frames.pvd") or ""
local files, times = {}, {}
case("frames.pvd lists the frames with their times", function()
  for time, file in pvd:gmatch '<DataSet timestep="([^"]*)"[^>]- file="([^"]*)"' do
    files[#files + 1], times[#times + 1] = file, tonumber(time)
  end
  equal(#files, 4, "frames of the collection")
  for i, time in ipairs(times) do
    near(time, 0.01 * i, 1e-12, "time of frame " .. i)
    local found = read_frame(files[i])
    near((found.of.TimeValue or { sum = 0 }).sum, time, 1e-12, "TimeValue of frame " .. i)
  end
end)

-- Before anything breaks, and at the end.
local first, last = read_frame(files[1]), read_frame(files[4])
case("VTK reads a frame before anything breaks and at the end, with every array", function()
  equal(first.lines, 6, "lines before: two elements a member")
  equal(first.points, 7, "points before")
  local expected = {
    field = { "TimeValue", "groups", "memberships", "sections: kind, width, depth, web, flange [m]", "declared nodes",
      "loads: kind, point, line, place, first and second vector", "ground: point, normal [m]" },
    point = { "is_virtual", "displacement [m]", "rotation [rad]", "held" },
    cell = { "f_y", "group", "state", "member", "element", "width [m]", "N [N]", "Mx 1 [N m]", "Mx 2 [N m]",
    "My 1 [N m]",
      "My 2 [N m]", "Mz [N m]", "hinge rotation 1 [rad]", "hinge rotation 2 [rad]", "N0 [N]", "Mx0 [N m]", "My0 [N m]",
      "Mz0 [N m]", "Qx 1 [N]", "Qx 2 [N]", "Qy 1 [N]", "Qy 2 [N]", "P L2/EIx", "P L2/EIy", "hinges",
      "touched", "section", "up [1/127]" },
  }
  for _, frame in ipairs { first, last } do
    local count = 0
    if frame == last then -- where something has broken: the nodes at which elements were declared to end
      table.move({ "node 1", "node 2" }, 1, 2, #expected.cell + 1, expected.cell)
    end
    for where, names in pairs(expected) do
      for _, name in ipairs(names) do
        local array = frame.of[name]
        expect(array and array.where == where, "no array '%s' of %ss", name, where)
        local tuples = where == "point" and frame.points or where == "cell" and frame.lines
        if array and tuples then equal(array.tuples, tuples, "length of " .. name) end
        count = count + 1
      end
    end
    for name in pairs(frame.of) do count = count - 1 expect(count >= 0, "an array more, such as %s", name) end
  end
  equal(last.of.groups.text, "columns", "the first group's name")
  equal(last.of.state.high, 2, "a broken element")
  equal(first.of.state.high < 2, true, "none at first")
  equal(said.broken, 1, "members broken")
  expect(last.of["hinge rotation 1 [rad]"].high > 0 or last.of["hinge rotation 2 [rad]"].high > 0,
    "no plastic rotation")
  near(last.of["width [m]"].low, math.sqrt(0.2 * 0.15), 0.2, "width")
  local fields = last.of["sections: kind, width, depth, web, flange [m]"]
  near(fields.sum, 1 + 0.15 + 0.2 + 0.008 + 0.012, 1e-9, "the section")
end)

case("nodes come first, in their order", function()
  for i, u in ipairs(said.u) do
    for from, array in pairs { [0] = "displacement [m]", [3] = "rotation [rad]" } do
      local row = support.output(("%s %s/one/%s '%s' %d"):format(quote(arg[2]), quote(folder), files[4], array, i - 1))
      local c = 0
      for v in row:gmatch "%S+" do
        c = c + 1
        near(tonumber(v), u[from + c], 1e-9 + 1e-6 * math.abs(u[from + c]), ("%s %d of node %d"):format(array, c, i))
      end
      equal(c, 3, array)
    end
  end
end)

case("forces of members in a frame are those of member:forces", function()
  -- Forces of members: those at their two ends are among the elements', of which the largest are at no other place.
  for part, names in pairs { N = { "N [N]" }, Mx = { "Mx 1 [N m]", "Mx 2 [N m]" }, My = { "My 1 [N m]", "My 2 [N m]" },
    Mz = { "Mz [N m]" } } do
    local low, high = math.huge, -math.huge
    for _, name in ipairs(names) do
      low, high = -support.largest_of(-low, -last.of[name].low), support.largest_of(high, last.of[name].high)
    end
    local of = said[part]
    local size = support.largest_of(math.abs(of.low), math.abs(of.high), 1)
    local ranges = ("%s: %g to %g, members' ends have %g to %g"):format(part, low, high, of.low, of.high)
    expect(low <= of.low + 1e-6 * size and high >= of.high - 1e-6 * size, ranges)
    expect(high - low <= 3 * (of.high - of.low) + 1, ranges)
  end
end)

-- A girder and two panels beside it, of which the outer one is pulled until it tears.
local of_panels = [=[
local hinge = require "hinge"
local steel = hinge.material { E = 206e9, density = 7850, yield_stress = 235e6 }
local model = hinge.model()
local node = {}
for i, p in ipairs { { 0, 0, 0 }, { 2, 0, 0 }, { 2, 1, 0 }, { 0, 1, 0 }, { 2, 3, 0 }, { 0, 3, 0 } } do
  node[i] = model:node(p)
end
model:member { node[1], node[2], section = hinge.section.named "IPE 200", material = steel }
model:fix({ node[1], node[2] })
model:fix({ node[3], node[4], node[5], node[6] }, "z")
local plate = { model:panel { node[1], node[2], node[3], node[4], thickness = 0.02, material = steel },
  model:panel { node[4], node[3], node[5], node[6], thickness = 0.005, material = steel, ultimate_strain = 0.01 } }
model:move { node = { node[5], node[6] }, y = function(t) return 0.5 * t end }
local run = model:dynamic { dt = 1e-4, duration = 0.05 }
local said = { forces = {}, used = {}, torn = {} }
local function note()
  hinge.frame(run)
  for i, p in ipairs(plate) do
    table.insert(said.forces, { p:force(run) })
    table.insert(said.used, p:used(run))
    table.insert(said.torn, p:torn(run) and 1 or 0)
  end
end
for step in run:steps() do
  if #said.used == 0 and step.time > 0.02 then note() end
end
note()
return said
]=]

case("panels are polygons with their forces, behind the lines", function()
  equal(hinge_on("run -q", of_panels, "--out plates"), 0, "the scene")
  local told = support.json(support.read(folder .. "/plates/summary.json")).results
  local function row(frame, array, k)
    local text = support.output(("%s %s/plates/frames/frame_%05d.vtp '%s' %d"):format(quote(arg[2]), quote(folder),
      frame, array, k))
    return tonumber(text:match "%S+")
  end
  expect(told.torn[2] == 0 and told.torn[4] == 1 and told.torn[3] == 0, "the outer panel alone tears, at the end")
  expect(told.forces[2][2] > 1e5 and told.used[2] > 0.001, "it is pulled in the first frame")
  for frame = 1, 2 do
    local found = read_frame(("frames/frame_%05d.vtp"):format(frame), "plates")
    equal(found.lines .. " " .. found.polygons, "2 2", "lines and polygons")
    for name, array in pairs(found.of) do
      if array.where == "cell" then equal(array.tuples, 4, "rows of " .. name) end
    end
    equal(row(frame, "panel", 0) .. " " .. row(frame, "panel", 3), "0 2", "numbers of panels")
    for k = 1, 2 do
      local at = 2 * (frame - 1) + k
      local n = told.forces[at]
      for c, name in ipairs { "n11 [N/m]", "n22 [N/m]", "n12 [N/m]" } do
        near(row(frame, name, k + 1), n[c], 1e-6 * (math.abs(n[1]) + math.abs(n[2])) + 1e-3, name)
      end
      local middle, half = (n[1] + n[2]) / 2, math.sqrt(((n[1] - n[2]) / 2) ^ 2 + n[3] ^ 2)
      local slack = 1e-6 * (math.abs(middle) + half) + 1e-3
      near(row(frame, "principal 1 [N/m]", k + 1), middle + half, slack, "the larger one")
      near(row(frame, "principal 2 [N/m]", k + 1), middle - half, slack, "the smaller one")
      near(row(frame, "used", k + 1), told.used[at], 1e-6 * told.used[at] + 1e-12, "used")
      equal(row(frame, "torn", k + 1), told.torn[at], "torn")
    end
    equal(row(frame, "N [N]", 2), nil, "a panel has no N")
  end
  -- the program reads them as it does without panels
  local status, _, complaint = support.run(("cd %s && %s render plates"):format(quote(folder),
    quote(arg[1] .. "/hinge")))
  equal(status, 0, complaint)
  expect(support.is_there(folder .. "/plates/frames/frame_00002.png"), "the picture of a frame with panels")
end)

checks.done()
