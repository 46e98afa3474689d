-- hinge.joint by hand, row by row: the column web in compression (rho and k_wc of EN 1993-1-8, 6.2.6.2), rows near the
-- end of a column (table 6.4), blocks at the end of a plate (3.10.2), the shear of a base plate (6.2.2), and bolts by
-- table 3.1 and the product standards. The numbers are a second transcription.
--
-- Read for it: 6.2.6.2 as eurocode.us prints it; tables 3.1, 3.4 and 6.4 as the program metku and SCI P398 give them;
-- As of ISO 898-1, heads of ISO 4014, nuts of ISO 4032 and washers of ISO 7089 as tables of makers print them.
--
-- Run: lua5.4 tests/script/standards/en_1993_1_8/joint_tables_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../../?.lua;" .. package.path
local hinge = require "hinge"
local parts = require "hinge.standards.en_1993_1_8.parts"
local scenes = require "scenes"
local support = require "support"
local checks = support.checks "tables of joints"
local case, expect, equal, near = checks.case, checks.expect, checks.equal, checks.near

local pi, root_2, root_3 = math.pi, math.sqrt(2), math.sqrt(3)

local function same(value, wanted, what) near(value, wanted, 1e-6 * math.abs(wanted), what) end

-- A beam on a column, flush, with welds of these throats, mm.
local function end_plate_options(column, options)
  options = options or {}
  return {
    beam = { section = hinge.section.named "IPE 400", yield_stress = 355e6 },
    column = { section = column, yield_stress = options.fy or 355e6, stress = options.stress,
      end_distance = options.end_distance },
    plate = { width = 0.2, thickness = 0.015, yield_stress = 355e6, below = options.below or 0 },
    bolts = { diameter = 0.02, grade = "8.8", rows = options.rows or { 0.32 }, gauge = 0.1 },
    welds = { flange = 0.006, web = 0.004 }, beta = options.beta or 0, capacity = 0.03,
    gamma_M1 = options.gamma_M1 or 1, gamma_M2 = 1.25,
  }
end
local function end_plate(...) return select(2, hinge.joint.end_plate(end_plate_options(...))) end

-- 6.2.6.2 -------------------------------------------------------------------------------------------------------------

case("6.2.6.2: rho of a slender web, on each side of a slenderness of 0.72", function()
  local seen = {}
  for _, r in ipairs { { "HEB 300", 355 }, { "HEM 300", 355 }, { "HEB 220", 235 },
    { "HEA 300", 235 }, { "HEA 300", 460 }, { "HEA 400", 355 },
    { "HEA 240", 275 }, { "HEAA", 460 } } do
    local s = r[1] ~= "HEAA" and hinge.section.named(r[1])
      or hinge.section.h { depth = 0.29, width = 0.3, web = 0.0065, flange = 0.012, r = 0.027 }
    local fy, p = r[2], { h = s.depth * 1e3, tw = s.web * 1e3, tf = s.flange * 1e3 }
    local root = math.sqrt((s.area * 1e6 - 2 * s.width * 1e3 * p.tf - (p.h - 2 * p.tf) * p.tw) / (4 - pi))
    local d = p.h - 2 * p.tf - 2 * root
    local b = 13.5 + 2 * root_2 * 6 + 5 * (p.tf + root) + 15 -- no plate below the flange: one thickness
    local slenderness = 0.932 * math.sqrt(b * d * fy / (210e3 * p.tw ^ 2))
    local rho = slenderness <= 0.72 and 1 or (slenderness - 0.2) / slenderness ^ 2
    local c = end_plate(s, { fy = fy * 1e6 }).compression
    same(c.slenderness, slenderness, r[1] .. ": slenderness")
    same(c.rho, rho, r[1] .. ": rho")
    same(c.column_web, rho * b * p.tw * fy, r[1] .. ": 6.9")
    seen[slenderness <= 0.72] = true
    c = end_plate(s, { fy = fy * 1e6, gamma_M1 = 1.1 }).compression
    local wanted = support.smallest_of(1, rho / 1.1) * b * p.tw * fy
    same(c.column_web, wanted, r[1] .. ": gamma_M1 with rho, gamma_M0 without")
  end
  expect(seen[true] and seen[false], "webs on both sides of 0.72")
end)

case("6.14: k_wc of a compressed column, on each side of 0.7 f_y", function()
  local column = hinge.section.named "HEB 300"
  local free = end_plate(column).compression.column_web
  for part, wanted in pairs { [0] = 1, [0.4] = 1, [0.699] = 1, [0.701] = 0.999, [0.85] = 0.85, [1] = 0.7 } do
    local c = end_plate(column, { stress = part * 355e6 }).compression
    near(c.k_wc, wanted, 1e-9, ("k_wc at %g f_y"):format(part))
    same(c.column_web, wanted * free, ("the web at %g f_y"):format(part))
  end
end)

case("the plate below the flange spreads the compression, up to 45 degrees", function()
  local column = hinge.section.named "HEB 300"
  for below, wanted in pairs { [0] = 15, [0.012] = 15 + 12 - 6 * root_2, [0.05] = 30 } do -- t_p + ..., at most 2 t_p
    local c = end_plate(column, { below = below }).compression
    same(c.width * 1e3, 13.5 + 12 * root_2 + 5 * (19 + 27) + wanted, "b_eff of a plate " .. below .. " m below")
  end
end)

-- Table 6.4 -----------------------------------------------------------------------------------------------------------

case("table 6.4: one row, and two, near the end of a column and far from it", function()
  local column = hinge.section.named "HEB 300"
  local m, e = (100 - 11) / 2 - 0.8 * 27, 100 -- 22.9
  local side, p = 2 * m + 0.625 * e, 100
  for _, e1 in ipairs { 30, 45, 60, 500 } do
    local one = end_plate(column, { end_distance = e1 / 1e3 }).rows[1].components.column_flange.lengths
    local circular = support.smallest_of(2 * pi * m, pi * m + 2 * e1)
    local other = support.smallest_of(2 * side, side + e1)
    same(one.circular * 1e3, circular, ("one row, %g mm from the end: circular"):format(e1))
    same(one.other * 1e3, other, ("one row, %g mm from the end: others"):format(e1))
    same(one.mode_1 * 1e3, support.smallest_of(circular, other), "mode 1: the smaller")
    same(one.mode_2 * 1e3, other, "mode 2: no circular pattern")
    -- two rows as a group: the end row and the last of the group
    local n = end_plate(column, { end_distance = e1 / 1e3, rows = { 0.32, 0.22 } })
    local two
    for _, group in ipairs(n.groups) do
      if group.from == 1 and group.to == 2 then two = group.components.column_flange.lengths end
    end
    circular = support.smallest_of(pi * m + p, 2 * e1 + p) + pi * m + p
    other = support.smallest_of(side + p / 2, e1 + p / 2) + side + p / 2
    same(two.circular * 1e3, circular, ("two rows, %g mm from the end: circular"):format(e1))
    same(two.other * 1e3, other, ("two rows, %g mm from the end: others"):format(e1))
    -- the second row alone is no end row
    local second = n.rows[2].components.column_flange.lengths
    same(second.circular * 1e3, 2 * pi * m, "the second row: circular")
    same(second.other * 1e3, 2 * side, "the second row: others")
  end
  -- an inner row of three has its pitches
  local three = end_plate(column, { rows = { 0.32, 0.24, 0.15 } })
  for _, group in ipairs(three.groups) do
    if group.from == 1 and group.to == 3 then
      local lengths = group.components.column_flange.lengths
      same(lengths.circular * 1e3, pi * m + 80 + 80 + 90 + pi * m + 90, "three rows: circular")
      same(lengths.other * 1e3, side + 40 + 85 + side + 45, "three rows: others")
    end
  end
end)

case("the row with the largest moment governs", function()
  local n = end_plate(hinge.section.named "HEB 300", { rows = { 0.32, 0.1 } })
  expect(n.rows[1].force * 0.32 > n.rows[2].force * 0.1, "the upper row has the larger moment")
  equal(n.governs, n.rows[1].governs, "what governs")
  equal(n.rows[1].force < n.rows[2].force * 1.5, true, "and forces of the same size")
end)

case("table 3.3: rows are 2.2 hole diameters apart or more", function()
  local column = hinge.section.named "HEB 300"
  local apart = 2.2 * 0.022
  equal(#end_plate(column, { rows = { 0.32, 0.32 - apart } }).rows, 2, "just so")
  checks.refused("must be 2.2 hole diameters", hinge.joint.end_plate, end_plate_options(column,
    { rows = { 0.32, 0.32 - 0.99 * apart } }))
end)

-- Fin plates and cleats -----------------------------------------------------------------------------------------------

local function fin(options)
  options = options or {}
  return select(2, hinge.joint.fin_plate {
    beam = { section = hinge.section.named "IPE 400", yield_stress = 275e6, ultimate_stress = 430e6, edge = 0.045,
      top = 0.1 },
    plate = { depth = 0.28, thickness = 0.01, yield_stress = 265e6, ultimate_stress = 410e6, edge = 0.05 },
    bolts = { diameter = 0.02, grade = "8.8", rows = 3, pitch = 0.08, lines = options.lines or 1,
      gauge = options.lines and 0.06 or nil },
    gap = 0.01, gamma_M0 = 1.05, gamma_M2 = 1.25, gamma_Mu = 1.1, capacity = 0.05,
  })
end

case("3.10.2: blocks of a plate and a web, between the bolts and at the plate's end, by hand", function()
  for lines = 1, 2 do
    local n = fin { lines = lines == 2 and 2 or nil }
    local p2 = lines == 2 and 60 or 0
    local e1, holes = (280 - 160) / 2, (lines - 0.5) * 22
    local what = lines .. " line(s): "
    local along = p2 + 50 - holes
    same(n.tension_of["block of the plate"], 410 * 10 * 2 * (80 - 22) / 1.1 + 2 * 265 * 10 * along / (root_3 * 1.05),
      what .. "tying, between the outer rows")
    same(n.tension_of["block at the plate's end"],
      410 * 10 * (e1 + 160 - 2.5 * 22) / 1.1 + 265 * 10 * along / (root_3 * 1.05), what .. "tying, at the plate's end")
    same(n.tension_of["plate, net"], 0.9 * 10 * (280 - 66) * 410 / 1.1, what .. "tying, net section")
    local web = p2 + 45 - holes
    same(n.tension_of["block of the beam's web"], 430 * 8.6 * 116 / 1.1 + 2 * 275 * 8.6 * web / (root_3 * 1.05),
      what .. "tying, the web")
    same(n.shear_of["block of the plate"], 0.5 * 410 * 10 * (p2 + 50 - (2 * lines - 1) * 11) / 1.25
      + 265 * 10 * (280 - e1 - 2.5 * 22) / (root_3 * 1.05), what .. "shear, the plate")
    same(n.shear_of["block of the beam's web"], 0.5 * 430 * 8.6 * (p2 + 45 - (2 * lines - 1) * 11) / 1.25
      + 275 * 8.6 * (100 + 160 - 2.5 * 22) / (root_3 * 1.05), what .. "shear, the web")
    same(n.shear_of["plate in shear"], 280 * 10 * 265 / (1.27 * root_3 * 1.05), what .. "shear, gross")
    same(n.shear_of["plate in shear, net"], 10 * (280 - 66) * 410 / (root_3 * 1.25), what .. "shear, net")
    near(n.lever_arm, (10 + 45 + p2 / 2) * 1e-3, 1e-12, what .. "lever arm of the bolts")
  end
end)

case("table 3.4: bearing and shear of the bolts of a fin plate, by hand", function()
  local n = fin()
  -- one line of three, 55 mm from the column: the outer bolts have F / 3 down and F 55 / 160 across
  local function shared(down, across) return 1 / math.sqrt((1 / 3 / down) ^ 2 + (55 / 160 / across) ^ 2) end
  local Fv = 0.6 * 800 * 245 / 1.25
  same(n.shear_of["bolts in shear"], shared(Fv, Fv), "bolts in shear")
  same(n.tension_of["bolts in shear"], 3 * 0.6 * 800 * 245 / 1.1, "in tying, by gamma_Mu")
  local function bearing(e1, p1, e2, p2, t, fu)
    local a = support.smallest_of(e1 / 66, p1 and p1 / 66 - 0.25 or 1, 800 / fu, 1)
    local k = support.smallest_of(2.8 * e2 / 22 - 1.7, p2 and 1.4 * p2 / 22 - 1.7 or 2.5, 2.5)
    return k * a * fu * 20 * t / 1.25
  end
  same(n.shear_of["bearing on the plate"], shared(bearing(60, 80, 50, nil, 10, 410), bearing(50, nil, 60, 80, 10, 410)),
    "bearing on the plate")
  same(n.shear_of["bearing on the beam's web"], shared(bearing(100, 80, 45, nil, 8.6, 430),
    bearing(45, nil, 100, 80, 8.6, 430)), "bearing on the web")
  -- a stocky plate in bending does not govern: 280 mm is above 2.73 z
  same(n.contact, math.asin(55 / math.sqrt(45 ^ 2 + 220 ^ 2)) - math.atan(45 / 220), "rotation at contact")
end)

-- Base plates ---------------------------------------------------------------------------------------------------------

-- HEB 200 in S235 on a plate of 340x340x18 mm. o: of the plate length, width, thickness; of the bolts diameter, grade,
-- bolt_length; of the concrete strength, grout; section, yield_stress, axial.
local function base(o)
  return select(2, hinge.joint.base_plate {
    column = { section = hinge.section.named(o.section or "HEB 200"), yield_stress = o.yield_stress or 235e6 },
    plate = { length = o.length or 0.34, width = o.width or 0.34, thickness = o.thickness or 0.018,
      yield_stress = 235e6 },
    bolts = { diameter = o.diameter or 0.02, grade = o.grade or "8.8", outside = 0.035, gauge = 0.2,
      length = not o.grout and 0.25 or nil },
    concrete = { strength = o.strength or 20e6, grout = o.grout }, weld = 0.0035, axial = o.axial or 0, capacity = 0.05,
    gamma_c = 1.5, gamma_M2 = 1.25 })
end

case("6.2.2 (6) to (8): shear of a base plate by friction and four bolts, by hand", function()
  -- F_1,vb = alpha_v f_ub As / gamma_M2, F_2,vb = (0.44 - 0.0003 f_yb) f_ub As / gamma_M2
  for _, r in ipairs { { "4.6", 240, 400, 0.6 }, { "5.6", 300, 500, 0.6 }, { "8.8", 640, 800, 0.6 },
    { "10.9", 900, 1000, 0.5 } } do
    local alpha = support.smallest_of(0.44 - 0.0003 * r[2], r[4])
    for _, axial in ipairs { 0, 300e3 } do
      local n = base { grade = r[1], axial = axial }
      same(n.shear, 0.2 * axial + 4 * alpha * r[3] * 245 / 1.25, ("grade %s, N = %g N"):format(r[1], axial))
    end
  end
end)

case("the flange of a column on concrete: bearing, and what limits it", function()
  -- c = t sqrt(fy / (3 f_jd)); f_jd = 2/3 20 / 1.5 = 8.89 MPa: 53.4 mm, and 118.7 of 40 mm
  for thickness, strength in pairs { [0.018] = 20e6, [0.04] = 20e6, [0.03] = 90e6 } do
    local n = base { thickness = thickness, strength = strength }
    local f = 2 / 3 * strength / 1.5
    local c = thickness * math.sqrt(235e6 / (3 * f))
    local hw = 0.17
    local width = support.smallest_of(c, 0.07) + 0.015 + support.smallest_of(c, hw / 2)
    local length = support.smallest_of(0.2 + 2 * c, 0.34)
    same(n.compression.reach, c, "c")
    same(n.compression.width, width, "width")
    same(n.compression.length, length, "length")
    same(n.compression.concrete, f * width * length, "concrete")
    local flange = 642.5e-6 * 235e6 / (0.2 - 0.015)
    near(n.compression.flange, flange, 1e-3 * flange, "column flange")
    same(n.compression.resistance, support.smallest_of(n.compression.flange, f * width * length), "the smaller of both")
  end
  -- what governs: bolts, plate, concrete, the column's flange
  equal(base({ thickness = 0.012 }).governs, "plate in bending", "a thin plate")
  equal(base({ thickness = 0.06, diameter = 0.012, grade = "4.6" }).governs, "bolts in tension", "weak bolts")
  equal(base({ thickness = 0.03, strength = 20e6, axial = 700e3 }).governs, "concrete", "a large axial force")
  equal(base({ thickness = 0.05, strength = 90e6, axial = 600e3, diameter = 0.024, grade = "10.9" }).governs,
    "column flange in compression", "strong concrete, and bolts")
end)

case("a base plate's anchor bolts without a length, its flange's class, and its T-stub", function()
  local function plain(more) return base(scenes.with({ length = 0.4, grade = "4.6", grout = 0.03 }, more)) end
  local row = plain().tension_row
  near(row.bolt_length, (8 * 20 + 30 + 18 + 3 + 9) * 1e-3, 1e-12, "L_b: 8 d, grout, plate, washer, half a nut")
  local m = 35 - 0.8 * root_2 * 3.5
  near(row.m, m * 1e-3, 1e-12, "m_x")
  near(row.n, 1.25 * m * 1e-3, 1e-12, "n: at most 1.25 m; e_x is 65 mm")
  local near_end = plain { length = 0.324 }
  near(near_end.tension_row.n, 27e-3, 1e-12, "n: e_x where that is less")
  near(near_end.tension_row.lengths.other * 1e3, support.smallest_of(4 * m + 1.25 * 27, 70 + 2 * m + 0.625 * 27, 170,
    100 + 2 * m + 0.625 * 27), 1e-9, "table 6.6, others")
  near(near_end.tension_row.lengths.circular * 1e3, support.smallest_of(2 * pi * m, pi * m + 200, pi * m + 140), 1e-9,
    "circular")
  -- 1.2 hole diameters, of 22 mm, from the plate's side and end
  for width, good in pairs { [0.253] = true, [0.2525] = false } do
    equal(pcall(plain, { width = width }), good, ("bolts %g mm from the side"):format((width - 0.2) / 2 * 1e3))
  end
  for length, good in pairs { [0.323] = true, [0.3225] = false } do
    equal(pcall(plain, { length = length }), good, ("bolts %g mm from the end"):format((length - 0.27) / 2 * 1e3))
  end
  -- class 2 of the column's flange: c / tf = (200 - 9) / 2 / tf, less the fillet; HEA 200 in S460 has 7.88, and 7.15
  for _, r in ipairs { { "HEA 200", 235e6, true }, { "HEA 200", 460e6, false }, { "HEB 200", 460e6, true } } do
    equal(pcall(plain, { section = r[1], yield_stress = r[2] }), r[3], ("%s, %g MPa"):format(r[1], r[2] / 1e6))
  end
end)

case("table 6.6: a row below the one at the flange has the pattern of a plain row", function()
  local n = end_plate(hinge.section.named "HEB 300", { rows = { 0.32, 0.1 } })
  local m, e = (100 - 8.6) / 2 - 0.8 * root_2 * 4, 50
  local second = n.rows[2].components.end_plate.lengths
  same(second.circular * 1e3, 2 * pi * m, "circular")
  same(second.other * 1e3, 2 * (2 * m + 0.625 * e), "others")
  same(n.rows[1].components.end_plate.lengths.other * 1e3, n.alpha * m, "the row at the flange: alpha m")
  -- shear: a row of two bolts in tension keeps 0.4 / 1.4, and further rows have all
  same(n.shear, 4 * 0.4 / 1.4 * 0.6 * 800 * 245 / 1.25, "shear of two rows in tension")
end)

-- Bolts ---------------------------------------------------------------------------------------------------------------

case("bolts: stress areas, holes, heads, nuts and washers, strengths of the grades", function()
  -- mm: As, hole, head, nut, washer
  for d, r in pairs { [12] = { 84.3, 13, 7.5, 10.8, 2.5 }, [16] = { 157, 18, 10, 14.8, 3 },
    [20] = { 245, 22, 12.5, 18, 3 }, [22] = { 303, 24, 14, 19.4, 3 }, [24] = { 353, 26, 15, 21.5, 4 },
    [27] = { 459, 30, 17, 23.8, 4 }, [30] = { 561, 33, 18.7, 25.6, 4 }, [36] = { 817, 39, 22.5, 31, 5 } } do
    local bolt = parts.bolt("test", { diameter = d / 1e3, grade = "8.8" }, 1.25)
    for i, name in ipairs { "As", "d0", "head", "nut", "washer" } do
      near(bolt[name] * (i == 1 and 1e6 or 1e3), r[i], 1e-9, ("M%d: %s"):format(d, name))
    end
    same(bolt.tension, 0.9 * 800 * r[1] / 1.25, "tension of M" .. d)
    -- As is that of the thread's pitch: pi / 4 (d - 0.9382 P)^2
    local pitch = ({ [12] = 1.75, [16] = 2, [20] = 2.5, [22] = 2.5, [24] = 3, [27] = 3, [30] = 3.5, [36] = 4 })[d]
    near(r[1], pi / 4 * (d - 0.9382 * pitch) ^ 2, 0.005 * r[1], "its area by the pitch")
  end
  for grade, r in pairs { ["4.6"] = { 240, 400, 0.6 }, ["4.8"] = { 320, 400, 0.5 }, ["5.6"] = { 300, 500, 0.6 },
    ["5.8"] = { 400, 500, 0.5 }, ["6.8"] = { 480, 600, 0.5 }, ["8.8"] = { 640, 800, 0.6 },
    ["10.9"] = { 900, 1000, 0.5 } } do
    local bolt = parts.bolt("test", { diameter = 0.02, grade = grade }, 1.25)
    same(bolt.fyb, r[1] * 1e6, grade .. ": f_yb")
    same(bolt.fub, r[2] * 1e6, grade .. ": f_ub")
    same(bolt.shear, r[3] * r[2] * 245 / 1.25, grade .. ": thread in the shear plane")
    same(parts.bolt("test", { diameter = 0.02, grade = grade, shank = true }, 1.25).shear,
      0.6 * r[2] * pi / 4 * 400 / 1.25, grade .. ": shank in the shear plane")
  end
end)

checks.done()
