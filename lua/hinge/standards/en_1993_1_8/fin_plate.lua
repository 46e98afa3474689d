-- hinge.joint.fin_plate: a plate on the column, bolted to the web of the beam (web_bolts.lua). The plate itself is as
-- in SCI P358 (2011). Lengths in m, forces in N.
local core = require "hinge.core"
local check = require "hinge.library.check"
local parts = require "hinge.standards.en_1993_1_8.parts"
local web_bolts = require "hinge.standards.en_1993_1_8.web_bolts"

local where = "hinge.joint.fin_plate"

local rules = parts.with(web_bolts.rules, { plate = { "table" } })
local plate_rules = { depth = parts.length, thickness = parts.length, yield_stress = parts.stress,
  ultimate_stress = parts.stress, edge = parts.length }

local function geometry(options)
  local o = check.options(where, options, rules)
  o.plate = parts.options(where, o, "plate", plate_rules)
  return web_bolts.geometry(where, o, "plate")
end

-- SCI P358, check 4: the plate in bending, and the stress at which a long one buckles sideways.
local function bending(g)
  local o, p, z = g.o, g.side, g.z
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
  local plate, bend, stress = web_bolts.plate_shear(g, g.side), bending(g)
  local all = { ["bolts in shear"] = web_bolts.group(g, g.bolt.shear, g.bolt.shear),
    ["bearing on the plate"] = web_bolts.bears(g, g.side), ["plate in shear"] = plate.gross,
    ["plate in shear, net"] = plate.net, ["block of the plate"] = plate.block, ["plate in bending"] = bend }
  web_bolts.add_web_shear(g, all)
  return all, stress
end

-- Tying: the resistance to tension along the beam, with ultimate stresses over gamma_Mu.
local function tying(g)
  local plate, web = web_bolts.tying(g, g.side), web_bolts.tying(g, g.web)
  return { ["bolts in shear"] = g.n * g.bolt.shear * g.o.gamma_M2 / g.o.gamma_Mu,
    ["bearing on the plate"] = plate.bearing, ["block of the plate"] = plate.block,
    ["block at the plate's end"] = plate.end_block, ["plate, net"] = plate.net,
    ["bearing on the beam's web"] = web.bearing, ["block of the beam's web"] = web.block }
end

--- hinge.joint.fin_plate
return function(options, ...)
  check.no_more(where, ...)
  local g = geometry(options)
  local numbers = {}
  numbers.shear_of, numbers.buckling_stress = shear(g)
  numbers.tension_of = tying(g)
  return core.joint(web_bolts.joint(g, numbers)), numbers
end
