-- What a step costs, beside what it gets right: ratios within one run, since machines are noisy.
--
-- Run     hinge run tests/bench/bench.lua               (quick=true: shorter; largest=100000: frames up to that many elements)
-- Shows   Case I of the ten-storey impact stage by stage, in microseconds and in products of its own operator (6x6 blocks, one
--         vector), with the energy remainder; frames of growing size: time per element and step, memory per element
-- Writes  case.csv, growth.csv and growth.png in its output folder
local hinge  = require "hinge"
local core   = require "hinge.core"
local impact = require "hinge.models.ten_storey_impact"
local paper  = require "hinge.paper"

local function csv(job, name, head, rows)
  local file = assert(io.open(job.out .. "/" .. name, "w"))
  file:write(table.concat(head, ","), "\n")
  for _, row in ipairs(rows) do file:write(table.concat(row, ","), "\n") end
  file:close()
end

local function case_one(p, job)
  local q = impact.parameters { dt = 1e-5 }
  local model = hinge.model {}
  local _, plane = impact.add(model, q)
  local loaded = model:static { hold = plane, record = false }
  loaded:finish()
  local run = model:dynamic { from = loaded, dt = q.dt, duration = p.quick and 0.02 or p.duration, beta = 0.4, record = false }
  local product = math.huge
  for step in run:steps() do -- the yardstick now and then, as the machine's pace changes
    if step.index % math.max(1, run.planned_steps // 20) == 0 then product = math.min(product, core.time_product(run, 5)) end
  end
  local rows, sum, n = {}, 0, run.index
  for i, stage in ipairs(run.stages) do
    local us = 1e6 * stage.seconds / n
    sum, rows[i] = sum + us, { stage.name, ("%.1f"):format(us), ("%.2f"):format(us * 1e-6 / product) }
  end
  rows[#rows + 1] = { "step", ("%.1f"):format(sum), ("%.2f"):format(sum * 1e-6 / product) }
  local energy, counts = run.energy, run.counts
  paper.table(("Case I, %d steps: a product takes %.1f us; per step %.2f iterations, %.2f elements rebuilt; energy remainder %.2g %%")
    :format(n, 1e6 * product, counts.cg_iterations / n, counts.element_builds / n, 100 * energy.remainder / energy.initial),
    { "stage", "us", "products" }, rows)
  csv(job, "case.csv", { "stage", "us", "products" }, rows)
  return { steps = n, step_us = sum, product_us = 1e6 * product, products = sum * 1e-6 / product,
    remainder = energy.remainder / energy.initial, iterations = counts.cg_iterations / n, builds = counts.element_builds / n }
end

local function resident() -- kB
  for line in io.lines "/proc/self/status" do
    local kB = line:match "^VmRSS:%s*(%d+)"
    if kB then return tonumber(kB) end
  end
end

-- A frame of n x n bays and so many storeys that shakes under a sudden side load on all its joints.
local function frame(elements)
  local building = require "hinge.models.ten_storey"
  local bays = math.max(1, math.floor((elements / 2 / 30) ^ (1 / 3) + 0.5))
  local each = (bays + 1) ^ 2 + 2 * bays * (bays + 1) -- members a storey
  local storeys = math.max(1, math.floor(elements / 2 / each + 0.5))
  local before, start = resident(), os.clock()
  local model = hinge.model {}
  building.add(model, { bays = { bays, bays }, storeys = storeys })
  model:velocity("building", { 1, 0, 0 })
  local run = model:dynamic { dt = 1e-5, duration = 1, record = false }
  local built, steps = os.clock() - start, math.max(5, math.floor(2e5 / elements))
  run:step() -- the first one touches all memory
  start = os.clock()
  for _ = 1, steps do run:step() end
  local seconds, count = (os.clock() - start) / steps, model:counts().elements
  local energy = run.energy
  return { count, ("%.0f"):format(1e9 * seconds / count), ("%.2f"):format(seconds / core.time_product(run, 5)), ("%.2f"):format(built),
    ("%.2f"):format(((resident() or 0) - (before or 0)) / count), ("%.1e"):format(math.abs(energy.remainder) / energy.initial) }
end

return hinge.scenario {
  parameters = { duration = 0.1, largest = 30000, quick = false },
  run = function(p, job)
    assert(os.execute("mkdir -p '" .. job.out:gsub("'", "'\\''") .. "'"))
    local result = { case = case_one(p, job), growth = {} }
    local rows, x, y, size = {}, {}, {}, 1000
    while size <= (p.quick and 3000 or p.largest) do
      rows[#rows + 1] = frame(size)
      x[#x + 1], y[#y + 1] = tonumber(rows[#rows][1]), tonumber(rows[#rows][2])
      collectgarbage()
      size = size * 10 ^ 0.5
    end
    local head = { "elements", "ns/element/step", "products a step", "build, s", "kB/element", "remainder" }
    paper.table("Frames of growing size, elastic, moving", head, rows)
    csv(job, "growth.csv", head, rows)
    job:plot({ title = "Cost of an element's step", x_label = "elements", y_label = "ns", log_x = true, series = { { x = x, y = y } } }, "growth.png")
    result.growth = rows
    return result
  end,
}
