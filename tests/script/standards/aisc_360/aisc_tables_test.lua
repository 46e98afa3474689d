-- The checks of standards/aisc_360 against AISC 360-16, row by row: one row on each side of each limit. The numbers are
-- a second transcription, made without the code of the checks.
--
-- Read for it: table B4.1 as pages that print it; E3, F7, G5 and H3 as the verification examples of STAAD.Pro's help
-- (AISC 360-16) and the AISC Design Examples apply them; the remaining formulas of F2, F3, F6, F11, G2 and H1 as
-- textbooks give them. The specification itself was not at hand.
--
-- Run: lua5.4 tests/script/standards/aisc_360/aisc_tables_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../../?.lua;" .. package.path
local hinge = require "hinge"
local aisc = require "hinge.standards.aisc_360.members"
local profile = require "hinge.results.profile"
local scenes = require "scenes"
local support = require "support"
local checks = support.checks "tables of AISC 360-16"
local case, expect, equal, near = checks.case, checks.expect, checks.equal, checks.near

local pi = math.pi
local inch, ksi = hinge.units.inch, hinge.units.ksi
local E = 29000 * ksi
local rounding = 1e-9 -- of values that are computed by the same formula

local function same(value, wanted, what) near(value, wanted, rounding * math.abs(wanted), what) end
local function steel(fy) return hinge.material { E = E, nu = 0.3, yield_stress = fy * ksi } end

local sections = {
  rolled = hinge.section.named "W14X90", beam = hinge.section.named "W21X44",
  welded = hinge.section.h { depth = 0.5, width = 0.25, web = 0.012, flange = 0.02 },
  hss = hinge.section.named "HSS8X4X1/2",
  box = hinge.section.box { width = 0.2, depth = 0.3, web = 0.01, flange = 0.02 },
  pipe = hinge.section.named "HSS5X0.25", bar = hinge.section.solid { width = 0.02, depth = 0.1 },
  flat = hinge.section.solid { width = 0.1, depth = 0.02 }, round = hinge.section.round { diameter = 0.08 },
}
local plates = {}
for name, s in pairs(sections) do plates[name] = assert(profile.of(s)) end

local function strengths(name, fy, lengths)
  return aisc.strengths(sections[name], plates[name], steel(fy), scenes.with({ Lx = 3, Ly = 3, C1 = 1, Cb = 1 },
    lengths))
end

-- Table B4.1 ----------------------------------------------------------------------------------------------------------

local function h_flange(ratio) -- b / 2 tf
  return { shape = "h", made = "rolled", b = ratio * 0.02, tf = 0.01, c_web = 0.1, tw = 0.01, hw = 0.12, d = 0.14 }
end
local function welded_flange(web) -- of a web of this slenderness
  return function(ratio)
    return { shape = "h", made = "welded", b = ratio * 0.02, tf = 0.01, c_web = web * 0.01, tw = 0.01, d = 1 }
  end
end
local function h_web(ratio)
  return { shape = "h", made = "rolled", b = 0.06, tf = 0.01, c_web = ratio * 0.01, tw = 0.01, d = 1 }
end
local function box_flange(ratio)
  return { shape = "box", made = "cold", b = 1, d = 1, c_flange = ratio * 0.01, tf = 0.01, c_web = 0.1, tw = 0.01 }
end
local function box_web(ratio)
  return { shape = "box", made = "cold", b = 1, d = 1, c_flange = 0.1, tf = 0.01, c_web = ratio * 0.01, tw = 0.01 }
end
local function pipe(ratio) return { shape = "pipe", made = "cold", d = ratio * 0.01, tw = 0.01, b = 1, tf = 0.01 } end

local function kc(web) return support.smallest_of(0.76, support.largest_of(0.35, 4 / math.sqrt(web))) end

case("table B4.1: slender in compression, and compact in bending, on each side of their limits", function()
  for _, fy in ipairs { 36, 50, 65 } do
    local root = math.sqrt(29000 / fy)
    local pressed, bent, about_y = { compression = 1, Mx = 0, My = 0 }, { compression = 0, Mx = 1, My = 0 },
      { compression = 0, Mx = 1, My = 1 }
    for _, row in ipairs {
      { "B4.1a, 1: rolled flange", h_flange, 0.56 * root, pressed, "slender in compression" },
      { "B4.1a, 2: built-up flange, kc of 0.76", welded_flange(20), 0.64 * math.sqrt(0.76) * root, pressed,
        "slender in compression" },
      { "B4.1a, 2: built-up flange, kc = 4 / sqrt(h / tw)", welded_flange(30), 0.64 * math.sqrt(kc(30)) * root, pressed,
        "slender in compression" },
      { "B4.1a, 5: web", h_web, 1.49 * root, pressed, "slender in compression" },
      { "B4.1a, 6: flange of HSS", box_flange, 1.12 * root, pressed, "not compact" }, -- before 1.40
      { "B4.1a, 6: web of HSS", box_web, 1.40 * root, pressed, "slender in compression" },
      { "B4.1a, 9: round HSS", pipe, 0.07 * 29000 / fy, pressed, "not compact" }, -- before 0.11
      { "B4.1b, 10: rolled flange, slender", h_flange, root, bent, "its flange is slender" },
      { "B4.1b, 11: built-up flange, slender", welded_flange(20), 0.95 * math.sqrt(0.76 / 0.7) * root, bent,
        "its flange is slender" },
      { "B4.1b, 11: kc of a slender web", welded_flange(75), 0.95 * math.sqrt(kc(75) / 0.7) * root, bent,
        "its flange is slender" },
      { "B4.1b, 15: web", h_web, 3.76 * root, bent, "its web is not compact" },
      { "B4.1b, 17: flange of HSS", box_flange, 1.12 * root, bent, "its flange is not compact" },
      { "B4.1b, 17: web of HSS that is bent about y", box_web, 1.12 * root, about_y, "its flange is not compact" },
      { "B4.1b, 19: web of HSS", box_web, 2.42 * root, bent, "its wall is not compact" },
      { "B4.1b, 20: round HSS", pipe, 0.07 * 29000 / fy, bent, "its wall is not compact" },
    } do
      local what = ("%s, %g ksi"):format(row[1], fy)
      local why, ratio = aisc.refused(row[2](0.999 * row[3]), fy * ksi, row[4], E)
      equal(why, nil, what .. ": below")
      near(ratio, 0.999, 1e-6, what .. ": over the limit")
      for _, times in ipairs { 1.001, 1.02 } do
        why, ratio = aisc.refused(row[2](times * row[3]), fy * ksi, row[4], E)
        expect(why and why:find(row[5], 1, true), "%s: above: %s", what, tostring(why))
        near(ratio, times, 1e-6, what .. ": over the limit, above")
      end
    end
  end
  -- the limits of compression count in compression alone
  equal(aisc.refused(h_web(60), 50 * ksi, { compression = 0, Mx = 1, My = 0 }, E), nil, "a web in bending")
  equal(aisc.refused(box_web(50), 50 * ksi, { compression = 0, Mx = 1, My = 0 }, E), nil, "a web of HSS in bending")
  equal(aisc.refused(box_web(40), 50 * ksi, { compression = 0, Mx = 1e5, My = 90 }, E), nil, "My of rounding")
  expect(aisc.refused(box_web(40), 50 * ksi, { compression = 0, Mx = 1e5, My = 110 }, E), "My that counts")
  equal(aisc.refused(plates.bar, 50 * ksi, { compression = 1, Mx = 1, My = 1 }, E), nil, "a bar has no plates")
  for _, shape in ipairs { "pipe", "box" } do -- table B4.1a, 6 and 9: what bending does not refuse first
    local p = shape == "pipe" and pipe(0.0699 * 580) or box_flange(1.119 * math.sqrt(580))
    local _, ratio = aisc.refused(p, 50 * ksi, { compression = 1, Mx = 0, My = 0 }, E)
    near(ratio, shape == "pipe" and 0.0699 / 0.07 or 1.119 / 1.12, 1e-6, shape .. ": the larger of two ratios")
  end
end)

-- D2 and E3 -----------------------------------------------------------------------------------------------------------

case("D2-1 and E3: strength in tension and in compression, on each side of 4.71 sqrt(E / Fy)", function()
  for _, fy in ipairs { 36, 50 } do
    local limit = 4.71 * math.sqrt(29000 / fy) -- 133.7 and 113.4
    for _, name in ipairs { "rolled", "hss", "pipe", "bar" } do
      local s = sections[name]
      local rx, ry = math.sqrt(s.Ix / s.area), math.sqrt(s.Iy / s.area)
      for _, ratio in ipairs { 40, 0.999 * limit, 1.001 * limit, 160 } do
        local Fe = pi ^ 2 * 29000 / ratio ^ 2 -- E3-4
        local Fcr = ratio < limit and 0.658 ^ (fy / Fe) * fy or 0.877 * Fe -- E3-2 and E3-3
        local R = strengths(name, fy, { Lx = ratio * rx, Ly = 20 * ry })
        local what = ("%s, %g ksi, L / r = %g: "):format(name, fy, ratio)
        same(R.compression_x, 0.9 * Fcr * ksi * s.area, what .. "about x")
        same(R.slenderness_x, ratio, what .. "slenderness about x")
        R = strengths(name, fy, { Lx = 20 * rx, Ly = ratio * ry })
        same(R.compression_y, 0.9 * Fcr * ksi * s.area, what .. "about y")
        same(R.slenderness_y, ratio, what .. "slenderness about y")
        same(R.tension, 0.9 * fy * ksi * s.area, what .. "tension")
      end
    end
  end
  -- the manual's table 4-14, Fy = 50 ksi: phi Fcr of 37.5 ksi at 50 and 8.82 ksi at 160
  local s = sections.rolled
  local ry = math.sqrt(s.Iy / s.area)
  near(strengths("rolled", 50, { Ly = 50 * ry }).compression_y / s.area / ksi, 37.5, 0.05, "phi Fcr at 50")
  near(strengths("rolled", 50, { Ly = 160 * ry }).compression_y / s.area / ksi, 8.82, 0.005, "phi Fcr at 160")
end)

-- F -------------------------------------------------------------------------------------------------------------------

case("F2: lateral torsional buckling of an H, on each side of L_p and L_r", function()
  local s, fy, A = sections.beam, 50 * ksi, sections.beam.area -- W21X44: 20.7 in deep, 6.5 in wide, 0.45 in flanges
  local Sx, h0, ry = s.Ix / (20.7 * inch / 2), (20.7 - 0.45) * inch, math.sqrt(s.Iy / A)
  local Cw = s.Iy * h0 ^ 2 / 4
  local rts = math.sqrt(math.sqrt(s.Iy * Cw) / Sx)
  local Mp, Mr = fy * s.Zx, 0.7 * fy * Sx
  local Lp = 1.76 * ry * math.sqrt(E / fy)
  local twist = s.J / (Sx * h0)
  local Lr = 1.95 * rts * E / (0.7 * fy) * math.sqrt(twist + math.sqrt(twist ^ 2 + 6.76 * (0.7 * fy / E) ^ 2))
  near(Lp / inch / 12, 4.45, 0.05, "L_p of the manual, ft")
  near(Lr / inch / 12, 13.0, 0.2, "L_r of the manual, ft")
  for _, Cb in ipairs { 1, 1.3, 2.5 } do
    for _, Lb in ipairs { 0.5 * Lp, 0.999 * Lp, 1.001 * Lp, (Lp + Lr) / 2, 0.999 * Lr, 1.001 * Lr, 1.5 * Lr } do
      local Mn = Mp
      if Lb > Lp and Lb <= Lr then Mn = Cb * (Mp - (Mp - Mr) * (Lb - Lp) / (Lr - Lp)) end
      if Lb > Lr then
        Mn = Cb * pi ^ 2 * E / (Lb / rts) ^ 2 * math.sqrt(1 + 0.078 * twist * (Lb / rts) ^ 2) * Sx
      end
      local R = strengths("beam", 50, { Lb = Lb, Cb = Cb })
      near(R.Mx, 0.9 * support.smallest_of(Mp, Mn), 1e-6 * Mp, ("Lb %.3g m, Cb %g"):format(Lb, Cb))
      near(R.Lp, Lp, 1e-6 * Lp, "L_p")
      near(R.Lr, Lr, 1e-6 * Lr, "L_r")
    end
  end
  local R = strengths("beam", 50)
  near(R.Mx, 0.9 * Mp, 1e-9 * Mp, "without Lb there is none")
end)

case("F3-1 and F6-2: flanges of an H on each side of compact", function()
  for _, made in ipairs { "rolled", "welded" } do
    for _, times in ipairs { 0.999, 1.001, 1.6, 2.2 } do
      local fy, compact = 50 * ksi, 0.38 * math.sqrt(29000 / 50)
      local lambda = times * compact
      local s = hinge.section.h { depth = 0.4, width = 0.3, web = 0.012, flange = 0.3 / 2 / lambda,
        r = made == "rolled" and 0.01 or nil }
      local p = profile.of(s)
      equal(p.made, made, "how it is made")
      local R = aisc.strengths(s, p, steel(50), { Lx = 1, Ly = 1, C1 = 1, Cb = 1 })
      local Sx, Sy = s.Ix / 0.2, s.Iy / 0.15
      local Mp, My = fy * s.Zx, support.smallest_of(fy * s.Zy, 1.6 * fy * Sy)
      local root = math.sqrt(29000 / 50)
      local slender = made == "rolled" and root or 0.95 * math.sqrt(kc(p.c_web / 0.012) / 0.7) * root
      local Mn, Mny = Mp, My
      if times > 1 then
        Mn = Mp - (Mp - 0.7 * fy * Sx) * (lambda - compact) / (slender - compact)
        Mny = My - (My - 0.7 * fy * Sy) * (lambda - compact) / (root - compact)
      end
      near(R.Mx, 0.9 * Mn, 1e-6 * Mp, ("%s, F3-1 at %g"):format(made, times))
      near(R.My, 0.9 * Mny, 1e-6 * My, ("%s, F6-2 at %g"):format(made, times))
    end
  end
  -- F6-1: at most 1.6 Fy Sy, which a thick web with narrow flanges comes to
  local stub = hinge.section.h { depth = 0.4, width = 0.06, web = 0.03, flange = 0.02 }
  expect(stub.Zy > 1.7 * stub.Iy / 0.03, "Z / S is %g", stub.Zy / (stub.Iy / 0.03))
  near(aisc.strengths(stub, profile.of(stub), steel(50), { Lx = 1, Ly = 1, C1 = 1, Cb = 1 }).My,
    0.9 * 1.6 * 50 * ksi * stub.Iy / 0.03, 1, "F6-1")
  -- with lateral torsional buckling the smaller of the two
  local s = hinge.section.h { depth = 0.4, width = 0.3, web = 0.012, flange = 0.01, r = 0.01 }
  local p = profile.of(s)
  local R = aisc.strengths(s, p, steel(50), { Lx = 1, Ly = 1, Lb = 20, C1 = 1, Cb = 1 })
  local free = aisc.strengths(s, p, steel(50), { Lx = 1, Ly = 1, Lb = 1, C1 = 1, Cb = 1 })
  expect(R.Mx < 0.5 * free.Mx and R.My == free.My, "of 20 m: %g of %g", R.Mx, free.Mx)
end)

case("F7, F8 and F11: moments of boxes, pipes and bars", function()
  local fy = 50 * ksi
  for _, name in ipairs { "hss", "box", "pipe" } do
    local s = sections[name]
    local R = strengths(name, 50)
    same(R.Mx, 0.9 * fy * s.Zx, name .. ": M_p about x")
    same(R.My, 0.9 * fy * s.Zy, name .. ": about y")
  end
  -- F11.1: Fy Z, at most 1.6 Fy S; a rectangle has Z / S = 1.5, a circle 1.7. A flat bar about both axes:
  for _, name in ipairs { "bar", "flat" } do
    local R = strengths(name, 50)
    local x, y = name == "bar" and 1 or 2, name == "bar" and 2 or 1
    local Z = { 0.02 * 0.1 ^ 2 / 4, 0.1 * 0.02 ^ 2 / 4 }
    same(R.Mx, 0.9 * fy * Z[x], name .. ": about x")
    same(R.My, 0.9 * fy * Z[y], name .. ": about y")
  end
  local R = strengths("round", 50)
  near(R.Mx, 0.9 * 1.6 * fy * pi * 0.08 ^ 3 / 32, 1e-6 * R.Mx, "round bar about x: 1.6 S governs")
  near(R.My, R.Mx, 1e-9 * R.Mx, "and about y")
end)

case("F7.4: lateral torsional buckling of a box, on each side of L_p and L_r", function()
  local deep = hinge.section.box { width = 0.1, depth = 0.3, thickness = 0.01 }
  local wide = hinge.section.box { width = 0.3, depth = 0.1, thickness = 0.01 }
  local fy, s = 50 * ksi, deep
  local ry, root, Sx = math.sqrt(s.Iy / s.area), math.sqrt(s.J * s.area), s.Ix / 0.15
  local Mp, Mr = fy * s.Zx, 0.7 * fy * s.Ix / 0.15
  local Lp, Lr = 0.13 * E * ry * root / Mp, 2 * E * ry * root / (0.7 * fy * Sx)
  for _, Cb in ipairs { 1, 1.2 } do
    for _, Lb in ipairs { 0.999 * Lp, 1.001 * Lp, (Lp + Lr) / 2, 0.999 * Lr, 1.001 * Lr, 2 * Lr } do
      local Mn = Mp
      if Lb > Lp and Lb <= Lr then Mn = Cb * (Mp - (Mp - Mr) * (Lb - Lp) / (Lr - Lp)) end
      if Lb > Lr then Mn = 2 * E * Cb * root / (Lb / ry) end
      local R = aisc.strengths(s, profile.of(s), steel(50), { Lx = 1, Ly = 1, Lb = Lb, C1 = 1, Cb = Cb })
      near(R.Mx, 0.9 * support.smallest_of(Mp, Mn), 1e-6 * Mp, ("Lb %.3g m, Cb %g"):format(Lb, Cb))
    end
  end
  local R = aisc.strengths(wide, profile.of(wide), steel(50), { Lx = 1, Ly = 1, Lb = 90, C1 = 1, Cb = 1 })
  same(R.Mx, 0.9 * fy * wide.Zx, "a box that lies flat does not turn over")
end)

case("F11.2: lateral torsional buckling of an upright bar, on each side of 0.08 and 1.9 E / Fy", function()
  local fy, S = 50 * ksi, 0.02 * 0.1 ^ 2 / 6
  local Mp = fy * 0.02 * 0.1 ^ 2 / 4
  for _, Cb in ipairs { 1, 1.5 } do
    for _, ratio in ipairs { 0.0799 * 580, 0.0801 * 580, 400, 1.899 * 580, 1.901 * 580, 2000 } do
      local Mn = Mp
      if ratio > 0.08 * 580 then Mn = Cb * (1.52 - 0.274 * ratio / 580) * fy * S end
      if ratio > 1.9 * 580 then Mn = 1.9 * E * Cb / ratio * S end
      local R = strengths("bar", 50, { Lb = ratio * 0.02 ^ 2 / 0.1, Cb = Cb })
      near(R.Mx, 0.9 * support.smallest_of(Mp, Mn), 1e-6 * Mp, ("Lb d / t^2 %g, Cb %g"):format(ratio, Cb))
    end
  end
  same(strengths("flat", 50, { Lb = 9 }).Mx, 0.9 * fy * 0.1 * 0.02 ^ 2 / 4, "a flat bar does not turn over")
end)

-- G and H3 ------------------------------------------------------------------------------------------------------------

case("G2.1: shear of webs, with phi of 1 and 0.9, on each side of their limits", function()
  for _, fy in ipairs { 36, 50 } do
    local root = math.sqrt(29000 / fy)
    local limit = 1.10 * math.sqrt(5.34) * root -- 2.54 sqrt(E / Fy)
    for _, row in ipairs {
      { "rolled", 2.239 * root, 1.0 }, { "rolled", 2.241 * root, 0.9 }, { "rolled", 0.999 * limit, 0.9 },
      { "rolled", 1.05 * limit, 0.9 / 1.05 }, { "welded", 2.239 * root, 0.9 }, { "welded", 20, 0.9 },
      { "welded", 1.2 * limit, 0.9 / 1.2 },
    } do
      local r = row[1] == "rolled" and 0.01 or 0
      local clear = row[2] * 0.01
      local s = hinge.section.h { depth = clear + 2 * r + 0.04, width = 0.25, web = 0.01, flange = 0.02,
        r = r > 0 and r or nil }
      local p = profile.of(s)
      equal(p.made, row[1], "how it is made")
      local R = aisc.strengths(s, p, steel(fy), { Lx = 1, Ly = 1, C1 = 1, Cb = 1 })
      local V = 0.6 * fy * ksi * (clear + 2 * r + 0.04) * 0.01
      near(R.Vy, row[3] * V, 1e-6 * V, ("%s, h / tw = %g, %g ksi"):format(row[1], row[2], fy))
      same(R.Vx, 0.9 * 0.6 * fy * ksi * 2 * 0.25 * 0.02, "G6: two flanges")
      same(R.T, 0.9 * 0.6 * fy * ksi * s.Zz, "torque of an H at full yield")
    end
  end
end)

case("G4, G5, H3.1: shear and torque of boxes, pipes and bars", function()
  local f = 0.9 * 0.6 * 50 * ksi
  local t = 0.465 * inch -- HSS8X4X1/2: the design thickness; h and b less three of it
  local R = strengths("hss", 50)
  near(R.Vy, f * 2 * (8 * inch - 3 * t) * t, 1e-6 * R.Vy, "G4 along y")
  near(R.Vx, f * 2 * (4 * inch - 3 * t) * t, 1e-6 * R.Vx, "G4 along x")
  near(R.T, f * (2 * (4 * inch - t) * (8 * inch - t) * t - 4.5 * (4 - pi) * t ^ 3), 1e-6 * R.T, "H3-1, C with corners")
  R = strengths("box", 50)
  near(R.Vy, f * 2 * (0.3 - 0.06) * 0.01, 1e-6 * R.Vy, "of a welded box along y")
  near(R.Vx, f * 2 * (0.2 - 0.03) * 0.02, 1e-6 * R.Vx, "along x")
  near(R.T, f * 2 * 0.19 * 0.28 * 0.01, 1e-6 * R.T, "its torque: the thinner wall, no corners")
  R = strengths("pipe", 50)
  local D, wall = 5 * inch, 0.233 * inch -- the design thickness
  local A, J = pi / 4 * (D ^ 2 - (D - 2 * wall) ^ 2), pi / 32 * (D ^ 4 - (D - 2 * wall) ^ 4)
  near(R.Vx, f * A / 2, 1e-6 * R.Vx, "G5 along x")
  near(R.Vy, f * A / 2, 1e-6 * R.Vy, "along y")
  near(R.T, f * J / (D / 2), 1e-6 * R.T, "torque of a pipe")
  for name, part in pairs { bar = 2 / 3, flat = 2 / 3, round = 3 / 4 } do
    R = strengths(name, 50)
    same(R.Vx, f * part * sections[name].area, name .. " along x")
    same(R.Vy, f * part * sections[name].area, name .. " along y")
    same(R.T, f * sections[name].Zz, name .. ": torque")
  end
end)

-- H -------------------------------------------------------------------------------------------------------------------

local function at(of)
  local row = { N = 0, Mx = 0, My = 0, Mz = 0, Qx = 0, Qy = 0, x = 0 }
  for name, value in pairs(of) do row[name] = value end
  return row
end

case("H1-1a and H1-1b, on each side of 0.2; the sign of N", function()
  local R = { tension = 1000, compression_x = 800, compression_y = 500, Mx = 100, My = 40, Vx = 300, Vy = 200, T = 10 }
  for _, row in ipairs {
    { 199, 0.199 / 2 + 0.5 + 0.3 }, { 201, 0.201 + 8 / 9 * 0.8 }, -- tension
    { -99.5, 0.199 / 2 + 0.5 + 0.3 }, { -100.5, 0.201 + 8 / 9 * 0.8 }, -- compression, about y
  } do
    local found = aisc.section(nil, { shape = "h" }, at { N = row[1], Mx = -50, My = 12, Qx = -30, Qy = 50,
      Mz = -3 }, R)
    same(found["H1-1"], row[2], "H1-1 at N = " .. row[1])
    same(found["F Mx"], 0.5, "Mx")
    same(found["F My"], 0.3, "My")
    same(found["G Vx"], 0.1, "Vx")
    same(found["G Vy"], 0.25, "Vy")
    same(found["H3 T"], 0.3, "T")
    same(found[row[1] < 0 and "E3 N" or "D2 N"], math.abs(row[1]) / (row[1] < 0 and 500 or 1000), "N")
    equal(found[row[1] < 0 and "D2 N" or "E3 N"], nil, "and not the other")
    equal(found["H3-6"], nil, "H3-6 is for hollow sections")
  end
  R.compression_x, R.compression_y = 500, 800
  same(aisc.section(nil, { shape = "h" }, at { N = -100.5 }, R)["E3 N"], 0.201, "about x where that is less")
  same(aisc.member({ compression = 99.5, Mx = 50, My = 12 }, R)["H1-1 member"], 0.199 / 2 + 0.8, "of a member, H1-1b")
  same(aisc.member({ compression = 100.5, Mx = 50, My = 12 }, R)["H1-1 member"], 0.201 + 8 / 9 * 0.8, "H1-1a")
  R.compression_x, R.compression_y = 800, 500
  same(aisc.member({ compression = 100.5, Mx = 50, My = 12 }, R)["H1-1 member"], 0.201 + 8 / 9 * 0.8, "about y")
  equal(next((aisc.member({ compression = 0, Mx = 50, My = 12 }, R))), nil, "none in tension")
end)

case("H3-6: torsion of hollow sections above a fifth of T", function()
  local R = { tension = 1000, compression_x = 800, compression_y = 500, Mx = 100, My = 40, Vx = 300, Vy = 200, T = 10 }
  for shape, both in pairs { box = 0.25, pipe = math.sqrt(0.1 ^ 2 + 0.25 ^ 2) } do
    local loads = { N = -50, Mx = 20, My = 12, Qx = 30, Qy = 50, Mz = 1.99 }
    equal(aisc.section(nil, { shape = shape }, at(loads), R)["H3-6"], nil, shape .. ": up to 0.2 it may be left out")
    for _, T in ipairs { 2.01, 5 } do
      loads.Mz = -T
      same(aisc.section(nil, { shape = shape }, at(loads), R)["H3-6"], 0.1 + 0.2 + 0.3 + (both + T / 10) ^ 2,
        ("%s at T = %g"):format(shape, T / 10))
    end
    loads.Qx, loads.Qy = 120, 20 -- 0.4 and 0.1
    local larger = shape == "box" and 0.4 or math.sqrt(0.4 ^ 2 + 0.1 ^ 2)
    same(aisc.section(nil, { shape = shape }, at(loads), R)["H3-6"], 0.6 + (larger + 0.5) ^ 2, shape .. ": along x")
  end
  same(aisc.section(nil, { shape = "round" }, at { Qx = 90, Qy = 80 }, { tension = 1, compression_x = 1,
    compression_y = 1, Mx = 1, My = 1, Vx = 300, Vy = 200, T = 1 })["G Vx"], 0.5, "a round bar: sum of squares")
end)

checks.done()
