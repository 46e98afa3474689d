-- Sections that tables and other programs have, by their dimensions, m: tees, pairs of angles, and H with flanges that
-- taper. Properties are those of the outline.
local outline = require "hinge.sections.outline"
local shapes = require "hinge.sections.shapes"

local tees = {}

-- Fully plastic torque over shear yield stress of a plate b by t (b >= t): Nadai's sand heap.
local function sand_heap(b, t)
  if b < t then b, t = t, b end
  return t * t * (3 * b - t) / 6
end

--- Tee: the flange on top, the stem below it; depth with the flange, width of the flange, web the stem's thickness, r
--- the radius between the two. J: sum of b t^3 / 3. Shear areas: 5/6 of the flange and of the stem with the full depth.
function tees.tee(d)
  local b, h, tw, tf, r = d.width, d.depth, d.web, d.flange, d.r or 0
  if not (tw < b and tf < h) then error("hinge: the tee's stem is wider than its flange, or its flange deeper", 0) end
  local low = tf - h
  local corners = outline.rounded { { -tw / 2, low }, { tw / 2, low }, { tw / 2, 0, r }, { b / 2, 0 }, { b / 2, tf },
    { -b / 2, tf }, { -b / 2, 0 }, { -tw / 2, 0, r } }
  local m = outline.moments(corners)
  corners = outline.moved(corners, 0, m.y / m.A)
  local c = outline.moments(corners)
  return {
    kind = "tee", outline = { { corners = corners } }, size = { width = b, depth = h }, area = m.A, Ix = c.yy,
    Iy = c.xx,
    J = (b * tf ^ 3 + (h - tf) * tw ^ 3) / 3, shear_area_x = 5 / 6 * b * tf, shear_area_y = 5 / 6 * h * tw,
    plastic = { A = m.A, Zx = outline.plastic_modulus(corners, 2), Zy = outline.plastic_modulus(corners, 1),
      Zz = sand_heap(b, tf) + (h - tf) * tw ^ 2 / 2 },
  }
end

--- Two angles back to back: depth of the legs along y, which are back to back at the distance gap, width of the other
--- two, on top. They act as one section. J: twice that of an angle. Shear areas: of the legs.
function tees.double_angle(d)
  local h, b, t, gap = d.depth, d.width, d.thickness, d.gap or 0
  if not (t < h and t < b) then error("hinge: the angle's thickness is above a leg", 0) end
  -- the right one, its corner at the origin, legs down and to the right
  local one = { { 0, -h }, { t, -h }, { t, -t }, { b, -t }, { b, 0 }, { 0, 0 } }
  local m = outline.moments(one)
  local cx, cy = m.x / m.A + gap / 2, m.y / m.A
  local parts, moved = {}, outline.moved(one, -gap / 2, cy)
  local mirrored = {}
  for i, p in ipairs(moved) do mirrored[#moved + 1 - i] = { -p[1], p[2] } end
  parts[1], parts[2] = { corners = moved }, { corners = mirrored }
  local own = outline.moved(one, m.x / m.A, cy)
  local c = outline.moments(own)
  local legs = (h + b - t) * t ^ 3 / 3
  return {
    kind = "double angle", outline = parts, size = { width = 2 * b + gap, depth = h }, area = 2 * m.A, Ix = 2 * c.yy,
    Iy = 2 * (c.xx + m.A * cx ^ 2), J = 2 * legs, shear_area_x = 5 / 3 * b * t, shear_area_y = 5 / 3 * h * t,
    plastic = { A = 2 * m.A, Zx = 2 * outline.plastic_modulus(own, 2), Zy = 2 * m.A * cx,
      Zz = 2 * (sand_heap(h, t) + (b - t) * t ^ 2 / 2) },
  }
end

--- H with flanges that taper by the slope 1 : 6, as S have them; flange: the mean thickness of a flange beside the web.
function tees.tapered(d)
  local x, y, w = d.width / 2, d.depth / 2, d.web / 2
  local dt = (x - w) / 12 -- half of what the thickness changes by
  local root, toe = y - d.flange - dt, y - d.flange + dt
  local corners = { { -x, -y }, { x, -y }, { x, -toe }, { w, -root }, { w, root }, { x, toe }, { x, y }, { -x, y },
    { -x, toe }, { -w, root }, { -w, -root }, { -x, -toe } }
  local m, plates = outline.moments(corners), shapes.h { depth = d.depth, width = d.width, web = d.web,
    flange = d.flange }
  plates.outline, plates.area, plates.Ix, plates.Iy = { { corners = corners } }, m.A, m.yy, m.xx
  plates.plastic.A, plates.interaction = m.A, d.interaction
  plates.plastic.Zx, plates.plastic.Zy = outline.plastic_modulus(corners, 2), outline.plastic_modulus(corners, 1)
  return plates
end

return tees
