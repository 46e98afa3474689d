-- The text of a Python script as statements: { line =, text =, tokens =, body = statements of its block, or nil }.
-- A token is { kind = "number", "name", "string", "f-string" or "op", value =, line = }.
local notes = require "hinge.import.notes"

local opening, closing = { ["("] = true, ["["] = true, ["{"] = true }, { [")"] = true, ["]"] = true, ["}"] = true }
local operators = { "^%*%*=", "^//=", "^%*%*", "^//", "^[-+*/%%<>=!]=", "^[-+*/%%<>=%(%)%[%]{}.,:;@]" }
local numbers = { "^0[xX]%x+", "^%d[%d_]*%.?[%d_]*[eE][+-]?%d+", "^%.%d+[eE][+-]?%d+", "^%d[%d_]*%.?[%d_]*",
  "^%.%d[%d_]*" }

local escapes = { n = "\n", t = "\t", ["\n"] = "" }

-- The token that begins at a place: its kind, value, and the place after it; nil for what is no token of Python.
local function token_at(text, at)
  local prefix, quote, after = text:match("^([rRbBuUfF]?[rRbBfF]?)(['\"])()", at)
  if prefix then
    if text:sub(after, after + 1) == quote .. quote then quote, after = quote .. quote .. quote, after + 2 end
    local stop = after
    while text:sub(stop, stop + #quote - 1) ~= quote do
      if stop > #text or #quote == 1 and text:sub(stop, stop) == "\n" then return "open", "string", stop end
      stop = stop + (text:sub(stop, stop) == "\\" and 2 or 1)
    end
    local value = text:sub(after, stop - 1)
    if not prefix:find "[rR]" then value = value:gsub("\\(.)", function(c) return escapes[c] or c end) end
    return prefix:find "[fF]" and "f-string" or "string", value, stop + #quote
  end
  for _, pattern in ipairs(numbers) do
    local found = text:match(pattern, at)
    if found and not text:find("^[%w_]", at + #found) then
      return "number", tonumber((found:gsub("_", ""))), at + #found
    end
  end
  local name = text:match("^[%a_\128-\255][%w_\128-\255]*", at)
  if name then return "name", name, at + #name end
  for _, pattern in ipairs(operators) do
    local found = text:match(pattern, at)
    if found then return "op", found, at + #found end
  end
end

local deepest = 100 -- brackets, and blocks, within each other; Python itself takes 200 and 100

-- Lines that end outside of brackets: { indent =, line =, text =, tokens = }.
local function logical_lines(where, file, text)
  local lines, current, depth, at, line = {}, nil, {}, 1, 1
  local function fail(...) notes.fail(where, { file = file, line = line }, ...) end
  local indent = #(text:match "^[ \t]*":gsub("\t", "        "))
  local function finish(stop)
    if current then
      current.text = text:sub(current.from, stop)
      lines[#lines + 1], current = current, nil
    end
  end
  while at <= #text do
    local c = text:sub(at, at)
    if c == "\n" then
      if #depth == 0 then
        finish(at - 1)
        indent = #(text:match("^[ \t]*", at + 1):gsub("\t", "        "))
      end
      at, line = at + 1, line + 1
    elseif c == "\\" and text:sub(at + 1, at + 1) == "\n" then
      at, line = at + 2, line + 1
    elseif c:find "%s" then
      at = at + 1
    elseif c == "#" then
      at = text:find("\n", at, true) or #text + 1
    else
      local kind, value, after = token_at(text, at)
      if kind == "open" then fail "the quotes are not closed" end
      if not kind then fail("'%s' is no part of Python", c) end
      current = current or { indent = indent, line = line, from = at, tokens = {} }
      table.insert(current.tokens, { kind = kind, value = value, line = line, from = at, to = after - 1 })
      if kind == "op" and opening[value] then depth[#depth + 1] = line end
      if #depth > deepest then fail("more than %d brackets are within each other", deepest) end
      if kind == "op" and closing[value] then
        if #depth == 0 then fail("the bracket %s closes nothing", value) end
        depth[#depth] = nil
      end
      local _, more = text:sub(at, after - 1):gsub("\n", "")
      at, line = after, line + more
    end
  end
  if #depth > 0 then
    line = depth[#depth]
    fail "a bracket is not closed"
  end
  finish(#text)
  return lines
end

local compound = {}
for word in ("for while if elif else def class with try except finally async"):gmatch "%a+" do compound[word] = true end

-- The place of a token outside of brackets, or nil.
local function find(tokens, value, from)
  local depth = 0
  for i = from or 1, #tokens do
    local t = tokens[i]
    if t.kind == "op" and opening[t.value] then depth = depth + 1 end
    if t.kind == "op" and closing[t.value] then depth = depth - 1 end
    if depth == 0 and t.value == value and (t.kind == "op" or t.kind == "name") then return i end
  end
end

-- A logical line as statements: "a = 1; b = 2", "for i in range(3): f(i)".
local function split(logical, text)
  local list, tokens = {}, logical.tokens
  local first = tokens[1].kind == "name" and tokens[1].value
  if compound[first] then
    local colon = find(tokens, ":")
    local head = { line = logical.line, text = logical.text, word = first, indent = logical.indent, body = {},
      tokens = table.move(tokens, 1, (colon or #tokens + 1) - 1, 1, {}) }
    if colon and colon < #tokens then
      local rest = { line = logical.line, tokens = table.move(tokens, colon + 1, #tokens, 1, {}),
        indent = logical.indent + 1 }
      rest.text = text:sub(rest.tokens[1].from, rest.tokens[#rest.tokens].to)
      head.body, head.whole = split(rest, text), true
    end
    return { head }
  end
  local from = 1
  while from <= #tokens do
    local stop = find(tokens, ";", from) or #tokens + 1
    local own = table.move(tokens, from, stop - 1, 1, {})
    if #own > 0 then
      list[#list + 1] = { line = own[1].line, text = text:sub(own[1].from, own[#own].to), tokens = own,
        indent = logical.indent }
    end
    from = stop + 1
  end
  return list
end

local module = { find = find }

--- The statements of a script, with blocks.
function module.statements(where, file, text)
  local top = {}
  local blocks = { { indent = 0, list = top } }
  for _, logical in ipairs(logical_lines(where, file, text)) do
    local last = blocks[#blocks].list[#blocks[#blocks].list]
    if logical.indent > blocks[#blocks].indent then
      if not (last and last.body and not last.whole and #last.body == 0) then
        notes.fail(where, { file = file, line = logical.line }, "the line is indented, and no block begins before it")
      end
      if #blocks > deepest then
        notes.fail(where, { file = file, line = logical.line }, "more than %d blocks are within each other", deepest)
      end
      blocks[#blocks + 1] = { indent = logical.indent, list = last.body }
    else
      while logical.indent < blocks[#blocks].indent do blocks[#blocks] = nil end
      if logical.indent ~= blocks[#blocks].indent then
        notes.fail(where, { file = file, line = logical.line }, "the indentation fits no line above")
      end
    end
    for _, statement in ipairs(split(logical, text)) do table.insert(blocks[#blocks].list, statement) end
  end
  return top
end

return module
