-- Cases in processes of their own, several at a time.
local core = require "hinge.core"
local case = require "hinge.study.case"
local check = require "hinge.library.check"

local pool = {}

--- Runs tasks: next(running) gives { number =, folder =, what =, resume = } or nil; done(task, outcome) hears of each
-- that has ended, tick(running) is called several times a second. options: jobs, timeout (s) and memory (bytes), or
-- nil. Returns true, or false where a signal ended it: what was under way has been stopped then.
function pool.run(next, done, tick, options)
  local running, count, more = {}, 0, true
  local script = core.script_runs(false) -- signals are looked for here

  local function start(task)
    local free, problem = pcall(core.lock, task.folder) -- the case's process has the lock until its end
    if not free then
      done(task, { verdict = "wrong", reason = tostring(problem), results = {}, seconds = 0 })
      return
    end
    case.prepare(task.folder)
    task.began = core.clock()
    local process = core.start(function() return case.run(task.what, task.folder) end,
      task.folder .. "/output.txt", options.memory or 0, task.resume, options.jobs)
    core.unlock(task.folder)
    running[process] = task
    count = count + 1
  end

  local function ended(process, kind, code, memory)
    local task = running[process]
    if not task then return end
    running[process] = nil
    count = count - 1
    local outcome = case.outcome(task.folder, { kind = kind, code = code, late = task.late,
      stopped = task.stopped })
    outcome.seconds, outcome.memory = core.clock() - task.began, memory
    case.load_modules(outcome.modules)
    done(task, outcome)
  end

  local function end_late_ones()
    if not options.timeout then return end
    for process, task in pairs(running) do
      if not task.late and core.clock() - task.began > options.timeout then
        task.late = options.timeout
        core.kill(process, false)
      end
    end
  end

  while true do
    while more and count < options.jobs do
      local task = next(count)
      if task then start(task) else more = false end
    end
    if count == 0 and not more then
      core.script_runs(script)
      return true
    end
    local process, kind, code, memory = core.wait(0.1)
    if process == "interrupted" then break end
    if process then
      ended(process, kind, code, memory)
      more = true
    end
    end_late_ones()
    tick(count)
  end

  -- A signal came: what is under way writes its checkpoints, where it names some, and ends.
  if count > 0 then
    io.stderr:write(("hinge: interrupted: waits at most 10 s for %s under way; once more ends it at once\n"):format(
      check.count(count, "case")))
  end
  for process, task in pairs(running) do
    task.stopped = true
    core.kill(process, true)
  end
  local until_then = core.clock() + 10
  while count > 0 do
    local process, kind, code, memory = core.wait(0.1, true)
    if process and process ~= "interrupted" then ended(process, kind, code, memory) end
    if core.clock() > until_then then
      for left in pairs(running) do core.kill(left, false) end
    end
  end
  core.script_runs(script)
  return false
end

return pool
