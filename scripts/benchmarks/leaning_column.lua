-- A cantilever column holds a leaning one: the leaning column is pinned at both ends and pushes it to the side.
--
-- Run     hinge run scripts/benchmarks/leaning_column.lua
-- Shows   a load on a column that carries no moment makes the frame unstable all the same; joints by rigid links that
--         leave the rotations free
-- Expect  load P on the cantilever, Q on the leaning column, both h high: tan u / u = 1 + P / Q, u^2 = P h^2 / EI;
--         without P: Q = 3 EI / h^2
local hinge = require "hinge"
local root = require "hinge.library.numeric".root

local E, h, I = 200e9, 10, 1e-6
local steel = hinge.material { E = E }
local function section(factor)
  return hinge.section.general { area = 1e-2, Ix = factor * I, Iy = 10 * factor * I, J = I, shear_area_x = 0.1,
    shear_area_y = 0.1 }
end

-- The sum of both loads at which the frame becomes unstable, in EI / h^2; `part` of it acts on the leaning column.
local function buckling(part, expected)
  local model = hinge.model { plasticity = false, elements_per_member = 2 }
  local function node(x, z, follows)
    local made = model:node { x, 0, z }
    model:fix(made, follows and "rx,rz" or "y,rx,rz")
    return made
  end
  local foot, head = node(0, 0), node(0, h)
  local low, high = node(h, 0), node(h, h)
  local left, right = node(0, h, true), node(h, h, true) -- ends of the beam, which follow the heads
  model:fix(foot)
  model:fix(low, "x,z")
  model:member { foot, head, section = section(1), material = steel }
  model:member { low, high, section = section(20), material = steel } -- does not buckle by itself
  model:member { left, right, section = section(1), material = steel }
  model:rigid_link { from = head, to = left, dofs = "xyz" }
  model:rigid_link { from = high, to = right, dofs = "xyz" }
  local P = 1.5 * expected * E * I / h ^ 2
  if part < 1 then model:load { node = head, force = { 0, 0, -(1 - part) * P } } end
  model:load { node = high, force = { 0, 0, -part * P } }
  return 1.5 * expected * model:static { steps = 10, to_limit = true }:finish().instability.factor
end

-- (P + Q) h^2 / EI of tan u / u = 1 + P / Q.
local function exact(part)
  local u = root(function(v) return math.tan(v) / v - 1 / part end, 1e-6, math.pi / 2 - 1e-12)
  return u ^ 2 / (1 - part)
end

return hinge.benchmark {
  title = "Frame with a leaning column", kind = "stability", fast = true,
  source = "closed form: the beam-column's lateral stiffness P / (tan u / k - h) equals Q / h",
  run = function(b)
    for _, c in ipairs { { "Q h^2 / EI, load on the leaning one", 1, 3 },
      { "(P + Q) h^2 / EI, P = Q", 0.5, exact(0.5) }, { "(P + Q) h^2 / EI, P = 3 Q", 0.25, exact(0.25) } } do
      b:row { c[1], computed = buckling(c[2], c[3]), reference = c[3], tolerance = 2e-5, elements = 6, steps = 10 }
    end
  end,
}
