-- Cross-sections by their names in tables: "HEB 300", "W14X90", "CHS 168.3x8". The tables are
-- lua/hinge/sections/profiles/*.lua.
--
-- Names are compared without case, blanks and zeros at the end of numbers; "HE 300 B" is HEB 300, "SHS 100x5" is
-- SHS 100x100x5, and "HSS8X8X.5" is HSS8X8X1/2.
local core = require "hinge.core"
local check = require "hinge.library.check"
local further = require "hinge.sections.further_names"
local shapes = require "hinge.sections.shapes"

local named = {}

local files = { "european", "british", "angles", "american", "hollow", "japanese", "american_more", "hd", "chinese" }
local units = { mm = 1e-3, ["in"] = 0.0254 }

-- ASTM A6: `flange` is the mean thickness of the part beside the web
local function tapered_channel(d, slope)
  d.slope, d.flange_at = slope, (d.width + d.web) / 2
  return shapes.channel(d)
end
local function with_corners(d, outer, inner)
  d.r, d.r_inner = outer * d.thickness, inner * d.thickness
  return shapes.box(d)
end
-- What is made of a row's dimensions, m.
local makers = {
  h = shapes.h, angle = shapes.angle, pipe = shapes.pipe,
  tapered = function(d) return core.shape("tapered", d, "H with tapered flanges") end,
  tapered_channel = function(d) return tapered_channel(d, 1 / 6) end,
  flat_channel = function(d) return tapered_channel(d, 1 / 12) end,
  w = function(d)
    d.r, d.kdes = d.kdes - d.flange, nil
    return shapes.h(d)
  end,
  -- DIN 1026-1: flanges of 8 % slope, measured at half the width; above 300 mm 5 %, at half of what is beside the web
  upn = function(d)
    local low = d.depth < 0.31
    d.r, d.r_toe, d.slope = d.flange, d.flange / 2, low and 0.08 or 0.05
    d.flange_at = low and d.width / 2 or (d.width + d.web) / 2
    return shapes.channel(d)
  end,
  hot = function(d) return with_corners(d, 1.5, 1) end, -- EN 10210-2
  cold = function(d) -- EN 10219-2
    local t = d.thickness
    local outer = t <= 0.006 + 1e-9 and 2 or t <= 0.01 + 1e-9 and 2.5 or 3
    return with_corners(d, outer, outer - 1)
  end,
  hss = function(d) return with_corners(d, 2, 1) end, -- AISC: of the design thickness
}

-- A number of a name: "12.50", ".5", "3/8", "1-1/4"; nil for anything else.
local function number(text)
  local whole, above, below = text:match "^(%d*)%-?(%d+)/(%d+)$"
  if whole and (whole == "" or text:find "%-") then
    return tonumber(below) ~= 0 and (tonumber(whole) or 0) + above / below or nil
  end
  return text:find "^%d*%.?%d+$" and tonumber(text) or nil
end

-- The sizes in a name, "200x100x8"; inches are rounded to sixteenths where they are near. Nil if there are others.
local function sizes_of(text, inches)
  local list = {}
  for part in (text .. "X"):gmatch "(.-)X" do
    local v = number(part)
    if not v then return nil end
    local sixteenths = math.floor(16 * v + 0.5)
    if inches and math.abs(16 * v - sixteenths) <= 0.01 then v = sixteenths / 16 end
    list[#list + 1] = v
  end
  return list
end

local function key_of(family, sizes)
  local parts = {}
  for i, v in ipairs(sizes) do parts[i] = ("%.8g"):format(v) end
  return family .. " " .. table.concat(parts, "x")
end

-- The rows of a table, each { name, dimensions in the table's unit, what is published }. A line of a table `by_walls`
-- is of one size: "100x50 8 4: 6 | 8.71 95.4; 8 | 11.4 121" are the sections 100x50x6 and 100x50x8, with 8 and 4 as
-- their further dimensions. Walls of American hollow sections are 0.93 of what the name says, to a thousandth; after
-- "0.322 0.3 |" it is 0.3.
local function rows_of(kind)
  local list = {}
  for line in kind.rows:gsub("\n  ", " "):gmatch "[^\n]+" do
    local head, rest = line:match "^(.-): (.*)$"
    for first, published in (rest .. ";"):gmatch " ?([^;|]*) | ([^;]*);" do
      local name, dimensions = head, first
      if kind.by_walls then
        local size, further_ones = head:match "^(%S+)(.*)$"
        local wall, given = first:match "^(%S+) ?(.*)$"
        if given == "" then
          given = kind.unit == "in" and ("%.3f"):format(0.93 * sizes_of(wall, true)[1]) or wall
        end
        name = size .. (kind.unit == "in" and "X" or "x") .. wall
        dimensions = table.concat(sizes_of(size:upper()), " ") .. " " .. given .. further_ones
      end
      list[#list + 1] = { name, dimensions, published }
    end
  end
  return list
end

-- The rows of a family, in the order of its tables and by key. They are read when something first asks for them: all
-- tables take 30 ms, one family 1 ms.
local function read_rows(family)
  family.rows, family.by_key = {}, {}
  for _, kind in ipairs(family.kinds) do
    for _, of in ipairs(rows_of(kind)) do
      local sizes = assert(sizes_of(of[1]:upper(), family.inches), of[1])
      local row = { kind = kind, name = kind.prefix .. of[1], dimensions = of[2], published = of[3], sizes = sizes }
      family.rows[#family.rows + 1], family.by_key[key_of(kind.family, sizes)] = row, row
    end
  end
end
local when_asked = {
  __index = function(family, field)
    if field ~= "rows" and field ~= "by_key" then return nil end
    read_rows(family)
    return rawget(family, field)
  end,
}

-- The families in their order, and by name: { name =, inches =, kinds =, rows =, by_key = }.
local families
local function read()
  if families then return end
  families = {}
  for _, file in ipairs(files) do
    for _, kind in ipairs(require("hinge.sections.profiles." .. file)) do
      local family = families[kind.family]
      if not family then
        family = setmetatable({ name = kind.family, kinds = {}, inches = kind.unit == "in" }, when_asked)
        families[#families + 1], families[kind.family] = family, family
      end
      table.insert(family.kinds, kind)
    end
  end
end

-- The row of these sizes, or nil.
local function row_of(family, sizes)
  return families[family] and families[family].by_key[key_of(family, sizes)]
end

local others = { UKB = "UB", UKC = "UC", HFSHS = "SHS", HFRHS = "RHS", HFCHS = "CHS", CFCHS = "CHS", IPB = "HEB",
  IPBL = "HEA", IPBV = "HEM", ROR = "CHS", UNP = "UPN" }

-- The dimensions of a row, m.
local function dimensions_of(row)
  local dimensions, unit, values = {}, units[row.kind.unit], row.dimensions:gmatch "%S+"
  for field in row.kind.columns:gmatch "%S+" do dimensions[field] = unit * tonumber(values()) end
  return dimensions
end

-- A name in capitals and without blanks.
local function text_of(name) return (name:upper():gsub("×", "X"):gsub("%*", "X"):gsub("[%s_]", "")) end

-- Family and sizes as a script wrote them; the second is nil where they cannot be read.
local function taken_apart(name)
  local text = text_of(name)
  local before, letters = text:match "^HE%-?(%d+)([ABM])$"
  if before then return "HE" .. letters, { tonumber(before) } end
  local family, rest = text:match "^(%a+)%-?(.*)$"
  if not family then rest, family = text:match "^([%d.X/%-]+)%-?(%a+)$" end
  if not family or family == "X" then return text, nil end
  family = others[family] or family
  local sizes = sizes_of(rest, families[family] and families[family].inches)
  if sizes and #sizes == 2 and (family:find "SHS$" or family == "L" or family == "BCR" or family == "BCP") then
    table.insert(sizes, 2, sizes[1])
  end
  return family, sizes
end

-- Square columns of Japan, cold formed by rolls (BCR) and by presses (BCP): any size of these walls. The outer radius
-- is 2.5 and 3.5 times the thickness; the inner one is less by the thickness.
local columns = { BCR = { 2.5, 6, 25 }, BCP = { 3.5, 6, 40 } }

local function column(name, family, sizes, options)
  local ratio, least, most = table.unpack(columns[family])
  if not sizes or #sizes ~= 3 or sizes[1] ~= sizes[2] then
    check.fail("hinge.section.named: '%s' is no square column; write side and thickness in mm, as in '%s 400x16'", name,
      family)
  end
  local side, t = sizes[1], sizes[3]
  if t < least or t > most or side < 2.5 * ratio * t then
    check.fail("hinge.section.named: '%s': %s have walls of %g to %g mm and sides of at least %g times as much", name,
      family, least, most, 2.5 * ratio)
  end
  local made = shapes.box { width = side / 1e3, depth = side / 1e3, thickness = t / 1e3, r = ratio * t / 1e3,
    interaction = options.interaction }
  made.kind, made.shape = ("%s %gx%gx%g"):format(family, side, side, t), made.kind
  return made
end

local function quoted(list)
  local parts = {}
  for i, v in ipairs(list) do parts[i] = "'" .. v .. "'" end
  return table.concat(parts, ", ")
end

-- The rows of a family whose sizes are nearest in their ratios.
local function nearest(family, sizes, count)
  local list = {}
  for i, row in ipairs(family.rows) do
    local off = 0
    for k = 1, math.max(#sizes, #row.sizes) do
      local a, b = sizes[k], row.sizes[k]
      off = off + (a and b and a > 0 and math.abs(math.log(a / b)) or 10)
    end
    list[i] = { off = off, at = i, name = row.name }
  end
  table.sort(list, function(a, b) return a.off < b.off or a.off == b.off and a.at < b.at end)
  local names = {}
  for i = 1, math.min(count, #list) do names[i] = list[i].name end
  return names
end

local function family_names()
  local names = {}
  for i, family in ipairs(families) do names[i] = family.name end
  names[#names + 1], names[#names + 2] = "BCR", "BCP"
  return names
end

local function not_found(name, family, sizes)
  if text_of(name):find "^PIPE" then
    check.fail("hinge.section.named: unknown section '%s'; pipes are Pipe1/2STD to Pipe26STD, with STD, XS or XXS; "
      .. "Pipe20 is one of 20 in or of 20 mm", name)
  end
  local known = families[family]
  if known then
    local metric = sizes and further.in_inches(known, sizes)
    check.fail("hinge.section.named: unknown section '%s'; the nearest are %s; hinge.section.names '%s' gives all",
      name, quoted(nearest(known, metric or sizes or {}, 3)), family)
  end
  local meant = core.did_you_mean(family, family_names()):match "'(.-)'"
  local row = meant and sizes and row_of(meant, sizes)
  check.fail("hinge.section.named: unknown section '%s'%s; families are %s", name,
    row and (" (did you mean '%s'?)"):format(row.name) or meant and (" (did you mean '%s'?)"):format(meant) or "",
    table.concat(family_names(), ", "))
end

local option_rules = { interaction = { "string", one_of = { "paper", "exact", "exact with shear" }, optional = true } }

--- The properties of a section by its name, as hinge.shapes gives them; `kind` is the name.
function named.properties(name, options)
  if type(name) ~= "string" then
    check.fail("hinge.section.named: the name is %s; must be a string such as 'HEB 300'",
      name == nil and "missing" or check.show(name))
  end
  options = check.options("hinge.section.named", options, option_rules)
  read()
  local family, sizes = taken_apart(name)
  if columns[family] then return column(name, family, sizes, options) end
  local row = sizes and (row_of(family, sizes) or further.row(families, family, sizes))
  if not row then
    local made = family == "L" and further.angle(sizes)
      or further.made(text_of(name), families, sizes_of, dimensions_of)
    if not made then not_found(name, family, sizes) end
    made.interaction = options.interaction
    return made
  end
  local made = makers[row.kind.shape](dimensions_of(row))
  made.kind, made.shape, made.interaction = row.name, made.kind, options.interaction
  return made
end

--- The names of a family's sections, in the order of the tables; without a family the families.
function named.names(family)
  read()
  if family == nil then return family_names() end
  local known = type(family) == "string" and families[others[family:upper()] or family:upper()]
  if not known then
    check.fail("hinge.section.names: unknown family %s%s; there are %s", check.show(family),
      core.did_you_mean(tostring(family), family_names()), table.concat(family_names(), ", "))
  end
  local names = {}
  for i, row in ipairs(known.rows) do names[i] = row.name end
  return names
end

--- What tables publish of a section, SI: { area =, Ix =, ... } with the fields that its table has. For tests.
function named.published(name)
  read()
  local row = assert(row_of(taken_apart(name)), name)
  local values, published, unit = row.published:gmatch "%S+", {}, row.kind.unit == "mm" and 1e-2 or 0.0254
  for fields in row.kind.published:gmatch "%S+" do
    local value = tonumber(values())
    for field in fields:gmatch "[^=]+" do -- "Ix=Iy" of a square: one value for both
      published[field] = value * unit ^ (field == "area" and 2 or field:find "^Z" and 3 or 4)
    end
  end
  return published
end

return named
