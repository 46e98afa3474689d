-- The result of hinge run --within in words, and in summary.json.
local broken = require "hinge.accuracy.broken"
local check = require "hinge.library.check"
local text = require "hinge.cost.text"
local words = require "hinge.cost.words"

local report = {}

-- A part as a percentage of two digits, rounded up so that it stays a bound; more than the answer itself is not known.
local function percent(part)
  if not (part <= 1) then return "unknown" end
  if part < 1e-10 then return "0 %" end
  local unit = 10.0 ^ (math.floor(math.log(100 * part, 10)) - 1)
  return ("%.3g %%"):format(math.ceil(100 * part / unit - 1e-9) * unit)
end
local function time(seconds) return words.seconds(seconds, 2) end
local function number(value) return ("%.4g"):format(value) end

-- An error of an answer, a part of `size`, in words: in its own unit where the answer is smaller than the size that
-- errors are parts of (`least`).
local function error_text(part, size, least)
  if least and size <= least and part < math.huge then return ("%.2g"):format(part * size) end
  return percent(part)
end

-- "order 1.98 in dt", "0.4 % by changes in elements". what: the knob, or several.
local function basis_of(what, found, error)
  if found.by == "order" then return ("order %.2g in %s"):format(found.order, what) end
  if found.by == "exact" then return "no change in " .. what end
  if found.by == "scatter" then return ("no change in %s beyond the scatter"):format(what) end
  if found.by == "change" then return ("%s by changes in %s"):format(error, what) end
  if found.by == "grows" then return ("changes in %s grow"):format(what) end
  return what .. " has one value"
end

-- The knobs in which the settings of a line differ, in words.
local function knobs_of_line(all, line)
  local names = {}
  for _, knob in ipairs(all) do
    if line[1][knob.name] ~= line[#line][knob.name] then names[#names + 1] = knob.name end
  end
  return table.concat(names, " and ") .. (#names > 1 and " together" or "")
end

--- What the error of an answer rests on; line: the settings on it, or nil; size and least: see error_text.
local function basis(all, e, line, size, least)
  local parts = {}
  local function told(part) return error_text(part, size, least) end
  if e.mean ~= nil then
    parts[1] = ("%d runs, mean %s, scatter %s"):format(e.runs,
      type(e.mean) == "number" and number(e.mean) or "of a history", number(e.deviation))
  end
  if e.line then parts[#parts + 1] = basis_of(knobs_of_line(all, line), e.line, told(e.line_part)) end
  for _, knob in ipairs(e.line and {} or all) do
    local found = e.found[knob.name]
    if found then parts[#parts + 1] = basis_of(knob.name, found, told(e.parts[knob.name])) end
  end
  if e.shown then parts[#parts + 1] = ("check %s"):format(told(e.shown)) end
  return table.concat(parts, "; ")
end

--- Answers as they are told: { { name =, value =, error = part of size, size =, least = the smallest size, given = that
--- of the user, basis =, chaotic = }, ... } by name.
function report.answers(all, found, search)
  local list = {}
  for _, name in ipairs(check.keys(found.errors)) do
    local e = found.errors[name]
    local value = search.ladders:answer(found.chosen, name)
    local size, least = search.ladders:size(name, { e.mean or value }), search.ladders:smallest_of(name)
    list[#list + 1] = { name = name, value = type(value) == "number" and value or nil, error = e.total,
      size = size, least = least, given = search.ladders.least[name],
      chaotic = search.ladders.chaotic[name] or false, basis = basis(all, e, found.line, size, least),
      mean = type(e.mean) == "number" and e.mean or nil, scatter = e.deviation, runs = e.runs, band = e.band,
      parts = e.parts }
  end
  return list
end

--- "asked 2 %, estimated 1.3 %, cost 4.1 s; 0.65 % would cost about 12 s".
function report.line(told)
  local line = ("asked %s, estimated %s, cost %s"):format(text.percent(told.asked), percent(told.estimated),
    time(told.elapsed))
  if told.half then
    line = line .. ("; %s would cost about %s"):format(percent(told.half.error), time(told.half.seconds))
  end
  return line
end

-- Names of the answers whose error is not accepted, and of all, as --answers takes them.
local function names_of(told)
  local missed, all = {}, {}
  for _, a in ipairs(told.answers) do
    local is_missed = not (a.error <= told.asked)
    if is_missed then missed[#missed + 1] = a.name end
    local whole = math.type(a.value) == "integer" and 1 -- of what is counted
    local matters = a.given and a.given * told.asked or is_missed and (whole or "DIFFERENCE")
    if type(matters) == "number" then matters = ("%g"):format(matters) end
    all[#all + 1] = a.name .. (matters and ":" .. matters or "")
  end
  return missed, all
end

-- What is not reached, and by which answers.
local function not_reached(told)
  local missed = names_of(told)
  return ("%s is not reached for %s: with %s %s error is estimated at %s (%s)"):format(text.percent(told.asked),
    #missed == #told.answers and #missed > 1 and "any answer" or table.concat(missed, ", "), told.setting,
    #missed > 1 and "the largest" or "its", percent(told.estimated), told.why)
end

--- "within 2 %: dt 1 ms, 4 elements a member (1.3 s)".
local function conclusion(told)
  if told.reached then
    return ("within %s: %s (%s)"):format(text.percent(told.asked), told.setting, time(told.own))
  end
  return not_reached(told)
end

--- What the search took.
local function effort(told)
  return ("%d runs, %.2g times the chosen one%s"):format(told.runs, told.seconds / told.own,
    told.checked and "; checked with " .. told.checked or "")
end

--- All lines that are printed.
function report.lines(told)
  local lines = { conclusion(told) }
  local widest, rows = 0, {}
  for i, a in ipairs(told.answers) do
    rows[i] = { a.name .. (a.chaotic and " (chaotic)" or ""), a.chaotic and a.mean and number(a.mean)
      or a.value and number(a.value) or "history", "+- " .. error_text(a.error, a.size, a.least), a.basis }
    widest = math.max(widest, #rows[i][1])
  end
  for _, row in ipairs(rows) do
    lines[#lines + 1] = ("  %-" .. widest .. "s  %10s  %-10s  %s"):format(table.unpack(row))
  end
  for _, line in ipairs(broken.lines(told.broken)) do lines[#lines + 1] = line end
  for _, note in ipairs(told.notes) do lines[#lines + 1] = "note: " .. note end
  for _, warning in ipairs(told.warnings) do lines[#lines + 1] = "warning: " .. warning end
  local missed, all = names_of(told)
  if #missed > 0 and #all > 1 then
    lines[#lines + 1] = "to leave an answer out, or to say which difference does not matter: --answers "
      .. table.concat(all, ",")
  end
  lines[#lines + 1] = report.line(told) .. "; " .. effort(told)
  return lines
end

--- For summary.json.
function report.summary(told)
  local answers, search = {}, told.search
  for _, a in ipairs(told.answers) do
    answers[a.name] = { value = a.value, error = a.error < math.huge and a.error or nil,
      error_text = error_text(a.error, a.size, a.least), basis = a.basis, chaotic = a.chaotic, mean = a.mean,
      scatter = a.scatter, runs = a.runs, band = a.band }
  end
  return { asked = told.asked, estimated = told.estimated < math.huge and told.estimated or nil, reached = told.reached,
    setting = told.setting, values = told.values, checked = told.checked, answers = answers, seconds = told.seconds,
    runs = told.runs, own_seconds = told.own, half = told.half, conclusion = conclusion(told), line = report.line(told),
    effort = effort(told), notes = told.notes, broken = broken.summary(told.broken, search.ladders:at(told.levels, 1)
      and "with stiffness and strength changed by 1e-9" or "of different settings") }
end

return report
