-- Hard cases: every run keeps its energy and momenta in bounds, or ends by itself with a verdict that says step, time, place and cause.
--
-- Run     cmake --build build --target hard         (or: lua5.4 tests/hard/suite.lua [quick] [words of a scene's name])
-- Shows   each scene at a quarter, a half, one, two, four and eight times its own time step; quick: only at one, without the slow ones
-- Expect  a table and "the rule holds"; what a run did that is neither in bounds nor said is listed, and the status is then 1
local folder = arg[0]:match "^(.*)[/\\]" or "."
package.path = folder .. "/?.lua;" .. package.path
local hinge = require "hinge"

local quick, wanted = arg[1] == "quick", table.concat(arg, " "):gsub("^quick ?", "")
local factors = quick and { 1 } or { 1, 0.25, 0.5, 2, 4, 8 }

local function size(v) return math.sqrt(v[1] ^ 2 + v[2] ^ 2 + v[3] ^ 2) end
local function finite(x) return x == x and math.abs(x) < math.huge end

-- Momentum's change as a part of what the fastest node would give the whole mass.
local function momentum_error(run, before)
  local now, scale = run:momentum(), 0
  local change = {}
  for c = 1, 3 do change[c] = now.linear[c] - before.linear[c] end
  scale = math.max(size(before.linear), before.mass * (run.fastest and run.fastest.speed or 0), 1e-300)
  return size(change) / scale
end

-- The largest energy that any account has: what the remainder is a part of.
local function turned_over(e)
  local most = 0
  for _, account in ipairs { "initial", "kinetic", "gravity", "elastic", "plastic", "fracture", "contact", "work" } do most = math.max(most, math.abs(e[account])) end
  return most
end

-- What came of a scene at a part of its steps: said (ended by itself, or was refused), in bounds, or a breach of the rule.
local function try(scene, factor)
  local out = { factor = factor }
  local ok, failure = pcall(function()
    local model, more = scene.make(hinge)
    local run
    if scene.static then
      run = model:static {}
    else
      local options = { dt = scene.dt * factor, duration = scene.dt * scene.steps, record = false }
      for k, v in pairs(more or {}) do options[k] = v end
      run = model:dynamic(options)
    end
    local before, most, at_energy = scene.free and run:momentum(), 0, 0
    local every = math.max(1, run.planned_steps // 200)
    run:on_step(function(r)
      if r.index % every ~= 0 and r.index < r.planned_steps then return end
      local e = r.energy
      most = math.max(most, turned_over(e))
      if most > 1e-12 then at_energy = math.max(at_energy, math.abs(e.remainder) / most) end
    end)
    run:finish()
    out.verdict, out.reason, out.steps, out.remainder = run.verdict, run.reason, run.index, at_energy
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

-- Why this outcome breaks the rule, or nil.
local function breach(scene, out)
  if out.not_finite then return "a number that is not finite in the answer" end
  local wanted_text = scene.names or scene.says
  if wanted_text then
    if out.verdict == "completed" then return "completed, but should be refused with '" .. wanted_text .. "'" end
    return not out.reason:find(wanted_text, 1, true) and ("said '%s', without '%s'"):format(out.reason, wanted_text) or nil
  end
  if out.verdict == "refused" then return "refused: " .. out.reason end
  if out.verdict == "failed" then
    return not (out.reason:find "step %d+" and out.reason:find "t = ") and "failed without a step and a time: " .. out.reason or nil
  end
  if out.factor == 1 and out.remainder > scene.remainder then return ("remainder %.2g, its bound is %.2g"):format(out.remainder, scene.remainder) end
  if out.remainder > 0.1 then return ("completed with a remainder of %.2g"):format(out.remainder) end
  local bound = scene.momentum and math.max(scene.momentum, 1e-6) * math.max(1, out.factor ^ 2) -- stubs that turn: second order
  if out.momentum and out.momentum > bound then return ("momentum off by %.2g, its bound is %.2g"):format(out.momentum, bound) end
end

local function held(scene, out) return not (scene.names or scene.says) and out.verdict == "completed" and out.remainder <= math.max(scene.remainder, 0.02) end

local scenes, breaches, count, holding = {}, {}, 0, {}
for _, file in ipairs { "structures", "breaking", "contacts" } do table.move(require(file), 1, 999, #scenes + 1, scenes) end
print(("%-58s %8s %9s %9s %8s  %-9s %s"):format("scene", "steps", "remainder", "momentum", "m/s", "verdict", "dt times 1/4 1/2 2 4 8"))
for _, scene in ipairs(scenes) do
  local name = scene[1]
  if name:find(wanted, 1, true) and not (quick and scene.slow) then
    count = count + 1
    local first, others = nil, {}
    local long = scene.static or scene.says or scene.slow and wanted == ""
    for _, factor in ipairs(long and { 1 } or factors) do
      local out = try(scene, factor)
      local why = breach(scene, out)
      if why then breaches[#breaches + 1] = ("%s, dt times %g: %s"):format(name, factor, why) end
      if held(scene, out) then holding[factor] = (holding[factor] or 0) + 1 end
      if factor == 1 then first = out
      else others[#others + 1] = why and "BREACH" or held(scene, out) and "holds" or out.verdict == "completed" and ("%.0e"):format(out.remainder) or "stops" end
    end
    local function number(x) return x and ("%9.1e"):format(x) or "" end
    print(("%-58s %8s %9s %9s %8s  %-9s %s"):format(name, first.steps or "", number(first.remainder), number(first.momentum),
      first.speed and ("%.3g"):format(first.speed) or "", first.verdict, table.concat(others, " ")))
    if first.verdict == "failed" or first.verdict == "refused" then print("    " .. first.reason:gsub("\n.*", "")) end
    io.stdout:flush()
  end
end

print(("%d scenes; completed within their bounds at their own step: %d, at 2, 4 and 8 times: %d, %d, %d; the others ended by themselves or were refused"):format(
  count, holding[1] or 0, holding[2] or 0, holding[4] or 0, holding[8] or 0))
for _, b in ipairs(breaches) do print("  breach: " .. b) end
print(#breaches == 0 and "the rule holds" or ("the rule is broken %d times"):format(#breaches))
os.exit(#breaches == 0)
