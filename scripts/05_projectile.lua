-- A projectile hits a column.
--
-- Run     hinge run scripts/05_projectile.lua
-- Shows   a bar of 20 kg flies at 30 m/s into the middle of a clamped column, bends it and bounces off
-- Expect  brought_Ns = 602.9 within 0.02 %           its momentum m v
--         lost_percent = 0 within 0.1              part of it that is neither in the supports nor in motion
--         yielded = 2 exactly                      both halves of the column
--         energy_error_percent = 0 within 0.3      energy error, of the initial energy
local hinge = require "hinge"

local steel = hinge.material { E = 206e9, density = 7850, yield_stress = 325e6 }
local box   = hinge.section.box { width = 0.15, depth = 0.15, thickness = 0.008 }
local solid = hinge.section.solid { width = 0.08, depth = 0.08 }

local model = hinge.model {}
local foot, middle, head = model:node { 0, 0, 0 }, model:node { 0, 0, 1.5 }, model:node { 0, 0, 3 }
model:fix({ foot, head }, "all")
model:member { foot, middle, section = box, material = steel, group = "column" }
model:member { middle, head, section = box, material = steel, group = "column" }
local projectile = model:member {
  model:node { -0.12, -0.2, 1.4 }, model:node { -0.12, 0.2, 1.4 }, section = solid, material = steel,
  group = "projectile",
}
model:velocity(projectile, { 30, 0, 0 })
model:contact {}

local run = model:dynamic { dt = 1e-5, duration = 0.02 }
local reactions = { run:probe { node = foot, "fx" }, run:probe { node = head, "fx" } }
local brought = run:momentum().linear[1]
run:finish()

-- The impulse of the supports, by the trapezoidal rule.
local impulse = 0
for _, force in ipairs(reactions) do
  for i = 2, #force.value do
    impulse = impulse + (force.value[i] + force.value[i - 1]) / 2 * (force.time[i] - force.time[i - 1])
  end
end
local left = run:momentum().linear[1]
print(("momentum brought %.3f N s, left %.3f N s, impulse of the supports %.3f N s"):format(brought, left, impulse))
print(("velocity of the projectile's end %.2f m/s; the column bends by %.1f mm")
  :format(projectile.a:velocity(), 1e3 * middle:displacement()))
return {
  brought_Ns = brought, lost_percent = 100 * (brought + impulse - left) / brought,
  yielded = run:count { group = "column", state = "yielded" },
  energy_error_percent = 100 * run.energy.energy_error / run.energy.initial,
}
