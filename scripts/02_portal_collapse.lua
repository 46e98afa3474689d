-- A portal frame is pushed until it collapses.
--
-- Run     hinge run scripts/02_portal_collapse.lua
-- Shows   a frame of square bars with fixed feet, a load on its left corner and the same load on the middle of its
--         beam. The run controls the displacement of the corner, so it can go on where the load no longer rises
-- Expect  limit_kN = 6.5625 within 0.05 %          6 Mp / (h + L/2): hinges in the middle of the beam, on the
--                                                  right and in both feet
--         hinges = 4 exactly                       one more than the degree of redundancy: a mechanism
--         energy_error_percent = 0 within 0.02     energy error, of the loads' work
--
-- Below the limit load the curve has a kink where a hinge forms. The sway mechanism alone would need 4 Mp / h, the beam
-- mechanism alone 8 Mp / L. Both are more. Axial forces reduce Mp by (N / N0)^2 (eq 14), here by a ten thousandth.
local hinge = require "hinge"

local h, L, side, yield_stress = 4, 6, 0.05, 245e6
local Mp = side ^ 3 / 4 * yield_stress

local model = hinge.model { displacement = "small" }
local steel = hinge.material { E = 206e9, density = 7850, yield_stress = yield_stress }
local bar   = hinge.section.solid { width = side, depth = side }
local feet  = { model:node { 0, 0, 0 }, model:node { L, 0, 0 } }
local left, middle, right = model:node { 0, 0, h }, model:node { L / 2, 0, h }, model:node { L, 0, h }
model:fix(feet, "all")
for _, joints in ipairs { { feet[1], left }, { left, middle }, { middle, right }, { right, feet[2] } } do
  model:member { joints[1], joints[2], section = bar, material = steel }
end
model:load { node = left, force = { 1000, 0, 0 } }
model:load { node = middle, force = { 0, 0, -1000 } }

local run = model:static { steps = 50, control = { node = left, "ux", to = 0.8 } }
print "sway mm   load kN"
for step in run:steps() do
  if step.index % 5 == 0 then print(("%7.0f %9.4f"):format(1000 * left:displacement(), step.factor)) end
end

-- A hinge at a corner may be in both members there, so joints are counted.
local flowing = {}
for _, member in ipairs(model:members()) do
  local a, b = member:forces()
  if a.f_y > 0.999 then flowing[member.a] = true end
  if b.f_y > 0.999 then flowing[member.b] = true end
end
local hinges = 0
for _, joint in ipairs(model:nodes()) do
  if flowing[joint] then
    hinges = hinges + 1
    print("hinge at " .. tostring(joint))
  end
end
print(("limit load %.4f kN; by hand %.4f kN"):format(run.factor, 6 * Mp / (h + L / 2) / 1000))
return { limit_kN = run.factor, hinges = hinges,
  energy_error_percent = 100 * run.energy.energy_error / run.energy.work }
