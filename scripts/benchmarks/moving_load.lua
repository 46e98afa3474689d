-- A force that runs along a simply supported beam at constant speed.
--
-- Run     hinge run scripts/benchmarks/moving_load.lua
-- Shows   forces at the joints that are functions of time; moving_load.png has midspan over time
-- Expect  the sum over the modes of Krylov and Timoshenko: 1.7 times the static deflection at half the critical speed
--
-- The force is shared between the two joints next to it, in proportion. The critical speed is
-- pi / L sqrt(EI / (rho A)).
local hinge = require "hinge"

local E, nu, density, side, L, F, members = 206e9, 0.3, 7850, 0.02, 2, 100, 32
local EI, line = E * side ^ 4 / 12, density * side ^ 2
local critical = math.pi / L * math.sqrt(EI / line)
local static = F * L ^ 3 / (48 * EI)

-- Deflection of midspan at the time t, by the modes of a beam without shear and rotary inertia, while the force is on
-- the beam.
local function by_modes(speed, t)
  local u = 0
  for n = 1, 15, 2 do
    local w, W = (n * math.pi / L) ^ 2 * math.sqrt(EI / line), n * math.pi * speed / L
    local moved = (math.sin(W * t) - W / w * math.sin(w * t)) / (w ^ 2 - W ^ 2)
    u = u + 2 * F / (line * L) * moved * math.sin(n * math.pi / 2)
  end
  return u
end

-- Lets the force run. Returns time and deflection of midspan.
local function crossed(speed)
  local model = hinge.model { displacement = "small", plasticity = false, mass = "cubic" }
  local steel = hinge.material { E = E, nu = nu, density = density }
  local section, joints = hinge.section.solid { width = side, depth = side }, {}
  for i = 0, members do joints[i] = model:node { L * i / members, 0, 0 } end
  for i = 1, members do model:member { joints[i - 1], joints[i], section = section, material = steel } end
  for i = 0, members do model:fix(joints[i], "y,rx,rz") end
  model:fix(joints[0], "x,z")
  model:fix(joints[members], "z")
  for i = 1, members - 1 do
    model:load { node = joints[i], force = { 0, 0, -F }, history = function(t)
      return math.max(0, 1 - math.abs(speed * t * members / L - i))
    end }
  end
  local run = model:dynamic { dt = L / speed / 1600, duration = L / speed, solver = "direct", record = false }
  local down = run:probe { node = joints[members // 2], "uz" }
  run:finish()
  return down, run
end

return hinge.benchmark {
  title = "Force that runs along a beam", kind = "dynamics", fast = true,
  source = "closed form: Krylov (1905), Timoshenko; sum over eight modes",
  run = function(b, job)
    local curves = {}
    for _, part in ipairs { 0.25, 0.5, 1.5 } do
      local down, run = crossed(part * critical)
      local x, computed, wanted, most, reference = {}, {}, {}, 0, 0
      for i, t in ipairs(down.time) do
        x[i], computed[i] = t / run.time, -down.value[i] / static
        wanted[i] = by_modes(part * critical, t) / static
        if computed[i] > most or computed[i] ~= computed[i] then most = computed[i] end
        if wanted[i] > reference then reference = wanted[i] end
      end
      b:row { ("greatest, %g of the critical speed"):format(part), computed = most, reference = reference,
        unit = "static", tolerance = 1.5e-3, elements = 2 * members, steps = run.index }
      curves[#curves + 1] = { x = x, y = computed, name = ("speed %g"):format(part) }
      curves[#curves + 1] = { x = x, y = wanted, name = ("speed %g, modes"):format(part), dashed = true }
    end
    job:plot({ series = curves, x_label = "place of the force / L", y_label = "midspan / static",
      title = "force that runs along a beam" }, "moving_load.png")
  end,
}
