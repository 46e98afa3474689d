-- Draws of a study: Sobol's sequence by Joe and Kuo's list, what a seed changes, and quantiles of distributions.
--
-- Read for it: the first rows of new-joe-kuo-6.21201, as public programs have them, and the recurrence of the
-- direction numbers in Joe and Kuo's notes on the list.
--
-- Run: lua5.4 tests/script/study/draws_test.lua BUILD, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
require "hinge"
local draws = require "hinge.study.draws"
local checks = support.checks "draws"
local case, near, equal, expect = checks.case, checks.near, checks.equal, checks.expect

-- d, s, a, m_i
local list = [[
2 1 0 1
3 2 1 1 3
4 3 1 1 3 1
5 3 2 1 1 1
6 4 1 1 1 3 3
7 4 4 1 3 5 13
8 5 2 1 1 5 5 17
9 5 4 1 1 5 5 5
10 5 7 1 1 7 11 19
11 5 11 1 1 5 1 1
12 5 13 1 1 1 3 11
13 5 14 1 3 5 5 31
14 6 1 1 3 3 9 7 49
15 6 13 1 1 1 15 21 21
16 6 16 1 3 1 13 27 49
17 6 19 1 1 1 15 7 5
18 6 22 1 3 1 15 13 25
19 6 25 1 1 5 5 19 61
20 7 1 1 3 7 11 23 15 103
21 7 4 1 3 7 13 13 15 69]]

-- The points without their random shift, as whole numbers of 32 bits: each is combined with the first one.
local function unshifted(n, seed)
  local points, bits = draws.points("sobol", 21, n, seed), {}
  for i, point in ipairs(points) do
    bits[i] = {}
    for d = 1, 21 do bits[i][d] = math.floor(point[d] * 2.0 ^ 32) ~ math.floor(points[1][d] * 2.0 ^ 32) end
  end
  return bits
end

case("the first points of three dimensions are those that Joe and Kuo print", function()
  local printed = { { 0, 0, 0 }, { 0.5, 0.5, 0.5 }, { 0.75, 0.25, 0.25 }, { 0.25, 0.75, 0.75 },
    { 0.375, 0.375, 0.625 }, { 0.875, 0.875, 0.125 }, { 0.625, 0.125, 0.875 }, { 0.125, 0.625, 0.375 },
    { 0.1875, 0.3125, 0.9375 }, { 0.6875, 0.8125, 0.4375 } }
  for _, seed in ipairs { 1, 7 } do
    for i, point in ipairs(unshifted(#printed, seed)) do
      for d = 1, 3 do
        equal(point[d] / 2.0 ^ 32, printed[i][d], ("point %d, dimension %d, seed %d"):format(i, d, seed))
      end
    end
  end
end)

case("the direction numbers of 21 dimensions are those of Joe and Kuo's list", function()
  local n = 12 -- direction numbers of each dimension
  local points = unshifted(1 << n, 1)
  -- in Gray code's order point k + 1 is the sum of the direction numbers of the bits of k ~ (k >> 1); the place where
  -- bit i alone is set:
  local function direction(i, d)
    local k, bit = 0, 1 << (i - 1)
    while bit > 0 do k, bit = k ~ bit, bit >> 1 end
    return points[k + 1][d] >> (32 - i)
  end
  for i = 1, n do equal(direction(i, 1), 1, "van der Corput's, " .. i) end
  local rows = 0
  for row in list:gmatch "[^\n]+" do
    local numbers = {}
    for word in row:gmatch "%d+" do numbers[#numbers + 1] = math.tointeger(word) end
    local d, s, a, m = numbers[1], numbers[2], numbers[3], { table.unpack(numbers, 4) }
    equal(#m, s, "numbers of dimension " .. d)
    for i = s + 1, n do -- m_i = 2 a_1 m_(i-1) + 2^2 a_2 m_(i-2) + ... + 2^s m_(i-s) + m_(i-s), by exclusive or
      m[i] = m[i - s] ~ (m[i - s] << s)
      for k = 1, s - 1 do m[i] = m[i] ~ (((a >> (s - 1 - k)) & 1) * m[i - k] << k) end
    end
    for i = 1, n do equal(direction(i, d), m[i], ("dimension %d, number %d"):format(d, i)) end
    rows = rows + 1
  end
  equal(rows, 20, "rows of the list")
end)

case("the shift of Sobol's points comes from the seed, and each method's draws do", function()
  for _, method in ipairs { "plain", "lhs", "sobol" } do
    local function text(seed)
      local words = {}
      for _, point in ipairs(draws.points(method, 3, 16, seed)) do
        for d = 1, 3 do words[#words + 1] = ("%.17g"):format(point[d]) end
      end
      return table.concat(words, " ")
    end
    equal(text(5), text(5), method .. ": a seed gives the same draws")
    expect(text(5) ~= text(6), "%s: another seed gives others", method)
    for _, point in ipairs(draws.points(method, 3, 64, 5)) do
      for d = 1, 3 do expect(point[d] > 0 and point[d] < 1, "%s: within 0 and 1: %g", method, point[d]) end
    end
  end
  -- a table of parameters goes with the seed
  local one = { { name = "v", distribution = draws.distribution("uniform(10, 20)", "test") } }
  equal(draws.table(one, 4, 3, "lhs")[2].v, draws.table(one, 4, 3, "lhs")[2].v, "the same table")
  expect(draws.table(one, 4, 3, "lhs")[2].v ~= draws.table(one, 4, 4, "lhs")[2].v, "another table")
end)

case("hinge study --seed: the same seed has the same cases, another one others", function()
  local folder = support.temporary_folder()
  support.write(folder .. "/one.lua", [[
    local hinge = require "hinge"
    return hinge.scenario { parameters = { v = 1.5 }, run = function(p)
      local model = hinge.model {}
      local a, b = model:node { 0, 0, 0 }, model:node { 1, 0, 0 }
      model:fix(a)
      model:member { a, b, section = hinge.section.solid { width = 0.1, depth = 0.1 },
        material = hinge.material { E = p.v * 1e11 } }
      model:load { node = b, force = { 0, 0, 1 } }
      model:static { steps = 1 }:finish()
      return { stiffness = p.v }
    end }
  ]])
  local program = support.quote(arg[1] .. "/hinge")
  local function values(out, more)
    local status, _, complaint = support.run(("cd %s && %s study one.lua 'v~uniform(1,2)' --samples 5 --out %s %s")
      :format(support.quote(folder), program, out, more))
    equal(status, 0, "exit status: " .. complaint)
    local found, text = {}, support.read(folder .. "/" .. out .. "/results.csv") or ""
    for line in text:gmatch "[^\n]+" do
      local first = line:match "^[^,]*,([%d.]+),"
      if first then found[#found + 1] = first end
    end
    equal(#found, 5, "cases of " .. out .. ": " .. text)
    return table.concat(found, " ")
  end
  local default = values("a", "")
  equal(values("b", "--seed 1"), default, "the default is 1")
  equal(values("c", "--seed 9"), values("d", "--seed 9"), "the same seed")
  expect(values("e", "--seed 9") ~= default, "another seed: %s", default)
  expect(values("f", "--seed 9 --method sobol") ~= values("g", "--seed 8 --method sobol"), "Sobol's, too")
end)

case("impossible numbers of distributions are refused, one by one", function()
  for _, r in ipairs { { "normal(1, 2)", true }, { "normal(1, 0)", false }, { "normal(1, -2)", false },
    { "lognormal(1, 2)", true }, { "lognormal(-1, 2)", false }, { "lognormal(1, -2)", false },
    { "uniform(1, 2)", true }, { "uniform(2, 1)", false }, { "uniform(1, 1)", false },
    { "triangular(0, 1, 2)", true }, { "triangular(0, 0, 2)", true }, { "triangular(0, 2, 2)", true },
    { "triangular(0, -1, 2)", false }, { "triangular(0, 3, 2)", false }, { "triangular(1, 1, 1)", false },
    { "weibull(1, 2)", true }, { "weibull(-1, 2)", false }, { "weibull(1, -2)", false }, { "weibull(1)", false },
    { "normal(1, 2, 3)", false }, { "normal(a, 2)", false } } do
    equal(pcall(draws.distribution, r[1], "test"), r[2], r[1])
  end
  -- numbers of the generator lie strictly within 0 and 1, also those whose bits are all 0: none is below half of 2^-53
  local random = draws.generator(11)
  for _ = 1, 2000 do
    local u = random.part()
    expect(u > 0 and u < 1, "%.17g", u)
    local whole = u * 2.0 ^ 53
    expect(whole - math.floor(whole) == 0.5 or u > 0.5, "in the middle of its cell: %.17g", u)
    local k = random.below(7)
    expect(math.type(k) == "integer" and k >= 0 and k < 7, "below 7: %s", k)
  end
  -- its first numbers, by splitmix64 and xorshift64* in another way: with products of 32 bit parts
  local function times(a, b) -- a b modulo 2^64
    local low, high = b & 0xffffffff, (b >> 32) & 0xffffffff
    return (a * low) + ((a * high) << 32)
  end
  local z = 11 + 0x9e3779b97f4a7c15
  z = times(z ~ (z >> 30), 0xbf58476d1ce4e5b9)
  z = times(z ~ (z >> 27), 0x94d049bb133111eb)
  z = z ~ (z >> 31)
  local again = draws.generator(11)
  for i = 1, 5 do
    z = z ~ (z >> 12)
    z = z ~ (z << 25)
    z = z ~ (z >> 27)
    equal(again.part(), ((times(z, 0x2545f4914f6cdd1d) >> 11) + 0.5) * 2.0 ^ -53, "number " .. i)
  end
end)

case("quantiles of distributions by their own formulas", function()
  local function quantile(text, u) return draws.distribution(text, "test").quantile(u) end
  near(quantile("normal(10, 2)", 0.5), 10, 1e-12, "normal: mean")
  near(quantile("normal(10, 2)", 0.8413447460685429), 12, 1e-9, "normal: one deviation above")
  near(quantile("normal(10, 2)", 0.15865525393145707), 8, 1e-9, "normal: one below")
  near(quantile("lognormal(100, 0.5)", 0.8413447460685429), 100 * math.exp(0.5), 1e-7, "lognormal")
  near(quantile("uniform(3, 7)", 0.25), 4, 1e-12, "uniform")
  near(quantile("triangular(0, 1, 4)", 0.25), 1, 1e-12, "triangular: at the likeliest value")
  near(quantile("triangular(0, 1, 4)", 0.0625), 0.5, 1e-12, "triangular: below it")
  near(quantile("triangular(0, 1, 4)", 1 - 1 / 12), 3, 1e-12, "triangular: above it") -- (4 - 3)^2 / (4 3)
  near(quantile("weibull(10, 2)", 1 - math.exp(-4)), 20, 1e-9, "Weibull: scale (-ln(1 - u))^(1 / shape)")
  -- the normal distribution's part below x on each side of the change of formula at 3
  for x, part in pairs { [-1] = 0.15865525393145707, [2.5] = 0.9937903346742238, [2.999] = 0.998645,
    [3.5] = 0.9997673709209645, [-4] = 3.167124183311992e-05 } do
    near(draws.normal_part(x), part, x == 2.999 and 1e-6 or 1e-14, "part below " .. x)
  end
end)

checks.done()
