-- The results of other laws of sections: a printed table, and laws.csv.
local compare = require "hinge.cost.compare"
local text = require "hinge.cost.text"
local columns = require "hinge.library.columns"

local report = {}
local percent, sorted = text.percent, text.sorted
local most_rows = 14 -- answers shown; laws.csv has them all

-- A number; of a history the value with the largest magnitude.
local function value(answer)
  if type(answer) ~= "table" then return answer end
  local peak = 0
  for _, v in ipairs(answer.y) do
    if math.abs(v) > math.abs(peak) then peak = v end
  end
  return peak
end

local function shown(answer)
  local v = value(answer)
  return v and ("%s%.4g"):format(type(answer) == "table" and "peak " or "", v) or "-"
end

local function measured(result)
  local rows = {}
  for _, row in ipairs(result.laws) do
    if not row.failed then rows[#rows + 1] = row end
  end
  return rows
end

local function times_table(result, rows)
  local lines = {}
  for i, row in ipairs(rows) do
    local at = row.worst
    lines[i] = { row.name, ("%+.1f %%"):format(100 * row.slower), ("%.1f"):format(100 * row.spread),
      row.same and "nothing: 0 (same bits)" or (row.lost and "no more than scatter: " or "") .. percent(row.change),
      row.same and "" or at or "-", row.same and "" or at and shown(result.values[at]) or "-",
      row.same and "" or at and shown(row.answers[at]) or "-", percent(row.energy_error) }
  end
  columns.print("Laws of sections: the scenario with another law, or without one: its time, and what it changes",
    { "with", "time", "+-", "changes", "most in", "from", "to", "energy error" }, lines)
end

local function answers_table(result, rows)
  local largest, others = {}, {}
  for _, row in ipairs(rows) do
    if not row.same then others[#others + 1] = row end
    for name, c in pairs(row.changes) do largest[name] = compare.larger(largest[name] or 0, c) end
  end
  if #others == 0 then return end
  local names = sorted(largest, function(a, b) return largest[a] > largest[b] or largest[a] == largest[b] and a < b end)
  local head, lines = { "answer", "as it is" }, {}
  for _, row in ipairs(others) do head[#head + 1] = row.name end
  for i = 1, math.min(#names, most_rows) do
    lines[i] = { names[i], shown(result.values[names[i]]) }
    for _, row in ipairs(others) do table.insert(lines[i], shown(row.answers[names[i]])) end
  end
  columns.print("Each answer with another law" .. (#names > most_rows
    and ("; %d more in laws.csv"):format(#names - most_rows) or ""), head, lines)
end

--- Prints the tables; nothing where no section can yield.
function report.show(result)
  local rows = measured(result)
  if #rows == 0 then return end
  times_table(result, rows)
  answers_table(result, rows)
end

--- The text of laws.csv.
function report.csv(result)
  local names, head, lines = sorted(result.answers), {}, {}
  for title in ("with law change worst same lost slower spread seconds timings energy_error failed"):gmatch "%S+" do
    head[#head + 1] = title
  end
  for _, name in ipairs(names) do
    table.move({ "change of " .. name, name, name .. " as it is" }, 1, 3, #head + 1, head)
  end
  lines[1] = text.csv_line(head)
  for _, row in ipairs(result.laws) do
    local cells = { row.name, row.law, row.change or "", row.worst or "", row.same or false, row.lost or false,
      row.slower or "", row.spread or "", row.seconds or "", row.times and #row.times or 0, row.energy_error or "",
      row.failed or "" }
    for _, name in ipairs(names) do
      table.move({ row.changes[name] or "", value((row.answers or {})[name]) or "", value(result.values[name]) or "" },
        1, 3, #cells + 1, cells)
    end
    lines[#lines + 1] = text.csv_line(cells)
  end
  return table.concat(lines, "\n") .. "\n"
end

return report
