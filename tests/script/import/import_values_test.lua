-- What import.tcl reads of OpenSees, command by command, in Tcl and in Python: displacements and forces of supports of
-- what import.build makes, and of the script that import.write writes, against a small solver that gets the same
-- commands (commands_solver.lua).
--
-- Run: lua5.4 tests/script/import/import_values_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
require "hinge"
local import = require "hinge.import"
local checks = support.checks "values of OpenSees"
local case, expect, equal = checks.case, checks.expect, checks.equal
local by_commands = dofile(support.folder .. "import/commands_solver.lua")
local write, folder = support.writer()

-- Where OpenSees has no shear strain hinge has a shear area of 1000 times the area: 1e-4 of a displacement at most.
local usual = 2e-4

-- Scripts -------------------------------------------------------------------------------------------------------------

-- The commands of a text, which has one a line or between semicolons: { name, argument, ... }.
local function commands_of(text)
  local list = {}
  for line in text:gmatch "[^\n;]+" do
    local words = {}
    for word in line:gmatch "%S+" do words[#words + 1] = word end
    list[#list + 1] = words
  end
  return list
end

local inside = { load = "pattern", eleLoad = "pattern", patch = "section" }

-- As Tcl: loads and fibres stand in the braces of the command before them.
local function to_tcl(list)
  local lines, open = {}, nil
  for _, words in ipairs(list) do
    if open and inside[words[1]] ~= open then lines[#lines + 1], open = "}", nil end
    local opens = words[2] == "Plain" or words[2] == "Fiber"
    lines[#lines + 1] = table.concat(words, " ") .. (opens and " {" or "")
    open = opens and words[1] or open
  end
  return table.concat(lines, "\n") .. (open and "\n}\n" or "\n")
end

local function to_python(list)
  local lines = { "import openseespy.opensees as ops\n" }
  for i, words in ipairs(list) do
    local arguments = {}
    for k = 2, #words do arguments[k - 1] = tonumber(words[k]) and words[k] or ("'%s'"):format(words[k]) end
    lines[i + 1] = ("ops.%s(%s)\n"):format(words[1], table.concat(arguments, ", "))
  end
  return table.concat(lines)
end

local languages = { tcl = to_tcl, py = support.output "command -v python3" ~= "" and to_python or nil }
if support.output "command -v tclsh" == "" then checks.skip "tclsh is not installed (apt-get install tcl)" end

-- Comparison ----------------------------------------------------------------------------------------------------------

-- Rows { by the solver, by hinge } of three numbers: their largest difference over the largest number is within limits.
local function alike(what, rows, within)
  local largest, difference = 0, 0
  for _, row in pairs(rows) do
    for i = 1, 3 do
      largest = support.largest_of(largest, math.abs(row[1][i]))
      difference = support.largest_of(difference, math.abs(row[1][i] - row[2][i]))
    end
  end
  expect(difference <= within * largest, "%s differ by %.2g of the largest", what, difference / largest)
end

-- Displacements of nodes, and forces of supports, under each pattern of a model.
local function same_values(what, m, model, nodes, within)
  local function in_hinge(v) return m.dim == 2 and { v.x or 0, 0, v.y or 0 } or { v.x or 0, v.y or 0, v.z or 0 } end
  for _, pattern in ipairs(m.patterns) do
    local solved = m:frame(pattern):solve()
    local run = model:static { steps = 1, loads = { ["pattern " .. pattern.name] = 1 } }:finish()
    local ways, forces = {}, {}
    for name, node in pairs(nodes) do
      local reaction = solved.reaction[name]
      ways[name] = { in_hinge(solved.u[name]), { node:displacement(run) } }
      if reaction.x or reaction.y or m.dim == 3 and reaction.z then
        forces[name] = { in_hinge(reaction), { node:reaction(run) } }
      end
    end
    alike(("%s, pattern %s: displacements"):format(what, pattern.name), ways, within)
    alike(("%s, pattern %s: reactions"):format(what, pattern.name), forces, within)
  end
end

-- Compares a text in both languages, and the script that is written of it.
local function same(text, within)
  local list, small = commands_of(text), { model = { displacement = "small" } }
  local m = by_commands.read(list)
  for ending, as in pairs(languages) do
    local frame, notes = import.tcl { file = write("model." .. ending, as(list)), units = { length = "m", force = "N" },
      run_python = true }
    equal(#notes, 0, ending .. ": " .. tostring(notes))
    local model, nodes = import.build(frame, small)
    same_values(ending, m, model, nodes, within or usual)
    if ending == "tcl" then
      local written, its_nodes = dofile(import.write(frame, folder .. "written.lua", small))
      same_values("written", m, written, its_nodes, within or usual)
    end
  end
end

local portal = [[
model basic -ndm 2 -ndf 3
node 1 0 0; node 2 0 4; node 3 6 4.5; node 4 6 0
fix 1 1 1 1
fix 4 1 1 0
geomTransf Linear 1
]]
local columns = "element elasticBeamColumn 1 1 2 0.01 2e11 1e-4 1\nelement elasticBeamColumn 3 4 3 0.01 2e11 1e-4 1\n"
local beam = "element elasticBeamColumn 2 2 3 0.008 2e11 2e-4 1\n"
local loads = "timeSeries Linear 1\npattern Plain 1 1\nload 2 1e4 -2e4 3e3\nload 3 2e3 0 -1e3\n"

-- Beams in the plane --------------------------------------------------------------------------------------------------

case("plane: elastic beams, with a section, with shear", function()
  same(portal .. columns .. beam .. loads)
  same(portal .. columns .. "section Elastic 7 2e11 0.008 2e-4\nelement elasticBeamColumn 2 2 3 7 1\n" .. loads)
  same(portal .. columns .. "element ElasticTimoshenkoBeam 2 2 3 2e11 8e10 0.008 2e-4 0.002 1\n" .. loads)
end)

case("plane: elements with integration points in each of their forms", function()
  local sections = "section Elastic 7 2e11 0.008 2e-4\nsection Elastic 8 2e11 0.008 2e-4 8e10 0.3\n"
  for _, element in ipairs { "forceBeamColumn 2 2 3 5 7 1", "dispBeamColumn 2 2 3 5 7 1",
    "nonlinearBeamColumn 2 2 3 4 7 1", "forceBeamColumn 2 2 3 5 8 1", "forceBeamColumn 2 2 3 1 Lobatto 8 5",
    "dispBeamColumn 2 2 3 1 Legendre 7 3" } do
    same(portal .. columns .. sections .. "element " .. element .. "\n" .. loads)
  end
  same(portal .. columns .. sections .. "beamIntegration Lobatto 4 8 5\nelement forceBeamColumn 2 2 3 1 4\n" .. loads)
end)

case("plane: sections of fibres and aggregated ones have the stiffness that they begin with", function()
  local steel = "uniaxialMaterial Steel01 1 2.5e8 2e11 0.01\n"
  local element = "element forceBeamColumn 2 2 3 5 7 1\n"
  -- 40 fibres over the depth have 1/1600 less than the outline's second moment
  same(portal .. columns .. steel .. "section Fiber 7\npatch rect 1 40 1 -0.15 -0.1 0.15 0.1\n" .. element .. loads,
    1e-3)
  same(portal .. columns .. "uniaxialMaterial Elastic 2 1.28e8\nsection Elastic 6 2e11 0.008 2e-4\n"
    .. "section Aggregator 7 2 Vy -section 6\n" .. element .. loads)
  same(portal .. columns .. "uniaxialMaterial Elastic 2 1.6e9\nuniaxialMaterial Elastic 3 4e7\n"
    .. "section Aggregator 7 2 P 3 Mz\n" .. element .. loads)
end)

case("plane: releases at either end and at both, joint offsets", function()
  for code = 0, 3 do
    same(portal .. columns .. ("element elasticBeamColumn 2 2 3 0.008 2e11 2e-4 1 -release %d\n"):format(code) .. loads
      .. "eleLoad -ele 2 -type -beamUniform -5e3\n")
  end
  same(portal .. "geomTransf Linear 2 -jntOffset 0.3 0.1 -0.4 -0.2\n" .. columns
    .. "element elasticBeamColumn 2 2 3 0.008 2e11 2e-4 2\n" .. loads)
end)

case("plane: bars, and frames of bars alone", function()
  local brace = "uniaxialMaterial Elastic 1 2e11\nelement %s 4 1 3 0.001 1\n"
  for _, kind in ipairs { "truss", "corotTruss" } do same(portal .. columns .. beam .. brace:format(kind) .. loads) end
  -- nodes without rotations, and with rotations that supports hold or not; a section of one deformation
  for _, r in ipairs { { 2, "" }, { 3, " 1" }, { 3, " 0" } } do
    same(([[
model basic -ndm 2 -ndf NDF
node 1 0 0; node 2 8 0; node 3 4 3
fix 1 1 1 HELD
fix 2 0 1 HELD
uniaxialMaterial Elastic 1 2e11
uniaxialMaterial Elastic 2 2e8
section Uniaxial 7 2 P
element truss 1 1 3 7
element truss 2 2 3 0.001 1
element truss 3 1 2 0.002 1
pattern Plain 1 Linear
load 3 1e4 -2e4 ZERO
]]):gsub("%u%u%u+", { NDF = r[1], HELD = r[2], ZERO = r[1] == 3 and "0" or "" }), 1e-7)
  end
end)

-- What ties nodes -----------------------------------------------------------------------------------------------------

case("plane: springs of no length, links of two nodes, equal degrees of freedom, rigid links", function()
  local hinge = "node 5 0 4\nuniaxialMaterial Elastic 1 3e6\nelement zeroLength 5 2 5 -mat 1 -dir 6\n"
  local from_5 = "element elasticBeamColumn 2 5 3 0.008 2e11 2e-4 1\n"
  same(portal .. columns .. hinge .. "equalDOF 2 5 1 2\n" .. from_5 .. loads)
  same(portal .. columns .. "node 5 0 4\nequalDOF 2 5 1 2\n" .. from_5 .. loads)
  same(portal .. columns .. "node 5 0 4\nequalDOF 2 5 1 2 3\n" .. from_5 .. loads)
  for _, order in ipairs { "2 3", "3 2" } do same(portal .. columns .. "equalDOF " .. order .. " 1\n" .. loads) end
  -- what follows a support is held
  same(portal .. columns .. beam .. "node 5 9 4\nfix 5 1 1 1\nequalDOF 5 3 1\n" .. loads)
  -- a spring to a support
  same(portal .. columns .. beam .. "node 6 6 0\nfix 6 1 1 1\nuniaxialMaterial Elastic 1 3e6\n"
    .. "element zeroLength 6 6 4 -mat 1 -dir 6\n" .. loads)
  local open = portal:gsub("fix 4 1 1 0\n", "") .. columns .. beam .. "node 6 6 0\nfix 6 1 1 1\n"
    .. "uniaxialMaterial Elastic 1 3e6\nuniaxialMaterial Elastic 2 1e8\n"
  for _, foot in ipairs { "fix 4 1 1 0\nelement zeroLength 6 4 6 -mat 1 -dir 6",
    "element zeroLength 6 6 4 -mat 2 2 1 -dir 1 2 6",
    "element zeroLength 6 6 4 -mat 2 2 1 -dir 1 2 6 -orient 0 1 0 -1 0 0",
    "element twoNodeLink 6 6 4 -mat 2 2 1 -dir 1 2 3 -orient 1 0 0 0 1 0" } do
    same(open .. foot .. "\n" .. loads)
  end
  -- springs along turned axes
  same(portal .. columns .. beam .. "node 6 6 4.5\nfix 6 1 1 1\nuniaxialMaterial Elastic 1 3e6\n"
    .. "uniaxialMaterial Elastic 2 2e6\nelement zeroLength 6 6 3 -mat 1 2 -dir 1 2 -orient 0.6 0.8 0 -0.8 0.6 0\n"
    .. loads)
  -- a link with a length, beside the beam
  same(portal .. columns .. beam .. "uniaxialMaterial Elastic 1 3e7\nelement twoNodeLink 5 2 3 -mat 1 -dir 1\n"
    .. loads)
  same(portal .. columns .. "node 5 0.5 4.2\nrigidLink beam 2 5\n" .. from_5 .. loads)
  same(portal .. columns .. beam .. "node 5 8 4\nrigidLink beam 3 5\n" .. loads .. "load 5 0 -7e3 0\n")
  same(portal .. columns .. "node 5 0 4\nrigidLink bar 2 5\n" .. from_5 .. loads)
  -- bars and springs at nodes without rotations
  same([[
model basic -ndm 2 -ndf 2
node 1 0 0; node 2 4 0; node 3 4 0
fix 1 1 1
fix 3 1 1
uniaxialMaterial Elastic 1 4e8
uniaxialMaterial Elastic 2 1e6
element truss 1 1 2 1e-2 1
element zeroLength 2 2 3 -mat 2 2 -dir 1 2
pattern Plain 1 Linear
load 2 1e3 2e3
]], 1e-7)
end)

case("plane: frames with concentrated hinges and floors, leaning columns", function()
  -- the beam ends at nodes of its own, which follow the joints along x and y; the storey sways as one
  local text = portal .. columns .. "uniaxialMaterial Elastic 1 3e6\nuniaxialMaterial Elastic 2 1e-6\n"
    .. "uniaxialMaterial Elastic 3 2e11\nnode 23 0 4; node 32 6 4.5\n"
    .. "element elasticBeamColumn 2 23 32 0.008 2e11 2e-4 1\n"
  for _, order in ipairs { "2 23", "23 2" } do
    local hinges = ("element zeroLength 12 %s -mat 1 -dir 6\nequalDOF %s 1 2\n"):format(order, order)
      .. "element zeroLength 13 3 32 -mat 1 -dir 6\nequalDOF 3 32 1 2\n"
    same(text .. hinges .. loads)
    same(text .. hinges .. "equalDOF 2 3 1\npattern Plain 1 Linear\nload 2 1e4 0 0\n"
      .. "eleLoad -ele 2 -type -beamUniform -5e3 1e3\n")
    -- a column that leans on the frame: bars to it, and springs of next to no stiffness in it
    same(text .. hinges .. "node 5 9 0; node 6 9 4.5; node 7 9 4.5; node 8 9 9; node 9 6 9\nfix 5 1 1 0\nfix 9 1 1 1\n"
      .. "element truss 4 3 6 1 3\nelement truss 7 9 8 1 3\nelement elasticBeamColumn 5 5 7 1 2e11 1e-2 1\n"
      .. "element zeroLength 6 6 7 -mat 2 -dir 6\nequalDOF 6 7 1 2\nnode 67 9 4.5; node 86 9 9\n"
      .. "element elasticBeamColumn 8 67 86 1 2e11 1e-2 1\nelement zeroLength 9 6 67 -mat 2 -dir 6\n"
      .. "equalDOF 6 67 1 2\nelement zeroLength 10 8 86 -mat 2 -dir 6\nequalDOF 8 86 1 2\n" .. loads
      .. "load 6 0 -1e5 0\nload 8 5e3 -1e5 0\n")
  end
end)

-- Loads ---------------------------------------------------------------------------------------------------------------

case("plane: loads on elements, factors of series and patterns", function()
  local all = portal .. columns .. beam .. "timeSeries Linear 1 -factor 3\ntimeSeries Constant 2 -factor 0.5\n"
  same(all .. "pattern Plain 1 1\neleLoad -ele 2 -type -beamUniform -2e3\n"
    .. "pattern Plain 2 2\neleLoad -ele 1 2 -type -beamUniform 1e3 5e2\n"
    .. "pattern Plain 3 Linear\neleLoad -ele 2 -type -beamPoint -8e3 0.3\n"
    .. "eleLoad -ele 1 -type -beamPoint 2e3 0.75 1e3\n"
    .. "pattern Plain 4 1 -fact 2\nload 2 1e3 0 0\neleLoad -range 1 3 -type -beamUniform 1e3\n")
end)

-- Space ---------------------------------------------------------------------------------------------------------------

local space = [[
model basic -ndm 3 -ndf 6
node 1 0 0 0; node 2 6 0 0; node 3 6 5 0; node 4 0 5 0
node 11 0 0 4; node 12 6 0 4; node 13 6 5 4; node 14 0 5 4
fix 1 1 1 1 1 1 1
fix 2 1 1 1 0 1 1
fix 3 1 1 1 1 1 1
fix 4 1 1 1 1 1 1
geomTransf Linear 1 1 0 0
geomTransf PDelta 2 0 0.6 0.8
geomTransf Linear 3 0 0 1
element elasticBeamColumn 1 1 11 0.01 2e11 8e10 2e-6 4e-5 1e-4 1
element elasticBeamColumn 2 2 12 0.01 2e11 8e10 2e-6 4e-5 1e-4 1
element ElasticTimoshenkoBeam 3 3 13 2e11 8e10 0.01 2e-6 4e-5 1e-4 0.004 0.002 1
element elasticBeamColumn 4 4 14 0.01 2e11 8e10 2e-6 4e-5 1e-4 1
element elasticBeamColumn 5 11 12 0.008 2e11 8e10 1e-6 3e-5 2e-4 2
element elasticBeamColumn 7 13 14 0.008 2e11 8e10 1e-6 3e-5 2e-4 3
element elasticBeamColumn 8 14 11 0.008 2e11 8e10 1e-6 3e-5 2e-4 3
]]
local beam_in_space = "element elasticBeamColumn 6 12 13 0.008 2e11 8e10 1e-6 3e-5 2e-4 3\n"
local loads_in_space = "pattern Plain 1 Linear\nload 11 1e4 2e3 -5e3 1e3 2e3 3e3\nload 13 0 4e3 0 0 0 -2e3\n"
  .. "eleLoad -ele 5 8 -type -beamUniform -2e3 7e2 3e2\neleLoad -ele 1 -type -beamPoint 1e3 5e2 0.4 2e2\n"

case("space: beams with their axes, loads, releases about both axes", function()
  same(space .. beam_in_space .. loads_in_space)
  for code = 1, 3 do
    local released = beam_in_space:gsub("\n", (" -releasez %d -releasey %d\n"):format(code, code % 3 + 1))
    same(space .. released .. loads_in_space .. "eleLoad -ele 6 -type -beamUniform -2e3 7e2\n")
  end
  same(space .. "section Elastic 7 2e11 0.008 2e-4 3e-5 8e10 1e-6\nelement forceBeamColumn 6 12 13 5 7 3\n"
    .. loads_in_space)
  same(space .. "geomTransf Linear 4 0 0 1 -jntOffset 0.1 0.2 0 0 -0.3 0.1\n"
    .. "element elasticBeamColumn 6 12 13 0.008 2e11 8e10 1e-6 3e-5 2e-4 4\n" .. loads_in_space)
end)

case("space: floors, rigid links, bars, springs", function()
  local all = space .. beam_in_space
  same(all .. "node 20 2.5 2 4\nfix 20 0 0 1 1 1 0\nrigidDiaphragm 3 20 11 12 13 14\n"
    .. loads_in_space .. "load 20 5e3 7e3 0 0 0 4e3\n")
  same(all .. "rigidDiaphragm 3 11 12 13 14\n" .. loads_in_space)
  same(all .. "node 20 3 0 5\nrigidLink beam 12 20\n" .. loads_in_space .. "load 20 0 7e3 0 0 1e3 0\n")
  same(all .. "uniaxialMaterial Elastic 1 2e11\nelement truss 9 1 13 0.001 1\n" .. loads_in_space)
  same(all .. "node 20 6 5 4\nfix 20 1 1 1 1 1 1\nuniaxialMaterial Elastic 1 3e6\nuniaxialMaterial Elastic 2 1e6\n"
    .. "element zeroLength 9 20 13 -mat 1 2 2 -dir 1 3 5 -orient 0 1 0 0 0 1\n" .. loads_in_space)
  -- between two members
  same(space .. "node 20 6 0 4\nuniaxialMaterial Elastic 1 3e6\nuniaxialMaterial Elastic 2 1e9\n"
    .. "element elasticBeamColumn 6 20 13 0.008 2e11 8e10 1e-6 3e-5 2e-4 3\n"
    .. "element zeroLength 9 12 20 -mat 2 2 2 2 1 2 -dir 1 2 3 4 5 6\n" .. loads_in_space)
  for _, ndf in ipairs { 3, 6 } do
    same(([[
model basic -ndm 3 -ndf NDF
node 1 0 0 0; node 2 4 0 0; node 3 0 4 0; node 4 1 1 3
fix 1 1 1 1 ZEROS
fix 2 1 1 1 ZEROS
fix 3 1 1 1 ZEROS
uniaxialMaterial Elastic 1 2e11
element truss 1 1 4 0.001 1
element truss 2 2 4 0.001 1
element truss 3 3 4 0.001 1
pattern Plain 1 Linear
load 4 1e3 2e3 -9e3 ZEROS
]]):gsub("%u%u%u+", { NDF = ndf, ZEROS = ndf == 6 and "0 0 0" or "" }), 1e-7)
  end
end)

checks.done()
