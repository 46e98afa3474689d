-- hinge run SCRIPT --within 2%: reads the command line, searches, makes the chosen run, prints and writes.
local accuracy = require "hinge.accuracy"
local answers = require "hinge.accuracy.answers"
local check = require "hinge.library.check"
local files = require "hinge.study.files"
local report = require "hinge.accuracy.report"
local runner = require "hinge.program.runner"
local values = require "hinge.library.values"

local program = {}

-- What the user gives as values of parameters, as the scenario has them; those of plain statements as they are.
local function parameters_of(options, scenario)
  local given = {}
  local all = scenario and scenario:values(options.case, options.overrides)
  for _, override in ipairs(options.overrides) do given[override[1]] = all and all[override[1]] or override[2] end
  return given
end

--- options: script, case, overrides, out, out_given, within, budget, answers, quiet, all as text. Returns the program's
-- exit status: 0 where the answers are within what was asked, 1 where they are not, or the run failed.
function program.main(options)
  return runner.guard(function()
    if options.sandbox then
      check.fail("--within %s: the search runs a script many times, and in the sandbox a script runs once. Leave out "
        .. "--sandbox if you trust the script; if not, run it in the sandbox with two values of a parameter, such as "
        .. "dt=1e-3 and dt=5e-4, and compare the answers", options.within)
    end
    local within = values.accuracy("--within", options.within)
    local budget = values.time("--budget", options.budget)
    files.watch()
    local scenario = accuracy.load(options)
    local parameters = parameters_of(options, scenario)
    local told, why = accuracy.run { script = options.script, scenario = scenario, case = options.case,
      overrides = options.overrides, parameters = parameters, out = runner.folder(options, parameters),
      out_given = options.out_given ~= nil, within = within, budget = budget,
      answers = answers.read("--answers", options.answers), progress = options.quiet == nil }
    if not told then return runner.status("failed", why) end
    io.stdout:write(told.printed)
    for _, line in ipairs(report.lines(told)) do print(line) end
    print("written to " .. told.folder)
    return told.reached and 0 or 1
  end)
end

return program
