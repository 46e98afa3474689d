-- The two problems by which AISC 360 checks a second-order analysis: a W14x48, 28 ft long, bent under axial load.
--
-- Run     hinge run scripts/benchmarks/aisc_c_c2.lua
-- Shows   moment and deflection of a member under axial load with shear, two elements a member: case 1 is a simple
--         span under 0.20 kip/ft, case 2 a cantilever with 1 kip at its tip
-- Expect  the closed form within 0.1 %. It has the axial strain e = P / EA and the shear angle to first order:
--         EI M'' + c P M = -c q EI with c = 1 - e + P / G A_s. With c = 1, M is 375.4 for 380 and 849 for 856.
--         Engesser's form with shear alone, c = 1 / (1 - P / G A_s), is 0.2 % above hinge in M, 0.4 % in deflection
local hinge = require "hinge"

local inch, kip, ksi = hinge.units.inch, hinge.units.kip, hinge.units.ksi
local E, G, L = 29000 * ksi, 11200 * ksi, 28 * 12 * inch
local A, I, A_shear = 14.1 * inch ^ 2, 484 * inch ^ 4, 13.8 * 0.340 * inch ^ 2 -- depth times web
local section = hinge.section.general { area = A, Ix = I, Iy = 51.4 * inch ^ 4, J = 1.45 * inch ^ 4,
  shear_area_x = 7.96 * inch ^ 2, shear_area_y = A_shear }
local steel = hinge.material { E = E, G = G }

-- c and e of the closed form under P.
local function factor(P)
  local e = P / (E * A)
  return 1 - e + P / (G * A_shear), e
end

-- Case 1: moment (N m) and deflection (m) at midspan under P.
local function simple_span(P)
  local model = hinge.model { plasticity = false }
  local a, m, b = model:node { 0, 0, 0 }, model:node { L / 2, 0, 0 }, model:node { L, 0, 0 }
  model:fix({ a, m, b }, "y,rx,rz")
  model:fix(a, "x,z")
  model:fix(b, "z")
  local left = model:member { a, m, section = section, material = steel }
  local right = model:member { m, b, section = section, material = steel }
  local q = 0.2 * kip / (12 * inch)
  for _, member in ipairs { left, right } do model:load { member = member, q = { 0, 0, -q } } end
  model:load { node = b, force = { -P, 0, 0 } }
  model:static { steps = 5 }:finish()
  local _, at_b = left:forces()
  local c, e = factor(P)
  local M = q * E * I / P * (1 / math.cos(math.sqrt(c * P / (E * I)) * L / 2) - 1)
  return math.abs(at_b.Mx), -select(3, m:displacement()), M, (M - (1 - e) * q * L ^ 2 / 8) / P
end

-- Case 2: moment at the foot and deflection of the top under P.
local function cantilever(P)
  local model = hinge.model { plasticity = false }
  local a, b = model:node { 0, 0, 0 }, model:node { 0, 0, L }
  model:fix(a)
  model:fix(b, "y,rx,rz")
  model:member { a, b, section = section, material = steel }
  local H = 1 * kip
  model:load { node = b, force = { H, 0, -P } }
  model:static { steps = 5 }:finish()
  local c, e = factor(P)
  local u = math.sqrt(c * P / (E * I)) * L
  local M = c * H * L * math.tan(u) / u
  return math.abs(select(5, a:reaction())), (b:displacement()), M, (M - (1 - e) * H * L) / P
end

return hinge.benchmark {
  title = "AISC 360, commentary C2: cases 1 and 2", kind = "stability", fast = true,
  source = "closed form of the beam-column with shortening and shear; A 14.1, I 484, A_s = d t_w, G 11,200 ksi",
  run = function(b)
    local in_kip = kip * inch
    for _, c in ipairs { { "case 1", 150, simple_span }, { "case 1", 450, simple_span },
      { "case 2", 100, cantilever }, { "case 2", 200, cantilever } } do
      local M, u, exact_M, exact_u = c[3](c[2] * kip)
      local elements = c[3] == cantilever and 2 or 4
      b:row { ("%s, %d kip: moment"):format(c[1], c[2]), computed = M / in_kip, reference = exact_M / in_kip,
        unit = "kip in", tolerance = 8e-4, elements = elements, steps = 5 }
      b:row { ("%s, %d kip: deflection"):format(c[1], c[2]), computed = u / inch, reference = exact_u / inch,
        unit = "in", tolerance = 1.5e-3, elements = elements, steps = 5 }
    end
  end,
}
