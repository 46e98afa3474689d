-- All that the README and its pages name and that ctest leaves out because it takes long: the main job, the hard
-- suite, the million paths, the bench, the limits of the page of hinge report, the tests under ASan and UBSan, the
-- paper's figures and tables, and what accuracy costs in the scenes of scripts/cost.
--
-- Run     cmake --build build --target everything
--         or: lua5.4 tests/everything.lua BUILD [only=NAME] [list] [jobs=FILE]
--         (only: this job, or all whose names begin with it and a blank: only=cost; list: says what there is and runs
--         nothing; jobs: other jobs, from a Lua file that returns them)
-- Shows   which job of how many is running, and the seconds so far; a job that fails does not stop the others
-- Expect  a table of verdict, seconds and reason, and exit status 0 if all passed. What a job printed and wrote is in
--         BUILD/everything/NAME
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "script/?.lua;" .. package.path
local support = require "support"
local quote = support.quote

local function stop(text, ...)
  io.stderr:write("everything: " .. text:format(...) .. "\n")
  os.exit(2)
end

local choice = { only = "" }
for i = 2, #arg do
  local name, value = arg[i]:match "^(%a+)=(.+)$"
  if arg[i] == "list" then
    choice.list = true
  elseif name == "only" or name == "jobs" then
    choice[name] = value
  else
    stop("'%s' is not an option; there are only=NAME, list and jobs=FILE", arg[i])
  end
end
if not arg[1] then stop "the build folder is missing: lua5.4 tests/everything.lua BUILD" end
local build = support.output("cd " .. quote(arg[1]) .. " && pwd"):gsub("%s+$", "")
local root = support.output("cd " .. quote(support.root) .. " && pwd"):gsub("%s+$", "")
if build == "" then stop("there is no folder %s", arg[1]) end

-- What may be wrong although the status is 0: a text, or nil ------------------------------------------------------

local function summary_of(folder)
  local ok, summary = pcall(function() return support.json(support.read(folder .. "/summary.json")) end)
  return ok and summary or nil
end

local looks = {}

function looks.completed(folder)
  local s = summary_of(folder)
  if not s then return "no summary.json, or one that cannot be read" end
  if s.verdict ~= "completed" then return ("verdict %s: %s"):format(s.verdict, s.reason) end
end

-- hinge cost says what it could not compare, and ends with status 0.
function looks.compared(folder)
  local s = summary_of(folder)
  if not s then return "no summary.json, or one that cannot be read" end
  if #(s.failed or {}) > 0 then
    return ("%d settings without an answer, one of them: %s"):format(#s.failed, s.failed[1].failed)
  end
  if #(s.left_out or {}) > 0 then return ("%d settings were left out"):format(#s.left_out) end
  if s.effects then return #s.effects == 0 and "no effect was left out" or nil end
  if #(s.references or {}) ~= 2 then return "there are no two references: " .. table.concat(s.notes or {}, "; ") end
  for _, q in pairs(s.quantities or {}) do
    if q.state == "sound" then return nil end
  end
  return "no answer has an error"
end

-- The jobs: name, command (in the project's folder; @ is the job's own), and what looks at what it left ----------

local function named_scripts(folder) -- { { name, path } }
  local list = {}
  for path in support.output(("cd %s && ls %s/*.lua"):format(quote(root), folder)):gmatch "[^\n]+" do
    list[#list + 1] = { path:match "([^/]+)%.lua$", path }
  end
  return list
end

-- Case I with 100 frames, its page, and what a headless Chromium says of that: size, time to open, frames a second.
local function page_job(hinge)
  local function found(programs)
    return ("$(command -v %s || echo %s)"):format(table.concat(programs, " || command -v "), programs[1])
  end
  return { name = "page", look = "completed",
    command = ("%s run -q scripts/ten_storey_impact.lua frame_every=250 --out @ && %s report @ && "
      .. "%s tests/viewer/limits_test.js %s @/report.html"):format(hinge, hinge, found { "node", "nodejs" },
      found { "chromium-headless-shell", "chromium", "chromium-browser" }) }
end

local function all_jobs()
  local hinge = quote(build .. "/hinge")
  local jobs = {
    { name = "main job", command = hinge .. " run scripts/ten_storey_impact.lua --out @", look = "completed" },
    { name = "hard", command = ("LUA_CPATH=%s lua5.4 tests/hard/suite.lua"):format(quote(build .. "/?.so")) },
    { name = "paths", command = ('HINGE_FIGURES=1 %s "[paths]"'):format(quote(build .. "/tests/hinge_tests")) },
    { name = "bench", look = "completed",
      command = ("%s run tests/bench/bench.lua build=%s --out @"):format(hinge, quote(build .. "/tests")) },
    page_job(hinge),
    { name = "guide figures",
      command = ("lua5.4 tests/script/documents/guide_figures_test.lua %s all"):format(quote(build)) },
    { name = "address", command = "tests/sanitize.sh address" }, -- builds into build-address/
  }
  for _, script in ipairs(named_scripts "scripts/paper") do
    if script[1] ~= "all" then
      jobs[#jobs + 1] = { name = "paper " .. script[1], look = "completed",
        command = ("%s run scripts/paper/all.lua only=%s --out @"):format(hinge, script[1]) }
    end
  end
  -- Of each scene the commands that its head states.
  for _, script in ipairs(named_scripts "scripts/cost") do
    local head = support.read(root .. "/" .. script[2]):match "^(.-)\nlocal "
    for options in head:gmatch("hinge cost " .. script[2]:gsub("%p", "%%%0") .. "([^\n(]*)") do
      options = options:gsub("%s+$", "")
      local others = options:gsub(" %-%-within %S+", "")
      jobs[#jobs + 1] = { name = "cost " .. script[1] .. others, look = "compared",
        command = ("%s cost %s%s --out @"):format(hinge, script[2], options) }
    end
  end
  return jobs
end

local jobs, chosen = choice.jobs and dofile(choice.jobs) or all_jobs(), {}
for _, job in ipairs(jobs) do
  if choice.only == "" or job.name == choice.only or job.name:sub(1, #choice.only + 1) == choice.only .. " " then
    chosen[#chosen + 1] = job
  end
end
if #chosen == 0 then
  local names = {}
  for i, job in ipairs(jobs) do names[i] = job.name end
  stop("only=%s: there is no such job; there are %s", choice.only, table.concat(names, ", "))
end
if choice.list then
  for _, job in ipairs(chosen) do print(("%s: %s"):format(job.name, job.command)) end
  os.exit(0)
end

-- One after the other ----------------------------------------------------------------------------------------------

-- What a job says itself: the last line that names a failure, or else the last one that it printed; and the last note.
local function last_words(log)
  local last, failure, note = "it printed nothing", nil, nil
  for line in log:gmatch "[^\r\n]+" do
    if line:find "^hinge: " or line:find "^lua5.4: " or line:find "^the rule is broken" then failure = line end
    note = line:match "^note: (.*)" or note
    if line:find "%S" then last = line end
  end
  return (failure or last) .. (note and " (" .. note .. ")" or ""), note
end

-- Runs a job. Returns why it failed (nil: it passed), what else is worth knowing, and whether it was interrupted.
local function run(job)
  local folder = build .. "/everything/" .. job.name:gsub("[^%w_.-]+", "_")
  support.run(("rm -rf %s && mkdir -p %s"):format(quote(folder), quote(folder)))
  local command = job.command:gsub("@", (quote(folder):gsub("%%", "%%%%")))
  local log = folder .. "/log.txt"
  local _, kind, status = os.execute(("cd %s && { %s ; } >%s 2>&1 </dev/null"):format(quote(root), command, quote(log)))
  local words, note = last_words(support.read(log) or "")
  local interrupted = kind == "signal" and (status == 2 or status == 15) or status == 130 or status == 143
  if kind ~= "exit" or status ~= 0 then
    return ("%s %d: %s"):format(kind == "exit" and "status" or kind, status, words), nil, interrupted
  end
  local missing = (support.read(log) or ""):match "[^\n]* not drawn: [^\n]*"
  return job.look and looks[job.look](folder) or missing, note
end

local start, rows, failed = os.time(), {}, 0
local function so_far() return os.difftime(os.time(), start) end
for i, job in ipairs(chosen) do
  print(("[%d of %d, %.0f s so far] %s"):format(i, #chosen, so_far(), job.name))
  io.stdout:flush()
  local begun = os.time()
  local why, note, interrupted = run(job)
  if why then failed = failed + 1 end
  rows[i] = { job.name, why and "FAILED" or "passed", os.difftime(os.time(), begun), why or note or "" }
  if why then print(("    FAILED: %s"):format(why)) end
  if interrupted then
    for k = i + 1, #chosen do rows[k], failed = { chosen[k].name, "not run", 0, "interrupted before" }, failed + 1 end
    break
  end
end

local width = 4
for _, row in ipairs(rows) do if #row[1] > width then width = #row[1] end end
local form = "%-" .. width .. "s  %-7s  %7s  %s"
print("\n" .. form:format("job", "verdict", "seconds", "reason"))
for _, row in ipairs(rows) do print((form:format(row[1], row[2], ("%.0f"):format(row[3]), row[4]):gsub("%s+$", ""))) end
local outcome = failed == 0 and ("all %d passed"):format(#rows) or ("%d of %d did not pass"):format(failed, #rows)
print(("%s, %.0f s"):format(outcome, so_far()))
os.exit(failed == 0)
