-- Members that carry tension alone: a braced panel before and after yield, and cables.
--
-- Run     hinge run scripts/benchmarks/tension_braces.lua
-- Shows   carries = "tension": crossed braces over a cycle, the slack that yielding leaves, a cable under its weight
-- Expect  a panel of pinned members, span 4 m, height 3 m, pushed at its head: one brace of 5 m acts, k = EA / 5 0.8^2,
--         until it yields at 0.8 N0. Pushed to u and back, it is slack from u - u_y on, and the panel is loose until
--         the other brace pulls. A cable of equal parts between two points that hangs under its own weight is a
--         catenary: its sag and the pull at its ends are those of y = a cosh(x / a), but for what it stretches and for
--         the bending of its 20 straight parts.
local hinge = require "hinge"
local root = require "hinge.library.numeric".root

local E, fy, area = 206e9, 300e6, 2e-4
local steel = hinge.material { E = E, yield_stress = fy }
local k, N0 = E * area / 5 * 0.8 ^ 2, fy * area

-- A section without bending stiffness to speak of.
local function wire(A)
  return hinge.section.general { area = A, Ix = 1e-12, Iy = 1e-12, J = 1e-12, plastic = { A = A } }
end

-- The force on a panel at each of the displacements of its head, one after the other.
local function panel(turns)
  local model = hinge.model { displacement = "small" }
  local feet, head = {}, model:node { 0, 0, 3 }
  for i, x in ipairs { -4, 4 } do
    feet[i] = model:node { x, 0, 0 }
    model:fix(feet[i])
    model:member { feet[i], head, section = wire(area), material = steel, carries = "tension", up = { 0, 1, 0 } }
  end
  model:fix(head, "y,z,rx,ry,rz")
  model:load { node = head, force = { N0, 0, 0 } }
  local at_turn, u, P, run = {}, { 0 }, { 0 }, nil
  for i, to in ipairs(turns) do
    run = model:static { from = run, steps = 20, control = { node = head, "ux", to = to } }
    while run:step() do u[#u + 1], P[#P + 1] = 1e3 * head:displacement(run), run.factor * N0 end
    assert(run.verdict == "completed", run.reason)
    at_turn[i] = P[#P]
  end
  return at_turn, u, P
end

-- The pull at the end and the sag of a cable of `parts` bars over a span, under its own weight, N/m.
local function cable(span, sag, parts, weight)
  local rope = hinge.material { E = E, density = weight / 9.80665 / (math.pi / 4 * 0.012 ^ 2) }
  local model, node, length = hinge.model {}, {}, 0
  for i = 0, parts do
    local x = span * (i / parts - 0.5)
    node[i] = model:node { x, 0, sag * ((2 * x / span) ^ 2 - 1) } -- a parabola at first
    model:fix(node[i], i % parts == 0 and "x,y,z,rx,rz" or "y,rx,rz")
  end
  for i = 1, parts do
    length = length + model:member({ node[i - 1], node[i], section = hinge.section.round { diameter = 0.012 },
      material = rope, up = { 0, 1, 0 }, carries = "tension" }).length
  end
  model:gravity { 0, 0, -9.80665 }
  local run = model:static { steps = 10 }:finish()
  assert(run.verdict == "completed", run.reason)
  return -node[0]:reaction(run), sag - select(3, node[parts // 2]:displacement(run)), length
end

-- a of the catenary of a length over a span: 2 a sinh(span / 2 a) = length.
local function catenary(span, length)
  local function sinh(x) return (math.exp(x) - math.exp(-x)) / 2 end
  local a = root(function(x) return 2 * x * sinh(span / 2 / x) - length end, span / 20, 100 * span)
  return a, a * (math.sqrt(1 + sinh(span / 2 / a) ^ 2) - 1)
end

return hinge.benchmark {
  title = "Braces and a cable, tension alone", kind = "inelastic", fast = true, source = "closed forms",
  run = function(b, job)
    local uy = 0.8 * N0 / k
    local at, u, P = panel { 0.8 * uy, 3 * uy, 0, -0.5 * uy, 2.5 * uy }
    local function row(what, computed, reference, unit, tolerance, elements, steps)
      b:row { what, computed = computed, reference = reference, unit = unit, tolerance = tolerance,
        elements = elements, steps = steps, scale = reference == 0 and 0.8 * N0 or nil }
    end
    row("panel: one brace acts", at[1], 0.64 * N0, "N", 1e-6, 4, 20)
    row("panel: the brace has yielded", at[2], 0.8 * N0, "N", 1e-6, 4, 40)
    row("panel: both are slack on the way back", at[3], 0, "N", 1e-6, 4, 60)
    row("panel: the first brace pulls again", at[5], 0.5 * 0.8 * N0, "N", 1e-6, 4, 100)
    local pull, sag, length = cable(8, 2.4, 20, 1000)
    local a, by_hand = catenary(8, length)
    row("cable: sag", sag, by_hand, "m", 3e-3, 40, 10)
    row("cable: horizontal pull", pull, 1000 * a, "N", 1.5e-3, 40, 10)
    for i = 1, #u do P[i] = P[i] / 1e3 end
    local corners = { x = { 0, 1, 3, 2, 0, -0.5 }, y = { 0, 1, 1, 0, 0, -0.5 }, name = "by hand", style = "points" }
    for i = 1, 6 do corners.x[i], corners.y[i] = 1e3 * uy * corners.x[i], 0.8e-3 * N0 * corners.y[i] end
    job:plot({ series = { { x = u, y = P, name = "hinge" }, corners }, x_label = "displacement of the head (mm)",
      y_label = "force (kN)", title = "A panel with crossed tension braces" }, "tension_braces.png")
  end,
}
