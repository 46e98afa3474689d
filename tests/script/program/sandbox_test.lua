-- A script that is not trusted: what it can do, each way out that it might try and what it is told, and the limits,
-- which hold inside a native call too.
--
-- Run: lua5.4 tests/script/program/sandbox_test.lua BUILD_FOLDER
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local checks = support.checks "sandbox"
local case, ended = checks.case, checks.ended
local run, expect, equal = support.run, checks.expect, checks.equal

local _, folder, hinge = support.scenes(arg[1])
local function path(name) return folder .. "/" .. name end
local count = 0

-- Runs the script in a folder of its own; it ends with this status and these words. Returns what it printed.
local function ends(script, status, words, options)
  count = count + 1
  support.write(path "s.lua", script)
  return (ended(status, words, hinge(("run --sandbox s.lua --out out%d %s"):format(count, options or ""))))
end

-- What is left is enough to work with ---------------------------------------------------------------------------------

local frame = [[
local hinge = require "hinge"
local steel = hinge.material { E = 206e9, density = 7850, yield_stress = 245e6 }
local bar = hinge.section.solid { width = 0.05, depth = 0.05 }
local function cantilever(rule)
  local model = hinge.model()
  local foot, tip = model:node { 0, 0, 0 }, model:node { 1, 0, 0 }
  model:fix(foot)
  model:member { foot, tip, section = bar, material = steel }
  model:load { node = tip, force = { 0, 0, -1e4 } }
  if rule then model:fracture(rule) end
  return model
end
]]
case("what is left in the sandbox is enough to work with", function()
  local printed = ends(frame .. [[
local check = require "hinge.library.check"
return hinge.scenario {
  parameters = { dt = 1e-5 }, cases = { slow = { dt = 2e-5 } },
  run = function(p, job)
    local run = cantilever(function(s) return s.curvature_y > 1 end):dynamic { dt = p.dt, duration = 1e-3 }
    for step in run:steps() do if step.index == 10 then job:frame(run) end end
    local co = coroutine.wrap(function() coroutine.yield(math.sin(1)) end)
    print(("%.3f"):format(co()), #table.pack(1, 2), os.time() > 0, utf8.char(72), select(2, pcall(error, "x")),
      load "return 1 + 1" ())
    job:note "seen"
    return { steps = run.index }
  end,
}]], 0, "", "--case slow")
  expect(printed:find "0%.841\t2\ttrue\tH\tx\t2\n", "what it prints: %s", printed)
  local summary = support.json(support.read(path "out1/summary.json") or "{}")
  equal(summary.results and summary.results.steps, 50, "its results")
  expect(support.is_there(path "out1/history.csv") and support.is_there(path "out1/frames/frame_00001.vtp"),
    "its files")
  ended(0, "", hinge "--sandbox s.lua --out short")
  ended(0, "dynamic run", hinge "plan --sandbox s.lua")
  local main_job = support.output("realpath " .. support.root .. "scripts/ten_storey_impact.lua"):sub(1, -2)
  ended(0, "", hinge("run --sandbox " .. main_job .. " duration=1e-4 --out impact"))
end)

-- Ways out ------------------------------------------------------------------------------------------------------------

case("every way out of the sandbox is closed", function()
  support.write(path "secret.lua", "return 'secret'")
  support.run(("ln -s %s %s"):format(path "elsewhere", path "link"))
  local absent = { -- expression that leads out -> what is not there
    ["io.open '/etc/passwd'"] = "io.open",
    ["io.popen 'id'"] = "io.popen",
    ["io.write 'x'"] = "io.write",
    ["io.lines 's.lua'"] = "io.lines",
    ["io.stderr:write 'x'"] = "io.stderr",
    ["os.execute 'id'"] = "os.execute",
    ["os.remove 's.lua'"] = "os.remove",
    ["os.rename('s.lua', 't.lua')"] = "os.rename",
    ["os.tmpname()"] = "os.tmpname",
    ["os.getenv 'HOME'"] = "os.getenv",
    ["os.exit(0)"] = "os.exit",
    ["os.setlocale 'C'"] = "os.setlocale",
    ["dofile 'secret.lua'"] = "dofile",
    ["loadfile 'secret.lua'"] = "loadfile",
    ["package.loadlib('libc.so.6', 'system')"] = "package.loadlib",
    ["package.cpath"] = "package.cpath",
    ["package.loaded"] = "package.loaded",
    ["package.searchers"] = "package.searchers",
    ["debug.getregistry()"] = "debug.getregistry",
    ["debug.getupvalue(print, 1)"] = "debug.getupvalue",
    ["debug.sethook()"] = "debug.sethook",
    ["debug.getmetatable ''"] = "debug.getmetatable",
    ["debug.setmetatable(1, {})"] = "debug.setmetatable",
    ["debug.getinfo(print)"] = "debug.getinfo",
    ["string.dump(print)"] = "string.dump",
    ["('').dump"] = "string.dump",
    ["_G.io.open"] = "io.open",
    ["load 'return os.execute' ()"] = "os.execute",
    ["load('return io.open', 'x', 'bt', _G)()"] = "io.open",
    ["coroutine.wrap(function() return os.execute 'id' end)()"] = "os.execute",
  }
  for expression, name in pairs(absent) do
    local place = expression:find "^load ?['(]" and "\"]:1" or "s.lua:1" -- of a coroutine Lua adds the other one
    ends("local x = " .. expression .. "\nprint 'OUT'", 2,
      { place .. ": ", (": %s is not available to a script in the sandbox\n"):format(name) })
  end

  local series = "{ series = { { x = { 1, 2 }, y = { 1, 2 } } } }"
  local function in_job(statements)
    return "return require 'hinge'.scenario { run = function(_, job) " .. statements .. " end }"
  end
  -- a plot of this folder, or of this file in the job's folder
  local function plot_to(out) return in_job("job.out = " .. out .. "; job:plot(" .. series .. ", 'x.png')") end
  local outside = "is outside the output folder"
  local function no_module(name) return "module '" .. name .. "' is not available to a script in the sandbox; there" end
  local no_field = { "s.lua:", "attempt to index a boolean value" }
  local ways = { -- script -> status, message
    { "require 'hinge.core'", 2, "s.lua:1: require: " .. no_module "hinge.core" .. " are hinge, " },
    { "require 'hinge.program.runner'", 2, no_module "hinge.program.runner" },
    { "require 'secret'", 2, no_module "secret" },
    { "require 'hinge.../../secret'", 2, no_module "hinge.../../secret" },
    { "collectgarbage 'stop'", 2, { "s.lua:1: collectgarbage: option 'stop' is not available", "'collect', " } },
    { "assert(load('\\27Lua'))", 2, "attempt to load a binary chunk (mode is 't')" },
    { "assert(load('\\27Lua', 'x', 'b'))", 2, "attempt to load a binary chunk (mode is 't')" },
    { "getmetatable('').__index.format = nil", 2, no_field },
    { "getmetatable(os).__index = nil", 2, no_field },
    { "setmetatable(_G, {})", 2, "s.lua:1: cannot change a protected metatable" },
    { "getmetatable(require 'hinge'.model()).__gc()", 2, no_field },
    { frame .. "getmetatable(cantilever():static()).__gc()", 2, no_field },
    -- a script that bends what it was given harms itself alone
    { "string.format, table.concat, print, error = nil, nil, nil, nil; string = nil", 0, "" },
    { "require 'hinge.library.check'.fail = function() print 'OUT' end; require 'hinge'.material { E = -1 }", 2,
      "s.lua:1: hinge.material: field 'E' is -1 Pa; must be above 0 Pa" },
    -- files: only a plain name, only in the output folder
    { in_job "job:plot({ series = {} }, '../x.png')", 2,
      "s.lua:1: job:plot: filename is '../x.png'; must be a plain name ending in .png, .svg or .pdf" },
    { in_job "job:plot({ series = {} }, '/tmp/x.png')", 2, "filename is '/tmp/x.png'; must be a plain name" },
    { in_job "job:plot('/tmp', 'x.svg')", 2, { "s.lua:1: job:plot: what is '/tmp'", "reads no files" } },
    { "require 'hinge.library.check'.fail = function() end; require 'hinge'.plot('/tmp', 'x.svg')", 2,
      { "what is '/tmp'", "reads no files" } },
    { "require 'hinge'.import.tcl { file = '/etc/passwd', units = { force = 'N', length = 'm' } }", 2,
      "hinge.import.tcl: a script in the sandbox reads no files" },
    { "require 'hinge'.import.csv { nodes = '/etc/passwd', members = '/etc/passwd' }", 2,
      "hinge.import.csv: a script in the sandbox reads no files" },
    -- no commands to the terminal
    { "error '\\27]0;title\\7'", 2, "?]0;title?" },
    { "require 'hinge'.note '\\27[31mOUT'", 0, "" },
    -- what it has of the library is a copy, at any depth and however it is read
    { "require 'hinge.library.check'.value = function() end; require 'hinge'.plot(" .. series .. ", {})", 2,
      "s.lua:1: hinge.plot: field 'filename' is a table; must be a string" },
    { "for _, f in pairs(require 'hinge.models.ten_storey'.designs) do f.storey_height = 'x' end "
      .. "require 'hinge.models.ten_storey'.add(require 'hinge'.model {}, { bays = { 1, 1 }, storeys = 1 })", 0, "" },
    { "local h = require 'hinge' getmetatable(h).__index = nil", 2, no_field },
    { in_job "job.__index.plot = print", 2, "s.lua:1: attempt to index a nil value (field '__index')" },
    { frame .. "cantilever():static { steps = 1 }:finish():hinges { limit = 0.1 }.__index.write = print", 2,
      "s.lua:13: attempt to index a nil value (field '__index')" },
    { "local h = require 'hinge' local s = h.scenario { run = function() end } s.cases.slow = 'x' "
      .. "assert(not next(h.scenario { run = function() end }.cases))", 0, "" },
    -- names of files are texts without line breaks, whatever stands for them
    { in_job("job.out = setmetatable({}, { __concat = function(a) return setmetatable({ match = function() return "
      .. "'png' end }, getmetatable(a)) end }) job:plot(" .. series .. ", 'x.png')"), 2, "picture's name is no text" },
    { plot_to "job.out .. '/a\\nb'", 2, "goes on with the character number 10; it must not have line breaks" },
    { "local h = require 'hinge' h.cost(h.scenario { run = function() return { v = 1 } end }, { out = './x' })", 2,
      "s.lua:1: hinge.cost: field 'out' is not available to a script in the sandbox" },
    { "require 'hinge'.study(nil, { out = './elsewhere' })", 2,
      "hinge.study is not available to a script in the sandbox" },
    { plot_to "'..'", 2, { "s.lua:1: '../x.png' " .. outside, "a script in the sandbox writes nowhere else" } },
    { plot_to "''", 2, "s.lua:1: 'x.png' " .. outside },
    { plot_to "'/tmp/hinge-out'", 2, "s.lua:1: '/tmp/hinge-out/x.png' " .. outside },
    { plot_to "job.out .. '-2'", 2, outside },
    { plot_to "job.out .. '/../../link'", 2, outside },
    -- what the engine could stumble over
    { frame .. "local run run = cantilever(function() run:step() end):dynamic { dt = 1e-5, duration = 0.1 } "
      .. "run:finish()", 2, "s.lua:13: run:step: called from a function of this very run" },
    { frame .. "cantilever():dynamic { dt = 1e-5, duration = 0.1, threads = 256 }", 1,
      { "cannot start 256 threads: ", "ask for fewer" }, "--memory 64M" },
    -- errors made to stumble over themselves
    { "error(setmetatable({}, { __tostring = function() error 'again' end }))", 2, "" },
    { "error(setmetatable({}, { __metatable = 7 }))", 2, "" },
    { "local t = {} for i = 1, 2 do t[i] = t end return t", 0, "" },
  }
  for _, way in ipairs(ways) do
    local printed = ends(table.unpack(way))
    expect(not printed:find(way[1]:find "31mOUT" and "\27" or "OUT"), "%s came out", way[1])
  end
end)

case("a link in the output folder leads nowhere", function()
  support.run(("mkdir -p %s/linked %s/elsewhere && ln -s ../elsewhere %s/linked/frames"):format(folder, folder, folder))
  support.write(path "s.lua",
    frame .. "return hinge.scenario { run = function(_, job) job:frame(cantilever():static { steps = 1 }:finish()) "
    .. "end }")
  ended(2, "is outside the output folder linked", hinge "--sandbox s.lua --out linked")
  equal(support.output("ls " .. path "elsewhere"), "", "what went through the link")
end)

case("a file that is a link is not followed", function()
  -- Nor does a file that is a link, whichever of the files it has the name of: it is refused, or a file takes its
  -- place. run.json is read first, which the kernel refuses where it leads out.
  support.write(path "s.lua", frame .. [[
return hinge.scenario { run = function(_, job)
  local run = cantilever():dynamic { dt = 1e-5, duration = 1e-4 }
  for step in run:steps() do if step.index == 5 then run:checkpoint(job.out .. "/run.checkpoint") end end
  job:frame(run)
  job:plot(run, "x.svg")
end }]])
  for name, refused in pairs { ["x.svg"] = true, ["run.checkpoint"] = true, ["summary.json"] = false,
    ["history.csv"] = false, ["frames.pvd"] = true } do
    support.run(("cd %s && rm -rf linked && mkdir linked && ln -s ../target linked/%s"):format(folder, name))
    support.write(path "target", "mine")
    local _, complaint = ended(refused and 2 or 0, "", hinge "--sandbox s.lua --out linked")
    equal(complaint:find(("'linked/%s' is outside the output folder linked"):format(name), 1, true) ~= nil, refused,
      name .. " is a link: " .. complaint)
    equal(support.read(path "target"), "mine", "what the link " .. name .. " points to")
  end
  support.run(("cd %s && rm -rf linked && mkdir linked && ln -s ../target linked/run.json"):format(folder))
  support.write(path "target", "mine")
  hinge "--sandbox s.lua --out linked"
  equal(support.read(path "target"), "mine", "what the link run.json points to")
  for _, name in ipairs { "x.png", "../x.png", "out1-2/x.png" } do
    expect(not support.is_there(path(name)), "%s was written", name)
  end
end)

-- Limits --------------------------------------------------------------------------------------------------------------

local instructions = { "hinge: s.lua:", ": the script took more than 1e+06 instructions, the sandbox's limit; "
  .. "--instructions gives it more\n" }
case("limits of time, memory and files end a script with a message", function()
  for _, script in ipairs {
    "print 'said before'\nwhile true do end",
    "while true do pcall(error) end",
    "while true do pcall(function() while true do end end) end",
    "coroutine.wrap(function() coroutine.wrap(function() while true do end end)() end)()",
    "local function f() for i = 1, 1e5 do end return coroutine.wrap(f)() end\n"
      .. "local t = {} for i = 1, 1e9 do t = coroutine.wrap(function() for i = 1, 1e5 do end end) t() end",
    "table.sort({ 1, 2, 3 }, function() while true do end end)",
    "('x'):gsub('x', function() while true do end end)",
    "load(function() while true do end end)",
    frame .. "cantilever(function() while true do end end):dynamic { dt = 1e-5, duration = 1 }:finish()",
    frame .. "for i = 1, 1e9 do cantilever() end",
  } do
    local printed = ends(script, 1, instructions, "--instructions 1e6 --seconds 20")
    if script:find "said" then equal(printed, "said before\n", "what was said before the end") end
  end

  local time = { "hinge: ", "the script took more than 0.3 s, the sandbox's limit", "--seconds gives it more\n" }
  for _, script in ipairs {
    "while true do end",
    "('a'):rep(40):find(('a?'):rep(40) .. ('a'):rep(40))", -- backtracks for ever
    "('x'):rep(1e5):find '.-.-.-.-y'",
    "string.rep('', 1 << 62)",
    "table.move({}, 1, 1 << 62, 2)",
    "table.concat(setmetatable({}, { __index = function() return '' end }), '', 1, 1 << 62)",
    "setmetatable({}, { __gc = function() while true do end end })", -- while the state is closed, without hooks
    "setmetatable({}, { __gc = function() string.rep('', 1 << 62) end }) collectgarbage()",
    frame .. "cantilever():dynamic { dt = 1e-7, duration = 1e4, record = false }:finish()",
    frame .. "pcall(function() cantilever():dynamic { dt = 1e-7, duration = 1e4, record = false }:finish() end)",
  } do
    local begin = os.time()
    ends(script, 1, time, "--seconds 0.3 --instructions 1e15")
    expect(os.time() - begin <= 3, "%s: stopped after %d s", script, os.time() - begin)
  end

  local memory = "hinge: not enough memory; the sandbox's limit is 64M, --memory gives more\n"
  for _, script in ipairs {
    "string.rep('x', 1e9)",
    "local t = {} for i = 1, 1e9 do t[i] = i end",
    "local s = 'x' while true do s = s .. s end",
    "local t = {} for i = 1, 1e6 do t[i] = ('x'):rep(1000) end table.concat(t)",
    "table.concat(setmetatable({}, { __index = function() return ('x'):rep(1e6) end }), '', 1, 1 << 30)",
    "string.format('%s%s', ('x'):rep(2e7), ('x'):rep(2e7))",
    "local t = {} for i = 1, 1e7 do t[i] = coroutine.create(print) end",
    frame .. "local m = hinge.model() m:member { m:node { 0, 0, 0 }, m:node { 1, 0, 0 }, section = bar, "
      .. "material = steel, elements = 1e9 } m:counts()",
    frame .. "local m = hinge.model() while true do m:node { 0, 0, 0 } end",
    frame .. "local m, runs = cantilever(), {} while true do runs[#runs + 1] = m:dynamic { dt = 1e-5, duration = 1 } "
    .. "end",
    "local t = {} for i = 1, 30 do t = { t, t, t, t } end return t",
  } do
    ends(script, 1, memory, "--memory 64M --seconds 30 --instructions 1e10")
  end
end)

case("a script may catch the limit of memory and go on with less", function()
  -- A script may catch it and go on with less; so the limit holds, and without the sandbox
  -- too nothing is lost but the run.
  ends("print(pcall(string.rep, 'x', 1e9)) return { x = 1 }", 0, "false\tnot enough memory\n", "--memory 64M")
  support.write(path "s.lua", "return ('x'):rep(1e9)")
  local _, complaint = ended(1, "", run(("cd %s && ulimit -v 500000 && %s/hinge run s.lua"):format(folder, arg[1])))
  equal(complaint, "hinge: not enough memory\n", "without the sandbox")
end)

case("wrong limits, and limits without the sandbox, are refused", function()
  for options, message in pairs {
    ["--memory 1G"] = "--memory requires --sandbox",
    ["--sandbox --memory x"] = "--memory: ",
    ["--sandbox --memory 1k"] = "--memory: Value 1024 not in range",
    ["--sandbox --seconds 0"] = "--seconds: Value 0 not in range",
    ["--sandbox --instructions -1"] = "--instructions: Value -1 not in range",
  } do ended(2, message, hinge("run s.lua " .. options)) end
end)

checks.done()
