-- What accuracy costs in Case I: the whole impact (0.25 s) by several settings, each with slightly changed runs.
--
-- Run     hinge run -q scripts/accuracy_of_case1.lua          (all runs: half an hour of one core. Each is added
--                                                             to `data` when it is done; a second call goes on)
--         hinge run -q scripts/accuracy_of_case1.lua draw=1   (no run: table and picture of the data beside this file)
-- Shows   mean and scatter of columns cut, members of the building that break, plastic work, fracture energy, the part
--         of the aircraft's momentum that it has given away, the largest velocity of a floor (mean of its joints), the
--         members that break in all and in some of the runs, and processor time. Speed and mass of the aircraft differ
--         by 1e-9 from run to run
-- Expect  20 us, which is halved so often that it takes longer than 10 us; half of the time with explicit steps; three
--         times the plastic work with limits of hinge rotation in place of the paper's limits of curvature, 30 MJ for 8
local hinge  = require "hinge"
local impact = require "hinge.models.ten_storey_impact"
local statistics = require "hinge.accuracy.statistics"

local limits = { -- of fracture
  curvature = impact.designs.light.limits, -- the paper's: the rotation that breaks follows the elements' length
  rotation = { hinge_rotation_x = 0.08, hinge_rotation_y = 0.08, elongation = 0.3 }, -- rad, m: it does not
}

-- Settings: step in us, elements a member, limits, contact, interaction, integrator. Each varies one or two things of
-- the first one, which is the load case as it is. Costly ones have fewer runs.
local settings = {}
local function setting(dt, elements, limit, contact, interaction, integrator)
  settings[#settings + 1] = { dt = dt, elements = elements, limit = limit, contact = contact,
    interaction = interaction, integrator = integrator, few = elements > 2 or dt ~= 10 and dt ~= "auto" }
end
setting(10, 2, "curvature", "gap", "paper", "newmark")
setting(10, 2, "rotation", "gap", "paper", "newmark")
setting(10, 2, "rotation", "surface", "paper", "newmark")
setting(10, 2, "curvature", "surface", "paper", "newmark")
setting(10, 2, "curvature", "gap", "exact", "newmark")
setting("auto", 2, "curvature", "gap", "paper", "explicit")
setting("auto", 2, "rotation", "surface", "paper", "explicit")
for _, dt in ipairs { 20, 40, 80, 5 } do setting(dt, 2, "curvature", "gap", "paper", "newmark") end
setting(10, 4, "curvature", "gap", "paper", "newmark")
setting(10, 4, "rotation", "gap", "paper", "newmark")
setting(10, 4, "rotation", "surface", "paper", "newmark")
setting(10, 8, "curvature", "gap", "paper", "newmark")
setting(10, 8, "rotation", "surface", "paper", "newmark")

local inputs = { "dt", "elements", "limit", "contact", "interaction", "integrator" }
local outputs = { "run", "columns_cut", "broken", "plastic_MJ", "fracture_MJ", "momentum_given", "floor_m_per_s",
  "energy_error", "steps", "seconds", "members" }

local answers = { "seconds", "columns_cut", "broken", "plastic_MJ", "fracture_MJ", "momentum_given", "floor_m_per_s" }
local short = { columns_cut = "columns", broken = "members", plastic_MJ = "plastic", fracture_MJ = "fracture",
  momentum_given = "momentum", floor_m_per_s = "floor" }

-- Mean velocity along x of the joints of each floor; returns the largest.
local function fastest_floor(run, floors)
  local most = 0
  for _, joints in ipairs(floors) do
    local sum = 0
    for _, joint in ipairs(joints) do sum = sum + run:velocity(joint) end
    most = math.max(most, math.abs(sum) / #joints)
  end
  return most
end

local function floors_of(frame)
  local floors = {}
  for level = 1, 10 do
    floors[level] = {}
    for i = 0, 4 do
      for j = 0, 4 do table.insert(floors[level], frame.node(i, j, level)) end
    end
  end
  return floors
end

-- Numbers of the members of the building that are broken: "3 17 240".
local function broken_members(run)
  local list, numbers = {}, run:read("member", "building")
  for i, broken in ipairs(run:read("broken", "building")) do
    if broken == 1 then list[#list + 1] = ("%d"):format(numbers[i]) end
  end
  return table.concat(list, " ")
end

-- One run of a setting; number: 1 is the load case as it is, each further one changes it by another 1e-9.
local function simulate(s, number, p)
  local by = 1e-9 * (number - 1)
  local model = hinge.model { p_delta = "chord", interaction = s.interaction, weight = "nodes",
    elements_per_member = s.elements }
  local frame, plane = impact.add(model, { contact = s.contact, speed = 440 / 3.6 * (1 + by), mass = 15000 * (1 - by),
    fracture = function(m) m:fracture(limits[s.limit]) end })
  local loaded = model:static { fixed_group = plane }:finish()
  local floors, before = floors_of(frame), loaded:momentum(plane).mass * 440 / 3.6
  local explicit = s.integrator == "explicit"
  local begin = os.clock()
  local run = model:dynamic { from = loaded, dt = explicit and "auto" or s.dt * 1e-6, duration = p.duration,
    integrator = s.integrator, beta = not explicit and 0.4 or nil, record = false }
  local fastest, next_look = 0, 0
  for _ in run:steps() do
    if run.time >= next_look then
      fastest, next_look = math.max(fastest, fastest_floor(run, floors)), next_look + 5e-4
    end
  end
  return { seconds = os.clock() - begin, run = number, columns_cut = run:count { group = "columns", state = "broken" },
    broken = run:count { group = "building", state = "broken" }, plastic_MJ = run.energy.plastic / 1e6,
    fracture_MJ = run.energy.fracture / 1e6, momentum_given = 1 - run:momentum(plane).linear[1] / before,
    floor_m_per_s = fastest, energy_error = run.energy_error, steps = run.index, members = broken_members(run),
    verdict = run.verdict }
end

local function key_of(row)
  local parts = {}
  for i, name in ipairs(inputs) do parts[i] = tostring(row[name]) end
  return table.concat(parts, ",")
end

-- The runs that `data` holds, by setting and number.
local function read(path)
  local rows, file = {}, io.open(path)
  if not file then return rows end
  local names = {}
  for name in file:read("l"):gmatch "[^,]+" do names[#names + 1] = name end
  for line in file:lines() do
    local row, i = {}, 0
    for value in (line .. ","):gmatch "([^,]*)," do
      i = i + 1
      row[names[i]] = names[i] ~= "members" and math.tointeger(value) or tonumber(value) or value
    end
    rows[key_of(row) .. "," .. row.run] = row
  end
  file:close()
  return rows
end

local function append(path, s, row)
  local new, values = not io.open(path), {}
  local file = assert(io.open(path, "a"))
  if new then file:write(table.concat(inputs, ","), ",", table.concat(outputs, ","), "\n") end
  for i, name in ipairs(outputs) do
    values[i] = math.type(row[name]) == "float" and ("%.6g"):format(row[name]) or tostring(row[name])
  end
  file:write(key_of(s), ",", table.concat(values, ","), "\n")
  file:close()
end

-- Mean, deviation and number of runs of each answer of a setting; nil where there is no run yet.
local function means_of(s, rows, most)
  local values, runs, counts = {}, 0, {}
  for number = 1, most do
    local row = rows[key_of(s) .. "," .. number]
    if row then
      runs = runs + 1
      for _, name in ipairs(answers) do
        values[name] = values[name] or {}
        table.insert(values[name], row[name])
      end
      for member in tostring(row.members):gmatch "%d+" do counts[member] = (counts[member] or 0) + 1 end
    end
  end
  if runs == 0 then return nil end
  local result = { setting = s, runs = runs, in_all = 0, in_some = 0 }
  for name, list in pairs(values) do
    local mean, deviation = list[1], nil
    if runs > 1 then mean, deviation = statistics.mean(list) end
    result[name] = { mean = mean, deviation = deviation, runs = runs }
  end
  for _, count in pairs(counts) do
    local kind = count == runs and "in_all" or "in_some"
    result[kind] = result[kind] + 1
  end
  return result
end

local function name_of(s)
  return ("%s%s us, %d elements, %s, %s, %s, %s"):format(s.dt == "auto" and "" or s.dt, s.dt == "auto" and "auto" or "",
    s.elements, s.limit, s.contact, s.interaction, s.integrator):gsub("auto us", "auto")
end

-- Answers in which two settings differ by more than their scatter explains (Welch's test, 95 %).
local function differences(a, b)
  if a == b then return "-" end
  if a.runs < 3 or b.runs < 3 then return "?" end -- two runs may agree by chance
  local names = {}
  for i = 2, #answers do -- the first is the time
    if statistics.apart(a[answers[i]], b[answers[i]]) then names[#names + 1] = short[answers[i]] end
  end
  return #names > 0 and table.concat(names, ", ") or "nothing"
end

-- The problems that are computed: limits and contact, by colour and mark; what else differs stands beside a point.
local problems = {
  { name = "curvature, gap elements (paper)", limit = "curvature", contact = "gap", colour = "blue",
    mark = "circle" },
  { name = "curvature, surfaces", limit = "curvature", contact = "surface", colour = "purple",
    mark = "diamond" },
  { name = "hinge rotation, gap elements", limit = "rotation", contact = "gap", colour = "red",
    mark = "square" },
  { name = "hinge rotation, surfaces", limit = "rotation", contact = "surface", colour = "green",
    mark = "triangle" },
}

local function label_of(s)
  if s.integrator == "explicit" then return "explicit" end
  if s.interaction == "exact" then return "exact" end
  if s.elements > 2 then return s.elements .. " elements" end
  return s.limit == "curvature" and s.contact == "gap" and s.dt .. " us" or "" -- the others have 10 us
end

-- Mean and one standard deviation to both sides of an answer against time. Two lines a problem: through its steps, and
-- (dashed) through its numbers of elements at 10 us.
local function panel_of(found, name, label)
  local series = {}
  for _, problem in ipairs(problems) do
    local points = { name = problem.name, style = "points", colour = problem.colour, mark = problem.mark, x = {},
      y = {}, low = {}, high = {}, labels = {} }
    local steps, elements = {}, {}
    for _, m in ipairs(found) do
      local s, v = m.setting, m[name]
      if s.limit == problem.limit and s.contact == problem.contact then
        local i, half = #points.x + 1, v.deviation or 0
        points.x[i], points.y[i], points.labels[i] = m.seconds.mean, v.mean, label_of(s)
        points.low[i], points.high[i] = v.mean - half, v.mean + half
        local usual = s.integrator == "newmark" and s.interaction == "paper"
        if usual and s.elements == 2 then steps[#steps + 1] = { s.dt, i } end
        if usual and s.dt == 10 then elements[#elements + 1] = { s.elements, i } end
      end
    end
    for k, list in ipairs { steps, elements } do
      table.sort(list, function(a, b) return a[1] < b[1] end)
      local line = { colour = problem.colour, dashed = k == 2, x = {}, y = {} }
      for n, item in ipairs(list) do line.x[n], line.y[n] = points.x[item[2]], points.y[item[2]] end
      if #list > 1 then series[#series + 1] = line end
    end
    series[#series + 1] = points
  end
  return { y_label = label, x_label = "processor time of a run, s", log_x = true, series = series }
end

local function draw(found, job)
  local panels = { panel_of(found, "columns_cut", "columns cut"), panel_of(found, "plastic_MJ", "plastic work, MJ") }
  local most = 0
  for _, m in ipairs(found) do most = math.max(most, m.columns_cut.mean + (m.columns_cut.deviation or 0)) end
  panels[1].y_range, panels[2].log_y = { 0, 1.7 * most }, true -- room for the legend above
  for _, s in ipairs(panels[2].series) do s.name = nil end -- the legend is in the other panel
  job:plot({ width = 1200, height = 1150, panels = panels, share_x = true }, "accuracy_of_case1.png")
end

local function show(found, base)
  print(("%-52s %4s %9s %12s %11s %11s %11s %11s %11s %9s  %s"):format("setting", "runs", "time, s", "columns cut",
    "broken", "plastic, MJ", "fract., MJ", "given, %", "floor, m/s", "all, some", "differs from the first in"))
  for _, m in ipairs(found) do
    local cells = {}
    for i, name in ipairs(answers) do
      local v, unit = m[name], name == "momentum_given" and 100 or 1
      cells[i] = i == 1 and ("%.1f"):format(v.mean) or ("%.3g +- %s"):format(unit * v.mean,
        v.deviation and ("%.2g"):format(unit * v.deviation) or "?")
    end
    print(("%-52s %4d %9s %12s %11s %11s %11s %11s %11s %9s  %s"):format(name_of(m.setting), m.runs, cells[1], cells[2],
      cells[3], cells[4], cells[5], cells[6], cells[7], ("%d, %d"):format(m.in_all, m.in_some), differences(m, base)))
  end
end

-- All runs. Those of cheap settings come early, so that much is known if they are interrupted.
local function tasks_of(p)
  local tasks = {}
  for place, s in ipairs(settings) do
    local seconds = s.integrator == "explicit" and 6 or s.dt == 10 and 15 or 28
    for number = 1, s.few and p.few or p.runs do
      tasks[#tasks + 1] = { setting = s, number = number, place = place, weight = number * seconds * s.elements ^ 1.2 }
    end
  end
  table.sort(tasks, function(a, b)
    if a.weight ~= b.weight then return a.weight < b.weight end
    return a.place < b.place
  end)
  return tasks
end

return hinge.scenario {
  parameters = { data = "scripts/accuracy_of_case1.csv", runs = 8, few = 3, duration = 0.25, -- s
    draw = 0 }, -- 1: no run, only the table and the picture
  run = function(p, job)
    local rows = read(p.data)
    for _, task in ipairs(p.draw == 0 and tasks_of(p) or {}) do
      local s, number = task.setting, task.number
      if not rows[key_of(s) .. "," .. number] then
        local row = simulate(s, number, p)
        if row.verdict ~= "completed" then print(key_of(s), row.verdict) end
        append(p.data, s, row)
        rows[key_of(s) .. "," .. number] = row
      end
    end
    local found = {}
    for _, s in ipairs(settings) do found[#found + 1] = means_of(s, rows, p.runs) end
    show(found, found[1])
    draw(found, job)
  end,
}
