-- Debris falls on the ground and comes to rest: see contact_and_debris.md.
local hinge = require "hinge"

local side, mu, g = 0.15, 0.4, 9.80665
local steel = hinge.material { E = 206e9, density = 7850 }
local bar = hinge.section.solid { width = side, depth = side }
local model = hinge.model {}

-- A bar lies on the ground and slides at 3 m/s.
local tail, head = model:node { 0, -2, side / 2 }, model:node { 2, -2, side / 2 }
model:member { tail, head, section = bar, material = steel, group = "slider" }
model:velocity("slider", { 3, 0, 0 })

-- Three crosses fall, one on the other.
for i = 0, 2 do
  local x, y, z = 0.3 * i, 0.1 * i, 0.5 + 0.4 * i
  local centre = model:node { x, y, z }
  for arm = 0, 3 do
    local angle = 0.5 * i + arm * math.pi / 2
    local tip = model:node { x + 1.2 * math.cos(angle), y + 1.2 * math.sin(angle), z }
    model:member { centre, tip, section = bar, material = steel, group = "debris" }
  end
end

model:gravity { 0, 0, -g }
model:ground { friction = mu }
model:contact { friction = mu }
model:damping { beta = 2e-6 } -- of vibration alone

local run = model:dynamic { integrator = "explicit", dt = "auto", duration = 2 }
local before = run:snapshot()
run:finish()

local lowest = math.huge
for _, z in ipairs(run:read("node_z", "debris")) do lowest = math.min(lowest, z) end
local energy = run.energy
local given = energy.initial - energy.gravity
print(("the bar slides %.3f m, by hand %.3f m"):format(tail:displacement(), 3 ^ 2 / (2 * mu * g)))
print(("deepest in the ground: %s 20 mm"):format(side / 2 - lowest < 0.02 and "below" or "above"))
print(("in motion after 2 s: %s 1 %% of the energy"):format(energy.kinetic < 0.01 * given and "below" or "above"))
print(("where it went: %s"):format(energy.ground_dissipated > energy.damping + energy.contact_released
  and "most of it into the ground" or "most of it into contacts and damping"))
print(("energy error below 0.1 %%: %s"):format(math.abs(run.energy_error) < 1e-3))

local view = { width = 800, height = 500, from = { -0.6, -1.4, 0.4 }, box = { -1.2, 3.4, -2.2, 1.5, 0, 1.8 } }
hinge.strip({ { before, view }, { run, view } }, 2, "contact_and_debris.png")
