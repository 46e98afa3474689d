-- Checks of the values that a script gives, and messages that say what is wrong and what is allowed.
local core = require "hinge.core"

local check = {}

--- "model", "node", "member", "group", "run", ... of an object of hinge; nil of any other value.
check.kind_of = core.kind_of

--- Raises an input error at the script's own line.
function check.fail(format, ...)
  core.input_error(select("#", ...) > 0 and format:format(...) or format)
end

--- A text without control characters but line ends and tabs, for a terminal.
function check.plain(text) return (text:gsub("[\0-\8\11-\31\127]", "?")) end

--- Raises an error if there are more arguments than a function takes.
function check.no_more(where, ...)
  for i = 1, select("#", ...) do
    local more = select(i, ...)
    if more ~= nil then check.fail("%s: takes no further argument, got also %s", where, check.show(more)) end
  end
end

--- A value as it should appear in a message.
function check.show(value)
  if type(value) == "string" then return "'" .. value .. "'" end
  if value ~= value then return "not a number (nan)" end
  if math.type(value) == "float" then return ("%.10g"):format(value) end
  if type(value) ~= "table" or getmetatable(value) then return tostring(value) end
  local parts = {}
  for i, v in ipairs(value) do
    if i > 12 then parts[i] = "..." break end
    parts[i] = check.show(v)
  end
  return #parts > 0 and "{" .. table.concat(parts, ", ") .. "}" or "a table"
end

--- A text for one line of a terminal or a table: its line breaks become blanks.
function check.one_line(text) return (tostring(text):gsub("%s*[\r\n]+%s*", " ")) end

--- The keys of a table as text, sorted.
function check.keys(map)
  local names = {}
  for key in pairs(map) do names[#names + 1] = tostring(key) end
  table.sort(names)
  return names
end

--- Raises "... did you mean ...?" for a name that is not among `names`.
function check.unknown(where, what, word, names)
  check.fail("%s: unknown %s %s%s; %s", where, what, check.show(word), core.did_you_mean(tostring(word), names),
    #names > 0 and "there are " .. table.concat(names, ", ") or "there is none")
end

--- Makes reading a field that is not there an error, for tables whose fields are all known. With `call` the table is a
--- function, too.
function check.strict(map, where, call)
  return setmetatable(map, { __index = function(t, key) check.unknown(where, "field", key, check.keys(t)) end,
    __call = call and function(_, ...) return call(...) end, __name = call and where })
end

--- As check.strict, with fields that are made when they are first read: later.name() gives the value of the field
--- `name`. pairs() makes them all. What later.name() requires is found where it is now, also if a script has given
--- package.path another value since.
function check.lazy(map, later, where)
  local path = rawget(package, "path") -- nil in the sandbox, which finds the files by itself
  local function make(t, key)
    local of_script = rawget(package, "path")
    local _ <close> = setmetatable({}, { __close = function() package.path = of_script end })
    package.path = path
    local value = later[key]()
    later[key] = nil
    rawset(t, key, value)
    return value
  end
  return setmetatable(map, {
    __index = function(t, key)
      if later[key] then return make(t, key) end
      check.unknown(where, "field", key, check.keys(t))
    end,
    __pairs = function(t)
      while next(later) do make(t, next(later)) end
      return next, t, nil
    end,
  })
end

--- The metatable of objects with these methods. It is not the table of the methods, which an object would then hand
--- out as its field __index to scripts that are not trusted.
function check.class(methods, name)
  return { __index = methods, __name = name }
end

local bounds = {
  { "above", "above", function(v, limit) return v > limit end },
  { "at_least", "of at least", function(v, limit) return v >= limit end },
  { "below", "below", function(v, limit) return v < limit end },
  { "at_most", "of at most", function(v, limit) return v <= limit end },
}

local allowed

-- What else a value may be, beside its kind: { "number", also = { "auto" } }.
local function with_also(rule)
  local others = {}
  for _, value in ipairs(rule.also) do others[#others + 1] = "'" .. value .. "'" end
  local plain = {}
  for k, v in pairs(rule) do plain[k] = v end
  plain.also = nil
  return allowed(plain) .. " or " .. table.concat(others, " or ")
end

function allowed(rule)
  local kind = rule[1]
  if rule.also then return with_also(rule) end
  if rule.one_of then return "one of " .. table.concat(rule.one_of, ", ") end
  local number = rule.whole and "whole number" or "number"
  local text
  if kind == "number" then
    text = "a " .. number
  elseif kind == "numbers" then
    text = (rule.count or "two or more") .. " " .. number .. "s in braces, each"
  else
    return ({ string = "a string",
      boolean = "true or false", table = "a table", ["function"] = "a function",
      section = "a section, such as hinge.section.box{...} gives",
      material = "a material, made by hinge.material{...}" })[kind] or rule.words
  end
  local limits = {}
  for _, b in ipairs(bounds) do
    if rule[b[1]] then limits[#limits + 1] = ("%s %s"):format(b[2], check.show(rule[b[1]])) end
  end
  text = #limits > 0 and text .. " " .. table.concat(limits, " and ") or text:gsub(", each$", "")
  if not rule.unit then return text end
  return #limits > 0 and text .. " " .. rule.unit or text .. ", in " .. rule.unit
end

local function good_number(value, rule)
  if type(value) ~= "number" or value ~= value or math.abs(value) == math.huge then return false end
  if rule.whole and not math.tointeger(value) then return false end
  for _, b in ipairs(bounds) do
    if rule[b[1]] and not b[3](value, rule[b[1]]) then return false end
  end
  return true
end

local function among(value, list)
  for _, v in ipairs(list) do
    if v == value then return true end
  end
  return false
end

local function good(value, rule)
  local kind = rule[1]
  if rule.also and among(value, rule.also) then return true end
  if kind == "number" then return good_number(value, rule) end
  if kind == "numbers" then
    if type(value) ~= "table" or #value < 2 or rule.count and #value ~= rule.count then return false end
    for _, v in ipairs(value) do
      if not good_number(v, rule) then return false end
    end
    return true
  end
  local mark = ({ section = "area", material = "E" })[kind]
  if mark then return (type(value) == "userdata" or type(value) == "table") and type(value[mark]) == "number" end
  if rule.good then return rule.good(value) end
  if type(value) ~= kind then return false end
  return not rule.one_of or among(value, rule.one_of)
end

--- One field against its rule; see check.options.
function check.value(where, field, value, rule)
  if value == nil then
    check.fail("%s: field '%s' is missing; give %s", where, field, allowed(rule))
  end
  if good(value, rule) then return value end
  local unit = type(value) == "number" and rule.unit and " " .. rule.unit or ""
  check.fail("%s: field '%s' is %s%s; must be %s%s", where, field, check.show(value), unit, allowed(rule),
    rule.one_of and core.did_you_mean(tostring(value), rule.one_of) or "")
end

--- The first argument of everything that adds to a model.
function check.model(where, model)
  if core.kind_of(model) ~= "model" and not (type(model) == "table" and model.node and model.member) then
    check.fail("%s: the model is %s; call it as %s(model, { option = value })", where,
      model == nil and "missing" or check.show(model), where)
  end
end

--- A value of the library for a script, which may change it: tables are copied, with those inside.
function check.copy(value)
  if type(value) ~= "table" then return value end
  local copy = {}
  for key, item in pairs(value) do copy[key] = check.copy(item) end
  return copy
end

--- Checks a table of named options and returns a copy with the defaults filled in.
-- Each rule is { kind, unit=, default=, optional=, above=, at_least=, below=, at_most=, whole=,
-- count=, one_of=, also= (other values that it may be) }; kinds: number, numbers (a list of `count`, or of any two or
-- more), string, boolean, table, function, section, material; or any other word with good = a function that says
-- whether a value will do, and words = what it must be.
function check.options(where, options, rules)
  if options == nil then options = {} end
  if type(options) ~= "table" then
    check.fail("%s: takes a table of options, got %s", where, check.show(options))
  end
  for field in pairs(options) do
    if type(field) ~= "string" then
      check.fail("%s: the value %s has no name; write name = value; the names are %s", where,
        check.show(options[field]), table.concat(check.keys(rules), ", "))
    end
    if not rules[field] then check.unknown(where, "field", field, check.keys(rules)) end
  end
  local result = {}
  for _, field in ipairs(check.keys(rules)) do
    local rule, value = rules[field], options[field]
    if value == nil then value = check.copy(rule.default) end
    if value ~= nil or not rule.optional then result[field] = check.value(where, field, value, rule) end
  end
  return result
end

--- Options with what is missing from the design that `options.design` names.
function check.design(where, options, designs)
  local design = designs[options.design]
  if not design then check.unknown(where .. ": field 'design'", "design", options.design, check.keys(designs)) end
  for name, value in pairs(design) do
    if options[name] == nil then options[name] = check.copy(value) end
  end
  return options
end

--- "1 setting", "2 settings"
function check.count(n, what) return ("%d %s%s"):format(n, what, n == 1 and "" or "s") end

return check
