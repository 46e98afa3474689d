-- Tributary areas of a convex panel: which part of it each of its sides carries. Points have two coordinates in the
-- plane of the panel, m.
--
-- Two way: a point belongs to the nearest side, so that lines at half the angle from the corners divide the panel (45
-- degrees in a rectangle). One way: each strip along the direction of span gives half of its length to each of the two
-- sides where it ends. An opening carries nothing; what is around it goes where it would go without it.
--
-- The part of a side, less what openings take, is a sum of polygons with a sign. The width of that sum at a place along
-- the side is linear between their corners: loads per length are exact, and so is their sum.
local tributary = {}

local function cross(a, b) return a[1] * b[2] - a[2] * b[1] end
local function minus(a, b) return { a[1] - b[1], a[2] - b[2] } end

--- The area of a polygon, above 0 where it turns to the left.
function tributary.area(polygon)
  local sum, n = 0, #polygon
  for i = 2, n - 1 do
    sum = sum + cross(minus(polygon[i], polygon[1]), minus(polygon[i + 1], polygon[1])) / 2
  end
  return sum
end

-- The part of a polygon where f(point) >= 0, f linear.
local function clip(polygon, f)
  local out, n = {}, #polygon
  for i = 1, n do
    local p, q = polygon[i], polygon[i % n + 1]
    local fp, fq = f(p), f(q)
    if fp >= 0 then out[#out + 1] = p end
    if (fp > 0 and fq < 0) or (fp < 0 and fq > 0) then
      local t = fp / (fp - fq)
      out[#out + 1] = { p[1] + t * (q[1] - p[1]), p[2] + t * (q[2] - p[2]) }
    end
  end
  return #out >= 3 and out or {}
end

-- The part of any polygon that lies in a convex one, which turns to the left.
local function inside(polygon, convex)
  local n = #convex
  for i = 1, n do
    local a, along = convex[i], minus(convex[i % n + 1], convex[i])
    polygon = clip(polygon, function(p) return cross(along, minus(p, a)) end)
  end
  return polygon
end

--- The area of an opening that lies in the panel, m^2.
function tributary.area_inside(opening, panel) return math.abs(tributary.area(inside(opening, panel))) end

local function is_convex(polygon)
  local n = #polygon
  for i = 1, n do
    local a, b, c = polygon[i], polygon[i % n + 1], polygon[(i + 1) % n + 1]
    local r, s = minus(b, a), minus(c, b)
    if cross(r, s) < -1e-9 * math.sqrt((r[1] ^ 2 + r[2] ^ 2) * (s[1] ^ 2 + s[2] ^ 2)) then return false end
  end
  return true
end

--- The area that two polygons have in common, m^2, which turn to the left; 0 where neither is convex.
function tributary.overlap(one, other)
  if is_convex(one) then return math.abs(tributary.area(inside(other, one))) end
  return is_convex(other) and math.abs(tributary.area(inside(one, other))) or 0
end

--- Two edges of a polygon that cross, by the numbers of their first corners; nil where none do.
function tributary.crossing(polygon)
  local n = #polygon
  for i = 1, n do
    local a, b = polygon[i], polygon[i % n + 1]
    for j = i + 2, n do
      local c, d = polygon[j], polygon[j % n + 1]
      if (i > 1 or j < n) and cross(minus(b, a), minus(c, a)) * cross(minus(b, a), minus(d, a)) < 0
        and cross(minus(d, c), minus(a, c)) * cross(minus(d, c), minus(b, c)) < 0 then
        return i, j
      end
    end
  end
end

-- How far a point is inside of a side.
local function distance(side)
  return function(p) return cross(side.along, minus(p, side.from)) end
end

-- The regions of a panel as { side =, polygon =, toward = (from a point to where its load goes, as a direction) }.
local function two_way(panel, sides)
  local regions = {}
  for i, side in ipairs(sides) do
    local polygon, mine = panel, distance(side)
    for j, other in ipairs(sides) do
      local theirs = distance(other)
      if j ~= i then polygon = clip(polygon, function(p) return theirs(p) - mine(p) end) end
    end
    regions[#regions + 1] = { side = side, polygon = polygon, toward = { side.along[2], -side.along[1] } }
  end
  return regions
end

local function one_way(panel, sides, span, slack)
  local regions = {}
  local function place(p) return cross(span, p) end -- of the strip that a point is in
  for _, first in ipairs(sides) do
    for _, last in ipairs(sides) do
      local enters, leaves = cross(first.along, span), -cross(last.along, span)
      if enters > slack and leaves > slack then
        local low = math.max(math.min(place(first.from), place(first.to)), math.min(place(last.from), place(last.to)))
        local high = math.min(math.max(place(first.from), place(first.to)), math.max(place(last.from), place(last.to)))
        local strip = clip(clip(panel, function(p) return place(p) - low end), function(p) return high - place(p) end)
        local to_first, to_last = distance(first), distance(last)
        local function nearer(p) return to_last(p) / leaves - to_first(p) / enters end
        if high > low then
          regions[#regions + 1] = { side = first, polygon = clip(strip, nearer), toward = { -span[1], -span[2] } }
          regions[#regions + 1] = { side = last, polygon = clip(strip, function(p) return -nearer(p) end),
            toward = span }
        end
      end
    end
  end
  return regions
end

-- A region and what openings take of it in the side's own coordinates: s along the side, to where the load goes, and t
-- off it, such that an area of the panel is the same area there. Returns { sign =, polygon = { {s, t}, ... } }, ...
local function flatten(region, openings)
  local side, toward = region.side, region.toward
  local slope = cross(side.along, toward) -- -1 where the load goes straight to the side
  local function flat(polygon)
    local out = {}
    for i, p in ipairs(polygon) do
      local off = cross(side.along, minus(p, side.from)) -- m
      local r = minus(p, side.from)
      local s = r[1] * side.along[1] + r[2] * side.along[2]
        - off / slope * (toward[1] * side.along[1] + toward[2] * side.along[2])
      out[i] = { s, off }
    end
    return out
  end
  local parts = { { sign = 1, polygon = flat(region.polygon) } }
  for _, opening in ipairs(openings) do
    local cut = inside(opening, region.polygon)
    if #cut > 0 then
      parts[#parts + 1] = { sign = tributary.area(cut) > 0 and -1 or 1, polygon = flat(cut) }
    end
  end
  return parts
end

-- The width of a sum of polygons at the place s, which is at none of their corners.
local function width(parts, s)
  local sum = 0
  for _, part in ipairs(parts) do
    local polygon, n = part.polygon, #part.polygon
    for i = 1, n do
      local p, q = polygon[i], polygon[i % n + 1]
      if (p[1] > s) ~= (q[1] > s) then
        local t = p[2] + (s - p[1]) / (q[1] - p[1]) * (q[2] - p[2])
        sum = sum + part.sign * (p[1] > q[1] and t or -t)
      end
    end
  end
  return sum
end

--- Of each side of a convex panel the stretches { from =, to = (m along the side), a =, b = (width that is carried
--- there, m) }. panel: corners that turn to the left. sides: { from =, to = (corners), along = (unit vector) }. span: a
--- unit vector for one way, nil for two. slack: lengths below it are 0.
function tributary.stretches(panel, sides, openings, span, slack)
  local regions = span and one_way(panel, sides, span, 1e-9) or two_way(panel, sides)
  local of_side = {}
  for _, side in ipairs(sides) do of_side[side] = { parts = {}, places = {} } end
  for _, region in ipairs(regions) do
    if #region.polygon > 0 then
      local own = of_side[region.side]
      for _, part in ipairs(flatten(region, openings)) do
        own.parts[#own.parts + 1] = part
        for _, p in ipairs(part.polygon) do own.places[#own.places + 1] = p[1] end
      end
    end
  end
  local lists = {}
  for i, side in ipairs(sides) do
    local own, list = of_side[side], {}
    table.sort(own.places)
    local from = own.places[1]
    for _, to in ipairs(own.places) do
      if to - from > slack then
        local one, two = width(own.parts, from + (to - from) / 4), width(own.parts, from + 3 * (to - from) / 4)
        local a, b = 1.5 * one - 0.5 * two, 1.5 * two - 0.5 * one
        list[#list + 1] = { from = from, to = to, a = math.max(0, a), b = math.max(0, b) }
        from = to
      end
    end
    lists[i] = list
  end
  return lists
end

return tributary
