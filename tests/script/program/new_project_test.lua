-- hinge new: what it writes runs as its README says, with the program and with plain Lua, and leaves what is there
-- alone. .luarc.json, there and at the top level, tells editors of files that are there.
--
-- Run: lua5.4 tests/script/program/new_project_test.lua BUILD_FOLDER
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local checks = support.checks "new project"
local case, ended = checks.case, checks.ended
local quote, run, expect, equal = support.quote, support.run, checks.expect, checks.equal
local program = quote(arg[1] .. "/hinge")
local pictures = support.is_there(arg[1] .. "/libhinge_output.so")

local folder = support.temporary_folder()
local here = "cd " .. quote(folder) .. " && "
local project = folder .. "/my portal"
case("hinge new writes a project with its files", function()
  local printed = ended(0, "", run(here .. program .. " new 'my portal'"))
  equal(printed, "written to my portal: main.lua, README.md, .luarc.json, .gitignore\n"
    .. "next: cd 'my portal' && hinge run main.lua\n", "what it says")
  equal(support.output("ls -A " .. quote(project)), ".gitignore\n.luarc.json\nREADME.md\nmain.lua\n", "what it writes")
  for _, name in ipairs { "main.lua", "README.md" } do
    local text = support.read(project .. "/" .. name)
    expect(text:find "my portal" and not text:find "PROJECT", "%s does not name the project", name)
  end
  equal(support.read(project .. "/.gitignore"), "/out/\n", ".gitignore")
end)

-- Nothing is overwritten.
local main = support.read(project .. "/main.lua")
case("hinge new overwrites nothing", function()
  support.write(folder .. "/file", "mine")
  run(("mkdir -p %s/full %s/empty && touch %s/full/.hidden"):format(folder, folder, folder))
  for _, name in ipairs { "'my portal'", "file", "full" } do
    equal(ended(2, "already; nothing was written", run(here .. program .. " new " .. name)), "", name)
  end
  equal(support.read(folder .. "/file"), "mine", "a file of that name")
  equal(support.output("ls -A " .. folder .. "/full"), ".hidden\n", "a folder of that name")
  ended(0, "", run(here .. program .. " new empty/../empty"))
  expect(support.read(folder .. "/empty/main.lua"):find "^%-%- empty:", "into an empty folder")
  ended(1, "", run(here .. program .. " new file/inside")) -- no folder can be made there
  ended(2, "", run(program .. " new"))
end)

-- It runs -------------------------------------------------------------------------------------------------------------

local there = "cd " .. quote(project) .. " && "
case("the new project runs in the program and in plain Lua", function()
  local function results(arguments)
    ended(0, "", run(there .. program .. " run main.lua --out out/test " .. arguments))
    local summary = support.json(support.read(project .. "/out/test/summary.json") or "{}")
    run(there .. "rm -r out/test/summary.json")
    return summary.results or {}, summary
  end
  local plain, summary = results ""
  equal(summary.verdict, "completed", "verdict")
  equal(#(summary.warnings or {}), 0, "warnings of the project as it is written")
  expect(plain.largest_sway_mm and plain.largest_sway_mm > 60 and plain.largest_sway_mm < 120, "sway %s mm",
    plain.largest_sway_mm)
  expect(plain.plastic_work_kJ and plain.plastic_work_kJ > 1 and plain.yielded == 3,
    "the blow makes hinges: %s kJ in %s",
    plain.plastic_work_kJ, plain.yielded)
  for _, name in ipairs { "portal.png", "sway.png" } do
    expect(not pictures or support.is_there(project .. "/out/test/" .. name), "no %s", name)
  end
  local weak, more = results "--case weak", results "impulse=15e3"
  expect(weak.yielded == 0 and weak.largest_sway_mm < 50, "a weak blow: %s mm", weak.largest_sway_mm)
  expect((more.largest_sway_mm or 0) > 120, "a stronger one: %s mm", more.largest_sway_mm)
  local printed = ended(0, "", run(there .. ("LUA_CPATH=%s lua5.4 main.lua"):format(quote(arg[1] .. "/?.so"))))
  checks.near(tonumber(printed:match "largest_sway_mm%s+(%S+)"), plain.largest_sway_mm, 1e-9, "its result")
end)

case("every command of its README runs", function()
  local page, count = support.read(project .. "/README.md"), 0
  for command in page:gmatch "\n| `(hinge [^`]*)`" do
    count = count + 1
    local printed = ended(0, "", run(there .. (command:gsub("^hinge", function() return program end))))
    expect(not printed:find "warning:", "%s: %s", command, printed)
    if command:find " plan " then -- its own weight acts, and no load counts the floor a second time
      expect(printed:find "\n  gravity +on " and printed:find "\n  member loads +off ", "%s: %s", command, printed)
    end
  end
  equal(count, 8, "commands in its README")
  for line in main:match "^.-\n\n":gmatch "%-%-   (hinge .-)   " do
    ended(0, "", run(there .. (line:gsub("^hinge", function() return program end))))
  end
end)

-- Editors -------------------------------------------------------------------------------------------------------------

case("editors find the declarations", function()
  local function settings(where)
    local text = support.read(where .. "/.luarc.json")
    local ok, value = pcall(support.json, text or "")
    if not expect(ok, "%s/.luarc.json: %s", where, tostring(value)) then return end
    equal(value["runtime.version"], "Lua 5.4", where .. ": version of Lua")
    local declared = {}
    for _, path in ipairs(value["workspace.library"] or {}) do
      local whole = path:find "^/" and path or where .. "/" .. path
      declared[path:match "[^/]*$"] = true
      local file = path:find "%.lua$" and whole or whole .. "/model.d.lua"
      expect((support.read(file) or ""):find "^%-%-%-@meta", "%s: %s is no file of declarations", where, file)
    end
    expect(declared["hinge.d.lua"] and declared.words, "%s: not all of hinge's types", where)
    for _, path in ipairs(value["runtime.path"] or {}) do
      expect(support.is_there(where .. "/" .. path:match "^(.-)/%?"), "%s: there is no %s", where, path)
    end
  end
  settings(project)
  settings(support.root:gsub("/$", ""))
end)

checks.done()
