-- hinge study and hinge.study: the cases of a study, what it writes, what a sick case costs, how it goes on after an
-- end.
--
-- Run: lua5.4 tests/script/study/study_test.lua BUILD_FOLDER
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local hinge = require "hinge"
local draws = require "hinge.study.draws"
local fit = require "hinge.study.fit"
local checks = support.checks "study"
local case = checks.case
local quote, expect, equal, near = support.quote, checks.expect, checks.equal, checks.near
local program = quote(arg[1] .. "/hinge")

local folder = support.temporary_folder()
support.write(folder .. "/bar.lua", [[
return function(p)
  local hinge = require "hinge"
  local steel = hinge.material { E = 206e9, nu = 0.3, density = 7850 }
  local model = hinge.model { displacement = "small" }
  local wall, tip = model:node { 0, 0, 0 }, model:node { p.length, 0, 0 }
  model:fix(wall, "all")
  model:member { wall, tip, section = hinge.section.solid { width = 0.05, depth = 0.05 }, material = steel }
  model:load { node = tip, force = { 0, 0, -p.load } }
  local run = model:static { steps = 1 }:finish()
  local uz = select(3, run:displacement(tip))
  return { tip = { mm = -1000 * uz }, down = -uz > 0.01, list = { 1, 2 } }
end
]])
support.write(folder .. "/s.lua", [[
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local hinge = require "hinge"
return hinge.scenario {
  parameters = { load = 1000, length = 1, sick = "", wait = 0 },
  cases = { long = { length = 2 }, short = { length = 0.5 } },
  proposals = { half = function(cases)
    local low, high = 0, 10000
    for _, c in ipairs(cases) do
      if c.results.down then high = c.parameters.load else low = c.parameters.load end
    end
    if high - low > 100 then return { load = 0.5 * (low + high) } end
  end },
  run = function(p)
    if p.sick == "crash" then os.execute "kill -SEGV $PPID" end
    if p.sick == "hang" then while true do end end
    if p.sick == "memory" then local t = {} for i = 1, 1e9 do t[i] = { i } end end
    if p.sick == "wrong" then error "no such thing" end
    local until_then = os.clock() + p.wait
    while os.clock() < until_then do end
    return require "bar" (p)
  end,
}
]])

local function study(words, before)
  return support.run(("cd %s && %s %s study %s"):format(folder, before or "", program, words))
end
local function results(name)
  local rows, names = {}, nil
  for line in (support.read(folder .. "/" .. name .. "/results.csv") or ""):gmatch "[^\n]+" do
    local items = {}
    for item in (line .. ","):gmatch "([^,]*)," do items[#items + 1] = item end
    if not names then names = items else
      local row = {}
      for i, key in ipairs(names) do row[key] = items[i] end
      rows[#rows + 1] = row
    end
  end
  return rows, names
end
local function tip(load, length) -- P L^3 / 3 E I + P L / k G A, mm
  local I, A, G = 0.05 ^ 4 / 12, 0.05 ^ 2, 206e9 / 2.6
  return 1000 * load * (length ^ 3 / (3 * 206e9 * I) + length / (5 / 6 * G * A))
end
local function written(name) -- when each case's own summary was written
  return support.output(("cd %s/%s/cases && stat -c '%%n %%y' */summary.json 2>/dev/null"):format(folder, name))
end

-- The product of all values, the first one slowest; a row a case; the numbers of the script itself.
local made, told, wrong = study "s.lua load=1000,2000 length=1:2:0.5 --cases long,short -j 2 --out a"
case("a study has a row a case for the product of all values, its plots, and each case's own files", function()
  equal(made, 0, "exit made: " .. wrong)
  local rows, names = results "a"
  equal(table.concat(names, " "), "number case load length verdict down tip.mm energy_error steps reason", "columns")
  equal(#rows, 12, "cases")
  for i, row in ipairs(rows) do
    equal(tonumber(row.number), i, "order")
    equal(row.case, i <= 6 and "long" or "short", "case of row " .. i)
    equal(tonumber(row.load), (i - 1) // 3 % 2 == 0 and 1000 or 2000, "load of row " .. i)
    equal(tonumber(row.length), 1 + 0.5 * ((i - 1) % 3), "length of row " .. i)
    near(tonumber(row["tip.mm"]) / tip(tonumber(row.load), tonumber(row.length)), 1, 1e-9, "tip of row " .. i)
    equal(row.verdict, "completed", "verdict of row " .. i)
  end
  expect(told:find "12 cases: 12 completed", "the last lines: %s", told)
  local summary = support.json(support.read(folder .. "/a/summary.json"))
  equal(summary.verdicts.completed, 12, "summary.json: verdicts")
  for _, name in ipairs { "tip.mm-load.png", "tip.mm-length.png" } do
    expect((support.read(folder .. "/a/" .. name) or ""):find "^\137PNG", "there is no %s", name)
  end
  equal(support.json(support.read(folder .. "/a/cases/00005/summary.json")).parameters.length, 1.5,
    "a case's own folder")
end)

-- What identifies a case are the files that it reads, and none that the study writes.
local function files_of(name)
  local last, read = nil, {}
  for line in (support.read(folder .. "/" .. name .. "/cases.jsonl") or ""):gmatch "[^\n]+" do last = line end
  for i, one in ipairs(last and support.json(last).files or {}) do read[i] = one[1]:match "[^/]*$" end
  return table.concat(read, " ")
end
case("a case is known by the files that it reads; one process and eight write the same files", function()
  equal(files_of "a", "bar.lua s.lua", "files of the last case")

  -- One process at a time, or eight: the same files, byte for byte.
  study "s.lua load=1000,2000 length=1:2:0.5 --cases long,short -j 1 --out b"
  study "s.lua load=1000,2000 length=1:2:0.5 --cases long,short -j 8 --out c"
  for _, name in ipairs { "results.csv", "summary.json" } do
    checks.same_files(folder .. "/b/" .. name, folder .. "/c/" .. name, "one process and eight")
  end
end)

case("a case that crashes, hangs, takes too much memory or is wrong costs itself alone", function()
  -- A case that crashes, hangs, takes too much memory or is wrong costs itself.
  local status = study "s.lua sick=fine,crash,hang,memory,wrong,well --timeout 3s --memory 100M -j 3 --out sick"
  equal(status, 1, "exit status with sick cases")
  local verdicts = {}
  for _, row in ipairs(results "sick") do verdicts[#verdicts + 1] = row.verdict end
  equal(table.concat(verdicts, ", "), "completed, crashed, timed out, out of memory, wrong, completed", "verdicts")
  expect((results "sick")[5].reason:find "no such thing", "reason: %s", (results "sick")[5].reason)
end)

case("a second study is refused without --resume, which runs the cases without an answer alone", function()
  -- A second study does not take the place of the first by mistake. --resume runs what has no answer, and no more.
  local status, printed, complaint = study "s.lua sick=fine,crash,hang,memory,wrong,well --out sick"
  equal(printed, "", "what is printed where nothing runs")
  equal(status, 2, "exit status without --resume")
  expect(complaint:find "holds 6 cases of a study; %-%-resume", "message: %s", complaint)
  local before = written "sick"
  equal(select(2, before:gsub("\n", "")), 2, "cases with a summary")
  study "s.lua sick=fine,crash,hang,memory,wrong,well --timeout 3s --memory 100M -j 3 --out sick --resume"
  equal(written "sick", before, "finished cases, which are kept")
end)

case("cases run again when a module has changed, and count no older answer", function()
  -- A module that has changed is noticed: its cases run again.
  support.write(folder .. "/bar.lua", (support.read(folder .. "/bar.lua"):gsub("%-1000 %* uz }", "-2000 * uz }")))
  local status, printed, complaint = study "s.lua load=1000,2000 length=1:2:0.5 --cases long,short --out b --resume"
  expect(printed:find "12 cases: 12 completed", "the last lines after a change: %s", printed)
  equal(status, 0, "exit status after a change")
  expect(complaint:find "bar%.lua has changed: 12 cases run again", "message: %s", complaint)
  near(tonumber((results "b")[1]["tip.mm"]) / tip(1000, 1), 2, 1e-9, "the changed module's answer")
  -- One that now ends the process: what the case has answered before does not count.
  local bar = support.read(folder .. "/bar.lua")
  support.write(folder .. "/bar.lua", "return function() os.exit(0) end")
  study "s.lua load=1000,2000 length=1:2:0.5 --cases long,short --out c --resume"
  for i, row in ipairs(results "c") do
    equal(row.verdict .. (row["tip.mm"] or ""), "wrong", "a case without an answer, row " .. i)
  end
  support.write(folder .. "/bar.lua", bar)
end)

case("a killed study keeps what was finished and goes on, with a cut journal too", function()
  local status
  -- kill -9 of the runner: its workers end with it, and all that was finished is kept.
  for round = 1, 3 do
    local name = "killed" .. round
    study(("s.lua load=1:40:1 wait=0.02 -j 4 --out %s"):format(name), ("timeout -s KILL %g"):format(0.12 + 0.1 * round))
    local workers
    for _ = 1, 20 do -- the system takes a moment to end them
      workers = tonumber((support.output("pgrep -f '[s]tudy s.lua load=1:40:1' | wc -l")))
      if workers == 0 then break end
      os.execute "sleep 0.1"
    end
    equal(workers, 0, "workers left after a kill")
    local journal = support.read(folder .. "/" .. name .. "/cases.jsonl") or ""
    local _, kept = journal:gsub("\n", "\n")
    local old = written(name)
    status = study(("s.lua load=1:40:1 wait=0.02 -j 4 --out %s --resume"):format(name))
    equal(status, 0, "exit status of --resume after a kill")
    equal(#results(name), 40, "cases after --resume")
    local new, same = written(name), 0
    for line in old:gmatch "[^\n]+" do if new:find(line, 1, true) then same = same + 1 end end
    expect(same >= kept, "%d cases were finished before the kill, %d were kept", kept, same)
  end
  -- A journal whose last line was cut off, as a full disk leaves it.
  local killed = folder .. "/killed1/cases.jsonl"
  support.write(killed, support.read(killed):sub(1, -20))
  status = study "s.lua load=1:40:1 wait=0.02 -j 4 --out killed1 --resume"
  equal(status, 0, "exit status with a cut journal")
  equal(#results "killed1", 40, "cases with a cut journal")
end)

case("a case that has an answer keeps it, whatever a later try says", function()
  -- A case that has an answer keeps it, whatever a later try says, such as that of another task of a cluster.
  local journal, there = require "hinge.study.journal", folder .. "/tries"
  local function last_of(...)
    os.execute("rm -rf " .. quote(there) .. " && mkdir " .. quote(there))
    for i, verdict in ipairs { ... } do
      journal.add(there, i < 3 and "cases.jsonl" or "cases-2.jsonl", { id = "x", verdict = verdict, try = i })
    end
    local entry = journal.read(there).x or {}
    return entry.verdict, entry.try
  end
  for tries, wanted in pairs {
    ["completed, timed out"] = 1, ["timed out, completed"] = 2, ["timed out, crashed"] = 2, ["completed, stopped"] = 2,
    ["completed, timed out, crashed"] = 1, ["crashed, timed out, completed"] = 3,
  } do
    local list = {}
    for verdict in tries:gmatch "[^,]+" do list[#list + 1] = verdict:match "^ ?(.*)$" end
    local verdict, try = last_of(table.unpack(list))
    equal(try, wanted, tries .. ": the entry that counts")
    equal(verdict, list[wanted], tries .. ": its verdict")
  end
end)

case("a study varies what the scenario itself varies, unless it is told otherwise", function()
  -- What the scenario itself varies, where the study says nothing else.
  support.write(folder .. "/own.lua", [[
local hinge = require "hinge"
return hinge.scenario { parameters = { x = 1, y = 1, z = 1 }, vary = { x = { 1, 2 }, y = "choice(5,7)" },
  run = function(p) return { sum = p.x + p.y + p.z } end }
]])
  local status = study "own.lua --samples 4 --method sobol --out own"
  equal(status, 0, "exit status of a study of what the scenario varies")
  local rows = results "own"
  equal(#rows, 8, "cases of what the scenario varies")
  local sum = 0
  for _, row in ipairs(rows) do sum = sum + tonumber(row.sum) end
  equal(sum, 4 * (1 + 2) + 4 * (5 + 7) + 8, "sums of what the scenario varies")
  status = study "own.lua x=3 y=4 z=5:7:1 --out own2"
  equal(status, 0, "exit status with other values")
  equal(#results "own2", 3, "the study's own values come first")
  support.write(folder .. "/own.csv", "x,y\n8,9\n10,11\n")
  status = study "own.lua --table own.csv --out own5"
  equal(status, 0, "exit status with a table")
  equal(#results "own5", 2, "what a table names is not drawn")
  local own = hinge.scenario { parameters = { x = 1 }, vary = { x = { 1, 2, 3 } },
    run = function(p) return { x = p.x } end }
  equal(#hinge.study(own, { out = folder .. "/own3", pictures = false }).cases, 3, "hinge.study of what it varies")
  equal(#hinge.study(own, { vary = { x = 1 }, out = folder .. "/own4", pictures = false }).cases, 1, "other values")
  local good, said = pcall(hinge.scenario, { parameters = { x = 1 }, vary = { y = { 1 } }, run = print })
  expect(not good and tostring(said):find("vary: unknown parameter 'y'", 1, true), "vary of no parameter: %s", said)
end)

case("--propose asks the scenario for the next case until it has none", function()
  -- Proposals: each asked with what has ended. The tip comes down by 10 mm at 10 / tip(1, 1) N (here twice as much).
  support.write(folder .. "/bar.lua", (support.read(folder .. "/bar.lua"):gsub("%-1000 %* uz }", "-2000 * uz }")))
  local status = study "s.lua --propose half --out half"
  equal(status, 0, "exit status of proposals")
  local rows = results "half"
  near(tonumber(rows[#rows].load), 10 / tip(1, 1), 100, "load at which the bar is down")
end)

case("a proposal of the same parameters again is refused", function()
  -- One that proposes the same again would never end: it is told of.
  local again = hinge.scenario { parameters = { x = 1 }, run = function(p) return { x = p.x } end }
  local good, said = pcall(hinge.study, again, { propose = function() return { x = 2 } end, out = folder .. "/again" })
  expect(not good and tostring(said):find "returned the parameters of case 1 again", "the same again: %s", said)
end)

case("with proposals a single value holds for all cases, and more than one is refused", function()
  -- With proposals a single value holds for all cases; what would ask for cases of its own is an error, at the line.
  local asked = hinge.scenario { parameters = { x = 1, y = 1 }, cases = { all = {} }, run = function(p)
    return { sum = p.x + p.y }
  end }
  local function propose(cases) if #cases < 2 then return { x = #cases + 1 } end end
  local found = hinge.study(asked, { vary = { y = 10 }, propose = propose, out = folder .. "/fixed", pictures = false })
  equal(#found.cases == 2 and found.cases[2].results.sum, 12, "a value that holds for all cases")
  equal(table.concat(found.varied, " "), "x", "what varies")
  for wanted, options in pairs {
    ["y has several values; the function proposes them"] = { vary = { y = { 1, 2 } } },
    ["x has several values; the function proposes them"] = { vary = { x = "normal(1,2)" } },
    ["cases has no effect; the function proposes the cases"] = { cases = { "all" } },
    ["samples has no effect; the function proposes the cases"] = { samples = 3 },
    ["table has no effect; the function proposes the cases"] = { table = folder .. "/p.csv" },
  } do
    support.write(folder .. "/p.csv", "x\n1\n")
    options.propose, options.out = propose, folder .. "/refused"
    local line = debug.getinfo(1, "l").currentline + 1
    local taken, why = pcall(hinge.study, asked, options)
    equal(not taken and tostring(why):match "study_test%.lua:(.*)", line .. ": hinge.study: propose: " .. wanted,
      wanted)
    expect(not support.is_there(folder .. "/refused"), "%s: a folder was made", wanted)
  end
end)

case("--table takes the cases from the rows of a CSV file", function()
  -- Rows of a table.
  support.write(folder .. "/t.csv", "load,length\n1000,1\n3000,\"2\"\r\n\n# a remark\n500,0.5\n")
  study "s.lua --table t.csv --out table"
  local rows = results "table"
  equal(#rows, 3, "rows of the table")
  equal(rows[2].length .. " " .. rows[3].load, "2 500", "values of the table")
  support.write(folder .. "/empty.csv", "sick,load,wait\n,1000,0\nfine , 2000,\n")
  equal(study "s.lua --table empty.csv --out empty", 2, "exit status where a number is missing in the table")
  support.write(folder .. "/empty.csv", "load,sick\n1000,\n2000 , fine \n")
  equal(study "s.lua --table empty.csv --out empty", 0, "exit status where a text of the table is empty")
  rows = results "empty"
  equal(rows[1].sick .. "|" .. rows[2].sick .. "|" .. rows[2].load, "|fine|2000", "values of a table with an empty one")
end)

case("wrong arguments of hinge study are refused before anything runs", function()
  local status, printed, complaint
  -- Wrong input is refused before anything runs.
  for words, message in pairs {
    ["s.lua laod=3"] = "unknown parameter 'laod' %(did you mean 'load'%?%)",
    ["s.lua load=1:2"] = "must be a number",
    ["s.lua load=1:2:-1"] = "no value lies between",
    ["s.lua load~norml(1,2)"] = "did you mean 'normal'",
    ["s.lua load~normal(1)"] = "normal takes mean, standard deviation",
    ["s.lua load=1 load=2"] = "load is given twice",
    ["s.lua --cases thin"] = "unknown case 'thin'",
    ["s.lua load=1 --samples 3"] = "nothing is drawn",
    ["s.lua load=1 --timeout soon"] = "must be a time above 0",
    ["s.lua --table none.csv"] = "none.csv",
    ["s.lua --propose none"] = "unknown proposal 'none'",
    ["s.lua --propose half load=1,2"] = "load has several values; the function proposes them",
    ["s.lua --propose half --samples 3"] = "%-%-samples has no effect; the function proposes the cases",
  } do
    status, printed, complaint = study((words:gsub("[~()]", "\\%0")) .. " --out wrong")
    equal(printed, "", words .. ": what is printed")
    equal(status, 2, words .. ": exit status")
    expect(complaint:find(message), "%s: message: %s", words, complaint)
    expect(not support.is_there(folder .. "/wrong"), "%s: a folder was made", words)
  end
end)

case("a case whose script of plain statements does not read a setting is wrong", function()
  -- A script of plain statements that does not read a setting: its case says so.
  support.write(folder .. "/unread.lua", "local p = ...\nlocal q = p\nreturn { a = q.y or 2 }")
  equal(study "unread.lua x=1 --out unread", 1, "exit status where a setting is not read")
  expect((results "unread")[1].verdict == "wrong" and (results "unread")[1].reason:find "reads no parameter 'x'",
    "a setting that is not read: %s", (results "unread")[1].reason)
end)

-- From Lua, with functions that no file holds: the same numbers.
local slope = 3
local scenario = hinge.scenario { parameters = { x = 1, y = 1 }, run = function(p)
  return { z = slope * p.x + p.y, above = slope * p.x + p.y > 10 }
end }
case("hinge.study varies functions that no file holds", function()
  local result = hinge.study(scenario, { vary = { x = { 1, 2, 3 }, y = { from = 0, to = 10, by = 5 } },
    out = folder .. "/lua", jobs = 3, pictures = false })
  equal(#result.cases, 9, "cases of hinge.study")
  for _, c in ipairs(result.cases) do
    equal(c.results.z, 3 * c.parameters.x + c.parameters.y, "result of case " .. c.number)
    equal(c.results.above, c.results.z > 10, "truth of case " .. c.number)
  end
end)

case("a case finds the modules of hinge loaded that those before it have used, and nothing else of them", function()
  local asked = hinge.scenario { parameters = { n = 1 }, run = function(p)
    local was = package.loaded["hinge.sections.named"] ~= nil
    local section = hinge.section.named "HEB 300"
    local first = rawget(_G, "seen") == nil
    rawset(_G, "seen", p.n)
    return { was = was, first = first, area = section.area }
  end }
  local now = hinge.study(asked, { vary = { n = { 1, 2, 3 } }, jobs = 1, out = folder .. "/loaded",
    pictures = false })
  for i, one in ipairs(now.cases) do
    equal(one.results.was, i > 1, ("case %d: whether the module was there"):format(i))
    equal(one.results.first, true, ("case %d: whether its globals are its own"):format(i))
    near(one.results.area, 149.1e-4, 1e-5, ("case %d: area"):format(i))
  end
  equal(#now.cases, 3, "cases")
end)

case("a failed case is in the table and in no plot, correlation or note", function()
  -- A case that failed may have returned something: it is in the table, and in nothing that is drawn from all cases.
  local failing = hinge.scenario { parameters = { x = 1, y = 1 }, run = function(p, job)
    job:verdict(p.x == 1 and "failed" or "completed", "it fell over")
    return { z = p.x == 1 and -1000 or p.x + p.y, above = p.x == 1 or p.x + 2 * p.y > 12 }
  end }
  local result = hinge.study(failing, { vary = { x = { 1, 2, 3, 4, 5, 6 }, y = { 1, 2, 3, 4, 5 } },
    out = folder .. "/failing" })
  equal(result.cases[1].verdict .. " " .. result.cases[1].results.z, "failed -1000", "a case that failed")
  for _, one in ipairs(result.correlations) do
    equal(one.cases, 25, "cases that have an answer, for " .. one.parameter)
  end
  near(result.correlations[#result.correlations - 1].correlation, result.correlations[#result.correlations].correlation,
    1e-9, "correlation of a sum with its parts")
  expect(table.concat(result.notes, ";"):find "5 cases without an answer left out", "notes: %s",
    table.concat(result.notes, "; "))
end)

case("a study within a run has a summary.json of its own", function()
  -- A study within a run leaves the run its folder: each has a summary.json of its own.
  support.write(folder .. "/within.lua", [[
local hinge = require "hinge"
local scenario = hinge.scenario { parameters = { x = 1 }, run = function(p) return { twice = 2 * p.x } end }
return hinge.scenario { parameters = { n = 2 }, run = function(p, job)
  local found = hinge.study(scenario, { vary = { x = { 1, 2, 3 } }, out = job.out .. "/runs", pictures = false })
  return { sum = p.n * found.cases[3].results.twice }
end }
]])
  for words, at in pairs { ["run within.lua --out within"] = "within", ["study within.lua n=2,3 -q --out outer"]
      = "outer/cases/00001" } do
    local code, _, why = support.run(("cd %s && %s %s"):format(folder, program, words))
    equal(code, 0, words .. ": exit status: " .. why)
    for path, wanted in pairs { [at] = "results", [at .. "/runs"] = "verdicts" } do
      local text = support.read(("%s/%s/summary.json"):format(folder, path))
      expect(text and support.json(text)[wanted], "%s: %s/summary.json holds no %s", words, path, wanted)
    end
  end
end)

case("hinge.study goes in plain Lua after a run with two threads, and refuses unknown parameters", function()
  -- Plain Lua, where a run has had two threads and a module is there before the study begins.
  support.write(folder .. "/plain.lua", [[
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local hinge, post = require "hinge", require "post"
local first = post(1)
local scenario = hinge.scenario { parameters = { speed = 1 }, run = function(p)
  local hash = first.hash
  first = nil
  collectgarbage()
  return { same = post(p.speed).hash == hash }
end }
local study = hinge.study(scenario, { vary = { speed = { 1, 2 } }, out = "plain", timeout = 60, pictures = false })
for _, c in ipairs(study.cases) do print(c.verdict, c.results.same) end
]])
  support.write(folder .. "/post.lua", [[
local hinge = require "hinge"
return function(speed)
  local model, below = hinge.model {}, nil
  for k = 0, 300 do
    local node = model:node { 0, 0, k }
    if below then
      model:member { below, node, section = hinge.section.solid { width = 0.5, depth = 0.5 },
        material = hinge.material { E = 206e9, density = 7850 } }
    else
      model:fix(node, "all")
    end
    below = node
  end
  model:velocity(below, { speed, 0, 0 })
  return model:dynamic { dt = 1e-4, duration = 2e-3, threads = 2 }:finish()
end
]])
  local status, printed, complaint = support.run(("cd %s && LUA_CPATH=%s/?.so lua5.4 plain.lua"):format(folder,
    quote(arg[1])))
  equal(status, 0, "exit status in plain Lua: " .. complaint)
  equal(printed, "completed\ttrue\ncompleted\tfalse\n", "plain Lua, with threads")
  equal(files_of "plain", "plain.lua post.lua", "files of the last case in plain Lua")
  expect(not pcall(hinge.study, scenario, { vary = { w = { 1 } }, out = folder .. "/no" }),
    "an unknown parameter is taken")
  expect(not pcall(hinge.study, {}, {}), "something else than a scenario is taken")
end)

case("draws fill strata as they should, and distributions have their quantiles", function()
  -- Draws: of each stratum of a Latin hypercube one; Sobol's points fill each half, quarter and eighth alike;
  -- quantiles.
  for d = 1, 3 do
    local seen = {}
    for _, point in ipairs(draws.points("lhs", 3, 64, 7)) do seen[math.floor(64 * point[d])] = true end
    local n = 0
    for _ in pairs(seen) do n = n + 1 end
    equal(n, 64, "strata of a Latin hypercube, dimension " .. d)
  end
  for d = 1, 21 do
    local count = {}
    for _, point in ipairs(draws.points("sobol", 21, 64, 7)) do
      local cell = math.floor(8 * point[d])
      count[cell] = (count[cell] or 0) + 1
    end
    for cell = 0, 7 do equal(count[cell], 8, ("Sobol's points in cell %d of dimension %d"):format(cell, d)) end
  end
  for a = 1, 5 do -- pairs of dimensions: a net of four by four
    local count = {}
    for _, point in ipairs(draws.points("sobol", 6, 256, 7)) do
      local cell = math.floor(4 * point[a]) * 4 + math.floor(4 * point[a + 1])
      count[cell] = (count[cell] or 0) + 1
    end
    for cell = 0, 15 do
      equal(count[cell], 16, ("Sobol's points in cell %d of dimensions %d and %d"):format(cell, a, a + 1))
    end
  end
  expect(draws.points("plain", 1, 1, 1)[1][1] ~= draws.points("plain", 1, 1, 2)[1][1], "seeds give the same draws")
  near(draws.normal_quantile(0.975), 1.959963984540054, 1e-12, "normal distribution, 97.5 %")
  near(draws.normal_quantile(1e-6), -4.753424308822899, 1e-11, "normal distribution, 1e-6")
  local quantile = draws.distribution("lognormal(100,0.5)", "test").quantile
  near(quantile(0.5), 100, 1e-9, "median of a lognormal distribution")
  near(draws.distribution("weibull(10,2)", "test").quantile(1 - math.exp(-1)), 10, 1e-9,
    "a Weibull distribution's scale")
  local picked = {}
  for i = 0, 99 do
    local value = draws.distribution("choice(gap, 2, surface, gap)", "test").quantile((i + 0.5) / 100)
    picked[value] = (picked[value] or 0) + 1
  end
  equal(("%d %d %d"):format(picked.gap or 0, picked[2] or 0, picked.surface or 0), "50 25 25", "values of a choice")
  for _, text in ipairs { "choice(gap)", "choice(a,,b)", "choice()" } do
    local ok, message = pcall(draws.distribution, text, "contact")
    expect(not ok and message:find("choice", 1, true), "%s: %s", text, tostring(message))
  end
  near(draws.distribution("triangular(0,1,2)", "test").quantile(0.125), 0.5, 1e-12, "a triangular distribution")
end)

case("a fragility curve that cases were drawn from is found again, within its band", function()
  -- A fragility curve that the cases were drawn from is found again; its band holds it.
  local random, x, y = draws.generator(3), {}, {}
  for i = 1, 4000 do
    x[i] = 50 + 100 * random.part()
    y[i] = random.part() < draws.normal_part(math.log(x[i] / 100) / 0.2) and 1 or 0
  end
  local curve = fit.fragility(x, y, true)
  near(curve.median, 100, 1.5, "median of a fragility curve")
  near(curve.dispersion, 0.2, 0.015, "dispersion of a fragility curve")
  local at, low, high = curve.at(90)
  expect(low < at and at < high and high - low < 0.06, "band %g to %g around %g", low, high, at)
  expect(fit.fragility({ 1, 2, 3 }, { 1, 1, 1 }) == nil, "a curve without a change")
  expect(fit.fragility({ 1, 2, 3, 4 }, { 0, 0, 1, 1 }) == nil, "a curve of a step")
  near(fit.rank_correlation({ 1, 2, 3, 4 }, { 10, 30, 20, 40 }), 0.8, 1e-12, "rank correlation")
  equal(fit.rank_correlation({ 1, 1 }, { 1, 2 }), nil, "rank correlation with what does not vary")
end)

checks.done()
