-- hinge.joint.fin_plate: a plate on the column, bolted to the web of the beam. Bolts and plates by EN 1993-1-8:2005,
-- tables 3.3 and 3.4 and 3.10.2; the group of bolts, the long plate and tying as in "Steel buildings in Europe,
-- multi-storey steel buildings, part 5" (2009) and SCI P358 (2011). Lengths in m, forces in N.
local core = require "hinge.core"
local check = require "hinge.check"
local parts = require "hinge.joints.parts"

local where = "hinge.joint.fin_plate"
local root_3 = math.sqrt(3)

local count = { "number", whole = true, at_least = 1 }
local rules = {
  beam = { "table" }, plate = { "table" }, bolts = { "table" }, gap = parts.length,
  stiffness = { "number", unit = "N m/rad", above = 0, default = 1e3 },
  capacity = { "number", unit = "rad", above = 0, optional = true },
  gamma_M0 = parts.factor, gamma_M1 = parts.factor, gamma_M2 = parts.factor, gamma_Mu = parts.factor,
}
local beam_rules = { section = { "section" }, yield_stress = parts.stress, ultimate_stress = parts.stress,
  edge = parts.length, top = parts.length }
local plate_rules = { depth = parts.length, thickness = parts.length, yield_stress = parts.stress,
  ultimate_stress = parts.stress, edge = parts.length }
local bolt_rules = { diameter = parts.bolt_rules.diameter, grade = parts.bolt_rules.grade, rows = count,
  lines = parts.with(count, { at_most = 2, default = 1 }), pitch = parts.some_length, gauge = parts.some_length,
  shank = { "boolean", default = false } }

local function no_less(what, value, limit, of)
  if not (value >= limit - 1e-9) then
    check.fail("%s: %s is %s m; must be %s m or more: %s", where, what, check.show(value), check.show(limit), of)
  end
end

-- Table 3.3, and what fits where.
local function within(g)
  local d0 = g.bolt.d0
  for what, value in pairs { ["field 'plate': the distance of a bolt from the upper end"] = g.plate.e1,
    ["field 'plate': field 'edge'"] = g.plate.e2, ["field 'beam': field 'edge'"] = g.web.e2 } do
    no_less(what, value, 1.2 * d0, "1.2 hole diameters")
  end
  if g.n1 > 1 then no_less("field 'bolts': field 'pitch'", g.p1, 2.2 * d0, "2.2 hole diameters") end
  if g.n2 > 1 then no_less("field 'bolts': field 'gauge'", g.p2, 2.4 * d0, "2.4 hole diameters") end
  no_less("field 'beam': field 'edge'", g.web.e2, 1.2 * d0, "1.2 hole diameters")
  local room = g.beam.hw - 2 * g.beam.r
  no_less("the straight part of the beam's web", room, g.plate.depth, "the plate's depth")
  local last = g.web.e1 + (g.n1 - 1) * g.p1
  if g.web.e1 - g.plate.e1 < g.beam.tf + g.beam.r - 1e-9
    or last + g.plate.e1 > g.beam.h - g.beam.tf - g.beam.r + 1e-9 then
    check.fail("%s: field 'beam': field 'top' is %s m; the plate would be in a flange or a fillet of the beam", where,
      check.show(g.web.e1))
  end
end

local function geometry(options)
  local o = check.options(where, options, rules)
  o.beam, o.plate = parts.options(where, o, "beam", beam_rules), parts.options(where, o, "plate", plate_rules)
  o.bolts = parts.options(where, o, "bolts", bolt_rules)
  local b = o.bolts
  if b.rows > 1 then check.value(where .. ": field 'bolts'", "pitch", b.pitch, parts.length) end
  if b.lines > 1 then check.value(where .. ": field 'bolts'", "gauge", b.gauge, parts.length) end
  local beam, bolt = parts.h(where, o, "beam"), parts.bolt(where, b, o.gamma_M2)
  local n1, p1, p2 = b.rows, b.rows > 1 and b.pitch or 0, b.lines > 1 and b.gauge or 0
  local g = { o = o, beam = beam, bolt = bolt, n1 = n1, n2 = b.lines, n = n1 * b.lines, p1 = p1, p2 = p2,
    z = o.gap + o.beam.edge + p2 / 2,
    plate = { t = o.plate.thickness, fy = o.plate.yield_stress, fu = o.plate.ultimate_stress, depth = o.plate.depth,
      e1 = (o.plate.depth - (n1 - 1) * p1) / 2, e2 = o.plate.edge },
    web = { t = beam.tw, fy = beam.fy, fu = beam.fu, e1 = o.beam.top, e2 = o.beam.edge } }
  within(g)
  return g
end

-- Bearing of one bolt, table 3.4, along the distances e1 and p1; p: 0 where there is no neighbour.
local function bearing(g, s, e1, p1, e2, p2, gamma)
  local d0 = g.bolt.d0
  local a = math.min(e1 / (3 * d0), p1 > 0 and p1 / (3 * d0) - 0.25 or 1, g.bolt.fub / s.fu, 1)
  local k = math.min(2.8 * e2 / d0 - 1.7, p2 > 0 and 1.4 * p2 / d0 - 1.7 or 2.5, 2.5)
  return k * a * s.fu * g.bolt.d * s.t / gamma
end

-- Force V at the column's face under which the bolt at the corner of the group has the resistances down and across.
local function group(g, down, across)
  local n1, n2, p1, p2 = g.n1, g.n2, g.p1, g.p2
  -- sum of the squares of the distances from the middle
  local I = n2 * n1 * (n1 ^ 2 - 1) * p1 ^ 2 / 12 + n1 * n2 * (n2 - 1) * p2 ^ 2 / 4
  if I == 0 then
    check.fail("%s: field 'bolts': a single bolt does not hold the moment of the shear force about it", where)
  end
  local alpha, beta = g.z * p2 / (2 * I), g.z * (n1 - 1) * p1 / (2 * I)
  return g.n / math.sqrt(((1 + alpha * g.n) / down) ^ 2 + (beta * g.n / across) ^ 2), I
end

-- SCI P358, check 4: the plate in bending, and the stress at which a long one buckles sideways.
local function bending(g)
  local o, p, z = g.o, g.plate, g.z
  local W = p.t * p.depth ^ 2 / 6
  local V = p.depth >= 2.73 * z and math.huge or W * p.fy / (z * o.gamma_M0)
  if z <= p.t / 0.15 then return V end
  local E, slenderness = 205e9, 2.8 * math.sqrt(z * p.depth / (1.5 * p.t ^ 2)) -- BS 5950-1, B.2.1
  local euler, limit = math.pi ^ 2 * E / slenderness ^ 2, 0.4 * math.sqrt(math.pi ^ 2 * E / p.fy)
  local imperfection = math.max(0, 0.007 * (slenderness - limit))
  local phi = (p.fy + (imperfection + 1) * euler) / 2
  local stress = math.min(euler * p.fy / (phi + math.sqrt(phi ^ 2 - euler * p.fy)), p.fy)
  return math.min(V, W * stress / (0.6 * z * o.gamma_M1), W * p.fy / (z * o.gamma_M0)), stress
end

-- Shear of the bolts, the plate and the beam's web, each a resistance of the whole joint.
local function shear(g)
  local o, p, w = g.o, g.plate, g.web
  local d0, n1 = g.bolt.d0, g.n1
  local across = g.p2 + p.e2 - (2 * g.n2 - 1) * d0 / 2
  local Av = math.max(g.beam.A - 2 * g.beam.b * g.beam.tf + (g.beam.tw + 2 * g.beam.r) * g.beam.tf,
    g.beam.hw * g.beam.tw) -- EN 1993-1-1, 6.2.6 (3)
  local function block(s, wide, long) -- 3.10.2 (3)
    return 0.5 * s.fu * s.t * wide / o.gamma_M2 + s.fy * s.t * long / (root_3 * o.gamma_M0)
  end
  local function bears(s)
    return (group(g, bearing(g, s, s.e1, g.p1, s.e2, g.p2, o.gamma_M2),
      bearing(g, s, s.e2, g.p2, s.e1, g.p1, o.gamma_M2)))
  end
  local bend, stress = bending(g)
  return { ["bolts in shear"] = (group(g, g.bolt.shear, g.bolt.shear)), ["bearing on the plate"] = bears(p),
    ["bearing on the beam's web"] = bears(w),
    ["plate in shear"] = p.depth * p.t * p.fy / (1.27 * root_3 * o.gamma_M0),
    ["plate in shear, net"] = p.t * (p.depth - n1 * d0) * p.fu / (root_3 * o.gamma_M2),
    ["block of the plate"] = block(p, across, p.depth - p.e1 - (n1 - 0.5) * d0),
    ["plate in bending"] = bend, ["beam's web in shear"] = Av * w.fy / (root_3 * o.gamma_M0),
    ["beam's web in shear, net"] = (Av - n1 * d0 * w.t) * w.fu / (root_3 * o.gamma_M2),
    ["block of the beam's web"] = block(w, across - p.e2 + w.e2, w.e1 + (n1 - 1) * g.p1 - (n1 - 0.5) * d0),
  }, stress
end

-- Tying: the resistance to tension along the beam, with ultimate stresses over gamma_Mu.
local function tying(g)
  local o, d0, n1, n2 = g.o, g.bolt.d0, g.n1, g.n2
  local result = { ["bolts in shear"] = g.n * g.bolt.shear * o.gamma_M2 / o.gamma_Mu }
  for what, s in pairs { ["plate"] = g.plate, ["beam's web"] = g.web } do
    local along = (n2 - 1) * g.p2 + s.e2 - (n2 - 0.5) * d0
    local function block(wide, lines)
      return s.fu * s.t * wide / o.gamma_Mu + s.fy * lines * s.t * along / (root_3 * o.gamma_M0)
    end
    result["bearing on the " .. what] = g.n * bearing(g, s, s.e2, g.p2, s.e1, g.p1, o.gamma_Mu)
    -- between the outer rows; a web goes on above and below, so that its second block is that of the plate alone
    if n1 > 1 then result["block of the " .. what] = block((n1 - 1) * (g.p1 - d0), 2) end
    if s.depth then
      result["block at the plate's end"] = block(s.e1 + (n1 - 1) * g.p1 - (n1 - 0.5) * d0, 1)
      result["plate, net"] = 0.9 * s.t * (s.depth - n1 * d0) * s.fu / o.gamma_Mu
    end
  end
  return result
end

local function least(resistances)
  local F, name = math.huge, nil
  for _, key in ipairs(check.keys(resistances)) do
    if resistances[key] < F then F, name = resistances[key], key end
  end
  return F, name
end

-- The rotation about the middle of the bolts at which a flange of the beam meets the column; nil: it never does.
local function contact(g)
  local middle = g.web.e1 + (g.n1 - 1) * g.p1 / 2
  local far, near = math.max(middle, g.beam.h - middle), g.z - g.o.gap
  local radius = math.sqrt(near ^ 2 + far ^ 2)
  if radius <= g.z then return nil end
  return math.asin(g.z / radius) - math.atan(near / far)
end

--- hinge.joint.fin_plate
return function(options, ...)
  check.no_more(where, ...)
  local g = geometry(options)
  local numbers = { lever_arm = g.z, contact = contact(g), bolt = g.bolt }
  numbers.shear_of, numbers.buckling_stress = shear(g)
  numbers.tension_of = tying(g)
  numbers.shear, numbers.governs_shear = least(numbers.shear_of)
  numbers.tension, numbers.governs_tension = least(numbers.tension_of)
  numbers.capacity = g.o.capacity or numbers.contact
  if not numbers.capacity then
    check.fail("%s: field 'capacity' is missing; the beam's flange does not meet the column at any rotation: give the "
      .. "rotation at which the joint breaks, in rad", where)
  end
  return core.joint { Mx = { stiffness = g.o.stiffness, capacity = numbers.capacity }, My = "free",
    tension = numbers.tension, shear = numbers.shear }, numbers
end
