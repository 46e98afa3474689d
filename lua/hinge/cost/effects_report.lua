-- The results of leaving out effects: a printed table, effects.csv and summary.json. Those of laws: laws_report.lua.
local core = require "hinge.core"
local compare = require "hinge.cost.compare"
local laws_report = require "hinge.cost.laws_report"
local text = require "hinge.cost.text"
local columns = require "hinge.library.columns"

local report = {}
local percent, sorted = text.percent, text.sorted
local most_rows = 14 -- answers shown; effects.csv has them all

local function change(row)
  if row.same then return "nothing: 0 (same bits)" end
  return (row.lost and "no more than scatter: " or "") .. percent(row.change)
end

local function effects_table(result)
  local rows, fewest, most = {}, #result.times, #result.times
  for _, row in ipairs(result.effects) do
    if not row.failed then
      rows[#rows + 1] = { row.name, change(row), row.same and "" or row.worst or "-",
        ("%.1f %%"):format(100 * row.saves), ("%.1f"):format(100 * row.spread), ("%.3g"):format(row.seconds),
        percent(row.energy_error) }
      fewest, most = math.min(fewest, #row.times), math.max(most, #row.times)
    end
  end
  rows[#rows + 1] = { "(all effects)", "", "", "", "", ("%.3g"):format(result.seconds), percent(result.energy_error) }
  local times = fewest == most and tostring(most) or ("%d to %d"):format(fewest, most)
  columns.print(("Each effect left out by itself, timed %s times alternately: what it changes, "
    .. "and what part of the time it takes"):format(times),
    { "effect", "changes", "most in", "takes", "+-", "s without", "energy error" }, rows)
end

local function answers_table(result)
  local largest, shown = {}, {}
  for name in pairs(result.answers) do largest[name] = 0 end
  for _, row in ipairs(result.effects) do
    if not row.failed and not row.same then shown[#shown + 1] = row end
    for name, c in pairs(row.changes) do largest[name] = compare.larger(largest[name], c) end
  end
  if #shown == 0 then return end
  local names = sorted(largest, function(a, b) return largest[a] > largest[b] or largest[a] == largest[b] and a < b end)
  local head, rows = { "answer" }, {}
  for _, row in ipairs(shown) do head[#head + 1] = row.name end
  table.move({ "own error", "scatter" }, 1, 2, #head + 1, head)
  for i = 1, math.min(#names, most_rows) do
    rows[i] = { names[i] }
    for _, row in ipairs(shown) do table.insert(rows[i], percent(row.changes[names[i]])) end
    table.insert(rows[i], percent(result.answers[names[i]].error))
    table.insert(rows[i], percent(result.answers[names[i]].scatter))
  end
  columns.print("Change of each answer without an effect"
    .. (#names > most_rows and ("; %d more in effects.csv"):format(#names - most_rows) or ""), head, rows)
end

--- Prints it all.
function report.show(result)
  effects_table(result)
  answers_table(result)
  laws_report.show(result)
  print ""
  if result.finer then print(("own error: difference from a setting twice as fine (%s)"):format(result.finer)) end
  print(("scatter: change of the answer when every number changes by a relative %g"):format(result.perturbation))
  for _, note in ipairs(result.notes) do print("note: " .. note) end
  for _, row in ipairs(result.effects) do
    if row.failed then print(("%s cannot be left out: %s"):format(row.name, row.failed)) end
  end
  for _, row in ipairs(result.laws) do
    if row.failed then print(("%s: no answer: %s"):format(row.name, row.failed)) end
  end
  if #result.absent > 0 then print("not in this scenario: " .. table.concat(result.absent, ", ")) end
  if #result.left_out > 0 then print("not tried because of the budget: " .. table.concat(result.left_out, ", ")) end
  local small = {}
  for _, row in ipairs(result.effects) do
    local scatter = row.lost and result.answers[row.worst].scatter or 0
    if row.change and row.change <= result.within and scatter <= result.within then small[#small + 1] = row.name end
  end
  print(#small > 0
    and ("changes no more than %s, each by itself: %s"):format(percent(result.within), table.concat(small, ", "))
    or ("every effect of this scenario changes an answer by more than %s"):format(percent(result.within)))
end

local function csv(result)
  local names, lines, head = sorted(result.answers), {}, {}
  for title in ("effect change worst same lost saves spread seconds timings energy_error failed"):gmatch "%S+" do
    head[#head + 1] = title
  end
  for _, name in ipairs(names) do head[#head + 1] = "change of " .. name end
  lines[1] = text.csv_line(head)
  for _, row in ipairs(result.effects) do
    local cells = { row.name, row.change or "", row.worst or "", row.same or false, row.lost or false, row.saves or "",
      row.spread or "", row.seconds or "", row.times and #row.times or 0, row.energy_error or "", row.failed or "" }
    for _, name in ipairs(names) do cells[#cells + 1] = row.changes[name] or "" end
    lines[#lines + 1] = text.csv_line(cells)
  end
  return table.concat(lines, "\n") .. "\n"
end

-- Rows without their answers, which are long.
local function short(rows)
  local list = {}
  for i, row in ipairs(rows) do
    list[i] = {}
    for name, value in pairs(row) do
      if name ~= "answers" then list[i][name] = value end
    end
  end
  return list
end

--- Writes effects.csv, summary.json and, if a section can yield, laws.csv into a folder.
function report.write(result, out)
  core.write_text(out .. "/effects.csv", csv(result))
  if #result.laws > 0 then core.write_text(out .. "/laws.csv", laws_report.csv(result)) end
  local summary = {}
  for name, value in pairs(result) do
    if name ~= "values" then summary[name] = value end
  end
  summary.effects, summary.laws = short(result.effects), short(result.laws)
  summary.version = core.version
  core.write_json(out .. "/summary.json", summary)
end

return report
