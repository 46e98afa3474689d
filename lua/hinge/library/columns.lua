-- Tables as text: cells in columns, which are as wide as their widest cell. Widths are in letters, not in bytes.
local columns = {}

local function letters(text) return utf8.len(text) or #text end

--- Rows of cells, numbers or texts, as a list of lines with two blanks between the columns. left: the numbers of the
-- columns that are set to the left, { true } by default, the first one, or "all"; the others are set to the right.
-- before: the text before each line, nothing by default. Lines end in no blanks.
function columns.lines(rows, left, before)
  left = left or { true }
  local widths, lines = {}, {}
  for _, row in ipairs(rows) do
    for i, cell in ipairs(row) do widths[i] = math.max(widths[i] or 0, letters(tostring(cell))) end
  end
  for k, row in ipairs(rows) do
    local parts = {}
    for i, cell in ipairs(row) do
      local text = tostring(cell)
      local blanks = (" "):rep(widths[i] - letters(text))
      parts[i] = (left == "all" or left[i]) and text .. blanks or blanks .. text
    end
    lines[k] = ((before or "") .. table.concat(parts, "  ")):gsub(" +$", "")
  end
  return lines
end

--- Prints a table below its title and an empty line. The first column is set to the left.
function columns.print(title, head, rows)
  print("\n" .. title .. "\n" .. table.concat(columns.lines({ head, table.unpack(rows) }, nil, "  "), "\n"))
end

return columns
