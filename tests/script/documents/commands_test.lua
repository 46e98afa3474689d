-- What the pages and the heads of scripts name is there: files, verbs and options of hinge, parameters of the scripts
-- that they run, targets of the build, tests, options of the build and of shell scripts. The commands of the guide's
-- console blocks are run by guide_test.lua; those that take long are only read here.
--
-- Run: lua5.4 tests/script/documents/commands_test.lua BUILD_FOLDER
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local checks = support.checks "commands"
local case, expect = checks.case, checks.expect
local quote, root, program = support.quote, support.root, support.quote(arg[1] .. "/hinge")
local function in_root(command) return support.output(("cd %s && %s"):format(quote(root), command)) end

-- What there is -------------------------------------------------------------------------------------------------------

local options = { e = {}, i = {} } -- of each verb; -e and -i stand for do and prompt
for verb, list in support.output(program .. " completion bash"):match "_hinge_options%(%)(.-)esac"
    :gmatch "(%l+)%) printf '%%s\\n' ([^;]*);;" do
  options[verb] = {}
  for option in list:gmatch "%S+" do options[verb][option] = true end
end
options.e, options.i = options["do"], options.prompt

local builds = support.read(root .. "CMakeLists.txt") .. support.read(root .. "tests/CMakeLists.txt")
local function has_target(name)
  for _, kind in ipairs { "add_custom_target", "add_executable", "add_library" } do
    if builds:find(kind .. "%(" .. name .. "%f[^%w_]") then return true end
  end
end

local tests = " "
for name in builds:gmatch "add_script_test%(([%w_]+)" do tests = tests .. "script_" .. name .. " " end
for name in in_root("ls lua/guide tests/unit tests/physics"):gmatch "[%w_]+%f[.]" do
  tests = tests .. "script_guide_" .. name .. " " .. name .. " "
end

-- Options of the build, variables of the environment, macros.
local switches = in_root("grep -rhoE 'HINGE_[A-Z_]*[A-Z]' CMakeLists.txt src scripts lua tests .ci --include=*.sh "
  .. "--include=*.lua --include=*.cpp --include=*.h --include=CMakeLists.txt --include=*.cmake --include=run "
  .. "--exclude=commands_test.lua")
local jobs = support.output(("lua5.4 %stests/everything.lua %s list"):format(root, quote(arg[1])))

-- The text of a script with that of the modules of hinge that it requires, where its parameters may be; or nil.
local script_texts = {}
local function script_text(path)
  if script_texts[path] == nil then
    local text = support.read(root .. path)
    for module in (text or ""):gmatch "require ?%(?\"hinge%.([%w_.]+)\"" do
      text = text .. (support.read(root .. "lua/hinge/" .. module:gsub("%.", "/") .. ".lua") or "")
    end
    script_texts[path] = text or false
  end
  return script_texts[path] or nil
end
local function has_word(text, word)
  return text:find("%f[%w_-]" .. word:gsub("%p", "%%%0") .. "%f[^%w_]") ~= nil
end

-- What a text names ---------------------------------------------------------------------------------------------------

local placeholder = "%f[%w_]%u[%u_]+%f[^%w_]" -- scripts/NAME.lua, SCRIPT

-- What is wrong in a line of a shell from "hinge " on: VERB and what follows.
local function wrong_in_call(words, wrong)
  if words:find "^help accuracy%f[^%w]" then return end -- a topic, and no verb
  local verb = words:match "^%-?(%l+)%f[^%w.]" or words:find "^[%w_/]+%.lua" and "run"
  if verb == "help" then verb = words:match "^help (%l+)" end -- hinge help VERB is hinge VERB --help
  if not verb or verb == "rotation" then return end -- "hinge rotation 1 [rad]" is a field of a frame
  if not options[verb] then return wrong("hinge has no verb '%s'", verb) end
  local script = words:match "[%w_/]+%.lua%f[^%w_]"
  local text = script and script:find "^scripts/" and script_text(script)
  words = words:gsub("'([^']*)'", function(quoted) return (quoted:gsub("%s", "")) end):gsub("%-%-sbatch %S+", "")
  for option in words:gmatch "%f[%S](%-%-?%l[%w-]*)" do
    local parameter = text and option:match "^%-%-(.*)" -- hinge run SCRIPT --key value is key=value
    if not options[verb][option] and not (parameter and has_word(text, parameter)) and not option:find "^%-[ei]$" then
      wrong("hinge %s has no option %s", verb, option)
    end
  end
  for name in words:gmatch "%f[%S]([%l_][%w_]*)[=~]" do
    if text and not has_word(text, name) then wrong("%s has no parameter '%s'", script, name) end
  end
end

-- Commands of a page: lines of its blocks of a shell, and what stands between backquotes.
local function commands_of(page)
  local list = {}
  local function add(command)
    command = command:gsub("%s#%s.*$", ""):gsub("%s%s%s+%f[%(%l].*$", "") -- the remark behind it
    for part in (command .. ";"):gmatch "(.-)[;|]" do list[#list + 1] = part end
  end
  local prose = page:gsub("%f[^\n%z]```(%w*)\n(.-)%f[^\n]```", function(language, block)
    block = block:gsub("\\\n%s*", "")
    for line in block:gmatch "[^\n]+" do
      if language == "sh" or language == "bash" then add(line)
      elseif line:find "^%$ " then add(line:sub(3)) end
    end
    return ""
  end)
  for span in prose:gmatch "`([^`]+)`" do add((span:gsub("%s+", " "))) end
  return list
end

-- Commands of a head: what follows Run, and the lines below it that are further in.
local function commands_of_head(head)
  local list = {}
  local said = head:match "\n%S+ +Run:? +(.-)\n%S+ ?%f[%w\n]" or head:match "\n%S+ +Run:? +(.*)$" or ""
  said = said:gsub("\\\n%S+%s+", "")
  for line in (said .. "\n"):gmatch "[^\n]+" do
    list[#list + 1] = line:gsub("^%S+%s+%f[hlcs]", ""):gsub("%s%s%s+.*$", "") .. "\n"
  end
  return list
end

-- Calls wrong(text, ...) for what a text and its commands name and is not there.
local function look(text, commands, wrong)
  for folder, rest in text:gmatch "%f[%w_./<$-]([%w.]+)(/[%w_./*-]+)" do
    local path = (folder .. rest):gsub("[.-]+$", "")
    if (folder == "scripts" or folder == "tests" or folder == "src" or folder == "lua") and path:find "%.%l+$"
        and not path:find(placeholder) and not path:find "drag%.%l+$" -- the example of an effect, in src/README.md
        and in_root("ls -d " .. path .. " 2>/dev/null") == "" then
      wrong("there is no %s", path)
    end
  end
  for name in text:gmatch "HINGE_[%u_]*%u%f[^%w_]" do
    if not has_word(switches, name) then wrong("nothing reads %s", name) end
  end
  for _, command in ipairs(commands) do
    for name in command:gmatch "%-%-target ([%l][%w_]*)" do
      if not has_target(name) then wrong("the build has no target %s", name) end
    end
    for name in command:gmatch "ctest .*%-R ([%w_]+)" do
      if not tests:find(name, 1, true) then wrong("no test has %s in its name", name) end
    end
    for script, word in command:gmatch "([%w_/]+%.sh) (%-?%-?%l+)%f[^%w]" do
      local body = (support.read(root .. script) or word):gsub("\n#[^\n]*", "")
      if not script:find "demo.sh$" and not has_word(body, word) then -- demo.sh hands on what it is given
        wrong("%s takes no %s", script, word)
      end
    end
    local job = command:match "everything%.lua .*only=(%l+)"
    if job and not ("\n" .. jobs):find("\n" .. job, 1, true) then wrong("everything.lua has no job %s", job) end
    local call = command:match "^%s*hinge (.*)" or command:match "^.*%f[%w_/]build/hinge (.*)"
    if call then wrong_in_call(call, wrong) end
  end
end

-- The pages -----------------------------------------------------------------------------------------------------------

case("what is not there is noticed, and what is there is not", function()
  local function said(page)
    local list = {}
    look(page, commands_of(page), function(...) list[#list + 1] = string.format(...) end)
    return table.concat(list, "; ")
  end
  for page, wanted in pairs {
    ["see `scripts/lost.lua`"] = "there is no scripts/lost.lua",
    ["(tests/unit/lost_test.cpp)"] = "there is no tests/unit/lost_test.cpp",
    ["in tests/script/program/check_test.lua."] = "",
    ["as `hinge run scripts/NAME.lua`"] = "",
    ["`hinge help study`, `hinge help benchmark`"] = "hinge has no verb 'benchmark'",
    ["`hinge run SCRIPT --lively`"] = "hinge run has no option --lively",
    ["```sh\nhinge study s.lua a=1 --resume -j 2\nbuild/hinge plan s.lua --resume   # why\n```\n"]
      = "hinge plan has no option --resume",
    ["```console\n$ hinge render out/a --films\nhinge plan --films\n```\n"] = "hinge render has no option --films",
    ["```sh\nhinge run scripts/studies/robustness.lua x=2 wind=1 --storey 2 --snow 1\n```\n"]
      = "hinge run has no option --snow; scripts/studies/robustness.lua has no parameter 'wind'",
    ["`cmake --build build --target hart`"] = "the build has no target hart",
    ["`cmake --build build --target hard`"] = "",
    ["`ctest -R script_nothing`"] = "no test has script_nothing in its name",
    ["`HINGE_CASE=velocity ctest --test-dir build -R script_declared -V`"] = "",
    ["`tests/sanitize.sh undefined`"] = "tests/sanitize.sh takes no undefined",
    ["`lua5.4 tests/everything.lua build only=soft`"] = "everything.lua has no job soft",
    ["with `-DHINGE_NATIV=OFF`"] = "nothing reads HINGE_NATIV",
  } do
    checks.equal(said(page), wanted, page)
  end
  local head = "-- A scene.\n--\n-- Run     hinge run scripts/studies/show.lua robust=1   (a map)\n"
    .. "--         hinge run scripts/studies/show.lua aircraft=1\n-- Shows   a map\n"
  local list = {}
  look(head, commands_of_head(head), function(...) list[#list + 1] = string.format(...) end)
  checks.equal(table.concat(list, "; "), "scripts/studies/show.lua has no parameter 'robust'", "a head")
end)

case("files, verbs, options, parameters, targets and tests that the pages name are there", function()
  local count, commands = 0, 0
  for path in in_root "find . -name '*.md' -not -path './build*' -not -path './out/*' -not -path './.git/*'"
      :gmatch "%./([^\n]+)" do
    if path ~= "src/CHANGES.md" then -- which names what was there once
      local page = support.read(root .. path)
      local list = commands_of(page)
      count, commands = count + 1, commands + #list
      look(page, list, function(text, ...) expect(false, "%s: " .. text, path, ...) end)
    end
  end
  expect(count > 50 and commands > 1000, "%d pages with %d commands and names", count, commands)
end)

case("what hinge help accuracy names is there", function()
  local list, verb = {}, nil
  for line in support.output(program .. " help accuracy"):gmatch "[^\n]+" do
    verb = line:match "^hinge %l+" or verb
    list[#list + 1] = line:match "^hinge .-%f[ ]   " or line:match "^  %-%-%l+" and verb .. line:match "^ ( %-%-%l+)"
      or nil
  end
  expect(#list >= 7, "it names %d commands and options", #list)
  look("", list, function(text, ...) expect(false, "hinge help accuracy: " .. text, ...) end)
end)

case("what the heads of scripts and tests say to run is there", function()
  local count = 0
  for path in in_root "find scripts tests lua/guide src/viewer -name '*.lua' -o -name '*.sh'":gmatch "[^\n]+" do
    local head = (support.read(root .. path) or ""):match "^(.-)\n%f[%w.]" or ""
    local list = commands_of_head("\n" .. head)
    if #list > 0 then count = count + 1 end
    look(head, list, function(text, ...) expect(false, "%s: " .. text, path, ...) end)
  end
  expect(count > 200, "%d heads", count)
end)

checks.done()
