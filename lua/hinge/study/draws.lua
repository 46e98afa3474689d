-- Random draws of parameters: independent ones, a Latin hypercube, or Sobol's sequence; and the distributions.
local check = require "hinge.library.check"
local values = require "hinge.library.values"

local draws = {}

-- Distributions: the value below which the part u of all draws lies, 0 < u < 1 -------------------------------------

-- The standard normal distribution's: where erfc is a series or a continued fraction, by Newton's method on it.
local function normal_part(x) -- the part below x
  local z = math.abs(x)
  if z > 38 then return x > 0 and 1 or 0 end
  if z < 3 then -- series of Abramowitz and Stegun 26.2.11
    local term, sum, k = z, z, 1
    while term > 1e-17 * sum do
      k = k + 2
      term = term * z * z / k
      sum = sum + term
    end
    local part = sum * math.exp(-z * z / 2) / math.sqrt(2 * math.pi)
    return x > 0 and 0.5 + part or 0.5 - part
  end
  local fraction = 0 -- continued fraction, 26.2.14
  for k = 100, 1, -1 do fraction = k / (z + fraction) end
  local tail = math.exp(-z * z / 2) / math.sqrt(2 * math.pi) / (z + fraction)
  return x > 0 and 1 - tail or tail
end

local function normal_quantile(u)
  if u > 0.5 then return -normal_quantile(1 - u) end
  local low, high = -39.0, 0.0
  for _ = 1, 20 do
    local middle = 0.5 * (low + high)
    if normal_part(middle) < u then low = middle else high = middle end
  end
  local x = 0.5 * (low + high)
  for _ = 1, 4 do
    local density = math.exp(-x * x / 2) / math.sqrt(2 * math.pi)
    if density > 0 then x = x - (normal_part(x) - u) / density end
  end
  return x
end
draws.normal_part, draws.normal_quantile = normal_part, normal_quantile

local distributions = {
  normal = { takes = "mean, standard deviation", n = 2, make = function(mean, deviation)
    return function(u) return mean + deviation * normal_quantile(u) end
  end, allowed = function(_, deviation) return deviation > 0 end },
  lognormal = { takes = "median, standard deviation of the logarithm", n = 2, make = function(median, deviation)
    return function(u) return median * math.exp(deviation * normal_quantile(u)) end
  end, allowed = function(median, deviation) return median > 0 and deviation > 0 end },
  uniform = { takes = "lowest, highest value", n = 2, make = function(low, high)
    return function(u) return low + (high - low) * u end
  end, allowed = function(low, high) return low < high end },
  triangular = { takes = "lowest, likeliest, highest value", n = 3, make = function(low, likely, high)
    local turn = (likely - low) / (high - low)
    return function(u)
      if u < turn then return low + math.sqrt(u * (high - low) * (likely - low)) end
      return high - math.sqrt((1 - u) * (high - low) * (high - likely))
    end
  end, allowed = function(low, likely, high) return low <= likely and likely <= high and low < high end },
  weibull = { takes = "scale, shape", n = 2, make = function(scale, shape)
    return function(u) return scale * (-math.log(1 - u)) ^ (1 / shape) end
  end, allowed = function(scale, shape) return scale > 0 and shape > 0 end },
}

-- choice(a,b,...): each value of a list, text or number, equally often.
local function choice(text, inside, where)
  local items = {}
  for item in (inside .. ","):gmatch "([^,]*)," do items[#items + 1] = values.guess(item:match "^%s*(.-)%s*$") end
  if #items < 2 then check.fail("%s: choice takes two values or more", where) end
  for i, item in ipairs(items) do
    if item == "" then check.fail("%s: value %d of choice is empty", where, i) end
  end
  return { text = text, quantile = function(u) return items[math.min(#items, math.floor(u * #items) + 1)] end }
end

--- "normal(122, 5)" as { text =, quantile = function(u) }. `where`: what stands before a message.
function draws.distribution(text, where)
  local name, inside = text:match "^%s*(%a+)%s*%((.*)%)%s*$"
  if name == "choice" then return choice(text, inside, where) end
  local known = name and distributions[name]
  if not known then
    check.fail("%s: '%s' is no distribution%s; there are normal(mean,deviation), lognormal(median,deviation of the "
      .. "logarithm), uniform(lowest,highest), triangular(lowest,likeliest,highest), weibull(scale,shape) and "
      .. "choice(a,b,...)", where,
      text, name and require "hinge.core".did_you_mean(name, check.keys(distributions)) or "")
  end
  local numbers = {}
  for item in (inside .. ","):gmatch "([^,]*)," do numbers[#numbers + 1] = values.number(item) or 0 / 0 end
  local good = #numbers == known.n
  for _, number in ipairs(numbers) do good = good and number == number end
  if not good or not known.allowed(table.unpack(numbers)) then
    check.fail("%s: %s takes %s%s", where, name, known.takes, good and ", in that order, none of them impossible" or "")
  end
  return { text = text, quantile = known.make(table.unpack(numbers)) }
end

-- Random numbers: xorshift64* by Vigna (2016), from a seed spread by splitmix64, so that each machine draws the same --

local function generator(seed)
  local state = seed + 0x9e3779b97f4a7c15
  state = (state ~ (state >> 30)) * 0xbf58476d1ce4e5b9
  state = (state ~ (state >> 27)) * 0x94d049bb133111eb
  state = state ~ (state >> 31)
  if state == 0 then state = 1 end
  local function bits()
    state = state ~ (state >> 12)
    state = state ~ (state << 25)
    state = state ~ (state >> 27)
    return state * 0x2545f4914f6cdd1d
  end
  return {
    part = function() return ((bits() >> 11) + 0.5) * 2.0 ^ -53 end,      -- above 0, below 1
    below = function(n) return (bits() >> 33) * n // (1 << 31) end, -- a whole number from 0 to n - 1
  }
end
draws.generator = generator

-- Direction numbers of Sobol's sequence: degree, coefficients and first numbers as Joe and Kuo (SIAM J. Sci. Comput.
-- 30, 2008) have them for the dimensions 2 to 21. The first dimension is van der Corput's.
local joe_kuo = {
  { 1, 0, 1 }, { 2, 1, 1, 3 }, { 3, 1, 1, 3, 1 }, { 3, 2, 1, 1, 1 }, { 4, 1, 1, 1, 3, 3 }, { 4, 4, 1, 3, 5, 13 },
  { 5, 2, 1, 1, 5, 5, 17 }, { 5, 4, 1, 1, 5, 5, 5 }, { 5, 7, 1, 1, 7, 11, 19 }, { 5, 11, 1, 1, 5, 1, 1 },
  { 5, 13, 1, 1, 1, 3, 11 }, { 5, 14, 1, 3, 5, 5, 31 }, { 6, 1, 1, 3, 3, 9, 7, 49 }, { 6, 13, 1, 1, 1, 15, 21, 21 },
  { 6, 16, 1, 3, 1, 13, 27, 49 }, { 6, 19, 1, 1, 1, 15, 7, 5 }, { 6, 22, 1, 3, 1, 15, 13, 25 },
  { 6, 25, 1, 1, 5, 5, 19, 61 }, { 7, 1, 1, 3, 7, 11, 23, 15, 103 }, { 7, 4, 1, 3, 7, 13, 13, 15, 69 },
}
local sobol_bits = 32

local function directions(dimension)
  local v = {}
  if dimension == 1 then
    for i = 1, sobol_bits do v[i] = 1 << (sobol_bits - i) end
    return v
  end
  local row = joe_kuo[dimension - 1]
  local degree, coefficients = row[1], row[2]
  for i = 1, degree do v[i] = row[2 + i] << (sobol_bits - i) end
  for i = degree + 1, sobol_bits do
    v[i] = v[i - degree] ~ (v[i - degree] >> degree)
    for k = 1, degree - 1 do
      if (coefficients >> (degree - 1 - k)) & 1 == 1 then v[i] = v[i] ~ v[i - k] end
    end
  end
  return v
end

-- Points of Sobol's sequence in Gray code's order, from the second on, each dimension with a random digital shift.
local function sobol(dimensions, n, random)
  if dimensions > #joe_kuo + 1 then
    check.fail("method 'sobol' draws at most %d parameters, and %d are random; take 'lhs'", #joe_kuo + 1, dimensions)
  end
  local v, x, shift = {}, {}, {}
  for d = 1, dimensions do v[d], x[d], shift[d] = directions(d), 0, random.below(1 << 30) << 2 end
  local points = {}
  for i = 0, n - 1 do
    points[i + 1] = {}
    for d = 1, dimensions do points[i + 1][d] = ((x[d] ~ shift[d]) + 0.5) / 2.0 ^ sobol_bits end
    local place, rest = 1, i
    while rest & 1 == 1 do rest, place = rest >> 1, place + 1 end
    for d = 1, dimensions do x[d] = x[d] ~ v[d][place] end
  end
  return points
end

local function hypercube(dimensions, n, random)
  local points = {}
  for i = 1, n do points[i] = {} end
  for d = 1, dimensions do
    local order = {}
    for i = 1, n do order[i] = i end
    for i = n, 2, -1 do
      local k = random.below(i) + 1
      order[i], order[k] = order[k], order[i]
    end
    for i = 1, n do points[i][d] = (order[i] - 1 + random.part()) / n end
  end
  return points
end

local function plain(dimensions, n, random)
  local points = {}
  for i = 1, n do
    points[i] = {}
    for d = 1, dimensions do points[i][d] = random.part() end
  end
  return points
end

local methods = { plain = plain, lhs = hypercube, sobol = sobol }

--- n points in the unit cube by "plain", "lhs" or "sobol".
function draws.points(method, dimensions, n, seed)
  if not methods[method] then check.unknown("method", "method", method, check.keys(methods)) end
  return methods[method](dimensions, n, generator(seed))
end

--- n draws of { name =, distribution = }: a list of { name = value }.
function draws.table(random, n, seed, method)
  local list = {}
  for i, point in ipairs(draws.points(method, #random, n, seed)) do
    list[i] = {}
    for d, one in ipairs(random) do list[i][one.name] = one.distribution.quantile(point[d]) end
  end
  return list
end

return draws
