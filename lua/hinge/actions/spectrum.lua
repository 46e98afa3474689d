-- hinge.spectrum: elastic response spectrum. The oscillator u'' + 2 zeta w u' + w^2 u = -a is integrated exactly for an
-- acceleration that is straight between its values (Nigam and Jennings, Calculation of response spectra from
-- strong-motion earthquake records, Bull. Seism. Soc. Am. 59, 1969).
local check = require "hinge.library.check"

local where = "hinge.spectrum"
local parts = 20 -- of a period: no step is longer than this part. Peaks between steps are then right to 1e-5
local most_periods = 1000 -- in a time step, which takes 20,000 steps then
local terms = 16 -- of the power series over a step: w h is 2 pi / 20 at most, so the rest is below 1e-17

-- u and v after a step h from u0 and v0, while the acceleration goes straight from p to q. A power series in the time:
-- the closed form divides small differences by (w h)^3, and loses its digits where the period is long.
local function after_step(w, zeta, h, u0, v0, p, q)
  local damped, stiff = 2 * zeta * w * h, (w * h) ^ 2
  local term, next_term = u0, v0 * h -- of degree k and k + 1
  local u, vh = u0 + next_term, next_term
  for k = 0, terms do
    local load = k == 0 and p or k == 1 and q - p or 0
    term, next_term = next_term,
      -(damped * (k + 1) * next_term + stiff * term + load * h * h) / ((k + 1) * (k + 2))
    u, vh = u + next_term, vh + (k + 2) * next_term
  end
  return u, vh / h
end

-- How an interval of `length` is done: `count` steps h, each by eight coefficients. u = uu u0 + uv v0 + up p + uq q,
-- and v likewise.
local function step_of(w, zeta, length)
  local count = math.ceil(length * parts * w / (2 * math.pi) * (1 - 1e-12))
  local h = length / count
  local s = { count = count, h = h }
  for name, start in pairs { u = { 1, 0, 0, 0 }, v = { 0, 1, 0, 0 }, p = { 0, 0, 1, 0 }, q = { 0, 0, 0, 1 } } do
    s["u" .. name], s["v" .. name] = after_step(w, zeta, h, table.unpack(start))
  end
  return s
end

-- The size of the extremum of f within a step h. f0 is the value at its start. d is the rate of f, which changes its
-- sign, and s is the rate of d, at both ends. d is taken as the cubic that these four give. Halving finds its root.
local function extremum(h, f0, d0, s0, d1, s1)
  local c1, c2, c3 = h * s0, 3 * (d1 - d0) - h * (2 * s0 + s1), 2 * (d0 - d1) + h * (s0 + s1)
  local low, high = 0, 1
  while high - low > 1e-4 do
    local x = (low + high) / 2
    if (d0 + x * (c1 + x * (c2 + x * c3))) * d0 > 0 then low = x else high = x end
  end
  return math.abs(f0 + h * low * (d0 + low * (c1 / 2 + low * (c2 / 3 + low * c3 / 4))))
end

-- The largest relative displacement and the largest absolute acceleration, z = 2 zeta w v + w^2 u, of one oscillator.
-- After the last value the ground is not accelerated any more: one period of free vibration follows.
local function peaks_of(w, zeta, motion)
  local a, kinds, steps = motion.acceleration, motion.kinds, {}
  for kind, length in ipairs(motion.lengths) do steps[kind] = step_of(w, zeta, length) end
  local c, k = 2 * zeta * w, w * w
  local u, v, z, largest_u, largest_z = 0, 0, 0, 0, 0
  for i = 1, #a do
    local p, q, s = a[i], a[i + 1], steps[kinds[i]]
    if i == #a then p, q, s = 0, 0, step_of(w, zeta, 2 * math.pi / w) end
    local rise, h = (q - p) / s.count, s.h
    local slope = rise / h
    for _ = 1, s.count do
      q = p + rise
      local u1, v1 = s.uu * u + s.uv * v + s.up * p + s.uq * q, s.vu * u + s.vv * v + s.vp * p + s.vq * q
      local z1 = c * v1 + k * u1
      local r, r1 = -p - z, -q - z1 -- relative accelerations
      local d, d1 = c * r + k * v, c * r1 + k * v1 -- rates of z
      largest_u, largest_z = math.max(largest_u, math.abs(u1)), math.max(largest_z, math.abs(z1))
      if v * v1 < 0 then largest_u = math.max(largest_u, extremum(h, u, v, r, v1, r1)) end
      if d * d1 < 0 then
        largest_z = math.max(largest_z, extremum(h, z, d, k * r - c * (d + slope), d1, k * r1 - c * (d1 + slope)))
      end
      u, v, z, p = u1, v1, z1, q
    end
  end
  if not (math.abs(u) < math.huge and largest_u < math.huge and largest_z < math.huge) then
    check.fail("%s: the response at a period of %g s is too large to compute; look at the accelerations, in m/s^2",
      where, 2 * math.pi / w)
  end
  return largest_u, largest_z
end

-- Checks a list of `least` or more numbers, each by a rule of check.value.
local function list_of(field, list, least, rule)
  if #list < least then
    check.fail("%s: field '%s' has %s; must have %d or more", where, field, check.count(#list, "value"), least)
  end
  for i = 1, #list do check.value(where, ("%s[%d]"):format(field, i), list[i], rule) end
  return list
end

-- Times as a list of different lengths, and the kind of length that each interval has. Lengths that differ by less than
-- a millionth of the shortest one are one: the times of a run are sums with rounding errors.
local function intervals(time)
  local lengths, kinds, known, shortest = {}, {}, {}, math.huge
  for i = 2, #time do
    local length = time[i] - time[i - 1]
    if not (length > 0) then
      check.fail("%s: field 'time[%d]' is %s s; must be above the one before, %s s", where, i, check.show(time[i]),
        check.show(time[i - 1]))
    end
    shortest = math.min(shortest, length)
  end
  for i = 2, #time do
    local length = time[i] - time[i - 1]
    local key = math.floor(length / shortest * 1e6 + 0.5)
    if not known[key] then
      lengths[#lengths + 1] = length
      known[key] = #lengths
    end
    kinds[i - 1] = known[key]
  end
  return lengths, kinds
end

-- 100 periods from 0.02 to 4 s, at equal steps of the logarithm.
local function default_periods()
  local periods = {}
  for i = 0, 99 do periods[i + 1] = 0.02 * 200 ^ (i / 99) end
  return periods
end

-- What is shaken: accelerations, the lengths of time between them, and which of these each interval has.
local function motion_of(o)
  if (o.dt == nil) == (o.time == nil) then
    check.fail("%s: %s; give one of them: 'dt', the time step in s, or 'time', a list of times in s", where,
      o.dt and "there are both 'dt' and 'time'" or "field 'dt' or 'time' is missing")
  end
  local a = list_of("acceleration", o.acceleration, 2, { "number", unit = "m/s^2" })
  if o.time then
    list_of("time", o.time, 2, { "number", unit = "s" })
    if #o.time ~= #a then
      check.fail("%s: 'time' has %d values, and 'acceleration' has %d", where, #o.time, #a)
    end
    local lengths, kinds = intervals(o.time)
    return { acceleration = a, lengths = lengths, kinds = kinds }
  end
  local kinds = {}
  for i = 1, #a - 1 do kinds[i] = 1 end
  return { acceleration = a, lengths = { o.dt }, kinds = kinds }
end

-- The periods that are asked for.
local function periods_of(o, motion)
  local periods = list_of("periods", o.periods or default_periods(), 1, { "number", unit = "s", above = 0 })
  local longest = 0
  for _, length in ipairs(motion.lengths) do longest = math.max(longest, length) end
  for i, period in ipairs(periods) do
    if period * most_periods < longest then
      check.fail("%s: field 'periods[%d]' is %g s; must be at least 1/%d of the longest time step, %g s", where, i,
        period, most_periods, longest / most_periods)
    end
  end
  return periods
end

return function(options, ...)
  check.no_more(where, ...)
  local o = check.options(where, options, {
    dt = { "number", unit = "s", above = 0, optional = true },
    time = { "table", optional = true },
    acceleration = { "table" },
    periods = { "table", optional = true },
    damping = { "number", at_least = 0, below = 1, default = 0.05 },
  })
  local motion = motion_of(o)
  local periods = periods_of(o, motion)
  local result = { periods = {}, displacement = {}, velocity = {}, acceleration = {}, absolute_acceleration = {},
    damping = o.damping }
  for i, period in ipairs(periods) do
    local w = 2 * math.pi / period
    local u, z = peaks_of(w, o.damping, motion)
    result.periods[i], result.displacement[i], result.absolute_acceleration[i] = period, u, z
    result.velocity[i], result.acceleration[i] = w * u, w * w * u
  end
  return check.strict(result, "spectrum of " .. where)
end
