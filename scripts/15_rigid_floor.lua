-- A floor that is rigid in its plane is pushed beside its centre: it shifts and turns. A balcony on a rigid offset.
--
-- Run     hinge run scripts/15_rigid_floor.lua
-- Shows   model:diaphragm and model:rigid_link, with nothing stiff that would have to be chosen
-- Expect  by hand, of four clamped columns with free heads, k = 1 / (h^3 / 3 E I + h / k G A):
--         shift_mm = 11.191 within 0.001      F / 4 k, of the middle
--         turn_mrad = 2.673 within 0.001      F x / (4 (k (x^2 + y^2) + G J / h)), of every corner
--         foot_knm = 8 within 0.0001          a load of 5 kN, 1.6 m from the axis of its column
local hinge = require "hinge"

local concrete = hinge.material { E = 30e9, G = 12.5e9, density = 2500 }
local column = hinge.section.solid { width = 0.3, depth = 0.3 }

local model = hinge.model { displacement = "small" }
local heads = {}
for i, at in ipairs { { -2, -1.5 }, { 2, -1.5 }, { 2, 1.5 }, { -2, 1.5 } } do
  local foot = model:node { at[1], at[2], 0 }
  heads[i] = model:node { at[1], at[2], 3 }
  model:fix(foot)
  model:member { foot, heads[i], section = column, material = concrete }
end
model:diaphragm { nodes = heads }
model:load { node = heads[2], force = { 0, 100e3, 0 } }
local run = model:static { steps = 1 }:finish()
local left, right = select(2, run:displacement(heads[1])), select(2, run:displacement(heads[2]))
local turn = select(6, run:displacement(heads[3]))

local balcony = hinge.model { displacement = "small" }
local foot, axis = balcony:node { 0, 0, 0 }, balcony:node { 0, 0, 3 }
local face, rail = balcony:node { 0.15, 0, 3 }, balcony:node { 1.6, 0, 3 }
balcony:fix(foot)
balcony:member { foot, axis, section = column, material = concrete }
balcony:member { face, rail, section = column, material = concrete }
balcony:rigid_link { from = axis, to = face }
balcony:load { node = rail, force = { 0, 0, -5e3 } }
local moment = select(5, balcony:static { steps = 1 }:finish():reaction(foot))

return { shift_mm = 1e3 * (left + right) / 2, turn_mrad = 1e3 * turn, foot_knm = -1e-3 * moment }
