-- Commands of OpenSees that make nodes, supports and masses.
local arguments = require "hinge.import.opensees.arguments"
local check = require "hinge.library.check"

local number, tag, numbers, positional = arguments.number, arguments.tag, arguments.numbers, arguments.positional
local option, find, assume = arguments.option, arguments.find, arguments.assume
local dimensions, freedoms = arguments.dimensions, arguments.freedoms

local commands = {}

function commands.model(self, args)
  local ndm, ndf = arguments.number_of(self, args, "-ndm"), arguments.number_of(self, args, "-ndf")
  if not ndm then self:fail("the number of dimensions is missing: model basic -ndm 2, or -ndm 3") end
  ndf = ndf or ndm == 2 and 3 or 6
  if not (ndm == 2 and (ndf == 2 or ndf == 3) or ndm == 3 and (ndf == 3 or ndf == 6)) then
    self:fail("-ndm %s -ndf %s is no frame; frames have 2 and 3, or 3 and 6, trusses 2 and 2, or 3 and 3",
      args[option(args, "-ndm") + 1], tostring(ndf))
  end
  if self.ndm and self.ndm ~= ndm and #self.frame.nodes > 0 then
    self:fail("the number of dimensions changes from %d to %d", self.ndm, ndm)
  end
  self.ndm, self.ndf = math.tointeger(ndm), math.tointeger(ndf)
  if ndm == 2 then
    assume(self, "a plane frame: y of OpenSees is z of hinge; all nodes are fixed against moving out of the plane")
  end
end

function commands.node(self, args)
  local ndm = dimensions(self)
  local name = tag(self, args[1], "the tag")
  arguments.is_new(self, "node", name)
  if positional(args) < 1 + ndm then -- OpenSees ignores more of them
    self:fail("node %s has %s; must be %d", name, check.count(positional(args) - 1, "coordinate"), ndm)
  end
  local at = numbers(self, args, 2, 1 + ndm, "coordinate")
  for i, x in ipairs(at) do at[i] = x * self.length end
  local node = ndm == 2 and { name = name, x = at[1], y = 0, z = at[2], fixed = { y = true, rx = true, rz = true } }
    or { name = name, x = at[1], y = at[2], z = at[3], fixed = {} }
  local of_truss = self.ndf == ndm
  node.freedoms = of_truss and table.move(freedoms[ndm], 1, ndm, 1, {}) or freedoms[ndm]
  self.node[name] = node
  self.places[node] = self.place
  table.insert(self.frame.nodes, node)
  arguments.other_options(self, args, { ["-mass"] = true })
  local m = option(args, "-mass")
  if m then
    local all = { name }
    for i = m + 1, m + self.ndf do all[#all + 1] = args[i] end
    commands.mass(self, all)
  end
end

-- Supports ------------------------------------------------------------------------------------------------------------

local function fix(self, node, args, from)
  for i, letter in ipairs(node.freedoms) do
    local flag = number(self, args[from + i - 1], ("flag %d"):format(i))
    if flag ~= 0 and flag ~= 1 then self:fail("flag %d is %s; must be 0 or 1", i, args[from + i - 1]) end
    if flag == 1 then node.fixed[letter] = true end
  end
end

function commands.fix(self, args)
  dimensions(self)
  fix(self, find(self, "node", tag(self, args[1], "the node")), args, 2)
end

for axis, letter in pairs { X = 1, Y = 2, Z = 3 } do
  commands["fix" .. axis] = function(self, args)
    local key = freedoms[dimensions(self)][letter]
    local at = number(self, args[1], "the coordinate") * self.length
    local within = (arguments.number_of(self, args, "-tol") or 1e-10) * self.length
    for _, node in ipairs(self.frame.nodes) do
      if math.abs(node[key] - at) <= within then fix(self, node, args, 2) end
    end
  end
end

-- Masses --------------------------------------------------------------------------------------------------------------

local small = 1e-3 -- of the largest mass: one that is there only so that a matrix can be inverted

-- The mass of a node from those along its axes, which must be one mass; then whether it is missing along some of them.
local function one_mass(self, along)
  local mass, missing = 0, false
  for _, m in ipairs(along) do
    if m < 0 then self:fail("a mass is %g; must be 0 or above", m) end
    if m > mass then mass = m end
  end
  for _, m in ipairs(along) do
    if m <= small * mass then missing = true
    elseif math.abs(m - mass) > 1e-9 * mass then
      arguments.give_up "the masses along the axes differ; a mass of hinge acts along all axes"
    end
  end
  return mass, missing and mass > 0
end

-- mass node m m J, in space node m m m Jx Jy Jz: takes the place of the mass that the node has.
function commands.mass(self, args)
  local ndm = dimensions(self)
  local node = find(self, "node", tag(self, args[1], "the node"))
  local count = #node.freedoms
  local m = numbers(self, args, 2, 1 + count, "mass")
  self.mass_of[node.name] = nil
  local mass, missing = one_mass(self, table.move(m, 1, ndm, 1, {}))
  local J = count == ndm and { 0, 0, 0 } or ndm == 2 and { 0, m[3], 0 } or { m[4], m[5], m[6] }
  local turns = J[1] > 0 or J[2] > 0 or J[3] > 0
  for i, value in ipairs(J) do J[i] = value * self.mass * self.length ^ 2 end
  if mass == 0 then
    if turns then self:not_read "an inertia without a mass is not read" end
    return
  end
  if missing then assume(self, "a mass that acts along some axes in OpenSees acts along all of them") end
  local row = { node = node.name, mass = mass * self.mass, inertia = turns and J or nil }
  self.places[row] = self.place
  self.mass_of[node.name] = row
end

return commands
