-- What slabs are made of: sections of areas of SAP2000 and ETABS as model:panel takes them, with what the option
-- `slabs` of the readers gives beside the file.
--
-- Concrete is the panel's concrete, which carries no tension, with the bars of a layered section or of the option.
-- Another material is a plate of metal.
local check = require "hinge.library.check"
local notes = require "hinge.import.notes"

local Sheets = {}
Sheets.__index = Sheets

local sheets = {}

-- The option --------------------------------------------------------------------------------------------------------

local optional = require "hinge.import.ties".optional
local of_panel = { thickness = optional("number", { unit = "m", above = 0 }), material = optional "string",
  hardening = optional "number", ultimate_strain = optional "number", concrete = optional "table",
  reinforcement = optional "table", deck = optional "table", along = optional("numbers", { count = 3 }),
  mass = optional("number", { unit = "kg/m^2", at_least = 0 }),
  bending = { "bending", optional = true, words = "a table, \"layers\" or false",
    good = function(v) return v == false or v == "layers" or type(v) == "table" end } }
local of_all = { panels = { "number", whole = true, at_least = 1, at_most = 64, default = 4 },
  sections = { "table", default = {} } }
for field, rule in pairs(of_panel) do of_all[field] = rule end

--- The rule of the option.
sheets.rule = { "slabs", optional = true, words = "true, false, or a table of what slabs are made of",
  good = function(v) return type(v) == "boolean" or type(v) == "table" end }

--- The option `slabs` of a reader as a table; nil: none are wanted.
function sheets.option(where, given)
  if not given then return nil end
  local o = check.options(where .. ": slabs", given == true and {} or given, of_all)
  for _, name in ipairs(check.keys(o.sections)) do
    o.sections[name] = check.options(("%s: slabs.sections['%s']"):format(where, name), o.sections[name], of_panel)
  end
  return o
end

-- What the file says --------------------------------------------------------------------------------------------------

function Sheets:read_kinds()
  local reader = self.reader
  for _, row in ipairs(reader:rows "MATERIAL PROPERTIES 01 - GENERAL") do
    self.kind[row:need "Material"] = row:text "Type"
  end
  local stress = reader.force / reader.length ^ 2
  for name, fields in pairs { ["03B - CONCRETE DATA"] = "Fc", ["03E - REBAR DATA"] = "Fy" } do
    for _, row in ipairs(reader:rows("MATERIAL PROPERTIES " .. name)) do
      local value = row:number(fields, 0)
      local list = fields == "Fc" and self.strength or self.yield
      list[row:need "Material"] = value > 0 and value * stress or nil
    end
  end
  for name, given in pairs(reader.of_material) do -- of ETABS
    self.kind[name] = self.kind[name] or given.kind
    self.strength[name] = self.strength[name] or given.strength
  end
end

-- Bars of layered sections: x and y, area per width (m), and their material.
function Sheets:read_layers()
  local reader = self.reader
  for _, row in ipairs(reader:rows "AREA SECTION PROPERTY LAYERS") do
    local material, area = row:text "Material" or "", row:number("Thickness", 0) * reader.length
    local angle, of = row:number("MatAngle", 0) % 180, row:need "Section"
    local bars = (self.kind[material] or ""):lower() == "rebar" and (row:text "Type" or ""):lower() ~= "plate"
    local axis = angle == 0 and "x" or angle == 90 and "y"
    if bars and axis then
      local found = self.bars[of] or { material = material }
      self.bars[of], found[axis] = found, (found[axis] or 0) + area
    elseif bars then
      reader:not_read(row, "bars of slabs at other angles than 0 and 90 degrees are not read")
    elseif not self.concrete_of[of] and self:is_concrete(material) then
      self.concrete_of[of] = material
    end
  end
end

function Sheets:read_sections()
  for _, row in ipairs(self.reader:rows "AREA SECTION PROPERTIES") do
    local name = row:need "Section"
    self.section[name] = self.section[name] or { name = name, row = row, material = row:text "Material",
      thickness = row:number("Thickness", 0) * self.reader.length,
      bend = (row:text "BendThick" and row:number "BendThick" or row:number("Thickness", 0)) * self.reader.length,
      modifier = (row:number("M11Mod", 1) + row:number("M22Mod", 1)) / 2, mass_modifier = row:number("MMod", 1) }
  end
end

-- nil: the file does not say it.
function Sheets:is_concrete(material)
  local kind = (self.kind[material] or ""):lower()
  if kind:find "concrete" then return true end
  for _, other in ipairs { "steel", "metal", "alumi", "cold", "rebar", "tendon" } do
    if kind:find(other, 1, true) then return false end
  end
  if self.strength[material] then return true end
  local of = self.reader.material[material]
  if of and of.yield_stress then return false end
  return nil
end

-- A sheet -------------------------------------------------------------------------------------------------------------

-- One level of tables is merged, so that { bending = { sagging = 1e4 } } keeps the stiffness of the file.
local function merged(base, given)
  if base == nil or type(given) ~= "table" or given[1] then -- a list is taken as it is
    if given == nil then return base end
    return given
  end
  local result = check.copy(base)
  for key, value in pairs(given) do result[key] = value end
  return result
end

-- What the option gives for a section.
function Sheets:given(name)
  local given, own = {}, self.option.sections[name] or {}
  for field in pairs(of_panel) do given[field] = merged(self.option[field], own[field]) end
  return given
end

local function bending_of(section, material, thickness)
  local nu = material.nu or material.G and material.E / (2 * material.G) - 1 or 0.3
  local factor = section.thickness > 0 and section.bend / section.thickness or 1
  return { stiffness = section.modifier * material.E * (factor * thickness) ^ 3 / (12 * (1 - nu ^ 2)), poisson = nu }
end

local function thickless(section)
  return ("its section '%s' has no thickness that is read"):format(section.name)
end

function Sheets:of_concrete(section, given, material, name)
  local concrete = merged({ thickness = section.thickness > 0 and section.thickness or nil, E = material.E,
    strength = self.strength[name], density = material.density }, given.concrete)
  local bars = self.bars[section.name]
  bars = bars and { x = bars.x, y = bars.y, E = (self.reader.material[bars.material] or {}).E,
    yield_stress = self.yield[bars.material] }
  local sheet = { concrete = concrete, reinforcement = merged(bars, given.reinforcement), deck = given.deck }
  if not concrete.thickness then return nil, thickless(section) end
  if not sheet.reinforcement and not sheet.deck and not section.lacks then
    section.lacks = true
    table.insert(self.lacking, section)
  end
  sheet.bending = merged(bending_of(section, material, concrete.thickness), given.bending)
  return sheet, concrete.thickness * (concrete.density or 0)
end

local function plate_of(section, given, material, name)
  local thickness = given.thickness or section.thickness
  if thickness <= 0 then return nil, thickless(section) end
  local sheet = { thickness = thickness, material = name, hardening = given.hardening,
    ultimate_strain = given.ultimate_strain, reinforcement = given.reinforcement, deck = given.deck,
    bending = given.bending }
  if sheet.bending == nil and (section.modifier ~= 1 or section.bend ~= section.thickness) then
    sheet.bending = bending_of(section, material, thickness)
  elseif type(given.bending) == "table" then
    sheet.bending = merged(bending_of(section, material, thickness), given.bending)
  end
  return sheet, thickness * (material.density or 0)
end

-- What a section became, for the notes.
local function words(self, sheet, name, concrete, guessed)
  local list = {}
  if sheet.concrete then
    local c = sheet.concrete
    list[1] = ("concrete of %.4g m, E %.4g GPa, %s"):format(c.thickness, c.E / 1e9,
      c.strength and ("strength %.4g MPa"):format(c.strength / 1e6) or "elastic in compression")
  else
    local of = self.reader.material[name]
    list[1] = ("a plate of %.4g m, E %.4g GPa, %s"):format(sheet.thickness, of.E / 1e9,
      of.yield_stress and ("yield stress %.4g MPa"):format(of.yield_stress / 1e6) or "elastic: it never yields")
    if concrete then list[#list + 1] = "concrete that never cracks" end
    if guessed then list[#list + 1] = "the file does not say of what kind its material is" end
  end
  local r, b = sheet.reinforcement, sheet.bending
  if r and r[1] then
    list[#list + 1] = ("%d meshes of bars"):format(#r)
  elseif r then
    list[#list + 1] = ("bars of %.4g and %.4g m^2/m along x and y, %s"):format(r.x or 0, r.y or 0, r.yield_stress
      and ("yield stress %.4g MPa"):format(r.yield_stress / 1e6) or "elastic: they never yield")
  end
  if b == false then list[#list + 1] = "no bending" end
  if b == "layers" then list[#list + 1] = "bends by its layers" end
  if type(b) == "table" and not (b.sagging and b.hogging) then list[#list + 1] = "elastic in bending, uncracked" end
  return table.concat(list, "; ")
end

--- The name of the sheet of a section for an area whose axes are turned by an angle (degrees), and its sheet; or nil
--- and the reason.
function Sheets:of(name, angle)
  local section = self.section[name or ""]
  if not section then return nil, "it has no section with a thickness" end
  local own = angle ~= 0 and ("%s at %.6g degrees"):format(name, angle) or name
  local made = self.made[own]
  if made ~= nil then return made and own or nil, made or self.why[own] end
  local given = self:given(name)
  local material_name = given.material or self.concrete_of[name] or section.material or ""
  local material, concrete = self.reader.material[material_name], self:is_concrete(material_name)
  local sheet, mass
  if not material then
    mass = ("the material '%s' of its section '%s' is not read"):format(material_name, name)
  elseif given.concrete or concrete and not given.material then
    sheet, mass = self:of_concrete(section, given, material, material_name)
  else
    sheet, mass = plate_of(section, given, material, material_name)
  end
  if not sheet then
    self.made[own], self.why[own] = false, mass
    return nil, mass
  end
  sheet.name, sheet.mass = own, given.mass or mass * section.mass_modifier
  sheet.along = given.along
  if not sheet.along and angle ~= 0 then
    sheet.along = { math.cos(math.rad(angle)), math.sin(math.rad(angle)), 0 }
  end
  self.made[own] = sheet
  notes.add(self.reader.notes.assumed, section.row.place, section.row.line, ("slabs of '%s': %s"):format(own,
    words(self, sheet, material_name, concrete, concrete == nil)))
  return own, sheet
end

--- An error that asks for what the sections lack that areas have: bars in concrete.
function Sheets:ask()
  if #self.lacking == 0 then return end
  local names, first = {}, self.lacking[1]
  for i, section in ipairs(self.lacking) do names[i] = "'" .. section.name .. "'" end
  notes.fail(self.reader.where, first.row.place, "slabs of %s are of concrete, and the file has no bars in them; give "
    .. "slabs = { reinforcement = { x = 393e-6, y = 393e-6, yield_stress = 500e6 } } (m^2/m, Pa), of one section by "
    .. "slabs = { sections = { [%s] = { reinforcement = ... } } }, or a material that makes it an elastic plate, "
    .. "{ material = '%s' }", table.concat(names, ", "), names[1], first.material or "")
end

--- The sheets that the sections of a reader can be.
function sheets.new(reader)
  local self = setmetatable({ reader = reader, option = reader.slabs, kind = {}, strength = {}, yield = {}, bars = {},
    concrete_of = {}, section = {}, made = {}, why = {}, lacking = {} }, Sheets)
  self:read_kinds()
  self:read_layers()
  self:read_sections()
  return self
end

return sheets
