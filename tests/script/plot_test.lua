-- hinge.plot: histories of a run with one call, files by their ending, and what it says of values that are wrong.
--
-- Run: LUA_CPATH=BUILD_FOLDER/?.so lua5.4 tests/script/plot_test.lua
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "?.lua;" .. package.path
local support = require "support"
local checks = support.checks "plot"
local case, expect, equal, near = checks.case, checks.expect, checks.equal, checks.near

local folder = support.temporary_folder()

-- Scripts run in plain Lua within that folder, for pictures go where Lua was started.
local head = [[
local hinge = require "hinge"
local steel = hinge.material { E = 206e9, density = 7850, yield_stress = 235e6 }
local bar = hinge.section.solid { width = 0.05, depth = 0.05 }
local function cantilever(record)
  local model = hinge.model { elements_per_member = 2 }
  local root, tip = model:node { 0, 0, 0 }, model:node { 1, 0, 0 }
  model:fix(root)
  model:member { root, tip, section = bar, material = steel }
  model:load { node = tip, force = { 0, 0, -1000 } }
  return model, tip, root
end
local model, tip, root = cantilever()
local run = model:dynamic { dt = 1e-4, duration = 0.02 }
local sag, speed = run:probe { node = tip, "uz", name = "sag" }, run:probe { node = tip, "vz", name = "speed" }
local shear = run:probe { node = root, "fz" }
]]

local function lua(script)
  local file = folder .. "/script.lua"
  support.write(file, head .. script)
  local command = ("cd %s && lua5.4 script.lua 2>&1"):format(support.quote(folder))
  local pipe = assert(io.popen(command))
  local text = pipe:read "a"
  local good = pipe:close()
  return text, good
end

local function svg(name)
  local text = support.read(folder .. "/" .. name)
  return expect(text and text:find "^<svg ", "%s is no SVG", name) and text or ""
end

local function holds(text, what, wanted)
  return expect((text:find(">" .. what .. "<", 1, true) ~= nil) == (wanted ~= false), "%s '%s' in\n%s",
    wanted == false and "unexpected" or "no", what, text:sub(1, 2000))
end

-- The points of the curves of an SVG.
local function curves(text)
  local list = {}
  for points in text:gmatch '<polyline [^>]*points="([^"]*)"' do
    local curve = {}
    for x, y in points:gmatch "(-?[%d.]+),(-?[%d.]+)" do curve[#curve + 1] = { x = tonumber(x), y = tonumber(y) } end
    list[#list + 1] = curve
  end
  return list
end

-- ---- a dynamic run --------------------------------------------------------------------------------------------------

case("a plot of a dynamic run has its curves, axes and units", function()
  local said, good = lua [[
run:finish()
hinge.plot(run, "all.svg")
hinge.plot(run, "all.png")
hinge.plot(run, { "kinetic", "elastic", sag, title = "A <blow>", width = 500, height = 400 }, "some.svg")
hinge.plot(run, { speed, x = sag }, "phase.svg")
hinge.plot(run, { "sag" }, "sag.svg")
print(sag.unit, speed.unit, shear.unit, run.energy.kinetic, #sag.value)
]]
  expect(good, "plots of a run: %s", said)
  equal(said:match "^(.-)\n" and said:match "^(%S+\t%S+\t%S+)", "m\tm/s\tN", "units of probes")
  local all = svg "all.svg"
  for _, words in ipairs { "kinetic", "elastic", "work", "remainder", "energy, J", "sag, mm", "speed, m/s",
    "node1_fz, kN", "time, ms" } do holds(all, words) end
  for _, words in ipairs { "plastic", "fracture", "contact", "contact_stored" } do holds(all, words, false) end
  equal(select(2, all:gsub(">time, ms<", "")), 1, "the panels share one axis of time")
  expect((support.read(folder .. "/all.png") or ""):sub(2, 4) == "PNG", "all.png is no PNG")
  local some = svg "some.svg"
  for _, words in ipairs { "kinetic", "elastic", "energy, J", "sag, mm", "A &lt;blow&gt;" } do holds(some, words) end
  for _, words in ipairs { "work", "speed, m/s" } do holds(some, words, false) end
  expect(some:find 'width="500" height="400"', "the size that was asked for")
  local phase = svg "phase.svg"
  holds(phase, "sag, mm")
  holds(phase, "speed, m/s")
end)

-- The curve of the sag is the probe: its lowest point where the probe has it.
case("the curve of a plot is the probe", function()
  local lowest, at, points = -math.huge, nil, curves(svg "sag.svg")[1] or {}
  for i, p in ipairs(points) do
    if p.y > lowest then lowest, at = p.y, i end
  end
  expect(#points > 100, "%d points of the sag", #points)
  local said_at = lua [[
run:finish()
local at = 1
for i, v in ipairs(sag.value) do if v < sag.value[at] then at = i end end
print((sag.time[at] - sag.time[1]) / (sag.time[#sag.time] - sag.time[1]))
]]
  if at then
    near((points[at].x - points[1].x) / (points[#points].x - points[1].x), tonumber(said_at) or 0 / 0, 0.01,
      "when the sag is largest")
  end
end)

case("plotted energies are those of history.csv", function()
  -- Energies are those of history.csv, in plain Lua too, which writes none; the last row is the present state.
  local energies = lua [[
for step in run:steps() do if step.index == 77 then break end end
local core = require "hinge.core"
local rows = core.run_history(run)
local n = #rows.time
print(n, rows.time[n] == run.time, rows.kinetic[n] == run.energy.kinetic, rows.remainder[n] == run.energy.remainder)
]]
  equal(energies, "78\ttrue\ttrue\ttrue\n", "rows in the middle of a run")
end)

case("long runs keep a part of their rows, evenly, and the last one", function()
  -- Long runs keep a part of their rows, evenly, and the last one.
  local long = lua [[
local many = model:dynamic { dt = 1e-6, duration = 0.02, record = 1 }:finish()
local rows = require "hinge.core".run_history(many)
local n, step = #rows.time, rows.time[2] - rows.time[1]
local even = true
for i = 2, n - 1 do even = even and math.abs(rows.time[i] - rows.time[i - 1] - step) < 1e-9 end
print(n > 4000 and n <= 8193, even, rows.time[n] == many.time)
]]
  equal(long, "true\ttrue\ttrue\n", "rows of a long run")
end)

-- ---- a static run ---------------------------------------------------------------------------------------------------

case("a plot of a static run is drawn over the load factor", function()
  local said, good = lua [[
local push = model:static { steps = 10 }
local down = push:probe { node = tip, "uz", name = "down" }
push:finish()
hinge.plot(push, "load.svg")
hinge.plot(push, { "elastic" }, "elastic.svg")
]]
  expect(good, "plots of statics: %s", said)
  local load = svg "load.svg"
  holds(load, "down, mm")
  holds(load, "load factor")
  holds(load, "time, s", false)
  local rising = curves(load)[1] or {}
  equal(#rising, 11, "points of the load-displacement curve")
  if #rising == 11 then
    expect(rising[11].y < rising[1].y and rising[11].x < rising[1].x, "the load rises, the tip falls")
  end
  holds(svg "elastic.svg", "elastic energy, J")
end)

-- ---- the folder of a run that is over -------------------------------------------------------------------------------

case("the folder of a run that is over is plotted as the run was", function()
  os.execute("mkdir -p " .. support.quote(folder .. "/done"))
  support.write(folder .. "/done/history.csv", [[
time,factor,kinetic,elastic,work,remainder,node2_uz,roof
0,0,0,0,0,0,0,1
0.5,0,2000,500,2500,0,0.01,2
1,0,4000,1000,5000,0,0.02,3
]])
  local said, good = lua [[
hinge.plot("done", "done.svg")
hinge.plot("done", { "kinetic", "roof" }, "done_some.svg")
]]
  expect(good, "plots of a folder: %s", said)
  for _, words in ipairs { "kinetic", "elastic", "work", "energy, kJ", "node2_uz, mm", "roof", "time, s" } do
    holds(svg "done.svg", words)
  end
  holds(svg "done.svg", "remainder", false)
  holds(svg "done_some.svg", "kinetic energy, kJ")
end)

case("a plot has the units of probes as the run left them beside its history", function()
  local said, good
  -- Units of probes as the run left them beside its history; what is no list of probes is as good as none.
  for text, wanted in pairs {
    ['[{"name":"roof","node":1,"quantity":"az","unit":"m/s^2"}, {"name":"node2_uz","unit":"m"}]'] = { "roof, m/s²" },
    ['[{"name":"roof","node":1,"quantity":"uz","unit":"m"}]'] = { "displacement, m", "roof", "node2_uz" },
    ['[{"name":"roof","unit":"furlong"}, 3, {"unit":"m"}]'] = { "roof", "node2_uz, mm" },
    ['[{"name":"ro'] = { "roof", "node2_uz, mm" },
  } do
    support.write(folder .. "/done/probes.json", text)
    said, good = lua 'hinge.plot("done", "units.svg")'
    expect(good, "units of %s: %s", text, said)
    for _, words in ipairs(wanted) do holds(svg "units.svg", words) end
  end
end)

-- ---- a run that goes on from a checkpoint ---------------------------------------------------------------------------

case("a run that goes on from a checkpoint is plotted from its beginning", function()
  local said = lua [[
for step in run:steps() do if step.index == 100 then break end end
run:checkpoint "half.checkpoint"
local again = model:dynamic { dt = 1e-4, duration = 0.02 }
again:probe { node = tip, "uz", name = "sag" }
again:probe { node = tip, "vz", name = "speed" }
again:probe { node = root, "fz" }
again:resume "half.checkpoint"
again:finish()
run:finish()
local core = require "hinge.core"
local a, b = core.run_history(run), core.run_history(again)
local same = #a.time == #b.time
for i = 1, #a.time do same = same and a.time[i] == b.time[i] and a.kinetic[i] == b.kinetic[i] end
print(#a.time, same)
]]
  equal(said, "201\ttrue\n", "rows from before the checkpoint")
end)

-- ---- bars, bands, panels as Lua gives them --------------------------------------------------------------------------

case("bars, bands and panels are drawn as Lua gives them", function()
  local said, good = lua [[
hinge.plot({ series = { { x = { "I", "II" }, y = { 1, 2 }, style = "bars", labels = { 1, "two" } } } }, "bars.svg")
hinge.plot({ series = { { x = { 0, 1 }, low = { 1, 2 }, high = { 2, 3 }, colour = { 1, 0, 0.5 } },
  { x = { 0, 1 }, y = { 1, 2 }, style = "line and points", colour = "#0a0B0c" } } }, "band.svg")
hinge.plot({ title = "both", columns = 2, panels = { { title = "left", series = { { x = { 0, 1 }, y = { 0, 1 } } } },
  { title = "right", series = { { x = { 0, 1 }, y = { 0, 1 } } }, lines = { { y = 2, name = "limit" } } } } },
  "panels.svg")
]]
  expect(good, "bars, bands and panels: %s", said)
  for _, words in ipairs { "I", "II", "1", "two" } do holds(svg "bars.svg", words) end
  for _, words in ipairs { "#ff0080", "#0a0b0c", "<circle", "<polygon" } do
    expect(svg "band.svg":find(words, 1, true), "no %s in band.svg", words)
  end
end)

case("different ranges of different columns, or without share_x, are no error", function()
  -- Different ranges of different columns, or without share_x, are no error.
  local said, good = lua [[
local function panel(low, high) return { x_range = { low, high }, series = { { x = { 0, 9 }, y = { 0, 1 } } } } end
hinge.plot({ share_x = true, columns = 2, panels = { panel(0, 1), panel(2, 3), panel(0, 1) } }, "ranges.svg")
hinge.plot({ panels = { panel(0, 1), panel(2, 3) } }, "ranges.svg")
]]
  expect(good, "ranges: %s", said)
  for _, words in ipairs { "both", "left", "right", "limit" } do holds(svg "panels.svg", words) end
end)

-- ---- what is wrong is said at the script's line ---------------------------------------------------------------------

case("wrong plots are refused at the script's line", function()
  local line = select(2, head:gsub("\n", "")) + 2
  for call, message in pairs {
    ['hinge.plot(run, { "kinetik" }, "x.png")']
      = "hinge.plot: unknown item 1 'kinetik' (did you mean 'kinetic'?); there are kinetic, ..., sag, speed, "
        .. "node1_fz",
    ['hinge.plot(run, { 42 }, "x.png")']
      = "hinge.plot: item 1 is 42; must be a probe of the run or one of ...",
    ['hinge.plot(run, { titel = "a" }, "x.png")']
      = "hinge.plot: unknown field 'titel' (did you mean 'title'?); there are columns, height, title, width, "
        .. "x",
    ['hinge.plot(run, { "kinetic", x = "sog" }, "x.png")']
      = "hinge.plot: unknown field 'x' 'sog' (did you mean 'sag'?)...",
    ['hinge.plot(run, 5, "x.png")']
      = "hinge.plot: field 'choice' is 5; must be a table",
    ['hinge.plot(run)']
      = "hinge.plot: field 'filename' is missing; give a string",
    ['hinge.plot(run, "x.pdf")']
      = "hinge.plot: filename is 'x.pdf'; must be a plain name ending in .png or .svg ...",
    ['hinge.plot(run, "../x.svg")']
      = "hinge.plot: filename is '../x.svg'; must be a plain name ending in .png or .svg ...",
    ['hinge.plot(run, {}, "x.svg", 3)']
      = "hinge.plot: takes no further argument, got also 3",
    ['hinge.plot(model, "x.png")']
      = "hinge.plot: the run is a hinge.model; must be one that model:static{} or ...",
    ['hinge.plot(nil, "x.png")']
      = "hinge.plot: field 'what' is missing; give a table",
    ['hinge.plot("nowhere", "x.png")']
      = "hinge.plot: there is no 'nowhere/history.csv'; give a run, or the folder of one that has ended",
    ['hinge.plot(model:dynamic { dt = 1e-4, duration = 1e-3 }, "x.png")']
      = "hinge.plot: the run has taken no step yet; plot it after run:finish()",
    ['hinge.plot(model:dynamic { dt = 1e-4, duration = 1e-3, record = false }:finish(), "x.png")']
      = "hinge.plot: nothing was recorded; ask for probes before the first step (run:probe)",
    ['hinge.plot(model:dynamic { dt = 1e-4, duration = 1e-3, record = false }:finish(), { "kinetic" }, "x.png")']
      = "hinge.plot: nothing was recorded of 'kinetic' (record = false keeps no energies)",
    ['hinge.plot({ series = { { x = { 1 }, y = { 1 }, colour = "rad" } } }, "x.png")']
      = "hinge.plot: series 1: field 'colour' is 'rad'; must be black, ... from 0 to 1 (did you mean 'red'?)",
    ['hinge.plot({ series = { { x = { 1 }, y = { 1 }, colour = { 255, 0, 0 } } } }, "x.png")']
      = "hinge.plot: series 1: field 'colour' is a table; must be black, ... from 0 to 1",
    ['hinge.plot({ series = { { x = { 1 }, y = { 1 }, style = "dots" } } }, "x.png")']
      = "hinge.plot: series 1: field 'style' is 'dots'; must be one of 'line', 'points', 'line and points', "
        .. "'band', 'bars'",
    ['hinge.plot({ panels = { { series = { { x = { 1, 2 }, y = { 1 } } } } } }, "x.png")']
      = "hinge.plot: panel 1, series 1: field 'y' is 1 number; must hold as many as x, 2",
    ['hinge.plot({ panels = { { seris = {} } } }, "x.png")']
      = "hinge.plot: panel 1: unknown field 'seris' (did you mean 'series'?)...",
    ['hinge.plot({ panels = {} }, "x.png")']
      = "hinge.plot: field 'panels' is {}; must hold at least one { series =, ... }",
    ['hinge.plot({ series = {}, columns = 2 }, "x.png")']
      = "hinge.plot: unknown field 'columns'...",
    ['hinge.plot({ series = { { x = { "a" }, y = { 1 } }, { x = { 1 }, y = { 1 } } } }, "x.png")']
      = "hinge.plot: series 2: field 'x' is numbers; must hold names as in the series before: an axis has "
        .. "one or the other",
    ['hinge.plot({ series = { { x = { "a" }, y = { "b" } } } }, "x.png")']
      = "hinge.plot: field 'series' is names along x and y; must have numbers along one of the two axes",
    ['hinge.plot({ log_x = true, series = { { x = { "a" }, y = { 1 } } } }, "x.png")']
      = "hinge.plot: field 'x_range or log_x' is given; must be left out where x holds names",
    ['hinge.plot({ series = { { x = { 1 }, low = { 1 } } } }, "x.png")']
      = "hinge.plot: series 1: field 'high' is nil; must be a list of numbers",
    ['hinge.plot({ series = { { x = { 1 }, low = { 1 }, high = { 2 }, style = "line" } } }, "x.png")']
      = "hinge.plot: series 1: field 'style' is 'line'; must be 'band', which has low and high",
    ['hinge.plot({ series = { { x = { 1 }, y = { 1 }, labels = { "a", "b" } } } }, "x.png")']
      = "hinge.plot: series 1: field 'labels' is 2 texts; must hold as many as x, 1",
    ['hinge.plot({ x_range = { 2, 1 }, series = {} }, "x.png")']
      = "hinge.plot: field 'x_range' is {2, 1}; must be { low, high }, two numbers with low below high",
    ['hinge.plot({ y_range = { 0, 1 }, log_y = true, series = {} }, "x.png")']
      = "hinge.plot: field 'y_range' is {0, 1}; must be ..., above 0 on a logarithmic axis",
    ['hinge.plot({ share_x = true, panels = { { x_range = { 0, 1 }, series = { { x = { 1 }, y = { 1 } } } }, '
      .. '{ x_range = { 2, 4 }, series = { { x = { 3 }, y = { 1 } } } } } }, "x.png")']
      = "hinge.plot: field 'share_x' is true and panel 2 has x_range {2, 4}; must have the same as panel 1 in its "
        .. "column, which has x_range {0, 1}",
    ['hinge.plot({ share_x = true, columns = 2, panels = { { series = { { x = { 1 }, y = { 1 } } } }, '
      .. '{ series = { { x = { "a" }, y = { 1 } } } }, { log_x = true, series = { { x = { 3 }, y = { 1 } } } } } }, '
      .. '"x.png")']
      = "hinge.plot: field 'share_x' is true and panel 3 has a logarithmic x axis; must have the same as panel 1 in "
        .. "its "
        .. "column, which has a linear x axis",
    ['hinge.plot({ lines = { { x = 1, y = 2 } }, series = {} }, "x.png")']
      = "hinge.plot: line 1: field 'y' is 2; must be left out beside x; ...",
    ['hinge.plot({ lines = { {} }, series = {} }, "x.png")']
      = "hinge.plot: line 1: field 'x' is missing; give it or y; ...",
  } do
    local text = lua("run:step()\nprint(select(2, pcall(function()\n" .. call .. "\nend)))"):gsub("\n$", "")
    expect(support.says(text, ("script.lua:%d: %s"):format(line + 1, message)), "%s says\n  %s\n  wanted %s", call,
      text,
      message)
  end
  expect(not support.read(folder .. "/x.png") and not support.read(folder .. "/x.svg"), "nothing was drawn of that")
end)

checks.done()
