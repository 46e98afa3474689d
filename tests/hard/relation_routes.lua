-- Relations of routes to one answer: more elements, slow dynamics, explicit steps, a cut run, damping as asked.
local scenes = require "relation_scenes"
local built = require "relation_model"
local runs = require "relation_runs"
local support = require "support"
local with = require "scenes".with
local has, elastic, worse, static, dynamic = runs.has, runs.elastic, runs.worse, runs.static, runs.dynamic
local compare, dynamic_options, zero, chance = runs.compare, runs.dynamic_options, runs.zero, runs.chance
local list = {}

-- Other routes to the same answer -----------------------------------------------------------------------------------

list[#list + 1] = { name = "elements", why = "exact in small displacement; in large, pairs bow as one curve: 2 %",
  fits = function(s)
    -- Slender braces take tension by their sag, and act on their chords where they carry one sign of N: more elements,
    -- more of it. A load along a member that is slack hangs on the elements that are not.
    local rods = #s.braces > 0 and (s.options.displacement ~= "small" or has(s, "one_way"))
    return s.mode == "static" and elastic(s) and not rods and not has(s, "one_way")
  end,
  check = function(hinge, s)
    local answers, limit = {}, s.options.displacement == "small" and 1e-6 or 0.02
    for k, n in ipairs(limit < 1e-5 and { 2, 4, 8 } or { 4, 8 }) do
      local b, run = static(hinge, s, built.way { options = { elements_per_member = n } })
      answers[k] = built.answer(b, run)
      if run.verdict == "completed" then
        for _, member in ipairs(b.members) do
          local at = {}
          for _, row in ipairs(member:along(run, 8)) do at[math.floor(row.x / member.length * 8000 + 0.5)] = row end
          for i = 1, 7 do -- between the joints too
            local row = at[1000 * i]
            for _, name in ipairs { "Mx", "My" } do table.insert(answers[k].moment, row[name]) end
          end
        end
      end
      b.model:close()
    end
    local off, what = compare(answers[1], answers[2], limit)
    if off and answers[3] then
      local more, which = compare(answers[1], answers[3], limit)
      if more == nil or more > off then off, what = more, which end
    end
    return off, what
  end }

-- The circular frequency of the first mode in the state of a static run.
local function first_frequency(hinge, s)
  local b, run = static(hinge, s, built.way())
  if run.verdict ~= "completed" then return nil end
  local mode = run:modes({ n = 1 })[1]
  b.model:close()
  return mode and mode.frequency > 0 and 2 * math.pi * mode.frequency or nil
end

-- The parts of a scene with its loads raised from 0 over a time.
local function ramp(s, over)
  for i, p in ipairs(s.parts) do
    if p.kind == "load" or p.kind == "q" or p.kind == "point" then
      s.parts[i] = with(p, { history = { { 0, 0 }, { over, 1 } } })
    end
  end
end

list[#list + 1] = { name = "slow dynamics",
  why = "what damping and the steps' iterations leave: 3e-4; axes of joints that are rigid give in dynamics: 1e-3",
  fits = function(s) return s.mode == "static" and elastic(s) and not has(s, "settle") end,
  check = function(hinge, s)
    local straight, run = static(hinge, s, built.way())
    local a = built.answer(straight, run)
    straight.model:close()
    local w = first_frequency(hinge, s)
    if not w then return nil, "no frequency" end
    local slow = scenes.copy(s)
    slow.parts[#slow.parts + 1] = { kind = "damping", alpha = 2 * w, beta = 0 }
    slow.mode = "dynamic"
    local T = 2 * math.pi / w
    ramp(slow, 2 * T)
    -- from rest under what is there at once; what the steps do not resolve is damped by the method
    local b = built.make(hinge, slow, built.way())
    local more = { dt = T / 40, duration = 6 * T, iterations = 30, rho_infinity = 0.5, record = false,
      energy_tolerance = 0, precision = "double", internals = { solver_tolerance = 1e-12 } }
    local at_once = has(s, "gravity", "heat", "prestress")
    for _, p in ipairs(s.parts) do at_once = at_once or p.kind == "link" and p.dofs == "all" end
    if at_once then
      more.from = b.model:static({ tolerance = 1e-11, record = false }):finish()
    end
    local its = b.model:dynamic(more):finish()
    local off, what = compare(a, built.answer(b, its), has(s, "joint") and 1e-3 or 3e-4)
    b.model:close()
    return off, what
  end }

local left_out = {}
for _, kind in ipairs { "gravity", "heat", "prestress", "velocity", "link", "settle", "move", "remove", "contact",
  "ground", "yield", "hardening", "rate", "backbone", "law", "fracture" } do
  left_out[kind] = true
end
-- Lumps have the polar inertia of a section about every axis (beam/element_mass.h), twice that of bending: 4 % of the
-- displacements of members that are 1.5 times as long as they are deep, whatever their elements.
local function is_stubby(s)
  for _, member in ipairs(s.members) do
    local of = member.section
    if member.length < 4 * support.largest_of(of.depth or of.diameter, of.width or 0) then return true end
  end
  return false
end

--- By both methods with n elements a member, over a period T: the largest difference of displacements.
local function largest_difference(hinge, s, T, n)
  local answers, most = {}, {}
  for k, integrator in ipairs { "newmark", "explicit" } do
    local b, run = dynamic(hinge, s, built.way { options = { elements_per_member = n } },
      { integrator = integrator, dt = k == 1 and T / 200 or "auto", duration = T })
    local largest = 0
    run:on_step(function(r)
      for _, node in ipairs(b.nodes) do
        local x, y, z = node:displacement(r)
        largest = worse(largest, math.sqrt(x * x + y * y + z * z))
      end
    end)
    run:finish()
    answers[k], most[k] = built.answer(b, run), largest
    b.model:close()
  end
  if answers[1].verdict ~= "completed" or answers[2].verdict ~= "completed" then
    return answers[1].verdict ~= answers[2].verdict and math.huge or nil, answers[1].reason .. answers[2].reason
  end
  local off, what = 0, ""
  for i, v in ipairs(answers[1].u) do
    local by = math.abs(v - answers[2].u[i]) / (0.03 * most[1])
    if not (by <= off) then off, what = worse(off, by), ("u %d: %.6g and %.6g, largest %.6g"):format(i, v,
      answers[2].u[i], most[1]) end
  end
  return off, what
end

-- What is left of a scene whose displacements both methods must have.
local function smooth_part(s)
  local smooth = scenes.copy(s, function(p) return left_out[p.kind] and p.kind ~= "move" end)
  smooth.mode, smooth.yields, smooth.options.interaction = "dynamic", false, nil
  return smooth
end

list[#list + 1] = { name = "explicit", why = "lumped against consistent mass, 8 elements, or 16: 3 % of the largest",
  fits = function(s) return s.held and #s.members < 5 and not is_stubby(s) and not has(s, "concrete") end,
  acts = smooth_part,
  check = function(hinge, s)
    -- what acts at once sets off vibrations that have other frequencies with other masses; what flows or breaks does so
    -- at another time
    local still = scenes.copy(s, function(p) return left_out[p.kind] end)
    still.mode, still.yields = "static", false
    for i, p in ipairs(still.parts) do
      if p.history then
        still.parts[i] = with(p)
        still.parts[i].history = nil
      end
    end
    local w = first_frequency(hinge, still)
    if not w then return nil, "no frequency" end
    local smooth = smooth_part(s)
    local T, o = 2 * math.pi / w, dynamic_options(s)
    if T > 400 * o.dt then return nil, "too many explicit steps" end
    ramp(smooth, T / 2)
    for i, p in ipairs(smooth.parts) do
      if p.kind == "move" then smooth.parts[i] = { kind = "move", node = p.node, by = p.by, over = T / 2 } end
    end
    local off, what = largest_difference(hinge, smooth, T, 8)
    if off and off > 1 then off, what = largest_difference(hinge, smooth, T, 16) end
    return off, what
  end }

list[#list + 1] = { name = "cut in two", why = "bits",
  fits = function(s) return s.mode == "dynamic" end,
  check = function(hinge, s)
    local whole, run, o = dynamic(hinge, s, built.way())
    run:finish()
    local b, cut = dynamic(hinge, s, built.way())
    local file = os.tmpname()
    for _ = 1, 37 do cut:step() end
    cut:checkpoint(file)
    local other = b.model:dynamic(o):resume(file):finish()
    os.remove(file)
    local same = other.hash == run.hash and other.index == run.index and other.verdict == run.verdict
    local what = ("%s %d %s, and %s %d %s"):format(run.hash, run.index, run.verdict, other.hash, other.index,
      other.verdict)
    whole.model:close()
    b.model:close()
    return same and 0 or math.huge, what
  end }

list[#list + 1] = { name = "two runs", why = "bits; without step control, whose share of a step hangs on the duration",
  fits = function(s) return s.mode == "dynamic" end,
  check = function(hinge, s)
    local o = dynamic_options(s)
    local more = { integrator = s.seed % 3 == 0 and "explicit" or nil, step_control = s.seed % 3 ~= 0 and 0 or nil }
    local whole, run = dynamic(hinge, s, built.way(), more)
    run:finish()
    more.duration = 37 * o.dt
    local b, first, settings = dynamic(hinge, s, built.way(), more)
    settings.from, settings.duration, settings.allow_failed = first:finish(), o.duration - 37 * o.dt, true
    local second = b.model:dynamic(settings):finish()
    local same = second.hash == run.hash and first.index + second.index == run.index
    local what = ("%s %d %s, and %s %d + %d %s"):format(run.hash, run.index, run.verdict, second.hash, first.index,
      second.index, second.verdict)
    local failed = run.verdict == "failed" -- at a step that either way is the last: the energy balance is looked at
    whole.model:close()
    b.model:close()
    if failed then return nil, "the run fails" end
    return same and 0 or math.huge, what
  end }

list[#list + 1] = { name = "decay", why = "higher modes and the period of Newmark's method: 4 % of the ratio",
  fits = function(s) -- beta does not damp panels
    return s.mode == "static" and elastic(s) and s.seed % 2 == 0 and not has(s, "one_way", "panel")
  end,
  check = function(hinge, s)
    local small = scenes.copy(s, function(p) return p.kind == "load" or p.kind == "q" or p.kind == "point" or
      p.kind == "gravity" or p.kind == "settle" or p.kind == "heat" or p.kind == "prestress" or p.curve ~= nil end)
    for i, p in ipairs(small.parts) do
      if p.kind == "link" then
        small.parts[i] = { kind = "link", from = p.from, by = p.by, dofs = p.dofs, force = zero }
      end
    end
    small.options.displacement = "small"
    local node
    for i, n in ipairs(small.nodes) do node = node or not n.fixed and i or nil end
    small.parts[#small.parts + 1] = { kind = "mass", node = node, mass = 3e4, inertia = 0 }
    small.parts[#small.parts + 1] = { kind = "load", node = node, force = { 1e-3, 0, 0 } }
    local b, run = static(hinge, small, built.way(), { steps = 1 })
    if run.verdict ~= "completed" then return nil, "the run fails: " .. run.reason:sub(1, 100) end
    local mode = run:modes({ n = 1 })[1]
    local w = mode.frequency and 2 * math.pi * mode.frequency or 0
    local shape = { mode:displacement(b.nodes[node]) }
    b.model:close()
    if not (w > 0) then return nil, "no frequency" end
    local size = math.sqrt(shape[1] ^ 2 + shape[2] ^ 2 + shape[3] ^ 2)
    if not (3e4 * size ^ 2 > 0.97) then return nil, "the mode is not that of the mass" end
    for i = 1, 3 do shape[i] = shape[i] / size end
    local d = chance(s, 105)
    local ratio, T = d.log(0.01, 0.1), 2 * math.pi / w
    small = scenes.copy(small, function(p) return p.kind == "load" end)
    small.mode = "dynamic"
    small.parts[#small.parts + 1] = d.pick { { kind = "damping", alpha = 2 * ratio * w, beta = 0 },
      { kind = "damping", alpha = 0, beta = 2 * ratio / w }, { kind = "damping", alpha = ratio * w, beta = ratio / w } }
    small.parts[#small.parts + 1] = { kind = "velocity", node = node, v = { shape[1], shape[2], shape[3] }, w = zero }
    local other, its = dynamic(hinge, small, built.way(), { dt = T / 200, duration = 5.3 * T, step_control = 0 })
    local before, last, peaks = 0, 0, {}
    while its:step() do
      local x, y, z = other.nodes[node]:displacement(its)
      local u = x * shape[1] + y * shape[2] + z * shape[3]
      if last > before and last > u and its.time > 0.5 * T then -- a parabola through three points
        local top = last - (u - before) ^ 2 / (8 * (u - 2 * last + before))
        peaks[#peaks + 1] = top
      end
      before, last = last, u
    end
    other.model:close()
    if #peaks ~= 5 and #peaks ~= 4 then return nil, #peaks .. " peaks: other modes are in the motion" end
    local decrement = math.log(peaks[1] / peaks[#peaks]) / (#peaks - 1)
    local found = decrement / math.sqrt(4 * math.pi ^ 2 + decrement ^ 2)
    return math.abs(found / ratio - 1) / 0.04, ("ratio %.5g for %.5g"):format(found, ratio)
  end }

return list
