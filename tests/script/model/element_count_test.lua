-- elements = "auto": which members get how many elements, and why; critical loads of columns that got them; the same
-- bits as with the same numbers given.
--
-- Run: lua5.4 tests/script/model/element_count_test.lua BUILD_FOLDER
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local hinge = require "hinge"
local checks = support.checks "element_count"
local runs = require "runs"(checks)
local case, expect, equal, near = checks.case, checks.expect, checks.equal, checks.near
local pi = math.pi

-- A bar of 0.1 m by 0.1 m, 10 m long: Euler's load 164 kN, N0 2450 kN, plastic moment 61 kN m.
local E, L, b, yield_stress = 2e11, 10.0, 0.1, 245e6
local P_E, M_p = pi ^ 2 * E * b ^ 4 / 12 / L ^ 2, yield_stress * b ^ 3 / 4
local elastic = hinge.material { E = E, density = 7850 }
local steel = hinge.material { E = E, density = 7850, yield_stress = yield_stress }
local section = hinge.section.solid { width = b, depth = b }

-- One member from { 0, 0, 0 } to { L, 0, 0 }. `a`, `b`: what is held at its ends.
local function bar(o)
  local model = hinge.model { elements_per_member = o.elements or "auto", elements_accuracy = o.accuracy,
    p_delta = o.p_delta or "chord", displacement = o.displacement, plasticity = o.plasticity }
  local s = { model = model, a = model:node { 0, 0, 0 }, b = model:node { L, 0, 0 } }
  model:fix(s.a, o.a or "xyz,rx")
  model:fix(s.b, o.b or "yz")
  s.member = model:member { s.a, s.b, section = section, material = o.material or steel, group = "bars" }
  if o.push then model:load { node = s.b, force = { -o.push, 0, 0 } } end
  if o.bend then  -- equal moments at both ends, one curvature
    model:load { node = s.a, moment = { 0, o.bend, 0 } }
    model:load { node = s.b, moment = { 0, -o.bend, 0 } }
  end
  if o.load then o.load.member = s.member model:load(o.load) end
  if o.weight then model:gravity { 0, 0, -o.weight / (7850 * b ^ 2) } end  -- N/m
  return s
end
local function decided(o)
  local s = bar(o)
  s.model:static { steps = 1, record = false }
  return s.member.elements
end

case("with axial force on chords alone the count of elements does not follow it", function()
  -- What "auto" goes by where the axial force acts on chords alone: the critical load of a pinned column of n
   -- elements, over Euler's.
  for n, wanted in pairs { [2] = 2.269, [4] = 1.102, [8] = 1.024, [16] = 1.006 } do
    local s = bar { material = elastic, elements = n, push = 3 * P_E }
    local run = s.model:static { steps = 60, to_limit = true, record = false }:finish()
    expect(run.limit, "%d elements: no limit", n)
    near(3 * run.factor, wanted, 2e-3, n .. " elements: critical load")
  end
end)

case("a pinned column at Euler's load gets the fewest elements that have its critical load", function()
  -- to the accuracy asked for
  for accuracy, wanted in pairs { [0.6] = 2, [0.1] = 4, [0.03] = 8, [0.01] = 16 } do
    local s = bar { material = elastic, push = P_E, accuracy = accuracy }
    equal(s.member.elements, "auto", "before a run")
    s.model:static { record = false }
    equal(s.member.elements, wanted, "accuracy " .. accuracy)
    s.model:load { node = s.b, force = { -2 * P_E, 0, 0 } }
    local run = s.model:static { steps = 60, to_limit = true, record = false }:finish()
    equal(s.member.elements, wanted, "a load that came later")
    local found = 3 * run.factor
    expect(1 - 1 / found <= accuracy, "accuracy %g: critical load %g", accuracy, found)
  end
  equal(decided { material = elastic }, 2, "no load")
  equal(decided { material = elastic, push = 0.017 * P_E }, 2, "hardly compressed")
  equal(decided { material = elastic, push = 0.019 * P_E }, 4, "a little compressed")
  equal(decided { material = elastic, push = -P_E }, 2, "in tension")
  equal(decided { material = elastic, push = P_E, displacement = "small" }, 2, "small displacement")
  equal(decided { material = elastic, push = 50 * P_E }, 16, "16 is the most")
end)

case("with p_delta = member two elements are exact", function()
  -- beyond Euler's load four
  equal(decided { p_delta = "member", material = elastic, push = 0.98 * P_E }, 2, "member, below Euler's load")
  local s = bar { p_delta = "member", material = elastic, push = 5 * P_E, a = "all", b = "yz,rx,ry,rz" }
  local run = s.model:static { steps = 50, to_limit = true, record = false }:finish()
  equal(s.member.elements, 4, "clamped at both ends")
  near(5 * run.factor, 4, 0.01, "clamped at both ends: critical load")
end)

case("members that yield between their ends get elements where it happens", function()
  local function middle(part) return { at = 0.5, force = { 0, 0, -part * 4 * M_p / L } } end
  equal(decided { load = middle(0.97) }, 2, "a load in the middle below the plastic moment")
  equal(decided { load = middle(1.03) }, 4, "a load in the middle beyond it")
  equal(decided { load = middle(1.03), plasticity = false }, 2, "plasticity = false")
  equal(decided { load = middle(1.03), material = elastic }, 2, "no yield stress")
  local clamped = { a = "all", b = "yz,rx,ry,rz" }
  for part, wanted in pairs { [0.97] = 2, [1.03] = 4 } do  -- yields at its ends, where loads count by its nodes
    clamped.load = { q = { 0, 0, -part * 12 * M_p / L ^ 2 } }
    equal(decided(clamped), wanted, "clamped, uniform load, ends at " .. part)
  end
  -- clamped at one end, under its weight: when the clamped end has yielded, the middle follows at 12 M_p / L^2; a
  -- linear solution has it there at 16
  for part, wanted in pairs { [11.8] = 2, [12.3] = 4 } do
    equal(decided { a = "all", weight = part * M_p / L ^ 2 }, wanted, "propped under its weight, " .. part)
  end
  equal(decided { a = "all", b = "yz,ry", bend = 1.2 * M_p }, 2, "moments on clamped ends")
  -- compression adds its part: at half of Euler's load twice the moment
  equal(decided { p_delta = "member", push = 0.5 * P_E, bend = 0.45 * M_p }, 2, "compressed and bent")
  equal(decided { p_delta = "member", push = 0.5 * P_E, bend = 0.55 * M_p }, 4, "compressed and bent more")
  equal(decided { push = -3e6, load = middle(0.01) }, 2, "yields in tension, without a hinge")
end)

-- A frame with a slender column, a beam with a load and a bar that flies, in one order or the other.
local function frame(o)
  local model = hinge.model { elements_per_member = o.auto and "auto" or 2, p_delta = "chord" }
  local n, made = {}, {}
  for i, at in ipairs { { 0, 0, 0 }, { 0, 0, L }, { 5, 0, L }, { 5, 0, 0 }, { 2, 3, 15 }, { 3, 3, 15 } } do
    n[i] = model:node(at)
  end
  model:fix({ n[1], n[4] }, "all")
  local parts = { { 1, 2, "columns", 16 }, { 2, 3, "beams", 4 }, { 3, 4, "columns", 16 }, { 5, 6, "thrown", 2 } }
  local function join(i)
    local p = parts[i]
    made[i] = model:member { n[p[1]], n[p[2]], section = section, material = steel, group = p[3],
      elements = not o.auto and p[4] or nil }
  end
  local function push() model:load { node = n[2], force = { 0, 0, -0.9 * P_E } } end
  local function bend() model:load { member = made[2], at = 0.5, force = { 0, 0, -1.5 * 8 * M_p / 5 } } end
  if o.late then push() for i = 4, 1, -1 do join(i) end bend() model:gravity { 0, 0, -9.81 }
  else model:gravity { 0, 0, -9.81 } for i = 1, 4 do join(i) end bend() push() end
  return model, made, parts
end
local function dynamic(model) return model:dynamic { dt = 2e-4, duration = 0.01, record = false } end

case("counted elements have the bits of the same numbers given", function()
  -- whatever the order; a checkpoint goes from one to the other
  for _, late in ipairs { false, true } do
    local model, made, parts = frame { auto = true, late = late }
    equal(model:counts().elements, 8, "before a run")
    local run = dynamic(model)
    for i, p in ipairs(parts) do equal(made[i].elements, p[4], p[3] .. (late and ", late" or "")) end
    equal(model:counts().elements, 38, "elements")
    runs.completed(run, "the frame")
    equal(run.hash, dynamic((frame { late = late })):finish().hash, "bits")
    equal(run.hash, dynamic((frame { auto = true, late = late })):finish().hash, "bits of a second model")
  end
  local file = support.temporary_folder() .. "/one.checkpoint"
  local run = dynamic((frame { auto = true }))
  for _ = 1, 20 do run:step() end
  run:checkpoint(file)
  local resumed = dynamic((frame {})):resume(file)
  equal(resumed:finish().hash, run:finish().hash, "resumed with the numbers given")
end)

case("what a run has counted stays for the runs after it", function()
  -- one that could not be made decides nothing; later members are decided later
  local s = bar { push = 0.9 * P_E }
  expect(not pcall(s.model.static, s.model, { control = { node = s.b, "uy", to = 1 } }), "a fixed node is driven")
  equal(s.member.elements, "auto", "after a run that could not be made")
  local first = s.model:static { steps = 1, record = false }
  equal(s.member.elements, 16, "the column")
  first:finish()
  runs.completed(s.model:static { from = first, record = false }, "goes on from the first")
  local far = s.model:node { 2 * L, 0, 0 }
  local later = s.model:member { s.b, far, section = section, material = steel, elements = "auto" }
  local given = s.model:member { s.a, far, section = section, material = steel, elements = 6, up = { 0, 1, 0 } }
  equal(later.elements, "auto", "declared later")
  s.model:static { steps = 1, record = false }
  equal(later.elements, 2, "decided later")
  equal(given.elements, 6, "given")
  equal(s.member.elements, 16, "as it was")
end)

case("wrong numbers of elements are refused", function()
  for words, options in pairs {
    ["elements_per_member' is 'automatic'; must be a whole number, 1 or above, or 'auto'"] = {
      elements_per_member = "automatic" },
    ["elements_per_member' is 'auto'; goes by the errors of formulation 'asi-gauss'"] = {
      elements_per_member = "auto", formulation = "asi" },
    ["elements_accuracy' is 1; must be below 1"] = { elements_accuracy = 1 },
    ["elements_accuracy' is 0"] = { elements_accuracy = 0 },
  } do
    checks.refused(words, hinge.model, options)
  end
  local s = bar {}
  checks.refused("'elements' is 'autp'; must be a whole number, 1 or above, or 'auto' (did you mean 'auto'?)",
    s.model.member, s.model, { s.a, s.b, section = section, material = steel, elements = "autp" })
end)

case("hinge plan and summary.json name the counted elements", function()
  local hinge_on, folder = support.scenes(arg[1])
  local text = [[
local hinge = require "hinge"
local steel = hinge.material { E = 2e11, density = 7850, yield_stress = 245e6 }
local bar = hinge.section.solid { width = 0.1, depth = 0.1 }
local model = hinge.model { elements_per_member = "auto", p_delta = "chord" }
local function column(x, push, load)
  local a, b = model:node { x, 0, 0 }, model:node { x, 0, 10 }
  if push then model:fix(a, "xyz,rz") model:fix(b, "xy") end
  local m = model:member { a, b, section = bar, material = steel, group = push and "columns" or "thrown" }
  if push then model:load { node = b, force = { 0, 0, -push * 164493.4 } } end
  if load then model:load { member = m, at = 0.5, force = { load * 24500, 0, 0 } } end
end
column(0, 0.5)
column(1, 0.9)
column(2, 0.001)
column(3, 0.001, 1.1)
column(4)
column(5, 4)
model:dynamic { dt = 1e-3, duration = 2e-3 }:finish()
]]
  local status, printed = hinge_on("plan", text)
  equal(status, 0, "status of the plan")
  local wanted = [[
  elements = "auto", elements_accuracy = 0.01:
    16 in 2 members: compressed by up to 0.9 of Euler's load, member 2 (columns)
    16 in 1 member: compressed by up to 4 of Euler's load, member 6 (columns); 16 is the most that "auto" gives, ]]
    .. [[and elements_accuracy is not reached
    4 in 1 member: moments up to 1.1 times the fully plastic one under loads or between the ends, member 4 (columns)
    2 in 1 member: no yield between the ends, compressed by at most 0.001 of Euler's load
    2 in 1 member: supports do not hold the body, so it has no static solution to decide by
]]
  expect(support.has(printed, wanted), "the plan:\n%s", printed)
  expect(printed:find("6 members, 56 elements", 1, true), "elements of the plan:\n%s", printed)
  hinge_on("run", text)
  local summary = support.json(support.read(folder .. "/out/scene/summary.json") or "null")
  if expect(summary, "no summary.json") then
    local groups = summary.model.automatic_elements
    equal(#groups, 5, "groups of summary.json")
    equal(groups[1].elements, 16, "of the first")
    equal(groups[1].members, 2, "members of the first")
    equal(groups[1].because, "compressed by up to 0.9 of Euler's load, member 2 (columns)", "its reason")
  end
end)

checks.done()
