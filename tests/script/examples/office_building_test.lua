-- The worked example, scripts/office_building.lua: each of its parts for a small building. Verdicts and energy errors;
-- reactions are the weight; drifts are those of the nodes; end plates break in the blast and not at rest;
-- the table of lost columns has each column of the ground floor.
--
-- Run: lua5.4 tests/script/examples/office_building_test.lua, with the module on LUA_CPATH
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local hinge = require "hinge"
local new_job = require("hinge.program.job").new
local checks = support.checks "office building"
local case, near, equal, expect = checks.case, checks.near, checks.equal, checks.expect

local path = support.root .. "scripts/office_building.lua"
local office = dofile(path)
local bays_x, bays_y, storeys, bay, height, g = 2, 1, 2, 6, 4, 9.80665
local scenes = require "scenes"
local with = scenes.with

-- Runs a part of the small building. Returns its results and its runs; `watch` gets each dynamic run before it starts.
local function part(name, changes, watch)
  local values = office:values "small"
  for key, value in pairs(with({ part = name }, changes)) do values[key] = value end
  local ok, results, runs = scenes.runs_of(office.run, function(run)
    if watch and run.kind == "dynamic" then watch(run) end
  end, values, new_job(support.temporary_folder()))
  assert(ok, results)
  return results, runs
end

-- All runs completed, and the energy balance of dynamics closes within 0.5 % of the largest energy.
local function completed(runs, what)
  expect(#runs > 0, "%s: no run", what)
  for i, run in ipairs(runs) do
    equal(run.verdict, "completed", ("%s, run %d: verdict; %s"):format(what, i, run.reason))
    if run.kind == "dynamic" then near(run.energy_error, 0, 5e-3, what .. ": energy error") end
  end
end

-- Joints of statics do not break: a run warns of one that is beyond its capacity.
local function none_beyond_capacity(runs, what)
  for _, run in ipairs(runs) do
    for _, warning in ipairs(run.warnings) do
      expect(not warning:find "beyond its capacity", "%s: %s", what, warning)
    end
  end
end

case("it is shorter than a hundred lines", function()
  local _, lines = support.read(path):gsub("\n", "")
  expect(lines < 100, "%d lines", lines)
end)

case("static: the reactions are 1.35 of the dead load and 1.5 of the live load", function()
  local results, runs = part "static"
  completed(runs, "static")
  none_beyond_capacity(runs, "static")
  -- Lengths of columns, main beams, beams along y and rods (two in each storey of four bays), m.
  local named = hinge.section.named
  local volume = (bays_x + 1) * (bays_y + 1) * storeys * height * named("HEB 300").area
    + (bays_y + 1) * bays_x * bay * storeys * named("IPE 400").area
    + (2 * bays_x + 1) * bays_y * bay * storeys * named("HEA 240").area
    + 4 * 2 * storeys * math.sqrt(bay ^ 2 + height ^ 2) * math.pi / 4 * 0.07 ^ 2
  local floors = storeys * bays_x * bay * bays_y * bay -- m^2
  local mass = 7850 * volume + 400 * floors
  near(results.base / (g * (1.35 * mass + 1.5 * 300 * floors)), 1, 1e-6, "reactions over the loads")
end)

-- The drift of a column line of the first storey is held by a probe of its own, along x.
case("earthquake: it completes, and the drift is that of the nodes", function()
  local probes = {}
  local results, runs = part("earthquake", { dt = 5e-3, duration = 0.75 }, function(run)
    local at = {}
    for _, node in ipairs(run.model:nodes()) do at[("%g %g %g"):format(node.x, node.y, node.z)] = node end
    for i = 0, bays_x do
      for j = 0, bays_y do
        local low, high = at[("%g %g 0"):format(i * bay, j * bay)], at[("%g %g %g"):format(i * bay, j * bay, height)]
        probes[#probes + 1] = { run:probe { node = low, "ux" }, run:probe { node = high, "ux" } }
      end
    end
  end)
  completed(runs, "earthquake")
  none_beyond_capacity(runs, "earthquake")
  local drift = 0
  for _, pair in ipairs(probes) do
    for i, low in ipairs(pair[1].value) do
      drift = support.largest_of(drift, math.abs(pair[2].value[i] - low) / height)
    end
  end
  equal(#probes, (bays_x + 1) * (bays_y + 1), "column lines")
  expect(drift > 1e-5, "the frame hardly moves: %g", drift)
  near(results.drift / drift, 1, 1e-9, "drift of hinge.results over that of the nodes")
  expect(results.period > 0.1 and results.period < 1, "the first period is %g s", results.period)
end)

case("blast: end plates break; with 1 kg of TNT in place of 500 kg none does", function()
  local results, runs = part("blast", { duration = 0.1 })
  completed(runs, "blast")
  none_beyond_capacity({ runs[1] }, "at rest")
  expect(results.broken > 0, "no end plate broke")
  local quiet, of_quiet = part("blast", { charge = 1, duration = 0.1 })
  completed(of_quiet, "1 kg of TNT")
  equal(quiet.broken, 0, "end plates that broke by 1 kg of TNT")
end)

-- hinge.robustness closes its models, and is an error where a row has failed.
case("robustness: a row for each column of the ground floor", function()
  equal(part("robustness").cases, (bays_x + 1) * (bays_y + 1), "rows")
end)

checks.done()
