-- A frame suddenly loses its middle column: see column_removal.md.
local hinge = require "hinge"

local g, span, lost_at = 9.80665, 6, 0.05 -- m/s^2, m, s
local fy = 325e6
local steel = hinge.material { E = 206e9, density = 7850, yield_stress = fy }
local post = hinge.section.box { width = 0.25, depth = 0.25, thickness = 0.012 }
local box = hinge.section.box { width = 0.15, depth = 0.3, thickness = 0.01 }

-- Two storeys on three columns, with w N/m on the beams, as mass. Returns the model and the joint over the column.
local function frame(w, column_is_there)
  local model = hinge.model {}
  local floor = hinge.material { E = 206e9, density = w / g / box.area, yield_stress = fy }
  local above, last
  for i = 1, 3 do
    local line = {}
    for level = 0, 2 do
      local lost = i == 2 and level == 1
      if i ~= 2 or level > 0 or column_is_there then line[level] = model:node { span * (i - 1), 0, 4 * level } end
      if lost then above = line[1] end
      if line[level - 1] then
        model:member { line[level - 1], line[level], section = post, material = steel, group = lost and "lost" or nil }
      end
      if last and level > 0 then
        model:member { last[level], line[level], section = box, material = floor, elements = 4, group = "beams" }
      end
    end
    if line[0] then model:fix(line[0], "all") end
    last = line
  end
  model:gravity { 0, 0, -g }
  return model, above
end

local function z(joint, run) return select(3, joint:displacement(run)) end

print "w kN/m   statics           dynamics, deepest   factor"
local curves, views = {}, {}
for _, w in ipairs { 10e3, 20e3, 35e3 } do
  -- Statics without the column, up to the load or to the limit load.
  local bare, joint = frame(w, false)
  local without = bare:static { to_limit = true }:finish()

  -- Dynamics: at rest on all columns, then the head of the middle one breaks.
  local model, above = frame(w, true)
  model:fracture {
    group = "lost", where = "all",
    rule = function(section) return section.time >= lost_at and section.node == above.index end,
  }
  local rest = model:static { steps = 1 }:finish()
  local run = model:dynamic { from = rest, dt = 2e-4, duration = 0.7 }
  local probe = run:probe { node = above, "uz" }
  run:finish()

  local start = z(above, rest)
  local still, deepest = start - z(joint, without), start - probe.min
  print(("%5.0f    %-16s  %6.0f mm           %s"):format(w / 1e3,
    without.limit and ("limit %.1f kN/m"):format(without.factor * w / 1e3) or ("%.1f mm"):format(1e3 * still),
    1e3 * deepest, without.limit and "falls" or ("%.2f"):format(deepest / still)))
  curves[#curves + 1] = { x = probe.time, y = probe.value, name = ("%.0f kN/m"):format(w / 1e3) }
  views[#views + 1] = { run, { width = 640, height = 480, view = "front", box = { -1, 13, -1, 1, 0, 9 } } }
end
hinge.strip({ views[2], views[3] }, 2, "column_removal.png")
hinge.plot({ series = curves, x_label = "time, s", y_label = "displacement of the joint, m", width = 1000,
  height = 500 }, "column_removal_history.png")
