-- Answers that scatter: when they are chaotic, means with their 95 % bands, and means that differ by more than chance.
local compare = require "hinge.cost.compare"

local statistics = {}

-- Student's t, 95 %, two-sided; by the number of values beyond those that give the means, from 1 to 10.
local students = { 12.71, 4.303, 3.182, 2.776, 2.571, 2.447, 2.365, 2.306, 2.262, 2.228 }
local function student(degrees)
  local n = math.floor(degrees)
  return n >= #students and students[#students] or students[math.max(1, n)]
end

--- An answer is chaotic if it changes by more than this part of it where physical numbers change by 1e-9: the change
-- has grown a thousandfold. Answers of structures near their limits grow a hundredfold, and Newton's method leaves 1e-9
-- to 1e-7.
statistics.least_scatter = 1e-6
-- Scatter below this part of the accepted error is told with the error, and needs no mean.
local no_matter = 1 / 10

--- Whether a scatter, a part of an answer, makes it chaotic where an error of `within` is accepted.
function statistics.is_chaotic(spread, within)
  return not (spread <= math.max(statistics.least_scatter, no_matter * within))
end

--- Mean, standard deviation and number of some answers; histories point by point, their deviation as a root mean
--- square. nil for fewer than two of them, or if they do not go together.
function statistics.mean(answers)
  local n = #answers
  if n < 2 then return nil end
  local mean = compare.combined(function(...)
    local sum = 0
    for i = 1, n do sum = sum + (select(i, ...)) end
    return sum / n
  end, table.unpack(answers))
  if not mean then return nil end
  local sum = 0
  for _, a in ipairs(answers) do sum = sum + compare.distance(mean, a) ^ 2 end
  return mean, math.sqrt(sum / (n - 1)), n
end

--- Half of the 95 % band of a mean: Student's t times the standard deviation of the mean.
function statistics.band(deviation, runs) return student(runs - 1) * deviation / math.sqrt(runs) end

--- Whether two means differ by more than their scatter explains. a, b: { mean =, deviation =, runs = }.
function statistics.apart(a, b)
  local va, vb = a.deviation ^ 2 / a.runs, b.deviation ^ 2 / b.runs
  local difference = compare.distance(a.mean, b.mean)
  if va + vb == 0 then return difference > 1e-9 * compare.size(a.mean) end
  local degrees = (va + vb) ^ 2 / (va ^ 2 / (a.runs - 1) + vb ^ 2 / (b.runs - 1))
  return not (difference <= student(degrees) * math.sqrt(va + vb))
end

return statistics
