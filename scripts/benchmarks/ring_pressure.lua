-- A ring under pressure buckles into an ellipse: pressure that stays normal to it, and pressure of fixed direction.
--
-- Run     hinge run scripts/benchmarks/ring_pressure.lua
-- Shows   loads along members in their own axes, which turn with the elements; a quarter with its planes of symmetry
-- Expect  3 EI / R^3 for pressure that stays normal, 4 EI / R^3 for pressure of fixed direction, within 0.3 %. It is
--         the load at which a small ellipse grows without bound. run.instability tells of it for a perfect ring
local hinge = require "hinge"

local E, R, I, A = 200e9, 1, 1e-10, 1e-2 -- R / r = 10,000: the ring does not get shorter
local section = hinge.section.general { area = A, Ix = I, Iy = 1e3 * I, J = I, shear_area_x = 0.1,
  shear_area_y = 0.1 }
local steel = hinge.material { E = E }

-- A quarter of a ring whose radius differs by `ellipse`, under the pressure p in EI / R^3, and its first node.
local function quarter(members, axes, p, ellipse)
  local model, n = hinge.model { plasticity = false }, {}
  for i = 0, members do
    local t = math.pi / 2 * i / members
    local r = R * (1 + ellipse * math.cos(2 * t))
    n[i] = model:node { r * math.cos(t), 0, r * math.sin(t) }
    model:fix(n[i], i == 0 and "y,z,rx,ry,rz" or i == members and "x,y,rx,ry,rz" or "y,rx,rz")
    if i > 0 then
      local dx, dz = n[i].x - n[i - 1].x, n[i].z - n[i - 1].z
      local out = { dz / math.sqrt(dx ^ 2 + dz ^ 2), 0, -dx / math.sqrt(dx ^ 2 + dz ^ 2) }
      local q = p * E * I / R ^ 3
      model:load { axes = axes, q = axes == "local" and { 0, -q, 0 } or { -q * out[1], 0, -q * out[3] },
        member = model:member { n[i - 1], n[i], section = section, material = steel, up = out } }
    end
  end
  return model, n[0]
end

-- The pressure at which the displacement u grows without bound: p / u falls to 0 in a line (R. V. Southwell 1932).
local function critical(members, axes, expected)
  local p, inverse = {}, {}
  for i, part in ipairs { 0.8, 0.9 } do
    p[i] = part * expected
    local model, node = quarter(members, axes, p[i], 1e-4)
    model:static { steps = 10, tolerance = 1e-11 }:finish()
    inverse[i] = p[i] / node:displacement()
  end
  return p[2] + inverse[2] * (p[2] - p[1]) / (inverse[1] - inverse[2])
end

return hinge.benchmark {
  title = "Ring under pressure", kind = "stability", fast = true,
  source = "closed form (M. Levy 1884; S. P. Timoshenko, J. M. Gere, Theory of Elastic Stability, chapter 7)",
  run = function(b, job)
    for name, c in pairs { ["stays normal"] = { "local", 3 }, ["fixed direction"] = { "global", 4 } } do
      local run = quarter(16, c[1], 1.2 * c[2], 0):static { steps = 20 }:finish()
      b:row { "perfect ring, " .. name, computed = 1.2 * c[2] * (run.instability or { factor = 0 }).factor,
        reference = c[2], tolerance = 6e-3, elements = 32, steps = 20 }
    end
    job:verdict "completed" -- these runs end where the ring gives way
    for _, c in ipairs { { "p R^3 / EI, stays normal", "local", 3 }, { "p R^3 / EI, fixed direction", "global", 4 } } do
      local found = {}
      for _, members in ipairs { 4, 8, 16 } do found[members] = critical(members, c[2], c[3]) end
      b:row { c[1], computed = found[16], reference = c[3], tolerance = 4e-3, elements = 32, steps = 10 }
      b:row { ("order, %s axes, 8 to 16 to 32"):format(c[2]), reference = 2, tolerance = 0.04, elements = 32,
        computed = math.log((found[4] - found[8]) / (found[8] - found[16]), 2), steps = 10 }
    end
  end,
}
