-- Eq 16 in other readings: of a section, where the section is fully plastic alone, and with shear; and the fields of a
-- section that they need.
--
-- Run: lua5.4 tests/script/effects/fracture_readings_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local hinge = require "hinge"
local checks = support.checks "fracture readings"
local case, expect, equal, near = checks.case, checks.expect, checks.equal, checks.near

local E, fy = 206e9, 235e6
local G = E / 2.6
local bar = hinge.section.solid { width = 0.02, depth = 0.02 }
local steel = hinge.material { E = E, nu = 0.3, density = 7850, yield_stress = fy }
local length = 0.5

-- A bar of one element between two clamped ends. One end moves by 1 mm in 1 ms. Sideways, the bar bends like an S,
-- with a hinge at each end that rotates by the motion over the length. Along the bar, it is stretched.
-- Returns how far the end had moved when the bar broke (nil: it held), and at which end.
local function moved_bar(rule, o)
  o = o or {}
  local model = hinge.model { formulation = o.formulation or "asi", displacement = "small", elements_per_member = 1 }
  local a, b = model:node { 0, 0, 0 }, model:node { length, 0, 0 }
  model:member { a, b, section = bar, material = o.material or steel, up = { 0, 0, 1 } }
  model:fix(a)
  model:fix(b)
  local most = o.most or 0.05
  model:move { node = b, [o.direction or "z"] = { { 0, 0 }, { most, most } } }
  model:fracture(rule)
  local run = model:dynamic { dt = o.dt or 2e-5, duration = most, record = false }
  for _ in run:steps() do
    if run:count { state = "broken" } > 0 then return run.time end
  end
  expect(run.verdict == "completed", "the moved bar: %s", run.reason or "")
end

-- The curvature of the element is nearly 0, those of its sections are not: rotation / length. The chord rotates by the
-- motion over the length. The elastic part of it is shear alone, Q / (G A), since an element with its point in the
-- middle does not bend in an S.
local M = fy * bar.Zx
local elastic = 2 * M / length / (G * bar.shear_area_y)
local limit = 0.1 -- 1/m, at a hinge rotation of 0.05
local wanted = (limit * length + elastic) * length
case("limits by section break an S-bent bar about both axes, by element none", function()
  equal(moved_bar { curvature_x = limit }, nil, "S: the whole element hardly curves, so that eq 16 lets it hold")
  local broke = moved_bar { curvature_x = limit, strain_measure = "section" }
  expect(broke and math.abs(broke - wanted) < 0.01 * wanted,
    "S: by section it breaks at %s m of motion, wanted %.4g", broke, wanted)
  equal(moved_bar({ curvature_x = limit, strain_measure = "section" }, { most = 0.95 * wanted }), nil,
    "S: and not before")
  equal(moved_bar({ curvature_y = limit, strain_measure = "section" }), nil, "S: bending about x is not about y")
  local sideways = moved_bar({ curvature_y = limit, strain_measure = "section" }, { direction = "y" })
  expect(sideways and math.abs(sideways - wanted) < 0.01 * wanted, "S about y: at %s m, wanted %.4g", sideways, wanted)
  equal(moved_bar({ curvature_x = limit, strain_measure = "section" }, { formulation = "conventional" }), nil,
    "the conventional element has one hinge in its middle, which does not rotate in an S")
end)

case("a hinge that rotated and flows no more breaks by its section where it is bent on", function()
  -- A hinge at one end has rotated and flows no more. Then the bar is bent elastically, and the limit of the section is
  -- reached without flow: at end 1 and at end 2 of the element alike, when a rule that reads the section sees it.
  local rounds = { -- s; m, of the joint and of the far end
    { 0, 0, 0 }, { 1, 0.03, 0.075 }, { 1.2, 0.0285, 0.0735 }, { 2.2, 0.034, 0.1015 } }
  local function path(column)
    return function(t)
      for i = 2, #rounds do
        local a, b = rounds[i - 1], rounds[i]
        if t <= b[1] then
          local part = (1 - math.cos(math.pi * (t - a[1]) / (b[1] - a[1]))) / 2
          return a[column] + part * (b[column] - a[column])
        end
      end
      return rounds[#rounds][column]
    end
  end
  local function bent(at, rule)
    local model = hinge.model { displacement = "small" }
    local wall, joint, far = model:node { 0, 0, 0 }, model:node { length, 0, 0 }, model:node { 2 * length, 0, 0 }
    local ends = at == 1 and { wall, joint } or { joint, wall }
    model:fix(wall)
    model:fix({ joint, far }, "xy rx rz")
    local member = model:member { ends[1], ends[2], section = bar, material = steel, up = { 0, 0, 1 }, group = "bar" }
    model:member { joint, far, section = bar, material = hinge.material { E = E, nu = 0.3, density = 7850 },
      up = { 0, 0, 1 } }
    model:move { node = joint, z = path(2) }
    model:move { node = far, z = path(3) }
    rule.group = "bar"
    model:fracture(rule)
    local run = model:dynamic { dt = 2e-3, duration = 2.2, record = false }
    run:finish()
    equal(run.verdict, "completed", "bent without flow: " .. run.reason)
    return select(3, member:state(run))
  end
  local most = 0.264 -- 1/m
  for _, at in ipairs { 1, 2 } do
    local reached, in_flow
    bent(at, { where = "all", rule = function(s)
      if s.node ~= 1 or reached then return false end
      local own = s.curvature_x - s.plastic_curvature_x + s.hinge_rotation_x / (length / 2)
      if math.abs(own) >= most then reached, in_flow = s.time, s.plastic end
      return false
    end })
    local when = bent(at, { curvature_x = most, strain_measure = "section" })
    expect(reached and reached > 1.5 and not in_flow, "end %d: the limit is reached without flow, at %s s", at, reached)
    near(when or 0, reached or 1, 1e-9, ("end %d: breaks without flow"):format(at))
  end
end)

-- What a rule reads: the rotations of the hinges, and by another route the same from curvatures.
local seen, asked = {}, 0
case("a rule reads the rotation, rate and shear of its section", function()
  moved_bar({ where = "all", rule = function(s)
    asked = asked + 1
    seen[s["end"]] = { rotation = s.hinge_rotation_x, other = s.hinge_rotation_y, plastic = s.plastic_curvature_x,
      shear = s.shear_y, zero = s.shear_x, force = s.Mx, time = s.time }
  end }, { most = 0.02 })
  expect(asked > 100, "the rule was asked %d times", asked)
  local from_motion = seen[1].time / length - elastic
  for i, s in ipairs(seen) do
    near(math.abs(s.rotation), from_motion, 0.01 * from_motion, "rotation of the hinge at end " .. i)
    near(s.other, 0, 1e-9, "about y, end " .. i)
    near(math.abs(s.shear), 2 * M / length / (G * bar.shear_area_y), 1e-2 * 2 * M / length / (G * bar.shear_area_y),
      "shear strain at end " .. i)
    expect(s.rotation * s.force > 0, "the hinge at end %d rotates with its moment: %g rad, %g N m", i, s.rotation,
      s.force)
    near(s.zero, 0, 1e-12, "shear along x, end " .. i)
  end
  near((seen[1].rotation + seen[2].rotation) / length, seen[1].plastic, 1e-12, "both hinges make the plastic curvature")
  expect(seen[1].rotation * seen[2].rotation < 0, "in an S the hinges rotate against each other")
  near(seen[1].shear, (seen[2].force - seen[1].force) / length / (G * bar.shear_area_y), 1e-9, "shear is dM/dz / (G A)")
end)

local weak = hinge.material { E = E, nu = 0.3, density = 7850 } -- as stiff as steel, and it never yields

case("a bar breaks by the shear strain of its load alone, elastic or with hinges", function()
  -- Shear: Q / (G A), here 2 M_p / (L G A) when both hinges have formed.
  local most = 2 * M / length / (G * bar.shear_area_y)
  for _, direction in ipairs { "y", "z" } do
    local by_shear = moved_bar({ shear_strain = 0.9 * most }, { dt = 1e-6, most = 1e-3, direction = direction })
    expect(by_shear and by_shear < elastic * length, "shear, %s: breaks while elastic, at %s m", direction, by_shear)
  end
  equal(moved_bar { shear_strain = 1.1 * most }, nil, "shear: holds, the hinges let no more through")
  equal(moved_bar({ shear_strain = 0.9 * most }, { direction = "x", most = 0.01 }), nil, "stretched: no shear")
  local at = 10 * most * length -- m; nothing yields here
  local broke = moved_bar({ shear_strain = 10 * most }, { material = weak, dt = 1e-6, most = 1e-3 })
  expect(broke and math.abs(broke - at) < 0.02 * at, "shear, elastic bar: at %s m, wanted %.4g", broke, at)
end)

case("plastic_only breaks nothing before it yields", function()
  -- Only where plastic: strains below yield break nothing, however low the limit.
  local at_yield = fy / E * length
  local early = moved_bar({ axial_strain = 0.5 * fy / E }, { direction = "x" })
  expect(early and early < 0.6 * at_yield, "axial: breaks before it yields, at %s m", early)
  local late = moved_bar({ axial_strain = 0.5 * fy / E, plastic_only = true }, { direction = "x" })
  expect(late and late > 0.9 * at_yield and late < 1.2 * at_yield, "plastic_only: breaks as it yields, at %s m of %.4g",
    late, at_yield)
  equal(moved_bar({ axial_strain = 0.5 * fy / E, plastic_only = true }, { direction = "x", material = weak }), nil,
    "plastic_only: a bar that cannot yield holds")
  late = moved_bar { curvature_x = limit, strain_measure = "section", plastic_only = true }
  near(late, moved_bar { curvature_x = limit, strain_measure = "section" }, 1e-3 * wanted,
    "plastic_only: a hinge is plastic")
end)

case("wrong limits are refused", function()
  for _, row in ipairs {
    { "fracture", "strain_measure", { curvature_x = 1, strain_measure = "hinge" } },
    { "fracture", "plastic_only", { curvature_x = 1, plastic_only = 1 } },
    { "fracture", "shear_strain", { shear_strain = 0 } },
    { "fracture", "belongs to limits", { strain_measure = "section", rule = function() end } },
    { "fracture", "belongs to limits", { plastic_only = true, rule = function() end } },
    { "fracture", "no limit is given", {} },
    { "contact", "belongs to as_printed", { rule = "gap", sign_of_f = "as printed" } },
    { "contact", "belongs to rule 'gap'", { sign_of_f = "absolute" } },
    { "contact", "sign_of_f", { rule = "gap", as_printed = true, sign_of_f = "plus" } },
  } do
    local model = hinge.model {}
    checks.refused(row[2], model[row[1]], model, row[3])
  end
end)

checks.done()
