-- hinge.combinations: the load combinations of EN 1990 and of ASCE 7, declared in a model. Their factors, with the
-- sources, are in standards/en_1990/combinations.lua and standards/asce_7/combinations.lua.
local check = require "hinge.library.check"
local lists = require "hinge.actions.combination_list"
local chosen = require "hinge.model.chosen_members"
local asce_7 = require "hinge.standards.asce_7.combinations"
local en_1990 = require "hinge.standards.en_1990.combinations"

local where = "hinge.combinations"
local types = { ["EN 1990"] = en_1990.types, ["ASCE 7-16"] = asce_7.types, ["ASCE 7-22"] = asce_7.types }
local alone = { S = true, W = true, T = true, R = true, A = true, E = true } -- of two such cases one acts at a time

-- Cases ---------------------------------------------------------------------------------------------------------------

local psi_rule = { "numbers", count = 3, at_least = 0, at_most = 1, optional = true }

-- The fields that a case of a type may have.
local function case_rules(standard, type_of)
  local rules = { alternative = { "string", optional = true } }
  if type_of == "E" then rules.both_signs = { "boolean", default = true } end
  if standard ~= "EN 1990" then return rules end
  if type_of == "G" then rules.source = { "string", default = "one source" } end
  if type_of == "Q" or type_of == "S" or type_of == "W" or type_of == "T" then
    rules.psi, rules.action = psi_rule, { "string", optional = true }
  end
  if type_of == "Q" then rules.category = { "string", one_of = en_1990.categories, optional = true } end
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
  c.name, c.type, c.alternative = name, given, alternative
  if alternative == nil and alone[given] then c.alternative = "type " .. given end
  if standard == "EN 1990" and (given == "Q" or given == "S" or given == "W" or given == "T") then
    c.psi = en_1990.psi(what, c)
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
  local kinds = standard == "EN 1990" and en_1990.kinds or check.keys(asce_7.rules[standard])
  local kind = check.value(where, "kind", given.kind, { "string", one_of = kinds })
  local o = check.options(where, given, rules_of(standard, kind))
  o.kind = kind
  return o
end

-- Declaring -----------------------------------------------------------------------------------------------------------

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
  o.first_type = types[o.standard][1]
  local out = { list = {}, seen = {}, cases = cases }
  (o.standard == "EN 1990" and en_1990 or asce_7).combine(out, o, cases)
  local rows = o.omit and out.list or lists.without_parts(out.list)
  if #rows == 0 then
    check.fail("%s: %s, kind '%s', makes no combination of these cases", where, o.standard, o.kind)
  end
  local list = { standard = o.standard, kind = o.kind }
  list.cases, list.left_out = lists.used_and_not(rows, cases, known)
  for i, row in ipairs(rows) do
    list[i] = { name = lists.name_of(o, cases, row.factors), factors = row.factors, rule = row.rule }
  end
  local texts = {}
  for i, row in ipairs(list) do texts[i] = { name = row.name, factors = row.factors, text = text_of(row.factors) } end
  declare(o.model, texts)
  return setmetatable(list, lists.class)
end
