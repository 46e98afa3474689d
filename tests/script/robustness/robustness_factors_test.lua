-- hinge.robustness, its factors and what it compares, by hand: limits of rotation by level, group and end; demand
-- over capacity by the weaker end, by deformation and by force; factors on loads; two columns that go together; loads
-- without mass.
--
-- Run: lua5.4 tests/script/robustness/robustness_factors_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local hinge = require "hinge"
local robustness = require "hinge.robustness"
local shared = require "hinge.robustness.demands"
local geometry = require "hinge.robustness.geometry"
local runs = require "hinge.robustness.runs"
local ufc = require "hinge.standards.ufc_4_023_03.factors"
local checks = support.checks "factors of robustness"
local case, near, equal, expect = checks.case, checks.near, checks.equal, checks.expect

local frames = require "robustness.frames"
local with = require "scenes".with
local fy, E, box, post, Mp, bridge = frames.fy, frames.E, frames.box, frames.post, frames.Mp, frames.bridge

-- Factors -------------------------------------------------------------------------------------------------------------

case("UFC 4-023-03: factors on loads of steel", function()
  -- Omega_LD = 0.9 m + 1.1; Omega_N = 1.08 + 0.76 / (theta_pra / theta_y + 0.83); Omega_LF = 2
  for m, wanted in pairs { [1] = 2, [1.8] = 2.72, [3] = 3.8, [6] = 6.5 } do
    near(ufc.linear(m), wanted, 1e-12, "Omega_LD of m = " .. m)
  end
  for r, wanted in pairs { [0] = 1.99566, [1] = 1.49530, [4] = 1.23735, [9] = 1.15731 } do
    near(ufc.nonlinear(r), wanted, 1e-5, "Omega_N of " .. r)
  end
  equal(ufc.force, 2.0, "Omega_LF")
  equal(ufc.irregular, 2, "largest DCR of an irregular structure")
  equal(ufc.most_storeys, 10, "GSA: most storeys of linear statics")
end)

-- A beam of a group and its model.
local function one_beam()
  local model = hinge.model {}
  local a, b = model:node { 0, 0, 3 }, model:node { 5, 0, 3 }
  return model:member { a, b, section = box, material = hinge.material { E = E, yield_stress = fy }, up = { 0, 0, 1 },
    group = "beams" }
end

case("the limit of rotation: the largest level that is given, by group, and the weaker end", function()
  local member = one_beam()
  for _, r in ipairs {
    { 0.03, 0.03 }, { { IO = 0.005, LS = 0.02, CP = 0.03 }, 0.03 }, { { IO = 0.005, LS = 0.02 }, 0.02 },
    { { IO = 0.005 }, 0.005 }, { { LS = 0.02, CP = 0.03 }, 0.03 },
    { { beams = 0.04 }, 0.04 }, { { beams = { IO = 0.01, CP = 0.05 } }, 0.05 }, { { columns = 0.04 }, nil },
    { function(h) return h.at == 0 and 0.02 or 0.03 end, 0.02 },
    { function(h) return h.at == 0 and 0.05 or 0.03 end, 0.03 },
    { function(h) return h.at == 0 and 0.05 or nil end, 0.05 },
    { function(h) return h.at == 1 and 0.06 or nil end, 0.06 }, { function() return nil end, nil },
    { function(h) return { IO = 0.001, CP = h.x / 100 + 0.01 } end, 0.01 },
  } do
    equal(shared.limit_of(r[1], member), r[2], "limit " .. tostring(r[1]))
  end
  local seen = {}
  shared.limit_of(function(h)
    seen[#seen + 1] = ("%g %g %g, end %d at %g, node %d, %s %d: %g %s"):format(h.x, h.y, h.z, h["end"], h.at,
      h.node.index, h.group, h.member.index, h.element, h.broken)
    for _, name in ipairs { "rotation_x", "rotation_y", "rotation", "largest", "demand", "elongation", "work", "f_y",
      "utilisation" } do equal(h[name], 0, name .. " of what has not yielded") end
    equal(h.before, false, "not before")
  end, member)
  equal(table.concat(seen, "; "), "0 0 3, end 1 at 0, node 1, beams 1: 1 false; 5 0 3, end 2 at 1, node 2, beams 1: "
    .. "1 false", "what a function is asked")
end)

-- Demand over capacity ------------------------------------------------------------------------------------------------

-- Three posts, two beams over them; geo as hinge.robustness reads it.
local function small_frame()
  local model = hinge.model { displacement = "small" }
  local steel, top = frames.light(), {}
  for i = 0, 2 do
    local foot = model:node { 5 * i, 0, 0 }
    top[i] = model:node { 5 * i, 0, 3 }
    model:fix(foot)
    model:member { foot, top[i], section = post, material = steel, up = { 1, 0, 0 }, group = "posts" }
  end
  for i = 1, 2 do
    model:member { top[i - 1], top[i], section = box, material = steel, up = { 0, 0, 1 }, group = "beams" }
  end
  return model, geometry.read(model)
end

local none = { N = 0, Mx = 0, My = 0 }
-- demands of a frame whose member `index` has these forces at its ends.
local function demands(index, at_a, at_b, times, times_force)
  local model, geo = small_frame()
  local function forces(i)
    if i == index then return at_a, at_b end
    return none, none
  end
  return shared.demands(model, geo, { removed = {} }, { forces, times or 1 }, { forces, times_force or 1 })
end

case("the DCR is that of the weaker end, of both axes, with the factors on loads", function()
  local Mpy = box.Zy * fy
  local function forces(of) return with(none, of) end
  local small, large = forces { Mx = 0.3 * Mp }, forces { Mx = -0.7 * Mp }
  near(demands(4, small, large).ratio, 0.7, 1e-12, "the last end has more")
  near(demands(4, large, small).ratio, 0.7, 1e-12, "the first end has more")
  equal(demands(4, large, small).member, 4, "the member")
  near(demands(4, forces { Mx = 0.3 * Mp, My = -0.25 * Mpy }, none).ratio, 0.55, 1e-12, "about both axes")
  near(demands(4, forces { Mx = 0.3 * Mp }, none, 2.5).ratio, 0.75, 1e-12, "times the factor of deformation")
  -- on each side of N / N0 = 0.2
  local N0 = box.plastic_area * fy
  near(demands(4, forces { N = 0.199 * N0, Mx = 0.3 * Mp }, none).ratio, 0.0995 + 0.3, 1e-12, "n = 0.199")
  near(demands(4, forces { N = -0.201 * N0, Mx = 0.3 * Mp }, none).ratio, 0.201 + 8 / 9 * 0.3, 1e-12, "n = 0.201")
end)

case("columns above half of N0 are controlled by force, beams are not", function()
  local N0 = post.plastic_area * fy
  local function pressed(part) return { N = -part * N0, Mx = 0.1 * post.Zx * fy, My = 0 } end
  local by_deformation, by_force = demands(1, pressed(0.2), none, 1, 2.4) -- 0.48
  equal(by_force, nil, "0.48 of N0")
  near(by_deformation.ratio, 0.2 + 8 / 9 * 0.1, 1e-12, "by deformation, with its own factor")
  by_deformation, by_force = demands(1, pressed(0.22), none, 4, 2.4) -- 0.528
  near(by_force.ratio, 0.528 + 8 / 9 * 0.24, 1e-12, "0.528 of N0: times the factor of force, and not of deformation")
  near(by_force.axial, 0.528, 1e-12, "its axial force")
  equal(by_deformation.ratio, 0, "the other end, which has nothing")
  by_deformation, by_force = demands(4, { N = -0.6 * box.plastic_area * fy, Mx = 0, My = 0 }, none, 1, 1)
  equal(by_force, nil, "a beam")
  near(by_deformation.ratio, 0.6, 1e-12, "its DCR")
end)

-- The rows of a study of a bridge with its load case.
local function rows_of(P, options, given)
  return robustness(with({ build = function() return (bridge(P, options)) end, quiet = true, loads = { dead = 1 },
    procedures = { "linear static" } }, given)).rows
end

case("a force that a column does not carry is not divided by m", function()
  local side = hinge.section.solid { width = 0.05, depth = 0.05 }
  local row = rows_of(1.1 * 0.05 ^ 2 * fy, { side = { section = side } }, { remove = { 2 }, m = 100 })[1]
  equal(row.verdict, "exceeds the capacity", row.reason)
  expect(row.force_dcr > 1 and row.ratio == row.force_dcr, "by force: %g", row.force_dcr)
  local member = tonumber(row.reason:match "^member (%d+) has a DCR of ")
  expect(member == 1 or member == 3, "it names an outer post: %s", row.reason)
end)

case("two columns that go together have the deflection of a frame without both", function()
  local P = 20e3
  local both = rows_of(P, { spans = 3 }, { remove = { { 2, 3 } }, m = 2 })
  equal(#both, 1, "one case")
  local row = both[1]
  equal(#row.members, 2, "with two members")
  -- by hand: the same frame without the two, elastic, under P on both joints times Omega_LD = 2.9
  local model, top = bridge(2.9 * P, { spans = 3, without = true })
  local run = model:static { steps = 1, loads = { dead = 1 } }:finish()
  near(row.deflection, -select(3, top[1]:displacement(run)), 1e-3 * row.deflection, "deflection, m")
  local worst = 0
  for _, beam in ipairs(model:group "beams":members()) do
    for _, at in ipairs { beam:forces(run) } do
      worst = support.largest_of(worst, math.abs(at.N) / (2 * box.plastic_area * fy) + math.abs(at.Mx) / Mp)
    end
  end
  near(row.dcr, worst, 1e-3 * worst, "DCR of a beam, n / 2 + m")
  local one = rows_of(P, { spans = 3 }, { remove = { 2 }, m = 2 })[1]
  expect(one.deflection < 0.5 * row.deflection, "one alone goes down less: %g of %g m", one.deflection, row.deflection)
end)

case("loads without inertia are told above 1.5 times the weight of all masses", function()
  for part, told in pairs { [0.6] = true, [0.7] = false } do
    local row = rows_of(15e3, { mass = part }, { remove = { 2 }, limit = 0.06,
      procedures = { "nonlinear dynamic" } })[1]
    equal(support.has(table.concat(row.warnings, "\n"), "loads without mass have no inertia"), told,
      ("masses of %g of the loads: %s"):format(part, row.verdict))
  end
end)

case("the formulas of the factors are refused for concrete, unless the factors are given", function()
  local concrete = hinge.section.concrete { width = 0.3, depth = 0.3, concrete = 30e6, steel = 500e6,
    strains = "plastic", bars = { { -0.1, 0.1, area = 3e-4 }, { 0.1, 0.1, area = 3e-4 }, { -0.1, -0.1, area = 3e-4 },
      { 0.1, -0.1, area = 3e-4 } } }
  local bridge_of = { side = { section = concrete, material = hinge.material { E = 30e9, density = 0.05 } } }
  for procedure, name in pairs { ["linear static"] = "omega_ld", ["nonlinear static"] = "omega_n" } do
    checks.refused({ "member 1 is of concrete", "for steel", "field '" .. name .. "'" }, rows_of, 1e3, bridge_of,
      { remove = { 2 }, limit = 0.03, procedures = { procedure } })
  end
  expect(pcall(rows_of, 1e3, bridge_of, { remove = { 2 }, omega_ld = 1.5 }), "with the factor")
end)

-- Verdicts ------------------------------------------------------------------------------------------------------------

case("verdict and reason by rotation, by forces of joints, without limits, and what was not compared", function()
  local function judged(of)
    local row = with({ without_limit = 0, pins = 0, pin_rotation = 0, joints_unrated = 0, unrated_rotation = 0 }, of)
    local verdict, reason = runs.judge_rotation(row)
    return verdict .. ": " .. reason
  end
  for _, r in ipairs {
    { { ratio = 1 }, "holds: " },
    { { ratio = 1.001, limit = 0.04, worst = 7, worst_axis = "x" },
      "exceeds the limit of rotation: member 7 has 1.001 of its limit 0.04 rad" },
    { { ratio = 0 / 0, limit = 0.04, worst = 7 }, "exceeds the limit of rotation: member 7 has " },
    { { ratio = 2, limit = 0.04, worst = 7, worst_joint = "joint at end a of member 7", worst_axis = "y" },
      "exceeds the limit of rotation: the joint at end a of member 7 has 2 of its limit 0.04 rad" },
    { { ratio = 1.5, worst_joint = "joint J", worst_axis = "tension" },
      "exceeds the capacity: the joint J has 1.5 of the tension at which it breaks" },
    { { ratio = 1.5, worst_joint = "joint J", worst_axis = "shear" },
      "exceeds the capacity: the joint J has 1.5 of the shear at which it breaks" },
    { { ratio = 0.5, joints_unrated = 1, unrated_rotation = 0.012 },
      "not rated: 1 joint without a limit of rotation turns by up to 0.012 rad; " },
    { { joints_unrated = 2, unrated_rotation = 0.012 },
      "not rated: 2 joints without a limit of rotation turn by up to 0.012 rad; " },
    { { ratio = 0.5, without_limit = 1 }, "holds: 1 plastic hinge without a limit, not compared" },
    { { ratio = 0.5, without_limit = 3, pins = 1, pin_rotation = 2e-6 },
      "holds: 3 plastic hinges without a limit, not compared; 1 pin, which turns by up to 2e-06 rad now, not "
        .. "compared" },
    { { pins = 2, pin_rotation = 0.01 }, "holds: 2 pins, which turn by up to 0.01 rad now, not compared" },
    { { pins = 2, pin_rotation = 9e-7 }, "holds: " },
  } do
    local text = judged(r[1])
    equal(text:sub(1, #r[2]), r[2], "says")
    if r[2]:find "holds" then equal(text, r[2], "and no more") end
  end
  for _, r in ipairs { { {}, false }, { { largest = 2e-6 }, true }, { { largest = 9e-7 }, false },
    { { largest = 1, strength = 5 }, false }, { { largest = 1, strength = 5, yielded = true }, true },
    { { largest = 1, ratio = 0.1, yielded = true }, false } } do
    local h = with({ largest = 0 }, r[1])
    equal(runs.is_unrated(h), r[2], "held against nothing")
    h.largest = 1e-4 * h.largest
    equal(runs.is_unrated(h, 1e4), r[2], "under a part of the loads")
  end
end)

checks.done()
