-- A dynamic run that goes on from another one of which nothing but the duration has changed is the whole to the bit.
-- Its energies count from its own start. What has changed since is taken up.
--
-- Run: LUA_CPATH="build/?.so" lua5.4 tests/script/run/two_runs_test.lua
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local scenes = require "scenes"
local hinge = require "hinge"
local checks = support.checks "two runs"
local case, expect, equal, near = checks.case, checks.expect, checks.equal, checks.near

local square = hinge.section.solid { width = 0.1, depth = 0.1 }

-- A storey that is thrown sideways, with what a scene asks for; its runs follow each other.
local function storey(scene, settings, durations, between)
  local material = scene.yields and scenes.steel or scenes.elastic
  local joint = scene.joint and { a = hinge.joint { Mx = { stiffness = 2e6 } } } or nil
  local model, nodes = scenes.portal { model = { displacement = scene.displacement },
    column = { section = square, material = material }, beam = { section = square, material = material, ends = joint } }
  local b, c = nodes[2], nodes[3]
  if scene.link then model:rigid_link { from = b, to = c } end
  if scene.damping then model:damping { alpha = 1, beta = 1e-5 } end
  if scene.gravity then model:gravity { 0, 0, -9.81 } end
  if scene.load then
    model:load { node = b, force = { 2e3, 500, 0 }, history = { { 0, 0 }, { 0.02, 1 }, { 0.1, 0 } } }
  end
  for _, node in ipairs { b, c } do model:velocity(node, { scene.speed or 2, 0.2, 0 }) end
  if scene.contact then
    local bar = model:member { model:node { 2, -1, 3.2 }, model:node { 2.1, 1, 3.2 }, section = square,
      material = material }
    model:velocity(bar, { 0, 0, -3 })
    model:contact { rule = "surface", friction = 0.3 }
  end
  local run, first, steps = nil, nil, 0
  for i, duration in ipairs(durations) do
    local o = scenes.with({ from = run, duration = duration, record = false }, settings)
    if i == 2 and between then between(model, b, o) end
    run = model:dynamic(o):finish()
    first, steps = first or run, steps + run.index
  end
  return run, first, steps
end

case("a dynamic run cut in two is the whole to the bit, with energies of its own", function()
  local newmark, explicit = { dt = 2e-4 }, { dt = 5e-6, integrator = "explicit" }
  local conserving = { dt = 2e-4, integrator = "energy-momentum" }
  for name, scene in pairs {
    elastic = {}, ["damped, with its weight"] = { damping = true, gravity = true }, link = { link = true },
    small = { displacement = "small" }, ["a load over time"] = { load = true, rho = true }, joint = { joint = true },
    yields = { yields = true, speed = 6, uncontrolled = true }, contact = { contact = true },
  } do
    for _, settings in ipairs { newmark, explicit, conserving } do
      if settings ~= conserving or not (scene.displacement or scene.contact or scene.link or scene.joint) then
        settings.step_control = settings == newmark and scene.uncontrolled and 0 or nil
        settings.rho_infinity = settings == newmark and scene.rho and 0.9 or nil
        settings.dt = scene.uncontrolled and settings == newmark and 5e-5 or settings == explicit and 5e-6 or 2e-4
        local T = settings == explicit and 0.01 or 0.1
        local whole, _, steps = storey(scene, settings, { T })
        equal(whole.verdict, "completed", name .. ": " .. whole.reason)
        for _, parts in ipairs { { 0.3 * T, 0.7 * T }, { 0.5 * T, 0.1 * T, 0.4 * T } } do
          local what = ("%s, %s, %d parts"):format(name, settings.integrator or "newmark", #parts)
          local run, first, together = storey(scene, settings, parts)
          equal(run.verdict, "completed", what .. ": " .. run.reason)
          equal(run.hash, whole.hash, what .. ": the state")
          equal(together, steps, what .. ": steps")
          near(run.energy_error, 0, settings == explicit and 2e-3 or 5e-3, what .. ": energy error")
          local e = first.energy
          if #parts == 2 then
            local left = e.kinetic + e.elastic + (e.contact_stored or 0) + (e.joint_stored or 0)
            near(run.energy.initial / left, 1, 1e-9, what .. ": it begins with what the first part has left")
            local of_both = (e.gravity or 0) + (run.energy.gravity or 0)
            near(of_both, whole.energy.gravity or 0, 1e-9 * e.initial, what .. ": gravity, part by part")
          end
        end
      end
    end
  end
end)

case("a dynamic run that goes on with something changed takes it up", function()
  for what, between in pairs {
    ["a load"] = function(model, node) model:load { node = node, force = { 5e4, 0, 0 } } end,
    ["a velocity"] = function(model, node) model:velocity(node, { -3, 0, 0 }) end,
    ["gravity"] = function(model) model:gravity { 0, 0, -9.81 } end,
    ["dt"] = function(_, _, o) o.dt = 1e-4 end,
    ["damping"] = function(model) model:damping { alpha = 20 } end,
    ["beta"] = function(_, _, o) o.rho_infinity = 0.5 end,
  } do
    local whole = storey({}, { dt = 2e-4 }, { 0.1 })
    local run = storey({}, { dt = 2e-4 }, { 0.05, 0.05 }, between)
    equal(run.verdict, "completed", what .. ": " .. run.reason)
    expect(run.hash ~= whole.hash, "%s makes no difference", what)
    near(run.energy_error, 0, 1e-3, what .. ": energy error")
  end
end)

checks.done()
