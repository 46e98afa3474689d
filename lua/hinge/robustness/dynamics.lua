-- The dynamic procedure of hinge.robustness: members leave a frame at rest, and the run goes on until the joint above
-- has turned or something has fallen.
local check = require "hinge.library.check"
local runs = require "hinge.robustness.runs"
local statics = require "hinge.robustness.statics"

local every = 10 -- steps between looks at all joints
local g = 9.80665 -- m/s^2
local too_light = 1.5 -- loads over the weight of all masses, beyond which the masses do not stand for the loads
local least_steps = 50 -- in a period: with fewer the joint's way down is not followed

-- The joints that hang on something: all but those whose members are all removed.
local function joints_to_watch(geo, case)
  local list = {}
  for i, node in ipairs(geo.nodes) do
    for _, m in ipairs(node.members) do
      if not case.removed[m.index] then
        list[#list + 1] = i
        break
      end
    end
  end
  return list
end

-- A joint that has fallen by more than `fall`: its index and its fall.
local function fallen(run, start, watched, fall)
  local now = run:read "uz"
  for _, i in ipairs(watched) do
    if not (start[i] - now[i] <= fall) then return i, start[i] - now[i] end
  end
end

-- Follows the run until the joint above has been no deeper for a period (it has turned, or rests), or something has
-- fallen. Returns deepest (m), when (s, within 0.1 % of the way), and what has ended it: "turned", "fallen" (with the
-- joint), or nil.
local function follow(study, case, model, rest, run, base)
  local node, start = model:nodes()[base.joint], rest:read "uz"
  local watched = joints_to_watch(study.geo, case)
  local from, found, mark = runs.height(node, rest), { deepest = 0, at = 0 }, 0
  while run:step() do
    local down = from - runs.height(node, run)
    if not (down <= found.deepest) then found.deepest = down end
    if not (down <= mark * 1.001) then found.at, mark = run.time, down end
    local joint
    if run.index % every == 0 or not (down <= base.fall) then joint = fallen(run, start, watched, base.fall) end
    if joint then
      found.ended, found.joint = "fallen", joint
    elseif found.deepest > 0 and run.time - found.at >= study.o.follow * math.max(base.period, found.at) then
      found.ended = "turned"
    end
    if found.ended then break end
  end
  run:stop()
  return found
end

-- The energy error as a part of the largest account.
local function energy_error(run)
  local energy, largest = run.energy, 0
  for _, name in ipairs { "initial", "kinetic", "gravity", "elastic", "plastic", "work" } do
    if not (math.abs(energy[name]) <= largest) then largest = math.abs(energy[name]) end
  end
  return largest > 0 and energy.energy_error / largest or 0
end

local function judge_dynamic(row, run, found)
  if run.verdict == "failed" then return "failed", run.reason end
  if found.ended == "fallen" then
    return "collapses", ("node %d has fallen by more than %.4g m at t = %.4g s"):format(found.joint, row.fall, run.time)
  end
  if not found.ended then
    return "failed", ("the joint above has not turned, or not for long enough, by t = %.4g s, the end of the run; "
      .. "give a longer duration"):format(run.time)
  end
  if row.broken > 0 then
    return "loses members", check.count(row.broken, "further member") .. (row.broken == 1 and " breaks" or " break")
  end
  if row.joints_broken > 0 then
    return "loses joints", ("%s, the %s"):format(row.joints_broken == 1 and "1 joint breaks"
      or row.joints_broken .. " joints break, among them", row.first_broken)
  end
  return runs.judge_rotation(row)
end

-- Loads without mass have no inertia: deflections are as they are, and all goes faster than it should.
local function warn_of_light_masses(row, rest)
  local carried, mass = 0, rest:momentum().mass
  for _, fz in ipairs(rest:read "reaction_fz") do carried = carried + fz end
  if carried > too_light * mass * g then
    table.insert(row.warnings, ("the supports carry %.4g N, and all masses weigh %.4g N: loads without mass have no "
      .. "inertia, and the frame moves too fast"):format(carried, mass * g))
  end
end

-- Dynamics of a model at rest whose members go, into the row.
local function dynamic(study, case, base, row, model)
  row.dt = study.o.dt or tonumber(("%.2g"):format(base.period / 1000))
  if row.dt * least_steps > base.period then
    return "failed", ("dt = %.4g s is too long; the period of the joint is about %.4g s, and dt must be %.4g s or less")
      :format(row.dt, base.period, base.period / least_steps)
  end
  local rest = model:static { steps = 10, loads = study.o.loads, record = false }:finish()
  runs.note(row.warnings, rest)
  if rest.verdict ~= "completed" then
    row.run_verdict = rest.verdict
    return "failed", "statics before the removal: " .. (rest.reason ~= "" and rest.reason or rest.verdict)
  end
  warn_of_light_masses(row, rest)
  runs.declare_removal(case, model, study.o.over)
  if study.o.damping then
    model:damping { ratio = study.o.damping, periods = { base.period, base.period / 10 } }
  end
  local run = model:dynamic { from = rest, dt = row.dt, duration = study.o.duration or 10 * base.period,
    record = false }
  local found = follow(study, case, model, rest, run, base)
  runs.note(row.warnings, run)
  runs.take(row, runs.rotations(study, case, run))
  row.deflection, row.time, row.followed = found.deepest, found.at, run.time
  row.broken = run:count { state = "broken" } - #case.members
  row.run_verdict, row.energy_error = run.verdict, energy_error(run)
  row.at_rest = runs.height(model:nodes()[base.joint], rest)
  return judge_dynamic(row, run, found)
end

--- Nonlinear dynamics of a case, into its row. Returns verdict and reason.
return function(study, case, base, row)
  local model = runs.fresh(study, case, "nonlinear dynamic", 1)
  local verdict, reason = dynamic(study, case, base, row, model)
  model:close()
  local sag, limit, reached = statics.still(study, case, base)
  row.static_limit, row.limit_reached = limit, reached
  if sag and row.at_rest then
    row.static_deflection = sag + row.at_rest
    if verdict ~= "failed" and verdict ~= "collapses" then row.increase = row.deflection / row.static_deflection end
  end
  row.at_rest = nil
  return verdict, reason
end
