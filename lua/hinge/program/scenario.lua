-- A scenario: a script's parameters with their defaults, its named cases, its settings of accuracy against time, and
-- the function that runs it.
local check = require "hinge.library.check"
local settings = require "hinge.program.parameters"
local values = require "hinge.library.values"

local scenario = {}
local Scenario = {}
local class = check.class(Scenario, "hinge.scenario")

local where = "hinge.scenario"
local kinds = { number = true, string = true, boolean = true, table = true }

local function same_type(what, value, default)
  if type(value) ~= type(default) then
    check.fail("%s: %s is %s; must be a %s, like its default %s", where, what, check.show(value), type(default),
      check.show(default))
  end
end

local function each_parameter(parameters)
  for name, value in pairs(parameters) do
    if type(name) ~= "string" then
      check.fail("%s: parameters holds %s without a name; write name = value", where, check.show(value))
    elseif not kinds[type(value)] then
      check.fail("%s: parameter %s is a %s; must be a number, a string, true, false or a list", where, name,
        type(value))
    end
  end
end

-- Whether `return hinge.scenario { ... }` ends a script under Lua's own interpreter. Nothing would then run the
-- scenario.
local function ends_a_script()
  local caller = debug.getinfo(3, "S")
  return debug.getinfo(2, "t").istailcall and caller and caller.what == "C" and not debug.getinfo(4, "S")
    and type(arg) == "table" and type(arg[0]) == "string"
end

--- hinge.scenario: see words/scenarios.d.lua.
function scenario.new(options, ...)
  if ends_a_script() then
    check.fail("%s: this script returns a scenario, which plain Lua does not run; the program does: "
      .. "hinge run %s [key=value ...] [--case NAME]", where, arg[0])
  end
  check.no_more(where, ...)
  local o = check.options(where, options, {
    parameters = { "table", default = {} }, cases = { "table", default = {} },
    accuracy = { "table", default = {} }, proposals = { "table", default = {} }, vary = { "table", default = {} },
    run = { "function" }, answers = { "table", optional = true },
  })
  if o.answers then require "hinge.accuracy.answers".check(where .. ": answers", o.answers) end
  each_parameter(o.parameters)
  local parameters = {}
  for name, value in pairs(o.parameters) do parameters[name] = value end
  for name, choices in pairs(o.accuracy) do
    if type(name) ~= "string" or type(choices) ~= "table" or #choices == 0 then
      check.fail("%s: accuracy.%s is %s; must be a list of settings, the first of them the default", where,
        tostring(name), check.show(choices))
    end
    if parameters[name] == nil then parameters[name] = choices[1] end
    for _, choice in ipairs(choices) do same_type("accuracy." .. name, choice, parameters[name]) end
  end
  each_parameter(parameters)
  for case, changes in pairs(o.cases) do
    if type(case) ~= "string" or type(changes) ~= "table" then
      check.fail("%s: cases holds %s; each case is written name = { parameter = value }", where, check.show(changes))
    end
    for name, value in pairs(changes) do
      if parameters[name] == nil then
        check.unknown(("%s: case %s"):format(where, case), "parameter", name, check.keys(parameters))
      end
      same_type(("case %s: %s"):format(case, name), value, parameters[name])
    end
  end
  for name, propose in pairs(o.proposals) do
    if type(name) ~= "string" or type(propose) ~= "function" then
      check.fail("%s: proposals holds %s; each is written name = function(cases)", where, check.show(propose))
    end
  end
  for name in pairs(o.vary) do
    if parameters[name] == nil then check.unknown(where .. ": vary", "parameter", name, check.keys(parameters)) end
  end
  return setmetatable({ parameters = parameters, cases = o.cases, accuracy = o.accuracy, proposals = o.proposals,
    vary = o.vary, run = o.run, answers = o.answers }, class)
end

function scenario.is(value) return getmetatable(value) == class end

--- The parameters of one run: defaults, changed by a case, changed by overrides.
-- `overrides` is a list of { name, text }; later ones win. Reading a parameter that does not exist is an error.
function Scenario:values(case, overrides)
  local result = {}
  for name, value in pairs(self.parameters) do result[name] = value end
  if case then
    if not self.cases[case] then check.unknown("--case", "case", case, check.keys(self.cases)) end
    for name, value in pairs(self.cases[case]) do result[name] = value end
  end
  for _, override in ipairs(overrides or {}) do
    local name, text = override[1], override[2]
    local default = self.parameters[name]
    if default == nil then check.unknown(name .. "=" .. text, "parameter", name, check.keys(self.parameters)) end
    local value, allowed = values.like(text, default)
    if value == nil then
      check.fail("%s=%s: %s is %s; must be %s%s", name, text, name, check.show(text), allowed,
        settings.about_units(name, text))
    end
    result[name] = value
  end
  return check.strict(result, "parameters")
end

-- Whether two parameters are the same, lists item by item.
local function same(a, b)
  if type(a) ~= "table" or type(b) ~= "table" then return a == b end
  for i = 1, math.max(#a, #b) do if not same(a[i], b[i]) then return false end end
  return true
end

--- The values that differ from those of the case, or from the defaults.
function Scenario:changed(case, parameters)
  local changed = {}
  for name, value in pairs(self:values(case)) do
    if not same(value, parameters[name]) then changed[name] = parameters[name] end
  end
  return changed
end

return scenario
