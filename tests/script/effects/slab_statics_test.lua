-- Statics of slabs: one step finds what many find, and with few factorisations.
--
-- Run: lua5.4 tests/script/effects/slab_statics_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local hinge = require "hinge"
local checks = support.checks "slab_statics"
local case, expect = checks.case, checks.expect

local slabs = {
  ["a plate of steel"] = { thickness = 0.012, material = hinge.material { E = 210e9, density = 7850 } },
  ["concrete with given moments"] = { concrete = { thickness = 0.13, E = 33e9, strength = 30e6 },
    reinforcement = { x = 4e-4, y = 4e-4, yield_stress = 500e6, hardening = 1e9 },
    bending = { stiffness = 1.5e6, sagging = 20e3, hogging = 20e3 } },
  ["concrete that bends by its layers"] = { concrete = { thickness = 0.13, E = 33e9, strength = 30e6 },
    reinforcement = { x = 4e-4, y = 4e-4, z = -0.03, yield_stress = 500e6, hardening = 1e9 }, bending = "layers" },
}

-- Two by one bays under their weight: the sag in the middle of a bay, and the run.
local function floor(slab, options)
  local model = hinge.model { elements_per_member = 4, displacement = options.displacement }
  local grid = hinge.grid { model = model, x = { count = 2, spacing = 6 }, y = { count = 1, spacing = 5 },
    z = { count = 1, spacing = 3.5 } }
  grid:fix "all"
  grid:defaults { material = hinge.material.steel "S355" }
  grid:columns { section = hinge.section.named "HEB 300", up = { 1, 0, 0 } }
  for _, along in ipairs { "x", "y" } do
    grid:beams { along = along, section = hinge.section.named "IPE 400", group = "beams" }
  end
  model:gravity { 0, 0, -9.81 }
  model:floor { group = "beams", mass = 400, slab = slab }
  local run = model:static { steps = options.steps }:finish()
  expect(run.verdict == "completed", "%s", run.reason)
  local sag = 0
  for _, z in ipairs(run:read "uz") do sag = support.smallest_of(sag, z) end
  return sag, run
end

for name, slab in pairs(slabs) do
  case("one step of load and ten find the same sag of " .. name, function()
    local once, run = floor(slab, { steps = 1 })
    local often = floor(slab, { steps = 10 })
    checks.near(once, often, 1e-6 * math.abs(often), "sag")
    -- 11 to 17 with a search for the least energy; by halves of steps that make the balance worse some hundred and more
    expect(run.counts.factorisations <= 30, "%d factorisations", run.counts.factorisations)
  end)
end

checks.done()
