-- Commands of OpenSees that make sections, transformations and the integration points of elements. Numbers are in the
-- units of the script; y and z are the local axes of OpenSees.
local arguments = require "hinge.import.opensees.arguments"
local fibres = require "hinge.import.opensees.fibres"
local materials = require "hinge.import.opensees.materials"

local tag, numbers, positional = arguments.tag, arguments.numbers, arguments.positional
local option, give_up, assume, dimensions = arguments.option, arguments.give_up, arguments.assume, arguments.dimensions

local commands, makers = {}, {}

function commands.geomTransf(self, args)
  local name = tag(self, args[2], "the tag")
  local up
  if dimensions(self) == 3 then
    if positional(args) < 5 then self:fail "vecxz has three numbers" end
    up = numbers(self, args, 3, 5, "vecxz")
  end
  local known = { kind = args[1], up = up, place = self.place }
  self.geomTransf[name] = known
  arguments.other_options(self, args, { ["-jntOffset"] = true })
  local o = option(args, "-jntOffset")
  if o then
    local v = numbers(self, args, o + 1, o + 2 * self.ndm, "offset")
    local plane = self.ndm == 2
    known.offset = { a = plane and { v[1], 0, v[2] } or { v[1], v[2], v[3] },
      b = plane and { v[3], 0, v[4] } or { v[4], v[5], v[6] } }
    for _, by in pairs(known.offset) do
      for i = 1, 3 do by[i] = by[i] * self.length end
    end
  end
end

-- Sections ------------------------------------------------------------------------------------------------------------

-- section Elastic tag E A Iz <G alphaY>, in space tag E A Iz Iy G J <alphaY alphaZ>
function makers.Elastic(self, args, name)
  local n, plane = positional(args), dimensions(self) == 2
  if n < (plane and 5 or 8) then self:fail("section Elastic %s has too few numbers", name) end
  local v = numbers(self, args, 3, n, "number")
  return plane and { E = v[1], A = v[2], Iz = v[3], G = v[4], ky = v[5] }
    or { E = v[1], A = v[2], Iz = v[3], Iy = v[4], G = v[5], J = v[6], ky = v[7], kz = v[8] }
end

-- section Fiber tag <-GJ GJ> <-torsion material>; patches, layers and fibres follow.
function makers.Fiber(self, args)
  local section = { list = {}, parts = {}, GJ = arguments.number_of(self, args, "-GJ") }
  local t = option(args, "-torsion")
  if t then section.GJ = materials.of(self, args[t + 1]).E end
  self.section_now = section
  return section
end

makers.fiberSec, makers.FiberSection = makers.Fiber, makers.Fiber

local function rectangle(y0, z0, y1, z1) return { { y0, z0 }, { y1, z0 }, { y1, z1 }, { y0, z1 } } end

local function add(section, list, part)
  table.move(list, 1, #list, #section.list + 1, section.list)
  section.parts[#section.parts + 1] = part
end

-- section WFSection2d tag material depth web width flange web_fibres flange_fibres
function makers.WFSection2d(self, args)
  local v = numbers(self, args, 4, 9, "number")
  local m, d, tw, b, tf, n, k = materials.of(self, args[3]), v[1], v[2], v[3], v[4], v[5], v[6]
  local section = { list = {}, parts = {} }
  add(section, fibres.quad(m, n, 1, rectangle(tf - d / 2, -tw / 2, d / 2 - tf, tw / 2)))
  add(section, fibres.quad(m, k, 1, rectangle(d / 2 - tf, -b / 2, d / 2, b / 2)))
  add(section, fibres.quad(m, k, 1, rectangle(-d / 2, -b / 2, tf - d / 2, b / 2)))
  return section
end
makers.WSection2d = makers.WFSection2d

local deformations = { P = { "EA", "N0" }, Mz = { "EIz", "Mz0" }, My = { "EIy", "My0" }, Vy = { "GAy" }, Vz = { "GAz" },
  T = { "GJ" } }

-- The stiffness and the strength of an aggregated section along one of its deformations.
local function aggregate(section, what, m)
  local keys = deformations[what or ""] or give_up("the deformation %s is not read", tostring(what))
  section[keys[1]] = m.E
  if keys[2] then section[keys[2]] = m.fy end
end

-- section Aggregator tag material P|Mz|Vy|My|Vz|T ... <-section tag>
function makers.Aggregator(self, args)
  local s, section = option(args, "-section"), {}
  if s then
    for key, value in pairs(arguments.find(self, "section", tag(self, args[s + 1], "the section"))) do
      section[key] = value
    end
  end
  for i = 3, positional(args), 2 do aggregate(section, args[i + 1], materials.of(self, args[i])) end
  if not s and not (section.EA and section.EIz) then give_up "a section without P and Mz is not read" end
  section.aggregated = not s
  return section
end

-- section Uniaxial tag material P|Mz|...
function makers.Uniaxial(self, args)
  local section = { uniaxial = args[4] }
  aggregate(section, args[4], materials.of(self, args[3]))
  return section
end

function commands.section(self, args)
  local name = tag(self, args[2], "the tag")
  arguments.is_new(self, "section", name)
  self.section_now = nil
  self.section[name] = { unread = self.place }
  local maker = makers[args[1] or ""]
  if not maker then give_up("section %s is not read", tostring(args[1])) end
  local section = maker(self, args, name)
  section.name = "section " .. name
  self.section[name] = section
end

-- Fibres --------------------------------------------------------------------------------------------------------------

-- The section that fibres belong to. What of it is not read leaves the whole of it unread.
local function open_section(self)
  local section = self.section_now
  if not section then self:fail("%s stands outside of a section of fibres", self.command) end
  return section
end

local function with_section(read)
  return function(self, args)
    local section = self.section_now
    local good, result = pcall(read, self, args, section or open_section(self))
    if good then return end
    if section and type(result) == "table" then section.unread = self.place end
    error(result, 0)
  end
end

local patches = {}

-- patch rect material ny nz y0 z0 y1 z1
function patches.rect(v, m) return fibres.quad(m, v[1], v[2], rectangle(v[3], v[4], v[5], v[6])) end
patches.rectangular = patches.rect

-- patch quad material n12 n23 y z of four corners
function patches.quad(v, m)
  return fibres.quad(m, v[1], v[2], { { v[3], v[4] }, { v[5], v[6] }, { v[7], v[8] }, { v[9], v[10] } })
end
patches.quadr, patches.quadrilateral = patches.quad, patches.quad

-- patch circ material around across y z r0 r1 <first last>
function patches.circ(v, m)
  return fibres.ring(m, v[1], v[2], v[3], v[4], v[5], v[6], v[7] or 0, v[8] or 360)
end
patches.circular = patches.circ

local counts = { [patches.rect] = 6, [patches.quad] = 10, [patches.circ] = 6 }

commands.patch = with_section(function(self, args, section)
  local patch = patches[args[1] or ""]
  if not patch then give_up("patch %s is not read", tostring(args[1])) end
  local m, n = materials.of(self, args[2]), positional(args)
  if n < 2 + counts[patch] then self:fail("patch %s has too few numbers", args[1]) end
  local v = numbers(self, args, 3, n, "number")
  for i = 1, 2 do
    if not (v[i] >= 1 and v[i] <= 10000 and v[i] % 1 == 0) then
      self:fail("the number of fibres is %s; must be a whole number from 1 to 10000", args[2 + i])
    end
  end
  add(section, patch(v, m))
end)

commands.layer = with_section(function(self, args, section)
  local kind, m = args[1], materials.of(self, args[2])
  local v = numbers(self, args, 3, positional(args), "number")
  if #v < (kind == "straight" and 6 or 5) then self:fail("layer %s has too few numbers", tostring(kind)) end
  if not (v[1] >= 1 and v[1] <= 10000 and v[1] % 1 == 0) then self:fail("the number of bars is %s", args[3]) end
  if kind == "straight" then return add(section, fibres.line(m, v[1], v[2], v[3], v[4], v[5], v[6])) end
  if kind ~= "circ" and kind ~= "circular" then give_up("layer %s is not read", tostring(kind)) end
  add(section, fibres.arc(m, v[1], v[2], v[3], v[4], v[5], v[6], v[7]))
end)

-- fiber y z area material
commands.fiber = with_section(function(self, args, section)
  local v = numbers(self, args, 1, 3, "number")
  add(section, fibres.line(materials.of(self, args[4]), 1, v[3], v[1], v[2], v[1], v[2]))
end)

-- Properties of sections
-- ------------------------------------------------------------------------------------------------

-- The numbers of a section of resultants: E is that of steel, so that areas and second moments have a usual size.
local function of_resultants(self, s)
  local E = 2e11 / self.stress
  assume(self, "a section of stiffnesses alone is one of the same stiffnesses with E = 200 GPa")
  return { E = E, A = s.EA / E, Iz = s.EIz / E, Iy = (s.EIy or s.EIz) / E, N0 = s.N0, Mz0 = s.Mz0, My0 = s.My0 }
end

-- What all fibres have in common, or nil.
local function common(list, key)
  local value = list[1].material[key]
  for _, f in ipairs(list) do
    if f.material[key] ~= value then return nil end
  end
  return value
end

-- The parts of the outline about the centre, where the section consists of patches of one material alone.
local function outline_of(s, sums)
  local outline = {}
  for _, f in ipairs(s.list) do
    if f.bar then return nil end
  end
  for _, part in ipairs(s.parts) do
    if part.ring then
      local y, z, r0, r1 = table.unpack(part.ring)
      outline[#outline + 1] = { diameter = 2 * r1, centre = { y - sums.y, z - sums.z } }
      if r0 > 0 then outline[#outline + 1] = { diameter = 2 * r0, centre = { y - sums.y, z - sums.z }, hole = true } end
    else
      local corners = {}
      for i, c in ipairs(part.corners) do corners[i] = { c[1] - sums.y, c[2] - sums.z } end
      outline[#outline + 1] = { corners = corners }
    end
  end
  return #outline > 0 and outline or nil
end

-- The section of fibres as an elastic-plastic one.
local function of_fibres(self, s)
  if #s.list == 0 then give_up("%s has no fibre", s.name) end
  local sums = fibres.sums(s.list)
  local E = sums.EA / sums.area
  local p = { E = E, A = sums.area, Iz = sums.EIz / E, Iy = sums.EIy / E }
  if math.abs(sums.off) > 1e-3 * math.sqrt(p.Iz / p.A) then
    assume(self, "the axis of a section of fibres is where the axial force causes no bending")
  end
  if self.ndm == 2 and sums.EIy <= 1e-9 * sums.EIz then -- one fibre across; bending out of the plane does not matter
    p.Iy, sums.My0 = p.Iz, nil
  end
  if sums.concrete then
    assume(self, "a section with concrete is elastic, with the stiffness of its fibres at the start, without cracks")
    return p
  end
  local fy, count = common(s.list, "fy"), #s.parts
  if fy and count > 0 then p.outline = outline_of(s, sums) end
  p.fy, p.b, p.kinematic = fy, common(s.list, "b"), common(s.list, "kinematic")
  p.N0, p.Mz0, p.My0 = sums.N0, sums.Mz0, sums.My0
  if sums.N0 then
    assume(self, "a section of fibres is elastic up to its fully plastic moments and forces, %s",
      p.outline and "which its outline has" or "which its fibres sum up to")
  end
  return p
end

--- Properties of a section that was read, for an element with or without shear strain.
local function properties(self, name, shear)
  local s = arguments.find(self, "section", tag(self, name, "the section"))
  if s.unread then arguments.follows("%s was not read, see line %d", s.name, s.unread.line) end
  if s.uniaxial then give_up("%s has one deformation alone", s.name) end
  local p = s.list and of_fibres(self, s) or s.aggregated and of_resultants(self, s) or {}
  if not s.list and not s.aggregated then
    for key, value in pairs(s) do p[key] = value end
  end
  p.name = s.name
  if s.EIz and not s.aggregated then give_up("%s has bending twice", s.name) end
  p.G = p.G or p.E / 2.6
  if s.GJ then p.J = s.GJ / p.G end
  if shear and s.ky then p.Avy, p.Avz = s.ky * s.A, (s.kz or s.ky) * s.A end
  if shear and s.GAy then p.Avy, p.Avz = s.GAy / p.G, (s.GAz or s.GAy) / p.G end
  return p
end

--- Area, E and strength of a section for a bar, which has an axial force alone.
local function of_bar(self, name)
  local s = arguments.find(self, "section", tag(self, name, "the section"))
  if not s.EA or s.list then
    local p = properties(self, name, false)
    return { A = p.A, E = p.E, N0 = p.N0, fy = p.N0 and p.N0 / p.A, b = p.b, kinematic = p.kinematic }
  end
  local E = 2e11 / self.stress
  return { A = s.EA / E, E = E, N0 = s.N0, fy = s.N0 and s.N0 * E / s.EA }
end

-- beamIntegration kind tag section points | HingeRadau tag sectionI lpI sectionJ lpJ sectionE
function commands.beamIntegration(self, args)
  local name = tag(self, args[2], "the tag")
  local rest = table.move(args, 3, #args, 1, {})
  self.beamIntegration[name] = { kind = args[1], args = rest }
end

return { commands = commands, properties = properties, of_bar = of_bar }
