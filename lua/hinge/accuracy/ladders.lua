-- What the runs of a search say of the errors: ladders of runs, one for each number that is varied (a knob).
--
-- A setting is a table of levels, { dt = -1, elements = 0 }: level 0 is the script's own value, each level above it is
-- a refinement by the knob's ratio. The ladder of the first knob, which is the time step or the load step, stands at
-- the coarsest levels of the others. Theirs stand at a coarse level of the first. Errors of several knobs add up.
local check = require "hinge.library.check"
local compare = require "hinge.cost.compare"
local estimate = require "hinge.accuracy.estimate"
local statistics = require "hinge.accuracy.statistics"

local Ladders = {}
Ladders.__index = Ladders

local rounding = 1e-12 -- of the unit: an answer below it is 0
local no_matter = 1e-9 -- of the unit: a difference that matters in no answer
local longest = 4      -- values of a ladder that count, the finest ones

--- knobs: { { name =, theory = order, ratio =, work = exponent of the work over the ratio (1), least = level, most =
-- level }, ... }; corner: their coarsest levels.
-- accepted: the part by which answers may change and pass for settled. least: by name, the size below which errors are
-- parts of this size, and no longer of the answer itself (default: none).
function Ladders.new(knobs, corner, accepted, least)
  return setmetatable({ accepted = accepted, least = least or {}, smallest = no_matter / (2 * accepted),
    knobs = knobs, corner = corner, coarse = corner, records = {}, chaotic = {} }, Ladders)
end

--- These levels with another one of a knob.
function Ladders.with(levels, name, level)
  local new = {}
  for key, value in pairs(levels) do new[key] = value end
  new[name] = level
  return new
end

function Ladders:key(levels)
  local parts = {}
  for i, knob in ipairs(self.knobs) do parts[i] = knob.name .. " " .. levels[knob.name] end
  return table.concat(parts, ", ")
end

--- Keeps a run: of these levels, varied so many times (0: not).
function Ladders:keep(levels, vary, record)
  local key = self:key(levels)
  self.records[key] = self.records[key] or {}
  self.records[key][vary] = record
end

--- The run of these levels that has an answer, nil where there is none.
function Ladders:at(levels, vary)
  local record = (self.records[self:key(levels)] or {})[vary or 0]
  return record and not record.failed and record or nil
end

--- All values of an answer at these levels, that of the run that is not varied first.
function Ladders:values(levels, name)
  local all = {}
  for vary = 0, math.huge do
    local record = self:at(levels, vary)
    if not record then break end
    if record.answers[name] ~= nil then all[#all + 1] = record.answers[name] end
  end
  return all
end

--- The answer at these levels: of a chaotic one the mean of its runs. nil where there is none.
function Ladders:answer(levels, name)
  if self.chaotic[name] then
    local mean = statistics.mean(self:values(levels, name))
    if mean then return mean end
  end
  local record = self:at(levels)
  return record and record.answers[name]
end

--- Where the ladder of a knob stands.
function Ladders:place(knob) return knob == self.knobs[1] and self.corner or self.coarse end

--- The levels of a knob's ladder that have been run, the coarsest first.
function Ladders:levels(knob)
  local levels, place = {}, self:place(knob)
  for level = knob.least, knob.most do
    if self:at(Ladders.with(place, knob.name, level)) then levels[#levels + 1] = level end
  end
  return levels
end

--- Size of an answer with these values, of which errors are parts: that of its finest value; where this is 0, of its
--- largest.
function Ladders:size(name, answers)
  local size = compare.size(answers[#answers])
  if not (size > rounding) then
    for _, a in ipairs(answers) do size = compare.larger(size, compare.size(a)) end
  end
  size = compare.larger(size, self.least[name] or 0)
  return size > rounding and compare.larger(size, self.smallest) or 0
end

--- The size below which errors are no longer parts of an answer itself.
function Ladders:smallest_of(name) return compare.larger(self.least[name] or 0, self.smallest) end

local function is_whole(answers)
  for _, a in ipairs(answers) do
    if math.type(a) ~= "integer" then return false end
  end
  return true
end

-- What settings say of an answer, the coarsest first: see estimate.along; and answers and size of them. h: their step
-- sizes; twice: see there. A number that counts something is wrong by 1 at least, where it changes at all.
function Ladders:along_settings(settings, h, theory, name, twice)
  local answers = {}
  for i, levels in ipairs(settings) do answers[i] = self:answer(levels, name) end
  if #answers == 0 or #answers < #settings then return { by = "open", error = math.huge, size = 0 } end
  local size, finest = self:size(name, answers), compare.size(answers[#answers])
  local found = self.chaotic[name] and self:along_means(settings, name, answers)
    or estimate.along(h, answers, theory, self.accepted * (finest > 0 and size / finest or 1), twice)
  found.answers, found.size = answers, size
  if found.size == 0 and found.by ~= "open" then found.by, found.error = "exact", 0 end
  local whole = not self.chaotic[name] and is_whole(answers)
  found.whole = whole
  if whole and found.by ~= "exact" then found.error = math.max(1, math.ceil(found.error)) end
  return found
end

local function step_of(knob, level) return knob.h and knob.h(level) or knob.ratio ^ -level end

--- What the ladder of a knob says of an answer: see along_settings; and levels, of its finest values.
function Ladders:along(knob, name)
  local all, h, settings, levels = self:levels(knob), {}, {}, {}
  for i = math.max(1, #all - longest + 1), #all do
    levels[#levels + 1], h[#h + 1] = all[i], step_of(knob, all[i])
    settings[#settings + 1] = Ladders.with(self:place(knob), knob.name, all[i])
  end
  local found = self:along_settings(settings, h, knob.theory, name)
  found.levels = levels
  return found
end

--- What settings say of which each is a level finer in several knobs, the coarsest first.
function Ladders:along_line(line, name)
  local h, theory = {}, math.huge
  for _, knob in ipairs(self.knobs) do
    if line[1][knob.name] ~= line[#line][knob.name] then
      theory = math.min(theory, knob.theory)
      for i, levels in ipairs(line) do h[i] = h[i] or step_of(knob, levels[knob.name]) end
    end
  end
  return self:along_settings(line, h, theory, name, true)
end

-- Of a chaotic answer: means differ by scatter, so no order can be seen. The error is the last difference where it is
-- beyond scatter, else none; the band of the mean counts beside it.
function Ladders:along_means(settings, name, answers)
  local n = #answers
  if n < 2 then return { by = "open", error = math.huge, answer = answers[n] } end
  if not self:apart(settings[n - 1], settings[n], name) then
    return { by = "scatter", error = 0, answer = answers[n] }
  end
  return { by = "change", error = compare.distance(answers[n - 1], answers[n]), answer = answers[n] }
end

-- The error of an answer at a level: at the finest what the ladder leaves; at a coarser one the way to the best known
-- value as well.
local function error_at(found, level)
  local n = #found.levels
  if n == 0 or level >= found.levels[n] then return found.error end
  for i, at in ipairs(found.levels) do
    if at == level then return compare.distance(found.answers[i], found.answer) + found.error end
  end
  return math.huge
end

local function part_of(error, size) return size > 0 and error / size or not (error <= rounding) and math.huge or 0 end
Ladders.part_of = part_of

--- The error of an answer at the finest level of a knob, as a part of it; 0 where means do not differ beyond scatter.
function Ladders:part(knob, name)
  local found = self:along(knob, name)
  return part_of(found.error, found.size), found
end

--- Errors at these levels by answer: { total =, parts = { knob = part of the answer }, found = { knob = along } }.
function Ladders:errors(levels, names)
  local all = {}
  for _, name in ipairs(names) do
    local e = { total = 0, parts = {}, found = {} }
    for _, knob in ipairs(self.knobs) do
      local found = self:along(knob, name)
      local part = part_of(error_at(found, levels[knob.name]), found.size)
      e.parts[knob.name], e.found[knob.name], e.total = part, found, e.total + part
    end
    all[name] = e
  end
  return all
end

--- Whether the means of a chaotic answer at two settings differ by more than their scatter (Welch's test, 95 %).
function Ladders:apart(coarse, fine, name)
  local sides = {}
  for i, levels in ipairs { coarse, fine } do
    local mean, deviation, runs = statistics.mean(self:values(levels, name))
    if not mean then return true end
    sides[i] = { mean = mean, deviation = deviation, runs = runs }
  end
  return statistics.apart(sides[1], sides[2])
end

--- The answer with the largest error, and that error; nil and 0 where no answer counts.
function Ladders.worst(all)
  local name, most = nil, 0
  for _, candidate in ipairs(check.keys(all)) do
    if not name or not (all[candidate].total <= most) then name, most = candidate, all[candidate].total end
  end
  return name, most
end

--- How an answer at these levels differs from the sum of what the ladders say, as a part of its size: what the knobs do
--- to each other. 0 where the setting is on a ladder.
function Ladders:interplay(levels, name)
  local first = self.knobs[1]
  local own = self:answer(levels, name)
  if own == nil then return math.huge end
  local parts = { self:answer(Ladders.with(self:place(first), first.name, levels[first.name]), name) }
  for i = 2, #self.knobs do
    local knob = self.knobs[i]
    local place = self:place(knob)
    parts[#parts + 1] = self:answer(Ladders.with(place, knob.name, levels[knob.name]), name)
    parts[#parts + 1] = self:answer(place, name)
  end
  if #parts < 2 * #self.knobs - 1 then return 0 end
  local sum = compare.combined(function(...)
    local value = (...)
    for i = 2, select("#", ...), 2 do value = value + (select(i, ...)) - (select(i + 1, ...)) end
    return value
  end, table.unpack(parts))
  if not sum then return math.huge end
  return part_of(compare.distance(own, sum), self:size(name, { own }))
end

return Ladders
