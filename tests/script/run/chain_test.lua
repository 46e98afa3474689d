-- A chain of runs is as good as its weakest: what goes on from a run that did not come to its end has failed too, in
-- hinge run, hinge study, hinge cost and under plain Lua, unless the script says allow_failed = true.
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local checks = support.checks "chain"
local case = checks.case
local quote, expect, equal, near = support.quote, checks.expect, checks.equal, checks.near

local hinge_does, folder = support.scenes(arg[1])
local function hinge_run(text, arguments) return hinge_does("run", text, "--out out " .. (arguments or "")) end
local function summary() return support.json(support.read(folder .. "/out/summary.json") or "{}") end

-- A steel cantilever of 0.05 x 0.05 m carries Mp / l = 235e6 * 0.05^3 / 4 N at its tip.
local carries = 235e6 * 0.05 ^ 3 / 4
local cantilever = [[
local hinge = require "hinge"
local function cantilever(load, options)
  local model = hinge.model { displacement = "small" }
  local wall, tip = model:node { 0, 0, 0 }, model:node { 1, 0, 0 }
  model:fix(wall, "all")
  model:member { wall, tip, section = hinge.section.solid { width = 0.05, depth = 0.05 },
    material = hinge.material { E = 206e9, nu = 0.3, density = 7850, yield_stress = 235e6 } }
  model:load { node = tip, force = { 0, 0, -load } }
  return model, model:static(options or { steps = 4 }):finish(), tip
end
]]
local function scene(times, options, more)
  return cantilever .. ("local model, rest, tip = cantilever(%.17g, %s)\n"):format(times * carries, options or "nil")
    .. (more or "")
end
local goes_on = "local run = model:dynamic { from = rest, dt = 1e-5, duration = 2e-5 %s }:finish()\n"

case("a run that goes on from a failed one warns, and says where the first one failed", function()
  -- The run before failed at 1/3 of its load, or ended there as it was asked to; or arc length fell short.
  for options, says in pairs {
    ["{ steps = 4 }"] = "static run 1, which failed at 0.333 of its load (made at scene.lua:9): no equilibrium found",
    ["{ steps = 4, to_limit = true }"] = "static run 1, which ended at its limit load, at 0.333 of its load (made at",
    ["{ steps = 1, control = { 'arc', to = 0.3 } }"] = "static run 1, which ended at load factor",
  } do
    local status, _, complaint = hinge_run(scene(3, options, goes_on:format ""))
    equal(status, 1, options .. ": status")
    local s = summary()
    equal(s.verdict, "failed", options .. ": verdict")
    equal(s.steps, 2, options .. ": the steps were taken all the same")
    expect(support.has(s.reason or "", "goes on from " .. says), "%s: reason: %s", options, s.reason)
    expect((s.reason or ""):find("; allow_failed = true of model:dynamic accepts that", 1, true),
      "%s: what accepts: %s", options, s.reason)
    expect(complaint:find("hinge: the run failed: goes on from static run 1", 1, true), "%s: it says %s", options,
      complaint)
    expect(support.has((s.warnings or {})[1] or "", "this run goes on from " .. says), "%s: warnings: %s", options,
      (s.warnings or {})[1])

    status, _, complaint = hinge_run(scene(3, options, goes_on:format ", allow_failed = true"))
    equal(status, 0, options .. ", accepted: status; " .. complaint)
    s = summary()
    equal(s.verdict, "completed", options .. ", accepted: verdict")
    expect(support.has((s.warnings or {})[1] or "", "this run goes on from " .. says), "%s, accepted: warnings: %s",
      options, (s.warnings or {})[1])
  end
end)

case("a run that goes on from a completed one does not warn", function()
  -- A run that came to its end, by any control, is no weak link; nor is one that the script has stopped.
  for options, times in pairs { ["{ steps = 4 }"] = 0.5, ["{ steps = 4, to_limit = true }"] = 0.5,
    ["{ steps = 20, control = { 'arc', to = 0.25 } }"] = 3 } do
    local status, _, complaint = hinge_run(scene(times, options, goes_on:format ""))
    equal(status .. summary().verdict, "0completed", options .. ": " .. complaint)
  end
end)

case("the warning comes further down the chain too", function()
  local long = scene(3, nil, [[
local still = model:static { from = rest, steps = 1, allow_failed = %s }:finish()
local run = model:dynamic { from = still, dt = 1e-5, duration = 2e-5 }
assert(run.verdict == "running" and run:step() and run.verdict == "running")
run:finish()
return { how = run.verdict, why = run.reason, of_itself = run.warnings[1] or "", text = tostring(run) }
]])
  for _, accepted in ipairs { "false", "true" } do
    equal(hinge_run((long:gsub("%%s", accepted))), 1, "three runs, accepted " .. accepted)
    local r = summary().results
    equal(r.how, "failed", "three runs: run.verdict")
    expect(r.why:find("^goes on from static run [12], which failed at "), "three runs: run.reason: %s", r.why)
    expect(r.of_itself:find("^goes on from static run [12], which failed at "), "three runs: run.warnings: %s",
      r.of_itself)
    expect(r.text:find "^dynamic run: failed at step 2 of 2", "three runs: tostring: %s", r.text)
  end
end)

case("a run that the script leaves before its end is named", function()
  equal(hinge_run(scene(3, nil, (goes_on:format "":gsub(":finish%(%)", "") .. "run:step()\n"))), 1, "left: status")
  expect(summary().verdict == "failed" and summary().reason:find "^goes on from static run 1", "left: %s",
    summary().reason)
end)

case("runs that are no chain do not warn", function()
  -- one of which nobody asked how it went, and one of which somebody did
  local two = cantilever .. "local _, first = cantilever(%.17g)\ncantilever(%.17g)\n%s"
  local status, _, complaint = hinge_run(two:format(3 * carries, 0.5 * carries, ""))
  equal(status, 1, "never asked: status")
  expect(summary().verdict == "failed" and summary().reason:find("^static run 1, made at scene.lua:9, failed: no eq")
    and summary().reason:find("the script never asked how that went (run.verdict)", 1, true), "never asked: %s",
    summary().reason)
  expect(complaint:find("hinge: the run failed: static run 1", 1, true), "never asked: it says %s", complaint)
  status, _, complaint = hinge_run(two:format(3 * carries, 0.5 * carries, "return { how = first.verdict }"))
  equal(status .. summary().verdict .. summary().results.how, "0completedfailed", "asked: " .. complaint)
  equal(#(summary().failed_runs or {}), 1, "asked: failed_runs")
  status = hinge_run(cantilever .. "return hinge.scenario { run = function(_, job)\n" .. two:format(3 * carries,
    0.5 * carries, "job:verdict 'completed'\nend }"):sub(#cantilever + 1))
  equal(status .. summary().verdict, "0completed", "the script says that the job has completed")
end)

local scenario = cantilever .. ([[
return hinge.scenario { parameters = { times = 1 }, run = function(p)
  local model, rest, tip = cantilever(p.times * %.17g)
  local run = model:dynamic { from = rest, dt = 1e-5, duration = 2e-5 }:finish()
  return { uz = select(3, run:displacement(tip)) }
end }
]]):format(carries)

case("a case of a study that goes on from a failed run is failed", function()
  support.write(folder .. "/scene.lua", scenario)
  local study = ("cd %s && %s study scene.lua times=0.5,2,3 -j 1 --out study"):format(quote(folder),
    quote(arg[1] .. "/hinge"))
  local status, printed, complaint = support.run(study)
  equal(status, 1, "study: status")
  expect(printed:find("3 cases: 1 completed, 2 failed", 1, true), "study: it says %s", printed)
  expect(support.has(complaint, "case 2 failed: goes on from static run 1, which failed at 0.5 of its load"),
    "study: stderr: %s", complaint)
  local rows = support.read(folder .. "/study/results.csv") or ""
  expect(rows:find "\n1,0.5,completed,[^\n]*,2,\n2,2,failed,[^\n]*,2,\"goes on from static run 1, which failed at 0%.",
    "study: results.csv: %s", rows)
  local journal = support.read(folder .. "/study/cases.jsonl") or ""
  expect(journal:find('"reason":"goes on from static run 1, which failed at 0.', 1, true), "study: journal: %s",
    journal)
  equal(support.json(support.read(folder .. "/study/summary.json")).verdicts.failed, 2, "study: summary.json")
  local factor = tonumber(journal:match '"number":3,.-which failed at ([%d.]+)'
    or journal:match 'which failed at ([%d.]+) of its load[^\n]*"times":3')
  near(factor or 0, 1 / 3, 1e-3, "study: load factor of case 3")
  local finished = quote(folder .. "/study/cases/00001/summary.json")
  local function written() return support.output("stat -c %y " .. finished) end
  local kept = written()
  expect(os.remove(folder .. "/study/cases/00002/summary.json"), "study: no summary of a failed case")
  equal(support.run(study .. " --resume"), 1, "study: status of --resume")
  expect(support.is_there(folder .. "/study/cases/00002/summary.json"), "study: --resume left a failed case")
  equal(written(), kept, "study: --resume ran a finished case")
end)

case("a setting of hinge cost whose run goes on from a failed one has no answer", function()
  local status, _, complaint = hinge_does("cost", (scenario:gsub("times = 1 }",
    "times = 3 }, accuracy = { dt = { 1e-5, 2e-5 } }")), "--out cost")
  equal(status, 2, "cost: status")
  expect(complaint:find("no setting has an answer: goes on from static run 1, which failed at 0.333", 1, true),
    "cost: %s", complaint)
end)

case("the option is refused without a run to go on from", function()
  for _, call in ipairs { "static { allow_failed = true }", "dynamic { dt = 1, duration = 1, allow_failed = true }" } do
    local status, _, complaint = hinge_run(scene(0.5, nil, "model:" .. call))
    expect(status == 2 and complaint:find("field 'allow_failed' is true; has no meaning without from =", 1, true),
      "%s: %s %s", call, status, complaint)
  end
end)

checks.done()
