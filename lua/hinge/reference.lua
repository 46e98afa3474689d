-- hinge reference: what hinge.d.lua and library.d.lua declare, as a page. `lua5.4 lua/hinge/reference.lua` writes reference.md anew.
local folder = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$"

local reference = { files = { "hinge.d.lua", "library.d.lua" } }

-- A type and what follows it: types may hold blanks inside brackets, and after the `:` of a function's result.
local function split_type(text)
  local depth = 0
  for at = 1, #text do
    local c = text:sub(at, at)
    if c:find "[%[{(<]" then depth = depth + 1 elseif c:find "[%]})>]" then depth = depth - 1 end
    if c == " " and depth == 0 and not text:sub(1, at - 1):find "[:,]$" then return text:sub(1, at - 1), text:sub(at + 1) end
  end
  return text, ""
end

--- The fields of a table type such as "{ a: number, b?: string }": { { name =, type =, optional = }, ... }; nil for other types.
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

--- The declarations in their order: a list of entries, each with `kind` and `line` ("hinge.d.lua:12"):
-- heading (text, module), alias and class (name, type, doc; fields), and function (name, object, separator, arguments, params,
-- returns, doc). A field or a param has name, optional, type, doc.
function reference.read()
  local entries = {}
  for _, name in ipairs(reference.files) do
    local number, doc, params, returns, class, class_of = 0, {}, {}, {}, nil, {}
    local function add(entry)
      entry.doc = table.concat(doc, " ") .. (entry.doc and entry.doc ~= "" and (#doc > 0 and " " or "") .. entry.doc or "")
      entry.line = ("%s:%d"):format(name, number)
      doc, entries[#entries + 1] = {}, entry
      return entry
    end
    local function item(text)
      local word, optional, rest = text:match "^(%S-)(%??) (.*)$"
      local kind, about = split_type(rest)
      return { name = word, optional = optional == "?" or kind:find "%?$" ~= nil, type = (kind:gsub("%?$", "")), doc = about, line = ("%s:%d"):format(name, number) }
    end
    for line in io.lines(folder .. name) do
      number = number + 1
      local tag, text = line:match "^%-%-%-@(%a+) ?(.*)$"
      local called, arguments = line:match "^function ([%w_.:]+)%((.-)%) end"
      if tag == "class" then
        local word, about = text:match "^(%S+) ?(.*)$"
        class = add { kind = "class", name = word, doc = about, fields = {} }
      elseif tag == "alias" then
        local word, rest = text:match "^(%S+) (.*)$"
        local kind, about = split_type(rest)
        add { kind = "alias", name = word, type = kind, doc = about }
      elseif tag == "field" then table.insert(class.fields, item(text))
      elseif tag == "param" then params[#params + 1] = item(text)
      elseif tag == "return" then returns[#returns + 1] = text
      elseif line:find "^%-%-%- ?" and not tag then doc[#doc + 1] = line:match "^%-%-%- ?(.*)$"
      elseif called then
        local variable, separator, own = called:match "^([%w_]+)([.:])([%w_]+)$"
        add { kind = "function", name = own, object = class_of[variable], variable = variable, separator = separator, arguments = arguments,
          params = params, returns = returns }
        params, returns = {}, {}
      elseif line:find "^local [%w_]+ = {}" then class_of[line:match "^local ([%w_]+)"] = class.name
      elseif line:find "^%-%- .- %-%-%-%-+$" then
        local text = line:match "^%-%- (.-) %-%-%-%-+$"
        add { kind = "heading", text = text, module = text:match 'require "(.-)"' }
      end
    end
  end
  return entries
end

--- How a function is called, as in "model:node(position)".
function reference.signature(f)
  local arguments = {}
  for _, p in ipairs(f.params) do arguments[#arguments + 1] = p.name .. (p.optional and "?" or "") end
  local sections = f.object == "hinge.sections" and "hinge." or ""
  return ("%s%s%s%s(%s)"):format(sections, f.variable, f.separator, f.name, table.concat(arguments, ", "))
end

local function line_of(item)
  local about = item.doc ~= "" and " — " .. item.doc or ""
  return ("- `%s%s`: `%s`%s"):format(item.name, item.optional and "?" or "", item.type, about)
end

local writers = {
  heading = function(e) return { "## " .. (e.module and ('`require "%s"`'):format(e.module) or e.text) } end,
  alias = function(e) return { ("### `%s`"):format(e.name), "", ("`%s`%s"):format(e.type, e.doc ~= "" and " — " .. e.doc or "") } end,
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

local opening = [[
# Reference

Every call, made from [hinge.d.lua](hinge.d.lua) and [library.d.lua](library.d.lua) by `lua5.4 lua/hinge/reference.lua`. Units are
SI throughout: m, kg, s, N, Pa, rad. A `?` marks what may be left out; options are given by name, as in
`hinge.material { E = 206e9 }`. Wrong input is an error at the script's own line; what goes wrong in the physics or the numbers is a
result: see `verdict` of a run. "eq" and "section" refer to Lynn and Isobe's paper on the ASI-Gauss technique.
]]

--- The page, or what of it speaks of `name`: a function's or class's own name, such as "material", "model:node", "hinge.run".
function reference.page(name)
  local parts = { not name and opening or nil }
  for _, e in ipairs(reference.read()) do
    local call = e.kind == "function" and reference.signature(e):match "^[^(]*"
    if not name or e.name == name or call == name or (e.object or "") == name then
      parts[#parts + 1] = table.concat(writers[e.kind](e), "\n") .. "\n"
    end
  end
  return table.concat(parts, "\n")
end

--- Prints the page; options.code: the name that it is to speak of. Returns the exit status.
function reference.main(options)
  local page = reference.page(options.code)
  if page == "" then
    io.stderr:write(("hinge: nothing is called '%s'; `hinge reference` prints everything\n"):format(options.code))
    return 2
  end
  io.write(page)
  return 0
end

if ... == "hinge.reference" then return reference end
local file = assert(io.open(folder .. "reference.md", "w"))
assert(file:write(reference.page()))
assert(file:close())
