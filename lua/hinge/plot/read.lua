-- Reads the table of a plot: checks each field and copies it, with numbers in place of names of categories.
local core = require "hinge.core"
local check = require "hinge.library.check"

local read = {}

-- The eight colours of series in their order, which colour-blind readers can tell apart, and grey.
read.colours = { 0x0072b2, 0xd55e00, 0x009e73, 0xcc79a7, 0xe69f00, 0x56b4e9, 0x000000, 0xf0e442 }
local colour_names = { blue = 1, red = 2, green = 3, purple = 4, orange = 5, sky = 6, black = 7, yellow = 8 }
read.grey = 0x6e747c
local styles = { "line", "points", "line and points", "band", "bars" }
local marks = { "circle", "square", "triangle", "diamond", "open circle", "open square", "open triangle",
  "open diamond" } -- a picture in grey tells series by them

-- A script in the sandbox may replace the functions of hinge.check, but not this one.
local function fail(format, ...) core.input_error(format:format(...)) end

local function complain(where, field, value, allowed)
  fail("%s%s field '%s' is %s; must %s", where, where:find ":$" and "" or ":", field, value, allowed)
end

local panel_rules = { title = { "string", optional = true }, x_label = { "string", optional = true },
  y_label = { "string", optional = true }, log_x = { "boolean", default = false },
  log_y = { "boolean", default = false }, series = { "table", optional = true }, lines = { "table", optional = true },
  x_range = { "table", optional = true }, y_range = { "table", optional = true } }
local size_rules = { width = { "number", whole = true, at_least = 64, at_most = 8192, optional = true },
  height = { "number", whole = true, at_least = 64, at_most = 8192, optional = true } }
local series_rules = { name = { "string", optional = true }, dashed = { "boolean", default = false },
  faint = { "boolean", default = false } }
for _, name in ipairs { "x", "y", "low", "high", "style", "colour", "labels", "mark" } do
  series_rules[name] = { "any" }
end
local line_rules = { x = { "number", optional = true }, y = { "number", optional = true },
  name = { "string", optional = true }, dashed = { "boolean", default = true }, colour = { "any" } }

local function joined(...)
  local all = {}
  for _, rules in ipairs { ... } do
    for name, rule in pairs(rules) do all[name] = rule end
  end
  return all
end
local single_rules = joined(panel_rules, size_rules)
local sheet_rules = joined(size_rules, { title = { "string", optional = true }, panels = { "table", optional = true },
  columns = { "number", whole = true, at_least = 1, default = 1 }, share_x = { "boolean", default = false } })

-- Fields by their rules; those of kind "any", and tables that have messages of their own, are copied as they are.
local function options(where, given, rules)
  local plain, own = {}, {}
  for name, rule in pairs(rules) do
    local kept = rule[1] == "any" or rule[1] == "table"
    plain[name] = kept and { "table", optional = true } or rule
    if kept then own[#own + 1] = name end
  end
  if type(given) ~= "table" then fail("%s: takes a table of options, got %s", where, check.show(given)) end
  local rest = {}
  for name, value in pairs(given) do rest[name] = value end
  local copied = {}
  for _, name in ipairs(own) do copied[name], rest[name] = given[name], nil end
  local result = check.options(where:gsub(":$", ""), rest, plain)
  for name, value in pairs(copied) do result[name] = value end
  return result
end

local function list_of(where, name, value, what)
  if type(value) ~= "table" then complain(where, name, check.show(value), "be a list of " .. what) end
  return value
end

local function finite(v) return type(v) == "number" and v == v and math.abs(v) < math.huge end

-- Numbers of a list as they are; false for anything else, which leaves a gap.
local function numbers(where, name, value)
  local list, copy = list_of(where, name, value, "numbers"), {}
  for i = 1, #list do
    local v = list[i]
    copy[i] = finite(v) and v + 0.0
  end
  return copy
end

local function texts(where, name, value)
  if value == nil then return {} end
  local list, copy = list_of(where, name, value, "texts"), {}
  for i = 1, #list do
    local v = list[i]
    copy[i] = (type(v) == "string" or type(v) == "number") and tostring(v) or ""
  end
  return copy
end

-- x or y of a series: numbers, or names of categories, which get their numbers in the order in which they come.
local function places(where, axis, value, names)
  local list = list_of(where, axis, value, "numbers")
  if #list == 0 then return {} end
  local named = type(list[1]) == "string"
  if names.used ~= nil and names.used ~= named then
    complain(where, axis, named and "names" or "numbers", ("hold %s as in the series before: an axis has one or the "
      .. "other"):format(named and "numbers" or "names"))
  end
  names.used = named
  if not named then return numbers(where, axis, list) end
  local copy = {}
  for i, text in ipairs(texts(where, axis, list)) do
    if not names.at[text] then
      names.list[#names.list + 1] = text
      names.at[text] = #names.list
    end
    copy[i] = names.at[text]
  end
  return copy
end

local function as_many(where, name, list, n)
  if #list == n then return list end
  return complain(where, name, check.count(#list, name == "labels" and "text" or "number"),
    ("hold as many as x, %d"):format(n))
end

local function colour(where, value)
  if value == nil then return nil end
  local hint = ""
  if type(value) == "string" then
    if value == "grey" then return read.grey end
    if colour_names[value] then return read.colours[colour_names[value]] end
    local hex = value:match "^#(%x%x%x%x%x%x)$"
    if hex then return tonumber(hex, 16) end
    local names = check.keys(colour_names)
    names[#names + 1] = "grey"
    hint = core.did_you_mean(value, names)
  elseif type(value) == "table" and #value == 3 then
    local sum = 0
    for i = 1, 3 do
      local v = value[i]
      sum = sum and finite(v) and v >= 0 and v <= 1 and sum * 256 + math.floor(255 * v + 0.5)
    end
    if sum then return sum end
  end
  return complain(where, "colour", type(value) == "table" and "a table" or check.show(value),
    "be black, blue, green, grey, orange, purple, red, sky or yellow, '#rrggbb', or three numbers "
    .. "{ red, green, blue } from 0 to 1" .. hint)
end

local function style_of(where, given)
  local between = given.low ~= nil or given.high ~= nil
  local style = given.style
  if style == nil then return between and "band" or "line" end
  local dots = style == "points" or style == "line and points"
  for _, name in ipairs(styles) do
    if name == style then
      if between and style ~= "band" and not dots then
        complain(where, "style", "'" .. style .. "'", "be 'band', 'points' or 'line and points', which have "
          .. "low and high")
      end
      return name
    end
  end
  return complain(where, "style", check.show(style), "be one of '" .. table.concat(styles, "', '") .. "'"
    .. (type(style) == "string" and core.did_you_mean(style, styles) or ""))
end

local function mark_of(where, given, style)
  if given.mark == nil then return nil end
  if style ~= "points" and style ~= "line and points" then
    complain(where, "mark", check.show(given.mark), "be left out: only points have one")
  end
  for i, name in ipairs(marks) do
    if name == given.mark then return i end
  end
  return complain(where, "mark", check.show(given.mark), "be one of '" .. table.concat(marks, "', '") .. "'"
    .. (type(given.mark) == "string" and core.did_you_mean(given.mark, marks) or ""))
end

-- low and high of points: the ends of an upright bar through each.
local function read_bars(where, given, s)
  for _, name in ipairs { "low", "high" } do
    if given[name] == nil then fail("%s: field '%s' is missing; a bar has low and high", where, name) end
    s["bar_" .. name] = as_many(where, name, numbers(where, name, given[name]), #s.x)
  end
end

local function read_series(where, given, place, names)
  given = options(where, given, series_rules)
  local s = { place = place, name = given.name or "", style = style_of(where, given), dashed = given.dashed,
    faint = given.faint }
  s.x = places(where, "x", given.x, names.x)
  if s.style == "band" then
    if given.y ~= nil then complain(where, "y", "there", "be left out: a band has low and high") end
    s.y = as_many(where, "low", numbers(where, "low", given.low), #s.x)
    s.high = as_many(where, "high", numbers(where, "high", given.high), #s.x)
  else
    s.y = as_many(where, "y", places(where, "y", given.y, names.y), #s.x)
    if given.low ~= nil or given.high ~= nil then read_bars(where, given, s) end
  end
  s.mark = mark_of(where, given, s.style)
  s.colour = colour(where, given.colour)
  s.labels = texts(where, "labels", given.labels)
  if #s.labels > #s.x then as_many(where, "labels", s.labels, #s.x) end
  return s
end

local function range(where, name, value, log)
  if value == nil then return nil end
  local low, high
  if type(value) == "table" and #value == 2 then low, high = value[1], value[2] end
  if finite(low) and finite(high) and low < high and not (log and low <= 0) then return { low, high } end
  return complain(where, name, low and ("{%s, %s}"):format(check.show(low), check.show(high)) or check.show(value),
    "be { low, high }, two numbers with low below high" .. (log and ", above 0 on a logarithmic axis" or ""))
end

local function read_line(where, given)
  given = options(where, given, line_rules)
  local one = "; a line has one of them: x if it is upright, y if it is level"
  if given.x and given.y then complain(where, "y", check.show(given.y), "be left out beside x" .. one) end
  if not given.x and not given.y then fail("%s: field 'x' is missing; give it or y%s", where, one) end
  return { upright = given.x ~= nil, at = given.x or given.y, name = given.name or "", dashed = given.dashed,
    colour = colour(where, given.colour) }
end

local function read_panel(where, given)
  local panel = { title = given.title or "", x_label = given.x_label or "", y_label = given.y_label or "",
    log_x = given.log_x, log_y = given.log_y, series = {}, lines = {},
    x_range = range(where, "x_range", given.x_range, given.log_x),
    y_range = range(where, "y_range", given.y_range, given.log_y) }
  local names = { x = { list = {}, at = {} }, y = { list = {}, at = {} } }
  local function item(kind, i) return where .. (where:find ":$" and " " or ", ") .. kind .. " " .. i end
  for i, s in ipairs(list_of(where, "series", given.series, "{ name =, x =, y = }")) do
    panel.series[i] = read_series(item("series", i), s, i, names)
  end
  for i, l in ipairs(given.lines and list_of(where, "lines", given.lines, "{ x = } and { y = }") or {}) do
    panel.lines[i] = read_line(item("line", i), l)
  end
  for _, axis in ipairs { "x", "y" } do
    if #names[axis].list > 0 then
      panel["categories_" .. axis] = names[axis].list
      if panel["log_" .. axis] or panel[axis .. "_range"] then
        complain(where, ("%s_range or log_%s"):format(axis, axis), "given", ("be left out where %s holds names"):format(
          axis))
      end
    end
  end
  if panel.categories_x and panel.categories_y then
    complain(where, "series", "names along x and y", "have numbers along one of the two axes")
  end
  return panel
end

local function kind_of(panel)
  return panel.categories_x and "names along x" or panel.log_x and "a logarithmic x axis" or "a linear x axis"
end

local function has_values(panel)
  for _, s in ipairs(panel.series) do
    if #s.x > 0 then return true end
  end
  return false
end

-- With share_x there is one scale below a column, which must hold for all of its panels.
local function check_shared(where, plot)
  local function differ(i, own, k, theirs)
    complain(where, "share_x", ("true and panel %d has %s"):format(i, own),
      ("have the same as panel %d in its column, which has %s"):format(k, theirs))
  end
  local function show_range(r) return ("x_range {%s, %s}"):format(check.show(r[1]), check.show(r[2])) end
  for i, panel in ipairs(plot.panels) do
    for k = i - plot.columns, 1, -plot.columns do
      local above = plot.panels[k]
      local a, b = panel.x_range, above.x_range
      if a and b and (a[1] ~= b[1] or a[2] ~= b[2]) then differ(i, show_range(a), k, show_range(b)) end
      if has_values(panel) and has_values(above) then
        if kind_of(panel) ~= kind_of(above) then differ(i, kind_of(panel), k, kind_of(above)) end
        if table.concat(panel.categories_x or {}, "\0") ~= table.concat(above.categories_x or {}, "\0") then
          differ(i, "other names along x", k, "its own")
        end
      end
    end
  end
end

--- A plot with all that may be left out filled in: title, panels, columns, rows, share_x, width, height (pixels).
-- Each panel has its series, each with lists x and y (and high of a band) in which false is a gap.
function read.plot(where, given)
  local several = given.panels ~= nil
  local o = options(where, given, several and sheet_rules or single_rules)
  local plot = { title = several and o.title or "", columns = several and o.columns or 1, share_x = o.share_x or false,
    panels = {} }
  if several then
    for i, panel in ipairs(list_of(where, "panels", o.panels, "{ series =, ... }")) do
      local own = ("%s: panel %d"):format(where, i)
      plot.panels[i] = read_panel(own, options(own, panel, panel_rules))
    end
    if #plot.panels == 0 then complain(where, "panels", "{}", "hold at least one { series =, ... }") end
    plot.columns = math.min(plot.columns, #plot.panels)
  else
    plot.panels[1] = read_panel(where .. ":", o)
  end
  plot.rows = math.ceil(#plot.panels / plot.columns)
  if plot.share_x then check_shared(where, plot) end
  local columns, rows = plot.columns, plot.rows
  plot.width = o.width or (columns == 1 and 1200 or math.min(800 * columns, 8192))
  plot.height = o.height or (rows > 1 and math.min(160 + 420 * rows, 8192) or columns > 1 and 600 or 900)
  return plot
end

return read
