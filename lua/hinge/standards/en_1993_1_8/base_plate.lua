-- hinge.joint.base_plate: the base of an H column, with a row of two anchor bolts outside of each flange, bent about
-- its strong axis, by EN 1993-1-8:2005, 6.2.5, 6.2.8 and 6.3.4. Lengths in m, forces in N.
local core = require "hinge.core"
local check = require "hinge.library.check"
local parts = require "hinge.standards.en_1993_1_8.parts"

local where = "hinge.joint.base_plate"
local root_2 = math.sqrt(2)

local rules = {
  column = { "table" }, plate = { "table" }, bolts = { "table" }, concrete = { "table" },
  weld = parts.no_length, axial = { "number", unit = "N", at_least = 0 },
  capacity = { "number", unit = "rad", above = 0 },
  gamma_M0 = parts.factor, gamma_M2 = parts.factor, gamma_c = parts.factor,
}
local column_rules = { section = { "section" }, yield_stress = parts.stress }
local plate_rules = { length = parts.length, width = parts.length, thickness = parts.length,
  yield_stress = parts.stress }
local bolt_rules = { diameter = parts.bolt_rules.diameter, grade = parts.bolt_rules.grade, outside = parts.length,
  gauge = parts.length, length = parts.some_length,
  anchorage = { "number", unit = "N", above = 0, optional = true } }
local concrete_rules = { strength = parts.stress, spread = { "number", at_least = 1, at_most = 3, default = 1 },
  joint_factor = { "number", above = 0, at_most = 1, default = 2 / 3 }, grout = parts.with(parts.no_length,
    { default = 0 }), E = parts.with(parts.stress, { optional = true }) }

local function geometry(options)
  local o = check.options(where, options, rules)
  o.column, o.plate = parts.options(where, o, "column", column_rules), parts.options(where, o, "plate", plate_rules)
  o.bolts, o.concrete = parts.options(where, o, "bolts", bolt_rules),
    parts.options(where, o, "concrete", concrete_rules)
  local c, bolt = parts.h(where, o, "column"), parts.bolt(where, o.bolts, o.gamma_M2)
  local g = { o = o, column = c, bolt = bolt, mx = o.bolts.outside - 0.8 * root_2 * o.weld,
    overhang = (o.plate.length - c.h) / 2, e = (o.plate.width - o.bolts.gauge) / 2 }
  g.ex = g.overhang - o.bolts.outside
  parts.no_less(where, "field 'plate': field 'width'", o.plate.width, c.b, "the column's width")
  parts.no_less(where, "the distance of the bolts from the plate's end", g.ex, 1.2 * bolt.d0, "1.2 hole diameters")
  parts.no_less(where, "the distance of the bolts from the plate's side", g.e, 1.2 * bolt.d0, "1.2 hole diameters")
  if g.mx <= 0 then check.fail("%s: field 'bolts': field 'outside' has the bolts in the weld", where) end
  local eps = parts.epsilon(c.fy)
  if ((c.b - c.tw) / 2 - c.r) / c.tf > 10 * eps then
    check.fail("%s: field 'column': the flange of '%s' is not of class 1 or 2 at this yield stress", where, c.name)
  end
  g.zt, g.zc = c.h / 2 + o.bolts.outside, (c.h - c.tf) / 2
  return g
end

-- The flange of the column on the concrete: 6.2.5 and 6.2.6.7.
local function pressed(g)
  local o, c, p = g.o, g.column, g.o.plate
  local stress = o.concrete.joint_factor * o.concrete.spread * o.concrete.strength / o.gamma_c
  local reach = p.thickness * math.sqrt(p.yield_stress / (3 * stress * o.gamma_M0))
  local inside = math.min(reach, c.hw / 2)
  local width, length = math.min(reach, g.overhang) + c.tf + inside, math.min(c.b + 2 * reach, p.width)
  local flange = c.W * c.fy / o.gamma_M0 / (c.h - c.tf)
  local web = math.max(0, c.hw - 2 * inside) * math.min(c.tw + 2 * reach, p.width)
  return { bearing_stress = stress, reach = reach, width = width, length = length, flange = flange,
    concrete = stress * width * length, resistance = math.min(flange, stress * width * length),
    area = 2 * width * length + web, axial = stress * (2 * width * length + web) }
end

-- A row of anchor bolts and the plate in bending: tables 6.2 and 6.6.
local function pulled(g)
  local o, p = g.o, g.o.plate
  local lengths = parts.effective(parts.outside(g.mx, g.ex, g.e, o.bolts.gauge, p.width))
  local one = math.min(g.bolt.tension, o.bolts.anchorage or math.huge)
  local tee = parts.tee({ m = g.mx, n = math.min(g.ex, 1.25 * g.mx), thickness = p.thickness,
    yield_stress = p.yield_stress }, lengths, 2 * one, nil, o.gamma_M0)
  local length = o.bolts.length or 8 * g.bolt.d + o.concrete.grout + p.thickness + g.bolt.washer + g.bolt.nut / 2
  tee.bolt_length, tee.bolt = length, one
  tee.prying = length <= 8.8 * g.mx ^ 3 * g.bolt.As / (lengths.mode_1 * p.thickness ^ 3)
  if not tee.prying then -- modes 1 and 2 are one: 2 M_pl,1 / m
    local yielding = 2 * 0.25 * lengths.mode_1 * p.thickness ^ 2 * p.yield_stress / (o.gamma_M0 * g.mx)
    tee.modes = { yielding, yielding, 2 * one }
    tee.resistance, tee.mode = math.min(yielding, 2 * one), yielding <= 2 * one and 1 or 3
  end
  local l = math.min(lengths.circular, lengths.other)
  tee.k15 = (tee.prying and 0.85 or 0.425) * l * p.thickness ^ 3 / g.mx ^ 3
  tee.k16 = (tee.prying and 1.6 or 2) * g.bolt.As / length
  return tee
end

-- 6.2.8.3 and 6.3.4 under the compression N: equilibrium of the two flanges, and the springs of both.
local function bend(g, push, pull)
  local N, z = g.o.axial, g.zt + g.zc
  local C, T = push.resistance, pull.resistance
  if N >= 2 * C then
    check.fail("%s: field 'axial' is %s N; must be below %s N, what the concrete holds under both flanges", where,
      check.show(N), check.show(2 * C))
  end
  local strength = g.o.concrete.strength
  local Ec = g.o.concrete.E or 22e9 * ((strength + 8e6) / 10e6) ^ 0.3 -- EN 1992-1-1, table 3.1
  local k13 = Ec * math.sqrt(push.width * push.length) / (1.275 * parts.E)
  if N > C then
    local M = 2 * g.zc * (C - N / 2)
    return M, parts.E * (2 * g.zc) ^ 2 / (2 / k13), "concrete", 2 * g.zc, k13
  end
  local by_bolts, by_concrete = T * z + N * g.zc, C * z - N * g.zt
  local M = math.min(by_bolts, by_concrete)
  local kt = 1 / (1 / pull.k15 + 1 / pull.k16)
  local shift = (g.zc * k13 - g.zt * kt) / (k13 + kt) -- e_k
  local S = parts.E * z ^ 2 / (1 / kt + 1 / k13) / (1 - shift * N / M)
  local governs = by_concrete < by_bolts and (push.flange < push.concrete and "column flange in compression"
    or "concrete") or pull.mode == 3 and "bolts in tension" or "plate in bending"
  return M, S, governs, z, k13
end

--- hinge.joint.base_plate
return function(options, ...)
  check.no_more(where, ...)
  local g = geometry(options)
  local push, pull = pressed(g), pulled(g)
  local M, S, governs, z, k13 = bend(g, push, pull)
  -- 6.2.2 (6) to (8): friction on mortar of sand and cement, and four bolts
  local alpha = 0.44 - 0.0003 * g.bolt.fyb / 1e6
  local shear = 0.2 * g.o.axial + 4 * math.min(alpha * g.bolt.fub * g.bolt.As / g.o.gamma_M2, g.bolt.shear)
  local numbers = { moment = M, stiffness = S, governs = governs, lever_arm = z, compression = push, tension_row = pull,
    k13 = k13, axial = push.axial, points = parts.curve(M, S), tension = 2 * pull.resistance, shear = shear,
    capacity = g.o.capacity, bolt = g.bolt }
  return core.joint { Mx = { points = numbers.points, capacity = g.o.capacity }, tension = numbers.tension,
    shear = shear }, numbers
end
