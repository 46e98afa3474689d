-- Slabs of floors: panels (model:panel) between the nodes of the members around a floor, inside of them too.
local hinge = require "hinge.core"
local check = require "hinge.library.check"
local stud_rules = require "hinge.model.studs"

local slab = {}

-- The number of elements along a side of a floor's panel.
local function count_along(side)
  local count = 0
  for _, piece in ipairs(side.pieces) do
    local n = piece.member.elements
    if type(n) ~= "number" then
      check.fail("model:floor: member %d has elements = 'auto'; a slab needs a number, which says how fine it is laid "
        .. "out", piece.member.index)
    end
    count = count + n
  end
  return count
end

-- The nodes along a side, from corner to corner.
local function nodes_along(side)
  local list = {}
  for k, piece in ipairs(side.pieces) do
    local member, n = piece.member, piece.member.elements
    local function at(i)
      if i == 0 then return member.a elseif i == n then return member.b end
      return member:node(i)
    end
    for i = k == 1 and 0 or 1, n do list[#list + 1] = at(piece.turned and n - i or i) end
  end
  return list
end

-- Before the first part is laid: a slab is laid as a whole or not at all.
local function refuse_misfit(part)
  if #part.sides ~= 4 then
    local at = part.corners[1]
    check.fail("model:floor: the part of the floor at {%.6g, %.6g} m of its plane has %d sides; a slab needs four: "
      .. "divide it by members, or lay it with model:panel", at[1], at[2], #part.sides)
  end
  local counts = {}
  for i, side in ipairs(part.sides) do counts[i] = count_along(side) end
  if counts[1] ~= counts[3] or counts[2] ~= counts[4] then
    check.fail("model:floor: the sides of a panel have %s elements; a slab needs four sides, and as many elements on a "
      .. "side as on the one across: give the members there `elements` that fit", table.concat(counts, ", "))
  end
end

local function point(node) return { node.x, node.y, node.z } end

local function lay_one(model, corners, options)
  local o = {}
  for key, value in pairs(options) do o[key] = value end
  for i, node in ipairs(corners) do o[i] = node end
  return model:panel(o)
end

-- A node inside, between those along the four sides (Coons' surface).
local function inner_node(model, rows, i, j, n, m)
  local u, v, p = i / n, j / m, {}
  local function weighted(list)
    for c = 1, 3 do
      p[c] = 0
      for _, e in ipairs(list) do p[c] = p[c] + e[1] * point(e[2])[c] end
    end
  end
  weighted { { 1 - v, rows[i][0] }, { v, rows[i][m] }, { 1 - u, rows[0][j] }, { u, rows[n][j] },
    { -(1 - u) * (1 - v), rows[0][0] }, { -u * (1 - v), rows[n][0] }, { -u * v, rows[n][m] },
    { -(1 - u) * v, rows[0][m] } }
  return model:node(p)
end

-- The nodes of a panel with four sides as rows[i][j], i along the first side. own: the slab's node over one of a beam.
local function grid_of(model, panel, own)
  local sides = {}
  for i, side in ipairs(panel.sides) do
    sides[i] = nodes_along(side)
    for k, node in ipairs(own and sides[i] or {}) do sides[i][k] = own(node) end
  end
  local n, m = #sides[1] - 1, #sides[2] - 1
  local rows = {}
  for i = 0, n do rows[i] = {} end
  for i = 0, n do rows[i][0], rows[i][m] = sides[1][i + 1], sides[3][n - i + 1] end
  for j = 0, m do rows[n][j], rows[0][j] = sides[2][j + 1], sides[4][m - j + 1] end
  for i = 1, n - 1 do
    for j = 1, m - 1 do rows[i][j] = inner_node(model, rows, i, j, n, m) end
  end
  return rows, n, m
end

-- One axis in all parts of a floor: x, or y where the floor stands across x.
local function level_axis(parts)
  for _, part in ipairs(parts) do
    for _, side in ipairs(part.sides) do
      local member = side.pieces[1].member
      if math.abs(member.a.x - member.b.x) > 1e-6 * member.length then return { 1, 0, 0 } end
    end
  end
  return { 0, 1, 0 }
end

-- Options that model:panel does not take are refused by one laid elsewhere, in the place of a part of the floor.
local function refuse_wrong(part, options)
  local aside, corners = hinge.model(), {}
  for i, side in ipairs(part.sides) do
    local first = side.pieces[1]
    corners[i] = aside:node(point(first.turned and first.member.b or first.member.a))
  end
  lay_one(aside, corners, options)
end

-- Lays the panels of one part of the floor, their corners counter-clockwise as seen from above.
local function lay(model, panel, options, list, own)
  local rows, n, m = grid_of(model, panel, own)
  local a, b, d = point(rows[0][0]), point(rows[n][0]), point(rows[0][m])
  local up = (b[1] - a[1]) * (d[2] - a[2]) - (b[2] - a[2]) * (d[1] - a[1]) >= 0
  for i = 0, n - 1 do
    for j = 0, m - 1 do
      local corners = { rows[i][j], rows[i + 1][j], rows[i + 1][j + 1], rows[i][j + 1] }
      if not up then corners[2], corners[4] = corners[4], corners[2] end
      list[#list + 1] = lay_one(model, corners, options)
    end
  end
end

-- What is on the panels goes to their nodes.
local function load_nodes(model, list, loads, direction, history)
  local share, order = {}, {}
  for _, panel in ipairs(list) do
    for k, node in ipairs(panel.nodes) do
      if not share[node.index] then
        share[node.index] = 0
        order[#order + 1] = node
      end
      share[node.index] = share[node.index] + panel.shares[k]
    end
  end
  for _, load in ipairs(loads) do
    for _, node in ipairs(order) do
      local q = load.value * share[node.index]
      if q ~= 0 then
        model:load { node = node, force = { q * direction[1], q * direction[2], q * direction[3] }, case = load.case,
          history = history }
      end
    end
  end
end

--- Lays the slab of a floor: its panels. parts: those of floor_strips. o: the options of model:floor, as read.
function slab.lay(model, parts, o)
  local options, list = {}, {}
  for key, value in pairs(o.slab) do
    if type(key) ~= "string" then
      check.fail("model:floor: field 'slab' has [%s]; it takes the fields of model:panel, without nodes", tostring(key))
    end
    options[key] = value
  end
  if not (options.material or options.concrete or options.reinforcement or options.deck) then
    check.fail("model:floor: field 'slab' is made of nothing; give 'thickness' (m) and 'material', 'concrete', "
      .. "'reinforcement' or 'deck'")
  end
  local studs = options.studs and stud_rules.read(options.studs)
  options.studs = nil
  options.mass = o.mass or options.mass
  for _, part in ipairs(parts) do refuse_misfit(part) end
  options.along = options.along or type(o.span) == "table" and o.span or level_axis(parts)
  if parts[1] then refuse_wrong(parts[1], options) end
  local own = studs and stud_rules.nodes(model, parts, studs)
  for _, part in ipairs(parts) do lay(model, part, options, list, own) end
  if studs then stud_rules.join(model, parts, studs, nodes_along) end
  load_nodes(model, list, o.loads, o.direction, o.history)
  return list
end

return slab
