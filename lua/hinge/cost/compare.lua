-- Comparing answers: the difference of two, the order of convergence, and the settings on the Pareto front.
local compare = {}
-- The part of an error by which a slower setting must be better to be on the front: less is rounding.
local least_gain = 1e-3

--- The larger of two numbers; not a number if one of them is not: math.max(a, b) drops a b that is not a number.
function compare.larger(a, b) return a == a and not (b <= a) and b or a end

-- The value of a history at x by the cubic through the four points about it; its abscissae rise.
local function value_at(h, x, from)
  local n, k = #h.x, from
  while k < n - 1 and h.x[k + 1] <= x do k = k + 1 end
  if x == h.x[k] then return h.y[k], k end
  local first = math.max(1, math.min(k - 1, n - 3))
  local sum = 0
  for i = first, math.min(first + 3, n) do
    local weight = 1
    for j = first, math.min(first + 3, n) do
      if j ~= i then weight = weight * (x - h.x[j]) / (h.x[i] - h.x[j]) end
    end
    sum = sum + weight * h.y[i]
  end
  return sum, k
end

local function rises(x)
  for i = 2, #x do
    if not (x[i] > x[i - 1]) then return false end
  end
  return true
end

local function size(answer)
  if type(answer) == "number" then return math.abs(answer) end
  local peak = 0
  for _, v in ipairs(answer.y) do peak = compare.larger(peak, math.abs(v)) end
  return peak
end

-- Root of the mean square difference of two histories at the abscissae of the first, as far as both go.
local function distance(a, b)
  if type(a) ~= type(b) then return math.huge end
  if type(a) == "number" then return math.abs(a - b) end
  if #a.x < 2 or #b.x < 2 or not rises(a.x) or not rises(b.x) then -- a load factor that turns back: step by step
    if #a.y ~= #b.y then return math.huge end
    local sum = 0
    for i, v in ipairs(a.y) do sum = sum + (v - b.y[i]) ^ 2 end
    return math.sqrt(sum / math.max(1, #a.y))
  end
  local sum, count, k, last = 0, 0, 1, b.x[#b.x] * (1 + 1e-9)
  for i, x in ipairs(a.x) do
    if x > last then break end
    local wanted
    wanted, k = value_at(b, x, k)
    sum, count = sum + (a.y[i] - wanted) ^ 2, count + 1
  end
  return count > 0 and math.sqrt(sum / count) or math.huge
end

--- The difference of an answer from another, as a part of the other's size (the value of a number, the largest value of
-- a history); root mean square for histories. math.huge if one of them has a number that is not finite.
function compare.error(answer, reference)
  if answer == nil or reference == nil then return math.huge end
  local d, scale = distance(answer, reference), size(reference)
  if not (d < math.huge and scale < math.huge and size(answer) < math.huge) then return math.huge end
  if d == 0 then return 0 end
  return d / (scale > 0 and scale or size(answer))
end

--- The size of an answer: a number without its sign, the largest value of a history.
compare.size = size
--- The difference of two answers, root mean square for histories; math.huge if they cannot be compared.
compare.distance = distance

-- The values of a history at the abscissae of another one. Curves that turn back are taken step by step. nil if they do
-- not go together.
local function values_along(base, h)
  if type(base) ~= type(h) then return nil end
  if h == base then return h.y end
  if #base.x < 2 or #h.x < 2 or not rises(base.x) or not rises(h.x) then return #base.y == #h.y and h.y or nil end
  local values, k = {}, 1
  for i, x in ipairs(base.x) do
    if x > h.x[#h.x] * (1 + 1e-9) then break end
    values[i], k = value_at(h, x, k)
  end
  return #values > 0 and values or nil
end

--- f of the values of several answers, as an answer: f(a, b, ...) of numbers; of histories f at each abscissa of the
--- last one, as far as all of them go. nil if they do not go together.
function compare.combined(f, ...)
  local all = { ... }
  local base = all[#all]
  if type(base) == "number" then
    for _, a in ipairs(all) do
      if type(a) ~= "number" then return nil end
    end
    return f(...)
  end
  local columns, rows = {}, #base.y
  for i, h in ipairs(all) do
    columns[i] = values_along(base, h)
    if not columns[i] then return nil end
    rows = math.min(rows, #columns[i])
  end
  local result, cells = { x = table.move(base.x, 1, rows, 1, {}), y = {} }, {}
  for k = 1, rows do
    for i, column in ipairs(columns) do cells[i] = column[k] end
    result.y[k] = f(table.unpack(cells))
  end
  return result
end

--- Whether the change from a to b goes on in the change from b to c: the cosine of the angle between both changes, for
--- numbers 1, -1, or 0 where nothing changes.
function compare.going_on(a, b, c)
  local before = compare.combined(function(x, y) return y - x end, a, b, c)
  local after = compare.combined(function(_, y, z) return z - y end, a, b, c)
  if not before then return 0 end
  if type(before) == "number" then return before * after > 0 and 1 or before * after < 0 and -1 or 0 end
  local along, first, second = 0, 0, 0
  for i, v in ipairs(before.y) do
    along, first, second = along + v * after.y[i], first + v * v, second + after.y[i] * after.y[i]
  end
  return first * second > 0 and along / math.sqrt(first * second) or 0
end

--- The order of convergence p from answers at three step sizes h1 > h2 > h3: (h1^p - h2^p) / (h2^p - h3^p) is the ratio
-- of their differences. nil if none between 0.02 and 16 fits; math.huge (exact) if the differences are 0.
function compare.order(h, answers)
  local first, second = distance(answers[1], answers[2]), distance(answers[2], answers[3])
  local noise = 1e-9 * size(answers[3])
  if first <= noise and second <= noise then return math.huge end
  if not (first < math.huge and second > 0) then return nil end
  local function excess(p) return (h[1] ^ p - h[2] ^ p) / (h[2] ^ p - h[3] ^ p) - first / second end
  local low, high = 0.02, 16
  if excess(low) > 0 or excess(high) < 0 then return nil end
  for _ = 1, 60 do
    local middle = (low + high) / 2
    if excess(middle) > 0 then high = middle else low = middle end
  end
  return (low + high) / 2
end

--- The Pareto front of { { time =, error = }, ... }, by time. An item is on it if no other item is better in one value
-- and equal or better in the other. Left out are items without an error, or with one that is not a number, and items
-- that are better by less than a thousandth.
function compare.front(items)
  local sorted, front, least = {}, {}, math.huge
  for _, item in ipairs(items) do
    if item.error and item.error == item.error then sorted[#sorted + 1] = item end
  end
  table.sort(sorted, function(a, b) return a.time < b.time or a.time == b.time and a.error < b.error end)
  for _, item in ipairs(sorted) do
    if item.error < least * (1 - least_gain) then
      front[#front + 1] = item
      least = item.error
    end
  end
  return front
end

function compare.median(values)
  local sorted = table.move(values, 1, #values, 1, {})
  table.sort(sorted)
  local n = #sorted
  return n > 0 and (sorted[(n + 1) // 2] + sorted[n // 2 + 1]) / 2 or nil
end

return compare
