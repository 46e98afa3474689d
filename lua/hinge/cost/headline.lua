-- The result of hinge cost in words: its first lines, the settings that failed, and what the budget left out.
local check = require "hinge.library.check"
local compare = require "hinge.cost.compare"
local text = require "hinge.cost.text"
local words = require "hinge.cost.words"

local headline = {}
local near = 1.1       -- settings whose bounds differ by less are the same to the words; the cheaper one is named
local cheaper = 2      -- a setting that takes less than half the time is worth a word beside the wanted one,
local far = 10         -- if its error is at most ten times the wanted one
local better = 2       -- so is one with less than half the error
local most_left_out = 6
local other_method = 100 -- farther away than any number of the same method

local percent, sorted = text.percent, text.sorted

local function time(seconds) return words.seconds(seconds, 2) end

-- Settings, and the finer runs with them if they are wanted, that have a finite bound of the error; the cheapest first.
local function candidates(result, finer)
  local all = {}
  for _, list in ipairs { result.settings, finer and result.finer or {} } do
    for _, s in ipairs(list) do
      if s.high and s.high < math.huge then all[#all + 1] = s end
    end
  end
  table.sort(all, function(a, b) return a.seconds < b.seconds end)
  return all
end

local function first(all, fits)
  for _, s in ipairs(all) do
    if fits(s) then return s end
  end
end

local function bound(part) return part < 1e-10 and "exact to rounding" or "within " .. words.bound(part) end

-- "dt 1 ms is", "two elements are"
local function is(name) return name .. ((name:find "^%w+ elements" or name:find "^%w+ steps") and " are" or " is") end

-- The setting that is good enough at much less cost than the wanted one, if its error is not much larger.
local function early_of(result)
  local wanted, early = result.cheapest, nil
  for _, s in ipairs(candidates(result)) do
    local better_yet = not early or s.high < early.high
    if s.seconds * cheaper <= wanted.seconds and s.high <= far * result.within and better_yet then early = s end
  end
  return early
end

--- The setting that the first line names: the cheapest that is good enough, or one that costs much less and is nearly
--- as good; where none is good enough, the best one. nil where no error has a bound.
function headline.named(result)
  if result.cheapest then return early_of(result) or result.cheapest end
  local settings, least = candidates(result), math.huge
  for _, s in ipairs(settings) do least = math.min(least, s.high) end
  return first(settings, function(s) return s.high <= near * least end)
end

-- "dt 1 ms with two elements is within 3 % in 4 s; 1 % takes 31 s (dt 250 us with four elements)"
local function main_line(result)
  local within, inputs, named = result.within, result.inputs, headline.named(result)
  local all = candidates(result, true)
  local function name(s) return words.setting(inputs, s.values) end
  local function takes(s, part)
    return ("%s takes %s (%s)"):format(words.bound(part), time(s.seconds), name(s))
  end
  local wanted = result.cheapest
  if named ~= wanted then
    local rest
    local fine = wanted or first(all, function(s) return s.high <= within end)
    local finest, beyond = all[#all], result.beyond
    if fine then rest = takes(fine, within)
    elseif beyond then
      rest = ("%s would take about %s (%s)"):format(words.bound(within), time(beyond.seconds), name(beyond))
    elseif finest ~= named and finest.high < named.high then
      rest = ("%s is not reached: the finest run (%s, %s) is %s"):format(percent(within), name(finest),
        time(finest.seconds), bound(finest.high))
    else rest = percent(within) .. " is not reached" end
    return ("%s %s in %s; %s"):format(is(name(named)), bound(named.high), time(named.seconds), rest)
  end
  local exact = wanted.high < 1e-10
  local next_one = not exact and first(all, function(s) return s.high * better <= wanted.high end)
  return ("%s %s in %s%s"):format(is(name(wanted)), exact and "exact to rounding" or "within " .. words.bound(within),
    time(wanted.seconds), next_one and "; " .. (next_one.high < 1e-10
      and ("%s exact in %s"):format(is(name(next_one)), time(next_one.seconds))
      or takes(next_one, next_one.high)) or "")
end

-- The chaotic answers in words: mean and scatter of the cheapest setting that cannot be told apart from the finest.
local function chaotic_line(result, name)
  local q, least, standard, alike, all = result.quantities[name], nil, nil, 0, 0
  for _, s in ipairs(result.settings) do
    local m = s.means and s.means[name]
    if m then
      all = all + 1
      if not m.apart then
        alike = alike + 1
        least = least or s
      end
      if s.label == q.standard then standard = s end
    end
  end
  if not least then
    return ("%s is chaotic: runs whose physical numbers change by 1e-9 scatter by %s"):format(name, percent(q.scatter))
  end
  local m = least.means[name]
  local value = m.mean and ("%.4g with a scatter of %.2g"):format(m.mean, m.scatter * math.abs(m.mean))
    or ("a scatter of %s of its largest value"):format(percent(m.scatter))
  local fine = ("%s (%s)"):format(words.setting(result.inputs, standard.values), time(standard.seconds))
  local rest
  if alike == all then
    rest = all > 1 and "no setting can be told apart from the finest, " .. fine
      or "no other setting was run often enough"
  elseif least == standard then
    rest = "the means of all other settings differ from it"
  else
    rest = ("this mean cannot be told apart from that of %s, as %d of %d cannot"):format(fine, alike, all)
  end
  return ("%s is chaotic: %s in %d runs of %s (%s each); %s"):format(name, value, m.runs,
    words.setting(result.inputs, least.values), time(least.seconds), rest)
end

-- "v (chaotic)", "plastic_kJ (within 14 %)": an answer by which settings are not compared, at the setting of the first
-- line.
local function not_counted(result, name, setting)
  local q, e = result.quantities[name], setting.estimates[name]
  return ("%s (%s)"):format(name, q.state == "chaotic" and "chaotic"
    or e and e.high < math.huge and q.by ~= "grows" and bound(e.high) or "does not converge")
end

--- The result in words: the first line is the answer; a second one names the answers that it does not hold for.
function headline.lines(result)
  local lines, others, chaotic, by = {}, {}, {}, {}
  for _, name in ipairs(result.compared_by) do by[name] = true end
  local named = headline.named(result)
  for _, name in ipairs(sorted(result.quantities)) do
    local state = result.quantities[name].state
    if not result.quantity or result.quantity == name then
      if state == "chaotic" then chaotic[#chaotic + 1] = name end
      if named and not by[name] and state ~= "moving" then others[#others + 1] = not_counted(result, name, named) end
    end
  end
  if named then
    lines[1] = main_line(result)
    if #others > 0 then lines[2] = "not counted: " .. words.list(others, 4) end
  elseif #chaotic > 0 then
    for i = 1, math.min(#chaotic, 2) do lines[i] = chaotic_line(result, chaotic[i]) end
  elseif #result.compared_by > 0 then
    local most, several = 0, #result.compared_by > 1
    for _, s in ipairs(result.settings) do most = compare.larger(most, s.error or 0) end
    lines[1] = ("no setting has a known error: %s %s%s"):format(words.list(result.compared_by, 3), result.finer[1]
        and (several and "do" or "does") .. " not get nearer to a value with finer settings"
        or (several and "have" or "has") .. " no finer run to compare with",
      most > 1e-10 and ("; errors are up to %s at least"):format(percent(most)) or "")
  else
    lines[1] = "no setting can be compared: " .. (next(result.quantities)
      and "every answer differs from run to run of the same setting"
      or "the scenario returns no number, and its runs have no probe")
  end
  return lines
end

-- The setting with an answer that is nearest to a failed one: of the same method if there is one, then by its numbers.
local function nearest_that_works(result, failed)
  local best, least = nil, math.huge
  for _, s in ipairs(result.settings) do
    local apart = 0
    for _, input in ipairs(result.inputs) do
      local a, b = s.values[input.name], failed.values[input.name]
      if a ~= nil and a ~= b then apart = apart + (input.side and math.abs(math.log(a / b)) or other_method) end
    end
    if apart < least then best, least = s, apart end
  end
  return best
end

--- Settings without an answer, a line for each reason, with the nearest setting that has one.
function headline.failures(result)
  local lines, of = {}, {}
  for _, s in ipairs(result.failed) do
    local reason = check.one_line(s.failed)
    if not of[reason] then
      of[reason] = { s }
      lines[#lines + 1] = reason
    else
      table.insert(of[reason], s)
    end
  end
  for i, reason in ipairs(lines) do
    local settings = of[reason]
    local works = nearest_that_works(result, settings[1])
    lines[i] = ("no answer: %s%s: %s%s"):format(words.setting(result.inputs, settings[1].values),
      #settings > 1 and (" and %d more"):format(#settings - 1) or "", reason,
      works and ("; the nearest setting with an answer is %s"):format(words.setting(result.inputs, works.values)) or "")
  end
  return lines
end

--- The warnings of runs: in how many settings, and the first one, of the cheapest good setting if that has any.
function headline.warnings(result)
  local warned, shown = 0, nil
  for _, s in ipairs(result.settings) do
    if s.warnings and #s.warnings > 0 then
      warned = warned + 1
      if not shown or s == result.cheapest then shown = s end
    end
  end
  if not shown then return {} end
  return { ("warnings in %d of %d settings, such as %s: %s"):format(warned, #result.settings,
    words.setting(result.inputs, shown.values), shown.warnings[1]) }
end

--- What the budget left out, with the time that each would take.
function headline.left_out(result)
  local n = #result.left_out
  if n == 0 then return {} end
  local parts, own, rest = {}, 0, 0
  for i, s in ipairs(result.left_out) do
    parts[i] = ("%s (%s)"):format(words.setting(result.inputs, s.values),
      s.estimate > 0 and "about " .. time(s.estimate) or "was run")
    own, rest = own + s.estimate, math.max(rest, s.rest)
  end
  return { ("left out because of the budget: %d %s, %s; with their references and checks they take about %s more")
    :format(n, n == 1 and "setting" or "settings", words.list(parts, most_left_out), time(own + rest)) }
end

return headline
