-- Argyris' right-angle frame: two thin legs under equal moments at their feet in the frame's plane buckle sideways.
--
-- Run     hinge run scripts/benchmarks/argyris_frame.lua
-- Shows   lateral-torsional buckling of a frame; bending and torsion meet at the corner
-- Expect  M_cr = pi / L sqrt(EI GJ) = 622.2 N mm. A foot slides along the line through both feet and turns about the
--         normal of the frame's plane; it is held in all other ways
local hinge = require "hinge"

local E, nu, L, t, width = 71240e6, 0.31, 0.24, 0.6e-3, 30e-3
local I, J = width * t ^ 3 / 12, width * t ^ 3 / 3
local section = hinge.section.general { area = width * t, Ix = t * width ^ 3 / 12, Iy = I, J = J }
local exact = math.pi / L * math.sqrt(E * I * E / (2 * (1 + nu)) * J)

-- The moment, N m, at which the frame becomes unstable. sign: the way of the moments.
local function buckling(elements, sign)
  local model = hinge.model { plasticity = false, elements_per_member = elements }
  local steel = hinge.material { E = E, nu = nu }
  local s = L / math.sqrt(2)
  local left, corner, right = model:node { -s, 0, 0 }, model:node { 0, 0, s }, model:node { s, 0, 0 }
  model:fix({ left, right }, "y,z,rx,rz")
  model:fix(corner, "x")
  for _, ends in ipairs { { left, corner }, { corner, right } } do
    -- the section's depth of 30 mm lies in the frame's plane
    local dx, dz = ends[2].x - ends[1].x, ends[2].z - ends[1].z
    model:member { ends[1], ends[2], section = section, material = steel, up = { -dz, 0, dx } }
  end
  for node, side in pairs { [left] = 1, [right] = -1 } do
    model:load { node = node, moment = { 0, sign * side * 1.5 * exact, 0 } }
  end
  return 1.5 * exact * model:static { steps = 20, to_limit = true }:finish().instability.factor
end

return hinge.benchmark {
  title = "Lateral buckling of Argyris' right-angle frame", kind = "stability", fast = true,
  source = "closed form; problem: J. H. Argyris et al., Comput. Methods Appl. Mech. Eng. 20 (1979)",
  missing = "warping, which a narrow rectangle has almost none of",
  run = function(b)
    local M = {}
    for _, elements in ipairs { 8, 16, 32 } do M[elements] = buckling(elements, 1) end
    for _, o in ipairs { { "one way", M[32] }, { "the other way", buckling(32, -1) } } do
      b:row { "M_cr, moments " .. o[1], computed = o[2] * 1e3, reference = exact * 1e3, unit = "N mm",
        tolerance = 1.5e-3, elements = 64, steps = 20 }
    end
    b:row { "order, 16 to 32 to 64 elements", computed = math.log((M[8] - M[16]) / (M[16] - M[32]), 2), reference = 2,
      tolerance = 0.02, elements = 64, steps = 20 }
  end,
}
