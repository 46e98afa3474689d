-- What the tests of standards/en_1993_1_1 share: sections of each kind, and a demand.
local hinge = require "hinge"
local scenes = require "scenes"
local profile = require "hinge.results.profile"

local function demand(of) return scenes.with({ compression = 0, tension = 0, Mx = 0, My = 0 }, of) end

-- Sections of the tests: rolled and welded H, hot and cold and welded box, pipe, flat bar, round bar.
local sections = {
  rolled = hinge.section.named "IPE 400", wide = hinge.section.named "HEB 300",
  welded = hinge.section.h { depth = 0.5, width = 0.25, web = 0.012, flange = 0.02 },
  hot = hinge.section.named "RHS 200x100x8", cold = hinge.section.named "CFRHS 200x100x8",
  box = hinge.section.box { width = 0.2, depth = 0.3, web = 0.01, flange = 0.02 },
  pipe = hinge.section.named "CHS 244.5x10", bar = hinge.section.solid { width = 0.02, depth = 0.1 },
  round = hinge.section.round { diameter = 0.08 },
}
local plates = {}
for name, s in pairs(sections) do plates[name] = assert(profile.of(s)) end

return { demand = demand, sections = sections, plates = plates }
