-- A bend of 45 degrees goes out of its plane under a load at its tip.
--
-- Run     hinge run scripts/benchmarks/bend_45.lua
-- Shows   bending about two axes and torsion together, with large rotations in space
-- Expect  the problem of K. J. Bathe and S. Bolourchi, Int. J. Numer. Meth. Eng. 14 (1979): radius 100, section 1 x 1,
--         E = 1e7, nu = 0, load 600. With J = 1/6 the tip moves by (-23.5606, -13.6046, 53.4755), computed apart by
--         shooting on a rod that stretches, shears, bends and twists (Runge-Kutta, 400 steps). With J = 0.1406, that of
--         a square, V. Sonneville, A. Cardona and O. Brüls (2014) have 53.610 out of the plane. Straight members stand
--         on the arc, so the error is of second order in their length
local hinge = require "hinge"

local R, steps = 100, 12

-- The displacement of the tip. x: along the bend at its clamped end, y: towards its centre, z: out of its plane.
local function tip_of(J, members)
  local model = hinge.model { plasticity = false }
  local material = hinge.material { E = 1e7, nu = 0 }
  local section = hinge.section.general { area = 1, Ix = 1 / 12, Iy = 1 / 12, J = J }
  local last
  for i = 0, members do
    local angle = i / members * math.pi / 4
    local node = model:node { R * math.sin(angle), R * (1 - math.cos(angle)), 0 }
    if last then model:member { last, node, section = section, material = material, up = { 0, 0, 1 } }
    else model:fix(node) end
    last = node
  end
  model:load { node = last, force = { 0, 0, 600 } }
  return { last:displacement(model:static { steps = steps }:finish()) }
end

return hinge.benchmark {
  title = "Bend of 45 degrees under a load out of its plane", kind = "elastic", fast = true,
  source = "Bathe and Bolourchi's problem; shooting on the exact rod, and Sonneville et al. 2014",
  run = function(b)
    local exact, coarse, fine = { -23.5606, -13.6046, 53.4755 }, tip_of(1 / 6, 4), tip_of(1 / 6, 8)
    for k, name in ipairs { "along the bend", "towards the centre", "out of the plane" } do
      b:row { name .. ", J = 1/6", computed = fine[k], reference = exact[k], unit = "m", elements = 16, steps = steps,
        tolerance = ({ 2e-4, 0.007, 0.0015 })[k] }
    end
    b:row { "out of the plane, J = 0.1406", computed = tip_of(0.1406, 8)[3], reference = 53.610, unit = "m",
      elements = 16, steps = steps, tolerance = 0.002 }
    b:row { "observed order, 8 to 16 elements", computed = math.log((coarse[3] - exact[3]) / (fine[3] - exact[3]), 2),
      reference = 2, elements = 16, steps = steps, tolerance = 0.01 }
  end,
}
