-- Runs of a script with changed settings: measured in this process, or made in full into the output folder by a process
-- of its own. What was measured is kept between calls.
local core = require "hinge.core"
local changes = require "hinge.accuracy.changes"
local job = require "hinge.program.job"
local knobs = require "hinge.accuracy.knobs"
local measure = require "hinge.cost.measure"
local runner = require "hinge.program.runner"
local store = require "hinge.cost.store"

local Runs = {}
Runs.__index = Runs

local interrupted = 130 -- exit status, as after Ctrl-C
-- Times the steps of Newmark's run: with more, explicit steps are not faster. They take a third to a half of the time.
local worth_it = 1.4
local late_part = 1.5 -- of the time that is left
Runs.late = "it took too long"
local same_end = 0.05 -- of its duration: a run that ends farther from where the first one ended was ended by the script

--- o: script (path), scenario (nil for plain statements), case, overrides, parameters (what they say), out (folder),
-- out_given, budget (s, nil: none), say (function of a text).
function Runs.open(o)
  local self = setmetatable({ o = o, began = core.clock(), asked = {}, seconds = 0, wall = 0, slowness = 1 }, Runs)
  self.store = store.open(o.out .. "/accuracy", o.scenario and o.scenario.run or o.script)
  return self
end

function Runs:elapsed() return core.clock() - self.began end

--- Whether so many seconds of the processor are left: of the budget, which is time of the clock, or of `most`.
function Runs:fits(seconds)
  if self.o.budget and self:elapsed() + seconds * self.slowness > self.o.budget then return false end
  return self.o.budget or not self.most or self.seconds + seconds <= self.most
end

-- A run has been made: its time, and how much longer the clock takes than the processor.
function Runs:count(record)
  self.seconds, self.wall = self.seconds + record.seconds, self.wall + (record.wall or record.seconds)
  self.slowness = math.max(1, self.wall / math.max(1e-3, self.seconds))
end

-- The scenario's parameters with those of a setting.
function Runs:parameters(set)
  if not self.o.scenario then return {} end
  local p = self.o.scenario:values(self.o.case, self.o.overrides)
  for name, value in pairs(set) do p[name] = value end
  return p
end

-- The overrides of the command line with those of a setting.
function Runs:overrides(set)
  local list = table.move(self.o.overrides, 1, #self.o.overrides, 1, {})
  local case = require "hinge.study.case"
  for _, name in ipairs(require "hinge.library.check".keys(set)) do
    list[#list + 1] = { name, case.text(set[name]) }
  end
  return list
end

local function key_of(self, set, factors, vary)
  local given = {}
  for i, pair in ipairs(self.o.overrides) do given[i] = pair end
  return store.key({ given = given, set = set, factors = factors, vary = vary, case = self.o.case or "",
    integrator = factors.integrator or self.integrator or "" })
end

-- What is kept of a measurement. Its time is that of the processor: other programs that use the machine do not change
-- what a search chooses.
local function plain_record(record, began)
  if not record then return nil end
  record.wall = record.seconds + (record.outside or 0)
  record.seconds = os.clock() - began
  record.stages, record.memory = nil, nil
  local work = 0
  for _, run in ipairs(record.runs) do work = work + run.steps * run.elements end
  record.work = work > 0 and work or nil
  return record
end

-- Runs the script once, and writes nothing.
function Runs:once(set, factors, vary, until_then)
  local o = self.o
  local with = {}
  for name, value in pairs(factors) do with[name] = value end
  with.vary, with.integrator = vary, factors.integrator or self.integrator
  local deadline = until_then or o.budget and self.began + o.budget
  local change = changes.of(with, self.asked)
  if o.scenario then return measure.once(o.scenario, self:parameters(set), o.case, deadline, nil, change) end
  local plain = { run = function()
    local _, results, _, all_read = runner.load(o.script, self:overrides(set))
    if all_read then all_read() end
    return results
  end }
  return measure.once(plain, {}, nil, deadline, nil, change)
end

-- Where no budget is given: a run ends that takes far longer than what is left, since a forecast may be wrong.
function Runs:time_left()
  if self.o.budget or not self.most then return nil end
  local until_then = os.clock() + late_part * math.max(0, self.most - self.seconds)
  return function() return os.clock() > until_then end
end

--- The measurement of a setting: the kept one, or a new one; nil where the budget ended it.
function Runs:measure(set, factors, vary, deadline)
  local key = key_of(self, set, factors, vary)
  local record = self.store:get(key)
  if record then
    self.asked.explicit = self.asked.explicit or record.explicit
    self.asked.damps = self.asked.damps or record.damps
  else
    local began = os.clock()
    deadline = deadline or self:time_left()
    record = plain_record(self:once(set, factors, vary, deadline), began)
    if not record and deadline then record = { failed = Runs.late, seconds = os.clock() - began } end
    if not record then return nil end
    record.explicit, record.damps = self.asked.explicit, self.asked.damps
    self:count(record)
    if record.failed ~= Runs.late then self.store:put(key, record) end
  end
  return record
end

--- Whether a run ended where the first one did; else why its answers are not those of another time step.
function Runs.ends_alike(record, first)
  if record.failed then return true end
  if #record.runs ~= #first.runs then return true end -- the script itself makes more or fewer
  for i, run in ipairs(record.runs) do
    local other = first.runs[i]
    if run.kind == "dynamic" and math.abs(run.ended - other.ended) > same_end * math.abs(other.ended) then
      return false
    end
  end
  return true
end

-- In the process of its own: runs the script as hinge run does, and leaves the measurement in a file.
local function in_full(self, set, factors, file, folder)
  local o, began = self.o, os.clock()
  local results, status
  local record = measure.watch(function()
    status = runner.guard(function()
      return runner.run { scenario = o.scenario, script = o.script, case = o.case, overrides = self:overrides(set),
        out = folder, out_given = true, see = function(returned) results = returned end }
    end)
    return results
  end, nil, nil, changes.of({ dt = factors.dt, elements = factors.elements, steps = factors.steps,
    integrator = self.integrator }, self.asked))
  record = plain_record(record, began)
  record.status = status
  if status ~= 0 and not record.failed then record.failed = "the script ended with status " .. status end
  core.write_text(file, store.key(record))
  return status
end

local function read(path)
  local file = io.open(path, "rb")
  local text = file and file:read "a"
  if file then file:close() end
  return text
end

--- Makes a setting's run in full, into the output folder. Returns its record, or nil and the status of its process.
function Runs:in_full(set, factors)
  local folder, file = self.folder, self.o.out .. "/accuracy/chosen.lua"
  os.remove(file)
  os.remove(self.o.out .. "/accuracy/output.txt") -- of a run before
  core.unlock(folder)
  local process = core.start(function() return in_full(self, set, factors, file, folder) end,
    self.o.out .. "/accuracy/output.txt", 0, false)
  while true do
    local ended, _, code = core.wait(0.2)
    if ended == "interrupted" then
      core.kill(process, true)
      while core.wait(10, true) ~= process do end
      os.exit(interrupted, true)
    end
    if ended == process then
      local text = read(file)
      local f = text and load("return " .. text, "chosen", "t", {})
      local record = f and f()
      if record then self:count(record) end
      return record, code
    end
    self.o.tick()
  end
end

--- The folder that the chosen run writes to.
function Runs:own_folder()
  local o = self.o
  if self.folder then return self.folder end
  local before = job.current_output()
  self.folder = job.own_output(o.out, { script = o.script and core.whole_path(o.script), case = o.case,
    parameters = o.parameters }, o.out_given)
  core.own_output(before[1] == "" and "" or before[1], before[2], true)
  return self.folder
end

--- What the script printed in the chosen run.
function Runs:printed() return read(self.o.out .. "/accuracy/output.txt") or "" end

local function steps_of(record)
  local steps = 0
  for _, run in ipairs(record.runs) do steps = steps + (run.kind == "dynamic" and run.steps or 0) end
  return steps
end

-- Explicit steps in place of Newmark's, where something is struck and they take clearly less time: the record of a run
-- with them, which all runs have then. Two of their steps' lengths are needed to see an error.
function Runs:try_explicit(set, record)
  if self.asked.explicit or self.asked.damps or record.failed then return nil end
  if not (record.effects.contact or record.effects.ground) then return nil end
  if self.o.scenario and self.o.scenario.accuracy.integrator then return nil end
  local left = worth_it * steps_of(record)
  local quick = self:measure(set, { integrator = "explicit" }, 0, function()
    left = left - 1
    return left < 0
  end)
  if not quick or quick.failed or steps_of(quick) > worth_it * steps_of(record) then return nil end
  self.integrator, self.asked.explicit = "explicit", true
  return quick
end

--- The first run of all: with the coarsest values of what the scenario lists, and else steps of four times the length.
-- Returns its record, the knobs and the corner.
function Runs:first()
  local set, factors = {}, { dt = 2.0 ^ -knobs.first_step }
  local record
  if self.o.scenario then
    local listed = knobs.of(self.o.scenario, self.o.parameters, { runs = {} }, {})
    for _, knob in ipairs(listed) do
      set[knob.name] = knob.value(knob.start)
      if knob.name == "dt" then factors.dt = nil end
    end
  end
  record = self:measure(set, factors, 0)
  if not record then return nil end
  record = self:try_explicit(set, record) or record
  local all, corner = knobs.of(self.o.scenario, self.o.parameters, record, self.asked)
  return record, all, corner
end

return Runs
