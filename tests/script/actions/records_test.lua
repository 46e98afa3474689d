-- Ground motion from files, and response spectra: files of each format that the test writes come back to rounding; the
-- cut, the scale, the baseline; what is wrong in a file is said with its line; spectra against closed forms.
--
-- Run: lua5.4 tests/script/actions/records_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local hinge = require "hinge"
local records, spectrum = require "hinge.actions.records", require "hinge.actions.spectrum"
local checks = support.checks "records"
local case, near, equal, expect = checks.case, checks.near, checks.equal, checks.expect

local folder = support.temporary_folder()
local g, pi = 9.80665, math.pi

local function write(name, text)
  support.write(folder .. "/" .. name, text)
  return folder .. "/" .. name
end

-- Values of a function of time every dt.
local function sampled(f, dt, n)
  local list = {}
  for i = 1, n do list[i] = f((i - 1) * dt) end
  return list
end

-- A Ricker pulse about `middle` with 1 / `width` Hz at its peak: it leaves no velocity behind.
local function ricker(width, middle)
  return function(t)
    local x = (pi * (t - middle) / width) ^ 2
    return (1 - 2 * x) * math.exp(-x)
  end
end
local function sine(period) return function(t) return math.sin(2 * pi * t / period) end end

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

case("PEER AT2 of both headers comes back to the digits that were written", function()
  for name, head in pairs(heads) do
    for _, format in ipairs { "PEER AT2", "none" } do
      local file = write("pulse.at2", head:format(#pulse) .. text_of(pulse, "%15.7E", 5))
      local r = records.read { file = file, format = format ~= "none" and format or nil }
      equal(r.format, "PEER AT2", name .. ": format")
      near(r.dt, 0.005, 1e-15, name .. ": dt")
      near(largest_difference(r.acceleration, pulse, g), 0, 0.5e-7 * g, name .. ": values with 8 digits")
      equal(r.name, "Nowhere, 1/1/2000, Made up, 180", name .. ": name")
      near(r.peak, g, 1e-12, name .. ": peak")
      near(r.duration, 402 * 0.005, 1e-12, name .. ": duration")
    end
  end
end)

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

case("ESM comes back to the digits that were written", function()
  local file = write("pulse.asc", esm_head(#pulse) .. text_of(pulse, "%.6f", 1))
  for _, format in ipairs { "ESM", "none" } do
    local r = records.read { file = file, format = format ~= "none" and format or nil }
    equal(r.format, "ESM", "format")
    equal(r.name, "MADE UP, XYZ HNE", "name")
    near(r.dt, 0.005, 1e-15, "dt")
    near(largest_difference(r.acceleration, pulse, 0.01), 0, 0.5e-6 * 0.01, "values in cm/s^2 with 6 decimals")
  end
end)

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

case("K-NET comes back to half a count, about its mean", function()
  local signal = sampled(sine(0.5), 0.01, 400) -- whole periods: its mean is 0
  local file = write("ABC001.NS", knet(signal))
  for _, format in ipairs { "K-NET", "none" } do
    local r = records.read { file = file, format = format ~= "none" and format or nil }
    equal(r.format, "K-NET", "format")
    equal(r.name, "ABC001 N-S, 2006/01/18 23:25:00", "name")
    near(r.dt, 0.01, 1e-15, "dt")
    near(largest_difference(r.acceleration, signal), 0, knet_factor, "values: half a count, and half a one of the mean")
    local sum = 0
    for _, value in ipairs(r.acceleration) do sum = sum + value end
    near(sum / 400, 0, 1e-12, "mean")
  end
  local r = records.read { file = write("one_less.NS", knet(signal, { ["Duration Time(s)"] = "3.99" })) }
  equal(#r.acceleration, 400, "a duration from the first value to the last")
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
  local model = hinge.model()
  local foot, second = model:node { 0, 0, 0 }, model:node { 0, 1, 0 }
  local bar = hinge.section.solid { width = 0.1, depth = 0.1 }
  local steel = hinge.material { E = 2e11, density = 7850 }
  model:member { foot, model:node { 0, 0, 1 }, section = bar, material = steel }
  model:member { second, model:node { 0, 1, 1 }, section = bar, material = steel }
  model:fix({ foot, second }, "all")
  model:move { node = { foot, second }, x = r.displacement }
  local run = model:dynamic { dt = "auto", duration = 0.02 }:finish()
  equal(run.verdict, "completed", run.reason)
  local moved = r.displacement(run.time)
  near(foot:displacement(run), moved, 1e-9 * math.abs(moved), "foot")
  near(second:displacement(run), moved, 1e-9 * math.abs(moved), "the other foot")
  expect(math.abs(moved) > 1e-4, "it moves by %g m", moved)
end)

-- Errors --------------------------------------------------------------------------------------------------------------

local function refuses(call, options, template)
  local ok, message = pcall(call, options)
  expect(not ok, "is not refused: %s", template)
  expect(support.says(tostring(message), "..." .. template), "says\n%s\nand not\n%s", message, template)
end

case("options of record.read that are wrong", function()
  local function wrong(options, template) refuses(records.read, options, "hinge.record.read: " .. template) end
  wrong({}, "field 'file' is missing; give a string")
  wrong({ file = folder .. "/nothing.at2" }, "field 'file': cannot open .../nothing.at2: No such file or directory")
  wrong({ file = folder }, "field 'file': cannot read ...: Is a directory")
  wrong({ file = write("empty.txt", " \n\n") }, "file '.../empty.txt' is empty")
  wrong({ file = ramp, format = "AT2" }, "field 'format' is 'AT2'; must be one of ESM, K-NET, PEER AT2, columns...")
  wrong({ file = ramp, unit = "gal", dt = 1 }, "field 'unit' is 'gal'; must be one of cm/s^2, g, m/s^2")
  wrong({ file = ramp, dt = 1 }, "file '.../ramp.txt', line 1: the text is not that of PEER AT2, ESM or K-NET; for "
    .. "columns of numbers give unit = 'm/s^2', 'g' or 'cm/s^2'; the line is '0.1...'")
  wrong({ file = ramp, format = "columns", dt = 1 }, "field 'unit' is missing; give one of cm/s^2, g, m/s^2")
  wrong({ file = ramp, unit = "g" }, "field 'dt' is missing; file '.../ramp.txt' has one column; give the time between "
    .. "two values, in s")
  wrong({ file = ramp, unit = "g", dt = -1 }, "field 'dt' is -1 s; must be a number above 0 s")
  wrong({ file = ramp, unit = "g", dt = 0.1, scale = 2, peak = 2 }, "give 'scale' or 'peak', not both")
  wrong({ file = ramp, unit = "g", dt = 0.1, peak = 0 }, "field 'peak' is 0 m/s^2; must be a number above 0 m/s^2")
  wrong({ file = ramp, unit = "g", dt = 0.1, to = 1.2 }, "field 'to' is 1.2 s; the record lasts 1 s")
  wrong({ file = ramp, unit = "g", dt = 0.1, from = 0.5, to = 0.4 },
    "field 'from' is 0.5 s; must be below 'to', 0.4 s")
  wrong({ file = ramp, unit = "g", dt = 0.1, from = 2 }, "field 'from' is 2 s; must be below the record's end, 1 s")
  wrong({ file = ramp, unit = "g", dt = 0.1, from = 0.41, to = 0.55 },
    "fewer than two values from 0.41 s to 0.55 s; the record has one every 0.1 s")
  wrong({ file = ramp, unit = "g", dt = 0.1, to = 0.3, baseline = "quadratic" },
    "field 'baseline': there are 4 values, and this baseline needs 5")
  wrong({ file = ramp, unit = "g", dt = 0.1, baseline = "cubic" }, "field 'baseline' is 'cubic'; must be one of none, "
    .. "constant, linear, quadratic...")
  wrong({ file = write("zeros.txt", "0\n0\n0\n"), unit = "g", dt = 0.1, peak = 2 },
    "field 'peak' is 2 m/s^2; all values of the record are 0")
  wrong({ file = write("large.txt", "1e300\n0\n0\n"), unit = "g", dt = 0.1, scale = 1e10 },
    "field 'scale' is 1e+10; a value is infinite then")
  local at2 = write("good.at2", heads.new:format(2) .. "1 2\n")
  for field, value in pairs { unit = "g", dt = 0.1 } do
    wrong({ file = at2, [field] = value }, "field '" .. field .. "' is for the format 'columns'; file '.../good.at2' "
      .. "is read as PEER AT2, whose text has it")
  end
end)

-- A file is refused with this line and this text.
local function wrong_line(format, text, line, template)
  local file = write("wrong.txt", text)
  refuses(records.read, { file = file, format = format, unit = format == "columns" and "g" or nil,
    dt = format == "columns" and not text:find "%d %d" and 0.1 or nil },
    "hinge.record.read: file '" .. file .. "', line " .. line .. ": " .. template)
end

case("files of PEER AT2 that are wrong", function()
  wrong_line("PEER AT2", "1\n2\n3\n4\n", 4, "not a file of PEER AT2, whose fourth line is ...; the line is '4'")
  wrong_line("PEER AT2", heads.new:format(2):gsub("ACCELERATION", "VELOCITY") .. "1 2\n", 3, "the line before NPTS "
    .. "must say ACCELERATION and UNITS OF G; ...; the line is 'VELOCITY TIME SERIES IN UNITS OF G'")
  wrong_line("PEER AT2", heads.new:format(2):gsub("OF G", "OF GAL") .. "1 2\n", 3, "the line before NPTS must say ...")
  wrong_line("PEER AT2", heads.new:format(2):gsub("%.00500", "0.0") .. "1 2\n", 4, "DT must be a number above 0; ...")
end)

for _, text in ipairs { "NaN", "nan", "inf", "-Infinity", "*****", "0x10", "1e999", "1,5", "1.2.3", "abc" } do
  case("a value that is no finite number: " .. text, function()
    wrong_line("PEER AT2", heads.new:format(4) .. "1 2\n3 " .. text .. "\n", 6, "'" .. text .. "' is not a finite "
      .. "number; the line is '3 " .. text .. "'")
    wrong_line("ESM", esm_head(2) .. "1\n" .. text .. "\n", 16, "'" .. text .. "' is not a finite number; ...")
    wrong_line("K-NET", knet { 0, 0 } .. text, 19, "'" .. text .. "' is not a finite number; ...")
    if text ~= "1,5" then
      wrong_line("columns", "# a\n1\n" .. text, 3, "'" .. text .. "' is not a finite number; ...")
      wrong_line("columns", "# a\n" .. (text == "abc" and "1\n" or "") .. text .. "\n1", text == "abc" and 3 or 2, "'"
        .. text .. "' is not a finite number; ...")
    end
  end)
end

local function wrong_number(text, template)
  local file = write("number.txt", text)
  refuses(records.read, { file = file }, "hinge.record.read: file '" .. file .. "': the header says " .. template)
end

case("files that have not as many values as the header says", function()
  wrong_number(heads.new:format(5) .. "1 2 3 4\n", "5 values (line 4: 'NPTS=     5, DT= .00500 SEC,'), and there are 4")
  wrong_number(heads.old:format(3) .. "1 2 3 4\n", "3 values (line 4: '3    0.0050    NPTS, DT'), and there are 4")
  wrong_number(esm_head(3) .. "1\n2\n", "3 values (line 7: 'NDATA: 3'), and there are 2")
  wrong_number(knet({ 0, 0, 0, 0 }, { ["Duration Time(s)"] = "10" }),
    "1000 values (line 12: 'Duration Time(s)  10'), and there are 4")
end)

case("files of ESM that are wrong", function()
  wrong_line("ESM", "1\n2\n", 1, "not a file of ESM, which begins with lines such as 'EVENT_NAME: ...'; the line is "
    .. "'1'")
  for _, key in ipairs { "DATA_TYPE", "UNITS", "SAMPLING_INTERVAL_S", "NDATA" } do
    wrong_line("ESM", esm_head(2, { [key] = false }) .. "1\n2\n", 14, "the header ends here, and has no line '" .. key
      .. ": ...'; the line is '1'")
  end
  wrong_line("ESM", esm_head(2, { DATA_TYPE = "VELOCITY" }) .. "1\n2\n", 12, "only ACCELERATION is read; the line is "
    .. "'DATA_TYPE: VELOCITY'")
  wrong_line("ESM", esm_head(2, { UNITS = "cm/s" }) .. "1\n2\n", 10, "the unit of a file of ESM must be cm/s^2; ...")
  wrong_line("ESM", esm_head(2, { SAMPLING_INTERVAL_S = "" }) .. "1\n2\n", 6, "SAMPLING_INTERVAL_S must be a number "
    .. "above 0; ...")
end)

case("files of K-NET that are wrong", function()
  wrong_line("K-NET", "1\n2\n", 1, "not a file of K-NET, which begins with 'Origin Time'; the line is '1'")
  wrong_line("K-NET", (knet({ 0, 0 }):gsub("Memo%.", "Note.")), 17, "the header of K-NET has 17 lines, of which the "
    .. "last begins with 'Memo.'; the line is 'Note.'")
  wrong_line("K-NET", (knet({ 0, 0 }):gsub("Scale Factor", "Scale Faktor")), 17, "the header has no line 'Scale "
    .. "Factor'; ...")
  wrong_line("K-NET", knet({ 0, 0 }, { ["Scale Factor"] = "3920(kine)/6182761" }), 14, "must be a number and '(gal)/' "
    .. "and a number; ...")
  wrong_line("K-NET", knet({ 0, 0 }, { ["Sampling Freq(Hz)"] = "100" }), 11, "the frequency (100Hz) must be a number "
    .. "above 0; ...")
end)

case("files of columns that are wrong", function()
  wrong_line("columns", "1 2 3\n", 1, "there are 3 numbers; one column or two are read; the line is '1 2 3'")
  wrong_line("columns", "0 2\n1\n2 2\n", 2, "there are 1 numbers, and 2 in the first row (line 1); the line is '1'")
  wrong_line("columns", "0 2\n0.1,,3\n", 2, "there is no number before a comma; the line is '0.1,,3'")
  wrong_line("columns", "# t a\n0 2\n0.1 2\n0.3 3\n0.4 1\n", 3, "the times in the first column must grow by equal "
    .. "steps; over all of them the step is 0.133333 s, so the time here must be 0.133333 s; the line is '0.1 2'")
  wrong_line("columns", "0 2\n0 3\n", 1, "the times in the first column must grow ...")
  local file = write("short.txt", "# only one\n0 2\n")
  refuses(records.read, { file = file, unit = "g" }, "hinge.record.read: file '" .. file .. "' has 1 row of numbers; "
    .. "there must be two or more")
  file = write("two.txt", "0 2\n1 2\n")
  refuses(records.read, { file = file, unit = "g", dt = 0.1 }, "hinge.record.read: field 'dt' is 0.1 s; file '" .. file
    .. "' has two columns, and the first one is the time; leave dt out")
end)

-- Spectra -------------------------------------------------------------------------------------------------------------
-- Peaks between steps of a twentieth of a period are read from a cubic for the velocity, right to 1e-5. The limits are
-- twice that where the excitation is straight between its values. A sampled sine is not: its chords are lower by
-- (W dt)^2 / 12.

-- The largest value of a function from t1 to t2.
local function largest_of(f, t1, t2, n)
  local largest = 0
  for i = 0, n do largest = support.largest_of(largest, math.abs(f(t1 + (t2 - t1) * i / n))) end
  return largest
end

case("a step of acceleration: 1 + exp(-pi zeta / sqrt(1 - zeta^2)) times the displacement in statics", function()
  local periods = { 1e-3, 0.02, 0.3, 1, 3.9 }
  for _, zeta in ipairs { 0, 0.02, 0.05, 0.3, 0.9 } do
    local s = spectrum { dt = 0.01, acceleration = sampled(function() return -2 end, 0.01, 501), periods = periods,
      damping = zeta }
    equal(s.damping, zeta, "damping")
    for i, period in ipairs(periods) do
      local name, w = ("damping %g, period %g s"):format(zeta, period), 2 * pi / period
      local most = 1 + math.exp(-pi * zeta / math.sqrt(1 - zeta ^ 2))
      equal(s.periods[i], period, name)
      near(s.displacement[i] * w * w / 2, most, 2e-5, name .. ": displacement")
      near(s.velocity[i], w * s.displacement[i], 1e-12 * s.velocity[i], name .. ": pseudo velocity")
      near(s.acceleration[i] / 2, most, 2e-5, name .. ": pseudo acceleration")
      if zeta == 0 then near(s.absolute_acceleration[i] / 2, 2, 2e-5, name .. ": absolute acceleration") end
    end
  end
end)

-- Relative displacement from rest under a = sin W t; zeta may be 0, W = w not then.
local function under_sine(w, zeta, W)
  local wd = w * math.sqrt(1 - zeta ^ 2)
  local b, c = w * w - W * W, 2 * zeta * w * W
  local S, C = -b / (b * b + c * c), c / (b * b + c * c) -- of sin W t and cos W t, which stay
  return function(t)
    local decay = math.exp(-zeta * w * t)
    return S * math.sin(W * t) + C * math.cos(W * t)
      - decay * (C * math.cos(wd * t) + (S * W + C * zeta * w) / wd * math.sin(wd * t))
  end
end

case("a sine from rest: the closed form to 1e-3", function()
  local W, dt, n = 2 * pi, 0.005, 1601 -- 8 s; the chords are lower by (W dt)^2 / 12 = 8e-5
  local a, periods = sampled(math.sin, W * dt, n), { 0.1, 0.37, 0.8, 1.3, 2.1, 4 }
  for _, zeta in ipairs { 0, 0.05, 0.2 } do
    local s = spectrum { dt = dt, acceleration = a, periods = periods, damping = zeta }
    for i, period in ipairs(periods) do
      local u = under_sine(2 * pi / period, zeta, W)
      -- 8 s of the sine, and what is left of the motion after it: here not more
      near(s.displacement[i] / largest_of(u, 0, 8, 16000), 1, 1e-3, ("damping %g, period %g s"):format(zeta, period))
    end
  end
end)

case("resonance: without damping the response grows by pi / w^2 a cycle, with damping up to 1 / (2 zeta)", function()
  for cycles = 2, 8, 3 do
    local dt = 0.005 -- chords: 8e-5
    local s = spectrum { dt = dt, acceleration = sampled(math.sin, 2 * pi * dt, cycles * 200 + 1), periods = { 1 },
      damping = 0 }
    -- u = (sin w t - w t cos w t) / (2 w^2); u' = 0 at w t = 2 pi cycles, where the sine ends
    near(s.acceleration[1], pi * cycles, 1e-3 * pi * cycles, cycles .. " cycles")
  end
  local s = spectrum { dt = 0.005, acceleration = sampled(math.sin, 2 * pi * 0.005, 24001), periods = { 1 } }
  near(s.acceleration[1], 10, 1e-2, "5 % damping, 120 cycles: 10")
end)

case("a rectangular pulse: 2 sin(pi t / T) after it, where the ground is at rest", function()
  local a = sampled(function() return 3 end, 0.01, 21) -- 0.2 s
  for _, period in ipairs { 0.5, 1, 3, 50 } do
    local s = spectrum { dt = 0.01, acceleration = a, periods = { period }, damping = 0 }
    near(s.acceleration[1] / 3, 2 * math.sin(pi * 0.2 / period), 2e-5, ("period %g s"):format(period))
  end
end)

case("a step that rises straight over one interval: 1 + |sin(pi t / T)| / (pi t / T)", function()
  for _, period in ipairs { 0.05, 0.3, 0.5, 0.7, 3 } do
    local s = spectrum { dt = 0.4, acceleration = { 0, 1, 1, 1, 1, 1, 1, 1, 1, 1 }, periods = { period }, damping = 0 }
    local x = pi * 0.4 / period
    near(s.acceleration[1], 1 + math.abs(math.sin(x)) / x, 2e-5, ("period %g s"):format(period))
  end
end)

case("stiff oscillators have the ground's acceleration, soft ones its displacement", function()
  local a = sampled(ricker(0.5, 1), 0.01, 201)
  local s = spectrum { dt = 0.01, acceleration = a, periods = { 5e-4, 1e4 } }
  -- at the kink at the peak it swings by w^-1 times the change of slope there, 2.3 m/s^3, at most: 2e-4
  near(s.absolute_acceleration[1], 1, 2e-4, "absolute acceleration")
  near(s.acceleration[1], 1, 2e-4, "pseudo acceleration")
  local u = hinge.ground { dt = 0.01, acceleration = a }
  near(s.displacement[2] / largest_of(u, 0, 2, 2000), 1, 1e-3, "displacement: damping and a period of 1e4 s count 6e-4")
end)

case("more points on the same straight lines change nothing", function()
  local saw, fine = { 0, 3, -2, 1, 4, 4, -3, 0, 5, -1, 2, 2, -4, 3, 0 }, {}
  for i = 1, 14 do
    for k = 0, 49 do fine[50 * i + k - 49] = saw[i] + (saw[i + 1] - saw[i]) * k / 50 end
  end
  fine[701] = 0
  for _, zeta in ipairs { 0, 0.05, 0.3, 0.6 } do
    local periods = { 0.11, 0.3, 0.5, 1, 1.9, 2.3 }
    local coarse = spectrum { dt = 0.1, acceleration = saw, periods = periods, damping = zeta }
    local s = spectrum { dt = 0.002, acceleration = fine, periods = periods, damping = zeta }
    for i, period in ipairs(periods) do
      local name = ("damping %g, period %g s"):format(zeta, period)
      near(coarse.displacement[i] / s.displacement[i], 1, 2e-5, name .. ": displacement")
      near(coarse.absolute_acceleration[i] / s.absolute_acceleration[i], 1, 2e-5, name .. ": absolute acceleration")
    end
  end
end)

case("a long period with short steps keeps its digits", function()
  local ten, one = {}, sampled(ricker(0.5, 1), 1e-3, 2001)
  for i = 1, 2000 do -- the same motion in steps of 1e-5 s: w h is 6e-6
    for k = 0, 9 do ten[10 * i + k - 9] = one[i] + (one[i + 1] - one[i]) * k / 10 end
  end
  local s = spectrum { dt = 1e-3, acceleration = one, periods = { 10 } }
  local fine = spectrum { dt = 1e-4, acceleration = ten, periods = { 10 } }
  near(fine.displacement[1] / s.displacement[1], 1, 1e-5, "displacement")
end)

case("absolute acceleration with damping: the closed form of a step", function()
  local w = 2 * pi
  for _, zeta in ipairs { 0.05, 0.3 } do
    local wd = w * math.sqrt(1 - zeta ^ 2)
    -- a mass on ground that begins to be accelerated by 1: 1 + e^(-zeta w t) (zeta w / wd sin wd t - cos wd t)
    local function absolute(t)
      return 1 + math.exp(-zeta * w * t) * (zeta * w / wd * math.sin(wd * t) - math.cos(wd * t))
    end
    local most = largest_of(absolute, 0, 3, 30000)
    for dt = 0.04, 0.05, 0.001 do -- the steps meet the peak or miss it
      local s = spectrum { dt = dt, acceleration = sampled(function() return 1 end, dt, 60), periods = { 1 },
        damping = zeta }
      near(s.absolute_acceleration[1], most, 2e-5 * most, ("damping %g, dt %g s"):format(zeta, dt))
      if zeta == 0.3 then expect(most - s.acceleration[1] > 0.05, "it is not the pseudo acceleration") end
    end
  end
end)

case("times in the place of dt, also unequal ones", function()
  local f, time, a = ricker(0.5, 1), {}, {}
  local t = 0
  while t < 2 do
    time[#time + 1], a[#a + 1] = 7 + t, f(t)
    t = t + (#time % 3 == 0 and 0.0025 or 0.005)
  end
  local even = spectrum { dt = 0.0025, acceleration = sampled(f, 0.0025, 801), periods = { 0.1, 0.5, 2 } }
  local s = spectrum { time = time, acceleration = a, periods = { 0.1, 0.5, 2 } }
  for i = 1, 3 do -- chords: the pulse has a curvature of 6 (pi / 0.5 s)^2, and 5 ms of it sag by an eighth of 6e-3
    near(s.displacement[i] / even.displacement[i], 1, 1e-3, "unequal steps")
  end
  local times = sampled(function(x) return x end, 0.0025, 801)
  local same = spectrum { time = times, acceleration = sampled(f, 0.0025, 801), periods = { 0.1, 0.5, 2 } }
  for i = 1, 3 do near(same.displacement[i] / even.displacement[i], 1, 1e-9, "equal steps") end
end)

case("the spectrum of a run's probe", function()
  local model = hinge.model()
  local foot, top = model:node { 0, 0, 0 }, model:node { 0, 0, 1 }
  model:fix(foot, "all")
  model:member { foot, top, section = hinge.section.solid { width = 0.1, depth = 0.1 },
    material = hinge.material { E = 2e9, density = 7850 } }
  model:mass { node = top, mass = 500 }
  model:move { node = foot, x = hinge.ground { dt = 0.01, acceleration = sampled(ricker(0.3, 0.5), 0.01, 101) } }
  local run = model:dynamic { dt = 1e-3, duration = 1 }
  local ax = run:probe { node = top, "ax" }
  run:finish()
  local largest = largest_of(function(i) return ax.value[math.floor(i + 0.5)] end, 1, #ax.value, #ax.value - 1)
  local s = spectrum { time = ax.time, acceleration = ax.value, periods = { 1e-3, 0.1 } }
  near(s.absolute_acceleration[1] / largest, 1, 1e-3, "a stiff thing on the top has its acceleration")
  expect(largest > 0.5, "which is %g m/s^2", largest)
end)

case("the periods if there are none given: 100 from 0.02 to 4 s", function()
  local s = spectrum { dt = 0.01, acceleration = { 0, 1, 0 } }
  equal(#s.periods, 100, "periods")
  near(s.periods[1], 0.02, 1e-15, "first")
  near(s.periods[100], 4, 1e-12, "last")
  near(s.periods[51] / s.periods[50], 200 ^ (1 / 99), 1e-12, "between")
  equal(#s.displacement + #s.velocity + #s.acceleration + #s.absolute_acceleration, 400, "values")
end)

case("options of hinge.spectrum that are wrong", function()
  local function wrong(options, template) refuses(spectrum, options, "hinge.spectrum: " .. template) end
  wrong({ acceleration = { 1, 2 } }, "field 'dt' or 'time' is missing; give one of them: 'dt', the time step in s, or "
    .. "'time', a list of times in s")
  wrong({ acceleration = { 1, 2 }, dt = 1, time = { 0, 1 } }, "there are both 'dt' and 'time'; ...")
  wrong({ dt = 0.1 }, "field 'acceleration' is missing; give a table")
  wrong({ dt = 0.1, acceleration = { 1 } }, "field 'acceleration' has 1 value; must have 2 or more")
  wrong({ dt = 0.1, acceleration = { 1, 0 / 0, 3 } },
    "field 'acceleration[2]' is not a number (nan) m/s^2; must be a number, in m/s^2")
  wrong({ dt = 0.1, acceleration = { 1, 2, "x" } }, "field 'acceleration[3]' is 'x'; must be a number, in m/s^2")
  wrong({ dt = 0, acceleration = { 1, 2 } }, "field 'dt' is 0 s; must be a number above 0 s")
  wrong({ time = { 0, 1, 1 }, acceleration = { 1, 2, 3 } },
    "field 'time[3]' is 1 s; must be above the one before, 1 s")
  wrong({ time = { 0, 1 }, acceleration = { 1, 2, 3 } }, "'time' has 2 values, and 'acceleration' has 3")
  wrong({ dt = 0.1, acceleration = { 1, 2 }, periods = {} }, "field 'periods' has 0 values; must have 1 or more")
  wrong({ dt = 0.1, acceleration = { 1, 2 }, periods = { 1, 0 } },
    "field 'periods[2]' is 0 s; must be a number above 0 s")
  wrong({ dt = 0.1, acceleration = { 1, 2 }, periods = { 1, 5e-5 } },
    "field 'periods[2]' is 5e-05 s; must be at least 1/1000 of the longest time step, 0.0001 s")
  wrong({ dt = 0.1, acceleration = { 1e308, -1e308, 1e308 }, periods = { 1 } },
    "the response at a period of 1 s is too large to compute; look at the accelerations, in m/s^2")
  wrong({ dt = 0.1, acceleration = { 1, 2 }, damping = 1 }, "field 'damping' is 1; must be a number of at least 0 and "
    .. "below 1")
  wrong({ dt = 0.1, acceleration = { 1, 2 }, zeta = 1 }, "unknown field 'zeta'...")
end)

checks.done()
