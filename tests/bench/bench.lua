-- What a step costs, beside what it gets right: ratios within one run, since machines are noisy.
--
-- Run     cmake --build build --target bench
--         or, without the effects compiled out: hinge run tests/bench/bench.lua (quick=true: shorter;
--         largest=1000000: bigger frames)
-- Shows   Case I of the ten-storey impact stage by stage, in microseconds and in products of its own effective
--         stiffness (6x6 blocks, one vector), Newmark's method and explicit; what is saved where nothing happens, and
--         what it changes; an effect that is off against an engine without it; rules of the script's own against
--         limits; threads; frames of growing size: time and memory
-- Expect  exit status 0: Case I ends as it should, and bits are the same where they must be; times are not checked
-- Writes  a CSV of each table and growth.png in its output folder
package.path = debug.getinfo(1, "S").source:match "^@(.-)[^/]*$" .. "../script/?.lua;" .. package.path
local support = require "support"
local hinge  = require "hinge"
local core   = require "hinge.core"
local impact = require "hinge.models.ten_storey_impact"
local paper  = require "hinge.paper"
local scenes = require "scenes"
local with   = scenes.with

-- Prints a table under its title and keeps it as name.csv.
local function show(job, name, title, head, rows)
  paper.table(title, head, rows)
  local file = assert(io.open(job.out .. "/" .. name .. ".csv", "w"))
  file:write(table.concat(head, ","), "\n")
  for _, row in ipairs(rows) do file:write(table.concat(row, ","), "\n") end
  file:close()
end

local faults = {} -- what is not as it must be

local function must(ok, format, ...)
  if not ok then faults[#faults + 1] = format:format(...) end
  return ok
end

local function text(format, value) return format:format(value) end
local function energy_error(run) return run.energy.energy_error / run.energy.initial end

-- Case I with the heavy frame, at rest under gravity; `options` go to model:dynamic, `rule` to model:contact, `breaks`
-- to model:fracture.
local function case_one(options, rule, breaks, p_delta)
  local q = impact.parameters { design = "heavy", dt = 1e-5 }
  local model = hinge.model { p_delta = p_delta or "chord", interaction = "paper", weight = "nodes" } -- as in the paper
  local _, plane = impact.add(model, q)
  if rule then model:contact(rule) end
  if breaks then model:fracture(breaks) end
  local loaded = model:static { fixed_group = plane, record = false }
  loaded:finish()
  local all = { from = loaded, dt = q.dt, record = false }
  if options.integrator ~= "explicit" then all.beta = 0.4 end
  for name, value in pairs(options) do all[name] = value end
  return model:dynamic(all), model
end

local function stages(job, name, what, run)
  local product = math.huge
  for step in run:steps() do -- the yardstick now and then, as the machine's speed changes
    if name == "case" and step.index % math.max(1, run.planned_steps // 20) == 0 then
      product = support.smallest_of(product, core.time_product(run, 5))
    end
  end
  must(run.verdict == "completed", "%s: %s", what, run.reason)
  local rows, sum, n = {}, 0, run.index
  for i, stage in ipairs(run.stages) do
    local us = 1e6 * stage.seconds / n
    sum = sum + us
    rows[i] = { stage.name, text("%.1f", us), name == "case" and text("%.2f", us * 1e-6 / product) or "" }
  end
  rows[#rows + 1] = { "step", text("%.1f", sum), name == "case" and text("%.2f", sum * 1e-6 / product) or "" }
  local counts = run.counts
  local title = what
    .. (": %d steps of %.3g us; %.2f iterations, %.2f elements rebuilt a step; energy error %.2g %%%s")
      :format(n, 1e6 * run.time / n, counts.cg_iterations / n, counts.element_builds / n, 100 * energy_error(run),
        name == "case" and (", a product takes %.1f us"):format(1e6 * product) or "")
  show(job, name, title, { "stage", "us", "products" }, rows)
  return { steps = n, step_us = sum, product_us = 1e6 * product, products = sum * 1e-6 / product,
    energy_error = energy_error(run) }
end

-- Runs each choice alternately, `times` times; least seconds of each, and its last run.
local function race(times, choices)
  local least, last = {}, {}
  for _ = 1, times do
    for i, choice in ipairs(choices) do
      local run = choice()
      run:finish()
      least[i], last[i] = support.smallest_of(least[i] or math.huge, run.wall_seconds), run
      collectgarbage()
    end
  end
  return least, last
end

-- What is left out where nothing happens: against the same with everything computed at every step.
local function savings(job, quick)
  local rows = {}
  local function compare(what, switch, lazy, full)
    local seconds, run = race(quick and 1 or 3, { lazy, full })
    local a, b = run[1].energy, run[2].energy
    rows[#rows + 1] = { what, switch, text("%.3f", seconds[1] / seconds[2]),
      run[1].hash == run[2].hash and "0 (same bits)" or text("%.1e", math.abs(a.kinetic - b.kinetic) / b.initial),
      text("%.1e", energy_error(run[1])), text("%.1e", energy_error(run[2])) }
  end
  local short = { duration = 0.002 }
  compare("bodies at rest, 2 ms of flight", "rest = false",
    function() return case_one(short) end,
    function() return case_one(with(short, { rest = false })) end)
  local hit = { duration = quick and 0.005 or 0.01 }
  compare("contact sleeps between looks", "model:contact { sleep = false }",
    function() return case_one(hit) end,
    function() return case_one(hit, { rule = "gap", binding_time = 0.5e-3, sleep = false }) end)
  compare("effective stiffness kept to 0.01 rad", "rebuild_angle = 1e-9",
    function() return case_one(hit) end,
    function() return case_one(with(hit, { internals = { rebuild_angle = 1e-9 } })) end)
  compare("effective stiffness in single precision", "precision = 'double'",
    function() return case_one(hit) end,
    function() return case_one(with(hit, { precision = "double" })) end)
  for name, chosen in pairs { newmark = hit, explicit = { duration = hit.duration, integrator = "explicit" } } do
    compare("axial force on chords, " .. name, "p_delta = 'member'",
      function() return case_one(chosen) end,
      function() return case_one(chosen, nil, nil, "member") end)
  end
  -- a bar thrown at a portal from 3 m away
  local function thrown(dt)
    local steel = hinge.material { E = 206e9, density = 7850, yield_stress = 250e6 }
    local bar = hinge.section.solid { width = 0.1, depth = 0.1 }
    local sizes = { section = bar, material = steel }
    local model = scenes.portal { width = 3, column = sizes, beam = sizes }
    model:member { model:node { 1.5, -3, 2 }, model:node { 1.5, -3, 4 },
      section = bar, material = steel, group = "missile" }
    model:velocity("missile", { 0, 60, 0 })
    model:contact {}
    return model:dynamic { dt = dt, duration = 0.1, record = false }
  end
  local steps = thrown("auto").planned_steps
  compare("long steps in flight, a thrown bar", "dt = a number",
    function() return thrown "auto" end,
    function() return thrown(0.1 / steps) end)
  show(job, "savings", "Where nothing happens, against everything computed: time as a ratio, "
    .. "difference of the kinetic energy, energy errors",
    { "what", "switch", "time", "difference", "energy error", "of all" }, rows)
  return rows
end

-- An elastic frame by an engine with every effect compiled in, and by one without those it does not call for.
local function compiled_out(job, build)
  local least, hash = {}, {}
  for _ = 1, 7 do
    for i, name in ipairs { "step_cost", "step_cost_bare" } do
      local pipe = assert(io.popen("'" .. build .. "/" .. name .. "'"))
      local us, bits = pipe:read("a"):match "^(%S+) (%S+)"
      pipe:close()
      us = assert(tonumber(us), name .. " gave no number")
      least[i], hash[i] = support.smallest_of(least[i] or math.huge, us), bits
    end
  end
  must(hash[1] == hash[2], "an engine without effects that are not called for has other bits")
  show(job, "compiled_out", "A step of an elastic frame that calls for no contact, fracture or plasticity",
    { "engine", "us", "ratio", "bits" },
    { { "all effects compiled in", text("%.2f", least[1]), text("%.3f", least[1] / least[2]), hash[1] },
      { "without them", text("%.2f", least[2]), "1", hash[2] } })
  return least[1] / least[2]
end

local function memory(kind) -- kB: VmRSS now, VmHWM the most so far
  for line in io.lines "/proc/self/status" do
    local kB = line:match("^" .. kind .. ":%s*(%d+)")
    if kB then return tonumber(kB) end
  end
end

-- A frame of n x n bays and so many storeys that moves under its own speed; `o.impact`: with
-- contact, fracture and yielding.
local function frame(elements, o)
  local building = require "hinge.models.ten_storey"
  local bays = math.max(1, math.floor((elements / 2 / 30) ^ (1 / 3) + 0.5))
  local each = (bays + 1) ^ 2 + 2 * bays * (bays + 1) -- members a storey
  local storeys = math.max(1, math.floor(elements / 2 / each + 0.5))
  collectgarbage()
  local before, start = memory "VmRSS" or 0, os.clock()
  local model = hinge.model {}
  building.add(model, { design = "heavy", bays = { bays, bays }, storeys = storeys })
  model:velocity("building", { 1, 0, 0 })
  if o.impact then
    model:contact {}
    model:fracture { curvature_x = 0.4, curvature_y = 0.4 }
  end
  local built = os.clock() - start
  local run = model:dynamic { dt = o.integrator == "explicit" and "auto" or 1e-5, duration = 1, record = false,
    integrator = o.integrator, threads = o.threads }
  for _ = 1, 3 do run:step() end -- the first one touches all memory
  local count, steps = model:counts().elements, math.max(25, math.floor(3e5 / elements))
  local least, per_batch = math.huge, math.max(1, steps // 5)
  for _ = 1, 5 do
    local from = run.wall_seconds
    for _ = 1, per_batch do run:step() end
    least = support.smallest_of(least, (run.wall_seconds - from) / per_batch)
  end
  local kB = ((memory "VmHWM" or 0) - before) / count
  local product = o.integrator == "explicit" and 0 or core.time_product(run, 3)
  return { elements = count, ns = 1e9 * least / count, products = product > 0 and least / product or 0,
    product_ns = 1e9 * product / count, built = built, kB = kB, energy_error = math.abs(energy_error(run)),
    hash = run.hash }
end

local kinds = { elastic = {}, impact = { impact = true }, explicit = { integrator = "explicit" } }
local fields = { "elements", "ns", "products", "product_ns", "built", "kB", "energy_error" }

-- The same in a process of its own, whose memory is this frame's alone.
local function alone(kind, size)
  local script = debug.getinfo(1, "S").source:match "^@(.*)"
  local command = ("exe=$(readlink /proc/$PPID/exe); \"$exe\" run '%s' one=%s size=%d 2>/dev/null")
    :format(script, kind, size)
  local pipe = assert(io.popen(command))
  local line = pipe:read("a"):match "frame: ([^\n]*)"
  pipe:close()
  local f, i = {}, 0
  for word in assert(line, "the frame of " .. size .. " elements gave no result"):gmatch "%S+" do
    i = i + 1
    f[fields[i]] = tonumber(word)
  end
  return f
end

local function growth(job, p)
  local rows, series = {}, {}
  for _, kind in ipairs { { "elastic" }, { "impact" }, { "explicit" } } do
    local x, y, size = {}, {}, 1000
    while size <= (p.quick and 3000 or p.largest) do
      local f = alone(kind[1], size)
      rows[#rows + 1] = { kind[1], f.elements, text("%.0f", f.ns), f.products > 0 and text("%.1f", f.products) or "",
        f.products > 0 and text("%.0f", f.product_ns) or "", text("%.2f", f.built), text("%.2f", f.kB),
        text("%.1e", f.energy_error) }
      x[#x + 1], y[#y + 1] = f.elements, f.ns
      size = size * 10
    end
    series[#series + 1] = { x = x, y = y, name = kind[1] }
  end
  show(job, "growth", "Frames of growing size, moving: a step",
    { "what", "elements", "ns an element", "products", "ns a product", "build, s", "kB an element, peak",
      "energy error" }, rows)
  job:plot({ title = "Cost of an element's step", x_label = "elements", y_label = "ns", log_x = true,
    series = series }, "growth.png")
  return rows
end

-- Case I by numbers, and by functions of the script that say the same (eq 16).
local function rules(job, duration)
  local abs = math.abs
  local choices = {
    { "limits" },
    { "a function of a section", { rule = function(s)
      return abs(s.curvature_x) >= 0.4 or abs(s.curvature_y) >= 0.4 or abs(s.axial_strain) >= 0.3
    end } },
  }
  local runs, rows = {}, {}
  for i, choice in ipairs(choices) do runs[i] = case_one({ duration = duration }, nil, choice[2]) end
  repeat -- in alternation
    local more
    for _, run in ipairs(runs) do
      for _ = 1, 100 do more = run:step() end
    end
  until not more
  for i, run in ipairs(runs) do
    rows[i] = { choices[i][1], text("%.1f", 1e6 * run.wall_seconds / run.index),
      text("%.3f", run.wall_seconds / runs[1].wall_seconds),
      run:count { state = "broken" },
      must(run.hash == runs[1].hash, "%s: other bits than by limits", choices[i][1]) and "the same" or "OTHER" }
  end
  show(job, "rules", "Case I, who decides what breaks",
    { "rule", "us a step", "ratio", "members broken", "bits" }, rows)
  return rows
end

-- What more threads would give, reckoned from frames that fit the cache (10^4 elements) and that do not. Of the time of
-- a step some is serial (s), some is shared out (c) and some is spent waiting for memory (m), ns an element:
--   cache, 1 thread: s + c      2 threads: s + c / 2      memory, 1 thread: s + c + m      2 threads: s + c / 2 + m / b
-- `most`: how many times one core's bandwidth the memory has at most.
local function reckoned(small, large, n, most)
  local s = math.max(0, 2 * small[2].ns - small[1].ns)
  local c = small[1].ns - s
  local m = math.max(0, large[1].ns - small[1].ns)
  local waits = large[2].ns - s - c / 2
  local b = waits > 0 and math.max(1, math.min(2, m / waits)) or 2
  return large[1].ns / (s + c / n + m / math.max(1, math.min(most or b, n * b / 2)))
end

local function threads(job, quick)
  local rows, more = {}, {}
  for _, integrator in ipairs { "newmark", "explicit" } do
    local of = {}
    for i, size in ipairs(quick and { 3000, 10000 } or { 10000, 100000 }) do
      of[i] = {}
      for turn = 1, quick and 2 or 6 do -- by turns: other programs take a core now and then
        local n = (turn - 1) % 2 + 1
        local f = frame(size, { integrator = integrator, threads = n })
        if not of[i][n] or f.ns < of[i][n].ns then of[i][n] = f end
      end
      for n = 1, 2 do
        local first, f = of[i][1], of[i][n]
        rows[#rows + 1] = { integrator, f.elements, n, text("%.0f", f.ns), text("%.2f", first.ns / f.ns),
          must(f.hash == first.hash, "%s, %d threads: other bits", integrator, n) and "the same" or "OTHER" }
      end
    end
    for _, n in ipairs { 1, 2, 4, 8, 16 } do
      more[#more + 1] = { integrator, of[2][1].elements, n, text("%.2f", reckoned(of[1], of[2], n)),
        text("%.2f", reckoned(of[1], of[2], n, 8)) }
    end
  end
  show(job, "threads", "Threads", { "integrator", "elements", "threads", "ns an element", "speed-up", "bits" }, rows)
  show(job, "more_threads", "Threads, reckoned", { "integrator", "elements", "threads",
    "speed-up if two cores use all of the memory's bandwidth", "if eight cores do" }, more)
  return rows
end

return hinge.scenario {
  parameters = { duration = 0.25, largest = 100000, quick = false, build = "", one = "", size = 1000 },
  run = function(p, job)
    if p.one ~= "" then -- called by `alone`
      local f, words = frame(p.size, kinds[p.one]), {}
      for i, name in ipairs(fields) do words[i] = text("%.9g", f[name]) end
      print("frame: " .. table.concat(words, " "))
      return {}
    end
    assert(os.execute("mkdir -p '" .. job.out:gsub("'", "'\\''") .. "'"))
    local length = p.quick and 0.02 or p.duration
    local result = { case = stages(job, "case", "Case I", (case_one { duration = length })) }
    result.explicit = stages(job, "explicit", "Case I, explicit",
      (case_one { duration = length, integrator = "explicit", dt = 1e-5 }))
    local run = stages(job, "explicit_auto", "Case I, explicit, dt = 'auto'",
      (case_one { duration = length, integrator = "explicit", dt = "auto" }))
    result.explicit_auto = run
    if p.build ~= "" then result.compiled_out = compiled_out(job, p.build) end
    result.savings = savings(job, p.quick)
    result.rules = rules(job, length)
    result.threads = threads(job, p.quick)
    result.growth = growth(job, p)
    job:verdict(#faults == 0 and "completed" or "failed", table.concat(faults, "; "))
    return result
  end,
}
