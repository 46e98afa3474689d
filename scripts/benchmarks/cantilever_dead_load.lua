-- A cantilever bends far under a load at its tip that keeps its direction.
--
-- Run     hinge run scripts/benchmarks/cantilever_dead_load.lua
-- Shows   deflection, shortening and slope of the tip for P L^2 / EI from 1 to 10, and the order of convergence
-- Expect  the digits below. They come from shooting on theta'' = -(P / EI) cos theta, theta(0) = 0, theta'(L) = 0, by
--         Runge-Kutta with 2000 steps. K. Mattiasson, Int. J. Numer. Meth. Eng. 17 (1981) 145-153, has the first five
--         of them from elliptic integrals. The bar is a strip that hardly stretches or shears. The error is of fourth
--         order in the length of the elements
local hinge = require "hinge"

local E, L, width, depth, steps = 206e9, 10, 0.2, 0.01, 20
local EI = E * width * depth ^ 3 / 12
-- P L^2 / EI: deflection / L, shortening / L, slope
local known = { { 1, 0.30172077, 0.05643324, 0.46135195 }, { 2, 0.49345748, 0.16064172, 0.78174983 },
  { 5, 0.71379152, 0.38762836, 1.21536812 }, { 10, 0.81060902, 0.55499560, 1.43028554 } }

-- Deflection / L, shortening / L and slope at the tip under P L^2 / EI = load, and the same after each step.
local function tip_under(load, elements)
  local model = hinge.model { plasticity = false }
  local steel, strip = hinge.material { E = E }, hinge.section.solid { width = width, depth = depth }
  local nodes, n = {}, elements // 2
  for i = 0, n do
    nodes[i] = model:node { i / n * L, 0, 0 }
    if i > 0 then model:member { nodes[i - 1], nodes[i], section = strip, material = steel } end
  end
  model:fix(nodes[0])
  model:load { node = nodes[n], force = { 0, 0, -load * EI / L ^ 2 } }
  local run, path = model:static { steps = steps }, {}
  for _ in run:steps() do
    local ux, _, uz, _, ry = nodes[n]:displacement(run)
    path[#path + 1] = { run.factor * load, -uz / L, -ux / L, ry }
  end
  return path[#path], path
end

return hinge.benchmark {
  title = "Cantilever under a dead load at its tip", kind = "elastic", fast = true,
  source = "shooting; Mattiasson 1981 from elliptic integrals",
  run = function(b, job)
    local names, series = { "deflection / L", "shortening / L", "slope" }, {}
    local exact = known[4]
    local coarse, path = tip_under(10, 8)
    local fine = tip_under(10, 16)
    for k, name in ipairs(names) do
      b:row { name .. ", P L^2 / EI = 10", computed = coarse[k + 1], reference = exact[k + 1], elements = 8,
        steps = steps, tolerance = ({ 6e-4, 8e-4, 8e-5 })[k] }
      local colour = ({ "blue", "red", "green" })[k]
      series[k] = { name = name, x = { 0 }, y = { 0 }, colour = colour }
      series[k + 3] = { x = {}, y = {}, style = "points", colour = colour }
      for i, at in ipairs(path) do series[k].x[i + 1], series[k].y[i + 1] = at[1], at[k + 1] end
      for i, at in ipairs(known) do series[k + 3].x[i], series[k + 3].y[i] = at[1], at[k + 1] end
    end
    b:row { "deflection / L, P L^2 / EI = 1", computed = tip_under(1, 4)[2], reference = known[1][2], elements = 4,
      steps = steps, tolerance = 4e-4 }
    b:row { "observed order, 8 to 16 elements", computed = math.log((coarse[2] - exact[2]) / (fine[2] - exact[2]), 2),
      reference = 4, elements = 16, steps = steps, tolerance = 0.05 }
    job:plot({ series = series, x_label = "P L^2 / EI", y_label = "rad, or parts of L", width = 1000, height = 720,
      title = "Cantilever under a dead load (points: exact)" }, "cantilever_dead_load.png")
  end,
}
