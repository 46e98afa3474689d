-- What a script declares is what runs, or an error at its line: velocities after statics, loads with a history in
-- statics and over jumps, what is declared after a run was made, load cases, and parameters.
--
-- Run: lua5.4 tests/script/model/declared_test.lua BUILD_FOLDER
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local hinge = require "hinge"
local support = require "support"
local checks = support.checks "declared"
local case, expect, equal, near = checks.case, checks.expect, checks.equal, checks.near
local quote = support.quote

local steel = hinge.material { E = 200e9, nu = 0.3, density = 8000 }
local bar = hinge.section.solid { width = 0.05, depth = 0.05 }
local L, P = 2, 1000
local drop = P * L ^ 3 / (3 * steel.E * bar.Ix) + P * L / (steel.G * bar.shear_area_y) -- m, of the tip under P

local function cantilever(options)
  local model = hinge.model(options or { displacement = "small" })
  local foot, tip = model:node { 0, 0, 0 }, model:node { L, 0, 0 }
  model:fix(foot)
  local member = model:member { foot, tip, section = bar, material = steel, group = "arms" }
  return model, foot, tip, member
end
local function sag(run, tip) return -select(3, run:displacement(tip)) end

-- An error at the line of the call that holds this message ("..." for anything).
local function refused(message, call)
  local ok, complaint = pcall(call)
  if not expect(not ok, "no complaint; wanted: %s", message) then return end
  local line, text = tostring(complaint):match "declared_test%.lua:(%d+): (.*)$"
  local f = debug.getinfo(call, "S")
  line = math.tointeger(line)
  expect(line and line >= f.linedefined and line <= f.lastlinedefined, "not at its line: %s", tostring(complaint))
  expect(support.says(text or "", message), "\n    says   %s\n    wanted %s", text or tostring(complaint), message)
end

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
  refused("model:velocity: target is node 1, which supports hold in all directions of this velocity; ...",
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
      refused("model:static: nothing acts: all loads have a history, which is for dynamics; ...",
        function() model:static {} end)
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
  for key, value in pairs { duration = 1e-3, rest = false } do options[key] = options[key] or value end
  local run = model:dynamic(options):finish()
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
    for method, options in pairs { newmark = { dt = 1e-4 }, ["energy-momentum"] = { dt = 1e-4,
      integrator = "energy-momentum" }, damped = { dt = 1e-4, rho_infinity = 0.6 }, explicit = { dt = 1e-5,
      integrator = "explicit" }, controlled = { dt = 1e-4, step_control = 0.01 }, displacement = { dt = 1e-4,
      internals = { predictor = "displacement" } } } do
      if method ~= "energy-momentum" then -- which is for large displacement
        for _, on_member in ipairs { false, true } do
          local copy = { energy_tolerance = 0 }
          for key, value in pairs(options) do copy[key] = value end
          local run, momentum, energy = flying(pulse[1], copy, on_member)
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
  end
end)

case("explicit steps keep the impulse and the energy of a pulse of few steps", function()
  -- Explicit steps: what a jump leaves between energy and work is taken up, as large as the pulse is short.
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
  refused("model:load: field 'history' is three times at 1 s; a jump is two points: up to its time, and from there on",
    function()
      local model, _, tip = cantilever()
      model:load { node = tip, force = { 1, 0, 0 }, history = { { 1, 0 }, { 1, 2 }, { 1, 3 } } }
    end)
  refused("model:move: field 'x' is out of order at point 2 (time 1 s); times must rise", function()
    local model, foot = cantilever()
    model:move { node = foot, x = { { 1, 0 }, { 1, 2 } } }
  end)
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
          refused("run:step: " .. name .. " at ...declared_test.lua:... came after this run was made at "
            .. "...declared_test.lua:..., which does not know of it; declare it before, or make another run that "
            .. "goes on "
            .. "from this one (from = run)", call)
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
  for what, group in pairs { late = late, ["'late'"] = "late", arms = arms } do
    local name = what:match "%a+"
    refused("run:count: field 'group' is group '" .. name .. "', of which member 2 was declared after this run was "
      .. "made",
      function() run:count { state = "elastic", group = group } end)
    refused("run:read: group is group '" .. name .. "', of which member 2 was declared after this run was made",
      function() run:read("N", group) end)
  end
  refused("run:forces: member is member 2, declared after this run was made", function() run:forces(new) end)
  refused("member:state: this is member 2, declared after this run was made", function() new:state() end)
  refused("node:displacement: this is node 4, declared after this run was made", function() node:displacement() end)
  refused("run:reaction: node is node 3, fixed after this run was made", function() run:reaction(far) end)
  refused("node:reaction: this is node 3, fixed after this run was made", function() far:reaction() end)
  refused("run:read: a joint is node 3, fixed after this run was made", function() run:read "reaction_fz" end)
  equal(run:count { state = "elastic" }, 1, "members of the run")
  equal(#member:groups(), 1, "groups")
  near(select(3, foot:reaction(run)), 1, 1e-9, "what the run knows")
  refused("model:dynamic: field 'from' is a run of a structure with 4 nodes and 2 elements; ... add nothing ...",
    function() model:dynamic { from = run, dt = 1e-6, duration = 1e-6 } end)
end)

case("a run goes on only from one that is over and whose supports are unchanged", function()
  local model, _, tip = cantilever()
  model:load { node = tip, force = { 0, 0, -1 } }
  local rest = model:static { steps = 2 }
  refused("model:dynamic: field 'from' is a static run that has done 0 of 2 steps (made at ...); finish it first with "
    .. "run:finish(), or end it with run:stop() to go on from there",
    function() model:dynamic { from = rest, dt = 1e-6, duration = 1e-6 } end)
  rest:step()
  refused("model:static: field 'from' is a static run that has done 1 of 2 steps ...",
    function() model:static { from = rest } end)
  rest:stop()
  model:static { from = rest }
  rest = model:static { steps = 1 }:finish()
  model:fix(tip, "y")
  refused("model:dynamic: field 'from' is the run made at ...; node 2 at {2, 0, 0} m has been fixed since, ...",
    function() model:dynamic { from = rest, dt = 1e-6, duration = 1e-6 } end)
end)

-- Load cases ---------------------------------------------------------------------------------------------------------
local function loaded(options)
  local model, foot, tip, member = cantilever(options)
  local dead = model:case "dead"
  local live = model:case "live"
  local blast = model:case "blast"
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
      local s = loaded { displacement = size }
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
    -- statics that goes on: what was there is held
    local s = loaded { displacement = size }
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
    local s = loaded { displacement = size }
    -- dynamics: at rest under what is held, and what comes beside
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
    local s = loaded { displacement = size }
    -- the blast in full in statics goes on in full in the next
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
    local ok, message = pcall(function()
      if last == "none" then model:gravity { 1, 0, 0 } else other:gravity { 1, 0, 0 } end
    end)
    expect(not ok and tostring(message):find("gravity belongs to case 'dead' already, not to "
      .. (last == "none" and "no load case" or "case 'other'"), 1, true), "gravity in two cases: %s", message)
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
  refused("model:static: a load on node 2 at {2, 0, 0} m is a function of time and the run, ... put it into a load "
    .. "case that this run does not take", function() model:static { loads = "rule" } end)
end)

case("loads in a case with factor 1 give the bits of loads in no case", function()
  -- the same numbers as without cases, to the bit
  local function hash(in_case)
    local model, _, tip, member = cantilever {}
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
  refused("model:static: field 'loads': no load case 'daed' (did you mean 'dead'?); the model has 'dead', 'live', "
    .. "'blast', 'uls', 'all'", function() model:static { loads = { daed = 1 } } end)
  refused("model:dynamic: field 'loads': no load case 'ulss' (did you mean 'uls'?); ...",
    function() model:dynamic { dt = 1, duration = 1, loads = "ulss" } end)
  refused("model:static: field 'loads': 'dead' is 'one'; must be a finite number, its factor",
    function() model:static { loads = { dead = "one" } } end)
  refused("model:static: field 'loads': 'dead' is not a number (nan); must be a finite number, its factor",
    function() model:static { loads = { dead = 0 / 0 } } end)
  refused("model:static: field 'loads': 1 = 'dead'; write { name = factor, ... }, such as { dead = 1.35, live = 1.5 }",
    function() model:static { loads = { "dead" } } end)
  refused("model:static: field 'loads' is 3; must be { name = factor, ... }, ...",
    function() model:static { loads = 3 } end)
  refused("model:static: the model has load cases, and this run does not say whether it takes 'dead', 'live', 'blast'; "
    .. "give loads = { dead = 1, ... }, or the name of a combination", function() model:static {} end)
  local rest = model:static { steps = 1, loads = "dead" }:finish()
  model:case "wind"
  refused("model:dynamic: the model has load cases, and this run does not say whether it takes 'wind'; ...; what the "
    .. "run before had goes on", function() model:dynamic { from = rest, dt = 1e-6, duration = 1e-6 } end)
  model:dynamic { from = rest, dt = 1e-6, duration = 1e-6, loads = { wind = 0 } }
  refused("model:load: field 'case': no load case 'snow'; the model has 'dead', ...",
    function() model:load { node = s.tip, force = { 1, 0, 0 }, case = "snow" } end)
  refused("model:load: field 'case' is load case 'dead' of another model; use one of this model",
    function() model:load { member = s.member, q = { 1, 0, 0 }, case = other.dead } end)
  refused("model:static: field 'loads' is load case 'dead' of another model; use one of this model",
    function() model:static { loads = other.dead } end)
  refused("case:load: field 'case' is given; this load belongs to load case 'dead' already; leave it out",
    function() s.dead:load { node = s.tip, force = { 1, 0, 0 }, case = "live" } end)
  refused("model:case: the name is 3; must be a string, such as 'dead'", function() model:case(3) end)
  refused("model:case: there is a combination 'uls' already", function() model:case "uls" end)
  refused("model:combination: there is a load case 'live' already",
    function() model:combination("live", { dead = 1 }) end)
  refused("model:combination: there is a combination 'uls' already",
    function() model:combination("uls", { dead = 1 }) end)
  refused("model:combination: 'new': no load case 'x'; the model has ...",
    function() model:combination("new", { x = 1 }) end)
  refused("model:combination: 'new' is empty; give { name = factor, ... }",
    function() model:combination("new", {}) end)
  equal(model:case "dead", s.dead, "a case again")
  equal(#model:cases(), 4, "cases")
  equal(tostring(s.live), "load case 'live'", "text")
  equal(model:loads()[1].case, "dead", "case of a load")
  refused("model:static: field 'loads' is given; the model has no load cases; declare one with model:case \"name\"",
    function() cantilever():static { loads = {} } end)
  other.model:close()
  refused("case:gravity: this is load case '' of a model that was closed at ...",
    function() other.dead:gravity { 0, 0, -1 } end)
end)

case("calls refuse arguments and fields that they would not read", function()
  local model, foot, tip, member = cantilever()
  refused("model:node: position has a field 'mass'; must be {x, y, z} in m and nothing else",
    function() model:node { 0, 0, 0, mass = 3 } end)
  refused("model:gravity: acceleration has a field 'x'; must be {x, y, z} in m/s^2 and nothing else",
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
    refused(name .. ": takes no argument, got also ...", call)
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
  local gap = "...; "
  local large = cantilever {}
  local function short(options)
    options.dt, options.duration = 1e-6, 1e-5
    return options
  end
  for message, call in pairs {
    ["hinge.section.box: takes no further argument, got also 3"] = function()
      hinge.section.box({ width = 1, depth = 1, thickness = 0.1 }, 3)
    end,
    ["hinge.ground: takes no further argument, got also 3"] = function()
      hinge.ground({ dt = 1, acceleration = { 0, 0 } }, 3)
    end,
    ["hinge.scenario: takes no further argument, got also 3"] = function() hinge.scenario({ run = print }, 3) end,
    ["hinge.material: field 'G' is 1 Pa; is given beside nu, ..."] = function()
      hinge.material { E = 1, nu = 0, G = 1 }
    end,
    ["hinge.model: field 'shift' is 'elastic_and_plastic'; has no meaning with formulation 'conventional', "
      .. "..."] = function()
      hinge.model { formulation = "conventional", shift = "elastic_and_plastic" }
    end,
    ["model:fix: the list of nodes is empty" .. gap .. "..."] = function() model:fix {} end,
    ["model:move: field 'node' is an empty list; ..."] = function() model:move { node = {}, x = math.sin } end,
    ["model:contact: field 'groups' is an empty list; no members would meet; leave it out"] = function()
      model:contact { groups = {} }
    end,
    ["model:member: field 'group' is 'q' twice; give each group once"] = function()
      model:member { foot, tip, section = bar, material = steel, group = { "q", "p", "q" } }
    end,
    ["model:connector: field 'capacity' is given for y; nothing acts in that direction, so it never ..."] =
      function() model:connector { tip, ground = true, stiffness = { x = 1 }, capacity = { x = 1, y = 2 } } end,
    ["model:damping: field 'ratio' holds a field 'x', which is not one of its items 1 to 2"] = function()
      model:damping { ratio = { 0.02, 0.03, x = 1 }, periods = { 1, 0.1 } }
    end,
    ["model:fracture: field 'keep' holds a field 'x', which is not one of its items 1 to 1"] = function()
      model:fracture { rule = print, keep = { "a", x = "b" } }
    end,
    ["model:fracture: field 'keep' is 'a' twice; give each name once"] = function()
      model:fracture { rule = print, keep = { "a", "a" } }
    end,
    ["model:dynamic: field 'internals': field 'solver_tolerance' ... solver = 'direct'; ..."] = function()
      large:dynamic(short { solver = "direct", internals = { solver_tolerance = 1e-3 } })
    end,
    ["model:dynamic: field 'internals': field 'solver_iterations' ... solver = 'direct'; ..."] = function()
      large:dynamic(short { solver = "direct", internals = { solver_iterations = 3 } })
    end,
    ["model:dynamic: field 'tolerance' is 0.001; is that of Newton's method, and iterations = 1 ..."] =
      function() large:dynamic(short { iterations = 1, tolerance = 1e-3 }) end,
    ["model:dynamic: field 'rest' is true; integrator = 'energy-momentum' leaves no body ..."] =
      function() large:dynamic(short { integrator = "energy-momentum", rest = true }) end,
    ["model:static: the model has gravity, and nothing in it has mass: ..."] = function()
      local light = hinge.model {}
      local a, b = light:node { 0, 0, 0 }, light:node { 1, 0, 0 }
      light:fix(a)
      light:member { a, b, section = bar, material = hinge.material { E = 1e9 } }
      light:gravity { 0, 0, -9.8 }
      light:static {}
    end,
  } do
    refused(message, call)
  end
  model:ground { point = { 0, 0, -1 } }
  model:ground { point = { 0, 0, -2 } }
  refused("model:ground: this plane is declared already, for the same members; ...",
    function() model:ground { point = { 0, 0, -1 }, normal = { 0, 0, 2 } } end)
  model:load { node = tip, force = { 0, 0, -1 } }
  local run = model:static { steps = 1 }
  run:probe { node = tip, "uz", name = "tip" }
  for _, name in ipairs { "tip", "time", "factor", "energy_error", "kinetic" } do
    refused("run:probe: field 'name' is '" .. name .. "'; there is a column of history.csv with that name already; ...",
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
      text,
      complaint, wanted)
  end
  for _, text in ipairs { "local p = ...\nprint(p.zzz)", "print((...).zzz)", "for k in pairs(...) do print(k) end",
    "-- zzz\nlocal p <const> = ...\nlocal q = p\nprint(q.zzz)", "local p = ...\nprint('load'..p.zzz)",
    "local p = ...\nq = p\nload('print(q.zzz)')()" } do
    local status, _, complaint = run_script(text, "zzz=3")
    equal(status, 0, "read: " .. text .. ": " .. complaint)
  end
end)

case("an unread parameter is refused before the first statement where the text tells, else at the end", function()
  -- One that no name of the script is like is refused before the first statement where the text tells, else at the end.
  -- hinge plan says so too.
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
