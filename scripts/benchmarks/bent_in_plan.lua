-- Beams that are bent in plan carry a load across their plane: bending and torsion, to first order.
--
-- Run     hinge run scripts/benchmarks/bent_in_plan.lua
-- Shows   an L-shaped cantilever, and one on a quarter of a circle; torsion of a solid square
-- Expect  L-shaped, arms a (from the wall) and c: P (a^3 + c^3) / (3 EI) + P a c^2 / GJ + P (a + c) / (k G A), and the
--         torque P c in the first arm. Quarter of a circle: P R^3 ((pi / 4) / EI + (3 pi / 4 - 2) / GJ), plus shear.
--         J of a square from Saint-Venant's series, 0.140577 b^4. Straight members are exact; the quarter of a circle
--         has an error of second order in the length of its members
local hinge = require "hinge"

local E, nu, side, P, a, c, R = 206e9, 0.3, 0.05, 1000, 1, 0.6, 1
local G, EI, A = E / (2 * (1 + nu)), E * side ^ 4 / 12, side ^ 2
local steel, square = hinge.material { E = E, nu = nu }, hinge.section.solid { width = side, depth = side }

local function torsional_stiffness()
  local sum = 0
  for k = 1, 99, 2 do
    local tanh = 1 - 2 / (math.exp(k * math.pi) + 1) -- of k pi / 2
    sum = sum + tanh / k ^ 5
  end
  return G * side ^ 4 / 3 * (1 - 192 / math.pi ^ 5 * sum)
end

-- Deflection of the last of these points under P, and the member at the wall with its run.
local function loaded(points)
  local model = hinge.model { displacement = "small" }
  local last, first
  for i, at in ipairs(points) do
    local node = model:node(at)
    if i == 1 then model:fix(node)
    else
      local member = model:member { last, node, section = square, material = steel, up = { 0, 0, 1 } }
      first = first or member
    end
    last = node
  end
  model:load { node = last, force = { 0, 0, -P } }
  local run = model:static { steps = 1 }:finish()
  return -1e3 * select(3, last:displacement(run)), first, run
end

local function quarter(members)
  local points = {}
  for i = 0, members do
    local angle = i / members * math.pi / 2
    points[i + 1] = { R * math.sin(angle), R * (1 - math.cos(angle)), 0 }
  end
  return (loaded(points))
end

return hinge.benchmark {
  title = "Cantilevers bent in plan", kind = "elastic", fast = true, source = "closed form, bending and torsion",
  run = function(b)
    local GJ, shear = torsional_stiffness(), 5 / 6 * G * A
    local found, first, run = loaded { { 0, 0, 0 }, { a, 0, 0 }, { a, c, 0 } }
    b:row { "L-shaped: deflection", computed = found, unit = "mm", elements = 4, tolerance = 1e-6,
      reference = 1e3 * P * ((a ^ 3 + c ^ 3) / (3 * EI) + a * c ^ 2 / GJ + (a + c) / shear) }
    b:row { "L-shaped: torque", computed = math.abs(first:forces(run).Mz), reference = P * c, unit = "N m",
      elements = 4, tolerance = 1e-6 }
    local exact = 1e3 * P * (R ^ 3 * (math.pi / 4 / EI + (3 * math.pi / 4 - 2) / GJ) + math.pi / 2 * R / shear)
    local coarse, fine = quarter(4), quarter(8)
    b:row { "quarter of a circle: deflection", computed = fine, reference = exact, unit = "mm", elements = 16,
      tolerance = 0.01 }
    b:row { "observed order, 8 to 16 elements", computed = math.log((coarse - exact) / (fine - exact), 2),
      reference = 2, elements = 16, tolerance = 0.02 }
  end,
}
