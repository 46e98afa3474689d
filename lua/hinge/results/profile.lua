-- The plates of a section, found from its properties: what the checks of standards need beyond area and moduli.
--
-- profile.of(section) returns { shape = "h", "box", "pipe", "rectangle" or "round", b =, d =, tw =, tf =, r =, ...,
-- made = "rolled", "welded", "hot", "cold" or "solid" }; or nil and the reason why the section is not known.
local root = require "hinge.library.numeric".root

local profile = {}

local near = 1e-6 -- of the property that is compared

local function same(a, b) return math.abs(a - b) <= near * math.abs(b) end

-- An H by its plates. The fillets are what the area has beyond the plates.
local function as_h(s)
  local b, d, tw, tf = s.width, s.depth, s.web, s.flange
  if not (tw > 0 and tf > 0) then return nil end
  local fillets = s.area - 2 * b * tf - (d - 2 * tf) * tw
  if fillets < -1e-4 * s.area then return nil, "its area is less than that of its plates" end
  local r = fillets > 1e-6 * s.area and math.sqrt(fillets / (4 - math.pi)) or 0
  return { shape = "h", made = r > 0 and "rolled" or "welded", b = b, d = d, tw = tw, tf = tf, r = r, hw = d - 2 * tf,
    c_web = d - 2 * tf - 2 * r, c_flange = (b - tw - 2 * r) / 2, warping = s.Iy * (d - tf) ^ 2 / 4 }
end

local function as_solid(s)
  local b, d = s.width, s.depth
  if same(b * d, s.area) and same(b * d ^ 3 / 12, s.Ix) then
    return { shape = "rectangle", made = "solid", b = b, d = d }
  elseif same(b, d) and same(math.pi * d ^ 2 / 4, s.area) and same(math.pi * d ^ 4 / 64, s.Ix) then
    return { shape = "round", made = "solid", b = d, d = d }
  end
end

local function as_pipe(s)
  local D = s.depth
  if not same(s.width, D) or not same(s.Ix, s.Iy) then return nil end
  local inside = D ^ 2 - 4 * s.area / math.pi
  if inside <= 0 then return nil end
  local inner = math.sqrt(inside)
  if not same(math.pi * (D ^ 4 - inner ^ 4) / 64, s.Ix) then return nil end
  local made = s.kind:find "^CHS" and "hot" or "cold"
  return { shape = "pipe", made = made, b = D, d = D, tw = (D - inner) / 2, tf = (D - inner) / 2 }
end

-- Second moment of area, about x, of a box with walls of one thickness and rounded corners.
local function inertia(b, d, t, ro, ri)
  local function part(across, along, r)
    local e, A = r * (10 - 3 * math.pi) / (12 - 3 * math.pi), (1 - math.pi / 4) * r ^ 2
    local own = r ^ 4 * (1 / 3 - math.pi / 16 - 1 / (9 * (4 - math.pi)))
    return across * along ^ 3 / 12 - 4 * (own + A * (along / 2 - e) ^ 2)
  end
  return part(b, d, ro) - part(b - 2 * t, d - 2 * t, ri)
end

local function box_of(s, t, ro, ri, made)
  local b, d = s.width, s.depth
  return { shape = "box", made = made, b = b, d = d, tw = t, tf = t, hw = d - 2 * t,
    c_web = d - (ro > 0 and 3 or 2) * t, c_flange = b - (ro > 0 and 3 or 2) * t, r = ro, r_inner = ri }
end

-- A box whose corners have radii in proportion to its thickness, and whose area and second moment fit.
local function rounded(s, outer, inner, made)
  local b, d = s.width, s.depth
  local function area(t)
    return 2 * t * (b + d - 2 * t) - (4 - math.pi) * ((outer * t) ^ 2 - (inner * t) ^ 2)
  end
  local t = root(function(v) return area(v) - s.area end, 0, 0.25 * math.min(b, d))
  if same(area(t), s.area) and same(inertia(b, d, t, outer * t, inner * t), s.Ix) then
    return box_of(s, t, outer * t, inner * t, made)
  end
end

-- Radii over the thickness of hollow sections: EN 10210-2; EN 10219-2 by thickness; AISC, of the design thickness; BCR
-- and BCP of Japan.
local function as_hollow(s)
  local cold = s.kind:find "^CF" or s.kind:find "^HSS" or s.kind:find "^BC"
  for _, ratios in ipairs { { 1.5, 1 }, { 2, 1 }, { 2.5, 1.5 }, { 3, 2 }, { 3.5, 2.5 } } do
    local made = not cold and ratios[1] == 1.5 and "hot" or "cold"
    local found = rounded(s, ratios[1], ratios[2], made)
    if found then return found end
  end
end

-- A box with sharp corners, whose webs and flanges may differ.
local function as_welded(s)
  local b, d = s.width, s.depth
  local function inner_width(tf) return (b * d - s.area) / (d - 2 * tf) end
  local function excess(tf)
    return (b * d ^ 3 - inner_width(tf) * (d - 2 * tf) ^ 3) / 12 - s.Ix
  end
  if b * d <= s.area then return nil end
  local tf = root(excess, 0, d / 2 * s.area / (b * d))
  local tw = (b - inner_width(tf)) / 2
  if not (tw > 0 and tf > 0 and same(excess(tf) + s.Ix, s.Ix)) then return nil end
  if not same((d * b ^ 3 - (d - 2 * tf) * (b - 2 * tw) ^ 3) / 12, s.Iy) then return nil end
  return { shape = "box", made = "welded", b = b, d = d, tw = tw, tf = tf, hw = d - 2 * tf, c_web = d - 2 * tf,
    c_flange = b - 2 * tw, r = 0, r_inner = 0 }
end

--- The plates of a section, or nil and a reason.
function profile.of(s)
  if s.kind == "concrete" then return nil, "it is of concrete" end
  local found, why = as_h(s)
  if found or why then return found, why end
  if not (s.width > 0 and s.depth > 0) then return nil, "it has no size" end
  found = as_solid(s) or as_pipe(s) or as_hollow(s) or as_welded(s)
  if found then return found end
  return nil, "its plates are not known: only H, box, pipe, rectangle and round bar are"
end

return profile
