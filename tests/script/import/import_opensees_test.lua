-- hinge.import.tcl: whole frames of OpenSees as text against what is written by hand, in the plane and in space, in Tcl
-- and in Python: every node, material, section, member, load and mass with its numbers in SI. What is not read is in
-- the notes with its line; broken scripts are refused with the line.
--
-- Run: lua5.4 tests/script/import/import_opensees_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local files = require "import.files"
local frame_text = require "import.frame_text"
require "hinge"
local import = require "hinge.import"
local checks = support.checks "frames of OpenSees"
local case, near, equal, expect, refused = checks.case, checks.near, checks.equal, checks.expect, checks.refused

local write = support.writer()

local function tcl(text, units)
  return import.tcl { file = write("frame.tcl", text), units = units or { length = "m", force = "N" } }
end

local function python(text)
  return import.tcl { file = write("frame.py", text), units = { length = "m", force = "N" }, run_python = true }
end

local plane_tcl = [[
model BasicBuilder -ndm 2
node 1 0 0
node 2 0 4 -mass 2 2 5
node 3 6.0 4
node 4 6 0
fix 1 1 1 1
fixY 0 1 1 0
geomTransf Linear 1
section Elastic 7 200 3 4 80 0.8
element elasticBeamColumn 1 1 2 3 200 4 1
element elasticBeamColumn 2 2 3 7 1 -mass 0.5
element forceBeamColumn 3 4 3 5 7 1
element ElasticTimoshenkoBeam 4 1 3 200 80 3 4 2 1
pattern Plain 1 Linear { load 2 1 2 3; eleLoad -ele 1 3 -type -beamUniform -1 2 }
pattern Plain 2 Constant -factor 2.5 { load 3 1 0 0 }
mass 3 1 1 0
]]
local plane_python = [[
from openseespy.opensees import *
model('basic', '-ndm', 2, '-ndf', 3)
for tag, x, y in [(1, 0, 0), (2, 0, 4), (3, 6, 4), (4, 6, 0)]:
    node(tag, x, y)
mass(2, 2, 2, 5)
fix(1, 1, 1, 1)
fix(4, *[1, 1], 0)
geomTransf('Linear', 1)
section('Elastic', 7, 200.0, 3, 4, 80, 0.8)
element('elasticBeamColumn', 1, 1, 2, 3, 200, 4, 1)
element('elasticBeamColumn', 2, 2, 3, 7, 1, '-mass', 0.5)
element('forceBeamColumn', 3, 4, 3, 5, 7, 1)
element('ElasticTimoshenkoBeam', 4, 1, 3, 200, 80, 3, 4, 2, 1)
timeSeries('Linear', 1)
pattern('Plain', 1, 1)
load(2, 1, 2, 3)
eleLoad('-ele', 1, 3, '-type', '-beamUniform', -1, 2)
timeSeries('Constant', 2, '-factor', 2.5)
pattern('Plain', 2, 2)
load(3, 1, 0, 0)
mass(3, 1, 1, 0)
]]
-- m and kN: 1 kN s2/m is 1 t. y of the plane is z; J is twice I_z where the plane frame has none.
local plane_as_text = [[
node 1 x=0 y=0 z=0 fix=all
node 2 x=0 y=0 z=4 fix=y,rx,rz
node 3 x=6 y=0 z=4 fix=y,rx,rz
node 4 x=6 y=0 z=0 fix=x,y,z,rx,rz
material element 1 E=200000 density=0
material section 7 E=200000 G=80000 density=166.667
material section 7, 2 E=200000 G=80000 density=0
section element 1 area=3 Ix=4 Iy=4 J=8 shear_area_x=3000 shear_area_y=3000
section section 7 area=3 Ix=4 Iy=4 J=8 shear_area_x=2.4 shear_area_y=2.4
section element 4 area=3 Ix=4 Iy=4 J=8 shear_area_x=2 shear_area_y=2
member 1 a=1 b=2 section=element 1 material=element 1 up={-1 0 0}
member 2 a=2 b=3 section=element 1 material=section 7 up={0 0 1}
member 3 a=4 b=3 section=section 7 material=section 7, 2 up={-1 0 0}
member 4 a=1 b=3 section=element 4 material=section 7, 2 up={-0.5547 0 0.83205}
case pattern 1
  load node=2 force={1000 0 2000} moment={0 -3000 0}
  load member=1 q={0 -1000 2000} axes=local
  load member=3 q={0 -1000 2000} axes=local
case pattern 2
  load node=3 force={2500 0 0}
mass 2 mass=2000 inertia={0 5000 0}
mass 3 mass=1000
]]

case("OpenSees: a plane frame in m and kN, row by row, in Tcl and in Python", function()
  for name, text in pairs { ["plane.tcl"] = plane_tcl, ["plane.py"] = plane_python } do
    local frame, notes = import.tcl { file = write(name, text), units = { length = "m", force = "kN" },
      run_python = true }
    frame_text.same(equal, frame, plane_as_text, name)
    equal(#notes, 0, tostring(notes))
    local assumed = {}
    for i, entry in ipairs(notes.assumed) do assumed[i] = ("%d %s"):format(entry.line, entry.reason:match "^[^;:]*") end
    table.sort(assumed)
    local along, small = "11 -mass lies along the member, not half at each node as in OpenSees; ",
      "8 displacement = 'small' of hinge.model"
    equal(table.concat(assumed, "; "), name == "plane.tcl"
      and "1 a plane frame; 10 the element has no shear strain; " .. along .. small
      or "10 the element has no shear strain; " .. along .. "2 a plane frame; " .. small, "what is assumed in " .. name)
  end
end)

local space_tcl = [[
model BasicBuilder -ndm 3 -ndf 6
node 1 0 0 0
node 2 0 0 3
node 3 4 1 3
fix 1 1 1 1 0 1 0
fixX 4 0 1 0 1 0 1 -tol 0.01
geomTransf PDelta 1 0 1 0
geomTransf PDelta 2 0 0.6 0.8
section Elastic 1 200 2 0.3 0.4 80 0.5 0.8 0.7
element elasticBeamColumn 1 1 2 2 200 80 0.5 0.4 0.3 1
element dispBeamColumn 2 2 3 1 Legendre 1 3 -mass 7
element ElasticTimoshenkoBeam 3 1 3 200 80 2 0.5 0.4 0.3 1.5 1.2 1
beamIntegration Lobatto 4 1 5
element forceBeamColumn 4 3 2 2 4
element nonlinearBeamColumn 5 3 1 1 "Lobatto 1 5"
element elasticBeamColumn 6 3 1 1 1
timeSeries Linear 1 -factor 3
pattern Plain 3 1 -fact 2 { load 3 1 0 0 0 0 0 }
pattern Plain 1 Constant { load 2 1 2 3 4 5 6 }
pattern Plain 2 Linear { eleLoad -range 1 2 -type -beamUniform 1 2 3
eleLoad -ele 3 -type -beamUniform 4 5 }
mass 2 3 3 3 1 2 4
mass 3 7 7 0 0 0 0
]]
-- mm and N: 1 N s2/mm is 1 t, 1 N/mm2 is 1 MPa. Ix is I_y of OpenSees, Iy is I_z; y is towards vecxz
local space_as_text = [[
node 1 x=0 y=0 z=0 fix=x,y,z,ry
node 2 x=0 y=0 z=0.003
node 3 x=0.004 y=0.001 z=0.003 fix=y,rx,rz
material element 1 E=2e+08 G=8e+07 density=0
material section 1 E=2e+08 G=8e+07 density=3.5e+12
section element 1 area=2e-06 Ix=4e-13 Iy=3e-13 J=5e-13 shear_area_x=0.002 shear_area_y=0.002
section element 3 area=2e-06 Ix=4e-13 Iy=3e-13 J=5e-13 shear_area_x=1.5e-06 shear_area_y=1.2e-06
section section 1 area=2e-06 Ix=4e-13 Iy=3e-13 J=5e-13 shear_area_x=1.6e-06 shear_area_y=1.4e-06
member 1 a=1 b=2 section=element 1 material=element 1 up={0 1 0}
member 2 a=2 b=3 section=element 1 material=section 1 up={0 1 0}
member 3 a=1 b=3 section=element 3 material=element 1 up={0 1 0}
member 4 a=3 b=2 section=section 1 material=element 1 up={0 0.6 0.8}
member 5 a=3 b=1 section=section 1 material=element 1 up={0 1 0}
member 6 a=3 b=1 section=element 1 material=element 1 up={0 1 0}
case pattern 3
  load node=3 force={6 0 0}
case pattern 1
  load node=2 force={1 2 3} moment={0.004 0.005 0.006}
case pattern 2
  load member=1 q={1000 2000 3000} axes=local
  load member=2 q={1000 2000 3000} axes=local
  load member=3 q={4000 5000 0} axes=local
mass 2 mass=3000 inertia={0.001 0.002 0.004}
mass 3 mass=7000
]]

case("OpenSees: a frame in space in mm and N, row by row", function()
  local frame, notes = import.tcl { file = write("space.tcl", space_tcl), units = { length = "mm", force = "N" } }
  frame_text.same(equal, frame, space_as_text, "Tcl")
  equal(#notes, 0, tostring(notes))
  expect(files.at_line(notes.assumed, 23), "a mass along two axes is named: %s", tostring(notes))
  local heavy = import.tcl { file = write("space.tcl", space_tcl), units = { length = "mm", force = "N", mass = 5 } }
  near(heavy.masses[1].mass, 15, 1e-12, "a unit of mass that is given")
end)

-- Notes and errors ----------------------------------------------------------------------------------------------------

local tcl_head = "model basic -ndm 3 -ndf 6\ngeomTransf Linear 1 1 0 0\n"
local python_head = "from openseespy.opensees import *\nimport math\nmodel('basic', '-ndm', 3, '-ndf', 6)\n"
  .. "geomTransf('Linear', 1, 1, 0, 0)\n"

case("what OpenSees has and is not read is noted with its line, in Tcl and in Python", function()
  local frame, notes = tcl(tcl_head .. [[
node 1 0 0 0 -disp 1
node 2 0 0 1
node 3 0 0 2 -mass 1 2 0 0 0 0
mass 1 0 0 0 1 1 1
element elasticBeamColumn 1 1 2 1 1 1 1 1 1 1 -damp 1
element shell 2 1 2 1 1
uniaxialMaterial Viscous 1 300 200
section Fiber 1 {
  patch rect 1 1 1 0 0 1 1
}
element forceBeamColumn 3 1 2 5 1 1
equalDOF 1 2 1
timeSeries MPAcc 1 -dt 0.1
pattern UniformExcitation 1 1
load 2 1 0 0 0 0 0
pattern Plain 2 1 {
  sp 1 1 0.1
  eleLoad -ele 1 -type -beamThermal 1 2 0.5
  eleLoad -ele 1 -type -surfaceLoad 1
  eleLoad -ele 2 -type -beamUniform 1 2
}
proc f {x} {
  node 7 $x 0 0
}
f 7
set a [nodeDisp 2 1]
node 9 [expr {$a + 1}] 0 0
foo 1
puts "node 2 0 0 5; mass 2 1 1 1 1 1 1"
fix 9 1 1 1 1 1 1
element forceBeamColumn 4 1 2 1 HingeRadau 1 0.1
geomTransf Linear 2 1 0 0 -shift 1
rigidDiaphragm 3 1
]])
  files.notes_are(expect, "tcl", notes, 2, { [1] = "-disp", [3] = "masses along the axes differ",
    [4] = "inertia without a mass", [5] = "-damp", [6] = "element shell", [7] = "uniaxialMaterial Viscous",
      [9] = "uniaxialMaterial 1 was not read, see line 9",
    [11] = "section 1 was not read, see line 11", [12] = "hinge ties", [13] = "MPAcc", [14] = "by its acceleration",
    [15] = "pattern was not read, see line 16",
    [16] = "timeSeries 1 was not read", [17] = "command sp", [18] = "-beamUniform",
    [19] = "-beamPoint", [20] = "element 2 was not read, see line 8",
    [27] = "hangs on a result of the analysis", [28] = "command foo ",
    [30] = "node 9 is not there; a line",
    [32] = "-shift", [33] = "needs two nodes" })
  equal(#frame.members, 1, "members")
  local _, of_python = python(python_head .. [[
import matplotlib.pyplot as plt
node(1, 0, 0, 0)
node(2, 0, 0, 1)
def f(x):
    node(7, x, 0, 0)
a = nodeDisp(1, 1) + 1
node(3, a, 0, 0)
import pylib
node(9, pylib.height, 0, 0)
for x in pylib.nodes: node(10, x, 0, 0)
x = [1, 2][0:1]
f(x)
class C: pass
print(f"{a}")
element('shell', 2, 1, 2, 1, 1)
for i in range(3):
    equalDOF(1, 2, 1)
]] .. "element('elasticBeamColumn', 1, 1, 2, 1, 1, 1, 1, 1, 1, 1)\n")
  files.notes_are(expect, "python", of_python, 4, { [7] = "hangs on a result of the analysis",
    [8] = "the module pylib is not there", [9] = "hangs on a result", [15] = "element shell", [17] = "hinge ties" })
  equal(files.at_line(of_python, 21).count, 3, "how often a line in a loop was run")
  equal(#of_python.skipped, 1, "what is computed is one entry: " .. tostring(of_python))
end)

case("broken scripts of OpenSees are refused with the line", function()
  local element = "element elasticBeamColumn 1 1 2 1 1 1 1 1 1 1"
  for _, row in ipairs {
    { "node 1 0 0", "3: node 1 has 2 coordinates; must be 3" }, { "node 1 0 0 x",
      "3: coordinate 3 is 'x'; must be a number" },
    { "node 1 0 0 0\nnode 1 0 0 0", "4: node 1 is there twice" }, { "fix 5 1 1 1 1 1 1", "3: node 5 is not there" },
    { "node 1 0 0 0\nfix 1 1 1 1 2 1 1", "4: flag 4 is 2; must be 0 or 1" },
    { "\nnode 1 0 0 0\nnode 2 0 0 0\n" .. element, "6: element 1 has no length" },
    { "node 1 0 0 0\nnode 2 0 0 1\nelement elasticBeamColumn 1 1 2 1 1 1",
      "5: element elasticBeamColumn has 6 arguments" },
    { "node 1 0 0 0\nnode 2 1 0 0\n" .. element, "5: vecxz of element 1 is along the element" },
    { "node 1 0 0 0\nnode 2 0 0 1\nelement elasticBeamColumn 1 1 2 -1 1 1 1 1 1 1", "5: A is -1; must be above 0" },
    { "node 1 0 0 0\nnode 2 0 0 1\nelement elasticBeamColumn 1 1 3 1 1 1 1 1 1 1", "5: node 3 is not there" },
    { "node 1 0 0 0\nnode 2 0 0 1\nelement elasticBeamColumn 1 1 2 5 8", "5: geomTransf 8 is not there" },
    { "load 1 1 0 0 0 0 0", "3: the load stands outside of a pattern" },
    { "node 1.5 0 0 0", "3: the tag is '1.5'; must be a whole number" },
    { "for {set i 0} {$i < 3} {incr i} {\n node $i 0 0 0\n", "3: missing close-brace" },
    { "set a \"x\n\n", "3: missing \"" }, { "set a [expr 1\n", "3: missing close-bracket" },
    { "set a {1}2", "3: extra characters after close-brace" }, { "model basic -ndm 2 -ndf 1",
      "3: -ndm 2 -ndf 1 is no frame" },
    { "elment truss 1 1 2 1 1", "3: invalid command name \"elment\" (did you mean 'element'?)" },
    { "node 1 0 0 $h", "3: can't read \"h\": no such variable" },
  } do
    refused(row[2], function() tcl(tcl_head .. row[1]) end)
  end
  for text, words in pairs { ["node 1 0 0 0"] = "1: the command stands before: model",
    [tcl_head] = "has no node that was read",
    ["proc frame {} { node 1 0 0 }"] = "it calls no command of OpenSees: if its functions do, give the file that calls "
      .. "them",
    ["model Tcl2dTruss"] = "1: the number of dimensions is missing: model basic -ndm 2, or -ndm 3" } do
    refused(words, function() tcl(text) end)
  end
  for _, row in ipairs {
    { "x = (1,\n  2\n", "5: SyntaxError: '(' was never closed" }, { "x = 1)", "5: SyntaxError: unmatched ')'" },
    { "x = 'a\n", "5: SyntaxError: unterminated string literal" },
    { "x = 1\n  y = 2", "6: IndentationError: unexpected indent" },
    { "if 1:\n    x = 1\n  y = 2", "7: IndentationError: unindent does not match" }, { "x = 1 ? 2",
      "5: SyntaxError: invalid syntax" },
    { "\nnode(1, 0, 0)", "6: node 1 has 2 coordinates" }, { "for i in [1]:\n  fix(9, *[1] * 6)",
      "6: node 9 is not there" },
  } do
    refused(row[2], function() python(python_head .. row[1]) end)
  end
  refused("field 'units' is missing; the file does not say its units", import.tcl, { file = "frame.tcl" })
  refused("units.force is 'newton'; must be one of N, kN", function() tcl("", { length = "m", force = "newton" }) end)
end)

checks.done()
