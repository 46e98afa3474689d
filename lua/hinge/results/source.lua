-- What results are read from: runs, the members that are asked for, and the states of a run that is still to be done.
local check = require "hinge.library.check"

local source = {}

--- The resultants of a section, and what their numbers are.
source.names = { "N", "Mx", "My", "Mz", "Qx", "Qy" }
source.kind = { N = "force", Qx = "force", Qy = "force", Mx = "moment", My = "moment", Mz = "moment" }

--- Options that say which members, and of which model.
source.rules = { parts = { "number", whole = true, at_least = 1, at_most = 1000, default = 8 },
  units = { "string", optional = true } }
source.free = { "model", "group", "members" }

--- Whether a value is a run.
function source.is_run(value) return check.kind_of(value) == "run" end

--- Raises an error for what is no run.
function source.must_be_run(where, run)
  if source.is_run(run) then return run end
  check.fail("%s: the run is %s; give what model:static or model:dynamic returned", where,
    run == nil and "missing" or check.show(run))
end

--- Options of which some have several kinds: those of `free` are copied as they are.
function source.options(where, options, rules, free)
  if options == nil then options = {} end
  if type(options) ~= "table" then check.fail("%s: takes a table of options, got %s", where, check.show(options)) end
  local simple, all = {}, {}
  for name, rule in pairs(rules) do all[name] = rule end
  for _, name in ipairs(free) do all[name] = { "table", optional = true } end
  for name, value in pairs(options) do simple[name] = value end
  for _, name in ipairs(free) do simple[name] = nil end
  local o = check.options(where, simple, all)
  for _, name in ipairs(free) do o[name] = options[name] end
  return o
end

-- The model of a run: that of the options, or the run's own where the run tells it.
local function model_of(where, run, o)
  if o.model ~= nil then
    check.model(where, o.model)
    return o.model
  end
  local ok, model = pcall(function() return run.model end)
  if ok and model ~= nil then return model end
  check.fail("%s: field 'model' is missing; give the model of the run, as in { model = model }", where)
end

source.model = model_of

local function members_of_group(where, run, o, group)
  if type(group) == "string" then group = model_of(where, run, o):group(group) end
  if check.kind_of(group) ~= "group" then
    check.fail("%s: field 'group' has %s; must be the name of a group, a group, or a list of these", where,
      check.show(group))
  end
  return group:members()
end

local function by_groups(where, run, o)
  local groups = type(o.group) == "table" and o.group or { o.group }
  local list, seen = {}, {}
  for _, group in ipairs(groups) do
    for _, member in ipairs(members_of_group(where, run, o, group)) do
      if not seen[member.index] then list[#list + 1], seen[member.index] = member, true end
    end
  end
  return list
end

local function by_list(where, given)
  if type(given) ~= "table" then
    check.fail("%s: field 'members' is %s; must be a list of members", where, check.show(given))
  end
  local list = {}
  for i, member in ipairs(given) do
    if check.kind_of(member) ~= "member" then
      check.fail("%s: members[%d] is %s; must be a member made by model:member{...}", where, i, check.show(member))
    end
    list[i] = member
  end
  return list
end

--- The members that are asked for: `members`, those of `group`, or all of the model.
function source.members(where, run, o)
  if o.members ~= nil and o.group ~= nil then
    check.fail("%s: fields 'members' and 'group' are both given; give one of the two", where)
  end
  local list
  if o.members ~= nil then list = by_list(where, o.members)
  elseif o.group ~= nil then list = by_groups(where, run, o)
  else list = model_of(where, run, o):members() end
  if #list == 0 then check.fail("%s: there is no member to read", where) end
  return list
end

--- Members by their index.
function source.by_index(list)
  local of = {}
  for _, member in ipairs(list) do of[member.index] = member end
  return of
end

-- States --------------------------------------------------------------------------------------------------------------

-- The load cases of a static run as text: "1.35 dead + 1.5 live".
local function loads_text(run)
  local parts = {}
  for _, name in ipairs(check.keys(run.loads)) do
    local factor = run.loads[name] * run.factor
    if factor ~= 0 then parts[#parts + 1] = ("%.4g %s"):format(factor, name) end
  end
  return #parts > 0 and table.concat(parts, " + ") or nil
end

--- What a state of a run is called: the name that was given, the time in s, or the loads of statics.
function source.state(run, name)
  if name ~= nil then return name end
  if run.kind == "dynamic" then return run.time end
  return loads_text(run) or ("factor %.4g"):format(run.factor)
end

--- A remark about a run that failed, or nil.
function source.failed(run, name)
  if run.verdict ~= "failed" then return nil end
  return ("the run %s failed: %s"):format(tostring(source.state(run, name)), run.reason)
end

--- Begins a method add(run, name) of a collector; returns what the state is called.
function source.begin(where, run, name, ...)
  check.no_more(where, ...)
  source.must_be_run(where, run)
  if name ~= nil then check.value(where, "name", name, { "string" }) end
  return source.state(run, name)
end

--- Ends it: counts the state, and notes a run that failed.
function source.ended(collector, run, name)
  collector.states = collector.states + 1
  local failed = source.failed(run, name)
  if failed then collector.notes[#collector.notes + 1] = failed end
  return collector
end

--- Whether forces are in the axes of the deformed members, and act where nodes are now.
function source.is_large(run)
  for _, effect in ipairs(run.effects) do
    if effect.name == "large displacement" then return effect.active end
  end
  return false
end

-- One run of a collector: what has ended is read now, the rest after its steps.
local function follow(where, collector, run, name, every)
  if run.verdict ~= "running" then
    if run.kind == "dynamic" then
      check.fail("%s: the dynamic run has ended, and only its last state is left; call this before its first step, or "
        .. "take :add(run) for single states", where)
    end
    return collector:add(run, name)
  end
  if run.kind == "dynamic" then collector:add(run, name) end
  run:on_step(function(now)
    if now.index % every == 0 or now.index == now.planned_steps then collector:add(now, name) end
  end)
end

--- Lets a collector, which has a method add(run, name), read all states of runs.
function source.collect(where, collector, runs, names, every)
  if names ~= nil and (type(names) ~= "table" or #names ~= #runs) then
    check.fail("%s: field 'names' must be a list of %s, one for each run", where, check.count(#runs, "name"))
  end
  for i, run in ipairs(runs) do source.must_be_run(("%s: run %d"):format(where, i), run) end
  for i, run in ipairs(runs) do follow(where, collector, run, names and names[i], every) end
  return collector
end

return source
