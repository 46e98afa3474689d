-- Values as readable text: tables by their fields, on one line if they fit; objects by tostring.
local width, most, deepest = 100, 40, 6 -- columns; items of one table; tables within tables

local reserved = {}
local words = "and break do else elseif end false for function goto if in local nil not or repeat return then true "
  .. "until while"
for word in words:gmatch "%a+" do reserved[word] = true end

local function before(a, b)
  if type(a) == type(b) and (type(a) == "number" or type(a) == "string") then return a < b end
  return type(a) == "number" and type(b) ~= "number" or type(a) < type(b)
end

local readable

local function key_text(key, outer)
  if type(key) == "string" and key:find "^[%a_][%w_]*$" and not reserved[key] then return key end
  return "[" .. readable(key, "", outer) .. "]"
end

-- `indent`: what the lines of a table begin with; `outer`: the tables that this one stands in.
function readable(value, indent, outer)
  if type(value) == "string" then return ("%q"):format(value):gsub("\\\n", "\\n") .. "" end
  local meta = type(value) == "table" and debug.getmetatable(value)
  if type(value) ~= "table" or meta and (meta.__tostring or meta.__name) then return tostring(value) end
  if meta and meta.__pairs then pairs(value) end -- a list that is filled only then
  if outer[value] or #outer >= deepest then return "{...}" end
  outer[#outer + 1], outer[value] = value, true
  local items, total, keys = {}, 0, {}
  local inner = indent .. "  "
  for i = 1, rawlen(value) do
    total = total + 1
    if total <= most then items[total] = readable(rawget(value, i), inner, outer) end
  end
  for key in next, value do
    if not (math.type(key) == "integer" and key >= 1 and key <= rawlen(value)) then keys[#keys + 1] = key end
  end
  table.sort(keys, before)
  for _, key in ipairs(keys) do
    total = total + 1
    if total <= most then items[total] = key_text(key, outer) .. " = " .. readable(rawget(value, key), inner, outer) end
  end
  if total > most then items[most + 1] = ("... %d more"):format(total - most) end
  outer[#outer], outer[value] = nil, nil
  local line = "{ " .. table.concat(items, ", ") .. " }"
  if total == 0 then return "{}" end
  if #indent + #line <= width and not line:find "\n" then return line end
  return "{\n" .. inner .. table.concat(items, ",\n" .. inner) .. "\n" .. indent .. "}"
end

--- The values as one text, with tabs between them. Strings stand as they are; inside tables they have quotes.
return function(...)
  local texts = table.pack(...)
  for i = 1, texts.n do
    texts[i] = type(texts[i]) == "string" and texts[i] or readable(texts[i], "", {})
  end
  return table.concat(texts, "\t", 1, texts.n)
end
