-- hinge.import.s2k and e2k with the option `slabs`: areas become plates between the members, joined to the nodes of
-- their elements. The same floor made by hand moves alike; weights are those without the option; what no slab can be
-- is named and stays a load.
--
-- Run: lua5.4 tests/script/import/import_slabs_test.lua BUILD_FOLDER, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local hinge = require "hinge"
local import = require "hinge.import"
local checks = support.checks "slabs of SAP2000 and ETABS"
local case, near, equal, expect, refused = checks.case, checks.near, checks.equal, checks.expect, checks.refused

local write, folder = support.writer()
local g = 9.80665
local bars = { x = 393e-6, y = 393e-6, yield_stress = 500e6 }
local bent = { sagging = 1e4, hogging = 1e4 }

-- Files ---------------------------------------------------------------------------------------------------------------

local tables = [[
TABLE:  "PROGRAM CONTROL"
   ProgramName=SAP2000   CurrUnits="KN, m, C"
TABLE:  "MATERIAL PROPERTIES 01 - GENERAL"
   Material=S355   Type=Steel   SymType=Isotropic
   Material=C30   Type=Concrete   SymType=Isotropic
   Material=B500   Type=Rebar   SymType=Uniaxial
TABLE:  "MATERIAL PROPERTIES 02 - BASIC MECHANICAL PROPERTIES"
   Material=S355   UnitWeight=76.9822025   UnitMass=7.85   E1=210000000   U12=0.3
   Material=C30   UnitWeight=24.516625   UnitMass=2.5   E1=33000000   U12=0.2
   Material=B500   UnitWeight=76.9822025   UnitMass=7.85   E1=200000000   U12=0.3
TABLE:  "MATERIAL PROPERTIES 03A - STEEL DATA"
   Material=S355   Fy=355000
TABLE:  "MATERIAL PROPERTIES 03B - CONCRETE DATA"
   Material=C30   Fc=30000
TABLE:  "MATERIAL PROPERTIES 03E - REBAR DATA"
   Material=B500   Fy=500000
TABLE:  "FRAME SECTION PROPERTIES 01 - GENERAL"
   SectionName=A   Material=S355   Shape=General   Area=0.01   TorsConst=1e-6   I33=2e-4   I22=5e-5   AS2=0   AS3=0
TABLE:  "AREA SECTION PROPERTIES"
   Section=S15   Material=C30   AreaType=Shell   Type=Shell-Thin   Thickness=0.15   BendThick=0.15   M11Mod=0.25 _
        M22Mod=0.25
   Section=P10   Material=S355   AreaType=Shell   Type=Shell-Thin   Thickness=0.01   BendThick=0.01
   Section=L20   Material=C30   AreaType=Shell   Type=Shell-Layered   Thickness=0.2   BendThick=0.2
TABLE:  "AREA SECTION PROPERTY LAYERS"
   Section=L20   LayerName=C   Distance=0   Thickness=0.2   Type=Shell   Material=C30   MatAngle=0
   Section=L20   LayerName=T1   Distance=0.07   Thickness=0.0003   Type=Membrane   Material=B500   MatAngle=0
   Section=L20   LayerName=B1   Distance=-0.07   Thickness=0.0004   Type=Membrane   Material=B500   MatAngle=0
   Section=L20   LayerName=B2   Distance=-0.06   Thickness=0.0005   Type=Membrane   Material=B500   MatAngle=90
TABLE:  "LOAD PATTERN DEFINITIONS"
   LoadPat=DEAD   DesignType=Dead   SelfWtMult=1
   LoadPat=LIVE   DesignType=Live   SelfWtMult=0
]]

-- A file of SAP2000. o.joints: { x, y, z }, fixed at z = 0; o.frames: { joint, joint }; o.areas: { section, joints...,
-- load = (kN/m2) }; o.more: further tables.
local function s2k(o, options)
  local text = { tables, 'TABLE:  "JOINT COORDINATES"' }
  local function add(format, ...) text[#text + 1] = format:format(...) end
  for i, p in ipairs(o.joints) do
    add("   Joint=%d   CoordSys=GLOBAL   CoordType=Cartesian   XorR=%.9g   Y=%.9g   Z=%.9g", i, p[1], p[2], p[3])
  end
  add 'TABLE:  "JOINT RESTRAINT ASSIGNMENTS"'
  for i, p in ipairs(o.joints) do
    if p[3] == 0 then add("   Joint=%d   U1=Yes   U2=Yes   U3=Yes   R1=Yes   R2=Yes   R3=Yes", i) end
  end
  add 'TABLE:  "CONNECTIVITY - FRAME"'
  for i, f in ipairs(o.frames) do add("   Frame=%d   JointI=%d   JointJ=%d", i, f[1], f[2]) end
  add 'TABLE:  "FRAME SECTION ASSIGNMENTS"'
  for i in ipairs(o.frames) do add("   Frame=%d   AnalSect=A   MatProp=Default", i) end
  add 'TABLE:  "CONNECTIVITY - AREA"'
  for i, a in ipairs(o.areas) do
    local joints = {}
    for k = 2, #a do joints[k - 1] = ("Joint%d=%d"):format(k - 1, a[k]) end
    add("   Area=%d   NumJoints=%d   %s", i, #joints, table.concat(joints, "   "))
  end
  add 'TABLE:  "AREA SECTION ASSIGNMENTS"'
  for i, a in ipairs(o.areas) do add("   Area=%d   Section=%s   MatProp=Default", i, a[1]) end
  add 'TABLE:  "AREA LOADS - UNIFORM"'
  for i, a in ipairs(o.areas) do
    if a.load then add("   Area=%d   LoadPat=LIVE   CoordSys=GLOBAL   Dir=Gravity   UnifLoad=%g", i, a.load) end
  end
  text[#text + 1] = o.more
  return import.s2k { file = write("floor.s2k", table.concat(text, "\n") .. "\n"), slabs = options }
end

-- Columns of 4 m below all points in plan, { { x, y }, ... }; beams between two of them by their numbers.
local function storey(points, beams, areas, more)
  local o = { joints = {}, frames = {}, areas = areas, more = more }
  for i, p in ipairs(points) do o.joints[i], o.joints[#points + i] = { p[1], p[2], 4 }, { p[1], p[2], 0 } end
  for i in ipairs(points) do o.frames[i] = { #points + i, i } end
  for _, b in ipairs(beams) do table.insert(o.frames, b) end
  return o
end

-- Two bays of 6 m by 5 m; the beams of the second one run the other way, and so does its area.
local function two_bays(section)
  return storey({ { 0, 0 }, { 6, 0 }, { 12, 0 }, { 0, 5 }, { 6, 5 }, { 12, 5 } },
    { { 1, 2 }, { 3, 2 }, { 4, 5 }, { 6, 5 }, { 1, 4 }, { 2, 5 }, { 6, 3 } },
    { { section or "S15", 1, 2, 5, 4, load = 3 }, { section or "S15", 2, 5, 6, 3, load = 2 } })
end

local function solve(model) return model:static { steps = 2, loads = { DEAD = 1, LIVE = 1 } }:finish() end

-- The sum of the vertical reactions under one case, N.
local function reaction(frame, name, options)
  local model, nodes = import.build(frame, options)
  local run, up = model:static { steps = 1, loads = { [name] = 1 } }:finish(), 0
  for _, node in pairs(nodes) do up = up + select(3, node:reaction(run)) end
  model:close()
  return up
end

-- The reason that a note has.
local function reason_of(list, words)
  for _, note in ipairs(list) do
    if support.has(note.reason or "", words) then return note end
  end
end

-- The same as made by hand --------------------------------------------------------------------------------------------

-- Two bays with panels of 4 by 4 in each, laid one by one.
local function by_hand()
  local model = hinge.model()
  local steel = hinge.material { E = 210e9, nu = 0.3, density = 7850 }
  local section = hinge.section.general { area = 0.01, Ix = 2e-4, Iy = 5e-5, J = 1e-6, shear_area_x = 10,
    shear_area_y = 10 }
  local dead, live = model:case "DEAD", model:case "LIVE"
  dead:gravity { 0, 0, -g }
  local rows = {} -- nodes of the floor, i along x from 0 to 8, j along y from 0 to 4
  for i = 0, 8 do rows[i] = {} end
  for i = 0, 8, 4 do
    for j = 0, 4, 4 do
      rows[i][j] = model:node { 1.5 * i, 1.25 * j, 4 }
      local foot = model:node { 1.5 * i, 1.25 * j, 0 }
      model:fix(foot)
      model:member { foot, rows[i][j], section = section, material = steel, up = { 1, 0, 0 } }
    end
  end
  local function beam(i, j, di, dj)
    local one = model:member { rows[i][j], rows[i + 4 * di][j + 4 * dj], section = section, material = steel,
      elements = 4 }
    for k = 1, 3 do rows[i + k * di][j + k * dj] = one:node(k) end
  end
  for _, b in ipairs { { 0, 0, 1, 0 }, { 4, 0, 1, 0 }, { 0, 4, 1, 0 }, { 4, 4, 1, 0 }, { 0, 0, 0, 1 }, { 4, 0, 0, 1 },
    { 8, 0, 0, 1 } } do
    beam(table.unpack(b))
  end
  for i = 0, 8 do
    for j = 0, 4 do rows[i][j] = rows[i][j] or model:node { 1.5 * i, 1.25 * j, 4 } end
  end
  for i = 0, 7 do
    for j = 0, 3 do
      local corners = { rows[i][j], rows[i + 1][j], rows[i + 1][j + 1], rows[i][j + 1] }
      model:panel { corners[1], corners[2], corners[3], corners[4], concrete = { thickness = 0.15, E = 33e9,
        strength = 30e6, density = 2500 }, reinforcement = bars, bending = { sagging = 1e4, hogging = 1e4,
        stiffness = 0.25 * 33e9 * 0.15 ^ 3 / (12 * (1 - 0.2 ^ 2)), poisson = 0.2 } }
      for _, node in ipairs(corners) do
        live:load { node = node, force = { 0, 0, -(i < 4 and 3e3 or 2e3) * 1.5 * 1.25 / 4 } }
      end
    end
  end
  return model, rows
end

local etabs = [[
$ CONTROLS
  UNITS  "KN"  "M"  "C"
$ STORIES - IN SEQUENCE FROM TOP
  STORY "Top"  HEIGHT 4
  STORY "Base"  ELEV 0
$ MATERIAL PROPERTIES
  MATERIAL  "S355"  TYPE "Steel"  WEIGHTPERVOLUME 76.9822025
  MATERIAL  "S355"  SYMTYPE "Isotropic"  E 210000000  U 0.3
  MATERIAL  "S355"  FY 355000
  MATERIAL  "C30"  TYPE "Concrete"  WEIGHTPERVOLUME 24.516625
  MATERIAL  "C30"  SYMTYPE "Isotropic"  E 33000000  U 0.2
  MATERIAL  "C30"  FC 30000
$ FRAME SECTIONS
  FRAMESECTION  "A"  MATERIAL "S355"  SHAPE "General"  AREA 0.01 I33 2e-4 I22 5e-5 TORSION 1e-6 AS2 10 AS3 10
$ SLAB PROPERTIES
  SHELLPROP  "S15"  PROPTYPE  "Slab"  MATERIAL "C30"  MODELINGTYPE "ShellThin"  SLABTYPE "Slab"  SLABTHICKNESS 0.15
  SHELLPROP  "S15"  M11MOD 0.25 M22MOD 0.25
$ POINT COORDINATES
  POINT "1"  0 0
  POINT "2"  6 0
  POINT "3"  12 0
  POINT "4"  0 5
  POINT "5"  6 5
  POINT "6"  12 5
$ LINE CONNECTIVITIES
  LINE "B1" BEAM "1" "2" 0
  LINE "B2" BEAM "2" "3" 0
  LINE "B3" BEAM "4" "5" 0
  LINE "B4" BEAM "5" "6" 0
  LINE "B5" BEAM "1" "4" 0
  LINE "B6" BEAM "2" "5" 0
  LINE "B7" BEAM "3" "6" 0
]]
for i = 1, 6 do etabs = etabs .. ('  LINE "C%d" COLUMN "%d" "%d" 1\n'):format(i, i, i) end
etabs = etabs .. "$ POINT ASSIGNS\n"
for i = 1, 6 do etabs = etabs .. ('  POINTASSIGN "%d" "Base" RESTRAINT "UX UY UZ RX RY RZ"\n'):format(i) end
etabs = etabs .. "$ LINE ASSIGNS\n"
for i = 1, 7 do etabs = etabs .. ('  LINEASSIGN "B%d" "Top" SECTION "A"\n'):format(i) end
for i = 1, 6 do etabs = etabs .. ('  LINEASSIGN "C%d" "Top" SECTION "A"\n'):format(i) end
etabs = etabs .. [[
$ AREA CONNECTIVITIES
  AREA "F1"  FLOOR 4 "1" "2" "5" "4" 0 0 0 0
  AREA "F2"  FLOOR 4 "2" "3" "6" "5" 0 0 0 0
$ AREA ASSIGNS
  AREAASSIGN "F1" "Top" SECTION "S15"
  AREAASSIGN "F2" "Top" SECTION "S15"
$ LOAD PATTERNS
  LOADPATTERN "DEAD"  TYPE "Dead"  SELFWEIGHT 1
  LOADPATTERN "LIVE"  TYPE "Live"  SELFWEIGHT 0
$ SHELL OBJECT LOADS
  AREALOAD "F1" "Top" TYPE "UNIFF" DIR "GRAV" LC "LIVE" FVAL 3
  AREALOAD "F2" "Top" TYPE "UNIFF" DIR "GRAV" LC "LIVE" FVAL 2
]]
local function e2k(options)
  return import.e2k { file = write("floor.e2k", etabs), slabs = options }
end

local asked = { reinforcement = bars, bending = bent }

case("a floor of SAP2000, of ETABS and of the scripts of both moves as the same floor made by hand", function()
  local hand, rows = by_hand()
  local of_hand = solve(hand)
  local wanted = { { rows[4][0]:displacement(of_hand) }, { rows[8][4]:displacement(of_hand) } }
  expect(wanted[1][3] < -1e-5, "it sags by %g m", -wanted[1][3])
  for name, frame in pairs { s2k = (s2k(two_bays(), asked)), e2k = (e2k(asked)) } do
    local names = name == "s2k" and { "2", "6" } or { "2@Top", "6@Top" }
    local function compare(what, model, nodes)
      local run = solve(model)
      for i, at in ipairs(names) do
        local u = { nodes[at]:displacement(run) }
        for c = 1, 6 do near(u[c], wanted[i][c], 1e-9, ("%s: %s, number %d, m or rad"):format(what, at, c)) end
      end
    end
    local model, nodes = import.build(frame)
    compare(name, model, nodes)
    local script = import.write(frame, folder .. "/" .. name .. ".lua")
    compare("the script of " .. name, dofile(script))
  end
  local counts = import.build((s2k(two_bays(), asked))):counts()
  equal(counts.elements, 6 * 2 + 7 * 4, "elements: two a column, four a beam")
  equal(counts.nodes, hand:counts().nodes, "nodes")
end)

case("slabs that bend by their layers, with meshes at heights of their own, are built and written", function()
  local meshes = { { x = 393e-6, y = 393e-6, z = -0.05, yield_stress = 500e6 }, { x = 188e-6, z = 0.05 } }
  local frame, notes = s2k(two_bays(), { bending = "layers", reinforcement = meshes, sections = asked.sections })
  expect(tostring(notes):find("2 meshes of bars; bends by its layers", 1, true), "the notes say it:\n%s", notes)
  local sag = {}
  local script = import.write(frame, folder .. "/layers.lua")
  for i, make in ipairs { function() return import.build(frame) end, function() return dofile(script) end } do
    local model, nodes = make()
    sag[i] = select(3, nodes["6"]:displacement(solve(model)))
  end
  expect(sag[1] < -1e-6, "it sags by %g m", -sag[1])
  near(sag[2], sag[1], 1e-9, "the script")
end)

case("weights are those without the option, and the slabs add their own mass alone", function()
  local _, plain_notes = s2k(two_bays())
  for _, way in ipairs { "gravity", "loads" } do
    local options = { self_weight = way }
    for _, name in ipairs { "DEAD", "LIVE" } do
      local without = reaction((s2k(two_bays())), name, options)
      local with = reaction((s2k(two_bays(), asked)), name, options)
      near(with, without, 1e-7 * without, ("%s: vertical reactions under %s, N"):format(way, name))
    end
  end
  local frame, notes = s2k(two_bays(), asked)
  equal(notes.summary.mass_of_members, plain_notes.summary.mass_of_members, "mass of the members")
  equal(notes.summary.mass_of_nodes, plain_notes.summary.mass_of_nodes, "point masses")
  near(notes.summary.mass_of_slabs, 0.15 * 2500 * 60, 1e-9, "mass of the slabs, kg")
  expect(support.has(tostring(notes), "slabs of 60 m^2 22500 kg"), "the summary: %s", notes)
  -- a mass that is not the file's: its weight is asked for
  local other = s2k(two_bays(), { reinforcement = bars, mass = 100 })
  refused("slab '1' weighs 3677.49 N/m^2, and its mass times gravity is 980.665 N/m^2", function()
    import.build(other)
  end)
  near(reaction(other, "DEAD", { self_weight = "loads" }), reaction(frame, "DEAD", { self_weight = "loads" }), 0.1,
    "as loads, N")
end)

case("without the option there is no slab, and nothing else", function()
  for _, options in ipairs { { s2k(two_bays()) }, { s2k(two_bays(), false) }, { e2k() } } do
    local frame, notes = table.unpack(options)
    equal(frame.slabs, nil, "slabs")
    equal(frame.sheets, nil, "sheets")
    for _, m in ipairs(frame.members) do equal(m.elements, nil, "elements of a member") end
    expect(reason_of(notes.assumed, "floors have no stiffness and no mass"), "the note: %s", notes)
    equal(notes.summary.slabs, nil, "the summary")
  end
end)

-- Nodes of elements ---------------------------------------------------------------------------------------------------

-- A bay of a slab has as many panels along a side as the members there have elements, so all of its nodes but those
-- inside are theirs.
local function nodes_of(frame, bays)
  local elements, sum = {}, #frame.nodes
  for _, m in ipairs(frame.members) do
    elements[m.name] = m.elements or 2
    sum = sum + elements[m.name] - 1
  end
  for _, bay in ipairs(bays) do
    local count = {}
    for i, side in ipairs(bay) do
      count[i] = 0
      for _, number in ipairs(side) do count[i] = count[i] + elements[tostring(number)] end
    end
    equal(count[1], count[3], "panels along a side and the one across")
    equal(count[2], count[4], "and along the other two")
    sum = sum + (count[1] - 1) * (count[2] - 1)
  end
  return sum
end

case("a bay beside two others: the nodes along the floor are those of members, and none is free", function()
  -- columns 1 to 8; beams 9 to 18: a beam at x = 3 lies between the bays at y from 0 to 5, none in that from 5 to 9
  local points = { { 0, 0 }, { 3, 0 }, { 8, 0 }, { 0, 5 }, { 3, 5 }, { 8, 5 }, { 0, 9 }, { 8, 9 } }
  local o = storey(points,
    { { 1, 2 }, { 2, 3 }, { 4, 5 }, { 5, 6 }, { 7, 8 }, { 1, 4 }, { 2, 5 }, { 3, 6 }, { 4, 7 }, { 6, 8 } },
    { { "S15", 1, 2, 5, 4, load = 1 }, { "S15", 2, 3, 6, 5 }, { "S15", 4, 6, 8, 7 } })
  local frame, notes = s2k(o, asked)
  equal(#notes, 0, tostring(notes))
  equal(#frame.slabs, 3, "slabs")
  local bays = { { { 9 }, { 15 }, { 11 }, { 14 } }, { { 10 }, { 16 }, { 12 }, { 15 } }, { { 11, 12 }, { 18 }, { 13 },
    { 17 } } }
  local model = import.build(frame)
  equal(model:counts().nodes, nodes_of(frame, bays), "nodes of members, and those inside of the bays")
  near(reaction(frame, "LIVE"), 15e3, 0.1, "load of 1 kN/m2 on 15 m2, N")
  for _, wanted in ipairs { 2, 3, 6 } do
    frame = s2k(o, { reinforcement = bars, panels = wanted })
    model = import.build(frame)
    equal(model:counts().nodes, nodes_of(frame, bays), wanted .. " panels are asked for")
    local fewest = math.huge
    for _, m in ipairs(frame.members) do fewest = support.smallest_of(fewest, m.elements or 99) end
    expect(fewest >= wanted or wanted == 3 and fewest == 4, "%d panels: the fewest are %d", wanted, fewest)
  end
end)

case("areas of a mesh are one slab between the members around", function()
  local points, areas = {}, {}
  for j = 0, 3 do
    for i = 0, 3 do points[#points + 1] = { 2 * i, 1.5 * j } end
  end
  local o = { joints = {}, frames = {}, areas = areas }
  for i, p in ipairs(points) do o.joints[i] = { p[1], p[2], 4 } end
  for _, corner in ipairs { 1, 4, 13, 16 } do
    o.joints[#o.joints + 1] = { points[corner][1], points[corner][2], 0 }
    table.insert(o.frames, { #o.joints, corner })
  end
  for _, edge in ipairs { { 1, 4 }, { 4, 16 }, { 16, 13 }, { 13, 1 } } do table.insert(o.frames, edge) end
  for j = 0, 2 do
    for i = 0, 2 do -- two of them turn the other way
      local a = 4 * j + i + 1
      local ring = i == j and { a, a + 4, a + 5, a + 1 } or { a, a + 1, a + 5, a + 4 }
      areas[#areas + 1] = { "S15", ring[1], ring[2], ring[3], ring[4], load = 2 }
    end
  end
  local frame, notes = s2k(o, asked)
  equal(#frame.slabs, 1, tostring(notes))
  local model = import.build(frame)
  local function side(number) return { number .. "/1", number .. "/2", number .. "/3" } end
  equal(model:counts().nodes, nodes_of(frame, { { side(5), side(6), side(7), side(8) } }), "nodes")
  near(reaction(frame, "LIVE"), 2e3 * 27, 0.1, "load, N")
  near(notes.summary.mass_of_slabs, 27 * 375, 1e-9, "mass, kg")
end)

-- What is no slab -----------------------------------------------------------------------------------------------------

case("what no slab can be stays a load, and the note says why", function()
  local square = { { 0, 0 }, { 6, 0 }, { 6, 5 }, { 0, 5 } }
  local ring = { { 1, 2 }, { 2, 3 }, { 3, 4 }, { 4, 1 } }
  for words, o in pairs {
    ["no members lie along the whole edge of the floor"] = storey(square, { { 1, 2 }, { 2, 3 }, { 3, 4 } },
      { { "S15", 1, 2, 3, 4 } }),
    ["has 3 sides, and slabs have four"] = storey({ { 0, 0 }, { 6, 0 }, { 6, 5 } }, { { 1, 2 }, { 2, 3 }, { 3, 1 } },
      { { "S15", 1, 2, 3 } }),
    ["another slab lies there"] = storey(square, ring, { { "S15", 1, 2, 3, 4 }, { "P10", 1, 2, 3, 4 } }),
    ["member 7 along it lies beside its joints"] = storey(square, ring, { { "S15", 1, 2, 3, 4 } },
      'TABLE:  "FRAME INSERTION POINT ASSIGNMENTS"\n   Frame=7   CardinalPt=10   Transform=Yes   JtOffZI=-0.2   '
      .. "JtOffZJ=-0.2"),
    ["the material 'C30' of its section 'No' is not read"] = storey(square, ring, { { "S15", 1, 2, 3, 4 } }),
  } do
    local options = asked
    if words:find "'No'" then
      o.areas[1][1] = "No"
      o.more = 'TABLE:  "AREA SECTION PROPERTIES"\n   Section=No   Material=Wood   Thickness=0.1'
      words = words:gsub("C30", "Wood")
    end
    local frame, notes = s2k(o, options)
    local note = reason_of(notes, "it is not laid as a slab: ")
    expect(note and support.has(note.reason, words), "no '%s': %s", words, notes)
    expect(#frame.slabs == (words:find "another" and 1 or 0), "%s: %d slabs", words, #frame.slabs)
    import.build(frame, { self_weight = "loads" }):close()
  end
  -- the load of a triangle is there without a slab
  local frame = s2k(storey({ { 0, 0 }, { 6, 0 }, { 6, 5 } }, { { 1, 2 }, { 2, 3 }, { 3, 1 } },
    { { "S15", 1, 2, 3, load = 2 } }), asked)
  near(reaction(frame, "LIVE"), 2e3 * 15, 1e-3, "load, N")
end)

case("a wall between members is a slab, and its weight is read; one without a member below is named", function()
  local o = { joints = { { 0, 0, 0 }, { 6, 0, 0 }, { 0, 0, 3 }, { 6, 0, 3 }, { 0, 0, 6 }, { 6, 0, 6 } },
    frames = { { 1, 3 }, { 2, 4 }, { 3, 5 }, { 4, 6 }, { 3, 4 }, { 5, 6 } },
    areas = { { "S15", 3, 4, 6, 5 }, { "S15", 1, 2, 4, 3 } } }
  local frame, notes = s2k(o, { reinforcement = bars })
  equal(#frame.slabs, 1, tostring(notes))
  expect(reason_of(notes, "no members lie along the whole edge"), "the wall below: %s", notes)
  expect(reason_of(notes, "1 area of 18 m^2 in all (floors and walls) is not read"), "its weight: %s", notes)
  local steel = notes.summary.mass_of_members
  near(reaction(frame, "DEAD"), (steel + 18 * 375) * g, 0.1, "weight of the frame and of one wall, N")
end)

-- What slabs are made of ----------------------------------------------------------------------------------------------

case("thickness, moduli and strengths come from the file; what it lacks is asked for", function()
  local sheet = s2k(two_bays(), asked).sheets[1]
  equal(("%g %g %g %g"):format(sheet.concrete.thickness, sheet.concrete.E, sheet.concrete.strength,
    sheet.concrete.density), "0.15 3.3e+10 3e+07 2500", "concrete")
  near(sheet.bending.stiffness, 0.25 * 33e9 * 0.15 ^ 3 / (12 * 0.96), 1e-3, "M11Mod and M22Mod")
  -- a layered section has its bars; a plate of steel yields as the file says
  local layered = s2k(two_bays "L20", true)
  local r = layered.sheets[1].reinforcement
  equal(("%g %g %g %g"):format(r.x, r.y, r.yield_stress, r.E), "0.0007 0.0005 5e+08 2e+11", "bars of layers")
  import.build(layered):close()
  local frame, notes = s2k(two_bays "P10", true)
  equal(frame.sheets[1].material .. frame.sheets[1].thickness, "S3550.01", "a plate")
  expect(reason_of(notes.assumed, "a plate of 0.01 m, E 210 GPa, yield stress 355 MPa"), "its note: %s", notes)
  near(reaction(frame, "LIVE"), 150e3, 1, "its load, N")
  refused("slabs of 'S15' are of concrete, and the file has no bars in them; give slabs = { reinforcement", function()
    s2k(two_bays(), true)
  end)
  -- one section by its name, and an elastic plate
  frame = s2k(two_bays(), { sections = { S15 = { reinforcement = { x = 1e-3 } } } })
  equal(frame.sheets[1].reinforcement.x, 1e-3, "bars of one section")
  frame, notes = s2k(two_bays(), { material = "C30" })
  equal(frame.sheets[1].concrete, nil, "no concrete")
  expect(reason_of(notes.assumed, "concrete that never cracks"), "its note: %s", notes)
  near(reaction(frame, "LIVE"), 150e3, 1, "its load, N")
end)

case("wrong options are told", function()
  for words, options in pairs {
    ["field 'slabs' is 4; must be true, false, or a table"] = 4,
    ["slabs: unknown field 'bars'"] = { bars = 3 },
    ["field 'panels' is 0; must be a whole number of at least 1"] = { panels = 0 },
    ["slabs.sections['S15']: unknown field 'panels'"] = { sections = { S15 = { panels = 3 } } },
    ["field 'bending' is true; must be a table, \"layers\" or false"] = { bending = true },
  } do
    refused(words, function() s2k(two_bays(), options) end)
  end
  local frame = s2k(two_bays(), asked)
  frame.slabs[1].load = { SNOW = 1e3 }
  refused("unknown load case 'SNOW'", function() import.build(frame) end)
  frame = s2k(two_bays(), asked)
  frame.slabs[2].sheet = "S51"
  refused("unknown sheet 'S51'", function() import.build(frame) end)
end)

case("hinge export --slabs writes them, and the script runs", function()
  s2k(two_bays(), asked) -- the file
  local program = support.quote(arg[1] .. "/hinge")
  local function run(arguments)
    return support.run(("cd %s && %s %s"):format(support.quote(folder), program, arguments))
  end
  local status, printed, complaint = run "export floor.s2k --slabs 393e-6,500e6 --out floors.lua"
  equal(status, 0, complaint)
  expect(support.has(printed, "slabs of 60 m^2 22500 kg"), "the summary: %s", printed)
  status, printed, complaint = run "run -q floors.lua --out floors"
  equal(status, 0, printed .. complaint)
  if support.is_there(arg[1] .. "/libhinge_output.so") then -- the report has the panels of the frames
    local script = support.read(folder .. "/floors.lua")
    support.write(folder .. "/shown.lua", (script:gsub("job:picture%b()", "job:frame(run)")))
    status, printed, complaint = run "run -q shown.lua --out shown"
    equal(status, 0, printed .. complaint)
    status, printed, complaint = run "report shown --out shown.html"
    equal(status, 0, printed .. complaint)
    expect(support.read(folder .. "/shown.html"):find '"plates":"[%w+/=]+"', "the page has no panels")
  end
  status, printed, complaint = run "export floor.s2k --slabs file --out no.lua"
  equal(printed, "", "nothing is written")
  expect(status == 2 and support.has(complaint, "the file has no bars in them"), "%s", complaint)
  status, printed, complaint = run "export floor.s2k --slabs thick --out no.lua"
  equal(printed, "", "nothing is written")
  expect(status == 2 and support.has(complaint, "--slabs is 'thick'"), "%s", complaint)
end)

checks.done()
