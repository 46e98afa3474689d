-- Ground motion from files: files of each format that the test writes come back to rounding; the cut, the scale, the
-- baseline; what is wrong in a file is said with its line. Response spectra: spectrum_test.lua.
--
-- Run: lua5.4 tests/script/actions/records_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local scenes = require "scenes"
local motions = require "actions.motions"
local hinge = require "hinge"
local records = require "hinge.actions.records"
local checks = support.checks "records"
local case, near, equal, expect = checks.case, checks.near, checks.equal, checks.expect

local write, folder = support.writer()
local g, pi = 9.80665, math.pi
local sampled, ricker = motions.sampled, motions.ricker

local function text_of(values, format, per_line)
  local parts = {}
  for i, value in ipairs(values) do
    parts[i] = format:format(value) .. ((i % per_line == 0 or i == #values) and "\n" or "")
  end
  return table.concat(parts)
end

local function largest_difference(a, b, factor)
  local worst = #a == #b and 0 or 0 / 0
  for i = 1, #a do worst = support.largest_of(worst, math.abs(a[i] - (factor or 1) * b[i])) end
  return worst
end

-- Formats -------------------------------------------------------------------------------------------------------------

local pulse = sampled(ricker(0.5, 1), 0.005, 403) -- of any unit; its largest value is 1

local heads = {
  new = "PEER NGA STRONG MOTION DATABASE RECORD\n Nowhere, 1/1/2000, Made up, 180 \nACCELERATION TIME SERIES IN UNITS "
    .. "OF G\nNPTS=%6d, DT= .00500 SEC,\n",
  old = "PEER NGA STRONG MOTION DATABASE RECORD\nNowhere, 1/1/2000, Made up, 180\nACCELERATION TIME HISTORY IN UNITS "
    .. "OF G. FILTER POINTS: HP=0.1 Hz LP=40 Hz\n %d    0.0050    NPTS, DT\n",
}

case("numbers of AT2 that touch, Fortran's D, and ends of lines of Windows", function()
  local file = write("touch.at2", (heads.new:format(4) .. "0.1E+00-0.25E-01-.5D+00\n  .125\n\n"):gsub("\n", "\r\n"))
  local r = records.read { file = file }
  near(largest_difference(r.acceleration, { 0.1, -0.025, -0.5, 0.125 }, g), 0, 1e-15, "values")
  equal(r.name, "Nowhere, 1/1/2000, Made up, 180", "name")
end)

-- A header of ESM. `changes` puts other values for its keys; false leaves a line out.
local function esm_head(n, changes)
  local keys = { "EVENT_NAME", "EVENT_ID", "EVENT_DATE_YYYYMMDD", "VS30_M/S", "STATION_CODE", "SAMPLING_INTERVAL_S",
    "NDATA", "DURATION_S", "STREAM", "UNITS", "PGA_CM/S^2", "DATA_TYPE", "PROCESSING", "USER5" }
  local values = { EVENT_NAME = "MADE UP", STATION_CODE = "XYZ", SAMPLING_INTERVAL_S = "0.005000", NDATA = n,
    STREAM = "HNE", UNITS = "cm/s^2", DATA_TYPE = "ACCELERATION", PROCESSING = "manual (somebody: 2011)" }
  for key, value in pairs(changes or {}) do values[key] = value end
  local lines = {}
  for _, key in ipairs(keys) do
    if values[key] ~= false then lines[#lines + 1] = ("%s: %s\n"):format(key, values[key] or "") end
  end
  return table.concat(lines)
end

-- A file of K-NET: a signal in m/s^2 as counts about an offset.
local knet_factor = 3920 / 6182761 * 0.01 -- m/s^2
local function knet(values, changes)
  local v = { ["Origin Time"] = "2006/01/18 23:25:00", ["Station Code"] = "ABC001", ["Sampling Freq(Hz)"] = "100Hz",
    ["Duration Time(s)"] = ("%g"):format(#values / 100), ["Dir."] = "N-S", ["Scale Factor"] = "3920(gal)/6182761" }
  for key, value in pairs(changes or {}) do v[key] = value end
  local lines = {}
  for i, key in ipairs { "Origin Time", "Lat.", "Long.", "Depth. (km)", "Mag.", "Station Code", "Station Lat.",
    "Station Long.", "Station Height(m)", "Record Time", "Sampling Freq(Hz)", "Duration Time(s)", "Dir.",
    "Scale Factor", "Max. Acc. (gal)", "Last Correction", "Memo." } do
    lines[i] = ("%-18s%s\n"):format(key, v[key] or "")
  end
  local counts = {}
  for i, value in ipairs(values) do counts[i] = math.floor(8004 + value / knet_factor + 0.5) end
  return table.concat(lines) .. text_of(counts, "%9d", 8)
end

case("each format comes back to the digits that were written, and is told from the others", function()
  local sine = sampled(function(t) return math.sin(4 * pi * t) end, 0.01, 400) -- whole periods: its mean is 0
  local peer = text_of(pulse, "%15.7E", 5)
  for _, of in ipairs {
    { "PEER AT2", "Nowhere, 1/1/2000, Made up, 180", heads.new:format(#pulse) .. peer, pulse, g, 0.5e-7 * g },
    { "PEER AT2", "Nowhere, 1/1/2000, Made up, 180", heads.old:format(#pulse) .. peer, pulse, g, 0.5e-7 * g },
    { "ESM", "MADE UP, XYZ HNE", esm_head(#pulse) .. text_of(pulse, "%.6f", 1), pulse, 0.01, 0.5e-6 * 0.01 },
    -- half a count, and half a one of the mean
    { "K-NET", "ABC001 N-S, 2006/01/18 23:25:00", knet(sine), sine, 1, knet_factor, 0.01 },
    { "K-NET", "ABC001 N-S, 2006/01/18 23:25:00", knet(sine, { ["Duration Time(s)"] = "3.99" }), sine, 1, knet_factor,
      0.01 }, -- a duration from the first value to the last
  } do
    local format, name, text, values, factor, within, dt = table.unpack(of)
    for _, given in ipairs { { format = format }, {} } do
      local r = records.read { file = write("pulse", text), format = given.format }
      equal(r.format, format, "format")
      equal(r.name, name, format .. ": name")
      near(r.dt, dt or 0.005, 1e-15, format .. ": dt")
      near(largest_difference(r.acceleration, values, factor), 0, within, format .. ": values")
      near(r.duration, (#values - 1) * (dt or 0.005), 1e-12, format .. ": duration")
      near(r.peak, factor * support.largest_of(table.unpack(values)), within, format .. ": peak")
      local sum = 0
      for _, value in ipairs(r.acceleration) do sum = sum + value end
      if format == "K-NET" then near(sum / #values, 0, 1e-12, "K-NET: mean") end
    end
  end
end)

case("columns: one or two, with blanks, commas or tabs, in three units", function()
  local factors = { ["m/s^2"] = 1, g = g, ["cm/s^2"] = 0.01 }
  for unit, factor in pairs(factors) do
    local r = records.read { file = write("one.txt", "# a comment\nacceleration 1 2\n" .. text_of(pulse, "%.17g", 1)),
      unit = unit, dt = 0.005 }
    near(largest_difference(r.acceleration, pulse, factor), 0, 1e-15, unit .. ": one column")
    equal(r.format, "columns", unit)
    equal(r.name, "one.txt", unit)
    for _, separator in ipairs { " ", ",", "\t", " , ", "   " } do
      local rows = { 'time,"a"' }
      for i, value in ipairs(pulse) do rows[i + 1] = ("%.3f%s%.17g"):format((i - 1) * 0.005, separator, value) end
      table.insert(rows, 5, "# in the middle")
      r = records.read { file = write("two.txt", "\239\187\191" .. table.concat(rows, "\n")), format = "columns",
        unit = unit }
      near(largest_difference(r.acceleration, pulse, factor), 0, 1e-15, unit .. ": two columns, " .. separator)
      near(r.dt, 0.005, 1e-12, unit .. ": dt")
    end
  end
  local rows = {}
  for i = 1, 100 do rows[i] = ("%.4f 1"):format(3 + i / 256) end -- a step of 0.00390625 s with four decimals
  local r = records.read { file = write("rounded.txt", table.concat(rows, "\n")), unit = "g" }
  near(r.dt, 1 / 256, 1e-6, "times with few digits: 5e-5 s over 99 steps")
end)

-- What is done to the values ------------------------------------------------------------------------------------------

local ramp = write("ramp.txt", text_of(sampled(function(t) return 0.1 + t end, 0.1, 11), "%.17g", 1)) -- 0.1 ... 1.1
local function read_ramp(options)
  options.file, options.unit, options.dt = ramp, "m/s^2", 0.1
  return records.read(options)
end

case("a record is cut, scaled to a factor or to a peak", function()
  local r = read_ramp { from = 0.3, to = 0.7 }
  near(largest_difference(r.acceleration, { 0.4, 0.5, 0.6, 0.7, 0.8 }), 0, 1e-14, "from and to are kept")
  near(r.duration, 0.4, 1e-12, "duration")
  r = read_ramp { from = 0.25, to = 0.65 }
  near(largest_difference(r.acceleration, { 0.4, 0.5, 0.6, 0.7 }), 0, 1e-14, "between the values")
  near(#read_ramp { from = 0.5 }.acceleration, 6, 0, "from alone")
  near(#read_ramp { to = 0.5 }.acceleration, 6, 0, "to alone")
  near(#read_ramp { to = 1 }.acceleration, 11, 0, "to the end")
  near(read_ramp { scale = -2 }.acceleration[11], -2.2, 1e-14, "scale")
  near(read_ramp { peak = 3 }.acceleration[1], 3 / 11, 1e-14, "peak")
  near(read_ramp { peak = 3, to = 0.4 }.peak, 3, 1e-14, "the peak of what is left")
end)

case("the displacement is that of hinge.ground, and the end is said", function()
  local r = read_ramp {}
  local same = hinge.ground { dt = 0.1, acceleration = r.acceleration }
  for _, t in ipairs { -1, 0, 0.33, 1, 5 } do near(r.displacement(t), same(t), 0, "at " .. t) end
  near(r.end_velocity, 0.1 + 0.5, 1e-14, "a = 0.1 + t: v = 0.1 t + t^2 / 2")
  near(r.end_displacement, 0.05 + 1 / 6, 1e-14, "u = 0.05 t^2 + t^3 / 6")
  expect(not pcall(function() return r.displacment end), "a field that is not there is an error")
end)

-- Velocities at the values of a record.
local function velocities(r)
  local v = { 0 }
  for i = 2, #r.acceleration do
    v[i] = v[i - 1] + (r.acceleration[i - 1] + r.acceleration[i]) * r.dt / 2
  end
  return v
end
local function squares(v)
  local sum = 0
  for _, x in ipairs(v) do sum = sum + x * x end
  return sum
end

-- A pulse on a baseline, as a file.
local function drifting(c)
  local f = ricker(0.5, 1)
  local values = sampled(function(t) return f(t) + c[1] + c[2] * t + c[3] * t * t end, 0.01, 301)
  return write("drift.txt", text_of(values, "%.17g", 1))
end
local kinds = { "constant", "linear", "quadratic" }

case("a baseline takes its own polynomial away", function()
  for degree, kind in ipairs(kinds) do
    local c = { 0.3, degree > 1 and -0.2 or 0, degree > 2 and 0.07 or 0 }
    local values = sampled(function(t) return c[1] + c[2] * t + c[3] * t * t end, 0.01, 301)
    local file = write("polynomial.txt", text_of(values, "%.17g", 1))
    local r = records.read { file = file, unit = "m/s^2", dt = 0.01, baseline = kind }
    near(r.peak, 0, 1e-13, kind .. " of a polynomial of its own degree")
    expect(degree == 3 or records.read { file = drifting { 0, 0, 0.1 }, unit = "m/s^2", dt = 0.01,
      baseline = kind }.peak > 0.1, "%s of a pulse", kind)
  end
end)

case("a baseline ends at rest, and no other of its degree has a smaller sum of v^2", function()
  local file, before = drifting { 0.3, -0.2, 0.05 }, math.huge
  local none = records.read { file = file, unit = "m/s^2", dt = 0.01 }
  expect(math.abs(none.end_velocity) > 0.1, "without a baseline it ends with %g m/s", none.end_velocity)
  for degree, kind in ipairs(kinds) do
    local r = records.read { file = file, unit = "m/s^2", dt = 0.01, baseline = kind }
    near(r.end_velocity, 0, 1e-13, kind .. ": velocity at the end")
    near(r.displacement(10) - r.displacement(3), 0, 1e-12, kind .. ": it stays where it is")
    local v = velocities(r)
    local least = squares(v)
    expect(least < before, "%s: %g is less than %g of the degree below", kind, least, before)
    before = least
    -- b: other velocities that end at 0, of a linear and of a quadratic acceleration
    for k = 1, degree - 1 do
      for _, small in ipairs { -1e-3, 1e-3 } do
        local other = {}
        for i, x in ipairs(v) do
          local s = (i - 1) / (#v - 1)
          other[i] = x + small * s * (1 - s) * (k == 2 and 1 - 2 * s or 1)
        end
        expect(squares(other) > least, "%s: another polynomial has %.12g, not %.12g", kind, squares(other), least)
      end
    end
  end
end)

case("a baseline changes a record that is in order a little at most", function()
  local file = write("still.txt", text_of(sampled(ricker(0.5, 1.5), 0.01, 301), "%.17g", 1))
  for _, kind in ipairs(kinds) do
    local r = records.read { file = file, unit = "m/s^2", dt = 0.01, baseline = kind, scale = 2 }
    -- the pulse has a velocity that is odd about its middle: a quadratic takes a little of it
    near(r.peak, 2, kind == "quadratic" and 0.05 or 1e-10, kind)
    near(r.end_velocity, 0, 1e-13, kind .. ": end")
  end
end)

case("model:move takes the displacement of a record", function()
  local r = read_ramp { baseline = "constant", scale = 5 }
  local model, _, _, foot = scenes.cantilever { along = { 0, 0, 1 } }
  local second = model:node { 0, 1, 0 }
  model:member { second, model:node { 0, 1, 1 }, section = scenes.square, material = scenes.elastic }
  model:fix(second)
  model:move { node = { foot, second }, x = r.displacement }
  local run = model:dynamic { dt = "auto", duration = 0.02 }:finish()
  equal(run.verdict, "completed", run.reason)
  local moved = r.displacement(run.time)
  near(foot:displacement(run), moved, 1e-9 * math.abs(moved), "foot")
  near(second:displacement(run), moved, 1e-9 * math.abs(moved), "the other foot")
  expect(math.abs(moved) > 1e-4, "it moves by %g m", moved)
end)

-- Errors --------------------------------------------------------------------------------------------------------------

local function wrong(options, ...) checks.refused({ "hinge.record.read: ", ... }, records.read, options) end

case("options of record.read that are wrong", function()
  wrong({}, "field 'file' is missing; give a string")
  wrong({ file = folder .. "nothing.at2" }, "field 'file': cannot open ", "nothing.at2: No such file or directory")
  wrong({ file = folder }, "field 'file': cannot read ", ": Is a directory")
  wrong({ file = write("empty.txt", " \n\n") }, "empty.txt' is empty")
  wrong({ file = ramp, format = "columns", dt = 1 }, "field 'unit' is missing; give one of cm/s^2, g, m/s^2")
  wrong({ file = ramp, unit = "gal", dt = 1 }, "field 'unit' is 'gal'; must be one of cm/s^2, g, m/s^2")
  wrong({ file = ramp, dt = 1 }, "ramp.txt', line 1: the text is not that of PEER AT2, ESM or K-NET; for columns of "
    .. "numbers give unit = 'm/s^2', 'g' or 'cm/s^2'", "the line is '0.1")
  wrong({ file = ramp, unit = "g" }, "field 'dt' is missing; file '", "ramp.txt' has one column")
  local zeros, large = write("zeros.txt", "0\n0\n0\n"), write("large.txt", "1e300\n0\n0\n")
  for words, options in pairs {
    ["field 'format' is 'AT2'; must be one of ESM, K-NET, PEER AT2, columns"] = { format = "AT2" },
    ["field 'dt' is -1 s; must be a number above 0 s"] = { dt = -1 },
    ["give 'scale' or 'peak', not both"] = { scale = 2, peak = 2 },
    ["field 'peak' is 0 m/s^2; must be a number above 0 m/s^2"] = { peak = 0 },
    ["field 'to' is 1.2 s; the record lasts 1 s"] = { to = 1.2 },
    ["field 'from' is 0.5 s; must be below 'to', 0.4 s"] = { from = 0.5, to = 0.4 },
    ["field 'from' is 2 s; must be below the record's end, 1 s"] = { from = 2 },
    ["fewer than two values from 0.41 s to 0.55 s; the record has one every 0.1 s"] = { from = 0.41, to = 0.55 },
    ["field 'baseline': there are 4 values, and this baseline needs 5"] = { to = 0.3, baseline = "quadratic" },
    ["field 'baseline' is 'cubic'; must be one of none, constant, linear, quadratic"] = { baseline = "cubic" },
    ["field 'peak' is 2 m/s^2; all values of the record are 0"] = { file = zeros, peak = 2 },
    ["field 'scale' is 1e+10; a value is infinite then"] = { file = large, scale = 1e10 },
  } do
    wrong(scenes.with({ file = ramp, unit = "g", dt = 0.1 }, options), words)
  end
  local at2 = write("good.at2", heads.new:format(2) .. "1 2\n")
  for field, value in pairs { unit = "g", dt = 0.1 } do
    wrong({ file = at2, [field] = value }, "field '" .. field .. "' is for the format 'columns'; file '",
      "good.at2' is read as PEER AT2, whose text has it")
  end
end)

-- A file is refused with this line and these words.
local function wrong_line(format, text, line, ...)
  local columns = format == "columns"
  wrong({ file = write("wrong.txt", text), format = format, unit = columns and "g" or nil,
    dt = columns and not text:find "%d %d" and 0.1 or nil }, "wrong.txt', line " .. line .. ": ", ...)
end

case("files of PEER AT2 that are wrong", function()
  local good = heads.new:format(2) .. "1 2\n"
  wrong_line("PEER AT2", "1\n2\n3\n4\n", 4, "not a file of PEER AT2, whose fourth line is ", "the line is '4'")
  wrong_line("PEER AT2", good:gsub("ACCELERATION", "VELOCITY"), 3, "the line before NPTS must say ACCELERATION and "
    .. "UNITS OF G", "the line is 'VELOCITY TIME SERIES IN UNITS OF G'")
  wrong_line("PEER AT2", good:gsub("OF G", "OF GAL"), 3, "the line before NPTS must say ")
  wrong_line("PEER AT2", good:gsub("%.00500", "0.0"), 4, "DT must be a number above 0")
end)

for _, text in ipairs { "NaN", "nan", "inf", "-Infinity", "*****", "0x10", "1e999", "1,5", "1.2.3", "abc" } do
  case("a value that is no finite number: " .. text, function()
    local said = "'" .. text .. "' is not a finite number"
    wrong_line("PEER AT2", heads.new:format(4) .. "1 2\n3 " .. text .. "\n", 6, said .. "; the line is '3 " .. text)
    wrong_line("ESM", esm_head(2) .. "1\n" .. text .. "\n", 16, said)
    wrong_line("K-NET", knet { 0, 0 } .. text, 19, said)
    if text ~= "1,5" then
      wrong_line("columns", "# a\n1\n" .. text, 3, said)
      local word = text == "abc"
      wrong_line("columns", "# a\n" .. (word and "1\n" or "") .. text .. "\n1", word and 3 or 2, said)
    end
  end)
end

case("files that have not as many values as the header says", function()
  for words, text in pairs {
    ["5 values (line 4: 'NPTS=     5, DT= .00500 SEC,'), and there are 4"] = heads.new:format(5) .. "1 2 3 4\n",
    ["3 values (line 4: '3    0.0050    NPTS, DT'), and there are 4"] = heads.old:format(3) .. "1 2 3 4\n",
    ["3 values (line 7: 'NDATA: 3'), and there are 2"] = esm_head(3) .. "1\n2\n",
    ["1000 values (line 12: 'Duration Time(s)  10'), and there are 4"] =
      knet({ 0, 0, 0, 0 }, { ["Duration Time(s)"] = "10" }),
  } do
    wrong({ file = write("number.txt", text) }, "number.txt': the header says " .. words)
  end
end)

case("files of ESM that are wrong", function()
  wrong_line("ESM", "1\n2\n", 1, "not a file of ESM, which begins with lines such as 'EVENT_NAME: ...'")
  for _, key in ipairs { "DATA_TYPE", "UNITS", "SAMPLING_INTERVAL_S", "NDATA" } do
    wrong_line("ESM", esm_head(2, { [key] = false }) .. "1\n2\n", 14, "the header ends here, and has no line '" .. key)
  end
  wrong_line("ESM", esm_head(2, { DATA_TYPE = "VELOCITY" }) .. "1\n2\n", 12, "only ACCELERATION is read",
    "the line is 'DATA_TYPE: VELOCITY'")
  wrong_line("ESM", esm_head(2, { UNITS = "cm/s" }) .. "1\n2\n", 10, "the unit of a file of ESM must be cm/s^2")
  wrong_line("ESM", esm_head(2, { SAMPLING_INTERVAL_S = "" }) .. "1\n2\n", 6, "must be a number above 0")
end)

case("files of K-NET that are wrong", function()
  wrong_line("K-NET", "1\n2\n", 1, "not a file of K-NET, which begins with 'Origin Time'")
  wrong_line("K-NET", knet({ 0, 0 }):gsub("Memo%.", "Note."), 17, "the header of K-NET has 17 lines, of which the last "
    .. "begins with 'Memo.'")
  wrong_line("K-NET", knet({ 0, 0 }):gsub("Scale Factor", "Scale Faktor"), 17, "has no line 'Scale Factor'")
  wrong_line("K-NET", knet({ 0, 0 }, { ["Scale Factor"] = "3920(kine)/6182761" }), 14, "must be a number and '(gal)/' "
    .. "and a number")
  wrong_line("K-NET", knet({ 0, 0 }, { ["Sampling Freq(Hz)"] = "100" }), 11, "must be a number above 0")
end)

case("files of columns that are wrong", function()
  wrong_line("columns", "1 2 3\n", 1, "there are 3 numbers; one column or two are read; the line is '1 2 3'")
  wrong_line("columns", "0 2\n1\n2 2\n", 2, "there are 1 numbers, and 2 in the first row (line 1); the line is '1'")
  wrong_line("columns", "0 2\n0.1,,3\n", 2, "there is no number before a comma; the line is '0.1,,3'")
  wrong_line("columns", "# t a\n0 2\n0.1 2\n0.3 3\n0.4 1\n", 3, "the times in the first column must grow by equal "
    .. "steps; over all of them the step is 0.133333 s, so the time here must be 0.133333 s; the line is '0.1 2'")
  wrong_line("columns", "0 2\n0 3\n", 1, "the times in the first column must grow")
  wrong({ file = write("short.txt", "# only one\n0 2\n"), unit = "g" }, "short.txt' has 1 row of numbers")
  wrong({ file = write("two.txt", "0 2\n1 2\n"), unit = "g", dt = 0.1 }, "field 'dt' is 0.1 s; file '",
    "two.txt' has two columns, and the first one is the time; leave dt out")
end)

checks.done()
