-- The panels that members close in a plane: faces of the plane graph whose edges are the members.
local check = require "hinge.library.check"
local tributary = require "hinge.model.tributary"

local panels = {}

local function cross(a, b) return a[1] * b[2] - a[2] * b[1] end
local function minus(a, b) return { a[1] - b[1], a[2] - b[2] } end

-- The graph: at = place of each node by its index, out = members at each node as { to =, member = }.
local function graph_of(where, edges)
  local at, out, between = {}, {}, {}
  for _, edge in ipairs(edges) do
    local ends = { edge.member.a.index, edge.member.b.index }
    local key = ("%d %d"):format(math.min(ends[1], ends[2]), math.max(ends[1], ends[2]))
    if between[key] then
      check.fail("%s: members %d and %d lie between the same nodes; leave one of them out of 'members'", where,
        between[key].index, edge.member.index)
    end
    between[key] = edge.member
    at[ends[1]], at[ends[2]] = edge.a, edge.b
    for i = 1, 2 do
      local list = out[ends[i]] or {}
      out[ends[i]] = list
      list[#list + 1] = { from = ends[i], to = ends[3 - i], member = edge.member }
    end
  end
  return at, out
end

-- Takes away members that end in the open, until there is none: they close nothing.
local function prune(out)
  local open = {}
  for node, list in pairs(out) do
    if #list == 1 then open[#open + 1] = node end
  end
  while #open > 0 do
    local node = table.remove(open)
    local list = out[node]
    if list and #list == 1 then
      local other = out[list[1].to]
      for i = #other, 1, -1 do
        if other[i].to == node then table.remove(other, i) end
      end
      if #other == 1 then open[#open + 1] = list[1].to end
    end
    out[node] = nil
  end
  for node, list in pairs(out) do
    if #list == 0 then out[node] = nil end
  end
end

-- Members that cross without a node would close panels that are none.
local function refuse_crossings(where, at, list)
  table.sort(list, function(p, q) return p.low < q.low end)
  for i, p in ipairs(list) do
    for j = i + 1, #list do
      local q = list[j]
      if q.low >= p.high then break end
      local a, b, c, d = at[p.from], at[p.to], at[q.from], at[q.to]
      local shared = p.from == q.from or p.from == q.to or p.to == q.from or p.to == q.to
      if not shared and math.max(a[2], b[2]) > math.min(c[2], d[2]) and math.min(a[2], b[2]) < math.max(c[2], d[2])
        and cross(minus(b, a), minus(c, a)) * cross(minus(b, a), minus(d, a)) < 0
        and cross(minus(d, c), minus(a, c)) * cross(minus(d, c), minus(b, c)) < 0 then
        check.fail("%s: members %d and %d cross without a common node; join them there, or leave one of them out of "
          .. "'members'", where, p.member.index, q.member.index)
      end
    end
  end
end

local function sorted_keys(map)
  local keys = {}
  for key in pairs(map) do keys[#keys + 1] = key end
  table.sort(keys)
  return keys
end

-- Sorts the members at each node by their direction, to the left.
local function sort_around(at, out)
  local edges = {}
  for _, node in ipairs(sorted_keys(out)) do
    local list = out[node]
    for _, edge in ipairs(list) do
      local r = minus(at[edge.to], at[node])
      edge.angle = math.atan(r[2], r[1])
    end
    table.sort(list, function(p, q) return p.angle < q.angle end)
    for i, edge in ipairs(list) do
      edge.place = i
      if edge.to > edge.from then
        local x, y = at[edge.from][1], at[edge.to][1]
        edges[#edges + 1] = { from = edge.from, to = edge.to, member = edge.member, low = math.min(x, y),
          high = math.max(x, y) }
      end
    end
  end
  return edges
end

-- The edge after `edge` around the panel on its left.
local function next_edge(out, edge)
  local list = out[edge.to]
  for i, back in ipairs(list) do
    if back.to == edge.from then return list[(i - 2) % #list + 1] end
  end
end

--- The closed panels as { corners = { {x, y}, ... } that turn to the left, nodes = (their indices), members = (the one
--- after each corner) }. edges: { member =, a =, b = (places of its ends in the plane) }.
function panels.find(where, edges)
  local at, out = graph_of(where, edges)
  prune(out)
  refuse_crossings(where, at, sort_around(at, out))
  local list, done = {}, {}
  for _, node in ipairs(sorted_keys(out)) do
    for _, first in ipairs(out[node]) do
      if not done[first] then
        local panel, edge = { corners = {}, nodes = {}, members = {} }, first
        repeat
          done[edge] = true
          table.insert(panel.corners, at[edge.from])
          table.insert(panel.nodes, edge.from)
          table.insert(panel.members, edge.member)
          edge = next_edge(out, edge)
        until edge == first
        panel.area = tributary.area(panel.corners)
        if panel.area > 0 then list[#list + 1] = panel end
      end
    end
  end
  return list, at, out
end

--- Whether a point lies inside of a polygon.
function panels.contains(polygon, p)
  local is_in, n = false, #polygon
  for i = 1, n do
    local a, b = polygon[i], polygon[i % n + 1]
    if (a[2] > p[2]) ~= (b[2] > p[2]) and p[1] < a[1] + (p[2] - a[2]) / (b[2] - a[2]) * (b[1] - a[1]) then
      is_in = not is_in
    end
  end
  return is_in
end

--- The straight sides of a panel as { from =, to =, node = (index, at from), along = (unit vector), length =, pieces =
--- { { member =, from =, to = (m along the side), turned = whether it runs the other way } } }, and its corner that
--- points inward, or nil.
function panels.sides(panel, slack)
  local n, sides, inward = #panel.corners, {}, nil
  local function direction(i)
    local r = minus(panel.corners[i % n + 1], panel.corners[i])
    local size = math.sqrt(r[1] ^ 2 + r[2] ^ 2)
    return { r[1] / size, r[2] / size }, size
  end
  local first = 1
  for i = 1, n do -- begins at a corner
    if math.abs(cross((direction((i - 2) % n + 1)), (direction(i)))) > slack then
      first = i
      break
    end
  end
  for k = 0, n - 1 do
    local i = (first + k - 1) % n + 1
    local along, size = direction(i)
    local last = sides[#sides]
    local turn = last and cross(last.along, along) or 1
    if turn < -slack then inward = panel.corners[i] end
    if not last or math.abs(turn) > slack then
      last = { from = panel.corners[i], node = panel.nodes[i], along = along, length = 0, pieces = {} }
      sides[#sides + 1] = last
    end
    local member = panel.members[i]
    table.insert(last.pieces, { member = member, from = last.length, to = last.length + size,
      turned = member.a.index ~= panel.nodes[i] })
    last.length, last.to = last.length + size, panel.corners[i % n + 1]
  end
  if #sides > 1 and cross(sides[#sides].along, sides[1].along) < -slack then inward = sides[1].from end
  return sides, inward
end

return panels
