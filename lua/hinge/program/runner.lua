-- Runs one script for the program: loads it, gives it its parameters, writes the summary, and says how it went.
local core = require "hinge.core"
local check = require "hinge.library.check"
local hinges = require "hinge.results.hinges"
local job = require "hinge.program.job"
local parameters = require "hinge.program.parameters"
local scenario = require "hinge.program.scenario"

local runner = {}
local done, run_failed, wrong_input = 0, 1, 2
local library = debug.getinfo(1, "S").source:gsub("runner%.lua$", "")

-- The places in the script through which an error came, nearest first; the library's own frames are left out.
local function places(level)
  local lines = {}
  while #lines < 6 do
    local info = debug.getinfo(level, "Sl")
    if not info then break end
    if info.what ~= "C" and info.source:sub(1, #library) ~= library then
      lines[#lines + 1] = ("  at %s:%d"):format(info.short_src, info.currentline)
    end
    level = level + 1
  end
  return lines
end

local about_settings = "" -- what may have been meant by settings that are not numbers

-- Lua keeps the message handler out of this one: there may be no memory for it.
local out_of_memory = "not enough memory"

-- Message handler: what to print and which status it means.
local function explain(failure)
  if failure == out_of_memory then return failure end
  local kind, status = core.error_kind(failure)
  if kind then
    local text = tostring(failure) .. (kind == "input" and about_settings or "")
    return { status = status or kind == "outside" and run_failed or wrong_input, text = text, kind = kind }
  end
  local has_text = type(failure) == "string" or getmetatable(failure) and getmetatable(failure).__tostring
  local text = has_text and tostring(failure) or ("the script raised a %s"):format(type(failure))
  return { status = wrong_input, text = table.concat({ text, table.unpack(places(3)) }, "\n") .. about_settings,
    message = text }
end

--- The exit status that a verdict means; why a run failed goes to stderr.
function runner.status(verdict, reason)
  if verdict == "failed" then io.stderr:write("hinge: the run failed: " .. tostring(reason) .. "\n") end
  return verdict == "failed" and run_failed or done
end

--- Loads a script. Returns its scenario; or, when it is made of plain statements, nil, what they returned, the
-- settings and a function that raises an error if one of these was not read: only running a script tells which of the
-- two it is. `overrides`: the settings, which plain statements get in a table, `...`; `sandbox`, whether the script is
-- not trusted.
function runner.load(path, overrides, sandbox)
  local code = core.read_text(path) or ""
  local chunk, problem = loadfile(path, "t", sandbox and require "hinge.program.sandbox".environment() or _G)
  if not chunk then check.fail("%s", problem) end
  local watched, plain, must_be_read = parameters.of(overrides, path, code)
  about_settings = parameters.all_about_units(overrides)
  local before = core.script_runs(true)
  local result = chunk(watched)
  core.script_runs(before)
  about_settings = ""
  if scenario.is(result) then return result end
  return nil, result, plain, must_be_read
end

-- Runs a script without steps, so that its runs describe themselves. Errors of the script because results are missing
-- do not count. For a check, errors that the engine raises count.
local function plan_script(options)
  local checking = options.verb == "check"
  core.plan(checking)
  local say = print
  print = function() end
  local all_read = nil -- once a script of plain statements has come to its end
  local ok, failure = xpcall(function()
    local this = job.new("", options.case)
    job.use(this)
    if options.sandbox then core.raise_walls(options.script) end
    local loaded, _, _, must_be_read = runner.load(options.script, options.overrides, options.sandbox)
    if not loaded then all_read = must_be_read return end
    loaded.run(loaded:values(options.case, options.overrides), this)
  end, explain)
  print = say
  if all_read then all_read() end
  local described = core.runs_made()
  if ok and described == 0 then
    say(("nothing %s: the script makes no run"):format(checking and "to check" or "would be simulated"))
  end
  if ok then return done end
  if described == 0 or checking and failure.kind == "input" then
    io.stderr:write("hinge: " .. failure.text .. "\n")
    return failure.status
  end
  say(("the rest of the script needs results, so it was not followed (%s)"):format(
    check.one_line(failure.message or failure.text)))
  return done
end

-- A value as a part of a folder's name.
local function name_part(value)
  if type(value) == "table" then
    local items = {}
    for i, item in ipairs(value) do items[i] = name_part(item) end
    return table.concat(items, ",")
  end
  local text = math.type(value) == "float" and ("%.6g"):format(value) or tostring(value)
  return (text:gsub("[^%w._+-]", "_"))
end

--- The output folder for these parameters: options.out, with them in its name unless the user gave it.
function runner.folder(options, changed)
  local folder = options.out
  if options.out_given then return folder end
  for _, name in ipairs(check.keys(changed)) do
    folder = ("%s-%s=%s"):format(folder, name_part(name), name_part(changed[name]))
  end
  return folder:sub(1, 160)
end

-- The script's output folder, with the parameters that differ from their defaults in its name. `changed`: those.
local function own_output(options, used, changed)
  if not options.out then return core.out_dir() end
  local owner = { script = options.script and core.whole_path(options.script), case = options.case,
    parameters = used, changed = changed }
  local folder = job.own_output(runner.folder(options, changed), owner, options.out_given ~= nil)
  core.refuse_locked(folder) -- before hours of work
  return folder
end

--- Runs a script and writes its summary. Returns the exit status; see runner.main for the options. One more: scenario,
-- where it is known; the script is not loaded then. And see(results, parameters, scenario or nil), which may object.
function runner.run(options)
  local settings = parameters.given(options.overrides)
  local this = job.new(own_output(options, settings, settings), options.case)
  job.use(this)

  -- The kernel must know the folder before anything of the script runs, so that in the sandbox the settings name it as
  -- they were given.
  if options.sandbox then core.raise_walls(options.script, core.out_dir()) end
  local before = core.script_runs(true)
  local used
  local loaded, results, plain, must_be_read = options.scenario, nil, nil, nil
  if not loaded then
    loaded, results, plain, must_be_read = runner.load(options.script, options.overrides, options.sandbox)
  end
  if loaded then
    used = loaded:values(options.case, options.overrides)
    if not options.sandbox then this.out = own_output(options, used, loaded:changed(options.case, used)) end
    results = loaded.run(used, this)
  else
    if options.case then
      check.fail("--case %s: %s has no cases; it does not return a hinge.scenario", options.case, options.script)
    end
    used = plain
  end
  core.script_runs(before)
  if options.see then options.see(results, used, loaded) end
  local all_read, unread = pcall(must_be_read or function() end)
  if not all_read then this.whole = { verdict = "failed", reason = tostring(unread) } end
  local verdict, reason = core.write_summary {
    results = results, parameters = used, case = options.case, script = options.script, notes = this.notes,
    whole = this.whole,
  }
  if options.out then hinges.leave() end
  if not all_read then error(unread, 0) end
  return runner.status(verdict, reason)
end

--- Calls f, prints what goes wrong, and returns the program's exit status: f's own, or the one its error means.
-- `memory`: the sandbox's limit as text, or nil. see({ status =, kind =, text =, message = }) hears of an error, whose
-- kind is that of core.error_kind or "memory"; message: without the places that led to it, nil where there are none.
function runner.guard(f, memory, see)
  local ok, result = xpcall(f, explain)
  if ok then return result end
  if result == out_of_memory then
    local more = memory and ("; the sandbox's limit is %s, --memory gives more"):format(memory) or ""
    result = { status = run_failed, text = out_of_memory .. more, kind = "memory" }
  elseif type(result) ~= "table" then -- an error in the error message
    result = { status = wrong_input, text = tostring(result) }
  end
  core.event("error", { status = result.status, message = result.text })
  if memory then result.text = check.plain(result.text) end -- the script's own words
  if see then see(result) end
  io.stderr:write("hinge: " .. result.text .. "\n") -- one write: what a terminal echoes meanwhile does not come between
  return result.status
end

--- Runs a script and returns the program's exit status: 0 done, 1 the run failed, 2 the script or its
-- input is wrong, 3 interrupted with a checkpoint written, 130 or 143 without one. options: script
-- (path), verb ("run", "plan", "check"), overrides (list of { name, text }), case (name or nil), out
-- (folder), sandbox (its memory as text, or nil).
function runner.main(options)
  return runner.guard(function()
    local verb = options.verb or "run"
    if verb == "plan" or verb == "check" then return plan_script(options) end
    if verb ~= "run" then check.unknown("hinge", "verb", verb, { "run", "plan", "check" }) end
    return runner.run(options)
  end, options.sandbox)
end

return runner
