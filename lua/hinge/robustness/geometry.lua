-- The columns of a model as hinge.robustness sees them: vertical members from joint to joint, the bays beside them and
-- the beams in these bays. All are plain numbers, so that they outlive the model they were read from.
local check = require "hinge.library.check"

local geometry = {}

local sine = math.sin(math.rad(15)) -- within 15 degrees: upright is a column, level is a beam
local same_place = 0.3 -- m: columns that are nearer in plan stand above each other; floors that are nearer are one
local straight = 0.999 -- cosine between two parts of one beam

-- Reading ---------------------------------------------------------------------------------------------------------

local function held_upright(fixed)
  if fixed == "all" then return true end
  for part in (fixed or ""):gmatch "[^,]+" do
    if part == "z" then return true end
  end
  return false
end

local function kind_of(dx, dy, dz, length)
  if math.sqrt(dx * dx + dy * dy) <= sine * length then return "column" end
  return math.abs(dz) <= sine * length and "beam" or "other"
end

-- Nodes and members as tables, and the members of each node.
local function read_all(model)
  local geo = { nodes = {}, members = {} }
  for _, n in ipairs(model:nodes()) do
    geo.nodes[n.index] = { index = n.index, x = n.x, y = n.y, z = n.z, held = held_upright(n.fixed), members = {} }
  end
  for _, m in ipairs(model:members()) do
    local a, b = geo.nodes[m.a.index], geo.nodes[m.b.index]
    local dx, dy, dz = b.x - a.x, b.y - a.y, b.z - a.z
    local own = { index = m.index, a = a, b = b, group = m.group, groups = {}, length = m.length,
      kind = kind_of(dx, dy, dz, m.length), along = { dx / m.length, dy / m.length, dz / m.length } }
    for _, g in ipairs(m:groups()) do own.groups[#own.groups + 1] = g.name end
    geo.members[m.index] = own
    table.insert(a.members, own)
    table.insert(b.members, own)
  end
  return geo
end

-- Chains of members -----------------------------------------------------------------------------------------------

-- Whether a node is inside a column: nothing but the column is there.
local function inside_column(node)
  return #node.members == 2 and not node.held and node.members[1].kind == "column" and node.members[2].kind == "column"
end

-- The part of a beam that goes on straight beyond a node where no column is.
local function beam_beyond(node, member)
  local found
  for _, other in ipairs(node.members) do
    if other.kind == "column" then return nil end
    local a, b = member.along, other.along
    local cosine = a[1] * b[1] + a[2] * b[2] + a[3] * b[3]
    if other ~= member and other.kind == "beam" and math.abs(cosine) > straight then found = other end
  end
  return found
end

local function column_beyond(node, member)
  if not inside_column(node) then return nil end
  return node.members[node.members[1] == member and 2 or 1]
end

-- The members of the chain that a member belongs to, and its two end nodes.
local function chain_of(member, beyond)
  local list, ends, seen = { member }, {}, { [member] = true }
  for side, start in ipairs { member.a, member.b } do
    local node, last = start, member
    while true do
      local more = beyond(node, last)
      if not more or seen[more] then break end
      seen[more] = true
      list[#list + 1], last = more, more
      node = more.a == node and more.b or more.a
    end
    ends[side] = node
  end
  return list, ends[1], ends[2]
end

local function metres(value) return (("%.4g"):format(math.abs(value) < 5e-5 and 0 or value)) end

local function place_name(x, y, low, high)
  local heights = high - low < 1e-6 and metres(low) or metres(low) .. " to " .. metres(high)
  return ("x = %s m, y = %s m, z = %s m"):format(metres(x), metres(y), heights)
end

local function new_column(list, low, high)
  if low.z > high.z then low, high = high, low end
  table.sort(list, function(a, b) return a.index < b.index end)
  local indices = {}
  for i, m in ipairs(list) do indices[i] = m.index end
  return { members = indices, low = low, high = high, x = high.x, y = high.y, group = list[1].group,
    name = place_name(high.x, high.y, low.z, high.z) }
end

-- Each column knows how many stand below it.
local function number_storeys(columns)
  local by_top, storeys = {}, 0
  for _, c in ipairs(columns) do by_top[c.high] = c end
  table.sort(columns, function(a, b)
    if a.low.z ~= b.low.z then return a.low.z < b.low.z end
    if a.x ~= b.x then return a.x < b.x end
    return a.y < b.y or a.y == b.y and a.members[1] < b.members[1]
  end)
  for _, c in ipairs(columns) do
    local below = by_top[c.low]
    c.storey = below and below.storey + 1 or 1
    storeys = math.max(storeys, c.storey)
  end
  return storeys
end

--- Nodes, members, columns and the number of storeys (of the tallest stack of columns) of a model.
function geometry.read(model)
  local geo = read_all(model)
  geo.columns, geo.beam_length = {}, {}
  local done = {}
  for _, m in ipairs(geo.members) do
    if not done[m] and m.kind ~= "other" then
      local list, first, last = chain_of(m, m.kind == "column" and column_beyond or beam_beyond)
      local length = 0
      for _, part in ipairs(list) do done[part], length = true, length + part.length end
      for _, part in ipairs(list) do geo.beam_length[part.index] = length end
      if m.kind == "column" then geo.columns[#geo.columns + 1] = new_column(list, first, last) end
    end
  end
  geo.storeys = number_storeys(geo.columns)
  return geo
end

-- Cases -----------------------------------------------------------------------------------------------------------

-- The joints that a case leaves without support: those of the removed members that keep another member.
local function joints_of(geo, removed)
  local joints, seen = {}, {}
  for index in pairs(removed) do
    for _, node in ipairs { geo.members[index].a, geo.members[index].b } do
      local keeps = false
      for _, m in ipairs(node.members) do keeps = keeps or not removed[m.index] end
      if keeps and not node.held and not seen[node] then
        seen[node] = true
        joints[#joints + 1] = node
      end
    end
  end
  table.sort(joints, function(a, b) return a.z > b.z or a.z == b.z and a.index < b.index end)
  return joints
end

local function apart(a, b) return math.sqrt((a.x - b.x) ^ 2 + (a.y - b.y) ^ 2) end

-- The place of a column, which may lean, at a height.
local function place_at(c, z)
  local t = math.max(0, math.min(1, (z - c.low.z) / (c.high.z - c.low.z)))
  return { x = c.low.x + t * (c.high.x - c.low.x), y = c.low.y + t * (c.high.y - c.low.y) }
end

-- Where the other columns that reach the level of a joint are at this level.
local function columns_at(geo, removed, joint)
  local list = {}
  for _, c in ipairs(geo.columns) do
    local place = place_at(c, joint.z)
    if not removed[c.members[1]] and c.low.z < joint.z + same_place and c.high.z > joint.z - same_place
      and apart(place, joint) > same_place then list[#list + 1] = place end
  end
  return list
end

-- The bays at a joint: from the next column on its line to the next, or as far as the structure goes.
local function bays_at(geo, removed, joint)
  local bay = { x = { -math.huge, math.huge }, y = { -math.huge, math.huge }, z = joint.z - same_place }
  for _, c in ipairs(columns_at(geo, removed, joint)) do
    for axis, across in pairs { x = "y", y = "x" } do
      local d = c[axis] - joint[axis]
      if math.abs(c[across] - joint[across]) <= same_place then
        local side = d < 0 and 1 or 2
        if math.abs(bay[axis][side] - joint[axis]) > math.abs(d) then bay[axis][side] = c[axis] end
      end
    end
  end
  return bay
end

--- Whether a point is in the bays next to the removal, at its level or above.
function geometry.is_near(case, x, y, z)
  for _, bay in ipairs(case.bays) do
    if z >= bay.z and x >= bay.x[1] - 1e-6 and x <= bay.x[2] + 1e-6 and y >= bay.y[1] - 1e-6
      and y <= bay.y[2] + 1e-6 then return true end
  end
  return false
end

-- Whether a joint is the upper end of a removed member (or an end of a level one): the bays above it are affected.
local function is_upper(joint, removed)
  for _, m in ipairs(joint.members) do
    local other = m.a == joint and m.b or m.a
    if removed[m.index] and other.z <= joint.z + 1e-6 then return true end
  end
  return false
end

-- Adds to a case what follows from its members: joints, bays, span, and its place.
local function complete(geo, case)
  local removed = {}
  for _, index in ipairs(case.members) do removed[index] = true end
  case.removed, case.joints, case.bays = removed, joints_of(geo, removed), {}
  local low, high = math.huge, -math.huge
  for index in pairs(removed) do
    local m = geo.members[index]
    low, high = math.min(low, m.a.z, m.b.z), math.max(high, m.a.z, m.b.z)
  end
  local top = case.joints[1] or geo.members[case.members[1]].b
  case.x, case.y, case.z_low, case.z_high = top.x, top.y, low, high
  case.place = place_name(top.x, top.y, low, high)
  case.name = case.name or case.place
  for _, joint in ipairs(case.joints) do
    if is_upper(joint, removed) then case.bays[#case.bays + 1] = bays_at(geo, removed, joint) end
    for _, c in ipairs(columns_at(geo, removed, joint)) do
      case.span = math.min(case.span or math.huge, apart(c, joint))
    end
  end
  return case
end

-- Adds the members that an item of `remove` means, and returns its name.
local function add_members(where, geo, item, into)
  local index, name = math.tointeger(item), type(item) == "string" and item or nil
  local kind = check.kind_of(item)
  if kind == "member" then index = item.index elseif kind == "group" then name = item.name end
  if index then
    if not geo.members[index] then
      check.fail("%s: field 'remove' has member %s; the model that build returned has %s", where, index,
        check.count(#geo.members, "member"))
    end
    into[index] = true
    return "member " .. index
  end
  if not name then
    check.fail("%s: field 'remove' has %s; must be 'columns' or a list of groups (names) and members (numbers), of "
      .. "which each may be a list of those that go together", where, check.show(item))
  end
  local names, any = {}, false
  for _, m in ipairs(geo.members) do
    for _, g in ipairs(m.groups) do
      names[g] = true
      if g == name then into[m.index], any = true, true end
    end
  end
  if not any then check.unknown(where .. ": field 'remove'", "group", name, check.keys(names)) end
  return name
end

local function case_of_item(where, geo, item)
  local into, names, members = {}, {}, {}
  local list = type(item) == "table" and item or { item }
  if #list == 0 then check.fail("%s: field 'remove' has an empty list; give groups or members in it", where) end
  for i, part in ipairs(list) do names[i] = add_members(where, geo, part, into) end
  for index in pairs(into) do members[#members + 1] = index end
  table.sort(members)
  local case = complete(geo, { members = members, group = geo.members[members[1]].group })
  case.name = ("%s (%s)"):format(table.concat(names, " and "), case.place)
  return case
end

local function columns_of(where, geo, storeys)
  local cases, lowest = {}, math.huge
  for _, c in ipairs(geo.columns) do lowest = math.min(lowest, c.low.z) end
  for _, c in ipairs(geo.columns) do
    if storeys == "all" or c.low.held or c.low.z < lowest + 1e-3 then
      cases[#cases + 1] = complete(geo, { members = c.members, group = c.group, name = c.name, storey = c.storey })
    end
  end
  if #cases == 0 then
    check.fail("%s: the model that build returned has no column, which is a member within 15 degrees of the vertical "
      .. "(z); name groups or members in field 'remove'", where)
  end
  return cases
end

--- The cases of a study: what goes in each of them.
function geometry.cases(where, geo, remove, storeys)
  if remove == "columns" then return columns_of(where, geo, storeys) end
  if type(remove) == "string" then
    check.fail("%s: field 'remove' is '%s'; must be 'columns' or a list of groups and members, such as { '%s' }",
      where, remove, remove)
  end
  if type(remove) ~= "table" or #remove == 0 then
    check.fail("%s: field 'remove' is %s; must be 'columns' or a list of groups and members", where,
      check.show(remove))
  end
  local cases = {}
  for i, item in ipairs(remove) do cases[i] = case_of_item(where, geo, item) end
  return cases
end

--- Raises an error where a model that was made later is not the same structure.
function geometry.must_be_same(where, geo, model)
  local members = model:members()
  local differs = #members ~= #geo.members
  for i, m in ipairs(members) do
    if differs then break end
    local own = geo.members[i]
    for _, ends in ipairs { { m.a, own.a }, { m.b, own.b } } do
      for _, axis in ipairs { "x", "y", "z" } do
        differs = differs or math.abs(ends[1][axis] - ends[2][axis]) > 1e-6
      end
    end
  end
  if differs then
    check.fail("%s: build returned another structure than at its first call (%s, then %s); nodes and members must be "
      .. "the same each time, loads may differ", where, check.count(#geo.members, "member"),
      check.count(#members, "member"))
  end
end

return geometry
