-- A constant load that acts at once on one freedom, elastic and elastic-plastic, and a support that is lost at once.
--
-- Run     hinge run scripts/benchmarks/sudden_load.lua
-- Shows   the dynamic factor 2 of a sudden load and of a sudden loss of a support, and what yielding makes of it
-- Expect  twice the static displacement; u / u_y = 1 / (2 (1 - b)): 1.25 and 2.5 under b = 0.6 and 0.8 of the yield
--         load
--
-- The freedom is a bar of two elements that stretches, with a mass at its end; the bar's own mass is 1e-6 of that.
local hinge = require "hinge"

local E, side, L, yield, mass = 206e9, 0.05, 1, 245e6, 1000
local A = side ^ 2
local k, u_y = E * A / L, yield / E * L
local T = 2 * math.pi * math.sqrt(mass / k)
local section = hinge.section.solid { width = side, depth = side }

-- Greatest displacement of the mass under the part b of the yield load, over that at yield.
local function pulled(b)
  local model = hinge.model { displacement = "small" }
  local steel = hinge.material { E = E, density = 1e-6 * mass / (A * L), yield_stress = yield }
  local wall, tip = model:node { 0, 0, 0 }, model:node { L, 0, 0 }
  model:fix(wall)
  model:fix(tip, "y,z,rx,ry,rz")
  model:member { wall, tip, section = section, material = steel }
  model:mass { node = tip, mass = mass }
  model:load { node = tip, force = { b * yield * A, 0, 0 } }
  local run = model:dynamic { dt = T / 400, duration = 2 * T, record = false }
  local u = run:probe { node = tip, "ux" }
  run:finish()
  return u.max / u_y, run
end

-- A light beam, clamped at both ends, with a mass on a column in the middle, which is taken away. Returns the greatest
-- sag over the static one without the column, and its closed form: 2, less the part that the column gave way before.
local function lost_column()
  local model = hinge.model { displacement = "small", plasticity = false }
  local steel = hinge.material { E = E, density = 1e-6 * mass / (A * L) }
  local left, middle, right = model:node { 0, 0, 0 }, model:node { L, 0, 0 }, model:node { 2 * L, 0, 0 }
  local foot = model:node { L, 0, -L }
  model:fix({ left, right, foot })
  model:fix(middle, "x,y,rx,rz")
  model:member { left, middle, section = section, material = steel }
  model:member { middle, right, section = section, material = steel }
  local column = model:member { foot, middle, section = section, material = steel }
  model:mass { node = middle, mass = mass }
  model:gravity { 0, 0, -9.80665 }
  local rest = model:static { steps = 1 }:finish()
  model:remove { member = column, at = 0 }
  local bending = 1 / (L ^ 3 / (24 * E * side ^ 4 / 12) + L / (2 * 5 / 6 * E / 2.6 * A)) -- N/m, of both halves
  local period = 2 * math.pi * math.sqrt(mass / bending)
  local run = model:dynamic { from = rest, dt = period / 400, duration = period, record = false }
  local down = run:probe { node = middle, "uz" }
  run:finish()
  return -down.min / (mass * 9.80665 / bending), 2 - bending / (bending + k), run
end

return hinge.benchmark {
  title = "Sudden load and sudden loss of a support", kind = "dynamics", fast = true,
  source = "closed form: work of the load against the energy of the spring",
  run = function(b)
    for _, case in ipairs { { 0.4, 0.8, 1e-6 }, { 0.6, 1.25, 2e-5 }, { 0.8, 2.5, 2e-5 } } do
      local part, reference, tolerance = table.unpack(case)
      local computed, run = pulled(part)
      b:row { ("u / u_y, %.1f of the yield load"):format(part), computed = computed, reference = reference,
        tolerance = tolerance, elements = 2, steps = run.index }
    end
    local computed, reference, run = lost_column()
    b:row { "lost column, over the static sag", computed = computed, reference = reference, tolerance = 2e-4,
      elements = 6, steps = run.index }
  end,
}
