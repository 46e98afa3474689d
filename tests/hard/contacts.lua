-- Hard contacts: slow to very fast, in every position that has no single closest point, and with masses far apart.
local parts = require "parts"

-- Two bars: the first between a and b, the second between c and d with a velocity. Free in space, nothing is lost.
local function two(name, a, b, c, d, velocity, o)
  o = o or {}
  return { name, energy_error = o.energy_error or 2e-2, momentum = 1e-6, dt = o.dt or 5e-6, steps = o.steps or 2000,
    free = true, build = function(model)
      parts.row(model, a, b, { members = 2, group = "first", side = o.first })
      parts.row(model, c, d, { members = 2, group = "second", side = o.second,
        material = o.material and parts.steel(o.material) })
      model:velocity("second", velocity)
      model:contact { rule = o.rule, friction = o.friction }
    end }
end

local scenes = {}
local function add(...) scenes[#scenes + 1] = two(...) end

for _, speed in ipairs { 1, 50, 300, 1000 } do
  add(("crossing at %d m/s"):format(speed),
    { -0.5, 0, 0 }, { 0.5, 0, 0 }, { 0.1, -0.5, 0.06 }, { 0.1, 0.5, 0.06 }, { 0, 0, -speed },
    { dt = speed > 100 and 2e-6 or 5e-6, steps = speed == 1 and 4000 or 1000 })
end
add("end on, collinear", { 0, 0, 0 }, { 1, 0, 0 }, { 1.06, 0, 0 }, { 2.06, 0, 0 }, { -20, 0, 0 })
add("parallel, side by side", { 0, 0, 0 }, { 1, 0, 0 }, { 0, 0, 0.06 }, { 1, 0, 0.06 }, { 0, 0, -20 })
add("parallel, half beside", { 0, 0, 0 }, { 1, 0, 0 }, { 0.5, 0, 0.06 }, { 1.5, 0, 0.06 }, { 0, 0, -20 })
add("in one plane, a tip into a side", { 0, 0, 0 }, { 1, 0, 0 }, { 0.3, 0, 0.06 }, { 0.3, 0, 1.06 }, { 0, 0, -20 })
add("at a joint", { -0.5, 0, 0 }, { 0.5, 0, 0 }, { 0, -0.5, 0.06 }, { 0, 0.5, 0.06 }, { 0, 0, -20 })
add("coincident from the start", { 0, 0, 0 }, { 1, 0, 0 }, { 0, 0, 0 }, { 1, 0, 0 }, { 0, 0, 5 })
add("crossing in overlap from the start",
  { -0.5, 0, 0 }, { 0.5, 0, 0 }, { 0, -0.5, 0.01 }, { 0, 0.5, 0.01 }, { 0, 0, -20 })
add("sliding along each other with friction",
  { 0, 0, 0 }, { 1, 0, 0 }, { 0, -0.5, 0.06 }, { 0.2, 0.5, 0.06 }, { 20, 0, -10 }, { friction = 0.3 })
add("1 to 1000 in mass",
  { -0.5, 0, 0 }, { 0.5, 0, 0 }, { 0.1, -0.5, 0.06 }, { 0.1, 0.5, 0.06 }, { 0, 0, -50 },
  { material = { density = 7.85 }, dt = 1e-6 })

for _, speed in ipairs { 1, 50, 300, 1000 } do
  add(("crossing at %d m/s, gap elements"):format(speed),
    { -0.5, 0, 0 }, { 0.5, 0, 0 }, { 0.1, -0.5, 0.06 }, { 0.1, 0.5, 0.06 }, { 0, 0, -speed },
    { rule = "gap", dt = speed > 100 and 2e-6 or 5e-6, steps = speed == 1 and 12000 or 1000 })
end
add("end on, gap elements", { 0, 0, 0 }, { 1, 0, 0 }, { 1.06, 0, 0 }, { 2.06, 0, 0 }, { -20, 0, 0 }, { rule = "gap" })
add("parallel, gap elements", { 0, 0, 0 }, { 1, 0, 0 }, { 0, 0, 0.08 }, { 1, 0, 0.08 }, { 0, 0, -20 }, { rule = "gap" })
add("coincident, gap elements", { 0, 0, 0 }, { 1, 0, 0 }, { 0, 0, 0 }, { 1, 0, 0 }, { 0, 0, 5 }, { rule = "gap" })

scenes[#scenes + 1] = { "columns land on the ground at all angles and break", energy_error = 2e-2, dt = 2e-5,
  steps = 10000,
  build = function(model)
    for i = 0, 8 do
      local angle = math.rad(11.25 * i)
      parts.row(model, { 0, i, 0.1 }, { 2 * math.sin(angle), i, 0.1 + 2 * math.cos(angle) },
        { members = 2, group = "column", material = parts.steel { yield_stress = 250e6 } })
    end
    model:velocity("column", { 2, 0, -8 })
    model:gravity { 0, 0, -9.80665 }
    model:fracture { curvature_x = 0.05, curvature_y = 0.05, axial_strain = 0.1 }
    model:ground { friction = 0.5 }
  end }

-- Their sizes are such that nothing falls out of the bin. At its end the debris lies: see `rests`.
scenes[#scenes + 1] = { "500 bars pile up in a bin and come to rest", energy_error = 2e-2, dt = 5e-4, steps = 3200,
  slow = true, long = true,
  -- The part of the largest energy that still moves at the end; up to 0.02 in other settings, which damp otherwise.
  rests = 0.01,
  model = { formulation = "conventional", elements_per_member = 1 }, build = function(model)
    local soft = parts.steel { yield_stress = 100e6 }
    local function rail(from, to) model:fix(parts.row(model, from, to, { members = 4, side = 0.07 })) end
    for i = -24, 24 do rail({ 0.1 * i, -2.4, 0 }, { 0.1 * i, 2.4, 0 }) end
    for i = 1, 12 do
      for _, side in ipairs { -2.4, 2.4 } do
        rail({ -2.4, side, 0.1 * i }, { 2.4, side, 0.1 * i })
        rail({ side, -2.4, 0.1 * i }, { side, 2.4, 0.1 * i })
      end
    end
    for i = 0, 499 do
      local x, y, z = i % 10, i // 10 % 10, i // 100
      local turned = (x + y + z) % 2 == 0
      local at = { 0.4 * x - 2, 0.4 * y - 2, 0.3 + 0.15 * z }
      local to = { at[1] + (turned and 0.36 or 0.02), at[2] + (turned and 0.02 or 0.36), at[3] + 0.05 }
      parts.row(model, at, to, { side = 0.04, material = soft })
    end
    model:gravity { 0, 0, -9.80665 }
    model:contact { friction = 0.5, stiffness = 1e6 }
    return { rho_infinity = 0, step_control = 0.02, tolerance = 1e-3 }
  end }

return scenes
