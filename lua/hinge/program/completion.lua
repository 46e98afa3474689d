-- hinge completion names: what a shell may complete, "parameter NAME" and "case NAME" of a script, "call NAME" of the
-- reference. A script's text is read; nothing of it runs.
local core = require "hinge.core"
local check = require "hinge.library.check"
local parameters = require "hinge.program.parameters"

local completion = {}

-- The fields of a table that is written out: { name = text of the value up to the next one }.
local function fields(text)
  local found, depth, at = {}, 0, 1
  while at <= #text do
    local c = text:sub(at, at)
    if c:find "[{(%[]" then depth = depth + 1 elseif c:find "[})%]]" then depth = depth - 1 end
    local name, value = nil, nil
    if depth == 1 then name, value = text:match("^[{,;%s]([%a_][%w_]*)%s*=%f[^=]%s*()", at) end
    if name then
      found[name] = found[name] or value -- a later one is inside a function
      at = value
    else
      at = at + 1
    end
  end
  return found
end

-- The fields of the table whose text begins at a place: { ... }, call { ... }, or a variable that was made so.
local function fields_at(text, at)
  local own = text:match("^%b{}", at) or text:match("^[%w_.:]+%s*%(?%s*(%b{})", at)
  local variable = text:match("^([%a_][%w_]*)%s*[,;}]", at)
  if not own and variable then
    own = text:match("%f[%w_]" .. variable .. "%s*=%s*(%b{})")
      or text:match("%f[%w_]" .. variable .. "%s*=%s*[%w_.:]+%s*%(?%s*(%b{})")
  end
  return own and fields(own) or {}
end

--- Two lists: the names of the parameters and of the cases of a script that its text shows.
function completion.names(text)
  local code = parameters.bare(text)
  local from, to = code:match "%f[%w_]scenario%s*%(?%s*()%b{}()"
  if not from then return check.keys(parameters.names_in(text) or {}), {} end
  local options = fields(code:sub(from, to - 1))
  local function of(name) return options[name] and fields_at(code, from - 1 + options[name]) or {} end
  local all = of "parameters"
  for name in pairs(of "accuracy") do all[name] = true end
  return check.keys(all), check.keys(of "cases")
end

local function say(kind, names)
  for _, name in ipairs(names) do print(kind .. " " .. name) end
end

--- options: script (path), or nil for the calls of the reference. Returns the exit status.
function completion.main(options)
  if not options.script then
    local calls = {}
    for _, e in ipairs(require "hinge.program.reference".read()) do
      if e.kind == "function" or e.kind == "class" then calls[e.name] = true end
    end
    say("call", check.keys(calls))
    return 0
  end
  local text = core.read_text(options.script)
  if not text then return 2 end
  local names, cases = completion.names(text)
  say("parameter", names)
  say("case", cases)
  return 0
end

return completion
