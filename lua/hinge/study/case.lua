-- One case of a study: run in a process of its own, and what the study keeps of it.
local core = require "hinge.core"
local check = require "hinge.check"
local files = require "hinge.study.files"
local runner = require "hinge.runner"

local case = {}

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

--- Makes the folder ready: what an earlier try has left there says nothing about this one.
function case.prepare(folder)
  core.write_text(folder .. "/output.txt", "")
  for _, name in ipairs { "summary.json", "case.json" } do os.remove(folder .. "/" .. name) end
end

--- Runs one case into `folder`, as hinge run does, and writes case.json, the files that it has read. what: scenario, or
-- nil where script is one of plain statements; script (path), case, overrides ({ { name, text } }). Returns the exit
-- status of the process.
function case.run(what, folder)
  local status = runner.guard(function()
    local result = runner.run { scenario = what.scenario, script = what.script, case = what.case,
      overrides = what.overrides, out = folder, out_given = true }
    if result == 0 then core.drop_checkpoints() end
    return result
  end)
  core.write_json(folder .. "/case.json", { files = files.read(core.whole_path(folder)) })
  return status
end

--- What a case has left in its folder, as { verdict =, reason =, results =, ... }, given how its process ended.
function case.outcome(folder, ended)
  local summary, said = json(folder .. "/summary.json") or {}, files.text(folder .. "/output.txt") or ""
  local kept = { verdict = summary.verdict, reason = summary.reason, results = flat(summary.results),
    energy_error = summary.energy_error, steps = summary.steps, files = (json(folder .. "/case.json") or {}).files }
  if ended.late then
    kept.verdict, kept.reason = "timed out", ("stopped after %g s"):format(ended.late)
  elseif ended.kind == "signal" then
    kept.verdict, kept.reason = "crashed", ("ended by signal %d"):format(ended.code)
  elseif said:find("not enough memory", 1, true) then
    kept.verdict, kept.reason = "out of memory", said:match "[^\n]*not enough memory[^\n]*"
  elseif ended.code == 3 or ended.code == 130 or ended.code == 143 then
    kept.verdict, kept.reason = "interrupted", nil
  elseif ended.code == 2 or not kept.verdict then
    kept.verdict, kept.reason = "wrong", said:match "([^\n]*)\n*$"
    for line in said:gmatch "hinge: ([^\n]*)" do kept.reason = line end
  end
  if kept.reason == "" then kept.reason = nil end
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
