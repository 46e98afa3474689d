-- What the laws of sections cost: a scenario is run with another law in the place of one, or without one.
local compare = require "hinge.cost.compare"

local laws = {}

--- What is run in place of the scenario as it is, by the name of the law that is left out (core.optional_laws).
function laws.change(name)
  return name == "eq 14" and "exact in the place of eq 14"
    or name == "exact" and "eq 14 in the place of exact"
    or "without " .. name
end

-- Median of the time over that of the scenario as it is, less 1, round by round, and half the width of the middle half.
local function slower(all, other)
  local parts = {}
  for i = 1, math.min(#all, #other) do parts[i] = other[i] / all[i] - 1 end
  table.sort(parts)
  local n = #parts
  return compare.median(parts), (parts[n - (n - 1) // 4] - parts[1 + (n - 1) // 4]) / 2
end

--- Makes a row of the effects' comparison one of laws: the time is that with the change.
function laws.row(row, all)
  row.law, row.name = row.name, laws.change(row.name)
  row.saves, row.spread = nil, nil
  if not row.failed then row.slower, row.spread = slower(all.record.seconds, row.times) end
  return row
end

return laws
