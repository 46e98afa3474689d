-- What floors cost in a step, as loads and as masses along beams: a building of 10 storeys, 5 by 4 bays, at rest.
--
-- Run     hinge run -q tests/bench/floors.lua
-- Shows   time of a step of 2 ms on the processor, and the energy error: floors in the density of beams, as even masses
--         along them, as masses in trapezoids, and with a live load in trapezoids beside them
local hinge = require "hinge"

local function at_rest(floors)
  local model = hinge.model()
  local grid = hinge.grid { model = model, x = { count = 5, spacing = 6 }, y = { count = 4, spacing = 5 },
    z = { count = 10, spacing = 3.5 } }
  grid:fix "all"
  local steel, beam = hinge.material.steel "S355", hinge.section.named "IPE 400"
  local area, length = 30 * 20, 5 * 6 * 5 + 6 * 5 * 4 -- of a storey and of its beams, m^2 and m
  grid:defaults { material = steel }
  grid:columns { section = hinge.section.named "HEB 300", up = { 1, 0, 0 }, group = "columns" }
  local laden = floors == "density" and steel:with { density = 7850 + 400 * area / length / beam.area } or steel
  for _, along in ipairs { "x", "y" } do
    grid:beams { along = along, section = beam, material = laden, group = "beams" }
  end
  model:gravity { 0, 0, -9.81 }
  if floors == "even" then model:mass { group = "beams", per_length = 400 * area / length } end
  if floors == "two ways" then grid:floor { mass = 400 } end
  if floors == "with load" then grid:floor { mass = 400, load = 1e3 } end
  return model, model:static { steps = 1 }:finish()
end

return hinge.scenario { parameters = { steps = 200, rounds = 2 }, run = function(p)
  local out = {}
  for round = 1, p.rounds do
    for _, floors in ipairs { "density", "even", "two ways", "with load" } do
      local model, rest = at_rest(floors)
      local run = model:dynamic { from = rest, dt = 2e-3, duration = 2e-3 * p.steps, rest = false, record = false }
      local begun = os.clock()
      run:finish()
      local ms = 1e3 * (os.clock() - begun) / p.steps
      if round == p.rounds then
        print(("%-10s %.2f ms a step, energy error %.1e"):format(floors, ms, run.energy_error))
        out[floors:gsub(" ", "_")] = ms
      end
      model:close()
    end
  end
  return out
end }
