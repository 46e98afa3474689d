-- expr of Tcl: numbers, variables, [commands], arithmetic, comparisons, && || ! ?:, and the usual functions. Whole
-- numbers stay whole: 1 / 2 is 0, as in Tcl.

local expression = {}

local function beyond(format, ...) error({ beyond = format:format(...) }, 0) end
expression.beyond = beyond

--- A number as Tcl writes it.
function expression.text(value)
  if type(value) ~= "number" then return value end
  if math.type(value) == "integer" then return ("%d"):format(value) end
  if value ~= value or math.abs(value) == math.huge then beyond "a result is not a finite number" end
  local text = ("%.17g"):format(value)
  return text:find "[.eE]" and text or text .. ".0"
end

-- A text as a number; 010 is 8 in some versions of Tcl and 10 in others.
local function number_of(text)
  if text:find "^%s*[+-]?0%d+%s*$" then beyond("%s begins with 0: 8 to some versions of Tcl, 10 to others", text) end
  return text:find "^%s*[+-]?%.?%d" and tonumber(text) or nil
end

local function number(value)
  if type(value) == "number" then return value end
  return number_of(value) or beyond("'%s' is not a number", value)
end

local function truth(value)
  if value == "true" or value == "yes" then return true end
  if value == "false" or value == "no" then return false end
  return number(value) ~= 0
end

local function flag(condition) return condition and 1 or 0 end

local function divide(a, b)
  if b == 0 then beyond "a division by 0" end
  return math.type(a) == "integer" and math.type(b) == "integer" and a // b or a / b
end

local function power(a, b)
  local result = a ^ b
  local whole = math.type(a) == "integer" and math.type(b) == "integer" and math.abs(result) < 2 ^ 53
  return whole and math.tointeger(result) or result
end

-- Both as numbers where they are numbers, else as texts.
local function pair(a, b)
  local x, y = tonumber(a), tonumber(b)
  if x and y then return x, y end
  return tostring(a), tostring(b)
end

-- By precedence: the lower, the weaker.
local binary = {
  ["||"] = { 1 }, ["&&"] = { 2 },
  ["=="] = { 3, function(a, b) a, b = pair(a, b) return flag(a == b) end },
  ["!="] = { 3, function(a, b) a, b = pair(a, b) return flag(a ~= b) end },
  eq = { 3, function(a, b) return flag(expression.text(a) == expression.text(b)) end },
  ne = { 3, function(a, b) return flag(expression.text(a) ~= expression.text(b)) end },
  ["<"] = { 4, function(a, b) return flag(number(a) < number(b)) end },
  [">"] = { 4, function(a, b) return flag(number(a) > number(b)) end },
  ["<="] = { 4, function(a, b) return flag(number(a) <= number(b)) end },
  [">="] = { 4, function(a, b) return flag(number(a) >= number(b)) end },
  ["+"] = { 5, function(a, b) return number(a) + number(b) end },
  ["-"] = { 5, function(a, b) return number(a) - number(b) end },
  ["*"] = { 6, function(a, b) return number(a) * number(b) end },
  ["/"] = { 6, function(a, b) return divide(number(a), number(b)) end },
  ["%"] = { 6, function(a, b) if number(b) == 0 then beyond "a division by 0" end return number(a) % number(b) end },
  ["**"] = { 8, function(a, b) return power(number(a), number(b)) end, right = true },
}

local function away_from_zero(x) return math.tointeger(x < 0 and math.ceil(x - 0.5) or math.floor(x + 0.5)) end
local functions = {
  sqrt = math.sqrt, sin = math.sin, cos = math.cos, tan = math.tan, asin = math.asin, acos = math.acos,
  atan = function(x) return math.atan(x) end, atan2 = function(y, x) return math.atan(y, x) end, exp = math.exp,
  log = function(x) return math.log(x) end, log10 = function(x) return math.log(x, 10) end, abs = math.abs,
  pow = function(a, b) return (a + 0.0) ^ b end, hypot = function(a, b) return math.sqrt(a * a + b * b) end,
  int = function(x) return math.tointeger(x < 0 and math.ceil(x) or math.floor(x)) end, round = away_from_zero,
  double = function(x) return x + 0.0 end, floor = function(x) return math.floor(x) + 0.0 end,
  ceil = function(x) return math.ceil(x) + 0.0 end, min = math.min, max = math.max,
  fmod = function(a, b) return math.fmod(a + 0.0, b) end,
}
functions.wide, functions.entier = functions.int, functions.int

local Parser = {}
Parser.__index = Parser

function Parser:accept(pattern)
  local found, after = self.text:match("^%s*(" .. pattern .. ")()", self.at)
  if found then self.at = after end
  return found
end

function Parser:operator()
  local found = self.text:match("^%s*([|&=!<>*][|&=*])", self.at)
    or self.text:match("^%s*([<>+*/%%%-])", self.at) or self.text:match("^%s*(%a%a)%f[^%w]", self.at)
  return binary[found or ""] and found or nil
end

function Parser:call(name)
  local arguments = {}
  if not self:accept "%)" then
    repeat arguments[#arguments + 1] = number(self:choice()) until not self:accept ","
    if not self:accept "%)" then beyond("in '%s' a bracket is not closed", self.text) end
  end
  if not functions[name] then beyond("the function %s is not followed", name) end
  local good, value = pcall(functions[name], table.unpack(arguments))
  if not good or value == nil then beyond("the function %s cannot take its arguments", name) end
  return value
end

function Parser:primary()
  if self:accept "%(" then
    local inner = self:choice()
    if not self:accept "%)" then beyond("in '%s' a bracket is not closed", self.text) end
    return inner
  end
  local sign = self:accept "[-+!]"
  if sign then
    local value = self:primary()
    if sign == "!" then return flag(not truth(value)) end
    return sign == "-" and -number(value) or number(value)
  end
  local start = self.text:match("^%s*()", self.at)
  if self.text:find('^[$%["]', start) then
    local value
    value, self.at = self.substitute(self.text, start)
    return number_of(value) or value
  end
  local name = self:accept "%a[%w_]*"
  if name then
    if self:accept "%(" then return self:call(name) end
    return name
  end
  for _, pattern in ipairs { "0[xX]%x+", "%d+%.?%d*[eE][+-]?%d+", "%.%d+[eE][+-]?%d+", "%d+%.?%d*", "%.%d+" } do
    local literal = self:accept(pattern)
    if literal then return number_of(literal) end
  end
  beyond("'%s' is not arithmetic that is followed", self.text)
end

-- Operators of at least this precedence. What && and || do not need is computed too.
function Parser:chain(least)
  local left = self:primary()
  while true do
    local name = self:operator()
    local operator = name and binary[name]
    if not operator or operator[1] < least then return left end
    self.at = self.text:match("^%s*()", self.at) + #name
    local right = self:chain(operator.right and operator[1] or operator[1] + 1)
    if name == "||" then left = flag(truth(left) or truth(right))
    elseif name == "&&" then left = flag(truth(left) and truth(right))
    else left = operator[2](left, right) end
  end
end

function Parser:choice()
  local condition = self:chain(1)
  if not self:accept "%?" then return condition end
  local yes = self:choice()
  if not self:accept ":" then beyond("in '%s' a ? has no :", self.text) end
  local no = self:choice()
  return truth(condition) and yes or not truth(condition) and no
end

--- The value of an expression. substitute(text, at): the text that $name, [command] or "text" stands for, and the place
--- after it.
function expression.value(text, substitute)
  local parser = setmetatable({ text = text, at = 1, substitute = substitute }, Parser)
  local value = parser:choice()
  if parser.text:find("%S", parser.at) then beyond("'%s' is not arithmetic that is followed", text) end
  return value
end

expression.truth = truth

return expression
