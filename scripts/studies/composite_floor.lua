-- Which inputs does the load depend on that a composite floor holds without a column? The floor of
-- scripts/benchmarks/illinois_floor.lua, whose head says what is known of it and what is taken.
--
-- Run     hinge study scripts/studies/composite_floor.lua column=corner,girders bolt=20e3,29e3,40e3 -j 1
--         hinge run scripts/studies/composite_floor.lua column=corner panels=6 tell=true      (the curve as text)
-- Shows   the load that the floor holds up to a sag of 0.6 m, the sag there, and how many shear tabs have broken
-- Expect  half a minute a case with 3 panels along a bay, and some two minutes with 6
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../benchmarks/support/?.lua;" .. package.path
local floor = require "half_scale_floor"
local hinge = require "hinge"

local parameters = { column = "corner", tell = false }
for name, value in pairs(floor.inputs) do parameters[name] = value end

return hinge.scenario {
  parameters = parameters,
  run = function(p, job)
    if not floor.columns[p.column] then error("column is 'corner', 'girders', 'beams' or 'interior'", 0) end
    local changes = {}
    for name in pairs(floor.inputs) do changes[name] = p[name] end
    changes.tell = p.tell
    local found = floor.test(changes, p.column)
    print(("%.2f kPa (%.0f psf) at %.2f m; %d tabs broken then, %d at the end"):format(found.peak / 1e3,
      found.peak / 47.880, found.sag, found.tabs_at_peak, found.tabs))
    job:plot({ series = { { x = found.x, y = found.y } }, x_label = "sag of the lost column (m)",
      y_label = "load held (kPa)" }, "held.png")
    return { held_kPa = found.peak / 1e3, sag = found.sag, tabs_at_peak = found.tabs_at_peak, tabs = found.tabs,
      energy_error = found.error }
  end,
}
