-- The Lua library: sections against formulas found another way, checks and their messages,
-- scenarios, and the models' counts.
--
-- Run: LUA_CPATH="build/?.so" lua5.4 tests/script/library/library_test.lua
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local hinge = require "hinge"
local support = require "support"
local core = require "hinge.core"
local shapes = require "hinge.sections.shapes"
local values = require "hinge.library.values"
local building = require "hinge.models.ten_storey"
local aircraft = require "hinge.models.aircraft"
local with = require "scenes".with

local checks = support.checks "library"
local case, expect = checks.case, checks.expect
local function near(value, wanted, tolerance, what)
  expect(math.abs(value - wanted) <= tolerance * math.abs(wanted), "%s: %.9g, wanted %.9g", what, value, wanted)
end
local refused = checks.refused

case("fully plastic resultants of solid squares are those of the paper", function()
  for _, row in ipairs { { 0.05, 612.5e3, 7656.25, 5893.78 }, { 0.02, 98e3, 490, 377.2 } } do
    local p = shapes.solid { width = row[1], depth = row[1] }.plastic
    near(p.A * 245e6, row[2], 1e-12, "N0")
    near(p.Zx * 245e6, row[3], 1e-12, "Mp about x")
    near(p.Zy * 245e6, row[3], 1e-12, "Mp about y")
    near(p.Zz * 245e6 / math.sqrt(3), row[4], 1e-5, "T0")
  end
  near(shapes.solid { width = 0.05, depth = 0.05 }.J, 0.140577 * 0.05 ^ 4, 1e-6, "J of a square")
  near(shapes.solid { width = 1, depth = 1000 }.J, 1000 / 3 * (1 - 0.63e-3), 1e-6, "J of a strip")
end)

case("properties of walls with sharp corners, of pipes and of rounds are their closed forms", function()
  local function plate(b, d) return { A = b * d, Ix = b * d ^ 3 / 12, Zx = b * d ^ 2 / 4 } end
  local function disc(d) return { A = math.pi * d ^ 2 / 4, Ix = math.pi * d ^ 4 / 64, Zx = d ^ 3 / 6 } end
  local box = shapes.box { width = 0.3, depth = 0.5, web = 0.01, flange = 0.02 }
  local h = shapes.h { depth = 0.4, width = 0.2, web = 0.008, flange = 0.013 }
  local pipe, round = shapes.pipe { diameter = 0.2, thickness = 0.03 }, shapes.round { diameter = 0.2 }
  for what, of in pairs {
    -- the section, its axis, what encloses it, what is taken out of that
    ["box about x"] = { box, "x", plate(0.3, 0.5), plate(0.28, 0.46) },
    ["box about y"] = { box, "y", plate(0.5, 0.3), plate(0.46, 0.28) },
    ["h about x"] = { h, "x", plate(0.2, 0.4), plate(0.192, 0.374) },
    ["pipe"] = { pipe, "x", disc(0.2), disc(0.14) },
    ["round"] = { round, "y", disc(0.2), plate(0, 0) },
  } do
    local shape, axis, whole, hole = table.unpack(of)
    near(shape.area, whole.A - hole.A, 1e-12, what .. ": area")
    near(shape["I" .. axis], whole.Ix - hole.Ix, 1e-12, what .. ": I")
    near(shape.plastic["Z" .. axis], whole.Zx - hole.Zx, 1e-12, what .. ": Z")
  end
  near(h.Iy, 2 * plate(0.013, 0.2).Ix + plate(0.374, 0.008).Ix, 1e-12, "h about y: I")
  near(h.plastic.Zy, 2 * plate(0.013, 0.2).Zx + plate(0.374, 0.008).Zx, 1e-12, "h about y: Z")
  near(pipe.plastic.Zz, math.pi * (0.2 ^ 3 - 0.14 ^ 3) / 12, 1e-12, "plastic torque of the pipe")
  near(box.plastic.Zz, 2 * 0.29 * 0.48 * 0.01, 1e-12, "plastic torque of the box")
end)

-- Shear areas again, from the shear strain energy of the wall flows: I^2 / integral of Q^2 / t.
local function energy_area(b, height, web, flange, flange_length)
  local I = web * height ^ 3 / 12 + 2 * b * flange * height ^ 2 / 4
  local flow = 4 * flange_length ^ 3 / 3 * flange * height ^ 2 / 4 -- four outstands, Q = t h s / 2
  local n = 20000
  for i = 1, n do
    local y = height / 2 * (i - 0.5) / n
    local Q = b * flange * height / 2 + web / 2 * (height ^ 2 / 4 - y ^ 2)
    flow = flow + 2 * Q ^ 2 / web * height / 2 / n
  end
  return I ^ 2 / flow
end
case("shear areas are those of the strain energy of the wall flows", function()
  local thin_h = shapes.h { depth = 0.4004, width = 0.2, web = 0.0005, flange = 0.0004 }
  near(thin_h.shear_area_y, energy_area(0.2, 0.4, 0.0005, 0.0004, 0.1), 3e-3, "shear area of a thin H")
  local thin_box = shapes.box { width = 0.3005, depth = 0.4004, web = 0.0005, flange = 0.0004 }
  near(thin_box.shear_area_y, energy_area(0.3, 0.4, 0.001, 0.0004, 0.15), 3e-3, "shear area of a thin box")
  -- A box has two of each: along y its webs carry and its flanges hang on them, along x the other way round.
  for _, b in ipairs {
    { width = 0.2, depth = 0.5, web = 0.0002, flange = 0.0012 },
    { width = 0.2, depth = 0.5, web = 0.0012, flange = 0.0002 },
    { width = 0.6, depth = 0.25, web = 0.0005, flange = 0.0003 },
  } do
    local wide, high = b.width - b.web, b.depth - b.flange -- between the middles of the walls
    local what = ("shear area of a box %g x %g m, web %g m, flange %g m, along "):format(b.width, b.depth, b.web,
      b.flange)
    local s = shapes.box(b)
    near(s.shear_area_y, energy_area(wide, high, 2 * b.web, b.flange, wide / 2), 1e-3, what .. "y")
    near(s.shear_area_x, energy_area(high, wide, 2 * b.flange, b.web, high / 2), 1e-3, what .. "x")
    -- turned by a quarter it is the box with the names exchanged
    local turned = shapes.box { width = b.depth, depth = b.width, web = b.flange, flange = b.web }
    near(turned.shear_area_x, s.shear_area_y, 1e-12, what .. "y, turned")
    near(turned.shear_area_y, s.shear_area_x, 1e-12, what .. "x, turned")
  end
  near(shapes.box { width = 1, depth = 1, thickness = 1e-4 }.shear_area_x / 4e-4, 5 / 12, 1e-3,
    "shear area of a thin square tube")
  near(shapes.pipe { diameter = 1, thickness = 1e-4 }.shear_area_x / (math.pi * 1e-4), 0.5, 1e-3,
    "shear area of a thin pipe")
end)

case("wrong input names function, field, value, unit and what is allowed", function()
  local section, walls = hinge.section, { width = 0.4, depth = 0.4 }
  local function box(more) return function() section.box(with(walls, more)) end end
  for _, row in ipairs {
    { { "hinge.section.box", "'width'", "-0.4 m", "above 0" }, box { width = -0.4, thickness = 0.02 } },
    { { "'thickness'", "0.2 m", "half the width" }, box { thickness = 0.2 } },
    { "'flange' is missing", box { web = 0.02 } },
    { { "unknown field 'widht'", "mean 'width'?" }, function() section.solid { widht = 0.4, depth = 0.4 } end },
    { { "'thickness' is missing", "above 0 m" }, function() section.pipe { diameter = 0.1 } end },
    { { "'diameter'", "above 0 m" }, function() section.pipe { diameter = 0 / 0, thickness = 0.01 } end },
    { "has no name", function() section.h { 0.4 } end },
    { "did you mean 'box'?", function() return section.bx end },
    { "did you mean 'model'?", function() return hinge.modell end },
    { "the model is missing", function() building.add() end },
  } do refused(row[1], row[2]) end
  for word, meant in pairs { ["elements per member"] = "elements_per_member", sizte = "size", szie = "size",
    SIZE = "size", asi_gauss = "asi-gauss", vx = "vz" } do
    local said = core.did_you_mean(word, { "dt", "elements_per_member", "size", "asi-gauss", "vz" })
    expect(said == (" (did you mean '%s'?)"):format(meant), word .. said)
  end
  for _, word in ipairs { "zzz", "", "t", "speed" } do
    expect(core.did_you_mean(word, { "size", "d", "asi-gauss" }) == "", "nothing is near '" .. word .. "'")
  end
end)

case("values from the command line are sums, lists and texts", function()
  for text, wanted in pairs { ["440/3.6"] = 440 / 3.6, ["2e-5"] = 2e-5, ["-2^2"] = -4, ["2*(3+4)-1"] = 13,
    ["8/2/2"] = 2, [" 1 - 2 - 3 "] = -4, [".5"] = 0.5, ["2^3^2"] = 512, ["2*pi"] = 2 * math.pi, ["2^-1"] = 0.5 } do
    expect(values.number(text) == wanted, text .. " is " .. tostring(values.number(text)))
  end
  for _, text in ipairs { "", "1+", "os.exit()", "1/0", "0x", "1 2", "(1", "pin", "3,4", "nan" } do
    expect(values.number(text) == nil, "'" .. text .. "' is not a number")
  end
  expect(math.type(values.like("20/2", 10)) == "integer", "whole stays whole")
  expect(values.like("{4, 2*3}", { 1, 1 })[2] == 6 and values.like("true", false) == true
    and values.like("x", "y") == "x", "types")
end)

case("a scenario's parameters are its own, then the case's, then those given", function()
  local function make(change)
    local made = hinge.scenario(with({ parameters = { speed = 100, model = "a" }, cases = { II = { speed = 80 } },
      accuracy = { dt = { 1e-5, 2e-5 } }, run = function() end }, change))
    return made -- no tail call: the error stands at the line above
  end
  local p = make():values("II", { { "dt", "4e-5" }, { "model", "b" } })
  expect(p.speed == 80 and p.dt == 4e-5 and p.model == "b" and make():values().dt == 1e-5, "merged parameters")
  for _, row in ipairs {
    { { "unknown parameter 'sped'", "mean 'speed'?" }, function() make():values(nil, { { "sped", "1" } }) end },
    { { "speed=fast", "440/3.6" }, function() make():values(nil, { { "speed", "fast" } }) end },
    { { "unknown case 'IV'", "II" }, function() make():values "IV" end },
    { "did you mean 'speed'?", function() return p.sped end },
    { { "case II", "unknown parameter 'size'" }, make, { cases = { II = { size = 1 } } } },
    { { "case II", "speed is 'x'", "must be a number" }, make, { cases = { II = { speed = "x" } } } },
    { "accuracy.dt", make, { accuracy = { dt = {} } } },
    { { "'run'", "a function" }, make, { run = false } },
  } do refused(table.unpack(row)) end
end)

case("building and aircraft have the members, masses and degrees of freedom of the paper", function()
  -- Models: the paper's 1698 elements and 7308 degrees of freedom.
  local model = hinge.model { elements_per_member = 2 }
  local frame = building.add(model, { design = "heavy" })
  local counts = model:counts()
  expect(counts.members == 650 and counts.free_dofs == 6 * (250 + 650), "building: 650 members, 250 free joints")
  near(frame.mass, 9805e3, 1e-4, "mass of the building")
  near(frame.floor_load, 912, 1e-3, "floor load")
  local light = building.add(hinge.model {}) -- by hand: (875 x 4176 + 2320 x 2612) mm^2 m x 7850 kg/m^3, 21 times
  near(light.mass, 21 * 7850 * (875 * 4176e-6 + 2320 * 2612e-6), 1e-9, "mass of the light building")
  near(light.floor_load, 20 / 21 * light.mass / (10 * 16 * 5.8 ^ 2), 1e-9, "its floor load")
  local _, parts = aircraft.add(model)
  counts = model:counts()
  expect(counts.members == 849 and counts.elements == 1698 and counts.free_dofs == 7308, "the paper's counts")
  expect(parts.members == 199 and parts.joints == 119, "aircraft: 199 members, 119 joints")
end)

case("the aircraft is in one piece, has its mass, and flies where it heads", function()
  -- What they hand to a model, seen by one that only listens.
  local function listen(add, options)
    local heard = { points = {}, members = {}, fixed = 0, group = function(_, name) return name end }
    function heard:node(point) self.points[#self.points + 1] = point return #self.points end
    function heard:fix() self.fixed = self.fixed + 1 end
    function heard:member(m) self.members[#self.members + 1] = m end
    function heard:velocity(_, v) self.speed = v end
    local _, facts = add(heard, options)
    local parent, total = {}, 0
    local function root(i) while parent[i] do i = parent[i] end return i end
    for _, m in ipairs(heard.members) do
      local a, b, cross, l, u = heard.points[m[1]], heard.points[m[2]], 0, 0, 0
      local d = { b[1] - a[1], b[2] - a[2], b[3] - a[3] }
      for k = 1, 3 do
        local i, j = k % 3 + 1, (k + 1) % 3 + 1
        cross, l, u = cross + (d[i] * m.up[j] - d[j] * m.up[i]) ^ 2, l + d[k] ^ 2, u + m.up[k] ^ 2
      end
      expect(cross > 0.1 * l * u, "up is too near the member's direction")
      total = total + math.sqrt(l)
      if root(m[1]) ~= root(m[2]) then parent[root(m[1])] = root(m[2]) end
    end
    local pieces = 0
    for i = 1, #heard.points do pieces = pieces + (parent[i] and 0 or 1) end
    return heard, pieces, total, facts
  end
  local heard, pieces, total, facts = listen(aircraft.add, { heading = { 0, -2, 0 }, speed = 50, position = { 1, 2,
    3 } })
  expect(pieces == 1, "the aircraft is in one piece")
  near(total, 229.5, 1e-3, "length of the aircraft's members")
  near(facts.length * facts.density * aircraft.designs.stiff.section.area, 15000, 1e-12, "its mass")
  near(select(2, aircraft.add(hinge.model {}, { design = "slender" })).density
    * shapes.box { width = 0.12, depth = 0.12, thickness = 0.006 }.area * total, 15000, 1e-12,
    "mass of the slender one")
  refused({ "unknown design 'lihgt'", "'light'" },
    function() building.add(hinge.model {}, { design = "lihgt" }) end)
  expect(heard.speed[1] == 0 and heard.speed[2] == -50, "it flies where it heads")
  expect(heard.points[1][1] == 1 and heard.points[1][2] == 2, "its nose is where it was put")
  expect(select(2, listen(aircraft.add, { heading = { 1, 1, 0.5 } })) == 1, "any heading will do")
  near(select(3, listen(aircraft.add, { size = 12 })), 229.5 * 12 / 15, 1e-3, "a smaller one")
  heard, pieces = listen(building.add, { bays = { 1, 2 }, storeys = 3 })
  expect(pieces == 1 and heard.fixed == 6 and #heard.points == 24 and #heard.members == 18 + 21, "a smaller building")
end)

-- What all folders of the library use ---------------------------------------------------------------------------------

case("tables as text: widths in letters, columns to the left and to the right", function()
  local columns = require "hinge.library.columns"
  local rows = { { "√f", "N" }, { "beam", 12.5 }, { "", "" } }
  local function lines(...) return table.concat(columns.lines(...), "|") end
  expect(lines(rows) == "√f       N|beam  12.5|", "the first to the left: %s", lines(rows))
  expect(lines(rows, {}, "> ") == ">   √f     N|> beam  12.5|>", "all to the right: %s", lines(rows, {}, "> "))
  expect(lines(rows, "all") == "√f    N|beam  12.5|", "all to the left: %s", lines(rows, "all"))
end)

case("the kind of an object of hinge, and of what is none", function()
  local model = hinge.model()
  local steel, bar = hinge.material { E = 206e9 }, hinge.section.solid { width = 0.05, depth = 0.05 }
  local a, b = model:node { 0, 0, 0 }, model:node { 1, 0, 0 }
  model:fix(a)
  local member = model:member { a, b, section = bar, material = steel, group = "arm" }
  local kinds = { model = model, node = a, member = member, group = model:group "arm", material = steel, section = bar,
    run = model:static() }
  for kind, object in pairs(kinds) do
    expect(core.kind_of(object) == kind, "a %s is called %s", kind, tostring(core.kind_of(object)))
  end
  for _, other in ipairs { 1, "model", {}, io.stdout, print } do
    expect(core.kind_of(other) == nil, "%s is called %s", tostring(other), tostring(core.kind_of(other)))
  end
end)

case("library requires no other folder, no file requires those of the paper, and none is long", function()
  local data = { ["sections/profiles/american.lua"] = true }
  local folder = support.root .. "lua/hinge/"
  for path in support.output("cd " .. support.quote(folder) .. " && find . -name '*.lua'"):gmatch "%./([^\n]+)" do
    local text, count = support.read(folder .. path), 0
    for _ in text:gmatch "\n" do count = count + 1 end
    expect(count <= 450 or data[path], "lua/hinge/%s has %d lines; at most 450", path, count)
    for module in text:gmatch 'require "(hinge[%w_.]*)"' do
      expect(not path:find "^library/" or module == "hinge.core" or module:find "^hinge%.library%.",
        "lua/hinge/%s requires %s", path, module)
      expect(module ~= "hinge.paper" or path:find "^models/" or path:find "^words/" or path:find "^program/sandbox",
        "lua/hinge/%s requires %s", path, module)
    end
  end
end)

checks.done()
