-- Values written as text on a command line: numbers and sums such as 440/3.6, true or false, lists in braces, strings,
-- numbers with a unit.
local check = require "hinge.library.check"

local values = {}

local literals = { "^%d+%.?%d*[eE][+-]?%d+", "^%.%d+[eE][+-]?%d+", "^%d+%.?%d*", "^%.%d+" }

--- The value of an arithmetic expression (+ - * / ^ and brackets, pi), or nil. Precedence is Lua's.
function values.number(text)
  local at, sum = 1, nil

  local function accept(pattern)
    local first, last = text:find("^%s*" .. pattern, at)
    if first then
      at = last + 1
      return text:sub(first, last):match("%S+")
    end
  end

  local function primary()
    if accept("%(") then
      local inner = sum()
      return inner and accept("%)") and inner
    end
    if accept("pi%f[%W]") then return math.pi end
    at = text:find("%S", at) or at
    for _, literal in ipairs(literals) do
      local first, last = text:sub(at):find(literal)
      if first then
        at = at + last
        return tonumber(text:sub(at - last, at - 1))
      end
    end
  end

  local function signed()
    if accept("%-") then
      local inner = signed()
      return inner and -inner
    end
    local base = primary()
    if not (base and accept("%^")) then return base end
    local exponent = signed()
    return exponent and base ^ exponent
  end

  local function chain(operand, operators)
    return function()
      local left = operand()
      while left do
        local operator = accept(operators)
        if not operator then return left end
        local right = operand()
        if not right then return nil end
        if operator == "+" then left = left + right
        elseif operator == "-" then left = left - right
        elseif operator == "*" then left = left * right
        else left = left / right end
      end
    end
  end

  sum = chain(chain(signed, "[*/]"), "[+-]")
  local result = sum()
  if not result or text:find("%S", at) then return nil end
  return result == result and math.abs(result) < math.huge and result or nil
end

local function list(text)
  local inside = text:match("^%s*{(.*)}%s*$")
  if not inside then return nil end
  local result = {}
  if not inside:find "%S" then return result end
  for item in (inside:gsub(",%s*$", "") .. ","):gmatch "([^,]*)," do -- a comma may stand at the end, as in Lua
    result[#result + 1] = values.number(item)
    if not result[#result] then return nil end
  end
  return result
end

--- The items of a text with commas between them, each of which must hold something. `whole`: for the message.
function values.items(text, whole)
  for item in (text .. ","):gmatch "([^,]*)," do
    if not item:find "%S" then
      check.fail("%s: a value is missing at a comma; write it, or leave the comma out", whole)
    end
  end
  return text:gmatch "[^,]+"
end

--- Names between commas as a list; nil for nil. `option`: of the command line.
function values.names(option, text)
  if not text then return nil end
  local names = {}
  for name in values.items(text, option .. " " .. text) do names[#names + 1] = name:match "^%s*(.-)%s*$" end
  return names
end

--- Text as a value of the same type as `default`. Returns nil and what would be allowed when it cannot be one.
function values.like(text, default)
  local kind = type(default)
  if kind == "string" then return text end
  if kind == "boolean" then
    if text == "true" or text == "false" then return text == "true" end
    return nil, "true or false"
  end
  if kind == "table" then
    local result = list(text)
    return result, not result and "numbers in braces, such as {4, 4}" or nil
  end
  if kind ~= "number" then return nil, "set in the script only" end
  local result = values.number(text)
  if not result then return nil, "a number in SI units or a sum such as 440/3.6" end
  return math.type(default) == "integer" and math.tointeger(result) or result
end

--- Text as whatever it looks like: for scripts that do not say which parameters they have.
function values.guess(text)
  if text == "true" or text == "false" then return text == "true" end
  return list(text) or values.number(text) or text
end

--- The value of an option such as 60s, 500M or 1%, which must be above 0; nil without a text. units: what a number is
-- multiplied by, by what stands behind it; allowed: for the message.
function values.quantity(option, text, units, allowed)
  if not text then return nil end
  local number, unit = text:match "^%s*([%d.eE+-]+)%s*(%%?%a*)%s*$"
  number = number and values.number(number)
  if not number or not units[unit] or number <= 0 then check.fail("%s %s: must be %s", option, text, allowed) end
  return number * units[unit]
end

--- An accuracy: a part of an answer, below 1.
function values.accuracy(option, text)
  local allowed = "a part above 0 and below 1, such as 2% or 0.02"
  local part = values.quantity(option, text, { [""] = 1, ["%"] = 0.01 }, allowed)
  if part and part >= 1 then check.fail("%s %s: must be %s", option, text, allowed) end
  return part
end

--- The seconds of an option.
function values.time(option, text)
  return values.quantity(option, text, { [""] = 1, s = 1, min = 60, h = 3600 },
    "a time above 0, such as 60s, 5min or 1h")
end

--- The whole number of an option, which must be at least `least`; nil without a text.
function values.whole(option, text, least)
  local number = text and math.tointeger(tonumber(text))
  if text and (not number or number < least) then
    check.fail("%s %s: must be a whole number of at least %d", option, text, least)
  end
  return number
end

--- A line of CSV as fields, texts without the blanks around them; quotes as RFC 4180 has them.
function values.csv_fields(line)
  local found, at = {}, 1
  repeat
    local quoted, stop = line:match('^%s*"(.-)"%s*()', at)
    if quoted then
      while line:sub(stop, stop) == '"' do
        local more, next_stop = line:match('^"(.-)"%s*()', stop)
        if not more then break end
        quoted, stop = quoted .. '"' .. more, next_stop
      end
      found[#found + 1] = quoted
    else
      local text
      text, stop = line:match("^([^,]*)()", at)
      found[#found + 1] = text:match "^%s*(.-)%s*$"
    end
    at = stop + 1
  until line:sub(stop, stop) ~= ","
  return found
end

return values
