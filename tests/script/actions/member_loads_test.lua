-- Loads on members against closed forms: fixed-end forces, deflections, limit loads (even loads along them:
-- weight_test.lua); in dynamics momentum, energy and histories; what checkpoints, undo and idle loads make of them; and
-- wrong input.
--
-- Run: lua5.4 tests/script/actions/member_loads_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local scenes = require "scenes"
local short = require "actions.short_beam"
local hinge = require "hinge"
local checks = support.checks "member_loads"
local runs = require "runs"(checks)
local case, near, equal, expect = checks.case, checks.near, checks.equal, checks.expect
local beam, straight, completed, with = short.beam, short.straight, runs.completed, scenes.with

local E, G, A, Ix, Iy, J = short.E, short.G, short.A, short.Ix, short.Iy, short.J
local Ax, Ay, L = short.Ax, short.Ay, short.L
local function solve(s, options) return completed(s.model:static(options or { steps = 1 }), "statics") end
local function close(value, wanted, what, part) near(value, wanted, (part or 1e-9) * math.abs(wanted) + 1e-12, what) end
local w = 3e4 -- N/m

-- Triangular, trapezoidal and point loads, about both axes, in a clamped beam; shear flexibility does not change
-- symmetric fixed-end moments, but these.
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
    local f = axis == 3 and short.phi(Ix, Ay) or short.phi(Iy, Ax)
    local moment = axis == 3 and "Mx" or "My"
    local function force(size) return { 0, axis == 2 and -size or 0, axis == 3 and -size or 0 } end
    for name, row in pairs {
      ["point load at 0.3"] = { { at = 0.3, force = force(w) }, { point_moments(w, 0.3, f) } },
      ["triangle"] = { { q = { b = force(w) } }, { spread_moments(0, w, f) } },
      ["trapezoid"] = { { q = { a = force(w), b = force(2.5 * w) } }, { spread_moments(w, 2.5 * w, f) } },
    } do
      local s = straight { "all", "all" }
      row[1].member = s.member[1]
      s.model:load(row[1])
      local a, b = s.member[1]:forces(solve(s))
      local what = ("%s, axis %d (%s): "):format(name, axis, about)
      close(math.abs(a[moment]), row[2][1], what .. "moment at a", 1e-8)
      close(math.abs(b[moment]), row[2][2], what .. "moment at b", 1e-8)
    end
  end
end)

case("a cantilever under loads along it has the tip and section forces of theory", function()
  local s = straight { "all" }
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

case("loads per plan length and across an inclined member: snow and pressure", function()
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
  x, z, a = roof { q = { 0, -w, 0 }, axes = "local" }
  close(x, -w * rise, "pressure: sideways")
  close(z, w * L, "pressure: down")
  close(math.abs(a.Mx), w * length ^ 2 / 12, "pressure: end moment")
end)

-- Dynamics ------------------------------------------------------------------------------------------------------------

local methods = { newmark = { dt = 2e-5 }, explicit = { dt = "auto", integrator = "explicit" } }

-- The momentum is q L t, whatever the steps; its spin too.
case("a free bar under an even load has the momentum q L t", function()
  for integrator, options in pairs(methods) do
    local s = straight({}, { displacement = "large" })
    s.model:load { member = s.member[1], q = { a = { 0, 0, 3000 }, b = { 0, 900, -2000 } } }
    local run = completed(s.model:dynamic(with(options, { duration = 0.02 })), integrator)
    local p = run:momentum()
    close(p.linear[3], 500 * L * run.time, integrator .. ": momentum", 1e-6)
    close(p.linear[2], 450 * L * run.time, integrator .. ": momentum aside", 1e-6)
    runs.balanced(run, integrator == "explicit" and 2e-5 or 1e-6, "work", integrator .. ", free bar")
  end
end)

-- Let on suddenly, a load lowers the joint twice as far as at rest (the lowest mode alone: a light beam, a heavy end).
local function swing(options, load, model)
  local s = beam({ { 0, 0, 0 }, { L / 2, 0, 0 }, { L, 0, 0 } }, { "all", nil, "all" }, model)
  load.group = "beam"
  s.model:load(load)
  local run = s.model:dynamic(options)
  local probe = run:probe { node = s.node[2], "uz" }
  completed(run, "in dynamics")
  return support.smallest_of(table.unpack(probe.value)), run
end
case("a load let on suddenly lowers the joint twice as far as at rest", function()
  local rest = -w * L ^ 4 / (384 * E * Ix) - w * L ^ 2 / (8 * G * Ay)
  local lowest, run = swing({ dt = 1e-5, duration = 8e-3 }, { q = { 0, 0, -w } })
  near(lowest / rest, 2, 0.06, "let on at once: twice the deflection")
  runs.balanced(run, 1e-6, "work", "let on at once")
  -- over ten periods: hardly a swing
  lowest, run = swing({ dt = 2e-5, duration = 0.06 }, { q = { 0, 0, -w }, history = { { 0, 0 }, { 0.05, 1 } } })
  near(lowest / rest, 1, 0.06, "let on slowly: as at rest")
  runs.balanced(run, 1e-6, "work", "let on slowly")
  lowest, run = swing(with(methods.explicit, { duration = 8e-3 }), { q = { 0, 0, -w } }, { displacement = "large" })
  near(lowest / rest, 2, 0.1, "explicit, let on at once")
  runs.balanced(run, 5e-3, "work", "explicit") -- of second order in dt
end)

-- Follower forces of the elements converge to it: a coarse and a fine mesh.
case("a load in local axes rotates with its member", function()
  local up, turn, a = {}, {}, nil
  for i, elements in ipairs { 40, 8 } do
    local s = straight({ "all" }, { displacement = "large", elements_per_member = elements })
    s.model:load { member = s.member[1], q = { 0, E * Ix / L ^ 3, 0 }, axes = "local" }
    local run = solve(s, { steps = 4 })
    local u = { run:displacement(s.node[2]) }
    up[i], turn[i] = u[3], u[5]
    a = s.member[1]:forces(run)
  end
  close(up[2], up[1], "follower pressure: up", 3e-3)
  close(turn[2], turn[1], "follower pressure: rotation", 3e-3)
  -- equilibrium: the supports hold what the pressure asks where it is
  expect(math.abs(a.Mx) < 0.5 * E * Ix / L, "follower pressure: less than the dead load's moment")
end)

-- Of a free bar one element of four breaks: its quarter of the load is gone from then on, and nothing else.
case("an element that breaks loses its part of the load and nothing else", function()
  for integrator, options in pairs(methods) do
    local s = straight({}, { displacement = "large", elements_per_member = 4 })
    s.model:load { member = s.member[1], q = { 0, 0, 3000 } }
    local broke
    s.model:fracture(function(at)
      if at.element ~= 2 or at.time < 4e-3 then return false end
      broke = at.time
      return true
    end)
    local run = completed(s.model:dynamic(with(options, { duration = 8e-3 })), integrator .. ", broken")
    equal(run:count { state = "broken" }, 1, integrator .. ": members broken")
    close(run:momentum().linear[3], 3000 * L * (broke + 0.75 * (run.time - broke)), integrator .. ", broken: momentum",
      1e-6)
    runs.balanced(run, 1e-4, "work", integrator .. ", broken")
  end
end)

-- At rest under its load, from statics: it stays so, with the same end forces.
case("a beam at rest under its load stays at rest in dynamics", function()
  local s = straight({ "all" }, { displacement = "large" })
  s.model:load { group = "beam", q = { 0, 0, -w } }
  s.model:load { group = "beam", q = { 0, -w, 0 }, axes = "local" }
  local start = solve(s, { steps = 10 })
  runs.balanced(start, 1e-5, "work", "statics")
  for _, rest in ipairs { true, false } do
    local run = s.model:dynamic { from = start, dt = 1e-4, duration = 0.02, rest = rest }
    run:finish()
    close(s.member[1]:forces(run).Mx, s.member[1]:forces(start).Mx, "at rest: moment at the wall", 1e-8)
    near(run.energy.kinetic, 0, 1e-12 * start.energy.work, "at rest: kinetic energy")
  end
end)

-- Checkpoint, undo, idle ----------------------------------------------------------------------------------------------

local function scene(declare, more)
  local s = beam({ { 0, 0, 0 }, { L, 0, 0 }, { L, L, 0 } }, { "all" }, { displacement = "large" })
  if declare then declare(s) end
  return s.model:dynamic(with({ dt = 2e-5, duration = 4e-3 }, more)), s
end
local function loaded(s)
  s.model:load { member = s.member[1], q = { 0, 0, -1e6 }, history = { { 0, 0 }, { 1e-3, 1 }, { 2e-3, 0.2 } } }
  s.model:load { group = "beam", q = { 0, 2e5, 0 }, axes = "local" }
  s.model:load { member = s.member[2], at = 0.7, force = { 0, 0, 1e5 }, moment = { 10, 0, 2000 } }
end
for name, more in pairs { implicit = {}, explicit = methods.explicit,
  ["step control"] = { dt = 1.6e-4, step_control = 7e-5 } } do
  case("checkpoints and steps taken back change no bit under member loads: " .. name, function()
    local whole = runs.resumes(function() return (scene(loaded, more)) end, 2e-3, name)
    equal(whole.verdict, "completed", name .. ": verdict")
    runs.balanced(whole, 1e-3, "work", name .. ", loads that turn")
    if more.step_control then
      expect(whole.counts.rejected_steps > 0, "steps taken back: %s", tostring(whole.counts.rejected_steps))
    end
  end)
end

case("a load of nothing changes no bit", function()
  local idle = scene(function(s) s.model:load { group = "beam", q = { 0, 0, 0 } } end)
  equal(idle:finish().hash, scene():finish().hash, "a load of nothing: state")
end)

case("a load left out of a comparison is as not declared", function()
  local core = require "hinge.core"
  local function hash(declare, left_out)
    core.leave_out(left_out)
    local run, s = scene(declare)
    local rest = s.model:static { steps = 1 }
    core.leave_out(nil)
    return completed(run, "left out").hash .. completed(rest, "left out").hash
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
  checks.refused({ "not yet", "field 'history'" }, run.finish, run)
  fails = false
  run:finish()
  equal(run.hash, whole.hash, "after a failed step: state")
  equal(run.energy.work, whole.energy.work, "after a failed step: work")
end)

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

case("wrong loads on members are refused, and change nothing", function()
  local s = straight { "all" }
  local member, up = s.member[1], { 0, 0, 1 }
  for words, options in pairs {
    ["field 'member' is 'beam'; must be a member made by model:member"] = { member = "beam", q = up },
    ["field 'group': no group 'beems'"] = { group = "beems", q = up },
    ["field 'group' is given beside member; give one of the two"] = { member = member, group = "beam", q = up },
    ["field 'node' is given beside a member or group"] = { node = s.node[1], member = member, q = up },
    ["neither 'q' (N/m) nor 'moment' (N m/m) is given; give {x, y, z}"] = { member = member },
    ["neither 'force' (N) nor 'moment' (N m) is given beside 'at'"] = { member = member, at = 0.5 },
    ["field 'q' is 5; must be a table {x, y, z} in N/m"] = { member = member, q = 5 },
    ["field 'q': component z is not a number (nan); must be finite"] = { member = member, q = { 0, 0, 0 / 0 } },
    ["field 'q': field 'b' is 1; must be a table {x, y, z} in N/m"] = { member = member, q = { b = 1 } },
    ["field 'at' is 1.5; must be from 0, the member's first end, to 1"] = { member = member, at = 1.5, force = up },
    ["field 'force' is given without 'at'; is a point load, in N"] = { member = member, force = up },
    ["field 'q' is given beside 'at'; is for the whole length"] = { member = member, at = 0.5, q = up },
    ["field 'axes' is 'globl'"] = { member = member, q = up, axes = "globl" },
    ["field 'axes' is 'projected'; is for 'q'; a point load has no length"] = { member = member, at = 0.5, force = up,
      axes = "projected" },
    ["field 'history' is 5; must be a function of time (s) or a table"] = { member = member, q = up, history = 5 },
    ["field 'q' is given; belongs to a load on 'member', not on a node"] = { node = s.node[1], q = up },
  } do
    checks.refused("model:load: " .. words, s.model.load, s.model, options)
  end
  s.model:load { node = s.node[2], force = { 0, 0, -1 } }
  local _, _, down = solve(s):displacement(s.node[2])
  near(down, -L ^ 3 / (3 * E * Ix) - L / (G * Ay), 1e-15, "as before")
end)

checks.done()
