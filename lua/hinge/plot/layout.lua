-- Where the parts of a plot stand: ranges of axes, frames of panels, and places of legends and labels that hide least.
local layout = {}

local inf = math.huge
layout.bars_share = 0.8 -- of the distance between two places, taken by all bars there
local letter = 0.6      -- width of a letter, in its size

local function is_in(range, v) return not range or v >= range[1] and v <= range[2] end
local function usable(v, log) return v and (not log or v > 0) end

--- Whether value i of a series can be shown: a number, and above 0 on a logarithmic axis.
function layout.shown(panel, s, i)
  if not usable(s.x[i], panel.log_x) then return false end
  if s.style == "band" then return s.y[i] and usable(s.high[i], panel.log_y) end -- its foot may lie below the axis
  return usable(s.y[i], panel.log_y)
end

function layout.width_of(text, size) return (utf8.len(text) or #text) * letter * size end

-- The smallest distance between two bars.
local function spacing(panel)
  if panel.categories_x or panel.categories_y then return 1 end
  local at, least = {}, inf
  for _, s in ipairs(panel.series) do
    for i = 1, s.style == "bars" and #s.x or 0 do
      if layout.shown(panel, s, i) then at[#at + 1] = s.x[i] end
    end
  end
  table.sort(at)
  for i = 2, #at do
    if at[i] > at[i - 1] then least = math.min(least, at[i] - at[i - 1]) end
  end
  return least < inf and least or 1
end

-- The number of a mark as gnuplot writes it with %h: 2.2e+08 is 2.2 x 10^8.
local function mark_text(v)
  local mantissa, power = ("%g"):format(v):match "^(.-)e([+-]%d+)$"
  return mantissa and ("%s×10%d"):format(mantissa, math.tointeger(tonumber(power))) or ("%g"):format(v)
end

--- The step of a linear axis at which the numbers of its marks, beside each other on `width`, leave room between them;
--- nil where they do at the step of ten marks or so, which gnuplot takes by itself.
function layout.step_of(ends, width, em)
  local range, first = math.abs(ends[2] - ends[1]), nil
  if not (range > 0 and range < math.huge) then return nil end
  local power = 10.0 ^ math.floor(math.log(range / 10, 10))
  for _, times in ipairs { 1, 2, 5, 10, 20, 50, 100 } do
    local step, widest = times * power, 0
    local low, high = math.ceil(math.min(ends[1], ends[2]) / step), math.floor(math.max(ends[1], ends[2]) / step)
    if high - low <= 11 then
      first = first or step
      for k = low, high do widest = math.max(widest, layout.width_of(mark_text(k * step), em)) end
      if widest + 0.8 * em <= width * step / range then return step > first and step or nil end
    end
  end
end

--- What the panel's series take of both axes: sets bars, dots, lies, spacing, extent.
function layout.measure(panel)
  local x, y, all_y = { inf, -inf }, { inf, -inf }, { inf, -inf }
  local function add(range, v) range[1], range[2] = math.min(range[1], v), math.max(range[2], v) end
  panel.lies, panel.spacing, panel.bars, panel.any = panel.categories_y ~= nil, spacing(panel), 0, false
  for _, s in ipairs(panel.series) do
    local bars = s.style == "bars"
    local reach = bars and not panel.lies and panel.spacing / 2 or 0
    if bars then panel.bars = panel.bars + 1 end
    panel.dots = panel.dots or s.style == "points" or s.style == "line and points" or #s.labels > 0
    for i = 1, #s.x do
      if layout.shown(panel, s, i) then
        panel.any = true
        if is_in(panel.y_range, s.y[i]) then add(x, s.x[i] - reach) add(x, s.x[i] + reach) end
        for _, values in pairs { s.y, s.high, s.bar_low, s.bar_high } do
          local v = values[i]
          if usable(v, panel.log_y) then
            add(all_y, v)
            if is_in(panel.x_range, s.x[i]) then add(y, v) end
          end
        end
      end
    end
    if bars and #s.x > 0 and not (panel.lies and panel.log_x or not panel.lies and panel.log_y) then
      add(panel.lies and x or y, 0)
    end
  end
  if y[1] > y[2] then y = all_y end
  for _, line in ipairs(panel.lines) do
    local range = line.upright and x or y
    if range[1] <= range[2] and usable(line.at, panel[line.upright and "log_x" or "log_y"]) then add(range, line.at) end
  end
  panel.extent_x, panel.extent_y = x, y
end

-- Ends of an axis: those given, or what is there with some room; nothing is drawn below zero just to leave room.
local function ends(given, extent, log, padding)
  if given then return given end
  local low, high = extent[1], extent[2]
  if low > high then return { log and 0.1 or 0, 1 } end
  if log then
    if high / low < 1.01 then low, high = low / 2, high * 2 end
    local factor = (high / low) ^ padding
    return { low / factor, high * factor }
  end
  local largest = math.max(math.abs(low), math.abs(high))
  if high - low <= 1e-9 * largest then
    local room = largest > 0 and 0.1 * largest or 1
    low, high = low - room, high + room
  end
  local length = high - low
  return { low >= 0 and low < 0.15 * length and 0 or low - padding * length,
    high <= 0 and -high < 0.15 * length and 0 or high + padding * length }
end

--- Sets x_ends and y_ends of each panel; those of a column agree where they share their x axis.
function layout.ranges(plot)
  for i, panel in ipairs(plot.panels) do
    local given, extent = panel.x_range, { panel.extent_x[1], panel.extent_x[2] }
    for k = (i - 1) % plot.columns + 1, plot.share_x and #plot.panels or 0, plot.columns do
      local other = plot.panels[k]
      given = given or other.x_range
      extent = { math.min(extent[1], other.extent_x[1]), math.max(extent[2], other.extent_x[2]) }
    end
    local names = panel.categories_x
    panel.x_ends = names and { 0.5, #names + 0.5 }
      or ends(given, extent, panel.log_x, panel.lies and 0.16 or panel.dots and 0.04 or 0)
    names = panel.categories_y
    panel.y_ends = names and { #names + 0.5, 0.5 } or ends(panel.y_range, panel.extent_y, panel.log_y, 0.06)
  end
end

--- Whether the powers of ten of a logarithmic axis are written out: 0.001 to 10000 are read more easily so.
function layout.plain_powers(range) return range[1] > 0.9e-3 and range[2] < 1.1e4 end

--- The text that gnuplot puts beside the marks of an axis at most, in letters. Its steps are 0.2, 0.5 or 1 times a
--- power of ten: 5 to 10 marks. On a logarithmic axis they are 1, 2, 5 or powers of ten.
function layout.letters(range, log)
  if log then
    if range[2] / range[1] >= 100 and not layout.plain_powers(range) then return 4 end -- 10 with its power
    return math.max(#("%g"):format(10.0 ^ math.ceil(math.log(range[1] / 9, 10))), #("%.0f"):format(range[2]))
  end
  local from, to = math.min(range[1], range[2]), math.max(range[1], range[2])
  local power = 10 ^ math.floor(math.log(to - from, 10))
  local of_power = (to - from) / power
  local step = power * (of_power < 2 and 0.2 or of_power < 5 and 0.5 or 1)
  local most = 1
  for k = math.ceil(from / step), math.floor(to / step) do most = math.max(most, #("%g"):format(k * step)) end
  return math.min(most, 8)
end

-- What is drawn in a panel, as pixels from the lower left corner of its frame.
local Ground = {}
Ground.__index = Ground

--- `width`, `height`: of the frame, pixels.
function layout.ground(panel, width, height, em)
  local ground = setmetatable({ panel = panel, width = width, height = height, em = em, points = {} }, Ground)
  for _, s in ipairs(panel.series) do ground:series(s) end
  return ground
end

local function share(v, range, log)
  if log then return v > 0 and math.log(v / range[1]) / math.log(range[2] / range[1]) or -1 end
  return (v - range[1]) / (range[2] - range[1])
end

function Ground:pixel(x, y)
  return share(x, self.panel.x_ends, self.panel.log_x) * self.width,
    share(y, self.panel.y_ends, self.panel.log_y) * self.height
end

function Ground:take(x, y)
  if x >= -1 and x <= self.width + 1 and y >= -1 and y <= self.height + 1 then
    local p = self.points
    p[#p + 1], p[#p + 2] = x, y
  end
end

-- Places of a straight line, half a letter apart.
function Ground:line(x0, y0, x1, y1)
  local n = math.min(400, math.ceil(math.max(math.abs(x1 - x0), math.abs(y1 - y0), 1) / (0.5 * self.em)))
  for k = 1, n do self:take(x0 + (x1 - x0) * k / n, y0 + (y1 - y0) * k / n) end
end

function Ground:box(x, y, width, height)
  for i = 0, math.ceil(width / (0.5 * self.em)) do
    for k = 0, math.ceil(height / (0.5 * self.em)) do
      self:take(math.min(x + 0.5 * self.em * i, x + width), math.min(y + 0.5 * self.em * k, y + height))
    end
  end
end

function Ground:series(s)
  local panel, before_x, before_y, before_high = self.panel, nil, nil, nil
  for i = 1, #s.x do
    if not layout.shown(panel, s, i) then before_x = nil
    else
      local x, y = self:pixel(s.x[i], s.y[i])
      if s.style == "bars" then
        local half = layout.bars_share * panel.spacing / 2
        local x0, y0 = self:pixel(panel.lies and (panel.log_x and s.x[i] or 0) or s.x[i] - half,
          panel.lies and s.y[i] + half or (panel.log_y and s.y[i] or 0))
        local x1, y1 = self:pixel(panel.lies and s.x[i] or s.x[i] + half, panel.lies and s.y[i] - half or s.y[i])
        self:box(math.min(x0, x1), math.min(y0, y1), math.abs(x1 - x0), math.abs(y1 - y0) + self.em)
      elseif s.style == "band" then
        local _, high = self:pixel(s.x[i], s.high[i])
        if not before_x then before_x, before_y, before_high = x, y, high end
        local n = math.min(400, math.ceil(math.abs(x - before_x) / (0.5 * self.em)) + 1)
        for k = 1, n do
          local at, foot = before_x + (x - before_x) * k / n, before_y + (y - before_y) * k / n
          self:line(at, math.max(foot, 0), at, before_high + (high - before_high) * k / n)
        end
        before_x, before_y, before_high = x, y, high
      else
        if s.style ~= "points" and before_x then self:line(before_x, before_y, x, y) end
        self:take(x, y)
        if s.bar_low and s.bar_low[i] and s.bar_high[i] then
          local _, foot = self:pixel(s.x[i], s.bar_low[i])
          local _, head = self:pixel(s.x[i], s.bar_high[i])
          self:line(x, math.max(foot, 0), x, head)
        end
        before_x, before_y = x, y
      end
    end
  end
end

--- How much is drawn within a box, and how far it reaches out of the frame.
function Ground:hidden(x, y, width, height)
  local n, p = 0, self.points
  for i = 1, #p, 2 do
    if p[i] >= x and p[i] <= x + width and p[i + 1] >= y and p[i + 1] <= y + height then n = n + 1 end
  end
  local out = x < 0 or y < 0 or x + width > self.width or y + height > self.height
  return n, out
end

--- The corner or side of the frame where a legend of that size hides nothing, as gnuplot names it; nil: none.
function Ground:legend(width, height)
  if width > self.width or height > self.height then return nil end
  for _, place in ipairs { { "top right", 1, 1 }, { "top left", 0, 1 }, { "bottom right", 1, 0 },
    { "bottom left", 0, 0 }, { "center right", 1, 0.5 }, { "center left", 0, 0.5 }, { "top center", 0.5, 1 },
    { "bottom center", 0.5, 0 } } do
    local x, y = place[2] * (self.width - width), place[3] * (self.height - height)
    if self:hidden(x, y, width, height) == 0 then
      self:box(x, y, width, height)
      return place[1]
    end
  end
end

local around = { { 0.6, 0, "left" }, { 0.4, 0.75, "left" }, { 0.4, -0.75, "left" }, { -0.6, 0, "right" },
  { -0.4, 0.75, "right" }, { -0.4, -0.75, "right" }, { 0, 0.95, "center" }, { 0, -0.95, "center" },
  { 0.4, 1.6, "left" }, { 0.4, -1.6, "left" }, { -0.4, 1.6, "right" }, { -0.4, -1.6, "right" } }

--- Beside the point x, y (values): which way the text goes, and its offset in em; nil where it may be left out and
-- finds no room.
function Ground:label(x, y, text, size, may_go)
  local px, py = self:pixel(x, y)
  local width, best, least = layout.width_of(text, size), nil, inf
  for i, place in ipairs(around) do
    local left = px + place[1] * self.em - (place[3] == "right" and width or place[3] == "center" and width / 2 or 0)
    local foot = py + place[2] * self.em - 0.55 * size
    local n, out = self:hidden(left, foot, width, 1.1 * size)
    -- what is near counts too: beside another point or over another curve it would seem to belong there
    local margin = 0.35 * self.em
    local near = self:hidden(left - margin, foot - margin, width + 2 * margin, 1.1 * size + 2 * margin)
    local cost = 3 * n + near + 0.3 * i + (i > 8 and 3 or 0) + (out and 90 or 0)
    if cost < least then best, least = { place = place, left = left, foot = foot }, cost end
  end
  if may_go and least > 5 then return nil end
  self:box(best.left, best.foot, width, 1.1 * size)
  return best.place[3], best.place[1], best.place[2]
end

--- Of a line with more than four values a column of `columns`, those that can be seen: the first, last, lowest and
-- highest of each column. Nil: all of them.
function layout.thin(panel, s, columns)
  if s.style ~= "line" or #s.x < 4 * columns then return nil end
  local kept, bucket, first, least, most, last = {}, nil, nil, nil, nil, nil
  local function flush()
    if not first then return end
    local list = { first, least, most, last }
    table.sort(list)
    for k, i in ipairs(list) do
      if i ~= list[k - 1] then kept[#kept + 1] = i end
    end
  end
  for i = 1, #s.x do
    local b = layout.shown(panel, s, i) and math.floor(share(s.x[i], panel.x_ends, panel.log_x) * columns)
    if b ~= bucket then
      flush()
      bucket, first, least, most = b, i, i, i
    end
    last = i
    if b and s.y[i] < s.y[least] then least = i end
    if b and s.y[i] > s.y[most] then most = i end
  end
  flush()
  return kept
end

return layout
