-- A shear frame of three storeys on moving ground, against the exact response of its modes.
--
-- Run     hinge run scripts/benchmarks/shaken_frame.lua
-- Shows   ground acceleration as a moving support: drift of the storeys and base shear; shaken_frame.png has the roof
-- Expect  greatest drifts within 0.03 %; the modes are computed in this file
--
-- Floors are stiff, and columns bend only: three freedoms. The record is made up; it is straight between its values,
-- for which each mode has an exact solution over a step.
local hinge = require "hinge"

local E, I, height, floor = 200e9, 1e-5, 3, 10000 -- Pa, m^4 of one column, m, kg
local k = 2 * 12 * E * I / height ^ 3 -- N/m, of the two columns of a storey
local storeys, dt_record = 3, 0.02

-- Acceleration of the ground, m/s^2: three sines under an envelope, then nothing.
local function record()
  local a = {}
  for i = 0, 500 do
    local t = i * dt_record
    local size = t < 6 and math.sin(math.pi * t / 6) ^ 2 or 0
    a[i + 1] = size * (2 * math.sin(9 * t) + 1.5 * math.sin(21 * t + 1) + math.sin(33 * t + 2))
  end
  return a
end

-- The modes of a uniform shear frame: shapes sin(i q), w = 2 sqrt(k / m) sin(q / 2), q = (2 n - 1) pi / (2 N + 1).
-- Exact step of x'' + w^2 x = -(a0 + s t): particular solution -(a0 + s t) / w^2, and a free vibration.
local function modal(a, steps)
  local floors, times = {}, {}
  for i = 1, storeys do floors[i] = {} end
  for n = 1, storeys do
    local q = (2 * n - 1) * math.pi / (2 * storeys + 1)
    local w = 2 * math.sqrt(k / floor) * math.sin(q / 2)
    local shape, up, down = {}, 0, 0
    for i = 1, storeys do
      shape[i] = math.sin(i * q)
      up, down = up + shape[i], down + shape[i] ^ 2
    end
    local x, v, h, at = 0, 0, dt_record / steps, 0
    for j = 1, #a - 1 do
      local s = (a[j + 1] - a[j]) / dt_record
      for part = 0, steps - 1 do
        local a0 = a[j] + s * part * h
        local A, B = x + a0 / w ^ 2, (v + s / w ^ 2) / w
        local c, r = math.cos(w * h), math.sin(w * h)
        x, v = A * c + B * r - (a0 + s * h) / w ^ 2, w * (B * c - A * r) - s / w ^ 2
        at = at + 1
        times[at] = at * h
        for i = 1, storeys do floors[i][at] = (floors[i][at] or 0) + up / down * shape[i] * x end
      end
    end
  end
  return floors, times
end

local function greatest(list, less)
  local most = 0
  for i, u in ipairs(list) do
    local size = math.abs(u - (less and less[i] or 0))
    if size > most or size ~= size then most = size end -- a value that is not a number stays
  end
  return most
end

-- The frame: columns without mass, floors that are rigid, and the mass at the joints.
local function shaken(a)
  local model = hinge.model { displacement = "small", plasticity = false }
  local grid = hinge.grid { model = model, x = { 0, 5 }, z = { count = storeys, spacing = height } }
  local steel = hinge.material { E = E, density = 1e-3 }
  local section = hinge.section.general { area = 1, Ix = I, Iy = I, J = I, shear_area_x = 1e3, shear_area_y = 1e3 }
  grid:columns { section = section, material = steel }
  grid:fix "all"
  local probes, feet = {}, { grid:node("A1", 0), grid:node("B1", 0) }
  for level = 1, storeys do
    grid:fix("y,z,rx,ry,rz", level)
    for _, line in ipairs { "A1", "B1" } do model:mass { node = grid:node(line, level), mass = floor / 2 } end
  end
  model:move { node = feet, x = hinge.ground { dt = dt_record, acceleration = a } }
  local run = model:dynamic { dt = dt_record / 10, duration = (#a - 1) * dt_record, record = false }
  for level = 1, storeys do
    probes[level] = run:probe { node = grid:node("A1", level), relative_to = feet[1], "ux" }
  end
  local shear = run:probe { node = feet[1], "fx" }
  run:finish()
  return probes, shear, run
end

return hinge.benchmark {
  title = "Shear frame on moving ground", kind = "dynamics", fast = true,
  source = "superposition of exact modes, exact for each straight piece of the record",
  run = function(b, job)
    local a = record()
    local floors, times = modal(a, 10)
    local probes, shear, run = shaken(a)
    local row = b:rows_with { elements = 12, steps = run.index }
    row("roof against the ground", 1e3 * greatest(probes[3].value), 1e3 * greatest(floors[3]), "mm", 1e-4)
    row("drift of the first storey", 1e3 * greatest(probes[1].value), 1e3 * greatest(floors[1]), "mm", 5e-4)
    row("drift of the third storey", 1e3 * greatest(probes[3].value, probes[2].value),
      1e3 * greatest(floors[3], floors[2]), "mm", 1e-4)
    row("shear in one foot", greatest(shear.value) / 1e3, k / 2 * greatest(floors[1]) / 1e3, "kN", 5e-4)
    job:plot({ series = { { x = probes[3].time, y = probes[3].value, name = "hinge" },
      { x = times, y = floors[3], name = "modes", dashed = true } }, x_label = "s", y_label = "m, roof",
      title = "shear frame on moving ground" }, "shaken_frame.png")
  end,
}
