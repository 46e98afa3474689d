-- A portal under a blast, run by other steps and elements: how far to trust the result. See trust.md.
local hinge = require "hinge"

local steel = hinge.material { E = 210e9, density = 7850, yield_stress = 235e6 }
local box = hinge.section.box { width = 0.2, depth = 0.2, thickness = 0.01 }
local mass, force, fades = 10e3, 1500e3, 0.05 -- kg on each corner, N, s

-- Returns a run that has not yet begun, and a probe of the sway.
local function blast(options)
  local model = hinge.model { elements_per_member = options.elements or 2 }
  local node = {}
  for i, at in ipairs { { 0, 0 }, { 0, 4 }, { 6, 4 }, { 6, 0 } } do node[i] = model:node { at[1], 0, at[2] } end
  model:fix { node[1], node[4] }
  for i = 1, 3 do model:member { node[i], node[i + 1], section = box, material = steel } end
  for i = 2, 3 do model:mass { node = node[i], mass = mass } end
  model:load { node = node[2], force = { force, 0, 0 }, history = { { 0, 1 }, { fades, 0 } } }
  local run = model:dynamic { dt = options.dt, duration = 1, step_control = options.step_control }
  return run, run:probe { node = node[2], "ux" }
end

print "step              elements   verdict   at s   largest sway mm   plastic kJ   energy error %"
for _, o in ipairs { { dt = 2e-3, step_control = 0 }, { dt = 2e-3 }, { dt = 2e-3, step_control = 0.01 },
  { dt = 1e-3, step_control = 0.01 }, { dt = 5e-4 }, { dt = 2.5e-4 }, { dt = "auto" }, { dt = 5e-4, elements = 4 },
  { dt = 5e-4, elements = 8 } } do
  local run, sway = blast(o)
  run:finish()
  local how = { [0] = ", all kept", [0.01] = ", control" }
  local step = o.dt == "auto" and "auto" or ("%.2f ms%s"):format(1e3 * o.dt, how[o.step_control] or "")
  local error = 100 * run.energy_error
  print(("%-17s %8d %9s %6.3f %17.2f %12.0f %16s"):format(step, o.elements or 2, run.verdict, run.time,
    1e3 * (sway.max or 0), run.energy.plastic / 1e3, (math.abs(error) < 0.01 and "%.1g" or "%.2f"):format(error)))
  if run.verdict == "failed" then print("  " .. run.reason:gsub(";.*", "")) end
end

-- Where the energy goes, and by hand: the impulse moves both masses; four hinges of Mp stop them.
local run = blast { dt = 5e-4 }
local curves = { { name = "work of the blast", dashed = true }, { name = "kinetic" }, { name = "elastic" },
  { name = "plastic" } }
for _, curve in ipairs(curves) do curve.x, curve.y = { 0 }, { 0 } end
for step in run:steps() do
  local e = run.energy
  for i, value in ipairs { e.work, e.kinetic, e.elastic, e.plastic } do
    table.insert(curves[i].x, step.time)
    table.insert(curves[i].y, value / 1e3)
  end
end
local impulse, Mp = force * fades / 2, box.Zx * steel.yield_stress
local energy = impulse ^ 2 / (2 * 2 * mass)
print(("work of the blast %.1f kJ, by hand %.1f kJ"):format(run.energy.work / 1e3, energy / 1e3))
print(("rigid-plastic sway by hand %.0f mm"):format(1e3 * 4 * energy / (4 * Mp)))

hinge.plot({ series = curves, title = "where the energy of the blast goes", x_label = "time, s",
  y_label = "energy, kJ", width = 1000, height = 600 }, "trust.png")
return { plastic_kJ = run.energy.plastic / 1e3, error_percent = 100 * run.energy_error }
