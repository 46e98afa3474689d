-- hinge.import.tcl: whole frames of OpenSees as text against what is written by hand, in the plane and in space, in Tcl
-- and in Python: every node, material, section, member, load and mass with its numbers in SI.
--
-- Run: lua5.4 tests/script/import/import_opensees_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local frame_text = require "import.frame_text"
require "hinge"
local import = require "hinge.import"
local checks = support.checks "frames of OpenSees"
local case, near, equal = checks.case, checks.near, checks.equal
local dump = frame_text.of
local function same_lines(found, wanted, what) frame_text.same(equal, found, wanted, what) end

local write = support.writer()

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
      same_lines(dump(frame), plane_as_text, name)
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
section Elastic 1 200 2 0.3 0.4 80 0.5
element elasticBeamColumn 1 1 2 2 200 80 0.5 0.4 0.3 1
element dispBeamColumn 2 2 3 1 Legendre 1 3 -mass 7
element ElasticTimoshenkoBeam 3 1 3 200 80 2 0.5 0.4 0.3 1.5 1.2 1
beamIntegration Lobatto 4 1 5
element forceBeamColumn 4 3 2 2 4
pattern Plain 1 Constant { load 2 1 2 3 4 5 6 }
pattern Plain 2 Linear { eleLoad -range 1 2 -type -beamUniform 1 2 3
eleLoad -ele 3 -type -beamUniform 4 5 }
mass 2 3 3 3 1 2 4
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
member 1 a=1 b=2 section=element 1 material=element 1 up={0 1 0}
member 2 a=2 b=3 section=element 1 material=section 1 up={0 1 0}
member 3 a=1 b=3 section=element 3 material=element 1 up={0 1 0}
member 4 a=3 b=2 section=element 1 material=element 1 up={0 0.6 0.8}
case pattern 1
  load node=2 force={1 2 3} moment={0.004 0.005 0.006}
case pattern 2
  load member=1 q={1000 2000 3000} axes=local
  load member=2 q={1000 2000 3000} axes=local
  load member=3 q={4000 5000 0} axes=local
mass 2 mass=3000 inertia={0.001 0.002 0.004}
]]

case("OpenSees: a frame in space in mm and N, row by row", function()
  local frame, notes = import.tcl { file = write("space.tcl", space_tcl), units = { length = "mm", force = "N" } }
  same_lines(dump(frame), space_as_text, "Tcl")
  equal(#notes, 0, tostring(notes))
  local heavy = import.tcl { file = write("space.tcl", space_tcl), units = { length = "mm", force = "N", mass = 5 } }
  near(heavy.masses[1].mass, 15, 1e-12, "a unit of mass that is given")
end)

checks.done()
