-- The small aircraft of the paper's section 4: a space frame of 199 members and 119 joints.
--
-- Reconstructed, because the paper's figure 16 is lost; the counts follow from its 1698 elements and
-- 7308 degrees of freedom:
--                                                joints  members
--   nose joint, 4 members to the first frame          1        4
--   fuselage: 11 square frames, 4 longerons          44       84
--   two wings, two-spar ladders of 12 ribs           48       72
--   two tailplanes of 5 ribs                         20       30
--   fin of 3 ribs                                     6        9
-- Each square frame stands on its corner. Wings and tailplanes begin at the side joints, the fin at the top joints,
-- each with its two spars. All dimensions are parts of `size`. They are chosen so that the total length of the members
-- is 229.5 m at a size of 15 m. Also reconstructed: duralumin 2017-T4, and the section of the members, in two designs.
-- `stiff` is the default, box 260x260x13; scripts/paper/lost_inputs.lua chose it. `slender` is box 120x120x6. From the
-- paper: the mass of the aircraft is spread evenly over its members, by their density.
local hinge = require "hinge"
local check = require "hinge.library.check"
local vectors = require "hinge.library.vectors"
local materials = require "hinge.models.materials"

local aircraft = {}
local where = "aircraft.add"

aircraft.designs = {
  stiff = { section = hinge.section.box { width = 0.26, depth = 0.26, thickness = 0.013 } },
  slender = { section = hinge.section.box { width = 0.12, depth = 0.12, thickness = 0.006 } },
}

local rules = {
  design = { "string", default = "stiff" },
  size = { "number", unit = "m", above = 0, default = 15 },
  mass = { "number", unit = "kg", above = 0, default = 15000 },
  speed = { "number", unit = "m/s", optional = true },
  position = { "numbers", count = 3, unit = "m", default = { -0.5, 11.6, 23.8 } },
  heading = { "numbers", count = 3, default = { 1, 0, 0 } },
  section = { "section", optional = true }, -- of the design
  material = { "material", default = hinge.material { E = 70.6e9, nu = 0.33, density = 2800, yield_stress = 275e6 } },
  shape = { "table", default = {} },
}

local function share(default) return { "number", above = 0, default = default } end

-- Parts of `size`. A `tip` is the chord at the tip. A `sweep` is the distance of the front spar's tip behind its root.
local shape_rules = {
  length = share(1.00), -- nose to last frame
  nose = share(0.10), -- nose to first frame
  droop = { "number", default = 0.02 }, -- nose joint below the fuselage's axis
  body = share(0.12265), -- side of the square frames in the middle of the fuselage
  span = share(1.00), wing_tip = share(0.09), wing_sweep = { "number", default = 0.10 },
  tail_span = share(0.40), tail_tip = share(0.05), tail_sweep = { "number", default = 0.04 },
  fin_height = share(0.16), fin_tip = share(0.05), fin_sweep = { "number", default = 0.07 },
}

-- Side of each frame, nose to tail, over that of the frames in the middle.
local taper = { 0.75, 0.95, 1, 1, 1, 1, 0.95, 0.85, 0.72, 0.58, 0.45 }
local wing_frames, tail_frames = { 4, 6 }, { 10, 11 } -- where front and rear spar start

local between = vectors.between

-- Joints, as parts of the size, and members. Body axes: x backwards from the nose, y to the left,
-- z up from the fuselage's axis.
local function lay_out(s)
  local points, members = {}, {}
  local function point(x, y, z)
    points[#points + 1] = { x, y, z }
    return #points
  end
  local function member(a, b, group) members[#members + 1] = { a, b, group } end

  local nose, frames = point(0, 0, -s.droop), {}
  for i, width in ipairs(taper) do
    local x = s.nose + (s.length - s.nose) * (i - 1) / (#taper - 1)
    local r = width * s.body / math.sqrt(2)
    frames[i] = { point(x, 0, r), point(x, r, 0), point(x, 0, -r), point(x, -r, 0) } -- top, left, bottom, right
    for k = 1, 4 do
      member(frames[i][k], frames[i][k % 4 + 1], "fuselage")
      member(i == 1 and nose or frames[i - 1][k], frames[i][k], "fuselage")
    end
  end

  -- A ladder of two spars, from corner `k` of a front and a rear frame to a tip at y, z.
  local function ladder(group, from, k, ribs, sweep, chord, y, z)
    local roots = { frames[from[1]][k], frames[from[2]][k] }
    local x = points[roots[1]][1] + sweep
    local tips = { { x, y, z }, { x + chord, y, z } }
    local last = roots
    for i = 1, ribs do
      local rib = {}
      for spar = 1, 2 do
        rib[spar] = point(table.unpack(between(points[roots[spar]], tips[spar], i / ribs)))
        member(last[spar], rib[spar], group)
      end
      member(rib[1], rib[2], group)
      last = rib
    end
  end

  local top, left, right = 1, 2, 4
  ladder("wing", wing_frames, left, 12, s.wing_sweep, s.wing_tip, s.span / 2, 0)
  ladder("wing", wing_frames, right, 12, s.wing_sweep, s.wing_tip, -s.span / 2, 0)
  ladder("tail", tail_frames, left, 5, s.tail_sweep, s.tail_tip, s.tail_span / 2, 0)
  ladder("tail", tail_frames, right, 5, s.tail_sweep, s.tail_tip, -s.tail_span / 2, 0)
  ladder("tail", tail_frames, top, 3, s.fin_sweep, s.fin_tip, 0, points[frames[tail_frames[1]][top]][3] + s.fin_height)
  return points, members
end

--- Adds an aircraft to a model; returns its group and a table of its facts. Options: see words/models.d.lua.
function aircraft.add(model, options)
  check.model(where, model)
  local o = check.design(where, check.options(where, options, rules), aircraft.designs)
  local shape = check.options(where .. " shape", o.shape, shape_rules)
  if shape.length <= shape.nose then
    check.fail("%s shape: field 'length' is %s; must be above nose, %s", where, check.show(shape.length),
      check.show(shape.nose))
  end
  if o.heading[1] == 0 and o.heading[2] == 0 then
    check.fail("%s: field 'heading' is %s; must not be vertical", where, check.show(o.heading))
  end
  local points, members = lay_out(shape)

  local forward = vectors.unit(o.heading)
  local left = vectors.unit(vectors.cross({ 0, 0, 1 }, forward))
  local upward = vectors.cross(forward, left)
  local nodes, places = {}, {}
  for i, p in ipairs(points) do
    local place = {}
    for k = 1, 3 do place[k] = o.position[k] + o.size * (p[2] * left[k] + p[3] * upward[k] - p[1] * forward[k]) end
    places[i], nodes[i] = place, model:node(place)
  end

  local length, directions = 0, {}
  for i, m in ipairs(members) do
    local a, b = places[m[1]], places[m[2]]
    local l
    directions[i], l = vectors.unit(vectors.minus(b, a))
    length = length + l
  end
  local density = o.mass / (o.section.area * length)
  local material = materials.with_density(o.material, density)
  for i, m in ipairs(members) do
    local steep = math.abs(vectors.dot(directions[i], upward)) > 0.8
    model:member { nodes[m[1]], nodes[m[2]], section = o.section, material = material, up = steep and forward or upward,
      group = { m[3], "aircraft" } }
  end

  local group = model:group("aircraft")
  if o.speed then model:velocity(group, vectors.times(o.speed, forward)) end
  return group, { nose = nodes[1], joints = #points, members = #members, length = length, density = density,
    mass = o.mass, groups = { "fuselage", "wing", "tail" } }
end

return aircraft
