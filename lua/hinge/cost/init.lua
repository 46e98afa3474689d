-- What accuracy costs in time: a scenario with each of its accuracy settings. Each is compared with a reference, which
-- is tested itself.
--
-- Every setting runs in this process, with its own models, since a scenario is a function of this Lua state. So
-- start-up is not in the times, and runs of different settings can alternate. The most memory is measured anew for each
-- (/proc/self/clear_refs).
local core = require "hinge.core"
local check = require "hinge.library.check"
local alike = require "hinge.cost.alike"
local scenarios = require "hinge.program.scenario"
local benches = require "hinge.cost.bench"
local effects = require "hinge.cost.effects"
local ladder = require "hinge.cost.ladder"
local methods = require "hinge.cost.methods"
local scatter = require "hinge.cost.scatter"
local verdict = require "hinge.cost.verdict"

local cost = {}
local notes_of_elements = "fracture has limits of curvature or strain, which go with the length of the elements: more "
  .. "elements are another problem, not a finer one; hinge_rotation_x, hinge_rotation_y and elongation do not"
local where = "hinge.cost"

local rules = {
  within = { "number", above = 0, default = 0.01 }, quantity = { "string", optional = true },
  case = { "string", optional = true },
  parameters = { "table", default = {} }, budget = { "number", unit = "s", above = 0, optional = true },
  repeats = { "number", whole = true, at_least = 1, default = 3 }, out = { "string", optional = true },
  accuracy = { "table", optional = true }, finer = { "table", default = {} }, orders = { "table", default = {} },
  perturbation = { "number", above = 0, below = 1e-3, default = 1e-9 }, progress = { "boolean", default = false },
  effects = { "boolean", default = false },
}

local function references(inputs, compared)
  return { ladder.reference(inputs, compared, 1), ladder.reference(inputs, compared, 2) }
end

-- The setting whose numbers are changed slightly: the scenario's default, or the slowest one if the default was not
-- run.
local function default_of(inputs, compared)
  for _, s in ipairs(compared) do
    local all = true
    for _, input in ipairs(inputs) do all = all and s.values[input.name] == input.values[1] end
    if all then return s end
  end
  return compared[#compared]
end

-- Seconds that the references of these settings and the changed runs would take.
local function still_to_come(bench, inputs, compared)
  local seconds = 0
  for _, r in ipairs(references(inputs, compared)) do seconds = seconds + bench:estimate(r) end
  return seconds + bench:changed_runs(default_of(inputs, compared), compared[#compared])
end

-- Runs settings, the cheap ones first, as long as they and their references fit into the budget. If the references do
-- not fit at all, it runs settings as long as these fit. Returns those that have an answer and whose references fit,
-- those that failed, those left out, and those that have an answer although references for them do not fit.
local function run_settings(bench, inputs, settings)
  local compared, failed, left_out = {}, {}, {}
  local function leave_out(s, own, rest)
    left_out[#left_out + 1] = { label = s.label, values = s.values, estimate = own, rest = rest }
  end
  for i, s in ipairs(settings) do
    local with = table.move(compared, 1, #compared, 1, {})
    with[#with + 1] = s
    local own = bench:estimate(s)
    local rest = #compared > 0 and still_to_come(bench, inputs, with) or 0
    local comparable = #compared > 0 and bench:fits(still_to_come(bench, inputs, compared))
    bench:progress(s.label, i - 1, #settings, own + rest)
    local fits = #compared == 0 or bench:fits(own + (comparable and rest or 0))
    local record = (bench:record(s) or fits and bench:fits(0)) and bench:run(s)
    if not record then
      leave_out(s, own, rest)
    elseif record.failed then
      s.failed = record.failed
      failed[#failed + 1] = s
    else
      s.record = record
      compared[#compared + 1] = s
    end
  end
  local fewer = #compared -- the most settings whose references fit
  while fewer > 0 and not bench:fits(still_to_come(bench, inputs, table.move(compared, 1, fewer, 1, {}))) do
    fewer = fewer - 1
  end
  local beside = {}
  for _ = 1, fewer > 0 and #compared - fewer or 0 do table.insert(beside, 1, table.remove(compared)) end
  return compared, failed, left_out, beside
end

-- The references that have an answer, at most two, and why it is not two.
local function run_references(bench, inputs, compared)
  local refs, done = references(inputs, compared), {}
  for i, r in ipairs(refs) do
    local estimate = still_to_come(bench, inputs, compared)
    bench:progress("reference " .. i .. ", " .. r.label, i, 2, estimate)
    if not bench:record(r) and not bench:fits(bench:estimate(r)) then
      return done, ("the budget leaves no time for the reference (%s) and its own check, about %.2g s; "
        .. "a call with a larger budget continues from here"):format(r.label, estimate)
    end
    r.record = bench:run(r)
    if not r.record then
      return done, ("the budget ended in the reference (%s); give a larger one"):format(r.label)
    end
    if r.record.failed then return done, ("the reference (%s) has no answer: %s"):format(r.label, r.record.failed) end
    done[i] = r
  end
  return done
end

-- Settings and references as many as fit. With the references measured there may be room for more settings, which are
-- then tried; where their references do not fit after all, what was compared before stands.
local function compare_within(bench, inputs)
  local found
  repeat
    local compared, failed, left_out, beside = run_settings(bench, inputs, ladder.grid(inputs))
    local refs, problem = {}, nil
    if #compared > 0 then refs, problem = run_references(bench, inputs, compared) end
    local more = not found or #refs == 2
      and (#compared > #found[1] or #compared + #beside > #found[1] + #found[6])
    if more then found = table.pack(compared, failed, left_out, refs, problem, beside) end
  until not more or #refs < 2 or #left_out + #beside == 0
  return table.unpack(found, 1, 6)
end

-- The settings that are compared: those with references of their own, and those beside them that are no finer than the
-- finest reference; all of them if there is no reference. The others are left out.
local function with_those_beside(inputs, base, beside, refs, left_out)
  local all, finest = table.move(base, 1, #base, 1, {}), refs[#refs]
  for _, s in ipairs(beside) do
    if not finest or ladder.no_finer(inputs, s, finest) then all[#all + 1] = s
    else left_out[#left_out + 1] = { label = s.label, values = s.values, estimate = 0, rest = 0 } end
  end
  return all
end

-- A note where more elements are another problem: limits of fracture that are strains go with the elements' length.
local function elements_matter(inputs, compared)
  for _, input in ipairs(inputs) do
    if input.name:find "^elements" and compared[1].record.strain_limits then return notes_of_elements end
  end
end

local function parameters_of(scenario, o)
  local base = scenario:values(o.case)
  for name, value in pairs(o.parameters) do
    local default = scenario.parameters[name]
    if default == nil then
      check.unknown(where .. ": parameters", "parameter", name, check.keys(scenario.parameters))
    end
    if type(value) ~= type(default) then
      check.fail("%s: parameter %s is %s; must be a %s, like its default", where, name, check.show(value),
        type(default))
    end
    base[name] = value
  end
  return base
end

--- hinge.cost: see words/cost.d.lua.
function cost.compare(scenario, options)
  if not scenarios.is(scenario) then
    check.fail("%s: takes a scenario, made by hinge.scenario{...}, got %s", where, check.show(scenario))
  end
  local o = check.options(where, options, rules)
  if o.out and core.sandboxed() then
    check.fail("%s: field 'out' is not available to a script in the sandbox: it would be a folder of its own", where)
  end
  local inputs = ladder.inputs(where, scenario, o, o.parameters)
  local bench = benches.open(scenario, parameters_of(scenario, o), inputs, o)
  if o.effects then return effects.compare(bench, inputs, o) end
  if #inputs == 0 then
    check.fail("%s: the scenario has no setting to vary; give accuracy = { dt = { 1e-5, 2e-5, 4e-5 } } and the like, "
      .. "and use p.dt in run", where)
  end
  local base, failed, left_out, refs, problem, beside = compare_within(bench, inputs)
  local compared = with_those_beside(inputs, base, beside, refs, left_out)
  if #refs == 0 then base = compared end
  local idle
  compared, idle = alike.merged(inputs, compared)
  base = alike.merged(inputs, base)
  if #compared == 0 then
    check.fail("%s: %s", where,
      failed[1] and "no setting has an answer: " .. failed[1].failed
      or "the budget ended before the first setting was finished; give a larger one")
  end
  local notes = { problem }
  table.move(idle, 1, #idle, #notes + 1, notes)
  if #beside > 0 and refs[2] then
    notes[#notes + 1] = ("the budget left no time for references finer than all settings; the finest one is %s")
      :format(refs[2].label)
  end
  local spread, silent = bench:scatter(default_of(inputs, base))
  notes[#notes + 1] = silent
  notes[#notes + 1] = elements_matter(inputs, compared)
  local both = refs[2] and refs
  local function weigh(moving)
    local quantities = verdict.answers(both, spread, moving, compared, o.within)
    return quantities, verdict.estimates(inputs, base, refs, quantities, o.within)
  end
  -- an answer that differs from run to run is no chaos: one more run of the cheapest setting tells, before runs are
  -- changed for their scatter
  local called = scatter.chaotic(weigh {}, o.quantity)
  local moving = bench:time_alternately(called and { compared[1] } or compared, called and math.min(o.repeats, 2)
    or o.repeats)
  local quantities, finest = weigh(moving)
  if o.quantity and not quantities[o.quantity] then
    check.unknown(where .. ": quantity", "quantity", o.quantity, check.keys(quantities))
  end
  if scatter.chaotic(quantities, o.quantity) then
    notes[#notes + 1] = bench:vary(compared)
    scatter.settle(compared, quantities)
  end
  for name in pairs(bench:time_alternately(compared, o.repeats)) do
    if quantities[name] then quantities[name] = { state = "moving", kind = quantities[name].kind } end
  end
  local by = verdict.errors(compared, refs, quantities, o.quantity)
  local orders = verdict.orders(inputs, base, refs, by)
  local needed, beyond = verdict.needed(inputs, by, #refs, o.within), nil
  if needed then
    beyond = ladder.reference(inputs, base, needed)
    beyond = { values = beyond.values, label = beyond.label, seconds = bench:estimate(beyond) }
  end
  local finest_label = finest.label
  verdict.describe(quantities)
  local front, best = verdict.front(compared, o.within)
  local equal = methods.compare(inputs, compared, o.within, best)
  for i, r in ipairs(refs) do
    refs[i] = { values = r.values, label = r.label, seconds = r.record.seconds[1], answers = r.record.answers,
      high = r.high }
  end
  local result = {
    within = o.within, quantity = o.quantity, case = o.case, perturbation = o.perturbation,
    inputs = inputs, settings = compared, failed = failed, left_out = left_out, references = refs[2] and refs,
    finer = refs, beyond = beyond, finest = finest_label, compared_by = check.keys(by),
    quantities = quantities, orders = orders, equal = equal, front = front, cheapest = best, notes = notes,
    complete = #left_out + #beside == 0 and refs[2] ~= nil, elapsed = bench:elapsed(),
  }
  if o.out then require "hinge.cost.report".write(result, o.out) end
  return result
end

return cost
