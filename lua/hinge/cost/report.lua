-- The results of a comparison: printed tables, cost.csv and summary.json.
local core = require "hinge.core"
local check = require "hinge.library.check"
local print_table = require "hinge.library.columns".print
local jobs = require "hinge.program.job"
local compare = require "hinge.cost.compare"
local ladder = require "hinge.cost.ladder"
local headline = require "hinge.cost.headline"
local plot = require "hinge.cost.plot"
local text = require "hinge.cost.text"
local words = require "hinge.cost.words"

local report = {}
local percent, bytes, sorted = text.percent, text.bytes, text.sorted
local most_rows = 14 -- reasons shown; summary.json has them all
local most_chaotic = 4 -- answers with a table of means
local most_settings = 12 -- settings in a table; cost.csv has them all

local states = {
  chaotic = "is chaotic: it scatters by %s in runs whose physical numbers change by 1e-9, so it has no error",
  unsettled = "is not converged to what --within asks: the two finest runs differ by %s; ",
  moving = "differs from run to run of the same setting (%s): a measured time, or a random number; left out",
}
local bases = {
  order = "the order of convergence is clear, so the error is estimated from it (Richardson)",
  change = "no order of convergence is clear, so its error is the largest change, with a safety factor of 3",
  grows = "refinements change it in one direction by no less each time, so only a lower bound of its error is known",
  open = "only a lower bound of its error is known",
  exact = "",
}

-- Why answers have no error, or one that is larger than what was asked.
local function doubts(result)
  local lines = {}
  for _, name in ipairs(sorted(result.quantities)) do
    local q = result.quantities[name]
    if q.state == "unsettled" and q.agreement == math.huge then
      lines[#lines + 1] = name .. " is not finite, or is not there, in a reference"
    elseif states[q.state] then
      local size = q.state == "chaotic" and q.scatter or q.agreement
      lines[#lines + 1] = ("%s %s%s"):format(name, states[q.state]:format(percent(size)),
        q.state == "unsettled" and bases[q.by or "open"] or "")
    elseif q.state == "unknown" then
      lines[#lines + 1] = ("%s has no two references: %s"):format(name, bases[q.by or "open"])
    end
  end
  if #lines > most_rows then
    lines[most_rows] = ("and %d more, in summary.json"):format(#lines - most_rows + 1)
    for i = #lines, most_rows + 1, -1 do lines[i] = nil end
  end
  return lines
end

-- Numbers of the settings that tables show, in their order: all of them, or the Pareto front and then those with the
-- smallest errors.
local function shown(result)
  local function error_of(s) return s.error == s.error and s.error or math.huge end
  local order = {}
  for i in ipairs(result.settings) do order[i] = i end
  if #order > most_settings then
    table.sort(order, function(i, j)
      local a, b = result.settings[i], result.settings[j]
      if (a.front or false) ~= (b.front or false) then return a.front or false end
      if error_of(a) ~= error_of(b) then return error_of(a) < error_of(b) end
      return i < j
    end)
    for i = #order, most_settings + 1, -1 do order[i] = nil end
    table.sort(order)
  end
  return order
end

-- A table with as many columns as the terminal has room for, the first ones. `more`: what the others are called.
local function fitting_table(title, head, rows, more)
  local width, used, columns = core.width() or 120, 2, 0
  for i = 1, #head do
    local widest = #head[i]
    for _, row in ipairs(rows) do widest = math.max(widest, #tostring(row[i] or "")) end
    used = used + widest + (i > 1 and 2 or 0)
    if i > 1 and used > width then break end
    columns = i
  end
  local left_out = #head - columns
  for _, row in ipairs { head, table.unpack(rows) } do
    for i = #row, columns + 1, -1 do row[i] = nil end
  end
  if left_out > 0 then title = ("%s; %d more %s in cost.csv"):format(title, left_out, more) end
  print_table(title, head, rows)
end

local function settings_table(result)
  local head = { "" }
  for _, input in ipairs(result.inputs) do head[#head + 1] = input.name end
  local any = false
  for _, s in ipairs(result.settings) do any = any or s.error ~= nil end
  if any then table.move({ "error", "band", "worst in" }, 1, 3, #head + 1, head) end
  table.move({ "time", "s", "memory", "energy error" }, 1, 4, #head + 1, head)
  local rows = {}
  for _, i in ipairs(shown(result)) do
    local s = result.settings[i]
    local row = { ("%d%s"):format(i, s.front and " *" or "") }
    for _, input in ipairs(result.inputs) do row[#row + 1] = ladder.text(s.values[input.name]) end
    if any then table.move({ text.error(s), text.band(s), s.worst or "-" }, 1, 3, #row + 1, row) end
    table.move({ ("%.2f"):format(s.ratio), ("%.3g"):format(s.seconds), bytes(s.memory), percent(s.energy_error) },
      1, 4, #row + 1, row)
    rows[#rows + 1] = row
  end
  local fewest, most = math.huge, 0
  for _, s in ipairs(result.settings) do fewest, most = math.min(fewest, #s.times), math.max(most, #s.times) end
  local times = fewest == most and tostring(most) or ("%d to %d"):format(fewest, most)
  local left_out = #result.settings - #rows
  print_table(("%s, timed %s times alternately (time: median over the cheapest's; * on the Pareto front)%s")
    :format(check.count(#result.settings, "setting"), times,
      left_out > 0 and ("; the best %d, %d more in cost.csv"):format(#rows, left_out) or ""), head, rows)
end

-- The values of answers that are numbers, by setting.
local function values_table(result, names)
  local head, rows, numbers = { "setting" }, {}, {}
  for _, name in ipairs(names) do
    if result.quantities[name].kind == "number" then
      numbers[#numbers + 1] = name
      head[#head + 1] = name
    end
  end
  if #numbers == 0 then return end
  local function add(title, value_of, given)
    local row, any = { title }, not given
    for k, name in ipairs(numbers) do
      local value = value_of(name)
      row[k + 1] = value and text.number(value) or "-"
      any = any or value ~= nil
    end
    if any then rows[#rows + 1] = row end
  end
  for _, i in ipairs(shown(result)) do
    add(tostring(i), function(name) return tonumber(result.settings[i].answers[name]) end)
  end
  add("finest run", function(name) return result.quantities[name].value end)
  add("extrapolated", function(name) return result.quantities[name].extrapolated end, true)
  fitting_table(("Value of each answer by setting; finest run: %s"):format(result.finest), head, rows, "answers")
end

local bases_short = { order = "order %.2g", change = "changes", grows = "grows",
  open = "unknown", exact = "exact" }

local function answers_table(result)
  local largest = {}
  for name, q in pairs(result.quantities) do
    if q.by and q.state ~= "chaotic" then
      largest[name] = 0
      for _, s in ipairs(result.settings) do
        largest[name] = compare.larger(largest[name], s.errors[name] or math.huge)
      end
    end
  end
  local names = sorted(largest, function(a, b) return largest[a] > largest[b] or largest[a] == largest[b] and a < b end)
  if #names == 0 then return end
  local head, rows = { "setting" }, {}
  for k, name in ipairs(names) do
    head[k + 1] = name .. (result.quantities[name].kind == "history" and " (history)" or "")
  end
  for _, i in ipairs(shown(result)) do
    local row = { tostring(i) }
    for k, name in ipairs(names) do row[k + 1] = percent(result.settings[i].errors[name]) end
    rows[#rows + 1] = row
  end
  local apart, half, by = { "references" }, { "band +/-" }, { "from" }
  for k, name in ipairs(names) do
    local q = result.quantities[name]
    apart[k + 1] = percent(q.agreement)
    half[k + 1] = q.half == math.huge and "unknown" or percent(q.half)
    by[k + 1] = (bases_short[q.by] or "-"):format(q.order)
  end
  if result.references then rows[#rows + 1] = apart end
  table.move({ half, by }, 1, 2, #rows + 1, rows)
  fitting_table("Error of each answer by setting: its difference from the finest run; below, what that run itself "
    .. "leaves open", head, rows, "answers")
  values_table(result, names)
end

-- Means and scatter of chaotic answers, and the settings whose means cannot be told apart.
local function chaos_tables(result)
  local count = 0
  for _, name in ipairs(sorted(result.quantities)) do
    local q = result.quantities[name]
    if q.alike and (not result.quantity or result.quantity == name) then
      count = count + 1
      if count <= most_chaotic then
        local rows, alike = {}, {}
        for _, i in ipairs(shown(result)) do
          local m = (result.settings[i].means or {})[name]
          if m then
            local standard = result.settings[i].label == q.standard
            rows[#rows + 1] = { tostring(i), m.mean and text.number(m.mean) or "-", percent(m.scatter),
              tostring(m.runs), standard and "-" or percent(m.difference),
              standard and "the finest" or m.apart and "yes" or "no" }
            if not m.apart and not standard then alike[#alike + 1] = tostring(i) end
          end
        end
        print_table(("%s is chaotic: mean and scatter (standard deviation), physical numbers change by 1e-9")
          :format(name), { "setting", "mean", "scatter", "runs", "from the finest's mean", "told apart (95 %)" }, rows)
        print(#alike > 0 and ("  the mean of %s %s cannot be told apart from that of %s"):format(
          #alike == 1 and "setting" or "settings", words.list(alike), q.standard)
          or #rows > 1 and ("  no mean agrees with that of %s"):format(q.standard) or "")
      end
    end
  end
  if count > most_chaotic then print(("  %d more chaotic answers in cost.csv"):format(count - most_chaotic)) end
end

local function stages_of(settings)
  local all = {}
  for _, s in ipairs(settings) do
    for name, seconds in pairs(s.stages) do all[name] = math.max(all[name] or 0, seconds) end
  end
  return sorted(all, function(a, b) return all[a] > all[b] or all[a] == all[b] and a < b end)
end

local function stages_table(result)
  local names, head, rows = stages_of(result.settings), { "setting" }, {}
  if #names == 0 then return end
  table.move(names, 1, #names, 2, head)
  for _, i in ipairs(shown(result)) do
    local row = { tostring(i) }
    for k, name in ipairs(names) do row[k + 1] = ("%.2f"):format(1e3 * (result.settings[i].stages[name] or 0)) end
    rows[#rows + 1] = row
  end
  fitting_table("Time by stage, ms", head, rows, "stages")
end

local function orders_table(result)
  local rows = {}
  for _, name in ipairs(sorted(result.orders)) do
    local o = result.orders[name]
    local observed = o.observed == math.huge and "exact" or o.observed and ("%.2f"):format(o.observed) or "-"
    rows[#rows + 1] = { name, observed, o.theory and ("%g"):format(o.theory) or "-", o.note or o.why or "" }
  end
  if #rows > 0 then print_table("Order of convergence", { "", "observed", "theory", "" }, rows) end
end

-- The numbers and words of one setting, or of the two around it, without those of one input.
local function others(result, settings, but)
  local parts = {}
  for _, input in ipairs(result.inputs) do
    if input.name ~= but then
      local a, b = settings[1].values[input.name], settings[#settings].values[input.name]
      parts[#parts + 1] = a ~= nil
        and ("%s %s"):format(input.name, ladder.text(a) .. (a ~= b and " to " .. ladder.text(b) or "")) or nil
    end
  end
  return table.concat(parts, ", ")
end

local function equal_tables(result)
  for _, name in ipairs(sorted(result.equal)) do
    local head, rows = { name }, {}
    for i, row in ipairs(result.equal[name]) do
      head[2 * i], head[2 * i + 1] = "at " .. percent(row.error), ""
      for j, m in ipairs(row.methods) do
        rows[j] = rows[j] or { ladder.text(m.value) }
        rows[j][2 * i] = ("%s%.2f"):format(m.more and "> " or "", m.ratio)
        rows[j][2 * i + 1] = others(result, m.settings, name) .. (m.more and ": " .. percent(m.settings[1].error) or "")
      end
    end
    print_table("Time at equal error, over the shortest (a to b: on the straight line between two settings, "
      .. "on logarithmic axes; >: even the best one has a larger error)", head, rows)
  end
end

-- What the conclusion rests on, and for which answers it does not hold.
local function show_grounds(result)
  if result.references then
    local worst
    for _, q in pairs(result.quantities) do
      if q.state == "sound" then worst = compare.larger(worst or 0, q.agreement) end
    end
    local function name(r) return words.setting(result.inputs, r.values) end
    print(("reference: %s; a coarser one (%s) %s"):format(name(result.references[2]), name(result.references[1]),
      worst and "agrees with it to " .. percent(worst) or "agrees with it in no answer"))
  end
  for _, line in ipairs(doubts(result)) do print(line) end
  for _, note in ipairs(result.notes) do print("note: " .. note) end
  for _, lines in ipairs { headline.failures(result), headline.warnings(result), headline.left_out(result) } do
    for _, line in ipairs(lines) do print(line) end
  end
end

--- Prints it all: one conclusion, what it rests on, and the tables.
function report.show(result)
  for _, line in ipairs(headline.lines(result)) do print(line) end
  show_grounds(result)
  settings_table(result)
  answers_table(result)
  chaos_tables(result)
  stages_table(result)
  equal_tables(result)
  orders_table(result)
  print ""
end

-- The columns of each answer: { title, function of the setting }. difference: from the finest run.
local function answer_columns(result, names)
  local columns = {}
  local function add(title, f) columns[#columns + 1] = { title, f } end
  for _, name in ipairs(names) do
    local q = result.quantities[name]
    if q.kind == "number" then
      add("value of " .. name, function(s) return s.answers and tonumber(s.answers[name]) end)
    end
    if q.alike then
      for _, what in ipairs { "mean", "scatter", "runs" } do
        add(("%s of %s"):format(what, name), function(s) return s.means and s.means[name] and s.means[name][what] end)
      end
    elseif q.by then
      add("difference of " .. name, function(s) return s.errors and s.errors[name] end)
      for _, what in ipairs { "error", "low", "high" } do
        add(("%s of %s"):format(what, name),
          function(s) return s.estimates and s.estimates[name] and s.estimates[name][what] end)
      end
    end
  end
  return columns
end

local function csv(result)
  local names, stages, lines = sorted(result.quantities), stages_of(result.settings), {}
  local function add(cells) lines[#lines + 1] = text.csv_line(cells) end
  local head = {}
  for _, input in ipairs(result.inputs) do head[#head + 1] = input.name end
  local titles = "error low high worst seconds ratio timings outside_seconds memory_bytes energy_error front within "
    .. "failed"
  for title in titles:gmatch "%S+" do head[#head + 1] = title end
  for _, stage in ipairs(stages) do head[#head + 1] = "seconds of " .. stage end
  local columns = answer_columns(result, names)
  for _, column in ipairs(columns) do head[#head + 1] = column[1] end
  add(head)
  for _, list in ipairs { result.settings, result.failed } do
    for _, s in ipairs(list) do
      local row = {}
      for _, input in ipairs(result.inputs) do row[#row + 1] = ladder.text(s.values[input.name]) end
      for _, cell in ipairs { s.error or "", s.low or "", s.high or "", s.worst or "", s.seconds or "", s.ratio or "",
        s.times and #s.times or 0,
        s.outside or "", s.memory or "", s.energy_error or "", s.front or false, s.meets or false, s.failed or "" } do
        row[#row + 1] = cell
      end
      for _, stage in ipairs(stages) do row[#row + 1] = s.stages and s.stages[stage] or "" end
      for _, column in ipairs(columns) do row[#row + 1] = column[2](s) or "" end
      add(row)
    end
  end
  return table.concat(lines, "\n") .. "\n"
end

-- The same as result.equal, with labels instead of settings.
local function equal_summary(result)
  local all = {}
  for name, rows in pairs(result.equal) do
    all[name] = {}
    for i, row in ipairs(rows) do
      all[name][i] = { error = row.error, methods = {} }
      for j, m in ipairs(row.methods) do
        local labels = {}
        for k, s in ipairs(m.settings) do labels[k] = s.label end
        all[name][i].methods[j] = { value = m.value, seconds = m.seconds, ratio = m.ratio, more = m.more or false,
          settings = labels }
      end
    end
  end
  return all
end

--- Writes cost.csv, cost.png and summary.json into a folder.
function report.write(result, out)
  core.write_text(out .. "/cost.csv", csv(result))
  plot.draw(result, jobs.new(out, result.case))
  local summary = {}
  for name, value in pairs(result) do summary[name] = value end
  summary.inputs = nil
  summary.settings, summary.references, summary.front = {}, {}, {}
  summary.cheapest = result.cheapest and result.cheapest.label
  summary.equal = equal_summary(result)
  for i, s in ipairs(result.settings) do
    summary.settings[i] = {}
    for name, value in pairs(s) do
      if name ~= "answers" then summary.settings[i][name] = value end
    end
  end
  for i, r in ipairs(result.references or {}) do
    summary.references[i] = { label = r.label, values = r.values, seconds = r.seconds }
  end
  summary.finer, summary.words = nil, headline.lines(result)
  for i, s in ipairs(result.front) do summary.front[i] = s.label end
  summary.version = core.version
  core.write_json(out .. "/summary.json", summary)
end

return report
