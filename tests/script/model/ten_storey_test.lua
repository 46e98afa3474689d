-- The ten-storey frame with slabs: the same mass and weight as without, and an aircraft that strikes them.
--
-- Run: LUA_CPATH="build/?.so" lua5.4 tests/script/model/ten_storey_test.lua
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local hinge = require "hinge"
local support = require "support"
local building = require "hinge.models.ten_storey"
local impact = require "hinge.models.ten_storey_impact"

local checks = support.checks "ten storeys"
local case, equal, near, refused = checks.case, checks.equal, checks.near, checks.refused
local g = 9.80665

-- At rest: the reactions of the feet, N, line by line, and their sum.
local function weight(options, elements)
  local model = hinge.model { elements_per_member = elements }
  local frame = building.add(model, options)
  model:gravity { 0, 0, -g }
  local run = model:static { steps = 1 }:finish()
  local feet, sum = {}, 0
  for i = 0, options.bays[1] do
    for j = 0, options.bays[2] do
      local _, _, fz = frame.node(i, j, 0):reaction(run)
      feet[i .. j], sum = fz, sum + fz
    end
  end
  return frame, sum, feet
end

case("slabs weigh what the beams weighed for them, in both designs", function()
  for _, design in ipairs { "light", "heavy" } do
    for _, elements in ipairs { 2, 4 } do
      local size = { design = design, bays = { 2, 1 }, storeys = 2 }
      local bare, without = weight(size, elements)
      if elements == 2 then -- with four the loaded beams are seen to buckle sideways: no floor holds them
        size.floor = "weight"
        local _, by_area = weight(size, elements)
        near(by_area, without, 1e-9 * without, "reactions with the weight by area")
      end
      size.floor = "slab"
      local frame, with, feet = weight(size, elements)
      equal(frame.mass, bare.mass, "mass")
      near(frame.floor.mass, frame.floor_mass, 1e-9 * frame.mass, "mass of the floors")
      equal(frame.beam_density, 7850, "density of the beams")
      equal(#frame.floor.slab, 2 * 2 * elements ^ 2, "panels")
      near(without, g * frame.mass, 1e-9 * without, "reactions without")
      near(with, g * frame.mass, 1e-6 * with, "reactions with")
      for place, like in pairs { ["01"] = "00", ["20"] = "00", ["21"] = "00", ["11"] = "10" } do
        near(feet[place], feet[like], 0.05 * feet[like], "reaction of foot " .. place)
      end
      -- by area twice a corner's, and more where the floor goes on over the middle; of beams all alike 1.6 times
      local part = feet["10"] / feet["00"]
      checks.expect(part > 2 and part < 2.5, "the middle carries %g times a corner", part)
    end
  end
end)

case("an aircraft strikes slabs, and the balances close", function()
  local model = hinge.model { p_delta = "chord", weight = "nodes" }
  local frame, plane = impact.add(model, { floor = "slab", height = 3.9, building = { bays = { 2, 2 }, storeys = 2 } })
  local rest = model:static { steps = 1, fixed_group = plane }:finish()
  local run = model:dynamic { from = rest, integrator = "explicit", dt = 1e-5, duration = 0.03,
    record = false }:finish()
  local e = run.energy
  equal(run.verdict, "completed", "verdict")
  near(run.energy_error, 0, 1e-3, "energy error")
  near(e.panel_stored + e.panel_dissipated, e.panels, 1e-9 * e.panels, "panels")
  local left = run:momentum(plane).linear[1] / (plane.mass * 440 / 3.6)
  checks.expect(left < 0.97, "%g of the momentum is left", left)
  checks.expect(e.panel_contact_lost > 1e4, "%.3g J are lost where slabs are struck", e.panel_contact_lost)
  checks.expect(e.panel_dissipated > 1e4, "%.3g J are dissipated in slabs", e.panel_dissipated)
  equal(impact.damage(run, frame).torn_panels, 0, "torn panels")
end)

case("what does not fit is refused", function()
  refused({ "ten_storey.add", "field 'slab' is given without floor = \"slab\"" }, building.add, hinge.model(),
    { slab = {} })
  refused({ "field 'floor' is 'slabs'", "none, weight, slab" }, building.add, hinge.model(), { floor = "slabs" })
end)

checks.done()
