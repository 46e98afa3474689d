-- A thin ring is pulled apart by two opposite forces, to first order.
--
-- Run     hinge run scripts/benchmarks/ring.lua
-- Shows   a curved structure of straight members, and the order of convergence
-- Expect  (pi / 4 - 2 / pi) P R^3 / EI along the forces, (2 / pi - 1 / 2) P R^3 / EI across them, and the moment
--         P R / pi at the forces (S. Timoshenko, Strength of Materials, thin ring). The corners of the polygon lie on
--         the circle, so the error is of second order in the length of the members
local hinge = require "hinge"

local E, R, P, side = 206e9, 1, 0.1, 0.002
local EI = E * side ^ 4 / 12

-- How much wider the ring is along the forces, how much narrower across, and the moment at a force.
local function pulled(members)
  local model = hinge.model { displacement = "small" }
  local steel, square = hinge.material { E = E }, hinge.section.solid { width = side, depth = side }
  local nodes, first = {}, nil
  for i = 0, members do
    local angle = 2 * math.pi * i / members
    nodes[i] = i == members and nodes[0] or model:node { R * math.sin(angle), 0, -R * math.cos(angle) }
    if i > 0 then
      local made = model:member { nodes[i - 1], nodes[i], section = square, material = steel, up = { 0, 1, 0 } }
      first = first or made
    end
  end
  model:fix(nodes[0])
  model:load { node = nodes[members // 2], force = { 0, 0, P } }
  local run = model:static { steps = 1 }:finish()
  local right, left = nodes[members // 4]:displacement(run), nodes[3 * members // 4]:displacement(run)
  local ends = first:forces(run)
  return { select(3, nodes[members // 2]:displacement(run)), left - right, math.sqrt(ends.Mx ^ 2 + ends.My ^ 2) }
end

return hinge.benchmark {
  title = "Ring under two opposite forces", kind = "elastic", fast = true, source = "closed form, thin ring",
  run = function(b)
    local exact = { (math.pi / 4 - 2 / math.pi) * P * R ^ 3 / EI, (2 / math.pi - 1 / 2) * P * R ^ 3 / EI,
      P * R / math.pi }
    local coarse, fine = pulled(16), pulled(32)
    for k, name in ipairs { "wider along the forces", "narrower across them", "moment at a force" } do
      b:row { name, computed = 1e3 * fine[k], reference = 1e3 * exact[k], unit = k < 3 and "mm" or "N mm",
        elements = 64, tolerance = ({ 0.015, 0.015, 0.006 })[k] }
    end
    b:row { "observed order, 32 to 64 elements", computed = math.log((coarse[1] - exact[1]) / (fine[1] - exact[1]), 2),
      reference = 2, elements = 64, tolerance = 0.05 }
  end,
}
