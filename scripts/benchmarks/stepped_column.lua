-- A stepped cantilever column: the lower half is four times as stiff as the upper one.
--
-- Run     hinge run scripts/benchmarks/stepped_column.lua
-- Shows   buckling of a column of two sections, with a load on its top, and with a second one at the step
-- Expect  a load on the top alone: tan u tan 2u = 2, so u = atan(1 / sqrt 2), P = 4 u^2 EI_1 / L^2.
--         Three quarters of the load at the step: P_1 = 4 P_2, and k = sqrt(P / EI) is the same in both halves
local hinge = require "hinge"
local root = require "hinge.library.numeric".root

local E, L, I1, I2 = 200e9, 10, 4e-6, 1e-6
local steel = hinge.material { E = E }
local function section(I)
  return hinge.section.general { area = 1e-2, Ix = I, Iy = 10 * I, J = I, shear_area_x = 0.1, shear_area_y = 0.1 }
end

-- The sum of the loads at which the column becomes unstable, in EI_1 / L^2; `part` of it acts at the step.
local function buckling(part, expected)
  local model = hinge.model { plasticity = false, elements_per_member = 2 }
  local foot, step, top = model:node { 0, 0, 0 }, model:node { 0, 0, L / 2 }, model:node { 0, 0, L }
  model:fix(foot)
  model:fix({ step, top }, "y,rx,rz")
  model:member { foot, step, section = section(I1), material = steel }
  model:member { step, top, section = section(I2), material = steel }
  local P = 1.5 * expected * E * I1 / L ^ 2
  model:load { node = top, force = { 0, 0, -(1 - part) * P } }
  if part > 0 then model:load { node = step, force = { 0, 0, -part * P } } end
  return 1.5 * expected * model:static { steps = 10, to_limit = true }:finish().instability.factor
end

-- The exact condition, with L = EI_1 = 1. w_1 and w_2 are the deflections of the lower and the upper half.
-- w_1 = C (1 - cos k1 x), where C = (P_2 f + P_s d) / P_1, f: deflection of the top, d: of the step;
-- w_2 = f - B sin k2 (1 - x). Both meet at x = 1/2 with the same slope. Returns the determinant of the two equations
-- in f and d.
local function determinant(P1, part)
  local P2, Ps = (1 - part) * P1, part * P1
  local k1, k2 = math.sqrt(P1), math.sqrt(P2 * I1 / I2)
  local u1, u2 = k1 / 2, k2 / 2
  local c = 1 - math.cos(u1)
  -- d = c (P2 f + Ps d) / P1 and k1 sin u1 (P2 f + Ps d) / P1 = k2 (f - d) / tan u2
  local a11, a12 = c * P2 / P1, c * Ps / P1 - 1
  local a21 = k1 * math.sin(u1) * P2 / P1 - k2 / math.tan(u2)
  local a22 = k1 * math.sin(u1) * Ps / P1 + k2 / math.tan(u2)
  return a11 * a22 - a12 * a21
end

local function lowest(part)
  local high = 0.02
  while (determinant(high, part) > 0) == (determinant(0.01, part) > 0) do high = high + 0.01 end
  return root(function(u) return determinant(u, part) end, high - 0.01, high)
end

return hinge.benchmark {
  title = "Stepped column", kind = "stability", fast = true,
  source = "closed form (S. P. Timoshenko, J. M. Gere, Theory of Elastic Stability, chapter 2)",
  run = function(b)
    local exact = 4 * math.atan(1 / math.sqrt(2)) ^ 2
    b:row { "P L^2 / EI_1, load on the top", computed = buckling(0, exact), reference = exact, tolerance = 1.5e-5,
      elements = 4, steps = 10 }
    local both = lowest(0.75)
    b:row { "sum P L^2 / EI_1, 3/4 at the step", computed = buckling(0.75, both), reference = both,
      tolerance = 1.5e-5, elements = 4, steps = 10 }
  end,
}
