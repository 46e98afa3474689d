-- A thin beam bends about both axes and twists under a weight at its tip: the Princeton beam.
--
-- Run     hinge run scripts/benchmarks/princeton_beam.lua
-- Shows   the coupling of bending about two axes with torsion, by large displacements alone
-- Expect  the beam of the experiment of E. H. Dowell and J. J. Traybar (1975): aluminium, 0.508 m, 12.377 x 3.2024 mm,
--         clamped with its section turned about its axis, 13.345 N at the tip. The reference is not the experiment. It
--         is computed apart, by shooting on the exact rod with E = 71.7 GPa and nu = 0.31. The errors are of second
--         order in the length of the elements where the beam twists, and of fourth order where it does not (90 degrees)
local hinge = require "hinge"

local L, wide, thin, weight, steps = 0.508, 12.377e-3, 3.2024e-3, 13.345, 12

-- What the tip does: displacement across the wide side (flap), across the thin side (chord) and along the beam, m, and
-- the angle by which its wide side has turned in the plane across the beam, degrees. `degrees`: of the section; 0: the
-- weight acts along the wide side.
local function tip_of(degrees, elements)
  local model = hinge.model { plasticity = false }
  local aluminium, angle, last = hinge.material { E = 71.7e9, nu = 0.31 }, math.rad(degrees), nil
  local section = hinge.section.solid { width = wide, depth = thin } -- its y axis, `up`, is across the wide side
  for i = 0, elements // 2 do
    local node = model:node { 2 * i / elements * L, 0, 0 }
    if last then
      model:member { last, node, section = section, material = aluminium,
        up = { 0, math.cos(angle), math.sin(angle) } }
    else model:fix(node) end
    last = node
  end
  model:load { node = last, force = { 0, 0, -weight } }
  local ux, uy, uz, rx, ry, rz = last:displacement(model:static { steps = steps }:finish())
  -- the wide side { 0, sin, -cos } turned by the rotation vector (Rodrigues)
  local w, r, t = { 0, math.sin(angle), -math.cos(angle) }, { rx, ry, rz }, math.sqrt(rx ^ 2 + ry ^ 2 + rz ^ 2)
  local along, turned = (rx * w[1] + ry * w[2] + rz * w[3]) / t ^ 2, {}
  for i = 1, 3 do
    local j, k = i % 3 + 1, (i + 1) % 3 + 1
    turned[i] = math.cos(t) * w[i] + math.sin(t) / t * (r[j] * w[k] - r[k] * w[j]) + (1 - math.cos(t)) * along * r[i]
  end
  return { flap = -(uy * math.cos(angle) + uz * math.sin(angle)), chord = uy * w[2] + uz * w[3], axial = ux,
    twist = math.deg(math.atan(turned[3], turned[2]) - math.atan(w[3], w[2])) }
end

return hinge.benchmark {
  title = "Princeton beam", kind = "elastic", fast = true,
  source = "shooting on the exact rod; the beam of Dowell and Traybar 1975",
  run = function(b)
    local coarse, fine = tip_of(45, 8), tip_of(45, 16)
    for _, row in ipairs { { "flap", 0.156588, "m", 4e-4 }, { "chord", 0.015342, "m", 0.005 },
      { "axial", -0.030361, "m", 8e-4 }, { "twist", 3.485, "degrees", 0.003 } } do
      local name, reference, unit, tolerance = table.unpack(row)
      b:row { name .. ", section at 45 degrees", computed = fine[name], reference = reference, unit = unit,
        elements = 16, steps = steps, tolerance = tolerance }
    end
    b:row { "flap, section at 90 degrees", computed = tip_of(90, 8).flap, reference = 0.200693, unit = "m",
      elements = 8, steps = steps, tolerance = 6e-5 }
    b:row { "observed order, chord, 8 to 16 elements", reference = 2, elements = 16, steps = steps, tolerance = 0.03,
      computed = math.log((coarse.chord - 0.015342) / (fine.chord - 0.015342), 2) }
  end,
}
