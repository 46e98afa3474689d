-- The kernel's walls around a script in the sandbox, without those of Lua: plain Lua has io and os, and raises them by
-- core.raise_walls as the program does. Another process draws. Ends as skipped where the kernel lacks a wall.
--
-- Run: lua5.4 tests/script/program/sandbox_walls_test.lua
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local core = require "hinge" and require "hinge.core"
local checks = support.checks "sandbox_walls"
local case, ended, expect, equal = checks.case, checks.ended, checks.expect, checks.equal

local folder = support.temporary_folder()
local lua = arg[-1]

-- Runs a script in plain Lua that has a folder `out` and stands behind the walls; returns status, what it printed and
-- what it complained of.
local function behind(script)
  support.write(folder .. "/s.lua", ([[
local hinge = require "hinge"
local core = require "hinge.core"
core.own_output("out", {}, true)
core.raise_walls("s.lua", "out")
local function refused(what, done, why) if done then print(what .. " was possible") else print(why) end end
]]) .. script)
  return support.run(("cd %s && rm -rf out && %s s.lua"):format(support.quote(folder), lua))
end

local _, _, complaint = behind "print 'there'"
if complaint:find "this kernel lacks" then
  print("SKIPPED, nothing was tried: " .. complaint)
  os.exit(77)
end

case("nothing is started and nothing is opened outside of the folder", function()
  support.write(folder .. "/mine", "mine")
  local printed = ended(0, "", behind [[
refused("os.execute", os.execute "touch ../started")
refused("io.popen", io.popen "touch ../started")
refused("reading", io.open "/etc/passwd")
refused("reading beside it", io.open "mine")
refused("writing beside it", io.open("mine", "w"))
refused("a new file", io.open("new", "w"))
refused("removing", os.remove "mine")
refused("renaming", os.rename("mine", "out/mine"))
refused("a module", package.loadlib("/tmp/absent.so", "*"))
refused("a process", pcall(core.start, function() return 0 end, "out/log", 0, false))
assert(io.open("out/file", "w")):close()
assert(os.rename("out/file", "out/other"))
assert(os.remove "out/other")
assert(io.open "s.lua")
print "end"
]])
  expect(not printed:find "possible" and printed:find "end\n$", "what it could: %s", printed)
  for _, name in ipairs { "started", "new" } do
    expect(not support.is_there(folder .. "/" .. name), "%s was made", name)
  end
  equal(support.read(folder .. "/mine"), "mine", "the file beside it")
end)

case("threads, pictures, strips, frames, plots and checkpoints are the same as without walls", function()
  local script = [[
local steel = hinge.material { E = 206e9, density = 7850, yield_stress = 245e6 }
local model = hinge.model {}
local a, b = model:node { 0, 0, 0 }, model:node { 0, 0, 3 }
model:fix(a)
model:member { a, b, section = hinge.section.named "HEB 300", material = steel, group = "it's" }
model:load { node = b, force = { 2e6, 0, 0 } }
local run = model:dynamic { dt = 1e-4, duration = 2e-3, threads = 2, checkpoint = "out/run.checkpoint" }
run:finish()
hinge.frame(run)
hinge.picture(run, { title = "a column", groups = { "it's" }, loads = true, plane = { x = 0 } }, "x.png")
hinge.strip({ { run, { show = "Mx" } }, { run:snapshot(), {} } }, 2, "strip.png")
hinge.plot({ title = "it's", series = { { name = "a\nb", x = { 1, 2, 3 }, y = { 1, 0 / 0, 1e300 } } } }, "x.svg")
hinge.plot(run, "run.pdf")
run:checkpoint "out/again.checkpoint"
]]
  local files = { "frames.pvd", "frames/frame_00001.vtp", "x.png", "strip.png", "x.gp", "x.dat", "x.svg", "run.gp",
    "run.dat", "history.csv" }
  local inside, outside = {}, {}
  equal(ended(0, "", behind(script)), "", "notes")
  for _, name in ipairs(files) do inside[name] = support.read(folder .. "/out/" .. name) end
  expect(support.is_there(folder .. "/out/again.checkpoint") and support.is_there(folder .. "/out/run.pdf"), "files")
  support.write(folder .. "/s.lua", "local hinge = require 'hinge' local core = require 'hinge.core' "
    .. "core.own_output('out', {}, true)\n" .. script)
  ended(0, "", support.run(("cd %s && rm -rf out && %s s.lua"):format(support.quote(folder), lua)))
  for _, name in ipairs(files) do outside[name] = support.read(folder .. "/out/" .. name) end
  for _, name in ipairs(files) do
    expect(inside[name] and inside[name] == outside[name], "%s differs from the one without walls", name)
  end
end)

case("the process that draws refuses what is no plot and what lies outside", function()
  for script, message in pairs {
    ["core.draw_packed('out/x.svg', 'x')"] = "the bytes of a plot are not valid",
    ["core.draw_packed('out/x.svg', '')"] = "the bytes of a plot are not valid",
    ["core.draw_packed('out/x.svg', string.pack('<c1i8', 'm', 1 << 40))"] = "the bytes of a plot are not valid",
    ["core.draw_packed('x.svg', require 'hinge.plot.data'.pack { panels = {} })"] = "is outside the output folder out",
    ["core.draw_packed('/tmp/x.svg', require 'hinge.plot.data'.pack { panels = {} })"] =
      "is outside the output folder out",
    ["core.draw_packed('out/\\nx.svg', '')"] = "it must not have line breaks",
  } do
    ended(1, message, behind("print(" .. script .. ")"))
  end
  expect(not support.is_there(folder .. "/x.svg"), "a plot outside")
end)

case("a plot has no functions, cycles or metatables", function()
  local data = require "hinge.plot.data"
  local sent = { 1, 2.5, "text", true, { -0.0, 1 / 0, a = false, [3] = "x\0y" }, n = math.mininteger }
  local got = data.unpack(data.pack(sent))
  equal(got[2], 2.5, "a number")
  equal(math.type(got[1]), "integer", "an integer")
  equal(got[5][3], "x\0y", "a text")
  expect(got[5].a == false and got[5][2] == 1 / 0 and got.n == math.mininteger, "the rest")
  expect(data.unpack(data.pack { 0 / 0 })[1] ~= data.unpack(data.pack { 0 / 0 })[1], "not a number")
  local cycle = {}
  cycle[1] = cycle
  for _, bad in ipairs { cycle, { print }, { io.stdout }, { coroutine.create(print) } } do
    expect(not pcall(data.pack, bad), "a plot with %s", tostring(bad[1]))
  end
end)

case("gnuplot starts no program and writes beside the picture alone, in the sandbox or not", function()
  local away = support.temporary_folder()
  local plot = "set terminal svg\nset output 'x.svg'\nplot x\nunset output\n"
  for _, command in ipairs { "system 'touch %s/no'", "!touch %s/no", "x = system('touch %s/no')",
    "plot '<touch %s/no'", "set print '|touch %s/no'", "set table '|touch %s/no'\nplot x\nunset table",
    "set output '|touch %s/no'\nplot x\nunset output", "set print '%s/no'\nprint 1", "load '<touch %s/no'",
    "set terminal svg\nset output '%s/no'\nplot x", "save '%s/no'",
    "system '/lib64/ld-linux-x86-64.so.2 /bin/touch %s/no'" } do
    pcall(core.draw_plot, folder .. "/x.svg", "set terminal svg\n" .. command:format(away) .. "\n" .. plot, "")
    expect(not support.is_there(away .. "/no"), "gnuplot did %s", command)
    os.remove(away .. "/no")
  end
  os.remove(folder .. "/x.svg")
  core.draw_plot(folder .. "/x.svg", plot, "")
  expect(support.is_there(folder .. "/x.svg"), "a plot")
end)

checks.done()
