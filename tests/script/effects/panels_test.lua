-- Panels: membranes and plates against published and closed solutions, yielding and tearing, momentum; wrong input is
-- refused and changes nothing.
--
-- Run: lua5.4 tests/script/effects/panels_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local panel_cells = require "panel_cells"
local hinge = require "hinge"
local checks = support.checks "panels"
local case = checks.case
local function near(what, value, wanted, tolerance) checks.near(value, wanted, tolerance, what) end
local function equal(what, value, wanted) checks.equal(value, wanted, what) end

local g = 9.80665 -- m/s^2

local function elastic(E, nu, density)
  return hinge.material { E = E, G = E / (2 * (1 + nu)), density = density or 0 }
end
local function z_of(run, node) return (select(3, run:displacement(node))) end

local cells, square, on_edge = panel_cells.lay, panel_cells.square, panel_cells.on_edge

-- In their plane ------------------------------------------------------------------------------------------------------

case("a patch of crooked quadrilaterals has the same strain everywhere (MacNeal and Harder)", function()
  for _, displacement in ipairs { "small", "large" } do
    local model = hinge.model { displacement = displacement }
    local size = displacement == "small" and 1 or 1e-4 -- large: so small that both are linear
    local nodes, panels = {}, {}
    local places = { { 0, 0 }, { 0.24, 0 }, { 0.24, 0.12 }, { 0, 0.12 }, { 0.04, 0.02 }, { 0.18, 0.03 }, { 0.16, 0.08 },
      { 0.08, 0.08 } }
    for i, p in ipairs(places) do nodes[i] = model:node { p[1], p[2], 0 } end
    for i, q in ipairs { { 1, 2, 6, 5 }, { 2, 3, 7, 6 }, { 3, 4, 8, 7 }, { 4, 1, 5, 8 }, { 5, 6, 7, 8 } } do
      panels[i] = model:panel { nodes[q[1]], nodes[q[2]], nodes[q[3]], nodes[q[4]], thickness = 0.001,
        material = elastic(1e6, 0.25), along = { 1, 0, 0 }, bending = false }
    end
    local function moved(p) return 1e-3 * size * (p[1] + p[2] / 2), 1e-3 * size * (p[2] + p[1] / 2) end
    for i = 1, 8 do model:fix(nodes[i], i <= 4 and "all" or "z") end
    for i = 1, 4 do
      local x, y = moved(places[i])
      model:settle { node = nodes[i], x = x, y = y }
    end
    local run = model:static { steps = 1 }:finish()
    for i = 5, 8 do
      local x, y = moved(places[i])
      local dx, dy = run:displacement(nodes[i])
      near(displacement .. " x", dx, x, 1e-6 * math.abs(x))
      near(displacement .. " y", dy, y, 1e-6 * math.abs(y))
    end
    for _, panel in ipairs(panels) do
      local n11, n22, n12 = panel:force(run)
      near("n11", n11, 1333 * 1e-3 * size, 1e-3 * size)
      near("n22", n22, 1333 * 1e-3 * size, 1e-3 * size)
      near("n12", n12, 400 * 1e-3 * size, 1e-3 * size)
    end
  end
end)

case("Cook's membrane: 23.96 at the middle of its end, within 2 %", function()
  local n = 8
  local model = hinge.model { displacement = "small" }
  local nodes = cells(model, n, n, function(i, j)
    local low, high = 44 * i / n, 44 + 16 * i / n
    return { 48 * i / n, low + (high - low) * j / n, 0 }
  end, { thickness = 1, material = elastic(1, 1 / 3), bending = false })
  for i = 0, n do
    for j = 0, n do model:fix(nodes[i][j], i == 0 and "all" or "z") end
  end
  for j = 0, n do
    model:load { node = nodes[n][j], force = { 0, (j == 0 or j == n) and 0.5 / n or 1 / n, 0 } }
  end
  local run = model:static { steps = 1 }:finish()
  local _, y = run:displacement(nodes[n][n // 2])
  near("end", y, 23.96, 0.02 * 23.96)
end)

case("a quadrilateral bends in its plane as a beam", function()
  local model = hinge.model { displacement = "small" }
  local nodes = cells(model, 8, 1, function(i, j) return { i, j - 0.5, 0 } end,
    { thickness = 0.1, material = elastic(1e6, 0.3), bending = false })
  for i = 0, 8 do
    for j = 0, 1 do model:fix(nodes[i][j], i == 0 and (j == 0 and "xyz" or "xz") or "z") end
  end
  for j = 0, 1 do model:load { node = nodes[8][j], force = { (1 - 2 * j) * 100, 0, 0 } } end -- a moment of 100 N m
  local run = model:static { steps = 1 }:finish()
  local _, y = run:displacement(nodes[8][0])
  local exact = 100 * 8 ^ 2 / (2 * 1e6 * 0.1 / 12)
  near("tip", y, exact, 1e-6 * exact)
end)

-- Membranes that hang -------------------------------------------------------------------------------------------------

case("a ribbon of panels hangs as an elastic cable", function()
  local n, L, EA, q, of_middle = 16, 10, 1e6, 100 -- per width of 1 m
  local model = hinge.model()
  local nodes = cells(model, n, 1, function(i, j) return { L * i / n, j, 0 } end,
    { thickness = 1e-3, material = elastic(1e9, 0), bending = false, mass = q / g })
  for i = 0, n do
    for j = 0, 1 do model:fix(nodes[i][j], (i == 0 or i == n) and "xyz" or "y") end
  end
  model:gravity { 0, 0, -g }
  model:damping { alpha = 6 }
  local run = model:dynamic { duration = 5, dt = 1e-3 }:finish()
  -- a string of n pieces whose weights hang at its nodes: its horizontal force closes the span
  local function of_force(H)
    local x, z = 0, 0
    for i = 1, n do
      local V = q * L / n * ((n - 1) / 2 - (i - 1))
      local T = math.sqrt(H * H + V * V)
      local length = L / n * (1 + T / EA)
      x, z = x + length * H / T, z - length * V / T
      if i == n // 2 then of_middle = z end
    end
    return x, of_middle
  end
  local low, high = 1, 1e5
  for _ = 1, 200 do
    local H = (low + high) / 2
    if (of_force(H)) > L then high = H else low = H end
  end
  local _, sag = of_force(low)
  near("sag", z_of(run, nodes[n // 2][0]), sag, 2e-3 * math.abs(sag))
end)

-- A net of strings with stiffness EA each, whose nodes carry `weight` N: its sag in the middle, by dynamic relaxation.
local function sag_of_net(n, side, EA, weight)
  local x, v, h = {}, {}, side / n
  for i = 0, n do
    x[i], v[i] = {}, {}
    for j = 0, n do x[i][j], v[i][j] = { h * i, h * j, on_edge(i, j, n) and 0 or -0.02 * side }, { 0, 0, 0 } end
  end
  local k = EA / h
  for _ = 1, 6000 do
    local f = {}
    for i = 0, n do
      f[i] = {}
      for j = 0, n do f[i][j] = { 0, 0, -weight } end
    end
    local function pull(a, b, fa, fb)
      local d = { b[1] - a[1], b[2] - a[2], b[3] - a[3] }
      local l = math.sqrt(d[1] ^ 2 + d[2] ^ 2 + d[3] ^ 2)
      for c = 1, 3 do
        local p = k * (l - h) * d[c] / l
        fa[c], fb[c] = fa[c] + p, fb[c] - p
      end
    end
    for i = 0, n do
      for j = 0, n do
        if i < n then pull(x[i][j], x[i + 1][j], f[i][j], f[i + 1][j]) end
        if j < n then pull(x[i][j], x[i][j + 1], f[i][j], f[i][j + 1]) end
      end
    end
    for i = 1, n - 1 do
      for j = 1, n - 1 do
        for c = 1, 3 do -- in units in which the mass is 4 k and a step is 1
          v[i][j][c] = 0.97 * (v[i][j][c] + f[i][j][c] / (4 * k))
          x[i][j][c] = x[i][j][c] + v[i][j][c]
        end
      end
    end
  end
  return x[n // 2][n // 2][3]
end

case("a square net of bars hangs under its own weight as strings do, within 1 %", function()
  local n, side, q = 12, 10, 200
  local model = hinge.model()
  local nodes = cells(model, n, n, square(side, n), { reinforcement = { x = 5e-5, y = 5e-5, E = 200e9 }, mass = q / g })
  for i = 0, n do
    for j = 0, n do
      if on_edge(i, j, n) then model:fix(nodes[i][j], "xyz") end
    end
  end
  model:gravity { 0, 0, -g }
  model:damping { alpha = 6 }
  local run = model:dynamic { duration = 4, dt = 4e-3 }:finish()
  local sag = sag_of_net(n, side, 1e7 * side / n, q * (side / n) ^ 2)
  near("sag", z_of(run, nodes[n // 2][n // 2]), sag, 0.01 * math.abs(sag))
  equal("energy error", run.energy_error < 1e-3, true)
end)

-- Plates --------------------------------------------------------------------------------------------------------------

local function plate(n, options, displacement, mixed)
  local model = hinge.model { displacement = displacement or "small" }
  local nodes, panels = cells(model, n, n, square(1, n), options, mixed)
  for i = 0, n do
    for j = 0, n do model:fix(nodes[i][j], on_edge(i, j, n) and "xyz" or "xy") end
  end
  return model, nodes, panels
end
local function load_plate(model, nodes, n, q)
  for i = 1, n - 1 do
    for j = 1, n - 1 do model:load { node = nodes[i][j], force = { 0, 0, -q / n ^ 2 } } end
  end
end

case("a simply supported square plate: its deflection and its first frequency (Timoshenko), ever closer", function()
  local D, before = 200e9 * 0.01 ^ 3 / 12 / (1 - 0.09), { math.huge, math.huge }
  for _, n in ipairs { 4, 8, 16 } do
    local model, nodes = plate(n, { thickness = 0.01, material = elastic(200e9, 0.3, 7850) })
    load_plate(model, nodes, n, 1000)
    local run = model:static { steps = 1 }:finish()
    local w = -z_of(run, nodes[n // 2][n // 2]) * D / 1000
    local f = 1 / model:dynamic { duration = 1, dt = 1e-3 }:modes { n = 1 }[1].period
    local off = { math.abs(w / 0.00406235 - 1), math.abs(f / (math.pi * math.sqrt(D / 78.5)) - 1) }
    for k = 1, 2 do equal("closer", off[k] < 0.4 * before[k], true) end
    before = off
  end
  equal("deflection", before[1] < 0.01, true)
  equal("frequency", before[2] < 0.01, true)
end)

case("panels whose nodes run this way and that bend as those that all run one way", function()
  for _, displacement in ipairs { "small", "large" } do
    local w = {}
    for _, mixed in ipairs { false, true } do
      local model, nodes = plate(4, { thickness = 0.01, material = elastic(200e9, 0.3, 7850), along = { 1, 0, 0 } },
        displacement, mixed)
      load_plate(model, nodes, 4, 1000)
      w[mixed] = z_of(model:static { steps = 2 }:finish(), nodes[2][2])
    end
    equal("sags", w[false] < -1e-6, true)
    near("deflection", w[true], w[false], 1e-9 * math.abs(w[false]))
  end
end)

case("a square slab carries 24 m / L^2 by yield lines (Johansen), from above, ever closer", function()
  local before = math.huge
  for _, n in ipairs { 4, 8 } do
    local model, nodes = plate(n, { concrete = { thickness = 0.02, E = 30e9 },
      bending = { stiffness = 2e4, sagging = 100, hogging = 100 } })
    load_plate(model, nodes, n, 2400)
    local run = model:static { steps = 20, control = { node = nodes[n // 2][n // 2], "uz", to = -0.03 } }:finish()
    local above = run.factor - 1
    equal("above, and closer", above > 0 and above < 0.7 * before, true)
    before = above
  end
  equal("load", before < 0.12, true)
end)

case("a strip of plate spans as a beam over two spans, continuous over the line in its middle", function()
  local n, q, D = 32, 1000, 1e4
  local model = hinge.model { displacement = "small" }
  local nodes = cells(model, n, 2, function(i, j) return { 10 * i / n, j, 0 } end,
    { concrete = { thickness = 0.02, E = 30e9 }, bending = { stiffness = D } })
  for i = 0, n do
    for j = 0, 2 do
      local held = i == 0 or i == n or i == n // 2
      model:fix(nodes[i][j], held and "xyz" or "xy")
      if not held then model:load { node = nodes[i][j], force = { 0, 0, -q * 10 / n * (j == 1 and 1 or 0.5) } } end
    end
  end
  local run = model:static { steps = 1 }:finish()
  local exact = -q * 5 ^ 4 / (192 * D) -- in the middle of a span
  near("span", z_of(run, nodes[n // 4][1]), exact, 0.02 * math.abs(exact))
end)

-- Yielding, crushing and tearing --------------------------------------------------------------------------------------

local layers = { thickness = 0.001,
  material = hinge.material { E = 200e9, G = 80e9, density = 7850, yield_stress = 250e6 },
  hardening = 1e9, ultimate_strain = 0.02, mass = 100,
  reinforcement = { x = 2e-4, y = 1e-4, yield_stress = 500e6, hardening = 1e9, ultimate_strain = 0.03 },
  concrete = { thickness = 0.1, strength = 30e6, E = 30e9 } }

-- Panels over a square, thrown in the middle at some speed; held at the edges or free.
local function thrown(speed, integrator, options)
  local n = 6
  local model = hinge.model()
  local o = {}
  for key, value in pairs(layers) do o[key] = value end
  for key, value in pairs(options.panels or {}) do o[key] = value end
  local nodes, panels = cells(model, n, n, square(3, n), o)
  for i = 0, n do
    for j = 0, n do
      if on_edge(i, j, n) and not options.free then model:fix(nodes[i][j], "xyz") end
      if (i - 3) ^ 2 + (j - 3) ^ 2 < 2.5 then model:velocity(nodes[i][j], { 0, 0, -speed }) end
    end
  end
  local run = model:dynamic { duration = 0.03, dt = integrator == "explicit" and 1e-5 or 2e-5, integrator = integrator }
  return model, run, nodes, panels
end
local function count_torn(panels, run)
  local torn = 0
  for _, panel in ipairs(panels) do
    if panel:torn(run) then torn = torn + 1 end
  end
  return torn
end

case("energy is kept to 0.01 % through yielding, crushing and tearing, and the integrators agree", function()
  local w, torn
  for _, integrator in ipairs { "newmark", "explicit", "energy-momentum" } do
    local _, run, nodes, panels = thrown(60, integrator, {})
    run:finish()
    equal(integrator .. ": energy", run.worst_energy_error < 1e-4 * run.energy.initial, true)
    torn = torn or count_torn(panels, run)
    equal(integrator .. ": torn", count_torn(panels, run), torn)
    equal("some", torn > 3 and torn < 36, true)
    equal(integrator .. ": dissipated", run.energy.panel_dissipated > 1e4, true)
    w = w or z_of(run, nodes[3][3])
    near(integrator .. ": deflection", z_of(run, nodes[3][3]), w, 1e-3 * math.abs(w))
  end
end)

case("a piece that comes off keeps the momentum, linear and angular", function()
  local _, run, _, panels = thrown(120, "newmark", { free = true, panels = { ultimate_strain = 0.003,
    reinforcement = { x = 2e-4, y = 1e-4, yield_stress = 500e6, ultimate_strain = 0.004 } } })
  local before = run:momentum()
  run:finish()
  local after = run:momentum()
  equal("some are torn", count_torn(panels, run) > 3, true)
  local size = before.mass * 120
  for c = 1, 3 do
    near("linear", after.linear[c], before.linear[c], 1e-9 * size)
    near("angular", after.angular[c], before.angular[c], 1e-7 * size * 3)
  end
end)

case("a checkpoint in the middle of tearing goes on with the same bits", function()
  local model, run = thrown(60, "newmark", {})
  for _ = 1, 200 do run:step() end
  local name = os.tmpname()
  run:checkpoint(name)
  run:finish()
  local again = model:dynamic { duration = 0.03, dt = 2e-5, integrator = "newmark" }
  again:resume(name)
  again:finish()
  os.remove(name)
  equal("hash", again.hash, run.hash)
end)

-- Statics ------------------------------------------------------------------------------------------------------------

local steel = hinge.material { E = 200e9, G = 80e9, density = 7850, yield_stress = 300e6 }

-- Columns under a floor of 2 by 2 bays.
case("statics ends where bars tear, at their strength, whatever its steps are", function()
  local bars = { x = 4e-4, y = 4e-4, yield_stress = 500e6, hardening = 1e9, ultimate_strain = 0.05 }
  local strength = 4e-4 * (500e6 + 1e9 * (0.05 - 500e6 / 200e9) / (1 + 1e9 / 200e9)) -- N/m
  for _, steps in ipairs { 1, 7 } do
    local model = hinge.model { displacement = "small" }
    local nodes, panels = cells(model, 1, 1, square(1, 1), { reinforcement = bars })
    model:fix({ nodes[0][0], nodes[0][1] }, "xyz")
    model:fix({ nodes[1][0], nodes[1][1] }, "yz")
    for j = 0, 1 do model:load { node = nodes[1][j], force = { 5e5, 0, 0 } } end
    local run = model:static { steps = steps, to_limit = true }:finish()
    local n11 = panels[1]:force(run)
    near("force", n11, strength, 1e-3 * strength)
    near("load", run.factor * 1e6, strength, 1e-3 * strength)
  end
end)

-- Wrong input ---------------------------------------------------------------------------------------------------------

case("wrong input is refused and changes nothing", function()
  local model = hinge.model()
  local p = { model:node { 0, 0, 0 }, model:node { 1, 0, 0 }, model:node { 1, 1, 0 }, model:node { 0, 1, 0 } }
  local plate_of = { thickness = 0.01, material = steel }
  local function refused(what, o, words)
    local list = {}
    for key, value in pairs(o.of or plate_of) do list[key] = value end
    for i, k in ipairs(o.nodes or { 1, 2, 3, 4 }) do list[i] = p[k] end
    for key, value in pairs(o.with or {}) do list[key] = value end
    local good, why = pcall(model.panel, model, list)
    equal(what, good, false)
    equal(what .. ": " .. tostring(why), why ~= nil and why:find(words, 1, true) ~= nil, true)
  end
  refused("two nodes", { nodes = { 1, 2 } }, "2 nodes are given")
  refused("a node twice", { nodes = { 1, 2, 2 } }, "given twice")
  refused("crossed", { nodes = { 1, 3, 2, 4 } }, "enclose no area")
  refused("nothing", { of = {} }, "made of nothing")
  refused("no material", { of = { thickness = 0.01 } }, "material")
  refused("no thickness", { of = { material = steel } }, "thickness")
  refused("a law", { of = { thickness = 0.01, material = 3 } }, "hinge.material")
  refused("across", { with = { along = { 0, 0, 1 } } }, "across the panel")
  refused("negative", { with = { mass = -1 } }, "mass")
  refused("no bars", { with = { reinforcement = { yield_stress = 5e8 } } }, "area of the bars")
  refused("unknown", { with = { colour = 1 } }, "colour")
  refused("bending", { with = { bending = { stiffness = -1 } } }, "stiffness")
  refused("a triangle that bends", { nodes = { 1, 2, 3 }, with = { bending = { stiffness = 1 } } }, "do not bend")
  refused("weak bars", { with = { reinforcement = { x = 1e-4, yield_stress = 5e8, ultimate_strain = 1e-3 } } },
    "below the strain at which they yield")
  p[4] = model:node { 0, 1, 0.2 }
  refused("warped", {}, "off a plane")
  p[4] = model:node { 0, 1, 0 }
  local panel = model:panel { p[1], p[2], p[3], p[4], thickness = 0.01, material = steel }
  refused("twice", { nodes = { 2, 3, 4, 1 } }, "between these nodes already")
  equal("the first panel", panel.index, 1)
  near("area", panel.area, 1, 1e-12)
  near("mass", panel.mass, 78.5, 1e-9)
  model:load { node = p[3], moment = { 1, 0, 0 } }
  model:fix(p[1], "xyz")
  equal("a moment", select(2, pcall(model.static, model, {})):find("no rotation of its own", 1, true) ~= nil, true)
end)

case("a flat membrane without bending has no stiffness across it in statics, which says so", function()
  local model = hinge.model()
  local nodes = cells(model, 2, 2, square(1, 2), { reinforcement = { x = 1e-4, y = 1e-4 }, mass = 10 })
  for i = 0, 2 do
    for j = 0, 2 do
      if on_edge(i, j, 2) then model:fix(nodes[i][j], "xyz") end
    end
  end
  model:gravity { 0, 0, -g }
  local good, why = pcall(model.static, model, {})
  equal("refused", good, false)
  equal("why", why:find("where they bend (field 'bending') or are in tension", 1, true) ~= nil, true)
end)

case("panels that bend about a crooked node are refused, and so is buckling of panels", function()
  local model = hinge.model()
  local nodes = cells(model, 2, 2, function(i, j) return { i + (i == 1 and j == 1 and 0.4 or 0), j, 0 } end,
    { thickness = 0.01, material = steel })
  model:fix({ nodes[0][0], nodes[2][0], nodes[0][2], nodes[2][2] }, "xyz")
  local good, why = pcall(model.static, model, { steps = 1 })
  equal("refused", good, false)
  equal("why", why:find("straighter rows", 1, true) ~= nil, true)
  local plane, at = plate(2, { thickness = 0.01, material = steel }, "large")
  plane:load { node = at[1][1], force = { 0, 0, -1 } }
  local run = plane:static { steps = 1 }:finish()
  good, why = pcall(run.buckling, run)
  equal("buckling", good, false)
  equal("why not", why:find("has panels", 1, true) ~= nil, true)
end)

case("a node that panels alone join needs a mass in dynamics", function()
  local model = hinge.model()
  local nodes = cells(model, 1, 1, square(1, 1), { reinforcement = { x = 1e-4, y = 1e-4, ultimate_strain = 0.1 } })
  model:fix({ nodes[0][0], nodes[0][1], nodes[1][0] }, "xyz")
  model:mass { node = nodes[0][0], mass = 1 }
  for _, integrator in ipairs { "newmark", "explicit", "energy-momentum" } do
    local good, why = pcall(model.dynamic, model, { dt = 1e-4, duration = 1e-3, integrator = integrator })
    equal("refused", good, false)
    equal(tostring(why), tostring(why):find("panels alone join it; give its panels", 1, true) ~= nil, true)
  end
end)

case("bending that is left out leaves the membranes and their masses", function()
  local core = require "hinge.core"
  local function sag(bending)
    local model = hinge.model()
    local nodes = cells(model, 4, 4, square(4, 4), { thickness = 0.02, material = elastic(2e11, 0.25, 8000),
      bending = bending })
    for i = 0, 4 do model:fix({ nodes[i][0], nodes[i][4] }, "xyz") end
    model:gravity { 0, 0, -g }
    return z_of(model:dynamic { dt = 1e-4, duration = 0.1, record = false }:finish(), nodes[2][2])
  end
  local with, membranes = sag(), sag(false)
  core.leave_out "bending of panels"
  local without = sag()
  core.leave_out(nil)
  equal("sag", without, membranes)
  equal("bending counts", with > 0.9 * without, true)
end)

case("a panel that tears in statics takes its bending with it", function()
  local model = hinge.model { displacement = "small" }
  local bars = { x = 4e-4, y = 4e-4, yield_stress = 500e6, hardening = 1e9, ultimate_strain = 0.05 }
  local nodes = cells(model, 2, 2, square(2, 2), { reinforcement = bars, bending = { stiffness = 1e6 } })
  for j = 0, 2 do
    model:fix(nodes[0][j], "xyz")
    model:fix({ nodes[1][j], nodes[2][j] }, "yz")
    model:load { node = nodes[2][j], force = { j == 1 and 4e5 or 2e5, 0, 0 } } -- torn at 8.7e5 N / 2 m
  end
  local run = model:static { steps = 9, to_limit = true }:finish()
  near("limit", run.factor * 8e5, 2 * 4e-4 * (500e6 + 1e9 * (0.05 - 500e6 / 200e9) / (1 + 1e9 / 200e9)), 2e3)
end)

checks.done()
