-- run:modes and run:buckling: frequencies, shapes, effective masses and buckling loads by closed forms, of loaded
-- states, with joints and rigid floors; pictures of a shape; wrong input is refused.
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local scenes = require "scenes"
local hinge = require "hinge"
local checks = support.checks "modes"
local case, near, equal, expect, refused = checks.case, checks.near, checks.equal, checks.expect, checks.refused

local E, side = 206e9, 0.05
local EI, GA = E * side ^ 4 / 12, 5 / 6 * E / 2.6 * side ^ 2
local steel = hinge.material { E = E, density = 7850 }
local square = hinge.section.solid { width = side, depth = side }

-- A cantilever along x with a force on its tip.
local function cantilever(elements, force, material, options, section)
  return scenes.cantilever { model = scenes.with({ elements_per_member = elements }, options), force = force,
    member = { section = section, material = material or steel } }
end

-- Up to where a condition holds, between two numbers, by bisection.
local function last_of(low, high, holds)
  for _ = 1, 80 do
    local middle = (low + high) / 2
    if holds(middle) then low = middle else high = middle end
  end
  return low
end

-- The first mode, and the first factor, of the state in which statics ends.
local function first_mode(model, options) return model:static(options):finish():modes({ n = 1 })[1] end
local function first_factor(model, options) return model:static(options):finish():buckling()[1].factor end

case("a cantilever: frequencies, shape and effective masses", function()
  local model, tip = cantilever(16, { 0, 0, -1 }, nil, { mass = "cubic" })
  local modes = model:static():finish():modes { n = 40 }
  equal(#modes, 40, "modes")
  -- Timoshenko's beam: tests/references.md, dynamics 15
  near(modes[1].frequency, 41.2938, 1e-3 * 41.2938, "first frequency")
  near(modes[2].frequency, modes[1].frequency, 1e-9 * 41, "the square bends alike in both planes")
  near(modes[3].frequency, 255.770, 1e-3 * 255.770, "second frequency")
  near(modes[1].period, 1 / modes[1].frequency, 1e-12, "period")
  near(modes[1].omega_squared, (2 * math.pi * modes[1].frequency) ^ 2, 1e-6, "its square")
  -- a slender clamped beam has 0.6131 of its mass in the first mode, 0.1883 in the second (Timoshenko: less by 1e-3)
  local share = modes[1].share.y + modes[2].share.y
  near(share, 0.6131, 4e-3, "share of the first mode")
  near(modes[3].share.z + modes[4].share.z, 0.1883, 4e-3, "share of the second")
  local sum, mass = { x = 0, y = 0, z = 0 }, 0
  for _, mode in ipairs(modes) do
    for axis in pairs(sum) do sum[axis] = sum[axis] + mode.share[axis] end
    mass = mass + mode.mass.y
  end
  expect(sum.y > 0.95 and sum.y < 1 + 1e-9, "shares along y sum up to %g", sum.y)
  near(mass / sum.y, 7850 * side ^ 2, 1e-9 * 7850 * side ^ 2, "whole mass")
  -- shape of modal mass 1: the tip moves by 2 / sqrt(m) of a slender beam
  local _, y, z = modes[1]:displacement(tip)
  near(math.sqrt(y * y + z * z), 2 / math.sqrt(7850 * side ^ 2), 5e-3 * 0.45, "displacement of the tip")
  near(modes[1].participation.y ^ 2, modes[1].mass.y, 1e-9, "effective mass")
end)

case("a tip mass on a compressed column, and on a pulled one", function()
  -- all but rigid in shear, and light, so that the closed form of the beam-column is the stiffness
  local light = hinge.material { E = E, G = 1e3 * E, density = 1e-3 }
  local euler = math.pi ^ 2 * EI / 4
  for _, part in ipairs { 0.5, 0.9, -1 } do
    local model, tip = cantilever(2, { -part * euler, 0, 0 }, light, nil, hinge.section.general {
      area = 1e3 * side ^ 2, Ix = side ^ 4 / 12, Iy = side ^ 4 / 12, J = side ^ 4 / 6 }) -- it does not shorten
    model:mass { node = tip, mass = 10 }
    local run = model:static { steps = 4 }:finish()
    local beta = math.sqrt(math.abs(part) * euler / EI)
    local k = part > 0 and part * euler * beta / (math.tan(beta) - beta)
      or -part * euler * beta / (beta - (math.exp(2 * beta) - 1) / (math.exp(2 * beta) + 1))
    local wanted = math.sqrt(k / 10) / (2 * math.pi)
    near(run:modes { n = 1 }[1].frequency, wanted, 1e-4 * wanted, ("at %g of Euler's load"):format(part))
  end
end)

case("an unstable state has modes whose squares are negative", function()
  local euler = math.pi ^ 2 * EI / 4 / (1 + math.pi ^ 2 * EI / 4 / GA)
  for elements, count in pairs { [4] = 2, [40] = 2 } do -- a small matrix, and one for Lanczos' method
    local model = cantilever(elements, { -1.2 * euler, 0, 0 })
    local modes = model:static({ steps = 4, unstable = "continue" }):finish():modes { n = 3 }
    for i = 1, count do expect(modes[i].omega_squared < 0, "%d: mode %d: %g", elements, i, modes[i].omega_squared) end
    expect(modes[3].omega_squared > 0, "%d: mode 3: %g", elements, modes[3].omega_squared)
    equal(modes[1].frequency, 0, "its frequency")
    -- nearly the square of the unloaded one times the part of the load beyond Euler's: 7 and 11 %
    near(modes[1].omega_squared, -0.2 * (2 * math.pi * 41.29) ^ 2, 0.12 * 0.2 * (2 * math.pi * 41.29) ^ 2,
      elements .. " elements: square")
  end
end)

-- A square or flat bar along x, clamped at one end, with a moment of fixed axis at the other one.
local function turned_cantilever(moment, options)
  local model = hinge.model { elements_per_member = (options.elements or 10) // (options.joint and 2 or 1) }
  local L, material = 10, hinge.material { E = 2e9, nu = 0, density = 1000 }
  local bar = hinge.section.solid { width = options.width or 0.02, depth = 0.02 }
  local wall, tip = model:node { 0, 0, 0 }, model:node { L, 0, 0 }
  model:fix(wall)
  if options.joint then
    local middle, joint = model:node { L / 2, 0, 0 }, hinge.joint { Mx = { stiffness = 1e7 }, My = { stiffness = 1e7 } }
    model:member { wall, middle, section = bar, material = material, ends = { b = joint } }
    model:member { middle, tip, section = bar, material = material }
  else
    model:member { wall, tip, section = bar, material = material }
  end
  local M = material.E * bar.Ix / L
  model:load { node = tip, moment = { moment[1] * M, moment[2] * M, moment[3] * M }, case = model:case "turn" }
  model:load { node = tip, force = { 0, 1e-4, 0 }, history = { { 0, 0 }, { 0.1, 1 }, { 0.2, 0 }, { 99, 0 } },
    case = model:case "push" }
  return model:static({ steps = 12, loads = { turn = 1 } }):finish(), model, tip
end

case("a moment of fixed axis: nothing grows at 0.6 of a turn", function()
  for _, moment in ipairs { { 0, -1.2 * math.pi, 0 }, { 0, 0, 1.2 * math.pi } } do
    local run = turned_cantilever(moment, {})
    equal(run.verdict, "completed", run.reason)
    for i, mode in ipairs(run:modes { n = 3 }) do
      expect(mode.omega_squared > 0, "mode %d: %g 1/s^2", i, mode.omega_squared)
    end
  end
end)

case("a moment of fixed axis: a stiff joint that carries it changes nothing", function()
  local plain = turned_cantilever({ 0, -1.2 * math.pi, 0 }, { elements = 12 }):modes { n = 4 }
  local jointed = turned_cantilever({ 0, -1.2 * math.pi, 0 }, { elements = 12, joint = true }):modes { n = 4 }
  for i = 1, 4 do -- the joint turns by 1e-5 of what the bar does
    near(jointed[i].omega_squared, plain[i].omega_squared, 1e-3 * plain[i].omega_squared, "mode " .. i)
  end
end)

case("a moment of fixed axis: flutter grows in dynamics as the modes say", function()
  local run, model, tip = turned_cantilever({ 0, -1.8 * math.pi, 0 }, {})
  local failure = refused("flutters", run.modes, run)
  local rate = tonumber(failure:match "flutters: vibrations of [%d.]+ Hz grow by exp%(([%d.]+) t%)") or 0 / 0
  local shaken = model:dynamic { from = run, loads = { turn = 1, push = 1 }, dt = 5e-3, duration = 16 }
  local most = { 0, 0 } -- over a half of its period and more
  while shaken:step() do
    local _, y = tip:displacement(shaken)
    local k = shaken.time > 12 and 2 or shaken.time > 4 and shaken.time <= 8 and 1
    if k then most[k] = support.largest_of(most[k], math.abs(y)) end
  end
  -- the two windows are 8 s apart; other modes are a tenth of the motion in the first one
  near(math.log(most[2] / most[1]) / 8, rate, 0.1 * rate, "rate of growth, 1/s")
end)

case("a shaft with a moment about its axis flutters if it is square, and not if it is flat", function()
  -- Ziegler: two bending modes of equal frequency, which the moment couples
  local shaft = turned_cantilever({ 0.2, 0, 0 }, {})
  refused("flutters", shaft.modes, shaft, { n = 2 })
  local flat = turned_cantilever({ 0.2, 0, 0 }, { width = 0.04 }):modes { n = 2 }
  local alone = turned_cantilever({ 0, 0, 0 }, { width = 0.04 }):modes { n = 2 }
  for i = 1, 2 do -- the change is of second order, 0.2^2 / pi^2 and less
    near(flat[i].omega_squared, alone[i].omega_squared, 4e-3 * alone[i].omega_squared, "mode " .. i)
  end
end)

case("unsymmetric stiffness: moments that change nothing, and too many unknowns", function()
  local run = turned_cantilever({ 0, -0.01, 0 }, { elements = 400 }) -- symmetric within a thousandth
  expect(run:modes({ n = 1 })[1].omega_squared > 0, "a small moment")
  run = turned_cantilever({ 0, -1.2 * math.pi, 0 }, { elements = 400 })
  refused("2400 degrees of freedom", run.modes, run, { n = 1 })
end)

-- A portal of members that hardly shear, with half of a push at each head; the sway under 100 kN, and its modes.
local function stiff_portal(shear, options)
  local function of(I)
    return { material = hinge.material { E = 200e9, density = 1e-3 }, section = hinge.section.general { area = 0.02,
      Ix = I, Iy = I, J = 2 * I, shear_area_x = shear, shear_area_y = shear } }
  end
  local model, n = scenes.portal { model = { displacement = options.displacement or "small" }, width = 6, height = 4,
    heads = "y,rx,rz", column = of(8e-4), beam = of(16e-4) }
  for _, head in ipairs { n[2], n[3] } do
    model:mass { node = head, mass = 20e3 }
    model:load { node = head, force = { 50e3, 0, 0 } }
  end
  if options.spring then model:connector { n[2], n[3], stiffness = { x = 1 } } end
  if options.dynamic then return model:dynamic({ dt = 1e-3, duration = 1e-3 }):finish() end
  local run = model:static { steps = 1 }:finish()
  return run, (n[2]:displacement(run))
end

case("members that are all but rigid in shear leave the period of a frame as it is", function()
  for _, options in ipairs { {}, { displacement = "large" }, { spring = true } } do
    for _, shear in ipairs { 1e3, 1e7, 1e9 } do -- m^2; files of other programs have such areas
      local run, sway = stiff_portal(shear, options)
      -- both heads move alike: T = 2 pi sqrt(m u / P). They move up and down, too: 1e-4. The loads of large
      -- displacement change it by u / L
      local wanted = 2 * math.pi * math.sqrt(40e3 * sway / 100e3)
      -- rounding of the stiffness, 1e-16 G A_s / (E I / L^2)
      near(run:modes({ n = 1 })[1].period, wanted, (options.displacement and 2e-3 or 1.5e-4 + 1e-12 * shear) * wanted,
        ("shear area %g m^2"):format(shear))
    end
  end
end)

case("a frequency that rounding hides is an error, not 0", function()
  for _, shear in ipairs { 1e11, 1e13 } do -- statics refuses them
    local run = stiff_portal(shear, { dynamic = true })
    refused("lost in the rounding of the stiffness", run.modes, run, { n = 1 })
  end
end)

case("bodies that move freely have frequency 0 beside parts that are 1e6 times as stiff", function()
  local huge = 1e6 * side ^ 2
  local model = scenes.cantilever { model = { elements_per_member = 16, mass = "cubic" }, member = { material = steel,
    section = hinge.section.general { area = huge, Ix = 1, Iy = 1, J = 1, shear_area_x = huge, shear_area_y = huge } } }
  local a, b = model:node { 0, 5, 0 }, model:node { 0.6, 5.8, 0 } -- oblique
  model:member { a, b, section = square, material = steel }
  local modes = model:dynamic({ dt = 1e-4, duration = 1e-4 }):finish():modes { n = 10 }
  for i = 1, 6 do equal(modes[i].frequency, 0, "rigid motion " .. i) end
  expect(modes[7].frequency > 10, "the seventh vibrates: %g Hz", modes[7].frequency)
  for i = 9, 10 do near(modes[i].frequency, 260.919, 1e-3 * 260.919, "bending of the free bar, in both planes") end
end)

case("joints, floors that are rigid in their plane and compression count", function()
  local function frame(options)
    local model, n = scenes.portal { column = { material = steel },
      beam = { material = steel, release = options.pinned and { a = "Mx", b = "Mx" } or nil } }
    for i = 2, 3 do
      model:mass { node = n[i], mass = 500 }
      if i == 2 or not options.link then model:fix(n[i], "y") end
    end
    if options.link then model:diaphragm { nodes = { n[2], n[3] } } end
    if options.gravity then model:gravity { 0, 0, -9.81 } end
    return model
  end
  -- two cantilevers with a pinned bar between them: 3 EI / h^3 each
  local k = 1 / (27 / (3 * EI) + 3 / GA)
  local column = 7850 * side ^ 2 * 3
  local wanted = math.sqrt(2 * k / (1000 + 2 * 33 / 140 * column + 7850 * side ^ 2 * 4)) / (2 * math.pi)
  local function frequency(options, steps) return first_mode(frame(options), { steps = steps }).frequency end
  near(frequency { pinned = true }, wanted, 2e-3 * wanted, "pinned beam")
  near(frequency { pinned = true, link = true }, wanted, 2e-3 * wanted, "pinned beam in a rigid floor")
  local rigid, pressed = frequency {}, frequency({ gravity = true }, 4)
  expect(rigid > 1.1 * wanted, "a rigid joint is stiffer")
  expect(pressed < rigid, "compression makes it softer: %g and not less than %g Hz", pressed, rigid)
end)

-- A column of 2 m with a rigid arm of 1 m on its head: a stiff member, or a rigid link; a mass and a load at the end
-- of the arm.
local function column_with_arm(kind)
  local model = hinge.model { elements_per_member = 8 }
  local light = hinge.material { E = 210e9, density = 1 }
  local foot, head, top = model:node { 0, 0, 0 }, model:node { 0, 0, 2 }, model:node { 0, 0, 3 }
  model:fix(foot)
  model:member { foot, head, section = square, material = light }
  if kind == "member" then
    model:member { head, top, elements = 2, material = light,
      section = hinge.section.general { area = 0.1, Ix = 1e-2, Iy = 1e-2, J = 1e-2 } }
  else
    model:member { top, model:node { 0, 0.3, 3 }, section = square, material = light }
    model:rigid_link { from = head, to = top }
  end
  model:mass { node = top, mass = 100 }
  model:load { node = top, force = { 0, 0, -1 }, case = model:case "P" }
  return model
end

case("a load on the arm of a rigid link turns the node over as on a stiff member", function()
  local stiff, linked = column_with_arm "member", column_with_arm "link"
  for _, P in ipairs { 1, 10e3, 25e3 } do
    local a = stiff:static({ loads = { P = P }, steps = 4 }):finish()
    local b = linked:static({ loads = { P = P }, steps = 4 }):finish()
    -- the member at the end of the link has 1.5 kg; the stiff member bends a little
    local frequency, load = a:modes({ n = 1 })[1].frequency, P * a:buckling()[1].factor
    near(b:modes({ n = 1 })[1].frequency, frequency, 1e-3 * frequency, P .. " N: frequency, Hz")
    near(P * b:buckling()[1].factor, load, 1e-4 * load, P .. " N: buckling")
  end
  local limit = linked:static({ loads = { P = 60e3 }, steps = 60, to_limit = true }):finish()
  local loaded = linked:static({ loads = { P = 1e3 }, steps = 1 }):finish()
  -- the column shortens by 2e-4 up to there
  near(1e3 * loaded:buckling()[1].factor, 60e3 * limit.factor, 1e-3 * 60e3 * limit.factor, "statics to its limit")
  -- at rest in dynamics, too; and not before the first step
  local shaken = linked:dynamic { from = loaded, loads = { P = 1e3 }, dt = 1e-2, duration = 2e-2 }
  refused("has done no step", shaken.modes, shaken)
  local wanted = loaded:modes({ n = 1 })[1].frequency
  near(shaken:finish():modes({ n = 1 })[1].frequency, wanted, 1e-6 * wanted, "in dynamics, Hz")
end)

case("effective masses add up to the whole mass that can move, with masses on arms", function()
  -- a bent cantilever, and two masses on rigid arms that lie along no axis: all modes together have every mass
  for _, arms in ipairs { false, true } do
    local model = hinge.model { elements_per_member = 2, displacement = "small" }
    local light = hinge.material { E = 210e9, density = 1e-3 }
    local foot, knee, tip = model:node { 0, 0, 0 }, model:node { 0, 0.2, 2 }, model:node { 1.5, 0, 2 }
    model:fix(foot)
    model:member { foot, knee, section = square, material = light }
    model:member { knee, tip, section = square, material = light }
    for _, of in ipairs { { knee, 70, { 0.4, -0.3, 0.5 } }, { tip, 40, { -0.2, 0.6, 0.3 } } } do
      local at, arm = of[1], of[3]
      local where = arms and model:node { at.x + arm[1], at.y + arm[2], at.z + arm[3] } or at
      if arms then
        -- something that the node at the end of the arm belongs to
        model:member { where, model:node { where.x + 0.1, where.y, where.z }, section = square, material = light }
        model:rigid_link { from = at, to = where }
      end
      model:mass { node = where, mass = of[2] }
    end
    model:load { node = tip, force = { 0, 0, -1 } }
    local modes = model:static { steps = 1 }:finish():modes { n = 200 }
    for _, axis in ipairs { "x", "y", "z" } do
      local mass, share, product = 0, 0, 0
      for _, mode in ipairs(modes) do
        mass, share = mass + mode.mass[axis], share + mode.share[axis]
        product = product + mode.participation[axis] ^ 2
      end
      -- the members have some 20 g, of which the half next to the support cannot move
      near(mass, 110, 2e-2, ("%s, along %s: effective masses, kg"):format(arms and "arms" or "no arms", axis))
      near(share, 1, 2e-4, axis .. ": shares")
      near(product, mass, 1e-9 * mass, axis .. ": squares of the participation, modal mass 1")
    end
  end
end)

case("effective masses have the stub of a broken element, which hangs on its node as on an arm", function()
  local light, heavy = hinge.material { E = 210e9, density = 1e-3 }, hinge.material { E = 210e9, density = 7850 }
  for which = 1, 2 do
    local model = hinge.model { elements_per_member = 2 }
    local feet = { model:node { 0, 0, 0 }, model:node { 3, 0, 0 } }
    local heads = { model:node { 0, 0, 2 }, model:node { 3, 0.5, 2 } }
    model:fix(feet)
    for i = 1, 2 do model:member { feet[i], heads[i], section = square, material = light } end
    local beam = model:member { heads[1], heads[2], section = square, material = heavy, group = "beam" }
    model:load { node = heads[1], force = { 0, 0, -1 } }
    model:fracture { group = "beam", where = "all", rule = function(section) return section.element == 4 + which end }
    local run = model:dynamic { dt = 1e-5, duration = 3e-5 }:finish()
    if run:state(beam) == "broken" then
      local modes = run:modes { n = 200 }
      for _, axis in ipairs { "x", "y", "z" } do
        local mass = 0
        for _, mode in ipairs(modes) do mass = mass + mode.mass[axis] end
        local wanted = 7850 * square.area * math.sqrt(9.25)
        near(mass, wanted, 2e-3 * wanted, ("element %d broken, along %s: effective masses, kg"):format(which, axis))
      end
    else expect(false, "element %d does not break: %s", which, run:state(beam)) end
  end
end)

case("a broken beam leaves two columns", function()
  local model, node = scenes.portal { heads = "y", column = { material = steel },
    beam = { material = steel:with { density = 1e-3 } } }
  for i = 2, 3 do model:mass { node = node[i], mass = 500 } end
  model:fracture { group = "beams", where = "all", rule = function() return true end }
  local run = model:dynamic({ dt = 1e-3, duration = 2e-3 }):finish()
  equal(run:count { state = "broken", group = "beams" }, 1, "broken members")
  local k = 1 / (27 / (3 * EI) + 3 / GA)
  local wanted = math.sqrt(k / (500 + 33 / 140 * 7850 * side ^ 2 * 3)) / (2 * math.pi)
  local found = {} -- what flies has six motions of frequency 0
  for _, mode in ipairs(run:modes { n = 8 }) do
    if mode.frequency > 1e-9 then found[#found + 1] = mode.frequency end
  end
  for i = 1, 2 do near(found[i], wanted, 3e-3 * wanted, "frequency " .. i) end
end)

case("Euler's loads: cantilever with two elements, several at once, multiple ones", function()
  local euler = math.pi ^ 2 * EI / 4
  local wanted = euler / (1 + euler / GA) -- Engesser
  for _, elements in ipairs { 2, 4 } do
    local model, tip = cantilever(elements, { -1000, 0, 0 })
    local found, hidden = model:static():finish():buckling { n = 3 }
    equal(#found, 3, "modes")
    near(1000 * found[1].factor, wanted, 3e-4 * wanted, elements .. " elements: first load")
    near(found[2].factor, found[1].factor, 1e-5 * found[1].factor, "in the other plane")
    near(1000 * found[3].factor, 9 * euler / (1 + 9 * euler / GA), 2e-2 * 9 * euler, "second load")
    -- a pair between clamped ends: 4 pi^2 EI / l^2 with l of the pair
    local pair = 2 / elements
    local clamped = 4 * math.pi ^ 2 * EI / pair ^ 2
    near(hidden, clamped / (1 + clamped / GA) / 1000, 1e-6 * hidden, "what a pair does not show")
    local _, y, z = found[1]:displacement(tip)
    near(math.sqrt(y * y + z * z), 1, 1e-6, "displacement of the tip")
  end
end)

-- A portal whose beam has joints of this strength about Mx, N m, pushed beyond it; `free`: pins in their place.
local function yielded_portal(strength, displacement, free)
  local of = { section = hinge.section.box { width = 0.15, depth = 0.2, thickness = 0.008 }, material = steel }
  local joint = not free and hinge.joint { Mx = { stiffness = 1e7, strength = strength } }
  local model, node = scenes.portal { model = { displacement = displacement }, width = 5, height = 3.5,
    heads = "y,rx,rz", column = scenes.with(of, { up = { 1, 0, 0 } }),
    beam = scenes.with(of, free and { release = { a = "Mx", b = "Mx" } } or { ends = { a = joint, b = joint } }) }
  local push = model:case "push"
  push:load { node = node[2], force = { 1e3, 0, 0 } }
  push:load { node = node[3], force = { 0, 0, -1e3 } }
  model:mass { node = node[2], mass = 5000 }
  local start = model:static { loads = { push = 1 }, steps = 1, record = false }:finish()
  if free then return start end
  return start, model:static { from = start, loads = { push = 40 }, steps = 4, record = false }:finish()
end

case("joints that have yielded unload elastically in modes, whatever the rounding of their moments", function()
  local pinned = yielded_portal(0, "small", true):modes({ n = 1 })[1].frequency
  for i = 0, 11 do
    local start, there = yielded_portal(15e3 + 137.7 * i, "small")
    local elastic = start:modes({ n = 1 })[1].frequency
    near(there:modes({ n = 1 })[1].frequency, elastic, 1e-9 * elastic, "unloading, Hz")
    -- a joint that slides keeps 1e-9 of its stiffness
    near(there:modes({ n = 1, joints = "slide" })[1].frequency, pinned, 1e-5 * pinned, "sliding, Hz")
    near(start:modes({ n = 1, joints = "slide" })[1].frequency, elastic, 1e-9 * elastic, "nothing has yielded, Hz")
  end
end)

case("joints that have yielded unload elastically in buckling", function()
  local first
  for i = 0, 5 do
    local _, there = yielded_portal(15e3 + 137.7 * i, "large")
    local factor, sliding = there:buckling({ most = 1000 })[1].factor, there:buckling({ joints = "slide" })[1].factor
    first = first or factor
    near(factor, first, 0.05 * first, "factor") -- the internal forces follow the strength, by 5 % in all
    expect(sliding < 0.6 * factor, "sliding: %g, unloading: %g", sliding, factor)
  end
end)

case("two elements between stiff semi-rigid ends buckle where the beam-column does", function()
  local bar = hinge.section.solid { width = 0.06, depth = 0.06 }
  local rigid = hinge.material { E = E, G = 1e5 * E, density = 7850 }
  local bending, L = E * bar.Ix, 6
  for _, k in ipairs { 1e5, 3e5, 5e5, 1e6, 5e6, 5e7 } do -- 0.46 to 0.998 of the clamped load
    local u = last_of(math.pi / 2 + 1e-9, math.pi - 1e-12, function(x) -- tan u = -2 u EI / (k L), N = 4 u^2 EI / L^2
      return math.tan(x) + 2 * x * bending / (k * L) < 0
    end)
    local wanted = 4 * u ^ 2 * bending / L ^ 2
    for _, elements in ipairs { 2, 4 } do
      local joint = hinge.joint { Mx = { stiffness = k }, My = { stiffness = 4 * k } }
      local model, _, member = scenes.cantilever { length = L, along = { 0, 0, 1 }, head = "all", member = {
        section = bar, material = rigid, elements = elements, ends = { a = joint, b = joint } } }
      local one = { stiffness = { { 20, 1 }, { 900, 1 } }, strength = { { 20, 1 }, { 900, 1 } },
        elongation = { { 20, 0 }, { 900, 880e3 / (E * bar.area) } } } -- 1 kN a degree
      model:heat { member = member, temperature = 21, properties = one }
      local found = model:static({ steps = 1 }):finish():buckling()
      if expect(#found == 1, "%d elements, k = %g: %d modes", elements, k, #found) then
        -- four elements: the error of two elements at a quarter of their length, 1e-3
        near(1e3 * found[1].factor, wanted, 2e-3 * wanted, ("%d elements, k = %g N m"):format(elements, k))
      end
    end
  end
end)

case("a run that ends at a part of its load has its factor on the declared loads", function()
  local euler = math.pi ^ 2 * EI / 4 / (1 + math.pi ^ 2 * EI / 4 / GA)
  for _, options in ipairs { { steps = 4 }, { steps = 4, to_limit = true } } do
    local model = cantilever(4, { -2 * euler, 0, 0 })
    local run = model:static(options):finish()
    expect(run.factor < 0.51, "it ends at %g", run.factor)
    local found, hidden = run:buckling { n = 1 }
    near(found[1].factor, 0.5, 1e-3 * 0.5, "factor")
    local clamped = 4 * math.pi ^ 2 * EI / 0.5 ^ 2
    near(hidden, clamped / (1 + clamped / GA) / (2 * euler), 1e-4 * hidden, "what a pair does not show")
    equal(#run:buckling { most = 0.4 }, 0, "factors up to 0.4")
  end
  -- loads of the run before are held: the factor is on the internal forces
  local model, tip = cantilever(4, { 0, 0, 0 })
  model:load { node = tip, force = { -euler, 0, 0 }, case = model:case "P" }
  local half = model:static({ loads = { P = 0.5 } }):finish()
  near(half:buckling()[1].factor, 2, 1e-3 * 2, "half of the load")
  local more = model:static({ from = half, loads = { P = 0.8 } }):finish()
  near(more:buckling()[1].factor, 1 / 0.8, 1e-3 / 0.8, "more of it")
end)

case("buckling under a moment of fixed axis is refused where it would not buckle", function()
  -- a cantilever of a narrow bar: the symmetric part buckles at pi sqrt(E Iy G J) / L; statics finds no limit up to
  -- twice that
  local narrow = hinge.section.solid { width = 0.01, depth = 0.1 }
  local model, tip = scenes.cantilever { model = { elements_per_member = 16 }, length = 2,
    member = { section = narrow, material = steel } }
  local M = math.pi * math.sqrt(E * narrow.Iy * steel.G * narrow.J) / 2
  model:load { node = tip, moment = { 0, 0.1 * M, 0 }, case = model:case "moment" }
  model:load { node = tip, force = { 0, 0, -0.1 * M / 2 }, case = model:case "force" }
  local run = model:static({ loads = { moment = 1 }, steps = 2 }):finish()
  refused("run:buckling: moments whose axes stay as they are", run.buckling, run)
  local further = model:static({ loads = { moment = 20 }, steps = 40, to_limit = true }):finish()
  near(further.factor, 1, 1e-9, "statics finds no limit: load factor")
  -- a force has no such part: 4.013 sqrt(E Iy G J) / L^2; 16 elements are 2 % and less above it
  run = model:static({ loads = { force = 1 }, steps = 2 }):finish()
  near(0.1 * run:buckling()[1].factor, 4.013 / math.pi, 0.03 * 4.013 / math.pi, "under a force")
  -- nor has a moment in the plane of a frame that is held in it
  local frame = hinge.model { elements_per_member = 4 }
  local a, b, c = frame:node { 0, 0, 0 }, frame:node { 0, 0, 3 }, frame:node { 3, 0, 3 }
  frame:fix({ a, c }, "xyz,rx,rz")
  frame:fix(b, "y,rx,rz")
  for _, ends in ipairs { { a, b }, { b, c } } do
    frame:member { ends[1], ends[2], section = square, material = steel }
  end
  frame:load { node = b, force = { 0, 0, -1e3 } }
  local without = first_factor(frame, { steps = 2 })
  frame:load { node = b, moment = { 0, 10, 0 } }
  near(first_factor(frame, { steps = 2 }), without, 0.01 * without, "a moment in the plane")
end)

case("a ring under pressure that stays normal to it: one factor, whatever part of the pressure acts", function()
  local I, members = 1e-10, 16
  local thin = hinge.section.general { area = 1e-2, Ix = I, Iy = 1e3 * I, J = I, shear_area_x = 0.1,
    shear_area_y = 0.1 }
  for axes, wanted in pairs { ["local"] = 3, global = 4 } do
    for _, part in ipairs { 0.01, 0.5, 0.9 } do
      local model, n = hinge.model { plasticity = false }, {}
      for i = 0, members do
        local t = math.pi / 2 * i / members
        n[i] = model:node { math.cos(t), 0, math.sin(t) }
        model:fix(n[i], i == 0 and "y,z,rx,ry,rz" or i == members and "x,y,rx,ry,rz" or "y,rx,rz")
        if i > 0 then
          local middle, q = t - math.pi / 4 / members, part * wanted * 206e9 * I
          local out = { math.cos(middle), 0, math.sin(middle) }
          local member = model:member { n[i - 1], n[i], section = thin, material = hinge.material { E = 206e9 },
            up = out }
          model:load { member = member, axes = axes,
            q = axes == "local" and { 0, -q, 0 } or { -q * out[1], 0, -q * out[3] } }
        end
      end
      -- 16 straight members a quarter are 0.4 % above Levy's 3 EI / R^3, and 4 of a pressure that keeps its direction
      near(part * first_factor(model, { steps = 4 }), 1, 7e-3, ("%s axes, %g of it"):format(axes, part))
    end
  end
end)

case("a hot column buckles with the stiffness of hot steel", function()
  local factors = {}
  for i, temperature in ipairs { 20, 600 } do
    local model, _, member = cantilever(4, { -1e3, 0, 0 })
    model:heat { member = member, temperature = temperature }
    factors[i] = first_factor(model)
  end
  near(factors[2], 0.31 * factors[1], 1e-6 * factors[1], "k_E of EN 1993-1-2, table 3.1") -- where it is declared
end)

case("a portal on pinned feet, and one with a semi-rigid beam", function()
  -- sway: alpha tan(alpha) = 6 c / EI_c h with the rotational stiffness of the joints c; alpha = h sqrt(P / EI)
  local function by_hand(r)
    return last_of(1e-6, math.pi / 2 - 1e-9, function(alpha) return alpha * math.tan(alpha) < r end) ^ 2 * EI / 9
  end
  local rigid = hinge.material { E = E, G = 1e6 * E, density = 7850 } -- in shear
  for _, joint in ipairs { math.huge, 2 * EI } do
    local ends = joint < math.huge and hinge.joint { Mx = { stiffness = joint } } or nil
    local model, node = scenes.portal { feet = "x,y,z,rx,rz", heads = "y", column = { material = rigid },
      beam = { material = rigid, ends = ends and { a = ends, b = ends } } }
    for i = 2, 3 do model:load { node = node[i], force = { 0, 0, -100 } } end
    local c = 1 / (4 / (6 * EI) + (joint < math.huge and 1 / joint or 0)) -- the beam bends in an S
    local found = model:static():finish():buckling()
    equal(#found, 1, "modes")
    local wanted = by_hand(c * 3 / EI)
    near(100 * found[1].factor, wanted, 1e-3 * wanted, "load with joints of " .. joint)
  end
end)

-- A straight column of two members between pins, pressed to a part of Euler's load; the model, the node in its middle.
local function pinned_column(part)
  local model = hinge.model { elements_per_member = 8 }
  local P = model:case "P"
  local foot, middle, head = model:node { 0, 0, 0 }, model:node { 0, 0, 1 }, model:node { 0, 0, 2 }
  model:fix(foot, "xyz,rz")
  model:fix({ middle, head }, "y")
  model:fix(head, "x")
  local slender = hinge.section.solid { width = 0.02, depth = 0.02 }
  -- rigid in shear
  model:line { foot, middle, head, section = slender, material = hinge.material { E = E, G = 1e4 * E, density = 7850 } }
  model:load { node = head, force = { 0, 0, -math.pi ^ 2 * E * slender.Ix / 4 }, case = P }
  local pressed = model:static { steps = 4, loads = { P = part } }:finish()
  return model, middle, pressed, pressed:buckling({ n = 1 })[1]
end

-- The elastica between pins: P over Euler's load where its middle is off by w of its length. With k = sin(alpha / 2),
-- alpha the rotation of an end: P = (2 K(k) / pi)^2 and w = k / K(k).
local function elastica(w)
  local function K(k)
    local a, b = 1, math.sqrt(1 - k ^ 2)
    for _ = 1, 30 do a, b = (a + b) / 2, math.sqrt(a * b) end
    return math.pi / 2 / a
  end
  return (2 * K(last_of(0, 0.9, function(k) return k / K(k) < w end)) / math.pi) ^ 2
end

case("a branch: a straight column buckles to either side and follows the elastica", function()
  for _, side_of in ipairs { 1, -1 } do
    local model, middle, pressed, mode = pinned_column(0.98)
    local run = model:static { from = pressed, loads = { P = 2 }, branch = mode, steps = 12,
      control = { node = middle, "ux", to = 0.72 * side_of } }
    local steps = 0
    for step in run:steps() do
      local w = middle:displacement(run) / 2
      equal(w * side_of > 0, true, "side")
      local P, exact = 0.98 + 1.02 * step.factor, elastica(math.abs(w))
      -- (pi / n)^2 / 12 of 16 elements, times what the ends have turned
      near(P, exact, 4e-4 * exact, ("load at w / L = %.3f"):format(w))
      steps = steps + 1
    end
    equal(run.verdict, "completed", run.reason)
    equal(steps, 12, "steps")
  end
end)

case("a branch is refused where it cannot be followed", function()
  local model, middle, pressed, mode = pinned_column(0.9)
  local drive, other = { node = middle, "ux", to = 0.1 }, first_mode((cantilever(4, { 0, 0, -1 })))
  for _, row in ipairs {
    { "must be a shape of run:buckling or run:modes", 3, drive },
    { "goes with control = { node =", mode },
    { "goes with control = { node =", mode, "arc" },
    { "does not move what 'control' drives", mode, { node = middle, "uz", to = 0.1 } },
    { "a shape of 5 nodes; must be of this structure, which has 17", other, drive },
  } do
    refused(row[1], model.static, model, { from = pressed, loads = { P = 2 }, branch = row[2], control = row[3] })
  end
end)

case("pictures of a shape", function()
  local run = cantilever(4, { -1, 0, 0 }):static():finish()
  local mode = run:modes({ n = 1 })[1]
  expect(tostring(mode):find "natural mode of 40.99", "text: %s", mode)
  equal(tostring(mode:snapshot(0.2)):match "^[%w.]*", "hinge.snapshot", "a snapshot")
  expect(tostring(run:buckling()[1]):find "buckling mode at factor", "text")
end)

local frames_script = [[
local hinge = require "hinge"
return hinge.scenario { run = function(_, job)
  local model = hinge.model {}
  local wall, tip = model:node { 0, 0, 0 }, model:node { 1, 0, 0 }
  model:fix(wall, "all")
  model:fix(tip, "y")
  model:member { wall, tip, section = hinge.section.solid { width = 0.05, depth = 0.05 },
    material = hinge.material { E = 206e9, density = 7850 }, elements = 8 }
  local mode = model:static():finish():modes { n = 1 }[1]
  job:animate(mode, { frames = 8, amplitude = 0.2 })
  print("period " .. mode.period)
end }
]]

case("an animation: one period in frames of equal steps, the largest displacement as given", function()
  local build = arg[1]
  if not support.is_there(build .. "/libhinge_output.so") then return print "without pictures: not looked at" end
  local folder = support.temporary_folder()
  support.write(folder .. "/animate.lua", frames_script)
  local status, printed, complaint = support.run(("cd %s && %s run -q animate.lua --out out && %s render out --gif")
    :format(support.quote(folder), support.quote(build .. "/hinge"), support.quote(build .. "/hinge")))
  equal(status, 0, complaint)
  local period = tonumber(printed:match "period (%S+)")
  local listed, k = support.read(folder .. "/out/frames.pvd") or "", 0
  for time in listed:gmatch 'timestep="([^"]*)"' do
    near(tonumber(time), k * period / 8, 1e-12, "time of frame " .. k + 1)
    k = k + 1
  end
  equal(k, 8, "frames")
  expect((support.read(folder .. "/out/film.gif") or ""):find "^GIF89a", "the film")
  for i, wanted in ipairs { 0, math.sqrt(0.5), 1, math.sqrt(0.5), 0, math.sqrt(0.5), 1, math.sqrt(0.5) } do
    local box = "return table.concat(require('hinge.core').frame_box('%s/out/frames/frame_%05d.vtp', {}).box, ' ')"
    local numbers = support.output(("%s do %s"):format(support.quote(build .. "/hinge"),
      support.quote(box:format(folder, i))))
    local low, high = numbers:match "^%S+ %S+ %S+ %S+ (%S+) (%S+)%s*$"
    local up = support.largest_of(math.abs(tonumber(low) or 0 / 0), math.abs(tonumber(high) or 0 / 0))
    near(up, 0.2 * wanted, 1e-6, "largest displacement in frame " .. i)
  end
end)

case("wrong input is refused", function()
  local run = cantilever(2, { -1, 0, 0 }):static()
  refused("carry nothing", run.buckling, run)
  run:finish()
  refused("field 'n' is 0", run.modes, run, { n = 0 })
  refused("count", run.modes, run, { count = 3 })
  refused("field 'most' is -1", run.buckling, run, { most = -1 })
  equal(run:modes({ n = 1 })[1].factor, nil, "a natural mode has no factor")
  equal(run:buckling()[1].frequency, nil, "a buckling mode has no frequency")
  refused("frequencies", function() return run:buckling()[1].frequencies end)
  run = cantilever(2, { -1, 0, 0 }, nil, { displacement = "small" }):static():finish()
  refused("displacement = 'small'", run.buckling, run)
  run = cantilever(2, { -1, 0, 0 }, hinge.material { E = E }):static():finish()
  refused("has mass", run.modes, run)
end)

checks.done()
