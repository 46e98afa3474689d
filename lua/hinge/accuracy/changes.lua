-- What hinge changes in the runs of a script by itself: time step, elements a member, integrator, steps of load; and
-- the physical numbers by a part of 1e-9. The script does not change: the engine asks for the options of each run
-- (core.change_runs).
local changes = {}

-- Options that explicit steps do not take.
local of_newmark = { "beta", "rho_infinity", "iterations", "tolerance", "solver", "precision", "internals" }
local usual_steps = 10 -- of model:static

-- Part by which stiffness and strength of all members change from one run of a family to the next. It is a thousand
-- times above rounding, and a thousand below what an answer that is not chaotic may change by (chaos.lua).
changes.part = 1e-9

-- A step of about that length with which the run ends where it would have ended.
local function fitted(o, factor)
  local steps = math.max(1, math.floor(o.duration / o.dt + 0.5))
  local duration = steps * o.dt
  o.dt = duration / math.max(1, math.floor(steps / factor + 0.5))
  o.duration = duration
end

local function copy(o)
  local new = {}
  for key, value in pairs(o) do new[key] = value end
  return new
end

-- What step control may accept, over what it does with the script's own step: where it divides steps, a shorter one
-- alone changes nothing.
local function control_of(dt) return math.min(1, dt) ^ 2 end

-- Options of a dynamic run with steps of another length. Explicit steps that are given must also follow the elements'
-- length.
local function of_dynamics(o, dt, elements, integrator)
  o = copy(o)
  if integrator == "explicit" and (o.integrator or "newmark") == "newmark" then
    o.integrator = "explicit"
    for _, name in ipairs(of_newmark) do o[name] = nil end
    o.dt, o.step_control = "auto", nil
  end
  if o.step_control then o.step_control = o.step_control * control_of(dt) end
  if type(o.dt) ~= "number" or type(o.duration) ~= "number" then return o end
  local factor = o.integrator == "explicit" and dt / math.max(1, elements) or dt
  if factor ~= 1 then fitted(o, factor) end
  return o
end

local function of_statics(o, steps)
  o = copy(o or {})
  local given = o.steps or usual_steps
  if math.type(given) ~= "integer" then return o end
  o.steps = math.max(1, math.floor(given * steps + 0.5))
  return o
end

--- For core.change_runs: dt and elements are factors, steps one on the steps of load, integrator "explicit" or nil, all
-- of them nil where nothing changes. `vary` > 0: stiffness and strength change by so many parts of 1e-9. `shorten` > 0:
-- the time step is shorter by so many thousandths. asked: a table that gets `explicit` = true where a run has explicit
-- steps of its own, and `damps` where it asks for numerical damping. Explicit steps are not made longer.
function changes.of(o, asked)
  local dt = (o.dt or 1) / (1 + 1e-3 * (o.shorten or 0))
  local strength = o.vary and o.vary ~= 0 and changes.part * o.vary or nil
  return { elements = o.elements, step = dt, control = control_of(dt), strength = strength,
    options = function(kind, options)
      if type(options) ~= "table" and options ~= nil then return options end
      if kind == "static" then return of_statics(options, o.steps or 1) end
      if not options then return nil end
      local explicit = options.integrator == "explicit"
      if explicit and asked then asked.explicit = true end
      if asked and (options.rho_infinity or options.beta) then asked.damps = true end
      return of_dynamics(options, explicit and math.min(1, dt) or dt, o.elements or 1, o.integrator)
    end }
end

return changes
