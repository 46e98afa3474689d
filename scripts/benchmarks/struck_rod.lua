-- A mass strikes a rod that is clamped at its other end: St Venant's waves.
--
-- Run     hinge run scripts/benchmarks/struck_rod.lua
-- Shows   the first wave, its doubling at the wall, and what the mass sends after it; struck_rod.png has both forces
-- Expect  forces in units of E A v / c: exp(-1) at the struck end when the wave is at the wall, 2 exp(-1) at the wall
--         when it is back, and 2 (1 + exp(-2)) = 2.27 at the wall at its second arrival there
--
-- The mass is as large as that of the rod and stays at its end. The integrator takes out the waves that are too short
-- for the elements (rho_infinity = 0.5). The peak at the second arrival is a jump, which the elements round off.
local hinge = require "hinge"

local E, density, side, L, v, elements = 206e9, 7850, 0.05, 1, 5, 200
local A, c = side ^ 2, math.sqrt(E / density)
local unit = E * A * v / c -- N

local function strike()
  local model = hinge.model { displacement = "small", plasticity = false }
  local steel = hinge.material { E = E, density = density }
  local wall, struck = model:node { 0, 0, 0 }, model:node { L, 0, 0 }
  model:fix(wall)
  model:fix(struck, "y,z,rx,ry,rz")
  local rod = model:member { wall, struck, section = hinge.section.solid { width = side, depth = side },
    material = steel, elements = elements }
  model:mass { node = struck, mass = density * A * L }
  model:velocity(struck, { -v, 0, 0 })
  local run = model:dynamic { dt = L / c / elements / 2, duration = 3.4 * L / c, rho_infinity = 0.5, record = false }
  local times, at_wall, at_end = {}, {}, {}
  run:on_step(function(r)
    local foot, head = r:forces(rod)
    times[r.index], at_wall[r.index], at_end[r.index] = r.time * c / L, -foot.N / unit, -head.N / unit
  end)
  run:finish()
  return times, at_wall, at_end, run
end

-- Closed form at the wall, by the time in L / c.
local function closed(t)
  if t < 1 then return 0 end
  local first = 2 * math.exp(1 - t)
  if t < 3 then return first end
  return first + 2 * (1 - 2 * (t - 3)) * math.exp(3 - t) -- the mass sends on the wave of the wall
end

return hinge.benchmark {
  title = "Rod struck by a mass", kind = "dynamics", fast = true, source = "closed form: St Venant's waves in a rod",
  run = function(b, job)
    local times, at_wall, at_end, run = strike()
    local row = b:rows_with { unit = "E A v/c", elements = elements, steps = run.index }
    local index = 2 * elements -- of the time L / c
    row("struck end at L / c", at_end[index], math.exp(-1), nil, 8e-3)
    row("wall at 2 L / c", at_wall[2 * index], 2 * math.exp(-1), nil, 8e-3)
    local peak = 0
    for i, t in ipairs(times) do if t > 2.5 and at_wall[i] > peak then peak = at_wall[i] end end
    row("wall, second arrival", peak, 2 + 2 * math.exp(-2), nil, 8e-3)
    row("wall at 3.3 L / c", at_wall[3.3 * index // 1 | 0], closed(3.3), nil, 4e-3)
    local wanted = {}
    for i, t in ipairs(times) do wanted[i] = closed(t) end
    job:plot({ series = { { x = times, y = at_wall, name = "wall" }, { x = times, y = at_end, name = "struck end" },
      { x = times, y = wanted, name = "wall, closed form", dashed = true } }, x_label = "c t / L",
      y_label = "force c / (E A v)", title = "rod struck by a mass" }, "struck_rod.png")
  end,
}
