-- A run whose energy balance no longer closes fails, says where, and goes back to its last good state. Step control: a
-- step that would lose too much is taken back and halved before anything is told of it, and steps grow again.
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local scenes = require "scenes"
local hinge = require "hinge"
local checks = support.checks "step_control"
local case, expect, equal, near, refused = checks.case, checks.expect, checks.equal, checks.near, checks.refused
local bar, steel = scenes.square, hinge.material { E = 206e9, density = 7850 }

-- A bar that rotates by 0.03 rad a step, by one solve a step from the displacement held: it cannot hold.
local function bar_in_flight()
  local model, b, member = scenes.cantilever { foot = false, member = { material = steel } }
  model:velocity(member, { 0, 0, 0 }, { 0, 0, 314 })
  return model, b
end
local function turning(options)
  return bar_in_flight():dynamic(scenes.with({ dt = 1e-4, duration = 0.05, iterations = 1, record = false }, options))
end
local run = turning { energy_tolerance = 0.1 }
local last = 0
run:on_step(function(r) last = r.time end)
case("a run that fails by its energy error names the state, the fastest node and a remedy", function()
  run:finish()
  equal(run.verdict, "failed", "verdict")
  expect(support.says(run.reason, "step ..., t = ... s: the energy balance no longer closes, "
    .. "its error is ... % of the largest energy (energy_tolerance 10 %); fastest was node ... with ... m/s "
    .. "at t = ... s. The state is that of step ..., t = ... s, where it was ... %; step_control = 0.01 holds: tried "
    .. "from t = ... s to ... s"), "reason: %s", run.reason)
end)

case("the remedy that is named holds", function()
  equal(turning { energy_tolerance = 0.1, step_control = 0.01 }:finish().verdict, "completed", "the remedy")
end)

case("the error that is named is that of the moment of failure", function()
  -- not that of the state to which the run went back
  local percent = tonumber(run.reason:match "its error is (%S+) %%")
  expect(percent and math.abs(run.energy_error) > 0.1 and math.abs(100 * run.energy_error / percent - 1) < 0.01,
    "energy_error %g, and the reason says %s %%", run.energy_error, percent)
  near(run.energy_error_of_state, run.energy.energy_error / run.energy.initial, 0.01, "energy_error_of_state")
  expect(math.abs(run.energy_error_of_state) <= 0.1, "energy_error_of_state %g", run.energy_error_of_state)
  expect(run.worst_energy_error >= math.abs(run.energy_error) * run.energy.initial * 0.99,
    "worst_energy_error %g", run.worst_energy_error)
  expect(run.time < last and math.abs(run.energy.energy_error) <= 0.1 * run.energy.initial,
    "it went back, from %g to %g s, where the balance closes", last, run.time)
  expect(not run:step(), "there is no further step")

  local blind = turning { energy_tolerance = 0 }:finish()
  expect(blind.verdict == "completed" or not blind.reason:find "energy balance",
    "energy_tolerance = 0 does not look: %s", blind.reason)
  expect(math.abs(blind.energy.energy_error) > 0.02 * blind.energy.initial, "and the energy balance does not close")
end)

-- A run that completes with a large error says so, whatever tolerance it was given; one that closes does not.
local function told(r)
  for _, warning in ipairs(r.warnings) do
    if warning:find("the energy error at the end of the run is", 1, true) then return warning end
  end
end
case("a run that completes with a large error warns whatever its tolerance", function()
  for _, energy_tolerance in ipairs { 0, 0.5 } do
    local off = turning { energy_tolerance = energy_tolerance, duration = 0.0024 }:finish()
    equal(off.verdict, "completed", "with energy_tolerance = " .. energy_tolerance)
    local said = tonumber((told(off) or ""):match "run is (%S+) %%")
    expect(said and math.abs(said) > 1 and math.abs(said / (100 * off.energy_error) - 1) < 0.05,
      "energy_tolerance = %g, energy error %g: the warning says %s %%", energy_tolerance, off.energy_error, said)
  end
end)

case("a run whose error was large on its way warns of when and how large", function()
  -- beta = 0.4 in long steps takes and gives energy as a mass swings on a bar. After 1.6 periods the error is small.
  local function swinging(options)
    local mass, model, b = 100, scenes.cantilever { head = "y,z,rx,ry,rz" }
    model:mass { node = b, mass = mass }
    model:velocity(b, { 1, 0, 0 })
    local period = 2 * math.pi * math.sqrt(mass / (206e9 * 0.05 ^ 2))
    local r = model:dynamic { dt = options.part * period, duration = 1.6 * period, record = false, beta = 0.4,
      energy_tolerance = options.energy_tolerance }
    local worst, at = 0, 0
    r:on_step(function(now)
      local share = now.energy.energy_error / now.energy.initial
      if math.abs(share) > math.abs(worst) then worst, at = share, now.time end
    end)
    r:finish()
    return r, worst, at
  end
  for _, energy_tolerance in ipairs { 0, 0.5 } do
    local swung, worst, at = swinging { part = 0.05, energy_tolerance = energy_tolerance }
    local name = ("swinging, energy_tolerance %g: "):format(energy_tolerance)
    expect(math.abs(worst) > 0.01 and math.abs(swung.energy_error) < 0.01, "%sworst %g, end %g", name, worst,
      swung.energy_error)
    local text = table.concat(swung.warnings, "\n")
    local when, share, final = text:match "energy error at t = (%S+) s was (%S+) %%.-%(at the end of the run (%S+) %%%)"
    near(tonumber(share) or 0 / 0, 100 * worst, 0.01 * math.abs(100 * worst), name .. "the error told, %")
    near(tonumber(when) or 0 / 0, at, 1e-3 * at, name .. "its time")
    near(tonumber(final) or 0 / 0, 100 * swung.energy_error, 0.01 * math.abs(100 * worst), name .. "at the end")
    local quiet = swinging { part = 0.02, energy_tolerance = energy_tolerance }
    equal(table.concat(quiet.warnings, "\n"):find("energy error", 1, true), nil, name .. "0.4 % is no warning")
  end
end)

case("a body that rotates far a step takes Newton's method by itself and holds", function()
  local held = bar_in_flight():dynamic { dt = 1e-4, duration = 0.05, record = false }:finish()
  expect(held.verdict == "completed" and math.abs(held.energy.energy_error) < 1e-2 * held.energy.initial,
    "Newton: %s, energy error %g", held.verdict, held.energy.energy_error)
  expect(not told(held), "it closes, and warns: %s", told(held))
end)

case("a column that folds beyond what shorter steps can mend fails by name", function()
  local function folding(elements, options)
    local model, _, member = scenes.cantilever { length = 5, along = { 0, 0, 1 }, head = "x,y,rx,ry,rz",
      force = { 0, 0, -677713 * 6 },
      member = { section = hinge.section.solid { width = 0.1, depth = 0.1 }, material = steel, elements = elements } }
    model:load { member = member, at = 0.5, force = { 1000, 0, 0 } }
    options.dt, options.record = 2e-4, false
    return model:dynamic(options):finish()
  end
  for _, options in ipairs { { duration = 0.3 }, { duration = 0.3, step_control = 0.01 } } do
    local folded = folding(4, options)
    expect(folded.verdict == "failed"
      and folded.reason:find("; more elements a member together with integrator = 'energy-momentum' may hold (not "
        .. "tried: it needs another model)", 1, true),
      "a column that folds: %s, %s", folded.verdict, folded.reason)
  end
  local holds = folding(8, { duration = 0.3, integrator = "energy-momentum" })
  equal(holds.verdict, "completed", "a column that folds: " .. holds.reason)
end)

case("an end that a moment folds back against its element names one cure", function()
  -- It is fracture where a hinge turned and no rule lets it break, else more elements.
  local function fold_back(moment, elements, yield_stress, breaks)
    local model = scenes.cantilever { model = { elements_per_member = elements, interaction = "paper" },
      moment = { 0, moment, 0 },
      member = { material = hinge.material { E = 206e9, density = 7850, yield_stress = yield_stress } } }
    if breaks then model:fracture { axial_strain = 9 } end
    return model:dynamic { dt = 2e-4, duration = 0.02, step_control = 0, energy_tolerance = 0.9, record = false }
      :finish().reason
  end
  -- Without yielding few moments end so: Newton's iteration fails first.
  local function folds_elastically()
    local why
    for moment = 2.9e6, 3.3e6, 2e4 do
      why = fold_back(moment, 2)
      if why:find("177 degrees", 1, true) then return why end
    end
    return why
  end
  for cure, why in pairs { ["a rule of fracture (model:fracture)"] = fold_back(3e5, 4, 235e6),
      ["more elements a member"] = folds_elastically(),
      [" more elements a member"] = fold_back(3e5, 4, 235e6, true) } do
    expect(why:match "177 degrees or more; (.*)$" == cure:match "%S.*" .. " may help", "%s: %s", cure, why)
  end
end)

case("an element that winds up turn after turn is no reason to fail", function()
  for _, step_control in ipairs { 0, 0.01 } do
    local model, b = scenes.cantilever { member = { material = steel } }
    model:velocity(b, { 0, 0, 0 }, { 6e4, 0, 0 })
    local twisted = model:dynamic { dt = 5e-6, duration = 0.01, step_control = step_control, record = false }:finish()
    equal(twisted.verdict, "completed", "twisted: " .. twisted.reason)
    expect(math.abs(twisted.energy.energy_error) < 1e-2 * twisted.energy.initial,
      "twisted: its energy balance closes, %g", twisted.energy.energy_error / twisted.energy.initial)
  end
end)

case("rows of history.csv never go back in time, and the last is that of the moment of failure", function()
  local hinge_on, folder = support.scenes(arg[1])
  equal(hinge_on("run", [[
local hinge = require "hinge"
local model = hinge.model {}
local a, b = model:node { 0, 0, 0 }, model:node { 1, 0, 0 }
model:member { a, b, section = hinge.section.solid { width = 0.05, depth = 0.05 },
  material = hinge.material { E = 206e9, density = 7850 }, group = "bar" }
model:velocity("bar", { 0, 0, 0 }, { 0, 0, 314 })
return model:dynamic { dt = 1e-4, duration = 0.05, iterations = 1, record = 3 }:finish().verdict
]], "--out out"), 1, "the program's status")
  local before, rows, last_row = -1, 0, nil
  for line in io.lines(folder .. "/out/history.csv") do
    local time = tonumber(line:match "^[^,]*")
    if time then
      rows = rows + 1
      expect(time >= before, "row %d goes back from %g to %g s", rows, before, time)
      before, last_row = time, line
    end
  end
  expect(rows > 3, "%d rows", rows)
  local summary = support.json(support.read(folder .. "/out/summary.json"))
  local values, initial = {}, summary.energy.initial
  for field in last_row:gmatch "[^,]+" do values[#values + 1] = tonumber(field) end
  local said, of_state = summary.energy_error, summary.energy_error_of_state
  expect(said and math.abs(said) > 0.005 and of_state and math.abs(of_state) < math.abs(said),
    "summary.json: energy_error %s, of the state %s", said, of_state)
  near(values[#values] / initial, said, 0.05 * math.abs(said), "the energy error of the last row")
end)

-- Steps that are halved -----------------------------------------------------------------------------------------------

local function share(r) return math.abs(r.energy.energy_error) / r.energy.initial end

case("a bar that rotates far a step loses no more than step control allows", function()
  local dt, held, before, seen = 1e-4, turning { step_control = 0.01 }, 0, 0
  held:on_step(function(r)
    local parts = dt / (r.time - before)
    expect(math.abs(parts - math.floor(parts + 0.5)) < 1e-6 and parts <= 1024, "a step of dt / %.9g at %g s",
      parts, r.time)
    before, seen = r.time, seen + 1
  end)
  held:finish()
  equal(held.verdict, "completed", "a bar that rotates: " .. held.reason)
  expect(share(held) <= 0.01, "energy error %g", share(held))
  expect(held.counts.rejected_steps > 0 and held.dt < dt, "%d taken back, dt %g", held.counts.rejected_steps, held.dt)
  equal(seen, held.index, "steps told to the script")
  expect(math.abs(held.time - 0.05) < 1e-15, "it ends at %.17g s", held.time)
end)

-- The part of the time that step control takes in an elastic frame whose weight comes at once: the least of three runs,
-- since other programs may take the processor at any moment.
local function share_of_control(declare)
  local least = math.huge
  for _ = 1, 3 do
    local model, at = hinge.model {}, {}
    local section = hinge.section.box { width = 0.3, depth = 0.3, thickness = 0.012 }
    for i = 0, 8 do
      for k = 0, 6 do
        at[9 * k + i] = model:node { 6 * i, 0, 3.5 * k }
        if k == 0 then model:fix(at[i]) else
          model:member { at[9 * k + i - 9], at[9 * k + i], section = section, material = steel }
          if i > 0 then model:member { at[9 * k + i - 1], at[9 * k + i], section = section, material = steel } end
        end
      end
    end
    model:gravity { 0, 0, -9.81 }
    declare(model)
    local all, control = 0, 0
    for _, stage in ipairs(model:dynamic { dt = 1e-3, duration = 0.2, record = false }:finish().stages) do
      all = all + stage.seconds
      if stage.name == "step control" then control = stage.seconds end
    end
    least = support.smallest_of(least, control / all)
  end
  return least
end
case("contact, ground and fracture that never act cost no energy balance where the motion is abrupt", function()
  for name, declare in pairs {
    contact = function(model) model:contact {} end,
    ground = function(model) model:ground { point = { 0, 0, -9 } } end,
    fracture = function(model) model:fracture { axial_strain = 1 } end,
  } do
    local part = share_of_control(declare)
    expect(part > 0 and part < 0.1, "%s: step control takes %.3f of the time", name, part) -- 0.02; 0.26 for every step
  end
end)

case("what no step can meet ends the run in the state before", function()
  local never = turning { step_control = 1e-15 }
  never:finish()
  equal(never.verdict, "failed", "step_control = 1e-15")
  expect(support.says(never.reason,
    "step ..., t = ... s: the step would lose ... % of the largest energy, its share of step_control is ... %; "
    .. "dt was halved down to 9.77e-08 s, and no shorter step is tried; step_control = 0.01 holds: tried "
    .. "from t = ... s to ... s"), "reason: %s", never.reason)
  expect(share(never) < 1e-3 and not never:step(), "the state before it, energy error %g", share(never))
end)

-- Impact by surfaces at eight times the step that it needs: what the script is told of belongs to steps that were kept.
local function crash(options)
  local model, touched, released, asked = hinge.model {}, 0, 0, {}
  local function row(group, z)
    local nodes = { model:node { 0, 0, z }, model:node { 0.5, 0, z }, model:node { 1, 0, z } }
    for i = 1, 2 do model:member { nodes[i], nodes[i + 1], section = bar, material = steel, group = group } end
    return nodes
  end
  row("struck", 0)
  local striker = row("striker", 0.06)
  model:velocity("striker", { 0, 0, -20 })
  model:contact { rule = "surface", on_contact = function() touched = touched + 1 end,
    on_release = function() released = released + 1 end }
  model:load { node = striker[2], force = { 1, 0, 0 }, history = function(t) asked[#asked + 1] = t return 1 end }
  options.duration, options.record = 4e-3, false
  local crashed = model:dynamic(options)
  local before = crashed:momentum().linear[3]
  crashed:finish()
  return crashed, touched, released, asked, math.abs(crashed:momentum().linear[3] / before - 1)
end
case("impact in steps of eight times the length keeps the energy, with the same bits on two threads", function()
  local long = crash { dt = 4e-5, energy_tolerance = 0, step_control = 0 }
  expect(share(long) > 0.02, "without control the energy balance is off by %g", share(long))
  local held, touched, released, asked, lost = crash { dt = 4e-5, step_control = 0.01 }
  equal(held.verdict, "completed", "impact: " .. held.reason)
  expect(share(held) <= 0.01 and lost < 1e-6, "impact: energy error %g, momentum %g", share(held), lost)
  expect(held.counts.rejected_steps > 0, "impact: steps taken back")
  equal(held.contacts.bound, touched, "touches told")
  equal(held.contacts.released, released, "releases told")
  local back = 0
  for i = 2, #asked do back = back + (asked[i] < asked[i - 1] and 1 or 0) end
  expect(back >= held.counts.rejected_steps,
    "loads are asked again where a step is tried again: %d times for %d", back, held.counts.rejected_steps)
end)

case("a function that fails in a step of step control is undone", function()
  local model, b = scenes.cantilever { member = { material = steel } }
  local fails = false
  model:load { node = b, force = { 0, 0, 1e3 }, history = function() return fails and error "not now" or 1 end }
  local undone = model:dynamic { dt = 1e-5, duration = 1e-3, step_control = 0.01, record = false }
  for _ = 1, 10 do undone:step() end
  local before = undone.hash
  fails = true
  refused("not now", undone.step, undone)
  equal(undone.hash, before, "the state before it")
  fails = false
  undone:finish()
  equal(undone.verdict, "completed", "and goes on")
end)

case("hinges that chatter are stepped through", function()
  -- Hinges that chatter so that Newton's method finds no end: steps that cannot be solved are halved too.
  local function mechanism(options)
    local model = hinge.model {}
    local soft = hinge.material { E = 206e9, density = 7850, yield_stress = 1e6 }
    local nodes = {}
    for level = 0, 2 do
      nodes[level] = {}
      for x = 0, 2 do nodes[level][x] = model:node { 3 * x, 0, 3 * level } end
    end
    model:fix { nodes[0][0], nodes[0][1], nodes[0][2] }
    for level = 1, 2 do
      for x = 0, 2 do
        model:member { nodes[level - 1][x], nodes[level][x], section = bar, material = soft }
        if x > 0 then model:member { nodes[level][x - 1], nodes[level][x], section = bar, material = soft } end
      end
    end
    model:gravity { 0.5, 0, -9.80665 }
    options.dt, options.duration, options.record = 2e-3, 0.2, false
    return model:dynamic(options):finish()
  end
  local kept, alone, controlled = mechanism { step_control = 0 }, mechanism {}, mechanism { step_control = 0.01 }
  equal(controlled.verdict, "completed", "hinges everywhere: " .. controlled.reason)
  -- By default, too, where there are hinges; a run whose steps must all be kept fails, and names what holds.
  equal(alone.verdict, "completed", "hinges everywhere, by default: " .. alone.reason)
  expect(alone.counts.rejected_steps > 0 and math.abs(alone.time - 0.2) < 1e-12,
    "by default %d taken back, ends at %.17g s", alone.counts.rejected_steps, alone.time)
  expect(math.abs(alone.energy_error) <= 0.002, "by default: energy error %g", alone.energy_error)
  expect(support.says(kept.reason, "step ..., t = ... s: Newton did not converge in 30 iterations (last correction "
    .. "... of the first); step_control = 0.01 holds: tried from t = ... s to ... s"), "all kept: %s", kept.reason)
end)

case("while no step is taken back the default changes no bit, no time and no step", function()
  local function same(what, make)
    local default, kept = make {}, make { step_control = 0 }
    equal(default.verdict, "completed", what .. ": " .. default.reason)
    equal(default.counts.rejected_steps, 0, what .. ": steps taken back")
    equal(default.hash, kept.hash, what .. ": bits")
    equal(default.time, kept.time, what .. ": time")
    equal(default.index, kept.index, what .. ": steps")
    equal(default.dt, kept.dt, what .. ": dt")
    local text = "halved where one would lose more than its share of 0.1 % of the energy"
    expect(default.effects[1].because:find(text, 1, true) and not kept.effects[1].because:find(text, 1, true),
      "%s: the plan says %s", what, default.effects[1].because)
  end
  same("impact", function(options)
    options.dt = 1e-6
    return (crash(options))
  end)
  same("hinges and fracture", function(options)
    local model, b = scenes.cantilever { along = { 0, 0, 1 }, member = { material = scenes.steel } }
    model:fracture { curvature_x = 0.4, curvature_y = 0.4, axial_strain = 0.3 }
    model:velocity(b, { 30, 0, 0 })
    options.dt, options.duration, options.record = 1e-5, 0.01, false
    return model:dynamic(options):finish()
  end)
end)

case("a trial of a remedy calls no function of the script", function()
  local calls, latest, model, b = 0, -1, bar_in_flight()
  model:load { node = b, force = { 0, 0, 1 }, history = function(t) calls, latest = calls + 1, t return 1 end }
  local fails = model:dynamic { dt = 1e-4, duration = 0.05, iterations = 1, record = false }
  local seen = 0
  fails:on_step(function() seen = seen + 1 end)
  fails:finish()
  equal(fails.verdict, "failed", "a bar that rotates, with a load by a function")
  expect(fails.reason:find("; step_control = 0.01 may hold (not tried: it would call functions of the script)", 1,
    true), "it says: %s", fails.reason)
  expect(calls <= seen + 6 and latest <= 1e-4 * (seen + 1.5), "%d calls up to %g s in %d steps", calls, latest, seen)
end)

case("dt = auto has step control by default, and a number has not", function()
  local text = "halved where one would lose more than its share of "
  local function said(options) return bar_in_flight():dynamic(options).effects[1].because end
  expect(said { dt = "auto", duration = 1e-3 }:find(text .. "0.1 %", 1, true), "auto: %s",
    said { dt = "auto", duration = 1e-3 })
  expect(said { dt = 1e-5, duration = 1e-3, step_control = 0.02 }:find(text .. "2 %", 1, true), "as told")
  for _, none in ipairs { { dt = "auto", duration = 1e-3, step_control = 0 }, { dt = 1e-5, duration = 1e-3 },
    { dt = "auto", duration = 1e-3, integrator = "explicit" } } do
    expect(not said(none):find(text, 1, true), "not there: %s", said(none))
  end
end)

checks.done()
