-- Which columns may a building lose? Each is taken away at once, in the manner of the alternate path method
-- (UFC 4-023-03, GSA 2016): the frame is at rest under its floors, then the column breaks. One case a column.
--
-- Run     hinge study scripts/studies/robustness.lua x=1:4:1 y=1:3:1 storey=1:4:1 -j 2
--         hinge run scripts/studies/show.lua robustness=out/robustness-study      (the map and the table)
--         hinge study scripts/studies/robustness.lua x=1:2:1 y=1:2:1 storey=1:4:1 floor=none,diaphragm,slab \
--           --out out/robustness-floors -j 2                           (with floors; a quarter of the building)
-- Shows   a steel frame of 3 by 2 bays and 4 storeys, whose columns have little to spare: 48 columns
-- Expect  case 1, a corner of the ground floor: holds, dynamic_factor = 2.069 within 0.02
--         case 19, inside, storey 3: full collapse, largest_drop = 3.49 within 0.1 m
--         all: the 4 corners of each storey hold, 32 full collapses; columns at mirrored places agree
--
-- A joint has fallen once it was lower by a tenth of a bay, 0.7 m, than at rest, within 1.25 s.
--   holds           no joint has fallen
--   local collapse  joints have fallen, all of them above the lost column
--   full collapse   joints of other columns have fallen as well
-- The limit of 0.1 rad at which a beam breaks is chosen for the example. There is no contact and no ground: what falls
-- does not strike the floor below. UFC and GSA have loads, limits and rules of their own, which are not in here.
local hinge = require "hinge"

local g, bay, height, bays, storeys = 9.80665, 7, 4, { 3, 2 }, 4

-- floor = "slab": 10 cm of concrete, a mesh of 252 mm^2/m each way; bending as it is when cracked.
local slab = {
  concrete = { thickness = 0.1, E = 30e9, strength = 25e6 },
  reinforcement = { x = 252e-6, y = 252e-6, yield_stress = 500e6, hardening = 1e9, ultimate_strain = 0.05 },
  bending = { stiffness = 0.25 * 30e9 * 0.1 ^ 3 / 12, sagging = 8.8e3, hogging = 8.8e3 },
}

-- The frame; column: { x, y, storey } of the one to lose, and whether it is there. Returns the model, all joints as
-- { node =, x =, y =, level = }, and the joint above that column.
local function frame(p, is_there)
  local model = hinge.model { interaction = p.interaction, elements_per_member = p.elements }
  local steel = { E = 206e9, density = 7850, yield_stress = p.yield_stress }
  local beam = hinge.section.box { width = 0.2, depth = 0.35, thickness = 0.01 }
  local function loaded(share) -- a floor panel gives a quarter of its weight to each of its four beams
    local floor = p.floor == "slab" and 0 or share * p.load * bay / 4 / g / beam.area
    return hinge.material { E = steel.E, yield_stress = p.yield_stress, density = steel.density + floor }
  end
  local one_panel, two_panels, post = loaded(1), loaded(2), hinge.material(steel)
  local joints, at = {}, {}
  for level = 0, storeys do
    for x = 1, bays[1] + 1 do
      for y = 1, bays[2] + 1 do
        local lost = x == p.x and y == p.y and level == p.storey
        local node = model:node { bay * (x - 1), bay * (y - 1), height * level }
        at[x .. y .. level] = node
        if level == 0 then model:fix(node, "all") end
        if level > 0 then
          joints[#joints + 1] = { node = node, x = x, y = y, level = level }
          local side = level <= 2 and p.lower or p.upper
          if is_there or not lost then
            model:member { at[x .. y .. level - 1], node, material = post, up = { 1, 0, 0 },
              section = hinge.section.box { width = side, depth = side, thickness = 0.012 },
              group = lost and "lost" or "columns" }
          end
          if x > 1 then
            model:member { at[x - 1 .. y .. level], node, section = beam, group = "beams",
              material = (y == 1 or y == bays[2] + 1) and one_panel or two_panels }
          end
          if y > 1 then
            model:member { at[x .. y - 1 .. level], node, section = beam, group = "beams",
              material = (x == 1 or x == bays[1] + 1) and one_panel or two_panels }
          end
        end
      end
    end
  end
  for level = 1, p.floor == "none" and 0 or storeys do
    local nodes, beams = {}, {}
    for _, one in ipairs(joints) do
      if one.level == level then nodes[#nodes + 1] = one.node end
    end
    for _, member in ipairs(model:group("beams"):members()) do
      if member.a.z == height * level then beams[#beams + 1] = member end
    end
    if p.floor == "diaphragm" then model:diaphragm { nodes = nodes }
    else model:floor { members = beams, mass = p.load / g, slab = slab } end
  end
  model:gravity { 0, 0, -g }
  return model, joints, at[p.x .. p.y .. p.storey]
end

local function z(node, run) return select(3, node:displacement(run)) end

return hinge.scenario {
  parameters = {
    x = 2, y = 1, storey = 1,      -- the column: line along x, line along y, storey, all from 1
    load = 8e3,                    -- N/m2 on all floors
    yield_stress = 325e6, lower = 0.14, upper = 0.12, -- Pa; m, side of the columns below and above
    rotation = 0.1,                -- rad, of a beam's end where it breaks
    floor = "none",                -- or "diaphragm", "slab": what ties the beams of a storey beside their joints
    elements = 2,                  -- a member; a slab has as many panels along a beam
    interaction = "exact",         -- of N, Mx and My where a section yields, or "paper": eq 14
    duration = 1.25, picture = false, -- s; whether to draw the frame as it ends
  },
  run = function(p, job)
    local without, _, joint = frame(p, false)
    local still = without:static { to_limit = true, steps = 10 }:finish()

    local model, joints, above = frame(p, true)
    local rest = model:static { steps = 1 }:finish()
    local before, drop, most = {}, {}, 0
    for i, one in ipairs(joints) do before[i], drop[i] = z(one.node, rest), 0 end
    model:fracture { group = "lost", where = "all", rule = function() return true end }
    model:fracture { group = "beams", hinge_rotation_x = p.rotation, hinge_rotation_y = p.rotation }
    local run = model:dynamic { from = rest, dt = "auto", integrator = "explicit", duration = p.duration }
    for step in run:steps() do
      if step.index % 20 == 0 then
        for i, one in ipairs(joints) do drop[i] = math.max(drop[i], before[i] - z(one.node, run)) end
      end
    end

    local r = { fallen = 0, elsewhere = 0, yielded = run:count { state = "yielded" },
      broken = run:count { group = "beams", state = "broken" } }
    for i, one in ipairs(joints) do
      if one.node == above then r.drop = drop[i] end
      most = math.max(most, drop[i])
      if drop[i] > bay / 10 then
        r.fallen = r.fallen + 1
        if one.x ~= p.x or one.y ~= p.y then r.elsewhere = r.elsewhere + 1 end
      end
    end
    r.largest_drop = most
    r.outcome = r.fallen == 0 and "holds" or r.elsewhere == 0 and "local collapse" or "full collapse"
    if still.verdict == "completed" and not still.limit then
      r.static_drop = z(above, rest) - z(joint, still)
      if r.outcome == "holds" then r.dynamic_factor = r.drop / r.static_drop end
    end
    if p.picture then job:picture(run, { width = 800, height = 560 }, "frame.png") end
    return r
  end,
}
