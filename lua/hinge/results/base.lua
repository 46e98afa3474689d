-- hinge.results.base: reactions by support, the loads that act, and whether the two are in balance.
local core = require "hinge.core"
local check = require "hinge.library.check"
local vectors = require "hinge.library.vectors"
local source = require "hinge.results.source"
local Table = require "hinge.results.table"

local base = {}
local Base = Table.class "hinge.results_base"
local components = { "Fx", "Fy", "Fz", "Mx", "My", "Mz" }
local enough = 1e-6 -- of the sum of all forces: the balance of a static run counts as closed below it
local columns = { { key = "name", head = "what", kind = "text" } }
for _, axis in ipairs { "x", "y", "z" } do
  columns[#columns + 1] = { key = axis, head = axis, kind = "length", minor = true }
end
for i, name in ipairs(components) do
  columns[#columns + 1] = { key = name, head = name, kind = i <= 3 and "force" or "moment" }
end

-- Adds a force F and a moment M at a place to a sum: { Fx, Fy, Fz, Mx, My, Mz } about a point.
local function add(sum, about, place, F, M)
  local x, y, z = place[1] - about[1], place[2] - about[2], place[3] - about[3]
  local turning = { y * F[3] - z * F[2], z * F[1] - x * F[3], x * F[2] - y * F[1] }
  for i = 1, 3 do
    sum[i] = sum[i] + F[i]
    sum[3 + i] = sum[3 + i] + turning[i] + M[i]
    sum.size = sum.size + math.abs(F[i])
  end
end

local function new_sum() return { 0, 0, 0, 0, 0, 0, size = 0 } end

local function row_of(name, sum)
  local row = { name = name }
  for i, key in ipairs(components) do row[key] = sum[i] end
  return row
end

-- The rows of supports that carry something, and how many carry nothing.
local function of_use(rows, size)
  local list, idle = {}, 0
  for _, row in ipairs(rows) do
    local largest = 0
    for _, key in ipairs(components) do largest = math.max(largest, math.abs(row[key])) end
    if largest > 1e-9 * size then list[#list + 1] = row else idle = idle + 1 end
  end
  return list, idle
end

-- A row for each node that a support holds, and their sum.
local function reactions(run, model, about, declared)
  local rows, sum = {}, new_sum()
  for _, node in ipairs(model:nodes()) do
    if node.fixed then
      local r = { run:reaction(node) }
      local place = declared and { node.x, node.y, node.z } or { run:position(node) }
      add(sum, about, place, { r[1], r[2], r[3] }, { r[4], r[5], r[6] })
      local row = row_of("node " .. node.index, r)
      row.node, row.x, row.y, row.z = node, node.x, node.y, node.z
      rows[#rows + 1] = row
    end
  end
  local list, idle = of_use(rows, sum.size)
  return list, sum, idle
end

local place_of, between = vectors.of_node, vectors.between

-- A load along a bar from a to b as forces at points: two Gauss points are exact for what is linear. It is per length
-- as declared.
local function spread(load, a, b, length, put)
  local v = load.value
  for _, t in ipairs { 0.5 - math.sqrt(3) / 6, 0.5 + math.sqrt(3) / 6 } do
    local q = {}
    for i = 1, 3 do q[i] = length / 2 * ((1 - t) * v[i] + t * v[3 + i]) end
    put(between(a, b, t), q)
  end
end

-- Puts the nodes of pieces back to where they are declared.
local function set_declared(pieces, model)
  local list, count, index = model:members(), {}, {}
  for _, bar in ipairs(pieces.bars) do count[bar.member] = (count[bar.member] or 0) + 1 end
  for i, node in ipairs(model:nodes()) do
    local own = pieces.nodes[i]
    own.x, own.y, own.z = node.x, node.y, node.z
  end
  for _, bar in ipairs(pieces.bars) do
    local member, k = list[bar.member], (index[bar.member] or 0) + 1
    index[bar.member] = k
    if k < count[bar.member] then
      local place = between(place_of(member.a), place_of(member.b), k / count[bar.member])
      local own = pieces.nodes[bar.b]
      own.x, own.y, own.z = place[1], place[2], place[3]
    end
  end
end

-- The length of the elements of each member, as declared.
local function element_lengths(pieces, model)
  local count, list = {}, model:members()
  for _, bar in ipairs(pieces.bars) do count[bar.member] = (count[bar.member] or 0) + 1 end
  return function(bar) return list[bar.member].length / count[bar.member] end
end

-- The sum of the loads that act now on nodes and members.
local function applied(pieces, about, model)
  local sum, length_of = new_sum(), element_lengths(pieces, model)
  for _, load in ipairs(pieces.loads) do
    local function put(place, value)
      local none = { 0, 0, 0 }
      if load.moment then add(sum, about, place, none, value) else add(sum, about, place, value, none) end
    end
    local bar = load.bar > 0 and pieces.bars[load.bar]
    local a, b = bar and place_of(pieces.nodes[bar.a]), bar and place_of(pieces.nodes[bar.b])
    if not bar then put(place_of(pieces.nodes[load.node]), load.value)
    elseif load.at >= 0 then put(between(a, b, load.at), load.value)
    else
      local from, to = load.from or 0, load.to or 1 -- of a load over a part of the element
      spread(load, between(a, b, from), between(a, b, to), (to - from) * length_of(bar), put)
    end
  end
  return sum
end

local function weight(pieces, about, g)
  local sum, mass = new_sum(), 0
  for _, node in ipairs(pieces.nodes) do
    if not node.gone then
      mass = mass + node.mass
      add(sum, about, place_of(node), { g[1] * node.mass, g[2] * node.mass, g[3] * node.mass }, { 0, 0, 0 })
    end
  end
  return sum, mass
end

-- What the balance says, in words.
local function verdict(run, rest, size, mass, has_gravity)
  local largest = 0
  for i = 1, 3 do largest = math.max(largest, math.abs(rest[i])) end
  if not (largest > enough * size) then
    return ("in balance: the rest is below %.0e of the forces"):format(enough), true
  end
  if run.kind == "dynamic" then
    return "the rest is what inertia, damping, contact and connectors to the ground have", false
  end
  local g = mass > 0 and rest[3] / mass or 0
  if not has_gravity and math.abs(g) > 1e-9 then
    return ("not in balance: the rest is %.4g m/s^2 times the mass; give field 'gravity' if the model has it")
      :format(g), false
  end
  return ("not in balance: the rest is %.2g of the forces; what else holds the model, such as connectors to the "
    .. "ground, is not in this table"):format(largest / size), false
end

--- hinge.results.base(run, { model =, gravity =, about =, units = })
function base.of_run(run, options, ...)
  local where = "hinge.results.base"
  check.no_more(where, ...)
  source.must_be_run(where, run)
  local o = source.options(where, options, {
    gravity = { "numbers", unit = "m/s^2", count = 3, optional = true },
    about = { "numbers", unit = "m", count = 3, default = { 0, 0, 0 } }, units = source.rules.units }, { "model" })
  local model = source.model(where, run, o)
  local declared = not source.is_large(run)
  local rows, sum, idle = reactions(run, model, o.about, declared)
  local pieces = core.pieces(run)
  if declared then set_declared(pieces, model) end
  local loads = applied(pieces, o.about, model)
  local own, mass = weight(pieces, o.about, o.gravity or { 0, 0, 0 })
  local rest = new_sum()
  for i = 1, 6 do rest[i] = sum[i] + loads[i] + own[i] end
  for _, item in ipairs { { "sum of reactions", sum }, { "loads", loads }, { "weight", o.gravity and own },
    { "rest", rest } } do
    if item[2] then
      local row = row_of(item[1], item[2])
      rows[#rows + 1], rows[item[1] == "sum of reactions" and "sum" or item[1]] = row, row
    end
  end
  local text, closed = verdict(run, rest, sum.size + loads.size + own.size, mass, o.gravity ~= nil)
  local about = ("moments of sums are about { %.4g, %.4g, %.4g } m"):format(table.unpack(o.about))
  local notes = { text, about }
  if idle > 0 then notes[3] = ("%s without a reaction"):format(check.count(idle, "supported node")) end
  notes[#notes + 1] = source.failed(run)
  return Table.new(Base, { columns = check.copy(columns), rows = rows, units = o.units, notes = notes,
    balanced = closed, mass = mass })
end

return base
