-- A mass on a cantilever under a sudden load: the error of the time step. See dynamics.md.
local hinge = require "hinge"

local steel = hinge.material { E = 210e9, nu = 0.3, density = 7850 }
local bar = hinge.section.solid { width = 0.05, depth = 0.05 }
local mass, force = 2000, 1000 -- kg, N

-- By hand: the tip moves by u (1 - cos w t), u the deflection in statics. A cantilever adds 33/140 of its mass.
local flexibility = 1 / (3 * steel.E * bar.Ix) + 1 / (steel.G * bar.shear_area_y)
local u = force * flexibility
local period = 2 * math.pi * math.sqrt((mass + 33 / 140 * 7850 * bar.area) * flexibility)
local w = 2 * math.pi / period

-- Three periods. Returns the run and the root mean square of the error at the tip, as a part of u.
local function vibrate(options)
  local model = hinge.model {}
  local wall, tip = model:node { 0, 0, 0 }, model:node { 1, 0, 0 }
  model:fix(wall, "all")
  model:member { wall, tip, section = bar, material = steel }
  model:mass { node = tip, mass = mass }
  model:load { node = tip, force = { 0, 0, force } }
  options.duration = 3 * period
  local run = model:dynamic(options)
  local sum, count = 0, 0
  for step in run:steps() do
    local e = select(3, tip:displacement(run)) / u - (1 - math.cos(w * step.time))
    sum, count = sum + e ^ 2, count + 1
  end
  return run, math.sqrt(sum / math.max(count, 1))
end

print(("static deflection %.3f mm, period %.4f s"):format(1000 * u, period))
print "steps a period   newmark    theory   rho 0.5"
local newmark, theory = { name = "newmark", x = {}, y = {} }, { name = "theory", x = {}, y = {}, dashed = true }
local damped = { name = "newmark, rho_infinity = 0.5", x = {}, y = {} }
for i = 0, 7 do
  local steps = 10 * 2 ^ i
  local dt = period / steps
  local _, plain = vibrate { dt = dt }
  local _, with_rho = vibrate { dt = dt, rho_infinity = 0.5 }
  -- Average acceleration makes a period longer by (w dt)^2 / 12 of itself; over three periods, as a mean:
  local by_theory = (w * dt) ^ 2 / 12 * 6 * math.pi / math.sqrt(6)
  print(("%14d %9.4f %9.4f %9.4f"):format(steps, plain, by_theory, with_rho))
  for curve, value in pairs { [newmark] = plain, [damped] = with_rho, [theory] = by_theory } do
    curve.x[i + 1], curve.y[i + 1] = 1000 * dt, value
  end
end

local auto, error_auto = vibrate { dt = "auto" }
local explicit, error_explicit = vibrate { dt = "auto", integrator = "explicit" }
print(("newmark, auto  %.4f in %d steps"):format(error_auto, auto.index))
print(("explicit, auto %.4f in %d steps"):format(error_explicit, explicit.index))
hinge.plot({ series = { newmark, damped, theory,
  { name = "newmark, auto", style = "points", x = { 1000 * auto.time / auto.index }, y = { error_auto } },
  { name = "explicit, auto", style = "points", x = { 1000 * explicit.time / explicit.index }, y = { error_explicit } },
  },
  title = "error of a vibration against the time step", x_label = "time step, ms", y_label = "error / deflection",
  log_x = true, log_y = true, width = 1000, height = 600 }, "dynamics.png")
return { error_auto = error_auto }
