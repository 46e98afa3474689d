-- model:remove: a member or a group leaves the structure at a time, beside fracture rules, with the energy balance of a
-- break; as an event, after a resume and over a chain of runs; statics keeps it.
--
-- Run: lua5.4 tests/script/effects/removal_test.lua BUILD_FOLDER
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local hinge = require "hinge"
local support = require "support"
local checks = support.checks "removal"
local case, expect, equal, near = checks.case, checks.expect, checks.equal, checks.near

local steel = hinge.material { E = 210e9, density = 7850, yield_stress = 235e6 }
local elastic = hinge.material { E = 210e9, density = 7850 }
local bar = hinge.section.solid { width = 0.05, depth = 0.05 }

-- A mass on a bar that hangs from a support, and hangs on a second bar beside it.
local function hanging(options)
  local model = hinge.model(options)
  local top, side = model:node { 0, 0, 2 }, model:node { 2, 0, 0 }
  local mass = model:node { 0, 0, 0 }
  model:fix(top, "all")
  model:fix(side, "all")
  local rope = model:member { top, mass, section = bar, material = elastic, group = "ropes" }
  local arm = model:member { side, mass, section = bar, material = elastic, group = "arms" }
  model:mass { node = mass, mass = 100 }
  model:gravity { 0, 0, -9.81 }
  return model, rope, arm, mass
end

case("removing a member keeps the time, releases its energy and leaves the rest", function()
  local model, rope, arm, mass = hanging()
  model:remove { member = rope, at = 0.005 }
  local rest = model:static { steps = 1 }:finish()
  equal(rope:state(rest), "elastic", "statics keeps it")
  local run = model:dynamic { from = rest, dt = 1e-4, duration = 0.02 }
  local broke
  for step in run:steps() do
    if not broke and rope:state(run) == "broken" then broke = step.time end
  end
  near(broke, 0.005, 1e-9, "when it goes")
  local state, _, time = rope:state(run)
  equal(state, "broken", "its state")
  near(time, 0.005, 1e-9, "its state has the time")
  equal(arm:state(run), "elastic", "the other one")
  equal(run:count { state = "broken" }, 1, "broken members")
  local _, _, uz = run:displacement(mass)
  local _, _, uz_rest = rest:displacement(mass)
  expect(uz < uz_rest - 1e-4, "it falls: %g m after %g m", uz, uz_rest)
  expect(run.energy.fracture > 0, "energy of the break: %g J", run.energy.fracture)
  expect(math.abs(run.energy_error) < 1e-3, "energy error %g", run.energy_error)
  local found
  for _, effect in ipairs(run.effects) do
    if effect.name == "removal" then found = effect end
  end
  expect(found and found.active and found.because == "model:remove; 1 member at 0.005 s", "plan: %s",
    found and found.because or "nothing")
  expect(found and found.asked_at:find "removal_test%.lua:%d+$", "plan: asked at %s", found and found.asked_at or "")

  -- the same as a rule that breaks both elements at that time
  local twin, other, _, tip = hanging()
  local ends = {}
  twin:fracture { group = "ropes", where = "all", rule = function(s)
    if s.time < 0.005 - 1e-9 then return false end
    ends[s.element] = ends[s.element] or (s.element == 1 and 2 or 1) -- at its middle
    return s["end"] == ends[s.element]
  end }
  local by_rule = twin:dynamic { from = twin:static { steps = 1 }:finish(), dt = 1e-4, duration = 0.02 }:finish()
  equal(other:state(by_rule), "broken", "by a rule")
  near(select(3, by_rule:displacement(tip)), uz, 1e-12, "falls as by a rule")
  near(by_rule.energy.fracture, run.energy.fracture, 1e-9 * run.energy.fracture, "energy as by a rule")

  -- over a chain of runs: it has gone, and goes no second time
  local on = model:dynamic { from = run, dt = 1e-4, duration = 0.002 }:finish()
  equal(rope:state(on), "broken", "in the next run")
  equal(on:count { state = "broken" }, 1, "in the next run: broken members")
  equal(on.energy.fracture, 0, "in the next run: energy of breaks")

  -- over a checkpoint, taken before and after
  for _, at in ipairs { 30, 70 } do
    local file = support.temporary_folder() .. "/a.checkpoint"
    local first = model:dynamic { from = rest, dt = 1e-4, duration = 0.02 }
    for step in first:steps() do
      if step.index == at then first:checkpoint(file) end
    end
    local second = model:dynamic { from = rest, dt = 1e-4, duration = 0.02 }
    second:resume(file)
    second:finish()
    equal(second.hash, first.hash, "after a resume at step " .. at)
    equal(first.hash, run.hash, "the same run")
  end

  -- a time before the run begins: at the end of its first step
  model:remove { member = arm, at = 0.001 }
  local late = model:dynamic { from = run, dt = 1e-4, duration = 0.002 }
  late:step()
  equal(arm:state(late), "broken", "a time that has gone")
end)

case("a group is removed beside general fracture rules", function()
  for _, order in ipairs { "before", "after" } do
    local model, rope, arm = hanging()
    if order == "before" then model:fracture { axial_strain = 10 } end
    model:remove { group = "ropes", at = 0.001 }
    if order == "after" then model:fracture { axial_strain = 10 } end
    local run = model:dynamic { dt = 1e-4, duration = 0.002 }:finish()
    equal(rope:state(run), "broken", "a rule declared " .. order)
    equal(arm:state(run), "elastic", "a rule declared " .. order .. ": the other one")
  end
  for name, options in pairs { auto = { dt = "auto", duration = 0.01 },
    explicit = { integrator = "explicit", dt = "auto", duration = 0.002 } } do
    local model, rope = hanging()
    model:remove { member = rope, at = options.duration / 2 }
    local run = model:dynamic(options)
    local longest, before, gone = 0, 0, nil
    for step in run:steps() do
      longest, before = support.largest_of(longest, step.time - before), step.time
      gone = gone or rope:state(run) == "broken" and step.time or nil
    end
    equal(run.verdict, "completed", name .. ": verdict")
    local at = options.duration / 2
    expect(gone and gone >= at - 1e-9 and gone <= at + longest, "%s: goes at %s", name, tostring(gone))
  end
end)

case("one element of a member is removed", function()
  for _, elements in ipairs { 1, 4 } do -- of four, those in the middle fall by themselves
    local model = hinge.model { elements_per_member = elements, formulation = elements == 1 and "asi" or nil }
    local a, b = model:node { 0, 0, 0 }, model:node { 1, 0, 0 }
    model:fix(a, "all")
    model:fix(b, "all")
    local beam = model:member { a, b, section = bar, material = steel }
    model:gravity { 0, 0, -9.81 }
    model:remove { member = beam, at = 0 }
    local run = model:dynamic { dt = 1e-4, duration = 0.05 }:finish()
    equal(run.verdict, "completed", elements .. " elements: verdict")
    equal(beam:state(run), "broken", elements .. " elements: state")
    local momentum = run:momentum()
    local free = elements == 4 and bar.area * steel.density / 2 or 0 -- kg, that hang on no support
    near(momentum.linear[3], -free * 9.81 * 0.05, 0.01 * free * 9.81 * 0.05 + 1e-9, elements .. " elements: momentum")
  end
end)

case("wrong removals are refused, and remove nothing", function()
  local model, rope = hanging()
  for _, row in ipairs {
    { "field 'member' is missing; give a member, or group = a group", { at = 1 } },
    { "field 'at' is missing; give a number in s", { member = rope } },
    { "field 'at' is -1 s; must be 0 s or above", { member = rope, at = -1 } },
    { "field 'over' is -1 s; must be 0 s or above", { member = rope, at = 0, over = -1 } },
    { "field 'group' is given beside member; give one of the two", { member = rope, group = "ropes", at = 1 } },
    { { "field 'group'", "'rope' (did you mean 'ropes'?)" }, { group = "rope", at = 1 } },
    { "field 'member' ", { member = 1, at = 1 } },
    { "unknown field 'time'", { member = rope, at = 1, time = 2 } },
  } do
    checks.refused(row[1], function() model:remove(row[2]) end)
  end
  checks.refused("a model with mass = 'cubic' cannot break", function()
    local cubic, first = hanging { mass = "cubic" }
    cubic:remove { member = first, at = 1 }
  end)
  local run = model:dynamic { dt = 1e-4, duration = 0.001 }:finish()
  equal(rope:state(run), "elastic", "what was refused removes nothing")
end)

case("a removal stands in events.csv, the plan and the summary of a program", function()
  local hinge_on, folder = support.scenes(arg[1])
  local status, _, complaint = hinge_on("run -q", [=[
local hinge = require "hinge"
local model = hinge.model()
local a, b, c = model:node { 0, 0, 0 }, model:node { 1, 0, 0 }, model:node { 2, 0, 0 }
model:fix(a, "all")
model:fix(c, "all")
local of = { section = hinge.section.solid { width = 0.05, depth = 0.05 }, material = hinge.material { E = 2e11,
  density = 7850 } }
model:member { a, b, section = of.section, material = of.material, group = "first" }
model:member { b, c, section = of.section, material = of.material }
model:gravity { 0, 0, -9.81 }
model:remove { group = "first", at = 2e-3 }
model:dynamic { dt = 1e-4, duration = 4e-3 }:finish()
]=], "--out one")
  equal(status, 0, "the scene: " .. complaint)
  local events, n = support.read(folder .. "/one/events.csv") or "", 0
  for line in events:gmatch "[^\n]+" do
    local element, limit, rule = line:match '^0%.002,fracture,(%d),1,%d,"first",(%a+),,,"(.*)",$'
    if element then
      n = n + 1
      equal(limit, "removed", "event: limit")
      expect(rule:find "scene%.lua:11$", "event: at %s", rule)
    end
  end
  equal(n, 2, "events of both elements in\n" .. events)
end)

-- A cantilever with a mass at its tip, which stands on a post: both elastic and nearly without mass. `elements` of the
-- post. Returns the model, the tip, the deflection without the post (m), the period, and the post.
local function propped(elements, ends, displacement)
  local model = hinge.model { displacement = displacement }
  local wall, tip, foot = model:node { 0, 0, 0 }, model:node { 2, 0, 0 }, model:node { 2, 0, -1 }
  model:fix { wall, foot }
  local light = hinge.material { E = 210e9, G = 1e4 * 210e9, density = 1 }
  model:member { wall, tip, section = bar, material = light }
  local post = model:member { foot, tip, section = hinge.section.solid { width = 0.02, depth = 0.02 },
    material = light, elements = elements, up = { 1, 0, 0 }, ends = ends }
  model:mass { node = tip, mass = 50 }
  model:gravity { 0, 0, -9.81 }
  local k = 3 * 210e9 * bar.Ix / 2 ^ 3
  return model, tip, 50 * 9.81 / k, 2 * math.pi * math.sqrt(50 / k), post
end

case("over: a load that leaves in a straight line, by the closed form", function()
  local pinned = hinge.joint { Mx = "free", My = "free" }
  for _, of in ipairs { { 0, 2, "small" }, { 0.2, 2, "large" }, { 0.5, 4, "large" }, { 1, 8, "small" },
    { 1.5, 2, "large" } } do
    local part, elements, displacement = table.unpack(of)
    local model, tip, sag, period, post = propped(elements, { b = pinned }, displacement)
    model:remove { member = post, at = 0, over = part * period }
    local rest = model:static():finish()
    local run = model:dynamic { from = rest, dt = period / 400, duration = 1.2 * (1 + part) * period, record = false }
    local deepest = 0
    while run:step() do deepest = support.largest_of(deepest, -select(3, tip:displacement(run))) end
    local x = math.pi * part
    local wanted = 1 + (part == 0 and 1 or math.abs(math.sin(x)) / x) -- of a mass on a spring
    local what = ("over %g periods, %s: "):format(part, displacement)
    -- the post shortens by 0.06 % of the sag, and the beam has a little mass
    near(deepest / sag, wanted, 1.5e-3, what .. "deflection over that of statics")
    near(run.energy_error, 0, 1e-6, what .. "energy error")
    equal(run.verdict, "completed", what .. "run")
  end
end)

case("over: bending of a rigid joint is taken over too, and a checkpoint in the middle", function()
  local function begin()
    local model, tip, _, period, post = propped(2)
    model:load { node = tip, force = { 800, 0, 0 } } -- bends post and beam
    model:remove { member = post, at = 0.25 * period, over = period }
    local rest = model:static { steps = 4 }:finish()
    return model:dynamic { from = rest, dt = period / 400, duration = 1.5 * period }, tip, rest, period, model
  end
  local run, tip, rest, period = begin()
  local still = 0
  while run.time < 0.25 * period do
    run:step()
    still = support.largest_of(still, math.abs(select(3, tip:displacement(run)) - select(3, tip:displacement(rest))))
  end
  run:step() -- the post is gone, and its force is all there
  near(select(3, tip:displacement(run)), select(3, tip:displacement(rest)), 1e-6, "the first step without the post")
  near(still, 0, 1e-8, "at rest before that")
  local folder = support.temporary_folder()
  run:checkpoint(folder .. "/half")
  run:finish()
  near(run.energy_error, 0, 1e-6, "energy error")
  local again = begin()
  again:resume(folder .. "/half")
  again:finish()
  equal(again.energy.work, run.energy.work, "work after a checkpoint")
  equal(again.energy.kinetic, run.energy.kinetic, "kinetic energy after it")
  -- a run that goes on from the middle has the rest of the force
  local part, end_of_it, _, T, model = begin()
  while part.time < 0.7 * T do part:step() end
  part:stop()
  local rest_of_it = model:dynamic { from = part, dt = T / 400, duration = run.time - part.time }:finish()
  local whole = select(3, tip:displacement(run))
  near(select(3, end_of_it:displacement(rest_of_it)), whole, 1e-4 * math.abs(whole), "where a second run ends")
end)

case("over: explicit steps as Newmark's", function()
  local function fall(integrator)
    local model, rope, _, mass = hanging()
    model:remove { member = rope, at = 2e-3, over = 0.01 }
    local rest = model:static { steps = 1 }:finish()
    local run = model:dynamic { from = rest, dt = integrator == "explicit" and "auto" or 2e-5, duration = 0.02,
      integrator = integrator, record = false }:finish()
    near(run.energy_error, 0, 1e-4, integrator .. ": energy error")
    return select(3, mass:displacement(run))
  end
  local implicit, explicit = fall "newmark", fall "explicit"
  near(explicit, implicit, 0.03 * math.abs(implicit), "displacement") -- with lumped masses, and with consistent ones
end)

case("statics goes on from a state without a member of four elements", function()
  for _, elements in ipairs { 2, 4, 8 } do
    local model, tip, sag, period, post = propped(elements)
    model:remove { member = post, at = 0 }
    local gone = model:dynamic { dt = 1e-6 * period, duration = 1e-6 * period, step_control = 0 }:finish()
    local run = model:static { from = gone }:finish()
    equal(run.verdict, "completed", elements .. " elements: " .. run.reason)
    near(-select(3, tip:displacement(run)), sag, 2e-3 * sag, elements .. " elements: deflection")
  end
end)

checks.done()
