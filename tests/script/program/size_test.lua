-- Large models: how large, how long and how much memory is said before the work begins, and what will not fit into the
-- memory is refused at the script's line.
--
-- Run: lua5.4 tests/script/program/size_test.lua BUILD_FOLDER
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local checks = support.checks "size"
local case, ended, expect, equal, near = checks.case, checks.ended, checks.expect, checks.equal, checks.near

local folder = support.temporary_folder()
local function run(limits, arguments)
  return support.run(("cd '%s' && %s '%s/hinge' run scene.lua --out out %s"):format(folder, limits, arg[1],
    arguments or ""))
end

-- A frame of n x n bays and n storeys; a row of members.
local frame = [[
local hinge = require "hinge"
local steel = hinge.material { E = 206e9, nu = 0.3, density = 7850 }
local section = hinge.section.solid { width = 0.3, depth = 0.3 }
local model, before, n = hinge.model(), {}, tonumber((...).n)
for z = 0, n do
  local floor = {}
  for x = 0, n do for y = 0, n do
    local at = x * (n + 1) + y
    local node = model:node { 5 * x, 5 * y, 3 * z }
    floor[at] = node
    if z == 0 then model:fix(node) else
      model:member { before[at], node, section = section, material = steel }
      if x > 0 then model:member { floor[at - n - 1], node, section = section, material = steel } end
      if y > 0 then model:member { floor[at - 1], node, section = section, material = steel } end
    end
  end end
  before = floor
end
model:gravity { 0, 0, -9.81 }
model:static { steps = 1, record = false }:finish()
]]
support.write(folder .. "/scene.lua", frame)

case("a model that does not fit into memory is refused before it is factorised", function()
  -- 198,440 members with 4 GB of memory: the factors alone take 10.3 GB.
  local _, complaint = ended(2, "", run("ulimit -t 60; ulimit -v 4000000;", "n=40"))
  local members = 40 * (41 ^ 2 + 2 * 40 * 41) // 1 | 0
  equal(members, 198440, "members")
  local lines = {}
  for line in complaint:gmatch "[^\n]+" do lines[#lines + 1] = line end
  equal(lines[1], "a large model: 100,000 members so far", "the first line")
  -- free: all nodes but those of the ground; a node within each member of two elements
  local nodes = 41 ^ 3 // 1 | 0
  equal(lines[2], "a large model: 198,440 members, 396,880 elements, 267,361 nodes, at most 1,604,166 degrees of "
    .. "freedom", "how large")
  equal(nodes + members, 267361, "nodes")
  expect((lines[3] or ""):find("^hinge: scene%.lua:20: model:static: a run of it factorises the stiffness of 1,594,080 "
    .. "degrees of freedom: about %d+%.%d GB of memory, and %d[%d.]* [MG]B are left; make the model smaller"),
    "it does not fit: %s", lines[3])
  equal((nodes + members - 41 ^ 2) * 6, 1594080.0, "free degrees of freedom")
  equal(#lines, 3, "lines")
end)

case("the memory that is foretold is near what a run takes", function()
  -- What is foretold is near what is taken: the most memory of a run, of which the program itself has some.
  support.write(folder .. "/scene.lua", (frame:gsub("model:static", "print(require 'hinge.core'.peak())\n%0")
    .. "print(require 'hinge.core'.peak())\n"))
  local _, printed, complaint_of_9 = run("", "n=9")
  local first, last = printed:match "(%d[%d.e+]*)\n(%d[%d.e+]*)"
  local taken = (tonumber(last) or 0) - (tonumber(first) or 0)
  expect(not complaint_of_9:find "a large model", "2,520 members are not large: %s", complaint_of_9)
  local _, _, complaint = run("ulimit -v 60000;", "n=9")
  local foretold = tonumber(complaint:match "about (%d+) MB of memory, and")
  if expect(foretold, "n = 9 does not fit into 60 MB: %s", complaint) then
    near(taken / 1e6 / foretold, 1, 0.4, ("memory taken, %.0f MB, over that foretold"):format(taken / 1e6))
  end
end)

case("a large dynamic run says how much memory it takes, once a model", function()
  support.write(folder .. "/scene.lua", [[
local hinge = require "hinge"
local model = hinge.model()
local last = model:node { 0, 0, 0 }
model:fix(last)
local section, material = hinge.section.solid { width = 1, depth = 1 }, hinge.material { E = 1e9, density = 1000 }
for i = 1, 20000 do
  local node = model:node { i, 0, 0 }
  model:member { last, node, section = section, material = material }
  last = node
end
for _ = 1, 2 do model:dynamic { dt = 1e-5, duration = 1e-5, integrator = "explicit", record = false } end
]])
  local _, complaint = ended(0, "", run "")
  expect(complaint:find "^a large model: 20,000 members, 40,000 elements, 40,001 nodes, at most 240,006 degrees of "
    and complaint:find "\na dynamic run of it takes about %d+ MB of memory; [%d.]+ [MG]B are left\n", "dynamics: %s",
    complaint)
  equal(select(2, complaint:gsub("a large model", "")), 1, "the same model again")
  expect(not select(3, run("", "-q")):find "large", "-q")
  local _, events = run("", "--json")
  expect(events:find '"event":"size"', "--json: %s", events)
end)

checks.done()
