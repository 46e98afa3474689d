-- import.csv: a frame from tables of nodes, members, sections, materials, supports, masses and loads, each a file whose
-- first line has the names of its columns. Units are SI.
local check = require "hinge.library.check"
local frame_module = require "hinge.import.frame"
local grades = require "hinge.sections.grades"
local named = require "hinge.sections.named"
local notes = require "hinge.import.notes"

local where = "hinge.import.csv"

-- Tables --------------------------------------------------------------------------------------------------------------

local function fail(place, ...) notes.fail(where, place, ...) end

-- The separator of a file: what its first line has most of.
local function separator_of(line)
  local best, most = ",", 0
  for _, c in ipairs { ",", ";", "\t" } do
    local _, count = line:gsub("%" .. c, "")
    if count > most then best, most = c, count end
  end
  return best
end

-- The cells of a line; one in double quotes may hold the separator, and "" for a quotation mark.
local function cells_of(place, line, separator)
  local cells, at = {}, 1
  while true do
    at = line:match("^[ ]*()", at)
    local cell
    if line:sub(at, at) == '"' then
      local stop = at + 1
      while true do
        stop = line:find('"', stop, true)
        if not stop then fail(place, "the quotes are not closed") end
        if line:sub(stop + 1, stop + 1) ~= '"' then break end
        stop = stop + 2
      end
      cell, at = line:sub(at + 1, stop - 1):gsub('""', '"'), line:match("^[ ]*()", stop + 1)
      if at <= #line and line:sub(at, at) ~= separator then fail(place, "there is text after the quotes") end
    else
      local stop = line:find(separator, at, true) or #line + 1
      cell, at = line:sub(at, stop - 1):gsub("%s+$", ""), stop
    end
    cells[#cells + 1] = cell
    if at > #line then return cells end
    at = at + 1
  end
end

local Row = {}
Row.__index = Row

--- The text of a cell; nil where it is empty or the file has no such column.
function Row:text(column)
  local cell = self.cells[column]
  return cell ~= "" and cell or nil
end

function Row:need(column)
  return self:text(column) or fail(self.place, "the cell of column '%s' is empty", column)
end

--- A cell as a number, or nil. With ; between cells a comma may be the decimal point.
function Row:number(column)
  local text = self:text(column)
  if not text then return nil end
  if self.separator == ";" and not text:find "%." then text = text:gsub(",", ".", 1) end
  local x = tonumber(text)
  if not x or x ~= x or math.abs(x) == math.huge then
    fail(self.place, "column '%s' is '%s'; must be a number", column, self:text(column))
  end
  return x
end

-- The columns of a file by their places; those that are not known are noted.
local function columns_of(list, place, names, columns, needed)
  local known, head, seen = {}, { count = #names }, {}
  for _, name in ipairs(columns) do known[name:lower()] = name end
  for i, name in ipairs(names) do
    head[i] = known[name:lower()]
    if not head[i] then
      notes.add(list, place, "column " .. name, "the column is not read; there are " .. table.concat(columns, ", "))
    elseif seen[head[i]] then
      fail(place, "the column '%s' is there twice", name)
    else
      seen[head[i]] = true
    end
  end
  for _, name in ipairs(needed) do
    if not seen[name] then
      fail(place, "the column '%s' is missing; there are %s", name, table.concat(columns, ", "))
    end
  end
  return head
end

-- The rows of a file. columns: those that it may have; needed: those without which it is none.
local function rows_of(list, path, columns, needed)
  local head, rows, separator
  for number, line in notes.lines(notes.read(where, path)) do
    local place = { file = path, line = number, text = line }
    if not line:find "%S" or line:find "^%s*#" then goto next end
    if not head then
      separator = separator_of(line)
      head, rows = columns_of(list, place, cells_of(place, line, separator), columns, needed), {}
    else
      local cells = cells_of(place, line, separator)
      if #cells > head.count then
        fail(place, "the line has %d cells, and the first line %d", #cells, head.count)
      end
      local row = setmetatable({ place = place, separator = separator, cells = {} }, Row)
      for i, cell in ipairs(cells) do
        if head[i] then row.cells[head[i]] = cell end
      end
      rows[#rows + 1] = row
    end
    ::next::
  end
  if not head then
    check.fail("%s: %s is empty; its first line must have the names of columns: %s", where, path,
      table.concat(columns, ", "))
  end
  return rows
end

-- The reader ----------------------------------------------------------------------------------------------------------

local Reader = {}
Reader.__index = Reader

function Reader:rows(file, columns, needed)
  if not self.files[file] then return {} end
  return rows_of(self.notes, self.files[file], columns, needed)
end

local function add(self, part, of, row, new)
  if of[new.name] then fail(row.place, "'%s' is there twice", new.name) end
  of[new.name], self.places[new] = new, row.place
  table.insert(self.frame[part], new)
end

local function find(row, what, name, of)
  if of[name] then return of[name] end
  fail(row.place, "%s '%s' is not in the file of %ss", what, name, what)
end

-- The error of a call of hinge, with the line of the file.
local function at_line(row, f, ...)
  local good, result = pcall(f, ...)
  if good then return result end
  fail(row.place, "%s", (tostring(result):gsub("^.-hinge%.", "hinge.")))
end

-- What a support fixes: the column `fix` as in model:fix, or 1 in columns of the directions.
local function fix_of(row)
  local fix = row:text "fix"
  if fix then
    fix = fix:gsub("[%s;/]+", ",")
    local rest = fix == "all" and "" or fix:gsub("r[xyz]", ""):gsub("[xyz,]", "")
    if rest ~= "" then
      fail(row.place, "column 'fix' is '%s'; must be all, or letters such as xyz or x,y,rx", row:text "fix")
    end
    return fix
  end
  local set = {}
  for _, letter in ipairs(frame_module.letters) do
    local flag = row:number(letter) or 0
    if flag ~= 0 and flag ~= 1 then fail(row.place, "column '%s' is %g; must be 0 or 1", letter, flag) end
    set[letter] = flag == 1
  end
  return frame_module.fix_of(set)
end

function Reader:read_nodes()
  for _, row in ipairs(self:rows("nodes", { "name", "x", "y", "z" }, { "name", "x", "y", "z" })) do
    local node = { name = row:need "name" }
    for _, axis in ipairs { "x", "y", "z" } do
      node[axis] = row:number(axis) or row:need(axis)
    end
    add(self, "nodes", self.node, row, node)
  end
  local columns = { "node", "fix", "x", "y", "z", "rx", "ry", "rz" }
  for _, row in ipairs(self:rows("supports", columns, { "node" })) do
    find(row, "node", row:need "node", self.node).fix = fix_of(row)
  end
end

local properties = { "area", "Ix", "Iy", "J", "shear_area_x", "shear_area_y" }

function Reader:read_sections()
  local columns = table.move(properties, 1, #properties, 2, { "name" })
  for _, more in ipairs { "Zx", "Zy", "Zz", "width", "depth", "named" } do columns[#columns + 1] = more end
  for _, row in ipairs(self:rows("sections", columns, { "name" })) do
    local section = { name = row:need "name", named = row:text "named" }
    if section.named then
      at_line(row, named.properties, section.named)
    else
      for i, key in ipairs(properties) do
        section[key] = row:number(key) or i <= 4 and row:need(key) or nil
        if section[key] and section[key] <= 0 then
          fail(row.place, "column '%s' is %g; must be above 0", key, section[key])
        end
      end
      local Zx, Zy = row:number "Zx", row:number "Zy"
      if Zx or Zy then section.plastic = { A = section.area, Zx = Zx, Zy = Zy, Zz = row:number "Zz" } end
      local width, depth = row:number "width", row:number "depth"
      if width and depth then section.size = { width = width, depth = depth } end
    end
    add(self, "sections", self.section, row, section)
  end
end

function Reader:read_materials()
  local columns = { "name", "E", "G", "nu", "density", "yield_stress" }
  for _, row in ipairs(self:rows("materials", columns, { "name", "E" })) do
    local material = { name = row:need "name", E = row:number "E" or row:need "E" }
    for i = 3, #columns do material[columns[i]] = row:number(columns[i]) end
    add(self, "materials", self.material, row, material)
  end
end

-- A section that no file has is one of hinge.section.named; a material one of hinge.material.steel.
function Reader:section_of(row)
  local name = row:need "section"
  if not self.section[name] then
    at_line(row, named.properties, name)
    add(self, "sections", self.section, row, { name = name, named = name })
  end
  return name
end

function Reader:material_of(row)
  local name = row:need "material"
  if not self.material[name] then
    local steel = at_line(row, grades.steel, name)
    add(self, "materials", self.material, row, { name = name, E = steel.E, nu = steel.nu, density = steel.density,
      yield_stress = steel.yield_stress })
  end
  return name
end

-- The direction of the section's y axis: three columns, of which all or none are given.
local function up_of(row)
  local up = { row:number "up_x", row:number "up_y", row:number "up_z" }
  local given = 0
  for i = 1, 3 do given = given + (up[i] and 1 or 0) end
  if given == 0 then return nil end
  if given < 3 then fail(row.place, "give up_x, up_y and up_z together") end
  return up
end

local function release_of(row, column)
  local text = row:text(column)
  if not text then return nil end
  if text:gsub("r[xyz]", ""):find "[^%s,;/]" then
    fail(row.place, "column '%s' is '%s'; must be rotations about the section's axes, such as rx ry", column, text)
  end
  return (text:gsub("[%s;/]+", ","))
end

function Reader:read_members()
  local columns = { "name", "a", "b", "section", "material", "up_x", "up_y", "up_z", "group", "release_a", "release_b" }
  for _, row in ipairs(self:rows("members", columns, { "name", "a", "b", "section", "material" })) do
    local a, b = find(row, "node", row:need "a", self.node), find(row, "node", row:need "b", self.node)
    local _, length = frame_module.direction(a, b)
    if not (length > 0) then fail(row.place, "member '%s' has no length", row:need "name") end
    local release = { a = release_of(row, "release_a"), b = release_of(row, "release_b") }
    add(self, "members", self.member, row, { name = row:need "name", a = a.name, b = b.name,
      section = self:section_of(row), material = self:material_of(row), up = up_of(row), group = row:text "group",
      release = next(release) and release or nil })
  end
end

local function vector(row, columns)
  local v, any = {}, false
  for i, column in ipairs(columns) do
    v[i] = row:number(column) or 0
    any = any or v[i] ~= 0
  end
  return any and v or nil
end

function Reader:case_of(row)
  local name = row:text "case" or "loads"
  if not self.case[name] then
    self.case[name] = { name = name, loads = {} }
    table.insert(self.frame.cases, self.case[name])
  end
  return self.case[name]
end

function Reader:read_loads()
  local columns = { "case", "node", "member", "fx", "fy", "fz", "mx", "my", "mz", "qx", "qy", "qz", "axes" }
  for _, row in ipairs(self:rows("loads", columns, {})) do
    local node, member, axes = row:text "node", row:text "member", row:text "axes"
    if (node == nil) == (member == nil) then fail(row.place, "give either a node or a member") end
    if node then find(row, "node", node, self.node) else find(row, "member", member, self.member) end
    local force, moment = vector(row, { "fx", "fy", "fz" }), vector(row, { "mx", "my", "mz" })
    local q = vector(row, { "qx", "qy", "qz" })
    if member and (force or moment) then fail(row.place, "a load on a member has qx, qy and qz alone") end
    if node and (q or axes) then fail(row.place, "a load on a node has fx to mz alone") end
    if axes and axes ~= "global" and axes ~= "local" and axes ~= "projected" then
      fail(row.place, "column 'axes' is '%s'; must be global, projected or local", axes)
    end
    local load = { node = node, member = member, force = force, moment = moment, q = q, axes = axes }
    self.places[load] = row.place
    local case = self:case_of(row)
    if force or moment or q then table.insert(case.loads, load) end
  end
end

function Reader:read_masses()
  for _, row in ipairs(self:rows("masses", { "node", "mass" }, { "node", "mass" })) do
    local mass = { node = find(row, "node", row:need "node", self.node).name,
      mass = row:number "mass" or row:need "mass" }
    if mass.mass <= 0 then fail(row.place, "column 'mass' is %g kg; must be above 0", mass.mass) end
    self.places[mass] = row.place
    table.insert(self.frame.masses, mass)
  end
end

local file = { "string", optional = true }

return function(options, ...)
  check.no_more(where, ...)
  local files = check.options(where, options, { nodes = { "string" }, members = { "string" }, sections = file,
    materials = file, supports = file, loads = file, masses = file })
  local self = setmetatable({ files = files, frame = frame_module.new(files.members), notes = notes.new(), places = {},
    node = {}, section = {}, material = {}, member = {}, case = {} }, Reader)
  self:read_nodes()
  self:read_sections()
  self:read_materials()
  self:read_members()
  self:read_loads()
  self:read_masses()
  return frame_module.finish(self.frame, self.notes, self.places)
end
