-- hinge.pressure: loads on members from a pressure on a rectangular area between them, or on a face by the width that
-- each member carries.
--
-- Tributary areas, as in textbooks of structural design. One way: each strip of a slab or of a cladding spans between
-- two neighbouring beams and gives half of its load to each. Two way: lines at 45 degrees from the corners divide the
-- area, and each point of it belongs to the nearest edge. A linear load over a whole member is one load `q`. Other
-- loads are point loads at Gauss points, three for each piece: with them the end forces and the total of a load that is
-- linear along the piece are exact.
local check = require "hinge.library.check"
local vectors = require "hinge.library.vectors"
local faces = require "hinge.actions.faces"
local chosen = require "hinge.model.chosen_members"

local where = "hinge.pressure"
local near = 1e-6 -- of the longer side of the area: places that differ by less are the same
local exact = 1e-12 -- of the total force
local pieces = 8 -- of a member that has point loads
local gauss = { { 0.5 - math.sqrt(0.15), 5 / 18 }, { 0.5, 8 / 18 }, { 0.5 + math.sqrt(0.15), 5 / 18 } } -- on 0 to 1

local dot, cross, minus, times, size_of = vectors.dot, vectors.cross, vectors.minus, vectors.times, vectors.length
local along = vectors.plus
local place_of = vectors.of_node

-- The value -----------------------------------------------------------------------------------------------------------

local function pressure_at(o, point)
  if type(o.value) == "number" then return o.value end
  local p = o.value(point[1], point[2], point[3])
  if type(p) ~= "number" or p ~= p or math.abs(p) == math.huge then
    check.fail("%s: the function in field 'value' returned %s at {%g, %g, %g} m; it must return a pressure in Pa",
      where, check.show(p), point[1], point[2], point[3])
  end
  return p
end

-- Loads of one member -------------------------------------------------------------------------------------------------
-- A stretch is a part of a member, { member =, from =, to = (0 to 1), length = (m), q = function(part of the stretch),
-- linear = whether q is linear along it, area = }. q is in N/m.

-- Loads as model:load takes them, and their sum in N.
local function loads_of(o, stretch)
  local member, whole = stretch.member, stretch.from == 0 and stretch.to == 1
  local function load(fields)
    fields.member, fields.history, fields.case = member, o.history, o.case
    return fields
  end
  if whole and stretch.linear then
    local scale = stretch.length / member.length -- 1, but for rounding
    local a, b = stretch.q(0) * scale, stretch.q(1) * scale
    if a == 0 and b == 0 then return {}, 0 end
    local q = a == b and times(a, o.direction) or { a = times(a, o.direction), b = times(b, o.direction) }
    return { load { q = q } }, (a + b) / 2 * member.length
  end
  local list, sum = {}, 0
  local n = math.max(1, math.ceil(pieces * (stretch.to - stretch.from) - 1e-9))
  for i = 1, n do
    for _, point in ipairs(gauss) do
      local part = (i - 1 + point[1]) / n
      local force = stretch.q(part) * point[2] * stretch.length / n
      sum = sum + force
      if force ~= 0 then
        list[#list + 1] = load { at = stretch.from + part * (stretch.to - stretch.from),
          force = times(force, o.direction) }
      end
    end
  end
  return list, sum
end

-- The area ------------------------------------------------------------------------------------------------------------

-- The rectangle as { at = its first corner, axes = { u, v } (unit vectors), sides = { length along u, along v },
-- normal =, slack = }.
local function rectangle(corners)
  if #corners ~= 4 then
    check.fail("%s: field 'on' has %d corner points; must have the 4 corners of a rectangle in their order, or be the "
      .. "direction out of a face; divide another area into rectangles", where, #corners)
  end
  for i, corner in ipairs(corners) do
    check.value(where, ("on[%d]"):format(i), corner, { "numbers", count = 3, unit = "m" })
  end
  local u, v = minus(corners[2], corners[1]), minus(corners[4], corners[1])
  local a, b = size_of(u), size_of(v)
  local slack = near * math.max(a, b)
  local misses = size_of(minus(corners[3], along(along(corners[1], 1, u), 1, v)))
  if a <= slack or b <= slack or misses > slack or math.abs(dot(u, v)) > near * a * b then
    check.fail("%s: the four points of field 'on' are not the corners of a rectangle, in their order; divide another "
      .. "area into rectangles", where)
  end
  u, v = times(1 / a, u), times(1 / b, v)
  return { at = corners[1], axes = { u, v }, sides = { a, b }, normal = cross(u, v), slack = slack }
end

-- What a member has of the area: { member =, axis = 1 or 2 (it is parallel to), offset = across, from =, to = along
-- that axis (m), a =, b = where its ends are }, or nil if it is elsewhere.
local function piece_of(area, member)
  local ends = {}
  for i, node in ipairs { member.a, member.b } do
    local r = minus(place_of(node), area.at)
    if math.abs(dot(r, area.normal)) > area.slack then return nil end
    ends[i] = { dot(r, area.axes[1]), dot(r, area.axes[2]) }
  end
  local a, b, slack = ends[1], ends[2], area.slack
  for k = 1, 2 do -- outside, or along the outside of an edge
    if math.max(a[k], b[k]) < -slack or math.min(a[k], b[k]) > area.sides[k] + slack then return nil end
  end
  for axis = 1, 2 do
    local across = 3 - axis
    if math.abs(a[across] - b[across]) <= slack then
      local from = math.max(0, math.min(a[axis], b[axis]))
      local to = math.min(area.sides[axis], math.max(a[axis], b[axis]))
      return to - from > slack and { member = member, axis = axis, offset = (a[across] + b[across]) / 2, from = from,
        to = to, a = a[axis], b = b[axis] } or nil
    end
  end
  for k = 1, 2 do -- it touches an edge or a corner from outside
    if math.max(a[k], b[k]) <= slack or math.min(a[k], b[k]) >= area.sides[k] - slack then return nil end
  end
  check.fail("%s: member %d lies in the area, parallel to none of its edges; leave it out of 'members', or divide the "
    .. "area", where, member.index)
end

local function pieces_of(area, members)
  local list = { {}, {} }
  for _, member in ipairs(members) do
    local piece = piece_of(area, member)
    if piece then table.insert(list[piece.axis], piece) end
  end
  if #list[1] + #list[2] == 0 then
    check.fail("%s: none of the %s lies in the area of field 'on'", where, check.count(#members, "member"))
  end
  return list
end

local function point_text(p) return ("{%.6g, %.6g, %.6g} m"):format(p[1], p[2], p[3]) end

-- The place in space at `along_axis` and `across` it, both from the first corner.
local function point_of(area, axis, along_axis, across)
  return along(along(area.at, along_axis, area.axes[axis]), across, area.axes[3 - axis])
end

-- Sorts the pieces of a line and closes it to the length of the area, to rounding.
local function close_line(area, axis, line)
  table.sort(line, function(p, q) return p.from < q.from end)
  local at = 0
  for _, piece in ipairs(line) do
    if piece.from > at + area.slack then
      check.fail("%s: no member carries the area from %s to %s; give all members of that line", where,
        point_text(point_of(area, axis, at, line.offset)), point_text(point_of(area, axis, piece.from, line.offset)))
    end
    if piece.from < at - area.slack then
      check.fail("%s: member %d lies where another one of 'members' lies", where, piece.member.index)
    end
    piece.from, at = at, piece.to
  end
  if at < area.sides[axis] - area.slack then
    check.fail("%s: no member carries the area from %s to %s; give all members of that line", where,
      point_text(point_of(area, axis, at, line.offset)),
      point_text(point_of(area, axis, area.sides[axis], line.offset)))
  end
  line[#line].to = area.sides[axis]
end

-- The lines of members parallel to an axis, sorted by their offset; the first and the last are edges of the area.
local function lines_of(area, axis, list)
  table.sort(list, function(p, q) return p.offset < q.offset end)
  local lines, across = {}, 3 - axis
  for _, piece in ipairs(list) do
    local line = lines[#lines]
    if not line or piece.offset > line.offset + area.slack then
      line = { offset = piece.offset }
      lines[#lines + 1] = line
    end
    line[#line + 1] = piece
  end
  local first, last = lines[1], lines[#lines]
  for i, edge in ipairs { 0, area.sides[across] } do
    local line = i == 1 and first or last
    if not line or math.abs(line.offset - edge) > area.slack then
      check.fail("%s: no member lies along the edge of the area from %s to %s", where,
        point_text(point_of(area, axis, 0, edge)), point_text(point_of(area, axis, area.sides[axis], edge)))
    end
    line.offset = edge
  end
  for _, line in ipairs(lines) do close_line(area, axis, line) end
  return lines
end

-- The load on the part of a piece between two places of its line. sides: the area on each side of it as { direction
-- across, depth at the first place, depth at the second one }.
local function stretch_of(o, area, piece, line, from, to, sides)
  local function fraction(x)
    local f = (x - piece.a) / (piece.b - piece.a)
    return math.abs(f) < near and 0 or math.abs(f - 1) < near and 1 or f
  end
  local first, last = fraction(from), fraction(to)
  local turned = first > last
  local function q(part)
    if turned then part = 1 - part end
    local x, sum = from + part * (to - from), 0
    for _, side in ipairs(sides) do
      local depth = side[2] + part * (side[3] - side[2])
      if type(o.value) == "number" then
        sum = sum + o.value * depth
      else
        for _, g in ipairs(gauss) do
          local point = point_of(area, piece.axis, x, line.offset + side[1] * g[1] * depth)
          sum = sum + g[2] * depth * pressure_at(o, point)
        end
      end
    end
    return sum
  end
  local covered = 0
  for _, side in ipairs(sides) do covered = covered + (side[2] + side[3]) / 2 * (to - from) end
  return { member = piece.member, from = math.min(first, last), to = math.max(first, last), length = to - from, q = q,
    linear = type(o.value) == "number", area = covered }
end

-- The axis along which the beams of a one-way area lie.
local function beams_axis(o, area, list)
  if o.span then
    local span = faces.direction(where, "span", o.span)
    for axis = 1, 2 do
      if math.abs(dot(span, area.axes[axis])) > 1 - near then return 3 - axis end
    end
    check.fail("%s: field 'span' is %s; must be parallel to an edge of the area", where, check.show(o.span))
  end
  if #list[1] > 0 and #list[2] > 0 then
    check.fail("%s: members lie along both directions of the area; give 'span', the direction in which it spans from "
      .. "beam to beam, or spread = \"two way\"", where)
  end
  return #list[1] > 0 and 1 or 2
end

local function one_way(o, area, list)
  local axis = beams_axis(o, area, list)
  local lines, stretches = lines_of(area, axis, list[axis]), {}
  for i, line in ipairs(lines) do
    local sides = {}
    for _, step in ipairs { -1, 1 } do
      local other = lines[i + step]
      local depth = other and math.abs(other.offset - line.offset) / 2
      if depth then sides[#sides + 1] = { step, depth, depth } end
    end
    for _, piece in ipairs(line) do
      stretches[#stretches + 1] = stretch_of(o, area, piece, line, piece.from, piece.to, sides)
    end
  end
  return stretches
end

local function two_way(o, area, list)
  if o.span then check.fail("%s: field 'span' is for spread = \"one way\"", where) end
  local stretches = {}
  for axis = 1, 2 do
    local L, B = area.sides[axis], area.sides[3 - axis]
    local function depth(x) return math.min(x, L - x, B / 2) end
    local lines = lines_of(area, axis, list[axis])
    if #lines > 2 then
      check.fail("%s: member %d lies inside of the area; with spread = \"two way\" each bay needs a call of its own",
        where, lines[2][1].member.index)
    end
    for i, line in ipairs(lines) do
      for _, piece in ipairs(line) do
        local x = piece.from
        for _, kink in ipairs(L > B and { B / 2, L - B / 2, L } or { L / 2, L }) do
          local to = math.min(kink, piece.to)
          if to > x then
            stretches[#stretches + 1] = stretch_of(o, area, piece, line, x, to,
              { { i == 1 and 1 or -1, depth(x), depth(to) } })
            x = to
          end
        end
      end
    end
  end
  return stretches
end

-- The face ------------------------------------------------------------------------------------------------------------

local function on_face(o, normal, members)
  local stretches = {}
  for i, member in ipairs(members) do
    local a = place_of(member.a)
    local axis = minus(place_of(member.b), a)
    faces.refuse_along(where, "on", member, normal)
    local width = faces.width(where, o.width, member)
    stretches[i] = { member = member, from = 0, to = 1, length = member.length, area = width * member.length,
      linear = type(o.value) == "number", q = function(part) return width * pressure_at(o, along(a, part, axis)) end }
  end
  return stretches
end

-- Options -------------------------------------------------------------------------------------------------------------

local function read_options(given)
  if type(given) == "table" and given.openings ~= nil then
    check.fail("%s: field 'openings' is not there: openings in the area are not known; give the rectangles around the "
      .. "opening, each with members along its edges", where)
  end
  local rules = { spread = { "string", one_of = { "one way", "two way" }, optional = true } }
  for _, name in ipairs { "model", "members", "group", "on", "value", "direction", "span", "width", "case",
    "history" } do
    rules[name] = faces.any
  end
  local o = check.options(where, given, rules)
  chosen.model(where, o.model)
  if type(o.on) ~= "table" then
    check.fail("%s: field 'on' is %s; must be the 4 corners of a rectangle, or the direction out of a face", where,
      o.on == nil and "missing" or check.show(o.on))
  end
  if type(o.value) ~= "function" then check.value(where, "value", o.value, { "number", unit = "Pa" }) end
  return o
end

-- The members and the stretches of an area with corner points.
local function of_area(o, members)
  if o.width then check.fail("%s: field 'width' is for a face, where 'on' is a direction", where) end
  local spread = check.value(where, "spread", o.spread, { "string", one_of = { "one way", "two way" } })
  o.direction = faces.direction(where, "direction", o.direction)
  local area = rectangle(o.on)
  local list = pieces_of(area, members)
  local stretches = spread == "one way" and one_way(o, area, list) or two_way(o, area, list)
  return stretches, area.sides[1] * area.sides[2]
end

local function of_face(o, members)
  for _, name in ipairs { "spread", "span" } do
    if o[name] then check.fail("%s: field '%s' is for an area, where 'on' has corner points", where, name) end
  end
  local normal = faces.direction(where, "on", o.on)
  o.direction = o.direction and faces.direction(where, "direction", o.direction) or times(-1, normal)
  local stretches, area = on_face(o, normal, members), 0
  for _, stretch in ipairs(stretches) do area = area + stretch.area end
  return stretches, area
end

-- The result ----------------------------------------------------------------------------------------------------------

local Result = { __name = "hinge.pressure_result" }
function Result.__tostring(self)
  return ("%.6g m^2 and %.6g kN on %s"):format(self.area, self.total / 1e3, check.count(#self.parts, "member"))
end

-- Loads, and what each member gets.
local function collect(o, stretches)
  local loads, parts, part_of, total, area = {}, {}, {}, 0, 0
  for _, stretch in ipairs(stretches) do
    local list, sum = loads_of(o, stretch)
    table.move(list, 1, #list, #loads + 1, loads)
    local index = stretch.member.index
    if not part_of[index] then
      part_of[index] = { member = stretch.member, area = 0, force = 0 }
      parts[#parts + 1] = part_of[index]
    end
    local part = part_of[index]
    part.area, part.force = part.area + stretch.area, part.force + sum
    total, area = total + sum, area + stretch.area
  end
  return loads, parts, total, area
end

--- hinge.pressure: see words/actions.d.lua.
return function(options, ...)
  check.no_more(where, ...)
  local o = read_options(options)
  local members = chosen.members(where, o.model, o.members, o.group)
  local is_face = type(o.on[1]) == "number"
  local stretches, area = (is_face and of_face or of_area)(o, members)
  local loads, parts, total, covered = collect(o, stretches)
  local asked = type(o.value) == "number" and o.value * area or total
  if not (math.abs(covered - area) <= exact * area and math.abs(total - asked) <= exact * math.abs(asked)) then
    check.fail("%s: the members carry %.15g m^2 and get %.15g N, not %.15g m^2 and %.15g N", where, covered, total,
      area, asked)
  end
  for _, load in ipairs(loads) do o.model:load(load) end
  return setmetatable({ area = area, total = total, force = times(total, o.direction), parts = parts }, Result)
end
