-- A line of code (hinge -e) and the prompt (hinge -i): what they print, how they end, what Tab offers, what is kept.
--
-- Run: lua5.4 tests/script/program/prompt_test.lua BUILD_FOLDER
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local checks = support.checks "prompt"
local case, ended = checks.case, checks.ended
local quote, run, expect, equal = support.quote, support.run, checks.expect, checks.equal

local folder = support.temporary_folder()
local function path(name) return folder .. "/" .. name end
local hinge = ("cd %s && XDG_STATE_HOME=%s TERM=xterm %s")
  :format(quote(folder), quote(path "state"), quote(arg[1] .. "/hinge"))

-- One line ------------------------------------------------------------------------------------------------------------

case("hinge -e evaluates one line and prints its values", function()
  for code, wanted in pairs {
    ["1 + 1"] = "2\n",
    ["x = 5"] = "",
    ["nil, 'text', {}"] = "nil\ttext\t{}\n",
    ["hinge.section.solid { width = 0.1, depth = 0.1 }.area"] = "0.01\n",
    ["hinge.model()"] = "model: 0 nodes, 0 members\n",
    ["{ 1, 2, b = 'two', a = { c = true }, ['end'] = 1, [2.5] = 0 }"] =
      '{ 1, 2, [2.5] = 0, a = { c = true }, b = "two", ["end"] = 1 }\n',
    ["local t = {} t.t = t return t"] = "{ t = {...} }\n",
    ["local t = {} for i = 1, 100 do t[i] = 7 end return t"] = "{\n" .. ("  7,\n"):rep(40) .. "  ... 60 more\n}\n",
    ["{ ('x'):rep(60), { ('y'):rep(60) } }"] = '{\n  "' .. ("x"):rep(60) .. '",\n  { "' .. ("y"):rep(60) .. '" }\n}\n',
  } do
    equal(ended(0, "", run(hinge .. " -e " .. quote(code))), wanted, code)
  end
  ended(0, "6\tII\n", run(hinge .. " -e 'local p = ... return p.speed, p.name' speed=2*3 name=II"))
  for code, message in pairs {
    ["x ="] = "hinge: (command line):1: unexpected symbol near <eof>\n",
    ["hinge.modle()"] = "hinge: (command line):1: hinge: unknown field 'modle' (did you mean 'model'?); there are ",
    ["error 'no'"] = "hinge: (command line):1: no\n  at (command line):1\n",
  } do equal(ended(2, message, run(hinge .. " -e " .. quote(code))), "", code) end
  local overloaded = [[
local m = hinge.model() local a, b = m:node { 0, 0, 0 }, m:node { 1, 0, 0 } m:fix(a)
m:member { a, b, section = hinge.section.solid { width = 0.05, depth = 0.05 },
  material = hinge.material { E = 2e11, yield_stress = 2e8 } }
m:load { node = b, force = { 0, 0, -1e6 } }
return m:static {}:finish().verdict]]
  equal(ended(1, "hinge: the run failed: no equilibrium", run(hinge .. " -e " .. quote(overloaded))), "failed\n",
    "a failed run")
  expect(not support.is_there(path "out") and not support.is_there(path "summary.json"),
    "hinge -e leaves nothing behind")
  for _, words in ipairs { " -e 1 speed", " -e" } do ended(2, "", run(hinge .. words)) end
end)

-- Lines from a pipe ---------------------------------------------------------------------------------------------------

local function typed(lines, arguments)
  return run(("printf %%s %s | ( %s -i %s )"):format(quote(lines), hinge, arguments or ""))
end
case("lines from a pipe are run one after the other, errors do not end them", function()
  local printed, complaint = ended(0, "", typed("print(1)\n1 +\n2\nt = { 1,\n 'a' }\nt\n"
    .. "for i = 1, 2 do\n  print(i)\nend\nlocal gone = 1\ngone\nx = 5 return x"))
  equal(complaint, "", "nothing is wrong")
  equal(printed, '1\n3\n{ 1, "a" }\n1\n2\nnil\n5\n', "what the lines print")
  printed, complaint = ended(0, "",
    typed "error 'one'\nhinge.model { formulaton = 1 }\nx = = 2\nerror { 1 }\n7 * 6\nprint(")
  equal(printed, "42\n", "the line after them")
  expect(support.says(complaint, "hinge: prompt:1: one\n  at prompt:1\n"
    .. "hinge: prompt:1: hinge.model: unknown field 'formulaton' (did you mean 'formulation'?); it takes ...\n"
    .. "hinge: prompt:1: unexpected symbol near '='\nhinge: the script raised a table\n  at prompt:1\n"
    .. "hinge: prompt:1: unexpected symbol near <eof>\n"), "their messages: %s", complaint)
  equal(select(2, typed "type(hinge), hinge.version"):match "^%a+", "table", "hinge is a global there")

  support.write(path "scene.lua",
    "assert(hinge == nil, 'a global')\nmodel = require 'hinge'.model()\nmodel:node { 1, 2, 3 }\ngiven = (...).n\n")
  ended(0, "model: 1 node, 0 members\t3\n", typed("model, given\n", "scene.lua n=3"))
  support.write(path "wrong.lua", "error 'wrong'\n")
  for _, name in ipairs { "wrong.lua", "nowhere.lua" } do ended(2, "", typed("1\n", name)) end -- in a pipe
end)

-- At a terminal: `script` is one --------------------------------------------------------------------------------------

case("at a terminal the prompt prints values, goes on over several lines and keeps a history", function()
  local function at_terminal(keys, program, environment)
    return run(("printf %%b %s | env %s TERM=xterm timeout 20 script -qec %s /dev/null"):format(quote(keys),
      environment or "", quote(program .. " -i")))
  end
  ended(0, { "function: ", "42\r\n", "hinge: prompt:1: here", "still there" },
    at_terminal("hinge.sec\\t.pi\\t\\nprint(40+\\n2)\\nerror [[here]]\\n'still ' .. 'there'\\n", hinge))
  local history = support.read(path "state/hinge/history") or ""
  expect(history:find "hinge%.section%.pipe\n" and history:find "here", "history: %s", history)
  ended(0, "still there\r\n", at_terminal("\\020\\n", hinge)) -- the last session's last line, by Ctrl-P
  support.write(path "file", "")
  for _, state in ipairs { "XDG_STATE_HOME=" .. path "file", "-u XDG_STATE_HOME -u HOME" } do
    local printed, complaint = ended(0, "2\r\n", at_terminal("1+1\\n", quote(arg[1] .. "/hinge"), state))
    expect(not (printed .. complaint):find "hinge: ", "no place for a history: %s%s", printed, complaint)
  end
end)

case("Ctrl-C ends what runs and not the session", function()
  support.write(path "endless.lua", [[
function endless()
  local pid <close> = io.open("pid", "w")
  pid:write(io.open("/proc/self/stat"):read "n")
  pid:flush()
  while true do end
end
]])
  local busy =
    "(printf %%b %s; for i in $(seq 200); do [ -s %s ] && break; sleep 0.1; done; kill -INT $(cat %s); printf %%b %s)"
  local status, printed = run((busy .. " | timeout 60 script -qec %s /dev/null")
    :format(quote "endless()\\n", quote(path "pid"), quote(path "pid"), quote "'after' .. 1\\n",
      quote(hinge .. " -i endless.lua")))
  expect(status == 0 and printed:find "hinge: interrupted" and printed:find "after1", "Ctrl-C: %s %s", status, printed)
end)

-- What Tab offers -----------------------------------------------------------------------------------------------------

case("Tab offers names, methods and files", function()
  _G.hinge = require "hinge"
  local complete = require "hinge.program.prompt".complete
  local scene = { model = _G.hinge.model(), name = "x", ["not a name"] = 1 }
  _G.scene = scene
  scene.wall = scene.model:node { 0, 0, 0 }
  local function offers(line, wanted)
    equal(table.concat(complete(line), " "), wanted, "Tab after " .. line)
  end
  offers("x = hinge.sec", "hinge.section")
  offers("hinge.section.",
    "hinge.section.angle hinge.section.box hinge.section.channel hinge.section.concrete hinge.section.general "
    .. "hinge.section.h "
      .. "hinge.section.named hinge.section.names hinge.section.pipe hinge.section.round hinge.section.solid")
  offers("scene.model:st", "scene.model:static")
  offers("print(scene.n", "scene.name")
  offers("whi", "while")
  offers("string.for", "string.format")
  offers("nowhere.x", "")
  offers("scene.", "scene.model scene.name scene.wall")
  offers("scene.wall.i", "scene.wall.index")
  offers("scene.wall:d", "scene.wall:displacement")
  offers("scene:", "")
  offers("f(1).", "")
  expect(#complete "" > 50, "with nothing typed: all globals and keywords")
end)

checks.done()
