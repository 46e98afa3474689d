-- Is energy kept when two beams collide? The paper's section 3.3, figures 13 to 15.
--
-- Run     hinge run scripts/paper/two_beam_impact.lua                 (any parameter: angle=45 offset=0.1 speed=100)
-- Shows   a free beam falls at 50 m/s on one that is clamped at both ends: two elements each, elastic, 3000 steps of
--         10 us, beta 0.4. Four contact rules: surface (bars press on each other where they are closest); gap (the
--         paper's gap elements, which give back their energy when the bars part); cut (gap elements that are released
--         after 0.5 ms); and eqs 17-19 as printed
-- Expect  rule                surface    gap       cut          as printed
--         energy error        0.20 %     0.67 %
--         energy lost         0          0         12.6 %       12.3 %
--         at other angles, offsets and speeds
--         energy error        0.3 %      1.01 %
--         energy lost         0          0         9 to 89 %
--         The energy error falls with the square of the step. With surface and beta 1/4 it is 70 times less. Two of
--         109 runs fail: gap elements with beta 0.4 at 20 and 40 us, a quarter and half of their period (*)
--         fig14_*.png: energies over time; fig15.png: snapshots; energy_error_over_dt.png
--
-- The paper's figure 13 is lost. Sizes, distance and material are *reconstructed*; they are parameters.
local hinge = require "hinge"
local paper = require "hinge.paper"

local rules = {
  { key = "surface", title = "surface", rule = { rule = "surface" } },
  { key = "gap", title = "gap", rule = { rule = "gap" } },
  { key = "cut", title = "gap, cut at 0.5 ms", rule = { rule = "gap", release = "time" } },
  { key = "as_printed", title = "gap, as printed", rule = { rule = "gap", as_printed = true } },
}
local percent = function(part) return ("%.2f"):format(100 * part) end

-- One collision. Returns the largest energy error and the released energy as parts of the initial energy, the balance
-- over time, and if the run failed, why. see(run) is called after each step.
local function collide(p, name, rule, changes, see)
  local q = setmetatable(changes or {}, { __index = p })
  local model = hinge.model { elements_per_member = q.elements, p_delta = "chord", interaction = "paper",
    weight = "nodes" } -- as in the paper
  local steel = hinge.material { E = q.E, nu = q.nu, density = q.density }
  local square = hinge.section.solid { width = q.thickness, depth = q.thickness }
  local along = { math.cos(math.rad(q.angle)), math.sin(math.rad(q.angle)) }
  local half, off = q.length / 2, q.offset - q.offset_free * along[1]
  local function end_of_free(side)
    return model:node { off + side * half * along[1], (side * half - q.offset_free) * along[2], q.gap }
  end
  local clamped = { model:node { -half, 0, 0 }, model:node { half, 0, 0 } }
  model:fix(clamped)
  model:member { clamped[1], clamped[2], section = square, material = steel, group = "clamped" }
  model:member { end_of_free(-1), end_of_free(1), section = square, material = steel, group = "free" }
  model:velocity("free", { 0, 0, -q.speed })
  model:gravity { 0, 0, -9.80665 }
  local contact = { friction = rule.rule == "surface" and q.friction or nil }
  for option, value in pairs(rule) do contact[option] = value end
  model:contact(contact)

  -- Every step is kept, as in the paper, also where one loses much energy: the energy error swings during a contact.
  local run = model:dynamic { dt = q.dt, duration = q.duration, beta = q.beta, step_control = 0,
    energy_tolerance = 0.1, record = false }
  local balance, every = { time = {} }, math.max(1, math.floor(q.duration / q.dt / 300 + 0.5))
  local worst, initial = 0, run.energy.initial
  for step in run:steps() do
    if step.index % every == 0 then
      local e = run.energy
      worst = math.max(worst, math.abs(e.energy_error))
      balance.time[#balance.time + 1] = 1e3 * run.time
      local terms = { kinetic = e.kinetic + e.gravity, elastic = e.elastic, stored = e.contact_stored,
        gone = e.contact_released, total = e.kinetic + e.gravity + e.elastic + e.contact_stored }
      for term, value in pairs(terms) do
        balance[term] = balance[term] or {}
        table.insert(balance[term], value / 1e3)
      end
    end
    if see then see(run) end
  end
  local e = run.energy
  return { worst = worst / initial, released = e.contact_released / initial, bound = run.contacts.bound,
    balance = balance, kinetic = (e.kinetic + e.gravity) / initial, elastic = e.elastic / initial, initial = initial,
    ended = paper.ended(run, name) }
end

-- A cell of a table, marked if its run failed.
local function cell(text, r) return r.ended and text .. "*" or text end

local function figure_14(job, title, key, balance)
  local shown = { { "kinetic + potential", "kinetic" }, { "strain", "elastic" }, { "held in contact", "stored" },
    { "released with contact", "gone" }, { "total", "total" } }
  local series = {}
  for i, item in ipairs(shown) do series[i] = { name = item[1], x = balance.time, y = balance[item[2]] } end
  job:plot({ title = "Fig. 14, " .. title, x_label = "time, ms", y_label = "energy, kJ", series = series },
    ("fig14_%s.png"):format(key))
end

-- Figure 15: snapshots of the collision by surfaces, in ms after the free beam starts.
local function snapshots(p, job)
  local shown, due = {}, { 0, 4.2, 5, 6, 8, 11 }
  local half = p.length / 2
  return function(run)
    local at = due[#shown + 1]
    if not at or 1e3 * run.time < at then return end
    shown[#shown + 1] = { run:snapshot(), { width = 640, height = 400, from = { -1, -1.4, 0.4 },
      box = { -half, half, -half, half, -0.1, 0.25 }, title = ("Fig. 15, %.1f ms"):format(1e3 * run.time) } }
    if #shown == #due then job:strip(shown, 3, "fig15.png") end
  end
end

-- Energy error over the time step, for both rules, with the paper's beta and with 1/4. A run fails when its energy
-- error reaches a tenth of the largest energy. The table then has the error at that time.
local function over_dt(p, job, count)
  local steps = p.quick and { 1e-5, 4e-5 } or { 1.25e-6, 2.5e-6, 5e-6, 1e-5, 2e-5, 4e-5 }
  local rows, series, result = {}, {}, {}
  for _, beta in ipairs { 0.4, 0.25 } do
    for i = 1, 2 do
      local x, y = {}, {}
      for n, dt in ipairs(steps) do
        local name = ("%s, beta %g, dt %g us"):format(rules[i].title, beta, 1e6 * dt)
        local r = count(collide(p, name, rules[i].rule, { dt = dt, beta = beta }))
        x[n], y[n] = 1e6 * dt, 100 * r.worst
        rows[n] = rows[n] or { ("%g"):format(1e6 * dt) }
        table.insert(rows[n], cell(("%.4f"):format(y[n]), r))
      end
      local name = ("%s, beta %g"):format(rules[i].title, beta)
      series[#series + 1] = { name = name, x = x, y = y, dashed = beta == 0.25 }
      result[#result + 1] = { rule = rules[i].key, beta = beta, dt_us = x, percent = y }
    end
  end
  paper.table("Largest energy error over the time step, % of the initial energy (*: until the run failed)",
    { "dt, us", "surface, beta 0.4", "gap, beta 0.4", "surface, beta 0.25", "gap, beta 0.25" }, rows)
  job:plot({ title = "What the step costs: two-beam impact", x_label = "time step, us", log_x = true, log_y = true,
    y_label = "largest energy error, % of the energy", series = series }, "energy_error_over_dt.png")
  return result
end

-- Both rules at other angles, offsets and speeds: the largest energy error and the released energy.
local function sweep(p, count)
  local rows, result = {}, {}
  for _, c in ipairs { { 90, 0, 0 }, { 70, 0, 0 }, { 45, 0, 0 }, { 20, 0, 0 }, { 90, 0.13, 0.07 }, { 70, 0.2, 0.2 },
    { 45, 0.3, -0.1 }, { 20, -0.2, 0.1 }, { 90, 0.25, 0.25 } } do
    for _, speed in ipairs(p.quick and { 50 } or { 10, 50, 100 }) do
      local row = { ("%d"):format(c[1]), c[2], c[3], speed }
      for i = 1, 3 do
        local name = ("%s, %d degrees, %g m and %g m off, %g m/s"):format(rules[i].title, c[1], c[2], c[3], speed)
        local crossing = { angle = c[1], offset = c[2], offset_free = c[3], speed = speed }
        local r = count(collide(p, name, rules[i].rule, crossing))
        if i < 3 then row[#row + 1] = cell(percent(r.worst), r) end
        if i > 1 then row[#row + 1] = cell(percent(math.max(r.released, 0)), r) end
        result[#result + 1] = { rule = rules[i].key, angle = c[1], offset = c[2], offset_free = c[3], speed = speed,
          worst = r.worst, released = r.released, ended = r.ended }
      end
      rows[#rows + 1] = row
    end
  end
  paper.table("Other crossings, % of the initial energy: energy error by surfaces; energy error and released, by gaps; "
    .. "released by gaps cut at 0.5 ms",
    { "angle", "off clamped, m", "off free, m", "m/s", "surface", "gap", "released", "cut" }, rows)
  return result
end

return hinge.scenario {
  parameters = {
    length = 1, thickness = 0.05, gap = 0.25,              -- m, *reconstructed*: axis to axis
    E = 206e9, nu = 0.3, density = 7850,                   -- Pa, kg/m^3, *reconstructed*
    speed = 50, angle = 90, offset = 0, offset_free = 0,   -- m/s, degrees, m: where they cross off the two middles
    friction = 0,                                          -- Coulomb's coefficient, by surfaces
    dt = 1e-5, duration = 0.03, beta = 0.4, elements = 2,  -- s: the paper's
    quick = false,
  },
  run = function(p, job)
    local rows, result, ended, all = {}, { rules = {} }, {}, 0
    local function count(r)
      ended[#ended + 1], all = r.ended, all + 1
      return r
    end
    for i, way in ipairs(rules) do
      local r = count(collide(p, way.title .. ", fig. 14", way.rule, nil, i == 1 and snapshots(p, job) or nil))
      figure_14(job, way.title, way.key, r.balance)
      rows[i] = { cell(way.title, r), r.bound, percent(r.worst), percent(math.max(0, r.released)), percent(r.kinetic),
        percent(r.elastic) }
      r.balance = nil
      result.rules[way.key] = r
    end
    paper.table(("Fig. 14: %.4f kJ fall at %g m/s, %g degrees; %% of them")
        :format(result.rules.surface.initial / 1e3, p.speed, p.angle),
      { "contact", "contacts", "largest error", "released", "kinetic + potential at the end", "strain at the end" },
      rows)
    local must_hold = #ended
    result.over_dt = over_dt(p, job, count)
    local long_steps = #ended - must_hold
    result.sweep = sweep(p, count)
    paper.show_ended(job, ended, all)
    result.ended, result.run_count = ended, all
    must_hold = #ended - long_steps
    job:verdict(must_hold == 0 and "completed" or "failed",
      must_hold .. " runs with the time step of the script failed")
    return result
  end,
}
