-- The scenes whose accuracy and time stand in tests/README.md: each runs as its head says,
-- and has the errors that it says.
--
-- Run: lua5.4 tests/script/cost/cost_scenes_test.lua
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local hinge = require "hinge"
local checks = support.checks "cost_scenes"
local case, expect, near = checks.case, checks.expect, checks.near

-- What of its settings is compared here, what is held, and the error, %, of the named answer
-- that its head states, by setting.
local scenes = {
  static_frame = {
    accuracy = { elements_per_member = { 2, 16 }, formulation = { "asi-gauss", "conventional" } },
    errors = { { "ux", { 2, "asi-gauss" }, 0, 1e-8 }, { "ux", { 16, "conventional" }, 0.351, 1e-3 } },
  },
  static_collapse = {
    accuracy = { elements_per_member = { 2, 16 }, formulation = { "asi-gauss", "asi", "conventional" } },
    parameters = { steps = 50 },
    errors = { { "load", { 2, "asi-gauss" }, 0, 0.01 }, { "limit_load", { 16, "conventional" }, 6.01, 0.01 },
      { "plastic", { 2, "asi" }, 6.1, 0.1 } },
  },
  dynamic_frame = {
    accuracy = { dt = { 5e-5, 2.5e-5 }, elements_per_member = { 2, 8 },
      method = { "asi-gauss", "asi-gauss, cubic", "conventional" } },
    errors = { { "plastic", { 5e-5, 2, "asi-gauss" }, 1.46, 0.1 }, { "ux", { 5e-5, 2, "asi-gauss" }, 0.66, 0.05 },
      { "plastic", { 5e-5, 8, "conventional" }, 23, 0.2 } },
  },
  column_loss = {
    accuracy = { dt = { 4e-3, 8e-3 } }, parameters = { duration = 0.3 },
    errors = { { "drift_mm", { 4e-3 }, 1.41, 0.1 }, { "plastic_kJ", { 4e-3 }, 0.51, 0.1 } },
  },
  earthquake = {
    accuracy = { dt = { 10e-3, 5e-3 } }, parameters = { duration = 3.0 },
    errors = { { "drift_mm", { 10e-3 }, 0.81, 0.1 }, { "plastic_kJ", { 10e-3 }, 7.6, 0.3 } },
  },
  two_beam_impact = {
    accuracy = { beta = { 0.25, 0.4 }, dt = { 2.5e-6, 5e-6 } },
    errors = { { "kinetic", { 0.25, 2.5e-6 }, 0.60, 0.02 }, { "kinetic", { 0.4, 2.5e-6 }, 1.21, 0.02 } },
  },
  ten_storey_impact = {
    accuracy = { dt = { 2e-5, 4e-5 }, scheme = { "newmark", "explicit" } }, parameters = { after = 3.2e-3 },
    errors = { { "before.plastic", { 4e-5, "newmark" }, 0.9, 0.6 }, { "before.plastic", { 4e-5, "explicit" }, 23, 1 } },
  },
}

case("the scenes of scripts/cost compare the settings and have the errors that they state", function()
  local page, seen = support.read(support.root .. "tests/README.md"), 0
  for path in support.output(("cd %s && ls scripts/cost/*.lua"):format(support.quote(support.root))):gmatch "[^\n]+" do
    local name, head = path:match "([^/]+)%.lua$", support.read(support.root .. path):match "^(.-)\nlocal "
    local scene = scenes[name]
    seen = seen + 1
    if expect(scene, "%s is not known here", path) then
      expect(head:find("hinge cost " .. path, 1, true), "%s: the head does not say how to run it", path)
      expect(page:find("](../" .. path .. ")", 1, true), "tests/README.md does not show %s", path)
      -- the whole impact has a picture of its own: scripts/accuracy_of_case1.lua
      expect(name == "ten_storey_impact" or page:find("](../scripts/pictures/cost_" .. name .. ".png)", 1, true),
        "tests/README.md does not show the plot of %s", path)
      local r = hinge.cost(dofile(support.root .. path), { accuracy = scene.accuracy, parameters = scene.parameters,
        repeats = 1, within = 0.05 })
      expect(#r.failed == 0 and r.references, "%s: settings without an answer", path)
      for _, wanted in ipairs(scene.errors) do
        for _, s in ipairs(r.settings) do
          local same = true
          for i, input in ipairs(r.inputs) do same = same and s.values[input.name] == wanted[2][i] end
          if same then
            near(100 * (s.errors[wanted[1]] or math.huge), wanted[3], wanted[4], ("%s: error of %s, %%, %s")
              :format(name, wanted[1], s.label))
          end
        end
      end
    end
  end
  checks.equal(seen, 7, "scenes")
end)

checks.done()
