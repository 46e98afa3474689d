-- Which nodes lie on the axis of a member, between its ends.

local near = 1e-3 -- m

--- For nodes { name =, x =, y =, z = }: a function of a member's two nodes that gives the names of those between them,
--- in order.
return function(nodes)
  local sorted = table.move(nodes, 1, #nodes, 1, {})
  table.sort(sorted, function(a, b) return a.x < b.x or a.x == b.x and a.name < b.name end)

  -- The place of the first node whose x is not below a value.
  local function first_at(x)
    local low, high = 1, #sorted + 1
    while low < high do
      local middle = (low + high) // 2
      if sorted[middle].x < x then low = middle + 1 else high = middle end
    end
    return low
  end

  return function(a, b)
    local dx, dy, dz = b.x - a.x, b.y - a.y, b.z - a.z
    local length = math.sqrt(dx * dx + dy * dy + dz * dz)
    local found, last = {}, math.max(a.x, b.x) + near
    local i = first_at(math.min(a.x, b.x) - near)
    while sorted[i] and sorted[i].x <= last do
      local n = sorted[i]
      local x, y, z = n.x - a.x, n.y - a.y, n.z - a.z
      local along = (x * dx + y * dy + z * dz) / length
      local off = math.sqrt(math.max(0, x * x + y * y + z * z - along * along))
      if off < near and along > near and along < length - near then
        found[#found + 1] = { name = n.name, along = along }
      end
      i = i + 1
    end
    table.sort(found, function(p, q) return p.along < q.along end)
    for k, n in ipairs(found) do found[k] = n.name end
    return found
  end
end
