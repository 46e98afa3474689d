-- Two deep columns of Ozkula, Harris and Uang, 2019, clamped at both ends, in cycles: without axial force, and under
-- 0.49 of the axial strength up to 0.010 rad.
--
-- Run     hinge run scripts/benchmarks/ozkula_columns.lua
-- Shows   the monotonic backbone of NIST (2017) with its wear on members of building size; nothing was fitted
-- Expect  the greatest moment of 2Z is 17 % too low, that of 1H 20 %. Both lose their strength too fast: 2Z keeps its
--         strength in the test to 0.063 rad, and has 43 % of it in hinge; 1H has half of it. Wear by the formula takes
--         more from members of this size than the tests did
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "support/?.lua;" .. package.path
local column = require "column"
local hinge = require "hinge"

local L, steps, elements = 5.486, 20, 2

-- Measured sizes, m; r from the depth of the web between the fillets, for h / tw; Fy: mean by area, Pa. Points: the
-- greatest moments (MN m) of the first cycle at each size of rotation (rad); most and last: of all, and of the last.
local tests = {
  { "2Z, no axial force", P = 0, Fy = 366.1e6, r = 0.0232,
    most = 3.10, last = 2.95, tolerance = { 0.3, 0.9 },
    size = { depth = 0.622, width = 0.328, web = 0.0154, flange = 0.0244 },
    turns = { { 0.0079, 2 }, { 0.0100, 4 }, { 0.0136, 2 }, { 0.0182, 2 }, { 0.0274, 2 }, { 0.0360, 2 }, { 0.0452, 2 },
      { 0.0540, 1 }, { 0.0630, 2 } },
    x = { 0.0076, 0.0101, 0.0135, 0.0183, 0.0276, 0.0363, 0.0453, 0.0538, 0.0567, -0.0069, -0.0095, -0.0134, -0.0178,
      -0.0268, -0.0355, -0.0452, -0.0541, -0.0632 },
    y = { 1.72, 1.95, 2.27, 2.47, 2.76, 3.04, 3.04, 3.04, 3.08, -1.71, -2.00, -2.24, -2.48, -2.92, -3.10, -2.85, -2.95,
      -2.95 } },
  { "1H, 0.49 Np", P = 6209e3, Fy = 382.6e6, r = 0.0232,
    most = 2.64, last = 2.51, tolerance = { 0.3, 0.75 },
    size = { depth = 0.64, width = 0.328, web = 0.0191, flange = 0.034 },
    turns = { { 0.0055, 6 }, { 0.0077, 6 }, { 0.0100, 4 } },
    x = { 0.0054, 0.0077, 0.0099, -0.0050, -0.0073, -0.0085 },
    y = { 1.89, 2.47, 2.64, -1.64, -2.27, -2.63 } },
}

local function bent(t)
  t.size.r = nil
  local section = hinge.section.h(t.size)
  t.size.r = t.r
  local steel = hinge.material { E = 200e9, yield_stress = t.Fy }
  local rule = hinge.backbone.nist { kind = "column", section = hinge.section.h(t.size), material = steel,
    shear_span = L / 2, unbraced_length = L, axial_ratio = t.P / (section.area * t.Fy), interaction = "exact" }
  local curve = column.bent { section = section, material = steel, L = L, P = t.P, clamped = true,
    backbone = rule, turns = column.turns(t.turns),
    steps = steps, elements = elements }
  for i, y in ipairs(curve.y) do curve.y[i] = y / 1e3 end
  return curve, curve.peaks[#curve.peaks] / 1e3
end

return hinge.benchmark {
  title = "Deep columns in cycles, Ozkula 2019", kind = "test", fast = true,
  source = "Ozkula, Harris and Uang, AISC Engineering Journal 54(1), 2019: 2Z, 1H, by the collection "
    .. "RESSLab-Team/resslab-hub-data",
  missing = "hardening in cycles beyond the backbone, buckling about the weak axis with torsion",
  run = function(b, job)
    local panels = {}
    local row = b:rows_with { unit = "MN m", elements = elements, steps = steps }
    for i, t in ipairs(tests) do
      local curve, last = bent(t)
      local name = t[1]:match "^%w+"
      row(name .. ", greatest moment", column.most(curve), t.most, nil, t.tolerance[1])
      row(name .. ", last half cycle", last, t.last, nil, t.tolerance[2])
      panels[i] = { title = t[1], x_label = "rotation of the chord (rad)", y_label = "end moment (MN m)",
        y_range = { -3.3, 5 }, series = { { x = curve.x, y = curve.y, name = "NIST, monotonic with wear" },
          { x = t.x, y = t.y, name = "test, first cycles", style = "points" } } }
    end
    job:plot({ panels = panels, columns = 2, title = "Columns of Ozkula" }, "ozkula_columns.png")
  end,
}
