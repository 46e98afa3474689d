-- The ground shakes a portal frame.
--
-- Run     hinge run scripts/04_shaken_frame.lua
-- Shows   a heavy beam on two slender columns. Their feet follow one wave of ground acceleration, 0.5 s long, once weak
--         and once eight times as strong. There is no damping, so the frame goes on swinging after the wave
-- Expect  weak_mm = 7.047 within 3 %               swing after the wave: 2 a/w^2 r / (r^2 - 1) sin(pi / r), w of
--                                                  one mass on two columns (13/35 of their own counts), r the
--                                                  wave's frequency over w
--         weak_plastic_J = 0 exactly               the frame stays elastic: the work of the ground is all kinetic
--                                                  and elastic energy
--         strong_mm = 57.84 within 1 %             largest drift under the strong wave: eight times that under the
--                                                  weak one, although the columns yield
--         set_mm = 6.24 within 5 %                 mean drift of the swing at the end
--         energy_error_percent = 0 within 0.01     energy error, of the work of the ground, for both waves
--
-- The record is a list of numbers. A measured record would be read from a file.
local hinge = require "hinge"

local span, h, a, length, dt = 6, 4, 0.3, 0.5, 0.01 -- m, m, m/s^2, s, s
local steel  = hinge.material { E = 206e9, density = 7850, yield_stress = 325e6 }
local heavy  = hinge.material { E = 206e9, density = 40000 }
local column = hinge.section.box { width = 0.2, depth = 0.2, thickness = 0.01 }
local beam   = hinge.section.box { width = 0.5, depth = 0.8, thickness = 0.05 }

local record = {}
for i = 0, length / dt do record[i + 1] = math.sin(2 * math.pi * i * dt / length) end

local function shake(scale)
  local model = hinge.model {}
  local feet = { model:node { 0, 0, 0 }, model:node { span, 0, 0 } }
  local tops = { model:node { 0, 0, h }, model:node { span, 0, h } }
  model:fix(feet, "all")
  local mass = model:member { tops[1], tops[2], section = beam, material = heavy }.mass
  for i = 1, 2 do mass = mass + 13 / 35 * model:member { feet[i], tops[i], section = column, material = steel }.mass end
  model:move { node = feet, x = hinge.ground { dt = dt, acceleration = record, scale = scale } }

  local run = model:dynamic { dt = 5e-4, duration = 3 }
  local peak, far, near = 0, 0, 0
  run:on_step(function()
    local drift = tops[1]:displacement() - feet[1]:displacement()
    peak = math.max(peak, math.abs(drift))
    if run.time < 2 then far, near = drift, drift end
    far, near = math.max(far, drift), math.min(near, drift)
  end)
  run:finish()
  return { peak = peak, swing = (far - near) / 2, set = (far + near) / 2, energy = run.energy, mass = mass,
    lost = math.abs(run.energy.energy_error / run.energy.work) }
end

local weak, strong = shake(a), shake(8 * a)
local w = math.sqrt(24 * steel.E * column.Ix / h ^ 3 / weak.mass)
local r = 2 * math.pi / length / w
local by_hand = 2 * a / w ^ 2 * math.abs(r / (r ^ 2 - 1) * math.sin(math.pi / r))
print(("period %.3f s; by hand the weak wave leaves a swing of %.3f mm"):format(2 * math.pi / w, 1e3 * by_hand))
for _, s in ipairs { weak, strong } do
  print(("largest drift %.3f mm, then a swing of %.3f mm about %.3f mm; plastic %.1f J of the ground's work %.1f J")
    :format(1e3 * s.peak, 1e3 * s.swing, 1e3 * s.set, s.energy.plastic, s.energy.work))
end
return {
  weak_mm = 1e3 * weak.swing, weak_plastic_J = weak.energy.plastic,
  strong_mm = 1e3 * strong.peak, set_mm = 1e3 * strong.set,
  energy_error_percent = 100 * (weak.lost + strong.lost),
}
