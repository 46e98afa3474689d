-- One run of a scenario as a measurement: its answers (numbers and histories), its time and its memory.
local core = require "hinge.core"
local jobs = require "hinge.program.job"
local compare = require "hinge.cost.compare"

local measure = {}
local deepest = 6 -- tables within tables of what a script returns
local late = "hinge.cost: the time that was given is over"

local function is_curve(value)
  for _, v in ipairs(value) do
    if type(v) ~= "number" then return false end
  end
  return #value > 1
end

-- The numbers of what a script returned, by name: "uz", "damage.columns.broken". A list of
-- numbers is a history over its index.
local function flatten(answers, value, name, depth)
  if type(value) == "number" then
    answers[name] = value
  elseif type(value) == "table" and depth < deepest then
    if is_curve(value) then
      answers[name] = { x = {}, y = table.move(value, 1, #value, 1, {}) }
      for i = 1, #value do answers[name].x[i] = i end
      return
    end
    for key, v in pairs(value) do
      flatten(answers, v, (name == "" and "" or name .. ".") .. tostring(key), depth + 1)
    end
  end
end

-- The records of probes, by their names. If a name is used more than once, by probes or results, the others are "uz#2"
-- and so on.
local function add_histories(answers, histories)
  for _, h in ipairs(histories) do
    local name, n = h.name, 1
    while answers[name] do
      n = n + 1
      name = ("%s#%d"):format(h.name, n)
    end
    answers[name] = { x = h.x, y = h.y }
  end
end

-- The results of a finished run. The run is then freed, so that its memory does not count for the next run.
local function harvest(result, histories, facts, run)
  result.seconds = result.seconds + run.wall_seconds
  for _, stage in ipairs(run.stages) do result.stages[stage.name] = (result.stages[stage.name] or 0) + stage.seconds end
  result.energy_error = compare.larger(result.energy_error, math.abs(run.energy_error))
  for _, probe in ipairs(run.probes) do
    histories[#histories + 1] = { name = probe.name, x = probe.time, y = probe.value }
  end
  for _, law in ipairs(core.optional_laws(run)) do result.laws[law] = true end
  for _, effect in ipairs(run.effects) do
    result.effects[effect.name] = result.effects[effect.name] or effect.active or nil
  end
  result.hashes[#result.hashes + 1] = run.hash
  for _, warning in ipairs(run.warnings) do result.warnings[#result.warnings + 1] = warning end
  if run.kind == "dynamic" and run.planned_steps > (result.longest and result.longest.steps or 0) then
    result.longest = { steps = run.planned_steps, time = run.time }
  end
  result.runs[#result.runs + 1] = { kind = run.kind, ended = run.kind == "dynamic" and run.time or run.factor,
    dt = facts.dt, steps = run.index, elements = facts.elements, members = facts.members, broken = facts.broken,
    groups = facts.groups }
  result.strain_limits = result.strain_limits or facts.strain_limits
end

-- The runs of a script that it never asked for their verdict fail all of it, if they failed; so does the last one, and
-- one that goes on from a run that did.
local function judge(result, facts, reason, is_last)
  if facts.verdict == "failed" and (is_last or not facts.asked) then result.failed = reason end
end

--- Calls f, which runs a scenario or a script, with what core.change_runs takes in `changes`, or without the effect or
-- the law of sections `without`. Returns { answers = { name = number or { x =, y = } }, seconds = in the steps of all
-- its runs, without what other programs took of the processor, outside = of the rest, stages = { name = seconds },
-- memory = bytes, energy_error = the largest of its runs' (run.energy_error), effects = { name = true } in a step, laws
-- = { name = true } of sections that can be left out, hashes = of the states at the end, warnings = { text, ... } of
-- all its runs, longest = { steps =, time = } of the dynamic run with the most steps, runs = { { kind =, ended = time
-- or load factor, dt =, steps =, elements =, members =, broken = numbers of members, groups = { number = group } }, ...
-- }, strain_limits = true if fracture has limits of strain, failed = why it has no answer }; nil when `deadline` (of
-- core.clock, or a function that is asked in each step and returns true when it is over) came first.
function measure.watch(f, deadline, without, changes)
  local result = { answers = {}, seconds = 0, stages = {}, energy_error = 0, effects = {}, laws = {}, hashes = {},
    warnings = {}, runs = {}, strain_limits = false }
  local runs, histories, expired = {}, {}, false
  collectgarbage()
  collectgarbage()
  local held = core.forget_peak()
  core.on_run(function(run)
    for i = #runs, 1, -1 do
      local facts = core.facts(runs[i])
      if facts.verdict ~= "running" then
        harvest(result, histories, facts, runs[i])
        judge(result, facts, runs[i].reason, false)
        table.remove(runs, i)
      end
    end
    runs[#runs + 1] = run
    if not deadline then return end
    run:on_step(function()
      if type(deadline) == "function" and not deadline() or type(deadline) == "number" and core.clock() < deadline then
        return
      end
      expired = true
      error(late)
    end)
  end)
  core.leave_out(without)
  core.change_runs(changes)
  local start, used = core.clock(), os.clock()
  local ok, returned = pcall(f)
  local all = core.clock() - start
  used = os.clock() - used
  core.on_run(nil)
  core.leave_out(nil)
  core.change_runs(nil)
  if expired then return nil end
  if not ok then
    if core.error_kind(returned) == "interrupted" or type(returned) ~= "string" or returned == "not enough memory" then
      error(returned, 0)
    end
    result.failed = returned
    return result
  end
  result.memory = held and math.max(0, core.peak() - held)
  for i, run in ipairs(runs) do
    local facts = core.facts(run)
    harvest(result, histories, facts, run)
    judge(result, facts, run.reason, i == #runs)
  end
  if result.seconds == 0 then result.seconds = all end -- a scenario without a run, or without a step
  -- Other programs took the processor meanwhile, or the scenario waited, which it does outside the steps.
  if result.seconds > all / 2 then result.seconds = result.seconds * math.min(1, used / all) end
  result.outside = all - result.seconds
  flatten(result.answers, returned, "", 0)
  add_histories(result.answers, histories)
  return result
end

--- Runs the scenario and writes nothing: see measure.watch. Each call makes its own models.
function measure.once(scenario, parameters, case, deadline, without, changes)
  local say, quiet = print, jobs.quiet(case)
  local before = jobs.use(quiet)
  print = function() end
  local results = table.pack(pcall(measure.watch, function() return scenario.run(parameters, quiet) end, deadline,
    without, changes))
  print = say
  jobs.use(before)
  if not results[1] then error(results[2], 0) end
  return results[2]
end

-- A small relative change of all numbers, up and down alternately, shows whether an answer is chaotic.
local function changed(value, by)
  if math.type(value) == "float" and value ~= 0 then return value * (1 + by) end
  if type(value) ~= "table" then return value end
  local copy = {}
  for key, v in pairs(value) do copy[key] = changed(v, by) end
  return copy
end

--- The parameters of these names, every number that is not whole changed by a part of itself.
function measure.perturbed(parameters, names, part, variation)
  local copy = {}
  for i, name in ipairs(names) do
    copy[name] = changed(parameters[name], part * ((i + variation) % 2 == 0 and 1 or -1) * (1 + variation) / 2)
  end
  return copy
end

return measure
