-- A rigid pendulum that swings far, a hanging chain, and a taut cable.
--
-- Run     hinge run scripts/benchmarks/pendulum_and_chain.lua
-- Shows   motion that is driven by gravity and by tension alone
-- Expect  the elliptic integral; the zeros 2.4048 and 5.5201 of Bessel's function J0; the octaves of a string
--
-- Chain and cable are thin bars, whose bending stiffness hardly counts. The chain is of a soft material; it stretches
-- by 0.08 % under its weight.
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "support/?.lua;" .. package.path
local hinge = require "hinge"
local elliptic = require "hinge.library.numeric".elliptic
local frequency = require "vibration".frequency

local E, density, L, g = 206e9, 7850, 1, 9.80665

-- Lets a stiff rod swing from the angle `from` off the vertical. Returns its period and the closed form.
local function pendulum(from)
  local model, side = hinge.model { plasticity = false }, 0.05
  local pin, tip = model:node { 0, 0, 0 }, model:node { L * math.sin(from), 0, -L * math.cos(from) }
  model:fix(pin, "x,y,z,rx,rz")
  model:fix(tip, "y,rx,rz")
  model:member { pin, tip, section = hinge.section.solid { width = side, depth = side },
    material = hinge.material { E = E, density = density } }
  model:gravity { 0, 0, -g }
  local T = 4 * elliptic(math.sin(from / 2) ^ 2) * math.sqrt((L ^ 2 / 3 + side ^ 2 / 12) / (g * L / 2))
  local run = model:dynamic { dt = T / 2000, duration = 2 * T, integrator = "energy-momentum", record = false }
  local passes, last = {}, nil
  run:on_step(function(r)
    local x = tip:position(r)
    if last and last > 0 and x <= 0 then passes[#passes + 1] = r.time - r.dt * x / (x - last) end
    last = x
  end)
  run:finish()
  return passes[2] - passes[1], T, run
end

-- A thin bar that is pulled by its weight or by prestress, and pushed a little at a joint. Returns the frequency of the
-- joint near `guess`.
local function string_of(o)
  local model = hinge.model { plasticity = false, mass = "cubic" }
  local steel = hinge.material { E = o.E, density = density }
  local section = hinge.section.solid { width = o.side, depth = o.side }
  local joints = {}
  for i = 0, 8 do joints[i] = model:node { 0, 0, -L * i / 8 } end
  for i = 1, 8 do model:member { joints[i - 1], joints[i], section = section, material = steel, elements = 4,
    group = "string" } end
  model:fix(joints[0], "xyz")
  for i = 0, 8 do model:fix(joints[i], "y,rx,rz") end
  if o.tension then
    model:fix(joints[8], "xyz")
    model:prestress { group = "string", force = o.tension }
  else -- statics asks for a support against rotation: a spring that is too weak to count
    model:connector { joints[0], ground = true, stiffness = { ry = 0.1 * o.E * o.side ^ 4 / 12 / L } }
  end
  model:case("hanging"):gravity { 0, 0, o.tension and 0 or -g }
  model:case("push"):load { node = joints[o.joint], force = { o.push, 0, 0 } }
  local straight = model:static { steps = 10, loads = { hanging = 1 } }:finish()
  local start = model:static { from = straight, steps = 10, loads = { push = 1 } }:finish()
  local dt = 2 * math.pi / o.guess / 60
  local run = model:dynamic { from = start, loads = { push = 0 }, dt = dt, duration = 1200 * dt, record = false }
  local u = run:probe { node = joints[o.joint], "ux" }
  run:finish()
  return 2 / dt * math.tan(frequency(u, dt, o.guess) * dt / 2), run -- without the lag of the steps
end

return hinge.benchmark {
  title = "Pendulum, hanging chain, taut cable", kind = "dynamics",
  source = "closed form: elliptic integral, zeros of Bessel's function J0, vibrating string",
  run = function(b)
    local function row(what, computed, reference, unit, tolerance, elements, run)
      b:row { what, computed = computed, reference = reference, unit = unit, tolerance = tolerance, elements = elements,
        steps = run.index }
    end
    for _, degrees in ipairs { 90, 170 } do
      local period, closed, run = pendulum(math.rad(degrees))
      row(("pendulum from %d degrees: period"):format(degrees), period, closed, "s", 1e-5, 2, run)
    end
    for i, case in ipairs { { 2.404825557695773, 1e-4 }, { 5.520078110286311, 3e-3 } } do
      local zero, tolerance = table.unpack(case)
      local w = zero / 2 * math.sqrt(g / L)
      local found, run = string_of { E = 1e8, side = 1e-4, joint = 6, push = 4e-7, guess = w }
      row(("chain: frequency %d"):format(i), found, w, "rad/s", tolerance, 32, run)
    end
    local side, tension = 1e-3, 100
    local w = math.pi / L * math.sqrt(tension / (density * side ^ 2))
    local found, run = string_of { E = E, side = side, joint = 4, push = 0.1, guess = w, tension = tension }
    row("taut cable: frequency", found, w, "rad/s", 1e-3, 32, run)
  end,
}
