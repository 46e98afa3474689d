-- Hinges may turn an end of an element by any angle: by several turns, in statics and dynamics, in and out of plane,
-- with a checkpoint on the way. The work of a hinge is its moment times its rotation, however far it has rotated.
--
-- Run: lua5.4 tests/script/run/fold_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local hinge = require "hinge"
local checks = support.checks "fold"
local case, expect, equal = checks.case, checks.expect, checks.equal
local pi, largest_of = math.pi, support.largest_of

--- value against wanted, as a part of it
local function close(value, wanted, within, what)
  checks.near(value / wanted, 1, within, ("%s (%g against %g)"):format(what, value, wanted))
end

-- A cantilever along x that yields in bending alone, so that a moment at its end bends all of it alike.
local L, EI, M0 = 2, 206e9 * 1e-6, 5e3 -- m, N m^2, N m
local function cantilever(options)
  local model = hinge.model { p_delta = options.p_delta, elements_per_member = 2, formulation = options.formulation }
  local a, b = model:node { 0, 0, 0 }, model:node { L, 0, 0 }
  local member = model:member { a, b, material = hinge.material { E = 206e9, nu = 0.3, density = 7850,
    yield_stress = 250e6 }, section = hinge.section.general { area = 1e-3, Ix = 1e-6, Iy = 1e-6, J = 1e-6,
    Mx0 = M0, My0 = M0 } }
  model:fix(a)
  return model, member, b
end

case("a moment in statics turns the end of a cantilever by eight half turns", function()
  -- Statics: a moment turns the end by eight half turns. Each end of the two elements turns by two of them against its
  -- element, and passes 180 degrees twice.
  local angle = 8 * pi
  local yields_at = M0 * L / EI -- rad, of the free end
  for _, p_delta in ipairs { "member", "chord" } do
    local model, member, b = cantilever { p_delta = p_delta }
    model:load { node = b, moment = { 0, 1, 0 } }
    local run = model:static { steps = 200, control = { node = b, "ry", to = angle } }
    run:finish()
    local name = "statics, " .. p_delta
    equal(run.verdict, "completed", name .. ": " .. run.reason)
    close(run.energy.plastic, M0 * (angle - yields_at), 1e-6, name .. ": plastic work")
    close(run.energy.elastic, 0.5 * M0 * yields_at, 1e-6, name .. ": strain energy")
    close(run.energy.work, M0 * (angle - yields_at / 2), 2e-3, name
      .. ": work; in its first step the moment has a bend")
    local _, at_b = member:forces(run)
    close(largest_of(math.abs(at_b.Mx), math.abs(at_b.My)), M0, 1e-9, name .. ": moment")
  end
end)

-- Dynamics: a heavy end that spins is stopped by its hinges after several turns. Where it goes is no closed form; the
-- balance closes, and the hinges have done nearly all of its energy.
local flywheel, spin = 5, 200 -- kg m^2, rad/s
local energy = 0.5 * flywheel * spin ^ 2
local function spun(options, run_options)
  local model, member, b = cantilever(options)
  model:mass { node = b, mass = 5, inertia = { flywheel, flywheel, flywheel } }
  model:velocity(b, { 0, 0, 0 }, { 0, spin * math.cos(options.aside or 0), spin * math.sin(options.aside or 0) })
  if options.bow then model:velocity(b, { 0, 0, 20 }, { 30, spin, 0 }) end
  if options.fracture then model:fracture(options.fracture) end
  local o = { dt = 2e-5, duration = 0.4, record = false }
  for k, v in pairs(run_options or {}) do o[k] = v end
  return model:dynamic(o), member, b
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
  -- What a rule of the script reads as a hinge's rotation goes on growing: all hinges together have turned the end.
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
  -- A checkpoint after ends were turned, and threads.
  local file = os.tmpname()
  local whole = spun({ bow = true }, { duration = 0.1 })
  local half = whole.planned_steps // 2
  for step in whole:steps() do
    if step.index == half then whole:checkpoint(file) end
  end
  local other = spun({ bow = true }, { duration = 0.1, threads = 2 })
  other:resume(file)
  other:finish()
  equal(other.hash, whole.hash, "a run that goes on from a checkpoint")
  os.remove(file)
end)

checks.done()
