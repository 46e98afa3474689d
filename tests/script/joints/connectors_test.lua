-- Connectors against closed forms: springs, dashpots, curves, laws and breaks, in statics and in both ways of steps;
-- momentum, energy, undo, checkpoints, and what is refused.
--
-- Run: lua5.4 tests/script/joints/connectors_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local hinge = require "hinge"
local scenes = require "scenes"
local checks = support.checks "connectors"
local case, expect, equal, near, largest_of = checks.case, checks.expect, checks.equal, checks.near, support.largest_of

local steel = scenes.elastic
local bar = scenes.square
local pi = math.pi

-- Statics -------------------------------------------------------------------------------------------------------------

-- A bar along x, free to slide only, held by what `ends` declares at its right end.
local function sliding_bar(options)
  local model = hinge.model(options or { displacement = "small" })
  local left, right = model:node { 0, 0, 0 }, model:node { 1, 0, 0 }
  model:fix({ left, right }, "yz rx ry rz")
  model:member { left, right, section = bar, material = steel }
  return model, left, right
end
local EA = 206e9 * 0.05 ^ 2

for _, displacement in ipairs { "small", "large" } do
  case("springs at the end of a bar carry by their stiffness in statics: " .. displacement, function()
    local model, left, right = sliding_bar { displacement = displacement }
    local k, F = 3e8, 1e5
    local c = model:connector { left, ground = true, stiffness = { x = k } }
    model:load { node = right, force = { F, 0, 0 } }
    local run = model:static { steps = 3 }:finish()
    near(run:displacement(right), F / k + F / EA, 1e-7 * F / EA, displacement .. ": a spring and a bar in series")
    near(c:force(run), F, 1e-7 * F, displacement .. ": force of the spring")
    near(c:deformation(run), F / k, 1e-7 * F / k, displacement .. ": its deformation")
    near(run.energy.connector_stored, F ^ 2 / (2 * k), 1e-6 * F ^ 2 / k, displacement .. ": its energy")
    near(run.energy.connectors, run.energy.connector_stored, 0, displacement .. ": the account is the sum of its parts")
    near(run.energy.energy_error, 0, 1e-6 * run.energy.work, displacement .. ": energy balance")
  end)
end

case("a connector of stiffness EA / L acts as a member, in axes of its own", function()
  local function tip(as_member)
    local model = hinge.model { displacement = "small" }
    local a, b = model:node { 0, 0, 0 }, model:node { 0.6, 0.8, 0 }
    local c, d = model:node { 1.2, 1.6, 0 }, model:node { 1.8, 2.4, 0 }
    model:fix(a)
    for _, n in ipairs { b, c, d } do model:fix(n, "z rx ry rz") end
    model:member { a, b, section = bar, material = steel }
    model:member { c, d, section = bar, material = steel }
    local x, y = { 3, 4, 0 }, { -4, 3, 0 }
    if as_member then
      model:member { b, c, section = bar, material = steel }
    else
      local GA, EI = 206e9 / 2.6 * bar.shear_area_x, 206e9 * bar.Iy
      -- between nodes that do not turn a member resists sideways with 1 / (L^3 / (12 E I) + L / (k G A))
      model:connector { b, c, axes = { x = x, y = y }, stiffness = { x = EA, y = 1 / (1 / (12 * EI) + 1 / GA) } }
    end
    model:load { node = d, force = { 2e4, -5e3, 0 } }
    local run = model:static { steps = 1 }:finish()
    return run:displacement(d)
  end
  local ux, uy = tip(true)
  local vx, vy = tip(false)
  near(vx / ux, 1, 1e-7, "a connector as stiff as a member, ux")
  near(vy / uy, 1, 1e-7, "a connector as stiff as a member, uy")
end)

case("a force law with a kink gives its force and the energy below it", function()
  for _, sign in ipairs { 1, -1 } do
    local model, left, right = sliding_bar()
    local c = model:connector { left, right, stiffness = { x = 0 }, curve = { x = { { 0, 0 }, { 1, 1 } } } }
    local weak = model:connector { left, ground = true,
      curve = { x = { { 0, 0 }, { 1e-3, 2e4 }, { 5e-3, 3e4 } } } }
    model:load { node = left, force = { sign * 2.5e4, 0, 0 } }
    local run = model:static { steps = 5 }:finish()
    near(run:displacement(left), sign * 3e-3, 1e-9, "a curve with a kink: the place")
    near(weak:force(run), sign * 2.5e4, 1e-2, "its force")
    near(run.energy.connector_stored, 0.5 * 1e-3 * 2e4 + 0.5 * (2e4 + 2.5e4) * 2e-3, 1e-4, "the area under it")
    expect(math.abs(c:force(run)) < 1e-6, "a connector that nothing stretches has no force: %s", c:force(run))
  end
end)

-- Elastic steps that take many iterations are unloaded again, to see whether they come back.
for _, steps in ipairs { 1, 20 } do
  case(("a force law has the force of its deformation after long steps: %d"):format(steps), function()
    local model, tip = scenes.cantilever { model = { elements_per_member = 4 }, length = 3, force = { 0, 0, -1500 },
      member = { section = hinge.section.solid { width = 0.02, depth = 0.02 } } }
    local function law(u) return 1e3 * u + 2e2 * u ^ 3 end
    local c = model:connector { tip, ground = true, law = { z = law } }
    local run = model:static { steps = steps }:finish()
    local u, F = select(3, c:deformation(run)), select(3, c:force(run))
    expect(u < -0.9, "the tip has moved by %g m", u)
    near(F, law(u), 1e-12 * math.abs(law(u)), "force of the law")
  end)
end

case("a curve given for both signs acts by its sign", function()
  local model, left = sliding_bar()
  local c = model:connector { left, ground = true,
    curve = { x = { { -1e-3, -1e3 }, { 0, 0 }, { 1e-3, 5e3 }, { 2e-3, 6e3 } } } }
  local load = model:load { node = left, force = { -500, 0, 0 } }
  local run = model:static { steps = 1 }:finish()
  near(c:deformation(run), -5e-4, 1e-10, "the branch below zero")
  near(run.energy.connector_stored, 0.5 * 500 * 5e-4, 1e-8, "its energy")
  load:remove()
  model:load { node = left, force = { 8e3, 0, 0 } }
  run = model:static { steps = 1 }:finish()
  near(c:deformation(run), 4e-3, 1e-9, "beyond its end a curve goes on as straight as it ends")
  near(run.energy.connector_stored, 2.5 + 5.5 + 14, 1e-6, "and the energy there")
end)

-- A break, stretched and pressed: what was stored is released. The capacity lies between two steps of a displacement
-- that is prescribed.
for what, sign in pairs { stretched = 1, pressed = -1 } do
  case("a connector that breaks releases what it stored: " .. what, function()
    local model, left, right = sliding_bar()
    local k, capacity = 1e7, 1e4
    model:fix(left)
    local c = model:connector { right, ground = true, stiffness = { x = k }, capacity = { x = capacity } }
    local target = sign * capacity / k * 1.0005
    model:load { node = right, force = { 1, 0, 0 } }
    local run = model:static { steps = 2001, control = { node = right, "ux", to = target } }:finish()
    equal(run.verdict, "completed", what .. ": verdict after a break")
    expect(c:broken(run), "a connector %s past its capacity is broken", what)
    equal(c:force(run), 0, "a broken connector has no force")
    near(run.energy.connector_dissipated / (capacity ^ 2 / (2 * k)), 1, 2e-3, "a break releases F^2 / 2k")
    near(run.energy.connector_stored, 0, 1e-12, "and nothing is stored any more")
    local change = run.state_changes[1]
    near(change and change.why:find "connector 1 between the ground and .* broke" or 0, 1, 0,
      "the run tells of it")
  end)
end

-- Dynamics ------------------------------------------------------------------------------------------------------------

case("a bar on a spring and a dashpot swings and decays as theory has it", function()
  -- A short bar that slides along x on a spring and a dashpot: m u'' + c u' + k u = 0 from u'(0) = 1 m/s.
  local function slide(options)
    local model = hinge.model { displacement = options.displacement or "small" }
    local a, b = model:node { 0, 0, 0 }, model:node { 0.1, 0, 0 }
    model:fix({ a, b }, "yz rx ry rz")
    model:member { a, b, section = bar, material = steel, group = "body" }
    model:velocity("body", { 1, 0, 0 })
    local m = 7850 * 0.05 ^ 2 * 0.1
    local omega, ratio = 2 * pi * 50, options.ratio
    local declared = { a, ground = true, stiffness = { x = m * omega ^ 2 } }
    if ratio > 0 then declared.damping = { x = 2 * ratio * omega * m } end
    local c = model:connector(declared)
    local run = model:dynamic { integrator = options.integrator, dt = options.dt, duration = 0.04,
      step_control = options.step_control }
    local damped, worst, worst_balance = omega * math.sqrt(1 - ratio ^ 2), 0, 0
    for step in run:steps() do
      local u = math.exp(-ratio * omega * step.time) * math.sin(damped * step.time) / damped
      worst = largest_of(worst, math.abs(run:displacement(a) - u) * damped)
      worst_balance = largest_of(worst_balance, math.abs(run.energy.energy_error))
    end
    return worst, worst_balance / (0.5 * m), run, c
  end
  for _, displacement in ipairs { "small", "large" } do
    for _, ratio in ipairs { 0, 0.05, 0.3 } do
      local what = ("%s displacement, %g of critical damping: "):format(displacement, ratio)
      -- m (w dt)^2 / 12 of the period is Newmark's own error
      local worst, balance, run = slide { displacement = displacement, ratio = ratio, dt = 2e-5 }
      expect(worst < 5e-4, "%sNewmark: off by %g of the amplitude", what, worst)
      expect(balance < 1e-6, "%sNewmark: energy balance off by %g", what, balance)
      if ratio > 0 then
        expect(run.energy.connector_dissipated > 0, "%sdissipates", what)
      end
      worst, balance = slide { displacement = displacement, ratio = ratio, dt = 2e-6, integrator = "explicit" }
      expect(worst < 5e-4, "%sexplicit: off by %g of the amplitude", what, worst)
      expect(balance < 1e-4, "%sexplicit: energy balance off by %g", what, balance)
    end
  end
end)

-- Coulomb's friction by a law: 4 F u in each cycle that a moved support drags it through.
local function rubs(F, stick)
  return function(u, _, state)
    local force = stick * (u - (state.stands or 0))
    if math.abs(force) <= F then return force, state end
    force = force > 0 and F or -F
    return force, { stands = u - force / stick }
  end
end
for _, integrator in ipairs { "newmark", "explicit" } do
  case("friction by a force law takes 4 F u a cycle: " .. integrator, function()
    local model, left = sliding_bar()
    local F, amplitude, period = 1e3, 2e-3, 0.02
    model:connector { left, ground = true, law = { x = rubs(F, 1e9) } }
    model:fix(left)
    model:move { node = left, x = function(t) return 0.5 * amplitude * (1 - math.cos(2 * pi * t / period)) end }
    local run = model:dynamic { integrator = integrator, dt = integrator == "explicit" and 2e-6 or 1e-5,
      duration = 3 * period }
    local at = {}
    for step in run:steps() do
      local cycles = step.time / period
      if math.abs(cycles - math.floor(cycles + 0.5)) < 1e-6 then at[#at + 1] = run.energy.connector_dissipated end
    end
    equal(run.verdict, "completed", integrator .. ", friction: " .. tostring(run.reason))
    near((at[3] - at[2]) / (4 * F * amplitude / 2), 1, 3e-3, integrator .. ": friction takes 4 F u in a cycle")
    near(run.energy.energy_error / run.energy.connector_dissipated, 0, 1e-3, integrator .. ", friction: energy balance")
  end)
end

-- Two bars that fly and spin, joined by a connector across a gap: momentum stays, and so does energy.
local function spinning(options, declare)
  local model = hinge.model {}
  local a, b = model:node { 0, 0, 0 }, model:node { 0.5, 0, 0 }
  local c, d = model:node { 0.7, 0.1, 0 }, model:node { 0.8, 0.6, 0.2 }
  model:member { a, b, section = bar, material = steel, group = "all" }
  model:member { c, d, section = bar, material = steel, group = "all" }
  model:velocity("all", { 3, 1, 0 }, { 4, -7, 30 })
  declare(model, b, c)
  return model:dynamic(scenes.with({ dt = 2e-5, duration = 0.02 }, options))
end
local soft = { x = 2e6, y = 1e6, z = 1e6, rx = 2e4, ry = 1e4, rz = 3e4 }
for _, integrator in ipairs { "newmark", "explicit" } do
  case("two spinning bars joined by a connector keep momentum and energy: " .. integrator, function()
    local run = spinning({ integrator = integrator, dt = integrator == "explicit" and 1e-6 or 4e-6 },
      function(model, b, c) model:connector { b, c, stiffness = soft, axes = { x = { 2, 1, 0 }, y = { 0, 1, 1 } } } end)
    local before = run:momentum()
    local scale, most = 0, 0
    for i = 1, 3 do scale = scale + math.abs(before.angular[i]) end
    for _ in run:steps() do most = largest_of(most, run.energy.connector_stored / run.energy.initial) end
    local after = run:momentum()
    for i = 1, 3 do
      near(after.linear[i], before.linear[i], 1e-9 * 100, integrator .. ": linear momentum " .. i)
      near(after.angular[i] / scale, before.angular[i] / scale, 2e-4, integrator .. ": angular momentum " .. i)
    end
    expect(most > 1e-3, "%s: the connector takes part: %g of the energy", integrator, most)
    near(run.energy.energy_error / run.energy.initial, 0, 1e-4, integrator .. ": energy of two bars that spin")
  end)
end

-- Breaks in flight, laws and dashpots: a checkpoint in the middle gives the same bits, and so does undo.
local folder = support.temporary_folder()
local function all_of_it(model, b, c)
  model:connector { b, c, stiffness = soft, damping = { x = 200, rz = 1 }, capacity = { z = 1500 } }
  model:connector { b, c, law = { y = rubs(500, 1e6) }, curve = { z = { { 0, 0 }, { 1e-3, 1e3 }, { 1e-2, 2e3 } } } }
end
case("checkpoints and steps taken back change no bit of connectors", function()
  for _, options in ipairs { {}, { step_control = 1e-4 }, { integrator = "explicit", dt = 1e-6 } } do
    local what = ("%s, step control %s: "):format(options.integrator or "newmark", tostring(options.step_control))
    local whole = spinning(options, all_of_it):finish()
    equal(whole.verdict, "completed", what .. tostring(whole.reason))
    local half = spinning(options, all_of_it)
    for step in half:steps() do if step.time > 0.01 then break end end
    half:checkpoint(folder .. "/one.checkpoint")
    local other = spinning(options, all_of_it):resume(folder .. "/one.checkpoint"):finish()
    equal(other.hash, whole.hash, what .. "state after a checkpoint")
    equal(other.energy.connector_dissipated, whole.energy.connector_dissipated, what .. "account after a checkpoint")
    near(whole.energy.energy_error / whole.energy.initial, 0, 2e-3, what .. "energy balance")
  end
end)

case("a force law that fails takes its step back and the run goes on", function()
  local fails = false
  local function declare(model, b, c)
    model:connector { b, c, stiffness = soft, law = { y = function(u, v, state)
      if fails then error "no" end
      return 1e5 * u + 10 * v, { calls = (state.calls or 0) + 1 }
    end } }
  end
  local whole = spinning({ duration = 2e-3 }, declare):finish()
  local run = spinning({ duration = 2e-3 }, declare)
  for step in run:steps() do if step.index == 50 then break end end
  local hash = run.hash
  fails = true
  local ok, message = pcall(run.finish, run)
  expect(not ok and message:find "no" and message:find "taken back", "a law that fails: %s", message)
  equal(run.hash, hash, "the step was taken back")
  fails = false
  run:finish()
  equal(run.hash, whole.hash, "and the run goes on as if it had not failed")
end)

case("a connector that carries nothing changes no bit", function()
  local function portal(declare)
    local model, left, right = sliding_bar {}
    model:load { node = right, force = { 1e4, 0, 0 } }
    model:fix(left)
    if declare then declare(model, left) end
    return model:dynamic { dt = 1e-5, duration = 1e-3 }:finish().hash
  end
  local plain = portal()
  equal(portal(function(model, left) model:connector { left, ground = true, stiffness = { x = 1e6 } } end), plain,
    "a connector on a fixed node changes no bit")
  local core = require "hinge.core"
  core.leave_out "connectors"
  equal(portal(function(model, left) model:connector { left, ground = true, stiffness = { y = 1e6 },
    law = { x = function() error "asked" end } } end), plain, "left out, it is not asked")
  core.leave_out(nil)
end)

-- What is refused -----------------------------------------------------------------------------------------------------

case("wrong connectors are refused", function()
  local model, left, right = sliding_bar()
  for _, row in ipairs {
    { {}, "it would do nothing" },
    { { [2] = left, stiffness = { x = 1 } }, "both nodes are node 1" },
    { { ground = true, stiffness = { x = 1 } }, "ground", "two nodes are given" },
    { { stiffness = { x = -1 } }, "stiffness", "-1", "N/m" },
    { { damping = { rx = 0 / 0 } }, "damping", "rx", "N m s/rad" },
    { { stiffness = { q = 1 } }, "unknown field 'q'" },
    { { capacity = { x = 0 }, stiffness = { x = 1 } }, "capacity", "x" },
    { { curve = { x = { { 0, 0 }, { 0, 1 } } } }, "point 2", "must rise" },
    { { curve = { x = { { 1, 0 }, { 2, 1 } } } }, "begins with {0, 0}" },
    { { law = { x = 3 } }, "law", "must be a function" },
    { { axes = { x = { 1, 0, 0 }, y = { 2, 0, 0 } }, stiffness = { x = 1 } }, "not along one line" },
  } do
    checks.refused({ table.unpack(row, 2) }, model.connector, model, scenes.with({ left, right }, row[1]))
  end
  model:fix(left)
  expect(model:static { steps = 1 } ~= nil, "what was refused is not in the model")
end)

case("the explicit step limit of a stiff connector is named", function()
  local function limit(dt)
    local model, left = sliding_bar()
    model:connector { left, ground = true, stiffness = { x = 1e12 } }
    return pcall(model.dynamic, model, { integrator = "explicit", dt = dt, duration = 1e-4 })
  end
  local m = 7850 * 0.05 ^ 2 / 6  -- a sixth of the bar hangs on its end: two elements
  local function stable_up_to(_, message) return tonumber(tostring(message):match "stay stable up to (%S+) s") or 0 end
  local of_elements = 2 / stable_up_to(pcall(sliding_bar().dynamic, sliding_bar(),
    { integrator = "explicit", dt = 1, duration = 2 }))
  local longest = 2 / math.sqrt(1e12 / m + of_elements ^ 2)
  near(stable_up_to(limit(1.001 * longest)) / longest, 1, 1e-5, "too long an explicit step")
  expect(limit(0.999 * longest), "a step just below the limit")
end)

-- dt = "auto" with many connectors at a node, beside one another and in a chain: no single one of them asks for so
-- short a step. What is thrown against them swings, and does not grow.
case("explicit dt = auto with many connectors at a node is stable and not too short", function()
  local k, c, m = 1e12, 4e5, 7850 * 0.05 ^ 2 * 0.1 / 6
  local function bodies(n)
    local model, ends = hinge.model { displacement = "small" }, {}
    for i = 1, n do
      local a, b = model:node { 0.3 * i, 0, 0 }, model:node { 0.3 * i + 0.1, 0, 0 }
      model:fix({ a, b }, "yz rx ry rz")
      model:member { a, b, section = bar, material = steel }
      model:velocity(a, { i % 2 == 0 and 1 or -1, 0, 0 })
      ends[i] = a
    end
    return model, ends
  end
  local function declare(kind, model, ends, with)
    for i = 1, kind == "parallel" and 12 or #ends - 1 do
      with[1], with[2] = ends[kind == "chain" and i or 1], ends[kind == "parallel" and 2 or i + 1]
      model:connector(with)
    end
  end
  local none = bodies(2):dynamic { integrator = "explicit", dt = "auto", duration = 1e-3 }.dt
  -- squares of the highest frequencies of the springs alone, of masses m
  local squares = { chain = 2 * k / m * (1 + math.cos(pi / 8)), parallel = 2 * 12 * k / m, star = 8 * k / m }
  for kind, square in pairs(squares) do
    local model, ends = bodies(kind == "parallel" and 2 or 8)
    -- half of it as a spring, half as a curve's steepest piece
    declare(kind, model, ends, { stiffness = { x = k / 2 },
      curve = { x = { { 0, 0 }, { 1e-6, k / 2 * 1e-6 }, { 2e-6, k / 2 * 1.5e-6 } } } })
    local run = model:dynamic { integrator = "explicit", dt = "auto", duration = 2e-3, energy_tolerance = 0,
      record = false }
    local fastest = 0
    for _ in run:steps() do
      for _, node in ipairs(ends) do fastest = support.largest_of(fastest, math.abs((run:velocity(node)))) end
    end
    equal(run.verdict, "completed", kind .. ", explicit: " .. run.reason)
    -- all of the energy in one end: the root of 8 bars of 4 m each; at 0.9 of the limit 1 / (1 - 0.81) of it may show
    expect(fastest < math.sqrt(8 * 4 / 0.19), "%s, explicit: it swings up to %g m/s", kind, fastest)
    near(run.dt / (0.9 * 2 / math.sqrt(square)), 1, 0.05, kind .. ", explicit: the step, of what springs alone allow")
    expect(run.dt < 0.5 * none, "%s, explicit: %g s, without %g s", kind, run.dt, none)
    -- and a step that one of them alone would allow is refused
    expect(not pcall(model.dynamic, model, { integrator = "explicit", dt = 0.99 * 2 / math.sqrt(2 * k / m),
      duration = 1e-4 }), "%s, explicit: a step for one alone", kind)
    -- Newmark's steps stay stable, but are to follow what swings: 0.9 rad a step, with a quarter of the bar on its end
    local newmark = model:dynamic { dt = "auto", duration = 1e-3, record = false }
    near(newmark.dt / (0.9 / math.sqrt(square * 4 / 6)), 1, 0.02, kind .. ", newmark: the step")
  end
  for _, kind in ipairs { "chain", "parallel" } do -- dashpots alone
    local model, ends = bodies(kind == "chain" and 8 or 2)
    declare(kind, model, ends, { damping = { x = c } })
    local run = model:dynamic { integrator = "explicit", dt = "auto", duration = 1e-3, energy_tolerance = 0,
      record = false }:finish()
    equal(run.verdict, "completed", kind .. " of dashpots: " .. run.reason)
    expect(run.energy.kinetic + run.energy.elastic < 0.5 * run.energy.initial, "%s of dashpots: %g of %g J left", kind,
      run.energy.kinetic + run.energy.elastic, run.energy.initial)
  end
  -- soft ones leave the step as it is
  for _, integrator in ipairs { "explicit", "newmark" } do
    local options = { integrator = integrator, dt = "auto", duration = 1e-3 }
    local plain = bodies(2):dynamic(options).dt
    local model, ends = bodies(2)
    model:connector { ends[1], ends[2], stiffness = { x = 1e3 } }
    near(model:dynamic(options).dt / plain, 1, 1e-3, integrator .. ": the step with a soft connector")
  end
end)

case("the plan says that force laws are asked", function()
  local model, left = sliding_bar()
  model:connector { left, ground = true, law = { x = function() return 0 end } }
  for _, effect in ipairs(model:dynamic { dt = 1e-5, duration = 1e-4 }.effects) do
    if effect.name == "script functions" then
      equal(effect.active and effect.because, "a connector's law", "plan of a law")
    end
  end
end)

checks.done()
