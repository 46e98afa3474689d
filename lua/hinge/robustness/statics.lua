-- The static procedures of hinge.robustness: a joint is pushed down until the loads are carried, and elastic moments
-- against capacities.
local demands = require "hinge.robustness.demands"
local runs = require "hinge.robustness.runs"
local ufc = require "hinge.standards.ufc_4_023_03.factors"

local statics = {}

-- Nonlinear statics -----------------------------------------------------------------------------------------------

local tries = 12 -- iterations before a step is halved: where the load has its end, all of them are in vain
local between = { "deflection", "beam_rotation", "column_rotation", "joint_rotation", "beam_ratio", "column_ratio",
  "joint_ratio", "ratio", "unrated_rotation", "pin_rotation" }

-- The state where the load factor is `factor`, straight between two steps.
local function state_between(a, b, factor)
  local part = (factor - a.factor) / (b.factor - a.factor)
  local state = {}
  for name, value in pairs(b) do state[name] = value end
  for _, name in ipairs(between) do
    if b[name] then state[name] = (a[name] or 0) + part * (b[name] - (a[name] or 0)) end
  end
  return state
end

-- Pushes the joint down to `fall`, until the load has come to its largest value and to `needed`. Returns limit (load
-- factor), reached (whether it is a limit), state (at `needed`; nil where the limit is below), step (in which that was)
-- and the run.
local function push(study, case, model, gone, options)
  local node = model:nodes()[options.joint]
  local run = runs.static(study, model, gone, { steps = options.steps, iterations = tries,
    control = { node = node, "uz", to = -options.fall } })
  local found = { limit = 0, reached = false, run = run }
  local last = { factor = 0, deflection = 0, beam_rotation = 0, column_rotation = 0, joint_rotation = 0, ratio = 0 }
  while not found.reached and run:step() do
    local now, unstable = runs.rotations(study, case, run), run.instability
    now.factor, now.deflection = run.factor, -runs.height(node, run)
    local most = math.max(found.limit, unstable and unstable.factor or now.factor)
    if not found.state and most >= options.needed then
      found.state, found.step = now.factor > options.needed and state_between(last, now, options.needed) or now,
        run.index
    end
    found.reached = unstable ~= nil or now.factor < found.limit * (1 - 1e-6)
    found.limit, last = most, now
  end
  run:stop()
  if run.verdict == "failed" then
    found.why = run.reason
    runs.elastic(study, model, gone) -- the last run is the script's verdict, and the end of a push is no failure
  end
  return found
end

-- As push, with short steps where the load is reached within the first ones.
local function push_finely(study, case, model, gone, options)
  local found = push(study, case, model, gone, options)
  if not found.state or found.step > 3 then return found end
  local again = {}
  for name, value in pairs(options) do again[name] = value end
  again.fall = options.fall * found.step / options.steps
  local fine = push(study, case, model, gone, again)
  if fine.state then found.state = fine.state end
  return found
end

--- Statics without the members under the loads as they are: the limit load factor, and the sag of the joint (m) where
--- there is one. Its warnings are not those of the dynamic run that it is compared with.
function statics.still(study, case, base)
  local model = runs.fresh(study, case, "nonlinear dynamic", 1)
  local gone = runs.without(study, case, model)
  local found = push(study, case, model, gone, { joint = base.joint, fall = base.fall, steps = study.o.steps,
    needed = 1 })
  local sag
  if found.limit >= 1 then
    local run = runs.static(study, model, gone, { steps = 10, to_limit = true }):finish()
    if run.verdict == "completed" and not run.limit then sag = -runs.height(model:nodes()[base.joint], run) end
  end
  model:close()
  return sag, not found.why and found.limit or nil, found.reached
end

-- The dynamic factor on the loads: Omega_N, as given or by its formula.
local function increase_of(study, case, base)
  if study.o.omega_n then return study.o.omega_n end
  local model = runs.fresh(study, case, "nonlinear static", 1)
  demands.must_be_steel(study.where, model, "omega_n")
  local r = demands.smallest_ratio(model, study.geo, case, study.o.limit, base.capacity)
  model:close()
  if not r then
    return nil, "no beam next to the removal has a limit of rotation and a moment at yield, so there is no Omega_N; "
      .. "give field 'omega_n'"
  end
  return ufc.nonlinear(r), nil, r
end

local function judge_static(row, found)
  if found.why and not found.state then
    return "failed", ("at %.4g times the loads: %s"):format(row.load_factor, found.why)
  end
  if not found.state then
    return "collapses", ("the loads come to %.4g, and %.4g is needed; %s"):format(row.load_factor, row.omega,
      found.reached and "there is no equilibrium beyond" or ("the joint is down by %.4g m then"):format(row.fall))
  end
  return runs.judge_rotation(row)
end

--- Nonlinear statics of a case, into its row. Returns verdict and reason.
function statics.nonlinear(study, case, base, row)
  local omega, why, r = increase_of(study, case, base)
  if not omega then return "failed", why end
  row.omega, row.smallest_ratio = omega, r
  local model, scaled = runs.fresh(study, case, "nonlinear static", omega)
  row.loads_scaled = scaled and "next to the removal" or "all"
  local needed = scaled and 1 or omega
  local gone = runs.without(study, case, model)
  local found = push_finely(study, case, model, gone, { joint = base.joint, fall = base.fall, steps = study.o.steps,
    needed = needed })
  -- the push goes on beyond the loads that are needed, to their largest value
  runs.note(row.warnings, found.run, "at the end of the push: ")
  row.load_factor, row.limit_reached = found.limit * omega / needed, found.reached
  if found.why then table.insert(row.warnings, "the push ended before a largest load was seen: " .. found.why) end
  if found.state then runs.take(row, found.state) end
  row.factor = nil
  row.run_verdict = found.run.verdict
  local verdict, reason = judge_static(row, found)
  model:close()
  return verdict, reason
end

-- Linear statics --------------------------------------------------------------------------------------------------

-- Elastic forces of the frame whose loads next to the removal are times `factor`, as demands.demands takes them.
local function elastic_forces(model, run, times)
  local members = model:members()
  return { function(i) return members[i]:forces(run) end, times / run.factor }
end

-- What a joint's rows in run:hinges say of the loads times `times` over those of an elastic run: the DCR of its moments
-- (of all axes together, and of tension where it weakens them), the forces at which it breaks and its rotation, each
-- over its limit.
local function add_joint(of, h, times)
  of.place, of.member = h.joint, h.member.index
  if h.moment and h.strength then
    of.moment = (of.moment or 0) + times * math.abs(h.moment) / h.strength
  elseif h.force then -- now: the step that takes the members out has forces of its own
    local part = times * math.max(h.force, 0) / h.strength
    if not (part <= (of.force or 0)) then of.force = part end
    if h.interaction and h.axis == "tension" then of.moment = (of.moment or 0) + part end
  end
  if h.moment and h.ratio and not (times * h.ratio <= (of.rotation or 0)) then
    of.rotation, of.limit = times * h.ratio, h.limit
  end
  if runs.is_unrated(h, times) then of.unrated = math.max(of.unrated or 0, times * h.largest) end
end

-- The joint with the largest value of each kind, as { ratio =, member =, place =, limit = }; how many are not rated and
-- their largest rotation.
local function joint_demands(study, case, run, times)
  local joints, order, worst = {}, {}, { unrated = 0, rotation_of_unrated = 0 }
  for _, h in ipairs(run:hinges { limit = study.o.limit }) do
    if h.joint and not runs.is_removed(case, h) then
      if not joints[h.joint] then joints[h.joint], order[#order + 1] = {}, h.joint end
      add_joint(joints[h.joint], h, times)
    end
  end
  for _, name in ipairs(order) do
    local of = joints[name]
    for _, kind in ipairs { "moment", "force", "rotation" } do
      if of[kind] and not (worst[kind] and of[kind] <= worst[kind].ratio) then
        worst[kind] = { ratio = of[kind], member = of.member, place = of.place, limit = of.limit }
      end
    end
    if of.unrated then
      worst.unrated, worst.rotation_of_unrated = worst.unrated + 1, math.max(worst.rotation_of_unrated, of.unrated)
    end
  end
  return worst
end

local function larger(a, b) return not b and a or a and b.ratio <= a.ratio and a or b end

local function judge_linear(study, row, by_deformation, by_force, joints)
  if study.o.criterion == "GSA" and study.geo.storeys > ufc.most_storeys then
    return "not allowed", ("linear statics is for up to %d storeys; there are %d"):format(ufc.most_storeys,
      study.geo.storeys)
  end
  if study.o.irregular and not (row.dcr <= ufc.irregular) then
    return "not allowed", ("linear statics of an irregular structure needs a DCR of at most %d; member %s has %.4g")
      :format(ufc.irregular, row.worst, row.dcr)
  end
  if row.ratio <= 1 then
    if joints.unrated > 0 then return runs.judge_unrated(joints.unrated, joints.rotation_of_unrated) end
    return "holds", ""
  end
  if joints.rotation and row.ratio == joints.rotation.ratio then
    return "exceeds the limit of rotation", ("the %s has %.4g of its limit %.4g rad"):format(joints.rotation.place,
      joints.rotation.ratio, joints.rotation.limit)
  end
  local at = by_deformation and row.ratio == by_deformation.ratio / row.dcr_limit and by_deformation or by_force
  return "exceeds the capacity", ("%s%s has a DCR of %.4g"):format(at.place and "the " or "", runs.place(at.place,
    at.member), at.ratio)
end

-- A model without the members, its elastic run, and whether its loads are scaled next to the removal alone.
local function elastic_model(study, case, factor)
  local model, scaled = runs.fresh(study, case, "linear static", factor)
  local run, why = runs.elastic(study, model, runs.without(study, case, model))
  return model, run, scaled, why
end

-- Elastic forces for actions that are controlled by force, and the joint that comes nearest to breaking by a force.
-- Returns a model to close, if it made one.
local function forces_by_force(study, case, model, run, scaled)
  if not scaled then
    return elastic_forces(model, run, ufc.force),
      joint_demands(study, case, run, ufc.force / run.factor).force
  end
  local other, other_run, _, why = elastic_model(study, case, ufc.force)
  if not other_run then return nil, why end
  return elastic_forces(other, other_run, 1), joint_demands(study, case, other_run, 1 / other_run.factor).force, other
end

--- Linear statics of a case, into its row. Returns verdict and reason.
function statics.linear(study, case, base, row)
  local omega = study.o.omega_ld or ufc.linear(study.o.m)
  row.omega, row.dcr_limit = omega, study.o.m
  local model, run, scaled, why = elastic_model(study, case, omega)
  if not study.o.omega_ld then demands.must_be_steel(study.where, model, "omega_ld") end
  if not run then return "failed", why end
  row.loads_scaled = scaled and "next to the removal" or "all"
  local linear = elastic_forces(model, run, scaled and 1 or omega)
  local joints = joint_demands(study, case, run, linear[2])
  local force, joint_force, other = forces_by_force(study, case, model, run, scaled)
  if not force then return "failed", joint_force end
  local by_deformation, by_force = demands.demands(model, study.geo, case, linear, force)
  by_deformation, by_force = larger(by_deformation, joints.moment), larger(by_force, joint_force)
  row.deflection = -runs.height(model:nodes()[base.joint], run) * linear[2]
  model:close()
  if other then other:close() end
  if not by_deformation and not by_force then return "failed", "no member has a plastic resultant" end
  row.dcr = by_deformation and by_deformation.ratio or 0
  row.worst = by_deformation and by_deformation.member
  row.worst_joint = by_deformation and by_deformation.place
  row.force_dcr = by_force and by_force.ratio
  row.joint_dcr, row.joint_ratio = joints.moment and joints.moment.ratio, joints.rotation and joints.rotation.ratio
  row.joints_unrated = joints.unrated
  row.ratio = math.max(row.dcr / row.dcr_limit, row.force_dcr or 0, row.joint_ratio or 0)
  return judge_linear(study, row, by_deformation, by_force, joints)
end

return statics
