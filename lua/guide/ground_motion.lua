-- A frame of two storeys on ground that moves as a record in a file says: see ground_motion.md.
local hinge = require "hinge"
local record, spectrum = hinge.record, hinge.spectrum

local bay, height = 6, 3.5 -- m
local steel = hinge.material.steel "S275"
local column, beam = hinge.section.named "HEB 220", hinge.section.named "IPE 330"

-- No earthquake: 24 sines with phases all over the circle, under an envelope. In g, every 10 ms for 10 s. The constant
-- 0.005 g is an error of the baseline, as instruments have it.
local function synthetic()
  local values = {}
  for i = 0, 1000 do
    local t, sum = i / 100, 0
    for k = 1, 24 do sum = sum + math.sin(2 * math.pi * (0.4 * k ^ 0.9 * t + 0.618034 * k * k)) / k ^ 0.5 end
    values[i + 1] = 0.05 * (t / 2) ^ 2 * math.exp(2 - t) * sum + 0.005
  end
  return values
end

-- Writes accelerations (g, every dt s) as a file of PEER.
local function write_at2(path, dt, values)
  local file = assert(io.open(path, "w"))
  file:write("NO DATABASE\nSYNTHETIC, NO EARTHQUAKE\nACCELERATION TIME SERIES IN UNITS OF G\n")
  file:write(("NPTS= %d, DT= %.5f SEC"):format(#values, dt))
  for i, value in ipairs(values) do file:write(i % 5 == 1 and "\n" or "", ("%15.7E"):format(value)) end
  file:write "\n"
  file:close()
end

-- The frame, with 25 kN/m on its beams. Returns the model, its feet, and a node of each floor.
local function frame()
  local model = hinge.model {}
  local floor = hinge.material { E = steel.E, yield_stress = steel.yield_stress, density = 25e3 / 9.81 / beam.area }
  local left, right = {}, {}
  for level = 0, 2 do
    for at, list in pairs { [0] = left, [bay] = right } do
      list[level] = model:node { at, 0, level * height }
      model:fix(list[level], level == 0 and "all" or "y,rx,rz")
      if level > 0 then
        model:member { list[level - 1], list[level], section = column, material = steel, up = { 1, 0, 0 } }
      end
    end
    if level > 0 then model:member { left[level], right[level], section = beam, material = floor, up = { 0, 0, 1 } } end
  end
  model:gravity { 0, 0, -9.81 }
  model:damping { ratio = 0.03, periods = { 1, 0.1 } }
  return model, { left[0], right[0] }, left
end

return hinge.scenario { run = function(_, job)
  local model, feet, floors = frame()
  local rest = model:static { steps = 2 }:finish()

  local path = job.out .. "/synthetic.at2"
  write_at2(path, 0.01, synthetic())
  local raw = record.read { file = path }
  local quake = record.read { file = path, baseline = "linear", peak = 3 }
  print(("%s: %d values, %.2f s, peak %.2f m/s^2"):format(raw.name, #raw.acceleration, raw.duration, raw.peak))
  print(("at the end: %.3f m/s as it is, %.3f m/s with baseline = 'linear'"):format(raw.end_velocity,
    math.abs(quake.end_velocity)))

  model:move { node = feet, x = quake.displacement }
  local run = model:dynamic { from = rest, dt = 5e-3, duration = 12 }
  local roof = run:probe { node = floors[2], "ax" }
  local drifts = {}
  for i = 1, 2 do drifts[i] = run:probe { node = floors[i], relative_to = floors[i - 1], "drift_x" } end
  run:finish()

  local ground = spectrum { dt = quake.dt, acceleration = quake.acceleration }
  local floor = spectrum { time = roof.time, acceleration = roof.value }
  local most = 1
  for i, a in ipairs(floor.acceleration) do most = a > floor.acceleration[most] and i or most end
  print(("spectrum of the roof: %.1f m/s^2 at %.2f s, that of the ground %.1f m/s^2"):format(floor.acceleration[most],
    floor.periods[most], ground.acceleration[most]))
  local curves = {}
  for i, drift in ipairs(drifts) do
    local percent = {}
    for k, value in ipairs(drift.value) do percent[k] = 100 * value end
    curves[i] = { x = drift.time, y = percent, name = "storey " .. i }
    print(("storey %d: largest drift %.2f %%, at the end %.2f %%"):format(i, 100 * math.max(drift.max, -drift.min),
      100 * drift.last))
  end
  print(("hinges have dissipated %.0f kJ"):format(run.energy.plastic / 1e3))
  hinge.plot({ columns = 2, width = 1300, height = 520, panels = {
    { x_label = "period, s", y_label = "acceleration, 5 % damping, m/s^2", log_x = true, series = {
      { x = ground.periods, y = ground.acceleration, name = "ground" },
      { x = floor.periods, y = floor.acceleration, name = "roof" } } },
    { x_label = "time, s", y_label = "drift, %", series = curves } } }, "ground_motion.png")
end }
