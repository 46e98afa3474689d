-- Weight along members (weight = "members") against closed forms: end forces, reactions and deflections in statics and
-- at rest in dynamics, about both axes, inclined, in a portal, with both masses; load cases and held gravity; bodies
-- that fall; large swings; breaks; and weight = "nodes".
--
-- Run: lua5.4 tests/script/actions/weight_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local hinge = require "hinge"
local checks = support.checks "weight"
local case, near, equal, expect = checks.case, checks.near, checks.equal, checks.expect

-- Short and thick, so that shear counts; upright y, along x. Iy is not Ix.
local E, G, A, Ix, Iy, J, Ax, Ay = 200e9, 77e9, 0.02, 8e-5, 3e-5, 5e-5, 0.009, 0.011
local rho, L, g = 7850, 2, 9.8
local w = rho * A * g -- N/m
local steel = hinge.material { E = E, G = G, density = rho }
local section = hinge.section.general { area = A, Ix = Ix, Iy = Iy, J = J, shear_area_x = Ax, shear_area_y = Ay }

local function merged(a, b)
  local t = {}
  for k, v in pairs(a or {}) do t[k] = v end
  for k, v in pairs(b or {}) do t[k] = v end
  return t
end
-- Joints at `points`, one member between each and the next; fixed: by joint.
local function beam(points, fixed, options, gravity)
  local s = { model = hinge.model(merged({ displacement = "small" }, options)), node = {}, member = {} }
  for i, p in ipairs(points) do s.node[i] = s.model:node(p) end
  for i, what in pairs(fixed) do s.model:fix(s.node[i], what) end
  for i = 1, #points - 1 do
    s.member[i] = s.model:member { s.node[i], s.node[i + 1], section = section, material = steel, up = { 0, 0, 1 },
      group = "beam" }
  end
  s.model:gravity(gravity or { 0, 0, -g })
  return s
end
local function finished(run, what)
  run:finish()
  equal(run.verdict, "completed", what or "verdict")
  return run
end
local function solve(s, options) return finished(s.model:static(options or { steps = 1 }), "statics") end
local function close(value, wanted, what, part) near(value, wanted, (part or 1e-9) * math.abs(wanted) + 1e-12, what) end
local function straight(...) return beam({ { 0, 0, 0 }, { L, 0, 0 } }, ...) end

local elements = { { 2, "linear" }, { 4, "linear" }, { 8, "linear" }, { 2, "cubic" }, { 4, "cubic" } }
case("beams of two, four and eight elements carry their weight as theory has it", function()
  for _, kind in ipairs(elements) do
    local n, mass = kind[1], kind[2]
    local function options(more) return merged({ elements_per_member = n, mass = mass }, more) end
    local what = ("%d elements, %s mass: "):format(n, mass)

    -- Clamped: about both axes.
    local s = straight({ "all", "all" }, options())
    local run = solve(s)
    local a, b = s.member[1]:forces(run)
    close(math.abs(a.Mx), w * L ^ 2 / 12, what .. "clamped, moment at a")
    close(b.Mx, a.Mx, what .. "clamped, moment at b")
    close(math.abs(a.Qy), w * L / 2, what .. "clamped, shear at a")
    close(b.Qy, -a.Qy, what .. "clamped, shear at b")
    local r = { run:reaction(s.node[1]) }
    close(r[3], w * L / 2, what .. "clamped, reaction")
    close(math.abs(r[5]), w * L ^ 2 / 12, what .. "clamped, moment of the support")
    s = straight({ "all", "all" }, options(), { 0, 2 * g, 0 })
    a = s.member[1]:forces(solve(s))
    close(math.abs(a.My), w * L ^ 2 / 6, what .. "clamped, aside, moment")
    close(math.abs(a.Qx), w * L, what .. "clamped, aside, shear")

    -- Pinned: nothing at the ends; slopes there are w L^3/24EI. Of two members the middle is exact, too.
    s = straight({ "x,y,z,rx", "y,z,rx" }, options())
    run = solve(s)
    a = s.member[1]:forces(run)
    near(a.Mx, 0, 1e-9 * w * L ^ 2, what .. "pinned, moment")
    close(math.abs(a.Qy), w * L / 2, what .. "pinned, shear")
    close(math.abs(select(5, run:displacement(s.node[1]))), w * L ^ 3 / (24 * E * Ix), what .. "pinned, slope")
    s = beam({ { 0, 0, 0 }, { L / 2, 0, 0 }, { L, 0, 0 } }, { "x,y,z,rx", nil, "y,z,rx" }, options())
    run = solve(s)
    close(select(3, run:displacement(s.node[2])), -5 * w * L ^ 4 / (384 * E * Ix) - w * L ^ 2 / (8 * G * Ay),
      what .. "pinned, middle")
    local _, middle = s.member[1]:forces(run)
    close(math.abs(middle.Mx), w * L ^ 2 / 8, what .. "pinned, moment in the middle")
    near(middle.Qy, 0, 1e-9 * w * L, what .. "pinned, shear in the middle")

    -- Propped: with shear the wall has w L^2/8 / (1 + phi/4), phi = 12 EI / GA L^2.
    s = straight({ "all", "y,z,rx" }, options())
    a, b = s.member[1]:forces(solve(s))
    local wall = w * L ^ 2 / 8 / (1 + 3 * E * Ix / (G * Ay * L ^ 2))
    close(math.abs(a.Mx), wall, what .. "propped, moment at the wall")
    close(math.abs(a.Qy), w * L / 2 + wall / L, what .. "propped, shear at the wall")
    near(b.Mx, 0, 1e-9 * wall, what .. "propped, moment at the prop")
    close(math.abs(b.Qy), w * L / 2 - wall / L, what .. "propped, shear at the prop")

    -- Cantilever, along and across.
    s = straight({ "all" }, options(), { g, 0, -g })
    run = solve(s)
    close(select(3, run:displacement(s.node[2])), -w * L ^ 4 / (8 * E * Ix) - w * L ^ 2 / (2 * G * Ay),
      what .. "cantilever, tip")
    close((run:displacement(s.node[2])), w * L ^ 2 / (2 * E * A), what .. "cantilever, along")
    a, b = s.member[1]:forces(run)
    close(a.N, w * L, what .. "cantilever, N at the wall")
    close(math.abs(a.Mx), w * L ^ 2 / 2, what .. "cantilever, moment at the wall")
    close(math.abs(a.Qy), w * L, what .. "cantilever, shear at the wall")
    for name, value in pairs(b) do
      if name ~= "f_y" then near(value, 0, 1e-9 * w * L, what .. "cantilever, " .. name .. " at the tip") end
    end

    -- Inclined by 3 to 4.
    s = beam({ { 0, 0, 0 }, { 0.8 * L, 0, 0.6 * L } }, { "all", "all" }, options())
    run = solve(s)
    a, b = s.member[1]:forces(run)
    close(math.abs(a.Mx), 0.8 * w * L ^ 2 / 12, what .. "inclined, moment")
    close(math.abs(a.Qy), 0.8 * w * L / 2, what .. "inclined, shear")
    close(a.N, -0.6 * w * L / 2, what .. "inclined, N at the foot")
    close(b.N, 0.6 * w * L / 2, what .. "inclined, N at the head")
  end
end)

case("a portal under its weight has the corner moments of slope-deflection", function()
  -- A portal, clamped at its feet, without sway by symmetry: slope-deflection gives at the corners
  -- M = w l^2/12 * (4 E I/h) / (4 E I/h + 2 E I/l), with shear and axial strain made negligible.
  local model = hinge.model { displacement = "small" }
  local stiff = hinge.section.general { area = 1e4, Ix = Ix, Iy = Iy, J = J, shear_area_x = 1e6, shear_area_y = 1e6 }
  local light = hinge.material { E = E, G = G, density = rho * A / 1e4 }
  local h, l = 3, 5
  local n = { model:node { 0, 0, 0 }, model:node { 0, 0, h }, model:node { l, 0, h }, model:node { l, 0, 0 } }
  model:fix { n[1], n[4] }
  local m = {}
  for i = 1, 3 do
    m[i] = model:member { n[i], n[i + 1], section = stiff, material = light,
      up = { i == 2 and 0 or 1, 0, i == 2 and 1 or 0 } }
  end
  model:gravity { 0, 0, -g }
  local run = solve { model = model }
  local corner = w * l ^ 2 / 12 * (4 / h) / (4 / h + 2 / l)
  local a = m[2]:forces(run)
  close(math.abs(a.Mx), corner, "portal: moment at the corner", 1e-5)
  close(math.abs(a.Qy), w * l / 2, "portal: shear at the corner", 1e-5)
  local foot = m[1]:forces(run)
  close(math.abs(foot.Mx), corner / 2, "portal: moment at the foot", 1e-5)
  close(foot.N, -w * (h + l / 2), "portal: N at the foot", 1e-5)
end)

case("weight = nodes has the moments of the elements' own nodes", function()
  -- weight = "nodes": as elements alone have it.
  for n, part in pairs { [2] = 0.6339745962, [4] = 0.9084936490 } do
    local s = straight({ "all", "all" }, { elements_per_member = n, weight = "nodes" })
    local a = s.member[1]:forces(solve(s))
    close(math.abs(a.Mx), part * w * L ^ 2 / 12, ("at nodes, %d elements: moment"):format(n), 1e-8)
    close(math.abs(a.Qy), (1 - 1 / n) * w * L / 2, ("at nodes, %d elements: shear"):format(n))
  end
end)

case("gravity in load cases carries in proportion to its factor", function()
  -- Load cases: a factor, gravity that comes on, and gravity that is held.
  local model = hinge.model { displacement = "small" }
  local a, b = model:node { 0, 0, 0 }, model:node { L, 0, 0 }
  model:fix(a)
  model:fix(b, "y,z,rx")
  local m = model:member { a, b, section = section, material = steel, up = { 0, 0, 1 } }
  local dead, live = model:case "dead", model:case "live"
  dead:gravity { 0, 0, -g }
  live:load { member = m, q = { 0, 0, -w } }
  local wall = w * L ^ 2 / 8 / (1 + 3 * E * Ix / (G * Ay * L ^ 2))
  local function check(run, part, what)
    close(math.abs((m:forces(run)).Mx), part * wall, what .. ": moment")
    close(math.abs(select(5, run:reaction(a))), part * wall, what .. ": moment of the support")
    near(run.energy.energy_error, 0, 1e-9 * run.energy.elastic, what .. ": energy balance")
  end
  local half = finished(model:static { loads = { dead = 0.5 }, steps = 2 })
  check(half, 0.5, "half of gravity")
  check(finished(model:static { from = half, loads = { dead = 1, live = 2 }, steps = 4 }), 3, "gravity comes on")
  local part = model:static { from = half, loads = { dead = 1, live = 2 }, steps = 4 }
  part:step()
  check(part, 0.5 + 0.25 * 2.5, "a quarter of the way")
end)

-- At rest in dynamics, small and large, all integrators: what statics has, and it stays so.
local integrators = {
  { "newmark", { dt = 1e-4 } }, { "explicit", { dt = "auto", integrator = "explicit" } },
  { "energy-momentum", { dt = 1e-4, integrator = "energy-momentum" } },
}
case("a beam at rest under its weight stays so in dynamics, with the forces of statics", function()
  for _, displacement in ipairs { "small", "large" } do
    for _, how in ipairs(integrators) do
      if displacement == "large" or how[1] ~= "energy-momentum" then
        local what = ("%s, %s displacement: "):format(how[1], displacement)
        local s = beam({ { 0, 0, 0 }, { 0.8 * L, 0, 0.6 * L }, { 1.8 * L, 0, 0.6 * L } }, { "all", nil, "all" },
          { displacement = displacement })
        local rest = solve(s, { steps = 2, tolerance = 1e-12 })
        local there = s.member[2]:forces(rest)
        local options = merged(how[2], { from = rest, duration = 0.01, rest = false })
        local run = finished(s.model:dynamic(options), what .. "verdict")
        local now = s.member[2]:forces(run)
        for _, name in ipairs { "Mx", "Qy" } do close(now[name], there[name], what .. name, 1e-6) end
        near(run.energy.kinetic, 0, 1e-12 * w * L, what .. "kinetic energy at rest")
      end
    end
  end
end)

case("large displacement is small displacement where little bends", function()
  -- Large displacement, little of it: as in small displacement.
  local s = straight({ "all", "all" }, { displacement = "large" })
  local a = s.member[1]:forces(solve(s))
  close(math.abs(a.Mx), w * L ^ 2 / 12, "large displacement: clamped", 1e-6)
end)

case("what falls freely is not bent and has no forces", function()
  -- What falls is not bent, and has no forces in it; what a support or a connector carries has the correction.
  for _, how in ipairs(integrators) do
    local s = straight({}, { displacement = "large" })
    local run = finished(s.model:dynamic(merged(how[2], { duration = 0.01 })))
    local a = s.member[1]:forces(run)
    near(a.Mx, 0, 1e-9 * w * L ^ 2, how[1] .. ", falls: moment")
    near(a.Qy, 0, 1e-9 * w * L, how[1] .. ", falls: shear")
    close(run:momentum().linear[3], -w * L * run.time, how[1] .. ", falls: momentum", 1e-9)
  end
end)

case("a beam held at its ends, by supports or springs, has the moments of its weight in dynamics", function()
  local function held(declare)
    local s = straight({ [2] = "all" }, { displacement = "large" })
    declare(s.model, s.node[1], s)
    local rest = solve(s, { steps = 1, tolerance = 1e-12 })
    local run = finished(s.model:dynamic { from = rest, dt = 1e-4, duration = 0.005, rest = false })
    return math.abs((s.member[1]:forces(run)).Mx)
  end
  local M = held(function(model, a) model:fix(a) end)
  close(M, w * L ^ 2 / 12, "held: moment", 1e-6)
  -- the same on springs, of which one is as good as rigid; the beam's own body has no support
  local s = straight({}, { displacement = "large" })
  for _, node in ipairs(s.node) do
    s.model:connector { node, ground = true,
      stiffness = { x = 1e11, y = 1e11, z = 1e11, rx = 1e11, ry = 1e11, rz = 1e11 } }
  end
  local rest = solve(s, { steps = 1, tolerance = 1e-12 })
  local run = finished(s.model:dynamic { from = rest, dt = 1e-4, duration = 0.005, rest = false })
  close(math.abs((s.member[1]:forces(run)).Mx), w * L ^ 2 / 12, "on springs: moment", 1e-3)
end)

case("a released beam swings far and keeps its energy", function()
  -- A beam that is released at one end swings far: the energy balance closes, as the one of weights at nodes does.
  for _, how in ipairs { { "newmark", { dt = 5e-4 }, 2e-6 },
    { "explicit", { dt = "auto", integrator = "explicit" }, 2e-6 },
    { "energy-momentum", { dt = 2e-3, integrator = "energy-momentum" }, 1e-9 } } do
    local function swing(weight)
      local soft = hinge.material { E = 2e9, density = rho }
      local thin = hinge.section.solid { width = 0.02, depth = 0.05 }
      local model = hinge.model { weight = weight }
      local a, b = model:node { 0, 0, 0 }, model:node { 1.5, 0, 0.3 }
      model:fix(a, "x,y,z,rx,rz")
      model:member { a, b, section = thin, material = soft, up = { 0, 0, 1 } }
      model:gravity { 0, 0.5, -g }
      local run = finished(model:dynamic(merged(how[2], { duration = 0.8 })), how[1] .. ": swing")
      return run, select(3, run:displacement(b))
    end
    local run, down = swing "members"
    local nodes, fell = swing "nodes"
    local e = run.energy
    expect(down < -1.2, "%s: the tip goes down by %g m", how[1], -down)
    near(e.energy_error / e.gravity, 0, how[3], how[1] .. ", swing: energy balance")
    near(nodes.energy.energy_error / nodes.energy.gravity, 0, how[3], how[1] .. ", swing at nodes: energy balance")
    expect(run.hash ~= nodes.hash and math.abs(down - fell) < 0.05, "%s: swing along members %g, at nodes %g m", how[1],
      down, fell)
  end
end)

case("gravity is accounted for as the height of the mass", function()
  -- The account of gravity: of a cantilever, half the way of a load that is let on at once is elastic energy.
  local s = straight({ "all" }, {})
  local run = solve(s, { steps = 3 })
  local e = run.energy
  near(e.energy_error, 0, 1e-12 * math.abs(e.gravity), "statics: energy balance")
  expect(e.gravity < 0 and math.abs(e.elastic + e.gravity - e.work) < 1e-9 * e.elastic,
    "statics: gravity %g, work %g J", e.gravity, e.work)
end)

case("an element that breaks keeps the energy balance of its weight", function()
  -- An element breaks: its member has no correction any more, the others keep theirs, and the energy balance closes.
  for _, how in ipairs { integrators[1], integrators[2] } do
    local model = hinge.model {}
    local n = { model:node { 0, 0, 0 }, model:node { L, 0, 0 }, model:node { 2 * L, 0, 0 } }
    model:fix { n[1], n[3] }
    local m = {}
    for i = 1, 2 do
      m[i] = model:member { n[i], n[i + 1], section = section, material = steel, up = { 0, 0, 1 },
        group = i == 1 and "breaks" or "stays" }
    end
    model:gravity { 0, 0, -g }
    local broken = false
    model:fracture { group = "breaks", where = "all", rule = function(at)
      if at.time < 0.002 or broken then return false end
      broken = true
      return true
    end }
    local rest = solve({ model = model }, { steps = 1 })
    local run = finished(model:dynamic(merged(how[2], { from = rest, duration = 0.02 })), how[1] .. ": break")
    equal(m[1]:state(run), "broken", how[1] .. ": a member is broken")
    near(run.energy.energy_error, 0, 2e-3 * run.energy.initial, how[1] .. ", break: energy balance")
    broken = false
    local half = finished(model:dynamic(merged(how[2], { from = rest, duration = 0.01 })))
    local on = finished(model:dynamic(merged(how[2], { from = half, duration = 0.01 })))
    close(select(5, on:displacement(n[2])), select(5, run:displacement(n[2])),
      how[1] .. ", break: as in a run from there", how[1] == "newmark" and 1e-6 or 1e-3)
  end
end)

case("members that their own weight would bring down are warned of in dynamics", function()
  -- In dynamics members that their own weight would bring down between clamped ends, beyond 16 M_p / L^2, have it at
  -- nodes: in their first instants nothing acts in between.
  for _, part in ipairs { 0.99, 1.01 } do
    local model = hinge.model { displacement = "small" }
    local a, b = model:node { 0, 0, 0 }, model:node { L, 0, 0 }
    model:fix { a, b }
    local m = model:member { a, b, section = hinge.section.solid { width = 0.1, depth = 0.2 }, up = { 0, 0, 1 },
      material = hinge.material { E = E, density = rho, yield_stress = 1e6 } }
    local weight = part * 16 * (0.1 * 0.2 ^ 2 / 4 * 1e6) / L ^ 2 -- N/m
    model:gravity { 0, 0, -weight / (rho * 0.02) }
    local x = m:forces(finished(model:dynamic { dt = 1e-9, duration = 2e-9 }))
    local there = math.abs(x.Mx) / (weight * L ^ 2)
    expect(part < 1 and there > 0.02 and there < 1 / 12 or part > 1 and there < 1e-6, "%g of the limit: %g", part,
      there)
  end

  for _, wrong in ipairs { "node", "lumped" } do
    local ok, message = pcall(hinge.model, { weight = wrong })
    expect(not ok and tostring(message):find("weight", 1, true), "weight = %s: %s", wrong, message)
  end
end)

checks.done()
