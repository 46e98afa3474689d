-- The limit load of a portal by load control, displacement control and arc length: see statics.md.
local hinge = require "hinge"

local height, half, side, yield_stress = 4, 3, 0.1, 235e6 -- m, m, m, Pa
local Mp = side ^ 3 / 4 * yield_stress
local steel = hinge.material { E = 210e9, density = 7850, yield_stress = yield_stress }
local bar = hinge.section.solid { width = side, depth = side }

-- 50 kN to the side at the left corner, 50 kN downwards on the middle of the beam. Returns the model and the corner.
local function portal(displacement)
  local model = hinge.model { displacement = displacement }
  local node = {}
  for i, at in ipairs { { 0, 0 }, { 0, height }, { half, height }, { 2 * half, height }, { 2 * half, 0 } } do
    node[i] = model:node { at[1], 0, at[2] }
  end
  model:fix { node[1], node[5] }
  for i = 1, 4 do model:member { node[i], node[i + 1], section = bar, material = steel } end
  model:load { node = node[2], force = { 50e3, 0, 0 } }
  model:load { node = node[3], force = { 0, 0, -50e3 } }
  return model, node[2]
end

-- A run as a curve of sway (m) and load (kN), and its largest load.
local function follow(run, node, curve)
  curve.x, curve.y = { 0 }, { 0 }
  for step in run:steps() do
    table.insert(curve.x, (node:displacement(run)))
    table.insert(curve.y, 50 * step.factor)
  end
  return curve, math.max(table.unpack(curve.y))
end

local model, left = portal "large"
local pushed = model:static { steps = 40, to_limit = true }
local by_load, limit_by_load = follow(pushed, left, { name = "load control", style = "points" })
local driven = model:static { steps = 60, control = { node = left, "ux", to = 1.2 } }
local by_sway, limit_by_sway = follow(driven, left, { name = "displacement control, large" })
local arc = model:static { steps = 110, control = "arc" }
local by_arc, limit_by_arc = follow(arc, left, { name = "arc length", style = "points" })
local flat, corner = portal "small"
local first_order = flat:static { steps = 60, control = { node = corner, "ux", to = 1.2 } }
local by_first, limit_first = follow(first_order, corner, { name = "displacement control, small" })

-- By hand: rigid bars with hinges in both feet, in the middle and on the right. The left column leans by t.
local rigid, last = { name = "rigid bars by hand", x = {}, y = {}, dashed = true }, nil
for t = 0, 0.301, 0.01 do
  local x, z = height * math.sin(t) + half * math.cos(t), height * math.cos(t) - half * math.sin(t) -- the middle
  local way = math.sqrt((2 * half - x) ^ 2 + z ^ 2)                                               -- to the right foot
  local angle = math.acos((half ^ 2 + way ^ 2 - height ^ 2) / (2 * half * way)) - math.atan(z, 2 * half - x)
  local lean = math.asin((x + half * math.cos(angle) - 2 * half) / height)
  local now = { 2 * (t + angle + lean) * Mp, height * math.sin(t) + height - z, height * math.sin(t) } -- energy, ways
  if last then
    table.insert(rigid.x, (now[3] + last[3]) / 2)
    table.insert(rigid.y, (now[1] - last[1]) / (now[2] - last[2]) / 1000)
  end
  last = now
end

print(("small displacement  %6.2f kN, by hand %.2f kN"):format(limit_first, 6 * Mp / (height + half) / 1000))
print(("load control        %6.2f kN, at a sway of %.0f mm"):format(limit_by_load, 1000 * left:displacement(pushed)))
print(("displacement        %6.2f kN, then %.2f kN at %.2f m"):format(limit_by_sway, by_sway.y[60], by_sway.x[60]))
print(("rigid bars by hand          then %.2f kN at %.2f m"):format(rigid.y[#rigid.y], rigid.x[#rigid.x]))
print(("arc length          %6.2f kN, the last step is at %.2f m"):format(limit_by_arc, by_arc.x[#by_arc.x]))
hinge.plot({ series = { by_first, by_sway, by_arc, by_load, rigid }, x_label = "sway of the corner, m",
  y_label = "load, kN", title = "a portal is pushed past its limit load", width = 1000, height = 600 }, "statics.png")
return { limit_kN = limit_by_load }
