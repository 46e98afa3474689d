-- The README's first script is a test: it runs as printed there, and prints what is printed there.
--
-- Run: lua5.4 tests/script/readme_test.lua BUILD_FOLDER
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "?.lua;" .. package.path
local support = require "support"
local checks = support.checks "readme"
local quote, expect, equal, prints = support.quote, checks.expect, checks.equal, checks.prints

local text = assert(support.read(support.root .. "README.md"))
local code, after = text:match "\n```lua\n(.-)\n```\n()"
assert(code, "README.md has no block of Lua")
local shell = text:match("\n```\n(.-)\n```\n", after)
local command, output = shell:match "^%$ build/hinge run (%S+)\n(.*)$"
assert(command, "the block after the first script does not start with: $ build/hinge run SCRIPT")

-- In a folder of its own, as the README says it: build/hinge run scripts/...
local folder = support.temporary_folder()
support.run(("mkdir -p %s/scripts && ln -s %s %s/build"):format(folder, quote(arg[1]), folder))
support.write(folder .. "/" .. command, code .. "\n")
local status, printed, complaint = support.run(("cd %s && build/hinge run %s"):format(folder, command))
equal(status, 0, "exit status: " .. complaint)
prints(printed, output .. "\n", "what the script prints")

-- The same script under plain Lua prints the same, but for where the program wrote its files.
status, printed = support.run(("cd %s && LUA_CPATH='build/?.so' lua5.4 %s"):format(folder, command))
equal(status, 0, "exit status under lua5.4")
prints(printed, (output .. "\n"):gsub("written to [^\n]*\n", ""), "what it prints under lua5.4")

-- It is the script of that name without its heading.
equal((support.read(support.root .. command) or "none"):match "\n(local hinge = .*)", code .. "\n", command)

-- Every file and folder that the README names is there.
for name in text:gmatch "%]%(([^)#]+)%)" do
  if not name:find "^https?:" and not name:find "^scripts/pictures/" then
    expect(support.is_there(support.root .. name), "README.md points to %s, which is not there", name)
  end
end
checks.done()
