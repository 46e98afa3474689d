-- One scene of tests/hard/within.lua: asked with several accuracies, and compared with a reference that is four times
-- finer in everything than the finest setting that was chosen.
local accuracy = require "hinge.accuracy"
local Runs = require "hinge.accuracy.runs"
local statistics = require "hinge.accuracy.statistics"
local support = require "support"
local measured = {}

local finer = 4        -- the reference, in time steps and elements
local least_runs = 3   -- of a reference whose answers are chaotic
local for_asking = 0.5 -- part of the scene's time
local rounding = 1e-12

-- What a run took and answered, with factors on the script's own steps and elements. nil where the time of the
-- processor is over.
local function run_once(runs, factors, vary, until_then)
  local record = runs:measure({}, factors, vary, function() return os.clock() > until_then end)
  return record.failed ~= Runs.late and record or nil
end

-- Factors `times` finer than the finest of several settings.
local function factors_of(all, times)
  local f = { dt = math.huge, elements = 0 }
  for _, told in ipairs(all) do
    f.dt = support.smallest_of(f.dt, (told.values.dt or 1) / times)
    f.elements = support.largest_of(f.elements, (told.values.elements or 1) * times)
    if told.setting:find "^explicit" then f.integrator = "explicit" end
  end
  return f
end

-- The reference of the settings that have been told, { runs = { record, ... }, half = record or nil }: as many runs
-- with changed physical numbers as the largest family that was told. nil and why where there is none.
local function reference_of(runs, all, deadline)
  local own = 0
  for _, told in ipairs(all) do own = support.largest_of(own, told.own) end
  if finer ^ 2 * own > deadline - os.clock() then return nil, "too slow" end
  local first = run_once(runs, factors_of(all, finer), 0, deadline)
  if not first then return nil, "too slow" end
  if first.failed then return nil, first.failed end
  local reference = { runs = { first } }
  local half = run_once(runs, factors_of(all, finer / 2), 0, deadline)
  if half and not half.failed then reference.half = half end
  local most = 0
  for _, told in ipairs(all) do
    for _, a in ipairs(told.answers) do if a.chaotic then most = support.largest_of(most, a.runs or 0) end end
  end
  for vary = 1, most - 1 do
    local record = run_once(runs, factors_of(all, finer), vary, deadline)
    if not record then break end
    if not record.failed then reference.runs[#reference.runs + 1] = record end
  end
  return reference
end

local function values_of(records, name)
  local values = {}
  for i, record in ipairs(records) do values[i] = record.answers[name] end
  return values
end

-- The difference as a part of b, or of `least` where b is smaller.
local function part(a, b, least)
  if math.abs(a - b) == 0 then return 0 end
  local size = math.abs(b) > rounding and math.abs(b) or math.abs(a)
  size = support.largest_of(size, least)
  return size > rounding and math.abs(a - b) / size or 0
end

-- What the reference says of an answer: { name, value, estimated, reference, distance = its true error as a part,
-- open = part by which the reference itself changed with its last refinement, chaotic }; of means also alone = whether
-- the reference is in the 95 % band, holds = they differ by no more than their scatter explains (Welch's test), told =
-- they differ by no more than the estimated error and the band of the reference's mean }.
local function judged(a, reference, least)
  local row = { name = a.name, chaotic = a.chaotic, estimated = a.error, value = a.mean or a.value }
  if not row.value or not reference then return row end
  if a.chaotic and a.runs then
    local mean, deviation, runs = statistics.mean(values_of(reference.runs, a.name))
    if not mean or runs < least_runs then return row end
    row.reference, row.distance = mean, part(a.mean, mean, least)
    row.alone = math.abs(a.mean - mean) <= a.band
    row.holds = not statistics.apart({ mean = a.mean, deviation = a.scatter, runs = a.runs },
      { mean = mean, deviation = deviation, runs = runs })
    row.told = math.abs(a.mean - mean) <= a.error * support.largest_of(math.abs(a.mean), least)
      + statistics.band(deviation, runs)
  else
    local value = reference.runs[1].answers[a.name]
    if value ~= value or not value then return row end
    row.reference, row.distance = value, part(row.value, value, least)
    local half = reference.half and reference.half.answers[a.name]
    row.open = half and part(half, value, least) or nil
  end
  return row
end

-- Elements that make another problem are named in the notes.
local function is_named(told)
  for _, note in ipairs(told.notes) do
    if note:find "with the length of the" then return true end
  end
  return false
end

--- Asks for each accuracy, the largest first, and finds the reference. o: folder, asked = { parts }, most = s of the
-- processor. Returns rows { seed, class, asked, status ("told", "not told"), why, reached, estimated, setting, own,
-- asking, runs, reference (s), named, answers = see judged }.
function measured.scene(scene, o)
  local began, told_all, rows = os.clock(), {}, {}
  for i, asked in ipairs(o.asked) do
    local row = { seed = scene.seed, class = scene.class, asked = asked, answers = {} }
    rows[i] = row
    if os.clock() - began > for_asking * o.most then row.status, row.why = "not told", "the scene's time is over"
    else
      local ok, told, why = pcall(accuracy.run, { script = o.script, scenario = scene.scenario, overrides = {},
        parameters = {}, out = o.folder, out_given = true, within = asked, measured_only = true, longest = o.most / 6 })
      row.status = ok and told and "told" or "not told"
      if ok and told then
        row.told, told_all[#told_all + 1] = told, told
        row.reached, row.estimated, row.setting = told.reached, told.estimated, told.setting
        row.own, row.asking, row.runs, row.named = told.own, told.seconds, told.runs, is_named(told)
        row.why = not told.reached and told.why or nil
      else row.why = tostring(told or why) end
    end
  end
  local reference, why
  local runs = Runs.open { script = o.script, scenario = scene.scenario, overrides = {}, out = o.folder }
  while #told_all > 0 do -- without the most accurate setting, where the time does not suffice for its reference
    reference, why = reference_of(runs, told_all, began + o.most)
    if reference or why ~= "too slow" or os.clock() - began > o.most then break end
    table.remove(told_all)
  end
  for _, row in ipairs(rows) do
    local counts = false
    for _, told in ipairs(told_all) do counts = counts or told == row.told end
    row.reference = counts and reference and reference.runs[1].seconds or nil
    if row.told and not row.reference then
      row.why = ("%sreference: %s"):format(row.why and row.why .. "; " or "", why or "?")
    end
    for k, a in ipairs(row.told and row.told.answers or {}) do
      row.answers[k] = judged(a, row.reference and reference, (scene.least[a.name] or 0) / row.asked)
    end
  end
  return rows
end

return measured
