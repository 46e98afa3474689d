-- import.tcl: a frame from a script of OpenSees, in Tcl or in Python. This file follows Tcl: set, expr, for, foreach,
-- while, if, incr, lists, format, source. What it does not follow is noted with its line.
local check = require "hinge.check"
local core = require "hinge.core"
local expression = require "hinge.import.tcl_expression"
local notes = require "hinge.import.notes"
local opensees = require "hinge.import.opensees"

local where = "hinge.import.tcl"
local most_commands = 200000 -- of one script, so that an endless loop ends
local beyond = expression.beyond

local Script = {}
Script.__index = Script

-- Text to words -------------------------------------------------------------------------------------------------------

local function fail(self, at, ...) notes.fail(where, { file = self.file, line = self:line(at) }, ...) end

-- The line of a place in the text; places mostly rise.
function Script:line(at)
  if at < self.last_at then self.last_at, self.last_line = 1, self.first_line end
  local _, more = self.text:sub(self.last_at, at - 1):gsub("\n", "")
  self.last_at, self.last_line = at, self.last_line + more
  return self.last_line
end

-- The place after the brace that closes the one at `at`.
function Script:closing_brace(at)
  local depth, from = 0, at
  while true do
    at = self.text:find("[{}\\]", at)
    if not at then fail(self, from, "the brace { is not closed") end
    local c = self.text:sub(at, at)
    if c == "\\" then at = at + 1 elseif c == "{" then depth = depth + 1 else depth = depth - 1 end
    at = at + 1
    if depth == 0 then return at end
  end
end

-- A list of Tcl as a table.
local function list_of(text)
  local items, at = {}, 1
  while true do
    at = text:match("^%s*()", at)
    if at > #text then return items end
    local c = text:sub(at, at)
    local item, after
    if c == "{" then
      item, after = text:match("^(%b{})()", at)
      if not item then beyond("'%s' is not a list", text) end
      item = item:sub(2, -2)
    elseif c == '"' then
      item, after = text:match('^"([^"]*)"()', at)
      if not item then beyond("'%s' is not a list", text) end
    else
      item, after = text:match("^(%S+)()", at)
    end
    items[#items + 1], at = item, after
  end
end

local escapes = { n = "\n", t = "\t", ["\n"] = " " }

-- What grows without bound ends the script.
function Script:refuse_long(text)
  if #text > notes.most_text then
    notes.fail(where, { file = self.file, line = self.current }, "a value has more than %d characters", notes.most_text)
  end
end

-- The value of a variable by its name, which may have an index: a(1,2).
function Script:variable(name)
  local value = self.shared.variables[name]
  if value == nil then beyond("the variable %s has no value", name) end
  return value
end

-- $name, ${name}, $name(index): its value and the place after it.
function Script:dollar(at)
  local name, after = self.text:match("^%${([^}]*)}()", at)
  if name then return self:variable(name), after end
  name, after = self.text:match("^%$([%w_:]+)()", at)
  if not name then return "$", at + 1 end
  if self.text:sub(after, after) == "(" then
    local index
    index, after = self:substituted(after + 1, "^%)")
    if self.text:sub(after, after) ~= ")" then fail(self, at, "the index of %s is not closed", name) end
    return self:variable(name .. "(" .. index .. ")"), after + 1
  end
  return self:variable(name), after
end

-- A piece of text that begins with $, [ or \: what it stands for, and the place after it.
function Script:piece(at)
  local c = self.text:sub(at, at)
  if c == "$" then return self:dollar(at) end
  if c == "[" then return self:commands(at + 1, true) end
  local next = self.text:sub(at + 1, at + 1)
  if next == "\n" then return " ", self.text:match("^[ \t]*()", at + 2) end
  return escapes[next] or next, at + 2
end

-- Text with substitutions up to a pattern: the text, and the place of what fits the pattern.
function Script:substituted(at, stop)
  local parts = {}
  while at <= #self.text and not self.text:find(stop, at) do
    local plain = self.text:match("^[%w_.+-]+", at)
    if plain then
      parts[#parts + 1], at = plain, at + #plain
    elseif self.text:find("^[%$%[\\]", at) then
      parts[#parts + 1], at = self:piece(at)
    else
      parts[#parts + 1] = self.text:sub(at, at)
      at = at + 1
    end
  end
  local text = table.concat(parts)
  self:refuse_long(text)
  return text, at
end

-- One word: its text, the place after it, and whether it stood in braces.
function Script:word(at, ends)
  local c = self.text:sub(at, at)
  if c == "{" then
    local after = self:closing_brace(at)
    return self.text:sub(at + 1, after - 2):gsub("\\\n[ \t]*", " "), after, true
  elseif c == '"' then
    local text, after = self:substituted(at + 1, '^"')
    if after > #self.text then fail(self, at, "the quotes are not closed") end
    return text, after + 1
  end
  return self:substituted(at, ends)
end

-- Skips blanks, ends of lines and comments before a command.
function Script:skip(at)
  while true do
    if at > #self.text then return at end
    at = self.text:match("^[%s;]*()", at)
    if self.text:sub(at, at) ~= "#" then return at end
    repeat
      local stop = self.text:find("\n", at, true) or #self.text + 1
      local goes_on = self.text:sub(stop - 1, stop - 1) == "\\"
      at = stop + 1
    until not goes_on
  end
end

-- The place where a command ends that cannot be followed: the end of its line or of its braces.
function Script:end_of(at)
  while at <= #self.text do
    local c = self.text:sub(at, at)
    if c == "\n" or c == ";" then return at end
    if c == "{" then at = self:closing_brace(at)
    elseif c == "\\" then at = at + 2
    else at = at + 1 end
  end
  return at
end

-- The words of the command at a place: a list of { text =, at =, braces = }, and the place after it.
function Script:words(at, within)
  local words = {}
  local ends = within and "^[%s;%]]" or "^[%s;]"
  while true do
    local apart, after = self.text:match("^([ \t]*)()", at)
    while self.text:find("^\\\n", after) do after, apart = self.text:match("^[ \t]*()", after + 2), " " end
    if after > #self.text or self.text:find("^[\n;]", after) or within and self.text:find("^%]", after) then
      return words, after
    end
    if #words > 0 and apart == "" then fail(self, after, "there is no blank after a brace or a quotation mark") end
    local list = self.text:match("^{%*}()", after)
    local text, stop, braces = self:word(list or after, ends)
    if list then
      for _, item in ipairs(list_of(text)) do words[#words + 1] = { text = item, at = after } end
    else
      words[#words + 1] = { text = text, at = after, braces = braces }
    end
    at = stop
  end
end

-- Built-in commands ---------------------------------------------------------------------------------------------------

local builtin = {}

local function texts(words)
  local list = {}
  for i = 2, #words do list[#list + 1] = words[i].text end
  return list
end

-- The value of an expression in the text of a word.
function Script:evaluate(text)
  return expression.value(text, function(whole, at)
    local inner = self:inner(whole, self.current)
    if whole:sub(at, at) == '"' then
      local value, after = inner:substituted(at + 1, '^"')
      return value, after + 1
    end
    return inner:piece(at)
  end)
end

function Script:is_true(text) return expression.truth(self:evaluate(text)) end

-- Runs the text of a word as a script; its lines are those of the file.
function Script:body(word)
  local line = self:line(word.at)
  self:inner(word.text, line):commands(1, false)
end

local function joined(list)
  local parts = {}
  for i, value in ipairs(list) do parts[i] = value:find "^[^%s{}\"]+$" and value or "{" .. value .. "}" end
  return table.concat(parts, " ")
end

function builtin.set(self, words)
  local name = words[2] and words[2].text or beyond "set has no variable"
  if words[3] then self.shared.variables[name] = words[3].text end
  return self:variable(name)
end

function builtin.expr(self, words) return expression.text(self:evaluate(table.concat(texts(words), " "))) end

function builtin.incr(self, words)
  local name = words[2].text
  local by = words[3] and math.tointeger(tonumber(words[3].text)) or 1
  local value = math.tointeger(tonumber(self.shared.variables[name] or "0"))
  if not value then beyond("the variable %s is not a whole number", name) end
  self.shared.variables[name] = ("%d"):format(value + by)
  return self.shared.variables[name]
end

function builtin.list(_, words) return joined(texts(words)) end
function builtin.concat(_, words) return table.concat(texts(words), " ") end
function builtin.llength(_, words) return ("%d"):format(#list_of(words[2].text)) end

function builtin.lindex(_, words)
  local list = list_of(words[2].text)
  local at = words[3] and (words[3].text == "end" and #list - 1 or math.tointeger(tonumber(words[3].text)))
  if not at or words[4] then beyond "lindex is followed with one whole number" end
  return list[at + 1] or ""
end

function builtin.lappend(self, words)
  local name = words[2].text
  local list = list_of(self.shared.variables[name] or "")
  for i = 3, #words do list[#list + 1] = words[i].text end
  self.shared.variables[name] = joined(list)
  self:refuse_long(self.shared.variables[name])
  return self.shared.variables[name]
end

function builtin.append(self, words)
  local name = words[2].text
  local values = texts(words)
  table.remove(values, 1)
  self.shared.variables[name] = (self.shared.variables[name] or "") .. table.concat(values)
  self:refuse_long(self.shared.variables[name])
  return self.shared.variables[name]
end

builtin["format"] = function(_, words)
  local values = texts(words)
  local form = table.remove(values, 1) or ""
  local index = 0
  for kind in form:gsub("%%%%", ""):gmatch "%%[%d.+# -]*(%a)" do
    index = index + 1
    if kind:find "[diux]" then values[index] = math.tointeger(tonumber(values[index])) end
    if kind:find "[eEfgG]" then values[index] = tonumber(values[index]) end
  end
  local good, text = pcall(string.format, form:gsub("%%([%d.+# -]*)i", "%%%1d"), table.unpack(values, 1, index))
  if not good then beyond "format cannot take its arguments" end
  return text
end

-- The error that `break` and `continue` raise in a loop.
local leave = { ["break"] = { leave = "break" }, continue = { leave = "continue" } }
builtin["break"] = function() error(leave["break"], 0) end
builtin.continue = function() error(leave.continue, 0) end

-- Runs the body of a loop; true where it ends the loop.
function Script:turn(word)
  local good, problem = pcall(self.body, self, word)
  if good or problem == leave.continue then return false end
  if problem == leave["break"] then return true end
  error(problem, 0)
end

builtin["for"] = function(self, words)
  if #words ~= 5 then beyond "for has not four arguments" end
  self:body(words[2])
  while self:is_true(words[3].text) do
    if self:turn(words[5]) then break end
    self:body(words[4])
    self:count()
  end
end

builtin["while"] = function(self, words)
  if #words ~= 3 then beyond "while has not two arguments" end
  while self:is_true(words[2].text) do
    self:count()
    if self:turn(words[3]) then break end
  end
end

function builtin.foreach(self, words)
  if #words < 4 or #words % 2 ~= 0 then beyond "foreach has no list" end
  local names, lists, turns = {}, {}, 0
  for i = 2, #words - 1, 2 do
    local of, list = list_of(words[i].text), list_of(words[i + 1].text)
    names[#names + 1], lists[#lists + 1] = of, list
    turns = math.max(turns, math.ceil(#list / #of))
  end
  for turn = 1, turns do
    for k, of in ipairs(names) do
      for i, name in ipairs(of) do self.shared.variables[name] = lists[k][(turn - 1) * #of + i] or "" end
    end
    self:count()
    if self:turn(words[#words]) then break end
  end
end

builtin["if"] = function(self, words)
  local i = 2
  while true do
    local condition = words[i]
    if not condition then beyond "if has no condition" end
    i = i + 1
    if words[i] and words[i].text == "then" then i = i + 1 end
    if not words[i] then beyond "if has no body" end
    if self:is_true(condition.text) then return self:body(words[i]) end
    i = i + 1
    local word = words[i]
    if not word then return end
    if word.text == "elseif" then
      i = i + 1
    else
      return self:body(word.text == "else" and words[i + 1] or word)
    end
  end
end

builtin["proc"] = function(_, words) beyond("the procedure %s is not followed", words[2] and words[2].text or "") end

function builtin.source(self, words)
  local name = words[2] and words[2].text or beyond "source has no file"
  local path = name:find "^/" and name or (self.file:match "^(.*/)" or "") .. name
  if self.depth > 15 then beyond "files that source each other are not followed" end
  if not core.file_size(path) then beyond("the file %s cannot be read", path) end
  local inner = self:inner(notes.read(where, path), 1)
  inner.file, inner.depth = path, self.depth + 1
  inner:commands(1, false)
end

-- Running -------------------------------------------------------------------------------------------------------------

function Script:count()
  self.shared.count = self.shared.count + 1
  if self.shared.count > most_commands then
    notes.fail(where, { file = self.file, line = self.current }, "the script runs more than %d commands", most_commands)
  end
end

-- The same script with another text, which begins at a line of the file.
function Script:inner(text, line)
  return setmetatable({ text = text, first_line = line, last_line = line, last_at = 1, file = self.file,
    depth = self.depth, reader = self.reader, shared = self.shared, current = line }, Script)
end

-- A command of OpenSees. The loads of a pattern stand in braces.
function Script:opensees(name, words, place)
  local last = words[#words]
  if (name == "pattern" or name == "section") and last.braces then
    words = table.move(words, 1, #words - 1, 1, {})
    self.reader:run(name, texts(words), place)
    self:body(last)
    if name == "pattern" then self.reader.case = nil end -- loads after the braces belong to no pattern
    return
  end
  self.reader:run(name, texts(words), place)
end

-- Runs the command at a place; its value, and the place after it.
function Script:command(at, within)
  local line = self:line(at)
  self.current = line
  self:count()
  local words, after = self:words(at, within)
  local name = words[1].text
  if builtin[name] then return builtin[name](self, words), after end
  if within then
    error({ beyond = ("the value of the command %s is not known"):format(name), beside = self.reader.beside[name] }, 0)
  end
  self:opensees(name, words, { file = self.file, line = line, text = self.text:sub(at, after - 1) })
  return "", after
end

-- Runs the commands from a place on, up to the ] that closes them; the value of the last one, and the place after it.
function Script:commands(at, within)
  local value, from = "", at - 1
  while true do
    at = self:skip(at)
    if within and self.text:sub(at, at) == "]" then return value or "", at + 1 end
    if at > #self.text then
      if within then fail(self, from, "the bracket [ is not closed") end
      return value or "", at
    end
    if within then
      value, at = self:command(at, true)
    else
      value, at = self:noted(at)
    end
  end
end

-- Runs one command; where it cannot be followed, notes it, and the variable that it would set has no value.
function Script:noted(at)
  local line = self:line(at)
  local good, value, after = pcall(self.command, self, at, false)
  if good then return value, after end
  if type(value) ~= "table" or not value.beyond then error(value, 0) end
  after = self:end_of(at)
  local text = self.text:sub(at, after - 1)
  local name = text:match "^set%s+(%S+)" or text:match "^incr%s+(%S+)" or text:match "^l?append%s+(%S+)"
  if name then self.shared.variables[name] = nil end
  local place, lines = { file = self.file, line = line, text = text }, select(2, text:gsub("\n", ""))
  if value.beside then
    notes.add(self.reader.notes.skipped, place, text)
  else
    self.reader:lost(place, value.beyond, lines)
  end
  return "", after
end

-- import.tcl ----------------------------------------------------------------------------------------------------------

return function(options, ...)
  check.no_more(where, ...)
  local o = check.options(where, options, { file = { "string" }, units = { "table", optional = true },
    model = { "number", whole = true, at_least = 1, optional = true },
    language = { "string", one_of = { "tcl", "python" }, optional = true } })
  local reader = opensees.new(where, o.file, o.units, o.model)
  local text = notes.read(where, o.file)
  local python = o.language == "python" or not o.language and o.file:find "%.py$"
  if python then
    notes.within_limits(where, o.file, function() require "hinge.import.python"(where, reader, o.file, text) end)
  else
    local script = setmetatable({ file = o.file, depth = 0, reader = reader, shared = { variables = {}, count = 0 } },
      Script)
    notes.within_limits(where, o.file, function() script:inner(text, 1):commands(1, false) end)
  end
  return reader:finish()
end
