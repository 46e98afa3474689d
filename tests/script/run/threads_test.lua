-- Any number of threads: the same bits. A frame of some thousand elements that moves, in implicit and in explicit
-- steps, and the ten-storey impact with contact, hinges and fracture.
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local scenes = require "scenes"
local hinge = require "hinge"
local core = require "hinge.core"
local building = require "hinge.models.ten_storey"
local impact = require "hinge.models.ten_storey_impact"
local checks = support.checks "threads"
local case = checks.case

-- Takes a run with each number of threads to its end; all must come to the same bits.
local function compare(what, numbers, run_with)
  local first
  for _, threads in ipairs(numbers) do
    local run = run_with(threads)
    local start = run.hash
    run:finish()
    first = first or run.hash
    checks.equal(run.verdict, "completed", ("%s, %s threads: verdict"):format(what, threads))
    checks.expect(run.index >= 20 and run.hash ~= start, "%s: %d steps, and moves", what, run.index)
    checks.equal(run.hash, first, ("%s: hash with %s threads"):format(what, threads))
  end
  return first
end

-- 8 x 8 bays, 9 storeys: 4050 elements, 2754 nodes, several pieces of work for each thread in each loop.
local function frame()
  local model = hinge.model {}
  building.add(model, { bays = { 8, 8 }, storeys = 9 })
  model:velocity("building", { 3, 1, 0 })
  return model
end
case("a frame has the same bits on one, two, three threads and as many as suit it", function()
  checks.expect(frame():counts().elements > 3000, "a frame of %d elements", frame():counts().elements)
  local seen = {}
  for what, base in pairs {
    ["frame, implicit, single precision"] = { dt = 1e-5, duration = 2e-4 },
    ["frame, implicit, double precision"] = { dt = 1e-5, duration = 2e-4, precision = "double" },
    ["frame, explicit"] = { dt = "auto", duration = 4e-3, integrator = "explicit" },
  } do
    local hash = compare(what, { 1, 2, 3, "auto" }, function(threads)
      return frame():dynamic(scenes.with(base, { threads = threads, record = false }))
    end)
    checks.expect(not seen[hash], "%s differs from another way", what)
    seen[hash] = true
  end
end)

case("Case I has the same bits on one and two threads", function()
  for what, base in pairs {
    ["Case I, implicit"] = { dt = 1e-5, beta = 0.4 },
    ["Case I, explicit"] = { dt = 1e-5, integrator = "explicit" },
  } do
    local run
    compare(what, { 1, 2 }, function(threads)
      local model = hinge.model {}
      local _, plane = impact.add(model, impact.parameters())
      run = model:dynamic(scenes.with(base, { threads = threads, record = false, duration = 300 * base.dt,
        from = model:static { fixed_group = plane, record = false }:finish() }))
      return run
    end)
    local bound, yielded = run.contacts.bound, run:count { state = "yielded" }
    checks.expect(run.index == 300 and yielded > 0, "%s: %d steps, %d members yielded", what, run.index, yielded)
    print(("%s, %d steps: %d pairs bound so far, %d members yielded"):format(what, run.index, bound, yielded))
  end
end)

-- A case of a study may go on with a run of the script's. Its process has no thread of it.
case("a run of two threads goes on in another process, and ends there", function()
  local base = { dt = 1e-5, duration = 1e-4, record = false }
  local expected = frame():dynamic(scenes.with(base, { threads = 1 })):finish().hash
  local run = frame():dynamic(scenes.with(base, { threads = 2 }))
  run:step()
  local process = core.start(function()
    local same = run:finish().hash == expected
    run = nil
    collectgarbage() -- closes the run, whose threads are not here
    return same and 0 or 1
  end, os.tmpname(), 0, false)
  local ended, how, status = core.wait(20)
  if ended ~= process then core.kill(process, false) end
  checks.expect(ended == process and how == "exit" and status == 0, "the process: %s, %s", how, status)
  checks.equal(run:finish().hash, expected, "the run itself")
end)

case("cases that run side by side share the cores", function()
  local cores = core.cores()
  for _, jobs in ipairs { 1, cores, 2 * cores } do
    core.start(core.cores, os.tmpname(), 0, false, jobs)
    local _, how, status = core.wait(20)
    checks.equal(how, "exit", ("%d jobs"):format(jobs))
    checks.equal(status, jobs <= cores and cores // jobs or 1, ("cores of a case of %d"):format(jobs))
  end
end)

checks.done()
