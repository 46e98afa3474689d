-- hinge.import: one space frame by hand, from text tables of SAP2000, from OpenSees in Tcl and in Python, and from CSV
-- gives the same numbers; so does the script that import.write writes. Frames without a file: releases, offsets and
-- axes of members, by hand; what is no frame is refused.
--
-- Run: lua5.4 tests/script/import/import_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local hinge = require "hinge"
local import = require "hinge.import"
local checks = support.checks "import"
local case, near, equal, expect, refused = checks.case, checks.near, checks.equal, checks.expect, checks.refused

local samples = support.folder .. "import/"
local write, folder = support.writer()
local E, G = 210e9, 210e9 / 2.6
local small = { model = { displacement = "small" } }

local function read_csv()
  return import.csv { nodes = samples .. "nodes.csv", members = samples .. "members.csv",
    sections = samples .. "sections.csv", materials = samples .. "materials.csv", supports = samples .. "supports.csv",
    loads = samples .. "loads.csv" }
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

-- The dimensions of numbers of SAP2000, as powers of force and length.
local dimensions = { E1 = { 1, -2 }, G12 = { 1, -2 }, UnitWeight = { 1, -3 }, UnitMass = { 1, -4 }, FOverLA = { 1, -1 },
  FOverLB = { 1, -1 } }
for powers, names in pairs { [{ 0, 1 }] = "t3 t2 XorR Y Z GlobalX GlobalY GlobalZ AbsDistA AbsDistB",
  [{ 0, 2 }] = "Area AS2 AS3", [{ 0, 3 }] = "Z33 Z22", [{ 0, 4 }] = "TorsConst I33 I22", [{ 1, 0 }] = "F1 F2 F3",
  [{ 1, 1 }] = "M1 M2 M3" } do
  for name in names:gmatch "%S+" do dimensions[name] = powers end
end

-- The sample in kN and m, with its numbers in kip and inch.
local function in_kip_and_inch()
  local kip, inch = 4.4482216152605, 0.0254 -- kN, m
  local text = support.read(samples .. "frame.s2k"):gsub("KN, m, C", "Kip, in, F")
  return (text:gsub("(%w+)=([-%d][%d.e-]*)", function(name, value)
    local p = dimensions[name]
    return p and ("%s=%.17g"):format(name, value / kip ^ p[1] / inch ^ p[2])
  end))
end

local sap_cases, opensees_cases = { "DEAD", "WIND X" }, { "pattern 1", "pattern 2" }
local readers = {
  { "SAP2000", sap_cases, function() return import.s2k { file = samples .. "frame.s2k" } end },
  { "SAP2000 in kip and in", sap_cases, function()
    return import.s2k { file = write("frame.s2k", in_kip_and_inch()) }
  end },
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

-- Frames without a file -----------------------------------------------------------------------------------------------

-- A portal of 4 m by 6 m whose beam has these releases and offsets at its ends; a load of 10 kN/m on it and 1 kN to
-- the side.
local function portal(release, offset)
  return { nodes = { { name = "1", x = 0, y = 0, z = 0, fix = "all" }, { name = "2", x = 0, y = 0, z = 4 },
    { name = "3", x = 6, y = 0, z = 4 }, { name = "4", x = 6, y = 0, z = 0, fix = "all" } },
    materials = { { name = "steel", E = E, density = 7850 } },
    sections = { { name = "HEB 200", named = "HEB 200" } },
    members = { { name = "left", a = "1", b = "2", section = "HEB 200", material = "steel" },
      { name = "beam", a = "2", b = "3", section = "HEB 200", material = "steel", release = release,
        offset = offset },
      { name = "right", a = "4", b = "3", section = "HEB 200", material = "steel" } },
    cases = { { name = "load", loads = { { member = "beam", q = { 0, 0, -10e3 } }, { node = "2",
      force = { 1e3, 0, 0 } } } } }, masses = {} }
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

local dx, dz = 0.18, -0.23
local beside = { a = { dx, 0, dz }, b = { -dx, 0, dz } } -- rigid ends of a beam that hangs below its nodes

-- The sway of the portal with these offsets, by rigid links. dofs: of the link at the beam's first end.
local function by_links(dofs)
  local model = hinge.model(small.model)
  local steel, profile = hinge.material { E = E, density = 7850 }, hinge.section.named "HEB 200"
  local head, ends = {}, {}
  for i = 0, 1 do
    local foot = model:node { 6 * i, 0, 0 }
    head[i], ends[i] = model:node { 6 * i, 0, 4 }, model:node { i == 0 and dx or 6 - dx, 0, 4 + dz }
    model:fix(foot)
    model:member { foot, head[i], section = profile, material = steel }
  end
  local beam = model:member { ends[0], ends[1], section = profile, material = steel }
  model:rigid_link { from = head[0], to = ends[0], dofs = dofs }
  model:rigid_link { from = head[1], to = ends[1] }
  if dofs then -- torsion stays
    model:connector { head[0], ends[0], axes = { x = { 0, -1, 0 }, y = { 0, 0, 1 } },
      stiffness = { rz = 1000 * G * profile.J / (6 - 2 * dx) } }
  end
  model:load { node = head[0], force = { 1e3, 0, 0 } }
  model:load { member = beam, q = { 0, 0, -10e3 } }
  return head[0]:displacement(model:static { steps = 1 }:finish())
end

case("offsets of a beam: as by rigid links, also released, built and written", function()
  local function sway(model, nodes)
    return (nodes["2"]:displacement(model:static { steps = 1, loads = { load = 1 } }:finish()))
  end
  for name, end_ in pairs { rigid = {}, pinned = { release = { a = "rx,ry" }, dofs = "xyz" } } do
    local right, frame = by_links(end_.dofs), portal(end_.release, beside)
    -- the rounding of the solution
    near(sway(import.build(frame, small)) / right, 1, 1e-9, name .. ": sway")
    near(sway(dofile(import.write(frame, folder .. name .. ".lua", small))) / right, 1, 1e-9, name .. ": written")
  end
  local length = require "hinge.import.frame".summary(portal(nil, beside)).length
  near(length, 2 * 4 + 6 - 2 * dx, 1e-12, "length of all members: between their ends")
end)

case("axes of members: y is the part of `up` across the member, x follows", function()
  local axes = require "hinge.import.frame".axes
  for _, r in ipairs { { { 1, 0, 0 }, { 0, 0, 1 } }, { { 0, 0, 1 }, { 1, 0, 0 } }, { { 0.6, 0, 0.8 }, { 0, 0, 1 } },
    { { 0.48, 0.6, 0.64 }, { 0.3, -0.2, 0.9 } }, { { 0, 0.6, -0.8 }, { 1, 2, 3 } }, { { 0.6, 0, 0.8 }, nil },
    { { 0, 0, 1 }, nil } } do
    local z, up = r[1], r[2]
    local x, y = axes(z, up)
    local function dot(a, b) return a[1] * b[1] + a[2] * b[2] + a[3] * b[3] end
    near(dot(y, z), 0, 1e-12, "y is across the member")
    near(dot(y, y), 1, 1e-12, "of length 1")
    near(dot(x, y), 0, 1e-12, "x is across y")
    near(dot(x, z), 0, 1e-12, "and across the member")
    local wanted = up or (math.abs(z[3]) < 0.99 and { 0, 0, 1 } or { 1, 0, 0 })
    local along = dot(wanted, z)
    local size = math.sqrt(dot(wanted, wanted) - along ^ 2)
    near(dot(y, wanted), size, 1e-12, "y is as near to `up` as it can be")
    -- right-handed: x = y x z
    near(dot(x, { y[2] * z[3] - y[3] * z[2], y[3] * z[1] - y[1] * z[3], y[1] * z[2] - y[2] * z[1] }), 1, 1e-12,
      "right-handed")
  end
  equal(axes({ 1, 0, 0 }, { 2, 0, 0 }), nil, "`up` along the member")
end)

case("a frame that is no frame is refused", function()
  local function load(f, given)
    given.member = "beam"
    f.cases[1].loads = { given }
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
    { function(f) f.shells = {} end, "unknown field 'shells'" },
    { function(f) f.members = {} end, "the frame has no member" },
    { function(f) f.members[2].offset = { c = { 0, 0, 0 } } end, "offset: unknown end 'c'" },
    { function(f) f.members[2].offset = { a = { 0, 0 } } end, "offset.a" },
    { function(f) f.members[2].offset = { a = { 6, 0, 0 } } end, "its two ends are at one place" },
    { function(f) load(f, { q = { a = { 0, 0 } } }) end, "q.a" },
    { function(f) load(f, { q = { 0, 0, -1 }, from = 0.5, to = 0.5 }) end, "the load needs a length" },
    { function(f) load(f, { force = { 0, 0, -1 }, from = 0.5 }) end, "'from' and 'to' are for 'q'" },
    { function(f) load(f, { q = { 0, 0, -1 }, to = 1.5 }) end, "field 'to' is 1.5" },
  } do
    local frame = portal { a = "rx" }
    row[1](frame)
    refused(row[2], import.build, frame)
  end
  refused("hinge.import.build: the frame is missing", import.build)
  refused("takes no further argument", import.build, portal(), small, 1)
  refused("it is no script of import.write", import.write, portal(), write("own.lua", "x = 1\n"))
  equal(support.read(folder .. "own.lua"), "x = 1\n", "it is left as it was")
  refused("its name must end in .lua", import.write, portal(), "frame.txt")
  refused("unknown field 'gravty'", import.build, portal(), { gravty = 1 })
  refused("unknown field 's2q'", function() return import.s2q end)
end)

checks.done()
