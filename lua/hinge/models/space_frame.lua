-- The space frame of the paper's section 3 (figure 8): a cube of four columns, fixed at their feet, and four beams.
--
-- Reconstructed, because figure 8 is lost: side 0.25 m, solid square members of 20 mm, steel with a yield
-- stress of 245 MPa. With them 8 kN is elastic and 12 kN plastic below collapse, as sections 3.1 and 3.2 say.
-- Every one is an option. From the paper: the feet are fixed, and a horizontal load acts on an upper corner,
-- here along the beam from it (x).
local hinge = require "hinge"
local check = require "hinge.library.check"

local space_frame = {}
local where = "space_frame.add"

local rules = {
  side = { "number", unit = "m", above = 0, default = 0.25 },
  thickness = { "number", unit = "m", above = 0, default = 0.02 },
  material = { "material", default = hinge.material { E = 206e9, nu = 0.3, density = 7850, yield_stress = 245e6 } },
  exact_elements = { "number", whole = true, at_least = 1, optional = true },
}

-- The section with smaller shear areas, so that a midpoint element of length l has the exact stiffness: MacNeal's
-- residual bending flexibility, 1/GA' = 1/GA + l^2/12EI. Only for elements with their integration point in the middle.
local function softened(s, material, l)
  local function shear_area(area, I) return 1 / (1 / area + material.G * l ^ 2 / (12 * material.E * I)) end
  return hinge.section.general {
    area = s.area, Ix = s.Ix, Iy = s.Iy, J = s.J,
    shear_area_x = shear_area(s.shear_area_x, s.Iy), shear_area_y = shear_area(s.shear_area_y, s.Ix),
    plastic = { A = s.plastic_area, Zx = s.Zx, Zy = s.Zy, Zz = s.Zz }, size = { width = s.width, depth = s.depth },
  }
end

--- Adds the frame to a model. Options and what is returned: see words/models.d.lua.
function space_frame.add(model, options)
  check.model(where, model)
  local o = check.options(where, options, rules)
  local section = hinge.section.solid { width = o.thickness, depth = o.thickness }
  if o.exact_elements then section = softened(section, o.material, o.side / o.exact_elements) end
  local corners = { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } } -- the loaded one first, round the cube

  local feet, joints = {}, {}
  for i, c in ipairs(corners) do
    feet[i] = model:node { c[1] * o.side, c[2] * o.side, 0 }
    joints[i] = model:node { c[1] * o.side, c[2] * o.side, o.side }
  end
  model:fix(feet, "all")
  for i = 1, 4 do
    model:member { feet[i], joints[i], section = section, material = o.material, group = "columns" }
    model:member { joints[i], joints[i % 4 + 1], section = section, material = o.material, group = "beams" }
  end
  return { feet = feet, joints = joints, loaded = joints[1], section = section }
end

return space_frame
