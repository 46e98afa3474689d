-- What a frame has beside nodes, members and loads: rigid links, diaphragms, springs and joints between nodes, motion
-- of its supports, damping. Their rules, the part of a model that they are (import.build) and the lines of a script
-- (import.write). Rows:
--
-- frame.links       { from =, to =, dofs = "all" or "xyz" }
-- frame.diaphragms  { nodes =, normal =, master = }
-- frame.connectors  { a =, b = (nil: the ground), x =, y = (axes), stiffness = }
-- frame.joints      { a =, b =, x =, y =, Mx =, My =, Mz = } as in hinge.joint
-- frame.motions     { axis =, dt =, acceleration =, scale = }: of all nodes that are held along the axis
-- frame.damping     { alpha =, beta = }
-- frame.model       options of hinge.model that the file asks for
local ties = {}

--- The rule of a value that may be left out.
function ties.optional(kind, more)
  local rule = { kind, optional = true }
  for key, value in pairs(more or {}) do rule[key] = value end
  return rule
end
local optional, text, axis = ties.optional, { "string" }, { "numbers", count = 3 }
local moment = { "table", also = { "free", "rigid" }, optional = true }

ties.rules = {
  links = { from = text, to = text, dofs = { "string", one_of = { "all", "xyz" }, default = "all" } },
  diaphragms = { nodes = { "table" }, normal = { "string", one_of = { "x", "y", "z" }, default = "z" },
    master = optional "string" },
  connectors = { a = text, b = optional "string", x = axis, y = axis, stiffness = { "table" } },
  joints = { a = text, b = text, x = axis, y = axis, Mx = moment, My = moment, Mz = moment },
  motions = { axis = { "string", one_of = { "x", "y", "z" } }, dt = { "number", unit = "s", above = 0 },
    acceleration = { "table" }, scale = { "number", default = 1 } },
}
ties.options = { damping = true, model = true }

--- Checks that the nodes of all rows are there. known(where, what, name, by_name): fails for a name that is not.
function ties.check(where, parts, known)
  local function node(what, i, name)
    known(("%s: frame.%s[%d]"):format(where, what, i), "node", name, parts.node)
  end
  for i, row in ipairs(parts.links) do
    node("links", i, row.from)
    node("links", i, row.to)
  end
  for i, row in ipairs(parts.diaphragms) do
    for _, name in ipairs(row.nodes) do node("diaphragms", i, name) end
    if row.master then node("diaphragms", i, row.master) end
  end
  for _, what in ipairs { "connectors", "joints" } do
    for i, row in ipairs(parts[what]) do
      node(what, i, row.a)
      if row.b then node(what, i, row.b) end
    end
  end
end

-- The nodes that move with the ground along an axis.
local function held_along(full, letter)
  local list = {}
  for _, n in ipairs(full.nodes) do
    local fix = n.fix or ""
    if fix == "all" or fix:gsub("r[xyz]", ""):find(letter, 1, true) then list[#list + 1] = n.name end
  end
  return list
end

-- Build ---------------------------------------------------------------------------------------------------------------

--- Adds all of it to a model. nodes: those of the model by their names.
function ties.build(core, model, full, nodes)
  local function all(names)
    local list = {}
    for i, name in ipairs(names) do list[i] = nodes[name] end
    return list
  end
  for _, row in ipairs(full.links) do
    model:rigid_link { from = nodes[row.from], to = nodes[row.to], dofs = row.dofs }
  end
  for _, row in ipairs(full.diaphragms) do
    model:diaphragm { nodes = all(row.nodes), normal = row.normal, master = row.master and nodes[row.master] }
  end
  for _, row in ipairs(full.connectors) do
    model:connector { nodes[row.a], row.b and nodes[row.b], ground = not row.b or nil, axes = { x = row.x, y = row.y },
      stiffness = row.stiffness }
  end
  for _, row in ipairs(full.joints) do
    model:joint { nodes[row.a], nodes[row.b], axes = { x = row.x, y = row.y },
      joint = core.joint { Mx = row.Mx, My = row.My, Mz = row.Mz } }
  end
  for _, row in ipairs(full.motions) do
    model:move { node = all(held_along(full, row.axis)), [row.axis] = require "hinge.actions.ground" { dt = row.dt,
      acceleration = row.acceleration, scale = row.scale } }
  end
  if full.damping then model:damping(full.damping) end
end

-- Write ---------------------------------------------------------------------------------------------------------------

-- nodes["1"], nodes["2"]
local function node_list(w, names)
  local list = {}
  for i, name in ipairs(names) do list[i] = "nodes[" .. w.quote(name) .. "]" end
  return table.concat(list, ", ")
end

local function write_links(w, full)
  if #full.links == 0 and #full.diaphragms == 0 then return end
  w.line "-- Rigid links and diaphragms"
  for _, row in ipairs(full.links) do
    w.line(("model:rigid_link { from = %s, to = %s, dofs = %s }"):format(node_list(w, { row.from }),
      node_list(w, { row.to }), w.quote(row.dofs)))
  end
  for _, row in ipairs(full.diaphragms) do
    w.line(("model:diaphragm { normal = %s, nodes = { %s }%s }"):format(w.quote(row.normal), node_list(w, row.nodes),
      row.master and ", master = " .. node_list(w, { row.master }) or ""))
  end
  w.line ""
end

local function write_springs(w, full)
  if #full.connectors == 0 and #full.joints == 0 then return end
  w.line "-- Springs between nodes, N/m and N m/rad, and joints: rad, N m"
  for _, row in ipairs(full.connectors) do
    w.line(("model:connector { %s, %s, axes = %s, stiffness = %s }"):format(node_list(w, { row.a }),
      row.b and node_list(w, { row.b }) or "ground = true", w.literal { x = row.x, y = row.y },
      w.literal(row.stiffness)))
  end
  for _, row in ipairs(full.joints) do
    w.line(("model:joint { %s, axes = %s, joint = hinge.joint %s }"):format(node_list(w, { row.a, row.b }),
      w.literal { x = row.x, y = row.y }, w.literal { Mx = row.Mx, My = row.My, Mz = row.Mz }))
  end
  w.line ""
end

local function write_motion(w, full)
  for _, row in ipairs(full.motions) do
    w.line("-- Motion of the ground in dynamics: acceleration times scale, m/s^2")
    w.line(("model:move { node = { %s }, %s = hinge.ground { dt = %s, scale = %s, acceleration = %s } }"):format(
      node_list(w, held_along(full, row.axis)), row.axis, w.literal(row.dt), w.literal(row.scale),
      w.literal(row.acceleration)))
    w.line ""
  end
  if full.damping then w.line(("model:damping %s -- 1/s, s\n"):format(w.literal(full.damping))) end
end

--- Writes all of it. w: { line = function(text), literal =, quote = }.
function ties.write(w, full)
  write_links(w, full)
  write_springs(w, full)
  write_motion(w, full)
end

return ties
