-- hinge.import.csv: tables of nodes, members and so on. Names, separators, decimal commas, supports by columns,
-- releases of both ends, plastic moduli; broken tables are refused with the line.
--
-- Run: lua5.4 tests/script/import/import_csv_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local files = require "import.files"
local scenes = require "scenes"
local hinge = require "hinge"
local import = require "hinge.import"
local checks = support.checks "tables of import"
local case, near, equal, expect, refused = checks.case, checks.near, checks.equal, checks.expect, checks.refused

local write = support.writer()

-- Reads tables given as text; those left out are not read.
local function csv(tables)
  local paths = {}
  for name, text in pairs(tables) do paths[name] = write(name .. ".csv", text) end
  local frame, notes = import.csv(paths)
  return frame, notes
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
  files.notes_are(expect, "csv", notes, 0, { [1] = "name, x, y, z" })
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

-- A beam of 6 m between fixed supports under 8 kN/m.
local beam = { nodes = "name,x,y,z\n1,0,0,0\n2,6,0,0\n", sections = "name,area,Ix,Iy,J\nS,0.01,1e-4,1e-5,1e-6\n",
  members = "name,a,b,section,material\nm,1,2,S,steel\n", materials = "name,E,G\nsteel,2.1e11,8e10\n",
  supports = "node,x,y,z,rx,ry,rz\n1,1,1,1,1,1,1\n2,1,1,1,1,1,1\n", loads = "case,member,qz\ndead,m,-8000\n" }

case("CSV: release_a and release_b are each at their own end", function()
  local function frame(release_a, release_b)
    return csv(scenes.with(beam, { members = ("name,a,b,section,material,up_x,up_y,up_z,release_a,release_b\n"
      .. "m,1,2,S,steel,0,0,1,%s,%s\n"):format(release_a, release_b) }))
  end
  for _, r in ipairs { { "", "", 24e3, 24e3 }, { "rx", "", 0, 36e3 }, { "", "rx", 36e3, 0 }, { "rx", "rx", 0, 0 } } do
    local read = frame(r[1], r[2])
    local release = read.members[1].release
    equal(release and release.a, r[1] ~= "" and r[1] or nil, "release at a")
    equal(release and release.b, r[2] ~= "" and r[2] or nil, "release at b")
    local model, _, members = import.build(read, { model = { displacement = "small" } })
    local at_a, at_b = members.m:forces(model:static { steps = 1, loads = { dead = 1 } }:finish())
    -- q L^2 / 12 at both ends, q L^2 / 8 at the one that is held, less 0.3 % by shear strain
    near(math.abs(at_a.Mx), r[3], 5e-3 * 36e3, ("moment at a of '%s', '%s'"):format(r[1], r[2]))
    near(math.abs(at_b.Mx), r[4], 5e-3 * 36e3, ("moment at b of '%s', '%s'"):format(r[1], r[2]))
  end
  local several = frame("rx;ry", "rz ry").members[1].release
  equal(several.a .. " " .. several.b, "rx,ry rz,ry", "several at each end")
end)

case("CSV: plastic moduli and G", function()
  local _, _, its = import.build((csv(scenes.with(beam, {
    sections = "name,area,Ix,Iy,J,Zx,Zy\nS,0.01,1e-4,1e-5,1e-6,7e-4,2e-4\n" }))))
  near(its.m.section.Zx, 7e-4, 1e-12, "Zx")
  near(its.m.section.Zy, 2e-4, 1e-12, "Zy")
  near(its.m.material.G, 8e10, 1, "G")
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
    { { members = "name,a,b,section,material,release_a\nm,1,2,HEB 300,S355,x\n" },
      "members.csv:2: column 'release_a' is 'x'; must be rotations" },
    { { sections = "name,area,Ix,Iy,J\ns,1,1,0,1\n" }, "sections.csv:2: column 'Iy' is 0; must be above 0" },
    { { sections = "name,area,Ix,Iy\ns,1,1,1\n" }, "sections.csv:2: the cell of column 'J' is empty" },
    { { supports = "node,fix\n1,rq\n" }, "supports.csv:2: column 'fix' is 'rq'" },
    { { loads = "node,member,fx\n1,m,5\n" }, "loads.csv:2: give either a node or a member" },
    { { loads = "member,fx\nm,5\n" }, "loads.csv:2: a load on a member has qx" },
    { { loads = "member,qx,axes\nm,5,up\n" }, "loads.csv:2: column 'axes' is 'up'" },
    { { masses = "node,mass\n1,-5\n" }, "masses.csv:2: column 'mass' is -5 kg" },
  } do
    refused(row[2], csv, scenes.with({ nodes = two_nodes, members = one_member }, row[1]))
  end
end)

checks.done()
