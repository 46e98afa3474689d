-- Where a run begins, goes on and takes a step back: what it begins with counts in the energy balance, a step that is
-- taken back leaves the state of the step before, and the place of the origin is no matter.
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local scenes = require "scenes"
local hinge = require "hinge"
local checks = support.checks "starts"
local case, expect, equal, near = checks.case, checks.expect, checks.equal, checks.near

local steel = hinge.material { E = 210e9, density = 7850 }
local box = hinge.section.box { width = 0.15, depth = 0.2, thickness = 0.008 }
local square = hinge.section.solid { width = 0.1, depth = 0.1 }

-- A floor of three columns whose beams end in joints, pushed and bent. `with`: what joins its nodes.
local function floor(with, integrator)
  local model = hinge.model { elements_per_member = 4, displacement = with.displacement }
  local top, foot = {}, {}
  for i, at in ipairs { { 0, 0 }, { 5, 0 }, { 5, 4 } } do
    foot[i], top[i] = model:node { at[1], at[2], 0 }, model:node { at[1], at[2], 3 }
    model:fix(foot[i])
    model:member { foot[i], top[i], section = box, material = steel }
  end
  local last = top[2]
  if with.panel then
    last = model:node { 5, 0, 3 }
    model:joint { top[2], last, joint = hinge.joint { Mx = { stiffness = 2e7 } } }
  end
  local plate = hinge.joint { Mx = { stiffness = 1e7 } }
  model:member { top[1], last, section = box, material = steel, release = with.release and { b = "Mx" } or nil,
    ends = with.joint and { a = plate, b = plate } or nil }
  model:member { last, top[3], section = box, material = steel, release = with.release and { b = "Mx" } or nil }
  if with.mass then model:mass { node = top[2], mass = 500, inertia = 10, offset = { 0.1, 0.1, 0.1 } } end
  if with.diaphragm then model:diaphragm { nodes = top } end
  if with.link then model:rigid_link { from = top[2], to = top[3] } end
  model:load { node = top[1], force = { 1e4, 2e3, -1e4 } }
  return model:dynamic { dt = integrator == "explicit" and "auto" or 2e-5, integrator = integrator, duration = 0.02,
    record = false }:finish(), top[1]
end

case("explicit steps move a node that follows others, and that others follow, as Newmark's method does", function()
  for _, with in ipairs {
    { diaphragm = true, joint = true }, { diaphragm = true, release = true }, { diaphragm = true, panel = true },
    { diaphragm = true, joint = true, mass = true }, { diaphragm = true, panel = true, displacement = "small" },
    { link = true, joint = true }, { link = true, panel = true, mass = true }, { panel = true, joint = true },
  } do
    local names = {}
    for name, value in pairs(with) do table.insert(names, name .. " " .. tostring(value)) end
    table.sort(names)
    local what = table.concat(names, ", ")
    local by_explicit, node = floor(with, "explicit")
    local by_newmark, same_node = floor(with, "newmark")
    equal(by_explicit.verdict, "completed", what)
    near(by_explicit.energy_error, 0, 1e-4, what .. ": energy error")  -- the swing of the fastest vibrations
    -- masses lumped and consistent, with four elements a member: 1 % of the frequencies
    near((node:displacement(by_explicit)) / (same_node:displacement(by_newmark)), 1, 0.02, what .. ": displacement")
  end
end)

case("heat that leaves the range of its properties takes the step back, with each integrator", function()
  for _, settings in ipairs { { dt = 1e-3 }, { integrator = "explicit", dt = 2e-5 },
    { dt = 1e-3, step_control = 1e-2 } } do
    local model, _, post = scenes.cantilever { length = 3, along = { 0, 0, 1 },
      member = { section = square, material = steel } }
    model:heat { member = post, temperature = 20, across_x = { { 0, 0 }, { 0.2, 300 } } }
    settings.duration, settings.record = 0.2, false
    local run = model:dynamic(settings)
    local before = 0
    local ok, message = pcall(function()
      while run:step() do before = run.time end
    end)
    -- 80 degrees below 20 on the cold side leave the range, which begins at -60: after 0.2 s * 160 / 300
    local steps = math.floor(0.2 * 160 / 300 / settings.dt)
    local last, tried = steps * settings.dt, (steps + 1) * settings.dt
    expect(not ok and support.has(message, ("the temperature is 20 degrees Celsius at t = %.6g s"):format(tried)),
      "it said: %s", message)
    expect(support.has(tostring(message), ("at step %d, t = %.6g s; the step was taken back to t = %.6g s"):format(
      steps + 1, tried, last)), "it said: %s", message)
    near(run.time, last, 1e-12, "the time")
    equal(run.time, before, "that of the step before")
    near(run.energy_error, 0, 1e-3, "the energy error of the state that is left")
    expect(not pcall(run.step, run), "the same step fails again")
    equal(run.time, before, "and is taken back again")
  end
end)

-- A bar that falls on a beam (rule "surface" or "gap") or on the ground; its runs follow each other.
local function falls_on(what, integrator, durations)
  local model = hinge.model {}
  local bar
  if what == "surface" or what == "gap" then
    local a, b = model:node { -1, 0, 0 }, model:node { 1, 0, 0 }
    model:fix { a, b }
    model:member { a, b, section = square, material = steel }
    bar = model:member { model:node { 0.1, -0.6, 0.11 }, model:node { 0.1, 0.5, 0.11 }, section = square,
      material = steel }
    model:contact { rule = what }
  else
    bar = model:member { model:node { 0, 0, 0.06 }, model:node { 0, 1, 0.07 }, section = square, material = steel }
    model:ground(what == "points" and { stiffness = 1e8 } or {})
  end
  model:velocity(bar, { 0, 0, -5 })
  local run, first
  for _, duration in ipairs(durations) do
    run = model:dynamic { from = run, dt = integrator == "explicit" and 5e-6 or 1e-5, integrator = integrator,
      duration = duration, record = false }:finish()
    first = first or run
  end
  local place = {}
  for _, node in ipairs(bar:nodes()) do
    local x, y, z = node:displacement(run)
    place[#place + 1], place[#place + 2], place[#place + 3] = x, y, z
  end
  return run, place, first
end

case("a run that goes on while members press on each other, or on the ground, has the energy of the whole", function()
  for _, what in ipairs { "surface", "gap", "points", "layer" } do
    for _, integrator in ipairs { "newmark", "explicit" } do
      local whole, place = falls_on(what, integrator, { 0.006 })
      local most = 0
      for _, cut in ipairs { 0.001, 0.0025, 0.0035, 0.0045 } do
        local name = ("%s, %s, cut at %g s"):format(what, integrator, cut)
        local run, moved, first = falls_on(what, integrator, { cut, 0.006 - cut })
        local e = first.energy
        local stored = e.contact_stored + (e.ground_stored or 0)
        most = support.largest_of(most, stored)
        equal(run.verdict, "completed", name .. ": " .. run.reason)
        -- what explicit steps' balance swings by in a contact
        near(run.energy_error, 0, integrator == "explicit" and 2e-3 or 5e-5, name .. ": energy error")
        near(run.energy.initial / (e.kinetic + e.elastic + stored), 1, 1e-9, name .. ": what it begins with")
        for i, u in ipairs(moved) do equal(u, place[i], name .. ": the bits of displacement " .. i) end
      end
      if what ~= "gap" then expect(most > 1, "%s: %g J were stored at a cut", what, most) end
      near(whole.energy_error, 0, integrator == "explicit" and 2e-3 or 5e-5, what .. ": energy error")
    end
  end
end)

case("joint_stored and connector_stored are what is stored now, in each run of a chain", function()
  local model = hinge.model {}
  local a, b, c = model:node { 0, 0, 0 }, model:node { 3, 0, 0 }, model:node { 0, 3, 0 }
  model:fix { a, c }
  local k_joint, k_spring, P = 1e5, 1e5, 1000
  model:member { a, b, section = square, material = steel, ends = { a = hinge.joint { Mx = { stiffness = k_joint } } } }
  model:connector { b, ground = true, stiffness = { z = k_spring } }
  model:case "dead":load { node = b, force = { 0, 0, -P } }
  local rest = model:static { loads = { dead = 1 }, record = false }:finish()
  local function stored(run)
    local _, _, z = b:displacement(run)
    return run.energy.joint_stored, run.energy.connector_stored, 0.5 * k_spring * z ^ 2
  end
  local in_joint, in_spring, by_hand = stored(rest)
  near(in_spring, by_hand, 1e-9 * by_hand, "statics: k u^2 / 2")
  expect(in_joint > 0.1, "the joint turns: %g J", in_joint)

  local again = model:static { from = rest, loads = { dead = 1 }, record = false }:finish()
  near(again.energy.connector_stored, in_spring, 1e-6 * in_spring, "statics that goes on: the same")
  near(again.energy.initial, again.energy.elastic + in_joint + in_spring, 1e-6 * in_spring, "and began with it")

  for _, integrator in ipairs { "newmark", "explicit" } do
    local run = model:dynamic { from = rest, loads = { dead = 0 }, integrator = integrator,
      dt = integrator == "explicit" and "auto" or 1e-4, duration = 0.1, record = false }
    local e = run.energy
    equal(e.joint_stored, in_joint, integrator .. ": as before in the joint")
    equal(e.connector_stored, in_spring, integrator .. ": and in the connector")
    near(e.initial, e.elastic + in_joint + in_spring, 1e-12 * in_spring, integrator .. ": it begins with all of it")
    while run:step() do
      local joint, spring, now = stored(run)
      near(spring, now, 1e-9 * by_hand, integrator .. ": k u^2 / 2")
      expect(joint >= 0, "%s: joint_stored is %g J", integrator, joint)
    end
    near(run.energy_error, 0, 1e-5, integrator .. ": energy error")
  end
end)

case("small displacement: the weight of an offset mass does work on its node's rotation", function()
  local M, arm, H, g = 200, 0.3, 3, 9.81
  local function post(offset, displacement)
    local model, b = scenes.cantilever { model = { displacement = displacement }, length = H, along = { 0, 0, 1 },
      member = { section = square, material = steel } }
    model:mass { node = b, mass = M, offset = offset }
    model:gravity { 0, 0, -g }
    return model, b
  end
  for axis, offset in ipairs { { arm, 0, 0 }, { 0, -arm, 0 }, { arm, arm, 0.2 } } do
    local model, b = post(offset, "small")
    local rest = model:static { steps = 2, record = false }:finish()
    near(rest.energy_error, 0, 1e-9, axis .. ", statics: energy error")
    -- of a cantilever under the moment M g a: M g a H^2 / 2 E I
    local sway = M * g * offset[1] * H ^ 2 / (2 * 210e9 * square.Iy)
    if offset[1] ~= 0 then near((b:displacement(rest)) / sway, 1, 1e-9, axis .. ": sway") end
    for _, integrator in ipairs { "newmark", "explicit" } do
      model, b = post(offset, "small")
      local run = model:dynamic { dt = integrator == "explicit" and "auto" or 1e-3, duration = 0.3,
        integrator = integrator, record = false }:finish()
      equal(run.verdict, "completed", axis .. ", " .. integrator .. ": " .. run.reason)
      -- linear: exact by Newmark's method; explicit steps swing
      near(run.energy_error, 0, integrator == "newmark" and 1e-9 or 1e-4, axis .. ", " .. integrator)
      local large_model, top = post(offset, "large")
      local large = large_model:dynamic { dt = 1e-3, duration = 0.3, record = false }:finish()
      -- P-delta of the mass, M g / (E I (pi / 2 H)^2) = 0.4 %, has its time of 0.3 s to change the phase of the swing
      local x, y = b:displacement(run)
      local X, Y = top:displacement(large)
      local apart, of = math.sqrt((x - X) ^ 2 + (y - Y) ^ 2), math.sqrt(X ^ 2 + Y ^ 2)
      if integrator == "newmark" then near(apart / of, 0, 0.1, axis .. ": against large displacement") end
    end
  end
end)

case("small displacement: the energy balance closes where a member is removed under its weight", function()
  for _, integrator in ipairs { "newmark", "explicit" } do
    for _, slope in ipairs { 0, 0.7 } do
      local model = hinge.model { displacement = "small" }
      local a, b = model:node { 0, 0, 0 }, model:node { 0, 0, 3 }
      local c, d = model:node { 4, slope, 3 + slope }, model:node { 4, slope, 0 }
      model:fix { a, d }
      for i, ends in ipairs { { a, b }, { d, c }, { b, c } } do
        model:member { ends[1], ends[2], section = box, material = steel, group = i == 3 and "lost" or nil }
      end
      model:gravity { 0, 0, -9.81 }
      model:remove { group = "lost", at = 0.01 }
      local rest = model:static { steps = 1, record = false }:finish()
      local run = model:dynamic { from = rest, dt = integrator == "explicit" and "auto" or 5e-4,
        integrator = integrator, duration = 0.1, record = false }:finish()
      equal(run.verdict, "completed", integrator .. ": " .. run.reason)
      near(run.energy_error, 0, integrator == "newmark" and 1e-9 or 1e-4, integrator .. ": energy error")
    end
  end
end)

-- A thin bar of short elements let go high above its origin: the first steps have 1e-12 J.
local function let_go(z, settings)
  local model = hinge.model {}
  local a, b = model:node { 0, 0, z }, model:node { 0.2, 0, z }
  model:member { a, b, section = hinge.section.round { diameter = 0.003 }, material = scenes.steel, elements = 4 }
  model:gravity { 0, 0, -9.80665 }
  model:ground { point = { 0, 0, z - 0.02 } }
  settings.duration, settings.record = 2e-4, false
  return model:dynamic(settings):finish(), b
end

case("a body that is let go falls alike at any height above the origin", function()
  for _, settings in ipairs { { dt = "auto" }, { dt = 1e-6 }, { dt = 1e-5, step_control = 1e-6 },
    { dt = "auto", integrator = "explicit" } } do
    local at_origin, node = let_go(0, settings)
    local _, _, fallen = node:displacement(at_origin)
    near(fallen / (-9.80665 * 2e-4 ^ 2 / 2), 1, 1e-6, "free fall")
    for _, z in ipairs { 30, -300, 3000, 1e6 } do
      local run, n = let_go(z, settings)
      local what = ("dt = %s, z = %g m"):format(settings.dt, z)
      equal(run.verdict, "completed", what .. ": " .. run.reason)
      equal(run.index, at_origin.index, what .. ": steps")
      equal(run.counts.rejected_steps, 0, what .. ": none is halved")
      -- the ground is where it is to 1e-16 z
      near(select(3, n:displacement(run)) / fallen, 1, z < 1e5 and 0 or 1e-9, what .. ": the bits of the way")
      near(run.energy_error, 0, 1e-9, what .. ": energy error")
    end
  end
end)

-- What has come far begins anew at rest: a step control of it would see the rounding of the way.
local function far_away(settings, far)
  local model, b, bar = scenes.cantilever { length = 0.2, foot = false, member = {
    section = hinge.section.round { diameter = 0.003 }, material = steel, elements = 4 } }
  model:velocity(bar, { 0, 0, far * 1e4 })
  local up = model:dynamic { dt = 1e-6, duration = 1e-4, record = false }:finish()
  near(select(3, b:displacement(up)) / far, 1, 1e-9, "the way")
  model:gravity { 0, 0, -9.80665 }
  model:velocity(bar, { 0, 0, 0 })
  return model:dynamic(scenes.with(settings, { from = up, duration = 1e-3, record = false })):finish()
end

case("a body that has come far is let go alike: an error below rounding is none", function()
  for _, settings in ipairs { { dt = "auto" }, { dt = 1e-6, step_control = 1e-3 },
    { dt = "auto", integrator = "explicit" } } do
    for _, far in ipairs { 3, 300, 30000 } do
      local run = far_away(settings, far)
      local what = ("dt = %s, %s, %g m up"):format(settings.dt, settings.integrator, far)
      equal(run.verdict, "completed", what .. ": " .. run.reason)
      -- displacements round by 1e-16 of the way that they have, and the body falls by 5e-6 m
      near(run.energy_error, 0, 1e-8 + 3e-15 * far / 5e-6, what .. ": energy error")
    end
  end
end)

case("dt = \"auto\" takes twelve to forty-eight steps for a wave to cross the shortest element", function()
  local c = math.sqrt(206e9 / 7850)
  for _, carries in ipairs { "both", "tension" } do
    for _, yield_stress in ipairs { false, 1200e6 } do
      for _, diameter in ipairs { 0.3, 0.1, 0.03, 0.01, 0.003 } do
        for _, elements in ipairs { 2, 8 } do
          local model = scenes.cantilever { length = 6, head = "all", member = { carries = carries, elements = elements,
            section = hinge.section.round { diameter = diameter },
            material = hinge.material { E = 206e9, density = 7850, yield_stress = yield_stress or nil } } }
          local run = model:dynamic { dt = "auto", duration = 1e-2, record = false }
          local steps = 6 / elements / c / run.dt
          expect(steps >= 12 - 1e-9 and steps <= (yield_stress and 48 or 12.2),
            "%s, fy %s, diameter %g, %d elements: %g steps", carries, yield_stress, diameter, elements, steps)
        end
      end
    end
  end
end)

case("a slender bar that yields takes the steps of dt = \"auto\" to the result of short ones", function()
  local plastic = {}
  for _, dt in ipairs { "auto", 4e-6 } do
    local d = 0.03
    local model = scenes.cantilever { length = 2, force = { 0, 0, -235e6 * d ^ 3 / 6 },
      member = { section = hinge.section.round { diameter = d }, material = scenes.steel } }
    local run = model:dynamic { dt = dt, duration = 0.1, record = false }:finish()
    equal(run.verdict, "completed", run.reason)
    near(run.energy_error, 0, 1e-4, "energy error with dt = " .. dt)
    table.insert(plastic, run.energy.plastic)
  end
  near(plastic[1] / plastic[2], 1, 5e-3, "plastic work")  -- hinges begin a step sooner or later
end)

-- A bar that is clamped at both ends and hot, or prestressed, from the start.
local function hot_bar(set, yield_stress, of)
  of = of or {}
  local model, _, bar = scenes.cantilever { model = { elements_per_member = of.elements }, length = 3, head = "all",
    member = { section = of.section or hinge.section.box { width = 0.2, depth = 0.2, thickness = 0.01 },
      material = hinge.material { E = 206e9, density = 7850, yield_stress = yield_stress or 275e6, rate = of.rate } } }
  set(model, bar)
  return model, bar
end
local function told_of_yield(run)
  for _, warning in ipairs(run.warnings) do
    if support.has(warning, "beyond yield") and support.has(warning, "heat or prestress") then return warning end
  end
end

case("a run of dynamics that begins beyond yield begins on the yield surface, as after statics, and says so", function()
  for name, set in pairs {
    ["140 degrees"] = function(m) m:heat { temperature = 140 } end,
    ["193 degrees"] = function(m) m:heat { temperature = 193 } end,
    ["500 degrees"] = function(m) m:heat { temperature = 500 } end,
    ["-60 degrees"] = function(m) m:heat { temperature = -60 } m:heat { temperature = -60 } end,
    shortening = function(m, bar) m:prestress { member = bar, strain = -3e-3 } end,
    pull = function(m, bar) m:prestress { member = bar, force = 5e6 } end,
  } do
    local model = hot_bar(set)
    local slow = model:static { steps = 200, record = false }:finish()
    for _, settings in ipairs { { dt = 1e-5 }, { dt = 1e-4 }, { dt = "auto" }, { integrator = "explicit", dt = "auto" },
      { dt = 1e-5, energy_tolerance = 0 } } do
      local what = ("%s, %s, dt = %s"):format(name, settings.integrator, settings.dt)
      settings.duration, settings.record = 1e-3, false
      local run = model:dynamic(settings)
      local stored, plastic = run.energy.elastic, run.energy.plastic
      run:finish()
      equal(run.verdict, "completed", what .. ": " .. run.reason)
      near(run.energy_error, 0, 1e-9, what .. ": energy error")
      near(run.energy.plastic, plastic, 1e-6 * run.energy.initial, what .. ": nothing yields later")
      near(run.energy.initial, stored + plastic, 1e-9 * run.energy.initial, what .. ": what it begins with")
      near(stored / slow.energy.elastic, 1, 1e-6, what .. ": stored, against statics")
      -- beyond 400 degrees it yields on the way at the strength of lower ones. Statics needs a step to begin to yield
      if name ~= "500 degrees" then
        near(plastic, slow.energy.plastic, 0.01 * run.energy.initial, what .. ": plastic work, against statics")
      end
      equal(told_of_yield(run) ~= nil, plastic > 0, what .. ": " .. table.concat(run.warnings, "; "))
    end
  end
end)

-- Held along its axis beyond N0, no section has room for a moment: what a gradient across it would make flows away, and
-- the forces stay at the corner of N alone, where the surface has no one normal.
case("heat with a gradient begins at the corner of N alone, with any elements, sections and rates of strain", function()
  for _, section in ipairs { "box", "HEB 200" } do
    for _, elements in ipairs { 2, 4, 8 } do
      for _, rate in ipairs { 0, 1 } do
        local set = { elements = elements, section = section ~= "box" and hinge.section.named(section) or nil,
          rate = rate == 1 and { D = 40, q = 5 } or nil }
        local function begun(across)
          return hot_bar(function(m, bar)
            m:heat { member = bar, temperature = 193, across_x = across }
          end, nil, set):dynamic { dt = 1e-5, duration = 1e-4, record = false }
        end
        for _, across in ipairs { 50, 100 } do
          local what = ("%s, %d elements, rate %d, %g degrees across"):format(section, elements, rate, across)
          local run, even = begun(across), begun(0)
          local plastic = run.energy.plastic
          near(plastic / even.energy.plastic, 1, 1e-4, what .. ": plastic work, against none across")
          run:finish()
          equal(run.verdict, "completed", what .. ": " .. run.reason)
          near(run.energy.plastic, plastic, 1e-6 * run.energy.initial, what .. ": nothing yields later")
          near(run.energy.elastic / even.energy.elastic, 1, 1e-4, what .. ": stored, against none across")
        end
      end
    end
  end
end)

case("a run that goes on from a cold one is as hot from its start as one that begins hot", function()
  local model = hot_bar(function(m) m:case "weight":gravity { 0, 0, -9.81 } end)
  local cold = model:static { loads = { weight = 1 }, record = false }:finish()
  model:heat { temperature = 193, case = model:case "fire" }
  local run = model:dynamic { from = cold, loads = { weight = 1, fire = 1 }, dt = 1e-5, duration = 1e-3,
    record = false }:finish()
  equal(run.verdict, "completed", run.reason)
  near(run.energy_error, 0, 1e-4, "energy error")
  expect(run.energy.plastic > 0 and told_of_yield(run), "%g J: %s", run.energy.plastic,
    table.concat(run.warnings, "; "))
  local on = model:dynamic { from = run, dt = 1e-5, duration = 1e-3, record = false }:finish()
  expect(not told_of_yield(on), "once: %s", table.concat(on.warnings, "; "))
  near(on.energy_error, 0, 1e-6, "energy error of the run that goes on from there")
end)

case("what another member has of prestress changes nothing for loads between nodes that act at once", function()
  for _, part in ipairs { 0.5, 3.2 } do -- of the strength, which the fixed-end moments are
    local function run_with(strain)
      local model = hot_bar(function() end, 355e6, { section = hinge.section.round { diameter = 0.028 } })
      local rod = model:member { model:node { 0, 1, 0 }, model:node { 3, 1, 0 },
        section = hinge.section.round { diameter = 0.028 }, material = hinge.material.steel "S355" }
      model:fix { rod.a, rod.b }
      if strain then model:prestress { member = rod, strain = strain } end
      local strength = 355e6 * 0.028 ^ 3 / 6 / (9 / 64 * 3)
      model:load { member = model:members()[1], at = 0.25, force = { 0, 0, -part * strength } }
      return model:dynamic { dt = 1e-4, duration = 2e-3, record = false }:finish()
    end
    local alone = run_with()
    equal(alone.verdict, part < 1 and "completed" or "failed", part .. " of the strength")
    for _, strain in ipairs { 1e-4, -1e-4, 3e-3 } do
      local run = run_with(strain)
      local what = ("%g of the strength, strain %g: "):format(part, strain)
      equal(run.verdict, alone.verdict, what .. run.reason)
      if part > 1 then equal(run.failure.cause, alone.failure.cause, what .. "cause") end
    end
  end
end)

case("stress below yield, and members that go slack, begin without plastic work and without a word", function()
  local model = hot_bar(function(m) m:heat { temperature = 120 } end)
  local run = model:dynamic { dt = 1e-5, duration = 1e-4, record = false }:finish()
  equal(run.energy.plastic, 0, "120 degrees")
  equal(told_of_yield(run), nil, "120 degrees")
  model = scenes.cantilever { length = 3, head = "all",
    member = { section = hinge.section.round { diameter = 0.01 }, carries = "tension", material = steel } }
  model:heat { temperature = 300 }
  run = model:dynamic { dt = 1e-5, duration = 1e-3, record = false }:finish()
  equal(run.verdict, "completed", run.reason)
  near(run.energy.initial, 0, 1e-9, "a rod that is slack stores nothing")
  equal(run.energy.plastic, 0, "and takes no work")
  equal(told_of_yield(run), nil, "a slack rod")
end)

checks.done()
