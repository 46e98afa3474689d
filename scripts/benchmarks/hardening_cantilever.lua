-- A cantilever whose plastic zone spreads along it: bilinear hardening.
--
-- Run     hinge run scripts/benchmarks/hardening_cantilever.lua
-- Shows   plastic zones made of the ends of elements, each of which stands for half of its element
-- Expect  beyond Mp the curvature grows by (M - Mp) / (H I), H the modulus of hardening. With M = 2 Mp at the root half
--         of the cantilever yields, and the areas of the diagram of curvatures give the tip: M L^2 / 3 EI + (M - Mp) /
--         (H I) L / 4 (L - L / 6). The plastic work is the integral of (M - Mp) (M + Mp) / 2 H I along the
--         zone. Half of an element at its full moment is a trapezoidal rule: the error falls with the square of the
--         length.
local hinge = require "hinge"

local E, fy, L = 210e9, 235e6, 3
local H = E / 20
local section = hinge.section.solid { width = 0.1, depth = 0.15, interaction = "exact" }
local steel = hinge.material { E = E, G = 1e15, yield_stress = fy, hardening = { modulus = H } }
local Mp, I = fy * section.Zx, section.Ix

-- Deflection of the tip under 2 Mp / L, and what has been dissipated and stored by hardening.
local function loaded(elements)
  local model = hinge.model { displacement = "small" }
  local root, tip = model:node { 0, 0, 0 }, model:node { L, 0, 0 }
  model:fix(root)
  model:member { root, tip, section = section, material = steel, up = { 0, 0, 1 }, elements = elements }
  model:load { node = tip, force = { 0, 0, 2 * Mp / L } }
  local run = model:static { steps = 40 }:finish()
  return select(3, tip:displacement(run)), run.energy.plastic
end

return hinge.benchmark {
  title = "Cantilever with a plastic zone", kind = "inelastic", fast = true, source = "closed form: moment areas",
  run = function(b)
    local zone = L / 2
    local tip = 2 * Mp * L ^ 2 / (3 * E * I) + 0.5 * Mp / (H * I) * zone * (L - zone / 3)
    -- (M^2 - Mp^2) / 2 H I over the zone, M from Mp to 2 Mp: its mean is 4 / 3 Mp^2
    local work = 4 / 3 * Mp ^ 2 / (2 * H * I) * zone
    local off, most = {}, nil
    for _, n in ipairs { 8, 16, 32 } do
      local u, dissipated = loaded(n)
      off[n], most = u - tip, dissipated
      if n ~= 16 then
        b:row { ("deflection of the tip, %d elements"):format(n), computed = u, reference = tip, unit = "m",
          tolerance = n == 8 and 0.016 or 1e-3, elements = n, steps = 40 }
      end
    end
    local order = math.log(off[8] / off[32]) / math.log(4)
    b:row { "observed order, 8 to 16 to 32 elements", computed = order, reference = 2, tolerance = 1e-3, elements = 32,
      steps = 40 }
    b:row { "plastic work, 32 elements", computed = most, reference = work, unit = "J", tolerance = 1e-3, elements = 32,
      steps = 40 }
  end,
}
