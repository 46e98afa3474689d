-- Long runs survive: a run goes on from its checkpoint with the same bits, whatever it is doing; what is damaged, of
-- another run or another hinge is refused; killed, stopped, out of disk, nothing that was written is lost.
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local scenes = require "scenes"
local hinge = require "hinge"
local checks = support.checks "checkpoint"
local case, expect, equal, refused = checks.case, checks.expect, checks.equal, checks.refused
local quote, run, with = support.quote, support.run, scenes.with

local folder = support.temporary_folder()
local function path(name) return folder .. "/" .. name end

-- Two portals under their weight, and a bar thrown at one: hinges, fracture, contact, debris.
local scene = [[
local hinge = require "hinge"
local function impact(o)
  local steel = hinge.material { E = 206e9, nu = 0.3, density = 7850, yield_stress = 250e6 }
  local bar = hinge.section.solid { width = 0.1, depth = 0.1 }
  local model, foot, corner = hinge.model(o.model)
  for _, y in ipairs { 0, 2 } do
    local a, b, c, d = model:node { 0, y, 0 }, model:node { 0, y, 3 }, model:node { 3, y, 3 }, model:node { 3, y, 0 }
    model:fix(a)
    model:fix(d)
    for _, ends in ipairs { { a, b }, { b, c }, { c, d } } do
      model:member { ends[1], ends[2], section = bar, material = steel }
    end
    foot, corner = a, b
  end
  local low = model:node { 1.5, -0.3, 2 }
  model:member { low, model:node { 1.5, -0.3, 4 }, section = bar, material = steel, group = "missile" }
  model:velocity("missile", { 0, 100, 0 }, { 3, 0, 0 })
  model:gravity { 0, 0, -9.80665 }
  model:fracture(o.fracture or { curvature_x = 0.15, curvature_y = 0.15, axial_strain = 0.1 })
  model:contact(o.contact or { rule = "gap" })
  local start = model:static { fixed_group = "missile" }
  start:finish()
  if o.declare then o.declare(model, corner, foot) end
  local options = { from = start, dt = 2e-5, duration = 0.012, beta = 0.4 }
  for field, value in pairs(o.run or {}) do options[field] = value end
  if options.integrator == "explicit" or not options.beta then options.beta = nil end
  local run = model:dynamic(options)
  run:probe { node = low, "uy" }
  return run
end
]]
local impact_run = assert(load(scene .. "return impact"))()

-- The same bits -------------------------------------------------------------------------------------------------------

local function same(what, resumed, whole)
  equal(resumed.hash, whole.hash, what .. ": state")
  equal(resumed.verdict, whole.verdict, what .. ": verdict")
  equal(resumed.index, whole.index, what .. ": steps")
  for _, name in ipairs { "initial", "work", "energy_error" } do
    equal(resumed.energy[name], whole.energy[name], what .. ": " .. name)
  end
  -- all but factors, which are not kept: they are made anew from the same numbers
  for name, count in pairs(whole.counts) do
    if name ~= "factorisations" then equal(resumed.counts[name], count, ("%s: %s"):format(what, name)) end
  end
  equal(table.concat(resumed.probes[1].value, " "), table.concat(whole.probes[1].value, " "), what .. ": probe")
  equal(#resumed.state_changes, #whole.state_changes, what .. ": changes of state")
end

-- Runs the scene once, with a checkpoint now and then from which another run goes on, on one thread and on two.
local function goes_on(name, options, times)
  case("a run goes on from a checkpoint with the same bits: " .. name, function()
    local whole = impact_run(options)
    whole:finish()
    expect(whole:count { state = "broken" } > 0 and whole.contacts.bound > 0, "%s: %d broken, %d bound", name,
      whole:count { state = "broken" }, whole.contacts.bound)
    local watched, resumed_from = impact_run(options), 0
    for step in watched:steps() do
      if step.index % (whole.index // times) == 3 then
        resumed_from = resumed_from + 1
        watched:checkpoint(path "one.checkpoint")
        local threads = 1 + resumed_from % 2
        local other = impact_run(with(options, { run = with(options.run, { threads = threads }) }))
          :resume(path "one.checkpoint")
        equal(other.hash, watched.hash, ("%s: state at step %d"):format(name, step.index))
        other:finish()
        same(("%s, from step %d on %d threads"):format(name, step.index, threads), other, whole)
      end
    end
    expect(resumed_from >= times, "%s: went on %d times", name, resumed_from)
    same(name .. ", with checkpoints taken", watched, whole)
    if (options.run or {}).step_control then
      expect(whole.counts.rejected_steps > 2, "%s: %d steps taken back", name, whole.counts.rejected_steps)
    end
  end)
end

goes_on("gap", {}, 8)
goes_on("surfaces with friction", { contact = { rule = "surface", friction = 0.3 } }, 6)
goes_on("explicit", { run = { integrator = "explicit", dt = "auto", duration = 0.01 } }, 4)
goes_on("dt auto", { run = { dt = "auto", duration = 0.01 } }, 6)
goes_on("no rest", { run = { rest = false, beta = 0.25 }, contact = { rule = "surface" } }, 3)
goes_on("point and all", { model = { shift = "elastic_and_plastic" } }, 3)
goes_on("conventional, factors",
  { model = { formulation = "conventional" }, run = { solver = "direct", duration = 0.008 } }, 3)
goes_on("long steps, double",
  { fracture = { curvature_x = 0.03, curvature_y = 0.03 },
    run = { dt = 2e-4, precision = "double", duration = 0.02, energy_tolerance = 0.5 } }, 5)
goes_on("damped, with step control",
  { run = { dt = 8e-5, beta = false, rho_infinity = 0.7, step_control = 3e-4, duration = 0.02 } }, 5)
goes_on("rules of the script's own", {
  fracture = { keep = { "damage" }, rule = function(section)
    section.damage = section.damage + math.abs(section.curvature_rate_x) * section.dt
    return section.damage > 0.03
  end },
  contact = { rule = "surface", pairs = function() return { friction = 0.2 } end },
  declare = function(model, corner, foot)
    model:load { node = corner, force = function(t, r)
      return 100 * math.sin(200 * t), 0, -1e3 * r:displacement(corner)
    end }
    model:move { node = foot, x = function(t) return 1e-3 * math.sin(300 * t) ^ 2 end }
  end,
}, 4)

case("a run that fails goes on from a checkpoint to the same failure", function()
  -- it goes back to a state from before the checkpoint
  local strict = { run = { energy_tolerance = 1e-3, step_control = 0 } }
  local failed = impact_run(strict)
  failed:finish()
  expect(failed.verdict == "failed" and failed.reason:find "energy balance",
    "a run whose energy balance does not close: %s %s", failed.verdict, failed.reason)
  local failing = impact_run(strict)
  while failing.verdict == "running" and failing.index < failed.index + 5 do failing:step() end
  failing:checkpoint(path "failing.checkpoint")
  local fails_too = hinge.resume(impact_run(strict), path "failing.checkpoint")
  fails_too:finish()
  equal(fails_too.reason, failed.reason, "the reason why it failed")
  same("failed", fails_too, failed)
end)

-- What is refused -----------------------------------------------------------------------------------------------------

local function small(dt, more)
  local model, b = scenes.cantilever { force = { 0, 0, -10 } }
  if more then
    model:member { b, model:node { 2, 0, 0 }, section = scenes.square,
      material = hinge.material { E = 206e9, density = 7800 } }
  end
  return model:dynamic { dt = dt, duration = 1e-2 }, b
end

local file = path "small.checkpoint"
local first = small(1e-4)
for _ = 1, 7 do first:step() end
first:checkpoint(file)
local bytes = support.read(file)
local victim = small(1e-4)
case("every byte that is changed and every length that is cut is noticed", function()
  local before = victim.hash
  -- What is not noticed. A file of its own each time: some file systems write to the disk at once what replaces the
  -- content of a file.
  local function passes(text, says)
    os.remove(file)
    support.write(file, text)
    local ok, failure = pcall(victim.resume, victim, file)
    return ok or not tostring(failure):find(says, 1, true) or victim.hash ~= before or victim.index ~= 0
  end
  local unseen = "none"
  for i = 1, #bytes do -- every byte
    local flipped = bytes:byte(i) ~ (i % 2 == 0 and 255 or 1 << (i % 8))
    local text = bytes:sub(1, i - 1) .. string.char(flipped) .. bytes:sub(i + 1)
    if unseen == "none" and passes(text, "checkpoint " .. file .. " is ") then unseen = i end
  end
  equal(unseen, "none", "byte changed that was not noticed")
  for length = 0, #bytes - 1 do -- every length
    if unseen == "none" and passes(bytes:sub(1, length), "is cut short") then unseen = length end
  end
  equal(unseen, "none", "cut short, not noticed, at byte")
end)

case("a byte too many, another file, no file and another version are refused", function()
  support.write(file, bytes .. "\0")
  refused("checkpoint " .. file .. " is damaged: ", victim.resume, victim, file)
  support.write(file, "speed,height\n" .. bytes)
  refused("checkpoint " .. file .. " is no checkpoint of hinge; is it the right file?", victim.resume, victim, file)
  refused("cannot read " .. path "none" .. ": No such file or directory; check the name", victim.resume, victim,
    path "none")

  -- Another version: the checksum (CRC-32 of all behind it) is right.
  local function crc(text)
    local c = 0xffffffff
    for i = 1, #text do
      c = c ~ text:byte(i)
      for _ = 1, 8 do c = (c >> 1) ~ (0xedb88320 & -(c & 1)) end
    end
    return ~c & 0xffffffff
  end
  local own = string.unpack("<I4", bytes, 13)
  local newer = string.pack("<I4", own + 1) .. "9.8.7" .. ("\0"):rep(11) .. bytes:sub(33)
  support.write(file, bytes:sub(1, 8) .. string.pack("<I4", crc(newer)) .. newer)
  refused({ ("checkpoint %s is of format %d, written by hinge 9.8.7"):format(file, own + 1),
    ("this is hinge %s, which reads format %d: go on with the hinge that wrote it, or start the run anew")
      :format(hinge.version, own) }, victim.resume, victim, file)
end)

case("a checkpoint of another model, step or set of probes is refused", function()
  support.write(file, bytes)
  local probed, tip = small(1e-4)
  probed:probe { node = tip, "uz", name = "tip" }
  local in_step = impact_run { declare = function(model, corner)
    model:load { node = corner, force = function(_, r) r:checkpoint(file) return 0, 0, 0 end }
  end }
  for _, row in ipairs {
    { { "checkpoint " .. file .. " is of another run, which differs in dt", "; give the script and parameters " },
      function() small(5e-5):resume(file) end },
    { "is of another run, which differs in nodes (2 there, 3 here), members (1 there, 2 here), materials (1 there, 2 "
      .. "here), sections (1 there, 2 here), groups and velocities (2 there, 3 here); give",
      function() small(1e-4, true):resume(file) end },
    { "is of a run with other probes (there: none; here: tip); ask for the same ones before the run goes on",
      function() probed:resume(file) end },
    { "run:resume: the run has begun (step 7, t = 0.0007 s); resume before its first step",
      function() first:resume(file) end },
    { "run:checkpoint: called from a function in the middle of a step; call it between steps, or in run:on_step",
      in_step.step, in_step },
    { "run:checkpoint: the file is nil; give its name, such as 'case1.checkpoint'", function() first:checkpoint() end },
    { "run:checkpoint: the run is static; checkpoints are for dynamic runs, a static one is done anew",
      function() scenes.cantilever():static {}:checkpoint(file) end },
  } do refused(row[1], row[2], row[3]) end
end)

case("wrong checkpoint options of model:dynamic are refused", function()
  local itself = {}
  itself.t = itself
  for given, message in pairs {
    [7] = { "field 'checkpoint' is 7", "must be a file name, or { file =, every = s, keep = table }" },
    [{}] = { "field 'checkpoint' is a table", "must be a file name, or { file =, every = s, keep = table }" },
    [{ file = "x", keep = 3 }] = { "checkpoint: field 'keep' is 3", "must be a table, whose values are kept" },
    [{ file = "x", keep = { list = { 1, print } } }] =
      { "checkpoint: keep.list[2] is a function; only booleans, numbers, strings and tables of them can be kept" },
    [{ file = "x", keep = itself }] = { "checkpoint: keep.t.", "is nested too deep to be kept; does a table hold it" },
    [{ file = "x", every = -1 }] = { "checkpoint: field 'every' is -1 s; must be " },
  } do
    refused(message, impact_run, { run = { checkpoint = given } })
  end
end)

case("a run goes on with the same bits after a step that was rejected, where members that yield are tied", function()
  local function made() return impact_run { run = { duration = 0.01 } } end
  local whole, rejected = made(), nil
  for step in whole:steps() do -- steps 276 and later are those after a rejected one
    rejected = rejected or whole.counts.rejected_steps > 6 and step.index
  end
  for at = rejected, rejected + 4, 4 do
    local part, rest = made(), made()
    for step in part:steps() do
      if step.index == at then part:checkpoint(path "rejected.checkpoint") break end
    end
    rest:resume(path "rejected.checkpoint")
    same("after step " .. at, rest:finish(), whole)
  end
end)

case("a run that refused checkpoints resumes the right one with the same bits", function()
  victim:resume(file) -- and is none the worse for all that
  victim:finish()
  first:finish()
  equal(victim.hash, first.hash, "the small run, resumed after all")
end)

case("what a script gathers in keep goes on with the run", function()
  local function gathers(keep)
    local model, b = scenes.cantilever { force = { 0, 0, -10 } }
    local r = model:dynamic { dt = 1e-4, duration = 1e-2,
      checkpoint = { file = path "gathers.checkpoint", keep = keep } }
    return r, function(step)
      keep.list[#keep.list + 1], keep.last, keep[1.5] = r:displacement(b), step.index % 2 == 0,
        { n = step.index, s = "a\0b" }
    end
  end
  local all, half, rest = { list = {} }, { list = {} }, { list = {}, lost = 1 }
  local r, gather = gathers(all)
  for step in r:steps() do gather(step) end
  r, gather = gathers(half)
  for step in r:steps() do
    gather(step)
    if step.index == 40 then r:checkpoint(path "gathers.checkpoint") break end
  end
  r, gather = gathers(rest)
  r:resume(path "gathers.checkpoint")
  expect(#rest.list == 40 and rest.lost == nil and rest.last == true and rest[1.5].n == 40 and rest[1.5].s == "a\0b"
    and math.type(rest[1.5].n) == "integer", "what the script gathered, at step 40")
  for step in r:steps() do gather(step) end
  equal(#all.list, 100, "what was gathered")
  equal(table.concat(rest.list, " "), table.concat(all.list, " "), "what was gathered, half of it before")
end)

-- The program ---------------------------------------------------------------------------------------------------------

local program = quote(arg[1] .. "/hinge")
support.write(path "impact.lua", scene .. [[
return hinge.scenario {
  parameters = { duration = 0.1, every = 0.005, checkpoint = "impact.checkpoint", threads = 1, slow = 0, stall = 0 },
  run = function(p)
    local plan = p.checkpoint ~= "none" and { file = p.checkpoint, every = p.every } or nil
    local run = impact { run = { duration = p.duration, threads = p.threads, checkpoint = plan } }
    if p.slow > 0 then run:on_step(function(r) if r.index == p.slow then os.execute("kill -TERM $PPID") end end) end
    if p.stall > 0 then run:on_step(function(r) if r.index > p.stall then os.execute "sleep 0.02" end end) end
    run:finish()
    return { uy = run.probes[1].last, steps = run.index }
  end,
}
]])
local function command(out, more)
  return ("%s run %s --out %s %s"):format(program, quote(path "impact.lua"), quote(path(out)), more or "")
end
local function summary(out) return support.json(support.read(path(out) .. "/summary.json") or "{}") end
local function history(out) return support.read(path(out) .. "/history.csv") end

local whole_status = run(command "whole")
local wanted = summary "whole"
local function as_whole(what, out)
  equal(summary(out).state_hash, wanted.state_hash, what .. ": state")
  equal(summary(out).results.uy, wanted.results.uy, what .. ": result")
  expect(history(out) == history "whole", "%s: history.csv is another", what)
end
case("a run with a checkpoint completes", function()
  equal(whole_status, 0, "a run with a checkpoint")
  expect(#history "whole" > 10000 and wanted.results.steps >= 5000, "the run: %s", wanted.results.steps)
end)

case("a run ended by SIGTERM writes a checkpoint and goes on with --resume", function()
  local status, _, complaint = run(command("ended", "slow=1234"))
  equal(status, 3, "status after SIGTERM")
  local at = complaint:match "after step 1234, (t = %S+ s); written" -- some steps before it were halved
  expect(complaint:find(("hinge: interrupted by SIGTERM after step 1234, %s; written to "):format(at)
    .. path "ended/impact.checkpoint" .. "; the same command with --resume goes on from there", 1, true),
    "after SIGTERM: %s", complaint)
  expect(not support.is_there(path "ended/summary.json"), "a summary of a run that is not over")
  local _, told = run(program .. " history " .. quote(path "ended"))
  expect(told:find("  no summary, but a checkpoint, impact.checkpoint: the script has not ended, or stumbled; the same "
    .. "command with --resume goes on from it; hinge ", 1, true), "history of an interrupted run: %s", told)
  status, _, complaint = run(command("ended", "threads=2 --resume"))
  equal(status, 0, "status of --resume: " .. complaint)
  expect(support.says(complaint, path "ended" .. " held the run of ...impact.lua, slow = 1234; what has a checkpoint "
    .. "there goes on as the run of ...impact.lua, threads = 2\n...") and not complaint:find "replaced",
    "whose it was: %s", complaint)
  expect(complaint:find("goes on from " .. path "ended/impact.checkpoint: step 1234, " .. tostring(at), 1, true),
    "--resume: %s", complaint)
  as_whole("after SIGTERM", "ended")
  status, _, complaint = run(command("ended", "--resume"))
  equal(summary "ended".resumed_at, 1234, "resumed_at of a run that is over")
  expect(status == 0 and complaint:find("step " .. wanted.results.steps, 1, true),
    "--resume of a run that is over: %s %s", status, complaint)
  as_whole("over, once more", "ended")
end)

case("a run without a checkpoint that SIGTERM ends says that it starts anew", function()
  local status, _, complaint = run(command("unkept", "slow=100 checkpoint=none"))
  equal(status, 143, "status after SIGTERM without a checkpoint")
  local _, told = run(program .. " history " .. quote(path "unkept"))
  expect(told:find("  no summary: the script has not ended, or stumbled; hinge ", 1, true), "without: %s", told)
  expect(complaint:find("names no checkpoint (checkpoint = 'FILE' in model:dynamic) and starts anew next time", 1,
    true), "without: %s", complaint)
  -- the heading, step 0, and one in ten
  equal(select(2, history "unkept":gsub("\n", "")), 12, "rows of the history that SIGTERM left")
end)

case("--resume starts anew where there is no checkpoint and refuses that of another run", function()
  local status, _, complaint = run(command("fresh", "--resume duration=0.002"))
  expect(status == 0 and complaint:find("--resume: there is no "
    .. path "fresh/impact.checkpoint; the run starts from its beginning", 1, true),
    "--resume without a checkpoint: %s %s", status, complaint)
  status, _, complaint = run(command("fresh", "--resume duration=0.004"))
  expect(status == 2 and complaint:find("differs in duration", 1, true), "--resume of another run: %s %s",
    status, complaint)
  status, _, complaint = run(command("fresh", "duration=0.004"))
  expect(status == 0 and not support.is_there(path "fresh/impact.checkpoint.before"),
    "anew after one that is over: %s %s", status, complaint)
  equal(run(command("again", "slow=50")), 3, "status after SIGTERM")
  status, _, complaint = run(command("again", "duration=0.004"))
  expect(status == 0 and complaint:find("is of a run that is not over, and kept as "
    .. path "again/impact.checkpoint.before", 1, true), "anew: %s %s", status, complaint)
end)

case("a run killed 50 times and resumed has the same bits and files", function()
  support.write(path "kill.sh", ([[
RANDOM=11 kills=0 ends=0
while [ $kills -lt 50 ]; do
  %s >%s 2>&1 & p=$!
  sleep $(printf 0.%%03d $((RANDOM %% 60 + 5)))
  kill -9 $p
  wait $p; s=$?
  if [ $s = 137 ]; then kills=$((kills + 1))
  elif [ $s = 0 ]; then ends=$((ends + 1)); rm %s
  else echo "status $s"; cat %s; exit 1; fi
  if [ -e %s ] && [ -n "$(tail -c 1 %s)" ]; then echo "half a row"; exit 1; fi
done
echo "kills $kills ends $ends"
]]):format(command("killed", "duration=0.05 every=0 --resume"), path "log", path "killed/impact.checkpoint",
    path "log", path "killed/history.csv", path "killed/history.csv"))
  local killed, printed, complaint = run("bash " .. quote(path "kill.sh"))
  expect(killed == 0 and printed:find "kills 50", "kill -9: %s %s", printed, complaint)
  print("kill -9: " .. printed:gsub("\n", ""))
  equal(run(command("killed", "duration=0.05 --resume")), 0, "after the last kill")
  equal(run(command("unkilled", "duration=0.05")), 0, "never killed")
  equal(summary "killed".state_hash, summary "unkilled".state_hash, "killed 50 times: state")
  expect(history "killed" == history "unkilled", "killed 50 times: history.csv is another")
  checks.same_files(path "killed/events.csv", path "unkilled/events.csv", "killed 50 times")
end)

case("a killed run without a checkpoint leaves its history, its events and a report", function()
  -- it is slow towards its end; events.csv has all that happened up to the last row of history.csv
  local function lines_of(name)
    local lines = {}
    for line in (support.read(name) or ""):gmatch "[^\n]+" do lines[#lines + 1] = line end
    return lines
  end
  local all_events = lines_of(path "whole/events.csv")
  expect(#all_events > 12, "events of the whole run: %d", #all_events - 1)
  support.write(path "kill_once.sh", ([[
%s >%s 2>&1 & p=$!
for i in $(seq 600); do
  [ -e %s ] && [ $(wc -l <%s) -gt 20 ] && break
  sleep 0.01
done
kill -9 $p
wait $p
[ $? = 137 ]
]]):format(command("cut", "checkpoint=none stall=4500"), path "log", path "cut/history-1.csv", path "cut/history.csv"))
  equal(run("bash " .. quote(path "kill_once.sh")), 0, "a run that is killed")
  local rows, events = lines_of(path "cut/history.csv"), lines_of(path "cut/events.csv")
  local reached, due = tonumber((rows[#rows] or ""):match "^[^,]*") or 0, 1
  while all_events[due + 1] and tonumber(all_events[due + 1]:match "^[^,]*") <= reached do due = due + 1 end
  print(("killed at %g s at least: %d rows, %d of %d events"):format(reached, #rows - 1, #events - 1, #all_events - 1))
  expect(due > 10 and #events >= due, "killed after %g s: %d lines of events.csv, wanted %d", reached, #events, due)
  for i = 1, math.min(#events, #all_events) do
    equal(events[i], all_events[i], "killed: line " .. i .. " of events.csv")
  end
  local told_status, told_of, told_wrong = run(program .. " report " .. quote(path "cut"))
  equal(told_status, 0, "hinge report of a run that was killed: " .. told_wrong)
  expect(told_of:find("cut/report.html: 1 run, 0 frames", 1, true), "it says %s", told_of)
  local cut_page = support.read(path "cut/report.html") or ""
  expect(cut_page:find('"summary":null,"owner":{', 1, true), "its page has a summary, or not whose it is")
end)

case("a full disk keeps the checkpoint before and the run goes on", function()
  local status, _, complaint
  local tiny = path "tiny"
  os.execute("mkdir " .. quote(tiny))
  local mounted = ("unshare -rm sh -c 'mount -t tmpfs -o size=200k tmpfs %s && %%s'"):format(tiny)
  local can_mount = os.execute(mounted:format "true" .. " 2>" .. quote(path "log"))
  local kept = ("; s=$?; cp -r %s/out %s; exit $s"):format(tiny, path "full")
  if can_mount then
    local inside = ("%s run %s --out %s"):format(program, path "impact.lua", tiny .. "/out") .. kept
    status, _, complaint = run(mounted:format((inside:gsub("'", ""))))
  else
    status, _, complaint = run(("trap '' XFSZ; ulimit -f 100; %s"):format(command "full"))
  end
  print("full disk: " .. (can_mount and "a file system of 200 kB" or "a limit on the size of files"))
  expect(complaint:find("cannot write .-: N?F?[oi][ l][se].-; the run goes on, the checkpoint before stays as it was"),
    "full disk: status %s, %s", status, complaint)
  status, _, complaint = run(command("full", "--resume"))
  expect(status == 0 and complaint:find "goes on from", "after a full disk: %s %s", status, complaint)
  as_whole("after a full disk", "full")
end)

case("a checkpoint in a folder that cannot be written to is refused before the first step", function()
  for name, message in pairs { ["/proc/hinge/x.checkpoint"] = "cannot make folder /proc/hinge",
    ["/proc/x.checkpoint"] = "cannot write /proc/x.checkpoint" } do
    local status, _, complaint = run(command("nowhere", "checkpoint=" .. name))
    expect(status == 1 and complaint:find(message, 1, true), "unwritable: %s %s", status, complaint)
  end
end)

checks.done()
