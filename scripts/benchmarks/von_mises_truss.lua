-- Von Mises' truss: two shallow bars are pressed through the level line, and hang below it in the end.
--
-- Run     hinge run scripts/benchmarks/von_mises_truss.lua
-- Shows   snap-through by arc length, and the same limit load by load control
-- Expect  the largest load 2 EA (1 - cos^(2/3) t)^(3/2), tan t = h / a, where the bars' angle s has cos^3 s = cos t, so
--         that the top has come down by h - a sqrt(cos^(-2/3) t - 1); the same load upwards below the level line
local hinge = require "hinge"
local turn = require "hinge.library.numeric".turn

local E, A, a, h = 206e9, 1e-3, 1, 0.1
local steel = hinge.material { E = E }
local bar = hinge.section.general { area = A, Ix = 1e-6, Iy = 1e-6, J = 1e-6 } -- its bars do not buckle

local function truss(load)
  local model = hinge.model { plasticity = false }
  local left, right, top = model:node { -a, 0, 0 }, model:node { a, 0, 0 }, model:node { 0, 0, h }
  model:fix({ left, right }, "x,y,z,rx,rz")
  model:fix(top, "x,y,rx,rz")
  -- The bars turn freely at the top: the second one has an end of its own there, which follows the top.
  local follower = model:node { 0, 0, h }
  model:fix(follower, "rx,rz")
  model:rigid_link { from = top, to = follower, dofs = "xyz" }
  model:member { left, top, section = bar, material = steel }
  model:member { right, follower, section = bar, material = steel }
  model:load { node = top, force = { 0, 0, -load } }
  return model, top
end

return hinge.benchmark {
  title = "Von Mises' truss", kind = "stability", fast = true,
  source = "closed form, bars with the strain (l - l0) / l0 (R. von Mises 1923)",
  run = function(b, job)
    local cos = math.cos(math.atan(h, a))
    local most, w_most = 2 * E * A * (1 - cos ^ (2 / 3)) ^ 1.5, h - a * math.sqrt(cos ^ (-2 / 3) - 1)
    local limit = truss(2 * most):static { steps = 10, to_limit = true }:finish()
    b:row { "limit load, load control", computed = 2 * limit.factor * most / 1e3, reference = most / 1e3, unit = "kN",
      tolerance = 1e-5, elements = 4, steps = 10 }

    local model, top = truss(most)
    local path, high, low = { { x = 0, y = 0 } }, 1, 1
    local arc = model:static { control = { "arc", to = 3 }, steps = 400 }
    for _ in arc:steps() do
      path[#path + 1] = { x = -select(3, arc:displacement(top)), y = arc.factor }
      local last = path[#path]
      if last.x < h and last.y > path[high].y then high = #path end
      if last.x < 2 * h and last.y < path[low].y then low = #path end
    end
    local w, P = turn(path[high - 1], path[high], path[high + 1])
    b:row { "limit load, arc length", computed = P * most / 1e3, reference = most / 1e3, unit = "kN", tolerance = 1e-5,
      elements = 4, steps = arc.index }
    b:row { "deflection at the limit load", computed = w * 1e3, reference = w_most * 1e3, unit = "mm",
      tolerance = 2e-4, elements = 4, steps = arc.index }
    w, P = turn(path[low - 1], path[low], path[low + 1])
    b:row { "least load", computed = P * most / 1e3, reference = -most / 1e3, unit = "kN", tolerance = 1e-5,
      elements = 4, steps = arc.index }
    b:row { "deflection at the least load", computed = w * 1e3, reference = (2 * h - w_most) * 1e3, unit = "mm",
      tolerance = 1e-4, elements = 4, steps = arc.index }

    local found, exact = { x = {}, y = {}, name = "hinge, arc length", style = "points" }, { x = {}, y = {} }
    for i = 1, #path, 5 do
      found.x[#found.x + 1], found.y[#found.y + 1] = path[i].x * 1e3, path[i].y * most / 1e3
    end
    for i = 0, 237 do
      local z = h - i * 1e-3
      local l = math.sqrt(a ^ 2 + z ^ 2)
      exact.x[i + 1], exact.y[i + 1] = i, 2 * E * A * (1 - l / math.sqrt(a ^ 2 + h ^ 2)) * z / l / 1e3
    end
    exact.name = "closed form"
    job:plot({ series = { exact, found }, x_label = "deflection of the top, mm", y_label = "load, kN",
      title = "Von Mises' truss" }, "von_mises_truss.png")
  end,
}
