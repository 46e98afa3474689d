-- The frame of Bathe and Wilson: natural frequencies of ten bays and nine storeys.
--
-- Run     hinge run scripts/benchmarks/bathe_wilson.lua
-- Shows   frequencies of a whole frame from its free vibration, with two elements a member
-- Expect  the three lowest eigenvalues 0.5895, 5.527 and 16.59 1/s^2
--
-- Units are those of the source: ft, kip, s. The mass of the members is at their ends, as in the source. The frame is
-- pulled at its roof and at two floors and then let go. The step makes vibrations slower by a known amount, which is
-- taken out.
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "support/?.lua;" .. package.path
local hinge = require "hinge"
local frequency = require "vibration".frequency

local bays, storeys, bay, storey = 10, 9, 20, 10
local E, A, I, mass = 432000, 3, 1, 3 -- kip/ft^2, ft^2, ft^4, kip s^2/ft^2
local reference = { 0.589541, 5.52695, 16.5878 } -- 1/s^2

local function frame()
  local model = hinge.model { displacement = "small", plasticity = false }
  local grid = hinge.grid { model = model, x = { count = bays, spacing = bay },
    z = { count = storeys, spacing = storey } }
  local material = hinge.material { E = E, density = 1e-6 * mass / A }
  -- no shear deformation, and no rotary inertia
  local section = hinge.section.general { area = A, Ix = I, Iy = I, J = I, shear_area_x = 1e4 * A,
    shear_area_y = 1e4 * A, mass_Ix = 1e-6, mass_Iy = 1e-6 }
  grid:fix "all"
  for level = 1, storeys do grid:fix("y,rx,rz", level) end
  grid:defaults { section = section, material = material }
  grid:columns {}
  grid:beams { along = "x" }
  for _, member in ipairs(model:members()) do
    for _, node in ipairs(member:nodes()) do model:mass { node = node, mass = mass * member.length / 2 } end
  end
  return model, grid
end

return hinge.benchmark {
  title = "Frame of Bathe and Wilson", kind = "dynamics", fast = true,
  source = "Bathe and Wilson (1972), as in the verification of SAP2000 and Peterson (1981)",
  run = function(b)
    local model, grid = frame()
    local pulls = {}
    for _, place in ipairs { { 9, 1 }, { 5, -2 }, { 3, 2 } } do
      pulls[#pulls + 1] = model:load { node = grid:node("F1", place[1]), force = { place[2], 0, 0 } }
    end
    local pulled = model:static { steps = 1 }:finish()
    for _, pull in ipairs(pulls) do pull:remove() end
    local dt = 0.05
    local run = model:dynamic { from = pulled, dt = dt, duration = 100, solver = "direct", record = false }
    local roof = run:probe { node = grid:node("F1", 9), "ux" }
    run:finish()
    for i, eigenvalue in ipairs(reference) do
      local w = 2 / dt * math.tan(frequency(roof, dt, math.sqrt(eigenvalue)) * dt / 2)
      b:row { ("eigenvalue %d"):format(i), computed = w ^ 2, reference = eigenvalue, unit = "1/s^2", tolerance = 1e-5,
        elements = model:counts().elements, steps = run.index }
    end
  end,
}
