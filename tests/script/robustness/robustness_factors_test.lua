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

local g, fy, E = 9.80665, 325e6, 206e9
local box = hinge.section.box { width = 0.15, depth = 0.3, thickness = 0.01 }
local post = hinge.section.box { width = 0.25, depth = 0.25, thickness = 0.012 }
local Mp = box.Zx * fy

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
  local steel = hinge.material { E = E, density = 0.05, yield_stress = fy }
  local top = {}
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
  local function with(of) return { N = of.N or 0, Mx = of.Mx or 0, My = of.My or 0 } end
  local small, large = with { Mx = 0.3 * Mp }, with { Mx = -0.7 * Mp }
  near(demands(4, small, large).ratio, 0.7, 1e-12, "the last end has more")
  near(demands(4, large, small).ratio, 0.7, 1e-12, "the first end has more")
  equal(demands(4, large, small).member, 4, "the member")
  near(demands(4, with { Mx = 0.3 * Mp, My = -0.25 * Mpy }, none).ratio, 0.55, 1e-12, "about both axes")
  near(demands(4, with { Mx = 0.3 * Mp }, none, 2.5).ratio, 0.75, 1e-12, "times the factor of deformation")
  -- on each side of N / N0 = 0.2
  local N0 = box.plastic_area * fy
  near(demands(4, with { N = 0.199 * N0, Mx = 0.3 * Mp }, none).ratio, 0.0995 + 0.3, 1e-12, "n = 0.199")
  near(demands(4, with { N = -0.201 * N0, Mx = 0.3 * Mp }, none).ratio, 0.201 + 8 / 9 * 0.3, 1e-12, "n = 0.201")
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

-- Two spans without the middle post: P on the joint above it. The outer posts, of a small section, carry P / 2 each.
local function bridge(P, side, options)
  options = options or {}
  local model = hinge.model { displacement = "small" }
  local steel = hinge.material { E = E, density = 0.05, yield_stress = fy }
  local top, spans = {}, options.spans or 2
  for i = 0, spans do
    local foot = model:node { 5 * i, 0, 0 }
    top[i] = model:node { 5 * i, 0, 3 }
    model:fix(foot)
    model:fix(top[i], "y,rx,rz")
    local outer = i == 0 or i == spans
    model:member { foot, top[i], section = outer and side or post, material = steel, up = { 1, 0, 0 } }
  end
  for i = 1, spans do
    model:member { top[i - 1], top[i], section = box, material = steel, up = { 0, 0, 1 }, group = "beams" }
  end
  for i = 1, spans - 1 do
    if options.mass then model:mass { node = top[i], mass = options.mass * P / g } end
    model:case("dead"):load { node = top[i], force = { 0, 0, -P } }
  end
  return model, top
end

case("the DCR of actions that are controlled by force is not divided by m", function()
  local side = hinge.section.solid { width = 0.05, depth = 0.05 } -- N0 = 812.5 kN
  local N0 = 0.05 ^ 2 * fy
  for _, m in ipairs { 1, 4 } do
    local P = 600e3 -- 2 P / 2 over N0: 0.74
    local result = robustness { build = function() return bridge(P, side) end, remove = { 2 }, quiet = true,
      procedures = { "linear static" }, m = m, loads = { dead = 1 } }
    local row = result.rows[1]
    expect(row.force_dcr > 0.5, "columns are controlled by force: %s", tostring(row.force_dcr))
    local posts = 2 * P / 2 / N0
    expect(row.force_dcr >= posts * 0.99, "%g is at least that of N alone, %g", row.force_dcr, posts)
    near(row.ratio, support.largest_of(row.dcr / m, row.force_dcr), 1e-12, "the ratio, m = " .. m)
    equal(row.dcr_limit, m, "the limit of the others")
  end
  -- a force of 1.1 N0 is not carried by any m
  local row = robustness { build = function() return bridge(1.1 * N0, side) end, remove = { 2 }, quiet = true,
    procedures = { "linear static" }, m = 100, loads = { dead = 1 } }.rows[1]
  equal(row.verdict, "exceeds the capacity", row.reason)
  expect(row.force_dcr > 1 and row.ratio == row.force_dcr, "by force: %g", row.force_dcr)
  local member = tonumber(row.reason:match "^member (%d+) has a DCR of ")
  expect(member == 1 or member == 3, "it names an outer post: %s", row.reason)
end)

case("two columns that go together have the deflection of a frame without both", function()
  local P = 20e3
  local function deflection(remove)
    return robustness { build = function() return bridge(P, post, { spans = 3 }) end, remove = remove, quiet = true,
      procedures = { "linear static" }, m = 2, loads = { dead = 1 } }
  end
  local both = deflection { { 2, 3 } }
  equal(both.cases, 1, "one case")
  equal(#both.rows[1].members, 2, "with two members")
  local row = both.rows[1]
  -- by hand: the same frame without the two, elastic, under P on both joints times Omega_LD = 2.9
  local model = hinge.model { displacement = "small", plasticity = false }
  local steel = hinge.material { E = E, density = 0.05, yield_stress = fy }
  local top = {}
  for i = 0, 3 do
    top[i] = model:node { 5 * i, 0, 3 }
    model:fix(top[i], "y,rx,rz")
    if i == 0 or i == 3 then
      local foot = model:node { 5 * i, 0, 0 }
      model:fix(foot)
      model:member { foot, top[i], section = post, material = steel, up = { 1, 0, 0 } }
    else model:load { node = top[i], force = { 0, 0, -2.9 * P } } end
  end
  local beams = {}
  for i = 1, 3 do
    beams[i] = model:member { top[i - 1], top[i], section = box, material = steel, up = { 0, 0, 1 } }
  end
  local run = model:static { steps = 1 }:finish()
  near(row.deflection, -select(3, top[1]:displacement(run)), 1e-3 * row.deflection, "deflection, m")
  local worst = 0
  for _, beam in ipairs(beams) do
    for _, at in ipairs { beam:forces(run) } do
      worst = support.largest_of(worst, math.abs(at.N) / (2 * box.plastic_area * fy) + math.abs(at.Mx) / Mp)
    end
  end
  near(row.dcr, worst, 1e-3 * worst, "DCR of a beam, n / 2 + m")
  local one = deflection { 2 }.rows[1]
  expect(one.deflection < 0.5 * row.deflection, "one alone goes down less: %g of %g m", one.deflection, row.deflection)
end)

case("loads without inertia are told above 1.5 times the weight of all masses", function()
  for part, told in pairs { [0.6] = true, [0.7] = false } do
    local row = robustness { build = function() return bridge(15e3, post, { mass = part }) end, remove = { 2 },
      quiet = true, procedures = { "nonlinear dynamic" }, limit = 0.06, loads = { dead = 1 } }.rows[1]
    local found = false
    for _, text in ipairs(row.warnings) do
      found = found or text:find("loads without mass have no inertia", 1, true) ~= nil
    end
    equal(found, told, ("masses of %g of the loads: %s"):format(part, row.verdict))
  end
end)

case("the formulas of the factors are refused for concrete, unless the factors are given", function()
  local concrete = hinge.section.concrete { width = 0.3, depth = 0.3, concrete = 30e6, steel = 500e6,
    strains = "plastic", bars = { { -0.1, 0.1, area = 3e-4 }, { 0.1, 0.1, area = 3e-4 }, { -0.1, -0.1, area = 3e-4 },
      { 0.1, -0.1, area = 3e-4 } } }
  local function build()
    local model, heads = hinge.model { displacement = "small" }, {}
    local steel = hinge.material { E = E, density = 0.05, yield_stress = fy }
    for i = 0, 2 do
      local foot = model:node { 5 * i, 0, 0 }
      heads[i] = model:node { 5 * i, 0, 3 }
      model:fix(foot)
      model:fix(heads[i], "y,rx,rz")
      model:member { foot, heads[i], section = i == 0 and concrete or post, material = i == 0
        and hinge.material { E = 30e9, density = 0.05 } or steel, up = { 1, 0, 0 } }
      if i > 0 then
        model:member { heads[i - 1], heads[i], section = box, material = steel, up = { 0, 0, 1 } }
      end
    end
    model:case("dead"):load { node = heads[1], force = { 0, 0, -1e3 } }
    return model
  end
  local function result(options)
    local all = { build = build, remove = { 2 }, quiet = true, loads = { dead = 1 }, limit = 0.03 }
    for name, value in pairs(options) do all[name] = value end
    local good, message = pcall(robustness, all)
    return good and "made" or tostring(message)
  end
  for procedure, name in pairs { ["linear static"] = "omega_ld", ["nonlinear static"] = "omega_n" } do
    local said = result { procedures = { procedure } }
    expect(said:find("member 1 is of concrete; the formulas of the factors are for steel; give field '" .. name .. "'",
      1, true), "%s: %s", procedure, said)
  end
  equal(result { procedures = { "linear static" }, omega_ld = 1.5 }, "made", "with the factor")
end)

-- Verdicts ------------------------------------------------------------------------------------------------------------

case("verdict and reason by rotation, by forces of joints, without limits, and what was not compared", function()
  local function judged(of)
    local row = { without_limit = 0, pins = 0, pin_rotation = 0, joints_unrated = 0, unrated_rotation = 0 }
    for name, value in pairs(of) do row[name] = value end
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
    local h = { largest = 0 }
    for name, value in pairs(r[1]) do h[name] = value end
    equal(runs.is_unrated(h), r[2], "held against nothing")
    h.largest = 1e-4 * h.largest
    equal(runs.is_unrated(h, 1e4), r[2], "under a part of the loads")
  end
end)

checks.done()
