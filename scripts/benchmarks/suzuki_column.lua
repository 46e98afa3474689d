-- A column under 0.30 of its axial strength that is pushed until nothing is left: Suzuki and Lignos, 2021, W-6-34-M-C.
--
-- Run     hinge run scripts/benchmarks/suzuki_column.lua
-- Shows   the monotonic backbone of NIST (2017) for columns over the whole way down; nothing was fitted
-- Expect  the moment at yield is right. The greatest one is 10 % too high, as the published one is: 1.49 * 9/8
--         (1 - 0.30) Mp = 627 kN m. The way down begins 0.01 rad late, is 7 % too high at 0.11 rad, and 3 % too low at
--         0.13 rad
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "support/?.lua;" .. package.path
local column = require "column"
local hinge = require "hinge"
local value_at = require "hinge.library.numeric".value_at

-- W14X53, cantilever, braced at its head; measured sizes and yield stress, mean by area. The fillets are for h / tw
-- alone.
local L, P, steps, elements = 1.825, 1134e3, 120, 2
local steel = hinge.material { E = 200e9, yield_stress = 387e6 }
local section = hinge.section.h { depth = 0.353, width = 0.2043, web = 0.0098, flange = 0.0164 }
local with_fillets = hinge.section.h { depth = 0.353, width = 0.2043, web = 0.0098, flange = 0.0164, r = 0.0217 }

-- Moment at the foot (kN m) over the rotation of the chord (rad), read off the published curve.
local test = { name = "test", style = "points",
  x = { 0.0035, 0.0070, 0.0085, 0.0109, 0.0137, 0.0166, 0.0208, 0.0254, 0.0295, 0.0339, 0.0410, 0.0455, 0.0505,
    0.0555, 0.0605, 0.0655, 0.110, 0.120, 0.130, 0.140, 0.150, 0.160, 0.170, 0.180, 0.190, 0.200 },
  y = { 190, 379, 443, 490, 508, 514, 525, 540, 552, 563, 575, 562, 543, 522, 496, 477, 343, 311, 281, 259, 232, 202,
    175, 151, 115, 79 } }

return hinge.benchmark {
  title = "Column pushed to its end, Suzuki 2021", kind = "test", fast = true,
  source = "Suzuki and Lignos, J. Struct. Eng. 147(4), 2021: W-6-34-M-C, by the collection "
    .. "RESSLab-Team/resslab-hub-data",
  missing = "the give of the foot",
  run = function(b, job)
    local curve = column.bent { section = section, material = steel, L = L, P = P, turns = { 0.14 }, steps = steps,
      elements = elements, backbone = hinge.backbone.nist { kind = "column", section = with_fillets, material = steel,
        shear_span = L, unbraced_length = L, axial_ratio = P / (section.area * steel.yield_stress),
        interaction = "exact", wear = false } }
    local row = b:rows_with { elements = elements, steps = steps }
    row("moment at 0.0137 rad", value_at(curve, 0.0137), 508, "kN m", 0.01)
    row("greatest moment", column.most(curve), 575, "kN m", 0.15)
    row("rotation at 80 %", column.fallen_to(curve, 0.8), 0.070, "rad", 0.23)
    row("moment at 0.11 rad", value_at(curve, 0.11), 343, "kN m", 0.12)
    row("moment at 0.13 rad", value_at(curve, 0.13), 281, "kN m", 0.05)
    job:plot({ series = { { x = curve.x, y = curve.y, name = "NIST, monotonic" }, test },
      x_label = "rotation of the chord (rad)", y_label = "moment at the foot (kN m)",
      title = "W-6-34-M-C, pushed once" }, "suzuki_column.png")
  end,
}
