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
local check = require "hinge.library.check"
local outline = require "hinge.sections.outline"

local shapes = {}
local pi = math.pi
local length = { "number", unit = "m", above = 0 }
local optional_length = { "number", unit = "m", above = 0, optional = true }

local interaction = { "string", one_of = { "paper", "exact", "exact with shear" }, optional = true }

local radius = { "number", unit = "m", at_least = 0, optional = true }

local function must_be_below(where, field, value, limit, what)
  if value >= limit then
    check.fail("%s: field '%s' is %s m; must be below %s, %s m", where, field, check.show(value), what,
      check.show(limit))
  end
end

local function must_be_at_most(where, field, value, limit, what)
  if value > limit * (1 + 1e-12) then
    check.fail("%s: field '%s' is %s m; must be at most %s, %s m", where, field, check.show(value), what,
      check.show(limit))
  end
end

--- What a corner of radius r takes from its square: area; distance of its centroid from both sides, e; own second
-- moment, I.
local function spandrel(r)
  local A, e = (1 - pi / 4) * r ^ 2, r * (10 - 3 * pi) / (12 - 3 * pi)
  return A, e, r ^ 4 * (1 / 3 - pi / 16 - 1 / (9 * (4 - pi)))
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
    kind = "solid", interaction = o.interaction, outline = { outline.rectangle(b, d) },
    size = { width = b, depth = d }, area = b * d,
    Ix = b * d ^ 3 / 12, Iy = d * b ^ 3 / 12, J = torsion_of_rectangle(b, d),
    shear_area_x = 5 / 6 * b * d, shear_area_y = 5 / 6 * b * d,
    plastic = { A = b * d, Zx = b * d ^ 2 / 4, Zy = d * b ^ 2 / 4, Zz = sand_heap(b, d) },
  }
end

--- Closed box: outer width and depth; either `thickness` for all four walls, or `web` (the walls along y) and `flange`.
-- r: outer radius of the corners; r_inner: the inner one, by default r less the thicker wall, at least 0.
-- J and the plastic torque by Bredt: 4 Am^2 / sum(length / t), and 2 Am t with the thinnest wall. With r the middle
-- line has corners of the mean radius, and J also has the walls' own sum(length t^3) / 3, as in EN 10210-2, annex B.
function shapes.box(options)
  local where = "hinge.section.box"
  local o = check.options(where, options, { width = length, depth = length, thickness = optional_length,
    web = optional_length, flange = optional_length, r = radius, r_inner = radius, interaction = interaction })
  if o.thickness and (o.web or o.flange) then
    check.fail("%s: fields 'thickness' and '%s' are both given; give thickness (m), or web and flange (m)", where,
      o.web and "web" or "flange")
  elseif not o.thickness and not (o.web and o.flange) then
    check.fail("%s: field '%s' is missing; give thickness, a number above 0 m, or both web and flange", where,
      o.web and "flange" or o.flange and "web" or "thickness")
  elseif o.r_inner and not o.r then
    check.fail("%s: field 'r' is missing; give the corners' outer radius (m) with r_inner", where)
  end
  local b, d, tw, tf = o.width, o.depth, o.web or o.thickness, o.flange or o.thickness
  must_be_below(where, o.web and "web" or "thickness", tw, b / 2, "half the width")
  must_be_below(where, o.flange and "flange" or "thickness", tf, d / 2, "half the depth")
  local bi, di = b - 2 * tw, d - 2 * tf
  local bm, dm = b - tw, d - tf
  local r = o.r or 0
  must_be_at_most(where, "r", r, math.min(b, d) / 2, "half the smaller side")
  local ri = o.r_inner or math.max(r - math.max(tw, tf), 0)
  must_be_at_most(where, "r_inner", ri, math.min(bi, di) / 2, "half the smaller clear side")
  -- the material at a corner is least along its diagonal
  local diagonal = math.sqrt(tw ^ 2 + tf ^ 2)
  if diagonal <= (math.sqrt(2) - 1) * (r - ri) then
    check.fail("%s: field 'r' is %s m; with walls of %s m and the inner radius %s m the corners are cut through", where,
      check.show(r), check.show(math.max(tw, tf)), check.show(ri))
  end
  local Ao, eo, Io = spandrel(r)
  local Ai, ei, Ii = spandrel(ri)
  local function I(across, along, across_i, along_i)
    return (across * along ^ 3 - across_i * along_i ^ 3) / 12 - 4 * (Io + Ao * (along / 2 - eo) ^ 2)
      + 4 * (Ii + Ai * (along_i / 2 - ei) ^ 2)
  end
  local function Z(across, along, across_i, along_i)
    return (across * along ^ 2 - across_i * along_i ^ 2) / 4 - 4 * Ao * (along / 2 - eo) + 4 * Ai * (along_i / 2 - ei)
  end
  local rm = (r + ri) / 2
  local within = bm * dm - (4 - pi) * rm ^ 2
  local across, along, corners = 2 * (bm - 2 * rm), 2 * (dm - 2 * rm), 2 * pi * rm
  local J = 4 * within ^ 2 / (across / tf + along / tw + corners * 2 / (tw + tf))
  if r > 0 then J = J + (across * tf ^ 3 + along * tw ^ 3 + corners * ((tw + tf) / 2) ^ 3) / 3 end
  local area, webs, flanges = b * d - bi * di - 4 * (Ao - Ai), 2 * dm * tw, 2 * bm * tf
  return {
    kind = "box", interaction = o.interaction,
    outline = { outline.rectangle(b, d, r), outline.rectangle(bi, di, ri, true) },
    size = { width = b, depth = d }, area = area, Ix = I(b, d, bi, di), Iy = I(d, b, di, bi), J = J,
    shear_area_x = area * flanged_shear_factor(webs / flanges, dm, bm),
    shear_area_y = area * flanged_shear_factor(flanges / webs, bm, dm),
    plastic = { A = area, Zx = Z(b, d, bi, di), Zy = Z(d, b, di, bi), Zz = 2 * within * math.min(tw, tf) },
  }
end

--- Torsion constant of an H with root fillets: El Darwish and Johnston (1965). The circle in the joint of web and
-- flange has the diameter D.
local function torsion_of_rolled_h(b, d, tw, tf, r)
  local D = ((tf + r) ^ 2 + (r + tw / 4) * tw) / (2 * r + tf)
  local w, q = tw / tf, r / tf
  local alpha = -0.042 + 0.2204 * w + 0.1355 * q - 0.0865 * q * w - 0.0725 * w ^ 2
  return (2 * b * tf ^ 3 + (d - 2 * tf) * tw ^ 3) / 3 + 2 * alpha * D ^ 4 - 0.42 * tf ^ 4
end

--- H, also called I or wide flange: outer depth and width, thickness of web and flange, root radius r of rolled ones.
-- The web lies along y, so Ix is the strong axis. J = sum b t^3 / 3 of the three plates; with r that of El Darwish and
-- Johnston. Plastic torque: the sand-heap analogy for each plate, for the web without slopes at its ends. It and the
-- shear areas leave the fillets out. Shear along x: 5/6 of the flanges.
function shapes.h(options)
  local where = "hinge.section.h"
  local o = check.options(where, options, { depth = length, width = length, web = length, flange = length, r = radius,
    interaction = interaction })
  local b, d, tw, tf, r = o.width, o.depth, o.web, o.flange, o.r or 0
  must_be_below(where, "web", tw, b, "the width")
  must_be_below(where, "flange", tf, d / 2, "half the depth")
  local di, dm = d - 2 * tf, d - tf
  must_be_at_most(where, "r", r, di / 2, "half the clear depth between the flanges")
  must_be_at_most(where, "r", r, (b - tw) / 2, "the flange's part beside the web")
  local plates = 2 * b * tf + di * tw
  local A, e, I = spandrel(r)
  local area = plates + 4 * A
  local x, y, w, f = b / 2, d / 2, tw / 2, di / 2
  local corners = outline.rounded { { -x, -y }, { x, -y }, { x, -f }, { w, -f, r }, { w, f, r }, { x, f }, { x, y },
    { -x, y }, { -x, f }, { -w, f, r }, { -w, -f, r }, { -x, -f } }
  return {
    kind = "h", interaction = o.interaction, outline = { { corners = corners } },
    size = { width = b, depth = d, web = tw, flange = tf }, area = area,
    Ix = (b * d ^ 3 - (b - tw) * di ^ 3) / 12 + 4 * (I + A * (f - e) ^ 2),
    Iy = (2 * tf * b ^ 3 + di * tw ^ 3) / 12 + 4 * (I + A * (w + e) ^ 2),
    J = r > 0 and torsion_of_rolled_h(b, d, tw, tf, r) or (2 * b * tf ^ 3 + di * tw ^ 3) / 3,
    shear_area_x = 5 / 6 * 2 * b * tf,
    shear_area_y = plates * flanged_shear_factor(2 * b * tf / (dm * tw), b, dm),
    plastic = { A = area, Zx = b * tf * dm + tw * di ^ 2 / 4 + 4 * A * (f - e),
      Zy = tf * b ^ 2 / 2 + di * tw ^ 2 / 4 + 4 * A * (w + e), Zz = 2 * sand_heap(b, tf) + di * tw ^ 2 / 2 },
  }
end

--- The part of an outline, moved to its centroid, and its properties in axes x and y that are principal ones.
-- more.carries: rectangles { x0, x1, y0, y1 } that carry shear along x and along y.
local function by_outline(kind, law, corners, more)
  local m = outline.moments(corners)
  local low_x, low_y, high_x, high_y = math.huge, math.huge, -math.huge, -math.huge
  for _, p in ipairs(corners) do
    low_x, low_y = math.min(low_x, p[1]), math.min(low_y, p[2])
    high_x, high_y = math.max(high_x, p[1]), math.max(high_y, p[2])
  end
  return {
    kind = kind, interaction = law, outline = { { corners = corners } },
    size = { width = high_x - low_x, depth = high_y - low_y }, area = m.A, Ix = m.yy, Iy = m.xx, J = more.J,
    shear_area_x = outline.shear_area(more.walls, more.t, 1), shear_area_y = outline.shear_area(more.walls, more.t, 2),
    plastic = { A = m.A, Zx = outline.plastic_modulus(corners, 2), Zy = outline.plastic_modulus(corners, 1),
      Zz = more.Zz }, shear_walls = more.carries,
  }
end

--- Part of the torsion constant that a joint of two walls adds: alpha D^4 of El Darwish and Johnston (1965).
local function joint(alpha, tw, tf, r)
  return alpha * (2 * (3 * r + tw + tf - math.sqrt(2 * (2 * r + tw) * (2 * r + tf)))) ^ 4
end

--- Channel: the web along y, both flanges towards +x. slope: of the inner faces of the flanges, as UPN have it;
-- `flange` is then the thickness at the distance flange_at from the back, by default half the width. r: root radius;
-- r_toe: of the toes. J: El Darwish and Johnston, with the flanges' thickness at flange_at. Shear areas: of the walls'
-- middle lines. Forces act at the centroid: that the shear centre is elsewhere, behind the web, is not modelled.
function shapes.channel(options)
  local where = "hinge.section.channel"
  local o = check.options(where, options, { depth = length, width = length, web = length, flange = length, r = radius,
    r_toe = radius, slope = { "number", at_least = 0, below = 0.5, default = 0 }, flange_at = optional_length,
    interaction = interaction })
  local b, d, tw, tf, r, r_toe = o.width, o.depth, o.web, o.flange, o.r or 0, o.r_toe or 0
  must_be_below(where, "web", tw, b, "the width")
  must_be_below(where, "flange_at", o.flange_at or b / 2, b, "the width")
  local function thickness(x) return tf + o.slope * ((o.flange_at or b / 2) - x) end
  local root, toe = thickness(tw), thickness(b)
  must_be_below(where, "flange", root, d / 2, "half the depth at the web")
  if toe <= 0 then check.fail("%s: field 'slope' is %s; the flanges end before their toes", where,
    check.show(o.slope)) end
  must_be_at_most(where, "r", r, d / 2 - root, "half the clear depth between the flanges")
  must_be_at_most(where, "r_toe", r_toe, toe, "the flange's thickness at its toe")
  must_be_at_most(where, "r", r, b - tw - r_toe, "the flange's part beside the web, less r_toe")
  local corners = outline.rounded { { 0, -d / 2 }, { b, -d / 2 }, { b, toe - d / 2, r_toe }, { tw, root - d / 2, r },
    { tw, d / 2 - root, r }, { b, d / 2 - toe, r_toe }, { b, d / 2 }, { 0, d / 2 } }
  local m = outline.moments(corners)
  local cx = m.x / m.A
  local w, q = tw / tf, r / tf
  local alpha = -0.0908 + 0.2621 * w + 0.1231 * q - 0.0752 * w * q - 0.0945 * w ^ 2
  local y = (d - tf) / 2
  return by_outline("channel", o.interaction, outline.moved(corners, cx, m.y / m.A), {
    J = (2 * b * tf ^ 3 + (d - 2 * tf) * tw ^ 3) / 3 + 2 * joint(alpha, tw, tf, r) - 0.42 * tf ^ 4,
    Zz = 2 * sand_heap(b, tf) + (d - 2 * tf) * tw ^ 2 / 2,
    walls = { { b - cx, -y }, { tw / 2 - cx, -y }, { tw / 2 - cx, y }, { b - cx, y } }, t = { tf, tw, tf },
    carries = { x = { { -cx, b - cx, d / 2 - tf, d / 2 }, { -cx, b - cx, -d / 2, tf - d / 2 } },
      y = { { -cx, tw - cx, tf - d / 2, d / 2 - tf } } },
  })
end

--- Angle of two legs, `depth` and `width`. x and y are its principal axes: Ix is the larger moment (u-u of tables), and
-- the corner where the legs meet is on the side of -x. Legs of equal length make 45 degrees with x. r: root radius;
-- r_toe: of the toes. J: El Darwish and Johnston. Shear areas of the legs' middle lines. Forces act at the centroid:
-- that the shear centre is where the legs meet is not modelled.
function shapes.angle(options)
  local where = "hinge.section.angle"
  local o = check.options(where, options, { depth = length, width = length, thickness = length, r = radius,
    r_toe = radius, interaction = interaction })
  local b, d, t, r, r_toe = o.width, o.depth, o.thickness, o.r or 0, o.r_toe or 0
  local shorter = math.min(b, d)
  must_be_below(where, "thickness", t, shorter, "the shorter leg")
  must_be_at_most(where, "r_toe", r_toe, t, "the thickness")
  must_be_at_most(where, "r", r, shorter - t - r_toe, "the shorter leg's clear length, less r_toe")
  local corners = outline.rounded { { 0, 0 }, { b, 0 }, { b, t, r_toe }, { t, t, r }, { t, d, r_toe }, { 0, d } }
  local m = outline.moments(corners)
  local cx, cy = m.x / m.A, m.y / m.A
  local Ixx, Iyy, Ixy = m.yy - m.A * cy ^ 2, m.xx - m.A * cx ^ 2, m.xy - m.A * cx * cy
  local turn = 0.5 * math.atan(-2 * Ixy, Ixx - Iyy) -- from the leg along x to the axis of the larger moment
  if math.cos(turn) * cx + math.sin(turn) * cy < 0 then turn = turn + pi end
  local function moved(points) return outline.moved(points, cx, cy, turn) end
  return by_outline("angle", o.interaction, moved(corners), {
    J = (b * t ^ 3 + (d - t) * t ^ 3) / 3 + joint(0.0768 + 0.0479 * r / t, t, t, r) - 0.21 * t ^ 4,
    Zz = sand_heap(b, t) + (d - t) * t ^ 2 / 2,
    walls = moved { { b, t / 2 }, { t / 2, t / 2 }, { t / 2, d } }, t = { t, t },
  })
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
