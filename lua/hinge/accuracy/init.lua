-- hinge run SCRIPT --within 2%: a script is run so that its answers have a given error at most.
local core = require "hinge.core"
local answers = require "hinge.accuracy.answers"
local broken = require "hinge.accuracy.broken"
local check = require "hinge.library.check"
local forecast = require "hinge.accuracy.forecast"
local knobs = require "hinge.accuracy.knobs"
local picture = require "hinge.accuracy.picture"
local report = require "hinge.accuracy.report"
local Runs = require "hinge.accuracy.runs"
local Search = require "hinge.accuracy.search"
local status_line = require "hinge.library.status_line"
local text = require "hinge.cost.text"

local accuracy = {}
local where = "--within"

local most_runs = 20         -- of chaotic answers, where no budget is given
-- Without a budget the search takes at most so many s of the processor, or so many times the script's own run.
local longest, dearest = 60, 16

--- The scenario of a script; nil for plain statements, which are not run here.
function accuracy.load(options)
  local file = io.open(options.script, "rb")
  local code = file and file:read "a" or ""
  if file then file:close() end
  local chunk, problem = loadfile(options.script, "t")
  if not chunk then check.fail("%s", problem) end
  if not code:find "scenario%s*[{(]" then return nil end
  return (require "hinge.program.runner".load(options.script, options.overrides))
end

-- A function that shows progress: what runs now, how many have been made, and the time.
local function teller(show)
  local status, said = show and status_line.new(), 0
  local began, now = core.clock(), ""
  local tell = {}
  function tell.say(words)
    now = words or now
    if not show then return end
    local line = ("%s, %.0f s so far"):format(now, core.clock() - began)
    if status then status.show(line)
    elseif core.clock() - math.max(said, began) > 5 then
      said = core.clock()
      io.stderr:write(line .. "\n")
    end
  end
  function tell.close() if status then status.clear() end end
  return tell
end

local function words_of(why)
  local of = { budget = "the time did not suffice", finest = "the finest settings that are tried",
    restless = "finer settings change an answer by no less" }
  return of[why] or check.one_line(why)
end

-- Why what was asked is not reached.
local function why_not(found)
  local parts = {}
  for _, name in ipairs(check.keys(found.stuck)) do parts[#parts + 1] = name .. ": " .. words_of(found.stuck[name]) end
  return #parts > 0 and table.concat(parts, "; ") or "answers scatter more"
end

-- Warnings that belong to the result.
local function notes_of(search, record)
  local notes = {}
  local elements = false
  for _, knob in ipairs(search.knobs) do elements = elements or knob.name:find "^elements" end
  if record.strain_limits and elements then
    notes[#notes + 1] = "fracture has limits of curvature or strain, which go with the length of the elements: more "
      .. "elements are another problem, not a finer one; hinge_rotation_x, hinge_rotation_y and elongation do not"
  end
  for _, law in ipairs { "hardening", "strain rate" } do
    if record.laws and record.laws[law] and elements then
      notes[#notes + 1] = ("%s of the material goes with the length of the plastic zones, half an element each")
        :format(law)
    end
  end
  for name in pairs(record.answers) do
    if answers.is_error(name) then notes[#notes + 1] = name .. " is not counted: it is an error itself" end
  end
  for name, spread in pairs(search.sensitive) do
    if search.ladders.chaotic[name] then
      notes[#notes + 1] = ("%s is chaotic: it changes by %s where stiffness and strength change by 1e-9"):format(name,
        text.percent(spread))
    end
  end
  table.sort(notes)
  return notes
end

-- Records whose broken members are compared: those with changed physical numbers at the chosen setting; where there are
-- none, the chosen run, its check and the ladders' finest.
local function records_for_broken(search, found)
  local list = {}
  local function add(levels)
    for vary = 0, math.huge do
      local record = search.ladders:at(levels, vary)
      if not record then break end
      list[#list + 1] = record
    end
  end
  add(found.chosen)
  if #list > 1 then return list end
  if found.checked then add(found.checked) end
  for _, knob in ipairs(search.knobs) do
    local levels = search.ladders:levels(knob)
    add(search.ladders.with(search.ladders:place(knob), knob.name, levels[#levels]))
  end
  return list
end

local function problem_of(o, runs, tell, first, all, corner)
  local wanted = o.answers or o.scenario and o.scenario.answers
  local problem = { knobs = all, corner = corner, within = o.within, economic = o.economic,
    least = answers.least(wanted), explicit = runs.asked.explicit, most_runs = o.budget and math.huge or most_runs }
  function problem.names(record) return answers.names(o.where or where, record, wanted) end
  function problem.fits(seconds) return runs:fits(seconds) end
  function problem.run(levels, vary, chosen)
    local set, factors = knobs.apply(all, levels)
    tell.say(("run %d%s: %s, about %.2g s"):format(problem.search.runs + 1, chosen and " (chosen)" or "",
      knobs.words(all, levels), problem.foretell(levels)))
    local record, code
    if chosen and not o.measured_only then
      runs.o.tick = tell.say
      record, code = runs:in_full(set, factors)
      if not record then check.fail("%s: the chosen run ended with status %s", where, tostring(code)) end
    else
      record = runs:measure(set, factors, vary, chosen == "whatever it takes" and function() return false end or nil)
    end
    if not record or record.failed == Runs.late then return nil end
    if first.failed and not record.failed then first = record end
    if not record.failed and not Runs.ends_alike(record, first) then
      record.failed = "the run ends at another time with another dt, as the script counts its steps"
    end
    return record
  end
  function problem.foretell(levels) return forecast.seconds(problem.search, levels) end
  return problem
end

-- What a search has found, for report.lua.
local function told_of(o, runs, search, found)
  local all, ladders = search.knobs, search.ladders
  local chosen = ladders:at(found.chosen)
  local told = { asked = o.within, estimated = found.most, reached = found.reached, why = why_not(found),
    setting = (runs.integrator and "explicit steps, " or "") .. knobs.words(all, found.chosen, chosen),
    values = {}, levels = found.chosen,
    checked = found.checked and knobs.words(all, found.checked, ladders:at(found.checked)),
    answers = report.answers(all, found, search), notes = notes_of(search, chosen), elapsed = runs:elapsed(),
    seconds = found.seconds, runs = found.runs, own = found.own, half = forecast.half(search, found),
    folder = runs.folder, integrator = runs.integrator, warnings = chosen.warnings or {},
    printed = o.measured_only and "" or runs:printed() }
  if told.half then told.half.seconds = told.half.seconds * math.max(1, told.elapsed / found.seconds) end
  for _, knob in ipairs(all) do told.values[knob.name] = knob.value(found.chosen[knob.name]) end
  told.broken = broken.of(records_for_broken(search, found))
  told.found, told.search, told.knobs = found, search, all
  return told
end

--- Runs a script within an accuracy. o: script, scenario, case, overrides, parameters, out, out_given, within, budget,
-- answers, where (for messages), progress, longest = s that the search may take without a budget (default: 60, or 16
-- times the script's own run). Returns what report.lines takes, and folder and printed (what the script printed); nil
-- and why where the script has no answer.
function accuracy.run(o)
  local tell = teller(o.progress)
  local runs = Runs.open(o)
  tell.say "first run"
  local first, all, corner = runs:first()
  if not first then
    check.fail("%s: the budget ended before the first run was finished; give a larger one", o.where or where)
  end
  if first.failed and #first.runs == 0 then return nil, words_of(first.failed) end
  if #all == 0 then
    check.fail("%s: the script makes no run of a model, so there is nothing to refine", o.where or where)
  end
  if not o.measured_only then runs:own_folder() end
  local problem = problem_of(o, runs, tell, first, all, corner)
  local search = Search.new(problem)
  problem.search = search
  search:begin_with(first, knobs.of_first(all, corner))
  if not o.budget then
    local own = first.seconds
    for _, knob in ipairs(all) do own = own * 2 ^ -math.min(0, corner[knob.name]) end
    runs.most = o.longest or math.max(longest, dearest * own)
  end
  local found, why = search:find()
  tell.close()
  if not found then return nil, words_of(why) end
  local told = told_of(o, runs, search, found)
  if not o.measured_only then accuracy.write(told) end
  return told
end

--- Adds the choice and its grounds to the chosen run's summary.json, and writes accuracy.png and broken.csv.
function accuracy.write(told)
  local path = told.folder .. "/summary.json"
  local file = io.open(path, "rb")
  local summary = file and core.from_json(file:read "a")
  if file then file:close() end
  if not summary then return end
  summary.accuracy = report.summary(told)
  core.write_json(path, summary)
  if #told.broken.list > 0 then core.write_text(told.folder .. "/broken.csv", broken.csv(told.broken)) end
  picture.write(told)
end

return accuracy
