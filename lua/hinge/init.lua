-- The module: everything a script gets from `require "hinge"`. hinge.d.lua describes it for editors.
-- Most of its files are read when a script first asks for what they hold: a small script starts at once.
local core = require "hinge.core"
local check = require "hinge.check"
local free = require "hinge.job".free
require "hinge.hinges" -- the method of runs

local later = {
  results = function() return require "hinge.results" end,
  scenario = function() return require "hinge.scenario".new end,
  record = function() return require "hinge.records" end,
}
for _, name in ipairs {
  "material", "section", "backbone", "blast", "combinations", "grid", "heat", "import", "joint", "moving_load",
  "pressure", "units", "ground", "spectrum",
} do
  later[name] = function() return require("hinge." .. name) end
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
