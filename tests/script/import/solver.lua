-- An independent solver of elastic frames, for values that hinge is compared with: dense matrices, small displacements,
-- Euler-Bernoulli and Timoshenko beams. It shares no code with the engine. Units are those of what is given.
--
--   local s = solver.new "plane"                  -- x and y; without the word, space
--   s:node("a", 0, 0); s:node("b", 4, 0); s:fix("a", "x y rz")
--   s:beam { "beam", "a", "b", E = 200e9, A = 0.01, Iz = 1e-4 }
--   s:load("b", { y = -1e3 })
--   local r = s:solve()                           -- r.u.b.y, r.reaction.a.rz
--
-- Local axes of a beam: x from i to j, y = vecxz x x, z = x x y; in the plane vecxz is z of space.
local algebra = dofile(debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "solver_algebra.lua")

local solver, Frame = {}, {}
Frame.__index = Frame

local letters = { "x", "y", "z", "rx", "ry", "rz" }
local index = {}
for i, letter in ipairs(letters) do index[letter] = i end

local function cross(a, b)
  return { a[2] * b[3] - a[3] * b[2], a[3] * b[1] - a[1] * b[3], a[1] * b[2] - a[2] * b[1] }
end
local function unit(a)
  local size = math.sqrt(a[1] ^ 2 + a[2] ^ 2 + a[3] ^ 2)
  return { a[1] / size, a[2] / size, a[3] / size }, size
end

--- A frame without parts; kind: "plane" holds z, rx and ry of all nodes.
function solver.new(kind)
  return setmetatable({ plane = kind == "plane", nodes = {}, count = 0, names = {}, elements = {}, rows = {}, held = {},
    loads = {} }, Frame)
end

-- Parts ---------------------------------------------------------------------------------------------------------------

function Frame:node(name, x, y, z)
  assert(not self.nodes[name], "a node twice")
  self.nodes[name] = { name = name, at = { x, y, z or 0 }, first = 6 * self.count }
  self.count = self.count + 1
  table.insert(self.names, name)
  if self.plane then self:fix(name, "z rx ry") end
end

-- The number of a degree of freedom among those of all nodes.
local function freedom(self, node, letter)
  return assert(self.nodes[node], "no such node").first + assert(index[letter], "no such letter")
end

--- Holds degrees of freedom.
function Frame:fix(node, which)
  for letter in which:gmatch "%w+" do
    local i = freedom(self, node, letter)
    self.held[i] = true
    table.insert(self.rows, { [i] = 1 })
  end
end

--- Degrees of freedom of b that are those of a.
function Frame:equal(a, b, which)
  for letter in which:gmatch "%w+" do
    table.insert(self.rows, { [freedom(self, a, letter)] = -1, [freedom(self, b, letter)] = 1 })
  end
end

--- Degrees of freedom of b that follow a as a rigid body does: "x y z rx ry rz" of a link, "x y rz" of a floor.
function Frame:rigid(a, b, which)
  local p, q = self.nodes[a].at, self.nodes[b].at
  local d = { q[1] - p[1], q[2] - p[2], q[3] - p[3] }
  -- u_b = u_a + rotation x d
  local turn = { { [5] = d[3], [6] = -d[2] }, { [6] = d[1], [4] = -d[3] }, { [4] = d[2], [5] = -d[1] }, {}, {}, {} }
  for letter in which:gmatch "%w+" do
    local row = { [freedom(self, b, letter)] = 1, [freedom(self, a, letter)] = -1 }
    for k, factor in pairs(turn[index[letter]]) do
      if factor ~= 0 then row[self.nodes[a].first + k] = -factor end
    end
    table.insert(self.rows, row)
  end
end

--- Adds a load { x =, ..., rz = } on a node.
function Frame:load(node, load)
  for letter, value in pairs(load) do
    local i = freedom(self, node, letter)
    self.loads[i] = (self.loads[i] or 0) + value
  end
end

-- Beams ---------------------------------------------------------------------------------------------------------------

-- The two planes of bending: the places of their displacements and rotations, and the sign of the rotation: rz turns x
-- to y, ry turns x to -z.
local planes = { { v = 2, r = 6, sign = 1, I = "Iz", shear = "Avy" },
  { v = 3, r = 5, sign = -1, I = "Iy", shear = "Avz" } }

-- Shape functions of a beam with shear, phi = 12 E I / (G A_v L^2): displacement at x = s L by the displacement and
-- rotation of both ends. They solve the equations without a load, so a load on them gives the exact forces of a clamped
-- beam.
local function shapes(s, L, phi)
  local mu = 1 / (1 + phi)
  return { mu * (1 - 3 * s ^ 2 + 2 * s ^ 3 + phi * (1 - s)), L * mu * (s - 2 * s ^ 2 + s ^ 3 + phi / 2 * (s - s ^ 2)),
    mu * (3 * s ^ 2 - 2 * s ^ 3 + phi * s), L * mu * (s ^ 3 - s ^ 2 + phi / 2 * (s ^ 2 - s)) }
end

local function phi_of(p, plane, L)
  local shear = p[plane.shear]
  return shear and 12 * p.E * (p[plane.I] or 0) / (p.G * shear * L ^ 2) or 0
end

-- The part of the shape functions along x, y and z at s: rows of 12.
local function shapes_at(p, L, s)
  local N = {}
  for i = 1, 3 do N[i] = algebra.vector(12) end
  N[1][1], N[1][7] = 1 - s, s
  for _, plane in ipairs(planes) do
    local n, row = shapes(s, L, phi_of(p, plane, L)), N[plane.v]
    row[plane.v], row[plane.r], row[6 + plane.v], row[6 + plane.r] = n[1], plane.sign * n[2], n[3], plane.sign * n[4]
  end
  return N
end

local function stiffness(p, L)
  local k = algebra.zeros(12)
  local function bar(i, value) k[i][i], k[6 + i][6 + i], k[i][6 + i], k[6 + i][i] = value, value, -value, -value end
  bar(1, p.E * p.A / L)
  if p.J and p.G then bar(4, p.G * p.J / L) end
  for _, plane in ipairs(planes) do
    local EI, phi = p.E * (p[plane.I] or 0), phi_of(p, plane, L)
    local c, at = EI / ((1 + phi) * L ^ 3), { plane.v, plane.r, 6 + plane.v, 6 + plane.r }
    local of = { { 12, 6 * L, -12, 6 * L }, { 6 * L, (4 + phi) * L ^ 2, -6 * L, (2 - phi) * L ^ 2 },
      { -12, -6 * L, 12, -6 * L }, { 6 * L, (2 - phi) * L ^ 2, -6 * L, (4 + phi) * L ^ 2 } }
    for i = 1, 4 do
      for j = 1, 4 do
        local sign = (i % 2 == 0 and plane.sign or 1) * (j % 2 == 0 and plane.sign or 1)
        k[at[i]][at[j]] = k[at[i]][at[j]] + sign * c * of[i][j]
      end
    end
  end
  return k
end

local gauss = { { 0.5 - math.sqrt(0.15), 5 / 18 }, { 0.5, 8 / 18 }, { 0.5 + math.sqrt(0.15), 5 / 18 } }

-- Lets one local degree of freedom follow its equation: k and f0 without it.
local function release(element, i)
  local k, f0 = element.k, element.f0
  local row, pivot = algebra.copy(k[i]), k[i][i]
  if pivot == 0 then return end
  for a = 1, 12 do
    f0[a] = f0[a] - row[a] / pivot * (a == i and 0 or f0[i])
    for b = 1, 12 do k[a][b] = k[a][b] - row[a] * row[b] / pivot end
  end
  f0[i] = 0
end

-- Local from global degrees of freedom: the turn of the axes, and the arms of rigid ends (in space).
local function to_local(axes, arm_i, arm_j)
  local T = algebra.zeros(12)
  for part = 0, 3 do
    for i = 1, 3 do
      for j = 1, 3 do T[3 * part + i][3 * part + j] = axes[i][j] end
    end
  end
  for part, d in pairs { [0] = arm_i, [6] = arm_j } do
    -- u = u_node + rotation x d: along an axis e that is rotation . (d x e)
    for i = 1, 3 do
      local lever = cross(d, axes[i])
      for j = 1, 3 do T[part + i][part + 3 + j] = lever[j] end
    end
  end
  return T
end

--- A beam { name, i, j, E =, A =, Iz =, Iy =, G =, J =, Avy =, Avz = (shear areas; without: Euler-Bernoulli), vecxz =,
--- release_i =, release_j = ("ry rz", local axes), arm_i =, arm_j = (from the node to the end of the elastic part) }. A
--- truss has E and A alone.
function Frame:beam(p)
  local a, b, arm_i, arm_j = self.nodes[p[2]], self.nodes[p[3]], p.arm_i or { 0, 0, 0 }, p.arm_j or { 0, 0, 0 }
  local d = {}
  for i = 1, 3 do d[i] = b.at[i] + arm_j[i] - a.at[i] - arm_i[i] end
  local x, L = unit(d)
  local vecxz = p.vecxz or self.plane and { 0, 0, 1 } or (math.abs(x[3]) > 0.9 and { 1, 0, 0 } or { 0, 0, 1 })
  local y = unit(cross(vecxz, x))
  local element = { name = p[1], beam = p, L = L, axes = { x, y, cross(x, y) }, freedoms = {}, f0 = algebra.vector(12) }
  for i = 1, 6 do element.freedoms[i], element.freedoms[6 + i] = a.first + i, b.first + i end
  element.T = to_local(element.axes, arm_i, arm_j)
  element.k = stiffness(p, L)
  table.insert(self.elements, element)
  self.elements[p[1]] = element
end

--- A load on a beam along its axes: { q = { per length } } or { force =, at = (0 to 1) }.
function Frame:beam_load(name, load)
  local element = self.elements[name]
  assert(not element.released, "loads are given before the first solution")
  local function add(s, force)
    for i, row in ipairs(shapes_at(element.beam, element.L, s)) do
      for k = 1, 12 do element.f0[k] = element.f0[k] - row[k] * force[i] end
    end
  end
  if load.force then return add(load.at, load.force) end
  for _, g in ipairs(gauss) do
    local w = g[2] * element.L
    add(g[1], { w * load.q[1], w * load.q[2], w * load.q[3] })
  end
end

-- Springs -------------------------------------------------------------------------------------------------------------

--- A spring { name, i, j or nil (the ground), x =, ..., rz =, axes = (three directions; without them those of space),
--- arm_i =, arm_j = (from the node to the spring) }.
function Frame:spring(p)
  local element = { name = p[1], freedoms = {}, k = algebra.zeros(12), f0 = algebra.vector(12) }
  for i, letter in ipairs(letters) do
    element.freedoms[i] = self.nodes[p[2]].first + i
    element.freedoms[6 + i] = p[3] and self.nodes[p[3]].first + i or false
    local k = p[letter] or 0
    element.k[i][i], element.k[6 + i][6 + i], element.k[i][6 + i], element.k[6 + i][i] = k, k, -k, -k
  end
  element.T = to_local(p.axes or { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } }, p.arm_i or { 0, 0, 0 },
    p.arm_j or { 0, 0, 0 })
  table.insert(self.elements, element)
end

-- Solution ------------------------------------------------------------------------------------------------------------

-- Releases once, when all loads are known.
local function prepare(self)
  for _, element in ipairs(self.elements) do
    if not element.released then
      element.released = true
      local p = element.beam or {}
      for part, which in pairs { [0] = p.release_i or "", [6] = p.release_j or "" } do
        for letter in which:gmatch "%w+" do release(element, part + index[letter]) end
      end
      element.global = algebra.congruent(element.T, element.k)
      element.load = algebra.transposed_times(element.T, element.f0)
    end
  end
  return algebra.eliminate(self.rows, 6 * self.count)
end

--- Displacements by node (u) and forces of supports (reaction).
function Frame:solve()
  local reduced = prepare(self)
  local n = 6 * self.count
  local F, K = algebra.vector(n), algebra.reduced_matrix(reduced)
  for i, value in pairs(self.loads) do F[i] = F[i] + value end
  for _, element in ipairs(self.elements) do
    K:add(element.freedoms, element.global)
    for i, at in ipairs(element.freedoms) do
      if at then F[at] = F[at] - element.load[i] end
    end
  end
  local u = K:solve(F)
  local result, R = { u = {}, reaction = {} }, algebra.vector(n)
  for i = 1, n do R[i] = -F[i] end
  for _, element in ipairs(self.elements) do
    local of = {}
    for i, at in ipairs(element.freedoms) do of[i] = at and u[at] or 0 end
    for i, at in ipairs(element.freedoms) do
      if at then R[at] = R[at] + algebra.dot(element.global[i], of) end
    end
  end
  for _, name in ipairs(self.names) do
    result.u[name], result.reaction[name] = {}, {}
    for i, letter in ipairs(letters) do
      local at = self.nodes[name].first + i
      result.u[name][letter], result.reaction[name][letter] = u[at], self.held[at] and R[at] or nil
    end
  end
  return result
end

return solver
