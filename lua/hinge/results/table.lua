-- A table of results. It keeps its rows in SI units, and shows them as text, CSV, Markdown or LaTeX in the units that
-- are asked for.
--
-- A column is { key =, head =, kind = }: the field of a row, the words above it, and what its numbers are: "force",
-- "moment", "length", "displacement", "time", "number" (without a unit), "whole" or "text". `place` and `when` are
-- fields of the row that stand in the same cell, and have columns of their own in CSV files. `minor`: in these files
-- alone.
local core = require "hinge.core"
local check = require "hinge.library.check"
local in_columns = require "hinge.library.columns".lines
local output = require "hinge.library.output"
local units = require "hinge.results.units"
local quote = require "hinge.library.quote"

local Table = {}

local shown_as = {
  top = { "number", whole = true, above = 0, optional = true }, units = { "string", optional = true },
  sort = { "string", optional = true }, columns = { "table", optional = true },
}

-- Columns, rows and units of one output ------------------------------------------------------------------------------

local function unit_of(column, set) return set[column.kind] end

local function keys_of(columns)
  local keys = {}
  for i, column in ipairs(columns) do keys[i] = column.key end
  return keys
end

local function column_of(columns, key)
  for _, column in ipairs(columns) do
    if column.key == key then return column end
  end
end

-- The columns that are asked for, in their order; without a choice those that are not minor.
local function chosen_columns(where, columns, wanted, all)
  local list = {}
  for i, key in ipairs(wanted or {}) do
    list[i] = column_of(columns, key) or check.unknown(where .. ": field 'columns'", "column", key, keys_of(columns))
  end
  if wanted then return list end
  for _, column in ipairs(columns) do
    if all or not column.minor then list[#list + 1] = column end
  end
  return list
end

-- Numbers by their size, the largest first; texts by the alphabet; rows without a value last.
local function before(a, b)
  if type(a) == "number" and type(b) == "number" then return math.abs(a) > math.abs(b) end
  if a == nil or b == nil then return a ~= nil and b == nil end
  return tostring(a) < tostring(b)
end

-- Rows in order. Rows that are equal keep the order that they have.
local function sorted(rows, key)
  local list, place = table.move(rows, 1, #rows, 1, {}), {}
  if not key then return list end
  for i, row in ipairs(list) do place[row] = i end
  table.sort(list, function(a, b)
    if before(a[key], b[key]) then return true end
    if before(b[key], a[key]) then return false end
    return place[a] < place[b]
  end)
  return list
end

local function view(self, where, options, all)
  local o = check.options(where, options, shown_as)
  local columns = self:all_columns()
  if o.sort and not column_of(columns, o.sort) and not (self.sort_keys or {})[o.sort] then
    check.unknown(where .. ": field 'sort'", "column", o.sort, keys_of(columns))
  end
  local rows = sorted(self.rows, o.sort or self.order)
  local left_out = o.top and #rows > o.top and #rows - o.top or 0
  return { columns = chosen_columns(where, columns, o.columns, all), left_out = left_out,
    rows = table.move(rows, 1, o.top and math.min(o.top, #rows) or #rows, 1, {}),
    units = units.read(where, o.units or self.units) }
end

-- Cells ---------------------------------------------------------------------------------------------------------------

-- Digits behind the point with which the largest number has four digits.
local function decimals_of(largest)
  if not (largest > 0) or largest == math.huge then return 1 end
  return math.max(0, math.min(9, 3 - math.floor(math.log(largest, 10) + 1e-9)))
end

local function plain(value, decimals)
  if value ~= value then return "nan" end
  local text = ("%%.%df"):format(decimals):format(value)
  return text:find "^%-0%.?0*$" and text:sub(2) or text
end

-- The largest number of a field.
local function largest_of(rows, key)
  local largest = 0
  for _, row in ipairs(rows) do
    local v = row[key]
    if type(v) == "number" and math.abs(v) < math.huge then largest = math.max(largest, math.abs(v)) end
  end
  return largest
end

-- A function that shows the numbers of a field with as many digits as suit the largest of them. `most`: at most so many
-- behind the point.
local function shower(rows, key, unit, decimals, most)
  local factor = unit and unit.factor or 1
  decimals = decimals or math.min(most or 9, decimals_of(factor * largest_of(rows, key)))
  return function(value)
    if math.type(value) == "integer" and not unit then return tostring(value) end
    return type(value) == "number" and plain(factor * value, decimals) or value and tostring(value)
  end
end

-- The time of a cell, or the name of a case.
local function when_text(value, set)
  if type(value) ~= "number" then return tostring(value) end
  return ("%.4g %s"):format(value * set.time.factor, set.time.name)
end

-- Digits behind the point that columns of each kind have at most: two more than its largest number takes, so that
-- rounding errors are shown as zeros.
local function most_decimals(v)
  local most = {}
  for _, column in ipairs(v.columns) do
    local unit = unit_of(column, v.units)
    if unit then
      local own = decimals_of(unit.factor * largest_of(v.rows, column.key))
      most[column.kind] = math.min(most[column.kind] or 9, 2 + own)
    end
  end
  return most
end

-- A function of a row: the text of its cell in a column, or nil for none.
local function cell_of(column, rows, set, most)
  local show = shower(rows, column.key, unit_of(column, set), column.decimals, most)
  local place = column.place and shower(rows, column.place, set.length)
  return function(row)
    local value = row[column.key]
    if value == nil then return nil end
    if column.kind == "text" and column.key == "when" then return when_text(value, set) end
    local text = show(value)
    if place and row[column.place] then text = text .. " at " .. place(row[column.place]) end
    if column.when and row[column.when] then text = text .. ", " .. when_text(row[column.when], set) end
    return text
  end
end

local function head_of(column, set)
  local unit = unit_of(column, set)
  local text = column.head .. (unit and ", " .. unit.name or "")
  return column.place and text .. " (at x, " .. set.length.name .. ")" or text
end

-- All cells of an output as texts; "-" where there is nothing.
local function cells(v)
  local head, body, most = {}, {}, most_decimals(v)
  for k, column in ipairs(v.columns) do
    local cell = cell_of(column, v.rows, v.units, most[column.kind])
    head[k] = head_of(column, v.units)
    for i, row in ipairs(v.rows) do
      body[i] = body[i] or {}
      body[i][k] = cell(row) or "-"
    end
  end
  return head, body
end

local function is_text(column) return column.kind == "text" end

-- Output --------------------------------------------------------------------------------------------------------------

local function remarks(self, v)
  local list = table.move(self.notes, 1, #self.notes, 1, {})
  if v.left_out > 0 then list[#list + 1] = ("%s more"):format(check.count(v.left_out, "row")) end
  return list
end

--- The table as aligned text, with its title above it and its remarks below.
function Table:text(options, ...)
  check.no_more("table:text", ...)
  local v = view(self, "table:text", options)
  local head, body = cells(v)
  local left = {}
  for k, column in ipairs(v.columns) do left[k] = is_text(column) end
  local lines = in_columns({ head, table.unpack(body) }, left, "  ")
  if self.title then table.insert(lines, 1, self.title) end
  for _, text in ipairs(remarks(self, v)) do lines[#lines + 1] = text end
  return table.concat(lines, "\n")
end

--- The table in Markdown.
function Table:markdown(options, ...)
  check.no_more("table:markdown", ...)
  local v = view(self, "table:markdown", options)
  local head, body = cells(v)
  local rules, lines = {}, {}
  for k, column in ipairs(v.columns) do rules[k] = is_text(column) and "---" or "---:" end
  local function line(row)
    local safe = {}
    for k, text in ipairs(row) do safe[k] = quote.markdown(text) end
    lines[#lines + 1] = "| " .. table.concat(safe, " | ") .. " |"
  end
  line(head)
  lines[2] = "|" .. table.concat(rules, "|") .. "|"
  for _, row in ipairs(body) do line(row) end
  for _, text in ipairs(remarks(self, v)) do lines[#lines + 1] = "\n" .. text end
  return table.concat(lines, "\n") .. "\n"
end

--- The table as a tabular of LaTeX; units stand in its head.
function Table:latex(options, ...)
  check.no_more("table:latex", ...)
  local v = view(self, "table:latex", options)
  local head, body = cells(v)
  local sides, lines = {}, {}
  for k, column in ipairs(v.columns) do sides[k] = is_text(column) and "l" or "r" end
  local function line(row)
    local safe = {}
    for k, text in ipairs(row) do safe[k] = text == "-" and "--" or quote.latex(text) end
    lines[#lines + 1] = "  " .. table.concat(safe, " & ") .. " \\\\"
  end
  lines[1] = "\\begin{tabular}{" .. table.concat(sides) .. "}"
  lines[2] = "  \\hline"
  line(head)
  lines[4] = "  \\hline"
  for _, row in ipairs(body) do line(row) end
  lines[#lines + 1] = "  \\hline"
  lines[#lines + 1] = "\\end{tabular}"
  for _, text in ipairs(remarks(self, v)) do lines[#lines + 1] = "% " .. text end
  return table.concat(lines, "\n") .. "\n"
end

-- The fields of a CSV file: each column, and its place and time as columns of their own.
local function fields_of(v)
  local list = {}
  local function add(key, unit) list[#list + 1] = { key = key, unit = unit } end
  for _, column in ipairs(v.columns) do
    add(column.key, unit_of(column, v.units))
    if column.place then add(column.place, v.units.length) end
    if column.when then add(column.when, v.units.time) end
  end
  return list
end

--- Writes the table as a CSV file into the output folder. Heads are the names of fields, with their units.
function Table:csv(filename, options, ...)
  local where = "table:csv"
  check.no_more(where, ...)
  local path = output.path(output.name(where, filename, "csv"))
  local v = view(self, where, options, true)
  local fields, head = fields_of(v), {}
  for i, field in ipairs(fields) do
    head[i] = ('"%s"'):format(field.unit and ("%s (%s)"):format(field.key, field.unit.name) or field.key)
  end
  local lines = { table.concat(head, ",") }
  for _, row in ipairs(v.rows) do
    local list = {}
    for i, field in ipairs(fields) do list[i] = output.field(row[field.key], field.unit and field.unit.factor) end
    lines[#lines + 1] = table.concat(list, ",")
  end
  if not core.planning() then core.write_text(path, table.concat(lines, "\n") .. "\n") end
  return self
end

-- Classes of tables ---------------------------------------------------------------------------------------------------

function Table:all_columns() return self.columns end

--- The column of remarks, which is shown where a row has one.
function Table.remarks(rows)
  local column = { key = "remark", head = "remark", kind = "text", minor = true }
  for _, row in ipairs(rows) do
    if row.remark then column.minor = false end
  end
  return column
end

--- Draws a plot of hinge.plot into the output folder: by a job, or by the script's own output.
function Table.draw(where, plot, job, filename)
  if filename == nil and type(job) == "string" then job, filename = nil, job end
  check.value(where, "filename", filename, { "string" })
  if job ~= nil and type(job) ~= "table" then
    check.fail("%s: the job is %s; call it as table:plot(filename, options) or table:plot(job, filename, options)",
      where, check.show(job))
  end
  if job then job:plot(plot, filename) else require "hinge.program.job".free.plot(plot, filename) end
end

--- The arguments of a method plot: (filename, options) or (job, filename, options).
function Table.plot_arguments(where, job, ...)
  if type(job) == "string" then
    check.no_more(where, select(2, ...))
    return nil, job, (...)
  end
  check.no_more(where, select(3, ...))
  return job, ...
end

local classes = {} -- metatables by the table of methods

--- The methods of a class of tables, to which more can be added.
function Table.class(name)
  local methods = setmetatable({}, { __index = Table })
  classes[methods] = check.class(methods, name)
  classes[methods].__tostring = function(self) return self:text() end
  return methods
end

function Table.is(value, class) return getmetatable(value) == classes[class] end

--- A table of a class: { columns =, rows =, title =, notes =, units =, order = the field by which rows are sorted }.
function Table.new(class, fields)
  fields.rows, fields.notes = fields.rows or {}, fields.notes or {}
  return setmetatable(fields, classes[class])
end

return Table
