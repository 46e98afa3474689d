-- What a study found, as a table and a picture made from its results.csv: for robustness.lua and aircraft.lua.
--
-- Run     hinge run scripts/studies/show.lua robustness=out/robustness-study
--         hinge run scripts/studies/show.lua aircraft=out/aircraft-study
-- Shows   how a script of one's own goes on from results.csv
-- Expect  robustness_map.png; aircraft_work.png and aircraft_hinged.png
local hinge = require "hinge"

-- The rows of a results.csv whose texts hold no comma, as tables by column; numbers where they are.
local function rows_of(folder)
  local rows, names = {}, nil
  for line in io.lines(folder .. "/results.csv") do
    local row, i = {}, 0
    for text in (line .. ","):gmatch "([^,]*)," do
      i = i + 1
      if names and names[i] then row[names[i]] = tonumber(text) or text ~= "" and text or nil
      elseif not names then row[i] = text end
    end
    if names then rows[#rows + 1] = row else names = row end
  end
  return rows
end

-- The three frames along x side by side, each column coloured by what follows when it is lost.
local function robustness(folder)
  local beams, found = { x = {}, y = {}, dashed = true }, {}
  for _, outcome in ipairs { "full collapse", "holds", "local collapse" } do
    found[#found + 1] = { name = outcome, x = {}, y = {} }
    found[outcome] = found[#found]
  end
  local function line(series, x, y, to_x, to_y)
    for k, value in ipairs { x, to_x, 0 / 0 } do -- not a number: a gap
      series.x[#series.x + 1], series.y[#series.y + 1] = value, ({ y, to_y, 0 / 0 })[k]
    end
  end
  for y = 1, 3 do
    for level = 1, 4 do line(beams, 5 * (y - 1) + 1, level, 5 * (y - 1) + 4, level) end
  end
  local count, factors = {}, {}
  for _, row in ipairs(rows_of(folder)) do
    local series = found[row.outcome]
    if series then
      for k = -4, 4 do -- a bar
        local x = 5 * (row.y - 1) + row.x + 0.02 * k
        line(series, x, row.storey - 0.95, x, row.storey - 0.05)
      end
      local key = row.storey .. row.outcome
      count[key] = (count[key] or 0) + 1
      if row.dynamic_factor then factors[#factors + 1] = row.dynamic_factor end
    end
  end
  print "storey   holds   local collapse   full collapse"
  for storey = 1, 4 do
    print(("%6d %7d %16d %15d"):format(storey, count[storey .. "holds"] or 0, count[storey .. "local collapse"] or 0,
      count[storey .. "full collapse"] or 0))
  end
  print(("where it holds, the dynamic drop is %.2f to %.2f times the static one")
    :format(math.min(table.unpack(factors)), math.max(table.unpack(factors))))
  for i = #found, 1, -1 do
    if #found[i].x == 0 then table.remove(found, i) end
  end
  hinge.plot({ title = "what follows when a column is lost", width = 1200, height = 460, y_label = "storey",
    x_label = "the frames y = 1 (left), 2 and 3; columns x = 1 to 4 in each", series = { beams, table.unpack(found) } },
    "robustness_map.png")
end

local function aircraft(folder)
  local all, speeds, sizes = {}, {}, {}
  for _, row in ipairs(rows_of(folder)) do
    if not speeds[row.speed] then speeds[#speeds + 1], speeds[row.speed] = row.speed, row end
    if not sizes[row.size] then sizes[#sizes + 1], sizes[row.size] = row.size, true end
    local key = row.speed .. " " .. row.size
    all[key] = all[key] or {}
    table.insert(all[key], row)
  end
  for _, what in ipairs { { "work_MJ", "plastic work in the building, MJ", "%.1f", "aircraft_work.png" },
    { "hinged", "members of the building with a plastic hinge", "%.0f", "aircraft_hinged.png" } } do
    local name, title, digits, file = table.unpack(what)
    print(title .. ": mean (least to most) of three offsets")
    local head = { "size m" }
    local series, points = {}, { name = "each case", x = {}, y = {}, style = "points" }
    for k, speed in ipairs(speeds) do
      head[k + 1] = ("%.0f m/s, %.0f t"):format(speed, speeds[speed].mass_t)
      series[k] = { name = head[k + 1], x = {}, y = {} }
    end
    print(("%6s" .. ("  %22s"):rep(#speeds)):format(table.unpack(head)))
    for _, size in ipairs(sizes) do
      local cells = {}
      for k, speed in ipairs(speeds) do
        local sum, least, most = 0, math.huge, -math.huge
        local cases = all[speed .. " " .. size]
        for _, row in ipairs(cases) do
          local value = row[name]
          sum, least, most = sum + value, math.min(least, value), math.max(most, value)
          points.x[#points.x + 1], points.y[#points.y + 1] = size, value
        end
        table.insert(series[k].x, size)
        table.insert(series[k].y, sum / #cases)
        cells[k] = (digits .. " (%s to %s)"):format(sum / #cases, digits:format(least), digits:format(most))
      end
      print(("%6.4g" .. ("  %22s"):rep(#cells)):format(size, table.unpack(cells)))
    end
    series[#series + 1] = points
    hinge.plot({ title = "equal kinetic energy, 112 MJ", x_label = "size of the aircraft, m", y_label = title,
      width = 1000, height = 640, series = series }, file)
  end
end

local settings = ... or {}
if settings.robustness then robustness(settings.robustness) end
if settings.aircraft then aircraft(settings.aircraft) end
