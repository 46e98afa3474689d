-- Constraints, springs and masses of joints in tables of SAP2000: diaphragms and bodies, equal displacements where a
-- support holds them, springs to the ground, ends with partial fixity, added masses.
local frame_module = require "hinge.import.frame"
local notes = require "hinge.import.notes"

local same_level = 1e-3 -- m, between joints of one level
local directions = frame_module.letters

local Ties = {}
Ties.__index = Ties

-- Constraints ---------------------------------------------------------------------------------------------------------

-- The joints of each constraint that a member joins, in the order of the file, by its name.
function Ties:joints_of()
  local reader, of = self.reader, {}
  for _, row in ipairs(reader:rows "JOINT CONSTRAINT ASSIGNMENTS") do
    local node, name = reader:joint(row, "Joint"), row:need "Constraint"
    row:text "Type"
    of[name] = of[name] or {}
    if self.joined[node.name] then table.insert(of[name], node) end
  end
  return of
end

-- Lists of nodes at the same place along an axis.
local function levels(nodes, axis)
  local sorted, list = table.move(nodes, 1, #nodes, 1, {}), {}
  table.sort(sorted, function(a, b)
    return a[axis] < b[axis] or a[axis] == b[axis] and a.name < b.name
  end)
  for i, node in ipairs(sorted) do
    if i == 1 or node[axis] - sorted[i - 1][axis] > same_level then list[#list + 1] = {} end
    table.insert(list[#list], node)
  end
  return list
end

local function names_of(nodes)
  local list = {}
  for i, node in ipairs(nodes) do list[i] = node.name end
  return list
end

local function holds(node, letter)
  if node.fix == "all" then return true end
  for word in (node.fix or ""):gmatch "[^,]+" do
    if word == letter then return true end
  end
  return false
end

-- Also holds a direction of a node.
local function hold(node, letter)
  if holds(node, letter) then return end
  node.fix = node.fix and node.fix ~= "" and node.fix .. "," .. letter or letter
end

-- A diaphragm of which one joint is held in its plane holds all the others. Returns whether it is so; and the joints
-- that are held in part of it, beyond what is held at all joints, are left out.
function Ties:held_in_plane(nodes, axis)
  local free, letters = {}, frame_module.in_plane[axis]
  for _, node in ipairs(nodes) do
    local held, part = true, false
    for _, letter in ipairs(letters) do
      held = held and holds(node, letter)
      part = part or holds(node, letter) and not self.reader.inactive[letter]
    end
    if held and part then
      for _, other in ipairs(nodes) do
        for _, letter in ipairs(letters) do hold(other, letter) end
      end
      return true
    end
    if not part then free[#free + 1] = node end
  end
  return false, free
end

function Ties:read_diaphragms(of)
  local reader = self.reader
  for _, row in ipairs(reader:rows "CONSTRAINT DEFINITIONS - DIAPHRAGM") do
    local axis = (row:text "Axis" or "Z"):lower()
    if axis == "auto" then axis = "z" end
    local nodes = of[row:need "Name"] or {}
    local parts = row:yes "MultiLevel" and levels(nodes, axis) or { nodes }
    for _, part in ipairs(parts) do
      local held, free = self:held_in_plane(part, axis)
      if held then
        reader:assume(row, "a support holds the diaphragm in its plane, and so all its joints", "held diaphragm")
      elseif #part > 1 then
        if #free < #part then
          reader:not_read(row, "joints of the diaphragm that a support holds in a part of its plane are left out of it")
        end
        part = free
      end
      if not held and #part > 1 then
        table.insert(reader.frame.diaphragms, { nodes = names_of(part), normal = axis })
      end
    end
  end
end

function Ties:read_bodies(of)
  local reader = self.reader
  for _, row in ipairs(reader:rows "CONSTRAINT DEFINITIONS - BODY") do
    local nodes, whole = of[row:need "Name"] or {}, true
    for _, letter in ipairs(directions) do
      whole = whole and (row:text(reader.key_of(letter)) or "Yes"):lower() == "yes"
    end
    if not whole then
      reader:not_read(row, "a body constraint of some of the six directions is not read")
    else
      for i = 2, #nodes do
        table.insert(reader.frame.links, { from = nodes[1].name, to = nodes[i].name, dofs = "all" })
      end
    end
  end
end

-- Displacements that are equal are all zero where a support holds one of them.
function Ties:read_equals(of)
  local reader = self.reader
  for _, row in ipairs(reader:rows "CONSTRAINT DEFINITIONS - EQUAL") do
    local nodes, left = of[row:need "Name"] or {}, false
    for _, letter in ipairs(directions) do
      if row:yes(reader.key_of(letter)) and #nodes > 1 then
        local held = false
        for _, node in ipairs(nodes) do held = held or holds(node, letter) end
        for _, node in ipairs(held and nodes or {}) do hold(node, letter) end
        left = left or not held
      end
    end
    if left then
      reader:not_read(row, "equal displacements of joints that no support holds are not read")
    elseif #nodes > 1 then
      reader:assume(row, "what is equal to a displacement that a support holds is held, too", "equal")
    end
  end
end

-- Released joints -----------------------------------------------------------------------------------------------------

-- Where all ends at a joint are released nothing holds its rotation: one of them does, which has no moment there.
function Ties:hold_released_joints()
  local reader, count, first = self.reader, 0, nil
  local ends = frame_module.ends_at(reader.frame.members)
  for _, node in ipairs(reader.frame.nodes) do
    local list = ends[node.name]
    local free = list and not (holds(node, "rx") and holds(node, "ry") and holds(node, "rz"))
    for _, one in ipairs(list or {}) do free = free and one[1].release and one[1].release[one[2]] end
    if free then
      local m, at = list[1][1], list[1][2]
      m.release[at] = nil
      if not next(m.release) then m.release = nil end
      count, first = count + 1, first or node
    end
  end
  if count == 0 then return end
  local place = reader.places[first] or { file = reader.file }
  notes.add(reader.notes.assumed, place, place.text or "", ("at %d joints all ends are released: the first one holds "
    .. "the joint's rotation, without a moment there but what torsion of the others brings"):format(count))
end

-- Springs -------------------------------------------------------------------------------------------------------------

function Ties:read_springs()
  local reader = self.reader
  for _, row in ipairs(reader:rows "JOINT SPRING ASSIGNMENTS 1 - UNCOUPLED") do
    local node, stiffness = reader:joint(row, "Joint"), {}
    row:text "CoordSys"
    for i, letter in ipairs(directions) do
      local k = row:number(i <= 3 and "U" .. i or "R" .. i - 3, 0)
      k = k * reader.force * (i <= 3 and 1 / reader.length or reader.length)
      if k < 0 then notes.fail(reader.where, row.place, "a spring has the stiffness %g; must not be below 0", k) end
      if k > 0 and not holds(node, letter) then stiffness[letter] = k end
    end
    if self.turned[node.name] then
      reader:not_read(row, "springs of a joint whose axes are turned are not read")
    elseif next(stiffness) and self.joined[node.name] then
      table.insert(reader.frame.connectors, { a = node.name, x = { 1, 0, 0 }, y = { 0, 1, 0 }, stiffness = stiffness })
    end
  end
end

-- Springs of released ends: M3 is Mx, M2 is My, T is Mz of the member's end.
function Ties:read_partial_fixity()
  local reader = self.reader
  for _, row in ipairs(reader:rows "FRAME RELEASE ASSIGNMENTS 2 - PARTIAL FIXITY") do
    local member = reader:frame_of(row)
    local parts = member and reader.parts[member.name] or {}
    for at, letter in pairs { a = "I", b = "J" } do
      local part = at == "a" and parts[1] or parts[#parts]
      for _, key in ipairs { "P", "V2", "V3" } do
        if row:number(key .. letter, 0) ~= 0 then
          reader:not_read(row, "springs of the releases of P, V2 and V3 are not read")
        end
      end
      for key, fields in pairs { M3 = { "Mx", "rx" }, M2 = { "My", "ry" }, T = { "Mz", "rz" } } do
        local k = row:number(key .. letter, 0) * reader.force * reader.length
        local released = part and part.release and part.release[at] or ""
        if k > 0 and released:find(fields[2], 1, true) then
          part.ends = part.ends or {}
          part.ends[at] = part.ends[at] or {}
          part.ends[at][fields[1]] = { stiffness = k }
          local left = released:gsub(fields[2], ""):gsub(",+", ","):gsub("^,", ""):gsub(",$", "")
          part.release[at] = left ~= "" and left or nil
          if not next(part.release) then part.release = nil end
        end
      end
    end
  end
end

-- Masses --------------------------------------------------------------------------------------------------------------

function Ties:add_mass(row, node, mass)
  if mass <= 0 then return end
  local new = { node = node, mass = mass, offset = self.reader.moved_joints[node] }
  self.reader.places[new] = { file = self.reader.file, line = row.place.line, text = row.line }
  table.insert(self.reader.frame.masses, new)
end

function Ties:read_masses()
  local reader = self.reader
  for _, row in ipairs(reader:rows "JOINT ADDED MASS ASSIGNMENTS") do
    local node, v = reader:joint(row, "Joint"), {}
    for i = 1, 3 do v[i] = row:number("Mass" .. i, 0) * reader.mass end
    for i = 1, 3 do
      if row:number("MMI" .. i, 0) ~= 0 then reader:not_read(row, "moments of inertia of joints are not read") end
    end
    row:text "CoordSys"
    local largest = math.max(v[1], v[2], v[3])
    if math.min(v[1], v[2], v[3]) < largest then
      reader:assume(row, "a mass that acts along some axes acts along all", "axes")
    end
    self:add_mass(row, node.name, largest)
  end
  for _, row in ipairs(reader:rows "FRAME ADDED MASS ASSIGNMENTS") do
    local member, per_length = reader:frame_of(row), row:number("MassPerLen", 0) * reader.mass / reader.length
    for _, part in ipairs(member and reader.parts[member.name] or {}) do
      local _, length = frame_module.direction(reader.node[part.a], reader.node[part.b])
      self:add_mass(row, part.a, per_length * length / 2)
      self:add_mass(row, part.b, per_length * length / 2)
    end
    reader:assume(row, "the mass along a frame is put on its joints", "along")
  end
  local rows = reader:rows "MASS SOURCE"
  local first = rows[1]
  local elements = first and (first:text "Elements" or "Yes"):lower()
  if first and elements ~= "yes" then
    reader:not_read(first, "the masses of the file come from its loads, not from its members: what has mass here are "
      .. "the members" .. (#reader.frame.masses > 0 and " and the masses of joints" or ""))
  end
  for _, row in ipairs(rows) do
    for _, key in ipairs { "MassSource", "Elements", "Masses", "Loads", "IsDefault", "LoadPat", "Multiplier" } do
      row:text(key)
    end
  end
end

--- Springs of released ends, and joints at which all ends are released; before the other two.
local function read_ends(reader)
  local self = setmetatable({ reader = reader }, Ties)
  self:read_partial_fixity()
  self:hold_released_joints()
end

--- Reads the rest.
local function read(reader)
  local self = setmetatable({ reader = reader, joined = frame_module.ends_at(reader.frame.members), turned = {} }, Ties)
  for _, row in ipairs(reader:rows "JOINT LOCAL AXES ASSIGNMENTS 1 - TYPICAL") do
    local turned = row:number("AngleA", 0) ~= 0 or row:number("AngleB", 0) ~= 0 or row:number("AngleC", 0) ~= 0
    self.turned[reader:joint(row, "Joint").name] = turned or nil
  end
  if next(self.turned) then
    for _, row in ipairs(reader:rows "JOINT RESTRAINT ASSIGNMENTS") do
      local node = reader.node[row:need "Joint"]
      if self.turned[node.name] and node.fix and node.fix ~= "all" and node.fix ~= "x,y,z" then
        reader:not_read(row, "the joint's axes are turned, and its support is taken along the axes of space")
      end
    end
  end
  local of = self:joints_of()
  self:read_diaphragms(of)
  self:read_bodies(of)
  self:read_equals(of)
  self:read_springs()
  self:read_masses()
end

return { read_ends = read_ends, read = read }
