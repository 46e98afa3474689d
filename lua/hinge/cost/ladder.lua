-- The settings of accuracy against time: their list, the finer side of each, and references that are finer than all.
local check = require "hinge.library.check"

local ladder = {}

-- Numbers whose finer side is known by their name. ratio: from one reference to the next; order: of the error, in
-- theory; work: how the time grows when the number is refined, for estimates until there are measurements.
local sides = {
  { "^dt$", finer = "smaller", ratio = 2, order = 2, work = 1,
    why = "Newmark's method and central differences, smooth motion" },
  { "^elements", finer = "larger", ratio = 2, order = 2, work = 1,
    why = "linear elements; asi-gauss is exact in elastic statics" },
  { "^steps$", finer = "larger", ratio = 2, order = 1, work = 1, why = "backward steps of load, where members yield" },
  { "tolerance$", finer = "smaller", ratio = 10, order = 1, work = 0.05, why = "what is left out of balance" },
}

-- Words, the finest first: the reference has the first one that is compared. For other words it has the default of the
-- script.
local words = {
  formulation = { "asi-gauss", "asi", "conventional" }, integrator = { "newmark", "explicit" },
  displacement = { "large", "small" },
  precision = { "double", "single" }, solver = { "direct", "cg" },
}

local function side_of(name, options)
  local finer = options.finer and options.finer[name]
  for _, side in ipairs(sides) do
    if name:find(side[1]) and (not finer or finer == side.finer) then return side end
  end
  return finer and { finer = finer, ratio = 2, work = 1 }
end

-- Values for a setting without a list: the script's own value first.
local function usual(name, value)
  local list = { value }
  if type(value) == "number" then
    local side = side_of(name, {})
    if not side or value <= 0 then return nil end
    for i = 1, 2 do
      local factor = side.ratio ^ i
      list[i + 1] = side.finer == "smaller" and value * factor
        or math.type(value) == "integer" and math.tointeger(value * factor) or value * factor
    end
    return list
  end
  for _, word in ipairs(words[name] or {}) do
    if word ~= value then list[#list + 1] = word end
  end
  return #list > 1 and list or nil
end

--- The names in the rules above, as they are written there: each has to be an option that there is.
function ladder.named()
  local names = {}
  for _, side in ipairs(sides) do names[#names + 1] = side[1] end
  for name in pairs(words) do names[#names + 1] = "^" .. name .. "$" end
  return names
end

--- The inputs of a scenario, sorted by name: { name =, values =, side = nil or { finer, ratio, order, work, why } }.
-- Parameters in `held` keep their values. options: accuracy, finer, orders (see hinge.cost).
function ladder.inputs(where, scenario, options, held)
  local lists, inputs = options.accuracy or scenario.accuracy, {}
  if next(lists) == nil then
    lists = {}
    for name, value in pairs(scenario.parameters) do lists[name] = usual(name, value) end
  end
  for name, values in pairs(lists) do
    if scenario.parameters[name] == nil then
      check.unknown(where .. ": accuracy", "parameter", name, check.keys(scenario.parameters))
    end
    if type(values) ~= "table" or #values == 0 then
      check.fail("%s: accuracy.%s is %s; must be a list of settings", where, name, check.show(values))
    end
    if held[name] == nil and #values > 1 then
      local side = type(values[1]) == "number" and side_of(name, options) or nil
      if side then
        local order = options.orders and options.orders[name]
        side = { finer = side.finer, ratio = side.ratio, order = order or side.order, work = side.work,
          why = not order and side.why or nil }
      end
      inputs[#inputs + 1] = { name = name, values = values, side = side }
    end
  end
  table.sort(inputs, function(a, b) return a.name < b.name end)
  return inputs
end

--- A value as text for tables and keys; "-" where there is none: see alike.lua.
function ladder.text(value)
  if value == nil then return "-" end
  return math.type(value) == "float" and ("%.6g"):format(value) or tostring(value)
end

function ladder.label(inputs, values)
  local parts = {}
  for _, input in ipairs(inputs) do
    local value = values[input.name]
    parts[#parts + 1] = value ~= nil and input.name .. " " .. ladder.text(value) or nil
  end
  return table.concat(parts, ", ")
end

--- How much finer a number is than another one of its input; above 1: it is finer.
function ladder.finer(input, value, than)
  return input.side.finer == "smaller" and than / value or value / than
end

--- A setting: these values of the inputs.
function ladder.setting(inputs, values)
  local weight = 1
  for _, input in ipairs(inputs) do
    if input.side then weight = weight * ladder.finer(input, values[input.name], input.values[1]) ^ input.side.work end
  end
  return { values = values, label = ladder.label(inputs, values), weight = weight }
end

--- All combinations, the cheapest first, by an estimate before any measurement.
function ladder.grid(inputs)
  local all = { {} }
  for _, input in ipairs(inputs) do
    local more = {}
    for _, values in ipairs(all) do
      for _, value in ipairs(input.values) do
        local copy = { [input.name] = value }
        for name, v in pairs(values) do copy[name] = v end
        more[#more + 1] = copy
      end
    end
    all = more
  end
  for i, values in ipairs(all) do
    all[i] = ladder.setting(inputs, values)
    all[i].place = i
  end
  table.sort(all, function(a, b) return a.weight < b.weight or a.weight == b.weight and a.place < b.place end)
  return all
end

--- The finest value of a input among settings; of words the first that is known as finest, else its default.
function ladder.finest(input, settings)
  local there, best = {}, nil
  for _, s in ipairs(settings) do
    local value = s.values[input.name]
    there[value] = true
    if input.side and (best == nil or ladder.finer(input, value, best) > 1) then best = value end
  end
  if best ~= nil then return best end
  for _, word in ipairs(words[input.name] or {}) do
    if there[word] then return word end
  end
  return input.values[1]
end

--- Whether a setting is finer than another one in no number.
function ladder.no_finer(inputs, setting, than)
  for _, input in ipairs(inputs) do
    if input.side and ladder.finer(input, setting.values[input.name], than.values[input.name]) > 1 + 1e-9 then
      return false
    end
  end
  return true
end

--- A setting `level` steps of refinement finer than all of these.
function ladder.reference(inputs, settings, level)
  local values = {}
  for _, input in ipairs(inputs) do
    local value = ladder.finest(input, settings)
    if input.side then
      local factor = input.side.ratio ^ level
      if input.side.finer == "smaller" then value = value / factor
      else value = math.type(value) == "integer" and math.tointeger(value * factor) or value * factor end
    end
    values[input.name] = value
  end
  return ladder.setting(inputs, values)
end

return ladder
