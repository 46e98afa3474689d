-- What a script declares is what runs, or an error at its line: velocities after statics, loads with a history in
-- statics and over jumps, what is declared after a run was made, and parameters.
--
-- Run: lua5.4 tests/script/model/declared_test.lua BUILD_FOLDER
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local hinge = require "hinge"
local support = require "support"
local scenes = require "scenes"
local checks = support.checks "declared"
local case, expect, equal, near, refused = checks.case, checks.expect, checks.equal, checks.near, checks.refused
local quote, with = support.quote, scenes.with

local steel, bar = hinge.material { E = 200e9, nu = 0.3, density = 8000 }, scenes.square
local L, P = 2, 1000
local drop = P * L ^ 3 / (3 * steel.E * bar.Ix) + P * L / (steel.G * bar.shear_area_y) -- m, of the tip under P

local function cantilever(options)
  local model, tip, member, foot = scenes.cantilever { length = L, model = options or { displacement = "small" },
    member = { material = steel, group = "arms" } }
  return model, foot, tip, member
end
local function sag(run, tip) return -select(3, run:displacement(tip)) end

case("a velocity given after statics acts in the run that goes on from it", function()
  local model, foot, tip = cantilever()
  model:gravity { 0, 0, -9.8 }
  local rest = model:static { steps = 1 }:finish()
  model:velocity(tip, { 0, 3, 0 }, { 0, 0, 1 })
  local first = model:dynamic { from = rest, dt = 1e-6, duration = 1e-5 }
  near(select(2, first:velocity(tip)), 3, 0, "given after the statics: velocity")
  near(select(6, first:velocity(tip)), 1, 0, "given after the statics: spin")
  near(sag(first, tip), sag(rest, tip), 0, "given after the statics: place")
  first:finish()
  near(select(2, first:displacement(tip)), 3e-5, 1e-6, "it moves")
  -- the run after goes on as fast as the first one ended; given anew it begins anew
  local went = { first:velocity(tip) }
  local second = model:dynamic { from = first, dt = 1e-6, duration = 1e-5 }
  equal(select(2, second:velocity(tip)), went[2], "no velocity given since")
  model:velocity(tip, { 0, 3, 0 })
  second = model:dynamic { from = first, dt = 1e-6, duration = 1e-5 }
  equal(select(2, second:velocity(tip)), 3, "given again since")
  -- as if it had been given before, to the bit
  local other, _, end_of = cantilever()
  other:gravity { 0, 0, -9.8 }
  other:velocity(end_of, { 0, 3, 0 }, { 0, 0, 1 })
  local before = other:static { steps = 1 }:finish()
  equal(other:dynamic { from = before, dt = 1e-6, duration = 1e-5 }:finish().hash, first.hash, "given before or after")
  refused("model:velocity: target is node 1, which supports hold in all directions of this velocity",
    function() model:velocity(foot, { 1, 0, 0 }) end)
end)

case("a velocity given to a group acts on it as a rigid body where it is by then", function()
  local model = hinge.model {}
  local a, b = model:node { 0, 0, 0 }, model:node { 1, 0, 0 }
  model:member { a, b, section = bar, material = steel, group = "bar" }
  model:velocity("bar", { 0, 0, 0 }, { 0, 0, math.pi / 2 })
  local turned = model:dynamic { dt = 1e-3, duration = 1 }:finish()
  model:velocity("bar", { 0, 0, 0 }, { 0, 0, 2 })
  local run = model:dynamic { from = turned, dt = 1e-3, duration = 1e-3 }
  local vx, vy = run:velocity(b)
  near(vx, -1, 0.02, "a bar that has turned: along x")
  near(vy, 0, 0.02, "a bar that has turned: along y")
  local mid = model:node { 5, 0, 0 }
  model:velocity(mid, { 1, 0, 0 })
  refused("model:dynamic: a velocity was given to node 3 at {5, 0, 0} m, which belongs to no member",
    function() model:dynamic { dt = 1e-3, duration = 1e-3 } end)
end)

case("a load with a history is no part of statics, unless its case is taken", function()
  for name, target in pairs { ["on a node"] = function(tip) return { node = tip, force = { 0, 0, -P } } end,
    ["on a member"] = function(_, member) return { member = member, at = 1, force = { 0, 0, -P } } end } do
    for shape, history in pairs { points = { { 0, 1 }, { 0.1, 0 } }, ["function"] = function() return 1 end } do
      local what = name .. ", " .. shape .. ": "
      local model, _, tip, member = cantilever()
      local load = target(tip, member)
      load.history = history
      model:load(load)
      refused("model:static: nothing acts: all loads have a history", function() model:static {} end)
      model:load { node = tip, force = { 0, P, 0 } }
      local rest = model:static { steps = 1 }:finish()
      near(sag(rest, tip), 0, 1e-12, what .. "statics")
      expect(select(2, rest:displacement(tip)) > 0.9 * drop, what .. "the other load")
      -- dynamics begins with it, from rest: m a = P for the tip's own part
      local run = model:dynamic { from = rest, dt = 1e-6, duration = 1e-6 }
      expect(select(3, run:acceleration(tip)) < -1, what .. "dynamics")
      -- by its case, in full
      local by_case, _, far, arm = cantilever()
      local blast = target(far, arm)
      blast.history, blast.case = history, by_case:case "blast"
      by_case:load(blast)
      near(sag(by_case:static { steps = 1, loads = "blast" }:finish(), far), drop, 1e-9 * drop, what .. "its case")
      near(sag(by_case:static { steps = 1, loads = { blast = 0.5 } }:finish(), far), drop / 2, 1e-9 * drop,
        what .. "half of its case")
    end
  end
end)

-- A history that jumps: no impulse is lost, wherever the steps end ---------------------------------------------------
local function flying(history, options, on_member)
  local model = hinge.model { displacement = "small" }
  local a, b = model:node { 0, 0, 0 }, model:node { 1, 0, 0 }
  local member = model:member { a, b, section = bar, material = steel }
  if on_member then
    model:load { member = member, q = { 0, P, 0 }, history = history }
  else
    for _, node in ipairs { a, b } do model:load { node = node, force = { 0, P / 2, 0 }, history = history } end
  end
  local run = model:dynamic(with({ duration = 1e-3, rest = false }, options)):finish()
  equal(run.verdict, "completed", "flight: " .. run.reason)
  return run, select(2, table.unpack(run:momentum().linear)), run.energy
end
local pulses = { -- points, impulse over P
  ["a jump where a step ends"] = { { { 0, 0 }, { 2e-4, 0 }, { 2e-4, 1 } }, 8e-4 },
  ["a jump within a step"] = { { { 0, 0 }, { 2.3e-4, 0 }, { 2.3e-4, 1 } }, 7.7e-4 },
  ["a jump at the start"] = { { { 0, 0 }, { 0, 1 }, { 1, 1 } }, 1e-3 },
  ["a jump to nothing"] = { { { 0, 1 }, { 4e-4, 1 }, { 4e-4, 0 } }, 4e-4 },
  ["a pulse within one step"] = { { { 0, 0 }, { 2.3e-4, 0 }, { 2.3e-4, 1 }, { 2.7e-4, 1 }, { 2.7e-4, 0 } }, 4e-5 },
  ["a blast"] = { { { 0, 0 }, { 3e-4, 0 }, { 3e-4, 1 }, { 6.5e-4, 0 } }, 1.75e-4 },
  ["a triangle within one step"] = { { { 3.1e-4, 0 }, { 3.5e-4, 1 }, { 3.9e-4, 0 } }, 4e-5 },
  ["a triangle of two and a half steps"] = { { { 3e-4, 0 }, { 4.25e-4, 1 }, { 5.5e-4, 0 } }, 1.25e-4 },
  ["a triangle of three steps"] = { { { 3e-4, 0 }, { 4.5e-4, 1 }, { 6e-4, 0 } }, 1.5e-4 },
  ["a blast of one and a half steps"] = { { { 0, 1 }, { 1.5e-4, 0 } }, 0.75e-4 },
  ["kinks where steps end"] = { { { 1e-4, 0 }, { 2e-4, 1 }, { 4e-4, 0 } }, 1.5e-4 },
}
case("a load that jumps keeps its impulse wherever the steps end", function()
  for name, pulse in pairs(pulses) do
    for method, options in pairs { newmark = { dt = 1e-4 }, damped = { dt = 1e-4, rho_infinity = 0.6 },
      explicit = { dt = 1e-5, integrator = "explicit" }, controlled = { dt = 1e-4, step_control = 0.01 },
      displacement = { dt = 1e-4, internals = { predictor = "displacement" } } } do
      for _, on_member in ipairs { false, true } do
        local run, momentum, energy = flying(pulse[1], with(options, { energy_tolerance = 0 }), on_member)
        local what = name .. ", " .. method .. (on_member and ", on a member" or "")
        -- Bossak's weights spread a jump over two steps
        local within = method == "damped" and 0.09 * P * 1e-4 or 2e-7 * P * 1e-3
        near(momentum, P * pulse[2], within, what .. ": momentum")
        expect(math.abs(energy.energy_error) <= (method == "explicit" and 0.1 or 1e-5) * energy.work,
          "%s: energy error %g of %g", what, energy.energy_error, energy.work)
        expect(run.time > 0.999e-3, "%s: end", what)
      end
    end
  end
end)

case("explicit steps keep the impulse and the energy of a pulse of few steps", function()
  -- what a jump leaves between energy and work is taken up, as large as the pulse is short
  for _, steps in ipairs { 1.5, 2.1, 2.5, 2.7, 3.5, 4.5 } do
    local dt = 8e-6
    local run, momentum, energy = flying({ { 0, 0 }, { steps * dt / 2, 1 }, { steps * dt, 0 } },
      { dt = dt, integrator = "explicit" })
    local what = ("a triangle of %g explicit steps"):format(steps)
    near(momentum, P * steps * dt / 2, 1e-9 * P * dt, what .. ": momentum")
    expect(energy.work > 0 and math.abs(run.energy_error) <= 2e-3, "%s: energy error %g of the largest energy", what,
      run.energy_error)
  end
end)

case("a checkpoint before a jump, and a step taken back over one, change nothing", function()
  local function struck(options)
    local model, _, tip = cantilever {}
    model:load { node = tip, force = { 0, 0, -4e4 }, history = { { 0, 0 }, { 3.3e-4, 0 }, { 3.3e-4, 1 }, { 1, 1 } } }
    options.duration = 1e-3
    return model:dynamic(options)
  end
  local file = os.tmpname()
  for _, dt in ipairs { 1e-5, 7e-6 } do
    for _, part in ipairs { 0.32, 0.33, 0.34, 0.6 } do
      local whole = struck { dt = dt }
      for step in whole:steps() do
        if step.index == math.floor(part * whole.planned_steps + 0.5) then whole:checkpoint(file) end
      end
      equal(struck { dt = dt }:resume(file):finish().hash, whole.hash, ("a checkpoint at %g of the way"):format(part))
    end
  end
  os.remove(file)
  local controlled = struck { dt = 1e-4, step_control = 1e-8 }
  local finest = controlled:finish()
  expect(controlled.counts.rejected_steps > 0 and controlled.verdict == "completed", "steps taken back: %s, %s",
    controlled.counts.rejected_steps, controlled.reason)
  expect(math.abs(finest.energy.energy_error) <= 1e-6 * finest.energy.work, "taken back: energy error %g of %g",
    finest.energy.energy_error, finest.energy.work)
end)

case("three points of a history at one time, and jumps of a support, are refused", function()
  local model, foot, tip = cantilever()
  refused("model:load: field 'history' is three times at 1 s; a jump is two points: up to its time, and from there on",
    function() model:load { node = tip, force = { 1, 0, 0 }, history = { { 1, 0 }, { 1, 2 }, { 1, 3 } } } end)
  refused("model:move: field 'x' is out of order at point 2 (time 1 s); times must rise",
    function() model:move { node = foot, x = { { 1, 0 }, { 1, 2 } } } end)
end)

-- What is declared after a run was made ------------------------------------------------------------------------------
local later = {
  ["model:node"] = function(s) s.model:node { 9, 9, 9 } end,
  ["model:fix"] = function(s) s.model:fix(s.tip, "y") end,
  ["model:member"] = function(s)
    s.model:member { s.tip, s.far, section = bar, material = steel, group = { "arms", "late" } }
  end,
  ["model:gravity"] = function(s) s.model:gravity { 0, 0, -1 } end,
  ["model:velocity"] = function(s) s.model:velocity(s.tip, { 1, 0, 0 }) end,
  ["model:load"] = function(s) s.model:load { node = s.tip, force = { 1, 0, 0 } } end,
  ["case:load"] = function(s) s.case:load { member = s.member, q = { 1, 0, 0 } } end,
  ["case:gravity"] = function(s) s.case:gravity { 0, 0, -1 } end,
  ["load:remove"] = function(s) s.load:remove() end,
  ["model:mass"] = function(s) s.model:mass { node = s.tip, mass = 1 } end,
  ["model:move"] = function(s) s.model:move { node = s.foot, x = { { 0, 0 }, { 1, 1 } } } end,
  ["model:fracture"] = function(s) s.model:fracture { curvature_x = 1 } end,
  ["model:contact"] = function(s) s.model:contact() end,
  ["model:connector"] = function(s) s.model:connector { s.tip, ground = true, stiffness = { x = 1 } } end,
  ["model:damping"] = function(s) s.model:damping { alpha = 1 } end,
  ["model:ground"] = function(s) s.model:ground { point = { 0, 0, -9 } } end,
}
case("a declaration after a run was made stops that run with its line", function()
  for name, declare in pairs(later) do
    for _, kind in ipairs { "static", "dynamic" } do
      for _, begun in ipairs { false, true } do
        local s = {}
        s.model, s.foot, s.tip, s.member = cantilever()
        s.far, s.case = s.model:node { 4, 0, 0 }, s.model:case "live"
        s.load = s.model:load { node = s.tip, force = { 0, 0, -1 } }
        local run = s.model[kind](s.model, kind == "static" and { steps = 4, loads = "live" }
          or { dt = 1e-6, duration = 4e-6, loads = "live" })
        if begun then run:step() end
        declare(s)
        local calls = { function() run:step() end, function() run:finish() end, function() run:steps()() end }
        for _, call in ipairs(calls) do
          refused({ "run:step: " .. name .. " at ", "declared_test.lua:", " came after this run was made at ",
            "declare it before, or make another run that goes on from this one (from = run)" }, call)
        end
        run:stop()
        expect(not run:step(), "%s: a run that was stopped", name)
      end
    end
  end
end)

case("members, nodes and groups declared after a run was made are refused by it", function()
  local model, foot, tip, member = cantilever()
  local far = model:node { 4, 0, 0 }
  model:load { node = tip, force = { 0, 0, -1 } }
  local run = model:static { steps = 1 }:finish()
  local new = model:member { tip, far, section = bar, material = steel, group = { "arms", "late" } }
  local node = model:node { 5, 0, 0 }
  model:fix(far, "z")
  local late, arms = model:group "late", model:group "arms"
  local since, fixed = ", declared after this run was made", ", fixed after this run was made"
  for what, group in pairs { late = late, ["'late'"] = "late", arms = arms } do
    local which = "group is group '" .. what:match "%a+" .. "', of which member 2 was declared after this run was made"
    refused({ "run:count: field 'group'", which:sub(7) }, function() run:count { state = "elastic", group = group } end)
    refused("run:read: " .. which, function() run:read("N", group) end)
  end
  refused("run:forces: member is member 2" .. since, function() run:forces(new) end)
  refused("member:state: this is member 2" .. since, function() new:state() end)
  refused("node:displacement: this is node 4" .. since, function() node:displacement() end)
  refused("run:reaction: node is node 3" .. fixed, function() run:reaction(far) end)
  refused("node:reaction: this is node 3" .. fixed, function() far:reaction() end)
  refused("run:read: a joint is node 3" .. fixed, function() run:read "reaction_fz" end)
  equal(run:count { state = "elastic" }, 1, "members of the run")
  equal(#member:groups(), 1, "groups")
  near(select(3, foot:reaction(run)), 1, 1e-9, "what the run knows")
  refused({ "model:dynamic: field 'from' is a run of a structure with 4 nodes and 2 elements", "add nothing" },
    function() model:dynamic { from = run, dt = 1e-6, duration = 1e-6 } end)
end)

case("a run goes on only from one that is over and whose supports are unchanged", function()
  local model, _, tip = cantilever()
  model:load { node = tip, force = { 0, 0, -1 } }
  local rest = model:static { steps = 2 }
  refused({ "model:dynamic: field 'from' is a static run that has done 0 of 2 steps (made at ",
    "finish it first with run:finish(), or end it with run:stop()" },
    function() model:dynamic { from = rest, dt = 1e-6, duration = 1e-6 } end)
  rest:step()
  refused("model:static: field 'from' is a static run that has done 1 of 2 steps",
    function() model:static { from = rest } end)
  rest:stop()
  model:static { from = rest }
  rest = model:static { steps = 1 }:finish()
  model:fix(tip, "y")
  refused({ "model:dynamic: field 'from' is the run made at ", "node 2 at {2, 0, 0} m has been fixed since" },
    function() model:dynamic { from = rest, dt = 1e-6, duration = 1e-6 } end)
end)

case("calls refuse arguments and fields that they would not read", function()
  local model, foot, tip, member = cantilever()
  refused("model:node: position has a field 'mass'; must be {x, y, z}",
    function() model:node { 0, 0, 0, mass = 3 } end)
  refused("model:gravity: acceleration has a field 'x'; must be {x, y, z}",
    function() model:gravity { 0, 0, -9.8, x = 1 } end)
  refused("model:fix: the list of nodes holds a field 'what', which is not one of its items 1 to 2",
    function() model:fix { foot, tip, what = "x" } end)
  model:load { node = tip, force = { 0, 0, -1 } }
  local run = model:static { steps = 1 }:finish()
  refused("run:momentum: group: no group 'g'; the model has 'arms'", function() run:momentum "g" end)
  for name, call in pairs {
    ["model:counts"] = function() model:counts(1) end, ["model:close"] = function() model:close(1) end,
    ["model:nodes"] = function() model:nodes(1) end, ["group:members"] = function() model:group "arms":members(1) end,
    ["member:nodes"] = function() member:nodes(1) end, ["run:steps"] = function() run:steps(1) end,
    ["run:finish"] = function() run:finish(1) end, ["run:step"] = function() run:step(2) end,
    ["run:stop"] = function() run:stop(1) end, ["run:snapshot"] = function() run:snapshot(1) end,
    ["load:remove"] = function() model:loads()[1]:remove(1) end,
  } do
    refused(name .. ": takes no argument, got also", call)
  end
  for name, call in pairs {
    ["model:member"] = function() model:member({}, 1) end, ["model:load"] = function() model:load({}, 1) end,
    ["model:static"] = function() model:static({}, 1) end, ["model:dynamic"] = function() model:dynamic({}, 1) end,
    ["model:contact"] = function() model:contact({}, 1) end, ["model:group"] = function() model:group("arms", 1) end,
    ["run:displacement"] = function() run:displacement(tip, 1) end, ["run:count"] = function() run:count({}, 1) end,
    ["node:reaction"] = function() foot:reaction(run, 1) end, ["member:forces"] = function() member:forces(run, 1) end,
    ["hinge.model"] = function() hinge.model({}, 1) end, ["hinge.material"] = function() hinge.material({}, 1) end,
    ["hinge.section.general"] = function() hinge.section.general({}, 1) end,
  } do
    refused(name .. ": takes one argument, got also 1", call)
  end
end)

case("declarations that would do nothing, or contradict each other, are refused", function()
  local model, foot, tip = cantilever()
  local member = model:members()[1]
  local large = cantilever {}
  local function dynamic(options) large:dynamic(with({ dt = 1e-6, duration = 1e-5 }, options)) end
  local light = scenes.cantilever { member = { material = hinge.material { E = 1e9 } } }
  light:gravity { 0, 0, -9.8 }
  for words, call in pairs {
    ["hinge.section.box: takes no further argument, got also 3"] =
      function() hinge.section.box({ width = 1, depth = 1, thickness = 0.1 }, 3) end,
    ["hinge.ground: takes no further argument, got also 3"] =
      function() hinge.ground({ dt = 1, acceleration = { 0, 0 } }, 3) end,
    ["hinge.scenario: takes no further argument, got also 3"] = function() hinge.scenario({ run = print }, 3) end,
    ["hinge.material: field 'G' is 1 Pa; is given beside nu"] = function() hinge.material { E = 1, nu = 0, G = 1 } end,
    ["hinge.model: field 'shift' is 'elastic_and_plastic'; has no meaning with formulation 'conventional'"] =
      function() hinge.model { formulation = "conventional", shift = "elastic_and_plastic" } end,
    ["model:fix: the list of nodes is empty"] = function() model:fix {} end,
    ["model:move: field 'node' is an empty list"] = function() model:move { node = {}, x = math.sin } end,
    ["model:contact: field 'groups' is an empty list"] = function() model:contact { groups = {} } end,
    ["model:member: field 'group' is 'q' twice; give each group once"] =
      function() model:member { foot, tip, section = bar, material = steel, group = { "q", "p", "q" } } end,
    ["model:connector: field 'capacity' is given for y; nothing acts in that direction"] =
      function() model:connector { tip, ground = true, stiffness = { x = 1 }, capacity = { x = 1, y = 2 } } end,
    ["model:damping: field 'ratio' holds a field 'x', which is not one of its items 1 to 2"] =
      function() model:damping { ratio = { 0.02, 0.03, x = 1 }, periods = { 1, 0.1 } } end,
    ["model:fracture: field 'keep' holds a field 'x', which is not one of its items 1 to 1"] =
      function() model:fracture { rule = print, keep = { "a", x = "b" } } end,
    ["model:fracture: field 'keep' is 'a' twice; give each name once"] =
      function() model:fracture { rule = print, keep = { "a", "a" } } end,
    ["model:static: the model has gravity, and nothing in it has mass"] = function() light:static {} end,
  } do
    refused(words, call)
  end
  for word, options in pairs {
    solver_tolerance = { solver = "direct", internals = { solver_tolerance = 1e-3 } },
    solver_iterations = { solver = "direct", internals = { solver_iterations = 3 } },
    ["tolerance' is 0.001; is that of Newton's method, and iterations = 1"] = { iterations = 1, tolerance = 1e-3 },
    ["rest' is true; integrator = 'energy-momentum' leaves no body"] = { integrator = "energy-momentum", rest = true },
  } do
    refused({ "model:dynamic: field '", options.solver and "solver = 'direct'" or "", "'" .. word }, dynamic, options)
  end
  model:ground { point = { 0, 0, -1 } }
  model:ground { point = { 0, 0, -2 } }
  refused("model:ground: this plane is declared already, for the same members",
    function() model:ground { point = { 0, 0, -1 }, normal = { 0, 0, 2 } } end)
  model:load { node = tip, force = { 0, 0, -1 } }
  local run = model:static { steps = 1 }
  run:probe { node = tip, "uz", name = "tip" }
  for _, name in ipairs { "tip", "time", "factor", "energy_error", "kinetic" } do
    refused("run:probe: field 'name' is '" .. name .. "'; there is a column of history.csv with that name already",
      function() run:probe { node = tip, "ux", name = name } end)
  end
  run:finish()
  refused("run:on_step: the run is over (completed), so no step follows that would call it",
    function() run:on_step(print) end)
  run:stop()
  equal(run.verdict, "completed", "stopped when it was over")
  equal(#member:groups(), 1, "groups of the member")
end)

-- Parameters of a script that is made of plain statements ------------------------------------------------------------
local hinge_on, folder = support.scenes(arg[1])
local function run_script(text, settings) return hinge_on("run", text, settings .. " --out out") end
case("a parameter that a script of plain statements does not read is refused", function()
  for text, wanted in pairs {
    ["return 1"] = "zzz=3: scene.lua takes no parameters; it does not read its argument, '...'",
    ["local p = ...\nprint(p.speed or p.height)"] = "zzz=3: scene.lua reads no parameter 'zzz'; it reads height, speed",
    ["local p = ...\nprint(p.zz)"] = "zzz=3: scene.lua reads no parameter 'zzz' (did you mean 'zz'?); it reads zz",
    ["local function f(q) return q.speed end\nprint(f((...)))"] = "zzz=3: scene.lua reads no parameter 'zzz'; it reads "
      .. "speed",
  } do
    local status, _, complaint = run_script(text, "zzz=3")
    expect(status == 2 and complaint:find("hinge: " .. wanted .. "\n", 1, true), "%s\n    says   %s\n    wanted %s",
      text, complaint, wanted)
  end
  for _, text in ipairs { "local p = ...\nprint(p.zzz)", "print((...).zzz)", "for k in pairs(...) do print(k) end",
    "-- zzz\nlocal p <const> = ...\nlocal q = p\nprint(q.zzz)", "local p = ...\nprint('load'..p.zzz)",
    "local p = ...\nq = p\nload('print(q.zzz)')()" } do
    local status, _, complaint = run_script(text, "zzz=3")
    equal(status, 0, "read: " .. text .. ": " .. complaint)
  end
end)

case("an unread parameter is refused before the first statement where the text tells, else at the end", function()
  local with_load = [[
print "begins"
local p = ... or {}
local load = p.load or 5 -- load it
local hinge = require "hinge"
local model = hinge.model()
local foot, tip = model:node { 0, 0, 0 }, model:node { 1, 0, 0 }
model:fix(foot)
model:member { foot, tip, section = hinge.section.solid { width = 0.1, depth = 0.1 },
  material = hinge.material { E = 206e9, density = 7850 } }
print("load", 'load("x")', MORE)
model:load { node = tip, force = { 0, 0, -load } }
model:static { steps = 1 }:finish()
]]
  local at_end = with_load:gsub("MORE", "load, (function(q) return q.what end)(p)")
  local at_once = with_load:gsub("MORE", "load")
  for what, text in pairs { ["at once"] = at_once, ["at the end"] = at_end } do
    for _, verb in ipairs { "run", "plan" } do
      support.run("rm -rf " .. quote(folder .. "/out"))
      local status, printed, complaint = hinge_on(verb, text, "laod=3")
      equal(status, 2, verb .. ", " .. what)
      expect(complaint:find("laod=3: scene.lua reads no parameter 'laod' (did you mean 'load'?); it reads load", 1,
        true), "%s, %s: %s", verb, what, complaint)
      -- What has been computed by then stays, and its summary says what is wrong with it.
      local left = support.output(("cat %s/out/*/summary.json 2>/dev/null"):format(quote(folder)))
      if verb == "run" and what == "at the end" then
        local summary = support.json(left)
        equal(summary.verdict, "failed", "verdict of what was computed")
        expect(summary.reason:find "reads no parameter 'laod'", "its reason: %s", summary.reason)
      else
        equal(left, "", verb .. ", " .. what .. ": what is left")
      end
      if verb == "run" then equal(printed:find "begins" ~= nil, what == "at the end", "begins: " .. what) end
    end
    local status = hinge_on("run", text, "load=3")
    expect(status == 0 and support.is_there(folder .. "/out/scene-load=3/summary.json"), "%s, as it should be", what)
  end
end)

checks.done()
