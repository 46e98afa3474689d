-- Frame 1 of Ziemian and Ziemian: a portal with fixed feet, 30 ft wide and 15 ft high.
--
-- Run     hinge run scripts/benchmarks/ziemian_1.lua
-- Shows   first-order and second-order elastic analysis of a frame that leans by 1/500, with 0.8 E
-- Expect  published: first order within 0.01 %, second order within 0.3 %. The second-order values that were published
--         are of another program; an analysis made apart from both gives 1.1924, 1.1654 in and 2426.84 kip in
local hinge = require "hinge"

local inch, kip, ksi = hinge.units.inch, hinge.units.kip, hinge.units.ksi
local steel = hinge.material { E = 0.8 * 29000 * ksi }
-- The members of the reference have no shear deformation: the shear areas are 1000 times the area.
local function section(A, I)
  A, I = A * inch ^ 2, I * inch ^ 4
  return hinge.section.general { area = A, Ix = I, Iy = I, J = I, shear_area_x = 1000 * A, shear_area_y = 1000 * A }
end

-- The sway of both eaves and the moment at the left foot.
local function frame(displacement, steps)
  local model = hinge.model { displacement = displacement, plasticity = false }
  local n = {}
  for i, at in ipairs { { 0, 0 }, { 0, 180 }, { 360, 180 }, { 360, 0 } } do
    n[i] = model:node { (at[1] + at[2] / 500) * inch, 0, at[2] * inch }
    model:fix(n[i], (i == 1 or i == 4) and "all" or "y,rx,rz")
  end
  local column, beam = section(20.0, 722), section(10.3, 510) -- W14x68, W18x35
  for i = 1, 3 do model:member { n[i], n[i + 1], section = i == 2 and beam or column, material = steel } end
  model:load { node = n[2], force = { 34.849 * kip, 0, -348.49 * kip } }
  model:load { node = n[3], force = { 0, 0, -348.49 * kip } }
  model:static { steps = steps }:finish()
  local left, right = n[2]:displacement(), n[3]:displacement()
  return left / inch, right / inch, math.abs(select(5, n[1]:reaction())) / (kip * inch)
end

return hinge.benchmark {
  title = "Ziemian and Ziemian 2021, frame 1", kind = "stability", fast = true,
  source = "C. W. Ziemian, R. D. Ziemian, J. Constr. Steel Res. 186 (2021); E 23,200 ksi, out of plumb 1/500",
  run = function(b)
    local first = { frame("small", 1) }
    b:row { "1st order, left eave u", computed = first[1], reference = 1.04501, unit = "in", tolerance = 4e-5,
      elements = 6 }
    b:row { "1st order, left base moment", computed = first[3], reference = 2177.81, unit = "kip in",
      tolerance = 1e-5, elements = 6 }
    local second = { frame("large", 5) }
    b:row { "2nd order, left eave u", computed = second[1], reference = 1.1908, unit = "in", tolerance = 3e-3,
      elements = 6, steps = 5 }
    b:row { "2nd order, right eave u", computed = second[2], reference = 1.1638, unit = "in", tolerance = 3e-3,
      elements = 6, steps = 5 }
    b:row { "2nd order, left base moment", computed = second[3], reference = 2427.99, unit = "kip in",
      tolerance = 3e-3, elements = 6, steps = 5 }
  end,
}
