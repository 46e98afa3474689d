-- Joints of member ends: pins, semi-rigid and partial-strength joints by closed forms, with any number of elements;
-- cycles, breaking, the energy balance, floors that are rigid in their plane, checkpoints; wrong input is refused.
--
-- Run: lua5.4 tests/script/joints/joints_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local hinge = require "hinge"
local scenes = require "scenes"
local with = scenes.with
local checks = support.checks "joints"
local case, near, equal, expect = checks.case, checks.near, checks.equal, checks.expect

local E, side, g = 206e9, 0.05, 9.81
local EI = E * side ^ 4 / 12
-- rigid in shear, so that the sums of beams by hand are exact
local stiff = hinge.material { E = E, G = 1e6 * E, density = 7850 }
local steel = hinge.material { E = E, density = 7850 }
local square = scenes.square
local small = { displacement = "small" }

-- A beam of 2 m between two walls, under a load along it.
local function beam(options, elements)
  local model, tip, member, wall = scenes.cantilever { length = 2, member = with({ material = stiff }, options),
    model = { displacement = "small", elements_per_member = elements } }
  model:fix(tip)
  model:load { member = member, q = { 0, 0, -100 } }
  return member, model:static():finish(), wall
end

case("pins and semi-rigid ends of a loaded beam by hand, with 2, 4 and 8 elements", function()
  local q, L = 100, 2
  local off = 1e-6 * q * L ^ 2 -- of the solution, with axes that are 1000 times as stiff as the member
  for _, elements in ipairs { 2, 4, 8 } do
    local what = elements .. " elements: "
    local a, b = beam({ release = { a = "Mx", b = { "Mx", "My" } } }, elements):forces()
    near(a.Mx, 0, off, what .. "moment at a pin")
    near(math.abs(a.Qy) + math.abs(b.Qy), q * L, off, what .. "shear forces of a simple beam")
    a, b = beam({ release = { b = "Mx" } }, elements):forces()
    near(math.abs(a.Mx), q * L ^ 2 / 8, 1e-6 * q * L ^ 2, what .. "q L^2 / 8 where the other end is pinned")
    near(b.Mx, 0, off, what .. "its pin")
    local k = 3 * EI / L
    local member, _, node = beam({ ends = { a = hinge.joint { Mx = { stiffness = k } },
      b = hinge.joint { Mx = { stiffness = k } } } }, elements)
    local M = q * L ^ 2 / 12 / (1 + 2 * EI / (k * L))
    near(math.abs(member:forces().Mx), M, off, what .. "semi-rigid ends")
    local joint = member:joint "a"
    near(math.abs(joint.Mx), M, off, what .. "moment of the joint")
    near(math.abs(joint.rotation_x), M / k, off / k, what .. "its rotation")
    near(joint.shear, q * L / 2, off, what .. "its shear force")
    equal(joint.broken, false, what .. "broken")
    local _, _, z, _, my = node:reaction()
    near(z, q * L / 2, off, what .. "reaction of a support that has only a joint")
    near(math.abs(my), M, off, what .. "its moment")
  end
  equal(beam({}, 2):joint "a", nil, "an end without a joint has none")
end)

-- The head of a column of 3 m on a rotational spring k, under H across and P along it: by the exact beam-column.
local function sway_by_hand(H, P, k)
  local L, beta = 3, math.sqrt(P / EI)
  local D = H * math.sin(beta * L) / (P * beta) / (math.cos(beta * L) / P - math.sin(beta * L) / (k * beta))
  return (D - H * L) / P
end

case("a column on a semi-rigid base under compression: the exact beam-column, two elements", function()
  local k = 2 * EI / 3
  -- the smallest root of k L / EI = alpha tan(alpha), alpha = L sqrt(P / EI), with k L / EI = 2
  local critical = 1.0768740 ^ 2 * EI / 9
  for _, part in ipairs { 0.3, 0.6, 0.9 } do
    local model, head = scenes.cantilever { along = { 0, 0, 1 }, length = 3, force = { 1, 0, -part * critical },
      member = { material = stiff, ends = { a = hinge.joint { Mx = { stiffness = k }, My = { stiffness = k } } } } }
    equal(model:static { steps = 4, tolerance = 1e-10 }:finish().verdict, "completed", "static run")
    local by_hand = sway_by_hand(1, part * critical, k)
    near(head:displacement(), by_hand, 5e-4 * by_hand, ("sway at %g of the critical load"):format(part))
  end
end)

case("a portal whose beam is pinned: two cantilevers", function()
  local pinned = { "Mx", "My" }
  local model, node = scenes.portal { model = small, width = 5, column = { material = stiff },
    beam = { material = stiff, release = { a = pinned, b = pinned } } }
  model:load { node = node[2], force = { 100, 0, 0 } }
  model:static():finish()
  local sway = 50 * 3 ^ 3 / (3 * EI)
  -- the beam's own shortening is 2.4e-4 of the sway of a square of 50 mm
  near((node[2]:displacement() + node[3]:displacement()) / 2, sway, 1e-6 * sway, "sway")
end)

-- A nearly rigid arm of 1 m on a joint, whose tip moves to each of these heights.
local function cycle(points, heights)
  local rigid = hinge.material { E = 1e6 * E, G = 1e6 * E, density = 7850 }
  local model, tip, arm = scenes.cantilever { model = small, force = { 0, 0, 1 },
    member = { material = rigid, ends = { a = hinge.joint { Mx = { points = points } } } } }
  local run, forces = nil, {}
  for i, z in ipairs(heights) do
    run = model:static { from = run, steps = 20, control = { node = tip, "uz", to = z } }:finish()
    equal(run.verdict, "completed", "static run: " .. tostring(run.reason))
    forces[i] = run.factor
  end
  return forces, run, arm
end

case("cycles follow Masing's rule and dissipate the loop", function()
  local points = { { 0.002, 200 }, { 0.006, 400 }, { 0.016, 500 } }
  local forces, run, arm = cycle(points, { 0.004, 0.02, -0.02, 0.02, 0.02 - 0.008 })
  local tolerance = 1e-3 -- the arm bends a little
  near(forces[1], 300, tolerance * 300, "on the second part of the curve")
  near(forces[2], 500, tolerance * 500, "beyond the last point")
  near(forces[3], -500, tolerance * 500, "the other way")
  near(forces[4], 500, tolerance * 500, "back")
  -- unloading is the curve at twice the scale: 2 x 0.004 rad take 2 x 300 N m off
  near(forces[5], 500 - 2 * 300, tolerance * 600, "unloading by twice the curve")
  near(arm:joint("a").Mx, -forces[5], 1e-6 * 500, "moment of the joint")
  -- from -0.02 to 0.02 rad each slider moves beyond twice its yield rotation, at its strength
  local strengths = { (200 / 0.002 - 200 / 0.004) * 0.002, (200 / 0.004 - 100 / 0.01) * 0.006, 100 / 0.01 * 0.016 }
  local half = 0
  for i, point in ipairs(points) do half = half + strengths[i] * 2 * (0.02 - point[1]) end
  local _, back = cycle(points, { 0.02, -0.02, 0.02 })
  near(back.energy.joint_dissipated, half, 2e-3 * half, "half a loop")
  near(back.energy.energy_error, 0, 1e-2 * half, "energy error: steps across the corners of the curve")
  near(run.energy.energy_error, 0, 1e-6 * half, "energy error of a run whose corners are at ends of steps")
end)

-- A bar of 1 m that swings down from a wall.
local function pendulum(joint, options)
  local model, tip, bar = scenes.cantilever { member = { material = steel, ends = { a = hinge.joint(joint) } } }
  model:gravity { 0, 0, -g }
  return model:dynamic(with({ dt = 1e-3, duration = 1 }, options)), bar, tip
end
local mass = 7850 * side ^ 2

case("a pendulum swings through the lowest point with all of its energy", function()
  for integrator, options in pairs { newmark = {}, explicit = { dt = "auto", duration = 0.7 } } do
    options.integrator = integrator
    local run, _, tip = pendulum({ Mx = "free" }, options)
    local lowest = 0
    for _ in run:steps() do lowest = support.smallest_of(lowest, (select(3, tip:displacement()))) end
    equal(run.verdict, "completed", integrator .. ": " .. tostring(run.reason))
    near(lowest, -1, 1e-3, integrator .. ": lowest point")
    near(run.energy.energy_error, 0, 1e-4 * mass * g, integrator .. ": energy error")
    local x, y = tip:position()
    near(x * x + y * y + select(3, tip:position()) ^ 2, 1, 1e-4, integrator .. ": distance from the wall")
  end
end)

case("a plastic joint brings it to rest, and takes its energy", function()
  local run, bar = pendulum({ Mx = { stiffness = 1e5, strength = 60 } }, { duration = 3 })
  run:finish()
  equal(run.verdict, "completed", tostring(run.reason))
  local energy = run.energy
  near(energy.joint_dissipated, -energy.gravity, 2e-3 * mass * g, "plastic work")
  near(energy.energy_error, 0, 1e-3 * mass * g, "energy error")
  -- the rotation at which the work of the constant moment is that of the weight: 60 phi = m g / 2 sin(phi) is at 1.6
  -- or beyond, where the moment of the weight is less than the joint holds
  expect(math.abs(bar:joint("a").rotation_x) > 1.5, "rotation %g rad", bar:joint("a").rotation_x)
end)

case("it breaks by rotation, tension and shear, falls freely, and keeps the energy balance", function()
  local rotation = { Mx = { stiffness = 1e5, strength = 60, capacity = 0.5 } }
  for what, joint in pairs { rotation = rotation, tension = { Mx = "free", tension = 250 },
    ["shear force"] = { Mx = "free", shear = 120 } } do
    local run, bar, tip = pendulum(joint)
    run:finish()
    equal(run.verdict, "completed", what .. ": " .. tostring(run.reason))
    local broken = bar:joint("a").broken
    expect(broken and broken < 0.6, "%s: broken at %s", what, broken)
    local told = false
    for _, change in ipairs(run.state_changes) do
      told = told or change.effect == "joints" and support.has(change.why, "end a of member 1 broke: " .. what)
    end
    expect(told, "%s: run.state_changes tells of it", what)
    near(run.energy.energy_error, 0, 2e-3 * mass * g, what .. ": energy error")
    equal(bar:joint("a").shear, 0, what .. ": a broken joint carries nothing")
    local falls = run:momentum().linear[3]
    expect(falls < -0.9 * mass * g * (1 - broken), "%s: momentum %g", what, falls)
    expect((select(3, tip:displacement())) < -1, "%s: the tip has fallen", what)
  end
end)

case("statics breaks no joint, and warns", function()
  local model = scenes.cantilever { force = { 0, 0, -60 },
    member = { material = steel, ends = { a = hinge.joint { shear = 50 } } } }
  local run = model:static():finish()
  equal(run.verdict, "completed", "verdict")
  expect(support.has(table.concat(run.warnings, "\n"), "is beyond its capacity: shear force of 60"), "warnings: %s",
    table.concat(run.warnings, "\n"))
end)

case("pinned beams in a floor that is rigid in its plane", function()
  local function floor(integrator)
    local model = hinge.model { displacement = integrator and "large" or "small" }
    local heads, pinned = {}, { "Mx", "My" }
    for _, x in ipairs { 0, 4 } do
      for _, y in ipairs { 0, 4 } do
        local foot, head = model:node { x, y, 0 }, model:node { x, y, 3 }
        model:fix(foot)
        model:member { foot, head, section = square, material = steel }
        heads[#heads + 1] = head
      end
    end
    for _, pair in ipairs { { 1, 2 }, { 3, 4 }, { 1, 3 }, { 2, 4 } } do
      model:member { heads[pair[1]], heads[pair[2]], section = square, material = steel,
        release = { a = { "Mx", "My", "Mz" }, b = pinned } }
    end
    model:diaphragm { nodes = heads }
    model:load { node = heads[1], force = { 100, 0, 0 } }
    local run = integrator and model:dynamic { dt = 1e-3, duration = 0.1, integrator = integrator }:finish()
      or model:static():finish()
    equal(run.verdict, "completed", "run: " .. tostring(run.reason))
    return heads, run
  end
  -- a quarter of the load each; and the load's moment about the middle, 2 m away, on columns that sway and twist
  local G = E / 2.6
  local one = 27 / (3 * EI) + 3 / (5 / 6 * G * side ^ 2)
  local twist = 4 * 8 / one + 4 * G * 0.140577 * side ^ 4 / 3
  local wanted = 100 * (one / 4 + 2 * 2 / twist)
  local heads = floor()
  near(heads[1]:displacement(), wanted, 1e-4 * wanted, "sway of the loaded corner")
  local _, run = floor "newmark"
  near(run.energy.energy_error, 0, 1e-4 * run.energy.work, "energy error")
end)

-- In explicit steps rigid axes are springs of another stiffness.
case("a beam at rest stays at rest in the run that goes on from statics", function()
  for _, integrator in ipairs { "newmark", "explicit" } do
    local model, tip = scenes.cantilever { force = { 0, 500, -300 }, member = { material = steel, -- My, Mz are rigid
      ends = { a = hinge.joint { Mx = { stiffness = 1e5 } } } } }
    local rest = model:static():finish()
    local _, y = tip:displacement(rest)
    local run = model:dynamic { from = rest, dt = integrator == "explicit" and "auto" or 1e-4, duration = 2e-3,
      integrator = integrator }:finish()
    local _, now = tip:displacement(run)
    near(now, y, 1e-5 * y, integrator .. ": deflection about the rigid axis")
  end
end)

-- A portal whose columns have joints at their feet, under an acceleration of 20 m/s^2 from the right: its weight
-- (nil), or ground that moves, with a path. Nearly all of its mass is at the heads of the columns.
local function accelerated(moves, capacity, integrator, duration)
  local light = hinge.material { E = 210e9, density = 50, yield_stress = 235e6 }
  local base = hinge.joint { Mx = { points = { { 0.002, 40e3 }, { 0.01, 80e3 } }, capacity = capacity }, My = "free" }
  local post = { section = hinge.section.named "HEB 200", material = light }
  local model, node, member = scenes.portal { width = 6, beam = post,
    column = with(post, { up = { 1, 0, 0 }, ends = { a = base } }) }
  for i = 2, 3 do model:mass { node = node[i], mass = 5000 } end
  if moves then model:move { node = { node[1], node[4] }, x = function(t) return 10 * t ^ 2 end }
  else model:gravity { -20, 0, 0 } end
  local run = model:dynamic { dt = integrator == "explicit" and "auto" or 2.5e-4, duration = duration,
    integrator = integrator }
  return run, node[3], member[1], node[1]
end

case("joints at feet that move: as in a frame of reference that is accelerated", function()
  for _, integrator in ipairs { "newmark", "explicit" } do
    for _, capacity in ipairs { math.huge, 0.03 } do
      local what = ("%s, %s: "):format(integrator, capacity < 1 and "joints that break" or "joints that hold")
      local function ended(moves)
        local run, head, left, foot = accelerated(moves, capacity < 1 and capacity or nil, integrator, 0.3)
        run:finish()
        equal(run.verdict, "completed", what .. "run")
        return head:displacement(run) - (moves and 10 * run.time ^ 2 or 0), run, left:joint("a", run),
          (foot:reaction(run))
      end
      local by_weight, rest, at_rest, held = ended()
      local by_ground, run, moved, pushed = ended(true)
      expect(run.energy.joint_dissipated > 500, "%splastic work of %g J", what, run.energy.joint_dissipated)
      -- The columns yield and swing; masses that differ by 1e-8 scatter by 0.25 % in explicit steps.
      local apart = integrator == "explicit" and 0.006 or 0.002
      near(by_ground, by_weight, apart * math.abs(by_weight), what .. "displacement of a head")
      near(run.energy.joint_dissipated, rest.energy.joint_dissipated, 0.006 * rest.energy.joint_dissipated,
        what .. "plastic work")
      -- of Newmark's steps through the break: 17 J here, 37 J where the weight of 129 kJ does it
      near(run.energy_error, 0, capacity < 1 and 4e-3 or 1e-5, what .. "energy error")
      equal(moved.broken and true or false, capacity < 1, what .. "the joint broke")
      if capacity < 1 then
        near(moved.broken, at_rest.broken, 0.002, what .. "when it broke")
        equal(pushed, 0, what .. "force of a support that has lost its joint")
      else
        near(moved.shear, at_rest.shear, 0.02 * at_rest.shear, what .. "shear force of the joint")
        near(pushed, held, 0.02 * math.abs(held), what .. "force of the support")
      end
    end
  end
end)

case("tension takes from the moment: M / M_R + T / T_R is 1", function()
  for _, part in ipairs { 0, 0.25, 0.75, -0.5 } do
    local joint = hinge.joint { Mx = { points = { { 0.004, 60e3 }, { 0.02, 100e3 } } }, tension = 200e3,
      interaction = "linear" }
    local model, tip, arm = scenes.cantilever { model = small, length = 2, member = { up = { 0, 0, 1 },
      ends = { a = joint }, section = hinge.section.named "IPE 360",
      material = hinge.material { E = 210e9, density = 7850 } } }
    model:case "pull":load { node = tip, force = { 200e3 * part, 0, 0 } }
    model:case "push":load { node = tip, force = { 0, 0, -1e3 } }
    local pulled = model:static { loads = "pull", steps = 2 }:finish()
    local run = model:static { from = pulled, loads = { push = 1 }, steps = 40,
      control = { node = tip, "uz", to = -0.1 } }:finish()
    local what, left = ("T / T_R = %g: "):format(part), math.min(1, 1 - part)
    near(math.abs(arm:joint("a").Mx), left * 100e3, 1, what .. "moment")
    near(arm:joint("a").tension, 200e3 * part, 1, what .. "tension, which stays")
    -- two sliders: 2.5e6 N m/rad up to left x 50 kN m, 12.5e6 N m/rad up to left x 50 kN m
    local turned = math.abs(arm:joint("a").rotation_x)
    local work = left * 50e3 * (turned - left * 0.02) + left * 50e3 * (turned - left * 0.004)
    near(run.energy.joint_dissipated, work, 0.005 * work, what .. "plastic work")
    near(run.energy_error, 0, 2e-3, what .. "energy error") -- of 40 steps through the corners of the curve
  end
end)

case("a beam that hangs between joints: the energy closes while tension grows", function()
  local errors = {}
  for i, dt in ipairs { 4e-4, 1e-4 } do
    local joint = hinge.joint { Mx = { stiffness = 2e7, strength = 40e3 }, tension = 600e3, interaction = "linear" }
    local girder = hinge.section.named "IPE 200"
    local model, right, hung = scenes.cantilever { length = 6, member = { section = girder, elements = 4,
      ends = { a = joint, b = joint }, material = hinge.material { E = 210e9, density = 3e3 / g / girder.area } } }
    model:fix(right)
    model:gravity { 0, 0, -8 * g }
    model:damping { ratio = 0.05, periods = { 0.2, 0.01 } } -- of the ringing along the beam
    local run = model:dynamic { dt = dt, duration = 0.2 }
    -- the tension that counts follows that of the member with the delay of an axial wave
    local wave = 6 * math.sqrt(3e3 / g / girder.area / 210e9)
    local pull, at, deepest, past = 0, 0, 0, 0
    while run:step() do
      local now = hung:joint("a", run)
      past = support.largest_of(past, math.abs(now.Mx) - 40e3 * math.min(1, 1 - pull / 600e3))
      pull = pull + math.min(1, (run.time - at) / wave) * (now.tension - pull)
      at = run.time
      deepest = support.largest_of(deepest, now.tension)
    end
    equal(run.verdict, "completed", "run")
    expect(deepest > 100e3 and deepest < 600e3, "largest tension %g N", deepest)
    near(past, 0, 1e-3, "moment beyond that which the tension leaves, N m")
    errors[i] = math.abs(run.energy_error)
  end
  near(errors[1], 0, 3e-4, "energy error")
  expect(errors[2] < 0.5 * errors[1], "energy error %g in a quarter of the step, %g before", errors[2], errors[1])
end)

case("runs with joints, also at feet that move, go on from a checkpoint to the same energies", function()
  local file = support.temporary_folder() .. "/half"
  for steps, make in pairs {
    [200] = function() return (pendulum { Mx = { points = { { 6e-4, 60 }, { 0.01, 70 } }, capacity = 0.7 } }) end,
    [100] = function() return (accelerated(true, nil, "newmark", 0.1)) end,
  } do
    local whole, first = make():finish(), make()
    for _ = 1, steps do first:step() end
    first:checkpoint(file)
    local second = make():resume(file):finish()
    for _, of in ipairs { "work", "kinetic", "joint_dissipated" } do equal(second.energy[of], whole.energy[of], of) end
    equal(#second.state_changes, #whole.state_changes, "what has happened")
  end
end)

-- A cross of half storeys and half spans with a node for the beams where they meet the columns, if there is a joint:
-- pinned at the foot, on rollers at the ends of the beams. F at the head; what the run is.
local cross_height, cross_span = 3.5, 6
local function cross(joint, F, options)
  local model = hinge.model { displacement = options.displacement or "small", elements_per_member = options.elements }
  local H, L = cross_height, cross_span
  local foot, middle, head = model:node { 0, 0, 0 }, model:node { 0, 0, H / 2 }, model:node { 0, 0, H }
  local left, right = model:node { -L / 2, 0, H / 2 }, model:node { L / 2, 0, H / 2 }
  local beams_at = joint and model:node { 0, 0, H / 2 } or middle
  model:fix(foot, "x,y,z,rx,rz")
  model:fix({ left, right }, "y,z,rx,rz")
  model:fix(head, "y,rx,rz")
  local post, girder = hinge.section.named "HEB 300", hinge.section.named "IPE 450"
  for _, ends in ipairs { { foot, middle }, { middle, head } } do
    model:member { ends[1], ends[2], section = post, material = steel, up = { 1, 0, 0 } }
  end
  local left_beam = model:member { left, beams_at, section = girder, material = steel, ends = options.ends }
  model:member { beams_at, right, section = girder, material = steel }
  local panel = joint and model:joint { middle, beams_at, joint = joint, axes = { x = { 0, 1, 0 }, y = { 0, 0, 1 } } }
  if options.dynamic then
    model:mass { node = head, mass = 20e3 }
    model:velocity(head, { F, 0, 0 })
    return model:dynamic { dt = options.dt or 2e-4, duration = options.dynamic, integrator = options.integrator }, head,
      panel, left_beam, beams_at, middle
  end
  model:load { node = head, force = { F, 0, 0 } }
  return model:static { steps = options.steps }:finish(), head, panel, left_beam
end

case("a joint between nodes: the drift of a cross grows by F H / K", function()
  for _, displacement in ipairs { "small", "large" } do
    for _, elements in ipairs { 2, 4 } do
      local F, K, H = displacement == "small" and 30e3 or 300, 1e8, cross_height
      local options = { displacement = displacement, elements = elements }
      local _, head = cross(nil, F, options)
      local rigid = head:displacement()
      local run, other, panel = cross(hinge.joint { Mx = { stiffness = K } }, F, options)
      local what = ("%s, %d elements: "):format(displacement, elements)
      near(other:displacement() - rigid, F * H ^ 2 / K, 1e-4 * F * H ^ 2 / K, what .. "drift by the joint")
      local now = panel:state(run)
      near(math.abs(now.Mx), F * H, 1e-4 * F * H, what .. "its moment")
      near(math.abs(now.rotation_x), F * H / K, 1e-4 * F * H / K, what .. "its rotation")
      equal(now.broken, false, what .. "broken")
      expect(now.shear == nil, "a joint between nodes tells of a shear force")
    end
  end
  equal(tostring(select(3, cross(hinge.joint { Mx = { stiffness = 1e8 } }, 1, {}))),
    "the joint between nodes 2 and 6", "text")
end)

case("a joint between nodes that is plastic, and one that breaks: the energy closes", function()
  for _, integrator in ipairs { "newmark", "explicit" } do
    for _, capacity in ipairs { math.huge, 0.02 } do
      local joint = hinge.joint { Mx = { points = { { 1.7e-3, 190e3 }, { 6.8e-3, 230e3 } },
        capacity = capacity < 1 and capacity or nil } }
      local run, _, panel, _, beams_at, middle = cross(joint, 3, { dynamic = 0.2, integrator = integrator,
        dt = integrator == "explicit" and "auto" or nil, displacement = "large" })
      run:finish()
      local what = ("%s, capacity %g rad: "):format(integrator, capacity)
      equal(run.verdict, "completed", what .. "run")
      near(run.energy_error, 0, 1e-3, what .. "energy error")
      local at = panel:state().broken
      if capacity < 1 then
        expect(at and at > 0.01 and at < 0.1, "%sbroke at %s s", what, at)
        near(panel:state().Mx, 0, 0, what .. "its moment then")
        local apart = math.abs((beams_at:displacement(run)) - middle:displacement(run))
        expect(apart > 0.01, "%sthe beams stay at the column: %g m", what, apart)
      else
        expect(run.energy.joint_dissipated > 1e4, "%splastic work of %g J", what, run.energy.joint_dissipated)
        expect(not at, "%sbroke", what)
      end
    end
  end
end)

case("a member's joint at a node that a joint joins", function()
  -- both in a row: the flexibilities of this side add up
  local F, K, H = 20e3, 1e8, cross_height
  local _, head = cross(nil, F, {})
  local rigid = head:displacement()
  local both, moved, panel, pinned = cross(hinge.joint { Mx = { stiffness = K } }, F,
    { ends = { b = hinge.joint { Mx = "free" } } })
  near(pinned:joint("b", both).Mx, 0, 1, "moment at the pin")
  near(math.abs(panel:state(both).Mx), F * H, 1e-4 * F * H, "moment of the panel")
  expect(moved:displacement() > 1.3 * rigid + F * H ^ 2 / K, "drift with a pin")
  near(pinned:joint("b", both).shear, 0, 1, "shear force of the pinned beam, without load")
end)

case("a joint between nodes at a foot that moves: as the joint of a member there", function()
  local function column(node_joint)
    local model = hinge.model { displacement = "small" }
    local foot, head = model:node { 0, 0, 0 }, model:node { 0, 0, 3 }
    local joint = hinge.joint { Mx = { stiffness = 3e6 }, My = { stiffness = 2e6 } }
    local axes = { x = { 0, 1, 0 }, y = { -1, 0, 0 } }
    model:fix(foot)
    local stump = model:node { 0, 0, -0.5 } -- of the same column, below the foot
    model:fix(stump)
    model:member { stump, foot, section = square, material = steel }
    local from = foot
    if node_joint then
      from = model:node { 0, 0, 0 }
      model:joint { foot, from, joint = joint, axes = axes }
    end
    model:member { from, head, section = square, material = steel, up = { 1, 0, 0 },
      ends = not node_joint and { a = joint } or nil }
    model:mass { node = head, mass = 100 }
    model:move { node = { foot, stump }, x = function(t) return 0.01 * math.sin(20 * t) end }
    local run = model:dynamic { dt = 1e-3, duration = 0.5 }:finish()
    return head:displacement(run), run, (foot:reaction(run))
  end
  local by_end, run, held = column(false)
  local by_node, other, pushed = column(true)
  near(by_node, by_end, 2e-4 * math.abs(by_end), "displacement of the head")
  near(other.energy_error, 0, 1e-6, "energy error")
  near(other.energy.work, run.energy.work, 1e-3 * math.abs(run.energy.work), "work of the support")
  near(pushed, held, 1e-3 * math.abs(held), "reaction")
end)

case("a member tells of its joints, and copies of a grid have them", function()
  local plan = hinge.grid { model = hinge.model(), x = { 0, 4 }, z = { 0, 3 } }
  plan:defaults { section = square, material = steel, group = "beams", release = { a = "Mx", b = "Mx" } }
  plan:defaults { group = "columns", section = square, material = steel }
  local columns = plan:columns { group = "columns" }
  local floor_beam = plan:beams({ along = "x", group = "beams" })[1]
  equal(columns[1].ends, nil, "ends of a column")
  equal(tostring(floor_beam.ends.b), "joint: Mx free, My rigid, Mz rigid", "ends of a beam")
  plan:copy { members = columns, by = { 0, 5, 0 } }
  local copy = plan:copy({ members = { floor_beam }, by = { 0, 5, 0 } })[1]
  equal(tostring(copy.ends.a), "joint: Mx free, My rigid, Mz rigid", "ends of a copy")
end)

case("wrong input is refused", function()
  local free = hinge.joint { Mx = "free" }
  for _, row in ipairs {
    { "it is rigid and never breaks", {} }, { "must be 'free', 'rigid'", { Mx = "fre" } },
    { "stiffness", { Mx = { strength = 5 } } },
    { "less steep", { Mx = { points = { { 0.01, 10 }, { 0.02, 30 } } } } },
    { "'capacity'", { Mx = { points = { { 0.01, 10 }, { 0.02, 8 } } } } },
    { "given beside points", { Mx = { points = { { 0.01, 10 } }, stiffness = 1 } } },
    { "tension", { Mx = "free", tension = -1 } },
    { "needs 'tension'", { Mx = { stiffness = 1, strength = 1 }, interaction = "linear" } },
    { "needs a strength", { Mx = { stiffness = 1 }, tension = 1, interaction = "linear" } },
    { "'none', 'linear'", { Mx = { stiffness = 1 }, interaction = "square" } },
  } do
    checks.refused(row[1], function() hinge.joint(row[2]) end)
  end
  local model = hinge.model()
  local a, b = model:node { 0, 0, 0 }, model:node { 1, 0, 0 }
  local here, there = model:node { 0, 0, 0 }, model:node { 0, 0, 0 }
  local function joined(words, options)
    checks.refused(words, model.joint, model, with({ a, here, joint = free }, options))
  end
  joined("the nodes are 1 m apart; a joint has no length", { a, b })
  joined("both nodes are node 1", { a, a })
  joined("only moments count", { joint = hinge.joint { shear = 1 } })
  joined("must be a joint made by hinge.joint", { joint = 3 })
  joined("not along one line", { axes = { x = { 1, 0, 0 }, y = { 2, 0, 0 } } })
  model:joint { a, here, joint = free }
  joined("join node 4 to node 1 as well", { here, there })
  joined("a node is joined to one other node", { there, here })
  model:fix(a)
  model:member { a, b, section = square, material = steel }
  checks.refused("node 3 at {0, 0, 0} m has no member", model.static, model)
  model = hinge.model()
  a, b = model:node { 0, 0, 0 }, model:node { 1, 0, 0 }
  for words, options in pairs {
    ["must be 'Mx', 'My' or 'Mz'"] = { release = { a = "N" } }, ["must be { a = "] = { release = "Mx" },
    ["torsion (Mz) is free at both ends"] = { release = { a = "Mz", b = "Mz" } },
    ["must be a joint made by hinge.joint"] = { ends = { a = 3 } },
    ["given beside a joint"] = { ends = { a = free }, release = { a = "Mx" } },
  } do
    checks.refused(words, model.member, model, with({ a, b, section = square, material = steel }, options))
  end
  equal(#model:members(), 0, "no member was added")
end)

-- A cantilever of 3 m, with or without a joint at the wall that is soft about one axis, and a load on its tip.
local function rooted(joint, load)
  return scenes.cantilever { model = small, length = 3, force = load.force, moment = load.moment,
    member = { material = stiff, ends = joint and { a = hinge.joint(joint) },
      section = hinge.section.box { width = 0.1, depth = 0.2, thickness = 0.01 } } }
end

case("a rigid axis beside a soft one is softer by what the reference says", function()
  local loads = {
    Mx = { force = { 0, 0, 1e3 }, at = 3, part = 0.75 },
    My = { force = { 0, 1e3, 0 }, at = 2, part = 0.75 },
    Mz = { moment = { 1e3, 0, 0 }, at = 4, part = 1 },
  }
  for _, soft in ipairs { "Mx", "My", "Mz" } do
    for about, load in pairs(loads) do
      local what = ("%s is soft, %s bends: "):format(soft, about)
      if about ~= soft then
        local plain, end_of_plain = rooted(nil, load)
        local model, tip = rooted({ [soft] = { stiffness = 1e6 } }, load)
        local still = model:static { steps = 1, record = false }:finish()
        local wanted = select(load.at, plain:static { steps = 1, record = false }:finish():displacement(end_of_plain))
        local has = select(load.at, still:displacement(tip))
        near(has / wanted - 1, load.part * 1e-5, 1e-8, what .. "statics")
        -- dynamics has a softer spring, and begins with the moments of statics
        local on = model:dynamic { from = still, dt = 1e-3, duration = 0.1, record = false }:finish()
        near(select(load.at, on:displacement(tip)) / has, 1, 1e-6, what .. "a run that goes on from statics")
      end
    end
  end
end)

checks.done()
