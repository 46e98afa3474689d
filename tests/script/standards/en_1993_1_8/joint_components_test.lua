-- hinge.joint.end_plate, fin_plate, web_cleats, base_plate and panel_zone: published examples, hand calculations, the
-- joint in a run; wrong input is refused.
--
-- Run: lua5.4 tests/script/standards/en_1993_1_8/joint_components_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../../?.lua;" .. package.path
local support = require "support"
local hinge = require "hinge"
local scenes = require "scenes"
local checks = support.checks "joint components"
local case, near, equal, expect = checks.case, checks.near, checks.equal, checks.expect

local kN, mm, pi = 1e3, 1e-3, math.pi
local rounded = 0.006 -- of a value printed with three digits

local function copy(t)
  local new = {}
  for k, v in pairs(t) do new[k] = type(v) == "table" and getmetatable(v) == nil and copy(v) or v end
  return new
end

-- Options with some fields in the place of others: with(base, { bolts = { grade = "10.9" } }).
local function with(base, more)
  local new = copy(base)
  for k, v in pairs(more) do
    if type(v) == "table" and getmetatable(v) == nil and type(new[k]) == "table" and not v[1] then
      new[k] = with(new[k], v)
    else
      new[k] = v
    end
  end
  return new
end

-- SCI P398 (2013), example C.1: UB 533x210x92 on both sides of UC 254x254x107, S275 (265 MPa: thicker than 16 mm),
-- plate 670x250x25, M24 8.8, rows 100 and 90 mm apart, the first 40 mm above the beam; welds with legs of 12 and 8 mm;
-- washers as wide as the heads are across corners.
local c1 = {
  beam = { section = hinge.section.named "UB 533x210x92", yield_stress = 275e6 },
  column = { section = hinge.section.named "UC 254x254x107", yield_stress = 265e6 },
  plate = { width = 0.25, thickness = 0.025, yield_stress = 265e6, below = 0.05 },
  bolts = { diameter = 0.024, grade = "8.8", rows = { 0.5653, 0.4653, 0.3753 }, gauge = 0.1, edge = 0.05,
    head = 0.03955 },
  welds = { flange = 0.012 / math.sqrt(2), web = 0.008 / math.sqrt(2) }, beta = 0, gamma_M2 = 1.25, capacity = 0.03,
}

case("end plate of SCI P398, example C.1", function()
  local _, n = hinge.joint.end_plate(c1)
  local flange, plate = n.rows[1].components.column_flange, n.rows[1].components.end_plate
  -- sheets 4 to 7; no digits are printed below 1 kN and 1 mm
  for what, pair in pairs { ["column flange, circular"] = { flange.lengths.circular, 210 * mm },
    ["column flange, others"] = { flange.lengths.other, 233 * mm }, ["m"] = { flange.m, 33.4 * mm },
    ["column flange, mode 1"] = { flange.modes[1], 898 * kN }, ["mode 2"] = { flange.modes[2], 398 * kN },
    ["mode 3"] = { flange.modes[3], 406 * kN }, ["end plate, circular"] = { plate.lengths.circular, 191 * mm },
    ["end plate, others"] = { plate.lengths.other, 125 * mm }, ["mx"] = { plate.m, 30.4 * mm },
    ["end plate, mode 1"] = { plate.modes[1], 901 * kN }, ["end plate, mode 2"] = { plate.modes[2], 377 * kN } } do
    near(pair[1], pair[2], rounded * pair[2], what)
  end
  near(n.rows[1].force, 377 * kN, rounded * 377 * kN, "first row")
  equal(n.rows[1].governs, "end plate in bending", "what governs it")
  -- as a sheet of the same example by a program prints it; compression limits the third row here
  near(n.moment, 424 * kN, 0.01 * 424 * kN, "moment resistance")
  equal(n.governs, "column web in compression", "what governs the joint")
end)

-- A flush end plate with one row in tension, one-sided: IPE 300 on HEB 200, S235, M20 8.8; by hand, in mm, N, MPa.
local flush = {
  beam = { section = hinge.section.named "IPE 300", yield_stress = 235e6 },
  column = { section = hinge.section.named "HEB 200", yield_stress = 235e6 },
  plate = { width = 0.17, thickness = 0.012, yield_stress = 235e6 },
  bolts = { diameter = 0.02, grade = "8.8", rows = { 0.235 }, gauge = 0.09, shear_rows = 1, length = 0.045 },
  welds = { flange = 0.005, web = 0.004 },
}

case("flush end plate, one row, by hand", function()
  local _, n = hinge.joint.end_plate(flush)
  local row = n.rows[1]
  -- column flange: m = (90 - 9) / 2 - 0.8 x 18, e = 55, e_min = 40
  local m, Ft = 40.5 - 14.4, 2 * 0.9 * 800 * 245
  local circular, other = 2 * pi * m, 4 * m + 1.25 * 55
  local nn = 1.25 * m
  local length = math.min(circular, other)
  local T1 = 4 * 0.25 * length * 15 ^ 2 * 235 / m
  local T2 = (2 * 0.25 * other * 15 ^ 2 * 235 + nn * Ft) / (m + nn)
  near(row.components.column_flange.modes[1], T1, 1e-6 * T1, "column flange, mode 1")
  near(row.components.column_flange.modes[2], T2, 1e-6 * T2, "column flange, mode 2")
  -- column web: A_v = 7808 - 2 x 200 x 15 + (9 + 36) x 15
  local Av = 7808.124 - 6000 + 675
  local function omega(b) return 1 / math.sqrt(1 + 1.3 * (b * 9 / Av) ^ 2) end
  local web = omega(length) * length * 9 * 235
  near(row.components.column_web.resistance, web, 1e-6 * web, "column web in tension")
  -- end plate: m = (90 - 7.1) / 2 - 0.8 sqrt(2) 4, e = 40; m2 = 289.3 - 5.35 - 235 - 0.8 sqrt(2) 5; alpha satisfies
  -- the equation of figure 6.11
  local mp, m2 = 41.45 - 3.2 * math.sqrt(2), 48.95 - 4 * math.sqrt(2)
  local one, two, a = mp / (mp + 40), m2 / (mp + 40), n.alpha
  local limit = 1.25 / (a - 2.75)
  local at = a * limit / 2
  near(limit + (1 - limit) * ((at - two) / at) ^ (0.185 * a ^ 1.785), one, 1e-9, "alpha on the curve of lambda_1")
  local lp = math.min(2 * pi * mp, a * mp)
  local P1 = lp * 12 ^ 2 * 235 / mp
  near(row.components.end_plate.resistance, P1, 1e-6 * P1, "end plate, mode 1")
  equal(row.components.end_plate.mode, 1, "its mode")
  near(row.components.beam_web.resistance, lp * 7.1 * 235, 1e-6 * lp * 7.1 * 235, "beam web in tension")
  -- compression and shear
  local b = 10.7 + 2 * math.sqrt(2) * 5 + 5 * (15 + 18) + 12
  near(n.compression.column_web, omega(b) * b * 9 * 235, 1e-6 * b * 9 * 235, "column web in compression")
  local Fc = 628.35588646 * 235 * 1e3 / (300 - 10.7)
  near(n.compression.beam_flange, Fc, 1e-6 * Fc, "beam flange in compression")
  local V = 0.9 * 235 * Av / math.sqrt(3)
  near(n.compression.column_shear, V, 1e-6 * V, "column web in shear")
  local F = math.min(P1, T2, T1, web, V)
  near(n.moment, F * 0.235, 1e-6 * F * 0.235, "moment resistance")
  -- stiffness: table 6.11 with d_c = 134
  local k = { 0.38 * Av / 235, 0.7 * b * 9 / 134, 0.7 * length * 9 / 134, 0.9 * length * 15 ^ 3 / m ^ 3,
    0.9 * lp * 12 ^ 3 / mp ^ 3, 1.6 * 245 / 45 }
  local sum = 0
  for _, ki in ipairs(k) do sum = sum + 1 / ki end
  local S = 210e3 * 235 ^ 2 / sum / 1e3
  near(n.stiffness, S, 1e-6 * S, "initial stiffness")
  near(n.lever_arm, 0.235, 1e-9, "lever arm")
  -- two bolts without tension and two with 0.4 / 1.4 of their shear
  local Fv = 0.6 * 800 * 245
  near(n.shear, 2 * Fv * (1 + 0.4 / 1.4), 1e-6 * Fv, "shear resistance")
  near(n.tension, math.min(P1, T2, T1, web), 1, "tension resistance")
  -- 12 mm is below 0.36 x 20 sqrt(800 / 235) = 13.3 mm
  equal(n.governs, "end plate in bending", "what governs")
  equal(n.ductile, true, "6.4.2 (2)")
end)

case("stiffness of three rows: 6.3.3.1 by the coefficients of the rows", function()
  local _, n = hinge.joint.end_plate(with(c1, { beta = 1 }))
  local first, second = 0, 0
  for _, row in ipairs(n.rows) do
    local k = 1 / (1 / row.k3 + 1 / row.k4 + 1 / row.k5 + 1 / row.k10)
    first, second = first + k * row.distance, second + k * row.distance ^ 2
  end
  local z = second / first
  near(n.lever_arm, z, 1e-9, "z_eq")
  -- A_vc = 13638 - 2 x 258.8 x 20.5 + (12.8 + 25.4) x 20.5 mm^2, b = 15.6 + 24 + 5 x 33.2 + 50 mm, d_c = 200.3 mm
  local k1 = 0.38 * (13638.2125 - 10610.8 + 783.1) * 1e-6 / z
  local k2 = 0.7 * 0.2556 * 0.0128 / 0.2003
  local S = 210e9 * z ^ 2 / (1 / k1 + 1 / k2 + z / first)
  near(n.stiffness, S, 1e-6 * S, "initial stiffness")
  -- the middle row: (100 + 90) / 2 = 95 mm of the column flange, and the plate's 90 / 2 + alpha m - (2 m + 0.625 e)
  near(n.rows[2].k4, 0.9 * 95 * 20.5 ^ 3 / 33.44 ^ 3 * mm, 1e-8, "k4 of the middle row")
  local m = 44.95 - 6.4
  local plate = 45 + n.alpha * m - (2 * m + 0.625 * 75)
  near(n.rows[2].k5, 0.9 * plate * 25 ^ 3 / m ^ 3 * mm, 1e-8, "k5 of the middle row")
end)

case("what the shear in the column takes, and the knee", function()
  local last
  for _, beta in ipairs { 0, 0.5, 0.75, 1, 1.5, 2 } do
    local _, n = hinge.joint.end_plate(with(c1, { beta = beta }))
    expect(not last or n.moment <= last, "beta = %g: %g N m after %s", beta, n.moment, last)
    last = n.moment
    local x = (0.2556 * 0.0128 / 3.8105125e-3) ^ 2
    local one, two = 1 / math.sqrt(1 + 1.3 * x), 1 / math.sqrt(1 + 5.2 * x)
    local wanted = ({ [0] = 1, [0.5] = 1, [0.75] = one + 0.5 * (1 - one), [1] = one, [1.5] = (one + two) / 2,
      [2] = two })[beta]
    near(n.compression.omega, wanted, 1e-6, ("omega at beta = %g"):format(beta))
  end
  local _, n = hinge.joint.end_plate(c1)
  local first, final = n.points[1], n.points[#n.points]
  near(first[2] / first[1], n.stiffness, 1e-9 * n.stiffness, "elastic part")
  near(first[2], 2 / 3 * n.moment, 1e-9 * n.moment, "its end")
  near(final[2], n.moment, 1e-9 * n.moment, "resistance")
  near(final[1], n.moment / n.stiffness * 1.5 ^ 2.7, 1e-9 * final[1], "rotation there: mu = 1.5^2.7")
end)

case("bolts far apart from the plate's ductility", function()
  -- 6.2.7.2 (9): the first row is at mode 3, so that a lower one has no more than its part of the lever arm
  local _, n = hinge.joint.end_plate(with(c1, { column = { section = hinge.section.named "UC 305x305x283" },
    bolts = { grade = "4.6" } }))
  equal(n.rows[1].governs, "bolts in tension", "first row")
  expect(n.rows[2].force <= n.rows[1].force * 0.4653 / 0.5653 + 1, "second row: %g N", n.rows[2].force)
  checks.refused("field 'capacity' is false", hinge.joint.end_plate, with(c1, { capacity = false }))
  local options = copy(c1)
  options.capacity = nil
  checks.refused("6.4.2: column web in compression governs", hinge.joint.end_plate, options)
end)

-- "Steel buildings in Europe, multi-storey steel buildings, part 5", example 3.4: IPE A 550 S275, plate 360x160x10,
-- two lines of five M20 8.8.
local fin = {
  beam = { section = hinge.section.h { depth = 0.547, width = 0.21, web = 0.009, flange = 0.0157, r = 0.024 },
    yield_stress = 275e6, ultimate_stress = 430e6, edge = 0.04, top = 0.09 },
  plate = { depth = 0.36, thickness = 0.01, yield_stress = 275e6, ultimate_stress = 430e6, edge = 0.05 },
  bolts = { diameter = 0.02, grade = "8.8", rows = 5, lines = 2, pitch = 0.07, gauge = 0.06 },
  gap = 0.01, gamma_M2 = 1.25, gamma_Mu = 1.1,
}

case("fin plate of Steel buildings in Europe, part 5, example 3.4", function()
  local _, n = hinge.joint.fin_plate(fin)
  for what, published in pairs { ["bolts in shear"] = 584, ["bearing on the plate"] = 605,
    ["bearing on the beam's web"] = 624, ["plate in shear"] = 450, ["plate in shear, net"] = 497,
    ["block of the plate"] = 483, ["beam's web in shear"] = 953, ["beam's web in shear, net"] = 995 } do
    -- it rounds alpha_b to two digits, and takes the area from a table: 11700 and not 11729 mm^2
    near(n.shear_of[what], published * kN, 0.01 * published * kN, what)
  end
  -- the example takes four holes and not four and a half from the web's block: 507 kN
  local block = 0.5 * 430 * 603 / 1.25 + 275 / math.sqrt(3) * 9 * (90 + 280 - 4.5 * 22)
  near(n.shear_of["block of the beam's web"], block, 1, "block of the beam's web")
  equal(n.governs_shear, "plate in shear", "what governs")
  near(n.shear, n.shear_of["plate in shear"], 0, "the joint's")
  -- a long plate: lambda = 2.8 sqrt(80 x 360 / 150) = 38.80, p_b = 264.65 MPa by BS 5950-1, B.2.1, by hand
  near(n.buckling_stress, 264.6476e6, 1e-6 * 264e6, "stress at which the plate buckles")
end)

case("fin plate of the JRC's workshop on Eurocodes, Brussels 2014 (Wald)", function()
  -- IPE 300 S235, three M20 8.8, 70 mm apart, 50 mm from the beam's end, 80 mm from its top
  local _, n = hinge.joint.fin_plate(with(fin, { beam = { section = hinge.section.named "IPE 300", edge = 0.05,
    top = 0.08, yield_stress = 235e6, ultimate_stress = 360e6 }, plate = { depth = 0.23 }, bolts = { rows = 3,
    lines = 1 } }))
  near(n.shear_of["block of the beam's web"], 199 * kN, rounded * 199 * kN, "block in shear")
  near(n.tension_of["block of the beam's web"], 298 * kN, rounded * 298 * kN, "block in tying")
end)

-- The same publication, example 4.4: the same beam, two angles 430 mm long and 10 mm thick, six M20 8.8 in its web and
-- twice six at the column, 109 mm apart; washers 37 mm wide.
local cleats = {
  beam = fin.beam, gap = 0.01, gamma_M2 = 1.25, gamma_Mu = 1.1,
  cleats = { depth = 0.43, thickness = 0.01, r = 0.011, yield_stress = 275e6, ultimate_stress = 430e6, edge = 0.04,
    column_edge = 0.04, column_gauge = 0.109 },
  bolts = { diameter = 0.02, grade = "8.8", rows = 6, pitch = 0.07, head = 0.037 },
}

case("web cleats of Steel buildings in Europe, part 5, example 4.4", function()
  local _, n = hinge.joint.web_cleats(cleats)
  local function published(value, wanted, what) near(value, wanted * kN, 0.01 * wanted * kN, what) end
  published(n.shear_of["bolts in shear"], 962, "bolts in the web")
  published(n.shear_of["bolts at the column"], 902, "bolts at the column")
  published(n.shear_of["cleats in shear"], 1076, "cleats in shear")
  near(n.legs.m, 31.2 * mm, 1e-9, "m, which it rounds to 31")
  published(n.legs.modes[1], 696, "tying, mode 1")
  published(n.legs.modes[2], 1190, "mode 2")
  published(n.legs.modes[3], 1920, "mode 3")
  published(n.tension_of["bolts in shear"], 1284, "bolts in shear, tying")
  -- by hand, from the formulas of the publication
  near(n.shear_of["cleats in shear, net"], 2 * 10 * (430 - 6 * 22) * 430 / (math.sqrt(3) * 1.25), 1, "net section")
  near(n.shear_of["block of the cleats"], 2 * (0.5 * 430 * 10 * (40 - 11) / 1.25
    + 275 * 10 * (430 - 40 - 5.5 * 22) / math.sqrt(3)), 1, "block")
  local down, across = 2.5 * 40 / 66 * 430 * 200 / 1.25, 2.5 * 40 / 66 * 430 * 200 / 1.25 -- 2.8 40 / 22 - 1.7 > 2.5
  local beta = 6 * 50 / (6 * 7 * 70)
  near(n.shear_of["bearing on the cleats"], 2 * 6 / math.sqrt((1 / down) ^ 2 + (6 * beta / across) ^ 2), 1, "bearing")
  near(n.tension_of["bearing on the cleats"], 12 * 2.5 * 40 / 66 * 430 * 200 / 1.1, 1, "bearing, tying")
  equal(n.governs_shear, "block of the beam's web", "what governs shear")
  equal(n.governs_tension, "bearing on the beam's web", "what governs tying")
  -- weaker bolts than holes, and stronger ones: 3.7 (1)
  local _, stronger = hinge.joint.web_cleats(with(cleats, { cleats = { thickness = 0.004, column_gauge = 0.1 } }))
  local outer, inner = 2.5 * 40 / 66 * 430 * 80 / 1.25, 2.5 * (70 / 66 - 0.25) * 430 * 80 / 1.25
  near(stronger.shear_of["bolts at the column"], 2 * (outer + 5 * inner), 1,
    "each hole bears as much as it can, the one towards an end less")
  -- effective length of a leg: 2 e1, at most what is clear between the fillets plus a hole; each pitch, as much at most
  local tw = fin.beam.section.web
  local most = 0.109 - tw - 2 * 0.01 - 2 * 0.011 + 22 * mm
  for _, r in ipairs { { 6, 0.43, 0.07 }, { 6, 0.42, 0.065 }, { 4, 0.335, 0.085 }, { 6, 0.37, 0.06 } } do
    local rows, depth, pitch = r[1], r[2], r[3]
    local _, made = hinge.joint.web_cleats(with(cleats, { cleats = { depth = depth },
      bolts = { rows = rows, pitch = pitch } }))
    near(made.legs.lengths.mode_1, support.smallest_of(depth - (rows - 1) * pitch, most)
      + (rows - 1) * support.smallest_of(pitch, most), 1e-9, ("depth %g m, pitch %g m"):format(depth, pitch))
  end
end)

case("the gap closes", function()
  local _, n = hinge.joint.fin_plate(fin)
  -- the lower flange's corner, 70 mm from the middle of the bolts and 317 mm below it, has turned to the column's face
  local phi = n.contact
  near(70 * math.cos(phi) + 317 * math.sin(phi), 80, 1e-9, "distance of the corner, mm")
  near(n.capacity, phi, 0, "the joint's capacity")
end)

case("base plate: bearing of Wald's example, and equilibrium by hand", function()
  -- the same workshop: HEB 200 on a plate 340x340x18 S235, C12/15 with gamma_c 1.5, alpha 2.5 on grout 2/3
  local base = { column = { section = hinge.section.named "HEB 200", yield_stress = 235e6 },
    plate = { length = 0.34, width = 0.34, thickness = 0.018, yield_stress = 235e6 },
    bolts = { diameter = 0.02, grade = "8.8", outside = 0.04, gauge = 0.2, length = 0.25 },
    concrete = { strength = 12e6, spread = 2.5, E = 27e9 }, weld = 0.0035, axial = 0, capacity = 0.05,
    gamma_c = 1.5 }
  local _, n = hinge.joint.base_plate(base)
  near(n.compression.bearing_stress, 13.3e6, rounded * 13.3e6, "bearing stress")
  near(n.compression.reach, 43.7 * mm, rounded * 43.7 * mm, "additional width")
  near(n.compression.area, 66722e-6, rounded * 66722e-6, "effective area")
  near(n.axial, 887 * kN, rounded * 887 * kN, "axial resistance")
  -- not published: no prying (250 mm is beyond L_b*), half of table 6.6 in one mechanism
  local mx = 40 - 2.8 * math.sqrt(2)
  local l = math.min(2 * pi * mx, pi * mx + 200, pi * mx + 140, 4 * mx + 37.5, 70 + 2 * mx + 18.75, 170,
    100 + 2 * mx + 18.75)
  local T = 2 * 0.25 * l * 18 ^ 2 * 235 / mx
  near(n.tension_row.resistance, T, 1e-6 * T, "row of bolts")
  near(n.moment, T * 0.2325, 1e-6 * T, "moment without axial force")
  local kt, kc = 1 / (1 / (0.425 * l * 18 ^ 3 / mx ^ 3) + 250 / (2 * 245)), n.k13 * 1e3
  near(kc, 27 / 210 / 1.275 * math.sqrt(n.compression.width * n.compression.length) * 1e3, 1e-9, "k13")
  near(n.stiffness, 210e3 * 232.5 ^ 2 / (1 / kt + 1 / kc) / 1e3, 10, "stiffness without axial force")
  local C = n.compression.resistance
  for axial, wanted in pairs { [100e3] = math.min(T * 0.2325 + 100e3 * 0.0925, C * 0.2325 - 100e3 * 0.14),
    [300e3] = math.min(T * 0.2325 + 300e3 * 0.0925, C * 0.2325 - 300e3 * 0.14),
    [600e3] = 2 * 0.0925 * (C - 300e3) } do
    local _, at = hinge.joint.base_plate(with(base, { axial = axial }))
    near(at.moment, wanted, 1e-6 * wanted, axial .. " N: moment")
    if axial < C then -- table 6.12: e = -M / N
      local ek, e = (92.5 * kc - 140 * kt) / (kc + kt), -1e3 * at.moment / axial
      local S = 210e3 * 232.5 ^ 2 / (1 / kt + 1 / kc) * e / (e + ek) / 1e3
      near(at.stiffness, S, 1e-6 * S, axial .. " N: stiffness")
    end
  end
  checks.refused("field 'axial' is 900000 N; must be below", hinge.joint.base_plate, with(base, { axial = 900e3 }))
end)

case("panel zone: the lines of Krawinkler, by hand", function()
  -- HEB 300 of 235 MPa, a beam 450 mm deep, with a doubler plate of 8 mm and without: mm, N, MPa
  for _, doubler in ipairs { 0, 8 } do
    local _, n = hinge.joint.panel_zone { column = { section = hinge.section.named "HEB 300", yield_stress = 235e6 },
      beam_depth = 0.45, doubler = doubler * mm }
    local t, G = 11 + doubler, 210e3 / 2.6
    local V, Ke = 0.55 * 235 * 300 * t, 0.95 * 300 * t * G
    near(n.shear, V, 1e-6 * V, "shear at yield")
    near(n.distortion, V / Ke, 1e-9, "distortion at yield")
    near(n.stiffness, Ke * 0.45, 1e-6 * Ke, "stiffness")
    -- the form of AISC 360-16, J10-11, with 0.55 in the place of 0.6
    local full = 0.55 * 235 * 300 * t * (1 + 3 * 300 * 19 ^ 2 / (450 * 300 * t))
    near(n.full_shear, full, 1e-6 * full, "shear at four times the distortion")
    near(n.points[2][2], 0.45 * full, 1e-6 * full, "moment there")
    near(n.points[2][1], 4 * V / Ke, 1e-9, "rotation there")
  end
  local _, n = hinge.joint.panel_zone { column = { section = hinge.section.named "HEB 300", yield_stress = 235e6 },
    beam_depth = 0.45, storey_height = 3.6, hardening = 0.03 }
  near(n.lever_arm, 0.45 / (1 - 0.125), 1e-12, "lever arm, less the shear of the column")
  near((n.points[3][2] - n.points[2][2]) / (n.points[3][1] - n.points[2][1]), 0.03 * n.stiffness, 1, "hardening")
end)

case("the joint in a run", function()
  local options = with(flush, { capacity = 0.08 })
  local joint, n = hinge.joint.end_plate(options)
  local steel = hinge.material { E = 210e9, density = 7850 }
  for _, part in ipairs { 0.5, 0.75, 0.92 } do
    local model, _, beam = scenes.cantilever { model = { displacement = "small" }, length = 2,
      force = { 0, 0, -part * n.moment / 2 }, member = { section = options.beam.section, material = steel,
        up = { 0, 0, 1 }, ends = { a = joint } } }
    equal(model:static { steps = 10 }:finish().verdict, "completed", "run")
    local wanted = part * n.moment / n.stiffness * (part > 2 / 3 and (1.5 * part) ^ 2.7 or 1)
    near(math.abs(beam:joint("a").rotation_x), wanted, 1e-4 * wanted, ("rotation at %g of the resistance"):format(part))
  end
end)

case("wrong input is refused", function()
  local function refused(make, base, more, message) checks.refused(message, make, with(base, more)) end
  local plate, pin = hinge.joint.end_plate, hinge.joint.fin_plate
  refused(plate, c1, { bolts = { rows = { 0.5653, 0.5353 } } }, "apart; must be 2.2 hole diameters")
  refused(plate, c1, { bolts = { rows = { 0.64, 0.5653 } } }, "EN 1993-1-8 has one row outside")
  refused(plate, c1, { bolts = { diameter = 0.021 } }, "must be that of a bolt M12")
  refused(plate, c1, { bolts = { grade = "9.9" } }, "one of 10.9, 4.6")
  refused(plate, c1, { bolts = { gauge = 0.03 } }, "no room between a bolt and the weld or fillet at the")
  refused(plate, c1, { bolts = { rows = { 0.53 } } }, "no room between a bolt and the weld or fillet at the")
  refused(plate, c1, { bolts = { rows = { "a" } } }, "field 'rows[1]' is 'a'; must be a number above 0 m")
  refused(plate, c1, { plate = { width = 0.13 } }, "the distance of the bolts from the plate's edge, m, is 0.015")
  refused(plate, c1, { plate = { thicknes = 0.13 } }, "field 'plate': unknown field 'thicknes'")
  refused(plate, c1, { column = { stress = 300e6 } }, "field 'stress' is 300000000 Pa; must be a number")
  refused(plate, c1, { plate = { width = 1 }, bolts = { gauge = 0.06 } }, "the plate is too wide for its bolts")
  refused(plate, c1, { beta = 3 }, "field 'beta' is 3; must be a number of at least 0 and of at most 2")
  refused(plate, c1, { column = { section = hinge.section.named "IPE 600", yield_stress = 690e6 } },
    "a more slender web in shear is not theirs")
  refused(plate, c1, { beam = { section = hinge.section.solid { width = 0.1, depth = 0.3 } } }, "must be an H")
  refused(plate, c1, { column = { section = hinge.section.h { depth = 0.26, width = 0.26, web = 0.012,
    flange = 0.02 } } }, "a section without fillets is taken as welded")
  refused(plate, c1, { beam = { section = hinge.section.named "UC 305x305x97", yield_stress = 690e6 } },
    "classes 1 and 2")
  refused(pin, fin, { bolts = { rows = 1, lines = 1 }, plate = { depth = 0.08 } },
    "a single bolt does not hold the moment")
  refused(pin, fin, { bolts = { lines = 3 } }, "field 'lines' is 3; must be a whole number")
  refused(pin, fin, { plate = { edge = 0.02 } }, "must be 0.0264 m or more: 1.2 hole diameters")
  refused(pin, fin, { beam = { top = 0.06 } }, "the plate would be in a flange or a fillet")
  local panel = { column = { section = hinge.section.named "HEB 300", yield_stress = 235e6 }, beam_depth = 0.45 }
  refused(hinge.joint.panel_zone, panel, { storey_height = 0.4 }, "must be more than the depth of the beam, 0.45 m")
  refused(hinge.joint.panel_zone, panel, { doubler = -1 }, "field 'doubler' is -1 m")
  refused(hinge.joint.panel_zone, panel, { column = { section = hinge.section.solid { width = 1, depth = 1 } } },
    "must be an H")
  local angles = hinge.joint.web_cleats
  refused(angles, cleats, { cleats = { column_edge = 0.02 } }, "'column_edge' is 0.02 m; must be 0.0264 m or more")
  refused(angles, cleats, { cleats = { column_gauge = 0.06 } }, "'column_gauge' is 0.06 m; must be 0.071 m or more")
  refused(angles, cleats, { cleats = { depth = 0.47 } }, "must be 0.47 m or more: the depth of field 'cleats'")
  refused(angles, cleats, { gamma_M1 = 1 }, "unknown field 'gamma_M1'")
  refused(pin, fin, { gap = 0 }, "field 'gap' is 0 m; must be a number above 0 m")
  checks.refused("hinge.joint: unknown field 'cleats'", function() local _ = hinge.joint.cleats end)
end)

checks.done()
