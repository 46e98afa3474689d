-- The prompt, and a line of code from the command line. Only there `hinge` and `help` are globals.
local core = require "hinge.core"
local parameters_of = require "hinge.program.parameters".of
local readable = require "hinge.library.readable"
local runner = require "hinge.program.runner"

local prompt = {}

-- The text as a function, first as an expression. If it is neither expression nor statement: nil, the error, and
-- whether more text could complete it.
local function compile(text, name)
  local expression, lacking = load("return " .. text, name, "t")
  if expression then return expression end
  local statement, problem = load(text, name, "t")
  if statement then return statement end
  return nil, problem, (problem:find "<eof>$" or lacking:find "<eof>$") ~= nil
end

-- The globals at the prompt. A `help` that the script has defined stays.
local function set_globals()
  _G.hinge = require "hinge"
  if rawget(_G, "help") == nil then _G.help = require "hinge.program.help".at_prompt end
end

-- Runs it and prints what it returns. A list of items holds nils too.
local function evaluate(chunk, ...)
  local results = table.pack(chunk(...))
  if results.n > 0 then print(readable(table.unpack(results, 1, results.n))) end
end

--- hinge -e: runs options.code with the settings in a table, `...`, and prints what it
-- returns. Returns the exit status.
function prompt.line(options)
  return runner.guard(function()
    set_globals()
    local chunk, problem = compile(options.code or "", "=(command line)")
    if not chunk then core.input_error(problem) end
    local _, plain = parameters_of(options.overrides, "the line", options.code)
    evaluate(chunk, plain)
    return runner.status(core.write_summary {})
  end)
end

-- Completion ----------------------------------------------------------------------------------------------------------

local keywords = { "and", "break", "do", "else", "elseif", "end", "false", "for", "function", "goto", "if", "in",
  "local", "nil", "not", "or", "repeat", "return", "then", "true", "until", "while" }

-- Names of the fields and methods of a value. methods: only those that can be called.
local function names_of(value, methods)
  local names = {}
  local function add(map)
    for name, field in next, map do
      if type(name) == "string" and name:find "^[%a_][%w_]*$" and (not methods or type(field) == "function") then
        names[name] = true
      end
    end
  end
  local meta = debug.getmetatable(value)
  if type(value) == "table" then
    if meta and meta.__pairs then pairs(value) end -- hinge: its fields are made when they are first read
    add(value)
  end
  if not meta then return names end
  if type(meta.methods) == "table" then add(meta.methods) end
  if type(meta.__index) == "table" then add(meta.__index) end
  if not methods then
    for _, name in ipairs(meta.fields or {}) do names[name] = true end
  end
  return names
end

-- The value of a chain of names such as model.section. Reading it may call only the function of a field.
local function value_of(chain)
  local value = _G
  for name in chain:gmatch "[%a_][%w_]*" do
    local ok, next_value = pcall(function() return value[name] end)
    if not ok or next_value == nil then return nil end
    value = next_value
  end
  return value
end

--- What the last word of a line may become, sorted: names after `.`, methods after `:`, else globals and keywords.
function prompt.complete(line)
  local chain, mark, begun = line:match "([%a_][%w_%.]*)([.:])([%w_]*)$"
  local found, before = {}, ""
  local names
  if chain then
    local value = value_of(chain)
    if value == nil then return found end
    names, before = names_of(value, mark == ":"), chain .. mark
  else
    begun = line:match "[%a_][%w_]*$" or ""
    if line:find "[.:]%s*$" then return found end
    names = names_of(_G)
    for _, word in ipairs(keywords) do names[word] = true end
  end
  for name in pairs(names) do
    if name:sub(1, #begun) == begun then found[#found + 1] = before .. name end
  end
  table.sort(found)
  return found
end

-- The prompt ----------------------------------------------------------------------------------------------------------

-- Reads until the lines are whole. Returns them as a function; or nil and, at the end of the input, true.
local function read_whole(read)
  local text
  while true do
    local line, given_up = read(text and ">> " or "> ", prompt.complete)
    if given_up then return nil end
    if not line and not text then return nil, true end
    text = text and line and text .. "\n" .. line or text or line
    local chunk, problem, lacking = compile(text, "=prompt")
    if chunk then return chunk end
    if not (lacking and line) then core.input_error(problem) end
  end
end

--- hinge -i: runs options.script, if there is one, and then what is typed. options.read: see
-- push_line_reader in src/prompt.h; without it lines come from the standard input. Returns the exit status,
-- which no error at the prompt changes.
function prompt.main(options)
  if options.script then
    local status = runner.guard(function() return runner.run(options) end)
    if not options.read and status ~= 0 then return status end
  end
  set_globals()
  local read = options.read
  if read then
    print(("hinge %s, %s. Expressions print what they are, Tab completes names, Ctrl-D ends. Locals last for one line. "
      .. "help lists the calls."):format(core.version, _VERSION))
  else
    read = function() return io.read "l" end
  end
  local ended
  repeat
    runner.guard(function()
      local chunk
      chunk, ended = read_whole(read)
      if chunk then evaluate(chunk) end
      return 0
    end)
  until ended
  if options.read then print() end
  return 0
end

return prompt
