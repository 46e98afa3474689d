-- Does a small or a large, a fast or a slow aircraft do more damage, if all bring the same kinetic energy? The question
-- that the paper leaves open: its table 1 changes speed, mass and size one at a time, and with them the energy.
--
-- Run     hinge study scripts/studies/aircraft.lua size=10:20:2.5 speed=100,122.22,150 offset=0,0.001,0.002 -j 2
--         hinge run scripts/studies/show.lua aircraft=out/aircraft-study          (the table and the plots)
-- Shows   the heavy building and its aircraft at the energy of Case I, 112 MJ; the mass follows from the speed. Every
--         case three times, with the aircraft at its place and 1 and 2 mm aside: by how much these differ is scatter
-- Expect  plastic work in the building falls with size, 13 to 6 MJ from 10 to 20 m at 122 m/s, and with speed; the
--         number of members with a hinge falls with speed, and not with size. No column or beam breaks
--         case 1 with path=1: hinged = 12 within 3, touched = 1 exactly
local hinge  = require "hinge"
local impact = require "hinge.models.ten_storey_impact"

return hinge.scenario {
  parameters = {
    speed = 440 / 3.6, size = 15,           -- m/s, m: Case I
    energy = 0.5 * 15000 * (440 / 3.6) ^ 2, -- J, of Case I
    design = "heavy", offset = 0,           -- m, of the aircraft's axis: left of the building's middle
    gap = 0.5, path = 24,                   -- m that the aircraft would fly before and behind the facade in the run
  },
  run = function(p)
    local mass = 2 * p.energy / p.speed ^ 2
    local model = hinge.model { p_delta = "chord", interaction = "paper", weight = "nodes" } -- as in Case I
    local frame, plane = impact.add(model, impact.with(p, { mass = mass }))
    local rest = model:static { fixed_group = plane }:finish()
    local run = model:dynamic { from = rest, dt = "auto", integrator = "explicit",
      duration = (p.gap + p.path) / p.speed }
    run:finish()
    local d = impact.damage(run, frame)
    return {
      mass_t = mass / 1e3, work_MJ = d.work / 1e6, work_aircraft_MJ = d.work_aircraft / 1e6,
      moving_MJ = run.energy.kinetic / 1e6, hinged = d.hinged_columns + d.hinged_beams,
      touched = d.touched_inner + d.touched_outer + d.touched_beams,
      broken_columns = d.broken_columns, broken_beams = d.broken_beams, broken_aircraft = d.broken_aircraft,
    }
  end,
}
