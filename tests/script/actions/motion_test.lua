-- What moves and what is damped: velocities of single nodes and of members, alpha relative to supports that move, free
-- bodies that alpha slows down, and free bodies that spin too fast for Newmark's method.
--
-- Run: lua5.4 tests/script/actions/motion_test.lua BUILD_FOLDER
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local scenes = require "scenes"
local hinge = require "hinge"
local checks = support.checks "motion"
local case, expect, equal, near = checks.case, checks.expect, checks.equal, checks.near
local runs = require "runs"(checks)
local hinge_on = support.scenes(arg[1])

local steel = hinge.material { E = 200e9, nu = 0.3, density = 8000 }
local bar = scenes.square
local per_length, L = 8000 * 0.05 ^ 2, 2 -- kg/m, m

-- Velocities ----------------------------------------------------------------------------------------------------------

local function cantilever(elements)
  return scenes.cantilever { length = L, member = { material = steel, elements = elements } }
end
case("a velocity on a node, a member and a group moves what it names", function()
  for _, elements in ipairs { 2, 8 } do
    local what = elements .. " elements: "
    local model, tip, member = cantilever(elements)
    model:mass { node = tip, mass = 50 }
    model:velocity(tip, { 0, 0, 2 })
    local run = model:dynamic { dt = 1e-5, duration = 1e-5 }
    near(run.energy.kinetic, 0.5 * 4 * (50 + per_length * L / elements / 3), 1e-9, what .. "a node alone")
    model:velocity(member, { 0, 0, 2 }) -- the foot is held
    run = model:dynamic { dt = 1e-5, duration = 1e-5 }
    near(run.energy.kinetic, 0.5 * 4 * (50 + per_length * L * (1 - 2 / 3 / elements)), 1e-9, what .. "the member")
  end
end)

case("the peak of a struck mass does not depend on the number of elements", function()
  -- as a mass on a spring has it: m v^2 = k u^2
  local peak = {}
  for _, elements in ipairs { 2, 8 } do
    local model, tip = cantilever(elements)
    model:mass { node = tip, mass = 500 }
    model:velocity(tip, { 0, 0, 1 })
    local run = model:dynamic { dt = 1e-4, duration = 0.12 }
    local z = run:probe { node = tip, "uz" }
    run:finish()
    peak[elements] = z.max
  end
  near(peak[2], peak[8], 0.01 * peak[8], "peak of a struck cantilever")
end)

case("both ends by two calls move the member as its group does", function()
  -- given to one joint of two members: that joint
  local function kinetic(give)
    local model = hinge.model { elements_per_member = 4 }
    local a, b, c = model:node { 0, 0, 0 }, model:node { L, 0, 0 }, model:node { 2 * L, 0, 0 }
    for _, ends in ipairs { { a, b }, { b, c } } do
      model:member { ends[1], ends[2], section = bar, material = steel, group = ends[1] == a and "one" or "two" }
    end
    give(model, a, b, c)
    return model:dynamic { dt = 1e-5, duration = 1e-5 }.energy.kinetic
  end
  local m, share = per_length * L, per_length * L / 4 / 3
  near(kinetic(function(model, a, b) model:velocity(a, { 0, 1, 0 }) model:velocity(b, { 0, 1, 0 }) end),
    0.5 * (m + share), 1e-9, "both ends, one by one")
  near(kinetic(function(model) model:velocity("one", { 0, 1, 0 }) end), 0.5 * (m + share), 1e-9, "a group")
  near(kinetic(function(model, _, b) model:velocity(b, { 0, 1, 0 }) end), 0.5 * 2 * share, 1e-9, "a joint")
end)

case("velocities after statics move the same", function()
  local model, tip = cantilever(4)
  model:load { node = tip, force = { 0, 0, 1 } }
  local rest = model:static { steps = 1 }:finish()
  model:velocity(tip, { 0, 0, 2 })
  near(model:dynamic { from = rest, dt = 1e-5, duration = 1e-5 }.energy.kinetic, 0.5 * 4 * per_length * L / 4 / 3,
    1e-6, "after statics")
end)

-- A scene in the program; $more: what it declares, $run: how it runs.
local scene = [[
local hinge = require "hinge"
local model = hinge.model {}
local a, b = model:node { 0, 0, 0 }, model:node { 2, 0, 0 }
local c, d = model:node { 0, 5, 0 }, model:node { 2, 5, 0 }
local steel = hinge.material { E = 206e9, density = 7850, yield_stress = 355e6 }
local bar = hinge.section.solid { width = 0.05, depth = 0.05 }
model:fix(a)
model:member { a, b, section = bar, material = steel, group = "held" }
model:member { c, d, section = bar, material = steel, group = "free" }
%s
model:dynamic { dt = 1e-4, duration = 1e-3 }:finish()
]]
local function check(more, verb)
  local status, printed, complaint = hinge_on(verb or "check", scene:format(more))
  equal(status, 0, more .. complaint)
  return printed .. complaint
end
local alone = "is given to that node alone and brings "
case("a scene in the program warns of a velocity on a node without mass", function()
  expect(check("model:velocity(b, { 0, 0, 3 })"):find(alone, 1, true), "a node without mass")
  expect(check("model:velocity(b, { 0, 0, 3 })", "run"):find(alone, 1, true), "a node without mass, at the run")
  expect(not check("model:mass { node = b, mass = 100 }\nmodel:velocity(b, { 0, 0, 3 })"):find(alone, 1, true),
    "a node with mass")
  expect(not check("model:velocity('free', { 0, 0, 3 })"):find(alone, 1, true), "a group")
  local told = check("model:velocity('free', { 0, 0, 3 })", "plan"):match "begins with (%S+) J of kinetic energy"
  near(tonumber(told) or 0 / 0, 0.5 * 7850 * 0.05 ^ 2 * 2 * 9, 0.1, "the plan tells of the energy")
  expect(not check("", "plan"):find("begins with", 1, true), "nothing moves")
end)

-- Free bodies that alpha slows down -----------------------------------------------------------------------------------
case("alpha slows free bodies down", function()
  local slows = "is held by no support, and alpha = 2 1/s of model:damping slows it down in flight, by 18 % in 0.1 s"
  for _, verb in ipairs { "check", "run" } do
    local said = check("model:damping { alpha = 2, beta = 1e-4 }", verb)
    expect(said:find("the body of member 2 (free) " .. slows, 1, true), "%s: %s", verb, said)
  end
  for what, more in pairs {
    ["by group"] = "model:damping { alpha = 2, group = 'held' }",
    ["left out"] = "model:damping { alpha = 2 }\nmodel:damping { alpha = 0, group = 'free' }",
    ["meant"] = "model:damping { alpha = 2, group = 'free' }",
    ["beta alone"] = "model:damping { alpha = 0, beta = 1e-4 }",
    ["held by a connector"] = "model:damping { alpha = 2 }\nmodel:connector { b, d, stiffness = { x = 1e5 } }",
    ["held by the ground"] = "model:damping { alpha = 2 }\nmodel:connector { d, ground = true, "
      .. "stiffness = { x = 1e5 } }",
  } do
    expect(not check(more):find(slows, 1, true), "quiet: %s", what)
  end
end)

-- alpha relative to supports that move --------------------------------------------------------------------------------
-- A mass on a post whose ground is accelerated, and leaves a velocity: it answers as it does in the axes of the ground,
-- under the weight -m a.
case("a mass on a post whose ground is accelerated follows the closed form", function()
  local function shaken(o)
    local model, top, _, foot = scenes.cantilever { along = { 0, 0, 1 }, member = { material = steel },
      model = { elements_per_member = 2, weight = "nodes" } }
    model:mass { node = top, mass = 200 }
    local a = o.acceleration
    if o.moves then
      model:move { node = foot, x = function(t) return 0.5 * a * t * t + (o.speed or 0) * t end }
    else
      model:gravity { -a, 0, 0 }
    end
    model:damping { alpha = o.alpha }
    local run = model:dynamic { dt = o.integrator == "explicit" and "auto" or 1e-4, duration = 0.25,
      integrator = o.integrator, rho_infinity = o.rho_infinity }
    runs.completed(run, "shaken")
    return run, run:displacement(top) - run:displacement(foot)
  end
  for _, o in ipairs { { integrator = "newmark" }, { integrator = "explicit" }, { rho_infinity = 0.8 } } do
    local what = (o.integrator or "rho_infinity = 0.8") .. ": "
    o.alpha, o.acceleration, o.speed, o.moves = 5, 3, 0, true
    local moving, u = shaken(o)
    o.moves = false
    local still, wanted = shaken(o)
    -- In explicit steps the bar's mass is in Simpson's lumps, and its weight acts by halves of its elements.
    local exact = o.integrator == "explicit" and 5e-3 or 2e-3
    near(u, wanted, exact * math.abs(wanted), what .. "as in the axes of the ground")
    near(moving.energy.damping, still.energy.damping, 0.02 * still.energy.damping, what .. "energy damped")
    expect(still.energy.damping > 0.01, what .. "something is damped")
    runs.balanced(moving, 1e-4, "work", what)
  end
end)

case("supports that move apart load what is between them", function()
  -- relative to their mean, along each direction by those held in it
  local model, b = scenes.cantilever { length = 2, member = { material = steel } }
  model:fix(b, "xyz")
  model:move { node = b, z = function(t) return 0.01 * (1 - math.cos(50 * t)) end }
  model:damping { alpha = 5 }
  runs.balanced(model:dynamic { dt = 2e-5, duration = 0.2 }:finish(), 1e-3, "damping", "supports that move apart")
end)

case("a free body beside moving supports is damped by its velocity in space", function()
  local model, _, _, foot = scenes.cantilever { along = { 0, 0, 1 }, member = { material = steel } }
  local c, d = model:node { 5, 0, 0 }, model:node { 6, 0, 0 }
  model:member { c, d, section = bar, material = steel, group = "free" }
  model:velocity("free", { 20, 0, 0 })
  model:move { node = foot, x = function(t) return t end }
  model:damping { alpha = 1 }
  local run = model:dynamic { dt = 1e-4, duration = 0.2 }:finish()
  near(run:velocity(c), 20 * math.exp(-0.2), 1e-3, "in flight")
end)

-- Spin ----------------------------------------------------------------------------------------------------------------
case("a spin turns a body at its rate", function()
  local function spinning(o)
    local model = hinge.model {}
    local a, b = model:node { 0, 0, 0 }, model:node { 2, 0, 0 }
    model:member { a, b, section = bar, material = steel, group = "bar" }
    model:velocity("bar", { 1, 0, 0 }, o.spin)
    local run = model:dynamic { dt = o.dt, duration = o.duration or 1, integrator = o.integrator, record = false }
    runs.completed(run, "spinning")
    local said
    for _, w in ipairs(run.warnings) do said = said or w:find('integrator = "energy-momentum"', 1, true) and w end
    return said
  end
  local said = spinning { spin = { 0, 0, 30 }, dt = 1e-3, duration = 1.2 }
  expect(said and said:find "^the free body of member 1 spins at [23]%d%.?%d* rad/s at t = ", "fast: %s", said)
  for what, o in pairs { ["short steps"] = { spin = { 0, 0, 60 }, dt = 1e-4, duration = 0.3 },
    ["slow"] = { spin = { 0, 0, 3 }, dt = 1e-3 },
    ["about its axis"] = { spin = { 60, 0, 0 }, dt = 1e-3, duration = 0.3 },
    ["energy-momentum"] = { spin = { 0, 0, 60 }, dt = 1e-3, integrator = "energy-momentum", duration = 0.3 } } do
    equal(spinning(o), nil, what)
  end
end)

case("pieces whose mass is at one node are not said to spin", function()
  local model = hinge.model {}
  for i = 1, 20 do
    local a, b = model:node { 3e-6 * i, 7e-6, i * 1e-7 }, model:node { 2, 0.1 * i, 1.9 }
    model:member { a, b, section = bar, material = steel, group = "bars" }
  end
  model:fracture { group = "bars", where = "all", rule = function() return true end }
  model:velocity("bars", { 13.7, 3.3, 0.9 })
  local run = runs.completed(model:dynamic { dt = 1e-3, duration = 0.3, record = false })
  expect(run:count { state = "broken" } > 0, "the bars break")
  for _, w in ipairs(run.warnings) do expect(not w:find("spins", 1, true), "%s", w) end
end)

checks.done()
