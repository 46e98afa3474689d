-- Ends of members beside their joints, as SAP2000 and ETABS have them: insertion points, joint offsets, rigid ends.
--
-- Insertion point: one of eleven points of the section lies on the line between the joints, so that the member is
-- beside it. 1 to 9 are on the rectangle around the section: 1 bottom left, 2 bottom, 3 bottom right, 4 left, 5 middle,
-- 6 right, 7 top left, 8 top, 9 top right; left is towards axis 3, top towards axis 2. 10 is the centroid, 11 the shear
-- centre. Where the stiffness is not transformed, the point is drawn and does not enter the analysis.
--
-- Rigid end: the part RigidFactor of the length from the joint to the face of what crosses there. CSI leaves axial
-- strain and torsion flexible in it; here it is rigid in all. Loads in it act on the joint.
local frame_module = require "hinge.import.frame"
local vectors = require "hinge.library.vectors"
local notes = require "hinge.import.notes"
local units = require "hinge.library.units"

local steep = 0.7 -- cosine to the vertical: members above it are columns, members below its complement beams

local plus, dot, cross = vectors.plus, vectors.dot, vectors.cross
local function is_zero(v) return v[1] == 0 and v[2] == 0 and v[3] == 0 end

-- Sections ------------------------------------------------------------------------------------------------------------

-- The rectangle around a section from its centroid: { left, right, low, high }, m; nil where the size is not known.
local function rectangle(section)
  local given = frame_module.properties(section)
  local size = given.size
  local found
  for _, part in ipairs(given.outline or {}) do
    for _, p in ipairs(part.corners or {}) do
      found = found or { p[1], p[1], p[2], p[2] }
      found[1], found[2] = math.min(found[1], p[1]), math.max(found[2], p[1])
      found[3], found[4] = math.min(found[3], p[2]), math.max(found[4], p[2])
    end
  end
  if not found and size and size.width and size.depth then
    found = { -size.width / 2, size.width / 2, -size.depth / 2, size.depth / 2 }
  end
  return found
end

-- The insertion point from the centroid, in the section's axes x (to the right) and y (upwards), m.
local function point_of(r, number)
  local column, row = (number - 1) % 3, (number - 1) // 3
  return column == 0 and r[1] or column == 1 and (r[1] + r[2]) / 2 or r[2],
    row == 0 and r[3] or row == 1 and (r[3] + r[4]) / 2 or r[4]
end

-- Beside the joints ---------------------------------------------------------------------------------------------------

local Offsets = {}
Offsets.__index = Offsets

-- What the insertion point of a row moves the member by, in space, m.
function Offsets:of_point(row, member, x, y)
  local text = row:text "CardinalPt" or "10"
  local number = tonumber(text:match "^%s*(%d+)%s*$" or text:match "^%s*(%d+)%s*%(")
  if not number or number < 1 or number > 11 then
    notes.fail(self.reader.where, row.place, "CardinalPt is '%s'; must be a number from 1 to 11", text)
  end
  if number >= 10 then
    if number == 11 and not self.symmetric[member.section] then
      self.reader:not_read(row, "insertion point 11: the shear centre is taken at the centroid")
    end
    return { 0, 0, 0 }
  end
  local r = self.rectangle[member.section]
  if not r then
    self.reader:not_read(row, ("insertion point %d: the size of section %s is not known"):format(number,
      member.section))
    return { 0, 0, 0 }
  end
  if not self.symmetric[member.section] and (row:yes "Mirror2" or row:yes "Mirror3") then
    self.reader:not_read(row, "Mirror2, Mirror3: the section is not mirrored")
  end
  local px, py = point_of(r, number)
  return plus(plus({ 0, 0, 0 }, -px, x), -py, y)
end

-- The offset of a joint of one end, in space, m. at: "I" or "J".
function Offsets:of_joint(row, at, axes)
  local v = { 0, 0, 0 }
  for i, letter in ipairs { "X", "Y", "Z" } do
    local keys = { { "JtOff" .. letter .. at }, { "JtOff" .. i .. at, axes[i] } }
    for _, key in ipairs(keys) do
      local value = row:number(key[1], 0) * self.reader.length
      v = plus(v, value, key[2] or { i == 1 and 1 or 0, i == 2 and 1 or 0, i == 3 and 1 or 0 })
    end
  end
  return v
end

-- How far the ends of a member are beside its joints: two vectors in space; nil where they are not.
function Offsets:beside(member)
  local row = self.points[member.name]
  if not row then return nil end
  local transform = row:text "Transform" or row:text "StiffTrans" or row:text "StiffTransform" or "Yes"
  local node = self.reader.node
  local z = frame_module.direction(node[member.a], node[member.b])
  local x, y = frame_module.axes(z, member.up)
  local by = self:of_point(row, member, x, y)
  local axes = { z, y, { -x[1], -x[2], -x[3] } }
  local i, j = plus(by, 1, self:of_joint(row, "I", axes)), plus(by, 1, self:of_joint(row, "J", axes))
  for _, key in ipairs { "Mirror2", "Mirror3", "CoordSys" } do row:text(key) end
  if is_zero(i) and is_zero(j) then return nil end
  if transform:lower() ~= "yes" then
    self.reader:assume(row, "its insertion point does not enter the analysis, for the file says that the stiffness is "
      .. "not transformed: the member goes from joint to joint", "not transformed")
    return nil
  end
  return { i, j }
end

-- Rigid ends ----------------------------------------------------------------------------------------------------------

local function is_column(z) return math.abs(z[3]) > steep end
local function is_beam(z) return math.abs(z[3]) < math.sqrt(1 - steep ^ 2) end

-- From a joint along d, the face of the beams there (of a column), or of the columns there (of a beam), m.
function Offsets:face(joint, member, d, column)
  local far = 0
  for _, other in ipairs(self.at_joint[joint]) do
    local r = other.name ~= member.name and self.rectangle[other.section]
    local z = r and frame_module.direction(self.reader.node[other.a], self.reader.node[other.b])
    if r and (column and is_beam(z) or not column and is_column(z)) then
      local x, y = frame_module.axes(z, other.up)
      local by = self.moved[other.name] and self.moved[other.name][1] or { 0, 0, 0 }
      local dx, dy = dot(d, x), dot(d, y)
      local reach = math.max(dx * r[1], dx * r[2]) + math.max(dy * r[3], dy * r[4]) + dot(d, by)
      if reach > far then far = reach end
    end
  end
  return far
end

-- The lengths of the rigid ends of a member, m; nil: none.
function Offsets:rigid(member)
  local row = self.lengths[member.name]
  if row then row:text "SelfWeight" end
  local factor = row and (row:text "RigidFactor" and row:number "RigidFactor" or row:number("RigidFact", 0)) or 0
  if factor == 0 then return nil end
  local a, b, reader = member.a, member.b, self.reader
  local d = frame_module.direction(reader.node[a], reader.node[b])
  local i, j = row:number("LengthI", 0) * reader.length, row:number("LengthJ", 0) * reader.length
  if (row:text "Type" or "User"):lower():find "^auto" then
    if not is_column(d) and not is_beam(d) then return nil end
    i, j = self:face(a, member, d, is_column(d)), self:face(b, member, { -d[1], -d[2], -d[3] }, is_column(d))
    reader:assume(row, "automatic rigid ends: from a joint to the face of the columns there (of a beam), of the beams "
      .. "there (of a column), times the rigid factor", "automatic")
  end
  if i == 0 and j == 0 then return nil end
  return { factor * i, factor * j, row = row, full = (row:text "SelfWeight" or "Full"):lower() == "full" }
end

-- The parts -----------------------------------------------------------------------------------------------------------

-- The offsets of the parts of a member, and where along each its flexible length begins and ends, m.
function Offsets:apply(member, parts, rigid)
  local reader, by = self.reader, self.moved[member.name]
  local first, last = reader.node[member.a], reader.node[member.b]
  local d, length = frame_module.direction(first, last)
  local i, j = rigid and rigid[1] or 0, rigid and rigid[2] or 0
  local _, own = frame_module.direction(first, reader.node[parts[1].b])
  local _, its = frame_module.direction(reader.node[parts[#parts].a], last)
  if i >= own or j >= its or i + j >= length then
    reader:not_read(rigid.row, "its rigid ends are longer than the member or its piece between joints", "too rigid")
    i, j = 0, 0
  end
  for k, part in ipairs(parts) do
    local offset = {}
    for _, at in ipairs { "a", "b" } do
      local _, along = frame_module.direction(first, reader.node[part[at]])
      if part[at] == member.a then along = 0 end
      local v = by and plus(plus({ 0, 0, 0 }, 1 - along / length, by[1]), along / length, by[2]) or { 0, 0, 0 }
      if k == 1 and at == "a" then v = plus(v, i, d) end
      if k == #parts and at == "b" then v = plus(v, -j, d) end
      if not is_zero(v) then offset[at] = v end
    end
    part.offset = next(offset) and offset or nil
    reader.rigid[part.name] = { k == 1 and i or 0, k == #parts and j or 0 }
  end
  return i + j
end

-- The mass and the weight of rigid ends are on the joints. Gravity acts on the mass; the moment that the weight has
-- there is a load in every case with self weight, and so is a weight without mass.
function Offsets:weigh(row, part, ends)
  local reader = self.reader
  local material, area = reader.material[part.material], self.area[part.section]
  local per_metre = (material.unit_weight or material.density * units.gravity) * area
  local d = frame_module.direction(reader.node[part.a], reader.node[part.b])
  for i, at in ipairs { "a", "b" } do
    local weight, mass = per_metre * ends[i], material.density * area * ends[i]
    if weight > 0 then
      local along = plus({ 0, 0, 0 }, (i == 1 and 0.5 or -0.5) * ends[i], d)
      table.insert(reader.weights, { node = part[at], force = mass > 0 and { 0, 0, 0 } or { 0, 0, -weight },
        moment = cross(along, { 0, 0, -weight }) })
    end
    if mass > 0 then
      local new = { node = part[at], mass = mass, weight = weight }
      reader.places[new] = { file = reader.file, line = row.place.line, text = row.line }
      table.insert(reader.frame.masses, new)
      self.mass = self.mass + mass
    end
  end
end

--- Gives the parts of all members their offsets. reader.rigid: the lengths of rigid ends of each part by name, m;
--- reader.weights: loads of their weight.
local function read(reader)
  local self = setmetatable({ reader = reader, rectangle = {}, symmetric = {}, area = {}, moved = {}, at_joint = {},
    mass = 0 }, Offsets)
  self.points = reader:by_frame("FRAME INSERTION POINT ASSIGNMENTS")
  self.lengths = reader:by_frame("FRAME OFFSET ALONG LENGTH ASSIGNMENTS", "FRAME OFFSET (LENGTH) ASSIGNMENTS")
  reader.rigid, reader.weights = {}, {}
  if not next(self.points) and not next(self.lengths) then return end
  for _, rows in ipairs { self.points, self.lengths } do
    for _, row in pairs(rows) do reader:frame_of(row) end
  end
  for _, s in ipairs(reader.frame.sections) do
    local r = rectangle(s)
    self.rectangle[s.name], self.area[s.name] = r, frame_module.properties(s).area
    self.symmetric[s.name] = not r or math.abs(r[1] + r[2]) + math.abs(r[3] + r[4]) < 1e-6 * (r[2] - r[1])
  end
  for _, node in ipairs(reader.frame.nodes) do self.at_joint[node.name] = {} end
  local whole = {} -- the members before they were divided
  for _, part in ipairs(reader.frame.members) do
    for _, at in ipairs { "a", "b" } do table.insert(self.at_joint[part[at]], part) end
  end
  for name, member in pairs(reader.member) do
    whole[#whole + 1] = member
    self.moved[name] = self:beside(member)
    for _, part in ipairs(reader.parts[name]) do self.moved[part.name] = self.moved[name] end
  end
  table.sort(whole, function(a, b) return reader.places[a].line < reader.places[b].line end)
  local length, first, weighed = 0, nil, {}
  for _, member in ipairs(whole) do
    local rigid, parts = self:rigid(member), reader.parts[member.name]
    if rigid or self.moved[member.name] then
      local own = self:apply(member, parts, rigid)
      if own > 0 then
        length, first = length + own, first or rigid.row
        if rigid.full then weighed[#weighed + 1] = { rigid.row, parts } end
      end
    end
  end
  for _, w in ipairs(weighed) do
    for _, part in ipairs(w[2]) do self:weigh(w[1], part, reader.rigid[part.name]) end
  end
  if length > 1e-9 then
    notes.add(reader.notes.assumed, first.place, first.line, ("rigid ends of %.4g m in all: rigid in axial strain and "
      .. "torsion, too, which %s leaves flexible there; their mass of %.4g kg is on the joints"):format(
      length, reader.program, self.mass))
  end
end

-- Joints with ends beside them alone ----------------------------------------------------------------------------------

-- The ends at each joint: { part =, at =, by = (offset; nil: at the joint), released = }.
local function ends_at(reader)
  local ends = frame_module.ends_at(reader.frame.members)
  for _, list in pairs(ends) do
    for i, one in ipairs(list) do
      local part, at = one[1], one[2]
      list[i] = { part = part, at = at, by = part.offset and part.offset[at],
        released = part.release and part.release[at] ~= nil }
    end
  end
  return ends
end

-- The nearest of the ends that is not released, where all are beside the joint or released; else nil. at_support: one
-- that is released does, too, where there is no other, for the support holds the joint.
local function nearest(list, at_support)
  local best, size
  for _, one in ipairs(list) do
    if not one.by and not one.released then return nil end
    local own = one.by and vectors.length(one.by) or 0
    if one.by and (not one.released or at_support and #list == 1) and (not best or own < size) then
      best, size = one, own
    end
  end
  return best
end

local function set_offset(one, v)
  local offset = one.part.offset or {}
  offset[one.at] = dot(v, v) > 1e-18 and v or nil
  one.part.offset = next(offset) and offset or nil
end

-- Moves a joint by a vector: it and all its ends are one rigid body, so that forces and masses there go along.
local function move_joint(reader, node, by, list)
  node.x, node.y, node.z = node.x + by[1], node.y + by[2], node.z + by[3]
  for _, one in ipairs(list) do set_offset(one, plus(one.by or { 0, 0, 0 }, -1, by)) end
  local back = plus({ 0, 0, 0 }, -1, by)
  reader.moved_joints[node.name] = back
  for _, case in ipairs(reader.frame.cases) do
    for _, load in ipairs(case.loads) do
      if load.node == node.name and load.force then
        load.moment = plus(load.moment or { 0, 0, 0 }, 1, cross(back, load.force))
      end
    end
  end
  for _, mass in ipairs(reader.frame.masses) do
    if mass.node == node.name then mass.offset = back end
  end
end

--- The engine needs a member at each joint. A joint at which all end beside it goes to the nearest of them, where its
--- supports let it; else that end goes to the joint. After all loads. reader.moved_joints: from a joint to where it
--- was, by name, m.
local function settle(reader)
  reader.moved_joints = {}
  local ends, sprung, moved, pulled = ends_at(reader), {}, {}, {}
  for _, row in ipairs(reader:rows "JOINT SPRING ASSIGNMENTS 1 - UNCOUPLED") do sprung[row:need "Joint"] = true end
  local free = reader:inactive_fix()
  for _, node in ipairs(reader.frame.nodes) do
    local list = ends[node.name]
    local one = list and nearest(list, node.fix == "all")
    if one and not sprung[node.name] and (node.fix == "all" or node.fix == free) then
      moved[#moved + 1] = node
      move_joint(reader, node, one.by, list)
    elseif one then
      pulled[#pulled + 1] = node
      set_offset(one, { 0, 0, 0 })
    end
  end
  for _, told in ipairs {
    { moved, reader.notes.assumed, "%d joints at which all members end beside the joint are put to the nearest end, "
      .. "with the moments of forces there" },
    { pulled, reader.notes, "at %d supports all members end beside the joint: the nearest one goes to it, without its "
      .. "rigid end or insertion point" },
  } do
    local first = told[1][1]
    local place = first and reader.places[first]
    if first then notes.add(told[2], place, place.text, told[3]:format(#told[1])) end
  end
end

return { read = read, settle = settle }
