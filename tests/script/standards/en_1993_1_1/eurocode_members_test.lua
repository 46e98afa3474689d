-- The checks of members in standards/en_1993_1_1 against EN 1993-1-1:2005, 6.3 and annex B, row by row: one row on
-- each side of each limit. A second transcription; eurocode_tables_test.lua says what was read.
--
-- Run: lua5.4 tests/script/standards/en_1993_1_1/eurocode_members_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../../?.lua;" .. package.path
local hinge = require "hinge"
local eurocode = require "hinge.standards.en_1993_1_1.members"
local profile = require "hinge.results.profile"
local scenes = require "scenes"
local support = require "support"
local checks = support.checks "members by EN 1993-1-1"
local case, expect, equal, near = checks.case, checks.expect, checks.equal, checks.near

local pi, MPa = math.pi, 1e6
local rounding = 1e-9 -- of values that are computed by the same formula

local function same(value, wanted, what) near(value, wanted, rounding * math.abs(wanted), what) end

local shared = require "standards.en_1993_1_1.eurocode_sections"
local demand, sections, plates = shared.demand, shared.sections, shared.plates

-- 6.3.1 ---------------------------------------------------------------------------------------------------------------

case("tables 6.1 and 6.2: curves, on each side of h / b = 1.2, of 40 mm, 100 mm and of S460", function()
  for _, row in ipairs {
    -- made, h / b, tf mm, curves y-y and z-z of S235 to S420, and of S460
    { "rolled", 1.21, 40, "a b", "a0 a0" }, { "rolled", 1.21, 40.1, "b c", "a a" },
    { "rolled", 1.21, 100, "b c", "a a" }, { "rolled", 1.21, 100.1, "d d", "c c" },
    { "rolled", 1.2, 40, "b c", "a a" }, { "rolled", 1.2, 100, "b c", "a a" }, { "rolled", 1.2, 100.1, "d d", "c c" },
    { "rolled", 2.5, 13.5, "a b", "a0 a0" },
    { "welded", 1.2, 40, "b c", "b c" }, { "welded", 2, 40, "b c", "b c" }, { "welded", 2, 40.1, "c d", "c d" },
  } do
    local p = { shape = "h", made = row[1], d = 0.3 * row[2], b = 0.3, tf = row[3] * 1e-3 }
    for fy, wanted in pairs { [235e6] = row[4], [355e6] = row[4], [420e6] = row[4], [460e6] = row[5],
      [440e6] = row[5] } do
      equal(table.concat({ eurocode.curves_of(p, fy) }, " "), wanted, ("%s, h/b %g, %g mm, %g MPa"):format(row[1],
        row[2], row[3], fy / MPa))
    end
  end
  for _, row in ipairs {
    { "box", "hot", "a a", "a0 a0" }, { "box", "cold", "c c", "c c" }, { "box", "welded", "b b", "b b" },
    { "pipe", "hot", "a a", "a0 a0" }, { "pipe", "cold", "c c", "c c" }, { "rectangle", "solid", "c c", "c c" },
    { "round", "solid", "c c", "c c" },
  } do
    local p = { shape = row[1], made = row[2], d = 0.4, b = 0.2, tf = 0.01 }
    equal(table.concat({ eurocode.curves_of(p, 355e6) }, " "), row[3], row[2] .. " " .. row[1])
    equal(table.concat({ eurocode.curves_of(p, 460e6) }, " "), row[4], row[2] .. " " .. row[1] .. ", S460")
  end
end)

case("figure 6.4: chi of the five curves", function()
  -- three digits of the tables that ECCS and textbooks print for the curves
  for curve, wanted in pairs { a0 = { 0.986, 0.725 }, a = { 0.977, 0.666 }, b = { 0.964, 0.597 },
    c = { 0.949, 0.540 }, d = { 0.923, 0.467 } } do
    for i, slenderness in ipairs { 0.3, 1.0, 2.05 } do
      local phi = (1 + ({ a0 = 0.13, a = 0.21, b = 0.34, c = 0.49, d = 0.76 })[curve] * (slenderness - 0.2)
        + slenderness ^ 2) / 2
      same(eurocode.chi(slenderness, curve), 1 / (phi + math.sqrt(phi ^ 2 - slenderness ^ 2)), "6.49")
      if wanted[i] then near(eurocode.chi(slenderness, curve), wanted[i], 6e-4, curve .. " at " .. slenderness) end
    end
    equal(eurocode.chi(0.2, curve), 1, "no reduction at 0.2")
    equal(eurocode.chi(0.1, curve), 1, "nor below")
    expect(eurocode.chi(0.25, curve) < 1, "and one above")
  end
end)

local steel = hinge.material { E = 210e9, nu = 0.3, density = 7850, yield_stress = 355 * MPa }
local ones = { x = 1, y = 1, LT = 1 }

-- A member whose slendernesses about x and y are given.
local function member(name, lx, ly, d, more)
  local o = scenes.with({ gamma_M0 = 1, gamma_M1 = 1, interaction = "standard" }, more)
  local s, own = sections[name], o.material or steel
  local function length(slenderness, I)
    return slenderness * pi * math.sqrt(own.E * I / (s.area * own.yield_stress))
  end
  local L = { Lx = length(lx, s.Ix), Ly = length(ly, s.Iy), Lb = o.Lb, C1 = o.C1 or 1 }
  return eurocode.member(s, plates[name], own, demand(d), L, o.Cm or ones, o)
end

case("6.47: flexural buckling about x and y, with gamma_M1 and given curves", function()
  local Npl = sections.rolled.area * 355 * MPa
  local found, detail = member("rolled", 0.8, 1.3, { compression = 0.2 * Npl }, { gamma_M1 = 1.1 })
  same(detail.slenderness_x, 0.8, "slenderness about x")
  same(detail.slenderness_y, 1.3, "about y")
  same(found["6.3.1 Nx"], 0.22 / eurocode.chi(0.8, "a"), "about x: curve a")
  same(found["6.3.1 Ny"], 0.22 / eurocode.chi(1.3, "b"), "about y: curve b")
  same(detail.N_b, eurocode.chi(1.3, "b") * Npl / 1.1, "N_b,Rd is the smaller")
  found = member("rolled", 0.8, 1.3, { compression = 0.2 * Npl }, { curves = { x = "d" } })
  same(found["6.3.1 Nx"], 0.2 / eurocode.chi(0.8, "d"), "a curve that is given for x")
  same(found["6.3.1 Ny"], 0.2 / eurocode.chi(1.3, "b"), "leaves that of y")
  found = member("rolled", 0.8, 1.3, { compression = 0.2 * Npl }, { curves = { y = "a0" } })
  same(found["6.3.1 Ny"], 0.2 / eurocode.chi(1.3, "a0"), "for y")
  same(found["6.3.1 Nx"], 0.2 / eurocode.chi(0.8, "a"), "leaves that of x")
  equal(next((member("rolled", 0.8, 1.3, { tension = 1e6 }))), nil, "no buckling in tension")
end)

-- 6.3.2 ---------------------------------------------------------------------------------------------------------------

case("table 6.4: lateral torsional buckling, on each side of h / b = 2", function()
  local function h(width, r)
    return hinge.section.h { depth = 0.4, width = width, web = 0.01, flange = 0.016, r = r }
  end
  for _, row in ipairs { { h(0.2, 0.02), "a" }, { h(0.199, 0.02), "b" }, { h(0.2), "c" }, { h(0.199), "d" },
    { sections.bar, "d" } } do
    local s, curve = row[1], row[2]
    local p, L, E, G = profile.of(s), 3, 210e9, 210e9 / 2.6
    local Iw = p.shape == "h" and s.Iy * 0.384 ^ 2 / 4 or 0
    local Mcr = 1.4 * pi / L * math.sqrt(E * s.Iy * (G * s.J + pi ^ 2 * E * Iw / L ^ 2)) -- SN003, C1 = 1.4
    local slenderness = math.sqrt(s.Zx * 355 * MPa / Mcr)
    local lengths = { Lx = 1, Ly = 1, Lb = L, C1 = 1.4 }
    local o = { gamma_M0 = 1, gamma_M1 = 1.1, interaction = "standard" }
    local found, detail = eurocode.member(s, p, steel, demand { Mx = 1e4 }, lengths, ones, o)
    same(detail.M_cr, Mcr, "M_cr")
    same(detail.slenderness_LT, slenderness, "its slenderness")
    same(found["6.3.2 Mx"], 1e4 / (eurocode.chi(slenderness, curve) * s.Zx * 355 * MPa / 1.1), "6.55, curve " .. curve)
    o.curve_LT = "a0"
    found = eurocode.member(s, p, steel, demand { Mx = 1e4 }, lengths, ones, o)
    same(found["6.3.2 Mx"], 1e4 / (eurocode.chi(slenderness, "a0") * s.Zx * 355 * MPa / 1.1), "a curve that is given")
  end
  for _, name in ipairs { "hot", "box", "pipe", "round" } do
    local found = member(name, 0.5, 0.5, { Mx = 1e4 }, { Lb = 9 })
    equal(found["6.3.2 Mx"], nil, name .. " does not turn over")
  end
end)

-- Annex B -------------------------------------------------------------------------------------------------------------

case("table B.1: k of members that do not turn over, on each side of a slenderness of 1", function()
  local Cm = { x = 0.9, y = 0.7, LT = 0.8 }
  for _, name in ipairs { "rolled", "welded", "hot", "box", "pipe", "bar" } do
    local Npl = sections[name].area * 355 * MPa
    for _, lx in ipairs { 0.5, 0.99, 1.01, 1.6 } do
      for _, ly in ipairs { 0.45, 0.99, 1.01, 1.7 } do
        local _, k = member(name, lx, ly, { compression = 0.1 * Npl, Mx = 1, My = 1 }, { Cm = Cm })
        local nx, ny = 0.1 / k.chi_x, 0.1 / k.chi_y
        local kyy = 0.9 * (1 + (lx < 1 and lx - 0.2 or 0.8) * nx)
        local kzz = 0.7 * (1 + (ly < 1 and 2 * ly - 0.6 or 1.4) * ny)
        if name ~= "rolled" and name ~= "welded" then kzz = 0.7 * (1 + (ly < 1 and ly - 0.2 or 0.8) * ny) end
        local what = ("%s, slenderness %g and %g: "):format(name, lx, ly)
        same(k.kxx, kyy, what .. "k_yy")
        same(k.kyy, kzz, what .. "k_zz")
        same(k.kxy, 0.6 * kzz, what .. "k_yz")
        same(k.kyx, 0.6 * kyy, what .. "k_zy")
      end
    end
  end
end)

case("table B.2: k_zy of members that turn over, on each side of slendernesses of 0.4 and 1", function()
  local Cm = { x = 0.9, y = 0.7, LT = 0.8 }
  local Npl = sections.rolled.area * 355 * MPa
  for _, row in ipairs { { 0.3, 0.05 }, { 0.3, 0.6 }, { 0.39, 0.3 }, { 0.41, 0.3 }, { 0.99, 0.3 }, { 1.01, 0.3 },
    { 1.8, 0.1 } } do
    local ly, part = row[1], row[2]
    local _, k = member("rolled", 0.5, ly, { compression = part * Npl, Mx = 1 }, { Cm = Cm, Lb = 2 })
    local ny = part / k.chi_y
    local wanted = 1 - 0.1 * support.smallest_of(ly, 1) / (0.8 - 0.25) * ny
    if ly < 0.4 then wanted = support.smallest_of(0.6 + ly, 1 - 0.1 * ly / (0.8 - 0.25) * ny) end
    same(k.kyx, wanted, ("k_zy at a slenderness of %g and n = %g"):format(ly, part))
    same(k.kxy, 0.6 * k.kyy, "k_yz is that of table B.1")
  end
end)

case("6.61 and 6.62 with the numbers on the way", function()
  local s = sections.rolled
  local Npl, Mx, My = s.area * 355 * MPa, s.Zx * 355 * MPa, s.Zy * 355 * MPa
  for _, Lb in ipairs { false, 3 } do
    local d = { compression = 0.1 * Npl, Mx = 0.2 * Mx, My = 0.3 * My }
    local found, k = member("rolled", 0.6, 1.2, d, { gamma_M1 = 1.1, Lb = Lb or nil,
      Cm = { x = 0.9, y = 0.7, LT = 0.8 } })
    local chi_LT = k.chi_LT or 1
    expect(Lb and chi_LT < 0.9 or chi_LT == 1, "chi_LT is %g", chi_LT)
    local N_x, N_y = 0.11 / eurocode.chi(0.6, "a"), 0.11 / eurocode.chi(1.2, "b")
    same(found["6.61"], N_x + k.kxx * 0.22 / chi_LT + k.kxy * 0.33, "6.61")
    same(found["6.62"], N_y + k.kyx * 0.22 / chi_LT + k.kyy * 0.33, "6.62")
  end
end)

checks.done()
