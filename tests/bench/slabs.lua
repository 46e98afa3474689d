-- What slabs cost in a step: a building of some storeys, 4 by 3 bays with 4 by 4 panels each, that sways.
--
-- Run     hinge run -q tests/bench/slabs.lua [storeys=10 steps=50]
-- Shows   time of a step on the processor and the energy error, by both methods: the frame with its floors as masses in
--         trapezoids, with an elastic slab of steel, with one of concrete and bars, and one that bends by its layers
local hinge = require "hinge"

local slabs = {
  steel = { thickness = 0.012, material = hinge.material { E = 210e9, density = 7850 } },
  concrete = { concrete = { thickness = 0.13, E = 33e9, strength = 30e6 },
    reinforcement = { x = 4e-4, y = 4e-4, yield_stress = 500e6, hardening = 1e9, ultimate_strain = 0.05 },
    bending = { stiffness = 1.5e6, sagging = 20e3, hogging = 20e3 } },
}
slabs.layers = { concrete = slabs.concrete.concrete, bending = "layers",
  reinforcement = { x = 4e-4, y = 4e-4, z = -0.03, yield_stress = 500e6, hardening = 1e9, ultimate_strain = 0.05 } }

local function building(storeys, slab)
  local model = hinge.model { elements_per_member = 4 }
  local grid = hinge.grid { model = model, x = { count = 4, spacing = 6 }, y = { count = 3, spacing = 5 },
    z = { count = storeys, spacing = 3.5 } }
  grid:fix "all"
  grid:defaults { material = hinge.material.steel "S355" }
  grid:columns { section = hinge.section.named "HEB 300", up = { 1, 0, 0 }, group = "columns" }
  for _, along in ipairs { "x", "y" } do
    grid:beams { along = along, section = hinge.section.named "IPE 400", group = "beams" }
  end
  model:gravity { 0, 0, -9.81 }
  model:floor { group = "beams", mass = 400, slab = slab }
  return model, model:static { steps = 1 }:finish()
end

return hinge.scenario { parameters = { storeys = 10, steps = 50 }, run = function(p)
  local out = {}
  for _, name in ipairs { "frame", "steel", "concrete", "layers" } do
    local model, rest = building(p.storeys, slabs[name])
    model:velocity("beams", { 0.2, 0, 0 }) -- m/s
    for _, integrator in ipairs { "newmark", "explicit" } do
      local cracks = name == "concrete" or name == "layers" -- which longer steps do not follow
      local dt = integrator == "explicit" and 2e-5 or cracks and 2e-4 or 2e-3
      local run = model:dynamic { from = rest, dt = dt, duration = dt * p.steps, integrator = integrator, rest = false,
        record = false, step_control = integrator == "newmark" and 0 or nil }
      local begun = os.clock()
      run:finish()
      local ms = 1e3 * (os.clock() - begun) / p.steps
      print(("%-8s %-8s %.2f ms a step, energy error %.1e, %s"):format(name, integrator, ms, run.energy_error,
        run.verdict))
      out[name .. "_" .. integrator] = ms
    end
    model:close()
  end
  return out
end }
