-- hinge run --within on three small scenes of a new user's kind: an elastic frame that is shaken, a frame that loses a
-- column, a mass that falls on a frame. The error that is told is held against runs four times finer in everything.
--
-- Run: lua5.4 tests/script/accuracy/within_test.lua BUILD_FOLDER, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local hinge = require "hinge"
local accuracy = require "hinge.accuracy"
local changes = require "hinge.accuracy.changes"
local measure = require "hinge.cost.measure"
local checks = support.checks "accuracy_within"
local case, expect, equal, near = checks.case, checks.expect, checks.equal, checks.near
local build = arg[1]
local folder = support.temporary_folder()

local frame = [[
local hinge = require "hinge"
local steel = hinge.material { E = 206e9, density = 7850, yield_stress = STRESS }
local laden = hinge.material { E = 206e9, density = 60000, yield_stress = STRESS }
local column = hinge.section.box { width = 0.2, depth = 0.2, thickness = 0.008 }
local beam = hinge.section.h { depth = 0.25, width = 0.125, web = 0.006, flange = 0.009 }
local function build()
  local model, n, columns = hinge.model {}, {}, {}
  for k = 0, 1 do
    for i = 0, 2 do
      local at = #n + 1
      n[at] = model:node { 5 * i, 0, 3.5 * k }
      model:fix(n[at], k == 0 and "all" or "y,rx,rz")
      if k > 0 then columns[#columns + 1] = model:member { n[at - 3], n[at], section = column, material = steel,
        group = "columns" } end
      if k > 0 and i > 0 then model:member { n[at - 1], n[at], section = beam, material = laden, group = "beams" } end
    end
  end
  return model, n, columns
end
]]

local scripts = {
  shaken = frame:gsub("STRESS", "nil") .. [[
local model, n = build()
local record = {}
for i = 0, 50 do record[i + 1] = math.sin(0.4 * i) * math.exp(-((i - 25) / 12) ^ 2) end
model:move { node = { n[1], n[2], n[3] }, x = hinge.ground { dt = 0.02, acceleration = record, scale = 3 } }
local run = model:dynamic { dt = 5e-3, duration = 1 }
local roof = run:probe { node = n[4], "ux", name = "roof" }
run:finish()
print "shaken"
return { roof_mm = 1000 * (roof.max > -roof.min and roof.max or -roof.min), my_energy_error = run.energy_error }
]],
  lost = frame:gsub("STRESS", "325e6") .. [[
local model, n, columns = build()
model:gravity { 0, 0, -9.81 }
local rest = model:static { steps = 4 }:finish()
model:remove { member = columns[2], at = 0 }
model:fracture { hinge_rotation_x = 0.08, hinge_rotation_y = 0.08 }
local run = model:dynamic { from = rest, dt = 1e-3, duration = 0.4 }
local sag = run:probe { node = n[5], "uz", name = "sag" }
run:finish()
return { sag_mm = -1000 * sag.min, broken = run:count { state = "broken" } }
]],
  struck = frame:gsub("STRESS", "325e6") .. [[
local model, n = build()
local block = model:member { model:node { 2.5, -0.8, 3.9 }, model:node { 2.5, 0.8, 3.9 }, material = laden,
  section = hinge.section.solid { width = 0.2, depth = 0.2 } }
model:velocity(block, { 0, 0, -8 })
model:fracture { hinge_rotation_x = 0.03, hinge_rotation_y = 0.03 }
model:contact {}
local run = model:dynamic { dt = 1e-4, duration = 0.05 }:finish()
return { fall_mm = -1000 * select(3, block.a:displacement(run)), broken = run:count { state = "broken" } }
]],
}
for name, text in pairs(scripts) do support.write(("%s/%s.lua"):format(folder, name), text) end

local function hinge_run(words)
  local status, stdout, stderr = support.run(("cd %s && %s/hinge %s"):format(folder, build, words))
  return { status = status, stdout = stdout, stderr = stderr }
end

local function summary_of(out) return support.json(support.read(("%s/%s/summary.json"):format(folder, out))) end

-- How many runs have been measured.
local function measurements(out) return select(2, support.read(out .. "/accuracy/finished.lua"):gsub("[^\n]+", "")) end

-- The answers of a script with steps and elements that are finer by these factors.
local function answers_of(name, dt, elements)
  local path = ("%s/%s.lua"):format(folder, name)
  local record = measure.once({ run = function() return dofile(path) end }, {}, nil, nil, nil,
    changes.of { dt = dt, elements = elements })
  expect(not record.failed, "%s: %s", name, record.failed)
  return record.answers
end

local function holds(name, within, told)
  local fine = answers_of(name, told.values.dt / 4, told.values.elements * 4)
  for answer, a in pairs(told.answers) do
    local truth = math.abs(a.value / fine[answer] - 1)
    if a.value == fine[answer] then truth = 0 end
    expect(not told.reached or truth <= within, "%s: %s is off by %.3g, asked %g", name, answer, truth, within)
    expect(truth <= (a.error or math.huge), "%s: %s is off by %.3g, told %s", name, answer, truth, a.error)
  end
end

case("an elastic frame that is shaken is within 2 %, and the error that is told holds", function()
  local r = hinge_run "run shaken.lua --within 2% --out shaken"
  equal(r.status, 0, "status: " .. r.stderr)
  local told = summary_of("shaken").accuracy
  expect(told.reached and told.estimated <= 0.02 and told.asked == 0.02, "told %g", told.estimated)
  expect(told.answers.roof_mm and not told.answers.my_energy_error, "answers that count")
  expect(r.stdout:find("shaken\nwithin 2 %: dt ", 1, true), "what the script prints, and then the conclusion:\n%s",
    r.stdout)
  expect(r.stdout:find "\n  roof_mm +[%d.]+ +%+%- [%d.]+ %% +[^\n]+ in dt; [^\n]+ in elements", "a line an answer:\n%s",
    r.stdout)
  expect(r.stdout:find "asked 2 %%, estimated [%d.]+ %%, cost [%d.]+ m?s; [%d.]+ %% would cost about",
    "what it cost:\n%s", r.stdout)
  expect(r.stdout:find(("shaken\n%s\n"):format(told.conclusion), 1, true) and r.stdout:find(told.line .. "; "
    .. told.effort, 1, true), "the report shows other lines: %s, %s, %s", told.conclusion, told.line, told.effort)
  expect(r.stdout:find("+- " .. told.answers.roof_mm.error_text, 1, true), "and another error")
  equal(#(summary_of("shaken").notes or {}), 0, "notes")
  expect(support.is_there(folder .. "/shaken/history.csv"), "the chosen run is written in full")
  holds("shaken", 0.02, told)
end)

case("what does not matter in an answer is accepted", function()
  local r = hinge_run "run shaken.lua --within 1e-6 --answers roof_mm:3 --out shaken"
  equal(r.status, 0, "status: " .. r.stdout)
  local a = summary_of("shaken").accuracy.answers.roof_mm
  expect(a.value < 3e6 and r.stdout:find "roof_mm +[%d.]+ +%+%- [%d.]+ +[%d.]+ by changes in dt",
    "in its own unit:\n%s", r.stdout)
end)

case("what the script prints is that of the last chosen run, also in a later call", function()
  for _, within in ipairs { "5%", "0.01%" } do
    local r = hinge_run(("run shaken.lua --within %s --out shaken"):format(within))
    equal(select(2, r.stdout:gsub("shaken\n", "")), 2, "once, and in the name of the folder:\n" .. r.stdout)
    equal(summary_of("shaken").accuracy.asked, tonumber(within:match "[%d.]+") / 100, "of the last call")
  end
end)

case("a script of four elements a member begins with two, and each number of elements has a run", function()
  local four = support.read(folder .. "/lost.lua"):gsub("hinge.model {}", "hinge.model { elements_per_member = 4 }")
  support.write(folder .. "/four.lua", four)
  hinge_run "run four.lua --within 10% --answers sag_mm --out four"
  local steps = {}
  for line in io.lines(folder .. "/four/accuracy/finished.lua") do
    local f = load("return " .. line)
    local entry = f and f()
    local run = entry and entry.record.runs[#entry.record.runs]
    if run then steps[run.elements] = (steps[run.elements] or 0) + 1 end
  end
  expect(steps[10] and steps[10] >= 2 and steps[20], "runs with 10 and 20 elements: %s, %s", steps[10], steps[20])
  local told = summary_of("four").accuracy
  expect(not told.answers.sag_mm.basis:find "no change in elements", "basis: %s", told.answers.sag_mm.basis)
  holds("four", 0.1, told)
end)

case("a second call takes the runs of the first", function()
  local r = hinge_run "run shaken.lua --within 1% --out shaken"
  equal(r.status, 0, "status: " .. r.stderr)
  local made = measurements(folder .. "/shaken")
  hinge_run "run shaken.lua --within 1% --out shaken"
  equal(measurements(folder .. "/shaken"), made, "measurements after a third call")
end)

case("a frame that loses a column tells its sag, what is not reached, and who broke", function()
  local r = hinge_run "run lost.lua --within 5% --answers sag_mm,broken --out lost"
  local told = summary_of("lost").accuracy
  equal(r.status, told.reached and 0 or 1, "status")
  holds("lost", 0.05, told)
  local of = told.broken
  expect(of.in_all + of.in_some > 0 == support.is_there(folder .. "/lost/broken.csv"), "broken.csv")
  equal(#(of.list or {}), of.in_all + of.in_some, "members that broke")
  equal(of.in_all + of.in_some + of.in_none, 5, "members")
end)

case("a mass that falls on a frame tells an error that holds, or that there is none", function()
  local r = hinge_run "run struck.lua --within 10% --budget 20 --out struck"
  local told = summary_of("struck").accuracy
  equal(r.status, told.reached and 0 or 1, "status")
  if not told.reached then expect(r.stdout:find "^10 %% is not reached for ", "conclusion:\n%s", r.stdout) end
  local reference = answers_of("struck", told.values.dt / 4, 8)
  for name, a in pairs(told.answers) do
    local truth = a.value == reference[name] and 0 or math.abs(a.value / reference[name] - 1)
    expect(not a.error or a.error > 1 or truth <= a.error, "%s is off by %.3g, told %s", name, truth, a.error)
  end
end)

case("a failed run whose verdict the script reads leaves the answers, another one does not", function()
  local function measured(reads)
    return measure.watch(function()
      local model = hinge.model {}
      local foot, top = model:node { 0, 0, 0 }, model:node { 0, 0, 3 }
      model:fix(foot)
      model:member { foot, top, section = hinge.section.round { diameter = 0.05 },
        material = hinge.material { E = 206e9, density = 7850, yield_stress = 235e6 } }
      model:load { node = top, force = { 1e6, 0, 0 } }
      local pushed = model:static { steps = 2 }:finish()
      if reads then equal(pushed.verdict, "failed", "verdict of a load beyond the limit") end
      local run = model:dynamic { dt = 1e-3, duration = 2e-3 }:finish()
      return { top_mm = 1000 * top:displacement(run) }
    end)
  end
  local read, unread = measured(true), measured(false)
  expect(not read.failed and read.answers.top_mm > 0, "a verdict that was read: %s", read.failed)
  expect(unread.failed, "a verdict that was not read")
end)

case("where the time ends with the first run, that run is told", function()
  local path = folder .. "/shaken.lua"
  local scenario = hinge.scenario { run = function() return dofile(path) end }
  local told, why = accuracy.run { script = path, scenario = scenario, overrides = {}, parameters = {},
    out = folder .. "/short", out_given = true, within = 0.02, measured_only = true, longest = 1e-6 }
  expect(told and not told.reached and told.answers[1].value, "told: %s", why)
end)

case("a shorter step is one of a stricter step control", function()
  local function steps(change)
    local path = folder .. "/struck.lua"
    local record = measure.once({ run = function() return dofile(path) end }, {}, nil, nil, nil, change)
    return record.runs[1].steps
  end
  equal(changes.of({ dt = 0.5 }).control, 0.25, "what it may accept at half the step")
  equal(changes.of({ dt = 4 }).control, 1, "and at a longer one")
  local given = changes.of({ dt = 0.5 }).options("dynamic", { dt = 1e-3, duration = 1, step_control = 0.01 })
  near(given.step_control, 0.0025, 1e-12, "one that the script gives")
  local usual, strict = steps { step = 1 }, steps { control = 1e-4 }
  expect(strict > 1.2 * usual, "%d steps, %d where a ten thousandth is accepted", usual, strict)
end)

case("what is wrong on the command line is named", function()
  for words, complaint in pairs {
    ["run shaken.lua --within 2%% --answers top"] = "unknown answer 'top'",
    ["run shaken.lua --within 2%% --answers roof_mm:much"] = "roof_mm:much must be NAME or NAME:DIFFERENCE",
    ["run shaken.lua --within 2%% --answers roof_mm:-1"] = "a difference that does not matter",
    ["run shaken.lua --within 5"] = "--within 5: must be a part above 0 and below 1",
    ["run shaken.lua --within much"] = "--within much: must be a part above 0",
    ["run shaken.lua --budget 5"] = "--within",
    ["study shaken.lua x=1,2 --within 2%% --case 2"] = "the same command with --list or --slurm",
    ["run shaken.lua --within 2%% --sandbox"] = "Leave out --sandbox",
  } do
    local r = hinge_run((words:gsub("%%%%", "%%")) .. " --out wrong")
    expect(r.status ~= 0 and r.stderr:find(complaint, 1, true), "%s: %s %s", words, r.status, r.stderr)
  end
end)

case("a study chooses its settings once, and checks them in some of its cases", function()
  support.write(folder .. "/many.lua", [[
    local hinge = require "hinge"
    return hinge.scenario { parameters = { scale = 3 }, accuracy = { elements = { 2, 4 } }, run = function(p) ]]
    .. scripts.shaken:gsub("scale = 3", "scale = p.scale"):gsub("{}", "{ elements_per_member = p.elements }", 1)
    .. " end }")
  local words = "study many.lua scale=1,2,3,4 --within 3% --answers roof_mm --out many"
  local r = hinge_run(words)
  equal(r.status, 0, "status: " .. r.stderr)
  local told = summary_of("many").accuracy
  expect(#told.checked == 3 and told.asked == 0.03, "cases that are checked: %d", #told.checked)
  for _, one in ipairs(told.checked) do expect(one.error <= 0.03, "case %d: %s", one.case, one.error) end
  expect(r.stdout:find("\nwithin 3 %: dt ", 1, true), "its line:\n%s", r.stdout)
  expect(not (support.read(folder .. "/many/results.csv")):find(",200,", 1, true), "steps are those of the script")
  expect(not support.is_there(folder .. "/many/history.csv"), "runs of the choice leave a history")
  -- The choice is taken from the folder, with more cases as well; but not after a change, or for other answers.
  local made = measurements(folder .. "/many")
  r = hinge_run(words:gsub("3,4", "3,4,5") .. " --resume")
  equal(r.status, 0, "status of more cases: " .. r.stderr)
  equal(measurements(folder .. "/many"), made + 2, "measurements with a fifth case, which the check takes")
  local choice = support.read(folder .. "/many/accuracy/choice.json")
  support.write(folder .. "/many/accuracy/choice.json", choice:gsub("dt 20 ms", "dt 10 ms"):gsub('"dt": 4', '"dt": 2'))
  hinge_run(words:gsub("3,4", "3,4,5") .. " --resume")
  local _, rows = support.read(folder .. "/many/results.csv"):gsub(",100,", "")
  equal(rows, 5, "cases with the step of the choice in the folder")
  r = hinge_run(words:gsub("roof_mm", "roof") .. " --case 1")
  expect(r.status == 2 and r.stderr:find "is that of other words or options", "other answers: %s", r.stderr)
  support.write(folder .. "/many.lua", support.read(folder .. "/many.lua") .. "\n")
  r = hinge_run(words:gsub("3,4", "3,4,5") .. " --case 1")
  expect(r.status == 2 and r.stderr:find "many%.lua has changed", "another script: %s", r.stderr)
end)

case("cases by their numbers, and a study from Lua, have the settings and results of hinge study", function()
  hinge_run "study many.lua scale=1,2,3 --within 3% --answers roof_mm --out whole"
  local words = "study many.lua scale=1,2,3 --within 3% --answers roof_mm --out parts"
  local listed = hinge_run(words .. " --list")
  expect(listed.stdout:find "^1\telements=%d\tscale=1\n" and listed.stderr:find "^within 3 %%: dt ", "--list: %s%s",
    listed.stdout, listed.stderr)
  for _, numbers in ipairs { "2-3", "1" } do
    equal(hinge_run(words .. " --case " .. numbers).stderr, "", "complaint of --case " .. numbers)
    local r = hinge_run(words .. " --collect")
    expect((r.stdout:find "not checked yet" ~= nil) == (numbers == "2-3"), "--collect after %s: %s", numbers, r.stdout)
  end
  checks.same_files(folder .. "/parts/results.csv", folder .. "/whole/results.csv", "cases by their numbers")
  equal(#summary_of("parts").accuracy.checked, 3, "cases that --collect checks")
  support.write(folder .. "/from_lua.lua", [[
    require "hinge".study(dofile "many.lua", { vary = { scale = { 1, 2, 3 } }, within = 0.03, answers = { "roof_mm" },
      out = "lua", pictures = false })]])
  equal(hinge_run "run -q from_lua.lua --out program".stderr, "", "complaint of a study from Lua")
  checks.same_files(folder .. "/lua/results.csv", folder .. "/whole/results.csv", "a study from Lua")
  equal(summary_of("lua").accuracy.line, summary_of("whole").accuracy.line, "what the choice is")
  checks.refused("field 'budget' has no effect without within", function()
    hinge.study(dofile(folder .. "/many.lua"), { vary = { scale = { 1 } }, budget = 3 })
  end)
  checks.refused("within: answers: unknown answer 'top'", function()
    hinge.study(dofile(folder .. "/many.lua"), { vary = { scale = { 1 } }, within = 0.03, answers = { "top" },
      out = folder .. "/fresh" })
  end)
end)

checks.done()
