-- Shell completion: what bash offers after `hinge`, verbs and options as --help lists them, files, and the parameters
-- and cases of scripts, which are read and not run. Where zsh and fish are there, they take their scripts.
--
-- Run: lua5.4 tests/script/program/completion_test.lua BUILD_FOLDER, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
require "hinge"
local names = require "hinge.program.completion".names
local checks = support.checks "completion"
local case = checks.case
local quote, run, expect, equal = support.quote, support.run, checks.expect, checks.equal
local program = quote(arg[1] .. "/hinge")

local folder = support.temporary_folder()
support.write(folder .. "/frame.lua", [[
local hinge = require "hinge"
io.open("it ran", "w"):close()
local parameters = { speed = 9, name = "a = 1", --[=[ no = 1, ]=] list = { 1, inner = 2 }, sizes = { 1, 2 } } -- x = 1
return hinge.scenario {
  parameters = parameters, accuracy = { dt = { 1e-4, 2e-4 }, speed = { 100, 50 } },
  cases = { II = { speed = 80 }, ["odd"] = {}, heavy = { speed = 120 } },
  run = function(p) local cases = { wrong = {} } return p, cases end,
}]])
support.write(folder .. "/plain.lua", 'local p = ...\nprint(p.height or 3, p["width"])\n')
support.write(folder .. "/notes.txt", "")
run(("mkdir -p '%s/out/frame'"):format(folder))

-- What bash's completion offers after these words, the last of which is begun, sorted and with blanks between.
support.write(folder .. "/ask.sh", [[
source <(hinge completion bash) || exit 3
COMP_WORDS=("$@") COMP_CWORD=$(($# - 1)) COMPREPLY=()
_hinge
printf '%s\n' "${COMPREPLY[@]}" | LC_ALL=C sort | paste -sd' '
]])
local in_folder = ("cd %s && PATH=%s:$PATH "):format(quote(folder), quote(arg[1]))
local function offers(...)
  local words = {}
  for i, word in ipairs { "hinge", ... } do words[i] = quote(word) end
  local status, printed, complaint = run(in_folder .. "bash ask.sh " .. table.concat(words, " "))
  expect(status == 0 and complaint == "", "%s: status %s: %s", table.concat(words, " "), status, complaint)
  return printed:gsub("\n$", "")
end

case("completion knows every verb and option that --help lists", function()
  local function listed(arguments, pattern)
    local found, text = {}, "\n" .. support.output(program .. " " .. arguments .. " --help")
    for name in text:gmatch(pattern) do
      if not found[name] then found[#found + 1], found[name] = name, true end
    end
    table.sort(found)
    return found
  end
  local verbs = listed("", "\n  ([%l]+)%f[%s]")
  expect(#verbs >= 11, "%d verbs", #verbs)
  for _, verb in ipairs(verbs) do
    local begun = verb:sub(1, 3)
    expect((" " .. offers(begun) .. " "):find(" " .. verb .. " ", 1, true), "%s is not offered after %s", verb, begun)
    equal(offers(verb, "--"), table.concat(listed(verb, "%f[%-](%-%-[%w-]+)%f[^%w-]"), " "), "options of " .. verb)
  end

  for _, row in ipairs {
    { "pl", "plain.lua plan" }, { "run", "", "frame.lua out plain.lua" }, { "plan", "fr", "frame.lua" },
    { "frame.lua", "", "dt= list= name= sizes= speed=" }, { "run", "frame.lua", "sp", "speed=" },
    { "cost", "frame.lua", "--within", "1%", "d", "dt=" }, { "run", "-q", "frame.lua", "l", "list=" },
    { "run", "frame.lua", "--case", "", "II heavy" }, { "plan", "frame.lua", "--case", "h", "heavy" },
    { "run", "frame.lua", "--out", "o", "out" }, { "cost", "frame.lua", "--quantity", "", "" },
    { "frame.lua", "speed", "=", "" }, { "run", "plain.lua", "", "height= width=" }, { "render", "out/", "out/frame" },
    { "history", "", "out" }, { "reference", "damp", "damping" }, { "reference", "-s", "damp", "" },
    { "completion", "", "bash fish zsh" }, { "new", "", "" }, { "do", "1", "" }, { "nonsense", "", "" },
  } do
    local wanted = table.remove(row)
    equal(offers(table.unpack(row)), wanted, "after hinge " .. table.concat(row, " "))
  end
  expect(not support.is_there(folder .. "/it ran"), "a script was run to complete its parameters")
end)

case("completion knows the parameters and cases of a script", function()
  local function listed_names(text)
    local parameters, cases = names(text)
    return table.concat(parameters, " ") .. "/" .. table.concat(cases, " ")
  end
  for text, wanted in pairs {
    ["return hinge.scenario { run = f }"] = "/", ["return 1"] = "/", ["hinge.scenario {"] = "/",
    ["return hinge.scenario({ parameters = { a = 1, b = { c = 2 } } })"] = "a b/",
    ["local p = impact.parameters { dt = 1 } return hinge.scenario { parameters = p, cases = impact.cases }"] = "dt/",
    ["scenario { cases = { I = {}, II = { x = 1 } }, parameters = with({ x = 1 }, more) }"] = "x/I II",
    ["-- '\nscenario { parameters = { --[==[ no = 1,\n]] ]==] a = '-', b = \"\\\"c = 1\", d = [[e = 1]], f = 2 - 1 } }"]
      = "a b d f/",
  } do
    equal(listed_names(text), wanted, text)
  end
  for path in support.output("ls " .. quote(support.root) .. "scripts/*.lua " .. quote(support.root)
    .. "scripts/*/*.lua"):gmatch "[^\n]+" do
    equal(run(program .. " completion names " .. quote(path)), 0, "names of " .. path)
  end

  for _, words in ipairs { "names " .. folder .. "/nowhere.lua", "csh" } do
    equal(run(program .. " completion " .. words), 2, words)
  end
  for _, shell in ipairs { "bash", "fish", "zsh" } do
    support.write(folder .. "/script", (checks.ended(0, { "hinge completion " .. shell, "instructions" },
      run(program .. " completion " .. shell))))
    if run("command -v " .. shell) == 0 then checks.ended(0, "", run(("%s -n %s/script"):format(shell, folder))) end
  end
end)

checks.done()
