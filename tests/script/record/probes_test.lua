-- What a run records: a probe's value at a time is the state's at that time, and so is a row of history.csv. Probes of
-- two nodes against each other, drifts, and what probe.value and probe.time are: lists that cost nothing to ask for,
-- and are plain lists to whoever uses them.
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local hinge = require "hinge"
local scenes = require "scenes"
local support = require "support"
local checks = support.checks "probes"
local case, expect, equal, near, refused = checks.case, checks.expect, checks.equal, checks.near, checks.refused

local steel, bar = scenes.elastic, hinge.section.solid { width = 0.04, depth = 0.06 }

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

case("probes of a post of two storeys read what the run reads", function()
  for _, displacement in ipairs { "large", "small" } do
    for _, kind in ipairs { "static", "dynamic" } do
      local what = displacement .. ", " .. kind .. ": "
      local model, foot, floor, roof = post { displacement = displacement }
      if kind == "dynamic" then model:velocity(roof, { 0, 2, 0 }, { 0, 0, 3 }) end
      local run = kind == "static" and model:static { steps = 5 } or model:dynamic { dt = 1e-3, duration = 0.05 }
      local pairs_of = {}
      for _, name in ipairs { "ux", "uy", "uz", "vx", "vy", "vrz", "ax" } do
        pairs_of[name] = { run:probe { node = roof, name }, run:probe { node = floor, name },
          run:probe { node = roof, relative_to = floor, name } }
      end
      local drift_x = run:probe { node = roof, relative_to = floor, "drift_x" }
      local drift_y = run:probe { node = roof, relative_to = floor, "drift_y", height = 2, name = "own" }
      local turn = run:probe { node = roof, relative_to = floor, "rz" }
      local same = run:probe { node = roof, relative_to = foot, "rz" }
      local rz = run:probe { node = roof, "rz" }
      local below = run:probe { node = floor, "rz" }
      run:finish()
      for name, three in pairs(pairs_of) do
        equal(#three[3].value, run.index + 1, what .. name .. ": how many")
        for i, value in ipairs(three[3].value) do
          equal(value, three[1].value[i] - three[2].value[i], what .. name .. ", row " .. i)
        end
        equal(three[3].unit, three[1].unit, what .. name .. ": unit")
        equal(three[3].name, "node3_" .. name .. "_to_node2", what .. name .. ": name")
      end
      for i, value in ipairs(drift_x.value) do
        near(value, pairs_of.ux[3].value[i] / 4, 1e-16, what .. "drift over 4 m")
        near(drift_y.value[i], pairs_of.uy[3].value[i] / 2, 1e-16, what .. "drift over 2 m")
        near(same.value[i], rz.value[i], 1e-12, what .. "against a foot that does not turn")
        if displacement == "small" then
          equal(turn.value[i], rz.value[i] - below.value[i], what .. "rotation against each other")
        end
      end
      equal(drift_x.unit, "", what .. "a drift has no unit")
      equal(drift_x.name, "node3_drift_x_to_node2", what .. "its name")
      expect(math.abs(drift_x.last) > 1e-5, "%sdrift %g", what, drift_x.last)
    end
  end
end)

case("a probe of rotations follows a body that spins through many turns", function()
  -- against a node of the same body there is none, however far it has turned
  local model, b, member, a = scenes.cantilever { foot = false, member = { section = bar } }
  model:velocity(member, { 0, 0, 0 }, { 0, 0, 2 })
  local run = model:dynamic { dt = 1e-3, duration = 0.5 }
  local own, against = run:probe { node = a, "rz" }, run:probe { node = a, relative_to = b, "rz" }
  run:finish()
  near(own.last, 1, 0.01, "turned")
  near(against.last, 0, 1e-3, "against the other end")
end)

case("a probe of a reaction, a force and an energy reads what the run has", function()
  local model, foot, floor, roof = post()
  local run = model:static { steps = 2 }
  for _, row in ipairs {
    { "field 'relative_to' is missing; 'drift_x' takes a node of the floor below", { node = roof, "drift_x" } },
    { "field 'relative_to' is given beside 'fx'; a reaction", { node = foot, relative_to = roof, "fx" } },
    { "field 'relative_to' is the same node; must be another one", { node = roof, relative_to = roof, "ux" } },
    { "field 'height' is 3 m; belongs to drift_x and drift_y",
      { node = roof, relative_to = floor, "ux", height = 3 } },
    { "field 'height' is 0 m; must be above 0 m", { node = roof, relative_to = floor, "drift_y", height = 0 } },
    { "field 'relative_to'", { node = roof, relative_to = 3, "ux" } },
    { { "quantity is 'drift'; must be one of", "drift_x drift_y" }, { node = roof, relative_to = floor, "drift" } },
  } do
    expect(refused(row[1], function() run:probe(row[2]) end):find "^run:probe: ", "says which call")
  end
  local beam, q, _, p = scenes.cantilever { force = { 0, 0, -1 } }
  local level = beam:static { steps = 1 }
  refused("run:probe: both nodes are 0 m high, so 'drift_x' has no height to divide by; give height = m",
    function() level:probe { node = q, relative_to = p, "drift_x" } end)
  equal(#run.probes, 0, "what was refused is no probe")
end)

case("probes go on over a checkpoint", function()
  local function make(height)
    local model, _, floor, roof = post()
    local run = model:dynamic { dt = 1e-3, duration = 0.02 }
    return run, run:probe { node = roof, relative_to = floor, "drift_x", height = height }
  end
  local file = support.temporary_folder() .. "/a.checkpoint"
  local run, whole = make()
  for step in run:steps() do
    if step.index == 10 then run:checkpoint(file) end
  end
  local second, resumed = make()
  second:resume(file):finish()
  equal(table.concat(resumed.value, " "), table.concat(whole.value, " "), "after a resume")
  local other = make(5)
  refused("of a run with other probes", function() other:resume(file) end)
end)

-- Lists ---------------------------------------------------------------------------------------------------------------
case("lists of probes give drifts, sums and largest values", function()
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
  for i, v in ipairs(value) do most, counted = support.largest_of(most, v), counted + (v == plain[i] and 1 or 0) end
  equal(counted, n, "ipairs")
  equal(most, probe.max, "the largest")
  equal(select("#", table.unpack(value, 1, 100)), 100, "table.unpack")
  equal(table.concat(value, ",", 1, 3), table.concat(plain, ",", 1, 3), "table.concat")
  counted = 0
  for k, v in pairs(probe.value) do counted = counted + (v == plain[k] and 1 or 0) end
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
  local text = require "hinge.library.readable"(early)
  expect(text:find("^{ " .. ("%.14g"):format(early[1])) or text:find "^{ 0", "as text: %s", text)

  local file = support.temporary_folder() .. "/kept"
  local keep = { list = probe.value }
  local other = model:dynamic { dt = 1e-4, duration = 1e-3, checkpoint = { file = file, every = 0, keep = keep } }
  other:finish()
  keep.list = nil
  local again = model:dynamic { dt = 1e-4, duration = 1e-3, checkpoint = { file = file .. "2", keep = keep } }
  again:resume(file)
  equal(keep.list and #keep.list, n, "kept in a checkpoint")
end)

case("probes in a program head columns of history.csv and stand in probes.json", function()
  local hinge_on, folder = support.scenes(arg[1])
  local status, _, complaint = hinge_on("run -q", [=[
local hinge = require "hinge"
local model = hinge.model {}
local foot, floor, roof = model:node { 0, 0, 0 }, model:node { 0, 0, 3 }, model:node { 0, 0, 6 }
model:fix(foot)
local of = { section = hinge.section.solid { width = 0.04, depth = 0.06 }, material = hinge.material { E = 2e11 } }
model:member { foot, floor, section = of.section, material = of.material }
model:member { floor, roof, section = of.section, material = of.material }
model:load { node = roof, force = { 50, 0, 0 } }
local run = model:static { steps = 4 }
local drift = run:probe { node = roof, relative_to = floor, "drift_x" }
local sway = run:probe { node = roof, "ux" }
run:finish()
hinge.plot(run, { drift }, "drift.svg")
hinge.plot({ series = { { name = "a", x = sway.value, y = drift.time } } }, "sway.svg")
return { drift = drift.value }
]=], "--out one")
  equal(status, 0, "the scene: " .. complaint)
  local head = (support.read(folder .. "/one/history.csv") or ""):match "^[^\n]*"
  expect(head and head:find(",node3_drift_x_to_node2,node3_ux$"), "columns: %s", head)
  local summary = support.json(support.read(folder .. "/one/summary.json") or "{}")
  equal(summary.results and summary.results.drift and #summary.results.drift, 5, "in the results")
  local probe = (summary.probes or {})[1] or {}
  equal(probe.quantity, "drift_x", "in the summary")
  equal(probe.relative_to, 2, "in the summary: against")
  equal(probe.height, 3, "in the summary: height")
  expect(support.is_there(folder .. "/one/drift.svg") and support.is_there(folder .. "/one/sway.svg"), "no plots")
end)

-- Where a run begins --------------------------------------------------------------------------------------------------
-- The first value of a reaction: what statics has come to, or what holds under the load that is there at once.
case("the first value of a reaction is that of the state the run begins in", function()
  local function loaded()
    local model, _, _, foot = scenes.cantilever { length = 3, force = { 200, 0, -1000 },
      member = { section = hinge.section.solid { width = 0.1, depth = 0.1 } } }
    return model, foot
  end
  local function begins(run, foot, name)
    local probe = run:probe { node = foot, name }
    run:finish()
    return probe.value[1], probe.value[2], probe.last
  end
  for _, name in ipairs { "fx", "fz", "my" } do
    local model, foot = loaded()
    local static = model:static { steps = 2 }
    local first, _, at_rest = begins(static, foot, name)
    equal(first, 0.0, name .. ": statics from nothing")
    local on_first = begins(model:static { steps = 2, from = static }, foot, name)
    near(on_first, at_rest, 1e-6 * math.abs(at_rest), name .. ": statics goes on")
    for _, integrator in ipairs { "newmark", "energy-momentum", "explicit" } do
      local what = ("%s: %s, "):format(name, integrator)
      local options = { dt = 1e-7, duration = 1e-6, integrator = integrator }
      local fresh, where = loaded()
      local sudden, next_one = begins(fresh:dynamic(options), where, name)
      expect(math.abs(sudden - next_one) <= 1e-3 * math.abs(next_one) + 1e-2, "%sfrom nothing: %g, then %g", what,
        sudden, next_one)
      expect(integrator == "explicit" or name == "my" or math.abs(sudden) > 20, "%sfrom nothing: %g", what, sudden)
      options.from = static
      near(begins(model:dynamic(options), foot, name), at_rest, 1e-6 * math.abs(at_rest), what .. "after statics")
    end
  end
end)

-- Each quantity of a probe, and how a run is asked for the same.
local quantities = {}
for i, c in ipairs { "x", "y", "z", "rx", "ry", "rz" } do
  quantities[i <= 3 and "u" .. c or c] = { "displacement", i }
  quantities["v" .. c] = { "velocity", i }
  quantities["a" .. c] = { "acceleration", i }
end
for i, c in ipairs { "fx", "fy", "fz", "mx", "my", "mz" } do quantities[c] = { "reaction", i } end

case("every recorded quantity of a bent cantilever is that of its step", function()
  -- A bent cantilever under a load that changes, so that nothing stays what it was from one step to the next.
  local function cantilever(is_static)
    local model, tip, _, foot = scenes.cantilever { along = { 1, 0.1, 0.2 },
      member = { section = hinge.section.solid { width = 0.04, depth = 0.06 } } }
    model:velocity(tip, { 1, -2, 3 }, { 3, 2, 1 })
    model:load { node = tip, force = { 300, 400, -500 }, moment = { 7, 8, 9 },
      history = not is_static and function(t) return math.cos(3e3 * t) end or nil }
    return model, foot, tip
  end

  local function hold(what, run, foot, tip, abscissa)
    local probes, steps = {}, 0
    for name, way in pairs(quantities) do
      local node = way[1] == "reaction" and foot or tip
      if run.kind == "dynamic" or (way[1] ~= "velocity" and way[1] ~= "acceleration") then
        probes[name] = { run:probe { node = node, name }, node, way[1], way[2] }
      end
    end
    local last = {}
    local function agrees(at) -- the first value is that of the start
      for name, p in pairs(probes) do
        local probe, node, ask, place = table.unpack(p)
        local now = select(place, run[ask](run, node))
        local times, values = probe.time, probe.value
        local n = steps + 1
        if not (#times == n and #values == n and times[n] == at and values[n] == now) then
          return expect(false, "%s: %s after step %d has %d values, the last %.17g at %.17g; it is %.17g at %.17g",
            what, name, steps, #values, values[#values], times[#times], now, at)
        end
        last[name] = last[name] or {}
        last[name][now] = true
      end
      return true
    end
    if not agrees(0) then return end
    for step in run:steps() do
      steps = steps + 1
      if not agrees(step[abscissa]) then return end
    end
    expect(steps > 9, "%s: %d steps", what, steps)
    for name in pairs(probes) do
      local different = 0
      for _ in pairs(last[name]) do different = different + 1 end
      expect(different > steps - 2, "%s: %s has %d values in %d steps", what, name, different, steps)
    end
  end

  for what, options in pairs {
    Newmark = {}, explicit = { integrator = "explicit" }, ["step control"] = { step_control = 0.01 },
    damped = { rho_infinity = 0.6 },
  } do
    local model, foot, tip = cantilever()
    options.dt, options.duration = 2e-6, 6e-5
    hold(what, model:dynamic(options), foot, tip, "time")
  end
  local model, foot, tip = cantilever(true)
  hold("statics", model:static { steps = 12 }, foot, tip, "factor")
end)

case("rows of history.csv come at the interval that is asked for", function()
  -- they are what the script itself read at that time
  local hinge_on, folder = support.scenes(arg[1])
  local status, _, complaint = hinge_on("run", [[
local hinge = require "hinge"
local model = hinge.model {}
local a, b = model:node { 0, 0, 0 }, model:node { 1, 0, 0 }
model:member { a, b, section = hinge.section.solid { width = 0.05, depth = 0.05 },
  material = hinge.material { E = 206e9, density = 7850 } }
model:fix(a)
model:velocity(b, { 1, 2, -3 })
local run = model:dynamic { dt = 1e-5, duration = 3e-4, record = 4 }
run:probe { node = b, "uz", name = "tip" }
local file = assert(io.open("seen.csv", "w"))
run:on_step(function(r)
  file:write(("%.9g,%.9g,%.9g\n"):format(r.time, r.energy.kinetic, (select(3, r:displacement(b)))))
end)
run:finish()
file:close()
]], "--out out")
  equal(status, 0, "status of the program, " .. tostring(complaint))
  local seen, rows = {}, 0
  for line in io.lines(folder .. "/seen.csv") do
    local time, kinetic, tip_z = line:match "^([^,]*),([^,]*),([^,]*)$"
    seen[time] = { kinetic, tip_z }
  end
  for line in io.lines(folder .. "/out/history.csv") do
    local time, kinetic, tip_z = line:match "^([%d.e+-]+),[^,]*,([^,]*),.*,([^,]*)$"
    if time and tonumber(time) > 0 then
      rows = rows + 1
      local there = seen[time] or {}
      expect(there[1] == kinetic and there[2] == tip_z, "history.csv has %s J, %s m at %s s; the script saw %s J, %s m",
        kinetic, tip_z, time, there[1], there[2])
    end
  end
  equal(rows, 8, "rows of history.csv: every fourth of 30 steps, and the last")
end)

checks.done()
