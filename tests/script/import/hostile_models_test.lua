-- Files of models that are made to take all time, all memory or all of the stack: each ends soon, with a message that
-- says where and why.
--
-- Run: lua5.4 tests/script/import/hostile_models_test.lua
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local checks = support.checks "hostile_models"
local case, expect, equal = checks.case, checks.expect, checks.equal
local hinge = require "hinge"
local notes = require "hinge.import.notes"
local folder = support.temporary_folder()

-- What import says of a file with this text.
local function said(name, text)
  local path = folder .. "/" .. name
  if text then support.write(path, text) end
  local kind = name:match "[^.]*$"
  local options = { file = path }
  if kind == "py" or kind == "tcl" then
    kind, options.units, options.run_python = "tcl", { force = "kN", length = "m" }, true
  end
  local began = os.clock()
  local good, problem = pcall(hinge.import[kind], options)
  local seconds = os.clock() - began
  expect(seconds < 30, "%s took %.1f s of the processor", name, seconds)
  return good and "it was read" or tostring(problem)
end

local function says(name, text, wanted)
  local problem = said(name, text)
  expect(problem:find(wanted, 1, true), "%s: %s, wanted %s", name, problem, wanted)
end

local seconds, memory = notes.most_seconds, notes.most_memory

case("Tcl: values that grow without bound, loops and files without end", function()
  notes.most_seconds, notes.most_memory = 2, 200
  for text, wanted in pairs {
    ["set x a\nwhile {1} { lappend x $x }"] = "it takes more than 200 MB of memory",
    ["set x a\nwhile {1} { append x $x }"] = "it takes more than 200 MB of memory",
    ["set x abcdefgh\nwhile {1} { set x $x$x }"] = "it takes more than 200 MB of memory",
    ["set x abcdefgh\nwhile {1} { set x [concat $x $x $x] }"] = "200 MB of memory",
    ["string repeat x 1500000000"] = "200 MB of memory",
    ["model basic -ndm 2\nnode 1 0 0\nset x a\nwhile {1} { append x $x }"] =
      "a.tcl:2: behind this command: it takes",
    ["set x 1\nwhile {1} {}"] = "a.tcl:2: the script takes more than 2 s",
    ["while {1} { after 100000 }"] = "a.tcl:1: the script ",
    ["while {1} { catch { while 1 {} } }"] = "a.tcl:1: the script takes more than 2 s",
    ["vwait forever\nafter 1000000\nwhile {1} {set x 1}"] = "a.tcl:3: the script ",
    ["proc f {} { f }\nf"] = "a.tcl:2: too many nested evaluations",
    ["source self.tcl\nsource self.tcl"] = "self.tcl:1: too many nested evaluations",
  } do
    says(text:find "self" and "self.tcl" or "a.tcl", text, wanted)
  end
  notes.most_seconds, notes.most_memory = seconds, memory
end)

case("Tcl: brackets within each other", function()
  says("a.tcl", "set x " .. ("["):rep(1e5), "nested too deeply")
  says("a.tcl", "set x " .. ("{"):rep(1e5), ":1: missing close-brace")
  says("a.tcl", ("if {1} {"):rep(2000) .. ("}"):rep(2000), "a.tcl:1: too many nested")
  says("a.tcl", "set x [expr " .. ("("):rep(1e5) .. "1" .. (")"):rep(1e5) .. "]", "a.tcl")
end)

case("Tcl: no program, no socket, no file outside of the folder, nothing written", function()
  support.run(("cd %s && mkdir -p in/deep && ln -sf /etc/passwd in/link && ln -sf ../../out.tcl in/deep/out.tcl")
    :format(support.quote(folder)))
  support.write(folder .. "/out.tcl", "node 1 0 0\n")
  for text, wanted in pairs {
    ["exec touch " .. folder .. "/made"] = "exec is not available",
    ["catch {exec touch " .. folder .. "/made}\nset f [open " .. folder .. "/made w]\nputs $f x\nclose $f\n"
      .. "file mkdir " .. folder .. "/made"] = "has no node that was read",
    ["open {|ls} r"] = "open: a program is not started",
    ["socket localhost 22"] = "socket is not available",
    ["glob *"] = "glob is not available",
    ["file stat /etc/passwd x"] = "file stat is not available",
    ["interp create x"] = "interp is not available",
    ["open /etc/passwd r"] = "open /etc/passwd: only files in the folder",
    ["open link r"] = "open link: only files in the folder",
    ["open ../out.tcl r"] = "open ../out.tcl: only files in the folder",
    ["source ../out.tcl"] = "source ../out.tcl: only files in the folder",
    ["source deep/out.tcl"] = "source deep/out.tcl: only files in the folder",
    ["source /etc/passwd"] = "source /etc/passwd: only files in the folder",
    ["cd ..\nsource out.tcl"] = "cd ..: only files in the folder",
    ["if {[file exists /etc/passwd] || [file exists link]} { error seen }"] = "has no node that was read",
    ["puts $env(HOME)\nnode 1 0 0"] = "can't read \"env(HOME)\"",
  } do
    says("in/a.tcl", "set a 1\n" .. text, wanted)
  end
  expect(not support.is_there(folder .. "/made"), "a file was made")
  support.run(("mkfifo %s/in/pipe"):format(support.quote(folder)))
  says("in/a.tcl", "open pipe r", "open pipe: it is no file")
  says("in/a.tcl", "source pipe", "source pipe: it is no file")
end)

case("Python: values that grow without bound, and loops without end", function()
  notes.most_seconds, notes.most_memory = 2, 300
  local memory_bomb = "it takes more than 300 MB of memory"
  for text, wanted in pairs {
    ["y = 1\nx = [0] * 1000000000"] = "a.py:2: " .. memory_bomb,
    ["x = 'a' * 1000000000"] = "a.py:1: " .. memory_bomb,
    ["x = [0]\nwhile True:\n    x = x + x"] = "a.py:3: " .. memory_bomb,
    ["x = [0]\nwhile True:\n    try:\n        x = x + x\n    except BaseException: pass"] = "takes more than 2 s",
    ["y = 1\nwhile True: pass"] = "a.py:2: the script takes more than 2 s",
    ["import time\nwhile True: time.sleep(1000)"] = "a.py:2: the script takes more than 2 s",
    ["import signal\nsignal.alarm(0)\nsignal.signal(signal.SIGALRM, signal.SIG_IGN)\nwhile True: pass"] =
      "it takes more than 2 s",
    ["def f(x): return f(x + 1)\nf(1)"] = "a.py:1: RecursionError",
    ["import sys\nsys.setrecursionlimit(10**9)\nf = lambda x: f(x)\nfor i in range(9): f = (lambda g: lambda x: "
      .. "max(x, key=g))(f)\ndef g(x): return max([x], key=g)\ng(1)"] = "nested too deeply",
    ["input()"] = "a.py:1: EOFError",
  } do
    says("a.py", text, wanted)
  end
  notes.most_seconds, notes.most_memory = seconds, memory
end)

case("Python: brackets and blocks within each other", function()
  says("a.py", "x = " .. ("["):rep(1e5) .. ("]"):rep(1e5), "a.py:1: SyntaxError: too many nested parentheses")
  local lines = {}
  for i = 0, 300 do lines[i + 1] = (" "):rep(i) .. "if True:" end
  says("a.py", table.concat(lines, "\n") .. "\n" .. (" "):rep(301) .. "x = 1\n", "IndentationError: too many levels")
  says("a.py", "x = " .. ("-"):rep(1e5) .. "1", "a.py")
end)

case("Python: no process, no program, no network, no file outside of the folder, nothing written", function()
  support.write(folder .. "/secret.txt", "secret")
  support.run(("cd %s && mkdir -p in && ln -sf /etc/passwd in/link"):format(support.quote(folder)))
  local refused = "PermissionError: [Errno "
  for text, wanted in pairs {
    ["import os\nwhile True: os.fork()"] = "a.py:2: " .. refused .. "1]",
    ["import subprocess\nsubprocess.run(['touch', 'made'])"] = "a.py:2: " .. refused,
    ["import os\nif os.system('touch made') == 0: raise ValueError"] = "has no node that was read",
    ["import os\nos.execv('/bin/touch', ['touch', 'made'])"] = "a.py:2: " .. refused .. "13]",
    ["import multiprocessing as m\nm.Process(target=print).start()"] = "a.py:2: PermissionError",
    ["import socket\nsocket.create_connection(('127.0.0.1', 22))"] = "a.py:2: " .. refused .. "1]",
    ["import urllib.request\nurllib.request.urlopen('http://127.0.0.1')"] = "a.py:2: ",
    ["open('/etc/passwd').read()"] = "a.py:1: " .. refused .. "13]",
    ["open('link').read()"] = "a.py:1: " .. refused .. "13]",
    ["open('../secret.txt').read()"] = "a.py:1: " .. refused .. "13]",
    ["import os\nos.open('../secret.txt', os.O_RDONLY)"] = "a.py:2: " .. refused .. "13]",
    ["import os\nos.listdir('..')"] = "a.py:2: " .. refused .. "13]",
    ["import os\nos.open('made', os.O_CREAT | os.O_WRONLY)"] = "a.py:2: " .. refused .. "13]",
    ["import os\nos.symlink('a.py', 'made')"] = "a.py:2: " .. refused .. "13]",
    ["import os\nos.truncate('a.py', 0)"] = "a.py:2: " .. refused,
    ["import os, signal\nos.kill(os.getppid(), signal.SIGKILL)"] = "a.py:2: " .. refused .. "1]",
    ["import os\nos.chmod('a.py', 0)"] = "a.py:2: " .. refused .. "1]",
    ["import ctypes\nctypes.CDLL(None).unlink(b'a.py')\nraise ValueError"] = "a.py:3: ValueError",
    ["f = open('made', 'w')\nf.write('x')\nf.close()\nimport os\nos.remove('a.py')"] = "has no node that was read",
    ["import sys\nsys.path.insert(0, '..')\nimport secret"] =
      "has no node that was read; the first line that was not read: import secret",
    ["import os\nos._exit(7)"] = "python3 ended by status 7",
  } do
    says("in/a.py", text, wanted)
    expect(support.is_there(folder .. "/in/a.py"), "it removed itself: %s", text)
  end
  expect(not support.is_there(folder .. "/in/made") and not support.is_there(folder .. "/made"), "a file was made")
  expect(not support.is_there(folder .. "/in/__pycache__"), "compiled modules were left")
end)

case("devices, pipes and very large files are refused before they are read", function()
  support.run(("cd %s && mkfifo pipe.tcl && ln -s /dev/zero zero.e2k && ln -s /dev/zero zero.s2k && "
    .. "truncate -s 800M large.s2k && ln -s /dev/zero zero.py"):format(support.quote(folder)))
  for _, name in ipairs { "pipe.tcl", "zero.e2k", "zero.s2k", "zero.py" } do
    says(name, nil, "it is a pipe, a socket or a device")
  end
  says("large.s2k", nil, "has 839 MB, and more than 500 MB are not read")
end)

case("limits of time and memory hold wherever a reader is, and leave no hook", function()
  notes.most_seconds = 0.05
  says("a.tcl", "while {1} {}", "takes more than 0.05 s")
  notes.most_seconds, notes.most_memory = seconds, 2
  says("a.tcl", "set x 1", "takes more than 2 MB of memory")
  notes.most_memory = memory
  equal(debug.gethook(), nil, "a hook")
end)

checks.done()
