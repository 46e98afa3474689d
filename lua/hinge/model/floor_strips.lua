-- What members carry of floors: their planes, the panels in them (panels.lua), and of each member the strips of the
-- panels beside it (tributary.lua).
local check = require "hinge.library.check"
local panels = require "hinge.model.panels"
local tributary = require "hinge.model.tributary"
local vectors = require "hinge.library.vectors"

local strips = {}
local where = "model:floor"
local near = 1e-6 -- of the size of the floor: places that differ by less are the same
local tiny = 1e-12 -- of a length: rounding
local exact = 1e-9 -- of the area: what the sum over the members may be off

local dot, cross, minus, unit = vectors.dot, vectors.cross, vectors.minus, vectors.unit
local of_node = vectors.of_node

-- Planes --------------------------------------------------------------------------------------------------------------
-- A plane is { at = a point, axes = { u, v } (unit vectors), slack = (m), outline = (corners in it) or nil }.

local function flat(plane, point)
  local r = minus(point, plane.at)
  return { dot(r, plane.axes[1]), dot(r, plane.axes[2]) }
end

local function in_space(plane, p)
  return vectors.plus(vectors.plus(plane.at, p[1], plane.axes[1]), p[2], plane.axes[2])
end

local function place_text(plane, p)
  local at = in_space(plane, p)
  for i = 1, 3 do at[i] = math.abs(at[i]) < plane.slack and 0 or at[i] end
  return ("{%.6g, %.6g, %.6g} m"):format(at[1], at[2], at[3])
end

local function is_in(plane, point, normal)
  return math.abs(dot(minus(point, plane.at), normal)) <= plane.slack
end

--- Points in space, of a field, as places in a plane.
function strips.flat_polygon(plane, field, points)
  local polygon, normal = {}, cross(plane.axes[1], plane.axes[2])
  for i, point in ipairs(points) do
    if not is_in(plane, point, normal) then
      check.fail("%s: field '%s[%d]' is %s m, which is %.3g m off the plane of the floor", where, field, i,
        check.show(point), math.abs(dot(minus(point, plane.at), normal)))
    end
    polygon[i] = flat(plane, point)
  end
  local i, j = tributary.crossing(polygon)
  if i then
    local n = #polygon
    check.fail("%s: field '%s': the edges from point %d to %d and from point %d to %d cross; give the points in their "
      .. "order around", where, field, i, i % n + 1, j, j % n + 1)
  end
  return polygon
end

--- The plane of the corners of a floor, with their outline.
function strips.plane_of(points)
  local normal, size = { 0, 0, 0 }, 0
  for i = 2, #points - 1 do
    normal = vectors.plus(normal, 1, cross(minus(points[i], points[1]), minus(points[i + 1], points[1])))
  end
  for _, p in ipairs(points) do size = math.max(size, vectors.length(minus(p, points[1]))) end
  local n, twice = unit(normal)
  if not (twice > near * size * size) then
    check.fail("%s: the points of field 'corners' enclose no area: they lie in one line, or are not in their order "
      .. "around the floor", where)
  end
  local u = unit(minus(points[2], points[1]))
  local plane = { at = points[1], axes = { u, cross(n, u) }, slack = near * size }
  plane.outline = strips.flat_polygon(plane, "corners", points)
  return plane
end

--- The horizontal planes in which members lie, from below.
function strips.levels_of(members)
  local low, high, places = { math.huge, math.huge, math.huge }, { -math.huge, -math.huge, -math.huge }, {}
  for _, member in ipairs(members) do
    for _, node in ipairs { member.a, member.b } do
      for i, x in ipairs(of_node(node)) do low[i], high[i] = math.min(low[i], x), math.max(high[i], x) end
    end
  end
  local slack = near * math.max(high[1] - low[1], high[2] - low[2], high[3] - low[3])
  for _, member in ipairs(members) do
    if math.abs(member.a.z - member.b.z) <= slack then places[#places + 1] = (member.a.z + member.b.z) / 2 end
  end
  table.sort(places)
  local list = {}
  for _, z in ipairs(places) do
    if #list == 0 or z > list[#list].at[3] + slack then
      list[#list + 1] = { at = { low[1], low[2], z }, axes = { { 1, 0, 0 }, { 0, 1, 0 } }, slack = slack }
    end
  end
  return list
end

-- Panels --------------------------------------------------------------------------------------------------------------

-- The members in a plane, with the places of their ends; of those in an outline alone.
local function edges_in(plane, members)
  local edges, normal = {}, cross(plane.axes[1], plane.axes[2])
  for _, member in ipairs(members) do
    local a, b = of_node(member.a), of_node(member.b)
    if is_in(plane, a, normal) and is_in(plane, b, normal) then
      edges[#edges + 1] = { member = member, a = flat(plane, a), b = flat(plane, b) }
    end
  end
  return edges
end

-- The middle of mass of a panel.
local function middle_of(corners)
  local sum, x, y, o = 0, 0, 0, corners[1]
  for i = 2, #corners - 1 do
    local a = tributary.area { o, corners[i], corners[i + 1] }
    sum = sum + a
    x = x + a * (o[1] + corners[i][1] + corners[i + 1][1]) / 3
    y = y + a * (o[2] + corners[i][2] + corners[i + 1][2]) / 3
  end
  return { x / sum, y / sum }
end

-- The first side of the outline that no members cover, as the places where it begins and ends; nil where all are.
local function open_side(plane, edges)
  local n = #plane.outline
  for i = 1, n do
    local p, q = plane.outline[i], plane.outline[i % n + 1]
    local along = { q[1] - p[1], q[2] - p[2] }
    local length = math.sqrt(along[1] ^ 2 + along[2] ^ 2)
    local covered = 0
    local function place(r) -- along the side, and off it, m
      local x, y = r[1] - p[1], r[2] - p[2]
      return (x * along[1] + y * along[2]) / length, math.abs(x * along[2] - y * along[1]) / length
    end
    for _, edge in ipairs(edges) do
      local a, off_a = place(edge.a)
      local b, off_b = place(edge.b)
      if off_a <= plane.slack and off_b <= plane.slack then
        covered = covered + math.max(0, math.min(length, math.max(a, b)) - math.max(0, math.min(a, b)))
      end
    end
    if covered < length - 2 * plane.slack then return p, q end
  end
end

local function refuse_open_outline(plane, edges)
  local p, q = open_side(plane, edges)
  if p then
    check.fail("%s: no members lie along the whole edge of the floor from %s to %s; a floor lies on members along all "
      .. "of its edges", where, place_text(plane, p), place_text(plane, q))
  end
end

-- Members that end in the open inside a panel carry nothing of it: most likely they are not joined.
local function refuse_idle(plane, edges, out, kept)
  for _, edge in ipairs(edges) do
    local a, b = edge.member.a.index, edge.member.b.index
    local is_edge = false
    for _, next_to_a in ipairs(out[a] or {}) do is_edge = is_edge or next_to_a.to == b end
    local middle = { (edge.a[1] + edge.b[1]) / 2, (edge.a[2] + edge.b[2]) / 2 }
    for _, panel in ipairs(is_edge and {} or kept) do
      if panels.contains(panel.corners, middle) then
        check.fail("%s: member %d, from %s to %s, ends in the open inside a panel and carries nothing; join it to the "
          .. "members around the panel, divided there, or leave it out of 'members'", where, edge.member.index,
          place_text(plane, edge.a), place_text(plane, edge.b))
      end
    end
  end
end

-- Whether a panel lies in the outline. That a part of it does is an error: no member divides it along the outline.
local function lies_in(plane, panel)
  if not plane.outline then return true end
  local part = tributary.overlap(panel.corners, plane.outline)
  if part >= (1 - near) * panel.area then return true end
  if part > near * panel.area and panels.contains(plane.outline, middle_of(panel.corners)) then
    check.fail("%s: the panel at %s lies partly outside of the floor; a member must divide it along the edge of the "
      .. "floor", where, place_text(plane, middle_of(panel.corners)))
  end
  return false
end

-- The panels in a plane.
local function panels_of(plane, members)
  local edges = edges_in(plane, members)
  if plane.outline then refuse_open_outline(plane, edges) end
  local list, at, out = panels.find(where, edges)
  local kept, area = {}, 0
  for _, panel in ipairs(list) do
    panel.plane = plane
    if lies_in(plane, panel) then
      kept[#kept + 1] = panel
      area = area + panel.area
      local own = {}
      for _, node in ipairs(panel.nodes) do own[node] = true end
      for node in pairs(out) do
        if not own[node] and panels.contains(panel.corners, at[node]) then
          check.fail("%s: node %d, at %s, lies inside a panel, and members at it do not reach the panel's edges; join "
            .. "them to it, or leave them out of 'members'", where, node, place_text(plane, at[node]))
        end
      end
    end
  end
  refuse_idle(plane, edges, out, kept)
  if plane.outline then
    local whole = math.abs(tributary.area(plane.outline))
    if math.abs(area - whole) > near * whole then
      check.fail("%s: members close %.6g m^2 of the %.6g m^2 between the corners; a floor lies on members along all of "
        .. "its edges", where, area, whole)
    end
  end
  return kept
end

-- "one way": across the shorter sides of a panel with four.
local function shorter_way(panel, sides)
  if #sides ~= 4 then
    check.fail("%s: the panel at %s has %d sides; give 'span' as the direction in which it spans, { x, y, z }", where,
      place_text(panel.plane, middle_of(panel.corners)), #sides)
  end
  local one, two = sides[1].length + sides[3].length, sides[2].length + sides[4].length
  if math.abs(one - two) <= near * one then
    check.fail("%s: the panel at %s is as long as it is wide; give 'span' as the direction in which it spans, "
      .. "{ x, y, z }", where, place_text(panel.plane, middle_of(panel.corners)))
  end
  return sides[one < two and 1 or 2].along
end

-- The direction of span in the plane, nil for two ways.
local function span_of(span, panel, sides)
  if span == "two way" then return nil end
  if span == "one way" then return shorter_way(panel, sides) end
  local u = flat({ at = { 0, 0, 0 }, axes = panel.plane.axes }, span)
  local size = math.sqrt(u[1] ^ 2 + u[2] ^ 2)
  if size < 1 - near then
    check.fail("%s: field 'span' is not a direction in the plane of the floor, which slopes; give one along it, such "
      .. "as from one corner to another", where)
  end
  return { u[1] / size, u[2] / size }
end

-- What members carry --------------------------------------------------------------------------------------------------
-- A strip is { from =, to = (parts of the member's length), a =, b = (width that is carried there, m) }.

-- Adds the strips of one side to those of its members.
local function add_side(side, stretches, of_member)
  for _, piece in ipairs(side.pieces) do
    local length = piece.to - piece.from
    local scale = length / piece.member.length -- above 1 between offsets
    local list = of_member[piece.member.index] or { member = piece.member }
    of_member[piece.member.index] = list
    for _, s in ipairs(stretches) do
      local from, to = math.max(s.from, piece.from), math.min(s.to, piece.to)
      if to - from > tiny * length then
        local function width(at) return scale * (s.a + (at - s.from) / (s.to - s.from) * (s.b - s.a)) end
        local first, last = (from - piece.from) / length, (to - piece.from) / length
        if first < tiny then first = 0 end
        if last > 1 - tiny then last = 1 end
        local strip = { from = first, to = last, a = width(from), b = width(to) }
        if piece.turned then strip = { from = 1 - last, to = 1 - first, a = strip.b, b = strip.a } end
        list[#list + 1] = strip
      end
    end
  end
end

-- The strips of a member without overlap, joined where they go on straight.
local function joined(parts)
  local places, list = { 0, 1 }, {}
  for _, s in ipairs(parts) do places[#places + 1], places[#places + 2] = s.from, s.to end
  table.sort(places)
  local from = 0
  for _, to in ipairs(places) do
    if to - from > tiny then
      local a, b, middle = 0, 0, (from + to) / 2
      for _, s in ipairs(parts) do
        if s.from < middle and s.to > middle then
          local slope = (s.b - s.a) / (s.to - s.from)
          a, b = a + s.a + (from - s.from) * slope, b + s.a + (to - s.from) * slope
        end
      end
      a, b = math.max(0, a), math.max(0, b) -- but for rounding
      local last = list[#list]
      local size = near * math.max(a, b)
      if last and math.abs(last.b - a) <= size
        and math.abs((last.b - last.a) / (last.to - last.from) - (b - a) / (to - from)) <= size then
        last.to, last.b = to, b
      elseif math.max(a, b) > 0 then
        list[#list + 1] = { from = from, to = to, a = a, b = b }
      end
      from = to
    end
  end
  return list
end

local function add_panel(asked, panel, of_member)
  local sides, inward = panels.sides(panel, near)
  if inward then
    check.fail("%s: the panel at %s has a corner that points inward, at %s; put a member there that divides it", where,
      place_text(panel.plane, middle_of(panel.corners)), place_text(panel.plane, inward))
  end
  panel.corners, panel.nodes, panel.around, panel.sides = {}, {}, panel.members, sides
  for i, side in ipairs(sides) do panel.corners[i], panel.nodes[i] = side.from, side.node end
  local span, openings, open = span_of(asked, panel, sides), {}, 0
  for _, opening in ipairs(panel.plane.openings) do
    local area = tributary.area_inside(opening, panel.corners)
    if area > 0 then openings[#openings + 1], open = opening, open + area end
  end
  local lists = tributary.stretches(panel.corners, sides, openings, span, tiny / near * panel.plane.slack)
  for i, side in ipairs(sides) do add_side(side, lists[i], of_member) end
  panel.area, panel.open = panel.area - open, open
  return panel
end

local function refuse_lost_openings(planes, open)
  local cut = 0
  for _, plane in ipairs(planes) do
    for _, opening in ipairs(plane.openings) do cut = cut + math.abs(tributary.area(opening)) end
  end
  if math.abs(cut - open) > near * cut then
    check.fail("%s: %.6g of the %.6g m^2 of openings lie in the floor; they must lie in it whole", where,
      open, cut)
  end
end

--- Of floors in these planes, each with its `openings`, on these members: the panels as { nodes = (indices), around =
--- (members), area = }, and the members that carry them in the order of their indices, as { member =, strips... }.
--- members: as of a model, or tables with index, length, a and b, and of these index, x, y, z. span: as in model:floor.
function strips.of(planes, members, span)
  local list, of_member, order, area, open, carried = {}, {}, {}, 0, 0, 0
  local seen = {}
  for _, plane in ipairs(planes) do
    for _, panel in ipairs(panels_of(plane, members)) do
      local nodes = table.move(panel.nodes, 1, #panel.nodes, 1, {})
      table.sort(nodes)
      local key = table.concat(nodes, " ")
      if seen[key] then
        check.fail("%s: the panel at %s is in two of the floors, which lie on each other", where,
          place_text(plane, middle_of(panel.corners)))
      end
      seen[key] = true
      list[#list + 1] = add_panel(span, panel, of_member)
      area, open = area + panel.area, open + panel.open
    end
  end
  if #list == 0 then
    check.fail("%s: the members close no panel in a horizontal plane; a floor lies on members along all of its edges, "
      .. "joined at their nodes, and one that slopes needs 'corners'", where)
  end
  for index in pairs(of_member) do order[#order + 1] = index end
  table.sort(order)
  for i, index in ipairs(order) do
    local member = of_member[index].member
    order[i] = joined(of_member[index])
    order[i].member = member
    for _, s in ipairs(order[i]) do carried = carried + (s.a + s.b) / 2 * (s.to - s.from) * member.length end
  end
  refuse_lost_openings(planes, open)
  if not (math.abs(carried - area) <= exact * area) then
    check.fail("%s: the members carry %.12g m^2 of the %.12g m^2 of the panels; divide openings that overlap, or that "
      .. "have corners which point inward", where, carried, area)
  end
  return list, order
end

return strips
