-- import.e2k: a frame from a text file of ETABS (.e2k, .$et): sections that begin with "$ NAME", lines of a word, names
-- and pairs of a key and a value. The lines are put into the tables of SAP2000, which sap2000/frame.lua reads.
--
-- Names of sections and keys: exported files of versions 9 to 22 and programs that write them, in public repositories.
-- STORY lists the storeys from the top, each with its height, the base with its elevation. LINE "C1" COLUMN "1" "2" 1
-- has its second point on the storey to which LINEASSIGN puts it, and its first point one storey below. The third
-- number of a POINT is how far it lies below its storey.
local check = require "hinge.library.check"
local e2k_areas = require "hinge.import.etabs.areas"
local lines = require "hinge.import.etabs.lines"
local named = require "hinge.sections.named"
local notes = require "hinge.import.notes"
local rows = require "hinge.import.sap2000.row"
local sap_frame = require "hinge.import.sap2000.frame"
local sheets = require "hinge.import.sap2000.sheets"
local units = require "hinge.library.units"

local where = "hinge.import.e2k"

local function fail(line, ...) notes.fail(where, line.place, ...) end

-- The reader ----------------------------------------------------------------------------------------------------------

local Reader = { pairs_after = lines.pairs_after }
Reader.__index = Reader
for name, method in pairs(require "hinge.import.etabs.loads") do Reader[name] = method end

--- The lines of a section that begin with a word; marks the section as read.
function Reader:lines(name, word)
  local found, list = self.sections[name], {}
  if not found then return list end
  found.read = true
  for _, line in ipairs(found.lines) do
    if line.words[1]:upper() == word then
      line.read = true
      list[#list + 1] = line
    end
  end
  return list
end

--- A note on a line; lines with the same reason, or of the same kind, are one note with a count.
function Reader:remark(line, reason, assumed, kind)
  table.insert(self.remarks, { place = line.place, line = line.text, reason = reason, assumed = assumed, kind = kind })
end

--- A row of a table of SAP2000 with these fields, made of a line.
function Reader:row(table_name, section, line, fields)
  local found = self.tables[table_name]
  if not found then
    found = { name = table_name, title = "$ " .. section, place = line.place, rows = {} }
    self.tables[table_name], self.tables[#self.tables + 1] = found, found
  end
  local row = rows.new(where, "$ " .. section, line.place, line.text)
  row.fields = fields
  table.insert(found.rows, row)
end

--- Notes the keys of a line that are neither taken nor of no meaning for the frame.
function Reader:note_keys(line, given, taken, without_meaning)
  local left = {}
  for _, key in ipairs(check.keys(given)) do
    if not (taken[key] or notes.begins_with(key, without_meaning or {})) then left[#left + 1] = key end
  end
  if #left > 0 then self:remark(line, "not read of it: " .. table.concat(left, ", ")) end
end

local forces = { N = "N", KN = "kN", KGF = "kgf", TON = "tonf", TONF = "tonf", LB = "lb", KIP = "kip" }
local lengths = { M = "m", CM = "cm", MM = "mm", IN = "in", FT = "ft" }
local metres = { m = 1, cm = 1e-2, mm = 1e-3, ["in"] = units.inch, ft = units.ft }

function Reader:read_units()
  local line = self:lines("CONTROLS", "UNITS")[1]
  if not line then
    check.fail("%s: %s has no line UNITS in $ CONTROLS, so that its units are not known", where, self.file)
  end
  local force, length = forces[(line.words[2] or ""):upper()], lengths[(line.words[3] or ""):upper()]
  if not (force and length) then
    fail(line, "UNITS are '%s' and '%s'; must be a force (%s) and a length (%s)",
      line.words[2] or "", line.words[3] or "", table.concat(check.keys(forces), ", "),
      table.concat(check.keys(lengths), ", "))
  end
  self.metre = metres[length]
  self:row("PROGRAM CONTROL", "CONTROLS", line, { CurrUnits = force .. ", " .. length })
end

-- self.storey: by name { index =, z = }, index 1 at the top; self.storeys: in this order.
function Reader:read_storeys()
  local section = "STORIES - IN SEQUENCE FROM TOP"
  self.storey, self.storeys = {}, {}
  for _, line in ipairs(self:lines(section, "STORY")) do
    local name, given = line.words[2], lines.pairs_after(line, 3)
    if not name then fail(line, "STORY has no name") end
    if self.storey[name] then fail(line, "storey %s is there twice", name) end
    self:note_keys(line, given, lines.set "HEIGHT ELEV", {
      "MASTERSTORY", "SIMILARTO", "SPLICE", "COLOR", "CUMULATIVE" })
    local storey = { name = name, index = #self.storeys + 1, line = line,
      height = given.HEIGHT and lines.number_of(line, given.HEIGHT, "HEIGHT") or nil,
      z = given.ELEV and lines.number_of(line, given.ELEV, "ELEV") or nil }
    self.storey[name], self.storeys[storey.index] = storey, storey
  end
  local base = self.storeys[#self.storeys]
  if not base or not (base.z or base.height) then
    check.fail("%s: %s has no storeys in $ %s", where, self.file, section)
  end
  if not base.z then fail(base.line, "the last STORY is the base; it needs ELEV") end
  for i = #self.storeys - 1, 1, -1 do
    local storey = self.storeys[i]
    if not storey.height then fail(storey.line, "storey %s has no HEIGHT", storey.name) end
    storey.z = self.storeys[i + 1].z + storey.height
  end
end

function Reader:read_points()
  self.point = {}
  for _, line in ipairs(self:lines("POINT COORDINATES", "POINT")) do
    local name = line.words[2]
    if not name then fail(line, "POINT has no name") end
    if self.point[name] then fail(line, "point %s is there twice", name) end
    local below = line.words[5] and lines.number_of(line, line.words[5], "the third number of the point") or 0
    self.point[name] = { x = lines.number_of(line, line.words[3], "x"), y = lines.number_of(line, line.words[4], "y"),
      below = below, line = line }
    if below ~= 0 then self:remark(line, "the third number is how far the point lies below its storey", true) end
  end
end

function Reader:storey_of(line, name)
  return self.storey[name or ""] or fail(line, "storey '%s' is not in $ STORIES", tostring(name))
end

--- The joint of a point on a storey, which is made when it is first used.
function Reader:joint(line, point, storey)
  local p = self.point[point]
  if not p then fail(line, "point '%s' is not in $ POINT COORDINATES", tostring(point)) end
  local name = point .. "@" .. storey.name
  if not self.joints[name] then
    self.joints[name] = true
    self:row("JOINT COORDINATES", "POINT COORDINATES", p.line, { Joint = name, XorR = tostring(p.x), Y = tostring(p.y),
      Z = tostring(storey.z - p.below) })
  end
  return name
end

-- Materials and sections ----------------------------------------------------------------------------------------------

-- The pairs of all lines of a name, and the first of these lines: { name =, line =, given = }, in their order.
function Reader:gathered(section, word)
  local list, by_name = {}, {}
  for _, line in ipairs(self:lines(section, word)) do
    local name = line.words[2]
    if not name then fail(line, "%s has no name", word) end
    local found = by_name[name]
    if not found then
      found = { name = name, line = line, given = {} }
      by_name[name], list[#list + 1] = found, found
    end
    for key, value in pairs(lines.pairs_after(line, 3)) do found.given[key] = value end
  end
  return list
end

function Reader:read_materials()
  local section = "MATERIAL PROPERTIES"
  for _, m in ipairs(self:gathered(section, "MATERIAL")) do
    local given = m.given
    lines.must_be_numbers(m.line, given, "E U G12 M W WEIGHTPERVOLUME FY")
    local weight = given.WEIGHTPERVOLUME or given.W
    local mass = given.M
      or weight and tostring(lines.number_of(m.line, weight, "the weight") * self.metre / units.gravity) or nil
    self:row("MATERIAL PROPERTIES 02 - BASIC MECHANICAL PROPERTIES", section, m.line, { Material = m.name,
      E1 = given.E, U12 = given.U, G12 = given.G, UnitMass = mass, UnitWeight = weight,
      Kind = given.DESIGNTYPE or given.TYPE, Strength = tonumber(given.FC) and given.FC })
    if given.FY then
      self:row("MATERIAL PROPERTIES 03A - STEEL DATA", section, m.line, { Material = m.name, Fy = given.FY })
    end
  end
end

local shapes = { TUBE = "Box/Tube", RECTANGULAR = "Rectangular", ["RECTANGULAR BAR"] = "Rectangular",
  CIRCLE = "Circle", ["CIRCULAR BAR"] = "Circle", PIPE = "Pipe", ["I/WIDE FLANGE"] = "I/Wide Flange",
  ["BOX/TUBE"] = "Box/Tube", GENERAL = "General", PLATE = "Rectangular",
  CHANNEL = "Channel", TEE = "Tee", ["DOUBLE ANGLE"] = "Double Angle" }
local modifiers = { AREAMODIFIER = "AMod", AMOD = "AMod", AS2MODIFIER = "A2Mod", A2MOD = "A2Mod",
  AS3MODIFIER = "A3Mod", A3MOD = "A3Mod", JMODIFIER = "JMod", JMOD = "JMod", I22MODIFIER = "I2Mod", I2MOD = "I2Mod",
  I33MODIFIER = "I3Mod", I3MOD = "I3Mod", MMODIFIER = "MMod", MMOD = "MMod", WMODIFIER = "WMod", WMOD = "WMod" }
local taken_of_sections = lines.set "MATERIAL SHAPE D B TF TW T DIS AREA AS2 AS3 I33 I22 TORSION Z33 Z22"
for key in pairs(modifiers) do taken_of_sections[key] = true end

function Reader:read_sections()
  local section = "FRAME SECTIONS"
  if not self.sections[section] and self.sections["FRAME PROPERTIES"] then section = "FRAME PROPERTIES" end
  for _, s in ipairs(self:gathered(section, "FRAMESECTION")) do
    local given = s.given
    lines.must_be_numbers(s.line, given, "D B TF TW T AREA AS2 AS3 I33 I22 TORSION Z33 Z22")
    for key in pairs(modifiers) do lines.must_be_numbers(s.line, given, key) end
    local shape = given.SHAPE or "General"
    local plain = shape:gsub("^Steel ", ""):gsub("^Concrete ", "")
    local known = shapes[plain:upper()]
    local row = { SectionName = s.name, Material = given.MATERIAL, Shape = known or shape, t3 = given.D, t2 = given.B,
      dis = given.DIS, tf = given.TF, tw = given.TW or given.T, Area = given.AREA, AS2 = given.AS2, AS3 = given.AS3,
      I33 = given.I33, I22 = given.I22, TorsConst = given.TORSION, Z33 = given.Z33, Z22 = given.Z22 }
    if known == "Pipe" then row.tw = given.TW or given.T or given.TF end
    if not known and not given.AREA then
      row.Catalogue = shape:find "^Steel " and s.name or shape
      if pcall(named.properties, shape) then row.Named = shape end
    end
    for key, field in pairs(modifiers) do row[field] = row[field] or given[key] end
    self:note_keys(s.line, given, taken_of_sections, { "COLOR", "NOTES", "AUTORIGIDZONE", "FILE", "S33", "S22", "R33",
      "R22", "NOTIONAL", "GUID", "TIMEDEP" })
    self:row("FRAME SECTION PROPERTIES 01 - GENERAL", section, s.line, row)
  end
end

-- Lines of the frame --------------------------------------------------------------------------------------------------

function Reader:read_connectivities()
  self.line = {}
  for _, line in ipairs(self:lines("LINE CONNECTIVITIES", "LINE")) do
    local name, kind, a, b = line.words[2], line.words[3], line.words[4], line.words[5]
    if not b then fail(line, "LINE must have a name, COLUMN, BEAM or BRACE, and two points") end
    if self.line[name] then fail(line, "line %s is there twice", name) end
    local down = line.words[6] and lines.number_of(line, line.words[6], "the storeys between its ends") or 0
    self.line[name] = { kind = kind:upper(), a = a, b = b, down = down, line = line }
  end
end

local releases = lines.set "P V2 V3 T M2 M3"
local taken_of_lines = lines.set("SECTION ANG RELEASE LENGTHOFFI LENGTHOFFJ RIGIDZONE SELFWEIGHTOPTION CARDINALPT "
  .. "TRANSSTIFF TRANSFORMSTIFF OFFSETXI OFFSETYI OFFSETZI OFFSETXJ OFFSETYJ OFFSETZJ MIRROR2 MIRROR3")
local of_no_meaning = { "MINNUMSTA", "MAXSTASPC", "AUTOMESH", "MESH", "PIER", "SPANDREL", "DESIGN", "GUID" }

-- The released forces of a line: "M2I M3J" as the fields of SAP2000.
local function released(line, text)
  if text:upper() == "PINNED" then text = "M2I M3I M2J M3J" end
  local fields = {}
  for name in text:gmatch "%S+" do
    local force, at = name:upper():match "^(%w-)([IJ])$"
    if not releases[force or ""] then
      fail(line, "RELEASE '%s' is not known; must be PINNED, or P, V2, V3, T, M2 or M3 with I or J", name)
    end
    fields[force .. at] = "Yes"
  end
  return fields
end

-- Insertion point, joint offsets in space and rigid ends of a line. Without lengths these are automatic.
function Reader:read_ends(line, frame, given)
  lines.must_be_numbers(line, given, "LENGTHOFFI LENGTHOFFJ RIGIDZONE CARDINALPT OFFSETXI OFFSETYI OFFSETZI OFFSETXJ "
    .. "OFFSETYJ OFFSETZJ")
  local point = { Frame = frame, CardinalPt = given.CARDINALPT, Mirror2 = given.MIRROR2, Mirror3 = given.MIRROR3,
    Transform = given.TRANSFORMSTIFF or given.TRANSSTIFF or "No" }
  local any = given.CARDINALPT ~= nil
  for _, key in ipairs { "XI", "YI", "ZI", "XJ", "YJ", "ZJ" } do
    point["JtOff" .. key] = given["OFFSET" .. key]
    any = any or given["OFFSET" .. key] ~= nil
  end
  if any then self:row("FRAME INSERTION POINT ASSIGNMENTS", "LINE ASSIGNS", line, point) end
  local factor = tonumber(given.RIGIDZONE or 0)
  if factor == 0 and (tonumber(given.LENGTHOFFI or 0) ~= 0 or tonumber(given.LENGTHOFFJ or 0) ~= 0) then
    self:remark(line, "end offsets with a rigid zone of 0 do not stiffen the member", true)
  elseif factor ~= 0 then
    self:row("FRAME OFFSET ALONG LENGTH ASSIGNMENTS", "LINE ASSIGNS", line, { Frame = frame,
      Type = (given.LENGTHOFFI or given.LENGTHOFFJ) and "User" or "Automatic", LengthI = given.LENGTHOFFI,
      LengthJ = given.LENGTHOFFJ, RigidFactor = given.RIGIDZONE,
      SelfWeight = (given.SELFWEIGHTOPTION or ""):upper():find "^CLEAR" and "Clear" or "Full" })
  end
end

function Reader:read_line(line, name, storey, given)
  local l = self.line[name]
  if not l then fail(line, "line '%s' is not in $ LINE CONNECTIVITIES", name) end
  local below = self.storeys[storey.index + l.down]
  if not below or l.down ~= math.floor(l.down) or l.down < 0 then
    fail(line, "line %s on storey %s begins %s below it; there %s %d", name, storey.name,
      check.count(l.down, "storey"), #self.storeys - storey.index == 1 and "is" or "are", #self.storeys - storey.index)
  end
  local section = "LINE ASSIGNS"
  local frame = name .. "@" .. storey.name
  if self.frames[frame] then fail(line, "line %s is assigned twice to storey %s", name, storey.name) end
  self.frames[frame] = true
  self:row("CONNECTIVITY - FRAME", section, line, { Frame = frame, JointI = self:joint(line, l.a, below),
    JointJ = self:joint(line, l.b, storey) })
  self:row("FRAME SECTION ASSIGNMENTS", section, line, { Frame = frame, AnalSect = given.SECTION or "None" })
  lines.must_be_numbers(line, given, "ANG")
  if given.ANG then self:row("FRAME LOCAL AXES 1 - TYPICAL", section, line, { Frame = frame, Angle = given.ANG }) end
  if given.RELEASE then
    local fields = released(line, given.RELEASE)
    fields.Frame = frame
    self:row("FRAME RELEASE ASSIGNMENTS 1 - GENERAL", section, line, fields)
  end
  self:row("GROUPS 2 - ASSIGNMENTS", section, line, { GroupName = l.kind:lower() .. "s", ObjectType = "Frame",
    ObjectLabel = frame })
  self:note_keys(line, given, taken_of_lines, of_no_meaning)
  self:read_ends(line, frame, given)
end

function Reader:read_lines()
  local list, by_name = {}, {}
  for _, line in ipairs(self:lines("LINE ASSIGNS", "LINEASSIGN")) do
    local name, storey = line.words[2], self:storey_of(line, line.words[3])
    local key = tostring(name) .. "@" .. storey.name
    local given = lines.pairs_after(line, 4)
    local before = by_name[key]
    if before and not given.SECTION then -- more of the same line
      for field, value in pairs(given) do before.given[field] = value end
    else
      by_name[key] = { line = line, name = name, storey = storey, given = given }
      list[#list + 1] = by_name[key]
    end
  end
  for _, l in ipairs(list) do self:read_line(l.line, l.name, l.storey, l.given) end
end

-- A point in a diaphragm, of which each storey has its own. One without a line at it is a corner of floors alone.
function Reader:read_diaphragm(line, point, storey, diaphragm)
  if not diaphragm or diaphragm:upper() == "DISCONNECTED" then return end
  if not self.joints[point .. "@" .. storey.name] then return end
  local kind = self.diaphragm_kinds[diaphragm]
  if kind and kind ~= "RIGID" then
    return self:remark(line, ("diaphragm %s is %s: its floors are not read, and nothing ties its points"):format(
      diaphragm, kind:lower()), true, "soft diaphragm")
  end
  local name, joint = diaphragm .. " on " .. storey.name, point .. "@" .. storey.name
  if not self.diaphragms[name] then
    self.diaphragms[name] = {}
    self:row("CONSTRAINT DEFINITIONS - DIAPHRAGM", "DIAPHRAGM NAMES", line, { Name = name, Axis = "Z" })
  end
  if self.diaphragms[name][joint] then return end
  self.diaphragms[name][joint] = true
  self:row("JOINT CONSTRAINT ASSIGNMENTS", "POINT ASSIGNS", line, { Joint = joint, Constraint = name })
end

-- Springs of a point to the ground.
function Reader:read_spring(line, storey, name)
  local given = self.springs[name]
  if not given then return self:remark(line, ("spring %s is not read"):format(name)) end
  lines.must_be_numbers(line, given, "UX UY UZ RX RY RZ")
  self:row("JOINT SPRING ASSIGNMENTS 1 - UNCOUPLED", "POINT ASSIGNS", line, { Joint = self:joint(line, line.words[2],
    storey), U1 = given.UX, U2 = given.UY, U3 = given.UZ, R1 = given.RX, R2 = given.RY, R3 = given.RZ })
end

-- What points are assigned to: kinds of diaphragms, and springs.
function Reader:read_point_properties()
  self.diaphragm_kinds, self.diaphragms, self.springs = {}, {}, {}
  for _, line in ipairs(self:lines("DIAPHRAGM NAMES", "DIAPHRAGM")) do
    self.diaphragm_kinds[line.words[2]] = (lines.pairs_after(line, 3).TYPE or "RIGID"):upper()
  end
  for _, line in ipairs(self:lines("POINT SPRING PROPERTIES", "POINTSPRING")) do
    local given = lines.pairs_after(line, 3)
    local option = (given.STIFFNESSOPTION or "USERDEFINED"):upper()
    if option == "USERDEFINED" then self.springs[line.words[2]] = given end
  end
end

function Reader:read_point_assigns()
  for _, line in ipairs(self:lines("POINT ASSIGNS", "POINTASSIGN")) do
    local storey, given = self:storey_of(line, line.words[3]), lines.pairs_after(line, 4)
    if given.RESTRAINT then
      local fields = { Joint = self:joint(line, line.words[2], storey) }
      for name in given.RESTRAINT:gmatch "%S+" do
        local kind, axis = name:upper():match "^([UR])([XYZ])$"
        if not kind then fail(line, "RESTRAINT '%s' is not known; must be UX, UY, UZ, RX, RY or RZ", name) end
        fields[kind .. (("XYZ"):find(axis, 1, true))] = "Yes"
      end
      self:row("JOINT RESTRAINT ASSIGNMENTS", "POINT ASSIGNS", line, fields)
    end
    self:read_diaphragm(line, line.words[2], storey, given.DIAPH or given.DIAPHRAGM)
    if given.SPRINGPROP then self:read_spring(line, storey, given.SPRINGPROP) end
    self:note_keys(line, given, lines.set "RESTRAINT DIAPH DIAPHRAGM SPRINGPROP", { "GROUP", "USERJOINT", "MESH",
      "JOINTMESH", "GUID" })
  end
end

-- What is left --------------------------------------------------------------------------------------------------------

-- Sections that say nothing about the frame. Beginnings of their names.
local beside = { "PROGRAM INFORMATION", "CONTROLS", "GRIDS", "ANALYSIS OPTIONS", "FUNCTIONS",
  "LOAD CASES", "LOAD COMBINATIONS", "PROJECT INFORMATION", "DIMENSION LINES", "DEVELOPED ELEVATIONS", "GROUPS",
  "REBAR DEFINITIONS", "LOG", "PIER/SPANDREL NAMES", "TABLE SETS", "MODAL", "STEEL DESIGN", "STEEL PREFERENCES",
  "CONCRETE DESIGN", "CONCRETE PREFERENCES", "COMPOSITE", "WALL PREFERENCES", "WALL DESIGN", "SHEAR WALL DESIGN",
  "REFERENCE PLANES", "REFERENCE LINES", "RESPONSE SPECTRUM CASES", "PUSHOVER", "NAMED SETS", "AUTO SELECT",
  "SECTION CUTS", "GENERALIZED DISPLACEMENTS", "TOWERS", "DEFAULT", "DESIGN", "OPTIONS", "PREFERENCES", "SLAB DESIGN",
  "ACCEPTANCE CRITERIA", "STORIES", "PANEL ZONE PROPERTIES", "TENDON SECTIONS", "LINK PROPERTIES", "CONCRETE SLAB",
  "CONCRETE SECTIONS" }

-- Sections without a reader, and lines of the others that begin with a word that has none.
function Reader:note_the_rest()
  for _, s in ipairs(self.sections) do
    local left = {}
    for _, line in ipairs(s.lines) do
      if not line.read then left[#left + 1] = line end
    end
    if #left > 0 then
      table.insert(self.tables, { name = s.name, title = s.title, place = left[1].place, rows = left,
        beside = notes.begins_with(s.name, beside) })
    end
  end
  table.insert(self.tables, { name = "", rows = {}, remarks = self.remarks })
end

return function(options, ...)
  check.no_more(where, ...)
  local o = check.options(where, options, { file = { "string" }, sections = { "table", optional = true },
    slabs = sheets.rule })
  local sections, others = notes.within_limits(where, o.file, function() return lines.sections_of(o.file) end)
  if #sections == 0 then check.fail("%s: %s has no line that begins with '$ '", where, o.file) end
  local self = setmetatable({ file = o.file, sections = sections, tables = {}, remarks = {}, joints = {},
    frames = {} }, Reader)
  self:read_units()
  self:read_storeys()
  self:read_points()
  self:read_materials()
  self:read_sections()
  self:read_connectivities()
  self:read_lines()
  self:read_point_properties()
  self:read_point_assigns()
  e2k_areas(self)
  self:read_patterns()
  self:read_mass_source()
  self:read_point_loads()
  self:read_line_loads()
  self:note_the_rest()
  return sap_frame.read(where, o.file, self.tables, others, "ETABS", o.sections, o.slabs)
end
