-- What a run records: a probe's value at a time is the state's at that time, and so is a row of history.csv.
--
-- Run: lua5.4 tests/script/record/recording_test.lua BUILD, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local scenes = require "scenes"
local hinge = require "hinge"
local checks = support.checks "recording"
local case, expect, equal, near = checks.case, checks.expect, checks.equal, checks.near
local build = arg[1]

-- Where a run begins ------------------------------------------------------------------------------------------------
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

case("recorded forces follow the closed form", function()
  -- a bar that flies freely is at v t
  local model, b, bar = scenes.cantilever { foot = false }
  model:velocity(bar, { 0, 3, 0 })
  local run = model:dynamic { dt = 1e-4, duration = 1e-2, record = false }
  local probe = run:probe { node = b, "uy" }
  run:finish()
  equal(#probe.time, 101, "values of a flight of 100 steps")
  for i, t in ipairs(probe.time) do
    checks.near(t, (i - 1) * 1e-4, 1e-12, "time of step " .. i - 1)
    checks.near(probe.value[i], 3 * t, 1e-12, "way of a bar that flies at 3 m/s")
  end
end)

case("rows of history.csv come at the interval that is asked for", function()
  -- they are what the script itself read at that time
  local hinge_on, folder = support.scenes(build)
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
