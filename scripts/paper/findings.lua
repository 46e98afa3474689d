-- Which findings of the paper's section 4 hold, and for which frames and aircraft? From the study lost_inputs.lua.
--
-- Run     hinge run scripts/paper/findings.lua           (the cases in lost_inputs.csv, three studies)
--         hinge run scripts/paper/findings.lua study=out/lost_inputs-study,out/light    (studies of your own)
-- Shows   each finding: in how many frames it holds, by rule of contact and limit of curvature; the frames where all
--         hold but one; where Case II does more damage than Case III; the frame in the middle of the region
-- Expect  the tables of README.md in this folder; one picture a finding, over the two inputs that it depends on most;
--         points.csv, the numbers that all this needs, as lost_inputs.csv has them; region.csv, the inputs of the
--         frames where all hold but one. hinge study scripts/paper/lost_inputs.lua newmark=true --table FILE runs those
--         again by Newmark's method
--
-- Damage is the plastic work in the building, and the number of its members that break. A finding that compares two
-- cases holds if the means of their three runs do, in both measures. It is clear if no run of one reaches the other's.
local core   = require "hinge.core"
local fit    = require "hinge.study.fit"
local hinge  = require "hinge"
local paper  = require "hinge.paper"
local values = require "hinge.library.values"

local folder = debug.getinfo(1, "S").source:match "^@(.*/)" or ""
local cases = { "I", "II", "III", "IV" }
local inputs = { "bay", "storey", "floor", "beams", "yield_stress", "column", "metal", "plane_wall", "plane_yield",
  "body", "sweep", "height", "offset" }
local choices = { "contact", "reading", "kappa" }

-- Reading -------------------------------------------------------------------------------------------------------------

-- The rows of a file of comma-separated values, by the names in its first line.
local function rows_of(file)
  local rows, names = {}, nil
  for line in io.lines(file) do
    local fields, row = values.csv_fields(line), {}
    for i, name in ipairs(names or {}) do
      local text = fields[i] or ""
      row[name] = tonumber(text) or text == "true" or text ~= "false" and text ~= "" and text
    end
    if names then rows[#rows + 1] = row else names = fields end
  end
  return rows
end

-- Columns that the findings need.
local function columns()
  local list = { "study", "number", "allowed", "f_y", "tension" }
  table.move(inputs, 1, #inputs, #list + 1, list)
  table.move(choices, 1, #choices, #list + 1, list)
  for _, case in ipairs(cases) do
    for _, name in ipairs { "inner", "inner_least", "inner_most", "outer", "beams", "work", "work_least", "work_most",
      "lowest", "missed", "ground", "failed", "moving" } do
      list[#list + 1] = case .. "." .. name
    end
  end
  return list
end

-- Writes these columns of the rows; `form`: how numbers are written.
local function write(rows, names, form, file)
  local lines = { table.concat(names, ",") }
  for _, row in ipairs(rows) do
    local items = {}
    for i, name in ipairs(names) do
      local value = row[name]
      items[i] = type(value) == "number" and form:format(value) or value and tostring(value) or ""
    end
    lines[#lines + 1] = table.concat(items, ",")
  end
  core.write_text(file, table.concat(lines, "\n") .. "\n")
end

-- Findings ------------------------------------------------------------------------------------------------------------

local function broken(r, case) return r[case .. ".inner"] + r[case .. ".outer"] + r[case .. ".beams"] end
local function more(r, a, b) return r[a .. ".work"] > r[b .. ".work"] and broken(r, a) > broken(r, b) end
local function clearly(r, a, b) return r[a .. ".work_least"] > r[b .. ".work_most"] end

local findings = {
  { name = "most_cut", text = "I cuts five inner columns or more (a storey has nine)", holds = function(r)
    return r["I.inner"] >= 5
  end },
  { name = "sixth", text = "damage in I reaches the sixth storey", holds = function(r)
    return r["I.lowest"] > 0 and r["I.lowest"] < 6.5
  end },
  { name = "I_over_II", text = "I does more damage than II", holds = function(r) return more(r, "I", "II") end },
  { name = "I_over_III", text = "I does more damage than III", holds = function(r) return more(r, "I", "III") end },
  { name = "IV_cuts_fewer", text = "IV cuts fewer inner columns than I", holds = function(r)
    return r["IV.inner"] < r["I.inner"]
  end },
  { name = "IV_passes", text = "more members of IV than of I touch nothing", holds = function(r)
    return r["IV.missed"] > r["I.missed"]
  end },
  { name = "tension", text = "tension in I within 3 ms", holds = function(r)
    return r.tension >= 0 and r.tension < 3e-3
  end },
  { name = "lowest_plastic", text = "the lowest storey becomes plastic in I", holds = function(r)
    return r["I.ground"] > 0
  end },
  { name = "II_over_III", alone = true, text = "II does more damage than III", holds = function(r)
    return more(r, "II", "III")
  end },
}

local function all_but_last(r)
  for _, f in ipairs(findings) do
    if not f.alone and not f.holds(r) then return false end
  end
  return true
end

local function count(rows, holds)
  local n = 0
  for _, r in ipairs(rows) do n = n + (holds(r) and 1 or 0) end
  return n
end

local function only(rows, name, value)
  local list = {}
  for _, r in ipairs(rows) do if r[name] == value then list[#list + 1] = r end end
  return list
end

local function values_of(rows, name)
  local seen, list = {}, {}
  for _, r in ipairs(rows) do
    if not seen[r[name]] then
      seen[r[name]] = true
      list[#list + 1] = r[name]
    end
  end
  table.sort(list)
  return list
end

local function share(rows, holds)
  return #rows > 0 and ("%d of %d"):format(count(rows, holds), #rows) or "-"
end

local function show_findings(rows)
  local head, parts, list = { "finding", "all" }, { rows }, {}
  for _, name in ipairs(choices) do
    for _, value in ipairs(values_of(rows, name)) do
      head[#head + 1] = tostring(value)
      parts[#parts + 1] = only(rows, name, value)
    end
  end
  local lines = {}
  local function line(text, holds)
    local cells = { text }
    for _, part in ipairs(parts) do cells[#cells + 1] = share(part, holds) end
    lines[#lines + 1] = cells
  end
  for _, f in ipairs(findings) do
    line(f.text, f.holds)
    list[f.name] = count(rows, f.holds)
  end
  line("all but the last one", all_but_last)
  line("the last one, clear by plastic work", function(r) return clearly(r, "II", "III") end)
  list.all_but_last = count(rows, all_but_last)
  list.II_over_III_clear = count(rows, function(r) return clearly(r, "II", "III") end)
  paper.table("Frames where a finding holds; all, by rule of contact, reading of eq 16, limit of curvature in 1/m",
    head, lines)
  return list
end

-- Where ---------------------------------------------------------------------------------------------------------------

-- Spearman's rank correlation of an input with a truth; 0 where one of them does not vary.
local function correlation(rows, input, holds)
  local x, y = {}, {}
  for i, r in ipairs(rows) do x[i], y[i] = r[input], holds(r) and 1 or 0 end
  return fit.rank_correlation(x, y) or 0
end

local labels = {
  bay = "bay, m", storey = "storey, m", floor = "floors, kg/m^2", beams = "beams, 0 light to 1 heavy",
  yield_stress = "yield stress of the building, MPa", column = "width of the columns over their thickness",
  metal = "metal of the aircraft over 12 t", plane_wall = "width of the aircraft's members over their thickness",
  plane_yield = "yield stress of the aircraft, MPa", body = "side of the fuselage over the length",
  sweep = "sweep of the wings over the length", height = "height of the impact, storeys",
  offset = "offset of the impact, bays", kappa = "limit of curvature, 1/m",
}

-- Blue where it holds, orange where it does not, paler with the second limit: told apart by all kinds of sight.
local colours = { [true] = { { 0, 0.45, 0.7 }, { 0.35, 0.72, 0.93 } },
  [false] = { { 0.8, 0.3, 0 }, { 0.95, 0.68, 0.3 } } }

-- One picture: where the finding holds, over the two inputs that it depends on most.
local function draw(job, rows, f)
  local order = {}
  for i, name in ipairs(inputs) do order[i] = { name = name, size = correlation(rows, name, f.holds) } end
  table.sort(order, function(a, b) return math.abs(a.size) > math.abs(b.size) end)
  local x, y, series = order[1].name, order[2].name, {}
  for i, kappa in ipairs(values_of(rows, "kappa")) do
    for _, holds in ipairs { true, false } do
      local name = ("%s, %g 1/m"):format(holds and "holds" or "does not", kappa)
      local one = { name = name, x = {}, y = {}, style = "points", colour = colours[holds][(i - 1) % 2 + 1] }
      for _, r in ipairs(rows) do
        if r.kappa == kappa and f.holds(r) == holds then one.x[#one.x + 1], one.y[#one.y + 1] = r[x], r[y] end
      end
      series[#series + 1] = one
    end
  end
  job:plot({ title = f.text, x_label = labels[x], y_label = labels[y], series = series },
    "finding_" .. f.name .. ".png")
end

local function means(r, name, form)
  local cells = {}
  for i, case in ipairs(cases) do cells[i] = form:format(r[case .. "." .. name]) end
  return table.concat(cells, " ")
end

local function damage_of(r)
  local cells = {}
  for i, case in ipairs(cases) do cells[i] = ("%.0f"):format(broken(r, case)) end
  return table.concat(cells, " ")
end

local function show_frames(title, rows)
  local lines = {}
  for i, r in ipairs(rows) do
    lines[i] = { r.number, r.contact, r.reading, r.kappa, ("%.1f"):format(r.bay), ("%.1f"):format(r.storey),
      ("%.0f"):format(r.floor), ("%.0f"):format(r.yield_stress), ("%.0f"):format(r.column), ("%.2f"):format(r.metal),
      ("%.1f"):format(r.height), ("%.2f"):format(r.offset), means(r, "inner", "%.0f"), damage_of(r),
      means(r, "work", "%.1f") }
  end
  if #lines == 0 then lines[1] = { "none" } end
  paper.table(title, { "case", "contact", "reading", "kappa", "bay", "storey", "floor", "yield", "b/t", "metal",
    "height", "offset", "inner columns", "broken", "plastic work, MJ" }, lines)
end

-- How far two frames are apart: inputs over their ranges; another rule counts as half a range.
local function distance(a, b, ranges)
  local sum = 0
  for _, name in ipairs(inputs) do sum = sum + ((a[name] - b[name]) / ranges[name]) ^ 2 end
  for _, name in ipairs { "contact", "kappa" } do sum = sum + (a[name] == b[name] and 0 or 0.25) end
  return sum
end

local function score(r)
  local n = 0
  for _, f in ipairs(findings) do n = n + (not f.alone and f.holds(r) and 1 or 0) end
  return n
end

-- The frame of the region whose eight nearest neighbours show the most findings.
local function middle(rows, region)
  local ranges, best, most = {}, nil, -1
  for _, name in ipairs(inputs) do
    local low, high = math.huge, -math.huge
    for _, r in ipairs(rows) do low, high = math.min(low, r[name]), math.max(high, r[name]) end
    ranges[name] = math.max(high - low, 1e-9)
  end
  for _, r in ipairs(region) do
    local near = {}
    for i, other in ipairs(rows) do near[i] = { score = score(other), d = distance(r, other, ranges) } end
    table.sort(near, function(a, b) return a.d < b.d end)
    local sum = 0
    for i = 2, math.min(9, #near) do sum = sum + near[i].score / 8 end
    if sum > most then best, most = r, sum end
  end
  return best, most
end

-- The frames of each study, in order: a list of { name =, drawn = { row, ... }, stand = { row, ... } }.
local function studies_of(paths)
  local list, found = {}, {}
  for path in paths:gmatch "[^,]+" do
    local file = path:match "%.csv$" and path or path .. "/results.csv"
    for _, r in ipairs(rows_of(file)) do
      r.study = r.study or path:match "([^/]+)/*$"
      if not found[r.study] then
        found[r.study] = { name = r.study, drawn = {}, stand = {} }
        list[#list + 1] = found[r.study]
      end
      local study = found[r.study]
      table.insert(study.drawn, r)
      if r.allowed == true then table.insert(study.stand, r) end
    end
  end
  return list
end

local function show_study(study)
  local rows, region, slow = study.stand, {}, {}
  local failed = count(rows, function(r)
    return r["I.failed"] + r["II.failed"] + r["III.failed"] + r["IV.failed"] > 0
  end)
  print(("\n==== %s: %d frames drawn, %d stand under their own weight; in %d a run fails, with half the step too")
    :format(study.name, #study.drawn, #rows, failed))
  if #rows == 0 then return { drawn = #study.drawn, stand = 0 } end
  local list = show_findings(rows)
  for _, r in ipairs(rows) do
    if all_but_last(r) then region[#region + 1] = r end
    if clearly(r, "II", "III") or findings[#findings].holds(r) then slow[#slow + 1] = r end
  end
  show_frames("All but the last one hold; Cases I II III IV", region)
  show_frames("II does more damage than III, by both measures, or clearly by plastic work", slow)
  local best, near = middle(rows, region)
  if best then
    show_frames(("In the middle: of its eight nearest neighbours, %.1f of 8 findings hold"):format(near), { best })
  end
  return { drawn = #study.drawn, stand = #rows, failed = failed, holds = list, middle = best and best.number or 0 }
end

return hinge.scenario {
  parameters = { study = "" },
  run = function(p, job)
    local all, drawn, region, results = {}, {}, {}, {}
    for _, study in ipairs(studies_of(p.study == "" and folder .. "lost_inputs.csv" or p.study)) do
      results[study.name] = show_study(study)
      table.move(study.stand, 1, #study.stand, #all + 1, all)
      table.move(study.drawn, 1, #study.drawn, #drawn + 1, drawn)
    end
    for _, row in ipairs(all) do if all_but_last(row) then region[#region + 1] = row end end
    write(drawn, columns(), "%.5g", job.out .. "/points.csv")
    write(region, table.move(choices, 1, #choices, #inputs + 1, table.move(inputs, 1, #inputs, 1, {})), "%.14g",
      job.out .. "/region.csv")
    for _, f in ipairs(findings) do draw(job, all, f) end
    return results
  end,
}
