-- Commands of OpenSees that make beams, columns and bars.
--
-- Axes: z of hinge is x of OpenSees, y is z, which is towards vecxz, and x is y. In a plane frame y of hinge is y of
-- OpenSees, and x is -z.
local arguments = require "hinge.import.opensees.arguments"
local check = require "hinge.library.check"
local frame_module = require "hinge.import.frame"
local materials = require "hinge.import.opensees.materials"
local sections = require "hinge.import.opensees.sections"
local springs = require "hinge.import.opensees.springs"

local number, tag, numbers, positional = arguments.number, arguments.tag, arguments.numbers, arguments.positional
local option, find, give_up, assume = arguments.option, arguments.find, arguments.give_up, arguments.assume

local rigid = 1000 -- shear areas over the area where an element has no shear strain: 1/1000 of what the area would give
local commands, elements = {}, {}

-- Rows of the frame ---------------------------------------------------------------------------------------------------

-- A value as text, with numbers to twelve digits.
local function text_of(value)
  if type(value) == "number" then return ("%.12g"):format(value) end
  if type(value) ~= "table" then return tostring(value) end
  local parts = {}
  for i, item in ipairs(value) do parts[i] = text_of(item) end
  for _, key in ipairs(check.keys(value)) do
    if not math.tointeger(tonumber(key)) then parts[#parts + 1] = key .. "=" .. text_of(value[key]) end
  end
  return "{" .. table.concat(parts, " ") .. "}"
end

-- A row of the frame that may be there already: rows whose numbers agree to twelve digits are one.
local function shared(self, part, row, name)
  local key = text_of(row)
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

-- An outline in the axes of hinge, m.
local function turned(self, outline)
  local L, plane = self.length, self.ndm == 2
  local function at(c) return plane and { -c[2] * L, c[1] * L } or { c[1] * L, c[2] * L } end
  local list = {}
  for i, part in ipairs(outline) do
    if part.diameter then
      list[i] = { diameter = part.diameter * L, centre = at(part.centre), hole = part.hole }
    else
      list[i] = { corners = {} }
      for k, c in ipairs(part.corners) do list[i].corners[k] = at(c) end
    end
  end
  return list
end

local function section_row(self, p)
  local L, F, plane = self.length, self.force, self.ndm == 2
  local area = p.A * L ^ 2
  local Ix, Iy = (p.Iy or p.Iz) * L ^ 4, p.Iz * L ^ 4
  if plane then Ix, Iy = Iy, Ix end
  local row = { area = area, Ix = Ix, Iy = Iy, J = (p.J or 2 * p.Iz) * L ^ 4,
    shear_area_x = p.Avy and p.Avy * L ^ 2 or rigid * area, shear_area_y = p.Avz and p.Avz * L ^ 2 or rigid * area }
  row.N0 = p.N0 and p.N0 * F
  local Mz0, My0 = p.Mz0 and p.Mz0 * F * L, p.My0 and p.My0 * F * L
  if plane then row.Mx0 = Mz0 else row.Mx0, row.My0 = My0, Mz0 end
  if p.outline then
    row.outline, row.interaction = turned(self, p.outline), "exact"
    if plane then row.My0 = My0 end
  elseif p.N0 or Mz0 then
    row.interaction = "paper"
  end
  return row
end

local function material_row(self, p, per_length)
  local row = { E = p.E * self.stress, G = p.G and p.G * self.stress or nil,
    density = per_length / (p.A * self.length ^ 2) }
  if p.N0 or p.Mz0 then
    row.yield_stress = (p.fy or p.N0 and p.N0 / p.A or p.Mz0 / p.Iz) * self.stress
    if p.b and p.b > 0 then row.hardening = { tangent = p.b * row.E, kinematic = p.kinematic } end
  end
  return row
end

-- Releases of -release, or -releasez and -releasey: 1, 2, 3 are the first end, the second, both.
local function releases(self, args)
  local ends, any = { a = {}, b = {} }, false
  local letters = self.ndm == 2 and { ["-release"] = "rx", ["-releasez"] = "rx" }
    or { ["-releasez"] = "ry", ["-releasey"] = "rx" }
  for _, name in ipairs { "-release", "-releasey", "-releasez" } do
    local letter = letters[name]
    local code = letter and arguments.number_of(self, args, name)
    if code and code ~= 0 then
      if code ~= 1 and code ~= 2 and code ~= 3 then self:fail("%s is %g; must be 0, 1, 2 or 3", name, code) end
      if code ~= 2 then table.insert(ends.a, letter) end
      if code ~= 1 then table.insert(ends.b, letter) end
      any = true
    end
  end
  local function joined(list) return #list > 0 and table.concat(list, ",") or nil end
  return any and { a = joined(ends.a), b = joined(ends.b) } or nil
end

local taken = { ["-mass"] = true, ["-cMass"] = true, ["-lMass"] = true, ["-iter"] = true, ["-integration"] = true,
  ["-release"] = true, ["-releasez"] = true, ["-releasey"] = true, ["-sections"] = true, ["-doRayleigh"] = true,
  ["-section"] = true, ["-rho"] = true }

-- Checks that the numbers of an element are those of a member.
local function check_properties(self, p)
  for _, key in ipairs { "E", "A", "Iz", "Iy", "J", "G" } do
    if p[key] and p[key] <= 0 then self:fail("%s is %g; must be above 0", key, p[key]) end
  end
end

-- The direction of the section's y axis of an element between two ends.
local function up_of(self, name, ends, vecxz)
  local a, b = frame_module.ends(ends, self.node)
  if a.x == b.x and a.y == b.y and a.z == b.z then self:fail("element %s has no length", name) end
  local z = frame_module.direction(a, b)
  if self.ndm == 2 then return { -z[3], 0, z[1] } end
  if not frame_module.axes(z, vecxz) then self:fail("vecxz of element %s is along the element", name) end
  return vecxz
end

-- Adds a member with the properties p in the units and axes of the file: E, G, A, Iz, in space Iy and J; Avy, Avz:
-- shear areas, without which it has no shear strain; N0, Mz0, My0, fy, b, outline: where it yields, and how.
local function add_member(self, args, p, transformation)
  local name = tag(self, args[1], "the tag")
  local a, b = self.node[tag(self, args[2], "node i")], self.node[tag(self, args[3], "node j")]
  local m = arguments.number_of(self, args, "-mass", "-rho")
  local per_length = m and m * self.mass / self.length or 0
  check_properties(self, p)
  local of = p.name or "element " .. name
  local member = { name = name, a = a.name, b = b.name, offset = transformation.offset }
  member.up = up_of(self, name, member, transformation.up)
  member.section = shared(self, "sections", section_row(self, p), of)
  member.material = shared(self, "materials", material_row(self, p, per_length), of)
  member.release = releases(self, args)
  self.element[name] = member
  table.insert(self.frame.members, member)
  self.transformation_of[member] = transformation
  arguments.other_options(self, args, taken)
  if per_length > 0 and not option(args, "-cMass") then
    assume(self, "-mass lies along the member, not half at each node as in OpenSees: frequencies are those of more "
      .. "elements a member")
  end
  if not p.Avy then
    assume(self, "the element has no shear strain: its shear areas are %d times the area", rigid)
  end
  return member
end

local function transformation(self, text) return find(self, "geomTransf", tag(self, text, "the transformation")) end

-- Fails unless as many arguments stand before the options of an element as it needs. also: what else may stand there.
local function must_have(self, kind, n, count, also)
  if n ~= count then
    self:fail("element %s has %s before its options; must be %s%d", kind, check.count(n, "argument"), also or "", count)
  end
end

-- Elastic elements ----------------------------------------------------------------------------------------------------

-- tag i j A E Iz transf; in space tag i j A E G J Iy Iz transf; tag i j section transf
function elements.elasticBeamColumn(self, args)
  local n, plane = positional(args), self.ndm == 2
  if n ~= 5 then must_have(self, "elasticBeamColumn", n, plane and 7 or 10, "5 (with a section) or ") end
  local t = transformation(self, args[n])
  local p
  if n == 5 then
    p = sections.properties(self, args[4], false)
    p.N0, p.Mz0, p.My0, p.outline = nil, nil, nil, nil
  else
    local v = numbers(self, args, 4, n - 1, "number")
    p = plane and { A = v[1], E = v[2], Iz = v[3] } or { A = v[1], E = v[2], G = v[3], J = v[4], Iy = v[5], Iz = v[6] }
  end
  add_member(self, args, p, t)
end

-- tag i j E G A Iz Avy transf; in space tag i j E G A J Iy Iz Avy Avz transf
function elements.ElasticTimoshenkoBeam(self, args)
  local n, plane = positional(args), self.ndm == 2
  must_have(self, "ElasticTimoshenkoBeam", n, plane and 9 or 12)
  local t = transformation(self, args[n])
  local v = numbers(self, args, 4, n - 1, "number")
  add_member(self, args, plane and { E = v[1], G = v[2], A = v[3], Iz = v[4], Avy = v[5], Avz = v[5] }
    or { E = v[1], G = v[2], A = v[3], J = v[4], Iy = v[5], Iz = v[6], Avy = v[7], Avz = v[8] }, t)
end

-- Elements with integration points
-- -------------------------------------------------------------------------------------

local prismatic = { Lobatto = true, Legendre = true, Radau = true, NewtonCotes = true, Trapezoidal = true,
  ConcentratedCurvature = true, Simpson = true, UserDefined = false }
local with_ends = { HingeRadau = true, HingeRadauTwo = true, HingeMidpoint = true, HingeEndpoint = true }

-- Properties of an element whose ends have other sections than the rest: it is elastic between its ends.
local function with_hinges(self, first, second, interior)
  local ends, p = sections.properties(self, first, false), interior
  if first ~= second then give_up "different sections at the two ends are not read" end
  if math.abs(ends.E * ends.Iz - p.E * p.Iz) > 0.01 * p.E * p.Iz then
    assume(self, "an element with hinges has the stiffness of its middle along its whole length")
  end
  p.N0, p.Mz0, p.My0, p.outline = ends.N0, ends.Mz0, ends.My0, nil
  p.fy, p.b = ends.fy and ends.N0 and ends.N0 / p.A, ends.b
  return p
end

-- The sections of a rule, all of which must be one.
local function one_section(list)
  for _, name in ipairs(list) do
    if name ~= list[1] then give_up "different sections along an element are not read" end
  end
  return list[1]
end

-- Properties by a rule and what follows its name: section points, or those of hinges.
local function of_rule(self, rule, rest, shear)
  if with_ends[rule or ""] then
    return with_hinges(self, rest[1], rest[3], sections.properties(self, rest[5] or rest[1], shear))
  end
  if not prismatic[rule or ""] then give_up("integration %s is not read", rule or "without a name") end
  return sections.properties(self, rest[1], shear)
end

-- Properties and transformation of an element with integration points:
--   tag i j points section transf | tag i j transf integration | tag i j transf Lobatto section points
--   tag i j points -sections s s ... transf
local function of_points(self, args, shear)
  local words = {}
  for i = 1, positional(args) do
    for word in args[i]:gmatch "%S+" do words[#words + 1] = word end -- "Lobatto 1 5" in quotes
  end
  local listed = arguments.list_of(args, "-sections")
  if listed then
    local t = table.remove(listed)
    return sections.properties(self, one_section(listed), shear), t
  end
  if tonumber(words[5] or "") and words[6] then return sections.properties(self, words[5], shear), words[6] end
  local rule = words[5]
  if rule and tonumber(rule) then
    local known = find(self, "beamIntegration", tag(self, rule, "the integration"))
    return of_rule(self, known.kind, known.args, shear), words[4]
  end
  return of_rule(self, rule, table.move(words, 6, #words, 1, {}), shear), words[4]
end

local function with_points(shear)
  return function(self, args)
    local p, t = of_points(self, args, shear)
    add_member(self, args, p, transformation(self, t))
  end
end

for name in ("forceBeamColumn nonlinearBeamColumn elasticForceBeamColumn mixedBeamColumn forceBeamColumnCBDI "
  .. "forceBeamColumnCSBDI forceBeamColumnWarping"):gmatch "%S+" do elements[name] = with_points(true) end
elements.dispBeamColumn = with_points(false)

-- tag i j sectionI lpI sectionJ lpJ E A Iz transf; in space ... E A Iz Iy G J transf
function elements.beamWithHinges(self, args)
  local n, plane = positional(args), self.ndm == 2
  must_have(self, "beamWithHinges", n, plane and 11 or 14)
  local v = numbers(self, args, 8, n - 1, "number")
  local p = { E = v[1], A = v[2], Iz = v[3], Iy = v[4], G = v[5], J = v[6] }
  add_member(self, args, with_hinges(self, args[4], args[6], p), transformation(self, args[n]))
end

-- Bars ----------------------------------------------------------------------------------------------------------------

-- tag i j A material, or tag i j section: a bar that is pinned at both ends.
local function truss(kind)
  return function(self, args)
    local n = positional(args)
    local name = tag(self, args[1], "the tag")
    local a, b = self.node[tag(self, args[2], "node i")], self.node[tag(self, args[3], "node j")]
    local p
    if n == 4 then
      p = sections.of_bar(self, args[4])
    else
      must_have(self, kind, n, 5)
      local m = materials.of(self, args[5])
      if m.concrete then give_up "a bar of concrete is not read" end
      local A = number(self, args[4], "A")
      p = { A = A, E = m.E, N0 = m.fy and m.fy * A, fy = m.fy, b = m.b, kinematic = m.kinematic }
    end
    local _, length = frame_module.direction(a, b)
    -- a second moment with which the bar yields or reaches a strain of 0.1 long before it buckles
    local I = p.A * (length / self.length) ^ 2 / 100
    local bar = { E = p.E, A = p.A, Iz = I, Iy = I, J = 2 * I, N0 = p.N0, fy = p.fy, b = p.b, kinematic = p.kinematic,
      name = "bar " .. name }
    local up = self.ndm == 3 and (math.abs(b.z - a.z) < 0.9 * length and { 0, 0, 1 } or { 1, 0, 0 }) or nil
    local member = add_member(self, args, bar, { up = up, kind = kind == "corotTruss" and "Corotational" or nil })
    member.release = self.ndm == 2 and { a = "rx", b = "rx" } or { a = "rx,ry,rz", b = "rx,ry" }
    self.bars[member] = true
    assume(self, "a truss element is a member that is pinned at both ends, and does not buckle by itself")
  end
end

for _, kind in ipairs { "truss", "Truss", "trussSection", "TrussSection" } do elements[kind] = truss "truss" end
for _, kind in ipairs { "corotTruss", "CorotTruss", "corotTrussSection", "CorotTrussSection" } do
  elements[kind] = truss "corotTruss"
end

for name, read in pairs(springs.elements) do elements[name] = read end

function commands.element(self, args)
  arguments.dimensions(self)
  local kind = args[1] or ""
  local rest = table.move(args, 2, #args, 1, {})
  local name = tag(self, rest[1], "the tag")
  arguments.is_new(self, "element", name)
  self.element[name] = { unread = self.place }
  if not elements[kind] then
    self.elements_lost = true
    self:not_read_once(("element %s is not read"):format(kind))
    return
  end
  for i, what in ipairs { "node i", "node j" } do find(self, "node", tag(self, rest[i + 1], what)) end
  elements[kind](self, rest)
end

return { commands = commands }
