-- A ten-storey frame by its grid. See grid.md.
local hinge = require "hinge"

local steel = hinge.material.steel "S355"
local model = hinge.model {}
local grid = hinge.grid { model = model, x = { count = 4, spacing = 6 }, y = { count = 3, spacing = 5 },
  z = { count = 10, spacing = 3.5 } }
grid:fix "all"
grid:defaults { material = steel }
for storey = 1, grid.storeys do
  local size = storey <= 4 and "HEM 300" or storey <= 7 and "HEB 300" or "HEA 300"
  grid:columns { storeys = { storey }, section = hinge.section.named(size), up = { 1, 0, 0 }, group = "columns" }
end
grid:beams { along = "x", section = hinge.section.named "IPE 400", group = "beams" }
grid:beams { along = "y", section = hinge.section.named "IPE 300", group = "beams" }
for _, ends in ipairs { { "A1", "A2" }, { "E3", "E4" } } do
  grid:braces { from = ends[1], to = ends[2], section = hinge.section.named "HEA 160", group = "braces" }
end
model:load { group = "beams", q = { 0, 0, -20e3 } }
model:load { node = grid:node "E4, storey 10", force = { 50e3, 50e3, 0 } }

local run = model:static { steps = 1 }:finish()
local top = grid:node "E4, storey 10"
local x, y, z = top:displacement(run)
print(("%d nodes, %d members"):format(#model:nodes(), #model:members()))
print(("%s moves by %.1f, %.1f and %.1f mm"):format(grid:name(top), 1e3 * x, 1e3 * y, 1e3 * z))
local worst = { f_y = 0 }
for i, f_y in ipairs(run:read("f_y", "columns")) do
  if f_y > worst.f_y then worst = { f_y = f_y, member = run:read("member", "columns")[i] } end
end
local foot = model:members()[worst.member].a
print(("the column from %s has f_y = %.2f"):format(grid:name(foot), worst.f_y))
hinge.picture(run, { width = 900, height = 1000 }, "grid.png")
