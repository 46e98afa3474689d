-- Loads along the members of SAP2000 and ETABS: uniform or trapezoidal ones over a part of a member, and forces and
-- moments at a point. A member that was divided has them on its parts; what lies on a rigid end acts on the joint.
local frame_module = require "hinge.import.frame"
local notes = require "hinge.import.notes"
local vectors = require "hinge.library.vectors"

local near = 1e-6 -- of a member's length

-- Directions of loads along members: axes of hinge, and the load of size 1 there. Axes 1, 2, 3 are z, y, -x.
local global = { X = { 1, 0, 0 }, Y = { 0, 1, 0 }, Z = { 0, 0, 1 }, GRAVITY = { 0, 0, -1 } }
local projected = { ["X PROJ"] = global.X, ["Y PROJ"] = global.Y, ["Z PROJ"] = global.Z,
  ["GRAV PROJ"] = global.GRAVITY }
local own_axes = { ["1"] = { 0, 0, 1 }, ["2"] = { 0, 1, 0 }, ["3"] = { -1, 0, 0 } }

local function direction_of(row)
  local dir, system = row:need "Dir":upper(), (row:text "CoordSys" or "GLOBAL"):upper()
  if own_axes[dir] and system == "LOCAL" then return own_axes[dir], "local" end
  if system ~= "GLOBAL" then return nil end
  if projected[dir] then return projected[dir], "projected" end
  return global[dir], nil
end

local times, plus = vectors.times, vectors.plus

local Loads = {}
Loads.__index = Loads

-- The parts of a member from its first joint on: where each begins and ends, and its flexible length, m.
function Loads:parts_of(member)
  local reader, list, at = self.reader, {}, 0
  for i, part in ipairs(reader.parts[member.name]) do
    local d, length = frame_module.direction(reader.node[part.a], reader.node[part.b])
    local rigid = reader.rigid[part.name] or { 0, 0 }
    list[i] = { part = part, d = d, from = at, to = at + length, first = at + rigid[1], last = at + length - rigid[2] }
    at = at + length
  end
  return list, at
end

-- A load of size 1 in space: per length of the member also where it is per length of its projection.
local function in_space(p, to, axes)
  if axes == "local" then
    local x, y = frame_module.axes(p.d, p.part.up)
    return plus(plus(times(to[1], x), to[2], y), to[3], p.d)
  end
  if axes ~= "projected" then return to end
  return times(math.sqrt(math.max(0, 1 - vectors.dot(to, p.d) ^ 2)), to)
end

function Loads:add(case, row, load)
  self.reader.places[load] = { file = self.reader.file, line = row.place.line, text = row.line }
  table.insert(case.loads, load)
end

-- A force and a moment at the distance s from a member's first joint, on the rigid end of a part.
function Loads:add_at_joint(case, row, p, at, s, force, moment)
  local offset, tip = p.part.offset and p.part.offset[at] or { 0, 0, 0 }, at == "a" and p.first or p.last
  local turn = vectors.cross(plus(offset, s - tip, p.d), force or { 0, 0, 0 })
  self:add(case, row, { node = p.part[at], force = force, moment = plus(turn, 1, moment or { 0, 0, 0 }) })
end

-- What a load that is linear between s1 and s2 is together between two places, and where its resultant acts.
local function resultant(w, low, high)
  local a, b = w(low), w(high)
  local sum = (a + b) / 2 * (high - low)
  if sum == 0 then return 0, (low + high) / 2 end
  return sum, low + (high - low) * (a + 2 * b) / (3 * (a + b))
end

-- A load that is w1 at s1 and w2 at s2, N/m, linear between; s from the member's first joint, m.
function Loads:spread(case, row, member, given)
  local list, whole = self:parts_of(member)
  local s1, s2 = given.s1, given.s2
  local function w(s) return given.w1 + (given.w2 - given.w1) * (s - s1) / (s2 - s1) end
  for _, p in ipairs(list) do
    local low, high = math.max(s1, p.first), math.min(s2, p.last)
    if high - low > near * whole then
      local long = p.last - p.first
      local a, b = w(low), w(high)
      local from = low - p.first > near * whole and (low - p.first) / long or nil
      local to = p.last - high > near * whole and (high - p.first) / long or nil
      local q = math.abs(a - b) <= 1e-12 * math.max(math.abs(a), math.abs(b)) and times(a, given.to)
        or { a = times(a, given.to), b = times(b, given.to) }
      self:add(case, row, { member = p.part.name, q = q, from = from, to = to, axes = given.axes })
    end
    for _, rigid in ipairs { { "a", p.from, p.first }, { "b", p.last, p.to } } do
      low, high = math.max(s1, rigid[2]), math.min(s2, rigid[3])
      if high > low then
        local sum, at = resultant(w, low, high)
        self:add_at_joint(case, row, p, rigid[1], at, times(sum, in_space(p, given.to, given.axes)))
      end
    end
  end
end

-- A force or a moment at the distance s from the member's first joint.
function Loads:point(case, row, member, given)
  local list, whole = self:parts_of(member)
  for i, p in ipairs(list) do
    if given.s <= p.to + near * whole or i == #list then
      local v = times(given.size, given.to)
      if given.s < p.first or given.s > p.last then
        v = in_space(p, v, given.axes)
        local at = given.s < p.first and "a" or "b"
        return self:add_at_joint(case, row, p, at, given.s, given.what == "force" and v or nil,
          given.what == "moment" and v or nil)
      end
      local at = (given.s - p.first) / (p.last - p.first)
      return self:add(case, row, { member = p.part.name, [given.what] = v, at = math.max(0, math.min(1, at)),
        axes = given.axes })
    end
  end
end

-- Rows ----------------------------------------------------------------------------------------------------------------

-- A distance from the first joint, m: relative or absolute. length: of the member.
local function distance(reader, row, letter, length, default)
  local relative, absolute = "RelDist" .. letter, "AbsDist" .. letter
  local by_length = (row:text "DistType" or "RelDist"):lower() == "absdist"
  local r, a = row:number(relative, default), row:number(absolute, default * length / reader.length)
  local s = by_length and a * reader.length or r * length
  if s < -near * length or s > (1 + near) * length then
    notes.fail(reader.where, row.place, "%s is %g; the load is beside the member", by_length and absolute or relative,
      by_length and a or r)
  end
  if math.abs(s) <= near * length then return 0 end
  return math.abs(s - length) <= near * length and length or s
end

-- The member, case, direction and axes of a row; nil with a note.
function Loads:place_of(row, kinds)
  local reader = self.reader
  local member, case = reader:frame_of(row), reader:pattern(row)
  local kind = (row:text "Type" or "Force"):lower()
  local to, axes = direction_of(row)
  if not member then return reader:not_read(row, "its frame was not read") end
  if not kinds[kind] then return reader:not_read(row, "forces alone are read") end
  if not to then return reader:not_read(row, "its direction is not read") end
  return member, case, to, axes, kind
end

function Loads:read_distributed()
  local reader = self.reader
  for _, row in ipairs(reader:rows "FRAME LOADS - DISTRIBUTED") do
    local member, case, to, axes = self:place_of(row, { force = true })
    if member then
      local _, length = self:parts_of(member)
      local s1, s2 = distance(reader, row, "A", length, 0), distance(reader, row, "B", length, 1)
      local unit = reader.force / reader.length
      local w1, w2 = row:number "FOverLA" * unit, row:number "FOverLB" * unit
      if s1 > s2 then s1, s2, w1, w2 = s2, s1, w2, w1 end
      if (w1 ~= 0 or w2 ~= 0) and s2 > s1 then
        self:spread(case, row, member, { s1 = s1, s2 = s2, w1 = w1, w2 = w2, to = to, axes = axes })
      end
    end
  end
end

function Loads:read_points()
  local reader = self.reader
  for _, row in ipairs(reader:rows "FRAME LOADS - POINT") do
    local member, case, to, axes, kind = self:place_of(row, { force = true, moment = true })
    if member and axes == "projected" then
      reader:not_read(row, "its direction is not read")
    elseif member then
      local _, length = self:parts_of(member)
      local force = kind == "force"
      local size = row:number(force and "Force" or "Moment") * reader.force * (force and 1 or reader.length)
      local s = distance(reader, row, "", length, 0)
      if size ~= 0 then
        self:point(case, row, member, { s = s, size = size, to = to, axes = axes, what = kind })
      end
    end
  end
end

--- Reads the loads along members, and adds the weight of rigid ends to each case with self weight.
return function(reader)
  local self = setmetatable({ reader = reader }, Loads)
  self:read_distributed()
  self:read_points()
  for _, case in ipairs(reader.frame.cases) do
    for _, w in ipairs(case.self_weight and case.self_weight ~= 0 and reader.weights or {}) do
      table.insert(case.loads, { node = w.node, force = times(case.self_weight, w.force),
        moment = times(case.self_weight, w.moment) })
    end
  end
end
