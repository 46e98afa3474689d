-- One freedom with Rayleigh damping, with a dashpot and with a friction damper.
--
-- Run     hinge run scripts/benchmarks/damped_oscillator.lua
-- Shows   what damping takes from free vibration, and the amplitude that it leaves at resonance
-- Expect  the logarithmic decrement 2 pi z / sqrt(1 - z^2); the amplitude F / (2 z k) at resonance; 4 F / k less in
--         each period with Coulomb's friction
--
-- The freedom is a short bar that stretches and holds a mass of 1000 kg; with friction it is a short bar on a spring.
local hinge = require "hinge"

local E, side, L, mass, z = 206e9, 0.05, 1, 1000, 0.05
local k = E * side ^ 2 / L
local omega = math.sqrt(k / mass)
local T = 2 * math.pi / omega
local section = hinge.section.solid { width = side, depth = side }

-- The freedom with damping of the ratio z at its period: half of it by alpha M and half by beta K.
local function oscillator()
  local model = hinge.model { displacement = "small", plasticity = false }
  local steel = hinge.material { E = E, density = 1e-3 }
  local wall, tip = model:node { 0, 0, 0 }, model:node { L, 0, 0 }
  model:fix(wall)
  model:fix(tip, "y,z,rx,ry,rz")
  model:member { wall, tip, section = section, material = steel }
  model:mass { node = tip, mass = mass }
  model:damping { alpha = z * omega, beta = z / omega }
  return model, tip
end

-- The greatest values of a probe in its swings to the positive side.
local function peaks_of(probe)
  local peaks, u = {}, probe.value
  for i = 2, #u - 1 do
    if u[i] > 0 and u[i] >= u[i - 1] and u[i] > u[i + 1] then
      local d = u[i - 1] - 2 * u[i] + u[i + 1]
      peaks[#peaks + 1] = u[i] - (u[i + 1] - u[i - 1]) ^ 2 / (8 * d) -- of the parabola through three values
    end
  end
  return peaks
end

local function decrement()
  local model, tip = oscillator()
  model:velocity(tip, { 1, 0, 0 })
  local run = model:dynamic { dt = T / 200, duration = 5.5 * T, record = false }
  local u = run:probe { node = tip, "ux" }
  run:finish()
  local peaks = peaks_of(u)
  return math.log(peaks[1] / peaks[5]) / 4, run
end

local function resonance(F)
  local model, tip = oscillator()
  model:load { node = tip, force = { F, 0, 0 }, history = function(t) return math.sin(omega * t) end }
  local run = model:dynamic { dt = T / 200, duration = 25 * T, record = false }
  local u = run:probe { node = tip, "ux" }
  run:finish()
  local peaks = peaks_of(u)
  return peaks[#peaks] / (1 - math.exp(-z * omega * 25 * T)), run
end

-- Friction is a stiff spring that slides at the force F; its state is the place of its sliding end.
local function friction(u0, F)
  local model = hinge.model { displacement = "small", plasticity = false }
  local a, b = model:node { 0, 0, 0 }, model:node { 0.1, 0, 0 }
  model:fix({ a, b }, "y,z,rx,ry,rz")
  model:member { a, b, section = section, material = hinge.material { E = E, density = mass / (0.1 * side ^ 2) } }
  local soft, stick = k / 1e4, k / 10
  model:connector { a, ground = true, stiffness = { x = soft }, law = { x = function(u, _, state)
    local force = stick * (u - (state.stands or 0))
    if math.abs(force) <= F then return force, state end
    force = force > 0 and F or -F
    return force, { stands = u - force / stick }
  end } }
  local period = 2 * math.pi * math.sqrt(mass / soft)
  model:velocity(a, { u0 * 2 * math.pi / period, 0, 0 })
  model:velocity(b, { u0 * 2 * math.pi / period, 0, 0 })
  local run = model:dynamic { dt = period / 400, duration = 5 * period, record = false }
  local u = run:probe { node = a, "ux" }
  run:finish()
  local peaks = peaks_of(u)
  return (peaks[1] - peaks[4]) / 3, 4 * F / soft, run
end

return hinge.benchmark {
  title = "Damped oscillators", kind = "dynamics", fast = true, source = "closed form",
  run = function(b)
    local row = b:rows_with { elements = 2 }
    local computed, run = decrement()
    row("Rayleigh damping: decrement", computed, 2 * math.pi * z / math.sqrt(1 - z ^ 2), "", 3e-4,
      { steps = run.index })
    computed, run = resonance(1e4)
    row("amplitude at resonance", 1e3 * computed, 1e3 * 1e4 / (2 * z * k), "mm", 3e-4, { steps = run.index })
    local reference
    computed, reference, run = friction(0.1, k / 1e4 * 5e-3)
    row("friction: lost in a period", 1e3 * computed, 1e3 * reference, "mm", 3e-4, { steps = run.index })
  end,
}
