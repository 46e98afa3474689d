-- hinge.results: what comes out of runs, as tables for a report. words/results.d.lua describes the calls.
local check = require "hinge.library.check"

local results = {
  members = require "hinge.results.members".of_run,
  envelope = require "hinge.results.envelope".new,
  storeys = require "hinge.results.storeys".new,
  base = require "hinge.results.base".of_run,
  utilisation = require "hinge.results.utilisation".new,
}

-- Options with the model filled in where they do not name one.
local function with_model(options, model)
  if options ~= nil and type(options) ~= "table" then return options end
  local filled = {}
  for key, value in pairs(options or {}) do filled[key] = value end
  if filled.model == nil then filled.model = model end
  return filled
end

--- The same functions for one model, so that `model` need not be given at each call.
local function of(model, ...)
  check.no_more("hinge.results.of", ...)
  check.model("hinge.results.of", model)
  local bound = {}
  for _, name in ipairs { "members", "storeys", "base", "utilisation" } do
    bound[name] = function(run, options, ...) return results[name](run, with_model(options, model), ...) end
  end
  function bound.envelope(options, ...)
    if type(options) == "userdata" then options = { options } end
    return results.envelope(with_model(options, model), ...)
  end
  return check.strict(bound, "hinge.results.of(model)")
end

results.of = of
return check.strict(results, "hinge.results")
