-- Does a heavier, faster or larger aircraft do more damage, and how does the building respond? The paper's section 4.
--
-- Run     hinge run scripts/paper/ten_storey_cases.lua   (half=1: in one process; quick=true: 20 ms of each case)
-- Shows   table 1, figures 17 to 19: Cases I to IV side by side, 0.25 s at 10 us, each with the aircraft 0, 1 and 2 mm
--         aside, since the motion of the debris is chaotic. A finding that compares two cases holds if the means do, in
--         plastic work and in broken members of the building
-- Expect  Case                               I             II            III           IV
--         inner columns cut                  15 to 18      10            11 to 17      12 to 13
--         members of the building broken     55 to 67      31 to 35      40 to 54      41 to 52
--         plastic work in the building, MJ   1.6 to 2.5    0.7 to 1.2    1.0 to 1.9    1.6 to 2.1
--         All findings hold but II > III; I > III on the mean, not for every pair of runs. The impact reaches every
--         storey within 7 ms (f_y changed by 0.005; within 13 ms by 0.05); the elastic wave takes 4 ms. Tension begins
--         after 0.3 ms, in 134 of the 250 columns, up to 1.1 MN. Energy error at most 0.016 %
--         fig17_stills.png, fig17.png, fig18_*.png, fig19.png
--
-- The paper's figure 16 is lost. The frame, the aircraft's members and the place of the impact are *reconstructed*, by
-- the study lost_inputs.lua. design=heavy height=30 is the frame of earlier versions.
local hinge  = require "hinge"
local impact = require "hinge.models.ten_storey_impact"
local paper  = require "hinge.paper"

local view   = { -10, 34, 2, 30, 0, 40 } -- m, the same for all snapshots of figure 17
local snapshots = { 0, 2e-3, 5e-3, 10e-3, 25e-3, 50e-3, 100e-3, 150e-3, 240e-3 } -- s after first contact

local function mega(joules) return ("%.2f"):format(joules / 1e6) end
local function ms(seconds) return seconds < 0 and "-" or ("%.2f"):format(1e3 * seconds) end

-- Pictures of one run: the upper five storeys without broken members (figure 18), and for Case I a strip of snapshots
-- (figure 17).
local function pictures(p, job, case)
  return function(run, frame, watch)
    local strip = {}
    return function(step)
      local after, due = watch.touched and run.time - watch.touched, snapshots[#strip + 1]
      if case == "I" and after and due and after >= due - p.dt / 2 then
        local title = ("Case I, %.0f ms after contact"):format(1e3 * after)
        strip[#strip + 1] = { run:snapshot(), { title = title, box = view, width = 800, height = 800 } }
      end
      if step.index < run.planned_steps then return end
      if #strip > 0 then job:strip(strip, 3, "fig17_stills.png") end
      local upper = frame.size[3] / 2 - 0.5 -- half a metre below the sixth floor, so that its beams are in
      job:picture(run, { title = "Fig. 18, Case " .. case, above = upper, leave_out_broken = true,
        groups = { "building" } }, ("fig18_%s.png"):format(case))
    end
  end
end

-- The smallest and the largest value of a measure over the runs of a case.
local function range(runs, name)
  local least, most = math.huge, -math.huge
  for _, r in ipairs(runs) do least, most = math.min(least, r[name]), math.max(most, r[name]) end
  return least, most
end

local function spread(runs, name, scale, form)
  local least, most = range(runs, name)
  return least == most and form:format(least / scale) or (form .. " to " .. form):format(least / scale, most / scale)
end

local function mean(runs, name)
  local sum = 0
  for _, r in ipairs(runs) do sum = sum + r[name] / #runs end
  return sum
end

-- Whether a case has more than another on the mean of its runs, and whether all its runs have more.
local function more(a, b, name)
  return mean(a, name) > mean(b, name), (range(a, name)) > select(2, range(b, name))
end

local function tables(first, runs)
  local rows = {}
  local function row(name, show)
    local cells = { name }
    for i, case in ipairs(impact.order) do cells[i + 1] = show(first[case], runs[case]) end
    rows[#rows + 1] = cells
  end
  local function count(name) return function(r) return ("%d"):format(r[name]) end end
  local function energy(name) return function(r) return mega(r[name]) end end

  row("speed, km/h; size, m; mass, t", function(r)
    return ("%.0f; %.0f; %.0f"):format(3.6 * r.speed, r.size, r.mass / 1e3)
  end)
  row("kinetic energy brought, MJ", energy "own_kinetic")
  row("momentum brought, kN s", function(r) return ("%.0f"):format(r.brought / 1e3) end)
  row("failed at, ms", function(r) return r.verdict == "failed" and ("%.1f *"):format(1e3 * r.time) or "no" end)
  row("columns fractured, inner", count "broken_inner")
  row("columns fractured, outer", count "broken_outer")
  row("beams fractured", count "broken_beams")
  row("lowest storey with fracture", function(r) return r.lowest > 0 and r.lowest or "none" end)
  row("columns with a hinge, inner", count "hinged_inner")
  row("columns with a hinge, outer", count "hinged_outer")
  row("beams with a hinge, of 400", count "hinged_beams")
  row("columns hit, inner + outer", function(r) return ("%d + %d"):format(r.touched_inner, r.touched_outer) end)
  row("aircraft members fractured, of 199", count "broken_aircraft")
  paper.table("Table 1 and fig. 18: damage", { "Case", table.unpack(impact.order) }, rows)

  rows = {}
  row("hinges of inner columns", energy "work_inner")
  row("hinges of outer columns", energy "work_outer")
  row("hinges of beams", energy "work_beams")
  row("building in all", energy "work")
  row("  over all runs of the case", function(_, all) return spread(all, "work", 1e6, "%.1f") end)
  row("  of the kinetic energy brought", function(r) return ("%.1f %%"):format(100 * r.work / r.own_kinetic) end)
  row("hinges of the aircraft", energy "work_aircraft")
  row("released by fracture", energy "fracture")
  row("released with contact ties", energy "contact")
  row("elastic", energy "elastic")
  row("still moving (nearly all aircraft)", energy "kinetic")
  row("energy error", energy "energy_error")
  row("momentum of the building at the end, of that brought",
    function(r) return r.given and ("%.0f %%"):format(100 * r.given) or "-" end)
  paper.table("Where the energy went, MJ", { "Case", table.unpack(impact.order) }, rows)
end

local function figure_17(r, job)
  local rows, hit = {}, math.ceil(r.height / r.storey)
  local function away(level) -- m, from where the aircraft hits to the storey's columns
    return math.max(0, level > hit and (level - 1) * r.storey - r.height or r.height - level * r.storey)
  end
  local function wave(name, speed)
    local line = { name = ("%s, %.0f m/s"):format(name, speed), x = {}, y = {}, dashed = true }
    for level = 1, #r.felt do line.x[level], line.y[level] = 1e3 * away(level) / speed, level end
    return line
  end
  local function points(name, times)
    local seen = { name = name, x = {}, y = {}, style = "points" }
    for level, t in ipairs(times) do
      if t >= 0 then seen.x[#seen.x + 1], seen.y[#seen.y + 1] = 1e3 * t, level end
    end
    return seen
  end
  for level = #r.felt, 1, -1 do
    rows[#rows + 1] = { level, ms(away(level) / r.wave), ms(away(level) / r.long_wave), ms(r.faint[level]),
      ms(r.felt[level]), ms(r.red[level]) }
  end
  paper.table("Fig. 17, Case I: when a column of a storey first feels the impact, ms after first contact",
    { "storey", "elastic wave", "long wave", "f_y changed by 0.005", "by 0.05", "fully plastic" }, rows)
  job:plot({ title = "Fig. 17, Case I: the impact travels",
    x_label = "time after first contact, ms", y_label = "storey",
    series = { wave("elastic wave", r.wave), points("f_y changed by 0.005", r.faint), points("by 0.05", r.felt),
      wave("long wave, with the floors", r.long_wave) } }, "fig17.png")
end

local function figure_19(r, job)
  local rows, by_storey = {}, {}
  for _, c in ipairs(r.pulled) do
    local s = by_storey[c.storey] or { count = 0, first = c.first, most = 0, before = 0 }
    s.count, s.first = s.count + 1, math.min(s.first, c.first)
    if c.most > s.most then s.most, s.before = c.most, c.before end
    by_storey[c.storey] = s
  end
  for level = #r.felt, 1, -1 do
    local s = by_storey[level]
    rows[#rows + 1] = s
      and { level, s.count, ms(s.first), ("%.2f"):format(s.most / 1e6), ("%.2f"):format(s.before / 1e6) }
      or { level, 0, "-", "-", "-" }
  end
  paper.table("Fig. 19, Case I: columns that were compressed and carry tension",
    { "storey", "columns of 25", "first, ms", "most tension, MN", "the same before, MN" }, rows)
  local time = {}
  for i, t in ipairs(r.times) do time[i] = 1e3 * t end
  job:plot({ title = "Fig. 19, Case I: columns pulled that were pressed", x_label = "time after first contact, ms",
    y_label = "columns", series = { { name = "of all 250", x = time, y = r.counts },
      { name = "of the lower half", x = time, y = r.below } } }, "fig19.png")
  return by_storey
end

-- The paper's findings against the numbers. Each: what, holds or not, and the numbers.
local function findings(first, runs)
  local list = {}
  -- `cases`: the cases that the finding needs; the first run of Case I if there are no more. If one of them failed, the
  -- finding is undecided.
  local function find(what, cases, holds, numbers, clear)
    local stopped
    for case in cases:gmatch "%a+" do
      for _, r in ipairs(cases == "I" and { first.I } or runs[case]) do
        if r.verdict == "failed" then stopped = case end
      end
    end
    if stopped then holds = nil end
    list[#list + 1] = { finding = what, holds = holds, clear = clear, undecided = stopped and true or nil,
      numbers = numbers }
    local answer = stopped and ("undecided, a run of Case %s failed"):format(stopped)
      or holds and (clear == false and "holds on the mean, not for every pair of runs" or "holds") or "does not hold"
    print(("\n%d. %s: %s\n   %s"):format(#list, what, answer, numbers))
  end
  local function work(case) return spread(runs[case], "work", 1e6, "%.1f") end
  local function broken(case) return spread(runs[case], "broken", 1, "%d") end
  -- Damage is larger by both measures: plastic work and broken members of the building.
  local function damage(a, b)
    local by_work, work_clear = more(runs[a], runs[b], "work")
    local by_count, count_clear = more(runs[a], runs[b], "broken")
    return by_work and by_count, work_clear and count_clear
  end
  local function numbers(...)
    local parts = {}
    for i, case in ipairs { ... } do
      parts[i] = ("%s %s MJ, %s members"):format(case, work(case), broken(case))
    end
    return "plastic work, and broken members of the building: " .. table.concat(parts, "; ")
  end

  for _, other in ipairs { "II", "III" } do
    local holds, clear = damage("I", other)
    find(("Damage in I is larger than in %s"):format(other), "I " .. other, holds, numbers("I", other), clear)
  end
  local holds, clear = damage("II", "III")
  find("Damage in II is larger than in III, although II brings less kinetic energy", "II III", holds,
    numbers("II", "III") .. ("\n   II brings less of both: %.1f MJ and %.2f MN s, III %.1f MJ and %.2f MN s"):format(
      first.II.own_kinetic / 1e6, first.II.brought / 1e6, first.III.own_kinetic / 1e6, first.III.brought / 1e6), clear)
  find("Columns are cut: in I five inner ones or more, down to the sixth floor", "I",
    mean(runs.I, "broken_inner") >= 5 and first.I.lowest > 0 and first.I.lowest <= 6,
    ("fractured columns, inner and outer: I %s and %s; lowest storey %d"):format(
      spread(runs.I, "broken_inner", 1, "%d"), spread(runs.I, "broken_outer", 1, "%d"), first.I.lowest))
  holds, clear = more(runs.I, runs.IV, "broken_inner")
  find("At equal energy a smaller aircraft cuts fewer inner columns: IV fewer than I", "I IV", holds,
    ("fractured inner columns: I %s, IV %s"):format(spread(runs.I, "broken_inner", 1, "%d"),
      spread(runs.IV, "broken_inner", 1, "%d")), clear)
  holds, clear = more(runs.IV, runs.I, "missed")
  find("More members of the smaller aircraft pass without touching anything", "I IV", holds,
    ("members of 199 that touch nothing: I %s, IV %s"):format(spread(runs.I, "missed", 1, "%d"),
      spread(runs.IV, "missed", 1, "%d")), clear)
  local pulled = first.I.pulled
  find("Tension appears soon after the impact in columns that were compressed", "I",
    #pulled > 0 and pulled[1].first < 10e-3,
    #pulled > 0 and ("%d columns; the first %s ms after first contact, in storey %d")
      :format(#pulled, ms(pulled[1].first), pulled[1].storey) or "none")
  local function latest(times)
    local last = 0
    for _, t in ipairs(times) do last = t < 0 and math.huge or math.max(last, t) end
    return last
  end
  local faint, felt = latest(first.I.faint), latest(first.I.felt)
  find("The whole building feels the impact within milliseconds", "I", faint < 25e-3,
    ("f_y of some column has changed by 0.005 in every storey after %s ms, by 0.05 after %s ms")
      :format(ms(faint), ms(felt)))
  find("Hinges appear in columns down to the lowest storey", "I", first.I.red[1] >= 0,
    ("first in storey 1: %s ms after first contact"):format(ms(first.I.red[1])))
  return list
end

return hinge.scenario {
  parameters = impact.parameters {
    dt = 1e-5, duration = 0.25, watch = 5e-5,   -- s: the paper's; and how often the columns are looked at
    twin_dt = 1e-5, twins = 2,                  -- further runs of each case, the aircraft 1, 2, ... mm aside
    quick = false, half = 0,
  },

  run = function(p, job)
    if p.quick then p = impact.with(p, { dt = 4e-5, twin_dt = 4e-5, duration = 0.02, twins = 1 }) end
    local tasks = {}
    for twin = 0, p.twins do
      for _, case in ipairs(impact.order) do
        local aside = twin == 0 and {} or { dt = p.twin_dt, offset = p.offset + 1e-3 * twin }
        tasks[#tasks + 1] = { case = case, twin = twin, p = impact.with(impact.with(p, impact.cases[case]), aside) }
      end
    end
    local results = impact.side_by_side(job, p, tasks, function(task, at)
      return impact.simulate(task.p, task.twin == 0 and pictures(task.p, at, task.case))
    end)

    local first, runs, ended = {}, {}, {}
    for i, task in ipairs(tasks) do
      ended[#ended + 1] = paper.ended(results[i], ("Case %s, %s"):format(task.case,
        task.twin == 0 and "the paper's" or ("%g m aside"):format(task.p.offset)))
      runs[task.case] = runs[task.case] or {}
      table.insert(runs[task.case], results[i])
      if task.twin == 0 then first[task.case] = results[i] end
    end
    tables(first, runs)
    figure_17(first.I, job)
    local tension = figure_19(first.I, job)
    local found = findings(first, runs)
    paper.show_ended(job, ended, #tasks)
    local stopped = {} -- what the paper ran to its end
    for _, case in ipairs(impact.order) do
      local r = first[case]
      if r.verdict == "failed" then stopped[#stopped + 1] = ("Case %s: %s"):format(case, r.reason) end
    end
    job:verdict(#stopped == 0 and "completed" or "failed", table.concat(stopped, "; "))
    for _, r in pairs(first) do r.times, r.counts, r.below = nil, nil, nil end
    return { cases = first, tension = tension, findings = found, ended = ended, run_count = #tasks }
  end,
}
