-- A beam with a reduced section in cycles until it has lost a third of its strength: Engelhardt and others, 2000, DBBW.
--
-- Run     hinge run scripts/benchmarks/engelhardt_rbs.lua
-- Shows   loss of strength in cycles by Lignos and Krawinkler's backbone with wear (2011); nothing was fitted
-- Expect  strength within 1 % of the test in the cycles up to 0.04 rad, 7 % below it in the second at 0.04 rad, and
--         29 % below it in the second at 0.06 rad, where the test keeps two thirds of its strength
local hinge = require "hinge"

-- W36X150, half of the width cut; yield stress measured, mean by area; span: from the column's face to the point of no
-- moment. Its depth over its web, 57, is just outside of the tests behind the formulas (55).
local section, span = hinge.section.named "W36X150", 3.578
local steel = hinge.material { E = 200e9, yield_stress = 391.4e6 }
local backbone = hinge.backbone.lignos { section = section, material = steel, shear_span = span,
  unbraced_length = 2.5, reduced = true, cut = 0.0761, beyond_tests = true }
local steps, elements = 20, 2

-- Turns of the measured rotation of the beam, rad, and the greatest moment of the half cycle before each over that of
-- the test in its direction (2.27 and 2.42 MN m).
local turns = { 0.0024, -0.0022, 0.0024, -0.0022, 0.0024, -0.0022, 0.0024, -0.0022, 0.0076, -0.0065, 0.0078, -0.0072,
  0.0079, -0.0072, 0.0133, -0.0119, 0.0134, -0.0118, 0.0267, -0.0241, 0.0286, -0.0272, 0.0392, -0.0401, 0.0393, -0.0405,
  0.0576, -0.0568, 0.0598, -0.0599 }
local measured = { [9] = 0.89, [10] = 0.86, [15] = 0.96, [16] = 0.95, [19] = 1, [20] = 1, [21] = 0.93, [22] = 0.91,
  [23] = 0.85, [24] = 0.84, [25] = 0.77, [26] = 0.80, [27] = 0.76, [28] = 0.75, [29] = 0.68, [30] = 0.67 }

-- The moment at the face over the rotation of the chord, and the greatest moments of the half cycles, MN m.
local function bent(law)
  local model = hinge.model { displacement = "small" }
  local face, tip = model:node { 0, 0, 0 }, model:node { span, 0, 0 }
  local beam = model:member { face, tip, section = section, material = steel, up = { 0, 0, 1 }, elements = elements,
    backbone = law }
  model:fix(face)
  model:load { node = tip, force = { 0, 0, -1 } }
  local curve, peaks, most, run = { x = { 0 }, y = { 0 } }, {}, 0, nil
  for i, turn in ipairs(turns) do
    run = model:static { from = run, steps = steps, record = false,
      control = { node = tip, "uz", to = -turn * span } }
    peaks[i] = 0
    while run:step() do
      local M = beam:forces(run).Mx / 1e6
      curve.x[#curve.x + 1], curve.y[#curve.y + 1] = -select(3, tip:displacement(run)) / span, M
      peaks[i] = math.max(peaks[i], math.abs(M))
    end
    assert(run.verdict == "completed", run.reason)
    most = math.max(most, peaks[i])
  end
  return curve, peaks, most
end

return hinge.benchmark {
  title = "Beam with a reduced section, Engelhardt 2000", kind = "test", fast = true,
  source = "Engelhardt and others, 2000, DBBW, by the collections RESSLab-Team/resslab-hub-data and "
    .. "Le1gh/Le1gh.github.io, PZWeb",
  missing = "the distance between braces, taken as 2.5 m; where along the beam the moment was measured, so that "
    .. "moments are compared as parts of the greatest one; half of the elastic rotation, which the measured one "
    .. "has not",
  run = function(b, job)
    local curve, peaks, most = bent(backbone)
    local function row(what, first, tolerance)
      b:row { what, computed = (peaks[first] + peaks[first + 1]) / 2 / most,
        reference = (measured[first] + measured[first + 1]) / 2, tolerance = tolerance, elements = elements,
        steps = steps }
    end
    row("second cycle at 0.027 rad", 21, 0.015)
    row("first cycle at 0.040 rad", 23, 0.03)
    row("second cycle at 0.040 rad", 25, 0.13)
    row("second cycle at 0.060 rad", 29, 0.45)
    local test = { x = {}, y = {}, name = "test, each half cycle", style = "points" }
    for i, part in pairs(measured) do
      table.insert(test.x, turns[i])
      table.insert(test.y, turns[i] > 0 and part or -part)
    end
    for i, M in ipairs(curve.y) do curve.y[i] = M / most end
    curve.name = "Lignos and Krawinkler, RBS"
    job:plot({ series = { curve, test }, x_label = "rotation of the beam (rad)", y_label = "over the greatest moment",
      y_range = { -1.1, 1.5 }, title = "DBBW, W36X150 with a reduced section" }, "engelhardt_rbs.png")
  end,
}
