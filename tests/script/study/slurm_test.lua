-- hinge study on a real Slurm, which this test starts and stops on the loopback address: a job array gives the same
-- files as the same study without it; tasks that are killed and requeued go on from their checkpoints with the same
-- bits. Where Slurm, munge or root are missing, or a cluster cannot be started, it says why and is skipped (status 77).
--
-- Run: lua5.4 tests/script/study/slurm_test.lua BUILD_FOLDER
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local checks = support.checks "slurm"
local case = checks.case
local quote, expect, equal = support.quote, checks.expect, checks.equal
local program = quote(arg[1] .. "/hinge")

local function skip(why)
  print("slurm: skipped, " .. why)
  os.exit(77, true) -- true: what is to be closed is closed
end

if support.output "id -u" ~= "0\n" then skip "a cluster of its own needs root" end
for _, name in ipairs { "slurmctld", "slurmd", "sbatch", "munged", "runuser" } do
  if support.run(("command -v %s || ls /usr/sbin/%s"):format(name, name)) ~= 0 then
    skip(name .. " is not installed (apt-get install slurm-wlm munge)")
  end
end

local folder = support.temporary_folder()
os.execute("chmod 711 " .. folder) -- munge looks in
support.write(folder .. "/s.lua", support.swinging_bar)
local function hinge_study(words) return support.run(("cd %s && %s study %s"):format(folder, program, words)) end

local cluster = folder .. "/cluster"
local control = quote(support.root .. "tests/slurm/cluster.sh")
local status, conf, complaint = support.run(("%s start %s"):format(control, cluster))
conf = conf:gsub("%s+$", "")
-- Stopped whatever comes; by a process of its own where this one is killed.
local watch = io.popen(("exec 3<&0; (setsid %s watch %s <&3 3<&- >/dev/null 2>&1 &)"):format(control, cluster), "w")
local stop <close> = setmetatable({}, { __close = function()
  support.run(("%s stop %s"):format(control, cluster))
  watch:close()
end })
assert(stop)
if status ~= 0 then skip("the cluster does not start: " .. complaint) end

local function slurm(words) return support.run(("cd %s && export SLURM_CONF=%s && %s"):format(folder, conf, words)) end
local function wait_for(what, seconds)
  for _ = 1, 10 * seconds do
    if what() then return true end
    os.execute "sleep 0.1"
  end
  return false
end
local function queue() return select(2, slurm "squeue -h -r -o '%A %a %T'") end

case("all cases run as a job array of two a task", function()
  -- All cases as a job array, two a task.
  hinge_study "s.lua speed=5,10,20 steps=2000 --out whole"
  local listed
  status, listed, complaint = slurm(program
    .. " study s.lua speed=5,10,20 steps=2000 --slurm --per-task 2 --out array")
  expect(status == 0 and listed:find "Submitted batch job", "submitting: %s%s", listed, complaint)
  expect(wait_for(function() return queue() == "" end, 120), "the array does not end: %s", queue())
  status = slurm(program .. " study s.lua speed=5,10,20 steps=2000 --out array --collect")
  equal(status, 0, "exit status of --collect")
  checks.same_files(folder .. "/array/results.csv", folder .. "/whole/results.csv", "results of the array")
end)

case("tasks that are signalled or requeued give the results of a plain study", function()
  local listed
  -- Long cases: one task gets the scheduler's signal, one is requeued without a word.
  local words = "s.lua speed=12,15 steps=150000"
  hinge_study(words .. " -j 2 --out long")
  status, listed, complaint = slurm(program .. " study " .. words .. " --slurm --out requeued")
  local job = listed:match "batch job (%d+)"
  expect(status == 0 and job, "submitting: %s%s", listed, complaint)
  local function checkpoint(task) return ("%s/requeued/cases/0000%d/c"):format(folder, task) end
  for task = 1, 2 do
    expect(wait_for(function() return support.is_there(checkpoint(task)) end, 60), "task %d writes no checkpoint", task)
  end
  os.execute "sleep 0.6"
  slurm(("scancel --signal=TERM --batch %s_1"):format(job))
  slurm(("scontrol requeue %s_2"):format(job))
  expect(wait_for(function() return queue() == "" end, 180), "the requeued tasks do not end: %s", queue())
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
end)

checks.done()
