-- A frame loses its columns one after the other, by the procedures of UFC 4-023-03. See robustness.md.
local hinge = require "hinge"

local lines, storeys, height = { 0, 5, 10, 17 }, 3, 3.5 -- m: where columns stand; height of a storey
local g, w = 9.80665, 28e3 -- m/s^2; N/m on the beams: 1.2 D + 0.5 L
local steel = hinge.material.steel "S355"
local post, beam = hinge.section.named "HEB 240", hinge.section.named "IPE 360"

-- The frame with its loads as mass. options.scale says by how much the load at a place is to be increased.
local function build(options)
  local model, at = hinge.model {}, {}
  local function joint(x, z)
    local node = model:node { x, 0, z }
    model:fix(node, z == 0 and "all" or "y,rx,rz")
    return node
  end
  local function girder(from, to) -- in three parts: the floor holds it at its third points
    local span = to.x - from.x
    local load = w * options.scale((from.x + to.x) / 2, 0, from.z)
    local heavy = steel:with { density = load / g / beam.area }
    for part = 1, 3 do
      local next_one = part == 3 and to or joint(from.x + span / 3, from.z)
      model:member { from, next_one, section = beam, material = heavy, group = "beams", up = { 0, 0, 1 } }
      from = next_one
    end
  end
  for level = 0, storeys do
    at[level] = {}
    for i, x in ipairs(lines) do
      at[level][i] = joint(x, level * height)
      if level > 0 then
        model:member { at[level - 1][i], at[level][i], section = post, material = steel, group = "columns",
          up = { 1, 0, 0 } }
        if i > 1 then girder(at[level][i - 1], at[level][i]) end
      end
    end
  end
  model:gravity { 0, 0, -g }
  return model
end

-- The rotation that is allowed is that of welded connections of beams of this depth.
local _, allowed = hinge.backbone.ufc { kind = "improved WUF", depth = beam.depth }
local loss = hinge.robustness { build = build, limit = { beams = allowed, columns = 0.02 }, m = 2, damping = 0.02,
  dt = 1e-3, quiet = true }
print(loss:table())
loss:picture "robustness.png"
