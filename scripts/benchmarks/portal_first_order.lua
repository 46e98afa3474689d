-- An elastic portal to first order: a load at its head, a load on its beam, fixed and pinned feet.
--
-- Run     hinge run scripts/benchmarks/portal_first_order.lua
-- Shows   moments and sway of a frame with members that bend, and neither stretch nor shear
-- Expect  with k = (I_beam / I_column) (h / L), by slope and deflection (the formulas of A. Kleinlogel's tables):
--         H at the head, fixed feet: moment at a foot H h (3 k + 1) / (2 (6 k + 1)), sway H h^3 (3 k + 2) /
--         (12 E I_column (6 k + 1)); q on the beam, fixed feet: moment at a head q L^2 / (6 (k + 2));
--         q on the beam, pinned feet: thrust q L^2 / (4 h (2 k + 3))
local hinge = require "hinge"

local E, h, L, H, q = 206e9, 4, 6, 40e3, 20e3
local I_column, I_beam = 1.2e-4, 2e-4
local k = I_beam / I_column * h / L
local stiff = hinge.material { E = E, G = 1e15 }

local function bending(I) -- neither stretches nor, with G, shears
  return hinge.section.general { area = 100, Ix = I, Iy = I, J = I, shear_area_x = 1, shear_area_y = 1,
    size = { width = 0.2, depth = 0.3 } }
end

-- The portal under a load; pinned: its feet. Returns the run, the left foot, the left head, the left column.
local function portal(pinned, load)
  local model = hinge.model { displacement = "small" }
  local nodes = {}
  for i, at in ipairs { { 0, 0, 0 }, { 0, 0, h }, { L, 0, h }, { L, 0, 0 } } do
    nodes[i] = model:node(at)
    model:fix(nodes[i], (i == 2 or i == 3) and "y,rx,rz" or pinned and "x,y,z,rx,rz" or "all")
  end
  local members = {}
  for i = 1, 3 do
    members[i] = model:member { nodes[i], nodes[i + 1], section = bending(i == 2 and I_beam or I_column),
      material = stiff }
  end
  load(model, nodes, members)
  return model:static { steps = 1 }:finish(), nodes[1], nodes[2], members[1]
end

local function moment(ends)
  return math.sqrt(ends.Mx ^ 2 + ends.My ^ 2) -- the columns' axes do not matter
end

return hinge.benchmark {
  title = "Portal to first order", kind = "elastic", fast = true, source = "closed form, Kleinlogel's tables",
  run = function(b)
    local row = b:rows_with { elements = 2, tolerance = 2e-6 }
    local run, _, head, column = portal(false, function(model, nodes)
      model:load { node = nodes[2], force = { H, 0, 0 } }
    end)
    row("H, fixed: moment at a foot", moment((column:forces(run))) / 1e3,
      H * h * (3 * k + 1) / (2 * (6 * k + 1)) / 1e3, "kN m")
    row("H, fixed: sway", 1e3 * head:displacement(run),
      1e3 * H * h ^ 3 * (3 * k + 2) / (12 * E * I_column * (6 * k + 1)), "mm")
    local function on_beam(model, _, members) model:load { member = members[2], q = { 0, 0, -q } } end
    local beam_run, _, _, loaded = portal(false, on_beam)
    row("q, fixed: moment at a head", moment(select(2, loaded:forces(beam_run))) / 1e3,
      q * L ^ 2 / (6 * (k + 2)) / 1e3, "kN m")
    local pinned_run, foot = portal(true, on_beam)
    row("q, pinned: thrust", foot:reaction(pinned_run) / 1e3, q * L ^ 2 / (4 * h * (2 * k + 3)) / 1e3, "kN")
  end,
}
