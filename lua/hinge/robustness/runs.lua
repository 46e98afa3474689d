-- What the procedures of hinge.robustness share: models that lose members, statics without these, and rotations.
local core = require "hinge.core"
local check = require "hinge.library.check"
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
  if check.kind_of(model) ~= "model" then
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

--- Adds the warnings of a run to a list, each once. before: words that stand before them.
function runs.note(warnings, run, before)
  for _, text in ipairs(run.warnings) do
    if not warnings[text] then
      warnings[text] = true
      warnings[#warnings + 1] = (before or "") .. text
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

-- A model in which nothing yields would hold whatever comes. Joints with a strength yield, and others are rated by
-- their rotation.
local function must_yield(study, gone)
  if type(study.o.criterion) == "function" or not study.nonlinear or gone:hinges()[1] then return end
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

-- The smallest rotation, rad, at which a joint of each member breaks in bending, by index of the member.
local function capacities(run)
  local list = {}
  for _, h in ipairs(run:hinges()) do
    if h.capacity and h.axis ~= "z" then
      local i = h.member.index
      list[i] = math.min(list[i] or math.huge, h.capacity)
    end
  end
  return list
end

--- The frame without the members under its loads: joint (index), sag in linear statics (m), period (s), fall (m),
--- capacity (of joints, as above); or nil and why not.
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
  local capacity = capacities(gone)
  local run, why = runs.elastic(study, model, gone)
  local joint, sag
  if run then joint, sag = joint_above(case, model, run) end
  model:close()
  if not run then return nil, why end
  if not joint or not (sag > 0) then return nil, "no joint of what is removed goes down under the loads" end
  return { joint = joint.index, sag = sag, period = 2 * math.pi * math.sqrt(sag / g), fall = fall,
    capacity = capacity }
end

-- Rotations -------------------------------------------------------------------------------------------------------

local rotations = { x = true, y = true, z = true } -- `axis` of a joint's rotations in run:hinges
local beyond = 1 + 1e-9 -- the least ratio of what has broken
local least_turn = 1e-6 -- rad: a joint that turns less rests, but for rounding

--- Whether what run:hinges lists belongs to the members that are removed. A joint between nodes stays with what is left
--- there.
function runs.is_removed(case, h) return case.removed[h.member.index] and not h.between_nodes end

--- Whether a row of a joint is held against nothing: it turns, no rotation is its limit, and it has either no strength
--- or has come to it. times: the loads over those of an elastic run, 1 unless given.
function runs.is_unrated(h, times)
  return not h.ratio and (h.yielded or not h.strength) and not ((times or 1) * h.largest <= least_turn)
end

-- Adds an axis or a force of a joint to the numbers of a row; `seen`: joints that are counted already.
local function add_joint(r, h, seen)
  if not (h.demand <= r.joint_rotation) then r.joint_rotation = h.demand end
  if h.ratio and not (h.ratio <= (r.joint_ratio or 0)) then r.joint_ratio = h.ratio end
  if h.failed and not seen.failed[h.joint] then
    seen.failed[h.joint], r.joints_broken = true, r.joints_broken + 1
    r.first_broken = r.first_broken or h.joint
  end
  if not runs.is_unrated(h) then return end
  if not seen.unrated[h.joint] then r.joints_unrated = r.joints_unrated + 1 end
  seen.unrated[h.joint], r.unrated_rotation = true, math.max(r.unrated_rotation, h.largest)
end

-- Adds a hinge, or an axis or a force of a joint.
local function add_rotation(r, h, kind)
  local rotation, ratio = kind .. "_rotation", kind .. "_ratio"
  if h.yielded then r.hinges = r.hinges + 1 end
  if not (h.demand <= r[rotation]) then r[rotation] = h.demand end
  if h.ratio and not (h.ratio <= (r[ratio] or 0)) then r[ratio] = h.ratio end
  if h.ratio and not (h.ratio <= (r.ratio or 0)) then
    r.ratio, r.worst, r.limit, r.worst_joint, r.worst_axis = h.ratio, h.member.index, h.limit, h.joint, h.axis
  end
  if not h.ratio and h.yielded then r.without_limit = r.without_limit + 1 end
end

--- The largest rotations of beams and columns, plastic ones of hinges and whole ones of joints, and how much of their
--- limit they are. Members that are neither, such as braces, count with the beams.
function runs.rotations(study, case, run)
  local list = run:hinges { limit = study.o.limit }
  local r = { beam_rotation = 0, column_rotation = 0, joint_rotation = 0, ratio = study.o.limit ~= nil and 0 or nil,
    hinges = 0, without_limit = 0, joints_broken = 0, joints_unrated = 0, unrated_rotation = 0 }
  local seen = { failed = {}, unrated = {} }
  for _, h in ipairs(list) do
    -- the step that takes the members out, from which statics goes on, has forces of its own
    if h.force and run.kind == "static" then h.ratio = math.max(h.force, 0) / h.strength end
    if h.connector and h.failed then h.ratio = math.max(h.largest_force / h.strength, beyond) end -- it has no force now
    if not runs.is_removed(case, h) then
      if h.joint then add_joint(r, h, seen) end
      add_rotation(r, h, study.geo.members[h.member.index].kind == "column" and "column" or "beam")
    end
  end
  r.pins, r.pin_rotation = core.pins_of(run)
  return r
end

--- Copies fields into a row.
function runs.take(row, values)
  for name, value in pairs(values) do row[name] = value end
end

--- What a row is called in reasons: the joint, or the member.
function runs.place(joint, member) return joint or ("member %s"):format(member) end

-- What a row that holds was not compared with.
local function not_compared(row)
  local list, hinges = {}, row.without_limit
  if hinges > 0 then
    list[1] = check.count(hinges, "plastic hinge") .. " without a limit, not compared"
  end
  if row.pins > 0 and not (row.pin_rotation <= least_turn) then
    list[#list + 1] = ("%s, which %s by up to %.3g rad now, not compared"):format(check.count(row.pins, "pin"),
      row.pins == 1 and "turns" or "turn", row.pin_rotation)
  end
  return table.concat(list, "; ")
end

--- Verdict and reason where joints have no limit: a row of theirs cannot hold.
function runs.judge_unrated(count, rotation)
  return "not rated", ("%s without a limit of rotation %s by up to %.4g rad; give them a limit in field 'limit', or a "
    .. "capacity"):format(check.count(count, "joint"), count == 1 and "turns" or "turn", rotation)
end

--- Verdict and reason by the limit of rotation, and by the forces at which joints break.
function runs.judge_rotation(row)
  if row.ratio and not (row.ratio <= 1) then
    local place = runs.place(row.worst_joint, row.worst)
    if row.worst_joint and not rotations[row.worst_axis] then
      return "exceeds the capacity", ("the %s has %.4g of the %s at which it breaks"):format(place, row.ratio,
        row.worst_axis:gsub("force_", "force along "):gsub("moment_", "moment about "))
    end
    return "exceeds the limit of rotation", ("%s%s has %.4g of its limit %.4g rad"):format(row.worst_joint and "the "
      or "", place, row.ratio, row.limit)
  end
  if row.joints_unrated > 0 then return runs.judge_unrated(row.joints_unrated, row.unrated_rotation) end
  return "holds", not_compared(row)
end

return runs
