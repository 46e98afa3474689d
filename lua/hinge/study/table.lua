-- The cases of a study as a table: results.csv, and what is printed of it.
local check = require "hinge.check"

local tables = {}

local function csv(value)
  if value == nil then return "" end
  if math.type(value) == "float" then
    for digits = 15, 16 do
      local short = ("%%.%dg"):format(digits):format(value)
      if tonumber(short) == value then return short end
    end
    return ("%.17g"):format(value)
  end
  if type(value) == "table" then
    local items = {}
    for i, item in ipairs(value) do items[i] = csv(item) end
    value = "{" .. table.concat(items, ",") .. "}"
  end
  local text = tostring(value)
  return text:find '[,"\n\r]' and '"' .. text:gsub('"', '""') .. '"' or text
end

--- The names of all numbers, words and truths that cases returned, in alphabetical order.
function tables.quantities(cases)
  local seen = {}
  for _, c in ipairs(cases) do
    for name in pairs(c.results) do seen[name] = true end
  end
  return check.keys(seen)
end

--- results.csv: a row a case, in their order: number, case, what varied, verdict, what was returned, energy error,
-- steps, reason. times.csv has what differs from one computer to another: seconds and memory.
function tables.write(write, study)
  local quantities = tables.quantities(study.cases)
  local head = { "number" }
  if study.has_cases then head[#head + 1] = "case" end
  table.move(study.varied, 1, #study.varied, #head + 1, head)
  head[#head + 1] = "verdict"
  table.move(quantities, 1, #quantities, #head + 1, head)
  table.move({ "energy_error", "steps", "reason" }, 1, 3, #head + 1, head)
  for i, name in ipairs(head) do head[i] = csv(name) end
  local rows, times = { table.concat(head, ",") }, { "number,seconds [s],memory [bytes]" }
  for _, c in ipairs(study.cases) do
    local row = { csv(c.number) }
    if study.has_cases then row[#row + 1] = csv(c.case) end
    for _, name in ipairs(study.varied) do row[#row + 1] = csv(c.parameters[name]) end
    row[#row + 1] = csv(c.verdict)
    for _, name in ipairs(quantities) do row[#row + 1] = csv(c.results[name]) end
    row[#row + 1], row[#row + 2], row[#row + 3] = csv(c.energy_error), csv(c.steps), csv(c.reason)
    rows[#rows + 1] = table.concat(row, ",")
    times[#times + 1] = ("%d,%s,%s"):format(c.number, csv(c.seconds), csv(c.memory))
  end
  write("results.csv", table.concat(rows, "\n") .. "\n")
  write("times.csv", table.concat(times, "\n") .. "\n")
end

local function short(value)
  if type(value) == "number" then return ("%.6g"):format(value) end
  return value == nil and "" or tostring(value)
end

--- The cases as lines of text, `width` columns at most: what varied, the verdict, and as many results as have room.
function tables.lines(study, width)
  local columns = { { "number", function(c) return short(c.number) end } }
  if study.has_cases then columns[#columns + 1] = { "case", function(c) return short(c.case) end } end
  for _, name in ipairs(study.varied) do
    columns[#columns + 1] = { name, function(c) return short(c.parameters[name]) end }
  end
  columns[#columns + 1] = { "verdict", function(c) return short(c.verdict) end }
  for _, name in ipairs(tables.quantities(study.cases)) do
    columns[#columns + 1] = { name, function(c) return short(c.results[name]) end }
  end
  local lines, used, left_out = {}, 0, 0
  for i = 0, #study.cases do lines[i + 1] = "" end
  for _, column in ipairs(columns) do
    local texts, widest = { column[1] }, #column[1]
    for i, c in ipairs(study.cases) do
      texts[i + 1] = column[2](c)
      widest = math.max(widest, #texts[i + 1])
    end
    if used + widest + 2 > width and used > 0 then
      left_out = left_out + 1
    else
      used = used + widest + 2
      for i, text in ipairs(texts) do lines[i] = lines[i] .. "  " .. (" "):rep(widest - #text) .. text end
    end
  end
  return lines, left_out
end

return tables
