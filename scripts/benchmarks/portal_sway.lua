-- A portal sways to the side under the loads on its columns.
--
-- Run     hinge run scripts/benchmarks/portal_sway.lua
-- Shows   buckling of a frame with two elements a member, on pinned and on clamped feet
-- Expect  pinned feet: u tan u = 6, clamped feet: u / tan u = -6, with u^2 = P h^2 / EI; columns and beam are alike
local hinge = require "hinge"
local root = require "hinge.library.numeric".root

local E, h, I = 200e9, 10, 1e-6
local section = hinge.section.general { area = 1e-2, Ix = I, Iy = 10 * I, J = I, shear_area_x = 0.1,
  shear_area_y = 0.1 } -- L / r = 1000: shortening and shear do not count

-- The load on each column at which the portal becomes unstable, in EI / h^2.
local function buckling(foot, expected, elements)
  local model = hinge.model { plasticity = false, elements_per_member = elements }
  local n = {}
  for i, at in ipairs { { 0, 0, 0 }, { 0, 0, h }, { h, 0, h }, { h, 0, 0 } } do
    n[i] = model:node(at)
    model:fix(n[i], (i == 1 or i == 4) and foot or "y,rx,rz")
  end
  for i = 1, 3 do
    model:member { n[i], n[i + 1], section = section, material = hinge.material { E = E } }
  end
  local P = 1.5 * expected * E * I / h ^ 2
  for i = 2, 3 do model:load { node = n[i], force = { 0, 0, -P } } end
  local run = model:static { steps = 10, to_limit = true }:finish()
  return 1.5 * expected * run.instability.factor
end

return hinge.benchmark {
  title = "Sway buckling of a portal", kind = "stability", fast = true,
  source = "closed form by slope deflection (S. P. Timoshenko, J. M. Gere, Theory of Elastic Stability, chapter 2)",
  run = function(b)
    local pinned = root(function(u) return u * math.tan(u) - 6 end, 0.1, math.pi / 2 - 1e-9) ^ 2
    local clamped = root(function(u) return u / math.tan(u) + 6 end, math.pi / 2, math.pi - 1e-9) ^ 2
    b:row { "P h^2 / EI, pinned feet", computed = buckling("x,y,z,rx,rz", pinned, 2), reference = pinned,
      tolerance = 1.5e-5, elements = 6, steps = 10 }
    b:row { "P h^2 / EI, clamped feet", computed = buckling("all", clamped, 2), reference = clamped,
      tolerance = 1.5e-5, elements = 6, steps = 10 }
  end,
}
