-- A function of the script decides when a member breaks.
--
-- Run     hinge run scripts/07_custom_fracture_rule.lua
-- Shows   a rod with one end fixed; the other end is pulled away with constant acceleration. The rod breaks at a strain
--         of 2 %, once by a numerical limit and once by a function
-- Expect  ms = 20 within 0.5 %                     when the moved end has gone 2 % of the length:
--                                                  t = sqrt(2 * 0.02 L / a)
--         same = 1 exactly                         both give the same result, to the bit
--         energy_error_percent = 0 within 0.01     energy error, of the work at the pulled end
--
-- More rules of this kind: rules/plastic_work.lua (damage that adds up), rules/strain_rate.lua (a limit that rises with
-- the speed), rules/joint_interaction.lua (axial force and bending together, at the joints only).
local hinge = require "hinge"

local L, limit, acceleration = 1, 0.02, 100 -- m, -, m/s^2
local glass = hinge.material { E = 45e9, density = 2000 }
local rod   = hinge.section.round { diameter = 0.02 }

local function pull(rule)
  local model = hinge.model {}
  local held, pulled = model:node { 0, 0, 0 }, model:node { L, 0, 0 }
  model:fix(held, "all")
  local member = model:member { held, pulled, section = rod, material = glass, elements = 8 }
  model:move { node = pulled, x = function(t) return acceleration * t ^ 2 / 2 end }
  model:fracture(rule)
  local run = model:dynamic { dt = 1e-5, duration = 0.025 }:finish()
  local _, _, time = member:state()
  return run, time or 0 -- 0: it did not break
end

local by_numbers, time = pull { axial_strain = limit }
local by_function      = pull(function(section) return math.abs(section.axial_strain) >= limit end)

print(("the rod breaks at %.3f ms; by hand %.3f ms"):format(1e3 * time, 1e3 * math.sqrt(2 * limit * L / acceleration)))
return {
  ms = 1e3 * time, same = by_numbers.hash == by_function.hash and 1 or 0,
  energy_error_percent = 100 * by_function.energy.energy_error / by_function.energy.work,
}
