-- The search for a setting whose answers have a given error: cheap runs first, the number with the largest error is
-- refined, then the chosen run is made, then one that checks it. Runs come from a function, so that a test can search
-- in a table.
local check = require "hinge.library.check"
local compare = require "hinge.cost.compare"
local judge = require "hinge.accuracy.judge"
local statistics = require "hinge.accuracy.statistics"
local Ladders = require "hinge.accuracy.ladders"
local with = Ladders.with

local Search = {}
Search.__index = Search

local room = 0.9     -- part of the accepted error that the ladders may take before the chosen run is made
local reserve = 2    -- the ladders of other knobs stand that many levels of the first one before its finest
local family = 3     -- runs with changed physical numbers at each setting, where answers are chaotic
local least_runs = 5 -- of a chaotic answer at the chosen setting
-- Values of a ladder after which an answer should come to rest: of the first knob, and of others.
local restless, restless_beside = 4, 3
-- Of the accepted error: a knob whose ladder shows that it has less is left as it is; and if it cannot be finer.
local small_part, bearable_part = 0.1, 0.5

-- Sizes at which the differences that do not matter are the accepted part.
local function sizes_of(problem)
  local sizes = {}
  for name, least in pairs(problem.least or {}) do sizes[name] = least / problem.within end
  return sizes
end

--- problem: knobs and corner (see Ladders.new), within, least = by name a difference that does not matter,
-- names(record) of the answers that count, run(levels, vary, chosen), which returns { answers =, seconds =, work =
-- steps times elements or nil, failed = } or nil where the budget ends; foretell(levels) and fits(seconds): what a run
-- takes, and whether there is time for it; say(text, levels).
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

--- Takes a run of these levels that has been made already.
function Search:begin_with(record, levels)
  record.levels = levels
  self.ladders:keep(levels, 0, record)
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

-- Whether a ladder tells no more, in an answer whose error is not accepted: four values of the first knob, of which the
-- last change is as large as the first; three of another knob, which show no order; three chaotic means that differ.
-- Settings that are finer in all then go on.
function Search:is_restless(knob)
  for _, name in ipairs(self.names) do
    local found = self.ladders:along(knob, name)
    local n = #found.levels
    if self.ladders.chaotic[name] and n >= 3 and found.by == "change" then return true end
    local accepted = self.ladders:part(knob, name) <= self.problem.within / 2
    if knob ~= self.knobs[1] and n >= restless_beside and not accepted and found.by ~= "order" then return true end
    if n >= restless and not accepted then
      local first = compare.distance(found.answers[n - 3], found.answers[n - 2])
      local last = compare.larger(compare.distance(found.answers[n - 2], found.answers[n - 1]),
        compare.distance(found.answers[n - 1], found.answers[n]))
      if not (last < first) then return true end
    end
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
function Search:choose()
  local chosen = finest_of(self)
  if not self.economic then return chosen end
  for i = #self.knobs, 1, -1 do
    local knob = self.knobs[i]
    local levels = self.ladders:levels(knob)
    for k = #levels - 1, 1, -1 do
      local trial = with(chosen, knob.name, levels[k])
      local _, most = Ladders.worst(self.ladders:errors(trial, self.names))
      if not (most <= room * self.problem.within) then break end
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

-- More runs with changed physical numbers at the chosen setting, until the bands of the means are accepted.
function Search:repeat_chaotic(chosen)
  if not next(self.ladders.chaotic) then return end
  for vary = 1, self.problem.most_runs - 1 do
    local errors = judge.errors(self, chosen)
    local _, most = Ladders.worst(errors)
    local others = 0 -- what more runs do not change
    for _, e in pairs(errors) do others = compare.larger(others, e.total - (e.band_part or 0)) end
    if vary >= least_runs and (most <= self.problem.within or not (others <= self.problem.within)) then break end
    if not self.ladders:at(chosen, vary) and not self:run(chosen, vary) then break end
  end
end

-- Whether a knob's ladder shows, in all answers whose error is too large, that its part of it is below `part` of the
-- accepted error.
function Search:is_small(knob, errors, part)
  for _, e in pairs(errors) do
    local found = e.found[knob.name]
    if not (e.total <= self.problem.within) and found.by ~= "exact"
      and not (found.by == "order" and e.parts[knob.name] <= part * self.problem.within) then return false end
  end
  return true
end

-- The setting after one whose errors are too large: all knobs a level finer, but for those that do little. nil where
-- one of them cannot be finer.
function Search:finer_than(chosen, errors)
  local finer, any = chosen, false
  for _, knob in ipairs(self.knobs) do
    local is_finest = chosen[knob.name] >= knob.most
    if not self:is_small(knob, errors, is_finest and bearable_part or small_part) then
      if is_finest then
        self.stuck[knob.name] = "finest"
        return nil
      end
      finer, any = with(finer, knob.name, chosen[knob.name] + 1), true
    end
  end
  return any and finer or nil
end

-- The run of a setting in full, the runs beside it, and what they say. nil and why where the run has no answer.
function Search:try(chosen, whatever)
  local own, why = self:run(chosen, 0, whatever and "whatever it takes" or "chosen")
  if not own then return nil, why end
  self:repeat_chaotic(chosen)
  local line = judge.line(self, chosen)
  local checked = not line and judge.check(self, chosen, own) or nil
  local errors = judge.errors(self, chosen, checked, line)
  local _, most = Ladders.worst(errors)
  return { chosen = chosen, errors = errors, checked = checked, line = line, reached = most <= self.problem.within,
    own = own.seconds, most = most }
end

local function closed(self, result)
  result.seconds, result.runs, result.stuck = self.seconds, self.runs, self.stuck
  return result
end

--- Searches. Returns { chosen = levels, errors = by answer, checked = levels or nil, line = list of levels or nil,
-- reached = whether all errors are accepted, stuck = { knob = reason }, seconds =, runs =, own = seconds of the chosen
-- run }; or nil and why there is no answer at all.
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
  self:climb()
  local result = self:try(self:choose()) or self:try(self:best_known(), true)
  if not result then return nil, "the chosen run failed" end
  while not result.reached do
    self.stuck = {} -- ladders that told no more do not end the search
    local finer = self:finer_than(result.chosen, result.errors)
    local better
    if not finer then return closed(self, result) end
    better, why = self:try(finer)
    if not better then
      for _, knob in ipairs(self.knobs) do
        if finer[knob.name] > result.chosen[knob.name] then self.stuck[knob.name] = why end
      end
      if why ~= "budget" then self:run(result.chosen, 0, "whatever it takes") end -- its output counts
      return closed(self, result)
    end
    result = better
  end
  return closed(self, result)
end

return Search
