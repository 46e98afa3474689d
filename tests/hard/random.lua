-- Random scenes: many small structures, drawn by seed, with the energy balance watched by this script.
--
-- Run     lua5.4 tests/hard/random.lua [name=value ...], with the module on LUA_CPATH
--         count=200 first=1    so many seeds, from the first; with class, setting or fast of those that fit
--         seed=N               this seed alone, with the history of its balance
--         seeds=N,N,...        these seeds
--         why                  every seed also with p_delta chord, 4 and 8 elements, a quarter of its step, and without
--                              contact, fracture or plasticity: what its error comes from
--         class=NAME           only seeds of this class; as=NAME: all seeds as this class ("hit frame": the frames hit
--                              by a bar; "struck column": one member pressed by 20 t;
--                              floors: buildings with slabs)
--         setting=NAME         only seeds of this setting: auto, explicit, fine dt, coarse dt
--         guard=off|on         energy_tolerance of the runs: 0 (default), or their own default
--         set.NAME=VALUE       an option of the model (p_delta, elements_per_member) or of the run (dt, integrator,
--                              step_control, ...) in place of the scene's own; set.dt_times=0.25: that part of its
--                              own step; set.contact=none, set.fracture=none, set.plasticity=false: without these;
--                              set.fracture=hinges: limits of rotation and elongation in place of those drawn;
--                              set.ground=points: elastic points in place of the layer
--         out=FILE.csv         a line for each seed is added; seeds that it already has are not run again
--         jobs=1               processes at a time; each scene has a process of its own
--         seconds=20           longest time of a scene; then it counts as failed, "too slow"
--         compare              every seed with p_delta member and chord, 2, 4 and 8 elements, steps of 20 and 5 us;
--                              with as="hit frame" count=40: what bending between joints loses, what the step loses
--         remedy               a run that fails is run again, whole, with what its reason names as a remedy; with
--                              guard=on the runs are those that a user has
--         fast                 only seeds with a small budget of steps, and of these the first 40 %, at most 5000
--                              steps and 3e5 updates of elements (steps are halved): 24 of 200 scenes reach that
--         tell                 prints the scenes' descriptions and runs none
--         check                the status is 1 where a bound in `bounds` is not kept
-- Shows   a table by class and by setting: how many completed, energy errors over 0.1, 1 and 10 %, the largest one, how
--         many failed by name, how many completed with an error over 1 % and a warning of it, and how many without
--         one: wrong in silence
--
-- Errors are the run's energy error over the largest physical energy that was supplied up to then (initial energy, work
-- of loads and supports, potential energy released), looked at every step or every five. The error itself never counts
-- there. What came out of an account that can only take energy in, such as damping, counts as an error too.
local folder = arg[0]:match "^(.*)[/\\]" or "."
package.path = folder .. "/?.lua;" .. package.path
local hinge = require "hinge"
local core = require "hinge.core"
local values = require "hinge.library.values"
local scenes = require "random_scenes"
package.path = folder .. "/../script/?.lua;" .. package.path
local largest_of = require("support").largest_of
local with = require("scenes").with

-- What `check` asks for, as parts of all scenes. The 200 fast ones gave these numbers when they were written here, less
-- two scenes for other processors: raise them with the engine, never lower them. None may be refused or crash.
local bounds = { completed = 0.99, within_1_percent = 0.99, within_01_percent = 0.96, silent = 0 }

local options, changed = { count = 200, first = 1, jobs = 1, seconds = 20, guard = "off" }, {}
for _, word in ipairs(arg) do
  local name, value = word:match "^([%w_.]+)=(.*)$"
  if not name then name, value = word, true end
  value = tonumber(value) or value == "true" or value ~= "false" and value
  if name:match "^set%." then changed[name:sub(5)] = value else options[name] = value end
end
if options.fast then changed.part = 0.4 end
local most_steps, most_updates = 5000, 3e5 -- of a fast scene
if options.guard == "off" then changed.energy_tolerance = 0 end

-- One scene --------------------------------------------------------------------------------------------------------

local function one_line(text) return (tostring(text):gsub("%s*\n%s*", " ")) end

-- Energy supplied up to now: what was there, work done on it, and what gravity released.
local function supply(energy) return energy.initial + largest_of(0, energy.work) + largest_of(0, -energy.gravity) end

-- What the balance does not explain: its error, and what has come out of accounts that can only take energy in.
local taking = { "kinetic", "elastic", "plastic", "fracture", "contact", "ground", "damping", "panels",
  "panel_contact" }
local function made(energy)
  local sum = energy.energy_error
  for _, name in ipairs(taking) do
    local account = energy[name] or 0
    if not (account >= 0) then sum = sum < 0 and sum + account or sum - account end
  end
  return sum
end

-- Largest error of the samples { time, error, supplied so far }, as a part of the energy supplied up to then; and
-- its time. Where little was supplied yet, a twentieth of what was supplied while the balance closed counts.
local function worst_of(samples)
  local sound = 0
  for _, p in ipairs(samples) do
    if not (math.abs(p[2]) <= p[3]) then break end
    sound = largest_of(sound, p[3])
  end
  local worst, at = 0, 0
  for _, p in ipairs(samples) do
    local share = math.abs(p[2]) / largest_of(p[3], 0.05 * sound, 1e-9)
    if share ~= share then share = math.huge end
    if share > worst then worst, at = share, p[1] end
  end
  return worst, at
end

-- Runs a scene. Returns a table: verdict, reason, worst, at, seconds, steps; history, its samples.
local function run_scene(scene, changes)
  local out = { worst = 0, at = 0, steps = 0, verdict = "completed", reason = "" }
  local begun = os.clock()
  local samples, run = {}, nil
  local ok, problem = pcall(function()
    local model, more = scene.make(hinge, changes)
    run = model:dynamic(more)
    local supplied, count, every = 0, 0, run.planned_steps < 1000 and 1 or 5
    run:on_step(function(r)
      count = count + 1
      if count % every == 0 or r.index >= r.planned_steps then
        local e = r.energy
        local now = supply(e)
        if now > supplied or now ~= now then supplied = now end
        samples[#samples + 1] = { r.time, made(e), supplied, e }
      end
      if os.clock() - begun > options.seconds then
        out.slow = true
        r:stop()
      elseif options.fast and count % 50 == 0 and (count >= most_steps or r.counts.element_updates > most_updates) then
        out.enough = true
        r:stop()
      end
    end)
    run:finish()
    out.verdict, out.reason, out.steps = run.verdict, run.reason, run.index
    if out.enough and out.verdict == "stopped" then out.verdict = "completed" end
    out.warnings = run.warnings
    for _, warning in ipairs(run.warnings) do
      if warning:find "^the energy error at " then out.verdict = "warned" end
    end
    if out.slow then out.verdict, out.reason = "failed", ("too slow at t = %.3g s"):format(run.time) end
    return model
  end)
  if not ok then out.verdict, out.reason = "refused", tostring(problem) end
  out.seconds = os.clock() - begun
  out.worst, out.at = worst_of(samples)
  out.history, out.reason = samples, one_line(out.reason)
  return out
end

-- The remedy that the reason of a failed run names: its words and the changes that they ask for, or nil.
local function remedy_of(reason, elements_per_member)
  local words = reason:match "; ([^;]-) holds: tried from" or reason:match "; ([^;]-) may hold %(not tried"
  if not words then return nil end
  local changes = {}
  for name, value in words:gmatch "([%a_]+) = '?([%w.%-]+)" do changes[name] = tonumber(value) or value end
  if words:find("more elements a member", 1, true) then
    changes.elements_per_member = 2 * (math.tointeger(elements_per_member) or 2)
  end
  return words, changes
end

-- The scene once more, with the remedy that its first run named; adds to `out` what came of it.
local function take_remedy(seed, changes, out)
  local words, more = remedy_of(out.reason, changes.elements_per_member)
  if not words then
    out.reason = out.reason .. " REMEDY none"
    return
  end
  local again = run_scene(scenes.scene(seed, options.as), with(changes, more))
  out.reason = ("%s REMEDY %s: %s, largest error %.3g %% %s"):format(out.reason, words, again.verdict,
    100 * again.worst, again.reason)
end

-- The file of results ----------------------------------------------------------------------------------------------

local columns = { "seed", "class", "setting", "verdict", "worst", "at", "seconds", "steps", "reason", "scene" }

local function quoted(text) return '"' .. tostring(text):gsub('"', "'") .. '"' end

local function line_of(scene, out)
  return table.concat({ scene.seed, quoted(scene.class), quoted(scene.setting), out.verdict,
    ("%.4g"):format(out.worst), ("%.6g"):format(out.at), ("%.3f"):format(out.seconds), out.steps, quoted(out.reason),
    quoted(table.concat(scene.words, "; ")) }, ",")
end

local function read_line(line)
  local fields = values.csv_fields(line)
  local row = {}
  for i, name in ipairs(columns) do
    row[name] = fields[i]
    if not fields[i] then return nil end
  end
  for _, name in ipairs { "seed", "worst", "at", "seconds", "steps" } do
    local x = row[name]
    row[name] = x:match "^inf" and math.huge or tonumber(x)
    if not row[name] then return nil end
  end
  return row
end

-- The table --------------------------------------------------------------------------------------------------------

-- A reason without its numbers and names, as a kind of failure.
local function kind(reason)
  reason = reason:gsub("^%S*random_scenes%.lua:%d+: ", "")
  local text = reason:gsub(" REMEDY .*", ""):gsub("%. The state.*", ""):gsub("; fastest was.*", "")
  text = text:gsub("^step %d+, t = %S+ s: ", "")
  text = text:gsub("[-+]?%d+%.?%d*e?[-+]?%d*", "#"):gsub("'[^']*'", "'...'")
  return text:sub(1, 110)
end

local function summary(rows)
  local function new() return { n = 0, completed = 0, over = { 0, 0, 0 }, largest = 0, failed = 0, warned = 0,
    silent = 0, wild = 0, seconds = 0, times = {} } end
  local groups, order = {}, {}
  local function add(name, row)
    local group = groups[name]
    if not group then
      group = new()
      groups[name], order[#order + 1] = group, name
    end
    group.n, group.seconds = group.n + 1, group.seconds + row.seconds
    group.times[#group.times + 1] = row.seconds
    for i, limit in ipairs { 1e-3, 1e-2, 1e-1 } do
      if not (row.worst <= limit) then group.over[i] = group.over[i] + 1 end
    end
    group.largest = largest_of(group.largest, row.worst)
    if row.verdict == "completed" or row.verdict == "warned" then
      group.completed = group.completed + 1
      if row.verdict == "warned" then group.warned = group.warned + 1
      elseif not (row.worst <= 1e-2) then group.silent = group.silent + 1 end
    else
      group.failed = group.failed + 1
      if row.verdict ~= "failed" then group.wild = group.wild + 1 end
    end
  end
  for _, row in ipairs(rows) do
    add("class " .. row.class, row)
    add("setting " .. row.setting, row)
    add("~all", row)
  end
  table.sort(order)
  print(("%-24s %6s %9s %7s %6s %6s %11s %7s %7s %7s %8s %7s"):format("", "scenes", "completed", "> 0.1 %", "> 1 %",
    "> 10 %", "largest %", "failed", "warned", "silent", "median s", "max s"))
  for _, name in ipairs(order) do
    local x = groups[name]
    table.sort(x.times)
    print(("%-24s %6d %9d %7d %6d %6d %11.3g %7d %7d %7d %8.3f %7.2f"):format(name:gsub("~", ""), x.n, x.completed,
      x.over[1], x.over[2], x.over[3], 100 * x.largest, x.failed, x.warned, x.silent, x.times[(#x.times + 1) // 2],
      x.times[#x.times]))
  end
  local all = groups["~all"]
  if all then print(("%d scenes took %.0f s"):format(all.n, all.seconds)) end
  local reasons, list = {}, {}
  for _, row in ipairs(rows) do
    if row.verdict ~= "completed" and row.verdict ~= "warned" then
      local what = row.verdict .. ": " .. kind(row.reason)
      if not reasons[what] then
        reasons[what] = { n = 0, seeds = {} }
        list[#list + 1] = what
      end
      local reason = reasons[what]
      reason.n = reason.n + 1
      if #reason.seeds < 6 then reason.seeds[#reason.seeds + 1] = ("%d"):format(row.seed) end
    end
  end
  table.sort(list, function(a, b) return reasons[a].n > reasons[b].n or reasons[a].n == reasons[b].n and a < b end)
  for _, what in ipairs(list) do
    print(("%5d  %s   seeds %s"):format(reasons[what].n, what, table.concat(reasons[what].seeds, " ")))
  end
  local tried = {}
  for _, row in ipairs(rows) do
    local taken = row.reason:match "REMEDY (.*)"
    if taken then tried[#tried + 1] = ("seed %d: %s"):format(row.seed, taken:sub(1, 240)) end
  end
  if #tried > 0 then print("remedies\n" .. table.concat(tried, "\n")) end
  table.sort(rows, function(a, b) return a.worst > b.worst or a.worst == b.worst and a.seed < b.seed end)
  print "largest errors"
  for i = 1, math.min(20, #rows) do
    local row = rows[i]
    if not (row.worst > 1e-3) then break end
    print(("%9.3g %%  seed %d  %s, %s, %s: %s"):format(100 * row.worst, row.seed, row.class, row.setting, row.verdict,
      row.scene))
  end
  return all
end

-- What is asked for ------------------------------------------------------------------------------------------------

local function scene_of(seed)
  local scene = scenes.scene(seed, options.as)
  if options.class and scene.class ~= options.class then return nil end
  if options.fast and scene.budget > 1e5 then return nil end
  if options.setting and scene.setting ~= options.setting then return nil end
  return scene
end

if options.seed then
  local scene = scenes.scene(options.seed, options.as)
  local out = run_scene(scene, changed)
  print(("seed %d, %s, %s: %s"):format(scene.seed, scene.class, scene.setting, table.concat(scene.words, "; ")))
  local every = math.max(1, #out.history // (options.rows or 40))
  local names = { "initial", "work", "gravity", "kinetic", "elastic", "plastic",
    "fracture", "contact", "ground", "connectors", "damping", "panels", "panel_contact", "numerical" }
  local head = { ("%12s %11s"):format("time", "error %") }
  for _, name in ipairs(names) do head[#head + 1] = ("%11s"):format(name) end
  print(table.concat(head, " "))
  local before, jumped = 0, nil
  for i, p in ipairs(out.history) do
    local share = p[2] / largest_of(p[3], 1e-9)
    local jump = math.abs(share - before) > 0.01
    jumped = jumped or jump and p[1]
    if i % every == 0 or i == #out.history or jump and i < 400 then
      local row = { ("%12.6g %11.4g"):format(p[1], 100 * share) }
      for k, name in ipairs(names) do
        row[k + 1] = p[4][name] and ("%11.4g"):format(p[4][name]) or ("%11s"):format ""
      end
      print(table.concat(row, " "))
    end
    before = share
  end
  for _, warning in ipairs(out.warnings or {}) do print("warning: " .. warning) end
  print(("%s after %d steps, %.2f s; largest error %.4g %% at t = %.6g s; %s"):format(out.verdict, out.steps,
    out.seconds, 100 * out.worst, out.at, out.reason))
  os.exit(out.verdict ~= "failed" and out.verdict ~= "refused")
end

local rows, done = {}, {}
if options.out then
  local file = io.open(options.out)
  for line in file and file:lines() or function() end do
    local row = read_line(line)
    if row then
      rows[#rows + 1] = row
      done[row.seed .. row.setting] = true
    end
  end
  if file then
    file:close()
  else
    file = assert(io.open(options.out, "w"))
    file:write(table.concat(columns, ","), "\n")
    file:close()
  end
end

local function keep(line)
  local row = read_line(line)
  if row then rows[#rows + 1] = row end
  if options.out then
    local file = assert(io.open(options.out, "a"))
    file:write(line, "\n")
    file:close()
  end
end

-- Every scene in a process of its own: what ends a process is one line of the table.
local running, count = {}, 0

local function start(scene, changes)
  local output = os.tmpname()
  local process = core.start(function()
    local out = run_scene(scene, changes)
    if options.remedy and out.verdict == "failed" and not out.slow then take_remedy(scene.seed, changes, out) end
    local file = assert(io.open(output, "w"))
    file:write("RESULT ", line_of(scene, out), "\n")
    file:close()
    return 0
  end, output, 3e9, false)
  running[process] = { scene = scene, output = output, began = core.clock() }
  count = count + 1
end

local function ended(process, how, code)
  local task = running[process]
  if not task then return end
  running[process], count = nil, count - 1
  local file = io.open(task.output)
  local text = file and file:read "a" or ""
  if file then file:close() end
  os.remove(task.output)
  local line = text:match "RESULT ([^\n]*)"
  if not line then
    local reason = task.late and "hangs" or ("process ended by %s %s"):format(how, code)
    line = line_of(task.scene, { verdict = "crashed", reason = reason .. " " .. one_line(text):sub(1, 200), worst = 0,
      at = 0, seconds = core.clock() - task.began, steps = 0 })
  end
  keep(line)
end

local variants
if options.compare then
  variants = {}
  for _, dt in ipairs { 2e-5, 5e-6 } do
    for _, p_delta in ipairs { "member", "chord" } do
      for _, elements in ipairs(dt == 2e-5 and { 2, 4, 8 } or { 2 }) do
        variants[#variants + 1] = { ("%2.0f us %s %d"):format(1e6 * dt, p_delta, elements),
          { dt = dt, p_delta = p_delta, elements_per_member = elements } }
      end
    end
  end
elseif options.why then
  variants = { { "own", {} }, { "chord", { p_delta = "chord" } }, { "4 elem.", { elements_per_member = 4 } },
    { "8 elem.", { elements_per_member = 8 } }, { "dt / 4", { dt_times = 0.25 } },
    { "chord dt/4", { p_delta = "chord", dt_times = 0.25 } }, { "no contact", { contact = "none" } },
    { "no fract.", { fracture = "none" } }, { "elastic", { plasticity = false } } }
end

-- What is still to run: a scene and its changes, or nil.
local next_task = coroutine.wrap(function()
  local seed, left, listed = options.first - 1, options.count, nil
  if options.seeds then
    listed = {}
    for word in tostring(options.seeds):gmatch "%d+" do listed[#listed + 1] = math.tointeger(word) end
    left = #listed
  end
  while left > 0 and seed < options.first + 1e6 do
    seed = listed and listed[#listed - left + 1] or seed + 1
    local scene = scene_of(seed)
    if listed and not scene then left = left - 1 end
    if scene then left = left - 1 end
    if scene and options.tell then
      pcall(scene.make, hinge, changed)
      print(("seed %d, %s, %s: %s"):format(scene.seed, scene.class, scene.setting, table.concat(scene.words, "; ")))
    elseif scene and variants then
      for _, variant in ipairs(variants) do
        local one = scene_of(seed)
        one.setting = variant[1]
        if not done[seed .. one.setting] then coroutine.yield(one, with(variant[2], changed)) end
      end
    elseif scene and not done[seed .. scene.setting] then
      coroutine.yield(scene, changed)
    end
  end
  while true do coroutine.yield(nil) end
end)

while true do
  while count < options.jobs do
    local scene, changes = next_task()
    if not scene then break end
    start(scene, changes)
  end
  if count == 0 then break end
  local process, how, code = core.wait(0.5)
  if process == "interrupted" then
    for left in pairs(running) do core.kill(left, false) end
    os.exit(false)
  end
  if process then ended(process, how, code) end
  for left, task in pairs(running) do
    if not task.late and core.clock() - task.began > 3 * options.seconds + 10 then
      task.late = true
      core.kill(left, false)
    end
  end
end
if options.tell then os.exit(true) end

-- A line a seed: its error in every variant, %, with "f" where the run failed.
local function table_of_causes()
  local by_seed, order = {}, {}
  for _, row in ipairs(rows) do
    if not by_seed[row.seed] then
      by_seed[row.seed] = {}
      order[#order + 1] = row.seed
    end
    local ran = row.verdict == "completed" or row.verdict == "warned"
    by_seed[row.seed][row.setting] = ("%.2g%s"):format(100 * row.worst, ran and "" or " f")
  end
  local head = { ("%8s"):format "seed" }
  for _, variant in ipairs(variants) do head[#head + 1] = ("%11s"):format(variant[1]) end
  print(table.concat(head))
  for _, seed in ipairs(order) do
    local line = { ("%8d"):format(seed) }
    for _, variant in ipairs(variants) do line[#line + 1] = ("%11s"):format(by_seed[seed][variant[1]] or "") end
    print(table.concat(line))
  end
end
if options.why then
  table_of_causes()
  os.exit(true)
end

local all = summary(rows)
if options.check then
  local broken = {}
  local function at_least(what, part, bound)
    print(("%-32s %.4f of all, bound %.4f"):format(what, part, bound))
    if not (part >= bound) then broken[#broken + 1] = what end
  end
  at_least("completed", all.completed / all.n, bounds.completed)
  at_least("energy error within 1 %", 1 - all.over[2] / all.n, bounds.within_1_percent)
  at_least("energy error within 0.1 %", 1 - all.over[1] / all.n, bounds.within_01_percent)
  at_least("not wrong in silence", 1 - all.silent / all.n, 1 - bounds.silent)
  at_least("neither refused nor crashed", 1 - all.wild / all.n, 1)
  at_least("scenes that ran", all.n, options.count)
  print(#broken == 0 and "the bounds are kept" or "not kept: " .. table.concat(broken, ", "))
  os.exit(#broken == 0)
end
