-- Which files a script reads: itself, the modules it requires, what it loads, and data that it opens. A case's identity
-- holds what is in them.
local core = require "hinge.core"
local check = require "hinge.check"

local files = {}
local fingerprint_of = {} -- by whole path, of what has been read
local own = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$"
local open = io.open

--- All of a file without noting that it was read, or nil: for what the study itself writes.
function files.text(path)
  local file = open(path, "rb")
  local text = file and file:read "a"
  if file then file:close() end
  return text
end

--- Notes that a file is read. The study's own modules say nothing about a case.
function files.note(path)
  if type(path) ~= "string" then return end
  local whole = core.whole_path(path)
  if fingerprint_of[whole] or whole:sub(1, #own) == own then return end
  local text = files.text(whole)
  if text then fingerprint_of[whole] = core.fingerprint(text) end
end

-- Whether a module of that name is part of a case: of hinge's own those that are models, the others being a part of the
-- engine.
local function is_of_script(name) return name:find "^hinge%.models%." or not name:find "^hinge%f[%W]" end

-- What was read before anybody looked: the script that Lua runs, and the modules that it has required.
local function note_loaded()
  files.note(type(arg) == "table" and arg[0] or nil)
  for name in pairs(package.loaded) do
    if type(name) == "string" and is_of_script(name) then
      files.note((package.searchpath(name, package.path)))
    end
  end
end

--- From now on what is read is noted, also in processes that are started from this one. Returns a function that ends
-- it.
function files.watch()
  note_loaded()
  local note, search, loadfile, dofile, lines = files.note, package.searchers[2], loadfile, dofile, io.lines
  package.searchers[2] = function(name)
    local loader, path = search(name)
    if type(loader) == "function" and is_of_script(name) then note(path) end
    return loader, path
  end
  _G.loadfile = function(path, ...) note(path) return loadfile(path, ...) end
  _G.dofile = function(path, ...) note(path) return dofile(path, ...) end
  io.lines = function(path, ...) note(path) return lines(path, ...) end
  io.open = function(path, mode)
    local file, problem, code = open(path, mode)
    if file and (not mode or mode:find "^r" and not mode:find("+", 1, true)) then note(path) end
    return file, problem, code
  end
  return function()
    package.searchers[2], _G.loadfile, _G.dofile, io.lines, io.open = search, loadfile, dofile, lines, open
  end
end

--- { { path, fingerprint }, ... } of what has been read, but for what lies in a folder.
function files.read(without)
  local list = {}
  for _, path in ipairs(check.keys(fingerprint_of)) do
    if path:sub(1, #without) ~= without then list[#list + 1] = { path, fingerprint_of[path] } end
  end
  return list
end

--- A function that says whether the files of such a list are still what they were, and if not, which has changed. It
--- reads each file once.
function files.comparison()
  local now = {}
  return function(list)
    for _, one in ipairs(list) do
      local path = one[1]
      if now[path] == nil then
        local text = files.text(path)
        now[path] = text and core.fingerprint(text) or false
      end
      if now[path] ~= one[2] then return false, path end
    end
    return true
  end
end

return files
