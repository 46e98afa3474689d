-- import.s2k: a frame from text tables of SAP2000 and ETABS (.s2k, .$2k): TABLE: "NAME", then rows of Key=Value.
local check = require "hinge.library.check"
local notes = require "hinge.import.notes"
local rows = require "hinge.import.sap2000.row"
local sap_frame = require "hinge.import.sap2000.frame"
local sheets = require "hinge.import.sap2000.sheets"

local where = "hinge.import.s2k"

-- Whether a value in quotes goes on in the next line. It ends at the latest before the next table.
local function is_open(text)
  return text:gsub('="[^"]*"', ""):find('="', 1, true) ~= nil or text:find "\n%s*TABLE:" ~= nil
end

-- The fields of a line: Key=Value, values with blanks in quotes. Adds them to the row.
local function take_fields(row, place, line)
  local at = 1
  while true do
    at = line:find("%S", at)
    if not at then return end
    local key, after = line:match("^([^%s=\"]+)=()", at)
    if not key then
      if not line:find("^_%f[%s\0]", at) then
        notes.fail(where, place, "%s: '%s' is not of the form Key=Value", row.table, line:sub(at, at + 30))
      end
      at = at + 1
    else
      local value, stop = line:match('^"([^"]*)"()', after)
      if not value then
        if line:find('^"', after) then notes.fail(where, place, "field %s: the quotes are not closed", key) end
        value, stop = line:match("^(%S*)()", after)
        local apart, its_end = line:match("^%s+([^%s=]+)()%f[%s\0]", after) -- Key= Value
        if value == "" and apart and apart ~= "_" then value, stop = apart, its_end end
      end
      row.fields[key], at = value, stop
    end
  end
end

-- All tables of the file by name: { name =, place =, rows = }, and in their order.
local function tables_of(path)
  local tables, current, row = {}, nil, nil
  local others = {} -- lines that stand before the tables
  local function must_be_whole()
    if not row then return end
    notes.fail(where, row.place, "%s: the row has _ at its end, and no line of it follows", row.table)
  end
  for number, line in notes.lines(notes.read(where, path), is_open) do
    local place = { file = path, line = number }
    local name = line:match '^%s*TABLE:%s*"([^"]*)"%s*$'
    if line:find "^%s*END TABLE DATA" then break end
    if line:find "^%s*TABLE:" then
      if not name then notes.fail(where, place, "the name of the table is not in quotes: %s", line) end
      must_be_whole()
      name = name:upper()
      if not tables[name] then
        tables[name] = { name = name, place = place, rows = {} }
        tables[#tables + 1] = tables[name]
      end
      current = tables[name]
    elseif line:find "%S" then
      local text, goes_on = line:match "^(.-)%s_%s*$", true
      if not text then text, goes_on = line, false end
      if current then
        row = row or rows.new(where, ('TABLE "%s"'):format(current.name), place, line)
        take_fields(row, place, text)
        if not goes_on then table.insert(current.rows, row) end
      else
        others[#others + 1] = { place = place, line = line }
      end
      if not goes_on then row = nil end
    end
  end
  must_be_whole()
  return tables, others
end

return function(options, ...)
  check.no_more(where, ...)
  local o = check.options(where, options, { file = { "string" }, sections = { "table", optional = true },
    slabs = sheets.rule })
  local tables, others = notes.within_limits(where, o.file, function() return tables_of(o.file) end)
  return sap_frame.read(where, o.file, tables, others, "SAP2000", o.sections, o.slabs)
end
