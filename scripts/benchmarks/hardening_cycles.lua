-- A bar that is stretched and pressed in cycles: three hardening rules and the work that a cycle takes.
--
-- Run     hinge run scripts/benchmarks/hardening_cycles.lua
-- Shows   kinematic, isotropic and saturating (Armstrong and Frederick) hardening of one fibre
-- Expect  strains of +-a, plastic strain e at a turn. Kinematic: straight lines of the slopes E and Et; a closed cycle
--         takes 4 fy e of a unit of volume, for its two halves flow by 2 e at a mean stress of fy. Isotropic: the
--         elastic range has grown by what the bar has hardened. Armstrong and Frederick, d back = (H - H |back| / s) d
--         e: the back stress is s (1 - exp(-H e / s)) at the first turn and s tanh(H e / s) at those of a stable cycle.
--         Steps of any length are exact where the flow keeps its direction: 1e-6 is the limit of statics.
local hinge = require "hinge"

local E, fy, L, area, a = 210e9, 235e6, 2, 1e-3, 0.01
local Et = E / 50

-- Stress (Pa) and strain of a bar that is driven to the strains `turns`, at each step; the dissipated work after each.
local function cycled(hardening, turns, steps)
  local model = hinge.model { displacement = "small" }
  local steel = hinge.material { E = E, yield_stress = fy, hardening = hardening }
  local wall, tip = model:node { 0, 0, 0 }, model:node { L, 0, 0 }
  model:fix(wall)
  model:member { wall, tip, section = hinge.section.general { area = area, Ix = 1e-7, Iy = 1e-7, J = 1e-7,
    plastic = { A = area } }, material = steel }
  model:load { node = tip, force = { area * fy, 0, 0 } }
  local strain, stress, work, at_turn, run = { 0 }, { 0 }, {}, {}, nil
  for i, to in ipairs(turns) do
    run = model:static { from = run, steps = steps, control = { node = tip, "ux", to = to * L } }
    while run:step() do
      strain[#strain + 1], stress[#stress + 1] = tip:displacement(run) / L, run.factor * fy
    end
    assert(run.verdict == "completed", run.reason)
    work[i], at_turn[i] = run.energy.plastic, stress[#stress]
  end
  return { strain = strain, stress = stress, work = work, at_turn = at_turn }
end

return hinge.benchmark {
  title = "Cycles of a bar, three hardening rules", kind = "inelastic", fast = true, source = "closed forms",
  run = function(b, job)
    local turns = { a, -a, a, -a, a }
    local row = b:rows_with { elements = 2 }
    local moves = cycled({ tangent = Et }, turns, 20)
    local first = fy + Et * (a - fy / E)
    row("kinematic: stress after a reversal", moves.at_turn[2], -first, "Pa", 1e-6, { steps = 40 })
    row("kinematic: work of a closed cycle", moves.work[3] + moves.work[4], 4 * fy * (a - first / E) * area * L, "J",
      1e-6, { steps = 80 })
    local grows = cycled({ tangent = Et, kinematic = 0 }, turns, 20)
    row("isotropic: stress after a reversal", grows.at_turn[2], -(first + Et * 2 * (a - first / E)), "Pa", 1e-6,
      { steps = 40 })
    local H, s = E / 20, 150e6
    local bends = cycled({ modulus = H, saturation = s }, turns, 40)
    -- a = (fy + back) / E + e, back = s (1 - exp(-H e / s)), by Newton's method
    local e = a / 2
    for _ = 1, 50 do
      local g = (fy + s * (1 - math.exp(-H * e / s))) / E + e - a
      e = e - g / (1 + H / E * math.exp(-H * e / s))
    end
    row("saturating: stress at the first turn", bends.at_turn[1], E * (a - e), "Pa", 1e-6, { steps = 40 })
    row("saturating: the same in two steps", cycled({ modulus = H, saturation = s }, { a }, 2).at_turn[1], E * (a - e),
      "Pa", 1e-6, { steps = 2 })
    local long = cycled({ modulus = H, saturation = s }, { a, -a, a, -a, a, -a, a, -a }, 40)
    e = a / 2
    for _ = 1, 200 do -- stable cycle: fy + s tanh(H e / s) = E (a - e); the eighth branch is 1.4e-5 from it
      e = a - (fy + s * (math.exp(2 * H * e / s) - 1) / (math.exp(2 * H * e / s) + 1)) / E
    end
    row("saturating: stress of a stable cycle", -long.at_turn[8], E * (a - e), "Pa", 3e-5, { steps = 320 })
    local series = {}
    for i, path in ipairs { moves, grows, bends } do
      local shown = { x = {}, y = {}, name = ({ "kinematic", "isotropic", "saturating" })[i] }
      for k = 1, #path.strain do shown.x[k], shown.y[k] = 100 * path.strain[k], path.stress[k] / 1e6 end
      series[i] = shown
    end
    job:plot({ series = series, x_label = "strain (%)", y_label = "stress (MPa)", title = "Cycles of a bar" },
      "hardening_cycles.png")
  end,
}
