-- accuracy.png of hinge run --within: error against time of all settings that were run, drawn like cost.png; chaotic
-- answers with mean and scatter.
local compare = require "hinge.cost.compare"
local jobs = require "hinge.program.job"
local plot = require "hinge.cost.plot"
local statistics = require "hinge.accuracy.statistics"

local picture = {}

-- The value of a knob as an engineer names it: the step, the elements a member, else its parameter or factor.
local function value_of(knob, level, record)
  local longest, elements, members = nil, 0, 0
  for _, run in ipairs(record.runs or {}) do
    if run.dt and run.steps > (longest and longest.steps or 0) then longest = run end
    elements, members = elements + run.elements, members + run.members
  end
  if not knob.parameter and knob.name == "dt" and longest then return longest.dt end
  if not knob.parameter and knob.name == "elements" and members > 0 then
    local mean = elements / members
    return math.tointeger(mean) or tonumber(("%.3g"):format(mean))
  end
  return knob.value(level)
end

-- Mean and scatter of the chaotic answers at a setting that was run several times.
local function means_of(told, levels)
  local means, ladders = {}, told.search.ladders
  for _, answer in ipairs(told.answers) do
    local mean, deviation, runs = nil, nil, nil
    if answer.chaotic then mean, deviation, runs = statistics.mean(ladders:values(levels, answer.name)) end
    if type(mean) == "number" then
      local scatter = mean ~= 0 and deviation / math.abs(mean) or 0
      means[answer.name] = { mean = mean, scatter = scatter, runs = runs, apart = levels ~= told.levels }
    end
  end
  return next(means) and means or nil
end

-- The settings that have an answer, the fastest first.
local function settings_of(told)
  local settings, search = {}, told.search
  for key, runs in pairs(search.ladders.records) do
    local record = runs[0]
    if record and not record.failed then
      local chosen = key == search.ladders:key(told.levels)
      local levels = chosen and told.levels or record.levels
      local _, most = search.ladders.worst(search.ladders:errors(levels, search.names))
      if chosen then most = told.estimated end
      local s = { values = {}, seconds = record.seconds, label = key, chosen = chosen or nil,
        means = means_of(told, levels) }
      for _, knob in ipairs(told.knobs) do s.values[knob.name] = value_of(knob, levels[knob.name], record) end
      s.error = most < math.huge and most or nil
      settings[#settings + 1] = s
    end
  end
  table.sort(settings, function(a, b)
    if a.seconds ~= b.seconds then return a.seconds < b.seconds end
    return a.label < b.label
  end)
  local items = {}
  for i, s in ipairs(settings) do items[i] = { time = s.seconds, error = s.error, setting = s } end
  for _, item in ipairs(compare.front(items)) do item.setting.front = true end
  return settings
end

--- What hinge.cost.plot draws of a result of accuracy.run.
function picture.of(told)
  local result = { within = told.asked, settings = settings_of(told), inputs = {}, quantities = {} }
  for i, knob in ipairs(told.knobs) do
    local seen, values = {}, {}
    for _, s in ipairs(result.settings) do
      local value = s.values[knob.name]
      if not seen[value] then seen[value], values[#values + 1] = true, value end
    end
    table.sort(values)
    result.inputs[i] = { name = knob.name, side = knob, values = values }
  end
  for _, answer in ipairs(told.answers) do
    result.quantities[answer.name] = { kind = answer.value and "number" or "history", alike = answer.chaotic or nil,
      standard = told.search.ladders:key(told.levels) }
  end
  return result
end

--- Writes accuracy.png into the folder of the chosen run.
function picture.write(told)
  local out = jobs.new(told.folder)
  plot.draw(picture.of(told), { plot = function(_, what) out:plot(what, "accuracy.png") end })
end

return picture
