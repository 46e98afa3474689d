-- Beams over several supports, to first order: moments over the supports, reactions, a support that settles.
--
-- Run     hinge run scripts/benchmarks/continuous_beam.lua
-- Shows   uniform loads on members, a load at a point of a member, a support that moves
-- Expect  beams that bend and do not shear, from the equation of three moments. Three equal spans under q: q L^2 / 10
--         over the inner supports, 1.1 q L at them, q L^4 / (1920 EI) in the middle. Two equal spans, P in the middle
--         of one: 3 P L / 32 over the inner support. Two equal spans whose inner support settles by s: 3 EI s / L^2
local hinge = require "hinge"

local E, L, q, P, settles = 206e9, 6, 20e3, 50e3, 0.01
local I = 8e-5
local beam = hinge.section.general { area = 6e-3, Ix = I, Iy = 6e-6, J = 2e-7, shear_area_y = 1 }
local steel = hinge.material { E = E, G = 1e15 } -- so stiff in shear that bending is alone

-- A beam of `spans` spans with a node in the middle of each. Returns model, nodes and members, from left to right.
-- free: the number of a node that has no support after all.
local function over(spans, free)
  local model, nodes, members = hinge.model { displacement = "small" }, {}, {}
  for i = 0, 2 * spans do
    nodes[i] = model:node { i * L / 2, 0, 0 }
    model:fix(nodes[i], i == free and "y,rx,rz" or i == 0 and "x,y,z,rx,rz" or i % 2 == 0 and "y,z,rx,rz" or "y,rx,rz")
    if i > 0 then members[i] = model:member { nodes[i - 1], nodes[i], section = beam, material = steel } end
  end
  return model, nodes, members
end

local function solved(model) return model:static { steps = 1 }:finish() end

-- The moment at the far end of a member.
local function end_moment(member, run) return math.abs(select(2, member:forces(run)).Mx) end

return hinge.benchmark {
  title = "Continuous beams", kind = "elastic", fast = true, source = "closed form, the equation of three moments",
  run = function(b)
    local row = b:rows_with { elements = 4, tolerance = 1e-6 }
    local model, nodes, members = over(3)
    for i = 1, 6 do model:load { member = members[i], q = { 0, 0, -q } } end
    local run = solved(model)
    row("three spans, q: moment over a support", end_moment(members[2], run) / 1e3, q * L ^ 2 / 10 / 1e3, "kN m")
    row("three spans, q: inner reaction", select(3, nodes[2]:reaction(run)) / 1e3, 1.1 * q * L / 1e3, "kN")
    row("three spans, q: sag in the middle", -1e3 * select(3, nodes[3]:displacement(run)),
      1e3 * q * L ^ 4 / (1920 * E * I), "mm")
    model, nodes, members = over(2)
    model:load { node = nodes[1], force = { 0, 0, -P } }
    row("two spans, P: moment over the support", end_moment(members[2], solved(model)) / 1e3, 3 * P * L / 32 / 1e3,
      "kN m")
    model, nodes, members = over(2, 2)
    model:load { node = nodes[2], force = { 0, 0, -1 } }
    run = model:static { steps = 1, control = { node = nodes[2], "uz", to = -settles } }:finish()
    row("two spans, settlement: moment", end_moment(members[2], run) / 1e3, 3 * E * I * settles / L ^ 2 / 1e3, "kN m")
  end,
}
