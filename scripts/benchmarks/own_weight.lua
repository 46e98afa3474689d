-- A cantilever column buckles under its own weight.
--
-- Run     hinge run scripts/benchmarks/own_weight.lua
-- Shows   an axial force that grows along a member; it is constant in each pair of elements, so that two
--         elements are 14 % too low, and the error falls with the square of their number
-- Expect  q L^3 / EI = 7.8373: J_(-1/3)(2/3 sqrt(q L^3 / EI)) = 0
local hinge = require "hinge"
local root = require "hinge.library.numeric".root

local E, L, I, A = 200e9, 10, 1e-6, 1e-2
local section = hinge.section.general { area = A, Ix = I, Iy = 10 * I, J = I, shear_area_x = 0.1, shear_area_y = 0.1 }
local gravity = 9.80665

-- The first zero of the series of J_(-1/3) with x = 2/3 sqrt(c): the sum of (-c / 9)^k / (k! (2/3) (5/3) ...).
local function exact()
  local function sum(c)
    local total, term = 1, 1
    for k = 1, 30 do
      term = -term * c / 9 / (k * (k - 1 / 3))
      total = total + term
    end
    return total
  end
  return root(sum, 1, 20)
end

-- q L^3 / EI at which the column becomes unstable.
local function buckling(elements, expected)
  local model = hinge.model { plasticity = false, elements_per_member = elements }
  local foot, top = model:node { 0, 0, 0 }, model:node { 0, 0, L }
  model:fix(foot)
  model:fix(top, "y,rx,rz")
  local density = 1.5 * expected * E * I / L ^ 3 / (A * gravity)
  model:member { foot, top, section = section, material = hinge.material { E = E, density = density } }
  model:gravity { 0, 0, -gravity }
  return 1.5 * expected * model:static { steps = 10, to_limit = true }:finish().instability.factor
end

return hinge.benchmark {
  title = "Column under its own weight", kind = "stability", fast = true,
  source = "closed form (A. G. Greenhill 1881; S. P. Timoshenko, J. M. Gere, Theory of Elastic Stability, chapter 2)",
  run = function(b)
    local c = exact()
    local found = {}
    for _, o in ipairs { { 2, 0.2 }, { 4, 0.06 }, { 8, 0.015 }, { 16, 4e-3 } } do
      found[o[1]] = buckling(o[1], c)
      b:row { ("q L^3 / EI, %d elements"):format(o[1]), computed = found[o[1]], reference = c, tolerance = o[2],
        elements = o[1], steps = 10 }
    end
    b:row { "order, 4 to 8 to 16 elements", reference = 2, tolerance = 0.02, elements = 16, steps = 10,
      computed = math.log((found[4] - found[8]) / (found[8] - found[16]), 2) }
  end,
}
