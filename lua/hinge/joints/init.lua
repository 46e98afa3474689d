-- hinge.joint: a function that makes a joint, and a table of those that make one by EN 1993-1-8:2005.
local core = require "hinge.core"
local check = require "hinge.library.check"

return check.strict({
  end_plate = require "hinge.standards.en_1993_1_8.end_plate",
  fin_plate = require "hinge.standards.en_1993_1_8.fin_plate",
  web_cleats = require "hinge.standards.en_1993_1_8.web_cleats",
  base_plate = require "hinge.standards.en_1993_1_8.base_plate",
  panel_zone = require "hinge.joints.panel_zone",
}, "hinge.joint", core.joint)
