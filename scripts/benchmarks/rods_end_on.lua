-- Two steel rods meet end on at 50 m/s.
--
-- Run     hinge run scripts/benchmarks/rods_end_on.lua
-- Shows   the wave in both rods: contact force, time in contact, and how much speed is left where lengths differ
-- Expect  equal rods are in contact for 2 L / c = 0.390 ms with 2.513 MN, and exchange their velocities; a rod that
--         hits one twice as long has the coefficient of restitution L1 / L2 = 0.5
--
-- The contact has the stiffness of one element. The default one is that of a piece as long as the section is deep; it
-- delays the waves and gives 0.52 in the place of 0.5, with any number of elements. The integrator takes out the waves
-- that are too short for the elements (rho_infinity = 0.5): they would make the rods that only lie against each other
-- knock again. The force is the mean over the middle of the contact.
local hinge = require "hinge"

local E, density, side, v, L = 206e9, 7850, 0.05, 50, 1
local c = math.sqrt(E / density)
local elements = 100 -- for each metre

-- A rod along x from x0. Returns its two joints and its member.
local function rod(model, x0, length, group)
  local steel = hinge.material { E = E, density = density }
  local section = hinge.section.solid { width = side, depth = side }
  local joints = { model:node { x0, 0, 0 }, model:node { x0 + length, 0, 0 } }
  model:fix(joints, "y,z,rx,ry,rz")
  local member = model:member { joints[1], joints[2], section = section, material = steel, group = group,
    elements = elements * length }
  return joints, member
end

-- Mean position of the two ends of a rod: that of its middle, apart from vibrations that are even about it.
local function middle_of(run, joints)
  return (run:displacement(joints[1]) + run:displacement(joints[2])) / 2
end

-- The first rod, 1 m long, flies into the second one. Returns the time in contact, the force, and both velocities
-- afterwards.
local function collide(L2)
  local model = hinge.model { plasticity = false }
  local one = rod(model, -L - side, L, "one")
  local two, struck = rod(model, 0, L2, "two")
  model:velocity("one", { v, 0, 0 })
  local began, ended
  model:contact { between = { "one", "two" }, stiffness = E * side ^ 2 * elements,
    on_contact = function(event) began = began or event.time end, on_release = function(event) ended = event.time end }
  local steps = 2 * elements * L2 -- in the time that a wave takes through the second rod
  local run = model:dynamic { dt = L2 / c / steps, duration = 8 * L2 / c, rho_infinity = 0.5,
    record = false }
  local force, count, marks = 0, 0, {}
  run:on_step(function(r)
    if began and r.time - began > 0.5 * L / c and r.time - began < 1.5 * L / c then
      force, count = force - r:forces(struck).N, count + 1
    end
    if r.index == 4 * steps or r.index == 8 * steps then
      marks[#marks + 1] = { t = r.time, middle_of(r, one), middle_of(r, two) }
    end
  end)
  run:finish()
  local span = marks[2].t - marks[1].t -- whole periods of both rods
  return { run = run, contact = ended - began, force = force / count,
    one = (marks[2][1] - marks[1][1]) / span, two = (marks[2][2] - marks[1][2]) / span }
end

return hinge.benchmark {
  title = "Rods end on", kind = "dynamics", fast = true, source = "closed form: St Venant's waves in rods",
  run = function(b)
    local function row(what, found, computed, reference, unit, tolerance, scale)
      b:row { what, computed = computed, reference = reference, unit = unit, tolerance = tolerance, scale = scale,
        elements = 2 * elements, steps = found.run.index }
    end
    local equal, longer = collide(L), collide(2 * L)
    row("equal rods: contact", equal, 1e3 * equal.contact, 2e3 * L / c, "ms", 0.01)
    row("equal rods: force", equal, equal.force / 1e6, E * side ^ 2 * v / c / 2 / 1e6, "MN", 1e-5)
    row("equal rods: velocity of the struck one", equal, equal.two, v, "m/s", 5e-3)
    row("twice as long: restitution", longer, (longer.two - longer.one) / v, 0.5, "", 0.02)
    row("twice as long: velocity of the striking one", longer, longer.one, 0, "m/s", 6e-3, v)
  end,
}
