-- The flying beam of Simo and Vu-Quoc: a free flexible beam that is pushed and turned at one end.
--
-- Run     hinge run scripts/benchmarks/flying_beam.lua
-- Shows   free flight of a body that bends far and rotates: momentum from the impulse, energy kept afterwards
-- Expect  20 kg m/s along x, and the pushed end at (9.77, 8.21) m after 5 s; the reference is good to 0.5 %
--
-- The beam goes from (6, 0) to (0, 8) m. A force of 8 N along x and a moment of -80 N m act on its lower end for 2.5 s
-- and then stop. It takes 40 elements: the moment bends the pushed end sharply.
local hinge = require "hinge"

local pushed, F, M = 2.5, 8, -80

local function fly(elements, dt)
  local model = hinge.model { elements_per_member = elements, plasticity = false }
  local low, high = model:node { 6, 0, 0 }, model:node { 0, 8, 0 }
  model:fix({ low, high }, "z,rx,ry")
  local material = hinge.material { E = 1e4, nu = -0.5, density = 1 }
  local section = hinge.section.general { area = 1, Ix = 0.01, Iy = 0.01, J = 0.01, shear_area_x = 1, shear_area_y = 1,
    mass_Ix = 10, mass_Iy = 10 }
  model:member { low, high, section = section, material = material }
  model:load { node = low, force = { F, 0, 0 }, moment = { 0, 0, M },
    history = { { 0, 1 }, { pushed, 1 }, { pushed, 0 }, { 1000, 0 } } }
  local run = model:dynamic { dt = dt, duration = 5, integrator = "energy-momentum", record = false }
  run:finish()
  local x, y = run:displacement(low)
  return run, 6 + x, y
end

return hinge.benchmark {
  title = "Flying beam", kind = "dynamics", fast = true,
  source = "momentum: closed form; else Simo and Vu-Quoc's problem (1986), computed apart to 0.5 %",
  run = function(b)
    local run, x, y = fly(40, 0.0125)
    local energy = run.energy.kinetic + run.energy.elastic
    local row = b:rows_with { elements = 40, steps = run.index }
    row("momentum along x", run:momentum().linear[1], F * pushed, "kg m/s", 1e-6)
    row("pushed end at 5 s, x", x, 9.77, "m", 6e-3)
    row("pushed end at 5 s, y", y, 8.21, "m", 2e-3)
    row("energy at 5 s", energy, 378.75, "J", 4e-3)
  end,
}
