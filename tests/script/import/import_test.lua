-- hinge.import: one space frame by hand, from text tables of SAP2000, from OpenSees in Tcl and in Python, and from CSV
-- gives the same numbers; so does the script that import.write writes. Units, local axes, plane frames, releases and
-- self weight by closed forms. What is not read is in the notes with its line; broken files are refused with the line.
--
-- Run: lua5.4 tests/script/import/import_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local hinge = require "hinge"
local import = require "hinge.import"
local checks = support.checks "import"
local case, near, equal, expect = checks.case, checks.near, checks.equal, checks.expect

local samples = support.folder .. "import/"
local folder = support.temporary_folder() .. "/"
local E, G = 210e9, 210e9 / 2.6
local small = { model = { displacement = "small" } }

local function write(name, text)
  support.write(folder .. name, text)
  return folder .. name
end

local function tcl(text, units)
  return import.tcl { file = write("frame.tcl", text), units = units or { length = "m", force = "N" } }
end

local function python(text, units)
  return import.tcl { file = write("frame.py", text), units = units or { length = "m", force = "N" },
    run_python = true }
end

local function s2k(text) return import.s2k { file = write("frame.s2k", text) } end

local function read_csv()
  return import.csv { nodes = samples .. "nodes.csv", members = samples .. "members.csv",
    sections = samples .. "sections.csv", materials = samples .. "materials.csv", supports = samples .. "supports.csv",
    loads = samples .. "loads.csv" }
end

-- The entry of a list of notes at a line, or nil.
local function at_line(list, line)
  for _, entry in ipairs(list) do
    if entry.line == line then return entry end
  end
end

-- One frame in many forms ---------------------------------------------------------------------------------------------

-- The frame of the samples by hand: 2 bays of 6 m along x, 1 of 5 m along y, 2 storeys of 3.5 m.
local function by_hand()
  local model = hinge.model { displacement = "small" }
  local steel = hinge.material { E = E, G = G, density = 7850 }
  local column = hinge.section.general { area = 0.0149, Ix = 2.517e-4, Iy = 8.563e-5, J = 1.85e-6,
    shear_area_x = 0.0095, shear_area_y = 0.0035 }
  local beam = hinge.section.general { area = 0.00845, Ix = 2.313e-4, Iy = 1.318e-5, J = 5.1e-7,
    shear_area_x = 8.45, shear_area_y = 8.45 } -- no shear strain: 1000 times the area
  local dead, wind = model:case "dead", model:case "wind"
  local n, m = {}, {}
  for k = 0, 2 do
    for j = 0, 1 do
      for i = 0, 2 do n[#n + 1] = model:node { 6 * i, 5 * j, 3.5 * k } end
    end
  end
  for i = 1, 6 do model:fix(n[i], i == 3 and "x,y,z,rz" or "all") end
  local turned = { math.cos(math.pi / 6), math.sin(math.pi / 6), 0 }
  for i = 1, 12 do
    m[i] = model:member { n[i], n[i + 6], section = column, material = steel, up = i == 8 and turned or { 1, 0, 0 } }
  end
  for level = 1, 2 do
    for j = 0, 1 do
      for i = 0, 1 do
        local a = 1 + i + 3 * j + 6 * level
        m[#m + 1] = model:member { n[a], n[a + 1], section = beam, material = steel }
        dead:load { member = m[#m], q = { 0, 0, -12e3 } }
      end
    end
    for a = 1 + 6 * level, 3 + 6 * level do
      m[#m + 1] = model:member { n[a], n[a + 3], section = beam, material = steel }
    end
  end
  wind:load { node = n[7], force = { 20e3, 0, 0 } }
  wind:load { node = n[13], force = { 35e3, 0, 0 }, moment = { 0, 0, 4e3 } }
  wind:load { node = n[18], force = { 12e3, 5e3, 0 } }
  wind:load { member = m[2], q = { -1e3, -3e3, 0 }, axes = "local" }
  return model, n
end

-- Displacements, rotations, forces and moments of all nodes under each case: four lists.
local function numbers(model, node_of, cases)
  local lists = { {}, {}, {}, {} }
  for _, name in ipairs(cases) do
    local run = model:static { steps = 1, loads = { [name] = 1 } }:finish()
    equal(run.verdict, "completed", name)
    for i = 1, 18 do
      local u, r = { node_of(i):displacement(run) }, { node_of(i):reaction(run) }
      for k = 1, 6 do
        table.insert(lists[k <= 3 and 1 or 2], u[k])
        table.insert(lists[k <= 3 and 3 or 4], r[k])
      end
    end
  end
  return lists
end

local hand_model, hand_nodes = by_hand()
local hand
case("by hand: the frame moves, and its supports carry the loads", function()
  hand = numbers(hand_model, function(i) return hand_nodes[i] end, { "dead", "wind" })
  local largest = 0
  for _, u in ipairs(hand[1]) do largest = support.largest_of(largest, math.abs(u)) end
  expect(largest > 1e-3, "the largest displacement is %g m", largest)
  local up = 0
  for i = 1, 18 do up = up + hand[3][3 * i] end
  near(up, 12e3 * 6 * 8, 1e-3, "the sum of the vertical reactions under dead load, N")
end)

-- Compares with the numbers by hand: each within 1e-9 of the largest of its kind.
local function same_numbers(what, model, node_of, cases)
  local found = numbers(model, node_of, cases)
  for kind, name in ipairs { "displacement", "rotation", "force", "moment" } do
    local largest, worst = 0, 0
    for i, wanted in ipairs(hand[kind]) do
      largest = support.largest_of(largest, math.abs(wanted))
      worst = support.largest_of(worst, math.abs(found[kind][i] - wanted))
    end
    equal(#found[kind], #hand[kind], what .. ": how many")
    expect(worst <= 1e-9 * largest, "%s: a %s differs by %g of the largest", what, name, worst / largest)
  end
end

local sap_cases, opensees_cases = { "DEAD", "WIND X" }, { "pattern 1", "pattern 2" }
local readers = {
  { "SAP2000", sap_cases, function() return import.s2k { file = samples .. "frame.s2k" } end },
  { "SAP2000 in kip and in", sap_cases, function() return import.s2k { file = samples .. "frame_kip.s2k" } end },
  { "OpenSees", opensees_cases, function()
    return import.tcl { file = samples .. "frame.tcl", units = { length = "m", force = "kN", mass = "t" } }
  end },
  { "OpenSeesPy", opensees_cases, function()
    return import.tcl { file = samples .. "frame.py", units = { length = 1, force = "N" }, run_python = true }
  end },
  { "CSV", sap_cases, read_csv },
  { "ETABS", sap_cases, function() return import.e2k { file = samples .. "frame.e2k" } end,
    node = function(i)
      return ("%d@%s"):format((i - 1) % 6 + 1, i <= 6 and "Base" or i <= 12 and "Storey 1" or "Storey 2")
    end,
    member = { ["8"] = "C2@Storey 2", ["26"] = "B7@Storey 2" } },
}

for _, reader in ipairs(readers) do
  local what, cases, node, member = reader[1], reader[2], reader.node or tostring, reader.member or {}
  local turned, last = member["8"] or "8", member["26"] or "26"
  case(what .. ": the numbers of the frame by hand, also of the written script", function()
    local frame, notes = reader[3]()
    equal(#notes, 0, "nothing is left unread: " .. tostring(notes))
    local s = notes.summary
    equal(("%d %d %d %d"):format(s.nodes, s.members, s.sections, s.cases), "18 26 2 2", "nodes, members and so on")
    near(s.length, 12 * 3.5 + 8 * 6 + 6 * 5, 1e-9, "length of all members, m")
    near(s.mass_of_members, 7850 * (42 * 0.0149 + 78 * 0.00845), 1e-6, "mass, kg")
    local model, nodes, members = import.build(frame, small)
    near(members[turned].up[2] / members[turned].up[1], math.tan(math.pi / 6), 1e-12, "the turned column")
    same_numbers(what, model, function(i) return nodes[node(i)] end, cases)
    import.write(frame, folder .. "written.lua", small)
    local again, its_nodes, its_members = dofile(folder .. "written.lua")
    same_numbers(what .. ", written", again, function(i) return its_nodes[node(i)] end, cases)
    equal(its_members[last].b.x, members[last].b.x, "a member of the script by its name")
    equal(its_members[last].group, members[last].group, "its group")
  end)
end

case("the written script can be read: a line for each node and member, and luacheck's width", function()
  import.write(read_csv(), folder .. "written.lua", { model = { displacement = "small", plasticity = false } })
  local text = support.read(folder .. "written.lua")
  for _, piece in ipairs { "hinge.model { displacement = \"small\", plasticity = false }", '\n  { "7", 0, 0, 3.5 },\n',
    '\n  { "3", 12, 0, 0, "x,y,z,rz" },\n', '\n  { "13", "7", "8", "BEAM", "steel", group = "beams" },\n',
      "E = 2.1e11" } do
    expect(text:find(piece, 1, true), "the script has not: %s", piece)
  end
  for line in text:gmatch "[^\n]+" do expect(#line <= 120, "a long line: %s", line) end
end)

case("numbers and names come through a script as they are", function()
  local odd = "a \"b\"\n\\c"
  local x = 0.1 + 0.2
  local frame = { nodes = { { name = odd, x = x, y = -1e-20, z = 1e6 + 0.125, fix = "all" },
    { name = "end", x = x + 1, y = 0, z = 1e6 + 0.125 } },
    materials = { { name = "m", E = 123456789012345678 } },
    sections = { { name = "s", area = 1, Ix = 1 / 3, Iy = 2e-3, J = 1e-3 }, { name = "HEB 200", named = "HEB 200" } },
    members = { { name = odd, a = odd, b = "end", section = "s", material = "m" },
      { name = "2", a = odd, b = "end", section = "HEB 200", material = "m", up = { 0, 1, 0 } } } }
  import.write(frame, folder .. "odd.lua")
  local _, nodes, members = dofile(folder .. "odd.lua")
  local node = nodes[odd]
  equal(("%a %a %a"):format(node.x, node.y, node.z), ("%a %a %a"):format(x, -1e-20, 1e6 + 0.125), "a node")
  equal(members[odd].section.Ix, 1 / 3, "a section")
  equal(members[odd].material.E, 123456789012345678.0, "a material")
  equal(members["2"].section.kind, "HEB 200", "a section by its name")
end)

-- SAP2000 -------------------------------------------------------------------------------------------------------------

-- A file with a frame from joint 1, which is fixed, to joint 2; `more`: further tables.
local function sap(options)
  local o = options or {}
  return ([[
TABLE:  "PROGRAM CONTROL"
   ProgramName=%s   CurrUnits="%s"
TABLE:  "JOINT COORDINATES"
   Joint=1   CoordSys=GLOBAL   CoordType=Cartesian   XorR=0   Y=0   Z=0
   Joint=2   CoordSys=GLOBAL   CoordType=Cartesian   %s
TABLE:  "CONNECTIVITY - FRAME"
   Frame=1   JointI=1   JointJ=2   IsCurved=No
TABLE:  "JOINT RESTRAINT ASSIGNMENTS"
   Joint=1   U1=Yes   U2=Yes   U3=Yes   R1=Yes   R2=Yes   R3=Yes
TABLE:  "MATERIAL PROPERTIES 02 - BASIC MECHANICAL PROPERTIES"
   Material=S   UnitWeight=76.9822025   UnitMass=7.85   E1=210000000   U12=0.3
TABLE:  "FRAME SECTION PROPERTIES 01 - GENERAL"
   SectionName=A   Material=S   %s
TABLE:  "FRAME SECTION ASSIGNMENTS"
   Frame=1   AnalSect=A   MatProp=Default
TABLE:  "LOAD PATTERN DEFINITIONS"
   LoadPat=DEAD   DesignType=Dead   SelfWtMult=%s
%s]]):format(o.program or "SAP2000", o.units or "KN, m, C", o.at or "XorR=0   Y=0   Z=3", o.section
    or "Shape=General   Area=0.01   TorsConst=1e-6   I33=2e-4   I22=5e-5   AS2=0   AS3=0", o.weight or "0",
      o.more or "")
end

local head = 17 -- lines before `more`

-- Displacement of joint 2 under the case DEAD.
local function tip(frame)
  local model, nodes = import.build(frame, small)
  return nodes["2"]:displacement(model:static { steps = 1, loads = { DEAD = 1 } }:finish())
end

local push = 'TABLE:  "JOINT LOADS - FORCE"\n   Joint=2   LoadPat=DEAD   CoordSys=GLOBAL   F1=1   F2=0   F3=0\n'

case("local axes: axis 2 of a column is along X, and the angle turns it towards axis 3", function()
  -- F = 1 kN on a cantilever of 3 m: u = F L^3 / (3 E I) + F L / (G A_s) in each principal direction; a shear area of 0
  -- has become 1000 times the area. 1e-7: rounding with shear that is so stiff
  local shear = 1e3 * 3 / (G * 1000 * 0.01)
  local u33, u22 = 1e3 * 27 / (3 * E * 2e-4) + shear, 1e3 * 27 / (3 * E * 5e-5) + shear
  for _, angle in ipairs { 0, 30, 90, -45 } do
    for _, name in ipairs { "FRAME LOCAL AXES 1 - TYPICAL", "FRAME LOCAL AXES ASSIGNMENTS 1 - TYPICAL" } do
      local more = push .. ('TABLE:  "%s"\n   Frame=1   Angle=%g   AdvanceAxes=No\n'):format(name, angle)
      local x, y = tip((s2k(sap { more = more })))
      local c, s = math.cos(math.rad(angle)), math.sin(math.rad(angle))
      near(x, u33 * c * c + u22 * s * s, 1e-7 * u22, angle .. " degrees: along x, m")
      near(y, (u33 - u22) * c * s, 1e-7 * u22, angle .. " degrees: along y, m")
    end
  end
  -- along Y axis 2 is Z, so that axis 3 = Y x Z is X; turned by 90 degrees axis 2 is X
  local along_y = 'TABLE:  "FRAME LOCAL AXES 1 - TYPICAL"\n   Frame=1   Angle=90\n'
  local x = tip((s2k(sap { at = "XorR=0 Y=3 Z=0", more = push .. along_y })))
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
    local frame = s2k(sap { units = text, more = push })
    near(frame.nodes[2].z, 3 * size[2], 1e-15, text .. ": length")
    near(frame.cases[1].loads[1].force[1], size[1], 1e-12 * size[1], text .. ": force")
    near(frame.materials[1].E, 210e6 * size[1] / size[2] ^ 2, 1e-3, text .. ": stress")
    near(frame.materials[1].density, 7.85 * size[1] / size[2] ^ 4, 1e-12 * size[1] / size[2] ^ 4, text .. ": density")
  end
end)

case("groups, degrees of freedom that are not active, rows that go on, values in quotes", function()
  local frame, notes = s2k(sap { more = push .. [[
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

-- Releases and self weight --------------------------------------------------------------------------------------------

local release_row = "   Frame=1   PI=No   V2I=No   V3I=No   TI=No   M2I=No   M3I=%s   PJ=No   V2J=No   V3J=No   "
  .. "TJ=No   M2J=No   M3J=%s   PartialFix=No\n"

-- A beam of 6 m along x between fixed supports under 10 kN/m; its file has these releases of M3.
local function released(i, j)
  return s2k(sap { at = "XorR=6   Y=0   Z=0", more = '   LoadPat=X   SelfWtMult=0\n'
    .. 'TABLE:  "JOINT RESTRAINT ASSIGNMENTS"\n   Joint=2   U1=Yes   U2=Yes   U3=Yes   R1=Yes   R2=Yes   R3=Yes\n'
    .. 'TABLE:  "FRAME RELEASE ASSIGNMENTS 1 - GENERAL"\n' .. release_row:format(i, j)
    .. 'TABLE:  "FRAME LOADS - DISTRIBUTED"\n   Frame=1   LoadPat=DEAD   CoordSys=GLOBAL   Type=Force   Dir=Gravity   '
    .. "DistType=RelDist   RelDistA=0   RelDistB=1   FOverLA=10   FOverLB=10\n" })
end

case("releases at supports: moments and reactions of a beam by hand", function()
  local w, L = 10e3, 6
  for _, row in ipairs { { "No", "No", w * L ^ 2 / 12, 0.5 }, { "No", "Yes", w * L ^ 2 / 8, 5 / 8 },
    { "Yes", "Yes", 0, 0.5 } } do
    local frame = released(row[1], row[2])
    local model, nodes, members = import.build(frame, small)
    local run = model:static { steps = 1, loads = { DEAD = 1 } }:finish()
    local what = ("M3I=%s, M3J=%s"):format(row[1], row[2])
    near(members["1"]:forces(run).Mx, row[3], 1e-4 * w * L ^ 2, what .. ": the moment at the first end, N m")
    near(select(3, nodes["1"]:reaction(run)), row[4] * w * L, 1e-4 * w * L, what .. ": the reaction, N")
    import.write(frame, folder .. "released.lua", small)
    local again, its_nodes = dofile(folder .. "released.lua")
    local its_run = again:static { steps = 1, loads = { DEAD = 1 } }:finish()
    near(select(3, its_nodes["1"]:reaction(its_run)), select(3, nodes["1"]:reaction(run)), 1e-6, what .. ": written")
  end
end)

-- A portal of 4 m by 6 m whose beam has these releases at both ends; a load of 10 kN/m on it and 1 kN to the side.
local function portal(release)
  return { nodes = { { name = "1", x = 0, y = 0, z = 0, fix = "all" }, { name = "2", x = 0, y = 0, z = 4 },
    { name = "3", x = 6, y = 0, z = 4 }, { name = "4", x = 6, y = 0, z = 0, fix = "all" } },
    materials = { { name = "steel", E = E, density = 7850 } },
    sections = { { name = "HEB 200", named = "HEB 200" } },
    members = { { name = "left", a = "1", b = "2", section = "HEB 200", material = "steel" },
      { name = "beam", a = "2", b = "3", section = "HEB 200", material = "steel", release = release },
      { name = "right", a = "4", b = "3", section = "HEB 200", material = "steel" } },
    cases = { { name = "load", loads = { { member = "beam", q = { 0, 0, -10e3 } }, { node = "2",
      force = { 1e3, 0, 0 } } } } } }
end

case("releases at a joint with other members: a pinned beam, torsion held, and the written script", function()
  local frame = portal { a = "rx,ry", b = "rx ry" }
  local model, nodes, members = import.build(frame, small)
  local run = model:static { steps = 1, loads = { load = 1 } }:finish()
  equal(run.verdict, "completed", run.reason)
  local at_a, at_b = members.beam:forces(run)
  near(at_a.Mx, 0, 1, "the moment at the first end, N m")
  near(at_b.Mx, 0, 1, "the moment at the second end, N m")
  near(select(3, nodes["1"]:reaction(run)), 30e3, 1, "half of the load, N")
  -- two columns that share the push, as clamped cantilevers: the beam's axial strain takes less than 1 % of it
  near(nodes["1"]:reaction(run), -500, 5, "half of the push, N")
  import.write(frame, folder .. "portal.lua", small)
  local again, its_nodes = dofile(folder .. "portal.lua")
  local its_run = again:static { steps = 1, loads = { load = 1 } }:finish()
  near(its_nodes["2"]:displacement(its_run), nodes["2"]:displacement(run), 1e-15, "the sway of the written model, m")
  for _, release in ipairs { { a = "rx,rz" }, { a = "rx,ry,rz" } } do
    local one, _, its = import.build(portal(release), small)
    local ended = one:static { steps = 1, loads = { load = 1 } }:finish()
    near(its.beam:forces(ended).Mx, 0, 1, "one end: " .. release.a)
    expect(math.abs(select(2, its.beam:forces(ended)).Mx) > 1e4, "the other end carries a moment")
  end
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
  local good, message = pcall(import.build, frame, small)
  expect(not good and tostring(message):find "self_weight = 'gravity'.*or 'loads'", "asks: %s", tostring(message))
  near(reaction { model = small.model, self_weight = "loads" }, weight, 1e-6 * weight, "of members alone, N")
  near(reaction { model = small.model, self_weight = "gravity" }, weight + 1.5 * 100 * 9.80665, 1e-6 * weight,
    "with the point mass, N")
  frame.masses = {}
  frame.materials[1].unit_weight = 80e3
  good, message = pcall(import.build, frame, small)
  expect(not good and tostring(message):find "80000 N/m%^3", "asks for a weight that is not the mass: %s", message)
  near(reaction { self_weight = "loads" }, 1.5 * 80e3 * 0.05, 1e-3, "the weight of the file, N")
  frame.cases[2] = { name = "more", self_weight = 1, loads = {} }
  good, message = pcall(import.build, frame, { self_weight = "gravity" })
  expect(not good and tostring(message):find "2 load cases have self weight", "refuses two: %s", tostring(message))
end)

-- ETABS ---------------------------------------------------------------------------------------------------------------

-- A file with a frame of two storeys of 3 m over points 1 (0, 0) and 2 (4, 0); more: further lines.
local function etabs(more, options)
  local o = options or {}
  local text = ([[
$ CONTROLS
  UNITS  %s
$ STORIES - IN SEQUENCE FROM TOP
  STORY "S2"  HEIGHT 3
  STORY "S1"  HEIGHT 3
  STORY "Base"  ELEV 1
$ MATERIAL PROPERTIES
  MATERIAL "S"  TYPE "Steel"  WEIGHTPERVOLUME 76.9822025
  MATERIAL "S"  SYMTYPE "Isotropic"  E 210000000  U 0.3
  MATERIAL "S"  FY 355000  FU 510000
$ FRAME SECTIONS
  FRAMESECTION "A"  MATERIAL "S"  SHAPE %s
$ POINT COORDINATES
  POINT "1"  0 0
  POINT "2"  4 0
  POINT "3"  4 3 0.5
$ LINE CONNECTIVITIES
  LINE "C1"  COLUMN "1" "1" 1
  LINE "B1"  BEAM "1" "2" 0
  LINE "D1"  BRACE "1" "2" 2
  LINE "B2"  BEAM "2" "3" 0
$ LOAD PATTERNS
  LOADPATTERN "DEAD"  TYPE "Dead"  SELFWEIGHT 1
%s]]):format(o.units or '"KN" "M" "C"', o.shape or '"Steel I/Wide Flange"  D 0.4 B 0.2 TF 0.012 TW 0.008', more or "")
  return import.e2k { file = write("frame.e2k", text) }
end

local etabs_head = 23 -- lines before more

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

  local old = import.e2k { file = write("old.e2k", [[
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
]]) }
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
  local text = tostring(notes)
  for offset, words in pairs { [2] = "PROPMOD", [5] = "spring soft is not read",
    [9] = "without RDIST", [11] = "area" } do
    local line = etabs_head + offset
    local entry
    for _, e in ipairs(notes) do
      if e.line == line and e.reason:find(words, 1, true) then entry = e end
    end
    expect(entry, "line %d is not noted with '%s':\n%s", line, words, text)
  end
  expect(at_line(notes.skipped, etabs_head + 13), "combinations are no part of a frame: %s", text)
  expect(text:find("PROPMOD", 1, true), "an unknown key is named: %s", text)

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
    local good, message = pcall(etabs, wrong)
    expect(not good and tostring(message):find(words:gsub("[%$%(%)]", "%%%0"), 1, false),
      "wanted '%s', got: %s", words, tostring(message))
  end
  local good, message = pcall(etabs, "", { units = '"STONE" "M"' })
  expect(not good and tostring(message):find(":2: UNITS are 'STONE'", 1, true), "units: %s", tostring(message))
  good, message = pcall(import.e2k, { file = write("empty.e2k", "nothing\n") })
  expect(not good and tostring(message):find("no line that begins with", 1, true), "%s", tostring(message))
end)

-- OpenSees ------------------------------------------------------------------------------------------------------------

local plane = [[
model BasicBuilder -ndm 2 -ndf 3
node 1 0 0
node 2 %s
fix 1 1 1 1
geomTransf Linear 1
element elasticBeamColumn 1 1 2 0.01 210e9 2e-4 1
pattern Plain 1 Linear { %s }
]]

case("a plane frame: y becomes z, rotations about z become those about -y", function()
  local function run_of(at, loads)
    local frame, notes = tcl(plane:format(at, loads))
    equal(#notes, 0, tostring(notes))
    local model, nodes = import.build(frame, small)
    return { nodes["2"]:displacement(model:static { steps = 1, loads = { ["pattern 1"] = 1 } }:finish()) },
      nodes["2"].fixed
  end
  local EI, L = E * 2e-4, 3
  -- shear areas are 1000 times the area; 1e-7: rounding
  local GA = G * 1000 * 0.01
  local u, fixed = run_of("3 0", "load 2 0 1000 0")
  near(u[3], 1e3 * L ^ 3 / (3 * EI) + 1e3 * L / GA, 1e-7 * u[3], "a force along y, m")
  near(u[5], -1e3 * L ^ 2 / (2 * EI), 1e-7 * math.abs(u[5]), "its rotation, rad")
  equal(fixed, "y,rx,rz", "what is fixed")
  u = run_of("3 0", "load 2 0 0 1000")
  near(u[3], 1e3 * L ^ 2 / (2 * EI), 1e-7 * u[3], "a moment about z lifts the tip, m")
  near(u[5], -1e3 * L / EI, 1e-7 * math.abs(u[5]), "a moment about z, rad")
  u = run_of("0 3", "eleLoad -ele 1 -type -beamUniform -1000 200")
  near(u[1], 1e3 * L ^ 4 / (8 * EI) + 1e3 * L ^ 2 / (2 * GA), 1e-7 * u[1], "a column: -1 kN/m along its y is +x, m")
  near(u[3], 200 * L ^ 2 / 2 / (E * 0.01), 1e-9 * u[3], "along the column, m")
end)

case("elements: sections by tag, integration points, shear by alphaY and alphaZ, masses", function()
  local frame, notes = tcl([[
model basic -ndm 3 -ndf 6
node 1 0 0 0
node 2 0 0 3 -mass 5 5 5 1 2 3
node 3 4 0 3 -mass 7 7 0 0 0 0
fixZ 0 1 1 1 1 1 1
geomTransf Corotational 1 0 1 0
section Elastic 1 200 2 0.3 0.4 80 0.5 0.8 0.7
element forceBeamColumn 1 1 2 5 1 1 -mass 4
element dispBeamColumn 2 2 3 1 Legendre 1 3
element elasticBeamColumn 3 2 3 1 1
element nonlinearBeamColumn 4 2 3 1 "Lobatto 1 5"
element elasticBeamColumn 5 2 3 2 200 80 0.5 0.4 0.3 1
timeSeries Linear 1 -factor 3
pattern Plain 1 1 -fact 2 { load 3 1 2 3 4 5 6 }
pattern Plain 2 Constant { load 3 1 0 0 0 0 0; eleLoad -range 2 3 -type -beamUniform 1 2 3 }
]], { length = "mm", force = "kN" })
  equal(#notes, 0, tostring(notes))
  local of = {}
  for _, s in ipairs(frame.sections) do of[s.name] = s end
  local m = frame.members
  -- y of hinge is z of OpenSees: Ix = Iy, Iy = Iz; 1 mm^2 is 1e-6 m^2
  local s = of[m[1].section]
  equal(("%.6g %.6g %.6g %.6g %.6g %.6g"):format(s.area, s.Ix, s.Iy, s.J, s.shear_area_x, s.shear_area_y),
    "2e-06 4e-13 3e-13 5e-13 1.6e-06 1.4e-06", "with shear strain")
  equal(of[m[2].section].shear_area_x, 1000 * 2e-6, "dispBeamColumn has none")
  for _, i in ipairs { 3, 5 } do equal(m[i].section, m[2].section, "without shear strain: element " .. i) end
  equal(m[4].section, m[1].section, "nonlinearBeamColumn is forceBeamColumn")
  near(frame.materials[1].E, 200e9, 1, "kN/mm^2")
  near(frame.materials[1].density, 4e6 / 1e-3 / 2e-6, 1e3, "-mass in kN s^2/mm per mm, over the area")
  equal(frame.nodes[1].fix, "all", "fixZ")
  near(frame.masses[1].mass, 5e6, 1e-6, "a mass, kg")
  near(frame.masses[1].inertia[3], 3, 1e-9, "its inertia, kg m^2")
  expect(at_line(notes.assumed, 4), "a mass along two axes is named: %s", tostring(notes))
  equal(frame.cases[1].loads[1].force[2], 12e3, "both factors, N")
  equal(frame.cases[1].loads[1].moment[3], 36, "a moment, N m")
  equal(#frame.cases[2].loads, 3, "loads of the second pattern")
  local q = frame.cases[2].loads[2]
  equal(("%s %g %g %g"):format(q.axes, q.q[1], q.q[2], q.q[3]), "local 1e+06 2e+06 3e+06", "Wy, Wz, Wx are x, y, z")
end)

-- The x of nodes that a script makes.
local function made(frame)
  local parts = {}
  for i, node in ipairs(frame.nodes) do parts[i] = ("%s:%.10g"):format(node.name, node.x) end
  return table.concat(parts, " ")
end

local tcl_head = "model basic -ndm 3 -ndf 6\ngeomTransf Linear 1 1 0 0\n"
-- Members that join nodes 1 and 2, 2 and 3 and so on, so that none is left out.
local function joined(count)
  local lines = {}
  for i = 1, count - 1 do
    lines[i] = ("element elasticBeamColumn %d %d %d 1 1 1 1 1 1 1"):format(i, i, i + 1)
  end
  return table.concat(lines, "\n") .. "\n"
end

case("Tcl: variables, arithmetic, lists, loops and conditions", function()
  for _, row in ipairs {
    { "set a 2\nnode 1 $a 0 1\nnode 2 [expr $a*1.5+1] 0 2", "1:2 2:4" },
    { "node 1 [expr 7/2] 0 1; node 2 [expr 7/2.] 0 2; # whole numbers stay whole", "1:3 2:3.5" },
    { "node 1 [expr -7/2] 0 1; node 2 [expr -2**2+2*3**2] 0 2", "1:-4 2:22" },
    { "node 1 [expr {sqrt(16) + pow(2,3)}] 0 1\nnode 2 [expr {2 > 1 && !0 ? 5 : 6}] 0 2", "1:12 2:5" },
    { "set x(1,a) 3\nset i 1\nnode 1 $x($i,a) 0 1\nnode 2 ${i}0.5 0 2", "1:3 2:10.5" },
    { "for {set i 1} {$i <= 3} {incr i} {\n  if {$i == 2} { continue }\n  node [expr ($i+1)/2] $i 0 $i\n}", "1:1 2:3" },
    { "foreach {n x} {1 0.5 2 1.5} { node $n $x 0 $n }", "1:0.5 2:1.5" },
    { "foreach n {1 2} x [list 4 [expr 2+3]] { node $n $x 0 $n }", "1:4 2:5" },
    { "set l {}\nlappend l 8 9\nnode 1 [lindex $l 0] 0 1\nnode [llength $l] [lindex $l end] 0 2", "1:8 2:9" },
    { "set n 0\nwhile {1} {\n incr n\n if {$n > 2} {break} else {node $n $n 0 $n}\n}", "1:1 2:2" },
    { "set t [format \"%d\" 1]\nnode $t 1 \\\n  0 1\n\n# node 9 9 9 9 \\\n still a comment\nnode 2 \"2\" {0} 2",
      "1:1 2:2" },
    { "if {0} {\n} elseif {1 != 1} {\n} else {\n node 1 1 0 1\n}\nnode 2 2 0 2", "1:1 2:2" },
    { "set p {1 2 0 1}\nnode {*}$p\neval2 5\nnode 2 3 0 2", "1:2 2:3", 1 },
  } do
    local frame, notes = tcl(tcl_head .. row[1] .. "\n" .. joined(2))
    equal(made(frame), row[2], row[1])
    equal(#notes, row[3] or 0, row[1] .. "\n" .. tostring(notes))
  end
  write("units.tcl", "set in 0.0254\nset bad [nodeDisp 1 1]\nnode 1 [expr 10*$in] 0 1\nnode 2 1 0 2\nfoo 1\n")
  local frame, notes = tcl(tcl_head .. "source units.tcl\n" .. joined(2))
  equal(made(frame), "1:0.254 2:1", "a file that is sourced")
  equal(notes[1].file .. notes[1].line, folder .. "units.tcl5", "its notes have its name and line")
  equal(#notes.skipped, 1, "a result of the analysis is no part of a frame")
end)

local python_head = "from openseespy.opensees import *\nimport math\nmodel('basic', '-ndm', 3, '-ndf', 6)\n"
  .. "geomTransf('Linear', 1, 1, 0, 0)\n"
local python_end = "element('elasticBeamColumn', 1, 1, 2, 1, 1, 1, 1, 1, 1, 1)\n"

case("Python: variables, arithmetic, lists, loops and conditions", function()
  for _, row in ipairs {
    { "a, b = 2, 3.0\nnode(1, a * b, 0, 1)\nnode(2, 7 // 2 + 7 / 2, 0, 2)", "1:6 2:6.5" },
    { "node(1, -2 ** 2, 0, 1); node(2, 2 ** -1, 0, 2)", "1:-4 2:0.5" },
    { "x = [4, 5,\n     6]\nnode(1, x[0], 0, 1)\nnode(2, x[-1], 0, len(x))", "1:4 2:6" },
    { "for tag, (x, z) in enumerate([(1, 1), (2, 2)], 1):\n    node(tag, x, 0, z)", "1:1 2:2" },
    { "for i in range(1, 3): node(i, i * 2, 0, i)", "1:2 2:4" },
    { "d = {'a': 1, 2: 5}\nd['b'] = 7\nnode(1, d['b'], 0, 1)\nnode(2, d[2], 0, 2)", "1:7 2:5" },
    { "p = {}\nfor i in range(2):\n    for j in range(1):\n        p[i, j] = i + 1\n        node(p[i, j], 3 * i, 0, i)",
      "1:0 2:3" },
    { "x = []\nfor i in range(5):\n  if i % 2 == 0 and not i == 4:\n    x.append(i)\n  elif i > 3:\n    break\n"
      .. "node(1, x[1], 0, 1)\nnode(2, sum(x), 0, 2)", "1:2 2:2" },
    { "x = [i ** 2 for i in range(4) if i > 1]\nnode(1, x[0], 0, 1)\nnode(2, max(x), 0, 2)", "1:4 2:9" },
    { "i = 0\nwhile True:\n    i += 1\n    if i > 2:\n        break\n    node(i, float(i), 0, i)", "1:1 2:2" },
    { "node(1, math.cos(math.pi) if 1 < 2 < 3 else 4, 0, 1)\nnode(2, int('3') + round(2.5), 0, 2)", "1:-1 2:5" },
    { '"""A comment\nof two lines."""\nnode(1, 1_000, 0, 1)  # a comment\nnode(2, \\\n  2, 0, 2)', "1:1000 2:2" },
    { "def f(x):\n    node(5, x, 0, 0)\n    return x\nnode(1, 1, 0, 1)\nnode(2, f(2), 0, 2)", "1:1 2:2", 1 },
    { "if __name__ == '__main__':\n  node(1, 1, 0, 1)\n  pass\nelse:\n  node(9, 9, 9, 9)\nnode(2, 2, 0, 2)",
      "1:1 2:2" },
    { "for a, b in zip([1, 2], (3, 4)):\n  node(a, b, 0, a)", "1:3 2:4" },
  } do
    local frame, notes = python(python_head .. row[1] .. "\n" .. python_end)
    equal(made(frame), row[2], row[1])
    equal(#notes, row[3] or 0, row[1] .. "\n" .. tostring(notes))
  end
end)

-- Notes ---------------------------------------------------------------------------------------------------------------

-- The lines of an entry, each once: one, or those of all that are alike.
local function lines_of(entry)
  local lines, seen = {}, {}
  for _, line in ipairs(entry.lines or { entry.line }) do
    if not seen[line] then lines[#lines + 1], seen[line] = line, true end
  end
  return lines, seen
end

-- Each line of `unread` has as many entries in the notes as it has reasons; no other line has one.
local function notes_are(what, notes, first, unread)
  local count, told = 0, 0
  for _, entry in ipairs(notes) do
    local wanted = 0 -- of lines that are alike, one or all are wanted
    for _, line in ipairs(lines_of(entry)) do wanted = wanted + (unread[line - first] and 1 or 0) end
    told = told + (wanted > 0 and wanted or 1)
  end
  for line, reasons in pairs(unread) do
    for _, reason in ipairs(type(reasons) == "table" and reasons or { reasons }) do
      count = count + 1
      local found = false
      for _, entry in ipairs(notes) do
        local _, seen = lines_of(entry)
        found = found or seen[first + line] and entry.text ~= "" and entry.reason:find(reason, 1, true)
      end
      expect(found, "%s, line %d: there is no '%s'", what, first + line, reason)
    end
  end
  expect(told == count, "%s: %d entries, wanted %d:\n%s", what, told, count, tostring(notes))
end

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
  notes_are("s2k", notes, head, { [2] = "no member", [4] = "curved", [9] = "above 0", [12] = "no section",
    [13] = "section N was not read, see line 26", [17] = "forces alone",
    [18] = "direction", [19] = "frame was not read", [21] = "GLOBAL alone", [22] = "no member",
    [24] = { "partial", "P, V2 and V3" }, [25] = "table is not read", [30] = "another temperature", [31] = "no E1" })
  equal(#frame.members, 1, "members")
  expect(at_line(notes.skipped, head + 27), "grid lines are no part of a frame: %s", tostring(notes))
  expect(tostring(notes):find("not read (15):", 1, true), "print shows them: %s", tostring(notes))
end)

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
  notes_are("tcl", notes, 2, { [1] = "-disp", [3] = "masses along the axes differ",
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
]] .. python_end)
  notes_are("python", of_python, 4, { [7] = "hangs on a result of the analysis",
    [8] = "the module pylib is not there", [9] = "hangs on a result", [15] = "element shell", [17] = "hinge ties" })
  equal(at_line(of_python, 21).count, 3, "how often a line in a loop was run")
  equal(#of_python.skipped, 1, "what is computed is one entry: " .. tostring(of_python))
end)

-- CSV -----------------------------------------------------------------------------------------------------------------

-- Reads tables given as text; those left out are not read.
local function csv(tables)
  local files = {}
  for name, text in pairs(tables) do files[name] = write(name .. ".csv", text) end
  return import.csv(files)
end

local two_nodes, one_member = "name,x,y,z\n1,0,0,0\n2,3,0,0\n", "name,a,b,section,material\nm,1,2,HEB 300,S355\n"

case("CSV: names of sections and grades, separators, decimal commas, quotes, supports by columns", function()
  local frame, notes = csv {
    nodes = '\239\187\191Name;X;Y;Z;colour\r\n"a ""1""";0,5;0;0;red\r\n\r\n# a comment\r\n2;3;0;1e1;\r\n',
    members = 'name\ta\tb\tsection\tmaterial\tgroup\trelease_a\nm\t2\t"a ""1"""\tHEB 300\tS355\tlong one\trx ry\n'
      .. 'n\t2\ta "1"\tmine\tS355\t\t\n',
    sections = "name,named\nmine,IPE 300\n", supports = "node,x,y,z,rx\n2,1,1,0,1\na \"1\",0,0,0,0\n",
    loads = "node,fx\n2,5\n", masses = "node,mass\n2,100\n" }
  equal(frame.nodes[1].name .. frame.nodes[1].x .. frame.nodes[2].z, 'a "1"0.510.0', "nodes")
  notes_are("csv", notes, 0, { [1] = "name, x, y, z" })
  equal(frame.nodes[2].fix .. tostring(frame.nodes[1].fix), "x,y,rxnil", "supports")
  equal(frame.members[1].release.a .. frame.members[1].group, "rx,rylong one", "a member")
  equal(frame.cases[1].name .. frame.cases[1].loads[1].force[1], "loads5", "loads without a case")
  local _, _, members = import.build { nodes = frame.nodes, members = { frame.members[2] }, sections = frame.sections,
    materials = frame.materials }
  equal(members.n.section.kind .. members.n.material.yield_stress, "IPE 300355000000.0", "names")
  near(notes.summary.mass_of_nodes, 100, 1e-12, "masses, kg")
  local steel, heb = hinge.material.steel "S355", hinge.section.named "HEB 300"
  local plain, its = csv { nodes = two_nodes, members = one_member }
  near(its.summary.mass_of_members, 3 * steel.density * heb.area, 1e-9, "mass, kg")
  local model = import.build(plain)
  equal(model:members()[1].section.kind, "HEB 300", "a section by its name")
end)

-- Errors --------------------------------------------------------------------------------------------------------------

local function refused(what, wanted, f, ...)
  local good, message = pcall(f, ...)
  expect(not good, "%s: is not refused", what)
  message = tostring(message)
  expect(message:find(wanted, 1, true), "%s: wanted '%s' in: %s", what, wanted, message)
  expect(message:find("import_test.lua:", 1, true), "%s: the script's line in: %s", what, message)
end

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
  } do refused(row[2], row[2], s2k, row[1]) end
  refused("no file", "hinge.import.s2k: cannot read ", import.s2k, { file = folder .. "none.s2k" })
  refused("a field", "unknown field 'path'", import.s2k, { path = "x" })
end)

case("broken scripts of OpenSees are refused with the line", function()
  for _, row in ipairs {
    { "node 1 0 0", "3: node 1 has 2 coordinates; must be 3" }, { "node 1 0 0 x",
      "3: coordinate 3 is 'x'; must be a number" },
    { "node 1 0 0 0\nnode 1 0 0 0", "4: node 1 is there twice" }, { "fix 5 1 1 1 1 1 1", "3: node 5 is not there" },
    { "node 1 0 0 0\nfix 1 1 1 1 2 1 1", "4: flag 4 is 2; must be 0 or 1" },
    { "\nnode 1 0 0 0\nnode 2 0 0 0\n" .. joined(2), "6: element 1 has no length" },
    { "node 1 0 0 0\nnode 2 0 0 1\nelement elasticBeamColumn 1 1 2 1 1 1",
      "5: element elasticBeamColumn has 6 arguments" },
    { "node 1 0 0 0\nnode 2 1 0 0\n" .. joined(2), "5: vecxz of element 1 is along the element" },
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
    refused(row[2], row[2], tcl, tcl_head .. row[1])
  end
  refused("before model", "1: the command stands before: model", tcl, "node 1 0 0 0")
  refused("no node", "has no node that was read", tcl, tcl_head)
  refused("no command", "it calls no command of OpenSees: if its functions do, give the file that calls them", tcl,
    "proc frame {} { node 1 0 0 }")
  refused("no -ndm", "1: the number of dimensions is missing: model basic -ndm 2, or -ndm 3", tcl, "model Tcl2dTruss")
  for _, row in ipairs {
    { "x = (1,\n  2\n", "5: SyntaxError: '(' was never closed" }, { "x = 1)", "5: SyntaxError: unmatched ')'" },
    { "x = 'a\n", "5: SyntaxError: unterminated string literal" },
    { "x = 1\n  y = 2", "6: IndentationError: unexpected indent" },
    { "if 1:\n    x = 1\n  y = 2", "7: IndentationError: unindent does not match" }, { "x = 1 ? 2",
      "5: SyntaxError: invalid syntax" },
    { "\nnode(1, 0, 0)", "6: node 1 has 2 coordinates" }, { "for i in [1]:\n  fix(9, *[1] * 6)",
      "6: node 9 is not there" },
  } do
    refused(row[2], row[2], python, python_head .. row[1])
  end
  refused("no units", "field 'units' is missing; the file does not say its units", import.tcl, { file = samples
    .. "frame.tcl" })
  refused("a unit", "units.force is 'newton'; must be one of N, kN", tcl, "", { length = "m", force = "newton" })
end)

case("broken tables are refused with the line", function()
  for _, row in ipairs {
    { { nodes = "name,x,y\n" }, "nodes.csv:1: the column 'z' is missing; there are name, x, y, z" },
    { { nodes = "" }, "nodes.csv is empty" },
    { { nodes = "name,x,y,z\n1,0,0,0\n\n1,1,1,1\n" }, "nodes.csv:4: '1' is there twice" },
    { { nodes = "name,x,y,z\n1,0,0,abc\n" }, "nodes.csv:2: column 'z' is 'abc'; must be a number" },
    { { nodes = "name,x,y,z\n1,0,0\n" }, "nodes.csv:2: the cell of column 'z' is empty" },
    { { nodes = "name,x,y,z\n1,0,0,0,0\n" }, "nodes.csv:2: the line has 5 cells, and the first line 4" },
    { { nodes = 'name,x,y,z\n"1,0,0,0\n' }, "nodes.csv:2: the quotes are not closed" },
    { { members = "name,a,b,section,material\nm,1,3,HEB 300,S355\n" },
      "members.csv:2: node '3' is not in the file of nodes" },
    { { members = "name,a,b,section,material\nm,1,2,HEB 301,S355\n" },
      "members.csv:2: hinge.section.named: unknown section" },
    { { members = "name,a,b,section,material\nm,1,2,HEB 300,S999\n" },
      "members.csv:2: hinge.material.steel: unknown grade" },
    { { members = "name,a,b,section,material\nm,1,1,HEB 300,S355\n" }, "members.csv:2: member 'm' has no length" },
    { { members = "name,a,b,section,material,up_x\nm,1,2,HEB 300,S355,1\n" },
      "members.csv:2: give up_x, up_y and up_z" },
    { { sections = "name,area,Ix,Iy,J\ns,1,1,0,1\n" }, "sections.csv:2: column 'Iy' is 0; must be above 0" },
    { { sections = "name,area,Ix,Iy\ns,1,1,1\n" }, "sections.csv:2: the cell of column 'J' is empty" },
    { { supports = "node,fix\n1,rq\n" }, "supports.csv:2: column 'fix' is 'rq'" },
    { { loads = "node,member,fx\n1,m,5\n" }, "loads.csv:2: give either a node or a member" },
    { { loads = "member,fx\nm,5\n" }, "loads.csv:2: a load on a member has qx" },
    { { loads = "member,qx,axes\nm,5,up\n" }, "loads.csv:2: column 'axes' is 'up'" },
    { { masses = "node,mass\n1,-5\n" }, "masses.csv:2: column 'mass' is -5 kg" },
  } do
    local tables = { nodes = two_nodes, members = one_member }
    for name, text in pairs(row[1]) do tables[name] = text end
    refused(row[2], row[2], csv, tables)
  end
end)

case("a frame that is no frame is refused", function()
  local function with(change)
    local frame = portal { a = "rx" }
    change(frame)
    return frame
  end
  for _, row in ipairs {
    { function(f) f.members[1].a = "9" end, "frame.members[1], 'left': field 'a': unknown node '9'" },
    { function(f) f.members[1].section = "HEB" end, "unknown section 'HEB'" },
    { function(f) f.members[1].b = "1" end, "both ends are node '1'" },
    { function(f) f.nodes[2].x = nil end, "frame.nodes[2]: field 'x' is missing; give a number, in m" },
    { function(f) f.nodes[2].name = "1" end, "frame.nodes[2]: the name '1' is there twice" },
    { function(f) f.nodes[5] = { name = "5", x = 0, y = 0, z = 0 } end, "node '5' belongs to no member" },
    { function(f) f.materials[1].E = -1 end, "frame.materials[1]: field 'E' is -1 Pa; must be a number above 0 Pa" },
    { function(f) f.cases[1].loads[1].node = "1" end, "frame.cases[1].loads[1]: give either 'node' or 'member'" },
    { function(f) f.cases[1].loads[1].member = "x" end, "unknown member 'x'" },
    { function(f) f.masses = { { node = "1", mass = 0 } } end, "frame.masses[1]: field 'mass' is 0 kg" },
    { function(f) f.members[2].release = { a = "x" } end, "release.a is 'x'; must be rotations" },
    { function(f) f.slabs = {} end, "unknown field 'slabs'" },
    { function(f) f.members = {} end, "the frame has no member" },
  } do refused(row[2], row[2], import.build, with(row[1])) end
  refused("nothing", "hinge.import.build: the frame is missing", import.build)
  refused("a third argument", "takes no further argument", import.build, portal(), small, 1)
  refused("a file of another kind", "it is no script of import.write", import.write, portal(),
    write("own.lua", "x = 1\n"))
  equal(support.read(folder .. "own.lua"), "x = 1\n", "it is left as it was")
  refused("a name", "its name must end in .lua", import.write, portal(), "frame.txt")
  refused("an option", "unknown field 'gravty'", import.build, portal(), { gravty = 1 })
  refused("a function", "unknown field 's2q'", function() return import.s2q end)
end)

checks.done()
