-- What the tests of sections and their laws share: a cantilever that is pressed and pushed to its limit, and a portal
-- whose heads are struck, with what its energy, its integrators and its checkpoints must keep.
local scenes = require "scenes"
local law_scenes = {}

--- A cantilever of 3 m that N stretches or presses (case "axial"), with a push { y, z } on its tip (case "push").
--- `options`: of scenes.cantilever. Returns { model =, tip =, member = }.
function law_scenes.pressed(options, N, push)
  local model, tip, member = scenes.cantilever(scenes.with({ length = 3 }, options, {
    model = scenes.with({ displacement = "small" }, options.model),
    member = scenes.with({ up = { 0, 0, 1 } }, options.member) }))
  model:case "axial":load { node = tip, force = { N, 0, 0 } }
  model:case "push":load { node = tip, force = { 0, push[1], push[2] } }
  return { model = model, tip = tip, member = member }
end

--- The factor of the push at the limit of such a cantilever, beside the whole of N; and the run.
function law_scenes.limit(checks, scene)
  local held = scene.model:static { loads = { axial = 1 }, steps = 4 }:finish()
  local run = scene.model:static { from = held, loads = { push = 1 }, steps = 20, to_limit = true }:finish()
  checks.expect(run.reason:find "limit load" ~= nil, "ends at a limit load: %s", run.reason)
  return run.factor, run
end

--- A portal of 5 by 4 m whose heads, of 20 t, have a velocity that makes hinges. `options`: of scenes.portal.
function law_scenes.struck(options, velocity)
  local model, node = scenes.portal(scenes.with({ width = 5, height = 4 }, options, {
    column = scenes.with({ up = { 0, 1, 0 } }, options.column),
    beam = scenes.with({ up = { 0, 0, 1 }, elements = 4 }, options.beam) }))
  for i = 2, 3 do
    model:mass { node = node[i], mass = 20000 }
    model:velocity(node[i], velocity)
  end
  return model
end

--- Runs what make(method) builds by three methods: each closes its energy balance, and all dissipate the same. `o`:
--- duration, error (of the balance; a number, or by method), what, and how far plastic works may be apart: implicit
--- (0.01), explicit (nil: not compared).
function law_scenes.balances(checks, make, o)
  local work = {}
  for method, settings in pairs { newmark = { dt = 2e-4 }, explicit = { integrator = "explicit", dt = "auto" },
    conserving = { integrator = "energy-momentum", dt = 2e-4 } } do
    local run, what = make(method):dynamic(scenes.with(settings, { duration = o.duration })):finish(),
      (o.what and o.what .. ", " or "") .. method
    checks.equal(run.verdict, "completed", what .. ": " .. tostring(run.reason))
    checks.near(run.energy_error, 0, type(o.error) == "table" and o.error[method] or o.error, what .. ": energy error")
    work[method] = run.energy.plastic
    checks.expect(work[method] > 1e4, "%s: dissipates %g J", what, work[method])
  end
  checks.near(work.newmark / work.conserving, 1, o.implicit or 0.01, "plastic work, newmark over conserving")
  for _, method in ipairs(o.explicit and { "newmark", "conserving" } or {}) do
    checks.near(work[method] / work.explicit, 1, o.explicit, ("plastic work, %s over explicit"):format(method))
  end
end

--- A run that was saved after `o.steps` steps goes on to the same bytes. make(): the model. o.others: functions that
--- build models in which it must not go on, by each what the message names. `o`: dt (2e-4), duration.
function law_scenes.resumes(checks, make, o)
  local path, settings = os.tmpname(), { dt = o.dt or 2e-4, duration = o.duration }
  local run = make():dynamic(settings)
  for _ = 1, o.steps do run:step() end
  run:checkpoint(path)
  run:finish()
  checks.equal(make():dynamic(settings):resume(path):finish().hash, run.hash, "state")
  for other, words in pairs(o.others) do
    checks.refused(words, function() other():dynamic(settings):resume(path) end)
  end
  os.remove(path)
end

return law_scenes
