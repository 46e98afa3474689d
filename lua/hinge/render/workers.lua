-- Work on numbered items in several processes, each of which takes the next item when it has done one; with a line on a
-- terminal that says how far it is.
local core = require "hinge.core"
local status_line = require "hinge.library.status_line"

local workers = {}

-- Shows "37 of 100 pictures, 12 s left" on a terminal.
local function progress(what, total)
  local line, began = status_line.new(), core.clock()
  local show = {}
  function show.tick(done)
    if not line then return end
    local text = ("%d of %d %s"):format(done, total, what)
    if done > 0 and done < total then
      text = ("%s, %s left"):format(text, status_line.time((core.clock() - began) / done * (total - done)))
    end
    line.show(text)
  end
  function show.close()
    if line then line.clear() end
  end
  return show
end

-- What a process of its own does: items until there are none, and a line of JSON about each.
local function work_on(number, task)
  while true do
    local i = number:next()
    if i > task.count then return 0 end
    local ok, result = pcall(task.work, i, task.steps)
    local told = { item = i, ok = ok }
    if ok then told.result = result
    else
      told.problem = tostring(result)
      told.unwritten, told.why = core.unwritten(result)
      if not told.unwritten then told.field, told.why = core.wrong_field(result) end
    end
    io.stdout:write(core.to_json(told), "\n")
    io.stdout:flush()
  end
end

-- The lines of JSON that the processes have left, by item.
local function results_in(files)
  local results = {}
  for _, file in ipairs(files) do
    for line in io.lines(file:path()) do
      local result = line:find "^{" and core.from_json(line)
      if result and result.item then results[result.item] = result end
    end
  end
  return results
end

--- Calls task.work(i, task.steps) for i from 1 to task.count in at most task.jobs processes. task: also what (what the
-- items are called) and steps (a shared number on which work counts how far it is, of task.total; without it the items
-- are counted). Returns { [i] = { ok = true, result = what work returned } or { ok = false, problem = text,
-- unwritten =, field =, why = } }: the file that could not be written or the field that is wrong, where that was the
-- problem, and why; or nil where a signal came, after the processes have been ended. task.killed(process) hears of
-- those that did not end well.
function workers.run(task)
  local number, running, count, files = core.shared_number(), {}, 0, {}
  local show = progress(task.what, task.total or task.count)
  local ends = {} -- how processes ended that did not end well

  local function start()
    local file = core.memory_file()
    files[#files + 1] = file
    running[core.start(function() return work_on(number, task) end, file:path(), 0, false)] = number:so_far()
    count = count + 1
  end

  for _ = 1, math.min(task.jobs, task.count) do start() end
  local interrupted = false
  while count > 0 do
    local process, kind, code = core.wait(0.1, interrupted)
    if process == "interrupted" then
      interrupted = true
      for one in pairs(running) do core.kill(one, false) end
    elseif process and running[process] then
      local began_at = running[process]
      running[process] = nil
      count = count - 1
      if interrupted and task.killed then task.killed(process) end
      if kind == "signal" or code ~= 0 then
        ends[#ends + 1] = kind == "signal" and ("by signal %d"):format(code) or ("with status %d"):format(code)
        if task.killed then task.killed(process) end
        -- Another one takes what is left, unless this one did not get as far as an item.
        if not interrupted and number:so_far() > began_at and number:so_far() < task.count then start() end
      end
    end
    local done = task.steps and task.steps:so_far() or math.max(0, math.min(number:so_far(), task.count) - count)
    if not interrupted then show.tick(done) end
  end
  show.close()
  if interrupted then return nil end

  local results = results_in(files)
  for i = 1, task.count do
    results[i] = results[i] or { ok = false, problem = #ends > 0
      and ("the process that worked on it ended %s"):format(table.concat(ends, ", "))
      or "nothing was heard of it" }
  end
  return results
end

return workers
