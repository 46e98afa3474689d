-- The numbers that hinge varies to reach an accuracy (knobs): those that the scenario lists under `accuracy`, and by
-- itself the time step (in statics the load steps) and the elements a member. A list with one value holds its number.
local costs = require "hinge.cost.ladder"

local knobs = {}
local finer_than_own = 4     -- refinements beyond the script's own value or list
local finer_elements = 5
local coarser_steps = 6      -- levels of dt below the script's own that may be tried
local first_step = -2        -- the search begins with steps that are four times as long
local least_elements = 2     -- a member: with fewer, pairs of asi-gauss cannot be

-- The knob of a list of numbers: its level 0 is the coarsest of them.
local function of_list(input)
  local values, side = {}, input.side
  for i, value in ipairs(input.values) do values[i] = value end
  table.sort(values, function(a, b) return costs.finer(input, b, a) > 1 end)
  local n = #values
  local function value(level)
    if level < n then return values[level + 1] end
    local factor = side.ratio ^ (level - n + 1)
    if side.finer == "smaller" then return values[n] / factor end
    local more = values[n] * factor
    return math.type(values[n]) == "integer" and math.tointeger(more) or more
  end
  return { name = input.name, parameter = true, theory = side.order or 1, ratio = side.ratio, least = 0,
    most = n - 1 + finer_than_own, start = 0, value = value,
    h = function(level) return 1 / costs.finer(input, value(level), values[1]) end }
end

local function of_factor(name, o)
  return { name = name, theory = o.theory, ratio = 2, least = o.least, most = o.most, start = o.start,
    value = function(level) return 2.0 ^ (o.finer == "smaller" and -level or level) end }
end

-- What the runs of a script are, as a first run shows: { dynamic =, explicit =, elements a member = }.
local function kinds_of(record, asked)
  local elements, members, dynamic = 0, 0, false
  for _, run in ipairs(record.runs) do
    dynamic = dynamic or run.kind == "dynamic"
    elements, members = elements + run.elements, members + run.members
  end
  return dynamic, asked.explicit, members > 0 and elements / members or 0
end

-- Whether a knob of the list does what one of these would.
local function listed(inputs, scenario, pattern)
  for _, input in ipairs(inputs) do
    if input.name:find(pattern) then return true end
  end
  for name in pairs(scenario and scenario.accuracy or {}) do
    if name:find(pattern) then return true end
  end
  return false
end

--- The knobs of a script, that of the steps first. scenario: nil for plain statements. held: parameters that the user
-- has given. record: a run of it with the steps of `first_step`; asked: what its runs asked for (see changes.of).
function knobs.of(scenario, held, record, asked)
  local inputs = scenario and costs.inputs("--within", scenario, { accuracy = scenario.accuracy }, held) or {}
  local dynamic, explicit, elements = kinds_of(record, asked)
  local all = {}
  for _, input in ipairs(inputs) do
    if input.side then all[#all + 1] = of_list(input) end
  end
  if dynamic and not listed(inputs, scenario, "^dt$") then
    all[#all + 1] = of_factor("dt", { finer = "smaller", theory = 2, least = explicit and 0 or -coarser_steps,
      most = finer_than_own, start = explicit and 0 or first_step })
  elseif not dynamic and #record.runs > 0 and not listed(inputs, scenario, "^steps$") then
    all[#all + 1] = of_factor("steps", { finer = "larger", theory = 1, least = 0, most = finer_than_own, start = 0 })
  end
  if elements > 0 and not listed(inputs, scenario, "^elements") then
    local coarser = math.max(0, math.floor(math.log(elements / least_elements, 2) + 1e-9))
    all[#all + 1] = of_factor("elements", { finer = "larger", theory = 2, least = -coarser, most = finer_elements,
      start = -coarser })
  end
  table.sort(all, function(a, b)
    local function rank(k) return (k.name == "dt" or k.name == "steps") and 0 or 1 end
    if rank(a) ~= rank(b) then return rank(a) < rank(b) end
    return a.name < b.name
  end)
  local corner = {}
  for _, knob in ipairs(all) do corner[knob.name] = knob.start end
  return all, corner
end

knobs.first_step = first_step

--- Levels of the run that tells what there is to vary: the corner's, with the script's own elements.
function knobs.of_first(all, corner)
  local levels = {}
  for _, knob in ipairs(all) do
    levels[knob.name] = knob.name == "elements" and not knob.parameter and 0 or corner[knob.name]
  end
  return levels
end

--- The parameters of a setting, and its factors for changes.of.
function knobs.apply(all, levels)
  local parameters, factors = {}, {}
  for _, knob in ipairs(all) do
    (knob.parameter and parameters or factors)[knob.name] = knob.value(levels[knob.name])
  end
  return parameters, factors
end

--- A setting in words, with what a run of it had: "dt 0.5 ms, 4 elements a member".
function knobs.words(all, levels, record)
  local parts, longest = {}, nil
  for _, run in ipairs(record and record.runs or {}) do
    if run.dt and run.steps > (longest and longest.steps or 0) then longest = run end
  end
  local seconds = require "hinge.cost.words".seconds
  for _, knob in ipairs(all) do
    local value = knob.value(levels[knob.name])
    if knob.parameter then
      parts[#parts + 1] = knob.name == "dt" and "dt " .. seconds(value) or knob.name .. " " .. costs.text(value)
    elseif knob.name == "dt" then parts[#parts + 1] = longest and "dt " .. seconds(longest.dt) or "dt times " .. value
    elseif knob.name == "elements" then
      local elements, members = 0, 0
      for _, run in ipairs(record and record.runs or {}) do
        elements, members = elements + run.elements, members + run.members
      end
      parts[#parts + 1] = members > 0 and ("%.3g elements a member"):format(elements / members)
        or ("elements times %g"):format(value)
    elseif record and knob.name == "steps" then
      local steps = 0
      for _, run in ipairs(record.runs) do steps = steps + run.steps end
      parts[#parts + 1] = steps .. " load steps"
    else parts[#parts + 1] = ("%s times %g"):format(knob.name, value) end
  end
  return table.concat(parts, ", ")
end

return knobs
