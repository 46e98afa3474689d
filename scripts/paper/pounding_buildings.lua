-- Neighbouring buildings that pound in an earthquake, after a later paper of the same group: D. Isobe, T. Ohta,
-- T. Inoue and F. Matsueda, Seismic pounding and collapse behavior of neighboring buildings with different natural
-- periods, Natural Science 4 (2012).
--
-- Run     hinge run scripts/paper/pounding_buildings.lua     (quick=true: the first 5 s of the first two cases)
-- Shows   three frames of 14 storeys, one after the other with narrow joints, on ground that moves in a long period:
--         all alike; the first one softer; and the same three far apart
-- Expect  alike: no contact, all stand. Softer: they pound from 4.07 s on, and the first two come down; the third
--         stands. Far apart: all stand. pounding.png, sway.png; a minute and a half
--
-- The paper's text says that three similar buildings, the Nuevo Leon buildings in Mexico City, stood with narrow joints
-- between them, that two of them collapsed in the earthquake of 1985, and that their collision may come from natural
-- periods that differ, as after damage by an earlier earthquake. All numbers here are chosen: plane steel frames, and a
-- ground that moves as a sine of 2 s that grows and fades.
local hinge = require "hinge"
local paper = require "hinge.paper"

local g, thickness = 9.80665, 0.019
local storey, bay, bays, depth = 3, 6, 2, 0.7 -- m
local beam = hinge.section.h { depth = depth, width = 0.2, web = 0.010, flange = 0.016 }

-- The three buildings; softer: the first one's period over that of the others. Returns the model, the two joints at the
-- top of each building that face a neighbour, and all feet.
local function build(p, softer, gap)
  local model = hinge.model {}
  local roofs, feet, x0 = {}, {}, 0
  for b = 1, 3 do
    local E = 206e9 * (b == 1 and softer ^ -2 or 1)
    local column = hinge.material { E = E, density = 7850, yield_stress = p.yield_stress }
    local floor = hinge.material { E = E, density = p.load / g / beam.area, yield_stress = p.yield_stress }
    local group, below = "building " .. b, {}
    for level = 0, p.storeys do
      local here = {}
      for i = 0, bays do
        here[i] = model:node { x0 + bay * i, 0, storey * level }
        if level == 0 then
          feet[#feet + 1] = here[i]
        else
          model:fix(here[i], "y,rx,rz")
          local side = p.side - 0.15 * (level - 1) / (p.storeys - 1)
          model:member { below[i], here[i], material = column, group = group, up = { 0, 1, 0 },
            section = hinge.section.box { width = side, depth = side, thickness = thickness } }
          if i > 0 then model:member { here[i - 1], here[i], section = beam, material = floor, group = group } end
        end
      end
      below = here
    end
    roofs[b] = { below[0], below[bays] }
    local most_curved = p.rotation / (bay / 2) -- of an element, of which a beam has two
    model:fracture { group = group, curvature_x = most_curved, curvature_y = most_curved }
    x0 = x0 + bay * bays + p.side + gap
  end
  model:fix(feet, "all")
  model:ground { point = { 0, 0, -0.5 }, friction = 0.4 }
  model:gravity { 0, 0, -g }
  return model, roofs, feet
end

-- Acceleration of the ground, as parts of its largest: it grows for two periods and fades in the last two.
local function motion(p, dt)
  local record, long = {}, p.cycles * p.period
  for i = 0, math.floor(long / dt) do
    local t = i * dt
    record[i + 1] = math.sin(2 * math.pi * t / p.period) * math.min(1, t / (2 * p.period), (long - t) / (2 * p.period))
  end
  return record
end

local function shake(p, case, job)
  local model, roofs, feet = build(p, case.softer, case.gap)
  local rest = model:static { steps = 1 }:finish()
  local periods = {}
  for i, mode in ipairs(rest:modes { n = 3 }) do periods[i] = mode.period end
  model:move { node = feet, x = hinge.ground { dt = 0.01, acceleration = motion(p, 0.01), scale = p.acceleration } }
  local first, contacts = nil, 0
  for b = 1, 2 do
    model:contact { between = { "building " .. b, "building " .. b + 1 }, on_contact = function(event)
      first, contacts = first or event.time, contacts + 1
    end }
  end
  local run = model:dynamic { from = rest, dt = p.dt, duration = p.duration }
  local sway, pictures = { {}, {}, {} }, {}
  local times = case.picture and { 4.2, 8, 12, 15.5 } or {}
  for b = 1, 3 do sway[b] = { name = "building " .. b, x = {}, y = {} } end
  for step in run:steps() do
    if step.index % 10 == 0 then
      for b = 1, 3 do
        local s = sway[b]
        s.x[#s.x + 1], s.y[#s.y + 1] = run.time, roofs[b][1]:displacement(run) - feet[1]:displacement(run)
      end
    end
    if run.time >= (times[#pictures + 1] or math.huge) then
      pictures[#pictures + 1] = { run:snapshot(), { title = ("%.1f s"):format(run.time), width = 800, height = 700,
        box = { -20, 65, -1, 1, -2, 46 } } }
    end
  end
  if case.picture then
    if #pictures > 0 then job:strip(pictures, 2, "pounding.png") end
    job:plot({ title = "Sway of the roofs, the first building softer", x_label = "time, s", y_label = "m",
      series = sway, y_range = { -2, 2 } }, "sway.png")
  end
  local row, down = { case.name, ("%.2f, %.2f"):format(periods[1], periods[3]), first and ("%.2f"):format(first) or "-",
    contacts }, 0
  for b = 1, 3 do
    local _, _, z = roofs[b][1]:displacement(run)
    if -z > storey then down = down + 1 end
    row[#row + 1] = run:count { group = "building " .. b, state = "broken" }
  end
  row[#row + 1], row[#row + 2], row[#row + 3] = down, run.verdict, ("%.3f"):format(100 * run.energy_error)
  return row, { first_contact = first, contacts = contacts, down = down, verdict = run.verdict }
end

return hinge.scenario {
  parameters = {
    storeys = 14, side = 0.55,              -- m: outer side of the columns of the first storey, less by 0.15 at the top
    load = 40e3, yield_stress = 325e6,      -- N/m of the beams; Pa
    rotation = 0.03,                        -- rad, of a beam's half where it breaks; a column: at the same curvature
    gap = 0.1, softer = 1.25,               -- m; natural period of the first building over that of the others
    acceleration = 1, period = 2, cycles = 9, -- m/s2, s
    dt = 1e-3, duration = 16, quick = false,     -- s
  },
  run = function(p, job)
    local rows, results = {}, {}
    local cases = { { name = "alike", softer = 1, gap = p.gap },
      { name = "softer", softer = p.softer, gap = p.gap, picture = true },
      { name = "far apart", softer = p.softer, gap = 10 } }
    if p.quick then p, cases[3] = setmetatable({ duration = 5 }, { __index = p }), nil end
    for i, case in ipairs(cases) do rows[i], results[case.name] = shake(p, case, job) end
    paper.table("Three buildings on the same ground", { "case", "periods, s", "first contact, s", "contacts",
      "broken in 1", "in 2", "in 3", "buildings down", "verdict", "energy error, %" }, rows)
    return results
  end,
}
