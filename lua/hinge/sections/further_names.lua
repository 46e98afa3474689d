-- Names of sections that are those of a table in another writing, or made of one: metric names of American sections,
-- tees cut of a W, M or S, American angles and pairs of them, and pipes.
--
-- Metric: W360X79 is W14X53, HSS203.2X203.2X6.4 is HSS8X8X1/4, L102X102X12.7 is L4X4X1/2: nominal depth and sizes in
-- mm, mass in kg/m for weight in lb/ft.
local core = require "hinge.core"
local shapes = require "hinge.sections.shapes"

local inch, lb_per_ft = 0.0254, 0.45359237 / 0.3048

-- Nominal depths of metric names, mm, by that in inches.
local depths = { [4] = 100, [5] = 130, [6] = 150, [8] = 200, [10] = 250, [12] = 310, [14] = 360, [16] = 410, [18] = 460,
  [20] = 510, [21] = 530, [24] = 610, [27] = 690, [30] = 760, [33] = 840, [36] = 920, [40] = 1000, [44] = 1100,
  [12.5] = 318, [15] = 380, [9] = 230, [7] = 180, [3] = 75, [13] = 330 }
local nearly = { [310] = { 300, 310 }, [510] = { 500, 510 }, [180] = { 175, 180 } }

-- Diameters of American pipes by their nominal size, in, and their nominal walls: standard, extra strong, double extra
-- strong. 20 is left out: it is also the name of a pipe of 20 mm. The design thickness of AISC is 0.93 times the
-- nominal one.
local pipes = {
  ["1/2"] = { 0.84, 0.109, 0.147 }, ["3/4"] = { 1.05, 0.113, 0.154 }, ["1"] = { 1.315, 0.133, 0.179 },
  ["1-1/4"] = { 1.66, 0.14, 0.191 }, ["1-1/2"] = { 1.9, 0.145, 0.2 }, ["2"] = { 2.375, 0.154, 0.218, 0.436 },
  ["2-1/2"] = { 2.875, 0.203, 0.276, 0.552 }, ["3"] = { 3.5, 0.216, 0.3, 0.6 }, ["3-1/2"] = { 4, 0.226, 0.318 },
  ["4"] = { 4.5, 0.237, 0.337, 0.674 }, ["5"] = { 5.563, 0.258, 0.375, 0.75 }, ["6"] = { 6.625, 0.28, 0.432, 0.864 },
  ["8"] = { 8.625, 0.322, 0.5, 0.875 }, ["10"] = { 10.75, 0.365, 0.5 }, ["12"] = { 12.75, 0.375, 0.5 },
  ["14"] = { 14, 0.375, 0.5 }, ["16"] = { 16, 0.375, 0.5 }, ["18"] = { 18, 0.375, 0.5 },
  ["24"] = { 24, 0.375, 0.5 }, ["26"] = { 26, 0.375, 0.5 },
}
local walls = { STD = 2, XS = 3, XXS = 4 }
-- Nominal sizes of metric names, mm: 150 STD and 152 STD are 6 STD.
local metric_pipes = { [15] = "1/2", [40] = "1-1/2", [50] = "2", [65] = "2-1/2", [80] = "3",
  [90] = "3-1/2", [100] = "4", [125] = "5", [150] = "6", [200] = "8", [250] = "10", [300] = "12", [350] = "14",
  [400] = "16", [450] = "18", [500] = "20", [600] = "24", [650] = "26", [13] = "1/2", [19] = "3/4", [25] = "1",
  [32] = "1-1/4", [38] = "1-1/2", [51] = "2",
  [64] = "2-1/2", [75] = "3", [76] = "3", [89] = "3-1/2", [102] = "4", [127] = "5", [152] = "6", [203] = "8",
  [254] = "10", [310] = "12", [305] = "12" }

local further = {}

local function pipe(size, wall)
  local mm = tonumber(size)
  local row = pipes[size] or mm and pipes[metric_pipes[mm]]
  local nominal = row and row[walls[wall]]
  if not nominal then return nil end
  local made = shapes.pipe { diameter = row[1] * inch, thickness = 0.93 * nominal * inch }
  made.shape, made.kind = made.kind, ("Pipe%s%s"):format(pipes[size] and size or metric_pipes[mm], wall)
  return made
end

-- The row of a family with the same nominal depth and weight, for a metric name.
local function by_mass(family, depth, mass)
  local best, off
  for _, row in ipairs(family.rows) do
    local metric = depths[row.sizes[1]]
    local same = metric == depth
    for _, other in ipairs(nearly[metric] or {}) do same = same or other == depth end
    local away = same and math.abs(row.sizes[2] * lb_per_ft - mass) or math.huge
    if not off or away < off then best, off = row, away end
  end
  local rounding = mass < 60 and math.max(0.45, 0.023 * mass) or math.min(0.013 * mass, 1.45) -- that of the names
  return best and off <= rounding and best or nil
end

-- The row of a family whose sizes in inches are these in mm, to 2 %.
local function by_sizes(family, sizes)
  local best, least
  for _, row in ipairs(family.rows) do
    local worst = #row.sizes == #sizes and 0 or math.huge
    for i = 1, worst == 0 and #sizes or 0 do
      worst = math.max(worst, math.abs(sizes[i] / 25.4 / row.sizes[i] - 1) * (i == #sizes and 1 or 4))
    end
    if not least or worst < least then best, least = row, worst end
  end
  return least and least <= 0.02 and best or nil
end

-- H shapes by depth, width, web and flange: 294x200x8x12 is HM 300x200.
local chinese = { H = { "HW", "HM", "HN" }, HW = { "HW" }, HM = { "HM" }, HN = { "HN" } }

local function by_plates(families, name, sizes)
  for _, other in ipairs(chinese[name]) do
    for _, row in ipairs(#sizes <= 4 and (name ~= "H" or #sizes == 4) and families[other].rows or {}) do
      local plates, same = row.dimensions:gmatch "%S+", true
      for i = 1, #sizes do same = tonumber(plates()) == sizes[i] and same end
      if same then return row end
    end
  end
end

--- Sizes of a metric name in inches and lb/ft, where the family is in inches; else nil.
function further.in_inches(family, sizes)
  if not family.inches or not sizes[1] or sizes[1] < 75 then return nil end
  local list = {}
  for i, v in ipairs(sizes) do list[i] = #sizes == 2 and i == 2 and v / lb_per_ft or v / 25.4 end
  return list
end

-- A row of a family by sizes as its names have them; metric ones are found, too.
function further.row(families, name, sizes)
  local family = families[name]
  if family and sizes and chinese[name] then return by_plates(families, name, sizes) end
  if not family or not sizes or not family.inches then return nil end
  if #sizes == 2 and name ~= "HSS" then
    for _, row in ipairs(family.rows) do
      if row.sizes[1] == sizes[1] and math.abs(row.sizes[2] - sizes[2]) <= 0.051 then return row end -- 8X18.7, 18.75
    end
    return sizes[1] >= 75 and by_mass(family, sizes[1], sizes[2]) or nil
  end
  return sizes[1] > 30 and by_sizes(family, sizes) or nil
end

-- Legs and thickness in m, and the same in inches; metric ones are of whole sixteenths to 2 %. Nil: no American angle.
local function legs(sizes)
  local list, metric = {}, sizes[1] > 12.01
  for i = 1, #sizes do
    local v = metric and sizes[i] / 25.4 or sizes[i]
    local sixteenths = math.floor(16 * v + 0.5)
    if sixteenths == 0 or math.abs(16 * v / sixteenths - 1) > 0.02 then return nil end
    list[i] = sixteenths / 16
  end
  return list
end

local function fraction(v)
  local whole, rest, below = math.floor(v), math.floor(16 * (v % 1) + 0.5), 16
  while rest > 0 and rest % 2 == 0 do rest, below = rest // 2, below // 2 end
  if rest == 0 then return ("%d"):format(whole) end
  return (whole > 0 and ("%d-"):format(whole) or "") .. ("%d/%d"):format(rest, below)
end

local function written(prefix, list)
  local parts = {}
  for i, v in ipairs(list) do parts[i] = fraction(v) end
  return prefix .. table.concat(parts, "X")
end

--- An American angle, from its legs and thickness in inches or mm; nil where it is none.
function further.angle(sizes)
  local list = sizes and #sizes == 3 and legs(sizes)
  if not list or list[3] >= list[2] then return nil end
  local made = shapes.angle { depth = list[1] * inch, width = list[2] * inch, thickness = list[3] * inch }
  made.shape, made.kind = made.kind, written("L", list)
  return made
end

local function gap_text(v) return 16 * v % 1 == 0 and fraction(v) or ("%.4g"):format(v) end

-- Two angles: sizes as of one and the gap between them; LLBB: the long legs back to back, SLBB the short ones.
local function double_angle(sizes, backs)
  local list = (#sizes == 3 or #sizes == 4) and legs({ sizes[1], sizes[2], sizes[3] })
  if not list or list[3] >= list[2] then return nil end
  local gap = (sizes[4] or 0) * (sizes[1] > 12.01 and 1e-3 or inch)
  local depth, width = list[1], list[2]
  if backs == "SLBB" then depth, width = width, depth end
  local made = core.shape("double angle", { depth = depth * inch, width = width * inch, thickness = list[3] * inch,
    gap = gap }, "pair of angles")
  made.shape, made.kind = made.kind, written("2L", list) .. (gap > 0 and "X" .. gap_text(gap / inch) or "")
    .. (backs or "")
  return made
end

-- A tee: half of the section of twice its depth and weight. dimensions(row): of that section, m.
local function tee(families, name, sizes, dimensions)
  local from = families[name:sub(1, -2)]
  local depth, weight = sizes[1], sizes[2]
  local row = further.row(families, from.name, { 2 * depth, 2 * weight })
  for _, other in ipairs(row and {} or from.rows) do
    -- nominal depths of tees are rounded: WT10.5 is cut of a W21, WT4 of a W8
    if math.abs(other.sizes[1] / 2 - depth) <= 0.26 and math.abs(other.sizes[2] / 2 - weight) <= 0.051 then
      row = other
    end
  end
  if not row then return nil end
  local d = dimensions(row)
  local made = core.shape("tee", { depth = d.depth / 2, width = d.width, web = d.web, flange = d.flange,
    r = d.kdes and d.kdes - d.flange or nil }, "tee")
  made.shape, made.kind = made.kind, ("%s%gX%g"):format(name, row.sizes[1] / 2, row.sizes[2] / 2)
  return made
end

--- The properties of a name that is in no table by itself, or nil. text: the name in capitals without blanks; sizes_of:
--- the numbers of a text; dimensions(row).
function further.made(text, families, sizes_of, dimensions)
  local size, wall = text:match "^PIPE([%d/%-]+)(%a+)$"
  if not size then size, wall = text:match "^P([%d/%-]+)(X?X?S[TD]*)$" end
  if size then return pipe(size, wall) end
  local rest, backs = text:match "^2L%-?([%d.X/%-]+)(%a*)$"
  if rest then
    local sizes = sizes_of(rest, true)
    if not sizes or backs ~= "" and backs ~= "LLBB" and backs ~= "SLBB" then return nil end
    return double_angle(sizes, backs ~= "" and backs or nil)
  end
  local family, numbers = text:match "^([WMS]T)%-?([%d.X]+)$"
  local sizes = family and sizes_of(numbers, true)
  return sizes and #sizes == 2 and tee(families, family, sizes, dimensions) or nil
end

return further
