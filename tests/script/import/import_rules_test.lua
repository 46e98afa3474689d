-- hinge.import, rules of its formats one by one, by hand: releases of both ends by CSV, axes of members, units and
-- masses of ETABS.
--
-- Run: lua5.4 tests/script/import/import_rules_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
require "hinge"
local import = require "hinge.import"
local checks = support.checks "rules of import"
local case, near, equal, expect = checks.case, checks.near, checks.equal, checks.expect

local write = support.writer()

-- CSV -----------------------------------------------------------------------------------------------------------------

case("CSV: release_a and release_b are each at their own end", function()
  local function frame(release_a, release_b)
    return import.csv {
      nodes = write("nodes.csv", "name,x,y,z\n1,0,0,0\n2,6,0,0\n"),
      members = write("members.csv", ("name,a,b,section,material,up_x,up_y,up_z,release_a,release_b\n"
        .. "m,1,2,S,steel,0,0,1,%s,%s\n"):format(release_a, release_b)),
      sections = write("sections.csv", "name,area,Ix,Iy,J\nS,0.01,1e-4,1e-5,1e-6\n"),
      materials = write("materials.csv", "name,E,G\nsteel,2.1e11,8e10\n"),
      supports = write("supports.csv", "node,x,y,z,rx,ry,rz\n1,1,1,1,1,1,1\n2,1,1,1,1,1,1\n"),
      loads = write("loads.csv", "case,member,qz\ndead,m,-8000\n"),
    }
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
  expect(not pcall(frame, "x", ""), "a displacement is refused")
end)

case("CSV: plastic moduli, and nu where G is missing", function()
  local function section_of(columns, values, materials)
    local read = import.csv { nodes = write("nodes.csv", "name,x,y,z\n1,0,0,0\n2,6,0,0\n"),
      members = write("members.csv", "name,a,b,section,material\nm,1,2,S,steel\n"),
      sections = write("sections.csv", "name,area,Ix,Iy,J" .. columns .. "\nS,0.01,1e-4,1e-5,1e-6" .. values .. "\n"),
      materials = write("materials.csv", materials or "name,E,G\nsteel,2.1e11,8e10\n"),
      supports = write("supports.csv", "node,x,y,z,rx,ry,rz\n1,1,1,1,1,1,1\n"),
      loads = write("loads.csv", "case,member,qz\ndead,m,-8000\n") }
    return (select(3, import.build(read))).m
  end
  local member = section_of(",Zx,Zy", ",7e-4,2e-4")
  near(member.section.Zx, 7e-4, 1e-12, "Zx")
  near(member.section.Zy, 2e-4, 1e-12, "Zy")
  near(member.material.G, 8e10, 1, "G")
end)

-- Axes ----------------------------------------------------------------------------------------------------------------

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

-- ETABS ---------------------------------------------------------------------------------------------------------------

-- A cantilever 3 m high of a section 0.1 m2 in these units; line: what the material says of weight and mass.
local function etabs(force, length, metre, newton, line)
  local function u(value, power) return ("%.12g"):format(value / metre ^ power) end
  local text = ([[
$ CONTROLS
  UNITS  "%s"  "%s"  "C"
$ STORIES - IN SEQUENCE FROM TOP
  STORY "S1"  HEIGHT %s
  STORY "Base"  ELEV 0
$ MATERIAL PROPERTIES
  MATERIAL  "C"    TYPE "Concrete"  %s
  MATERIAL  "C"    SYMTYPE "Isotropic"  E %.12g  U 0.2
$ FRAME SECTIONS
  FRAMESECTION  "R"  MATERIAL "C"  SHAPE "Rectangular"  D %s B %s
$ POINT COORDINATES
  POINT "1"  0 0
$ LINE CONNECTIVITIES
  LINE  "C1"  COLUMN  "1"  "1"  1
$ POINT ASSIGNS
  POINTASSIGN  "1"  "Base"  RESTRAINT "UX UY UZ RX RY RZ"
$ LINE ASSIGNS
  LINEASSIGN  "C1"  "S1"  SECTION "R"
]]):format(force, length, u(3, 1), line, 30e9 / newton * metre ^ 2, u(0.5, 1), u(0.2, 1))
  return import.e2k { file = write("frame.e2k", text) }
end

case("ETABS in several units: mass from M, or from the weight without M, and E and sizes", function()
  for _, unit in ipairs { { "KN", "M", 1, 1e3 }, { "N", "MM", 1e-3, 1 }, { "KN", "MM", 1e-3, 1e3 },
    { "KN", "CM", 1e-2, 1e3 }, { "KIP", "IN", 0.0254, 4448.2216152605 }, { "LB", "FT", 0.3048, 4.4482216152605 } } do
    local force, length, metre, newton = table.unpack(unit)
    local what = force .. ", " .. length .. ": "
    local weight = 24000 * metre ^ 3 / newton -- 24 kN/m3
    for _, key in ipairs { "WEIGHTPERVOLUME", "W" } do
      local m = etabs(force, length, metre, newton, ("%s %.12g"):format(key, weight)).materials[1]
      near(m.density, 24000 / 9.80665, 1e-4, what .. "density from " .. key)
      near(m.E, 30e9, 1e3, what .. "E")
    end
    -- mass in force s^2 / length, which M gives per volume; 2500 kg/m3 beside a weight that says something else
    local mass = 2500 * metre ^ 4 / newton
    local m = etabs(force, length, metre, newton, ("WEIGHTPERVOLUME %.12g M %.12g"):format(weight, mass)).materials[1]
    near(m.density, 2500, 1e-6, what .. "density from M")
    local frame = etabs(force, length, metre, newton, ("W %.12g"):format(weight))
    local model, nodes, members = import.build(frame, { model = { displacement = "small" } })
    near(nodes["1@S1"].z, 3, 1e-9, what .. "height, m")
    near(members["C1@S1"].section.area, 0.1, 1e-9, what .. "area, m2")
    near(members["C1@S1"].section.Ix, 0.2 * 0.5 ^ 3 / 12, 1e-9, what .. "Ix, m4")
    model:gravity { 0, 0, -9.80665 }
    local run = model:static { steps = 1 }:finish()
    near(select(3, nodes["1@Base"]:reaction(run)), 24000 * 0.1 * 3, 1, what .. "weight, N")
  end
end)

checks.done()
