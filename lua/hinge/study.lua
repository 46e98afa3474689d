-- hinge.study and hinge study: a scenario with many values, each case in a process of its own.
local core = require "hinge.core"
local case = require "hinge.study.case"
local check = require "hinge.check"
local files = require "hinge.study.files"
local job = require "hinge.job"
local journal = require "hinge.study.journal"
local pool = require "hinge.study.pool"
local scenarios = require "hinge.scenario"
local vary = require "hinge.study.vary"

local study = {}
local main_journal = "cases.jsonl"

local function id_of(one)
  return core.fingerprint(core.to_json { case = one.case, parameters = case.overrides(one.parameters) })
end

-- A case as users and journals see it.
local function entry_of(study_of, one, outcome)
  return {
    id = one.id, number = one.number, case = one.case, parameters = one.parameters, verdict = outcome.verdict,
    reason = outcome.reason, results = outcome.results, energy_error = outcome.energy_error, steps = outcome.steps,
    seconds = outcome.seconds, memory = outcome.memory, files = outcome.files, engine = core.engine(),
    folder = ("cases/%s"):format(study_of.name_of(one.number)),
  }
end

-- Whether what an earlier run found is still what this one would find.
local function still_holds(entry)
  if not case.finished(entry.verdict) then return false end
  if entry.engine ~= core.engine() then return false, "hinge is another version or build" end
  local same, changed = files.same(entry.files or {})
  return same, changed and changed .. " has changed"
end

-- Says once why finished cases run again.
local function say_changed(counts)
  for why, n in pairs(counts) do
    io.stderr:write(("%s: %s again\n"):format(why, n == 1 and "1 case runs" or n .. " cases run"))
  end
end

-- The folder of a study: whose it is, what is in it already.
local function open_folder(options, plan)
  local owner = { script = options.script and core.whole_path(options.script), study = plan.said }
  local folder = job.own_output(options.out, owner, options.out_given)
  local found = journal.read(folder)
  local n = #check.keys(found)
  if n > 0 and not options.resume and not options.restart then
    check.fail("%s holds %s of a study; --resume goes on with it (resume = true), --restart begins anew, or give "
      .. "another --out", folder, check.count(n, "case"))
  end
  if options.restart or n == 0 and not options.resume then
    os.execute(("rm -rf '%s/cases'"):format((folder:gsub("'", "'\\''"))))
    journal.remove(folder)
    found = {}
  end
  return folder, found
end

local function describe(cases)
  local counts = {}
  for _, c in ipairs(cases) do counts[c.verdict] = (counts[c.verdict] or 0) + 1 end
  return counts
end
study.describe = describe

--- Writes results.csv, times.csv, summary.json and the pictures of all cases that have ended.
function study.write(of)
  local write = function(name, text) core.write_text(of.folder .. "/" .. name, text) end
  require "hinge.study.table".write(write, of)
  journal.write(of.folder, main_journal, of.entries)
  core.write_json(of.folder .. "/summary.json", {
    verdict = of.interrupted and "stopped" or "completed", hinge = core.version, script = of.script,
    study = of.said, cases = #of.cases, planned = of.planned, verdicts = describe(of.cases),
    quantities = require "hinge.study.table".quantities(of.cases), pictures = of.pictures,
  })
end

-- The cases that run one after the other, in batches that a function proposes.
local function proposer(propose, of, add)
  return function()
    local proposed = propose(of.cases)
    if proposed == nil then return end
    if type(proposed) ~= "table" then
      check.fail("hinge.study: propose returned %s; must be a table of parameters, a list of them, or nil",
        check.show(proposed))
    end
    for _, parameters in ipairs(#proposed > 0 and proposed or { proposed }) do add { parameters = parameters } end
  end
end

-- What tasks have ended so far, in the order of the cases.
local function gathered(of, all, found)
  of.entries = {}
  for number, one in ipairs(all) do
    local entry = found[one.id]
    if entry then
      entry.number, entry.folder = number, ("cases/%s"):format(of.name_of(number))
      table.insert(of.entries, entry)
    end
  end
  of.cases = of.entries
  return of
end

--- Runs a study. options: scenario or script (path; of plain statements), plan (list, cases, rows, row_names, samples,
-- seed, method, said), fixed (parameters that all cases have), propose, jobs, timeout, memory, out, out_given, resume,
-- restart, progress, only (numbers of the cases to run, as a set) with journal (name), list (run nothing), collect (run
-- nothing, and take what has ended). Returns the study as hinge.study does, and of `list` all cases.
function study.go(options)
  files.watch()
  if options.script then files.note(options.script) end
  local plan = options.plan
  local all, varied = {}, {}
  if not options.propose then all, varied = vary.cases(plan) end
  local of = { cases = {}, entries = {}, varied = varied, said = plan.said, script = options.script,
    has_cases = plan.cases ~= nil,
    proposed = options.propose ~= nil }
  local digits = math.max(5, #tostring(#all))
  function of.name_of(number) return ("%0" .. digits .. "d"):format(number) end

  local function prepare(one, number)
    for name, value in pairs(options.fixed or {}) do
      if one.parameters[name] == nil then one.parameters[name] = value end
    end
    one.case = one.case or plan.case
    one.number, one.id = number, id_of(one)
    if options.scenario then options.scenario:values(one.case, case.overrides(one.parameters)) end
  end
  for number, one in ipairs(all) do prepare(one, number) end

  if options.list then return of, all end
  local found
  of.folder, found = open_folder(options, plan)
  of.planned = not options.propose and #all or nil
  if options.collect then return gathered(of, all, found) end

  local changed, queue, kept = {}, {}, 0
  local function add(one, number)
    local entry = found[one.id]
    if entry then
      local holds, why = still_holds(entry)
      if holds then
        entry.number, entry.folder = number, ("cases/%s"):format(of.name_of(number))
        of.entries[number], kept = entry, kept + 1
        return
      end
      if why then changed[why] = (changed[why] or 0) + 1 end
    end
    queue[#queue + 1] = one
  end
  for number, one in ipairs(all) do
    if not options.only or options.only[number] then add(one, number) end
  end
  say_changed(changed)

  local show = options.progress and require "hinge.study.progress".new {
    total = not options.propose and #queue + kept or nil, kept = kept, jobs = options.jobs }

  -- Cases in order, as far as they have ended.
  local function collect()
    local numbers = {}
    for number in pairs(of.entries) do numbers[#numbers + 1] = number end
    table.sort(numbers)
    of.cases = {}
    for i, number in ipairs(numbers) do of.cases[i] = of.entries[number] end
  end

  local at, proposed, seen = 0, 0, {}
  local more = options.propose and proposer(options.propose, of, function(one)
    proposed = proposed + 1
    prepare(one, proposed)
    if seen[one.id] then
      check.fail("hinge.study: propose returned the parameters of case %d again; a study that would never end",
        seen[one.id])
    end
    seen[one.id] = proposed
    for _, name in ipairs(check.keys(one.parameters)) do
      local known = (options.fixed or {})[name] ~= nil
      for _, other in ipairs(varied) do known = known or other == name end
      if not known then varied[#varied + 1] = name end
    end
    add(one, proposed)
  end)
  local function next(running)
    while at == #queue and more and running == 0 do
      collect()
      local before = proposed
      more()
      if proposed == before then break end
    end
    local one = queue[at + 1]
    if not one then return nil end
    at = at + 1
    local folder = ("%s/cases/%s"):format(of.folder, of.name_of(one.number))
    return { number = one.number, one = one, folder = folder, what = { scenario = options.scenario,
      script = options.script, case = one.case, overrides = case.overrides(one.parameters),
      parameters = one.parameters, resume = options.resume } }
  end
  local function done(task, outcome)
    local entry = entry_of(of, task.one, outcome)
    if show then show.ended(task, outcome) end
    if outcome.verdict == "interrupted" then return end
    of.entries[task.number] = entry
    journal.add(of.folder, options.journal or main_journal, entry)
  end

  local whole = pool.run(next, done, function(running) if show then show.tick(running) end end, options)
  if show then show.close() end
  collect()
  of.interrupted = not whole
  local list = {}
  for i, entry in ipairs(of.cases) do list[i] = entry end
  of.entries = list
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
}

--- hinge.study: see hinge.d.lua.
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
  local before, output = job.use(nil), job.current_output()
  local _ <close> = setmetatable({}, { __close = function() -- also after an error: the run has its folder back
    job.use(before)
    job.restore_output(output)
  end })
  local source = debug.getinfo(scenario.run, "S").source:match "^@(.*)$"
  local of = study.go { scenario = scenario, script = source, plan = plan, propose = o.propose,
    jobs = o.jobs or core.cores(), timeout = o.timeout, memory = o.memory, out = o.out, out_given = true,
    resume = o.resume, restart = o.restart, progress = o.progress }
  if o.pictures then of.pictures = require "hinge.study.pictures".draw(of) end
  study.write(of)
  return of
end

return study
