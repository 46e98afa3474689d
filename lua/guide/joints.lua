-- A frame with end plates loses its middle column: the joints break before the members. See joints.md.
local hinge = require "hinge"

local g, span, lost_at = 9.80665, 6, 0.05 -- m/s^2, m, s
local fy = 235e6
local post, girder = hinge.section.named "HEB 240", hinge.section.named "IPE 360"
local steel = hinge.material { E = 210e9, density = 7850, yield_stress = fy }
local loaded = hinge.material { E = 210e9, density = 9e3 / g / girder.area, yield_stress = fy } -- 9 kN/m on beams

-- End plates that stand out of the beam above and below, so that the joint is the same under moments of either sign.
-- beta = 1 at the outer columns, and 0 where beams on both sides bend alike.
local function end_plate(beta, capacity, interaction)
  return hinge.joint.end_plate {
    beam = { section = girder, yield_stress = fy }, column = { section = post, yield_stress = fy }, beta = beta,
    plate = { width = 0.2, thickness = 0.012, yield_stress = fy, below = 0.08 },
    bolts = { diameter = 0.02, grade = "8.8", rows = { 0.399, 0.296 }, gauge = 0.11, edge = 0.035, shear_rows = 2 },
    welds = { flange = 0.007, web = 0.004 }, capacity = capacity, interaction = interaction,
  }
end

-- Two storeys on three columns. `outer`, `inner`: joints of the beams' ends; nil: rigid. Returns the history of the
-- node over the lost column, the run, the beams, and the moments of the joint at the left end of the first one.
local function lose_column(outer, inner)
  local model = hinge.model {}
  local nodes, beams = {}, {}
  for i = 1, 3 do
    nodes[i] = {}
    for level = 0, 2 do
      nodes[i][level] = model:node { span * (i - 1), 0, 3.5 * level }
      if level > 0 then
        model:member { nodes[i][level - 1], nodes[i][level], section = post, material = steel,
          group = i == 2 and level == 1 and "lost" or nil }
      end
    end
    model:fix(nodes[i][0])
  end
  for level = 1, 2 do
    for i = 1, 2 do
      beams[#beams + 1] = model:member { nodes[i][level], nodes[i + 1][level], section = girder, material = loaded,
        elements = 4, ends = outer and { a = i == 1 and outer or inner, b = i == 2 and outer or inner } }
    end
  end
  model:gravity { 0, 0, -g }
  model:damping { beta = 1e-4 } -- s, against ringing along the beams
  local above = nodes[2][1]
  model:fracture { group = "lost", where = "all",
    rule = function(section) return section.time >= lost_at and section.node == above.index end }
  local rest = model:static { steps = 1 }:finish()
  local run = model:dynamic { from = rest, dt = 5e-4, duration = 1 }
  local drop, turn = { x = {}, y = {} }, { x = {}, y = {} }
  while run:step() do
    table.insert(drop.x, run.time)
    drop.y[#drop.x] = select(3, above:displacement(run))
    local now = beams[1]:joint("a", run)
    if now then
      table.insert(turn.x, math.abs(now.rotation_x))
      table.insert(turn.y, math.abs(now.Mx) / 1e3)
    end
  end
  assert(run.verdict == "completed", run.reason)
  return drop, run, beams, turn
end

-- When the first joint broke, s; nil: none did.
local function first_break(beams)
  local first
  for _, beam in ipairs(beams) do
    for _, side in ipairs { "a", "b" } do
      local at = beam:joint(side).broken
      if at and at < (first or math.huge) then first = at end
    end
  end
  return first
end

local _, numbers = end_plate(1, 0.02)
print(("outer joints: %.0f kN m, %.1f MN m/rad, %s; beam: %.0f kN m"):format(numbers.moment / 1e3,
  numbers.stiffness / 1e6, numbers.governs, fy * girder.Zx / 1e3))
print "joints                      deepest   turned by     the first broke at"
local drops, turns, views, deepest, breaks = {}, {}, {}, {}, {}
for _, of in ipairs { { "rigid" }, { "end plates, moment alone", math.huge, "none" }, { "end plates", math.huge },
  { "end plates, 0.02 rad", 0.02 } } do
  local name, capacity, interaction = table.unpack(of)
  local finite = capacity and capacity < 1 and capacity or nil
  local drop, run, beams, turn = lose_column(capacity and (end_plate(1, finite, interaction)),
    capacity and (end_plate(0, finite, interaction)))
  local broke = capacity and first_break(beams)
  breaks[name] = broke
  deepest[#deepest + 1] = -1e3 * math.min(table.unpack(drop.y))
  print(("%-26s %5.0f mm   %-12s  %s"):format(name, deepest[#deepest],
    capacity and ("%.4f rad"):format(math.max(table.unpack(turn.x))) or "-",
    broke and ("%.3f s"):format(broke) or "-"))
  drop.name, turn.name = name, name
  drops[#drops + 1] = drop
  if capacity then
    table.insert(turns, 1, turn)
    views[#views + 1] = { run, { width = 640, height = 480, view = "front", box = { -1, 13, -1, 1, 0, 8 } } }
  end
end
hinge.strip(views, 3, "joints.png")
hinge.plot({ series = drops, x_label = "time, s", y_label = "displacement over the lost column, m", width = 1000,
  height = 500 }, "joints_drop.png")
hinge.plot({ series = turns, x_label = "rotation of the outer joint, rad", y_label = "moment, kN m", width = 1000,
  height = 500 }, "joints_moment.png")
return { moment = numbers.moment, rigid = deepest[1], moment_alone = deepest[2], pulled = deepest[3],
  turned = deepest[4], broke_after = breaks["end plates, 0.02 rad"] }
