-- Even loads along members, by their weight (weight = "members") or by model:load, against closed forms: end forces,
-- reactions and deflections in statics and at rest in dynamics, about both axes, inclined, in a portal, with both
-- masses and all formulations; load cases and held gravity; bodies that fall; large swings; breaks; weight = "nodes".
--
-- Run: lua5.4 tests/script/actions/weight_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local scenes = require "scenes"
local short = require "actions.short_beam"
local hinge = require "hinge"
local checks = support.checks "weight"
local runs = require "runs"(checks)
local case, near, equal, expect = checks.case, checks.near, checks.equal, checks.expect
local with, completed = scenes.with, runs.completed

local E, G, A, Ix, Iy, J, Ay = short.E, short.G, short.A, short.Ix, short.Iy, short.J, short.Ay
local rho, L, g = short.rho, short.L, 9.8
local w = rho * A * g -- N/m
local tip = w * L ^ 4 / (8 * E * Ix) + w * L ^ 2 / (2 * G * Ay) -- of a cantilever

-- A beam under an acceleration, by gravity, or under the same load per length, by q.
local function beam(points, fixed, options, gravity, by)
  local s = short.beam(points, fixed, options)
  gravity = gravity or { 0, 0, -g }
  if by == "q" then
    s.model:load { group = "beam", q = { rho * A * gravity[1], rho * A * gravity[2], rho * A * gravity[3] } }
  else
    s.model:gravity(gravity)
  end
  return s
end
local function straight(...) return beam({ { 0, 0, 0 }, { L, 0, 0 } }, ...) end
local function solve(s, options) return completed(s.model:static(options or { steps = 1 }), "statics") end
local function close(value, wanted, what, part) near(value, wanted, (part or 1e-9) * math.abs(wanted) + 1e-12, what) end

local kinds = { { 2, "weight" }, { 4, "weight" }, { 8, "weight" }, { 2, "weight", mass = "cubic" },
  { 4, "weight", mass = "cubic" }, { 2, "q" }, { 4, "q" } }
local function of_kind(kind)
  return { elements_per_member = kind[1], mass = kind.mass, formulation = kind.formulation }, kind[2],
    ("%s on %d elements, %s: "):format(kind[2], kind[1], kind.mass or kind.formulation or "linear")
end

case("clamped beams carry an even load as theory has it, whatever their formulation", function()
  local all = { table.unpack(kinds) }
  for _, formulation in ipairs { "asi", "conventional" } do
    for n = 1, 4 do all[#all + 1] = { n, "q", formulation = formulation } end
  end
  for _, kind in ipairs(all) do
    local options, by, what = of_kind(kind)
    local s = straight({ "all", "all" }, options, nil, by)
    local run = solve(s)
    local a, b = s.member[1]:forces(run)
    close(math.abs(a.Mx), w * L ^ 2 / 12, what .. "moment at a")
    close(b.Mx, a.Mx, what .. "moment at b")
    close(math.abs(a.Qy), w * L / 2, what .. "shear at a")
    close(b.Qy, -a.Qy, what .. "shear at b")
    local r = { run:reaction(s.node[1]) }
    close(r[3], w * L / 2, what .. "reaction")
    close(math.abs(r[5]), w * L ^ 2 / 12, what .. "moment of the support")
    s = straight({ "all", "all" }, options, { 0, 2 * g, 0 }, by)
    a = s.member[1]:forces(solve(s))
    close(math.abs(a.My), w * L ^ 2 / 6, what .. "aside, moment")
    close(math.abs(a.Qx), w * L, what .. "aside, shear")
  end
end)

case("beams of two, four and eight elements carry an even load as theory has it", function()
  for _, kind in ipairs(kinds) do
    local options, by, what = of_kind(kind)
    -- Pinned: nothing at the ends; slopes there are w L^3/24EI. Of two members the middle is exact, too.
    local s = straight({ "x,y,z,rx", "y,z,rx" }, options, nil, by)
    local run = solve(s)
    local a, b = s.member[1]:forces(run)
    near(a.Mx, 0, 1e-9 * w * L ^ 2, what .. "pinned, moment at a")
    near(b.Mx, 0, 1e-9 * w * L ^ 2, what .. "pinned, moment at b")
    close(math.abs(a.Qy), w * L / 2, what .. "pinned, shear")
    close(math.abs(select(5, run:displacement(s.node[1]))), w * L ^ 3 / (24 * E * Ix), what .. "pinned, slope")
    s = beam({ { 0, 0, 0 }, { L / 2, 0, 0 }, { L, 0, 0 } }, { "x,y,z,rx", nil, "y,z,rx" }, options, nil, by)
    run = solve(s)
    close(select(3, run:displacement(s.node[2])), -5 * w * L ^ 4 / (384 * E * Ix) - w * L ^ 2 / (8 * G * Ay),
      what .. "pinned, middle")
    local _, middle = s.member[1]:forces(run)
    close(math.abs(middle.Mx), w * L ^ 2 / 8, what .. "pinned, moment in the middle")
    near(middle.Qy, 0, 1e-9 * w * L, what .. "pinned, shear in the middle")

    -- Propped: with shear the wall has w L^2/8 / (1 + phi/4), phi = 12 EI / GA L^2.
    s = straight({ "all", "y,z,rx" }, options, nil, by)
    a, b = s.member[1]:forces(solve(s))
    local wall = w * L ^ 2 / 8 / (1 + short.phi(Ix, Ay) / 4)
    close(math.abs(a.Mx), wall, what .. "propped, moment at the wall")
    close(math.abs(a.Qy), w * L / 2 + wall / L, what .. "propped, shear at the wall")
    near(b.Mx, 0, 1e-9 * wall, what .. "propped, moment at the prop")
    close(math.abs(b.Qy), w * L / 2 - wall / L, what .. "propped, shear at the prop")

    -- Cantilever, along and across.
    s = straight({ "all" }, options, { g, 0, -g }, by)
    run = solve(s)
    close(select(3, run:displacement(s.node[2])), -tip, what .. "cantilever, tip")
    close((run:displacement(s.node[2])), w * L ^ 2 / (2 * E * A), what .. "cantilever, along")
    a, b = s.member[1]:forces(run)
    close(a.N, w * L, what .. "cantilever, N at the wall")
    close(math.abs(a.Mx), w * L ^ 2 / 2, what .. "cantilever, moment at the wall")
    close(math.abs(a.Qy), w * L, what .. "cantilever, shear at the wall")
    for name, value in pairs(b) do
      if name ~= "f_y" then near(value, 0, 1e-9 * w * L, what .. "cantilever, " .. name .. " at the tip") end
    end

    -- Inclined by 3 to 4.
    s = beam({ { 0, 0, 0 }, { 0.8 * L, 0, 0.6 * L } }, { "all", "all" }, options, nil, by)
    run = solve(s)
    a, b = s.member[1]:forces(run)
    close(math.abs(a.Mx), 0.8 * w * L ^ 2 / 12, what .. "inclined, moment")
    close(math.abs(a.Qy), 0.8 * w * L / 2, what .. "inclined, shear")
    close(a.N, -0.6 * w * L / 2, what .. "inclined, N at the foot")
    close(b.N, 0.6 * w * L / 2, what .. "inclined, N at the head")
  end
end)

case("a portal under an even load has the corner moments of slope-deflection", function()
  -- A portal, clamped at its feet, without sway by symmetry: slope-deflection gives at the corners
  -- M = w l^2/12 * (4 E I/h) / (4 E I/h + 2 E I/l), with shear and axial strain made negligible.
  local h, l = 3, 5
  local stiff = { up = { 1, 0, 0 }, material = hinge.material { E = E, G = G, density = rho * A / 1e4 },
    section = hinge.section.general { area = 1e4, Ix = Ix, Iy = Iy, J = J, shear_area_x = 1e6, shear_area_y = 1e6 } }
  for _, by in ipairs { "weight", "q" } do
    local model, _, m = scenes.portal { model = { displacement = "small" }, width = l, height = h, column = stiff,
      beam = with(stiff, { up = { 0, 0, 1 } }) }
    if by == "q" then model:load { member = m[2], q = { 0, 0, -w } } else model:gravity { 0, 0, -g } end
    local run = solve { model = model }
    local corner = w * l ^ 2 / 12 * (4 / h) / (4 / h + 2 / l)
    local a, foot = m[2]:forces(run), m[1]:forces(run)
    close(math.abs(a.Mx), corner, by .. ": moment at the corner", 1e-5)
    close(math.abs(a.Qy), w * l / 2, by .. ": shear at the corner", 1e-5)
    close(math.abs(foot.Mx), corner / 2, by .. ": moment at the foot", 1e-5)
    close(foot.N, -w * ((by == "q" and 0 or h) + l / 2), by .. ": N at the foot", 1e-5)
  end
end)

case("weight = nodes has the moments of the elements' own nodes", function()
  for n, part in pairs { [2] = 0.6339745962, [4] = 0.9084936490 } do
    local s = straight({ "all", "all" }, { elements_per_member = n, weight = "nodes" })
    local a = s.member[1]:forces(solve(s))
    close(math.abs(a.Mx), part * w * L ^ 2 / 12, ("at nodes, %d elements: moment"):format(n), 1e-8)
    close(math.abs(a.Qy), (1 - 1 / n) * w * L / 2, ("at nodes, %d elements: shear"):format(n))
  end
  for _, n in ipairs { 2, 20 } do
    local s = straight({ "all" }, { elements_per_member = n, weight = "nodes" })
    close(select(3, solve(s):displacement(s.node[2])), -tip, ("at nodes, %d elements: tip"):format(n),
      0.485 / n ^ 2) -- 0.479 / n^2 by the lumping
  end
end)

case("gravity in load cases carries in proportion to its factor", function()
  -- a factor, gravity that comes on, and gravity that is held
  local s = short.straight { "all", "y,z,rx" }
  local model, m = s.model, s.member[1]
  local dead, live = model:case "dead", model:case "live"
  dead:gravity { 0, 0, -g }
  live:load { member = m, q = { 0, 0, -w } }
  local wall = w * L ^ 2 / 8 / (1 + short.phi(Ix, Ay) / 4)
  local function check(run, part, what)
    close(math.abs((m:forces(run)).Mx), part * wall, what .. ": moment")
    close(math.abs(select(5, run:reaction(s.node[1]))), part * wall, what .. ": moment of the support")
    runs.balanced(run, 1e-9, "elastic", what)
  end
  local half = completed(model:static { loads = { dead = 0.5 }, steps = 2 })
  check(half, 0.5, "half of gravity")
  check(completed(model:static { from = half, loads = { dead = 1, live = 2 }, steps = 4 }), 3, "gravity comes on")
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
        local run = completed(s.model:dynamic(with(how[2], { from = rest, duration = 0.01, rest = false })), what)
        local now = s.member[2]:forces(run)
        for _, name in ipairs { "Mx", "Qy" } do close(now[name], there[name], what .. name, 1e-6) end
        near(run.energy.kinetic, 0, 1e-12 * w * L, what .. "kinetic energy at rest")
      end
    end
  end
end)

case("large displacement is small displacement where little bends", function()
  local s = straight({ "all", "all" }, { displacement = "large" })
  close(math.abs((s.member[1]:forces(solve(s))).Mx), w * L ^ 2 / 12, "large displacement: clamped", 1e-6)
end)

case("what falls freely is not bent and has no forces", function()
  for _, how in ipairs(integrators) do
    local s = straight({}, { displacement = "large" })
    local run = completed(s.model:dynamic(with(how[2], { duration = 0.01 })))
    local a = s.member[1]:forces(run)
    near(a.Mx, 0, 1e-9 * w * L ^ 2, how[1] .. ", falls: moment")
    near(a.Qy, 0, 1e-9 * w * L, how[1] .. ", falls: shear")
    close(run:momentum().linear[3], -w * L * run.time, how[1] .. ", falls: momentum", 1e-9)
  end
end)

case("a beam held by springs has the moments of its weight in dynamics", function()
  -- of which one is as good as rigid; the beam's own body has no support
  local s = straight({}, { displacement = "large" })
  local stiffness = { x = 1e11, y = 1e11, z = 1e11, rx = 1e11, ry = 1e11, rz = 1e11 }
  for _, node in ipairs(s.node) do s.model:connector { node, ground = true, stiffness = stiffness } end
  local rest = solve(s, { steps = 1, tolerance = 1e-12 })
  local run = completed(s.model:dynamic { from = rest, dt = 1e-4, duration = 0.005, rest = false })
  close(math.abs((s.member[1]:forces(run)).Mx), w * L ^ 2 / 12, "on springs: moment", 1e-3)
end)

case("a released beam swings far and keeps its energy", function()
  -- the energy balance closes, as the one of weights at nodes does
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
      local run = completed(model:dynamic(with(how[2], { duration = 0.8 })), how[1] .. ": swing")
      runs.balanced(run, how[3], "gravity", how[1] .. ", weight of " .. weight)
      return run, select(3, run:displacement(b))
    end
    local run, down = swing "members"
    local nodes, fell = swing "nodes"
    expect(down < -1.2, "%s: the tip goes down by %g m", how[1], -down)
    expect(run.hash ~= nodes.hash and math.abs(down - fell) < 0.05, "%s: swing along members %g, at nodes %g m", how[1],
      down, fell)
  end
end)

case("gravity is accounted for as the height of the mass", function()
  -- of a cantilever, half the way of a load that is let on at once is elastic energy
  local run = solve(straight { "all" }, { steps = 3 })
  local e = run.energy
  runs.balanced(run, 1e-12, "gravity", "statics")
  expect(e.gravity < 0 and math.abs(e.elastic + e.gravity - e.work) < 1e-9 * e.elastic,
    "statics: gravity %g, work %g J", e.gravity, e.work)
end)

case("an element that breaks keeps the energy balance of its weight", function()
  -- its member has no correction any more, the others keep theirs
  for _, how in ipairs { integrators[1], integrators[2] } do
    local s = beam({ { 0, 0, 0 }, { L, 0, 0 }, { 2 * L, 0, 0 } }, { "all", nil, "all" }, { displacement = "large" })
    local model, broken = s.model, false
    model:fracture { where = "all", rule = function(at)
      if at.member ~= 1 or at.time < 0.002 or broken then return false end
      broken = true
      return true
    end }
    local rest = solve(s)
    local run = completed(model:dynamic(with(how[2], { from = rest, duration = 0.02 })), how[1] .. ": break")
    equal(s.member[1]:state(run), "broken", how[1] .. ": a member is broken")
    runs.balanced(run, 2e-3, "initial", how[1] .. ", break")
    broken = false
    local half = completed(model:dynamic(with(how[2], { from = rest, duration = 0.01 })))
    local on = completed(model:dynamic(with(how[2], { from = half, duration = 0.01 })))
    close(select(5, on:displacement(s.node[2])), select(5, run:displacement(s.node[2])),
      how[1] .. ", break: as in a run from there", how[1] == "newmark" and 1e-6 or 1e-3)
  end
end)

case("members that their own weight would bring down are warned of in dynamics", function()
  -- In dynamics members that their own weight would bring down between clamped ends, beyond 16 M_p / L^2, have it at
  -- nodes: in their first instants nothing acts in between.
  for _, part in ipairs { 0.99, 1.01 } do
    local model, node, m = scenes.cantilever { length = L, model = { displacement = "small" }, member = {
      section = hinge.section.solid { width = 0.1, depth = 0.2 }, up = { 0, 0, 1 },
      material = hinge.material { E = E, density = rho, yield_stress = 1e6 } } }
    model:fix(node)
    local weight = part * 16 * (0.1 * 0.2 ^ 2 / 4 * 1e6) / L ^ 2 -- N/m
    model:gravity { 0, 0, -weight / (rho * 0.02) }
    local x = m:forces(completed(model:dynamic { dt = 1e-9, duration = 2e-9 }))
    local there = math.abs(x.Mx) / (weight * L ^ 2)
    expect(part < 1 and there > 0.02 and there < 1 / 12 or part > 1 and there < 1e-6, "%g of the limit: %g", part,
      there)
  end
  for _, wrong in ipairs { "node", "lumped" } do checks.refused("'weight'", hinge.model, { weight = wrong }) end
end)

checks.done()
