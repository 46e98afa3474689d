-- What a reader of files has to say: the notes of what it could not read, and errors with file and line.
local check = require "hinge.library.check"
local core = require "hinge.core"

local notes = {}

local Notes = { __name = "hinge.import_notes" }
local widest = 90 -- characters of a line of the file that a note shows

local function short(text)
  text = text:gsub("%s+", " "):gsub("^ ", ""):gsub(" $", "")
  return #text <= widest and text or text:sub(1, widest - 3) .. "..."
end

--- Notes without an entry.
function notes.new() return setmetatable({ assumed = {}, skipped = {}, summary = {} }, Notes) end

local known = setmetatable({}, { __mode = "k" }) -- the entries of a list, by what makes them the same

-- Adds an entry, or counts one more where one of this key is there.
local function add(list, place, text, reason, key)
  known[list] = known[list] or {}
  local entry = known[list][key]
  if entry then
    entry.count, entry.lines = (entry.count or 1) + 1, entry.lines or { entry.line }
    if place.line then table.insert(entry.lines, place.line) end
    return
  end
  entry = { file = place.file, line = place.line, text = short(text), reason = reason }
  list[#list + 1], known[list][key] = entry, entry
end

--- Adds an entry to the notes themselves, to notes.assumed or to notes.skipped. `place`: { file =, line = }. A line
--- that is run again, in a loop of the file, is counted.
function notes.add(list, place, text, reason)
  add(list, place, text, reason, ("%s:%s:%s:%s"):format(place.file, place.line, reason, text))
end

--- Adds an entry to a list once for each kind, by default the reason; later ones are counted, and entry.lines has all.
function notes.once(list, place, text, reason, kind) add(list, place, text, reason, kind or reason) end

--- How many places of the file a list is about.
function notes.count(list)
  local count = 0
  for _, entry in ipairs(list) do count = count + (entry.count or 1) end
  return count
end

local function line_of(entry)
  local place = entry.line and ("%s:%d"):format(entry.file, entry.line) or entry.file
  local more = entry.count and (" (and %d more like it)"):format(entry.count - 1) or ""
  return ("  %s: %s%s%s"):format(place, entry.text, entry.reason and ": " .. entry.reason or "", more)
end

local function section(lines, title, list)
  if #list == 0 then return end
  lines[#lines + 1] = ("%s (%d):"):format(title, notes.count(list))
  for _, entry in ipairs(list) do lines[#lines + 1] = line_of(entry) end
end

-- The summary in one sentence, then what was not read, what was assumed, and what is no part of a frame.
function Notes:__tostring()
  local s, count = self.summary, check.count
  local lines = {}
  if s.nodes then
    lines[1] = ("%s: %s, %s of %.6g m, %s, %s, %s, %s"):format(s.file, count(s.nodes, "node"),
      count(s.members, "member"), s.length, count(s.sections, "section"), count(s.materials, "material"),
      count(s.cases, "load case"), count(s.loads, "load"))
    lines[2] = ("  mass of the members %.6g kg, point masses %.6g kg"):format(s.mass_of_members, s.mass_of_nodes)
    if s.slabs then lines[2] = ("%s, slabs of %.6g m^2 %.6g kg"):format(lines[2], s.area_of_slabs, s.mass_of_slabs) end
  end
  section(lines, "not read", self)
  section(lines, "assumed", self.assumed)
  section(lines, "no part of a frame", self.skipped)
  return table.concat(lines, "\n")
end

--- Sorts all entries by file and line, in the order of the files.
function notes.sort(all)
  for _, list in ipairs { all, all.assumed, all.skipped } do
    local order, count = {}, 0
    for i, entry in ipairs(list) do
      if not order[entry.file] then order[entry.file], count = count, count + 1 end
      entry.at = i
    end
    table.sort(list, function(a, b)
      if a.file ~= b.file then return order[a.file] < order[b.file] end
      local x, y = a.line or 0, b.line or 0
      return x < y or x == y and a.at < b.at
    end)
    for _, entry in ipairs(list) do entry.at = nil end
  end
end

--- Whether a name begins with one of these.
function notes.begins_with(name, beginnings)
  for _, beginning in ipairs(beginnings) do
    if name:sub(1, #beginning) == beginning then return true end
  end
  return false
end

--- An error in a file: "hinge.import.s2k: frame.s2k:12: ...".
function notes.fail(where, place, format, ...)
  local what = select("#", ...) > 0 and format:format(...) or format
  check.fail("%s: %s:%d: %s", where, place.file, place.line, what)
end

notes.most_seconds = 60 -- s of the processor
notes.most_memory = 1000 -- MB
local most_file = 500 -- MB

--- The bytes of a file. Devices and pipes, which have no end, and files of more than 500 MB are refused.
function notes.text_of(where, path)
  if core.sandboxed() then check.fail("%s: a script in the sandbox reads no files", where) end
  local size = core.file_size(path)
  if size and size > most_file * 1e6 then
    check.fail("%s: the file '%s' has %.0f MB, and more than %d MB are not read", where, path, size / 1e6, most_file)
  end
  local text, problem = core.read_text(path)
  if not text then check.fail("%s: %s", where, problem) end
  return text
end

-- Ends what takes too much: called now and then while a file is read.
local function watch(where, path, began, before)
  if os.clock() - began > notes.most_seconds then
    check.fail("%s: reading '%s' takes more than %g s; does a loop in it have no end?", where, path, notes.most_seconds)
  end
  if collectgarbage "count" - before > notes.most_memory * 1000 then
    collectgarbage()
    if collectgarbage "count" - before > notes.most_memory * 1000 then
      check.fail("%s: reading '%s' takes more than %g MB of memory; does a value in it grow without bound?", where,
        path, notes.most_memory)
    end
  end
end

--- f() within limits of time, memory and depth, of which a message tells. A script that has set a hook of its own, or
--- runs in the sandbox, has its own limits.
function notes.within_limits(where, path, f)
  local free = not core.sandboxed() and debug.gethook() == nil
  collectgarbage() -- or what is left of others would count
  local began, before = os.clock(), collectgarbage "count"
  if free then debug.sethook(function() watch(where, path, began, before) end, "", 10000) end
  local good, result, more = pcall(f)
  if free then debug.sethook() end
  if good then return result, more end
  local text = type(result) == "string" and not core.error_kind(result) and result or ""
  if text:find "stack overflow" then
    check.fail("%s: brackets, braces or lists in '%s' are nested too deeply; a hundred levels are read", where, path)
  end
  if text:find "not enough memory" then check.fail("%s: there is not enough memory to read '%s'", where, path) end
  error(result, 0)
end

--- The whole text of a file, with line ends of one kind and without the mark of UTF-8.
function notes.read(where, path)
  local text = notes.text_of(where, path)
  return (text:gsub("^\239\187\191", ""):gsub("\r\n?", "\n"))
end

local most_joined = 1000 -- lines of one value in quotes

--- The lines of a text, each with its number: for number, line in notes.lines(text) do ... end. Where is_open(line) is
--- true, the lines that follow belong to it, and the number is that of the first. At the end of the text, or after 1000
--- lines, it is a line by itself.
function notes.lines(text, is_open)
  local at, number = 1, 0
  local function line_at(from)
    local stop = text:find("\n", from, true) or #text + 1
    return text:sub(from, stop - 1), stop + 1
  end
  return function()
    if at > #text then return nil end
    local line, after = line_at(at)
    local joined, next_at, count = line, after, 1
    while is_open and is_open(joined) and next_at <= #text and count < most_joined do
      local more
      more, next_at = line_at(next_at)
      joined, count = joined .. "\n" .. more, count + 1
    end
    local first = number + 1
    if count > 1 and not is_open(joined) then
      at, number = next_at, number + count
      return first, joined
    end
    at, number = after, first
    return first, line
  end
end

return notes
