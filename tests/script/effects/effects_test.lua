-- Effects that a scene does not call for: idle ones change no bit, and constant operators are factorised once.
--
-- Run: lua5.4 tests/script/effects/effects_test.lua
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local scenes = require "scenes"
local checks = support.checks "effects"
local case, expect, equal = checks.case, checks.expect, checks.equal
local hinge = require "hinge"

-- Two frames side by side, one of them flying; `declare(model)` adds what should lie idle.
local function flying(options, declare, run_options)
  local model = hinge.model(options.model)
  local steel = hinge.material { E = 206e9, density = 7850, yield_stress = options.yield }
  local bar = hinge.section.solid { width = 0.05, depth = 0.05 }
  for i, y in ipairs { 0, 2 } do
    local a, b, c = model:node { 0, y, 0 }, model:node { 0, y, 1 }, model:node { 1, y, 1 }
    if i == 1 then model:fix(a) end
    local group = i == 1 and "standing" or "flying"
    model:member { a, b, section = bar, material = steel, group = group }
    model:member { b, c, section = bar, material = steel, group = group }
    if i == 1 then model:load { node = c, force = { 0, 0, -2000 } } end
  end
  model:velocity("flying", { 0, 3, 0 }, { 1, 2, 3 })
  if declare then declare(model) end
  -- short: in long steps scenes that may yield are solved otherwise
  local run = model:dynamic(scenes.with({ dt = 4e-6, duration = 1.2e-3, record = false }, run_options)):finish()
  equal(run.verdict, "completed", "verdict")
  return run
end

case("effects that lie idle change no bit", function()
  local plain = flying {}
  for name, idle in pairs {
    ["contact by surfaces"] = { {}, function(m) m:contact {} end },
    ["contact by surfaces, friction"] = { {}, function(m) m:contact { friction = 0.3 } end },
    ["contact by gaps"] = { {}, function(m) m:contact { rule = "gap" } end },
    ["fracture"] = { {}, function(m) m:fracture { curvature_x = 1e9, axial_strain = 1e9 } end },
    ["fracture by a function"] = { {}, function(m) m:fracture(function() return false end) end },
    ["plasticity"] = { { yield = 1e20 }, function() end },
    ["gravity of nothing"] = { {}, function(m) m:gravity { 0, 0, 0 } end },
  } do
    local run = flying(idle[1], idle[2])
    equal(run.hash, plain.hash, name .. ", idle: the state's hash")
  end
  expect(flying({}, function(m) m:gravity { 0, 0, -9.8 } end).hash ~= plain.hash, "the hash sees what an effect does")
end)

case("a linear scene at a constant step is factorised once", function()
  local linear = flying({ model = { displacement = "small" } }, nil, { solver = "direct" })
  equal(linear.counts.factorisations, 1, "factorisations of an elastic dynamic scene")
  equal(linear.counts.solves, 300, "its solves")
  expect(linear.counts.element_builds <= 8, "element builds: %s for 8 elements", linear.counts.element_builds)

  local model = scenes.cantilever { model = { displacement = "small" }, force = { 0, 0, -1000 } }
  local static = model:static({ steps = 10 }):finish()
  equal(static.verdict, "completed", "verdict of the static scene")
  equal(static.counts and static.counts.factorisations, 1, "factorisations of a linear static scene")
end)

checks.done()
