-- The ground storey of a frame is heated until the frame comes down. See fire.md.
local hinge = require "hinge"

local bays, storeys, bay, height = 3, 4, 6, 3.5 -- m
local steel = hinge.material.steel "S275"
local column, beam = hinge.section.named "HEB 200", hinge.section.named "IPE 330"

-- The frame with w N/m on its beams. Those of the ground storey, and its columns, are the group "fire".
local function frame(w)
  local model = hinge.model { interaction = "exact" }
  local floor = hinge.material.steel("S275", { density = w / 9.81 / beam.area })
  local at = {}
  for i = 0, bays do
    at[i] = {}
    for level = 0, storeys do
      at[i][level] = model:node { i * bay, 0, level * height }
      if level == 0 then
        model:fix(at[i][0], "all")
      else
        local group = level == 1 and "fire" or "cold"
        model:fix(at[i][level], "y,rx,rz")
        model:member { at[i][level - 1], at[i][level], section = column, material = steel, up = { 1, 0, 0 },
          elements = 4, group = group }
        if i > 0 then
          model:member { at[i - 1][level], at[i][level], section = beam, material = floor, up = { 0, 0, 1 },
            elements = 4, group = group }
        end
      end
    end
  end
  return model, at
end

-- Statics: gravity first, then heat, until there is no equilibrium.
local minute = hinge.heat.unprotected { section_factor = 140, shadow = 0.7, duration = 3600 } -- of steel, in ISO 834
local function minutes_to(temperature)
  for _, point in ipairs(minute) do if point[2] >= temperature then return point[1] / 60 end end
end
print "w kN/m   critical temperature   reached after"
local critical = {}
for _, w in ipairs { 10e3, 20e3, 30e3 } do
  local model = frame(w)
  model:gravity { 0, 0, -9.81 }
  model:heat { group = "fire", temperature = 1000, case = model:case "fire" }
  local cold = model:static { cases = { fire = 0 } }:finish()
  local hot = model:static { from = cold, cases = { fire = 1 }, steps = 50 }:finish()
  assert(hot.limit, hot.reason)
  critical[w] = hot:read("temperature", "fire")[1]
  print(("%5.0f %14.0f degrees C %11d min"):format(w / 1e3, critical[w], minutes_to(critical[w])))
end

-- Dynamics: the heat of the fire in 4 s, so slow for the frame that it hardly moves before it falls.
local w = 20e3
local model, at = frame(w)
model:gravity { 0, 0, -9.81 }
model:damping { ratio = 0.05, periods = { 1, 0.1 } }
model:heat { group = "fire", temperature = { { 0, 20 }, { 4, 800 } } }
model:contact {}
model:ground {}
local run = model:dynamic { from = model:static { steps = 2 }:finish(), dt = 5e-4, duration = 5 }
local views = {}
local head = run:probe { node = at[1][1], "uz" }
while run:step() do
  if #views == 0 and run.time >= 3.2 then views[1] = hinge.frame(run) end
end
