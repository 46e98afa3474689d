-- Hard cases: in its own step every scene keeps its energy and momenta in bounds to the end, or ends with the words
-- that it states. In other settings a run may also fail, with a reason that says step, time, place and cause.
--
-- Run     cmake --build build --target hard         (or: lua5.4 tests/hard/suite.lua [quick] [words of a scene's name])
-- Shows   each scene in its own step, and in the other settings below, slow ones in longer steps alone, long and drawn
--         ones in their own; those whose name is asked for in all, but for drawn ones; quick: in its own step alone,
--         without the slow ones
-- Expect  a table and "the rule holds"; what a run did that is neither in bounds nor said is listed, and the status is
--         then 1. So it is where fewer scenes hold in a setting than `stated` below says
--
-- A scene: its name; model, the options of its model, and build(model), which may return more options of the run, or
-- make(hinge), which returns a model and these; dt and steps of its own; energy_error and momentum, its bounds; free,
-- nothing acts on it from outside; rests, what may still move at its end, as a part of the largest energy. names or
-- says: it is refused, or fails, with these words; all others must hold in their own step. warns: words of a warning
-- that its run must give.
local folder = arg[0]:match "^(.*)[/\\]" or "."
package.path = folder .. "/?.lua;" .. folder .. "/../script/?.lua;" .. package.path
local hinge = require "hinge"
local support = require "support"
local largest_of, with = support.largest_of, require "scenes".with

local quick, wanted = arg[1] == "quick", table.concat(arg, " "):gsub("^quick ?", "")

-- `times` a scene's own step, with what options.
local own = { "1", times = 1 }
local settings = {
  { "1/4", times = 0.25 }, { "1/2", times = 0.5 }, { "2", times = 2 }, { "4", times = 4 }, { "8", times = 8 },
  { "8 control", times = 8, step_control = 0.01 }, { "64 control", times = 64, step_control = 0.01 },
  { "8 damped", times = 8, rho_infinity = 0.8 },
  -- eq 15 as printed, one solution a step
  { "as printed", times = 1, internals = { predictor = "displacement" }, iterations = 1 },
  { "auto", dt = "auto" }, { "explicit", dt = "auto", integrator = "explicit" },
}
-- In how many scenes of those tried a setting holds, at least, on each processor tried: collisions at 300 and 1000 m/s
-- in steps 8 and 64 times as long end within their bounds, or by name, as the last bits fall.
local stated = quick and { ["1"] = { 59, 66 } } or {
  ["1"] = { 69, 76 }, ["1/4"] = { 41, 41 }, ["1/2"] = { 41, 41 }, ["2"] = { 40, 43 }, ["4"] = { 41, 43 },
  ["8"] = { 40, 43 }, ["8 control"] = { 41, 43 }, ["64 control"] = { 40, 43 }, ["8 damped"] = { 41, 43 },
  ["as printed"] = { 38, 41 }, ["auto"] = { 36, 36 }, ["explicit"] = { 37, 37 },
}
local fewest_steps, most_times_the_steps = 4, 20 -- outside of these a setting is not tried

local function size(v) return math.sqrt(v[1] ^ 2 + v[2] ^ 2 + v[3] ^ 2) end
local function finite(x) return x == x and math.abs(x) < math.huge end

-- Momentum's change as a part of what the fastest node would give the whole mass.
local function momentum_error(run, before)
  local now, change = run:momentum(), {}
  for c = 1, 3 do change[c] = now.linear[c] - before.linear[c] end
  local scale = largest_of(size(before.linear), before.mass * (run.fastest and run.fastest.speed or 0), 1e-300)
  return size(change) / scale
end

-- What has come out of accounts that can only take energy in, J: it was made, although the balance closes.
local function given_back(energy)
  local sum = 0
  for _, name in ipairs { "plastic", "fracture", "contact", "ground", "damping" } do
    sum = sum - support.smallest_of(0, energy[name] or 0)
  end
  return sum
end

-- What the accounts of an energy balance leave over, J, and the largest of them, to which an error is related.
-- Every account counts that run.energy has. "contact_stored" is a part of "contact" and "connector_stored" one of
-- "connectors": parts do not count again.
local function balance(energy)
  local left, most = 0, 0
  for name, joules in pairs(energy) do
    local whole = name:match "^(.-)_"
    if name ~= "energy_error" and name ~= "remainder" and not (whole and (energy[whole] or energy[whole .. "s"])) then
      left = left + ((name == "initial" or name == "work") and joules or -joules)
      most = largest_of(most, math.abs(joules))
    end
  end
  return left, most
end

-- What came of a scene in a setting: said (failed, or was refused), in bounds, or a
-- breach of the rule. Nil: not tried.
local function try(scene, setting)
  local out = { times = setting.times }
  local ok, failure = pcall(function()
    local model = scene.build and hinge.model(scene.model or {})
    local more, run
    if model then more = scene.build(model) else model, more = scene.make(hinge) end
    if scene.static then
      run = model:static {}
    else
      local options = with({ duration = scene.dt * scene.steps, record = false,
        dt = setting.dt or scene.dt * setting.times }, more)
      for _, k in ipairs { "step_control", "rho_infinity", "internals", "iterations", "integrator" } do
        options[k] = setting[k] or options[k]
      end
      if setting.integrator then options.rho_infinity, options.tolerance = nil, nil end
      run = model:dynamic(options)
      local steps = run.planned_steps
      if setting ~= own and (steps < fewest_steps or steps > most_times_the_steps * scene.steps) then
        out = nil
        return model:close()
      end
    end
    local before, most, at_energy, uncounted = scene.free and run:momentum(), 0, 0, 0
    local every = math.max(1, run.planned_steps // 200)
    run:on_step(function(r)
      if r.index % every ~= 0 and r.index < r.planned_steps then return end
      local e = r.energy
      local left, largest = balance(e)
      most = largest_of(most, largest)
      if most <= 1e-12 then return end
      at_energy = largest_of(at_energy, (math.abs(e.energy_error) + given_back(e)) / most)
      uncounted = largest_of(uncounted, math.abs(left - e.energy_error) / most)
    end)
    local begun = os.clock()
    run:finish()
    out.seconds = os.clock() - begun
    out.verdict, out.reason, out.steps = run.verdict, run.reason, run.index
    out.warnings = table.concat(run.warnings, "\n")
    out.energy_error, out.uncounted = at_energy, uncounted
    out.moves = run.energy.kinetic / largest_of(most, 1e-300)
    out.momentum = before and momentum_error(run, before)
    out.speed = run.fastest and run.fastest.speed
    for _, quantity in ipairs { "ux", "uy", "uz", "vx", "vy", "vz" } do
      for _, x in ipairs(run:read(quantity)) do out.not_finite = out.not_finite or not finite(x) end
    end
    model:close()
  end)
  if not ok then out.verdict, out.reason = "refused", tostring(failure) end
  return out
end

-- Why this outcome breaks the rule, or nil. What is not a number is within no bound.
local function breach(scene, out, own_step)
  if out.not_finite then return "a number that is not finite in the answer" end
  local wanted_text = scene.names or scene.says
  if wanted_text then
    if out.verdict == "completed" then return "completed, but should be refused with '" .. wanted_text .. "'" end
    return not out.reason:find(wanted_text, 1, true)
      and ("said '%s', without '%s'"):format(out.reason, wanted_text) or nil
  end
  if out.verdict == "refused" then return "refused: " .. out.reason end
  if not (out.uncounted <= 1e-12) then
    return ("the accounts and the energy error are %.2g apart"):format(out.uncounted)
  end
  if out.verdict == "failed" then
    if own_step then return "failed in its own step: " .. out.reason end
    local placed = out.reason:find "step %d+" and out.reason:find "t = "
    return not placed and "failed without a step and a time: " .. out.reason or nil
  end
  if out.verdict ~= "completed" then return "its verdict is " .. out.verdict end
  if own_step and not (out.energy_error <= scene.energy_error) then
    return ("energy error %.2g, its bound is %.2g"):format(out.energy_error, scene.energy_error)
  end
  if own_step and scene.rests and not (out.moves <= scene.rests) then
    return ("%.2g of the energy still moves at the end, its bound is %.2g"):format(out.moves, scene.rests)
  end
  if own_step and scene.warns and not out.warnings:find(scene.warns, 1, true) then
    return ("no warning with '%s'"):format(scene.warns)
  end
  if not (out.energy_error <= 0.1) then return ("completed with an energy error of %.2g"):format(out.energy_error) end
  local bound = scene.momentum and largest_of(scene.momentum, 1e-6) * largest_of(1, (out.times or 1) ^ 2)
  if out.momentum and not (out.momentum <= bound) then
    return ("momentum off by %.2g, its bound is %.2g"):format(out.momentum, bound)
  end
end

local function held(scene, out)
  return not (scene.names or scene.says or out.breach) and out.verdict == "completed"
    and out.energy_error <= largest_of(scene.energy_error, 0.02)
end

local as_printed = {} -- where eq 15 as printed does not hold
local scenes, breaches, count, holding, tried = {}, {}, 0, {}, {}
for _, file in ipairs { "structures", "breaking", "contacts", "drawn" } do
  table.move(require(file), 1, 999, #scenes + 1, scenes)
end

-- The outcome in one setting; what breaks the rule goes into the list.
local function outcome_of(scene, setting)
  local out = try(scene, setting)
  if not out then return end
  out.as_printed = setting.internals ~= nil
  out.breach = breach(scene, out, setting == own)
  out.holds = held(scene, out)
  if out.breach then breaches[#breaches + 1] = ("%s, in setting %s: %s"):format(scene[1], setting[1], out.breach) end
  tried[setting] = (tried[setting] or 0) + 1
  if out.holds then holding[setting] = (holding[setting] or 0) + 1 end
  return out
end

local function mark(out)
  return not out and "" or out.breach and "BREACH" or out.holds and "+"
    or out.verdict == "completed" and ("%.0e"):format(out.energy_error) or "stops"
end

local head = { ("%-58s %8s %9s %9s %8s  %-9s"):format("scene", "steps", "error", "momentum", "m/s", "verdict") }
if not quick then
  for _, setting in ipairs(settings) do head[#head + 1] = ("%11s"):format(setting[1]) end
  head[#head + 1] = "  cheapest"
end
print(table.concat(head))
for _, scene in ipairs(scenes) do
  if scene[1]:find(wanted, 1, true) and not (quick and scene.slow) then
    count = count + 1
    local first = outcome_of(scene, own)
    local function number(x) return x and ("%9.1e"):format(x) or "" end
    local row = { ("%-58s %8s %9s %9s %8s  %-9s"):format(scene[1], first.steps or "",
      number(first.energy_error), number(first.momentum), first.speed and ("%.3g"):format(first.speed) or "",
      first.verdict) }
    if not (quick or scene.static or scene.says or scene.drawn or scene.long and wanted == "") then
      local cheapest, of = first.holds and first, own
      for _, setting in ipairs(settings) do
        local too_long = scene.slow and wanted == "" and (setting.times or 0) < 2
        local out = not too_long and outcome_of(scene, setting) or nil
        if out and out.as_printed and not out.holds then
          local why = out.reason ~= "" and out.reason or ("energy error %.2g"):format(out.energy_error)
          as_printed[#as_printed + 1] = ("%s: %s"):format(scene[1], why)
        end
        row[#row + 1] = ("%11s"):format(mark(out))
        if out and out.holds and (not cheapest or out.seconds < cheapest.seconds) then cheapest, of = out, setting end
      end
      row[#row + 1] = cheapest and ("  %s, %.2g of its own"):format(of[1], cheapest.seconds / first.seconds) or "  none"
    end
    print(table.concat(row))
    if first.verdict == "failed" or first.verdict == "refused" then print("    " .. first.reason:gsub("\n.*", "")) end
    io.stdout:flush()
  end
end

print(("%d scenes; completed within their bounds in their own step: %d"):format(count, holding[own] or 0))
if not quick then
  local shares = {}
  for i, setting in ipairs(settings) do
    shares[i] = ("%s: %d of %d"):format(setting[1], holding[setting] or 0, tried[setting] or 0)
  end
  print("in other settings " .. table.concat(shares, ", ") .. "; the others failed or were refused")
end
if #as_printed > 0 then print "eq 15 as printed, one solve a step from du = 0, does not hold in" end
for _, l in ipairs(as_printed) do print("  " .. l:gsub("%. The state.*", "")) end
if wanted == "" then
  for _, setting in ipairs { own, table.unpack(quick and {} or settings) } do
    local holds, of = holding[setting] or 0, tried[setting] or 0
    local wanted_holds, wanted_of = table.unpack(stated[setting[1]])
    if holds < wanted_holds or of ~= wanted_of then
      breaches[#breaches + 1] = ("setting %s holds in %d of %d scenes, stated are %d of %d"):format(setting[1], holds,
        of, wanted_holds, wanted_of)
    elseif holds > wanted_holds then
      print(("setting %s holds in %d scenes, more than the %d stated"):format(setting[1], holds, wanted_holds))
    end
  end
end
for _, b in ipairs(breaches) do print("  breach: " .. b) end
print(#breaches == 0 and "the rule holds" or ("the rule is broken %d times"):format(#breaches))
os.exit(#breaches == 0)
