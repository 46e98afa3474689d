-- Settings in words: "dt 1 ms with two elements, asi-gauss"; times and errors as an engineer writes them.
local ladder = require "hinge.cost.ladder"

local words = {}
local prefixes = { { 1, "" }, { 1e-3, "m" }, { 1e-6, "u" }, { 1e-9, "n" } }
local counts = { "one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten", "eleven", "twelve" }

local function rounded(number, digits) return ("%%.%dg"):format(digits):format(number) end

--- Seconds with the prefix that leaves a number of at least 1: "10 us", "2.5 ms", "4 s".
function words.seconds(value, digits)
  if value == 0 then return "0 s" end
  for _, p in ipairs(prefixes) do
    -- what rounds up to 1000 of a prefix is 1 of the next one
    local shown = tonumber(rounded(value / p[1], digits or 4))
    if math.abs(shown) >= 1 or p[2] == "n" then
      return (math.abs(shown) < 1e4 and "%.6g %ss" or "%.0f %ss"):format(shown, p[2])
    end
  end
end

--- A part as a percentage, rounded up so that it stays a bound, to two digits, or three if two would add more than a
--- twentieth: "3 %", "0.17 %", "1.01 %".
function words.bound(part)
  if part == 0 then return "0 %" end
  local unit = 10.0 ^ (math.floor(math.log(100 * part, 10)) - 1)
  local function up(by) return math.ceil(100 * part / by - 1e-9) * by end
  return ("%.6g %%"):format(up(unit) <= 105 * part and up(unit) or up(unit / 10))
end

--- The value of a input: "10 us" for a time step, "1e-8" for a small number.
function words.value(name, value)
  if name == "dt" and type(value) == "number" then return words.seconds(value) end
  return (ladder.text(value):gsub("e([+-])0+", "e%1"):gsub("e%+", "e"))
end

local function is_elements(name) return name == "elements_per_member" or name == "elements" end

--- The words among the values of a setting, and numbers without a finer side: "asi-gauss, explicit"; "" if none varies.
function words.method(inputs, values)
  local parts = {}
  for _, input in ipairs(inputs) do
    local value = values[input.name]
    if not input.side then
      parts[#parts + 1] = (type(value) == "string" and "" or input.name .. " ") .. words.value(input.name, value)
    end
  end
  return table.concat(parts, ", ")
end

--- What tells a setting from the others, for a label in a picture: "dt 10 us", "10 us, 4 elements". `inputs`: those to
--- name.
function words.label(inputs, values)
  local parts, alone = {}, #inputs == 1
  for _, input in ipairs(inputs) do
    local name, value = input.name, values[input.name]
    local text = words.value(name, value)
    parts[#parts + 1] = value ~= nil and (is_elements(name) and text .. (value == 1 and " element" or " elements")
      or name == "steps" and text .. " steps"
      or (type(value) == "string" or name == "dt" and not alone) and text or name .. " " .. text) or nil
  end
  return table.concat(parts, ", ")
end

--- A setting in a sentence: "dt 1 ms with two elements, asi-gauss".
function words.setting(inputs, values)
  local numbers, others, elements = {}, {}, nil
  for _, input in ipairs(inputs) do
    local name, value = input.name, values[input.name]
    if value ~= nil and is_elements(name) then
      elements = ("%s element%s"):format(counts[value] or tostring(value), value == 1 and "" or "s")
    elseif type(value) == "string" then
      others[#others + 1] = value
    elseif value ~= nil then -- nil: it changes nothing, see alike.lua
      local text = words.value(name, value)
      numbers[#numbers + 1] = name == "steps" and text .. " steps" or name .. " " .. text
    end
  end
  local text = table.concat(numbers, ", ")
  if elements then text = text == "" and elements or text .. " with " .. elements end
  if #others > 0 then text = (text == "" and "" or text .. ", ") .. table.concat(others, ", ") end
  return text
end

--- Names as "a", "a and b", "a, b and c"; with more than `most` of them "a, b and 3 more".
function words.list(names, most)
  local n = #names
  if n <= 1 then return names[1] or "" end
  if most and n > most then
    return ("%s and %d more"):format(table.concat(names, ", ", 1, most), n - most)
  end
  return ("%s and %s"):format(table.concat(names, ", ", 1, n - 1), names[n])
end

return words
