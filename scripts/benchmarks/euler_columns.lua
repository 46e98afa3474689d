-- Columns buckle at Euler's load in the four classical cases, with two elements a member.
--
-- Run     hinge run scripts/benchmarks/euler_columns.lua
-- Shows   pairs of elements have the stability functions of the exact beam-column, so that two elements are enough;
--         a column that is clamped at both ends and cannot sway takes four. With p_delta = "chord", the paper's way,
--         the error falls with the square of the number of elements
-- Expect  all four within 0.01 % of n pi^2 EI / L^2, n = 1, 1/4, 2.0457, 4
local hinge = require "hinge"
local root = require "hinge.library.numeric".root

local E, L, I = 200e9, 10, 1e-6
local euler = math.pi ^ 2 * E * I / L ^ 2
-- L / r = 1000 and large shear areas: what Euler leaves out, shortening and shear, is 1e-5 here.
local section = hinge.section.general { area = 1e-2, Ix = I, Iy = 10 * I, J = I, shear_area_x = 0.1,
  shear_area_y = 0.1 }

-- The load at which a column with these supports becomes unstable, over pi^2 EI / L^2.
local function buckling(foot, head, expected, elements, p_delta)
  local model = hinge.model { plasticity = false, elements_per_member = elements, p_delta = p_delta }
  local a, b = model:node { 0, 0, 0 }, model:node { 0, 0, L }
  model:fix({ a, b }, "y,rx,rz")
  model:fix(a, foot)
  if head then model:fix(b, head) end
  model:member { a, b, section = section, material = hinge.material { E = E } }
  local steps = 10
  model:load { node = b, force = { 0, 0, -1.5 * expected * euler } }
  local run = model:static { steps = steps, to_limit = true }:finish()
  return 1.5 * expected * run.instability.factor, steps
end

-- x of tan x = x: the column that is clamped and pinned buckles at (x / pi)^2.
local function clamped_and_pinned()
  return (root(function(x) return math.tan(x) - x end, math.pi, 1.5 * math.pi - 1e-9) / math.pi) ^ 2
end

return hinge.benchmark {
  title = "Euler's columns", kind = "stability", fast = true,
  source = "closed form (Euler 1744; S. P. Timoshenko, J. M. Gere, Theory of Elastic Stability, chapter 2)",
  run = function(b)
    for _, c in ipairs {
      { "P / P_E, pinned", "x,z", "x", 1, 2 }, { "P / P_E, cantilever", "all", nil, 0.25, 2 },
      { "P / P_E, clamped and pinned", "all", "x", clamped_and_pinned(), 2 },
      { "P / P_E, clamped at both ends", "all", "x,ry", 4, 4 },
    } do
      local found, steps = buckling(c[2], c[3], c[4], c[5])
      b:row { c[1], computed = found, reference = c[4], tolerance = 5e-5, elements = c[5], steps = steps }
    end
    local e = {}
    for _, elements in ipairs { 4, 8, 16 } do e[elements] = buckling("x,z", "x", 1, elements, "chord") - 1 end
    b:row { "order, pinned, chord, 4 to 8 elements", computed = math.log(e[4] / e[8], 2), reference = 2,
      tolerance = 0.06, elements = 8, steps = 10 }
    b:row { "order, pinned, chord, 8 to 16", computed = math.log(e[8] / e[16], 2), reference = 2, tolerance = 0.015,
      elements = 16, steps = 10 }
  end,
}
