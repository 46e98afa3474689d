-- The module: everything a script gets from `require "hinge"`. hinge.d.lua describes it for editors.
local core = require "hinge.core"
local check = require "hinge.check"
local free = require "hinge.job".free
require "hinge.hinges" -- the method of runs

return check.strict({
  version = core.version,
  model = core.model,
  material = require "hinge.material",
  section = require "hinge.section",
  backbone = require "hinge.backbone",
  benchmark = function(...) return require "hinge.benchmark".new(...) end,
  blast = require "hinge.blast",
  combinations = require "hinge.combinations",
  grid = require "hinge.grid",
  heat = require "hinge.heat",
  import = require "hinge.import",
  joint = require "hinge.joint",
  moving_load = require "hinge.moving_load",
  pressure = require "hinge.pressure",
  units = require "hinge.units",
  resume = core.resume,
  ground = require "hinge.ground",
  record = require "hinge.records",
  spectrum = require "hinge.spectrum",
  frame = free.frame,
  picture = free.picture,
  strip = free.strip,
  plot = free.plot,
  note = free.note,
  results = require "hinge.results",
  robustness = function(...) return require "hinge.robustness"(...) end,
  scenario = require "hinge.scenario".new,
  study = function(...) return require "hinge.study".run(...) end,
  cost = function(...) return require "hinge.cost".compare(...) end, -- read when it is first asked for
}, "hinge")
