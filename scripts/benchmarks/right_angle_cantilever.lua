-- The right-angle cantilever of Simo and Vu-Quoc: bending and torsion of very flexible legs in space.
--
-- Run     hinge run scripts/benchmarks/right_angle_cantilever.lua
-- Shows   large rotations in space under a short pulse, and free vibration with the energy kept for 28 s
-- Expect  elbow and tip swing by 5.5 and 9.7 m, as much as the legs are long; right_angle.png shows both histories
local hinge = require "hinge"

-- Extremes found apart, by an explicit rod of the same theory: time in s, displacement out of the plane in m.
local reference = { elbow = { { 3.10, 5.509 }, { 10.85, -4.063 }, { 25.25, 6.106 } },
  tip = { { 7.45, 8.242 }, { 15.90, -9.726 } }, energy = 114.78 } -- J, after the push

-- Two legs of 10 m: EA = GA = 1e6 N, EI = GJ = 1e3 N m^2, 1 kg/m, rotary inertia 20 kg m about the axis and 10 across.
local function cantilever(elements, dt)
  local model = hinge.model { elements_per_member = elements, plasticity = false }
  local foot, elbow, tip = model:node { 0, 0, 0 }, model:node { 10, 0, 0 }, model:node { 10, 10, 0 }
  local material = hinge.material { E = 1e6, nu = -0.5, density = 1 }
  local section = hinge.section.general { area = 1, Ix = 1e-3, Iy = 1e-3, J = 1e-3, shear_area_x = 1, shear_area_y = 1,
    mass_Ix = 10, mass_Iy = 10 }
  model:member { foot, elbow, section = section, material = material }
  model:member { elbow, tip, section = section, material = material }
  model:fix(foot)
  model:load { node = elbow, force = { 0, 0, 50 }, history = { { 0, 0 }, { 1, 1 }, { 2, 0 }, { 1000, 0 } } }
  local run = model:dynamic { dt = dt, duration = 28, integrator = "energy-momentum", record = false }
  local of_elbow, of_tip, energy = run:probe { node = elbow, "uz" }, run:probe { node = tip, "uz" }, nil
  run:on_step(function(r)
    if not energy and r.time > 2 + dt / 2 then energy = r.energy.kinetic + r.energy.elastic end
  end)
  run:finish()
  return of_elbow, of_tip, energy, run
end

-- The extreme of a probe within 1.5 s of a time.
local function extreme(probe, at)
  local most = 0
  for i, t in ipairs(probe.time) do
    if math.abs(t - at) < 1.5 and math.abs(probe.value[i]) > math.abs(most) then most = probe.value[i] end
  end
  return most
end

local function points_of(list, name)
  local x, y = {}, {}
  for i, point in ipairs(list) do x[i], y[i] = table.unpack(point) end
  return { x = x, y = y, name = name, style = "points" }
end

return hinge.benchmark {
  title = "Right-angle cantilever", kind = "dynamics", fast = true,
  source = "problem: Simo and Vu-Quoc, Comp. Meth. Appl. Mech. Eng. 66 (1988); values computed apart",
  run = function(b, job)
    local elbow, tip, energy, run = cantilever(10, 0.05)
    local row = b:rows_with { elements = 20, steps = run.index }
    row("elbow, first swing", extreme(elbow, 3.10), reference.elbow[1][2], "m", 2e-4)
    row("elbow, greatest swing", extreme(elbow, 25.25), reference.elbow[3][2], "m", 5e-3)
    row("tip, first swing", extreme(tip, 7.45), reference.tip[1][2], "m", 1.5e-3)
    row("tip, greatest swing", extreme(tip, 15.90), reference.tip[2][2], "m", 2e-4)
    row("energy after the push", energy, reference.energy, "J", 1e-3)
    job:plot({ series = { { x = elbow.time, y = elbow.value, name = "elbow" },
      { x = tip.time, y = tip.value, name = "tip" }, points_of(reference.elbow, "elbow, reference"),
      points_of(reference.tip, "tip, reference") }, x_label = "s", y_label = "m, out of the plane",
      title = "right-angle cantilever" }, "right_angle.png")
  end,
}
