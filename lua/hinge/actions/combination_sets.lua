-- What the combinations of all standards are made of: the cases that act together, and every set of them.
--
-- A choice is a list of { case, factor }. A slot is a list of choices. A combination has one choice of each slot.
local check = require "hinge.library.check"

local sets = {}

local where = "hinge.combinations"
local most = 2000 -- combinations of one call

function sets.of_type(cases, ...)
  local list = {}
  for _, c in ipairs(cases) do
    for i = 1, select("#", ...) do
      if c.type == select(i, ...) then list[#list + 1] = c end
    end
  end
  return list
end

-- Every set of these cases that can act together, without the empty one.
local function sets_of(cases)
  local found = { {} }
  for _, c in ipairs(cases) do
    for i = 1, #found do
      local free = true
      for _, other in ipairs(found[i]) do free = free and not (c.alternative and c.alternative == other.alternative) end
      if free then
        local more = table.move(found[i], 1, #found[i], 1, {})
        more[#more + 1] = c
        found[#found + 1] = more
        if #found > 2 * most then
          check.fail("%s: %d cases of type %s may act in too many sets; put what acts together into one load case",
            where, #cases, c.type)
        end
      end
    end
  end
  table.remove(found, 1)
  return found
end

-- The choices of cases that act together or not, each with its factor; `must`: one of them acts.
function sets.slot_of(cases, factor, must)
  local choices = must and {} or { {} }
  for _, set in ipairs(sets_of(cases)) do
    local choice = {}
    for i, c in ipairs(set) do choice[i] = { c, factor(c) } end
    choices[#choices + 1] = choice
  end
  return choices
end

-- Each earthquake in turn, with both signs, and with a part of the others.
function sets.earthquakes(cases, factor, orthogonal)
  local choices = {}
  local function add(choice, rest, lead)
    local c = rest[1]
    if not c then choices[#choices + 1] = choice return end
    local size = c == lead and factor or orthogonal and factor * orthogonal or 0
    for _, sign in ipairs((size == 0 or not c.both_signs) and { 1 } or { 1, -1 }) do
      local longer = table.move(choice, 1, #choice, 1, {})
      longer[#longer + 1] = { c, sign * size }
      add(longer, table.move(rest, 2, #rest, 1, {}), lead)
    end
  end
  for _, lead in ipairs(cases) do add({}, cases, lead) end
  return choices
end

-- One slot for all permanent cases of a source: all with each of the factors.
function sets.permanent(cases, factors)
  local sources, slots = {}, {}
  for _, c in ipairs(cases) do
    local source = c.source or "dead loads of ASCE 7"
    if not sources[source] then
      sources[source] = {}
      slots[#slots + 1] = sources[source]
    end
    table.insert(sources[source], c)
  end
  for i, members in ipairs(slots) do
    local choices = {}
    for k, factor in ipairs(factors) do
      choices[k] = {}
      for j, c in ipairs(members) do choices[k][j] = { c, factor } end
    end
    slots[i] = choices
  end
  return slots
end

-- Whether two cases of a combination are alternatives. Earthquakes are chosen by `earthquakes`.
local function at_odds(terms)
  local seen = {}
  for _, term in ipairs(terms) do
    local key = term[1].type ~= "E" and term[2] ~= 0 and term[1].alternative
    if key and seen[key] then return true end
    if key then seen[key] = true end
  end
  return false
end

local function rounded(factor) return tonumber(("%.12g"):format(factor)) + 0.0 end

-- Adds every combination of the slots to `out.list`, without those that are there.
local function expand(out, rule, slots, terms, at)
  if at > #slots then
    if at_odds(terms) then return end
    local factors, parts = {}, {}
    for _, term in ipairs(terms) do
      local factor = rounded(term[2])
      if factor ~= 0 then factors[term[1].name] = factor end
    end
    for _, c in ipairs(out.cases) do parts[#parts + 1] = ("%.12g"):format(factors[c.name] or 0) end
    local key = table.concat(parts, " ")
    if next(factors) == nil or out.seen[key] then return end
    out.seen[key] = true
    out.list[#out.list + 1] = { factors = factors, rule = rule, key = key }
    if #out.list > most then
      check.fail("%s: there are more than %d combinations; put what acts together into one load case, or leave out "
        .. "combinations by omit = false", where, most)
    end
    return
  end
  for _, choice in ipairs(slots[at]) do
    local more = table.move(terms, 1, #terms, 1, {})
    expand(out, rule, slots, table.move(choice, 1, #choice, #more + 1, more), at + 1)
  end
end

function sets.add_rule(out, rule, permanents, slots)
  local all = table.move(permanents, 1, #permanents, 1, {})
  expand(out, rule, table.move(slots, 1, #slots, #all + 1, all), {}, 1)
end

function sets.whole(factor)
  return function() return factor or 1 end
end

function sets.needs(o, type_of, why)
  check.fail("%s: no case has the type \"%s\"; kind '%s' of %s needs %s", where, type_of, o.kind, o.standard, why)
end

return sets
