-- A cantilever under a force at its tip, to first order: bending and shear.
--
-- Run     hinge run scripts/benchmarks/timoshenko_cantilever.lua
-- Shows   that two asi-gauss elements are exact in elastic bending and shear, for slender and for stocky members
-- Expect  P L^3 / (3 EI) + P L / (k G A), k = 5/6; 3.112854 mm for 1 kN on 1 m of a steel square of 50 mm. A member
--         as long as it is thick has 44 % of its deflection from shear
local hinge = require "hinge"

local E, nu, side, P = 206e9, 0.3, 0.05, 1000
local G, EI, area = E / (2 * (1 + nu)), E * side ^ 4 / 12, side ^ 2

local function tip_of(L)
  local model = hinge.model { displacement = "small", elements_per_member = 2 }
  local wall, tip = model:node { 0, 0, 0 }, model:node { L, 0, 0 }
  model:fix(wall)
  model:member { wall, tip, section = hinge.section.solid { width = side, depth = side },
    material = hinge.material { E = E, nu = nu } }
  model:load { node = tip, force = { 0, 0, -P } }
  local _, _, uz, _, ry = tip:displacement(model:static { steps = 1 }:finish())
  return -uz, ry
end

return hinge.benchmark {
  title = "Timoshenko cantilever", kind = "elastic", fast = true, source = "closed form, Timoshenko beam",
  run = function(b)
    for _, L in ipairs { 1, side } do
      local uz, ry = tip_of(L)
      b:row { ("deflection, L / h = %d"):format(L // side), computed = 1000 * uz, unit = "mm", elements = 2,
        reference = 1000 * (P * L ^ 3 / (3 * EI) + P * L / (5 / 6 * G * area)), tolerance = 1e-6 }
      if L == 1 then
        b:row { "slope, L / h = 20", computed = ry, reference = P * L ^ 2 / (2 * EI), unit = "rad", elements = 2,
          tolerance = 1e-6 }
      end
    end
  end,
}
