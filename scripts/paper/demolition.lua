-- Which columns does a controlled demolition blast, and when? After a later paper of the same group: D. Isobe, An
-- Analysis Code and a Planning Tool Based on a Key Element Index for Controlled Explosive Demolition, International
-- Journal of High-Rise Buildings 3(4) (2014).
--
-- Run     hinge run scripts/paper/demolition.lua     (quick=true: the index of a frame of two storeys, no blast)
-- Shows   the index of the columns of the first storey: how many times more weight the frame carries with the column
--         than without it. Then nine of them go, those with the largest or those with the smallest index, at once or
--         one after the other
-- Expect  index: 1.42 at a corner, 1.85 at an edge, 2.45 inside. demolition.png; six minutes on two busy cores
--
-- The paper's text says that columns with the largest index should go where all are blasted at once, and those with the
-- smallest in a sequence whose last column has a large index. Of its frame it gives 15 storeys of 3.6 m, three bays of
-- 6 m, the depth of the first columns (430 mm) and of the beams (331 mm), and the load of the floors (400 kg/m2). Here
-- the frame has six storeys. The rest is chosen. The index is that of the whole frame: the paper finds it anew after
-- each column.
local hinge = require "hinge"
local paper = require "hinge.paper"

local g, bay, height, bays = 9.80665, 6, 3.6, 3 -- m
local beam = hinge.section.h { depth = 0.331, width = 0.2, web = 0.009, flange = 0.0132 }

-- The frame; lost: number of a column of the first storey that it lacks. Returns the model, the columns of the first
-- storey by number, and all joints as { node =, z = }.
local function build(p, lost)
  local model = hinge.model {}
  local joints, columns, at = {}, {}, {}
  local function loaded(panels) -- a floor panel gives a quarter of its weight to each of its four beams
    return hinge.material { E = 206e9, yield_stress = p.yield_stress,
      density = 7850 + panels * p.load * bay / 4 / beam.area }
  end
  local of_edge, inside = loaded(1), loaded(2)
  local steel = hinge.material { E = 206e9, density = 7850, yield_stress = p.yield_stress }
  for level = 0, p.storeys do
    local side = 0.43 - 0.13 * math.max(0, level - 1) / math.max(1, p.storeys - 1)
    local column = hinge.section.box { width = side, depth = side, thickness = p.wall }
    local here, number = {}, 0
    for j = 0, bays do
      for i = 0, bays do
        number = number + 1
        local left_out = level <= 1 and number == lost
        local node = not (left_out and level == 0) and model:node { bay * i, bay * j, height * level }
        here[number] = node
        if level == 0 then
          if node then model:fix(node, "all") end
        else
          joints[#joints + 1] = { node = node, z = height * level }
          if not left_out then
            local made = model:member { at[number], node, material = steel, group = "columns", section = column }
            if level == 1 then columns[number] = made end
          end
          if i > 0 then
            model:member { here[number - 1], node, section = beam, group = "beams",
              material = (j == 0 or j == bays) and of_edge or inside }
          end
          if j > 0 then
            model:member { here[number - bays - 1], node, section = beam, group = "beams",
              material = (i == 0 or i == bays) and of_edge or inside }
          end
        end
      end
    end
    at = here
  end
  return model, columns, joints
end

-- How many times its own weight and that of its floors the frame carries.
local function capacity(p, lost)
  local model, most = build(p, lost), 15
  model:gravity { 0, 0, -most * g }
  local run = model:static { to_limit = true, steps = 30, record = false }:finish()
  assert(run.verdict == "completed", run.reason)
  return most * run.factor
end

-- The columns of `order` go, `interval` seconds one after the other. Returns the part of their height by which the
-- joints have come down, p.after seconds after the last one, and the run.
local function demolish(p, order, interval)
  local model, columns, joints = build(p)
  model:gravity { 0, 0, -g }
  model:ground { point = { 0, 0, -0.3 }, friction = 0.4 }
  model:contact {}
  for group, length in pairs { beams = bay, columns = height } do
    local most_curved = p.rotation / (length / 2) -- of an element, of which a member has two
    model:fracture { group = group, curvature_x = most_curved, curvature_y = most_curved }
  end
  local rest = model:static { steps = 1 }:finish()
  for i, number in ipairs(order) do model:remove { member = columns[number], at = 0.05 + interval * (i - 1) } end
  local run = model:dynamic { from = rest, dt = 1e-3, duration = 0.05 + interval * (#order - 1) + p.after }:finish()
  local fell, all = 0, 0
  for _, joint in ipairs(joints) do
    local _, _, at_rest = joint.node:displacement(rest)
    local _, _, z = joint.node:displacement(run)
    fell, all = fell + math.min(joint.z, at_rest - z), all + joint.z
  end
  return fell / all, run
end

return hinge.scenario {
  parameters = {
    storeys = 6, load = 400, yield_stress = 325e6, wall = 0.012, -- kg/m2, Pa, m: of the columns
    rotation = 0.04, count = 9,   -- rad, of a member's half where it breaks; columns that go
    interval = 0.1, after = 4,    -- s
    quick = false,
  },
  run = function(p, job)
    if p.quick then p = setmetatable({ storeys = 2 }, { __index = p }) end
    local whole = capacity(p)
    local index = { corner = whole / capacity(p, 1), edge = whole / capacity(p, 2), inside = whole / capacity(p, 6) }
    paper.table("Columns of the first storey: capacity of the frame with the column over that without", { "corner",
      "edge", "inside" }, { { ("%.2f"):format(index.corner), ("%.2f"):format(index.edge),
      ("%.2f"):format(index.inside) } })
    local results = { index = index }
    if p.quick then return results end

    local inside, edges, corners = { 6, 7, 10, 11 }, { 2, 5, 3, 9, 8, 14, 12, 15 }, { 1, 4, 13, 16 }
    local function first(count, ...)
      local list = {}
      for _, from in ipairs { ... } do
        for _, number in ipairs(from) do if #list < count then list[#list + 1] = number end end
      end
      return list
    end
    local largest, smallest = first(p.count, inside, edges, corners), first(p.count, corners, edges, inside)
    local last_large = first(p.count - 1, corners, edges, inside)
    last_large[#last_large + 1] = 6
    local rows, pictures = {}, {}
    for i, case in ipairs { { "largest, at once", largest, 0 }, { "smallest, at once", smallest, 0 },
      { "largest, in a sequence", largest, p.interval },
      { "smallest, in a sequence, a large one last", last_large, p.interval } } do
      local part, run = demolish(p, case[2], case[3])
      rows[i] = { case[1], ("%.0f"):format(100 * part), run:count { group = "columns", state = "broken" },
        run:count { group = "beams", state = "broken" }, run.verdict, ("%.2f"):format(100 * run.energy_error) }
      results[case[1]] = { part = part, verdict = run.verdict }
      pictures[i] = { run:snapshot(), { title = case[1], width = 800, height = 700,
        box = { -10, 28, -10, 28, -1, 24 } } }
    end
    job:strip(pictures, 2, "demolition.png")
    paper.table(("%g s after the last of %d columns"):format(p.after, p.count), { "columns that go",
      "joints have come down by, %", "columns broken", "beams broken", "verdict", "energy error, %" }, rows)
    return results
  end,
}
