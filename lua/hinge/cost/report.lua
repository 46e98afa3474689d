-- What came out of a comparison: tables for the reader, cost.csv, summary.json and the work-precision plot.
local core = require "hinge.core"
local jobs = require "hinge.job"
local ladder = require "hinge.cost.ladder"
local paper = require "hinge.paper"

local report = {}
local most_rows = 14 -- answers shown; cost.csv has them all
local exact = 1e-16  -- where an error of nothing is drawn

local function percent(part)
  if part == nil then return "-" end
  if part == math.huge then return "none" end
  if part < 1e-12 then return "0 %" end
  return ("%.3g %%"):format(100 * part)
end

local function bytes(n) return n and ("%.1f MB"):format(n / 1e6) or "-" end

local function sorted(map, before)
  local names = {}
  for name in pairs(map) do names[#names + 1] = name end
  table.sort(names, before)
  return names
end

local states = {
  chaotic = "chaotic: it scatters by %s when every number changes by %g of itself, so it has no error",
  unsettled = "not settled: two references, each finer than all settings, differ by %s; give finer settings, or a greater --within",
  moving = "differs from run to run of the same setting (%s): a time, or chance; left out",
}

-- What keeps answers from having an error, in their own words; those that share words stand together.
local function doubts(result)
  local lines = {}
  for _, name in ipairs(sorted(result.quantities)) do
    local q = result.quantities[name]
    if states[q.state] then
      local size = q.state == "chaotic" and q.scatter or q.agreement
      lines[#lines + 1] = ("%s %s"):format(name, states[q.state]:format(percent(size), result.perturbation))
    end
  end
  if #lines > most_rows then
    lines[most_rows] = ("and %d more, in summary.json"):format(#lines - most_rows + 1)
    for i = #lines, most_rows + 1, -1 do lines[i] = nil end
  end
  return lines
end

local function settings_table(result)
  local head = { "" }
  for _, knob in ipairs(result.knobs) do head[#head + 1] = knob.name end
  for _, title in ipairs { "error", "worst in", "time", "s", "memory", "remainder" } do head[#head + 1] = title end
  local rows = {}
  for i, s in ipairs(result.settings) do
    local row = { ("%d%s"):format(i, s.front and " *" or "") }
    for _, knob in ipairs(result.knobs) do row[#row + 1] = ladder.text(s.values[knob.name]) end
    table.move({ (s.below and s.error > 1e-12 and "< " or "") .. percent(s.error), s.worst or "-", ("%.2f"):format(s.ratio), ("%.3g"):format(s.seconds), bytes(s.memory),
      percent(s.remainder) }, 1, 6, #row + 1, row)
    rows[i] = row
  end
  local fewest, most = math.huge, 0
  for _, s in ipairs(result.settings) do fewest, most = math.min(fewest, #s.times), math.max(most, #s.times) end
  paper.table(("%d settings, timed %s times by turns (time: median over that of the cheapest; * on the Pareto front)")
    :format(#result.settings, fewest == most and tostring(most) or ("%d to %d"):format(fewest, most)), head, rows)
end

local function answers_table(result)
  local largest = {}
  for name, q in pairs(result.quantities) do
    if q.state == "sound" then
      largest[name] = 0
      for _, s in ipairs(result.settings) do largest[name] = math.max(largest[name], s.errors[name]) end
    end
  end
  local names = sorted(largest, function(a, b) return largest[a] > largest[b] or largest[a] == largest[b] and a < b end)
  if #names == 0 then return end
  local head, rows = { "answer" }, {}
  for i in ipairs(result.settings) do head[i + 1] = tostring(i) end
  for i = 1, math.min(#names, most_rows) do
    local row = { names[i] .. (result.quantities[names[i]].kind == "history" and " (history)" or "") }
    for _, s in ipairs(result.settings) do row[#row + 1] = percent(s.errors[names[i]]) end
    row[#row + 1] = percent(result.quantities[names[i]].agreement)
    rows[i] = row
  end
  head[#head + 1] = "references"
  paper.table("Error of each answer by setting, and by how much the references differ" .. (#names > most_rows and ("; %d more in cost.csv"):format(#names - most_rows) or ""),
    head, rows)
end

local function stages_of(settings)
  local all = {}
  for _, s in ipairs(settings) do
    for name, seconds in pairs(s.stages) do all[name] = math.max(all[name] or 0, seconds) end
  end
  return sorted(all, function(a, b) return all[a] > all[b] or all[a] == all[b] and a < b end)
end

local function stages_table(result)
  local head, rows = { "stage" }, {}
  for i in ipairs(result.settings) do head[i + 1] = tostring(i) end
  for i, name in ipairs(stages_of(result.settings)) do
    rows[i] = { name }
    for _, s in ipairs(result.settings) do table.insert(rows[i], ("%.2f"):format(1e3 * (s.stages[name] or 0))) end
  end
  if #rows > 0 then paper.table("Time by stage, ms", head, rows) end
end

local function orders_table(result)
  local rows = {}
  for _, name in ipairs(sorted(result.orders)) do
    local o = result.orders[name]
    local observed = o.observed == math.huge and "exact" or o.observed and ("%.2f"):format(o.observed) or "-"
    rows[#rows + 1] = { name, observed, o.theory and ("%g"):format(o.theory) or "-", o.note or o.why or "" }
  end
  if #rows > 0 then paper.table("Order of convergence", { "", "observed", "theory", "" }, rows) end
end

--- Prints it all.
function report.show(result)
  settings_table(result)
  answers_table(result)
  stages_table(result)
  orders_table(result)
  print ""
  if result.references then
    local worst
    for _, q in pairs(result.quantities) do
      if q.state == "sound" then worst = math.max(worst or 0, q.agreement) end
    end
    print(("reference: %s; a coarser one (%s) %s"):format(result.references[2].label, result.references[1].label,
      worst and "agrees with it to " .. percent(worst) or "agrees with it on nothing"))
  end
  for _, line in ipairs(doubts(result)) do print(line) end
  for _, note in ipairs(result.notes) do print("note: " .. note) end
  for _, s in ipairs(result.failed) do print(("no answer: %s: %s"):format(s.label, s.failed)) end
  local out = result.left_out[1]
  if out then
    print(("left out by the budget: %d settings, such as %s, about %.2g s and %.2g s for its reference"):format(#result.left_out, out.label, out.estimate, out.rest))
  end
  local judged, all = 0, 0
  for _, q in pairs(result.quantities) do judged, all = judged + (q.state == "sound" and 1 or 0), all + 1 end
  local by = result.quantity or ("%d of %d answers"):format(judged, all)
  if result.cheapest then
    print(("cheapest within %s (judged by %s): %s, %s, %.3g s"):format(percent(result.within), by, result.cheapest.label, percent(result.cheapest.error),
      result.cheapest.seconds))
  else
    print(("no setting is known to be within %s"):format(percent(result.within)))
  end
end

local function quoted(text) return text:find '[,"\n]' and '"' .. text:gsub('"', '""'):gsub("\n", " ") .. '"' or text end

local function csv(result)
  local names, stages, lines = sorted(result.quantities), stages_of(result.settings), {}
  local function add(cells)
    for i, cell in ipairs(cells) do cells[i] = quoted(tostring(cell)) end
    lines[#lines + 1] = table.concat(cells, ",")
  end
  local head = {}
  for _, knob in ipairs(result.knobs) do head[#head + 1] = knob.name end
  for title in ("error worst seconds ratio timings outside_seconds memory_bytes remainder front within failed"):gmatch "%S+" do head[#head + 1] = title end
  for _, stage in ipairs(stages) do head[#head + 1] = "seconds of " .. stage end
  for _, name in ipairs(names) do head[#head + 1] = "error of " .. name end
  add(head)
  for _, list in ipairs { result.settings, result.failed } do
    for _, s in ipairs(list) do
      local row = {}
      for _, knob in ipairs(result.knobs) do row[#row + 1] = ladder.text(s.values[knob.name]) end
      for _, cell in ipairs { s.error or "", s.worst or "", s.seconds or "", s.ratio or "", s.times and #s.times or 0, s.outside or "", s.memory or "", s.remainder or "",
        s.front or false, s.meets or false, s.failed or "" } do row[#row + 1] = cell end
      for _, stage in ipairs(stages) do row[#row + 1] = s.stages and s.stages[stage] or "" end
      for _, name in ipairs(names) do row[#row + 1] = s.errors and s.errors[name] or "" end
      add(row)
    end
  end
  return table.concat(lines, "\n") .. "\n"
end

-- The number along which a line of the plot goes: the one with the most values, dt before others.
local function line_knob(knobs)
  local best
  for _, knob in ipairs(knobs) do
    if knob.side and (not best or #knob.values > #best.values or #knob.values == #best.values and knob.name == "dt") then best = knob end
  end
  return best
end

local function plot(result, job)
  local along, methods, names = line_knob(result.knobs), {}, {}
  for _, s in ipairs(result.settings) do
    if s.error then
      local parts = {}
      for _, knob in ipairs(result.knobs) do
        if knob ~= along then parts[#parts + 1] = (type(s.values[knob.name]) == "number" and knob.name .. " " or "") .. ladder.text(s.values[knob.name]) end
      end
      local name = #parts > 0 and table.concat(parts, ", ") or along.name
      if not methods[name] then methods[name], names[#names + 1] = {}, name end
      table.insert(methods[name], s)
    end
  end
  if #names == 0 then return end
  table.sort(names)
  local series, front = {}, { name = "Pareto front", style = "points", x = {}, y = {} }
  for _, name in ipairs(names) do
    local line = { name = name, x = {}, y = {}, style = #methods[name] == 1 and "points" or "line" }
    if along then table.sort(methods[name], function(a, b) return ladder.finer(along, b.values[along.name], a.values[along.name]) > 1 end) end
    for i, s in ipairs(methods[name]) do line.x[i], line.y[i] = s.seconds, 100 * math.max(s.error, exact) end
    series[#series + 1] = line
  end
  for i, s in ipairs(result.front) do front.x[i], front.y[i] = s.seconds, 100 * math.max(s.error, exact) end
  series[#series + 1] = front
  job:plot({ title = "Error against time" .. (result.quantity and ", " .. result.quantity or ""), x_label = "time of the steps, s", y_label = "error, %", log_x = true,
    log_y = true, series = series, width = 1500, height = 950 }, "cost.png")
end

--- Writes cost.csv, cost.png and summary.json into a folder.
function report.write(result, out)
  core.write_text(out .. "/cost.csv", csv(result))
  plot(result, jobs.new(out, result.case))
  local summary = {}
  for name, value in pairs(result) do summary[name] = value end
  summary.knobs, summary.settings, summary.references, summary.front, summary.cheapest = nil, {}, {}, {}, result.cheapest and result.cheapest.label
  for i, s in ipairs(result.settings) do
    summary.settings[i] = {}
    for name, value in pairs(s) do
      if name ~= "answers" then summary.settings[i][name] = value end
    end
  end
  for i, r in ipairs(result.references or {}) do summary.references[i] = { label = r.label, values = r.values, seconds = r.seconds } end
  for i, s in ipairs(result.front) do summary.front[i] = s.label end
  summary.version = core.version
  core.write_json(out .. "/summary.json", summary)
end

return report
