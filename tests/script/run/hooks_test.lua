-- A script's own functions inside the run: rules of fracture and contact, loads and supports that are functions,
-- callbacks; what they see, that a step whose function fails is taken back, and that equal rules give equal bits.
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local hinge = require "hinge"
local scenes = require "scenes"
local support = require "support"
local checks = support.checks "hooks"
local case, refused = checks.case, checks.refused

local elastic, bar = scenes.elastic, scenes.square
local steel = hinge.material { E = 206e9, nu = 0.3, density = 7850, yield_stress = 245e6 }

-- A bar pulled along its axis until it flows and breaks.
local function pulled(fracture, history)
  local model, tip = scenes.cantilever { member = { material = steel, group = "bars" } }
  model:load { node = tip, force = { 735e3, 0, 0 }, history = history or { { 0, 0 }, { 1e-3, 1 } } }
  model:fracture(fracture)
  collectgarbage() -- the functions live on in the model alone
  return model:dynamic { dt = 1e-5, duration = 4e-3 }
end

case("numbers and a function break a bar at the same step", function()
  local numbers = pulled({ axial_strain = 0.01 }):finish()
  local seen = 0
  local functions = pulled(function(section)
    seen = seen + 1
    assert(section.group == "bars" and section.member == 1 and section.plastic)
    return math.abs(section.axial_strain) >= 0.01
  end, function(t) return t >= 1e-3 and 1 or (1 - t / 1e-3) * 0 + t / 1e-3 * 1 end):finish()
  checks.equal(numbers:count { state = "broken" }, 1, "the bar breaks by numbers")
  checks.expect(seen > 10 and seen < 400, "the function is asked while the bar flows: %d times", seen)
  checks.equal(functions.hash, numbers.hash, "a function against numbers")
  checks.equal(pulled({ axial_strain = 0.01, rule = function() return false end }):finish().hash, numbers.hash,
    "limits beside a rule that never breaks")
end)

case("a rule in Lua breaks the same members of Case I at the same steps as numbers", function()
  local impact = require "hinge.models.ten_storey_impact"
  local abs = math.abs
  local function breaks(s)
    return abs(s.curvature_x) >= 0.4 or abs(s.curvature_y) >= 0.4 or abs(s.axial_strain) >= 0.3
  end
  local function case_one(rule)
    local model = hinge.model()
    local _, plane = impact.add(model, impact.parameters { design = "heavy", dt = 1e-5 })
    if rule then model:fracture(rule) end
    return model:dynamic { from = model:static { fixed_group = plane }:finish(), dt = 1e-5, duration = 0.02,
      beta = 0.4 }:finish()
  end
  local limits = case_one()
  checks.expect(limits:count { state = "broken" } > 5, "members break in Case I")
  checks.equal(case_one { rule = breaks }.hash, limits.hash, "Case I by a function")
end)

-- What a section shows ------------------------------------------------------------------------------------------------

case("rules of two groups see their own sections, every field as the run has it", function()
  local model = hinge.model()
  local a, b, c = model:node { 0, 0, 0 }, model:node { 1, 0, 0 }, model:node { 2, 0, 0 }
  model:fix(a, "all")
  model:member { a, b, section = bar, material = steel, group = "near" }
  model:member { b, c, section = bar, material = steel, group = "far" }
  model:load { node = c, force = { 1e5, 4e3, 4e4 }, moment = { 500, 0, 0 }, history = { { 0, 0 }, { 2e-2, 1 } } }
  local last, asked = {}, { near = 0, far = 0 }
  model:fracture { group = "far", rule = function(s)
    asked.far = asked.far + 1
    assert((s.plastic or s.f_y < 1.001) and s.group == "far") -- strained as never before, or plastic now
  end }
  model:fracture { group = "near", where = "all", keep = { "count", "strain" }, rule = function(s)
    asked.near = asked.near + 1
    s.count = s.count + 1
    local key = s.element * 10 + s["end"]
    if s.step > 1 then
      checks.near(s.axial_strain_rate * s.dt, s.axial_strain - s.strain, 1e-12, "the rate of the axial strain")
      checks.near(s.count, s.step, 0, "a number kept")
    end
    s.strain = s.axial_strain
    last[key] = { N = s.N, Mx = s.Mx, My = s.My, Mz = s.Mz, f_y = s.f_y, work = s.plastic_work,
      curvature = s.curvature_x, rest = s.plastic_curvature_x, time = s.time }
  end }
  local run = model:dynamic { dt = 2e-5, duration = 2e-2 }
  for step in run:steps() do
    if step.index % 250 == 0 then
      local at_a = run:forces(model:members()[1])
      local s = last[11]
      for _, name in ipairs { "N", "Mx", "My", "Mz", "f_y" } do
        checks.near(s[name], at_a[name], 1e-9 * math.abs(at_a[name]) + 1e-9, name .. " at the wall")
      end
      checks.near(s.time, step.time, 1e-12, "time")
      checks.near(last[11].work + last[21].work, run:read "plastic_work"[1], 1e-9, "plastic work of the member")
    end
  end
  checks.equal(asked.near, 4 * 1000, "where = 'all' asks every section at every step")
  checks.expect(run:count { state = "yielded", group = "near" } == 1 and math.abs(last[11].rest) > 1e-3,
    "the bar at the wall has flowed")
  checks.expect(asked.far > 0 and asked.far < 1000, "a rule is asked where something flows: %d times", asked.far)
end)

case("fields of a section can be read at any time, and neither set nor misspelt", function()
  local kept, strain
  local function says(rule, wanted)
    local run = pulled { rule = rule, keep = { "damage" } }
    refused(wanted, run.finish, run)
    return select(2, pcall(run.finish, run)) -- the same again, with its place
  end
  pulled(function(s)
    checks.equal(tostring(s), ("end %d of element %d, member 1"):format(s["end"], s.element), "a section as text")
    if s.step % 7 == 0 then checks.near(s.N / 612.5e3, 1, 0.05, "read at some steps only") end
    if kept then checks.expect(rawequal(kept, s), "the same object at every call") end
    kept, strain = s, s.axial_strain
  end):finish()
  checks.expect(strain > 0, "it is strained by %g", strain)
  refused("read after its rule has returned", function() return kept.axial_strain end)
  checks.equal(tostring(kept), "section of a rule that has returned", "a section as text, too late")
  says(function(s) s.axial_strain = 0 end, "field 'axial_strain' cannot be set")
  says(function(s) s.damage = 0 / 0 end, "must be finite numbers")
  says(function(s) return s.axial_strian end, "has no field 'axial_strian' (did you mean 'axial_strain'?)")
  says(function(s) return s.N end, "it must return true where the section breaks, false or nil where it holds")
  local place = says(function(s) if s.element == 2 then error "no good" end end, "no good")
  for _, part in ipairs { "hooks_test.lua:%d+: no good", "fracture rule of .*hooks_test.lua:%d+", "element 2",
    "end [12]", "at step %d+, t = ", "the step was taken back" } do
    checks.expect(place:find(part), "an error in a rule says %s: %s", part, place)
  end
end)

case("a rule that steps another run sees its own sections alone", function()
  local inner
  local model, tip = scenes.cantilever { member = { material = steel } }
  model:load { node = tip, force = { 735e3, 0, 0 }, history = { { 0, 0 }, { 1e-3, 1 } } }
  local depth, nested = 0, 0
  model:fracture(function(s)
    local step, strain = s.step, s.axial_strain
    depth = depth + 1
    if depth == 1 and step == 150 then
      inner = inner or model:dynamic { dt = 1e-5, duration = 1e-3 }
      inner:finish()
      checks.expect(s.step == step and s.axial_strain == strain, "a section after another run of its rule")
    elseif depth == 2 then
      nested = nested + 1
    end
    depth = depth - 1
  end)
  model:dynamic { dt = 1e-5, duration = 2e-3 }:finish()
  checks.expect(nested > 0, "the run inside asks its rule: %d times", nested)
end)

-- A section that breaks leaves out its twin alone.
case("two rules along a frame are asked in the order of its elements", function()
  local order = {}
  local model = hinge.model()
  for i = 1, 3 do
    local foot, tip = model:node { 0, i, 0 }, model:node { 1, i, 0 }
    model:fix(foot, "all")
    model:member { foot, tip, section = bar, material = steel, group = i == 2 and "even" or "odd" }
  end
  local function note(s)
    order[#order + 1] = s.element .. "." .. s["end"]
    return s.element == 3
  end
  model:fracture { group = "odd", where = "all", rule = note }
  model:fracture { group = "even", where = "all", rule = note }
  local run = model:dynamic { dt = 1e-5, duration = 1e-5 }:finish()
  local elements, twice = {}, {}
  for _, name in ipairs(order) do
    local element = name:match "%d+"
    if elements[#elements] == element then twice[element] = true else elements[#elements + 1] = element end
  end
  checks.equal(table.concat(elements, " "), "1 2 3 4 5 6", "the order")
  checks.expect(twice["1"] and twice["2"] and not twice["3"] and twice["4"] and twice["6"], "the twins: %s",
    table.concat(order, " "))
  checks.equal(run:count { group = "even", state = "broken" }, 1, "what broke")
end)

-- Contact -------------------------------------------------------------------------------------------------------------

-- Two bars fly at a third from both sides.
local function impact(declare, dt)
  local model = hinge.model()
  local function beam(group, y, v)
    local a, b = model:node { -0.5, y, 0 }, model:node { 0.5, y, 0 }
    local member = model:member { a, b, section = bar, material = elastic, group = group }
    if v then model:velocity(member, { 0, v, 0 }) end
    return member
  end
  local members = { beam("left", -0.2, 20), beam("middle", 0), beam("right", 0.2, -20) }
  local events = {}
  declare(model, members, function(event) events[#events + 1] = event end)
  local run = model:dynamic { dt = dt or 5e-6, duration = 0.02, beta = 0.4 }
  run:finish()
  return run, events, members
end
case("on_contact sees each touch with its members and time", function()
  local _, both = impact(function(m, _, note) m:contact { on_contact = note } end)
  local touched = {}
  for _, e in ipairs(both) do touched[e.a.group .. "-" .. e.b.group] = e.time end
  checks.expect(touched["left-middle"] and touched["middle-right"], "both sides touch")
  checks.expect(touched["left-middle"] > 0.15 / 20 - 1e-4 and touched["left-middle"] < 0.15 / 20 + 1e-4, "when: %s s",
    touched["left-middle"])
  local one, events = impact(function(m, _, note)
    m:contact { between = { "left", "middle" }, on_contact = note, on_release = note }
  end)
  checks.expect(#events >= 2 and one:count { group = "right", state = "touched" } == 0,
    "between two groups alone; the right one flies through")
end)

case("pairs is asked once a pair of members and can leave it out", function()
  local asked = 0
  local none = impact(function(m, members) m:contact { pairs = function(a, b)
    asked = asked + 1
    return not (a == members[1] or b == members[1])
  end } end)
  checks.expect(none:count { group = "left", state = "touched" } == 0
    and none:count { group = "right", state = "touched" } == 1, "pairs decides who touches")
  checks.expect(asked >= 2 and asked <= 3, "asked once a pair of members: %d", asked)
end)

case("a stiffness that pairs returns acts as that of the rule", function()
  local soft = impact(function(m) m:contact { pairs = function() return { stiffness = 1e6 } end } end)
  local softer = impact(function(m) m:contact { stiffness = 1e6 } end)
  checks.equal(soft.hash, softer.hash, "a pair's own stiffness against the rule's")
end)

case("pairs of different stiffness keep energy and momentum", function()
  local mixed = impact(function(m)
    m:contact {}
    m:contact { between = { "left", "middle" }, rule = "gap" }
  end, 1e-6)
  checks.expect(math.abs(mixed.energy.energy_error) < 2e-3 * mixed.energy.initial,
    "gaps on one side, surfaces on the other: energy error %g of %g J", mixed.energy.energy_error, mixed.energy.initial)
  checks.expect(mixed:count { state = "touched" } == 3, "all three touch")
  local momentum = mixed:momentum().linear
  checks.expect(math.abs(momentum[2]) < 1e-8 * 20 * mixed:momentum().mass, "momentum: %g", momentum[2])
end)

-- Loads and supports --------------------------------------------------------------------------------------------------

case("a load that a function returns acts as a spring, with its work", function()
  local model = hinge.model()
  local a, b = model:node { 0, 0, 0 }, model:node { 0.5, 0, 0 }
  model:member { a, b, section = bar, material = elastic }
  local mass, k = 7850 * 0.05 ^ 2 * 0.5, 4e4
  for _, node in ipairs { a, b } do
    model:fix(node, "y,z,rx,ry,rz")
    model:load { node = node, force = function(_, run) return -k / 2 * (select(1, run:displacement(node))), 0, 0 end }
    model:velocity(node, { 1, 0, 0 })
  end
  local T = 2 * math.pi * math.sqrt(mass / k)
  local run = model:dynamic { dt = T / 4000, duration = T }
  run:finish()
  checks.near(run:displacement(a), 0, 0.01 * T / (2 * math.pi), "back after a period")
  checks.near(run:velocity(a), 1, 0.01, "as fast as at the start")
  checks.expect(math.abs(run.energy.energy_error) < 1e-5 * run.energy.kinetic, "its work is counted: %g",
    run.energy.energy_error)
end)

-- Callbacks -----------------------------------------------------------------------------------------------------------

case("a function of on_step can stop the run", function()
  local run, calls = pulled { axial_strain = 0.01 }, 0
  run:on_step(function(r)
    calls = calls + 1
    if r.index == 7 then r:stop() end
  end):finish()
  checks.equal(calls, 7, "calls until it was stopped")
  checks.equal(run.verdict, "stopped", "its verdict")
end)

-- Steps that are taken back -------------------------------------------------------------------------------------------

-- Each hook fails once, in the middle of things; the run goes on as if it had not.
local failing = {
  ["an error"] = { function() error "no good" end, "no good" },
  ["a yield"] = { function() coroutine.yield() end, "attempt to yield" },
  ["a change of the model"] = { function(model) model:node { 9, 9, 9 } end,
    "the model cannot be changed while a run of it is inside a step" },
  ["a step of the run"] = { function(_, run) run:step() end, "called from a function of this very run" },
}
local function scene(when, fail)
  local model, b = scenes.cantilever { member = { material = steel, group = "bars" } }
  local run, calls, armed = nil, 0, true
  local function once()
    calls = calls + 1
    if armed and calls == when then
      armed = false
      fail(model, run)
    end
  end
  local c, d = model:node { 0.7, -0.4, 0.3 }, model:node { 0.7, 0.4, 0.3 }
  model:velocity(model:member { c, d, section = bar, material = steel, group = "bullet" }, { 0, 0, -80 })
  return model, once, function()
    run = model:dynamic { dt = 1e-5, duration = 8e-3, beta = 0.4 }
    return run
  end, b
end

-- An error between the first two questions changes no bit.
case("a load that is a function acts from where the run begins", function()
  local function from_start(fails)
    local model, b = scenes.cantilever { foot = false }
    local times = {}
    model:load { node = b, force = function(t, run)
      times[#times + 1] = t
      checks.near(run.time, math.max(0, t - 1e-5), 1e-15, "the run that it sees at " .. t)
      if fails and #times == 2 then error "once" end
      return { 500, 0, 0 }
    end }
    return model:dynamic { dt = 1e-5, duration = 2e-5, record = false }, times
  end
  local run, times = from_start(false)
  run:finish()
  checks.equal(table.concat(times, " "), "0.0 1e-05 2e-05", "when it is asked")
  checks.near(run:momentum().linear[1], 500 * 2e-5, 1e-10, "momentum of a load from the start")
  local again, more = from_start(true)
  refused("once", again.finish, again)
  again:finish()
  checks.equal(table.concat(more, " "), "0.0 1e-05 1e-05 2e-05", "when it is asked again")
  checks.equal(again.hash, run.hash, "state after an error in the first step")
end)

local hooks = {
  fracture = function(model, once)
    model:fracture { rule = function(s) once() return math.abs(s.curvature_x) > 0.3 end, keep = { "n" } }
    model:contact {}
  end,
  on_contact = function(model, once) model:contact { on_contact = once } end,
  pairs = function(model, once) model:contact { pairs = function() once() end } end,
  load = function(model, once, tip)
    model:contact {}
    model:load { node = tip, force = function() once() return 0, 0, 10 end }
  end,
  history = function(model, once, tip)
    model:contact {}
    model:load { node = tip, force = { 0, 0, 10 }, history = function() once() return 1 end }
  end,
}
for name, declare in pairs(hooks) do
  case("a step that fails in a hook is taken back: " .. name, function()
    local steady_model, nothing, steady_run, steady_tip = scene(0)
    declare(steady_model, nothing, steady_tip)
    local steady = steady_run():finish()
    for what, row in pairs(failing) do
      local model, once, make, tip = scene((name == "on_contact" or name == "pairs") and 1 or 20, row[1])
      declare(model, once, tip)
      local run = make()
      refused({ row[2], "the step was taken back" }, run.finish, run)
      checks.equal(run.verdict, "running", what .. " in " .. name .. ": the run can go on")
      run:finish()
      checks.equal(run.verdict, "completed", what .. " in " .. name .. ": it did")
      local energy, expected = run.energy, steady.energy
      for _, part in ipairs { "kinetic", "elastic", "plastic", "fracture", "contact", "work" } do
        checks.near(energy[part], expected[part], 1e-6 * expected.initial,
          ("%s in %s: %s energy at the end"):format(what, name, part))
      end
      checks.expect(pcall(model.node, model, { 5, 5, 5 }), "the model is open again")
    end
  end)
end

checks.done()
