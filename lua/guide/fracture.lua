-- One of two hangers breaks at a limit of strain: see fracture.md.
local hinge = require "hinge"

local steel = hinge.material { E = 206e9, density = 7850, yield_stress = 235e6 }
local rod = hinge.section.round { diameter = 0.012 }
local tube = hinge.section.box { width = 0.15, depth = 0.15, thickness = 0.008 }
local limit, rate, g = 0.001, 60e3, 9.80665 -- strain, N/s, m/s^2

-- A beam hangs from two rods.
local model = hinge.model {}
local hooks = { model:node { 0, 0, 2 }, model:node { 4, 0, 2 } }
local ends = { model:node { 0, 0, 0 }, model:node { 4, 0, 0 } }
model:fix(hooks, "all")
local left = model:member { hooks[1], ends[1], section = rod, material = steel, group = "hangers" }
model:member { hooks[2], ends[2], section = rod, material = steel, group = "hangers" }
local beam = model:member { ends[1], ends[2], section = tube, material = steel, group = "beam" }
model:fracture { group = "hangers", axial_strain = limit }

-- At rest under its weight.
model:gravity { 0, 0, -g }
local rest = model:static { steps = 1 }:finish()

-- Then a load on the left end rises until the hanger breaks.
model:load {
  node = ends[1],
  force = function(t, run) return 0, 0, left:state(run) == "broken" and 0 or -rate * t end,
}
local run = model:dynamic { from = rest, dt = 1e-5, duration = 0.7 }
local mass = run:momentum().mass
run:finish()

-- By hand: the strain at the top of the hanger, and the strain energy of its upper half at that strain.
local EA, weight = steel.E * rod.area, (beam.mass / 2 + left.mass) * g
local _, _, time, element = left:state()
print(("%s, element %d"):format(left, element))
print(("time of the break %.2f ms, by hand %.2f ms"):format(1e3 * time, 1e3 * (EA * limit - weight) / rate))
print(("strain energy released %.2f J, by hand %.2f J"):format(run.energy.fracture_elastic,
  EA * limit ^ 2 / 2 * left.length / 2))
print(("kinetic energy lost %.3f J"):format(run.energy.fracture_kinetic))
print(("mass before and after %.2f kg, %.2f kg"):format(mass, run:momentum().mass))
print(("energy error %.2f %% of the largest energy"):format(100 * math.abs(run.energy_error)))

local view = { width = 800, height = 500, view = "front", box = { -0.5, 4.5, -1, 1, -1, 2.1 } }
hinge.strip({ { rest, view }, { run, view } }, 2, "fracture.png")
