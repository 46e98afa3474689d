-- How far the finest answer of several refinements may still be from the exact one, and the errors of other answers
-- against it. What one refinement shows is in lua/hinge/accuracy/estimate.lua.
local compare = require "hinge.cost.compare"

local estimate = {}

local ranks = { exact = 1, order = 2, change = 3, grows = 4, open = 5 }

--- What several refinements, one of each number, leave together: the extrapolations and the errors add up. finest: the
-- answer from which they all come. Returns what hinge.accuracy.estimate does.
function estimate.together(finest, parts)
  local all = { by = "exact", answer = finest, error = 0 }
  for _, part in ipairs(parts) do
    if ranks[part.by] > ranks[all.by] then all.by, all.order = part.by, part.order end
    all.error = all.error + part.error
    all.answer = compare.combined(function(sum, own, base) return sum + own - base end, all.answer, part.answer, finest)
      or all.answer
  end
  return all
end

--- The error of an answer against an estimate: { difference = from the finest, error =, low =, high = }, as parts of
-- the size of the best known answer.
function estimate.error(answer, found, finest)
  local error = compare.error(answer, found.answer)
  local size = compare.size(found.answer)
  local half = size > 0 and found.error / size or found.error > 0 and math.huge or 0
  if half == math.huge then
    return { difference = compare.error(answer, finest), error = error, low = error, high = math.huge }
  end
  return { difference = compare.error(answer, finest), error = error, low = math.max(0, error - half),
    high = error + half }
end

return estimate
