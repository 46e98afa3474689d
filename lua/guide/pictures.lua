-- A frame is pushed over: pictures side by side, plots and frames for films and ParaView. See pictures.md.
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
hinge.strip({
  { rest, { view = "front", scale = "auto", ghost = true, labels = true, width = 600, height = 400 } },
  { rest, { view = "front", show = "Mx", width = 600, height = 400 } } }, 2, "pictures_gravity.png")

local run = model:dynamic { from = rest, dt = 1e-3, duration = 1 }
local sway = run:probe { node = node[2][2], "ux", name = "sway" }
local fall = run:probe { node = node[2][2], "uz", name = "fall" }

-- A snapshot, a frame and bars of the storeys' drifts each 0.25 s; all snapshots share one box, so that they have one
-- scale.
local shots, drifts = {}, {}
for step in run:steps() do
  if step.index % 250 == 0 then
    shots[#shots + 1] = { run:snapshot(), { box = { -1, 15, 0, 0, -0.5, 8 }, view = "front", width = 500,
      height = 300 } }
    hinge.frame(run)
    local lower, upper = run:displacement(node[2][1]), run:displacement(node[2][2])
    drifts[#drifts + 1] = { name = ("%.2f s"):format(step.time), style = "bars",
      x = { "lower storey", "upper storey" }, y = { lower, upper - lower } }
  end
end
hinge.strip(shots, 2, "pictures_strip.png")
hinge.plot(run, { "work", "gravity", "kinetic", "elastic", "plastic", sway, fall, width = 900, height = 800 },
  "pictures_history.png")
hinge.plot({ columns = 2, width = 1200, height = 480, panels = {
  { title = "upper right corner", x_label = "time, s", y_label = "displacement, m",
    series = { { name = "to the right", x = sway.time, y = sway.value },
      { name = "upwards", x = fall.time, y = fall.value } },
    lines = { { x = 0.3, name = "the force ends" } } },
  { title = "drift of the storeys", y_label = "drift, m", series = drifts } } }, "pictures_plot.png")
print(("%d of %d columns have yielded; the corner moved by %.1f m and %.1f m"):format(
  run:count { group = "columns", state = "yielded" }, #model:group "columns", sway.last, fall.last))
