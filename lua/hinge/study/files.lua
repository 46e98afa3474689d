-- Which files a script reads: itself, the modules it requires, what it loads, and data that it opens. A case's identity
-- holds what is in them, and so does a measurement of hinge cost. They are watched from the moment when the program
-- loads the script, or the script the library: what it reads at its top counts as much as what a case reads.
local core = require "hinge.core"
local check = require "hinge.library.check"

local files = {}
local fingerprint_of = {} -- by whole path, of what has been read or looked for
local written = {} -- by whole path, what the script itself has written: none of its inputs
local absent = "absent"
local own = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$"
local open = io.open

--- All of a file without noting that it was read, or nil: for what the study itself writes.
function files.text(path)
  local file = open(path, "rb")
  local text = file and file:read "a"
  if file then file:close() end
  return text
end

--- io.open without noting that the file is read.
files.open = open

-- The fingerprint of a file as it is now; `absent` also of what is no file, such as a pipe.
local function fingerprint(path)
  local text = core.read_text(path)
  return text and core.fingerprint(text) or absent
end

-- Whether a file is of the output folder of the run that is under way.
local function is_output(whole)
  local folder = core.out_dir()
  if folder == "." then return false end
  folder = core.whole_path(folder)
  return whole:sub(1, #folder) == folder and whole:find("^/", #folder + 1) ~= nil
end

--- Notes that a file is read, as it is at the first time, or that it was looked for and is not there: once it is, a
-- case may come out differently. The study's own modules say nothing about a case, nor does what the run or the script
-- has written itself.
function files.note(path)
  if type(path) ~= "string" then return end
  local whole = core.whole_path(path)
  if fingerprint_of[whole] or written[whole] or whole:sub(1, #own) == own or is_output(whole) then return end
  fingerprint_of[whole] = fingerprint(whole)
end

local function note_written(path)
  local whole = core.whole_path(path)
  written[whole] = true
  if fingerprint_of[whole] == absent then fingerprint_of[whole] = nil end
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

local watching = false

--- From now on what is read is noted, also in processes that are started from this one.
function files.watch()
  if watching then return end
  watching = true
  note_loaded()
  local note, loadfile, dofile, lines, input = files.note, loadfile, dofile, io.lines, io.input
  for _, i in ipairs { 2, 3 } do -- modules of Lua, and of C
    local search = package.searchers[i]
    package.searchers[i] = function(name)
      local loader, path = search(name)
      if type(loader) == "function" and is_of_script(name) then note(path) end
      return loader, path
    end
  end
  -- tail calls: the place in an error is the script's
  _G.loadfile = function(path, ...) note(path) return loadfile(path, ...) end
  _G.dofile = function(path, ...) note(path) return dofile(path, ...) end
  io.lines = function(path, ...) note(path) return lines(path, ...) end
  io.input = function(...) note((...)) return input(...) end
  io.open = function(path, mode, ...)
    if type(path) == "string" then
      if type(mode) == "string" and mode:find "^[wa]" then note_written(path)
      elseif mode ~= "r+" and mode ~= "r+b" then note(path) end
    end
    return open(path, mode, ...)
  end
end

--- { { path, fingerprint }, ... } of what has been read, but for what lies in a folder.
function files.read(without)
  local list = {}
  for _, path in ipairs(check.keys(fingerprint_of)) do
    if path:sub(1, #without + 1) ~= without .. "/" then list[#list + 1] = { path, fingerprint_of[path] } end
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
      now[path] = now[path] or fingerprint(path)
      if now[path] ~= one[2] then return false, path end
    end
    return true
  end
end

return files
