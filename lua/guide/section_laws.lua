-- A column of HEB 300 is pushed over under axial forces, by eq 14 and by the exact interaction. See section_laws.md.
local hinge = require "hinge"

local L, fy = 3, 235e6
local steel = hinge.material { E = 210e9, density = 7850, yield_stress = fy }
local function heb300(interaction)
  return hinge.section.h { depth = 0.3, width = 0.3, web = 0.011, flange = 0.019, r = 0.027, interaction = interaction }
end

-- The moment at the foot of a column that cannot carry more, over Mx0; its head carries n N0.
local function carried(interaction, n)
  local section = heb300(interaction)
  local model = hinge.model { displacement = "small" }
  local foot, head = model:node { 0, 0, 0 }, model:node { 0, 0, L }
  model:member { foot, head, section = section, material = steel, up = { 0, 1, 0 } }
  model:fix(foot, "all")
  model:case "weight":load { node = head, force = { 0, 0, -n * section.plastic_area * fy } }
  model:case "push":load { node = head, force = { 0, section.Zx * fy / L, 0 } }
  local loaded = model:static { loads = { weight = 1 } }
  loaded:finish()
  local run = model:static { from = loaded, loads = { push = 1.5 }, steps = 20, to_limit = true }
  run:finish()
  return 1.5 * (run.factor or 0)
end

-- EN 1993-1-1, 6.2.9.1 (5): what the standard gives for an H about its strong axis.
local section = heb300 "exact"
local a = math.min(0.5, (section.area - 2 * 0.3 * 0.019) / section.area)
local function standard(n) return math.min(1, (1 - n) / (1 - 0.5 * a)) end

print "N / N0   M / Mx0: a run, exact   by hand   a run, eq 14   by hand   EN 1993-1-1"
for _, n in ipairs { 0, 0.2, 0.4, 0.6, 0.8 } do
  print(("%5.1f %20.3f %12.3f %12.3f %10.3f %12.3f"):format(n, carried("exact", n), (section:reduced_moments(n)),
    carried("paper", n), math.sqrt(1 - n ^ 2), standard(n)))
end

local curves = { exact = { name = "exact" }, eq14 = { name = "eq 14" },
  en = { name = "EN 1993-1-1", dashed = true } }
for _, c in pairs(curves) do c.x, c.y = {}, {} end
for i = 0, 100 do
  local n = i / 100
  for name, m in pairs { exact = (section:reduced_moments(n)), eq14 = math.sqrt(1 - n ^ 2), en = standard(n) } do
    table.insert(curves[name].x, m)
    table.insert(curves[name].y, n)
  end
end
hinge.plot({ series = { curves.exact, curves.eq14, curves.en }, title = "HEB 300 about its strong axis",
  x_label = "M / Mx0", y_label = "N / N0", width = 900, height = 700 }, "section_laws.png")
return { exact_at_half = carried("exact", 0.5), eq14_at_half = carried("paper", 0.5) }
