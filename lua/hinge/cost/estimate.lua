-- How far the finest answer may still be from the exact one: by Richardson's extrapolation where the order of
-- convergence is clear, else by how much the finest answers scatter.
local compare = require "hinge.cost.compare"

local estimate = {}
local least_order = 0.5 -- an order below it is not clear: the extrapolation would be longer than what was observed
local aligned = 0.5     -- cosine of the angle between two changes of a history that are of one kind
local shrinks = 1.4     -- a change by this factor smaller than the one before is clearly the smaller one
local careful = 3       -- safety factor where two refinements cannot show the order (Roache 1994)

-- The largest distance between any two of some answers.
local function spread(answers)
  local most = 0
  for i, a in ipairs(answers) do
    for k = 1, i - 1 do most = compare.larger(most, compare.distance(a, answers[k])) end
  end
  return most
end

--- Along one refinement: answers at step sizes h that fall, two or three of them, the finest last; `theory`: the order.
-- settled: how far the answers may differ and still pass for converged, as a part of their size.
-- Returns { by =, answer =, half =, order = }. answer: the best known one, extrapolated where the order is clear. half:
-- it may be off by so much, in the unit of the answer. by: "exact" (nothing changes), "order" (observed), "theory" (two
-- answers, a safety factor of 3), "scatter" (no clear order: the spread of the three; where the last change is clearly
-- the smaller one, at most three times that change), "grows" (changes go on in one direction and do not get smaller:
-- half is no bound), "open" (one answer alone, half is infinite).
function estimate.along(h, answers, theory, settled)
  local n = #answers
  local finest = answers[n]
  local open = { by = "open", answer = finest, half = math.huge }
  if n < 2 then return open end
  for _, a in ipairs(answers) do
    if not (compare.size(a) < math.huge) then return open end
  end
  local last = compare.distance(answers[n - 1], finest)
  local noise = 1e-9 * compare.size(finest)
  if spread(answers) <= noise then return { by = "exact", answer = finest, half = spread(answers) } end
  local function missing(order) return last / ((h[n - 1] / h[n]) ^ order - 1) end
  if n == 2 then return { by = "theory", answer = finest, half = careful * missing(theory) } end
  local order = compare.order(h, answers)
  if order == math.huge then order = nil end
  local one_way = compare.going_on(table.unpack(answers)) > aligned
  if one_way and order and order >= least_order then
    local part = 1 / ((h[2] / h[3]) ^ order - 1)
    local better = compare.combined(function(b, c) return c + part * (c - b) end, answers[2], finest)
    if better then
      return { by = "order", answer = better, half = missing(math.min(order, theory)), order = order }
    end
  end
  local half = spread(answers)
  if not (half < math.huge) then return open end
  if last * shrinks <= compare.distance(answers[1], answers[2]) then
    return { by = "scatter", answer = finest, half = math.min(half, careful * last) }
  end
  local grows = one_way and half > settled * compare.size(finest)
  return { by = grows and "grows" or "scatter", answer = finest, half = half }
end

local ranks = { exact = 1, order = 2, theory = 3, scatter = 4, grows = 5, open = 6 }

--- What several refinements, one of each number, leave together: the extrapolations and the bands add up. finest: the
-- answer from which they all come.
function estimate.together(finest, parts)
  local all = { by = "exact", answer = finest, half = 0 }
  for _, part in ipairs(parts) do
    if ranks[part.by] > ranks[all.by] then all.by, all.order = part.by, part.order end
    all.half = all.half + part.half
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
  local half = size > 0 and found.half / size or found.half > 0 and math.huge or 0
  if found.by == "open" or found.by == "grows" then
    local least = compare.larger(error, found.by == "grows" and half or 0)
    return { difference = compare.error(answer, finest), error = least, low = least, high = math.huge }
  end
  return { difference = compare.error(answer, finest), error = error, low = math.max(0, error - half),
    high = error + half }
end

return estimate
