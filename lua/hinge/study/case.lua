-- One case of a study, in the process that runs it: the scenario's run, its summary, and what the study keeps of it.
local core = require "hinge.core"
local check = require "hinge.check"
local files = require "hinge.study.files"
local job = require "hinge.job"
local runner = require "hinge.runner"

local case = {}

--- Results as a flat table: { ["damage.columns"] = 3 }; numbers, strings and booleans, tables of names four deep; items
-- of lists are left out.
function case.flat(results)
  local flat = {}
  local function add(prefix, value, depth)
    local kind = type(value)
    if kind == "number" or kind == "string" or kind == "boolean" then
      flat[prefix == "" and "result" or prefix] = value
    elseif kind == "table" and depth < 4 then
      for key, item in pairs(value) do
        if type(key) == "string" then add(prefix == "" and key or prefix .. "." .. key, item, depth + 1) end
      end
    end
  end
  add("", results, 0)
  return flat
end

local function energy_of(folder)
  local file = files.open(folder .. "/summary.json")
  local summary = file and core.from_json(file:read "a") or {}
  if file then file:close() end
  return summary
end

--- Runs one case into `folder` and writes case.json there. what: scenario (or nil, and script: a path), case,
-- overrides ({ { name, text } }), values (those of hinge.study, by name). Returns the process's exit status.
function case.run(what, folder)
  job.own_output(folder, { script = what.script, case = what.case, parameters = what.parameters }, true)
  local this = job.new(folder, what.case)
  job.use(this)
  local kept = {}
  local status = runner.guard(function()
    local results, used
    local loaded, plain, must_be_read = what.scenario, nil, nil
    if not loaded then loaded, results, plain, must_be_read = runner.load(what.script, what.overrides) end
    if loaded then
      used = loaded:values(what.case, what.overrides)
      results = loaded.run(used, this)
    else
      used = plain
    end
    kept.results = case.flat(results)
    kept.verdict, kept.reason = core.write_summary {
      results = results, parameters = used, case = what.case, script = what.script, notes = this.notes,
      whole = this.whole,
    }
    if must_be_read then must_be_read() end
    if case.finished(kept.verdict) then core.drop_checkpoints() end
    return runner.status(kept.verdict, kept.reason)
  end)
  local summary = kept.verdict and energy_of(folder) or {}
  kept.energy_error, kept.steps = summary.energy_error, summary.steps
  kept.files = files.read(core.whole_path(folder))
  core.write_text(folder .. "/case.json", core.to_json(kept) .. "\n")
  return status
end

--- What a case has left in its folder, as { verdict =, reason =, results =, ... }, given how its process ended.
function case.outcome(folder, ended)
  local file = files.open(folder .. "/case.json")
  local kept = file and core.from_json(file:read "a") or {}
  if file then file:close() end
  local said = ""
  local output = files.open(folder .. "/output.txt")
  if output then
    said = output:read "a"
    output:close()
  end
  if ended.late then
    kept.verdict, kept.reason = "timed out", ("stopped after %g s"):format(ended.late)
  elseif ended.kind == "signal" then
    kept.verdict, kept.reason = "crashed", ("ended by signal %d"):format(ended.code)
  elseif said:find("not enough memory", 1, true) then
    kept.verdict, kept.reason = "out of memory", said:match "[^\n]*not enough memory[^\n]*"
  elseif ended.code == 3 or ended.code == 130 or ended.code == 143 then
    kept.verdict, kept.reason = "interrupted", nil
  elseif not kept.verdict then
    kept.verdict = "wrong"
    for line in said:gmatch "hinge: ([^\n]*)" do kept.reason = line end
    kept.reason = kept.reason or said:match "([^\n]*)\n*$"
  end
  if kept.reason == "" then kept.reason = nil end
  kept.results = kept.results or {}
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
