-- The README's first script is a test: it runs as printed there, and prints what is printed there. The citation is that
-- of the README.
--
-- Run: lua5.4 tests/script/documents/readme_test.lua BUILD_FOLDER
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local checks = support.checks "readme"
local case = checks.case
local quote, expect, equal, prints = support.quote, checks.expect, checks.equal, checks.prints

local text = assert(support.read(support.root .. "README.md"))
local code, after = text:match "\n```lua\n(.-)\n```\n()"
assert(code, "README.md has no block of Lua")
local shell = text:match("\n```\n(.-)\n```\n", after)
local command, output = shell:match "^%$ build/hinge run (%S+)\n(.*)$"
assert(command, "the block after the first script does not start with: $ build/hinge run SCRIPT")

-- In a folder of its own, as the README says it: build/hinge run scripts/...
local folder = support.temporary_folder()
case("the first script of the README prints what the README shows", function()
  support.run(("mkdir -p %s/scripts && ln -s %s %s/build"):format(folder, quote(arg[1]), folder))
  support.write(folder .. "/" .. command, code .. "\n")
  local status, printed, complaint = support.run(("cd %s && build/hinge run %s"):format(folder, command))
  equal(status, 0, "exit status: " .. complaint)
  prints(printed, output .. "\n", "what the script prints")
end)

case("it prints the same under plain Lua", function()
  -- The same script under plain Lua prints the same, but for where the program wrote its files.
  local status, printed = support.run(("cd %s && LUA_CPATH='build/?.so' lua5.4 %s"):format(folder, command))
  equal(status, 0, "exit status under lua5.4")
  prints(printed, (output .. "\n"):gsub("written to [^\n]*\n", ""), "what it prints under lua5.4")
end)

case("it is the script of that name without its heading", function()
  equal((support.read(support.root .. command) or "none"):match "\n(local hinge = .*)", code .. "\n", command)
end)

case("the citation is of the paper that the README names", function()
  local citation = support.read(support.root .. ".github/CITATION.cff") or ""
  local words = text:gsub("%s+", " ")
  for _, field in ipairs { "title", "journal" } do
    local value = citation:match("references:.*%s" .. field .. ": ([^\n]+)")
    expect(value and words:find(value, 1, true), "the README does not cite %s", value)
  end
  expect(words:find(("%s (%s) %s-%s"):format(citation:match "volume: (%d+)", citation:match "year: (%d+)",
    citation:match "start: (%d+)", citation:match "end: (%d+)"), 1, true), "volume, year or pages of the paper")
end)

checks.done()
