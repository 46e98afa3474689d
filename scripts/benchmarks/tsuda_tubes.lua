-- Three square tubes of Tsuda and Matsui, 1998, in cycles under 0.1, 0.3 and 0.45 of their axial strength.
--
-- Run     hinge run scripts/benchmarks/tsuda_tubes.lua
-- Shows   the interaction of axial force and moment of a box, and what a column without loss of strength leaves out
-- Expect  greatest moments 2 to 6 % below the tests. The last cycle of 333C has 1.8 times the moment of the test: its
--         walls (35 times their thickness wide) buckle, which hinge has no published backbone for
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "support/?.lua;" .. package.path
local column = require "column"
local hinge = require "hinge"

-- Measured. The outer radius of the corners, twice the wall, follows from the measured area of 2453 mm^2.
local L, steps, elements = 1, 20, 2
local steel = hinge.material { E = 205e9, yield_stress = 440.3e6 }
local tube = hinge.section.box { width = 0.15, depth = 0.15, thickness = 0.00429, r = 0.00858 }
local N0 = tube.area * steel.yield_stress

-- Points: greatest moments (kN m) of the cycles at the largest rotation (rad) in their order, both directions.
local tests = {
  { "331C", n = 0.1, most = 61.6, tolerance = 0.1, turns = { { 0.0068, 2 }, { 0.0136, 2 }, { 0.0203, 7 } },
    x = { 0.0057, 0.0137, 0.0206, 0.0205, 0.0201, 0.0203, 0.0202, 0.0203, 0.0203, -0.0068, -0.0134, -0.0177, -0.0163,
      -0.0156, -0.0155, -0.0182 },
    y = { 23, 52, 60, 56, 50, 44, 40, 36, 34, -32, -57, -63, -54, -47, -42, -38 } },
  { "333C", n = 0.3, most = 53.7, last = 28.5, tolerance = 0.07, turns = { { 0.0068, 2 }, { 0.0134, 6 } },
    x = { 0.0069, 0.0134, 0.0136, 0.0135, 0.0118, 0.0104, 0.0067, -0.0066, -0.0133, -0.0135, -0.013, -0.0133, -0.0066,
      -0.0071 },
    y = { 30, 50, 53, 51, 48, 38, 31, -33, -54, -53, -54, -40, -35, -27 } },
  { "335C", n = 0.45, most = 44.0, tolerance = 0.04, turns = { { 0.0068, 2 }, { 0.0134, 1 } },
    x = { 0.0069, 0.0115, 0.0019, 0.0049, -0.0065, -0.0084, -0.0025, -0.0029 },
    y = { 33, 43, 27, 13, -32, -45, -20, -8 } },
}

return hinge.benchmark {
  title = "Square tubes in cycles, Tsuda and Matsui 1998", kind = "test", fast = true,
  source = "Tsuda and Matsui, J. Struct. Constr. Eng. AIJ 512, 1998: Matsui-331C, 333C, 335C, by the collection "
    .. "RESSLab-Team/resslab-hub-data",
  missing = "local buckling: hinge has no published backbone for tubes, so the columns lose no strength; hardening",
  run = function(b, job)
    local panels, last = {}, nil
    for i, test in ipairs(tests) do
      local curve = column.bent { section = tube, material = steel, L = L, P = test.n * N0, steps = steps,
        elements = elements, turns = column.turns(test.turns) }
      b:row { test[1] .. ", greatest moment", computed = column.most(curve), reference = test.most, unit = "kN m",
        tolerance = test.tolerance, elements = elements, steps = steps }
      if test.last then last = { curve.peaks[#curve.peaks - 1], test.last } end
      panels[i] = { title = ("%s, %g Np"):format(test[1], test.n), x_label = "rotation of the chord (rad)",
        y_label = "moment at the foot (kN m)", y_range = { -75, 110 },
        series = { { x = curve.x, y = curve.y, name = "no loss of strength" },
          { x = test.x, y = test.y, name = "test, all cycles", style = "points" } } }
    end
    b:row { "333C, last cycle", computed = last[1], reference = last[2], unit = "kN m", tolerance = 1.3,
      elements = elements, steps = steps }
    job:plot({ panels = panels, columns = 3, title = "Square tubes of Tsuda and Matsui" }, "tsuda_tubes.png")
  end,
}
