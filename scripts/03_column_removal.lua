-- A frame suddenly loses a column.
--
-- Run     hinge run scripts/03_column_removal.lua
-- Shows   a beam over three columns, at rest under its weight; the middle column is broken by
--         a rule that tests the time
-- Expect  dynamic_factor = 1.994 within 0.2 %       largest drop of the joint over the static one; 2 for one mass
--                                                   on a spring
--         static_mm = 16.013 within 0.01 %         static drop of the joint without the column
--         broken = 1 exactly                       the column alone
--         energy_error_percent = 0 within 0.01     energy error, of the potential energy released
--
-- Why twice: when the frame reaches the new equilibrium, half of the work of gravity is kinetic energy. It moves the
-- frame down as far again.
local hinge = require "hinge"

local steel = hinge.material { E = 206e9, density = 7850 }
local floor = hinge.material { E = 206e9, density = 60000 } -- the beam carries a floor
local box   = hinge.section.box { width = 0.2, depth = 0.2, thickness = 0.01 }
local I     = hinge.section.h { depth = 0.4, width = 0.2, web = 0.008, flange = 0.013 }

local function frame(columns)
  local model = hinge.model { displacement = "small" }
  local top = {}
  for i = 1, 3 do
    top[i] = model:node { 6 * (i - 1), 0, 4 }
    if columns[i] then
      local foot = model:node { 6 * (i - 1), 0, 0 }
      model:fix(foot, "all")
      model:member { foot, top[i], section = box, material = steel, group = columns[i] }
    end
  end
  for i = 1, 2 do model:member { top[i], top[i + 1], section = I, material = floor, group = "beams", elements = 8 } end
  model:gravity { 0, 0, -9.80665 }
  return model, top[2]
end

local function height(joint) return select(3, joint:displacement()) end

local without, joint = frame { "sides", nil, "sides" }
without:static { steps = 1 }:finish()
local lower = height(joint)

local model, middle = frame { "sides", "removed", "sides" }
model:fracture {
  group = "removed", where = "all",
  rule = function(section) return section.time >= 0.02 and section.node == middle.index end, -- at its head
}
local rest = model:static { steps = 1 }:finish()
local upper = height(middle)

local run = model:dynamic { from = rest, dt = 2e-4, duration = 0.6 }
local drop = run:probe { node = middle, "uz" }
run:finish()

print(("standing %.3f mm, without the column %.3f mm, deepest %.3f mm")
  :format(1e3 * upper, 1e3 * lower, 1e3 * drop.min))
return {
  dynamic_factor = (drop.min - upper) / (lower - upper), static_mm = 1e3 * (upper - lower),
  broken = run:count { state = "broken" },
  energy_error_percent = 100 * run.energy.energy_error / -run.energy.gravity,
}
