-- Parkes' cantilever: a mass at its tip gets a velocity, and a plastic hinge travels from the tip to the wall.
--
-- Run     hinge run scripts/benchmarks/parkes_cantilever.lua
-- Shows   how an elastic-plastic beam comes to the rigid-plastic solution as the elastic part is made small
-- Expect  41.3 mm in the limit; 1.9 % more with 64 elements and 1e5 times the stiffness of steel; parkes.png has the
--         histories
--
-- The solution has no elasticity and a hinge that moves steadily. Here hinges stand at the ends of elements. From 32
-- elements on the error of that is about in proportion to their length, so that two numbers of elements give the limit.
-- With ten times the stiffness of steel the elastic energy, Mp^2 L / (2 EI), is 5 % of the initial one.
-- rho_infinity = 0 takes the fastest vibrations of the stiff beam out of the motion.
local hinge = require "hinge"

local E, density, side, yield, L, mass, V = 206e9, 7850, 0.05, 245e6, 1, 10, 10
local Mp, line = yield * side ^ 3 / 4, density * side ^ 2 -- N m, kg/m

-- Rigid-plastic displacement of the tip over time. The part z of the beam next to the tip rotates about the hinge: its
-- momentum gives the velocity v = V / (1 + line z / (2 mass)), the moments about the tip t = line v z^2 / (6 Mp). When
-- the hinge is at the wall, the whole beam rotates about it until its kinetic energy is used.
local function rigid_plastic()
  local times, way, v = { 0 }, { 0 }, V
  local steps = 1000
  for i = 1, steps do
    local z = L * i / steps
    local next_v = V / (1 + line * z / (2 * mass))
    local t = line * next_v * z ^ 2 / (6 * Mp)
    way[i + 1] = way[i] + (t - times[i]) * (v + next_v) / 2
    times[i + 1], v = t, next_v
  end
  local slow = Mp / (mass * L + line * L ^ 2 / 3) -- m/s^2, of the tip
  local began, before = times[#times], way[#way]
  for i = 1, 100 do
    local t = v / slow * i / 100
    times[#times + 1], way[#way + 1] = began + t, before + v * t - slow * t ^ 2 / 2
  end
  return times, way
end

-- The velocity of a node alone also moves a third of the element at it; the mass is less by that.
local function parkes(stiffer, elements)
  local model = hinge.model { displacement = "small", elements_per_member = elements }
  local steel = hinge.material { E = stiffer * E, density = density, yield_stress = yield }
  local wall, tip = model:node { 0, 0, 0 }, model:node { L, 0, 0 }
  model:fix(wall)
  model:fix(tip, "y,rx,rz")
  model:member { wall, tip, section = hinge.section.solid { width = side, depth = side }, material = steel }
  model:mass { node = tip, mass = mass - line * L / elements / 3 }
  model:velocity(tip, { 0, 0, -V })
  local run = model:dynamic { dt = 5e-6, duration = 0.017, rho_infinity = 0, record = false }
  local down = run:probe { node = tip, "uz" }
  run:finish()
  local way, sum, count = {}, 0, 0
  for i, u in ipairs(down.value) do
    way[i] = -1e3 * u
    if down.time[i] > 0.0145 then sum, count = sum + way[i], count + 1 end
  end
  return sum / count, { x = down.time, y = way, name = ("E x %g, %d elements"):format(stiffer, elements) }, run.index
end

return hinge.benchmark {
  title = "Parkes' cantilever", kind = "dynamics",
  source = "rigid-plastic closed form: Parkes, Proc. R. Soc. A 228 (1955)",
  run = function(b, job)
    local times, way = rigid_plastic()
    for i, u in ipairs(way) do way[i] = 1e3 * u end
    local curves = { { x = times, y = way, name = "rigid-plastic", dashed = true } }
    local found, steps_of_64 = {}, nil
    local cases = { { 10, 32, 0.25 }, { 1e3, 32, 0.07 }, { 1e5, 16, 0.11 }, { 1e5, 32, 0.045 }, { 1e5, 64, 0.025 } }
    for _, case in ipairs(cases) do
      local stiffer, elements, tolerance = table.unpack(case)
      local last, curve, steps = parkes(stiffer, elements)
      b:row { ("tip, E x %d, %d elements"):format(stiffer, elements), computed = last, reference = way[#way],
        unit = "mm", tolerance = tolerance, elements = elements, steps = steps }
      if stiffer ~= 1e5 or elements == 64 then curves[#curves + 1] = curve end
      found[#found + 1], steps_of_64 = last, steps
    end
    b:row { "tip, limit of 32 and 64 elements", computed = 2 * found[5] - found[4], reference = way[#way], unit = "mm",
      tolerance = 0.005, elements = 64, steps = steps_of_64 }
    job:plot({ series = curves, x_label = "s", y_label = "mm, tip", title = "Parkes' cantilever" }, "parkes.png")
  end,
}
