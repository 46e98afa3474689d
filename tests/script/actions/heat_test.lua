-- Heat of members: closed forms of elongation, restraint, gradients and strength, the load at which a heated column
-- buckles and a heated beam forms its mechanism, the energy balance, the same bytes after a checkpoint, load cases;
-- wrong input is refused. EN 1993-1-2's numbers: standards/en_1993_1_2/fire_tables_test.lua.
--
-- Run: lua5.4 tests/script/actions/heat_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local scenes = require "scenes"
local hinge = require "hinge"
local checks = support.checks "heat"
local runs = require "runs"(checks)
local case, near, equal, expect = checks.case, checks.near, checks.equal, checks.expect
local completed = runs.completed

local E, fy, L = 210e9, 275e6, 4
local elastic = hinge.material { E = E, density = 7850 }
local steel = hinge.material { E = E, density = 7850, yield_stress = fy }
local section = hinge.section.h { depth = 0.2, width = 0.2, web = 0.009, flange = 0.015 }

-- EN 1993-1-2, table 3.1 and 3.4.1.1, by hand.
local k_E = { [20] = 1, [150] = 0.95, [400] = 0.7, [600] = 0.31, [650] = 0.22, [1000] = 0.045 }
local k_y = { [20] = 1, [150] = 1, [400] = 1, [600] = 0.47, [650] = 0.35, [1000] = 0.04 }
local strain = { [20] = 0, [150] = 1.6484e-3, [400] = 5.1984e-3, [600] = 8.3984e-3, [650] = 9.2484e-3,
  [1000] = 0.0138 }

-- A member along x between two nodes, with supports as model:fix takes them.
local function member(options)
  local model = hinge.model(options.model or { displacement = "small" })
  local a, b = model:node { 0, 0, 0 }, model:node { L, 0, 0 }
  local m = model:member { a, b, section = section, material = options.material or elastic, up = { 0, 0, 1 },
    elements = options.elements }
  model:fix(a, options.a or "all")
  if options.b then model:fix(b, options.b) end
  return model, a, b, m
end

case("a bar that is free to lengthen carries nothing", function()
  for temperature, e in pairs(strain) do
    local model, _, b, m = member {}
    model:heat { member = m, temperature = temperature }
    local run = completed(model:static { steps = 3 })
    near(b:displacement(run), e * L, 3e-8 * L, temperature .. " degrees: elongation")
    near(m:forces(run).N, 0, 1e-6 * fy * section.area, temperature .. " degrees: axial force")
    near(run:read("temperature")[1], temperature, 1e-9, "what the run says of it")
  end
end)

case("a bar held at both ends is pressed by k_E E A times the strain, up to k_y N0", function()
  for temperature, e in pairs(strain) do
    local model, _, _, m = member { b = "all" }
    model:heat { member = m, temperature = temperature }
    local N = m:forces(model:static { steps = 1 }:finish()).N
    near(N, -k_E[temperature] * E * section.area * e, 3e-8 * E * section.area, temperature .. " degrees, elastic")
  end
  for _, law in ipairs { "paper", "exact" } do
    local model, _, _, m = member { b = "all", material = steel, model = { displacement = "small", interaction = law } }
    model:heat { member = m, temperature = 650 }
    local run = completed(model:static { steps = 10 })
    near(m:forces(run).N, -k_y[650] * fy * section.area, 1e-6 * fy * section.area, law .. ": the squash load")
  end
end)

case("what one side has more bends a beam that is free and loads one that is held", function()
  local more = 100
  -- at 200 degrees in the middle the strain has the slope 1.2e-5 + 0.8e-8 T
  local curvature = (1.2e-5 + 0.8e-8 * 200) * more / section.depth
  local model, _, b, m = member {}
  model:heat { member = m, temperature = 200, across_y = more }
  local _, _, uz = b:displacement(model:static { steps = 1 }:finish())
  near(uz, -curvature * L ^ 2 / 2, 1e-6 * curvature * L ^ 2, "the tip bends away from the hot side")
  local held, _, _, held_member = member { b = "all" }
  held:heat { member = held_member, temperature = 200, across_y = more }
  local f = held_member:forces(held:static { steps = 1 }:finish())
  near(math.abs(f.Mx), 0.9 * E * section.Ix * curvature, 1e-5 * E * section.Ix * curvature, "the moment of a held beam")
  local across, _, tip, weak = member {}
  across:heat { member = weak, temperature = 200, across_x = more }
  local _, uy = tip:displacement(across:static { steps = 1 }:finish())
  -- up is z: x of the section is y in space
  near(-uy, (1.2e-5 + 0.8e-8 * 200) * more / section.width * L ^ 2 / 2, 1e-6 * L ^ 2, "about the weak axis")
end)

-- Temperature at which k falls to `part`, between two points of table 3.1.
local function temperature_of(part, t1, k1, t2, k2) return t1 + (k1 - part) / (k1 - k2) * (t2 - t1) end

case("a column under a load buckles where k_E has fallen to that part of Euler's load", function()
  local model = hinge.model {}
  local foot, head = model:node { 0, 0, 0 }, model:node { 0, 0, L }
  local m = model:member { foot, head, section = section, material = elastic, up = { 1, 0, 0 }, elements = 8 }
  model:fix(foot, "x,y,z,rz")
  model:fix(head, "x,y,rz")
  local cold, hot = model:case "cold", model:case "hot"
  local euler = 1 / (L ^ 2 / (math.pi ^ 2 * E * section.Iy) + 1 / (elastic.G * section.shear_area_x))
  model:load { node = head, force = { 0, 0, -0.5 * euler }, case = cold }
  model:heat { temperature = 700, case = hot }
  local loaded = model:static { loads = { cold = 1 } }:finish()
  near(m:forces(loaded).N, -0.5 * euler, 1e-3 * euler, "under the load alone")
  equal(loaded:read("temperature")[1], 20, "cold")
  local run = model:static { from = loaded, loads = { cold = 1, hot = 1 }, steps = 40, to_limit = true }:finish()
  expect(run.limit, "it ends at a limit: %s %s", run.verdict, run.reason)
  local critical = 20 + run.factor * 680
  -- the column is 0.6 % longer by then
  near(critical, temperature_of(0.5, 500, 0.6, 600, 0.31), 3, "the critical temperature")
  near(run:read("temperature")[1], critical, 1e-6, "what the run says of it")
  near(m:forces(run).N, -0.5 * euler, 1e-3 * euler, "the load is held")
end)

case("a beam under a load forms its mechanism where k_y has fallen to that part of the plastic load", function()
  for _, law in ipairs { "paper", "exact" } do
    local model = hinge.model { displacement = "small", interaction = law }
    local a, c, b = model:node { 0, 0, 0 }, model:node { L / 2, 0, 0 }, model:node { L, 0, 0 }
    for _, ends in ipairs { { a, c }, { c, b } } do
      model:member { ends[1], ends[2], section = section, material = steel, up = { 0, 0, 1 } }
    end
    model:fix(a, "x,y,z,rx,rz")
    model:fix(b, "y,z,rx,rz")
    local most = 4 * fy * section.Zx / L
    model:load { node = c, force = { 0, 0, -0.6 * most }, case = model:case "cold" }
    model:heat { temperature = 750, case = model:case "hot" }
    local loaded = model:static { loads = { cold = 1 } }:finish()
    local run = model:static { from = loaded, loads = { cold = 1, hot = 1 }, steps = 40, to_limit = true }:finish()
    expect(run.limit, "%s: it ends at a limit: %s", law, run.reason)
    near(20 + run.factor * 730, temperature_of(0.6, 500, 0.78, 600, 0.47), 0.5, law .. ": the critical temperature")
  end
end)

case("without the case in a later run the member cools down again", function()
  local model, _, b, m = member {}
  model:heat { member = m, temperature = 400, case = model:case "hot" }
  local hot = model:static { loads = { hot = 1 } }:finish()
  near(b:displacement(hot), strain[400] * L, 1e-6 * L, "hot")
  local half = model:static { from = hot, loads = { hot = 0.5 } }:finish()
  near(half:read("temperature")[1], 210, 1e-9, "half as hot above 20 degrees")
  local cold = model:static { from = half, loads = { hot = 0 } }:finish()
  near(cold:read("temperature")[1], 20, 1e-9, "cold")
  near(b:displacement(cold), 0, 1e-9 * L, "as short as it was")
end)

-- A frame of two columns and a beam, whose left column and beam are heated while the beam carries a load.
local function frame(options)
  local model = hinge.model(options.model or {})
  local n = { model:node { 0, 0, 0 }, model:node { 0, 0, 3 }, model:node { L, 0, 3 }, model:node { L, 0, 0 } }
  local material = options.material or steel
  local groups = { "hot", "hot", "cold" }
  for i = 1, 3 do
    model:member { n[i], n[i + 1], section = section, material = material, group = groups[i],
      up = i == 2 and { 0, 0, 1 } or { 1, 0, 0 }, elements = options.elements, backbone = options.backbone }
  end
  model:fix { n[1], n[4] }
  for i = 2, 3 do model:mass { node = n[i], mass = 40e3 } end
  model:gravity { 0, 0, -9.81 }
  local across = { { 0, 0 }, { 1, options.across or 0 } }
  model:heat { group = "hot", temperature = { { 0, 20 }, { 1, 800 } }, across_y = across }
  return model, n
end

case("the energy balance closes while members are heated, yield and are softened", function()
  local tried = {
    { name = "Newmark", elements = 2 }, { name = "Newmark, cubic pairs", elements = 4, across = 60 },
    { name = "exact", model = { interaction = "exact" } },
    { name = "small", model = { displacement = "small" } },
    { name = "no pairs", model = { p_delta = "chord" } },
    { name = "elastic", material = elastic },
    { name = "hardening", material = hinge.material { E = E, density = 7850, yield_stress = fy,
      hardening = { modulus = 0.02 * E } } },
    { name = "explicit", run = { integrator = "explicit", dt = "auto", duration = 1 } },
  }
  for _, t in ipairs(tried) do
    local run = completed(frame(t):dynamic(t.run or { dt = 1e-3, duration = 1 }), t.name)
    local e = run.energy
    local moved = e.elastic + e.plastic + math.abs(e.gravity) + math.abs(e.heat)
    expect(moved > 1e3, "%s: heat does work", t.name)
    runs.balanced(run, 1e-4, moved, t.name)
    if t.name ~= "elastic" then expect(e.plastic > 100, "%s: it yields, %g J", t.name, e.plastic) end
  end
end)

case("heat that comes and goes leaves an elastic frame with the energy that it had", function()
  local model = member { b = "all", model = {} }
  model:heat { temperature = function(t) return 20 + 200 * math.sin(math.pi * t) ^ 2 end }
  local run = model:dynamic { dt = 1e-3, duration = 1 }:finish()
  local most = 0.5 * E * section.area * L * (1.2e-5 * 200) ^ 2
  near(run.energy.elastic, 0, 1e-6 * most, "elastic energy")
  near(run.energy.heat, 0, 1e-4 * most, "what heat has taken out")
end)

case("a run that goes on from a checkpoint has the same bytes", function()
  runs.resumes(function()
    return frame { elements = 2, model = { interaction = "exact" } }:dynamic { dt = 1e-3, duration = 0.8 }
  end, 0.4, "heated")
end)

case("a step that is taken back leaves the temperature as it was", function()
  local model = frame { elements = 2 }
  local failed = false
  model:fracture { where = "all", rule = function(s)
    if s.time > 0.3 and not failed then
      failed = true
      error "once"
    end
    return false
  end }
  local run = model:dynamic { dt = 1e-3, duration = 0.5 }
  pcall(run.finish, run)
  near(run:read("temperature", "hot")[1], 20 + 780 * run.time, 1e-9, "where the run stopped")
  completed(run)
  near(run:read("temperature", "hot")[1], 410, 1e-6, "at the end")
end)

case("heat is no strain for fracture, and what it makes is", function()
  local function broken(b)
    local model, _, _, m = member { b = b, model = {}, material = steel }
    model:heat { member = m, temperature = { { 0, 20 }, { 1, 600 } } }
    model:fracture { axial_strain = 2e-3 }
    return model:dynamic { dt = 1e-3, duration = 1 }:finish():count { state = "broken" }
  end
  equal(broken(nil), 0, "a free bar, 0.8 % longer")
  equal(broken "all", 1, "a held bar")
end)

case("the last of several declarations counts; members of no group stay cold", function()
  local model = frame {}
  model:heat { group = "hot", temperature = 300 }
  local run = model:static { steps = 2 }:finish()
  near(run:read("temperature")[1], 300, 1e-9, "group hot")
  near(run:read("temperature")[3], 20, 1e-9, "group cold")
end)

case("prestress: between ends that do not move, with a free end, and a cable that straightens a beam", function()
  for _, given in ipairs { { force = 3e5 }, { strain = -3e5 / (E * section.area) } } do
    local model, _, b, m = member { b = "all" }
    given.member = m
    model:prestress(given)
    near(m:forces(model:static { steps = 1 }:finish()).N, 3e5, 1e-3, "the force between fixed ends, N")
    near(m:forces(model:dynamic { dt = 1e-4, duration = 1e-3 }:finish()).N, 3e5, 1e-3, "the same in dynamics")
    local free, _, tip, alone = member {}
    free:prestress { member = alone, strain = -1e-3 }
    free:prestress { member = alone, strain = -1e-3 }
    near(tip:displacement(free:static { steps = 1 }:finish()), -2e-3 * L, 1e-9 * L, "it is shorter by the sum")
    near(b:displacement(model:static { steps = 1 }:finish()), 0, 1e-12, "fixed")
  end
  -- two bars in a line between fixed ends, of which the second is prestressed by S: both have S A E / (2 A E)
  local model = hinge.model { displacement = "small" }
  local n = { model:node { 0, 0, 0 }, model:node { L, 0, 0 }, model:node { 2 * L, 0, 0 } }
  local bars = {}
  for i = 1, 2 do
    bars[i] = model:member { n[i], n[i + 1], section = section, material = elastic, up = { 0, 0, 1 },
      carries = "tension" }
  end
  model:fix { n[1], n[3] }
  model:fix(n[2], "y,z,rx,ry,rz")
  model:prestress { member = bars[2], force = 1e5, case = model:case "stressed" }
  local run = model:static { steps = 4, loads = { stressed = 1 } }:finish()
  near(bars[1]:forces(run).N, 5e4, 1, "half of it in either bar, N")
  local off = model:static { from = run, steps = 4, loads = { stressed = 0 } }:finish()
  near(bars[2]:forces(off).N, 0, 1, "taken off, N")
end)

case("properties of another material", function()
  local model, _, b, m = member {}
  model:heat { member = m, temperature = 100,
    properties = { stiffness = { { 20, 1 }, { 120, 0.8 } }, strength = { { 0, 1 }, { 200, 0.5 } },
      elongation = { { 20, 0 }, { 120, 2.3e-3 } } } }
  model:load { node = b, force = { 1e5, 0, 0 } }
  local run = model:static { steps = 1 }:finish()
  near(b:displacement(run), (0.8 * 2.3e-3 + 1e5 / (0.84 * E * section.area)) * L, 1e-9 * L, "the tip")
end)

case("steel in a fire has a point a minute", function()
  equal(#hinge.heat.unprotected { section_factor = 200, shadow = 0.7, duration = 1200 }, 21, "points of 20 minutes")
end)

-- In tension the stress is that of EN 1993-1-2, figure 3.1; the unit test of the law has the numbers. Columns:
-- scripts/benchmarks/column_in_fire.lua.
case("hot_curve: a bar that is pulled", function()
  local curve = hinge.heat.curve()
  local hot_steel = hinge.material { E = 210e9, density = 7850, yield_stress = 355e6, hot_curve = curve }
  equal(hot_steel.laws, "curve of EN 1993-1-2", "words")
  local model, b, bar = scenes.cantilever { model = { displacement = "small" }, member = {
    section = hinge.section.solid { width = 0.1, depth = 0.1 }, material = hot_steel } }
  model:fix(b, "y,z,rx,ry,rz")
  model:heat { member = bar, temperature = 500, case = model:case "heat" }
  model:load { node = b, force = { 1, 0, 0 }, case = model:case "pull" }
  local hot = model:static { loads = { heat = 1 }, steps = 1 }:finish()
  local start = b:displacement(hot)
  local yields, fp, E_hot = 0.78 * 355e6, 0.36 * 355e6, 0.6 * 210e9
  local width = 0.02 - fp / E_hot
  local c = (yields - fp) ^ 2 / (width * E_hot - 2 * (yields - fp))
  local function on_curve(e)
    return fp - c + math.sqrt(c * width * E_hot + c ^ 2)
      * math.sqrt(1 - (0.02 - e) ^ 2 / (width * (width + c / E_hot)))
  end
  for to, stress in pairs { [0.001] = 0.001 * E_hot, [0.002] = on_curve(0.002), [0.01] = on_curve(0.01),
    [0.025] = yields } do
    local run = model:static { from = hot, loads = { pull = 1 }, steps = 40,
      control = { node = b, "ux", to = start + to } }:finish()
    near(bar:forces(run).N / 0.01, stress, 1e-9 * stress, ("stress at a strain of %g"):format(to))
    expect(math.abs(run.energy_error) < 5e-3, "energy error %g", run.energy_error) -- of the trapezium rule
  end
  for _, o in ipairs { { hot_curve = 3 }, { hot_curve = { { 20, 1, 1 } } }, { hot_curve = { { 20, 1, 2, 1 } } },
    { hot_curve = curve, rate = { D = 40, q = 5 } } } do
    local options = scenes.with({ E = 210e9, yield_stress = 355e6 }, o)
    checks.refused("hot_curve", function() hinge.material(options) end)
  end
  checks.refused("yield_stress", function() hinge.material { E = 210e9, hot_curve = curve } end)
end)

case("wrong input is refused", function()
  local model, _, _, m = member {}
  local round = hinge.section.general { area = 1e-3, Ix = 1e-6, Iy = 1e-6, J = 1e-6 }
  local sizeless = hinge.model {}
  local bare = sizeless:member { sizeless:node { 0, 0, 0 }, sizeless:node { 1, 0, 0 }, section = round,
    material = elastic }
  for _, r in ipairs {
    { model, { temperature = 1300 }, "is 1300 degrees Celsius; the properties are known from -60 to 1100" },
    { model, { temperature = { { 0, 20 }, { 60, 1200 } } }, "1200 degrees Celsius at 60 s" },
    { model, { temperature = 1080, across_y = 100 }, "both sides of the section must be in that range" },
    { model, { temperature = "hot" }, "'temperature'" },
    { model, {}, "'temperature' is missing" },
    { model, { member = m, group = "x", temperature = 100 }, "give one of the two" },
    { model, { temperature = 100, properties = 3 }, "hinge.heat.steel()" },
    { model, { temperature = 100, properties = { stiffness = { { 20, 1 }, { 20, 1 } } } }, "more than that before" },
    { model, { temperature = 100, properties = { stiffness = { { 20, 1 }, { 200, 0 } } } }, "0.001 or more" },
    { sizeless, { member = bare, temperature = 100, across_y = 10 }, "needs a section with a size" },
  } do
    checks.refused(r[3], r[1].heat, r[1], r[2])
  end
  for words, options in pairs {
    ["'member' is missing"] = { strain = 1e-3 }, ["neither 'strain' nor 'force'"] = { member = m },
    ["both 'strain' and 'force'"] = { member = m, strain = 1e-3, force = 1 },
    ["between -0.1 and 0.1"] = { member = m, strain = 0.5 },
  } do
    checks.refused(words, model.prestress, model, options)
  end
  local asked = member {}
  asked:heat { temperature = function(t) return t > 0.01 and 2000 or 20 end }
  local run = asked:dynamic { dt = 1e-3, duration = 0.1 }
  checks.refused("2000 degrees Celsius", run.finish, run)
  local other = frame {}
  checks.refused("does not go with heat", other.dynamic, other,
    { integrator = "energy-momentum", dt = 1e-3, duration = 0.1 })
end)

checks.done()
