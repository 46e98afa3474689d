-- Follows an OpenSeesPy script: assignments, arithmetic, lists, tuples, dictionaries, for, while, if, list
-- comprehensions, range and the like, math. What it does not follow (functions, classes) is noted with its line.
local notes = require "hinge.import.notes"
local tokens_of = require "hinge.import.python_tokens"

local Script = {}
Script.__index = Script

local none = setmetatable({}, { __name = "None" })
local most_statements = 200000 -- of one script, so that an endless loop ends

local function beyond(format, ...) error({ beyond = format:format(...) }, 0) end

-- Values --------------------------------------------------------------------------------------------------------------
-- Lists, tuples and dictionaries are tables with a kind; a dictionary keeps its keys in `keys`.

local function sequence(kind, items)
  items.kind = kind
  return items
end

local function is_sequence(value) return type(value) == "table" and (value.kind == "list" or value.kind == "tuple") end

local function number(value)
  if value == true then return 1 elseif value == false then return 0 end
  return type(value) == "number" and value or beyond "a value is not a number"
end

local function truth(value)
  if type(value) == "number" then return value ~= 0 end
  if is_sequence(value) then return #value > 0 end
  return value ~= false and value ~= none and value ~= ""
end

-- A value as text: for the arguments of OpenSees, and as a key.
local function text_of(value)
  if type(value) == "string" then return value end
  if value == true or value == false then return value and "1" or "0" end
  if type(value) ~= "number" then beyond "an argument is neither a number nor a text" end
  return math.type(value) == "integer" and ("%d"):format(value) or ("%.17g"):format(value)
end

local function key_of(value)
  if not is_sequence(value) then
    local whole = type(value) == "number" and math.tointeger(value)
    return (type(value) == "string" and "s" or "n") .. (whole and ("%d"):format(whole) or text_of(value))
  end
  local parts = {}
  for i, inner in ipairs(value) do parts[i] = key_of(inner) end
  return "(" .. table.concat(parts, ",") .. ")"
end

local function equal(a, b)
  if is_sequence(a) and is_sequence(b) then return key_of(a) == key_of(b) end
  return a == b
end

local function items_of(value)
  if is_sequence(value) then return value end
  if type(value) == "table" and value.kind == "dict" then return value.keys end
  beyond "a loop goes over what is not followed"
end

local function element(value, index)
  if type(value) == "table" and value.kind == "dict" then
    local found = value.values[key_of(index)]
    if found == nil then beyond "a key is not in the dictionary" end
    return found
  end
  local i = is_sequence(value) and math.type(index) == "integer" and (index < 0 and #value + index or index)
  local found = i and value[i + 1]
  if found == nil then beyond "an index is not followed" end
  return found
end

local function put(value, index, new)
  if type(value) == "table" and value.kind == "dict" then
    local key = key_of(index)
    if value.values[key] == nil then table.insert(value.keys, index) end
    value.values[key] = new
  elseif is_sequence(value) and math.type(index) == "integer" then
    element(value, index) -- it must be there
    value[(index < 0 and #value + index or index) + 1] = new
  else
    beyond "an index is not followed"
  end
end

-- Functions of Python -------------------------------------------------------------------------------------------------

local functions = {}

function functions.range(a, b, step)
  local from, to, by = number(a), b and number(b), step and number(step) or 1
  if not to then from, to = 0, from end
  if by == 0 or math.type(from) ~= "integer" or math.type(to) ~= "integer" or math.type(by) ~= "integer" then
    beyond "range takes whole numbers"
  end
  local list = {}
  for i = from, by > 0 and to - 1 or to + 1, by do
    if #list >= most_statements then beyond "a range has more than 200000 numbers" end
    list[#list + 1] = i
  end
  return sequence("list", list)
end

function functions.enumerate(list, start)
  local out = {}
  for i, value in ipairs(items_of(list)) do out[i] = sequence("tuple", { i - 1 + (start or 0), value }) end
  return sequence("list", out)
end

function functions.zip(...)
  local lists, out, count = { ... }, {}, math.huge
  for i, list in ipairs(lists) do
    lists[i] = items_of(list)
    count = math.min(count, #lists[i])
  end
  for i = 1, #lists > 0 and count or 0 do
    out[i] = { kind = "tuple" }
    for k, list in ipairs(lists) do out[i][k] = list[i] end
  end
  return sequence("list", out)
end

local function copy(value)
  local items = items_of(value)
  return table.move(items, 1, #items, 1, {})
end

function functions.list(value) return sequence("list", value and copy(value) or {}) end
function functions.tuple(value) return sequence("tuple", value and copy(value) or {}) end
function functions.len(value) return type(value) == "string" and #value or #items_of(value) end
function functions.reversed(value)
  local out, items = {}, items_of(value)
  for i = #items, 1, -1 do out[#out + 1] = items[i] end
  return sequence("list", out)
end

functions["float"] = function(value) return (tonumber(value) or beyond "float cannot take its argument") + 0.0 end
functions["int"] = function(value)
  local x = tonumber(value) or beyond "int cannot take its argument"
  return math.tointeger(x < 0 and math.ceil(x) or math.floor(x)) or beyond "int cannot take its argument"
end
functions["str"] = text_of

function functions.abs(value) return math.abs(number(value)) end
function functions.round(value, digits)
  if digits then beyond "round with digits is not followed" end
  local x = number(value)
  local low = math.floor(x)
  local up = x - low > 0.5 or x - low == 0.5 and low % 2 == 1 -- a half goes to the even one
  return math.tointeger(up and low + 1 or low)
end

local function extreme(better)
  return function(...)
    local values = select("#", ...) == 1 and items_of((...)) or { ... }
    local best = number(values[1])
    for i = 2, #values do
      if better(number(values[i]), best) then best = values[i] end
    end
    return best
  end
end
functions.min = extreme(function(a, b) return a < b end)
functions.max = extreme(function(a, b) return a > b end)
function functions.sum(list)
  local total = 0
  for _, value in ipairs(items_of(list)) do total = total + number(value) end
  return total
end

-- What math and numpy have of this.
local maths = { pi = math.pi, e = math.exp(1) }
for name, f in pairs { sqrt = math.sqrt, sin = math.sin, cos = math.cos, tan = math.tan, asin = math.asin,
  acos = math.acos, exp = math.exp, radians = math.rad, degrees = math.deg, fabs = math.abs, deg2rad = math.rad,
  atan = function(x) return math.atan(x) end, atan2 = function(y, x) return math.atan(y, x) end,
  log = function(x, base) return math.log(x, base) end, floor = math.floor, ceil = math.ceil,
  pow = function(a, b) return (a + 0.0) ^ b end, hypot = function(a, b) return math.sqrt(a * a + b * b) end } do
  maths[name] = function(...)
    local values = { ... }
    for i, value in ipairs(values) do values[i] = number(value) end
    return f(table.unpack(values))
  end
end

-- Expressions ---------------------------------------------------------------------------------------------------------

function Script:is(value)
  local t = self.tokens[self.at]
  return t and t.value == value and (t.kind == "op" or t.kind == "name")
end

function Script:accept(value)
  if not self:is(value) then return false end
  self.at = self.at + 1
  return true
end

function Script:must(value)
  if not self:accept(value) then beyond("a '%s' is missing where the line is followed", value) end
end

-- What grows without bound is not followed.
local function refuse_long(count, most, what)
  if not (count <= most) then beyond("%s of more than %d is not followed", what, most) end
end

-- What one operator makes of two values.
local operate = {
  ["+"] = function(a, b)
    if type(a) == "string" and type(b) == "string" then
      refuse_long(#a + #b, notes.most_text, "a text")
      return a .. b
    end
    if is_sequence(a) and is_sequence(b) then
      refuse_long(#a + #b, notes.most_items, "a list")
      local out = table.move(a, 1, #a, 1, {})
      return sequence(a.kind, table.move(b, 1, #b, #out + 1, out))
    end
    return number(a) + number(b)
  end,
  ["-"] = function(a, b) return number(a) - number(b) end,
  ["*"] = function(a, b)
    if is_sequence(b) then a, b = b, a end
    if not is_sequence(a) then return number(a) * number(b) end
    local out = {}
    refuse_long(#a * number(b), notes.most_items, "a list")
    for _ = 1, number(b) do table.move(a, 1, #a, #out + 1, out) end
    return sequence(a.kind, out)
  end,
  ["/"] = function(a, b)
    if number(b) == 0 then beyond "a division by 0" end
    return number(a) / number(b)
  end,
  ["//"] = function(a, b)
    if number(b) == 0 then beyond "a division by 0" end
    return number(a) // number(b)
  end,
  ["%"] = function(a, b)
    if number(b) == 0 then beyond "a division by 0" end
    return number(a) % number(b)
  end,
  ["**"] = function(a, b)
    local x, y = number(a), number(b)
    local result = x ^ y
    local whole = math.type(x) == "integer" and math.type(y) == "integer" and y >= 0 and math.abs(result) < 2 ^ 53
    return whole and math.tointeger(result) or result
  end,
}

local function holds(list, value)
  for _, item in ipairs(items_of(list)) do
    if equal(item, value) then return true end
  end
  return false
end

local comparisons = {
  ["<"] = function(a, b) return number(a) < number(b) end, [">"] = function(a, b) return number(a) > number(b) end,
  ["<="] = function(a, b) return number(a) <= number(b) end, [">="] = function(a, b) return number(a) >= number(b) end,
  ["=="] = equal, ["!="] = function(a, b) return not equal(a, b) end, is = equal,
  ["in"] = function(a, b) return holds(b, a) end,
}

-- Within a bracket: the place of a "for" that is in no further bracket, and of the bracket that closes.
function Script:is_comprehension()
  local f = tokens_of.find(self.tokens, "for", self.at)
  local depth = 0
  for i = self.at, #self.tokens do
    local value = self.tokens[i].kind == "op" and self.tokens[i].value
    if value == "(" or value == "[" or value == "{" then depth = depth + 1 end
    if value == ")" or value == "]" or value == "}" then depth = depth - 1 end
    if depth < 0 then return f and f < i and f or nil, i end
  end
end

-- [what for targets in list if condition]; f: the place of the for, stop: that of the bracket at the end.
function Script:comprehension(f, stop)
  local what = self.at
  local more = tokens_of.find(self.tokens, "for", f + 1)
  if more and more < stop then beyond "a comprehension with two loops is not followed" end
  self.at = f + 1
  local targets = self:targets "in"
  local list = items_of(self:choice())
  local condition = self:accept "if" and self.at or nil
  if not condition and self.at ~= stop then beyond "a comprehension is not followed" end
  local out = {}
  for _, value in ipairs(list) do
    self:count()
    self:assign(targets, value)
    self.at = condition or stop
    if not condition or truth(self:choice()) then
      self.at = what
      out[#out + 1] = self:choice()
    end
  end
  self.at = stop + 1
  return sequence("list", out)
end

-- Values between brackets; `comma`: whether there was one.
function Script:values(close)
  local list, comma = {}, false
  while not self:accept(close) do
    if self:accept "*" then
      local spread = items_of(self:choice())
      table.move(spread, 1, #spread, #list + 1, list)
    else
      list[#list + 1] = self:choice()
    end
    if not self:is(close) then
      self:must ","
      comma = true
    end
  end
  return list, comma
end

function Script:dictionary()
  local dict = { kind = "dict", keys = {}, values = {} }
  while not self:accept "}" do
    local key = self:choice()
    self:must ":"
    put(dict, key, self:choice())
    if not self:is "}" then self:must "," end
  end
  return dict
end

function Script:name(name)
  if name == "True" or name == "False" then return name == "True" end
  if name == "None" then return none end
  local value = self.variables[name]
  if value ~= nil then return value end
  if functions[name] then return functions[name] end
  if self.star and self:is "(" then return { kind = "command", name = name } end
  beyond("the variable %s has no value", name)
end

function Script:atom()
  local t = self.tokens[self.at]
  if not t then beyond "the line ends within an expression" end
  self.at = self.at + 1
  if t.kind == "number" then return t.value end
  if t.kind == "string" then
    local text = t.value
    while self.tokens[self.at] and self.tokens[self.at].kind == "string" do
      text, self.at = text .. self.tokens[self.at].value, self.at + 1
    end
    return text
  end
  if t.kind == "name" then return self:name(t.value) end
  if t.value == "(" or t.value == "[" then
    local close = t.value == "(" and ")" or "]"
    local f, stop = self:is_comprehension()
    if f then return self:comprehension(f, stop) end
    local list, comma = self:values(close)
    if close == ")" and #list == 1 and not comma then return list[1] end
    return sequence(close == ")" and "tuple" or "list", list)
  end
  if t.kind == "op" and t.value == "{" then return self:dictionary() end
  beyond("'%s' is not followed", t.kind == "f-string" and "an f-string" or tostring(t.value))
end

-- The arguments of a call: a list, and the named one `start`.
function Script:arguments()
  local list, named = {}, {}
  local f, stop = self:is_comprehension()
  if f then return { self:comprehension(f, stop) }, named end
  while not self:accept ")" do
    local t, after = self.tokens[self.at], self.tokens[self.at + 1]
    if t and t.kind == "name" and after and after.kind == "op" and after.value == "=" then
      self.at = self.at + 2
      named[t.value] = self:choice()
    elseif self:accept "*" then
      local spread = items_of(self:choice())
      table.move(spread, 1, #spread, #list + 1, list)
    else
      list[#list + 1] = self:choice()
    end
    if not self:is ")" then self:must "," end
  end
  return list, named
end

-- The arguments of a command as texts; lists are taken apart.
local function flat(list, out)
  for _, value in ipairs(list) do
    if is_sequence(value) then flat(value, out) else out[#out + 1] = text_of(value) end
  end
  return out
end

function Script:call(value)
  if type(value) == "table" and value.kind == "command" then
    if not self.alone then
      local beside = self.reader.beside[value.name]
      error({ beyond = ("the value of the command %s is not known"):format(value.name), beside = beside }, 0)
    end
    local list, named = self:arguments()
    if next(named) then beyond "arguments with a name are not followed" end
    self.reader:run(value.name, flat(list, {}), self.place)
    return none
  end
  if type(value) ~= "function" then beyond "a call is not followed" end
  local list, named = self:arguments()
  if value == functions.enumerate and named.start then list[2], named.start = named.start, nil end
  if next(named) then beyond "arguments with a name are not followed" end
  local good, result = pcall(value, table.unpack(list))
  if good and result ~= nil then return result end
  if type(result) == "table" and result.beyond then error(result, 0) end
  beyond "a function cannot take its arguments"
end

local function member(value, name)
  if type(value) == "table" and value.kind == "module" then
    if value.commands then return { kind = "command", name = name } end
    if value.names[name] then return value.names[name] end
  elseif is_sequence(value) and name == "append" then
    return function(item)
      value[#value + 1] = item
      return none
    end
  elseif is_sequence(value) and name == "extend" then
    return function(more)
      refuse_long(#value + #items_of(more), notes.most_items, "a list")
      table.move(items_of(more), 1, #more, #value + 1, value)
      return none
    end
  end
  beyond(".%s is not followed", name)
end

function Script:postfix()
  local value = self:atom()
  while true do
    if self:accept "(" then
      value = self:call(value)
    elseif self:accept "[" then
      local list, comma = self:values "]"
      value = element(value, comma and sequence("tuple", list) or list[1])
    elseif self:accept "." then
      value, self.at = member(value, self.tokens[self.at].value), self.at + 1
    else
      return value
    end
  end
end

function Script:power()
  local base = self:postfix()
  if self:accept "**" then return operate["**"](base, self:unary()) end
  return base
end

function Script:unary()
  if self:accept "-" then return -number(self:unary()) end
  if self:accept "+" then return number(self:unary()) end
  return self:power()
end

-- A chain of operators of one precedence.
local function chain(next, names)
  return function(self)
    local left = self[next](self)
    while true do
      local t = self.tokens[self.at]
      if not (t and t.kind == "op" and names[t.value]) then return left end
      self.at = self.at + 1
      left = operate[t.value](left, self[next](self))
    end
  end
end
Script.term = chain("unary", { ["*"] = true, ["/"] = true, ["//"] = true, ["%"] = true })
Script.arithmetic = chain("term", { ["+"] = true, ["-"] = true })

function Script:comparison()
  local left, result = self:arithmetic(), nil
  while true do
    local t = self.tokens[self.at]
    local negated = self:is "not" and self.tokens[self.at + 1] and self.tokens[self.at + 1].value == "in"
    if negated then
      self.at = self.at + 1
      t = self.tokens[self.at]
    end
    local compare = t and t.kind ~= "string" and comparisons[t.value]
    if not compare then
      if result == nil then return left end
      return result
    end
    self.at = self.at + 1
    if t.value == "is" and self:accept "not" then negated = true end
    local right = self:arithmetic()
    result = (result == nil or result) and compare(left, right) ~= (negated or false)
    left = right
  end
end

function Script:negation()
  if self:accept "not" then return not truth(self:negation()) end
  return self:comparison()
end

function Script:conjunction()
  local left = self:negation()
  while self:accept "and" do
    local right = self:negation()
    if truth(left) then left = right end
  end
  return left
end

function Script:disjunction()
  local left = self:conjunction()
  while self:accept "or" do
    local right = self:conjunction()
    if not truth(left) then left = right end
  end
  return left
end

-- value if condition else other
function Script:choice()
  local value = self:disjunction()
  local t = self.tokens[self.at]
  if self.in_condition or not (t and t.kind == "name" and t.value == "if") then return value end
  local else_at = tokens_of.find(self.tokens, "else", self.at)
  if not else_at then return value end -- the condition of a comprehension
  self.at = self.at + 1
  local condition = self:disjunction()
  self:must "else"
  local other = self:choice()
  if truth(condition) then return value end
  return other
end

-- One value or, with commas, a tuple, up to the end of the tokens.
function Script:whole()
  local value = self:choice()
  if self.at > #self.tokens then return value end
  local list = { value }
  while self:accept "," do
    if self.at > #self.tokens then break end
    list[#list + 1] = self:choice()
  end
  if self.at <= #self.tokens then beyond("'%s' is not followed", tostring(self.tokens[self.at].value)) end
  return sequence("tuple", list)
end

function Script:evaluate(tokens, from, to)
  self.tokens, self.at = table.move(tokens, from or 1, to or #tokens, 1, {}), 1
  return self:whole()
end

-- Assignments ---------------------------------------------------------------------------------------------------------

-- Names up to a word, as { "a", { "b", "c" } }: for a, (b, c) in ...
function Script:targets(stop)
  local list = {}
  while not self:accept(stop) do
    local t = self.tokens[self.at]
    if not t then beyond "the line is not followed" end
    self.at = self.at + 1
    if t.value == "(" or t.value == "[" then
      list[#list + 1] = self:targets(t.value == "(" and ")" or "]")
    elseif t.kind == "name" then
      list[#list + 1] = t.value
    else
      beyond("'%s' is not followed", tostring(t.value))
    end
    if not self:is(stop) then self:must "," end
  end
  return list
end

function Script:assign(targets, value)
  if #targets == 1 and type(targets[1]) == "string" then
    self.variables[targets[1]] = value
    return
  end
  if #targets == 1 then return self:assign(targets[1], value) end
  local items = items_of(value)
  if #items ~= #targets then beyond "the numbers of names and of values differ" end
  for i, target in ipairs(targets) do self:assign({ target }, items[i]) end
end

-- Assigns to tokens from..to: names, or one element of a list.
function Script:assign_to(tokens, from, to, value)
  if to > from and tokens[to].value == "]" then
    local open = from + 1
    if tokens[open].value ~= "[" then beyond "the assignment is not followed" end
    local list = self:name(tokens[from].value)
    local index = self:evaluate(tokens, open + 1, to - 1)
    return put(list, index, value)
  end
  self.tokens, self.at = table.move(tokens, from, to, 1, {}), 1
  table.insert(self.tokens, { kind = "op", value = "=" })
  self:assign(self:targets "=", value)
end

local augmented = { ["+="] = "+", ["-="] = "-", ["*="] = "*", ["/="] = "/", ["//="] = "//", ["**="] = "**",
  ["%="] = "%" }

-- a = b = value, a += value; false where the statement is no assignment.
function Script:assignment(tokens)
  for mark, operator in pairs(augmented) do
    local at = tokens_of.find(tokens, mark)
    if at then
      local left, right = self:evaluate(tokens, 1, at - 1), self:evaluate(tokens, at + 1, #tokens)
      self:assign_to(tokens, 1, at - 1, operate[operator](left, right))
      return true
    end
  end
  local places, at = {}, tokens_of.find(tokens, "=")
  while at do
    places[#places + 1] = at
    at = tokens_of.find(tokens, "=", at + 1)
  end
  if #places == 0 then return false end
  local value = self:evaluate(tokens, places[#places] + 1, #tokens)
  local from = 1
  for _, place in ipairs(places) do
    self:assign_to(tokens, from, place - 1, value)
    from = place + 1
  end
  return true
end

-- Statements ----------------------------------------------------------------------------------------------------------

local statements = {}
local leave = { ["break"] = {}, continue = {} }

function statements.pass() end
statements["break"] = function() error(leave["break"], 0) end
statements.continue = function() error(leave.continue, 0) end

local modules = { math = maths, numpy = maths }

-- import a.b as c; of OpenSees, math and numpy. Others are no part of a frame.
statements["import"] = function(self, statement)
  local name, alias = statement.text:match "^import%s+([%w_.]+)%s*$", nil
  if not name then name, alias = statement.text:match "^import%s+([%w_.]+)%s+as%s+([%w_]+)%s*$" end
  local of_opensees = name and (name == "opensees" or name:find "^openseespy")
  if of_opensees then
    self.variables[alias or name:match "[^.]+$"] = { kind = "module", commands = true }
    if not alias then self.variables.openseespy = { kind = "module", names = { opensees = { kind = "module",
      commands = true } } } end
  elseif name and modules[name] then
    self.variables[alias or name] = { kind = "module", names = modules[name] }
  else
    notes.add(self.reader.notes.skipped, self.place, statement.text)
  end
end

statements.from = function(self, statement)
  local name, what = statement.text:match "^from%s+([%w_.]+)%s+import%s+(.*)$"
  local of_opensees = name and (name == "opensees" or name == "openseespy.opensees")
  if of_opensees and what:find "^%*" then
    self.star = true
  elseif name and name:find "^openseespy$" and what:find "^opensees" then
    self.variables[what:match "as%s+([%w_]+)" or "opensees"] = { kind = "module", commands = true }
  elseif name and modules[name] then
    for word in what:gmatch "[%w_*]+" do
      if word == "*" then for key, value in pairs(modules[name]) do self.variables[key] = value end end
      self.variables[word] = modules[name][word]
    end
  else
    notes.add(self.reader.notes.skipped, self.place, statement.text)
  end
end

function Script:count()
  self.counted = self.counted + 1
  if self.counted > most_statements then
    notes.fail(self.where, self.place, "the script runs more than %d statements", most_statements)
  end
end

-- Runs the body of a loop; true where it ends the loop.
function Script:turn(body)
  self:count()
  local good, problem = pcall(self.block, self, body)
  if good or problem == leave.continue then return false end
  if problem == leave["break"] then return true end
  error(problem, 0)
end

statements["for"] = function(self, statement)
  local tokens = statement.tokens
  local middle = tokens_of.find(tokens, "in")
  if not middle then beyond "the loop has no in" end
  local list = sequence("list", copy(self:evaluate(tokens, middle + 1, #tokens)))
  self.tokens, self.at = table.move(tokens, 2, middle, 1, {}), 1
  local targets = self:targets "in"
  for _, value in ipairs(list) do
    self:assign(targets, value)
    if self:turn(statement.body) then break end
  end
end

statements["while"] = function(self, statement)
  while truth(self:evaluate(statement.tokens, 2)) do
    if self:turn(statement.body) then break end
  end
end

-- if and what follows it: list[i] is the if. Returns how many more statements belong to it.
function Script:branches(list, i)
  local taken, last = false, i
  while true do
    local statement = list[last]
    if not taken then
      self.place = self:place_of(statement)
      taken = statement.word == "else" or truth(self:evaluate(statement.tokens, 2))
      if taken then self:block(statement.body) end
    end
    local after = list[last + 1]
    if not (after and (after.word == "elif" or after.word == "else")) then return last - i end
    last = last + 1
  end
end

function Script:place_of(statement)
  return { file = self.file, line = statement.line, text = statement.text }
end

-- One statement without a block.
function Script:simple(statement)
  local tokens = statement.tokens
  local first = tokens[1]
  if first.kind == "string" and #tokens == 1 then return end -- a comment in quotes
  if first.kind == "name" and statements[first.value] then return statements[first.value](self, statement) end
  local command = tokens[2] and tokens[2].value == "." and tokens[3] or first
  if command.kind == "name" and (self.reader.beside[command.value] or command.value == "print")
    and tokens_of.find(tokens, "=") == nil then
    return notes.add(self.reader.notes.skipped, self.place, statement.text)
  end
  if self:assignment(tokens) then return end
  self.alone = true
  self:evaluate(tokens)
end

-- How many lines a statement has with its block.
local function lines_of(statement)
  local count = 1
  for _, inner in ipairs(statement.body or {}) do count = count + lines_of(inner) end
  return count
end

-- Names that a statement would assign have no value where it is not followed.
function Script:forget(statement)
  for _, inner in ipairs(statement.body or {}) do self:forget(inner) end
  local at = tokens_of.find(statement.tokens, "=")
  for i = 1, at and at - 1 or 0 do
    local t = statement.tokens[i]
    if t.kind == "name" and (not statement.tokens[i + 1] or statement.tokens[i + 1].value ~= ".") then
      self.variables[t.value] = nil
    end
  end
end

-- Runs statement i of a list; returns how many more belong to it.
function Script:statement(list, i)
  local statement = list[i]
  self.place, self.alone = self:place_of(statement), false
  self:count()
  if statement.word == "if" then return self:branches(list, i) end
  if statement.word and not statements[statement.word] then
    beyond("%s is not followed", statement.word)
  end
  if statement.word then statements[statement.word](self, statement) else self:simple(statement) end
  return 0
end

function Script:block(list)
  local i = 1
  while i <= #list do
    local statement = list[i]
    local good, more = pcall(self.statement, self, list, i)
    if not good then
      local problem = more
      if type(problem) ~= "table" or not problem.beyond then error(problem, 0) end
      self:forget(statement)
      local place, lines = self:place_of(statement), lines_of(statement)
      if problem.beside then
        notes.add(self.reader.notes.skipped, place, statement.text)
      else
        self.reader:lost(place, problem.beyond, lines - 1)
      end
      more = 0
      while statement.word == "if" and list[i + more + 1] and (list[i + more + 1].word or ""):find "^el" do
        more = more + 1
      end
    end
    i = i + 1 + more
  end
end

--- Runs a script and gives its commands to the reader.
return function(where, reader, file, text)
  local self = setmetatable({ where = where, reader = reader, file = file, counted = 0,
    variables = { __name__ = "__main__" } }, Script)
  self:block(tokens_of.statements(where, file, text))
end
