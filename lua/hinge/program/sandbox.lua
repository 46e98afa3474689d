-- The globals of a script that is not trusted: Lua without files, processes, native modules and debug functions, and a
-- separate copy of the library. src/script/lua/sandbox.h has its limits.
local core = require "hinge.core"
local check = require "hinge.library.check"
local scenario = require "hinge.program.scenario" -- shared: its module table never leaves the library

local globals = "assert error getmetatable ipairs next pairs pcall rawequal rawget rawlen rawset select setmetatable "
  .. "tonumber tostring type xpcall _VERSION"
local libraries = {
  coroutine = "close create isyieldable resume running status wrap yield",
  debug = "traceback",
  math = "*",
  os = "clock date difftime time",
  string = "*",
  table = "*",
  utf8 = "*",
}
local left_out = { ["string.dump"] = true }
local own_modules = { "hinge", "hinge.library.check", "hinge.models.aircraft", "hinge.models.materials",
  "hinge.models.space_frame", "hinge.models.ten_storey", "hinge.models.ten_storey_impact", "hinge.paper",
  "hinge.report", "hinge.sections", "hinge.sections.shapes", "hinge.library.values" }

-- A table that explains why a function of Lua is missing. The script cannot reach its metatable.
local function guarded(copy, original, prefix)
  return setmetatable(copy, { __metatable = false, __index = function(_, key)
    if original[key] ~= nil then check.fail("%s%s is not available to a script in the sandbox", prefix, key) end
  end })
end

local function copy_of(name, names)
  local original, copy = _G[name], {}
  for key, value in pairs(original) do
    if (names == "*" or (" " .. names .. " "):find(" " .. key .. " ", 1, true))
      and not left_out[name .. "." .. key] then
      copy[key] = value
    end
  end
  return guarded(copy, original, name .. ".")
end

local function collect(option, ...)
  if option ~= nil and option ~= "collect" and option ~= "count" and option ~= "step" then
    check.fail("collectgarbage: option %s is not available to a script in the sandbox; "
      .. "'collect', 'count' and 'step' are", check.show(option))
  end
  return collectgarbage(option, ...)
end

-- Commands to the terminal, such as those that write its title, are not passed on; line ends and tabs are.
local function plain_print(...)
  local parts = table.pack(...)
  for i = 1, parts.n do parts[i] = check.plain(tostring(parts[i])) end
  print(table.unpack(parts, 1, parts.n))
end

local function environment(require)
  local env = { require = require, collectgarbage = collect, print = plain_print }
  for name in globals:gmatch "%S+" do env[name] = _G[name] end
  for name, names in pairs(libraries) do env[name] = copy_of(name, names) end
  for _, name in ipairs { "io", "package" } do env[name] = guarded({}, _G[name], name .. ".") end
  env.load = function(chunk, name, _, ...) return load(chunk, name, "t", select("#", ...) > 0 and (...) or env) end
  env._G = env
  return guarded(env, _G, "")
end

-- A copy of a module for the script: what it writes there changes nothing for the library itself. Tables inside are
-- copies too, and so is what a module reads only when it is asked for.
local function copy_for_script(original, copies)
  if type(original) ~= "table" then return original end
  if copies[original] then return copies[original] end
  local copy, meta = {}, debug.getmetatable(original)
  copies[original] = copy
  for key, value in next, original do copy[key] = copy_for_script(value, copies) end
  if not meta then return copy end
  return setmetatable(copy, {
    __metatable = false,
    __index = function(_, key)
      local value = copy_for_script(original[key], copies)
      if value ~= nil then copy[key] = value end
      return value
    end,
    __call = meta.__call and function(_, ...) return meta.__call(original, ...) end,
  })
end

-- The script sees the metatables that it has set itself, and no other: those of the library's lists and results have
-- the library's functions.
local function metatables(env)
  local own = setmetatable({}, { __mode = "k" })
  function env.setmetatable(t, meta)
    local done, why = pcall(setmetatable, t, meta)
    if not done then error(why, 2) end
    if meta then own[meta] = true end
    return t
  end
  function env.getmetatable(t)
    local meta = getmetatable(t)
    if meta == nil or own[meta] then return meta end
    return false
  end
end

-- What starts processes and writes folders of its own.
local starts_processes = { "benchmark", "study" }

local sandbox = {}

--- The globals for one script. From here on the state is the sandbox's: methods of strings are copies too.
function sandbox.environment()
  local text = getmetatable ""
  text.__index, text.__metatable = copy_of("string", "*"), false
  local loaded = { ["hinge.core"] = core, ["hinge.program.scenario"] = scenario,
    ["hinge.study.files"] = { watch = function() end } } -- the script reads no files
  local inner = nil
  local function load_own(name)
    if loaded[name] == nil then
      local path = assert(package.searchpath(name, package.path))
      loaded[name] = assert(loadfile(path, "t", inner))(name, path)
    end
    return loaded[name]
  end
  inner = environment(load_own) -- the library's own, with the core in reach
  local copies = {}
  local env = environment(function(name)
    for _, own in ipairs(own_modules) do
      if name == own then return copy_for_script(load_own(name), copies) end
    end
    check.fail("require: module %s is not available to a script in the sandbox; there are %s", check.show(name),
      table.concat(own_modules, ", "))
  end)
  metatables(env)
  local module = copy_for_script(load_own "hinge", copies)
  for _, name in ipairs(starts_processes) do
    module[name] = function()
      check.fail("hinge.%s is not available to a script in the sandbox: it starts processes and writes folders of its "
        .. "own; run it without --sandbox", name)
    end
  end
  return env
end

return sandbox
