-- What probe.value and probe.time are: lists that cost nothing to ask for, and are plain lists to whoever uses them.
--
-- Run: lua5.4 tests/script/probes_test.lua BUILD_FOLDER
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "?.lua;" .. package.path
local hinge = require "hinge"
local support = require "support"
local checks = support.checks "probes"
local expect, equal = checks.expect, checks.equal

local steel = hinge.material { E = 206e9, nu = 0.3, density = 7850 }
local bar = hinge.section.solid { width = 0.04, depth = 0.06 }

-- A post of two storeys.
local function post(options)
  local model = hinge.model(options)
  local foot, floor, roof = model:node { 0, 0, 0 }, model:node { 0, 0, 3 }, model:node { 0.5, 0, 7 }
  model:fix(foot)
  model:member { foot, floor, section = bar, material = steel }
  model:member { floor, roof, section = bar, material = steel }
  model:load { node = roof, force = { 50, 30, -100 } }
  return model, foot, floor, roof
end

-- Lists ---------------------------------------------------------------------------------------------------------------
do
  local model, _, _, roof = post { displacement = "small" }
  local run = model:dynamic { dt = 1e-4, duration = 0.5 }
  local probe = run:probe { node = roof, "ux" }
  run:step()
  local early = probe.value
  run:finish()
  equal(#early, 2, "a list keeps what there was when it was asked for")
  equal(early[3], nil, "and no more")
  local n = run.index + 1
  equal(#probe.value, n, "length")
  equal(#probe.time, n, "times")
  equal(probe.time[n], run.time, "the last time")
  equal(probe.value[n], probe.last, "the last value")
  for _, key in ipairs { 0, -1, n + 1, 1.5, "1", "x" } do equal(probe.value[key], nil, "no item " .. tostring(key)) end
  equal(probe.value[2.0], probe.value[2], "a whole number in another form")
  collectgarbage()
  collectgarbage "stop"
  local before, sum = collectgarbage "count", 0
  for i = 1, 2000 do sum = sum + probe.value[i] + #probe.time end
  local kilobytes = collectgarbage "count" - before
  collectgarbage "restart"
  expect(kilobytes < 1000, "2000 reads of a list of %d took %.0f kB", n, kilobytes) -- 16 bytes an item made 300 MB
  expect(sum == sum, "the sum is a number")

  local value = probe.value
  local plain = table.move(value, 1, #value, 1, {})
  equal(rawlen(plain), n, "table.move")
  local most, counted = -math.huge, 0
  for i, v in ipairs(value) do
    most, counted = math.max(most, v), counted + 1
    if v ~= plain[i] then expect(false, "ipairs: item %d", i) end
  end
  equal(counted, n, "ipairs")
  equal(most, probe.max, "the largest")
  equal(select("#", table.unpack(value, 1, 100)), 100, "table.unpack")
  equal(table.concat(value, ",", 1, 3), table.concat(plain, ",", 1, 3), "table.concat")
  counted = 0
  for k, v in pairs(probe.value) do
    counted = counted + 1
    if v ~= plain[k] then expect(false, "pairs: item %d", k) end
  end
  equal(counted, n, "pairs")
  local sorted = probe.value
  table.sort(sorted)
  equal(sorted[1], probe.min, "sorted")
  equal(probe.value[1], plain[1], "what was sorted is the script's own list")
  local changed = probe.value
  changed[1] = 7
  equal(changed[1], 7, "changed")
  equal(changed[2], plain[2], "the rest of it stays")
  equal(#changed, n, "its length stays")
  changed = probe.value
  table.insert(changed, 8)
  equal(#changed, n + 1, "inserted")
  equal(changed[n + 1], 8, "at its end")
  equal(table.remove(changed), 8, "taken out again")
  changed = probe.value
  changed.name = "x"
  equal(changed.name, "x", "a field of its own")
  equal(#changed, n, "beside the items")
  local text = require "hinge.readable"(early)
  expect(text:find("^{ " .. ("%.14g"):format(early[1])) or text:find "^{ 0", "as text: %s", text)

  local file = support.temporary_folder() .. "/kept"
  local keep = { list = probe.value }
  local other = model:dynamic { dt = 1e-4, duration = 1e-3, checkpoint = { file = file, every = 0, keep = keep } }
  other:finish()
  keep.list = nil
  local again = model:dynamic { dt = 1e-4, duration = 1e-3, checkpoint = { file = file .. "2", keep = keep } }
  again:resume(file)
  equal(keep.list and #keep.list, n, "kept in a checkpoint")
end

-- In a program: results, plots.
do
  local hinge_on, folder = support.scenes(arg[1])
  local status, _, complaint = hinge_on("run -q", [=[
local hinge = require "hinge"
local model = hinge.model {}
local foot, roof = model:node { 0, 0, 0 }, model:node { 0, 0, 6 }
model:fix(foot)
model:member { foot, roof, section = hinge.section.solid { width = 0.04, depth = 0.06 },
  material = hinge.material { E = 2e11 } }
model:load { node = roof, force = { 50, 0, 0 } }
local run = model:static { steps = 4 }
local sway = run:probe { node = roof, "ux" }
run:finish()
hinge.plot({ series = { { name = "a", x = sway.value, y = sway.time } } }, "sway.svg")
return { sway = sway.value }
]=], "--out one")
  equal(status, 0, "the scene: " .. complaint)
  local summary = support.json(support.read(folder .. "/one/summary.json") or "{}")
  equal(summary.results and summary.results.sway and #summary.results.sway, 5, "in the results")
  expect(support.is_there(folder .. "/one/sway.svg"), "no plot")
end
checks.done()
