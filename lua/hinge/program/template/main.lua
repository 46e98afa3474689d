-- PROJECT: a steel portal stands under its own weight and a floor's, and takes a blow against its left corner.
--
--   hinge run main.lua                     the values below
--   hinge run main.lua impulse=15e3        another value; hinge run main.lua --case weak: several at once
--   hinge plan main.lua                    what would be simulated, and why
--   hinge reference model:member           what a call takes; hinge reference -s buckling searches
local hinge = require "hinge"

-- SI units: m, kg, s, N, Pa.
local parameters = {
  height = 4, -- m, of the columns
  span = 6, -- m, of the beam
  floor_mass = 1000, -- kg/m on the beam
  impulse = 10e3, -- N s, of the blow, over 50 ms
  duration = 0.5, -- s, of the dynamic run
  dt = 5e-4, -- s, a time step
}

-- The structure. Returns the model, its corners.
local function portal(p)
  local steel = hinge.material { E = 206e9, nu = 0.3, density = 7850, yield_stress = 235e6 }
  local column = hinge.section.h { depth = 0.2, width = 0.2, web = 0.009, flange = 0.015 }
  local beam = hinge.section.h { depth = 0.25, width = 0.18, web = 0.0065, flange = 0.01 }
  local model = hinge.model { elements_per_member = 4 }
  local feet = { model:node { 0, 0, 0 }, model:node { p.span, 0, 0 } }
  local corners = { model:node { 0, 0, p.height }, model:node { p.span, 0, p.height } }
  model:fix(feet)
  model:fix(corners, "y") -- held out of plane, as by purlins
  for i = 1, 2 do
    model:member { feet[i], corners[i], section = column, material = steel, group = "columns" }
  end
  -- The floor is mass along the beam, so that gravity gives its weight. A load beside it would count it twice.
  local laden = hinge.material { E = 206e9, nu = 0.3, density = 7850 + p.floor_mass / beam.area, yield_stress = 235e6 }
  model:member { corners[1], corners[2], section = beam, material = laden, group = "beams" }
  model:gravity { 0, 0, -9.80665 }
  -- Members break there: 0.070 - 0.0003 d rad, d = 9.8 in, of beams with reduced sections by UFC 4-023-03, table 5-2.
  model:fracture { hinge_rotation_x = 0.067, hinge_rotation_y = 0.067, elongation = 0.3 }
  return model, corners
end

-- One run. `p`: the parameters.
local function simulate(p)
  local model, corners = portal(p)

  -- 1. Under its own weight and the floor's, in statics.
  local rest = model:static { steps = 4 }:finish()
  if rest.verdict == "failed" then return {} end -- hinge says why, and ends with status 1

  -- 2. The blow, in dynamics: a triangle of force over 50 ms.
  model:load { node = corners[1], force = { 2 * p.impulse / 0.05, 0, 0 },
    history = { { 0, 0 }, { 0.025, 1 }, { 0.05, 0 } } }
  local run = model:dynamic { from = rest, dt = p.dt, duration = p.duration }
  local sway = run:probe { node = corners[1], "ux", name = "sway" }
  run:finish()

  -- 3. Pictures, and the results that summary.json keeps.
  hinge.picture(run, { title = "PROJECT, after the blow", from = { -0.2, -1, 0.2 } }, "portal.png")
  hinge.plot(run, { sway, "kinetic", "elastic", "plastic" }, "sway.png")
  return {
    largest_sway_mm = 1000 * sway.max,
    plastic_work_kJ = run.energy.plastic / 1000,
    yielded = run:count { state = "yielded" },
    broken = run:count { state = "broken" },
  }
end

if ... then -- the program: it gives the settings
  return hinge.scenario {
    parameters = parameters,
    cases = { weak = { impulse = 3e3 }, tall = { height = 6 } },
    accuracy = { dt = { 5e-4, 1e-3, 2.5e-4 } }, -- for hinge cost
    run = simulate,
  }
end
for name, value in pairs(simulate(parameters)) do print(name, value) end -- plain Lua: lua5.4 main.lua
