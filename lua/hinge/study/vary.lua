-- What a study varies: values in the command line's words or as Lua tables, and the list of cases that follows.
local check = require "hinge.library.check"
local values = require "hinge.library.values"
local draws = require "hinge.study.draws"
local files = require "hinge.study.files"

local vary = {}
local most = 1000000 -- cases of one study

local function number_in(text, whole)
  local number = values.number(text)
  if not number then check.fail("%s: '%s' is not a number; a sum such as 440/3.6 is one", whole, text) end
  return number
end

-- first:last:step as a list, with the last one in it if it is within a millionth of a step.
local function range(first, last, by, whole)
  if by == 0 or (last - first) / by < 0 then
    check.fail("%s: no value lies between %g and %g in steps of %g", whole, first, last, by)
  end
  local n = math.floor((last - first) / by + 1e-6)
  if n >= most then check.fail("%s: that is %.0f values; at most %d are allowed", whole, n + 1, most) end
  local list = {}
  for i = 0, n do
    local value = first + i * by
    list[#list + 1] = math.type(first) == "integer" and math.type(by) == "integer" and math.tointeger(value) or value
  end
  return list
end

--- Words of the command line as { { name =, values = } or { name =, distribution = }, ... }: key=a,b,c,
-- key=first:last:step, key~normal(mean,deviation).
function vary.from_words(words)
  local list = {}
  for _, word in ipairs(words) do
    local name, sign, text = word:match "^([%a_][%w_]*)([=~])(.+)$"
    if not name then
      check.fail("'%s' is not a setting; write key=value, key=a,b,c, key=first:last:step or key~normal(mean,deviation)",
        word)
    end
    for _, other in ipairs(list) do
      if other.name == name then check.fail("%s: %s is given twice", word, name) end
    end
    if sign == "~" then
      list[#list + 1] = { name = name, distribution = draws.distribution(text, word) }
    else
      local first, last, by = text:match "^([^:]+):([^:]+):([^:]+)$"
      local items = {}
      if first then
        items = range(number_in(first, word), number_in(last, word), number_in(by, word), word)
      elseif text:find "^{" or not text:find "," then
        items = { values.guess(text) }
      else
        for item in values.items(text, word) do items[#items + 1] = values.guess(item) end
      end
      list[#list + 1] = { name = name, values = items }
    end
  end
  return list
end

--- The same from a Lua table: { speed = { 90, 110 }, mass = { from =, to =, by = }, size = 15,
-- height = "normal(30, 1)" }.
function vary.from_table(given)
  local list = {}
  for _, name in ipairs(check.keys(given)) do
    local what, where = given[name], "hinge.study: vary." .. name
    if type(what) == "string" and what:find "^%a+%(" then
      list[#list + 1] = { name = name, distribution = draws.distribution(what, where) }
    elseif type(what) == "table" and what.from then
      local o = check.options(where, what, { from = { "number" }, to = { "number" }, by = { "number" } })
      list[#list + 1] = { name = name, values = range(o.from, o.to, o.by, where) }
    elseif type(what) == "table" then
      if #what == 0 then check.fail("%s: the list of values is empty", where) end
      list[#list + 1] = { name = name, values = what }
    else
      list[#list + 1] = { name = name, values = { what } }
    end
  end
  return list
end

--- Adds to a plan what the scenario's own `vary` has and the plan does not name. plan: see vary.cases.
function vary.add_own(plan, scenario)
  local given = {}
  for _, one in ipairs(plan.list) do given[one.name] = true end
  for _, name in ipairs(plan.row_names or {}) do given[name] = true end
  for _, one in ipairs(vary.from_table(scenario and scenario.vary or {})) do
    if not given[one.name] then table.insert(plan.list, one) end
  end
end

--- The values that all cases have where a function proposes the others, by name. Raises an error for what would ask for
-- cases of its own. plan: see vary.cases; where: for messages; dashes: what options have before their names there.
function vary.fixed(plan, where, dashes)
  for _, one in ipairs { { "cases" }, { "table", "rows" }, { "samples" }, { "method" }, { "seed" } } do
    if plan[one[2] or one[1]] then
      check.fail("%s: %s%s has no effect; the function proposes the cases", where, dashes, one[1])
    end
  end
  local fixed = {}
  for _, one in ipairs(plan.list) do
    if not one.values or #one.values > 1 then
      check.fail("%s: %s has several values; the function proposes them", where, one.name)
    end
    fixed[one.name] = one.values[1]
  end
  return fixed
end

--- The rows of a CSV file with names in its first line: a list of { name = value }, and the names.
function vary.rows(path)
  local file, problem = files.open(path) -- its rows are the cases: it says nothing about any one of them
  if not file then check.fail("--table: %s", problem) end
  local rows, names = {}, nil
  local number = 0
  for line in file:lines() do
    line, number = line:gsub("\r$", ""):gsub("^\u{FEFF}", ""), number + 1
    if line:find "%S" and not line:find "^#" then
      local items = values.csv_fields(line)
      if not names then
        names = items
        for _, name in ipairs(names) do
          if not name:find "^[%a_][%w_]*$" then
            check.fail("--table: %s:%d: '%s' is not a parameter's name", path, number, name)
          end
        end
      else
        if #items ~= #names then
          check.fail("--table: %s:%d: %s, and the first line has %s", path, number, check.count(#items, "value"),
            check.count(#names, "name"))
        end
        local row = {}
        for i, name in ipairs(names) do row[name] = values.guess(items[i]) end
        rows[#rows + 1] = row
      end
    end
  end
  file:close()
  if #rows == 0 then check.fail("--table: %s has no row", path) end
  return rows, names
end

-- The product of a list of cases and a name's values.
local function times(cases, name, items)
  if #cases * #items > most then
    check.fail("the study would have %d cases; at most %d are allowed", #cases * #items, most)
  end
  local list = {}
  for _, case in ipairs(cases) do
    for _, item in ipairs(items) do
      local new = { case = case.case, parameters = {} }
      for key, value in pairs(case.parameters) do new.parameters[key] = value end
      if name then new.parameters[name] = item else new.case = item end
      list[#list + 1] = new
    end
  end
  return list
end

--- All cases of a study, in order: { { case =, parameters = { name = value } }, ... }, and the names that vary, in the
-- order of the columns. plan: list (of from_words or from_table), cases (names or nil), rows, row_names, samples, seed,
-- method. The first name varies slowest. Draws are the same for each combination of the other values.
function vary.cases(plan)
  local cases, names, random = { { parameters = {} } }, {}, {}
  if plan.cases then cases = times(cases, nil, plan.cases) end
  if plan.rows then
    local list = {}
    for _, case in ipairs(cases) do
      for _, row in ipairs(plan.rows) do list[#list + 1] = { case = case.case, parameters = row } end
    end
    cases = list
    for _, name in ipairs(plan.row_names) do names[#names + 1] = name end
  end
  for _, one in ipairs(plan.list) do
    for _, name in ipairs(names) do
      if name == one.name then check.fail("%s is given twice", name) end
    end
    names[#names + 1] = one.name
    if one.distribution then random[#random + 1] = one
    else cases = times(cases, one.name, one.values) end
  end
  if #random == 0 then
    if plan.samples then check.fail "samples: nothing is drawn; write a parameter as key~normal(mean,deviation)" end
    return cases, names
  end
  local drawn = draws.table(random, plan.samples or 100, plan.seed or 1, plan.method or "lhs")
  if #cases * #drawn > most then
    check.fail("the study would have %d cases; at most %d are allowed", #cases * #drawn, most)
  end
  local list = {}
  for _, case in ipairs(cases) do
    for _, draw in ipairs(drawn) do
      local new = { case = case.case, parameters = {} }
      for key, value in pairs(case.parameters) do new.parameters[key] = value end
      for key, value in pairs(draw) do new.parameters[key] = value end
      list[#list + 1] = new
    end
  end
  return list, names
end

return vary
