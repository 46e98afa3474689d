-- The elastica: a clamped column is pressed far beyond Euler's load, until its top looks sideways and down again.
--
-- Run     hinge run scripts/benchmarks/elastica.lua
-- Shows   postbuckling with rotations up to 140 degrees
-- Expect  P / P_E = (2 K / pi)^2 with K the complete elliptic integral of the modulus sin(t / 2), t: rotation of the
--         top. At 140 degrees the top is 0.107 L below the clamped end. The error is seen to fall with the fourth
--         power of the number of elements; the reference of that row is this observation, and no theory
local hinge = require "hinge"

local E, L, I = 200e9, 1, 1e-8
-- L / r = 1000 and large shear areas: the elastica neither shortens nor shears.
local section = hinge.section.general { area = 1e-2, Ix = I, Iy = 1e3 * I, J = I, shear_area_x = 0.1,
  shear_area_y = 0.1 }
local euler = math.pi ^ 2 * E * I / (4 * L ^ 2)

-- (2 K / pi)^2 by the arithmetic-geometric mean, and the height of the top, 2 E / K - 1, in L.
local function exact(degrees)
  local k = math.sin(math.rad(degrees) / 2)
  local a, g, sum, power = 1, math.sqrt(1 - k ^ 2), k ^ 2 / 2, 0.5
  for _ = 1, 10 do
    power = 2 * power
    sum = sum + power * ((a - g) / 2) ^ 2
    a, g = (a + g) / 2, math.sqrt(a * g)
  end
  return 1 / a ^ 2, 2 * (1 - sum) - 1 -- E / K = 1 - sum
end

-- The load in P_E and the height of the top at these rotations of the top. A small moment makes the column bend.
local function column(elements, angles)
  local model = hinge.model { plasticity = false, elements_per_member = elements }
  local foot, top = model:node { 0, 0, 0 }, model:node { 0, 0, L }
  model:fix(foot)
  model:fix(top, "y,rx,rz")
  model:member { foot, top, section = section, material = hinge.material { E = E } }
  model:load { node = top, force = { 0, 0, -euler }, moment = { 0, 1e-6 * euler * L, 0 } }
  local found = {}
  for i, degrees in ipairs(angles) do
    local run = model:static { steps = 20, control = { node = top, "ry", to = math.rad(degrees) } }:finish()
    found[i] = { run.factor, select(3, top:position()) / L }
  end
  return found
end

return hinge.benchmark {
  title = "Elastica of a clamped column", kind = "stability", fast = true,
  source = "closed form (Euler 1744; S. P. Timoshenko, J. M. Gere, Theory of Elastic Stability, chapter 2)",
  run = function(b)
    local angles = { 20, 60, 100, 140 }
    local found = column(16, angles)
    for i, degrees in ipairs(angles) do
      local P = exact(degrees)
      b:row { ("P / P_E at %d degrees"):format(degrees), computed = found[i][1], reference = P, tolerance = 3e-5,
        elements = 16, steps = 20 }
    end
    local _, height = exact(140)
    b:row { "height of the top at 140 degrees / L", computed = found[4][2], reference = height, tolerance = 4e-4,
      elements = 16, steps = 20 }
    local error = {}
    for _, elements in ipairs { 4, 8 } do error[elements] = column(elements, { 100 })[1][1] - exact(100) end
    b:row { "order at 100 degrees, 4 to 8 elements", computed = math.log(error[4] / error[8], 2), reference = 4,
      tolerance = 0.05, elements = 8, steps = 20 }
  end,
}
