-- Loads on members against closed forms: fixed-end forces, deflections, frames; in dynamics momentum, energy and
-- histories; what checkpoints, undo and idle loads make of them; and wrong input.
--
-- Run: lua5.4 tests/script/actions/member_loads_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local hinge = require "hinge"
local checks = support.checks "member_loads"
local case, near, equal, expect = checks.case, checks.near, checks.equal, checks.expect

-- A short thick beam, so that shear counts; upright y, along x. Iy is not Ix.
local E, G, A, Ix, Iy, J, Ax, Ay = 200e9, 77e9, 0.02, 8e-5, 3e-5, 5e-5, 0.009, 0.011
local rho, L = 7850, 2
local steel = hinge.material { E = E, G = G, density = rho }
local section = hinge.section.general { area = A, Ix = Ix, Iy = Iy, J = J, shear_area_x = Ax, shear_area_y = Ay }

-- Joints at `points`, one member between each and the next; fixed: by joint.
local function beam(points, fixed, options)
  local model = hinge.model(options or { displacement = "small" })
  local s = { model = model, node = {}, member = {} }
  for i, p in ipairs(points) do s.node[i] = model:node(p) end
  for i, what in pairs(fixed) do model:fix(s.node[i], what) end
  for i = 1, #points - 1 do
    s.member[i] = model:member { s.node[i], s.node[i + 1], section = section, material = steel,
      up = { 0, 0, 1 }, group = "beam" }
  end
  return s
end
local function solve(s, options)
  local run = s.model:static(options or { steps = 1 })
  run:finish()
  equal(run.verdict, "completed", "verdict in statics")
  return run
end
local function close(value, wanted, what, part) near(value, wanted, (part or 1e-9) * math.abs(wanted) + 1e-12, what) end

-- Section forces at the two ends, as signed sums: with z along the member and y up, q = -w along y asks
-- Qy = w L/2 at the first end and bends it with M(z) = EI theta'; so M = ... is checked by its size and by balance.
local w = 3e4
case("an even load on a clamped beam has the fixed-end moments and reactions of theory", function()
  for _, formulation in ipairs { "asi-gauss", "asi", "conventional" } do
    for _, n in ipairs(formulation == "asi-gauss" and { 2, 4 } or { 1, 2, 3, 4 }) do
      local what = ("clamped, %s, %d elements: "):format(formulation, n)
      local s = beam({ { 0, 0, 0 }, { L, 0, 0 } }, { "all", "all" },
        { displacement = "small", formulation = formulation, elements_per_member = n })
      s.model:load { member = s.member[1], q = { 0, 0, -w } }
      local run = solve(s)
      local a, b = s.member[1]:forces(run)
      close(math.abs(a.Mx), w * L ^ 2 / 12, what .. "moment at a")
      close(a.Mx, b.Mx, what .. "moment at b")
      close(math.abs(a.Qy), w * L / 2, what .. "shear at a")
      close(a.Qy, -b.Qy, what .. "shear at b")
      local r = { run:reaction(s.node[1]) }
      close(r[3], w * L / 2, what .. "reaction")
      close(math.abs(r[5]), w * L ^ 2 / 12, what .. "moment of the support")
    end
  end
end)

-- Triangular, trapezoidal and point loads, about both axes, in a clamped beam; shear flexibility does not change
-- symmetric fixed-end moments, but these.
local function phi(I, area) return 12 * E * I / (G * area * L ^ 2) end
local function point_moments(P, part, f) -- at a and b, sizes
  local a, b = part * L, (1 - part) * L
  return P * a * b / L ^ 2 * (b + f * L / 2) / (1 + f), P * a * b / L ^ 2 * (a + f * L / 2) / (1 + f)
end
local function spread_moments(qa, qb, f) -- by the sum over many point loads (Simpson)
  local n, ma, mb = 200, 0, 0
  for i = 0, n do
    local x, weight = i / n, (i == 0 or i == n) and 1 or i % 2 == 1 and 4 or 2
    local a, b = point_moments(weight / 3 / n * L * (qa + (qb - qa) * x), x, f)
    ma, mb = ma + a, mb + b
  end
  return ma, mb
end
case("triangular, trapezoidal and point loads have the fixed-end moments of theory about both axes", function()
  for axis, about in pairs { [3] = "My", [2] = "Mz" } do -- space z is local y: bends about local x (space y)
    local f = axis == 3 and phi(Ix, Ay) or phi(Iy, Ax)
    local moment = axis == 3 and "Mx" or "My"
    local function force(size) return { 0, axis == 2 and -size or 0, axis == 3 and -size or 0 } end
    for name, row in pairs {
      ["point load at 0.3"] = { { at = 0.3, force = force(w) }, { point_moments(w, 0.3, f) } },
      ["triangle"] = { { q = { b = force(w) } }, { spread_moments(0, w, f) } },
      ["trapezoid"] = { { q = { a = force(w), b = force(2.5 * w) } }, { spread_moments(w, 2.5 * w, f) } },
    } do
      local s = beam({ { 0, 0, 0 }, { L, 0, 0 } }, { "all", "all" })
      row[1].member = s.member[1]
      s.model:load(row[1])
      local a, b = s.member[1]:forces(solve(s))
      local what = ("%s, axis %d (%s): "):format(name, axis, about)
      close(math.abs(a[moment]), row[2][1], what .. "moment at a", 1e-8)
      close(math.abs(b[moment]), row[2][2], what .. "moment at b", 1e-8)
    end
  end
end)

case("a triangular load without shear flexibility has moments w L^2/30 and w L^2/20", function()
  local a, b = spread_moments(0, w, 0)
  close(a, w * L ^ 2 / 30, "triangle, textbook, at a", 1e-8)
  close(b, w * L ^ 2 / 20, "triangle, textbook, at b", 1e-8)
end)

case("a cantilever under loads along it has the tip and section forces of theory", function()
  -- Cantilever: tip under a uniform load, axial load, torsion and moment per length; section forces at the wall and
  -- none at the tip.
  local s = beam({ { 0, 0, 0 }, { L, 0, 0 } }, { "all" })
  s.model:load { member = s.member[1], q = { 2 * w, -w, -w }, moment = { 500, 300, 0 } }
  local run = solve(s)
  local u = { run:displacement(s.node[2]) }
  -- a moment m per length about space y rotates the tip by m L^2/(2 E I) and lowers it by m L^3/(3 E I)
  close(u[3], -w * L ^ 4 / (8 * E * Ix) - w * L ^ 2 / (2 * G * Ay) - 300 * L ^ 3 / (3 * E * Ix), "cantilever: down")
  close(u[2], -w * L ^ 4 / (8 * E * Iy) - w * L ^ 2 / (2 * G * Ax), "cantilever: aside")
  close(u[1], 2 * w * L ^ 2 / (2 * E * A), "cantilever: along")
  close(u[4], 500 * L ^ 2 / (2 * G * J), "cantilever: twist")
  local a, b = s.member[1]:forces(run)
  close(a.N, 2 * w * L, "cantilever: N at the wall")
  close(math.abs(a.Mx), w * L ^ 2 / 2 + 300 * L, "cantilever: Mx at the wall")
  close(math.abs(a.My), w * L ^ 2 / 2, "cantilever: My at the wall")
  close(a.Mz, 500 * L, "cantilever: Mz at the wall")
  for name, value in pairs(b) do
    if name ~= "f_y" then near(value, 0, 1e-9 * w * L, "cantilever: " .. name .. " at the tip") end
  end
end)

case("simply supported and propped beams have the reactions and moments of theory", function()
  -- Simply supported, of two members, and propped.
  local s = beam({ { 0, 0, 0 }, { L / 2, 0, 0 }, { L, 0, 0 } }, { "x,y,z,rx", nil, "y,z,rx" })
  s.model:load { group = "beam", q = { 0, 0, -w } }
  local run = solve(s)
  local u = { run:displacement(s.node[2]) }
  close(u[3], -5 * w * L ^ 4 / (384 * E * Ix) - w * L ^ 2 / (8 * G * Ay), "simply supported: middle")
  local _, b = s.member[1]:forces(run)
  close(math.abs(b.Mx), w * L ^ 2 / 8, "simply supported: moment in the middle")
  near(b.Qy, 0, 1e-8 * w * L, "simply supported: shear in the middle")

  s = beam({ { 0, 0, 0 }, { L, 0, 0 } }, { "all", "y,z,rx" })
  s.model:load { member = s.member[1], q = { 0, 0, -w } }
  local f = phi(Ix, Ay)
  local wall = w * L ^ 2 / 8 / (1 + f / 4) -- the clamped beam's moment, and half or so of it carried over
  local a, e = s.member[1]:forces(solve(s))
  close(math.abs(a.Mx), wall, "propped: moment at the wall")
  near(e.Mx, 0, 1e-9 * wall, "propped: moment at the prop")
end)

case("a portal under an even load has the corner moments of slope-deflection", function()
  -- A portal, clamped at its feet, of height h and span l, no sway by symmetry: slope-deflection gives at the corners
  -- M = w l^2/12 * (4 E I_c/h) / (4 E I_c/h + 2 E I_b/l), with shear and axial strain made negligible.
  local model = hinge.model { displacement = "small" }
  local stiff = hinge.section.general { area = 1e4, Ix = Ix, Iy = Iy, J = J, shear_area_x = 1e6, shear_area_y = 1e6 }
  local h, l = 3, 5
  local n = { model:node { 0, 0, 0 }, model:node { 0, 0, h }, model:node { l, 0, h }, model:node { l, 0, 0 } }
  model:fix(n[1])
  model:fix(n[4])
  local m = {}
  for i = 1, 3 do
    m[i] = model:member { n[i], n[i + 1], section = stiff, material = steel,
      up = { i == 2 and 0 or 1, 0, i == 2 and 1 or 0 } }
  end
  model:load { member = m[2], q = { 0, 0, -w } }
  local run = solve { model = model }
  local corner = w * l ^ 2 / 12 * (4 / h) / (4 / h + 2 / l)
  local a = m[2]:forces(run)
  close(math.abs(a.Mx), corner, "portal: moment at the corner", 1e-5)
  local foot = m[1]:forces(run)
  close(math.abs(foot.Mx), corner / 2, "portal: moment at the foot", 1e-5)
end)

case("loads per plan length, per own length and across an inclined member", function()
  -- Inclined: snow per plan length, dead weight per own length, pressure across it.
  local rise = 1.2
  local length = math.sqrt(L ^ 2 + rise ^ 2)
  local function roof(more)
    local s = beam({ { 0, 0, 0 }, { L, 0, rise } }, { "all", "all" })
    more.member = s.member[1]
    s.model:load(more)
    local run = solve(s)
    local r, t = { run:reaction(s.node[1]) }, { run:reaction(s.node[2]) }
    return r[1] + t[1], r[3] + t[3], s.member[1]:forces(run)
  end
  local x, z, a = roof { q = { 0, 0, -w }, axes = "projected" }
  near(x, 0, 1e-6, "snow: sideways")
  close(z, w * L, "snow: sum")
  close(math.abs(a.Mx), w * L ^ 2 / 12, "snow: end moment")
  x, z, a = roof { q = { 0, 0, -w } }
  close(z, w * length, "weight: sum")
  close(math.abs(a.Mx), w * length * L / 12, "weight: end moment")
  near(x, 0, 1e-6, "weight: sideways")
  x, z, a = roof { q = { 0, -w, 0 }, axes = "local" }
  close(x, -w * rise, "pressure: sideways")
  close(z, w * L, "pressure: down")
  close(math.abs(a.Mx), w * length ^ 2 / 12, "pressure: end moment")
end)

case("a load of the weight per length acts as gravity does", function()
  -- The weight per length is gravity; with weight at nodes to the error of the mass's lumping.
  local function sag(n, declare, weight)
    local s = beam({ { 0, 0, 0 }, { L, 0, 0 } }, { "all" },
      { displacement = "small", elements_per_member = n, weight = weight })
    declare(s)
    return (select(3, solve(s):displacement(s.node[2])))
  end
  for _, n in ipairs { 2, 20 } do
    local q = sag(n, function(s) s.model:load { member = s.member[1], q = { 0, 0, -rho * A * 9.8 } } end)
    local function g(weight) return sag(n, function(s) s.model:gravity { 0, 0, -9.8 } end, weight) end
    close(g "members", q, ("gravity and q, %d elements"):format(n))
    close(g "nodes", q, ("gravity at nodes and q, %d elements"):format(n), 0.485 / n ^ 2) -- 0.479 / n^2 by the lumping
  end
end)

-- Dynamics ----------------------------------------

local function balance(run, what, part)
  local e = run.energy
  near(e.energy_error, 0, part * math.abs(e.work), what .. ": energy balance")
end

-- A free bar under q has the momentum q L t, whatever the steps; its spin too.
case("a free bar under an even load has the momentum q L t", function()
  for _, integrator in ipairs { "newmark", "explicit" } do
    local s = beam({ { 0, 0, 0 }, { L, 0, 0 } }, {}, { displacement = "large" })
    s.model:load { member = s.member[1], q = { a = { 0, 0, 3000 }, b = { 0, 900, -2000 } } }
    local options = { duration = 0.02, dt = 2e-5 }
    if integrator == "explicit" then options.integrator, options.dt = "explicit", "auto" end
    local run = s.model:dynamic(options)
    run:finish()
    equal(run.verdict, "completed", integrator .. ": verdict")
    local p = run:momentum()
    close(p.linear[3], 500 * L * run.time, integrator .. ": momentum", 1e-6)
    close(p.linear[2], 450 * L * run.time, integrator .. ": momentum aside", 1e-6)
    balance(run, integrator .. ", free bar", integrator == "explicit" and 2e-5 or 1e-6)
  end
end)

-- Let on suddenly, a load lowers the joint twice as far as at rest (the lowest mode alone: a light beam, a heavy end).
local function swing(options, load, model)
  local s = beam({ { 0, 0, 0 }, { L / 2, 0, 0 }, { L, 0, 0 } }, { "all", nil, "all" }, model)
  load.group = "beam"
  s.model:load(load)
  local run = s.model:dynamic(options)
  local probe = run:probe { node = s.node[2], "uz" }
  run:finish()
  equal(run.verdict, "completed", "verdict in dynamics")
  local lowest = 0
  for _, v in ipairs(probe.value) do lowest = -support.largest_of(-lowest, -v) end
  return lowest, run, probe
end
case("a load let on suddenly lowers the joint twice as far as at rest", function()
  local rest = -w * L ^ 4 / (384 * E * Ix) - w * L ^ 2 / (8 * G * Ay)
  local lowest, run = swing({ dt = 1e-5, duration = 8e-3 }, { q = { 0, 0, -w } }, { displacement = "small" })
  near(lowest / rest, 2, 0.06, "let on at once: twice the deflection")
  balance(run, "let on at once", 1e-6)
  -- over ten periods: hardly a swing
  lowest, run = swing({ dt = 2e-5, duration = 0.06 },
    { q = { 0, 0, -w }, history = { { 0, 0 }, { 0.05, 1 } } }, { displacement = "small" })
  near(lowest / rest, 1, 0.06, "let on slowly: as at rest")
  balance(run, "let on slowly", 1e-6)
  lowest, run = swing({ integrator = "explicit", dt = "auto", duration = 8e-3 }, { q = { 0, 0, -w } }, {})
  near(lowest / rest, 2, 0.1, "explicit, let on at once")
  balance(run, "explicit", 5e-3) -- of second order in dt
end)

-- Large displacement: a load in local axes rotates with its cantilever.
case("a load in local axes rotates with its member", function()
  local s = beam({ { 0, 0, 0 }, { L, 0, 0 } }, { "all" }, { displacement = "large", elements_per_member = 8 })
  s.model:load { member = s.member[1], q = { 0, E * Ix / L ^ 3, 0 }, axes = "local" }
  local run = solve(s, { steps = 4 })
  local _, _, up, _, turn = run:displacement(s.node[2])
  -- fine mesh of the same, as follower forces of the elements alone converge to it
  local fine = beam({ { 0, 0, 0 }, { L, 0, 0 } }, { "all" }, { displacement = "large", elements_per_member = 40 })
  fine.model:load { member = fine.member[1], q = { 0, E * Ix / L ^ 3, 0 }, axes = "local" }
  local other = solve(fine, { steps = 4 })
  local _, _, up_fine, _, turn_fine = other:displacement(fine.node[2])
  close(up, up_fine, "follower pressure: up", 3e-3)
  close(turn, turn_fine, "follower pressure: rotation", 3e-3)
  -- equilibrium: the supports hold what the pressure asks where it is
  local a = s.member[1]:forces(run)
  expect(math.abs(a.Mx) < 0.5 * E * Ix / L, "follower pressure: less than the dead load's moment")
end)

-- Of a free bar one element of four breaks: its quarter of the load is gone from then on, and nothing else.
-- M. Levy 1884: 3 EI / R^3 where the pressure stays normal to the ring, 4 where it keeps its direction; 16 straight
-- members a quarter are 0.4 % above.
case("statics tells of the pressure at which a ring buckles, in local axes and in space", function()
  local I, members = 1e-10, 16
  local thin = hinge.section.general { area = 1e-2, Ix = I, Iy = 1e3 * I, J = I, shear_area_x = 0.1,
    shear_area_y = 0.1 }
  for axes, wanted in pairs { ["local"] = 3, global = 4 } do
    local model, n = hinge.model { plasticity = false }, {}
    for i = 0, members do
      local t = math.pi / 2 * i / members
      n[i] = model:node { math.cos(t), 0, math.sin(t) }
      model:fix(n[i], i == 0 and "y,z,rx,ry,rz" or i == members and "x,y,rx,ry,rz" or "y,rx,rz")
      if i > 0 then
        local middle, q = t - math.pi / 4 / members, 1.2 * wanted * 206e9 * I
        local out = { math.cos(middle), 0, math.sin(middle) }
        model:load { axes = axes, q = axes == "local" and { 0, -q, 0 } or { -q * out[1], 0, -q * out[3] },
          member = model:member { n[i - 1], n[i], section = thin, material = hinge.material { E = 206e9 }, up = out } }
      end
    end
    local run = model:static { steps = 20 }:finish()
    if expect(run.instability, "%s axes: the run tells of an instability: %s", axes, run.reason) then
      near(1.2 * wanted * run.instability.factor, wanted, 6e-3 * wanted, axes .. " axes: p R^3 / EI")
    end
  end
end)

case("an element that breaks loses its part of the load and nothing else", function()
  for _, integrator in ipairs { "newmark", "explicit" } do
    local s = beam({ { 0, 0, 0 }, { L, 0, 0 } }, {}, { displacement = "large", elements_per_member = 4 })
    s.model:load { member = s.member[1], q = { 0, 0, 3000 } }
    local broke
    s.model:fracture(function(at)
      if at.element ~= 2 or at.time < 4e-3 then return false end
      broke = at.time
      return true
    end)
    local options = { duration = 8e-3, dt = 2e-5 }
    if integrator == "explicit" then options.integrator, options.dt = "explicit", "auto" end
    local run = s.model:dynamic(options)
    run:finish()
    equal(run.verdict, "completed", integrator .. ", broken: verdict")
    equal(run:count { state = "broken" }, 1, integrator .. ": members broken")
    close(run:momentum().linear[3], 3000 * L * (broke + 0.75 * (run.time - broke)), integrator .. ", broken: momentum",
      1e-6)
    balance(run, integrator .. ", broken", 1e-4)
  end
end)

-- At rest under its load, from statics: it stays so, with the same end forces.
case("a beam at rest under its load stays at rest in dynamics", function()
  local s = beam({ { 0, 0, 0 }, { L, 0, 0 } }, { "all" }, { displacement = "large" })
  s.model:load { group = "beam", q = { 0, 0, -w } }
  s.model:load { group = "beam", q = { 0, -w, 0 }, axes = "local" }
  local start = solve(s, { steps = 10 })
  near(start.energy.energy_error, 0, 1e-5 * start.energy.work, "statics: energy balance")
  for _, rest in ipairs { true, false } do
    local run = s.model:dynamic { from = start, dt = 1e-4, duration = 0.02, rest = rest }
    run:finish()
    close(s.member[1]:forces(run).Mx, s.member[1]:forces(start).Mx, "at rest: moment at the wall", 1e-8)
    near(run.energy.kinetic, 0, 1e-12 * start.energy.work, "at rest: kinetic energy")
  end
end)

-- Checkpoint, undo, idle ----------------------------------------

local function scene(declare, more)
  local s = beam({ { 0, 0, 0 }, { L, 0, 0 }, { L, L, 0 } }, { "all" }, { displacement = "large" })
  if declare then declare(s) end
  local options = { dt = 2e-5, duration = 4e-3 }
  for k, v in pairs(more or {}) do options[k] = v end
  return s.model:dynamic(options), s
end
local function loaded(s)
  s.model:load { member = s.member[1], q = { 0, 0, -1e6 }, history = { { 0, 0 }, { 1e-3, 1 }, { 2e-3, 0.2 } } }
  s.model:load { group = "beam", q = { 0, 2e5, 0 }, axes = "local" }
  s.model:load { member = s.member[2], at = 0.7, force = { 0, 0, 1e5 }, moment = { 10, 0, 2000 } }
end
local folder = support.temporary_folder()
for name, more in pairs { implicit = {}, explicit = { integrator = "explicit", dt = "auto" },
  ["step control"] = { dt = 1.6e-4, step_control = 7e-5 } } do
  case("checkpoints and steps taken back change no bit under member loads: " .. name, function()
    local whole = scene(loaded, more)
    whole:finish()
    equal(whole.verdict, "completed", name .. ": verdict")
    local half = scene(loaded, more)
    for step in half:steps() do
      if step.index == whole.index // 2 then half:checkpoint(folder .. "/one.checkpoint") end
    end
    local resumed = scene(loaded, more):resume(folder .. "/one.checkpoint")
    resumed:finish()
    equal(resumed.hash, whole.hash, name .. ": state after a checkpoint")
    equal(resumed.energy.work, whole.energy.work, name .. ": work after a checkpoint")
    balance(whole, name .. ", loads that turn", 1e-3)
    if more.step_control then
      expect(whole.counts.rejected_steps > 0, "steps taken back: %s", tostring(whole.counts.rejected_steps))
    end
  end)
end
case("a load of nothing changes no bit", function()
  local plain, idle = scene(), scene(function(s) s.model:load { group = "beam", q = { 0, 0, 0 } } end)
  plain:finish()
  idle:finish()
  equal(idle.hash, plain.hash, "a load of nothing: state")
end)

case("a load left out of a comparison is as not declared", function()
  local core = require "hinge.core"
  local function hash(declare, left_out)
    core.leave_out(left_out)
    local run, s = scene(declare)
    local rest = s.model:static { steps = 1 }
    core.leave_out(nil)
    run:finish()
    rest:finish()
    equal(run.verdict .. rest.verdict, "completedcompleted", "verdicts, left out: " .. tostring(left_out))
    return run.hash .. rest.hash
  end
  expect(hash(loaded) ~= hash(), "loads on members change nothing")
  equal(hash(loaded, "member loads"), hash(), "left out: states")
end)

case("the plan says that a history is asked, and where", function()
  local function hooks(declare)
    for _, effect in ipairs(scene(declare).effects) do
      if effect.name == "script functions" then return effect end
    end
  end
  local line = hooks(loaded)
  equal(line.active, true, "plan of a history: active")
  equal(line.because, "a load's history", "plan of a history: why")
  expect(line.asked_at and line.asked_at:find "member_loads_test.lua:%d+", "plan of a history: where: %s",
    tostring(line.asked_at))
  equal(hooks(function(s) s.model:load { group = "beam", q = { 0, 0, 1 } } end).active, false, "plan without one")
end)

case("a history function that fails takes the step back whole", function()
  local fails = false
  local function sine(s)
    s.model:load { group = "beam", q = { 0, 0, -1e5 }, history = function(t)
      if fails and t > 1e-3 then error "not yet" end
      return math.sin(1000 * t)
    end }
  end
  local whole, run = scene(sine), scene(sine)
  whole:finish()
  fails = true
  local ok, said = pcall(run.finish, run)
  expect(not ok and tostring(said):find("not yet", 1, true) and tostring(said):find("field 'history'", 1, true),
    "a history that fails: %s", tostring(said))
  fails = false
  run:finish()
  equal(run.hash, whole.hash, "after a failed step: state")
  equal(run.energy.work, whole.energy.work, "after a failed step: work")
end)

-- Wrong input ----------------------------------------

local function wrong(message, options)
  local s = beam({ { 0, 0, 0 }, { L, 0, 0 } }, { "all" })
  for _, name in ipairs { "member", "node" } do
    if options[name] == true then options[name] = s[name][1] end
  end
  local ok, said = pcall(s.model.load, s.model, options)
  expect(not ok and support.says(tostring(said):gsub("^.-model:load", "model:load"), message),
    "%s\n    says   %s", message, tostring(said))
  s.model:load { node = s.node[2], force = { 0, 0, -1 } }
  local _, _, down = solve(s):displacement(s.node[2])
  near(down, -L ^ 3 / (3 * E * Ix) - L / (G * Ay), 1e-15, "as before: " .. message)
end
-- A moment M0 jumps from -Mp to Mp where it acts; of a force at a quarter the hinges are at both ends and there:
-- P a b / L = 2 Mp with a = 1.5 m, b = 4.5 m.
case("limit loads of loads on nodes of the elements", function()
  local yields = hinge.material { E = 210e9, density = 7850, yield_stress = 275e6 }
  local solid = hinge.section.solid { width = 0.1, depth = 0.2 }
  local Mp = solid.Zx * 275e6
  local function limit(elements, load)
    local model = hinge.model { displacement = "small" }
    local a, b = model:node { 0, 0, 0 }, model:node { 6, 0, 0 }
    model:fix(a)
    model:fix(b, "y,z,rx,ry,rz")
    load.member = model:member { a, b, section = solid, material = yields, up = { 0, 0, 1 }, elements = elements }
    model:load(load)
    return model:static { steps = 50, to_limit = true, record = false }:finish().factor
  end
  for _, elements in ipairs { 2, 4, 8 } do
    near(5 * limit(elements, { at = 0.5, moment = { 0, 5 * Mp, 0 } }), 2, 2e-3,
      ("moment in the middle, %d elements"):format(elements))
  end
  for _, elements in ipairs { 4, 8 } do
    near(3 * limit(elements, { at = 0.25, force = { 0, 0, -3 * Mp } }), 2 * 6 / (1.5 * 4.5), 3e-3,
      ("force at a quarter, %d elements"):format(elements))
  end
end)

case("wrong loads on members are refused", function()
  wrong("model:load: field 'member' is 'beam'; must be a member made by model:member{a, b, ...}",
    { member = "beam", q = { 0, 0, 1 } })
  wrong("model:load: field 'group': no group 'beems'...", { group = "beems", q = { 0, 0, 1 } })
  wrong("model:load: field 'group' is given beside member; give one of the two",
    { member = true, group = "beam", q = { 0, 0, 1 } })
  wrong("model:load: field 'node' is given beside a member or group; give one of them",
    { node = true, member = true, q = { 0, 0, 1 } })
  wrong("model:load: neither 'q' (N/m) nor 'moment' (N m/m) is given; give {x, y, z}, or ...", { member = true })
  wrong("model:load: neither 'force' (N) nor 'moment' (N m) is given beside 'at'", { member = true, at = 0.5 })
  wrong("model:load: field 'q' is 5; must be a table {x, y, z} in N/m", { member = true, q = 5 })
  wrong("model:load: field 'q': component z is not a number (nan); must be finite",
    { member = true, q = { 0, 0, 0 / 0 } })
  wrong("model:load: field 'q': field 'b' is 1; must be a table {x, y, z} in N/m", { member = true, q = { b = 1 } })
  wrong("model:load: field 'at' is 1.5; must be from 0, the member's first end, to 1",
    { member = true, at = 1.5, force = { 0, 0, 1 } })
  wrong("model:load: field 'force' is given without 'at'; is a point load, in N; give 'at' (0 to 1), or ...",
    { member = true, force = { 0, 0, 1 } })
  wrong("model:load: field 'q' is given beside 'at'; is for the whole length; ...",
    { member = true, at = 0.5, q = { 0, 0, 1 } })
  wrong("model:load: field 'axes' is 'globl'; must be...(did you mean 'global'?)",
    { member = true, q = { 0, 0, 1 }, axes = "globl" })
  wrong("model:load: field 'axes' is 'projected'; is for 'q'; a point load has no length to be projected",
    { member = true, at = 0.5, force = { 0, 0, 1 }, axes = "projected" })
  wrong("model:load: field 'history' is 5; must be a function of time (s) or a table of {time, factor} pairs",
    { member = true, q = { 0, 0, 1 }, history = 5 })
  wrong("model:load: unknown field 'forces' (did you mean 'force'?); it takes ...", { member = true, forces = 1 })
  wrong("model:load: field 'q' is given; belongs to a load on 'member', not on a node", { node = true, q = { 0, 0,
    1 } })
end)

checks.done()
