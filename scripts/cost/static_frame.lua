-- What elements a member cost in elastic statics: the paper's space frame (figure 8) pushed sideways.
--
-- Run     hinge cost scripts/cost/static_frame.lua --within 1%   (hinge run: its default, asi-gauss, two elements)
-- Shows   one cube of eight members, small displacement, elastic, 50 steps of load, by the three formulations
-- Expect  asi-gauss is exact with two elements. The other two are of second order and reach 1 % only with sixteen
local hinge       = require "hinge"
local space_frame = require "hinge.models.space_frame"

return hinge.scenario {
  parameters = { load = 8000.0, side = 0.25, thickness = 0.02 }, -- N, m, *reconstructed*
  accuracy = { elements_per_member = { 2, 4, 8, 16 }, formulation = { "asi-gauss", "asi", "conventional" } },
  run = function(p)
    local model = hinge.model { formulation = p.formulation, elements_per_member = p.elements_per_member,
      displacement = "small" }
    local steel = hinge.material { E = 206e9, nu = 0.3 }
    local frame = space_frame.add(model, { side = p.side, thickness = p.thickness, material = steel })
    model:load { node = frame.loaded, force = { p.load, 0, 0 } }
    local run = model:static { steps = 50 }:finish()
    local ux = run:displacement(frame.loaded)
    return { ux = ux, elastic = run.energy.elastic }
  end,
}
