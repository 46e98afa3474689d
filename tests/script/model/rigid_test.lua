-- Rigid links against closed forms: statics, rigid bodies in flight, breaks, and what is refused.
--
-- Run: lua5.4 tests/script/model/rigid_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local scenes = require "scenes"
local hinge = require "hinge"
local checks = support.checks "rigid links"
local runs = require "runs"(checks)
local case, expect, equal, near = checks.case, checks.expect, checks.equal, checks.near
local done, balanced = runs.completed, runs.balanced

local E, G = 206e9, 206e9 / 2.6
local bar = hinge.section.solid { width = 0.05, depth = 0.08 }
local function steel(density, stiffness)
  return hinge.material { E = stiffness or E, nu = 0.3, density = density or 7850 }
end
-- By integrator: options of a run whose implicit steps are dt.
local function methods(dt)
  return { newmark = { integrator = "newmark", dt = dt, record = false },
    explicit = { integrator = "explicit", dt = "auto", record = false } }
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
    balanced(run, 1e-8, nil, displacement)
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
    balanced(one, 5e-3, nil, name) -- the trapezium rule over five steps
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
  balanced(run, 1e-8, nil, "propped")
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

for integrator, options in pairs(methods(2e-4)) do
  case("two bars joined by a link tumble freely and keep energy and momenta: " .. integrator, function()
    local model, n = dumbbell({}, 1e9)
    local run = model:dynamic(scenes.with(options, { duration = 5 * 2 * math.pi / spin }))
    local before, first = run:momentum(), run.energy.kinetic
    done(run, integrator)
    local after = run:momentum()
    for c = 1, 3 do
      -- the centre of mass moves as the integrator moves a node: what is left is rounding and the solver's residual
      near(after.linear[c], before.linear[c], 1e-7 * before.linear[1], "linear momentum " .. c)
      -- second order: (w dt)^2 / 12 = 3e-7 of a turn for dt = 2e-4, and the turns of the bars' own vibration
      near(after.angular[c], before.angular[c], 2e-5 * before.angular[3], "angular momentum " .. c)
    end
    balanced(run, 2e-5, first, integrator)
    local p, q = { run:displacement(n[2]) }, { run:displacement(n[3]) }
    local apart = math.sqrt((q[1] + 0.8 - p[1]) ^ 2 + (q[2] + 0.1 - p[2]) ^ 2 + (q[3] + 0.2 - p[3]) ^ 2)
    near(apart, math.sqrt(0.8 ^ 2 + 0.1 ^ 2 + 0.2 ^ 2), 1e-11, "the link keeps its length")
    for c = 4, 6 do near(p[c], q[c], 1e-11, "its ends rotate alike") end
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
local function torn(options)
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
  return model:dynamic(scenes.with(options, { duration = 0.4 })), n
end
local function place(run, node, at)
  local x, y, z = run:displacement(node)
  return { at[1] + x, at[2] + y, at[3] + z }
end

for integrator, options in pairs(methods(2e-4)) do
  case("what a link joins stays joined as members break at it, and momenta are kept: " .. integrator, function()
    local run, n = torn(options)
    local before, first = run:momentum(), run
    runs.resumes(function()
      local made = first or torn(options)
      first = nil
      return made
    end, 0.2, integrator)
    equal(run.verdict, "completed", "verdict " .. run.reason)
    equal(run:count { state = "broken" }, 2, "two bars are broken")
    local after = run:momentum()
    near(after.mass, before.mass, 1e-9, "mass")
    for c = 1, 3 do -- angular: second order in dt
      near(after.linear[c], before.linear[c], 1e-7 * before.linear[1], "linear momentum " .. c)
      near(after.angular[c], before.angular[c], 1e-4 * before.angular[3], "angular momentum " .. c)
    end
    -- what a break takes counts as fracture; the rest is the error
    balanced(run, 1e-4, "initial", integrator)
    local p, q = place(run, n[3], { -0.5, 0.5, 0.1 }), place(run, n[5], { -0.5, -0.5, 0 })
    local apart = math.sqrt((p[1] - q[1]) ^ 2 + (p[2] - q[2]) ^ 2 + (p[3] - q[3]) ^ 2)
    near(apart, math.sqrt(1.01), 1e-10, "the length of the link that is left")
  end)
end

case("two bars joined by a link fall on the ground, and the energy balance closes", function()
  for integrator, options in pairs(methods(2e-4)) do
    local model, n = dumbbell({}, 1e9)
    model:gravity { 0, 0, -9.81 }
    model:ground { point = { 0, 0, -0.05 }, friction = 0.3 }
    local run = done(model:dynamic(scenes.with(options, { duration = 0.25 })), integrator)
    -- a per cent of what moves is what a run may miss by default; of a single bar it is a tenth of that
    balanced(run, 1e-3, nil, integrator)
    local _, _, vz = run:velocity(n[1])
    expect(vz > -9.81 * run.time + 0.5, "%s: the ground has slowed it down: %g m/s", integrator, vz)
    expect(run.energy.ground_stored + run.energy.ground_dissipated > 0, "%s: the ground took part", integrator)
  end
end)

-- What is refused -----------------------------------------------------------------------------------------------------

case("wrong links are refused at their line, and nothing of them is declared", function()
  local model, wall, tip, far, stub = extended { displacement = "small" }
  for words, options in pairs {
    ["model:rigid_link: field 'from'"] = { to = far }, ["model:rigid_link: field 'to'"] = { from = far },
    ["both nodes are node 2"] = { from = tip, to = tip },
    ["field 'dofs' is 'xy'"] = { from = tip, to = stub, dofs = "xy" },
    ["node 3 follows node 2 by a rigid link already; a node follows one other node"] = { from = wall, to = far },
    ["let both follow node 2"] = { from = far, to = stub },
    ["node 3 follows node 2 by a rigid link already, so that it cannot follow"] = { from = wall, to = tip },
  } do
    checks.refused(words, function() model:rigid_link(options) end)
  end
  equal(model:static { steps = 1 }.verdict, "running", "nothing of it was declared")
end)

case("what does not go together is refused where the run is made", function()
  local model, _, _, far = extended {}
  local tip
  checks.refused("integrator = 'energy-momentum' does not go with rigid links",
    function() model:dynamic { dt = 1e-3, duration = 0.1, integrator = "energy-momentum" } end)
  model:fix(far, "z")
  checks.refused("uz of node 3 at {2.5, 0, 0} m depends on node 2 at {2, 0, 0} m and is held by a support",
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
  checks.refused("can break at node 1", function() model:dynamic { dt = 1e-3, duration = 0.1 } end)

  model, _, tip, far = extended {}
  model:velocity(tip, { 1, 0, 0 })
  model:velocity(far, { 2, 0, 0 })
  checks.refused("begins with a velocity", function() model:dynamic { dt = 1e-3, duration = 0.1 } end)

  model, _, tip = extended {}
  local loose = model:node { 5, 0, 0 }
  model:rigid_link { from = tip, to = loose }
  checks.refused("has no member", function() model:static { steps = 1 } end)
end)

checks.done()
