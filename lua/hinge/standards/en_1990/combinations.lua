-- The combinations of EN 1990, for hinge.combinations.
--
-- Sources. The original standard was not at hand.
-- Table A1.1 (psi): as the program XC has it (xcfem/xc, ec0_buildings_combination_factors_es.py), which agrees with a
--   second program (desssign) in categories A to E.
-- gamma_G 1.35 and 1.0, gamma_Q 1.5, xi 0.85 (table A1.2(B), recommended values): recalled, and used by many programs.
local check = require "hinge.library.check"
local sets = require "hinge.actions.combination_sets"

local en_1990 = {}

en_1990.types = { "G", "Q", "S", "W", "T", "A", "E" }
en_1990.kinds = { "ULS", "SLS characteristic", "SLS frequent", "SLS quasi-permanent", "accidental", "seismic" }

-- Table A1.1: psi_0, psi_1, psi_2.
local imposed = {
  A = { 0.7, 0.5, 0.3 }, B = { 0.7, 0.5, 0.3 }, C = { 0.7, 0.7, 0.6 }, D = { 0.7, 0.7, 0.6 }, E = { 1.0, 0.9, 0.8 },
  F = { 0.7, 0.7, 0.6 }, G = { 0.7, 0.5, 0.3 }, H = { 0, 0, 0 },
}
local much_snow, little_snow = { 0.7, 0.5, 0.2 }, { 0.5, 0.2, 0 } -- above 1000 m or in the north, and elsewhere
local wind, temperature = { 0.6, 0.2, 0 }, { 0.6, 0.5, 0 }

en_1990.categories = check.keys(imposed)

--- psi_0, psi_1 and psi_2 of a variable action.
function en_1990.psi(what, c)
  if c.psi then return c.psi end
  if c.type == "Q" then return imposed[check.value(what, "category", c.category, { "string",
    one_of = en_1990.categories })] end
  if c.type == "W" then return wind end
  if c.type == "T" then return temperature end
  if c.region == "north" then return much_snow end
  check.value(what, "altitude", c.altitude, { "number", unit = "m", at_least = -500, at_most = 5000 })
  return c.altitude > 1000 and much_snow or little_snow
end

-- The variable actions: lists of cases that lead or accompany together.
local function actions_of(cases)
  local actions, named = {}, {}
  for _, c in ipairs(sets.of_type(cases, "Q", "S", "W", "T")) do
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
  sets.add_rule(out, rule, permanents, fixed)
  for i, leading in ipairs(out.actions) do
    local slots = table.move(fixed, 1, #fixed, 1, {})
    slots[#slots + 1] = sets.slot_of(leading, lead, true)
    for k, action in ipairs(out.actions) do
      if k ~= i then slots[#slots + 1] = sets.slot_of(action, other) end
    end
    sets.add_rule(out, rule, permanents, slots)
  end
end

local function with_equal(out, rule, permanents, fixed, factor)
  local slots = table.move(fixed, 1, #fixed, 1, {})
  for _, action in ipairs(out.actions) do slots[#slots + 1] = sets.slot_of(action, factor) end
  sets.add_rule(out, rule, permanents, slots)
end

local function psi(i, factor)
  return function(c) return (factor or 1) * c.psi[i + 1] end
end
local function ultimate(out, o, permanents)
  local sup, inf, Q = o.K_FI * o.gamma_G, o.gamma_G_inf, o.K_FI * o.gamma_Q
  if o.expression == "6.10" then
    return with_leading(out, "EN 1990 (6.10)", sets.permanent(permanents, { sup, inf }), {}, sets.whole(Q), psi(0, Q))
  end
  with_equal(out, "EN 1990 (6.10a)", sets.permanent(permanents, { sup, inf }), {}, psi(0, Q))
  with_leading(out, "EN 1990 (6.10b)", sets.permanent(permanents, { o.xi * sup, inf }), {}, sets.whole(Q), psi(0, Q))
end

--- Adds the combinations of the kind o.kind to out.list.
function en_1990.combine(out, o, cases)
  local permanents, once = sets.of_type(cases, "G"), sets.permanent(sets.of_type(cases, "G"), { 1 })
  out.actions = actions_of(cases)
  local kinds = {
    ULS = function() ultimate(out, o, permanents) end,
    ["SLS characteristic"] = function() with_leading(out, "EN 1990 (6.14b)", once, {}, sets.whole(), psi(0)) end,
    ["SLS frequent"] = function() with_leading(out, "EN 1990 (6.15b)", once, {}, psi(1), psi(2)) end,
    ["SLS quasi-permanent"] = function() with_equal(out, "EN 1990 (6.16b)", once, {}, psi(2)) end,
    accidental = function()
      local accidents = sets.of_type(cases, "A")
      local fixed = #accidents > 0 and { sets.slot_of(accidents, sets.whole(), true) } or {}
      if o.leading == "psi_2" then return with_equal(out, "EN 1990 (6.11b)", once, fixed, psi(2)) end
      with_leading(out, "EN 1990 (6.11b)", once, fixed, psi(1), psi(2))
    end,
    seismic = function()
      local quakes = sets.of_type(cases, "E")
      if #quakes == 0 then sets.needs(o, "E", "an earthquake") end
      with_equal(out, "EN 1990 (6.12b)", once, { sets.earthquakes(quakes, 1, o.orthogonal) }, psi(2))
    end,
  }
  kinds[o.kind]()
end

return en_1990
