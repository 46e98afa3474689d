-- Plates that fall on each other, in piles of forty: how near they are to rest at the end, and what a step takes.
-- Run: hinge run -q tests/bench/panel_pile.lua
local hinge = require "hinge"

local g = 9.80665 -- m/s^2
local high = 40   -- plates in a pile

return hinge.scenario {
  parameters = { plates = 200, duration = 3, dt = 4e-5, restitution = 0.3, integrator = "explicit" },
  run = function(p)
    local steel = hinge.material { E = 200e9, nu = 0.3, density = 7850 }
    local model, tops = hinge.model(), {}
    for pile = 0, math.ceil(p.plates / high) - 1 do
      for k = 0, high do -- the lowest is held
        local x, y, z = 1.2 * (pile % 8) + 0.02 * (k % 2), 1.2 * (pile // 8) + 0.03 * (k % 3 % 2), 0.03 * k
        local at = {}
        for i, c in ipairs { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } } do
          at[i] = model:node { x + c[1], y + c[2], z }
        end
        model:panel { at[1], at[2], at[3], at[4], thickness = 0.02, material = steel }
        if k == 0 then model:fix(at, "xyz") end
        if k == high then tops[#tops + 1] = at[1] end
      end
    end
    model:gravity { 0, 0, -g }
    local contact = model:panel_contact { friction = 0.4, restitution = p.restitution }
    local run = model:dynamic { dt = p.dt, duration = p.duration, integrator = p.integrator, record = false }
    local from = os.clock()
    run:finish()
    local seconds, points, force, depth = os.clock() - from, contact:pressing(run)
    local speed = 0
    for _, node in ipairs(tops) do speed = speed + math.abs((select(3, run:velocity(node)))) / #tops end
    local weights = #tops * high * (high + 1) / 2 * 0.02 * 7850 * g -- what the plates press with, all together
    print(("%d plates, %d steps: %.1f ms a step; mean speed of the tops %.1e m/s, "
      .. "forces over weights %.4f, depth %.2g mm, energy error %.1e"):format(#tops * high, run.counts.substeps,
      1e3 * seconds / run.counts.substeps, speed, force / weights, 1e3 * depth, run.energy_error))
    return { speed = speed, points = points, part = force / weights, energy_error = run.energy_error }
  end,
}
