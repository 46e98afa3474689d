-- hinge.import.tcl: scripts are run by their own interpreters, and what they say is what tclsh and python3 say. Lines
-- in procedures, loops and other files; results of the analysis, which hinge does not have; scripts that end early.
--
-- Run: lua5.4 tests/script/import/import_recorded_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
require "hinge"
local import = require "hinge.import"
local checks = support.checks "recorded scripts"
local case, near, equal, expect = checks.case, checks.near, checks.equal, checks.expect
local refused = checks.refused

local write, folder = support.writer()
local units = { length = "m", force = "N" }

local head = "model basic -ndm 2 -ndf 3\nnode 1 0 0\n"
local tail = "fix 1 1 1 1\ngeomTransf Linear 1\nelement elasticBeamColumn 1 1 2 0.01 2e11 1e-4 1\n"

local whole = head .. "node 2 0 3\n" .. tail

local function tcl(text) return import.tcl { file = write("frame.tcl", text), units = units } end

-- The height of node 2, which the script gives.
local function height(text, ...)
  local frame, notes = tcl(head .. text .. "\n" .. tail)
  equal(#notes, 0, text .. ": " .. tostring(notes))
  return frame.nodes[2].z, ...
end

case("Tcl: a variable has the value that tclsh gives it, whatever set it", function()
  for text, wanted in pairs {
    ["set h 3.0\nif {[info exists tall]} { set x 1 } else { set h 4.0 }\nnode 2 0 $h"] = 4,
    ["set h 3.0\nswitch a { a { set h 4.0 } b { set h 5.0 } }\nnode 2 0 $h"] = 4,
    ["set h 3.0\ncatch { set h 4.0; nonsense.x; set h 5.0 }\nnode 2 0 $h"] = 4,
    ["set h 3.0\neval set h 4.0\nnode 2 0 $h"] = 4,
    ["set p {3.0 5.0}\nlset p 0 4.0\nnode 2 0 [lindex $p 0]"] = 4,
    ["set h 3.0\nproc taller {by} { global h; set h [expr {$h + $by}] }\ntaller 1\nnode 2 0 $h"] = 4,
    ["array set of {wall 3.0 column 4.0}\nforeach {name h} [array get of] {}\nnode 2 0 $of(column)"] = 4,
    ["set d [dict create h 4.0]\ndict for {k v} $d { node 2 0 $v }"] = 4,
    ["set h [lindex [lsort -real {7 4.0 9}] 0]; node 2 0 $h"] = 4,
    ["pset h 4.0\nnode 2 0 $h"] = 4,
    ["if {[getPID] == 0 && [getNP] == 1} { node 2 0 4 }"] = 4,
    ["namespace eval of { variable h 4.0 }\nnode 2 0 $of::h"] = 4,
    ["set h 1\nwhile 1 { if {[incr h] == 4} break }\nnode 2 0 $h"] = 4,
    ["for {set i 0} {$i < 8000} {incr i} { lappend times $i }\nnode 2 0 [expr {[llength $times] / 2000}]"] = 4,
    ["set text \"an \\\"a\\\" { in quotes\"\nnode 2 0 4"] = 4,
    ["set text {a \" in braces}; node 2 0 4"] = 4,
    ["node 2 0 [expr {round(4.2)}] ;# a comment"] = 4,
    ["node 2 0 [expr {0.1 + 0.2}]"] = 0.1 + 0.2, ["node 2 0 [expr {7 / 3.0}]"] = 7 / 3, -- to the last digit
    ["node 2 0 [expr {acos(-1.0)}]"] = math.pi,
  } do near(height(text), wanted, 0, text) end
end)

case("Tcl: text in quotes is text: no command in it runs", function()
  local frame, notes = tcl(whole .. "mass 2 100 100 0\nset log stdout\n"
    .. 'puts $log "masses of the roof; mass 2 500 500 0 in kg"\nputs $log "supports; fix 2 1 1 1 as before"\n')
  near(notes.summary.mass_of_nodes, 100, 0, "mass, kg")
  equal(frame.nodes[2].fix, "y,rx,rz", "the node is free in the plane")
  -- a variable that is not there ends the script; nothing but prints follows
  frame, notes = tcl(whole .. "mass 2 100 100 0\n"
    .. 'puts $log "masses of the roof; mass 2 500 500 0 in kg"\nputs $log "fix 2 1 1 1"\n')
  near(notes.summary.mass_of_nodes, 100, 0, "mass, kg")
  equal(#notes .. " " .. notes[1].line .. " " .. notes[1].text, '1 8 can\'t read "log": no such variable', "the note")
  equal(#frame.members, 1, "members")
end)

case("Tcl: procedures make nodes; what is not read has its line in loops, procedures and other files", function()
  write("parts.tcl", "proc column {tag x} {\n  node $tag $x 3\n  weld $tag\n}\nincrease 1\n")
  local frame, notes = tcl(head .. [[
source parts.tcl
foreach tag {2} x {1.5} {
  column $tag $x
  if {1} {
    bearing $tag
  }
}
proc loads {} {
  set F 5
  pattern Plain 1 Linear {
    load 2 $F 0 0
    settle 2
  }
}
]] .. tail .. "loads\npattern Plain 2 Linear {\n  load 2 1 0 0\n  sp 2 1 0.1\n}\nuniaxialMaterial Viscous 1 2e11\n"
  .. "eval {\n  bearing 3\n}\n")
  local lines = {}
  for i, entry in ipairs(notes) do lines[i] = entry.file:match "[^/]*$" .. ":" .. entry.line .. " " .. entry.text end
  table.sort(lines)
  equal(table.concat(lines, "; "), "frame.tcl:14 settle 2; frame.tcl:23 sp 2 1 0.1; "
    .. "frame.tcl:25 uniaxialMaterial Viscous 1 2e11; frame.tcl:27 bearing 3; frame.tcl:7 bearing $tag; "
    .. "parts.tcl:3 weld $tag; parts.tcl:5 increase 1", "lines")
  near(frame.nodes[2].x, 1.5, 0, "a node of a procedure")
  near(frame.cases[1].loads[1].force[1], 5, 0, "a load in the braces sees the variables of its procedure")
end)

case("Tcl: results can be computed with; where a number of the model hangs on one, it is not read", function()
  local frame, notes = tcl(whole .. [[
set ok [analyze 10]
if {$ok != 0} { puts failed } else { loadConst -time 0.0 }
set omega [expr {sqrt([lindex [eigen 3] 0])}]
set T [expr {6.283 / $omega}]
set drift [expr {[nodeDisp 2 1] / 3.0}]
lassign [nodeDisp 2] ux uy rz
set N [lindex [eleResponse 1 force] 0]
while {[nodeDisp 2 1] < 0.5} { analyze 1 }
while {[getTime] < 2.0} { analyze 1 0.01 }
foreach tag [getNodeTags] { puts "$tag [nodeCoord $tag 2] [nodeCoord $tag]" }
node 3 0 [expr {[nodeCoord 2 2] + 2}]
element elasticBeamColumn 2 2 3 0.01 2e11 1e-4 1
rayleigh [expr {0.02*$omega}] 0 0 0
]])
  equal(notes[1].line .. " " .. notes[1].reason, "19 it hangs on a result of the analysis, which hinge does not "
    .. "compute here", "damping by a frequency")
  equal(#notes, 1, tostring(notes))
  near(frame.nodes[3].z, 5, 0, "a coordinate is no result")
  equal(#notes.skipped, 1, "what is computed is one entry: " .. tostring(notes))
  frame, notes = tcl(whole .. "set u [nodeDisp 2 1]\nnode 3 0 [expr {4 + $u}]\n"
    .. "pattern Plain 1 Linear { load 2 [expr {1e3 * [eigen 1]}] 0 0; load 2 5 0 0 }\n"
    .. "pattern Plain 2 Linear -fact [expr {1 / $u}]\nload 2 7 0 0\n")
  equal(#notes, 4, tostring(notes))
  equal(#frame.nodes .. " " .. #frame.cases .. " " .. #frame.cases[1].loads, "2 1 1", "what is left")
  near(frame.cases[1].loads[1].force[1], 5, 0, "and not that of the pattern that hangs on a result")
end)

case("Tcl: a branch that hangs on a result is named, and nothing behind it is read", function()
  local frame, notes = tcl(whole .. "analyze 1\nif {[nodeDisp 2 1] > 0.002} { node 3 0 4 }\nnode 4 0 5\n")
  equal(#notes, 1, tostring(notes))
  expect(notes[1].line == 8 and notes[1].reason:find("whether this runs hangs on a result", 1, true), "%s",
    tostring(notes))
  equal(#frame.nodes, 2, "nodes")
  for _, loop in ipairs { "while {[nodeDisp 2 1] < 5} { analyze 1; remove loadPattern 1 }",
    "for {set i 0} {$i < 1e4*[nodeDisp 2 1]} {incr i} { node [expr {10 + $i}] 0 $i }" } do
    _, notes = tcl(whole .. "analyze 1\n" .. loop .. "\n")
    expect(tostring(notes):find("frame.tcl:8: [^\n]*whether this runs"), "%s", tostring(notes))
  end
  for _, number in ipairs { "[expr {3 + rand()}]", "[clock microseconds]" } do -- chance and time are not known either
    _, notes = tcl(whole .. "node 3 0 " .. number .. "\n")
    expect(#notes == 1 and notes[1].line == 7, "%s: %s", number, tostring(notes))
  end
end)

case("Tcl: an error before an analysis is an error of the file; behind one, its line is in the notes", function()
  for _, name in ipairs { "nod", "nodee", "ndoe", "Node" } do
    refused(("frame.tcl:3: invalid command name \"%s\" (did you mean 'node'?)"):format(name), function()
      tcl(head .. name .. " 2 0 3\n" .. tail)
    end)
  end
  refused("did you mean 'lappend'", function() tcl(whole .. "lapend x 1\n") end)
  local outside = whole .. "pattern Plain 1 Linear { load 2 1 0 0 }\nload 2 1 0 0\n"
  refused("frame.tcl:8: the load stands outside of a pattern", function() tcl(outside) end)
  local _, notes = tcl(whole .. "analyze 1\nset f [open record.txt r]\nnode 3 0 4\n")
  equal(#notes .. " " .. notes[1].line, "1 8", tostring(notes))
  expect(notes[1].text:find("record.txt", 1, true), "%s", tostring(notes))
  _, notes = tcl(whole .. "analyze 1\nexit\nnode 3 0 4\n")
  equal(#notes, 0, "exit ends a script: " .. tostring(notes))
end)

case("Tcl: files below the folder are read, and files to write are dropped", function()
  support.run(("mkdir -p %sdata"):format(support.quote(folder)))
  write("data/heights.txt", "3.5\n4.5\n")
  near(height([[
set f [open data/heights.txt r]
gets $f first
set second [gets $f]
if {[gets $f more] >= 0 || ![eof $f]} { error "the file has two lines" }
close $f
set out [open results.txt w]
puts $out "height $second"
close $out
file mkdir results
if {[file exists data/heights.txt] && ![file exists ../heights.txt]} { node 2 0 $second }]]), 4.5, 0, "height, m")
  near(height "set f [open [file join [file dirname [info script]] data heights.txt]]\nnode 2 0 [lindex [read $f] 0]",
    3.5, 0, "by the script's own folder")
  expect(not support.is_there(folder .. "results.txt") and not support.is_there(folder .. "results"), "it wrote")
end)

-- Python --------------------------------------------------------------------------------------------------------------

local python_head = "import openseespy.opensees as ops\nops.model('basic', '-ndm', 2, '-ndf', 3)\nops.node(1, 0, 0)\n"
local python_tail = "ops.fix(1, 1, 1, 1)\nops.geomTransf('Linear', 1)\n"
  .. "ops.element('elasticBeamColumn', 1, 1, 2, 0.01, 2e11, 1e-4, 1)\n"
local python_whole = python_head .. "ops.node(2, 0, 3)\n" .. python_tail

local function python(text)
  return import.tcl { file = write("frame.py", text), units = units, run_python = true }
end

case("Python: a file is a program, and runs only where the user says so", function()
  local file = write("frame.py", "import os\nos.abort()\n")
  for _, options in ipairs { {}, { run_python = false }, { language = "python" } } do
    options.file, options.units = options.language and write("frame.txt", "1\n") or file, units
    refused("is a program in Python, and reading it is running it. If you want that, say so: hinge export "
      .. "--run-python, or run_python = true", import.tcl, options)
  end
end)

case("Python: a variable has the value that python3 gives it, whatever set it", function()
  write("parts.py", "import openseespy.opensees as ops\ndef column(tag, height):\n    ops.node(tag, 0, height)\n")
  for text, wanted in pairs {
    ["p = [3.0]\nq = p\nq += [4.0]\nops.node(2, 0, p[-1])"] = 4,
    ["import os\nh = 3.0\nif os.path.exists('x'):\n    pass\nelse:\n    h = 4.0\nops.node(2, 0, h)"] = 4,
    ["h = 3\nmatch h:\n    case 3: h = 4\nops.node(2, 0, h)"] = 4,
    ["from parts import column\ncolumn(2, 4.0)"] = 4,
    ["class Frame:\n    def __init__(self): self.h = 4.0\n    def make(self): ops.node(2, 0, self.h)\n"
      .. "Frame().make()"] = 4,
    ["def f(n):\n    return 1 if n == 0 else 2 * f(n - 1)\nops.node(2, 0, f(2))"] = 4,
    ["if __name__ == '__main__':\n    ops.node(*(2, 0), *[4.0])"] = 4,
    ["from openseespy.opensees import *\nnode(2, 0, 4)"] = 4,
    ["ops.node(2, 0, 0.1 + 0.2)"] = 0.1 + 0.2, ["ops.node(2, 0, 1e22 / 3)"] = 1e22 / 3, -- to the last digit
    ["import math\nops.node(2, 0, math.pi)"] = math.pi, ["ops.node(2, False, True + 2)"] = 3,
    ["from opsvis import *\nfrom os import path\nops.node(2, 0, 4)"] = 4,
    ["import opensees as o\no.node(2, [0, 4])"] = 4,
    ["from openseespy import opensees\nopensees.node(2, 0, 4)"] = 4,
    ["import openseespy\nopenseespy.opensees.node(2, 0, 4)"] = 4,
    ["try:\n    raise ValueError\nexcept ValueError:\n    ops.node(2, 0, 4)"] = 4,
    ["import matplotlib.pyplot as plt, opsvis as opsv\nfig, (a, b) = plt.subplots(2)\na.plot([1, 2])\n"
      .. "fig.savefig('x.png')\nplt.figure(figsize=(1, 2)).add_subplot(111).set_xlim(0, 1)\n"
      .. "for x in b.lines: print(x)\nopsv.plot_model()\nplt.show()\nops.node(2, 0, 4)"] = 4,
    ["with open('h.txt', 'w') as f:\n    print('x')\n    f.write('4.0')\n"
      .. "ops.node(2, 0, float(open('h.txt').read()))"] = 4,
  } do
    local frame, notes = python(python_head .. text .. "\n" .. python_tail)
    equal(#notes, 0, text .. ": " .. tostring(notes))
    near(frame.nodes[2].z, wanted, 0, text)
    expect(#notes.skipped <= 1, "what is computed is one entry: %s", tostring(notes))
  end
end)

case("Python: lines in functions and in other files; what is not read", function()
  write("bits.py", "import openseespy.opensees as ops\n\ndef springs(n):\n    for i in range(n):\n"
    .. "        ops.weld(i)\n")
  local _, notes = python(python_head .. "import bits\nops.node(2, 0, 4)\n" .. python_tail
    .. "bits.springs(3)\nops.element('truss', 2,\n            1, 2, 1.0, 1)\n")
  local lines = {}
  for i, entry in ipairs(notes) do
    lines[i] = ("%s:%d %s %d"):format(entry.file:match "[^/]*$", entry.line, entry.text, entry.count or 1)
  end
  table.sort(lines)
  equal(table.concat(lines, "; "), "bits.py:5 ops.weld(i) 3; frame.py:10 ops.element('truss', 2, 1", "lines")
end)

case("Python: results can be computed with; a number of the model that hangs on one is not read", function()
  local frame, notes = python(python_whole .. [[
ok = ops.analyze(10)
if ok != 0: print("failed")
omega = ops.eigen('-fullGenLapack', 3)[0] ** 0.5
u = ops.nodeDisp(2)
drift = (u[0] - ops.nodeDisp(1, 1)) / 3
N = ops.eleResponse(1, 'force')[0] + ops.basicForce(1)[2]
while ops.nodeDisp(2, 1) < 0.5: ops.analyze(1)
while ops.getTime() < 20.0: ops.analyze(1, 0.5)
for tag in ops.getNodeTags(): print(tag, ops.nodeCoord(tag), ops.nodeCoord(tag, 2))
ops.node(3, 0, ops.nodeCoord(2, 2) + 2)
ops.element('elasticBeamColumn', 2, 2, 3, 0.01, 2e11, 1e-4, 1)
ops.rayleigh(0.02 * omega, 0, 0, 0)
]])
  equal(#notes .. " " .. notes[1].line, "1 19", tostring(notes))
  expect(notes[1].reason:find("hangs on a result", 1, true), "%s", tostring(notes))
  near(frame.nodes[3].z, 5, 0, "a coordinate is no result")
  for text, what in pairs {
    ["if ops.nodeDisp(2, 1) > 0.002:\n    ops.node(3, 0, 4)"] = "whether this runs hangs on a result",
    ["import random\nops.node(3, 0, random.random())"] = "it hangs on a result",
    ["import time\nops.node(3, 0, time.time())"] = "it hangs on a result",
    ["import nobody\nops.node(3, 0, nobody.height)"] = "it hangs on a result",
    ["import nobody\nif nobody.tall:\n    ops.node(3, 0, 4)"] = "whether this runs hangs on a result" } do
    frame, notes = python(python_whole .. text .. "\n")
    equal(#frame.nodes, 2, text)
    expect(tostring(notes):find(what, 1, true), "%s: %s", text, tostring(notes))
  end
end)

case("Python: an error before an analysis is one of the file; modules that numbers come from are named", function()
  for text, wanted in pairs {
    ["h = 3.0\nh += float(input())"] = "frame.py:5: EOFError",
    ["ops.node(2, 0, height)"] = "frame.py:4: NameError: name 'height' is not defined",
    ["import parts.none"] = "frame.py:4: ModuleNotFoundError" } do
    refused(wanted, function() python(python_head .. text .. "\n" .. python_tail) end)
  end
  local _, notes = python(python_whole .. "ops.analyze(1)\nopen('record.txt')\nops.node(3, 0, 4)\n")
  equal(#notes .. " " .. notes[1].line, "1 9", tostring(notes))
  _, notes = python(python_whole .. "import sys\nsys.exit()\nops.node(3, 0, 4)\n")
  equal(#notes, 0, "exit ends a script: " .. tostring(notes))
  for _, name in ipairs { "numpy", "scipy", "pandas" } do
    if support.run("env -i PATH=/usr/bin:/bin python3 -c 'import " .. name .. "'") ~= 0 then
      refused(("frame.py:1: ModuleNotFoundError: %s is not installed: apt-get install python3-%s"):format(name, name),
        function() python(("import %s\n"):format(name) .. python_head) end)
    elseif name == "numpy" then
      local frame = python("import numpy as np\n" .. python_head .. "ops.node(*np.array([2, 0, 3]))\n"
        .. "for i, z in enumerate(np.linspace(3.5, 4.0, 2)):\n    ops.node(3 + i, np.float64(0), z)\n" .. python_tail
        .. "ops.element('elasticBeamColumn', np.int64(2), 3, 4, 0.01, 2e11, 1e-4, 1)\n")
      near(frame.nodes[4].z, 4, 0, "numbers of numpy")
    end
  end
end)

checks.done()
