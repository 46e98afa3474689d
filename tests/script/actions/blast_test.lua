-- Blast loads: Kingery and Bulmash's values by Swisdak's fits against his tables, limits of the fits, the decay of
-- Friedlander's pulse against quadrature, oblique faces; wrong input is refused. Loads: blast_loads_test.lua.
--
-- Run: lua5.4 tests/script/actions/blast_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local scenes = require "scenes"
local blast = require "hinge".blast
local checks = support.checks "blast"
local case, near, equal, expect, refused = checks.case, checks.near, checks.equal, checks.expect, checks.refused

local function close(value, wanted, part, what) near(value, wanted, part * math.abs(wanted), what) end

-- One kilogram: distances are scaled distances.
local kilogram = blast { charge = 1, at = { 0, 0, 0 } }
local pulse_fields = { "arrival", "incident_pressure", "reflected_pressure", "duration", "incident_impulse",
  "reflected_impulse" }

-- Values ------------------------------------------------------------------------------------------------------------

-- The six digits to which this case was computed from the coefficients by another program; not 1 kg, so that values
-- scale with the charge.
case("10,000 kg at 500 m", function()
  local p = blast { charge = 10000, at = { 10, -20, 0 } }:parameters { 310, 380, 0 }
  close(p.distance, 500, 1e-12, "distance, m")
  close(p.Z, 23.208, 1e-4, "Z")
  for name, value in pairs { arrival = 1.276165, incident_pressure = 5054.96, reflected_pressure = 10244.62,
    duration = 0.133233, incident_impulse = 295.877, reflected_impulse = 528.765, incident_decay = 0.4013 } do
    close(p[name], value, 1e-4, name)
  end
end)

-- Swisdak 1994 (ADA526744), metric tables, as the tests of the Python package kingery-bulmash 1.0.1 hold them: Z, then
-- ms, kPa, kPa, ms, kPa ms and kPa ms for 1 kg. They have four digits, or three behind the point.
local tables = {
  { 0.2, 0.037, 17310.36, 185301, 0.243, 369.5, 10520 }, { 0.5, 0.143, 4888, 39422, 0.281, 166.2, 2371 },
  { 1, 0.467, 1354, 8152, 1.72, 236.3, 884.7 }, { 1.5, 0.989, 551.4, 2511, 2.148, 177.4, 520.7 },
  { 2.5, 2.557, 171.3, 547.3, 2.305, 107.5, 278 }, { 5, 8.242, 43.23, 100.9, 3.793, 59.31, 125.6 },
  { 10, 21.66, 14.89, 31.54, 4.779, 31.04, 59.33 }, { 20, 49.93, 6.102, 12.44, 5.94, 15.89, 28.67 },
  { 30, 79.07, 3.559, 7.261, 6.601, 10.65, 18.76 }, { 40, 107.8, 2.375, 4.775, 7.162, 7.885, 13.85 },
}
local units = { 1e-3, 1e3, 1e3, 1e-3, 1, 1 }
case("the tables of Swisdak's report", function()
  for _, row in ipairs(tables) do
    local p = kilogram:parameters(row[1])
    for i, name in ipairs(pulse_fields) do
      near(p[name] / units[i], row[i + 1], 5e-4 * row[i + 1] + 6e-4, ("%s at Z = %g"):format(name, row[1]))
    end
  end
  for Z, row in pairs { [50] = { 1.735, 6.221 }, [100] = { 0.654, 2.98 }, [150] = { 0.37, 1.937 } } do
    local p = kilogram:parameters(Z)
    near(p.incident_pressure / 1e3, row[1], 6e-4, "incident pressure, kPa, far away")
    near(p.incident_impulse, row[2], 6e-4 + 5e-4 * row[2], "incident impulse, kPa ms, far away")
  end
end)

-- UN SaferGuard's calculator, which has Kingery and Bulmash's own longer polynomials; read in the tests of the same
-- package. Swisdak's fits are within 1 % of them.
case("the calculator of UN SaferGuard", function()
  for _, row in ipairs {
    { 5000, 50, 57.92, 122.12, 354.22, 47.34, 1622.32, 3951.86 },
    { 10000, 50, 48.11, 202.42, 678.94, 46.8, 2518.76, 6545.98 },
    { 1000, 50, 82.45, 43.18, 100.68, 37.85, 592.56, 1255.69 } } do
    local p = blast { charge = row[1], at = { 0, 0, 0 } }:parameters(row[2])
    for i, name in ipairs(pulse_fields) do close(p[name] / units[i], row[i + 2], 0.01, name .. " of UN SaferGuard") end
  end
end)

-- Z where a fit begins, where it goes over into the next one, and where it ends.
local ends = {
  arrival = { 0.06, 1.5, 40 }, incident_pressure = { 0.2, 2.9, 23.8, 198.5 }, reflected_pressure = { 0.06, 2, 40 },
  duration = { 0.2, 1.02, 2.8, 40 }, incident_impulse = { 0.2, 0.96, 2.38, 33.7, 158.7 },
  reflected_impulse = { 0.06, 40 },
}
-- Z at which a value turns within a fit; the fits of Kingery and Bulmash have that, too.
local turns = { duration = { 0.3003, 1.277, 1.889 }, incident_impulse = { 0.5054 } }

case("values rise or fall with Z within each fit, and turn where they are known to", function()
  for name, Z in pairs(ends) do
    for i = 1, #Z - 1 do
      local found, sign, last = {}, nil, nil
      for k = 0, 400 do
        local z = Z[i] * (1 + 1e-6) * (Z[i + 1] * (1 - 2e-6) / Z[i]) ^ (k / 400)
        local value = kilogram:parameters(z)[name]
        expect(value > 0 and value < math.huge, "%s at Z = %g is %g", name, z, value)
        if last then
          if sign ~= nil and (value > last) ~= sign then found[#found + 1] = z end
          sign = value > last
        end
        last = value
      end
      local wanted = {}
      for _, z in ipairs(turns[name] or {}) do if z > Z[i] and z < Z[i + 1] then wanted[#wanted + 1] = z end end
      equal(#found, #wanted, ("turns of %s from Z = %g to %g"):format(name, Z[i], Z[i + 1]))
      for k, z in ipairs(wanted) do close(found[k] or 0 / 0, z, 0.02, name .. " turns at Z =") end
      if name ~= "duration" and name ~= "incident_impulse" then
        equal(sign, name == "arrival", name .. " rises with Z")
      end
    end
  end
end)

case("fits go over into each other with jumps below 5 %", function()
  local most = 0
  for name, Z in pairs(ends) do
    for i = 2, #Z - 1 do
      local before, after = kilogram:parameters(Z[i])[name], kilogram:parameters(Z[i] * (1 + 1e-6))[name]
      local jump = math.abs(after / before - 1)
      expect(jump > 1e-5 and jump < 0.05, "%s jumps by %.2f %% at Z = %g", name, 100 * jump, Z[i])
      most = support.largest_of(most, jump)
    end
  end
  near(most, 0.024, 5e-4, "the largest jump, of the incident impulse at 2.38")
end)

case("each value is refused outside of its own range, and the error names it", function()
  for name, Z in pairs(ends) do
    local first, last = Z[1], Z[#Z]
    local words = ("explosion:parameters: '%s' is known from Z = %g to %g m/kg^(1/3)"):format(name, first, last)
    expect(kilogram:parameters(first)[name] and kilogram:parameters(last)[name], "%s at the ends", name)
    if first > 0.06 then refused(words, function() return kilogram:parameters(0.999 * first)[name] end) end
    if last < 198.5 then refused(words, function() return kilogram:parameters(1.001 * last)[name] end) end
  end
  for _, wave in ipairs { "incident_decay", "reflected_decay" } do
    refused("'" .. wave .. "' is known from Z = 0.2 to 40", function() return kilogram:parameters(41)[wave] end)
    refused("here Z is 0.1 m/kg^(1/3), 0.1 m from 1 kg", function() return kilogram:parameters(0.1)[wave] end)
  end
  for _, Z in ipairs { 0.0599, 199 } do
    refused("must be from 0.06 to 198.5 m/kg^(1/3)", function() kilogram:parameters(Z) end)
  end
  for _, x in ipairs { 0.19, 40.1 } do
    refused("is known from Z = ", function() kilogram:pressure({ x, 0, 0 }, { -1, 0, 0 }, 0) end)
  end
end)

-- Pulses ------------------------------------------------------------------------------------------------------------

-- Simpson's rule, n even.
local function integral(f, from, to, n)
  local sum = f(from) + f(to)
  for i = 1, n - 1 do sum = sum + (i % 2 == 1 and 4 or 2) * f(from + (to - from) * i / n) end
  return sum * (to - from) / (3 * n)
end

case("the decay gives the impulse everywhere, by quadrature", function()
  for k = 0, 40 do
    local Z = k == 40 and 40 or 0.2 * 200 ^ (k / 40)
    local p = kilogram:parameters(Z)
    for _, wave in ipairs { "incident", "reflected" } do
      local b, peak = p[wave .. "_decay"], p[wave .. "_pressure"]
      local i = integral(function(t) return peak * (1 - t / p.duration) * math.exp(-b * t / p.duration) end, 0,
        p.duration, 200)
      close(i, p[wave .. "_impulse"], 1e-5, ("%s impulse at Z = %.3g"):format(wave, Z))
      -- from 1/2, the impulse of a triangle, on there would be no pulse that decays
      local full = p[wave .. "_impulse"] / (peak * p.duration)
      expect(full > 0.059 and full < 0.464 and b > 0.23 and b < 16.7, "b is %g for %g at Z = %g", b, full, Z)
    end
  end
end)

local function impulse_of(points)
  local sum = 0
  for i = 2, #points do
    sum = sum + (points[i][1] - points[i - 1][1]) * (points[i][2] + points[i - 1][2]) / 2
  end
  return sum
end

case("pulses as histories: a jump at the arrival, the impulse, and values beside the curve", function()
  local t = blast.triangle { peak = 3, duration = 0.2, arrival = 0.5 }
  equal(#t, 3, "points of a triangle")
  for i, want in ipairs { { 0.5, 0 }, { 0.5, 3 }, { 0.7, 0 } } do
    near(t[i][1], want[1], 1e-12, "time")
    near(t[i][2], want[2], 1e-12, "value")
  end
  equal(blast.triangle { peak = 1, duration = 1 }[1][1], 0, "arrival by default")
  for _, b in ipairs { 0, 1e-3, 0.4, 3, 16, 50 } do
    local points = blast.friedlander { peak = 2, duration = 0.1, decay = b, arrival = 0.3 }
    expect(points[1][1] == 0.3 and points[2][1] == 0.3 and points[1][2] == 0 and points[2][2] == 2, "the jump")
    near(points[#points][1], 0.4, 1e-12, "its end")
    equal(points[#points][2], 0, "at its end")
    local function curve(time) return 2 * (1 - time / 0.1) * math.exp(-b * time / 0.1) end
    close(impulse_of(points), integral(curve, 0, 0.1, 2000), 1e-6, ("impulse, b = %g"):format(b))
    local worst = 0
    for i = 3, #points do
      worst = support.largest_of(worst, math.abs(points[i][2] - curve(points[i][1] - 0.3)))
      expect(points[i][1] > points[i - 1][1] and points[i][2] < points[i - 1][2], "it falls")
    end
    expect(worst < 0.002 * 2 * (b > 16 and 3 or 1), "b = %g: %g beside the curve", b, worst)
  end
end)

-- A charge of 500 kg at the origin, and faces 20 m away whose normals are at an angle to the line to it.
local bomb = blast { charge = 500, at = { 0, 0, 0 } }
local there = { 20, 0, 0 }
local function turned(degrees) return { -3 * math.cos(math.rad(degrees)), 0, 3 * math.sin(math.rad(degrees)) } end

case("oblique faces: from reflected to incident, and never less", function()
  local p = bomb:parameters(there)
  local function peak(degrees) return bomb:pressure(there, turned(degrees), p.arrival) end
  close(peak(0), p.reflected_pressure, 1e-12, "across")
  for _, degrees in ipairs { 90, 120, 180 } do close(peak(degrees), p.incident_pressure, 1e-9, "along and away") end
  -- 60 degrees: cos = 1/2, so p_r / 4 + p_i (1 + 1/2 - 1/2)
  close(peak(60), p.reflected_pressure / 4 + p.incident_pressure, 1e-9, "60 degrees")
  close(peak(45), p.reflected_pressure / 2 + p.incident_pressure * math.sqrt(0.5), 1e-9, "45 degrees")
  local last = math.huge
  for degrees = 0, 90, 5 do
    local now = peak(degrees)
    expect(now < last and now >= p.incident_pressure * (1 - 1e-12), "%g degrees: %g Pa", degrees, now)
    last = now
  end
  -- a weak wave: p_r is nearly 2 p_i, and a face turned towards the charge has p_i at least
  local weak = kilogram:parameters(40)
  for degrees = 0, 90, 10 do
    expect(kilogram:pressure({ 40, 0, 0 }, turned(degrees), weak.arrival) >= weak.incident_pressure * (1 - 1e-9),
      "a weak wave at %g degrees", degrees)
  end
end)

case("the pressure over time begins at the arrival, ends with the duration and has the impulse", function()
  local p = bomb:parameters(20)
  for _, shape in ipairs { "friedlander", "triangle" } do
    for _, start in ipairs { 0, 0.1 } do
      local one = blast { charge = 500, at = { 0, 0, 0 }, shape = shape, start = start }
      for _, degrees in ipairs { 0, 50, 150 } do
        local c = support.largest_of(0, math.cos(math.rad(degrees)))
        local r, i = c ^ 2, 1 + c - 2 * c ^ 2
        local impulse = r * p.reflected_impulse + i * p.incident_impulse
        local peak = r * p.reflected_pressure + i * p.incident_pressure
        local function at(t) return one:pressure(there, turned(degrees), t) end
        local from = start + p.arrival
        local duration = shape == "triangle" and 2 * impulse / peak or p.duration
        equal(at(from - 1e-9), 0, "before it")
        close(at(from + 1e-12), peak, 1e-6, "its peak")
        expect(at(from + 0.99 * duration) > 0, "near its end")
        equal(at(from + 1.0001 * duration), 0, "after it")
        close(integral(at, from + 1e-12, from + duration - 1e-12, 200), impulse, 1e-5, shape .. ": impulse")
      end
    end
  end
end)

-- What is refused ----------------------------------------------------------------------------------------------------

case("wrong input is refused", function()
  for words, options in pairs {
    ["field 'charge' is missing"] = { charge = false }, ["field 'at' is {1, 2}"] = { at = { 1, 2 } },
    ["'charge' is 0 kg; must be a number above 0 kg"] = { charge = 0 },
    ["field 'at' is missing; give 3 numbers in braces, in m"] = { at = false },
    ["must be 'surface', a hemispherical charge on the ground; there is no other"] = { kind = "air" },
    ["must be one of friedlander, triangle"] = { shape = "square" },
    ["the negative phase is not there"] = { negative = true },
    ["field 'start' is 'now'"] = { start = "now" },
  } do
    local given = scenes.with({ charge = 1, at = { 0, 0, 0 } }, options)
    given.charge, given.at = given.charge or nil, given.at or nil
    refused(words, function() blast(given) end)
  end
  for words, call in pairs {
    ["hinge.blast: takes no further argument"] = function() blast({ charge = 1, at = { 0, 0, 0 } }, 1) end,
    ["hinge.blast: unknown field 'square'"] = function() return blast.square end,
    ["explosion: unknown field 'loads' (did you mean 'load'?)"] = function() return bomb.loads end,
    ["explosion:pressure: called on {1}; write explosion:pressure(...)"] = function() bomb.pressure { 1 } end,
    ["field 'distance' is 0 m; must be a number above 0 m"] = function() bomb:parameters(0) end,
    ["field 'point' is {1}"] = function() bomb:parameters { 1 } end,
    ["unknown field 'peak'"] = function() return bomb:parameters(20).peak end,
    ["field 'normal' is {0, 0, 0}; must be the direction out of the face"] =
      function() bomb:pressure(there, { 0, 0, 0 }, 0) end,
    ["field 'time' is missing"] = function() bomb:pressure(there, { 1, 0, 0 }) end,
    ["hinge.blast.triangle: field 'peak' is missing"] = function() blast.triangle { duration = 1 } end,
    ["hinge.blast.triangle: field 'duration' is 0 s; must be a number above 0 s"] =
      function() blast.triangle { peak = 1, duration = 0 } end,
    ["field 'decay' is -1; must be a number of at least 0 and of at most 50"] =
      function() blast.friedlander { peak = 1, duration = 1, decay = -1 } end,
    ["field 'decay' is missing"] = function() blast.friedlander { peak = 1, duration = 1 } end,
  } do
    refused(words, call)
  end
end)

checks.done()
