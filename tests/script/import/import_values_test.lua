-- What import.tcl reads of OpenSees, command by command, in Tcl and in Python: displacements, forces of supports and
-- natural frequencies against a small solver that gets the commands from tclsh and python3 themselves
-- (import/compare.lua).
--
-- Run: lua5.4 tests/script/import/import_values_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
require "hinge"
local import = require "hinge.import"
local checks = support.checks "values of OpenSees"
local case, expect = checks.case, checks.expect
local compare = dofile(support.folder .. "import/compare.lua")
local write = support.writer()

-- Where OpenSees has no shear strain hinge has a shear area of 1000 times the area: 1e-4 of a displacement at most.
local within = 2e-4

-- Scripts -------------------------------------------------------------------------------------------------------------

local in_pattern = { load = true, eleLoad = true, sp = true }
local in_section = { patch = true, layer = true, fiber = true }

-- Commands, one a line, as Tcl: loads and fibres stand in the braces of the command before them.
local function to_tcl(text)
  local lines, inside = {}, false
  for line in text:gmatch "[^\n;]+" do
    local name = line:match "%a+"
    if inside and not (in_pattern[name] or in_section[name]) then
      lines[#lines + 1], inside = "}", false
    end
    local opens = line:find "^%s*pattern Plain" or line:find "^%s*section Fiber"
    lines[#lines + 1] = line .. (opens and " {" or "")
    inside = inside or opens
  end
  return table.concat(lines, "\n") .. (inside and "\n}\n" or "\n")
end

-- The same as Python.
local function to_python(text)
  local lines = { "import openseespy.opensees as ops" }
  for line in text:gmatch "[^\n;]+" do
    local words = {}
    for word in line:gmatch "%S+" do words[#words + 1] = tonumber(word) and word or ("'%s'"):format(word) end
    if words[1] then
      lines[#lines + 1] = ("ops.%s(%s)"):format(words[1]:sub(2, -2), table.concat(words, ", ", 2))
    end
  end
  return table.concat(lines, "\n") .. "\n"
end

local languages = { tcl = to_tcl, py = support.output "command -v python3" ~= "" and to_python or nil }
if support.output "command -v tclsh" == "" then checks.skip "tclsh is not installed (apt-get install tcl)" end

local function read(path)
  local python = path:find "%.py$" and true or nil
  return import.tcl { file = path, units = { length = "m", force = "N" }, run_python = python }
end

-- Compares both forms of a text. more: { within =, modes = (how many), notes = (how many that are not read) }
local function same(text, more)
  more = more or {}
  for ending, as in pairs(languages) do
    local path = write("model." .. ending, as(text))
    local frame, notes = read(path)
    expect(#notes == (more.notes or 0), "%s: %d notes: %s", ending, #notes, tostring(notes))
    local model, nodes = import.build(frame, { model = { displacement = "small" } })
    local m = compare.model(path)
    for _, pattern in ipairs(m.patterns) do
      local way, where, force, at = compare.pattern(m, { model, nodes }, pattern, 1)
      expect(way <= (more.within or within), "%s, pattern %s: displacements differ by %.2g: %s", ending, pattern.name,
        way, where)
      expect(force <= (more.within or within), "%s, pattern %s: reactions differ by %.2g: %s", ending, pattern.name,
        force, at)
    end
    if more.modes then
      local difference, at = compare.modes(m, { model, nodes }, more.modes)
      expect(difference <= (more.within or within), "%s: frequencies differ by %.2g: %s", ending, difference, at)
    end
  end
end

local start = "model basic -ndm 2 -ndf 3\n"
local portal = start .. [[
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
    { within = 1e-3 })
  same(portal .. columns .. "uniaxialMaterial Elastic 2 1.28e8\nsection Elastic 6 2e11 0.008 2e-4\n"
    .. "section Aggregator 7 2 Vy -section 6\n" .. element .. loads)
  same(portal .. columns .. "uniaxialMaterial Elastic 2 1.6e9\nuniaxialMaterial Elastic 3 4e7\n"
    .. "section Aggregator 7 2 P 3 Mz\n" .. element .. loads)
end)

case("plane: releases at either end and at both, joint offsets", function()
  for code = 0, 3 do
    same(portal .. columns .. ("element elasticBeamColumn 2 2 3 0.008 2e11 2e-4 1 -release %d\n"):format(code) .. loads)
  end
  same(portal .. "geomTransf Linear 2 -jntOffset 0.3 0.1 -0.4 -0.2\n" .. columns
    .. "element elasticBeamColumn 2 2 3 0.008 2e11 2e-4 2\n" .. loads)
end)

case("plane: bars, and frames of bars alone", function()
  local brace = "uniaxialMaterial Elastic 1 2e11\nelement %s 4 1 3 0.001 1\n"
  for _, kind in ipairs { "truss", "corotTruss" } do same(portal .. columns .. beam .. brace:format(kind) .. loads) end
  same [[
model basic -ndm 2 -ndf 2
node 1 0 0; node 2 8 0; node 3 4 3
fix 1 1 1
fix 2 0 1
uniaxialMaterial Elastic 1 2e11
element truss 1 1 3 0.001 1
element truss 2 2 3 0.001 1
element truss 3 1 2 0.002 1
pattern Plain 1 Linear
load 3 1e4 -2e4
]]
end)

-- What ties nodes -----------------------------------------------------------------------------------------------------

case("plane: springs of no length, links of two nodes, equal degrees of freedom, rigid links", function()
  local hinge = "node 5 0 4\nuniaxialMaterial Elastic 1 3e6\nelement zeroLength 5 2 5 -mat 1 -dir 6\n"
  local from_5 = "element elasticBeamColumn 2 5 3 0.008 2e11 2e-4 1\n"
  same(portal .. columns .. hinge .. "equalDOF 2 5 1 2\n" .. from_5 .. loads)
  same(portal .. columns .. "node 5 0 4\nequalDOF 2 5 1 2\n" .. from_5 .. loads)
  -- a spring to a support
  same(portal .. columns .. beam .. "node 6 6 0\nfix 6 1 1 1\nuniaxialMaterial Elastic 1 3e6\n"
    .. "element zeroLength 6 6 4 -mat 1 -dir 6\n" .. loads)
  -- springs along turned axes
  same(portal .. columns .. beam .. "node 6 6 4.5\nfix 6 1 1 1\nuniaxialMaterial Elastic 1 3e6\n"
    .. "uniaxialMaterial Elastic 2 2e6\nelement zeroLength 6 6 3 -mat 1 2 -dir 1 2 -orient 0.6 0.8 0 -0.8 0.6 0\n"
    .. loads)
  -- a link with a length, beside the beam
  same(portal .. columns .. beam .. "uniaxialMaterial Elastic 1 3e7\nelement twoNodeLink 5 2 3 -mat 1 -dir 1\n"
    .. loads)
  same(portal .. columns .. "node 5 0.5 4.2\nrigidLink beam 2 5\n" .. from_5 .. loads)
  same(portal .. columns .. "node 5 0 4\nrigidLink bar 2 5\n" .. from_5 .. loads)
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
    same(space .. released .. loads_in_space)
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
  same(all .. "node 20 3 0 5\nrigidLink beam 12 20\n" .. loads_in_space .. "load 20 0 7e3 0 0 1e3 0\n")
  same(all .. "uniaxialMaterial Elastic 1 2e11\nelement truss 9 1 13 0.001 1\n" .. loads_in_space)
  same(all .. "node 20 6 5 4\nfix 20 1 1 1 1 1 1\nuniaxialMaterial Elastic 1 3e6\nuniaxialMaterial Elastic 2 1e6\n"
    .. "element zeroLength 9 20 13 -mat 1 2 2 -dir 1 3 5 -orient 0 1 0 0 0 1\n" .. loads_in_space)
  same [[
model basic -ndm 3 -ndf 3
node 1 0 0 0; node 2 4 0 0; node 3 0 4 0; node 4 1 1 3
fix 1 1 1 1
fix 2 1 1 1
fix 3 1 1 1
uniaxialMaterial Elastic 1 2e11
element truss 1 1 4 0.001 1
element truss 2 2 4 0.001 1
element truss 3 3 4 0.001 1
pattern Plain 1 Linear
load 4 1e3 2e3 -9e3
]]
end)

-- Which model ---------------------------------------------------------------------------------------------------------

case("wipe begins anew", function()
  same(portal .. columns .. beam .. loads .. "wipe\n" .. start .. "node 1 0 0; node 2 5 0\nfix 1 1 1 1\n"
    .. "geomTransf Linear 1\nelement elasticBeamColumn 1 1 2 0.01 2e11 1e-4 1\n" .. loads:gsub("load 3[^\n]*\n", ""))
end)

checks.done()
