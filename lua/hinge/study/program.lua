-- hinge study: reads the command line, runs the cases, prints and writes.
local core = require "hinge.core"
local answers = require "hinge.accuracy.answers"
local case = require "hinge.study.case"
local check = require "hinge.library.check"
local files = require "hinge.study.files"
local runner = require "hinge.program.runner"
local study = require "hinge.study"
local tables = require "hinge.study.table"
local values = require "hinge.library.values"
local vary = require "hinge.study.vary"

local program = {}

local sizes = { [""] = 1, K = 2 ^ 10, M = 2 ^ 20, G = 2 ^ 30, T = 2 ^ 40 }

-- The scenario's cases that --cases names.
local function chosen_cases(text, scenario, script)
  if not text then return nil end
  if not scenario then check.fail("--cases %s: %s has no cases; it does not return a hinge.scenario", text, script) end
  local all = check.keys(scenario.cases)
  if text == "all" then
    if #all == 0 then check.fail("--cases all: %s has no cases", script) end
    return all
  end
  local list = {}
  for name in values.items(text, "--cases " .. text) do
    if not scenario.cases[name] then check.unknown("--cases", "case", name, all) end
    list[#list + 1] = name
  end
  return list
end

-- What the study is, as run.json and summary.json have it: the words, and the options that choose cases.
local function said(options)
  local parts = { table.concat(options.words, " ") }
  for _, name in ipairs { "cases", "table", "propose", "samples", "method", "seed" } do
    if options[name] then parts[#parts + 1] = ("--%s %s"):format(name, options[name]) end
  end
  return table.concat(parts, " ")
end

-- The scenario's function that --propose names.
local function proposal(name, scenario, script)
  if not scenario then check.fail("--propose %s: %s does not return a hinge.scenario", name, script) end
  if not scenario.proposals[name] then
    check.unknown("--propose", "proposal", name, check.keys(scenario.proposals))
  end
  return scenario.proposals[name]
end

--- What the command line says, for study.go.
function program.read(options)
  local scenario = runner.load(options.script, {})
  local propose = options.propose and proposal(options.propose, scenario, options.script)
  local plan = { list = vary.from_words(options.words), cases = chosen_cases(options.cases, scenario, options.script),
    samples = values.whole("--samples", options.samples, 1), seed = values.whole("--seed", options.seed, 0),
    method = options.method, said = said(options) }
  if options.table then plan.rows, plan.row_names = vary.rows(options.table) end
  if not propose then vary.add_own(plan, scenario) end
  local what = { scenario = scenario, plan = plan, propose = propose,
    fixed = propose and vary.fixed(plan, "--propose " .. options.propose, "--"),
    jobs = values.whole("-j", options.jobs, 1) or core.cores(), timeout = values.time("--timeout", options.timeout),
    memory = values.quantity("--memory", options.memory, sizes, "a size above 0, such as 500M or 2G"),
    progress = options.quiet == nil }
  for _, name in ipairs { "script", "out" } do what[name] = options[name] end
  for _, name in ipairs { "out_given", "resume", "restart", "list", "collect" } do what[name] = options[name] ~= nil end
  return what
end

-- "3" or "3-7" as a set, the first and the last of them.
local function numbers(text)
  if not text then return nil end
  local first, last = text:match "^(%d+)%-?(%d*)$"
  first, last = math.tointeger(tonumber(first)), math.tointeger(tonumber(last)) or math.tointeger(tonumber(first))
  if not first or first < 1 or last < first then
    check.fail("--case %s: must be the number of a case, as --list has them, or several as 3-7", text)
  end
  local set = {}
  for number = first, last do set[number] = true end
  return set, first, last
end

-- The cases, a line each: number, case, parameters.
local function print_list(all)
  for _, one in ipairs(all) do
    local parts = { tostring(one.number) }
    if one.case then parts[2] = "case=" .. one.case end
    for _, name in ipairs(check.keys(one.parameters)) do
      parts[#parts + 1] = name .. "=" .. case.text(one.parameters[name])
    end
    print(table.concat(parts, "\t"))
  end
end

-- What is printed at the end.
local function show(of, options)
  local width = core.width() or 120
  if #of.cases <= 24 and options.quiet == nil then
    local lines, left_out, footer = tables.lines(of, width)
    for _, line in ipairs(lines) do print(line) end
    for _, line in ipairs(footer) do print(line) end
    if left_out > 0 then print(("  and %s more: results.csv"):format(check.count(left_out, "column"))) end
  end
  local parts = {}
  local counts = study.describe(of.cases)
  for _, verdict in ipairs(check.keys(counts)) do parts[#parts + 1] = ("%d %s"):format(counts[verdict], verdict) end
  print(("%s: %s"):format(check.count(#of.cases, "case"), table.concat(parts, ", ")))
  for _, curve in ipairs(of.fragility or {}) do
    print(("%s: half of the cases at %s = %.5g"):format(curve.quantity, curve.parameter, curve.median))
  end
  for _, note in ipairs(of.notes or {}) do print("note: " .. note) end
  local warned = study.warned(of.cases)
  if warned then
    print(("%s with warnings of %s run, the first is case %d: %s"):format(check.count(warned.cases, "case"),
      warned.cases == 1 and "its" or "their", warned.first, warned.text))
  end
  if of.accuracy then print(of.accuracy.line) end
  print("written to " .. of.folder)
end

-- 0 if all cases have an answer, 1 if some have not or a picture could not be written, 3 after an interruption.
local function status_of(of)
  if of.interrupted then
    io.stderr:write("hinge: interrupted; the same command with --resume goes on\n")
    return 3
  end
  if of.lost then
    io.stderr:write(("hinge: not all was written: %s\n"):format(of.lost))
    return 1
  end
  for _, c in ipairs(of.cases) do
    if not case.finished(c.verdict) then return 1 end
  end
  return 0
end

-- What --within asks for: { within =, budget =, answers =, where = for messages }; nil without it.
local function within_of(options)
  if not options.within then return nil end
  return { within = values.accuracy("--within", options.within), budget = values.time("--budget", options.budget),
    answers = answers.read("--answers", options.answers), where = "--within " .. options.within }
end

--- options: script, words, and the options of the command line as text. Returns the program's exit status: 0 all cases
-- ended, 1 some of them without an answer, 2 the script or its input is wrong, 3 interrupted.
function program.main(options)
  return runner.guard(function()
    files.watch()
    local what = program.read(options)
    local only, first, last = numbers(options.number)
    what.list = what.list or options.slurm ~= nil
    what.resume = what.resume or what.collect or only ~= nil
    if what.propose and (what.list or what.collect or only) then
      check.fail("--propose %s: the next case follows from the results so far; there is no list of cases for --list, "
        .. "--case, --collect and --slurm", options.propose)
    end
    if only then
      what.only, what.journal = only, first == last and ("cases-%d.jsonl"):format(first)
        or ("cases-%d-%d.jsonl"):format(first, last)
    end
    local within = within_of(options)
    if not (options.slurm and options.dry_run) then what.within = within end -- which writes nothing
    local of = study.go(what)
    if what.list and of.choice and options.quiet == nil then io.stderr:write(of.choice .. "\n") end
    if options.slurm then return require "hinge.study.slurm".submit(options, #of.all) end
    if what.list then return print_list(of.all) or 0 end
    if only then return status_of(of) end
    of.pictures = require "hinge.study.pictures".draw(of)
    study.write(of)
    show(of, options)
    if what.collect and of.planned > #of.cases then
      print(("%s not ended yet"):format(check.count(of.planned - #of.cases, "case")))
    end
    return status_of(of)
  end)
end

return program
