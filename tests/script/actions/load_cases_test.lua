-- Load cases and combinations: what a run takes of them, what it holds of the run before, gravity and functions in
-- them, and what is refused.
--
-- Run: lua5.4 tests/script/actions/load_cases_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local hinge = require "hinge"
local support = require "support"
local scenes = require "scenes"
local checks = support.checks "load cases"
local case, expect, equal, near = checks.case, checks.expect, checks.equal, checks.near

local steel, bar = scenes.elastic, scenes.square
local L, P = 2, 1000
local drop = P * L ^ 3 / (3 * steel.E * bar.Ix) + P * L / (steel.G * bar.shear_area_y) -- m, of the tip under P

local function cantilever(size)
  local model, tip, member, foot = scenes.cantilever { length = L, model = { displacement = size or "small" } }
  return model, foot, tip, member
end
local function sag(run, tip) return -select(3, run:displacement(tip)) end

local function loaded(size)
  local model, foot, tip, member = cantilever(size)
  local dead, live, blast = model:case "dead", model:case "live", model:case "blast"
  model:load { node = tip, force = { 0, 0, -P }, case = dead }
  live:load { member = member, q = { 0, 0, -P / L } }
  model:load { node = tip, force = { 0, P, 0 }, case = "blast", history = { { 0, 1 }, { 5e-3, 0 } } }
  model:combination("uls", { dead = 1.35, live = 1.5 })
  model:combination("all", { uls = 1, blast = 2, dead = 0.65 })
  return { model = model, foot = foot, tip = tip, member = member, dead = dead, live = live, blast = blast }
end
-- The reactions at the foot tell what acts.
local function carried(s, run)
  local _, y, z = run:reaction(s.foot)
  return z, -y
end
case("statics takes the load cases and combinations that it names", function()
  for _, size in ipairs { "small", "large" } do
    for what, row in pairs {
      ["a table"] = { { dead = 1, live = 0.3 }, 1.3, 0 }, ["a combination"] = { "uls", 2.85, 0 },
      ["combinations in one"] = { "all", 2 + 1.5, 2 }, ["a row"] = { "live", 1, 0 },
      ["a combination and a row"] = { { uls = 2, dead = 0.3 }, 6, 0 }, ["none"] = { {}, 0, 0 },
      ["negative"] = { { dead = -1, live = 0.5 }, -0.5, 0 }, ["handles"] = { "handles", 3, 0 },
    } do
      local s = loaded(size)
      local loads = row[1] == "handles" and { [s.dead] = 2, [s.live] = 1 } or row[1]
      local run = s.model:static { steps = 2, loads = loads }:finish()
      local z, y = carried(s, run)
      near(z, row[2] * P, 1e-6 * P, size .. ", " .. what .. ": down")
      near(y, row[3] * P, 1e-6 * P, size .. ", " .. what .. ": across")
    end
  end
end)

case("statics from another run holds its loads while others come on", function()
  for _, size in ipairs { "small", "large" } do
    local s = loaded(size)
    local first = s.model:static { steps = 1, loads = { dead = 1 } }:finish()
    local second = s.model:static { steps = 4, from = first, loads = { live = 1 } }
    local factors = {}
    for _ in second:steps() do
      factors[#factors + 1] = second.factor
      near(carried(s, second), P * (1 + second.factor), 1e-6 * P, size .. ": held while the other comes on")
    end
    equal(#factors, 4, "steps")
    expect(second.loads.dead == 1 and second.loads.live == 1 and second.loads.blast == 0, "run.loads")
    local less = s.model:static { steps = 2, from = second, loads = { dead = 0.5 } }
    less:step()
    near(carried(s, less), P * 1.75, 1e-6 * P, size .. ": half of the difference")
    if size == "small" then
      near(math.abs(s.member:forces(less).Mx), (0.75 + 0.5) * P * L, 1e-6 * P * L, "moment: a load on a member, held")
    end
    less:stop() -- where it is
    local third = s.model:static { steps = 1, from = less, loads = { live = 0 } }:finish()
    near(carried(s, third), P * 0.75, 1e-6 * P, size .. ": on from there")
    local work = first.energy.work + second.energy.work
    local at_once = s.model:static { steps = 1, loads = { dead = 1, live = 1 } }:finish()
    if size == "small" then -- the work of a load that is held is its force times the way
      near(second.energy.energy_error, 0, 1e-9 * work, "energy of the second")
      near(work, second.energy.elastic, 1e-9 * work, "work of both")
      near(sag(second, s.tip), sag(at_once, s.tip), 1e-9 * drop, "the same place")
      near(s.member:forces(second).Mx, s.member:forces(at_once).Mx, 1e-6 * P,
        "moments: a load on a member that is held")
    end
    local pushed = s.model:static { from = first, loads = { blast = 1 }, steps = 3,
      control = { node = s.tip, "uy", to = 0.5 * drop } }:finish()
    equal(pushed.verdict, "completed", size .. ": pushed under what is held: " .. pushed.reason)
    if size == "small" then near(pushed.factor, 0.5, 1e-9, "factor of the push alone") end
    near(carried(s, pushed), P, 1e-6 * P, size .. ": what is held under a push")
  end
end)

case("dynamics from statics stays at rest under the loads that it holds", function()
  for _, size in ipairs { "small", "large" } do
    local s = loaded(size)
    local rest = s.model:static { steps = 2, loads = { dead = 1, live = 0.3 } }:finish()
    for _, integrator in ipairs { "newmark", "explicit" } do
      local still = s.model:dynamic { from = rest, dt = 1e-6, duration = 2e-5, integrator = integrator }:finish()
      near(sag(still, s.tip), sag(rest, s.tip), 1e-9 * drop, size .. ", " .. integrator .. ": it stays at rest")
      expect(still.loads.dead == 1 and still.loads.live == 0.3 and still.loads.blast == 0, "what goes on")
      local hit = s.model:dynamic { from = rest, dt = 1e-6, duration = 2e-5, loads = { dead = 1, blast = 2 },
        integrator = integrator, rest = false }
      expect(hit.loads.live == 0.3 and hit.loads.blast == 2, "held ones go on")
      hit:finish()
      near(sag(hit, s.tip), sag(rest, s.tip), 1e-6 * drop, size .. ", " .. integrator .. ": the held ones are held")
      expect(select(2, hit:displacement(s.tip)) > 1e-8, "%s, %s: the blast acts", size, integrator)
      local without = s.model:dynamic { from = rest, dt = 1e-6, duration = 2e-5, loads = { live = 0, dead = 0 },
        integrator = integrator }:finish()
      expect(sag(without, s.tip) < sag(rest, s.tip) * (1 - 1e-8), "%s, %s: taken away", size, integrator)
    end
  end
end)

case("a load with a history that statics took in full is held in the run after it", function()
  for _, size in ipairs { "small", "large" } do
    local s = loaded(size)
    local stood = s.model:static { steps = 1, loads = { blast = 1 } }:finish()
    local more = s.model:static { steps = 1, from = stood, loads = { dead = 1 } }:finish()
    near(select(2, carried(s, more)), P, 1e-6 * P, size .. ": a load with a history that statics took is held")
  end
end)

case("gravity belongs to one load case, or to none", function()
  for _, last in ipairs { "none", "other" } do
    local model = hinge.model {}
    local dead, other = model:case "dead", model:case "other"
    dead:gravity { 0, 0, -9.8 }
    dead:gravity { 0, 0, -9.81 }
    local words = "gravity belongs to case 'dead' already, not to "
      .. (last == "none" and "no load case" or "case 'other'")
    checks.refused(words, function() (last == "none" and model or other):gravity { 1, 0, 0 } end)
  end
end)

case("gravity and functions scale with their case; what belongs to no case acts in full", function()
  local model, foot, tip = cantilever()
  local weight = steel.density * bar.area * L * 9.8
  local mass = model:case "mass"
  mass:gravity { 0, 0, -9.8 }
  model:case "rule":load { node = tip, force = function() return 0, 100, 0 end }
  model:load { node = tip, force = { 50, 0, 0 } }
  local half = model:static { steps = 1, loads = { mass = 0.5 } }:finish()
  near(select(3, foot:reaction(half)), weight / 2, 1e-6 * weight, "half of gravity")
  near(foot:reaction(half), -50, 1e-6, "a load that belongs to no case")
  local whole = model:static { steps = 2, from = half, loads = "mass" }
  whole:step()
  near(select(3, foot:reaction(whole)), 0.75 * weight, 1e-6 * weight, "gravity that comes on")
  near(foot:reaction(whole), -50, 1e-6, "a load that belongs to no case is held")
  whole:finish()
  near(whole.energy.energy_error, 0, 1e-9 * weight, "gravity that comes on: energy")
  local part, wanted = nil, 0 -- of what belongs to no case, in runs that each go half of the way
  for _ = 1, 4 do
    part = model:static { steps = 2, from = part, loads = "mass" }
    part:step()
    part:stop()
    wanted = wanted + (1 - wanted) / 2
    near(foot:reaction(part), -50 * wanted, 1e-6, "half of the way: a load that belongs to no case")
    near(select(3, foot:reaction(part)), weight * wanted, 1e-6 * weight, "half of the way: gravity")
  end
  local none = model:static { steps = 1, loads = {} }:finish()
  near(select(3, foot:reaction(none)), 0, 1e-9, "no gravity")
  local run = model:dynamic { dt = 1e-6, duration = 1e-6, from = whole, loads = { rule = 2 } }:finish()
  local alone = model:dynamic { dt = 1e-6, duration = 1e-6, from = whole, loads = { rule = 1 } }:finish()
  near(select(2, run:velocity(tip)), 2 * select(2, alone:velocity(tip)), 1e-9, "twice a function")
  expect(select(2, alone:velocity(tip)) > 1e-6, "a function of the state")
  checks.refused({ "model:static: a load on node 2 at {2, 0, 0} m is a function of time and the run",
    "put it into a load case that this run does not take" }, function() model:static { loads = "rule" } end)
end)

case("loads in a case with factor 1 give the bits of loads in no case", function()
  local function hash(in_case)
    local model, _, tip, member = cantilever "large"
    local name = in_case and model:case "all".name or nil
    model:gravity({ 0, 0, -9.8 }, name)
    model:load { node = tip, force = { 0, 300, -P }, moment = { 5, 0, 0 }, case = name }
    model:load { member = member, q = { 0, 0, -P }, case = name }
    model:load { node = tip, force = { 0, 0, 2 * P }, history = { { 0, 0 }, { 1e-4, 1 } }, case = name }
    local rest = model:static { steps = 3, loads = name and {} }
    if not name then rest = model:static { steps = 3 } end
    rest:stop()
    return model:dynamic { dt = 1e-6, duration = 5e-5, loads = name }:finish().hash
  end
  equal(hash(true), hash(false), "in a case with factor 1 and in none")
end)

case("wrong load cases and combinations are refused", function()
  local s = loaded()
  local model, other = s.model, loaded()
  local push = { node = s.tip, force = { 1, 0, 0 } }
  local rest = model:static { steps = 1, loads = "dead" }:finish()
  local goes_on = { from = rest, dt = 1e-6, duration = 1e-6 }
  for words, loads in pairs {
    ["no load case 'daed' (did you mean 'dead'?); the model has 'dead', 'live', 'blast', 'uls', 'all'"] = { daed = 1 },
    ["'dead' is 'one'; must be a finite number, its factor"] = { dead = "one" },
    ["'dead' is not a number (nan); must be a finite number, its factor"] = { dead = 0 / 0 },
    ["1 = 'dead'; write { name = factor, ... }, such as { dead = 1.35, live = 1.5 }"] = { "dead" },
    [" is 3; must be { name = factor, ... }"] = 3,
    [" is load case 'dead' of another model; use one of this model"] = other.dead,
  } do
    checks.refused({ "model:static: field 'loads'", words }, function() model:static { loads = loads } end)
  end
  checks.refused("model:dynamic: field 'loads': no load case 'ulss' (did you mean 'uls'?)",
    function() model:dynamic { dt = 1, duration = 1, loads = "ulss" } end)
  checks.refused({ "model:static: the model has load cases, and this run does not say whether it takes 'dead', 'live', "
    .. "'blast'", "give loads = { dead = 1, ... }, or the name of a combination" }, function() model:static {} end)
  model:case "wind"
  checks.refused({ "model:dynamic: the model has load cases, and this run does not say whether it takes 'wind'",
    "what the run before had goes on" }, function() model:dynamic(goes_on) end)
  model:dynamic(scenes.with(goes_on, { loads = { wind = 0 } }))
  for words, call in pairs {
    ["model:load: field 'case': no load case 'snow'; the model has 'dead', "] =
      function() model:load(scenes.with(push, { case = "snow" })) end,
    ["model:load: field 'case' is load case 'dead' of another model; use one of this model"] =
      function() model:load { member = s.member, q = { 1, 0, 0 }, case = other.dead } end,
    ["case:load: field 'case' is given; this load belongs to load case 'dead' already; leave it out"] =
      function() s.dead:load(scenes.with(push, { case = "live" })) end,
    ["model:case: the name is 3; must be a string, such as 'dead'"] = function() model:case(3) end,
    ["model:case: there is a combination 'uls' already"] = function() model:case "uls" end,
    ["model:combination: there is a load case 'live' already"] =
      function() model:combination("live", { dead = 1 }) end,
    ["model:combination: there is a combination 'uls' already"] =
      function() model:combination("uls", { dead = 1 }) end,
    ["model:combination: 'new': no load case 'x'; the model has "] = function() model:combination("new", { x = 1 }) end,
    ["model:combination: 'new' is empty; give { name = factor, ... }"] = function() model:combination("new", {}) end,
    ["model:static: field 'loads' is given; the model has no load cases; declare one with model:case \"name\""] =
      function() cantilever():static { loads = {} } end,
  } do
    checks.refused(words, call)
  end
  equal(model:case "dead", s.dead, "a case again")
  equal(#model:cases(), 4, "cases")
  equal(tostring(s.live), "load case 'live'", "text")
  equal(model:loads()[1].case, "dead", "case of a load")
  other.model:close()
  checks.refused("case:gravity: this is load case '' of a model that was closed at ",
    function() other.dead:gravity { 0, 0, -1 } end)
end)

checks.done()
