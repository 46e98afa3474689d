-- hinge.robustness: the numbers of a row against closed forms of two beams over a column that goes, and against runs by
-- hand: pushes, dynamic factors, times, falls, linear statics of two factors, capacities of joints; and each verdict.
--
-- Run: lua5.4 tests/script/robustness/robustness_numbers_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local hinge = require "hinge"
local robustness = require "hinge.robustness"
local checks = support.checks "numbers of robustness"
local case, near, equal, expect = checks.case, checks.near, checks.equal, checks.expect
local with = require "scenes".with

require "hinge.core".own_output(support.temporary_folder(), {}, true)
local frames = require "robustness.frames"
local g, fy, E, L, box, post, Mp = frames.g, frames.fy, frames.E, frames.L, frames.box, frames.post, frames.Mp
local flexibility, R, mechanism = frames.flexibility, frames.R, frames.mechanism

local function row_of(how, options)
  return robustness(with({ build = function(o) return (mechanism(how, o.scale)) end, remove = { 3 }, limit = 0.06,
    quiet = true, fall = 0.8, allow_failed = true, loads = not how.mass and { dead = 1 } or nil }, options)).rows[1]
end

-- Nonlinear statics ---------------------------------------------------------------------------------------------------

local push = { "nonlinear static" }

case("a load that is reached within the first steps of a push has its own deflection, to the last digit", function()
  -- the first of ten steps is beyond yield; the second push goes to it alone, and its steps are elastic
  local P, omega = 100e3, 1.3
  for _, scaled in ipairs { false, true } do
    local row = row_of({ P = P, scaled = scaled }, { procedures = push, omega_n = omega, steps = 10 })
    expect(0.08 > R * flexibility, "a step of the first push is beyond yield")
    near(row.deflection, omega * P * flexibility, 1e-4 * row.deflection, "deflection, m") -- a beam of some weight
    equal(row.beam_rotation, 0, "no hinge")
    equal(row.ratio, 0, "of the limit")
    equal(row.verdict, "holds", row.reason)
    equal(row.run_verdict, "completed", "the push goes on to its end")
    near(row.load_factor, R / P, 1e-5 * R / P, "largest load")
  end
end)

case("hinges that harden have the rotation of a run to the same load by hand", function()
  -- M = M_p (1 + 0.5 rotation / 0.05) up to 0.05 rad
  local backbone = hinge.backbone { cap_rotation = 0.05, cap_strength = 1.5, post_cap_rotation = 0.3 }
  local P, omega = 200e3, 1.25
  local row = row_of({ P = P, backbone = backbone }, { procedures = push, omega_n = omega, limit = 0.01 })
  local theta = (omega * P / R - 1) * 0.05 / 0.5 -- both ends of both beams have the moment of P L / 8 each
  near(row.beam_rotation, theta, 0.02 * theta, "plastic rotation, rad")
  near(row.deflection, omega * P * flexibility + theta * L, 0.01 * row.deflection, "deflection, m")
  near(row.ratio, row.beam_rotation / 0.01, 1e-12, "of the limit")
  near(row.beam_ratio, row.ratio, 1e-12, "the beams'")
  local model = mechanism { P = P * omega, backbone = backbone }
  model:remove { member = model:members()[3], at = 0 }
  local gone = model:dynamic { dt = 1e-6, duration = 1e-6, loads = {}, step_control = 0, energy_tolerance = 0 }:finish()
  local run = model:static { from = gone, loads = { dead = 1 }, steps = 20 }:finish()
  near(row.beam_rotation, run:hinges().worst.demand, 2e-3 * theta, "that of a run by hand")
  equal(row.verdict, "exceeds the limit of rotation", row.reason)
  expect(support.says(row.reason, ("member %d has %.4g of its limit 0.01 rad"):format(row.worst, row.ratio)), "says %s",
    row.reason)
end)

case("a push that does not come to the loads says how far it came, and whether there is more", function()
  local falling = hinge.backbone { cap_rotation = 0.03, post_cap_rotation = 0.3 }
  local P = 150e3
  local row = row_of({ P = P, backbone = falling }, { procedures = push, omega_n = 1.5 })
  local words = ("the loads come to %.4g, and 1.5 is needed; "):format(R / P)
  equal(row.reason, words .. "there is no equilibrium beyond", "falls")
  equal(row.limit_reached, true, "a limit")
  near(row.load_factor, R / P, 1e-5 * R / P, "which is that of the mechanism")
  row = row_of({ P = P }, { procedures = push, omega_n = 1.5 })
  equal(row.reason, words .. "the joint is down by 0.8 m then", "flat")
  equal(row.verdict, "collapses", "verdict")
  equal(row.limit_reached, false, "no limit up to the fall")
  equal(row.deflection, nil, "no deflection")
end)

case("Omega_N goes by the smallest capacity of a joint about x or y, and not about z", function()
  local at_yield = Mp * L / (6 * E * box.Ix)
  local stiff = 1e9
  local function ends(capacity)
    local spring = {}
    for axis, value in pairs(capacity) do spring[axis] = { stiffness = stiff, capacity = value } end
    return { a = hinge.joint(spring), b = hinge.joint { Mx = { stiffness = stiff, capacity = 0.04 } } }
  end
  for _, r in ipairs { { { Mx = 0.02, Mz = 0.001 }, 0.02 }, { { Mx = 0.02, My = 0.01 }, 0.01 },
    { { Mx = 0.05 }, 0.04 }, { { Mx = 0.5 }, 0.04 } } do
    local row = row_of({ P = 20e3, ends = ends(r[1]) }, { procedures = push, limit = 0.06 })
    near(row.smallest_ratio, r[2] / at_yield, 1e-6 * row.smallest_ratio, "allowed over yield")
    near(row.omega, 1.08 + 0.76 / (r[2] / at_yield + 0.83), 1e-6, "Omega_N")
  end
end)

-- Dynamics ------------------------------------------------------------------------------------------------------------

local P_elastic = 100e3
local T = 2 * math.pi * math.sqrt(P_elastic * flexibility / g)
local function elastic(options, more)
  return row_of(with({ P = P_elastic, mass = true, elastic = true }, more),
    with({ procedures = { "nonlinear dynamic" } }, options))
end

case("an elastic frame turns at T / 2 at twice statics, and is followed for a period more", function()
  local row = elastic()
  near(row.period, T, 1e-4 * T, "period, s")
  equal(row.dt, tonumber(("%.2g"):format(T / 1000)), "time step, s")
  near(row.deflection, 2 * P_elastic * flexibility, 2e-3 * row.deflection, "deflection, m")
  -- the deepest place is known to 0.1 % of the way, within 3 % of T / 2
  near(row.time, T / 2, 0.02 * T, "when, s")
  near(row.followed, row.time + row.period, 2 * row.dt, "followed to, s")
  near(elastic({ follow = 0.5, dt = T / 200 }).followed, row.time + T / 2, 3 * T / 200, "for half a period")
  equal(row.broken, 0, "broken")
  equal(row.verdict, "holds", row.reason)
  equal(row.at_rest, nil, "what the row needs for itself alone is taken out")
  local short = elastic { follow = 100, dt = T / 100 }
  equal(short.reason, ("the joint above has not turned, or not for long enough, by t = %.4g s, the end of the run; "
    .. "give a longer duration"):format(10 * row.period), "ten periods without a duration")
end)

case("removal within a time and damping: the dynamic factors of one degree of freedom", function()
  for _, r in ipairs { { 0.5, 1 + 2 / math.pi }, { 0.8, 1 + math.sin(0.8 * math.pi) / (0.8 * math.pi) } } do
    near(elastic({ over = r[1] * T, dt = T / 400 }).increase, r[2], 0.005, "forces fall in T times " .. r[1])
  end
  for _, ratio in ipairs { 0.05, 0.2 } do
    local factor = 1 + math.exp(-math.pi * ratio / math.sqrt(1 - ratio ^ 2))
    near(elastic({ damping = ratio, dt = T / 400 }).increase, factor, 0.005, "damping " .. ratio)
  end
end)

case("the energy error is over the largest account, and the step may be up to a fiftieth of the period", function()
  local dt = T / 52
  local row = elastic({ dt = dt }, { elastic = false })
  local model = mechanism { P = P_elastic, mass = true }
  local rest = model:static { steps = 10 }:finish()
  model:remove { member = model:members()[3], at = 0 }
  local run = model:dynamic { from = rest, dt = dt, duration = 10 * row.period }
  while run.time < row.followed - 1e-9 and run:step() do end
  local largest = 0
  for _, name in ipairs { "initial", "kinetic", "gravity", "elastic", "plastic", "work" } do
    largest = support.largest_of(largest, math.abs(run.energy[name]))
  end
  expect(run.energy.energy_error ~= 0, "there is an error")
  near(row.energy_error, run.energy.energy_error / largest, 1e-9 * math.abs(row.energy_error), "energy error")
  run:stop()
  equal(elastic({ dt = T / 48 }).verdict, "failed", "a longer step")
end)

case("another node than the joint above falls: it is named, with the time of a look at every tenth step", function()
  -- the right beam ends at the head; a cantilever beyond it goes down further than the joint
  local arm = 4
  local function build(scale)
    local model, head = mechanism({ P = 5e3, mass = true, elastic = true, extra = function(model, head)
      local tip = model:node { L, 0, 3 + arm }
      local side = model:node { L + arm, 0, 3 + arm }
      local light = frames.light(2e10)
      for _, ends in ipairs { { head, tip }, { tip, side } } do
        model:member { ends[1], ends[2], section = box, material = light, up = { 0, 1, 0 } }
      end
      model:fix({ tip, side }, "y,rx,rz")
      model:mass { node = side, mass = 6e3 }
    end }, scale)
    return model, head
  end
  local dt, fall = 1e-3, 0.04
  local row = robustness { build = function() return (build()) end, remove = { 3 }, limit = 0.06, quiet = true,
    fall = fall, dt = dt, follow = 4, procedures = { "nonlinear dynamic" } }.rows[1]
  local model = build()
  local rest = model:static { steps = 10 }:finish()
  model:remove { member = model:members()[3], at = 0 }
  local run = model:dynamic { from = rest, dt = dt, duration = 3 }
  local function down(i) return rest:read "uz"[i] - run:read "uz"[i] end
  local deepest, found = 0, nil
  while not found and run:step() do
    deepest = support.largest_of(deepest, down(2))
    if run.index % 10 == 0 then
      for i = 1, 6 do found = found or down(i) > fall and i end
    end
  end
  equal(found, 6, "the tip falls")
  equal(row.reason, ("node 6 has fallen by more than 0.04 m at t = %.4g s"):format(run.time), "says")
  equal(row.verdict, "collapses", "verdict")
  near(row.followed, run.time, 1e-12, "followed to, s")
  near(row.deflection, deepest, 1e-12, "the joint above is down by, m")
  expect(deepest < fall, "which is less: %g m", deepest)
  equal(row.increase, nil, "no factor of a collapse")
  run:stop()
end)

case("of two joints without a column the one that goes down more is followed", function()
  local function build(heavy)
    local model = hinge.model { displacement = "small" }
    local light, heads = frames.light(), {}
    for k, x in ipairs { 0, 40 } do
      local left, right, foot = model:node { x, 0, 3 }, model:node { x + 2 * L, 0, 3 }, model:node { x + L, 0, 0 }
      heads[k] = model:node { x + L, 0, 3 }
      model:fix({ left, right, foot }, "all")
      model:fix(heads[k], "y,rx,rz")
      model:member { left, heads[k], section = box, material = light, up = { 0, 0, 1 } }
      model:member { heads[k], right, section = box, material = light, up = { 0, 0, 1 } }
      model:member { foot, heads[k], section = post, material = light, up = { 1, 0, 0 } }
      model:case("dead"):load { node = heads[k], force = { 0, 0, k == heavy and -60e3 or -30e3 } }
    end
    return model
  end
  for heavy = 1, 2 do
    local row = robustness { build = function() return build(heavy) end, remove = { { 3, 6 } }, quiet = true,
      procedures = { "linear static" }, m = 1, loads = { dead = 1 }, fall = 1 }.rows[1]
    near(row.deflection, 2 * 60e3 * flexibility, 1e-4 * row.deflection, "deflection, m")
    near(row.period, 2 * math.pi * math.sqrt(60e3 * flexibility / g), 1e-4, "period, s")
  end
end)

-- Linear statics ------------------------------------------------------------------------------------------------------

-- Two spans on three posts, of which the middle one goes; the outer ones, 50 mm square, are controlled by force.
local side = hinge.section.solid { width = 0.05, depth = 0.05 }
local function bridge(P, scale, without)
  local function by(x) return scale and scale(x, 0, 3) or 1 end
  local model, top = frames.bridge(P * by(L), { side = { section = side }, without = without })
  model:case("dead"):load { node = top[0], force = { 0, 0, -0.5 * P * by(-40) } }
  return model
end

case("linear statics: DCR under Omega_LD and 2 times the loads, of all or of those next to the removal", function()
  local P, m = 400e3, 3
  local omega = 0.9 * m + 1.1
  local N0 = { 0.05 ^ 2 * fy, box.plastic_area * fy }
  local M0 = { 0.05 ^ 3 / 4 * fy, box.Zx * fy }
  -- DCRs of posts and of beams, elastic, without the post
  local function by_hand(scale)
    local run = bridge(P, scale, true):static { steps = 1, loads = { dead = 1 } }
    local model = run.model
    run:finish()
    local most, axial = { 0, 0 }, 0
    for i, member in ipairs(model:members()) do
      local k = i <= 2 and 1 or 2
      for _, at in ipairs { member:forces(run) } do
        local n, mx = math.abs(at.N) / N0[k], math.abs(at.Mx) / M0[k]
        most[k] = support.largest_of(most[k], n >= 0.2 and n + 8 / 9 * mx or n / 2 + mx)
        if k == 1 then axial = support.largest_of(axial, n) end
      end
    end
    return most, axial
  end
  for _, scaled in ipairs { true, false } do
    local function factor(value)
      return function(x) return (not scaled or x > 0) and value or 1 end -- the load at x = -40 is far from the removal
    end
    local row = robustness { build = function(o) return bridge(P, scaled and o.scale or nil) end, remove = { 2 },
      procedures = { "linear static" }, m = m, loads = { dead = 1 }, quiet = true }.rows[1]
    local name = scaled and "next to the removal" or "all"
    equal(row.loads_scaled, name, "loads")
    near(row.omega, omega, 1e-12, "Omega_LD")
    local force, axial = by_hand(factor(2))
    expect(axial > 0.5, "posts are controlled by force: %g", axial)
    near(row.force_dcr, force[1], 1e-3 * force[1], name .. ": DCR by force")
    near(row.dcr, by_hand(factor(omega))[2], 1e-3 * row.dcr, name .. ": DCR by deformation")
    near(row.ratio, support.largest_of(row.dcr / m, row.force_dcr), 1e-12, name .. ": of what is allowed")
    equal(row.dcr_limit, m, "what is allowed")
    local governs = row.dcr / m > row.force_dcr
    local told, value = row.reason:match "^member (%d) has a DCR of ([%d.]+)$"
    expect(told and (tonumber(told) > 3) == governs, "the member that governs: %s", row.reason)
    near(tonumber(value), governs and row.dcr or row.force_dcr, 1e-3 * value, "its DCR")
  end
end)

-- Verdicts ------------------------------------------------------------------------------------------------------------

case("linear statics: the shear of a joint under 2 times the loads over that at which it breaks", function()
  local P, V = 100e3, 120e3 -- each end of both beams has P / 2
  for _, scaled in ipairs { false, true } do
    for _, capacity in ipairs { V, 0.7 * V } do
      local row = row_of({ P = P, scaled = scaled, ends = { a = hinge.joint { shear = capacity,
        Mx = { stiffness = 1e11, strength = 10 * Mp } } } }, { procedures = { "linear static" }, m = 4 })
      near(row.force_dcr, P / capacity, 1e-4, "DCR by force")
      near(row.joint_dcr, (0.9 * 4 + 1.1) * P * L / 8 / (10 * Mp) * 2, 0.02, "DCR of its moment") -- P L / 4 of two ends
      equal(row.verdict, P < capacity and "holds" or "exceeds the capacity", row.reason)
      if P > capacity then
        expect(row.reason:find("^the joint at end a of member %d has a DCR of 1.19"), "says %s", row.reason)
      end
    end
  end
end)

case("joints that turn without a limit are counted, each once, and their largest rotation is told", function()
  -- springs at both ends of both beams, and P so small that nothing else yields; the elastic run has a part of 1e-4
  -- of the loads, in which the joints turn by less than what counts as a turn
  local spring = 5e6
  local ends = { a = hinge.joint { Mx = { stiffness = spring } }, b = hinge.joint { Mx = { stiffness = 2 * spring } } }
  for _, procedure in ipairs { "linear static", "nonlinear static", "nonlinear dynamic" } do
    local how = { P = 5e3, mass = true, ends = ends }
    local row = row_of(how, { limit = { beams = 1 }, procedures = { procedure }, omega_n = 1.2 })
    equal(row.verdict, "holds", procedure .. ": a limit of the group of the beams: " .. row.reason)
    equal(row.joints_unrated, 0, "all have a limit")
    how.extra = function(model)
      local a, b = model:node { 0, 9, 0 }, model:node { 1, 9, 0 }
      model:fix(a)
      model:member { a, b, section = box, group = "other", material = frames.light() }
    end
    row = row_of(how, { limit = { other = 1 }, procedures = { procedure }, omega_n = 1.2 })
    equal(row.joints_unrated, 4, procedure .. ": joints")
    equal(row.verdict, "not rated", row.reason)
    expect(row.reason:find "^4 joints without a limit of rotation turn by up to [%d.e-]+ rad; ", "says %s", row.reason)
    local told = tonumber(row.reason:match "up to ([%d.e-]+)")
    expect(told < 0.01, "it is a small one: %s", row.reason)
    if procedure == "nonlinear static" then
      near(told, row.joint_rotation, 1e-3 * row.joint_rotation, "rad")
    end
  end
end)

case("options have their ranges, and an error of failed rows says how many and where", function()
  for name, r in pairs { duration = { 1, 0 }, dt = { 1e-4, 0 }, over = { 0, -1 }, fall = { 0.1, 0 },
    follow = { 0.1, 0 }, damping = { 0, -0.1 }, steps = { 10, 9 }, m = { 1, 0.9 }, omega_ld = { 1, 0.9 },
    omega_n = { 1, 0.9 } } do
    local function with_value(value)
      return { P = 1e3, elastic = true }, { procedures = { "linear static" }, [name] = value }
    end
    expect(pcall(row_of, with_value(r[1])), "%s = %g", name, r[1])
    checks.refused(("field '%s' is %g"):format(name, r[2]), row_of, with_value(r[2]))
  end
  checks.refused("field 'steps' is 1001", row_of, { P = 1e3 }, { procedures = { "linear static" }, steps = 1001 })
  for _, where in ipairs { false, "loss" } do
    local message = checks.refused({ "1 of 2 rows failed, the first one in case 1 (nonlinear dynamic): the joint above "
      .. "has not turned", "by t = 0.01 s", "give a longer duration", "allow_failed = true" }, row_of,
      { P = 100e3, mass = true }, { procedures = { "linear static", "nonlinear dynamic" }, duration = 0.01, dt = 1e-4,
      folder = where or nil, allow_failed = false })
    equal(support.has(message, "the report is written"), where ~= false, "a report in a folder alone")
  end
end)

case("a frame in which nothing can yield is refused, and so are loads that belong to no case", function()
  local function plastic(on, options)
    local function build()
      local model = hinge.model { displacement = "small", plasticity = on }
      local a, b, foot = model:node { 0, 0, 3 }, model:node { L, 0, 3 }, model:node { L, 0, 0 }
      model:fix({ a, foot })
      model:fix(b, "y,rx,rz")
      model:member { a, b, section = box, material = frames.light() }
      model:member { foot, b, section = post, material = frames.light() }
      model:case("dead"):load { node = b, force = { 0, 0, -1e3 } }
      return model
    end
    return { P = 1 }, with({ build = build, remove = { 2 }, procedures = { "nonlinear static" }, omega_n = 1.2 },
      options)
  end
  checks.refused("nothing can yield in the model", row_of, plastic(false))
  expect(pcall(row_of, plastic(true)), "with plasticity")
  expect(pcall(row_of, plastic(false, { procedures = { "linear static" } })), "linear statics needs no yield")
  expect(pcall(row_of, plastic(false, { criterion = function() return "fine" end })), "an own criterion may judge it")
  local loaded = { P = 1e3, extra = function(model, head) model:load { node = head, force = { 0, 0, -1 } } end }
  checks.refused("give each of them a case", row_of, loaded, { procedures = { "linear static" } })
end)

case("a plan has a row for each case and procedure, none of them run, and writes nothing", function()
  local core = require "hinge.core"
  local planning = core.planning
  core.planning = function() return true end
  local result = robustness { remove = { 3, 4 },
    limit = 0.06, quiet = true, fall = 0.8, duration = 1e-2, dt = 1e-3, folder = "planned",
    build = function()
      return (mechanism { P = 1e3, mass = true, extra = function(model)
        local a, b = model:node { 0, 9, 0 }, model:node { 1, 9, 0 }
        model:fix { a, b }
        model:member { a, b, section = box, material = frames.light() }
      end })
    end }
  core.planning = planning
  local rows = {}
  for i, row in ipairs(result.rows) do
    rows[i] = ("%d %s: %s%s %g"):format(row.case, row.procedure, row.verdict, row.reason, row.seconds)
  end
  equal(table.concat(rows, "; "), "1 nonlinear dynamic: not run 0; 1 nonlinear static: not run 0; "
    .. "1 linear static: not run 0; 2 nonlinear dynamic: not run 0; 2 nonlinear static: not run 0; "
    .. "2 linear static: not run 0", "rows")
  equal(result.counts["linear static"]["not run"], 2, "counted")
  equal(support.is_there(core.out_dir() .. "/planned"), false, "no folder")
end)

checks.done()
