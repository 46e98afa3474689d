-- Nothing that a script in the sandbox can change is shared with the library. Two walks are compared: one over all
-- tables of the library, with Lua's debug functions, and one over all that the script can get at, with its own powers:
-- pairs, getmetatable, every name that occurs anywhere as a field of every object, and calls.
--
-- Run: lua5.4 tests/script/program/sandbox_sharing_test.lua
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"

-- The examples write where Lua was started: this file starts itself again in a folder that goes.
if not arg[1] then
  local status, printed, complaint = support.run(("here=$(realpath %s) && cd %s && lua5.4 $here inside %s")
    :format(support.quote(support.folder .. "program/sandbox_sharing_test.lua"),
      support.quote(support.temporary_folder()),
      support.quote(support.case_argument)))
  io.write(printed)
  io.stderr:write(complaint)
  os.exit(status)
end

local checks = support.checks "sandbox_sharing"
local case, expect = checks.case, checks.expect
require "hinge"
local reference = require "hinge.program.reference"
local jobs = require "hinge.program.job"

local say = print
local env = require "hinge.program.sandbox".environment()

local function upvalue(f, wanted)
  for i = 1, 255 do
    local name, value = debug.getupvalue(f, i)
    if name == wanted then return value end
    if not name then return nil end
  end
end

-- The library's own modules inside the sandbox, by name.
local load_own = upvalue(env.require, "load_own")
local loaded = upvalue(load_own, "loaded")

-- All modules, also those that are loaded when they are first needed.
for name in support.output(("cd %s && find hinge -name '*.lua'"):format(support.quote(support.root .. "lua")))
  :gmatch "(hinge/[%w_/]+)%.lua" do
  name = name:gsub("/init$", ""):gsub("/", ".")
  if not name:find "%.d$" and not name:find "template" then pcall(load_own, name) end
end

-- Tables, userdata and functions in reach of these values for somebody with the debug library.
local function walk_library(roots, seen)
  local queue = roots
  local function visit(value)
    local kind = type(value)
    if (kind == "table" or kind == "userdata" or kind == "function") and not seen[value] then
      seen[value] = true
      queue[#queue + 1] = value
    end
  end
  while #queue > 0 do
    local value = table.remove(queue)
    if type(value) == "table" then
      for key, item in next, value do visit(key) visit(item) end
    elseif type(value) == "function" then
      for i = 1, 255 do
        local name, item = debug.getupvalue(value, i)
        if not name then break end
        visit(item)
      end
    elseif type(value) == "userdata" then
      for i = 1, 4 do visit((debug.getuservalue(value, i))) end
    end
    if type(value) ~= "function" and value ~= "" then visit(debug.getmetatable(value)) end
  end
end

-- All of the library, but for what is made for this script.
local function library(but)
  local seen, roots = {}, {}
  -- what the sandbox has made for the script is no part of the library
  seen[upvalue(env.require, "copies")], seen[env.require] = true, true
  seen[package.loaded] = true
  for name, module in pairs(loaded) do
    if name ~= "hinge.program.sandbox" then roots[#roots + 1] = module seen[module] = true end
  end
  for name, module in pairs(package.loaded) do
    if name:find "^hinge" and name ~= "hinge.program.sandbox" then roots[#roots + 1] = module seen[module] = true end
  end
  for value in pairs(but) do seen[value] = true end
  walk_library(roots, seen)
  for value in pairs(but) do seen[value] = nil end
  seen[upvalue(env.require, "copies")], seen[package.loaded] = nil, nil
  return seen
end

-- Names of fields anywhere in the library.
local function all_names(seen)
  local names = { "__index", "__newindex", "__metatable", "__name", "__gc", "__call", "__pairs", "methods", "fields" }
  local known = {}
  for value in pairs(seen) do
    for key in next, type(value) == "table" and value or {} do
      if type(key) == "string" and not known[key] then known[key], names[#names + 1] = true, key end
    end
  end
  return names
end

-- What the script can reach from these values: each with the way there.
local function walk_script(roots, names)
  local way, queue, probed = {}, {}, {} -- probed: objects of a metatable, of which ten are asked for all names
  local function visit(value, path)
    local kind = type(value)
    if (kind == "table" or kind == "userdata") and not way[value] then
      way[value] = path
      queue[#queue + 1] = value
    elseif kind == "function" and not way[value] then
      way[value] = path
    end
  end
  for name, value in pairs(roots) do visit(value, name) end
  while #queue > 0 do
    local value = table.remove(queue)
    local path = way[value]
    local meta = env.getmetatable(value)
    if meta then visit(meta, path .. " metatable") end
    if type(value) == "table" then
      for key, item in next, value do
        visit(key, path .. " key")
        visit(item, path .. "." .. tostring(key))
      end
      pcall(function()
        for key, item in env.pairs(value) do visit(key, path) visit(item, path .. "." .. tostring(key)) end
      end)
    end
    local class = debug.getmetatable(value)
    if class then probed[class] = (probed[class] or 0) + 1 end
    if class and probed[class] <= 10 then
      for _, name in ipairs(names) do
        local ok, item = pcall(function() return value[name] end)
        if ok and item ~= nil then visit(item, path .. "." .. name) end
      end
    end
  end
  return way
end

-- Runs a chunk as a script of the sandbox and keeps what each of its calls returns: keep(value, name of the chunk).
local function run_script(code, name, environment, keep)
  local chunk = assert(load(code, "=" .. name, "t", environment))
  debug.sethook(function()
    local caller = debug.getinfo(3, "S")
    if not caller or caller.short_src ~= name then return end
    local returned = debug.getinfo(2, "r")
    for i = returned.ftransfer, returned.ftransfer + returned.ntransfer - 1 do
      local _, value = debug.getlocal(2, i)
      keep(value, name)
    end
  end, "r")
  local ok, result = pcall(chunk)
  if ok and type(result) == "table" and rawget(result, "run") then
    ok, result = pcall(result.run, result:values(), environment.job)
  end
  debug.sethook()
  return ok, result
end

-- Every function of the modules, called without arguments and with an empty table.
local call_all = [[
local function call_all(t, depth)
  for key, f in pairs(t) do
    if type(f) == "function" then pcall(f) pcall(f, {})
    elseif type(f) == "table" and depth < 2 then call_all(f, depth + 1) end
  end
end
for _, name in ipairs { "hinge", "hinge.library.check", "hinge.models.aircraft", "hinge.models.materials",
  "hinge.models.space_frame", "hinge.models.ten_storey", "hinge.models.ten_storey_impact", "hinge.paper",
  "hinge.report", "hinge.sections", "hinge.sections.shapes", "hinge.library.values" } do call_all(require(name), 0) end
]]

case("no table of the library is in the script's reach, by fields, metatables or calls", function()
  local job = jobs.new "job" -- one for each script, which the library keeps
  jobs.use(job)
  local shared = library { [job] = true }
  local names = all_names(shared)
  local got, count = { env = env, job = job }, 0
  local function keep(value, name)
    count = count + 1
    if type(value) == "table" or type(value) == "userdata" then got[name .. " " .. count] = value end
  end
  env.print, _G.print = function() end, function() end
  env.job = job
  local failed, ran = {}, 0
  for _, e in ipairs(reference.read()) do
    if e.kind == "function" and e.example then
      local ok, why = run_script(reference.preamble .. "\n" .. e.example, e.name, env, keep)
      ran = ran + 1
      -- studies and files are not for scripts of the sandbox
      if not ok and not tostring(why):find "sandbox" then failed[#failed + 1] = e.name .. ": " .. tostring(why) end
    end
  end
  run_script(call_all, "all calls", env, keep)
  _G.print = say
  expect(ran > 150 and #failed == 0, "%d examples, of which failed: %s", ran, table.concat(failed, "\n"))
  local way, found = walk_script(got, names), 0
  for value, path in pairs(way) do
    -- functions are no store: a script cannot change one
    if shared[value] and type(value) == "table" then
      found = found + 1
      if found < 20 then expect(false, "%s is the library's own", path) end
    end
  end
  -- what the library keeps since then, and the script has too
  local kept = {}
  for value in pairs(library { [job] = true }) do
    if not shared[value] and way[value] and type(value) == "table" then kept[#kept + 1] = way[value] end
  end
  table.sort(kept)
  expect(#kept == 0, "the library keeps %d tables that the script has: %s", #kept, table.concat(kept, "; ", 1,
    #kept > 30 and 30 or #kept))
  local total = 0
  for _ in pairs(way) do total = total + 1 end
  expect(total > 5000, "%d things in reach, of %d results", total, count)
end)

checks.done()
