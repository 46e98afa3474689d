-- What runs all the long jobs notices one that fails, and goes on: with jobs made for this test, each a second or less.
--
-- Run: lua5.4 tests/script/tree/everything_test.lua BUILD_FOLDER
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local checks = support.checks "everything"
local case, ended = checks.case, checks.ended
local quote, expect, equal = support.quote, checks.expect, checks.equal
local folder = support.temporary_folder()

local everything = "lua5.4 " .. quote(support.root .. "tests/everything.lua") .. " "
local in_folder, in_build = everything .. quote(folder) .. " ", everything .. quote(arg[1]) .. " "

-- Runs jobs, given as the source of a list. Returns the status, what was printed, and the rows of the table by job.
local function run(jobs, options)
  support.write(folder .. "/jobs.lua", "return {\n" .. jobs .. "\n}")
  local command = in_folder .. "jobs=" .. quote(folder .. "/jobs.lua") .. " " .. (options or "")
  local status, printed, complaint = support.run(command)
  local rows = {}
  for line in (printed:match "\njob +verdict +seconds +reason\n(.*)$" or ""):gmatch "[^\n]+" do
    local name, verdict, reason = line:match "^(%S+)  +(%a[%a ]-%a) +%d+ *(.*)$"
    if name then rows[name] = { verdict = verdict, reason = reason } end
  end
  return status, printed, rows, complaint
end
local function row(rows, name, verdict, reason, what)
  local r = rows[name] or { verdict = "no row", reason = "" }
  equal(r.verdict, verdict, ("%s: verdict of %s"):format(what, name))
  expect(support.says(r.reason, reason), "%s: reason of %s: %s", what, name, r.reason)
end

local good = [[{ name = "good", command = "echo fine; echo note: one of two; touch @/made" },]]

-- All pass.
local status, printed, rows = run(good .. [[ { name = "other", command = "true" },]])
case("jobs that pass give status 0 and a table", function()
  equal(status, 0, "status of two that pass; " .. printed)
  row(rows, "good", "passed", "one of two", "all pass")
  row(rows, "other", "passed", "", "all pass")
  expect(printed:find("[1 of 2, 0 s so far] good\n[2 of 2, ", 1, true), "progress: %s", printed)
  expect(printed:find "\nall 2 passed, %d+ s\n$", "the last line: %s", printed)
  expect(support.is_there(folder .. "/everything/good/made"), "@ is the job's own folder")
  equal(support.read(folder .. "/everything/good/log.txt"), "fine\nnote: one of two\n", "what a job printed is kept")
end)

-- Each way to fail is noticed, and what comes after it runs.
local function leaves(summary, look) -- status 0, and a summary.json that says otherwise
  return ("command = [[echo '%s' >@/summary.json]], look = '%s'"):format(summary, look)
end
case("each way to fail is noticed and what comes after it runs", function()
  local ways = {
    { "command = [[echo much; echo 'hinge: this is why' >&2; echo more; exit 1]]", "status 1: hinge: this is why" },
    { "command = [[echo note: aside; echo 'hinge: no'; exit 1]]", "status 1: hinge: no (aside)" },
    { "command = [[echo the rule is broken 3 times; exit 1]]", "status 1: the rule is broken 3 times" },
    { "command = [[echo last words; exit 7]]", "status 7: last words" },
    { "command = [[exit 2]]", "status 2: it printed nothing" },
    { "command = [[no_such_program_at_all]]", "status 127: ...not found" },
    { "command = [[kill -9 $$]]", "signal 9: it printed nothing" },
    { "command = [[lua5.4 -e 'error [=[a slip]=]']]", "status 1: lua5.4: ...a slip" },
    { ("command = [[%s run nowhere.lua]]"):format(quote(arg[1] .. "/hinge")), "status 2: hinge: ...nowhere.lua" },
    { "command = [[echo 'note: fig9.png not drawn: no display']]", "note: fig9.png not drawn: no display" },
    { "command = [[true]], look = 'completed'", "no summary.json, or one that cannot be read" },
    { leaves('{"verdict": ', "completed"), "no summary.json, or one that cannot be read" },
    { leaves('{"verdict": "stopped", "reason": "enough"}', "completed"), "verdict stopped: enough" },
    { leaves('{"failed": [{"failed": "gone"}], "references": [1, 2]}', "compared"),
      "1 settings without an answer, one of them: gone" },
    { leaves('{"left_out": [1, 2]}', "compared"), "2 settings were left out" },
    { leaves('{"references": [1], "notes": ["why"]}', "compared"), "there are no two references: why" },
    { leaves('{"references": [1, 2], "quantities": {"a": {"state": "chaotic"}}}', "compared"),
    "no answer has an error" },
    { leaves('{"effects": []}', "compared"), "no effect was left out" },
  }
  for _, way in ipairs(ways) do
    status, printed, rows = run(("{ name = 'bad', %s }, %s"):format(way[1], good))
    equal(status, 1, "status: " .. way[1])
    row(rows, "bad", "FAILED", way[2], way[1])
    row(rows, "good", "passed", "one of two", way[1])
    expect(printed:find "\n1 of 2 did not pass, %d+ s\n$", "the last line: %s", printed)
  end
end)

case("sound summaries pass, and what an earlier call left does not count", function()
  local sound = '{"references": [1, 2], "quantities": {"a": {"state": "sound"}}}'
  equal(run(("{ name = 'a', %s }, { name = 'b', %s }, { name = 'c', %s },"):format(
    leaves('{"verdict": "completed"}', "completed"), leaves(sound, "compared"),
    leaves('{"effects": [{}]}', "compared"))), 0, "summaries as they should be")
  rows = select(3, run "{ name = 'a', command = 'true', look = 'completed' },")
  row(rows, "a", "FAILED", "no summary.json, or one that cannot be read", "what an earlier call left")
end)

case("Ctrl-C ends the jobs", function()
  status, printed, rows = run("{ name = 'bad', command = 'kill -2 $$' }, " .. good)
  equal(status, 1, "status after Ctrl-C: " .. printed)
  row(rows, "good", "not run", "interrupted before", "Ctrl-C")
end)

case("jobs are chosen by the beginning of their name", function()
  local three = "{ name = 'a', command = 'exit 1' }, { name = 'b x', command = 'true' }, "
    .. "{ name = 'b y', command = 'true' }, "
  for options, wanted in pairs { ["only=a"] = { 1, "" }, ["only='b x'"] = { 0, "all 1 passed" },
    ["only=b"] = { 0, "all 2 passed" }, ["quickly"] = { 2, "" },
    ["only=c"] = { 2, "everything: only=c: there is no such job; there are a, b x, b y\n" } } do
    local ended_with, said, _, complaint = run(three, options)
    ended(wanted[1], wanted[2], ended_with, said, complaint)
  end
end)

case("the jobs of this tree are listed and their commands are there", function()
  local listed = "\n" .. ended(0, "", support.run(in_build .. "list"))
  local function has(name, command)
    expect(listed:find("\n" .. name .. ": " .. command), "%s is not among the jobs: %s", name, listed)
  end
  has("main job", ".*/hinge' run scripts/ten_storey_impact.lua %-%-out")
  has("hard", ".*lua5.4 tests/hard/suite.lua\n") -- without a word: in full
  has("page", ".*/hinge' report .*tests/viewer/limits_test.js")
  has("address", "tests/sanitize.sh address\n")
  has("bench", ".*/hinge' run tests/bench/bench.lua build=")
  local all = support.read(support.root .. "scripts/paper/all.lua")
  local paths = support.output(("cd %s && ls scripts/paper/*.lua scripts/cost/*.lua"):format(quote(support.root)))
  for path in paths:gmatch "[^\n]+" do
    local kind, name = path:match "([^/]+)/([^/]+)%.lua$"
    if kind == "cost" then
      has("cost " .. name, ".*/hinge' cost " .. path .. ".* %-%-within %d%% %-%-out")
    elseif name ~= "all" then
      has("paper " .. name, ".*/hinge' run scripts/paper/all.lua only=" .. name .. " %-%-out")
      expect(all:find('"' .. name .. '"', 1, true), "all.lua does not run %s", name)
    end
  end
  expect(not listed:find "quick", "a job is quick: %s", listed)
end)

checks.done()
