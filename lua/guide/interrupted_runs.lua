-- A long run that is interrupted and goes on: see interrupted_runs.md.
local hinge = require "hinge"

local steel = hinge.material { E = 206e9, density = 7850, yield_stress = 235e6 }
local bar = hinge.section.box { width = 0.1, depth = 0.1, thickness = 0.005 }

-- A mast of 6 m with 500 kg on top, whose foot is shaken 0.8 times a second.
return hinge.scenario {
  parameters = { interrupt_at = 1e9 },
  run = function(p, job)
    local model = hinge.model()
    local foot, top = model:node { 0, 0, 0 }, model:node { 0, 0, 6 }
    model:member { foot, top, section = bar, material = steel }
    model:mass { node = top, mass = 500 }
    model:fix(foot, "all")
    model:move { node = foot, x = function(t) return 0.05 * math.sin(2 * math.pi * 0.8 * t) end }
    local gathered = { passes = 0, before = 0 }
    local run = model:dynamic { dt = 1e-3, duration = 6, checkpoint = { file = "mast.checkpoint", keep = gathered } }
    local sway = run:probe { node = top, "ux", name = "sway" }
    for _ in run:steps() do
      local x = top:displacement(run)
      if x * gathered.before < 0 then gathered.passes = gathered.passes + 1 end
      gathered.before = x
      -- Here the script presses Ctrl-C itself, so that this page shows the same each time.
      if run.time > p.interrupt_at then io.popen("kill -INT $PPID"):close() end
    end
    print(("the top passed its middle %d times; its largest displacement was %.4f m"):format(gathered.passes, sway.max))
    job:plot({ title = "top of the mast", x_label = "time, s", y_label = "displacement, m", width = 1000, height = 600,
      series = { { x = sway.time, y = sway.value } } }, "interrupted_runs.png")
    return { largest = sway.max, passes = gathered.passes }
  end,
}
