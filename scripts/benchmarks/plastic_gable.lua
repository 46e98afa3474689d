-- A pitched portal with pinned feet up to its plastic limit load.
--
-- Run     hinge run scripts/benchmarks/plastic_gable.lua
-- Shows   mechanisms of a frame with sloping members, first order, bending alone
-- Expect  span L, eaves at the height h, apex r above them, one redundant force: the thrust T at the right foot. The
--         moment at the right eaves is T h, at the apex V L / 4 + H h / 2 - T (h + r), with V at the apex and H at the
--         left eaves. Both are Mp at the limit: V L / 4 + H h / 2 = Mp (2 + r / h).
local hinge = require "hinge"

local L, h, r, E, EI, Mp = 20, 6, 3, 206e9, 33e6, 240e3 -- m, Pa, N m^2, N m
local steel = hinge.material { E = E, G = 1e15 }
local section = hinge.section.general { area = 0.05, Ix = EI / E, Iy = EI / E, J = EI / E, Mx0 = Mp }

-- The load factor of V at the apex and H at the left eaves, where the apex has sunk by 1 m.
local function limit(V, H)
  local model, node = hinge.model { displacement = "small" }, {}
  for i, at in ipairs { { 0, 0 }, { 0, h }, { L / 2, h + r }, { L, h }, { L, 0 } } do
    node[i] = model:node { at[1], 0, at[2] }
    model:fix(node[i], (i == 1 or i == 5) and "x,y,z,rx,rz" or "y,rx,rz")
    if i > 1 then
      model:member { node[i - 1], node[i], section = section, material = steel,
        up = (i == 2 or i == 5) and { 1, 0, 0 } or { 0, 0, 1 } }
    end
  end
  model:load { node = node[2], force = { H, 0, 0 } }
  model:load { node = node[3], force = { 0, 0, -V } }
  local run = model:static { steps = 20, control = { node = node[3], "uz", to = -1 } }:finish()
  assert(run.verdict == "completed", run.reason)
  return run.factor
end

return hinge.benchmark {
  title = "Plastic pitched portal", kind = "inelastic", fast = true, source = "closed form: statics at two hinges",
  run = function(b)
    local moment = Mp * (2 + r / h)
    local alone, both = 4 * moment / L, moment / (L / 4 + h / 2)
    b:row { "V at the apex", computed = alone * limit(alone, 0), reference = alone, unit = "N", tolerance = 1e-6,
      elements = 8, steps = 20 }
    b:row { "V at the apex, H = V at the eaves", computed = both * limit(both, both), reference = both, unit = "N",
      tolerance = 1e-6, elements = 8, steps = 20 }
  end,
}
