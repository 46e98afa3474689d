-- A weight falls on the middle of a light beam.
--
-- Run     hinge run scripts/benchmarks/falling_weight.lua
-- Shows   contact of two members under gravity: the greatest deflection by the height of the fall
-- Expect  1 + sqrt(1 + 2 h / u) times the static deflection u: 2 for h = 0, 5.58 for h = 10 u
--
-- The weight is a thick short bar across the beam. The beam has 1e-3 of its mass, and the contact is 300 times as stiff
-- as the beam: both are zero and infinite in the closed form. With the default stiffness of contact, which is that of a
-- piece of steel, so light a beam takes much shorter steps.
local hinge = require "hinge"

local E, nu, side, L, weight, g = 206e9, 0.3, 0.05, 2, 100, 9.80665 -- kg
local G, A = E / (2 * (1 + nu)), side ^ 2
local u = weight * g * (L ^ 3 / (48 * E * side ^ 4 / 12) + L / (4 * 5 / 6 * G * A)) -- m, static

-- Greatest deflection of midspan, m.
local function fall(h)
  local model = hinge.model { plasticity = false }
  local light = hinge.material { E = E, nu = nu, density = 1e-3 * weight / (A * L) }
  local left, middle, right = model:node { 0, 0, 0 }, model:node { L / 2, 0, 0 }, model:node { L, 0, 0 }
  model:fix({ left, right }, "y,z,rx,rz")
  model:fix(middle, "x,y,rx,rz")
  local section = hinge.section.solid { width = side, depth = side }
  model:member { left, middle, section = section, material = light, group = "beam" }
  model:member { middle, right, section = section, material = light, group = "beam" }
  local size, length = 0.1, 0.2
  local a = model:node { L / 2, -length / 2, h + (side + size) / 2 }
  local b = model:node { L / 2, length / 2, h + (side + size) / 2 }
  model:member { a, b, section = hinge.section.solid { width = size, depth = size }, group = "weight",
    material = hinge.material { E = E, density = weight / (size ^ 2 * length) } }
  model:fix({ a, b }, "x,y,rx,ry,rz")
  model:gravity { 0, 0, -g }
  model:contact { between = { "beam", "weight" }, stiffness = 300 * weight * g / u }
  local period = 2 * math.pi * math.sqrt(u / g)
  local run = model:dynamic { dt = period / 500, duration = math.sqrt(2 * h / g) + period * 0.52, record = false }
  local down = run:probe { node = middle, "uz" }
  run:finish()
  return -down.min, run
end

return hinge.benchmark {
  title = "Weight that falls on a beam", kind = "dynamics",
  source = "closed form: energy of a beam without mass (Timoshenko, Strength of Materials)",
  run = function(b)
    for _, case in ipairs { { 0, 4e-3 }, { 10, 2e-3 }, { 100, 1e-3 } } do
      local times, tolerance = table.unpack(case)
      local deepest, run = fall(times * u)
      b:row { ("factor, height %d u"):format(times), computed = deepest / u, reference = 1 + math.sqrt(1 + 2 * times),
        tolerance = tolerance, elements = 6, steps = run.index }
    end
  end,
}
