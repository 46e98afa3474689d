-- The work-precision picture: error against time on logarithmic axes, a line a method, each setting once. Chaotic
-- answers have panels of their own, with mean and scatter.
local check = require "hinge.library.check"
local words = require "hinge.cost.words"

local plot = {}
local exact = 1e-10 -- errors below it are rounding: drawn beneath all others
-- Of methods and of numbers of elements, in their order. A reader of a grey picture has the marks and the dashes.
local colours = { "blue", "red", "green", "purple", "orange", "sky", "black", "yellow" }
local marks = { "circle", "square", "triangle", "diamond" }
local most_panels = 3 -- of chaotic answers

local function among(list, value)
  for i, v in ipairs(list) do
    if v == value then return i end
  end
  list[#list + 1] = value
  return #list
end

-- The words of a setting: "asi-gauss, explicit"; "" if none varies.
local function method_of(inputs, s)
  local parts = {}
  for _, input in ipairs(inputs) do
    if not input.side then
      local value = s.values[input.name]
      parts[#parts + 1] = (type(value) == "string" and "" or input.name .. " ") .. words.value(input.name, value)
    end
  end
  return table.concat(parts, ", ")
end

-- How settings are drawn: methods in their order, and the input by which lines of one method are told apart: the
-- elements, if another number varies along the line.
local function look_of(result)
  local look = { methods = {}, counts = {}, numbers = {}, inputs = result.inputs }
  for _, input in ipairs(result.inputs) do
    if input.side then look.numbers[#look.numbers + 1] = input end
  end
  for _, input in ipairs(look.numbers) do
    if #look.numbers > 1 and input.name:find "^elements" then look.elements = input end
  end
  for _, value in ipairs(look.elements and look.elements.values or {}) do among(look.counts, value) end
  local names = {}
  for _, s in ipairs(result.settings) do names[method_of(result.inputs, s)] = true end
  look.methods = check.keys(names)
  return look
end

-- What names a setting in the picture: "2 ms, 4 elements", with its method if there are several. One is `chosen`.
local function label_of(look, s)
  return (s.chosen and "chosen: " or "") .. words.label(#look.methods > 1 and look.inputs or look.numbers, s.values)
end

-- The line of a setting, made if it is new: method by colour, elements by mark.
local function line_of(look, lines, s)
  local method, count = method_of(look.inputs, s), look.elements and s.values[look.elements.name]
  local key = method .. "\0" .. tostring(count)
  if not lines[key] then
    local number, parts = among(look.methods, method), {}
    if method ~= "" then parts[1] = method end
    if count then parts[#parts + 1] = words.label({ look.elements }, s.values) end
    local line = { name = #parts > 0 and table.concat(parts, ", ") or look.numbers[1].name, style = "line and points",
      colour = colours[(number - 1) % #colours + 1], dashed = number % 2 == 0,
      mark = marks[((count and among(look.counts, count) or number) - 1) % #marks + 1],
      x = {}, y = {}, low = {}, high = {}, labels = {} }
    lines[key], lines[#lines + 1] = line, line
  end
  return lines[key]
end

local function add(line, x, y, low, high, label)
  local i = #line.x + 1
  line.x[i], line.y[i], line.low[i], line.high[i], line.labels[i] = x, y, low, high, label or ""
end

-- Settings of which only a lower bound of the error is known: lighter, with a bar without end.
local function add_bounds(result, look, lines, height, top)
  local bounds = { name = "at least", style = "points", colour = "grey", mark = "triangle", x = {}, y = {}, low = {},
    high = {}, labels = {} }
  for _, s in ipairs(result.settings) do
    if s.error and s.above then add(bounds, s.seconds, height(s.error), height(s.error), top, label_of(look, s)) end
  end
  if #bounds.x > 0 then lines[#lines + 1] = bounds end
end

local function error_panel(result, look)
  local least, most, any_exact = math.huge, result.within, false
  for _, s in ipairs(result.settings) do
    if s.error then
      any_exact = any_exact or s.error <= exact
      if s.error > exact then least = math.min(least, s.error) end
      if s.error < math.huge then most = math.max(most, s.error) end
    end
  end
  local floor, lines, known = least < math.huge and least / 10 or exact, {}, false
  local function height(error) return 100 * (error > exact and error or floor) end
  for _, s in ipairs(result.settings) do -- the fastest first, so that a line goes from coarse to fine
    if s.error and not s.above then
      add(line_of(look, lines, s), s.seconds, height(s.error), height(s.low or s.error),
        height(math.min(s.high or s.error, 10 * most)), (s.front or s.chosen) and label_of(look, s))
    end
    known = known or s.error ~= nil
  end
  if not known then return nil end
  add_bounds(result, look, lines, height, 200 * most)
  return { title = "Error against time" .. (result.quantity and ", " .. result.quantity or ""),
    x_label = "time of the steps, s", log_x = true, log_y = true, series = lines,
    y_label = any_exact and ("error, %% (exact: at %.1g)"):format(100 * floor) or "error, %",
    lines = { { y = 100 * result.within, name = ("asked: %.4g %%"):format(100 * result.within) } } }
end

-- Mean and one standard deviation to both sides. Named is the cheapest setting that cannot be told apart from the
-- finest one.
local function mean_panel(result, look, name)
  local lines, finest, named = {}, nil, false
  for _, s in ipairs(result.settings) do
    local m = s.means and s.means[name]
    if m and m.mean then
      local half = m.scatter * math.abs(m.mean)
      add(line_of(look, lines, s), s.seconds, m.mean, m.mean - half, m.mean + half,
        not m.apart and not named and label_of(look, s))
      named = named or not m.apart
      if s.label == result.quantities[name].standard then finest = m.mean end
    end
  end
  if #lines == 0 then return nil end
  for _, line in ipairs(lines) do line.style = "points" end
  return { title = "Mean and scatter against time, " .. name, x_label = "time of the steps, s", y_label = name,
    log_x = true, series = lines, lines = finest and { { y = finest, name = "mean of the finest" } } or nil }
end

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
