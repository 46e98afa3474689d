-- hinge.grid: a frame by the lines of its plan and its storeys, with names such as "B2, storey 1". Column lines are
-- called A, B, ... along x and 1, 2, ... along y; level 0 is the base. words/grid.d.lua describes the calls.
local check = require "hinge.library.check"

local Grid = {}
local class = check.class(Grid, "hinge.grid")

-- What model:member takes beside its nodes.
local member_options = { "section", "material", "up", "group", "elements", "backbone", "law", "carries",
  "ends", "release", "offset" }
local list_rule = { "table", optional = true }
local floor_options = { cells = true, storeys = true, members = true, group = true, load = true, mass = true,
  span = true, direction = true, case = true, history = true }
local of_member = {}
for _, name in ipairs(member_options) do of_member[name] = true end

-- Names ---------------------------------------------------------------------------------------------------------------

-- 1 is A, 26 is Z, 27 is AA.
local function letters(i)
  local text = ""
  while i > 0 do
    text = string.char(65 + (i - 1) % 26) .. text
    i = (i - 1) // 26
  end
  return text
end

local function place_name(line, level)
  return level == 0 and line .. ", base" or ("%s, storey %d"):format(line, level)
end

-- "B2, storey 1", "B2, base" or "B2" with a level: the line and the level.
local function parse(where, name, level)
  if type(name) ~= "string" then
    check.fail("%s: the place is %s; give a name such as 'B2, storey 1', or a line such as 'B2' and a storey", where,
      check.show(name))
  end
  local line, rest = name:match "^%s*(%a+%d+)%s*,?%s*(.-)%s*$"
  local storey = rest == "base" and 0 or rest and math.tointeger(tonumber(rest:match "^storey%s+(%d+)$"))
  if line and rest == "" and level == nil then
    check.fail("%s: '%s' is a line; give a storey with it, as in '%s, storey 1', or '%s, base'", where, name, line,
      line)
  end
  if not line or (rest ~= "" and not storey) then
    check.fail("%s: '%s' is no place of a grid; they are called 'B2, storey 1' or 'B2, base'", where, name)
  end
  return line:upper(), storey or level
end

function Grid:node(name, level)
  local where = "grid:node"
  if level ~= nil then check.value(where, "storey", level, { "number", whole = true, at_least = 0 }) end
  local line, storey = parse(where, name, level)
  local column = self.columns_of[line]
  if not column then check.unknown(where, "line", line, self.names) end
  local node = column[storey]
  if not node then check.fail("%s: '%s' has no storey %d; the highest is %d", where, line, storey, self.storeys) end
  return node
end

function Grid:name(node)
  return self.name_of[node.index]
    or check.fail("grid:name: %s is not of this grid", tostring(node))
end

function Grid:lines()
  return table.move(self.names, 1, #self.names, 1, {})
end

-- Members -------------------------------------------------------------------------------------------------------------

local function first_group(group) return type(group) == "table" and group[1] or group end

function Grid:defaults(options, ...)
  check.no_more("grid:defaults", ...)
  if type(options) ~= "table" then
    check.fail("grid:defaults: takes a table of what model:member takes, got %s", check.show(options))
  end
  for field in pairs(options) do
    if not of_member[field] then check.unknown("grid:defaults", "field", tostring(field), member_options) end
  end
  local kept = {}
  for field, value in pairs(options) do kept[field] = value end
  self.kept[first_group(options.group) or ""] = kept
  return self
end

-- A member between two nodes: what its options leave out is taken from the defaults of its group, then from those of
-- all members.
function Grid:add(a, b, options)
  local made = { a, b }
  for _, field in ipairs(member_options) do made[field] = options[field] end
  local group = first_group(made.group)
  for _, defaults in ipairs { group and self.kept[group] or {}, self.kept[""] or {} } do
    for field, value in pairs(defaults) do
      if made[field] == nil then made[field] = value end
    end
  end
  return self.model:member(made)
end

-- Splits the one argument of a call, its options, into those of the call, checked by `rules`, and those of the members.
local function split(where, rules, options, ...)
  check.no_more(where, ...)
  if type(options) ~= "table" then check.fail("%s: takes a table of options, got %s", where, check.show(options)) end
  local own, of_members, known = {}, {}, check.keys(rules)
  for _, name in ipairs(member_options) do known[#known + 1] = name end
  for field, value in pairs(options) do
    if of_member[field] then of_members[field] = value
    elseif rules[field] then own[field] = value
    else check.unknown(where, "field", tostring(field), known) end
  end
  return check.options(where, own, rules), of_members
end

-- Storeys as a list: all, or those given.
local function storeys_of(self, where, given)
  if given == nil then
    given = {}
    for i = 1, self.storeys do given[i] = i end
  end
  for i, storey in ipairs(given) do
    check.value(where, ("storeys[%d]"):format(i), storey,
      { "number", whole = true, at_least = 1, at_most = self.storeys })
  end
  return given
end

local function lines_of(self, where, given)
  if given == nil then return self.names end
  local list = {}
  for i, name in ipairs(given) do
    local line = type(name) == "string" and name:upper()
    if not self.columns_of[line] then check.unknown(where .. ": field 'at'", "line", tostring(name), self.names) end
    list[i] = line
  end
  return list
end

function Grid:columns(options, ...)
  local where = "grid:columns"
  local o, of_members = split(where, { at = list_rule, storeys = list_rule }, options, ...)
  local made = {}
  for _, storey in ipairs(storeys_of(self, where, o.storeys)) do
    for _, line in ipairs(lines_of(self, where, o.at)) do
      local column = self.columns_of[line]
      made[#made + 1] = self:add(column[storey - 1], column[storey], of_members)
    end
  end
  return made
end

function Grid:beams(options, ...)
  local where = "grid:beams"
  local o, of_members = split(where, { along = { "string", one_of = { "x", "y" } }, at = list_rule,
    storeys = list_rule }, options, ...)
  local wanted = {}
  for _, name in ipairs(o.at or {}) do wanted[tostring(name):upper()] = true end
  local along_x, nx, ny = o.along == "x", #self.x, #self.y
  local function name_of(line) return along_x and tostring(line) or letters(line) end
  local function column(line, i) return self.columns_of[along_x and letters(i) .. line or letters(line) .. i] end
  local made, found = {}, 0
  for _, storey in ipairs(storeys_of(self, where, o.storeys)) do
    for line = 1, along_x and ny or nx do
      if not o.at or wanted[name_of(line)] then
        found = found + 1
        for i = 1, (along_x and nx or ny) - 1 do
          made[#made + 1] = self:add(column(line, i)[storey], column(line, i + 1)[storey], of_members)
        end
      end
    end
  end
  if found == 0 then
    check.fail("%s: field 'at' names no line; beams along %s are on lines %s to %s", where, o.along, name_of(1),
      name_of(along_x and ny or nx))
  end
  return made
end

function Grid:braces(options, ...)
  local where = "grid:braces"
  local o, of_members = split(where, { from = { "string" }, to = { "string" }, storeys = list_rule,
    shape = { "string", one_of = { "/", "\\", "X" }, default = "/" } }, options, ...)
  local ends = lines_of(self, where, { o.from, o.to })
  local from, to = self.columns_of[ends[1]], self.columns_of[ends[2]]
  local made = {}
  for _, storey in ipairs(storeys_of(self, where, o.storeys)) do
    if o.shape ~= "\\" then made[#made + 1] = self:add(from[storey - 1], to[storey], of_members) end
    if o.shape ~= "/" then made[#made + 1] = self:add(to[storey - 1], from[storey], of_members) end
  end
  return made
end

-- The corners of a cell such as "A1-B2", by the lines at two of its opposite corners.
local function cell_of(self, where, cell)
  local one, two = tostring(cell):match "^%s*(%a+%d+)%s*%-%s*(%a+%d+)%s*$"
  if not one then
    check.fail("%s: field 'cells' has %s; a cell is called by two opposite corners, such as 'A1-B2'", where,
      check.show(cell))
  end
  for _, line in ipairs { one, two } do
    if not self.columns_of[line:upper()] then
      check.unknown(("%s: field 'cells': '%s'"):format(where, cell), "line", line, self.names)
    end
  end
  local ends = lines_of(self, where, { one, two })
  local x, y = {}, {}
  for i, line in ipairs(ends) do x[i], y[i] = line:match "^(%a+)(%d+)$" end
  if x[1] == x[2] or y[1] == y[2] then
    check.fail("%s: the cell '%s' has no area; its corners must differ in both lines", where, cell)
  end
  return { x[1] .. y[1], x[2] .. y[1], x[2] .. y[2], x[1] .. y[2] }
end

function Grid:floor(options, ...)
  local where = "grid:floor"
  check.no_more(where, ...)
  if type(options) ~= "table" then check.fail("%s: takes a table of options, got %s", where, check.show(options)) end
  local others = {}
  for field, value in pairs(options) do
    if not floor_options[field] then check.unknown(where, "field", tostring(field), check.keys(floor_options)) end
    if field ~= "cells" and field ~= "storeys" then others[field] = value end
  end
  for _, field in ipairs { "cells", "storeys" } do
    if options[field] ~= nil then check.value(where, field, options[field], list_rule) end
    if options[field] and #options[field] == 0 then
      check.fail("%s: field '%s' is an empty list; leave it out for all of them", where, field)
    end
  end
  local cells, outlines = {}, {}
  local whole = { "A1-" .. self.names[#self.names] }
  for i, cell in ipairs(options.cells or whole) do cells[i] = cell_of(self, where, cell) end
  for _, storey in ipairs(storeys_of(self, where, options.storeys)) do
    for _, cell in ipairs(cells) do
      local corners = {}
      for i, line in ipairs(cell) do corners[i] = self.columns_of[line][storey] end
      outlines[#outlines + 1] = corners
    end
  end
  return require "hinge.model.floor"(self.model, others, outlines)
end

-- Members through several nodes, one after the other: nodes or names of places.
function Grid:line(options, ...)
  local where = "grid:line"
  check.no_more(where, ...)
  if type(options) ~= "table" or #options < 2 then
    check.fail("%s: give two or more nodes or names of places", where)
  end
  local nodes, others = {}, {}
  for field, value in pairs(options) do
    if math.type(field) ~= "integer" then others[field] = value end
  end
  for i, place in ipairs(options) do nodes[i] = type(place) == "string" and self:node(place) or place end
  local _, of_members = split(where, {}, others)
  local made = {}
  for i = 2, #nodes do made[#made + 1] = self:add(nodes[i - 1], nodes[i], of_members) end
  return made
end

function Grid:fix(what, storey, ...)
  check.no_more("grid:fix", ...)
  local level = storey == nil and 0
    or check.value("grid:fix", "storey", storey, { "number", whole = true, at_least = 0, at_most = self.storeys })
  for _, line in ipairs(self.names) do self.model:fix(self.columns_of[line][level], what) end
  return self
end

-- Copies --------------------------------------------------------------------------------------------------------------

-- Places to a micrometre; -0 is 0.
local function key(x, y, z)
  return (("%.6f %.6f %.6f"):format(x, y, z):gsub("%-0%.000000", "0.000000"))
end

-- The node at a place: one that there is, or a new one, fixed as `like` is.
local function node_at(self, at, like)
  local place = key(at[1], at[2], at[3])
  local there = self.node_of[place]
  if not there then
    there = self.model:node(at)
    if like and like.fixed then self.model:fix(there, like.fixed) end
    self.node_of[place] = there
  end
  return there
end

-- Where a point goes, and what becomes of a direction.
local function motion(where, o)
  if (o.by and 1 or 0) + (o.mirror and 1 or 0) ~= 1 then
    check.fail("%s: give one of two: by = { x, y, z } in m, or mirror = { x = at }, { y = at } or { z = at }", where)
  end
  if o.by then
    check.value(where, "by", o.by, { "numbers", count = 3, unit = "m" })
    return function(p) return { p[1] + o.by[1], p[2] + o.by[2], p[3] + o.by[3] } end, function(v) return v end
  end
  local axis, at = next(o.mirror)
  local i = ({ x = 1, y = 2, z = 3 })[axis]
  if not i or next(o.mirror, axis) or type(at) ~= "number" then
    check.fail("%s: field 'mirror' must be one of { x = at }, { y = at } and { z = at }, the place of the mirror in m",
      where)
  end
  local function flip(v, about)
    local out = { v[1], v[2], v[3] }
    out[i] = 2 * about - out[i]
    return out
  end
  return function(p) return flip(p, at) end, function(v) return flip(v, 0) end
end

function Grid:copy(options, ...)
  local where = "grid:copy"
  local o, changed = split(where, { members = { "table" }, by = list_rule, mirror = list_rule }, options, ...)
  local move, turn = motion(where, o)
  local made = {}
  for _, member in ipairs(o.members) do
    local given = {}
    for _, field in ipairs(member_options) do
      if field ~= "release" then given[field] = member[field] end -- which is in member.ends
    end
    given.group = member:groups()
    if #given.group == 0 then given.group = nil end
    if given.carries == "both" then given.carries = nil end
    given.up = turn(member.up)
    for field, value in pairs(changed) do given[field] = value end
    for i, node in ipairs { member.a, member.b } do
      given[i] = node_at(self, move { node.x, node.y, node.z }, node)
    end
    made[#made + 1] = self.model:member(given)
  end
  return made
end

-- The grid ------------------------------------------------------------------------------------------------------------

-- Positions along an axis: a list that rises, or { count = , spacing = , from = }.
local function positions(where, field, given, fewest)
  if type(given) ~= "table" then
    check.fail("%s: field '%s' is %s; give positions in m that rise, or { count = spaces, spacing = m }", where, field,
      check.show(given))
  end
  if given.count or given.spacing then
    local o = check.options(("%s: field '%s'"):format(where, field), given, {
      count = { "number", whole = true, at_least = 1 }, spacing = { "number", unit = "m", above = 0 },
      from = { "number", unit = "m", default = 0 } })
    local list = {}
    for i = 0, o.count do list[i + 1] = o.from + i * o.spacing end
    return list
  end
  local list = {}
  for i, value in ipairs(given) do
    check.value(where, ("%s[%d]"):format(field, i), value, { "number", unit = "m" })
    if i > 1 and not (value > list[i - 1]) then
      check.fail("%s: field '%s[%d]' is %s m; positions must rise, and the one before is %s m", where, field, i,
        check.show(value), check.show(list[i - 1]))
    end
    list[i] = value
  end
  if #list < fewest then check.fail("%s: field '%s' needs %d or more positions in m", where, field, fewest) end
  return list
end

return function(options, ...)
  local where = "hinge.grid"
  check.no_more(where, ...)
  if type(options) ~= "table" then check.fail("%s: takes a table of options, got %s", where, check.show(options)) end
  local known = { model = true, x = true, y = true, z = true }
  for field in pairs(options) do
    if not known[field] then check.unknown(where, "field", tostring(field), check.keys(known)) end
  end
  check.model(where, options.model)
  local self = setmetatable({ model = options.model, x = positions(where, "x", options.x, 1),
    y = positions(where, "y", options.y or { 0 }, 1), z = positions(where, "z", options.z, 2), names = {},
    columns_of = {}, name_of = {}, node_of = {}, kept = {} }, class)
  self.storeys = #self.z - 1
  for _, node in ipairs(self.model:nodes()) do self.node_of[key(node.x, node.y, node.z)] = node end
  for i, x in ipairs(self.x) do
    for j, y in ipairs(self.y) do
      local line = letters(i) .. j
      self.names[#self.names + 1], self.columns_of[line] = line, {}
      for level, z in ipairs(self.z) do
        local node = node_at(self, { x, y, z })
        self.columns_of[line][level - 1] = node
        self.name_of[node.index] = place_name(line, level - 1)
      end
    end
  end
  return self
end
