-- The beginning of a script for report_test.lua and live_test.lua: a frame of two storeys, and a bar that flies into a
-- column. The groups of the beams and of the bar have names that would hurt as markup.
return [=[
local hinge = require "hinge"
local how = ...
local steel = hinge.material { E = 206e9, density = 7850, yield_stress = 235e6 }
local tube = hinge.section.box { width = 0.15, depth = 0.15, thickness = 0.006 }
local solid = hinge.section.solid { width = 0.1, depth = 0.1 }
local evil = "<img src=x onerror=window.hurt=1>, \"quoted\""
local model = hinge.model { interaction = "paper" }
local node = {}
for i = 0, 1 do
  node[i] = {}
  for k = 0, 2 do node[i][k] = model:node { 4 * i, 0, 3 * k } end
  model:fix(node[i][0])
  for k = 1, 2 do
    model:member { node[i][k - 1], node[i][k], section = tube, material = steel, group = "columns" }
    if i > 0 then model:member { node[0][k], node[1][k], section = tube, material = steel,
      group = "<script>window.hurt = 1</script>" } end
  end
end
local bar = model:member { model:node { -0.2, -0.3, 1.5 }, model:node { -0.2, 0.3, 1.5 }, section = solid,
  material = steel, group = evil }
model:velocity(bar, { 90, 0, 0 })
model:contact {}
model:gravity { 0, 0, -9.81 }
]=]
