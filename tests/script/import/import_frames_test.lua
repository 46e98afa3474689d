-- hinge.import: whole frames as text against what is written by hand, one for each format: every node, material,
-- section, member, load and mass with its numbers in SI; releases and self weight in full.
--
-- Run: lua5.4 tests/script/import/import_frames_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local frame_text = require "import.frame_text"
require "hinge"
local import = require "hinge.import"
local in_full = require "hinge.import.in_full"
local checks = support.checks "frames of import"
local case, near, equal, expect = checks.case, checks.near, checks.equal, checks.expect

local shown = frame_text.shown

local write, folder = support.writer()
local function s2k(text) return import.s2k { file = write("frame.s2k", text) } end

-- SAP2000 -------------------------------------------------------------------------------------------------------------

-- kN and mm: 1 kN/mm2 is 1 GPa, 1 kN s2/mm4 is 1e15 kg/m3, 1 kN/mm3 is 1e12 N/m3, 1 kN mm is 1 N m, 1 kN/mm is 1e6 N/m
local sap = [[
TABLE:  "PROGRAM CONTROL"
   ProgramName=SAP2000   Version=14   CurrUnits="KN, mm, C"
TABLE:  "JOINT COORDINATES"
   Joint=1   CoordSys=GLOBAL   CoordType=Cartesian   XorR=0   Y=0   Z=0
   Joint=2   CoordSys=GLOBAL   CoordType=Cartesian   XorR=0   Y=0   Z=4000
   Joint=3   CoordSys=other   CoordType=Cylindrical   XorR=7   Y=7   Z=7   GlobalX=6000   GlobalY=0   GlobalZ=4000
   Joint=4   CoordSys=GLOBAL   CoordType=Cartesian   XorR=2000   Y=0.5   Z=4000
   Joint=5   CoordSys=GLOBAL   CoordType=Cartesian   XorR=6000   Y=0   Z=0
   Joint=6   CoordSys=GLOBAL   CoordType=Cartesian   XorR=2000   Y=1500   Z=4000
TABLE:  "JOINT RESTRAINT ASSIGNMENTS"
   Joint=1   U1=Yes   U2=Yes   U3=Yes   R1=Yes   R2=Yes   R3=Yes
   Joint=5   U1=Yes   U2=Yes   U3=Yes   R1=Yes   R2=Yes   R3=Yes
   Joint=6   U1=No   U2=Yes   U3=No   R1=Yes   R2=No   R3=Yes
TABLE:  "MATERIAL PROPERTIES 02 - BASIC MECHANICAL PROPERTIES"
   Material=S   UnitWeight=7.7E-08   UnitMass=7.85E-12   E1=210   G12=81   U12=0.3   A1=1E-05
   Material=C   E1=30   U12=0.2
   Material=D   UnitMass=2E-12   E1=10
TABLE:  "MATERIAL PROPERTIES 03A - STEEL DATA"
   Material=S   Fy=0.355   Fu=0.5
   Material=D   Fy=0
TABLE:  "FRAME SECTION PROPERTIES 01 - GENERAL"
   SectionName=G1   Material=C   t3=300   t2=200   Area=60000   TorsConst=470000000   I33=450000000   I22=200000000 _
        AS2=50000   AS3=0   Z33=4500000   AMod=0.5   A2Mod=0.8   I2Mod=0.9   JMod=0.1
   SectionName=G2   Material=S   Area=1000   TorsConst=20000   I33=10000000   I22=1000000   AS2=600   AS3=400 _
        Z22=3000   A3Mod=0.5   I3Mod=2
   SectionName=R   Material=D   Shape=Rectangular   t3=400   t2=200
TABLE:  "CONNECTIVITY - FRAME"
   Frame=1   JointI=1   JointJ=2   IsCurved=No
   Frame=2   JointI=2   JointJ=3   IsCurved=No
   Frame=3   JointI=5   JointJ=3   IsCurved=No
   Frame=4   JointI=6   JointJ=4   IsCurved=No
   Frame=5   JointI=3   JointJ=2   IsCurved=No
TABLE:  "FRAME SECTION ASSIGNMENTS"
   Frame=1   AnalSect=G1   MatProp=Default
   Frame=2   AnalSect=G2   MatProp=Default
   Frame=3   AnalSect=G1   MatProp=D
   Frame=4   AnalSect=R   MatProp=Default
   Frame=5   AnalSect=G2   MatProp=Default
TABLE:  "FRAME AUTO MESH"
   Frame=5   AutoMesh=Yes   AtJoints=No   AtFrames=No
TABLE:  "FRAME LOCAL AXES 1 - TYPICAL"
   Frame=1   Angle=90
   Frame=4   Angle=30
TABLE:  "FRAME RELEASE ASSIGNMENTS 1 - GENERAL"
   Frame=2   PI=No   M2I=No   M3I=Yes   TI=No   M2J=Yes   M3J=No   TJ=Yes
   Frame=3   TI=Yes   M3J=Yes   M2J=Yes
TABLE:  "GROUPS 2 - ASSIGNMENTS"
   GroupName=cols   ObjectType=Frame   ObjectLabel=1
   GroupName=cols   ObjectType=Frame   ObjectLabel=3
   GroupName=right   ObjectType=Frame   ObjectLabel=3
   GroupName=ALL   ObjectType=Frame   ObjectLabel=2
   GroupName=dots   ObjectType=Joint   ObjectLabel=2
TABLE:  "LOAD PATTERN DEFINITIONS"
   LoadPat=DEAD   DesignType=DEAD   SelfWtMult=1.1
   LoadPat=LIVE   DesignType=LIVE   SelfWtMult=0
TABLE:  "JOINT LOADS - FORCE"
   Joint=2   LoadPat=LIVE   CoordSys=GLOBAL   F1=1   F2=2   F3=-3   M1=10   M2=20   M3=30
   Joint=3   LoadPat=DEAD   CoordSys=GLOBAL   F2=-2
   Joint=4   LoadPat=DEAD   CoordSys=GLOBAL   M3=4
   Joint=4   LoadPat=DEAD   CoordSys=GLOBAL   F1=0
TABLE:  "FRAME LOADS - DISTRIBUTED"
   Frame=2   LoadPat=LIVE   CoordSys=GLOBAL   Type=Force   Dir=Gravity   DistType=RelDist   RelDistA=0   RelDistB=1 _
        AbsDistA=0   AbsDistB=6000   FOverLA=0.02   FOverLB=0.02
   Frame=1   LoadPat=LIVE   CoordSys=Local   Type=Force   Dir=3   DistType=AbsDist   AbsDistA=0   AbsDistB=4000 _
        FOverLA=0.01   FOverLB=0.01
   Frame=4   LoadPat=DEAD   CoordSys=GLOBAL   Type=Force   Dir="Y Proj"   FOverLA=-0.003   FOverLB=-0.003
]]

local sap_as_text = [[
node 1 x=0 y=0 z=0 fix=all
node 2 x=0 y=0 z=4
node 3 x=6 y=0 z=4
node 4 x=2 y=0.0005 z=4
node 5 x=6 y=0 z=0 fix=all
node 6 x=2 y=1.5 z=4 fix=y,rx,rz
material S E=2.1e+11 G=8.1e+10 density=7850 unit_weight=77000 yield_stress=3.55e+08
material C E=3e+10 nu=0.2 density=0
material D E=1e+10 nu=0.3 density=2000
section G1 area=0.03 Ix=0.00045 Iy=0.00018 J=4.7e-05 shear_area_x=30 shear_area_y=0.04 plastic={A=0.06 Zx=0.0045} ]]
  .. [[size={depth=0.3 width=0.2}
section G2 area=0.001 Ix=2e-05 Iy=1e-06 J=2e-08 shear_area_x=0.0002 shear_area_y=0.0006 plastic={A=0.001 Zy=3e-06}
section R area=0.08 Ix=0.00106667 Iy=0.000266667 J=%s shear_area_x=0.0666667 shear_area_y=0.0666667 ]]
  .. [[plastic={A=0.08 Zx=0.008 Zy=0.004 Zz=%s} size={depth=0.4 width=0.2}
member 1 a=1 b=2 section=G1 material=C up={0 1 0} group=cols
member 2/1 a=2 b=4 section=G2 material=S release={a=rx}
member 2/2 a=4 b=3 section=G2 material=S release={b=ry,rz}
member 3 a=5 b=3 section=G1 material=D group={cols right} release={a=rz b=rx,ry}
member 4 a=6 b=4 section=R material=D up={-0.5 0 0.866025}
member 5 a=3 b=2 section=G2 material=S
case DEAD self_weight=1.1
  load node=3 force={0 -2000 0}
  load node=4 moment={0 0 4}
  load member=4 q={0 -3000 0} axes=projected
case LIVE self_weight=0
  load node=2 force={1000 2000 -3000} moment={10 20 30}
  load member=2/1 q={0 0 -20000}
  load member=2/2 q={0 0 -20000}
  load member=1 q={-10000 0 0} axes=local
]]

case("SAP2000: a frame in kN and mm, row by row", function()
  local frame, notes = s2k(sap)
  -- torsion of a rectangle: h b^3 (1/3 - 64 / pi^5 b / h sum of tanh(n pi h / 2 b) / n^5); plastic: b^2 (3 h - b) / 6
  local b, h, sum = 0.2, 0.4, 0
  for n = 1, 99, 2 do
    local e = math.exp(-n * math.pi * h / b)
    sum = sum + (1 - e) / (1 + e) / n ^ 5
  end
  local J = h * b ^ 3 * (1 / 3 - 64 / math.pi ^ 5 * b / h * sum)
  frame_text.same(equal, frame, sap_as_text:format(shown(J), shown(b ^ 2 * (3 * h - b) / 6)), "SAP2000")
  equal(#notes, 0, "notes: " .. tostring(notes))
  equal(tostring(notes):match "^[^\n]*\n[^\n]*", folder .. "frame.s2k: 6 nodes, 6 members of 21.4995 m, 3 sections, "
    .. "3 materials, 2 load cases, 8 loads\n  mass of the members 574.12 kg, point masses 0 kg", "the summary")
end)

case("SAP2000: each release that is not read is noted with its line and its end", function()
  for key, at in pairs { PI = "I", V2J = "J", V3I = "I", V2I = "I", PJ = "J", V3J = "J" } do
    local _, notes = s2k((sap:gsub("Frame=3   TI=Yes", "Frame=3   TI=Yes   " .. key .. "=Yes")))
    equal(#notes, 1, key)
    equal(notes[1] and notes[1].reason, ("end %s: releases of P, V2 and V3 are not read"):format(at), key)
  end
  local _, notes = s2k((sap:gsub("Frame=3   TI=Yes", "Frame=3   PartialFix=Yes")))
  equal(notes[1] and notes[1].reason, "a spring of a partial release is not read: the end is released", "a spring")
  for _, key in ipairs { "AdvanceAxes", "MirrorAbt2", "MirrorAbt3" } do
    _, notes = s2k((sap:gsub("Angle=30", "Angle=30   " .. key .. "=Yes")))
    equal(notes[1] and notes[1].reason, "of the local axes the angle alone is read", key)
  end
end)

case("releases and self weight in full: as model:member has them, gravity or loads", function()
  local frame = s2k(sap)
  expect(pcall(in_full, "w", frame, {}), "a weight of 77000 N/m^3 beside 76982.2, within 0.1 %")
  local full = in_full("w", frame, { self_weight = "gravity", gravity = 9 })
  near(full.cases[1].gravity, -9.9, 1e-12, "gravity of the case, m/s^2")
  equal(full.cases[2].gravity, nil, "of the other one")
  local released = {}
  for _, m in ipairs(full.members) do
    for _, at in ipairs { "a", "b" } do
      local list = m.release and m.release[at]
      if list then released[#released + 1] = ("%s.%s: %s"):format(m.name, at, table.concat(list, " ")) end
    end
  end
  equal(table.concat(released, "; "), "2/1.a: Mx; 2/2.b: My Mz; 3.a: Mz; 3.b: Mx My", "released ends")
end)

case("self weight as loads: the weight of the file where it has one, else the density", function()
  local without_releases = sap:gsub('TABLE:  "FRAME RELEASE.-\nTABLE', "TABLE")
  local frame = s2k(without_releases)
  local full = in_full("w", frame, { self_weight = "loads", gravity = 10 })
  local of = {}
  for _, l in ipairs(full.cases[1].loads) do
    if l.member and not l.axes then of[l.member] = l.q[3] end
  end
  for name, q in pairs { ["1"] = 0, ["2/1"] = -1.1 * 77000 * 0.001, ["2/2"] = -1.1 * 77000 * 0.001,
    ["3"] = -1.1 * 2000 * 10 * 0.03, ["4"] = -1.1 * 2000 * 10 * 0.08, ["5"] = -1.1 * 77000 * 0.001 } do
    near(of[name], q, 1e-9 * math.abs(q), "member " .. name .. ", N/m")
  end
  equal(full.cases[1].gravity, nil, "no gravity")
  -- gravity is asked for by the density's weight within 0.1 %
  for weight, told in pairs { ["7.7E-08"] = false, ["7.71E-08"] = true, ["7.68E-08"] = true } do
    local other = s2k((without_releases:gsub("7%.7E%-08", weight)))
    equal(not pcall(in_full, "w", other, {}), told, "a weight of " .. weight)
  end
end)

-- ETABS ---------------------------------------------------------------------------------------------------------------

local etabs = [[
$ CONTROLS
  UNITS  "KN"  "CM"  "C"
$ STORIES - IN SEQUENCE FROM TOP
  STORY "Roof"  HEIGHT 300
  STORY "First"  HEIGHT 400
  STORY "Base"  ELEV 50
$ MATERIAL PROPERTIES
  MATERIAL  "S"    TYPE "Steel"  WEIGHTPERVOLUME 7.7E-05
  MATERIAL  "S"    SYMTYPE "Isotropic"  E 21000  U 0.25
  MATERIAL  "S"    FY 35.5
$ FRAME SECTIONS
  FRAMESECTION  "A"  MATERIAL "S"  SHAPE "General"  AREA 100  I33 9000  I22 4000  TORSION 50  AS2 40  AS3 60  D 30  B 20
  FRAMESECTION  "A"  I33MODIFIER 0.5  Z33 700  Z22 400
  FRAMESECTION  "P"  MATERIAL "S"  SHAPE "Steel Pipe"  D 20  T 1
  FRAMESECTION  "N"  MATERIAL "S"  SHAPE "HE200B"
$ POINT COORDINATES
  POINT "1"  0 0
  POINT "2"  600 100
  POINT "3"  300 50 100
$ LINE CONNECTIVITIES
  LINE  "C1"  COLUMN  "1"  "1"  1
  LINE  "C2"  COLUMN  "2"  "2"  2
  LINE  "B1"  BEAM  "1"  "2"  0
  LINE  "D1"  BRACE  "1"  "3"  1
$ POINT ASSIGNS
  POINTASSIGN  "1"  "Base"  RESTRAINT "UX UY UZ RX RY RZ"
  POINTASSIGN  "2"  "Base"  RESTRAINT "UX UZ RY"
$ LINE ASSIGNS
  LINEASSIGN  "C1"  "First"  SECTION "A"  ANG 90
  LINEASSIGN  "C1"  "Roof"  SECTION "P"
  LINEASSIGN  "C2"  "Roof"  SECTION "A"
  LINEASSIGN  "B1"  "Roof"  SECTION "A"  RELEASE "M3I M2J TJ"
  LINEASSIGN  "D1"  "Roof"  SECTION "P"
$ LOAD PATTERNS
  LOADPATTERN "Dead"  TYPE  "Dead"  SELFWEIGHT  1
  LOADPATTERN "Live"  TYPE  "Live"  SELFWEIGHT  0
$ POINT OBJECT LOADS
  POINTLOAD  "2"  "Roof"  TYPE "FORCE"  LC "Live"  FX 1  FY 2  FZ -3  MX 100  MY 200  MZ 300
$ LINE OBJECT LOADS
  LINELOAD  "B1"  "Roof"  TYPE "UNIFF"  DIR "GRAV"  LC "Live"  FVAL 0.2
  LINELOAD  "C1"  "First"  TYPE "TRAPF"  DIR "2"  LC "Live"  FSTART 0.1  FEND 0.1  RDSTART 0  RDEND 1
]]
-- kN and cm: 1 kN/cm2 is 10 MPa, 1 kN/cm3 is 1e9 N/m3, 1 kN cm is 10 N m, 1 kN/cm is 1e5 N/m
local etabs_as_text = [[
node 1@Base x=0 y=0 z=0.5 fix=all
node 1@First x=0 y=0 z=4.5
node 1@Roof x=0 y=0 z=7.5
node 2@Base x=6 y=1 z=0.5 fix=x,z,ry
node 2@Roof x=6 y=1 z=7.5
node 3@Roof x=3 y=0.5 z=6.5
material S E=2.1e+11 nu=0.25 density=7851.81 unit_weight=77000 yield_stress=3.55e+08
section A area=0.01 Ix=4.5e-05 Iy=4e-05 J=5e-07 shear_area_x=0.006 shear_area_y=0.004 ]]
  .. [[plastic={A=0.01 Zx=0.0007 Zy=0.0004} size={depth=0.3 width=0.2}
section P %s
section N named=%s
member C1@First a=1@Base b=1@First section=A material=S up={0 1 0} group=columns
member C1@Roof a=1@First b=1@Roof section=P material=S group=columns
member C2@Roof a=2@Base b=2@Roof section=A material=S group=columns
member B1@Roof a=1@Roof b=2@Roof section=A material=S group=beams release={a=rx b=ry,rz}
member D1@Roof a=1@First b=3@Roof section=P material=S group=braces
case Dead self_weight=1
case Live self_weight=0
  load node=2@Roof force={1000 2000 -3000} moment={1000 2000 3000}
  load member=B1@Roof q={0 0 -20000}
  load member=C1@First q={0 10000 0} axes=local
]]

case("ETABS: a frame in kN and cm, row by row", function()
  local frame, notes = import.e2k { file = write("frame.e2k", etabs) }
  local pi, D, d = math.pi, 0.2, 0.18
  local A, I = pi / 4 * (D ^ 2 - d ^ 2), pi / 64 * (D ^ 4 - d ^ 4)
  local pipe
  for _, s in ipairs(frame.sections) do if s.name == "P" then pipe = s end end
  local of_pipe = frame_text.of(frame):match "section P ([^\n]*)" or ""
  frame_text.same(equal, frame, etabs_as_text:format(of_pipe, "HE200B"), "ETABS")
  for key, wanted in pairs { area = A, Ix = I, Iy = I, J = 2 * I } do near(pipe[key], wanted, 1e-9 * wanted, key) end
  near(pipe.plastic.Zx, (D ^ 3 - d ^ 3) / 6, 1e-9, "Zx of the pipe")
  equal(#notes, 0, tostring(notes))
  for _, key in ipairs { "ANG", "LENGTHOFFI", "LENGTHOFFJ" } do -- with its line
    checks.refused(("frame.e2k:29: %s is 'upwards'; must be a number"):format(key), import.e2k,
      { file = write("frame.e2k", (etabs:gsub("ANG 90", key .. " upwards"))) })
  end
end)

-- CSV -----------------------------------------------------------------------------------------------------------------

case("CSV: a frame in SI, row by row, with all columns", function()
  local frame, notes = import.csv {
    nodes = write("nodes.csv", "name;x;y;z\n1;0;0;0\n2;0;0,5;4\n\n# a remark\n3;6;0.5;4\n4;6;0;0\n"),
    members = write("members.csv", 'name,a,b,section,material,up_x,up_y,up_z,group,release_a,release_b\n'
      .. '"m,1",1,2,S,steel,1,0,0,cols,,\nm2,2,3,T,S355,,,,"a ""b""",rx;ry,rz\nm3,4,3,HEB 200,C,,,,,,rx ry\n'),
    sections = write("sections.csv", "name,area,Ix,Iy,J,shear_area_x,shear_area_y,Zx,Zy,Zz,width,depth,named\n"
      .. "S,0.01,1e-4,2e-5,3e-6,0.004,0.005,7e-4,2e-4,1e-4,0.2,0.3,\nT,,,,,,,,,,,,IPE 300\n"),
    materials = write("materials.csv", "name,E,G,nu,density,yield_stress\nsteel,2.1e11,8e10,,7850,355e6\n"
      .. "C,3e10,,0.2,2500,\n"),
    supports = write("supports.csv", "node,fix,x,y,z,rx,ry,rz\n1,all,,,,,,\n4,,1,0,1,0,1,\n3,y;rx,,,,,,\n"),
    loads = write("loads.csv", "case,node,member,fx,fy,fz,mx,my,mz,qx,qy,qz,axes\n"
      .. 'dead,2,,1,2,3,4,5,6,,,,\ndead,,m2,,,,,,,7,8,9,local\n,3,,,,-1,,,,,,,\nwind,,"m,1",,,,,,,1,,,projected\n'),
    masses = write("masses.csv", "node,mass\n2,500\n"),
  }
  local steel = require "hinge.sections.grades".steel "S355"
  frame_text.same(equal, frame, ([[
node 1 x=0 y=0 z=0 fix=all
node 2 x=0 y=0.5 z=4
node 3 x=6 y=0.5 z=4 fix=y,rx
node 4 x=6 y=0 z=0 fix=x,z,ry
material steel E=2.1e+11 G=8e+10 density=7850 yield_stress=3.55e+08
material C E=3e+10 nu=0.2 density=2500
material S355 E=%s nu=%s density=%s yield_stress=%s
section S area=0.01 Ix=0.0001 Iy=2e-05 J=3e-06 shear_area_x=0.004 shear_area_y=0.005 ]]
    .. [[plastic={A=0.01 Zx=0.0007 Zy=0.0002 Zz=0.0001} size={depth=0.3 width=0.2}
section T named=IPE 300
section HEB 200 named=HEB 200
member m,1 a=1 b=2 section=S material=steel up={1 0 0} group=cols
member m2 a=2 b=3 section=T material=S355 group=a "b" release={a=rx,ry b=rz}
member m3 a=4 b=3 section=HEB 200 material=C release={b=rx,ry}
case dead
  load node=2 force={1 2 3} moment={4 5 6}
  load member=m2 q={7 8 9} axes=local
case loads
  load node=3 force={0 0 -1}
case wind
  load member=m,1 q={1 0 0} axes=projected
mass 2 mass=500
]]):format(shown(steel.E), shown(steel.nu), shown(steel.density), shown(steel.yield_stress)), "CSV")
  equal(#notes, 0, tostring(notes))
end)

checks.done()
