-- hinge.backbone: a function that makes a backbone, and a table of those that make one by published formulas.
local core = require "hinge.core"
local check = require "hinge.library.check"

local backbone = {
  lignos = require "hinge.sections.lignos".backbone,
  nist = require "hinge.standards.nist_gcr_17_917_46.backbones",
  asce41 = require "hinge.standards.asce_41.backbones".backbone,
  ufc = require "hinge.standards.ufc_4_023_03.backbones",
}

return setmetatable(backbone, {
  __call = function(_, ...) return core.backbone(...) end,
  __index = function(t, key) check.unknown("hinge.backbone", "field", key, check.keys(t)) end,
  __name = "hinge.backbone",
})
