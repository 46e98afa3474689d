-- Commands of OpenSees that make time series, load patterns, loads, ground motion and damping.
local arguments = require "hinge.import.opensees.arguments"
local check = require "hinge.library.check"
local series = require "hinge.import.opensees.series"
local vectors = require "hinge.library.vectors"

local number, tag, numbers, option = arguments.number, arguments.tag, arguments.numbers, arguments.option
local find, dimensions, give_up = arguments.find, arguments.dimensions, arguments.give_up

local commands = {}

function commands.timeSeries(self, args)
  local name = tag(self, args[2], "the tag")
  self.timeSeries[name] = { unread = self.place }
  local rest = table.move(args, 3, #args, 1, {})
  self.timeSeries[name] = series.read(self, args[1] or "", rest)
end

-- The series of a pattern: by its tag, or as a type with its options, in one text or several.
local function series_of(self, args, at)
  local words = {}
  for i = at, #args do
    for word in args[i]:gmatch "%S+" do words[#words + 1] = word end
  end
  local first = words[1] or "Linear"
  if not tonumber(first) then return series.read(self, first, table.move(words, 2, #words, 1, {})) end
  return find(self, "timeSeries", tag(self, first, "the time series"))
end

-- pattern Plain tag series { loads }: loads that follow belong to it.
local function plain(self, args, name)
  local factor = tonumber(args[3] or "") and arguments.number_of(self, args, "-fact", "-factor") or 1
  local good, s = pcall(series_of, self, args, 3)
  if not good then
    if type(s) ~= "table" then error(s, 0) end
    self:not_read(s.not_read .. ": loads have the factor 1")
    s = { factor = 1 }
  end
  self.case = { name = "pattern " .. name, loads = {}, history = s.history }
  self.factor = s.factor * factor
  self.pattern[name] = self.case
  table.insert(self.frame.cases, self.case)
end

-- pattern UniformExcitation tag direction -accel series <-fact factor>
local function excitation(self, args, name)
  local direction = number(self, args[3], "the direction")
  local axis = (dimensions(self) == 2 and { "x", "z" } or { "x", "y", "z" })[direction]
  if not axis then give_up("the ground moves along %s; only displacements are read", args[3]) end
  local a = option(args, "-accel", "-acceleration")
  if not a then give_up "a ground motion is read by its acceleration, -accel" end
  local fact = arguments.number_of(self, args, "-fact", "-factor") or 1
  local s = series_of(self, args, a + 1)
  if not tonumber(args[a + 1]) then fact = 1 end -- then -factor is that of the series
  if not s.dt then give_up "a ground motion is read as a series of equal steps from 0 on: Path, or Trig" end
  for _, row in ipairs(self.motions) do
    if row.axis == axis then give_up("the ground moves along %s twice", args[3]) end
  end
  if option(args, "-vel0") then self:not_read "-vel0 is not read" end
  table.insert(self.motions, { pattern = name, axis = axis, place = self.place, dt = s.dt, values = s.values,
    scale = s.factor * fact * self.length / self.time ^ 2 })
end

function commands.pattern(self, args)
  local kind, name = args[1], tag(self, args[2], "the tag")
  self.case = { unread = self.place }
  self.pattern[name] = self.case
  if kind == "Plain" then return plain(self, args, name) end
  if kind ~= "UniformExcitation" then give_up("pattern %s is not read", tostring(kind)) end
  excitation(self, args, name)
  self.case = { name = "pattern " .. name, loads = {}, motion = true }
  self.pattern[name] = self.case
end

-- rayleigh alphaM betaK betaK0 betaKcommit
function commands.rayleigh(self, args)
  for i = 1, 4 do
    if args[i] == "\0" then
      give_up "its factors hang on a result of the analysis (eigen); give them by hand: model:damping"
    end
  end
  local v = numbers(self, args, 1, 4, "factor")
  local alpha, beta = v[1] / self.time, (v[2] + v[3] + v[4]) * self.time
  if alpha < 0 or beta < 0 then give_up "a negative damping is not read" end
  self.damping.alpha, self.damping.beta = alpha, beta
end

-- region tag ... <-rayleigh ...>
function commands.region(_, args)
  if option(args, "-rayleigh") then give_up "damping of a region is not read" end
end

-- Loads ---------------------------------------------------------------------------------------------------------------

-- The load case of a load.
local function case_of(self)
  if not self.case or self.case.motion then self:fail("the load stands outside of a pattern") end
  if self.case.unread then arguments.follows("its pattern was not read, see line %d", self.case.unread.line) end
  return self.case
end

local function vector(v, factor)
  if v[1] == 0 and v[2] == 0 and v[3] == 0 then return nil end
  return { v[1] * factor, v[2] * factor, v[3] * factor }
end

function commands.load(self, args)
  local case, ndm = case_of(self), dimensions(self)
  local node = find(self, "node", tag(self, args[1], "the node"))
  local v = numbers(self, args, 2, 1 + #node.freedoms, "load")
  if ndm == 2 then v = { v[1], 0, v[2], 0, -(v[3] or 0), 0 } end
  local F = self.force * self.factor
  local load = { node = node.name, force = vector(v, F),
    moment = vector({ v[4] or 0, v[5] or 0, v[6] or 0 }, F * self.length) }
  self.places[load] = self.place
  if load.force or load.moment then table.insert(case.loads, load) end
end

-- The elements that eleLoad names: -ele 1 2 3, -range 1 3.
local function loaded_elements(self, args)
  local names, e, r = {}, arguments.list_of(args, "-ele"), option(args, "-range")
  if e then
    for i, text in ipairs(e) do names[i] = tag(self, text, "an element") end
  elseif r then
    local from, to = tag(self, args[r + 1], "-range"), tag(self, args[r + 2], "-range")
    for i = tonumber(from), tonumber(to) do
      local name = ("%d"):format(i)
      if self.element[name] or to - from < 1000 then names[#names + 1] = name end
    end
  end
  if #names == 0 then self:fail("eleLoad names no element; give -ele or -range") end
  return names
end

-- Components along the axes of a member, from those of the file: across, <across in space,> along.
local function across_and_along(plane, v, first)
  if plane then return { 0, v[first] or 0, v[first + 1] or 0 } end
  return { v[first] or 0, v[first + 1] or 0, v[first + 2] or 0 }
end

-- -beamUniform Wy <Wx <a b <Wy Wx at b>>>, in space Wy Wz <Wx <a b <Wy Wz Wx at b>>>
local function uniform(self, args, at, plane)
  local v = numbers(self, args, at, #args, "load")
  local n = plane and 2 or 3
  if #v < n - 1 or #v > 2 * n + 2 or #v == n + 1 then
    self:fail("-beamUniform has %d numbers", #v)
  end
  local w = self.force / self.length * self.factor
  local q = vectors.times(w, across_and_along(plane, v, 1))
  if #v <= n then
    if q[1] == 0 and q[2] == 0 and q[3] == 0 then return nil end
    return { q = q, axes = "local" }
  end
  local from, to = v[n + 1], v[n + 2]
  if not (from >= 0 and to <= 1 and from < to) then self:fail("the load is from %g to %g of the element", from, to) end
  local load = { q = q, axes = "local" }
  if #v > n + 2 then load.q = { a = q, b = vectors.times(w, across_and_along(plane, v, n + 3)) } end
  if from > 0 or to < 1 then load.from, load.to = from, to end
  return load
end

-- -beamPoint Py x <Px>, in space Py Pz x <Px>: x is a part of the length
local function point(self, args, at, plane)
  local v = numbers(self, args, at, #args, "load")
  local n = plane and 2 or 3
  if #v < n or #v > n + 1 then self:fail("-beamPoint has %d numbers", #v) end
  if v[n] < 0 or v[n] > 1 then self:fail("the load is at %g of the element; must be 0 to 1", v[n]) end
  local F = self.force * self.factor
  local force = plane and { 0, v[1] * F, (v[3] or 0) * F } or { v[1] * F, v[2] * F, (v[4] or 0) * F }
  return { force = force, at = v[n], axes = "local" }
end

-- eleLoad -ele 1 2 -type -beamUniform ... | -beamPoint ...
function commands.eleLoad(self, args)
  local case, plane = case_of(self), dimensions(self) == 2
  local u, p = option(args, "-beamUniform", "beamUniform"), option(args, "-beamPoint", "beamPoint")
  if not u and not p then give_up "loads other than -beamUniform and -beamPoint are not read" end
  local load = u and uniform(self, args, u + 1, plane) or p and point(self, args, p + 1, plane)
  for _, name in ipairs(loaded_elements(self, args)) do
    local member = find(self, "element", name)
    if not self.transformation_of[member] then give_up("element %s takes no load along it", name) end
    if load then
      local copy = check.copy(load)
      copy.member = member.name
      table.insert(case.loads, copy)
    end
  end
end

return { commands = commands }
