-- hinge.import of files as SAP2000 and ETABS write them: values over several lines, sections without dimensions, and
-- notes of one kind.
--
-- Run: lua5.4 tests/script/import/import_files_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local hinge = require "hinge"
local import = require "hinge.import"
local checks = support.checks "files of SAP2000 and ETABS"
local case, near, equal, expect = checks.case, checks.near, checks.equal, checks.expect

local write = support.writer()

-- SAP2000 -------------------------------------------------------------------------------------------------------------

-- A column of 3 m in kN and m, with a force at its head. section: the fields of its section.
local function column(section, more)
  return ([[
TABLE:  "PROGRAM CONTROL"
   ProgramName=SAP2000   Version=24.1.0   CurrUnits="KN, m, C"
TABLE:  "JOINT COORDINATES"
   Joint=1   CoordSys=GLOBAL   CoordType=Cartesian   XorR=0   Y=0   Z=0
   Joint=2   CoordSys=GLOBAL   CoordType=Cartesian   XorR=0   Y=0   Z=3
TABLE:  "JOINT RESTRAINT ASSIGNMENTS"
   Joint=1   U1=Yes   U2=Yes   U3=Yes   R1=Yes   R2=Yes   R3=Yes
TABLE:  "MATERIAL PROPERTIES 02 - BASIC MECHANICAL PROPERTIES"
   Material=S   UnitWeight=77   UnitMass=7.85   E1=2E8   G12=8E7   U12=0.25
TABLE:  "FRAME SECTION PROPERTIES 01 - GENERAL"
   %s
TABLE:  "CONNECTIVITY - FRAME"
   Frame=1   JointI=1   JointJ=2   IsCurved=No
TABLE:  "FRAME SECTION ASSIGNMENTS"
   Frame=1   AnalSect=%s   MatProp=Default
%sTABLE:  "LOAD PATTERN DEFINITIONS"
   LoadPat=W   DesignType=WIND   SelfWtMult=0
TABLE:  "JOINT LOADS - FORCE"
   Joint=2   LoadPat=W   CoordSys=GLOBAL   F1=10
END TABLE DATA
]]):format(section, section:match "SectionName=(%S+)", more or "")
end

local plain = "SectionName=P   Material=S   Shape=%s   %sArea=0.01   TorsConst=1E-06   I33=1E-04   I22=2E-05   "
  .. "AS2=0.004   AS3=0.005"

local function read(text) return import.s2k { file = write("frame.s2k", text) } end

local function sway(frame)
  local model, nodes = import.build(frame, { model = { displacement = "small" } })
  return (nodes["2"]:displacement(model:static { steps = 1, loads = { W = 1 } }:finish()))
end

local function by_hand(E, G, I, shear_area) return 10e3 * (27 / (3 * E * I) + 3 / (G * shear_area)) end

case("a value in quotes goes on over several lines", function()
  local section = plain:format("General", "") .. '   Notes="widths=[25,30]\nheights=[85,90]\n\nTABLE of them"'
  local project = 'TABLE:  "PROJECT INFORMATION"\n   Item="Notes"   Data="first line\n   second, as if a field=1"\n'
  local frame, notes = read(column(section, project))
  equal(#notes, 0, tostring(notes))
  near(sway(frame), by_hand(2e11, 8e10, 1e-4, 0.004), 1e-9, "sway")
  equal(notes.skipped[2].line, 19, "the place of the note behind the lines: " .. tostring(notes))
end)

case("quotes that are not closed end at the next table, with their own line", function()
  local good, problem = pcall(read, (column(plain:format("General", "")):gsub('"KN, m, C"', '"KN, m, C')))
  expect(not good and problem:find("frame.s2k:2: field CurrUnits: the quotes are not closed", 1, true), "%s", problem)
end)

case("a section without dimensions has the properties of the file", function()
  for _, shape in ipairs { '"I/Wide Flange"', "Box/Tube", "Pipe", "Rectangular", "Circle" } do
    local frame, notes = read(column(plain:format(shape, "")))
    equal(#notes, 0, tostring(notes))
    expect(#notes.assumed == 1 and notes.assumed[1].reason:find "the section of shape .- has no t3", "%s: %s", shape,
      tostring(notes))
    near(sway(frame), by_hand(2e11, 8e10, 1e-4, 0.004), 1e-9, shape)
    equal(frame.sections[1].outline, nil, shape .. ": outline")
  end
  local _, notes = read(column '   SectionName=P   Material=S   Shape=Pipe   tw=0.005')
  expect(#notes > 0 and notes[2].reason:find("Area, I33, I22 and TorsConst above 0", 1, true), "%s", tostring(notes))
end)

case("a section of a known name without dimensions has the outline and the plastic moduli of that name", function()
  local given = 'SectionName=HEB300   Material=S   Shape="I/Wide Flange"   Area=%s   TorsConst=1.85E-06   '
    .. "I33=2.517E-04   I22=8.563E-05   AS2=0.0033   AS3=0.0095"
  local frame, notes = read(column(given:format "0.01491"))
  local section, known = frame.sections[1], hinge.section.named "HEB 300"
  equal(section.area, 0.01491, "the area of the file")
  near(section.plastic.Zx, known.Zx, 1e-12, "Zx")
  expect(section.outline, "no outline")
  expect(notes.assumed[1].reason:find "HEB 300 in hinge.section.named", "%s", tostring(notes))
  -- another section of this name: the file is right
  frame = read(column(given:format "0.018"))
  equal(frame.sections[1].outline, nil, "outline")
  equal(frame.sections[1].plastic.Zx, nil, "Zx")
end)

-- A cantilever of 3 m, its section from P1 at the foot to P2 at the head; segments: rows of the table.
local function tapered(segments, more)
  local rows = {}
  for i, s in ipairs(segments) do
    rows[i] = ("   SectionName=P   NumSegments=%d   SegmentNum=%d   %s\n"):format(#segments, i, s)
  end
  return read((column("SectionName=P   Material=S   Shape=Nonprismatic", ([[
TABLE:  "FRAME SECTION PROPERTIES 01 - GENERAL"
   SectionName=P1   Material=S   Shape=General   Area=0.02   TorsConst=2E-06   I33=8E-04   I22=4E-05   AS2=0   AS3=0
   SectionName=P2   Material=S   Shape=General   Area=0.01   TorsConst=1E-06   I33=1E-04   I22=2E-05   AS2=0   AS3=0
TABLE:  "FRAME SECTION PROPERTIES 05 - NONPRISMATIC"
%s%s]]):format(table.concat(rows), more or ""))))
end

case("a member whose section varies is pieces of equal properties", function()
  local E, F, L = 2e11, 10e3, 3
  -- the integral of F x^2 / (E I), x from the head, by Simpson's rule
  local function exact(I)
    local n, sum = 2000, 0
    for k = 0, n do
      local x = L * k / n
      sum = sum + (k % n == 0 and 1 or k % 2 == 1 and 4 or 2) * x ^ 2 / I(x / L)
    end
    return F * sum * L / n / 3 / E
  end
  for law, power in pairs { Linear = 1, Parabolic = 2, Cubic = 3 } do
    local frame, notes = tapered { ("StartSect=P1   EndSect=P2   LengthType=Variable   VarLength=1   EI33Var=%s   "
      .. "EI22Var=Linear"):format(law) }
    equal(#notes, 0, tostring(notes))
    equal(#frame.members, 12, "pieces")
    local wanted = exact(function(t) return (1e-4 ^ (1 / power) * (1 - t) + 8e-4 ^ (1 / power) * t) ^ power end)
    near(sway(frame), wanted, 3e-3 * wanted, law)
    near(notes.summary.mass_of_members, 7850 * 3 * 0.015, 1e-6, "mass")
    expect(tostring(notes):find("12 pieces of equal properties", 1, true), "%s", tostring(notes))
  end
  -- a haunch of 1 m of P1, then P2
  local frame = tapered { "StartSect=P1   EndSect=P1   LengthType=Absolute   AbsLength=1",
    "StartSect=P2   EndSect=P2   LengthType=Variable   VarLength=1" }
  equal(#frame.members, 2, "two pieces")
  near(sway(frame), F / (3 * E) * (8 / 1e-4 + (27 - 8) / 8e-4), 1e-6, "haunch")
  local _, notes = tapered { "StartSect=P1   EndSect=P9   LengthType=Variable   VarLength=1" }
  expect(tostring(notes):find("section P9 of its section was not read", 1, true), "%s", tostring(notes))
  _, notes = tapered { "StartSect=P1   EndSect=P1   LengthType=Absolute   AbsLength=4" }
  expect(tostring(notes):find("longer than the frame", 1, true), "%s", tostring(notes))
end)

case("loads on a member of several pieces are whole", function()
  local frame = tapered({ "StartSect=P1   EndSect=P2   LengthType=Variable   VarLength=1" },
    'TABLE:  "FRAME LOADS - DISTRIBUTED"\n   Frame=1   LoadPat=W   CoordSys=GLOBAL   Type=Force   Dir=X   RelDistA=0   '
    .. "RelDistB=1   FOverLA=2   FOverLB=2\n")
  local model, nodes = import.build(frame, { model = { displacement = "small" } })
  local fx = nodes["1"]:reaction(model:static { steps = 1, loads = { W = 1 } }:finish())
  near(fx, -16e3, 1e-3, "reaction")
end)

-- ETABS ---------------------------------------------------------------------------------------------------------------

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
  local frame, notes = import.e2k { file = write("frame.e2k", storey) }
  equal(#notes, 1, tostring(notes))
  equal(notes[1].reason, "not read of it: COLOURED", "reason")
  equal(notes[1].count, 2, "count")
  equal(table.concat(notes[1].lines, " "), "25 26", "lines")
  equal(frame.members[3].release.a .. " " .. frame.members[3].release.b, "rx,ry rx,ry", "PINNED")
end)

-- Constraints, springs, floors ----------------------------------------------------------------------------------------

-- Two posts of 3 m with their heads at joints 2 and 4; joint 5 has no member.
local function posts(more)
  return import.s2k { file = write("frame.s2k", ([[
TABLE:  "PROGRAM CONTROL"
   ProgramName=SAP2000   Version=24.1.0   CurrUnits="KN, m, C"
TABLE:  "JOINT COORDINATES"
   Joint=1   XorR=0   Y=0   Z=0
   Joint=2   XorR=0   Y=0   Z=3
   Joint=3   XorR=5   Y=0   Z=0
   Joint=4   XorR=5   Y=0   Z=3
   Joint=5   XorR=5   Y=4   Z=3
TABLE:  "JOINT RESTRAINT ASSIGNMENTS"
   Joint=1   U1=Yes   U2=Yes   U3=Yes   R1=Yes   R2=Yes   R3=Yes
   Joint=3   U1=Yes   U2=Yes   U3=Yes   R1=Yes   R2=Yes   R3=Yes
TABLE:  "MATERIAL PROPERTIES 02 - BASIC MECHANICAL PROPERTIES"
   Material=S   UnitWeight=77   UnitMass=7.85   E1=2E8   G12=8E7
TABLE:  "FRAME SECTION PROPERTIES 01 - GENERAL"
   SectionName=P   Material=S   Shape=General   Area=0.01   TorsConst=1E-06   I33=1E-04   I22=2E-05   AS2=0.004 _
        AS3=0.005
   SectionName=list   Material=S   Shape="Auto Select"
TABLE:  "CONNECTIVITY - FRAME"
   Frame=1   JointI=1   JointJ=2
   Frame=2   JointI=3   JointJ=4
TABLE:  "FRAME SECTION ASSIGNMENTS"
   Frame=1   AnalSect=P
   Frame=2   AnalSect=P
TABLE:  "LOAD PATTERN DEFINITIONS"
   LoadPat=W   SelfWtMult=0
TABLE:  "JOINT LOADS - FORCE"
   Joint=2   LoadPat=W   CoordSys=GLOBAL   F1=10
%s]]):format(more or "")) }
end

local function moved(frame, ...)
  local model, nodes = import.build(frame, { model = { displacement = "small" } })
  local run = model:static { steps = 1, loads = { W = 1 } }:finish()
  local list = {}
  for i, name in ipairs { ... } do list[i] = (nodes[name]:displacement(run)) end
  return table.unpack(list)
end

case("diaphragms and bodies tie the heads of two posts, equal displacements are held with one of them", function()
  local alone = by_hand(2e11, 8e10, 1e-4, 0.004)
  near(moved(posts(), "2"), alone, 1e-9, "one post")
  local constraint = 'TABLE:  "CONSTRAINT DEFINITIONS - %s"\n   Name=C1   CoordSys=GLOBAL   %s\n'
    .. 'TABLE:  "JOINT CONSTRAINT ASSIGNMENTS"\n   Joint=2   Constraint=C1   Type=X\n   Joint=4   Constraint=C1\n'
    .. "   Joint=5   Constraint=C1\n"
  for _, axis in ipairs { "Axis=Z   MultiLevel=No", "Axis=Auto", "Axis=Z   MultiLevel=Yes" } do
    local frame, notes = posts(constraint:format("DIAPHRAGM", axis))
    equal(#notes, 1, tostring(notes)) -- joint 5, which has no member
    local a, b = moved(frame, "2", "4")
    near(a, alone / 2, 1e-9, "the head with the load: " .. axis)
    near(b, a, 1e-12, "the other head")
  end
  -- with a rigid end at joint 2, and with a beam whose end is released there, the diaphragm ties it as without
  local _, told = posts(constraint:format("DIAPHRAGM", "Axis=Z") .. 'TABLE:  "FRAME OFFSET ALONG LENGTH ASSIGNMENTS"\n'
    .. "   Frame=1   Type=User   LengthI=0   LengthJ=0.2   RigidFactor=1\n")
  expect(tostring(told):find("1 joints at which all members end beside the joint", 1, true), "%s", tostring(told))
  local pinned = posts(constraint:format("DIAPHRAGM", "Axis=Z") .. [[
TABLE:  "CONNECTIVITY - FRAME"
   Frame=3   JointI=2   JointJ=4
TABLE:  "FRAME SECTION ASSIGNMENTS"
   Frame=3   AnalSect=P
TABLE:  "FRAME RELEASE ASSIGNMENTS 1 - GENERAL"
   Frame=3   M3I=Yes
]])
  local c, d = moved(pinned, "2", "4")
  near(c, alone / 2, 2e-3, "the head with the load, with a beam") -- whose far end is not released
  near(d, c, 1e-12, "the other head, with a beam")
  -- a support holds the diaphragm in its plane; a plane frame, whose joints are all held out of it, keeps its diaphragm
  local held, words = posts(constraint:format("DIAPHRAGM", "Axis=Z") .. "   Joint=3   Constraint=C1\n")
  equal(#held.diaphragms, 0, "no diaphragm")
  near(moved(held, "2"), 0, 1e-12, "all are held")
  expect(tostring(words):find("a support holds the diaphragm in its plane", 1, true), "%s", tostring(words))
  local plane = posts(constraint:format("DIAPHRAGM", "Axis=Z")
    .. 'TABLE:  "ACTIVE DEGREES OF FREEDOM"\n   UX=Yes   UY=No   UZ=Yes   RX=No   RY=Yes   RZ=No\n')
  equal(#plane.diaphragms, 1, "a plane frame")
  local body = posts(constraint:format("BODY", "UX=Yes   UY=Yes   UZ=Yes   RX=Yes   RY=Yes   RZ=Yes"))
  equal(body.links[1].from .. " " .. body.links[1].to .. " " .. body.links[1].dofs, "2 4 all", "a body")
  local equals = posts(constraint:format("EQUAL", "UX=Yes   UY=No   UZ=No   RX=No   RY=No   RZ=No")
    .. "   Joint=3   Constraint=C1\n")
  near(moved(equals, "2"), 0, 1e-12, "held with joint 3")
  equal(equals.nodes[2].fix, "x", "fix")
  local _, notes = posts(constraint:format("EQUAL", "UX=Yes"))
  expect(notes[2].reason:find "no support holds", "%s", tostring(notes))
end)

case("where all ends at a joint are released one of them holds its rotation", function()
  local tables = [[
TABLE:  "CONNECTIVITY - FRAME"
   Frame=3   JointI=2   JointJ=4
TABLE:  "FRAME SECTION ASSIGNMENTS"
   Frame=3   AnalSect=P
TABLE:  "FRAME RELEASE ASSIGNMENTS 1 - GENERAL"
   Frame=1   TJ=Yes   M2J=Yes   M3J=Yes
   Frame=2   TJ=Yes   M2J=Yes   M3J=Yes
   Frame=3   M2I=Yes   M3I=Yes   M2J=Yes   M3J=Yes
]]
  local frame, notes = posts(tables)
  expect(tostring(notes):find("at 2 joints all ends are released", 1, true), "%s", tostring(notes))
  -- two cantilevers side by side, but for the bar's axial strain
  local alone, bar = by_hand(2e11, 8e10, 1e-4, 0.004), 2e11 * 0.01 / 5
  local post = 10e3 / alone
  near(moved(frame, "2"), 10e3 * (post + bar) / (post * (post + 2 * bar)), 1e-7, "sway")
end)

case("springs to the ground, by their own stiffness", function()
  local spring = 'TABLE:  "JOINT SPRING ASSIGNMENTS 1 - UNCOUPLED"\n   Joint=2   U1=500   U2=0   R1=0\n'
  local frame, notes = posts(spring)
  equal(#notes, 1, tostring(notes))
  local alone = by_hand(2e11, 8e10, 1e-4, 0.004)
  near(moved(frame, "2"), 10e3 / (10e3 / alone + 500e3), 1e-9, "post and spring side by side")
  -- a foot on a spring against rotation: 10 kN times 3 m over 2000 kN m/rad, times 3 m more
  local turning = posts('TABLE:  "JOINT SPRING ASSIGNMENTS 1 - UNCOUPLED"\n   Joint=1   R2=2000\n'
    .. 'TABLE:  "JOINT RESTRAINT ASSIGNMENTS"\n   Joint=1   U1=Yes   U2=Yes   U3=Yes   R1=Yes   R3=Yes\n')
  near(moved(turning, "2"), alone + 10e3 * 9 / 2000e3, 1e-9, "a foot that turns")
end)

case("an end with partial fixity has its spring", function()
  local frame, notes = posts('TABLE:  "FRAME RELEASE ASSIGNMENTS 1 - GENERAL"\n   Frame=1   M3I=Yes   PartialFix=Yes\n'
    .. 'TABLE:  "FRAME RELEASE ASSIGNMENTS 2 - PARTIAL FIXITY"\n   Frame=1   M3I=2000\n')
  equal(#notes, 1, tostring(notes)) -- joint 5
  equal(frame.members[1].ends.a.Mx.stiffness, 2e6, "N m/rad")
  equal(frame.members[1].release, nil, "release")
  local alone = by_hand(2e11, 8e10, 1e-4, 0.004)
  near(moved(frame, "2"), alone + 10e3 * 9 / 2000e3, 1e-8, "sway")
end)

case("areas are one note with their size, loads and weight; a section without a member is none", function()
  local _, notes = posts [[
TABLE:  "CONNECTIVITY - AREA"
   Area=1   NumJoints=3   Joint1=2   Joint2=4   Joint3=5
   Area=2   NumJoints=4   Joint1=1   Joint2=3   Joint3=4   Joint4=2
TABLE:  "AREA SECTION PROPERTIES"
   Section=slab   Material=S   AreaType=Shell   Type=Membrane   Thickness=0.1   Color=Green
TABLE:  "AREA SECTION ASSIGNMENTS"
   Area=1   Section=slab   MatProp=Default
TABLE:  "AREA LOADS - UNIFORM TO FRAME"
   Area=1   LoadPat=DEAD   CoordSys=GLOBAL   Dir=Gravity   UnifLoad=2   DistType="Two way"
   Area=1   LoadPat=LIVE   CoordSys=GLOBAL   Dir=Gravity   UnifLoad=3   DistType="Two way"
   Area=2   LoadPat=DEAD   CoordSys=GLOBAL   Dir=Gravity   UnifLoad=1   DistType="Two way"
]]
  equal(#notes, 2, tostring(notes))
  equal(notes[2].reason, "2 areas of 25 m^2 in all (floors and walls) are not read; with them go the loads DEAD 35 kN, "
    .. "LIVE 30 kN, their own weight 77 kN", "the note")
end)

case("ETABS: diaphragms of points and of floors, springs, and floors", function()
  local frame, notes = import.e2k { file = write("frame.e2k", (storey:gsub('COLOURED "Yes"', "")
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
]]) }
  equal(#notes, 1, tostring(notes))
  equal(notes[1].reason, "1 area of 12 m^2 in all (floors and walls) is not read; with it go the loads DEAD 3000 kN, "
    .. "their own weight 92.4 kN", "the note")
  equal(#frame.diaphragms, 1, "diaphragms")
  equal(table.concat(frame.diaphragms[1].nodes, " "), "1@Top 2@Top", "its joints")
  equal(frame.connectors[1].a .. " " .. frame.connectors[1].stiffness.x, "2@Top 211000000.0", "spring")
end)

case("ETABS: channels, tees and pairs of angles by their dimensions", function()
  for shape, wanted in pairs { -- plates: area, Ix, Iy, by hand
    ["Steel Channel\"  D 0.2 B 0.08 TF 0.01 TW 0.008"] = { 0.00304, 1.834e-05, 1.843e-06 },
    ["Steel Tee\"  D 0.2 B 0.16 TF 0.01 TW 0.008"] = { 0.00312, 1.238e-05, 3.421e-06 },
    ["Steel Double Angle\"  D 0.1 B 0.21 TF 0.01 TW 0.01 DIS 0.01"] = { 0.0038, 3.6e-06, 7.912e-06 },
  } do
    local frame, notes = import.e2k { file = write("frame.e2k", (storey:gsub(
      'Concrete Rectangular"  D 0.4 B 0.3 NOTIONALUSERVALUE 0.2', shape))) }
    equal(#notes, 1, tostring(notes))
    local s = frame.sections[1]
    for i, field in ipairs { "area", "Ix", "Iy" } do
      near(s[field], wanted[i], 2e-3 * wanted[i], shape .. ": " .. field)
    end
  end
end)

-- Sections by name ----------------------------------------------------------------------------------------------------

case("an unknown section has its own reason and near names, and the option gives another", function()
  local function catalogue(name) return (storey:gsub('SHAPE "Concrete Rectangular"  D 0.4 B 0.3 NOTIONALUSERVALUE 0.2',
    'SHAPE "' .. name .. '"')) end
  local function etabs(name, sections)
    return import.e2k { file = write("frame.e2k", catalogue(name)), sections = sections }
  end
  local frame = etabs "W360X79"
  equal(frame.sections[1].named, "W360X79", "a metric name")
  local _, notes = etabs "W14X999"
  expect(tostring(notes):find("no table of hinge has 'W14X999'; the nearest are 'W14X873'", 1, true), "%s",
    tostring(notes))
  for _, key in ipairs { "C", "W14X999" } do
    frame, notes = etabs("W14X999", { [key] = "W14X873" })
    equal(frame.sections[1].named, "W14X873", "by " .. key)
    equal(#frame.members, 3, "members")
    expect(tostring(notes):find("it is W14X873, as the option sections says", 1, true), "%s", tostring(notes))
  end
  local good, problem = pcall(etabs, "W14X999", { D = "W14X873" })
  expect(not good and problem:find "unknown section of the file in 'sections': 'D'", "%s", tostring(problem))
  good, problem = pcall(etabs, "W14X999", { C = "W14X998" })
  expect(not good and problem:find "unknown section 'W14X998'", "%s", tostring(problem))
  frame, notes = read(column "SectionName=HE300B   Material=S   Shape=General")
  equal(frame.sections[1].named, "HEB 300", "SAP2000: a known name without properties")
  expect(tostring(notes):find("the section has no properties: it is HEB 300", 1, true), "%s", tostring(notes))
end)

checks.done()
