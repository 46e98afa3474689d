-- What a step costs against what happens in it: bars of which some fall and the others lie on the ground, and a wide
-- frame of which a part yields.
--
-- Run     hinge run -q tests/bench/activity.lua              (integrator=explicit by default, or newmark)
-- Shows   processor time of a step of 500 bars against the part of them that falls; that of a frame of 24 bays before
--         and after it loses a column, against the elements that flow
-- Expect  500 bars at rest take a tenth of what they take as they fall
-- Writes  bars.csv, bars.png, frame.csv and frame.png in its output folder
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../script/?.lua;" .. package.path
local support = require "support"
local hinge = require "hinge"

local function us(seconds, steps) return 1e6 * seconds / steps end

-- The mean of `count` steps in five batches, the shortest of these, us.
local function time_steps(run, count)
  local least = math.huge
  for _ = 1, 5 do
    local begun = os.clock()
    for _ = 1, count // 5 do run:step() end
    local taken = us(os.clock() - begun, count // 5)
    least = support.smallest_of(least, taken)
  end
  return least
end

-- 500 bars of 1.5 m, of which `falling` are 60 m up and the others just above the ground, where they come to rest.
local function bars(p, falling)
  local model = hinge.model {}
  local section = hinge.section.box { width = 0.1, depth = 0.1, thickness = 0.005 }
  local steel = hinge.material { E = 206e9, density = 7850, yield_stress = 325e6 }
  for i = 0, p.bars - 1 do
    local x, y, z = 2 * (i % 25), 2 * (i // 25), i < falling and 60 or 0.0501
    model:member { model:node { x, y, z }, model:node { x + 1.5, y, z }, section = section, material = steel }
  end
  model:gravity { 0, 0, -9.80665 }
  model:ground {}
  model:contact {}
  local explicit = p.integrator == "explicit"
  local run = model:dynamic { dt = explicit and 2e-5 or 1e-4, integrator = explicit and "explicit" or nil,
    duration = 3, record = false, threads = 1, step_control = not explicit and 0 or nil }
  while run.time < 1.5 do run:step() end
  return time_steps(run, 1000)
end

-- A plane frame of 24 bays and 6 storeys that loses a column of its first storey: elements that flow, and the time of a
-- step, in intervals of the run.
local function frame(p)
  local model, node = hinge.model {}, {}
  local steel = hinge.material { E = 206e9, density = 7850, yield_stress = 235e6 }
  local column = hinge.section.box { width = 0.3, depth = 0.3, thickness = 0.012 }
  local beam = hinge.section.h { depth = 0.4, width = 0.2, web = 0.008, flange = 0.013 }
  for i = 0, p.bays do
    for k = 0, 6 do
      node[i * 7 + k] = model:node { 6 * i, 0, 3.5 * k }
      model:fix(node[i * 7 + k], k == 0 and "all" or "y,rx,rz") -- the frame stays in its plane
      if k > 0 then
        model:member { node[i * 7 + k - 1], node[i * 7 + k], section = column, material = steel,
          group = i == 2 and k == 1 and "lost" or "columns" }
        if i > 0 then
          model:member { node[i * 7 - 7 + k], node[i * 7 + k], section = beam, material = steel, group = "beams" }
        end
        model:mass { node = node[i * 7 + k], mass = p.mass }
      end
    end
  end
  model:gravity { 0, 0, -9.80665 }
  model:fracture { group = "lost", where = "all", rule = function(s) return s.time > 0.05 end }
  local rest = model:static { steps = 1, record = false }:finish()
  local run, rows = model:dynamic { from = rest, dt = 1e-3, duration = 1, record = false, threads = 1 }, {}
  while run.verdict == "running" do
    local begun, from = os.clock(), run.index
    for _ = 1, 50 do run:step() end
    local taken = us(os.clock() - begun, math.max(1, run.index - from))
    rows[#rows + 1] = { run.time, run:count { state = "yielded" }, taken }
  end
  assert(run.verdict == "completed", run.reason)
  return rows
end

return hinge.scenario {
  parameters = { integrator = "explicit", bars = 500, bays = 24, mass = 20000 },
  run = function(p, job)
    assert(os.execute("mkdir -p '" .. job.out:gsub("'", "'\\''") .. "'"))
    local file = assert(io.open(job.out .. "/bars.csv", "w"))
    file:write "part that falls,us a step\n"
    local x, y = {}, {}
    for i, part in ipairs { 0, 0.1, 0.25, 0.5, 0.75, 1 } do
      x[i], y[i] = 100 * part, bars(p, math.floor(part * p.bars))
      file:write(("%g,%.1f\n"):format(part, y[i]))
      print(("%3.0f %% of %d bars fall: %6.1f us a step"):format(x[i], p.bars, y[i]))
    end
    file:close()
    print(("all at rest, over all that fall: %.3f"):format(y[1] / y[#y]))
    local rows, t, cost, yielded = frame(p), {}, {}, {}
    file = assert(io.open(job.out .. "/frame.csv", "w"))
    file:write "time s,members that have yielded,us a step\n"
    for i, row in ipairs(rows) do
      file:write(("%g,%d,%.1f\n"):format(table.unpack(row)))
      t[i], yielded[i], cost[i] = row[1], row[2], row[3]
    end
    file:close()
    print(("frame of %d bays: %.0f us a step before it loses a column, %.0f at most, %.0f at the end; %d members yield")
      :format(p.bays, cost[1], support.largest_of(table.unpack(cost)), cost[#cost], yielded[#yielded]))
    job:plot({ title = ("%d bars, %s"):format(p.bars, p.integrator), x_label = "bars that fall, %",
      y_label = "us a step", series = { { x = x, y = y, name = "a step" } } }, "bars.png")
    job:plot({ title = ("A frame of %d bays that loses a column"):format(p.bays), x_label = "time, s",
      y_label = "us a step", series = { { x = t, y = cost, name = "a step" } } }, "frame.png")
    return { rest_over_fall = y[1] / y[#y] }
  end,
}
