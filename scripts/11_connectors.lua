-- How do a dashpot and a friction damper stop a vibrating mass?
--
-- Run     hinge run scripts/11_connectors.lua
-- Shows   a short bar on a spring, damped once by a dashpot and once by a law of the script, Coulomb's friction
-- Expect  decrement = 0.314554 within 0.0005     ln of two amplitudes, a period apart: 2 pi z / sqrt(1 - z^2), z = 0.05
--         lost_mm = 4 within 0.02                amplitude that friction takes away in each period: 4 F / k
--         rubbed_percent = 100 within 0.1        energy lost by friction, of F times the distance slid
local hinge = require "hinge"

local steel = hinge.material { E = 206e9, density = 7850 }
local bar   = hinge.section.solid { width = 0.05, depth = 0.05 }
local mass, frequency = 7850 * 0.05 ^ 2 * 0.1, 10
local omega = 2 * math.pi * frequency
local k = mass * omega ^ 2

-- Returns the positions of the bar at the ends of its swings, m, and the run.
local function swing(joint)
  local model = hinge.model { displacement = "small" }
  local a, b = model:node { 0, 0, 0 }, model:node { 0.1, 0, 0 }
  model:fix({ a, b }, "yz rx ry rz")
  model:member { a, b, section = bar, material = steel, group = "body" }
  model:velocity("body", { 0.02 * omega, 0, 0 })
  joint[1], joint.ground, joint.stiffness = a, true, { x = k }
  model:connector(joint)
  local run = model:dynamic { dt = 1e-4, duration = 3.5 / frequency }
  local ends, way, last, before = {}, 0, 0, 0
  for _ in run:steps() do
    local u = run:displacement(a)
    if (u - last) * (last - before) < 0 then ends[#ends + 1] = last end
    way, before, last = way + math.abs(u - last), last, u
  end
  for i = #ends + 1, 3 do ends[i] = last end -- a plan takes no step
  return ends, run, way
end

local ends = swing { damping = { x = 2 * 0.05 * omega * mass } }
local decrement = math.log(ends[1] / ends[3])

-- Friction is a stiff spring that slides. Its state is the position of its sliding end.
local F, stick = 1e-3 * k, 1e3 * k
local function rubs(u, _, state)
  local force = stick * (u - (state.stands or 0))
  if math.abs(force) <= F then return force, state end
  force = force > 0 and F or -F
  return force, { stands = u - force / stick }
end
local rubbed, run, way = swing { law = { x = rubs } }

print(("a dashpot: decrement %.4f; friction: %.3f mm less in each period, %.4f J for %.4f J")
  :format(decrement, 1e3 * (rubbed[1] - rubbed[3]), run.energy.connector_dissipated, F * way))
return {
  decrement = decrement, lost_mm = 1e3 * (rubbed[1] - rubbed[3]),
  rubbed_percent = 100 * run.energy.connector_dissipated / (F * way),
}
