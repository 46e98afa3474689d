-- Materials of the models: a copy with another density. The paper spreads the mass of floors and aircraft over members.
local materials = {}

function materials.with_density(material, density) return material:with { density = density } end

return materials
