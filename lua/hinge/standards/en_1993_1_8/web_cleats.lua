-- hinge.joint.web_cleats: two angles, bolted to the web of the beam and to the column: web_bolts.lua, and the angles as
-- in "Steel buildings in Europe, multi-storey steel buildings, part 5" (2009), section 4. Lengths in m, forces in N.
local core = require "hinge.core"
local check = require "hinge.library.check"
local parts = require "hinge.standards.en_1993_1_8.parts"
local web_bolts = require "hinge.standards.en_1993_1_8.web_bolts"

local where = "hinge.joint.web_cleats"

local rules = parts.with(web_bolts.rules, { cleats = { "table" } })
rules.gamma_M1 = nil -- nothing buckles
local cleat_rules = { depth = parts.length, thickness = parts.length, r = parts.no_length, yield_stress = parts.stress,
  ultimate_stress = parts.stress, edge = parts.length, column_edge = parts.length, column_gauge = parts.length }
local bolt_rules = parts.with(web_bolts.bolt_rules, { head = parts.some_length })

-- Rows at the column are those at the beam, with one bolt in each leg.
local function geometry(options)
  local o = check.options(where, options, rules)
  o.cleats = parts.options(where, o, "cleats", cleat_rules)
  local g = web_bolts.geometry(where, o, "cleats", bolt_rules)
  local c, d0 = o.cleats, g.bolt.d0
  parts.no_less(where, "field 'cleats': field 'column_edge'", c.column_edge, 1.2 * d0, "1.2 hole diameters")
  -- between the fillets of the two angles, at the column
  g.clear = c.column_gauge - g.beam.tw - 2 * c.thickness
  g.m = g.clear / 2 - 0.8 * c.r
  parts.no_less(where, "field 'cleats': field 'column_gauge'", c.column_gauge, g.beam.tw
    + 2 * (c.thickness + c.r) + g.bolt.d, "the web, the angles with their fillets, and a bolt")
  g.at_column = { t = c.thickness, fy = c.yield_stress, fu = c.ultimate_stress, depth = c.depth, e1 = g.side.e1,
    e2 = c.column_edge }
  return g
end

-- The bolts at the column, 3.7 (1). 0.8: they are pulled as well.
local function column_bolts(g)
  local s, gamma, d0, v = g.at_column, g.o.gamma_M2, g.bolt.d0, 0.8 * g.bolt.shear
  local outer = web_bolts.bearing(g, s, s.e1, 0, s.e2, 0, gamma)
  -- far from an end: 3 d0 is where it no longer counts
  local inner = g.n1 > 1 and web_bolts.bearing(g, s, 3 * d0, g.p1, s.e2, 0, gamma) or outer
  outer = math.min(outer, inner)
  if g.bolt.shear < outer then return 2 * g.n1 * v end
  if g.bolt.shear < inner then return 2 * g.n1 * outer end
  return 2 * (outer + (g.n1 - 1) * inner)
end

local function shear(g)
  local all = { ["bolts in shear"] = web_bolts.group(g, 2 * g.bolt.shear, 2 * g.bolt.shear),
    ["bolts at the column"] = column_bolts(g), ["bearing on the cleats"] = 2 * web_bolts.bears(g, g.side) }
  local one = parts.with(g, { n2 = 1, p2 = 0 })
  local beam, column = web_bolts.plate_shear(g, g.side), web_bolts.plate_shear(one, g.at_column)
  all["cleats in shear"], all["cleats in shear, net"] = 2 * beam.gross, 2 * beam.net
  all["block of the cleats"], all["block of the cleats at the column"] = 2 * beam.block, 2 * column.block
  local c = g.side
  if c.depth < 2.73 * g.z then
    all["cleats in bending"] = 2 * c.t * c.depth ^ 2 / 6 * c.fy / (g.z * g.o.gamma_M0)
  end
  web_bolts.add_web_shear(g, all)
  return all
end

-- The legs at the column in bending, as T-stubs of the ultimate stress: table 6.2 with the lengths of the source.
local function tee(g)
  local c, o, d0 = g.o.cleats, g.o, g.bolt.d0
  local most = g.clear - 2 * c.r + d0
  local length = 2 * math.min(g.side.e1, most / 2) + (g.n1 - 1) * math.min(g.p1, most)
  return parts.tee({ m = g.m, n = math.min(c.column_edge, 1.25 * g.m), thickness = c.thickness,
    yield_stress = c.ultimate_stress }, parts.effective(length, length), 2 * g.n1 * g.bolt.tension * o.gamma_M2
    / o.gamma_Mu, o.bolts.head, o.gamma_Mu)
end

local function tying(g)
  local legs, cleat, web = tee(g), web_bolts.tying(g, g.side), web_bolts.tying(g, g.web)
  return { ["bolts in shear"] = 2 * g.n * g.bolt.shear * g.o.gamma_M2 / g.o.gamma_Mu,
    ["cleats in bending"] = math.min(legs.modes[1], legs.modes[2]), ["bolts at the column in tension"] = legs.modes[3],
    ["bearing on the cleats"] = 2 * cleat.bearing, ["block of the cleats"] = cleat.block and 2 * cleat.block,
    ["block at the cleats' end"] = 2 * cleat.end_block, ["cleats, net"] = 2 * cleat.net,
    ["bearing on the beam's web"] = web.bearing, ["block of the beam's web"] = web.block }, legs
end

--- hinge.joint.web_cleats
return function(options, ...)
  check.no_more(where, ...)
  local g = geometry(options)
  local numbers = { shear_of = shear(g) }
  numbers.tension_of, numbers.legs = tying(g)
  return core.joint(web_bolts.joint(g, numbers)), numbers
end
