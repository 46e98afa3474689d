-- Ctrl-C and SIGTERM: the first one ends a script's own loop, the rest of a long static run, the cases of a study; what
-- cannot be left is named after a second; the second one ends the program at once. checkpoint_test.lua has the steps of
-- runs.
--
-- Run: lua5.4 tests/script/program/interrupt_test.lua BUILD_FOLDER
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local checks = support.checks "interrupt"
local case, expect, equal = checks.case, checks.expect, checks.equal

local folder = support.temporary_folder()
-- Signals at these times (s) from where it stands in the script.
local function signals(list)
  local parts = { "p=$PPID; (" }
  for _, one in ipairs(list) do parts[#parts + 1] = ("sleep %g; kill -%s $p;"):format(one[1], one[2]) end
  return ("os.execute %q\n"):format(table.concat(parts, " ") .. ") >/dev/null 2>&1 &")
end
local bar = [[
local hinge = require "hinge"
local model = hinge.model()
local a, b = model:node { 0, 0, 0 }, model:node { 1, 0, 0 }
model:fix(a)
model:member { a, b, section = hinge.section.solid { width = 0.1, depth = 0.1 },
  material = hinge.material { E = 1e9, density = 1000 } }
model:load { node = b, force = { 0, 0, -1 } }
]]
-- Runs scripts at the same time, each in a folder of its own; most of their time they wait. Returns by name: status,
-- complaint, folder, and seconds, of all of them. The time is bounded: without an end by the first signal it would be
-- that of `timeout`.
local function run_all(scripts, arguments)
  local list, commands, began = {}, {}, os.time()
  for name, text in pairs(scripts) do
    local own = ("%s/%d"):format(folder, #commands + 1)
    os.execute(("rm -rf '%s' && mkdir '%s'"):format(own, own))
    support.write(own .. "/scene.lua", text)
    commands[#commands + 1] = ("(cd '%s' && timeout -s KILL 60 '%s/hinge' %s >printed 2>complaint </dev/null; "
      .. "echo $? >status) &"):format(own, arg[1], arguments or "run scene.lua --out out")
    list[name] = { folder = own }
  end
  support.run(table.concat(commands, " ") .. " wait")
  for _, one in pairs(list) do
    one.status, one.seconds = tonumber(support.read(one.folder .. "/status")), os.time() - began
    one.complaint = support.read(one.folder .. "/complaint")
  end
  return list
end
local function run(text, arguments)
  local one = run_all({ text }, arguments)[1]
  return one.status, one.complaint, one.seconds, one.folder
end

case("Ctrl-C and SIGTERM end a script's endless loop, wherever it is", function()
  -- A script's own endless loop, before a run, after one, and in a function of the library that calls back.
  local loop = signals { { 0.2, "TERM" } } .. "while true do end"
  local scripts = {
    ["before a run"] = loop .. "\n",
    ["after a run"] = bar .. "model:static { steps = 1 }:finish()\n" .. loop .. "\n",
    ["in a scenario"] = "return require 'hinge'.scenario { run = function()\n" .. loop .. " end }\n",
    ["Ctrl-C"] = signals { { 0.2, "INT" } } .. "while true do end\n",
  }
  for what, ended in pairs(run_all(scripts)) do
    local _, line = scripts[what]:gsub("\n", "")
    equal(ended.status, what == "Ctrl-C" and 130 or 143, what .. ": status; " .. ended.complaint)
    expect(ended.complaint:find(("hinge: scene.lua:%d: interrupted by %s\n"):format(line, what == "Ctrl-C" and what
      or "SIGTERM"), 1, true), "%s: it says %s", what, ended.complaint)
    expect(ended.seconds < 30, "%s: it took %d s", what, ended.seconds)
  end
end)

case("a script that catches the interrupt goes on to its own end", function()
  local status, complaint, _, own = run(signals { { 0.2, "TERM" } } .. "local ok, why = pcall(function() while true do "
    .. "end end)\nreturn { ok = ok, why = why }\n")
  equal(status, 0, "caught: status; " .. complaint)
  local results = support.json(support.read(own .. "/out/summary.json")).results
  expect(results.ok == false and results.why:find "scene.lua:2: interrupted by SIGTERM", "caught: %s", results.why)
end)

case("what cannot be left is named, and the second signal ends it", function()
  local function twice(signal) return signals { { 0.2, signal }, { 1.6, signal } } end -- it is named after 1 s
  local named = {
    ["the call that the script is in, or the coroutine"] = twice "TERM"
      .. "coroutine.wrap(function() while true do end end)()\n",
    ["the step of the run that is under way"] = bar .. "local run = model:dynamic { dt = 1e-5, duration = 1e-3 }\n"
      .. "run:on_step(function() while true do end end)\n" .. twice "INT" .. "run:finish()\n",
    ["a step of the dynamic run"] = bar .. "model:fracture { where = 'all', rule = function() while true do end end }\n"
      .. "local run = model:dynamic { dt = 1e-5, duration = 1e-3 }\n" .. twice "INT" .. "run:finish()\n",
  }
  for what, ended in pairs(run_all(named)) do
    local signal, status = "Ctrl-C", 130
    if what:find "coroutine" then signal, status = "SIGTERM", 143 end
    expect(ended.complaint:find(("hinge: %s: it ends after %s; once more ends it at once\n"):format(signal, what), 1,
      true), "%s: %s", what, ended.complaint)
    equal(ended.status, status, what .. ": status")
  end
end)

-- It is named, and no other one begins.
case("a factorisation of seconds is left", function()
  local frame = ([[
local hinge = require "hinge"
local steel = hinge.material { E = 206e9, nu = 0.3, density = 7850 }
local section = hinge.section.solid { width = 0.3, depth = 0.3 }
local model, at, n = hinge.model(), {}, %d
local function join(a, b) if a then model:member { a, b, section = section, material = steel } end end
for z = 0, n do for x = 0, n do for y = 0, n do
  local function key(i, j, k) return (i * 100 + j) * 100 + k end
  local node = model:node { 5 * x, 5 * y, 3 * z }
  at[key(x, y, z)] = node
  if z == 0 then model:fix(node) else
    join(at[key(x, y, z - 1)], node)
    join(at[key(x - 1, y, z)], node)
    join(at[key(x, y - 1, z)], node)
  end
end end end
model:gravity { 0, 0, -9.81 }
]]):format(11)
  local status, complaint, seconds = run(frame .. signals { { 0.3, "TERM" } }
    .. "for i = 1, 100 do model:static { steps = 10, record = false }:finish() end\n")
  local _, lines = frame:gsub("\n", "")
  equal(status, 143, "a factorisation: status; " .. complaint)
  expect(complaint:find "it ends after a factorisation of the stiffness, of %d+ unknowns; once more ends it at once\n"
    or complaint:find "it ends after a step of the static run; once more" or seconds <= 2, -- on a fast machine
    "a factorisation: what it waits for: %s", complaint)
  expect(complaint:find(("hinge: scene.lua:%d: interrupted by SIGTERM\n"):format(lines + 2), 1, true),
    "a factorisation: it says %s", complaint)
  expect(seconds < 55, "a factorisation: it took %d s", seconds)
end)

case("a study ends with its cases and goes on with --resume", function()
  -- A study: its cases end, also one in an endless loop, and --resume runs them.
  local study = "return require 'hinge'.scenario { parameters = { x = 1, stop = true }, run = function(p)\n"
    .. "if p.stop and p.x == 2 then\n"
    .. "os.execute 'p=$(ps -o ppid= -p $PPID); (sleep 0.3; kill -TERM $p) >/dev/null 2>&1 &'\n"
    .. "while true do end end return { x2 = p.x } end }\n"
  local status, complaint, seconds, own = run(study, "study scene.lua x=1,2,3 -j 1 --out study -q")
  equal(status, 3, "a study: status; " .. complaint)
  expect(complaint:find("hinge: interrupted: waits at most 10 s for 1 case under way; once more ends it at once\n", 1,
    true), "a study: it says %s", complaint)
  expect(seconds < 9, "a study: it took %d s", seconds)
  local journal = support.read(own .. "/study/cases.jsonl") or ""
  expect(journal:find '"number":1,' and not journal:find '"number":2,', "a study: its journal: %s", journal)
  expect((support.read(own .. "/study/cases/00002/output.txt") or ""):find "scene.lua:4: interrupted by SIGTERM",
    "a study: what its case says")
end)

checks.done()
