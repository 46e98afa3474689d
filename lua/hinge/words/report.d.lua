---@meta
-- require "hinge.report" ----------------------------------------------------------------------------------------------

---@class report.counts
---@field members integer
---@field elastic integer
---@field yielded integer
---@field broken integer
---@field touched integer

---@alias report.damage table<string, report.counts> by group

---@class report
local report = {}

---Returns the damage of the members by group; see run:count.
---```lua
---local report = require "hinge.report"
---print(report.damage(run, { "arm" }).arm.yielded)
---```
---@param run hinge.run
---@param groups string[]
---@return report.damage
function report.damage(run, groups) end

---Prints the damage by group, the energy balance and the wall time by stage. Returns the damage.
---```lua
---local report = require "hinge.report"
---report.show(run, { "arm" })
---```
---@param run hinge.run
---@param groups string[]
---@return report.damage
function report.show(run, groups) end
