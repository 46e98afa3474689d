-- One or two cases of each of scripts/studies give the numbers that the scripts' heads state.
--
-- Run: lua5.4 tests/script/study/studies_test.lua BUILD_FOLDER
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local checks = support.checks "studies"
local case = checks.case
local quote, expect, equal, near = support.quote, checks.expect, checks.equal, checks.near
local program = quote(arg[1] .. "/hinge")
local folder = support.temporary_folder()

-- The command of a study as the head of its script has it, without the program and the options from -j or --out on.
local function command(name, nth)
  local head = support.read(support.root .. "scripts/studies/" .. name .. ".lua"):match "^(.-)\nlocal "
  local all = {}
  for line in head:gsub("\\\n%-%-%s*", ""):gmatch "hinge (study [^\n]*)" do
    all[#all + 1] = line:gsub(" %-j .*", ""):gsub(" %-%-out .*", "")
  end
  return assert(all[nth or 1], name .. ": the head does not say how to run it"), head
end

-- `name = number within number` or `exactly` of a head: the first one of a name.
local function stated(head, name)
  local value, within = head:match(name .. " = (%-?[%d.]+) within ([%d.]+)")
  return tonumber(value or head:match(name .. " = (%-?[%d.]+) exactly")), tonumber(within or 0)
end

-- Runs cases of a study by their numbers; returns their results by number, as summary.json has them.
local function run(name, words, ...)
  local out, found = folder .. "/" .. name, {}
  for _, number in ipairs { ... } do
    local status, _, complaint = support.run(("cd %s && %s %s -q --out %s --case %d")
      :format(quote(support.root), program, words, out, number))
    equal(status, 0, ("%s, case %d: exit status; %s"):format(name, number, complaint))
    local summary = support.read(("%s/cases/%05d/summary.json"):format(out, number))
    found[number] = summary and support.json(summary).results or {}
  end
  return found
end

local function as_stated(results, head, name, what)
  local value, within = stated(head, name)
  if expect(value, "%s: the head does not state %s", what, name) then
    near(results[name] or 0 / 0, value, within, ("%s: %s"):format(what, name))
  end
end

local words, head = command "robustness"
case("single cases of a study run by their numbers with the same results", function()
  local found = run("robustness", words, 1, 19)
  equal(found[1].outcome, "holds", "robustness, case 1")
  as_stated(found[1], head, "dynamic_factor", "robustness, case 1")
  equal(found[19].outcome, "full collapse", "robustness, case 19")
  as_stated(found[19], head, "largest_drop", "robustness, case 19")
  near(found[1].drop / found[1].static_drop, found[1].dynamic_factor, 1e-9, "what the dynamic factor is")

  words, head = command "aircraft"
  found = run("aircraft", words .. " path=1", 1)
  as_stated(found[1], head, "hinged", "aircraft")
  as_stated(found[1], head, "touched", "aircraft")
  near(0.5 * 1e3 * found[1].mass_t * 100 ^ 2, 0.5 * 15000 * (440 / 3.6) ^ 2, 1, "aircraft: energy of Case I")

  words, head = command "fragility"
  found = run("fragility", words, 1, 2)
  as_stated(found[1], head, "drop_mm", "fragility, case 1")
  equal(found[1].lost, false, "fragility, case 1 is lost")
  equal(found[2].lost, true, "fragility, case 2 is lost")
end)

case("halving finds the speed between the last case that is lost and the last that is not", function()
  -- The speed that halving finds lies between the last case that is lost and the last that is not.
  local status, _, complaint = support.run(("cd %s && %s %s -q --out %s/halving")
    :format(quote(support.root), program, command("fragility", 2), folder))
  equal(status, 0, "halving: " .. complaint)
  local most_that_holds, least_that_is_lost, cases = -math.huge, math.huge, 0
  local table_of_results = support.read(folder .. "/halving/results.csv") or ""
  for speed, lost in table_of_results:gmatch "\n%d+,([%d.]+),completed,[^\n]-(%a+),[^\n]*" do
    cases = cases + 1
    if lost == "true" then least_that_is_lost = support.smallest_of(least_that_is_lost, tonumber(speed))
    else most_that_holds = support.largest_of(most_that_holds, tonumber(speed)) end
  end
  equal(cases, 10, "cases of halving")
  local speed, within = stated(head, "speed")
  near((most_that_holds + least_that_is_lost) / 2, speed, within, "speed at which the column is lost")
  local known_to = least_that_is_lost - most_that_holds
  expect(known_to <= 0.05, "the speed is known to %g m/s", known_to)
end)

checks.done()
