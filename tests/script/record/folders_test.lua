-- Output folders: one run or study at a time writes to one, whatever ends it; tasks of a job array share one; what a
-- full disk costs; results and parameters with the names of the table's own columns.
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local checks = support.checks "folders"
local case = checks.case
local quote, expect, equal = support.quote, checks.expect, checks.equal
local program = quote(arg[1] .. "/hinge")

local folder = support.temporary_folder()
local function path(name) return folder .. "/" .. name end
local function hinge(words, before, after)
  return support.run(("cd %s; %s %s %s %s"):format(quote(folder), before or "", program, words, after or ""))
end

local cantilever = [[
local hinge = require "hinge"
local function cantilever()
  local model = hinge.model()
  local a, b = model:node { 0, 0, 0 }, model:node { 1, 0, 0 }
  model:fix(a)
  model:member { a, b, section = hinge.section.solid { width = 0.1, depth = 0.1 },
    material = hinge.material { E = 1e9, density = 1000 } }
  model:load { node = b, force = { 0, 0, -1 } }
  return model
end
]]
-- Says that it has begun, and waits until it may go on.
support.write(path "waits.lua", cantilever .. [[
return hinge.scenario { parameters = { wait = 0, x = 1 }, run = function(p)
  local run = cantilever():dynamic { dt = 1e-5, duration = 1e-4, record = 1 }
  for step in run:steps() do
    if step.index == 5 and p.wait > 0 then
      io.open("begun", "w"):close()
      os.execute "for i in $(seq 500); do test -e go && break; sleep 0.02; done"
    end
  end
  return { x2 = p.x ^ 2 }
end }
]])

-- `first` in the background while f runs; then it goes on. Returns its status and what it said.
local function beside(first, f)
  os.execute(("cd %s && rm -f begun go"):format(quote(folder)))
  os.execute(("cd %s && { %s %s >first.txt 2>&1; echo $? >first.status; } & for i in $(seq 500); do "
    .. "test -e %s && break; sleep 0.02; done"):format(quote(folder), program, first, quote(path "begun")))
  expect(support.is_there(path "begun"), "%s did not begin: %s", first, support.read(path "first.txt"))
  f()
  os.execute(("cd %s && touch go; for i in $(seq 500); do test -s first.status && break; sleep 0.02; done")
    :format(quote(folder)))
  local status, said = tonumber(support.read(path "first.status")), support.read(path "first.txt")
  os.remove(path "first.status")
  return status, said
end

local status, _, complaint

-- A call that is refused, as another one writes to a folder.
local function in_use(words, folder_of_it)
  status, _, complaint = hinge(words)
  expect(status == 1 and complaint:find("another run or study writes to " .. folder_of_it .. " (process ", 1, true),
    "%s: %s %s", words, status, complaint)
end

case("a second run into a folder in use is refused and names the first", function()
  local ended, said = beside("run waits.lua wait=1 --out one", function()
    status, _, complaint = hinge "run waits.lua x=2 --out one"
    equal(status, 1, "a second run: status")
    expect(complaint:find "^hinge: another run or study writes to one %(process %d+: [^\n]*hinge run waits%.lua wait=1 "
      .. "%-%-out one%); wait for its end, or give another folder with %-%-out\n$", "a second run: %s", complaint)
    equal(hinge "run waits.lua x=2 --out other", 0, "a run beside it, elsewhere")
    in_use("study waits.lua x=1,2 --out one", "one")
    equal(hinge "report one", 0, "hinge report while a run goes on")
  end)
  equal(ended, 0, "the first run: " .. tostring(said))
  equal(select(2, support.read(path "one/history.csv"):gsub("\n", "")), 12, "its history: a heading, start, ten steps")
  equal(support.json(support.read(path "one/summary.json")).parameters.wait, 1, "its summary")
  equal(support.output("ls -A " .. quote(path "one")):gsub("\n", " "),
    "history.csv report.html run.json summary.json ", "nothing is left of the lock")
  equal(hinge "run waits.lua x=2 --out one", 0, "once it has ended")
end)

case("a killed run does not lock its folder", function()
  beside("run waits.lua wait=1 --out one", function()
    local process = select(3, hinge "run waits.lua --out one"):match "%(process (%d+)"
    expect(process, "no process is named")
    os.execute("kill -9 " .. tostring(process))
    equal(hinge "run waits.lua --out one", 0, "after a kill")
  end)
end)

case("a second study into a folder in use is refused", function()
  -- and --restart does not clear the folder under the first one's feet
  local ended, said = beside("study waits.lua wait=1 x=1,2,3 -j 1 --out many", function()
    for _, more in ipairs { "", "--resume", "--restart", "--case 3", "--collect" } do
      in_use("study waits.lua wait=1 x=1,2,3 --out many " .. more, "many")
    end
    in_use("run waits.lua --out many/cases/00001", "many/cases/00001")
  end)
  equal(ended, 0, "the first study: " .. tostring(said))
  equal(support.output("ls " .. quote(path "many/cases")):gsub("\n", " "), "00001 00002 00003 ", "its cases")
  equal(hinge "study waits.lua wait=1 x=1,2,3 --out many --collect", 0, "--collect once it has ended")
end)

case("tasks of a job array share a folder", function()
  -- --collect goes on beside them; the same case twice is refused, and no whole study comes between
  local ended, said = beside("study waits.lua wait=1 x=1,2,3 --case 1 --out array", function()
    os.execute("touch " .. quote(path "go"))
    equal(hinge "study waits.lua wait=1 x=1,2,3 --case 2-3 --out array", 0, "another task")
  end)
  equal(ended, 0, "the first task: " .. tostring(said))
  ended = beside("study waits.lua wait=1 x=1,2,4 --case 3 --out array", function()
    equal(hinge "study waits.lua wait=1 x=1,2,4 --collect --out array", 0, "--collect beside a task")
    in_use("study waits.lua wait=1 x=1,2,4 --case 3 --out array", "array/cases/00003")
    expect(complaint:find("case 3 wrong: ", 1, true), "a task with the same case: %s", complaint)
    for _, more in ipairs { "--resume", "--restart" } do
      in_use("study waits.lua wait=1 x=1,2,4 --out array " .. more, "array")
    end
  end)
  equal(ended, 0, "the task with a case of its own")
  status = hinge "study waits.lua wait=1 x=1,2,4 --collect --out array"
  equal(status, 0, "collected")
  equal(select(2, support.read(path "array/results.csv"):gsub("completed", "")), 3, "collected: finished cases")
end)

case("a full disk ends a run and a study with a message", function()
  -- without a word of its physics; also with -q
  support.write(path "draws.lua", cantilever .. [[
return hinge.scenario { parameters = { x = 1 }, run = function(p, job)
  local run = cantilever():static { steps = 1 }:finish()
  local x, y = {}, {}
  for i = 1, 5000 do x[i], y[i] = i, math.sin(i) end
  for i = 1, 3 do job:plot({ series = { { x = x, y = y } } }, "plot" .. i .. ".svg") end
  return { factor = run.factor }
end }
]])
  local limit = "trap '' XFSZ; ulimit -f 40;" -- blocks of 512 or 1024 bytes
  status, _, complaint = hinge("run draws.lua -q --out full", limit)
  equal(status, 1, "a full disk: status")
  expect(complaint:find("^hinge: the run failed: not all was written: plot1%.svg: cannot write full/plot1%.dat: "
    .. "[^\n]*; and 2 more\n$"), "a full disk: %s", complaint)
  local s = support.json(support.read(path "full/summary.json") or "{}")
  equal(s.verdict, "failed", "a full disk: verdict")
  equal(#(s.lost or {}), 3, "a full disk: lost")
  equal((s.results or {}).factor, 1, "a full disk: results")
  status = hinge("study draws.lua x=1,2 -q --out full_study", limit)
  equal(status, 1, "a study on a full disk")
  equal(hinge "study draws.lua x=1,2 -q --out full_study --resume", 0, "and once there is room")
  equal(hinge("run draws.lua -q --out room"), 0, "where there is room")
end)

case("standard output that takes nothing ends with a message", function()
  status, _, complaint = hinge("run waits.lua --out room2", "", ">/dev/full")
  expect(status == 1 and complaint:find "cannot write to standard output: No space left on device",
    "stdout is full: %s %s", status, complaint)
end)

case("results and parameters named as the table's own columns are kept apart", function()
  support.write(path "names.lua", [[
local hinge = require "hinge"
return hinge.scenario { parameters = { x = 1, name = "verdict", steps = 1, number = 1 },
  run = function(p) return { [p.name] = p.x, steps2 = 2 * p.steps } end }
]])
  for _, name in ipairs { "verdict", "reason", "number", "case", "steps", "energy_error" } do
    status, _, complaint = hinge(("study names.lua x=1 name=%s --out names-%s"):format(name, name))
    equal(status, 1, name .. ": status")
    expect(complaint:find(("case 1 wrong: names.lua:3: the result '%s' has the name of a column that results.csv has "
      .. "of its own; choose another name than case, energy_error, number, reason, steps, verdict\n"):format(name), 1,
      true), "a result named %s: %s", name, complaint)
    equal(hinge(("run names.lua name=%s --out names"):format(name)), 0, "hinge run with a result named " .. name)
  end
  status, _, complaint = hinge "study names.lua name=x x=1,2 --out same"
  equal(status, 0, "a result that is a parameter which varies: " .. complaint)
  equal(support.read(path "same/results.csv"):match "^[^\n]*", "number,name,x,verdict,steps2,energy_error,steps,reason",
    "its columns")
  status, _, complaint = hinge "study names.lua x=1,2 steps=3,4 name=y --out steps"
  equal(support.read(path "steps/results.csv"):match "^[^\n]*",
    "number,x,steps,name,verdict,steps2,y,energy_error,run.steps,reason", "a parameter named steps")
  status, _, complaint = hinge "study names.lua number=1,2 --out number"
  expect(status == 2 and complaint:find("a study cannot vary a parameter named 'number'", 1, true),
    "a parameter named number: %s %s", status, complaint)
  expect(not support.is_there(path "number"), "a parameter named number: a folder was made")
  support.write(path "other.lua", (support.read(path "names.lua"):gsub("= p.x, ", "= p.x + 1, ")))
  status, _, complaint = hinge "study other.lua name=x x=1,2 --out other_study"
  expect(status == 1 and complaint:find("the result 'x' is 2, and the study varies a parameter of that name, which is "
    .. "1", 1, true), "a result that is not the parameter of that name: %s", complaint)
end)

checks.done()
