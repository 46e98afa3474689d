-- Which frame and which aircraft does the paper describe? Its figure 16 is lost. Each case of this study draws what
-- figure 16 gave, within bounds of the text, and runs Cases I to IV, each with the aircraft 0, 1 and 2 mm aside.
--
-- Run     hinge study scripts/paper/lost_inputs.lua --samples 128 --method sobol
--         (39 minutes on two busy cores; --resume goes on after an interruption; --samples 16 for a first look)
--         hinge run scripts/paper/findings.lua study=out/lost_inputs-study    (which findings hold, and where)
--         hinge run scripts/paper/lost_inputs.lua bay=6 column=30    (one frame; newmark=true: by Newmark, 10 us)
-- Shows   for each case the means, the least and the most of three runs: columns and beams of the building that break,
--         plastic work, members of the aircraft that touch nothing
-- Expect  as it stands, inner columns cut in Cases I to IV: 5 to 6, 4 to 6, 4 to 8, 5 to 6
--
-- Bounds by the text: the floors weigh twenty times the steel; the density of the aircraft's members is increased, also
-- for the 12 t of Case III; the building stands under its own weight (f_y below 0.6); 849 members of two elements.
-- By sense: storeys of 3 to 4.2 m, bays of 5 to 9 m, floors of 150 to 500 kg/m^2, structural steel, duralumin.
local hinge    = require "hinge"
local aircraft = require "hinge.models.aircraft"
local impact   = require "hinge.models.ten_storey_impact"

local g, steel_density, duralumin_density = 9.80665, 7850, 2800
local lightest, largest = 12000, 15 -- kg, m: the aircraft whose density is increased least

-- Eq 16 in other readings. `kappa` is the limit of curvature, 1/m: the paper's 0.0004 as 1/mm, or as 1/cm.
local readings = {
  element = { axial_strain = 0.3 },                                             -- as printed
  section = { axial_strain = 0.3, strain_measure = "section" },                        -- the hinge's own rotation
  tension = { axial_strain = 0.3, tension_only = true },                        -- not in compression
  plastic = { axial_strain = 0.3, strain_measure = "section", plastic_only = true },   -- only where fully plastic
  later = { axial_strain = 0.17, shear_strain = 2.6e-2, kappa = 0.3333 / 0.4 }, -- limits of Isobe's later papers
}

local function limits(p)
  local o = impact.with(readings[p.reading], {})
  local kappa = p.kappa * (o.kappa or 1)
  o.kappa, o.curvature_x, o.curvature_y = nil, kappa, kappa
  return o
end

-- Box section with the area wanted.
local function box(area, wall)
  local thickness = math.sqrt(area / (4 * (wall - 1)))
  return hinge.section.box { width = wall * thickness, depth = wall * thickness, thickness = thickness }
end

-- The sections follow from the load of the floors and from what the columns carry. The steel of the frame is a
-- twentieth of its floors. An inner column of the ground floor carries rho g (260 storey A_c + 420 bay A_b). Returns
-- nothing if even the lightest beams leave f_y above 0.58 there.
local function building_of(p)
  local stress = math.sqrt(0.58) * p.yield_stress * 1e6
  local least, most = 0.3, (stress / (steel_density * g) - 260 * p.storey) / (420 * p.bay) -- A_b / A_c
  if most < least then return nil end
  local ratio = least + p.beams * (most - least)
  local area = 8 * p.bay ^ 2 * p.floor / (steel_density * (250 * p.storey + 400 * p.bay * ratio))
  local depth = math.sqrt(ratio * area / (2 * 0.039 * 0.5 + 0.0265 * (1 - 2 * 0.039)))
  return {
    bay = p.bay, storey = p.storey, column = box(area, p.column),
    beam = hinge.section.h { depth = depth, width = 0.5 * depth, web = 0.0265 * depth, flange = 0.039 * depth },
  }
end

local function aircraft_of(p)
  local shape = { body = p.body, wing_sweep = p.sweep }
  local _, facts = aircraft.add(hinge.model {}, { size = largest, shape = shape })
  return {
    shape = shape, section = box(p.metal * lightest / (duralumin_density * facts.length), p.plane_wall),
    material = hinge.material { E = 70.6e9, nu = 0.33, density = duralumin_density,
      yield_stress = p.plane_yield * 1e6 },
  }
end

-- Model of one run, and the building at rest.
local function at_rest(p, case, aside)
  local model = hinge.model { p_delta = "chord", interaction = "paper", weight = "nodes" } -- as in the paper
  local changes = impact.cases[case]
  local frame, plane = impact.add(model, {
    speed = changes.speed, mass = changes.mass, size = changes.size, height = p.height * p.storey,
    offset = p.offset * p.bay + aside, contact = p.contact, yield_stress = p.yield_stress * 1e6,
    building = building_of(p), aircraft = aircraft_of(p),
    fracture = function(m) m:fracture(limits(p)) end,
  })
  return model, frame, model:static { fixed_group = plane }:finish()
end

-- The impact. dt: s, nil for the explicit scheme's own. Also returns when the first column that was compressed carries
-- tension, s after first contact, if `watched`.
local function impact_run(p, model, rest, dt, watched)
  local run = model:dynamic { from = rest, dt = dt or "auto", integrator = p.newmark and "newmark" or "explicit",
    beta = p.newmark and 0.4 or nil, duration = p.duration, record = 1000 }
  local before, touched, tension = rest:read("N", "columns"), nil, nil
  for step in run:steps() do
    if watched and not tension and step.index % 10 == 0 then
      touched = touched or run.contacts.bound > 0 and run.time
      for i, n in ipairs(touched and run:read("N", "columns") or {}) do
        if before[i] < 0 and n > -0.01 * before[i] then tension = run.time - touched end
      end
    end
  end
  return run, tension
end

-- One run's results. A run that fails, by its energy balance, is made again with half the step.
local function simulate(p, case, aside)
  local watched = case == "I" and aside == 0
  local model, frame, rest = at_rest(p, case, aside)
  local f_y = math.max(table.unpack(rest:read("f_y", "columns")))
  if rest.verdict ~= "completed" or f_y >= 0.6 then return nil end
  local run, tension = impact_run(p, model, rest, p.newmark and 1e-5 or nil, watched)
  local again = run.verdict == "failed"
  if again then
    model, frame, rest = at_rest(p, case, aside)
    run, tension = impact_run(p, model, rest, 0.5 * p.duration / run.planned_steps, watched)
  end
  local d = impact.damage(run, frame)
  return {
    inner = d.broken_inner, outer = d.broken_outer, beams = d.broken_beams, work = d.work / 1e6, lowest = d.lowest,
    work_aircraft = d.work_aircraft / 1e6, broken_aircraft = d.broken_aircraft, missed = d.missed,
    moving = run.energy.kinetic / 1e6, ground = run:count { group = "storey 1", state = "yielded" },
    failed = run.verdict == "failed" and 1 or 0, again = again and 1 or 0, error = math.abs(run.energy_error),
  }, { f_y = f_y, floor = frame.floor_load, tension = tension or -1 }
end

-- Of these the study keeps the least and the most of the three runs too; of the others the mean.
local spread = { inner = true, outer = true, beams = true, work = true, missed = true }

local function three_runs(p, case)
  local all, facts = {}, nil
  for i = 1, 3 do
    local r, f = simulate(p, case, (i - 1) * 1e-3)
    if not r then return nil end
    all[i], facts = r, facts or f
  end
  local result = {}
  for name in pairs(all[1]) do
    local a, b, c = all[1][name], all[2][name], all[3][name]
    result[name] = (a + b + c) / 3
    if spread[name] then result[name .. "_least"], result[name .. "_most"] = math.min(a, b, c), math.max(a, b, c) end
  end
  return result, facts
end

return hinge.scenario {
  parameters = {
    bay = 6.5, storey = 3.5, floor = 252,          -- m, m, kg/m^2
    beams = 0.35,                                  -- 0: A_b = 0.3 A_c; 1: the most that the columns can carry
    yield_stress = 325, column = 33.3,             -- MPa; width of the box over its thickness
    metal = 0.977,                                 -- mass of the aircraft's members by their own density, over 12 t
    plane_wall = 18.75, plane_yield = 275,         -- width over thickness of its members; MPa
    body = 0.12265, sweep = 0.1,                   -- side of the fuselage, sweep of the wings, over the length
    height = 6.6, offset = 0,                      -- storeys; bays to the left of the middle row of columns
    contact = "surface", reading = "element", kappa = 0.4,
    duration = 0.25, newmark = false, quick = false, -- s; quick: 20 ms
  },
  vary = {
    bay = "uniform(5,9)", storey = "uniform(3,4.2)", floor = "uniform(150,500)", beams = "uniform(0,1)",
    yield_stress = "uniform(235,355)", column = "uniform(18,45)", metal = "uniform(0.3,1)",
    plane_wall = "uniform(8,30)", plane_yield = "uniform(245,345)", body = "uniform(0.09,0.16)",
    sweep = "uniform(-0.05,0.2)", height = "uniform(6.1,8.4)", offset = "uniform(0,0.5)",
    contact = "choice(surface,surface,gap)", reading = "choice(element,section,tension,plastic,later)",
    kappa = "choice(0.4,0.04)",
  },
  run = function(p)
    if p.quick then p = impact.with(p, { duration = 0.02 }) end
    local results = { allowed = false }
    if not building_of(p) then return results end
    for _, case in ipairs(impact.order) do
      local facts
      results[case], facts = three_runs(p, case)
      if not results[case] then return { allowed = false } end
      if case == "I" then for name, value in pairs(facts) do results[name] = value end end
    end
    results.allowed = true
    return results
  end,
}
