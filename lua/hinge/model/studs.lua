-- Studs between the slab of a floor and its beams: the slab has nodes of its own over those of the beams, and a
-- connector at each stands for the studs on its part of the beams' length.
local check = require "hinge.library.check"
local vectors = require "hinge.library.vectors"

local studs = {}
local where = "model:floor: field 'slab.studs'"
local rules = {
  spacing = { "number", unit = "m", above = 0 },
  stiffness = { "number", unit = "N/m", above = 0 },
  capacity = { "number", unit = "N", above = 0, optional = true },
  slip = { "number", unit = "m", above = 0, optional = true },
  height = { "number", unit = "m", default = 0 },
}

--- The options as read; wrong ones are refused.
function studs.read(options)
  if type(options) ~= "table" then
    check.fail("%s is %s; must be a table such as { spacing = 0.2, stiffness = 100e6, capacity = 80e3, slip = 6e-3 }",
      where, check.show(options))
  end
  local o = check.options(where, options, rules)
  if o.slip and not o.capacity then
    check.fail("%s: 'slip' (m) is given without 'capacity' (N): studs that do not yield do not slip", where)
  end
  o.over, o.length = {}, {} -- by the index of a beam's node: the slab's node, the length of the beams that is its part
  return o
end

-- The axes of a part of the floor: x along its first side, z upward.
local function axes_of(part)
  local p = {}
  for i = 1, 4 do
    local first = part.sides[i].pieces[1]
    p[i] = vectors.of_node(first.turned and first.member.b or first.member.a)
  end
  local x = vectors.unit(vectors.minus(p[2], p[1]))
  local z = vectors.unit(vectors.cross(x, vectors.minus(p[4], p[1])))
  if z[3] < 0 then z = vectors.times(-1, z) end
  return { x = x, y = vectors.cross(z, x) }, z
end

--- A function that gives the slab's node over a node of the beams.
function studs.nodes(model, parts, o)
  if not parts[1] then return nil end
  o.axes, o.up = axes_of(parts[1])
  return function(node)
    local own = o.over[node.index]
    if not own then
      own = model:node(vectors.plus(vectors.of_node(node), o.height, o.up))
      o.over[node.index] = own
    end
    return own
  end
end

--- Joins the slab to the nodes of its beams. nodes_along(side): the nodes of one.
function studs.join(model, parts, o, nodes_along)
  local seen, order = {}, {}
  local function add(node, length)
    if not o.length[node.index] then
      o.length[node.index] = 0
      order[#order + 1] = node
    end
    o.length[node.index] = o.length[node.index] + length
  end
  for _, part in ipairs(parts) do
    for _, side in ipairs(part.sides) do
      local list = nodes_along(side)
      for i = 2, #list do
        local a, b = list[i - 1], list[i]
        local key = ("%d %d"):format(math.min(a.index, b.index), math.max(a.index, b.index))
        if not seen[key] then -- a beam between two parts has its studs once
          seen[key] = true
          local half = vectors.length(vectors.minus(vectors.of_node(a), vectors.of_node(b))) / 2
          add(a, half)
          add(b, half)
        end
      end
    end
  end
  for _, node in ipairs(order) do
    local count = o.length[node.index] / o.spacing
    local k = count * o.stiffness
    model:connector { node, o.over[node.index], axes = o.axes, stiffness = { x = k, y = k, z = k },
      yield = o.capacity and { xy = count * o.capacity } or nil, ultimate = o.slip and { xy = o.slip } or nil }
  end
end

return studs
