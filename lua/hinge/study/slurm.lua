-- hinge study --slurm: the study as a job array. Each task runs some cases by `hinge study ... --case A-B`, which
-- leaves finished ones alone, so a task that runs again goes on where it ended.
local core = require "hinge.core"
local check = require "hinge.library.check"
local quote = require "hinge.library.quote"

local slurm = {}

-- The study's own command, with whole paths, since a task starts elsewhere.
local function command(options, folder)
  local parts = { quote.shell(core.program()), "study", quote.shell(core.whole_path(options.script)) }
  for _, word in ipairs(options.words) do parts[#parts + 1] = quote.shell(word) end
  for _, name in ipairs { "cases", "samples", "method", "seed", "timeout", "memory", "within", "answers" } do
    if options[name] then parts[#parts + 1] = ("--%s %s"):format(name, quote.shell(options[name])) end
  end
  if options.table then parts[#parts + 1] = "--table " .. quote.shell(core.whole_path(options.table)) end
  parts[#parts + 1] = "--out " .. quote.shell(folder)
  return table.concat(parts, " ")
end

--- The script of the job array. options: those of the command line; total: cases; folder: whole path.
function slurm.script(options, total, folder)
  local per_task = math.tointeger(tonumber(options.per_task or 1))
  if not per_task or per_task < 1 then
    check.fail("--per-task %s: must be a whole number of at least 1", options.per_task)
  end
  local name = quote.sbatch("SCRIPT", "hinge-" .. (options.script:match "([^/]*)%.lua$" or "study"))
  local output = quote.sbatch("--out", folder:gsub("%%", "%%%%") .. "/slurm-%a.txt")
  local tasks = (total + per_task - 1) // per_task
  local at_once = options.jobs and "%" .. options.jobs or ""
  return ([[
#!/bin/bash
#SBATCH --job-name=%s
#SBATCH --array=1-%d%s
#SBATCH --requeue
#SBATCH --open-mode=append
#SBATCH --signal=B:TERM@60
#SBATCH --output=%s
# Cases of this task; the last task may have fewer.
first=$(( (SLURM_ARRAY_TASK_ID - 1) * %d + 1 ))
last=$(( first + %d > %d ? %d : first + %d ))

# The scheduler's signal: the cases under way write their checkpoints, and the task goes back into the queue.
trap 'kill -TERM "$study" 2>/dev/null' TERM
%s -q -j "${SLURM_CPUS_PER_TASK:-1}" --case "$first-$last" &
study=$!
wait "$study"; status=$?
if [ "$status" -gt 128 ]; then wait "$study"; status=$?; fi # the signal ended the first wait, not the study
if [ "$status" -eq 3 ]; then
  scontrol requeue "${SLURM_ARRAY_JOB_ID}_${SLURM_ARRAY_TASK_ID}"
  exit 0
fi
exit "$status"
]]):format(name, tasks, at_once, output, per_task, per_task - 1, total, total, per_task - 1, command(options, folder))
end

--- Writes and submits the job array, or prints it. Returns the exit status.
function slurm.submit(options, total)
  local folder = core.whole_path(options.out)
  local text, path = slurm.script(options, total, folder), folder .. "/study.sbatch"
  local submit = ("sbatch %s%s"):format(options.sbatch and options.sbatch .. " " or "", quote.shell(path))
  if options.dry_run then
    io.stdout:write(text)
    print("# " .. submit)
    return 0
  end
  core.own_output(options.out, { script = core.whole_path(options.script), study = table.concat(options.words, " ") },
    true)
  core.lock(options.out, true)
  core.write_text(path, text)
  local pipe = io.popen(submit .. " 2>&1")
  local said = pipe:read "a"
  if not pipe:close() then
    check.fail("--slurm: %s: %s", submit, check.one_line(said))
  end
  io.stdout:write(said)
  print(("%s in %s; hinge study ... --collect gathers what has ended"):format(check.count(total, "case"), options.out))
  return 0
end

return slurm
