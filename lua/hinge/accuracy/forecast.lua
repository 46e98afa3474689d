-- What runs will take, and what half of the error would cost.
local forecast = {}

-- Exponent of the time over a refinement: beyond it a time was measured badly. Explicit steps get shorter with the
-- elements, by up to the square of their length.
local most_growth, most_explicit = 1.3, 3

--- Seconds of a run at these levels, from the run with the nearest levels and how the time has grown so far.
function forecast.seconds(search, levels)
  local function growth(knob)
    local known = search.ladders:levels(knob)
    if #known < 2 then return 1 end
    local place = search.ladders:place(knob)
    local a = search.ladders:at(search.ladders.with(place, knob.name, known[1]))
    local b = search.ladders:at(search.ladders.with(place, knob.name, known[#known]))
    local most = search.problem.explicit and knob.name ~= "dt" and most_explicit or most_growth
    return math.min(most, math.max(0, math.log(b.seconds / a.seconds, 2) / (known[#known] - known[1])))
  end
  local best, nearest = nil, math.huge
  for _, family in pairs(search.ladders.records) do
    local record = family[0]
    local apart = 0
    for _, knob in ipairs(search.knobs) do
      apart = apart + math.abs((record and record.levels[knob.name] or math.huge) - levels[knob.name])
    end
    if record and not record.failed and apart < nearest then best, nearest = record, apart end
  end
  if not best then return 0 end
  local seconds = best.seconds
  for _, knob in ipairs(search.knobs) do
    seconds = seconds * 2 ^ (growth(knob) * (levels[knob.name] - best.levels[knob.name]))
  end
  return seconds
end

-- Levels at which settings on a line have half of the error: all of its knobs finer, by the order that it shows.
local function half_on_line(search, found, e)
  local line, levels = found.line, found.chosen
  for _, knob in ipairs(search.knobs) do
    if line[1][knob.name] ~= line[#line][knob.name] then
      local order = e.line.order and math.min(e.line.order, knob.theory) or 1
      levels = search.ladders.with(levels, knob.name, levels[knob.name] + math.ceil(1 / order - 1e-9))
    end
  end
  return levels
end

--- What half of the estimated error would cost: { error =, seconds = }. Knobs are refined by their orders until it is
-- met; the search costs as many times the chosen run as this one did. nil where an answer has no order to go by.
function forecast.half(search, found)
  local name, most = search.ladders.worst(found.errors)
  if not name or not found.reached or most < 1e-10 then return nil end
  local e, levels, parts = found.errors[name], found.chosen, {}
  if search.ladders.chaotic[name] then -- the band of a mean goes with the square root of the runs
    return { error = most / 2, seconds = 4 * found.seconds }
  end
  if found.line then
    local longer = forecast.seconds(search, half_on_line(search, found, e)) / found.own
    return { error = most / 2, seconds = math.max(1, longer) * found.seconds }
  end
  local rest = most
  for knob, part in pairs(e.parts) do parts[knob], rest = part, rest - part end
  for _ = 1, 12 do
    local sum, largest, at = math.max(0, rest), 0, nil
    for _, knob in ipairs(search.knobs) do
      sum = sum + parts[knob.name]
      if parts[knob.name] > largest then largest, at = parts[knob.name], knob end
    end
    if sum <= most / 2 or not at then break end
    local along = e.found[at.name]
    local factor = at.ratio ^ math.min(along.order or at.theory, at.theory)
    parts[at.name], rest = parts[at.name] / factor, rest / factor
    levels = search.ladders.with(levels, at.name, levels[at.name] + 1)
  end
  return { error = most / 2, seconds = math.max(1, forecast.seconds(search, levels) / found.own) * found.seconds }
end

return forecast
