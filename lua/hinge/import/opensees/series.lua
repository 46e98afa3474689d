-- Time series of OpenSees: a factor, and points { time, factor } of those that change in form.
local arguments = require "hinge.import.opensees.arguments"
local core = require "hinge.core"

local number, give_up = arguments.number, arguments.give_up
local series, readers = {}, {}

local most_points = 200000 -- of one series
local parts_of_period = 100 -- straight parts for a period of a sine: 1/2000 of its amplitude

-- The value of a series is that of `points`, { time (s), factor }, straight between them, times the factor.
local function of_points(factor, points) return { factor = factor, history = points } end

function readers.Linear(_, _, factor) return { factor = factor } end
readers.Constant = readers.Linear

-- Rectangular tStart tEnd
function readers.Rectangular(self, args, factor)
  local a, b = number(self, args[1], "the start") * self.time, number(self, args[2], "the end") * self.time
  return of_points(factor, { { a, 0 }, { a, 1 }, { b, 1 }, { b, 0 } })
end

-- Trig tStart tEnd period <-shift radians>: sin(2 pi (t - tStart) / period + shift)
function readers.Trig(self, args, factor)
  local T = self.time
  local a, b, period = number(self, args[1], "the start") * T, number(self, args[2], "the end") * T,
    number(self, args[3], "the period") * T
  local shift = arguments.number_of(self, args, "-shift", "-phaseShift") or 0
  if not (period > 0 and b > a) then self:fail "the period and the duration must be above 0" end
  local count = math.ceil((b - a) / period * parts_of_period)
  if count > most_points then give_up("it has more than %d points", most_points) end
  local points, values = { { a, 0 } }, {}
  for i = 0, count do
    local t = (b - a) * i / count
    values[i + 1] = math.sin(2 * math.pi * t / period + shift)
    points[i + 2] = { a + t, values[i + 1] }
  end
  points[#points + 1] = { b, 0 }
  if math.abs(points[2][2]) < 1e-12 then table.remove(points, 1) end
  if math.abs(points[#points - 1][2]) < 1e-9 then table.remove(points, #points - 1) end
  return { factor = factor, history = points, dt = a == 0 and (b - a) / count or nil, values = values }
end
readers.Sine, readers.TrigSeries = readers.Trig, readers.Trig

-- The numbers of a file below the folder of the script.
local function numbers_of_file(self, name)
  local folder = self.frame.source:match "^(.*/)" or ""
  if name:find "^/" or name:find "%.%." or name:find "^~" or name:find "^%a:" then
    give_up("the file '%s' is not below the folder of the script", name)
  end
  if core.sandboxed() then give_up "a script in the sandbox reads no files" end
  local text = core.read_text(folder .. name)
  if not text then give_up("the file '%s' cannot be read", name) end
  local list = {}
  for word in text:gmatch "[^%s,;]+" do
    local x = tonumber(word)
    if not x or x ~= x or math.abs(x) == math.huge then give_up("the file '%s' has more than numbers", name) end
    list[#list + 1] = x
    if #list > most_points then give_up("the file '%s' has more than %d numbers", name, most_points) end
  end
  if #list < 2 then give_up("the file '%s' has fewer than two numbers", name) end
  return list
end

-- The numbers of -values or of -filePath; or of -time or -fileTime.
local function list_of(self, args, of_list, of_file)
  local i = arguments.option(args, of_file)
  if i then return numbers_of_file(self, args[i + 1] or "") end
  local words = arguments.list_of(args, of_list)
  if not words then return nil end
  -- OpenSeesPy may give all arguments as a flat list: negative numbers are no options
  for k, word in ipairs(words) do words[k] = number(self, word, of_list) end
  return words
end

-- Path -dt dt -values {..} | -filePath file | -time {..} -values {..}, <-factor f> <-startTime t>
function readers.Path(self, args, factor)
  local values = list_of(self, args, "-values", "-filePath")
  if not values then give_up "a series Path is read with -values or -filePath" end
  local dt = arguments.number_of(self, args, "-dt")
  local times = not dt and list_of(self, args, "-time", "-fileTime")
  if not dt and not times then give_up "a series Path is read with -dt or -time" end
  if times and #times ~= #values then self:fail("it has %d times and %d values", #times, #values) end
  if dt and dt <= 0 then self:fail("-dt is %g; must be above 0", dt) end
  local start = (arguments.number_of(self, args, "-startTime") or 0) * self.time
  local points = {}
  for i, value in ipairs(values) do points[i] = { start + (dt and (i - 1) * dt or times[i]) * self.time, value } end
  if not arguments.option(args, "-useLast") then points[#points + 1] = { points[#points][1], 0 } end
  local first = points[1]
  if first[1] > 0 and first[2] ~= 0 then table.insert(points, 1, { first[1], 0 }) end
  if times and times[1] == 0 then
    dt = (times[#times] - times[1]) / (#times - 1)
    for i, t in ipairs(times) do
      if math.abs(t - (i - 1) * dt) > 1e-6 * dt * #times then dt = nil break end
    end
  end
  return { factor = factor, history = points, dt = dt and start == 0 and dt * self.time or nil, values = values }
end
readers.Series = readers.Path

--- A series by its type and the arguments behind it.
function series.read(self, kind, args)
  local factor = arguments.number_of(self, args, "-factor", "-fact", "-cFactor") or 1
  if not readers[kind] then give_up("series %s is not read", kind) end
  return readers[kind](self, args, factor)
end

return series
