-- A plot as bytes, for the process that draws for a script in the sandbox: nil, true, false, numbers, texts and tables
-- of these. What is read back has no functions, no metatables and no cycles.
local data = {}
local deepest = 16

local function pack(value, parts, depth)
  local kind = math.type(value) or type(value)
  if kind == "nil" then parts[#parts + 1] = "n"
  elseif kind == "boolean" then parts[#parts + 1] = value and "t" or "f"
  elseif kind == "integer" then parts[#parts + 1] = string.pack("<c1i8", "i", value)
  elseif kind == "float" then parts[#parts + 1] = string.pack("<c1d", "d", value)
  elseif kind == "string" then parts[#parts + 1] = string.pack("<c1s8", "s", value)
  elseif kind == "table" and depth < deepest then
    local count, at = 0, #parts + 1
    parts[at] = ""
    for key, item in next, value do
      pack(key, parts, depth + 1)
      pack(item, parts, depth + 1)
      count = count + 1
    end
    parts[at] = string.pack("<c1i8", "m", count)
  else error(("a plot cannot hold a %s at depth %d"):format(kind, depth)) end
end

local function unpack(bytes, at, depth)
  assert(depth <= deepest, "a plot is nested too deeply")
  local kind = bytes:sub(at, at)
  at = at + 1
  if kind == "n" then return nil, at end
  if kind == "t" or kind == "f" then return kind == "t", at end
  local formats = { i = "<i8", d = "<d", s = "<s8" }
  if formats[kind] then return string.unpack(formats[kind], bytes, at) end
  assert(kind == "m", "the bytes of a plot are not valid")
  local map, count, next_at = {}, string.unpack("<i8", bytes, at)
  for _ = 1, count do
    local key, after_key = unpack(bytes, next_at, depth + 1)
    map[key], next_at = unpack(bytes, after_key, depth + 1)
  end
  return map, next_at
end

--- The bytes of a plot of hinge.plot.read.
function data.pack(plot)
  local parts = {}
  pack(plot, parts, 0)
  return table.concat(parts)
end

--- The plot in these bytes.
function data.unpack(bytes) return (unpack(bytes, 1, 0)) end

return data
