-- The ground storey of a frame is heated until the frame comes down. See fire.md.
local hinge = require "hinge"

local bays, storeys, bay, height = 3, 4, 6, 3.5 -- m
local lean = 1 / 400 -- out of plumb
local steel = hinge.material.steel "S275"
local column, beam = hinge.section.named "HEB 200", hinge.section.named "IPE 330"

-- The frame with w N/m on its beams. The members of the ground storey are the group "fire".
local function frame(w)
  local model = hinge.model { interaction = "exact" }
  local floor = hinge.material { E = steel.E, yield_stress = steel.yield_stress, density = w / 9.81 / beam.area }
  local at = {}
  for i = 0, bays do
    at[i] = {}
    for level = 0, storeys do
      at[i][level] = model:node { i * bay + lean * level * height, 0, level * height }
      model:fix(at[i][level], level == 0 and "all" or "y,rx,rz")
      local group = level == 1 and "fire" or "cold"
      if level > 0 then
        model:member { at[i][level - 1], at[i][level], section = column, material = steel, up = { 1, 0, 0 },
          elements = level == 1 and 4 or 2, group = group }
      end
      if level > 0 and i > 0 then
        local from = at[i - 1][level]
        for part = 1, 3 do -- the floor holds the beam at its third points
          local to = at[i][level]
          if part < 3 then
            to = model:node { (i - 1 + part / 3) * bay + lean * level * height, 0, level * height }
            model:fix(to, "y,rx,rz")
          end
          model:member { from, to, section = beam, material = floor, up = { 0, 0, 1 }, group = group }
          from = to
        end
      end
    end
  end
  model:gravity { 0, 0, -9.81 }
  return model, at
end

-- Statics: gravity first, then heat, until there is no equilibrium.
local standard = hinge.heat.unprotected { section_factor = 140, shadow = 0.7, duration = 3600 }
local function minutes_to(temperature)
  for _, point in ipairs(standard) do if point[2] >= temperature then return point[1] / 60 end end
end
print "w kN/m   critical temperature   steel of 140 1/m has it after"
local curves = {}
for _, w in ipairs { 20e3, 30e3 } do
  local model, at = frame(w)
  model:heat { group = "fire", temperature = 1000, case = model:case "fire" }
  local cold = model:static { loads = {} }:finish()
  local hot = model:static { from = cold, loads = { fire = 1 }, steps = 25, to_limit = true }
  local curve = { x = {}, y = {}, name = ("%.0f kN/m"):format(w / 1e3) }
  while hot:step() do
    table.insert(curve.x, hot:read("temperature", "fire")[1])
    table.insert(curve.y, 1e3 * select(3, at[1][1]:displacement(hot)))
  end
  assert(hot.limit, hot.reason)
  local critical = hot:read("temperature", "fire")[1]
  print(("%5.0f %14.0f degrees C %15d min"):format(w / 1e3, critical, minutes_to(critical)))
  curves[#curves + 1] = curve
end
hinge.plot({ series = curves, x_label = "temperature of the ground storey (degrees C)",
  y_label = "rise of the head of an inner column (mm)", width = 1000, height = 500 }, "fire_heads.png")

-- Dynamics: the same heat within 4 s, which is slow for the frame.
local model, at = frame(20e3)
model:damping { ratio = 0.05, periods = { 1, 0.1 } }
model:heat { group = "fire", temperature = { { 0, 20 }, { 4, 800 } } }
model:contact {}
model:ground {}
local start = model:static { steps = 2 }:finish()
local leans = model:dynamic { from = start, dt = 2e-3, duration = 3.7 }
local highest, warmest = 0, nil
while leans:step() do
  local head = select(3, at[1][1]:displacement(leans))
  highest = math.max(highest, head)
  if not warmest and head < highest - 0.01 then warmest = leans:read("temperature", "fire")[1] end
end
local down = model:dynamic { from = leans, dt = 2e-3, duration = 1.3 }:finish()
print(("dynamics, 20 kN/m: the head of an inner column has sunk by 10 mm at %.0f degrees C"):format(warmest))
for _, run in ipairs { leans, down } do
  print(("t = %.1f s: hinges have dissipated %.1g MJ"):format(run.time, run.energy.plastic / 1e6))
end
local view = { width = 700, height = 520, view = "front", box = { -2, 22, -1, 1, 0, 14 } }
hinge.strip({ { leans, view }, { down, view } }, 2, "fire.png")
