-- A helical spring is pulled along its axis, to first order.
--
-- Run     hinge run scripts/benchmarks/helical_spring.lua
-- Shows   members in all directions of space; torsion with a share of bending
-- Expect  the pull acts on the axis, as through a rigid arm, so each section has the torque P R cos a and the moment
--         P R sin a, a being the slope of the wire. By Castigliano the deflection is
--         P R^2 s (cos^2 a / GJ + sin^2 a / EI) + P s (cos^2 a / (k G A) + sin^2 a / EA), s the length of the wire. For
--         a small slope this is 64 P R^3 n / (G d^4). The straight members have an error of second order
local hinge = require "hinge"

local E, nu, d, R, turns, slope, P = 206e9, 0.3, 0.01, 0.08, 4, math.rad(8), 100
local G, area, I = E / (2 * (1 + nu)), math.pi * d ^ 2 / 4, math.pi * d ^ 4 / 64
local wire = hinge.section.round { diameter = d }

-- Deflection along the axis, m, with so many members a turn.
local function pulled(members)
  local model = hinge.model { displacement = "small" }
  local steel, n, last = hinge.material { E = E, nu = nu }, members * turns, nil
  for i = 0, n do
    local angle = 2 * math.pi * i / members
    local node = model:node { R * math.cos(angle), R * math.sin(angle), R * angle * math.tan(slope) }
    if last then model:member { last, node, section = wire, material = steel } else model:fix(node) end
    last = node
  end
  -- P at the axis is P at the end of the wire with its moment, and the axis moves along with the end's rotation
  model:load { node = last, force = { 0, 0, P }, moment = { -P * last.y, P * last.x, 0 } }
  local _, _, uz, rx, ry = last:displacement(model:static { steps = 1 }:finish())
  return uz - rx * last.y + ry * last.x
end

return hinge.benchmark {
  title = "Helical spring", kind = "elastic", fast = true, source = "closed form, Castigliano",
  run = function(b)
    local c, s, k = math.cos(slope) ^ 2, math.sin(slope) ^ 2, wire.shear_area_x / area
    local length = 2 * math.pi * R * turns / math.cos(slope)
    local exact = P * length * (R ^ 2 * (c / (2 * G * I) + s / (E * I)) + c / (k * G * area) + s / (E * area))
    local coarse, fine = pulled(16), pulled(32)
    b:row { "deflection, 32 members a turn", computed = 1e3 * fine, reference = 1e3 * exact, unit = "mm",
      elements = 64 * turns, tolerance = 0.01 }
    b:row { "observed order, 16 to 32 members", computed = math.log((coarse - exact) / (fine - exact), 2),
      reference = 2, elements = 64 * turns, tolerance = 0.02 }
  end,
}
