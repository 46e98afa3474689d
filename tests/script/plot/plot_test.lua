-- hinge.plot: histories of a run with one call, files by their ending, and what it says of values that are wrong.
--
-- Run: LUA_CPATH=BUILD_FOLDER/?.so lua5.4 tests/script/plot/plot_test.lua
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
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

-- `program`: another way to start Lua.
local function lua(script, program)
  support.write(folder .. "/script.lua", head .. script)
  local status, text = support.run(("cd %s && %s script.lua 2>&1"):format(support.quote(folder), program or "lua5.4"))
  equal(status, 0, text)
  return text
end

-- What gnuplot was told to draw, beside the picture.
local function commands(name)
  local text = support.read(folder .. "/" .. name .. ".gp")
  return expect(text and text:find "^# Draws ", "%s.gp is not there", name) and text or ""
end

local function holds(text, what, wanted)
  what = "'" .. what:gsub("'", "''") .. "'"
  return expect((text:find(what, 1, true) ~= nil) == (wanted ~= false), "%s %s in\n%s",
    wanted == false and "unexpected" or "no", what, text)
end

-- The series in a data file by their number, from 0: rows of numbers, and `gaps`, how many there are.
local function rows(name)
  local list, now = {}, nil
  for line in (support.read(folder .. "/" .. name .. ".dat") or ""):gmatch "([^\n]*)\n" do
    local index = tonumber(line:match "^# index (%d+):")
    if index then
      now = { gaps = 0, name = line:match ": (.*)$" }
      list[index] = now
    elseif line:find "%S" then
      local row = {}
      for v in line:gmatch "%S+" do row[#row + 1] = tonumber(v) end
      if now.empty and #now > 0 then now.gaps = now.gaps + 1 end
      now[#now + 1], now.empty = row, false
    elseif now then now.empty = true end
  end
  return list
end

case("a plot of a dynamic run has its curves, axes and units", function()
  local said = lua [[
run:finish()
hinge.plot(run, "all.png")
hinge.plot(run, { "kinetic", "elastic", sag, title = "A <blow>", width = 500, height = 400 }, "some.svg")
hinge.plot(run, { speed, x = sag }, "phase.pdf")
print(sag.unit, speed.unit, shear.unit, run.energy.kinetic, #sag.value)
]]
  equal(said:match "^(.-)\n" and said:match "^(%S+\t%S+\t%S+)", "m\tm/s\tN", "units of probes")
  local all = commands "all"
  for _, words in ipairs { "kinetic", "elastic", "work", "energy_error", "energy, J", "sag, mm", "speed, m/s",
    "node1_fz, kN", "time, ms" } do holds(all, words) end
  for _, words in ipairs { "plastic", "fracture", "contact", "contact_stored" } do holds(all, words, false) end
  equal(select(2, all:gsub("'time, ms'", "")), 1, "the panels share one axis of time")
  local picture = support.read(folder .. "/all.png") or ""
  expect(picture:sub(2, 4) == "PNG", "all.png is no PNG")
  equal((">I4I4"):unpack(picture, 17), 1200, "width of a picture, pixels")
  local some = commands "some"
  for _, words in ipairs { "kinetic", "elastic", "energy, J", "sag, mm", "A <blow>" } do holds(some, words) end
  for _, words in ipairs { "work", "speed, m/s" } do holds(some, words, false) end
  local drawing = support.read(folder .. "/some.svg") or ""
  expect(drawing:find 'width="500" height="400"' and drawing:find("<text>A &lt;blow>", 1, true),
    "some.svg: its size and words")
  expect((support.read(folder .. "/phase.pdf") or ""):find "^%%PDF", "phase.pdf is no PDF")
  local phase = commands "phase"
  holds(phase, "sag, mm")
  holds(phase, "speed, m/s")
end)

case("the data of a plot are the values of the probe", function()
  -- in the units of the axis, with 9 digits
  local said = lua [[
run:finish()
hinge.plot(run, { "sag" }, "sag.svg")
for i = 1, #sag.value, 50 do print(sag.time[i], sag.value[i]) end
]]
  local sag, i = rows "sag" [0] or {}, 1
  equal(#sag, 201, "rows of the sag")
  for time, value in said:gmatch "(%S+)\t(%S+)\n" do
    near((sag[i] or {})[1] or 0 / 0, 1e3 * tonumber(time), 1e-8 * 20, "time of a row, ms")
    near((sag[i] or {})[2] or 0 / 0, 1e3 * tonumber(value), 1e-8, "sag of a row, mm")
    i = i + 50
  end
  equal(i, 251, "rows that were compared, and 50 more")
end)

case("rows of a run end with its present state, and those of a long run are a part, evenly", function()
  local energies = lua [[
for step in run:steps() do if step.index == 77 then break end end
local core = require "hinge.core"
local rows = core.run_history(run)
local n = #rows.time
print(n, rows.time[n] == run.time, rows.kinetic[n] == run.energy.kinetic,
  rows.energy_error[n] == run.energy.energy_error)
local many = model:dynamic { dt = 1e-6, duration = 0.02, record = 1 }:finish()
rows = core.run_history(many)
n = #rows.time
local step, even = rows.time[2] - rows.time[1], true
for i = 2, n - 1 do even = even and math.abs(rows.time[i] - rows.time[i - 1] - step) < 1e-9 end
print(n > 4000 and n <= 8193, even, rows.time[n] == many.time)
]]
  equal(energies, "78\ttrue\ttrue\ttrue\ntrue\ttrue\ttrue\n", "rows in the middle of a run, and of a long one")
end)

case("a plot of a static run is drawn over the load factor", function()
  lua [[
local push = model:static { steps = 10 }
local down = push:probe { node = tip, "uz", name = "down" }
push:finish()
hinge.plot(push, "load.svg")
hinge.plot(push, { "elastic" }, "elastic.svg")
]]
  local load = commands "load"
  holds(load, "down, mm")
  holds(load, "load factor")
  holds(load, "time, s", false)
  local rising = rows "load" [0] or {}
  equal(#rising, 11, "points of the load-displacement curve")
  if #rising == 11 then
    expect(rising[11][1] < rising[1][1], "the tip falls")
    near(rising[11][2], 1, 1e-9, "the load factor at the end")
  end
  holds(commands "elastic", "elastic energy, J")
end)

case("the folder of a run that is over is plotted as the run was", function()
  os.execute("mkdir -p " .. support.quote(folder .. "/done"))
  support.write(folder .. "/done/history.csv", [[
time,factor,kinetic,elastic,work,energy_error,node2_uz,roof
0,0,0,0,0,0,0,1
0.5,0,2000,500,2500,0,0.01,2
1,0,4000,1000,5000,0,0.02,3
]])
  lua [[
hinge.plot("done", "done.svg")
hinge.plot("done", { "kinetic", "roof" }, "done_some.svg")
]]
  for _, words in ipairs { "kinetic", "elastic", "work", "energy, kJ", "node2_uz, mm", "roof", "time, s" } do
    holds(commands "done", words)
  end
  holds(commands "done", "energy_error", false)
  holds(commands "done_some", "kinetic energy, kJ")
end)

case("curves that would lie on the axis have a panel of their own, with their own unit", function()
  require "hinge"
  local plotted = require "hinge.plot.history".plot
  local history_csv = "time,factor,kinetic,elastic,work,energy_error,a,b\n"
  for i = 0, 10 do
    history_csv = history_csv .. ("%g,1,%g,%g,%g,%g,%g,%g\n"):format(i, 5e6 * i, 1e6 * i, 4e4 * i, 3 * i, i, 2 * i)
  end
  os.execute("mkdir -p " .. support.quote(folder .. "/scales"))
  support.write(folder .. "/scales/history.csv", history_csv)
  local function panels(what)
    local list = {}
    for i, panel in ipairs(plotted("test", folder .. "/scales", what).panels) do
      local names = {}
      for k, series in ipairs(panel.series) do names[k] = series.name or "-" end
      list[i] = panel.y_label .. ": " .. table.concat(names, " ")
    end
    return table.concat(list, "; ")
  end
  local energies = panels():match "^(.-); [^;]*; [^;]*$"
  equal(energies, "energy, MJ: kinetic elastic; energy, small, kJ: work; energy, small, J: energy_error",
    "three sizes in three panels: " .. panels())
  equal(panels { "kinetic", "energy_error" }, "energy, MJ: kinetic energy_error", "what is asked for stays together")
end)

case("numbers of an axis leave room between them", function()
  require "hinge"
  local layout = require "hinge.plot.layout"
  local em = 23
  local function fits(ends, width, step)
    local widest = 0
    for k = math.ceil(ends[1] / step), math.floor(ends[2] / step) do
      local text = ("%g"):format(k * step):gsub("e%+?(-?)0*(%d+)", "×10%1%2")
      widest = support.largest_of(widest, layout.width_of(text, em))
    end
    return widest < width * step / (ends[2] - ends[1])
  end
  for _, r in ipairs { { { 2.2e8, 3.1e8 }, 1000, true }, { { 0, 1 }, 1000, false }, { { 0, 9.9e8 }, 500, true },
    { { 1.2e-5, 5e-5 }, 500, true }, { { -3e7, 4e7 }, 700, true }, { { 0, 100 }, 900, false } } do
    local step = layout.step_of(r[1], r[2], em)
    equal(step ~= nil, r[3], ("a step of its own for %g to %g"):format(r[1][1], r[1][2]))
    if step then
      expect(fits(r[1], r[2], step), "%g to %g: a step of %g", r[1][1], r[1][2], step)
      expect((r[1][2] - r[1][1]) / step >= 2, "two marks or more: %g", step)
    end
  end
  equal(layout.step_of({ 1, 1 }, 500, em), nil, "no range")
end)

case("a plot has the units of probes as the run left them beside its history", function()
  -- Units of probes as the run left them beside its history; what is no list of probes is as good as none.
  for text, wanted in pairs {
    ['[{"name":"roof","node":1,"quantity":"az","unit":"m/s^2"}, {"name":"node2_uz","unit":"m"}]'] = { "roof, m/s²" },
    ['[{"name":"roof","node":1,"quantity":"uz","unit":"m"}]'] = { "displacement, m", "roof", "node2_uz" },
    ['[{"name":"roof","unit":"furlong"}, 3, {"unit":"m"}]'] = { "roof", "node2_uz, mm" },
    ['[{"name":"ro'] = { "roof", "node2_uz, mm" },
  } do
    support.write(folder .. "/done/probes.json", text)
    lua 'hinge.plot("done", "units.svg")'
    for _, words in ipairs(wanted) do holds(commands "units", words) end
  end
end)

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

case("bars, bands and panels are drawn as Lua gives them", function()
  lua [[
hinge.plot({ series = { { x = { "I", "II" }, y = { 1, 2 }, style = "bars", labels = { 1, "two" } } } }, "bars.svg")
hinge.plot({ series = { { x = { 0, 1 }, low = { 1, 2 }, high = { 2, 3 }, colour = { 1, 0, 0.5 } },
  { x = { 0, 1 }, y = { 1, 2 }, style = "line and points", colour = "#0a0B0c" } } }, "band.svg")
hinge.plot({ title = "both", columns = 2, panels = { { title = "left", series = { { x = { 0, 1 }, y = { 0, 1 } } } },
  { title = "right", series = { { x = { 0, 1 }, y = { 0, 1 } } }, lines = { { y = 2, name = "limit" } } } } },
  "panels.svg")
]]
  for _, words in ipairs { "I", "II", "1", "two" } do holds(commands "bars", words) end
  for _, words in ipairs { "#ff0080", "#0a0b0c", " with linespoints ", " with filledcurves " } do
    expect(commands "band":find(words, 1, true), "no %s in band.gp", words)
  end
  local band = rows "band"
  equal(#(band[0] or {}), 2, "rows of a band")
  equal(table.concat((band[0] or {})[1] or {}, " "), "0 1 2", "x, low and high of a band")
  for _, words in ipairs { "both", "left", "right", "limit" } do holds(commands "panels", words) end
end)

case("points have marks, and bars that end at a logarithmic axis", function()
  lua [[
hinge.plot({ log_y = true, series = { { x = { 1, 2 }, y = { 10, 20 }, low = { 0, 10 }, high = { 20, 400 },
  style = "points", mark = "square" }, { x = { 1, 2 }, y = { 10, 20 }, style = "points", mark = "open triangle" },
  { x = { false }, y = { false }, style = "line and points", name = "alone" } } }, "marks.svg")
]]
  local text = commands "marks"
  local foot, top = text:match "set yrange %[([^:]+):([^%]]+)%]"
  expect(tonumber(foot) > 5 and tonumber(foot) < 10, "the least is 10, and 0 has no place: %s", foot)
  expect(tonumber(top) > 400, "the highest end of a bar is in the picture: %s", top)
  expect(text:find(("($3 > 0 ? $3 : %s)"):format(foot), 1, true), "a bar from 0 begins at the axis")
  expect(text:find("points pt 5 ", 1, true) and text:find("points pt 8 ", 1, true), "a square and an open triangle")
  expect(text:find('NaN with linespoints [^\n]*title .alone'), "a name in the legend without a point")
  equal(table.concat((rows "marks"[0] or {})[1] or {}, " "), "1 10 0 20", "x, y and both ends")
end)

case("different ranges of different columns, or without share_x, are no error", function()
  lua [[
local function panel(low, high) return { x_range = { low, high }, series = { { x = { 0, 9 }, y = { 0, 1 } } } } end
hinge.plot({ share_x = true, columns = 2, panels = { panel(0, 1), panel(2, 3), panel(0, 1) } }, "ranges.svg")
hinge.plot({ panels = { panel(0, 1), panel(2, 3) } }, "ranges.svg")
]]
  expect(support.is_there(folder .. "/ranges.svg"), "no plot is drawn")
end)

case("values that are no numbers are gaps, and long curves keep their extremes", function()
  lua [[
hinge.plot({ series = {
  { name = "gaps", x = { 0, 1, 2, 3, 4 }, y = { 1, 2, 0/0, 2, 1 } },
  { name = "alone", x = { 0, 1, 2 }, y = { 1/0, 3, "none" } },
  { name = "band", x = { 0, 1, 2 }, low = { 0, 1, 0 }, high = { 2, 0/0, 2 } } } }, "values.png")
hinge.plot({ log_y = true, series = { { x = { 1, 2, 3 }, y = { 1, -5, 100 } } } }, "log.png")
local x, y = {}, {}
for i = 1, 300000 do x[i], y[i] = i, i == 123456 and 10 or math.sin(0.7 * i) end
hinge.plot({ series = { { x = x, y = y } } }, "long.png")
hinge.plot({ x_range = { 0.2, 0.8 }, series = { { x = { 0, 1 }, y = { -100, 100 } }, { x = { 0.5 }, y = { 7 } } } },
  "cut.png")
]]
  -- Bands are drawn beneath, so they come first in the data.
  local values = rows "values"
  for index, wanted in pairs { [0] = { "band", 2, 1 }, { "gaps", 4, 1 }, { "alone", 1, 0 }, { "alone", 1, 0 } } do
    local s = values[index] or { gaps = -1 }
    equal(("%s: %d rows, %d gaps"):format(s.name, #s, s.gaps), ("%s: %d rows, %d gaps"):format(table.unpack(wanted)),
      "series " .. index)
  end
  expect(commands "values":find("data index 3 with points", 1, true), "a value without a neighbour gets a dot")
  local log = rows "log" [0] or { gaps = -1 }
  equal(#log + 10 * log.gaps, 12, "rows and a gap on a logarithmic axis")
  -- A long history stays a small file with its extremes and ends.
  local long_rows, highest, lowest = rows "long" [0] or {}, -math.huge, math.huge
  for _, row in ipairs(long_rows) do
    highest, lowest = support.largest_of(highest, row[2]), support.smallest_of(lowest, row[2])
  end
  expect(#long_rows > 2000 and #long_rows < 10000, "%d rows of a long history", #long_rows)
  equal(highest, 10.0, "its highest value")
  near(lowest, -1, 1e-6, "its lowest value")
  equal((long_rows[1] or {})[1] or 0, 1.0, "its first row")
  equal((long_rows[#long_rows] or {})[1] or 0, 300000.0, "its last row")
  -- With x_range alone the y axis fits what it shows: here one value, 7.
  local low, high = commands "cut":match "set yrange %[([^:]*):([^%]]*)%]"
  low, high = tonumber(low) or 0, tonumber(high) or 0
  expect(low < 7 and low > 5 and high > 7 and high < 9, "the y axis of x_range: %s to %s", low, high)
  expect(commands "cut":find("set xrange [0.2:0.8]", 1, true), "the x axis of x_range")
end)

case("bars, legends and labels stand where they hide nothing", function()
  lua [[
hinge.plot({ series = { { name = "one", x = { "I", "II", "III" }, y = { 2, -1, 4 }, style = "bars" },
  { name = "two", x = { "I", "III" }, y = { 3, 1 }, style = "bars" } } }, "upright.png")
hinge.plot({ series = { { y = { "I", "II" }, x = { 2, -1 }, style = "bars", labels = { "2", "-1" } } } }, "lying.png")
local up, flat, all = { x = {}, y = {} }, { x = {}, y = {}, name = "flat" }, {}
for i = 0, 100 do flat.x[i + 1], flat.y[i + 1] = i, i < 50 and 10 or 0 end
hinge.plot({ series = { flat } }, "corner.png")
for k = 0, 20 do all[k + 1] = { x = { 0, 1 }, y = { k, k }, name = "level " .. k } end
hinge.plot({ series = all }, "full.png")
hinge.plot({ x_range = { 0, 3 }, series = { { x = { 1.5, 1.6 }, y = { 1, 1 }, style = "line and points",
  labels = { "the first", "the second" } } } }, "pair.png")
hinge.plot({ series = { { x = { 1, 2 }, y = { 1, 1 }, style = "points", labels = { "it's {a}_b `c` @d", "right" } } } },
  "labels.png")
]]
  -- Two bars share 0.8 of a place: each 0.4 wide with a gap of 6 %, their middles 0.2 beside the place.
  local upright = commands "upright"
  for _, words in ipairs { "using ($1-0.2):2:(0.376) with boxes", "using ($1+0.2):2:(0.376) with boxes",
    "set xtics ('I' 1, 'II' 2, 'III' 3)", "set xrange [0.5:3.5]" } do
    expect(upright:find(words, 1, true), "bars: no %s in\n%s", words, upright)
  end
  equal(table.concat((rows "upright" [1] or {})[2] or {}, " "), "3 1", "a bar of the third place")
  local lying = commands "lying"
  for _, words in ipairs { "using (0):2:(0):1:($2-0.376):($2+0.376) with boxxyerror", "set yrange [2.5:0.5]",
    "set label '2' at 2,1 left", "set label '-1' at -1,2 right" } do
    expect(lying:find(words, 1, true), "bars that lie: no %s in\n%s", words, lying)
  end
  expect(commands "corner":find("set key top right", 1, true), "a legend where nothing is drawn")
  expect(commands "full":find("set key at graph 1.01", 1, true), "a legend beside a frame that is full")
  -- Labels of near points go apart: neither stands over the other's point.
  expect(commands "pair":find("'the first' at 1.5,1 right", 1, true), "the label of a point at the left")
  expect(commands "pair":find("'the second' at 1.6,1 left", 1, true), "the label of a point at the right")
  expect(commands "labels":find([[set label "it's {a}_b \140c\140 \100d" at 1,1]], 1, true),
    "a label is a text, whatever is in it")
end)

case("gnuplot draws what the script says, and runs none of its texts", function()
  -- No text of a script becomes a command, neither of gnuplot nor of a shell.
  local said = lua [[
local evil = "a'; system('touch owned') \n system('touch owned') `touch owned` \"`touch owned`\" @x \\"
hinge.plot({ title = evil, x_label = evil, y_label = evil, lines = { { y = 1, name = evil } },
  series = { { name = evil, x = { "b", evil }, y = { 1, 2 }, style = "bars", labels = { evil, evil } },
    { name = evil, x = { evil }, y = { 1 }, style = "points", labels = { evil } } } }, "evil.png")
]]
  expect(support.read(folder .. "/evil.png"), "texts with quotes: %s", said)
  expect(not support.read(folder .. "/owned"), "a text of a plot was run")
  -- Its own file draws it again, and the user's settings are not read.
  support.write(folder .. "/.gnuplot", "set title 'mine'\nexit\n")
  said = lua [[ hinge.plot({ series = { { x = { 0, 1 }, y = { 0, 1 } } } }, "again.svg") ]]
  local first = support.read(folder .. "/again.svg")
  os.execute(("cd %s && rm again.svg && HOME=. gnuplot -d again.gp"):format(support.quote(folder)))
  expect(first and support.read(folder .. "/again.svg") == first, "again.gp draws again.svg: %s", said)
  -- Where it is missing, the run goes on and the files for it are there.
  said = lua('hinge.plot({ series = { { x = { 0 }, y = { 0 } } } }, "none.png")', "PATH=/nowhere $(command -v lua5.4)")
  expect(said:find("note: none.png not drawn: plots need the program gnuplot, which is not installed: "
    .. "apt-get install gnuplot-nox; none.gp is there for it", 1, true), "without gnuplot: %s", said)
  expect(support.read(folder .. "/none.gp") and not support.read(folder .. "/none.png"), "files without gnuplot")
  said = lua [[ hinge.plot({ log_x = true, series = { { x = { -1 }, y = { 1 } } } }, "nothing.png") ]]
  expect(said:find("nothing.png not drawn: plot: nothing to draw; give at least one finite point, positive on a "
    .. "logarithmic axis", 1, true), "nothing to draw: %s", said)
end)

case("wrong plots are refused at the script's line", function()
  local hinge = require "hinge"
  local model, tip = require "scenes".cantilever { force = { 0, 0, -1000 } }
  local function dynamic(record) return model:dynamic { dt = 1e-4, duration = 1e-3, record = record } end
  local run, bare = dynamic(), dynamic(false):finish()
  run:probe { node = tip, "uz", name = "sag" }
  run:step()
  local function series(...) return { series = { ... } } end
  local point, named = { x = { 1 }, y = { 1 } }, { x = { "a" }, y = { 1 } }
  local function in_columns(columns, ...) return { share_x = true, columns = columns, panels = { ... } } end
  local with, shared = require "scenes".with, "field 'share_x' is true and panel %d has %s"
  for _, row in ipairs {
    -- words of the message, what is plotted, and what of it
    { { "item 1 'kinetik'", "did you mean 'kinetic'", "there are kinetic", "sag" }, run, { "kinetik" } },
    { { "item 1 is 42", "a probe of the run or one of" }, run, { 42 } },
    { { "field 'titel'", "did you mean 'title'", "there are columns, height, title, width, x" }, run, { titel = "a" } },
    { { "field 'x' 'sog'", "did you mean 'sag'" }, run, { "kinetic", x = "sog" } },
    { "field 'choice' is 5; must be a table", run, 5 },
    { { "the run is a hinge.model", "model:static{} or" }, model },
    { "there is no 'nowhere/history.csv'; give a run, or the folder", "nowhere" },
    { "has taken no step yet; plot it after run:finish()", dynamic() },
    { { "nothing was recorded", "run:probe" }, bare },
    { { "nothing was recorded of 'kinetic'", "record = false" }, bare, { "kinetic" } },
    { { "series 1", "'colour' is 'rad'", "from 0 to 1", "mean 'red'" }, series(with(point, { colour = "rad" })) },
    { { "series 1", "'colour' is a table", "from 0 to 1" }, series(with(point, { colour = { 255, 0, 0 } })) },
    { { "series 1", "'style' is 'dots'", "'line', 'points', 'line and points', 'band', 'bars'" },
      series(with(point, { style = "dots" })) },
    { { "panel 1, series 1", "'y' is 1 number", "many as x, 2" }, { panels = { series { x = { 1, 2 }, y = { 1 } } } } },
    { { "panel 1: unknown field 'seris'", "did you mean 'series'" }, { panels = { { seris = {} } } } },
    { { "'panels' is {}", "at least one { series =" }, { panels = {} } },
    { "unknown field 'columns'", { series = {}, columns = 2 } },
    { { "series 2: field 'x' is numbers", "names as in the series before" }, series(named, point) },
    { { "names along x and y", "numbers along one of the two axes" }, series { x = { "a" }, y = { "b" } } },
    { { "'x_range or log_x' is given", "left out where x holds names" }, with(series(named), { log_x = true }) },
    { { "series 1: field 'high' is nil", "a list of numbers" }, series { x = { 1 }, low = { 1 } } },
    { { "series 1", "'style' is 'line'", "'band', 'points' or 'line and points', which have low and high" },
      series { x = { 1 }, low = { 1 }, high = { 2 }, style = "line" } },
    { { "series 1", "'high' is missing", "a bar has low and high" },
      series { x = { 1 }, y = { 1 }, low = { 1 }, style = "points" } },
    { { "series 1", "'low' is 2 numbers", "as many as x, 1" },
      series { x = { 1 }, y = { 1 }, low = { 1, 2 }, high = { 1 }, style = "points" } },
    { { "series 1", "'mark' is 'sqare'", "mean 'square'" },
      series { x = { 1 }, y = { 1 }, style = "points", mark = "sqare" } },
    { { "series 1", "'mark' is 'square'", "only points have one" }, series(with(point, { mark = "square" })) },
    { { "series 1", "'labels' is 2 texts", "as many as x, 1" }, series(with(point, { labels = { "a", "b" } })) },
    { { "'x_range' is {2, 1}", "two numbers with low below high" }, with(series(), { x_range = { 2, 1 } }) },
    { { "'y_range' is {0, 1}", "above 0 on a logarithmic axis" },
      with(series(), { y_range = { 0, 1 }, log_y = true }) },
    { { shared:format(2, "x_range {2, 4}"), "the same as panel 1 in its column", "x_range {0, 1}" },
      in_columns(1, with(series(point), { x_range = { 0, 1 } }), with(series(point), { x_range = { 2, 4 } })) },
    { { shared:format(3, "a logarithmic x axis"), "the same as panel 1 in its column", "a linear x axis" },
      in_columns(2, series(point), series(named), with(series(point), { log_x = true })) },
    { { "line 1: field 'y' is 2", "left out beside x" }, { lines = { { x = 1, y = 2 } }, series = {} } },
    { { "line 1: field 'x' is missing", "give it or y" }, { lines = { {} }, series = {} } },
  } do
    checks.refused(row[1], function()
      if row[3] then hinge.plot(row[2], row[3], "x.png") else hinge.plot(row[2], "x.png") end
    end)
  end
  checks.refused("field 'what' is missing; give a table", function() hinge.plot(nil, "x.png") end)
  checks.refused("field 'filename' is missing; give a string", function() hinge.plot(run) end)
  for _, name in ipairs { "x.eps", "../x.svg" } do
    checks.refused({ "filename is '" .. name .. "'", "a plain name ending in .png, .svg or .pdf" },
      function() hinge.plot(run, name) end)
  end
  checks.refused("takes no further argument, got also 3", function() hinge.plot(run, {}, "x.svg", 3) end)
  expect(not support.read "x.png" and not support.read "x.gp", "nothing was drawn of that")
end)

checks.done()
