-- Two beams up to their plastic mechanism, hinge by hinge.
--
-- Run     hinge run scripts/benchmarks/plastic_beams.lua
-- Shows   loads and deflections at which each hinge forms, first order, bending alone
-- Expect  a propped cantilever, load at midspan: hinges at 16 Mp / 3 L and 6 Mp / L; a beam with both ends fixed, load
--         at a third: hinges at 27 Mp / 4 L, 243 Mp / 28 L and 9 Mp / L. Between two hinges the beam is elastic, so
--         that each next one follows from a linear analysis with those before as hinges that carry Mp. The computed
--         points are where the straight parts of the curve meet.
local hinge = require "hinge"

local E, side, fy, L = 206e9, 0.05, 245e6, 1
local steel = hinge.material { E = E, G = 1e15, yield_stress = fy } -- so stiff in shear that bending is alone
local Mp, EI = fy * side ^ 3 / 4, E * side ^ 4 / 12
local square = hinge.section.solid { width = side, depth = side }

-- The load P (N) over the deflection w (m) under it. `at`: its place, from the fixed end a; held: what is held at b.
local function pushed(at, held, to, elements)
  local model = hinge.model { displacement = "small", elements_per_member = elements }
  local a, under, b = model:node { 0, 0, 0 }, model:node { at, 0, 0 }, model:node { L, 0, 0 }
  model:fix(a)
  model:fix(b, held)
  for _, ends in ipairs { { a, under }, { under, b } } do
    model:member { ends[1], ends[2], section = square, material = steel }
  end
  model:load { node = under, force = { 0, 0, -1 } }
  local run = model:static { steps = 60, control = { node = under, "uz", to = -to } }
  local w, P = { 0 }, { 0 }
  while run:step() do w[#w + 1], P[#P + 1] = -select(3, under:displacement()), run.factor end
  return w, P
end

-- Where the straight parts of a curve meet: points { x, y }. A part has at least two steps of one slope.
local function corners(x, y)
  local parts, found = {}, {}
  local function slope(i) return (y[i + 1] - y[i]) / (x[i + 1] - x[i]) end
  local first = slope(1)
  for i = 1, #x - 2 do
    local s, last = slope(i), parts[#parts]
    if math.abs(s - slope(i + 1)) < 1e-6 * first and not (last and math.abs(s - last.slope) < 1e-6 * first) then
      parts[#parts + 1] = { slope = s, x = x[i], y = y[i] }
    end
  end
  for i = 2, #parts do
    local p, q = parts[i - 1], parts[i]
    local dx = (q.y - p.y - q.slope * (q.x - p.x)) / (p.slope - q.slope)
    found[#found + 1] = { p.x + dx, p.y + p.slope * dx }
  end
  return found
end

return hinge.benchmark {
  title = "Plastic beams, hinge by hinge", kind = "inelastic", fast = true,
  source = "closed forms: linear analysis between the hinges",
  run = function(b, job)
    local series = {}
    for _, case in ipairs { -- deflections over Mp L^2 / EI, loads over Mp / L
      { "propped", 1 / 2, "y,z,rx", 8e-3, { { 7 / 144, 16 / 3 }, { 1 / 16, 6 } } },
      { "fixed", 1 / 3, "all", 8e-3, { { 2 / 81, 27 / 4 }, { 8 / 189, 243 / 28 }, { 2 / 27, 9 } } },
    } do
      local name, reference = case[1], case[5]
      local w, P = pushed(case[2] * L, case[3], case[4], 2)
      local found = corners(w, P)
      local drawn = { x = { 0 }, y = { 0 }, name = name .. ", closed form", style = "points" }
      for i, wanted in ipairs(reference) do
        local got = found[i] or { 0 / 0, 0 / 0 }
        local w_ref, P_ref = wanted[1] * Mp * L ^ 2 / EI, wanted[2] * Mp / L
        b:row { ("%s: load at hinge %d"):format(name, i), computed = got[2], reference = P_ref, unit = "N",
          tolerance = 4e-6, elements = 4, steps = 60 }
        if i == #reference then
          b:row { ("%s: deflection at hinge %d"):format(name, i), computed = got[1], reference = w_ref, unit = "m",
            tolerance = 4e-6, elements = 4, steps = 60 }
        end
        drawn.x[i + 1], drawn.y[i + 1] = 1e3 * w_ref, P_ref / 1e3
      end
      for i = 1, #w do w[i], P[i] = 1e3 * w[i], P[i] / 1e3 end
      series[#series + 1] = { x = w, y = P, name = name .. " beam" }
      series[#series + 1] = drawn
    end
    job:plot({ series = series, x_label = "deflection under the load (mm)", y_label = "load (kN)",
      title = "Plastic beams, hinge by hinge" }, "plastic_beams.png")
  end,
}
