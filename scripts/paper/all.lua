-- Every figure and table of the paper, one after the other.
--
-- Run     hinge run scripts/paper/all.lua   (quick=true: coarser, under a minute; only=two_beam_impact: one)
-- Shows   the scripts of this folder with their defaults, each into a folder of its own name
-- Expect  a quarter of an hour on two busy cores. summary.json has the results of each script. A script that fails does
--         not stop the others; the exit status is then 1, and the reason names the script. A run that fails is a row of
--         its table
local hinge = require "hinge"
local jobs  = require "hinge.program.job"

local scripts = {
  "space_frame_static", "space_frame_dynamic", "fracture_figures", "two_beam_impact", "ten_storey_cases",
  "lost_inputs", "findings", "after_impact", "pounding_buildings",
  "demolition",
}
local folder = debug.getinfo(1, "S").source:match "^@(.*/)" or ""

return hinge.scenario {
  parameters = { quick = false, only = "" },
  run = function(p, job)
    local results, failed, start = {}, {}, os.time()
    for i, name in ipairs(scripts) do
      if p.only == "" or p.only == name then
        print(("\n==== %d of %d: %s (%d s so far)"):format(i, #scripts, name, os.difftime(os.time(), start)))
        local script = assert(loadfile(folder .. name .. ".lua"))()
        local quick = script.parameters.quick ~= nil and { { "quick", tostring(p.quick) } } or {}
        local own = jobs.new(job.out .. "/" .. name)
        local ok, result = xpcall(script.run, debug.traceback, script:values(nil, quick), own)
        results[name] = ok and result or nil
        for _, note in ipairs(own.notes) do job.notes[#job.notes + 1] = name .. ": " .. note end
        local why = not ok and tostring(result) or own.whole and own.whole.reason
        if why then
          failed[#failed + 1] = name
          job:note(("%s failed: %s"):format(name, why))
        end
      end
    end
    if next(results) == nil and #failed == 0 then
      error(("only=%s: no such script; must be one of %s"):format(p.only, table.concat(scripts, ", ")), 0)
    end
    job:verdict(#failed == 0 and "completed" or "failed", table.concat(failed, ", ") .. " failed; the notes say why")
    return results
  end,
}
