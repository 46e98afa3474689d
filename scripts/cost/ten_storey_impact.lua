-- What time steps cost in Case I with the heavy frame, shortened: the nose hits a column, the first members break.
--
-- Run     hinge cost scripts/cost/ten_storey_impact.lua --within 1%   (or --quantity before.plastic;
--                                                                     after=12e-3: far into fracture)
--         hinge cost scripts/cost/ten_storey_impact.lua --effects
--         hinge cost scripts/cost/ten_storey_impact.lua --effects floor=slab scheme=explicit height=28.6 after=0.03
-- Shows   energies of two runs, before the first member breaks and after it. It varies the integrator, the time step
--         and the contact rule
-- Expect  error of plastic work before: under 1 % at all steps. After: 11 % at 20 us, and 0.9 % at 10 us, where the
--         same three members break. Iterations and double precision change neither. Explicit steps differ by 23 %
--         before (lumped mass), surface contact by 12 % (another contact law). With after=12e-3 the energies after the
--         break are chaotic: that of fracture scatters by 9 %, so they have means in place of errors.
--         These are errors of the step. Elements change more: with 4 and 8 of them gap elements bind later (eq 18), and
--         plastic work before is 39 and 0 kJ in the place of 385 (../studies/impact_elements.lua)
--         With slabs that the aircraft strikes (the third command): panels with their mass take 91 % of the time, and
--         change the plastic work by 5.7 %. Contact of panels changes it by 0.7 % and costs nothing. Bending cannot be
--         left out: statics refuses a flat slab without it
local hinge    = require "hinge"
local building = require "hinge.models.ten_storey"
local aircraft = require "hinge.models.aircraft"

local schemes = { -- integrator and contact rule
  ["newmark"] = { beta = 0.4 }, ["newmark, double"] = { beta = 0.4, precision = "double" },
  ["newmark, iterated"] = { beta = 0.4, iterations = 4 },
  ["newmark, surface"] = { beta = 0.4 }, ["explicit"] = { integrator = "explicit" },
}

return hinge.scenario {
  -- m/s, m, kg, m, s
  parameters = { speed = 440 / 3.6, size = 15.0, mass = 15000.0, height = 30.0, before = 3e-3, after = 6e-3,
    floor = "none" }, -- or "weight", "slab"
  accuracy = { dt = { 1e-5, 2e-5, 4e-5 },
    scheme = { "newmark", "newmark, double", "newmark, iterated", "newmark, surface", "explicit" } },
  run = function(p)
    local model = hinge.model { p_delta = "chord", interaction = "paper", weight = "nodes" } -- as in the paper
    local frame = building.add(model, { design = "heavy", floor = p.floor })
    local plane = aircraft.add(model, { design = "slender", size = p.size, mass = p.mass, speed = p.speed,
      position = { -0.5, frame.size[2] / 2, p.height } })
    local surface = p.scheme:find "surface"
    model:gravity { 0, 0, -9.80665 }
    model:fracture { curvature_x = 0.4, curvature_y = 0.4, axial_strain = 0.3 }
    model:contact { rule = surface and "surface" or "gap", binding_time = not surface and 0.5e-3 or nil }
    if p.floor == "slab" then model:panel_contact { friction = 0.5, restitution = 0.3 } end
    local run = model:static { fixed_group = plane, steps = 1 }:finish()
    local function go_on(duration)
      local options = { from = run, dt = p.dt, duration = duration }
      for name, value in pairs(schemes[p.scheme]) do options[name] = value end
      run = model:dynamic(options):finish()
      return { elastic = run.energy.elastic, plastic = run.energy.plastic, fracture = run.energy.fracture,
        broken = run:count { state = "broken" } }
    end
    local before = go_on(p.before)
    return { before = before, after = go_on(p.after - p.before) }
  end,
}
