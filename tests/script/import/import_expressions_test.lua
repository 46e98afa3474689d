-- hinge.import: expressions of Python and Tcl come to the model with the values that their interpreters give, to the
-- last digit, against values by hand; those without a value end the script at their line.
--
-- Run: lua5.4 tests/script/import/import_expressions_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
require "hinge"
local import = require "hinge.import"
local checks = support.checks "expressions of import"
local case, near, equal, expect = checks.case, checks.near, checks.equal, checks.expect

local write = support.writer()

-- What expressions give: each is the x of a node. The expressions of a list, sorted, and their values.
local function values(name, text, line, expressions)
  local list = {}
  for expression in pairs(expressions) do list[#list + 1] = expression end
  table.sort(list)
  local lines = {}
  for i, expression in ipairs(list) do
    lines[i] = line:gsub("TAG", tostring(100 + i)):gsub("X", (expression:gsub("%%", "%%%%")))
  end
  local frame = import.tcl { file = write(name, text .. table.concat(lines, "\n")),
    units = { length = "m", force = "N" }, run_python = true }
  local x = {}
  for _, node in ipairs(frame.nodes) do x[node.name] = node.x end
  local found = {}
  for i, expression in ipairs(list) do found[expression] = x[tostring(100 + i)] end
  return list, found
end

local function python(expressions)
  return values("f.py", "import math\nimport openseespy.opensees as ops\nops.model('basic', '-ndm', 3, '-ndf', 6)\n"
    .. "ops.node(1, -99.0, 0, 0)\nops.geomTransf('Linear', 1, 0, 0, 1)\n",
    "ops.node(TAG, X, TAG, 0)\nops.element('elasticBeamColumn', TAG, 1, TAG, 1, 1, 1, 1, 1, 1, 1)", expressions)
end

local function tcl(expressions)
  return values("f.tcl", "model basic -ndm 3 -ndf 6\nnode 1 -99 0 0\ngeomTransf Linear 1 0 0 1\n",
    "node TAG [expr {X}] TAG 0\nelement elasticBeamColumn TAG 1 TAG 1 1 1 1 1 1 1", expressions)
end

local function have(what, of, wanted)
  local list, found = of(wanted)
  for _, expression in ipairs(list) do near(found[expression], wanted[expression], 0, what .. expression) end
end

case("Python: operators and functions, as python3 prints them", function()
  have("Python: ", python, {
    ["1 if 1 < 2 < 3 else 9"] = 1, ["1 if 1 < 3 < 2 else 9"] = 9, ["0 or 4"] = 4, ["3 and 4"] = 4, ["True + True"] = 2,
    ["2**3**2"] = 512, ["2**-1"] = 0.5, ["10 - -2**2"] = 14, ["-7 // 2 + 10"] = 6, ["-7 % 3"] = 2, ["1 / 3"] = 1 / 3,
    ["6 & 3"] = 2, ["6 | 3"] = 7, ["6 ^ 3"] = 5, ["~6"] = -7, ["3 << 2"] = 12, ["1_000.5"] = 1000.5, ["0x1F"] = 31,
    ["math.sin(1)"] = math.sin(1), ["math.pi"] = math.pi, ["math.hypot(3, 4)"] = 5, ["round(2.5)"] = 2,
    ["round(2.567, 2)"] = 2.57, ["sum(x * x for x in range(5) if x > 2)"] = 25, ["len(f'{3:>4d}')"] = 4,
    ["[1, 2, 3][1:][-2]"] = 2, ["{'a': 3, 2: 4}[2]"] = 4, ["(lambda x, y=2: x * y)(3)"] = 6, ["int('1' + '2')"] = 12,
    ["max([[1, 5], [2, 4]], key=lambda p: p[1])[0]"] = 1, ["1e22 / 3"] = 1e22 / 3, ["0.1 + 0.2"] = 0.1 + 0.2 })
end)

case("Tcl: operators and functions, as tclsh prints them", function()
  have("Tcl: ", tcl, {
    ["2**3**2"] = 512, ["(2**3)**2"] = 64, ["-2**2 + 10"] = 14, ["7 / -2"] = -4, ["-7 % 4"] = 1, ["7 / 2.0"] = 3.5,
    ["1 ? 2 : 3"] = 2, ["0 ? 2 : 1 ? 4 : 5"] = 4, ["!3 + 1"] = 1, ["\"a\" eq \"a\""] = 1, ["\"a\" == \"b\""] = 0,
    ["1 < 2 && 2 < 3"] = 1, ["0 || 0"] = 0, ["0x1F + 1"] = 32, ["010 + 1"] = 9, [".5e1"] = 5, ["2**-1"] = 0,
    ["2.0**-1"] = 0.5, ["6 & 3"] = 2, ["6 | 3"] = 7, ["6 ^ 3"] = 5, ["~6"] = -7, ["3 << 2"] = 12,
    ["2 in {1 2 3}"] = 1, ["sin(1)"] = math.sin(1), ["acos(-1.0)"] = math.pi, ["hypot(3, 4)"] = 5, ["int(-2.7)"] = -2,
    ["round(-2.5)"] = -3, ["floor(-2.5)"] = -3, ["double(3) / 2"] = 1.5, ["min(3, 1, 2)"] = 1, ["fmod(7.5, 2)"] = 1.5,
    ["1 / 3.0"] = 1 / 3, ["0.1 + 0.2"] = 0.1 + 0.2, ["[llength {a {b c}}] * 2"] = 4 })
end)

case("expressions without a value end the script at their line", function()
  for expression, wanted in pairs { ["1 / 0"] = "ZeroDivisionError", ["sqrt(2)"] = "name 'sqrt' is not defined",
    ["[1, 2][2]"] = "IndexError", ["{1: 2}[3]"] = "KeyError", ["'a' - 1"] = "TypeError", ["(2"] = "never closed" } do
    local good, message = pcall(python, { [expression] = 0 })
    expect(not good and tostring(message):find("f.py:6: [^\n]*" .. wanted), "Python: %s: %s", expression,
      tostring(message))
  end
  for expression, wanted in pairs { ["1 / 0"] = "divide by zero", ["foo(2)"] = "foo",
    ["$undefined + 1"] = "can't read \"undefined\"", ["(2"] = "unbalanced open paren",
    ["1 ? 2"] = "missing operator" } do
    local good, message = pcall(tcl, { [expression] = 0 })
    expect(not good and tostring(message):find("f.tcl:4: [^\n]*" .. wanted), "Tcl: %s: %s", expression,
      tostring(message))
  end
end)

case("loads after the braces of a pattern, an open index and modules that are no part of a frame", function()
  local head = "model basic -ndm 3 -ndf 6\nnode 1 -99 0 0\nnode 2 1 0 0\ngeomTransf Linear 1 0 0 1\n"
    .. "element elasticBeamColumn 1 1 2 1 1 1 1 1 1 1\n"
  local function refused(text)
    local good, message = pcall(import.tcl, { file = write("f.tcl", head .. text), units = { length = "m",
      force = "N" } })
    return good and "read" or tostring(message)
  end
  equal(refused "pattern Plain 1 Linear { load 2 1 0 0 0 0 0 }\n", "read", "a load in the braces")
  local behind = refused "pattern Plain 1 Linear { }\nload 2 1 0 0 0 0 0\n"
  expect(behind:find("f.tcl:7: the load stands outside of a pattern", 1, true), "behind them: %s", behind)
  expect(refused("set x(1) 2\nset y $x(1\n"):find("f.tcl:7: missing )", 1, true), "an index: %s",
    refused "set x(1) 2\nset y $x(1\n")
  for _, line in ipairs { "from os import path", "import os", "import os.path as p", "from opsvis import *" } do
    local _, notes = import.tcl { file = write("f.py", line .. "\nfrom openseespy.opensees import *\n"
      .. "from math import sqrt, pi\nmodel('basic', '-ndm', 3, '-ndf', 6)\nnode(1, 0, 0, 0)\n"
      .. "node(2, sqrt(4) * pi, 0, 0)\ngeomTransf('Linear', 1, 0, 0, 1)\n"
      .. "element('elasticBeamColumn', 1, 1, 2, 1, 1, 1, 1, 1, 1, 1)\n"), units = { length = "m", force = "N" },
      run_python = true }
    equal(#notes, 0, line .. ": nothing is missing")
    equal(notes.skipped[1] and notes.skipped[1].text, line:find "opsvis" and line or nil, "what is skipped")
  end
end)

checks.done()
