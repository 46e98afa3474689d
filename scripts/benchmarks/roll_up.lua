-- A cantilever rolls up to half a circle and to a whole one under a moment at its tip.
--
-- Run     hinge run scripts/benchmarks/roll_up.lua
-- Shows   rotations of any size, and how fast the error falls with the number of elements
-- Expect  the tip at x = 0 and at the height 2 L / pi under M = pi EI / L, and at the clamped end under twice as much.
--         The moment is the same everywhere, so the nodes lie on a circle, and x is right to rounding. The height has
--         an error of fourth order in the length of the elements. With p_delta = "chord", the paper's way, a chord is
--         as long as its arc should be: the circle is too large, and the error is of second order
local hinge = require "hinge"

local E, side, L, steps = 206e9, 0.01, 1, 20
local EI = E * side ^ 4 / 12

-- The displacement of the tip under the moment M, and where the nodes are then.
local function tip_under(M, elements, p_delta)
  local model = hinge.model { plasticity = false, p_delta = p_delta }
  local steel, square, nodes = hinge.material { E = E }, hinge.section.solid { width = side, depth = side }, {}
  for i = 0, elements // 2 do
    nodes[i] = model:node { 2 * i * L / elements, 0, 0 }
    if i > 0 then model:member { nodes[i - 1], nodes[i], section = square, material = steel } end
  end
  model:fix(nodes[0])
  model:load { node = nodes[#nodes], moment = { 0, -M, 0 } }
  local run = model:static { steps = steps }:finish()
  local curve = { x = {}, y = {}, style = "points", colour = "red" }
  for i = 0, #nodes do
    local ux, _, uz = nodes[i]:displacement(run)
    curve.x[i + 1], curve.y[i + 1] = nodes[i].x + ux, uz
  end
  return curve.x[#nodes + 1] - L, curve.y[#nodes + 1], curve
end

-- The exact shape under M.
local function arc(M)
  local curve, radius = { x = {}, y = {}, colour = "blue" }, EI / M
  for i = 0, 100 do
    local angle = i / 100 * L / radius
    curve.x[i + 1], curve.y[i + 1] = radius * math.sin(angle), radius * (1 - math.cos(angle))
  end
  return curve
end

return hinge.benchmark {
  title = "Cantilever rolled up by a moment", kind = "elastic", fast = true,
  source = "closed form: an arc of radius EI / M",
  run = function(b, job)
    local half, height = math.pi * EI / L, 2 * L / math.pi
    local function row(what, computed, reference, tolerance, elements, scale)
      b:row { what, computed = computed, reference = reference, unit = scale and "m" or nil, tolerance = tolerance,
        elements = elements, steps = steps, scale = scale }
    end
    for _, by in ipairs { { "member", 16, 1e-6, 4, 0.06 }, { "chord", 16, 0.005, 2, 0.012 } } do
      local name, elements, tolerance, order, order_tolerance = table.unpack(by)
      local ux, uz = tip_under(half, elements, name)
      if name == "member" then row("half a circle: u_x", ux, -L, 1e-6, elements, L) end
      row(("half a circle: u_z, %s"):format(name), uz, height, tolerance, elements, height)
      local _, coarse = tip_under(half, elements // 2, name)
      row(("observed order, %d to %d elements, %s"):format(elements // 2, elements, name),
        math.log((coarse - height) / (uz - height), 2), order, order_tolerance, elements)
    end
    local ux, uz, curve = tip_under(2 * half, 16)
    row("whole circle: u_x", ux, -L, 1e-6, 16, L)
    row("whole circle: u_z", uz, 0, 1e-6, 16, L)
    local _, _, half_curve = tip_under(half, 16)
    local exact = arc(2 * half)
    curve.name, exact.name = "hinge, 16 elements", "arc of radius EI / M"
    job:plot({ title = "cantilever rolled up by a moment", x_label = "x / L", y_label = "z / L", width = 1150,
      height = 810, x_range = { -0.75, 0.45 }, y_range = { -0.05, 0.7 },
      series = { exact, arc(half), curve, half_curve } }, "roll_up.png")
  end,
}
