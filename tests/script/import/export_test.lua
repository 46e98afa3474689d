-- hinge export: the frames of other programs become scripts that hinge check and hinge run take. What is wrong is said
-- in one line, and no file that something else has written is lost.
--
-- Run: lua5.4 tests/script/import/export_test.lua BUILD_FOLDER
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local checks = support.checks "export"
local case, equal, expect, near = checks.case, checks.equal, checks.expect, checks.near

local hinge = support.quote(arg[1] .. "/hinge")
local samples = support.folder .. "import/"
local folder = support.temporary_folder()

local function run(arguments)
  return support.run(("cd %s && %s %s"):format(support.quote(folder), hinge, arguments))
end

for name, source in pairs {
  e2k = "frame.e2k", s2k = "frame.s2k", tcl = "frame.tcl --units kN,m,t",
  python = "frame.py --units N,m --run-python", csv = "",
} do
  case("a script of " .. name .. " is written, looked over and run", function()
    local out = name .. ".lua"
    local status, printed, complaint = run(("export %s --out %s"):format(samples .. source, out))
    equal(status, 0, complaint)
    expect(printed:find("18 nodes, 26 members of 120 m", 1, true), "the summary: %s", printed)
    expect(printed:find("written to " .. out, 1, true), "what to do next: %s", printed)
    status, printed, complaint = run("check " .. out)
    equal(status, 0, complaint)
    expect(printed:find("26 members on 6 supported nodes", 1, true), "hinge check: %s", printed)
    -- the sum of the vertical reactions under dead load, 12 kN/m on 48 m
    local text = support.read(folder .. "/" .. out)
    local dead = text:match "pattern 1" or "DEAD"
    text = text:match "^(.-)return hinge%.scenario" .. ([[
local run = model:static { steps = 1, loads = { [%s] = 1 } }:finish()
local up = 0
for _, node in pairs(nodes) do up = up + select(3, node:reaction(run)) end
print(("up %%.6f"):format(up))
]]):format(("%q"):format(dead))
    support.write(folder .. "/sum.lua", text)
    status, printed, complaint = run "run -q sum.lua"
    equal(status, 0, complaint)
    near(tonumber(printed:match "up (%S+)"), 12e3 * 48, 0.1, "vertical reactions, N") -- the tolerance of equilibrium
  end)
end

case("the script is named after the file, and draws its load cases where there are pictures", function()
  local status, printed, complaint = run("export " .. samples .. "frame.e2k")
  equal(status, 0, complaint)
  expect(printed:find("written to frame.lua;", 1, true), "its name: %s", printed)
  status, printed, complaint = run "run -q frame.lua --out drawn"
  equal(status, 0, complaint .. printed)
  if support.is_there(arg[1] .. "/libhinge_output.so") then
    for i = 1, 2 do
      expect(support.is_there(("%s/drawn/case_%d.png"):format(folder, i)), "the picture of case %d is missing", i)
    end
  end
end)

case("what is not read stands in the last line, too", function()
  support.write(folder .. "/part.e2k", (support.read(samples .. "frame.e2k"):gsub('TYPE "FORCE"', 'TYPE "HEAT"')))
  local status, printed = run "export part.e2k"
  equal(status, 0, "status")
  expect(printed:find("without the 3 things above that were not read", 1, true), "the last line: %s", printed)
end)

case("--sections gives a section that hinge lacks, and refuses a table of another form", function()
  local text = support.read(samples .. "frame.e2k"):gsub('SHAPE "General"  D 0.4[^\n]*', 'SHAPE "W14X999"')
  support.write(folder .. "/unknown.e2k", text)
  support.write(folder .. "/map.csv", "name,named\nBEAM,W14X873\n")
  support.write(folder .. "/wrong.csv", "BEAM W14X873\n")
  local function export_of(options)
    local status, printed, complaint = run("export " .. options)
    return printed .. complaint, status
  end
  expect(export_of "unknown.e2k --out no.lua":find("the nearest are 'W14X873'", 1, true), "no near names")
  local printed, status = export_of "unknown.e2k --out known.lua --sections map.csv"
  equal(status, 0, printed)
  expect(printed:find("it is W14X873, as the option sections says", 1, true), "%s", printed)
  printed, status = export_of "unknown.e2k --out wrong.lua --sections wrong.csv"
  expect(status ~= 0 and printed:find("wrong.csv:1: 'BEAM W14X873' is not of the form NAME,NAME", 1, true), "%s",
    printed)
  printed, status = export_of "part.tcl --units kN,m --sections map.csv"
  expect(status ~= 0 and printed:find("--sections is for files of SAP2000 and ETABS", 1, true), "%s", printed)
end)

-- The first line of a script is a comment with the name of the file, which a line break would end.
case("the name of a file writes nothing into the script", function()
  local name = "a\nos.execute('touch HACKED') --.tcl"
  support.write(folder .. "/" .. name, support.read(samples .. "frame.tcl"))
  local status, _, complaint = run("export --units kN,m,t --out named.lua " .. support.quote(name))
  equal(status, 0, complaint)
  status, _, complaint = run "run -q named.lua"
  equal(status, 0, complaint)
  expect(not support.is_there(folder .. "/HACKED"), "the name of the file ran as a program")
end)

-- Long lines are broken after a comma, but not inside a text; and a word of Lua is no plain field.
case("names with commas, quotes and words of Lua come back as they were", function()
  local names = { ("c, "):rep(60), ('"], { os.exit(7), "'):rep(8), "]] --[[ \\", "while", "\r, \r" }
  for i, name in ipairs(names) do
    local script = ([[
local hinge = require "hinge"
local name = %q
local frame = { nodes = { { name = "a", x = 0, y = 0, z = 0, fix = "all" }, { name = name, x = 0, y = 0, z = 3 } },
  materials = { { name = name, E = 2e11, G = 8e10, density = 7850 } },
  sections = { { name = name, area = 0.01, Ix = 1e-5, Iy = 1e-5, J = 1e-5 } },
  members = { { name = name, a = "a", b = name, section = name, material = name } } }
hinge.import.write(frame, "names%d.lua")
]]):format(name, i):gsub("\\\n", "\\n")
    support.write(folder .. "/write.lua", script)
    local status, _, complaint = run "run -q write.lua --out ."
    equal(status, 0, name .. ": " .. complaint)
    local chunk, problem = loadfile(("%s/names%d.lua"):format(folder, i))
    expect(chunk, "%s: %s", name, problem)
  end
end)

case("a wrong call is told in one line, and a file of somebody else stays", function()
  support.write(folder .. "/mine.lua", "-- my own script\n")
  for arguments, words in pairs {
    ["export mine.lua"] = "is a script of hinge already",
    ["export nowhere.s2k"] = "cannot read nowhere.s2k",
    ["export frame.docx"] = "is of no kind that export reads: .s2k",
    ["export " .. samples .. "frame.tcl"] = "give --units FORCE,LENGTH",
    ["export " .. samples .. "frame.tcl --units kN"] = "--units is 'kN': there is no unit of length",
    ["export " .. samples .. "frame.tcl --units lb,ft"] = "'lb' is a mass; as a force it is lbf",
    ["export " .. samples .. "frame.tcl --units kN,m --model 0"] = "--model is '0'",
    ["export " .. samples .. "frame.tcl --units kN,m --model 2"] = "field 'model' is 2",
    ["export " .. samples .. "frame.e2k --model 1"] = "--model is for scripts of OpenSees",
    ["export " .. samples .. "frame.e2k --units kN,m"] = "--units is for scripts of OpenSees",
    ["export " .. samples .. "frame.e2k --out frame.txt"] = "its name must end in .lua",
    ["export " .. samples .. "frame.e2k --out mine.lua"] = "'mine.lua' is there, and it is no script of import.write",
  } do
    local status, _, complaint = run(arguments)
    equal(status, 2, arguments)
    expect(complaint:find(words, 1, true) and select(2, complaint:gsub("\n", "")) == 1, "%s: %s", arguments, complaint)
  end
  equal(support.read(folder .. "/mine.lua"), "-- my own script\n", "a script of somebody else")
end)

checks.done()
