-- The settings of a script of plain statements. Such a script has no list of parameters, so this file finds which
-- settings it reads.
local core = require "hinge.core"
local check = require "hinge.library.check"
local values = require "hinge.library.values"

local parameters = {}

--- A script's text without comments and without the content of its strings. names: a string that is a field name
--- stays, as in p["speed"].
function parameters.bare(text, names)
  local parts, at = {}, 1
  while true do
    local from = text:find("[%-%[\"']", at)
    if not from then break end
    local comment = text:match("^%-%-()", from)
    local level, inside = text:match("^%[(=*)%[()", comment or from)
    local stop
    if level then
      stop = select(2, text:find("]" .. level .. "]", inside, true)) or #text
    elseif comment then
      stop = (text:find("\n", comment, true) or #text + 1) - 1
    elseif text:find("^[\"']", from) then
      local quote, i = text:sub(from, from), from + 1
      while i <= #text and not text:find("^[\n" .. quote .. "]", i) do i = i + (text:sub(i, i) == "\\" and 2 or 1) end
      stop = math.min(i, #text)
    end
    parts[#parts + 1] = text:sub(at, from - 1)
    local is_name = names and stop and not comment and not level and text:sub(1, from - 1):find "%[%s*$"
    if not stop or is_name then parts[#parts + 1] = text:sub(from, stop or from)
    else parts[#parts + 1] = comment and " " or '""' end
    at = (stop or from) + 1
  end
  return table.concat(parts) .. text:sub(at)
end

-- Whether a text may run other code, which may return a scenario: `load` as the function of Lua, not as another name.
local function runs_other_code(text)
  for _, word in ipairs { "loadfile", "dofile" } do
    if text:find("%f[%w_:.]" .. word .. "%f[^%w_]") then return true end
  end
  if text:find "pcall%s*%(%s*load%s*," or text:find "=%s*load%s*[\n,;]" then return true end
  local own = text:find "local%s+load%f[^%w_]" or text:find "function%s+load%f[^%w_]"
  if not own and text:find "%f[%w_:.]load%s*[%(\"%[{]" then return true end
  return false
end

--- The names that a text reads from the variable with its `...`, as keys; {} if it has no `...`. nil if only a run can
-- show them, because the text passes the variable on or loads other code.
function parameters.names_in(whole)
  for module in whole:gmatch "%f[%w_]require%f[^%w_]%s*(.[^\n]*)" do
    if not module:find "^%(?%s*[\"']hinge[\"'%.]" then return nil end
  end
  local text = parameters.bare(whole, true)
  if text:find "scenario" or runs_other_code(text) then return nil end
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

local sizes = { ["G"] = 1e9, ["M"] = 1e6, ["k"] = 1e3, ["m"] = 1e-3 }
local units = { N = 1, Pa = 1, m = 1, s = 1, J = 1, W = 1, Nm = 1, ["N/m"] = 1, ["N m"] = 1, ["m/s"] = 1, ["m/s^2"] = 1,
  ["m/s2"] = 1, g = 1e-3, ["N/m2"] = 1, ["N/m^2"] = 1 }
local other_units = { ["cm"] = 0.01, ["km/h"] = 1 / 3.6, ["ms"] = 1e-3, ["t"] = 1e3, ["N/mm2"] = 1e6, ["N/mm^2"] = 1e6 }

-- A number with its unit behind it as a number in SI units, nil for other texts.
local function without_unit(text)
  local number, unit = text:match "^%s*([+-]?[%d.]+[eE]?[+-]?%d*)%s*(%a[%w/^ ]*)%s*$"
  number = tonumber(number)
  if not number then return nil end
  local size = other_units[unit] or units[unit]
  local prefix, rest = sizes[unit:sub(1, 1)], units[unit:sub(2)]
  if not size and prefix and rest then size = prefix * rest end
  return size and number * size
end

--- The advice for a setting that looks like a number with a unit, else "".
function parameters.about_units(name, text)
  local number = without_unit(text)
  return number and ("; a number in SI units, without its unit, is %s=%.10g"):format(name, number) or ""
end

--- The same for all settings of a script, each on a line of its own.
function parameters.all_about_units(overrides)
  local lines = ""
  for _, override in ipairs(overrides or {}) do
    local name, text = override[1], override[2]
    local about = parameters.about_units(name, text)
    if about ~= "" then lines = lines .. ("\n%s=%s is text for the script%s"):format(name, text, about) end
  end
  return lines
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
