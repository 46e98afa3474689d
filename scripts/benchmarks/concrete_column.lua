-- The interaction diagram of a column of reinforced concrete in a textbook, by runs of a cantilever.
--
-- Run     hinge run scripts/benchmarks/concrete_column.lua
-- Shows   hinge.section.concrete: N alone, and M beside N, up to the limit load
-- Expect  nominal strengths of a column of 14 x 24 in with three bars No. 9 at 2.5 in from each short side, f'c 4000
--         psi, fy 60 000 psi: the strain 0.003 at the edge and the stress block 0.85 f'c (strains = "ACI 318"). The
--         yield surface is a smooth one through the states. It is 0.8 % from the book in pure bending, where the bars
--         that are pressed leave the block.
local hinge = require "hinge"

local inch, kip, psi, ft = hinge.units.inch, hinge.units.kip, hinge.units.psi, hinge.units.ft
local L = 3
local bars = {}
for _, x in ipairs { -4.5, 0, 4.5 } do
  for _, y in ipairs { -9.5, 9.5 } do bars[#bars + 1] = { x * inch, y * inch, area = inch ^ 2 } end
end
local column = hinge.section.concrete { width = 14 * inch, depth = 24 * inch, concrete = 4000 * psi,
  steel = 60e3 * psi, strains = "ACI 318", bars = bars }

-- The factor of the limit load of a cantilever along x: `held` stays, `push` grows; forces at the tip.
local function limit(held, push)
  local model = hinge.model { displacement = "small" }
  local root, tip = model:node { 0, 0, 0 }, model:node { L, 0, 0 }
  model:fix(root)
  model:member { root, tip, section = column, material = hinge.material.concrete "C30/37" }
  model:case "held":load { node = tip, force = held }
  model:case "push":load { node = tip, force = push }
  local first = model:static { loads = { held = 1 }, steps = 2 }:finish()
  local run = model:static { from = first, loads = { push = 1 }, steps = 20, to_limit = true }:finish()
  assert(run.limit, run.reason)
  return run.factor
end

return hinge.benchmark {
  title = "Interaction diagram of a concrete column", kind = "inelastic", fast = true,
  source = "McCormac and Brown, Design of Reinforced Concrete, 9th ed., section 10.3",
  run = function(b, job)
    local row = b:rows_with { elements = 2, steps = 20 }
    -- kip ft beside a compression of `N` kip
    local function moment(N)
      local most = 800 * kip * ft
      return 800 * limit({ -N * kip, 0, 0 }, { 0, 0, most / L })
    end
    row("pure compression", 2000 * limit({ 0, 0, 0 }, { -2000 * kip, 0, 0 }), 1482, "kip", 2e-3)
    row("pure tension", 500 * limit({ 0, 0, 0 }, { 500 * kip, 0, 0 }), 360, "kip", 2e-3)
    row("M beside 504.4 kip, balanced", moment(504.4), 559.7, "kip ft", 5e-3)
    row("M alone", moment(0), 297, "kip ft", 1.5e-2)
    row("M beside 623.7 kip, bars not yielding", moment(623.7), 521.8, "kip ft", 5e-3)
    local M, N = {}, {}
    for i, n in ipairs { -300, -200, -100, 0, 100, 200, 300, 400, 504.4, 623.7, 800, 1000, 1200, 1400 } do
      M[i], N[i] = moment(n), n
    end
    job:plot({ series = { { x = M, y = N, name = "hinge", style = "line and points" },
      { x = { 0, 521.8, 559.7, 297, 0 }, y = { 1482, 623.7, 504.4, 0, -360 }, name = "published", style = "points" } },
      x_label = "M (kip ft)", y_label = "N (kip)", title = "A concrete column" }, "concrete_column.png")
  end,
}
