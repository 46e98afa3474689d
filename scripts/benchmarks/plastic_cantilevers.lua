-- Cantilevers whose root becomes fully plastic by eq 14 of the paper.
--
-- Run     hinge run scripts/benchmarks/plastic_cantilevers.lua
-- Shows   that a run ends on eq 14: two moments, N with a moment, and torsion with a moment, first order
-- Expect  (N / N0)^2 + (Mx / Mx0)^2 + (My / My0)^2 + (Mz / Mz0)^2 = 1 at the root when the run finds no further
--         equilibrium. How far eq 14 is from the stress distribution of a section stands in interaction_eq14.lua.
local hinge = require "hinge"

local side, fy, L = 0.05, 245e6, 1
local N0, Mp, T0 = fy * side ^ 2, fy * side ^ 3 / 4, fy / math.sqrt(3) * side ^ 3 / 3 -- T0: sand heap
local steel = hinge.material { E = 206e9, yield_stress = fy }
local square = hinge.section.solid { width = side, depth = side }

-- The factor of the limit: `held` forces stay, `push` grows; `arm`: a second member along y with the tip at its end.
local function limit(push, held, arm)
  local model = hinge.model { displacement = "small", interaction = "paper" }
  local root, corner = model:node { 0, 0, 0 }, model:node { L, 0, 0 }
  model:fix(root)
  model:member { root, corner, section = square, material = steel }
  local tip = corner
  if arm then
    tip = model:node { L, arm, 0 }
    model:member { corner, tip, section = square, material = steel }
  end
  model:case "held":load { node = tip, force = held or { 0, 0, 0 } }
  model:case "push":load { node = tip, force = push }
  local first = model:static { loads = { held = 1 }, steps = 2 }:finish()
  local run = model:static { from = first, loads = { push = 1 }, steps = 20, to_limit = true }:finish()
  assert(run.limit, run.reason)
  return run.factor
end

return hinge.benchmark {
  title = "Plastic cantilevers, eq 14", kind = "inelastic", fast = true, source = "closed forms: eq 14 at the root",
  run = function(b)
    local row = b:rows_with { unit = "N", tolerance = 4e-5, elements = 2, steps = 20 }
    local F, angle = 1.5 * Mp / L, math.rad(30)
    row("push at 30 degrees to an axis", F * limit { 0, F * math.cos(angle), F * math.sin(angle) }, Mp / L)
    row("push beside N = N0 / 2", F * limit({ 0, 0, F }, { N0 / 2, 0, 0 }), Mp / L * math.sqrt(3 / 4))
    row("push and N = 3 times the push", F * limit { 3 * F, 0, F }, 1 / math.sqrt((L / Mp) ^ 2 + (3 / N0) ^ 2))
    row("L in plan, arms 1 and 1 m", F * limit({ 0, 0, F }, nil, 1), 1 / math.sqrt((L / Mp) ^ 2 + (1 / T0) ^ 2))
    row("L in plan, arms 1 and 0.5 m", F * limit({ 0, 0, F }, nil, 0.5), 1 / math.sqrt((L / Mp) ^ 2 + (0.5 / T0) ^ 2))
  end,
}
