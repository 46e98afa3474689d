-- Rigid links and diaphragms against closed forms: statics, vibration, rigid bodies in flight, checkpoints, and what is
-- refused.
--
-- Run: lua5.4 tests/script/model/rigid_test.lua [BUILD], with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local hinge = require "hinge"
local checks = support.checks "rigid links and diaphragms"
local case, expect, equal, near = checks.case, checks.expect, checks.equal, checks.near

local build = arg[1] or "build"
local E, G = 206e9, 206e9 / 2.6
local bar = hinge.section.solid { width = 0.05, depth = 0.08 }
local function steel(density, stiffness)
  return hinge.material { E = stiffness or E, nu = 0.3, density = density or 7850 }
end
local function done(run, what)
  run:finish()
  equal(run.verdict, "completed", what .. ": verdict " .. run.reason)
  return run
end
local function balanced(run, within, what)
  local e = run.energy
  local most = support.largest_of(e.elastic, e.kinetic, e.initial)
  expect(most > 0, "%s: the energy balance has nothing to close", what)
  expect(math.abs(e.energy_error) <= within * most, "%s: energy error %g of %g J", what, e.energy_error, most)
end

-- Statics -------------------------------------------------------------------------------------------------------------

-- A cantilever of length L along x, with a rigid link of length a on its tip; the link's end carries a stub, on which
-- nothing acts.
local L, a = 2, 0.5
local function extended(options)
  local model = hinge.model(options)
  local wall, tip = model:node { 0, 0, 0 }, model:node { L, 0, 0 }
  local far, stub = model:node { L + a, 0, 0 }, model:node { L + a + 0.1, 0, 0 }
  model:fix(wall)
  model:member { wall, tip, section = bar, material = steel(), up = { 0, 0, 1 } }
  model:member { far, stub, section = bar, material = steel(), up = { 0, 0, 1 } }
  model:rigid_link { from = tip, to = far }
  return model, wall, tip, far, stub
end

for _, displacement in ipairs { "small", "large" } do
  case("a cantilever extended by a rigid link bends as by hand: displacement " .. displacement, function()
    local model, wall, tip, far = extended { displacement = displacement }
    -- so small that large displacement differs by less than (u / L)^2 = 1e-10
    local P = 1
    model:load { node = far, force = { 0, 0, -P } }
    local run = done(model:static { steps = 2 }, displacement)
    local EI = E * bar.Ix
    local u = P * L ^ 3 / (3 * EI) + P * a * L ^ 2 / (2 * EI) + P * L / (G * bar.shear_area_y)
    local angle = P * L ^ 2 / (2 * EI) + P * a * L / EI
    local _, _, at_tip, _, turn = run:displacement(tip)
    near(at_tip / -u, 1, 1e-8, "deflection at the tip")
    near(turn / angle, 1, 1e-8, "rotation at the tip")
    local _, _, at_far, _, turn_far = run:displacement(far)
    near(at_far / -(u + a * angle), 1, 1e-8, "deflection at the end of the link")
    near(turn_far, turn, 1e-15, "the link's end rotates as its beginning")
    local _, _, fz, _, my = run:reaction(wall)
    near(fz / P, 1, 1e-8, "reaction, N")
    near(my / -(P * (L + a)), 1, 1e-8, "its moment, N m")
    local _, _, none = run:reaction(far)
    equal(none, 0, "the link's end is no support")
    balanced(run, 1e-8, displacement)
  end)
end

-- An L of two bars, joined by a link that is skew in space, or by a bar in its place that is a million times stiffer.
local function bent(stiff, loads)
  local model = hinge.model {}
  local wall, b, c, d = model:node { 0, 0, 0 }, model:node { 1, 0, 0 }, model:node { 1.2, 0.1, 0.3 },
    model:node { 1.2, 1.1, 0.3 }
  model:fix(wall)
  model:member { wall, b, section = bar, material = steel(), up = { 0, 0, 1 } }
  model:member { c, d, section = bar, material = steel(), up = { 0, 0, 1 } }
  if stiff then model:member { b, c, section = bar, material = steel(1, stiff * E), up = { 0, 1, 0 } }
  else model:rigid_link { from = b, to = c } end
  loads(model, d, c)
  return model, d, c, wall
end

case("a structure with a rigid link moves as with a member that is 1e6 times stiffer", function()
  local function pressed(model, d) model:load { node = d, force = { -20e3, 5e3, -30e3 } } end
  local function twisted(model, d, c)
    pressed(model, d)
    model:load { node = c, force = { 0, 10e3, 0 }, moment = { 0, 2e3, 3e3 } }
  end
  for name, loads in pairs { forces = pressed, moments = twisted } do
    local by_link, d, c, wall = bent(nil, loads)
    local by_member, d2, c2, wall2 = bent(1e6, loads)
    local one, two = done(by_link:static { steps = 5 }, "link"), done(by_member:static { steps = 5 }, "member")
    local moved = 0
    for _, pair in ipairs { { d, d2 }, { c, c2 } } do
      local x, y = { one:displacement(pair[1]) }, { two:displacement(pair[2]) }
      for i = 1, 6 do
        moved = support.largest_of(moved, math.abs(x[i]))
        near(x[i], y[i], 1e-5 * 0.5, name .. ": displacement " .. i) -- what a stiffness of 1e-6 leaves, ten times over
      end
    end
    expect(moved > 0.2, "%s: the rotations are large: %g", name, moved)
    local r, q = { one:reaction(wall) }, { two:reaction(wall2) }
    for i = 1, 6 do near(r[i], q[i], 1, name .. ": reaction " .. i) end -- of 30 kN
    balanced(one, 5e-3, name) -- the trapezium rule over five steps
  end
end)

case("a link with dofs = \"xyz\" ends in a ball joint", function()
  -- a beam from a wall to a ball joint on a column's head: a propped cantilever under a load in the middle
  local model = hinge.model { displacement = "small" }
  local wall, middle, head = model:node { 0, 0, 0 }, model:node { 1, 0, 0 }, model:node { 2, 0, 0 }
  local post, foot = model:node { 2.3, 0, 0 }, model:node { 2.3, 0, -1 }
  model:fix { wall, foot, post }
  model:member { wall, middle, section = bar, material = steel(), up = { 0, 0, 1 } }
  model:member { middle, head, section = bar, material = steel(), up = { 0, 0, 1 } }
  model:member { foot, post, section = bar, material = steel(), up = { 1, 0, 0 } }
  model:rigid_link { from = post, to = head, dofs = "xyz" }
  local P = 1000
  model:load { node = middle, force = { 0, 0, -P } }
  local run = done(model:static { steps = 1 }, "propped")
  local EI, shear = E * bar.Ix, 1 / (G * bar.shear_area_y)
  local R = P * (5 / (48 * EI) * 8 + 1 * shear) / (8 / (3 * EI) + 2 * shear)
  local _, _, fz, _, my = run:reaction(post)
  near(fz / R, 1, 1e-8, "what the ball joint carries, N")
  near(my / (0.3 * R), 1, 1e-8, "its moment about the post's head, on an arm of 0.3 m")
  balanced(run, 1e-8, "propped")
end)

case("control by displacement and by arc length drives the end of a link", function()
  local function pressed_by(force) return function(m, d) m:load { node = d, force = { 0, 0, force } } end end
  local function run(stiff, control)
    local model, d = bent(stiff, pressed_by(-10e3))
    return done(model:static { steps = 8, control = control or { node = d, "uz", to = -0.2 } }, "controlled"), d
  end
  local one, d = run()
  local two, d2 = run(1e6)
  near(one.factor / two.factor, 1, 1e-5, "displacement: load factor")
  near((one:displacement(d)), (two:displacement(d2)), 1e-6, "displacement: what the load moves besides")
  -- along the arc: an equilibrium, which a run under that load finds as well
  local along, e = run(nil, "arc")
  local model, tip = bent(nil, pressed_by(-10e3 * along.factor))
  local loaded = done(model:static { steps = 2 }, "loaded")
  for c = 1, 6 do
    near(select(c, along:displacement(e)), select(c, loaded:displacement(tip)), 1e-6, "arc: displacement " .. c)
  end
  expect(along.factor > 0.1, "it went to a load factor of %g", along.factor)
end)

case("a column that carries its load through a rigid link buckles at the load worked out by hand", function()
  -- A cantilever of length L with a rigid link of length a along it, under an axial load at its end:
  -- k L tan k L = L / a, with P = k^2 EI (the rigid end leans with the tip; Timoshenko and Gere, section 2.13)
  local height, arm = 3, 1
  local low, high = 1e-6, math.pi / 2 - 1e-9
  for _ = 1, 200 do
    local x = (low + high) / 2
    if x * math.tan(x) < height / arm then low = x else high = x end
  end
  local flexible = bar.Iy
  local critical = (low / height) ^ 2 * E * flexible
  local model = hinge.model {}
  local foot, top = model:node { 0, 0, 0 }, model:node { 0, 0, height }
  local far, stub = model:node { 0, 0, height + arm }, model:node { 0, 0, height + arm + 0.1 }
  model:fix(foot)
  model:member { foot, top, section = bar, material = steel(), elements = 8 }
  model:member { far, stub, section = bar, material = steel() }
  model:rigid_link { from = top, to = far }
  model:load { node = far, force = { 0, 0, -2 * critical } }
  local run = model:static { steps = 20 }
  run:finish()
  equal(run.verdict, "failed", "it buckles")
  near(run.factor * 2, 1, 5e-3, "load at which it does, of the one by hand (shear is left out there): " .. run.reason)
end)

-- A storey ------------------------------------------------------------------------------------------------------------

-- Four columns of next to no mass, clamped at their feet, carry a floor that is rigid in its plane.
local height, half_x, half_y, corner = 3, 2, 1.5, 500
local k_x = 1 / (height ^ 3 / (3 * E * bar.Ix) + height / (G * bar.shear_area_y)) -- `up` is x
local k_y = 1 / (height ^ 3 / (3 * E * bar.Iy) + height / (G * bar.shear_area_x))
local k_turn = 4 * (k_x * half_y ^ 2 + k_y * half_x ^ 2 + G * bar.J / height)
local function storey(options, density)
  local model = hinge.model(options or { displacement = "small" })
  local heads, feet = {}, {}
  for i, at in ipairs { { -1, -1 }, { 1, -1 }, { 1, 1 }, { -1, 1 } } do
    feet[i] = model:node { at[1] * half_x, at[2] * half_y, 0 }
    heads[i] = model:node { at[1] * half_x, at[2] * half_y, height }
    model:fix(feet[i])
    model:member { feet[i], heads[i], section = bar, material = steel(density or 1e-3), up = { 1, 0, 0 } }
    model:mass { node = heads[i], mass = corner }
  end
  model:diaphragm { nodes = heads }
  return model, heads, feet
end

case("a force beside the centre of a diaphragm shifts and turns the floor", function()
  local model, heads, feet = storey()
  local F = 1000
  model:load { node = heads[2], force = { 0, F, 0 } } -- at x = half_x
  local run = done(model:static { steps = 1 }, "off centre")
  local shift, turn = F / (4 * k_y), F * half_x / k_turn
  for i, at in ipairs { { -1, -1 }, { 1, -1 }, { 1, 1 }, { -1, 1 } } do
    local ux, uy, _, _, _, rz = run:displacement(heads[i])
    near(ux / (-turn * at[2] * half_y), 1, 1e-7, "ux of corner " .. i)
    near(uy / (shift + turn * at[1] * half_x), 1, 1e-7, "uy of corner " .. i)
    near(rz / turn, 1, 1e-7, "rotation of corner " .. i)
  end
  local sum = { 0, 0, 0 }
  for i, at in ipairs { { -1, -1 }, { 1, -1 }, { 1, 1 }, { -1, 1 } } do
    local fx, fy, _, _, _, mz = run:reaction(feet[i])
    sum[1], sum[2] = sum[1] + fx, sum[2] + fy
    sum[3] = sum[3] + mz + at[1] * half_x * fy - at[2] * half_y * fx
  end
  near(sum[1], 0, 1e-6, "reactions along x, N")
  near(sum[2], -F, 1e-6, "reactions along y, N")
  near(sum[3], -F * half_x, 1e-6, "their torque, N m")
  balanced(run, 1e-9, "off centre")
end)

case("a storey with a diaphragm has the three periods worked out by hand", function()
  local turning_mass = 4 * corner * (half_x ^ 2 + half_y ^ 2)
  local wanted = {
    2 * math.pi * math.sqrt(corner / k_x), 2 * math.pi * math.sqrt(corner / k_y),
    2 * math.pi * math.sqrt(turning_mass / k_turn),
  }
  table.sort(wanted, function(one, two) return one > two end)
  local scene = os.tmpname()
  support.write(scene, ([[
local hinge = require "hinge"
local bar = hinge.section.solid { width = 0.05, depth = 0.08 }
local steel = hinge.material { E = 206e9, nu = 0.3, density = 1e-3 }
local model, heads = hinge.model { displacement = "small" }, {}
for i, at in ipairs { { -1, -1 }, { 1, -1 }, { 1, 1 }, { -1, 1 } } do
  local foot = model:node { at[1] * %g, at[2] * %g, 0 }
  heads[i] = model:node { at[1] * %g, at[2] * %g, %g }
  model:fix(foot)
  model:member { foot, heads[i], section = bar, material = steel, up = { 1, 0, 0 } }
  model:mass { node = heads[i], mass = %g }
end
model:diaphragm { nodes = heads }
model:dynamic { dt = 1e-3, duration = 1e-3 }
]]):format(half_x, half_y, half_x, half_y, height, corner))
  local text = support.output(("%s check %s"):format(support.quote(build .. "/hinge"), scene))
  os.remove(scene)
  local found, list = {}, text:match "natural periods ([^\n]*) s" or ""
  for number in list:gmatch "[%d.e-]+" do found[#found + 1] = tonumber(number) end
  for i, period in ipairs(wanted) do near((found[i] or 0) / period, 1, 1e-3, "period " .. i .. " of hinge check") end
end)

for _, integrator in ipairs { "newmark", "explicit" } do
  case("a floor that is let go sways at its period: " .. integrator, function()
    local w = math.sqrt(k_y / corner)
    for _, displacement in ipairs { "small", "large" } do
      local explicit = integrator == "explicit"
      local model, heads = storey({ displacement = displacement }, explicit and 200 or nil)
      for _, n in ipairs(heads) do model:velocity(n, { 0, 0.01 * w, 0 }) end
      local mass = corner + (explicit and 200 * bar.area * height / 2 or 0)
      local period = 2 * math.pi * math.sqrt(mass / k_y)
      local run = model:dynamic { dt = explicit and "auto" or period / 400, duration = 0.8 * period,
        integrator = integrator }
      local before, crossed = 0, nil
      for step in run:steps() do
        local _, uy = run:displacement(heads[3])
        if before > 0 and uy <= 0 and not crossed then crossed = step.time end
        before = uy
      end
      near((crossed or 0) / (period / 2), 1, explicit and 2e-2 or 5e-3, displacement .. ": half a period")
      balanced(run, 1e-3, displacement)
    end
  end)
end

-- Rigid bodies in flight ----------------------------------------------------------------------------------------------

-- Two bars on one line, joined by a link of 0.8 m, spin about their common centre.
local spin = 10
local function dumbbell(options, stiffness)
  local model = hinge.model(options or {})
  local n = {}
  for i, at in ipairs { { 0, 0, 0 }, { 0.2, 0, 0 }, { 1, 0.1, 0.2 }, { 1.3, 0.1, 0.2 } } do n[i] = model:node(at) end
  local function beam(i, j)
    model:member { n[i], n[j], section = bar, material = steel(nil, stiffness), up = { 0, 0, 1 }, group = "body" }
  end
  beam(1, 2)
  beam(3, 4)
  model:rigid_link { from = n[2], to = n[3] }
  model:velocity("body", { 1, 0, 0 }, { 0, 0, spin })
  return model, n
end

for _, integrator in ipairs { "newmark", "explicit" } do
  case("two bars joined by a link tumble freely and keep energy and momenta: " .. integrator, function()
    local explicit = integrator == "explicit"
    local function errors(dt)
      local model, n = dumbbell({}, 1e9)
      local run = model:dynamic { dt = dt, duration = 5 * 2 * math.pi / spin, integrator = integrator, record = false }
      local before, first = run:momentum(), run.energy.kinetic
      done(run, integrator)
      local after, angular = run:momentum(), 0
      for c = 1, 3 do
        -- the centre of mass moves as the integrator moves a node: what is left is rounding and the solver's residual
        near(after.linear[c], before.linear[c], 1e-7 * before.linear[1], "linear momentum " .. c)
        angular = support.largest_of(angular, math.abs(after.angular[c] - before.angular[c]) / before.angular[3])
      end
      local p, q = { run:displacement(n[2]) }, { run:displacement(n[3]) }
      local apart = math.sqrt((q[1] + 0.8 - p[1]) ^ 2 + (q[2] + 0.1 - p[2]) ^ 2 + (q[3] + 0.2 - p[3]) ^ 2)
      near(apart, math.sqrt(0.8 ^ 2 + 0.1 ^ 2 + 0.2 ^ 2), 1e-11, "the link keeps its length")
      for c = 4, 6 do near(p[c], q[c], 1e-11, "its ends rotate alike") end
      return angular, math.abs(run.energy.energy_error) / first, run.dt
    end
    -- second order: (w dt)^2 / 12 = 3e-7 of a turn for dt = 2e-4, and the turns of the bars' own vibration
    local angular, energy = errors(explicit and "auto" or 2e-4)
    expect(angular < 2e-5, "angular momentum changes by %g of itself", angular)
    expect(energy < 2e-5, "energy error %g of the kinetic energy", energy)
  end)
end

case("factors and conjugate gradients find the same motion", function()
  local function go(solver)
    local model, n = dumbbell {}
    local wall = model:node { 0, -1, 0 }
    model:fix(wall)
    model:member { wall, n[1], section = bar, material = steel() }
    model:load { node = n[4], force = { 0, 0, 1e3 } }
    return { done(model:dynamic { dt = 1e-4, duration = 0.02, solver = solver }, solver):displacement(n[4]) }
  end
  local one, two = go "cg", go "direct"
  for c = 1, 6 do near(one[c], two[c], 1e-7, "displacement " .. c) end -- m and rad; the solver's tolerance is 1e-8
end)

-- Three bars on a rigid Y spin. First the bar breaks off on which the others' links begin, then one of the two that are
-- left is taken out and leaves its halves at its ends.
local function torn(integrator)
  local model, n = hinge.model {}, {}
  local places = {
    { 0.5, 0, 0 }, { 1, 0, 0 }, { -0.5, 0.5, 0.1 }, { -1, 1, 0.1 }, { -0.5, -0.5, 0 }, { -1, -1, 0 },
  }
  for i, at in ipairs(places) do n[i] = model:node(at) end
  for i = 1, 5, 2 do
    n[i + 6] = model:member { n[i], n[i + 1], section = bar, material = steel(nil, 1e9), up = { 0, 0, 1 },
      group = "body" }
  end
  model:rigid_link { from = n[1], to = n[3] }
  model:rigid_link { from = n[1], to = n[5] }
  model:velocity("body", { 1, 0, 0 }, { 0, 1, spin })
  model:fracture { rule = function(s) return s.node == n[1].index and s.time > 0.05 end }
  model:remove { member = n[11], at = 0.15 }
  local explicit = integrator == "explicit"
  return model:dynamic { dt = explicit and "auto" or 2e-4, duration = 0.4, integrator = integrator, record = false }, n
end
local function place(run, node, at)
  local x, y, z = run:displacement(node)
  return { at[1] + x, at[2] + y, at[3] + z }
end

for _, integrator in ipairs { "newmark", "explicit" } do
  case("what a link joins stays joined as members break at it, and momenta are kept: " .. integrator, function()
    local run, n = torn(integrator)
    local before = run:momentum()
    local path, saved = os.tmpname(), false
    for step in run:steps() do
      if step.time > 0.2 and not saved then saved = run:checkpoint(path) or true end
    end
    equal(run.verdict, "completed", "verdict " .. run.reason)
    equal(run:count { state = "broken" }, 2, "two bars are broken")
    local after = run:momentum()
    near(after.mass, before.mass, 1e-9, "mass")
    for c = 1, 3 do -- angular: second order in dt
      near(after.linear[c], before.linear[c], 1e-7 * before.linear[1], "linear momentum " .. c)
      near(after.angular[c], before.angular[c], 1e-4 * before.angular[3], "angular momentum " .. c)
    end
    -- what a break takes counts as fracture; the rest is the error
    expect(math.abs(run.energy.energy_error) < 1e-4 * run.energy.initial, "energy error %g of %g J",
      run.energy.energy_error, run.energy.initial)
    local p, q = place(run, n[3], { -0.5, 0.5, 0.1 }), place(run, n[5], { -0.5, -0.5, 0 })
    local apart = math.sqrt((p[1] - q[1]) ^ 2 + (p[2] - q[2]) ^ 2 + (p[3] - q[3]) ^ 2)
    near(apart, math.sqrt(1.01), 1e-10, "the length of the link that is left")
    local resumed = torn(integrator):resume(path)
    resumed:finish()
    os.remove(path)
    equal(resumed.hash, run.hash, "state of the run that goes on after the breaks")
  end)
end

case("two bars joined by a link fall on the ground, and the energy balance closes", function()
  for _, integrator in ipairs { "newmark", "explicit" } do
    local model, n = dumbbell({}, 1e9)
    model:gravity { 0, 0, -9.81 }
    model:ground { point = { 0, 0, -0.05 }, friction = 0.3 }
    local explicit = integrator == "explicit"
    local run = model:dynamic { dt = explicit and "auto" or 2e-4, duration = 0.25, integrator = integrator }
    done(run, integrator)
    -- a per cent of what moves is what a run may miss by default; of a single bar it is a tenth of that
    balanced(run, 1e-3, integrator)
    local _, _, vz = run:velocity(n[1])
    expect(vz > -9.81 * run.time + 0.5, "%s: the ground has slowed it down: %g m/s", integrator, vz)
    expect(run.energy.ground_stored + run.energy.ground_dissipated > 0, "%s: the ground took part", integrator)
  end
end)

case("a run that goes on from a checkpoint has the same bits", function()
  for _, integrator in ipairs { "newmark", "explicit" } do
    local function made()
      local model, heads = storey({}, 500)
      model:velocity(heads[1], { 0, 1, 0 }, { 0, 0, 0.2 })
      model:gravity { 0, 0, -9.81 }
      local n = { model:node { 9, 0, 0 }, model:node { 9, 0, 1 }, model:node { 9.5, 0, 1 }, model:node { 9.5, 1, 2 } }
      model:member { n[1], n[2], section = bar, material = steel() }
      model:member { n[3], n[4], section = bar, material = steel() }
      model:rigid_link { from = n[2], to = n[3] }
      model:velocity(n[2], { 0, 0, 1 }, { 3, 2, 1 })
      local dt = integrator == "explicit" and "auto" or 2e-3
      return model:dynamic { dt = dt, duration = 0.06, integrator = integrator }
    end
    local path = os.tmpname()
    local whole, steps = made(), nil
    for step in whole:steps() do
      if not steps and step.time > 0.03 then
        steps = step.index
        whole:checkpoint(path)
      end
    end
    local resumed = made():resume(path)
    resumed:finish()
    os.remove(path)
    equal(resumed.hash, whole.hash, integrator .. ": state")
    equal(resumed.energy.energy_error, whole.energy.energy_error, integrator .. ": energy")
    expect(steps and whole.index > steps, "%s: it went on from the middle", integrator)
  end
end)

-- What is refused -----------------------------------------------------------------------------------------------------

local function refused(message, f)
  local good, why = pcall(f)
  expect(not good and support.has(tostring(why), message), "said '%s', expected '%s'", tostring(why), message)
end

case("wrong links are refused at their line", function()
  local model, wall, tip, far, stub = extended { displacement = "small" }
  local function link(options) return function() model:rigid_link(options) end end
  refused("model:rigid_link: field 'from'", link { to = far })
  refused("model:rigid_link: field 'to'", link { from = far })
  refused("both nodes are node 2", link { from = tip, to = tip })
  refused("field 'dofs' is 'xy'", link { from = tip, to = stub, dofs = "xy" })
  refused("unknown field 'dof'", link { from = tip, to = stub, dof = "xyz" })
  refused("node 3 follows node 2 by a rigid link already; a node follows one other node",
    link { from = wall, to = far })
  refused("let both follow node 2", link { from = far, to = stub })
  refused("node 3 follows node 2 by a rigid link already, so that it cannot follow", link { from = wall, to = tip })
  refused("rigid_test.lua", link { from = tip, to = tip })
  equal(model:static { steps = 1 }.verdict, "running", "nothing of it was declared")
end)

case("wrong diaphragms are refused at their line", function()
  local model, heads, feet = storey()
  local function floor(options) return function() model:diaphragm(options) end end
  refused("field 'nodes'", floor {})
  refused("must have two at least", floor { nodes = { feet[1] } })
  refused("listed twice", floor { nodes = { feet[1], feet[1] } })
  refused("field 'normal' is 'w'", floor { nodes = feet, normal = "w" })
  refused("must be one of 'nodes'", floor { nodes = feet, master = heads[1] })
  refused("already", floor { nodes = heads })
end)

-- A portal in the plane of x and z, held out of it at all nodes. join(model, heads, feet) declares what joins them.
local function plane_portal(displacement, join, hold)
  local model = hinge.model { displacement = displacement }
  local feet, heads = {}, {}
  for i = 1, 2 do
    feet[i], heads[i] = model:node { 4 * i, 0, 0 }, model:node { 4 * i, 0, 3 + 0.2 * i }
    model:fix(feet[i])
    local held = hold and hold[i] or "y,rx,rz"
    if held ~= "" then model:fix(heads[i], held) end
    model:member { feet[i], heads[i], section = bar, material = steel(), up = { 1, 0, 0 } }
  end
  join(model, heads, feet)
  model:load { node = heads[1], force = { 20, 0, 0 } }
  return model, heads
end

for _, displacement in ipairs { "small", "large" } do
  case("supports that hold both nodes agree with what joins them: displacement " .. displacement, function()
    local joins = {
      diaphragm = function(m, h) m:diaphragm { nodes = h } end,
      ["diaphragm from the other node"] = function(m, h) m:diaphragm { nodes = { h[2], h[1] } } end,
      ["link of places"] = function(m, h) m:rigid_link { from = h[1], to = h[2], dofs = "xyz" } end,
      ["rigid link"] = function(m, h) m:rigid_link { from = h[2], to = h[1] } end,
    }
    -- by hand: what supports hold of the dependent node is left to the constraint
    local by_hand = { diaphragm = { "y,rx,rz", "rx" }, ["diaphragm from the other node"] = { "rx", "y,rx,rz" },
      ["link of places"] = { "y,rx,rz", "rx,rz" }, ["rigid link"] = { "", "y,rx,rz" } }
    for name, join in pairs(joins) do
      for _, kind in ipairs { "static", "newmark", "explicit" } do
        local u = {}
        for i, hold in ipairs { { "y,rx,rz", "y,rx,rz" }, by_hand[name] } do
          local model, heads = plane_portal(displacement, join, hold)
          local run = kind == "static" and model:static { steps = 1 }
            or model:dynamic { dt = 1e-5, duration = 2e-3, integrator = kind }
          done(run, name .. ", " .. kind)
          u[i] = { heads[1]:displacement(run) }
        end
        -- rounding, and where the centre of mass is the reference, the integrator's own error
        local within = kind == "static" and 1e-9 or 1e-4
        for c = 1, 3 do near(u[1][c], u[2][c], within * math.abs(u[2][1]), ("%s, %s, %d"):format(name, kind, c)) end
        expect(math.abs(u[1][1]) > 1e-7, "%s: it moves by %g m", name, u[1][1])
      end
    end
  end)
end

case("feet that are held join a rigid floor, whatever comes first", function()
  local model, heads, feet = storey()
  model:diaphragm { nodes = feet }
  model:load { node = heads[1], force = { 1, 0, 0 } }
  done(model:static { steps = 1 }, "feet in a diaphragm")
end)

case("a support that holds a dependent node alone is refused", function()
  for _, hold in ipairs { { "y,rx,rz", "x,y,rx,rz" }, { "rx", "y,rx,rz" } } do
    local model = plane_portal("small", function(m, h) m:diaphragm { nodes = h } end, hold)
    refused("is held by a support, while that node is free to move it", function() model:static { steps = 1 } end)
  end
  local model = plane_portal("small", function(m, h)
    m:diaphragm { nodes = h }
    m:settle { node = h[1], y = 0.01 }
  end)
  refused("is held by a support", function() model:static { steps = 1 } end)
end)

case("what does not go together is refused where the run is made", function()
  local model, _, _, far = extended {}
  local tip
  refused("integrator = 'energy-momentum' does not go with rigid links",
    function() model:dynamic { dt = 1e-3, duration = 0.1, integrator = "energy-momentum" } end)
  model:fix(far, "z")
  refused("uz of node 3 at {2.5, 0, 0} m depends on node 2 at {2, 0, 0} m and is held by a support",
    function() model:static { steps = 1 } end)

  local arms = {}
  model = hinge.model {}
  for i = 1, 3 do
    arms[i] = model:node { i, 0, 0 }
    model:member { arms[i], model:node { i, 1, 0 }, section = bar, material = steel(), group = "weak" }
  end
  model:rigid_link { from = arms[1], to = arms[2], dofs = "xyz" }
  model:rigid_link { from = arms[1], to = arms[3] }
  model:fracture { axial_strain = 0.1 }
  refused("can break at node 1", function() model:dynamic { dt = 1e-3, duration = 0.1 } end)

  model, _, tip, far = extended {}
  model:velocity(tip, { 1, 0, 0 })
  model:velocity(far, { 2, 0, 0 })
  refused("begins with a velocity", function() model:dynamic { dt = 1e-3, duration = 0.1 } end)

  model, _, tip = extended {}
  local loose = model:node { 5, 0, 0 }
  model:rigid_link { from = tip, to = loose }
  refused("has no member", function() model:static { steps = 1 } end)
end)

case("the plan has a line of links and one of diaphragms", function()
  local model = storey()
  local run = model:static { steps = 1 }
  local line
  for _, effect in ipairs(run.effects) do
    if effect.name == "diaphragms" then line = effect end
  end
  expect(line and line.active and line.because == "1 diaphragm of 4 nodes", "it says: %s", line and line.because)
end)

checks.done()
