-- Names of options and fields of version 0.2 still do what they did, beside the names that they have now.
--
-- Run: lua5.4 tests/script/model/former_names_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local hinge = require "hinge"
local checks = support.checks "former names"
local case, expect, equal = checks.case, checks.expect, checks.equal

local steel = hinge.material { E = 206e9, nu = 0.3, density = 7850, yield_stress = 235e6 }
local bar = hinge.section.solid { width = 0.02, depth = 0.02 }

-- A cantilever with a free body beside it, which `hold` or `fixed_group` keeps in its place.
local function scene(options)
  local model = hinge.model(options)
  local a, b = model:node { 0, 0, 0 }, model:node { 1, 0, 0 }
  model:member { a, b, section = bar, material = steel, up = { 0, 0, 1 } }
  model:fix(a)
  model:load { node = b, force = { 0, 0, -100 } }
  local c, d = model:node { 0, 5, 0 }, model:node { 1, 5, 0 }
  model:member { c, d, section = bar, material = steel, up = { 0, 0, 1 }, group = "body" }
  return model, b
end

case("hold is fixed_group of a static run", function()
  local hashes = {}
  for i, field in ipairs { "fixed_group", "hold" } do
    hashes[i] = scene():static { [field] = "body" }:finish().hash
  end
  equal(hashes[1], hashes[2], "the states")
  local ok, message = pcall(function() return scene():static { hold = "body", fixed_group = "body" } end)
  expect(not ok and message:find("field 'hold' is the older name of 'fixed_group', and both are given", 1, true),
    "both at once: %s", message)
end)

case("reading is strain_measure of a fracture rule", function()
  local times = {}
  for i, field in ipairs { "strain_measure", "reading" } do
    local model = hinge.model { formulation = "asi", displacement = "small", elements_per_member = 1 }
    local a, b = model:node { 0, 0, 0 }, model:node { 0.5, 0, 0 }
    model:member { a, b, section = bar, material = steel, up = { 0, 0, 1 } }
    model:fix(a)
    model:fix(b)
    model:move { node = b, z = { { 0, 0 }, { 0.05, 0.05 } } }
    model:fracture { curvature_x = 0.05, [field] = "section" }
    local run = model:dynamic { dt = 2e-5, duration = 0.05, record = false }
    for _ in run:steps() do
      if run:count { state = "broken" } > 0 then break end
    end
    times[i] = run.time
    expect(run:count { state = "broken" } == 1, "%s: nothing broke", field)
  end
  equal(times[1], times[2], "when it breaks")
end)

case("shift = whole is elastic_and_plastic", function()
  local function hash(shift)
    return scene({ shift = shift, p_delta = "chord" }):static { fixed_group = "body", steps = 2 }:finish().hash
  end
  equal(hash "whole", hash "elastic_and_plastic", "the states")
end)

case("a run has the fields of version 0.2", function()
  local model, tip = scene()
  model:velocity(tip, { 0, 0, 1 })
  local run = model:dynamic { dt = 1e-4, duration = 2e-3 }:finish()
  equal(run.energy.remainder, run.energy.energy_error, "energy.remainder")
  equal(run.worst_remainder, run.worst_energy_error, "worst_remainder")
  expect(run.worst_energy_error > 0, "the worst energy error is %g J", run.worst_energy_error)
  equal(#run.wakings, #run.state_changes, "wakings")
end)

checks.done()
