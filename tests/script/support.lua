-- What the script tests share: named cases and checks, comparing messages, running commands, reading JSON.
local cases = require "cases"
local support = { case_argument = cases.argument } -- for a test that starts itself again

--- The folder of the tests, with a slash at its end; scripts may be started from anywhere.
support.folder = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$"
support.folder = support.folder:gsub("(script/)[%w_/]+/[./]+$", "%1") -- script/run/../, where a test in run found it
support.root = support.folder .. "../../"

--- The largest of numbers; not a number if one of them is not, so that every limit it is held against is missed.
--- math.max(worst, x) drops an x that is not a number.
function support.largest_of(first, ...)
  local largest = first
  for i = 1, select("#", ...) do
    local x = select(i, ...)
    if largest == largest and not (x <= largest) then largest = x end
  end
  return largest
end

--- The smallest of numbers, in the same way.
function support.smallest_of(first, ...)
  local smallest = first
  for i = 1, select("#", ...) do
    local x = select(i, ...)
    if smallest == smallest and not (x >= smallest) then smallest = x end
  end
  return smallest
end

--- The cases of a test file and the checks in them: cases.lua, and prints(printed, shown, what),
--- same_files(path, other, what).
function support.checks(title, test)
  local checks = cases.new(title, test)
  --- What was printed is what is shown: support.prints.
  function checks.prints(printed, shown, what)
    return checks.expect(support.prints(printed, shown), "%s: prints\n%s\nand not\n%s", what, printed, shown)
  end
  --- Two files that are there and hold the same bytes.
  function checks.same_files(path, other, what)
    local text = support.read(path)
    return checks.expect(text and text == support.read(other), "%s: %s %s", what, path, not text and "is not there"
      or support.is_there(other) and "and " .. other .. " differ" or "is there, " .. other .. " is not")
  end
  --- A call that is refused. The error stands at a line of `call`, if that is a function of the test, and holds each of
  --- these words (a text or a list of texts; numbers as numbers). Returns the message without its place.
  function checks.refused(words, call, ...)
    local good, failure = pcall(call, ...)
    words = type(words) == "table" and words or { words }
    if not checks.expect(not good, "no error; wanted: %s", table.concat(words, " ... ")) then return "" end
    local whole, of = tostring(failure), debug.getinfo(call, "S")
    local file, line, message = whole:match "^(.-):(%d+): (.*)$"
    if of.what ~= "C" and of.source == debug.getinfo(2, "S").source then
      line = line and file:match "[^/]*$" == of.source:match "[^/]*$" and tonumber(line)
      checks.expect(line and line >= of.linedefined and line <= of.lastlinedefined, "not at the call's line: %s", whole)
    end
    for _, word in ipairs(words) do
      checks.expect(support.has(message or whole, word), "'%s' is not in: %s", word, whole)
    end
    return message or whole
  end
  --- What a command returned (support.run): it ended with this status, and these words (a text or a list of texts;
  --- numbers as numbers) are in what it printed, or, where the status is not 0, in its complaint. Returns both.
  function checks.ended(wanted, words, status, printed, complaint)
    local text = wanted == 0 and printed or complaint
    checks.expect(status == wanted, "status %s, wanted %s: %s%s", status, wanted, printed, complaint)
    for _, word in ipairs(type(words) == "table" and words or { words }) do
      checks.expect(text:find(word, 1, true) or support.has(text, word), "'%s' is not in: %s", word, text)
    end
    return printed, complaint
  end
  return checks
end

-- Printed text --------------------------------------------------------------------------------------------------------
-- Words are compared as words and numbers as numbers: processors differ in the sign of a zero and in the last digit, so
-- in the blanks before a number as well.

-- The text of the number that begins at a place. Digits in a word (case_2, lua5.4, a hash) and in a version (0.2.0) are
-- no number.
local function number_at(text, at)
  if at > 1 and text:find("^[%w_.]", at - 1) then return nil end
  local number = text:match("^[+-]?%d+", at)
  if not number then return nil end
  number = number .. (text:match("^%.%d+", at + #number) or "")
  number = number .. (text:match("^[eE][+-]?%d+", at + #number) or "")
  local after = at + #number
  return not text:find("^[%w_]", after) and not text:find("^%.%d", after) and number or nil
end

-- How many digits a number is printed with, and one unit of the last of them.
local function precision(number)
  local whole, fraction, exponent = number:match "^[+-]?(%d+)%.?(%d*)[eE]?([+-]?%d*)$"
  local digits = (whole .. fraction):gsub("^0+", "")
  return #digits, 10.0 ^ ((tonumber(exponent) or 0) - #fraction)
end

--- Whether two printed numbers are the same. -0 is 0. Whole numbers are counts, and must be equal. Others may differ by
--- one unit of the last digit where three digits or more are printed: a value between two of them may be rounded to
--- either. They may also differ by 1e-6 of their value: iterations end at 1e-8, and a run adds such errors up.
function support.same_number(a, b)
  local x, y = tonumber(a), tonumber(b)
  if x == y then return true end
  if not (a:find "[.eE]" or b:find "[.eE]") then return false end
  local digits, unit = precision(a)
  local digits_of_b, unit_of_b = precision(b)
  if unit_of_b < unit then digits, unit = digits_of_b, unit_of_b end -- 1 is 0.999999 and 0.3 is 0.299
  return math.abs(x - y) <= support.largest_of(1e-6 * math.abs(x), digits >= 3 and 1.001 * unit or 0)
end

-- A text as a list of { words = } and { number = }. Blanks before a number are left out: how many there are depends on
-- the number. So are those after it; the words that follow then have `gap`.
local function parts_of(text)
  local parts, from, at = {}, 1, 1
  local function add_words(upto)
    local words = text:sub(from, upto)
    local last = parts[#parts]
    local gap = last and last.number and words:find "^ +" ~= nil
    words = gap and words:gsub("^ +", "") or words
    if words ~= "" or gap then parts[#parts + 1] = { words = words, gap = gap } end
  end
  while at <= #text do
    local number = number_at(text, at)
    if number then
      local upto = at - 1
      while upto >= from and text:sub(upto, upto) == " " do upto = upto - 1 end
      add_words(upto)
      parts[#parts + 1] = { number = number }
      at = at + #number
      from = at
    else
      at = at + 1
    end
  end
  add_words(#text)
  return parts
end

-- The place after the parts in a text, if they stand at a place.
local function skip_parts(parts, text, at)
  for _, part in ipairs(parts) do
    if part.number then
      local begin = text:match("^ *()", at)
      local number = number_at(text, begin)
      if not number or not support.same_number(number, part.number) then return nil end
      at = begin + #number
    else
      if part.gap then
        if not text:find("^ ", at) then return nil end
        at = text:match("^ *()", at)
      end
      if text:sub(at, at + #part.words - 1) ~= part.words then return nil end
      at = at + #part.words
    end
  end
  return at
end

-- Whether a text is a list of pieces one after the other, from `at` to its end. piece.after: what may come before the
-- piece: "nothing", "line" (anything within its line) or "anything".
local function are_pieces(pieces, i, text, at)
  local piece = pieces[i]
  if not piece then return at == #text + 1 end
  local last = at
  if piece.after == "line" then last = text:find("\n", at, true) or #text + 1
  elseif piece.after == "anything" then last = #text + 1 end
  for place = at, last do
    local stop = skip_parts(piece.parts, text, place)
    if stop and are_pieces(pieces, i + 1, text, stop) then return true end
  end
  return false
end

-- Cuts a text at its marks: `mark` stands for `after`, plainly.
local function cut(pieces, text, mark, after)
  local from = 1
  while true do
    local at, stop = text:find(mark, from, true)
    pieces[#pieces + 1] = { text = text:sub(from, (at or 0) - 1), after = from > 1 and after or "nothing" }
    if not at then return pieces end
    from = stop + 1
  end
end

local function match(pieces, text)
  for _, piece in ipairs(pieces) do piece.parts = parts_of(piece.text) end
  return are_pieces(pieces, 1, text, 1)
end

--- Whether what was printed is what is shown: words as words, numbers as numbers (support.same_number). In what is
--- shown "…" stands for anything within its line, and a line "…" for any number of lines.
function support.prints(printed, shown)
  local text = "\n" .. shown
  for _ = 1, 2 do text = text:gsub("\n…\n", "\n\0") end -- twice: two such lines share a line break
  local pieces = {}
  for _, lines in ipairs(cut({}, text, "\0", "anything")) do
    local first = #pieces + 1
    cut(pieces, lines.text, "…", "line")
    pieces[first].after = lines.after
  end
  return match(pieces, "\n" .. printed)
end

--- Whether a message is the template, in which "..." stands for anything; numbers as numbers.
function support.says(message, template) return match(cut({}, template, "...", "anything"), message) end

--- Whether a piece stands somewhere in a text; numbers as numbers.
function support.has(text, piece)
  local anything = { text = "", after = "anything" }
  return match({ { text = "", after = "nothing" }, { text = piece, after = "anything" }, anything }, text)
end

function support.quote(text) return "'" .. tostring(text):gsub("'", "'\\''") .. "'" end

function support.read(path)
  local file = io.open(path, "rb")
  if not file then return nil end
  local text = file:read "a"
  file:close()
  return text
end

function support.write(path, text)
  local file = assert(io.open(path, "wb"))
  assert(file:write(text))
  assert(file:close())
end

--- What a shell command prints.
function support.output(command)
  local pipe = assert(io.popen(command))
  local text = pipe:read "a"
  pipe:close()
  return text
end

function support.is_there(path)
  return support.read(path) ~= nil or os.execute("test -e " .. support.quote(path)) == true
end

--- A new empty folder, gone when the test ends.
function support.temporary_folder()
  local folder = support.output("mktemp -d"):gsub("%s+$", "")
  support.cleaner = support.cleaner or setmetatable({}, { __gc = function(t)
    for _, f in ipairs(t) do os.execute("rm -rf " .. support.quote(f)) end
  end })
  table.insert(support.cleaner, folder)
  return folder
end

--- write(name, text), which writes a file into a new temporary folder and returns its path; and that folder, with "/".
function support.writer()
  local folder = support.temporary_folder() .. "/"
  return function(name, text)
    support.write(folder .. name, text)
    return folder .. name
  end, folder
end

--- Runs a shell command; returns its exit status, what it printed, and what it printed to stderr.
function support.run(command)
  local out, err = os.tmpname(), os.tmpname()
  local _, kind, status = os.execute(("{ %s ; } >%s 2>%s </dev/null"):format(command, out, err))
  local printed, complaint = support.read(out), support.read(err)
  os.remove(out)
  os.remove(err)
  return kind == "exit" and status or kind .. " " .. status, printed, complaint
end

-- The first of these programs that is there.
local function first_of(programs)
  for _, name in ipairs(programs) do
    local where = support.output("command -v " .. name):gsub("%s+$", "")
    if where ~= "" then return where end
  end
end

--- look(script, ...): what support.run does of a test in tests/viewer, by Node.js with a headless Chromium and these
--- arguments, which may be nil. Nil where there is no such program; `who` says so.
function support.browser(who)
  local node, chromium = first_of { "node", "nodejs" }, first_of { "chromium-headless-shell", "chromium",
    "chromium-browser" }
  local quote = support.quote
  local starts = chromium and support.run(("timeout 60 %s --headless --no-sandbox --disable-gpu --dump-dom about:blank")
    :format(quote(chromium))) == 0
  if node and starts then
    return function(script, ...)
      local words = { quote(node), quote(support.root .. "tests/viewer/" .. script), quote(chromium) }
      for i = 1, select("#", ...) do words[#words + 1] = select(i, ...) and quote((select(i, ...))) end
      return support.run(table.concat(words, " "))
    end
  end
  print(chromium and not starts and ("%s: not looked at in a browser: %s does not start here"):format(who, chromium)
    or ("%s: not looked at in a browser: neither chromium-headless-shell nor chromium is there, or no Node.js")
      :format(who))
end

--- hinge_on(verb, text, arguments), its folder, gone when the test ends, and hinge(words): the first writes a script
--- there and runs `hinge VERB scene.lua ARGUMENTS` of a build folder, the last runs `hinge WORDS` there; both return
--- what support.run does.
function support.scenes(build)
  local folder = support.temporary_folder()
  local function hinge(words)
    return support.run(("cd %s && %s %s"):format(support.quote(folder), support.quote(build .. "/hinge"), words))
  end
  return function(verb, text, arguments)
    support.write(folder .. "/scene.lua", text)
    return hinge(("%s scene.lua %s"):format(verb, arguments or ""))
  end, folder, hinge
end

--- A script that writes one frame: a scenario, or plain statements.
function support.frame_script(plain)
  local model = [[
local model = hinge.model()
local foot = model:node { 0, 0, 0 }
model:fix(foot)
model:member { foot, model:node { 1, 0, 0 }, section = hinge.section.solid { width = 1, depth = 1 },
  material = hinge.material { E = 1e9 } }
]]
  local frame = "frame(model:static { steps = 1 }:finish())\n"
  return 'local hinge = require "hinge"\n' .. (plain and model .. "hinge." .. frame
    or "return hinge.scenario { run = function(_, job)\n" .. model .. "job:" .. frame .. "end }\n")
end

--- A scenario for studies: a bar with a mass at its end swings for `steps` steps, with a checkpoint on the way.
support.swinging_bar = [[
local hinge = require "hinge"
return hinge.scenario {
  parameters = { speed = 10, steps = 20000 },
  run = function(p)
    local steel = hinge.material { E = 206e9, nu = 0.3, density = 7850, yield_stress = 235e6 }
    local model = hinge.model()
    local a, b = model:node { 0, 0, 0 }, model:node { 1, 0, 0 }
    model:fix(a, "all")
    model:member { a, b, section = hinge.section.solid { width = 0.02, depth = 0.02 }, material = steel }
    model:mass { node = b, mass = 1 }
    model:velocity(b, { 0, 0, p.speed })
    local run = model:dynamic { dt = 1e-5, duration = 1e-5 * p.steps, checkpoint = { file = "c", every = 0.2 } }
    local path = run:probe { node = b, "uz" }
    run:finish()
    return { uz = path.value[#path.value], largest = path.max, n = #path.value }
  end,
}
]]

--- The least of `n` times that a command takes, in milliseconds.
function support.milliseconds(command, n)
  local script = ("for i in $(seq %d); do a=${EPOCHREALTIME/[.,]/}; %s >/dev/null 2>&1; "
    .. "b=${EPOCHREALTIME/[.,]/}; echo $((b - a)); done"):format(n, command)
  local least = math.huge
  for microseconds in support.output("bash -c " .. support.quote(script)):gmatch "%d+" do
    least = support.smallest_of(least, microseconds / 1000)
  end
  return least
end

--- A list of numbers and words as a text, to be compared whole; a gap (no number) is "|".
function support.joined(list)
  local texts = {}
  for i, v in ipairs(list) do texts[i] = type(v) == "number" and ("%.7g"):format(v) or tostring(v) end
  return (table.concat(texts, " "):gsub("%-?nan", "|"))
end

--- A JSON text as Lua values; null is nil. Enough for what hinge writes.
function support.json(text)
  local at, value = 1, nil
  local function skip() at = text:find("%S", at) or #text + 1 end
  local function fail() error(("no JSON at byte %d: %s"):format(at, text:sub(at, at + 20))) end
  local function take(c)
    skip()
    if text:sub(at, at) ~= c then return false end
    at = at + 1
    return true
  end
  local function quoted()
    local from = at
    repeat
      at = text:find('["\\]', at) or fail()
      local stop = text:sub(at, at) == '"'
      at = at + (stop and 1 or 2)
    until stop
    return (text:sub(from, at - 2):gsub("\\(.)", { n = "\n", t = "\t", ['"'] = '"', ["\\"] = "\\", ["/"] = "/" }))
  end
  local function object()
    local result = {}
    if take "}" then return result end
    repeat
      if not take '"' then fail() end
      local key = quoted()
      if not take ":" then fail() end
      result[key] = value()
    until not take ","
    return take "}" and result or fail()
  end
  local function array()
    local result = {}
    if take "]" then return result end
    repeat result[#result + 1] = value() until not take ","
    return take "]" and result or fail()
  end
  function value()
    if take "{" then return object() end
    if take "[" then return array() end
    if take '"' then return quoted() end
    for word, meaning in pairs { ["true"] = true, ["false"] = false } do
      if text:sub(at, at + #word - 1) == word then at = at + #word return meaning end
    end
    if text:sub(at, at + 3) == "null" then at = at + 4 return nil end
    local number = text:match("^-?%d+%.?%d*[eE]?[+-]?%d*", at) or fail()
    at = at + #number
    return tonumber(number)
  end
  local result = value()
  skip()
  return at > #text and result or fail()
end

return support
