-- A folder of benchmarks: each file in a process of its own, several at a time, and the rows that all have found.
local core = require "hinge.core"
local benchmark = require "hinge.benchmark"
local case = require "hinge.study.case"
local check = require "hinge.library.check"
local files = require "hinge.study.files"
local pool = require "hinge.study.pool"
local runner = require "hinge.program.runner"
local scenario = require "hinge.program.scenario"
local status_line = require "hinge.library.status_line"
local quote = require "hinge.library.quote"

local set, kinds = {}, {}
for i, kind in ipairs(benchmark.kinds) do kinds[kind] = i end

--- The names in a folder that end so, in alphabetical order, without the ending.
function set.names(folder, ending)
  local list = {}
  local pipe = assert(io.popen("ls -1 " .. quote.shell(folder) .. " 2>/dev/null"))
  for name in pipe:lines() do
    if name:sub(-#ending) == ending then list[#list + 1] = name:sub(1, -#ending - 1) end
  end
  pipe:close()
  table.sort(list)
  return list
end

--- Copies a file. (core.write_text ends a text at a byte 0.)
function set.copy(from, to)
  local text = assert(files.text(from), from)
  local file, problem = io.open(to, "wb")
  if not file then check.fail("cannot write %s", problem) end
  local written = file:write(text)
  if not (file:close() and written) then check.fail("cannot write %s", to) end
end

-- What a script says of itself, without running it; `problem`: why it is no benchmark.
local function description_of(path)
  local made = runner.load(path)
  local what = made and made.benchmark
  if not what then
    return { problem = path .. " returns no benchmark; its last statement must be return hinge.benchmark { ... }" }
  end
  return what
end

-- Runs tasks of a pool, one for each of `list`, which has items with name and folder. Returns false where a signal
-- ended it.
local function in_processes(list, what_of, done, tick, options)
  local at = 0
  local function next_task()
    at = at + 1
    local one = list[at]
    return one and { number = at, one = one, folder = one.folder, what = what_of(one) }
  end
  return pool.run(next_task, function(task, outcome) done(task.one, outcome) end, tick, options)
end

-- What a process has said about a benchmark, as a reason why it has no rows.
local function reason_of(outcome)
  if outcome.verdict == "completed" or outcome.verdict == "failed" then return outcome.reason or "it found no row" end
  return outcome.verdict .. (outcome.reason and ": " .. outcome.reason or "")
end

-- Reads title, kind and so on of each file. One that cannot be loaded has failed already.
local function describe(list, options)
  return in_processes(list, function(one)
    return { scenario = scenario.new { run = function() return description_of(one.path) end } }
  end, function(one, outcome)
    local found = outcome.results
    if outcome.verdict == "completed" and found.kind then
      for _, name in ipairs(benchmark.said) do one[name] = found[name] end
    else
      one.title, one.failure = one.name, found.problem or reason_of(outcome)
    end
  end, function() end, options)
end

-- Whether a benchmark is among those that were asked for. One that cannot be loaded is, unless its name tells that it
-- is not.
local function wanted(one, o)
  if o.fast and not one.fast and not one.failure then return false end
  if o.filter == "" or o.filter == one.kind then return true end
  if kinds[o.filter] then return false end -- "elastic" does not mean the inelastic ones
  for _, text in ipairs { one.name, one.title, one.kind or "" } do
    if text:lower():find(o.filter:lower(), 1, true) then return true end
  end
  return false
end

-- A number as summary.json has it: what is not finite is a text there.
local function number(value)
  if type(value) == "number" then return value end
  if value == "inf" then return math.huge elseif value == "-inf" then return -math.huge end
  return 0 / 0
end

-- Takes the rows that a benchmark has left in its folder. A benchmark that did not end as it should has a failure.
local function take(one, outcome)
  local summary = files.text(one.folder .. "/summary.json")
  summary = summary and core.from_json(summary) or {}
  one.seconds = outcome.seconds
  local wrong = 0
  for i, row in ipairs((summary.results or {}).rows or {}) do
    for _, name in ipairs { "computed", "reference", "error" } do row[name] = number(row[name]) end
    row.right = row.right == true and math.abs(row.error) <= row.tolerance
    wrong = wrong + (row.right and 0 or 1)
    one.rows[i] = row
  end
  if #one.rows == 0 or wrong == 0 and not case.finished(outcome.verdict) then one.failure = reason_of(outcome) end
end

--- Whether a benchmark that has run is as it should be.
function set.is_right(one)
  if one.failure then return false end
  for _, row in ipairs(one.rows) do
    if not row.right then return false end
  end
  return true
end

-- A line that says how far it is: on a terminal renewed in its place, else one now and then.
local function progress(total, say)
  local status, began, shown, done, failed = status_line.new(), core.clock(), core.clock(), 0, 0
  local function line(running)
    local text = ("%d of %d benchmarks done, %d running"):format(done, total, running)
    if failed > 0 then text = ("%s, %d failed"):format(text, failed) end
    if done == 0 or done == total then return text end
    return ("%s, %s left"):format(text, status_line.time((core.clock() - began) / done * (total - done)))
  end
  return {
    ended = function(bad)
      done, failed = done + 1, failed + (bad and 1 or 0)
    end,
    tick = function(running)
      if not say or core.clock() - shown < (status and 0.1 or 30) then return end
      shown = core.clock()
      if status then status.show(line(running)) else io.stderr:write(line(running) .. "\n") end
    end,
    close = function() if status then status.clear() end end,
  }
end

-- All benchmarks of a folder, by kind and name.
local function all_of(o)
  local all = {}
  for _, name in ipairs(set.names(o.folder, ".lua")) do
    if not o.without[name] then
      all[#all + 1] = { name = name, path = o.folder .. "/" .. name .. ".lua", folder = o.out .. "/" .. name,
        rows = {} }
    end
  end
  if #all == 0 then check.fail("folder=%s: it holds no benchmark, a file ending in .lua", o.folder) end
  local whole = describe(all, o)
  table.sort(all, function(a, b)
    local i, k = kinds[a.kind] or 99, kinds[b.kind] or 99
    return i < k or i == k and a.name < b.name
  end)
  return all, whole
end

local function refuse_none(o, all)
  local names = {}
  for i, one in ipairs(all) do names[i] = one.name end
  table.sort(names)
  check.fail("filter=%s%s: no benchmark has this in its name, its kind or its title; there are %s", o.filter,
    o.fast and " fast=true" or "", table.concat(names, ", "))
end

--- Runs the benchmarks of a folder. o: folder, out, jobs, filter, fast, timeout (s), without (a set of names), quiet.
-- Returns the list of those that were asked for, by kind and name, each { name =, path =, title =, kind =, source =,
-- missing =, folder =, rows =, failure =, seconds = }, and whether all have ended (false: a signal came).
function set.run(o)
  local all, whole = all_of(o)
  local list, to_run = {}, {}
  for _, one in ipairs(all) do
    if wanted(one, o) then
      list[#list + 1] = one
      if not one.failure then to_run[#to_run + 1] = one end
    end
  end
  if #list == 0 then refuse_none(o, all) end
  local show = progress(#to_run, not o.quiet)
  whole = whole and in_processes(to_run, function(one) return { script = one.path } end, function(one, outcome)
    take(one, outcome)
    show.ended(not set.is_right(one))
  end, show.tick, o)
  show.close()
  return list, whole
end

return set
