-- hinge cost: reads the command line, compares, prints and writes.
local check = require "hinge.library.check"
local cost = require "hinge.cost"
local files = require "hinge.study.files"
local runner = require "hinge.program.runner"
local values = require "hinge.library.values"

local program = {}

--- options: script, case, overrides, out, within, budget, quantity, effects (nil or not), all as text. Returns the
-- program's exit status.
function program.main(options)
  return runner.guard(function()
    local within = values.accuracy("--within", options.within)
    local budget = values.time("--budget", options.budget)
    files.watch()
    local scenario = runner.load(options.script, options.overrides)
    if not scenario then
      check.fail("cost: %s has no settings to compare; it does not return a hinge.scenario", options.script)
    end
    local given, parameters = scenario:values(options.case, options.overrides), {}
    for _, override in ipairs(options.overrides) do parameters[override[1]] = given[override[1]] end
    local out = runner.folder(options, parameters)
    local result = cost.compare(scenario, { within = within, budget = budget, quantity = options.quantity,
      case = options.case, parameters = parameters, out = out, progress = true,
      effects = options.effects ~= nil })
    require(options.effects and "hinge.cost.effects_report" or "hinge.cost.report").show(result)
    print("written to " .. out)
    return 0
  end)
end

return program
