-- hinge cost: reads the command line, compares, prints and writes.
local check = require "hinge.check"
local cost = require "hinge.cost"
local runner = require "hinge.runner"
local values = require "hinge.values"

local program = {}

local function positive(option, text, units, allowed)
  if not text then return nil end
  local number, unit = text:match "^%s*([%d.eE+-]+)%s*(%%?%a*)%s*$"
  number = number and values.number(number)
  if not number or not units[unit] or number <= 0 then check.fail("%s %s: must be %s", option, text, allowed) end
  return number * units[unit]
end

--- options: script, case, overrides, out, within, budget, quantity, effects (nil or not), all as text. Returns the
-- program's exit status.
function program.main(options)
  return runner.guard(function()
    local within = positive("--within", options.within, { [""] = 1, ["%"] = 0.01 },
      "a part above 0, such as 1% or 0.01")
    local budget = positive("--budget", options.budget, { [""] = 1, s = 1, min = 60, h = 3600 },
      "a time above 0, such as 60s, 5min or 1h")
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
