-- What hinge run says of a run as it goes, in words and as JSON: how far it is, its energy error, what changed, what
-- looks like a mistake.
--
-- Run: lua5.4 tests/script/program/telling_test.lua BUILD_FOLDER
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local checks = support.checks "telling"
local case, ended = checks.case, checks.ended
local quote, run, expect, equal = support.quote, support.run, checks.expect, checks.equal

local hinge_on, folder, hinge = support.scenes(arg[1])
local function hinge_run(...) return hinge_on("run", ...) end
local function summary() return support.json(support.read(folder .. "/out/scene/summary.json")) end

-- What the guide says of each event of --json: the rest of its row.
local documented = {}
for names, rest in support.read(support.root .. "lua/guide/studies.md"):gmatch "\n| (`[%l_`, ]+`) (|[^\n]+)" do
  for name in names:gmatch "`([%l_]+)`" do documented[name] = rest end
end
documented.run_ended = (documented.run_ended or ""):gsub("as `progress`", (documented.progress:gsub("%%", "%%%%")))

-- The lines of --json; each must be an object with an event that the guide has. How many there are depends on how fast
-- the machine is.
local function events(printed)
  local list, odd = {}, nil
  for line in printed:gmatch "[^\n]+" do
    local good, object = pcall(support.json, line)
    if good and type(object) == "table" and object.event then
      local row = documented[object.event]
      expect(row, "the guide does not have the event %s", object.event)
      for key in pairs(row and object or {}) do
        expect(key == "event" or row:find(("`%s`"):format(key), 1, true), "the guide does not have %s of the event %s",
          key, object.event)
      end
      list[#list + 1] = object
      list[object.event] = list[object.event] or {}
      table.insert(list[object.event], object)
    else
      odd = odd or line
    end
  end
  expect(#list > 0 and not odd, "no event: %s", odd or "nothing is printed")
  return list
end

-- Effects that did nothing --------------------------------------------------------------------------------------------

-- A bar falls on the ground and nothing else happens. Long enough that there is time to be saved: above a second.
local falling = [[
local hinge = require "hinge"
local model = hinge.model()
local bar = hinge.section.solid { width = 0.05, depth = 0.05 }
local a, b = model:node { 0, 0, 0.03 }, model:node { 1, 0, 0.03 }
model:member { a, b, section = bar, material = hinge.material { E = 206e9, density = 7850 } }
model:gravity { 0, 0, -9.80665 }
model:contact { rule = "surface" }
model:fracture { curvature_x = 1e9 }
model:ground {}
model:dynamic { dt = 1e-7, duration = %g, record = false, step_control = 0 }:finish()
]]
case("a run names effects that did nothing and cost much, not those that acted, nor where there is no time to save",
  function()
    local _, complaint = ended(0, "", hinge_run(falling:format(0.05)))
    local names, all, fracture, contact = complaint:match
      "([%l ]+) did nothing in this run and took (%S+) %% of its time: fracture (%S+) %%, contact (%S+) %%\n"
    equal(names, "fracture and contact", "what did nothing:\n" .. complaint)
    local wall, seconds = summary().wall_seconds, {}
    for _, e in ipairs(summary().effects) do seconds[e.name] = e.seconds end
    for name, part in pairs { contact = contact, fracture = fracture } do
      checks.near(tonumber(part) / 100 / (seconds[name] / wall), 1, 0.06, "part of " .. name)
    end
    checks.near(tonumber(all) / (tonumber(contact) + tonumber(fracture)), 1, 0.06, "both together")
    _, complaint = ended(0, "", hinge_run(falling:format(1e-4)))
    expect(not complaint:find "did nothing", "a short run:\n%s", complaint)
  end)

-- A bar that rests in space, and one that is clamped at both of its ends and damped.
local damped = falling:gsub("model:gravity.-model:ground {}", [[
  local c, d = model:node { 0, 5, 0 }, model:node { 1, 5, 0 }
  model:member { c, d, section = bar, material = hinge.material { E = 206e9, density = 7850 }, group = "still" }
  model:fix { c, d }
  model:damping { alpha = %%g, beta = %%g, group = "still" }]]):gsub("record = false", "%0, rest = false")
case("damping that dissipates nothing, and damping that no member has, did nothing", function()
  for alpha, words in pairs { [1] = "damping did nothing in this run and took %d", [0] = "it damps no member" } do
    local _, complaint = ended(0, "", hinge_run(damped:format(alpha, 1e-4 * alpha, 0.08)))
    local _, told = complaint:gsub("damping did nothing in this run", "")
    local wall = summary().wall_seconds -- below a second there is no time to save; about it both are right
    if wall > 1.05 then expect(told == 1 and complaint:find(words), "alpha = %g:\n%s", alpha, complaint)
    elseif wall < 0.95 then equal(told, 0, "a short run:\n" .. complaint) end
  end
end)

-- Changes of state: the first of each kind is told, the others are counted --------------------------------------------

local bouncing = [[
local hinge = require "hinge"
local model = hinge.model()
local steel = hinge.material { E = 206e9, density = 7850 }
local bar = hinge.section.solid { width = 0.05, depth = 0.05 }
local a, b, c, d = model:node { 0, 0, 0 }, model:node { 1, 0, 0 }, model:node { 0.5, -0.5, 0.06 },
  model:node { 0.5, 0.5, 0.06 }
model:fix({ a, b }, "all")
model:member { a, b, section = bar, material = steel, group = "rail" }
model:member { c, d, section = bar, material = steel, group = "bar" }
model:gravity { 0, 0, -9.80665 }
model:contact { rule = "surface" }
local run = model:dynamic { dt = 1e-5, duration = 0.4 }
run:finish()
print "the script's own words"
]]
case("changes of state are printed once each and counted, as events with --json, not with --quiet", function()
  local printed, complaint = ended(0, "", hinge_run(bouncing))
  local awake, asleep = 0, 0
  for _, w in ipairs(summary().state_changes) do
    if w.effect == "contact" then awake, asleep = awake + (w.awake and 1 or 0), asleep + (w.awake and 0 or 1) end
  end
  expect(awake > 5 and asleep > 5, "contact wakes %d times, falls asleep %d times", awake, asleep)
  for _, what in ipairs { "awake", "asleep" } do
    equal(select(2, complaint:gsub("t = %S+ s: contact " .. what, "")), 1, "told: " .. what)
  end
  expect(complaint:find(("contact: awake %d times, asleep %d times in all, the last at t = "):format(awake, asleep), 1,
    true), "counted: %s", complaint)

  expect(printed:find "written to out/scene\n$", "not quiet: %s", printed)
  printed, complaint = ended(0, "", hinge_run(bouncing, "--quiet"))
  equal(printed .. complaint, "the script's own words\n", "--quiet")

  printed, complaint = ended(0, "", hinge_run(bouncing, "--json"))
  local said = events(printed)
  equal(complaint, "the script's own words\n", "--json: stderr")
  equal(said[1] and said[1].event, "run_begun", "--json: the first line")
  equal(said[#said] and said[#said].event, "summary", "--json: the last line")
  expect(said.run_begun and #said.run_begun == 1 and said.run_begun[1].members == 2
    and said.run_begun[1].line == "scene.lua:12" and said.run_begun[1].steps == 40000, "--json: run_begun")
  expect(said.run_ended and said.run_ended[1].verdict == "completed" and said.run_ended[1].step == 40000
    and said.run_ended[1].part == 1, "--json: run_ended")
  for _, state in ipairs { true, false } do
    local told = 0
    for _, e in ipairs(said.state or {}) do
      if e.effect == "contact" and e.awake == state then told = told + 1 end
    end
    equal(told, 1, "--json: contact, awake " .. tostring(state))
  end
  local counted
  for _, e in ipairs(said.changes or {}) do if e.effect == "contact" then counted = e end end
  expect(counted and counted.awake == awake and counted.asleep == asleep, "--json: changes")
  local last = said.summary and said.summary[1] or { summary = {} }
  expect(last.folder == "out/scene" and last.summary.verdict == "completed" and last.summary.state_hash
    == summary().state_hash, "--json: the summary")

  printed = ended(2, "", hinge_run("local t = nil\nreturn t.x\n", "--json"))
  said = events(printed)
  expect(#said == 1 and said[1].event == "error" and said[1].status == 2
    and said[1].message:find "scene.lua:2: attempt to index a nil value", "--json: an error: %s", printed)
  ended(2, "", hinge "run scene.lua --json --quiet")
end)

-- The energy error is held against the largest energy, whenever that was, not against what is left at the end ---------

case("the energy error is given as a part of the largest energy", function()
  local swinging = [[
local hinge = require "hinge"
local model = hinge.model()
local wall, tip = model:node { 0, 0, 0 }, model:node { 1, 0, 0 }
model:fix(wall)
model:member { wall, tip, section = hinge.section.solid { width = 0.05, depth = 0.05 },
  material = hinge.material { E = 206e9, density = 7850 } }
model:load { node = tip, force = { 0, 0, -1000 } }
local run = model:dynamic { dt = 1e-4, duration = 0.025, record = RECORD, beta = 0.3 }
local most = 0
while run:step() do
  most = run.energy.work > most and run.energy.work or most
end
return { most = most, of_work = run.energy.energy_error / run.energy.work, error = run.energy_error,
  of_most = run.energy.energy_error / most }
]]
  for _, record in ipairs { "1", "100000", "false" } do
    ended(0, "", hinge_run((swinging:gsub("RECORD", record))))
    local r = summary().results
    expect(math.abs(r.of_work) > 50 * math.abs(r.of_most), "the work goes back: %s %s", r.of_work, r.of_most)
    expect(r.error / r.of_most > 0.5 and r.error / r.of_most < 1.01, "record = %s: energy error %s, of the largest %s",
      record, r.error, r.of_most)
    expect(math.abs(summary().energy_error - r.error) < 1e-12, "record = %s: summary.json %s", record,
      summary().energy_error)
  end
end)

-- A static run that finds no equilibrium says so while it looks for one -----------------------------------------------

case("a static run that looks long for an equilibrium tells its progress", function()
  local status, printed, complaint = hinge_run([[
local hinge = require "hinge"
local steel = hinge.material { E = 206e9, density = 7850, yield_stress = 245e6 }
local bar = hinge.section.solid { width = 0.2, depth = 0.2 }
local model, at = hinge.model { elements_per_member = 4 }, {}
for k = 0, 5 do
  for j = 0, 2 do
    for i = 0, 4 do
      local node = model:node { 5 * i, 5 * j, 3.5 * k }
      at[100 * k + 10 * j + i] = node
      if k == 0 then model:fix(node) else
        model:member { at[100 * k - 100 + 10 * j + i], node, section = bar, material = steel, up = { 1, 0, 0 } }
        if i > 0 then model:member { at[100 * k + 10 * j + i - 1], node, section = bar, material = steel } end
        if j > 0 then model:member { at[100 * k + 10 * j + i - 10], node, section = bar, material = steel } end
        model:load { node = node, force = { 6e4, 0, -2e5 } }
      end
    end
  end
end
local run = model:static { steps = 3 }
local clock = os.clock()
run:finish()
io.stderr:write(os.clock() - clock, "\n")
]], "--json")
  local said = events(printed)
  local taken = tonumber(complaint:match "^[%d.]+")
  local odd -- on a fast machine there is no progress to tell
  for _, e in ipairs(said.progress or {}) do
    if not (e.part < 1 and e.step <= e.steps) then odd = e end
  end
  expect(not odd, "while it is halved: part %s, step %s of %s", odd and odd.part, odd and odd.step, odd and odd.steps)
  expect(taken and (taken < 2.5 or said.progress), "nothing was said for %s s", taken)
  expect(status == 1 and said.run_ended and said.run_ended[1].reason:find "a limit load, where .* gives way",
    "an overloaded frame: %s", printed)
end)

-- Likely mistakes are told before the run that they spoil, each once, in ten lines at most ----------------------------

local slips = [[
local hinge = require "hinge"
local steel = hinge.material { E = 206, density = 7850, yield_stress = 245e6 }
local bar = hinge.section.solid { width = 0.2, depth = 0.2 }
local model = hinge.model()
local a, b = model:node { 0, 0, 0 }, model:node { 0, 0, 3000 }
local c, d = model:node { 0, 0, 3000 }, model:node { 4000, 0, 3000 }
model:fix(a, "all")
model:member { a, b, section = bar, material = steel }
model:member { c, d, section = bar, material = steel }
model:gravity { 0, 0, -9.80665 }
model:static {}
]]
local slip_lines = { "E is 206 Pa (the material of member 1) (scene.lua:2); in GPa? 206 GPa is 206e9",
  "member 1 is 3000 m long, 51962 times its section's radius of gyration (and 1 more like it); nodes in mm? "
    .. "positions are in m",
  "nodes 2 and 3 are both at {0, 0, 3000} m, but not joined; use one node for both where their members meet" }
case("likely mistakes of units and supports are warned of before the run", function()
  local printed, complaint = ended(2, "warning: " .. table.concat(slip_lines, "\nwarning: ")
    .. "\nhinge: scene.lua:11: model:static: ", hinge_run(slips))
  expect(printed == "" and complaint:find "^warning" and complaint:find " can .* without resistance: ", "slips: %s%s",
    printed, complaint)
  expect(not select(3, hinge_run(slips, "--quiet")):find "warning", "slips, quiet")
  local said = events(select(2, hinge_run(slips, "--json")))
  equal(said.warning and #said.warning, 3, "slips, --json")
  expect(said.warning and said.warning[1].text:find "^E is 206 Pa" and said.warning[1].line == "scene.lua:2"
    and said.warning[1].advice == "in GPa? 206 GPa is 206e9", "slips, --json: the first")
end)

-- A hundred models with a slip each: ten lines; all of the first fifty in summary.json. The same slip again: one.
local many = [[
local hinge = require "hinge"
for i = 1, 100 do
  local model = hinge.model()
  local a, b = model:node { 0, 0, 0 }, model:node { 0, 0, 3 }
  model:fix(a, "all")
  model:member { a, b, section = hinge.section.solid { width = 0.2, depth = 0.2 },
    material = hinge.material { E = WHICH, density = 7850 } }
  model:load { node = b, force = { 1e-9, 0, 0 } }
  model:static { steps = 1 }:finish()
end
]]
case("a hundred models with a slip each give ten lines", function()
  for E, count in pairs { ["206e9"] = 0, ["100"] = 1, ["100 + i"] = 10 } do -- none, the same one, many
    local _, complaint = ended(0, "", hinge_run((many:gsub("WHICH", E))))
    equal(select(2, complaint:gsub("warning: ", "")), count, "lines with E = " .. E)
    if count == 10 then
      expect(complaint:find "\nwarning: and more than these 9; hinge check tells all\n$", "the last: %s", complaint)
      equal(#(summary().warnings or {}), 50, "many: summary.json")
    elseif count == 0 then equal(complaint, "", "none") end
  end
end)

case("loads that strain beyond reason, and a foot that spins, are warned of by name", function()
  local post = many:gsub("100 do", "1 do"):gsub("WHICH", "206e9, yield_stress = 245e6")
  local _, _, complaint = hinge_run((post:gsub("model:static", "model:load { node = b, force = { 1e8, 0, 0 } } "
    .. "model:static")))
  expect(complaint:find("^warning: the loads would strain member 1 by 109 %% in a linear solution of them; the largest "
    .. "of them is 1e%+08 N, on node 2 %(scene.lua:8%); are the loads in N and N m, "), "loads too large: %s",
    complaint)
  ended(2, { "model:static: a mechanism", "node 1 at {0, 0, 0} m and 1 more node can rotate about z", "fix what" },
    hinge_run((post:gsub('"all"%)', '"xyz") model:fix(b, "xy")'))))
end)

-- Words ---------------------------------------------------------------------------------------------------------------

local beam = [[
local hinge = require "hinge"
local model = hinge.model { displacement = "large", elements_per_member = 2 }
local wall, tip = model:node { 0, 0, 0 }, model:node { 1, 0, 0 }
model:fix(wall)
model:member { wall, tip, section = hinge.section.solid { width = 0.05, depth = 0.05 },
  material = hinge.material { E = 206e9, density = 7850 } }
model:load { node = tip, force = { 0, 0, -1000 } }
]]
case("hinge plan and hinge check use numbers with fitting units", function()
  ended(0, { "static run, scene.lua:8: 1 member, 2 elements, 12 degrees of freedom, 1 step\n",
    "Newmark's method, steps of 2 ms\n" },
    hinge_on("plan", beam .. "model:static { steps = 1 }\nmodel:dynamic { dt = 2e-3, duration = 4e-3 }"))
  local printed = ended(0, { "explicit steps of 15 ns, lumped masses\n", "steps of 12.5 us\n", "steps of 2 s\n",
    " 2 steps\n" }, hinge_on("plan", beam .. "model:dynamic { dt = 1.5e-8, duration = 3e-8, integrator = 'explicit' }\n"
    .. "model:dynamic { dt = 1.25e-5, duration = 1 }\nmodel:dynamic { dt = 2, duration = 4 }"))
  expect(not printed:find "model", "plan: what it does not say: %s", printed)
  ended(0, "\n  the same model as that of the run made at scene.lua:8, with the same warnings\n",
    hinge_on("check", beam .. "model:static { steps = 1 }\nmodel:static { steps = 2 }"))
end)

case("a run that fails names the remedy that holds in a trial", function()
  local newton = { "Newton did not converge in 2 iterations (last correction ", "iterations = 30 holds: tried from " }
  local gradients = "conjugate gradients did not converge in 1 iteration; solver = 'direct' holds: tried from t = "
  for options, wanted in pairs {
    ["dt = 1e-3, internals = { solver_iterations = 1 }"] = { gradients, " s to " },
    ["dt = 1e-3, internals = { solver_iterations = 1 }, energy_tolerance = 0"] = gradients,
    ["dt = 1e-3, iterations = 2, rho_infinity = 0.8"] = newton,
    ["dt = 5e-3, iterations = 2, integrator = 'energy-momentum', step_control = 0"] = newton,
  } do
    local loaded = beam:gsub("%-1000", "-4e4"):gsub("r = 2", "r = 16")
    local run_it = loaded .. "model:dynamic { duration = 0.1, " .. options .. " }:finish()"
    local _, failed = ended(1, wanted, hinge_run(run_it))
    expect(failed:find "hinge: the run failed: step %d+, t = %S+ s: ", "%s: %s", options, failed)
    expect(select(2, failed:gsub("holds", "")) == 1, "%s: one remedy: %s", options, failed)
  end
end)

case("a failed run that another goes on from is told of", function()
  local two = beam:gsub("%-1000", "-1e9") .. [[
local first = model:static { steps = 2 }:finish()
model:dynamic { from = first, duration = 1e-4, dt = 1e-5 }:finish()
]]
  ended(1, { "hinge: static run 1, made at scene.lua:8, failed: ", "goes on from static run 1, which failed at " },
    hinge_run(two))
  local failed = summary().failed_runs
  expect(failed and #failed == 1 and failed[1]:find("^static run 1"), "summary.json: failed_runs")
end)

case("a failed run points back at the units that were doubted", function()
  local cause = "; the cause may be what the warning at scene.lua:6 says: E is 206000 Pa (the material of member 1)\n"
  ended(1, { "hinge: the run failed: ", cause },
    hinge_run((beam:gsub("206e9", "206e3")) .. "model:static { steps = 1 }:finish()\n"))
  local _, _, complaint = hinge_run((beam:gsub("%-1000", "-1e9")) .. "model:static { to_limit = true }:finish()\n")
  expect(not complaint:find "the cause may be what the warning at scene.lua:6", "no units: %s", complaint)
end)

case("a load history that is over before the run begins is warned of", function()
  -- A history that is over where the run begins, for this one goes on in the time of the one before.
  local two = beam .. [[
local rest = model:dynamic { dt = 1e-4, duration = 1e-2 }:finish()
model:load { node = tip, force = { 0, 0, -10 }, history = { { 0, 1 }, { 5e-3, 0 } } }
model:dynamic { from = rest, dt = 1e-4, duration = 1e-2 }:finish()
]]
  local wanted = "warning: the history of the load on node 2 changes from 0 to 0.005 s, and this run begins at 0.01 s, "
    .. "where the run that it goes on from ended: all along it is 0 (scene.lua:9); times go on through runs; add 0.01 s"
  local _, _, complaint = hinge_run(two)
  expect(support.has(complaint, wanted) and select(2, complaint:gsub("warning: ", "")) == 1, "over: %s", complaint)
  for what, history in pairs { ["in time"] = "{ { 0.01, 1 }, { 0.015, 0 } }",
    ["half of it"] = "{ { 0, 1 }, { 0.02, 0 } }" } do
    _, _, complaint = hinge_run((two:gsub("{ { 0, 1.-} }", history)))
    equal(complaint, "", "a history " .. what)
  end
  -- what acted in the run before may be over
  _, _, complaint = hinge_run((two:gsub("(local rest[^\n]*\n)(model:load[^\n]*\n)", "%2%1")))
  equal(complaint, "", "a history that acted before")
end)

case("plain Lua prints the same warnings and failures on stderr", function()
  -- Plain Lua: the same warnings and failures on stderr, nothing else there, and nothing of it where it is to be quiet.
  local function plain(text, before)
    support.write(folder .. "/scene.lua", text)
    return run(("cd %s && %s LUA_CPATH=%s/?.so lua5.4 scene.lua"):format(quote(folder), before or "env -u HINGE_QUIET",
      quote(arg[1])))
  end
  local soft = beam:gsub("206e9", "1e9"):gsub("7850", "78.5e2") .. "model:static { steps = 1 }:finish()\n"
  local doubted = soft:gsub("1e9", "0.9e9")
  for text, wanted in pairs { [soft] = "", [doubted] = "warning: E is 9e+08 Pa (the material of member 1) "
    .. "(scene.lua:6); in kN/m^2? in Pa that would be 9e+11\n" } do
    local printed, complaint = ended(0, "", plain(text .. "print 'done'\n"))
    expect(printed == "done\n" and complaint == wanted, "plain Lua: %s %s", printed, complaint)
    equal(select(3, plain(text, "HINGE_QUIET=1")), "", "plain Lua, quiet")
  end
  local fails = beam:gsub("%-1000", "-1e9") .. "local run = model:static { steps = 2 }:finish()\n"
  for after, told in pairs { [""] = true, ["print(run.factor)"] = true, ["print(run.verdict)"] = false,
    ["if run.reason then end"] = false } do
    local _, complaint = ended(0, "", plain(fails .. after))
    expect((complaint:find "hinge: static run 1, made at scene.lua:8, failed: " ~= nil) == told,
      "plain Lua, a failed run, %s: %s", after, complaint)
  end
  equal(select(3, plain(fails, "HINGE_QUIET=1")), "", "plain Lua, a failed run, quiet")
end)

case("hinge render draws the frames of a scenario", function()
  ended(0, "", hinge_run(beam .. "local run = model:static { steps = 3 }\nreturn hinge.scenario { run = "
    .. "function(_, job) for _ in run:steps() do job:frame(run) end end }"))
  equal(ended(0, "", hinge "render out/scene"), "3 pictures in out/scene\n", "render")
end)

case("pictures, plots, frames and notes go without a job, in the program and in plain Lua", function()
  local drawing = beam .. [[
local run = model:static { steps = 2 }
for _ in run:steps() do hinge.frame(run) end
hinge.picture(run, { title = "beam", width = 200, height = 150 }, "beam.png")
hinge.strip({ { run }, { run:snapshot() } }, 2, "strip.png")
hinge.plot({ series = { { x = { 0, 1 }, y = { 0, 1 } } } }, "curve.png")
hinge.note "looked at"
]]
  local printed = ended(0, "note: looked at\n", hinge_run(drawing))
  equal((summary().notes or {})[1], "looked at", "without a job: the note in " .. printed)
  ended(0, "", run(("mkdir %s/plain && cd %s/plain && LUA_CPATH=%s/?.so lua5.4 ../scene.lua"):format(folder, folder,
    quote(arg[1]))))
  for _, name in ipairs { "beam.png", "strip.png", "curve.png", "frames.pvd", "frames/frame_00002.vtp" } do
    for _, where in ipairs { "/out/scene/", "/plain/" } do
      expect(support.is_there(folder .. where .. name), "no %s in %s", name, where)
    end
  end
  ended(2, "hinge.picture: the run is 5; give what model:static or model:dynamic returned",
    hinge_run(beam .. "hinge.picture(5, {}, 'a.png')"))
  for _, verb in ipairs { "plan", "check" } do ended(0, "", hinge_on(verb, drawing)) end
end)

case("a scenario under plain Lua says how to run it", function()
  local function plain(name, text)
    support.write(folder .. "/" .. name, text)
    return run(("cd %s && LUA_CPATH=%s/?.so lua5.4 %s"):format(folder, quote(arg[1]), name))
  end
  ended(1, "hinge run returned.lua [key=value ...]",
    plain("returned.lua", "return require 'hinge'.scenario { run = function() end }\n"))
  ended(0, "true\n",
    plain("used.lua", "local s = dofile 'returned.lua'\nprint(require 'hinge.program.scenario'.is(s))\n"))
end)

case("a run that takes no step is warned of", function()
  for stepped, warning in pairs { [""] = "warning: 1 run made, and none has taken a step; call run:finish()",
    ["run:finish()"] = "" } do
    local _, complaint = ended(0, "", hinge_run(beam .. "local run = model:dynamic { dt = 1e-4, duration = 1e-3 } "
      .. stepped))
    expect(complaint:find(warning, 1, true) and (warning ~= "" or complaint == ""), "%s: %s", stepped, complaint)
  end
end)

checks.done()
