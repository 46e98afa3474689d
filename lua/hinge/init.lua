-- The module: everything a script gets from `require "hinge"`. hinge.d.lua and words describe it for editors.
-- Most of its files are read when a script first asks for what they hold: a small script starts at once.
local core = require "hinge.core"
local check = require "hinge.library.check"
local free = require "hinge.program.job".free
require "hinge.results.hinges" -- the method of runs
core.add_model_method("floor", function(model, options, ...)
  return require "hinge.model.floor"(model, options, nil, ...)
end)

local later = {
  results = function() return require "hinge.results" end,
  scenario = function() return require "hinge.program.scenario".new end,
  record = function() return require "hinge.actions.records" end,
}
for name, file in pairs {
  backbone = "sections.backbone", blast = "actions.blast", combinations = "actions.combinations", grid = "model.grid",
  ground = "actions.ground", heat = "standards.en_1993_1_2.heat", import = "import", joint = "joints",
  material = "sections.material", moving_load = "actions.moving_load", pressure = "actions.pressure",
  section = "sections", spectrum = "actions.spectrum", units = "library.units",
} do
  later[name] = function() return require("hinge." .. file) end
end

-- hinge.study and hinge.cost go by what is in the files that the script has read
if not core.sandboxed() then require "hinge.study.files".watch() end

return check.lazy({
  version = core.version,
  model = core.model,
  resume = core.resume,
  frame = free.frame,
  animate = free.animate,
  picture = free.picture,
  strip = free.strip,
  plot = free.plot,
  note = free.note,
  benchmark = function(...) return require "hinge.benchmark".new(...) end,
  robustness = function(...) return require "hinge.robustness"(...) end,
  study = function(...) return require "hinge.study".run(...) end,
  cost = function(...) return require "hinge.cost".compare(...) end,
}, later, "hinge")
