-- hinge.study and hinge study: a scenario with many values, each case in a process of its own.
local core = require "hinge.core"
local case = require "hinge.study.case"
local check = require "hinge.library.check"
local files = require "hinge.study.files"
local job = require "hinge.program.job"
local journal = require "hinge.study.journal"
local pool = require "hinge.study.pool"
local scenarios = require "hinge.program.scenario"
local tables = require "hinge.study.table"
local vary = require "hinge.study.vary"
local quote = require "hinge.library.quote"

local study = {}
local main_journal = "cases.jsonl"

-- A study as it runs. Of it users see cases (those that have ended, in order), varied, folder and interrupted; `ended`
-- has the same cases by number.
local Study = {}
local class = check.class(Study)

local function new(options)
  local plan, proposed = options.plan, options.propose ~= nil
  local all, varied = {}, {}
  if not proposed then all, varied = vary.cases(plan) end
  for _, name in ipairs(varied) do tables.check_parameter(name) end
  local self = setmetatable({ options = options, all = all, varied = varied, said = plan.said, script = options.script,
    has_cases = plan.cases ~= nil, proposed = proposed, planned = not proposed and #all or nil, cases = {}, ended = {},
    queue = {}, at = 0, seen = {}, digits = math.max(5, #tostring(#all)) }, class)
  for number, one in ipairs(all) do self:prepare(one, number) end
  return self
end

-- A case's folder within the study's.
function Study:place(number) return ("cases/%0" .. self.digits .. "d"):format(number) end

-- Gives a case its number and what it has in common with the others.
function Study:prepare(one, number)
  local options = self.options
  for name, value in pairs(options.fixed or {}) do
    if one.parameters[name] == nil then one.parameters[name] = value end
  end
  one.case, one.number = one.case or options.plan.case, number
  local overrides = case.overrides(one.parameters)
  one.id = core.fingerprint(core.to_json { case = one.case, parameters = overrides, setting = options.setting })
  if options.scenario then options.scenario:values(one.case, overrides) end
end

-- Opens the folder, and reads what has ended in it: self.found, by identity.
function Study:open()
  local options = self.options
  self.folder = job.own_output(options.out, options.owner, options.out_given)
  -- Tasks of a job array write to cases and journals of their own, so several may be at work, as may --collect.
  core.lock(self.folder, (options.only ~= nil or options.collect) and not options.restart)
  self.found = journal.read(self.folder)
  local n = #check.keys(self.found)
  if n > 0 and not options.resume and not options.restart then
    check.fail("%s holds %s of a study; --resume goes on with it (resume = true), --restart begins anew, or give "
      .. "another --out", self.folder, check.count(n, "case"))
  end
  if options.restart or n == 0 and not options.resume then
    os.execute("rm -rf " .. quote.shell(self.folder .. "/cases"))
    journal.remove(self.folder)
    self.found = {}
  end
end

-- Takes a case from what was found.
function Study:keep(one, entry)
  entry.number, entry.folder = one.number, self:place(one.number)
  self.ended[one.number] = entry
end

-- Renews the list of cases that have ended.
function Study:list()
  local numbers = {}
  for number in pairs(self.ended) do numbers[#numbers + 1] = number end
  table.sort(numbers)
  self.cases = {}
  for i, number in ipairs(numbers) do self.cases[i] = self.ended[number] end
end

-- Whether what an earlier run found is still what this one would find; if not, why, where that is to be said.
function Study:holds(entry)
  if not case.finished(entry.verdict) then return false end
  if entry.engine ~= core.engine() then return false, "hinge is another version or build" end
  self.same = self.same or files.comparison()
  local same, changed = self.same(entry.files or {})
  return same, changed and changed .. " has changed"
end

-- Adds a case to those that are to run, unless it has ended before. Returns why one that has ended runs again.
function Study:add(one)
  local entry, holds, why = self.found[one.id], false, nil
  if entry then holds, why = self:holds(entry) end
  if holds then self:keep(one, entry) else self.queue[#self.queue + 1] = one end
  return why
end

-- Adds the cases that are known from the beginning, and says once why finished ones run again.
function Study:add_all()
  local counts, only = {}, self.options.only
  for number, one in ipairs(self.all) do
    local why = (not only or only[number]) and self:add(one)
    if why then counts[why] = (counts[why] or 0) + 1 end
  end
  for why, n in pairs(counts) do
    io.stderr:write(("%s: %s again\n"):format(why, n == 1 and "1 case runs" or n .. " cases run"))
  end
end

-- Adds a case that a function has proposed.
function Study:add_proposed(parameters)
  local one = { parameters = parameters }
  self:prepare(one, #self.all + 1)
  if self.seen[one.id] then
    check.fail("hinge.study: propose returned the parameters of case %d again; a study that would never end",
      self.seen[one.id])
  end
  self.all[one.number], self.seen[one.id] = one, one.number
  local known = {}
  for name in pairs(self.options.fixed or {}) do known[name] = true end
  for _, name in ipairs(self.varied) do known[name] = true end
  for _, name in ipairs(check.keys(parameters)) do
    tables.check_parameter(name)
    if not known[name] then self.varied[#self.varied + 1] = name end
  end
  self:add(one)
end

-- Asks for further cases. Returns whether there are some.
function Study:ask()
  self:list()
  local proposed = self.options.propose(self.cases)
  if proposed == nil then return false end
  local list = type(proposed) == "table" and (#proposed > 0 and proposed or { proposed }) or { proposed }
  for _, parameters in ipairs(list) do
    if type(parameters) ~= "table" then
      check.fail("hinge.study: propose returned %s; must be a table of parameters, a list of them, or nil",
        check.show(proposed))
    end
    self:add_proposed(parameters)
  end
  return true
end

-- The next task of the pool, or nil where there is none now; running: how many are under way.
function Study:next(running)
  local options = self.options
  while self.at == #self.queue and options.propose and running == 0 and self:ask() do end
  local one = self.queue[self.at + 1]
  if not one then return nil end
  self.at = self.at + 1
  return { number = one.number, one = one, folder = self.folder .. "/" .. self:place(one.number),
    resume = options.resume, what = { scenario = options.scenario, script = options.script,
      case = one.case, overrides = case.overrides(one.parameters), varied = self.varied } }
end

-- A task of the pool has ended: a case as users and journals see it.
function Study:done(task, outcome)
  if outcome.verdict == "interrupted" then return end
  local one = task.one
  local entry = {
    id = one.id, number = one.number, case = one.case, parameters = one.parameters, verdict = outcome.verdict,
    reason = outcome.reason, cause = outcome.cause, results = outcome.results,
    energy_error = outcome.energy_error, steps = outcome.steps,
    warnings = outcome.warnings, seconds = outcome.seconds, memory = outcome.memory, files = outcome.files,
    engine = core.engine(),
    folder = self:place(one.number),
  }
  self.ended[one.number] = entry
  journal.add(self.folder, self.options.journal or main_journal, entry)
end

-- Runs what has not ended.
function Study:run()
  local options = self.options
  self:add_all()
  self:list()
  local kept = #self.cases
  local show = options.progress and require "hinge.study.progress".new {
    total = not self.proposed and #self.queue + kept or nil, kept = kept, jobs = options.jobs }
  local whole = pool.run(function(running) return self:next(running) end, function(task, outcome)
    if show then show.ended(task, outcome) end
    self:done(task, outcome)
  end, function(running) if show then show.tick(running) end end, options)
  if show then show.close() end
  self.interrupted = not whole
end

--- How many cases have each verdict.
function study.describe(cases)
  local counts = {}
  for _, c in ipairs(cases) do counts[c.verdict] = (counts[c.verdict] or 0) + 1 end
  return counts
end

--- What warnings of runs are in cases: how many cases have some, and the first of them; nil where none has.
function study.warned(cases)
  local count, first = 0, nil
  for _, c in ipairs(cases) do
    if c.warnings and c.warnings[1] then
      count, first = count + 1, first or c
    end
  end
  return first and { cases = count, first = first.number, text = first.warnings[1] } or nil
end

--- Writes results.csv, times.csv, summary.json and the pictures of all cases that have ended.
function study.write(of)
  local write = function(name, text) core.write_text(of.folder .. "/" .. name, text) end
  tables.write(write, of)
  journal.write(of.folder, main_journal, of.cases)
  core.write_json(of.folder .. "/summary.json", {
    verdict = of.interrupted and "stopped" or "completed", hinge = core.version, script = of.script,
    study = of.said, cases = #of.cases, planned = of.planned, verdicts = study.describe(of.cases),
    accuracy = of.accuracy, quantities = tables.columns_of(of), pictures = of.pictures, warned = study.warned(of.cases),
  })
end

--- Runs a study. options: scenario or script (path; of plain statements), plan (list, cases, rows, row_names, samples,
-- seed, method, said), propose and fixed (parameters that all cases have then), jobs, timeout, memory, out, out_given,
-- resume, restart, progress, only (numbers of the cases to run, as a set) with journal (name), list (run nothing),
-- collect (run nothing, and take what has ended), within (see accuracy/study.lua). Returns the study as hinge.study
-- does; all has all its cases.
function study.go(options)
  files.watch()
  files.note(options.script)
  options.owner = { script = options.script and core.whole_path(options.script), study = options.plan.said }
  local accuracy = options.within and require "hinge.accuracy.study"
  local _ <close> = accuracy and setmetatable({}, { __close = accuracy.leave })
  local choice = accuracy and accuracy.choose(options)
  local of = new(options)
  of.choice = choice and accuracy.line(options, choice)
  if options.list then return of end
  of:open()
  if options.collect then
    for _, one in ipairs(of.all) do
      local entry = of.found[one.id]
      if entry then of:keep(one, entry) end
    end
  else
    of:run()
  end
  of:list()
  if choice and not options.only then
    accuracy.leave()
    of.accuracy = accuracy.check(options, of, choice)
  end
  return of
end

local rules = {
  vary = { "table", default = {} }, cases = { "table", optional = true }, case = { "string", optional = true },
  table = { "string", optional = true }, samples = { "number", whole = true, above = 0, optional = true },
  seed = { "number", whole = true, at_least = 0, optional = true },
  method = { "string", one_of = { "lhs", "plain", "sobol" }, optional = true },
  propose = { "function", optional = true }, jobs = { "number", whole = true, above = 0, optional = true },
  timeout = { "number", unit = "s", above = 0, optional = true },
  memory = { "number", unit = "bytes", above = 0, optional = true }, out = { "string", default = "out/study" },
  resume = { "boolean", default = false }, restart = { "boolean", default = false },
  progress = { "boolean", default = false }, pictures = { "boolean", default = true },
  within = { "number", above = 0, optional = true }, budget = { "number", unit = "s", above = 0, optional = true },
  answers = { "table", optional = true },
}

-- What within, budget and answers ask for; nil without within.
local function within_of(where, o)
  for _, name in ipairs { "budget", "answers" } do
    if o[name] and not o.within then check.fail("%s: field '%s' has no effect without within", where, name) end
  end
  if o.answers then require "hinge.accuracy.answers".check(where .. ": answers", o.answers) end
  return o.within and { within = o.within, budget = o.budget, answers = o.answers, where = where .. ": within" }
end

--- hinge.study: see words/study.d.lua.
function study.run(scenario, options, ...)
  local where = "hinge.study"
  check.no_more(where, ...)
  if not scenarios.is(scenario) then
    check.fail("%s: the scenario is %s; give what hinge.scenario returned", where, check.show(scenario))
  end
  local o = check.options(where, options, rules)
  local plan = { list = vary.from_table(o.vary), cases = o.cases, case = o.case, samples = o.samples, seed = o.seed,
    method = o.method, said = core.to_json(o.vary) }
  if o.table then plan.rows, plan.row_names = vary.rows(o.table) end
  if not o.propose then vary.add_own(plan, scenario) end
  local fixed = o.propose and vary.fixed(plan, where .. ": propose", "")
  local before, output = job.use(nil), job.current_output()
  local _ <close> = setmetatable({}, { __close = function() -- also after an error: the run has its folder back
    job.use(before)
    if core.out_dir() ~= output[1] then core.unlock(core.out_dir()) end
    job.restore_output(output)
  end })
  local source = debug.getinfo(scenario.run, "S").source:match "^@(.*)$"
  local of = study.go { scenario = scenario, script = source, plan = plan, propose = o.propose, fixed = fixed,
    jobs = o.jobs or core.cores(), timeout = o.timeout, memory = o.memory, out = o.out, out_given = true,
    resume = o.resume, restart = o.restart, progress = o.progress, within = within_of(where, o) }
  if o.pictures then of.pictures = require "hinge.study.pictures".draw(of) end
  study.write(of)
  return of
end

return study
