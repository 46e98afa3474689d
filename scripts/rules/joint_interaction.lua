-- A joint that fails under axial force and bending together: (N / N_c)^2 + (M / M_c)^2 >= 1.
--
-- Run     hinge run scripts/rules/joint_interaction.lua
-- Shows   a cantilever whose weld at the wall is weaker than the bar. A load that rises slowly pulls it in three
--         directions until the weld breaks. The free end, which is a joint too, and the sections inside the member do
--         not break
-- Expect  along_kN = 200 within 0.5 %              N_c
--         inclined_kN = 19.925 within 0.5 %        1 / sqrt((cos a / N_c)^2 + (L sin a / M_c)^2) for a = 30 degrees
--         across_kN = 10 within 0.5 %              M_c / L
--         energy_error_percent = 0 within 0.01     energy error, of the work of all loads together
local hinge = require "hinge"

local L, N_c, M_c = 1, 200e3, 10e3 -- m, N, N m
local steel = hinge.material { E = 206e9, density = 7850 }
local box   = hinge.section.box { width = 0.1, depth = 0.1, thickness = 0.005 }

-- section.node is the joint at the section, nil inside a member.
local function weld(section)
  if not section.node then return false end
  return (section.N / N_c) ^ 2 + (section.Mx ^ 2 + section.My ^ 2) / M_c ^ 2 >= 1
end

local function strength(angle)
  local model = hinge.model { displacement = "small" }
  local wall, tip = model:node { 0, 0, 0 }, model:node { L, 0, 0 }
  model:fix(wall, "all")
  local member = model:member { wall, tip, section = box, material = steel }
  local by_hand = 1 / math.sqrt((math.cos(angle) / N_c) ^ 2 + (L * math.sin(angle) / M_c) ^ 2)
  local last = 1.2 * by_hand
  -- The load starts smoothly and is slow compared with the first period of the bar, 7 ms. So it hardly vibrates.
  model:load { node = tip, force = { last * math.cos(angle), 0, -last * math.sin(angle) },
    history = function(t) return t ^ 2 end }
  model:fracture { where = "all", rule = weld }
  local run = model:dynamic { dt = 1e-4, duration = 1 }
  local work, energy_error = 0, 0
  run:on_step(function()
    if member:state() == "broken" then return run:stop() end
    work, energy_error = run.energy.work, run.energy.energy_error
  end)
  run:finish()
  local _, _, time = member:state()
  local reached = last * (time or 0) ^ 2 / 1e3 -- 0: it did not break
  print(("%3.0f degrees: breaks at %.3f kN, by hand %.3f kN"):format(math.deg(angle), reached, by_hand / 1e3))
  return reached, math.abs(100 * energy_error / work)
end

local results, lost = {}, 0
for _, test in ipairs { { "along", 0 }, { "inclined", 30 }, { "across", 90 } } do
  local energy_error
  results[test[1] .. "_kN"], energy_error = strength(math.rad(test[2]))
  lost = lost + energy_error
end
results.energy_error_percent = lost
return results
