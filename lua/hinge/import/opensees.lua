-- The commands of OpenSees that describe a frame, as a frame of hinge. tcl.lua and python.lua evaluate the script and
-- call run(name, arguments, place) for each command, with arguments as a list of texts.
--
-- Commands: the wiki of OpenSees and the documentation of OpenSeesPy. Axes: z of hinge is x of OpenSees, y is z, which
-- is towards vecxz, and x is y. A plane frame in x and y becomes one in x and z of hinge: y of OpenSees is z of hinge,
-- and rotations about z of OpenSees are those about -y.
local check = require "hinge.check"
local frame_module = require "hinge.import.frame"
local notes = require "hinge.import.notes"

local Reader = {}
Reader.__index = Reader

local rigid = 1000 -- shear areas over the area where an element has no shear strain: 1/1000 of what the area would give
local commands, elements = {}, {}

function Reader:fail(...) notes.fail(self.where, self.place, ...) end

--- Notes that the command that runs now is not read.
function Reader:not_read(reason) notes.add(self.notes, self.place, self.place.text, reason) end

local function assume(self, reason) notes.once(self.notes.assumed, self.place, self.place.text, reason) end

-- Arguments -----------------------------------------------------------------------------------------------------------

local function number(self, text, what)
  local x = tonumber(text)
  if not x or x ~= x or math.abs(x) == math.huge then
    self:fail("%s is %s; must be a number", what, text == nil and "missing" or "'" .. text .. "'")
  end
  return x
end

-- A tag as text: 5 and 5.0 are the same.
local function tag(self, text, what)
  local x = number(self, text, what)
  if not math.tointeger(x) then self:fail("%s is '%s'; must be a whole number", what, text) end
  return ("%d"):format(math.tointeger(x))
end

local function numbers(self, args, from, to, what)
  local list = {}
  for i = from, to do list[#list + 1] = number(self, args[i], ("%s %d"):format(what, i - from + 1)) end
  return list
end

-- How many arguments stand before the first option, such as -mass.
local function positional(args)
  for i, text in ipairs(args) do
    if text:find "^%-%a" then return i - 1 end
  end
  return #args
end

-- The place of an option among the arguments, or nil.
local function option(args, name)
  for i, text in ipairs(args) do
    if text == name then return i end
  end
end

-- Notes the options of a command that are not among those that are known.
local function other_options(self, args, known)
  for _, text in ipairs(args) do
    if text:find "^%-%a" and not known[text] then self:not_read(("%s is not read"):format(text)) end
  end
end

-- An object of the script by its tag. Nil, with a note, where something was not read before; else an error.
local function find(self, kind, name)
  local found = self[kind][name]
  if found and not found.unread then return found end
  if found then
    self:not_read(("its %s %s was not read, see line %d"):format(kind, name, found.unread.line))
  elseif self.incomplete > 0 then
    self:not_read(("%s %s is not there; a line that was not read may make it"):format(kind, name))
  else
    self:fail("%s %s is not there", kind, name)
  end
end

local function is_new(self, kind, name)
  if self[kind][name] then self:fail("%s %s is there twice", kind, name) end
end

-- Model, nodes, supports, masses --------------------------------------------------------------------------------------

function commands.model(self, args)
  local d, f = option(args, "-ndm"), option(args, "-ndf")
  local ndm = d and number(self, args[d + 1], "-ndm")
  local ndf = f and number(self, args[f + 1], "-ndf") or ndm == 2 and 3 or 6
  if not (ndm == 2 and ndf == 3 or ndm == 3 and ndf == 6) then
    self:fail("-ndm %s -ndf %s is no frame; frames have 2 and 3, or 3 and 6", tostring(args[d and d + 1 or 0]),
      tostring(ndf))
  end
  if self.ndm and self.ndm ~= ndm and #self.frame.nodes > 0 then
    self:fail("the number of dimensions changes from %d to %d", self.ndm, ndm)
  end
  self.ndm, self.ndf = math.tointeger(ndm), math.tointeger(ndf)
  if ndm == 2 then
    assume(self, "a plane frame: y of OpenSees is z of hinge; all nodes are fixed against moving out of the plane")
  end
end

local function dimensions(self)
  if not self.ndm then self:fail("the command stands before: model BasicBuilder -ndm ... -ndf ...") end
  return self.ndm
end

function commands.node(self, args)
  local ndm = dimensions(self)
  local name = tag(self, args[1], "the tag")
  is_new(self, "node", name)
  if positional(args) ~= 1 + ndm then
    self:fail("node %s has %s; must be %d", name, check.count(positional(args) - 1, "coordinate"), ndm)
  end
  local at = numbers(self, args, 2, 1 + ndm, "coordinate")
  for i, x in ipairs(at) do at[i] = x * self.length end
  local node = ndm == 2 and { name = name, x = at[1], y = 0, z = at[2], fixed = { y = true, rx = true, rz = true } }
    or { name = name, x = at[1], y = at[2], z = at[3], fixed = {} }
  self.node[name] = node
  self.places[node] = self.place
  table.insert(self.frame.nodes, node)
  other_options(self, args, { ["-mass"] = true })
  local m = option(args, "-mass")
  if m then
    local all = { name }
    for i = m + 1, m + self.ndf do all[#all + 1] = args[i] end
    commands.mass(self, all)
  end
end

-- What the degrees of freedom of the file are here, and how they turn.
local freedoms = { [2] = { "x", "z", "ry" }, [3] = { "x", "y", "z", "rx", "ry", "rz" } }

local function fix(self, node, args, from)
  for i, letter in ipairs(freedoms[dimensions(self)]) do
    local flag = number(self, args[from + i - 1], ("flag %d"):format(i))
    if flag ~= 0 and flag ~= 1 then self:fail("flag %d is %s; must be 0 or 1", i, args[from + i - 1]) end
    if flag == 1 then node.fixed[letter] = true end
  end
end

function commands.fix(self, args)
  local node = find(self, "node", tag(self, args[1], "the node"))
  if node then fix(self, node, args, 2) end
end

for axis, letter in pairs { X = 1, Y = 2, Z = 3 } do
  commands["fix" .. axis] = function(self, args)
    local key = freedoms[dimensions(self)][letter]
    local at = number(self, args[1], "the coordinate") * self.length
    local t = option(args, "-tol")
    local within = (t and number(self, args[t + 1], "-tol") or 1e-10) * self.length
    for _, node in ipairs(self.frame.nodes) do
      if math.abs(node[key] - at) <= within then fix(self, node, args, 2) end
    end
  end
end

-- The mass of a node from those along its axes: they must be one mass.
local function one_mass(self, along)
  local mass, missing = 0, false
  for _, m in ipairs(along) do
    if m < 0 then self:fail("a mass is %g; must be 0 or above", m) end
    if m > 0 and mass > 0 and math.abs(m - mass) > 1e-9 * mass then return nil end
    mass, missing = math.max(mass, m), missing or m == 0
  end
  return mass, missing and mass > 0
end

function commands.mass(self, args)
  local ndm = dimensions(self)
  local node = find(self, "node", tag(self, args[1], "the node"))
  if not node then return end
  local m = numbers(self, args, 2, 1 + self.ndf, "mass")
  local mass, missing = one_mass(self, table.move(m, 1, ndm, 1, {}))
  if not mass then return self:not_read "the masses along the axes differ; a mass of hinge acts along all axes" end
  local J = ndm == 2 and { 0, m[3], 0 } or { m[4], m[5], m[6] }
  for i, value in ipairs(J) do J[i] = value * self.mass * self.length ^ 2 end
  local turns = J[1] > 0 or J[2] > 0 or J[3] > 0
  if mass == 0 then
    if turns then self:not_read "an inertia without a mass is not read" end
    return
  end
  if missing then assume(self, "a mass that acts along some axes in OpenSees acts along all of them") end
  local row = { node = node.name, mass = mass * self.mass, inertia = turns and J or nil }
  self.places[row] = self.place
  table.insert(self.frame.masses, row)
end

-- Sections and transformations ----------------------------------------------------------------------------------------

function commands.geomTransf(self, args)
  local name = tag(self, args[2], "the tag")
  local up, n = nil, positional(args)
  if dimensions(self) == 3 then
    if n < 5 then self:fail "vecxz has three numbers" end
    up = numbers(self, args, 3, 5, "vecxz")
  end
  self.geomTransf[name] = { up = up }
  other_options(self, args, {})
  assume(self, ("%s is not read: displacement = 'small' of hinge.model is as Linear; 'large', the default, as PDelta "
    .. "and Corotational"):format(args[1]))
end

-- section Elastic tag E A Iz <G alphaY>, in space tag E A Iz Iy G J <alphaY alphaZ>
function commands.section(self, args)
  local name = tag(self, args[2], "the tag")
  is_new(self, "section", name)
  if args[1] ~= "Elastic" then
    self.section[name] = { unread = self.place }
    return self:not_read "sections other than Elastic are not read"
  end
  local n, plane = positional(args), dimensions(self) == 2
  if n < (plane and 5 or 8) then self:fail("section Elastic %s has too few numbers", name) end
  local v = numbers(self, args, 3, n, "number")
  self.section[name] = plane and { E = v[1], A = v[2], Iz = v[3], G = v[4], ky = v[5] }
    or { E = v[1], A = v[2], Iz = v[3], Iy = v[4], G = v[5], J = v[6], ky = v[7], kz = v[8] }
  self.section[name].name = "section " .. name
end

function commands.beamIntegration(self, args)
  local name = tag(self, args[2], "the tag")
  self.beamIntegration[name] = { kind = args[1], section = args[3], count = positional(args) }
end

-- Elements ------------------------------------------------------------------------------------------------------------

-- A row of the frame that may be there already: rows whose numbers agree to twelve digits are one.
local function shared(self, part, row, name)
  local parts = {}
  for _, key in ipairs(check.keys(row)) do parts[#parts + 1] = ("%s=%.12g"):format(key, row[key]) end
  local key = table.concat(parts, " ")
  local known = self.shared[part]
  if not known[key] then
    local free = name
    local i = 1
    while known["name " .. free] do
      i = i + 1
      free = ("%s, %d"):format(name, i)
    end
    row.name, known[key], known["name " .. free] = free, row, true
    table.insert(self.frame[part], row)
  end
  return known[key].name
end

-- Adds a member with the properties p in the units and axes of the file: E, G, A, Iz, in space Iy and J; Avy, Avz:
-- shear areas, without which it has no shear strain.
local function add_member(self, args, p, transformation)
  local name = tag(self, args[1], "the tag")
  local a, b = self.node[tag(self, args[2], "node i")], self.node[tag(self, args[3], "node j")]
  local L, stress = self.length, self.force / self.length ^ 2
  local m = option(args, "-mass")
  local per_length = m and number(self, args[m + 1], "-mass") * self.mass / L or 0
  for _, key in ipairs { "E", "A", "Iz", "Iy", "J", "G" } do
    if p[key] and p[key] <= 0 then self:fail("%s is %g; must be above 0", key, p[key]) end
  end
  if a.x == b.x and a.y == b.y and a.z == b.z then self:fail("element %s has no length", name) end
  local z = frame_module.direction(a, b)
  local up = transformation.up
  if self.ndm == 2 then
    up = { -z[3], 0, z[1] }
  elseif not frame_module.axes(z, up) then
    self:fail("vecxz of element %s is along the element", name)
  end
  local area = p.A * L ^ 2
  local Ix, Iy = (p.Iy or p.Iz) * L ^ 4, p.Iz * L ^ 4
  local of = p.name or "element " .. name
  local row = { area = area, Ix = Ix, Iy = Iy, J = (p.J or 2 * p.Iz) * L ^ 4,
    shear_area_x = p.Avy and p.Avy * L ^ 2 or rigid * area, shear_area_y = p.Avz and p.Avz * L ^ 2 or rigid * area }
  local material = { E = p.E * stress, G = p.G and p.G * stress or nil, density = per_length / area }
  local member = { name = name, a = a.name, b = b.name, section = shared(self, "sections", row, of),
    material = shared(self, "materials", material, of), up = up }
  self.element[name] = member
  table.insert(self.frame.members, member)
  other_options(self, args, { ["-mass"] = true, ["-cMass"] = true, ["-lMass"] = true, ["-iter"] = true,
    ["-integration"] = true })
  if not p.Avy then
    assume(self, ("the element has no shear strain: its shear areas are %d times the area"):format(rigid))
  end
end

-- The properties of a section that was read, for an element with or without shear strain.
local function of_section(self, name, shear)
  local s = find(self, "section", tag(self, name, "the section"))
  if not s then return nil end
  local p = {}
  for key, value in pairs(s) do p[key] = value end
  if shear and s.ky then p.Avy, p.Avz = s.ky * s.A, (s.kz or s.ky) * s.A end
  return p
end

local function transformation(self, text) return find(self, "geomTransf", tag(self, text, "the transformation")) end

-- tag i j A E Iz transf; in space tag i j A E G J Iy Iz transf; tag i j section transf
function elements.elasticBeamColumn(self, args)
  local n, plane = positional(args), self.ndm == 2
  if n ~= 5 and n ~= (plane and 7 or 10) then
    self:fail("element elasticBeamColumn has %s before its options; must be 5 (with a section) or %d",
      check.count(n, "argument"), plane and 7 or 10)
  end
  local t = transformation(self, args[n])
  if not t then return end
  local p
  if n == 5 then
    p = of_section(self, args[4], false)
  else
    local v = numbers(self, args, 4, n - 1, "number")
    p = plane and { A = v[1], E = v[2], Iz = v[3] } or { A = v[1], E = v[2], G = v[3], J = v[4], Iy = v[5], Iz = v[6] }
  end
  if p then return add_member(self, args, p, t) end
end

-- tag i j E G A Iz Avy transf; in space tag i j E G A J Iy Iz Avy Avz transf
function elements.ElasticTimoshenkoBeam(self, args)
  local n, plane = positional(args), self.ndm == 2
  if n ~= (plane and 9 or 12) then
    self:fail("element ElasticTimoshenkoBeam has %s before its options; must be %d", check.count(n, "argument"),
      plane and 9 or 12)
  end
  local t = transformation(self, args[n])
  if not t then return end
  local v = numbers(self, args, 4, n - 1, "number")
  return add_member(self, args, plane and { E = v[1], G = v[2], A = v[3], Iz = v[4], Avy = v[5], Avz = v[5] }
    or { E = v[1], G = v[2], A = v[3], J = v[4], Iy = v[5], Iz = v[6], Avy = v[7], Avz = v[8] }, t)
end

local prismatic = { Lobatto = true, Legendre = true, Radau = true, NewtonCotes = true, Trapezoidal = true }

-- Section and transformation of an element with integration points, or nil with a note.
--   tag i j points section transf | tag i j transf integration | tag i j transf Lobatto section points
local function section_of_points(self, args)
  local words = {}
  for i = 1, positional(args) do
    for word in args[i]:gmatch "%S+" do words[#words + 1] = word end -- "Lobatto 1 5" in quotes
  end
  if tonumber(words[5] or "") and words[6] then return words[5], words[6] end
  local rule, section = words[5], words[6]
  if rule and tonumber(rule) then
    local known = find(self, "beamIntegration", tag(self, rule, "the integration"))
    if not known then return nil end
    rule, section = known.kind, known.section
  end
  if not prismatic[rule or ""] then
    self:not_read(("integration %s is not read"):format(rule or "without a name"))
    return nil
  end
  return section, words[4]
end

local function with_points(shear)
  return function(self, args)
    local section, t = section_of_points(self, args)
    if not section then return end
    t = transformation(self, t)
    local p = t and of_section(self, section, shear)
    if p then return add_member(self, args, p, t) end
  end
end

elements.forceBeamColumn = with_points(true)
elements.nonlinearBeamColumn = elements.forceBeamColumn
elements.dispBeamColumn = with_points(false)

function commands.element(self, args)
  dimensions(self)
  local kind = args[1]
  local rest = table.move(args, 2, #args, 1, {})
  local name = tag(self, rest[1], "the tag")
  is_new(self, "element", name)
  self.element[name] = { unread = self.place }
  if not elements[kind] then return self:not_read(("element %s is not read"):format(kind)) end
  for i, what in ipairs { "node i", "node j" } do
    if not find(self, "node", tag(self, rest[i + 1], what)) then return end
  end
  elements[kind](self, rest)
end

-- Loads ---------------------------------------------------------------------------------------------------------------

local steady = { Linear = true, Constant = true }

-- The factor of a time series that does not change in form; else 1, and it is noted.
local function series_factor(self, args, at)
  local f = option(args, "-factor") or option(args, "-fact")
  local factor = f and number(self, args[f + 1], "-factor") or 1
  if not steady[args[at] or ""] then
    self:not_read(("series %s is not read: loads have the factor 1"):format(tostring(args[at])))
    return 1
  end
  return factor
end

function commands.timeSeries(self, args)
  self.timeSeries[tag(self, args[2], "the tag")] = series_factor(self, args, 1)
end

-- The factor of a pattern: that of its series, which is a tag or a type, times its own.
local function pattern_factor(self, args, series)
  if not tonumber(series) then return series_factor(self, args, 3) end
  local f = option(args, "-fact") or option(args, "-factor")
  local own = f and number(self, args[f + 1], "-fact") or 1
  local factor = self.timeSeries[series]
  if factor then return factor * own end
  if self.incomplete == 0 then self:fail("time series %s is not there", series) end
  self:not_read(("time series %s is not there: loads have the factor 1"):format(series))
  return own
end

-- pattern Plain tag series { loads }: loads that follow belong to it.
function commands.pattern(self, args)
  local name = tag(self, args[2], "the tag")
  if args[1] ~= "Plain" then
    self.case = { unread = self.place }
    return self:not_read(("pattern %s is not read"):format(args[1]))
  end
  local factor = pattern_factor(self, args, args[3] or "Linear")
  self.case = { name = "pattern " .. name, loads = {} }
  self.factor = factor
  table.insert(self.frame.cases, self.case)
end

-- The load case of a load, or nil with a note.
local function case_of(self)
  if not self.case then self:fail("the load stands outside of a pattern") end
  if self.case.unread then
    self:not_read(("its pattern was not read, see line %d"):format(self.case.unread.line))
    return nil
  end
  return self.case
end

local function vector(v, factor)
  if v[1] == 0 and v[2] == 0 and v[3] == 0 then return nil end
  return { v[1] * factor, v[2] * factor, v[3] * factor }
end

function commands.load(self, args)
  local case, ndm = case_of(self), dimensions(self)
  if not case then return end
  local node = find(self, "node", tag(self, args[1], "the node"))
  if not node then return end
  local v = numbers(self, args, 2, 1 + self.ndf, "load")
  if ndm == 2 then v = { v[1], 0, v[2], 0, -v[3], 0 } end
  local F = self.force * self.factor
  local load = { node = node.name, force = vector(v, F), moment = vector({ v[4], v[5], v[6] }, F * self.length) }
  self.places[load] = self.place
  if load.force or load.moment then table.insert(case.loads, load) end
end

-- The elements that eleLoad names: -ele 1 2 3, -range 1 3.
local function loaded_elements(self, args)
  local names, e, r = {}, option(args, "-ele"), option(args, "-range")
  if e then
    local i = e + 1
    while args[i] and not args[i]:find "^%-%a" do
      names[#names + 1] = tag(self, args[i], "an element")
      i = i + 1
    end
  elseif r then
    local from, to = tag(self, args[r + 1], "-range"), tag(self, args[r + 2], "-range")
    for i = tonumber(from), tonumber(to) do names[#names + 1] = ("%d"):format(i) end
  end
  if #names == 0 then self:fail("eleLoad names no element; give -ele or -range") end
  return names
end

-- eleLoad -ele 1 2 -type -beamUniform Wy <Wx>, in space Wy Wz <Wx>
function commands.eleLoad(self, args)
  local case, plane = case_of(self), dimensions(self) == 2
  if not case then return end
  local u = option(args, "-beamUniform")
  if not u then return self:not_read "loads other than -beamUniform are not read" end
  local v = numbers(self, args, u + 1, #args, "load")
  if #v < (plane and 1 or 2) or #v > (plane and 2 or 3) then
    return self:not_read "a load on a part of the element is not read"
  end
  local w = self.force / self.length * self.factor
  local q = plane and vector({ 0, v[1], v[2] or 0 }, w) or vector({ v[1], v[2], v[3] or 0 }, w)
  for _, name in ipairs(loaded_elements(self, args)) do
    local member = find(self, "element", name)
    if member and q then table.insert(case.loads, { member = member.name, q = q, axes = "local" }) end
  end
end

-- Everything ----------------------------------------------------------------------------------------------------------

-- Commands that say nothing about the frame.
local beside = {}
for name in ("algorithm analysis analyze basicForce close constraints database eigen eleForce eleResponse exit "
  .. "getLoadFactor getTime integrator loadConst logFile modalDamping nodeCoord nodeDisp nodeReaction numberer print "
  .. "printA printB printModel puts reactions record recorder region reset save setPrecision setTime start stop system "
  .. "test video wipe wipeAnalysis"):gmatch "%S+" do beside[name] = true end

-- Commands that are not read and make nothing that others refer to.
local alone = {}
for name in ("uniaxialMaterial nDMaterial equalDOF equalDOF_Mixed rigidLink rigidDiaphragm rayleigh damping sp fiber "
  .. "patch layer frictionModel limitCurve hystereticBackbone"):gmatch "%S+" do alone[name] = true end

--- Runs one command of the script. place: { file =, line =, text = }.
function Reader:run(name, args, place)
  self.place = place
  if commands[name] then
    commands[name](self, args)
  elseif beside[name] then
    notes.add(self.notes.skipped, place, place.text)
  else
    self:not_read(("the command %s is not read"):format(name))
    if not alone[name] then self.incomplete = self.incomplete + 1 end
  end
end

--- Notes a line that the evaluator does not follow, and how many lines there are in it. What comes after may lack what
--- it makes.
function Reader:lost(place, reason, lines)
  self.place, self.incomplete = place, self.incomplete + 1
  self:not_read(reason .. (lines > 0 and ("; nor is what stands in it, %s"):format(check.count(lines, "line")) or ""))
end

--- Ends the reading: frame, notes.
function Reader:finish()
  for _, node in ipairs(self.frame.nodes) do
    local letters = {}
    for _, letter in ipairs(freedoms[3]) do
      if node.fixed[letter] then letters[#letters + 1] = letter end
    end
    node.fix = #letters == 6 and "all" or #letters > 0 and table.concat(letters, ",") or nil
    node.fixed = nil
  end
  if #self.frame.nodes == 0 then check.fail("%s: %s has no node that was read%s", self.where, self.frame.source,
    #self.notes > 0 and "; the first line that was not read: " .. self.notes[1].text or "") end
  return frame_module.finish(self.frame, self.notes, self.places)
end

local unit_names = { length = "m, mm, cm, inch, ft", force = "N, kN, MN, lbf, kip", mass = "kg, t, lb" }

-- One unit: its name in hinge.units, or its size in SI.
local function unit(where, what, value)
  if type(value) == "number" and value > 0 and value < math.huge then return value end
  local known = require "hinge.units"
  local size = type(value) == "string" and rawget(known, value)
  if not size then
    check.fail("%s: units.%s is %s; must be one of %s, or its size in SI", where, what,
      value == nil and "missing" or check.show(value), unit_names[what])
  end
  return size
end

local opensees = {}

--- A reader for one script. units: { length =, force =, mass = }, of which mass follows from the others and seconds.
function opensees.new(where, file, units)
  if type(units) ~= "table" then
    check.fail("%s: field 'units' is %s; the file does not say its units: give units = { length = 'm', force = 'kN' }",
      where, units == nil and "missing" or check.show(units))
  end
  for key in pairs(units) do
    if not unit_names[key] then check.unknown(where .. ": units", "field", key, { "force", "length", "mass" }) end
  end
  local length, force = unit(where, "length", units.length), unit(where, "force", units.force)
  local fitting = force / length
  local mass = units.mass and unit(where, "mass", units.mass) or fitting
  local self = setmetatable({ where = where, beside = beside, length = length, force = force, mass = mass,
    frame = frame_module.new(file), notes = notes.new(), places = {}, node = {}, section = {}, geomTransf = {},
    beamIntegration = {}, element = {}, timeSeries = {}, shared = { sections = {}, materials = {} }, incomplete = 0 },
    Reader)
  if math.abs(mass / fitting - 1) > 0.01 then
    notes.add(self.notes.assumed, { file = file }, ("units.mass is %.6g kg"):format(mass),
      ("the mass that fits the units of force and length is %.6g kg"):format(fitting))
  end
  return self
end

return opensees
