-- hinge.results.utilisation: what it takes from runs: demands, envelopes, broken members, lengths, options.
-- The formulas have tests of their own, eurocode_tables_test.lua and aisc_tables_test.lua.
--
-- Run: lua5.4 tests/script/results/utilisation_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local hinge = require "hinge"
local results = require "hinge.results"
local eurocode = require "hinge.standards.en_1993_1_1.members"
local profile = require "hinge.results.profile"
local scenes = require "scenes"
local support = require "support"
local checks = support.checks "utilisation"
local case, expect, equal, near = checks.case, checks.expect, checks.equal, checks.near
local with = scenes.with

require "hinge.core".own_output(support.temporary_folder(), {}, true)

local function steel(options)
  return hinge.material(with({ E = 210e9, nu = 0.3, density = 7850, yield_stress = 355e6 }, options))
end
local ipe = hinge.section.named "IPE 400"
local en = { standard = "EN 1993-1-1" }
local us = { standard = "AISC 360" }

local function same(value, wanted, what) near(value, wanted, 1e-9 * math.abs(wanted), what) end

-- A simple beam of 4 m along x, held against twist.
local function beam(section, material, options)
  local model = hinge.model(options or { displacement = "small", plasticity = false })
  local a, b = model:node { 0, 0, 0 }, model:node { 4, 0, 0 }
  model:fix(a, "x,y,z,rx")
  model:fix(b, "y,z")
  local member = model:member { a, b, section = section or ipe, material = material or steel(), up = { 0, 0, 1 },
    group = "beams" }
  return model, a, b, member
end

-- The beam under these end forces, and its row.
local function row_of(forces, o, section, material)
  local model, a, b = beam(section, material)
  model:load { node = b, force = { forces.N or 0, 0, 0 }, moment = { 0, -(forces.Mxb or forces.Mx or 0),
    forces.Myb or forces.My or 0 } }
  model:load { node = a, moment = { 0, forces.Mx or 0, -(forces.My or 0) } }
  local run = model:static { steps = 1 }:finish()
  return results.utilisation(run, with(o, { model = model })).rows[1]
end

-- What is refused -----------------------------------------------------------------------------------------------------

case("what the formulas do not cover is refused by both standards", function()
  for _, o in ipairs { en, us } do
    for _, r in ipairs {
      { steel { E = 70e9 }, "its E is 70 GPa, which is not that of steel" },
      { steel { E = 184e9 }, "its E is 184 GPa" }, { steel { E = 186e9 } }, { steel { E = 214e9 } },
      { steel { E = 216e9 }, "its E is 216 GPa" }, { steel { yield_stress = 701e6 }, "its yield stress is 701 MPa" },
      { hinge.material { E = 210e9 }, "its material has no yield stress" },
    } do
      local row = row_of({ N = -1e3 }, o, hinge.section.h { depth = 0.2, width = 0.2, web = 0.02, flange = 0.03 }, r[1])
      if r[2] then
        expect(row.remark and row.remark:find("not checked: " .. r[2], 1, true), "%s: '%s' in: %s", o.standard, r[2],
          tostring(row.remark))
        equal(row.utilisation, nil, "no number")
      else
        expect(row.utilisation and not row.remark, "%s: %g GPa is steel: %s", o.standard, r[1].E / 1e9,
          tostring(row.remark))
      end
    end
  end
  for _, r in ipairs {
    { en, hinge.section.named "UPN 200", "its plates are not known" },
    { en, hinge.section.h { depth = 0.6, width = 0.3, web = 0.004, flange = 0.008 }, "class 3 or 4: the flange has" },
    { us, hinge.section.named "HSS20X12X5/16", "slender in compression (E7)" },
  } do
    local row = row_of({ N = -10e3 }, r[1], r[2])
    equal(row.utilisation, nil, "no number")
    expect(support.has(tostring(row.remark), r[3]), "'%s' in: %s", r[3], tostring(row.remark))
  end
  -- 1.02 of the slenderness of class 2
  local e = math.sqrt(235 / 355)
  for times, wanted in pairs { [0.99] = false, [1.02] = true } do
    local flange = 0.095 / (10 * e * times) -- c = (0.2 - 0.01) / 2
    local s = hinge.section.h { depth = 0.3, width = 0.2, web = 0.01, flange = flange }
    local row = row_of({ N = -1e3, Mx = 1e3 }, en, s)
    equal(row.utilisation == nil, wanted, times .. " of the limit")
    near(row.slenderness, times, 1e-6, "the slenderness of plates is in the row")
  end
end)

case("Lb is refused for a bar or a box that is wider than deep alone", function()
  for _, r in ipairs { { hinge.section.solid { width = 0.2, depth = 0.02 }, true },
    { hinge.section.solid { width = 0.02, depth = 0.2 }, false },
    { hinge.section.box { width = 0.3, depth = 0.2, thickness = 0.02 }, true },
    { hinge.section.box { width = 0.2, depth = 0.3, thickness = 0.02 }, false },
    { hinge.section.named "HEA 300", false },
  } do
    for _, o in ipairs { en, us } do
      local row = row_of({ N = 1e3 }, with(o, { lengths = { Lb = 1 } }), r[1], steel { yield_stress = 235e6 })
      local said = row.remark and row.remark:find("wider than deep", 1, true) ~= nil or false
      equal(said, r[2], r[1].kind .. ": " .. tostring(row.remark))
    end
  end
end)

-- Demands -------------------------------------------------------------------------------------------------------------

case("a member is checked for its largest compression and moments, of any sign", function()
  local s = ipe
  local row = row_of({ N = -300e3, Mx = -80e3, My = 6e3 }, en)
  local d = { compression = 300e3, Mx = 80e3, My = 6e3, tension = 0 }
  local _, wanted = eurocode.member(s, profile.of(s), steel(), d, { Lx = 4, Ly = 4, C1 = 1 },
    { x = 1, y = 1, LT = 1 }, { gamma_M0 = 1, gamma_M1 = 1, interaction = "standard" })
  same(row["6.3.1 Ny"], 300e3 / (wanted.chi_y * s.area * 355e6), "compression")
  near(row["6.61"], row["6.3.1 Nx"] + wanted.kxx * 80e3 / (s.Zx * 355e6) + wanted.kxy * 6e3 / (s.Zy * 355e6), 1e-6,
    "moments")
  local pulled = row_of({ N = 300e3, Mx = 80e3 }, en)
  equal(pulled["6.61"], nil, "none of buckling in tension")
  same(pulled["6.2.3 N"], 300e3 / (s.area * 355e6), "tension")
  local by_aisc = row_of({ N = -900e3, Mx = -80e3, My = 6e3 }, us, hinge.section.named "HEB 300")
  local R = by_aisc.strengths
  local n = 900e3 / R.compression_y
  near(by_aisc["H1-1 member"], n + 8 / 9 * (80e3 / R.Mx + 6e3 / R.My), 1e-6, "AISC")
end)

case("lengths: factors, lengths, groups and a function", function()
  local function slendernesses(lengths)
    local detail = row_of({ N = -300e3 }, with(en, { lengths = lengths })).detail
    return detail.slenderness_x, detail.slenderness_y
  end
  local x, y = slendernesses()
  same(x, math.sqrt(ipe.area * 355e6 / (math.pi ^ 2 * 210e9 * ipe.Ix)) * 4, "of the member: about x")
  same(y, math.sqrt(ipe.area * 355e6 / (math.pi ^ 2 * 210e9 * ipe.Iy)) * 4, "about y")
  for _, r in ipairs { { { kx = 2, Ly = 1 }, 2, 0.25 }, { { beams = { Lx = 6 } }, 1.5, 1 },
    { function(m) return { ky = m.length / 2 } end, 1, 2 } } do -- others: results_tables_test.lua
    local kx, ky = slendernesses(r[1])
    same(kx, r[2] * x, "about x")
    same(ky, r[3] * y, "about y")
  end
  -- M_cr goes with C1, and phi M_n with Cb
  local one = row_of({ Mx = 10e3 }, with(en, { lengths = { Lb = 4 } })).detail
  local two = row_of({ Mx = 10e3 }, with(en, { lengths = { Lb = 4, C1 = 1.88 } })).detail
  same(two.M_cr, 1.88 * one.M_cr, "C1")
  local a = row_of({ Mx = 10e3 }, with(us, { lengths = { Lb = 9 } })).strengths
  local b = row_of({ Mx = 10e3 }, with(us, { lengths = { Lb = 9, Cb = 1.2 } })).strengths
  same(b.Mx, 1.2 * a.Mx, "Cb")
end)

case("gamma_M0, gamma_M1, curves and Cm are taken from the options", function()
  local forces = { N = -300e3, Mx = 80e3, My = 6e3 }
  local plain = row_of(forces, en)
  same(row_of(forces, with(en, { gamma_M0 = 1.1 }))["6.2.4 N"], 1.1 * plain["6.2.4 N"], "gamma_M0")
  same(row_of(forces, with(en, { gamma_M1 = 1.2 }))["6.3.1 Nx"], 1.2 * plain["6.3.1 Nx"], "gamma_M1")
  equal(row_of(forces, with(en, { curves = "d" })).detail.curve_x, "d", "a curve for both axes, x")
  equal(row_of(forces, with(en, { curves = "d" })).detail.curve_y, "d", "y")
  local mixed = row_of(forces, with(en, { curves = { y = "c" } })).detail
  equal(mixed.curve_x .. mixed.curve_y, "ac", "a curve for y")
  local one = row_of(forces, with(en, { Cm = 0.6 })).detail
  same(one.kxx, 0.6 * plain.detail.kxx, "one Cm for all, x")
  same(one.kyy, 0.6 * plain.detail.kyy, "y")
  local of_x = row_of(forces, with(en, { Cm = { x = 0.5 } })).detail
  same(of_x.kxx, 0.5 * plain.detail.kxx, "Cm of x")
  same(of_x.kyy, plain.detail.kyy, "leaves y")
end)

case("table B.3: Cm = 0.6 + 0.4 psi, at least 0.4, from the moments of the run", function()
  for _, r in ipairs { { 1, 1 }, { 0.5, 0.8 }, { 0, 0.6 }, { -0.4, 0.44 }, { -0.5, 0.4 }, { -1, 0.4 }, { 2, 0.8 } } do
    local psi, Cm = r[1], r[2]
    local fixed = with(en, { Cm = { x = Cm, y = 1, LT = Cm } })
    local about_x = { N = -300e3, Mx = 30e3, Mxb = psi * 30e3 }
    near(row_of(about_x, with(en, { Cm = "B.3" }))["6.61"], row_of(about_x, fixed)["6.61"], 1e-9, "x, psi = " .. psi)
    local about_y = { N = -300e3, My = 3e3, Myb = psi * 3e3 }
    fixed.Cm = { x = 1, y = Cm, LT = 1 }
    near(row_of(about_y, with(en, { Cm = "B.3" }))["6.62"], row_of(about_y, fixed)["6.62"], 1e-9, "y, psi = " .. psi)
  end
  -- a moment that is not linear between the ends has 1
  local model, _, b, member = beam()
  model:load { node = b, force = { -300e3, 0, 0 } }
  model:load { member = member, q = { 0, 0, -20e3 } }
  local run = model:static { steps = 1 }:finish()
  local row = results.utilisation(run, with(en, { model = model, Cm = "B.3" })).rows[1]
  same(row["6.61"], results.utilisation(run, with(en, { model = model, Cm = 1 })).rows[1]["6.61"], "a parabola")
end)

-- Several states ------------------------------------------------------------------------------------------------------

case("the largest of several runs, with its name and place", function()
  local model, _, b, member = beam()
  model:load { member = member, q = { 0, 0, -10e3 }, case = model:case "dead" }
  model:load { node = b, force = { 400e3, 0, 0 }, case = model:case "pull" }
  local runs = {}
  for i, loads in ipairs { { dead = 1 }, { dead = 1.5 }, { pull = 1 } } do
    runs[i] = model:static { steps = 1, loads = loads }:finish()
  end
  for i, order in ipairs { { 1, 2 }, { 2, 1 } } do
    local row = results.utilisation({ runs[order[1]], runs[order[2]] }, with(en, { model = model })).rows[1]
    equal(row.when, "1.5 dead", "the state, order " .. i)
    near(row.x, 2, 1e-9, "the place")
    same(row["6.2.9 Mx"], 1.5 * 10e3 * 16 / 8 / (ipe.Zx * 355e6), "the ratio")
    near(row["6.2.6 Vy"], 1.5 * 20e3 / (ipe.area - 2 * 0.18 * 0.0135 + 0.0506 * 0.0135) / (355e6 / math.sqrt(3)), 1e-6,
      "at the ends")
  end
  local both = results.utilisation({ runs[1], runs[3] }, with(en, { model = model, names = { "A", "B" } }))
  equal(both.rows[1].checks["6.2.3 N"].when, "B", "a name that is given")
  equal(both.states, 2, "states")
end)

case("a member that broke is told after a second run in which it did not", function()
  local model = hinge.model { displacement = "small" }
  model:fracture { axial_strain = 1e-3 }
  local a, b, c = model:node { 0, 0, 0 }, model:node { 4, 0, 0 }, model:node { 8, 0, 0 }
  model:fix({ a, c }, "all")
  model:fix(b, "y,z,rx,ry,rz")
  for _, ends in ipairs { { a, b }, { b, c } } do
    model:member { ends[1], ends[2], section = ipe, material = steel { yield_stress = 500e6 } }
  end
  model:load { node = b, force = { 4.2e6, 0, 0 }, case = model:case "much" }
  model:load { node = b, force = { 1e5, 0, 0 }, case = model:case "little" }
  local used = results.utilisation({}, with(en, { model = model }))
  local much = model:dynamic { dt = 2e-5, duration = 4e-3, loads = { much = 1 } }:finish()
  used:add(much, "much")
  equal(used.rows[1].remark, "broken", "after the run in which it breaks: " .. tostring(much.verdict))
  local little = model:dynamic { dt = 2e-5, duration = 1e-4, loads = { little = 1 } }:finish()
  equal(little:state(model:members()[1]) == "broken", false, "in the next run it is whole")
  used:add(little, "little")
  equal(used.rows[1].remark, "broken", "and the table still says that it broke")
end)

-- Envelopes -----------------------------------------------------------------------------------------------------------

-- Two columns of one piece under a load along them between two stations, and moments.
local function column(cases, section)
  local model = hinge.model { displacement = "small", plasticity = false }
  local foot, head = model:node { 0, 0, 0 }, model:node { 0, 0, 4 }
  model:fix(foot, "x,y,z,rz")
  model:fix(head, "x,y")
  local member = model:member { foot, head, section = section or ipe, material = steel(), up = { 1, 0, 0 } }
  cases(model, member, head)
  return model
end

case("an envelope has a peak of N and of moments between two stations, on the safe side", function()
  for _, sign in ipairs { -1, 1 } do
    local model = column(function(model, member)
      -- N has its extreme at the load: sign times 400 kN there, less towards both ends
      model:load { member = member, q = { 0, 0, -sign * 100e3 }, case = model:case "axial" }
      model:load { member = member, force = { 0, 0, sign * 500e3 }, at = 0.56, case = "axial" }
      model:load { member = member, force = { 40e3, 0, 0 }, at = 0.31, case = model:case "across" }
    end)
    local runs = {}
    for i, name in ipairs { "axial", "across" } do
      runs[i] = model:static { steps = 1, loads = { [name] = 1 } }:finish()
    end
    for _, o in ipairs { en, us } do
      local one = with(o, { model = model })
      local each = results.utilisation(runs, one).rows[1]
      local bound = results.utilisation(results.envelope { runs[1], runs[2], model = model }, one).rows[1]
      for name, value in pairs(each.checks) do
        if bound.checks[name] then
          expect(bound.checks[name].value >= value.value * (1 - 1e-9), "%s, %s: %g is at least %g", o.standard, name,
            bound.checks[name].value, value.value)
        else expect(false, "%s is not in the envelope", name) end
      end
      local members = results.members(runs[1], { model = model }).rows[1]
      if o == en then
        local N = support.largest_of(-members.N_min, members.N_max)
        local name = -members.N_min > members.N_max and "6.2.4 N" or "6.2.3 N"
        near(bound[name], N / (ipe.area * 355e6), 1e-6, "N at the load, between two stations: " .. N)
      end
    end
  end
end)

case("a moment between two stations of an envelope goes with the larger N of both, of either sign", function()
  local heb = hinge.section.named "HEB 300"
  for _, sign in ipairs { -1, 1 } do
    -- N goes from sign times 900 kN at the head to 2400 kN at the foot; the moment is largest 1.24 m above the foot
    local model = column(function(model, member, head)
      model:load { node = head, force = { 0, 0, sign * 900e3 } }
      model:load { member = member, q = { 0, 0, sign * 375e3 } }
      model:load { member = member, force = { 100e3, 0, 0 }, at = 0.31 }
    end, heb)
    local run = model:static { steps = 1 }:finish()
    local row = results.utilisation(results.envelope { run, model = model }, with(en, { model = model })).rows[1]
    local M = 100e3 * 0.31 * 0.69 * 4
    local function ratio(N)
      return (eurocode.section(heb, profile.of(heb), 355e6, { N = N, Mx = M, My = 0, Mz = 0, Qx = 0, Qy = 0 },
        { gamma_M0 = 1, gamma_M1 = 1, interaction = "standard" }))["6.2.9 Mx"]
    end
    -- stations stand every half metre: 2025 kN at 1 m, 1837.5 kN at 1.5 m
    near(row["6.2.9 Mx"], ratio(sign * 2025e3), 1e-3 * row["6.2.9 Mx"], "beside 2025 kN, sign " .. sign)
    expect(ratio(sign * 2025e3) > 1.05 * ratio(sign * 1837.5e3), "which is more than beside 1837.5 kN")
  end
end)

case("tension and compression of an envelope go each with the largest moments", function()
  local model = column(function(model, member, head)
    model:load { node = head, force = { 0, 0, -600e3 }, case = model:case "press" }
    model:load { node = head, force = { 0, 0, 900e3 }, case = model:case "pull" }
    model:load { member = member, force = { 90e3, 0, 0 }, at = 0.56, case = model:case "across" }
  end)
  local runs = {}
  for i, name in ipairs { "press", "pull", "across" } do
    runs[i] = model:static { steps = 1, loads = { [name] = 1 } }:finish()
  end
  local rows = results.utilisation(results.envelope { runs[1], runs[2], runs[3], model = model },
    with(en, { model = model })).rows
  local M, Mpl, Npl = 90e3 * 0.56 * 0.44 * 4, ipe.Zx * 355e6, ipe.area * 355e6
  local _, detail = eurocode.section(ipe, profile.of(ipe), 355e6, { N = 900e3, Mx = M, My = 0, Mz = 0, Qx = 0, Qy = 0 },
    { gamma_M0 = 1, gamma_M1 = 1, interaction = "standard" })
  near(rows[1]["6.2.3 N"], 900e3 / Npl, 1e-6, "tension")
  near(rows[1]["6.2.4 N"], 600e3 / Npl, 1e-6, "compression")
  near(rows[1]["6.2.9 Mx"], M / detail.MNx, 1e-6, "the moment beside the larger force")
  expect(rows[1]["6.61"] > 600e3 / Npl + M / Mpl, "buckling with the moment: %g", rows[1]["6.61"])
end)

checks.done()
