-- A beam of two spans under a load that stays and one that comes and goes: shakedown and incremental collapse.
--
-- Run     hinge run scripts/benchmarks/shakedown.lua
-- Shows   hinges that turn a little more in every cycle, below the plastic limit load
-- Expect  loads P at both midspans, spans L, one of them cycles between 0 and P. Elastic moments in P L / 64: 13 under
--         the load that stays while it is alone, -12 at the middle support under both. A residual moment R at the
--         support is R / 2 at midspan. Mp - 13 / 64 P L >= R / 2 and R >= 12 / 64 P L - Mp can both be kept up to the
--         shakedown load P_s = 96 / 19 Mp / L, where the limit load is 6 Mp / L. Beyond it R has to change in each
--         cycle by 3 Mp (P / P_s - 1), which takes a rotation of 4 L / 3 EI times as much at midspan: the deflection
--         there grows by L / 4 times that, Mp L^2 / EI (P / P_s - 1), in each cycle.
local hinge = require "hinge"

local E, side, fy, L = 206e9, 0.05, 245e6, 1
local Mp, EI = fy * side ^ 3 / 4, E * side ^ 4 / 12
local steel = hinge.material { E = E, G = 1e15, yield_stress = fy } -- G: a beam that does not shear
local square = hinge.section.solid { width = side, depth = side }
local shakedown, unit = 96 / 19 * Mp / L, Mp * L ^ 2 / EI

-- Deflection under the load that stays, after each cycle of the other one.
local function cycled(P, cycles)
  local model, node = hinge.model { displacement = "small" }, {}
  for i = 0, 4 do
    node[i] = model:node { i * L / 2, 0, 0 }
    model:fix(node[i], i % 2 == 1 and "y,rx,rz" or "y,z,rx,rz")
    if i > 0 then model:member { node[i - 1], node[i], section = square, material = steel } end
  end
  model:fix(node[0], "x")
  model:case "stays":load { node = node[1], force = { 0, 0, -P } }
  model:case "cycles":load { node = node[3], force = { 0, 0, -P } }
  local run = model:static { loads = { stays = 1 }, steps = 8 }:finish()
  local w = {}
  for i = 1, cycles do
    for _, factor in ipairs { 1, 0 } do
      run = model:static { from = run, loads = { stays = 1, cycles = factor }, steps = 4 }:finish()
      assert(run.verdict == "completed", run.reason)
    end
    w[i] = -select(3, node[1]:displacement(run))
  end
  return w
end

return hinge.benchmark {
  title = "Shakedown of a beam of two spans", kind = "inelastic", fast = true,
  source = "closed form, Melan's theorem with one redundant moment",
  run = function(b, job)
    local cycles, series, growth = 12, {}, {}
    for _, times in ipairs { 0.98, 1.02, 1.06 } do
      local w, number = cycled(times * shakedown, cycles), {}
      growth[times] = w[cycles] - w[cycles - 1]
      for i = 1, cycles do w[i], number[i] = w[i] / unit, i end
      series[#series + 1] = { x = number, y = w, name = ("P = %.2f P_s"):format(times), style = "line and points" }
    end
    local function row(what, computed, reference, u, scale)
      b:row { what, computed = computed, reference = reference, unit = u, tolerance = 1e-5, scale = scale, elements = 8,
        steps = 8 * cycles }
    end
    row("0.98 P_s: growth in the 12th cycle", growth[0.98], 0, "m", unit)
    row("1.06 P_s: growth in the 12th cycle", growth[1.06], 0.06 * unit, "m")
    row("load without growth", shakedown * (1.06 - 0.04 * growth[1.06] / (growth[1.06] - growth[1.02])), shakedown, "N")
    job:plot({ series = series, x_label = "cycle", y_label = "deflection at midspan, in Mp L^2 / EI",
      title = "Shakedown and incremental collapse" }, "shakedown.png")
  end,
}
