-- Backbones of members: the published form in numbers, the same hinge with any number of elements, the energy balance
-- of all integrators where strength falls, the same bytes after a checkpoint; wrong input is refused.
--
-- Run: lua5.4 tests/script/sections/backbone_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local hinge = require "hinge"
local scenes = require "scenes"
local law_scenes = require "sections.law_scenes"
local checks = support.checks "backbone"
local case, near, equal, expect = checks.case, checks.near, checks.equal, checks.expect

local E, fy, L = 200e9, 345e6, 3
local steel = hinge.material { E = E, density = 7850, yield_stress = fy }
local column = hinge.section.h { depth = 0.4, width = 0.2, web = 0.01, flange = 0.015 }
local Mp = fy * column.Zx

-- A modified Ibarra, Medina and Krawinkler model as it is published: strengths over Mp, rotations in rad.
local numbers = { yield = 1.1, cap_rotation = 0.025, cap_strength = 1.2, post_cap_rotation = 0.16, residual = 0.4,
  ultimate_rotation = 0.2 }

local function by_hand(rotation)
  if rotation <= 0.025 then return 1.1 + 0.1 * rotation / 0.025 end
  return support.largest_of(1.2 * (1 - (rotation - 0.025) / 0.16), 0.4 * 1.1)
end

-- A member with a backbone, or with a law: a table.
local function with(backbone, member)
  member[type(backbone) == "table" and "law" or "backbone"] = backbone
  member.section, member.material = column, steel
  return member
end

-- A cantilever whose tip is driven: the moment at its foot over Mp, by the plastic rotation of the foot.
local function driven(elements, backbone, turns, model_options)
  local model, tip, member = scenes.cantilever { model = model_options or { displacement = "small" }, length = L,
    force = { 0, 0, -Mp / L }, member = with(backbone, { up = { 0, 0, 1 }, elements = elements }) }
  local k = 1 / (L ^ 3 / (3 * E * column.Ix) + L / (steel.G * column.shear_area_y))
  local curve, run = {}, nil
  for _, turn in ipairs(turns) do
    run = model:static { from = run, steps = 25, control = { node = tip, "uz", to = -turn * L } }
    while run:step() do
      local _, _, uz = tip:displacement(run)
      local P = run.factor * Mp / L
      table.insert(curve, { (-uz - P / k) / L, run.factor })
    end
    equal(run.verdict, "completed", run.reason)
  end
  return curve, run, member
end

case("the moment over the plastic rotation is as published, with two, four and eight elements", function()
  for _, elements in ipairs { 2, 4, 8 } do
    local curve = driven(elements, hinge.backbone(numbers), { 0.19 })
    local off = 0
    for _, point in ipairs(curve) do
      if point[1] > 1e-6 then off = support.largest_of(off, math.abs(point[2] - by_hand(point[1]))) end
    end
    -- the tip's own rotation is small, and so is the error of the stiffness by hand
    expect(off < 1e-8, "%d elements: the moment is off by %g Mp", elements, off)
    near(curve[#curve][2], 0.44, 1e-8, elements .. " elements: the residual strength")
  end
end)

-- A member that is bent, and pressed beyond its squash load and far beyond the load up to which its pairs are convex:
-- 39 E I / l^2 about its weak axis, where 3.3 is that load. The return went down an energy that changed with the
-- strength: it was not found, or took 1000 times as long and then shorter steps. 3 %: Newmark's method in steps ten
-- times as long.
case("a hinge whose strength changes is found beside any compression, in steps of 0.1 ms", function()
  local function pushed(points, dt, interaction, control)
    local section = hinge.section.h { depth = 0.3, width = 0.15, web = 0.0068, flange = 0.0109 }
    local model, tip = scenes.cantilever { model = { interaction = interaction }, length = 5,
      force = { -1.19 * 325e6 * section.area, 0, -1e5 }, member = { section = section, up = { 0, 0, 1 },
        backbone = hinge.backbone { points = points },
        material = hinge.material { E = 206e9, density = 60000, yield_stress = 325e6 } } }
    model:fix(tip, "y,rx,rz")
    local run = model:dynamic { dt = dt, duration = 0.012, record = false, step_control = control }:finish()
    return run, tip:displacement(run)
  end
  for _, points in ipairs { { { 0, 1 }, { 0.006, 1.01 } }, { { 0, 1 }, { 0.006, 1.2 } }, { { 0, 1 }, { 0.006, 0.5 } },
    { { 0, 1.2 }, { 0.003, 1.3 }, { 0.01, 0.4 } } } do
    local falls = points[#points][2] < 1 -- by eq 14 a fall is a collapse, whose end a step decides
    for _, interaction in ipairs(falls and { "exact" } or { "exact", "paper" }) do
      local what = ("%g to %g, %s"):format(points[1][2], points[#points][2], interaction)
      local run, ux = pushed(points, 1e-4, interaction)
      equal(run.verdict, "completed", what .. ": " .. (run.reason or ""))
      expect(run.index < 200, "%s: %d steps for 120", what, run.index)
      expect(math.abs(run.energy_error) < 2e-3, "%s: energy error %g", what, run.energy_error)
      local fine, there = pushed(points, 1e-5, interaction)
      equal(fine.verdict, "completed", what .. ", fine: " .. (fine.reason or ""))
      near(ux / there, 1, 0.03, what .. ": shortening")
    end
  end
  equal(pushed({ { 0, 1 }, { 0.006, 1.2 } }, 1e-4, nil, 0).verdict, "completed", "every step is kept")
end)

case("beyond the ultimate rotation a hundredth is left", function()
  local curve = driven(2, hinge.backbone(numbers), { 0.19, 0.23 })
  near(curve[#curve][2], 0.01, 1e-6, "strength at the end")
end)

case("cycles of one amplitude keep the strength, and wear takes its part", function()
  local turns = { 0.06, -0.06, 0.06, -0.06 }
  local kept = driven(2, hinge.backbone(numbers), turns)
  near(math.abs(kept[50][2] / kept[100][2]), 1, 0.02, "without wear")
  local worn = driven(2, hinge.backbone(scenes.with(numbers, { wear = 1 })), turns)
  -- each half cycle turns the hinge by about 2 x 0.05 rad at 0.9 My, of 1 rad that there is: sqrt(1 - 0.32) is left
  local last = math.abs(worn[100][2] / kept[100][2])
  expect(last > 0.8 and last < 0.85, "with wear %g of it is left", last)
end)

case("wear takes stiffness in unloading by the plastic work, with two, four and eight elements", function()
  local b = hinge.backbone { yield = 1, cap_rotation = 0.3, wear = 1, stiffness_wear = true }
  for _, try in ipairs { { 2, { displacement = "small" } }, { 4, { displacement = "small" } },
    { 8, { displacement = "small" } }, { 2, {} }, { 4, {} }, { 2, { formulation = "asi" } } } do
    local model, tip = scenes.cantilever { model = try[2], length = L, force = { 0, 0, -Mp / L },
      member = with(b, { up = { 0, 0, 1 }, elements = try[1] }) }
    model:fix(tip, "y,rx,rz")
    local new = model:static { steps = 1, control = { node = tip, "uz", to = -1e-3 } }:finish()
    local run, from, turned = nil, 0, 0
    for _, turn in ipairs { 0.06, -0.06, 0.06, -0.06, 0.06 } do
      run = model:static { from = run, steps = 25, control = { node = tip, "uz", to = -turn * L } }:finish()
      equal(run.verdict, "completed", run.reason)
      local now = run:hinges()[1].rotation_x
      turned, from = turned + math.abs(now - from), now
    end
    local before, _, _, z = run.factor, tip:displacement(run)
    local back = model:static { from = run, steps = 4, control = { node = tip, "uz", to = z + 1e-3 } }:finish()
    equal(back.energy.plastic, 0, "it unloads")
    -- each direction has half of the work, which falls as the strength does
    local left = (1 - turned / 2) ^ 2
    expect(left > 0.55 and left < 0.65, "the part of the stiffness that is left is %g", left)
    local expected = 1e-3 / (1e-3 / new.factor + (1 / left - 1) * Mp * L ^ 2 / (6 * E * column.Ix))
    -- in large displacement the chord is turned by 0.06 rad, and the arm shorter
    near((before - back.factor) / expected, 1, try[2].displacement and 1e-9 or 6e-3,
      ("%d elements, %s: stiffness in unloading"):format(try[1], try[2].formulation or "asi-gauss"))
  end
end)

local function portal(backbone)
  return law_scenes.struck({ column = with(backbone, {}), beam = with(backbone, {}) }, { 6, 1, -1 })
end

local function closes(backbone)
  law_scenes.balances(checks, function() return portal(backbone) end, { duration = 0.2, explicit = 0.02,
    error = { newmark = 2e-3, explicit = 1e-4, conserving = 1e-9 } })
end

-- The backbone of the numbers, and others in their place.
local function numbered(more) return hinge.backbone(scenes.with(numbers, more)) end
local soft = { wear = 0.5, stiffness_wear = true }

case("where strength falls the energy balance closes, whatever the method", function()
  closes(numbered { wear = 2 })
end)

case("the same where stiffness falls with it", function()
  local worn = scenes.with(numbers, soft)
  -- at the ultimate rotation the strength drops faster than a soft end can unload: 0.02 % of the energy are lost there
  worn.ultimate_rotation = nil
  closes(hinge.backbone(worn))
end)

case("worn members that are heated or break keep the energy balance", function()
  local worn = numbered(soft)
  local hot = portal(worn)
  hot:heat { temperature = { { 0, 20 }, { 0.05, 20 }, { 0.2, 600 } }, properties = hinge.heat.steel() }
  local run = hot:dynamic { dt = 2e-4, duration = 0.2 }:finish()
  equal(run.verdict, "completed", run.reason)
  expect(run.energy.plastic > 1e4 and run.energy.heat ~= 0, "it yields and is heated")
  near(run.energy_error, 0, 1e-3, "heated: energy error") -- moments in the span follow the step before

  local weak, broken = portal(worn), 0
  weak:fracture(function(section)
    local breaks = section.plastic_work > 4e3
    broken = broken + (breaks and 1 or 0)
    return breaks
  end)
  run = weak:dynamic { dt = 1e-4, duration = 0.3 }:finish()
  equal(run.verdict, "completed", run.reason)
  expect(broken > 1, "%d elements break", broken)
  near(run.energy_error, 0, 3e-4, "broken: energy error")
end)

-- A cantilever that has been driven to and fro beside an axial force; then one of its two elements breaks in a step of
-- 10 ns, in which nothing moves. keeps: "foot", whose hinge is worn, or "tip", which never yields.
local function half_broken(wear, axial, turned, keeps)
  local backbone = numbered(wear and soft)
  local model, tip, member = scenes.cantilever { length = L, flipped = turned,
    member = with(backbone, { up = { 0, 0, 1 }, elements = 2, group = "post" }) }
  model:load { node = tip, force = { axial, 0, 0 }, case = model:case "axial" }
  model:load { node = tip, force = { 0, 0, -Mp / L }, case = model:case "side" }
  local run = model:static { steps = 1, loads = { axial = 1 } }:finish()
  for _, turn in ipairs { 0.02, -0.02, 0.01 } do
    run = model:static { from = run, steps = 30, loads = { axial = 1, side = 1 },
      control = { node = tip, "uz", to = -turn * L } }:finish()
    equal(run.verdict, "completed", run.reason)
  end
  local breaks = (keeps == "tip") == not turned and 1 or 2
  model:fracture { group = "post", where = "all", rule = function(section) return section.element == breaks end }
  return model, member, run
end

case("where one element of a pair breaks the other keeps its force, worn or not", function()
  for _, wear in ipairs { false, true } do
    for _, axial in ipairs { -1e3, -1e5, 4e5 } do
      for _, turned in ipairs { false, true } do
        for _, keeps in ipairs { "foot", "tip" } do
          local model, member, run = half_broken(wear, axial, turned, keeps)
          local function kept(of) return (select((keeps == "foot") == not turned and 1 or 2, of:forces(member))) end
          local before = kept(run)
          local largest = select(2, run:forces(member)).Mx
          largest = support.largest_of(math.abs(largest), math.abs((run:forces(member)).Mx))
          local broken, seen = model:dynamic { from = run, dt = 1e-8, duration = 3e-8,
            loads = { axial = 1, side = 1 } }, 0
          while broken:step() do -- right after the break, and in the step after it
            if broken:state(member) == "broken" then
              seen = seen + 1
              local after = kept(broken)
              local what = ("%s, N = %g%s, %s is left, step %d"):format(wear and "worn" or "whole", axial,
                turned and ", turned" or "", keeps, seen)
              near(after.N, before.N, 1e-6 * support.largest_of(math.abs(before.N), 1e3), what .. ": N")
              -- moments of the pair's bending beside N that are beyond those of the element by itself are let go
              near(after.Qy, before.Qy, 4e-3 * largest / L, what .. ": shear")
              near(after.Mx, before.Mx, 4e-3 * largest, what .. ": moment")
            end
          end
          expect(seen >= 2, "%d steps with the broken element", seen)
          near(broken.energy_error, 0, 1e-4, "energy error")
        end
      end
    end
  end
end)

case("a run that was saved on the falling branch goes on to the same bytes", function()
  law_scenes.resumes(checks, function() return portal(numbered(soft)) end, { steps = 400, duration = 0.12, others = {
    [function() return portal(hinge.backbone { points = { { 0, 1.1 }, { 0.1, 1 } } }) end] = "materials" } })
end)

case("a law of the script that follows the rotation is the same backbone, to rounding", function()
  local points = { { 0, 1.1 }, { 0.02, 1.2 }, { 0.1, 0.3 } }
  local function strength(rotation)
    for i = 2, #points do
      local a, b = points[i - 1], points[i]
      if rotation <= b[1] then return a[2] + (b[2] - a[2]) / (b[1] - a[1]) * (rotation - a[1]) end
    end
    return points[#points][2]
  end
  local law = { variables = 3, step = function(flow, history)
    local x, y = history[1] + flow.x, history[2] + flow.y
    local largest = support.largest_of(history[3], math.sqrt(x ^ 2 + y ^ 2))
    return flow.at_end and strength(largest) or 1.2, nil, { x, y, largest }
  end }
  local turns = { 0.03, -0.05, 0.12 }
  local a, b = driven(2, hinge.backbone { points = points }, turns), driven(2, law, turns)
  local off = 0
  for i = 1, #a do off = support.largest_of(off, math.abs(a[i][2] - b[i][2])) end
  -- the slopes of the tangent differ by 1e-6, so that Newton's method ends elsewhere within its tolerance of 1e-10
  expect(#a == 75 and off < 1e-9, "statics: the moments differ by %g Mp", off)
  local options = { dt = 1e-3, duration = 0.6 }
  local of_points = portal(hinge.backbone { points = points }):dynamic(options):finish()
  local of_law = portal(law):dynamic(options):finish()
  expect(of_points.energy.plastic > 1e3, "it yields")
  -- the mean over a step is by Simpson's rule: steps over a kink of the points differ
  near(of_law.energy.plastic / of_points.energy.plastic, 1, 1e-4, "dynamics: plastic work")
  -- explicit steps have no tangent: the law alone is compared
  options = { integrator = "explicit", dt = 2e-5, duration = 0.2 }
  local fast_points = portal(hinge.backbone { points = points }):dynamic(options):finish()
  local fast_law = portal(law):dynamic(options):finish()
  near(fast_law.energy.elastic / fast_points.energy.elastic, 1, 1e-10, "explicit: elastic energy")
end)

case("what was given can be read, and the plan names it", function()
  local b = hinge.backbone(numbers)
  equal(#b.points, 5, "points")
  near(b.points[2][1], 0.025, 1e-15, "rotation at the cap")
  near(b.points[3][2], 0.44, 1e-15, "residual strength")
  equal(b.wear, nil, "wear")

  local found
  for _, line in ipairs(portal(b):dynamic({ dt = 1e-3, duration = 1e-3 }).effects) do
    if line.name == "plasticity" then found = line.because end
  end
  expect(found and found:find("backbone (", 1, true), "plan: %s", found)
  local _, _, member = driven(2, b, { 0.01 })
  equal(member.backbone, b, "of the member")
end)

case("wrong input", function()
  for _, row in ipairs {
    { "cap_rotation", {} }, { "it must be 0", { points = { { 0.1, 1 } } } },
    { "must be more than that before", { points = { { 0, 1 }, { 0, 2 } } } },
    { "0.01 or more", { points = { { 0, 1 }, { 0.1, 0 } } } },
    { "must be { rotation (rad), strength }", { points = { { 0, "a" } } } },
    { "at least one point", { points = {} } }, { "given beside points", { points = { { 0, 1 } }, yield = 1 } },
    { "needs post_cap_rotation", { cap_rotation = 0.02, residual = 0.4 } },
    { "more than cap_rotation", { cap_rotation = 0.02, ultimate_rotation = 0.01 } },
    { "more than cap_strength", { cap_rotation = 0.02, post_cap_rotation = 0.1, residual = 2 } },
    { "must be above 0", { cap_rotation = 0.02, wear = -1 } },
    { "needs wear (rad)", { cap_rotation = 0.02, stiffness_wear = true } },
  } do
    checks.refused(row[1], function() hinge.backbone(row[2]) end)
  end
  local b = hinge.backbone(numbers)
  for _, given in ipairs { {}, function() return 1 end } do
    checks.refused({ "hinge.backbone", "law =" }, scenes.cantilever, { member = { backbone = given } })
  end
  for words, more in pairs { yield_stress = { material = scenes.elastic }, ["no hinges at its ends"] = {
    carries = "tension" } } do
    checks.refused(words, scenes.cantilever, { member = scenes.with({ material = steel, backbone = b }, more) })
  end
  checks.refused("ends of elements", scenes.cantilever, { model = { formulation = "conventional" },
    member = { material = steel, backbone = b } })
end)

checks.done()
