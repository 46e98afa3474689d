-- Results when all settings have been run: which answers can be trusted, the errors, the orders of convergence, and the
-- Pareto front.
local compare = require "hinge.cost.compare"
local ladder = require "hinge.cost.ladder"

local verdict = {}
local rounding = 1e-10     -- errors below it are the same to the front
local least_scatter = 1e-6 -- of an answer: what stays below is rounding, however strict `within` is

--- For every answer: whether it can be trusted to `within`, and if not, why.
function verdict.answers(refs, scatter, moving, compared, within)
  local quantities = {}
  local sample = refs and refs[2].record.answers or compared[#compared].record.answers
  for name, answer in pairs(sample) do
    local agreement = refs and compare.error(refs[1].record.answers[name], answer) or nil
    local spread = scatter and scatter[name] or nil
    local chaotic = spread and not (spread <= math.max(within / 2, least_scatter))
    local state = moving[name] and "moving" or chaotic and "chaotic"
      or not refs and "unknown" or not (agreement <= within / 2) and "unsettled" or "sound"
    quantities[name] = { state = state, agreement = agreement, scatter = spread,
      value = type(answer) == "number" and answer or nil,
      kind = type(answer) == "number" and "number" or "history" }
  end
  return quantities
end

--- The errors of each setting by answer, and one error of the setting: the largest of the trusted answers, or that of
--- the
-- chosen answer. It is not below the difference of the references.
function verdict.errors(compared, refs, quantities, chosen)
  for _, s in ipairs(compared) do
    s.errors = {}
    for name, q in pairs(quantities) do
      if q.state == "sound" then
        local error = compare.error(s.record.answers[name], refs[2].record.answers[name])
        s.errors[name] = error
        local bounded = compare.larger(error, q.agreement)
        if (not chosen or chosen == name)
          and (not s.error or bounded > s.error or bounded == s.error and name < s.worst) then
          s.error, s.worst, s.below = bounded, name, error < q.agreement
        end
      end
    end
  end
end

--- For each knob with a known finer side: the order of convergence of the answers, from its finest three values. All
-- other knobs have their finest value.
function verdict.orders(knobs, compared, refs, quantities, chosen)
  local result, sided = {}, 0
  for _, knob in ipairs(knobs) do sided = sided + (knob.side and 1 or 0) end
  for _, knob in ipairs(knobs) do
    if knob.side then
      local line = {}
      for _, s in ipairs(compared) do
        local along = true
        for _, other in ipairs(knobs) do
          along = along and (other == knob or s.values[other.name] == ladder.finest(other, compared))
        end
        if along then line[#line + 1] = s end
      end
      if sided == 1 and refs then table.move(refs, 1, 2, #line + 1, line) end
      table.sort(line, function(a, b) return ladder.finer(knob, b.values[knob.name], a.values[knob.name]) > 1 end)
      local found, all, n = {}, {}, #line
      for name, q in pairs(quantities) do
        if n >= 3 and q.state == "sound" and (not chosen or chosen == name) then
          local h, answers = {}, {}
          for i = 1, 3 do
            h[i] = 1 / ladder.finer(knob, line[n - 3 + i].values[knob.name], line[n - 2].values[knob.name])
            answers[i] = line[n - 3 + i].record.answers[name]
          end
          found[name] = compare.order(h, answers)
          if found[name] ~= math.huge then all[#all + 1] = found[name] end
        end
      end
      result[knob.name] = { observed = compare.median(all) or next(found) and math.huge, theory = knob.side.order,
        why = knob.side.why, quantities = found,
        note = n < 3 and "three values of it are needed, with all else at its finest" or nil }
    end
  end
  return result
end

--- Sets the time of each setting and whether it is on the Pareto front, and sorts the settings by time. Returns the
--- front
-- and the cheapest setting with an error up to `within`.
function verdict.front(compared, within)
  local cheapest, items = math.huge, {}
  for i, s in ipairs(compared) do
    local r = s.record
    s.seconds, s.times, s.outside = compare.median(r.seconds), r.seconds, r.outside
    s.stages, s.memory, s.remainder = r.stages, r.memory, r.remainder
    cheapest = math.min(cheapest, s.seconds)
    items[i] = { time = s.seconds, error = s.error and compare.larger(s.error, rounding), setting = s }
  end
  local front = {}
  for i, item in ipairs(compare.front(items)) do front[i], item.setting.front = item.setting, true end
  table.sort(compared, function(a, b) return a.seconds < b.seconds end)
  local best
  for _, s in ipairs(compared) do
    s.ratio, s.front = s.seconds / cheapest, s.front or false
    s.errors = s.errors or {}
    s.meets = s.error ~= nil and s.error <= within
    best = best or s.meets and s or nil
    s.answers, s.record, s.weight, s.place = s.record.answers, nil, nil, nil
  end
  return front, best
end

return verdict
