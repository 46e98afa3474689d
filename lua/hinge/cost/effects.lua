-- What effects and laws of sections change and cost: a scenario is run without one of its effects at a time, and with
-- another law in the place of one.
--
-- The script does not change. While it runs, the engine removes the declarations of the effect from its models, or the
-- law (core.leave_out).
local check = require "hinge.library.check"
local core = require "hinge.core"
local alike = require "hinge.cost.alike"
local compare = require "hinge.cost.compare"
local ladder = require "hinge.cost.ladder"

local effects = {}
local where = "hinge.cost"
local enough = 0.5 -- s: of all times of a run together, so that differences of some percent are seen

local function least(seconds) return math.min(table.unpack(seconds)) end

local function same_bits(a, b, changes)
  local same = alike.same_states(a, b)
  for _, change in pairs(changes) do same = same and change == 0 end
  return same
end

-- Part of the time that is saved, by the shortest time of each: whatever disturbs a run makes it longer. Second, how
-- far that may be off: half the width of the middle half of the parts round by round; nil if there is one round.
local function saved(all, rest)
  local parts = {}
  for i = 1, math.min(#all, #rest) do parts[i] = 1 - rest[i] / all[i] end
  table.sort(parts)
  local n = #parts
  return 1 - least(rest) / least(all), n > 1 and (parts[n - (n - 1) // 4] - parts[1 + (n - 1) // 4]) / 2 or nil
end

-- What is run in the place of the scenario as it is, by the name of the law that is left out (core.optional_laws).
local others = { ["eq 14"] = "exact in the place of eq 14", exact = "eq 14 in the place of exact" }
local function with_law(name) return others[name] or "without " .. name end

-- The answer that changes most, of those that change by more than their scatter. If there are none, it is the one of
-- all that changes most, and true if its scatter is larger.
local function worst(changes, scatter, chosen)
  local name, most
  for _, candidate in ipairs(check.keys(changes)) do
    local change = changes[candidate]
    local rank = change > (scatter[candidate] or 0) and 2 or change > 0 and 1 or 0
    if (not chosen or chosen == candidate) and (not name or rank > most or rank == most and change > changes[name]) then
      name, most = candidate, rank
    end
  end
  return name, most == 1
end

-- The difference of the setting from one twice as fine in all numbers with a finer side, by answer. If it is not known:
-- nil and the reason.
local function own_error(bench, inputs, all)
  local numbers = {}
  for _, input in ipairs(inputs) do numbers[#numbers + 1] = input.side and input end
  if #numbers == 0 then return nil, "the scenario has no number to refine, so its own error is not known" end
  local finer = ladder.reference(numbers, { all }, 1)
  for name, value in pairs(all.values) do finer.values[name] = finer.values[name] or value end
  bench:progress("twice as fine, " .. finer.label, 0, 1, bench:estimate(finer))
  local record = (bench:record(finer) or bench:fits(bench:estimate(finer))) and bench:run(finer)
  if not record then return nil, "the budget left no time for a run twice as fine, so the error is not known" end
  if record.failed then
    return nil, ("a run twice as fine (%s) has no answer: %s"):format(finer.label, record.failed)
  end
  local errors = {}
  for name, answer in pairs(record.answers) do errors[name] = compare.error(all.record.answers[name], answer) end
  return errors, nil, finer.label
end

local function compare_one(s, all, moving, scatter, o)
  local row = { name = s.without, failed = s.failed, changes = {} }
  if s.failed then return row end
  local r = s.record
  for name, answer in pairs(all.record.answers) do
    if not moving[name] then row.changes[name] = compare.error(r.answers[name], answer) end
  end
  row.same = same_bits(all.record, r, row.changes)
  row.worst, row.lost = worst(row.changes, scatter, o.quantity)
  row.change = row.worst and row.changes[row.worst]
  row.saves, row.spread = saved(all.record.seconds, r.seconds)
  row.seconds, row.times = least(r.seconds), r.seconds
  row.energy_error, row.answers = r.energy_error, r.answers
  return row
end

--- hinge.cost with effects = true: see words/cost.d.lua.
function effects.compare(bench, inputs, o)
  local values = {}
  for _, input in ipairs(inputs) do values[input.name] = bench.base[input.name] end
  local function without(name, label)
    local s = ladder.setting(inputs, values)
    s.without, s.label = name, label
    return s
  end
  local all, notes, absent, settings, left_out, measured = without("nothing", "as it is"), {}, {}, {}, {}, {}
  all.record = bench:run(all)
  if not all.record then
    check.fail("%s: the budget ended before the scenario was finished; give a larger one", where)
  end
  if all.record.failed then check.fail("%s: the scenario has no answer: %s", where, all.record.failed) end
  local optional = {}
  for _, name in ipairs(core.optional_effects()) do
    if all.record.effects[name] then optional[#optional + 1] = without(name, "without " .. name)
    else absent[#absent + 1] = name end
  end
  for _, name in ipairs(check.keys(all.record.laws or {})) do
    optional[#optional + 1] = without(name, with_law(name))
    optional[#optional].is_law = true
  end
  for i, s in ipairs(optional) do
    bench:progress(s.label, i - 1, #optional, (#optional - i + 1) * bench:estimate(all))
    s.record = (bench:record(s) or bench:fits(bench:estimate(s))) and bench:run(s)
    if not s.record then left_out[#left_out + 1] = s.is_law and s.label or s.without
    else
      settings[#settings + 1] = s
      s.failed = s.record.failed and check.one_line(s.record.failed)
      if not s.failed then measured[#measured + 1] = s end
    end
  end
  local scatter, silent = bench:scatter(all)
  notes[#notes + 1] = silent
  local errors, unknown, finer = own_error(bench, inputs, all)
  notes[#notes + 1] = unknown
  table.insert(measured, 1, all)
  local moving = bench:time_alternately(measured, o.repeats, enough)
  local answers = {}
  for name in pairs(all.record.answers) do
    if not moving[name] then
      answers[name] = { scatter = scatter and scatter[name], error = errors and errors[name] }
    end
  end
  if o.quantity and not answers[o.quantity] then
    check.unknown(where .. ": quantity", "quantity", o.quantity, check.keys(answers))
  end
  local rows, of_laws = {}, {}
  for _, s in ipairs(settings) do
    local row = compare_one(s, all, moving, scatter or {}, o)
    if s.is_law then
      row.law, row.name, row.instead = s.without, s.label, others[s.without] ~= nil
      of_laws[#of_laws + 1] = row
    else
      rows[#rows + 1] = row
    end
  end
  local result = {
    effects = rows, laws = of_laws, values = all.record.answers, absent = absent, left_out = left_out,
    answers = answers, finer = finer, notes = notes,
    within = o.within, quantity = o.quantity, case = o.case, perturbation = o.perturbation,
    seconds = least(all.record.seconds), times = all.record.seconds, energy_error = all.record.energy_error,
    complete = #left_out == 0, elapsed = bench:elapsed(),
  }
  if o.out then require "hinge.cost.effects_report".write(result, o.out) end
  return result
end

return effects
