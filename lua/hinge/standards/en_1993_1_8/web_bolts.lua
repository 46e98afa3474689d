-- Bolts through the web of a beam, which fin plates and web cleats have: tables 3.3 and 3.4 and 3.10.2 of EN
-- 1993-1-8:2005, the group of bolts and tying as in "Steel buildings in Europe, multi-storey steel buildings, part 5"
-- (2009). Lengths in m, forces in N.
local check = require "hinge.library.check"
local parts = require "hinge.standards.en_1993_1_8.parts"

local web_bolts = {}
local root_3 = math.sqrt(3)

web_bolts.count = { "number", whole = true, at_least = 1 }
web_bolts.beam_rules = { section = { "section" }, yield_stress = parts.stress, ultimate_stress = parts.stress,
  edge = parts.length, top = parts.length }
web_bolts.bolt_rules = { diameter = parts.bolt_rules.diameter, grade = parts.bolt_rules.grade, rows = web_bolts.count,
  lines = parts.with(web_bolts.count, { at_most = 2, default = 1 }), pitch = parts.some_length,
  gauge = parts.some_length, shank = { "boolean", default = false } }
--- Options of a joint that is bolted to the web.
web_bolts.rules = {
  beam = { "table" }, bolts = { "table" }, gap = parts.length,
  stiffness = { "number", unit = "N m/rad", above = 0, default = 1e3 },
  capacity = { "number", unit = "rad", above = 0, optional = true },
  gamma_M0 = parts.factor, gamma_M1 = parts.factor, gamma_M2 = parts.factor, gamma_Mu = parts.factor,
}

--- The beam's end and its bolts, by options that were checked. `field`: of the plate or cleats, o[field], through which
--- the bolts go: `depth`, and `edge` from the farthest line of bolts to its free side.
function web_bolts.geometry(where, o, field, bolt_rules)
  o.beam, o.bolts = parts.options(where, o, "beam", web_bolts.beam_rules), parts.options(where, o, "bolts",
    bolt_rules or web_bolts.bolt_rules)
  local b, side = o.bolts, o[field]
  if b.rows > 1 then check.value(where .. ": field 'bolts'", "pitch", b.pitch, parts.length) end
  if b.lines > 1 then check.value(where .. ": field 'bolts'", "gauge", b.gauge, parts.length) end
  local beam, bolt = parts.h(where, o, "beam"), parts.bolt(where, b, o.gamma_M2)
  local n1, p1, p2 = b.rows, b.rows > 1 and b.pitch or 0, b.lines > 1 and b.gauge or 0
  local g = { where = where, field = field, o = o, beam = beam, bolt = bolt, n1 = n1, n2 = b.lines, n = n1 * b.lines,
    p1 = p1, p2 = p2, z = o.gap + o.beam.edge + p2 / 2,
    side = { t = side.thickness, fy = side.yield_stress, fu = side.ultimate_stress, depth = side.depth,
      e1 = (side.depth - (n1 - 1) * p1) / 2, e2 = side.edge },
    web = { t = beam.tw, fy = beam.fy, fu = beam.fu, e1 = o.beam.top, e2 = o.beam.edge } }
  web_bolts.within(g)
  return g
end

--- Table 3.3, and what fits where.
function web_bolts.within(g)
  local where, d0 = g.where, g.bolt.d0
  local function no_less(...) parts.no_less(where, ...) end
  local side = ("field '%s': "):format(g.field)
  for what, value in pairs { [side .. "the distance of a bolt from the upper end"] = g.side.e1,
    [side .. "field 'edge'"] = g.side.e2, ["field 'beam': field 'edge'"] = g.web.e2 } do
    no_less(what, value, 1.2 * d0, "1.2 hole diameters")
  end
  if g.n1 > 1 then no_less("field 'bolts': field 'pitch'", g.p1, 2.2 * d0, "2.2 hole diameters") end
  if g.n2 > 1 then no_less("field 'bolts': field 'gauge'", g.p2, 2.4 * d0, "2.4 hole diameters") end
  local room = g.beam.hw - 2 * g.beam.r
  no_less("the straight part of the beam's web", room, g.side.depth, ("the depth of field '%s'"):format(g.field))
  local last = g.web.e1 + (g.n1 - 1) * g.p1
  if g.web.e1 - g.side.e1 < g.beam.tf + g.beam.r - 1e-9
    or last + g.side.e1 > g.beam.h - g.beam.tf - g.beam.r + 1e-9 then
    check.fail("%s: field 'beam': field 'top' is %s m; the plate would be in a flange or a fillet of the beam", where,
      check.show(g.web.e1))
  end
end

--- Bearing of one bolt, table 3.4, along the distances e1 and p1; p: 0 where there is no neighbour.
function web_bolts.bearing(g, s, e1, p1, e2, p2, gamma)
  local d0 = g.bolt.d0
  local a = math.min(e1 / (3 * d0), p1 > 0 and p1 / (3 * d0) - 0.25 or 1, g.bolt.fub / s.fu, 1)
  local k = math.min(2.8 * e2 / d0 - 1.7, p2 > 0 and 1.4 * p2 / d0 - 1.7 or 2.5, 2.5)
  return k * a * s.fu * g.bolt.d * s.t / gamma
end

--- Force V at the column's face under which the bolt at the corner of the group has the resistances down and across.
function web_bolts.group(g, down, across)
  local n1, n2, p1, p2 = g.n1, g.n2, g.p1, g.p2
  -- sum of the squares of the distances from the middle
  local I = n2 * n1 * (n1 ^ 2 - 1) * p1 ^ 2 / 12 + n1 * n2 * (n2 - 1) * p2 ^ 2 / 4
  if I == 0 then
    check.fail("%s: field 'bolts': a single bolt does not hold the moment of the shear force about it", g.where)
  end
  local alpha, beta = g.z * p2 / (2 * I), g.z * (n1 - 1) * p1 / (2 * I)
  return g.n / math.sqrt(((1 + alpha * g.n) / down) ^ 2 + (beta * g.n / across) ^ 2)
end

--- Shear force under which a bolt at the corner bears on s as much as it can.
function web_bolts.bears(g, s)
  local gamma, bearing = g.o.gamma_M2, web_bolts.bearing
  return web_bolts.group(g, bearing(g, s, s.e1, g.p1, s.e2, g.p2, gamma), bearing(g, s, s.e2, g.p2, s.e1, g.p1, gamma))
end

-- A block of s in shear, 3.10.2 (3): wide across the force, long along it.
local function block(g, s, wide, long)
  return 0.5 * s.fu * s.t * wide / g.o.gamma_M2 + s.fy * s.t * long / (root_3 * g.o.gamma_M0)
end

-- What a block across the lines of bolts has at a free side at the distance e2.
local function across(g, e2) return g.p2 + e2 - (2 * g.n2 - 1) * g.bolt.d0 / 2 end

--- Shear of a plate between the column and the beam: { gross, net, block }.
function web_bolts.plate_shear(g, s)
  local o, d0, n1 = g.o, g.bolt.d0, g.n1
  return { gross = s.depth * s.t * s.fy / (1.27 * root_3 * o.gamma_M0),
    net = s.t * (s.depth - n1 * d0) * s.fu / (root_3 * o.gamma_M2),
    block = block(g, s, across(g, s.e2), s.depth - s.e1 - (n1 - 0.5) * d0) }
end

--- Adds what the beam's web has in shear to a table of resistances.
function web_bolts.add_web_shear(g, shear)
  local o, w, b, d0, n1 = g.o, g.web, g.beam, g.bolt.d0, g.n1
  local Av = math.max(b.A - 2 * b.b * b.tf + (b.tw + 2 * b.r) * b.tf, b.hw * b.tw) -- EN 1993-1-1, 6.2.6 (3)
  shear["bearing on the beam's web"] = web_bolts.bears(g, w)
  shear["beam's web in shear"] = Av * w.fy / (root_3 * o.gamma_M0)
  shear["beam's web in shear, net"] = (Av - n1 * d0 * w.t) * w.fu / (root_3 * o.gamma_M2)
  shear["block of the beam's web"] = block(g, w, across(g, w.e2), w.e1 + (n1 - 1) * g.p1 - (n1 - 0.5) * d0)
end

--- Resistances of s to tension along the beam, with ultimate stresses over gamma_Mu: { bearing, block, end_block,
--- net }. `block` is that between the outer rows, of two rows or more. A web goes on above and below: it has those two
--- alone.
function web_bolts.tying(g, s)
  local o, d0, n1, n2 = g.o, g.bolt.d0, g.n1, g.n2
  local along = (n2 - 1) * g.p2 + s.e2 - (n2 - 0.5) * d0
  local function torn(wide, lines)
    return s.fu * s.t * wide / o.gamma_Mu + s.fy * lines * s.t * along / (root_3 * o.gamma_M0)
  end
  return { bearing = g.n * web_bolts.bearing(g, s, s.e2, g.p2, s.e1, g.p1, o.gamma_Mu),
    block = n1 > 1 and torn((n1 - 1) * (g.p1 - d0), 2) or nil,
    end_block = s.depth and torn(s.e1 + (n1 - 1) * g.p1 - (n1 - 0.5) * d0, 1),
    net = s.depth and 0.9 * s.t * (s.depth - n1 * d0) * s.fu / o.gamma_Mu }
end

--- The rotation about the middle of the bolts at which a flange of the beam meets the column; nil: it never does.
function web_bolts.contact(g)
  local middle = g.web.e1 + (g.n1 - 1) * g.p1 / 2
  local far, near = math.max(middle, g.beam.h - middle), g.z - g.o.gap
  local radius = math.sqrt(near ^ 2 + far ^ 2)
  if radius <= g.z then return nil end
  return math.asin(g.z / radius) - math.atan(near / far)
end

local function least(resistances)
  local F, name = math.huge, nil
  for _, key in ipairs(check.keys(resistances)) do
    if resistances[key] < F then F, name = resistances[key], key end
  end
  return F, name
end

--- Options of hinge.joint, by numbers.shear_of and numbers.tension_of, and the rest of the numbers.
function web_bolts.joint(g, numbers)
  numbers.lever_arm, numbers.contact, numbers.bolt = g.z, web_bolts.contact(g), g.bolt
  numbers.shear, numbers.governs_shear = least(numbers.shear_of)
  numbers.tension, numbers.governs_tension = least(numbers.tension_of)
  numbers.capacity = g.o.capacity or numbers.contact
  if not numbers.capacity then
    check.fail("%s: field 'capacity' is missing; the beam's flange does not meet the column at any rotation: give the "
      .. "rotation at which the joint breaks, in rad", g.where)
  end
  return { Mx = { stiffness = g.o.stiffness, capacity = numbers.capacity }, My = "free", tension = numbers.tension,
    shear = numbers.shear }
end

return web_bolts
