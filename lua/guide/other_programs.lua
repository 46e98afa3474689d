-- An elastic portal under dead load is pushed to the side, as the OpenSeesPy script beside it: see other_programs.md.
local hinge = require "hinge"

-- Sizes and properties: m, Pa. Density is needed in dynamics only.
local height, width, E, G = 4, 6, 210e9, 81e9
local steel = hinge.material { E = E, G = G, density = 7850 }
local column = hinge.section.general { area = 0.0106, Ix = 1.45e-4, Iy = 5.2e-5, J = 6.9e-7,
  shear_area_x = 0.006, shear_area_y = 0.0022 }
local girder = hinge.section.general { area = 0.0085, Ix = 2.31e-4, Iy = 1.3e-5, J = 5.1e-7,
  shear_area_x = 0.005, shear_area_y = 0.0029 }

-- Nodes, supports and members; the web of each column is in the plane of the frame.
local model = hinge.model { displacement = "small" }
local n = {}
for i, at in ipairs { { 0, 0 }, { 0, height }, { width, height }, { width, 0 } } do
  n[i] = model:node { at[1], 0, at[2] }
end
model:fix({ n[1], n[4] }, "all")
local left = model:member { n[1], n[2], section = column, material = steel, up = { 1, 0, 0 } }
model:member { n[2], n[3], section = girder, material = steel, up = { 0, 0, 1 } }
model:member { n[4], n[3], section = column, material = steel, up = { 1, 0, 0 } }

-- Two load cases: what stays, and what is scaled.
local dead, push = model:case "dead", model:case "push"
for _, head in ipairs { n[2], n[3] } do dead:load { node = head, force = { 0, 0, -100e3 } } end
push:load { node = n[2], force = { 1e3, 0, 0 } }

-- Dead load; then it is held, and the corner is driven by 20 mm in ten steps.
local rest = model:static { steps = 1, loads = "dead" }:finish()
local run = model:static { from = rest, loads = { push = 1 }, steps = 10, control = { node = n[2], "ux", to = 0.02 } }
run:finish()

print(("push %.3f kN at %.1f mm"):format(run.factor, 1e3 * n[2]:displacement(run)))
local fx, _, fz, _, my = n[1]:reaction(run)
print(("left foot %.3f kN, %.3f kN, %.3f kN m"):format(fx / 1e3, fz / 1e3, my / 1e3))
local at_foot, at_head = left:forces(run)
print(("left column N %.3f kN, Mx %.3f and %.3f kN m"):format(at_foot.N / 1e3, at_foot.Mx / 1e3, at_head.Mx / 1e3))

-- By hand, bending alone: 24 E I / h^3 (1 + 6 k) / (4 + 6 k), k = (I / L of the girder) / (I / h of the column).
local k = (girder.Ix / width) / (column.Ix / height)
local by_hand = 24 * E * column.Ix / height ^ 3 * (1 + 6 * k) / (4 + 6 * k) * 0.02
print(("push by hand, without shear and axial strain: %.3f kN"):format(by_hand / 1e3))
return { push_kN = run.factor }
