-- AISC Design Guide 25: a column under axial load and 10 kip to the side, as a cantilever and fixed with a guided head.
--
-- Run     hinge run scripts/benchmarks/design_guide_25.lua
-- Shows   the growth of moment and deflection near the buckling load, two elements a member, without shear
-- Expect  within 0.05 % the closed forms H L^3 / EI (tan u - u) / u^3 and H L tan u / u, with u^2 = P L^2 / EI; fixed
--         and guided: two such halves. The largest load is 0.67 of the cantilever's Euler load. The guide leaves out
--         that the column gets shorter by e = P / EA, 0.18 % there. With it u^2 is (1 - e) P L^2 / EI, and the moment
--         is 0.5 % less: the rows have e, but for the last one, which has the guide's own moment
local hinge = require "hinge"

local inch, kip, ksi = hinge.units.inch, hinge.units.kip, hinge.units.ksi
local E, L, A, I, H = 29500 * ksi, 196 * inch, 51.7 * inch ^ 2, 2150 * inch ^ 4, 10 * kip
-- The guide has no shear deformation: the shear areas are 100 times the area.
local section = hinge.section.general { area = A, Ix = I, Iy = I, J = I, shear_area_x = 100 * A,
  shear_area_y = 100 * A }
local euler = math.pi ^ 2 * E * I / (4 * L ^ 2) -- of the cantilever

-- Moment at the foot and deflection of the head under `part` of Euler's load, and both by the closed form.
local function column(part, guided, shortens)
  local model = hinge.model { plasticity = false }
  local a, b = model:node { 0, 0, 0 }, model:node { 0, 0, L }
  model:fix(a)
  model:fix(b, guided and "y,rx,ry,rz" or "y,rx,rz")
  model:member { a, b, section = section, material = hinge.material { E = E } }
  model:load { node = b, force = { H, 0, -part * euler } }
  model:static { steps = 5 }:finish()
  local l = guided and L / 2 or L
  local c = shortens and 1 - part * euler / (E * A) or 1
  local u = l * math.sqrt(c * part * euler / (E * I))
  local count = guided and 2 or 1
  return math.abs(select(5, a:reaction())), (b:displacement()), c * H * l * math.tan(u) / u,
    c ^ 2 * count * H * l ^ 3 / (E * I) * (math.tan(u) - u) / u ^ 3
end

return hinge.benchmark {
  title = "AISC Design Guide 25: columns under axial and lateral load", kind = "stability", fast = true,
  source = "closed form of the beam-column (R. C. Kaehler, D. W. White, Y. D. Kim, AISC Design Guide 25)",
  run = function(b)
    local in_kip = kip * inch
    for _, c in ipairs { { "cantilever", 0.3 }, { "cantilever", 0.67 }, { "guided", 0.67, true } } do
      local M, u, exact_M, exact_u = column(c[2], c[3], true)
      b:row { ("%s, %g P_E: moment"):format(c[1], c[2]), computed = M / in_kip, reference = exact_M / in_kip,
        unit = "kip in", tolerance = 6e-4, elements = 2, steps = 5 }
      b:row { ("%s, %g P_E: deflection"):format(c[1], c[2]), computed = u / inch, reference = exact_u / inch,
        unit = "in", tolerance = 6e-4, elements = 2, steps = 5 }
    end
    local M, _, guide = column(0.67, false, false)
    b:row { "cantilever, 0.67 P_E: moment, guide", computed = M / in_kip, reference = guide / in_kip, unit = "kip in",
      tolerance = 8e-3, elements = 2, steps = 5 }
  end,
}
