-- How a study goes, while it goes: a line that is renewed on a terminal, lines now and then in a pipe.
local core = require "hinge.core"
local case = require "hinge.study.case"
local status_line = require "hinge.library.status_line"

local progress = {}

--- options: total (number of cases, or nil where they are proposed one after the other), kept (from an earlier run),
-- jobs. Returns { ended(task, outcome), tick(running), close() }.
function progress.new(options)
  local status = status_line.new()
  local began, shown, told = core.clock(), 0, 0
  local done, failed, spent = 0, 0, 0
  local show = {}

  local function line(running)
    local parts = {}
    if options.total then parts[1] = ("%d of %d done"):format(options.kept + done, options.total)
    else parts[1] = ("%d done"):format(options.kept + done) end
    parts[2] = ("%d running"):format(running)
    if failed > 0 then parts[#parts + 1] = ("%d failed"):format(failed) end
    local left = options.total and options.total - options.kept - done
    if left and done > 0 and left > 0 then
      local each = spent / done / options.jobs
      parts[#parts + 1] = status_line.time(math.max(each * left, (core.clock() - began) / done * left)) .. " left"
    end
    return table.concat(parts, ", ")
  end

  function show.ended(task, outcome)
    done, spent = done + 1, spent + outcome.seconds
    if case.finished(outcome.verdict) then return end
    failed = failed + 1
    if failed > 10 then return end
    if status then status.clear() end
    io.stderr:write(("case %d %s%s%s\n"):format(task.number, outcome.verdict,
      outcome.reason and ": " .. outcome.reason or "", failed == 10 and " (further ones: results.csv)" or ""))
  end

  function show.tick(running)
    local now = core.clock()
    if status then
      if now - shown < 0.1 then return end
      shown = now
      status.show(line(running))
      return
    end
    local part = options.total and (options.kept + done) * 10 // math.max(1, options.total) or done // 10
    if part > told and now - began > 2 or now - math.max(shown, began) > 30 then
      told, shown = part, now
      io.stderr:write(line(running) .. "\n")
    end
  end

  function show.close()
    if status then status.clear() end
  end
  return show
end

return progress
