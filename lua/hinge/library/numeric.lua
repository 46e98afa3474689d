-- Roots, and curves through points.
local numeric = {}

--- Where f changes its sign between low and high, to the last digit: the last value before.
function numeric.root(f, low, high)
  local rises = f(high) > 0
  for _ = 1, 100 do
    local middle = (low + high) / 2
    if (f(middle) > 0) == rises then high = middle else low = middle end
  end
  return low
end

--- The value at x of a curve { x =, y = } that is straight between its points; nil beyond the last one.
function numeric.value_at(curve, x)
  for i = 2, #curve.x do
    if curve.x[i] >= x then
      local part = (x - curve.x[i - 1]) / (curve.x[i] - curve.x[i - 1])
      return curve.y[i - 1] + part * (curve.y[i] - curve.y[i - 1])
    end
  end
end

--- Where the parabola through three points { x =, y = } turns: x and y.
function numeric.turn(p, q, r)
  local slope = (q.y - p.y) / (q.x - p.x)
  local bend = ((r.y - q.y) / (r.x - q.x) - slope) / (r.x - p.x)
  local x = (p.x + q.x) / 2 - slope / (2 * bend)
  return x, p.y + (x - p.x) * (slope + bend * (x - q.x))
end

--- The complete elliptic integral of the first kind, of the square of the modulus, by the arithmetic-geometric mean.
function numeric.elliptic(k2)
  local a, b = 1, math.sqrt(1 - k2)
  for _ = 1, 12 do a, b = (a + b) / 2, math.sqrt(a * b) end
  return math.pi / (2 * a)
end

return numeric
