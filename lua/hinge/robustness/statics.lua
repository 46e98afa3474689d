-- The static procedures of hinge.robustness: a joint is pushed down until the loads are carried, and elastic moments
-- against capacities.
local factors = require "hinge.robustness.factors"
local runs = require "hinge.robustness.runs"

local statics = {}

-- Nonlinear statics -----------------------------------------------------------------------------------------------

local tries = 12 -- iterations before a step is halved: where the load has its end, all of them are in vain
local between = { "deflection", "beam_rotation", "column_rotation", "beam_ratio", "column_ratio", "ratio" }

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
  local last = { factor = 0, deflection = 0, beam_rotation = 0, column_rotation = 0, ratio = 0 }
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
--- there is one.
function statics.still(study, case, base, warnings)
  local model = runs.fresh(study, case, "nonlinear dynamic", 1)
  local gone = runs.without(study, case, model)
  local found = push(study, case, model, gone, { joint = base.joint, fall = base.fall, steps = study.o.steps,
    needed = 1 })
  runs.note(warnings, found.run)
  local sag
  if found.limit >= 1 then
    local run = runs.static(study, model, gone, { steps = 10, to_limit = true }):finish()
    if run.verdict == "completed" and not run.limit then sag = -runs.height(model:nodes()[base.joint], run) end
  end
  model:close()
  return sag, not found.why and found.limit or nil, found.reached
end

-- The dynamic factor on the loads: Omega_N, as given or by its formula.
local function increase_of(study, case)
  if study.o.omega_n then return study.o.omega_n end
  local model = runs.fresh(study, case, "nonlinear static", 1)
  factors.must_be_steel(study.where, model, "omega_n")
  local r = factors.smallest_ratio(model, study.geo, case, study.o.limit)
  model:close()
  if not r then
    return nil, "no beam next to the removal has a limit of rotation and a moment at yield, so there is no Omega_N; "
      .. "give field 'omega_n'"
  end
  return factors.nonlinear(r), nil, r
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
  local omega, why, r = increase_of(study, case)
  if not omega then return "failed", why end
  row.omega, row.smallest_ratio = omega, r
  local model, scaled = runs.fresh(study, case, "nonlinear static", omega)
  row.loads_scaled = scaled and "next to the removal" or "all"
  local needed = scaled and 1 or omega
  local gone = runs.without(study, case, model)
  local found = push_finely(study, case, model, gone, { joint = base.joint, fall = base.fall, steps = study.o.steps,
    needed = needed })
  runs.note(row.warnings, found.run)
  runs.note_joints(row.warnings, model)
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

-- Elastic forces of the frame whose loads next to the removal are times `factor`, as factors.demands takes them.
local function elastic_forces(model, run, times)
  local members = model:members()
  return { function(i) return members[i]:forces(run) end, times / run.factor }
end

local function judge_linear(study, row, by_deformation, by_force)
  if study.o.criterion == "GSA" and study.geo.storeys > factors.most_storeys then
    return "not allowed", ("linear statics is for up to %d storeys; there are %d"):format(factors.most_storeys,
      study.geo.storeys)
  end
  if study.o.irregular and not (row.dcr <= factors.irregular) then
    return "not allowed", ("linear statics of an irregular structure needs a DCR of at most %d; member %s has %.4g")
      :format(factors.irregular, row.worst, row.dcr)
  end
  if row.ratio <= 1 then return "holds", "" end
  local at = by_deformation and row.ratio == by_deformation.ratio / row.dcr_limit and by_deformation or by_force
  return "exceeds the capacity", ("member %d has a DCR of %.4g"):format(at.member, at.ratio)
end

-- A model without the members, its elastic run, and whether its loads are scaled next to the removal alone.
local function elastic_model(study, case, factor)
  local model, scaled = runs.fresh(study, case, "linear static", factor)
  local run, why = runs.elastic(study, model, runs.without(study, case, model))
  return model, run, scaled, why
end

--- Linear statics of a case, into its row. Returns verdict and reason.
function statics.linear(study, case, base, row)
  local omega = study.o.omega_ld or factors.linear(study.o.m)
  row.omega, row.dcr_limit = omega, study.o.m
  local model, run, scaled, why = elastic_model(study, case, omega)
  if not study.o.omega_ld then factors.must_be_steel(study.where, model, "omega_ld") end
  if not run then return "failed", why end
  row.loads_scaled = scaled and "next to the removal" or "all"
  runs.note_joints(row.warnings, model)
  local linear = elastic_forces(model, run, scaled and 1 or omega)
  local force, other = elastic_forces(model, run, factors.force), nil
  if scaled then
    local other_run, _
    other, other_run, _, why = elastic_model(study, case, factors.force)
    if not other_run then return "failed", why end
    force = elastic_forces(other, other_run, 1)
  end
  local by_deformation, by_force = factors.demands(model, study.geo, case, linear, force)
  row.deflection = -runs.height(model:nodes()[base.joint], run) * linear[2]
  model:close()
  if other then other:close() end
  if not by_deformation and not by_force then return "failed", "no member has a plastic resultant" end
  row.dcr = by_deformation and by_deformation.ratio or 0
  row.worst = by_deformation and by_deformation.member
  row.force_dcr = by_force and by_force.ratio
  row.ratio = math.max(row.dcr / row.dcr_limit, row.force_dcr or 0)
  return judge_linear(study, row, by_deformation, by_force)
end

return statics
