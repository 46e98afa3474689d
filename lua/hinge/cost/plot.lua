-- The work-precision picture: error against time on logarithmic axes. A setting is a point, whose mark shows the
-- elements and whose colour the method. A line goes through the front of each method. Chaotic answers have panels of
-- their own, with mean and scatter.
local check = require "hinge.library.check"
local compare = require "hinge.cost.compare"
local headline = require "hinge.cost.headline"
local words = require "hinge.cost.words"

local plot = {}
local exact = 1e-10 -- errors below it are rounding: drawn beneath all others
-- Of methods, in their order. Readers of a picture in grey tell them by open marks, dashes, and how dark they are.
local colours = { "blue", "red", "black", "orange", "green", "purple" }
local marks = { "circle", "square", "triangle", "diamond" }
local most_panels = 3 -- of chaotic answers
local most_names = 6  -- in full; where there are more, the marks tell the elements

local function place_of(list, value)
  for i, v in ipairs(list) do
    if v == value then return i end
  end
  list[#list + 1] = value
  return #list
end

-- The numbers and methods of the settings, methods in the order of the lists. `elements`: the input that marks show,
-- where another number varies beside it.
local function look_of(result)
  local look = { numbers = {}, others = {}, methods = {}, counts = {} }
  for _, input in ipairs(result.inputs) do
    if input.side then look.numbers[#look.numbers + 1] = input end
  end
  for _, input in ipairs(look.numbers) do
    if #look.numbers > 1 and input.name:find "^elements" then look.elements = input
    else look.others[#look.others + 1] = input end
  end
  local names, rank = {}, {}
  for _, s in ipairs(result.settings) do
    local name, places = words.method(result.inputs, s.values), {}
    for i, input in ipairs(result.inputs) do
      places[i] = input.side and "" or ("%03d"):format(place_of(input.values, s.values[input.name]))
    end
    names[name], rank[name] = true, table.concat(places)
  end
  look.methods = check.keys(names)
  table.sort(look.methods, function(a, b) return rank[a] < rank[b] end)
  for _, value in ipairs(look.elements and look.elements.values or {}) do place_of(look.counts, value) end
  table.sort(look.counts)
  function look.of(s) -- numbers of the method and of the count of elements
    return place_of(look.methods, words.method(result.inputs, s.values)),
      look.elements and place_of(look.counts, s.values[look.elements.name])
  end
  return look
end

-- What names a setting: its numbers. short: without the elements, where something else is left to say.
local function label_of(look, s, short)
  local label = short and words.label(look.others, s.values) or ""
  if label == "" then label = words.label(look.numbers, s.values) end
  return (s.chosen and "chosen: " or "") .. label
end

-- How a method and a count of elements are drawn. Without counts a method has a mark of its own.
local function style_of(method, count, style)
  local open = count and method % 2 == 0 and "open " or ""
  return { style = style, colour = colours[(method - 1) % #colours + 1], dashed = method % 2 == 0,
    mark = style ~= "line" and open .. marks[((count or method) - 1) % #marks + 1] or nil, x = {}, y = {} }
end

-- What the legend says: the methods, then the marks.
local function add_legend(look, series)
  local function add(s, name)
    s.name, s.x, s.y = name, { false }, { false }
    series[#series + 1] = s
  end
  for i, name in ipairs(#look.methods > 1 and look.methods or {}) do
    add(style_of(i, look.elements and 1, "line and points"), name)
  end
  for k, count in ipairs(#look.counts > 1 and look.counts or {}) do
    local s = style_of(1, k, "points")
    s.colour = "grey"
    add(s, words.label({ look.elements }, { [look.elements.name] = count }))
  end
end

-- The points of the settings: { setting =, y =, low =, high =, label = }, of one look each series.
local function add_points(look, series, points)
  local of = {}
  for _, p in ipairs(points) do
    local method, count = look.of(p.setting)
    local key = method .. " " .. (count or "")
    local s = of[key]
    if not s then
      s = style_of(method, count, "points")
      s.low, s.high, s.labels = {}, {}, {}
      of[key], series[#series + 1] = s, s
    end
    local i = #s.x + 1
    s.x[i], s.y[i], s.low[i], s.high[i], s.labels[i] = p.setting.seconds, p.y, p.low, p.high, p.label or ""
  end
end

-- A line through the settings of each method that no other one of it beats.
local function add_fronts(look, series, points)
  local items = {}
  for _, p in ipairs(points) do
    local method = look.of(p.setting)
    items[method] = items[method] or {}
    table.insert(items[method], { time = p.setting.seconds, error = p.y })
  end
  for method in ipairs(look.methods) do
    local line = style_of(method, nil, "line")
    for i, item in ipairs(compare.front(items[method] or {})) do line.x[i], line.y[i] = item.time, item.error end
    if #line.x > 1 then series[#series + 1] = line end
  end
end

-- Settings of which only a lower bound of the error is known: grey, with a bar without end.
local function add_bounds(result, series, height, top)
  local bounds = { name = "at least", style = "points", colour = "grey", mark = "triangle", x = {}, y = {}, low = {},
    high = {} }
  for _, s in ipairs(result.settings) do
    local i = #bounds.x + 1
    if s.error and s.above then
      bounds.x[i], bounds.y[i], bounds.low[i], bounds.high[i] = s.seconds, height(s.error), height(s.error), top
    end
  end
  if #bounds.x > 0 then series[#series + 1] = bounds end
end

local function error_panel(result, look)
  local least, most, any_exact, any_below = math.huge, result.within, false, false
  for _, s in ipairs(result.settings) do
    if s.error then
      any_exact, any_below = any_exact or s.error <= exact, any_below or s.below and s.error > exact
      if s.error > exact then least = math.min(least, s.error) end
      if s.error < math.huge then most = math.max(most, s.error) end
    end
  end
  local floor, series, points, known = least < math.huge and least / 10 or exact, {}, {}, false
  local answer, named = headline.named(result), 0
  local function is_named(s) return s.front or s.chosen or s == answer end
  local function height(error) return 100 * (error > exact and error or floor) end
  for _, s in ipairs(result.settings) do
    if s.error and not s.above then
      named = named + (is_named(s) and 1 or 0)
      points[#points + 1] = { setting = s, y = height(s.error), low = height(s.below and s.error or s.low or s.error),
        high = height(math.min(s.high or s.error, 10 * most)) }
    end
    known = known or s.error ~= nil
  end
  for _, p in ipairs(points) do
    p.label = is_named(p.setting) and label_of(look, p.setting, named > most_names)
  end
  if not known then return nil end
  add_fronts(look, series, points)
  add_points(look, series, points)
  add_bounds(result, series, height, 200 * most)
  add_legend(look, series)
  local notes = { any_exact and ("exact: at %.1g"):format(100 * floor) or nil }
  if any_below then notes[#notes + 1] = "without a bar: at most" end
  return { title = "Error against time" .. (result.quantity and ", " .. result.quantity or ""),
    x_label = "time of the steps, s", log_x = true, log_y = true, series = series,
    y_label = "error, %" .. (#notes > 0 and " (" .. table.concat(notes, "; ") .. ")" or ""),
    lines = { { y = 100 * result.within, name = ("asked: %.4g %%"):format(100 * result.within) } } }
end

-- Mean and one standard deviation to both sides. Named is the cheapest setting that cannot be told apart from the
-- finest one.
local function mean_panel(result, look, name)
  local points, finest, named, series = {}, nil, false, {}
  for _, s in ipairs(result.settings) do
    local m = s.means and s.means[name]
    if m and m.mean then
      local half = m.scatter * math.abs(m.mean)
      points[#points + 1] = { setting = s, y = m.mean, low = m.mean - half, high = m.mean + half,
        label = not m.apart and not named and label_of(look, s) }
      named = named or not m.apart
      if s.label == result.quantities[name].standard then finest = m.mean end
    end
  end
  if #points == 0 then return nil end
  add_points(look, series, points)
  add_legend(look, series)
  return { title = "Mean and scatter against time, " .. name, x_label = "time of the steps, s", y_label = name,
    log_x = true, series = series, lines = finest and { { y = finest, name = "mean of the finest" } } or nil }
end

--- Draws cost.png. job: an object with the method plot(what, filename).
function plot.draw(result, job)
  local look = look_of(result)
  local panels = { error_panel(result, look) }
  for _, name in ipairs(check.keys(result.quantities)) do
    local q = result.quantities[name]
    if (result.quantity or name) == name and q.alike and q.kind == "number" and #panels < most_panels then
      panels[#panels + 1] = mean_panel(result, look, name)
    end
  end
  if #panels == 0 then return end
  job:plot({ panels = panels, width = 1200, height = 60 + 700 * #panels }, "cost.png")
end

return plot
