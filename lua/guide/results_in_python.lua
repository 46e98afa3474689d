-- A portal whose masses get a speed: what its runs leave for Python. See results_in_python.md.
local hinge = require "hinge"

return hinge.scenario {
  parameters = { speed = 1.5, column = "HEB 160" }, -- m/s, of the masses on the beam
  vary = { speed = { 0.5, 1, 1.5, 2 }, column = { "HEB 160", "HEB 200" } },
  run = function(p, job)
    local steel = hinge.material.steel "S355"
    local column, beam = hinge.section.named(p.column), hinge.section.named "IPE 300"
    local model = hinge.model { interaction = "exact" }
    local heads = {}
    for i, x in ipairs { 0, 6 } do
      local foot = model:node { x, 0, 0 }
      heads[i] = model:node { x, 0, 4 }
      model:fix(foot, "all")
      model:fix(heads[i], "y") -- it moves in its plane
      model:member { foot, heads[i], section = column, material = steel, up = { 1, 0, 0 }, group = "columns" }
      model:mass { node = heads[i], mass = 10e3 }
    end
    model:member { heads[1], heads[2], section = beam, material = steel, group = "beams" }
    model:gravity { 0, 0, -9.81 }
    local rest = model:static():finish()
    for _, head in ipairs(heads) do model:velocity(head, { p.speed, 0, 0 }) end

    local run = model:dynamic { from = rest, dt = 2e-3, duration = 1.2 }
    run:probe { node = heads[1], "ux", name = "sway" }
    local peak, frames = 0, 0
    for step in run:steps() do
      peak = math.max(peak, math.abs((heads[1]:displacement(run))))
      if step.time > 0.2 * frames + 1e-9 then
        job:frame(run)
        frames = frames + 1
      end
    end
    job:picture(run, { title = "after 1.2 s", scale = 3, ghost = true }, "results_in_python.png")
    return { peak_mm = 1e3 * peak, plastic_kJ = run.energy.plastic / 1e3 }
  end,
}
