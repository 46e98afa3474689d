-- hinge.robustness: what a frame does when it loses a column, one column after the other, by the procedures of
-- UFC 4-023-03 and of GSA's guidelines.
local core = require "hinge.core"
local check = require "hinge.library.check"
local dynamics = require "hinge.robustness.dynamics"
local geometry = require "hinge.robustness.geometry"
local Result = require "hinge.robustness.result"
local runs = require "hinge.robustness.runs"
local statics = require "hinge.robustness.statics"
local status_line = require "hinge.library.status_line"
local ufc = require "hinge.standards.ufc_4_023_03.factors"

local where = "hinge.robustness"
local standards = { "UFC 4-023-03", "GSA" }
local procedures = { "nonlinear dynamic", "nonlinear static", "linear static" }
local does = { ["nonlinear dynamic"] = dynamics, ["nonlinear static"] = statics.nonlinear,
  ["linear static"] = statics.linear }

-- Options ---------------------------------------------------------------------------------------------------------

local function length(unit) return { "number", unit = unit, above = 0, optional = true } end

local rules = {
  build = { "function" }, storeys = { "string", one_of = { "lowest", "all" }, default = "lowest" },
  procedures = { "table", default = procedures }, duration = length "s", dt = length "s",
  over = { "number", unit = "s", at_least = 0, optional = true }, fall = length "m",
  follow = { "number", above = 0, default = 1 }, damping = { "number", at_least = 0, below = 1, optional = true },
  steps = { "number", whole = true, at_least = 10, at_most = 1000, default = 40 },
  m = { "number", at_least = 1, default = 1 }, omega_ld = { "number", at_least = 1, optional = true },
  omega_n = { "number", at_least = 1, optional = true }, irregular = { "boolean", default = false },
  folder = { "string", optional = true }, quiet = { "boolean", default = false },
  allow_failed = { "boolean", default = false },
}
-- Options of several kinds, which are checked by hand.
local free = { remove = true, criterion = true, limit = true, loads = true }

local function read_procedures(list)
  local seen = {}
  for i, name in ipairs(list) do
    check.value(where, ("procedures[%d]"):format(i), name, { "string", one_of = procedures })
    if seen[name] then check.fail("%s: field 'procedures' names '%s' twice", where, name) end
    seen[name] = true
  end
  if #list == 0 then
    check.fail("%s: field 'procedures' is %s; must be a list of one or more of '%s'", where, check.show(list),
      table.concat(procedures, "', '"))
  end
  return seen
end

-- The limit as run:hinges takes it; its levels and groups are checked there.
local function check_limit(o, asked)
  local limit = o.limit
  if type(limit) == "number" then
    check.value(where, "limit", limit, { "number", unit = "rad", above = 0 })
  elseif limit ~= nil and type(limit) ~= "table" and type(limit) ~= "function" then
    check.fail("%s: field 'limit' is %s; must be a number in rad, or what run:hinges takes as limit", where,
      check.show(limit))
  end
  if limit ~= nil then return end
  if type(o.criterion) ~= "function" and (asked["nonlinear dynamic"] or asked["nonlinear static"]) then
    check.fail("%s: field 'limit' is missing; give the plastic rotation that is allowed, in rad, or what run:hinges "
      .. "takes as limit", where)
  end
  if asked["nonlinear static"] and not o.omega_n then
    check.fail("%s: field 'limit' is missing; Omega_N of nonlinear statics follows from it; give it, or field "
      .. "'omega_n'", where)
  end
end

local function check_criterion(criterion)
  if type(criterion) == "function" then return end
  check.value(where, "criterion", criterion, { "string", one_of = standards })
end

local function check_loads(loads)
  local kind = type(loads)
  if loads ~= nil and kind ~= "table" and kind ~= "string" and kind ~= "userdata" then
    check.fail("%s: field 'loads' is %s; must be what model:static takes as loads, such as { dead = 1.2, live = 0.5 }",
      where, check.show(loads))
  end
end

local function read_options(options)
  if type(options) ~= "table" then
    check.fail("%s: takes a table of options, got %s", where, check.show(options))
  end
  local plain, all = {}, {}
  for name, rule in pairs(rules) do all[name] = rule end
  for name in pairs(free) do all[name] = { "table", optional = true } end
  for name, value in pairs(options) do
    if not free[name] then plain[name] = value end
  end
  local o = check.options(where, plain, all)
  for name in pairs(free) do o[name] = options[name] end
  if o.criterion == nil then o.criterion = "UFC 4-023-03" end
  if o.remove == nil then o.remove = "columns" end
  check_criterion(o.criterion)
  check_limit(o, read_procedures(o.procedures))
  check_loads(o.loads)
  if o.folder and not o.folder:find "^[%w._ -]+$" then
    check.fail("%s: folder is '%s'; must be a plain name (it is made in the output folder)", where, o.folder)
  end
  return o
end

-- The study -------------------------------------------------------------------------------------------------------

-- Reads the structure from a first model, and what is to be removed.
local function open(o)
  local study = { o = o, where = where, nonlinear = false }
  for _, name in ipairs(o.procedures) do study.nonlinear = study.nonlinear or name ~= "linear static" end
  local model = runs.fresh(study, nil, "geometry", 1)
  study.cases = #model:cases() > 0
  if study.cases and o.loads == nil then
    check.fail("%s: field 'loads' is missing; the model has load cases; give the factors of those that act, such as "
      .. "{ dead = 1.2, live = 0.5 }", where)
  elseif not study.cases and o.loads ~= nil then
    check.fail("%s: field 'loads' is given, and the model that build returned has no load case", where)
  end
  study.geo = geometry.read(model)
  study.list = geometry.cases(where, study.geo, o.remove, o.storeys)
  for number, case in ipairs(study.list) do case.number = number end
  model:close()
  return study
end

local function new_row(case, base, procedure)
  local row = { case = case.number, name = case.name, group = case.group, members = case.members, x = case.x,
    y = case.y, z_low = case.z_low, z_high = case.z_high, storey = case.storey, span = case.span,
    procedure = procedure, warnings = {} }
  if base then row.fall, row.period = base.fall, base.period end
  return row
end

-- The verdict of a function of the user; a row without a result has none to judge.
local function own_verdict(criterion, row)
  local verdict, reason = criterion(row)
  if type(verdict) ~= "string" or verdict == "" then
    check.fail("%s: the function in field 'criterion' returned %s for case %d; must return a verdict (a string) and, "
      .. "if it likes, a reason", where, check.show(verdict), row.case)
  end
  return verdict, reason == nil and "" or tostring(reason)
end

local function run_case(study, case, rows)
  local base, why = runs.prepare(study, case)
  local verdicts = {}
  for _, procedure in ipairs(study.o.procedures) do
    local began, row = core.clock(), new_row(case, base, procedure)
    row.verdict, row.reason = "failed", why
    if base then row.verdict, row.reason = does[procedure](study, case, base, row) end
    if type(study.o.criterion) == "function" and row.verdict ~= "failed" then
      row.verdict, row.reason = own_verdict(study.o.criterion, row)
    end
    row.seconds = core.clock() - began
    for text in pairs(row.warnings) do
      if type(text) == "string" then row.warnings[text] = nil end
    end
    rows[#rows + 1], verdicts[#verdicts + 1] = row, row.verdict
  end
  return table.concat(verdicts, ", ")
end

local function tell(study, number, name, verdicts, seconds, so_far)
  if study.o.quiet then return end
  local n = #study.list
  local left = number < n and ("; about %s left"):format(status_line.time(so_far / number * (n - number))) or ""
  io.stderr:write(("%s: case %d of %d, %s: %s; %.1f s%s\n"):format(where, number, n, name, verdicts, seconds, left))
end

-- What `hinge plan` sees: a static and a dynamic run of the first case; no row has numbers.
local function plan(study, rows)
  local model = runs.fresh(study, study.list[1], "nonlinear dynamic", 1)
  local rest = model:static { steps = 10, loads = study.o.loads, record = false }:finish()
  model:dynamic { from = rest, dt = study.o.dt or 1e-3, duration = study.o.duration or 1, record = false }:finish()
  for _, case in ipairs(study.list) do
    for _, procedure in ipairs(study.o.procedures) do
      local row = new_row(case, nil, procedure)
      row.verdict, row.reason, row.seconds = "not run", "", 0
      rows[#rows + 1] = row
    end
  end
end

local function count(rows)
  local counts = {}
  for _, row in ipairs(rows) do
    local of = counts[row.procedure] or {}
    counts[row.procedure] = of
    of[row.verdict] = (of[row.verdict] or 0) + 1
  end
  return counts
end

-- The members of the structure for pictures, as pairs of points.
local function outline_of(geo)
  local lines = {}
  for i, m in ipairs(geo.members) do
    lines[i] = { { x = m.a.x, y = m.a.y, z = m.a.z }, { x = m.b.x, y = m.b.y, z = m.b.z } }
  end
  return lines
end

-- A case without an answer must not pass for one that holds: it ends the call, after the report is written.
local function refuse_failed(o, rows)
  local failed = {}
  for _, row in ipairs(rows) do
    if row.verdict == "failed" then failed[#failed + 1] = row end
  end
  if #failed == 0 or o.allow_failed then return end
  local first = failed[1]
  check.fail("%s: %d of %d rows failed, the first one in case %d (%s): %s; allow_failed = true returns the result all "
    .. "the same%s", where, #failed, #rows, first.case, first.procedure, first.reason,
    o.folder and "; the report is written" or "")
end

--- hinge.robustness: see words/robustness.d.lua.
return function(options, ...)
  check.no_more(where, ...)
  local o = read_options(options)
  local began, study, rows = core.clock(), open(o), {}
  if core.planning() then
    plan(study, rows)
  else
    for number, case in ipairs(study.list) do
      local start = core.clock()
      local verdicts = run_case(study, case, rows)
      tell(study, number, case.name, verdicts, core.clock() - start, core.clock() - began)
    end
  end
  local result = setmetatable({ rows = rows, cases = #study.list, counts = count(rows),
    criterion = type(o.criterion) == "string" and o.criterion or "a function", procedures = o.procedures, m = o.m,
    omega_ld = o.omega_ld or ufc.linear(o.m), has_limit = o.limit ~= nil, folder = o.folder,
    outline = outline_of(study.geo), seconds = core.clock() - began }, Result)
  if o.folder then result:report() end
  refuse_failed(o, rows)
  return result
end
