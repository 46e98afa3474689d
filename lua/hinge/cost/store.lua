-- Measurements that are kept between calls: finished.lua in the output folder, one line each.
local core = require "hinge.core"
local quote = require "hinge.library.quote"
local check = require "hinge.library.check"

local store = {}
local Store = {}
Store.__index = Store

local function text(value)
  if type(value) == "string" then return quote.lua(value) end
  if math.type(value) == "float" then
    if value ~= value or math.abs(value) == math.huge then
      return value ~= value and "0/0" or value > 0 and "1/0" or "-1/0"
    end
    return ("%.17g"):format(value)
  end
  if type(value) ~= "table" then return tostring(value) end
  local names, parts = {}, {}
  for i, v in ipairs(value) do parts[i] = text(v) end
  local listed = #parts -- and not #value, which may lie beyond a gap
  for key in pairs(value) do
    if math.type(key) ~= "integer" or key < 1 or key > listed then names[#names + 1] = key end
  end
  table.sort(names, function(a, b) return tostring(a) < tostring(b) end)
  for _, key in ipairs(names) do parts[#parts + 1] = "[" .. text(key) .. "]=" .. text(value[key]) end
  return "{" .. table.concat(parts, ",") .. "}"
end

-- changed: by key, the file because of which a measurement does not count any more.
local function say_changed(changed)
  local counts = {}
  for _, file in pairs(changed) do counts[file] = (counts[file] or 0) + 1 end
  for _, file in ipairs(check.keys(counts)) do
    local n = counts[file]
    io.stderr:write(("%s has changed: %s made again\n"):format(file, n == 1 and "1 measurement is"
      or n .. " measurements are"))
  end
end

--- folder: nil keeps nothing. `run`: the scenario's function, or the path of a script. If its file can be read, the
-- content of the file is part of every key. A measurement counts as long as all files are as they were that the script
-- had read up to then.
function store.open(folder, run)
  local self = setmetatable({ lines = {}, path = folder and folder .. "/finished.lua" }, Store)
  if not self.path then return self end -- as in the sandbox, which has no place for these files
  local files = require "hinge.study.files"
  core.lock(folder)
  self.folder = core.whole_path(folder)
  local same, changed = files.comparison(), {}
  local source = type(run) == "string" and "@" .. run or debug.getinfo(run, "S").source
  local content = source:sub(1, 1) == "@" and files.text(source:sub(2)) or source
  self.mark = core.version .. " " .. core.fingerprint(content)
  for line in (files.text(self.path) or ""):gmatch "[^\n]+" do
    local f = load("return " .. line, "finished", "t", {})
    local ok, entry = pcall(f or error)
    if ok and type(entry) == "table" and entry.mark == self.mark then
      local holds, file = same(entry.files or {})
      self.lines[entry.key] = holds and entry.record or nil
      changed[entry.key] = not holds and file or nil
    end
  end
  say_changed(changed)
  return self
end

--- The key of a run: its parameters and all else that changes its result, such as the small change of its numbers.
function store.key(parameters, more) return text(parameters) .. (more or "") end

function Store:get(key) return self.lines[key] end

--- Keeps a measurement; a later one of the same key takes its place.
function Store:put(key, record)
  self.lines[key] = record
  -- also after a line that was cut short
  if self.path then
    core.append(self.path, "\n" .. text { key = key, mark = self.mark, record = record,
      files = require "hinge.study.files".read(self.folder) })
  end
end

return store
