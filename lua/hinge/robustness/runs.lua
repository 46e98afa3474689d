-- What the procedures of hinge.robustness share: models that lose members, statics without these, and rotations.
local check = require "hinge.check"
local geometry = require "hinge.robustness.geometry"

local runs = {}

local g = 9.80665 -- m/s^2, for the estimate of the period alone
local small = 1e-4 -- the part of the loads that stands for linear statics
local instant = 1e-6 -- s: the one step in which members leave a model at rest
local fall_of_span = 0.1 -- a fall beyond this part of the span counts as a collapse

-- Models ----------------------------------------------------------------------------------------------------------

--- A new model of the study, and whether its loads have been scaled in the bays next to the removal.
function runs.fresh(study, case, procedure, factor)
  local scaled = false
  local function scale(x, y, z)
    for _, v in ipairs { x or false, y or false, z or false } do
      if type(v) ~= "number" then
        check.fail("%s: options.scale takes x, y and z of a point, in m, got %s, %s, %s", study.where, check.show(x),
          check.show(y), check.show(z))
      end
    end
    scaled = true
    return case and geometry.is_near(case, x, y, z) and factor or 1
  end
  local options = { procedure = procedure, case = case and case.number, name = case and case.name, scale = scale }
  local model = study.o.build(options)
  local ok = type(model) == "userdata" and pcall(function() return model.static and model.members end)
  if not ok then
    check.fail("%s: build returned %s; must return the model, with its loads", study.where, check.show(model))
  end
  if study.geo then geometry.must_be_same(study.where, study.geo, model) end
  return model, scaled
end

--- The members of a case go at the first step of a dynamic run. over: s, in which their forces fall to nothing.
function runs.declare_removal(case, model, over)
  local members = model:members()
  for _, index in ipairs(case.members) do model:remove { member = members[index], at = 0, over = over } end
end

--- The model at rest without its members: they leave it in one dynamic step, too short for anything to move. Statics
-- goes on from there.
function runs.without(study, case, model)
  runs.declare_removal(case, model)
  return model:dynamic { dt = instant, duration = instant, loads = study.cases and {} or nil, step_control = 0,
    energy_tolerance = 0, record = false }:finish()
end

--- Adds the warnings of a run to a list, each once.
function runs.note(warnings, run)
  for _, text in ipairs(run.warnings) do
    if not warnings[text] then
      warnings[text] = true
      warnings[#warnings + 1] = text
    end
  end
end

--- Statics from rest without the members. more: options of model:static.
function runs.static(study, model, gone, more)
  local options = { from = gone, loads = study.o.loads, record = false }
  for name, value in pairs(more) do options[name] = value end
  return model:static(options)
end

--- Displacement of a joint upwards, m.
function runs.height(node, run) return (select(3, run:displacement(node))) end

--- Linear statics: a small part of the loads. Returns the run, or nil and why not.
function runs.elastic(study, model, gone)
  local run = runs.static(study, model, gone, { steps = math.floor(1 / small + 0.5) })
  run:step()
  run:stop()
  if run.index == 0 or run.verdict == "failed" or not (run.factor > 0) then
    return nil, "linear statics without the member: " .. (run.reason ~= "" and run.reason or "no equilibrium")
  end
  return run
end

-- Loads that belong to no case would act in full while statics raises the others.
local function must_have_cases(study, model, gone)
  if not study.cases or study.has_cases then return end
  local run = runs.static(study, model, gone, { loads = {}, steps = 1 }):finish()
  for _, uz in ipairs(run:read "uz") do
    if not (math.abs(uz) < 1e-9) then
      check.fail("%s: the model has load cases, and loads or gravity that belong to none; they would act in full in "
        .. "every run; give each of them a case", study.where)
    end
  end
  study.has_cases = true
end

-- A model in which nothing yields would hold whatever comes.
local function must_yield(study, gone)
  if type(study.o.criterion) == "function" or not study.nonlinear then return end
  for _, effect in ipairs(gone.effects) do
    if effect.name == "plasticity" and not effect.active then
      check.fail("%s: nothing can yield in the model (%s); the nonlinear procedures would find that every frame holds; "
        .. "give procedures = { 'linear static' }, or materials with a yield_stress", study.where, effect.because)
    end
  end
end

-- What every procedure begins with --------------------------------------------------------------------------------

-- The joint above that goes down most in linear statics, and by how much under the loads in full.
local function joint_above(case, model, run)
  local nodes, best, most = model:nodes(), nil, 0
  for _, joint in ipairs(case.joints) do
    local down = -runs.height(nodes[joint.index], run) / run.factor
    if not (down <= most) then best, most = joint, down end
  end
  return best, most
end

--- The frame without the members under its loads: joint (index), sag in linear statics (m), period (s), fall (m); or
--- nil and why not.
function runs.prepare(study, case)
  if not case.joints[1] then return nil, "no joint of what is removed is free to go down and keeps another member" end
  local fall = study.o.fall or case.span and fall_of_span * case.span
  if not fall then return nil, "no other column stands at this level, so there is no span; give field 'fall'" end
  local model = runs.fresh(study, case, "nonlinear dynamic", 1)
  local gone = runs.without(study, case, model)
  if gone.verdict ~= "completed" then return nil, "the step that takes the member out: " .. gone.reason end
  must_yield(study, gone)
  runs.rotations(study, case, gone) -- refuses a limit that run:hinges does not take
  must_have_cases(study, model, gone)
  local run, why = runs.elastic(study, model, gone)
  local joint, sag
  if run then joint, sag = joint_above(case, model, run) end
  model:close()
  if not run then return nil, why end
  if not joint or not (sag > 0) then return nil, "no joint of what is removed goes down under the loads" end
  return { joint = joint.index, sag = sag, period = 2 * math.pi * math.sqrt(sag / g), fall = fall }
end

-- Rotations -------------------------------------------------------------------------------------------------------

--- Warns where joints of members are not part of a static procedure: statics breaks none, and no standard's factors
--- rate them.
function runs.note_joints(warnings, model)
  local count = 0
  for _, member in ipairs(model:members()) do
    if member.ends then count = count + 1 end
  end
  if count == 0 or warnings.joints then return end
  warnings.joints = true
  warnings[#warnings + 1] = ("%s joints at their ends, which this procedure neither breaks nor rates: a row may hold "
    .. "whose joints fail; procedure = 'nonlinear dynamic' breaks them"):format(check.count(count, "member") ..
    (count == 1 and " has" or " have"))
end

--- The largest plastic rotations of beams and columns, and how much of their limit they are. Members that are neither,
-- such as braces, count with the beams.
function runs.rotations(study, case, run)
  local list = run:hinges { limit = study.o.limit }
  local r = { beam_rotation = 0, column_rotation = 0, ratio = study.o.limit ~= nil and 0 or nil, hinges = 0,
    without_limit = 0 }
  for _, h in ipairs(list) do
    if not case.removed[h.member.index] then
      r.hinges = r.hinges + 1
      local name = study.geo.members[h.member.index].kind == "column" and "column" or "beam"
      local rotation, ratio = name .. "_rotation", name .. "_ratio"
      if not (h.demand <= r[rotation]) then r[rotation] = h.demand end
      if h.ratio and not (h.ratio <= (r[ratio] or 0)) then r[ratio] = h.ratio end
      if h.ratio and not (h.ratio <= r.ratio) then
        r.ratio, r.worst, r.limit = h.ratio, h.member.index, h.limit
      end
      if not h.ratio then r.without_limit = r.without_limit + 1 end
    end
  end
  return r
end

--- Copies fields into a row.
function runs.take(row, values)
  for name, value in pairs(values) do row[name] = value end
end

--- Verdict and reason by the limit of rotation.
function runs.judge_rotation(row)
  if row.ratio and not (row.ratio <= 1) then
    return "exceeds the limit of rotation", ("member %s has %.4g of its limit %.4g rad"):format(row.worst, row.ratio,
      row.limit)
  end
  local free = row.without_limit
  return "holds", free > 0 and check.count(free, "plastic hinge") .. " without a limit, not compared" or ""
end

return runs
