-- 500 kg of TNT explode on the ground, 20 m in front of a two-storey frame. See blast.md.
local hinge = require "hinge"
local blast = hinge.blast

local bay, height, spacing = 6, 3.5, 4 -- m; frames stand 4 m apart
local steel = hinge.material.steel "S275"
local column, beam = hinge.section.named "HEB 300", hinge.section.named "IPE 400"
local panel = 500 -- kg/m^2, concrete on the front columns
local floor = 600 * spacing -- kg/m on the beams

-- Steel that weighs as much as the member and what it carries, kg/m.
local function with_mass(section, more)
  return hinge.material { E = steel.E, yield_stress = steel.yield_stress, density = 7850 + more / section.area }
end
local materials = { front = with_mass(column, panel * spacing), rear = steel, floors = with_mass(beam, floor) }

-- The frame: at[1][k] are the nodes of the front column, at[2][k] those of the rear one, k = 0 at the foot. Each storey
-- of a column has two members. The floors hold the beams at their third points.
local function frame()
  local model, at = hinge.model { interaction = "exact" }, {}
  local function member(from, to, section, group)
    return model:member { from, to, section = section, material = materials[group], group = group, elements = 4,
      up = group == "floors" and { 0, 0, 1 } or { 1, 0, 0 } }
  end
  for i, group in ipairs { "front", "rear" } do
    at[i] = {}
    for k = 0, 4 do
      at[i][k] = model:node { (i - 1) * bay, 0, k * height / 2 }
      model:fix(at[i][k], k == 0 and "all" or "y,rx,rz")
      if k > 0 then member(at[i][k - 1], at[i][k], column, group) end
    end
  end
  for k = 2, 4, 2 do
    local from = at[1][k]
    for part = 1, 3 do
      local to = part == 3 and at[2][k] or model:node { part / 3 * bay, 0, k * height / 2 }
      if part < 3 then model:fix(to, "y,rx,rz") end
      member(from, to, beam, "floors")
      from = to
    end
  end
  model:gravity { 0, 0, -9.81 }
  return model, at
end

local function largest(list)
  local most = 0
  for _, value in ipairs(list) do most = math.max(most, math.abs(value)) end
  return most
end

-- Loads the front columns and lets the frame move; returns what is drawn.
local function strike(shape)
  local explosion = blast { charge = 500, at = { -20, 0, 0 }, shape = shape }
  local model, at = frame()
  local force, impulse, parts = explosion:load(model, { group = "front", normal = { -1, 0, 0 }, width = spacing })
  local rest = model:static { steps = 2 }:finish()
  local run = model:dynamic { from = rest, dt = 2e-4, duration = 0.3 }
  local middle = run:probe { node = at[1][1], "ux" }
  local floors = { run:probe { node = at[1][2], "ux" }, run:probe { node = at[1][4], "ux" } }
  local momentum = 0
  for _ in run:steps() do momentum = math.max(momentum, run:momentum().linear[1]) end
  assert(run.verdict == "completed", run.reason)
  print(("%-11s %.1f MN and %.1f kN s; the frame takes up %.1f kN s; column %.0f mm, floors %.0f and %.0f mm"):format(
    shape, force / 1e6, impulse / 1e3, momentum / 1e3, 1e3 * largest(middle.value), 1e3 * largest(floors[1].value),
    1e3 * largest(floors[2].value)))
  return explosion, parts, run, middle, floors
end

local explosion, parts, run, middle, floors = strike "friedlander"
strike "triangle"
for i, part in ipairs(parts) do
  print(("front column, part %d: %.2f m away, struck after %.1f ms, %.0f kPa, %.0f Pa s"):format(i, part.distance,
    1e3 * part.arrival, part.pressure / 1e3, part.impulse / (part.width * part.member.length)))
end

-- The pressure on a face over time, in ms and kPa; what a probe has recorded, in ms and mm.
local function curve(name, point, normal)
  local c = { name = name, x = {}, y = {} }
  for i = 0, 600 do
    c.x[i + 1], c.y[i + 1] = i / 10, explosion:pressure(point, normal, 1e-4 * i) / 1e3
  end
  return c
end
local function path(name, probe)
  local c = { name = name, x = {}, y = {} }
  for i, t in ipairs(probe.time) do c.x[i], c.y[i] = 1e3 * t, 1e3 * probe.value[i] end
  return c
end
hinge.plot({ panels = {
  { series = { curve("front, foot", { 0, 0, 0 }, { -1, 0, 0 }), curve("roof", { 0, 0, 7 }, { 0, 0, 1 }),
    curve("rear, foot", { bay, 0, 0 }, { 1, 0, 0 }) }, x_label = "ms", y_label = "kPa", title = "pressure" },
  { series = { path("front column, 1.75 m up", middle), path("first floor", floors[1]), path("roof", floors[2]) },
    x_label = "ms", y_label = "mm", title = "to the rear" } } }, "blast_histories.png")
hinge.picture(run, { view = "front", scale = 5, ghost = true, width = 700, height = 600 }, "blast.png")
