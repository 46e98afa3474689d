-- What many tests ask of a run: local runs = require "runs"(checks).
local support = require "support"

return function(checks)
  local runs = {}

  --- Finishes a run, which must be completed. Returns it.
  function runs.completed(run, what)
    run:finish()
    checks.equal(run.verdict, "completed", ("%s: verdict %s"):format(what or "run", run.reason))
    return run
  end

  --- The energy error is below a part of what moves: a field of run.energy, or J; of elastic and kinetic energy, at the
  --- start and now, if it is left out.
  function runs.balanced(run, part, of, what)
    local e = run.energy
    local most = math.abs(type(of) == "number" and of or of and e[of]
      or support.largest_of(e.elastic, e.kinetic, e.initial))
    checks.expect(most > 0, "%s: the energy balance has nothing to close", what)
    checks.expect(math.abs(e.energy_error) <= part * most, "%s: energy error %g of %g J", what, e.energy_error, most)
  end

  --- A run that goes on from a checkpoint after `at` (s) ends with the same bits: make() makes the run. Returns the
  --- whole run.
  function runs.resumes(make, at, what)
    local path, whole, saved = os.tmpname(), make(), nil
    for step in whole:steps() do
      if not saved and step.time >= at then
        saved = step.index
        whole:checkpoint(path)
      end
    end
    local resumed = make():resume(path)
    os.remove(path)
    checks.equal(resumed.index, saved, what .. ": steps done at the checkpoint")
    resumed:finish()
    checks.expect(whole.index > saved, "%s: nothing is left to do after the checkpoint", what)
    checks.equal(resumed.hash, whole.hash, what .. ": state after a checkpoint")
    for _, name in ipairs { "work", "energy_error" } do
      checks.equal(resumed.energy[name], whole.energy[name], ("%s: %s after a checkpoint"):format(what, name))
    end
    return whole
  end

  return runs
end
