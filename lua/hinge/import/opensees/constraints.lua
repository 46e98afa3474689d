-- Commands of OpenSees that tie nodes together: equalDOF, rigidLink, rigidDiaphragm. They are kept as they come, and
-- made rigid links, diaphragms and supports of hinge once all members are known.
local arguments = require "hinge.import.opensees.arguments"
local check = require "hinge.library.check"
local frame_module = require "hinge.import.frame"
local vectors = require "hinge.library.vectors"

local number, tag, find, assume = arguments.number, arguments.tag, arguments.find, arguments.assume
local commands = {}

local function tie(self, kind, from, to, more)
  local row = check.copy(more or {})
  row.kind, row.from, row.to, row.place = kind, from, to, self.place
  table.insert(self.ties, row)
end

-- equalDOF r c 1 2 ...
function commands.equalDOF(self, args)
  local r, c = find(self, "node", tag(self, args[1], "the node")), find(self, "node", tag(self, args[2], "the node"))
  local letters = {}
  for i = 3, #args do
    local letter = r.freedoms[number(self, args[i], "a degree of freedom")]
    if not letter then self:fail("degree of freedom %s is not there", args[i]) end
    letters[letter] = true
  end
  tie(self, "equal", r.name, c.name, { letters = letters })
end

-- rigidLink beam|bar r c
function commands.rigidLink(self, args)
  local kind = (args[1] or ""):gsub("^%-", "")
  if kind ~= "beam" and kind ~= "bar" and kind ~= "rod" then self:fail("rigidLink has beam or bar, not '%s'", kind) end
  local r, c = find(self, "node", tag(self, args[2], "the node")), find(self, "node", tag(self, args[3], "the node"))
  if kind == "beam" then return tie(self, "beam", r.name, c.name) end
  -- a bar of OpenSees keeps the displacements alike, at any distance
  tie(self, "equal", r.name, c.name, { letters = self.ndm == 2 and { x = true, z = true }
    or { x = true, y = true, z = true } })
end

-- rigidDiaphragm normal master nodes
function commands.rigidDiaphragm(self, args)
  if arguments.dimensions(self) == 2 then arguments.give_up "a rigid diaphragm is read in space" end
  local axis = ({ "x", "y", "z" })[number(self, args[1], "the direction across the plane")]
  if not axis then self:fail("the direction across the plane is %s; must be 1, 2 or 3", args[1]) end
  local master, nodes = find(self, "node", tag(self, args[2], "the master node")), {}
  for i = 3, #args do nodes[#nodes + 1] = find(self, "node", tag(self, args[i], "a node")).name end
  tie(self, "diaphragm", master.name, nil, { nodes = nodes, normal = axis })
end

-- Rigid links, diaphragms, supports
-- ---------------------------------------------------------------------------------------

local every = { x = true, y = true, z = true, rx = true, ry = true, rz = true }
local out_of_plane = { y = true, rx = true, rz = true }

local function has_all(set, letters)
  for letter in pairs(letters) do
    if not set[letter] then return false end
  end
  return true
end

local function same_place(a, b)
  return math.abs(a.x - b.x) + math.abs(a.y - b.y) + math.abs(a.z - b.z) < 1e-6
end

-- Fixes what a node follows of a node that is held there.
local function hold(node, letters)
  for letter in pairs(letters) do node.fixed[letter] = true end
end

-- Frees what a node would be held in where it follows another one, which is held there as well. Nil: it is held in
-- more.
local function free_follower(follower, leader, letters)
  for _, letter in ipairs(letters) do
    if follower.fixed[letter] and not leader.fixed[letter] then return nil end
  end
  for _, letter in ipairs(letters) do follower.fixed[letter] = nil end
  return true
end

-- Moves the loads and the mass of a node that no member joins to one that moves with it as a rigid body.
local function move_to(self, from, to)
  self.used[from.name] = true
  local arm = { from.x - to.x, from.y - to.y, from.z - to.z }
  for _, case in ipairs(self.frame.cases) do
    for _, l in ipairs(case.loads) do
      if l.node == from.name then
        local moved = vectors.cross(arm, l.force or { 0, 0, 0 })
        l.node, l.moment = to.name, vectors.plus(l.moment or { 0, 0, 0 }, 1, moved)
      end
    end
  end
  local mass = self.mass_of[from.name]
  if not mass then return end
  self.mass_of[from.name] = nil
  mass.node = to.name
  if arm[1] ~= 0 or arm[2] ~= 0 or arm[3] ~= 0 then mass.offset = arm end
  table.insert(self.more_masses, mass)
end

local function add_link(self, from, to, dofs)
  if not free_follower(to, from, dofs == "all" and frame_module.letters or { "x", "y", "z" }) then
    return self:not_read(("node %s is held where it would follow node %s"):format(to.name, from.name))
  end
  table.insert(self.frame.links, { from = from.name, to = to.name, dofs = dofs })
end

-- Displacements alone in one direction, in a plane frame: a diaphragm across it, which the other nodes of the same
-- leader join.
local function add_to_floor(self, from, to, letter)
  local normal = letter == "x" and "z" or "x"
  if not free_follower(to, from, frame_module.in_plane[normal]) then
    return self:not_read(("node %s is held where it would follow node %s"):format(to.name, from.name))
  end
  for _, row in ipairs(self.frame.diaphragms) do
    if row.master == from.name and row.normal == normal then return table.insert(row.nodes, to.name) end
  end
  table.insert(self.frame.diaphragms, { master = from.name, normal = normal, nodes = { from.name, to.name } })
end

local read = {}

function read.equal(self, row, joined)
  local r, c, letters = self.node[row.from], self.node[row.to], row.letters
  local held, free = r, c
  if not has_all(r.fixed, letters) then held, free = c, r end
  if has_all(held.fixed, letters) then
    self.used[held.name] = true
    return hold(free, letters)
  end
  if not joined[c.name] or not joined[r.name] then
    return self:not_read_once "no member that was read ends at one of its nodes"
  end
  local moves, turns = {}, {}
  for letter in pairs(letters) do
    if #letter == 1 then moves[#moves + 1] = letter else turns[#turns + 1] = letter end
  end
  local plane = self.ndm == 2
  if same_place(r, c) and #moves == (plane and 2 or 3) and (#turns == 0 or #turns == (plane and 1 or 3)) then
    return add_link(self, r, c, #turns == 0 and "xyz" or "all")
  end
  if plane and #moves == 1 and #turns == 0 then return add_to_floor(self, r, c, moves[1]) end
  self:not_read("hinge ties all displacements of nodes at one place, with the rotations or without, and one "
    .. "displacement in a plane frame")
end

function read.beam(self, row, joined)
  local r, c = self.node[row.from], self.node[row.to]
  if has_all(r.fixed, every) then
    self.used[r.name] = true
    return hold(c, r.fixed)
  end
  if not joined[r.name] and not joined[c.name] then
    return self:not_read_once "no member that was read ends at one of its nodes"
  end
  if not joined[c.name] then return move_to(self, c, r) end
  if not joined[r.name] then
    if next(r.fixed) and not (self.ndm == 2 and has_all(out_of_plane, r.fixed)) then
      return self:not_read "its first node is held, and no member ends there"
    end
    return move_to(self, r, c)
  end
  add_link(self, r, c, "all")
end

-- The nodes of a diaphragm that members join.
local function of_members(names, joined)
  local list = {}
  for _, name in ipairs(names) do
    if joined[name] then list[#list + 1] = name end
  end
  return list
end

-- Solves for the part of each node of a floor in a mass: w_i = a + b u_i + c v_i with the same sum and centre.
local function weights(points, u, v)
  local n, su, sv, suu, svv, suv = #points, 0, 0, 0, 0, 0
  for _, p in ipairs(points) do
    local x, y = p[1] - u, p[2] - v
    su, sv, suu, svv, suv = su + x, sv + y, suu + x * x, svv + y * y, suv + x * y
  end
  -- [n su sv; su suu suv; sv suv svv] w = [1; 0; 0]
  local det = n * (suu * svv - suv ^ 2) - su * (su * svv - suv * sv) + sv * (su * suv - suu * sv)
  if math.abs(det) < 1e-9 * n * (suu + svv) ^ 2 then return nil end
  local a, b, c = (suu * svv - suv ^ 2) / det, (suv * sv - su * svv) / det, (su * suv - suu * sv) / det
  local list = {}
  for i, p in ipairs(points) do
    list[i] = a + b * (p[1] - u) + c * (p[2] - v)
    if list[i] < 0 then return nil end
  end
  return list
end

-- Spreads the mass of a master node without a member over the nodes of its floor: the same mass, centre and inertia
-- about the normal.
local function spread_mass(self, master, nodes, normal)
  local mass = self.mass_of[master.name]
  if not mass then return end
  local k = ({ x = 1, y = 2, z = 3 })[normal]
  local p, q = ({ "y", "x", "x" })[k], ({ "z", "z", "y" })[k]
  local points = {}
  for i, name in ipairs(nodes) do points[i] = { self.node[name][p], self.node[name][q] } end
  local parts = weights(points, master[p], master[q])
  if not parts then return self:not_read "the mass of its master node cannot be spread over its other nodes" end
  self.mass_of[master.name] = nil
  local J = mass.inertia and mass.inertia[k] or 0
  for i, part in ipairs(parts) do
    J = J - part * mass.mass * ((points[i][1] - master[p]) ^ 2 + (points[i][2] - master[q]) ^ 2)
  end
  if J < -1e-6 * mass.mass * ((points[1][1] - master[p]) ^ 2 + (points[1][2] - master[q]) ^ 2) then
    assume(self, "the rotary inertia of a floor is that of its mass at its nodes, which is more than in the file")
  end
  for i, part in ipairs(parts) do
    local inertia = J > 0 and { 0, 0, 0 } or nil
    if inertia then inertia[k] = J / #nodes end
    table.insert(self.more_masses, { node = nodes[i], mass = part * mass.mass, inertia = inertia })
  end
  assume(self, "the mass of a master node that no member joins is spread over the nodes of its floor")
end

function read.diaphragm(self, row, joined)
  local nodes, master = of_members(row.nodes, joined), self.node[row.from]
  if joined[master.name] then table.insert(nodes, 1, master.name) end
  if #nodes < 2 then return self:not_read "a diaphragm needs two nodes that members join" end
  local first, letters = self.node[nodes[1]], frame_module.in_plane[row.normal]
  for i = 2, #nodes do
    if not free_follower(self.node[nodes[i]], first, letters) then
      return self:not_read(("node %s is held in the plane of the diaphragm"):format(nodes[i]))
    end
  end
  if first ~= master then
    for _, letter in ipairs(letters) do
      if master.fixed[letter] then
        return self:not_read "its master node is held in its plane, and no member ends there"
      end
    end
    spread_mass(self, master, nodes, row.normal)
    move_to(self, master, first)
  end
  table.insert(self.frame.diaphragms, { master = nodes[1], normal = row.normal, nodes = nodes })
end

--- Makes rows of the frame of what ties nodes. joined: the nodes at which members end.
local function finish(self, joined)
  for _, row in ipairs(self.ties) do
    self.place = row.place
    if not row.used then read[row.kind](self, row, joined) end
  end
end

return { commands = commands, finish = finish, same_place = same_place, hold = hold, every = every,
  move_to = move_to }
