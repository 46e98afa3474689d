-- Hardening and strain rate of a material: closed forms in statics, the energy balance of all integrators, the same
-- bytes after a checkpoint in the middle of a cycle; wrong input is refused.
--
-- Run: lua5.4 tests/script/sections/material_law_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local hinge = require "hinge"
local scenes = require "scenes"
local law_scenes = require "sections.law_scenes"
local checks = support.checks "material law"
local case, near, equal, expect = checks.case, checks.near, checks.equal, checks.expect

local E, fy, L = 210e9, 235e6, 3
local function steel(hardening, rate)
  return (hinge.material { E = E, density = 7850, yield_stress = fy, hardening = hardening, rate = rate })
end
local function heb(law)
  return hinge.section.h { depth = 0.3, width = 0.3, web = 0.011, flange = 0.019, interaction = law }
end

-- A bar that is stretched to one strain after another: the stress at each.
local function stretched(material, law, strains)
  local model, tip, bar = scenes.cantilever { model = { displacement = "small" }, length = L, force = { 1e6, 0, 0 },
    member = { section = heb(law), material = material, up = { 0, 0, 1 } } }
  local stress, run = {}, nil
  for i, strain in ipairs(strains) do
    run = model:static { from = run, steps = 3, control = { node = tip, "ux", to = strain * L } }:finish()
    equal(run.verdict, "completed", run.reason)
    stress[i] = bar:forces(run).N / bar.section.area
  end
  return stress
end

case("cycles of a bar are those by hand", function()
  local strains, Et = { 0.01, -0.01, 0.02 }, E / 50
  local first = fy + Et * (0.01 - fy / E)
  for _, law in ipairs { "paper", "exact" } do
    local moves = stretched(steel { tangent = Et }, law, strains)
    near(moves[1] / first, 1, 1e-9, "first")
    -- elastic by 2 fy, then along the tangent
    local second = first - 2 * fy - Et * (0.02 - 2 * fy / E)
    near(moves[2] / second, 1, 1e-9, "back, kinematic")
    local grows = stretched(steel { tangent = Et, kinematic = 0 }, law, strains)
    near(grows[1] / first, 1, 1e-9, "first, isotropic")
    near(grows[2] / (-first - Et * (0.02 - 2 * first / E)), 1, 1e-9, "back, isotropic")
    local both = stretched(steel { tangent = Et, kinematic = 0.5 }, law, strains)
    near(2 * both[2] / (moves[2] + grows[2]), 1, 0.01, "half of each lies between them")
  end
end)

-- Armstrong and Frederick: x = s + (x0 - s) exp(-H e / s) in each branch. Under a stress that swings about a mean each
-- cycle adds the same strain. Exact, so that it is rounding (equilibrium to 1e-9) with any number of steps a branch.
case("ratcheting by Armstrong and Frederick is that by hand, with any number of steps", function()
  local H, saturation, up, down = 20e9, 120e6, 320e6, -200e6
  local back, by_hand = 0, 0
  for cycle = 1, 3 do
    by_hand = 0
    for _, branch in ipairs { { up, 1 }, { down, -1 } } do
      local sign, to = branch[2], branch[1] - branch[2] * fy
      by_hand = by_hand + sign * saturation / H * math.log((sign * saturation - back) / (sign * saturation - to))
      back = to
    end
    expect(cycle == 1 or by_hand > 1e-4, "it ratchets: %g", by_hand)
  end
  for _, steps in ipairs { 1, 4, 25 } do
    local model, tip, bar = scenes.cantilever { model = { displacement = "small" }, length = L, member = {
      section = heb "exact", up = { 0, 0, 1 }, material = steel { modulus = H, saturation = saturation } } }
    model:case "pull":load { node = tip, force = { bar.section.area, 0, 0 } }
    local run, before, last
    for _ = 1, 3 do
      before = last
      for _, stress in ipairs { up, down } do
        run = model:static { from = run, steps = steps, loads = { pull = stress } }:finish()
      end
      last = tip:displacement(run) / L
    end
    near((last - before) / by_hand, 1, 1e-6, steps .. " steps")
  end
end)

-- A bar from rest under a force that acts at once, in steps of two and a half times its axial wave. While its energy
-- still comes in, a step may lose half of the 1 % that a run may lose: all of it left nothing for the next steps, and
-- one load in 20 failed.
case("hardening with rate from rest completes, whatever the load", function()
  for i = 1, 40 do
    local model = scenes.cantilever { length = 2, force = { (0.3 + 0.05 * i) * 0.1 ^ 2 * 325e6, 0, 0 }, member = {
      section = hinge.section.solid { width = 0.1, depth = 0.1 }, material = hinge.material { E = 206e9, density = 7850,
        yield_stress = 325e6, hardening = { tangent = 2e10, kinematic = 0.5 }, rate = { D = 40.4, q = 5 } } } }
    local run = model:dynamic { dt = 1e-3, duration = 0.02, record = false }:finish()
    equal(run.verdict, "completed", ("%g N0: %s"):format(0.3 + 0.05 * i, run.reason or ""))
    expect(math.abs(run.energy_error) <= 0.0075, "%g N0: energy error %g", 0.3 + 0.05 * i, run.energy_error)
  end
end)

-- The moment at the foot of a cantilever, by the areas of a bilinear moment-curvature diagram: beyond Mp the curvature
-- grows by (M - Mp) / (H I). 2e-3 with 64 elements: each end stands for half of its element, so that the plastic zone
-- ends within one of them.
case("the plastic zone of a cantilever spreads as in the beam, with more and more elements", function()
  local H, section = E / 20, heb "exact"
  local Mp, EI = fy * section.Zx, E * section.Ix
  local M = 1.3 * Mp
  local zone = L * (1 - Mp / M)
  -- tip: M L^2 / 3 EI, and the plastic curvature (linear over the zone) times its lever arm
  local wanted = M * L ^ 2 / (3 * EI) + 0.5 * (M - Mp) / (H * section.Ix) * zone * (L - zone / 3)
  local off = {}
  for i, elements in ipairs { 16, 64 } do
    local model, tip = scenes.cantilever { model = { displacement = "small" }, length = L, force = { 0, 0, M / L },
      member = { section = section, up = { 0, 0, 1 }, elements = elements,
        material = hinge.material { E = E, G = 1e15, yield_stress = fy, hardening = { modulus = H } } } }
    local run = model:static { steps = 4 }:finish()
    local _, _, uz = tip:displacement(run)
    off[i] = math.abs(uz / wanted - 1)
  end
  expect(off[1] < 3e-2, "16 elements: %g", off[1])
  expect(off[2] < 2e-3, "64 elements: %g", off[2])
end)

local function portal(material, law)
  local member = { section = heb(), material = material }
  return law_scenes.struck({ model = { interaction = law }, column = member, beam = member }, { 9, 1.5, -2 })
end

local laws = { moves = { { tangent = E / 50 } }, grows = { { tangent = E / 50, kinematic = 0 } },
  bends = { { modulus = E / 20, saturation = 150e6 } }, fast = { nil, { D = 40.4, q = 5 } },
  all = { { tangent = E / 50, kinematic = 0.5 }, { C = 0.02, reference = 0.01 } } }

case("in dynamics the energy balance closes, whatever the law and the method", function()
  for name, law in pairs(laws) do
    law_scenes.balances(checks, function(method)
      return portal(steel(law[1], law[2]), method == "explicit" and "paper" or "exact")
    end, { duration = 0.1, error = 2e-3, what = name })
  end
end)

case("a run that was saved in the middle of a cycle goes on to the same bytes", function()
  local law = laws.all
  law_scenes.resumes(checks, function() return portal(steel(law[1], law[2]), "exact") end, { steps = 300,
    duration = 0.12, others = { [function() return portal(steel(law[1]), "exact") end] = "materials" } })
end)

case("the plan names the law, and a copy with another density keeps it", function()
  local material = steel({ tangent = 2.1e9 }, { D = 40.4, q = 5 })
  expect(material.laws:find "kinematic" and material.laws:find "Cowper", "laws: %s", material.laws)
  equal(material:with({ density = 1 }).laws, material.laws, "of the copy")
  equal(material:with({ density = 1 }).density, 1, "density of the copy")
  local found
  for _, line in ipairs(portal(material):dynamic({ dt = 1e-3, duration = 1e-3 }).effects) do
    if line.name == "plasticity" then found = line.because end
  end
  expect(found and found:find("hardening (kinematic", 1, true), "plan: %s", found)
end)

case("wrong input", function()
  for _, row in ipairs {
    { "give one of two", {} }, { "give one of two", { tangent = 1e9, modulus = 1e9 } },
    { "must be less than E", { tangent = 300e9 } }, { "from 0 to 1", { tangent = 1e9, kinematic = 1.5 } },
    { "needs kinematic hardening", { tangent = 1e9, kinematic = 0, saturation = 1e8 } },
    { "Cowper and Symonds", nil, { D = 40 } }, { "Cowper and Symonds", nil, { D = 40, q = 5, C = 0.1, reference = 1 } },
    { "must be a table", 1 },
  } do
    checks.refused(row[1], steel, row[2], row[3])
  end
  checks.refused("needs yield_stress", function() hinge.material { E = E, hardening = { tangent = 1e9 } } end)
end)

checks.done()
