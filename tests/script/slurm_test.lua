-- hinge study on a real Slurm, which this test starts and stops on the loopback address: a job array gives the same
-- files as the same study without it; tasks that are killed and requeued go on from their checkpoints with the same
-- bits. Where Slurm, munge or root are missing only what needs none of them is tested.
--
-- Run: lua5.4 tests/script/slurm_test.lua BUILD_FOLDER
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "?.lua;" .. package.path
local support = require "support"
local checks = support.checks "slurm"
local quote, expect, equal = support.quote, checks.expect, checks.equal
local program = quote(arg[1] .. "/hinge")

local folder = support.temporary_folder()
os.execute("chmod 711 " .. folder) -- munge looks in
support.write(folder .. "/s.lua", [[
local hinge = require "hinge"
return hinge.scenario {
  parameters = { speed = 10, steps = 20000 },
  run = function(p)
    local steel = hinge.material { E = 206e9, nu = 0.3, density = 7850, yield_stress = 235e6 }
    local model = hinge.model()
    local a, b = model:node { 0, 0, 0 }, model:node { 1, 0, 0 }
    model:fix(a, "all")
    model:member { a, b, section = hinge.section.solid { width = 0.02, depth = 0.02 }, material = steel }
    model:mass { node = b, mass = 1 }
    model:velocity(b, { 0, 0, p.speed })
    local run = model:dynamic { dt = 1e-5, duration = 1e-5 * p.steps, checkpoint = { file = "c", every = 0.2 } }
    local path = run:probe { node = b, "uz" }
    run:finish()
    return { uz = path.value[#path.value], largest = path.max, n = #path.value }
  end,
}
]])
local function hinge_study(words) return support.run(("cd %s && %s study %s"):format(folder, program, words)) end

-- The list of cases, one case by its number, and what --collect gathers: enough for any other queue.
local status, listed, complaint = hinge_study "s.lua speed=5,10,20 steps=2000 --list"
equal(status, 0, "exit status of --list: " .. complaint)
equal(listed, "1\tspeed=5\tsteps=2000\n2\tspeed=10\tsteps=2000\n3\tspeed=20\tsteps=2000\n", "the list of cases")
expect(not support.is_there(folder .. "/out"), "--list wrote something")
hinge_study "s.lua speed=5,10,20 steps=2000 --out whole"
for _, number in ipairs { "3", "1-2" } do
  status, listed, complaint = hinge_study("s.lua speed=5,10,20 steps=2000 --out parts --case " .. number)
  equal(listed, "", "what --case prints")
  equal(status, 0, "exit status of --case " .. number .. ": " .. complaint)
  local _, gathered = hinge_study "s.lua speed=5,10,20 steps=2000 --out parts --collect"
  expect(number == "1-2" or gathered:find "2 cases not ended yet", "what --collect says on the way: %s", gathered)
end
checks.same_files(folder .. "/parts/results.csv", folder .. "/whole/results.csv", "results of parts")
status, listed, complaint = hinge_study "s.lua speed=5 --case x"
equal(listed, "", "what is printed where the number is wrong")
expect(status == 2 and complaint:find "must be the number of a case", "a wrong number: %s", complaint)

-- The job array as text.
local text = select(2, hinge_study "s.lua speed=5,10,20 --slurm --dry-run --per-task 2 --sbatch '--time=5' --out 'a b'")
for _, line in ipairs { "#SBATCH --array=1-2\n", "#SBATCH --requeue\n", "--case \"$first-$last\"",
  "sbatch --time=5 " } do
  expect(text:find(line, 1, true), "the job array lacks %s:\n%s", line, text)
end
expect(not support.is_there(folder .. "/a b"), "--dry-run wrote something")

local function installed(name)
  return support.output(("command -v %s || ls /usr/sbin/%s 2>/dev/null"):format(name, name)) ~= ""
end
local lacking
for _, name in ipairs { "slurmctld", "slurmd", "sbatch", "munged" } do
  if not installed(name) then lacking = name .. " is not installed (apt-get install slurm-wlm munge)" end
end
if support.output "id -u" ~= "0\n" then lacking = "a cluster of its own needs root" end
if lacking then
  print("slurm: skipped on a real Slurm: " .. lacking)
  return checks.done()
end

-- A real cluster.
local cluster = folder .. "/cluster"
local control = quote(support.root .. "tests/slurm/cluster.sh")
local conf
status, conf, complaint = support.run(("%s start %s"):format(control, cluster))
conf = conf:gsub("%s+$", "")
-- stopped whatever comes
local stop <close> = setmetatable({}, { __close = function()
  support.run(("%s stop %s"):format(control, cluster))
end })
assert(stop)
if not expect(status == 0, "the cluster does not start: %s", complaint) then return checks.done() end

local function slurm(words) return support.run(("cd %s && export SLURM_CONF=%s && %s"):format(folder, conf, words)) end
local function wait_for(what, seconds)
  for _ = 1, 10 * seconds do
    if what() then return true end
    os.execute "sleep 0.1"
  end
  return false
end
local function queue() return select(2, slurm "squeue -h -r -o '%A %a %T'") end

-- All cases as a job array, two a task.
status, listed, complaint = slurm(program
  .. " study s.lua speed=5,10,20 steps=2000 --slurm --per-task 2 --out array")
expect(status == 0 and listed:find "Submitted batch job", "submitting: %s%s", listed, complaint)
expect(wait_for(function() return queue() == "" end, 30), "the array does not end: %s", queue())
status = slurm(program .. " study s.lua speed=5,10,20 steps=2000 --out array --collect")
equal(status, 0, "exit status of --collect")
checks.same_files(folder .. "/array/results.csv", folder .. "/whole/results.csv", "results of the array")

-- Long cases: one task gets the scheduler's signal, one is requeued without a word.
local words = "s.lua speed=12,15 steps=150000"
hinge_study(words .. " -j 2 --out long")
status, listed, complaint = slurm(program .. " study " .. words .. " --slurm --out requeued")
local job = listed:match "batch job (%d+)"
expect(status == 0 and job, "submitting: %s%s", listed, complaint)
local function checkpoint(task) return ("%s/requeued/cases/0000%d/c"):format(folder, task) end
for task = 1, 2 do
  expect(wait_for(function() return support.is_there(checkpoint(task)) end, 20), "task %d writes no checkpoint", task)
end
os.execute "sleep 0.6"
slurm(("scancel --signal=TERM --batch %s_1"):format(job))
slurm(("scontrol requeue %s_2"):format(job))
expect(wait_for(function() return queue() == "" end, 90), "the requeued tasks do not end: %s", queue())
status = slurm(program .. " study " .. words .. " --out requeued --collect")
equal(status, 0, "exit status of --collect after a requeue")
checks.same_files(folder .. "/requeued/results.csv", folder .. "/long/results.csv", "results after a requeue")
for task = 1, 2 do
  local name = ("/cases/0000%d/summary.json"):format(task)
  local resumed, whole = support.json(support.read(folder .. "/requeued" .. name) or "{}"),
    support.json(support.read(folder .. "/long" .. name) or "{}")
  expect((resumed.resumed_at or 0) > 0, "task %d did not go on from its checkpoint", task)
  equal(resumed.state_hash or "none", whole.state_hash, ("bits of task %d"):format(task))
end
checks.done()
