-- A portal frame on ground that shakes: see earthquake.md.
local hinge = require "hinge"

local h, span = 4, 6
local steel = hinge.material { E = 206e9, density = 7850, yield_stress = 325e6 }
local floor = hinge.material { E = 206e9, density = 40000 }
local post = hinge.section.box { width = 0.2, depth = 0.2, thickness = 0.01 }
local beam = hinge.section.box { width = 0.4, depth = 0.8, thickness = 0.04 }

-- The record: two periods of a sine, as the acceleration of the ground every 10 ms.
local period, length, dt = 0.8, 1.6, 0.01
local record = {}
for i = 0, length / dt do record[i + 1] = math.sin(2 * math.pi * i * dt / period) end

-- Returns the history of the drift (mm) for a record times `scale` (m/s^2), and the run.
local function shake(scale)
  local model = hinge.model {}
  local feet = { model:node { 0, 0, 0 }, model:node { span, 0, 0 } }
  local tops = { model:node { 0, 0, h }, model:node { span, 0, h } }
  model:member { tops[1], tops[2], section = beam, material = floor, group = "floor" }
  for i = 1, 2 do model:member { feet[i], tops[i], section = post, material = steel, group = "columns" } end
  model:fix(feet, "all")
  model:move { node = feet, x = hinge.ground { dt = dt, acceleration = record, scale = scale } }

  local run = model:dynamic { dt = 2e-4, duration = 3 }
  local drift, peak = { x = { 0 }, y = { 0 }, name = ("%.0f m/s^2"):format(scale) }, 0
  run:on_step(function()
    local now = 1e3 * (tops[1]:displacement() - feet[1]:displacement())
    drift.x[#drift.x + 1], drift.y[#drift.y + 1] = run.time, now
    peak = math.max(peak, math.abs(now))
  end)
  run:finish()
  print(("%s: peak drift %.1f mm, plastic %.0f J of %.0f J"):format(drift.name, peak, run.energy.plastic,
    run.energy.work))
  return drift, model
end

local weak, model = shake(1)
local strong = shake(5)

-- By hand: one mass on two columns that bend and shear, from rest, under the same sine.
local mass = model:group("floor").mass + 13 / 35 * model:group("columns").mass
local shear = 12 * steel.E * post.Ix / (steel.G * post.shear_area_y * h ^ 2)
local stiff = (beam.Ix / span) / (post.Ix / h) -- the beam's over the column's
local k = 24 * steel.E * post.Ix / h ^ 3 / (1 + shear) * (6 * stiff + 1) / (6 * stiff + 4)
local w, W = math.sqrt(k / mass), 2 * math.pi / period
local by_hand, worst = { x = {}, y = {}, name = "by hand, elastic", dashed = true }, 0
for i, t in ipairs(weak.x) do
  if t > length then break end
  by_hand.x[i], by_hand.y[i] = t, -1e3 * (math.sin(W * t) - W / w * math.sin(w * t)) / (w ^ 2 - W ^ 2)
  worst = math.max(worst, math.abs(weak.y[i] - by_hand.y[i]))
end

print(("period by hand %.3f s"):format(2 * math.pi / w))
print(("elastic: hinge and the numbers by hand differ by %.2f mm"):format(worst))
hinge.plot({ series = { weak, strong, by_hand }, x_label = "time, s", y_label = "drift, mm", width = 1000,
  height = 600 }, "earthquake.png")
