-- How far an answer may still be from the exact one, from its values at settings that get finer.
--
-- Where three values show an order of convergence, the error is the rest of the series (Richardson). Where they do not,
-- the largest change counts, over what a refinement leaves in theory, with a factor of safety of 3; of two values, the
-- change itself with that factor. This is the grid convergence index of Roache (P. J. Roache, Perspective: a method for
-- uniform reporting of grid refinement studies, Journal of Fluids Engineering 116, 1994, pp. 405-413). Three values
-- with an order near the theory's have the factor 1.25 of the same index. An order that is lower may be seen by chance,
-- or may fall further: it has the factor 3 (W. L. Oberkampf and C. J. Roy, Verification and Validation in Scientific
-- Computing, 2010, section 8.6), or 2 where two triples of four values show one.
local compare = require "hinge.cost.compare"

local estimate = {}

--- The rest of a series of the second order with halved steps, over its last change, with that change.
estimate.rest_of_second_order = 4 / 3
--- Roache's factor of safety without an observed order.
estimate.careful = 3

local least_order = 0.5  -- below it the rest of the series would be longer than what was seen
local beyond_theory = 0.5 -- an order that is higher than the theory by more is chance
local careful = estimate.careful
local usual = 1.25       -- and with one that is near the theory
local repeated = 2       -- and with a lower one that is seen twice
local near = 0.75        -- of the order in theory
local aligned = 0.5      -- cosine of the angle between two changes of a history that are of one kind
local rounding = 1e-9    -- of an answer: changes that are smaller say nothing

local function rest(change, ratio, order) return change / (ratio ^ order - 1) end

-- The largest change between neighbours, each reduced to the last refinement by this order: two values that agree by
-- chance do not hide a change before them.
local function largest_change(h, answers, order)
  local n, most = #answers, 0
  for i = 2, n do
    local change = compare.distance(answers[i], answers[i - 1])
    most = compare.larger(most, change * (h[n] / h[i]) ^ order)
  end
  return most
end

-- The order that the three values up to the n-th show; nil for none.
local function order_of(h, answers, n)
  return compare.order({ h[n - 2], h[n - 1], h[n] }, { answers[n - 2], answers[n - 1], answers[n] })
end

-- Whether the theory explains an order.
local function is_explained(order, theory)
  return order ~= nil and order >= least_order and order <= theory + beyond_theory
end

--- Along one refinement: answers at step sizes h that fall, the finest last; `theory`: the order in theory; `accepted`:
-- how far an answer may change and still pass for settled, as a part of it (default: 0). `twice`: of four values the
-- first three must show an order, too.
-- Returns { by =, error =, order =, answer = }. error: of the finest answer, in its unit. by: "exact" (no change),
-- "order" (three values show one), "change" (they do not, or there are two: the largest change with a factor of
-- safety), "grows" (three values change in one direction, by no less each time: the error is infinite), "open" (one
-- value, or one that is not a number: infinite). answer: the best known one, which
-- is extrapolated where an order is seen, else the finest.
function estimate.along(h, answers, theory, accepted, twice)
  local n = #answers
  local finest = answers[n]
  for _, a in ipairs(answers) do
    if not (compare.size(a) < math.huge) then n = 0 end
  end
  if n < 2 then return { by = "open", error = math.huge, answer = finest } end
  local ratio = h[n - 1] / h[n]
  local largest = largest_change(h, answers, math.min(1, theory)) -- nothing shows more than the first order yet
  local most = 0
  for i = 1, n - 1 do most = compare.larger(most, compare.distance(answers[i], finest)) end
  if not (most > rounding * compare.size(finest)) then return { by = "exact", error = most, answer = finest } end
  if n >= 3 then
    local last = { answers[n - 2], answers[n - 1], finest }
    local order = order_of(h, answers, n)
    local one_way = compare.going_on(table.unpack(last)) > aligned
    local change = compare.distance(last[2], finest)
    local seen_twice = n >= 4 and is_explained(order_of(h, answers, n - 1), theory)
    if one_way and is_explained(order, theory) and (seen_twice or n < 4 or not twice) then
      local part = 1 / (ratio ^ order - 1)
      local better = compare.combined(function(b, c) return c + part * (c - b) end, last[2], finest)
      local safety = order >= near * theory and usual or seen_twice and repeated or careful
      return { by = "order", order = order, answer = better or finest,
        error = safety * rest(change, ratio, math.min(order, theory)) }
    end
    if one_way and order and order < least_order then -- so slow that the rest counts as that of the least order
      return { by = "change", error = compare.larger(usual * rest(change, ratio, least_order),
        careful * rest(largest, ratio, theory)), answer = finest }
    end
    if one_way and not order and not (change <= (accepted or 0) * compare.size(finest)) then
      return { by = "grows", error = math.huge, answer = finest }
    end
  end
  -- nothing shows that two values follow the theory: their change counts in full, as of the first order
  return { by = "change", error = n == 2 and careful * largest or careful * rest(largest, ratio, theory),
    answer = finest }
end

return estimate
