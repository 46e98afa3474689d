-- A portal in text tables of SAP2000 is read, loaded, and written as a script of hinge: see import.md.
local hinge = require "hinge"
local import = hinge.import

-- The file, as an export of SAP2000 has it: a portal of 6 m by 4 m whose beam is pinned to the right column.
local tables = [[
TABLE:  "PROGRAM CONTROL"
   ProgramName=SAP2000   Version=24.1.0   CurrUnits="KN, m, C"
TABLE:  "MATERIAL PROPERTIES 02 - BASIC MECHANICAL PROPERTIES"
   Material=S355   UnitWeight=76.9822   UnitMass=7.85   E1=210000000   G12=80769231   U12=0.3   A1=1.2E-05
TABLE:  "MATERIAL PROPERTIES 03A - STEEL DATA"
   Material=S355   Fy=355000   Fu=510000
TABLE:  "FRAME SECTION PROPERTIES 01 - GENERAL"
   SectionName=HE240B   Material=S355   Shape="I/Wide Flange"   t3=0.24   t2=0.24   tf=0.017   tw=0.01   t2b=0.24 _
        tfb=0.017   Area=0.0106   TorsConst=1.027E-06   I33=1.126E-04   I22=3.923E-05   AS2=0.0024   AS3=0.0068 _
        Z33=0.001053   Z22=4.984E-04   Color=Red
   SectionName=IPE300   Material=S355   Shape="I/Wide Flange"   t3=0.3   t2=0.15   tf=0.0107   tw=0.0071   t2b=0.15 _
        tfb=0.0107   Area=0.00538   TorsConst=2.012E-07   I33=8.356E-05   I22=6.04E-06   AS2=0.00213   AS3=0.002675 _
        Z33=6.284E-04   Z22=1.252E-04   Color=Blue
TABLE:  "JOINT COORDINATES"
   Joint=1   CoordSys=GLOBAL   CoordType=Cartesian   XorR=0   Y=0   Z=0
   Joint=2   CoordSys=GLOBAL   CoordType=Cartesian   XorR=0   Y=0   Z=4
   Joint=3   CoordSys=GLOBAL   CoordType=Cartesian   XorR=6   Y=0   Z=4
   Joint=4   CoordSys=GLOBAL   CoordType=Cartesian   XorR=6   Y=0   Z=0
TABLE:  "CONNECTIVITY - FRAME"
   Frame=left   JointI=1   JointJ=2   IsCurved=No
   Frame=beam   JointI=2   JointJ=3   IsCurved=No
   Frame=right   JointI=4   JointJ=3   IsCurved=No
TABLE:  "JOINT RESTRAINT ASSIGNMENTS"
   Joint=1   U1=Yes   U2=Yes   U3=Yes   R1=Yes   R2=Yes   R3=Yes
   Joint=4   U1=Yes   U2=Yes   U3=Yes   R1=Yes   R2=Yes   R3=Yes
TABLE:  "FRAME SECTION ASSIGNMENTS"
   Frame=left   AnalSect=HE240B   MatProp=Default
   Frame=beam   AnalSect=IPE300   MatProp=Default
   Frame=right   AnalSect=HE240B   MatProp=Default
TABLE:  "FRAME RELEASE ASSIGNMENTS 1 - GENERAL"
   Frame=beam   PI=No   V2I=No   V3I=No   TI=No   M2I=No   M3I=No   PJ=No   V2J=No   V3J=No   TJ=No   M2J=No   M3J=Yes
TABLE:  "LOAD PATTERN DEFINITIONS"
   LoadPat=DEAD   DesignType=Dead   SelfWtMult=1
   LoadPat=WIND   DesignType=Wind   SelfWtMult=0
TABLE:  "FRAME LOADS - DISTRIBUTED"
   Frame=beam   LoadPat=DEAD   CoordSys=GLOBAL   Type=Force   Dir=Gravity   RelDistA=0   RelDistB=1 _
        FOverLA=20   FOverLB=20
   Frame=left   LoadPat=WIND   CoordSys=SITE   Type=Force   Dir=X   RelDistA=0   RelDistB=1   FOverLA=2   FOverLB=4
TABLE:  "JOINT LOADS - FORCE"
   Joint=2   LoadPat=WIND   CoordSys=GLOBAL   F1=10   F2=0   F3=0   M1=0   M2=0   M3=0
TABLE:  "JOINT SPRING ASSIGNMENTS 1 - UNCOUPLED"
   Joint=3   U1=500   U2=0   U3=0   R1=0   R2=0   R3=0
TABLE:  "GRID LINES"
   CoordSys=GLOBAL   AxisDir=X   GridID=A   XRYZCoord=0
END TABLE DATA
]]

-- Writes the file into the output folder; returns its path.
local function write_sample(folder)
  os.execute(("mkdir -p '%s'"):format(folder))
  local path = folder .. "/portal.s2k"
  local file = assert(io.open(path, "w"))
  file:write(tables)
  file:close()
  return path
end

-- Dead load, then dead load and wind. Prints the sway of joint 2 and the sum of the vertical reactions.
local function statics(title, model, nodes)
  local run = model:static { steps = 2, loads = { DEAD = 1 } }:finish()
  local _, _, left = nodes["1"]:reaction(run)
  local _, _, right = nodes["4"]:reaction(run)
  local windy = model:static { steps = 2, from = run, loads = { WIND = 1 } }:finish()
  local sway = nodes["2"]:displacement(windy) - nodes["2"]:displacement(run)
  print(("%s: vertical reactions %.3f kN, sway by wind %.3f mm"):format(title, (left + right) / 1e3, 1e3 * sway))
  return (left + right) / 1e3, 1e3 * sway
end

return hinge.scenario {
  run = function(_, job)
    local folder = job.out ~= "" and job.out or "/tmp" -- hinge plan and hinge check have no output folder

    -- Read the file, and print what was not read.
    local frame, notes = import.s2k { file = write_sample(folder) }
    print(notes)

    -- Put in by hand what was not read: the wind on the left column. SITE has the directions of GLOBAL.
    table.insert(frame.cases[2].loads, { member = "left", q = { a = { 2e3, 0, 0 }, b = { 4e3, 0, 0 } } })
    local options = { model = { displacement = "small" } }
    local model, nodes = import.build(frame, options)
    local vertical, sway = statics("the model", model, nodes)

    -- The same as a script, to go on from.
    local script = import.write(frame, "portal.lua", options)
    local again, its_nodes = dofile(script)
    statics(script, again, its_nodes)
    return { vertical_kN = vertical, sway_mm = sway }
  end,
}
