-- hinge study --within 2%, hinge.study { within = 0.02 }: the settings are chosen once, for the case in the middle of
-- the list, and checked in a sample of the cases. The choice is kept in the study's folder, for cases that other
-- processes run.
local accuracy = require "hinge.accuracy"
local case = require "hinge.study.case"
local changes = require "hinge.accuracy.changes"
local check = require "hinge.library.check"
local compare = require "hinge.cost.compare"
local core = require "hinge.core"
local estimate = require "hinge.accuracy.estimate"
local files = require "hinge.study.files"
local job = require "hinge.program.job"
local knobs = require "hinge.accuracy.knobs"
local Runs = require "hinge.accuracy.runs"
local store = require "hinge.cost.store"
local text = require "hinge.cost.text"
local vary = require "hinge.study.vary"

local study = {}
local sampled = 3 -- cases that are checked

-- The study's folder. It is not taken yet: the runs of the choice leave nothing in it but their measurements.
local function folder_of(what)
  local before = job.current_output()
  local folder = job.own_output(what.out, what.owner, what.out_given)
  job.restore_output(before)
  return folder
end

-- Calls f, whose runs leave nothing behind, also where a script has a folder or the study has one.
local function leaving_nothing(f, ...)
  local before = job.current_output()
  job.own_output("", {}, true)
  local results = table.pack(pcall(f, ...))
  job.restore_output(before)
  if not results[1] then error(results[2], 0) end
  return table.unpack(results, 2, results.n)
end

-- What accuracy.run takes, for a case of the study.
local function of_case(what, one)
  local all, o = {}, what.within
  for name, value in pairs(what.fixed or {}) do all[name] = value end
  for name, value in pairs(one.parameters or {}) do all[name] = value end
  return { script = what.script, scenario = what.scenario, case = one.case or what.plan.case,
    overrides = case.overrides(all), parameters = all, out = what.folder, out_given = true, within = o.within,
    budget = o.budget, answers = o.answers, where = o.where, progress = what.progress, measured_only = true,
    economic = true }
end

-- The settings of the case in the middle, and those that are finer by one refinement in everything.
local function search(what)
  local all = what.propose and {} or vary.cases(what.plan)
  local told, why = accuracy.run(of_case(what, all[#all // 2 + 1] or all[1] or {}))
  if not told then check.fail("%s: the case of the choice has no answer: %s", what.within.where, why) end
  local finer, names = {}, {}
  for _, knob in ipairs(told.knobs) do finer[knob.name] = math.min(knob.most, told.levels[knob.name] + 1) end
  for i, answer in ipairs(told.answers) do names[i] = { name = answer.name, chaotic = answer.chaotic } end
  local function setting(levels)
    local set, factors = knobs.apply(told.knobs, levels)
    return { set = set, factors = factors }
  end
  return { own = setting(told.levels), finer = setting(finer), integrator = told.integrator, answers = names,
    setting = told.setting, estimated = told.estimated < math.huge and told.estimated or nil, reached = told.reached,
    why = not told.reached and told.why or nil }
end

-- What a choice was made for: another accuracy, or other answers, want another choice.
local function asked_of(what)
  return store.key { within = what.within.within, answers = what.within.answers or {}, case = what.plan.case or "" }
end

-- The choice that the folder holds; nil and why where it holds none that counts. That of another study counts where
-- this one goes on with its cases.
local function kept(what, path)
  local choice = core.from_json(files.text(path) or "null")
  if type(choice) ~= "table" then return nil, "it is not there" end
  local takes = what.only or what.collect
  local same_study = choice.study == what.owner.study or what.resume and not takes
  if choice.asked ~= asked_of(what) or not same_study then return nil, "it is that of other words or options" end
  if what.collect then return choice end
  if choice.engine ~= core.engine() then return nil, "hinge is another version or build now" end
  local holds, changed = files.comparison()(choice.files)
  if not holds then return nil, changed .. " has changed" end
  if not takes and not choice.reached and choice.budget ~= what.within.budget then return nil end
  return choice
end

--- Chooses the settings of a study, and puts them into it: parameters into what.fixed, all else into the runs of all
-- cases, until study.leave. what: as study.go has it, with within = { within =, budget =, answers =, where = for
-- messages } and owner. A choice that its folder holds is taken, but for what.restart; with what.only or what.collect
-- there must be one. Returns what study.check takes.
function study.choose(what)
  what.folder = folder_of(what)
  local path, takes = what.folder .. "/accuracy/choice.json", what.only or what.collect
  local choice, why
  if takes or not what.restart then choice, why = kept(what, path) end
  if takes and not choice then
    check.fail("%s: the settings of all cases are to be in %s: %s; the same command with --list or --slurm chooses "
      .. "them once, for all calls with --case and --collect", what.within.where, path, why)
  end
  if not choice or choice.study ~= what.owner.study then
    choice = choice or leaving_nothing(search, what)
    choice.asked, choice.study, choice.budget = asked_of(what), what.owner.study, what.within.budget
    choice.engine, choice.files = core.engine(), files.read(core.whole_path(what.folder))
    core.write_json(path, choice)
  end
  what.fixed, what.setting = what.fixed or {}, choice.setting
  for name, value in pairs(choice.own.set) do what.fixed[name] = value end
  local factors = choice.own.factors
  factors.integrator = choice.integrator
  core.change_runs(changes.of(factors))
  return choice
end

--- From here on runs are as their scripts have them.
function study.leave() core.change_runs(nil) end

-- The largest error that a finer run of a case shows, and the answer that has it; nil where it could not be run.
local function error_of(what, one, choice)
  local run = Runs.open(of_case(what, one))
  run.integrator = choice.integrator
  local function measured(of) return run:measure(of.set, of.factors, 0) end
  local own, better = measured(choice.own), measured(choice.finer)
  if not own or not better or own.failed or better.failed then return nil end
  local most, worst = 0, nil
  for _, answer in ipairs(choice.answers) do
    local error = answer.chaotic and 0
      or estimate.rest_of_second_order * compare.error(own.answers[answer.name], better.answers[answer.name])
    if not worst or not (error <= most) then most, worst = error, answer.name end
  end
  return most, worst
end

--- "within 2 %: dt 1 ms, 4 elements a member, estimated 1.2 % in one case".
function study.line(what, choice)
  local asked, estimated = text.percent(what.within.within), choice.estimated and text.percent(choice.estimated)
    or "unknown"
  if choice.reached then return ("within %s: %s, estimated %s in one case"):format(asked, choice.setting, estimated) end
  return ("%s is not reached: the error of %s is estimated at %s in one case (%s)"):format(asked, choice.setting,
    estimated, choice.why)
end

--- Checks the choice in a sample of the cases, if all of them have ended: each is run once more, and once with all
-- finer by one refinement. Returns { asked =, estimated = for the case of the choice, setting =, reached =, checked = {
-- { case = number, error =, answer = }, ... }, line = in words }.
function study.check(what, of, choice)
  local n, checked, most, where = #of.cases, {}, 0, nil
  local line = study.line(what, choice)
  if of.interrupted or of.planned and n < of.planned then
    n, line = 0, line .. "; not checked yet"
  end
  for i = 1, math.min(sampled, n) do
    local one = of.cases[math.floor((i - 0.5) * n / math.min(sampled, n)) + 1]
    local error, answer = leaving_nothing(error_of, what, one, choice)
    checked[i] = { case = one.number, error = error, answer = answer }
    if error and error >= most then most, where = error, checked[i] end
  end
  if where then
    line = ("%s; checked in %s: at most %s (%s, case %d)%s"):format(line, check.count(#checked, "case"),
      text.percent(most), where.answer, where.case,
      most <= what.within.within and "" or ", which is more than was asked")
  end
  return { asked = what.within.within, estimated = choice.estimated, setting = choice.setting,
    reached = choice.reached, checked = checked, line = line }
end

return study
