-- hinge.import.s2k: ends of members and joints in files of SAP2000, against formulas by hand. Insertion points,
-- joint offsets, rigid ends, loads along members; diaphragms, bodies, equal displacements, springs, floors.
--
-- Run: lua5.4 tests/script/import/import_offsets_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local files = require "import.files"
local hinge = require "hinge"
local import = require "hinge.import"
local frame_module = require "hinge.import.frame"
local checks = support.checks "ends and joints of import"
local case, near, equal, expect, refused = checks.case, checks.near, checks.equal, checks.expect, checks.refused

local write = support.writer()

local E, G, small = 210e9, 210e9 / 2.6, { model = { displacement = "small" } }
local density, g = 7850, 9.80665

-- A column of 3 m, 0.4 by 0.2 m, axis 2 along X. more: further tables; joint: a third joint on its axis. Both ends have
-- a stub without load and weight, so that no joint is left with ends beside it alone.
local A, I, As = 0.08, 1e-3, 0.05 -- I and As for bending in the plane of X and Z
local function column(more, options)
  options = options or {}
  local joint = options.joint and ("   Joint=3   XorR=0   Y=0   Z=%g\n"):format(options.joint) or ""
  local frame, notes = import.s2k { file = write("frame.s2k", files.sap { weight = options.weight, section =
    "Shape=General   t3=0.4   t2=0.2   Area=0.08   TorsConst=1E-3   I33=1E-3   I22=3E-4   AS2=0.05   AS3=0.06",
    more = [[
TABLE:  "JOINT COORDINATES"
   Joint=8   XorR=0   Y=5   Z=0
   Joint=9   XorR=0   Y=5   Z=3
]] .. joint .. [[
TABLE:  "MATERIAL PROPERTIES 02 - BASIC MECHANICAL PROPERTIES"
   Material=light   UnitMass=0   E1=210000000   U12=0.3
TABLE:  "CONNECTIVITY - FRAME"
   Frame=8   JointI=1   JointJ=8
   Frame=9   JointI=2   JointJ=9
TABLE:  "FRAME SECTION ASSIGNMENTS"
   Frame=8   AnalSect=A   MatProp=light
   Frame=9   AnalSect=A   MatProp=light
]] .. more }) }
  return frame, notes
end

local at_head = 'TABLE:  "JOINT LOADS - FORCE"\n   Joint=2   LoadPat=DEAD   CoordSys=GLOBAL   F1=%g   F2=0   F3=%g\n'
local function rigid(i, j, factor, kind)
  return ('TABLE:  "FRAME OFFSET ALONG LENGTH ASSIGNMENTS"\n   Frame=1   Type=%s   LengthI=%g   LengthJ=%g   '
    .. 'RigidFactor=%g\n'):format(kind or "User", i, j, factor)
end
local function point(fields) return 'TABLE:  "FRAME INSERTION POINT ASSIGNMENTS"\n   Frame=1   ' .. fields .. "\n" end

local function spread(fields)
  return 'TABLE:  "FRAME LOADS - DISTRIBUTED"\n   Frame=1   LoadPat=DEAD   CoordSys=GLOBAL   Type=Force   ' .. fields
    .. "\n"
end

-- Displacements of the head and reactions of the foot.
local function solved(frame, options)
  local model, nodes = import.build(frame, { model = small.model, self_weight = options and options.self_weight })
  local run = model:static { steps = 1, loads = { DEAD = 1 } }:finish()
  local ux, _, uz = nodes["2"]:displacement(run)
  local fx, fy, fz, mx, my, mz = nodes["1"]:reaction(run)
  return ux, uz, { fx, fy, fz, mx, my, mz }
end

-- Rigid ends ----------------------------------------------------------------------------------------------------------

-- A cantilever with rigid parts below and above its length L, of which the upper one is e.
local function by_hand(F, L, e)
  local tip = F * L ^ 3 / (3 * E * I) + F * e * L ^ 2 / (2 * E * I) + F * L / (G * As)
  return tip + e * (F * L ^ 2 / (2 * E * I) + F * e * L / (E * I))
end

case("rigid ends stiffen a cantilever as by hand, divided or not", function()
  for _, joint in ipairs { false, 1.5 } do
    for _, row in ipairs { { 0, 0, 1 }, { 0.5, 0.3, 1 }, { 0.5, 0.3, 0.8 }, { 0, 0.3, 0.5 } } do
      local frame, notes = column(rigid(row[1], row[2], row[3]) .. at_head:format(10, 0), { joint = joint })
      equal(#notes, 0, tostring(notes))
      local i, j = row[1] * row[3], row[2] * row[3]
      local wanted = by_hand(10e3, 3 - i - j, j)
      near(solved(frame), wanted, 1e-8 * wanted, ("%g, %g times %g"):format(row[1], row[2], row[3]))
    end
  end
end)

-- The engine has no joint at which no member ends.
case("a joint with ends beside it alone goes to the nearest one, with its forces and masses", function()
  local text = rigid(0.5, 0.3, 1) .. 'TABLE:  "FRAME OFFSET ALONG LENGTH ASSIGNMENTS"\n   Frame=8   Type=User   '
    .. "LengthI=0.6   LengthJ=0   RigidFactor=1\n   Frame=9   Type=User   LengthI=0.1   LengthJ=0   RigidFactor=1\n"
  local frame, notes = column(text .. at_head:format(10, 7), { weight = "1" })
  equal(#notes, 0, tostring(notes))
  expect(tostring(notes):find("2 joints at which all members end beside the joint", 1, true), "%s", tostring(notes))
  local node, member = frame_module.by_name(frame.nodes), frame_module.by_name(frame.members)
  near(node["1"].z, 0.5, 1e-12, "the foot is at the column's end")
  near(node["2"].y, 0.1, 1e-12, "the head is at the stub's end")
  local a, b = frame_module.ends(member["1"], node)
  near(a.z, 0.5, 1e-12, "the column's foot")
  near(b.z, 2.7, 1e-12, "the column's head")
  near(b.y, 0, 1e-12, "the column's head")
  -- the head moves by the column alone; about X it has the moment of 7 kN with no arm, for the load is on the joint
  for _, way in ipairs { "gravity", "loads" } do
    local ux, _, r = solved(frame, { self_weight = way })
    near(ux, by_hand(10e3, 2.2, 0.3), 1e-9, "sway, " .. way)
    near(r[3], density * g * A * 3 - 7e3, 1e-3, "weight, " .. way)
    near(r[4], 0, 1e-3, "moment about X, " .. way)
  end
end)

case("rigid ends longer than the member are noted, and left out", function()
  for _, lengths in ipairs { { 2, 1.5 }, { 3, 0 } } do
    local frame, notes = column(rigid(lengths[1], lengths[2], 1) .. at_head:format(10, 0))
    equal(#notes, 1, tostring(notes))
    expect(notes[1].reason:find "longer than the member", "%s", tostring(notes))
    near(solved(frame), by_hand(10e3, 3, 0), 1e-9, "sway")
  end
end)

case("the weight of rigid ends is not lost, whichever way it acts", function()
  for _, way in ipairs { "gravity", "loads" } do
    local frame, notes = column(rigid(0.5, 0.3, 1) .. at_head:format(0, 0), { weight = "1.2" })
    local _, _, r = solved(frame, { self_weight = way })
    near(r[3], 1.2 * density * g * A * 3, 1e-3, way)
    local s = notes.summary
    near(s.mass_of_members + s.mass_of_nodes, density * A * 3, 1e-9, "mass")
    expect(tostring(notes):find(("mass of %.4g kg is on the joints"):format(density * A * 0.8), 1, true), "%s",
      tostring(notes))
  end
end)

-- Insertion points ----------------------------------------------------------------------------------------------------

case("a column on its edge: a force on the joint bends it by half its depth", function()
  for number, e in pairs { [8] = 0.2, [2] = -0.2, [10] = 0, [5] = 0, [7] = 0.2, [3] = -0.2 } do
    local frame, notes = column(point(('CardinalPt="%d (of eleven)"   Mirror2=No   Transform=Yes'):format(number))
      .. at_head:format(0, -100))
    equal(#notes, 0, tostring(notes))
    local ux, uz = solved(frame)
    near(ux, 100e3 * e * 9 / (2 * E * I), 1e-9, ("sway of %d"):format(number))
    local column_left = number == 7 and 0.1 or number == 3 and 0.1 or 0 -- about the other axis, with 3e-4 m^4
    near(uz, -100e3 * (3 / (E * A) + e ^ 2 * 3 / (E * I) + column_left ^ 2 * 3 / (E * 3e-4)), 1e-9,
      ("shortening of %d"):format(number))
  end
end)

case("left is towards axis 3: points 4 and 6 of a beam along X are to the side of -Y and of Y", function()
  local axis3 = { 0, -1, 0 } -- axis 1 is X, axis 2 is Z, axis 3 = 1 x 2
  local x = frame_module.axes({ 1, 0, 0 })
  for i = 1, 3 do near(x[i], -axis3[i], 1e-12, "axis 3 is -x") end
  local frame = column(point "CardinalPt=4   Transform=Yes" .. at_head:format(1, 0))
  local by = frame.members[1].offset.a -- of the column, whose axis 3 is Y: its left edge is at the joint
  near(by[2], -0.1, 1e-12, "the column is on the side of -Y")
  near(by[1], 0, 1e-12, "along X")
end)

case("a stiffness that is not transformed: the member goes from joint to joint, and the note says so", function()
  for _, field in ipairs { "Transform", "StiffTrans" } do
    local frame, notes = column(point(("CardinalPt=8   %s=No"):format(field)) .. at_head:format(0, -100))
    equal(#notes, 0, tostring(notes))
    expect(tostring(notes.assumed[1].reason):find "not transformed", "%s", tostring(notes))
    near(solved(frame), 0, 1e-12, "sway")
  end
end)

case("joint offsets in space and along the member's axes", function()
  local function offset(fields) return column(point(fields) .. at_head:format(1, 0)).members[1].offset end
  local both = offset "CardinalPt=10   JtOffXI=0.1   JtOffZI=-0.2   JtOff3J=0.3"
  for i, wanted in ipairs { 0.1, 0, -0.2 } do near(both.a[i], wanted, 1e-12, "a") end
  for i, wanted in ipairs { 0, 0.3, 0 } do near(both.b[i], wanted, 1e-12, "b") end -- axis 3 of the column is Y
end)

case("a point that is none is refused with its line", function()
  refused(("frame.s2k:%d: CardinalPt is '12'; must be a number from 1 to 11"):format(files.sap_head + 13), column,
    point "CardinalPt=12" .. at_head:format(0, 0))
end)

-- Loads ---------------------------------------------------------------------------------------------------------------

-- Force along X, and moment about Y at the origin, of all loads of a frame: each by its own integral.
local function together(frame)
  local node, member, F, M = frame_module.by_name(frame.nodes), frame_module.by_name(frame.members), 0, 0
  for _, l in ipairs(frame.cases[1].loads) do
    if l.node then
      local n = node[l.node]
      local f = l.force or { 0, 0, 0 }
      F, M = F + f[1], M + n.z * f[1] - n.x * f[3] + (l.moment and l.moment[2] or 0)
    elseif l.force then
      local a, b = frame_module.ends(member[l.member], node)
      F, M = F + l.force[1], M + (a.z + l.at * (b.z - a.z)) * l.force[1]
    elseif l.moment then
      M = M + l.moment[2]
    else
      local a, b = frame_module.ends(member[l.member], node)
      local from, to = a.z + (l.from or 0) * (b.z - a.z), a.z + (l.to or 1) * (b.z - a.z)
      local qa, qb = (l.q.a or l.q)[1], (l.q.b or l.q)[1]
      F = F + (qa + qb) / 2 * (to - from)
      M = M + (to - from) / 6 * (qa * (2 * from + to) + qb * (from + 2 * to)) -- a trapezoid as two triangles
    end
  end
  return F, M
end

case("trapezoids over a part: force and moment as in the file, with rigid ends and joints on the member", function()
  for _, row in ipairs { { 0, 3, 1, 1 }, { 0, 3, 0, 4 }, { 0.4, 2.2, 2, 5 }, { 0.1, 0.3, 1, 1 }, { 0.2, 2.9, -1, 3 },
    { 2.75, 3, 2, 1 } } do
    for _, more in ipairs { "", rigid(0.5, 0.3, 1), point "CardinalPt=8" .. rigid(0.5, 0.3, 0.7) } do
      for _, joint in ipairs { false, 1.5 } do
        local a, b, p, q = table.unpack(row)
        local frame, notes = column(more .. spread(("Dir=X   DistType=RelDist   RelDistA=%.15g   RelDistB=%.15g   "
          .. "AbsDistA=7   AbsDistB=7   FOverLA=%g   FOverLB=%g"):format(a / 3, b / 3, p, q)), { joint = joint })
        equal(#notes, 0, tostring(notes))
        local F, M = together(frame)
        local mean = (p + q) / 2 * (b - a) * 1e3
        near(F, mean, 1e-9 * 1e4, "force")
        -- the first moment of a trapezoid: uniform p, and a triangle to q - p
        near(M, 1e3 * (p * (b ^ 2 - a ^ 2) / 2 + (q - p) * (b - a) * (a + 2 * (b - a) / 3) / 2), 1e-5, "moment")
      end
    end
  end
end)

case("a distance in units of the file, and loads beside the member", function()
  local frame = column(spread "Dir=X   DistType=AbsDist   AbsDistA=1   AbsDistB=2   FOverLA=3   FOverLB=3")
  local load = frame.cases[1].loads[1]
  near(load.from, 1 / 3, 1e-12, "from")
  near(load.to, 2 / 3, 1e-12, "to")
  equal(load.q[1], 3e3, "q")
  refused("RelDistB is 1.5; the load is beside the member", column,
    spread "Dir=X   RelDistA=0   RelDistB=1.5   FOverLA=3   FOverLB=3")
end)

case("forces and moments at a point of a member", function()
  for _, joint in ipairs { false, 1.5 } do
    for _, at in ipairs { 0, 0.1, 0.5, 0.7, 0.95, 1 } do
      local fields = ([[
TABLE:  "FRAME LOADS - POINT"
   Frame=1   LoadPat=DEAD   CoordSys=GLOBAL   Type=Force   Dir=X   DistType=RelDist   RelDist=%g   Force=8
   Frame=1   LoadPat=DEAD   CoordSys=GLOBAL   Type=Moment   Dir=Y   DistType=RelDist   RelDist=%g   Moment=5
]]):format(at, at)
      local frame, notes = column(rigid(0.5, 0.3, 1) .. fields, { joint = joint })
      equal(#notes, 0, tostring(notes))
      local F, M = together(frame)
      near(F, 8e3, 1e-6, "force")
      near(M, 8e3 * 3 * at + 5e3, 1e-6, ("moment at %g"):format(at))
    end
  end
end)

-- Constraints, springs, floors ----------------------------------------------------------------------------------------

-- Two posts of 3 m with their heads at joints 2 and 4; joint 5 has no member.
local function posts(more)
  local section = "Shape=General   Area=0.01   TorsConst=1E-06 _\n   I33=1E-04   I22=2E-05   AS2=0.004   AS3=0.005"
  return import.s2k { file = write("frame.s2k", files.sap { section = section, more = files.push(10) .. [[
TABLE:  "JOINT COORDINATES"
   Joint=3   XorR=5   Y=0   Z=0
   Joint=4   XorR=5   Y=0   Z=3
   Joint=5   XorR=5   Y=4   Z=3
TABLE:  "JOINT RESTRAINT ASSIGNMENTS"
   Joint=3   U1=Yes   U2=Yes   U3=Yes   R1=Yes   R2=Yes   R3=Yes
TABLE:  "FRAME SECTION PROPERTIES 01 - GENERAL"
   SectionName=list   Material=S   Shape="Auto Select"
TABLE:  "CONNECTIVITY - FRAME"
   Frame=2   JointI=3   JointJ=4
TABLE:  "FRAME SECTION ASSIGNMENTS"
   Frame=2   AnalSect=A
]] .. (more or "") }) }
end

local alone = 10e3 * (27 / (3 * E * 1e-4) + 3 / (G * 0.004)) -- the sway of one post by itself, m

-- Displacements of joints along X.
local function moved(frame, ...)
  local model, nodes = import.build(frame, small)
  local run = model:static { steps = 1, loads = { DEAD = 1 } }:finish()
  local list = {}
  for i, name in ipairs { ... } do list[i] = (nodes[name]:displacement(run)) end
  return table.unpack(list)
end

case("diaphragms and bodies tie the heads of two posts, equal displacements are held with one of them", function()
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
   Frame=3   AnalSect=A
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
   Frame=3   AnalSect=A
TABLE:  "FRAME RELEASE ASSIGNMENTS 1 - GENERAL"
   Frame=1   TJ=Yes   M2J=Yes   M3J=Yes
   Frame=2   TJ=Yes   M2J=Yes   M3J=Yes
   Frame=3   M2I=Yes   M3I=Yes   M2J=Yes   M3J=Yes
]]
  local frame, notes = posts(tables)
  expect(tostring(notes):find("at 2 joints all ends are released", 1, true), "%s", tostring(notes))
  -- two cantilevers side by side, but for the bar's axial strain
  local bar = E * 0.01 / 5
  local post = 10e3 / alone
  near(moved(frame, "2"), 10e3 * (post + bar) / (post * (post + 2 * bar)), 1e-7, "sway")
end)

case("springs to the ground, by their own stiffness", function()
  local spring = 'TABLE:  "JOINT SPRING ASSIGNMENTS 1 - UNCOUPLED"\n   Joint=2   U1=500   U2=0   R1=0\n'
  local frame, notes = posts(spring)
  equal(#notes, 1, tostring(notes))
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
    .. "LIVE 30 kN, their own weight 76.98 kN", "the note")
end)

case("a floor between members gives them its loads and its weight", function()
  local frame, notes = posts [[
TABLE:  "LOAD PATTERN DEFINITIONS"
   LoadPat=LIVE   DesignType=Live   SelfWtMult=0
   LoadPat=OWN   DesignType=Dead   SelfWtMult=2
TABLE:  "JOINT COORDINATES"
   Joint=6   XorR=0   Y=4   Z=3
TABLE:  "CONNECTIVITY - FRAME"
   Frame=3   JointI=2   JointJ=4
   Frame=4   JointI=4   JointJ=5
   Frame=5   JointI=6   JointJ=5
   Frame=6   JointI=6   JointJ=2
TABLE:  "FRAME SECTION ASSIGNMENTS"
   Frame=3   AnalSect=A
   Frame=4   AnalSect=A
   Frame=5   AnalSect=A
   Frame=6   AnalSect=A
TABLE:  "CONNECTIVITY - AREA"
   Area=1   NumJoints=4   Joint1=2   Joint2=4   Joint3=5   Joint4=6
   Area=2   NumJoints=4   Joint1=1   Joint2=3   Joint3=4   Joint4=2
TABLE:  "AREA SECTION PROPERTIES"
   Section=slab   Material=S   AreaType=Shell   Type=Membrane   Thickness=0.1   Color=Green
TABLE:  "AREA SECTION ASSIGNMENTS"
   Area=1   Section=slab   MatProp=Default
TABLE:  "AREA LOADS - UNIFORM TO FRAME"
   Area=1   LoadPat=LIVE   CoordSys=GLOBAL   Dir=Gravity   UnifLoad=3   DistType="Two way"
TABLE:  "AREA LOADS - UNIFORM"
   Area=1   LoadPat=LIVE   CoordSys=GLOBAL   Dir=Z   UnifLoad=-1
   Area=2   LoadPat=LIVE   CoordSys=GLOBAL   Dir=Gravity   UnifLoad=1
]]
  equal(#notes, 1, tostring(notes))
  expect(notes[1].reason:find("1 area of 15 m^2 in all", 1, true), "the wall: %s", notes[1].reason)
  local assumed = notes.assumed[#notes.assumed].reason
  expect(assumed:find("1 area of 20 m^2 in all", 1, true), "the floor: %s", assumed)
  local model, _, members = import.build(frame, small)
  local own = hinge.model { displacement = "small" } -- the same floor by model:floor
  local corner, list = {}, {}
  for i, p in ipairs { { 0, 0 }, { 5, 0 }, { 5, 4 }, { 0, 4 } } do corner[i] = own:node { p[1], p[2], 3 } end
  own:fix(corner)
  for i, node in ipairs(corner) do
    list[i] = own:member { node, corner[i % 4 + 1], section = members["3"].section, material = members["3"].material,
      up = { 0, 0, 1 }, group = "beams" }
  end
  local floor, sum = own:floor { group = "beams", load = 4e3 }, { LIVE = 0, OWN = 0, DEAD = 0 }
  for _, c in ipairs(frame.cases) do
    for _, l in ipairs(c.loads) do
      if l.q then
        sum[c.name] = sum[c.name] - (l.q.a[3] + l.q.b[3]) / 2 * ((l.to or 1) - (l.from or 0))
          * members[l.member].length
      end
    end
  end
  near(sum.LIVE, 80e3, 1e-6, "live load, N")
  near(sum.OWN, 2 * 76.98e3 * 20 * 0.1, 10, "twice its own weight, N")
  near(floor.load, 80e3, 1e-6, "by model:floor, N")
  model:fix(model:nodes())
  local of_file, of_floor = model:static { loads = "LIVE" }:finish(), own:static {}:finish()
  near(math.abs(members["3"]:forces(of_file).Mx), math.abs(list[1]:forces(of_floor).Mx), 1e-6, "moment, long beam")
  near(math.abs(members["6"]:forces(of_file).Mx), math.abs(list[2]:forces(of_floor).Mx), 1e-6, "moment, short beam")
end)

checks.done()
