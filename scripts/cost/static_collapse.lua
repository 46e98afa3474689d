-- What elements a member cost up to collapse: the paper's space frame (figure 10) pushed past its limit load.
--
-- Run     hinge cost scripts/cost/static_collapse.lua --within 1%   (hinge run: its default, asi-gauss, two elements)
-- Shows   a corner of the cube is pushed 20 mm sideways; the load on the way, and at the end, where all hinges have
--         formed
-- Expect  asi-gauss: error of 0.009 % with two elements and 50 steps of load, order 0.99 in steps. asi: 6.1 % with two
--         (plastic work) and 0.37 % with eight. conventional: 91 % too strong with two and 6.01 % with sixteen, for any
--         steps
local hinge       = require "hinge"
local space_frame = require "hinge.models.space_frame"
local paper       = require "hinge.paper"

return hinge.scenario {
  -- N, m, m, m, Pa, *reconstructed*
  parameters = { load = 8000.0, reach = 0.02, side = 0.25, thickness = 0.02, yield_stress = 245e6 },
  accuracy = { elements_per_member = { 2, 4, 8, 16 }, steps = { 100, 50, 200 },
    formulation = { "asi-gauss", "asi", "conventional" } },
  run = function(p)
    local model = hinge.model { formulation = p.formulation, elements_per_member = p.elements_per_member,
      displacement = "small", interaction = "paper" }
    local steel = hinge.material { E = 206e9, nu = 0.3, yield_stress = p.yield_stress }
    local frame = space_frame.add(model, { side = p.side, thickness = p.thickness, material = steel })
    model:load { node = frame.loaded, force = { p.load, 0, 0 } }
    local run = model:static { steps = p.steps, control = { node = frame.loaded, "ux", to = p.reach } }
    local ux, load = { 0 }, { 0 }
    for _ in run:steps() do ux[#ux + 1], load[#load + 1] = (run:displacement(frame.loaded)), run.factor * p.load end
    return { limit_load = run.factor * p.load, load = paper.sampled(ux, load, p.reach, 50),
      plastic = run.energy.plastic }
  end,
}
