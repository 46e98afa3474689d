-- A frame is pushed over: pictures side by side, a curve and frames for ParaView. See pictures.md.
local hinge = require "hinge"

local steel = hinge.material { E = 206e9, density = 7850, yield_stress = 235e6 }
local column = hinge.section.box { width = 0.15, depth = 0.15, thickness = 0.006 }
local beam = hinge.section.h { depth = 0.3, width = 0.15, web = 0.007, flange = 0.01 }

-- Two bays of 5 m, two storeys of 3.5 m, and 6 t on each joint.
local model = hinge.model()
local node = {}
for i = 0, 2 do
  node[i] = {}
  for k = 0, 2 do node[i][k] = model:node { 5 * i, 0, 3.5 * k } end
  model:fix(node[i][0])
  for k = 1, 2 do
    model:member { node[i][k - 1], node[i][k], section = column, material = steel, group = "columns" }
    model:mass { node = node[i][k], mass = 6000 }
    if i > 0 then model:member { node[i - 1][k], node[i][k], section = beam, material = steel, group = "beams" } end
  end
end
model:gravity { 0, 0, -9.81 }
model:load { node = node[0][2], force = { 400e3, 0, 0 }, history = { { 0, 1 }, { 0.3, 1 }, { 0.3, 0 } } }

local rest = model:static { steps = 1 }:finish()
local run = model:dynamic { from = rest, dt = 1e-3, duration = 1 }
local sway = run:probe { node = node[2][2], "ux", name = "sway" }
local fall = run:probe { node = node[2][2], "uz", name = "fall" }

-- A snapshot and a frame each 0.25 s; all snapshots share one box, so that they have one scale.
local shots = {}
for step in run:steps() do
  if step.index % 250 == 0 then
    shots[#shots + 1] = { run:snapshot(), { box = { -1, 15, 0, 0, -0.5, 8 }, from = { 0, -1, 0.05 }, width = 500,
      height = 300 } }
    hinge.frame(run)
  end
end
hinge.strip(shots, 2, "pictures_strip.png")
hinge.plot({ title = "the upper right corner", x_label = "time, s", y_label = "displacement, m", width = 1000,
  height = 600, series = { { name = "to the right", x = sway.time, y = sway.value },
    { name = "upwards", x = fall.time, y = fall.value } } }, "pictures_plot.png")
print(("%d of %d columns have yielded; the corner moved by %.1f m and %.1f m"):format(
  run:count { group = "columns", state = "yielded" }, #model:group "columns", sway.last, fall.last))
