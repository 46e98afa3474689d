-- A frame in tables of SAP2000: rows of fields by the names that SAP2000 gives them. import.s2k reads such tables, and
-- import.e2k makes them of ETABS's lines.
--
-- Names of tables and fields: exported files in public repositories. Local axes, after the help of CSI on frames: axis
-- 1 is along the member. Axis 2 is in a vertical plane and upwards; of a vertical member it is along global X. A member
-- is vertical if the sine of its angle to Z is below 1e-3. The angle turns axis 2 towards axis 3.
local check = require "hinge.library.check"
local frame_module = require "hinge.import.frame"
local named = require "hinge.sections.named"
local notes = require "hinge.import.notes"
local sap_areas = require "hinge.import.sap2000.areas"
local nonprismatic = require "hinge.import.sap2000.nonprismatic"
local sap_loads = require "hinge.import.sap2000.loads"
local sap_offsets = require "hinge.import.sap2000.offsets"
local sap_ties = require "hinge.import.sap2000.ties"
local sheets = require "hinge.import.sap2000.sheets"
local sap_section = require "hinge.import.sap2000.section"
local rows = require "hinge.import.sap2000.row"
local units = require "hinge.library.units"

local fail = rows.fail
local sap_frame = {}

-- The reader ----------------------------------------------------------------------------------------------------------

local Reader = {}
Reader.__index = Reader
for name, method in pairs(require "hinge.import.sap2000.members") do Reader[name] = method end

-- The rows of a table that may be missing; marks it as read.
function Reader:rows(name)
  local found = self.tables[name]
  if not found then return {} end
  found.read = true
  return found.rows
end

--- A note on what is not read of a row; rows with the same reason, or of the same kind, are one note with a count.
function Reader:not_read(row, reason, kind)
  row.unread = true
  notes.once(self.notes, row.place, row.line, reason, kind)
end

--- A note, once for each kind, on what is taken where the file says otherwise or not at all.
function Reader:assume(row, reason, kind) notes.once(self.notes.assumed, row.place, row.line, reason, kind) end

local forces = { n = 1, kn = 1e3, kgf = units.gravity, tonf = 1e3 * units.gravity, lb = units.lbf, kip = units.kip }
local lengths = { m = 1, cm = 1e-2, mm = 1e-3, micron = 1e-6, ["in"] = units.inch, ft = units.ft }

-- CurrUnits="Kip, in, F"; masses fit forces, lengths and seconds.
function Reader:read_units()
  local row = self:rows "PROGRAM CONTROL"[1]
  if not row then
    check.fail("%s: %s has no TABLE \"PROGRAM CONTROL\", so that its units are not known", self.where, self.file)
  end
  local text = row:need "CurrUnits"
  local force, length = text:match "^%s*(%a+)%s*,%s*(%a+)"
  self.force, self.length = forces[(force or ""):lower()], lengths[(length or ""):lower()]
  if not (self.force and self.length) then
    fail(row, "CurrUnits is '%s'; must be a force (%s) and a length (%s), as in 'KN, m, C'", text,
      table.concat(check.keys(forces), ", "), table.concat(check.keys(lengths), ", "))
  end
  self.mass = self.force / self.length -- times s^2
  local program = row:text "ProgramName"
  if program and program:upper() ~= "SAP2000" then
    notes.add(self.notes.assumed, row.place, "ProgramName=" .. program,
      "the local axes of frames are taken by the rule of SAP2000; ETABS lets axis 1 of beams point towards +X")
  end
  for _, key in ipairs { "Version", "ProgLevel" } do row:text(key) end
end

local directions = frame_module.letters

--- The key of a direction, UX to RZ.
function Reader.key_of(letter) return (#letter == 1 and "U" .. letter or letter):upper() end

-- What is left out of the analysis, as in a plane frame, is fixed at every joint.
function Reader:read_freedoms()
  local row = self:rows "ACTIVE DEGREES OF FREEDOM"[1]
  self.inactive = {}
  for _, letter in ipairs(row and directions or {}) do
    local key = Reader.key_of(letter)
    if row:text(key) and not row:yes(key) then self.inactive[letter] = true end
  end
  if next(self.inactive) then
    notes.add(self.notes.assumed, row.place, row.line, "what is not active is fixed at all joints")
  end
end

-- Where a joint is, m: in the global system where the file says it, as it does for all systems.
function Reader:position(row)
  local system, kind = row:text "CoordSys" or "GLOBAL", row:text "CoordType" or "Cartesian"
  local keys = row:text "GlobalX" and { "GlobalX", "GlobalY", "GlobalZ" } or { "XorR", "Y", "Z" }
  if keys[1] == "XorR" and (system:upper() ~= "GLOBAL" or kind:lower() ~= "cartesian") then
    fail(row, "the joint is in the system %s, %s, and its GlobalX, GlobalY and GlobalZ are not in the file", system,
      kind)
  end
  local x, y, z = row:number(keys[1]), row:number(keys[2]), row:number(keys[3])
  for _, key in ipairs { "XorR", "Y", "Z", "SpecialJt" } do row:text(key) end
  return x * self.length, y * self.length, z * self.length
end

function Reader:read_joints()
  if not self.tables["JOINT COORDINATES"] then
    local names = {}
    for i, found in ipairs(self.tables) do names[i] = '"' .. found.name .. '"' end
    check.fail("%s: %s has no TABLE \"JOINT COORDINATES\"; it has %s", self.where, self.file,
      #names > 0 and table.concat(names, ", ") or "no table at all")
  end
  for _, row in ipairs(self:rows "JOINT COORDINATES") do
    local x, y, z = self:position(row)
    local name = row:need "Joint"
    if self.node[name] then fail(row, "joint %s is there twice", name) end
    local node = { name = name, x = x, y = y, z = z }
    table.insert(self.frame.nodes, node)
    self.node[name] = node
    self.places[node] = { file = self.file, line = row.place.line, text = row.line }
  end
end

function Reader:joint(row, key)
  local name = row:need(key)
  if not self.node[name] then fail(row, "%s: joint %s is not in JOINT COORDINATES", row.table, name) end
  return self.node[name]
end

-- What is not active, for a node that is none of the file's.
function Reader:inactive_fix() return frame_module.fix_of(self.inactive) end

function Reader:read_restraints()
  local fixed = {}
  for _, row in ipairs(self:rows "JOINT RESTRAINT ASSIGNMENTS") do
    local set = {}
    for i, letter in ipairs(directions) do
      set[letter] = row:yes(i <= 3 and "U" .. i or "R" .. i - 3) or self.inactive[letter]
    end
    fixed[self:joint(row, "Joint").name] = set
  end
  for _, node in ipairs(self.frame.nodes) do node.fix = frame_module.fix_of(fixed[node.name] or self.inactive) end
end

function Reader:read_materials()
  local yield = {}
  for _, row in ipairs(self:rows "MATERIAL PROPERTIES 03A - STEEL DATA") do
    local fy = row:number("Fy", 0)
    yield[row:need "Material"] = fy > 0 and fy * self.force / self.length ^ 2 or nil
  end
  for _, row in ipairs(self:rows "MATERIAL PROPERTIES 02 - BASIC MECHANICAL PROPERTIES") do
    local name, stress = row:need "Material", self.force / self.length ^ 2
    local G, nu = row:number("G12", 0), row:number("U12", 0.3)
    local E = row:number("E1", 0)
    for _, key in ipairs { "A1", "SymType" } do row:text(key) end
    local strength = row:number("Strength", 0) -- of ETABS, as is Kind
    self.of_material[name] = { kind = row:text "Kind", strength = strength > 0 and strength * stress or nil }
    if self.material[name] then
      self:not_read(row, "material " .. name .. " has other values above, at another temperature")
    elseif E <= 0 then
      self.unreadable[name] = row
      self:not_read(row, "the material has no E1")
    else
      local density = row:number("UnitMass", 0) * self.mass / self.length ^ 3
      local weight = row:text "UnitWeight" and row:number "UnitWeight" * self.force / self.length ^ 3
      self.material[name] = { name = name, E = E * stress, G = G > 0 and G * stress or nil, nu = G <= 0 and nu or nil,
        density = density, unit_weight = weight, yield_stress = yield[name] }
      table.insert(self.frame.materials, self.material[name])
    end
  end
end

function Reader:read_sections()
  self.nonprismatic = nonprismatic.segments(self)
  for _, row in ipairs(self:rows "FRAME SECTION PROPERTIES 01 - GENERAL") do
    local name = row:need "SectionName"
    local segments = self.nonprismatic[name]
    local section, reason
    if not segments then section, reason = sap_section(self, row, name) end
    if segments then
      self.section[name] = { material = row:text "Material", first = segments[1].from }
    elseif not section then
      row.unread = true
      self.unreadable[name] = row
      self.reasons[name] = reason -- told where a member has the section
    else
      if self.section[name] then fail(row, "section %s is there twice", name) end
      self.section[name] = { material = row:text "Material" }
      table.insert(self.frame.sections, section)
    end
  end
end

-- Loads ---------------------------------------------------------------------------------------------------------------

function Reader:read_patterns()
  for _, row in ipairs(self:rows "LOAD PATTERN DEFINITIONS") do
    local name = row:need "LoadPat"
    if self.case[name] then fail(row, "load pattern %s is there twice", name) end
    row:text "DesignType"
    self.case[name] = { name = name, self_weight = row:number("SelfWtMult", 0), loads = {} }
    table.insert(self.frame.cases, self.case[name])
  end
end

-- The load pattern of a row: LoadPat, in older files LoadCase.
function Reader:pattern(row)
  local name = row:text "LoadPat" or row:text "LoadCase" or row:need "LoadPat"
  if not self.case[name] then
    if self.tables["LOAD PATTERN DEFINITIONS"] then
      fail(row, "load pattern %s is not in LOAD PATTERN DEFINITIONS", name)
    end
    self.case[name] = { name = name, loads = {} }
    table.insert(self.frame.cases, self.case[name])
  end
  return self.case[name]
end

local function any(v) return v[1] ~= 0 or v[2] ~= 0 or v[3] ~= 0 end

function Reader:read_joint_loads()
  for _, row in ipairs(self:rows "JOINT LOADS - FORCE") do
    local joint, case = self:joint(row, "Joint"), self:pattern(row)
    local v = {}
    for i, key in ipairs { "F1", "F2", "F3", "M1", "M2", "M3" } do
      v[i] = row:number(key, 0) * self.force * (i > 3 and self.length or 1)
    end
    if (row:text "CoordSys" or "GLOBAL"):upper() ~= "GLOBAL" then
      self:not_read(row, "loads in GLOBAL alone are read")
    else
      local force, moment = { v[1], v[2], v[3] }, { v[4], v[5], v[6] }
      local load = { node = joint.name, force = any(force) and force or nil, moment = any(moment) and moment or nil }
      self.places[load] = { file = self.file, line = row.place.line, text = row.line }
      if load.force or load.moment then table.insert(case.loads, load) end
    end
  end
end

-- What is left --------------------------------------------------------------------------------------------------------

-- Tables that say nothing about the frame: how it is analysed, designed, drawn. Beginnings of their names.
local beside = { "ANALYSIS OPTIONS", "AUTO WAVE", "BRIDGE RESPONSE", "CASE - ", "COMBINATION DEFINITIONS",
  "COORDINATE SYSTEMS", "DATABASE FORMAT", "DESIGN", "FRAME DESIGN PROCEDURES",
  "FRAME LOAD TRANSFER", "FRAME OUTPUT STATION", "FRAME SECTION PROPERTIES 04 - AUTO SELECT",
  "FRAME SECTION PROPERTIES 13 - TIME DEPENDENT", "FUNCTION - ", "GRID LINES", "GROUPS 1", "GROUPS 3", "JOINT PATTERN",
  "LOAD CASE DEFINITIONS", "MATERIAL LIST", "MATERIAL PROPERTIES 01", "MATERIAL PROPERTIES 03",
  "MATERIAL PROPERTIES 04", "MATERIAL PROPERTIES 06", "MATERIAL PROPERTIES 09", "NAMED SETS",
  "OBJECT GEOMETRY", "OPTIONS - ", "OVERWRITES",
  "PREFERENCES", "PROJECT INFORMATION", "REBAR SIZES", "TABLES AUTOMATICALLY" }

-- The fields of a table's rows that nothing here is made of.
local function unused(found)
  local keys = {}
  for _, row in ipairs(found.rows) do
    for key in pairs(row.fields) do
      if not (row.used[key] or row.unread) then keys[key] = true end
    end
  end
  return check.keys(keys)
end

function Reader:note_the_rest(others)
  for _, name in ipairs(check.keys(self.reasons)) do
    local row = self.unreadable[name]
    notes.once(self.notes.skipped, row.place, row.line, "no member has this section")
  end
  for _, line in ipairs(others) do notes.add(self.notes.skipped, line.place, line.line) end
  for _, found in ipairs(self.tables) do
    for _, remark in ipairs(found.remarks or {}) do
      notes.once(remark.assumed and self.notes.assumed or self.notes, remark.place, remark.line, remark.reason,
        remark.kind)
    end
    local title = found.title or ('TABLE: "%s"'):format(found.name)
    if found.silent then goto next end
    if found.read then
      local keys = unused(found)
      if #keys > 0 then
        notes.add(self.notes.skipped, found.place, title, "fields " .. table.concat(keys, ", "))
      end
    elseif #found.rows > 0 then
      local list = (found.beside or notes.begins_with(found.name, beside)) and self.notes.skipped or self.notes
      notes.add(list, found.place, ("%s, %s"):format(title, check.count(#found.rows, "row")),
        list == self.notes and "the table is not read" or nil)
    end
    ::next::
  end
end

--- The names of hinge.section.named that sections of a file shall have, by their names there, checked.
function sap_frame.other_sections(where, sections)
  local of = {}
  for _, name in ipairs(check.keys(sections or {})) do
    local other = sections[name]
    if type(name) ~= "string" or type(other) ~= "string" then
      check.fail("%s: sections must be a table such as { ['W14X999'] = 'W14X873' }", where)
    end
    of[name] = named.properties(other).kind
  end
  return of
end

-- Names of the option `sections` that the file does not have.
function Reader:check_other_sections()
  for _, name in ipairs(check.keys(self.other_sections)) do
    if not self.used_sections[name] then
      local there = {}
      for i, row in ipairs(self:rows "FRAME SECTION PROPERTIES 01 - GENERAL") do there[i] = row.fields.SectionName end
      check.unknown(self.where, "section of the file in 'sections':", name, there)
    end
  end
end

--- The description of the frame and the notes. `tables`: by name, { name =, place =, rows = }, and in their order; a
--- table may have a title of its own, remarks for the notes, and beside = true: it says nothing about the frame.
--- `others`: lines of the file that belong to none, { place =, line = }. `program`: whose rules hold. `sections`: the
--- option of import.s2k and import.e2k; so is `slabs`.
function sap_frame.read(where, file, tables, others, program, sections, slabs)
  local self = setmetatable({ where = where, file = file, tables = tables, program = program or "SAP2000",
    other_sections = sap_frame.other_sections(where, sections), used_sections = {},
    frame = frame_module.new(file), notes = notes.new(), places = {}, node = {}, material = {}, section = {},
    member = {}, parts = {}, case = {}, unreadable = {}, reasons = {}, lost = {}, of_material = {},
    slabs = sheets.option(where, slabs) }, Reader)
  self:read_units()
  self:read_freedoms()
  self:read_joints()
  self:read_restraints()
  self:read_materials()
  self:read_sections()
  self:check_other_sections()
  self:read_members()
  self:divide()
  sap_ties.read_ends(self)
  sap_offsets.read(self)
  self:read_patterns()
  self:read_joint_loads()
  sap_loads(self)
  sap_offsets.settle(self)
  sap_ties.read(self)
  sap_areas(self)
  self:note_the_rest(others)
  return frame_module.finish(self.frame, self.notes, self.places)
end

return sap_frame
