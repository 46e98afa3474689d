-- hinge.import.s2k: text tables of SAP2000, against closed forms. Units, local axes, loads, shapes, self weight,
-- division of members; values over several lines, sections without dimensions, members whose section varies. What is
-- not read is in the notes with its line; broken files are refused with the line.
--
-- Run: lua5.4 tests/script/import/import_s2k_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local files = require "import.files"
local hinge = require "hinge"
local import = require "hinge.import"
local checks = support.checks "files of SAP2000"
local case, near, equal, expect, refused = checks.case, checks.near, checks.equal, checks.expect, checks.refused

local write, folder = support.writer()
local E, G = 210e9, 210e9 / 2.6
local small = { model = { displacement = "small" } }
local sap, head, push, at_line = files.sap, files.sap_head, files.push, files.at_line

local function s2k(text) return import.s2k { file = write("frame.s2k", text) } end

-- Displacement of joint 2 under the case DEAD.
local function tip(frame)
  local model, nodes = import.build(frame, small)
  return nodes["2"]:displacement(model:static { steps = 1, loads = { DEAD = 1 } }:finish())
end

case("local axes: axis 2 of a column is along X, and the angle turns it towards axis 3", function()
  -- F = 1 kN on a cantilever of 3 m: u = F L^3 / (3 E I) + F L / (G A_s) in each principal direction; a shear area of 0
  -- has become 1000 times the area. 1e-7: rounding with shear that is so stiff
  local shear = 1e3 * 3 / (G * 1000 * 0.01)
  local u33, u22 = 1e3 * 27 / (3 * E * 2e-4) + shear, 1e3 * 27 / (3 * E * 5e-5) + shear
  for _, angle in ipairs { 0, 30, 90, -45 } do
    for _, name in ipairs { "FRAME LOCAL AXES 1 - TYPICAL", "FRAME LOCAL AXES ASSIGNMENTS 1 - TYPICAL" } do
      local more = push(1) .. ('TABLE:  "%s"\n   Frame=1   Angle=%g   AdvanceAxes=No\n'):format(name, angle)
      local x, y = tip((s2k(sap { more = more })))
      local c, s = math.cos(math.rad(angle)), math.sin(math.rad(angle))
      near(x, u33 * c * c + u22 * s * s, 1e-7 * u22, angle .. " degrees: along x, m")
      near(y, (u33 - u22) * c * s, 1e-7 * u22, angle .. " degrees: along y, m")
    end
  end
  -- along Y axis 2 is Z, so that axis 3 = Y x Z is X; turned by 90 degrees axis 2 is X
  local along_y = 'TABLE:  "FRAME LOCAL AXES 1 - TYPICAL"\n   Frame=1   Angle=90\n'
  local x = tip((s2k(sap { at = "XorR=0 Y=3 Z=0", more = push(1) .. along_y })))
  near(x, u33, 1e-7 * u33, "a beam along Y, turned by 90 degrees")
  local _, notes = s2k(sap { more = along_y:gsub("Angle=90", "Angle=0   AdvanceAxes=Yes") })
  expect(at_line(notes, head + 2), "advanced axes are noted: %s", tostring(notes))
end)

case("loads along the frame's axes 1, 2, 3, by gravity and on the projection", function()
  local function total(dir, system, at, angle)
    local frame = s2k(sap { at = at, more = ('TABLE:  "FRAME LOADS - DISTRIBUTED"\n   Frame=1   LoadPat=DEAD   '
      .. "CoordSys=%s   Type=Force   Dir=%s   DistType=RelDist   RelDistA=0   RelDistB=1   FOverLA=2   FOverLB=2\n"
      .. 'TABLE:  "FRAME LOCAL AXES 1 - TYPICAL"\n   Frame=1   Angle=%g\n'):format(system, dir, angle) })
    local model, nodes = import.build(frame, small)
    return { nodes["1"]:reaction(model:static { steps = 1, loads = { DEAD = 1 } }:finish()) }
  end
  -- 5 m of 2 kN/m; axis 1 is (0.6, 0, 0.8), axis 2 (-0.8, 0, 0.6), axis 3 = 1 x 2 = (0, -1, 0)
  local leaning, along_y = "XorR=3   Y=0   Z=4", "XorR=0   Y=5   Z=0"
  for _, row in ipairs {
    { "Gravity", "GLOBAL", leaning, 0, 0, 0, -10e3 }, { "X", "GLOBAL", leaning, 0, 10e3, 0, 0 },
    { "Z", "GLOBAL", leaning, 0, 0, 0, 10e3 }, { '"Grav Proj"', "GLOBAL", leaning, 0, 0, 0, -6e3 },
    { '"X Proj"', "GLOBAL", leaning, 0, 8e3, 0, 0 }, { "1", "Local", leaning, 0, 6e3, 0, 8e3 },
    { "2", "Local", leaning, 0, -8e3, 0, 6e3 }, { "3", "Local", leaning, 0, 0, -10e3, 0 },
    { "2", "Local", leaning, 90, 0, -10e3, 0 }, { "3", "Local", leaning, 90, 8e3, 0, -6e3 },
    -- along Y: axis 2 is Z, axis 3 = Y x Z = X; turned by 90 degrees they are X and -Z
    { "3", "Local", along_y, 0, 10e3, 0, 0 }, { "2", "Local", along_y, 90, 10e3, 0, 0 },
    { "3", "Local", along_y, 90, 0, 0, -10e3 },
  } do
    local r = total(row[1], row[2], row[3], row[4])
    for i = 1, 3 do
      near(r[i], -row[4 + i], 1e-3, ("direction %s, %g degrees, reaction %d, N"):format(row[1], row[4], i))
    end
  end
end)

case("shapes: what the file states counts; what it leaves out is that of the shape", function()
  local d = { width = 0.2, depth = 0.4, web = 0.008, flange = 0.012 }
  local shapes = {
    { '"I/Wide Flange"   t3=0.4   t2=0.2   tf=0.012   tw=0.008   t2b=0.2   tfb=0.012', hinge.section.h(d) },
    { '"Box/Tube"   t3=0.4   t2=0.2   tf=0.012   tw=0.008', hinge.section.box(d) },
    { "Pipe   t3=0.4   tw=0.01", hinge.section.pipe { diameter = 0.4, thickness = 0.01 } },
    { "Rectangular   t3=0.4   t2=0.2", hinge.section.solid { width = 0.2, depth = 0.4 } },
    { "Circle   t3=0.4", hinge.section.round { diameter = 0.4 } },
  }
  for _, row in ipairs(shapes) do
    local frame, notes = s2k(sap { section = "Shape=" .. row[1] })
    equal(#notes, 0, tostring(notes))
    local _, _, members = import.build(frame)
    for _, key in ipairs { "area", "Ix", "Iy", "J", "shear_area_x", "shear_area_y", "Zx", "Zy", "width", "depth" } do
      near(members["1"].section[key], row[2][key], 1e-12, row[1] .. ": " .. key)
    end
    local stated = s2k(sap { section = "Shape=" .. row[1] .. ("   Area=%.17g   TorsConst=3e-6   I33=4e-4   I22=5e-5   "
      .. "AS2=0.001   AS3=0.002   Z33=6e-4   I3Mod=0.5   AMod=0.99"):format(row[2].area) })
    local _, _, its = import.build(stated)
    local s = its["1"].section
    near(s.area, 0.99 * row[2].area, 1e-15, row[1] .. ": AMod")
    near(s.Ix, 2e-4, 1e-15, row[1] .. ": I33 times I3Mod")
    equal(("%g %g %g %g %g"):format(s.Iy, s.J, s.shear_area_y, s.shear_area_x, s.Zx), "5e-05 3e-06 0.001 0.002 0.0006",
      row[1])
    near(s.Zy, row[2].Zy, 1e-12, row[1] .. ": Zy of the shape")
  end
  local frame = s2k(sap { more = 'TABLE:  "MATERIAL PROPERTIES 03A - STEEL DATA"\n   Material=S   Fy=355000\n' })
  near(frame.materials[1].yield_stress, 355e6, 1, "Fy, Pa")
  near(frame.materials[1].density, 7850, 1e-9, "UnitMass, kg/m^3")
  near(frame.materials[1].E / 2.6, import.build(frame):members()[1].material.G, 1, "G by U12, Pa")
end)

case("units: one inch and one kip; kgf and Tonf", function()
  local units = hinge.units
  for text, size in pairs { ["Kip, in, F"] = { units.kip, units.inch }, ["lb, ft, F"] = { units.lbf, units.ft },
    ["Kgf, cm, C"] = { 9.80665, 0.01 }, ["Tonf, m, C"] = { 9806.65, 1 }, ["N, mm, C"] = { 1, 1e-3 } } do
    local frame = s2k(sap { units = text, more = push(1) })
    near(frame.nodes[2].z, 3 * size[2], 1e-15, text .. ": length")
    near(frame.cases[1].loads[1].force[1], size[1], 1e-12 * size[1], text .. ": force")
    near(frame.materials[1].E, 210e6 * size[1] / size[2] ^ 2, 1e-3, text .. ": stress")
    near(frame.materials[1].density, 7.85 * size[1] / size[2] ^ 4, 1e-12 * size[1] / size[2] ^ 4, text .. ": density")
  end
end)

case("groups, degrees of freedom that are not active, rows that go on, values in quotes", function()
  local frame, notes = s2k(sap { more = push(1) .. [[
TABLE:  "GROUPS 2 - ASSIGNMENTS"
   GroupName=ALL   ObjectType=Frame   ObjectLabel=1
   GroupName="left side"   ObjectType=Frame   ObjectLabel=1
   GroupName=braces   ObjectType=Frame _
      ObjectLabel=1
   GroupName=braces   ObjectType=Joint   ObjectLabel=1
TABLE:  "ACTIVE DEGREES OF FREEDOM"
   UX=Yes   UY=No   UZ=Yes   RX=No   RY=Yes   RZ=No
END TABLE DATA
   this is no part of the file
]] })
  equal(table.concat(frame.members[1].group, "; "), "left side; braces", "the groups")
  equal(frame.nodes[1].fix, "all", "the foot")
  equal(frame.nodes[2].fix, "y,rx,rz", "the head")
  equal(#notes, 0, tostring(notes))
  expect(at_line(notes.assumed, head + 10), "that is said: %s", tostring(notes))
  local _, of_etabs = s2k(sap { program = "ETABS" })
  expect(at_line(of_etabs.assumed, 2), "the axes of ETABS are named: %s", tostring(of_etabs))
end)

case("a frame with other joints on it is divided there, unless the file says no", function()
  -- a beam of 6 m between two fixed supports; at 2 m and 4 m hang columns of 1 m with 10 kN each
  local function girder(more)
    return s2k(sap { at = "XorR=6   Y=0   Z=0", more = [[
TABLE:  "JOINT COORDINATES"
   Joint=5   CoordSys=GLOBAL   CoordType=Cartesian   XorR=4   Y=0   Z=0.0001
   Joint=3   CoordSys=GLOBAL   CoordType=Cartesian   XorR=2   Y=0   Z=0
   Joint=4   CoordSys=GLOBAL   CoordType=Cartesian   XorR=2   Y=0   Z=-1
   Joint=6   CoordSys=GLOBAL   CoordType=Cartesian   XorR=4   Y=0   Z=-1
TABLE:  "CONNECTIVITY - FRAME"
   Frame=left   JointI=3   JointJ=4
   Frame=right   JointI=5   JointJ=6
TABLE:  "FRAME SECTION ASSIGNMENTS"
   Frame=left   AnalSect=A
   Frame=right   AnalSect=A
TABLE:  "JOINT RESTRAINT ASSIGNMENTS"
   Joint=2   U1=Yes   U2=Yes   U3=Yes   R1=Yes   R2=Yes   R3=Yes
TABLE:  "FRAME RELEASE ASSIGNMENTS 1 - GENERAL"
   Frame=1   M3J=Yes
TABLE:  "JOINT LOADS - FORCE"
   Joint=4   LoadPat=DEAD   CoordSys=GLOBAL   F3=-10
   Joint=6   LoadPat=DEAD   CoordSys=GLOBAL   F3=-10
TABLE:  "FRAME LOADS - DISTRIBUTED"
   Frame=1   LoadPat=DEAD   CoordSys=GLOBAL   Type=Force   Dir=Gravity   FOverLA=1   FOverLB=1
]] .. (more or "") })
  end
  local frame, notes = girder()
  equal(#notes, 0, tostring(notes))
  expect(at_line(notes.assumed, 7).reason:find("joints on it (3, 5)", 1, true), "it is said: %s", tostring(notes))
  local parts = {}
  for i, m in ipairs(frame.members) do parts[i] = m.name .. ":" .. m.a .. "-" .. m.b end
  equal(table.concat(parts, " "), "1/1:1-3 1/2:3-5 1/3:5-2 left:3-4 right:5-6", "the parts")
  expect(not frame.members[1].release and frame.members[3].release.b == "rx", "the release is at the last part's end")
  local model, nodes = import.build(frame, small)
  local run = model:static { steps = 1, loads = { DEAD = 1 } }:finish()
  -- clamped and pinned, by the force method: P a (3 L^2 - a^2) / (2 L^3) of each load at a from the pinned end, and
  -- 5/8 w L, at the clamped end. 1e-3: joint 5 is 0.1 mm off the axis
  local L, P, wanted = 6, 10e3, 5 / 8 * 1e3 * 6
  for _, a in ipairs { 4, 2 } do wanted = wanted + P * a * (3 * L ^ 2 - a ^ 2) / (2 * L ^ 3) end
  near(select(3, nodes["1"]:reaction(run)), wanted, 1e-3 * wanted, "the reaction of the clamped end, N")
  local whole, of_whole = girder 'TABLE:  "FRAME AUTO MESH ASSIGNMENTS"\n   Frame=1   AutoMesh=No\n'
  equal(#whole.members, 3, "AutoMesh=No: " .. tostring(of_whole))
  local _, of_crossing = girder 'TABLE:  "FRAME AUTO MESH ASSIGNMENTS"\n   Frame=1   AutoMesh=Yes   AtFrames=Yes\n'
  expect(#of_crossing == 1 and of_crossing[1].reason:find "AtFrames", "%s", tostring(of_crossing))
end)

case("self weight: by gravity or by loads, and the choice where they differ", function()
  local frame = s2k(sap { at = "XorR=3   Y=0   Z=4", weight = "1.5" })
  local weight = 1.5 * 7850 * 9.80665 * 0.01 * 5
  local function reaction(options)
    local model, nodes = import.build(frame, options)
    return select(3, nodes["1"]:reaction(model:static { steps = 1, loads = { DEAD = 1 } }:finish()))
  end
  near(reaction(small), weight, 1e-6 * weight, "by gravity, N")
  near(reaction { model = small.model, self_weight = "loads" }, weight, 1e-6 * weight, "by loads, N")
  frame.masses[1] = { node = "2", mass = 100 }
  refused({ "self_weight = 'gravity'", "or 'loads'" }, import.build, frame, small)
  near(reaction { model = small.model, self_weight = "loads" }, weight, 1e-6 * weight, "of members alone, N")
  near(reaction { model = small.model, self_weight = "gravity" }, weight + 1.5 * 100 * 9.80665, 1e-6 * weight,
    "with the point mass, N")
  frame.masses = {}
  frame.materials[1].unit_weight = 80e3
  refused("80000 N/m^3", import.build, frame, small) -- a weight that is not the mass
  near(reaction { self_weight = "loads" }, 1.5 * 80e3 * 0.05, 1e-3, "the weight of the file, N")
  frame.cases[2] = { name = "more", self_weight = 1, loads = {} }
  refused("2 load cases have self weight", import.build, frame, { self_weight = "gravity" })
end)

-- Values over several lines, sections without dimensions, sections that vary ------------------------------------------

-- A column of 3 m with a force of 10 kN at its head.
local shear = "Shape=%s   %sArea=0.01   TorsConst=1E-06   I33=1E-04   I22=2E-05   AS2=0.004   AS3=0.005"
local function column(section, more, name)
  return sap { section = section, more = push(10) .. (more or ""), name = name }
end
local alone = 10e3 * (27 / (3 * E * 1e-4) + 3 / (G * 0.004)) -- its sway, m

case("a value in quotes goes on over several lines", function()
  local section = shear:format("General", "") .. '   Notes="widths=[25,30]\nheights=[85,90]\n\nTABLE of them"'
  local project = 'TABLE:  "PROJECT INFORMATION"\n   Item="Notes"   Data="first line\n   second, as if a field=1"\n'
  local frame, notes = s2k(column(section, project))
  equal(#notes, 0, tostring(notes))
  near(tip(frame), alone, 1e-9, "sway")
  equal(notes.skipped[2].line, 23, "the place of the note behind the lines: " .. tostring(notes))
end)

case("quotes that are not closed end at the next table, with their own line", function()
  refused("frame.s2k:2: field CurrUnits: the quotes are not closed", function()
    s2k((sap():gsub('"KN, m, C"', '"KN, m, C')))
  end)
end)

case("a section without dimensions has the properties of the file", function()
  for _, shape in ipairs { '"I/Wide Flange"', "Box/Tube", "Pipe", "Rectangular", "Circle" } do
    local frame, notes = s2k(column(shear:format(shape, "")))
    equal(#notes, 0, tostring(notes))
    expect(#notes.assumed == 1 and notes.assumed[1].reason:find "the section of shape .- has no t3", "%s: %s", shape,
      tostring(notes))
    near(tip(frame), alone, 1e-9, shape)
    equal(frame.sections[1].outline, nil, shape .. ": outline")
  end
  local _, notes = s2k(column "Shape=Pipe   tw=0.005")
  expect(#notes > 0 and notes[2].reason:find("Area, I33, I22 and TorsConst above 0", 1, true), "%s", tostring(notes))
end)

case("a section of a known name without dimensions has the outline and the plastic moduli of that name", function()
  local given = 'Shape="I/Wide Flange"   Area=%s   TorsConst=1.85E-06   '
    .. "I33=2.517E-04   I22=8.563E-05   AS2=0.0033   AS3=0.0095"
  local frame, notes = s2k(column(given:format "0.01491", "", "HEB300"))
  local section, known = frame.sections[1], hinge.section.named "HEB 300"
  equal(section.area, 0.01491, "the area of the file")
  near(section.plastic.Zx, known.Zx, 1e-12, "Zx")
  expect(section.outline, "no outline")
  expect(notes.assumed[1].reason:find "HEB 300 in hinge.section.named", "%s", tostring(notes))
  -- another section of this name: the file is right
  frame = s2k(column(given:format "0.018", "", "HEB300"))
  equal(frame.sections[1].outline, nil, "outline")
  equal(frame.sections[1].plastic.Zx, nil, "Zx")
  frame, notes = s2k(column("Shape=General", "", "HE300B"))
  equal(frame.sections[1].named, "HEB 300", "a known name without properties")
  expect(tostring(notes):find("the section has no properties: it is HEB 300", 1, true), "%s", tostring(notes))
end)

-- A cantilever of 3 m, its section from P1 at the foot to P2 at the head; segments: rows of the table.
local function tapered(segments, more)
  local rows = {}
  for i, s in ipairs(segments) do
    rows[i] = ("   SectionName=A   NumSegments=%d   SegmentNum=%d   %s\n"):format(#segments, i, s)
  end
  return s2k(column("Shape=Nonprismatic", ([[
TABLE:  "FRAME SECTION PROPERTIES 01 - GENERAL"
   SectionName=P1   Material=S   Shape=General   Area=0.02   TorsConst=2E-06   I33=8E-04   I22=4E-05   AS2=0   AS3=0
   SectionName=P2   Material=S   Shape=General   Area=0.01   TorsConst=1E-06   I33=1E-04   I22=2E-05   AS2=0   AS3=0
TABLE:  "FRAME SECTION PROPERTIES 05 - NONPRISMATIC"
%s%s]]):format(table.concat(rows), more or "")))
end

case("a member whose section varies is pieces of equal properties", function()
  local F, L = 10e3, 3
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
    near((tip(frame)), wanted, 3e-3 * wanted, law)
    near(notes.summary.mass_of_members, 7850 * 3 * 0.015, 1e-6, "mass")
    expect(tostring(notes):find("12 pieces of equal properties", 1, true), "%s", tostring(notes))
  end
  -- a haunch of 1 m of P1, then P2
  local frame = tapered { "StartSect=P1   EndSect=P1   LengthType=Absolute   AbsLength=1",
    "StartSect=P2   EndSect=P2   LengthType=Variable   VarLength=1" }
  equal(#frame.members, 2, "two pieces")
  near((tip(frame)), F / (3 * E) * (8 / 1e-4 + (27 - 8) / 8e-4), 1e-6, "haunch")
  local _, notes = tapered { "StartSect=P1   EndSect=P9   LengthType=Variable   VarLength=1" }
  expect(tostring(notes):find("section P9 of its section was not read", 1, true), "%s", tostring(notes))
  _, notes = tapered { "StartSect=P1   EndSect=P1   LengthType=Absolute   AbsLength=4" }
  expect(tostring(notes):find("longer than the frame", 1, true), "%s", tostring(notes))
end)

case("loads on a member of several pieces are whole", function()
  local frame = tapered({ "StartSect=P1   EndSect=P2   LengthType=Variable   VarLength=1" },
    'TABLE:  "FRAME LOADS - DISTRIBUTED"\n   Frame=1   LoadPat=DEAD   CoordSys=GLOBAL   Type=Force   Dir=X   '
    .. "RelDistA=0   RelDistB=1   FOverLA=2   FOverLB=2\n")
  local model, nodes = import.build(frame, small)
  local fx = nodes["1"]:reaction(model:static { steps = 1, loads = { DEAD = 1 } }:finish())
  near(fx, -16e3, 1e-3, "reaction")
end)

-- What is not read, and what is refused -------------------------------------------------------------------------------

case("what SAP2000 has and is not read is noted with its line", function()
  local frame, notes = s2k(sap { more = [[
TABLE:  "JOINT COORDINATES"
   Joint=3   CoordSys=GLOBAL   CoordType=Cartesian   XorR=9   Y=9   Z=9
TABLE:  "CONNECTIVITY - FRAME"
   Frame=2   JointI=1   JointJ=2   IsCurved=Yes
   Frame=3   JointI=1   JointJ=2
   Frame=4   JointI=1   JointJ=3
TABLE:  "FRAME SECTION PROPERTIES 01 - GENERAL"
   SectionName=L   Material=S   Shape=Angle   Area=1   TorsConst=1   I33=1   I22=1   I23=0.5
   SectionName=N   Material=S   Shape=Nonprismatic
TABLE:  "FRAME SECTION ASSIGNMENTS"
   Frame=2   AnalSect=A
   Frame=3   AnalSect=None
   Frame=4   AnalSect=N
TABLE:  "FRAME LOADS - DISTRIBUTED"
   Frame=1   LoadPat=DEAD   CoordSys=GLOBAL   Type=Force   Dir=Z   RelDistA=0   RelDistB=1   FOverLA=1   FOverLB=2
   Frame=1   LoadPat=DEAD   CoordSys=GLOBAL   Type=Force   Dir=Z   RelDistA=0   RelDistB=0.5   FOverLA=1   FOverLB=1
   Frame=1   LoadPat=DEAD   CoordSys=GLOBAL   Type=Moment   Dir=Z   RelDistA=0   RelDistB=1   FOverLA=1   FOverLB=1
   Frame=1   LoadPat=DEAD   CoordSys=CSYS1   Type=Force   Dir=Z   RelDistA=0   RelDistB=1   FOverLA=1   FOverLB=1
   Frame=4   LoadPat=DEAD   CoordSys=GLOBAL   Type=Force   Dir=Z   RelDistA=0   RelDistB=1   FOverLA=1   FOverLB=1
TABLE:  "JOINT LOADS - FORCE"
   Joint=2   LoadPat=DEAD   CoordSys=CSYS1   F1=1
   Joint=3   LoadPat=DEAD   CoordSys=GLOBAL   F1=1
TABLE:  "FRAME RELEASE ASSIGNMENTS 1 - GENERAL"
   Frame=1   PI=Yes   M3J=Yes   PartialFix=Yes
TABLE:  "LINK PROPERTY DEFINITIONS 01 - GENERAL"
   Link=L1   LinkType=Linear
TABLE:  "GRID LINES"
   CoordSys=GLOBAL   AxisDir=X   GridID=A   XRYZCoord= 0
TABLE:  "MATERIAL PROPERTIES 02 - BASIC MECHANICAL PROPERTIES"
   Material=S   E1=1
   Material=T   UnitMass=1
]] })
  files.notes_are(expect, "s2k", notes, head, { [2] = "no member", [4] = "curved", [9] = "above 0", [12] = "no section",
    [13] = "section N was not read, see line 26", [17] = "forces alone",
    [18] = "direction", [19] = "frame was not read", [21] = "GLOBAL alone", [22] = "no member",
    [24] = { "partial", "P, V2 and V3" }, [25] = "table is not read", [30] = "another temperature", [31] = "no E1" })
  equal(#frame.members, 1, "members")
  expect(at_line(notes.skipped, head + 27), "grid lines are no part of a frame: %s", tostring(notes))
  expect(tostring(notes):find("not read (15):", 1, true), "print shows them: %s", tostring(notes))
end)

case("broken files of SAP2000 are refused with the line", function()
  local function more(text) return sap { more = text } end
  for _, row in ipairs {
    { "hello\n", "no TABLE \"PROGRAM CONTROL\"" },
    { (sap {}:gsub('TABLE:  "JOINT COORDINATES"', 'TABLE:  "POINT BAYS"')),
      'no TABLE "JOINT COORDINATES"; it has "PROGRAM' },
    { sap { units = "Stone, m, C" }, "2: CurrUnits is 'Stone, m, C'; must be a force" },
    { sap { at = "XorR=abc   Y=0   Z=3" }, "5: TABLE \"JOINT COORDINATES\": field XorR is 'abc'; must be a number" },
    { sap { at = "XorR=1   Y=0" }, "5: TABLE \"JOINT COORDINATES\": the row has no field Z" },
    { sap { at = "XorR=1   Y=0   Z=0   rubbish" },
      "5: TABLE \"JOINT COORDINATES\": 'rubbish' is not of the form Key=Value" },
    { sap { at = "XorR=0   Y=0   Z=0" }, "7: frame 1 has no length" },
    { sap { section = 'Shape="General Area=1' }, "13: field Shape: the quotes are not closed" },
    { sap { section = 'Shape=Pipe   t3=0.1   tw=0.2' },
      "13: section of shape PIPE: hinge.section.pipe: field 'thickness'" },
    { sap { at = "XorR=1   CoordSys=CYL" }, "5: the joint is in the system CYL" },
    { more 'TABLE:  JOINT\n', "18: the name of the table is not in quotes" },
    { more 'TABLE:  "CONNECTIVITY - FRAME"\n   Frame=2   JointI=1   JointJ=7\n',
      "19: TABLE \"CONNECTIVITY - FRAME\": joint 7" },
    { more 'TABLE:  "CONNECTIVITY - FRAME"\n   Frame=1   JointI=1   JointJ=2\n', "19: frame 1 is there twice" },
    { more 'TABLE:  "CONNECTIVITY - FRAME"\n   Frame=2   JointI=1   JointJ=2\n',
      "19: frame 2 is not in TABLE \"FRAME SECTION" },
    { more 'TABLE:  "FRAME SECTION ASSIGNMENTS"\n   Frame=1   AnalSect=Z\n', "19: section Z of TABLE" },
    { more 'TABLE:  "FRAME SECTION ASSIGNMENTS"\n   Frame=8   AnalSect=A\n',
      "19: TABLE \"FRAME SECTION ASSIGNMENTS\": frame 8" },
    { more 'TABLE:  "JOINT LOADS - FORCE"\n   Joint=2   LoadPat=LIVE\n',
      "19: load pattern LIVE is not in LOAD PATTERN" },
    { more 'TABLE:  "JOINT LOADS - FORCE"\n   Joint=2   LoadPat=DEAD _\n',
      "19: TABLE \"JOINT LOADS - FORCE\": the row has _" },
    { more 'TABLE:  "JOINT LOADS - FORCE"\n   Joint=2   LoadPat=DEAD _\nTABLE:  "X"\n', "19: TABLE \"JOINT LOADS" },
    { more 'TABLE:  "JOINT COORDINATES"\n   Joint=2   XorR=1   Y=1   Z=1\n', "19: joint 2 is there twice" },
  } do refused(row[2], function() s2k(row[1]) end) end
  refused("hinge.import.s2k: cannot read ", import.s2k, { file = folder .. "none.s2k" })
  refused("unknown field 'path'", import.s2k, { path = "x" })
end)

checks.done()
