---@meta
-- Benchmarks ----------------------------------------------------------------------------------------------------------

---@class hinge
local hinge = {}

---A benchmark: a problem whose answer is published or has a closed form. It is a scenario: a script returns it, and
---`hinge run` runs it, prints its rows, and ends with status 1 if a row lies outside its tolerance. A folder of them
---runs as one table by scripts/benchmarks/all.lua, with `folder=` for one of your own: each in a process of its own,
---several at once. What has failed is a row as well. Right rows do not hide a run that failed: where that is meant, the
---function calls job:verdict "completed". results.csv has all rows. scripts/benchmarks/README.md explains
---the columns.
---```lua
---local sag = hinge.benchmark { title = "Cantilever", kind = "elastic", source = "closed form", fast = true,
---  run = function(b)
---    local _, _, uz = tip:displacement(model:static { steps = 1 }:finish())
---    local bending, shear = 1 / (3 * steel.E * square.Ix), 1 / (steel.G * square.shear_area_y)
---    b:row { "deflection", computed = -1e3 * uz, reference = 1e3 * 1000 * (bending + shear), unit = "mm",
---      tolerance = 1e-4, elements = 2 }
---  end }
---print(sag.benchmark.title)
---```
---@param options hinge.benchmark_options
---@return hinge.scenario
function hinge.benchmark(options) end

---@class hinge.benchmark_options
---@field title string
---elastic: statics without yield. stability: buckling and limit points. inelastic: plastic hinges, limit loads.
---dynamics: vibration and impact. test: a structure that was measured
---@field kind "elastic"|"stability"|"inelastic"|"dynamics"|"test"
---@field source string where the references come from
---@field fast? boolean true: it takes under a second; all.lua with fast=true runs these. Default false
---@field missing? string what the model leaves out; it is printed, and stands in the table of the README
---true: its references were not found in a public text. Its rows are marked so, and are not in the medians, the largest
---errors and the picture. Default false
---@field unconfirmed? boolean
---computes, and calls b:row for each number. The second argument is that of a scenario's run, for pictures and notes
---@field run fun(b: hinge.benchmark, job: hinge.job)

---@class hinge.benchmark what the function `run` of a benchmark gets
local benchmark = {}

---Adds a row: what was computed beside its reference. It prints it. A computed value that is not a number, or has no
---end, makes a row that is not right; it is no error. A benchmark without a row has failed.
---```lua
---local turned = hinge.benchmark { title = "Slope", kind = "elastic", source = "closed form", run = function(b)
---  local _, _, _, _, ry = tip:displacement(model:static { steps = 1 }:finish())
---  b:row { "slope of the tip", computed = ry, reference = 1000 / (2 * steel.E * square.Ix), unit = "rad",
---    tolerance = 1e-4, elements = 2 }
---end }
---```
---@param options hinge.benchmark_row
---@return hinge.benchmark_result row
function benchmark:row(options) end

---A function that adds rows which have fields in common, such as the elements and the steps of one run.
---```lua
---local bent = hinge.benchmark { title = "Tip", kind = "elastic", source = "closed form", run = function(b)
---  local _, _, uz, _, ry = tip:displacement(model:static { steps = 1 }:finish())
---  local row = b:rows_with { elements = 2, tolerance = 1e-4 }
---  row("slope", ry, 1000 / (2 * steel.E * square.Ix), "rad")
---  row("deflection", -uz, 1000 / (3 * steel.E * square.Ix), "m", 0.01) -- without shear
---end }
---```
---@param shared table fields of a row
---@return function row takes the quantity, computed, reference, unit, tolerance, and a table of further fields
function benchmark:rows_with(shared) end

---@class hinge.benchmark_row
---the quantity, in a few words. With "observed order" in it, or "order" at its beginning, it is an order of
---convergence, which all.lua leaves out of the median and the largest error
---@field [1] string
---@field computed number
---@field reference number never computed by hinge itself
---@field unit? string of both; default "", a number without one
---largest |error| of a row that is right, as a part of the reference (or of scale). Take 1.5 to 2 times the error that
---was found, 1e-6 at least, so that a change shows
---@field tolerance number
---@field scale? number what the error is a part of, above 0; needed if the reference is 0. Default |reference|
---@field elements integer elements in the member or structure, 1 or more
---@field steps? integer of the run; default 1

---@class hinge.benchmark_result a row as it was found, with the fields that it was given
---@field quantity string
---@field error number (computed - reference) / scale
---@field right boolean whether |error| is within the tolerance; false where the error is not a number
---@field seconds number s of the processor, since the row before or the beginning
