-- Response spectra against closed forms. Peaks between steps of a twentieth of a period are read from a cubic for the
-- velocity, right to 1e-5. The limits are twice that where the excitation is straight between its values. A sampled
-- sine is not: its chords are lower by (W dt)^2 / 12.
--
-- Run: lua5.4 tests/script/actions/spectrum_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local scenes = require "scenes"
local motions = require "actions.motions"
local hinge = require "hinge"
local spectrum = require "hinge.actions.spectrum"
local checks = support.checks "spectrum"
local case, near, equal, expect = checks.case, checks.near, checks.equal, checks.expect
local pi, sampled, ricker = math.pi, motions.sampled, motions.ricker

-- The largest value of a function from t1 to t2.
local function largest_of(f, t1, t2, n)
  local largest = 0
  for i = 0, n do largest = support.largest_of(largest, math.abs(f(t1 + (t2 - t1) * i / n))) end
  return largest
end

case("a step of acceleration: 1 + exp(-pi zeta / sqrt(1 - zeta^2)) times the displacement in statics", function()
  local periods = { 1e-3, 0.02, 0.3, 1, 3.9 }
  for _, zeta in ipairs { 0, 0.02, 0.05, 0.3, 0.9 } do
    local s = spectrum { dt = 0.01, acceleration = sampled(function() return -2 end, 0.01, 501), periods = periods,
      damping = zeta }
    equal(s.damping, zeta, "damping")
    for i, period in ipairs(periods) do
      local name, w = ("damping %g, period %g s"):format(zeta, period), 2 * pi / period
      local most = 1 + math.exp(-pi * zeta / math.sqrt(1 - zeta ^ 2))
      equal(s.periods[i], period, name)
      near(s.displacement[i] * w * w / 2, most, 2e-5, name .. ": displacement")
      near(s.velocity[i], w * s.displacement[i], 1e-12 * s.velocity[i], name .. ": pseudo velocity")
      near(s.acceleration[i] / 2, most, 2e-5, name .. ": pseudo acceleration")
      if zeta == 0 then near(s.absolute_acceleration[i] / 2, 2, 2e-5, name .. ": absolute acceleration") end
    end
  end
end)

-- Relative displacement from rest under a = sin W t; zeta may be 0, W = w not then.
local function under_sine(w, zeta, W)
  local wd = w * math.sqrt(1 - zeta ^ 2)
  local b, c = w * w - W * W, 2 * zeta * w * W
  local S, C = -b / (b * b + c * c), c / (b * b + c * c) -- of sin W t and cos W t, which stay
  return function(t)
    local decay = math.exp(-zeta * w * t)
    return S * math.sin(W * t) + C * math.cos(W * t)
      - decay * (C * math.cos(wd * t) + (S * W + C * zeta * w) / wd * math.sin(wd * t))
  end
end

case("a sine from rest: the closed form to 1e-3", function()
  local W, dt, n = 2 * pi, 0.005, 1601 -- 8 s; the chords are lower by (W dt)^2 / 12 = 8e-5
  local a, periods = sampled(math.sin, W * dt, n), { 0.1, 0.37, 0.8, 1.3, 2.1, 4 }
  for _, zeta in ipairs { 0, 0.05, 0.2 } do
    local s = spectrum { dt = dt, acceleration = a, periods = periods, damping = zeta }
    for i, period in ipairs(periods) do
      local u = under_sine(2 * pi / period, zeta, W)
      -- 8 s of the sine, and what is left of the motion after it: here not more
      near(s.displacement[i] / largest_of(u, 0, 8, 16000), 1, 1e-3, ("damping %g, period %g s"):format(zeta, period))
    end
  end
end)

case("resonance: without damping the response grows by pi / w^2 a cycle, with damping up to 1 / (2 zeta)", function()
  for cycles = 2, 8, 3 do
    local dt = 0.005 -- chords: 8e-5
    local s = spectrum { dt = dt, acceleration = sampled(math.sin, 2 * pi * dt, cycles * 200 + 1), periods = { 1 },
      damping = 0 }
    -- u = (sin w t - w t cos w t) / (2 w^2); u' = 0 at w t = 2 pi cycles, where the sine ends
    near(s.acceleration[1], pi * cycles, 1e-3 * pi * cycles, cycles .. " cycles")
  end
  local s = spectrum { dt = 0.005, acceleration = sampled(math.sin, 2 * pi * 0.005, 24001), periods = { 1 } }
  near(s.acceleration[1], 10, 1e-2, "5 % damping, 120 cycles: 10")
end)

case("a rectangular pulse: 2 sin(pi t / T) after it, where the ground is at rest", function()
  local a = sampled(function() return 3 end, 0.01, 21) -- 0.2 s
  for _, period in ipairs { 0.5, 1, 3, 50 } do
    local s = spectrum { dt = 0.01, acceleration = a, periods = { period }, damping = 0 }
    near(s.acceleration[1] / 3, 2 * math.sin(pi * 0.2 / period), 2e-5, ("period %g s"):format(period))
  end
end)

case("a step that rises straight over one interval: 1 + |sin(pi t / T)| / (pi t / T)", function()
  for _, period in ipairs { 0.05, 0.3, 0.5, 0.7, 3 } do
    local s = spectrum { dt = 0.4, acceleration = { 0, 1, 1, 1, 1, 1, 1, 1, 1, 1 }, periods = { period }, damping = 0 }
    local x = pi * 0.4 / period
    near(s.acceleration[1], 1 + math.abs(math.sin(x)) / x, 2e-5, ("period %g s"):format(period))
  end
end)

case("stiff oscillators have the ground's acceleration, soft ones its displacement", function()
  local a = sampled(ricker(0.5, 1), 0.01, 201)
  local s = spectrum { dt = 0.01, acceleration = a, periods = { 5e-4, 1e4 } }
  -- at the kink at the peak it swings by w^-1 times the change of slope there, 2.3 m/s^3, at most: 2e-4
  near(s.absolute_acceleration[1], 1, 2e-4, "absolute acceleration")
  near(s.acceleration[1], 1, 2e-4, "pseudo acceleration")
  local u = hinge.ground { dt = 0.01, acceleration = a }
  near(s.displacement[2] / largest_of(u, 0, 2, 2000), 1, 1e-3, "displacement: damping and a period of 1e4 s count 6e-4")
end)

case("more points on the same straight lines change nothing", function()
  local saw, fine = { 0, 3, -2, 1, 4, 4, -3, 0, 5, -1, 2, 2, -4, 3, 0 }, {}
  for i = 1, 14 do
    for k = 0, 49 do fine[50 * i + k - 49] = saw[i] + (saw[i + 1] - saw[i]) * k / 50 end
  end
  fine[701] = 0
  for _, zeta in ipairs { 0, 0.05, 0.3, 0.6 } do
    local periods = { 0.11, 0.3, 0.5, 1, 1.9, 2.3 }
    local coarse = spectrum { dt = 0.1, acceleration = saw, periods = periods, damping = zeta }
    local s = spectrum { dt = 0.002, acceleration = fine, periods = periods, damping = zeta }
    for i, period in ipairs(periods) do
      local name = ("damping %g, period %g s"):format(zeta, period)
      near(coarse.displacement[i] / s.displacement[i], 1, 2e-5, name .. ": displacement")
      near(coarse.absolute_acceleration[i] / s.absolute_acceleration[i], 1, 2e-5, name .. ": absolute acceleration")
    end
  end
end)

case("a long period with short steps keeps its digits", function()
  local ten, one = {}, sampled(ricker(0.5, 1), 1e-3, 2001)
  for i = 1, 2000 do -- the same motion in steps of 1e-5 s: w h is 6e-6
    for k = 0, 9 do ten[10 * i + k - 9] = one[i] + (one[i + 1] - one[i]) * k / 10 end
  end
  local s = spectrum { dt = 1e-3, acceleration = one, periods = { 10 } }
  local fine = spectrum { dt = 1e-4, acceleration = ten, periods = { 10 } }
  near(fine.displacement[1] / s.displacement[1], 1, 1e-5, "displacement")
end)

case("absolute acceleration with damping: the closed form of a step", function()
  local w = 2 * pi
  for _, zeta in ipairs { 0.05, 0.3 } do
    local wd = w * math.sqrt(1 - zeta ^ 2)
    -- a mass on ground that begins to be accelerated by 1: 1 + e^(-zeta w t) (zeta w / wd sin wd t - cos wd t)
    local function absolute(t)
      return 1 + math.exp(-zeta * w * t) * (zeta * w / wd * math.sin(wd * t) - math.cos(wd * t))
    end
    local most = largest_of(absolute, 0, 3, 30000)
    for dt = 0.04, 0.05, 0.001 do -- the steps meet the peak or miss it
      local s = spectrum { dt = dt, acceleration = sampled(function() return 1 end, dt, 60), periods = { 1 },
        damping = zeta }
      near(s.absolute_acceleration[1], most, 2e-5 * most, ("damping %g, dt %g s"):format(zeta, dt))
      if zeta == 0.3 then expect(most - s.acceleration[1] > 0.05, "it is not the pseudo acceleration") end
    end
  end
end)

case("times in the place of dt, also unequal ones", function()
  local f, time, a = ricker(0.5, 1), {}, {}
  local t = 0
  while t < 2 do
    time[#time + 1], a[#a + 1] = 7 + t, f(t)
    t = t + (#time % 3 == 0 and 0.0025 or 0.005)
  end
  local even = spectrum { dt = 0.0025, acceleration = sampled(f, 0.0025, 801), periods = { 0.1, 0.5, 2 } }
  local s = spectrum { time = time, acceleration = a, periods = { 0.1, 0.5, 2 } }
  for i = 1, 3 do -- chords: the pulse has a curvature of 6 (pi / 0.5 s)^2, and 5 ms of it sag by an eighth of 6e-3
    near(s.displacement[i] / even.displacement[i], 1, 1e-3, "unequal steps")
  end
  local times = sampled(function(x) return x end, 0.0025, 801)
  local same = spectrum { time = times, acceleration = sampled(f, 0.0025, 801), periods = { 0.1, 0.5, 2 } }
  for i = 1, 3 do near(same.displacement[i] / even.displacement[i], 1, 1e-9, "equal steps") end
end)

case("the spectrum of a run's probe", function()
  local model, top, _, foot = scenes.cantilever { along = { 0, 0, 1 }, member = { section = hinge.section.solid {
    width = 0.1, depth = 0.1 }, material = hinge.material { E = 2e9, density = 7850 } } }
  model:mass { node = top, mass = 500 }
  model:move { node = foot, x = hinge.ground { dt = 0.01, acceleration = sampled(ricker(0.3, 0.5), 0.01, 101) } }
  local run = model:dynamic { dt = 1e-3, duration = 1 }
  local ax = run:probe { node = top, "ax" }
  run:finish()
  local largest = largest_of(function(i) return ax.value[math.floor(i + 0.5)] end, 1, #ax.value, #ax.value - 1)
  local s = spectrum { time = ax.time, acceleration = ax.value, periods = { 1e-3, 0.1 } }
  near(s.absolute_acceleration[1] / largest, 1, 1e-3, "a stiff thing on the top has its acceleration")
  expect(largest > 0.5, "which is %g m/s^2", largest)
end)

case("the periods if there are none given: 100 from 0.02 to 4 s", function()
  local s = spectrum { dt = 0.01, acceleration = { 0, 1, 0 } }
  equal(#s.periods, 100, "periods")
  near(s.periods[1], 0.02, 1e-15, "first")
  near(s.periods[100], 4, 1e-12, "last")
  near(s.periods[51] / s.periods[50], 200 ^ (1 / 99), 1e-12, "between")
  equal(#s.displacement + #s.velocity + #s.acceleration + #s.absolute_acceleration, 400, "values")
end)

case("options of hinge.spectrum that are wrong", function()
  for words, options in pairs {
    ["field 'dt' or 'time' is missing; give one of them: 'dt', the time step in s"] = { dt = false },
    ["there are both 'dt' and 'time'"] = { time = { 0, 1 } },
    ["field 'acceleration' is missing; give a table"] = { acceleration = false },
    ["field 'acceleration' has 1 value; must have 2 or more"] = { acceleration = { 1 } },
    ["field 'acceleration[2]' is not a number (nan) m/s^2; must be a number"] = { acceleration = { 1, 0 / 0, 3 } },
    ["field 'acceleration[3]' is 'x'; must be a number, in m/s^2"] = { acceleration = { 1, 2, "x" } },
    ["field 'dt' is 0 s; must be a number above 0 s"] = { dt = 0 },
    ["field 'time[3]' is 1 s; must be above the one before, 1 s"] = { dt = false, time = { 0, 1, 1 },
      acceleration = { 1, 2, 3 } },
    ["'time' has 3 values, and 'acceleration' has 2"] = { dt = false, time = { 0, 1, 2 } },
    ["field 'periods' has 0 values; must have 1 or more"] = { periods = {} },
    ["field 'periods[2]' is 0 s; must be a number above 0 s"] = { periods = { 1, 0 } },
    ["field 'periods[2]' is 5e-05 s; must be at least 1/1000 of the longest time step, 0.0001 s"] = {
      periods = { 1, 5e-5 } },
    ["the response at a period of 1 s is too large to compute"] = { acceleration = { 1e308, -1e308, 1e308 },
      periods = { 1 } },
    ["field 'damping' is 1; must be a number of at least 0 and below 1"] = { damping = 1 },
  } do
    local given = scenes.with({ dt = 0.1, acceleration = { 1, 2 } }, options)
    for name, value in pairs(given) do given[name] = value or nil end
    checks.refused("hinge.spectrum: " .. words, spectrum, given)
  end
end)

checks.done()
