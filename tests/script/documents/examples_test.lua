-- Every call in the reference has an example that names it, and every example runs, each in an environment of its own,
-- after the lines that the reference states at its top. No run of an example fails.
--
-- Run: lua5.4 tests/script/documents/examples_test.lua BUILD_FOLDER
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"

-- They write pictures and checkpoints where Lua was started: this file starts itself again in a folder that goes.
if not arg[2] then
  local folder = support.temporary_folder()
  local quote = support.quote
  local status, printed, complaint = support.run(("here=$(realpath %s) build=$(realpath %s) && cd %s && "
    .. "LUA_CPATH=$build/?.so lua5.4 $here $build inside %s"):format(
    quote(support.folder .. "documents/examples_test.lua"),
    quote(arg[1]), quote(folder), quote(support.case_argument)))
  io.write(printed)
  io.stderr:write(complaint)
  if status ~= 0 then os.exit(1) end
  return
end

local checks = support.checks "examples"
local case, expect, equal = checks.case, checks.expect, checks.equal
require "hinge"
local reference = require "hinge.program.reference"
local runs_of = require "scenes".runs_of
local new_job = require "hinge.program.job".new
os.execute "mkdir -p job"
local has_pictures = support.is_there(arg[1] .. "/libhinge_output.so")

-- Runs an example without what it prints; returns nil, or what is wrong. Its runs are looked at when it has ended.
local function problem_of(example, name)
  local environment = setmetatable({ job = new_job "job", print = function() end }, { __index = _G })
  local chunk, wrong = load(reference.preamble .. "\n" .. example, "=" .. name, "t", environment)
  if not chunk then return wrong end
  local ok, message, runs = runs_of(function()
    local made = chunk()
    if type(made) == "table" and made.run then made.run(made:values(), environment.job) end -- as the program would
  end)
  if not ok then return tostring(message) end
  for _, run in ipairs(runs) do
    local open, verdict = pcall(function() return run.verdict end) -- the model of a run may be closed by now
    if open and verdict == "failed" then return "a run failed: " .. run.reason end
  end
  for key in pairs(environment) do
    if key ~= "job" and key ~= "print" then return ("it sets the global '%s'"):format(key) end
  end
end

case("an example that is wrong is noticed", function()
  for example, wanted in pairs {
    ["model:nod { 0, 0, 0 }"] = "nod", ["tip = nil x = 1"] = "global 'x'", ["x ="] = "unexpected symbol",
    ["model:load { node = tip, force = { 0, 0, -1e9 } } model:static():finish()"] = "a run failed",
    ["return hinge.scenario { run = function() error 'inside' end }"] = "inside",
  } do
    expect((problem_of(example, "planted") or "nothing"):find(wanted, 1, true), "'%s' is not noticed: %s", example,
      tostring(problem_of(example, "planted")))
  end
  equal(problem_of("", "planted"), nil, "the lines that examples start from")
end)

case("every example of the reference runs", function()
  local page = reference.page()
  expect(page:find("```lua\n" .. reference.preamble .. "\n```", 1, true), "the page does not state the first lines")
  local count = 0
  for _, e in ipairs(reference.read()) do
    if e.kind == "function" then
      count = count + 1
      local call = reference.signature(e):match "^[^(]*"
      if expect(e.example, "%s: %s has no example: write Lua between ---```lua and ---``` above it", e.line, call) then
        local own = e.example:gsub("%-%-[^\n]*", "")
        expect(own:find("[.:]" .. e.name .. "%f[^%w_]"), "%s: the example of %s does not call it", e.line, call)
        local problem = problem_of(e.example, call)
        expect(not problem, "%s: the example of %s: %s", e.line, call, tostring(problem))
      end
    end
  end
  expect(count > 100, "%d calls in the reference", count)
  for _, name in ipairs { "cantilever.png", "frames.pvd", "swing.checkpoint", "job/load.png" } do
    expect(support.is_there(name) or name:find "%.p" and not has_pictures, "no example wrote %s", name)
  end
end)

checks.done()
