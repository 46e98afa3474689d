-- What hinge.d.lua and the files of words declare, as a list and as a page. hinge reference and help (help.lua) look it
-- up.
local folder = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../"

-- In the order of the page.
local reference = { files = { "hinge.d.lua" } }
local files = "model members materials sections grid loads actions ground_motion heat joints connections breaks "
  .. "run_options runs recorded scenarios pictures results study cost benchmark robustness import models "
  .. "paper report"
for name in files:gmatch "%S+" do table.insert(reference.files, "words/" .. name .. ".d.lua") end

-- A type and what follows it: types may hold blanks inside brackets and quotes, and after the `:` of a function's
-- result.
local function split_type(text)
  local depth, quoted = 0, false
  for at = 1, #text do
    local c = text:sub(at, at)
    if c == '"' then quoted = not quoted end
    if c:find "[%[{(<]" then depth = depth + 1 elseif c:find "[%]})>]" then depth = depth - 1 end
    if c == " " and depth == 0 and not quoted and not text:sub(1, at - 1):find "[:,]$" then
      return text:sub(1, at - 1), text:sub(at + 1)
    end
  end
  return text, ""
end

--- The fields of a table type such as "{ a: number, b?: string }": { { name =, type =,
-- optional = }, ... }; nil for other types.
function reference.fields(type_text)
  local inside = type_text:match "^{ (.*) }$"
  if not inside then return nil end
  local fields = {}
  local rest = inside
  while rest ~= "" do
    local depth, at = 0, 1
    while at <= #rest and (depth > 0 or rest:sub(at, at) ~= ",") do
      local c = rest:sub(at, at)
      if c:find "[%[{(<]" then depth = depth + 1 elseif c:find "[%]})>]" then depth = depth - 1 end
      at = at + 1
    end
    local name, optional, kind = rest:sub(1, at - 1):match "^(%[?[%w_]+%]?)(%??): (.*)$"
    fields[#fields + 1] = { name = name, type = kind, optional = optional == "?" }
    rest = rest:sub(at + 1):gsub("^%s+", "")
  end
  return fields
end

-- The lines of a file with their numbers; one that begins with `---` and two blanks is the end of the one before it,
-- but not in an example.
local function lines_of(path)
  local lines, numbers, number, in_example = {}, {}, 0, false
  for line in io.lines(path) do
    number = number + 1
    if line:find "^%-%-%-```" then in_example = not in_example end
    local more = not in_example and line:match "^%-%-%-  +(.*)$"
    if more and #lines > 0 then
      lines[#lines] = lines[#lines] .. " " .. more
    else
      lines[#lines + 1], numbers[#lines + 1] = line, number
    end
  end
  return lines, numbers
end

--- The declarations in their order: a list of entries, each with `kind` and `line` ("words/model.d.lua:12"): heading
-- (text, module), alias and class (name, type, doc; fields; base, the class whose fields it has, too), and function
-- (name, object, separator, arguments, params, returns, doc, example). A field or a param has name, optional, type and
-- doc. An example is Lua, or nil.
function reference.read()
  local entries, classes = {}, {}
  for _, name in ipairs(reference.files) do
    local number, doc, params, returns, class, class_of = 0, {}, {}, {}, nil, {}
    local example, in_example
    -- What is said of a declaration: in the lines above it, then behind it.
    local function about(behind)
      if behind and behind ~= "" then doc[#doc + 1] = behind end
      local said = table.concat(doc, " ")
      doc = {}
      return said
    end
    local function add(entry)
      entry.doc = about(entry.doc)
      entry.line = ("%s:%d"):format(name, number)
      entries[#entries + 1] = entry
      return entry
    end
    local function item(text)
      local word, optional, rest = text:match "^(%S-)(%??) (.*)$"
      local kind, behind = split_type(rest)
      return { name = word, optional = optional == "?" or kind:find "%?$" ~= nil, type = (kind:gsub("%?$", "")),
        doc = behind, line = ("%s:%d"):format(name, number) }
    end
    local lines, numbers = lines_of(folder .. name)
    for i, line in ipairs(lines) do
      number = numbers[i]
      local tag, text = line:match "^%-%-%-@(%a+) ?(.*)$"
      local called, arguments = line:match "^function ([%w_.:]+)%((.-)%) end"
      if line:find "^%-%-%-```" then
        in_example = line:find "lua$" ~= nil
        example = example or {}
      elseif in_example then
        example[#example + 1] = line:match "^%-%-%-(.*)$"
      elseif tag == "class" then
        local word, behind = text:match "^(%S+) ?(.*)$"
        local base
        if word:find ":$" then
          word, base, behind = word:sub(1, -2), behind:match "^%S+", behind:gsub("^%S+", "The fields of `%0`, and:")
        end
        if classes[word] then class = classes[word] -- a class whose functions are in several files
        else class = add { kind = "class", name = word, base = base, doc = behind, fields = {} } end
        classes[word] = class
      elseif tag == "alias" then
        local word, rest = text:match "^(%S+) (.*)$"
        local kind, behind = split_type(rest)
        add { kind = "alias", name = word, type = kind, doc = behind }
      elseif tag == "field" then
        local field = item(text)
        field.doc = about(field.doc)
        table.insert(class.fields, field)
      elseif tag == "param" then
        params[#params + 1] = item(text)
      elseif tag == "return" then
        returns[#returns + 1] = text
      elseif line:find "^%-%-%- ?" and not tag then
        doc[#doc + 1] = line:match "^%-%-%- ?(.*)$"
      elseif called then
        local variable, separator, own = called:match "^([%w_]+)([.:])([%w_]+)$"
        add { kind = "function", name = own, object = class_of[variable], variable = variable, separator = separator,
          arguments = arguments, params = params, returns = returns, example = example and table.concat(example, "\n") }
        params, returns, example = {}, {}, nil
      elseif line:find "^local [%w_]+ = {}" then
        class_of[line:match "^local ([%w_]+)"] = class.name
      elseif line:find "^%-%- .- %-%-%-%-+$" then
        local title = line:match "^%-%- (.-) %-%-%-%-+$"
        add { kind = "heading", text = title, module = title:match 'require "(.-)"' }
      end
    end
  end
  return entries
end

--- Objects that are tables of the library: their names in it.
reference.tables = { ["hinge.sections"] = "section", ["hinge.materials"] = "material", ["hinge.backbones"] = "backbone",
  ["hinge.heats"] = "heat", ["hinge.blasts"] = "blast", ["hinge.joints"] = "joint",
  ["hinge.moving_loads"] = "moving_load", ["hinge.results"] = "results",
  ["hinge.records"] = "record", ["hinge.imports"] = "import" }

--- How a function is called, as in "model:node(position)".
function reference.signature(f)
  local arguments = {}
  for _, p in ipairs(f.params) do arguments[#arguments + 1] = p.name .. (p.optional and "?" or "") end
  local before = reference.tables[f.object] and "hinge." or ""
  return ("%s%s%s%s(%s)"):format(before, f.variable, f.separator, f.name, table.concat(arguments, ", "))
end

-- A paragraph or an item of a list, broken into lines of at most 120 columns: at blanks outside of `code`, and not
-- before what Markdown would take for the mark of a list.
function reference.wrapped(text)
  local indent = text:find "^%- " and "  " or ""
  local lines, line = {}, nil
  local words = text:gsub("`[^`]*`", function(code) return (code:gsub(" ", "\0")) end)
  words = words:gsub(" ([-+*]) ", "\0%1 "):gsub(" (%d+%.) ", "\0%1 ")
  for word in words:gmatch "[^ ]+" do
    if line and utf8.len(line) + 1 + utf8.len(word) > 120 then
      lines[#lines + 1] = line
      line = indent .. word
    else
      line = line and line .. " " .. word or word
    end
  end
  lines[#lines + 1] = line
  return (table.concat(lines, "\n"):gsub("\0", " "))
end

local function line_of(item)
  local about = item.doc ~= "" and " — " .. item.doc or ""
  return ("- `%s%s`: `%s`%s"):format(item.name, item.optional and "?" or "", item.type, about)
end

--- A field as an item of a list.
function reference.field(field) return reference.wrapped(line_of(field)) end

local writers = {
  heading = function(e) return { "## " .. (e.module and ('`require "%s"`'):format(e.module) or e.text) } end,
  alias = function(e)
    return { ("### `%s`"):format(e.name), "", ("`%s`%s"):format(e.type, e.doc ~= "" and " — " .. e.doc or "") }
  end,
  class = function(e)
    local lines = { ("### `%s`"):format(e.name) }
    if e.doc ~= "" then table.move({ "", e.doc }, 1, 2, #lines + 1, lines) end
    if #e.fields > 0 then lines[#lines + 1] = "" end
    for _, field in ipairs(e.fields) do lines[#lines + 1] = line_of(field) end
    return lines
  end,
  ["function"] = function(e)
    local lines = { ("#### `%s`"):format(reference.signature(e)) }
    if e.doc ~= "" then table.move({ "", e.doc }, 1, 2, #lines + 1, lines) end
    if #e.params + #e.returns > 0 then lines[#lines + 1] = "" end
    for _, p in ipairs(e.params) do lines[#lines + 1] = line_of(p) end
    for _, text in ipairs(e.returns) do
      local kind, about = split_type(text)
      lines[#lines + 1] = ("- returns `%s`%s"):format(kind, about ~= "" and " " .. about or "")
    end
    return lines
  end,
}

--- What the examples start from. In examples `job` is what a scenario's run gets.
reference.preamble = [[
local hinge = require "hinge"
local steel = hinge.material { E = 206e9, density = 7850, yield_stress = 245e6 }
local square = hinge.section.solid { width = 0.05, depth = 0.05 }
local model = hinge.model()
local wall, tip = model:node { 0, 0, 0 }, model:node { 1, 0, 0 }
model:fix(wall)
local beam = model:member { wall, tip, section = square, material = steel, group = "arm" }
model:load { node = tip, force = { 0, 0, -1000 } }
local run = model:static():finish()
local plan = hinge.grid { model = hinge.model(), x = { 0, 6 }, z = { 0, 3 } }]]

local opening = [[
# Reference

Every call, as `hinge reference` prints it from lua/hinge/hinge.d.lua and the files of lua/hinge/words. Units are SI
throughout: m, kg, s, N, Pa, rad. A `?` marks what may be left out; options are given by name, as in
`hinge.material { E = 206e9 }`. Wrong input is an error at the script's own line; what goes wrong in the physics or the
numbers is a result: see `verdict` of a run. "eq" and "section" refer to Lynn and Isobe's paper on the ASI-Gauss
technique.

Every example runs as it stands after these lines, a cantilever 1 m long with 1 kN at its tip, and the grid of
a portal. `job` is the second argument of a scenario's run.

```lua
]] .. reference.preamble .. "\n```\n"

--- An entry as Markdown.
function reference.text(e)
  local lines = writers[e.kind](e)
  for i, line in ipairs(lines) do lines[i] = reference.wrapped(line) end
  if e.example then lines[#lines + 1] = "\n```lua\n" .. e.example .. "\n```" end
  return table.concat(lines, "\n") .. "\n"
end

--- The page.
function reference.page()
  local parts = { opening }
  for _, e in ipairs(reference.read()) do parts[#parts + 1] = reference.text(e) end
  return table.concat(parts, "\n")
end

return reference
