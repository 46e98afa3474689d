-- hinge completion names: what a shell may complete, "parameter NAME" and "case NAME" of a script, "call NAME" of the
-- reference. A script's text is read; nothing of it runs.
local check = require "hinge.library.check"
local parameters = require "hinge.program.parameters"

local completion = {}

-- Where the string that begins at a place has ended.
local function after_string(text, at)
  local mark = text:sub(at, at)
  repeat
    at = text:find("[\\\n" .. mark .. "]", at + 1) or #text
    local escaped = text:sub(at, at) == "\\"
    if escaped then at = at + 1 end
  until not escaped
  return at + 1
end

-- A text without its comments, its strings empty.
local function bare(text)
  local parts, at = {}, 1
  while true do
    local from = text:find("[-\"'%[]", at)
    if not from then break end
    parts[#parts + 1] = text:sub(at, from - 1)
    local _, after = text:match("^%-?%-?%[(=*)%[.-%]%1%]()", from)
    after = after or text:match("^%-%-[^\n]*()", from)
    if not after and text:find("^[\"']", from) then after = after_string(text, from) end
    parts[#parts + 1] = not after and text:sub(from, from) or text:sub(from, from) ~= "-" and '""' or nil
    at = after or from + 1
  end
  parts[#parts + 1] = text:sub(at)
  return table.concat(parts)
end

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
  local code = bare(text)
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
  local file = io.open(options.script, "rb")
  local text = file and file:read "a"
  if file then file:close() end
  if not text then return 2 end
  local names, cases = completion.names(text)
  say("parameter", names)
  say("case", cases)
  return 0
end

return completion
