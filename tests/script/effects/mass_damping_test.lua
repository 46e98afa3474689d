-- Rayleigh damping of point masses: decay against closed forms, mean of groups, breaking, checkpoints, energy.
--
-- Run: lua5.4 tests/script/effects/mass_damping_test.lua
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local scenes = require "scenes"
local hinge = require "hinge"
local checks = support.checks "damping of point masses"
local case, equal, near = checks.case, checks.equal, checks.near
local folder = support.temporary_folder()

local section = scenes.square
local function steel(density) return hinge.material { E = 206e9, nu = 0.3, density = density or 7850 } end
local function done(run, what)
  run:finish()
  equal(run.verdict, "completed", what .. ": " .. tostring(run.reason))
  return run
end

case("a heavy mass on a light cantilever is damped as a single degree of freedom", function()
  -- the mean over four periods of the logarithm of the energy falls by 8 z w T
  local stiffness = 3 * 206e9 * section.Ix / (1 + 3 * 206e9 * section.Ix / (206e9 / 2.6 * section.shear_area_y))
  local function on_cantilever(options)
    local model, tip = scenes.cantilever { member = { material = steel(785), up = { 0, 0, 1 } } }
    model:mass { node = tip, mass = 200, inertia = options.inertia, offset = options.offset }
    local T = 2 * math.pi * math.sqrt(200 / stiffness)
    model:damping(options.damping(T))
    model:velocity(tip, { 0, 0, 0.01 }, options.spin)
    local explicit = options.integrator == "explicit"
    local run = model:dynamic { dt = explicit and "auto" or T / 200, duration = 12 * T, integrator = options.integrator,
      record = false, rest = false }
    local sum, steps = { 0, 0, 0 }, { 0, 0, 0 }
    for step in run:steps() do
      if not explicit or step.index % 16 == 0 then
        local part = math.min(3, math.ceil(step.time / (4 * T)))
        sum[part] = sum[part] + math.log(run.energy.kinetic + run.energy.elastic)
        steps[part] = steps[part] + 1
      end
    end
    equal(run.verdict, "completed", "cantilever: " .. tostring(run.reason))
    return (sum[1] / steps[1] - sum[3] / steps[3]) / (32 * math.pi), run
  end
  local by_ratio = { damping = function(T) return { ratio = 0.02, periods = { T, T / 10 } } end }
  local function by_alpha(T) return { alpha = 0.04 * 2 * math.pi / T } end -- all modes fall alike
  local beside = { inertia = { 30, 10, 5 }, offset = { 0.2, 0.3, 0.1 }, spin = { 0.01, 0.02, -0.03 }, damping =
    by_alpha }
  for _, row in ipairs {
    { "newmark", by_ratio }, { "energy-momentum", by_ratio }, { "explicit", { damping = by_alpha } },
    { "newmark", beside }, { "energy-momentum", beside }, { "explicit", beside },
  } do
    local options = row[2]
    options.integrator = row[1]
    local ratio, run = on_cantilever(options)
    local what = options.integrator .. (options.offset and ", beside its node, with rotary inertia" or "")
    print(("%-55s %.4f %%, open by %.2g"):format(what, 100 * ratio, run.energy.energy_error / run.energy.initial))
    near(ratio / 0.02, 1, 0.01, what .. ": ratio")
    local e = run.energy
    near(e.energy_error / e.initial, 0, 1e-4, what .. ": balance")
    near(e.damping / (e.initial - e.kinetic - e.elastic), 1, 1e-3, what .. ": account")
  end
end)

-- What tumbles through space: under alpha both its momenta fall as exp(-alpha t), whatever its inertia.
local function tumbling(options)
  local model = hinge.model { elements_per_member = 2 }
  local a, b = model:node { 0, 0, 0 }, model:node { 0.5, 0, 0 }
  model:member { a, b, section = section, material = steel() }
  model:mass { node = a, mass = 30, inertia = { 1, 3, 2 }, offset = { 0, 0.3, 0.1 } }
  model:mass { node = b, mass = 20, inertia = 1 }
  model:velocity(a, { 1, 2, 3 }, { 3, 5, 2 })
  model:damping { alpha = 2 }
  return model:dynamic { dt = options.dt or 1e-4, duration = 0.3, integrator = options.integrator, record = false,
    rest = false, checkpoint = options.checkpoint }
end
case("a tumbling body is damped in its momenta alone", function()
  local function momenta(run)
    local m = run:momentum()
    local all = {}
    for i = 1, 3 do all[i], all[3 + i] = m.linear[i], m.angular[i] end
    return all
  end
  local function size(v)
    local sum = 0
    for _, x in ipairs(v) do sum = sum + x * x end
    return math.sqrt(sum)
  end
  for integrator, dt in pairs { newmark = 1e-4, explicit = 1e-5, ["energy-momentum"] = 5e-4 } do
    local run = tumbling { integrator = integrator, dt = dt }
    local before = momenta(run)
    done(run, integrator)
    local after, off = momenta(run), {}
    for i = 1, 6 do off[i] = after[i] - before[i] * math.exp(-0.6) end
    print(("%-55s off by %.2g, open by %.2g"):format("tumbling, " .. integrator, size(off) / size(before),
      run.energy.energy_error / run.energy.initial))
    near(size(off) / size(before), 0, 1e-4, integrator .. ": momenta")
    near(run.energy.energy_error / run.energy.initial, 0, 1e-3, integrator .. ": balance of what tumbles")
  end
end)

case("a damped run goes on from its checkpoint with the same bits", function()
  for _, integrator in ipairs { "newmark", "explicit", "energy-momentum" } do
    local options = { integrator = integrator, dt = integrator == "explicit" and 1e-5 or 1e-4 }
    local file, whole = folder .. "/tumbling.checkpoint", tumbling(options)
    for step in whole:steps() do if step.index == 1000 then whole:checkpoint(file) end end
    local resumed = done(tumbling(options):resume(file), "resumed")
    equal(resumed.hash, whole.hash, integrator .. ": bits after a checkpoint")
    equal(resumed.energy.damping, whole.energy.damping, integrator .. ": account after a checkpoint")
  end
end)

case("one solution a step damps as several do where a step takes much of the velocity", function()
  -- Solved once a step, where a step takes much of the velocity: by the trapezium rule.
  local model = hinge.model { displacement = "small" }
  local a, b = model:node { 0, 0, 0 }, model:node { 1, 0, 0 }
  local member = model:member { a, b, section = section, material = steel() }
  model:mass { node = a, mass = 300 }
  model:velocity(member, { 1, 0, 0 })
  model:damping { alpha = 3e3 }
  local run = done(model:dynamic { dt = 1e-4, duration = 1e-3, iterations = 1, solver = "direct", precision = "double",
    record = false, rest = false }, "strong alpha")
  near((run:velocity(a)), (0.85 / 1.15) ^ 10, 1e-9, "ten steps of strong alpha")
end)

-- Between members of two groups a mass has the mean of their alphas, of those that are whole. Once all have broken it
-- flies undamped. The members weigh next to nothing.
local function between(breaks)
  local model = hinge.model { elements_per_member = 1, formulation = "conventional" }
  local nodes = {}
  for i = 1, 3 do nodes[i] = model:node { i, 0, 0 } end
  for i = 1, 2 do
    model:member { nodes[i], nodes[i + 1], section = section, material = steel(1e-3), group = ("abc"):sub(i, i) }
  end
  model:mass { node = nodes[2], mass = 10 }
  for _, group in ipairs { "a", "b" } do model:velocity(group, { 1, 0, 0 }) end
  model:damping { alpha = 3, group = "a" }
  model:damping { alpha = 1, group = "b" }
  if breaks then
    model:fracture { where = "all", rule = function(at) return at.time > 0.1 * at.element - 1e-6 end }
  end
  return model:dynamic { dt = 1e-3, duration = 0.3, record = false, rest = false, solver = "direct",
    energy_tolerance = 0 }, nodes[2]
end
case("masses beside nodes are damped", function()
  local run, middle = between()
  done(run, "two groups")
  near((run:velocity(middle)), math.exp(-0.3 * 2), 1e-5, "mean of two groups")
  local before
  run, middle = between(true)
  for step in run:steps() do
    if step.index == 100 then near((run:velocity(middle)), math.exp(-0.2), 1e-5, "both whole") end
    if step.index == 200 then near((run:velocity(middle)), math.exp(-0.2 - 0.1), 1e-3, "one has broken") end
    if step.index == 201 then before = run:velocity(middle) end
  end
  equal(run:count { state = "broken" }, 2, "both have broken")
  equal((run:velocity(middle)), before, "what flies undamped")
end)

checks.done()
