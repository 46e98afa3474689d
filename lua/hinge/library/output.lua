-- Files in the output folder: plain names, places, and rows as CSV.
local core = require "hinge.core"
local check = require "hinge.library.check"
local quote = require "hinge.library.quote"

local output = {}

--- A plain name with one of these endings; others are refused.
function output.name(where, filename, ...)
  local ending = check.value(where, "filename", filename, { "string" }):match "^[%w._ -]+%.(%l+)$"
  for _, allowed in ipairs { ... } do
    if ending == allowed then return filename end
  end
  check.fail("%s: filename is '%s'; must be a plain name ending in .%s (it goes into the output folder)", where,
    filename, table.concat({ ... }, " or ."))
end

--- The path of a file in a folder; default: the output folder.
function output.path(filename, folder)
  folder = folder or core.out_dir()
  return (folder == "" or folder == ".") and filename or folder .. "/" .. filename
end

--- A value as a field of a CSV file. What has an index, such as a node, is told by it; factor: of numbers.
function output.field(value, factor)
  if value == nil then return "" end
  if type(value) == "string" then return quote.csv(value) end
  if type(value) == "userdata" then return tostring(value.index) end
  if type(value) == "boolean" then return value and "1" or "0" end
  if math.type(value) == "integer" and not factor then return tostring(value) end
  return ("%.9g"):format(value * (factor or 1))
end

--- Rows as the text of a CSV file; its columns are fields of the rows.
function output.csv(columns, rows)
  local lines = { table.concat(columns, ",") }
  for _, row in ipairs(rows) do
    local fields = {}
    for i, name in ipairs(columns) do fields[i] = output.field(row[name]) end
    lines[#lines + 1] = table.concat(fields, ",")
  end
  return table.concat(lines, "\n") .. "\n"
end

return output
