-- Materials of the models: a copy with another density. The paper spreads the mass of floors and aircraft over members.
local hinge = require "hinge"

local materials = {}

function materials.with_density(material, density)
  local yields = material.yield_stress and material.yield_stress < math.huge
  return hinge.material {
    E = material.E, G = material.G, density = density, yield_stress = yields and material.yield_stress or nil,
  }
end

return materials
