-- A small aircraft hits a ten-storey steel frame: the paper's section 4, figures 17 and 18.
--
-- Run     hinge run scripts/ten_storey_impact.lua                 (Case I, 0.25 s, 25,000 steps)
--         hinge run scripts/ten_storey_impact.lua --case II       (or III, IV), or any parameter: speed=400/3.6 dt=2e-5
--         hinge run scripts/ten_storey_impact.lua integrator=explicit floor=slab      (with floors, 75 s of one core)
-- Shows   the frame under the weight of frame and floors, then the impact: hinges, fracture, contact, no damping
-- Expect  a table of damage by storey and group, the energy balance and the wall time by stage, how far the aircraft
--         gets; frame.png: all members in six colours of f_y, fractured ones black; upper_storeys.png: the upper
--         five storeys without fractured members; frames.pvd for ParaView. With floors 32 to 37 columns are cut,
--         without 23 to 24, and 60 to 63 % of the aircraft's momentum are left, without 60 to 73 % (explicit steps,
--         three runs each: lua/guide/falling_floors.md)
--
-- The paper's figure 16 is lost. The frame, the aircraft's members and the place of the impact are reconstructed: the
-- study scripts/paper/lost_inputs.lua chose them. --case heavy is Case I with a heavy frame, of which no column is cut.
local hinge    = require "hinge"
local building = require "hinge.models.ten_storey"
local aircraft = require "hinge.models.aircraft"
local report   = require "hinge.report"

-- How far the aircraft gets. way, m: of its centre of mass along x, the integral of its momentum. reach, m: its
-- foremost joint behind the facade, at any time, broken off or not. momentum, kinetic: the parts of them that are left.
local function follow(run, plane)
  local first, before, time = run:momentum(plane), run:momentum(plane), run.time
  local f = { way = 0, reach = -math.huge }
  function f.look()
    local now = run:momentum(plane)
    f.way = f.way + (before.linear[1] + now.linear[1]) / 2 / now.mass * (run.time - time)
    f.momentum, f.kinetic = now.linear[1] / first.linear[1], now.kinetic / first.kinetic
    for _, x in ipairs(run:read("node_x", plane)) do f.reach = math.max(f.reach, x) end
    before, time = now, run.time
  end
  return f
end

local function torn_panels(run, floor)
  local torn = 0
  for _, panel in ipairs(floor and floor.slab or {}) do
    if panel:torn(run) then torn = torn + 1 end
  end
  return torn
end

return hinge.scenario {
  parameters = {
    speed = 440 / 3.6, size = 15, mass = 15000,        -- m/s, m, kg: the paper's table 1, Case I
    design = "light", aircraft = "stiff",              -- of the building, of the aircraft's members
    -- m: axis above ground, left of the middle, nose before the facade
    height = 23.8, offset = 0, gap = 0.5,
    contact = "gap",                                   -- the paper's rule, or "surface"
    curvature = 0.04, strain_measure = "section",      -- 1/m: the paper's 0.0004 as 1/cm; which hinges it limits
    duration = 0.25, frame_every = 250,                -- s, steps
    interaction = "paper",                             -- of N, Mx and My where a section yields: eq 14, or "exact"
    floor = "none", friction = 0.5, restitution = 0.3, -- or "weight", "slab"; of slabs that are struck
    integrator = "newmark",                            -- or "explicit"
  },
  cases    = { I = {}, II = { speed = 320 / 3.6 }, III = { mass = 12000 }, IV = { size = 12 },
    heavy = { design = "heavy", aircraft = "slender", height = 30, curvature = 0.4, strain_measure = "element" } },
  accuracy = { dt = { 1e-5, 2e-5, 4e-5 }, elements_per_member = { 2, 4 }, formulation = { "asi-gauss", "asi" } },

  run = function(p, job)
    local model = hinge.model { formulation = p.formulation, elements_per_member = p.elements_per_member,
      p_delta = "chord", interaction = p.interaction, weight = "nodes" } -- as in the paper
    local frame = building.add(model, { design = p.design, bays = { 4, 4 }, storeys = 10, floor = p.floor })
    local plane, parts = aircraft.add(model, { design = p.aircraft,
      size = p.size, mass = p.mass, speed = p.speed, heading = { 1, 0, 0 },
      position = { -p.gap, frame.size[2] / 2 + p.offset, p.height },
    })
    model:gravity { 0, 0, -9.80665 }
    model:fracture { curvature_x = p.curvature, curvature_y = p.curvature, axial_strain = 0.3,
      strain_measure = p.strain_measure }
    model:contact { rule = p.contact, binding_time = p.contact == "gap" and 0.5e-3 or nil }
    if p.floor == "slab" then model:panel_contact { friction = p.friction, restitution = p.restitution } end

    local loaded = model:static { fixed_group = plane }
    loaded:finish()

    local run = model:dynamic { from = loaded, dt = p.dt, duration = p.duration, integrator = p.integrator,
      beta = p.integrator == "newmark" and 0.4 or nil, checkpoint = "impact.checkpoint" }
    local flight = follow(run, plane)
    for step in run:steps() do
      if step.index % p.frame_every == 0 then
        flight.look()
        job:frame(run)
      end
    end
    flight.look()

    local groups = { "columns", "inner columns", "outer columns", "beams" }
    table.move(frame.storey_groups, 1, #frame.storey_groups, #groups + 1, groups)
    table.move(parts.groups, 1, #parts.groups, #groups + 1, groups)
    local upper = frame.size[3] / 2 - 0.5 -- half a metre below the sixth floor, so that its beams are in
    job:picture(run, { title = ("f_y at %.3g s"):format(run.time) }, "frame.png")
    job:picture(run, { title = "upper five storeys", above = upper, leave_out_broken = true, groups = { "building" } },
      "upper_storeys.png")
    local damage = report.show(run, groups)
    print(("\naircraft: its centre has gone %.2f m, its foremost joint was %.2f m behind the facade, %.1f %% of its "
      .. "momentum and %.1f %% of its kinetic energy are left"):format(flight.way, flight.reach, 100 * flight.momentum,
      100 * flight.kinetic))
    return { damage = damage, broken_columns = damage.columns.broken, broken_beams = damage.beams.broken,
      way = flight.way, reach = flight.reach, momentum = flight.momentum, kinetic = flight.kinetic,
      torn_panels = torn_panels(run, frame.floor) }
  end,
}
