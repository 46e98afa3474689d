-- The bench: runs settings of a scenario within a budget, keeps finished measurements, times settings alternately, and
-- estimates the time of others.
local core = require "hinge.core"
local changes = require "hinge.accuracy.changes"
local ladder = require "hinge.cost.ladder"
local measure = require "hinge.cost.measure"
local compare = require "hinge.cost.compare"
local store = require "hinge.cost.store"

local Bench = {}
Bench.__index = Bench
local perturbations = 3
local few = 4         -- runs of a setting that are changed to see its scatter, beside the unchanged one
local most_repeats = 21

--- base: the scenario's parameters; options: see hinge.cost.
local function open(scenario, base, inputs, options)
  return setmetatable({
    scenario = scenario, base = base, inputs = inputs, case = options.case, part = options.perturbation,
    say = options.progress, store = store.open(options.out, scenario.run),
    start = core.clock(), budget = options.budget, names = {}, timed = {},
  }, Bench)
end

function Bench:elapsed() return core.clock() - self.start end

--- Whether so many seconds more are within the budget.
function Bench:fits(seconds) return not self.budget or self:elapsed() + seconds <= self.budget end

-- The parameters of a setting. `variation` > 0: physical numbers change by a part of 1e-9 or so: here the parameters
-- that are no settings and not whole; stiffness and strength of the models as well (Bench:measure).
function Bench:parameters(setting, variation)
  local p, names = {}, {}
  for name, value in pairs(self.base) do p[name] = value end
  for name, value in pairs(setting.values) do p[name] = value end
  if variation == 0 then return p end
  for name in pairs(p) do names[#names + 1] = setting.values[name] == nil and name or nil end
  table.sort(names)
  for name, value in pairs(measure.perturbed(p, names, self.part, variation)) do p[name] = value end
  return p
end

function Bench:key(setting, variation)
  return store.key(self:parameters(setting, 0), (" case %s, changed by %g times %d%s")
    :format(self.case or "", self.part, variation, setting.without and ", without " .. setting.without or ""))
end

function Bench:record(setting, variation) return self.store:get(self:key(setting, variation or 0)) end

-- How the time grows when a number is refined: the median exponent over finished settings that differ in this number
-- alone. If there are none, it is the usual exponent, corrected by the growth of all finished settings.
function Bench:growth(input)
  local found, all = {}, {}
  for i, a in ipairs(self.timed) do
    for j = 1, i - 1 do
      local b = self.timed[j]
      local alone = a.values[input.name] ~= b.values[input.name]
      for _, other in ipairs(self.inputs) do
        alone = alone and (other == input or a.values[other.name] == b.values[other.name])
      end
      if a.weight ~= b.weight then all[#all + 1] = math.log(a.seconds / b.seconds) / math.log(a.weight / b.weight) end
      if alone then
        found[#found + 1] = math.log(a.seconds / b.seconds)
          / math.log(ladder.finer(input, a.values[input.name], b.values[input.name]))
      end
    end
  end
  return math.max(0, compare.median(found) or input.side.work * (compare.median(all) or 1))
end

local other_method = 1e3 -- farther away than any amount of work of the same method

--- Seconds that a setting would take once, from the finished setting of its method with the nearest amount of work. 0
-- if nothing is known yet, and for a finished setting.
function Bench:estimate(setting, variation)
  if self:record(setting, variation) or #self.timed == 0 then return 0 end
  local nearest, from = math.huge, nil
  for _, known in ipairs(self.timed) do
    local apart = math.abs(math.log(setting.weight / known.weight))
    for _, input in ipairs(self.inputs) do
      local same = input.side or setting.values[input.name] == known.values[input.name]
      apart = apart + (same and 0 or other_method)
    end
    if apart <= nearest then nearest, from = apart, known end
  end
  local seconds = from.seconds
  for _, input in ipairs(self.inputs) do
    if input.side then
      seconds = seconds * ladder.finer(input, setting.values[input.name], from.values[input.name]) ^ self:growth(input)
    end
  end
  return seconds
end

local function took(record) return record.seconds[1] + record.outside end

function Bench:measure(setting, variation)
  local change = variation > 0 and changes.of { vary = variation * self.part / changes.part } or nil
  return measure.once(self.scenario, self:parameters(setting, variation), self.case,
    self.budget and self.start + self.budget, setting.without, change)
end

--- The measurement of a setting: the kept one, or a new one. nil if the budget ended it.
function Bench:run(setting, variation)
  local key = self:key(setting, variation or 0)
  local record = self.store:get(key)
  if not record then
    record = self:measure(setting, variation or 0)
    if not record then return nil end
    record.seconds, record.outside = { record.seconds }, record.outside or 0
    self.store:put(key, record)
  end
  if not record.failed then
    self.timed[#self.timed + 1] = { weight = setting.weight, values = setting.values, seconds = took(record) }
  end
  return record
end

--- Times a finished setting once more. Its answers should not change. The names of answers that did are put into
-- `moving`.
function Bench:time_again(setting, moving)
  local record, again = self:record(setting), self:measure(setting, 0)
  if not again or again.failed then return end
  if again.seconds < math.min(table.unpack(record.seconds)) then record.stages = again.stages end
  record.seconds[#record.seconds + 1] = again.seconds
  record.outside = math.min(record.outside, again.outside)
  for name, answer in pairs(record.answers) do
    if compare.error(again.answers[name], answer) > 0 then moving[name] = true end
  end
  record.moving = moving
end

--- Keeps the new times of a setting.
function Bench:keep(setting) self.store:put(self:key(setting, 0), self:record(setting)) end

--- Times settings again, one after the other so that a slow moment of the machine affects all of them. Returns the
-- names of answers that differed from one time to the next. enough: s; what takes less is timed more often, until all
-- its times together are that long; default 0.1.
function Bench:time_alternately(compared, repeats, enough)
  local moving = {}
  for _, s in ipairs(compared) do
    for name in pairs(s.record.moving or {}) do moving[name] = true end
  end
  local again = {}
  for round = 2, repeats > 1 and most_repeats or 1 do
    for i, s in ipairs(compared) do
      local seconds = s.record.seconds
      if #seconds < round and (round <= repeats or compare.median(seconds) * #seconds < (enough or 0.1))
        and self:fits(seconds[1] + s.record.outside) then
        self:progress(("timing %d, %s"):format(round, s.label), i - 1, #compared,
          math.max(1, repeats - round + 1) * seconds[1])
        self:time_again(s, moving)
        again[s] = true
      end
    end
  end
  for s in pairs(again) do self:keep(s) end
  return moving
end

--- Seconds that the changed runs of a setting would take: see scatter. `like`: a setting with known changed runs.
function Bench:changed_runs(setting, like)
  local seconds = 0
  for variation = 1, perturbations do
    if not self:record(setting, variation) then
      seconds = seconds + math.max(self:estimate(setting, variation), self:estimate(like, variation))
    end
  end
  return seconds
end

--- By name, the scatter of a setting's answers when physical numbers change by a part of 1e-9. nil and the reason where
-- the budget left no time.
function Bench:scatter(setting)
  local scatter = {}
  for variation = 1, perturbations do
    self:progress("changed slightly, " .. setting.label, variation - 1, perturbations,
      (perturbations - variation + 1) * self:estimate(setting, variation))
    local record = (self:record(setting, variation) or self:fits(self:estimate(setting, variation)))
      and self:run(setting, variation)
    if not record then return next(scatter) and scatter or nil, "the budget ended before the check for chaos" end
    for name, answer in pairs(setting.record.answers) do
      local error = record.failed and math.huge or compare.error(record.answers[name], answer)
      scatter[name] = compare.larger(scatter[name] or 0, error)
    end
  end
  return scatter
end

--- Runs each setting a few times more, with physical numbers changed slightly, and keeps the records in `varied` of it.
-- Returns what failed, or what the budget left out.
function Bench:vary(compared)
  local left_out, failed = {}, 0
  for i, s in ipairs(compared) do
    s.varied = {}
    for k = 1, few do
      local own = s.record.seconds[1] + s.record.outside
      self:progress("changed slightly, " .. s.label, i - 1, #compared, (few - k + 1) * own)
      local record = (self:record(s, k) or self:fits(own)) and self:run(s, k)
      if not record then
        left_out[#left_out + 1] = s
        break
      end
      if record.failed then failed = failed + 1 else s.varied[#s.varied + 1] = record end
    end
  end
  local notes = {}
  if failed > 0 then notes[1] = ("%d runs that were changed slightly failed"):format(failed) end
  if #left_out > 0 then
    notes[#notes + 1] = ("the budget left out runs that show the scatter of %d of %d settings, such as %s, "
      .. "about %.2g s each"):format(#left_out, #compared, left_out[1].label, left_out[1].record.seconds[1])
  end
  return notes[1] and table.concat(notes, "; ")
end

--- A line on stderr: the work in hand, its progress, and the time left.
function Bench:progress(what, done, all, left)
  if not self.say or self.said and core.clock() - self.said < 0.5 then return end
  self.said = core.clock()
  local filled = all > 0 and math.floor(20 * done / all) or 20
  local spent = self.budget and ("%.1f s of %.3g s"):format(self:elapsed(), self.budget)
    or ("%.1f s"):format(self:elapsed())
  io.stderr:write(("cost [%s%s] %d of %d, %s, about %.3g s left: %s\n")
    :format(("#"):rep(filled), ("-"):rep(20 - filled), done, all, spent, left, what))
end

return { open = open, label = ladder.label }
