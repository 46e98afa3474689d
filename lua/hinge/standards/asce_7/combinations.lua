-- The combinations of ASCE 7-16 and ASCE 7-22, for hinge.combinations.
--
-- Sources. The original standard was not at hand.
-- ASCE 7-16, 2.3.1 and 2.3.6: as a manual prints them (ideCAD, help page on ASCE 7-16). 2.4.1 and 2.4.5: as an article
--   of SkyCiv on the same combinations prints them. 2.5.2.1: as a text on ASCE/SEI 7, equation 2.5-1, prints it.
--   2.5.2.2: recalled, not confirmed.
-- ASCE 7-22, 2.4.1: STRUCTURE magazine prints equations 3a, 4a and 6a with 0.7 S, and 1.2 D + 1.0 S. The factors 0.3
--   and 0.15 of S in 2.3 and 0.1 of S in 2.4.5 are recalled, not confirmed. Those of 2.5 are not known here.
local sets = require "hinge.actions.combination_sets"

local asce_7 = {}

asce_7.types = { "D", "L", "Lr", "S", "R", "W", "A", "E" }

-- The factor of D, then slots. A slot holds load types of which one acts: "L or 0.5 W" is { L = 1, W = 0.5 }.
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
--- The rules by standard and kind.
asce_7.rules = {
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

-- The choices of a slot { L = 1, W = 0.5 }: cases of one of its types, or none.
local function asce_slot(o, cases, slot)
  if slot.E then return sets.earthquakes(sets.of_type(cases, "E"), slot.E * o.rho, o.orthogonal) end
  local choices = slot.must and {} or { {} }
  for _, name in ipairs(asce_7.types) do
    local factor = slot[name]
    if factor == "live" then factor = o.live end
    local more = factor and sets.slot_of(sets.of_type(cases, name), sets.whole(factor), true) or {}
    table.move(more, 1, #more, #choices + 1, choices)
  end
  return choices
end

--- Adds the combinations of the kind o.kind to out.list.
function asce_7.combine(out, o, cases)
  if o.kind:find "seismic" and #sets.of_type(cases, "E") == 0 then sets.needs(o, "E", "an earthquake") end
  if o.kind == "extraordinary" and #sets.of_type(cases, "A") == 0 then
    sets.needs(o, "A", "the load of the event; after the event it is kind 'residual capacity'")
  end
  for _, rule in ipairs(asce_7.rules[o.standard][o.kind]) do
    local slots = {}
    for i, slot in ipairs(rule) do
      if i > 1 then slots[i - 1] = asce_slot(o, cases, slot) end
    end
    local dead = rule.D + (rule.Ev and 0.2 * o.S_DS * rule.Ev or 0)
    sets.add_rule(out, o.standard .. " " .. rule[1], sets.permanent(sets.of_type(cases, "D"), { dead }), slots)
  end
end

return asce_7
