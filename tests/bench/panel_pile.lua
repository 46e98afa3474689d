-- Plates of 2 by 2 panels that fall on each other and on the ground, in piles: when they come to rest, what a step
-- takes before and after, and how that grows with the number of panels.
--
-- Run     hinge run -q tests/bench/panel_pile.lua [panels=1000 high=10 integrator=newmark dt=1e-3]
-- Shows   for 250, 500, 1,000 and 2,000 panels, or the number given: time at which the last plate came to rest, time of
--         a step on the processor while plates fall and strike (0.2 to 0.4 s), while they settle, and when all rest;
--         the part of contact; the energy error and the fastest node at the end
local hinge = require "hinge"

local g = 9.80665 -- m/s^2

local function piles(panels, high, thickness)
  local material = hinge.material { E = 30e9, nu = 0.2, density = 2400 }
  local model, nodes = hinge.model(), {}
  local count = math.max(1, math.floor(panels / (4 * high) + 0.5))
  local across = math.ceil(math.sqrt(count))
  for pile = 0, count - 1 do
    local gap = 0.02 + 0.004 * (pile % 5) -- m
    for k = 0, high - 1 do -- each a little beside the one below
      local at = {}
      for i = 0, 2 do
        for j = 0, 2 do
          at[3 * i + j] = model:node { 1.3 * (pile % across) + 0.5 * i + 0.02 * (k % 2),
            1.3 * (pile // across) + 0.5 * j + 0.03 * (k % 3), (thickness + gap) * (k + 1) }
          nodes[#nodes + 1] = at[3 * i + j]
        end
      end
      for _, c in ipairs { 0, 1, 3, 4 } do
        model:panel { at[c], at[c + 3], at[c + 4], at[c + 1], thickness = thickness, material = material }
      end
    end
  end
  model:gravity { 0, 0, -g }
  model:ground { friction = 0.5 }
  model:panel_contact { friction = 0.5, restitution = 0.3 }
  return model, nodes, 4 * high * count
end

-- When the last body came to rest, s; nil where one has not.
local function at_rest(run, nodes)
  for _, node in ipairs(nodes) do
    local x, y, z = run:velocity(node)
    if x ~= 0 or y ~= 0 or z ~= 0 then return nil end
  end
  local last = 0
  for _, change in ipairs(run.state_changes) do
    if change.effect:find "bod" and not change.awake then last = change.time end
  end
  return last
end

return hinge.scenario {
  parameters = { panels = 0, high = 10, thickness = 0.1, duration = 2.6, dt = 5e-5, integrator = "explicit" },
  run = function(p)
    local out = {}
    for _, wanted in ipairs(p.panels > 0 and { p.panels } or { 250, 500, 1000, 2000 }) do
      local model, nodes, panels = piles(wanted, p.high, p.thickness)
      local run = model:dynamic { dt = p.dt, duration = p.duration, integrator = p.integrator, record = false }
      local function ms_until(time) -- of a step
        local from, steps = os.clock(), run.counts.substeps
        while run.time < time and run:step() do end
        return 1e3 * (os.clock() - from) / math.max(1, run.counts.substeps - steps)
      end
      ms_until(0.2)
      local falls, settles, rested = ms_until(0.4), ms_until(0.6), nil
      while not rested and run.time < p.duration - 0.2 do
        ms_until(run.time + 0.1)
        rested = at_rest(run, nodes)
      end
      local rests = ms_until(p.duration)
      run:finish()
      local fastest = 0
      for _, node in ipairs(nodes) do
        local x, y, z = run:velocity(node)
        local speed = math.sqrt(x * x + y * y + z * z)
        if not (speed <= fastest) then fastest = speed end
      end
      local seconds = 0
      for _, effect in ipairs(run.effects) do
        if effect.name == "contact of panels" then seconds = effect.seconds end
      end
      print(("%5d panels: at rest after %s s; a step takes %.2f ms as they fall, %.2f as they settle, %.3f at rest; "
        .. "contact %.0f s; energy error %.1e, fastest node %.1e m/s"):format(panels,
        rested and ("%.2f"):format(rested) or "-", falls, settles, rests, seconds, run.energy_error, fastest))
      out[panels] = rested
      out["ms_" .. panels] = falls
    end
    return out
  end,
}
