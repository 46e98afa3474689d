-- Chaotic answers: mean and scatter of each setting over a few runs that are changed slightly, and the settings whose
-- means cannot be told apart (Welch's test, 95 %).
local compare = require "hinge.cost.compare"
local statistics = require "hinge.accuracy.statistics"

local scatter = {}

--- The answer of that name of a setting's runs, the unchanged one first.
local function answers_of(s, name)
  local all = { s.record.answers[name] }
  for _, record in ipairs(s.varied or {}) do
    if record.answers[name] ~= nil then all[#all + 1] = record.answers[name] end
  end
  return all
end

-- Mean and scatter of an answer of each setting.
local function means(compared, name)
  local all = {}
  for _, s in ipairs(compared) do
    local mean, deviation, runs = statistics.mean(answers_of(s, name))
    if mean then all[s] = { mean = mean, deviation = deviation, runs = runs } end
  end
  return all
end

--- Whether there is a chaotic answer, or the chosen one is chaotic.
function scatter.chaotic(quantities, chosen)
  for name, q in pairs(quantities) do
    if q.state == "chaotic" and (not chosen or chosen == name) then return true end
  end
  return false
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
      local different = s ~= base and statistics.apart(m, all[base])
      s.means = s.means or {}
      s.means[name] = { mean = type(m.mean) == "number" and m.mean or nil, runs = m.runs,
        scatter = size > 0 and m.deviation / size or m.deviation > 0 and math.huge or 0, apart = different,
        difference = compare.error(m.mean, all[base].mean) }
      if not different then q.alike[#q.alike + 1] = s.label end
    end
  end
end

--- Puts `means` by answer into each setting whose runs were changed.
function scatter.settle(compared, quantities)
  for name, q in pairs(quantities) do
    local all = q.state == "chaotic" and means(compared, name) or {}
    local base = standard(all)
    if base then
      q.scatter = all[base].deviation / compare.size(all[base].mean)
      compare_means(compared, name, q, all, base)
    end
  end
end

return scatter
