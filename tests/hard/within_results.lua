-- Results of tests/hard/within.lua: its file, its table, and the answers that miss.
local core = require "hinge.core"
local values = require "hinge.library.values"
local results = {}

local columns = { "seed", "class", "asked", "status", "reached", "estimated", "own", "asking", "runs", "reference",
  "named", "setting", "why", "answers", "scene" }
local numbers = { seed = true, asked = true, estimated = true, own = true, asking = true, runs = true,
  reference = true }
-- Of an answer, in this order, after its name.
local of_answer = { "value", "estimated", "reference", "distance", "open", "chaotic", "alone", "holds", "told" }

local function text(value)
  if value == nil then return "" end
  if math.type(value) == "float" then return ("%.6g"):format(value) end
  return tostring(value)
end

local function value_of(word)
  if word == "" then return nil end
  if word == "true" or word == "false" then return word == "true" end
  if word == "inf" then return math.huge end
  return tonumber(word)
end

--- A row as a line of CSV.
function results.line(row)
  local answers = {}
  for i, a in ipairs(row.answers) do
    local parts = { a.name }
    for _, name in ipairs(of_answer) do parts[#parts + 1] = text(a[name]) end
    answers[i] = table.concat(parts, ":")
  end
  local cells = {}
  for i, name in ipairs(columns) do
    local cell = name == "answers" and table.concat(answers, "|") or text(row[name])
    cells[i] = numbers[name] and cell or '"' .. cell:gsub('"', "'"):gsub("%s+", " ") .. '"'
  end
  return table.concat(cells, ",")
end

--- The row of a line; nil where it is none.
function results.read(line)
  local cells, row = values.csv_fields(line), { answers = {} }
  for i, name in ipairs(columns) do
    if not cells[i] then return nil end
    if numbers[name] then row[name] = value_of(cells[i]) elseif name ~= "answers" then row[name] = cells[i] end
  end
  row.seed = math.tointeger(row.seed)
  if not row.seed or not row.asked then return nil end
  row.reached, row.named = row.reached == "true", row.named == "true"
  for item in cells[14]:gmatch "[^|]+" do
    local a, words = {}, {}
    for word in (item .. ":"):gmatch "(.-):" do words[#words + 1] = word end
    a.name = words[1]
    for i, name in ipairs(of_answer) do a[name] = value_of(words[i + 1]) end
    row.answers[#row.answers + 1] = a
  end
  return row
end

--- The rows of a file, which is begun where there is none.
function results.open(path)
  local rows, whole = {}, core.read_text(path)
  for line in (whole or ""):gmatch "[^\n]+" do rows[#rows + 1] = results.read(line) end
  if not whole then core.write_text(path, table.concat(columns, ",") .. "\n") end
  return rows
end

-- What an answer is: "none" without a reference; "zero" in the run and in the reference; "chaotic"; "open" where the
-- reference itself still changes by more than half of what was asked; else "clear".
local function kind_of(row, a)
  if a.distance == nil then return "none" end
  if a.value == 0 and a.reference == 0 then return "zero" end
  if a.chaotic then return "chaotic" end
  if a.open == nil or not (a.open <= row.asked / 2) then return "open" end
  return "clear"
end

local slow = 0.2 -- s: in shorter runs most is the making of the model, and the cost of asking the number of runs

local function counted() return { n = 0, yes = 0 } end
local function count(of, yes) of.n, of.yes = of.n + 1, of.yes + (yes and 1 or 0) end

local function add(group, row)
  group.scenes = group.scenes + 1
  if row.status ~= "told" then
    group.untold = group.untold + 1
    return
  end
  count(group.reached, row.reached)
  if row.own and row.own > 0 then
    local costs = row.own >= slow and group.slow_costs or group.costs
    costs[#costs + 1] = row.asking / row.own
  end
  for _, a in ipairs(row.answers) do
    local kind = kind_of(row, a)
    group[kind] = (group[kind] or 0) + 1
    local near = a.distance and a.distance <= row.asked
    if kind == "clear" then
      if row.reached then count(group.within, near) end
      if a.estimated < 1 and a.open <= a.estimated / 2 then count(group.bounded, a.distance <= a.estimated + 1e-9) end
      if a.estimated < 1 and a.distance > 0 then group.sharp[#group.sharp + 1] = a.estimated / a.distance end
    elseif kind == "open" and row.reached then count(group.open_near, near)
    elseif kind == "chaotic" and a.told == nil then group.none = (group.none or 0) + 1 -- one run: no mean was told
    elseif kind == "chaotic" then
      count(group.alone, a.alone)
      count(group.holds, a.holds)
      count(group.told, a.told)
    end
  end
end

--- Counts by accuracy, of scenes that are one problem with any elements, and of the others ("named"); and of all.
function results.summary(rows)
  local groups, order = {}, {}
  local function group_of(name)
    if not groups[name] then
      groups[name] = { name = name, scenes = 0, untold = 0, costs = {}, slow_costs = {}, sharp = {} }
      for _, what in ipairs { "reached", "within", "bounded", "open_near", "alone", "holds", "told" } do
        groups[name][what] = counted()
      end
      order[#order + 1] = groups[name]
    end
    return groups[name]
  end
  local levels = {}
  for _, row in ipairs(rows) do levels[row.asked] = true end
  local sorted = {}
  for level in pairs(levels) do sorted[#sorted + 1] = level end
  table.sort(sorted)
  for _, level in ipairs(sorted) do
    for _, row in ipairs(rows) do
      if row.asked == level and not row.named then add(group_of(("%g %%"):format(100 * level)), row) end
    end
  end
  for _, row in ipairs(rows) do if not row.named then add(group_of "all", row) end end
  for _, row in ipairs(rows) do if row.named then add(group_of "elements make another problem, all", row) end end
  return order
end

local function share(of)
  return of.n > 0 and ("%d of %d (%.1f %%)"):format(of.yes, of.n, 100 * of.yes / of.n) or "-"
end
local function quantile(list, part)
  if #list == 0 then return "-" end
  table.sort(list)
  return ("%.2g"):format(list[math.max(1, math.ceil(part * #list))])
end

--- The table in Markdown.
function results.markdown(groups)
  local lines = { "| asked | scenes | reached | within what was asked | within the estimate | estimate over error | "
    .. "chaotic: in the band | mean and reference alike | within the estimate | cost of asking, runs below 0.2 s: "
    .. "median, 90 % | others | "
    .. "reference open (near) | zero | no reference | not told |", "|" .. ("---|"):rep(15) }
  for _, g in ipairs(groups) do
    local form = "| %s | %d | %s | %s | %s | %s | %s | %s | %s | %s, %s | %s, %s | %d (%s) | %d | %d | %d |"
    lines[#lines + 1] = form:format(g.name, g.scenes, share(g.reached), share(g.within), share(g.bounded),
      quantile(g.sharp, 0.5), share(g.alone), share(g.holds), share(g.told), quantile(g.costs, 0.5),
      quantile(g.costs, 0.9),
      quantile(g.slow_costs, 0.5), quantile(g.slow_costs, 0.9), g.open or 0, share(g.open_near),
      g.zero or 0, g.none or 0, g.untold)
  end
  return table.concat(lines, "\n")
end

local function percent(part) return part and ("%.3g %%"):format(100 * part) or "-" end

--- Lines of the answers that miss; `everything`: of all.
function results.misses(rows, everything)
  local lines = {}
  for _, row in ipairs(rows) do
    if everything or row.status ~= "told" then
      lines[#lines + 1] = ("seed %d, %s, asked %s: %s%s, estimated %s, %s (%s); %s"):format(row.seed, row.class,
        percent(row.asked), row.status, row.reached and ", reached" or "", percent(row.estimated), row.setting, row.why,
        row.scene)
    end
    for _, a in ipairs(row.answers) do
      local kind = kind_of(row, a)
      local far = kind == "clear" and (row.reached and not (a.distance <= row.asked) and "ASKED"
        or a.estimated < 1 and a.open <= a.estimated / 2 and not (a.distance <= a.estimated + 1e-9) and "estimate")
        or kind == "open" and row.reached and not (a.distance <= row.asked) and "open"
        or kind == "chaotic" and a.told == false and "BAND"
      if far or everything then
        lines[#lines + 1] = ("%s seed %d, %s%s, asked %s, %s: %s = %.6g, reference %s; estimated %s, true %s, "
          .. "reference open by %s; %s"):format(far or "-", row.seed, row.class, row.named and " (named)" or "",
          percent(row.asked), kind, a.name, a.value or 0 / 0, text(a.reference), percent(a.estimated),
          percent(a.distance), percent(a.open), row.setting)
      end
    end
  end
  return lines
end

--- Whether the quick scenes keep the bounds: parts of answers within what was asked and within the estimate, and of
--- bands that hold; and that no scene and no reference is left out.
function results.keeps(groups, bounds)
  for _, g in ipairs(groups) do
    if g.name == "all" then
      return g.untold == 0 and (g.none or 0) == 0 and g.within.n > 0 and g.within.yes >= bounds.within * g.within.n
        and g.bounded.yes >= bounds.bounded * g.bounded.n
        and (g.holds.n == 0 or g.holds.yes >= bounds.holds * g.holds.n)
    end
  end
  return false
end

return results
