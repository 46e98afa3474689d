-- lua/hinge/report/viewer.js, part of the tree, was built from the sources that are in src/viewer now. The build lists
-- the hashes of all its files in src/viewer/built.sha256, so that this check needs neither npm nor a network.
--
-- Run: lua5.4 tests/script/report/viewer_test.lua
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local checks = support.checks "viewer"
local case = checks.case
local quote, expect, equal = support.quote, checks.expect, checks.equal

local built, list = "lua/hinge/report/viewer.js", "src/viewer/built.sha256"
local sources = "src/viewer/build.sh src/viewer/package*.json src/viewer/src/*"

-- Hash of each file that a build reads or writes, by path.
local function hashes_of(root)
  local found = {}
  local lines = support.output(("cd %s && sha256sum -- %s %s"):format(quote(root), built, sources))
  for hash, path in lines:gmatch "(%x+)  ([^\n]+)" do found[path] = hash end
  return found
end

-- What differs between a tree and its list, sorted: "path: what".
local function differences(root)
  local found, wrong = hashes_of(root), {}
  for hash, path in (support.read(root .. "/" .. list) or ""):gmatch "(%x+)  ([^\n]+)" do
    if not found[path] then
      wrong[#wrong + 1] = path .. ": is missing"
    elseif found[path] ~= hash then
      wrong[#wrong + 1] = path .. ": changed since the build"
    end
    found[path] = nil
  end
  for path in pairs(found) do wrong[#wrong + 1] = path .. ": not in the list" end
  table.sort(wrong)
  return table.concat(wrong, "\n")
end

case("the viewer in the tree is the one that its sources make", function()
  local wrong = differences(support.root)
  expect(wrong == "", "%s is not what src/viewer makes; run src/viewer/build.sh:\n%s", built, wrong)
end)

case("each way in which the copy can differ from its sources is noticed", function()
  local copy = support.temporary_folder()
  local function changed(command)
    local copying = ("rm -rf %s/* && cd %s && cp -R --parents %s %s %s %s && cd %s && "):format(quote(copy),
      quote(support.root), sources, list, built, quote(copy), quote(copy))
    equal(support.run(copying .. command), 0, command)
    return differences(copy)
  end
  equal(changed "true", "", "the same files")
  equal(changed "echo >>src/viewer/src/plot.js", "src/viewer/src/plot.js: changed since the build",
    "a source is another")
  equal(changed("echo >>" .. built), built .. ": changed since the build", "the built file was edited")
  equal(changed "echo >src/viewer/src/more.js", "src/viewer/src/more.js: not in the list", "a new source")
  equal(changed "rm src/viewer/src/plot.js", "src/viewer/src/plot.js: is missing", "a source is gone")
  equal(changed "echo >>src/viewer/package-lock.json", "src/viewer/package-lock.json: changed since the build",
    "another three.js")
  expect(changed("rm " .. list):find(built .. ": not in the list", 1, true), "no list")
end)

checks.done()
