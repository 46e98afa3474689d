-- Documents say what the engine is: names that it has today, one version, the time of all tests in one place, and no
-- denial of what is there.
--
-- Run: lua5.4 tests/script/documents/documents_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local hinge = require "hinge"
local checks = support.checks "documents"
local case, expect, equal = checks.case, checks.expect, checks.equal

local root = support.root
local pages = { root .. "README.md", root .. "src/README.md", root .. "src/theory.md", root .. "tests/README.md",
  root .. ".github/CONTRIBUTING.md" }
for path in support.output("ls " .. support.quote(root) .. "lua/guide/*.md"):gmatch "[^\n]+" do
  pages[#pages + 1] = path
end
local function short(path) return path:sub(#root + 1) end

case("the version stands in CMakeLists.txt, CHANGES.md and CITATION.cff alone", function()
  local version = support.read(root .. "CMakeLists.txt"):match "project%(hinge VERSION ([%d.]+)"
  equal(hinge.version, version, "the build")
  equal(support.read(root .. "src/CHANGES.md"):match "\n## (%S+)", version, "the first version of CHANGES.md")
  equal(support.read(root .. ".github/CITATION.cff"):match "\nversion: (%S+)", version, "CITATION.cff")
  equal(support.read(root .. "lua/hinge-scm-1.rockspec"):match "\nversion = (%S+)", '"scm-1"', "the rockspec")
  for _, path in ipairs(pages) do
    for _, pattern in ipairs { "find_package%(hinge [%d.]+", "hinge_%d[%d.]+_amd64", "hinge %d+%.%d+%.%d+" } do
      local found = not path:find "CHANGES.md$" and support.read(path):match(pattern)
      expect(not found, "%s names a version: %s", short(path), found)
    end
  end
end)

case("CHANGES.md is a page a release, and begins with what changes results", function()
  local text = support.read(root .. "src/CHANGES.md")
  local releases, lines = {}, 0
  for line in text:gmatch "[^\n]*\n" do
    local version = line:match "^## (%S+)"
    if version then releases[#releases + 1], lines = version, 0 end
    lines = lines + 1
    expect(lines < 110, "%s has %d lines: whoever needs more has the commits", releases[#releases], lines)
  end
  expect(#releases > 2, "%d releases", #releases)
  equal(text:match "\n### ([^\n]*)", "What changes your results", "the first part of the first release")
  local first = text:match "\n%- ([^\n]*)"
  expect(first:find("interaction", 1, true), "it begins with: %s", first)
end)

case("counts on pages are those of the tree", function()
  local rows = select(2, support.read(root .. "scripts/benchmarks/README.md"):gsub("\n| [^\n]*[+-][%d.]+ %%", ""))
  local said = tonumber(support.read(root .. "README.md"):match "some (%d+) published values")
  expect(said and math.abs(said - rows) < 0.1 * rows, "the README says some %s published values; %d are there", said,
    rows)
  local lines = 0
  for line in support.read(root .. "lua/guide/grid.md"):match "\n```lua\n(.-)```\n":gmatch "[^\n]+" do
    if line:find "%S" and not line:find "^%s*%-%-" then lines = lines + 1 end
  end
  equal(support.read(root .. "lua/guide/README.md"):match "a ten%-storey frame in (%d+) lines", ("%d"):format(lines),
    "lines of the script of guide/grid.md")
end)

case("links of pages outside of the guide lead somewhere", function() -- guide_test.lua has the guide's
  local count = 0
  for path in support.output(("cd %s && git ls-files '*.md' || find . -name '*.md'"):format(support.quote(root)))
    :gmatch "[^\n]+" do
    local folder, text = root .. (path:match "^.*/" or ""), not path:find "lua/guide/" and support.read(root .. path)
    for link in (text or ""):gsub("\n```.-\n```", ""):gmatch "%]%(([^)#%s]+)[^)]*%)" do
      if not link:find "^https?:" and not link:find "^scripts/pictures/" then
        count = count + 1
        expect(support.is_there(folder .. link), "%s points to %s, which is not there", path, link)
      end
    end
  end
  expect(count > 80, "%d links", count)
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
