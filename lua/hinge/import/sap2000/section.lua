-- A section of SAP2000: the properties that the file states, the size, outline and plastic moduli of its shape.
--
-- t3 is the depth along axis 2, which is y of hinge, t2 the width along axis 3. I33 is Ix, I22 is Iy, AS2 is
-- shear_area_y, AS3 is shear_area_x. A shear area of 0 means that the member has no shear strain.
local core = require "hinge.core"
local named = require "hinge.sections.named"
local notes = require "hinge.import.notes"
local shapes = require "hinge.sections.shapes"

local rigid = 1000 -- shear areas over the area: the shear strain that is left is 1/1000 of what the area would give
local largest_difference = 0.02 -- of areas, beyond which hinge.section.general refuses the outline

-- What a shape makes of the dimensions, or nil for a shape that it does not have. d(key): a field, m.
local makers = {
  ["I/WIDE FLANGE"] = function(d)
    local b, t = d "t2b" or d "t2", d "tfb" or d "tf"
    if b ~= d "t2" or t ~= d "tf" then return nil end
    return shapes.h { depth = d "t3", width = d "t2", web = d "tw", flange = d "tf", r = d "FilletRadius" }
  end,
  ["BOX/TUBE"] = function(d)
    return shapes.box { depth = d "t3", width = d "t2", web = d "tw", flange = d "tf" }
  end,
  PIPE = function(d) return shapes.pipe { diameter = d "t3", thickness = d "tw" } end,
  RECTANGULAR = function(d) return shapes.solid { depth = d "t3", width = d "t2" } end,
  CIRCLE = function(d) return shapes.round { diameter = d "t3" } end,
  CHANNEL = function(d)
    local made = shapes.channel { depth = d "t3", width = d "t2", web = d "tw", flange = d "tf" }
    made.outline = nil -- the side on which its flanges are is not in the file
    return made
  end,
  TEE = function(d)
    return core.shape("tee", { depth = d "t3", width = d "t2", web = d "tw", flange = d "tf" }, "tee")
  end,
  ["DOUBLE ANGLE"] = function(d)
    local gap = d "dis" or 0
    return core.shape("double angle", { depth = d "t3", width = (d "t2" - gap) / 2, thickness = d "tf", gap = gap },
      "double angle")
  end,
}

-- Lengths of the row, m; one that is 0 counts as left out.
local function dimensions(reader, row)
  return function(key)
    local value = row:number(key, 0) * reader.length
    return value > 0 and value or nil
  end
end

local needed = { ["I/WIDE FLANGE"] = "t3 t2 tf tw", ["BOX/TUBE"] = "t3 t2 tf tw", PIPE = "t3 tw",
  CHANNEL = "t3 t2 tf tw", TEE = "t3 t2 tf tw", ["DOUBLE ANGLE"] = "t3 t2 tf",
  RECTANGULAR = "t3 t2", CIRCLE = "t3" }

-- The dimensions that a shape needs and the row does not have, "t3, tf"; nil: none.
local function missing(shape, d)
  local list = {}
  for key in (needed[shape] or ""):gmatch "%S+" do
    if not d(key) then list[#list + 1] = key end
  end
  return #list > 0 and table.concat(list, ", ") or nil
end

-- The section of this name in the tables of hinge, if its area and moments are those of the row.
local function of_its_name(reader, row)
  local good, known = pcall(named.properties, row:text "SectionName")
  if not good then return nil end
  for key, field in pairs { Area = "area", I33 = "Ix", I22 = "Iy" } do
    local value = row:text(key) and row:number(key) * reader.length ^ (key == "Area" and 2 or 4)
    if value and not (math.abs(value / known[field] - 1) <= largest_difference) then return nil end
  end
  reader:assume(row, ("the section has no dimensions: its outline and plastic moduli are those of %s in "
    .. "hinge.section.named"):format(known.kind), "named outline")
  return known
end

--- What the shape of a row gives: size, outline, and properties that the row may leave out.
local function shape_of(reader, row)
  local d = dimensions(reader, row)
  local shape = (row:text "Shape" or "General"):upper()
  local maker = makers[shape]
  local size = d "t2" and d "t3" and { width = d "t2", depth = d "t3" } or nil
  local lost = missing(shape, d)
  if lost then
    local known = of_its_name(reader, row)
    if known then return known end
    reader:assume(row, ("the section of shape %s has no %s: it has the properties of the file, no outline, and no "
      .. "plastic moduli but those of the file"):format(shape, lost), "no dimensions")
  end
  if lost or not maker then return { size = size } end
  local good, made = pcall(maker, d)
  if not good then
    notes.fail(reader.where, row.place, "section of shape %s: %s", shape, (tostring(made):gsub("^.-hinge%.", "hinge.")))
  end
  return made or { size = { width = d "t2", depth = d "t3" } }
end

-- A property of the file times its modifier, else that of the shape.
local function property(reader, row, key, modifier, power, of_shape)
  local value, factor = row:text(key) and row:number(key) * reader.length ^ power or of_shape, row:number(modifier, 1)
  return value and value * factor
end

-- Shear areas of the file: 0 is without shear strain.
local function shear_area(reader, row, key, modifier, of_shape, area)
  local value = property(reader, row, key, modifier, 2, of_shape)
  if value ~= 0 then return value end
  reader:assume(row, ("%s is 0, which is no shear strain: its shear area is %d times the area"):format(key, rigid))
  return rigid * area
end

local function modulus(reader, row, key, of_shape)
  local value = row:number(key, 0) * reader.length ^ 3
  return value > 0 and value or of_shape
end

local function is_there(value) return value and value > 0 end

-- The section by its name in the tables of hinge: that of the catalogue of ETABS, else its own. Or nil and the reason.
local function by_name(reader, row, name)
  local text = row:text "Catalogue" or name
  local good, known = pcall(named.properties, text)
  if good then
    reader:assume(row, ("the section has no properties: it is %s of hinge.section.named"):format(known.kind),
      "no properties")
    return { name = name, named = known.kind }
  end
  local nearest = tostring(known):match "the nearest are (.-);"
  local told = nearest and ("no table of hinge has '%s'; the nearest are %s"):format(text, nearest)
    or ("no table of hinge has '%s'"):format(text)
  return nil, ("the section needs Area, I33, I22 and TorsConst above 0, and %s: name another one in the option "
    .. "sections, or by --sections map.csv with the line %s,NAME"):format(told, name)
end

--- The section as a row of frame.sections, or nil and why it cannot be read.
return function(reader, row, name)
  local other = reader.other_sections[name] or reader.other_sections[row:text "Catalogue" or ""]
  if other then
    reader.used_sections[reader.other_sections[name] and name or row:text "Catalogue"] = true
    for key in pairs(row.fields) do row:text(key) end
    reader:assume(row, ("it is %s, as the option sections says"):format(other))
    return { name = name, named = other }
  end
  if row:text "Named" then return { name = name, named = row:text "Named" } end
  local shape = shape_of(reader, row)
  local whole = row:text "Area" and row:number "Area" * reader.length ^ 2 or shape.area
  local area = whole and whole * row:number("AMod", 1)
  local Ix = property(reader, row, "I33", "I3Mod", 4, shape.Ix)
  local Iy = property(reader, row, "I22", "I2Mod", 4, shape.Iy)
  local J = property(reader, row, "TorsConst", "JMod", 4, shape.J)
  if not (is_there(area) and is_there(Ix) and is_there(Iy) and is_there(J)) then
    if area or Ix or Iy then return nil, "the section needs Area, I33, I22 and TorsConst above 0" end
    return by_name(reader, row, name)
  end
  if row:number("I23", 0) ~= 0 then
    return nil, "I23 is not 0: axes that are not principal axes are not read"
  end
  if row:number("MMod", 1) ~= 1 or row:number("WMod", 1) ~= 1 then
    reader:not_read(row, "MMod and WMod, factors of mass and weight, are not read")
  end
  local plastic = shape.plastic or {}
  local section = { name = name, area = area, Ix = Ix, Iy = Iy, J = J, size = shape.size,
    shear_area_x = shear_area(reader, row, "AS3", "A3Mod", shape.shear_area_x, area),
    shear_area_y = shear_area(reader, row, "AS2", "A2Mod", shape.shear_area_y, area),
    plastic = { A = whole, Zx = modulus(reader, row, "Z33", plastic.Zx), Zy = modulus(reader, row, "Z22", plastic.Zy),
      Zz = plastic.Zz } }
  if shape.outline and math.abs(shape.area - area) <= largest_difference * area then section.outline = shape.outline end
  return section
end
