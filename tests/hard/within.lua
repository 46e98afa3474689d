-- Whether answers that were asked within an accuracy are within it: random scenes, asked 10, 5, 2 and 1 %, against
-- references that are four times finer in everything.
--
-- Run     lua5.4 tests/hard/within.lua [name=value ...], with the module on LUA_CPATH
--         count=200 first=1    so many scenes of the population, from the first seed
--         seed=N               this scene alone, with every answer; seeds=N,N,...: these
--         asked=10,5,2,1       accuracies, %
--         most=40              s of the processor for a scene: half for the asking, the rest for the reference. A
--                              process that takes forty times as long on the clock is ended
--         jobs=1               processes at a time; each scene has a process of its own
--         kept=FOLDER          the runs of each scene are kept there, and taken from there by the next call
--         out=FILE.csv         a line for each scene and accuracy is added; seeds that it has are not run again
--         table                the summary of `out` alone
--         misses               also a line for each answer that is farther off than was asked or estimated
--         chains               chaotic scenes in the place of the population: see within_chains.lua
--         quick                the scenes that take least, asked 5 %, for the test
--         check                the status is 1 where a bound in `bounds` is not kept
--
-- Shows   by accuracy: answers that are not chaotic, and how many of those whose accuracy was reached are as near the
--         reference as was asked, and as was estimated; answers that are chaotic, and in how many the band of the mean
--         holds; the time of asking over that of the chosen run; and what has no answer or no reference.
local folder = arg[0]:match "^(.*)[/\\]" or "."
package.path = folder .. "/?.lua;" .. folder .. "/../script/?.lua;" .. package.path
local core = require "hinge.core"
local results = require "within_results"
local measured = require "within_measure"
local chains = require "within_chains"
local scenes = require "within_scenes"

local options = { count = 200, first = 1, jobs = 1, most = 40, asked = "10,5,2,1" }
for _, word in ipairs(arg) do
  local name, value = word:match "^(%w+)=(.*)$"
  options[name or word] = name and (tonumber(value) or value) or true
end

-- What `check` asks for in the quick scenes, as parts of their answers.
local bounds = { within = 0.95, bounded = 0.95, holds = 0.8 }

-- The population's seeds with the least time, as they were measured.
local quickest = { 1, 12, 23, 38, 49, 50, 53, 62, 64, 69, 75, 101, 106, 138, 139, 151, 158, 169, 176, 201 }

if options.quick then options.asked = 5 end
local asked = {}
for word in tostring(options.asked):gmatch "[%d.]+" do asked[#asked + 1] = tonumber(word) / 100 end

local scene_of = options.chains and chains.scene or scenes.scene

-- Every scene in a process of its own: what ends a process is one line of the table.
local running, count, rows = {}, 0, {}

local function start(seed)
  local output = os.tmpname()
  local place = options.kept and ("%s/%d"):format(options.kept, seed) or output .. ".runs"
  local process = core.start(function()
    local scene = scene_of(seed)
    local lines = { "RESULT\n" }
    local told = measured.scene(scene, { folder = place, script = arg[0], asked = asked, most = options.most })
    for _, row in ipairs(told) do
      row.scene = table.concat(scene.words, "; ")
      lines[#lines + 1] = results.line(row) .. "\n"
    end
    local file = assert(io.open(output, "w"))
    file:write(table.concat(lines))
    file:close()
    return 0
  end, output, 3e9, false)
  running[process] = { seed = seed, output = output, place = place, began = core.clock() }
  count = count + 1
end

local function keep(line)
  rows[#rows + 1] = results.read(line)
  if not options.out then return end
  local file = assert(io.open(options.out, "a"))
  file:write(line, "\n")
  file:close()
end

local function ended(process, how, code)
  local task = running[process]
  if not task then return end
  running[process], count = nil, count - 1
  local text = core.read_text(task.output) or "" -- io.open would make it a file that the next scenes have read
  os.remove(task.output)
  for _, name in ipairs { "/accuracy/finished.lua", "/accuracy/.lock", "/accuracy", "" } do
    if not options.kept then os.remove(task.place .. name) end
  end
  local lines = text:match "RESULT\n(.*)"
  for line in (lines or ""):gmatch "[^\n]+" do keep(line) end
  if lines then return end
  local why = task.late and "took too long on the clock" or ("process ended by %s %s"):format(how, code)
  for _, part in ipairs(asked) do
    keep(results.line { seed = task.seed, class = "", asked = part, status = "lost",
      why = why .. ": " .. text:gsub("%s+", " "):sub(-200), answers = {}, scene = "" })
  end
end

local done = {}
if options.out then
  for _, row in ipairs(results.open(options.out)) do
    rows[#rows + 1] = row
    done[row.seed] = true
  end
end

-- The seeds that are still to run, one by one, then nil.
local next_seed = coroutine.wrap(function()
  local listed = options.seed or options.seeds
  if options.quick then listed = table.concat(quickest, ",") end
  if listed then
    for word in tostring(listed):gmatch "%d+" do
      local seed = math.tointeger(word)
      if not done[seed] and scene_of(seed) then coroutine.yield(seed) end
    end
  else
    local left, seed = options.count, options.first
    while left > 0 do
      if scene_of(seed) then
        left = left - 1
        if not done[seed] then coroutine.yield(seed) end
      end
      seed = seed + 1
    end
  end
  while true do coroutine.yield(nil) end
end)

while not options.table do
  while count < options.jobs do
    local seed = next_seed()
    if not seed then break end
    start(seed)
  end
  if count == 0 then break end
  local process, how, code = core.wait(0.5)
  if process == "interrupted" then
    for left in pairs(running) do core.kill(left, false) end
    os.exit(false)
  end
  if process then ended(process, how, code) end
  for left, task in pairs(running) do
    if not task.late and core.clock() - task.began > 40 * options.most then
      task.late = true
      core.kill(left, false)
    end
  end
end

local all = results.summary(rows)
print(results.markdown(all))
if options.misses or options.seed then
  for _, line in ipairs(results.misses(rows, options.seed ~= nil)) do print(line) end
end
if options.check then
  local kept = results.keeps(all, bounds)
  print(kept and "the bounds are kept" or "the bounds are not kept")
  os.exit(kept)
end
