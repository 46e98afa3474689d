-- The rows of benchmarks as text, as results.csv and as the tables of a README.md.
local columns = require "hinge.library.columns"
local quote = require "hinge.library.quote"
local tables = {}

local function is_finite(value) return value == value and math.abs(value) < math.huge end

--- The error of a row in percent, with its sign: "+0.00012 %".
function tables.percent(value)
  if value ~= value then return "not a number" end
  if value == 0 then return "0 %" end
  if math.abs(value) < 1e-11 then return "< 1e-9 %" end -- rounding
  return ("%%+.%dg %%%%"):format(math.abs(value) < 0.0995 and 2 or 3):format(100 * value)
end

local function value_of(value, unit) return ("%.6g%s"):format(value, unit ~= "" and " " .. unit or "") end

--- All rows of a list of benchmarks, each with `of`, its benchmark. One without an answer has a row with `failure`.
function tables.rows(list)
  local rows = {}
  for _, one in ipairs(list) do
    for _, row in ipairs(one.rows) do
      row.of = one
      rows[#rows + 1] = row
    end
    if one.failure then rows[#rows + 1] = { of = one, failure = one.failure, right = false } end
  end
  return rows
end

-- The quantity, marked where its reference is not sure.
local function named(row) return row.quantity .. (row.of.unconfirmed and " (reference not confirmed)" or "") end

local function cells_of(row)
  local one = row.of
  if row.failure then
    return { one.kind or "?", one.name, "failed", "-", "-", "-", "-", "-", "-" }
  end
  return { one.kind, one.name, named(row), value_of(row.computed, row.unit), ("%.6g"):format(row.reference),
    tables.percent(row.error) .. (row.right and "" or " !"), ("%d"):format(row.elements), ("%d"):format(row.steps),
    ("%.2f"):format(row.seconds) }
end

--- The table of all rows.
function tables.text(rows)
  local lines = { { "kind", "problem", "quantity", "computed", "reference", "error", "elements", "steps", "s" } }
  for i, row in ipairs(rows) do lines[i + 1] = cells_of(row) end
  return table.concat(columns.lines(lines, { true, true, true }), "\n")
end

-- |error|; without an answer it is infinite.
local function size_of(row)
  local size = row.failure and math.huge or math.abs(row.error)
  return size == size and size or math.huge
end

--- Whether a row's error is one of a result whose reference is sure. An order of convergence, by its name, is none.
function tables.counts(row)
  local name = row.quantity or ""
  local is_order = name:find "^order%f[^%a]" or name:find("observed order", 1, true)
  return not (is_order or row.of.unconfirmed)
end

--- By kind, in the order in which they come: { kind =, rows =, wrong =, median =, largest =, worst = (row) }. Rows that
--- do not count are among rows and wrong ones alone.
function tables.by_kind(rows)
  local list = {}
  for _, row in ipairs(rows) do
    local kind = row.of.kind or "?"
    if not list[kind] then
      list[kind] = { kind = kind, sizes = {}, rows = 0, wrong = 0, largest = -1, worst = row }
      list[#list + 1] = list[kind]
    end
    local of, size = list[kind], size_of(row)
    of.rows, of.wrong = of.rows + 1, of.wrong + (row.right and 0 or 1)
    if tables.counts(row) then
      of.sizes[#of.sizes + 1] = size
      if size > of.largest then of.largest, of.worst = size, row end
    end
  end
  for _, of in ipairs(list) do
    table.sort(of.sizes)
    local n = #of.sizes
    of.median = n > 0 and (of.sizes[(n + 1) // 2] + of.sizes[n // 2 + 1]) / 2 or math.huge
    of.largest = n > 0 and of.largest or math.huge
  end
  return list
end

local function plain_percent(value) return is_finite(value) and (tables.percent(value):gsub("^%+", "")) or "none" end

local function where_worst(of)
  local row = of.worst
  return row.failure and row.of.name or ("%s: %s"):format(row.of.name, row.quantity)
end

--- The summary by kind.
function tables.summary_text(rows)
  local lines = { { "kind", "rows", "median |error|", "largest |error|", "wrong", "where the largest is" } }
  for i, of in ipairs(tables.by_kind(rows)) do
    lines[i + 1] = { of.kind, ("%d"):format(of.rows), plain_percent(of.median), plain_percent(of.largest),
      ("%d"):format(of.wrong), where_worst(of) }
  end
  return table.concat(columns.lines(lines, { true, [6] = true }), "\n")
end

--- A line for each row that is not right.
function tables.complaints(rows)
  local lines = {}
  for _, row in ipairs(rows) do
    if row.failure then lines[#lines + 1] = ("%s failed: %s"):format(row.of.name, row.failure)
    elseif not row.right then
      lines[#lines + 1] = ("%s: %s: error %s, allowed %s"):format(row.of.name, row.quantity, tables.percent(row.error),
        plain_percent(row.tolerance))
    end
  end
  return lines
end

local function csv_cell(value)
  if value == nil then return "" end
  if math.type(value) == "float" then value = ("%.10g"):format(value) end
  return type(value) == "string" and quote.csv(value, true) or tostring(value)
end

--- results.csv: a line for each row.
function tables.csv(rows)
  local names = { "kind", "problem", "title", "quantity", "computed", "reference", "unit", "error", "tolerance",
    "right", "elements", "steps", "seconds", "source", "reason", "unconfirmed" }
  local lines = { table.concat(names, ",") }
  for _, row in ipairs(rows) do
    local one, cells = row.of, {}
    local own = { kind = one.kind, problem = one.name, title = one.title, source = one.source, reason = row.failure,
      unconfirmed = one.unconfirmed or nil }
    for i, name in ipairs(names) do
      local value = own[name]
      if value == nil then value = row[name] end
      cells[i] = csv_cell(value)
    end
    lines[#lines + 1] = table.concat(cells, ",")
  end
  return table.concat(lines, "\n") .. "\n"
end

local cell = quote.markdown

local function markdown_row(row, first)
  local one = row.of
  local name = first and ("[%s](%s.lua)"):format(cell(one.title), one.name) or ""
  if row.failure then return ("| %s | **failed: %s** | | | | | | |"):format(name, cell(row.failure)) end
  local error = tables.percent(row.error)
  return ("| %s | %s | %s | %.6g | %s | %d | %d | %.2f |"):format(name, cell(named(row)),
    cell(value_of(row.computed, row.unit)), row.reference, row.right and error or "**" .. error .. "**", row.elements,
    row.steps, row.seconds)
end

-- Source, what the model leaves out, and pictures of each benchmark of a kind.
local function notes_of(list, kind, pictures)
  local lines = {}
  for _, one in ipairs(list) do
    if one.kind == kind and one.source then
      local text = ("- [%s](%s.lua): %s"):format(one.title, one.name, one.source)
      if one.missing then text = text .. ". Not in the model: " .. one.missing end
      for i, picture in ipairs(pictures[one.name] or {}) do
        text = ("%s%s[picture%s](pictures/%s)"):format(text, i == 1 and ". " or ", ", i > 1 and " " .. i or "", picture)
      end
      lines[#lines + 1] = text
    end
  end
  return table.concat(lines, "\n")
end

--- The tables of a README.md. pictures: by benchmark, the names of its pictures.
function tables.markdown(list, rows, pictures)
  local parts = { "| kind | rows | median error | largest error | where the largest is |",
    "|---|---|---|---|---|" }
  local kinds = tables.by_kind(rows)
  for _, of in ipairs(kinds) do
    parts[#parts + 1] = ("| %s | %d | %s | %s | %s |"):format(of.kind, of.rows, plain_percent(of.median),
      plain_percent(of.largest), cell(where_worst(of)))
  end
  for _, of in ipairs(kinds) do
    parts[#parts + 1] = ("\n### %s\n"):format(of.kind:gsub("^%l", string.upper))
    parts[#parts + 1] = "| problem | quantity | computed | reference | error | elements | steps | s |"
    parts[#parts + 1] = "|---|---|---|---|---|---|---|---|"
    local last
    for _, row in ipairs(rows) do
      if (row.of.kind or "?") == of.kind then
        parts[#parts + 1] = markdown_row(row, row.of ~= last)
        last = row.of
      end
    end
    parts[#parts + 1] = "\nSources:\n"
    parts[#parts + 1] = notes_of(list, of.kind, pictures)
  end
  return table.concat(parts, "\n")
end

return tables
