-- hinge.material.steel, aluminium, timber, concrete and bars: every value of every grade, row by row, on each side of
-- each thickness.
--
-- Read for it: EN 10025-2 and table 3.1 of EN 1993-1-1 as the programs XC and metku give them. ASTM, JIS, EN 338,
-- EN 14080, EN 1999-1-1 and the bars are transcribed from memory a second time; lua/hinge/sections/grades.lua says the
-- same of its table.
--
-- Run: lua5.4 tests/script/sections/grades_tables_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local hinge = require "hinge"
local checks = support.checks "tables of grades"
local case, near, equal, expect = checks.case, checks.near, checks.equal, checks.expect
local material = hinge.material

local function strength(kind, name, options, wanted, what)
  local m = material[kind](name, options)
  near(m.yield_stress, 1e6 * wanted, 1, what or name)
  return m
end

-- Values by thickness on each side of each limit, mm.
local function bands(kind, name, limits, values, options)
  local first = {}
  for key, value in pairs(options or {}) do first[key] = value end
  strength(kind, name, first, values[1], name .. " without a thickness")
  for i, value in ipairs(values) do
    for _, t in ipairs { limits[i], i > 1 and limits[i - 1] + 0.01 or limits[i] / 2 } do
      first.thickness = t / 1e3
      strength(kind, name, first, value, ("%s, %g mm"):format(name, t))
    end
  end
  first.thickness = (limits[#values] + 0.01) / 1e3
  expect(not pcall(material[kind], name, first), "%s is known up to %g mm", name, limits[#values])
end

case("EN 10025 and EN 1993-1-1, table 3.1: yield stress by thickness", function()
  local limits = { 16, 40, 63, 80, 100, 150 }
  for name, values in pairs { S235 = { 235, 225, 215, 215, 215, 195 }, S275 = { 275, 265, 255, 245, 235, 225 },
    S355 = { 355, 345, 335, 325, 315, 295 }, S450 = { 450, 430, 410, 390, 380, 380 },
    S420M = { 420, 400, 390, 380, 370 }, S460M = { 460, 440, 430, 410, 400 } } do
    bands("steel", name, limits, values)
  end
  for name, values in pairs { S235 = { 235, 215 }, S275 = { 275, 255 }, S355 = { 355, 335 }, S420N = { 420, 390 },
    S460N = { 460, 430 } } do
    bands("steel", name, { 40, 80 }, values, { standard = "EN 1993-1-1" })
  end
  near(material.steel "S355".E, 210e9, 0, "E")
  near(material.steel "S355".G, 210e9 / 2.6, 1, "G: nu = 0.3")
end)

case("ASTM and JIS: yield stress and expected yield stress", function()
  for name, r in pairs { A36 = { 250, 1.5 }, ["A572-50"] = { 345, 1.1 }, A992 = { 345, 1.1 }, ["A500-B"] = { 315, 1.4 },
    ["A500-C"] = { 345, 1.3 }, ["A500-B round"] = { 290, 1.4 }, ["A500-C round"] = { 315, 1.3 } } do
    equal(strength("steel", name, nil, r[1]).E, 200e9, name .. ": E")
    strength("steel", name, { thickness = 0.9 }, r[1], name .. ", of any thickness")
    strength("steel", name, { expected = true }, r[1] * r[2], name .. ": R_y F_y")
  end
  for name, fy in pairs { SN400A = 235, SN400B = 235, SN490B = 325, SN490 = 325, BCR295 = 295, BCP325 = 325 } do
    bands("steel", name, { 40 }, { fy })
    equal(material.steel(name).E, 205e9, name .. ": E")
  end
end)

case("EN 1999-1-1: proof stress of extruded profiles", function()
  for name, r in pairs { ["5083-O"] = { { 200 }, { 110 } }, ["6060-T6"] = { { 15 }, { 140 } },
    ["6061-T6"] = { { 20 }, { 240 } }, ["6063-T5"] = { { 3, 25 }, { 130, 110 } }, ["6063-T6"] = { { 25 }, { 160 } },
    ["6063-T66"] = { { 10, 25 }, { 200, 180 } }, ["6005A-T6"] = { { 5, 10, 25 }, { 225, 215, 200 } },
    ["6082-T6"] = { { 5, 15 }, { 250, 260 } } } do
    bands("aluminium", name, r[1], r[2])
    local m = material.aluminium(name)
    equal(m.E, 70e9, name .. ": E")
    equal(m.density, 2700.0, name .. ": density")
  end
end)

case("EN 338 and EN 14080: bending strength, E, G and density of timber", function()
  for name, r in pairs { C16 = { 16, 8.0, 0.50, 370 }, C18 = { 18, 9.0, 0.56, 380 }, C24 = { 24, 11.0, 0.69, 420 },
    C27 = { 27, 11.5, 0.72, 430 }, C30 = { 30, 12.0, 0.75, 460 }, C35 = { 35, 13.0, 0.81, 470 },
    C40 = { 40, 14.0, 0.88, 480 }, D30 = { 30, 11.0, 0.69, 640 }, D40 = { 40, 13.0, 0.81, 660 },
    GL24h = { 24, 11.5, 0.65, 420 }, GL28h = { 28, 12.6, 0.65, 460 }, GL30h = { 30, 13.6, 0.65, 480 },
    GL32h = { 32, 14.2, 0.65, 490 } } do
    local m = strength("timber", name, nil, r[1])
    near(m.E, r[2] * 1e9, 1, name .. ": E")
    near(m.G, r[3] * 1e9, 1, name .. ": G")
    equal(m.density, r[4] + 0.0, name .. ": density")
  end
end)

case("EN 1992-1-1, table 3.1: E of concrete", function()
  -- GPa, as the table prints it
  for name, E in pairs { ["C12/15"] = 27, ["C16/20"] = 29, ["C20/25"] = 30, ["C25/30"] = 31, ["C30/37"] = 33,
    ["C35/45"] = 34, ["C40/50"] = 35, ["C45/55"] = 36, ["C50/60"] = 37, ["C55/67"] = 38, ["C60/75"] = 39,
    ["C70/85"] = 41, ["C80/95"] = 42, ["C90/105"] = 44 } do
    local m = material.concrete(name)
    near(m.E, E * 1e9, 0.51e9, name .. ": rounded to whole GPa")
    local f = tonumber(name:match "%d+") + 8
    near(m.E, 22e9 * (f / 10) ^ 0.3, 1, name .. ": 22 (f_cm / 10)^0.3")
    near(m.G, m.E / 2.4, 1, name .. ": nu = 0.2")
    equal(m.density, 2500.0, name .. ": density")
  end
end)

case("reinforcing bars", function()
  for name, r in pairs { B500A = { 500, 200 }, B500B = { 500, 200 }, B500C = { 500, 200 }, B450C = { 450, 200 },
    ["Grade 40"] = { 280, 200 }, ["Grade 60"] = { 420, 200 }, ["Grade 75"] = { 520, 200 }, SD295 = { 295, 205 },
    SD345 = { 345, 205 }, SD390 = { 390, 205 }, SD490 = { 490, 205 } } do
    equal(strength("bars", name, nil, r[1]).E, r[2] * 1e9, name .. ": E")
  end
end)

case("names are listed in order, and read with or without blanks", function()
  local names = table.concat(material.names "steel", " ")
  expect(names:find("S235 S275 S355", 1, true), "by number: %s", names)
  equal(table.concat(material.names "bars", ","), "B450C,B500A,B500B,B500C,Grade 40,Grade 60,Grade 75,SD295,SD345,"
    .. "SD390,SD490", "bars")
  equal(table.concat(material.names "timber", " "), "C16 C18 C24 C27 C30 C35 C40 D30 D40 GL24h GL28h GL30h GL32h",
    "timber")
end)

checks.done()
