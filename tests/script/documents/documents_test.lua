-- Documents say what the engine is: names that it has today, one version, the time of all tests in one place, and no
-- denial of what is there.
--
-- Run: lua5.4 tests/script/documents/documents_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local checks = support.checks "documents"
local case, expect, equal = checks.case, checks.expect, checks.equal

local root = support.root
local pages = { root .. "README.md", root .. "src/README.md", root .. "src/theory.md", root .. "tests/README.md",
  root .. ".github/CONTRIBUTING.md" }
for path in support.output("ls " .. support.quote(root) .. "lua/guide/*.md"):gmatch "[^\n]+" do
  pages[#pages + 1] = path
end
local function short(path) return path:sub(#root + 1) end

case("no page teaches a name that is a former one", function()
  -- as former_names_test.lua has them
  for _, path in ipairs(pages) do
    local text = support.read(path)
    for _, former in ipairs { 'shift = "whole"', '`"whole"`' } do
      local at = text:find(former, 1, true)
      expect(not at, "%s has %s; its name is elastic_and_plastic", short(path), former)
    end
  end
end)

case("all documents have the version of the build", function()
  local version = support.read(root .. "CMakeLists.txt"):match "project%(hinge VERSION ([%d.]+)"
  local minor = version:match "^%d+%.%d+"
  local count = 0
  local function holds(path, pattern, wanted)
    local text = support.read(path)
    for found in (text or ""):gmatch(pattern) do
      count = count + 1
      equal(found, wanted, short(path))
    end
  end
  for _, path in ipairs(pages) do
    holds(path, "find_package%(hinge ([%d.]+)", minor)
    holds(path, "hinge_([%d.]+)_amd64", version)
    holds(path, "%- hinge (%d+%.%d+%.%d+), an engine", version)
  end
  holds(root .. ".github/CITATION.cff", "\nversion: ([%d.]+)", version)
  equal(support.is_there(root .. "lua/hinge-" .. version .. "-1.rockspec"), true, "the rockspec")
  expect(count >= 4, "%d places with a version", count)
end)

case("how long all tests take is said in one place", function()
  local places = {}
  for _, path in ipairs(pages) do
    for line in support.read(path):gmatch "[^\n]+" do
      if line:find "all tests" or line:find "All tests" or line:find "tests together" then
        if line:find "minute" and not line:find "CI" then places[#places + 1] = short(path) end
      end
    end
  end
  equal(table.concat(places, " "), "tests/README.md", "places")
end)

case("no page denies joints, checks by standards or drifts", function()
  for _, path in ipairs(pages) do
    local text = support.read(path)
    for _, denial in ipairs { "joints weaker than members", "design to a code", "no code check", "no joints" } do
      expect(not text:find(denial, 1, true), "%s says '%s'", short(path), denial)
    end
  end
  expect(support.read(root .. "README.md"):find("EN 1993-1-1 and AISC 360", 1, true), "the README names the checks")
end)

checks.done()
