-- hinge study --within 2%: the settings are chosen once, for the case in the middle of the list, and checked in a
-- sample of the cases.
local accuracy = require "hinge.accuracy"
local case = require "hinge.study.case"
local changes = require "hinge.accuracy.changes"
local check = require "hinge.library.check"
local compare = require "hinge.cost.compare"
local core = require "hinge.core"
local knobs = require "hinge.accuracy.knobs"
local Runs = require "hinge.accuracy.runs"
local text = require "hinge.cost.text"
local vary = require "hinge.study.vary"

local study = {}
local sampled = 3 -- cases that are checked
local rest = 4 / 3 -- of a series of the second order with halved steps

-- What accuracy.run takes, for a case of the study.
local function of_case(what, one, o)
  local all = {}
  for name, value in pairs(what.fixed or {}) do all[name] = value end
  for name, value in pairs(one.parameters or {}) do all[name] = value end
  return { script = what.script, scenario = what.scenario, case = one.case or what.plan.case,
    overrides = case.overrides(all), parameters = all, out = what.out, out_given = true, within = o.within,
    budget = o.budget, answers = o.answers, progress = what.progress, measured_only = true, economic = true }
end

--- Chooses the settings of a study, what.plan, and puts them into it: parameters into what.fixed, all else into the
-- runs of all cases. o: within, budget, answers. Returns what study.check takes.
function study.choose(what, o)
  local all = what.propose and {} or vary.cases(what.plan)
  local told, why = accuracy.run(of_case(what, all[#all // 2 + 1] or all[1] or {}, o))
  if not told then check.fail("--within: the case of the choice has no answer: %s", why) end
  local set, factors = knobs.apply(told.knobs, told.levels)
  factors.integrator = told.integrator
  what.fixed = what.fixed or {}
  for name, value in pairs(set) do what.fixed[name] = value end
  what.setting = told.setting
  core.change_runs(changes.of(factors))
  return told
end

-- The largest error that a finer run of a case shows, and the answer that has it; nil where it could not be run.
local function error_of(what, one, o, told)
  local run = Runs.open(of_case(what, one, o))
  run.integrator = told.integrator
  local finer = {}
  for _, knob in ipairs(told.knobs) do finer[knob.name] = math.min(knob.most, told.levels[knob.name] + 1) end
  local function measured(levels)
    local set, factors = knobs.apply(told.knobs, levels)
    return run:measure(set, factors, 0)
  end
  local own, better = measured(told.levels), measured(finer)
  if not own or not better or own.failed or better.failed then return nil end
  local most, worst = 0, nil
  for _, answer in ipairs(told.answers) do
    local error = answer.chaotic and 0 or rest * compare.error(own.answers[answer.name], better.answers[answer.name])
    if not worst or not (error <= most) then most, worst = error, answer.name end
  end
  return most, worst
end

--- Checks the choice in a sample of the cases that have ended: each is run once more, and once with all finer by one
-- refinement. Returns { asked =, estimated = for the case of the choice, setting =, checked = { { case = number, error
-- =, answer = }, ... }, line = in words }.
function study.check(what, of, o, told)
  core.change_runs(nil)
  local n, checked, most, where = #of.cases, {}, 0, nil
  for i = 1, math.min(sampled, n) do
    local one = of.cases[math.floor((i - 0.5) * n / math.min(sampled, n)) + 1]
    local error, answer = error_of(what, one, o, told)
    checked[i] = { case = one.number, error = error, answer = answer }
    if error and error >= most then most, where = error, checked[i] end
  end
  local line = ("%s: %s, estimated %s in one case"):format(text.percent(o.within), told.setting,
    text.percent(told.estimated))
  if where then
    line = ("%s; checked in %s: at most %s (%s, case %d)%s"):format(line, check.count(#checked, "case"),
      text.percent(most), where.answer, where.case, most <= o.within and "" or ", which is more than was asked")
  end
  return { asked = o.within, estimated = told.estimated, setting = told.setting, checked = checked, line = line }
end

return study
