-- hinge.import.tcl: the commands of OpenSees one by one, against closed forms, and against what OpenSees does with
-- them: wipe and remove, masses, supports, constraints, springs, sections of fibres, loads, units. What import.build
-- makes and what import.write writes have the same numbers.
--
-- Run: lua5.4 tests/script/import/import_commands_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local hinge = require "hinge"
local import = require "hinge.import"
local checks = support.checks "commands of OpenSees"
local case, near, equal, expect = checks.case, checks.near, checks.equal, checks.expect

local write = support.writer()
local newton_metres = { length = "m", force = "N" }

-- Reads a script; `more` are further options.
local function read(text, units, more)
  local options = { file = write("frame.tcl", text), units = units or newton_metres }
  for key, value in pairs(more or {}) do options[key] = value end
  return import.tcl(options)
end

local function read_whole(text, units)
  local frame, notes = read(text, units)
  equal(#notes, 0, tostring(notes))
  return frame, notes
end

local function has_note(list, words, what)
  for _, entry in ipairs(list) do
    if (entry.reason or entry.text):find(words, 1, true) or entry.text:find(words, 1, true) then return entry end
  end
  expect(false, "%s: no note has '%s': %s", what or "notes", words, tostring(list))
end

local function refused(what, words, f, ...)
  local good, problem = pcall(f, ...)
  expect(not good and tostring(problem):find(words, 1, true), "%s: wanted '%s', came: %s", what, words,
    tostring(problem))
end

local scripts = 0

-- f(model, nodes, members) of what build makes, and of what the written script makes: both must give the same number.
local function both(frame, f, options)
  local built = f(import.build(frame, options))
  scripts = scripts + 1
  local again = f(dofile(import.write(frame, write(("script_%d.lua"):format(scripts), ""), options)))
  near(again, built, 1e-9 * math.abs(built) + 1e-30, "the written script gives what the built model gives")
  return built
end

local function static(model, loads)
  return model:static { steps = 1, loads = loads or { ["pattern 1"] = 1 } }:finish()
end

-- The displacement of a node along a letter, in the axes of hinge.
local order = { x = 1, y = 2, z = 3, rx = 4, ry = 5, rz = 6 }
local function moved(name, letter, loads)
  return function(model, nodes)
    return (select(order[letter], nodes[name]:displacement(static(model, loads))))
  end
end

local EI, h = 2e11 * 1e-4, 3

-- A column of height h in the plane; `more` follows.
local function column(more, height)
  return ([[
model basic -ndm 2 -ndf 3
node 1 0 0
node 2 0 %g
fix 1 1 1 1
geomTransf Linear 1
element elasticBeamColumn 1 1 2 0.01 2e11 1e-4 1
%s
]]):format(height or h, more or "")
end

local tip = "pattern Plain 1 Linear { load 2 1000. 0. 0. }\n"

-- Which model
-- -----------------------------------------------------------------------------------------------------------

case("wipe begins a new model: the one at the end is read, and `model` chooses", function()
  local three = column(tip .. "analyze 1\n") .. "wipe\n" .. column(tip, 4) .. "wipe\n" .. column(tip, 5)
  local function height(options)
    local frame, notes = read(three, nil, options)
    equal(#frame.nodes .. " " .. #frame.members .. " " .. #frame.cases, "2 1 1", "one model alone")
    return frame.nodes[2].z, notes
  end
  local z, notes = height()
  equal(z, 5, "the last one")
  equal(has_note(notes.assumed, "number 3, which stands at the end").text, "3 models, one after the other", "the note")
  for i = 1, 3 do equal((height { model = i }), 2 + i, "model " .. i) end
  refused("there are three", "field 'model' is 4; ", read, three, nil, { model = 4 })
  -- PL^3 / 3EI of the last one
  near(both(read_whole(three), moved("2", "x")), 1000 * 5 ^ 3 / (3 * EI), 1e-6, "its tip")
end)

case("wipe at the beginning and at the end of a file leaves one model, without a note", function()
  local frame, notes = read_whole("wipe\n" .. column(tip) .. "wipe\n")
  equal(frame.nodes[2].z, 3, "the model")
  for _, entry in ipairs(notes.assumed) do expect(not entry.text:find "models", "no note: %s", tostring(notes)) end
  local python = "import openseespy.opensees as ops\nfor h in (3.0, 4.0):\n    ops.wipe()\n"
    .. "    ops.model('basic', '-ndm', 2, '-ndf', 3)\n    ops.node(1, 0.0, 0.0)\n    ops.node(2, 0.0, h)\n"
    .. "    ops.fix(1, 1, 1, 1)\n    ops.geomTransf('Linear', 1)\n"
    .. "    ops.element('elasticBeamColumn', 1, 1, 2, 0.01, 2e11, 1e-4, 1)\n"
  local of_python = import.tcl { file = write("wipe.py", python), units = newton_metres,
    run_python = true }
  equal(of_python.nodes[2].z, 4, "in Python")
end)

case("remove takes out elements, nodes, patterns, supports; what stood at an analysis is a model of its own", function()
  local text = column [[
node 3 4 3
node 4 4 0
fix 4 1 1 1
element elasticBeamColumn 2 2 3 0.01 2e11 1e-4 1
element elasticBeamColumn 3 4 3 0.01 2e11 1e-4 1
pattern Plain 1 Linear { load 2 1000. 0. 0. }
pattern Plain 2 Linear { load 3 1000. 0. 0. }
analyze 1
remove loadPattern 2
remove element 2
remove element 3
remove node 3
remove node 4
remove sp 1 3
fix 1 0 0 1
]]
  local frame, notes = read_whole(text)
  equal(#frame.nodes .. " " .. #frame.members .. " " .. #frame.cases, "2 1 1", "what is left")
  has_note(notes.assumed, "number 2, which stands at the end")
  near(both(frame, moved("2", "x")), 1000 * h ^ 3 / (3 * EI), 1e-6, "the column alone")
  local before = read(text, nil, { model = 1 })
  equal(#before.nodes .. " " .. #before.members .. " " .. #before.cases, "4 3 2", "what stood at the analysis")
  equal(#read_whole(column "remove element 9\nremove loadPattern 7").members, 1, "what is not there stays away")
end)

case("loadConst: the written scenario holds what acts by then while later patterns act", function()
  local frame, notes = read_whole(column(
    "pattern Plain 1 Linear { load 2 0 -1000. 0. }\nloadConst -time 0.0\npattern Plain 2 Linear { load 2 500. 0 0 }"))
  equal(tostring(frame.cases[1].held) .. " " .. tostring(frame.cases[2].held), "true nil", "held")
  has_note(notes.assumed, "loadConst")
  local text = support.read(import.write(frame, write("held.lua", ""), { scenario = true }))
  expect(text:find('loads = { ["pattern 1"] = 1 }', 1, true) and text:find("from = held", 1, true), "%s", text)
end)

-- Nodes
-- -----------------------------------------------------------------------------------------------------------------

case("a second mass takes the place of the first, and one of 0 takes it away", function()
  local function masses(more)
    local frame = read_whole(column(more))
    local list = {}
    for i, m in ipairs(frame.masses) do list[i] = ("%s:%g"):format(m.node, m.mass) end
    return table.concat(list, " ")
  end
  equal(masses "mass 2 500 500 0\nmass 2 800 800 0", "2:800", "two commands")
  equal(masses "mass 2 500 500 0\nmass 2 0 0 0", "", "none")
  local text = column("mass 2 800 800 0"):gsub("node 2 0 3", "node 2 0 3 -mass 500 500 0")
  local frame = read_whole(text)
  equal(#frame.masses .. " " .. frame.masses[1].mass, "1 800.0", "-mass of the node before")
  equal(masses "mass 2 500 1e-9 1e-9", "2:500", "one that is there for the matrix alone")
end)

-- Transformations, loads, units
-- -------------------------------------------------------------------------------------------

case("displacement is small where all transformations are Linear, and large where one is not", function()
  local soft = [[
model basic -ndm 2 -ndf 3
node 1 0 0
node 2 0 3
node 3 0 6
fix 1 1 1 1
geomTransf %s 1
geomTransf %s 2
element elasticBeamColumn 1 1 2 0.01 2e11 1e-6 1
element elasticBeamColumn 2 2 3 0.01 2e11 1e-6 2
pattern Plain 1 Linear { load 3 100. -5000. 0. }
]]
  local linear, notes = read_whole(soft:format("Linear", "Linear"))
  equal(linear.model and linear.model.displacement, "small", "Linear")
  has_note(notes.assumed, "displacement = 'small'")
  local of_linear = 100 * 6 ^ 3 / (3 * 2e5)
  near(both(linear, moved("3", "x")), of_linear, 1e-5 * of_linear, "PL^3 / 3EI")
  for _, kinds in ipairs { { "PDelta", "PDelta" }, { "Corotational", "Linear" } } do
    local frame, said = read_whole(soft:format(kinds[1], kinds[2]))
    equal(frame.model, nil, table.concat(kinds, " "))
    has_note(said.assumed, kinds[2] == "Linear" and "large for all members: 1 is Linear, 1 PDelta"
      or "displacement is large")
  end
  -- beam-column: tan(u)/u - 1 over u^2/3 of the deflection, u = L sqrt(P / EI)
  local u = 6 * math.sqrt(5000 / 2e5)
  local more = 3 * (math.tan(u) / u - 1) / u ^ 2
  near(both(read_whole(soft:format("PDelta", "PDelta")), moved("3", "x")), of_linear * more, 5e-3 * of_linear * more,
    "with the axial force")
  near(both(linear, moved("3", "x"), { model = { displacement = "large" } }), of_linear * more,
    5e-3 * of_linear * more, "an option of the call goes first")
end)

case("a file without loads has none: no weight is made up", function()
  local frame = read_whole(column "mass 2 100 100 0")
  equal(#frame.cases, 0, "cases")
  local text = support.read(import.write(frame, write("unloaded.lua", ""), { scenario = true }))
  expect(not text:find "gravity" and not text:find "model:case", "%s", text)
end)

case("units are known by their kind, in any order", function()
  local of = require("hinge.import.opensees.units").of_text
  for text, wanted in pairs { ["kN,m"] = "kN m", ["m,kN"] = "kN m", ["lbf,ft"] = "lbf ft", ["in kip"] = "kip in",
    ["mm,tonf"] = "tonf mm", ["N,m,t"] = "N m t", ["t, mm, N"] = "N mm t" } do
    local u = of("--units", text)
    equal(("%s %s%s"):format(u.force, u.length, u.mass and " " .. u.mass or ""), wanted, text)
  end
  for text, words in pairs { ["MPa,m"] = "'MPa' is a unit of stress",
    ["lb,ft"] = "'lb' is a mass; as a force it is lbf",
    ["kg,m"] = "as a force it is kgf", ["t,m"] = "as a force it is tonf", ["kN,N"] = "both units of force",
    ["kN"] = "no unit of length", ["kN,m,kg,s,5"] = "more units than", ["furlong,N"] = "unknown unit 'furlong'" } do
    refused(text, words, of, "--units", text)
  end
  local function force(units) return read(column(tip), units).cases[1].loads[1].force[1] end
  near(force { length = "ft", force = "lbf" }, 4448.2216152605, 1e-9, "lbf")
  near(force { length = "m", force = "kgf" }, 9806.65, 1e-9, "kgf")
  near(force { length = "m", force = "tonf" }, 9806650, 1e-6, "tonf")
  near(force { length = "in", force = "kips" }, 4448221.6152605, 1e-6, "kips")
  near(hinge.units.kgf * 1000, hinge.units.tonf, 1e-9, "in hinge.units")
  for _, name in ipairs { "lb", "kg", "t" } do
    refused(name .. " as a force", "is a mass, as a force it is", read, column(tip), { length = "m", force = name })
  end
  refused("a length as a force", "units.force is 'm'", read, column(tip), { length = "m", force = "m" })
end)

-- Elements ------------------------------------------------------------------------------------------------------------

-- End forces of a member under the first pattern.
local function end_moments(name, letter)
  return function(model, _, members)
    local a, b = members[name]:forces(static(model))
    return math.abs(a["M" .. letter]) + 1e-3 * math.abs(b["M" .. letter])
  end
end

case("-release, -releasez and -releasey free the bending of each end about its axis", function()
  local beam = [[
model basic -ndm 2 -ndf 3
node 1 0 0
node 2 6 0
fix 1 1 1 1
fix 2 1 1 1
geomTransf Linear 1
element elasticBeamColumn 1 1 2 0.01 2e11 1e-4 1 -release %d
pattern Plain 1 Linear { eleLoad -ele 1 -type -beamUniform -8000. }
]]
  -- q L^2 / 12 at both ends, q L^2 / 8 at the one that is held
  for code, wanted in pairs { [0] = 24024, [1] = 36, [2] = 36000, [3] = 0 } do
    near(both(read_whole(beam:format(code)), end_moments("1", "x")), wanted, 1e-3 * 36e3, "-release " .. code)
  end
  local space = [[
model basic -ndm 3 -ndf 6
node 1 0 0 0
node 2 0 6 0
fix 1 1 1 1 1 1 1
fix 2 1 1 1 1 1 1
geomTransf Linear 1 0 0 1
element elasticBeamColumn 1 1 2 0.01 2e11 8e10 1e-4 1e-4 2e-4 1 %s
pattern Plain 1 Linear { eleLoad -ele 1 -type -beamUniform %s }
]]
  -- about z of OpenSees, for loads along its y, is about y of hinge; about y, for loads along z, is about x
  for _, r in ipairs { { "-releasez 1", "-8000. 0.", "y", 36 }, { "-releasez 2", "-8000. 0.", "y", 36000 },
    { "-releasey 1", "-8000. 0.", "y", 24024 }, { "-releasey 1", "0. -8000.", "x", 36 },
    { "-releasey 3 -releasez 1", "0. -8000.", "x", 0 }, { "-releasey 3 -releasez 1", "-8000. 0.", "y", 36 } } do
    near(both(read_whole(space:format(r[1], r[2])), end_moments("1", r[3])), r[4], 1e-3 * 36e3, r[1] .. " " .. r[2])
  end
end)

case("trusses: bars that are pinned at both ends, alone and beside frames, in the plane and in space", function()
  -- a bracket: two bars of EA from (0, 0) and (0, 3) to (4, 0), loaded by P downwards
  local EA, P = 2e11 * 1e-3, 1e4
  local bracket = [[
model basic -ndm 2 -ndf %d
node 1 0 0
node 2 0 3
node 3 4 0
fix 1 1 1%s
fix 2 1 1%s
uniaxialMaterial Elastic 1 2e11
element truss 1 1 3 1e-3 1
element %s 2 2 3 1e-3 1
pattern Plain 1 Linear { load 3 0 -1e4%s }
]]
  -- bar 2 carries P / sin = 5/3 P, bar 1 -4/3 P; virtual work
  local down = P / EA * ((5 / 3) ^ 2 * 5 + (4 / 3) ^ 2 * 4)
  for _, r in ipairs { { 2, "", "truss" }, { 3, " 1", "truss" }, { 3, " 0", "corotTruss" } } do
    local frame = read_whole(bracket:format(r[1], r[2], r[2], r[3], r[1] == 3 and " 0" or ""))
    near(both(frame, moved("3", "z")), -down, (r[3] == "truss" and 1e-7 or 2e-3) * down, r[3] .. " -ndf " .. r[1])
  end
  -- a tripod of three bars from (3, 0, 0), (-1.5, +-2.598, 0) to (0, 0, 4): P L^3 / (3 EA h^2)
  local tripod = [[
model basic -ndm 3 -ndf %d
node 1 3 0 0
node 2 -1.5 2.598076211353316 0
node 3 -1.5 -2.598076211353316 0
node 4 0 0 4
fixZ 0 1 1 1%s
uniaxialMaterial Steel01 1 3e8 2e11 0.01
element truss 1 1 4 1e-3 1
element truss 2 2 4 1e-3 1
element truss 3 3 4 1e-3 1
pattern Plain 1 Linear { load 4 %s%s }
]]
  local wanted = P * 5 ^ 3 / (3 * EA * 16)
  for _, ndf in ipairs { 3, 6 } do
    local zeros = ndf == 6 and " 0 0 0" or ""
    local of_z = both(read_whole(tripod:format(ndf, zeros, "0 0 -1e4", zeros)), moved("4", "z"))
    near(of_z, -wanted, 1e-6 * wanted, "a tripod, -ndf " .. ndf)
    -- across: sum of cos^2 over three directions is 3/2 (3/5)^2
    local of_x = both(read_whole(tripod:format(ndf, zeros, "1e4 0 0", zeros)), moved("4", "x"))
    near(of_x, P * 5 / (EA * 1.5 * 0.36), 1e-6 * of_x, "across")
  end
  -- a section of one deformation
  local of_section = bracket:format(2, "", "", "truss", ""):gsub("element truss 1", "uniaxialMaterial Elastic 2 2e8\n"
    .. "section Uniaxial 7 2 P\nelement truss 1"):gsub("1e%-3 1\n", "7\n")
  near(both(read_whole(of_section), moved("3", "z")), -down, 1e-7 * down, "section Uniaxial")
  -- a brace beside a frame: the tip of the column has the stiffness of both
  local braced = column([[
node 3 4 0
fix 3 1 1 1
uniaxialMaterial Elastic 1 2e11
element truss 2 3 2 1e-4 1
pattern Plain 1 Linear { load 2 1000. 0. 0. }
]])
  local k, column_k, EAc = 2e11 * 1e-4 / 5, 3 * EI / 27, 2e11 * 0.01 / 3
  -- two displacements of the tip: along x and z
  local kxx, kxz, kzz = column_k + k * 0.64, -k * 0.48, EAc + k * 0.36
  near(both(read_whole(braced), moved("2", "x")), 1000 * kzz / (kxx * kzz - kxz ^ 2), 1e-8, "a brace")
end)

-- Constraints ---------------------------------------------------------------------------------------------------------

case("equalDOF ties a floor in a plane frame, and ends at one place; a support holds what follows it", function()
  -- two columns of 3 m and 4 m, whose tips move alike: their stiffnesses add up
  local floor = column [[
node 3 5 -1
node 4 5 3
fix 3 1 1 1
element elasticBeamColumn 2 3 4 0.01 2e11 1e-4 1
%s
pattern Plain 1 Linear { load 2 1000. 0. 0. }
]]
  local stiff = 3 * EI * (1 / 27 + 1 / 64)
  for _, words in ipairs { "equalDOF 2 4 1", "equalDOF 4 2 1" } do
    near(both(read_whole(floor:format(words)), moved("2", "x")), 1000 / stiff, 1e-5 * 1000 / stiff, words) -- shear
  end
  -- a second node at the tip: with displacements alone it is a pin, with rotations it is rigid
  local arm = column [[
node 3 0 3
node 4 4 3
%s
element elasticBeamColumn 2 3 4 0.01 2e11 1e-4 1
fix 4 0 1 0
pattern Plain 1 Linear { load 2 1000. 0. 0. }
]]
  near(both(read_whole(arm:format "equalDOF 2 3 1 2"), moved("2", "x")), 1000 * 27 / (3 * EI), 1e-6, "a pin")
  -- the beam of 4 m on a roller resists the rotation of the tip by 3 EI / 4
  local k = 3 / 4
  local rigid = 1000 * 27 / EI * (4 / 3 + k) / (4 * (1 + 3 * k)) -- h = 3
  local found = both(read_whole(arm:format "equalDOF 2 3 1 2 3"), moved("2", "x"))
  local joined = arm:format(""):gsub("node 3 0 3\n", ""):gsub("2 3 4 0.01", "2 2 4 0.01")
  local one = both(read_whole(joined), moved("2", "x"))
  near(found, one, 1e-7 * one, "rigid")
  expect(found < 0.6 * 1000 * 27 / (3 * EI) and rigid > 0, "it is stiffer")
  -- a node that follows a support is held
  local held = column "node 3 0 3\nnode 4 4 3\nfix 4 1 1 1\nequalDOF 4 2 1 2 3\n"
    .. "pattern Plain 1 Linear { load 2 1000. 0. 0. }"
  local frame = read(held)
  equal(frame.nodes[2].fix, "all", "held with node 4")
end)

case("rigidLink beam is a rigid arm; a node without a member gives its load and mass to the other end", function()
  local text = column [[
node 3 2 3
rigidLink beam 2 3
mass 3 500 500 0
pattern Plain 1 Linear { load 3 0 -1000. 0 }
]]
  local frame = read_whole(text)
  -- the moment 1000 N * 2 m at the tip: M h^2 / 2 EI
  near(both(frame, moved("2", "x")), 2000 * 9 / (2 * EI), 1e-6, "the tip")
  equal(("%s %g"):format(frame.masses[1].node, frame.masses[1].offset[1]), "2 2", "the mass at the end of the arm")
  local arm = column [[
node 3 1 3
node 4 5 3
rigidLink beam 2 3
element elasticBeamColumn 2 3 4 0.01 2e11 1e-4 1
pattern Plain 1 Linear { load 4 0 -1000. 0 }
]]
  -- a moment of 5 kN m at the tip of the column, and a cantilever of 4 m behind an arm of 1 m
  local turn = 5000 * 3 / EI
  near(both(read_whole(arm), moved("4", "z")), -(turn * 5 + 1000 * 64 / (3 * EI) + 1000 * 3 / (2e11 * 0.01)), 1e-6,
    "a beam behind an arm")
end)

case("rigidDiaphragm: a master node with a member, and one without, whose load and mass go to the floor", function()
  -- four columns of 4 m at the corners of 6 m by 4 m; node 9 is in the middle, without a member
  local text = [[
model basic -ndm 3 -ndf 6
node 1 0 0 0
node 2 6 0 0
node 3 6 4 0
node 4 0 4 0
node 5 0 0 4
node 6 6 0 4
node 7 6 4 4
node 8 0 4 4
fixZ 0 1 1 1 1 1 1
geomTransf Linear 1 1 0 0
element elasticBeamColumn 1 1 5 0.01 2e11 8e10 2e-4 1e-4 1e-4 1
element elasticBeamColumn 2 2 6 0.01 2e11 8e10 2e-4 1e-4 1e-4 1
element elasticBeamColumn 3 3 7 0.01 2e11 8e10 2e-4 1e-4 1e-4 1
element elasticBeamColumn 4 4 8 0.01 2e11 8e10 2e-4 1e-4 1e-4 1
]]
  local lonely = text .. [[
node 9 3 2 4
fix 9 0 0 1 1 1 0
mass 9 4000 4000 0 0 0 60000
rigidDiaphragm 3 9 5 6 7 8
pattern Plain 1 Linear { load 9 1000. 0 0 0 0 500. }
]]
  local frame = read_whole(lonely)
  -- each column: 3 EI / h^3 across, its head free to turn but about z; GJ / h of four columns about z
  local k = 3 * 2e11 * 1e-4 / 64
  local turn = 500 / (4 * k * (9 + 4) + 4 * 8e10 * 2e-4 / 4)
  near(both(frame, moved("5", "x")), 1000 / (4 * k) + turn * 2, 1e-5 * 1000 / (4 * k), "a corner, along x")
  near(both(frame, moved("7", "y")), turn * 3, 1e-4 * turn * 3, "a corner, along y")
  local mass, J = 0, 0
  for _, m in ipairs(frame.masses) do
    mass = mass + m.mass
    J = J + m.mass * 13 + (m.inertia and m.inertia[3] or 0)
  end
  near(mass, 4000, 1e-6, "the mass of the floor")
  near(J, 60000, 1e-6, "its inertia about its centre")
  local at_corner = text .. "rigidDiaphragm 3 5 6 7 8\npattern Plain 1 Linear { load 5 1000. 0 0 0 0 -1500. }\n"
  -- 1 kN at the corner is one in the middle and a moment of 1 kN * 2 m
  local second = (2000 - 1500) / (4 * k * 13 + 4 * 8e10 * 2e-4 / 4)
  near(both(read_whole(at_corner), moved("5", "x")), 1000 / (4 * k) + second * 2, 1e-5 * 1000 / (4 * k),
    "a master with a member")
end)

-- Springs -------------------------------------------------------------------------------------------------------------

case("zeroLength and twoNodeLink: elastic springs to the ground and between members", function()
  -- a column on a foot that turns: PL^3 / 3EI + PL^2 / k
  local foot = [[
model basic -ndm 2 -ndf 3
node 1 0 0
node 11 0 0
node 2 0 3
fix 1 1 1 1
geomTransf Linear 1
uniaxialMaterial Elastic 1 5e6
uniaxialMaterial Elastic 2 1e8
%s
element elasticBeamColumn 1 11 2 0.01 2e11 1e-4 1
pattern Plain 1 Linear { load 2 1000. 0. 0. }
]]
  local bends, turns = 1000 * 27 / (3 * EI), 1000 * 9 / 5e6
  for words, wanted in pairs {
    ["equalDOF 1 11 1 2\nelement zeroLength 1 1 11 -mat 1 -dir 6"] = bends + turns,
    ["element zeroLength 1 11 1 -mat 1 -dir 6\nequalDOF 1 11 1 2"] = bends + turns,
    ["fix 11 1 1 0\nelement zeroLength 5 1 11 -mat 1 -dir 6"] = bends + turns,
    ["element zeroLength 5 1 11 -mat 2 2 1 -dir 1 2 6"] = bends + turns + 1000 / 1e8,
    ["element zeroLength 5 1 11 -mat 2 2 1 -dir 1 2 6 -orient 0 1 0 -1 0 0"] = bends + turns + 1000 / 1e8,
    ["element twoNodeLink 5 1 11 -mat 2 2 1 -dir 1 2 3 -orient 1 0 0 0 1 0"] = bends + turns + 1000 / 1e8,
  } do
    local text = foot:format(words):gsub("element elasticBeamColumn 1 ", "element elasticBeamColumn 7 ")
    near(both(read_whole(text), moved("2", "x")), wanted, 2e-5 * wanted, words)
  end
  -- beside a truss, where the ground has no rotations
  local pinned = [[
model basic -ndm 2 -ndf 2
node 1 0 0
node 2 4 0
node 3 4 0
fix 1 1 1
fix 3 1 1
uniaxialMaterial Elastic 1 4e8
uniaxialMaterial Elastic 2 1e6
element truss 1 1 2 1e-2 1
element zeroLength 2 2 3 -mat 2 2 -dir 1 2
pattern Plain 1 Linear { load 2 1000. 0. }
]]
  near(both(read_whole(pinned), moved("2", "x")), 1000 / (1e6 + 1e6), 1e-9, "-ndf 2")
  -- a strut with a length: twoNodeLink along its axis alone, k cos^2 beside the column
  local strut = column([[
node 3 4 0
fix 3 1 1 1
uniaxialMaterial Elastic 1 4e5
element twoNodeLink 2 3 2 -mat 1 -dir 1
pattern Plain 1 Linear { load 2 1000. 0. 0. }
]])
  local k, column_k, EAc = 4e5, 3 * EI / 27, 2e11 * 0.01 / 3
  local kxx, kxz, kzz = column_k + k * 0.64, -k * 0.48, EAc + k * 0.36
  near(both(read_whole(strut), moved("2", "x")), 1000 * kzz / (kxx * kzz - kxz ^ 2), 1e-8, "a strut")
  -- between members, in space: a beam whose end turns on a spring about y of the file
  local space = [[
model basic -ndm 3 -ndf 6
node 1 0 0 0
node 2 0 0 3
node 3 0 0 3
node 4 4 0 3
fix 1 1 1 1 1 1 1
geomTransf Linear 1 0 1 0
uniaxialMaterial Elastic 1 5e6
uniaxialMaterial Elastic 2 1e12
element elasticBeamColumn 1 1 2 0.01 2e11 8e10 2e-4 1e-4 1e-4 1
element elasticBeamColumn 2 3 4 0.01 2e11 8e10 2e-4 1e-4 1e-4 1
element zeroLength 3 2 3 -mat 2 2 2 2 1 2 -dir 1 2 3 4 5 6
pattern Plain 1 Linear { load 4 0 0 -1000. 0. 0. 0. }
]]
  local M = 4000
  local down = M * 3 / EI * 4 + M * 4 / 5e6 + 1000 * 64 / (3 * EI) + 1000 * 3 / 2e9
  near(both(read_whole(space), moved("4", "z")), -down, 2e-5 * down, "in space")
end)

case("zeroLength that yields becomes a joint: at a foot, and between members", function()
  local foot = [[
model basic -ndm 2 -ndf 3
node 1 0 0
node 11 0 0
node 2 0 3
fix 1 1 1 1
geomTransf Linear 1
uniaxialMaterial %s
equalDOF 1 11 1 2
element zeroLength 1 1 11 -mat 1 -dir 6
element elasticBeamColumn 7 11 2 0.01 2e11 1e-4 1
pattern Plain 1 Linear { load 2 10000. 0. 0. }
]]
  -- 30 kN m at the foot; the spring yields at 20 kN m and hardens by 2 %
  local bends = 1e4 * 27 / (3 * EI)
  local elastic, hard = 20e3 / 5e6, 10e3 / (0.02 * 5e6)
  near(both(read_whole(foot:format "Steel01 1 20e3 5e6 0.02"), moved("2", "x")), bends + 3 * (elastic + hard),
    1e-4 * (bends + 3 * (elastic + hard)), "Steel01")
  near(both(read_whole(foot:format "Steel01 1 40e3 5e6 0.02"), moved("2", "x")), bends + 3 * 30e3 / 5e6,
    1e-4 * (bends + 3 * 30e3 / 5e6), "below its strength")
  -- Bilin: K as+ as- My+ My- L L L L c c c c thp+ thp- thpc+ thpc- res res thu thu D D
  local bilin = "Bilin 1 5e6 0.02 0.02 20e3 -20e3 1 1 1 1 1 1 1 1 0.15 0.15 0.3 0.3 0.4 0.4 0.9 0.9 1 1"
  local frame, notes = read_whole(foot:format(bilin))
  near(both(frame, moved("2", "x")), bends + 3 * (elastic + hard), 1e-4 * (bends + 3 * (elastic + hard)), "Bilin")
  has_note(notes.assumed, "up to the greatest moment")
  local imk = "IMKBilin 1 5e6 0.15 0.3 0.9 20e3 1.75 0.4 0.15 0.3 0.9 20e3 1.75 0.4 1 1 1 1 1 1 1 1"
  near(both(read_whole(foot:format(imk)), moved("2", "x")), bends + 3 * (elastic + hard),
    1e-4 * (bends + 3 * (elastic + hard)), "IMKBilin")
  local between = column [[
node 3 0 3
node 4 4 3
uniaxialMaterial Steel01 1 20e3 5e6 0.02
equalDOF 2 3 1 2
element zeroLength 5 2 3 -mat 1 -dir 6
element elasticBeamColumn 7 3 4 0.01 2e11 1e-4 1
pattern Plain 1 Linear { load 4 0. -7500. 0. }
]]
  local M = 30e3
  local down = M * 3 / EI * 4 + (elastic + hard) * 4 + 7500 * 64 / (3 * EI) + 7500 * 3 / 2e9
  near(both(read_whole(between), moved("4", "z")), -down, 1e-4 * down, "between a column and a beam")
end)

-- Sections of fibres --------------------------------------------------------------------------------------------------

-- A cantilever of 3 m with the section 5 that the text makes, loaded across at its tip.
local function cantilever(section, load)
  return ([[
model basic -ndm 2 -ndf 3
node 1 0 0
node 2 0 3
fix 1 1 1 1
geomTransf Linear 1
uniaxialMaterial Steel01 1 3e8 2e11 0.01
%s
element forceBeamColumn 1 1 2 5 5 1
pattern Plain 1 Linear { load 2 %s 0. }
]]):format(section, load or "1000. 0.")
end

case("section Fiber: area and second moments are those of the fibres, strength that of full yield", function()
  local rectangle = "section Fiber 5 {\npatch rect 1 20 4 -0.15 -0.1 0.15 0.1\n}"
  local frame, notes = read_whole(cantilever(rectangle))
  local s, m = frame.sections[1], frame.materials[1]
  near(s.area, 0.06, 1e-12, "area")
  near(s.Ix, 0.2 * 0.3 ^ 3 / 12 * (1 - 1 / 400), 1e-12, "20 fibres: 1 - 1 / n^2 of b h^3 / 12")
  near(s.Mx0, 3e8 * 0.2 * 0.3 ^ 2 / 4, 1, "fy b h^2 / 4")
  near(s.N0, 3e8 * 0.06, 1, "fy A")
  equal(("%g %g"):format(m.yield_stress, m.hardening.tangent), "3e+08 2e+09", "yield stress and hardening")
  has_note(notes.assumed, "fully plastic moments")
  near(both(frame, moved("2", "x")), 1000 * 27 / (3 * 2e11 * s.Ix), 1e-5 * 1000 * 27 / (3 * 2e11 * s.Ix), "elastic")
  -- quad and rect are one, and WFSection2d is its three patches
  local quad = read_whole(cantilever "section Fiber 5 {\npatch quad 1 20 4 -0.15 -0.1 0.15 -0.1 0.15 0.1 -0.15 0.1\n}")
  near(quad.sections[1].Ix, s.Ix, 1e-15, "patch quad")
  local wf = read_whole(cantilever "section WFSection2d 5 1 0.3 0.01 0.2 0.015 40 4").sections[1]
  near(wf.area, 2 * 0.2 * 0.015 + 0.27 * 0.01, 1e-12, "an I: area")
  near(wf.Ix, 0.2 * 0.3 ^ 3 / 12 - 0.19 * 0.27 ^ 3 / 12, 1e-3 * wf.Ix, "an I: second moment")
  -- a pipe: the exact area, pi / 64 (D^4 - d^4) by 64 sectors to 1 %
  local pipe = read_whole(cantilever "section Fiber 5 {\npatch circ 1 64 4 0 0 0.08 0.1 0 360\n}").sections[1]
  near(pipe.area, math.pi * (0.01 - 0.0064), 1e-12, "a pipe: area")
  near(pipe.Ix, math.pi / 4 * (1e-4 - 0.08 ^ 4), 0.01 * pipe.Ix, "a pipe: second moment")
  -- single fibres, off the axis: the axis goes through their centre
  local two = read_whole(cantilever "section Fiber 5 {\nfiber 0.1 0 0.01 1\nfiber 0.3 0 0.01 1\n}").sections[1]
  near(two.Ix, 2 * 0.01 * 0.01, 1e-12, "two fibres")
  near(two.Mx0, 3e8 * 0.02 * 0.1, 1, "two fibres: N0 / 2 times their distance")
  local layer = read_whole(cantilever "section Fiber 5 {\nlayer straight 1 2 0.01 0.1 0 0.3 0\n}").sections[1]
  near(layer.Ix, two.Ix, 1e-15, "a layer of two")
end)

case("section Fiber: a cantilever yields at its fully plastic moment", function()
  local section = "section Fiber 5 {\npatch rect 1 20 4 -0.15 -0.1 0.15 0.1\n}"
  local limit = 3e8 * 0.2 * 0.3 ^ 2 / 4 / 3
  local soft = (cantilever(section, "1. 0."):gsub("2e11 0.01", "2e11 0.0"))
  local frame = read_whole(soft)
  both(frame, function(model)
    local run = model:static { steps = 20, loads = { ["pattern 1"] = 1.2 * limit } }:finish()
    expect(run.reason:find "limit load", "there is a limit load: %s", run.reason)
    near(run.factor, 1 / 1.2, 2e-3, "the limit load by fy b h^2 / 4") -- found to 1e-3 of the load
    return run.factor
  end)
end)

case("section Aggregator adds shear and torsion; section Elastic with shear keeps it", function()
  local text = cantilever("section Elastic 4 2e11 0.01 1e-4\nuniaxialMaterial Elastic 2 1e7\n"
    .. "section Aggregator 5 2 Vy -section 4")
  local wanted = 1000 * 27 / (3 * EI) + 1000 * 3 / 1e7
  near(both(read_whole(text), moved("2", "x")), wanted, 1e-6 * wanted, "Vy")
  local plain = cantilever("uniaxialMaterial Elastic 2 2e9\nuniaxialMaterial ElasticPP 3 2e7 0.002\n"
    .. "section Aggregator 5 2 P 3 Mz")
  local frame = read_whole(plain)
  near(both(frame, moved("2", "x")), 1000 * 27 / (3 * EI), 1e-6, "P and Mz")
  near(frame.sections[1].Mx0, 4e4, 1e-6, "its plastic moment")
end)

case("elements with hinges are elastic between their ends, and yield there", function()
  local section = "section Elastic 4 2e11 0.06 4.5e-4\nsection Fiber 5 {\npatch rect 1 40 1 -0.15 -0.1 0.15 0.1\n}\n"
  for _, words in ipairs { "beamIntegration HingeRadau 1 5 0.15 5 0.15 4\nelement forceBeamColumn 1 1 2 1 1",
    "element beamWithHinges 1 1 2 5 0.15 5 0.15 2e11 0.06 4.5e-4 1" } do
    local text = cantilever(section):gsub("element forceBeamColumn 1 1 2 5 5 1", words)
    local frame = read_whole(text)
    near(frame.sections[1].Ix, 4.5e-4, 1e-12, words)
    near(frame.sections[1].Mx0, 3e8 * 0.2 * 0.3 ^ 2 / 4, 1, words)
    near(both(frame, moved("2", "x")), 1000 * 27 / (3 * 2e11 * 4.5e-4), 1e-7, words)
  end
end)

-- Loads and motion ----------------------------------------------------------------------------------------------------

case("eleLoad -beamPoint is a force at a part of the length", function()
  local text = column "pattern Plain 1 Linear { eleLoad -ele 1 -type -beamPoint -1000. 0.4 500. }"
  -- P a^2 (3 L - a) / 6 EI at the tip; along y of the column is -x
  local a = 0.4 * 3
  near(both(read_whole(text), moved("2", "x")), 1000 * a ^ 2 * (9 - a) / (6 * EI), 1e-8, "across")
  near(both(read_whole(text), moved("2", "z")), 500 * a / (2e11 * 0.01), 1e-14, "along")
end)

case("time series: their factors in statics, their form in dynamics", function()
  local function factor(series) -- of the load in statics
    return both(read_whole(column(series .. "\npattern Plain 1 1 { load 2 1000. 0. 0. }")), moved("2", "x"))
      / (1000 * 27 / (3 * EI))
  end
  near(factor "timeSeries Linear 1 -factor 3", 3, 1e-4, "Linear")
  near(factor "timeSeries Path 1 -dt 0.1 -values {0 1 2} -factor 2", 2, 1e-4, "Path")
  local frame = read_whole(column("timeSeries Path 1 -time {0 1 3} -values {1 0.5 2}\n"
    .. "timeSeries Rectangular 2 0.5 1.5\ntimeSeries Trig 3 0 2 1 -factor 4\n"
    .. "pattern Plain 1 1 { load 2 1. 0. 0. }\npattern Plain 2 2 { load 2 1. 0. 0. }\n"
    .. "pattern Plain 3 3 { load 2 1. 0. 0. }"))
  local function at(points, t)
    for i = 2, #points do
      local p, q = points[i - 1], points[i]
      if t > p[1] and t <= q[1] then return p[2] + (t - p[1]) / (q[1] - p[1]) * (q[2] - p[2]) end
    end
  end
  near(at(frame.cases[1].history, 2), 1.25, 1e-12, "Path with times")
  near(at(frame.cases[2].history, 1), 1, 1e-12, "Rectangular")
  near(at(frame.cases[3].history, 0.25), 1, 1e-3, "Trig")
  near(frame.cases[3].loads[1].force[1], 4, 1e-12, "its factor")
end)

case("UniformExcitation and rayleigh: the ground moves, in the units of the file", function()
  local text = column([[
mass 2 500 500 0
rayleigh 0.5 0.001 0 0.0002
timeSeries Path 1 -dt 0.01 -values {0 1 2 1 0} -factor 9.81
pattern UniformExcitation 1 1 -accel 1 -fact 0.5
]]):gsub("1e%-4 1\n", "1e-4 1 -mass 50\n")
  local frame = read_whole(text)
  equal(("%s %g %g"):format(frame.motions[1].axis, frame.motions[1].dt, frame.motions[1].scale), "x 0.01 4.905",
    "motion")
  equal(("%g %g"):format(frame.damping.alpha, frame.damping.beta), "0.5 0.0012", "damping")
  both(frame, function(model, nodes)
    local run = model:dynamic { dt = 1e-3, duration = 0.2 }:finish()
    -- after the record the foot has the velocity of its acceleration: 4 * 0.01 * 4.905 m/s
    near(nodes["1"]:velocity(run), 0.04 * 4.905, 1e-3, "the velocity of the ground")
    return nodes["2"]:displacement(run)
  end)
  local sine = read_whole(column "mass 2 5 5 0\npattern UniformExcitation 1 1 -accel \"Sine 0 2 0.5 -factor 3\"")
  equal(("%s %d %g %.3g"):format(sine.motions[1].axis, #sine.motions[1].acceleration, sine.motions[1].scale,
    sine.motions[1].dt), "x 401 3 0.005", "a sine of four periods")
  local file = write("quake.txt", "0 1\n2 1 0\n")
  expect(file:find "quake.txt", "a file beside the script")
  local of_file = read_whole(column([[
mass 2 500 500 0
pattern UniformExcitation 1 2 -accel "Series -dt 0.01 -filePath quake.txt -factor 2"
]]), { length = "mm", force = "N" })
  local m = of_file.motions[1]
  equal(("%s %d %g"):format(m.axis, #m.acceleration, m.scale), "z 5 0.002", "of a file")
  local _, notes = read(column "pattern UniformExcitation 1 1 -accel \"Series -dt 0.01 -filePath ../quake.txt\"")
  has_note(notes, "is not below the folder of the script")
end)

checks.done()
