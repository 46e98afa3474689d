-- Properties of cross-sections from their dimensions: one pure function for each shape.
--
-- x and y are the section's axes, y along the member's `up`. Ix bends about x, so it resists deflection along y. Each
-- function returns the table that core.section takes: area (m^2), Ix, Iy, J (m^4), shear_area_x and shear_area_y (m^2),
-- plastic = { A, Zx, Zy, Zz } (m^2, m^3: fully plastic resultant over yield stress; Zz over yield stress / sqrt 3),
-- size = { width, depth } (m, along x and y; of an H also web and flange, for pictures), outline (m), interaction and
-- kind.
--
-- Shear areas: Cowper (1966) with Poisson's ratio 0, which is the area of equal shear strain energy. It gives the
-- paper's 5/6 for the rectangle and needs no material.
local check = require "hinge.check"

local shapes = {}
local pi = math.pi
local length = { "number", unit = "m", above = 0 }
local optional_length = { "number", unit = "m", above = 0, optional = true }

local interaction = { "string", one_of = { "paper", "exact" }, optional = true }

--- A rectangle between -b/2 and b/2, -d/2 and d/2, as a part of an outline.
local function rectangle(b, d, hole)
  return { corners = { { -b / 2, -d / 2 }, { b / 2, -d / 2 }, { b / 2, d / 2 }, { -b / 2, d / 2 } }, hole = hole }
end

local function must_be_below(where, field, value, limit, what)
  if value >= limit then
    check.fail("%s: field '%s' is %s m; must be below %s, %s m", where, field, check.show(value), what,
      check.show(limit))
  end
end

--- Torsion constant of a b x d rectangle: the series of the Prandtl stress function, m^4.
local function torsion_of_rectangle(b, d)
  local a, c = math.max(b, d), math.min(b, d)
  local sum = 0
  for n = 1, 39, 2 do
    local e = math.exp(-n * pi * a / c)
    sum = sum + (1 - e) / (1 + e) / n ^ 5 -- tanh(n pi a / 2c)
  end
  return a * c ^ 3 * (1 / 3 - 64 / pi ^ 5 * c / a * sum)
end

--- Fully plastic torque over shear yield stress of a rectangle: Nadai's sand-heap analogy, m^3.
local function sand_heap(b, d)
  local a, c = math.max(b, d), math.min(b, d)
  return c * c * (3 * a - c) / 6
end

--- Cowper's factor of a web of height h and thickness t between two flanges of breadth b, at Poisson's ratio 0.
-- m: area of the flanges over that of the web or webs; heights and breadths between the walls' middle planes.
local function flanged_shear_factor(m, b, h)
  local n = b / h
  return 10 * (1 + 3 * m) ^ 2 / (12 + 72 * m + 150 * m ^ 2 + 90 * m ^ 3 + 30 * n ^ 2 * (m + m ^ 2))
end

--- Solid rectangle: width along x, depth along y.
function shapes.solid(options)
  local o = check.options("hinge.section.solid", options, { width = length, depth = length, interaction = interaction })
  local b, d = o.width, o.depth
  return {
    kind = "solid", interaction = o.interaction, outline = { rectangle(b, d) }, size = { width = b, depth = d },
    area = b * d,
    Ix = b * d ^ 3 / 12, Iy = d * b ^ 3 / 12, J = torsion_of_rectangle(b, d),
    shear_area_x = 5 / 6 * b * d, shear_area_y = 5 / 6 * b * d,
    plastic = { A = b * d, Zx = b * d ^ 2 / 4, Zy = d * b ^ 2 / 4, Zz = sand_heap(b, d) },
  }
end

--- Closed box: outer width and depth; either `thickness` for all four walls, or `web` (the walls along y) and `flange`.
-- J and the plastic torque by Bredt: 4 Am^2 / sum(length / t), and 2 Am t with the thinnest wall.
function shapes.box(options)
  local where = "hinge.section.box"
  local o = check.options(where, options, { width = length, depth = length, thickness = optional_length,
    web = optional_length, flange = optional_length, interaction = interaction })
  if o.thickness and (o.web or o.flange) then
    check.fail("%s: fields 'thickness' and '%s' are both given; give thickness (m), or web and flange (m)", where,
      o.web and "web" or "flange")
  elseif not o.thickness and not (o.web and o.flange) then
    check.fail("%s: field '%s' is missing; give thickness, a number above 0 m, or both web and flange", where,
      o.web and "flange" or o.flange and "web" or "thickness")
  end
  local b, d, tw, tf = o.width, o.depth, o.web or o.thickness, o.flange or o.thickness
  must_be_below(where, o.web and "web" or "thickness", tw, b / 2, "half the width")
  must_be_below(where, o.flange and "flange" or "thickness", tf, d / 2, "half the depth")
  local bi, di = b - 2 * tw, d - 2 * tf
  local bm, dm = b - tw, d - tf
  local area, webs, flanges = b * d - bi * di, 2 * dm * tw, 2 * bm * tf
  return {
    kind = "box", interaction = o.interaction, outline = { rectangle(b, d), rectangle(bi, di, true) },
    size = { width = b, depth = d }, area = area,
    Ix = (b * d ^ 3 - bi * di ^ 3) / 12, Iy = (d * b ^ 3 - di * bi ^ 3) / 12,
    J = 4 * (bm * dm) ^ 2 / (2 * bm / tf + 2 * dm / tw),
    shear_area_x = area * flanged_shear_factor(webs / flanges, dm, bm),
    shear_area_y = area * flanged_shear_factor(flanges / webs, bm, dm),
    plastic = { A = area, Zx = (b * d ^ 2 - bi * di ^ 2) / 4, Zy = (d * b ^ 2 - di * bi ^ 2) / 4,
      Zz = 2 * bm * dm * math.min(tw, tf) },
  }
end

--- H, also called I or wide flange: outer depth and width, thickness of web and flange. The web lies along y, so Ix is
-- the strong axis. J = sum b t^3 / 3 of the three plates; plastic torque: the sand-heap analogy for each plate,
-- for the web without slopes at its ends. Neither includes the fillets. Shear along x: 5/6 of the flanges.
function shapes.h(options)
  local where = "hinge.section.h"
  local o = check.options(where, options, { depth = length, width = length, web = length, flange = length,
    interaction = interaction })
  local b, d, tw, tf = o.width, o.depth, o.web, o.flange
  must_be_below(where, "web", tw, b, "the width")
  must_be_below(where, "flange", tf, d / 2, "half the depth")
  local di, dm = d - 2 * tf, d - tf
  local area = 2 * b * tf + di * tw
  local x, y, w, f = b / 2, d / 2, tw / 2, di / 2
  local corners = { { -x, -y }, { x, -y }, { x, -f }, { w, -f }, { w, f }, { x, f }, { x, y }, { -x, y }, { -x, f },
    { -w, f }, { -w, -f }, { -x, -f } }
  return {
    kind = "h", interaction = o.interaction, outline = { { corners = corners } },
    size = { width = b, depth = d, web = tw, flange = tf }, area = area,
    Ix = (b * d ^ 3 - (b - tw) * di ^ 3) / 12, Iy = (2 * tf * b ^ 3 + di * tw ^ 3) / 12,
    J = (2 * b * tf ^ 3 + di * tw ^ 3) / 3,
    shear_area_x = 5 / 6 * 2 * b * tf,
    shear_area_y = area * flanged_shear_factor(2 * b * tf / (dm * tw), b, dm),
    plastic = { A = area, Zx = b * tf * dm + tw * di ^ 2 / 4, Zy = tf * b ^ 2 / 2 + di * tw ^ 2 / 4,
      Zz = 2 * sand_heap(b, tf) + di * tw ^ 2 / 2 },
  }
end

local function ring(kind, outer, inner, law)
  local area = pi / 4 * (outer ^ 2 - inner ^ 2)
  local I, Z = pi / 64 * (outer ^ 4 - inner ^ 4), (outer ^ 3 - inner ^ 3) / 6
  local m = inner / outer
  local q = (1 + m ^ 2) ^ 2
  local shear = area * 6 * q / (7 * q + 20 * m ^ 2)
  return {
    kind = kind, interaction = law,
    outline = { { diameter = outer }, inner > 0 and { diameter = inner, hole = true } or nil },
    size = { width = outer, depth = outer }, area = area, Ix = I, Iy = I, J = 2 * I,
    shear_area_x = shear, shear_area_y = shear, plastic = { A = area, Zx = Z, Zy = Z, Zz = pi / 2 * Z },
  }
end

--- Round tube: outer diameter and thickness. All values exact but the shear area (Cowper).
function shapes.pipe(options)
  local where = "hinge.section.pipe"
  local o = check.options(where, options, { diameter = length, thickness = length, interaction = interaction })
  must_be_below(where, "thickness", o.thickness, o.diameter / 2, "half the diameter")
  return ring("pipe", o.diameter, o.diameter - 2 * o.thickness, o.interaction)
end

--- Solid circle.
function shapes.round(options)
  local o = check.options("hinge.section.round", options, { diameter = length, interaction = interaction })
  return ring("round", o.diameter, 0, o.interaction)
end

return shapes
