-- The module: everything a script gets from `require "hinge"`. hinge.d.lua describes it for editors.
local core = require "hinge.core"
local check = require "hinge.check"

return check.strict({
  version = core.version,
  model = core.model,
  material = core.material,
  section = require "hinge.section",
  resume = core.resume,
  ground = require "hinge.ground",
  scenario = require "hinge.scenario".new,
  cost = function(...) return require "hinge.cost".compare(...) end, -- read when it is first asked for
}, "hinge")
