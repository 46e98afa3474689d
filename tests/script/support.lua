-- What the script tests share: counting checks, comparing messages, running commands, reading JSON.
local support = {}

--- The folder of the tests, with a slash at its end; scripts may be started from anywhere.
support.folder = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$"
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

--- A list of checks: expect(ok, what), equal(value, wanted, what), near(value, wanted, within, what),
--- same_files(path, other, what), done() at the end.
function support.checks(title)
  local count, failures = 0, {}
  local checks = {}
  function checks.expect(ok, what, ...)
    count = count + 1
    if not ok then failures[#failures + 1] = select("#", ...) > 0 and what:format(...) or what end
    return ok
  end
  function checks.equal(value, wanted, what)
    return checks.expect(value == wanted, "%s: is %s, wanted %s", what, tostring(value), tostring(wanted))
  end
  function checks.near(value, wanted, within, what)
    return checks.expect(math.abs(value - wanted) <= within, "%s: is %.10g, wanted %.10g within %.3g",
      what, value, wanted, within)
  end
  --- Two files that are there and hold the same bytes.
  function checks.same_files(path, other, what)
    local text = support.read(path)
    return checks.expect(text and text == support.read(other), "%s: %s %s", what, path, not text and "is not there"
      or support.is_there(other) and "and " .. other .. " differ" or "is there, " .. other .. " is not")
  end
  function checks.done()
    if #failures > 0 then
      io.stderr:write(("%s: %d of %d checks failed:\n  %s\n")
        :format(title, #failures, count, table.concat(failures, "\n  ")))
      os.exit(1)
    end
    print(("%s: %d checks passed"):format(title, count))
  end
  return checks
end

--- Whether a message is the template, in which "..." stands for anything.
function support.says(message, template)
  local pattern = template:gsub("%p", "%%%0"):gsub("%%%.%%%.%%%.", ".-")
  return message:find("^" .. pattern .. "$") ~= nil
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

--- hinge_on(verb, text, arguments), and its folder, gone when the test ends: writes a script there and runs
--- `hinge VERB scene.lua ARGUMENTS` of a build folder; returns what support.run does.
function support.scenes(build)
  local folder = support.temporary_folder()
  return function(verb, text, arguments)
    support.write(folder .. "/scene.lua", text)
    return support.run(("cd %s && %s %s scene.lua %s"):format(support.quote(folder), support.quote(build .. "/hinge"),
      verb, arguments or ""))
  end, folder
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
