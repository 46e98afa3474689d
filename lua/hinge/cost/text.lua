-- Numbers and cells as text, for the reports of hinge cost.
local text = {}

function text.percent(part)
  if part == nil then return "-" end
  if part == math.huge then return "none" end
  if math.abs(part) < 1e-12 then return "0 %" end
  return ("%.3g %%"):format(100 * part)
end

function text.bytes(n) return n and ("%.1f MB"):format(n / 1e6) or "-" end

--- The keys of a map.
function text.sorted(map, before)
  local names = {}
  for name in pairs(map) do names[#names + 1] = name end
  table.sort(names, before)
  return names
end

local function quoted(cell) return cell:find '[,"\n]' and '"' .. cell:gsub('"', '""'):gsub("\n", " ") .. '"' or cell end

function text.csv_line(cells)
  local parts = {}
  for i, cell in ipairs(cells) do parts[i] = quoted(tostring(cell)) end
  return table.concat(parts, ",")
end

return text
