-- How large is the error of elements with one integration point in their middle? It has a closed form.
--
-- Run     hinge run scripts/benchmarks/midpoint_integration.lua
-- Shows   the conventional formulation, and asi before any hinge, to first order. The rows hold the error of the method
--         itself against its closed form, not against the exact deflection
-- Expect  n elements of a member that is bent by Ma and Mb at its ends: twice the strain energy is too small by
--         L (Mb - Ma)^2 / (12 n^2 EI). So the bending part of a cantilever's deflection is short by 1 / (4 n^2), that
--         of a member that sways without rotation at its ends by 1 / n^2. For the paper's space frame (reconstructed: a
--         cube of 0.25 m, bars of 20 mm, 8 kN) the same is taken off each member's flexibility in 24 equations that
--         were solved apart: 1.654190 and 2.022626 mm with two and four elements, 2.143364 mm exact (asi-gauss)
local hinge = require "hinge"
local space_frame = require "hinge.models.space_frame"

local E, side, L, P = 206e9, 0.05, 1, 1000
local EI, shear = E * side ^ 4 / 12, 5 / 6 * E / 2.6 * side ^ 2

-- Deflection of the tip under P. held: what is held at the tip.
local function deflection(formulation, n, held)
  local model = hinge.model { formulation = formulation, displacement = "small", elements_per_member = n }
  local wall, tip = model:node { 0, 0, 0 }, model:node { L, 0, 0 }
  model:fix(wall)
  if held then model:fix(tip, held) end
  model:member { wall, tip, section = hinge.section.solid { width = side, depth = side },
    material = hinge.material { E = E, nu = 0.3 } }
  model:load { node = tip, force = { 0, 0, -P } }
  return -select(3, tip:displacement(model:static { steps = 1 }:finish()))
end

-- Displacement of the loaded corner of the space frame under 8 kN.
local function corner(formulation, n)
  local model = hinge.model { formulation = formulation, displacement = "small", elements_per_member = n,
    plasticity = false }
  local frame = space_frame.add(model)
  model:load { node = frame.loaded, force = { 8000, 0, 0 } }
  return (frame.loaded:displacement(model:static { steps = 1 }:finish()))
end

return hinge.benchmark {
  title = "Midpoint integration", kind = "elastic", fast = true,
  source = "closed form of the method's own error; 24 equations solved apart for the space frame",
  run = function(b)
    local bending, by_shear = P * L ^ 3 / (3 * EI), P * L / shear
    for _, row in ipairs { { "conventional", 1 }, { "conventional", 4 }, { "asi", 4 } } do
      local formulation, n = table.unpack(row)
      b:row { ("cantilever, %s, n = %d"):format(formulation, n), unit = "mm",
        computed = 1000 * deflection(formulation, n),
        reference = 1000 * (bending * (1 - 1 / (4 * n ^ 2)) + by_shear), elements = n, tolerance = 1e-6 }
    end
    b:row { "swaying member, conventional", computed = 1000 * deflection("conventional", 2, "rx,ry,rz"), unit = "mm",
      reference = 1000 * (bending / 4 * (1 - 1 / 2 ^ 2) + by_shear), elements = 2, tolerance = 1e-6 }
    for _, row in ipairs { { "conventional", 2, 1.654190 }, { "conventional", 4, 2.022626 },
      { "asi-gauss", 2, 2.143364 } } do
      b:row { ("space frame, %s, n = %d"):format(row[1], row[2]), computed = 1000 * corner(row[1], row[2]), unit = "mm",
        reference = row[3], elements = row[2], tolerance = 1e-6 }
    end
  end,
}
