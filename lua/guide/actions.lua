-- Actions on a small frame: pressure on floors and a wall, load combinations, and a lorry that crosses. See actions.md.
local hinge = require "hinge"

local bay, depth, height = 6, 5, 4 -- m
local steel = hinge.material { E = 210e9, density = 7850 }
local column, beam = hinge.section.named "HEB 200", hinge.section.named "IPE 360"
local with_floor = steel:with { density = 7850 + 1000 / beam.area } -- 1 t of floor moves with each metre of beam

-- Two bays along x and one along y. Returns the two beams along y = 0, and the joint where the second one ends.
local function frame()
  local model, at, deck = hinge.model { displacement = "small", mass = "cubic" }, {}, {}
  local function add_beam(from, to)
    return model:member { from, to, section = beam, material = with_floor, up = { 0, 0, 1 }, elements = 4,
      group = "beams" }
  end
  for i = 0, 2 do
    at[i] = {}
    for k = 0, 1 do
      local foot = model:node { i * bay, k * depth, 0 }
      model:fix(foot)
      at[i][k] = model:node { i * bay, k * depth, height }
      model:member { foot, at[i][k], section = column, material = steel, up = { 1, 0, 0 }, group = "columns" }
      if i > 0 then
        local along = add_beam(at[i - 1][k], at[i][k])
        if k == 0 then deck[i] = along end
      end
    end
    add_beam(at[i][0], at[i][1])
  end
  return model, deck, at[2][0]
end

-- Pressure on both bays of the floor, and wind on the wall at x = 0; value in Pa.
local function load_floors(model, case, value)
  for i = 0, 1 do
    local x, X = i * bay, (i + 1) * bay
    local floor = hinge.pressure { model = model, group = "beams", case = case, value = value, direction = { 0, 0, -1 },
      spread = "two way", on = { { x, 0, height }, { X, 0, height }, { X, depth, height }, { x, depth, height } } }
    print(("%-6s bay %d: %s"):format(case, i + 1, floor))
  end
end
local function load_wall(model, case, value)
  local wall = hinge.pressure { model = model, group = "columns", case = case, value = value, direction = { 1, 0, 0 },
    spread = "one way", on = { { 0, 0, 0 }, { 0, depth, 0 }, { 0, depth, height }, { 0, 0, height } } }
  print(("%-6s wall:  %s"):format(case, wall))
end

local model, deck, far = frame()
for _, case in ipairs { "dead", "office", "snow", "wind" } do model:case(case) end
load_floors(model, "dead", 4e3)
load_floors(model, "office", 3e3)
load_floors(model, "snow", 0.8e3)
load_wall(model, "wind", function(_, _, z) return 600 + 50 * z end)

-- Combinations: all of them run; the ones with the largest values are printed.
local cases = { dead = "G", office = { "Q", category = "B" }, snow = { "S", altitude = 500 }, wind = "W" }
local ultimate = hinge.combinations { model = model, standard = "EN 1990", kind = "ULS", cases = cases }
local hogging, sway = { 0 }, { 0 }
for _, combination in ipairs(ultimate) do
  local run = model:static { steps = 1, loads = combination.name, record = false }:finish()
  local _, at_middle = deck[1]:forces(run)
  local moment, ux = math.abs(at_middle.Mx), far:displacement(run)
  if moment > hogging[1] then hogging = { moment, combination.name } end
  if math.abs(ux) > sway[1] then sway = { math.abs(ux), combination.name } end
end
print(("%d combinations for %s"):format(#ultimate, ultimate.kind))
print(("beam at the middle joint: %.1f kN m by %s"):format(hogging[1] / 1e3, hogging[2]))
print(("sway: %.2f mm by %s"):format(1e3 * sway[1], sway[2]))
print(hinge.combinations { model = model, standard = "EN 1990", kind = "SLS characteristic", cases = cases,
  omit = false })

-- Influence line of that moment, for 1 N that moves along y = 0; and what two axles make of it, if slow.
local at_rest, its_deck = frame()
local line = hinge.moving_load.influence { model = at_rest, members = its_deck, read = function(run)
  return select(2, its_deck[1]:forces(run)).Mx
end }.value
local axles = { { force = 60e3 }, { force = 90e3, distance = 3 } } -- N, m
local function slow(s)
  local sum = 0
  for _, axle in ipairs(axles) do
    local x = s - (axle.distance or 0)
    for i = 2, #line.x do
      if x > line.x[i - 1] and x <= line.x[i] then
        local part = (x - line.x[i - 1]) / (line.x[i] - line.x[i - 1])
        sum = sum + axle.force * (line.y[i - 1] + part * (line.y[i] - line.y[i - 1]))
      end
    end
  end
  return sum
end

-- The same axles at a speed.
local shaken, crossed = frame()
local lorry = hinge.moving_load { model = shaken, members = crossed, axles = axles, speed = 20 }
print(lorry)
local run = shaken:dynamic { dt = 5e-4, duration = lorry.leaves + 0.1 }
local fast, still = { name = "20 m/s", x = {}, y = {} }, { name = "slow", x = {}, y = {} }
local largest, largest_slow = 0, 0
for _ in run:steps() do
  local s, moment = lorry.speed * run.time, select(2, crossed[1]:forces(run)).Mx
  largest, largest_slow = math.max(largest, math.abs(moment)), math.max(largest_slow, math.abs(slow(s)))
  table.insert(fast.x, s)
  table.insert(fast.y, moment / 1e3)
  table.insert(still.x, s)
  table.insert(still.y, slow(s) / 1e3)
end
assert(run.verdict == "completed", run.reason)
print(("the moment reaches %.1f kN m, and %.1f kN m if the lorry is slow"):format(largest / 1e3, largest_slow / 1e3))
line.name = "influence line"
hinge.plot({ panels = {
  { series = { line }, x_label = "position of 1 N, m", y_label = "N m", title = "moment of the beam at the middle" },
  { series = { still, fast }, x_label = "first axle, m", y_label = "kN m", title = "a lorry" } } }, "actions.png")
