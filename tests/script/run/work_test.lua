-- How much a run computes: elements swept and built, pairs looked at, iterations. Counts do not depend on how busy the
-- machine is; seconds do.
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local hinge = require "hinge"
local building = require "hinge.models.ten_storey"
local impact = require "hinge.models.ten_storey_impact"
local checks = support.checks "work"
local case, expect, equal = checks.case, checks.expect, checks.equal

-- A count may grow by a tenth of what was measured: other compilers round otherwise, and an
-- iteration more here and there follows.
local margin = 0.1
local function exactly(n) return { n } end

-- `measured`: every count of the run, as it was when this was written.
local function hold(what, run, measured)
  equal(run.verdict, "completed", what .. ": verdict")
  local counts = run.counts
  for name in pairs(counts) do expect(measured[name], "%s: nothing holds %s; add it to work_test.lua", what, name) end
  for name, usual in pairs(measured) do
    local now = counts[name]
    print(("%s: %s %s"):format(what, name, now))
    if type(usual) == "table" then
      expect(now == usual[1], "%s: %s is %s and must be %d", what, name, now, usual[1])
    else
      expect(now and now <= (1 + margin) * usual,
        "%s: %s grew from %d to %s; if that is meant, change the number in work_test.lua", what, name, usual, now)
    end
  end
end

-- Case I of the ten-storey impact from its rest: half a metre of flight, the first contact after 2 ms, hinges.
local model = hinge.model {}
local _, plane = impact.add(model, impact.parameters { design = "heavy" })
case("Case I from its rest costs as many operations as stored", function()
  local loaded = model:static { fixed_group = plane, record = false }:finish()
  local steps = 500
  local run = model:dynamic { from = loaded, dt = 1e-5, duration = steps * 1e-5, beta = 0.4, record = false }:finish()
  equal(run.index, steps, "Case I: steps")
  expect(run.contacts.bound > 0 and run:count { state = "yielded" } > 0,
    "Case I: no contact or no hinge within these steps")
  hold("Case I", run, {
    element_updates = 602536, -- 398 of the aircraft until it reaches the frame, then all 1698
    element_builds = 3009, pair_tests = 2088, rejected_steps = exactly(0), pair_lists = 8, cg_iterations = 2013,
    solves = exactly(steps), factorisations = exactly(0), substeps = exactly(steps),
  })
end)

-- An elastic frame of some 1000 elements that moves: one sweep a step and one for the acceleration at the start.
local elastic = require "scenes".elastic
case("an elastic frame that moves costs as many operations as stored", function()
  model = hinge.model {}
  building.add(model, { design = "heavy", bays = { 4, 4 }, storeys = 8, material = elastic })
  model:velocity("building", { 1, 0, 0 })
  local elements = model:counts().elements
  expect(elements > 1000, "a frame of %d elements", elements)
  local steps = 50
  local run = model:dynamic { dt = 1e-5, duration = steps * 1e-5, record = false }:finish()
  hold("elastic frame", run, {
    element_updates = exactly(elements * (steps + 1)), element_builds = exactly(elements), pair_tests = exactly(0),
    rejected_steps = exactly(0), pair_lists = exactly(0),
    cg_iterations = 150, solves = exactly(steps), factorisations = exactly(0), substeps = exactly(steps),
  })
end)

case("a linear frame under gravity costs as many operations as stored", function()
  -- built once and factorised once, however many load steps there are
  model = hinge.model { displacement = "small" }
  building.add(model, { design = "heavy", material = elastic })
  model:gravity { 0, 0, -9.80665 }
  local elements = model:counts().elements
  local run = model:static { steps = 10, record = false }:finish()
  hold("linear statics", run, {
    element_updates = exactly(elements * 21), -- two a load step and one where it begins
    element_builds = exactly(elements), pair_tests = exactly(0), rejected_steps = exactly(0), pair_lists = exactly(0),
    cg_iterations = exactly(0), solves = exactly(20), factorisations = exactly(1), substeps = exactly(10),
  })
end)

case("a frame at rest is assembled once", function()
  -- it is swept once, to see that it is in balance; then only the bar that flies by
  model = hinge.model {}
  building.add(model, { design = "heavy", bays = { 1, 1 }, storeys = 2, material = elastic })
  model:gravity { 0, 0, -9.80665 }
  model:member { model:node { -5, 0, 20 }, model:node { -5, 2, 20 },
    section = hinge.section.solid { width = 0.1, depth = 0.1 }, material = elastic, group = "bar" }
  model:velocity("bar", { 0, 10, 0 })
  model:contact {}
  local loaded = model:static { fixed_group = "bar", record = false }:finish()
  local elements, flying, steps = model:counts().elements, 2, 100
  for _, integrator in ipairs { "newmark", "explicit" } do
    for rest, updates in pairs { [true] = elements + flying * steps, [false] = elements * (steps + 1) } do
      local run = model:dynamic { from = loaded, dt = 1e-5, duration = steps * 1e-5, integrator = integrator,
        rest = rest, record = false }:finish()
      equal(run.index, steps, integrator .. ": steps")
      equal(run.counts.element_updates, updates, ("%s, rest = %s: updates of %d elements, %d of which fly"):format(
        integrator, rest, elements, flying))
    end
  end
end)

checks.done()
