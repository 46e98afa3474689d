-- What the hard scenes are made of: steel, square bars, rows of members, frames.
local hinge = require "hinge"

local parts = {}

--- Steel; what `changed` gives in place of its numbers.
function parts.steel(changed)
  local o = { E = 206e9, nu = 0.3, density = 7850 }
  for k, v in pairs(changed or {}) do o[k] = v end
  return hinge.material(o)
end

function parts.square(side) return hinge.section.solid { width = side, depth = side } end

--- Members in a row between two places, all alike. options: members, side (m), material,
-- group, up. Returns their joints.
function parts.row(model, from, to, options)
  local count, nodes = options.members or 1, {}
  for i = 0, count do
    local at = {}
    for c = 1, 3 do at[c] = from[c] + (to[c] - from[c]) * i / count end
    nodes[i + 1] = model:node(at)
  end
  for i = 1, count do
    model:member { nodes[i], nodes[i + 1], section = parts.square(options.side or 0.05),
      material = options.material or parts.steel(), group = options.group, up = options.up }
  end
  return nodes
end

--- A frame of storeys in the plane x-z, its feet fixed; columns in group "columns" and "storey N", beams in group
-- "beams". Returns the joints, [storey][bay].
function parts.frame(model, options)
  local section, material, joints = parts.square(options.side or 0.1), options.material or parts.steel(), {}
  for s = 0, options.storeys do
    joints[s] = {}
    for b = 0, options.bays do joints[s][b] = model:node { 3 * b, 0, 3 * s } end
    if s == 0 then for b = 0, options.bays do model:fix(joints[0][b]) end end
    for b = 0, s > 0 and options.bays or -1 do
      model:member { joints[s - 1][b], joints[s][b], section = section, material = material, up = { 1, 0, 0 },
        group = { "columns", "storey " .. s } }
      if b > 0 then
        model:member { joints[s][b - 1], joints[s][b], section = section, material = material, group = "beams" }
      end
    end
  end
  return joints
end

return parts
