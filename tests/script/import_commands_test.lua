-- hinge.import.tcl: the commands of OpenSees one by one, against closed forms, and against what OpenSees does with
-- them: wipe and remove, masses, supports, constraints, springs, sections of fibres, loads, units. What import.build
-- makes and what import.write writes have the same numbers.
--
-- Run: lua5.4 tests/script/import_commands_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "?.lua;" .. package.path
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
  local of_python = import.tcl { file = write("wipe.py", python), units = newton_metres }
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
  refused("what is not there", "element 9 is not there", read, column "remove element 9")
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

checks.done()
