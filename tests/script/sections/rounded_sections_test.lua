-- Sections with root fillets and rounded corners, channels and angles: against strips added up and closed forms found
-- another way; what of a radius is refused. named_sections_test.lua compares outlines and published tables.
--
-- Run: LUA_CPATH="build/?.so" lua5.4 tests/script/sections/rounded_sections_test.lua
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local hinge = require "hinge"
local support = require "support"
local shapes = require "hinge.sections.shapes"
local outline = require "sections.polygons"

local checks = support.checks "rounded sections"
local case, expect, equal = checks.case, checks.expect, checks.equal
local function close(value, wanted, tolerance, what)
  return expect(math.abs(value - wanted) <= tolerance * math.abs(wanted), "%s: %.9g, wanted %.9g within %.1g", what,
    value, wanted, tolerance)
end

-- Area, second moment and plastic modulus of a section that is symmetric about the axis, by adding up strips.
local function strips(half, breadth)
  local n, A, I, Z = 100000, 0, 0, 0
  local h = half / n
  for i = 1, n do
    local v = (i - 0.5) * h
    local b = breadth(v) * h
    A, I, Z = A + 2 * b, I + 2 * b * v ^ 2, Z + 2 * b * v
  end
  return A, I, Z
end
-- A strip of half / 100000 that meets an edge is off by its own area: 1e-5 of the properties of these sections.
local by_strips = 2e-5
local function bends(shape, axis, half, breadth, what)
  local A, I, Z = strips(half, breadth)
  close(shape.area, A, by_strips, what .. ": area")
  close(shape["I" .. axis], I, by_strips, what .. ": I" .. axis)
  close(shape.plastic["Z" .. axis], Z, by_strips, what .. ": Z" .. axis)
end

-- The distance of an arc from the side that it touches.
local function arc(r, from_centre) return r - math.sqrt(support.largest_of(r ^ 2 - from_centre ^ 2, 0)) end

case("an H with fillets has the properties of its strips", function()
  local b, d, tw, tf, r = 0.3, 0.3, 0.011, 0.019, 0.027
  local of = shapes.h { width = b, depth = d, web = tw, flange = tf, r = r }
  local f, w = d / 2 - tf, tw / 2
  bends(of, "x", d / 2, function(v)
    return v > f and b or tw + (v > f - r and 2 * arc(r, v - (f - r)) or 0)
  end, "about x")
  bends(of, "y", b / 2, function(v)
    return v < w and d or 2 * tf + (v < w + r and 2 * arc(r, w + r - v) or 0)
  end, "about y")
end)

case("a box with rounded corners has the properties of its strips", function()
  for _, o in ipairs {
    { width = 0.1, depth = 0.2, thickness = 0.01, r = 0.025 }, -- cold formed: the same wall around the corner
    { width = 0.1, depth = 0.2, thickness = 0.01, r = 0.015, r_inner = 0.01 }, -- hot finished
    { width = 0.2, depth = 0.3, web = 0.008, flange = 0.02, r = 0.03 },
    { width = 0.2, depth = 0.2, thickness = 0.05, r = 0.02 }, -- sharp within
  } do
    local of = shapes.box(o)
    local tw, tf = o.web or o.thickness, o.flange or o.thickness
    local ri = o.r_inner or support.largest_of(o.r - support.largest_of(tw, tf), 0)
    local function side(v, along, across, r) -- breadth at v of a rectangle with rounded corners
      local from = v - (along / 2 - r)
      return v > along / 2 and 0 or across - (from > 0 and 2 * arc(r, from) or 0)
    end
    local function breadth(along, across, t_along, t_across)
      return function(v)
        return side(v, along, across, o.r) - side(v, along - 2 * t_along, across - 2 * t_across, ri)
      end
    end
    bends(of, "x", o.depth / 2, breadth(o.depth, o.width, tf, tw), "about x")
    bends(of, "y", o.width / 2, breadth(o.width, o.depth, tw, tf), "about y")
  end
end)

-- The moment beside N, from strips: the part of the area next to the axis carries N.
local function reduced(half, breadth, n)
  local A, _, Z = strips(half, breadth)
  local count = 100000
  local h, within, rest = half / count, 0, 0
  for i = 1, count do
    local v = (i - 0.5) * h
    within = within + 2 * breadth(v) * h
    if within > n * A then rest = rest + 2 * breadth(v) * v * h end
  end
  return rest / Z
end
case("the moment beside an axial force has the fillets", function()
  local o = { width = 0.3, depth = 0.3, web = 0.011, flange = 0.019, r = 0.027 }
  local rolled = hinge.section.h(o)
  o.r = nil
  local plates = hinge.section.h(o)
  for _, n in ipairs { 0.1, 0.3, 0.6, 0.9 } do
    local about_x, about_y = rolled:reduced_moments(n)
    local function by_x(v)
      return v > 0.131 and 0.3 or 0.011 + (v > 0.104 and 2 * arc(0.027, v - 0.104) or 0)
    end
    local function by_y(v) return v < 0.0055 and 0.3 or 0.038 + (v < 0.0325 and 2 * arc(0.027, 0.0325 - v) or 0) end
    -- three pieces for an arc: beyond an axis through it the area is off by 1e-4 of the section's at most
    local wanted_x, wanted_y = reduced(0.15, by_x, n), reduced(0.15, by_y, n)
    expect(math.abs(about_x - wanted_x) < 1e-4, "about x, n %g: %g, wanted %g", n, about_x, wanted_x)
    expect(math.abs(about_y - wanted_y) < 1e-4, "about y, n %g: %g, wanted %g", n, about_y, wanted_y)
    local without = select(2, plates:reduced_moments(n))
    expect(about_y > without + 4e-4 or n < 0.2, "about y not that of three plates at n %g: %g", n, about_y)
  end
  equal(rolled:reduced_moments(1), 0, "at n = 1")
  equal(rolled:reduced_moments(0), 1, "at n = 0")
  local pipe = hinge.section.general { kind = "a tube", area = math.pi / 4 * (0.2 ^ 2 - 0.18 ^ 2), Ix = 2.7e-5,
    Iy = 2.7e-5, J = 5.4e-5, plastic = { A = 5.97e-3, Zx = 3.61e-4, Zy = 3.61e-4 },
    outline = { { diameter = 0.2 }, { diameter = 0.18, hole = true } } }
  close(pipe:reduced_moments(0.4), hinge.section.pipe { diameter = 0.2, thickness = 0.01 }:reduced_moments(0.4), 1e-9,
    "circles of an outline")
end)

case("a channel has the properties of its three plates", function()
  local b, d, tw, tf = 0.1, 0.2, 0.02, 0.016
  local of = shapes.channel { width = b, depth = d, web = tw, flange = tf }
  local web, flange = (d - 2 * tf) * tw, b * tf
  local A = web + 2 * flange
  local cx = (web * tw / 2 + 2 * flange * b / 2) / A
  close(of.area, A, 1e-12, "area")
  close(of.Ix, (b * d ^ 3 - (b - tw) * (d - 2 * tf) ^ 3) / 12, 1e-12, "Ix")
  close(of.Iy, (d - 2 * tf) * tw ^ 3 / 12 + web * (tw / 2 - cx) ^ 2 + 2 * (tf * b ^ 3 / 12 + flange * (b / 2 - cx) ^ 2),
    1e-12, "Iy")
  close(of.plastic.Zx, (b * d ^ 2 - (b - tw) * (d - 2 * tf) ^ 2) / 4, 1e-12, "Zx")
  local e = A / 2 / d -- half of the area is beside this line from the back, within the web
  expect(e < tw, "the line that halves the area is in the web: %g m", e)
  close(of.plastic.Zy, d * e ^ 2 / 2 + d * (tw - e) ^ 2 / 2 + 2 * tf * (b - tw) * ((b + tw) / 2 - e), 1e-10, "Zy")
  -- a thin one, by the shear flows of its walls: Q = t h s / 2 in a flange, and the parabola of the web on top of it
  local t, h, w = 1e-4, 0.2, 0.1
  local thin = shapes.channel { width = w + t / 2, depth = h + t, web = t, flange = t }
  local I = t * h ^ 3 / 12 + 2 * w * t * h ^ 2 / 4
  local flow = 2 * t * h ^ 2 / 4 * w ^ 3 / 3
  for i = 1, 10000 do
    local y = h / 2 * (i - 0.5) / 10000
    flow = flow + 2 * (w * t * h / 2 + t / 2 * (h ^ 2 / 4 - y ^ 2)) ^ 2 / t * h / 2 / 10000
  end
  close(thin.shear_area_y, I ^ 2 / flow, 2e-3, "shear area along the web") -- t / w of the middle lines
end)

case("an angle has its principal moments, and no product of inertia", function()
  local a, b, t = 0.15, 0.1, 0.012
  local of = shapes.angle { depth = a, width = b, thickness = t }
  local A = t * (a + b - t)
  local cx = (b * t * b / 2 + (a - t) * t * t / 2) / A
  local cy = (b * t * t / 2 + (a - t) * t * (a + t) / 2) / A
  local Ix = (t * a ^ 3 + (b - t) * t ^ 3) / 3 - A * cy ^ 2
  local Iy = (t * b ^ 3 + (a - t) * t ^ 3) / 3 - A * cx ^ 2
  local Ixy = (b ^ 2 * t ^ 2 + (a ^ 2 - t ^ 2) * t ^ 2) / 4 - A * cx * cy
  local mean, radius = (Ix + Iy) / 2, math.sqrt((Ix - Iy) ^ 2 / 4 + Ixy ^ 2)
  close(of.area, A, 1e-12, "area")
  close(of.Ix, mean + radius, 1e-9, "I about u-u")
  close(of.Iy, mean - radius, 1e-9, "I about v-v")
  local m = outline.moments(of.outline[1].corners)
  expect(math.abs(m.xy) < 1e-12 * of.Ix, "product of inertia %g m^4", m.xy)
  expect(math.abs(m.x) < 1e-12 * A and math.abs(m.y) < 1e-12 * A, "the centroid is the origin: %g, %g", m.x, m.y)
  local heel = of.outline[1].corners[1]
  expect(heel[1] < -0.2 * b, "the legs meet on the side of -x: %g m", heel[1])
  -- legs of equal length: u-u is the axis of symmetry
  local equal_legs = shapes.angle { depth = 0.1, width = 0.1, thickness = 0.01, r = 0.012, r_toe = 0.006 }
  for _, p in ipairs(equal_legs.outline[1].corners) do
    local mirrored = false
    for _, q in ipairs(equal_legs.outline[1].corners) do
      mirrored = mirrored or math.abs(p[1] - q[1]) + math.abs(p[2] + q[2]) < 1e-12
    end
    expect(mirrored, "corner %g, %g has no mirror image", p[1], p[2])
  end
  -- one leg of thin walls carries both: along u its shear area is that of its flows, 2 L t = A of which 5/12 counts
  local thin = shapes.angle { depth = 1, width = 1, thickness = 1e-4 }
  close(thin.shear_area_y, 5 / 12 * thin.area, 1e-3, "shear area along v")
end)

case("a section without a radius has the same bits as with r = 0", function()
  for _, name in ipairs { "h", "box" } do
    local o = { width = 0.13, depth = 0.27, web = 0.007, flange = 0.0113 }
    local plain = shapes[name](o)
    o.r = 0
    local with = shapes[name](o)
    for _, k in ipairs { "area", "Ix", "Iy", "J", "shear_area_x", "shear_area_y" } do equal(with[k], plain[k], k) end
    for k, v in pairs(plain.plastic) do equal(with.plastic[k], v, k) end
    equal(#plain.outline[1].corners, name == "h" and 12 or 4, "corners")
  end
end)

case("a radius that does not fit is refused", function()
  local s = hinge.section
  for _, row in ipairs {
    { s.h, { depth = 0.3, width = 0.3, web = 0.011, flange = 0.019, r = 0.14 }, "'r' is 0.14 m",
      "at most half the clear depth between the flanges, 0.131 m" },
    { s.h, { depth = 0.6, width = 0.1, web = 0.02, flange = 0.019, r = 0.05 }, "'r' is 0.05 m",
      "the flange's part beside the web, 0.04 m" },
    { s.h, { depth = 0.6, width = 0.1, web = 0.02, flange = 0.019, r = -0.01 }, "'r' is -0.01 m", "at least 0 m" },
    { s.box, { depth = 0.2, width = 0.1, thickness = 0.01, r = 0.06 }, "'r' is 0.06 m", "half the smaller side" },
    { s.box, { depth = 0.2, width = 0.1, thickness = 0.01, r = 0.04, r_inner = 0.045 }, "'r_inner' is 0.045 m",
      "half the smaller clear side, 0.04 m" },
    { s.box, { depth = 0.2, width = 0.1, thickness = 0.005, r = 0.04, r_inner = 0 }, "'r' is 0.04 m",
      "the corners are cut through" },
    { s.box, { depth = 0.2, width = 0.1, thickness = 0.005, r_inner = 0.01 }, "'r' is missing" },
    { s.channel, { depth = 0.2, width = 0.1, web = 0.01, flange = 0.01, slope = 0.3 }, "'slope' is 0.3", "toes" },
    { s.channel, { depth = 0.2, width = 0.05, web = 0.01, flange = 0.01, r = 0.05 }, "'r' is 0.05 m",
      "the flange's part beside the web" },
    { s.channel, { depth = 0.2, width = 0.1, web = 0.01, flange = 0.1 }, "half the depth at the web" },
    { s.angle, { depth = 0.1, width = 0.05, thickness = 0.01, r_toe = 0.02 }, "'r_toe' is 0.02 m", "the thickness" },
    { s.angle, { depth = 0.1, width = 0.05, thickness = 0.05 }, "'thickness' is 0.05 m", "the shorter leg" },
  } do
    checks.refused({ table.unpack(row, 3) }, row[1], row[2])
  end
  -- the flange of a channel is thinner than half its depth, and no more is asked
  equal(s.channel({ depth = 0.2, width = 0.1, web = 0.01, flange = 0.07 }).kind, "channel", "more than a third")
end)

checks.done()
