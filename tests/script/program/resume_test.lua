-- hinge run --resume of a run that has ended, checkpoints and output folders in which something is in the way or has
-- gone, and what killed processes leave.
--
-- Run: lua5.4 tests/script/program/resume_test.lua BUILD_FOLDER
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local checks = support.checks "resume"
local case, expect, equal = checks.case, checks.expect, checks.equal
local quote = support.quote
local _, folder, program = support.scenes(arg[1])
local function path(name) return folder .. "/" .. name end
local function hinge(words) return program("run " .. words) end

-- A bar that swings as a pendulum, in steps so long that energy is lost; with `strict` the run fails for that. With
-- `wall` it strikes a post, which breaks.
support.write(path "swing.lua", [[
local hinge = require "hinge"
local p = ...
local steel = hinge.material { E = 210e9, density = 7850, yield_stress = 235e6 }
local bar = hinge.section.solid { width = 0.02, depth = 0.02 }
local model = hinge.model {}
local pin, free = model:node { 0, 0, 0 }, model:node { 2, 0, 0 }
model:fix(pin, "xyz rx rz")
model:member { pin, free, section = bar, material = steel }
model:gravity { 0, 0, -9.81 }
if p.wall then
  local foot, top = model:node { 0.1, -1, -1 }, model:node { 0.1, 1, -1 }
  model:fix { foot, top }
  model:member { foot, top, section = bar, material = steel, group = "post" }
  model:fracture { group = "post", curvature_x = 0.05, curvature_y = 0.05 }
  model:contact {}
end
local run = model:dynamic { dt = tonumber(p.dt) or 5e-3, duration = p.wall and 0.7 or 2, step_control = 0,
  energy_tolerance = p.strict and 1e-6 or p.loose and 0 or nil, iterations = p.loose and 1 or nil,
  checkpoint = { file = "swing.checkpoint", every = 100 } }
local tip = run:probe { node = free, "uz" }
run:finish()
print(run.verdict, run.time, run.energy_error, run.energy_error_of_state, run.worst_energy_error, run.reason,
  #run.warnings, #tip.value, run.fastest.speed, run.counts.solves, run:count { state = "broken" }, run.hash)
]])

-- Runs it into a folder, then once more with --resume; returns both statuses, what both printed and wrote.
local function twice(words)
  local out = words:gsub("[ =]", "_")
  local status, printed, said = hinge(("swing.lua %s --out %s"):format(words, out))
  support.output(("cp -r %s %s"):format(quote(path(out)), quote(path(out .. "_first"))))
  local again, printed_again, said_again = hinge(("swing.lua %s --out %s --resume"):format(words, out))
  return out, status, again, printed, printed_again, said, said_again
end
for _, one in ipairs { { "completes", "dt=5e-3", 0 }, { "completes with a large energy error", "loose=1 dt=0.01", 0 },
  { "fails by its energy balance", "strict=1", 1 }, { "fails after hinges and contact", "wall=1 dt=1e-3", 1 },
  { "breaks a member in contact", "wall=1 dt=2e-5 loose=1", 0 } } do
  case(("--resume of a run that %s gives the same bytes"):format(one[1]), function()
    local out, status, again, printed, printed_again, said, said_again = twice(one[2])
    expect(status == one[3] and again == status, "%s: status %s, then %s: %s", one[1], status, again, said)
    expect(#printed > 20 and printed == printed_again, "printed\n%sand then\n%s", printed, printed_again)
    expect(said_again:find "is of a run that has ended: step %d+", "what --resume says: %s", said_again)
    local differ = support.output(("diff -rq %s %s"):format(quote(path(out)), quote(path(out .. "_first"))))
    equal(differ, "", "files that differ")
    local _, warnings = said:gsub("warning: ", "")
    equal(select(2, said_again:gsub("warning: ", "")), warnings, "warnings that are told again")
    local failure = said:match "hinge: the run failed[^\n]*"
    equal(said_again:match "hinge: the run failed[^\n]*", failure, "the failure is told again")
    expect((failure ~= nil) == (one[3] == 1), "failure: %s", tostring(failure))
  end)
end

case("a folder in the place of a checkpoint is an error and stays", function()
  for _, resume in ipairs { "", " --resume" } do
    support.output("mkdir -p " .. quote(path "way/swing.checkpoint"))
    checks.ended(1, { "way/swing.checkpoint", "folder" }, hinge("-q swing.lua --out way" .. resume))
    expect(support.is_there(path "way/swing.checkpoint/.") and not support.is_there(path "way/swing.checkpoint.before"),
      "the folder has moved")
  end
end)

-- A run of some 100,000 steps that tells when it is under way, and waits until its folder has gone.
support.write(path "long.lua", [[
local hinge = require "hinge"
local p = ...
local model = hinge.model {}
local a, b = model:node { 0, 0, 0 }, model:node { 0, 0, 3 }
model:fix(a)
model:member { a, b, section = hinge.section.solid { width = 0.1, depth = 0.1 },
  material = hinge.material { E = 210e9, density = 7850 } }
model:load { node = b, force = { 1e3, 0, 0 } }
local run = model:dynamic { dt = 1e-4, duration = 0.4, record = 1 }
for step in run:steps() do
  if step.index == 100 then
    local until_then = os.clock() + 0.7 -- rows are written every half second
    while os.clock() < until_then do end
  elseif step.index == 200 then
    os.execute(p["then"])
    if p.frame then hinge.frame(run) end
  end
end
]])
for _, one in ipairs { { "an output folder that is removed", "rm -rf gone", "gone" },
  { "an output folder whose files are removed", "rm -f emptied/*", "emptied" },
  { "an output folder that is moved", "mv moved moved_to", "moved" },
  { "an output folder that another one has replaced", "mv new_one old && mkdir new_one && touch new_one/history.csv",
    "new_one" } } do
  case(one[1] .. " while a run writes to it is an error", function()
    checks.ended(1, "removed", hinge(("-q long.lua then=%s --out %s"):format(quote(one[2]), one[3])))
    local left = support.read(path(one[3] .. "/history.csv"))
    expect(left == nil or left == "", "a history without a head: %s", (left or ""):sub(1, 100))
    local moved = support.read(path(one[3] == "moved" and "moved_to/history.csv" or "old/history.csv"))
    if one[3] == "moved" or one[3] == "new_one" then
      expect(moved and moved:find "^time,factor" and moved:sub(-1) == "\n", "what was written is complete")
    end
    expect(not support.is_there(path(one[3] .. "/summary.json")), "a summary without its run")
  end)
end

case("what a killed writer has left of a file is removed by its next writer, and other files are not", function()
  support.output("mkdir -p " .. quote(path "parts"))
  local mine = { "summary.json.4711.part", "history.csv.12.part", "swing.checkpoint.999999.part" }
  local others = { "film.001.part", "summary.json.part", "x.csv.17.part", "summary.json.a1.part" }
  for _, list in ipairs { mine, others } do
    for _, name in ipairs(list) do support.write(path("parts/" .. name), "half") end
  end
  equal(hinge "-q swing.lua --out parts", 0, "status")
  for _, name in ipairs(mine) do expect(not support.is_there(path("parts/" .. name)), "%s is still there", name) end
  for _, name in ipairs(others) do expect(support.is_there(path("parts/" .. name)), "%s has gone", name) end
end)

case("the unfinished file of a writer that is at work stays", function()
  if support.output "command -v flock" == "" then return expect(true, "no flock here") end
  support.write(path "parts/summary.json.4712.part", "half")
  checks.ended(0, "", support.run(("cd %s && flock -x parts/summary.json.4712.part %s run -q swing.lua --out parts")
    :format(quote(folder), quote(arg[1] .. "/hinge"))))
  expect(support.is_there(path "parts/summary.json.4712.part"), "it was removed")
end)

checks.done()
