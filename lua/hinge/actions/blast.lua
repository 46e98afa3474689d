-- hinge.blast: the pressure of an explosion on the ground, and loads on members from it.
--
-- Peaks, times and impulses: M. Swisdak, Simplified Kingery Airblast Calculations, Naval Surface Warfare Center, 1994
-- (ADA526744), hemispherical charges of TNT on the ground, metric. The report was not at hand. The coefficients are
-- those that the Python package kingery-bulmash 1.0.1 gives; its tests hold the tables of the report, which agree
-- (blast_test.lua).
--
-- Oblique faces: p = p_r c^2 + p_i (1 + c - 2 c^2), where c is the cosine of the angle of incidence. Two programs with
-- the ConWep model (OpenRadioss, Aero-S) have this. The source that is usually named, G. Randers-Pehrson and K.
-- Bannister, Airblast Loading Model for DYNA2D and DYNA3D, ARL-TR-1310, 1997, was not at hand: not confirmed. The same
-- formula is also printed with 1 + c^2 - 2 c. That cannot be right: in a weak wave, p_r = 2 p_i, a face turned towards
-- the charge would then have as little as 2/3 of the incident pressure.
local check = require "hinge.library.check"
local vectors = require "hinge.library.vectors"
local faces = require "hinge.actions.faces"
local chosen = require "hinge.model.chosen_members"

local blast = {}

local length = { "number", unit = "m", above = 0 }
local point_rule = { "numbers", count = 3, unit = "m" }
local even = 0.2 -- of the pressure in the middle of a member: the most that it may differ along the member
local intervals = 60 -- of a history
local largest_decay = 50 -- at which the history with that many intervals still follows the pulse

-- Kingery and Bulmash -------------------------------------------------------------------------------------------------

-- Each value is unit * exp(sum of c_i (ln Z)^i), times W^(1/3) where `scaled`: from Z, to Z in m/kg^(1/3), c_0, c_1 ...
local quantities = {
  arrival = { unit = 1e-3, scaled = true,
    { 0.06, 1.5, -0.7604, 1.8058, 0.1257, -0.0437, -0.0310, -0.00669 },
    { 1.5, 40, -0.7137, 1.5732, 0.5561, -0.4213, 0.1054, -0.00929 } },
  incident_pressure = { unit = 1e3,
    { 0.2, 2.9, 7.2106, -2.1069, -0.3229, 0.1117, 0.0685 },
    { 2.9, 23.8, 7.5938, -3.0523, 0.40977, 0.0261, -0.01267 },
    { 23.8, 198.5, 6.0536, -1.4066 } },
  reflected_pressure = { unit = 1e3,
    { 0.06, 2, 9.006, -2.6893, -0.6295, 0.1011, 0.29255, 0.13505, 0.019736 },
    { 2, 40, 8.8396, -1.733, -2.64, 2.293, -0.8232, 0.14247, -0.0099 } },
  duration = { unit = 1e-3, scaled = true,
    { 0.2, 1.02, 0.5426, 3.2299, -1.5931, -5.9667, -4.0815, -0.9149 },
    { 1.02, 2.8, 0.5440, 2.7082, -9.7354, 14.3425, -9.7791, 2.8535 },
    { 2.8, 40, -2.4608, 7.1639, -5.6215, 2.2711, -0.44994, 0.03486 } },
  incident_impulse = { unit = 1, scaled = true,
    { 0.2, 0.96, 5.522, 1.117, 0.6, -0.292, -0.087 },
    { 0.96, 2.38, 5.465, -0.308, -1.464, 1.362, -0.432 },
    { 2.38, 33.7, 5.2749, -0.4677, -0.2499, 0.0588, -0.00554 },
    { 33.7, 158.7, 5.9825, -1.062 } },
  reflected_impulse = { unit = 1, scaled = true,
    { 0.06, 40, 6.7853, -1.3466, 0.101, -0.01123 } },
}

-- The ranges of Z of all values that parameters may have.
local ranges = { incident_decay = { 0.2, 40 }, reflected_decay = { 0.2, 40 } }
for name, quantity in pairs(quantities) do ranges[name] = { quantity[1][1], quantity[#quantity][2] } end

-- A value by its fit, or nil where there is none. A distance of 0.2 W^(1/3) is within the range from 0.2.
local function value_of(quantity, Z, root)
  local slack = 1e-9 * Z
  if Z < quantity[1][1] - slack then return nil end
  for _, fit in ipairs(quantity) do
    if Z <= fit[2] + slack then
      local sum, x = 0, math.log(Z)
      for i = #fit, 3, -1 do sum = sum * x + fit[i] end
      return quantity.unit * math.exp(sum) * (quantity.scaled and root or 1)
    end
  end
end

-- The impulse of a Friedlander pulse over its peak times its duration: 1/b - (1 - e^-b)/b^2, 1/2 for b = 0.
local function fullness(b)
  if b < 0.01 then return 1 / 2 - b / 6 + b ^ 2 / 24 - b ^ 3 / 120 + b ^ 4 / 720 end
  return (b - 1 + math.exp(-b)) / b ^ 2
end

-- The decay b of a Friedlander pulse with this fullness. It falls with b from 1/2 at 0, and is below 1/b. In the whole
-- range of the fits it is between 0.059 and 0.464, so that there is one solution (blast_test.lua).
local function decay_of(full)
  local low, high = 0, 1 / full
  for _ = 1, 60 do
    local middle = (low + high) / 2
    if fullness(middle) > full then low = middle else high = middle end
  end
  return (low + high) / 2
end

-- The error of a value that parameters do not have.
local function missing(where, p, name)
  local range = ranges[name]
  if not range then
    local names = check.keys(ranges)
    table.move({ "Z", "distance" }, 1, 2, #names + 1, names)
    check.unknown(where, "field", name, names)
  end
  check.fail("%s: '%s' is known from Z = %g to %g m/kg^(1/3); here Z is %.6g m/kg^(1/3), %.6g m from %.6g kg", where,
    name, range[1], range[2], p.Z, p.distance, p.distance ^ 3 / p.Z ^ 3)
end

-- What is known at a distance (m). What is not known there is an error when it is read.
local function parameters_at(self, where, distance)
  local root = self.charge ^ (1 / 3)
  local p = { distance = distance, Z = distance / root }
  local known = false
  for name, quantity in pairs(quantities) do
    p[name] = value_of(quantity, p.Z, root)
    known = known or p[name] ~= nil
  end
  if not known then
    check.fail("%s: %.6g m from %.6g kg is Z = %.6g m/kg^(1/3); must be from 0.06 to 198.5 m/kg^(1/3), here %.4g to "
      .. "%.4g m", where, distance, self.charge, p.Z, 0.06 * root, 198.5 * root)
  end
  if p.duration then
    for _, wave in ipairs { "incident", "reflected" } do
      p[wave .. "_decay"] = decay_of(p[wave .. "_impulse"] / (p[wave .. "_pressure"] * p.duration))
    end
  end
  return setmetatable(p, { __index = function(t, name) missing(where, t, name) end })
end

-- Pulses --------------------------------------------------------------------------------------------------------------

-- A sum of Friedlander pulses of one duration, { peak, decay }, `s` seconds after their arrival.
local function friedlander_at(parts, duration, s)
  if s < 0 or s >= duration then return 0 end
  local sum = 0
  for _, part in ipairs(parts) do sum = sum + part[1] * math.exp(-part[2] * s / duration) end
  return (1 - s / duration) * sum
end

-- The pulse as points { time, value }, denser where it falls fast. Straight lines between points of a hollow curve have
-- too much impulse; the points between the first and the last are lowered together so that the impulse is exact.
local function points_of(pulse)
  local points = { { pulse.arrival, 0 }, { pulse.arrival, pulse.peak } }
  if pulse.triangle then
    points[3] = { pulse.arrival + pulse.duration, 0 }
    return points
  end
  local times, values, sum = { [0] = 0 }, { [0] = pulse.peak }, 0
  for i = 1, intervals do
    times[i] = pulse.duration * (i / intervals) ^ 2
    values[i] = friedlander_at(pulse.parts, pulse.duration, times[i])
    sum = sum + (values[i - 1] + values[i]) / 2 * (times[i] - times[i - 1])
  end
  local first = pulse.peak / 2 * times[1]
  local lower = (pulse.impulse - first) / (sum - first)
  for i = 1, intervals do points[i + 2] = { pulse.arrival + times[i], lower * values[i] } end
  return points
end

--- hinge.blast.triangle
function blast.triangle(options, ...)
  local where = "hinge.blast.triangle"
  check.no_more(where, ...)
  local o = check.options(where, options, {
    peak = { "number", above = 0 },
    duration = { "number", unit = "s", above = 0 },
    arrival = { "number", unit = "s", default = 0 },
  })
  return points_of { arrival = o.arrival, duration = o.duration, peak = o.peak, triangle = true }
end

--- hinge.blast.friedlander
function blast.friedlander(options, ...)
  local where = "hinge.blast.friedlander"
  check.no_more(where, ...)
  local o = check.options(where, options, {
    peak = { "number", above = 0 },
    duration = { "number", unit = "s", above = 0 },
    decay = { "number", at_least = 0, at_most = largest_decay },
    arrival = { "number", unit = "s", default = 0 },
  })
  return points_of { arrival = o.arrival, duration = o.duration, peak = o.peak, parts = { { o.peak, o.decay } },
    impulse = o.peak * o.duration * fullness(o.decay) }
end

-- Faces ---------------------------------------------------------------------------------------------------------------

local between, of_node = vectors.between, vectors.of_node

-- The distance of a point from the charge, and the vector from the point to the charge.
local function distance_to(self, point)
  local to = vectors.minus(self.at, point)
  return vectors.length(to), to
end

local function unit_normal(where, normal)
  return faces.direction(where, "normal", normal, "the direction out of the face")
end

-- The pulse on a small face at a point, with its unit normal: arrival in time of the run (s), duration (s), peak (Pa),
-- impulse (Pa s), and its parts.
local function pulse_on(self, where, point, normal)
  local distance, to = distance_to(self, point)
  local p = parameters_at(self, where, distance)
  local c = math.max(0, math.min(1, vectors.dot(to, normal) / distance)) -- 0: turned away
  local of_reflected, of_incident = c ^ 2, 1 + c - 2 * c ^ 2
  local parts = { { of_reflected * p.reflected_pressure, p.reflected_decay },
    { of_incident * p.incident_pressure, p.incident_decay } }
  local pulse = { arrival = self.start + p.arrival, duration = p.duration, parts = parts, distance = distance,
    peak = parts[1][1] + parts[2][1], impulse = of_reflected * p.reflected_impulse + of_incident * p.incident_impulse }
  if self.shape == "triangle" then
    pulse.triangle, pulse.duration = true, 2 * pulse.impulse / pulse.peak
  end
  return pulse
end

local function pulse_at(pulse, time)
  local s = time - pulse.arrival
  if not pulse.triangle then return friedlander_at(pulse.parts, pulse.duration, s) end
  return s >= 0 and s < pulse.duration and pulse.peak * (1 - s / pulse.duration) or 0
end

-- Members -------------------------------------------------------------------------------------------------------------

-- The peaks of the pressure at both ends of a part of a member and in its middle, and whether they are near each other.
local function peaks_along(self, where, from, to, normal)
  local peaks, least, most = {}, math.huge, 0
  for i = 1, 3 do
    peaks[i] = pulse_on(self, where, between(from, to, (i - 1) / 2), normal).peak
    least, most = math.min(least, peaks[i]), math.max(most, peaks[i])
  end
  return peaks, most - least <= even * peaks[2]
end

-- How many members of one length in the place of one are short enough, or nil for more than 100.
local function needed(self, where, a, b, normal)
  for n = 2, 100 do
    local good = true
    for i = 1, n do
      good = good and select(2, peaks_along(self, where, between(a, b, (i - 1) / n), between(a, b, i / n), normal))
    end
    if good then return n end
  end
end

local function refuse_uneven(self, where, member, normal)
  local a, b = of_node(member.a), of_node(member.b)
  local peaks, good = peaks_along(self, where, a, b, normal)
  if good then return end
  local n = needed(self, where, a, b, normal)
  check.fail("%s: the largest pressure on member %d is %.4g Pa at end a, %.4g Pa in the middle and %.4g Pa at end b, "
    .. "which differ by more than %g %% of the one in the middle; use %s members in its place, or take the pressure in "
    .. "the middle for all of it by uneven = true", where, member.index, peaks[1], peaks[2], peaks[3], 100 * even,
    n and tostring(n) or "more than 100")
end

local function load_options(where, given)
  local o = check.options(where, given, { members = { "table", optional = true }, group = faces.any,
    normal = { "numbers", count = 3 }, width = faces.any, uneven = { "boolean", default = false }, case = faces.any })
  if type(o.width) ~= "function" then
    local good = type(o.width) == "number" and o.width > 0 and o.width < math.huge
    if not good then
      check.fail("%s: field 'width' is %s; must be a number above 0 m, or a function that returns one for a member",
        where, o.width == nil and "missing" or check.show(o.width))
    end
  end
  return o
end

-- One load for each member, as model:load takes it, and what it is made of.
local function load_of(self, where, member, o, normal)
  faces.refuse_along(where, "normal", member, normal)
  if not o.uneven then refuse_uneven(self, where, member, normal) end
  local width = faces.width(where, o.width, member)
  local pulse = pulse_on(self, where, between(of_node(member.a), of_node(member.b), 1 / 2), normal)
  local area, q = width * member.length, width * pulse.peak
  local history = points_of(pulse)
  for _, point in ipairs(history) do point[2] = point[2] / pulse.peak end
  return { member = member, q = vectors.times(-q, normal), history = history, case = o.case },
    { member = member, distance = pulse.distance, arrival = pulse.arrival, duration = pulse.duration,
      pressure = pulse.peak, width = width, force = pulse.peak * area, impulse = pulse.impulse * area }
end

-- The object ----------------------------------------------------------------------------------------------------------

local methods = {}
local Explosion = { __name = "hinge.explosion" }

function Explosion.__index(self, key)
  if methods[key] then return methods[key] end
  local names = check.keys(self)
  for name in pairs(methods) do names[#names + 1] = name end
  check.unknown("explosion", "field", key, names)
end

function Explosion.__tostring(self)
  return ("explosion of %g kg of TNT on the ground at {%g, %g, %g} m"):format(self.charge, table.unpack(self.at))
end

local function check_self(where, self)
  if getmetatable(self) ~= Explosion then
    check.fail("%s: called on %s; write explosion:%s(...) with what hinge.blast{...} gives", where, check.show(self),
      where:match "[^:]+$")
  end
end

function methods.parameters(self, place, ...)
  local where = "explosion:parameters"
  check_self(where, self)
  check.no_more(where, ...)
  if type(place) ~= "table" then
    return parameters_at(self, where, check.value(where, "distance", place, length))
  end
  check.value(where, "point", place, point_rule)
  return parameters_at(self, where, distance_to(self, place))
end

function methods.pressure(self, point, normal, time, ...)
  local where = "explosion:pressure"
  check_self(where, self)
  check.no_more(where, ...)
  check.value(where, "point", point, point_rule)
  local n = unit_normal(where, normal)
  check.value(where, "time", time, { "number", unit = "s" })
  return pulse_at(pulse_on(self, where, point, n), time)
end

function methods.load(self, model, options, ...)
  local where = "explosion:load"
  check_self(where, self)
  check.model(where, model)
  check.no_more(where, ...)
  local o = load_options(where, options)
  local normal = unit_normal(where, o.normal)
  local members = chosen.members(where, model, o.members, o.group)
  local loads, parts, force, impulse = {}, {}, 0, 0
  for i, member in ipairs(members) do
    loads[i], parts[i] = load_of(self, where, member, o, normal)
    force, impulse = force + parts[i].force, impulse + parts[i].impulse
  end
  for _, load in ipairs(loads) do model:load(load) end
  return force, impulse, parts
end

-- hinge.blast { ... }
local function new(_, options, ...)
  local where = "hinge.blast"
  check.no_more(where, ...)
  local o = check.options(where, options, {
    charge = { "number", unit = "kg", above = 0 },
    at = point_rule,
    kind = { "string", default = "surface" },
    shape = { "string", default = "friedlander", one_of = { "friedlander", "triangle" } },
    start = { "number", unit = "s", default = 0 },
    negative = { "boolean", default = false },
  })
  if o.kind ~= "surface" then
    check.fail("%s: field 'kind' is %s; must be 'surface', a hemispherical charge on the ground; there is no other",
      where, check.show(o.kind))
  end
  if o.negative then
    check.fail("%s: field 'negative' is true; must be false: the negative phase is not there", where)
  end
  o.at = { o.at[1], o.at[2], o.at[3] }
  return setmetatable(o, Explosion)
end

return setmetatable(blast, {
  __call = new,
  __index = function(t, key) check.unknown("hinge.blast", "field", key, check.keys(t)) end,
  __name = "hinge.blast",
})
