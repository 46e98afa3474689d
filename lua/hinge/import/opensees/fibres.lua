-- Fibres of a section of OpenSees: from patches and layers, in its axes y and z and the units of the script. What they
-- sum up to is what OpenSees sums up: each fibre counts by its area at its centroid.
local fibres = {}

-- Area and centroid of a polygon of four corners { y, z }.
local function of_quad(p)
  local area, cy, cz = 0, 0, 0
  for i = 1, 4 do
    local a, b = p[i], p[i % 4 + 1]
    local part = (a[1] * b[2] - b[1] * a[2]) / 2
    area, cy, cz = area + part, cy + part * (a[1] + b[1]) / 3, cz + part * (a[2] + b[2]) / 3
  end
  if area == 0 then return 0, p[1][1], p[1][2] end
  return math.abs(area), cy / area, cz / area
end

-- The point of a quadrilateral at s and t, both 0 to 1.
local function inside(corners, s, t)
  local at = {}
  for k = 1, 2 do
    at[k] = (1 - s) * (1 - t) * corners[1][k] + s * (1 - t) * corners[2][k] + s * t * corners[3][k]
      + (1 - s) * t * corners[4][k]
  end
  return at
end

--- The fibres of a quadrilateral that is divided n times along its sides 12 and 43, m times along 23 and 14.
function fibres.quad(material, n, m, corners)
  local list = {}
  for i = 1, n do
    for k = 1, m do
      local s0, s1, t0, t1 = (i - 1) / n, i / n, (k - 1) / m, k / m
      local area, y, z = of_quad { inside(corners, s0, t0), inside(corners, s1, t0), inside(corners, s1, t1),
        inside(corners, s0, t1) }
      list[#list + 1] = { y = y, z = z, area = area, material = material }
    end
  end
  return list, { corners = corners, material = material }
end

--- The fibres of a part of a ring between two radii and two angles (degrees).
function fibres.ring(material, around, across, y, z, from, to, first, last)
  local list, part = {}, math.rad(last - first) / around
  for k = 1, across do
    local r0, r1 = from + (k - 1) * (to - from) / across, from + k * (to - from) / across
    local area = part / 2 * (r1 ^ 2 - r0 ^ 2)
    local r = 2 / 3 * (r1 ^ 3 - r0 ^ 3) / (r1 ^ 2 - r0 ^ 2) * math.sin(part / 2) / (part / 2)
    for i = 1, around do
      local angle = math.rad(first) + (i - 0.5) * part
      list[#list + 1] = { y = y + r * math.cos(angle), z = z + r * math.sin(angle), area = area, material = material }
    end
  end
  local whole = math.abs(last - first - 360) < 1e-6
  return list, whole and { ring = { y, z, from, to }, material = material } or nil
end

--- Bars on a straight line from one end to the other, one at each end.
function fibres.line(material, count, area, y0, z0, y1, z1)
  local list = {}
  for i = 1, count do
    local s = count == 1 and 0.5 or (i - 1) / (count - 1)
    list[i] = { y = y0 + s * (y1 - y0), z = z0 + s * (z1 - z0), area = area, material = material, bar = true }
  end
  return list
end

--- Bars on an arc between two angles (degrees); without them, around a whole circle.
function fibres.arc(material, count, area, y, z, r, first, last)
  first = first or 0
  last = last or 360 - 360 / count
  local list = {}
  for i = 1, count do
    local angle = math.rad(count == 1 and first or first + (i - 1) * (last - first) / (count - 1))
    list[i] = { y = y + r * math.cos(angle), z = z + r * math.sin(angle), area = area, material = material, bar = true }
  end
  return list
end

-- The largest sum of strength times distance from an axis that halves the strength: the fully plastic moment.
local function plastic(list, key)
  local sorted, whole = table.move(list, 1, #list, 1, {}), 0
  table.sort(sorted, function(a, b) return a[key] < b[key] end)
  for _, f in ipairs(sorted) do whole = whole + f.area * f.material.fy end
  local below, axis = 0, 0
  for _, f in ipairs(sorted) do
    below = below + f.area * f.material.fy
    if below >= whole / 2 then
      axis = f[key]
      break
    end
  end
  local moment = 0
  for _, f in ipairs(sorted) do moment = moment + f.area * f.material.fy * math.abs(f[key] - axis) end
  return moment
end

--- What fibres sum up to: area, EA, EIz (of y), EIy (of z) about their centre { y, z }; and, where all of them yield,
--- N0, Mz0, My0. The centre is that of their areas, as in OpenSees.
function fibres.sums(list)
  local s = { area = 0, EA = 0, EIz = 0, EIy = 0, y = 0, z = 0 }
  local yields, concrete = true, false
  for _, f in ipairs(list) do
    s.area, s.y, s.z = s.area + f.area, s.y + f.area * f.y, s.z + f.area * f.z
    yields = yields and f.material.fy ~= nil
    concrete = concrete or f.material.concrete or false
  end
  s.y, s.z = s.y / s.area, s.z / s.area
  local off = 0
  for _, f in ipairs(list) do
    local EA = f.material.E * f.area
    s.EA, s.EIz, s.EIy = s.EA + EA, s.EIz + EA * (f.y - s.y) ^ 2, s.EIy + EA * (f.z - s.z) ^ 2
    off = off + EA * (f.y - s.y)
  end
  s.off, s.concrete = off / s.EA, concrete
  if yields then
    s.N0, s.Mz0, s.My0 = 0, plastic(list, "y"), plastic(list, "z")
    for _, f in ipairs(list) do s.N0 = s.N0 + f.area * f.material.fy end
  end
  return s
end

return fibres
