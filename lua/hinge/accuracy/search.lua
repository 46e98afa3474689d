-- The search for a setting whose answers have a given error: cheap runs first, the number with the largest error is
-- refined, then the chosen run is made, then one that checks it. Runs come from a function, so that a test can search
-- in a table.
local check = require "hinge.library.check"
local compare = require "hinge.cost.compare"
local statistics = require "hinge.accuracy.statistics"
local Ladders = require "hinge.accuracy.ladders"
local with = Ladders.with

local Search = {}
Search.__index = Search

local room = 0.9     -- part of the accepted error that the ladders may take before the chosen run is made
local reserve = 2    -- the ladders of other knobs stand that many levels of the first one before its finest
local family = 3     -- runs with changed physical numbers at each setting, where answers are chaotic
local least_runs = 5 -- of a chaotic answer at the chosen setting
-- Times the work of the chosen run: where a check would make the search cost more, its first knob is coarser. Runs take
-- more than their steps; asking then costs about four times the chosen run.
local dearest = 3.5
local dear_check = 2 -- times the work of the chosen run: a check that takes more with any step is left out
local rest = 4 / 3   -- of a series of the second order with halved steps
local careful = 3    -- the factor of safety where nothing shows an order, see estimate.lua
local restless = 6   -- values of a ladder after which an answer should come to rest

-- Sizes at which the differences that do not matter are the accepted part.
local function sizes_of(problem)
  local sizes = {}
  for name, least in pairs(problem.least or {}) do sizes[name] = least / problem.within end
  return sizes
end

--- problem: knobs and corner (see Ladders.new), within, least = by name a difference that does not matter,
-- names(record) of the answers that count, run(levels, vary, chosen), which returns { answers =, seconds =, work = steps times
-- elements or nil, failed = } or nil where the budget ends; foretell(levels) and fits(seconds): what a run takes, and
-- whether there is time for it; say(text, levels).
function Search.new(problem)
  return setmetatable({ problem = problem, economic = problem.economic, knobs = problem.knobs,
    ladders = Ladders.new(problem.knobs, problem.corner, problem.within / 2, sizes_of(problem)), seconds = 0,
    work = 0, runs = 0, stuck = {}, sensitive = {}, names = {} }, Search)
end

--- The run of these levels; `chosen`: made in full, whatever is known of it. nil and why it is not there: "budget", or
-- what failed.
function Search:run(levels, vary, chosen)
  vary = vary or 0
  local key = self.ladders:key(levels)
  local record = not chosen and (self.ladders.records[key] or {})[vary]
  if not record then
    if chosen ~= "whatever it takes" and not self.problem.fits(self.problem.foretell(levels)) then
      return nil, "budget"
    end
    record = self.problem.run(levels, vary, chosen)
    if not record then return nil, "budget" end
    record.levels = levels
    self.ladders:keep(levels, vary, record)
    self.runs, self.seconds = self.runs + 1, self.seconds + record.seconds
    self.work = self.work + (record.work or record.seconds)
  end
  if record.failed then return nil, record.failed end
  if vary == 0 and next(self.ladders.chaotic) then
    for k = 1, family - 1 do self:run(levels, k) end
  end
  return record
end

--- Takes a run of the coarsest setting that has been made already.
function Search:begin_with(record)
  record.levels = self.ladders.corner
  self.ladders:keep(self.ladders.corner, 0, record)
  self.runs, self.seconds, self.work = 1, record.seconds, record.work or record.seconds
end

-- The coarsest setting that has an answer: the first knob is refined until there is one.
function Search:begin()
  local first = self.knobs[1]
  while true do
    local record, why = self:run(self.ladders.corner)
    if record then return record end
    if why == "budget" or not first or self.ladders.corner[first.name] >= first.most then return nil, why end
    self.ladders.corner = with(self.ladders.corner, first.name, self.ladders.corner[first.name] + 1)
    self.ladders.coarse = self.ladders.corner
  end
end

-- The largest change of an answer between neighbours among these levels of a knob, from the a-th to the b-th.
function Search:largest_change(knob, name, levels, a, b)
  local most, place = 0, self.ladders:place(knob)
  for i = a + 1, b do
    most = compare.larger(most, compare.distance(self.ladders:answer(with(place, knob.name, levels[i - 1]), name),
      self.ladders:answer(with(place, knob.name, levels[i]), name)))
  end
  return most
end

-- Whether refinements of a knob change an answer by no less each time: six values, of which the last three differ as
-- much as the first three, in an answer whose error is not accepted.
function Search:is_restless(knob)
  for _, name in ipairs(self.names) do
    local levels = self.ladders:levels(knob)
    local n = #levels
    if self.ladders.chaotic[name] and n >= 3 and self.ladders:along(knob, name).by == "change" then return true end
    if n >= restless and not (self.ladders:part(knob, name) <= self.problem.within / 2)
      and not (self:largest_change(knob, name, levels, n - 2, n)
        < self:largest_change(knob, name, levels, n - 5, n - 3)) then return true end
  end
  return false
end

-- Adds the next level to a knob's ladder. False where there is none: the knob is stuck, with the reason.
function Search:refine(knob)
  local levels = self.ladders:levels(knob)
  local level = #levels > 0 and levels[#levels] + 1 or self.ladders:place(knob)[knob.name]
  if level > knob.most then
    self.stuck[knob.name] = "finest"
    return false
  end
  local record, why = self:run(with(self.ladders:place(knob), knob.name, level))
  if not record then self.stuck[knob.name] = why
  elseif self:is_restless(knob) then self.stuck[knob.name] = "restless" end
  return record ~= nil
end

local function finest_of(self)
  local levels = {}
  for _, knob in ipairs(self.knobs) do
    local all = self.ladders:levels(knob)
    levels[knob.name] = all[#all] or self.ladders.corner[knob.name]
  end
  return levels
end

-- The knob that is refined next: that with the largest part in an answer whose error is not accepted. nil where the
-- errors of a knob that cannot be refined are too large by themselves: all else would be in vain.
function Search:next_knob(errors)
  local best, most = nil, 0
  for _, name in ipairs(check.keys(errors)) do
    local e = errors[name]
    if not (e.total <= room * self.problem.within) then
      for _, knob in ipairs(self.knobs) do
        local part = e.parts[knob.name]
        if self.stuck[knob.name] and not (part <= room * self.problem.within) then return nil, knob end
        if not self.stuck[knob.name] and not (part <= most) then best, most = knob, part end
      end
    end
  end
  return best
end

-- Refines ladders until their errors together are accepted. Returns whether they are.
function Search:climb()
  while true do
    local errors = self.ladders:errors(finest_of(self), self.names)
    local _, most = Ladders.worst(errors)
    if most <= room * self.problem.within then return true end
    local knob = self:next_knob(errors)
    if not knob then return false end
    self:refine(knob)
  end
end

-- The first ladder alone, until its own error is a small part of the accepted one: a quarter where two values must do,
-- half where there are more. Then the ladders of the others stand before its end.
function Search:first_ladder()
  local first = self.knobs[1]
  while first do
    local levels = self.ladders:levels(first)
    local most = 0
    for _, name in ipairs(self.names) do
      most = compare.larger(most, self.ladders:part(first, name))
    end
    if most <= self.problem.within / (#levels >= 3 and 2 or 4) or self.stuck[first.name]
      or not self:refine(first) then break end
  end
  local levels = first and self.ladders:levels(first) or {}
  if #levels > 0 then
    self.ladders.coarse = with(self.ladders.corner, first.name, math.max(levels[1], levels[#levels] - reserve))
  end
end

-- Scatter of the answers at a place, in runs whose physical numbers change by 1e-9, into `spread`. One such run tells
-- that an answer is not chaotic; where one is, all of a family are made.
function Search:add_spread(place, names, spread)
  local base = self.ladders:at(place)
  for vary = 1, family - 1 do
    local wild = false
    for name in pairs(spread) do wild = wild or statistics.is_chaotic(spread[name], self.problem.within) end
    if vary > 1 and not wild then break end
    local record, why = self:run(place, vary)
    if not record and why == "budget" then break end
    for _, name in ipairs(names) do
      local a, b = base.answers[name], record and record.answers[name]
      local apart = b == nil and math.huge or Ladders.part_of(compare.distance(b, a), self.ladders:size(name, { a }))
      spread[name] = compare.larger(spread[name] or 0, apart)
    end
  end
end

-- Which answers are chaotic: at the coarsest setting, and a level of the first knob above it as well. At one alone it
-- is the time step that makes an answer jump, for example where a step is divided or not.
function Search:look_for_chaos()
  local place, names = self.ladders.corner, self.names
  for _ = 1, 2 do
    local spread, wild = {}, {}
    self:add_spread(place, names, spread)
    for _, name in ipairs(names) do
      self.sensitive[name] = spread[name]
      if spread[name] and statistics.is_chaotic(spread[name], self.problem.within) then wild[#wild + 1] = name end
    end
    names = wild
    local first = self.knobs[1]
    if #wild == 0 or not first then break end
    place = with(place, first.name, place[first.name] + 1)
    if place[first.name] > first.most or not self:run(place) then break end
  end
  for _, name in ipairs(names) do self.ladders.chaotic[name] = true end
end

-- The finest levels of the ladders. Where many runs follow (economic), the coarsest whose errors together are accepted:
-- the dearest knob is coarsened first, which is the last.
function Search:choose(floor)
  local chosen = finest_of(self)
  if not self.economic then return chosen end
  for i = #self.knobs, 1, -1 do
    local knob = self.knobs[i]
    local levels = self.ladders:levels(knob)
    for k = #levels - 1, 1, -1 do
      local trial = with(chosen, knob.name, levels[k])
      local _, most = Ladders.worst(self.ladders:errors(trial, self.names))
      if levels[k] < (floor[knob.name] or levels[k]) or not (most <= room * self.problem.within) then break end
      chosen = trial
    end
  end
  return chosen
end

-- The setting with the least error of those that have been run.
function Search:best_known()
  local best, least = self.ladders.corner, math.huge
  for _, runs in pairs(self.ladders.records) do
    local record = runs[0]
    if record and not record.failed then
      local _, most = Ladders.worst(self.ladders:errors(record.levels, self.names))
      if most < least then best, least = record.levels, most end
    end
  end
  return best
end

-- Mean and band of a chaotic answer at the chosen setting, into its errors.
function Search:add_scatter(chosen, name, e)
  local mean, deviation, runs = statistics.mean(self.ladders:values(chosen, name))
  if not mean then
    e.total = math.huge
    return
  end
  local size = self.ladders:size(name, { mean })
  e.mean, e.deviation, e.runs = mean, deviation, runs
  e.band = statistics.band(deviation, runs)
  e.band_part = Ladders.part_of(e.band, size)
  e.total = e.total + e.band_part
end

-- Errors at the chosen setting, with what its own run and the check show.
function Search:judge(chosen, checked)
  local errors = self.ladders:errors(chosen, self.names)
  local first = self.knobs[1]
  for name, e in pairs(errors) do
    e.interplay = self.ladders.chaotic[name] and 0 or self.ladders:interplay(chosen, name)
    e.total = e.total + e.interplay
    if not self.ladders.chaotic[name] then e.total = e.total + 2 * (self.sensitive[name] or 0) end
    if self.ladders.chaotic[name] then self:add_scatter(chosen, name, e) end
    local other = first and checked and checked[first.name] ~= chosen[first.name] and e.parts[first.name] or 0
    local shown = checked and not self.ladders.chaotic[name]
      and self:shown_by(checked, chosen, name, e.total - other)
    if shown then
      e.shown = shown
      if other + shown > e.total then e.total, e.by_check = other + shown, true end
    end
  end
  return errors
end

-- What the check shows of an answer's error: its change where all knobs but the first are finer, without what the first
-- knob explains, with the rest of the series in theory. Where that is more than the ladders expect (`expected_part`),
-- the series is not that of the theory: the change has the factor of safety of two values.
function Search:shown_by(checked, chosen, name, expected_part)
  local first = self.knobs[1]
  local own, other = self.ladders:answer(chosen, name), self.ladders:answer(checked, name)
  if own == nil or other == nil then return math.huge end
  local expected = own
  if first and checked[first.name] ~= chosen[first.name] then
    local place = self.ladders:place(first)
    local there = self.ladders:answer(with(place, first.name, checked[first.name]), name)
    local here = self.ladders:answer(with(place, first.name, chosen[first.name]), name)
    if there ~= nil and here ~= nil then
      expected = compare.combined(function(a, b, c) return c + a - b end, there, here, own) or own
    end
  end
  local change = Ladders.part_of(compare.distance(other, expected), self.ladders:size(name, { own }))
  return change * (rest * change <= expected_part and rest or careful)
end

-- The check of a setting: all knobs but the first a level finer, and the first one that many levels coarser. With one
-- knob alone it is a level finer. nil where no knob can be finer.
function Search:check_of(chosen, coarser)
  local checked, finer = {}, false
  for i, knob in ipairs(self.knobs) do
    local level = chosen[knob.name]
    if i == 1 and #self.knobs > 1 then checked[knob.name] = math.max(self.ladders.corner[knob.name], level - coarser)
    else checked[knob.name], finer = math.min(knob.most, level + 1), finer or level < knob.most end
  end
  return finer and checked or nil
end

-- Makes the check of a setting, with the first knob as fine as its cost allows, by steps and elements: the same on
-- every machine. Returns its levels, nil where there is none.
function Search:run_check(chosen, own)
  local work, first = own.work or own.seconds, self.knobs[1]
  local coarsest = #self.knobs > 1 and math.max(1, chosen[first.name] - self.ladders.coarse[first.name]) or 1
  local checked
  for coarser = 1, coarsest do
    checked = self:check_of(chosen, coarser)
    if not checked then return nil end
    local more = work
    for _, knob in ipairs(self.knobs) do
      more = more * knob.ratio ^ ((knob.work or 1) * (checked[knob.name] - chosen[knob.name]))
    end
    if self.ladders:at(checked) or self.work + more <= dearest * work then break end
    if coarser == coarsest and more > dear_check * work then return nil end
  end
  return self:run(checked) and checked or nil
end

-- More runs with changed physical numbers at the chosen setting, until the bands of the means are accepted.
function Search:repeat_chaotic(chosen)
  if not next(self.ladders.chaotic) then return end
  for vary = 1, self.problem.most_runs - 1 do
    local errors = self:judge(chosen)
    local _, most = Ladders.worst(errors)
    local others = 0 -- what more runs do not change
    for _, e in pairs(errors) do others = compare.larger(others, e.total - (e.band_part or 0)) end
    if vary >= least_runs and (most <= self.problem.within or not (others <= self.problem.within)) then break end
    if not self.ladders:at(chosen, vary) and not self:run(chosen, vary) then break end
  end
end

--- Searches. Returns { chosen = levels, errors = by answer, checked = levels or nil, reached = whether all errors are
-- accepted, stuck = { knob = reason }, seconds =, runs =, own = seconds of the chosen run }; or nil and why there is no
-- answer at all.
function Search:find()
  local record, why = self:begin()
  if not record then return nil, why end
  self.names = self.problem.names(record)
  self:look_for_chaos()
  self:first_ladder()
  for i = 2, #self.knobs do
    local knob = self.knobs[i]
    while #self.ladders:levels(knob) < 2 and self:refine(knob) do end
  end
  local floor, result = {}, nil
  while true do
    self:climb()
    local chosen = self:choose(floor)
    local own = self:run(chosen, 0, "chosen")
    if not own then
      if result then return result end
      chosen = self:best_known()
      own = self:run(chosen, 0, "whatever it takes")
      if not own then return nil, "the chosen run failed" end
    end
    self:repeat_chaotic(chosen)
    local checked = self:run_check(chosen, own)
    local errors = self:judge(chosen, checked)
    local _, most = Ladders.worst(errors)
    result = { chosen = chosen, errors = errors, checked = checked, reached = most <= self.problem.within,
      stuck = self.stuck, seconds = self.seconds, runs = self.runs, own = own.seconds, most = most }
    if result.reached then return result end
    local knob = self:next_knob(errors)
    if not knob then return result end
    floor[knob.name] = chosen[knob.name] + 1
    local levels = self.ladders:levels(knob)
    if levels[#levels] < floor[knob.name] and not self:refine(knob) then return result end
  end
end

return Search
