-- A shallow pinned arch in the shape of half a sine, under a load that is distributed as half a sine.
--
-- Run     hinge run scripts/benchmarks/shallow_arch.lua
-- Shows   a limit load of a low arch, and of a higher one that goes to the side before it comes to its limit load
-- Expect  with l = a / (2 r), a: rise, r: radius of gyration, and q in 2 EI r (pi / L)^4: the limit load is
--         l + sqrt(4 (l^2 - 1)^3 / 27), the branching load l + 3 sqrt(l^2 - 4), which is less for l > sqrt 5.5
local hinge = require "hinge"

local E, L, side = 200e9, 1, 1e-3
local A, I, r = side ^ 2, side ^ 4 / 12, side / math.sqrt(12)
-- The theory does not shear: the shear areas are 1000 times the area.
local section = hinge.section.general { area = A, Ix = I, Iy = 1e4 * I, J = I, shear_area_x = 1000 * A,
  shear_area_y = 1000 * A }

-- The amplitude of the load at which the arch becomes unstable, in 2 EI r (pi / L)^4; two elements a member.
local function buckling(l, expected, members)
  local model = hinge.model { plasticity = false }
  local steel = hinge.material { E = E }
  local n, unit = {}, 1.3 * expected * 2 * E * I * r * (math.pi / L) ^ 4
  for i = 0, members do
    local s = math.sin(math.pi * i / members)
    n[i] = model:node { L * i / members, 0, 2 * r * l * s }
    model:fix(n[i], (i == 0 or i == members) and "x,y,z,rx,rz" or "y,rx,rz")
    if i > 0 then model:member { n[i - 1], n[i], section = section, material = steel } end
    -- A work-equivalent load: the integral of the sine with the straight shapes of both neighbours.
    local h = math.pi / members
    if i > 0 and i < members then
      model:load { node = n[i], force = { 0, 0, -unit * L / math.pi * s * 2 * (1 - math.cos(h)) / h } }
    end
  end
  local run = model:static { steps = 40, to_limit = true }:finish()
  return 1.3 * expected * run.factor
end

return hinge.benchmark {
  title = "Shallow arch under a sinusoidal load", kind = "stability", fast = true,
  source = "closed form of shallow arches (S. P. Timoshenko 1935; Y. C. Fung, A. Kaplan, NACA TN 2840, 1952)",
  run = function(b)
    local limit = 2 + math.sqrt(4 * (2 ^ 2 - 1) ^ 3 / 27)
    local error = {}
    for _, members in ipairs { 8, 16, 32 } do error[members] = buckling(2, limit, members) / limit - 1 end
    b:row { "limit load, l = 2", computed = limit * (1 + error[32]), reference = limit, tolerance = 2e-3,
      elements = 64, steps = 40 }
    b:row { "order, 16 to 32 to 64 elements", computed = math.log((error[8] - error[16]) / (error[16] - error[32]), 2),
      reference = 2, tolerance = 0.01, elements = 64, steps = 40 }
    local branch = 5 + 3 * math.sqrt(5 ^ 2 - 4)
    b:row { "branching load, l = 5", computed = buckling(5, branch, 32), reference = branch, tolerance = 3e-4,
      elements = 64, steps = 40 }
  end,
}
