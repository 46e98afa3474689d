-- A run whose energy balance no longer closes fails, says where, and goes back to its last good state.
--
-- Run: lua5.4 tests/script/run/guard_test.lua BUILD, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local hinge = require "hinge"
local checks = support.checks "guard"
local case = checks.case

-- A bar that rotates by 0.03 rad a step, by one solve a step from the displacement held: it cannot hold.
local function turning(options)
  local model = hinge.model {}
  local a, b = model:node { 0, 0, 0 }, model:node { 1, 0, 0 }
  model:member { a, b, section = hinge.section.solid { width = 0.05, depth = 0.05 },
    material = hinge.material { E = 206e9, density = 7850 }, group = "bar" }
  model:velocity("bar", { 0, 0, 0 }, { 0, 0, 314 })
  options.dt, options.duration, options.record = 1e-4, options.duration or 0.05, false
  return model:dynamic(options)
end
case("a run whose energy error exceeds 1 % fails and says by how much", function()
  local reason = turning { iterations = 1 }:finish().reason
  checks.expect(support.says(reason, "step ..., t = ... s: the energy balance no longer closes, "
    .. "its error is ... % of the largest energy (energy_tolerance 1 %); ..."), "by itself at 1 %%: %s", reason)
end)

local run = turning { iterations = 1, energy_tolerance = 0.1 }
local last = 0
run:on_step(function(r) last = r.time end)
case("a run that fails by its energy error names the state, the fastest node and a remedy", function()
  run:finish()
  checks.equal(run.verdict, "failed", "verdict")
  checks.expect(support.says(run.reason, "step ..., t = ... s: the energy balance no longer closes, "
    .. "its error is ... % of the largest energy (energy_tolerance 10 %); fastest was node ... with ... m/s "
    .. "at t = ... s. The state is that of step ..., t = ... s, where it was ... %; step_control = 0.01 holds: tried "
    .. "from t = ... s to ... s"), "reason: %s", run.reason)
end)

case("the remedy that is named holds", function()
  -- What is named does hold.
  checks.equal(turning { iterations = 1, energy_tolerance = 0.1, step_control = 0.01 }:finish().verdict, "completed",
    "the remedy")
end)

case("the error that is named is that of the moment of failure", function()
  -- The error is that of the moment of failure, not that of the state to which the run went back.
  local percent = tonumber(run.reason:match "its error is (%S+) %%")
  checks.expect(percent and math.abs(run.energy_error) > 0.1 and math.abs(100 * run.energy_error / percent - 1) < 0.01,
    "energy_error %g, and the reason says %s %%", run.energy_error, percent)
  checks.near(run.energy_error_of_state, run.energy.energy_error / run.energy.initial, 0.01,
    "energy_error_of_state")
  checks.expect(math.abs(run.energy_error_of_state) <= 0.1, "energy_error_of_state %g", run.energy_error_of_state)
  checks.expect(run.worst_energy_error >= math.abs(run.energy_error) * run.energy.initial * 0.99,
    "worst_energy_error %g", run.worst_energy_error)
  checks.expect(run.time < last and math.abs(run.energy.energy_error) <= 0.1 * run.energy.initial,
    "it went back, from %g to %g s, where the balance closes", last, run.time)
  checks.expect(not run:step(), "there is no further step")

  local blind = turning { iterations = 1, energy_tolerance = 0 }:finish()
  checks.expect(blind.verdict == "completed" or not blind.reason:find "energy balance",
    "energy_tolerance = 0 does not look: %s",
    blind.reason)
  checks.expect(math.abs(blind.energy.energy_error) > 0.02 * blind.energy.initial,
    "and the energy balance does not close")
end)

-- A run that completes with a large error says so, whatever tolerance it was given; one that closes does not.
local function told(r)
  for _, warning in ipairs(r.warnings) do
    if warning:find("the energy error at the end of the run is", 1, true) then return warning end
  end
end
case("a run that completes with a large error warns whatever its tolerance", function()
  for _, energy_tolerance in ipairs { 0, 0.5 } do
    local off = turning { iterations = 1, energy_tolerance = energy_tolerance, duration = 0.0024 }:finish()
    checks.equal(off.verdict, "completed", "with energy_tolerance = " .. energy_tolerance)
    local said = tonumber((told(off) or ""):match "run is (%S+) %%")
    checks.expect(said and math.abs(said) > 1 and math.abs(said / (100 * off.energy_error) - 1) < 0.05,
      "energy_tolerance = %g, energy error %g: the warning says %s %%", energy_tolerance, off.energy_error, said)
  end
end)

case("a run whose error was large on its way warns of when and how large", function()
  -- A run whose error was large on its way and is small at its end says when and how large: beta = 0.4 in long steps
  -- takes and gives energy as a mass swings on a bar. After 1.6 periods the error is small.
  local function swinging(options)
    local model, mass = hinge.model {}, 100
    local a, b = model:node { 0, 0, 0 }, model:node { 1, 0, 0 }
    model:fix(a)
    model:fix(b, "y,z,rx,ry,rz")
    model:member { a, b, section = hinge.section.solid { width = 0.05, depth = 0.05 },
      material = hinge.material { E = 206e9, density = 7850 } }
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
    checks.expect(math.abs(worst) > 0.01 and math.abs(swung.energy_error) < 0.01, "%sworst %g, end %g", name, worst,
      swung.energy_error)
    local text = table.concat(swung.warnings, "\n")
    local when, share, final = text:match "energy error at t = (%S+) s was (%S+) %%.-%(at the end of the run (%S+) %%%)"
    checks.near(tonumber(share) or 0 / 0, 100 * worst, 0.01 * math.abs(100 * worst), name .. "the error told, %")
    checks.near(tonumber(when) or 0 / 0, at, 1e-3 * at, name .. "its time")
    checks.near(tonumber(final) or 0 / 0, 100 * swung.energy_error, 0.01 * math.abs(100 * worst), name .. "at the end")
    local quiet = swinging { part = 0.02, energy_tolerance = energy_tolerance }
    checks.equal(table.concat(quiet.warnings, "\n"):find("energy error", 1, true), nil, name .. "0.4 % is no warning")
  end
end)

case("a body that rotates far a step takes Newton's method by itself and holds", function()
  -- What rotates far in long steps takes Newton's method by itself, and then holds.
  local held = turning {}:finish()
  checks.expect(held.verdict == "completed" and math.abs(held.energy.energy_error) < 1e-2 * held.energy.initial,
    "Newton: %s, energy error %g", held.verdict, held.energy.energy_error)
  checks.expect(not told(held), "it closes, and warns: %s", told(held))
end)

case("a column that folds beyond what shorter steps can mend fails by name", function()
  -- A column that folds bends its elements so far that shorter steps do not hold: what does, is named, and holds.
  local function folding(elements, options)
    local model = hinge.model {}
    local a, b = model:node { 0, 0, 0 }, model:node { 0, 0, 5 }
    model:fix(a)
    model:fix(b, "x,y,rx,ry,rz")
    local member = model:member { a, b, section = hinge.section.solid { width = 0.1, depth = 0.1 },
      material = hinge.material { E = 206e9, density = 7850 }, elements = elements }
    model:load { node = b, force = { 0, 0, -677713 * 6 } }
    model:load { member = member, at = 0.5, force = { 1000, 0, 0 } }
    options.dt, options.record = 2e-4, false
    return model:dynamic(options):finish()
  end
  for _, options in ipairs { { duration = 0.3 }, { duration = 0.3, step_control = 0.01 } } do
    local folded = folding(4, options)
    checks.expect(folded.verdict == "failed"
      and folded.reason:find("; more elements a member together with integrator = 'energy-momentum' may hold (not "
        .. "tried: it needs another model)", 1, true),
      "a column that folds: %s, %s", folded.verdict, folded.reason)
  end
  local holds = folding(8, { duration = 0.3, integrator = "energy-momentum" })
  checks.equal(holds.verdict, "completed", "a column that folds: " .. holds.reason)
end)

case("an end that a moment folds back against its element names one cure", function()
  -- An end that a moment folds back against its element: one cure is named. It is fracture where a hinge turned and no
  -- rule lets it break, else more elements.
  local function fold_back(moment, elements, yield_stress, breaks)
    local model = hinge.model { elements_per_member = elements, interaction = "paper" }
    local a, b = model:node { 0, 0, 0 }, model:node { 1, 0, 0 }
    model:fix(a)
    model:member { a, b, section = hinge.section.solid { width = 0.05, depth = 0.05 },
      material = hinge.material { E = 206e9, density = 7850, yield_stress = yield_stress } }
    model:load { node = b, moment = { 0, moment, 0 } }
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
    checks.expect(why:match "177 degrees or more; (.*)$" == cure:match "%S.*" .. " may help", "%s: %s", cure, why)
  end
end)

case("an element that winds up turn after turn is no reason to fail", function()
  -- An element that winds up turn after turn: no reason for a run to end.
  for _, step_control in ipairs { 0, 0.01 } do
    local model = hinge.model {}
    local a, b = model:node { 0, 0, 0 }, model:node { 1, 0, 0 }
    model:member { a, b, section = hinge.section.solid { width = 0.05, depth = 0.05 },
      material = hinge.material { E = 206e9, density = 7850 } }
    model:fix(a)
    model:velocity(b, { 0, 0, 0 }, { 6e4, 0, 0 })
    local twisted = model:dynamic { dt = 5e-6, duration = 0.01, step_control = step_control, record = false }:finish()
    checks.equal(twisted.verdict, "completed", "twisted: " .. twisted.reason)
    checks.expect(math.abs(twisted.energy.energy_error) < 1e-2 * twisted.energy.initial,
      "twisted: its energy balance closes, %g", twisted.energy.energy_error / twisted.energy.initial)
  end
end)

case("rows of history.csv never go back in time, and the last is that of the moment of failure", function()
  -- Rows of history.csv never go back in time.
  local build = arg[1]
  local folder = os.tmpname()
  os.remove(folder)
  local script = os.tmpname()
  local file = assert(io.open(script, "w"))
  file:write [[
local hinge = require "hinge"
local model = hinge.model {}
local a, b = model:node { 0, 0, 0 }, model:node { 1, 0, 0 }
model:member { a, b, section = hinge.section.solid { width = 0.05, depth = 0.05 },
  material = hinge.material { E = 206e9, density = 7850 }, group = "bar" }
model:velocity("bar", { 0, 0, 0 }, { 0, 0, 314 })
return model:dynamic { dt = 1e-4, duration = 0.05, iterations = 1, record = 3 }:finish().verdict
]]
  file:close()
  local _, _, status = os.execute(("%s run %s --out %s > /dev/null 2>&1")
    :format(support.quote(build .. "/hinge"), support.quote(script), support.quote(folder)))
  checks.equal(status, 1, "the program's status")
  local before, rows, last_row = -1, 0, nil
  for line in io.lines(folder .. "/history.csv") do
    local time = tonumber(line:match "^[^,]*")
    if time then
      rows = rows + 1
      checks.expect(time >= before, "row %d goes back from %g to %g s", rows, before, time)
      before, last_row = time, line
    end
  end
  checks.expect(rows > 3, "%d rows", rows)
  -- The last row is that of the moment of failure, as summary.json has it.
  local text = support.read(folder .. "/summary.json")
  local summary = support.json(text)
  local values, initial = {}, summary.energy.initial
  for field in last_row:gmatch "[^,]+" do values[#values + 1] = tonumber(field) end
  local said, of_state = summary.energy_error, summary.energy_error_of_state
  checks.expect(said and math.abs(said) > 0.005 and of_state and math.abs(of_state) < math.abs(said),
    "summary.json: energy_error %s, of the state %s", said, of_state)
  checks.near(values[#values] / initial, said, 0.05 * math.abs(said), "the energy error of the last row")
  os.remove(script)
  os.execute("rm -r " .. support.quote(folder))
end)

checks.done()
