-- Checks of steel members by AISC 360-16, LRFD: chapters D2(a), E3, F2, F3, F6, F7, F8, F11, G2, G4 to G6, H1.1, H3.
--
-- Axes are those of the section in hinge, which are x and y of the standard. Sources of the formulas: AISC 360-16, as
-- the AISC design examples apply them. Forces in N, moments in N m, lengths in m, stresses in Pa.
local aisc = { name = "AISC 360-16" }

local pi = math.pi
local phi = 0.9 -- of tension, compression, bending and torsion; of shear but for G2.1(a)

-- Plates --------------------------------------------------------------------------------------------------------------

-- Ratios of slenderness to limits of table B4.1a (compression: slender above 1) and B4.1b (bending: compact up to 1).
-- about_y: the webs of a box are flanges for bending about y.
local function ratios(p, E, fy, about_y)
  local root = math.sqrt(E / fy)
  if p.shape == "pipe" then
    return { compression = p.d / p.tw / (0.11 * E / fy), web = p.d / p.tw / (0.07 * E / fy), flange = 0 }
  elseif p.shape == "box" then
    local web, flange = p.c_web / p.tw, p.c_flange / p.tf
    return { compression = math.max(web, flange) / (1.40 * root), web = web / (2.42 * root),
      flange = math.max(about_y and web or 0, flange) / (1.12 * root) }
  elseif p.shape == "h" then
    local web, flange = p.c_web / p.tw, p.b / (2 * p.tf)
    local r = { web = web / (3.76 * root), lambda = flange, compact = 0.38 * root, slender = 1.0 * root,
      slender_y = 1.0 * root }
    local pressed = 0.56 * root
    if p.made == "welded" then -- built up: case 2 of B4.1a and case 11 of B4.1b, F_L = 0.7 Fy for compact webs
      local kc = math.min(math.max(0.35, 4 / math.sqrt(web)), 0.76)
      pressed, r.slender = 0.64 * math.sqrt(kc) * root, 0.95 * math.sqrt(kc / 0.7) * root
    end
    r.compression = math.max(web / (1.49 * root), flange / pressed)
    return r
  end
  return { compression = 0, web = 0, flange = 0 }
end

--- Why a section is not checked under d = { compression =, Mx =, My = }, or nil; and its slenderness over the limit.
function aisc.refused(p, fy, d, E)
  local r, compression = ratios(p, E, fy, d.My > 1e-3 * d.Mx), d.compression
  local of_flange = p.shape == "h" and r.lambda / r.slender or r.flange -- F3 and F6 have noncompact flanges of an H
  local largest = math.max(compression > 0 and r.compression or 0, r.web, of_flange)
  if compression > 0 and r.compression > 1 then
    return ("slender in compression (E7): %.3g of the limit"):format(r.compression), largest
  elseif r.web > 1 then
    return ("its %s is not compact: %.3g of the limit"):format(p.shape == "h" and "web" or "wall", r.web), largest
  elseif of_flange > 1 then
    return ("its flange is %s: %.3g of the limit"):format(p.shape == "h" and "slender" or "not compact", of_flange),
      largest
  end
  return nil, largest
end

-- Bending -------------------------------------------------------------------------------------------------------------

-- F3.2 and F6.2: what a noncompact flange of an H leaves of a moment. slender: the limit for bending about this axis.
local function by_flange(Mp, S, fy, r, slender)
  if r.lambda <= r.compact then return Mp end
  return Mp - (Mp - 0.7 * fy * S) * (r.lambda - r.compact) / (slender - r.compact)
end

-- F7.4: lateral torsional buckling of a box.
local function box_by_lateral(s, p, material, Mp, L)
  local E, fy, S = material.E, material.yield_stress, s.Ix / (p.d / 2)
  local ry, root = math.sqrt(s.Iy / s.area), math.sqrt(s.J * s.area)
  local Lp, Lr = 0.13 * E * ry * root / Mp, 2 * E * ry * root / (0.7 * fy * S)
  if L.Lb <= Lp or p.d <= p.b then return Mp, Lp, Lr end
  if L.Lb > Lr then return math.min(Mp, 2 * E * L.Cb * root / (L.Lb / ry)), Lp, Lr end
  return math.min(Mp, L.Cb * (Mp - (Mp - 0.7 * fy * S) * (L.Lb - Lp) / (Lr - Lp))), Lp, Lr
end

-- F11.2: lateral torsional buckling of an upright rectangle.
local function bar_by_lateral(s, p, material, Mp, L)
  local E, fy, S = material.E, material.yield_stress, s.Ix / (p.d / 2)
  local ratio = L.Lb * p.d / p.b ^ 2
  if ratio <= 0.08 * E / fy or p.d <= p.b then return Mp end
  if ratio > 1.9 * E / fy then return math.min(Mp, 1.9 * E * L.Cb / ratio * S) end
  return math.min(Mp, L.Cb * (1.52 - 0.274 * ratio * fy / E) * fy * S)
end

-- F2.2: lateral torsional buckling of an H between lateral supports Lb apart.
local function h_by_lateral(s, p, material, Mp, L)
  local E, fy, h0 = material.E, material.yield_stress, p.d - p.tf
  local S = s.Ix / (p.d / 2)
  local rts = math.sqrt(math.sqrt(s.Iy * p.warping) / S)
  local ry = math.sqrt(s.Iy / s.area)
  local Lp = 1.76 * ry * math.sqrt(E / fy)
  local twist = s.J / (S * h0)
  local Lr = 1.95 * rts * E / (0.7 * fy) * math.sqrt(twist + math.sqrt(twist ^ 2 + 6.76 * (0.7 * fy / E) ^ 2))
  if L.Lb <= Lp then return Mp, Lp, Lr end
  if L.Lb <= Lr then
    return math.min(Mp, L.Cb * (Mp - (Mp - 0.7 * fy * S) * (L.Lb - Lp) / (Lr - Lp))), Lp, Lr
  end
  local Fcr = L.Cb * pi ^ 2 * E / (L.Lb / rts) ^ 2 * math.sqrt(1 + 0.078 * twist * (L.Lb / rts) ^ 2)
  return math.min(Mp, Fcr * S), Lp, Lr
end

local laterals = { h = h_by_lateral, box = box_by_lateral, rectangle = bar_by_lateral }

-- What lateral torsional buckling leaves of the plastic moment about x, where Lb is given; limits of Lb.
local function by_lateral(s, p, material, Mp, L)
  local law = L.Lb and laterals[p.shape]
  if not law then return Mp end
  return law(s, p, material, Mp, L)
end

-- Nominal moments about x and y.
local function moments(s, p, material, L)
  local fy = material.yield_stress
  local Mpx, Mpy = fy * s.Zx, fy * s.Zy
  if p.shape == "h" then
    local r = ratios(p, material.E, fy)
    local Sx, Sy = s.Ix / (p.d / 2), s.Iy / (p.b / 2)
    local lateral, Lp, Lr = by_lateral(s, p, material, Mpx, L)
    local top = math.min(Mpy, 1.6 * fy * Sy)
    return math.min(lateral, by_flange(Mpx, Sx, fy, r, r.slender)), by_flange(top, Sy, fy, r, r.slender_y), Lp, Lr
  elseif p.shape == "rectangle" or p.shape == "round" then -- F11.1
    Mpx = math.min(Mpx, 1.6 * fy * s.Ix / (p.d / 2))
    return by_lateral(s, p, material, Mpx, L), math.min(Mpy, 1.6 * fy * s.Iy / (p.b / 2))
  end
  local lateral, Lp, Lr = by_lateral(s, p, material, Mpx, L)
  return lateral, Mpy, Lp, Lr
end

-- Shear and torsion ---------------------------------------------------------------------------------------------------

local function web_of_h(p, fy, E)
  local slenderness, root = p.c_web / p.tw, math.sqrt(E / fy)
  if p.made == "rolled" and slenderness <= 2.24 * root then return 1.0 end -- G2.1(a): phi is 1
  local limit = 1.10 * math.sqrt(5.34) * root
  return phi * (slenderness <= limit and 1 or limit / slenderness)
end

-- Available shear forces along x and y, and torque.
local function shears(s, p, fy, E)
  local full = 0.6 * fy
  if p.shape == "h" then -- Mz of an H: Saint-Venant's torsion at full yield
    return phi * full * 2 * p.b * p.tf, web_of_h(p, fy, E) * full * p.d * p.tw, phi * full * s.Zz
  elseif p.shape == "box" then
    local h, w = p.d - 3 * p.tf, p.b - 3 * p.tw
    local C = 2 * (p.b - p.tw) * (p.d - p.tf) * math.min(p.tw, p.tf)
      - (p.r > 0 and 4.5 * (4 - pi) * p.tw ^ 3 or 0)
    return phi * full * 2 * w * p.tf, phi * full * 2 * h * p.tw, phi * full * C
  elseif p.shape == "pipe" then -- G5 and H3.1(a), for short and stocky tubes
    return phi * full * s.area / 2, phi * full * s.area / 2, phi * full * 2 * s.J / p.d -- C of tables
  end
  local part = p.shape == "round" and 3 / 4 or 2 / 3
  return phi * full * part * s.area, phi * full * part * s.area, phi * full * s.Zz
end

-- Axial force ---------------------------------------------------------------------------------------------------------

-- Available strength in compression by E3 for buckling about one axis.
local function buckling(s, I, length, material)
  local E, fy = material.E, material.yield_stress
  local slenderness = length / math.sqrt(I / s.area)
  local Fe = pi ^ 2 * E / slenderness ^ 2
  local Fcr = slenderness <= 4.71 * math.sqrt(E / fy) and 0.658 ^ (fy / Fe) * fy or 0.877 * Fe
  return phi * Fcr * s.area, slenderness
end

-- Equations H1-1a and H1-1b.
local function combined(n, mx, my)
  if n >= 0.2 then return n + 8 / 9 * (mx + my) end
  return n / 2 + mx + my
end

--- The available strengths of a member: { tension, compression_x, compression_y, Mx, My, Vx, Vy, T }, N and N m.
function aisc.strengths(s, p, material, L)
  local fy = material.yield_stress
  local Mx, My, Lp, Lr = moments(s, p, material, L)
  local Vx, Vy, T = shears(s, p, fy, material.E)
  local R = { tension = phi * fy * s.area, Mx = phi * Mx, My = phi * My, Vx = Vx, Vy = Vy, T = T, Lp = Lp, Lr = Lr }
  R.compression_x, R.slenderness_x = buckling(s, s.Ix, L.Lx, material)
  R.compression_y, R.slenderness_y = buckling(s, s.Iy, L.Ly, material)
  return R
end

--- The checks of one section under its resultants.
function aisc.section(_, p, at, R)
  local vx, vy, t = math.abs(at.Qx) / R.Vx, math.abs(at.Qy) / R.Vy, math.abs(at.Mz) / R.T
  if p.shape == "pipe" or p.shape == "round" then
    vx = math.sqrt(vx ^ 2 + vy ^ 2)
    vy = vx
  end
  local mx, my = math.abs(at.Mx) / R.Mx, math.abs(at.My) / R.My
  local compressed = at.N < 0
  local n = math.abs(at.N) / (compressed and math.min(R.compression_x, R.compression_y) or R.tension)
  local checks = { ["F Mx"] = mx, ["F My"] = my, ["G Vx"] = vx, ["G Vy"] = vy, ["H3 T"] = t }
  checks[compressed and "E3 N" or "D2 N"] = n
  checks["H1-1"] = combined(n, mx, my)
  if (p.shape == "box" or p.shape == "pipe") and t > 0.2 then
    checks["H3-6"] = n + mx + my + (math.max(vx, vy) + t) ^ 2
  end
  return checks
end

--- The check of a member under its largest compression and moments.
function aisc.member(d, R)
  if not (d.compression > 0) then return {} end
  local n = d.compression / math.min(R.compression_x, R.compression_y)
  return { ["H1-1 member"] = combined(n, d.Mx / R.Mx, d.My / R.My) }
end

return aisc
