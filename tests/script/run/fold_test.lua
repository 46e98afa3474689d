-- Elements may wind up, and hinges may turn an end of an element, by any number of turns: in statics and dynamics, in
-- and out of plane, torn, kept in a checkpoint, taken back. The work of a hinge is its moment times its rotation.
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local scenes = require "scenes"
local hinge = require "hinge"
local checks = support.checks "fold"
local case, expect, equal = checks.case, checks.expect, checks.equal
local pi, largest_of = math.pi, support.largest_of

--- value against wanted, as a part of it
local function close(value, wanted, within, what)
  checks.near(value / wanted, 1, within, ("%s (%g against %g)"):format(what, value, wanted))
end

-- A bar from the origin along x, fixed there, with a flywheel at its other end. Little stiffness against torsion, so
-- that it stays straight: a torque of 2 pi EI / L would make it a helix.
local L, J, flywheel = 2, 2e-8, 0.5 -- m, m^4, kg m^2
local elastic, steel = scenes.elastic, scenes.steel
local function bar(o)
  local model, b, member = scenes.cantilever { length = L, member = { elements = o.elements,
    material = o.Mz0 and steel or elastic, section = hinge.section.general { area = 1e-3, Ix = o.Ix or 1e-6, Iy = 1e-6,
      J = J, mass_Ix = 1e-7, mass_Iy = 1e-7, Mz0 = o.Mz0 } } }
  model:mass { node = b, mass = 10, inertia = { flywheel, 0.1, 0.1 } }
  return model, member, b
end
local stiffness = elastic.G * J / L -- N m
-- What of the bar's own inertia turns with the flywheel: a third; of two elements' lumped masses three eighths.
local function inertia_of(part) return flywheel + part * 7850 * 2e-7 * L end -- kg m^2
local function period_of(part) return 2 * pi * math.sqrt(inertia_of(part) / stiffness) end
local inertia, newmark_period = inertia_of(1 / 3), period_of(1 / 3)

-- Five turns in statics -----------------------------------------------------------------------------------------------
local turns = 5 * 2 * pi
local function wound(options)
  local model, member, b = bar(options or {})
  model:load { node = b, moment = { 1, 0, 0 } }
  local static = model:static { steps = 25, control = { node = b, "rx", to = turns } }
  static:finish()
  return model, member, b, static
end
case("five turns in statics have the torque of theory", function()
  local _, member, _, static = wound()
  equal(static.verdict, "completed", "five turns in statics: " .. static.reason)
  close(static.energy.elastic, 0.5 * stiffness * turns ^ 2, 1e-9, "statics: strain energy")
  close(static.energy.work, 0.5 * stiffness * turns ^ 2, 1e-9, "statics: work")
  local _, at_b = member:forces(static)
  close(at_b.Mz, stiffness * turns, 1e-9, "statics: torque")
  close(static.factor, stiffness * turns, 1e-9, "statics: load")
end)

-- Released: it swings to five turns the other way and back (closed form) ----------------------------------------------
local function released(options, run_options)
  local model, member, b, static = wound(options)
  for _, load in ipairs(model:loads()) do load:remove() end
  local o = scenes.with({ from = static, dt = newmark_period / 2000, duration = newmark_period, record = false },
    run_options)
  if not o.integrator then o.iterations = 20 end -- it spins by 0.1 rad a step
  return model:dynamic(o), member, b
end
case("a bar that is released from its twist swings back with its energy", function()
  for _, row in ipairs { { "newmark", {} }, { "explicit", { integrator = "explicit", dt = "auto" } },
    { "step control", { step_control = 0.01 } }, { "threads", { threads = 2 } } } do
    local name, options = row[1], row[2]
    local period = period_of(name == "explicit" and 3 / 8 or 1 / 3)
    local run, member, b = released({}, options)
    local start, worst, far = run.energy.initial, 0, 0
    close(start, 0.5 * stiffness * turns ^ 2, 1e-9, name .. ": energy at the start")
    for _ in run:steps() do
      local torque = select(2, member:forces(run)).Mz
      local _, _, _, spin = run:velocity(b)
      worst = largest_of(worst, math.abs(run.energy.energy_error) / start)
      -- on the ellipse of torque and spin, and where on it by the time
      local angle = turns * math.cos(2 * pi * run.time / period)
      far = largest_of(far, math.abs(torque / stiffness - angle) / turns,
        math.abs(spin * period / (2 * pi) + turns * math.sin(2 * pi * run.time / period)) / turns)
    end
    equal(run.verdict, "completed", name .. ": " .. run.reason)
    expect(worst < 1e-5, "%s: energy error %g", name, worst)
    expect(far < 2e-3, "%s: angle and spin against the closed form, %g of five turns", name, far)
    if os.getenv "HINGE_FIGURES" then print(name, "energy error", worst, "against closed form", far) end
  end
end)

-- Plastic torsion by ten turns: work = Mz0 x angle --------------------------------------------------------------------
local Mz0, ten = 400, 10 * 2 * pi
local yields_at = Mz0 / stiffness
case("plastic torsion by ten turns has the fully plastic torque and its work", function()
  local model, member, b = bar { Mz0 = Mz0 }
  model:load { node = b, moment = { 1, 0, 0 } }
  local static = model:static { steps = 100, control = { node = b, "rx", to = ten } }
  static:finish()
  equal(static.verdict, "completed", "plastic, statics: " .. static.reason)
  close(static.energy.plastic, Mz0 * (ten - yields_at), 1e-6, "plastic, statics: plastic work")
  close(static.energy.elastic, 0.5 * Mz0 * yields_at, 1e-6, "plastic, statics: strain energy")
  close(select(2, member:forces(static)).Mz, Mz0, 1e-9, "plastic, statics: torque")
end)

case("plastic torsion that goes on from another run", function()
  for _, integrator in ipairs { "newmark", "explicit" } do
    local model, member, b = bar { Mz0 = Mz0 }
    -- of this spin the flywheel is at rest after ten turns of plastic twist
    local spin = math.sqrt(2 * Mz0 * ten / inertia)
    model:velocity(model:nodes()[1], { 0, 0, 0 }) -- both ends: the bar turns with the flywheel from the start
    model:velocity(b, { 0, 0, 0 }, { spin, 0, 0 })
    local stops = spin * inertia / Mz0
    local run = model:dynamic { dt = integrator == "explicit" and "auto" or stops / 4000, duration = 1.5 * stops,
      integrator = integrator, record = false }
    run:finish()
    local name = "plastic, " .. integrator
    equal(run.verdict, "completed", name .. ": " .. run.reason)
    local e = run.energy
    expect(math.abs(e.energy_error) < 1e-5 * e.initial, "%s: energy error %g", name, e.energy_error / e.initial)
    expect(e.plastic > 0.95 * Mz0 * ten and e.plastic < 1.01 * Mz0 * ten, "%s: plastic work %g of %g", name,
      e.plastic, Mz0 * ten)
    expect(math.abs(select(2, member:forces(run)).Mz) <= Mz0 * (1 + 1e-9), "%s: torque", name)
    if os.getenv "HINGE_FIGURES" then print(name, "energy error", e.energy_error / e.initial, e.plastic / Mz0 / ten) end
  end
end)

-- Torn while it is wound and spins: the strain energy released is that of the element's turns -------------------------
case("a bar torn while it is wound and spins keeps the energy balance", function()
  local model, member, b, static = wound { elements = 4 }
  for _, load in ipairs(model:loads()) do load:remove() end
  model:fracture { where = "all", rule = function(s) return s.element == 3 and s["end"] == 1 and s.time > 0.02 end }
  model:velocity(b, { 0, 0.3, 0.1 }, { 20, 1, 0 })
  local run = model:dynamic { from = static, dt = 1e-5, duration = 0.1, iterations = 20, step_control = 0.01,
    record = false }
  local torque
  for step in run:steps() do
    if step.time < 0.02 then torque = select(2, member:forces(run)).Mz end
  end
  equal(run.verdict, "completed", "torn: " .. run.reason)
  equal(run:count { state = "broken" }, 1, "torn: it broke")
  local e = run.energy
  close(e.fracture_elastic, 0.5 * torque ^ 2 / stiffness / 4, 0.01, "torn: the energy released")
  -- of second order in dt
  expect(math.abs(e.energy_error) < 2e-3 * e.initial, "torn: energy error %g", e.energy_error / e.initial)
end)

-- Wound and bent, with Ix unlike Iy: no jump in the energy on the way through every angle -----------------------------
case("a bar wound and bent, with Ix unlike Iy, keeps its energy", function()
  local model, _, b = bar { Ix = 2e-7, elements = 2 }
  model:velocity(b, { 0, 2, 3 }, { 250, 0, 0 })
  local run, worst = model:dynamic { dt = 4e-5, duration = 0.3, iterations = 20, record = false }, 0
  for _ in run:steps() do worst = largest_of(worst, math.abs(run.energy.energy_error)) end
  equal(run.verdict, "completed", "bent: " .. run.reason)
  local most = run.energy.initial
  expect(worst < 1e-3 * most, "bent: energy error %g", worst / most)
  if os.getenv "HINGE_FIGURES" then print("bent", worst / most) end
end)

-- Several turns in flight: a wound bar that rotates freely keeps its strain energy and its angular momentum -----------
case("several turns in flight keep the energy", function()
  local model, b, _, a = scenes.cantilever { length = L, along = { 0, 1, 0 }, foot = false, member = {
    section = hinge.section.general { area = 1e-3, Ix = 1e-6, Iy = 1e-6, J = J } } }
  for _, n in ipairs { a, b } do model:mass { node = n, mass = 10, inertia = { 0.1, flywheel, 0.1 } } end
  model:velocity(a, { 10, 0, 5 }, { 0, 200, 10 })
  model:velocity(b, { -10, 0, 5 }, { 0, -200, 10 })
  local run, worst = model:dynamic { dt = 5e-5, duration = 0.3, record = false }, 0
  local before = run:momentum().angular
  for _ in run:steps() do worst = largest_of(worst, math.abs(run.energy.energy_error)) end
  local after = run:momentum().angular
  equal(run.verdict, "completed", "flight: " .. run.reason)
  expect(worst < 1e-4 * run.energy.initial, "flight: energy error %g", worst / run.energy.initial)
  for c = 1, 3 do
    checks.near(after[c], before[c], 1e-4 * 400 * flywheel, "flight: angular momentum " .. c)
  end
end)

-- A checkpoint on the way, threads, and a step that is taken back while it winds --------------------------------------

--- make(threads) on two threads, from a checkpoint in the middle, has the bits of one thread.
local function same_from_checkpoint(make)
  local file, whole = os.tmpname(), make(1)
  local half = whole.planned_steps // 2
  for step in whole:steps() do
    if step.index == half then whole:checkpoint(file) end
  end
  equal(make(2):resume(file):finish().hash, whole.hash, "a run that goes on from a checkpoint")
  os.remove(file)
end
case("a checkpoint, threads and a step taken back change no bit while a bar winds", function()
  same_from_checkpoint(function(threads)
    return (released({}, { duration = 0.3 * newmark_period, threads = threads }))
  end)
  local function controlled(step_control)
    local model, _, b = bar { elements = 2 }
    model:velocity(b, { 0, 2, 3 }, { 250, 0, 0 })
    local run = model:dynamic { dt = 8e-3, duration = 0.5, step_control = step_control, record = false }
    run:finish()
    return run
  end
  local run = controlled(0.01)
  equal(run.verdict, "completed", "step control: " .. run.reason)
  expect(run.counts.rejected_steps > 0, "step control: %d steps taken back", run.counts.rejected_steps)
  expect(math.abs(run.energy.energy_error) < 0.01 * run.energy.initial, "step control: energy error %g",
    run.energy.energy_error / run.energy.initial)
  equal(controlled(0.01).hash, run.hash, "step control: the same bits")
end)

local EI, M0 = 206e9 * 1e-6, 5e3 -- N m^2, N m
local function cantilever(options)
  local section = hinge.section.general { area = 1e-3, Ix = 1e-6, Iy = 1e-6, J = 1e-6, Mx0 = M0, My0 = M0 }
  local model, b, member = scenes.cantilever { length = L, member = { material = steel, section = section },
    model = { p_delta = options.p_delta, formulation = options.formulation } }
  return model, member, b
end

case("a moment in statics turns the end of a cantilever by eight half turns", function()
  -- Each end of the two elements turns by two of them against its element, and passes 180 degrees twice.
  local angle, bends = 8 * pi, M0 * L / EI -- rad, of the free end, where it yields
  for _, p_delta in ipairs { "member", "chord" } do
    local model, member, b = cantilever { p_delta = p_delta }
    model:load { node = b, moment = { 0, 1, 0 } }
    local run = model:static { steps = 200, control = { node = b, "ry", to = angle } }
    run:finish()
    local name = "statics, " .. p_delta
    equal(run.verdict, "completed", name .. ": " .. run.reason)
    close(run.energy.plastic, M0 * (angle - bends), 1e-6, name .. ": plastic work")
    close(run.energy.elastic, 0.5 * M0 * bends, 1e-6, name .. ": strain energy")
    close(run.energy.work, M0 * (angle - bends / 2), 2e-3, name .. ": work; in its first step the moment has a bend")
    local _, at_b = member:forces(run)
    close(largest_of(math.abs(at_b.Mx), math.abs(at_b.My)), M0, 1e-9, name .. ": moment")
  end
end)

-- Dynamics: a heavy end that spins is stopped by its hinges after several turns. Where it goes is no closed form; the
-- balance closes, and the hinges have done nearly all of its energy.
local heavy, spin = 5, 200 -- kg m^2, rad/s
local energy = 0.5 * heavy * spin ^ 2
local function spun(options, run_options)
  local model, _, b = cantilever(options)
  model:mass { node = b, mass = 5, inertia = { heavy, heavy, heavy } }
  model:velocity(b, { 0, 0, options.bow and 20 or 0 }, { options.bow and 30 or 0, spin, 0 })
  if options.fracture then model:fracture(options.fracture) end
  return model:dynamic(scenes.with({ dt = 2e-5, duration = 0.4, record = false }, run_options))
end
case("hinges stop a spinning end after several turns and take its energy", function()
  for _, row in ipairs {
    { "newmark", {} }, { "chord", { p_delta = "chord" } },
    { "explicit", {}, { integrator = "explicit", dt = "auto" } },
    { "out of plane", { bow = true } },
    { "out of plane, explicit", { bow = true }, { integrator = "explicit", dt = "auto" } },
    { "energy-momentum", { bow = true }, { integrator = "energy-momentum", dt = 1e-4 } },
    { "conventional", { formulation = "conventional" } },
  } do
    local name = row[1]
    local run = spun(row[2], row[3])
    local worst = 0
    for _ in run:steps() do worst = largest_of(worst, math.abs(run.energy.energy_error)) end
    equal(run.verdict, "completed", name .. ": " .. run.reason)
    expect(worst < 1e-3 * run.energy.initial, "%s: energy error %g", name, worst / run.energy.initial)
    -- five turns and more of plastic rotation
    expect(run.energy.plastic > 0.9 * energy, "%s: plastic work %g of %g", name, run.energy.plastic, energy)
    if os.getenv "HINGE_FIGURES" then print(name, worst / run.energy.initial, run.energy.plastic / energy) end
  end
end)

case("the hinge rotations that a rule reads add up to the turns of the end", function()
  local rotation = {}
  local run = spun { fracture = { where = "all", rule = function(now)
    -- where two elements meet there is one hinge, which both of them read
    for _, about in ipairs { "x", "y" } do
      if now["end"] == 2 or now.element == 1 then
        rotation[about .. now["end"] .. now.element] = now["hinge_rotation_" .. about]
      end
    end
  end } }
  run:finish()
  local sum = 0
  for _, r in pairs(rotation) do sum = sum + math.abs(r) end
  close(M0 * sum, run.energy.plastic, 1e-3, "sum of the hinges' rotations times M0")
end)

case("checkpoints and threads change no bit after ends have turned over", function()
  same_from_checkpoint(function(threads) return spun({ bow = true }, { duration = 0.1, threads = threads }) end)
end)

checks.done()
