-- hinge.backbone: a function that makes a backbone, and a table of those that make one by published formulas.
local core = require "hinge.core"
local check = require "hinge.library.check"

return check.strict({
  lignos = require "hinge.sections.lignos".backbone,
  nist = require "hinge.standards.nist_gcr_17_917_46.backbones",
  asce41 = require "hinge.standards.asce_41.backbones".backbone,
  ufc = require "hinge.standards.ufc_4_023_03.backbones",
}, "hinge.backbone", core.backbone)
