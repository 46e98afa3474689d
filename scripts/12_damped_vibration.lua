-- How fast does a damped bar come to rest?
--
-- Run     hinge run scripts/12_damped_vibration.lua
-- Shows   a steel cantilever, 3 m long, 100 mm thick, that vibrates in its first mode; Rayleigh damping of 2 % of
--         critical at the periods of its first and second mode
-- Expect  ratio = 0.02 within 1 %                  from the energy after three periods, exp(-2 z w t)
--         lost = 0.529 within 1 %                  part of the energy lost by damping, 1 - exp(-2 z 6 pi)
--         open = 0 within 0.000001                 energy error, of the initial energy
local hinge = require "hinge"

local length, side, n, z = 3, 0.1, 6, 0.02
local steel = hinge.material { E = 206e9, nu = 0.3, density = 7850 }
local bar   = hinge.section.solid { width = side, depth = side }
local model = hinge.model {}
local nodes = {}
for i = 0, n do nodes[i] = model:node { length * i / n, 0, 0 } end
model:fix(nodes[0], "all")
for i = 1, n do model:member { nodes[i - 1], nodes[i], section = bar, material = steel, up = { 0, 0, 1 } } end

-- The modes of a clamped beam: w = (kL)^2 / L^2 * root of E I / (rho A).
local c = math.sqrt(206e9 / 7850 * side ^ 2 / 12)
local k1, k2 = 1.875104 / length, 4.694091 / length
local T1, T2 = 2 * math.pi / (k1 ^ 2 * c), 2 * math.pi / (k2 ^ 2 * c)
local alpha, beta = model:damping { ratio = z, periods = { T1, T2 } }
print(("alpha = %.4f 1/s, beta = %.4g s"):format(alpha, beta))

local function cosh(x) return (math.exp(x) + math.exp(-x)) / 2 end
local function sinh(x) return (math.exp(x) - math.exp(-x)) / 2 end
local s = (math.cos(k1 * length) + cosh(k1 * length)) / (math.sin(k1 * length) + sinh(k1 * length))
for i = 1, n do
  local x = k1 * length * i / n
  local speed = 0.1 * (cosh(x) - math.cos(x) - s * (sinh(x) - math.sin(x)))
  local spin = 0.1 * k1 * (sinh(x) + math.sin(x) - s * (cosh(x) - math.cos(x)))
  model:velocity(nodes[i], { 0, 0, speed }, { 0, -spin, 0 })
end

local run = model:dynamic { dt = T1 / 400, duration = 3 * T1 }
run:finish()
local e = run.energy
local left = (e.kinetic + e.elastic) / e.initial
print(("after three periods %.1f %% of the energy is left"):format(100 * left))
return { ratio = -math.log(left) / (2 * 6 * math.pi), lost = e.damping / e.initial, open = e.energy_error / e.initial }
