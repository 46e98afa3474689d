-- Which files a script reads: itself, the modules it requires, what it loads, and data that it opens. A case's identity
-- holds what is in them.
local core = require "hinge.core"

local files = {}
local read = {} -- path = fingerprint, in the order of reading kept by `order`
local order = {}

local opened = io.open
files.open = opened -- for the study's own files, which say nothing about a case
local own = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" -- the study's own files say nothing about a case

local function note(path)
  if type(path) ~= "string" then return end
  local whole = core.whole_path(path)
  if read[whole] or whole:sub(1, #own) == own then return end
  local file = opened(whole, "rb")
  local text = file and file:read "a"
  if file then file:close() end
  if not text then return end
  read[whole] = core.fingerprint(text)
  order[#order + 1] = whole
end

--- From now on what is read is noted, also in processes that are started from this one.
function files.watch()
  if files.watching then return end
  files.watching = true
  local search = package.searchers[2]
  package.searchers[2] = function(name)
    local loader, path = search(name)
    if type(loader) == "function" then note(path) end
    return loader, path
  end
  for _, name in ipairs { "loadfile", "dofile" } do
    local original = _G[name]
    _G[name] = function(path, ...)
      note(path)
      return original(path, ...)
    end
  end
  local lines = io.lines
  io.open = function(path, mode)
    local file, problem, code = opened(path, mode)
    if file and (not mode or mode:find "^r" and not mode:find("+", 1, true)) then note(path) end
    return file, problem, code
  end
  io.lines = function(path, ...)
    if path then note(path) end
    return lines(path, ...)
  end
end

--- Adds a file that is read without Lua's help.
files.note = note

--- { { path, fingerprint }, ... } of what has been read, but for what lies in a folder.
function files.read(without)
  local list = {}
  for _, path in ipairs(order) do
    if not without or path:sub(1, #without) ~= without then list[#list + 1] = { path, read[path] } end
  end
  table.sort(list, function(a, b) return a[1] < b[1] end)
  return list
end

local now = {} -- path = fingerprint as it is, once a study

--- Whether the files are still what they were; if not, the path of the first that is not.
function files.same(list)
  for _, one in ipairs(list) do
    local path = one[1]
    if now[path] == nil then
      local file = opened(path, "rb")
      local text = file and file:read "a"
      if file then file:close() end
      now[path] = text and core.fingerprint(text) or false
    end
    if now[path] ~= one[2] then return false, path end
  end
  return true
end

return files
