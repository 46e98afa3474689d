-- A portal that is loaded suddenly, computed with several elements and time steps: see accuracy.md.
local hinge = require "hinge"

local steel = hinge.material { E = 206e9, density = 7850, yield_stress = 235e6 }
local bar = hinge.section.h { depth = 0.2, width = 0.2, web = 0.008, flange = 0.012 }

return hinge.scenario {
  parameters = { load = 120e3 },
  accuracy = {
    dt = { 2e-3, 1e-3 },
    elements_per_member = { 2, 4 },
    formulation = { "asi-gauss", "conventional" },
  },
  run = function(p)
    local model = hinge.model { formulation = p.formulation, elements_per_member = p.elements_per_member }
    local node = { model:node { 0, 0, 0 }, model:node { 0, 0, 3 }, model:node { 5, 0, 3 }, model:node { 5, 0, 0 } }
    model:fix { node[1], node[4] }
    for i = 1, 3 do model:member { node[i], node[i + 1], section = bar, material = steel } end
    for i = 2, 3 do model:mass { node = node[i], mass = 5000 } end
    model:load { node = node[2], force = { p.load, 0, 0 } }
    local run = model:dynamic { dt = p.dt, duration = 0.4 }
    local sway = run:probe { node = node[3], "ux", name = "sway" }
    run:finish()
    print(("peak %.1f mm, plastic work %.2f kJ"):format(1000 * sway.max, run.energy.plastic / 1e3))
    return { peak_mm = 1000 * sway.max, plastic_work_kJ = run.energy.plastic / 1e3 }
  end,
}
