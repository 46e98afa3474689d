-- Every figure and table of the paper, one after the other.
--
-- Run     hinge run scripts/paper/all.lua                   (quick=true: coarser, under a minute; only=two_beam_impact: one)
-- Shows   the scripts of this folder with their defaults, each into a folder of its own name
-- Expect  6 minutes on two cores; summary.json holds what each script returned
local hinge = require "hinge"
local jobs  = require "hinge.job"

local scripts = {
  "space_frame_static", "space_frame_dynamic", "fracture_figures", "two_beam_impact", "ten_storey_cases",
  "ten_storey_sensitivity",
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
        if not ok then
          failed[#failed + 1] = name
          job:note(("%s failed: %s"):format(name, result))
        end
      end
    end
    if next(results) == nil and #failed == 0 then
      error(("only=%s: no such script; must be one of %s"):format(p.only, table.concat(scripts, ", ")), 0)
    end
    if #failed > 0 then error("failed: " .. table.concat(failed, ", "), 0) end
    return results
  end,
}
