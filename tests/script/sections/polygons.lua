-- Properties of polygons in Lua, with which the sections' outlines are compared: corners { x, y }, m, counterclockwise.
local outline = {}

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
  for _, p in ipairs(corners) do low, high = math.min(low, p[k]), p[k] > high and p[k] or high end
  local _, all = outline.beyond(corners, k, low)
  for _ = 1, 100 do
    local e = (low + high) / 2
    if outline.beyond(corners, k, e) > whole / 2 then low = e else high = e end
  end
  local _, moment = outline.beyond(corners, k, (low + high) / 2)
  return 2 * moment - all
end

return outline
