-- Checks of steel members by EN 1993-1-1:2005, for sections of class 1 and 2: 6.2 sections, 6.3 members with annex B.
--
-- Axes are those of the section in hinge: x is y-y of the standard, and y is z-z. Sources of the formulas: EN 1993-1-1,
-- as textbooks and public design tables give it; tests/script/results/results_test.lua compares with published
-- examples. Forces in N, moments in N m, lengths in m, stresses in Pa.
local eurocode = { name = "EN 1993-1-1" }

local pi = math.pi

-- Classes -------------------------------------------------------------------------------------------------------------

-- Whether a member is bent about y so little that its webs are compressed by N and Mx alone.
local function bends_about_x(d) return d.My <= 1e-3 * d.Mx end

--- The largest ratio of a plate's slenderness to the limit of class 2 (table 5.2), and the plate. The forces are d =
--- { compression =, Mx =, My = }. Flanges count as compressed throughout, and so do the webs of a box bent about y.
function eurocode.slenderness(p, fy, d)
  local e = math.sqrt(235e6 / fy)
  if p.shape == "pipe" then return p.d / p.tw / (70 * e ^ 2), "wall" end
  if p.shape ~= "h" and p.shape ~= "box" then return 0, "none" end
  local webs = p.shape == "box" and 2 or 1
  local part = math.min(1, (1 + d.compression / (fy * webs * p.tw * p.c_web)) / 2) -- compressed part of a web, alpha
  if p.shape == "box" and not bends_about_x(d) then part = 1 end
  local web = p.c_web / p.tw / (456 * e / (13 * part - 1))
  local flange = p.c_flange / p.tf / ((p.shape == "box" and 38 or 10) * e)
  if web > flange then return web, "web" end
  return flange, "flange"
end

-- Sections ------------------------------------------------------------------------------------------------------------

-- Shear areas along y and x: 6.2.6(3), with eta = 1. Of solid bars: elastic, 6.2.6(4).
local function shear_areas(s, p)
  if p.shape == "h" then
    local web = p.hw * p.tw
    local along_y = p.made == "rolled" and math.max(s.area - 2 * p.b * p.tf + (p.tw + 2 * p.r) * p.tf, web) or web
    return along_y, s.area - web
  elseif p.shape == "box" and p.made == "welded" then
    local webs = 2 * p.hw * p.tw
    return webs, s.area - webs
  elseif p.shape == "box" then
    return s.area * p.d / (p.b + p.d), s.area * p.b / (p.b + p.d)
  elseif p.shape == "pipe" then
    return 2 * s.area / pi, 2 * s.area / pi
  end
  local part = p.shape == "round" and 3 / 4 or 2 / 3
  return part * s.area, part * s.area
end

--- The plastic resistances of a section: N, Mx, My, Vx, Vy, T (N and N m), by gamma_M0.
function eurocode.resistances(s, p, fy, o)
  local f = fy / o.gamma_M0
  local Avy, Avx = shear_areas(s, p)
  return { N = s.area * f, Mx = s.Zx * f, My = s.Zy * f, Vy = Avy * f / math.sqrt(3), Vx = Avx * f / math.sqrt(3),
    T = s.Zz * f / math.sqrt(3), Avx = Avx, Avy = Avy, f = f }
end

-- Plastic moments beside the axial force n = N / N_pl: 6.2.9.1. Returns M_N,x, M_N,y and the exponents of 6.41.
local function beside_axial(s, p, R, n, o)
  if n >= 1 then return 0, 0, 1, 1 end
  if o.interaction == "linear" then return R.Mx * (1 - n), R.My * (1 - n), 1, 1 end
  local exact_x, exact_y = s:reduced_moments(n)
  if p.shape == "h" then
    local a, beta = math.min((s.area - 2 * p.b * p.tf) / s.area, 0.5), math.max(1, 5 * n)
    local low = n <= 0.25 and n * R.N <= 0.5 * p.hw * p.tw * R.f -- 6.33 and 6.34: no reduction
    local Mx = low and R.Mx or R.Mx * math.min(1, (1 - n) / (1 - 0.5 * a))
    local My = n <= a and R.My or R.My * (1 - ((n - a) / (1 - a)) ^ 2)
    if o.interaction == "exact" and exact_x then Mx, My = R.Mx * exact_x, R.My * exact_y end
    return Mx, My, 2, beta
  elseif p.shape == "box" then
    local aw = math.min((s.area - 2 * p.b * p.tf) / s.area, 0.5)
    local af = math.min((s.area - 2 * p.d * p.tw) / s.area, 0.5)
    local power = n < 0.8 and math.min(6, 1.66 / (1 - 1.13 * n ^ 2)) or 6
    local Mx, My = R.Mx * math.min(1, (1 - n) / (1 - 0.5 * aw)), R.My * math.min(1, (1 - n) / (1 - 0.5 * af))
    if o.interaction == "exact" and exact_x then Mx, My = R.Mx * exact_x, R.My * exact_y end
    return Mx, My, power, power
  elseif p.shape == "pipe" then
    local M = R.Mx * (1 - n ^ 1.7)
    if o.interaction == "exact" and exact_x then M = R.Mx * exact_x end
    return M, M, 2, 2
  elseif p.shape == "round" and exact_x then return R.Mx * exact_x, R.My * exact_y, 2, 2
  elseif p.shape == "rectangle" then return R.Mx * (1 - n ^ 2), R.My * (1 - n ^ 2), 1, 1 end -- 6.32
  return R.Mx * (1 - n), R.My * (1 - n), 1, 1
end

-- A ratio whose denominator may be 0 where something else has taken all strength.
local function over(part, whole)
  if part == 0 then return 0 end
  return whole > 0 and part / whole or math.huge
end

-- The factor on shear resistance beside torsion: 6.2.7(9).
local function beside_torsion(p, t)
  local left = p.shape == "h" and math.max(0, 1 - t / 1.25) ^ 0.5 or math.max(0, 1 - t)
  return math.max(left, 1e-6)
end

-- What shear beyond half of its resistance takes: 6.2.8. Factors on Mx, My and N. The yield stress is reduced in the
-- shear area: of an H the web for V along y (6.30), and the flanges for V along x, which carry the rest of Mx.
local function beside_shear(s, p, R, vx, vy)
  local rho_x = vx > 0.5 and math.min(1, (2 * vx - 1) ^ 2) or 0
  local rho_y = vy > 0.5 and math.min(1, (2 * vy - 1) ^ 2) or 0
  local sheared = (rho_y * R.Avy + rho_x * R.Avx) / s.area
  if p.shape == "h" then
    local web = (p.hw * p.tw) ^ 2 / (4 * p.tw) / s.Zx
    return 1 - rho_y * web - rho_x * (1 - web), 1 - rho_x, math.max(0, 1 - sheared)
  end
  -- of a pipe and a round bar vx and vy are the same, that of both
  if p.shape == "pipe" or p.shape == "round" then sheared = rho_y * R.Avy / s.area end
  local left = 1 - math.max(rho_x, rho_y)
  return left, left, math.max(0, 1 - sheared)
end

--- The checks of one section under its resultants, by clause or equation. Each is a ratio that may be at most 1.
function eurocode.section(s, p, fy, at, o)
  local R = eurocode.resistances(s, p, fy, o)
  local N, Mx, My = math.abs(at.N), math.abs(at.Mx), math.abs(at.My)
  local t = math.abs(at.Mz) / R.T
  local left = beside_torsion(p, t)
  local vx, vy = math.abs(at.Qx) / (R.Vx * left), math.abs(at.Qy) / (R.Vy * left)
  if p.shape == "pipe" or p.shape == "round" then
    vx = math.sqrt(vx ^ 2 + vy ^ 2)
    vy = vx
  end
  local kx, ky, kn = beside_shear(s, p, R, vx, vy)
  local n = over(N, R.N * kn)
  local MNx, MNy, alpha, beta = beside_axial(s, p, R, n, o)
  MNx, MNy = MNx * kx, MNy * ky
  local mx, my = over(Mx, MNx), over(My, MNy)
  local both = n >= 1 and n + over(Mx, R.Mx) + over(My, R.My) or mx ^ alpha + my ^ beta
  local checks = { [at.N < 0 and "6.2.4 N" or "6.2.3 N"] = N / R.N, ["6.2.6 Vx"] = vx, ["6.2.6 Vy"] = vy,
    ["6.2.7 T"] = t }
  if n < 1 then checks["6.2.9 Mx"], checks["6.2.9 My"] = mx, my end
  checks["6.41"] = both
  return checks, { R = R, n = n, MNx = MNx, MNy = MNy, alpha = alpha, beta = beta, vx = vx, vy = vy }
end

-- Members -------------------------------------------------------------------------------------------------------------

local imperfection = { a0 = 0.13, a = 0.21, b = 0.34, c = 0.49, d = 0.76 }
eurocode.curves = { "a0", "a", "b", "c", "d" }

--- The buckling curves about x and y by table 6.2.
function eurocode.curves_of(p, fy)
  local high = fy > 420e6
  if p.shape == "h" and p.made == "rolled" then
    if p.d / p.b > 1.2 and p.tf <= 0.04 then return high and "a0" or "a", high and "a0" or "b" end
    -- above 100 mm the table has a row for h / b up to 1.2 alone, and more slender ones are not better
    if p.tf <= 0.1 then return high and "a" or "b", high and "a" or "c" end
    return high and "c" or "d", high and "c" or "d"
  elseif p.shape == "h" then
    if p.tf <= 0.04 then return "b", "c" end
    return "c", "d"
  elseif p.made == "hot" then return high and "a0" or "a", high and "a0" or "a"
  elseif p.shape == "box" and p.made == "welded" then return "b", "b" end
  return "c", "c"
end

--- The reduction factor chi of 6.3.1.2 by the slenderness and a curve.
function eurocode.chi(slenderness, curve)
  if slenderness <= 0.2 then return 1 end
  local phi = (1 + imperfection[curve] * (slenderness - 0.2) + slenderness ^ 2) / 2
  return math.min(1, 1 / (phi + math.sqrt(phi ^ 2 - slenderness ^ 2)))
end

-- chi_LT of the general case, 6.3.2.2, for loads at the shear centre, of an H and of an upright rectangle. Other
-- sections have none.
local function lateral(s, p, material, o, L)
  local upright = p.shape == "rectangle" and p.d > p.b
  if not (p.shape == "h" or upright) or not L.Lb then return nil end
  local E, G = material.E, material.G
  local euler = pi ^ 2 * E * s.Iy / L.Lb ^ 2
  local critical = L.C1 * euler * math.sqrt((p.warping or 0) / s.Iy + G * s.J / euler)
  local slenderness = math.sqrt(s.Zx * material.yield_stress / critical)
  local curve = p.made == "rolled" and (p.d / p.b <= 2 and "a" or "b") or (p.d / p.b <= 2 and "c" or "d") -- table 6.4
  if upright then curve = "d" end
  return eurocode.chi(slenderness, o.curve_LT or curve), slenderness, critical
end

-- kxx, kxy, kyx and kyy by tables B.1 and B.2; nx, ny: N over chi N_Rk / gamma_M1; lx, ly: slendernesses. The tables
-- bound them from above alone: stocky members have less than Cm, and 6.2.9 governs there.
local function interaction_factors(p, Cm, nx, ny, lx, ly, turns_over)
  local kxx = Cm.x * (1 + math.min(lx - 0.2, 0.8) * nx)
  local kyy
  if p.shape == "h" then kyy = Cm.y * (1 + math.min(2 * ly - 0.6, 1.4) * ny)
  else kyy = Cm.y * (1 + math.min(ly - 0.2, 0.8) * ny) end
  if not turns_over then return kxx, 0.6 * kyy, 0.6 * kxx, kyy end
  local kyx = 1 - 0.1 * math.min(ly, 1) / (Cm.LT - 0.25) * ny
  if ly < 0.4 then kyx = math.min(0.6 + ly, 1 - 0.1 * ly / (Cm.LT - 0.25) * ny) end
  return kxx, 0.6 * kyy, kyx, kyy
end

--- The checks of a member under its largest compression and moments: d = { compression =, tension =, Mx =, My = }.
-- L: { Lx, Ly, Lb, C1 }: buckling lengths. Returns ratios and the numbers on the way.
function eurocode.member(s, p, material, d, L, Cm, o)
  local fy = material.yield_stress
  local chi_LT, l_LT, critical = lateral(s, p, material, o, L)
  local MxR, MyR = s.Zx * fy / o.gamma_M1, s.Zy * fy / o.gamma_M1
  local checks, detail = {}, { chi_LT = chi_LT, slenderness_LT = l_LT, M_cr = critical }
  if chi_LT then checks["6.3.2 Mx"] = d.Mx / (chi_LT * MxR) end
  if not (d.compression > 0) then return checks, detail end
  local NR = s.area * fy / o.gamma_M1
  local curve_x, curve_y = eurocode.curves_of(p, fy)
  curve_x, curve_y = o.curves and o.curves.x or curve_x, o.curves and o.curves.y or curve_y
  local lx = math.sqrt(s.area * fy * L.Lx ^ 2 / (pi ^ 2 * material.E * s.Ix))
  local ly = math.sqrt(s.area * fy * L.Ly ^ 2 / (pi ^ 2 * material.E * s.Iy))
  local chi_x, chi_y = eurocode.chi(lx, curve_x), eurocode.chi(ly, curve_y)
  local nx, ny = d.compression / (chi_x * NR), d.compression / (chi_y * NR)
  local kxx, kxy, kyx, kyy = interaction_factors(p, Cm, nx, ny, lx, ly, chi_LT ~= nil)
  local mx, my = d.Mx / ((chi_LT or 1) * MxR), d.My / MyR
  checks["6.3.1 Nx"], checks["6.3.1 Ny"] = nx, ny
  checks["6.61"], checks["6.62"] = nx + kxx * mx + kxy * my, ny + kyx * mx + kyy * my
  for key, value in pairs { chi_x = chi_x, chi_y = chi_y, slenderness_x = lx, slenderness_y = ly, curve_x = curve_x,
    curve_y = curve_y, kxx = kxx, kxy = kxy, kyx = kyx, kyy = kyy, N_b = math.min(chi_x, chi_y) * NR } do
    detail[key] = value
  end
  return checks, detail
end

--- Why a section is not checked under d, or nil; and its slenderness over the limit.
function eurocode.refused(p, fy, d)
  local ratio, plate = eurocode.slenderness(p, fy, d)
  if ratio > 1 then
    return ("class 3 or 4: the %s has %.3g of the slenderness of class 2"):format(plate, ratio), ratio
  end
  local e = math.sqrt(235e6 / fy)
  if (p.shape == "h" or p.shape == "box") and p.hw / p.tw > 72 * e then
    return ("its web buckles in shear (EN 1993-1-5): h_w / t_w is %.3g, above %.3g"):format(p.hw / p.tw, 72 * e), ratio
  end
  return nil, ratio
end

return eurocode
