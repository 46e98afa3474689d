-- Chaotic answers: mean and scatter of each setting over a few runs that are changed slightly, and the settings whose
-- means cannot be told apart (Welch's test, 95 %).
local compare = require "hinge.cost.compare"

local scatter = {}

-- Student's t, 95 %, two-sided; by the number of values beyond those that give the means, from 1 to 10.
local students = { 12.71, 4.303, 3.182, 2.776, 2.571, 2.447, 2.365, 2.306, 2.262, 2.228 }
local function student(degrees)
  local n = math.floor(degrees)
  return n >= #students and students[#students] or students[math.max(1, n)]
end

--- The answer of that name of a setting's runs, the unchanged one first.
local function answers_of(s, name)
  local all = { s.record.answers[name] }
  for _, record in ipairs(s.varied or {}) do
    if record.answers[name] ~= nil then all[#all + 1] = record.answers[name] end
  end
  return all
end

--- Mean, standard deviation and number of some answers; histories point by point, their deviation as a root mean
--- square. nil for fewer than two of them, or if they do not go together.
function scatter.mean(answers)
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
function scatter.band(deviation, runs) return student(runs - 1) * deviation / math.sqrt(runs) end

--- Whether two means differ by more than their scatter explains. a, b: { mean =, deviation =, runs = }.
function scatter.apart(a, b)
  local va, vb = a.deviation ^ 2 / a.runs, b.deviation ^ 2 / b.runs
  local difference = compare.distance(a.mean, b.mean)
  if va + vb == 0 then return difference > 1e-9 * compare.size(a.mean) end
  local degrees = (va + vb) ^ 2 / (va ^ 2 / (a.runs - 1) + vb ^ 2 / (b.runs - 1))
  return not (difference <= student(degrees) * math.sqrt(va + vb))
end

-- Mean and scatter of an answer of each setting.
local function means(compared, name)
  local all = {}
  for _, s in ipairs(compared) do
    local mean, deviation, runs = scatter.mean(answers_of(s, name))
    if mean then all[s] = { mean = mean, deviation = deviation, runs = runs } end
  end
  return all
end

local function calls(q) return q.state == "chaotic" or q.state == "unsettled" end

local function any(quantities, chosen, f)
  for name, q in pairs(quantities) do
    if f(q) and (not chosen or chosen == name) then return true end
  end
  return false
end

--- Whether an answer, if one is chosen this one, calls for runs that are changed slightly: it is chaotic, or two
--- references differ by more than is accepted.
function scatter.called(quantities, chosen) return any(quantities, chosen, calls) end

--- Whether there is a chaotic answer, or the chosen one is chaotic.
function scatter.chaotic(quantities, chosen)
  return any(quantities, chosen, function(q) return q.state == "chaotic" end)
end

-- The setting to which the others are compared: the one with the most work of those whose runs were changed.
local function standard(all)
  local best
  for s in pairs(all) do
    if not best or s.weight > best.weight or s.weight == best.weight and s.place < best.place then best = s end
  end
  return best
end

-- Puts mean and scatter of a chaotic answer into the settings, and into the answer those like the standard one.
local function compare_means(compared, name, q, all, base)
  q.alike, q.standard = {}, base.label
  for _, s in ipairs(compared) do
    local m = all[s]
    if m then
      local size = compare.size(m.mean)
      local different = s ~= base and scatter.apart(m, all[base])
      s.means = s.means or {}
      s.means[name] = { mean = type(m.mean) == "number" and m.mean or nil, runs = m.runs,
        scatter = size > 0 and m.deviation / size or m.deviation > 0 and math.huge or 0, apart = different,
        difference = compare.error(m.mean, all[base].mean) }
      if not different then q.alike[#q.alike + 1] = s.label end
    end
  end
end

--- Puts `means` by answer into each setting whose runs were changed. An answer on which the references differ is
--- chaotic if two runs of one setting may differ as much (95 %). If they do not, the scatter widens its band.
function scatter.settle(compared, refs, quantities)
  for name, q in pairs(quantities) do
    local all = calls(q) and means(compared, name) or {}
    local base = standard(all)
    if base and q.state == "unsettled" then
      local own = all[base]
      local widest = student(own.runs - 1) * own.deviation
      local apart = compare.distance(refs[1].record.answers[name], refs[2].record.answers[name])
      if apart <= math.sqrt(2) * widest then
        q.state, q.scatter = "chaotic", own.deviation / compare.size(own.mean)
      elseif q.found then
        q.found.half = compare.larger(q.found.half, widest)
      end
    end
    if base and q.state == "chaotic" then compare_means(compared, name, q, all, base) end
  end
end

return scatter
