-- The load case of the paper's section 4: a small aircraft flies into the ten-storey frame. Table 1, the set-up, what
-- is measured of a run, and runs side by side in processes of their own. Described for editors in words/models.d.lua.
--
-- Reconstructed, because the paper's figure 16 is lost: the place of the impact, and all values that ten_storey.lua and
-- aircraft.lua mark as reconstructed, in two designs; the rule of contact. From the paper: table 1, the limits of
-- fracture, gap elements with a binding time of 0.5 ms, no inclination, no damping.
local hinge    = require "hinge"
local check    = require "hinge.library.check"
local core     = require "hinge.core"
local building = require "hinge.models.ten_storey"
local aircraft = require "hinge.models.aircraft"
local files    = require "hinge.study.files"
local quote    = require "hinge.library.quote"

local impact = {
  order = { "I", "II", "III", "IV" },
  cases = { I = {}, II = { speed = 320 / 3.6 }, III = { mass = 12000 }, IV = { size = 12 } }, -- table 1
}

impact.designs = {
  -- the study scripts/paper/lost_inputs.lua chose it; the paper's 0.0004 is taken as 1/cm
  light = { height = 23.8, contact = "gap", yield_stress = 295e6, building = { design = "light" },
    aircraft = { design = "stiff" },
    limits = { curvature_x = 0.04, curvature_y = 0.04, axial_strain = 0.3, strain_measure = "section" } },
  -- no column is cut; 0.0004 as 1/mm
  heavy = { height = 30, contact = "gap", yield_stress = 325e6, building = { design = "heavy" },
    aircraft = { design = "slender" }, limits = { curvature_x = 0.4, curvature_y = 0.4, axial_strain = 0.3 } },
}

local rules = {
  design = { "string", default = "light" },
  speed = { "number", unit = "m/s", above = 0, default = 440 / 3.6 }, -- table 1, Case I
  size = { "number", unit = "m", above = 0, default = 15 },
  mass = { "number", unit = "kg", above = 0, default = 15000 },
  height = { "number", unit = "m", optional = true }, -- of the fuselage's axis; of the design, if not given
  offset = { "number", unit = "m", default = 0 }, -- to the left of the building's middle
  gap = { "number", unit = "m", default = 0.5 }, -- nose before the facade
  contact = { "string", optional = true }, -- of the design
  contact_limits = { "table", default = {} }, -- further options of model:contact
  floor = { "string", default = "none", one_of = { "none", "weight", "slab" } },
  panel_contact = { "table", default = { friction = 0.5, restitution = 0.3 } }, -- where slabs are struck
  yield_stress = { "number", unit = "Pa", above = 0, optional = true }, -- of the building; of the design
  building = { "table", default = {} }, -- further options of the two models, beside the design's
  aircraft = { "table", default = {} },
  fracture = { "function", optional = true }, -- declares other limits: function(model, frame)
  unstable = { "string", optional = true }, -- "continue": the impact follows even if the building cannot stand
}

local function design_of(where, o)
  return impact.designs[o.design]
    or check.unknown(where .. ": field 'design'", "design", o.design, check.keys(impact.designs))
end

--- The scenario parameters of the load case, with those of a script added.
function impact.parameters(own)
  local result = {}
  for name, rule in pairs(rules) do
    if rule[1] == "number" or rule[1] == "string" then result[name] = rule.default end
  end
  for name, value in pairs(own or {}) do result[name] = value end
  for name, value in pairs(design_of("ten_storey_impact.parameters", result)) do
    if type(value) ~= "table" and result[name] == nil then result[name] = value end
  end
  return result
end

--- A copy of `base` with changes.
function impact.with(base, changes)
  local result = {}
  for name, value in pairs(base) do result[name] = value end
  for name, value in pairs(changes) do result[name] = value end
  return result
end

--- Adds building, aircraft, gravity, fracture and contact. Returns frame, plane (its group) and parts.
-- Other fields of `options` are ignored, so a script can pass its parameters as they are.
function impact.add(model, options)
  local own = {}
  for name in pairs(rules) do own[name] = rawget(options, name) end
  local o = check.options("ten_storey_impact.add", own, rules)
  local design = design_of("ten_storey_impact.add", o)
  for _, name in ipairs { "height", "contact", "yield_stress" } do o[name] = o[name] or design[name] end
  local steel = hinge.material { E = 206e9, nu = 0.3, density = 7850, yield_stress = o.yield_stress }
  local frame = building.add(model, impact.with(
    impact.with(design.building, { material = steel, floor = o.floor }), o.building))
  local plane, parts = aircraft.add(model, impact.with(impact.with(design.aircraft, o.aircraft), {
    size = o.size, mass = o.mass, speed = o.speed, heading = { 1, 0, 0 },
    position = { -o.gap, frame.size[2] / 2 + o.offset, o.height },
  }))
  model:gravity { 0, 0, -9.80665 }
  if o.fracture then
    o.fracture(model, frame)
  else
    model:fracture(design.limits)
  end
  local numbers = { rule = o.contact, binding_time = o.contact == "gap" and 0.5e-3 or nil }
  model:contact(impact.with(numbers, o.contact_limits))
  if o.floor == "slab" then model:panel_contact(o.panel_contact) end
  -- m/s, of an elastic wave along a column; and of a long wave, which also moves the mass of the floors
  local columns = model:group("columns")
  frame.wave = math.sqrt(steel.E / steel.density)
  frame.long_wave = frame.wave * math.sqrt(columns.mass / frame.mass)
  return frame, plane, parts
end

-- Results of a run ---------------------------------------------------------------------------------------------------

local function sum(values)
  local total = 0
  for _, v in ipairs(values) do total = total + v end
  return total
end

--- The damage of the building, J and counts. A hinge is a section that has ever been fully plastic.
function impact.damage(run, frame)
  local d = { lowest = 0 }
  for name, group in pairs { inner = "inner columns", outer = "outer columns", beams = "beams" } do
    d["broken_" .. name] = run:count { group = group, state = "broken" }
    d["hinged_" .. name] = run:count { group = group, state = "yielded" }
    d["touched_" .. name] = run:count { group = group, state = "touched" }
    d["work_" .. name] = sum(run:read("plastic_work", group))
  end
  d.broken_columns, d.hinged_columns = d.broken_inner + d.broken_outer, d.hinged_inner + d.hinged_outer
  d.broken = d.broken_columns + d.broken_beams
  d.work_columns = d.work_inner + d.work_outer
  d.worst_column = math.max(table.unpack(run:read("plastic_work", "columns")))
  d.work = d.work_columns + d.work_beams
  d.work_aircraft = sum(run:read("plastic_work", "aircraft"))
  d.broken_aircraft = run:count { group = "aircraft", state = "broken" }
  local touched = run:read("touched", "aircraft")
  d.missed = #touched - sum(touched)
  d.torn_panels = 0
  for _, panel in ipairs(frame.floor and frame.floor.slab or {}) do
    if panel:torn(run) then d.torn_panels = d.torn_panels + 1 end
  end
  for level = #frame.storey_groups, 1, -1 do
    if run:count { group = frame.storey_groups[level], state = "broken" } > 0 then d.lowest = level end
  end
  return d
end

-- Watches the columns: when the impact reaches a storey (figure 17), and which columns change from compression to
-- tension (figure 19). felt: f_y of a column has changed by 0.05. faint: by 0.005. red: a column is fully plastic, f_y
-- = 1. A column counts as pulled if its tension is more than a hundredth of the largest compression at rest.
local function watch_columns(run, frame)
  local f_at_rest, n_at_rest = run:read("f_y", "columns"), run:read("N", "columns")
  local x, y, at = run:read("x", "columns"), run:read("y", "columns"), {}
  for i, z in ipairs(run:read("z", "columns")) do
    at[i] = math.ceil((z - frame.origin[3]) / frame.size[3] * #frame.storey_groups)
  end
  local least = 0.01 * -math.min(table.unpack(n_at_rest))
  local w = { felt = {}, faint = {}, red = {}, pulled = {}, times = {}, counts = {}, below = {}, touched = nil }

  function w.look()
    if not w.touched then
      if run.contacts.bound == 0 then return end
      w.touched = run.time
    end
    local after, count, below = run.time - w.touched, 0, 0
    for i, f in ipairs(run:read("f_y", "columns")) do
      local level, change = at[i], math.abs(f - f_at_rest[i])
      if not w.faint[level] and change > 0.005 then w.faint[level] = after end
      if not w.felt[level] and change > 0.05 then w.felt[level] = after end
      if not w.red[level] and f > 1 - 1e-6 then w.red[level] = after end
    end
    for i, n in ipairs(run:read("N", "columns")) do
      if n_at_rest[i] < 0 and n > least then
        count = count + 1
        if 2 * at[i] <= #frame.storey_groups then below = below + 1 end
        local column = w.pulled[i]
          or { storey = at[i], x = x[i], y = y[i], first = after, before = n_at_rest[i], most = 0 }
        column.most, w.pulled[i] = math.max(column.most, n), column
      end
    end
    w.times[#w.times + 1], w.counts[#w.counts + 1], w.below[#w.below + 1] = after, count, below
  end
  return w
end

-- Momentum along x of the building, kg m/s, from the motion of its members since `before`.
local function momentum_of(model, run, before, since)
  local total = 0
  for group, places in pairs(before) do
    local all = model:group(group)
    local mass = all.mass / all.size
    for i, x in ipairs(run:read("x", group)) do total = total + mass * (x - places[i]) / (run.time - since) end
  end
  return total
end

--- One run of the load case: gravity at rest, then the impact. p: the load case's parameters and dt, duration, beta.
-- see(run) is called when the run has been made; it returns a function that is called after each step. Returns the
-- results. If the run failed, they are those up to its end, with the verdict "failed" and the reason.
function impact.simulate(p, see)
  local model = hinge.model { p_delta = "chord", interaction = "paper", weight = "nodes" } -- as in the paper
  local frame, plane = impact.add(model, p)
  local loaded = model:static { fixed_group = plane, unstable = p.unstable }
  loaded:finish()
  local run = loaded -- no impact if the building does not stand
  if loaded.verdict ~= "failed" then
    run = model:dynamic { from = loaded, dt = p.dt, duration = p.duration, beta = 0.4, record = 1000 }
  end
  local watch = watch_columns(run, frame)
  local each = see and see(run, frame, watch) or function() end
  local every, before, since = math.max(1, math.floor(p.watch / p.dt + 0.5)), {}, nil
  for step in run:steps() do
    if step.index % every == 0 then watch.look() end
    if not since and run.time > p.duration - 1e-3 then
      since = run.time
      for _, group in ipairs { "columns", "beams" } do before[group] = run:read("x", group) end
    end
    each(step)
  end

  local r, energy, brought = impact.damage(run, frame), run.energy, p.mass * p.speed
  r.verdict, r.reason, r.time, r.seconds, r.touched = run.verdict, run.reason, run.time, run.wall_seconds, watch.touched
  r.failure = run.failure and { cause = run.failure.cause, text = run.failure.text }
  r.speed, r.mass, r.size = p.speed, p.mass, p.size
  local i = loaded.instability -- of the building under its own weight
  r.unstable = i and { factor = i.factor, node = i.node, component = i.component, by = i.by } or nil
  for _, name in ipairs { "kinetic", "elastic", "plastic", "fracture", "contact", "panels", "panel_contact",
    "energy_error" } do
    r[name] = energy[name] -- of panels: nil without slabs
  end
  r.brought, r.own_kinetic = brought, 0.5 * p.mass * p.speed ^ 2
  r.given = since and run.time > since and momentum_of(model, run, before, since) / brought or nil
  r.times, r.counts, r.below, r.pulled = watch.times, watch.counts, watch.below, {}
  for _, name in ipairs { "felt", "faint", "red" } do
    r[name] = {}
    for level = 1, #frame.storey_groups do r[name][level] = watch[name][level] or -1 end -- -1: not within the run
  end
  for _, column in pairs(watch.pulled) do r.pulled[#r.pulled + 1] = column end
  table.sort(r.pulled, function(a, b) return a.first < b.first end)
  r.wave, r.long_wave, r.storey, r.height = frame.wave, frame.long_wave, frame.size[3] / #frame.storey_groups, p.height
  return r
end

-- Runs side by side ---------------------------------------------------------------------------------------------------

-- A value as Lua source: numbers to the last bit, strings, booleans and tables of them.
local function source(value)
  if type(value) ~= "table" then
    return type(value) == "string" and quote.lua(value) or ("%q"):format(value)
  end
  local items = {}
  for key, item in pairs(value) do items[#items + 1] = ("[%q]=%s"):format(key, source(item)) end
  return "{" .. table.concat(items, ",") .. "}"
end

--- Calls one(task, job) for each task of a list and returns what it returned, in order. Each task is a case of a study,
-- in a process of its own, as many at a time as there are cores; half = 1 in `p`: all in this process. What `one`
-- returns must be made of numbers, strings, booleans and tables. Pictures all go to the job's own folder.
function impact.side_by_side(job, p, tasks, one)
  local results = {}
  if p.half ~= 1 and #tasks > 1 and not core.planning() then
    local numbers, out = {}, (job.out == "" and "." or job.out) .. "/runs"
    for i = 1, #tasks do numbers[i] = i end
    local scenario = hinge.scenario { parameters = { task = 1 }, run = function(q, own)
      local noted = #job.notes
      local text = source(one(tasks[q.task], job))
      local notes = table.move(job.notes, noted + 1, #job.notes, 1, {})
      core.write_text(own.out .. "/result.lua", ("return %s, %s\n"):format(text, source(notes)))
    end }
    local study = hinge.study(scenario, { vary = { task = numbers }, out = out, restart = true, progress = true,
      pictures = false })
    for _, c in ipairs(study.cases) do
      local text = c.verdict ~= "interrupted" and files.text(("%s/%s/result.lua"):format(study.folder, c.folder))
      local load_result, notes = text and load(text, "result", "t", {}), nil
      if load_result then results[c.number], notes = load_result() end
      for _, note in ipairs(notes or {}) do job:note(note) end
    end
  end
  for i, task in ipairs(tasks) do
    if results[i] == nil then results[i] = one(task, job) end -- also what another process failed to do
  end
  return results
end

return impact
