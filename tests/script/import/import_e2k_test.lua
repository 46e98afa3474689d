-- hinge.import.e2k: text files of ETABS. Storeys, points, shapes, units, dialects, diaphragms, springs, floors, names
-- of sections that hinge lacks. What is not read is in the notes with its line; broken lines are refused with the line.
--
-- Run: lua5.4 tests/script/import/import_e2k_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local files = require "import.files"
local hinge = require "hinge"
local import = require "hinge.import"
local frame_module = require "hinge.import.frame"
local checks = support.checks "files of ETABS"
local case, near, equal, expect, refused = checks.case, checks.near, checks.equal, checks.expect, checks.refused

local write = support.writer()
local small = { model = { displacement = "small" } }

local function e2k(text, sections) return import.e2k { file = write("frame.e2k", text), sections = sections } end
local function etabs(more, options) return e2k(files.etabs(more, options)) end

case("ETABS: storeys and points are joints, braces go over storeys, points may lie below", function()
  local frame, notes = etabs [[
$ LINE ASSIGNS
  LINEASSIGN "C1"  "S1"  SECTION "A"
  LINEASSIGN "D1"  "S2"  SECTION "A"  RELEASE "M2I M3I M2J M3J TJ"
  LINEASSIGN "B2"  "S2"  SECTION "A"
]]
  local _, nodes, members = import.build(frame, small)
  for name, at in pairs { ["1@Base"] = { 0, 0, 1 }, ["1@S1"] = { 0, 0, 4 }, ["2@S2"] = { 4, 0, 7 },
    ["3@S2"] = { 4, 3, 6.5 } } do
    local n = nodes[name]
    equal(("%g %g %g"):format(n.x, n.y, n.z), ("%g %g %g"):format(at[1], at[2], at[3]), name)
  end
  equal(members["D1@S2"].group, "braces", "its group")
  for _, m in ipairs(frame.members) do
    if m.name == "D1@S2" then
      equal(m.a .. " " .. m.b, "1@Base 2@S2", "a brace over two storeys")
      equal(m.release.a .. " " .. m.release.b, "rx,ry rx,ry,rz", "released ends")
    end
  end
  expect(tostring(notes):find("below its storey", 1, true), "the third number of a point is noted: %s", tostring(notes))
  local m = frame.materials[1]
  near(m.yield_stress, 355e6, 1, "FY, Pa")
  near(m.density, 7850, 1e-6, "the density is the weight over 9.80665 m/s^2")
  local s, h = members["C1@S1"].section, hinge.section.h { width = 0.2, depth = 0.4, web = 0.008, flange = 0.012 }
  for _, key in ipairs { "area", "Ix", "Iy", "J", "Zx", "depth" } do near(s[key], h[key], 1e-12, key) end
end)

case("ETABS: other shapes, a shape by its name, modifiers, and the older dialect", function()
  local assign = '$ LINE ASSIGNS\n  LINEASSIGN "C1"  "S1"  SECTION "A"\n'
  for shape, wanted in pairs {
    ['"Steel Tube"  D 0.4 B 0.2 TF 0.012 TW 0.008'] = hinge.section.box { width = 0.2, depth = 0.4, web = 0.008,
      flange = 0.012 },
    ['"Steel Pipe"  D 0.4 TF 0.01'] = hinge.section.pipe { diameter = 0.4, thickness = 0.01 },
    ['"Concrete Rectangular"  D 0.4 B 0.2'] = hinge.section.solid { width = 0.2, depth = 0.4 },
    ['"HEB 200"'] = hinge.section.named "HEB 200",
  } do
    local _, _, members = import.build((etabs(assign, { shape = shape })), small)
    for _, key in ipairs { "area", "Ix", "Iy", "J", "Zx" } do
      near(members["C1@S1"].section[key], wanted[key], 1e-12, shape .. ": " .. key)
    end
  end
  local frame = etabs(assign, { shape = '"General"  AREA 0.01 I33 2e-4 I22 5e-5 TORSION 1e-6 AS2 0.004 AS3 0.005\n'
    .. '  FRAMESECTION "A"  I33MODIFIER 0.5  I2MOD 0.7' })
  near(frame.sections[1].Ix, 1e-4, 1e-15, "I33MODIFIER")
  near(frame.sections[1].Iy, 3.5e-5, 1e-15, "I2MOD")

  local old = e2k [[
$ PROGRAM INFORMATION
  PROGRAM  "ETABS"  VERSION "9.7.3"
$ CONTROLS
  UNITS  "TON"  "M"
$ STORIES - IN SEQUENCE FROM TOP
  STORY "STORY1"  HEIGHT 3  ELEV 3
  STORY "BASE"  ELEV 0
$ MATERIAL PROPERTIES
  MATERIAL  "STEEL"  M 0.8  W 7.85  TYPE "ISOTROPIC"  E 2.1E+07  U 0.3  A 1.2E-05
$ FRAME SECTIONS
  FRAMESECTION  "A"  MATERIAL "STEEL"  SHAPE "Rectangular"  D 0.4  B 0.2
$ POINT COORDINATES
  POINT "1"  0  0
$ LINE CONNECTIVITIES
  LINE  "C1"  COLUMN  "1"  "1"  1
$ POINT ASSIGNS
  POINTASSIGN  "1"  "BASE"  RESTRAINT "UX UY UZ RX RY RZ"
$ LINE ASSIGNS
  LINEASSIGN  "C1"  "STORY1"  SECTION "A"  ANG  90  MINNUMSTA 3  LENGTHOFFI 0  LENGTHOFFJ 0  RIGIDZONE 1
$ STATIC LOADS
  LOADCASE "G"  TYPE  "DEAD"  SELFWEIGHT  0
$ POINT OBJECT LOADS
  POINTLOAD  "1"  "STORY1"  TYPE "FORCE"  LC "G"  FX 0  FY 2  FZ 0  MX 0  MY 0  MZ 0
]]
  local g = 9806.65
  near(old.materials[1].density, 0.8 * g, 1e-9 * g, "M is the mass per volume")
  near(old.materials[1].E, 2.1e7 * g, 1, "tons of force")
  local model, nodes = import.build(old, small)
  local _, tip_y = nodes["1@STORY1"]:displacement(model:static { steps = 1, loads = { G = 1 } }:finish())
  -- turned by 90 degrees axis 2 is Y: the depth of 0.4 m bends
  local Es, I, shear = 2.1e7 * g, 0.2 * 0.4 ^ 3 / 12, 5 / 6 * 0.08
  near(tip_y, 2 * g * (27 / (3 * Es * I) + 3 / (Es / 2.6 * shear)), 1e-9, "displacement, m")
end)

case("ETABS: what is not read is named with its line, and broken lines are refused", function()
  local frame, notes = etabs [[
$ LINE ASSIGNS
  LINEASSIGN "B1"  "S1"  SECTION "A"  LENGTHOFFI 0.2 LENGTHOFFJ 0.2  PROPMOD "half"
$ POINT ASSIGNS
  POINTASSIGN "1"  "S1"  DIAPH "D1"
  POINTASSIGN "2"  "S1"  DIAPH "D1"  SPRINGPROP "soft"
$ FRAME OBJECT LOADS
  LINELOAD "B1"  "S1"  TYPE "UNIFF"  DIR "GRAV"  LC "DEAD"  FVAL 5
  LINELOAD "B1"  "S1"  TYPE "TRAPF"  DIR "GRAV"  LC "DEAD"  FSTART 5  FEND 0  RDSTART 0  RDEND 1
  LINELOAD "B1"  "S1"  TYPE "POINTF"  DIR "GRAV"  LC "DEAD"  FVAL 5
$ AREA CONNECTIVITIES
  AREA "F1"  FLOOR 4 "1" "2" "3" "1" 0 0 0 0
$ LOAD COMBINATIONS
  COMBO "C"  TYPE "Linear Add"
]]
  local q = frame.cases[1].loads[1].q
  equal(("%g %g %g"):format(q[1], q[2], q[3]), "0 0 -5000", "the uniform load, N/m")
  local more = frame.cases[1].loads[2].q
  equal(("%g %g"):format(more.a[3], -more.b[3]), "-5000 0", "the trapezoid, N/m")
  equal(#frame.cases[1].loads, 2, "and no other")
  files.notes_are(expect, "e2k", notes, files.etabs_head, { [2] = "PROPMOD", [5] = "spring soft is not read",
    [9] = "without RDIST", [11] = "area" })
  expect(files.at_line(notes.skipped, files.etabs_head + 13), "combinations are no part of a frame: %s", notes)

  local assign = '$ LINE ASSIGNS\n  LINEASSIGN "C1"  "S1"  SECTION "A"\n'
  for wrong, words in pairs {
    ['$ LINE ASSIGNS\n  LINEASSIGN "C9"  "S1"  SECTION "A"\n'] = ":25: line 'C9' is not in $ LINE CONNECTIVITIES",
    ['$ LINE ASSIGNS\n  LINEASSIGN "C1"  "S7"  SECTION "A"\n'] = ":25: storey 'S7' is not in $ STORIES",
    ['$ LINE ASSIGNS\n  LINEASSIGN "C1"  "Base"  SECTION "A"\n'] = ":25: line C1 on storey Base begins",
    ['$ LINE ASSIGNS\n  LINEASSIGN "C1"  "S1"  SECTION "Z"\n'] = ":25: section Z",
    ['$ LINE ASSIGNS\n  LINEASSIGN "C1"  "S1"  SECTION "A"  RELEASE "M4I"\n'] = ":25: RELEASE 'M4I'",
    [assign .. '$ POINT ASSIGNS\n  POINTASSIGN "1"  "Base"  RESTRAINT "UP"\n'] = ":27: RESTRAINT 'UP'",
    [assign .. '$ POINT OBJECT LOADS\n  POINTLOAD "1"  "S1"  TYPE "FORCE"  LC "DEAD"  FX "much"\n'] =
      ":27: FX is 'much'",
    [assign .. '$ POINT ASSIGNS\n  POINTASSIGN "1"  "Base  RESTRAINT\n'] = ":27: the quotes are not closed",
  } do
    refused(words, function() etabs(wrong) end)
  end
  refused(":2: UNITS are 'STONE'", function() etabs("", { units = '"STONE" "M"' }) end)
  refused("no line that begins with", function() e2k "nothing\n" end)
end)

-- Units ---------------------------------------------------------------------------------------------------------------

-- A cantilever 3 m high of a section 0.1 m2 in these units; line: what the material says of weight and mass.
local function in_units(force, length, metre, newton, line)
  local function u(value, power) return ("%.12g"):format(value / metre ^ power) end
  return e2k(([[
$ CONTROLS
  UNITS  "%s"  "%s"  "C"
$ STORIES - IN SEQUENCE FROM TOP
  STORY "S1"  HEIGHT %s
  STORY "Base"  ELEV 0
$ MATERIAL PROPERTIES
  MATERIAL  "C"    TYPE "Concrete"  %s
  MATERIAL  "C"    SYMTYPE "Isotropic"  E %.12g  U 0.2
$ FRAME SECTIONS
  FRAMESECTION  "R"  MATERIAL "C"  SHAPE "Rectangular"  D %s B %s
$ POINT COORDINATES
  POINT "1"  0 0
$ LINE CONNECTIVITIES
  LINE  "C1"  COLUMN  "1"  "1"  1
$ POINT ASSIGNS
  POINTASSIGN  "1"  "Base"  RESTRAINT "UX UY UZ RX RY RZ"
$ LINE ASSIGNS
  LINEASSIGN  "C1"  "S1"  SECTION "R"
]]):format(force, length, u(3, 1), line, 30e9 / newton * metre ^ 2, u(0.5, 1), u(0.2, 1)))
end

case("ETABS in several units: mass from M, or from the weight without M, and E and sizes", function()
  for _, unit in ipairs { { "KN", "M", 1, 1e3 }, { "N", "MM", 1e-3, 1 }, { "KN", "MM", 1e-3, 1e3 },
    { "KN", "CM", 1e-2, 1e3 }, { "KIP", "IN", 0.0254, 4448.2216152605 }, { "LB", "FT", 0.3048, 4.4482216152605 } } do
    local force, length, metre, newton = table.unpack(unit)
    local what = force .. ", " .. length .. ": "
    local weight = 24000 * metre ^ 3 / newton -- 24 kN/m3
    for _, key in ipairs { "WEIGHTPERVOLUME", "W" } do
      local m = in_units(force, length, metre, newton, ("%s %.12g"):format(key, weight)).materials[1]
      near(m.density, 24000 / 9.80665, 1e-4, what .. "density from " .. key)
      near(m.E, 30e9, 1e3, what .. "E")
    end
    -- mass in force s^2 / length, which M gives per volume; 2500 kg/m3 beside a weight that says something else
    local mass = 2500 * metre ^ 4 / newton
    local weighed = ("WEIGHTPERVOLUME %.12g M %.12g"):format(weight, mass)
    local m = in_units(force, length, metre, newton, weighed).materials[1]
    near(m.density, 2500, 1e-6, what .. "density from M")
    local frame = in_units(force, length, metre, newton, ("W %.12g"):format(weight))
    local model, nodes, members = import.build(frame, small)
    near(nodes["1@S1"].z, 3, 1e-9, what .. "height, m")
    near(members["C1@S1"].section.area, 0.1, 1e-9, what .. "area, m2")
    near(members["C1@S1"].section.Ix, 0.2 * 0.5 ^ 3 / 12, 1e-9, what .. "Ix, m4")
    model:gravity { 0, 0, -9.80665 }
    local run = model:static { steps = 1 }:finish()
    near(select(3, nodes["1@Base"]:reaction(run)), 24000 * 0.1 * 3, 1, what .. "weight, N")
  end
end)

-- Diaphragms, springs, floors -----------------------------------------------------------------------------------------

local storey = [[
$ CONTROLS
  UNITS  "KN"  "M"  "C"
$ STORIES - IN SEQUENCE FROM TOP
  STORY "Top"  HEIGHT 3
  STORY "Base"  ELEV 0
$ MATERIAL PROPERTIES
  MATERIAL  "S"    TYPE "Steel"    NOTES "of the works
and of the shop"    WEIGHTPERVOLUME 77
  MATERIAL  "S"    SYMTYPE "Isotropic"  E 2E8  U 0.25  A 1.17E-05
$ FRAME SECTIONS
  FRAMESECTION  "C"  MATERIAL "S"  SHAPE "Concrete Rectangular"  D 0.4 B 0.3 NOTIONALUSERVALUE 0.2
$ POINT COORDINATES
  POINT "1"  0 0
  POINT "2"  6 0
$ LINE CONNECTIVITIES
  LINE  "C1"  COLUMN  "1"  "1"  1
  LINE  "C2"  COLUMN  "2"  "2"  1
  LINE  "B1"  BEAM  "1"  "2"  0
$ POINT ASSIGNS
  POINTASSIGN  "1"  "Base"  RESTRAINT "UX UY UZ RX RY RZ"
  POINTASSIGN  "2"  "Base"  RESTRAINT "UX UY UZ RX RY RZ"
  POINTASSIGN  "1"  "Top"  USERJOINT  "Yes"
  POINTASSIGN  "2"  "Top"  USERJOINT  "Yes"
$ LINE ASSIGNS
  LINEASSIGN  "C1"  "Top"  SECTION "C"  COLOURED "Yes"
  LINEASSIGN  "C2"  "Top"  SECTION "C"  COLOURED "Yes"
  LINEASSIGN  "B1"  "Top"  SECTION "C"  RELEASE "PINNED"
]]

case("ETABS: notes of one kind are one note with a count, and what has no meaning is silent", function()
  local frame, notes = e2k(storey)
  equal(#notes, 1, tostring(notes))
  equal(notes[1].reason, "not read of it: COLOURED", "reason")
  equal(notes[1].count, 2, "count")
  equal(table.concat(notes[1].lines, " "), "25 26", "lines")
  equal(frame.members[3].release.a .. " " .. frame.members[3].release.b, "rx,ry rx,ry", "PINNED")
end)

case("ETABS: diaphragms of points and of floors, springs, and floors", function()
  local frame, notes = e2k((storey:gsub('COLOURED "Yes"', "")
    :gsub('RELEASE "PINNED"', ""):gsub('USERJOINT  "Yes"', 'DIAPH "D1"', 1)) .. [[
$ DIAPHRAGM NAMES
  DIAPHRAGM "D1"    TYPE RIGID
$ POINT SPRING PROPERTIES
  POINTSPRING  "S1"  STIFFNESSOPTION  "USERDEFINED"  UX  211000 UY  0 UZ  0
$ POINT ASSIGNS
  POINTASSIGN  "2"  "Top"  SPRINGPROP "S1"
  POINTASSIGN  "3"  "Top"  DIAPH "D1"
$ POINT COORDINATES
  POINT "3"  6 4
$ AREA CONNECTIVITIES
  AREA "F1"  FLOOR  3  "1"  "2"  "3"  0  0  0
$ SLAB PROPERTIES
  SHELLPROP  "L10"  PROPTYPE  "Slab"  MATERIAL "S"  MODELINGTYPE "Membrane"  SLABTYPE "Slab"  SLABTHICKNESS 0.1
$ AREA ASSIGNS
  AREAASSIGN  "F1"  "Top"  SECTION "L10"  DIAPH "D1"
$ SHELL OBJECT LOADS
  AREALOAD  "F1"  "Top"  TYPE "UNIFF"  DIR "GRAV"  LC "DEAD"  FVAL 250
]])
  equal(#notes, 1, tostring(notes))
  equal(notes[1].reason, "1 area of 12 m^2 in all (floors and walls) is not read; with it go the loads DEAD 3000 kN, "
    .. "their own weight 92.4 kN", "the note")
  equal(#frame.diaphragms, 1, "diaphragms")
  equal(table.concat(frame.diaphragms[1].nodes, " "), "1@Top 2@Top", "its joints")
  equal(frame.connectors[1].a .. " " .. frame.connectors[1].stiffness.x, "2@Top 211000000.0", "spring")
end)

case("ETABS: a floor between members gives them its loads", function()
  local frame, notes = e2k((storey:gsub('COLOURED "Yes"', ""):gsub('RELEASE "PINNED"', "")) .. [[
$ POINT COORDINATES
  POINT "3"  6 4
$ LINE CONNECTIVITIES
  LINE  "B2"  BEAM  "2"  "3"  0
  LINE  "B3"  BEAM  "3"  "1"  0
$ LINE ASSIGNS
  LINEASSIGN  "B2"  "Top"  SECTION "C"
  LINEASSIGN  "B3"  "Top"  SECTION "C"
$ AREA CONNECTIVITIES
  AREA "F1"  FLOOR  3  "1"  "2"  "3"  0  0  0
$ AREA ASSIGNS
  AREAASSIGN  "F1"  "Top"  SECTION "None?"
$ LOAD PATTERNS
  LOADPATTERN "DEAD"  TYPE  "Dead"  SELFWEIGHT  0
$ SHELL OBJECT LOADS
  AREALOAD  "F1"  "Top"  TYPE "UNIFF"  DIR "GRAV"  LC "DEAD"  FVAL 250
]])
  equal(#notes, 0, tostring(notes))
  equal(#notes.assumed, 1, "a note of the floor")
  local model, _, members = import.build(frame, small)
  local sum = 0
  for _, c in ipairs(frame.cases) do
    for _, l in ipairs(c.loads) do
      if l.q then
        sum = sum - (l.q.a[3] + l.q.b[3]) / 2 * ((l.to or 1) - (l.from or 0)) * members[l.member].length
      end
    end
  end
  near(sum, 3000e3, 1e-3, "load of a triangle of 12 m^2, N")
  model:close()
end)

case("ETABS: channels, tees and pairs of angles by their dimensions", function()
  for shape, wanted in pairs { -- plates: area, Ix, Iy, by hand
    ["Steel Channel\"  D 0.2 B 0.08 TF 0.01 TW 0.008"] = { 0.00304, 1.834e-05, 1.843e-06 },
    ["Steel Tee\"  D 0.2 B 0.16 TF 0.01 TW 0.008"] = { 0.00312, 1.238e-05, 3.421e-06 },
    ["Steel Double Angle\"  D 0.1 B 0.21 TF 0.01 TW 0.01 DIS 0.01"] = { 0.0038, 3.6e-06, 7.912e-06 },
  } do
    local frame, notes = e2k((storey:gsub('Concrete Rectangular"  D 0.4 B 0.3 NOTIONALUSERVALUE 0.2', shape)))
    equal(#notes, 1, tostring(notes))
    local s = frame.sections[1]
    for i, field in ipairs { "area", "Ix", "Iy" } do
      near(s[field], wanted[i], 2e-3 * wanted[i], shape .. ": " .. field)
    end
  end
end)

-- The storey with a beam 0.5 by 0.2 and these keys of its lines.
local function portal(beam, columns)
  local kinds = { C1 = '"C" ' .. columns, C2 = '"C" ANG 90 ' .. columns, B1 = '"B" ' .. beam }
  return e2k((storey:gsub('("(%w+)"  "Top"  SECTION )[^\n]*', function(head, name) return head .. kinds[name] end)
    :gsub("%$ POINT COORDINATES", '  FRAMESECTION  "B"  MATERIAL "S"  SHAPE "Concrete Rectangular"  D 0.5 B 0.2\n%0')))
end

-- How far the ends of all members are from the points of the file.
local function offsets(frame)
  local list, node = {}, frame_module.by_name(frame.nodes)
  local function shown(place, name)
    local x, z = name:find "^2" and 6 or 0, name:find "Top" and 3 or 0
    local parts = {}
    for k, v in ipairs { place.x - x, place.y, place.z - z } do
      parts[k] = ("%.4g"):format(math.abs(v) < 1e-12 and 0 or v)
    end
    local text = table.concat(parts, " ")
    return text == "0 0 0" and "-" or text
  end
  for i, m in ipairs(frame.members) do
    local a, b = frame_module.ends(m, node)
    list[i] = ("%s; %s"):format(shown(a, m.a), shown(b, m.b))
  end
  return table.concat(list, " | ")
end

case("ETABS: insertion points and rigid zones of lines, in their lengths or automatic", function()
  for _, row in ipairs {
    { "", "", "-; - | -; - | -; -" },
    { 'CARDINALPT 8 TRANSFORMSTIFF "Yes"', "", "-; - | -; - | 0 0 -0.25; 0 0 -0.25" },
    { 'CARDINALPT 8 TRANSSTIFF "YES" RIGIDZONE 1', "", "-; - | -; - | 0.2 0 -0.25; -0.15 0 -0.25" },
    { "CARDINALPT 8", "", "-; - | -; - | -; -" },
    { "RIGIDZONE 0.5", "RIGIDZONE 0.5", "-; 0 0 -0.125 | -; 0 0 -0.125 | 0.1 0 0; -0.075 0 0" },
    { 'CARDINALPT 8 TRANSFORMSTIFF "Yes"', "RIGIDZONE 0.5",
      "-; 0 0 -0.25 | -; 0 0 -0.25 | 0 0 -0.25; 0 0 -0.25" },
    { "LENGTHOFFI 0.3 LENGTHOFFJ 0 RIGIDZONE 0.5", "", "-; - | -; - | 0.15 0 0; -" },
    { "LENGTHOFFI 0.3 LENGTHOFFJ 0.4", "", "-; - | -; - | -; -" },
    { 'TRANSFORMSTIFF "Yes" OFFSETXI 0.05 OFFSETYJ -0.2', "", "-; - | -; - | 0.05 0 0; 0 -0.2 0" },
  } do
    local frame, notes = portal(row[1], row[2])
    equal(#notes, 0, tostring(notes))
    equal(offsets(frame), row[3], row[1] .. ", columns " .. row[2])
  end
end)

case("an unknown section has its own reason and near names, and the option gives another", function()
  local function named(name, sections)
    local text = storey:gsub('"Concrete Rectangular"  D 0.4 B 0.3 NOTIONALUSERVALUE 0.2', '"' .. name .. '"')
    local frame, notes = e2k(text, sections)
    return frame, notes
  end
  local frame = named "W360X79"
  equal(frame.sections[1].named, "W360X79", "a metric name")
  local _, notes = named "W14X999"
  expect(tostring(notes):find("no table of hinge has 'W14X999'; the nearest are 'W14X873'", 1, true), "%s",
    tostring(notes))
  for _, key in ipairs { "C", "W14X999" } do
    frame, notes = named("W14X999", { [key] = "W14X873" })
    equal(frame.sections[1].named, "W14X873", "by " .. key)
    equal(#frame.members, 3, "members")
    expect(tostring(notes):find("it is W14X873, as the option sections says", 1, true), "%s", tostring(notes))
  end
  refused("unknown section of the file in 'sections': 'D'", named, "W14X999", { D = "W14X873" })
  refused("unknown section 'W14X998'", named, "W14X999", { C = "W14X998" })
end)

checks.done()
