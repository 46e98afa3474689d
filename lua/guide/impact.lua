-- A cage of bars flies into a steel frame: see impact.md.
local hinge = require "hinge"

local steel = hinge.material { E = 206e9, density = 7850, yield_stress = 325e6 }
local box = hinge.section.box { width = 0.15, depth = 0.15, thickness = 0.008 }
local bar = hinge.section.solid { width = 0.05, depth = 0.05 }
local model = hinge.model {}

-- A plane frame of three columns and two storeys.
local feet, last = {}, nil
for i = 1, 3 do
  local column = { [0] = model:node { 4 * (i - 1), 0, 0 } }
  for level = 1, 2 do
    column[level] = model:node { 4 * (i - 1), 0, 3 * level }
    model:member { column[level - 1], column[level], section = box, material = steel, group = "frame" }
    if last then model:member { last[level], column[level], section = box, material = steel, group = "frame" } end
  end
  feet[i], last = column[0], column
end
model:fix(feet, "all")

-- The body: a cube of twelve bars, 0.8 m wide. Two of its front bars will cross the left column.
local corner = {}
for i = 0, 7 do corner[i] = model:node { -1 + 0.8 * (i & 1), -0.4 + 0.4 * (i & 2), 1.1 + 0.2 * (i & 4) } end
for i = 0, 7 do
  for _, bit in ipairs { 1, 2, 4 } do
    if i & bit == 0 then
      model:member { corner[i], corner[i | bit], section = bar, material = steel, group = "body" }
    end
  end
end
model:velocity("body", { 40, 0, 0 })
model:contact { between = { "frame", "body" } }

-- The frame takes its weight in statics while the body is held. Then the body flies.
model:gravity { 0, 0, -9.80665 }
local rest = model:static { fixed_group = "body" }:finish()
local run = model:dynamic { from = rest, dt = 2e-5, duration = 0.1 }
local probes = {}
for i, foot in ipairs(feet) do probes[i] = run:probe { node = foot, "fx" } end
local before, brought = run:snapshot(), run:momentum().linear[1]
run:finish()

-- Momentum along x: what was brought, plus the impulse of the supports, is what is left.
local impulse = 0
for _, probe in ipairs(probes) do
  for i = 2, #probe.value do impulse = impulse + probe.value[i] * (probe.time[i] - probe.time[i - 1]) end
end
local left, energy = run:momentum().linear[1], run.energy
print(("momentum: brought %.0f N s, supports %.0f N s, left %.0f N s"):format(brought, impulse, left))
print(("energy: initial %.1f kJ, plastic %.1f kJ, elastic and kinetic %.1f kJ"):format(energy.initial / 1e3,
  energy.plastic / 1e3, (energy.elastic + energy.kinetic) / 1e3))
local function plastic_work(group)
  local sum = 0
  for _, work in ipairs(run:read("plastic_work", group)) do sum = sum + work end
  return sum
end
print(("plastic work: frame %.1f kJ, body %.1f kJ"):format(plastic_work "frame" / 1e3, plastic_work "body" / 1e3))
print(("energy error %.2f %%"):format(100 * math.abs(run.energy_error)))

local view = { width = 800, height = 700, from = { -0.5, -1.4, 0.5 }, box = { -1.3, 8.2, -0.6, 0.6, -0.1, 6.2 } }
hinge.strip({ { before, view }, { run, view } }, 2, "impact.png")
