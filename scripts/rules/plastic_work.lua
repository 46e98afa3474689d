-- A rule with memory: a joint breaks when damage from plastic work reaches a limit.
--
-- Run     hinge run scripts/rules/plastic_work.lua
-- Shows   the tip of a cantilever moves up and down slowly. A plastic hinge at the wall rotates to and fro until it
--         breaks
-- Expect  break_s = 0.905 within 0.5 %             in the fifth stroke s. The first one has the work Mp (s - u) / L,
--                                                  each other one Mp (s - 2 u) / L. u = Mp L^2 / (3 E I) is the
--                                                  elastic part. Strokes up count in full, strokes down one third
--         damage = 1 within 0.1 %                  largest damage that the rule has kept
--         work_J = 1835 within 0.5 %               plastic work until then
--         energy_error_percent = 0 within 0.3      energy error, of the work at the moved end
--
-- The rule keeps two numbers for each section: the plastic work at its last call, and the damage. The joint is welded
-- at its lower side. This side is in tension when the tip goes up (Mx < 0). section.plastic_work alone does not show
-- the direction.
local hinge = require "hinge"

local L, side, yield_stress, sway, period, limit = 1, 0.05, 245e6, 0.1, 0.4, 1300 -- m, m, Pa, m, s, J
local steel = hinge.material { E = 206e9, density = 7850, yield_stress = yield_stress }
local bar   = hinge.section.solid { width = side, depth = side }

local model = hinge.model { displacement = "small" }
local wall, tip = model:node { 0, 0, 0 }, model:node { L, 0, 0 }
model:fix(wall, "all")
local member = model:member { wall, tip, section = bar, material = steel }
model:move { node = tip, z = function(t) return sway * (1 - math.cos(2 * math.pi * t / period)) / 2 end }

local worst = 0
model:fracture {
  keep = { "seen", "damage" },
  rule = function(section)
    local counts = section.Mx < 0 and 1 or 1 / 3
    section.damage = section.damage + counts * (section.plastic_work - section.seen) / limit
    section.seen = section.plastic_work
    worst = math.max(worst, section.damage)
    return section.damage >= 1
  end,
}

local run = model:dynamic { dt = 2.5e-5, duration = 1.2 }:finish()
local _, _, time = member:state()
time = time or 0 -- 0: it did not break
print(("broken at %.4f s, after %.1f J of plastic work"):format(time, run.energy.plastic))
return { break_s = time, work_J = run.energy.plastic, damage = worst,
  energy_error_percent = 100 * run.energy.energy_error / run.energy.work }
