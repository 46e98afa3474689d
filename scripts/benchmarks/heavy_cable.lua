-- A wire between two fixed ends sags under its own weight: the elastic catenary.
--
-- Run     hinge run scripts/benchmarks/heavy_cable.lua
-- Shows   large displacement of a structure that has next to no stiffness until it hangs
-- Expect  with the length L of the wire without load as long as the span, the horizontal force H follows from
--         L / 2 = H / w asinh(w L / 2 H) + H L / (2 EA), and the sag is w L^2 / (8 EA) + H / w (sqrt(1 + (w L / 2 H)^2)
--         - 1) (H. M. Irvine, Cable Structures, chapter 1). The middle is driven to this sag: the weight that this
--         takes is 1. Under load control statics finds no equilibrium from the straight wire without tension; its
--         message names this control. The error is of second order in the length of the members
local hinge = require "hinge"
local root = require "hinge.library.numeric".root

local E, area, L, w, g, steps = 160e9, 1e-4, 100, 8, 9.80665, 10 -- w: N/m
local EA = E * area

local function exact()
  local function half(H) -- the wire's length as it hangs
    local x = w * L / 2 / H
    return H / w * math.log(x + math.sqrt(x ^ 2 + 1)) + H * L / (2 * EA)
  end
  local H = root(function(H) return half(H) - L / 2 end, 1, 1e7)
  return H, w * L ^ 2 / (8 * EA) + H / w * (math.sqrt(1 + (w * L / 2 / H) ^ 2) - 1)
end

-- The part of its weight, and the horizontal force, at which the wire of so many elements has this sag.
local function hung(elements, sag)
  local model, nodes, n = hinge.model { plasticity = false }, {}, elements // 2
  local steel = hinge.material { E = E, density = w / g / area }
  local wire = hinge.section.general { area = area, Ix = 1e-10, Iy = 1e-10, J = 2e-10 }
  for i = 0, n do
    nodes[i] = model:node { i / n * L, 0, 0 }
    if i > 0 then model:member { nodes[i - 1], nodes[i], section = wire, material = steel } end
  end
  model:fix({ nodes[0], nodes[n] }, "x,y,z,rx,rz")
  model:gravity { 0, 0, -g }
  local run = model:static { steps = steps, control = { node = nodes[n // 2], "uz", to = -sag } }:finish()
  return run.factor, math.abs(nodes[0]:reaction(run))
end

return hinge.benchmark {
  title = "Heavy cable", kind = "elastic", fast = true, source = "closed form, elastic catenary (Irvine)",
  run = function(b)
    local H, sag = exact()
    local coarse = hung(16, sag)
    local factor, force = hung(32, sag)
    b:row { "part of its weight at the exact sag", computed = factor, reference = 1, elements = 32, steps = steps,
      tolerance = 0.003 }
    b:row { "horizontal force there", computed = force, reference = H, unit = "N", elements = 32, steps = steps,
      tolerance = 0.006 }
    b:row { "observed order, 16 to 32 elements", computed = math.log((coarse - 1) / (factor - 1), 2), reference = 2,
      elements = 32, steps = steps, tolerance = 0.08 }
  end,
}
