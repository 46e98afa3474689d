-- Start-up: the program begins at once, reads only what a script uses, and loads VTK only when something is drawn.
--
-- Run: lua5.4 tests/script/program/startup_test.lua BUILD_FOLDER
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local checks = support.checks "startup"
local case = checks.case
local quote, expect, equal = support.quote, checks.expect, checks.equal

local hinge = quote(arg[1] .. "/hinge")
local folder = support.temporary_folder()
local function script(name, text)
  support.write(folder .. "/" .. name, text)
  return quote(folder .. "/" .. name) .. " --out " .. quote(folder .. "/" .. name .. ".out")
end

local two_nodes = [[
local hinge = require "hinge"
local function cantilever()
  local model = hinge.model()
  local wall, tip = model:node { 0, 0, 0 }, model:node { 1, 0, 0 }
  model:fix(wall)
  model:member { wall, tip, section = hinge.section.solid { width = 0.05, depth = 0.05 },
    material = hinge.material { E = 206e9 } }
  model:load { node = tip, force = { 0, 0, -1000 } }
  return model:static { steps = 1 }:finish()
end
]]

case("hinge --help and a script of two nodes start in some milliseconds", function()
  -- The whole process, from the shell to its end, with its files on the disk (fsync). Beside it, in turn, two small
  -- processes that start and bring a file to the disk: what the machine has to do besides costs both. Seen: 4 ms beside
  -- 3 ms, and 8 to 14 ms beside three compilers on two cores. What other processes cost only adds, so that the least
  -- counts, and a try that is near enough to its own measure will do; there are more while the machine looks busy.
  local small = ("{ lua5.4 -v && dd if=/dev/zero of=%s bs=1 count=1 conv=fsync; }"):format(quote(folder .. "/small"))
  for what, command in pairs {
    ["hinge --help"] = hinge .. " --help",
    ["a two-node script"] = hinge .. " run " .. script("two_nodes.lua", two_nodes .. "cantilever()\n"),
  } do
    equal(support.run(command), 0, what .. ": status")
    local least, limit
    for try = 1, 6 do
      if try > 1 then support.run "sleep 1" end
      limit = support.largest_of(20, 6 * support.milliseconds(small, 5))
      least = support.milliseconds(command, 5)
      if least < limit then break end
    end
    print(("%s: %.1f ms, of at most %.0f"):format(what, least, limit))
    expect(least < limit, "%s takes %.1f ms; at most %.0f", what, least, limit)
  end
end)

-- What a process has loaded when its script ends.
local loaded = [[
local function loaded()
  local found = {}
  for line in io.lines "/proc/self/maps" do found[#found + 1] = line:match "/([^/]*%.so[^/]*)$" end
  return table.concat(found, " ")
end
]]
local function libraries(name, body)
  local command = script(name, two_nodes .. loaded .. body)
  local printed = checks.ended(0, "", support.run(hinge .. " run " .. command))
  return printed:match "loaded: ([^\n]*)" or ""
end

case("a script without pictures does not load VTK", function()
  local plain = libraries("plain.lua", "cantilever()\nprint('loaded: ' .. loaded())\n")
  expect(plain:find "libc%.", "the list of what is loaded: %s", plain)
  for _, name in ipairs { "vtk", "libhinge_output", "libX11", "libGL" } do
    expect(not plain:find(name, 1, true), "a script without pictures loads %s: %s", name, plain)
  end
end)

case("a script that writes a frame loads VTK", function()
  if support.is_there(arg[1] .. "/libhinge_output.so") then
    local drawn = libraries("drawn.lua", [[
return hinge.scenario {
  run = function(_, job)
    job:frame(cantilever())
    print("loaded: " .. loaded())
  end,
}
]])
    expect(drawn:find("libvtk", 1, true) and drawn:find("libhinge_output", 1, true),
      "a script that writes a frame has not loaded VTK: %s", drawn)
  else
    print "the picture module was not built: what it loads is not looked at"
  end
end)

case("a small script reads only the files of the library that it uses", function()
  local lines = script("few.lua", two_nodes .. [[
cantilever()
local read = {}
for name in pairs(package.loaded) do
  if name:find "^hinge%." then read[#read + 1] = name end
end
table.sort(read)
print("read: " .. table.concat(read, " "))
package.path = "/nowhere/?.lua" -- a script's own business
print("kN: " .. hinge.units.kN .. " " .. package.path)
local names = {}
for name in pairs(hinge) do names[#names + 1] = name end
table.sort(names)
print("all: " .. table.concat(names, " "))
print("unknown: " .. tostring(select(2, pcall(function() return hinge.grids end))))
]])
  local printed = checks.ended(0, "did you mean 'grid'", support.run(hinge .. " run " .. lines))
  local read = printed:match "read: ([^\n]*)" or ""
  expect(read:find("hinge.sections.material", 1, true), "what the script used is not in the list: %s", read)
  for _, unused in ipairs { "hinge.joints", "hinge.results.table", "hinge.plot.draw", "hinge.actions.blast",
    "hinge.import" } do
    expect(not read:find(unused, 1, true), "a cantilever reads %s: %s", unused, read)
  end
  expect(printed:find("kN: 1000.* /nowhere/%?%.lua\n"), "another package.path: %s", printed)
  local all = printed:match "all: ([^\n]*)" or ""
  for _, name in ipairs { "blast", "grid", "joint", "material", "model", "results", "version" } do
    expect((" " .. all .. " "):find(" " .. name .. " ", 1, true), "pairs(hinge) leaves out %s: %s", name, all)
  end
end)

checks.done()
