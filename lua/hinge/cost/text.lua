-- Numbers and cells as text, for the reports of hinge cost.
local quote = require "hinge.library.quote"
local text = {}

function text.percent(part)
  if part == nil then return "-" end
  if part == math.huge then return "none" end
  if math.abs(part) < 1e-12 then return "0 %" end
  return ("%.3g %%"):format(100 * part)
end

--- A number with six digits, as short as it can be written.
function text.number(value) return ("%.6g"):format(value) end

--- The error of a setting: "< 1 %" where it is nearer than the finest run is known, "> 1 %" where only that is known.
function text.error(s)
  if s.above and s.error <= 1e-12 then return "unknown" end
  return (s.below and s.error > 1e-12 and "< " or s.above and "> " or "") .. text.percent(s.error)
end

--- The band of an error: "0.1 to 0.2 %".
function text.band(s)
  if not s.high then return "-" end
  if s.high == math.huge then return "unknown" end
  if s.high < 1e-12 then return "exact" end
  return ("%s to %s"):format(s.low < 1e-12 and "0" or ("%.3g"):format(100 * s.low), text.percent(s.high))
end

function text.bytes(n) return n and ("%.1f MB"):format(n / 1e6) or "-" end

--- The keys of a map.
function text.sorted(map, before)
  local names = {}
  for name in pairs(map) do names[#names + 1] = name end
  table.sort(names, before)
  return names
end

function text.csv_line(cells)
  local parts = {}
  for i, cell in ipairs(cells) do parts[i] = type(cell) == "string" and quote.csv(cell, true) or tostring(cell) end
  return table.concat(parts, ",")
end

return text
