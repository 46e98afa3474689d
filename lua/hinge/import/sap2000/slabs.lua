-- Areas of SAP2000 and ETABS as slabs of the frame (import/slabs.lua), where the option `slabs` asks for it: those with
-- members along all of their edges. Areas of one kind that go on into each other without a member between them, as a
-- mesh does, are one slab. What no slab can be stays as it is without the option, and a note says why.
local check = require "hinge.library.check"
local frame_module = require "hinge.import.frame"
local notes = require "hinge.import.notes"
local sheets = require "hinge.import.sap2000.sheets"
local strips = require "hinge.model.floor_strips"
local vectors = require "hinge.library.vectors"

local near = 1e-3 -- m
local finest = 16 -- times the panels that are asked for: sides that need more do not fit each other

local Slabs = {}
Slabs.__index = Slabs

-- Loads ---------------------------------------------------------------------------------------------------------------

-- The loads of an area that a slab has, Pa by case, and whether there are others.
function Slabs:loads_of(area)
  local sums, others = {}, false
  for _, load in ipairs(area.loads) do
    if load.value and self.reader.case[load.pattern] then
      sums[load.pattern] = (sums[load.pattern] or 0) + load.value
    else
      others = true
    end
  end
  local parts = {}
  for _, name in ipairs(check.keys(sums)) do
    if sums[name] == 0 then sums[name] = nil else parts[#parts + 1] = ("%q=%.17g"):format(name, sums[name]) end
  end
  return sums, others, table.concat(parts, " ")
end

-- Areas that go on into each other ------------------------------------------------------------------------------------

local function key_of(p)
  return ("%.0f %.0f %.0f"):format(math.floor(p[1] / near + 0.5), math.floor(p[2] / near + 0.5),
    math.floor(p[3] / near + 0.5))
end

-- An edge as a key: the same from both sides.
local function edge_key(p, q)
  local a, b = key_of(p), key_of(q)
  return a < b and a .. "|" .. b or b .. "|" .. a
end

-- Whether a member lies along an edge.
function Slabs:is_carried(p, q)
  local along, length = vectors.unit(vectors.minus(q, p))
  local middle = vectors.between(p, q, 0.5)
  for _, member in ipairs(self:members_near { p, q }) do
    local a, d = vectors.of_node(member.a), vectors.minus(vectors.of_node(member.b), vectors.of_node(member.a))
    local place = vectors.dot(vectors.minus(middle, a), d) / vectors.dot(d, d)
    local off = vectors.length(vectors.minus(middle, vectors.plus(a, place, d)))
    local turned = vectors.length(vectors.cross(along, vectors.unit(d))) * length
    if off < near and turned < near and place > 0 and place < 1 then return true end
  end
  return false
end

-- The outline of areas: their edges that belong to one of them, in one ring; nil where there are several.
local function outline_of(areas)
  if #areas == 1 then return areas[1].ring end
  local count, from = {}, {}
  for _, area in ipairs(areas) do
    for i, p in ipairs(area.ring) do
      local key = edge_key(p, area.ring[i % #area.ring + 1])
      count[key] = (count[key] or 0) + 1
    end
  end
  local edges = 0
  for _, area in ipairs(areas) do
    for i, p in ipairs(area.ring) do
      local q = area.ring[i % #area.ring + 1]
      if count[edge_key(p, q)] == 1 then
        if from[key_of(p)] then return nil end
        from[key_of(p)], edges = { p, q }, edges + 1
      end
    end
  end
  local first = areas[1].ring[1]
  for _, edge in pairs(from) do
    if key_of(edge[1]) < key_of(first) or not from[key_of(first)] then first = edge[1] end
  end
  local ring, at = {}, key_of(first)
  while from[at] and #ring < edges do
    ring[#ring + 1] = from[at][1]
    at = key_of(from[at][2])
  end
  return #ring == edges and at == key_of(first) and ring or nil
end

-- The normal of a polygon, of length 1.
local function normal_of(points)
  local n = { 0, 0, 0 }
  for i = 2, #points - 1 do
    n = vectors.plus(n, 1, vectors.cross(vectors.minus(points[i], points[1]), vectors.minus(points[i + 1], points[1])))
  end
  return (vectors.unit(n))
end

-- The corners of an area and its normal, so that all areas of a plane turn the same way: common edges then cancel.
local function ring_of(points)
  local n = normal_of(points)
  for _, i in ipairs { 3, 1, 2 } do
    if n[i] > 1e-9 then return points, n end
    if n[i] < -1e-9 then
      local ring = {}
      for k = #points, 1, -1 do ring[#ring + 1] = points[k] end
      return ring, vectors.times(-1, n)
    end
  end
end

-- The areas as groups, each of those of one kind and one plane that share edges without a member.
function Slabs:groups_of(areas)
  local root, at_edge = {}, {}
  local function find(area)
    while root[area] do area = root[area] end
    return area
  end
  for _, area in ipairs(areas) do
    for i, p in ipairs(area.ring) do
      local q = area.ring[i % #area.ring + 1]
      local key = edge_key(p, q)
      for _, other in ipairs(at_edge[key] or {}) do
        local a, b = find(area), find(other)
        if a ~= b and area.kind == other.kind and vectors.dot(area.normal, other.normal) > 1 - 1e-9
          and not self:is_carried(p, q) then
          root[a] = b
        end
      end
      at_edge[key] = at_edge[key] or {}
      table.insert(at_edge[key], area)
    end
  end
  local groups, of = {}, {}
  for _, area in ipairs(areas) do
    local r = find(area)
    if not of[r] then
      of[r] = { areas = {} }
      groups[#groups + 1] = of[r]
    end
    table.insert(of[r].areas, area)
  end
  return groups
end

-- Parts of slabs ------------------------------------------------------------------------------------------------------

-- Why the nodes of a member do not lie between its joints; nil: they do.
function Slabs:beside(member)
  local row = self.reader.frame.members[member.index]
  local d = frame_module.direction(member.a, member.b)
  for _, by in pairs(row.offset or {}) do
    if vectors.length(vectors.cross(by, d)) > near then
      return ("member %s along it lies beside its joints"):format(row.name)
    end
  end
end

-- Finds the parts of a group between the members; returns why there are none.
function Slabs:divide(group)
  local points = outline_of(group.areas)
  if not points then return "with the areas that go on from it, it has no outline of one ring" end
  local good, parts = pcall(function()
    local plane = strips.plane_of(points)
    plane.openings = {}
    return (strips.of({ plane }, self:members_near(points), "two way"))
  end)
  if not good then return tostring(parts):gsub("^.-model:floor: ", "") end
  for _, part in ipairs(parts) do
    if #part.sides ~= 4 then
      return ("a part of it between members has %d sides, and slabs have four"):format(#part.sides)
    end
    for _, member in ipairs(part.around) do
      local reason = self:beside(member)
      if reason then return reason end
    end
    local nodes = table.move(part.nodes, 1, #part.nodes, 1, {})
    table.sort(nodes)
    part.key = table.concat(nodes, " ")
    if self.seen[part.key] then return "another slab lies there" end
  end
  for _, part in ipairs(parts) do self.seen[part.key] = true end
  group.points, group.parts = points, parts
end

-- Elements of members -------------------------------------------------------------------------------------------------

local function count_along(side, elements)
  local sum = 0
  for _, piece in ipairs(side.pieces) do sum = sum + elements[piece.member.index] end
  return sum
end

local pair = 2 -- elements of a member: model:member takes an even number

-- Divides the longest elements along a side, until there are so many. Returns whether any was divided.
local function raise(side, elements, target)
  local count = count_along(side, elements)
  local any = count < target
  while count < target do
    local longest, size = nil, 0
    for _, piece in ipairs(side.pieces) do
      local own = (piece.to - piece.from) / elements[piece.member.index]
      if own > size * (1 + 1e-9) then longest, size = piece.member.index, own end
    end
    elements[longest], count = elements[longest] + pair, count + pair
  end
  return any
end

-- Elements of the members along all parts, as many along a side as along the one across; or the groups that do not
-- fit.
function Slabs:balance(groups)
  local elements, panels, unfit = {}, self.option.panels, {}
  for _, group in ipairs(groups) do
    for _, part in ipairs(group.parts) do
      for _, member in ipairs(part.around) do elements[member.index] = pair end
    end
  end
  local any
  repeat
    any = false
    for _, group in ipairs(groups) do
      for _, part in ipairs(group.parts) do
        for k = 1, 2 do
          local one, two = part.sides[k], part.sides[k + 2]
          local target = math.max(panels, count_along(one, elements), count_along(two, elements))
          if target > finest * panels then
            unfit[group] = true
          else
            local first, second = raise(one, elements, target), raise(two, elements, target)
            any = any or first or second
          end
        end
      end
    end
  until not any or next(unfit)
  return elements, unfit
end

-- What fits -----------------------------------------------------------------------------------------------------------

function Slabs:refuse(group, reason)
  for _, area in ipairs(group.areas) do
    notes.once(self.reader.notes, area.row.place, area.row.line, "it is not laid as a slab: " .. reason, "no slab")
  end
end

function Slabs:add(group, elements)
  local reader, list, taken = self.reader, {}, {}
  for _, part in ipairs(group.parts) do
    for _, member in ipairs(part.around) do
      if not taken[member.index] then
        taken[member.index] = true
        reader.frame.members[member.index].elements = elements[member.index]
        list[#list + 1] = member.name
      end
    end
  end
  local area = group.areas[1]
  local load = next(area.sums) and area.sums or nil
  table.insert(reader.frame.slabs, { name = area.name, sheet = area.sheet, corners = group.points, members = list,
    load = load, weight = area.weight > 0 and area.weight or nil })
  for _, one in ipairs(group.areas) do
    self.laid[one] = true
    for _, other in ipairs(one.loads) do
      if not (other.value and reader.case[other.pattern]) then
        notes.once(reader.notes, one.row.place, one.row.line, "its loads in other directions than down are not read",
          "slab load")
      end
    end
  end
end

-- Areas that can be slabs by what they are made of.
function Slabs:candidates(areas)
  local list = {}
  for _, area in ipairs(areas) do
    local sheet, reason = nil, nil
    if #area.points < 3 or area.size <= near * near then reason = "its corners enclose no area" end
    if not reason then sheet, reason = self.sheets:of(area.section, area.angle or 0) end
    if sheet then
      local sums, _, text = self:loads_of(area)
      area.sheet, area.sums, area.ring, area.normal = sheet, sums, ring_of(area.points)
      area.kind = ("%s %.17g %s"):format(sheet, area.weight, text)
      list[#list + 1] = area
    else
      self:refuse({ areas = { area } }, reason)
    end
  end
  self.sheets:ask()
  return list
end

function Slabs:note_laid(groups)
  local count, size, first = 0, 0, nil
  for _, group in ipairs(groups) do
    for _, area in ipairs(group.areas) do
      count, size, first = count + 1, size + area.size, first or area.row
    end
  end
  if not first then return end
  notes.add(self.reader.notes.assumed, first.place, first.line, ("%s of %.4g m^2 in all: plates between the members "
    .. "around, bonded to the nodes of these, with at least %d panels along a side; they have mass"):format(
    check.count(count, "area"), size, self.option.panels))
end

function Slabs:lay(areas)
  local groups = {}
  for _, group in ipairs(self:groups_of(self:candidates(areas))) do
    local reason = self:divide(group)
    if reason then self:refuse(group, reason) else groups[#groups + 1] = group end
  end
  local elements, unfit
  repeat
    elements, unfit = self:balance(groups)
    local kept = {}
    for _, group in ipairs(groups) do
      if unfit[group] then
        self:refuse(group, "its sides take ever more panels to fit those across and beside it")
      else
        kept[#kept + 1] = group
      end
    end
    groups = kept
  until not next(unfit)
  for _, group in ipairs(groups) do self:add(group, elements) end
  self:note_laid(groups)
  local frame, used = self.reader.frame, {}
  for _, row in ipairs(frame.slabs) do
    if not used[row.sheet] then
      used[row.sheet] = true
      table.insert(frame.sheets, self.sheets.made[row.sheet])
    end
  end
end

--- Lays what areas can be slabs. Returns them as a set. members_near(points): the members in the box around points.
return function(reader, areas, members_near)
  reader.frame.sheets, reader.frame.slabs = {}, {}
  local self = setmetatable({ reader = reader, option = reader.slabs, sheets = sheets.new(reader), laid = {}, seen = {},
    members_near = function(_, points) return members_near(points) end }, Slabs)
  self:lay(areas)
  return self.laid
end
