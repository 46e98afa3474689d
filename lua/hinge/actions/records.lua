-- hinge.record: one component of ground motion from a file. Where the formats are described:
--
-- PEER AT2   PEER Strong Motion Database, "Sample Data Files" (peer.berkeley.edu/smcat/data.html): four lines, the
--            third with the unit, the fourth with the number of points and dt. The fourth line has two forms, which the
--            OpenSees examples name: "NPTS=  3930, DT= .00500 SEC" and "3930 0.00500 NPTS, DT".
-- ESM        Header "DYNA 1.2" of the Engineering Strong Motion database, as in its files: 64 lines KEY: value, then
--            one value a line.
-- K-NET      NIED, "About K-NET ASCII format" (www.kyoshin.bosai.go.jp/kyoshin/man/knetform_en.html): 17 lines, the key
--            in the first 18 columns; then counts of the instrument. KiK-net has the same format.
local check = require "hinge.library.check"
local ground = require "hinge.actions.ground"
local units = require "hinge.library.units"

local where = "hinge.record.read"
local factors = { ["m/s^2"] = 1, g = units.gravity, ["cm/s^2"] = 0.01 } -- to m/s^2; 1 gal is 1 cm/s^2
local degrees = { constant = 0, linear = 1, quadratic = 2 } -- of the polynomial that `baseline` takes off

-- Files ---------------------------------------------------------------------------------------------------------------

-- The lines of a file, and its path.
local function open(path)
  local file, problem = io.open(path, "rb")
  if not file then check.fail("%s: field 'file': cannot open %s", where, problem) end
  local text, unread = file:read "a"
  file:close()
  if not text then check.fail("%s: field 'file': cannot read %s: %s", where, path, unread) end
  if not text:find "%S" then check.fail("%s: file '%s' is empty", where, path) end
  local source = { path = path }
  for line in (text:gsub("^\239\187\191", "") .. "\n"):gmatch "([^\n]*)\n" do -- a mark of UTF-8 may come first
    source[#source + 1] = (line:gsub("\r$", ""))
  end
  return source
end

-- Refuses a file for what is, or is not, in one of its lines.
local function refuse(source, i, what, ...)
  local line = (source[i] or ""):gsub("%c", " "):match "^%s*(.-)%s*$"
  if #line > 80 then line = line:sub(1, 80) .. "..." end
  check.fail("%s: file '%s', line %d: %s; the line is '%s'", where, source.path, i, what:format(...), line)
end

-- A number as it stands in these files, also with Fortran's 1.5D-03. Nil for anything else: NaN, ****, 0x10.
local function number_of(text)
  local number = text:find "^[-+.%dDdEe]+$" and tonumber((text:gsub("[Dd]", "e")))
  return number and math.abs(number) < math.huge and number + 0.0 or nil
end

-- The numbers of one line, each a `piece` of it.
local function numbers_of(source, i, piece, line)
  local list = {}
  for text in line:gmatch(piece) do
    list[#list + 1] = number_of(text) or refuse(source, i, "'%s' is not a finite number", text)
  end
  return list
end

-- All numbers from a line to the end. Numbers of a fixed width may touch: 0.1234E-03-0.5678E-03.
local function values_from(source, first)
  local values = {}
  for i = first, #source do
    local row = numbers_of(source, i, "%S+", (source[i]:gsub("(%d)([-+])", "%1 %2")))
    table.move(row, 1, #row, #values + 1, values)
  end
  return values
end

-- A number of the header that must be above 0.
local function above_zero(source, i, what, text)
  local number = number_of(text or "")
  return number and number > 0 and number or refuse(source, i, "%s must be a number above 0", what)
end

-- Refuses a file that has not as many values as its header says.
local function must_have(source, i, values, said, within)
  if math.abs(#values - said) <= within then return end
  check.fail("%s: file '%s': the header says %.10g values (line %d: '%s'), and there are %d", where, source.path, said,
    i, source[i]:match "^%s*(.-)%s*$", #values)
end

local function scaled(values, factor)
  for i, value in ipairs(values) do values[i] = value * factor end
  return values
end

-- Formats: each returns dt (s), accelerations (m/s^2) and a name ------------------------------------------------------

-- The line of an AT2 header that has the number of points and dt, and these as text; nil: there is none.
local function peer_line(source)
  for i = 1, math.min(10, #source) do
    local line = source[i]:upper()
    local n, dt = line:match "NPTS%s*=%s*(%d+)%s*,?%s*DT%s*=%s*([%d.E+-]+)"
    if not n then n, dt = line:match "^%s*(%d+)%s+([%d.E+-]+)%s+NPTS%s*,?%s*DT" end
    if n then return i, n, dt end
  end
end

local function read_peer(source)
  local i, n, dt = peer_line(source)
  if not i then
    refuse(source, math.min(4, #source), "not a file of PEER AT2, whose fourth line is 'NPTS=  n, DT= dt SEC' or "
      .. "'n dt NPTS, DT'")
  end
  local unit = (source[i - 1] or ""):upper()
  if not (unit:find "ACCELERATION" and unit:find "UNITS%s+OF%s+%(?G%f[%W]") then
    refuse(source, math.max(i - 1, 1), "the line before NPTS must say ACCELERATION and UNITS OF G; velocities, "
      .. "displacements and other units are not read")
  end
  dt = above_zero(source, i, "DT", dt)
  local values = values_from(source, i + 1)
  must_have(source, i, values, tonumber(n), 0)
  return dt, scaled(values, factors.g), (source[i - 2] or source.path):match "^%s*(.-)%s*$"
end

-- The header of a file of ESM: values by key, their lines by key, and the line after it.
local function esm_header(source)
  local values, lines = {}, {}
  for i = 1, #source do
    local key, value = source[i]:match "^([%u%d_/^]+):%s*(.-)%s*$"
    if not key then return values, lines, i end
    values[key], lines[key] = value, i
  end
  return values, lines, #source + 1
end

local function read_esm(source)
  local header, lines, after = esm_header(source)
  if after == 1 then refuse(source, 1, "not a file of ESM, which begins with lines such as 'EVENT_NAME: ...'") end
  for _, key in ipairs { "DATA_TYPE", "UNITS", "SAMPLING_INTERVAL_S", "NDATA" } do
    if not header[key] then refuse(source, after, "the header ends here, and has no line '%s: ...'", key) end
  end
  if header.DATA_TYPE ~= "ACCELERATION" then refuse(source, lines.DATA_TYPE, "only ACCELERATION is read") end
  if header.UNITS ~= "cm/s^2" then refuse(source, lines.UNITS, "the unit of a file of ESM must be cm/s^2") end
  local dt = above_zero(source, lines.SAMPLING_INTERVAL_S, "SAMPLING_INTERVAL_S", header.SAMPLING_INTERVAL_S)
  local n = above_zero(source, lines.NDATA, "NDATA", header.NDATA)
  local values = values_from(source, after)
  must_have(source, lines.NDATA, values, n, 0)
  local name = ("%s, %s %s"):format(header.EVENT_NAME or "", header.STATION_CODE or "", header.STREAM or "")
  return dt, scaled(values, factors["cm/s^2"]), name
end

-- The header of a file of K-NET: values by key, their lines by key, and the line after it. Its last key is Memo.
local function knet_header(source)
  if not source[1]:find "^Origin Time" then
    refuse(source, 1, "not a file of K-NET, which begins with 'Origin Time'")
  end
  local values, lines = {}, {}
  for i = 1, math.min(17, #source) do
    local key = source[i]:sub(1, 18):match "^(.-)%s*$"
    values[key], lines[key] = source[i]:sub(19):match "^%s*(.-)%s*$", i
    if key:find "^Memo" then return values, lines, i + 1 end
  end
  refuse(source, math.min(17, #source), "the header of K-NET has 17 lines, of which the last begins with 'Memo.'")
end

local function read_knet(source)
  local header, lines, after = knet_header(source)
  local function get(key) return header[key] or refuse(source, after - 1, "the header has no line '%s'", key) end
  local rate = above_zero(source, lines["Sampling Freq(Hz)"], "the frequency (100Hz)",
    get("Sampling Freq(Hz)"):match "^(%S-)%s*Hz$")
  local duration = above_zero(source, lines["Duration Time(s)"], "the duration", get "Duration Time(s)")
  local gal, counts = get("Scale Factor"):match "^(%S-)%s*%(gal%)%s*/%s*(%S+)$"
  if not gal then refuse(source, lines["Scale Factor"], "must be a number and '(gal)/' and a number") end
  local factor = above_zero(source, lines["Scale Factor"], "the first number", gal)
    / above_zero(source, lines["Scale Factor"], "the second number", counts)
  local values = values_from(source, after)
  -- the header has a duration and no number: it may be counted from the first value to the last, or with one step more
  must_have(source, lines["Duration Time(s)"], values, rate * duration, 1 + 1e-6)
  local sum = 0
  for _, value in ipairs(values) do sum = sum + value end
  local mean = sum / #values -- the header's peak is against it, too (NIED's description of KiK-net, line 15)
  for i, value in ipairs(values) do values[i] = value - mean end
  local name = ("%s %s, %s"):format(header["Station Code"] or "", header["Dir."] or "", header["Origin Time"])
  return 1 / rate, scaled(values, factor * factors["cm/s^2"]), name
end

local not_finite = { nan = true, inf = true, infinity = true } -- values, not words of a header

-- The rows of a file of columns, and their lines. What begins with # is no row, nor are words before the first row.
local function rows_of(source)
  local rows, lines = {}, {}
  for i, line in ipairs(source) do
    local begins = line:match "^%s*([%a\"']+)"
    local word = begins and #rows == 0 and not not_finite[begins:lower()]
    if line:find "%S" and not line:find "^%s*#" and not word then
      if line:find ",%s*," or line:find "^%s*," then refuse(source, i, "there is no number before a comma") end
      local row = numbers_of(source, i, "[^%s,]+", line)
      if #row > 2 then refuse(source, i, "there are %d numbers; one column or two are read", #row) end
      if rows[1] and #row ~= #rows[1] then
        refuse(source, i, "there are %d numbers, and %d in the first row (line %d)", #row, #rows[1], lines[1])
      end
      rows[#rows + 1], lines[#lines + 1] = row, i
    end
  end
  if #rows < 2 then
    check.fail("%s: file '%s' has %s of numbers; there must be two or more", where, source.path,
      check.count(#rows, "row"))
  end
  return rows, lines
end

-- The step of the times in the first column. They have few digits: each may be off by a tenth of a step.
local function step_of(source, rows, lines)
  local first = rows[1][1]
  local dt = (rows[#rows][1] - first) / (#rows - 1)
  for i, row in ipairs(rows) do
    if not (dt > 0 and math.abs(row[1] - first - (i - 1) * dt) <= 0.1 * dt) then
      refuse(source, lines[i], "the times in the first column must grow by equal steps; over all of them "
        .. "the step is %.6g s, so the time here must be %.6g s", dt, first + (i - 1) * dt)
    end
  end
  return dt
end

local function read_columns(source, o)
  check.value(where, "unit", o.unit, { "string", one_of = check.keys(factors) })
  local rows, lines = rows_of(source)
  local columns, dt, values = #rows[1], o.dt, {}
  if columns == 2 and dt then
    check.fail("%s: field 'dt' is %g s; file '%s' has two columns, and the first one is the time; leave dt out", where,
      dt, source.path)
  elseif columns == 1 and not dt then
    check.fail("%s: field 'dt' is missing; file '%s' has one column; give the time between two values, in s", where,
      source.path)
  end
  if columns == 2 then dt = step_of(source, rows, lines) end
  for i, row in ipairs(rows) do values[i] = row[columns] end
  return dt, scaled(values, factors[o.unit]), source.path:match "[^/]*$"
end

local formats = { ["PEER AT2"] = read_peer, ESM = read_esm, ["K-NET"] = read_knet, columns = read_columns }

-- The format that a text has; columns only where the unit is given.
local function format_of(source, o)
  if source[1]:find "^Origin Time" then return "K-NET" end
  local keys = esm_header(source)
  if keys.EVENT_NAME or keys.SAMPLING_INTERVAL_S then return "ESM" end
  if peer_line(source) then return "PEER AT2" end
  if o.unit then return "columns" end
  refuse(source, 1, "the text is not that of PEER AT2, ESM or K-NET; for columns of numbers give unit = 'm/s^2', 'g' "
    .. "or 'cm/s^2'")
end

-- What is done to the values ------------------------------------------------------------------------------------------

-- The values from `from` to `to` (s after the first value).
local function cut(values, dt, o)
  local last = (#values - 1) * dt
  local from, to = o.from or 0, o.to or last
  if to > last * (1 + 1e-9) then
    check.fail("%s: field 'to' is %g s; the record lasts %g s", where, to, last)
  elseif from >= to then
    check.fail("%s: field 'from' is %g s; must be below %s, %g s", where, from, o.to and "'to'" or "the record's end",
      to)
  end
  local first, stop = math.ceil(from / dt - 1e-6) + 1, math.floor(to / dt + 1e-6) + 1
  if stop <= first then
    check.fail("%s: fewer than two values from %g s to %g s; the record has one every %g s", where, from, to, dt)
  end
  return table.move(values, first, stop, 1, {})
end

-- Integral from the first value, straight lines between the values.
local function integral(values, dt)
  local sums = { 0 }
  for i = 2, #values do sums[i] = sums[i - 1] + (values[i - 1] + values[i]) * dt / 2 end
  return sums
end

-- Takes a polynomial p off the acceleration, so that the velocity at the end is 0, and the sum of the squares of all
-- velocities is the least that then is possible. p = c0 + c1 P1 + c2 P2 has Legendre's polynomials of x, which is -1
-- at the first value and 1 at the last. Let V, B1, B2 be the velocities of the record, of P1 and of P2. c0 makes the
-- end 0. The velocity that is left is v - c1 b1 - c2 b2: each small letter is the capital one less a straight line from
-- 0 to its end. b1 is even about the middle, and b2 is odd. So c1 = (v, b1) / (b1, b1), and c2 likewise.
local function without_baseline(values, dt, degree)
  local n = #values
  if n < degree + 3 then
    check.fail("%s: field 'baseline': there are %d values, and this baseline needs %d", where, n, degree + 3)
  end
  local function to_zero(of)
    local sums = integral(of, dt)
    local ends = sums[n]
    for i = 1, n do sums[i] = sums[i] - ends * (i - 1) / (n - 1) end
    return sums, ends / ((n - 1) * dt)
  end
  local v, mean = to_zero(values)
  local result = {}
  for i = 1, n do result[i] = values[i] - mean end
  for k = 1, degree do
    local p = {}
    for i = 1, n do
      local x = (2 * i - n - 1) / (n - 1)
      p[i] = k == 1 and x or (3 * x * x - 1) / 2
    end
    local b, own_mean = to_zero(p)
    local vb, bb = 0, 0
    for i = 1, n do vb, bb = vb + v[i] * b[i], bb + b[i] * b[i] end
    for i = 1, n do result[i] = result[i] - vb / bb * (p[i] - own_mean) end
  end
  return result
end

local function peak_of(values)
  local peak = 0
  for _, value in ipairs(values) do peak = math.max(peak, math.abs(value)) end
  return peak
end

local rules = {
  file = { "string" },
  format = { "string", optional = true, one_of = check.keys(formats) },
  unit = { "string", optional = true, one_of = check.keys(factors) },
  dt = { "number", unit = "s", above = 0, optional = true },
  scale = { "number", optional = true },
  peak = { "number", unit = "m/s^2", above = 0, optional = true },
  from = { "number", unit = "s", at_least = 0, optional = true },
  to = { "number", unit = "s", above = 0, optional = true },
  baseline = { "string", default = "none", one_of = { "none", "constant", "linear", "quadratic" } },
}

-- The factor that `scale` or `peak` asks for.
local function factor_of(o, values)
  if not o.peak then return o.scale or 1 end
  local peak = peak_of(values)
  if peak == 0 then check.fail("%s: field 'peak' is %g m/s^2; all values of the record are 0", where, o.peak) end
  return o.peak / peak
end

-- In this order: m/s^2, the cut, the baseline, the factor.
local function read(options, ...)
  check.no_more(where, ...)
  local o = check.options(where, options, rules)
  if o.scale and o.peak then check.fail("%s: give 'scale' or 'peak', not both", where) end
  local source = open(o.file)
  local format = o.format or format_of(source, o)
  for _, field in ipairs(format == "columns" and {} or { "unit", "dt" }) do
    if o[field] then
      check.fail("%s: field '%s' is for the format 'columns'; file '%s' is read as %s, whose text has it", where, field,
        o.file, format)
    end
  end
  local dt, values, name = formats[format](source, o)
  if #values < 2 then check.fail("%s: file '%s' has fewer than two values", where, o.file) end
  values = cut(values, dt, o)
  if degrees[o.baseline] then values = without_baseline(values, dt, degrees[o.baseline]) end
  scaled(values, factor_of(o, values))
  local peak, duration = peak_of(values), (#values - 1) * dt
  if not (peak < math.huge) then check.fail("%s: field 'scale' is %g; a value is infinite then", where, o.scale) end
  local displacement = ground { dt = dt, acceleration = values }
  return check.strict({ dt = dt, acceleration = values, name = name, format = format, peak = peak, duration = duration,
    end_velocity = integral(values, dt)[#values], end_displacement = displacement(duration),
    displacement = displacement }, "record of " .. where)
end

return check.strict({ read = read }, "hinge.record")
