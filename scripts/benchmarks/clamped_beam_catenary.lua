-- A clamped beam that builds up axial force as it sinks: from bending to a rope.
--
-- Run     hinge run scripts/benchmarks/clamped_beam_catenary.lua
-- Shows   large deflections of a plastic beam with full axial restraint, load at midspan, both interactions
-- Expect  rigid-plastic closed forms for a solid rectangle; Pc = 8 Mp / L, x = w / h, n = N / N0. While the middle
--         sinks by dw, a half span stretches by 2 w dw / L in two hinges, which turn by 2 dw / L each. Flow normal to
--         the surface then gives dM/dN = -w / 2. Equilibrium is P / Pc = M / Mp + 2 n x. Exact, M = Mp (1 - n^2): n = x
--         and P / Pc = 1 + x^2 up to x = 1, then N0 alone: 2 x. Eq 14, M = Mp sqrt(1 - n^2): n = 2 x / sqrt(1 + 4 x^2)
--         and P / Pc = sqrt(1 + 4 x^2). The error that is left is the elastic part and that of small angles: h / L is
--         1/100, and E is 1000 times that of steel. A run warns of both: of that E, and of the strength that eq 14
--         finds.
local hinge = require "hinge"

local h, L, fy = 0.05, 5, 245e6
local Mp = fy * h ^ 3 / 4
local stiff = hinge.material { E = 2e14, yield_stress = fy } -- nearly rigid, plastic

-- P over Pc at each w / h of a run that drives the middle down.
local function pushed(law, to, steps)
  local model = hinge.model { interaction = law }
  local a, middle, b = model:node { 0, 0, 0 }, model:node { L / 2, 0, 0 }, model:node { L, 0, 0 }
  model:fix({ a, b })
  model:fix(middle, "x,y,rx,ry,rz")
  local section = hinge.section.solid { width = h, depth = h }
  for _, ends in ipairs { { a, middle }, { middle, b } } do
    model:member { ends[1], ends[2], section = section, material = stiff }
  end
  model:load { node = middle, force = { 0, 0, -8 * Mp / L } }
  local run = model:static { steps = steps, control = { node = middle, "uz", to = -to * h } }
  local x, P = {}, {}
  while run:step() do x[#x + 1], P[#P + 1] = to * run.index / steps, run.factor end
  return x, P
end

local function exact(x) return x <= 1 and 1 + x ^ 2 or 2 * x end
local function eq14(x) return math.sqrt(1 + 4 * x ^ 2) end

return hinge.benchmark {
  title = "Clamped beam from bending to a rope", kind = "inelastic", fast = false,
  source = "closed forms, rigid-plastic, derived in this file",
  run = function(b, job)
    local series = {}
    for _, law in ipairs { "exact", "paper" } do
      local by_hand, steps = law == "exact" and exact or eq14, 50
      local name = law == "exact" and "exact" or "eq 14"
      local x, P = pushed(law, 2.5, steps)
      for _, at in ipairs(law == "exact" and { 0.5, 1, 2 } or { 0.5, 2 }) do
        local i = math.floor(at / 2.5 * steps + 0.5)
        b:row { ("%s: P / Pc at w = %g h"):format(name, at), computed = P[i],
          reference = by_hand(at), tolerance = 1.5e-3, elements = 4, steps = steps }
      end
      local line = { x = {}, y = {}, name = name .. ", closed form" }
      for i = 1, #x do line.x[i], line.y[i] = x[i], by_hand(x[i]) end
      series[#series + 1] = line
      series[#series + 1] = { x = x, y = P, name = name .. ", run", style = "points" }
    end
    job:plot({ series = series, x_label = "w / h", y_label = "P / Pc", title = "Clamped beam, axially restrained" },
      "clamped_beam_catenary.png")
  end,
}
