-- Vogel's portal frame: columns at four fifths of their axial strength, leaning, with N and M by the exact interaction.
--
-- Run     hinge run scripts/benchmarks/vogel_portal.lua
-- Shows   second-order limit load of a sway frame whose columns carry little moment beside their axial force
-- Expect  1. The load factor of this file's own second-order hinge calculation. At the limit the third hinge forms, at
--         the head of the right column: with hinges at both feet, too, the frame gives way. Their moments are those of
--         the stress blocks of HEB 300 beside N, and the columns bend by stability functions. The columns shorten,
--         elastically and in their hinges, and the beam tilts. 2. The load factor with plastic zones, computed apart
--         from hinge: a column of 120 parts, its curvature from 500 fibres, without residual stress (1.0422) and with
--         that of the ECCS, 0.5 fy (1.0217). Hinges are above both: they stay elastic up to the full plastic moment. So
--         the tolerances of these two rows are as wide as that. Published: plastic zones 1.022, plastic hinges 1.017.
--         These factors and the input (span 4 m, height 5 m, HEB 300, HEA 340, 2800 kN on each head, 35 kN, lean 1/400)
--         are recalled and were not found in a public source; that the calculation with residual stress gives 1.0217
--         speaks for both. Hinge formulas of codes take less M beside this N than the stress blocks, 0.20 Mp against
--         0.22, which may be why the published factor of hinges is lower. By eq 14, the default, the factor is 1.21;
--         such a run warns.
local hinge = require "hinge"
local root = require "hinge.library.numeric".root

local E, fy, h, span, lean, P, H = 205e9, 235e6, 5, 4, 1 / 400, 2800e3, 35e3
local column, beam = hinge.section.named "HEB 300", hinge.section.named "HEA 340"

-- The moment of stress blocks of HEB 300 beside N: what N leaves of the outer parts, in strips, with the fillets.
local function moment_beside(N)
  local strips, left, M = 600, N / fy, 0
  local t = 0.15 / strips
  for i = 1, strips do
    local y = (i - 0.5) * t
    local fillet = y - 0.104
    local width = y > 0.131 and 0.3 or 0.011 + (fillet > 0 and 2 * (0.027 - math.sqrt(0.027 ^ 2 - fillet ^ 2)) or 0)
    local area = 2 * t * width
    local part = math.min(area, left)
    left = left - part
    M = M + (area - part) * (y + 0.5 * t * part / area)
  end
  return fy * M
end

-- Capacity less demand of the sway at a load factor, when the third hinge forms. Rotations are those in the sense of
-- the sway; an end of a column turns by less than its chord by its bending and by its hinge.
local function spare(factor)
  local shear, chord, shorter, head = 0, 0, { 0, 0 }, 0
  local N, M = {}, {}
  for _ = 1, 12 do
    N = { factor * P - shear, factor * P + shear } -- the beam's shear force makes one column carry more
    M = { moment_beside(N[1]), moment_beside(N[2]) }
    local near, far = {}, {} -- rotation of an end by a moment at it and at the other end: stability functions
    for i = 1, 2 do
      local u = h * math.sqrt(N[i] / (E * column.Ix))
      near[i] = h / (E * column.Ix) * (1 - u / math.tan(u)) / u ^ 2
      far[i] = h / (E * column.Ix) * (u / math.sin(u) - 1) / u ^ 2
    end
    local bends, k = M[2] * (near[2] - far[2]), span / (6 * E * beam.Ix)
    head = (3 * k * M[2] + bends + M[1] * far[1]) / (3 * k + near[1]) -- moment of the left head: both chords are one
    shear = (head + M[2]) / span
    chord = (shorter[2] - shorter[1]) / span + k * (2 * M[2] - head) + bends
    local turned = { chord - M[1] * near[1] + head * far[1], chord - bends } -- hinges at the feet
    for i = 1, 2 do -- flow normal to the surface: a hinge shortens by its rotation times dM/dN
      local slope = (moment_beside(N[i] - 1e3) - moment_beside(N[i] + 1e3)) / 2e3
      shorter[i] = N[i] * h / (E * column.area) + slope * turned[i]
    end
  end
  return M[1] + 2 * M[2] + head - factor * H * h - (N[1] + N[2]) * (lean + chord) * h
end

-- The largest load factor of a run that drives the head sideways; its curve.
local function pushed(law, steps)
  local model = hinge.model { interaction = law }
  local steel = hinge.material { E = E, G = 1e15, yield_stress = fy } -- G: members that do not shear
  local node = {}
  for i, at in ipairs { { 0, 0 }, { lean * h, h }, { span + lean * h, h }, { span, 0 } } do
    node[i] = model:node { at[1], 0, at[2] }
    model:fix(node[i], at[2] == 0 and "all" or "y,rx,rz")
  end
  model:member { node[1], node[2], section = column, material = steel, up = { 1, 0, 0 } }
  model:member { node[4], node[3], section = column, material = steel, up = { 1, 0, 0 } }
  model:member { node[2], node[3], section = beam, material = steel, up = { 0, 0, 1 } }
  model:load { node = node[2], force = { H, 0, -P } }
  model:load { node = node[3], force = { 0, 0, -P } }
  local run = model:static { steps = steps, control = { node = node[2], "ux", to = 0.04 } }
  local u, factor, peak = { 0 }, { 0 }, 0
  while run:step() do
    u[#u + 1], factor[#factor + 1] = 1e3 * node[2]:displacement(run), run.factor
    peak = run.factor == run.factor and math.max(peak, run.factor) or run.factor
  end
  assert(run.verdict == "completed", run.reason)
  return peak, u, factor
end

return hinge.benchmark {
  title = "Vogel's portal, second order, exact interaction", kind = "inelastic", fast = true,
  source = "hinges: calculation in this file; plastic zones: computed apart, Vogel (1985) by recall",
  missing = "residual stress and the spread of yield",
  run = function(b, job)
    local by_hand = root(spare, 0.8, 1.2)
    local steps = 160
    local peak, u, factor = pushed("exact", steps)
    local function row(what, reference, tolerance)
      b:row { what, computed = peak, reference = reference, tolerance = tolerance, elements = 6, steps = steps }
    end
    row("factor, hinges by hand", by_hand, 2e-4)
    row("factor, zones, no residual stress", 1.0422, 0.011)
    row("factor, zones with residual stress", 1.0217, 0.031)
    local _, u14, factor14 = pushed("paper", 40)
    local function level(y, name) return { x = { 0, 40 }, y = { y, y }, name = name, dashed = true } end
    job:plot({ series = { { x = u, y = factor, name = "exact" }, { x = u14, y = factor14, name = "eq 14" },
      level(by_hand, "hinges by hand"), level(1.0217, "plastic zones, residual stress") }, y_range = { 0.8, 1.3 },
      x_label = "sway of the head (mm)", y_label = "load factor", title = "Vogel's portal" }, "vogel_portal.png")
  end,
}
