-- The cases of a study as a table: results.csv, and what is printed of it.
local check = require "hinge.library.check"
local quote = require "hinge.library.quote"

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
  return type(value) == "string" and quote.csv(value, true) or tostring(value)
end

-- What results.csv has of its own. The last two give way to a parameter of that name, and are then run.steps and
-- run.energy_error.
tables.own = { number = true, case = true, verdict = true, reason = true, steps = true, energy_error = true }

--- Raises an error for a parameter that no study can vary: results.csv has a column of that name for something else.
function tables.check_parameter(name)
  if not tables.own[name] or name == "steps" or name == "energy_error" then return end
  check.fail("a study cannot vary a parameter named '%s': results.csv has a column of that name; rename the parameter "
    .. "(number, case, verdict and reason are taken)", name)
end

--- The names of results that have columns of their own: a result with the name of a parameter that varies is that
-- parameter. And what varies, as a set.
function tables.columns_of(study)
  local varied, names = {}, {}
  for _, name in ipairs(study.varied) do varied[name] = true end
  for _, name in ipairs(tables.quantities(study.cases)) do
    if not varied[name] then names[#names + 1] = name end
  end
  return names, varied
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
  local quantities, varied = tables.columns_of(study)
  local head = { "number" }
  if study.has_cases then head[#head + 1] = "case" end
  table.move(study.varied, 1, #study.varied, #head + 1, head)
  head[#head + 1] = "verdict"
  table.move(quantities, 1, #quantities, #head + 1, head)
  for _, name in ipairs { "energy_error", "steps", "reason" } do
    head[#head + 1] = (varied[name] and "run." or "") .. name
  end
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

-- A column: its texts, the head first, its width with the blanks before it, and whether all cases have the same.
local function column(name, cases, f)
  local c = { name = name, texts = { name }, same = #cases > 1 }
  local widest, whole = #name, cases[1] and csv(f(cases[1]))
  for i, one in ipairs(cases) do
    local value = f(one)
    c.texts[i + 1] = short(value)
    widest = math.max(widest, #c.texts[i + 1])
    c.same = c.same and csv(value) == whole -- with all digits
  end
  c.width = widest + 2
  return c
end

-- The columns of a list that fit into so much room, the first ones first, and the room that is left.
local function fitting(list, room)
  local chosen = {}
  for _, c in ipairs(list) do
    if c.width <= room then
      chosen[c], room = true, room - c.width
    end
  end
  return chosen, room
end

--- The cases as lines of text, `width` columns at most: number, results, what varied, verdict. What is the same in all
--- cases is in the footer, as lines of text. Returns the lines, how many columns had no room, and the footer.
-- Results and what varied share the room: what varied has what it needs, up to half of it.
function tables.lines(study, width)
  local cases, constants = study.cases, {}
  local first = { column("number", cases, function(c) return c.number end) }
  if study.has_cases then first[2] = column("case", cases, function(c) return c.case end) end
  local results, varied = {}, {}
  local function add(list, c) table.insert(c.same and constants or list, c) end
  for _, name in ipairs((tables.columns_of(study))) do
    add(results, column(name, cases, function(c) return c.results[name] end))
  end
  for _, name in ipairs(study.varied) do add(varied, column(name, cases, function(c) return c.parameters[name] end)) end
  add(varied, column("verdict", cases, function(c) return c.verdict end))
  local room, wanted = width, 0
  for _, c in ipairs(first) do room = room - c.width end
  for _, c in ipairs(varied) do wanted = wanted + c.width end
  local kept = math.min(wanted, math.floor(room / 2))
  local chosen, rest = fitting(results, room - kept)
  local others
  others, rest = fitting(varied, kept + rest)
  local more = {}
  for _, c in ipairs(results) do more[#more + 1] = not chosen[c] and c or nil end
  more = fitting(more, rest)
  local lines, left_out = {}, 0
  for i = 0, #cases do lines[i + 1] = "" end
  for k, list in ipairs { first, results, varied } do
    for _, c in ipairs(list) do
      if k == 1 or chosen[c] or others[c] or more[c] then
        for i, text in ipairs(c.texts) do lines[i] = lines[i] .. (" "):rep(c.width - #text) .. text end
      else
        left_out = left_out + 1
      end
    end
  end
  return lines, left_out, tables.footer(constants, #cases, width)
end

--- What is the same in all cases, in lines of text no wider than `width`.
function tables.footer(constants, count, width)
  local lines, line = {}, ("  the same in all %d cases:"):format(count)
  for i, c in ipairs(constants) do
    local part = (" %s %s%s"):format(c.name, c.texts[2] == "" and "(none)" or c.texts[2], i < #constants and "," or "")
    if #line + #part > width then
      lines[#lines + 1], line = line, "   "
    end
    line = line .. part
  end
  if #constants > 0 then lines[#lines + 1] = line end
  return lines
end

return tables
