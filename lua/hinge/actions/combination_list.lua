-- The list that hinge.combinations returns: the names of combinations, and the list as a table.
local check = require "hinge.library.check"
local columns = require "hinge.library.columns"
local sets = require "hinge.actions.combination_sets"

local list = {}

local function factor_text(x)
  local text = ("%.10g"):format(x)
  return text:find "[.e]" and text or text .. ".0"
end

--- "ULS 1.35 G + 1.5 office": permanent cases that share a factor are written as one.
function list.name_of(o, cases, factors)
  local first = o.first_type
  local permanents, shared = sets.of_type(cases, first), true
  for _, c in ipairs(permanents) do shared = shared and factors[c.name] == factors[permanents[1].name] end
  shared = shared and #permanents > 1
  local text, written = o.kind, false
  for _, c in ipairs(cases) do
    local factor = factors[c.name]
    local skip = not factor or shared and c.type == first and c ~= permanents[1]
    if not skip then
      local sign = factor < 0 and " - " or written and " + " or " "
      text = ("%s%s%s %s"):format(text, sign, factor_text(math.abs(factor)), shared and c.type == first and first
        or c.name)
      written = true
    end
  end
  return text
end

--- Without those whose loads are a part of the loads of another one with the same factors.
function list.without_parts(all)
  local kept = {}
  for i, a in ipairs(all) do
    local is_part = false
    for k, b in ipairs(all) do
      local inside, larger = k ~= i and a.rule == b.rule, false
      for name, factor in pairs(a.factors) do inside = inside and b.factors[name] == factor end
      for name in pairs(b.factors) do larger = larger or a.factors[name] == nil end
      is_part = is_part or inside and larger
    end
    if not is_part then kept[#kept + 1] = a end
  end
  return kept
end

local methods = {}
list.class = { __name = "hinge.combination_list", __index = methods }

--- list:table(): a line for each combination, with the factors of the cases as columns.
function methods.table(self)
  local rows = { { "rule", table.unpack(self.cases) } }
  for _, row in ipairs(self) do
    local line = { row.rule }
    for _, name in ipairs(self.cases) do
      line[#line + 1] = row.factors[name] and ("%.5g"):format(row.factors[name]) or "-"
    end
    rows[#rows + 1] = line
  end
  local lines = columns.lines(rows)
  table.insert(lines, 1, ("%s, %s: %s"):format(self.standard, self.kind, check.count(#self, "combination")))
  if #self.left_out > 0 then
    lines[#lines + 1] = "load cases of the model in none of them: " .. table.concat(self.left_out, ", ")
  end
  return table.concat(lines, "\n")
end
list.class.__tostring = methods.table

--- The names of the cases that are in the combinations, in the order of `cases`, and of those that are in none.
function list.used_and_not(rows, cases, known)
  local is_used, used, left_out = {}, {}, {}
  for _, row in ipairs(rows) do
    for name in pairs(row.factors) do is_used[name] = true end
  end
  for _, c in ipairs(cases) do
    if is_used[c.name] then used[#used + 1] = c.name end
  end
  for _, name in ipairs(known) do
    if not is_used[name] then left_out[#left_out + 1] = name end
  end
  return used, left_out
end

return list
