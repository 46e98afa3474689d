-- Results when all settings have been run: which answers can be trusted, the errors, the orders of convergence, and the
-- Pareto front.
local alike = require "hinge.cost.alike"
local compare = require "hinge.cost.compare"
local refinement = require "hinge.accuracy.estimate"
local estimate = require "hinge.cost.estimate"
local ladder = require "hinge.cost.ladder"
local methods = require "hinge.cost.methods"
local statistics = require "hinge.accuracy.statistics"

local verdict = {}
local farthest = 6         -- refinements that are foretold
local rounding = 1e-10     -- of what is accepted

--- For every answer: whether it can be trusted to `within`, and if not, why.
function verdict.answers(refs, scatter, moving, compared, within)
  local quantities = {}
  local sample = refs and refs[2].record.answers or compared[#compared].record.answers
  for name, answer in pairs(sample) do
    local agreement = refs and compare.error(refs[1].record.answers[name], answer) or nil
    local spread = scatter and scatter[name] or nil
    local chaotic = spread and statistics.is_chaotic(spread, within)
    local state = moving[name] and "moving" or chaotic and "chaotic"
      or not refs and "unknown" or not (agreement <= within / 2) and "unsettled" or "sound"
    quantities[name] = { state = state, agreement = agreement, scatter = spread,
      kind = type(answer) == "number" and "number" or "history" }
  end
  return quantities
end

-- The setting that stands for the finest among some, and whether all its inputs have their finest value.
local function finest_of(inputs, compared)
  local best, most = nil, -1
  for _, s in ipairs(compared) do
    local finest = 0
    for _, input in ipairs(inputs) do
      if s.values[input.name] == ladder.finest(input, compared) then finest = finest + 1 end
    end
    if finest > most or finest == most and s.weight > best.weight then best, most = s, finest end
  end
  return best, most == #inputs
end

-- The settings that differ from the finest one in this number alone and are no finer, the coarsest first.
local function line_to(finest, input, inputs, compared)
  local line = {}
  for _, s in ipairs(compared) do
    local along = ladder.finer(input, s.values[input.name], finest.values[input.name]) <= 1
    for _, other in ipairs(inputs) do
      along = along and (other == input or s.values[other.name] == finest.values[other.name])
    end
    if along then line[#line + 1] = s end
  end
  table.sort(line, function(a, b) return ladder.finer(input, b.values[input.name], a.values[input.name]) > 1 end)
  return line
end

-- The order in which all numbers converge together when each is refined by its ratio, in terms of halved steps; of one
-- number alone its own.
local function joint_order(inputs)
  local least, sided, own = math.huge, 0, 1
  for _, input in ipairs(inputs) do
    if input.side then
      sided, own = sided + 1, input.side.order or 1
      least = math.min(least, own * math.log(input.side.ratio, 2))
    end
  end
  return sided > 1 and least or own
end

-- The settings and references along which all numbers are refined together, the finest last, their step sizes, and the
-- finest setting. If one number alone is varied, its settings are on that line, too.
local function levels_of(inputs, compared, refs)
  local best, whole = finest_of(inputs, compared)
  local sided = {}
  for _, input in ipairs(inputs) do sided[#sided + 1] = input.side and input end
  local levels, h = {}, {}
  if #sided == 1 and whole then levels = line_to(best, sided[1], inputs, compared)
  elseif whole then levels = { best } end
  table.move(refs, 1, #refs, #levels + 1, levels)
  levels = table.move(levels, math.max(1, #levels - 2), #levels, 1, {})
  for i, s in ipairs(levels) do
    h[i] = #sided == 1 and 1 / ladder.finer(sided[1], s.values[sided[1].name], best.values[sided[1].name])
      or 2 ^ (#levels - i)
  end
  return levels, h, best
end

--- What is known of the exact value of each answer, into `found` and `finest` of it: from the finest setting and the
--- references, which refine all numbers together. Without a reference it comes from one line of settings a number.
-- refs: the references that have an answer, none to two of them. Answers that differ by less than `within` have
-- settled.
function verdict.estimates(inputs, compared, refs, quantities, within)
  local levels, h, best = levels_of(inputs, compared, refs)
  local finest, order = levels[#levels] or best, joint_order(inputs)
  for name, q in pairs(quantities) do
    local last = finest.record.answers[name]
    local answers, parts = {}, {}
    for i, s in ipairs(levels) do answers[i] = s.record.answers[name] end
    if q.state == "moving" or last == nil then q.found = nil
    elseif #refs > 0 then
      q.found = #answers == #levels and refinement.along(h, answers, order, within)
        or { by = "open", answer = last, error = math.huge }
    else
      for _, input in ipairs(inputs) do
        if input.side then
          local line, sizes, values = line_to(finest, input, inputs, compared), {}, {}
          for i = math.max(1, #line - 2), #line do
            sizes[#sizes + 1] = 1 / ladder.finer(input, line[i].values[input.name], finest.values[input.name])
            values[#values + 1] = line[i].record.answers[name]
          end
          parts[#parts + 1] = #values == #sizes and refinement.along(sizes, values, input.side.order or 1, within)
            or { by = "open", answer = last, error = math.huge }
        end
      end
      q.found = #parts > 0 and estimate.together(last, parts) or { by = "open", answer = last, error = math.huge }
    end
    q.finest = last
  end
  return finest
end

-- The answers by which settings are compared: the chosen one; else those that can be trusted; else, one kind after the
-- other, those with a band and those with a lower bound.
local function ranked(quantities, chosen)
  local kinds = { {}, {}, {} }
  for name, q in pairs(quantities) do
    if q.found and q.state ~= "chaotic" and (not chosen or chosen == name) then
      local open = q.found.by == "open" or q.found.by == "grows"
      kinds[chosen and 1 or q.state == "sound" and 1 or open and 3 or 2][name] = q
    end
  end
  return next(kinds[1]) and kinds[1] or next(kinds[2]) and kinds[2] or kinds[3]
end

-- The error of a setting: that of the answer whose band reaches farthest. A setting that is nearer than the finest one
-- is known has the end of its band.
local function worst_of(s, names)
  for name in pairs(names) do
    local e = s.estimates[name]
    local above, below = e and e.high == math.huge, e and e.low == 0 and e.high > 0 and e.high < math.huge
    local error = e and (below and e.high or e.error)
    if e and (not s.high or not (e.high <= s.high) or e.high == s.high
      and (error > s.error or error == s.error and name < s.worst)) then
      s.error, s.worst, s.low, s.high, s.below, s.above = error, name, e.low, e.high, below, above
    end
  end
end

--- The errors of each setting by answer, and one error of the setting: the largest of the answers by which settings are
--- compared. The same for the references. Returns these answers.
function verdict.errors(compared, refs, quantities, chosen)
  local names = ranked(quantities, chosen)
  for _, list in ipairs { compared, refs } do
    for _, s in ipairs(list) do
      s.errors, s.estimates = {}, {}
      for name, q in pairs(quantities) do
        if q.found and q.state ~= "chaotic" then
          s.estimates[name] = estimate.error(s.record.answers[name], q.found, q.finest)
          s.errors[name] = s.estimates[name].difference
        end
      end
      worst_of(s, names)
    end
  end
  return names
end

--- How many refinements beyond the settings would bring all of these answers within what is accepted: nil where an
--- order is not clear, or where it would be more than `farthest`. refs: how many of them were run.
function verdict.needed(inputs, names, refs, within)
  local most, theory = refs, joint_order(inputs)
  for _, q in pairs(names) do
    local found, size = q.found, compare.size(q.found.answer)
    if found.by == "order" and size > 0 then
      -- the error of the finest run, and the end of its band, which is twice that
      local further = math.log(2 * found.error / size / within, 2) / math.min(found.order, theory)
      most = math.max(most, refs + math.ceil(further - 1e-9))
    elseif found.by ~= "exact" then
      return nil
    end
  end
  return most > refs and most <= farthest and most or nil
end

--- Puts what is known of the exact values into fields for the script and for summary.json: see hinge.cost_quantity.
function verdict.describe(quantities)
  for _, q in pairs(quantities) do
    local found, size = q.found, q.found and compare.size(q.found.answer)
    if found then
      q.by, q.order = found.by, found.order
      q.half = size > 0 and found.error / size or found.error > 0 and math.huge or 0
      q.extrapolated = q.kind == "number" and found.by == "order" and found.answer or nil
    end
    q.value, q.found, q.finest = q.kind == "number" and q.finest or nil, nil, nil
  end
end

--- For each input with a known finer side: the order of convergence of some answers, from its finest three values. All
-- other inputs have their finest value.
function verdict.orders(inputs, compared, refs, names)
  local result, sided = {}, 0
  for _, input in ipairs(inputs) do sided = sided + (input.side and 1 or 0) end
  for _, input in ipairs(inputs) do
    if input.side then
      local line = line_to(ladder.reference(inputs, compared, 0), input, inputs, compared)
      if sided == 1 then table.move(refs, 1, #refs, #line + 1, line) end
      local found, all, n = {}, {}, #line
      for name in pairs(names) do
        if n >= 3 then
          local h, answers = {}, {}
          for i = 1, 3 do
            h[i] = 1 / ladder.finer(input, line[n - 3 + i].values[input.name], line[n - 2].values[input.name])
            answers[i] = line[n - 3 + i].record.answers[name]
          end
          found[name] = compare.order(h, answers)
          if found[name] ~= math.huge then all[#all + 1] = found[name] end
        end
      end
      result[input.name] = { observed = compare.median(all) or next(found) and math.huge, theory = input.side.order,
        why = input.side.why, quantities = found,
        note = n < 3 and "three values of it are needed, with all else at its finest" or nil }
    end
  end
  return result
end

--- Sets the time of each setting and whether it is on the Pareto front, and sorts the settings by time. Returns the
--- front and the cheapest setting whose error, with its band, is up to `within`.
function verdict.front(compared, within)
  local cheapest = math.huge
  for _, s in ipairs(compared) do
    local r = s.record
    s.seconds, s.times, s.outside = compare.median(r.seconds), r.seconds, r.outside
    s.stages, s.memory, s.energy_error = r.stages, r.memory, r.energy_error
    cheapest = math.min(cheapest, s.seconds)
  end
  local front = {}
  for i, item in ipairs(methods.front(compared)) do front[i], item.setting.front = item.setting, true end
  table.sort(compared, function(a, b) return a.seconds < b.seconds end)
  local best
  for _, s in ipairs(compared) do
    s.ratio, s.front = s.seconds / cheapest, s.front or false
    s.errors = s.errors or {}
    s.meets = s.high ~= nil and s.high <= within * (1 + rounding)
    best = best or s.meets and s or nil
    s.answers, s.warnings = s.record.answers, s.record.warnings or {}
    s.record, s.weight, s.place, s.varied, s.values, s.any = nil, nil, nil, nil, alike.values(s), nil
  end
  return front, best
end

return verdict
