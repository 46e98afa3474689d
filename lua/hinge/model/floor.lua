-- model:floor: loads and masses of floors on the members that carry them (floor_strips.lua).
local core = require "hinge.core"
local check = require "hinge.library.check"
local chosen = require "hinge.model.chosen_members"
local faces = require "hinge.actions.faces"
local slab = require "hinge.model.slab"
local strips = require "hinge.model.floor_strips"
local tributary = require "hinge.model.tributary"
local vectors = require "hinge.library.vectors"

local where = "model:floor"
local times = vectors.times

-- Options -------------------------------------------------------------------------------------------------------------

local function is_span(value)
  return value == "one way" or value == "two way" or type(value) == "table"
end

local rules = {
  corners = { "table", optional = true }, members = faces.any, group = faces.any,
  load = { "a load", optional = true, words = "a number in Pa, or a table with one for each load case",
    good = function(v) return type(v) == "number" or type(v) == "table" end },
  mass = { "number", unit = "kg/m^2", at_least = 0, optional = true },
  span = { "a span", default = "two way", good = is_span,
    words = "\"two way\", \"one way\" or the direction of span, { x, y, z }" },
  slab = { "table", optional = true },
  openings = { "table", optional = true }, direction = { "numbers", count = 3, default = { 0, 0, -1 } },
  case = faces.any, history = faces.any,
}

-- The loads as { case =, value = (Pa) }, in the order of their names.
local function read_loads(o)
  if type(o.load) ~= "table" then
    if not o.load then
      for _, field in ipairs { "case", "history" } do
        if o[field] ~= nil then check.fail("%s: field '%s' is given without 'load'", where, field) end
      end
      return {}
    end
    return { { case = o.case, value = check.value(where, "load", o.load, { "number", unit = "Pa" }) } }
  end
  if o.case ~= nil then
    check.fail("%s: field 'case' is given beside loads of several cases; leave it out", where)
  end
  local list = {}
  if o.load[1] ~= nil then
    check.fail("%s: field 'load' is a list; must be a number in Pa, or a table with one for each load case, such as "
      .. "{ live = 3e3 }", where)
  end
  for _, case in ipairs(check.keys(o.load)) do
    list[#list + 1] = { case = case, value = check.value(where, "load." .. case, o.load[case],
      { "number", unit = "Pa" }) }
  end
  if #list == 0 then check.fail("%s: field 'load' is empty; give a number in Pa for each load case", where) end
  return list
end

-- Before the first load is declared: a floor is declared as a whole or not at all.
local function refuse_unknown_cases(model, o)
  local names = {}
  for i, case in ipairs(model:cases()) do names[i] = case.name end
  for _, load in ipairs(o.loads) do
    local known = load.case == nil or check.kind_of(load.case) ~= nil
    for _, name in ipairs(names) do known = known or name == load.case end
    if not known then check.unknown(where, "load case", load.case, names) end
  end
end

-- Points of a field, which may be nodes.
local function points_of(field, list, fewest)
  if type(list) ~= "table" or #list < fewest then
    check.fail("%s: field '%s' is %s; must be a list of %d or more points {x, y, z} in m, or nodes, in their order",
      where, field, type(list) == "table" and check.count(#list, "point") or check.show(list), fewest)
  end
  local points = {}
  for i, point in ipairs(list) do
    points[i] = check.kind_of(point) == "node" and vectors.of_node(point)
      or check.value(where, ("%s[%d]"):format(field, i), point, { "numbers", count = 3, unit = "m" })
  end
  return points
end

local function read_openings(o, plane)
  local list = {}
  for i, opening in ipairs(o.openings or {}) do
    local field = ("openings[%d]"):format(i)
    local polygon = strips.flat_polygon(plane, field, points_of(field, opening, 3))
    if math.abs(tributary.area(polygon)) <= plane.slack ^ 2 then
      check.fail("%s: the points of field '%s' enclose no area", where, field)
    end
    if tributary.area(polygon) < 0 then -- turns to the left
      local turned = {}
      for k = #polygon, 1, -1 do turned[#turned + 1] = polygon[k] end
      polygon = turned
    end
    for j, other in ipairs(list) do
      if tributary.overlap(polygon, other) > plane.slack ^ 2 then
        check.fail("%s: field '%s' overlaps openings[%d]", where, field, j)
      end
    end
    list[i] = polygon
  end
  return list
end

local function read(model, options, outlines)
  local o = check.options(where, options, rules)
  if o.load == nil and o.mass == nil and o.slab == nil then
    check.fail("%s: neither 'load' (Pa) nor 'mass' (kg/m^2) is given", where)
  end
  if o.slab and o.openings and #o.openings > 0 then
    check.fail("%s: field 'openings' does not go with 'slab' yet; leave parts of the floor out by 'corners'", where)
  end
  if type(o.span) == "table" then o.span = faces.direction(where, "span", o.span) end
  o.direction = faces.direction(where, "direction", o.direction)
  o.loads = read_loads(o)
  refuse_unknown_cases(model, o)
  local members
  if o.members == nil and o.group == nil then
    if not o.corners and not outlines then
      check.fail("%s: give 'corners', 'members' or 'group', which say where the floor is", where)
    end
    members = model:members()
  else
    members = chosen.members(where, model, o.members, o.group)
  end
  local planes = not o.corners and not outlines and strips.levels_of(members) or {}
  for i, corners in ipairs(outlines or { o.corners }) do
    planes[i] = strips.plane_of(points_of("corners", corners, 3))
  end
  if o.openings and #o.openings > 0 and not o.corners then
    check.fail("%s: field 'openings' needs 'corners', which say in which floor they are", where)
  end
  for _, plane in ipairs(planes) do plane.openings = read_openings(o, plane) end
  return o, members, planes
end

-- The floor -----------------------------------------------------------------------------------------------------------

local Floor = {}
local class = check.class(Floor, "hinge.floor")

function class.__tostring(self)
  local text = ("%s, %.6g m^2"):format(check.count(#self.panels, "panel"), self.area)
  if self.load ~= 0 then text = text .. (", %.6g kN"):format(self.load / 1e3) end
  if self.mass > 0 then text = text .. (", %.6g kg"):format(self.mass) end
  if self.slab then return ("%s; a slab of %s"):format(text, check.count(#self.slab, "panel")) end
  text = text .. " on " .. check.count(#self.parts, "member")
  if #self.idle == 0 then return text end
  return ("%s; %s of those given %s nothing"):format(text, check.count(#self.idle, "member"),
    #self.idle == 1 and "carries" or "carry")
end

--- The table of what each member carries.
function Floor:text()
  local lines = { tostring(self), "  member        area m^2        load kN         mass kg" }
  for _, part in ipairs(self.parts) do
    lines[#lines + 1] = ("  %6d  %14.6g  %13.6g  %14.6g"):format(part.member.index, part.area, part.load / 1e3,
      part.mass)
  end
  return table.concat(lines, "\n")
end

-- Declares what one member carries; returns its part.
local function declare(model, o, carrier)
  local member = carrier.member
  local part = { member = member, area = 0, load = 0, mass = 0 }
  for _, s in ipairs(carrier) do
    local whole = s.from == 0 and s.to == 1
    local from, to = not whole and s.from or nil, not whole and s.to or nil
    local area = (s.a + s.b) / 2 * (s.to - s.from) * member.length
    part.area = part.area + area
    for _, load in ipairs(o.loads) do
      part.load = part.load + load.value * area
      if load.value ~= 0 then
        model:load { member = member, from = from, to = to, case = load.case, history = o.history,
          q = { a = times(load.value * s.a, o.direction), b = times(load.value * s.b, o.direction) } }
      end
    end
    if o.mass and o.mass > 0 then
      part.mass = part.mass + o.mass * area
      model:mass { member = member, from = from, to = to, per_length = { a = o.mass * s.a, b = o.mass * s.b } }
    end
  end
  return part
end

-- The level members among those given that carry nothing.
local function idle_of(o, members, parts)
  local idle, carries = {}, {}
  if o.members == nil and o.group == nil then return idle end
  for _, part in ipairs(parts) do carries[part.member.index] = true end
  for _, member in ipairs(members) do
    if not carries[member.index] and math.abs(member.a.z - member.b.z) < 1e-6 * member.length then
      idle[#idle + 1] = member
    end
  end
  return idle
end

--- model:floor: see words/loads.d.lua. outlines: several floors in the place of `corners` (grid:floor).
return function(model, options, outlines, ...)
  check.no_more(where, ...)
  local o, members, planes = read(model, options, outlines)
  local list, carriers = strips.of(planes, members, o.span)
  local floor, nodes = { panels = {}, parts = {}, area = 0, load = 0, mass = 0 }, model:nodes()
  for _, panel in ipairs(list) do
    local corners = {}
    for i, index in ipairs(panel.nodes) do corners[i] = nodes[index] end
    table.insert(floor.panels, { nodes = corners, area = panel.area })
    if not o.slab then core.add_panel(model, corners, panel.around) end
    floor.area = floor.area + panel.area
  end
  if o.slab then
    floor.slab, floor.idle = slab.lay(model, list, o), {}
    for _, panel in ipairs(floor.slab) do floor.mass = floor.mass + panel.mass end
    for _, load in ipairs(o.loads) do floor.load = floor.load + load.value * floor.area end
    return setmetatable(floor, class)
  end
  for _, carrier in ipairs(carriers) do
    local part = declare(model, o, carrier)
    table.insert(floor.parts, part)
    floor.load, floor.mass = floor.load + part.load, floor.mass + part.mass
  end
  floor.idle = idle_of(o, members, floor.parts)
  return setmetatable(floor, class)
end
