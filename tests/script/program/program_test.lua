-- The program: exit statuses, what it says about wrong input, what a run leaves in its folder.
--
-- Run: lua5.4 tests/script/program/program_test.lua BUILD_FOLDER
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local checks = support.checks "program"
local case, ended = checks.case, checks.ended
local quote, expect, equal = support.quote, checks.expect, checks.equal

local version = (support.read(support.root .. "CMakeLists.txt") or ""):match "project%(hinge VERSION ([%d.]+)"
local ten_storey = support.output("realpath " .. quote(support.root .. "scripts/ten_storey_impact.lua")):sub(1, -2)
local _, folder, hinge = support.scenes(arg[1])
local function path(name) return folder .. "/" .. name end
local function script(name, text) support.write(path(name), text) return quote(path(name)) end

-- Help ----------------------------------------------------------------------------------------------------------------

case("help is printed for the program, each verb and a wrong verb", function()
  for words, wanted in pairs {
    ["--help"] = { "Usage: hinge ", "run ", "check ", "render ", "reference ", "'hinge -e CODE'", "'hinge -i'",
      "--version" },
    ["run --help"] = { "Usage: hinge run ", "script", "--case", "--out", "key=value", "--quiet", "--json",
      "Exit status: 0 done; 1 the run failed; 2 " },
    ["plan --help"] = { "script", "--case", "runs nothing" },
    ["check --help"] = { "script", "--case", "natural periods", "Exit status: 0 done, also with warnings; 2 " },
    ["cost --help"] = { "Usage: hinge cost ", "script", "--case", "--within", "--quantity", "--budget", "--out" },
    ["-e --help"] = { "Usage: hinge do ", "code", "key=value" },
    ["-i --help"] = { "Usage: hinge prompt ", "script", "--case", "--out" },
    ["reference --help"] = "name",
    ["render --help"] = "folder",
    ["report --help"] = { "folders", "--out", "3D", "Exit status: 0; 1 ", "2 where no run was written" },
    ["history --help"] = { "folders", "whose", "Exit status: 0; 2 " },
    ["--version"] = { "hinge " .. version .. "\nbuild ", "\nprocessor ", "\nthreads ", "\nLua        5.4.",
      "library in ", "\nEigen      3.", "\nVTK        " },
  } do ended(0, wanted, hinge(words)) end
  for words, as in pairs { ["help"] = "--help", ["help run"] = "run --help",
    ["help reference"] = "reference --help" } do
    equal(ended(0, "", hinge(words)), select(2, hinge(as)), words)
  end
  ended(2, { "no verb 'rn' (did you mean 'run'?)", "hinge --help", "hinge reference NAME" }, hinge "help rn")
end)

case("--version names version, commit and what hinge was built with", function()
  -- Scripts read the version from the first line; the commit is there where it is known.
  local about = select(2, hinge "--version")
  equal(about:match "^([^\n]*)\n", "hinge " .. version, "the first line")
  equal(about:find "\n\n", nil, "an empty line in " .. about)
  if support.run(("git -C %s rev-parse HEAD"):format(quote(support.root))) == 0 then
    expect(about:find "\ncommit     %x%x%x%x%x%x%x", "no commit: %s", about)
  end
end)

case("the manual page knows every verb", function()
  local manual = support.read(support.root .. "src/hinge.1") or ""
  local verbs = 0
  for verb in (select(2, hinge "--help"):match "Subcommands:\n(.*)" or ""):gmatch "%f[^\n%z]  (%l+)" do
    verbs = verbs + 1
    expect(manual:find("\n.BR " .. verb .. " ", 1, true), "src/hinge.1 does not have %s", verb)
  end
  expect(verbs > 8, "%d verbs in --help", verbs)
end)

-- Wrong input: status 2, a message on stderr, nothing written ---------------------------------------------------------

local plain = script("plain.lua", "return { given = (...).total }")
case("wrong arguments end with status 2 and a message, and write nothing", function()
  local in_si = "a number in SI units, without its unit, is "
  for words, message in pairs {
    [""] = "subcommand is required",
    ["rnu " .. plain] = "there is no verb and no script 'rnu' (did you mean 'run'?)",
    ["nonsense"] = "there is no verb and no script 'nonsense';",
    ["run"] = "script is required",
    ["run nowhere.lua"] = "hinge: there is no script nowhere.lua\n",
    ["nowhere.lua"] = "hinge: there is no script nowhere.lua\n",
    ["run " .. plain .. " speed"] = "'speed' is not a setting; write key=value, for example speed=100",
    ["run " .. plain .. " =5"] = "'=5' is not a setting; write key=value, for example speed=100",
    ["run " .. plain .. " --csae II"] = "--csae",
    ["run " .. plain .. " --case II"] = { "--case II: ", " has no cases; it does not return a hinge.scenario" },
    ["run " .. ten_storey .. " --case V"] = { "unknown case 'V'", "there are I, II, III, IV, heavy" },
    ["run " .. ten_storey .. " sped=100"] = "sped=100: unknown parameter 'sped' (did you mean 'speed'?); there are ",
    ["run " .. ten_storey .. " speed=fast"] = "speed is 'fast'; must be a number in SI units or a sum such as 440/3.6",
    ["run " .. ten_storey .. " speed=400km/h"] = { "speed is '400km/h'", in_si .. "speed=111.1111111" },
    ["run " .. script("adds.lua", "local p = ...\nreturn p.load + 1\n") .. " load=2kN"] =
      { "adds.lua:2: attempt to ", "\n  at ", "load=2kN is text for the script; " .. in_si .. "load=2000" },
    ["run " .. ten_storey .. " size=-15"] = { "ten_storey_impact.lua:", "field 'size' is -15 m", "above 0 m" },
    ["run " .. script("syntax.lua", "local x =\n= 2\n")] = "syntax.lua:2: unexpected symbol near '='",
    ["run " .. script("stumbles.lua", "local hinge = require 'hinge'\nlocal t = nil\nreturn t.x\n")] =
      { "stumbles.lua:3: attempt to index a nil value (local 't')\n  at ", "stumbles.lua:3\n" },
    ["run " .. script("raises.lua", "error { 1 }")] = { "hinge: the script raised a table\n  at ", "raises.lua:1\n" },
    ["run " .. script("wrong.lua", "local hinge = require 'hinge'\n\nhinge.model { formulaton = 'asi' }\n")] =
      { "wrong.lua:3: hinge.model: unknown field 'formulaton' (did you mean 'formulation'?); it takes " },
    ["render nowhere"] = { "no frames to draw", "job:frame(run) or hinge.frame(run)" },
  } do
    ended(2, message, hinge(words .. (words:find "^run" and " --out never" or "")))
    expect(not support.is_there(path "never"), "something was written by: hinge %s", words)
  end
end)

-- A folder that cannot be written is the world's fault, not the script's: status 1.
local beam = [[
local hinge = require "hinge"
local steel = hinge.material { E = 206e9, density = 7850, yield_stress = 245e6 }
local bar = hinge.section.solid { width = 0.05, depth = 0.05 }
local function cantilever(force)
  local model = hinge.model()
  local wall, tip = model:node { 0, 0, 0 }, model:node { 1, 0, 0 }
  model:fix(wall)
  model:member { wall, tip, section = bar, material = steel }
  model:load { node = tip, force = { 0, 0, force } }
  return model, tip
end
]]
local two_nodes = script("two_nodes.lua", beam .. "local model, tip = cantilever(-1000)\n"
  .. "local _, _, uz = model:static { steps = 1 }:finish():displacement(tip)\nreturn { uz = uz }\n")
case("a folder that cannot be written to ends with status 1", function()
  ended(1, "cannot make folder plain.lua", hinge("run " .. two_nodes .. " --out plain.lua"))
end)

-- A plan: which effects, why, and the line that asks; nothing is run or written ---------------------------------------

case("hinge plan names the effects, why and where they were asked for, and runs nothing", function()
  local printed = ended(0, "", hinge("plan " .. ten_storey))
  for effect, line in pairs { gravity = "model:gravity { 0, 0,", fracture = "model:fracture {",
    contact = "model:contact {", plasticity = "building.add(" } do
    local number, at = 0, nil
    for text in io.lines(ten_storey) do
      number = number + 1
      if text:find(line, 1, true) then at = at or number end
    end
    expect(printed:match("dynamic run.*\n  " .. effect .. " +on  [^\n]*ten_storey_impact.lua:(%d+)\n") == tostring(at),
      "plan: %s at line %s:\n%s", effect, at, printed)
  end
  for _, effect in ipairs { "friction", "moving supports", "script functions" } do
    expect(printed:find("\n  " .. effect .. " +off "), "plan: %s off:\n%s", effect, printed)
  end
  local function plan(text) return hinge("plan " .. script("plans.lua", text)) end
  for geometric, line in pairs { ["true"] = "on +part of large displacement", ["false"] = "off +geometric = false" } do
    printed = ended(0, "", plan(beam .. "cantilever(-1000):dynamic { dt = 1e-5, duration = 1e-3, internals = { "
      .. "geometric = " .. geometric .. " } }:finish()\n"))
    expect(printed:find("\n  geometric stiffness +" .. line .. "\n"), "geometric = %s:\n%s", geometric, printed)
  end
  printed = ended(0, "needs results, so it", plan(beam
    .. "for i = 1, 3 do cantilever(-1000):static { steps = 1 }:finish() end\nlocal t = nil\nreturn t.x\n"))
  equal(select(2, printed:gsub("static run", "")), 1, "a loop is described once")
  ended(2, "", plan "local t = nil\nreturn t.x\n") -- it fails before a run
  expect(not support.is_there(path "out"), "a plan writes nothing")
end)

-- What a run leaves ---------------------------------------------------------------------------------------------------

local function summary(name)
  local text = support.read(path(name) .. "/summary.json")
  return expect(text, "no summary.json in %s", name) and support.json(text)
    or { results = {}, effects = {}, energy = {}, model = {} }
end
local function lines(name)
  local list = {}
  for line in (support.read(path(name)) or ""):gmatch "[^\n]*\n" do list[#list + 1] = line:sub(1, -2) end
  return list
end

case("a run writes summary.json into the folder of its script and case", function()
  for how, given in pairs { ["total=6*7"] = 42, ["--total 6*8"] = 48, ["--total=6*8"] = 48 } do
    ended(0, "", hinge(plain .. " " .. how .. " --out plain"))
    equal(summary "plain".results.given, given, how)
  end
  ended(0, "", hinge("run " .. two_nodes))
  equal(summary "out/two_nodes".verdict, "completed", "verdict, in out/SCRIPT")
  local s = summary "out/two_nodes"
  for part, names in pairs {
    model = "members elements nodes free_dofs",
    energy = "initial kinetic gravity elastic plastic fracture contact work remainder energy_error",
  } do
    for name in names:gmatch "%S+" do equal(type((s[part] or {})[name]), "number", part .. "." .. name) end
  end
  for name in ("steps time wall_seconds"):gmatch "%S+" do equal(type(s[name]), "number", name) end
  for _, effect in ipairs(s.effects) do
    equal(type(effect.name) .. type(effect.active) .. type(effect.because), "stringbooleanstring", "an effect")
  end
  local cases = script("cases.lua", "return require 'hinge'.scenario { cases = { II = {} }, run = function() end }")
  ended(0, "", hinge("run " .. cases .. " --case II"))
  equal(summary "out/cases-II".case, "II", "case, in out/SCRIPT-CASE")
end)

-- A run with other parameters goes to a folder of its own, with them in its name; the same run to the same folder.
local study_of = [[
return require "hinge".scenario { parameters = { speed = 100, dt = 1e-4, name = "a", list = { 1, 2 }, on = true },
  cases = { II = { speed = 200 } }, run = function(p, job) return { speed = p.speed, out = job.out } end }
]]
local parametric = script("parametric.lua", study_of)
case("a run with other parameters goes to a folder named by them", function()
  local function writes(words, folder_of_it)
    equal(ended(0, "", hinge("run " .. words)), "written to " .. folder_of_it .. "\n", words)
  end
  for words, wanted in pairs {
    [""] = "parametric", ["speed=100 on=true list={1,2}"] = "parametric", ["speed=150"] = "parametric-speed=150",
    ["dt=2e-5 speed=400/3.6"] = "parametric-dt=2e-05-speed=111.111", ["--case II"] = "parametric-II",
    ["--case II speed=100"] = "parametric-II-speed=100", ["speed=200 --case II"] = "parametric-II",
    ["name=x/y list={3,4} on=false"] = "parametric-list=3,4-name=x_y-on=false",
  } do
    for _ = 1, 2 do
      writes(parametric .. " " .. words, "out/" .. wanted)
      equal(summary("out/" .. wanted).results.out, "out/" .. wanted, "job.out of: " .. words)
    end
  end
  writes(parametric .. " speed=111.1111", "out/parametric-speed=111.111")
  writes(parametric .. " speed=111.11111", "out/parametric-speed=111.111-2") -- a name that is taken
  writes(plain .. " total=6*7", "out/plain-total=42")
  support.run("mkdir " .. quote(path "beside"))
  local namesake = script("beside/parametric.lua", study_of)
  for _ = 1, 2 do writes(namesake, "out/parametric-2") end
  for speed, said in pairs { [150] = "",
    [160] = "given held the run of parametric.lua, speed = 150, which is replaced\n" } do
    if speed == 160 then hinge("run " .. parametric .. " speed=150 --out given") end
    local printed, complaint = ended(0, "", hinge("run " .. parametric .. " --out given speed=" .. speed))
    expect(printed == "written to given\n" and complaint == said, "--out given: %s%s", printed, complaint)
    support.run("rm -r " .. quote(path "given"))
  end
end)

case("hinge history lists the runs of a folder", function()
  ended(0, { "out/parametric\n  parametric.lua, default parameters\n  completed; hinge 0.",
    "out/parametric-2\n  beside/parametric.lua, default parameters\n",
    "out/parametric-II-speed=100\n  parametric.lua, case II, speed = 100\n",
    "out/plain-total=42\n  plain.lua, total = 42\n", "out/two_nodes\n" }, hinge "history")
  local printed = ended(0, "", hinge "history out/parametric-speed=150")
  local told = "out/parametric-speed=150\n  parametric.lua, speed = 150\n  script " .. path "parametric.lua"
    .. "\n  parameters dt = 0.0001, list = { 1, 2 }, name = a, on = true, speed = 150\n  completed; hinge "
  expect(printed:sub(1, #told) == told
    and printed:sub(#told + 1):find "^[%d.]+; 20%d%d%-%d%d%-%d%d %d%d:%d%d\n$", "history of one: %s", printed)
  ended(2, "hinge: no run was written to nowhere\n", hinge "history nowhere")
end)

case("failed, stopped and stumbling runs leave a true summary.json and whole rows of history.csv", function()
  local overloaded = script("overloaded.lua", beam .. "cantilever(-1e6):static {}:finish()")
  local _, complaint = ended(1, "", hinge("run " .. overloaded .. " --out failed"))
  local failed = summary "failed"
  expect(failed.verdict == "failed" and failed.reason:find "no equilibrium found beyond load factor 0%.%d"
    and complaint:find(failed.reason, 1, true), "reason: %s", failed.reason)

  local stopping = beam .. "local run = cantilever(-1):dynamic { dt = 1e-5, duration = 1e-3 }\n"
    .. "for step in run:steps() do if step.index == 7 then run:stop() end end\n"
  ended(0, "", hinge("run " .. script("stopping.lua", stopping) .. " --out stopped"))
  equal(summary "stopped".verdict, "stopped", "verdict")
  equal(summary "stopped".steps, 7, "steps of a stopped run")

  -- An error in a script's own fracture rule: file and line, status 2, whole rows in history.csv, no summary; and none
  -- left of a run that used the folder before.
  local failing = beam .. [[
local model = cantilever(-1e5)
local calls = 0
model:fracture(function(section)
  calls = calls + 1
  if calls == 30 then error "this rule is wrong" end
end)

model:dynamic { dt = 1e-5, duration = 5e-2, record = 1 }:finish()
]]
  _, complaint = ended(2, "", hinge("run " .. script("failing.lua", failing) .. " --out stopped"))
  expect(complaint:find("failing%.lua:16: this rule is wrong %(fracture rule of .-failing%.lua:14, "
    .. "element %d of member 1, .-the step was taken back to t = %S+ s\n"), "a fracture rule's error: %s", complaint)
  expect(not support.is_there(path "stopped/summary.json"), "a summary was left by a script that stumbled")
  local rows = lines "stopped/history.csv"
  expect(#rows > 10 and (support.read(path "stopped/history.csv") or ""):sub(-1) == "\n",
    "history.csv up to the error: %d rows", #rows)
  for i, row in ipairs(rows) do equal(select(2, row:gsub(",", "")), 10, "commas in row " .. i) end
  equal(support.output("find " .. quote(folder) .. " -name '*.part'"), "", "files half written")
end)

case("a job of several runs has the verdict of the whole", function()
  local function study(last, says)
    return hinge("run --out study " .. script("study.lua", beam .. ([[
return hinge.scenario { run = function(_, job)
  cantilever(%s):static {}:finish()
  %s
  return { kept = 7 }
end }
]]):format(last, says)))
  end
  for says, wanted in pairs {
    ["1e6 "] = { 1, "failed" }, ["1e6 job:verdict 'completed'"] = { 0, "completed" }, ["1e3 "] = { 0, "completed" },
    ["1e3 job:verdict('failed', 'one of two')"] = { 1, "failed", "one of two" },
    ["1e6 job:verdict('completed', 'whatever')"] = { 0, "completed" },
  } do
    local last, words = says:match "^(%S+) (.*)$"
    ended(wanted[1], wanted[3] and "hinge: the run failed: " .. wanted[3] .. "\n" or "", study("-" .. last, words))
    local s = summary "study"
    equal(s.verdict, wanted[2], says .. ": verdict")
    equal(s.results.kept, 7, says .. ": results")
    if wanted[2] == "completed" then equal(s.reason, nil, says .. ": reason") end
    if wanted[3] then equal(s.reason, wanted[3], says .. ": reason") end
  end
  for says, message in pairs {
    ["job:verdict 'stopped'"] = "job:verdict: verdict is 'stopped'; must be 'completed' or 'failed'",
    ["job:verdict 'failed'"] = "job:verdict: field 'reason' is missing",
    ["job:verdict()"] = "job:verdict: field 'verdict' is missing",
  } do ended(2, message, study("-1e3", says)) end
end)

-- Two runs side by side keep their histories apart.
local side_by_side = beam .. [[
local runs = {}
for i = 1, 2 do
  local model, tip = cantilever(-i)
  runs[i] = model:dynamic { dt = 1e-5, duration = 1e-4, record = 1 }
  runs[i]:probe { node = tip, "uz", name = "uz" .. i }
end
while runs[1]:step() and runs[2]:step() do end
runs[2]:finish()
]]
case("two runs side by side keep their histories apart", function()
  ended(0, "", hinge("run " .. script("pair.lua", side_by_side) .. " --out pair"))
  local first, second = lines "pair/history-1.csv", lines "pair/history.csv"
  expect(#first == 12 and #second == 12, "two histories of 11 rows: %d, %d", #first - 1, #second - 1)
  expect((first[1] or ""):find "uz1$" and (second[1] or ""):find "uz2$", "their probes: %s, %s", first[1], second[1])
  for name, wanted in pairs { ["probes-1"] = "uz1", probes = "uz2" } do
    local probes = support.json(support.read(path("pair/" .. name .. ".json")) or "[]")
    expect(probes[1] and probes[1].name == wanted and probes[1].unit == "m", "%s.json", name)
  end
end)

case("a run without probes leaves none of an earlier run", function()
  ended(0, "", hinge("run --out pair " .. script("bare.lua", (side_by_side:gsub("runs%[i%]:probe[^\n]*", "")))))
  for _, name in ipairs { "probes", "probes-1" } do
    expect(not support.is_there(path("pair/" .. name .. ".json")), "%s.json of another run", name)
  end
end)

case("the ten-storey impact of 400 steps writes frames, pictures, history and summary", function()
  ended(0, "", hinge("run " .. ten_storey .. " --case II duration=0.004 frame_every=200 --out impact"))
  local s = summary "impact"
  for name, wanted in pairs { verdict = "completed", case = "II", kind = "dynamic", steps = 400 } do
    equal(s[name], wanted, name)
  end
  for name, wanted in pairs { members = 849, elements = 1698, nodes = 1243, free_dofs = 7308 } do
    equal(s.model[name], wanted, name)
  end
  expect(math.abs((s.time or 0) - 0.004) < 1e-12, "time %s", s.time)
  expect((s.wall_seconds or 0) > 0, "wall_seconds %s", s.wall_seconds)
  expect(type(s.results.damage) == "table" and math.type(s.results.broken_columns) == "integer", "results")
  expect(s.parameters and s.parameters.speed and math.abs(s.parameters.speed - 320 / 3.6) < 1e-12
    and s.parameters.duration == 0.004, "parameters")
  expect(#(s.state_hash or "") == 16, "state_hash %s", s.state_hash)
  local active = {}
  for _, effect in ipairs(s.effects) do
    active[effect.name] = effect.active
    expect(type(effect.active) == "boolean" and #effect.because > 0 and type(effect.seconds) == "number", "effect %s",
      effect.name)
  end
  for _, name in ipairs { "inertia", "gravity", "large displacement", "plasticity", "fracture", "contact" } do
    equal(active[name], true, name)
  end
  local e, sum = s.energy, 0
  for _, name in ipairs { "kinetic", "gravity", "elastic", "plastic", "fracture", "contact", "energy_error" } do
    if expect(type(e[name]) == "number", "energy.%s", name) then sum = sum + e[name] end
  end
  expect(e.initial and math.abs(e.initial + e.work - sum) < 1e-9 * e.initial, "the energies add up: %s + %s, %s",
    e.initial, e.work, sum)
  expect(e.initial and e.initial > 59e6 and math.abs(e.energy_error) < 1e-4 * e.initial, "energy error %s of %s",
    e.energy_error, e.initial)

  local rows = lines "impact/history.csv"
  equal(rows[1], "time,factor,kinetic,gravity,elastic,plastic,fracture,contact,numerical,work,energy_error",
    "columns of history.csv")
  equal(#rows, 402, "rows of history.csv: a heading, the start and 400 steps")
  local last = -1
  for i = 2, #rows do
    local time = tonumber(rows[i]:match "^[^,]*")
    expect(time > last, "times rise: %s after %s", time, last)
    last = time
  end
  expect(support.is_there(path "impact/history-1.csv"), "the static run before it has its history too")
  local frames = 0
  for file in (support.read(path "impact/frames.pvd") or ""):gmatch 'file="([^"]*)"' do
    frames = frames + 1
    expect(support.is_there(path "impact/" .. file), "frames.pvd names %s", file)
  end
  equal(frames, 2, "frames")
  for _, name in ipairs { "frame.png", "upper_storeys.png" } do
    expect((support.read(path("impact/" .. name)) or ""):sub(1, 8) == "\137PNG\r\n\26\n", "%s is a picture", name)
  end
  ended(0, "", hinge "render impact")
  expect(support.is_there(path "impact/frames/frame_00002.png"), "render draws the frames")
end)

checks.done()
