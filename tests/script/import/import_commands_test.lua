-- hinge.import.tcl: the commands of OpenSees one by one, against closed forms, and against what OpenSees does with
-- them: wipe and remove, masses, supports, constraints, springs, sections of fibres, loads, units. What import.build
-- makes and what import.write writes have the same numbers.
--
-- Run: lua5.4 tests/script/import/import_commands_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local scenes = require "scenes"
local hinge = require "hinge"
local import = require "hinge.import"
local shown = require "import.frame_text".shown
local checks = support.checks "commands of OpenSees"
local case, near, equal, expect = checks.case, checks.near, checks.equal, checks.expect

local write = support.writer()
local newton_metres = { length = "m", force = "N" }

-- Reads a script; `more` are further options.
local function read(text, units, more)
  local file = { file = write("frame.tcl", text), units = units or newton_metres }
  local frame, notes = import.tcl(scenes.with(file, more))
  return frame, notes
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

-- f(model, nodes, members) of what build makes, and of what the written script makes: both must give the same number.
local function both(frame, f, options)
  local built = f(import.build(frame, options))
  local again = f(dofile(import.write(frame, write("script.lua", ""), options)))
  near(again, built, 1e-9 * math.abs(built) + 1e-30, "the written script gives what the built model gives")
  return built
end

-- The displacement of a node along x or z of hinge.
local function moved(name, letter)
  return function(model, nodes)
    local run = model:static { steps = 1, loads = { ["pattern 1"] = 1 } }:finish()
    return (select(letter == "x" and 1 or 3, nodes[name]:displacement(run)))
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

-- Which model ---------------------------------------------------------------------------------------------------------

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
  checks.refused("field 'model' is 4; ", read, three, nil, { model = 4 })
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
  local of_python = import.tcl { file = write("wipe.py", python), units = newton_metres, run_python = true }
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

-- Nodes ---------------------------------------------------------------------------------------------------------------

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

-- Transformations, loads, units ---------------------------------------------------------------------------------------

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
  local of_bar = read_whole(column [[
node 3 4 0
fix 3 1 1 1
uniaxialMaterial Elastic 1 2e11
element corotTruss 2 3 2 1e-4 1
]])
  equal(of_bar.model, nil, "corotTruss")
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
    checks.refused(words, of, "--units", text)
  end
  local function force(units) return read(column(tip), units).cases[1].loads[1].force[1] end
  near(force { length = "ft", force = "lbf" }, 4448.2216152605, 1e-9, "lbf")
  near(force { length = "m", force = "kgf" }, 9806.65, 1e-9, "kgf")
  near(force { length = "m", force = "tonf" }, 9806650, 1e-6, "tonf")
  near(force { length = "in", force = "kips" }, 4448221.6152605, 1e-6, "kips")
  near(hinge.units.kgf * 1000, hinge.units.tonf, 1e-9, "in hinge.units")
  for _, name in ipairs { "lb", "kg", "t" } do
    checks.refused("is a mass, as a force it is", read, column(tip), { length = "m", force = name })
  end
  checks.refused("units.force is 'm'", read, column(tip), { length = "m", force = "m" })
end)

-- Constraints ---------------------------------------------------------------------------------------------------------

case("equalDOF with a support holds what follows it; a mass at the end of a rigid link is on its other end", function()
  local held = read(column "node 3 0 3\nnode 4 4 3\nfix 4 1 1 1\nequalDOF 4 2 1 2 3\n")
  equal(held.nodes[2].fix, "all", "held with node 4")
  local mass = read_whole(column "node 3 2 3\nrigidLink beam 2 3\nmass 3 500 500 0\n").masses[1]
  equal(("%s %g %g"):format(mass.node, mass.mass, mass.offset[1]), "2 500 2", "the mass")
end)

case("rigidDiaphragm: the mass of a master node without a member goes to the floor", function()
  local frame = read_whole [[
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
node 9 3 2 4
fix 9 0 0 1 1 1 0
mass 9 4000 4000 0 0 0 60000
rigidDiaphragm 3 9 5 6 7 8
]]
  local mass, J = 0, 0
  for _, m in ipairs(frame.masses) do
    mass = mass + m.mass
    J = J + m.mass * 13 + (m.inertia and m.inertia[3] or 0)
  end
  near(mass, 4000, 1e-6, "the mass of the floor")
  near(J, 60000, 1e-6, "its inertia about its centre")
end)

-- Springs -------------------------------------------------------------------------------------------------------------

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
  local function sways(material, turn, turned_round)
    local text, wanted = foot:format(material), bends + 3 * turn
    if turned_round then text = text:gsub("(equalDOF[^\n]*\n)(element[^\n]*)1 11([^\n]*\n)", "%211 1%3%1") end
    local frame, notes = read_whole(text)
    near(both(frame, moved("2", "x")), wanted, 1e-4 * wanted, material)
    return notes
  end
  sways("Elastic 1 5e6", 30e3 / 5e6)
  sways("Elastic 1 5e6", 30e3 / 5e6, "spring first, and from the other node")
  sways("Steel01 1 20e3 5e6 0.02", elastic + hard)
  sways("Steel01 1 40e3 5e6 0.02", 30e3 / 5e6) -- below its strength
  -- Bilin: K as+ as- My+ My- L L L L c c c c thp+ thp- thpc+ thpc- res res thu thu D D
  local bilin = "Bilin 1 5e6 0.02 0.02 20e3 -20e3 1 1 1 1 1 1 1 1 0.15 0.15 0.3 0.3 0.4 0.4 0.9 0.9 1 1"
  has_note(sways(bilin, elastic + hard).assumed, "up to the greatest moment")
  sways("IMKBilin 1 5e6 0.15 0.3 0.9 20e3 1.75 0.4 0.15 0.3 0.9 20e3 1.75 0.4 1 1 1 1 1 1 1 1", elastic + hard)
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
  local aggregated = read_whole(cantilever("uniaxialMaterial Elastic 2 2e9\nuniaxialMaterial ElasticPP 3 2e7 0.002\n"
    .. "section Aggregator 5 2 P 3 Mz"))
  near(aggregated.sections[1].Mx0, 4e4, 1e-6, "the plastic moment of an aggregated section")
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
  equal(shown(frame.cases[1].history), "{{0 1} {1 0.5} {3 2} {3 0}}", "Path with times")
  equal(shown(frame.cases[2].history), "{{0.5 0} {0.5 1} {1.5 1} {1.5 0}}", "Rectangular")
  equal(shown(frame.cases[3].history[26]), "{0.25 1}", "Trig: a quarter of its period of 100 parts")
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
