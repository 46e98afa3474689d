-- A short thick beam, so that shear counts; upright y, along x. Iy is not Ix.
local hinge = require "hinge"
local scenes = require "scenes"

local short = { L = 2, A = 0.02, Ix = 8e-5, Iy = 3e-5, J = 5e-5, Ax = 0.009, Ay = 0.011, E = 200e9, G = 77e9,
  rho = 7850 }
short.steel = hinge.material { E = short.E, G = short.G, density = short.rho }
short.section = hinge.section.general { area = short.A, Ix = short.Ix, Iy = short.Iy, J = short.J,
  shear_area_x = short.Ax, shear_area_y = short.Ay }

--- 12 E I / (G A L^2): how much of its bending a beam shears.
function short.phi(I, area) return 12 * short.E * I / (short.G * area * short.L ^ 2) end

--- Joints at `points`, one member between each and the next; fixed: by joint. Returns { model =, node =, member = }.
function short.beam(points, fixed, options)
  local s = { model = hinge.model(scenes.with({ displacement = "small" }, options)), node = {}, member = {} }
  for i, p in ipairs(points) do s.node[i] = s.model:node(p) end
  for i, what in pairs(fixed) do s.model:fix(s.node[i], what) end
  for i = 1, #points - 1 do
    s.member[i] = s.model:member { s.node[i], s.node[i + 1], section = short.section, material = short.steel,
      up = { 0, 0, 1 }, group = "beam" }
  end
  return s
end

--- One member.
function short.straight(fixed, options) return short.beam({ { 0, 0, 0 }, { short.L, 0, 0 } }, fixed, options) end

return short
