-- Members from tables of SAP2000: their sections, angles, releases and groups, and their division at joints on them.
-- These are methods of the reader in frame.lua.
local check = require "hinge.library.check"
local divided = require "hinge.import.divided"
local frame_module = require "hinge.import.frame"
local notes = require "hinge.import.notes"
local nonprismatic = require "hinge.import.sap2000.nonprismatic"
local fail = require "hinge.import.sap2000.row".fail

local Members = {}

-- By frame: the rows of a table.
function Members:by_frame(...)
  local found = {}
  for _, name in ipairs { ... } do
    for _, row in ipairs(self:rows(name)) do found[row:need "Frame"] = row end
  end
  return found
end

-- Whether what a member needs was read; else a note or an error.
function Members:has(row, kind, name, known)
  if known then return true end
  local lost = self.unreadable[name]
  if not lost then fail(row, "%s %s of %s is not in the file", kind, name, row.table) end
  if kind == "section" and self.reasons[name] then
    self:not_read(lost, self.reasons[name])
    self.reasons[name] = nil
  end
  self:not_read(row, ("its %s %s was not read, see line %d"):format(kind, name, lost.place.line))
  return false
end

-- The direction of axis 2 where the angle turns it; nil where it is that of hinge.
local function turned(a, b, degrees)
  if degrees == 0 then return nil end
  local one = frame_module.direction(a, b)
  local x, two = frame_module.axes(one) -- axis 3 is -x
  local c, s = math.cos(math.rad(degrees)), math.sin(math.rad(degrees))
  return { c * two[1] - s * x[1], c * two[2] - s * x[2], c * two[3] - s * x[3] }
end

-- The angle of a member, degrees; a mirrored or advanced one is noted.
function Members:angle(row)
  if not row then return 0 end
  if row:yes "AdvanceAxes" or row:yes "MirrorAbt2" or row:yes "MirrorAbt3" then
    self:not_read(row, "of the local axes the angle alone is read")
  end
  return row:number("Angle", 0)
end

-- The released rotations of one end, such as "rx,ry": M3 is rx, M2 is ry, T is rz.
function Members:release(row, at)
  if row:yes("P" .. at) or row:yes("V2" .. at) or row:yes("V3" .. at) then
    self:not_read(row, ("end %s: releases of P, V2 and V3 are not read"):format(at))
  end
  local letters = {}
  for _, pair in ipairs { { "M3", "rx" }, { "M2", "ry" }, { "T", "rz" } } do
    if row:yes(pair[1] .. at) then letters[#letters + 1] = pair[2] end
  end
  return #letters > 0 and table.concat(letters, ",") or nil
end

function Members:releases(row)
  if not row then return nil end
  if row:yes "PartialFix" and not self.tables["FRAME RELEASE ASSIGNMENTS 2 - PARTIAL FIXITY"] then
    self:not_read(row, "a spring of a partial release is not read: the end is released")
  end
  local release = { a = self:release(row, "I"), b = self:release(row, "J") }
  return next(release) and release or nil
end

-- The names of a frame's groups: one or a list.
function Members:groups()
  local of = {}
  for _, row in ipairs(self:rows "GROUPS 2 - ASSIGNMENTS") do
    local group, frame = row:need "GroupName", row:text "ObjectLabel"
    if (row:text "ObjectType" or ""):lower() == "frame" and frame and group:upper() ~= "ALL" then
      local before = of[frame]
      of[frame] = not before and group or type(before) == "table" and before or { before }
      if before then table.insert(of[frame], group) end
    end
  end
  return of
end

-- Section and material of a frame, or nil with a note. given: its row of FRAME SECTION ASSIGNMENTS.
function Members:assigned(given)
  local section = given:text "AnalSect" or given:text "DesignSect" or given:need "Section"
  local own = given:text "MatProp"
  if section:lower() == "none" then
    self:not_read(given, "the frame has no section")
    return nil
  end
  if not self:has(given, "section", section, self.section[section]) then return nil end
  local of = self.section[section]
  local material = own and own ~= "Default" and own or of.material
  if of.first and not self.material[material or ""] then material = (self.section[of.first] or of).material end
  if not self:has(given, "material", material, self.material[material]) then return nil end
  return section, material
end

-- A row of CONNECTIVITY - FRAME as a member. more: angles, releases and groups by frame.
function Members:read_member(row, given, more)
  local name, a, b = row:need "Frame", self:joint(row, "JointI"), self:joint(row, "JointJ")
  for _, key in ipairs { "Length", "CentroidX", "CentroidY", "CentroidZ" } do row:text(key) end
  if self.lost[name] or self.member[name] then fail(row, "frame %s is there twice", name) end
  if not given then fail(row, "frame %s is not in TABLE \"FRAME SECTION ASSIGNMENTS\"", name) end
  if a.x == b.x and a.y == b.y and a.z == b.z then fail(row, "frame %s has no length", name) end
  self.lost[name] = row -- until it is read
  if row:yes "IsCurved" then return self:not_read(row, "the frame is curved") end
  local section, material = self:assigned(given)
  if not section then return end
  local member = { name = name, a = a.name, b = b.name, section = section, material = material,
    up = turned(a, b, self:angle(more.angles[name])), group = more.groups[name],
    release = self:releases(more.releases[name]) }
  self.lost[name], self.member[name] = nil, member
  self.places[member] = { file = self.file, line = row.place.line, text = row.line }
  table.insert(self.frame.members, member)
end

function Members:read_members()
  local assigned = self:by_frame "FRAME SECTION ASSIGNMENTS"
  local more = { groups = self:groups(), releases = self:by_frame "FRAME RELEASE ASSIGNMENTS 1 - GENERAL",
    angles = self:by_frame("FRAME LOCAL AXES 1 - TYPICAL", "FRAME LOCAL AXES ASSIGNMENTS 1 - TYPICAL") }
  for _, row in ipairs(self:rows "CONNECTIVITY - FRAME") do
    self:read_member(row, assigned[row:need "Frame"], more)
  end
  for _, rows in ipairs { assigned, more.releases, more.angles } do
    for _, row in pairs(rows) do self:frame_of(row) end
  end
end

-- The member of a row, or nil where it was not read; an error where the file has no such frame.
function Members:frame_of(row)
  local name = row:need "Frame"
  if not self.member[name] and not self.lost[name] then
    fail(row, "%s: frame %s is not in CONNECTIVITY - FRAME", row.table, name)
  end
  return self.member[name]
end

-- Divides the frames on which other joints lie, as SAP2000 does unless FRAME AUTO MESH says otherwise.
function Members:divide()
  local meshes = self:by_frame("FRAME AUTO MESH", "FRAME AUTO MESH ASSIGNMENTS")
  local on_axis, members = divided(self.frame.nodes), {}
  for _, m in ipairs(self.frame.members) do
    local row = meshes[m.name]
    if row and row:yes "AtFrames" and row:yes "AutoMesh" then
      self:not_read(row, "AtFrames=Yes: the frame is not divided where it crosses others")
    end
    local joined = not row or (row:text "AutoMesh" or "Yes") == "Yes" and (row:text "AtJoints" or "Yes") == "Yes"
    local names = joined and on_axis(self.node[m.a], self.node[m.b]) or {}
    if #names > 0 then self:note_division(m, names) end
    local section_at
    if self.nonprismatic[m.section] then names, section_at = self:cut(m, names) end
    self.parts[m.name] = not names and {} or #names == 0 and not section_at and { m }
      or self:parts_of(m, names, section_at)
    table.move(self.parts[m.name], 1, #self.parts[m.name], #members + 1, members)
  end
  self.frame.members = members
end

-- The nodes of a nonprismatic member, and its section at a place; nil where it cannot be read.
function Members:cut(member, names)
  local _, length = frame_module.direction(self.node[member.a], self.node[member.b])
  local pieces, reason = nonprismatic.pieces(self, member, length)
  if pieces then return nonprismatic.cut(self, member, pieces, names) end
  local place = self.places[member]
  notes.once(self.notes, place, place.text, reason)
  self.lost[member.name], self.member[member.name] = member, nil
  return nil
end

function Members:note_division(member, names)
  local place = self.places[member]
  notes.once(self.notes.assumed, place, place.text, ("it is divided at joints on it (%s), as %s does"):format(
    table.concat(names, ", "), self.program), "divided")
end

-- The parts of a member between nodes on it: "3/1", "3/2" and so on. section_at: its section at a distance along it.
function Members:parts_of(member, names, section_at)
  local parts, from, release = {}, member.a, member.release or {}
  for i = 1, #names + 1 do
    local part = check.copy(member)
    part.name, part.a, part.b = ("%s/%d"):format(member.name, i), from, names[i] or member.b
    local own = { a = i == 1 and release.a or nil, b = i > #names and release.b or nil }
    if section_at then
      local _, before = frame_module.direction(self.node[member.a], self.node[from])
      local _, after = frame_module.direction(self.node[member.a], self.node[part.b])
      part.section = section_at(((from == member.a and 0 or before) + after) / 2)
    end
    part.release, from = next(own) and own or nil, part.b
    parts[i] = part
  end
  return parts
end

return Members
