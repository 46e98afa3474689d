-- The lines of a text file of ETABS by section, and their words as keys and values.
local notes = require "hinge.import.notes"

local lines = {}

local where = "hinge.import.e2k"

-- The words of a line; those in quotes without them.
local function words_of(place, line)
  local words, at = {}, 1
  while true do
    at = line:find("%S", at)
    if not at then return words end
    if line:sub(at, at) == '"' then
      local stop = line:find('"', at + 1, true)
      if not stop then notes.fail(where, place, "the quotes are not closed: %s", line) end
      words[#words + 1], at = line:sub(at + 1, stop - 1), stop + 1
    else
      local word, stop = line:match("^(%S+)()", at)
      words[#words + 1], at = word, stop
    end
  end
end

-- Whether a word in quotes goes on in the next line. It ends at the latest before the next section.
local function is_open(text)
  return text:gsub('"[^"]*"', " "):find '%f[%S]"' ~= nil or text:find "\n%s*%$ " ~= nil
end

--- The sections of the file by name: { title =, place =, lines = { { place =, text =, words = } } }, and in their
-- order.
function lines.sections_of(path)
  local sections, others, current = {}, {}, nil
  for number, text in notes.lines(notes.read(where, path), is_open) do
    local place = { file = path, line = number }
    local name = text:match "^%s*%$%s*(.-)%s*$"
    if name then
      name = name:upper()
      if name:find "^END OF MODEL" then break end
      current = sections[name]
      if not current and not name:find "^FILE " then
        current = { name = name, title = "$ " .. name, place = place, lines = {} }
        sections[name], sections[#sections + 1] = current, current
      end
    elseif text:find "%S" and current then
      table.insert(current.lines, { place = place, text = text, words = words_of(place, text) })
    elseif text:find "%S" then
      others[#others + 1] = { place = place, line = text }
    end
  end
  return sections, others
end

--- The pairs of a key and a value behind the first words of a line, by key.
function lines.pairs_after(line, first)
  local found = {}
  for i = first, #line.words, 2 do
    local key, value = line.words[i]:upper(), line.words[i + 1]
    if value == nil then notes.fail(where, line.place, "%s has no value", key) end
    found[key] = value
  end
  return found
end

--- A word as a number.
function lines.number_of(line, word, what)
  local x = tonumber(word)
  if not x or x ~= x or math.abs(x) == math.huge then
    notes.fail(where, line.place, "%s is '%s'; must be a number", what, tostring(word))
  end
  return x
end

--- Raises an error unless these keys of a line are numbers, where they are there.
function lines.must_be_numbers(line, given, keys)
  for key in keys:gmatch "%S+" do
    if given[key] then lines.number_of(line, given[key], key) end
  end
end

--- The words of a text as keys.
function lines.set(text)
  local names = {}
  for name in text:gmatch "%S+" do names[name] = true end
  return names
end

return lines
