-- hinge study for a queue of jobs, without a queue: the list of cases, cases by their numbers, their collection, and
-- the job array for Slurm as text. slurm_test.lua submits it.
--
-- Run: lua5.4 tests/script/study/job_array_test.lua BUILD_FOLDER
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../?.lua;" .. package.path
local support = require "support"
local checks = support.checks "job array"
local case = checks.case
local quote, expect, equal = support.quote, checks.expect, checks.equal
local program = quote(arg[1] .. "/hinge")

local folder = support.temporary_folder()
support.write(folder .. "/s.lua", support.swinging_bar)
local function hinge_study(words) return support.run(("cd %s && %s study %s"):format(folder, program, words)) end

case("--collect gathers cases that were run one by one", function()
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
end)

case("the job array as text names its cases and tasks", function()
  -- The job array as text.
  local text = select(2,
    hinge_study "s.lua speed=5,10,20 --slurm --dry-run --per-task 2 --sbatch '--time=5' --out 'a b'")
  for _, line in ipairs { "#SBATCH --array=1-2\n", "#SBATCH --requeue\n", "--case \"$first-$last\"",
    "sbatch --time=5 " } do
    expect(text:find(line, 1, true), "the job array lacks %s:\n%s", line, text)
  end
  expect(not support.is_there(folder .. "/a b"), "--dry-run wrote something")
  expect(text:find("#SBATCH %-%-output=[^\n]*/a\\ b/slurm%-%%a.txt\n"), "the output's name with a blank:\n%s", text)
  text = select(2, hinge_study "s.lua speed=5 --slurm --dry-run --out 50%j")
  expect(text:find("#SBATCH %-%-output=[^\n]*/50%%%%j/slurm%-%%a.txt\n"), "a name with a percent sign:\n%s", text)
end)

case("a line break in a name is refused", function()
  local status, text, complaint
  -- A line break in a name would be a line of options for sbatch.
  local function refused(words, option)
    status, text, complaint = hinge_study(words .. " speed=5 --slurm --dry-run")
    expect(status == 2 and text == "" and complaint:find(option .. " .*must not hold a line break"),
      "a line break in %s: %s %s", option, status, text .. complaint)
  end
  refused("s.lua --out 'a\n#SBATCH --wrap=x'", "%-%-out")
  support.write(folder .. "/s\n#SBATCH --wrap=x.lua", support.swinging_bar)
  refused("'s\n#SBATCH --wrap=x.lua'", "SCRIPT")
end)

checks.done()
