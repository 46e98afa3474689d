-- Elements of OpenSees between two nodes at one place, and links: springs of hinge where they are elastic, joints where
-- they yield.
local arguments = require "hinge.import.opensees.arguments"
local constraints = require "hinge.import.opensees.constraints"
local frame_module = require "hinge.import.frame"
local materials = require "hinge.import.opensees.materials"

local number, tag, give_up, assume = arguments.number, arguments.tag, arguments.give_up, arguments.assume
local elements = {}

local letters = frame_module.letters
local plane_letters = { "x", "y", "rz", nil, nil, "rz" } -- 3 is the rotation in twoNodeLink, 6 in zeroLength

-- A direction of the file in the axes of hinge.
local function in_space(self, v) return self.ndm == 2 and { v[1], 0, v[2] } or { v[1], v[2], v[3] } end

-- The axes x and y of -orient x1 x2 x3 yp1 yp2 yp3; of three numbers, the one that counts.
local function orientation(self, args, along)
  local o = arguments.list_of(args, "-orient")
  local x, y = along or { 1, 0, 0 }, nil
  if o then
    local v = {}
    for i, text in ipairs(o) do v[i] = number(self, text, "-orient") end
    if #v == 6 then x, y = { v[1], v[2], v[3] }, { v[4], v[5], v[6] }
    elseif #v == 3 then y = { v[1], v[2], v[3] }
    else self:fail("-orient has %d numbers; must be 3 or 6", #v) end
    if #v == 6 and along then x = along end
  end
  if not y then
    y = { -x[2], x[1], 0 }
    if y[1] == 0 and y[2] == 0 then give_up "a link along z has no axis y; -orient gives it" end
  end
  return in_space(self, x), in_space(self, y)
end

-- The materials of -mat by the directions of -dir.
local function parts_of(self, args)
  local mats, dirs = arguments.list_of(args, "-mat"), arguments.list_of(args, "-dir", "-dof")
  if not mats or not dirs or #mats ~= #dirs then self:fail "-mat and -dir need as many materials as directions" end
  local parts = {}
  for i, text in ipairs(dirs) do
    local d = number(self, text, "-dir")
    local letter = (self.ndm == 2 and plane_letters or letters)[d]
    if letter then
      local m = materials.of(self, mats[i])
      if parts[letter] then give_up "two materials in one direction are not read" end
      parts[letter] = m
    elseif self.ndm == 3 then
      self:fail("direction %s is not there", text)
    end
  end
  if not next(parts) then give_up "it has no direction in the plane" end
  return parts
end

local function add(self, args, parts, x, y)
  local name = tag(self, args[1], "the tag")
  local row = { name = name, a = tag(self, args[2], "node i"), b = tag(self, args[3], "node j"), parts = parts, x = x,
    y = y, place = self.place }
  self.element[name] = row
  table.insert(self.springs, row)
end

-- zeroLength tag i j -mat ... -dir ... <-orient ...>
function elements.zeroLength(self, args)
  local x, y = orientation(self, args)
  add(self, args, parts_of(self, args), x, y)
  arguments.other_options(self, args, { ["-mat"] = true, ["-dir"] = true, ["-orient"] = true, ["-doRayleigh"] = true,
    ["-dof"] = true })
end

-- twoNodeLink tag i j -mat ... -dir ... <-orient ...> <-shearDist ...>
function elements.twoNodeLink(self, args)
  local a, b = self.node[tag(self, args[2], "node i")], self.node[tag(self, args[3], "node j")]
  local d = self.ndm == 2 and { b.x - a.x, b.z - a.z, 0 } or { b.x - a.x, b.y - a.y, b.z - a.z }
  local long = not constraints.same_place(a, b)
  local parts = parts_of(self, args)
  if long and (parts.y or parts.z) then
    give_up "a link with a length is read where it has no stiffness across its axis"
  end
  local x, y = orientation(self, args, long and d or nil)
  add(self, args, parts, x, y)
  arguments.other_options(self, args, { ["-mat"] = true, ["-dir"] = true, ["-orient"] = true, ["-doRayleigh"] = true })
end

-- Rows of the frame ---------------------------------------------------------------------------------------------------

-- Whether all degrees of freedom that a node has in the file are held.
local function is_held(node)
  for _, letter in ipairs(node.freedoms) do
    if not node.fixed[letter] then return false end
  end
  return true
end

-- Whether all displacements of two nodes are tied; the tie counts as used by the joint.
local function tied(self, a, b)
  for _, row in ipairs(self.ties) do
    local both = row.from == a and row.to == b or row.from == b and row.to == a
    if row.kind == "equal" and both and row.letters.x and row.letters.z and (self.ndm == 2 or row.letters.y) then
      return row
    end
  end
end

-- The stiffness of an elastic part in SI.
local function stiffness(self, letter, m)
  return #letter == 1 and m.E * self.force / self.length or m.E * self.force * self.length
end

-- Moment over rotation of a material, as hinge.joint takes it.
local function joint_axis(self, m)
  local moment = self.force * self.length
  if not m.fy then return { stiffness = m.E * moment } end
  if m.points then
    local points = {}
    for i, p in ipairs(m.points) do
      if i == 1 or p[2] > m.points[i - 1][2] * (1 + 1e-9) then points[#points + 1] = { p[1], p[2] * moment } end
    end
    if m.imk then
      assume(self, "the backbone of a joint is that of its spring up to the greatest moment, which then stays: its "
        .. "fall, its residual strength and the wear by cycles are left out")
    end
    return { points = points }
  end
  if not (m.b and m.b > 0) then return { stiffness = m.E * moment, strength = m.fy * moment } end
  local turn = m.fy / m.E
  local far = turn + 1 -- rad
  return { points = { { turn, m.fy * moment }, { far, (m.fy + m.b * m.E) * moment } } }
end

local function yields(parts)
  for letter, m in pairs(parts) do
    if m.fy then return letter end
  end
end

local moments = { rx = "Mx", ry = "My", rz = "Mz" }

-- A spring that yields between two nodes whose displacements are tied: a joint between them.
local function add_joint(self, row, a, b)
  local tie = tied(self, row.a, row.b)
  for letter, m in pairs(row.parts) do
    if m.fy and #letter == 1 then return self:not_read "a spring that yields along an axis is not read" end
  end
  if not constraints.same_place(a, b) or not tie and not (row.parts.x and row.parts.y) then
    return self:not_read "a spring that yields is read between nodes at one place whose displacements are tied"
  end
  local joint = { a = a.name, b = b.name, x = row.x, y = row.y }
  for letter, name in pairs(moments) do
    joint[name] = row.parts[letter] and joint_axis(self, row.parts[letter]) or "free"
  end
  if self.ndm == 3 and tie then
    for letter in pairs(tie.letters) do
      if #letter == 2 then return self:not_read "a joint of which some rotations are tied is not read" end
    end
  end
  for _, letter in ipairs { "x", "y", "z" } do b.fixed[letter] = nil end
  if tie then tie.used = true end
  table.insert(self.frame.joints, joint)
end

-- A spring that yields between a member and a support: a joint at the end of the member.
local function add_foot(self, row, node)
  local ends = frame_module.ends_at(self.frame.members)[node.name] or {}
  if #ends ~= 1 or self.ndm == 3 then
    return self:not_read "a spring to the ground that yields is read in a plane frame, at a node of one member"
  end
  if row.parts.x and row.parts.x.fy or row.parts.y and row.parts.y.fy then
    return self:not_read "a spring that yields along an axis is not read"
  end
  if not (node.fixed.x or row.parts.x) or not (node.fixed.z or row.parts.y) then
    return self:not_read "a spring to the ground that yields is read where the displacements are held"
  end
  local m, at = ends[1][1], ends[1][2]
  m.ends = m.ends or {}
  m.ends[at] = { Mx = joint_axis(self, row.parts.rz) }
  constraints.hold(node, constraints.every)
end

local function add_connector(self, row, a, b)
  local k = {}
  for letter, m in pairs(row.parts) do k[letter] = stiffness(self, letter, m) end
  table.insert(self.frame.connectors, { a = a.name, b = b and b.name, x = row.x, y = row.y, stiffness = k })
end

--- Makes rows of the frame of springs. joined: the nodes at which members end. Ties come after it.
local function finish(self, joined)
  for _, row in ipairs(self.springs) do
    self.place = row.place
    local a, b = self.node[row.a], self.node[row.b]
    if not joined[row.a] then a, b = b, a end
    if not joined[a.name] then
      self:not_read_once "no member that was read ends at one of its nodes"
    elseif joined[b.name] then
      if yields(row.parts) then add_joint(self, row, a, b) else add_connector(self, row, a, b) end
    elseif not is_held(b) then
      self:not_read(("node %s is free, and no member ends there"):format(b.name))
    else
      self.used[b.name] = true
      local tie = tied(self, row.a, row.b)
      if tie then
        constraints.hold(a, tie.letters)
        tie.used = true
      end
      if yields(row.parts) then add_foot(self, row, a) else add_connector(self, row, a) end
    end
  end
end

return { elements = elements, finish = finish, joint_axis = joint_axis, tied = tied }
