-- The settings of a script that is made of plain statements, which does not say what parameters it has: which of them
-- it reads.
local core = require "hinge.core"
local check = require "hinge.check"
local values = require "hinge.values"

local parameters = {}

--- The names that a text reads off the variable that holds its `...`, as keys, {} where it has no `...`; nil where only
-- running it can tell, for it hands them on or loads other code.
function parameters.names_in(text)
  text = text:gsub("%-%-%[%[.-%]%]", ""):gsub("%-%-[^\n]*", "")
  if text:find "scenario" then return nil end
  for _, word in ipairs { "load", "loadfile", "dofile" } do
    if text:find("%f[%w_:.]" .. word .. "%f[^%w_]") then return nil end
  end
  for module in text:gmatch "%f[%w_]require%f[^%w_]%s*(.[^\n]*)" do
    if not module:find "^%(?%s*[\"']hinge[\"'%.]" then return nil end
  end
  local _, dots = text:gsub("%.%.%.", "")
  if dots == 0 then return {} end
  local variable = text:match "local%s+([%a_][%w_]*)%s*=%s*%.%.%."
  if not variable or dots > 1 then return nil end
  local names, others = {}, 0
  for at in text:gmatch("%f[%w_]" .. variable .. "%f[^%w_]()") do
    local name = text:match("^%s*%.%s*([%a_][%w_]*)", at) or text:match("^%s*%[%s*[\"']([^\"']+)[\"']%s*%]", at)
    if name then names[name] = true else others = others + 1 end
  end
  return others == 1 and names or nil -- once where it is made
end

local function refuse(name, text, script, names)
  if next(names) == nil then
    check.fail("%s=%s: %s takes no parameters; it does not read its argument, '...'", name, text, script)
  end
  local known = check.keys(names)
  check.fail("%s=%s: %s reads no parameter %s%s; it reads %s", name, text, script, check.show(name),
    core.did_you_mean(name, known), table.concat(known, ", "))
end

--- Settings as a table, by name. overrides: a list of { name, text }.
function parameters.given(overrides)
  local given = {}
  for _, override in ipairs(overrides or {}) do given[override[1]] = values.guess(override[2]) end
  return given
end

--- Settings for code that does not say which parameters it has. overrides: a list of { name, text }; script: how it is
-- called in messages; code: its text. Returns what the code gets as `...`, the settings themselves, and a function that
-- raises an error if one of them was not read.
function parameters.of(overrides, script, code)
  overrides = overrides or {}
  local given, read, all = parameters.given(overrides), {}, false
  local names = #overrides > 0 and parameters.names_in(code)
  for _, override in ipairs(overrides) do
    if names and not names[override[1]] then refuse(override[1], override[2], script, names) end
  end
  if #overrides == 0 then return given, given, function() end end
  local watched = setmetatable({}, {
    __index = function(_, name) read[name] = true return given[name] end,
    __newindex = function(_, name, value) given[name] = value end,
    __pairs = function() all = true return next, given, nil end,
    __len = function() return #given end,
  })
  return watched, given, function()
    for _, override in ipairs(overrides) do
      if not all and not read[override[1]] then refuse(override[1], override[2], script, read) end
    end
  end
end

return parameters
