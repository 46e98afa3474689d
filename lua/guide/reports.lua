-- A bar flies into a frame; the page of hinge report tells what happened. See reports.md.
local hinge = require "hinge"

return hinge.scenario {
  parameters = { speed = 90 },
  cases = { slow = { speed = 45 } },

  run = function(p, job)
    local steel = hinge.material { E = 206e9, density = 7850, yield_stress = 235e6 }
    local tube = hinge.section.box { width = 0.15, depth = 0.15, thickness = 0.006 }
    local solid = hinge.section.solid { width = 0.1, depth = 0.1 }

    -- A bay of 4 m, two storeys of 3 m.
    local model = hinge.model()
    local node = {}
    for i = 0, 1 do
      node[i] = {}
      for k = 0, 2 do node[i][k] = model:node { 4 * i, 0, 3 * k } end
      model:fix(node[i][0])
      for k = 1, 2 do
        model:member { node[i][k - 1], node[i][k], section = tube, material = steel, group = "columns" }
        if i > 0 then model:member { node[0][k], node[1][k], section = tube, material = steel, group = "beams" } end
      end
    end
    local bar = model:member { model:node { -0.2, -0.3, 1.5 }, model:node { -0.2, 0.3, 1.5 }, section = solid,
      material = steel, group = "bar" }
    model:velocity(bar, { p.speed, 0, 0 })
    model:gravity { 0, 0, -9.81 }
    model:contact {}
    model:fracture { hinge_rotation_x = 0.15, hinge_rotation_y = 0.15 } -- rad: see fracture.md

    -- 50 frames: what the page shows.
    local run = model:dynamic { dt = 5e-6, duration = 0.04 }
    run:probe { node = node[1][2], "ux", name = "sway" }
    for step in run:steps() do
      if step.index % 160 == 0 then job:frame(run) end
    end
    job:picture(run, { title = "at 0.04 s", from = { -0.5, -1.4, 0.3 }, width = 800, height = 600 }, "reports.png")
    return { broken = run:count { state = "broken" }, yielded = run:count { state = "yielded" } }
  end,
}
