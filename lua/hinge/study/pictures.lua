-- Pictures of a study: each quantity against one or two parameters, fragility curves of truths against parameters that
-- were drawn, and the rank correlation of each quantity with each parameter.
local core = require "hinge.core"
local case = require "hinge.study.case"
local check = require "hinge.library.check"
local draw_plot = require "hinge.plot.draw"
local fit = require "hinge.study.fit"
local tables = require "hinge.study.table"

local pictures = {}
local most = 24 -- pictures of one study
local least_values, least_cases = 3, 8 -- that a fragility curve takes

-- Parameters that are numbers and take more than one value: { name =, values = sorted }.
local function numeric(of)
  local list = {}
  for _, name in ipairs(of.varied) do
    local seen, sorted, good = {}, {}, true
    for _, c in ipairs(of.cases) do
      local value = c.parameters[name]
      good = good and type(value) == "number"
      if good and not seen[value] then seen[value], sorted[#sorted + 1] = true, value end
    end
    if good and #sorted > 1 then
      table.sort(sorted)
      list[#list + 1] = { name = name, values = sorted }
    end
  end
  return list
end

local function number_of(value)
  if type(value) == "boolean" then return value and 1 or 0 end
  return type(value) == "number" and value or nil
end

-- What distinguishes cases beside the parameter on the axis: "II, mass 12000".
local function label(of, c, without)
  local parts = {}
  if of.has_cases then parts[1] = c.case end
  for _, name in ipairs(of.varied) do
    if name ~= without then
      local value = c.parameters[name]
      parts[#parts + 1] = ("%s %s"):format(name, type(value) == "number" and ("%.5g"):format(value) or tostring(value))
    end
  end
  return table.concat(parts, ", ")
end

-- A line for each combination of the other parameters, in the order of the cases; points alone where there are more
-- than eight.
local function against(of, quantity, axis)
  local groups, order = {}, {}
  for _, c in ipairs(of.cases) do
    local y = number_of(c.results[quantity])
    if y then
      local name = label(of, c, axis.name)
      if not groups[name] then groups[name], order[#order + 1] = {}, name end
      table.insert(groups[name], { c.parameters[axis.name], y })
    end
  end
  if #order == 0 then return nil end
  local series = {}
  if #order > 8 then
    local x, y = {}, {}
    for _, name in ipairs(order) do
      for _, point in ipairs(groups[name]) do x[#x + 1], y[#y + 1] = point[1], point[2] end
    end
    series[1] = { x = x, y = y, style = "points" }
  else
    for _, name in ipairs(order) do
      table.sort(groups[name], function(a, b) return a[1] < b[1] end)
      local x, y = {}, {}
      for i, point in ipairs(groups[name]) do x[i], y[i] = point[1], point[2] end
      series[#series + 1] = { name = #order > 1 and name or nil, x = x, y = y,
        style = #x <= 40 and "line and points" or "line" }
    end
  end
  return { x_label = axis.name, y_label = quantity, series = series }
end

-- A fragility curve with its band and the cases as points; nil and why not.
local function fragility(of, quantity, axis)
  local x, y, positive = {}, {}, true
  for _, c in ipairs(of.cases) do
    local value = number_of(c.results[quantity])
    if value then
      x[#x + 1], y[#y + 1] = c.parameters[axis.name], value
      positive = positive and x[#x] > 0
    end
  end
  if #axis.values < least_values then
    return nil, ("a curve takes %d values, and there are %d"):format(least_values, #axis.values)
  end
  local curve, why = fit.fragility(x, y, positive)
  if curve and #x < least_cases then
    curve, why = nil, ("a curve takes %d cases, and there are %d; list more values, or draw what is uncertain")
      :format(least_cases, #x)
  end
  if not curve then return nil, why end
  local line, band = { x = {}, y = {} }, { name = "95 % band", x = {}, low = {}, high = {}, colour = "blue" }
  local first, last = axis.values[1], axis.values[#axis.values]
  for i = 0, 200 do
    local at = first + (last - first) * i / 200
    line.x[i + 1], band.x[i + 1] = at, at
    line.y[i + 1], band.low[i + 1], band.high[i + 1] = curve.at(at)
  end
  line.name = ("median %.4g, dispersion %.3g"):format(curve.median, curve.dispersion)
  local inside = curve.median >= first and curve.median <= last -- what no case is near to is no answer
  local median = inside and { quantity = quantity, parameter = axis.name, median = curve.median,
    dispersion = curve.dispersion, of_logarithm = curve.log }
  return { title = ("chance of %s"):format(quantity), x_label = axis.name, y_label = "chance",
    series = { line, band, { name = "cases", x = x, y = y, style = "points", colour = "black" } } }, nil, median
end

-- The study with those cases alone that have an answer, and how many have none.
local function answered(of)
  local good = {}
  for _, c in ipairs(of.cases) do
    if case.finished(c.verdict) then good[#good + 1] = c end
  end
  return setmetatable({ cases = good }, { __index = of }), #of.cases - #good
end

--- Rank correlations: { { quantity =, parameter =, correlation = }, ... } of all numbers with all numeric parameters.
function pictures.correlations(of)
  local list = {}
  for _, quantity in ipairs(tables.columns_of(of)) do
    for _, axis in ipairs(numeric(of)) do
      local x, y = {}, {}
      for _, c in ipairs(of.cases) do
        local value = number_of(c.results[quantity])
        if value then x[#x + 1], y[#y + 1] = c.parameters[axis.name], value end
      end
      local r = #x > 2 and fit.rank_correlation(x, y)
      if r then list[#list + 1] = { quantity = quantity, parameter = axis.name, correlation = r, cases = #x } end
    end
  end
  return list
end

-- Bars from zero, one a parameter, of the correlations of one quantity, the strongest on top.
local function sensitivity(quantity, list)
  table.sort(list, function(a, b)
    local p, q = math.abs(a.correlation), math.abs(b.correlation)
    return p > q or p == q and a.parameter < b.parameter
  end)
  local bars = { style = "bars", x = {}, y = {}, labels = {} }
  for i, one in ipairs(list) do
    bars.x[i], bars.y[i], bars.labels[i] = one.correlation, one.parameter, ("%+.2f"):format(one.correlation)
  end
  return { title = "what " .. quantity .. " depends on", x_label = "rank correlation", series = { bars } }
end

-- A bar for each case of a study that varies no number; nil where they are too many to be told apart.
local function by_name(of, quantity)
  local bars = { style = "bars", x = {}, y = {}, labels = {} }
  for _, c in ipairs(of.cases) do
    local value = number_of(c.results[quantity])
    if value then
      local i = #bars.x + 1
      bars.x[i], bars.y[i], bars.labels[i] = label(of, c), value, ("%.4g"):format(value)
    end
  end
  if #bars.x < 2 or #bars.x > most then return nil end
  return { y_label = quantity, series = { bars } }
end

local function file_name(text) return (text:gsub("[^%w_.-]", "_")) end

--- Draws the pictures into the study's folder and returns their names; what cannot be drawn is said in of.notes.
function pictures.draw(of)
  local known, left_out = answered(of)
  local axes, names = numeric(known), {}
  of.notes, of.fragility = of.notes or {}, {}
  if left_out > 0 then
    of.notes[#of.notes + 1] = check.count(left_out, "case")
      .. " without an answer left out of pictures, fragility curves and correlations"
  end
  local not_drawn = 0
  local function draw(plot, name)
    if not plot then return end
    if #names >= most then
      not_drawn = not_drawn + 1
      return
    end
    local good, problem = pcall(draw_plot, plot, of.folder .. "/" .. name, "study")
    if good then names[#names + 1] = name
    else
      of.notes[#of.notes + 1] = ("%s not drawn: %s"):format(name, tostring(problem))
      if core.unwritten(problem) then of.lost = of.lost or of.notes[#of.notes] end
    end
  end
  for _, quantity in ipairs(tables.columns_of(known)) do
    if #axes == 0 then draw(by_name(known, quantity), file_name(quantity .. ".png")) end
    local truth = false
    for _, c in ipairs(known.cases) do truth = truth or type(c.results[quantity]) == "boolean" end
    local reasons = {}
    for _, axis in ipairs(axes) do
      local plot, why, curve
      if truth and not of.proposed then plot, why, curve = fragility(known, quantity, axis) end
      if curve then of.fragility[#of.fragility + 1] = curve end
      if why and not reasons[why] then reasons[why], reasons[#reasons + 1] = {}, why end
      if why then table.insert(reasons[why], axis.name) end
      if plot then draw(plot, file_name(("chance_of_%s-%s.png"):format(quantity, axis.name)))
      else draw(against(known, quantity, axis), file_name(("%s-%s.png"):format(quantity, axis.name))) end
    end
    for _, why in ipairs(reasons) do
      of.notes[#of.notes + 1] = ("no fragility curve of %s against %s: %s"):format(quantity,
        table.concat(reasons[why], ", "), why)
    end
  end
  if #axes > 1 and #known.cases >= 8 then
    local by = {}
    of.correlations = pictures.correlations(known)
    for _, one in ipairs(of.correlations) do
      by[one.quantity] = by[one.quantity] or {}
      table.insert(by[one.quantity], one)
    end
    for _, quantity in ipairs(tables.columns_of(known)) do
      if by[quantity] then
        draw(sensitivity(quantity, by[quantity]), file_name("sensitivity-" .. quantity .. ".png"))
      end
    end
  end
  if not_drawn > 0 then
    of.notes[#of.notes + 1] = ("%s more not drawn; a study draws %d"):format(check.count(not_drawn, "picture"), most)
  end
  return names
end

return pictures
