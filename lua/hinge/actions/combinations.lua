-- hinge.combinations: the load combinations of EN 1990 and of ASCE 7, declared in a model.
--
-- Sources. No original standard was at hand.
-- Table A1.1 of EN 1990 (psi): as the program XC has it (xcfem/xc, ec0_buildings_combination_factors_es.py), which
--   agrees with a second program (desssign) in categories A to E.
-- gamma_G 1.35 and 1.0, gamma_Q 1.5, xi 0.85 (table A1.2(B), recommended values): recalled, and used by many programs.
-- ASCE 7-16, 2.3.1 and 2.3.6: as a manual prints them (ideCAD, help page on ASCE 7-16). 2.4.1 and 2.4.5: as an article
--   of SkyCiv on the same combinations prints them. 2.5.2.1: as a text on ASCE/SEI 7, equation 2.5-1, prints it.
--   2.5.2.2: recalled, not confirmed.
-- ASCE 7-22, 2.4.1: STRUCTURE magazine prints equations 3a, 4a and 6a with 0.7 S, and 1.2 D + 1.0 S. The factors 0.3
--   and 0.15 of S in 2.3 and 0.1 of S in 2.4.5 are recalled, not confirmed. Those of 2.5 are not known here.
local check = require "hinge.library.check"
local columns = require "hinge.library.columns"
local chosen = require "hinge.model.chosen_members"

local where = "hinge.combinations"
local most = 2000 -- combinations of one call

-- Standards -----------------------------------------------------------------------------------------------------------

-- EN 1990, table A1.1: psi_0, psi_1, psi_2.
local imposed = {
  A = { 0.7, 0.5, 0.3 }, B = { 0.7, 0.5, 0.3 }, C = { 0.7, 0.7, 0.6 }, D = { 0.7, 0.7, 0.6 }, E = { 1.0, 0.9, 0.8 },
  F = { 0.7, 0.7, 0.6 }, G = { 0.7, 0.5, 0.3 }, H = { 0, 0, 0 },
}
local much_snow, little_snow = { 0.7, 0.5, 0.2 }, { 0.5, 0.2, 0 } -- above 1000 m or in the north, and elsewhere
local wind, temperature = { 0.6, 0.2, 0 }, { 0.6, 0.5, 0 }

-- ASCE 7: the factor of D, then slots. A slot holds load types of which one acts: "L or 0.5 W" is { L = 1, W = 0.5 }.
-- Loads of a slot may also not act, unless it is `must`. "live": the factor of L that may be 0.5. E: k times rho of the
-- horizontal effect; `Ev`: k of 0.2 S_DS D, which adds to the factor of D.
local function lrfd(roof, lead)
  return {
    { "2.3.1 (1)", D = 1.4 },
    { "2.3.1 (2)", D = 1.2, { must = true, L = 1.6 }, roof },
    { "2.3.1 (3)", D = 1.2, lead, { L = "live", W = 0.5 } },
    { "2.3.1 (4)", D = 1.2, { must = true, W = 1 }, { L = "live" }, roof },
    { "2.3.1 (5)", D = 0.9, { must = true, W = 1 } },
  }
end
local function asd(roof, part)
  return {
    { "2.4.1 (1)", D = 1 },
    { "2.4.1 (2)", D = 1, { must = true, L = 1 } },
    { "2.4.1 (3)", D = 1, roof },
    { "2.4.1 (4)", D = 1, { must = true, L = 0.75 }, part },
    { "2.4.1 (5)", D = 1, { must = true, W = 0.6 } },
    { "2.4.1 (6)", D = 1, { must = true, W = 0.45 }, { L = 0.75 }, part },
    { "2.4.1 (7)", D = 0.6, { must = true, W = 0.6 } },
  }
end
local function seismic_lrfd(S)
  return {
    { "2.3.6 (6)", D = 1.2, Ev = 1, { must = true, E = 1 }, { L = "live" }, { S = S } },
    { "2.3.6 (7)", D = 0.9, Ev = -1, { must = true, E = 1 } },
  }
end
local function seismic_asd(S)
  return {
    { "2.4.5 (8)", D = 1, Ev = 0.7, { must = true, E = 0.7 } },
    { "2.4.5 (9)", D = 1, Ev = 0.525, { must = true, E = 0.525 }, { L = 0.75 }, { S = S } },
    { "2.4.5 (10)", D = 0.6, Ev = -0.7, { must = true, E = 0.7 } },
  }
end
local asce = {
  ["ASCE 7-16"] = {
    LRFD = lrfd({ Lr = 0.5, S = 0.5, R = 0.5 }, { must = true, Lr = 1.6, S = 1.6, R = 1.6 }),
    ASD = asd({ must = true, Lr = 1, S = 1, R = 1 }, { Lr = 0.75, S = 0.75, R = 0.75 }),
    ["seismic LRFD"] = seismic_lrfd(0.2), ["seismic ASD"] = seismic_asd(0.75),
    extraordinary = {
      { "2.5.2.1", D = 0.9, { must = true, A = 1 }, { L = 0.5 }, { S = 0.2 } },
      { "2.5.2.1", D = 1.2, { must = true, A = 1 }, { L = 0.5 }, { S = 0.2 } },
    },
    ["residual capacity"] = {
      { "2.5.2.2", D = 0.9, { L = 0.5 }, { Lr = 0.2, S = 0.2, R = 0.2 } },
      { "2.5.2.2", D = 1.2, { L = 0.5 }, { Lr = 0.2, S = 0.2, R = 0.2 } },
    },
  },
  ["ASCE 7-22"] = {
    LRFD = lrfd({ Lr = 0.5, S = 0.3, R = 0.5 }, { must = true, Lr = 1.6, S = 1, R = 1.6 }),
    ASD = asd({ must = true, Lr = 1, S = 0.7, R = 1 }, { Lr = 0.75, S = 0.525, R = 0.75 }),
    ["seismic LRFD"] = seismic_lrfd(0.15), ["seismic ASD"] = seismic_asd(0.1),
  },
}
local eurocode_kinds = { "ULS", "SLS characteristic", "SLS frequent", "SLS quasi-permanent", "accidental", "seismic" }
local types = {
  ["EN 1990"] = { "G", "Q", "S", "W", "T", "A", "E" },
  ["ASCE 7-16"] = { "D", "L", "Lr", "S", "R", "W", "A", "E" },
  ["ASCE 7-22"] = { "D", "L", "Lr", "S", "R", "W", "A", "E" },
}
local alone = { S = true, W = true, T = true, R = true, A = true, E = true } -- of two such cases one acts at a time

-- Cases ---------------------------------------------------------------------------------------------------------------

local psi_rule = { "numbers", count = 3, at_least = 0, at_most = 1 }

-- psi_0, psi_1 and psi_2 of a variable action.
local function psi_of(what, c)
  if c.psi then return c.psi end
  if c.type == "Q" then return imposed[check.value(what, "category", c.category, { "string",
    one_of = check.keys(imposed) })] end
  if c.type == "W" then return wind end
  if c.type == "T" then return temperature end
  if c.region == "north" then return much_snow end
  check.value(what, "altitude", c.altitude, { "number", unit = "m", at_least = -500, at_most = 5000 })
  return c.altitude > 1000 and much_snow or little_snow
end

-- The fields that a case of a type may have.
local function case_rules(standard, type_of)
  local rules = { alternative = { "string", optional = true } }
  if type_of == "E" then rules.both_signs = { "boolean", default = true } end
  if standard ~= "EN 1990" then return rules end
  if type_of == "G" then rules.source = { "string", default = "one source" } end
  if type_of == "Q" or type_of == "S" or type_of == "W" or type_of == "T" then
    rules.psi, rules.action = { "numbers", count = 3, at_least = 0, at_most = 1, optional = true },
      { "string", optional = true }
  end
  if type_of == "Q" then rules.category = { "string", one_of = check.keys(imposed), optional = true } end
  if type_of == "S" then
    rules.altitude = { "number", unit = "m", at_least = -500, at_most = 5000, optional = true }
    rules.region = { "string", one_of = { "north", "other" }, default = "other" }
  end
  return rules
end

-- One case as { name =, type =, psi =, action =, alternative =, source =, both_signs = }.
local function read_case(standard, name, given)
  local what = ("%s: case '%s'"):format(where, name)
  local fields = {}
  if type(given) == "table" then
    for key, value in pairs(given) do
      if key ~= 1 then fields[key] = value end
    end
    given = given[1]
  end
  if given == nil then
    check.fail("%s: its type is missing; write %s = { \"%s\" } with one of %s", what, name, types[standard][1],
      table.concat(types[standard], ", "))
  end
  check.value(what, "type", given, { "string", one_of = types[standard] })
  local alternative = fields.alternative
  if alternative == false then fields.alternative = nil end
  local c = check.options(what, fields, case_rules(standard, given))
  if c.psi then check.value(what, "psi", c.psi, psi_rule) end
  c.name, c.type, c.alternative = name, given, alternative
  if alternative == nil and alone[given] then c.alternative = "type " .. given end
  if standard == "EN 1990" and (given == "Q" or given == "S" or given == "W" or given == "T") then
    c.psi = psi_of(what, c)
    c.action = c.action or given .. (c.category or "")
  end
  return c
end

-- All cases in a fixed order: by type as in the standard, then by name.
local function read_cases(o)
  local known, place, list = {}, {}, {}
  for i, case in ipairs(o.model:cases()) do known[i] = case.name end
  local is_known = {}
  for _, name in ipairs(known) do is_known[name] = true end
  for i, name in ipairs(types[o.standard]) do place[name] = i end
  for name, given in pairs(o.cases) do
    if type(name) ~= "string" then
      check.fail("%s: field 'cases' has the value %s without a name; write { dead = \"%s\" }", where, check.show(given),
        types[o.standard][1])
    end
    if not is_known[name] then check.unknown(where .. ": field 'cases'", "load case", name, known) end
    list[#list + 1] = read_case(o.standard, name, given)
  end
  table.sort(list, function(a, b)
    if a.type ~= b.type then return place[a.type] < place[b.type] end
    return a.name < b.name
  end)
  if #list == 0 then check.fail("%s: field 'cases' is empty; write { dead = \"%s\" }", where, types[o.standard][1]) end
  return list, known
end

local function of_type(cases, ...)
  local list = {}
  for _, c in ipairs(cases) do
    for i = 1, select("#", ...) do
      if c.type == select(i, ...) then list[#list + 1] = c end
    end
  end
  return list
end

-- Choices -------------------------------------------------------------------------------------------------------------
-- A choice is a list of { case, factor }. A slot is a list of choices. A combination has one choice of each slot.

-- Every set of these cases that can act together, without the empty one.
local function sets_of(cases)
  local sets = { {} }
  for _, c in ipairs(cases) do
    for i = 1, #sets do
      local free = true
      for _, other in ipairs(sets[i]) do free = free and not (c.alternative and c.alternative == other.alternative) end
      if free then
        local more = table.move(sets[i], 1, #sets[i], 1, {})
        more[#more + 1] = c
        sets[#sets + 1] = more
        if #sets > 2 * most then
          check.fail("%s: %d cases of type %s may act in too many sets; put what acts together into one load case",
            where, #cases, c.type)
        end
      end
    end
  end
  table.remove(sets, 1)
  return sets
end

-- The choices of cases that act together or not, each with its factor; `must`: one of them acts.
local function slot_of(cases, factor, must)
  local choices = must and {} or { {} }
  for _, set in ipairs(sets_of(cases)) do
    local choice = {}
    for i, c in ipairs(set) do choice[i] = { c, factor(c) } end
    choices[#choices + 1] = choice
  end
  return choices
end

-- Each earthquake in turn, with both signs, and with a part of the others.
local function earthquakes(cases, factor, orthogonal)
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
local function permanent(cases, factors)
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

local function add_rule(out, rule, permanents, slots)
  local all = table.move(permanents, 1, #permanents, 1, {})
  expand(out, rule, table.move(slots, 1, #slots, #all + 1, all), {}, 1)
end

-- EN 1990 -------------------------------------------------------------------------------------------------------------

-- The variable actions: lists of cases that lead or accompany together.
local function actions_of(cases)
  local actions, named = {}, {}
  for _, c in ipairs(of_type(cases, "Q", "S", "W", "T")) do
    if not named[c.action] then
      named[c.action] = {}
      actions[#actions + 1] = named[c.action]
    end
    table.insert(named[c.action], c)
  end
  return actions
end

-- Combinations with each action as the leading one, and with none. lead(case), other(case): their factors.
local function with_leading(out, rule, permanents, fixed, lead, other)
  add_rule(out, rule, permanents, fixed)
  for i, leading in ipairs(out.actions) do
    local slots = table.move(fixed, 1, #fixed, 1, {})
    slots[#slots + 1] = slot_of(leading, lead, true)
    for k, action in ipairs(out.actions) do
      if k ~= i then slots[#slots + 1] = slot_of(action, other) end
    end
    add_rule(out, rule, permanents, slots)
  end
end

local function with_equal(out, rule, permanents, fixed, factor)
  local slots = table.move(fixed, 1, #fixed, 1, {})
  for _, action in ipairs(out.actions) do slots[#slots + 1] = slot_of(action, factor) end
  add_rule(out, rule, permanents, slots)
end

local function psi(i, factor)
  return function(c) return (factor or 1) * c.psi[i + 1] end
end
local function whole(factor)
  return function() return factor or 1 end
end

local function ultimate(out, o, permanents)
  local sup, inf, Q = o.K_FI * o.gamma_G, o.gamma_G_inf, o.K_FI * o.gamma_Q
  if o.expression == "6.10" then
    return with_leading(out, "EN 1990 (6.10)", permanent(permanents, { sup, inf }), {}, whole(Q), psi(0, Q))
  end
  with_equal(out, "EN 1990 (6.10a)", permanent(permanents, { sup, inf }), {}, psi(0, Q))
  with_leading(out, "EN 1990 (6.10b)", permanent(permanents, { o.xi * sup, inf }), {}, whole(Q), psi(0, Q))
end

local function needs(o, type_of, why)
  check.fail("%s: no case has the type \"%s\"; kind '%s' of %s needs %s", where, type_of, o.kind, o.standard, why)
end

local function eurocode(out, o, cases)
  local permanents, once = of_type(cases, "G"), permanent(of_type(cases, "G"), { 1 })
  out.actions = actions_of(cases)
  local kinds = {
    ULS = function() ultimate(out, o, permanents) end,
    ["SLS characteristic"] = function() with_leading(out, "EN 1990 (6.14b)", once, {}, whole(), psi(0)) end,
    ["SLS frequent"] = function() with_leading(out, "EN 1990 (6.15b)", once, {}, psi(1), psi(2)) end,
    ["SLS quasi-permanent"] = function() with_equal(out, "EN 1990 (6.16b)", once, {}, psi(2)) end,
    accidental = function()
      local accidents = of_type(cases, "A")
      local fixed = #accidents > 0 and { slot_of(accidents, whole(), true) } or {}
      if o.leading == "psi_2" then return with_equal(out, "EN 1990 (6.11b)", once, fixed, psi(2)) end
      with_leading(out, "EN 1990 (6.11b)", once, fixed, psi(1), psi(2))
    end,
    seismic = function()
      local quakes = of_type(cases, "E")
      if #quakes == 0 then needs(o, "E", "an earthquake") end
      with_equal(out, "EN 1990 (6.12b)", once, { earthquakes(quakes, 1, o.orthogonal) }, psi(2))
    end,
  }
  kinds[o.kind]()
end

-- ASCE 7 --------------------------------------------------------------------------------------------------------------

-- The choices of a slot { L = 1, W = 0.5 }: cases of one of its types, or none.
local function asce_slot(o, cases, slot)
  if slot.E then return earthquakes(of_type(cases, "E"), slot.E * o.rho, o.orthogonal) end
  local choices = slot.must and {} or { {} }
  for _, name in ipairs(types[o.standard]) do
    local factor = slot[name]
    if factor == "live" then factor = o.live end
    local more = factor and slot_of(of_type(cases, name), whole(factor), true) or {}
    table.move(more, 1, #more, #choices + 1, choices)
  end
  return choices
end

local function american(out, o, cases)
  if o.kind:find "seismic" and #of_type(cases, "E") == 0 then needs(o, "E", "an earthquake") end
  if o.kind == "extraordinary" and #of_type(cases, "A") == 0 then
    needs(o, "A", "the load of the event; after the event it is kind 'residual capacity'")
  end
  for _, rule in ipairs(asce[o.standard][o.kind]) do
    local slots = {}
    for i, slot in ipairs(rule) do
      if i > 1 then slots[i - 1] = asce_slot(o, cases, slot) end
    end
    local dead = rule.D + (rule.Ev and 0.2 * o.S_DS * rule.Ev or 0)
    add_rule(out, o.standard .. " " .. rule[1], permanent(of_type(cases, "D"), { dead }), slots)
  end
end

-- Options -------------------------------------------------------------------------------------------------------------

local function factor_rule(default) return { "number", above = 0, at_most = 3, default = default } end
local common = { model = { "userdata" }, standard = { "string", one_of = { "EN 1990", "ASCE 7-16", "ASCE 7-22" } },
  kind = { "string" }, cases = { "table" }, omit = { "boolean", default = true } }
local only_eurocode = {
  expression = { "string", one_of = { "6.10", "6.10a/b" }, default = "6.10" }, gamma_G = factor_rule(1.35),
  gamma_G_inf = factor_rule(1), gamma_Q = factor_rule(1.5), xi = { "number", above = 0, at_most = 1, default = 0.85 },
  K_FI = { "number", at_least = 0.5, at_most = 1.5, default = 1 },
  leading = { "string", one_of = { "psi_1", "psi_2" }, default = "psi_1" },
}
local orthogonal = { "number", above = 0, at_most = 1, optional = true }

-- The fields that a standard and a kind have.
local function rules_of(standard, kind)
  local rules = {}
  for name, rule in pairs(common) do rules[name] = rule end
  local eurocodes = { ULS = { "expression", "gamma_G", "gamma_G_inf", "gamma_Q", "xi", "K_FI" },
    accidental = { "leading" } }
  if standard == "EN 1990" then
    for _, name in ipairs(eurocodes[kind] or {}) do rules[name] = only_eurocode[name] end
  elseif kind == "LRFD" or kind == "seismic LRFD" then
    rules.live = { "number", at_least = 0.5, at_most = 1, default = 1 }
  end
  if kind:find "seismic" then
    rules.orthogonal = orthogonal
    if standard ~= "EN 1990" then
      rules.S_DS = { "number", unit = "g", above = 0, at_most = 5 }
      rules.rho = { "number", at_least = 1, at_most = 1.3 }
    end
  end
  return rules
end

local function read_options(given)
  if type(given) ~= "table" then
    check.fail("%s: takes a table of options, got %s", where, check.show(given))
  end
  chosen.model(where, given.model)
  local standard = check.value(where, "standard", given.standard, common.standard)
  if standard == "ASCE 7-22" and (given.kind == "extraordinary" or given.kind == "residual capacity") then
    check.fail("%s: kind '%s' is not there for ASCE 7-22, whose factors of snow in section 2.5 are not confirmed; "
      .. "declare these combinations by model:combination", where, given.kind)
  end
  local kinds = standard == "EN 1990" and eurocode_kinds or check.keys(asce[standard])
  local kind = check.value(where, "kind", given.kind, { "string", one_of = kinds })
  local o = check.options(where, given, rules_of(standard, kind))
  o.kind = kind
  return o
end

-- Names and the list --------------------------------------------------------------------------------------------------

local function factor_text(x)
  local text = ("%.10g"):format(x)
  return text:find "[.e]" and text or text .. ".0"
end

-- "ULS 1.35 G + 1.5 office": permanent cases that share a factor are written as one.
local function name_of(o, cases, factors)
  local first = types[o.standard][1]
  local permanents, shared = of_type(cases, first), true
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

-- Without those whose loads are a part of the loads of another one with the same factors.
local function without_parts(list)
  local kept = {}
  for i, a in ipairs(list) do
    local is_part = false
    for k, b in ipairs(list) do
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
local List = { __name = "hinge.combination_list", __index = methods }

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
List.__tostring = methods.table

-- The names of the cases that are in the combinations, in the order of `cases`, and of those that are in none.
local function used_and_not(rows, cases, known)
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

-- What has been declared in each model, so that a second call can use it again.
local declared = setmetatable({}, { __mode = "k" })

local function declare(model, list)
  local there = declared[model] or {}
  declared[model] = there
  for _, row in ipairs(list) do
    local known = there[row.name]
    if known and known ~= row.text then
      check.fail("%s: the combination '%s' is there already, with other factors: %s; here %s", where, row.name, known,
        row.text)
    end
  end
  for _, row in ipairs(list) do
    if not there[row.name] then model:combination(row.name, row.factors) end
    there[row.name] = row.text
  end
end

local function text_of(factors)
  local parts = {}
  for _, name in ipairs(check.keys(factors)) do parts[#parts + 1] = ("%s = %.12g"):format(name, factors[name]) end
  return table.concat(parts, ", ")
end

--- hinge.combinations: see words/actions.d.lua.
return function(options, ...)
  check.no_more(where, ...)
  local o = read_options(options)
  local cases, known = read_cases(o)
  local out = { list = {}, seen = {}, cases = cases }
  if o.standard == "EN 1990" then eurocode(out, o, cases) else american(out, o, cases) end
  local rows = o.omit and out.list or without_parts(out.list)
  if #rows == 0 then
    check.fail("%s: %s, kind '%s', makes no combination of these cases", where, o.standard, o.kind)
  end
  local list = { standard = o.standard, kind = o.kind }
  list.cases, list.left_out = used_and_not(rows, cases, known)
  for i, row in ipairs(rows) do
    list[i] = { name = name_of(o, cases, row.factors), factors = row.factors, rule = row.rule }
  end
  local texts = {}
  for i, row in ipairs(list) do texts[i] = { name = row.name, factors = row.factors, text = text_of(row.factors) } end
  declare(o.model, texts)
  return setmetatable(list, List)
end
