-- Same script, same machine: the same bits. Two runs of the ten-storey impact, one after the other and two at once.
--
-- Run: lua5.4 tests/script/run/determinism_test.lua BUILD_FOLDER SECONDS    (simulated; 0.02 is 2000 steps)
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local checks = support.checks "determinism"
local case = checks.case
local quote, equal = support.quote, checks.equal

local folder = support.temporary_folder()
local function command(i)
  return ("%s run %s duration=%s frame_every=1e9 --out %s"):format(quote(arg[1] .. "/hinge"),
    quote(support.root .. "scripts/ten_storey_impact.lua"), arg[2], quote(folder .. "/" .. i))
end
case("one run and two at once have the same bits and files", function()
  local status, _, complaint = support.run(command(1))
  equal(status, 0, "first run: " .. complaint)
  status, _, complaint = support.run(("{ %s & %s ; wait $! ; }"):format(command(2), command(3)))
  equal(status, 0, "two at once: " .. complaint)

  local function read(i, name) return support.read(("%s/%d/%s"):format(folder, i, name)) or "" end
  local first = support.json(read(1, "summary.json"))
  checks.expect(first.steps == math.floor(arg[2] / 1e-5 + 0.5) and first.results.damage.fuselage.touched > 0,
    "%s steps, with contact", first.steps)
  for i = 2, 3 do
    equal(support.json(read(i, "summary.json")).state_hash, first.state_hash, "state_hash of run " .. i)
    for _, name in ipairs { "history.csv", "history-1.csv" } do
      checks.expect(#read(1, name) > 400 and read(i, name) == read(1, name), "%s of run %d", name, i)
    end
  end
  print(("%d steps: state_hash %s"):format(first.steps, first.state_hash))
end)

checks.done()
