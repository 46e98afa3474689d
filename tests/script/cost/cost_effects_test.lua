-- What effects change and cost: against closed forms, against scripts without the effect, idle ones, and those that a
-- script cannot do without.
--
-- Run: lua5.4 tests/script/cost/cost_effects_test.lua BUILD_FOLDER
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local hinge = require "hinge"
local compare = require "hinge.cost.compare"
local checks = support.checks "cost_effects"
local case, expect, equal, near = checks.case, checks.expect, checks.equal, checks.near

local function effect(result, name)
  for _, e in ipairs(result.effects) do
    if e.name == name then return e end
  end
  expect(false, "%s is not among the effects", name)
  return { changes = {} }
end

-- A slender cantilever far beyond small deflections: the elastica, and what the same load does to the first geometry --

local E, length, side = 206e9, 1, 0.01
local EI = E * side ^ 4 / 12

-- Tip deflection over length of EI theta'' = -P cos theta, clamped at one end, free of moment at the
-- other: shooting, by Runge and Kutta.
local function elastica(load)
  local function tip(curvature)
    local theta, k, y, h = 0, curvature, 0, 1 / 2000
    for _ = 1, 2000 do
      local k1, l1 = k, -load * math.cos(theta)
      local k2, l2 = k + h / 2 * l1, -load * math.cos(theta + h / 2 * k1)
      local k3, l3 = k + h / 2 * l2, -load * math.cos(theta + h / 2 * k2)
      local k4, l4 = k + h * l3, -load * math.cos(theta + h * k3)
      local middle, last = theta + h / 2 * k2, theta + h * k3
      y = y + h / 6 * (math.sin(theta) + 4 * math.sin(middle) + math.sin(last))
      theta, k = theta + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4), k + h / 6 * (l1 + 2 * l2 + 2 * l3 + l4)
    end
    return k, y
  end
  local low, high = 0, load
  for _ = 1, 60 do
    local middle = (low + high) / 2
    if tip(middle) > 0 then high = middle else low = middle end
  end
  return select(2, tip(low))
end
case("the elastica has the deflection of the tables", function()
  near(elastica(1), 0.30172, 1e-5, "the elastica's deflection in the tables, P L^2 = EI")
end)

local cantilever = hinge.scenario {
  parameters = { load = 1.001 * EI / length ^ 2, density = 0.0, yield_stress = 1e12, elements_per_member = 32 },
  accuracy = { elements_per_member = { 32, 64 } },
  run = function(p)
    local model = hinge.model { elements_per_member = p.elements_per_member }
    local wall, tip = model:node { 0, 0, 0 }, model:node { length, 0, 0 }
    model:fix(wall)
    model:member { wall, tip, section = hinge.section.solid { width = side, depth = side },
      material = hinge.material { E = E, density = p.density, yield_stress = p.yield_stress } }
    if p.load > 0 then model:load { node = tip, force = { 0, 0, -p.load } } end
    if p.density > 0 then model:gravity { 0, 0, -10 } end
    local _, _, uz = model:static { steps = 10 }:finish():displacement(tip)
    return { uz = uz }
  end,
}
local r = hinge.cost(cantilever, { effects = true, repeats = 4 })
local large = effect(r, "large displacement")
case("leaving out large displacement, gravity and the elastica changes the answer by what theory says", function()
  local wanted = 1.001 / 3 / elastica(1.001) - 1
  near(large.change / wanted, 1, 2e-3, "what large displacement changes, over that by the elastica")
  equal(large.worst, "uz", "the answer that it changes")
  equal(large.same, false, "it is not idle")
  near(large.answers.uz / (-1.001 * length / 3), 1, 1e-3, "the deflection without it")
  local least = math.min
  expect(#large.times >= 4 and large.saves == 1 - least(table.unpack(large.times)) / least(table.unpack(r.times))
    and large.spread >= 0, "the part of the time, by the shortest times")
  expect(large.saves > 0.2, "one linear solve a step is cheaper than several: %g", large.saves)
  local idle = effect(r, "plasticity")
  expect(idle.same and idle.change == 0, "plasticity far from yielding: the same bits, no change; %s", idle.change)
  equal(table.concat(r.absent, ", ", 1, 5), "point masses, panels, bending of panels, member loads, gravity",
    "what is not in the scene, first")
  near(r.answers.uz.error, 0, 1e-3, "its own error, against 64 elements")
  expect(r.answers.uz.scatter < 1e-7 and r.finer == "elements_per_member 64", "scatter %g, twice as fine: %s",
    r.answers.uz.scatter, r.finer)

  -- A load at the tip and the own weight in small displacement: w L^4 / 8 EI of it goes with gravity.
  local weight, load = 10 * 7850 * side ^ 2, 5.5
  r = hinge.cost(hinge.scenario {
    parameters = { load = load, density = 7850.5, yield_stress = 1e12, elements_per_member = 32 }, run =
      cantilever.run },
    { effects = true, repeats = 1, accuracy = { elements_per_member = { 32 } }, parameters = { load = load } })
  local bending = weight * 7850.5 / 7850 * length ^ 4 / (8 * EI)
  near(effect(r, "gravity").change / (bending / (load * length ^ 3 / (3 * EI) + bending)), 1, 5e-3,
    "what gravity changes")
  expect(r.notes[1] and r.notes[1]:find "no number to refine", "nothing to refine is said: %s", r.notes[1])
end)

-- Leaving out is the same as a script that never asked: every effect at once in a scene, bit by bit -------------------

case("leaving out an effect gives the bits of a script that never asked for it", function()
  local function scene(p)
    local model = hinge.model { displacement = p.without == "large displacement" and "small" or "large" }
    local steel = hinge.material { E = E, density = 7850, yield_stress = p.without ~= "plasticity" and 2e8 or nil }
    local bar = hinge.section.solid { width = 0.05, depth = 0.05 }
    local a, b = model:node { -0.5, 0, 0 }, model:node { 0.5, 0, 0 }
    model:fix { a, b }
    model:member { a, b, section = bar, material = steel, group = "fixed" }
    local c, d = model:node { 0.1, -0.4, 0.052 }, model:node { 0.1, 0.45, 0.052 }
    model:member { c, d, section = bar, material = steel, group = "flying" }
    model:velocity("flying", { 8, 0, -60 })
    if p.without ~= "gravity" then model:gravity { 0, 0, -9.8 } end
    if p.without ~= "fracture" then model:fracture { curvature_x = 0.1, curvature_y = 0.1, axial_strain = 0.01 } end
    local friction = p.without ~= "friction" and 0.3 or 0
    if p.without ~= "contact" then
      model:contact { friction = friction, pairs = p.pairs and function() return { friction = 2 * friction } end
        or nil }
    end
    -- in small displacement offset masses that rotate make energy, and no shorter step mends that
    local run = model:dynamic { dt = 4e-6, duration = 6e-4, energy_tolerance = 0, step_control = 0 }
    run:probe { node = d, "ux", name = "end" }
    run:finish()
    return { plastic = run.energy.plastic, slid = run.energy.contact, broken = run:count { state = "broken" },
      hash = run.hash, low = run:momentum().linear[1] }
  end
  for _, pairs_too in ipairs { false, true } do
    r = hinge.cost(hinge.scenario { parameters = { pairs = pairs_too }, run = scene }, { effects = true, repeats = 1,
      accuracy = { pairs = { pairs_too } } })
    equal(#r.effects, 6, "all effects are in the scene")
    local all = scene { pairs = pairs_too }
    expect(all.broken > 0 and all.slid > 0 and all.plastic > 0,
      "what happens in it: %d broken, %g J in contact, %g J plastic", all.broken, all.slid, all.plastic)
    for _, e in ipairs(r.effects) do
      local by_hand = scene { pairs = pairs_too, without = e.name }
      for name, value in pairs(by_hand) do
        if name ~= "hash" then
          equal(e.answers[name], value, ("%s without %s"):format(name, e.name))
          equal(e.changes[name], compare.error(value, all[name]), ("change of %s without %s"):format(name, e.name))
        end
      end
      expect(by_hand.hash ~= all.hash and not e.same, "%s is not idle", e.name)
      expect(e.changes["end"] > 0, "the probe without %s", e.name)
    end
  end
  equal(scene {}.hash, scene {}.hash, "a comparison leaves nothing behind")
end)

-- Laws of sections ----------------------------------------------------------------------------------------------------

-- A cantilever of HEB 300 beside N / N0 = 0.5, pushed far beyond its limit: its moment is that of its law.
local fy, reach = 235e6, 0.15
local function pushed(p)
  local of = hinge.section.named("HEB 300", { interaction = p.own or nil })
  local steel = hinge.material { E = E, density = 7850, yield_stress = fy,
    hardening = p.tangent > 0 and { tangent = p.tangent } or nil, rate = p.D > 0 and { D = p.D, q = 5 } or nil }
  local model = hinge.model { displacement = "small", interaction = p.interaction }
  local a, b = model:node { 0, 0, 0 }, model:node { 3, 0, 0 }
  local member = model:member { a, b, section = of, material = steel, up = { 0, 0, 1 } }
  model:fix(a)
  model:case("axial"):load { node = b, force = { -0.5 * of.plastic_area * fy, 0, 0 } }
  model:case("push"):load { node = b, force = { 0, 0, of.Zx * fy / 3 } }
  local held = model:static { loads = { axial = 1 } }:finish()
  local run = model:static { from = held, loads = { push = 1 }, steps = 10, control = { node = b, "uz", to = reach } }
  run:finish()
  local own_error = support.largest_of(math.abs(held.energy_error), math.abs(run.energy_error))
  return { m = math.abs(member:forces(run).Mx) / (of.Zx * fy) }, own_error
end
local function compared(parameters)
  return hinge.cost(hinge.scenario { parameters = parameters, run = pushed }, { effects = true, repeats = 3,
    accuracy = { own = { parameters.own } } })
end
local function law(result, name)
  for _, row in ipairs(result.laws) do
    if row.name == name then return row end
  end
  expect(false, "%s is not among the laws", name)
  return { changes = {}, answers = {} }
end

case("other laws of sections change the answer by what closed forms say", function()
  local exact, of_eq14 = hinge.section.named "HEB 300":reduced_moments(0.5), math.sqrt(0.75)
  local plain = { tangent = 0.0, D = 0.0, interaction = "paper", own = false }
  r = compared(plain)
  equal(#r.laws, 1, "laws of a scene with eq 14")
  local row = law(r, "exact in the place of eq 14")
  equal(row.law, "eq 14", "the law that is left out")
  near(r.values.m, of_eq14, 1e-4, "as it is")
  near(row.answers.m or 0, exact, 1e-4, "with the exact interaction")
  near(row.changes.m, 1 - exact / of_eq14, 2e-4, "the change")
  equal(row.saves, 1 - math.min(table.unpack(row.times)) / math.min(table.unpack(r.times)), "its time")
  expect(#row.times >= 3 and not row.same, "its times")
  for _, given in ipairs { { interaction = "exact", own = false }, { interaction = "paper", own = "exact" } } do
    r = compared { tangent = 0.0, D = 0.0, interaction = given.interaction, own = given.own }
    equal(#r.laws, 1, "laws of a scene with the exact interaction")
    row = law(r, "eq 14 in the place of exact")
    near(r.values.m, exact, 1e-4, "as it is")
    near(row.answers.m or 0, of_eq14, 1e-4, "by eq 14")
  end
end)

case("hardening and strain rate are left out each by itself", function()
  local given = { tangent = 5e9, D = 40.0, interaction = "exact", own = false }
  r = compared(given)
  equal(#r.laws, 3, "laws")
  for name, without in pairs { ["without hardening"] = { tangent = 0.0 }, ["without strain rate"] = { D = 0.0 },
    ["eq 14 in the place of exact"] = { interaction = "paper" } } do
    local p = {}
    for key, value in pairs(given) do p[key] = value end
    for key, value in pairs(without) do p[key] = value end
    equal(law(r, name).answers.m, pushed(p).m, name .. ": the bits of a script that never asked for it")
  end
  expect(law(r, "without hardening").change > 0.1, "hardening changes it: %s", law(r, "without hardening").change)
  expect(law(r, "without strain rate").same, "statics have no rate")
  local again, own_error = pushed(given)
  equal(again.m, r.values.m, "a comparison leaves nothing behind")
  expect(own_error > 0, "an energy error to be compared: %g", own_error)
  equal(r.energy_error, own_error, "the energy error is that of the run by itself")
end)

case("sections that cannot yield, or of unknown shape, have no other law", function()
  local function elastic()
    local model = hinge.model { displacement = "small" }
    local a, b = model:node { 0, 0, 0 }, model:node { 1, 0, 0 }
    model:fix(a)
    model:member { a, b, section = hinge.section.solid { width = side, depth = side },
      material = hinge.material { E = E } }
    model:load { node = b, force = { 0, 0, 1 } }
    return { uz = select(3, b:displacement(model:static {}:finish())) }
  end
  equal(#hinge.cost(hinge.scenario { parameters = { own = 1 }, run = elastic }, { effects = true, repeats = 1,
    accuracy = { own = { 1 } } }).laws, 0, "laws of an elastic scene")
end)

-- Idle, chaotic, failing, chosen --------------------------------------------------------------------------------------

local function falling(p)
  local model = hinge.model {}
  local a, b = model:node { 0, 0, 0 }, model:node { 1, 0, 0 }
  model:member { a, b, section = hinge.section.solid { width = 0.05, depth = 0.05 },
    material = hinge.material { E = E, density = 7850, yield_stress = 2e8 } }
  model:gravity { 0, 0, -p.g }
  model:contact { friction = 0.1 }
  model:fracture { curvature_x = 0.4 }
  -- short: in long steps what may yield is solved otherwise
  local run = model:dynamic { dt = 4e-6, duration = 4e-4 }:finish()
  local _, _, vz = run:velocity(a)
  local x = p.chaos
  for _ = 1, 200 do x = 3.9 * x * (1 - x) end
  if p.needs and vz == 0 then error("it does not fall\nand more") end
  return { vz = vz, chaos = x + 1e-3 * vz, clock = os.clock() }
end
local body = hinge.scenario { parameters = { g = 9.81, chaos = 0.3, needs = false },
  accuracy = { needs = { false, true } }, run = falling }
case("idle, chaotic, failing and chosen effects are told apart", function()
  r = hinge.cost(body, { effects = true, parameters = { needs = false } })
  for _, name in ipairs { "plasticity", "fracture", "contact", "friction" } do
    expect(effect(r, name).same and effect(r, name).change == 0, "%s is idle", name)
  end
  near(effect(r, "gravity").changes.vz, 1, 1e-12, "the whole of the speed is gravity's")
  equal(effect(r, "gravity").worst, "vz", "what changes by more than it scatters comes first")
  equal(r.answers.clock, nil, "what differs from run to run is no answer")
  expect(r.answers.chaos.scatter > 0.05, "chaos scatters: %g", r.answers.chaos.scatter)
  r = hinge.cost(body, { effects = true, parameters = { needs = false }, quantity = "chaos" })
  equal(effect(r, "gravity").lost, true, "a change that drowns in scatter is said to")
  r = hinge.cost(body, { effects = true, parameters = { needs = true }, repeats = 1 })
  expect(effect(r, "gravity").failed and effect(r, "gravity").failed:find "it does not fall and more$", -- in one line
    "a script that cannot do without: %s", effect(r, "gravity").failed)
  local _, refusal = pcall(hinge.cost, body, { effects = true, quantity = "vx" })
  expect(tostring(refusal):find "unknown quantity 'vx' %(did you mean 'vz'%?%)", "an unknown quantity: %s", refusal)
  _, refusal = pcall(hinge.cost, hinge.scenario { run = function() error "broken" end }, { effects = true })
  expect(tostring(refusal):find "hinge.cost: the scenario has no answer: .*broken", "a scenario that fails: %s",
    refusal)
end)

case("a budget leaves out effects and says so", function()
  -- A budget: what does not fit is named; nothing at all is an error. An answer that goes with
  -- its effect has no finite change.
  local core = require "hinge.core"
  local clock, now = core.clock, 0
  core.clock = function() return now end -- other programs do not count
  local slow = hinge.scenario { parameters = { g = 9.81, chaos = 0.3, needs = false },
    accuracy = { needs = { false, true } }, run = function(p)
      now = now + 0.05
      local answers = falling(p)
      answers.falls = answers.vz ~= 0 and 1 or nil
      return answers
    end }
  r = hinge.cost(slow, { effects = true, budget = 0.13, out = support.temporary_folder() })
  expect(#r.left_out >= 1 and not r.complete and #r.effects + #r.laws + #r.left_out == 7, "left out: %s",
    table.concat(r.left_out, ", "))
  equal(r.left_out[#r.left_out], "eq 14 in the place of exact", "laws come last")
  r = hinge.cost(slow, { effects = true, repeats = 1, out = support.temporary_folder() })
  equal(effect(r, "gravity").changes.falls, math.huge, "change of an answer that is gone")
  core.clock = clock
  local _, refusal = pcall(hinge.cost, body, { effects = true, budget = 1e-9 })
  expect(tostring(refusal):find "hinge.cost: the budget ended before the scenario was finished; give a larger one",
    "no time at all: %s", refusal)
end)

-- The program ---------------------------------------------------------------------------------------------------------

case("hinge cost --effects prints the table and writes effects.csv", function()
  local folder, program = support.temporary_folder(), support.quote(arg[1] .. "/hinge")
  local script = folder .. "/script.lua"
  support.write(script, [[
local hinge = require "hinge"
return hinge.scenario {
  parameters = { g = 9.81 }, cases = { moon = { g = 1.62 } }, accuracy = { dt = { 1e-3, 5e-4 } },
  run = function(p)
    local model = hinge.model {}
    local a, b = model:node { 0, 0, 0 }, model:node { 1, 0, 0 }
    model:member { a, b, section = hinge.section.solid { width = 0.05, depth = 0.05 },
      material = hinge.material { E = 206e9, density = 7850 } }
    model:gravity { 0, 0, -p.g }
    model:contact {}
    local _, _, vz = model:dynamic { dt = p.dt, duration = 0.01 }:finish():velocity(a)
    return { vz = vz }
  end,
}
]])
  local command = ("%s cost %s --effects --case moon --out %s/p"):format(program, support.quote(script), folder)
  local status, printed, complaint = support.run(command)
  equal(status, 0, "status: " .. complaint)
  for _, part in ipairs { "gravity decides (100 % of vz) and ", "changes nothing and ",
    "own error: difference from a setting twice as fine (dt 0.0005)",
    "plasticity, fracture, removal, contact of panels, friction, connectors, rigid links",
    "not in this scenario: point masses",
    "written to " .. folder .. "/p" } do
    expect(support.has(printed, part), "hinge cost --effects does not say '%s':\n%s", part, printed)
  end
  local summary = support.json(support.read(folder .. "/p/summary.json") or "{}")
  equal(#(summary.effects or {}), 3, "effects in summary.json")
  expect(summary.effects[1].name == "gravity" and summary.effects[1].change == 1 and summary.effects[3].same == true,
    "summary.json")
  local csv = support.read(folder .. "/p/effects.csv") or ""
  equal(csv:match "^[^\n]*",
    "without,change,worst,same,lost,takes,spread,seconds,timings,energy_error,failed,change of vz,vz",
    "head of effects.csv")
  equal(select(2, csv:gsub("\n", "")), 5, "lines of effects.csv")
  local before = support.read(folder .. "/p/finished.lua")
  equal(support.run(command), 0, "a second call")
  equal(support.read(folder .. "/p/finished.lua"), before, "what it runs again: nothing")
end)

case("hinge cost --effects prints what other laws change, and writes it", function()
  local folder, program = support.temporary_folder(), support.quote(arg[1] .. "/hinge")
  local script = folder .. "/script.lua"
  support.write(script, [[
local hinge = require "hinge"
return hinge.scenario {
  parameters = { n = 0.5 },
  run = function(p)
    local of = hinge.section.named "HEB 300"
    local model = hinge.model { displacement = "small", interaction = "paper" }
    local a, b = model:node { 0, 0, 0 }, model:node { 3, 0, 0 }
    model:fix(a)
    model:member { a, b, section = of, up = { 0, 0, 1 },
      material = hinge.material { E = 210e9, density = 7850, yield_stress = 235e6 } }
    local N0, M0 = of.plastic_area * 235e6, of.Zx * 235e6
    model:case("axial"):load { node = b, force = { -p.n * N0, 0, 0 } }
    model:case("push"):load { node = b, force = { 0, 0, M0 / 3 } }
    local held = model:static { loads = { axial = 1 } }:finish()
    local run = model:static { from = held, loads = { push = 1 }, control = { node = b, "uz", to = 0.15 } }
    run:probe { node = b, "uz", name = "tip" }
    return { strength = run:finish().factor }
  end,
}
]])
  local status, printed, complaint = support.run(("%s cost %s --effects --out %s/p"):format(program,
    support.quote(script), folder))
  equal(status, 0, "status: " .. complaint)
  local exact, of_eq14 = hinge.section.named "HEB 300":reduced_moments(0.5), math.sqrt(0.75)
  local printed_change = printed:match "\n  exact in the place of eq 14 +([%d.]+) %%"
  near(tonumber(printed_change) or 0, 100 * (1 - exact / of_eq14), 0.1, "what it prints of the change, %:\n" .. printed)
  expect(printed:match "^(.-)\n\n":find "exact in the place of eq 14 changes strength by [%d.]+ %% and takes ",
    "in words, first:\n%s", printed)
  local csv = support.read(folder .. "/p/effects.csv") or ""
  for name, wanted in pairs { nothing = of_eq14, ["exact in the place of eq 14"] = exact } do
    local row = csv:match("\n(" .. name .. ",[^\n]*)\n") or ""
    near(tonumber(row:match ",([%d.]+),[^,]*,[^,]*$") or 0, wanted, 1e-4, "strength in effects.csv: " .. row)
  end
  local summary = support.json(support.read(folder .. "/p/summary.json") or "{}")
  expect(#(summary.laws or {}) == 1 and summary.laws[1].law == "eq 14" and summary.values == nil, "summary.json")
end)

checks.done()
