-- The checks of standards/en_1993_1_1 against the tables of EN 1993-1-1:2005, row by row: one row on each side of each
-- limit. The numbers are a second transcription, made without the code of the checks.
--
-- Read for it: table 5.2 and table 6.2 as pages of the standard and as SCIA Engineer's help gives them; 6.18 a to g and
-- 6.25 to 6.42 as the formulas of the program Blueprints (NEN-EN 1993-1-1+C2+A1) and of metku; tables 6.1, 6.4, B.1 and
-- B.2 as metku and the JRC's report "Design of steel buildings with worked examples" give them. The standard itself was
-- not at hand.
--
-- Run: lua5.4 tests/script/standards/en_1993_1_1/eurocode_tables_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../../?.lua;" .. package.path
local hinge = require "hinge"
local eurocode = require "hinge.standards.en_1993_1_1.members"
local profile = require "hinge.results.profile"
local scenes = require "scenes"
local support = require "support"
local checks = support.checks "tables of EN 1993-1-1"
local case, expect, equal, near = checks.case, checks.expect, checks.equal, checks.near

local pi, MPa = math.pi, 1e6
local plain = { gamma_M0 = 1, gamma_M1 = 1, interaction = "standard" }
local rounding = 1e-9 -- of values that are computed by the same formula

local function same(value, wanted, what) near(value, wanted, rounding * math.abs(wanted), what) end

local function at(of) return scenes.with({ N = 0, Mx = 0, My = 0, Mz = 0, Qx = 0, Qy = 0, x = 0 }, of) end

local shared = require "standards.en_1993_1_1.eurocode_sections"
local demand, sections, plates = shared.demand, shared.sections, shared.plates

local function check_section(name, fy, forces, o)
  return eurocode.section(sections[name], plates[name], fy, at(forces), o or plain)
end

-- Table 5.2 -----------------------------------------------------------------------------------------------------------

-- Plates whose one slenderness is given, and all others stocky.
local function h_flange(ratio)
  return { shape = "h", made = "rolled", c_flange = ratio * 0.01, tf = 0.01, c_web = 0.1, tw = 0.01, hw = 0.12 }
end
local function h_web(ratio)
  return { shape = "h", made = "rolled", c_flange = 0.02, tf = 0.01, c_web = ratio * 0.01, tw = 0.01,
    hw = 0.3 }
end
local function box_flange(ratio)
  return { shape = "box", made = "hot", c_flange = ratio * 0.01, tf = 0.01, c_web = 0.1, tw = 0.01, hw = 0.12 }
end
local function box_web(ratio)
  return { shape = "box", made = "hot", c_flange = 0.1, tf = 0.01, c_web = ratio * 0.01, tw = 0.01, hw = 0.3 }
end
local function pipe(ratio) return { shape = "pipe", made = "hot", d = ratio * 0.01, tw = 0.01, tf = 0.01, b = 1 } end

-- alpha of a web under N and bending, stresses fy on both sides: N = (2 alpha - 1) c t fy, of each web.
local function by_alpha(alpha, webs, fy, limit)
  return (2 * alpha - 1) * webs * limit * 0.01 * 0.01 * fy
end

local function class_2(fy)
  local e = math.sqrt(235 * MPa / fy)
  local three_quarters, six_tenths = 456 * e / (13 * 0.75 - 1), 456 * e / (13 * 0.6 - 1)
  local mixed = { Mx = 1e5, My = 1e4 }
  return {
    { "outstand flange, 10 eps", h_flange, 10 * e },
    { "web in compression, 38 eps", h_web, 38 * e, { compression = 1e9 } },
    { "web in bending, 83 eps", h_web, 83 * e, { Mx = 1e5 }, 2e-3 }, -- 456 / 5.5 is 82.9
    { "web, alpha 0.75", h_web, three_quarters, { Mx = 1, compression = by_alpha(0.75, 1, fy, three_quarters) } },
    { "web, alpha 0.6", h_web, six_tenths, { Mx = 1, compression = by_alpha(0.6, 1, fy, six_tenths) } },
    { "web of a member in tension", h_web, 83 * e, { Mx = 1, tension = 1e9 }, 2e-3 },
    { "flange of a box, 38 eps", box_flange, 38 * e },
    { "web of a box in compression, 38 eps", box_web, 38 * e, { compression = 1e9 } },
    { "web of a box in bending, 83 eps", box_web, 83 * e, { Mx = 1e5 }, 2e-3 },
    { "two webs of a box, alpha 0.75", box_web, three_quarters,
      { Mx = 1e5, compression = by_alpha(0.75, 2, fy, three_quarters) } },
    { "web of a box that is bent about y, too", box_web, 38 * e, mixed },
    { "wall of a pipe, 70 eps^2", pipe, 70 * e ^ 2 },
  }
end

case("table 5.2: class 2 on each side of its limits", function()
  for _, fy in ipairs { 235 * MPa, 355 * MPa, 460 * MPa } do
    for _, row in ipairs(class_2(fy)) do
      local what, make, limit, d, width = row[1], row[2], row[3], demand(row[4]), row[5] or 1e-3
      what = ("%s, %g MPa"):format(what, fy / MPa)
      local below, ratio = eurocode.refused(make(limit * (1 - width)), fy, d)
      equal(below, nil, what .. ": below the limit")
      near(ratio, 1 - width, 1.2 * width, what .. ": slenderness over the limit")
      for _, times in ipairs { 1 + width, 1.02 } do
        local why = eurocode.refused(make(limit * times), fy, d)
        expect(why and why:find("class 3 or 4", 1, true), "%s: %g of the limit is refused: %s", what, times,
          tostring(why))
      end
    end
  end
end)

case("table 5.2: the plate that is named, and shapes without plates", function()
  expect(eurocode.refused(h_flange(12), 235 * MPa, demand {}):find("flange", 1, true), "flange")
  expect(eurocode.refused(h_web(50), 235 * MPa, demand { compression = 1e9 }):find("web", 1, true), "web")
  expect(eurocode.refused(pipe(80), 235 * MPa, demand {}):find("wall", 1, true), "wall")
  for _, name in ipairs { "bar", "round" } do
    local why, ratio = eurocode.refused(plates[name], 355 * MPa, demand { compression = 1e9, Mx = 1, My = 1 })
    equal(why, nil, name)
    equal(ratio, 0, name .. ": no plates")
  end
  -- a moment about y below 1e-3 of that about x is the rounding of a run
  equal(eurocode.refused(box_web(60), 235 * MPa, demand { Mx = 1e5, My = 90 }), nil, "bent about x alone")
  expect(eurocode.refused(box_web(60), 235 * MPa, demand { Mx = 1e5, My = 110 }), "bent about y, too")
end)

case("EN 1993-1-5: webs above 72 eps buckle in shear", function()
  for _, fy in ipairs { 235 * MPa, 355 * MPa } do
    local limit = 72 * math.sqrt(235 * MPa / fy)
    for _, make in ipairs { h_web, box_web } do
      local p = make(30)
      p.hw = 0.999 * limit * p.tw
      equal(eurocode.refused(p, fy, demand { Mx = 1 }), nil, p.shape .. ": below")
      p.hw = 1.001 * limit * p.tw
      local why = eurocode.refused(p, fy, demand { Mx = 1 })
      expect(why and why:find("its web buckles in shear", 1, true), "%s: above: %s", p.shape, tostring(why))
    end
  end
end)

-- 6.2.3 to 6.2.7 ------------------------------------------------------------------------------------------------------

case("6.2.6 (3): shear areas", function()
  -- mm, from the dimensions: IPE 400 is 400 x 180 x 8.6 x 13.5, r 21
  local A = 2 * 180 * 13.5 + 373 * 8.6 + (4 - pi) * 21 ^ 2 -- 8446
  local hot = sections.hot.area
  for _, row in ipairs {
    { "rolled", "a) A - 2 b tf + (tw + 2 r) tf", A - 2 * 180 * 13.5 + (8.6 + 42) * 13.5, A - 373 * 8.6 },
    { "welded", "d) hw tw, e) A - hw tw", 460 * 12, 2 * 250 * 20 },
    { "box", "d) two webs, e) the flanges", 2 * 260 * 10, 2 * 200 * 20 },
    { "hot", "f) A h / (b + h), A b / (b + h)", hot * 1e6 * 200 / 300, hot * 1e6 * 100 / 300 },
    { "cold", "f) of a cold formed one", sections.cold.area * 1e6 * 2 / 3, sections.cold.area * 1e6 / 3 },
    { "pipe", "g) 2 A / pi", 2 / pi * pi / 4 * (244.5 ^ 2 - 224.5 ^ 2), 2 / pi * pi / 4 * (244.5 ^ 2 - 224.5 ^ 2) },
    { "bar", "6.2.6 (4): largest stress 3/2 V / A", 2 / 3 * 2000, 2 / 3 * 2000 },
    { "round", "6.2.6 (4): largest stress 4/3 V / A", 3 / 4 * pi * 1600, 3 / 4 * pi * 1600 },
  } do
    local name, what, along_y, along_x = row[1], row[1] .. ", " .. row[2], row[3] * 1e-6, row[4] * 1e-6
    local R = eurocode.resistances(sections[name], plates[name], 275 * MPa, { gamma_M0 = 1.1, gamma_M1 = 1 })
    near(R.Avy, along_y, 1e-6 * along_y, what .. ": along y")
    near(R.Avx, along_x, 1e-6 * along_x, what .. ": along x")
    local V = 250 * MPa / math.sqrt(3)
    near(R.Vy, along_y * V, 1e-6 * along_y * V, what .. ": 6.18, V along y by gamma_M0")
    near(R.Vx, along_x * V, 1e-6 * along_x * V, what .. ": 6.18, V along x")
    same(R.N, sections[name].area * 250 * MPa, what .. ": 6.6 and 6.10")
    same(R.Mx, sections[name].Zx * 250 * MPa, what .. ": 6.13, about x")
    same(R.My, sections[name].Zy * 250 * MPa, what .. ": 6.13, about y")
    same(R.T, sections[name].Zz * V, what .. ": torque")
  end
end)

case("6.2.3, 6.2.4, 6.2.6: ratios, with the sign of N", function()
  local R = eurocode.resistances(sections.rolled, plates.rolled, 355 * MPa, plain)
  local pulled = check_section("rolled", 355 * MPa, { N = 0.3 * R.N, Qx = -0.2 * R.Vx, Qy = 0.4 * R.Vy })
  same(pulled["6.2.3 N"], 0.3, "tension")
  equal(pulled["6.2.4 N"], nil, "no compression")
  same(pulled["6.2.6 Vx"], 0.2, "shear along x")
  same(pulled["6.2.6 Vy"], 0.4, "shear along y")
  local pressed = check_section("rolled", 355 * MPa, { N = -0.3 * R.N })
  same(pressed["6.2.4 N"], 0.3, "compression")
  equal(pressed["6.2.3 N"], nil, "no tension")
  equal(check_section("rolled", 355 * MPa, { N = 0.5 })["6.2.4 N"], nil, "half a newton of tension")
  -- the shear of a pipe is that of both axes
  for _, name in ipairs { "pipe", "round" } do
    local V = eurocode.resistances(sections[name], plates[name], 355 * MPa, plain).Vx
    local found = check_section(name, 355 * MPa, { Qx = 0.3 * V, Qy = 0.4 * V })
    same(found["6.2.6 Vx"], 0.5, name .. ": sum of squares")
    same(found["6.2.6 Vy"], 0.5, name .. ": the same about y")
  end
end)

case("6.2.7 (9): shear resistance beside torsion", function()
  for _, row in ipairs {
    { "rolled", 0.5, math.sqrt(1 - 0.5 / 1.25) }, { "welded", 0.9, math.sqrt(1 - 0.9 / 1.25) }, -- 6.26
    { "hot", 0.5, 0.5 }, { "box", 0.3, 0.7 }, { "pipe", 0.25, 0.75 }, -- 6.28
  } do
    local name, t, left = row[1], row[2], row[3]
    local R = eurocode.resistances(sections[name], plates[name], 355 * MPa, plain)
    local found = check_section(name, 355 * MPa, { Mz = -t * R.T, Qy = 0.2 * R.Vy })
    same(found["6.2.7 T"], t, name .. ": torque")
    same(found["6.2.6 Vy"], 0.2 / left, name .. ": V_pl,T along y")
    same(check_section(name, 355 * MPa, { Mz = t * R.T, Qx = 0.2 * R.Vx })["6.2.6 Vx"], 0.2 / left,
      name .. ": V_pl,T along x")
  end
end)

-- 6.2.8 ---------------------------------------------------------------------------------------------------------------

-- The ratio of moments to their plastic resistance beside shear, which 6.2.8 reduces: { of Mx, of My }.
local function reduced(name, vx, vy)
  local R = eurocode.resistances(sections[name], plates[name], 355 * MPa, plain)
  local found = check_section(name, 355 * MPa, { Qx = vx * R.Vx, Qy = vy * R.Vy, Mx = 0.1 * R.Mx, My = 0.1 * R.My })
  return 0.1 / found["6.2.9 Mx"], 0.1 / found["6.2.9 My"]
end

case("6.2.8: moments beside shear, along y and along x", function()
  local rho = (2 * 0.8 - 1) ^ 2 -- 0.36
  for _, name in ipairs { "rolled", "welded", "wide", "hot", "box", "pipe", "bar", "round" } do
    local Mx, My = reduced(name, 0.5, 0)
    same(Mx, 1, name .. ": half of V along x reduces nothing, Mx")
    same(My, 1, name .. ": nor My")
    Mx, My = reduced(name, 0, 0.5)
    same(Mx, 1, name .. ": half of V along y reduces nothing, Mx")
    same(My, 1, name .. ": nor My")
  end
  -- 6.30: W - rho A_w^2 / (4 tw), A_w = hw tw
  for name, web in pairs { rolled = { 0.373, 0.0086 }, welded = { 0.46, 0.012 }, wide = { 0.262, 0.011 } } do
    local Aw, W = web[1] * web[2], sections[name].Zx
    local Mx, My = reduced(name, 0, 0.8)
    same(Mx, 1 - rho * Aw ^ 2 / (4 * web[2]) / W, name .. ": 6.30")
    same(My, 1, name .. ": the web has no part in My")
    -- 6.2.8 (3): the reduced yield stress is that of the flanges, which have the rest of W
    Mx, My = reduced(name, 0.8, 0)
    same(My, 1 - rho, name .. ": the flanges carry My")
    same(Mx, 1 - rho * (1 - Aw ^ 2 / (4 * web[2]) / W), name .. ": and the greater part of Mx")
  end
  for _, name in ipairs { "hot", "box", "pipe", "bar", "round" } do
    local Mx = reduced(name, 0, 0.8)
    same(Mx, 1 - rho, name .. ": V along y reduces Mx")
    local _, My = reduced(name, 0.8, 0)
    same(My, 1 - rho, name .. ": V along x reduces My")
  end
  local Mx, My = reduced("hot", 0.55, 0.8)
  same(Mx, 1 - rho, "both: Mx by the larger")
  same(My, 1 - rho, "both: My by the larger")
  same(reduced("hot", 0, 0.51), 1 - 0.02 ^ 2, "just above half")
  local R = eurocode.resistances(sections.hot, plates.hot, 355 * MPa, plain)
  equal(check_section("hot", 355 * MPa, { Qy = 1.1 * R.Vy, Mx = 1 })["6.2.9 Mx"], math.huge, "above V nothing is left")
end)

case("6.2.10: the axial force beside shear", function()
  -- rho off the shear area: n = N / (N_pl - rho A_v fy)
  local rho = 0.36
  for _, row in ipairs { { "box", 0, 0.8, 2 * 0.26 * 0.01 }, { "box", 0.8, 0, 2 * 0.2 * 0.02 },
    { "pipe", 0, 0.8, 2 / pi * sections.pipe.area }, { "round", 0.8, 0, 0.75 * sections.round.area },
    { "rolled", 0.8, 0, sections.rolled.area - 0.373 * 0.0086 } } do
    local name, vx, vy, area = row[1], row[2], row[3], row[4]
    local R = eurocode.resistances(sections[name], plates[name], 355 * MPa, plain)
    local _, detail = check_section(name, 355 * MPa, { N = -0.3 * R.N, Qx = vx * R.Vx, Qy = vy * R.Vy })
    same(detail.n, 0.3 / (1 - rho * area / sections[name].area), name)
  end
end)

-- 6.2.9.1 -------------------------------------------------------------------------------------------------------------

-- M_N,x and M_N,y over the plastic moments, and the powers of 6.41, at N = -n N_pl.
local function beside(name, n, o)
  local R = eurocode.resistances(sections[name], plates[name], 355 * MPa, o or plain)
  local _, detail = check_section(name, 355 * MPa, { N = -n * R.N }, o)
  return detail.MNx / R.Mx, detail.MNy / R.My, detail.alpha, detail.beta
end

case("6.33 to 6.38: M_N of H sections on each side of their limits", function()
  for name, plate in pairs { rolled = { 0.18, 0.0135, 0.373, 0.0086 }, wide = { 0.3, 0.019, 0.262, 0.011 },
    welded = { 0.25, 0.02, 0.46, 0.012 } } do
    local A = sections[name].area
    local a = (A - 2 * plate[1] * plate[2]) / A
    local free = support.smallest_of(0.25, 0.5 * plate[3] * plate[4] / A) -- 6.33 and 6.34
    for _, n in ipairs { 0.5 * free, 0.999 * free, 1.001 * free, a * 0.999, a * 1.001, 0.26, 0.5, 0.9 } do
      local Mx, My = beside(name, n)
      local wanted = n <= free and 1 or (1 - n) / (1 - 0.5 * support.smallest_of(a, 0.5))
      same(Mx, support.smallest_of(1, wanted), ("%s: 6.36 at n = %g"):format(name, n))
      same(My, n <= a and 1 or 1 - ((n - a) / (1 - a)) ^ 2, ("%s: 6.37 and 6.38 at n = %g"):format(name, n))
    end
  end
  -- a web of more than half of the area
  local deep = hinge.section.h { depth = 0.6, width = 0.1, web = 0.014, flange = 0.014 }
  local p, A = profile.of(deep), deep.area
  expect((A - 2 * 0.1 * 0.014) / A > 0.7, "its web is %g of it", (A - 2 * 0.1 * 0.014) / A)
  local _, detail = eurocode.section(deep, p, 235 * MPa, at { N = -0.6 * A * 235 * MPa }, plain)
  same(detail.MNx, deep.Zx * 235 * MPa * 0.4 / 0.75, "a is 0.5 at most: M_N,x")
  same(detail.MNy, deep.Zy * 235 * MPa * (1 - (0.1 / 0.5) ^ 2), "M_N,y")
  -- 6.33 alone holds here: a quarter of N_pl is less than half of the web
  _, detail = eurocode.section(deep, p, 235 * MPa, at { N = -0.26 * A * 235 * MPa }, plain)
  same(detail.MNx, deep.Zx * 235 * MPa * 0.74 / 0.75, "6.33: above a quarter of N_pl")
end)

case("6.39 and 6.40: M_N of hollow sections, pipes and bars", function()
  for name, box in pairs { hot = { 0.1, 0.2, 0.008, 0.008 }, box = { 0.2, 0.3, 0.01, 0.02 } } do
    local A = sections[name].area
    local aw = support.smallest_of(0.5, (A - 2 * box[1] * box[4]) / A)
    local af = support.smallest_of(0.5, (A - 2 * box[2] * box[3]) / A)
    expect(math.abs(aw - af) > 0.05, "%s: a_w %g and a_f %g differ", name, aw, af)
    for _, n in ipairs { 0.1, 0.3, 0.6, 0.9 } do
      local Mx, My = beside(name, n)
      near(Mx, support.smallest_of(1, (1 - n) / (1 - 0.5 * aw)), 1e-6, ("%s: 6.39 at n = %g"):format(name, n))
      near(My, support.smallest_of(1, (1 - n) / (1 - 0.5 * af)), 1e-6, ("%s: 6.40 at n = %g"):format(name, n))
    end
  end
  for _, n in ipairs { 0.1, 0.4, 0.8 } do
    local Mx, My = beside("pipe", n)
    same(Mx, 1 - n ^ 1.7, "pipe, x")
    same(My, 1 - n ^ 1.7, "pipe, y")
    Mx, My = beside("bar", n)
    same(Mx, 1 - n ^ 2, "6.32: flat bar, x")
    same(My, 1 - n ^ 2, "6.32: flat bar, y")
    -- a round bar: the segments beyond a chord, by the half angle t of what N takes: n = (2 t - sin 2 t) / pi
    local low, high = 0, pi / 2
    for _ = 1, 60 do
      local t = (low + high) / 2
      if (2 * t + math.sin(2 * t)) / pi < n then low = t else high = t end
    end
    Mx = beside("round", n)
    near(Mx, math.cos(low) ^ 3, 1e-3, "round bar: the engine's curve is a fit")
  end
end)

case("6.41: powers", function()
  for _, row in ipairs {
    { "rolled", 0.15, 2, 1 }, { "rolled", 0.199, 2, 1 }, { "rolled", 0.3, 2, 1.5 }, { "welded", 0.6, 2, 3 },
    { "hot", 0.3, 1.66 / (1 - 1.13 * 0.09), 1.66 / (1 - 1.13 * 0.09) }, { "box", 0, 1.66, 1.66 },
    { "box", 0.79, 1.66 / (1 - 1.13 * 0.79 ^ 2), 1.66 / (1 - 1.13 * 0.79 ^ 2) },
    { "hot", 0.81, 6, 6 }, { "hot", 0.95, 6, 6 }, { "pipe", 0.3, 2, 2 }, { "round", 0.3, 2, 2 }, { "bar", 0.3, 1, 1 },
  } do
    local name, n = row[1], row[2]
    local _, _, alpha, beta = beside(name, n)
    near(alpha, row[3], 1e-6, ("%s: alpha at n = %g"):format(name, n))
    near(beta, row[4], 1e-6, ("%s: beta at n = %g"):format(name, n))
  end
  -- the sum, with different moments about x and y
  local R = eurocode.resistances(sections.rolled, plates.rolled, 355 * MPa, plain)
  local found = check_section("rolled", 355 * MPa, { N = 0.1 * R.N, Mx = -0.6 * R.Mx, My = 0.3 * R.My })
  same(found["6.41"], 0.6 ^ 2 + 0.3, "of an H: the square about x, the first power about y")
  found = check_section("pipe", 355 * MPa, { Mx = 0.6 * R.Mx, My = 0 })
  same(found["6.41"], (0.6 * R.Mx / (sections.pipe.Zx * 355 * MPa)) ^ 2, "of a pipe")
  -- crushed and bent
  found = check_section("rolled", 355 * MPa, { N = -1.1 * R.N, Mx = 0.2 * R.Mx, My = 0.3 * R.My })
  same(found["6.41"], 1.6, "above N_pl: the sum of all three, which is above 1")
  equal(found["6.2.9 Mx"], nil, "and no ratio to a moment that is 0")
end)

case("the interactions that are asked for", function()
  for _, name in ipairs { "rolled", "hot", "pipe" } do
    local x, y = sections[name]:reduced_moments(0.4)
    local Mx, My = beside(name, 0.4, { gamma_M0 = 1, gamma_M1 = 1, interaction = "exact" })
    same(Mx, x, name .. ": exact, x")
    same(My, name == "pipe" and x or y, name .. ": exact, y")
    local alpha, beta
    Mx, My, alpha, beta = beside(name, 0.4, { gamma_M0 = 1, gamma_M1 = 1, interaction = "linear" })
    same(Mx, 0.6, name .. ": linear, x")
    same(My, 0.6, name .. ": linear, y")
    equal(alpha + beta, 2, name .. ": linear, powers")
  end
end)

checks.done()
