-- Arguments of a command of OpenSees: numbers, tags, options, and what they refer to. Each function takes the reader,
-- which knows the command that runs now and its place in the file.
local notes = require "hinge.import.notes"

local arguments = {}

--- Ends the command that runs now: a note has the reason, and the file goes on.
function arguments.give_up(reason, ...)
  error({ not_read = select("#", ...) > 0 and reason:format(...) or reason }, 0)
end

--- The same for what follows from a line that was not read: one note for all that do.
function arguments.follows(reason, ...) error({ not_read = reason:format(...), follows = true }, 0) end

--- Notes once for each reason what the file says otherwise or not at all, and what is taken.
function arguments.assume(self, reason, ...)
  notes.once(self.notes.assumed, self.place, self.place.text, select("#", ...) > 0 and reason:format(...) or reason)
end

function arguments.number(self, text, what)
  if text == "\0" or text == "unknown" then arguments.give_up("%s hangs on a result of the analysis", what) end
  local x = tonumber(text)
  if not x or x ~= x or math.abs(x) == math.huge then
    self:fail("%s is %s; must be a number", what, text == nil and "missing" or "'" .. text .. "'")
  end
  return x
end

--- A tag as text: 5 and 5.0 are the same.
function arguments.tag(self, text, what)
  local x = arguments.number(self, text, what)
  if not math.tointeger(x) then self:fail("%s is '%s'; must be a whole number", what, text) end
  return ("%d"):format(math.tointeger(x))
end

function arguments.numbers(self, args, from, to, what)
  local list = {}
  for i = from, to do list[#list + 1] = arguments.number(self, args[i], ("%s %d"):format(what, i - from + 1)) end
  return list
end

--- How many arguments stand before the first option, such as -mass.
function arguments.positional(args)
  for i, text in ipairs(args) do
    if text:find "^%-%a" then return i - 1 end
  end
  return #args
end

--- The place of an option among the arguments, or nil. Several names: those that mean the same.
function arguments.option(args, ...)
  for i, text in ipairs(args) do
    for _, name in ipairs { ... } do
      if text == name then return i end
    end
  end
end

--- The number behind an option, or nil where the option is not there.
function arguments.number_of(self, args, ...)
  local i = arguments.option(args, ...)
  return i and arguments.number(self, args[i + 1], args[i])
end

--- The texts behind an option, up to the next one; nil where the option is not there.
function arguments.list_of(args, ...)
  local i = arguments.option(args, ...)
  if not i then return nil end
  local list = {}
  for k = i + 1, #args do
    if args[k]:find "^%-%a" then break end
    for word in args[k]:gmatch "[^%s,{}]+" do list[#list + 1] = word end
  end
  return list
end

--- Notes the options of a command that are not among those that are known.
function arguments.other_options(self, args, known)
  for _, text in ipairs(args) do
    if text:find "^%-%a" and not known[text] then self:not_read(("%s is not read"):format(text)) end
  end
end

--- An object of the script by its tag. The command ends with a note where something was not read before; else an error.
function arguments.find(self, kind, name)
  local found = self[kind][name]
  if found and not found.unread then return found end
  if found then
    arguments.follows("its %s %s was not read, see line %d", kind, name, found.unread.line)
  elseif self.incomplete > 0 then
    arguments.follows("%s %s is not there; a line that was not read may make it", kind, name)
  end
  self:fail("%s %s is not there", kind, name)
end

function arguments.is_new(self, kind, name)
  if self[kind][name] then self:fail("%s %s is there twice", kind, name) end
end

--- The number of dimensions, 2 or 3.
function arguments.dimensions(self)
  if not self.ndm then self:fail("the command stands before: model BasicBuilder -ndm ... -ndf ...") end
  return self.ndm
end

-- What the degrees of freedom of the file are here, and how they turn.
arguments.freedoms = { [2] = { "x", "z", "ry" }, [3] = { "x", "y", "z", "rx", "ry", "rz" } }

return arguments
