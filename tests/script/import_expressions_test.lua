-- hinge.import: every operator and function that the readers of Python and of Tcl follow, on both sides of each
-- condition, against values by hand.
--
-- Run: lua5.4 tests/script/import_expressions_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "?.lua;" .. package.path
local support = require "support"
require "hinge"
local import = require "hinge.import"
local checks = support.checks "expressions of import"
local case, near, equal, expect = checks.case, checks.near, checks.equal, checks.expect

local write = support.writer()

-- The x of node 2, which is an expression.
local function python(expression)
  return import.tcl { file = write("f.py", ("import math\nimport openseespy.opensees as ops\n"
    .. "ops.model('basic', '-ndm', 3, '-ndf', 6)\nops.node(1, -99.0, 0, 0)\nv = %s\n"
    .. "ops.node(2, v, 0, 0)\nops.geomTransf('Linear', 1, 0, 0, 1)\n"
    .. "ops.element('elasticBeamColumn', 1, 1, 2, 1, 1, 1, 1, 1, 1, 1)\n"):format(expression)),
    units = { length = "m", force = "N" } }.nodes[2].x
end
local function tcl(expression)
  return import.tcl { file = write("f.tcl", ("model basic -ndm 3 -ndf 6\nnode 1 -99 0 0\nset v [expr {%s}]\n"
    .. "node 2 $v 0 0\ngeomTransf Linear 1 0 0 1\nelement elasticBeamColumn 1 1 2 1 1 1 1 1 1 1\n"):format(expression)),
    units = { length = "m", force = "N" } }.nodes[2].x
end

case("comparisons of Python and Tcl on each side and at equality, and what joins them", function()
  for _, r in ipairs { { "<", "100" }, { "<=", "110" }, { ">", "001" }, { ">=", "011" }, { "==", "010" },
    { "!=", "101" } } do
    for i, a in ipairs { 1, 2, 3 } do
      local wanted = tonumber(r[2]:sub(i, i))
      local text = ("%d %s 2"):format(a, r[1])
      equal(python(("7 if %s else 6"):format(text)), 6 + wanted, "Python: " .. text)
      equal(tcl(("%s ? 7 : 6"):format(text)), 6 + wanted, "Tcl: " .. text)
      equal(tcl(("%s + 5"):format("(" .. text .. ")")), 5 + wanted, "Tcl, as a number: " .. text)
    end
  end
  for _, r in ipairs { { "0", "0", 0, 0 }, { "0", "3", 0, 1 }, { "3", "0", 0, 1 }, { "3", "5", 1, 1 } } do
    equal(python(("1 if %s and %s else 0"):format(r[1], r[2])), r[3], "Python: and")
    equal(python(("1 if %s or %s else 0"):format(r[1], r[2])), r[4], "Python: or")
    equal(tcl(("%s && %s"):format(r[1], r[2])), r[3], "Tcl: &&")
    equal(tcl(("%s || %s"):format(r[1], r[2])), r[4], "Tcl: ||")
  end
  for expression, wanted in pairs { ["0 or 4"] = 4, ["3 or 4"] = 3, ["3 and 4"] = 4, ["0 and 4"] = 0,
    ["1 if 3 in [1, 3] else 0"] = 1, ["1 if 3 not in [1, 3] else 0"] = 0, ["1 if 2 in (1, 3) else 0"] = 0,
    ["1 if not 3 in [1, 3] else 0"] = 0, ["1 if [1, 2] == [1, 2] else 0"] = 1, ["1 if None is None else 0"] = 1,
    ["1 if 1 is not None else 0"] = 1, ["1 if 3 > 2 > 2 else 0"] = 0, ["1 if 3 > 2 >= 2 else 0"] = 1,
    ["1 if [] else 0"] = 0, ["1 if [0] else 0"] = 1, ["1 if '' else 0"] = 0, ["1 if None else 0"] = 0,
    ["True + True"] = 2, ["False + 3"] = 3 } do equal(python(expression), wanted, expression) end
end)

case("functions of Python and of Tcl have the values of their definition", function()
  local pi = math.pi
  for expression, wanted in pairs { ["math.sqrt(2)"] = 2 ^ 0.5, ["math.sin(1)"] = math.sin(1),
    ["math.cos(1)"] = math.cos(1), ["math.tan(1)"] = math.tan(1), ["math.asin(0.3)"] = math.asin(0.3),
    ["math.acos(0.3)"] = math.acos(0.3),
    ["math.atan(2)"] = math.atan(2), ["math.atan2(1, -2)"] = math.atan(1, -2), ["math.exp(1.5)"] = math.exp(1.5),
    ["math.log(3)"] = math.log(3), ["math.log(8, 2)"] = 3, ["math.radians(90)"] = pi / 2,
    ["math.degrees(1)"] = 180 / pi,
    ["math.fabs(-2.5)"] = 2.5, ["math.floor(-2.5)"] = -3, ["math.ceil(-2.5)"] = -2, ["math.pow(2, 3)"] = 8,
    ["math.hypot(3, 4)"] = 5, ["math.pi"] = pi, ["math.e"] = math.exp(1), ["abs(-3)"] = 3, ["int(-2.7)"] = -2,
    ["int(2.7)"] = 2, ["int('4')"] = 4, ["float('4.5')"] = 4.5, ["round(2.5)"] = 2, ["round(3.5)"] = 4,
    ["round(2.51)"] = 3, ["round(-2.5)"] = -2, ["round(-1.5)"] = -2, ["min(3, 1, 2)"] = 1, ["max([3, 1, 4])"] = 4,
    ["sum([1, 2, 3.5])"] = 6.5, ["len([4, 4])"] = 2, ["len('abc')"] = 3, ["len({1: 2, 3: 4})"] = 2,
    ["list(range(4))[3]"] = 3, ["range(2, 9, 3)[2]"] = 8, ["range(5, 0, -2)[2]"] = 1, ["len(range(5, 0, -2))"] = 3,
    ["len(range(2, 8, 3))"] = 2, ["list(reversed([1, 2, 3]))[0]"] = 3, ["tuple([5, 6])[1]"] = 6,
    ["list(enumerate([7, 8]))[1][0]"] = 1, ["list(enumerate([7, 8], start=3))[1][0]"] = 4,
    ["list(zip([1, 2, 3], [4, 5]))[1][1]"] = 5, ["len(list(zip([1, 2, 3], [4, 5])))"] = 2, ["{'a': 3, 2: 4}[2]"] = 4,
    ["[1, 2, 3][-2]"] = 2, ["([0] * 3 + [5])[3]"] = 5, ["len(2 * [1, 2])"] = 4,
    ["[x * x for x in range(5) if x > 2][1]"] = 16,
    ["7 // -2"] = -4, ["-7 % 4"] = 1, ["7.5 % 2"] = 1.5, ["2 ** 0.5"] = 2 ^ 0.5, ["0x1F"] = 31, ["1_000.5"] = 1000.5,
    [".5e1"] = 5, ["1e-2"] = 0.01, ["+4 - -3"] = 7, ["(1 + 2) * (3 - 5)"] = -6, ["int('1' + '2')"] = 12 } do
    near(python(expression), wanted, 1e-14 * (1 + math.abs(wanted)), "Python: " .. expression)
  end
  for expression, wanted in pairs { ["sqrt(2)"] = 2 ^ 0.5, ["sin(1)"] = math.sin(1), ["cos(1)"] = math.cos(1),
    ["tan(1)"] = math.tan(1), ["asin(0.3)"] = math.asin(0.3), ["acos(0.3)"] = math.acos(0.3),
    ["atan(2)"] = math.atan(2),
    ["atan2(1, -2)"] = math.atan(1, -2), ["exp(1.5)"] = math.exp(1.5), ["log(3)"] = math.log(3), ["log10(1000)"] = 3,
    ["abs(-3)"] = 3, ["pow(2, 3)"] = 8, ["hypot(3, 4)"] = 5, ["int(-2.7)"] = -2, ["int(2.7)"] = 2, ["round(2.5)"] = 3,
    ["round(-2.5)"] = -3, ["round(2.4)"] = 2, ["double(3) / 2"] = 1.5, ["floor(-2.5)"] = -3, ["ceil(-2.5)"] = -2,
    ["min(3, 1, 2)"] = 1, ["max(3, 1, 4)"] = 4, ["fmod(7.5, 2)"] = 1.5, ["7 / -2"] = -4, ["-7 % 4"] = 1,
    ["2 ** 10"] = 1024, ["2 ** 0.5"] = 2 ^ 0.5, ["0x1F + 1"] = 32, ["1e2 + .5"] = 100.5, [".5e1"] = 5,
    ["1 ? 2 : 3"] = 2, ["0 ? 2 : 1 ? 4 : 5"] = 4, ["!3 + 1"] = 1, ["\"a\" eq \"a\""] = 1, ["\"a\" ne \"a\""] = 0,
    ["\"a\" == \"b\""] = 0, ["\"a\" != \"b\""] = 1, ["2.0 == 2"] = 1, ["wide(2.9)"] = 2, ["-(2 + 3)"] = -5,
    ["010 + 1"] = 9, ["2**-1"] = 0, ["2.0**-1"] = 0.5, ["6 & 3"] = 2, ["6 | 3"] = 7, ["6 ^ 3"] = 5,
    ["~6"] = -7, ["3 << 2"] = 12 } do
    near(tcl(expression), wanted, 1e-14 * (1 + math.abs(wanted)), "Tcl: " .. expression)
  end
  for _, expression in ipairs { "1 / 0", "1 % 0", "1 // 0", "sqrt(2)", "undefined + 1", "[1, 2][2]", "{1: 2}[3]",
    "'a' - 1", "range(0.5)[0]" } do
    expect(not pcall(python, expression), "Python follows no %s", expression)
  end
  for _, expression in ipairs { "1 / 0", "1 % 0", "foo(2)", "$undefined + 1", "(2", "1 ? 2" } do
    expect(not pcall(tcl, expression), "Tcl follows no %s", expression)
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
      .. "element('elasticBeamColumn', 1, 1, 2, 1, 1, 1, 1, 1, 1, 1)\n"), units = { length = "m", force = "N" } }
    equal(#notes, 0, line .. ": nothing is missing")
    equal(notes.skipped[1] and notes.skipped[1].text, line, "what is skipped")
  end
end)

checks.done()
