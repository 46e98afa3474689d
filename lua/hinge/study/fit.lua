-- What many cases say together: a fragility curve with its band, and how much each parameter matters.
local draws = require "hinge.study.draws"

local fit = {}

-- Newton's method for the probit or logit coefficients of P(true) = Phi(a + b x); weights are the cases.
local function probit(x, y)
  local n, mean, deviation = #x, 0, 0
  for i = 1, n do mean = mean + x[i] / n end
  for i = 1, n do deviation = deviation + (x[i] - mean) ^ 2 / n end
  deviation = math.sqrt(deviation)
  if deviation == 0 then return nil end
  local a, b = 0, 0
  local H11, H12, H22
  for _ = 1, 100 do
    local g1, g2 = 0, 0
    H11, H12, H22 = 0, 0, 0
    for i = 1, n do
      local z = (x[i] - mean) / deviation
      local eta = math.max(-6, math.min(6, a + b * z))
      local p = math.max(1e-12, math.min(1 - 1e-12, draws.normal_part(eta)))
      local density = math.exp(-eta * eta / 2) / math.sqrt(2 * math.pi)
      local slope, weight = density * (y[i] - p) / (p * (1 - p)), density * density / (p * (1 - p))
      g1, g2 = g1 + slope, g2 + slope * z
      H11, H12, H22 = H11 + weight, H12 + weight * z, H22 + weight * z * z
    end
    local determinant = H11 * H22 - H12 * H12
    if not (determinant > 1e-12) then return nil end
    local da, db = (H22 * g1 - H12 * g2) / determinant, (H11 * g2 - H12 * g1) / determinant
    local long = math.max(1, math.max(math.abs(da), math.abs(db)) / 1)
    a, b = a + da / long, b + db / long
    if math.abs(b) > 50 then return nil end -- the two sides do not overlap: any steep curve fits
    if math.abs(da) + math.abs(db) < 1e-10 then break end
  end
  local determinant = H11 * H22 - H12 * H12
  return { a = a, b = b, mean = mean, deviation = deviation,
    covariance = { H22 / determinant, -H12 / determinant, H11 / determinant } }
end

-- Whether a curve explains the cases better than one chance for all of them: the ratio of likelihoods, 95 %.
local function better_than_chance(p, t, y, ones)
  local all, gain = ones / #y, 0
  for i, value in ipairs(t) do
    local chance = draws.normal_part(p.a + p.b * (value - p.mean) / p.deviation)
    gain = gain + (y[i] == 1 and math.log(math.max(chance, 1e-300) / all)
      or math.log(math.max(1 - chance, 1e-300) / (1 - all)))
  end
  return 2 * gain > 3.841458820694124
end

-- Why there is no curve where the outcomes do not overlap: between which values they change.
function fit.step(x, y)
  local highest, lowest = { [0] = -math.huge, [1] = -math.huge }, { [0] = math.huge, [1] = math.huge }
  for i, value in ipairs(x) do
    highest[y[i]], lowest[y[i]] = math.max(highest[y[i]], value), math.min(lowest[y[i]], value)
  end
  local low, high = math.min(highest[0], highest[1]), math.max(lowest[0], lowest[1])
  if not (low < high) then return "the cases show no trend; more of them would tell" end
  return ("the outcome changes between %.5g and %.5g, without scatter; more cases between them, or random draws of "
    .. "what is uncertain, would tell"):format(low, high)
end

--- The chance that `y` (numbers 0 and 1) is 1 as a function of x: a normal distribution's, or that of log x where
-- all x are positive (lognormal), by maximum likelihood. Returns { median =, dispersion =, log =, at = function(x) ->
-- chance, low, high }: a band that holds the curve with 95 % at each x (from the information matrix); nil and why where
-- the cases do not tell.
function fit.fragility(x, y, as_log)
  local ones = 0
  for i = 1, #y do ones = ones + y[i] end
  if ones == 0 or ones == #y then return nil, ("all %d cases have the same outcome"):format(#y) end
  local t = {}
  for i = 1, #x do t[i] = as_log and math.log(x[i]) or x[i] end
  local p = probit(t, y)
  if not p or p.b == 0 then return nil, fit.step(x, y) end
  if not better_than_chance(p, t, y, ones) then
    return nil, "the cases show no trend beyond chance (95 %); more of them, or other values, would tell"
  end
  local median = p.mean - p.a / p.b * p.deviation
  return {
    median = as_log and math.exp(median) or median, dispersion = p.deviation / math.abs(p.b), log = as_log or false,
    at = function(value)
      local z = ((as_log and math.log(value) or value) - p.mean) / p.deviation
      local eta, c = p.a + p.b * z, p.covariance
      local error = 1.959963984540054 * math.sqrt(math.max(0, c[1] + 2 * z * c[2] + z * z * c[3]))
      return draws.normal_part(eta), draws.normal_part(eta - error), draws.normal_part(eta + error)
    end,
  }
end

-- Ranks from 1, equal values sharing the mean of theirs.
local function ranks(list)
  local order, result = {}, {}
  for i = 1, #list do order[i] = i end
  table.sort(order, function(a, b) return list[a] < list[b] or list[a] == list[b] and a < b end)
  local i = 1
  while i <= #order do
    local k = i
    while k < #order and list[order[k + 1]] == list[order[i]] do k = k + 1 end
    for m = i, k do result[order[m]] = 0.5 * (i + k) end
    i = k + 1
  end
  return result
end

--- Spearman's rank correlation of two lists, -1 to 1; nil where one of them does not vary.
function fit.rank_correlation(x, y)
  local rx, ry, n = ranks(x), ranks(y), #x
  local sxy, sxx, syy, middle = 0, 0, 0, 0.5 * (n + 1)
  for i = 1, n do
    sxy = sxy + (rx[i] - middle) * (ry[i] - middle)
    sxx, syy = sxx + (rx[i] - middle) ^ 2, syy + (ry[i] - middle) ^ 2
  end
  if sxx == 0 or syy == 0 then return nil end
  return sxy / math.sqrt(sxx * syy)
end

return fit
