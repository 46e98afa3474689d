-- Rows of tables of SAP2000: fields by name, as text, numbers or yes and no.
local notes = require "hinge.import.notes"

local row = {}

local Row = {}
Row.__index = Row

--- Raises an error at the line of a row.
function row.fail(of, ...) notes.fail(of.where, of.place, ...) end

--- The text of a field, or nil where it is left out.
function Row:text(key)
  self.used[key] = true
  return self.fields[key]
end

function Row:need(key)
  local value = self:text(key)
  if value == nil then row.fail(self, "%s: the row has no field %s", self.table, key) end
  return value
end

--- A field as a number; `default` where it is left out.
function Row:number(key, default)
  local value = self:text(key)
  if value == nil and default ~= nil then return default end
  value = value or self:need(key)
  local x = tonumber(value)
  if not x or x ~= x or math.abs(x) == math.huge then
    row.fail(self, "%s: field %s is '%s'; must be a number", self.table, key, value)
  end
  return x
end

function Row:yes(key) return (self:text(key) or "No"):lower() == "yes" end

--- An empty row. `where`: the call, for messages; `title`: its table as messages name it; `place`: { file =, line = };
--- `line`: its text in the file.
function row.new(where, title, place, line)
  return setmetatable({ fields = {}, used = {}, where = where, place = place, table = title, line = line }, Row)
end

return row
