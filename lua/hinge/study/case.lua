-- One case of a study: run in a process of its own, and what the study keeps of it.
local core = require "hinge.core"
local check = require "hinge.library.check"
local files = require "hinge.study.files"
local runner = require "hinge.program.runner"
local tables = require "hinge.study.table"

local case = {}

-- Exit status of a case that ran out of memory: core.start has the same. hinge itself ends with none like it.
local out_of_memory = 5

-- Results as a flat table: { ["damage.columns"] = 3 }; numbers, strings and booleans, tables of names four deep; items
-- of lists are left out.
local function flat(results)
  local all = {}
  local function add(prefix, value, depth)
    local kind = type(value)
    if kind == "number" or kind == "string" or kind == "boolean" then
      all[prefix == "" and "result" or prefix] = value
    elseif kind == "table" and depth < 4 then
      for key, item in pairs(value) do
        if type(key) == "string" then add(prefix == "" and key or prefix .. "." .. key, item, depth + 1) end
      end
    end
  end
  add("", results, 0)
  return all
end

local function json(path)
  local text = files.text(path)
  return text and core.from_json(text) or nil
end

-- Raises an error where a result has the name of a column that results.csv has for something else.
local function check_names(results, parameters, scenario, what)
  local line = scenario and debug.getinfo(scenario.run, "S")
  local where = line and ("%s:%d"):format(line.short_src, line.linedefined) or what.script
  local varied = {}
  for _, name in ipairs(what.varied or {}) do varied[name] = true end
  for name, value in pairs(flat(results)) do
    if varied[name] then
      if value ~= parameters[name] then
        check.fail("%s: the result '%s' is %s, and the study varies a parameter of that name, which is %s; choose "
          .. "another name for the result", where, name, check.show(value), check.show(parameters[name]))
      end
    elseif tables.own[name] then
      check.fail("%s: the result '%s' has the name of a column that results.csv has of its own; choose another name "
        .. "than %s", where, name, table.concat(check.keys(tables.own), ", "))
    end
  end
end

--- Makes the folder ready: what an earlier try has left there says nothing about this one.
function case.prepare(folder)
  core.write_text(folder .. "/output.txt", "")
  for _, name in ipairs { "summary.json", "case.json" } do os.remove(folder .. "/" .. name) end
end

-- The modules of hinge that are loaded, by name.
local function modules()
  local names = {}
  for name in pairs(package.loaded) do names[name] = name:find "^hinge%." and true or nil end
  return names
end

--- Loads what cases before have loaded, so that the processes of the next ones find it there. What cannot be loaded
-- here is left to them.
function case.load_modules(names)
  for _, name in ipairs(names or {}) do
    if not package.loaded[name] then pcall(require, name) end
  end
end

--- Runs one case into `folder`, as hinge run does, and writes case.json: the files that it has read, the modules of
-- hinge that it has loaded, and an error, { kind =, text = }. what: scenario, or nil where script is one of plain
-- statements; script (path), case, overrides ({ { name, text } }), varied (names). Returns the exit status of the
-- process.
function case.run(what, folder)
  local raised
  local before = modules()
  local status = runner.guard(function()
    local result = runner.run { scenario = what.scenario, script = what.script, case = what.case,
      overrides = what.overrides, out = folder, out_given = true, see = function(results, parameters, scenario)
        check_names(results, parameters, scenario, what)
      end }
    if result == 0 then core.drop_checkpoints() end
    return result
  end, nil, function(failure) raised = { kind = failure.kind, text = failure.message or failure.text } end)
  if raised and raised.kind == "memory" then return out_of_memory end
  local loaded = {}
  for _, name in ipairs(check.keys(modules())) do
    if not before[name] then loaded[#loaded + 1] = name end
  end
  core.write_json(folder .. "/case.json",
    { files = files.read(core.whole_path(folder)), modules = loaded, error = raised })
  return status
end

-- Of a process that could not say more.
local function last_line(path) return (files.text(path) or ""):match "([^\n]*)\n*$" end

--- What a case has left in its folder, as { verdict =, reason =, results =, ... }, given how its process ended.
function case.outcome(folder, ended)
  local summary, left = json(folder .. "/summary.json") or {}, json(folder .. "/case.json") or {}
  local kept = { verdict = summary.verdict, reason = summary.reason, cause = summary.cause,
    results = flat(summary.results), energy_error = summary.energy_error, steps = summary.steps, files = left.files,
    modules = left.modules, warnings = summary.warnings }
  if ended.late then
    kept.verdict, kept.reason = "timed out", ("stopped after %g s"):format(ended.late)
  elseif ended.kind == "signal" and ended.stopped then
    kept.verdict, kept.reason = "interrupted", nil
  elseif ended.kind == "signal" then
    kept.verdict, kept.reason = "crashed", ("ended by signal %d"):format(ended.code)
  elseif ended.code == out_of_memory then
    kept.verdict, kept.reason = "out of memory", "not enough memory"
  elseif ended.code == 3 or ended.code == 130 or ended.code == 143 then
    kept.verdict, kept.reason = "interrupted", nil
  elseif ended.code == 2 or not kept.verdict then
    kept.verdict, kept.reason = "wrong", left.error and left.error.text or last_line(folder .. "/output.txt")
  end
  if kept.reason == "" then kept.reason = nil end
  if kept.verdict ~= "failed" then kept.cause = nil end
  if kept.verdict == "completed" or kept.verdict == "stopped" then -- runs whose failure the script knows of
    kept.reason = kept.reason or (summary.failed_runs or {})[1]
  end
  return kept
end

--- Whether a verdict is an answer, which --resume keeps.
function case.finished(verdict) return verdict == "completed" or verdict == "stopped" end

--- A parameter's value as text that gives it back.
function case.text(value)
  if math.type(value) == "float" then return ("%.17g"):format(value) end
  if type(value) ~= "table" then return tostring(value) end
  local items = {}
  for i, item in ipairs(value) do items[i] = case.text(item) end
  return "{" .. table.concat(items, ",") .. "}"
end

--- Parameters as the list of overrides that the command line would give.
function case.overrides(parameters)
  local list = {}
  for _, name in ipairs(check.keys(parameters)) do list[#list + 1] = { name, case.text(parameters[name]) } end
  return list
end

return case
