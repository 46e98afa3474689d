-- A pinned column on springs: one at midheight, and many along it.
--
-- Run     hinge run scripts/benchmarks/elastic_supports.lua
-- Shows   buckling with connectors to the ground; the mode changes with the stiffness of the springs
-- Expect  a spring c at midheight: (tan u - u) / u^3 = -16 EI / (c L^3), u = L / 2 sqrt(P / EI), and 4 P_E from
--         c = 16 pi^2 EI / L^3 on; a bed of springs k = 16 pi^4 EI / L^4: 8 P_E in two half waves
local hinge = require "hinge"
local root = require "hinge.library.numeric".root

local E, L, I = 200e9, 10, 1e-6
local euler = math.pi ^ 2 * E * I / L ^ 2
local section = hinge.section.general { area = 1e-2, Ix = I, Iy = 100 * I, J = I, shear_area_x = 0.1,
  shear_area_y = 0.1 }
local steel = hinge.material { E = E }

-- P / P_E of a column of so many members, two elements each, with a spring c (N/m) at each joint between them.
local function buckling(members, c, expected)
  local model = hinge.model { plasticity = false }
  local n = {}
  for i = 0, members do
    n[i] = model:node { 0, 0, L * i / members }
    model:fix(n[i], i == 0 and "x,y,z,rx,rz" or i == members and "x,y,rx,rz" or "y,rx,rz")
    if i > 0 then model:member { n[i - 1], n[i], section = section, material = steel } end
    if i > 0 and i < members then model:connector { n[i], ground = true, stiffness = { x = c } } end
  end
  model:load { node = n[members], force = { 0, 0, -1.5 * expected * euler } }
  local run = model:static { steps = 10, to_limit = true }:finish()
  return 1.5 * expected * run.instability.factor
end

-- P / P_E with the spring c at midheight, in EI / L^3.
local function one_spring(c)
  local u = root(function(v) return (math.tan(v) - v) / v ^ 3 + 16 / c end, math.pi / 2 + 1e-9, math.pi)
  return (2 * u / math.pi) ^ 2
end

return hinge.benchmark {
  title = "Column on elastic supports", kind = "stability", fast = true,
  source = "closed form (S. P. Timoshenko, J. M. Gere, Theory of Elastic Stability, chapter 2)",
  run = function(b)
    local stiff = 8 * math.pi ^ 2
    local exact = one_spring(stiff)
    b:row { "P / P_E, one spring, 8 pi^2 EI / L^3", computed = buckling(2, stiff * E * I / L ^ 3, exact),
      reference = exact, tolerance = 2e-5, elements = 4, steps = 10 }
    b:row { "P / P_E, one spring, 2.02 times that", computed = buckling(2, 2.02 * stiff * E * I / L ^ 3, 4),
      reference = 4, tolerance = 2e-5, elements = 4, steps = 10 }
    local count = 16
    local bed = 16 * math.pi ^ 4 * E * I / L ^ 4
    b:row { "P / P_E on a bed of 15 springs", computed = buckling(count, bed * L / count, 8), reference = 8,
      tolerance = 5e-5, elements = 2 * count, steps = 10 }
  end,
}
