-- Measurements that are kept between calls: finished.lua in the output folder, one line each.
local core = require "hinge.core"
local quote = require "hinge.quote"

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
  for key in pairs(value) do
    if math.type(key) ~= "integer" or key < 1 or key > #value then names[#names + 1] = key end
  end
  table.sort(names, function(a, b) return tostring(a) < tostring(b) end)
  for _, key in ipairs(names) do parts[#parts + 1] = "[" .. text(key) .. "]=" .. text(value[key]) end
  return "{" .. table.concat(parts, ",") .. "}"
end

local function read(path)
  local file = io.open(path, "rb")
  if not file then return nil end
  local content = file:read "a"
  file:close()
  return content
end

--- folder: nil keeps nothing. `run`: the scenario's function. If its file can be read, the content of the file is part
-- of every key.
function store.open(folder, run)
  local self = setmetatable({ lines = {}, path = folder and folder .. "/finished.lua" }, Store)
  if not self.path then return self end
  core.lock(folder)
  local source = debug.getinfo(run, "S").source
  local content = source:sub(1, 1) == "@" and read(source:sub(2)) or source
  self.mark = core.version .. " " .. core.fingerprint(content)
  for line in (read(self.path) or ""):gmatch "[^\n]+" do
    local f = load("return " .. line, "finished", "t", {})
    local ok, entry = pcall(f or error)
    if ok and type(entry) == "table" and entry.mark == self.mark then self.lines[entry.key] = entry.record end
  end
  return self
end

--- The key of a run: its parameters and all else that changes its result, such as the small change of its numbers.
function store.key(parameters, more) return text(parameters) .. (more or "") end

function Store:get(key) return self.lines[key] end

--- Keeps a measurement; a later one of the same key takes its place.
function Store:put(key, record)
  self.lines[key] = record
  -- also after a line that was cut short
  if self.path then core.append(self.path, "\n" .. text { key = key, mark = self.mark, record = record }) end
end

return store
