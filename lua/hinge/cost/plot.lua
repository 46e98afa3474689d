-- The work-precision plot: error against time, a line for each method, the front marked.
local check = require "hinge.library.check"
local ladder = require "hinge.cost.ladder"
local methods = require "hinge.cost.methods"
local words = require "hinge.cost.words"

local plot = {}
local exact = 1e-10   -- errors below it are rounding: drawn beneath all others
-- Of the lines, in their order.
local colours = { "blue", "red", "green", "purple", "orange", "sky", "black", "yellow" }
local near = 1.05     -- two points on logarithmic axes lie on each other: neither is more than this times the other

local function method_of(result, s)
  local parts = {}
  for _, input in ipairs(result.inputs) do
    if not input.side then
      parts[#parts + 1] = (type(s.values[input.name]) == "string" and "" or input.name .. " ")
        .. words.value(input.name, s.values[input.name])
    end
  end
  return table.concat(parts, ", ")
end

-- What tells a setting on the front from the others of its line: "2 ms, 4 elements". Labels of all settings would hide
-- the points.
local function label_of(numbers, s) return s.front and words.label(numbers, s.values) or "" end

-- The settings with an error by method: { { name =, settings = }, ... }, by name.
local function group(result)
  local groups, by_name = {}, {}
  for _, s in ipairs(result.settings) do
    if s.error and not s.above then -- a lower bound is no point
      local name = method_of(result, s)
      if not by_name[name] then
        by_name[name] = { name = name, settings = {} }
        groups[#groups + 1] = by_name[name]
      end
      table.insert(by_name[name].settings, s)
    end
  end
  table.sort(groups, function(a, b) return a.name < b.name end)
  return groups
end

-- The points of a method's line. If one number is varied, these are all settings, the coarsest first. If several
-- numbers are varied, these are the best settings.
local function line_of(numbers, settings)
  if #numbers == 1 then
    table.sort(settings, function(a, b)
      return ladder.finer(numbers[1], b.values[numbers[1].name], a.values[numbers[1].name]) > 1
    end)
    return settings
  end
  local best = {}
  for i, item in ipairs(methods.front(settings)) do best[i] = item.setting end
  return best
end

-- The settings of a method that are not on its line. They are drawn faint, in its colour.
local function others_of(g, name, number, on_line, numbers, height)
  local others = { name = name, style = "points", faint = true, colour = colours[(number - 1) % #colours + 1],
    x = {}, y = {}, labels = {} }
  for _, s in ipairs(g.settings) do
    if not on_line[s] then
      local i = #others.x + 1
      others.x[i], others.y[i], others.labels[i] = s.seconds, height(s), label_of(numbers, s)
    end
  end
  return #others.x > 0 and others or nil
end

-- Whether half or more of the points of a line lie on points of earlier lines. A solid line would hide these.
local function hides(line, others)
  local hidden = 0
  for i, x in ipairs(line.x) do
    local found = false
    for _, other in ipairs(others) do
      for j, ox in ipairs(other.x) do
        found = found or math.max(x / ox, ox / x, line.y[i] / other.y[j], other.y[j] / line.y[i]) < near
      end
    end
    hidden = hidden + (found and 1 or 0)
  end
  return 2 * hidden >= #line.x
end

-- The chaotic answer that is drawn where no setting has an error: the chosen one, else the first one with numbers.
local function chaotic(result)
  for _, name in ipairs(check.keys(result.quantities)) do
    if (result.quantity or name) == name and result.quantities[name].alike
      and result.quantities[name].kind == "number" then return name end
  end
end

-- Means against time, each with a bar of one standard deviation to both sides; named are those that cannot be told
-- apart from the finest.
local function draw_means(result, job, name)
  local means = { name = "mean", style = "points", colour = "blue", x = {}, y = {}, labels = {} }
  local alike = { name = "not told apart from the finest", style = "points", colour = "black", x = {}, y = {},
    labels = {} }
  local series = {}
  for _, s in ipairs(result.settings) do
    local m = s.means and s.means[name]
    if m then
      local half = m.scatter * math.abs(m.mean)
      series[#series + 1] = { name = #series == 0 and "one standard deviation" or nil, colour = "sky",
        x = { s.seconds, s.seconds }, y = { m.mean - half, m.mean + half } }
      local to = m.apart and means or alike
      local i = #to.x + 1
      to.x[i], to.y[i], to.labels[i] = s.seconds, m.mean, m.apart and "" or words.label(result.inputs, s.values)
    end
  end
  if #means.x > 0 then series[#series + 1] = means end
  series[#series + 1] = alike
  job:plot({ title = "Mean and scatter against time, " .. name, x_label = "time of the steps, s", y_label = name,
    log_x = true, series = series, width = 1200, height = 760 }, "cost.png")
end

function plot.draw(result, job)
  local groups, numbers, least = group(result), {}, math.huge
  if #groups == 0 then
    local name = chaotic(result)
    if name then draw_means(result, job, name) end
    return
  end
  for _, input in ipairs(result.inputs) do numbers[#numbers + 1] = input.side and input end
  for _, s in ipairs(result.settings) do
    if s.error and not s.above and s.error > exact then least = math.min(least, s.error) end
  end
  local floor = least < math.huge and least / 10 or exact
  local function height(s) return 100 * (s.error > exact and s.error or floor) end
  local series, others, any_exact = {}, {}, false
  for number, g in ipairs(groups) do
    local line = { name = g.name ~= "" and g.name or numbers[1].name, x = {}, y = {}, labels = {} }
    local on_line = {}
    for i, s in ipairs(line_of(numbers, g.settings)) do
      line.x[i], line.y[i], line.labels[i] = s.seconds, height(s), label_of(numbers, s)
      on_line[s] = true
    end
    for _, s in ipairs(g.settings) do any_exact = any_exact or s.error <= exact end
    line.style, line.dashed = #line.x == 1 and "points" or "line and points", hides(line, series)
    series[#series + 1] = line
    local name = #others == 0 and "faint: other settings" or nil
    others[#others + 1] = others_of(g, name, number, on_line, numbers, height)
  end
  table.move(others, 1, #others, #series + 1, series)
  local front = { name = "Pareto front", style = "points", colour = "black", x = {}, y = {} }
  for i, s in ipairs(result.front) do front.x[i], front.y[i] = s.seconds, height(s) end
  series[#series + 1] = front
  job:plot({ title = "Error against time" .. (result.quantity and ", " .. result.quantity or ""),
    x_label = "time of the steps, s",
    y_label = any_exact and ("error, %% (exact: at %.1g)"):format(100 * floor) or "error, %",
    log_x = true, log_y = true, series = series, width = 1200, height = 760 }, "cost.png")
end

return plot
