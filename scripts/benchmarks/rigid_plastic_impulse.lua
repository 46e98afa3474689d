-- Beams that get a velocity over their whole length, and stop by plastic hinges.
--
-- Run     hinge run scripts/benchmarks/rigid_plastic_impulse.lua
-- Shows   hinges that travel from the supports to midspan; small displacement, without membrane forces
-- Expect  m V^2 h^2 / (6 Mp) = 42.7 mm at midspan of a clamped beam, twice as much of a simply supported one
--
-- The closed form has no elasticity. With 1000 times the stiffness of steel the elastic energy is small; with that of
-- steel the midspan stops 15 % (clamped) and 12 % (simply supported) deeper.
local hinge = require "hinge"

local E, density, side, yield, h, V, elements = 206e9, 7850, 0.05, 245e6, 0.5, 20, 16 -- h: half of the span, m
local Mp, line = yield * side ^ 3 / 4, density * side ^ 2

-- Half of the beam. Returns the mean displacement of midspan after it has stopped, mm.
local function stopped(supports)
  local model = hinge.model { displacement = "small", elements_per_member = elements }
  local steel = hinge.material { E = 1000 * E, density = density, yield_stress = yield }
  local support, middle = model:node { 0, 0, 0 }, model:node { h, 0, 0 }
  model:fix(support, supports)
  model:fix(middle, "x,y,rx,ry,rz")
  model:member { support, middle, section = hinge.section.solid { width = side, depth = side }, material = steel,
    group = "beam" }
  model:velocity("beam", { 0, 0, -V })
  local run = model:dynamic { dt = 5e-6, duration = 0.012, record = false }
  local down, sum, count = run:probe { node = middle, "uz" }, 0, 0
  run:finish()
  for i, t in ipairs(down.time) do
    if t > 0.0115 then sum, count = sum - 1e3 * down.value[i], count + 1 end
  end
  return sum / count, run.index
end

return hinge.benchmark {
  title = "Rigid-plastic beams under an impulse", kind = "dynamics",
  source = "closed form of rigid-plastic theory (Jones, Structural Impact)",
  run = function(b)
    for _, case in ipairs { { "clamped", "all", 1 }, { "simply supported", "x,y,z,rx,rz", 2 } } do
      local what, supports, times = table.unpack(case)
      local computed, steps = stopped(supports)
      b:row { what .. ": midspan", computed = computed, reference = times * 1e3 * line * V ^ 2 * h ^ 2 / (6 * Mp),
        unit = "mm", tolerance = 0.015, elements = elements, steps = steps }
    end
  end,
}
