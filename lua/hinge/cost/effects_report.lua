-- The results of leaving out effects, and of other laws of sections: what matters in words, a table, effects.csv and
-- summary.json.
local core = require "hinge.core"
local compare = require "hinge.cost.compare"
local text = require "hinge.cost.text"
local words = require "hinge.cost.words"
local columns = require "hinge.library.columns"

local report = {}
local percent, sorted = text.percent, text.sorted
local most_answers = 6  -- in the table; effects.csv has them all
local decides = 0.5     -- part of an answer: an effect that changes more of it decides
local measurable = 0.02 -- part of the time; also no more than the rounds differ by is nothing that can be measured

local function short(part) return (part < 0.1 and "%.2g %%" or "%.0f %%"):format(100 * part) end

-- Effects and laws that have an answer, those that take most of the time first.
local function measured(result)
  local rows = {}
  for _, list in ipairs { result.effects, result.laws } do
    for _, row in ipairs(list) do rows[#rows + 1] = not row.failed and row or nil end
  end
  table.sort(rows, function(a, b) return a.saves > b.saves or a.saves == b.saves and a.name < b.name end)
  return rows
end

-- What an effect does: its change of the answer that it changes most.
local function change_in_words(row, within)
  if row.same then return "changes nothing" end
  if not row.change or row.change == 0 then return "changes no answer" end
  if row.lost then return ("changes nothing beyond scatter (%s of %s)"):format(short(row.change), row.worst) end
  if row.change == math.huge then return ("decides (without it there is no %s)"):format(row.worst) end
  if row.change >= decides then return ("decides (%s of %s)"):format(short(row.change), row.worst) end
  if row.change <= within then return ("changes no answer by more than %s"):format(short(row.change)) end
  return ("changes %s by %s"):format(row.worst, short(row.change))
end

-- row.instead: another law is in the place of one, not only something left out.
local function name_of(row) return row.law and not row.instead and row.law or row.name end

local function cost_in_words(row)
  if math.abs(row.saves) <= math.max(measurable, row.spread or 0) then
    return row.instead and "takes the same time" or "costs nothing"
  end
  if row.instead then
    return ("takes %s %s time"):format(short(math.abs(row.saves)), row.saves > 0 and "less" or "more")
  end
  return row.saves > 0 and ("costs %s of the time"):format(short(row.saves))
    or ("saves time: without it the run takes %s longer"):format(short(-row.saves))
end

-- "contact decides (100 % of plastic_kJ) and costs 61 %"; those of which the same is said are named together.
local function sentences(result)
  local said, order = {}, {}
  for _, row in ipairs(measured(result)) do
    local what = { change_in_words(row, result.within), cost_in_words(row) }
    local key = what[1] .. what[2]
    if not said[key] then
      said[key] = { names = {}, what = what }
      order[#order + 1] = said[key]
    end
    table.insert(said[key].names, name_of(row))
  end
  local lines = {}
  for i, s in ipairs(order) do
    local several = #s.names > 1
    local function verb(clause) return several and clause:gsub("^(%l+)s ", "%1 ") or clause end
    lines[i] = ("%s %s and %s"):format(words.list(s.names), (verb(s.what[1])), (verb(s.what[2])))
  end
  return lines
end

-- A change of an answer; in brackets if it is no more than the answer scatters.
local function cell(change, scatter)
  if change == 0 then return "0" end
  return change and scatter and change <= scatter and ("(%s)"):format(percent(change)) or percent(change)
end

-- The answers that change most, those beyond their scatter first.
local function answers_of(result, rows)
  local largest = {}
  for name, answer in pairs(result.answers) do
    largest[name] = -1
    for _, row in ipairs(rows) do
      local change = row.changes[name] or 0
      largest[name] = compare.larger(largest[name], change > (answer.scatter or 0) and change or change - 1)
    end
  end
  return sorted(largest, function(a, b) return largest[a] > largest[b] or largest[a] == largest[b] and a < b end)
end

local function print_table(result, rows)
  local names = answers_of(result, rows)
  local shown = math.min(#names, most_answers)
  local head, lines = { "left out", table.unpack(names, 1, shown) }, {}
  table.move({ "takes", "+-", "s", "energy error" }, 1, 4, #head + 1, head)
  for i, row in ipairs(rows) do
    lines[i] = { name_of(row) }
    for k = 1, shown do lines[i][k + 1] = cell(row.changes[names[k]], result.answers[names[k]].scatter) end
    table.move({ ("%.1f %%"):format(100 * row.saves), row.spread and ("%.1f"):format(100 * row.spread) or "-",
      ("%.3g"):format(row.seconds), percent(row.energy_error) }, 1, 4, shown + 2, lines[i])
  end
  local as_it_is = { "(nothing)" }
  for k = 2, shown + 3 do as_it_is[k] = "" end
  table.move({ ("%.3g"):format(result.seconds), percent(result.energy_error) }, 1, 2, shown + 4, as_it_is)
  lines[#lines + 1] = as_it_is
  for _, of in ipairs { "error", "scatter" } do
    local line = { of == "error" and "(own error)" or "(scatter)" }
    for k = 1, shown do line[k + 1] = percent(result.answers[names[k]][of]) end
    lines[#lines + 1] = line
  end
  columns.print("Change of each answer, and the part of the time that is taken"
    .. (#names > shown and ("; %d more answers in effects.csv"):format(#names - shown) or ""), head, lines)
end

--- Prints it all, what matters first.
function report.show(result)
  local rows = measured(result)
  for _, line in ipairs(sentences(result)) do print(line) end
  for _, list in ipairs { result.effects, result.laws } do
    for _, row in ipairs(list) do
      if row.failed then print(("%s: no answer without it: %s"):format(row.name, row.failed)) end
    end
  end
  if #rows > 0 then print_table(result, rows) end
  print ""
  if result.finer then print(("own error: difference from a setting twice as fine (%s)"):format(result.finer)) end
  print(("scatter: change of an answer when every number changes by a relative %g; changes in brackets are no larger")
    :format(result.perturbation))
  for _, note in ipairs(result.notes) do print("note: " .. note) end
  if #result.absent > 0 then print("not in this scenario: " .. table.concat(result.absent, ", ")) end
  if #result.left_out > 0 then print("not tried because of the budget: " .. table.concat(result.left_out, ", ")) end
end

-- A number; of a history the value with the largest magnitude.
local function value(answer)
  if type(answer) ~= "table" then return answer end
  local peak = 0
  for _, v in ipairs(answer.y) do
    if math.abs(v) > math.abs(peak) then peak = v end
  end
  return peak
end

local function csv(result)
  local names, lines, head = sorted(result.answers), {}, {}
  for title in ("without change worst same lost takes spread seconds timings energy_error failed"):gmatch "%S+" do
    head[#head + 1] = title
  end
  for _, name in ipairs(names) do table.move({ "change of " .. name, name }, 1, 2, #head + 1, head) end
  lines[1] = text.csv_line(head)
  local function add(row)
    local cells = { row.name, row.change or "", row.worst or "", row.same or false, row.lost or false, row.saves or "",
      row.spread or "", row.seconds or "", row.times and #row.times or 0, row.energy_error or "", row.failed or "" }
    for _, name in ipairs(names) do
      cells[#cells + 1] = row.changes[name] or ""
      cells[#cells + 1] = value((row.answers or {})[name]) or ""
    end
    lines[#lines + 1] = text.csv_line(cells)
  end
  add { name = "nothing", changes = {}, answers = result.values, seconds = result.seconds, times = result.times,
    energy_error = result.energy_error }
  for _, list in ipairs { result.effects, result.laws } do
    for _, row in ipairs(list) do add(row) end
  end
  return table.concat(lines, "\n") .. "\n"
end

-- Rows without their answers, which are long.
local function without_answers(rows)
  local list = {}
  for i, row in ipairs(rows) do
    list[i] = {}
    for name, v in pairs(row) do
      if name ~= "answers" then list[i][name] = v end
    end
  end
  return list
end

--- Writes effects.csv and summary.json into a folder.
function report.write(result, out)
  core.write_text(out .. "/effects.csv", csv(result))
  local summary = {}
  for name, v in pairs(result) do
    if name ~= "values" then summary[name] = v end
  end
  summary.effects, summary.laws = without_answers(result.effects), without_answers(result.laws)
  summary.said, summary.version = sentences(result), core.version
  core.write_json(out .. "/summary.json", summary)
end

return report
