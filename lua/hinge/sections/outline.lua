-- Outlines of cross-sections: polygons with rounded corners, and the properties of their areas.
--
-- A polygon is a list of corners { x, y }, m, counterclockwise. An arc becomes three straight pieces. The two points
-- between its ends lie a little outside of its circle, so that the sector keeps its area and its centroid. Areas and
-- plastic moduli are then exact where no neutral axis goes through an arc, and second moments are within 5e-5.
local outline = {}

-- Where the two points are, for an arc of radius 1 from -beta to beta: their radius and their angles, -a and a.
local function points_of_arc(beta)
  local function radius(a) -- the sector has the area beta
    local s, m = math.sin(beta - a), math.sin(2 * a) / 2
    return (math.sqrt(s * s + 4 * m * beta) - s) / (2 * m)
  end
  local low, high = 0.05 * beta, 0.95 * beta
  for _ = 1, 60 do
    local a = (low + high) / 2
    local r = radius(a)
    local end_part, middle = r * math.sin(beta - a), r * r * math.sin(2 * a) / 2
    local moment = end_part * (math.cos(beta) + r * math.cos(a)) + 2 * middle * r * math.cos(a) -- three times its half
    if moment > 2 * math.sin(beta) then low = a else high = a end
  end
  return radius((low + high) / 2), (low + high) / 2
end

-- The arc of radius r that touches both sides of a corner.
local function add_arc(to, before, corner, after, r)
  local ax, ay, bx, by = before[1] - corner[1], before[2] - corner[2], after[1] - corner[1], after[2] - corner[2]
  local a, b = math.sqrt(ax * ax + ay * ay), math.sqrt(bx * bx + by * by)
  ax, ay, bx, by = ax / a, ay / a, bx / b, by / b
  local half = math.acos(ax * bx + ay * by) / 2 -- between a side and the line from the corner to the arc's centre
  local beta, tangent, far = math.pi / 2 - half, r / math.tan(half), r / math.sin(half)
  local ox, oy = (ax + bx) / (2 * math.cos(half)), (ay + by) / (2 * math.cos(half)) -- that line's direction
  local side = ax * by - ay * bx < 0 and 1 or -1 -- convex corners turn left
  local radius, angle = points_of_arc(beta)
  to[#to + 1] = { corner[1] + tangent * ax, corner[2] + tangent * ay }
  for sign = -1, 1, 2 do
    local along, across = far - radius * r * math.cos(angle), sign * side * radius * r * math.sin(angle)
    to[#to + 1] = { corner[1] + along * ox + across * oy, corner[2] + along * oy - across * ox }
  end
  to[#to + 1] = { corner[1] + tangent * bx, corner[2] + tangent * by }
end

--- The polygon of corners { x, y, r }: those with r are rounded with that radius.
function outline.rounded(corners)
  local to, n = {}, #corners
  for i, corner in ipairs(corners) do
    local r = corner[3] or 0
    if r > 0 then add_arc(to, corners[(i + n - 2) % n + 1], corner, corners[i % n + 1], r)
    else to[#to + 1] = { corner[1], corner[2] } end
  end
  return to
end

--- A rectangle between -b/2 and b/2, -d/2 and d/2, with corners of radius r, as a part of an outline.
function outline.rectangle(b, d, r, hole)
  return { hole = hole, corners = outline.rounded { { -b / 2, -d / 2, r }, { b / 2, -d / 2, r }, { b / 2, d / 2, r },
    { -b / 2, d / 2, r } } }
end

--- Area, first moments { x, y } and second moments { xx, yy, xy } = integrals of x^2, y^2 and x y, by Green's theorem.
function outline.moments(corners)
  local A, x, y, xx, yy, xy = 0, 0, 0, 0, 0, 0
  local p = corners[#corners]
  for _, q in ipairs(corners) do
    local c = p[1] * q[2] - q[1] * p[2]
    A, x, y = A + c / 2, x + c * (p[1] + q[1]) / 6, y + c * (p[2] + q[2]) / 6
    xx = xx + c * (p[1] ^ 2 + p[1] * q[1] + q[1] ^ 2) / 12
    yy = yy + c * (p[2] ^ 2 + p[2] * q[2] + q[2] ^ 2) / 12
    xy = xy + c * (p[1] * (2 * p[2] + q[2]) + q[1] * (2 * q[2] + p[2])) / 24
    p = q
  end
  return { A = A, x = x, y = y, xx = xx, yy = yy, xy = xy }
end

--- The corners with their centroid at the origin and turned by -angle: an axis at `angle` becomes x.
function outline.moved(corners, x, y, angle)
  local c, s, to = math.cos(angle or 0), math.sin(angle or 0), {}
  for i, p in ipairs(corners) do
    local u, v = p[1] - x, p[2] - y
    to[i] = { c * u + s * v, c * v - s * u }
  end
  return to
end

--- Area and first moment of what lies beyond e along the axis `k`, 1 (x) or 2 (y).
function outline.beyond(corners, k, e)
  local other, sign = 3 - k, k == 1 and 1 or -1
  local area, moment = 0, 0
  local p = corners[#corners]
  for _, q in ipairs(corners) do
    local a, b = p[k] - e, q[k] - e
    if a > 0 or b > 0 then
      local pa, qa, from, to = a, b, p[other], q[other]
      if a <= 0 then pa, from = 0, from + (to - from) * a / (a - b)
      elseif b <= 0 then qa, to = 0, from + (to - from) * a / (a - b) end
      area = area + sign * (to - from) * (pa + qa) / 2
      moment = moment + sign * (to - from) * (pa * pa + pa * qa + qa * qa) / 6
    end
    p = q
  end
  return area, moment + e * area
end

--- Plastic modulus of bending about the axis along which `k` does not run: the first moments on both sides of the line
-- that halves the area.
function outline.plastic_modulus(corners, k)
  local whole, low, high = outline.moments(corners).A, math.huge, -math.huge
  for _, p in ipairs(corners) do low, high = math.min(low, p[k]), math.max(high, p[k]) end
  local _, all = outline.beyond(corners, k, low)
  for _ = 1, 100 do
    local e = (low + high) / 2
    if outline.beyond(corners, k, e) > whole / 2 then low = e else high = e end
  end
  local _, moment = outline.beyond(corners, k, (low + high) / 2)
  return 2 * moment - all
end

--- Shear area along the principal axis `k` of an open thin-walled section: I^2 over the integral of S^2 / t.
-- path: its walls' middle lines, points { x, y } from one free end to the other about the centroid; t: their
-- thicknesses.
function outline.shear_area(path, t, k)
  local I = 0
  for i = 1, #path - 1 do
    local a, b = path[i], path[i + 1]
    local l = math.sqrt((b[1] - a[1]) ^ 2 + (b[2] - a[2]) ^ 2)
    I = I + t[i] * l * (a[k] ^ 2 + a[k] * b[k] + b[k] ^ 2) / 3
  end
  local S, flow = 0, 0
  for i = 1, #path - 1 do
    local a, b = path[i], path[i + 1]
    local l = math.sqrt((b[1] - a[1]) ^ 2 + (b[2] - a[2]) ^ 2)
    -- S is a parabola along the wall: three points of Gauss integrate its square exactly
    for g = -1, 1 do
      local at = 0.5 + g * math.sqrt(0.15)
      local S_at = S + t[i] * l * at * (a[k] + 0.5 * at * (b[k] - a[k]))
      flow = flow + (g == 0 and 8 or 5) / 18 * l * S_at ^ 2 / t[i]
    end
    S = S + t[i] * l * (a[k] + b[k]) / 2
  end
  return I ^ 2 / flow
end

return outline
