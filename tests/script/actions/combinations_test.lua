-- Load combinations: the factors of table A1.1 of EN 1990 and of ASCE 7 by hand; the largest and the smallest effect of
-- all combinations against formulas that take each load where it is unfavourable; names, duplicates, runs; wrong input
-- is refused.
--
-- Run: lua5.4 tests/script/actions/combinations_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local scenes = require "scenes"
local hinge = require "hinge"
local combinations = require "hinge.actions.combinations"
local checks = support.checks "combinations"
local case, near, equal, expect = checks.case, checks.near, checks.equal, checks.expect

-- A model with load cases of these names.
local function model_with(...)
  local model = hinge.model()
  for _, name in ipairs { ... } do model:case(name) end
  return model
end

-- Factors as a text in the order of the names.
local function text_of(factors, names)
  local parts = {}
  for i, name in ipairs(names) do parts[i] = ("%.6g"):format(factors[name] or 0) end
  return table.concat(parts, " ")
end

-- The combinations are these, in any order; each is a text of the factors in the order of the names.
local function are(list, names, wanted, what)
  local left = {}
  for _, text in ipairs(wanted) do left[text] = true end
  for _, row in ipairs(list) do
    local text = text_of(row.factors, names)
    expect(left[text], "%s: '%s' is not wanted, or there twice", what, text)
    left[text] = nil
  end
  for text in pairs(left) do expect(false, "%s: '%s' is missing", what, text) end
  equal(#list, #wanted, what .. ": number")
end

local four = { "dead", "office", "snow", "wind" }
local european = { dead = "G", office = { "Q", category = "B" }, snow = { "S", altitude = 500 }, wind = "W" }

-- The combinations of cases with these names; `full`: without those that leave out a load.
local function of(names, standard, kind, cases, more)
  return combinations(scenes.with({ model = model_with(table.unpack(names)), standard = standard, kind = kind,
    cases = cases }, more))
end
local function full(standard, kind, cases, more, names)
  return of(names or four, standard, kind, cases, scenes.with({ omit = false }, more))
end

-- By hand, with psi 0.7 0.5 0.3 (office), 0.5 0.2 0 (snow) and 0.6 0.2 0 (wind).
case("EN 1990, each kind by hand", function()
  local by_hand = {
    ULS = { "1.35 1.5 0.75 0.9", "1.35 1.05 1.5 0.9", "1.35 1.05 0.75 1.5", "1 1.5 0.75 0.9", "1 1.05 1.5 0.9",
      "1 1.05 0.75 1.5" },
    ["SLS characteristic"] = { "1 1 0.5 0.6", "1 0.7 1 0.6", "1 0.7 0.5 1" },
    ["SLS frequent"] = { "1 0.5 0 0", "1 0.3 0.2 0", "1 0.3 0 0.2" },
    ["SLS quasi-permanent"] = { "1 0.3 0 0" },
    accidental = { "1 0.5 0 0", "1 0.3 0.2 0", "1 0.3 0 0.2" },
  }
  for kind, wanted in pairs(by_hand) do are(full("EN 1990", kind, european), four, wanted, kind) end
  are(full("EN 1990", "accidental", european, { leading = "psi_2" }), four, { "1 0.3 0 0" }, "the leading by psi_2")
  are(full("EN 1990", "ULS", european, { expression = "6.10a/b" }), four, { "1.35 1.05 0.75 0.9", "1 1.05 0.75 0.9",
    "1.1475 1.5 0.75 0.9", "1.1475 1.05 1.5 0.9", "1.1475 1.05 0.75 1.5", "1 1.5 0.75 0.9", "1 1.05 1.5 0.9",
    "1 1.05 0.75 1.5" }, "6.10a and 6.10b")
  local national = { gamma_G = 1.2, gamma_G_inf = 0.9, gamma_Q = 1.4, K_FI = 1.1 }
  are(full("EN 1990", "ULS", { dead = "G", wind = "W" }, national), { "dead", "wind" }, { "1.32 1.54", "0.9 1.54" },
    "national factors")
end)

case("table A1.1: psi of each action", function()
  local rows = { A = "0.7 0.5 0.3", B = "0.7 0.5 0.3", C = "0.7 0.7 0.6", D = "0.7 0.7 0.6", E = "1 0.9 0.8",
    F = "0.7 0.7 0.6", G = "0.7 0.5 0.3", H = "0 0 0" }
  local actions = { { { "W" }, "0.6 0.2 0" }, { { "T" }, "0.6 0.5 0" }, { { "S", altitude = 1000 }, "0.5 0.2 0" },
    { { "S", altitude = 1001 }, "0.7 0.5 0.2" }, { { "S", region = "north" }, "0.7 0.5 0.2" },
    { { "Q", category = "A", psi = { 0.4, 0.3, 0.1 } }, "0.4 0.3 0.1" } }
  for category, psi in pairs(rows) do actions[#actions + 1] = { { "Q", category = category }, psi } end
  for _, action in ipairs(actions) do
    local found = {}
    for i, kind in ipairs { "SLS characteristic", "SLS frequent", "SLS quasi-permanent" } do
      -- psi_0 is the factor while another action leads
      local list = of({ "dead", "it", "other" }, "EN 1990", kind, { dead = "G", it = action[1],
        other = i == 1 and { "Q", psi = { 0.9, 0, 0 }, action = "other" } or nil })
      found[i] = 0
      for _, row in ipairs(list) do
        if i > 1 or row.factors.other == 1 then found[i] = support.largest_of(found[i], row.factors.it or 0) end
      end
    end
    equal(("%g %g %g"):format(table.unpack(found)), action[2], tostring(action[1][1]) .. (action[1].category or ""))
  end
  local names = { "stores", "wind" }
  are(of(names, "EN 1990", "ULS", { stores = { "Q", category = "E" }, wind = "W" }), names,
    { "1.5 0", "1.5 0.9", "0 1.5", "1.5 1.5" }, "psi_0 = 1 of stores")
end)

case("ASCE 7, each kind by hand", function()
  -- of roof live load, snow and rain one acts at a time, each with factors of its own
  local old, new = { 0.5, 1.6, 1, 0.75 }, { 0.3, 1, 0.7, 0.525 }
  for standard, factors in pairs { ["ASCE 7-16"] = { S = old, Lr = old, R = old },
    ["ASCE 7-22"] = { S = new, Lr = old, R = old } } do
    for kind, f in pairs(factors) do
      local cases = { dead = "D", office = "L", snow = kind, wind = "W" }
      local function texts(...)
        local list = { ... }
        for i, text in ipairs(list) do
          list[i] = text:gsub("%l", function(letter) return ("%g"):format(f[letter:byte() - 96]) end)
        end
        return list
      end
      are(full(standard, "LRFD", cases), four, texts("1.4 0 0 0", "1.2 1.6 a 0", "1.2 1 b 0", "1.2 0 b 0.5",
        "1.2 1 a 1", "0.9 0 0 1"), standard .. ", LRFD, " .. kind)
      are(full(standard, "ASD", cases), four, texts("1 0 0 0", "1 1 0 0", "1 0 c 0", "1 0.75 d 0", "1 0 0 0.6",
        "1 0.75 d 0.45", "0.6 0 0 0.6"), standard .. ", ASD, " .. kind)
      if standard == "ASCE 7-16" then
        are(full(standard, "residual capacity", cases), four, { "0.9 0.5 0.2 0", "1.2 0.5 0.2 0" },
          "residual, " .. kind)
      end
    end
  end
  local names = { "dead", "live", "roof", "rain" }
  are(full("ASCE 7-16", "LRFD", { dead = "D", live = "L", roof = "Lr", rain = "R" }, { live = 0.5 }, names), names,
    { "1.4 0 0 0", "1.2 1.6 0.5 0", "1.2 1.6 0 0.5", "1.2 0.5 1.6 0", "1.2 0.5 0 1.6" },
    "Lr or R, and 0.5 L in combination 3")
  names = { "dead", "live", "crash" }
  are(full("ASCE 7-16", "extraordinary", { dead = "D", live = "L", crash = "A" }, nil, names), names,
    { "0.9 0.5 1", "1.2 0.5 1" }, "an extraordinary event")
  names = { "dead", "live", "snow", "crash" }
  are(full("ASCE 7-16", "extraordinary", { dead = "D", live = "L", snow = "S", crash = "A" }, nil, names), names,
    { "0.9 0.5 0.2 1", "1.2 0.5 0.2 1" }, "an extraordinary event in snow")
end)

case("earthquakes: both signs, a part of the other direction, the vertical part in the dead load", function()
  local names = { "dead", "live", "snow", "x", "y" }
  local function quake(standard, kind, more) return full(standard, kind, more.cases, more, names) end
  local european_quake = { dead = "G", live = { "Q", category = "B" }, x = "E", y = "E" }
  are(quake("EN 1990", "seismic", { cases = european_quake }), names, { "1 0.3 0 1 0", "1 0.3 0 -1 0", "1 0.3 0 0 1",
    "1 0.3 0 0 -1" }, "EN 1990")
  are(quake("EN 1990", "seismic", { cases = { dead = "G", x = { "E", both_signs = false }, y = "E" },
    orthogonal = 0.3 }), names, { "1 0 0 1 0.3", "1 0 0 1 -0.3", "1 0 0 0.3 1", "1 0 0 0.3 -1" }, "100 % and 30 %")
  local us = { cases = { dead = "D", live = "L", snow = "S", x = { "E", both_signs = false } }, S_DS = 0.5, rho = 1.3 }
  are(quake("ASCE 7-16", "seismic LRFD", us), names, { "1.3 1 0.2 1.3 0", "0.8 0 0 1.3 0" }, "LRFD of 2016")
  are(quake("ASCE 7-22", "seismic LRFD", us), names, { "1.3 1 0.15 1.3 0", "0.8 0 0 1.3 0" }, "LRFD of 2022")
  are(quake("ASCE 7-16", "seismic ASD", us), names, { "1.07 0 0 0.91 0", "1.0525 0.75 0.75 0.6825 0",
    "0.53 0 0 0.91 0" }, "ASD of 2016")
  are(quake("ASCE 7-22", "seismic ASD", us), names, { "1.07 0 0 0.91 0", "1.0525 0.75 0.1 0.6825 0",
    "0.53 0 0 0.91 0" }, "ASD of 2022")
end)

-- Effects of the cases of a model, pseudo-random: the minimal standard generator of Park and Miller.
local seed = 12345
local function random()
  seed = seed * 16807 % 2147483647
  return 2 * seed / 2147483647 - 1
end
local function extremes(list, effects)
  local largest, smallest
  for _, row in ipairs(list) do
    local sum = 0
    for name, factor in pairs(row.factors) do sum = sum + factor * effects[name] end
    largest = largest and support.largest_of(largest, sum) or sum
    smallest = smallest and support.smallest_of(smallest, sum) or sum
  end
  return largest, smallest
end
local function positive(x) return x > 0 and x or 0 end

-- The largest effect of 6.10: the worst leading action, each other action where it is unfavourable; of two directions
-- of wind one acts.
local function largest_of_610(e)
  local permanent = support.largest_of(1.35 * (e.dead + e.walls), e.dead + e.walls)
  local blows = support.largest_of(positive(e.wind), positive(e.gale))
  local terms = { 1.5 * positive(e.office), 1.5 * positive(e.snow), 1.5 * blows }
  local psi_0, best = { 0.7, 0.5, 0.6 }, permanent
  for lead = 1, 3 do
    local sum = permanent
    for i = 1, 3 do sum = sum + (i == lead and 1 or psi_0[i]) * terms[i] end
    best = support.largest_of(best, sum)
  end
  return best
end

case("EN 1990 (6.10) misses no extreme effect, for loads that act either way", function()
  local names = { "dead", "walls", "office", "snow", "wind", "gale" }
  local list = of(names, "EN 1990", "ULS", { dead = "G", walls = "G", office = { "Q", category = "B" },
    snow = { "S", altitude = 200 }, wind = "W", gale = "W" })
  for _ = 1, 200 do
    local effects, negative = {}, {}
    for _, name in ipairs(names) do
      effects[name] = random()
      negative[name] = -effects[name]
    end
    local largest, smallest = extremes(list, effects)
    near(largest, largest_of_610(effects), 1e-12, "the largest effect")
    near(smallest, -largest_of_610(negative), 1e-12, "the smallest effect")
  end
end)

case("sources of permanent actions have factors of their own", function()
  local names = { "dead", "soil", "crane" }
  are(of(names, "EN 1990", "ULS", { dead = "G", crane = { "G", source = "crane" }, soil = "G" }), names,
    { "1.35 1.35 1.35", "1.35 1.35 1", "1 1 1.35", "1 1 1" }, "two sources")
end)

case("parts of one action lead together, alternatives never act together", function()
  local B, roof = { "Q", category = "B" }, { "roof", "snow", "wind" }
  are(of({ "left", "right" }, "EN 1990", "ULS", { left = B, right = B }), { "left", "right" },
    { "1.5 0", "0 1.5", "1.5 1.5" }, "two spans of one action")
  are(full("EN 1990", "ULS", { office = B, snow = { "Q", category = "B", action = "another" } }),
    { "office", "snow" }, { "1.5 1.05", "1.05 1.5" }, "two actions of one category")
  are(of({ "wind", "gale" }, "EN 1990", "ULS", { wind = "W", gale = "W" }), { "wind", "gale" }, { "1.5 0", "0 1.5" },
    "two directions of wind")
  local both = { "W", alternative = false }
  are(full("EN 1990", "ULS", { snow = both, wind = both }), { "snow", "wind" }, { "1.5 1.5" },
    "pressure and suction together")
  are(full("EN 1990", "ULS", { roof = { "Q", category = "H", alternative = "roof" }, wind = "W",
    snow = { "S", altitude = 0, alternative = "roof" } }, nil, roof), roof,
    { "1.5 0 0.9", "0 1.5 0.9", "0 0.75 1.5" }, "never both on the roof")
end)

case("a run takes a combination by its name", function()
  local model, head, _, foot = scenes.cantilever { model = { displacement = "small" }, along = { 0, 0, 1 } }
  model:case("dead"):load { node = head, force = { 0, 0, -1e3 } }
  model:case("wind"):load { node = head, force = { 1e3, 0, 0 } }
  local list = combinations { model = model, standard = "EN 1990", kind = "ULS", cases = { dead = "G", wind = "W" } }
  local names, seen = {}, {}
  for i, row in ipairs(list) do
    names[i] = row.name
    expect(not seen[row.name], "%s is there twice", row.name)
    seen[row.name] = true
    local fx, _, fz = model:static { steps = 1, loads = row.name }:finish():reaction(foot)
    near(fx, -1e3 * (row.factors.wind or 0), 1e-6, row.name .. ": along x")
    near(fz, 1e3 * (row.factors.dead or 0), 1e-6, row.name .. ": upwards")
    equal(row.rule, "EN 1990 (6.10)", "rule")
  end
  equal(table.concat(names, "; "), "ULS 1.35 dead; ULS 1.0 dead; ULS 1.35 dead + 1.5 wind; ULS 1.0 dead + 1.5 wind",
    "names")
end)

case("names, the table, and a second call", function()
  local model = model_with("dead", "services", "office", "quake", "push")
  local options = { model = model, standard = "EN 1990", kind = "ULS", omit = false,
    cases = { dead = "G", services = "G", office = { "Q", category = "B" } } }
  local list = combinations(options)
  equal(list[1].name, "ULS 1.35 G + 1.5 office", "permanent cases with one factor")
  checks.prints(tostring(list), [[
EN 1990, ULS: 2 combinations
rule            dead  services  office
EN 1990 (6.10)  1.35      1.35     1.5
EN 1990 (6.10)     1         1     1.5
load cases of the model in none of them: quake, push]], "the table")
  equal(list:table(), tostring(list), "list:table()")
  equal(#combinations(options), 2, "the same call again")
  local quake = combinations { model = model, standard = "EN 1990", kind = "seismic", cases = { dead = "G",
    quake = "E" } }
  equal(quake[2].name, "seismic 1.0 dead - 1.0 quake", "a negative factor")
end)

case("an accident acts in full beside others, and bounds of options hold", function()
  -- EN 1990 (6.11b): G + A + psi_1 Q_1 + psi_2 Q_i; the accident is in each of them
  local cases = { dead = "G", office = european.office, blow = "A", wind = "W" }
  local names = { "dead", "office", "wind", "blow" }
  are(full("EN 1990", "accidental", cases, nil, names), names, { "1 0.5 0 1", "1 0.3 0.2 1" }, "accidental")
  are(full("EN 1990", "accidental", cases, { leading = "psi_2" }, names), names, { "1 0.3 0 1" }, "with psi_2 for all")
  -- what is left out by `omit` is a part of another combination with the same factors, and no other
  are(of({ "dead" }, "EN 1990", "SLS characteristic", { dead = "G" }), { "dead" }, { "1" }, "one permanent action")
  -- snow: psi by the altitude, up to 1000 m and above
  local function snow(altitude)
    return full("EN 1990", "SLS frequent", { dead = "G", snow = { "S", altitude = altitude } })
  end
  are(snow(1000), { "dead", "snow" }, { "1 0.2" }, "1000 m")
  are(snow(1001), { "dead", "snow" }, { "1 0.5" }, "1001 m")
  for altitude, good in pairs { [-500] = true, [-501] = false, [5000] = true, [5001] = false } do
    equal(pcall(snow, altitude), good, altitude .. " m")
  end
  -- cases of one type in the order of their names, and of types in that of the standard
  local told = tostring(of({ "zinc", "alu", "wind", "crane" }, "EN 1990", "ULS", { zinc = "G", alu = "G", wind = "W" }))
  expect(told:find("alu.*zinc.*wind"), "order: %s", told)
  expect(told:find("load cases of the model in none of them: crane", 1, true), "what is left out: %s", told)
end)

case("wrong input is refused", function()
  local model = model_with("dead", "office", "snow", "wind")
  local function with(more)
    return scenes.with({ model = model, standard = "EN 1990", kind = "ULS", cases = { dead = "G" } }, more)
  end
  for words, options in pairs {
    ["takes a table of options, got 3"] = 3,
    ["field 'model' is missing"] = {},
    ["field 'standard' is 'EN 1991'; must be one of EN 1990, ASCE 7-16"] = with { standard = "EN 1991" },
    ["field 'kind' is 'LRFD'; must be one of ULS, SLS characteristic"] = with { kind = "LRFD" },
    ["field 'cases' is empty"] = with { cases = {} },
    ["unknown load case 'ded' (did you mean 'dead'?)"] = with { cases = { ded = "G" } },
    ["case 'dead': field 'type' is 'D'; must be one of G, Q, S"] = with { cases = { dead = "D" } },
    ["case 'dead': its type is missing"] = with { cases = { dead = {} } },
    ["case 'dead': unknown field 'psi'"] = with { cases = { dead = { "G", psi = { 1, 1, 1 } } } },
    ["case 'office': field 'category' is missing; give one of A, B"] = with { cases = { office = "Q" } },
    ["case 'office': field 'category' is 'K'"] = with { cases = { office = { "Q", category = "K" } } },
    ["case 'snow': field 'altitude' is missing"] = with { cases = { snow = "S" } },
    ["field 'psi' is {2, 1, 1}; must be 3 numbers in braces, each of at least 0 and of at most 1"] = with {
      cases = { office = { "Q", psi = { 2, 1, 1 } } } },
    ["has the value 'G' without a name; write { dead = \"G\" }"] = with { cases = { "G" } },
    ["field 'gamma_Q' is not a number (nan)"] = with { gamma_Q = 0 / 0 },
    ["unknown field 'gamma_G'"] = with { kind = "SLS frequent", gamma_G = 1.35 },
    ["no case has the type \"E\""] = with { kind = "seismic" },
    ["no case has the type \"A\""] = with { standard = "ASCE 7-16", kind = "extraordinary", cases = { dead = "D" } },
    ["kind 'extraordinary' is not there for ASCE 7-22"] = with { standard = "ASCE 7-22", kind = "extraordinary" },
    ["field 'rho' is missing"] = with { standard = "ASCE 7-16", kind = "seismic LRFD", S_DS = 1,
      cases = { dead = "D", wind = "E" } },
    ["makes no combination of these cases"] = with { standard = "ASCE 7-16", kind = "ASD", cases = { wind = "A" } },
  } do
    checks.refused(words, combinations, options)
  end
  checks.refused("no further argument", combinations, with {}, 1)
  local many, cases = hinge.model(), {}
  for i = 1, 14 do
    many:case("load " .. i)
    cases["load " .. i] = { "Q", category = "A", action = "action " .. i }
  end
  checks.refused("more than 2000 combinations", combinations, with { model = many, cases = cases })
  expect(pcall(many.combination, many, "ULS 1.5 load 1", { ["load 1"] = 1 }), "nothing was declared")
  local twice = model_with("dead", "snow")
  combinations(with { model = twice, cases = { dead = "G", snow = "G" } })
  twice:case "crane"
  checks.refused("is there already, with other factors", combinations,
    with { model = twice, cases = { dead = "G", crane = "G" } })
end)

checks.done()
